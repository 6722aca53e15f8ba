"""Measures costs of a scene: operations and times of functions, effect by effect; accuracy against
time."""

from coscrew_codegen.program.reported_error import ReportedError


class CostError(ReportedError, ValueError):
    """The measurement is impossible with these settings; the message says what was wanted."""
