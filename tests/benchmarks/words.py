"""Prints times of benchmarks."""

from coscrew_codegen.reports.timing.intervals import Interval


def span(x: Interval, scale: float = 1) -> str:
    """median (low–high)."""
    return f"{x.median * scale:.3g} ({x.low * scale:.3g}–{x.high * scale:.3g})"
