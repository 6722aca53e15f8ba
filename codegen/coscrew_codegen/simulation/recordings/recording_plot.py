"""Plots recordings over time: one panel for each quantity and unit, single precision dashed."""

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from coscrew_codegen.backends.html import plots
from coscrew_codegen.simulation.recordings.recording import Column, Recording
from coscrew_codegen.simulation.recordings.recording_writer import delivered

_MOST_NAMED = 12  # most lines in the legend of a panel
_UNSEEN = 1e-6  # size of a curve, relative to the largest of its panel, that nobody sees
_DASHES = ("-", "--")


def grouped(columns: Iterable[Column]) -> Mapping[tuple[str, str], list[Column]]:
    """The columns of each quantity and unit."""
    groups: dict[tuple[str, str], list[Column]] = {}
    for column in columns:
        groups.setdefault((column.quantity, column.unit), []).append(column)
    return groups


@plots.styled
def plot(recordings: Sequence[Recording], path: Path, members: bool = False,
         targets: Mapping[str, np.ndarray] | None = None) -> None:
    """Draw the recordings, of the same columns, to an SVG or PNG: one, or double and single
    precision, or `members` of a batch; and the targets of columns, dotted.  Columns that lie on
    zero are left out, and named.  Raises SimulateError."""
    targets = targets or {}
    zero = _on_zero(recordings, targets)
    groups = grouped(x for x in recordings[0].columns if x.name not in zero)
    figure = Figure(figsize=(8, max(2.4, 2.0 * len(groups))), layout="constrained")
    panels = figure.subplots(len(groups), 1, sharex=True, squeeze=False)[:, 0]
    for axes, ((quantity, unit), columns) in zip(panels, groups.items(), strict=True):
        axes.set_ylabel(f"{quantity} [{unit}]")
        _lines(axes, recordings, columns, members)
        for i, column in enumerate(columns):
            if column.name in targets:
                axes.plot(recordings[0].t, targets[column.name], ":", color=f"C{i}", linewidth=1.6,
                          label="_", gid=f"{column.name} target")
    panels[-1].set_xlabel("t [s]")
    words = ["double precision solid, single dashed"] if len(recordings) > 1 and not members else []
    if any(name in targets for name in _names(recordings[0])):
        words.append("targets dotted")
    panels[0].set_title("; ".join(words), fontsize=8)
    if zero:
        figure.supxlabel(_left_out(zero), fontsize=8, x=0.01, ha="left", color=plots.QUIET)
    with delivered(path) as temporary:
        plots.write(figure, temporary)


def _names(recording: Recording) -> list[str]:
    return [x.name for x in recording.columns]


def _on_zero(recordings: Sequence[Recording], targets: Mapping[str, np.ndarray]) -> list[str]:
    """The columns without a target that nobody could tell from the line at zero; none if that are
    all."""
    results = []
    for columns in grouped(recordings[0].columns).values():
        sizes = {x.name: max(_size(recording.of(x.name)) for recording in recordings)
                 for x in columns}
        largest = max(sizes.values())
        results += [name for name, size in sizes.items()
                    if size <= _UNSEEN * largest and name not in targets]
    return results if len(results) < len(recordings[0].columns) else []


def _size(values: np.ndarray) -> float:
    """The largest size; infinite if one is not finite, so that the curve is drawn."""
    return float(np.abs(values).max(initial=0)) if np.isfinite(values).all() else np.inf


def _left_out(names: Sequence[str]) -> str:
    more = len(names) - _MOST_NAMED
    shown = ", ".join(names[:_MOST_NAMED])
    return textwrap.fill(f"on zero, not drawn: {shown}{f' and {more} more' if more > 0 else ''}",
                         110)


def _lines(axes: Axes, recordings: Sequence[Recording], columns: Sequence[Column],
           members: bool) -> None:
    dashes = ("-",) * len(recordings) if members else _DASHES
    for recording, dash in zip(recordings, dashes, strict=False):
        for i, column in enumerate(columns):
            values = np.ma.masked_invalid(recording.of(column.name))
            first = recording is recordings[0]
            named = first and i < _MOST_NAMED
            axes.plot(recording.t, values, dash, color=f"C{i}", linewidth=1,
                      label=column.name if named else "_",
                      gid=column.name if first or members else f"{column.name} single")
    if len(columns) > 1 or columns[0].name != columns[0].quantity:
        more = len(columns) - _MOST_NAMED
        axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1),
                    title=f"and {more} more" if more > 0 else None, title_fontsize=7)
