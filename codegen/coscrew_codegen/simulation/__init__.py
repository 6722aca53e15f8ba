"""Simulates scenes: integrates their equations of motion, records, writes, plots and plays back."""

from coscrew_codegen.program.reported_error import ReportedError


class SimulateError(ReportedError, ValueError):
    """The run is impossible with these settings; the message says what came and what was wanted."""
