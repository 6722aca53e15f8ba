"""`coscrew report`: what every kernel's error and time are on this machine, as measured."""


class ReportError(ValueError):
    """What was asked for cannot be measured; the message says why."""
