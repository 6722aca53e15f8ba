"""Style of all plots."""

from matplotlib import RcParams

STYLE = RcParams({
    "svg.hashsalt": "coscrew", "svg.fonttype": "path", "font.family": "DejaVu Sans",
    "font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#e3e6eb", "axes.edgecolor": "#9aa2b1",
    "axes.axisbelow": True, "axes.titlelocation": "left"})
"""Text as paths, so that it looks alike everywhere; ids from a fixed salt."""
