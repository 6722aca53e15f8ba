"""Measurements of `coscrew report`: errors and times of every kernel on this machine."""

from coscrew_codegen.program.reported_error import ReportedError


class ReportError(ReportedError, ValueError):
    """The measurement is impossible; the message says why."""
