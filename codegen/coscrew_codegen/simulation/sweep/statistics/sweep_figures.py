"""Draws figures of a sweep: a column's distribution and its sensitivity to each varied input."""

from functools import partial

import numpy as np
from markupsafe import Markup
from matplotlib.axes import Axes

from coscrew_codegen.backends.html import plots
from coscrew_codegen.simulation.sweep.member_summary import STATISTICS
from coscrew_codegen.simulation.sweep.statistics.axis import Axis
from coscrew_codegen.simulation.sweep.statistics.column import ColumnStatistics

_MOST = 4  # heat maps of the final value against the first varied quantities
_MAP, _FAILED = "viridis", "#d62728"
_SIZE = (3.3, 2.7)  # inches: four stand in a row of a wide page, one on a phone


def figures(column: ColumnStatistics) -> list[Markup]:
    """Draws the figures of a column: its distribution, members against the varied quantities in
    the order given, and its mean over the first two."""
    name = column.own.name
    panels = [plots.Panel(f"distribution of {name}", partial(_distribution, column=column),
                          size=_SIZE)]
    panels += [plots.Panel(f"{name} against {axis.name}", partial(_against, column=column, i=i),
                           size=_SIZE) for i, axis in enumerate(column.axes[:_MOST])]
    if pair := next(iter(column.pairs), None):
        names = " and ".join(column.axes[i].name for i in pair)
        panels.append(plots.Panel(f"mean of {name} over {names}",
                                  partial(_means, column=column, pair=pair), size=_SIZE))
    return [x.inline for x in panels]


def _means(axes: Axes, column: ColumnStatistics, pair: tuple[int, int]) -> None:
    """The mean of the final value over two axes."""
    x, y = (column.axes[i] for i in pair)
    _map(axes, x, y, column.means(pair), f"mean of the final {_label(column.own)}")
    cells = np.nonzero(column.pairs[pair][2])
    _cross(axes, x.middles[cells[0]], y.middles[cells[1]])


def _distribution(axes: Axes, column: ColumnStatistics) -> None:
    for counts, word in zip(column.histogram, STATISTICS, strict=True):
        first = word == STATISTICS[0]
        axes.stairs(counts, column.own.edges, label=word, fill=first, alpha=0.45 if first else 1)
    axes.set_xlabel(_label(column.own))
    axes.set_ylabel("members")
    axes.legend(fontsize=7)


def _against(axes: Axes, column: ColumnStatistics, i: int) -> None:
    """Members by the final value and one axis."""
    counts = column.joint[i]
    _map(axes, column.axes[i], column.own, np.where(counts > 0, counts, np.nan), "members")
    axes.set_ylabel(f"final {_label(column.own)}")
    share = column.explained(i)[0]
    if np.isfinite(share):
        axes.set_title(f"explains {100 * share:.0f} % of the variance", fontsize=8)
    where = column.axes[i].middles[column.lost[i] > 0]
    _cross(axes, where, np.full(len(where), 0.97), of_axes=True)


def _cross(axes: Axes, x: np.ndarray, y: np.ndarray, of_axes: bool = False) -> None:
    """Marks the places of failed members; with `of_axes`, y from 0, the lower end of the axis, to
    1."""
    if len(x):
        axes.scatter(x, y, 12, _FAILED, marker="x", linewidths=1, clip_on=False,
                     transform=axes.get_xaxis_transform() if of_axes else axes.transData)


def _map(axes: Axes, x: Axis, y: Axis, values: np.ndarray, words: str) -> None:
    mesh = axes.pcolormesh(x.edges, y.edges, values.T, cmap=_MAP, rasterized=True)
    axes.grid(False)
    for axis, of in ((axes.xaxis, x), (axes.yaxis, y)):
        axis.set_label_text(_label(of))
        if of.log:
            plots.logarithmic(axis)
    axes.figure.colorbar(mesh, ax=axes).set_label(words, fontsize=7)


def _label(axis: Axis) -> str:
    """Its name and unit."""
    return plots.escaped(axis.label)
