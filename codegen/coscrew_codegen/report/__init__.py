"""`coscrew report`: errors and times of every kernel, measured on this machine."""

from coscrew_codegen.errors import ReportedError


class ReportError(ReportedError, ValueError):
    """The measurement is impossible; the message says why."""
