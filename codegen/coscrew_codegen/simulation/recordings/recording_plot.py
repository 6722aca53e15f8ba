"""Plots recordings over time: one panel for each quantity and unit, single precision dashed."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from coscrew_codegen.backends.html import plots
from coscrew_codegen.simulation.recordings.recording import Column, Recording
from coscrew_codegen.simulation.recordings.recording_writer import delivered

_MOST_NAMED = 12  # most lines in the legend of a panel
_DASHES = ("-", "--")


def grouped(columns: Iterable[Column]) -> Mapping[tuple[str, str], list[Column]]:
    """The columns of each quantity and unit."""
    groups: dict[tuple[str, str], list[Column]] = {}
    for column in columns:
        groups.setdefault((column.quantity, column.unit), []).append(column)
    return groups


@plots.styled
def plot(recordings: Sequence[Recording], path: Path, members: bool = False) -> None:
    """Draw the recordings, of the same columns, to an SVG or PNG: one, or double and single
    precision, or `members` of a batch.  Raises SimulateError."""
    groups = grouped(recordings[0].columns)
    figure = Figure(figsize=(8, max(2.4, 2.0 * len(groups))), layout="constrained")
    panels = figure.subplots(len(groups), 1, sharex=True, squeeze=False)[:, 0]
    for axes, ((quantity, unit), columns) in zip(panels, groups.items(), strict=True):
        axes.set_ylabel(f"{quantity} [{unit}]")
        _lines(axes, recordings, columns, members)
    panels[-1].set_xlabel("t [s]")
    if len(recordings) > 1 and not members:
        panels[0].set_title("double precision solid, single dashed", fontsize=8)
    with delivered(path) as temporary:
        plots.write(figure, temporary)


def _lines(axes: Axes, recordings: Sequence[Recording], columns: Sequence[Column],
           members: bool) -> None:
    dashes = ("-",) * len(recordings) if members else _DASHES
    for recording, dash in zip(recordings, dashes, strict=False):
        for i, column in enumerate(columns):
            values = np.ma.masked_invalid(recording.of(column.name))
            first = recording is recordings[0]
            named = first and i < _MOST_NAMED
            axes.plot(recording.t, values, dash, color=f"C{i}", linewidth=1,
                      label=plots.escaped(column.name) if named else "_",
                      gid=column.name if first or members else f"{column.name} single")
    if len(columns) > 1 or columns[0].name != columns[0].quantity:
        more = len(columns) - _MOST_NAMED
        axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1),
                    title=f"and {more} more" if more > 0 else None, title_fontsize=7)
