"""Plots recordings over time: one panel for each quantity and unit, single precision dashed."""

from collections.abc import Sequence
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from coscrew_codegen.plots import STYLE
from coscrew_codegen.simulate.recording import Column, Recording
from coscrew_codegen.simulate.write import delivered

_MOST_NAMED = 12  # most lines in the legend of a panel
_DASHES = ("-", "--")


def plot(recordings: Sequence[Recording], path: Path, members: bool = False) -> None:
    """Draw the recordings, of the same columns, to an SVG or PNG: one, or double and single
    precision, or `members` of a batch.  Raises SimulateError."""
    groups: dict[tuple[str, str], list[Column]] = {}
    for column in recordings[0].columns:
        groups.setdefault((column.quantity, column.unit), []).append(column)
    with matplotlib.rc_context(STYLE), delivered(path) as temporary:
        figure = Figure(figsize=(8, max(2.4, 2.0 * len(groups))), layout="constrained")
        panels = figure.subplots(len(groups), 1, sharex=True, squeeze=False)[:, 0]
        for axes, ((quantity, unit), columns) in zip(panels, groups.items(), strict=True):
            axes.set_ylabel(f"{quantity} [{unit}]")
            _lines(axes, recordings, columns, members)
        panels[-1].set_xlabel("t [s]")
        if len(recordings) > 1 and not members:
            panels[0].set_title("double precision solid, single dashed", fontsize=8)
        kept = {"Date": None, "Creator": None} if path.suffix == ".svg" else {"Software": None}
        figure.savefig(temporary, metadata=kept)


def _lines(axes: Axes, recordings: Sequence[Recording], columns: Sequence[Column],
           members: bool) -> None:
    dashes = ("-",) * len(recordings) if members else _DASHES
    for recording, dash in zip(recordings, dashes, strict=False):
        for i, column in enumerate(columns):
            values = np.ma.masked_invalid(recording.of(column.name))
            first = recording is recordings[0]
            named = first and i < _MOST_NAMED
            axes.plot(recording.t, values, dash, color=f"C{i % 10}", linewidth=1,
                      label=_escaped(column.name) if named else "_",
                      gid=column.name if first or members else f"{column.name} single")
    if len(columns) > 1 or columns[0].name != columns[0].quantity:
        more = len(columns) - _MOST_NAMED
        axes.legend(frameon=False, fontsize=7, loc="upper left", bbox_to_anchor=(1, 1),
                    title=f"and {more} more" if more > 0 else None, title_fontsize=7)


def _escaped(name: str) -> str:
    """The name with characters escaped that Matplotlib reads as mathematics."""
    return name.replace("$", r"\$")
