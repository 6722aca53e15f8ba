"""`coscrew report`: what every kernel's error and time are on this machine, as measured."""

from coscrew_codegen.errors import Told


class ReportError(Told, ValueError):
    """What was asked for cannot be measured; the message says why."""
