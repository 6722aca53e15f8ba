"""Figures of a sweep: how a recorded column is distributed, and what of what varied moves it."""

import base64
import io

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from coscrew_codegen.plots import STYLE
from coscrew_codegen.sweep.axis import Axis
from coscrew_codegen.sweep.column import Column
from coscrew_codegen.sweep.summary import STATISTICS

_MOST = 3  # heat maps of the final value against what explains most of it
_MAP, _FAILED = "viridis", "#d62728"


def figure(column: Column) -> str:
    """The figure of a column, as the address of an image that contains it."""
    order = by_share(column)
    pair = min(column.pairs, key=lambda p: sum(map(order.index, p)), default=None)
    count = 1 + min(_MOST, len(order)) + (pair is not None)
    with matplotlib.rc_context(STYLE):
        drawn = Figure(figsize=(3.1 * count, 2.7), layout="constrained")
        panels = list(drawn.subplots(1, count, squeeze=False)[0])
        _distribution(panels.pop(0), column)
        if pair:
            x, y = (column.axes[i] for i in pair)
            _map(last := panels.pop(), x, y, column.means(pair),
                 f"mean of the final {_label(column.own)}")
            cells = np.nonzero(column.pairs[pair][2])
            _cross(last, x.middles[cells[0]], y.middles[cells[1]])
        for axes, i in zip(panels, order, strict=False):
            _against(axes, column, i)
        text = io.StringIO()
        drawn.savefig(text, format="svg", metadata={"Date": None, "Creator": None})
    return f"data:image/svg+xml;base64,{base64.b64encode(text.getvalue().encode()).decode()}"


def by_share(column: Column) -> list[int]:
    """The axes, those first that explain most of the final value's variance."""
    shares = [np.nan_to_num(column.explained(i)[0]) for i in range(len(column.axes))]
    return sorted(range(len(shares)), key=lambda i: -shares[i])


def _distribution(axes: Axes, column: Column) -> None:
    for counts, word in zip(column.histogram, STATISTICS, strict=True):
        first = word == STATISTICS[0]
        axes.stairs(counts, column.own.edges, label=word, fill=first, alpha=0.45 if first else 1)
    axes.set_xlabel(_label(column.own))
    axes.set_ylabel("members")
    axes.legend(frameon=False, fontsize=7)


def _against(axes: Axes, column: Column, i: int) -> None:
    """Members by the final value and one axis."""
    counts = column.joint[i]
    _map(axes, column.axes[i], column.own, np.where(counts > 0, counts, np.nan), "members")
    axes.set_ylabel(f"final {_label(column.own)}")
    where = column.axes[i].middles[column.lost[i] > 0]
    _cross(axes, where, np.full(len(where), 1.03), of_axes=True)


def _cross(axes: Axes, x: np.ndarray, y: np.ndarray, of_axes: bool = False) -> None:
    """Mark where members failed; with `of_axes`, y from 0, the lower end of the axis, to 1."""
    if len(x):
        axes.scatter(x, y, 12, _FAILED, marker="x", linewidths=1, clip_on=False,
                     transform=axes.get_xaxis_transform() if of_axes else axes.transData)


def _map(axes: Axes, x: Axis, y: Axis, values: np.ndarray, words: str) -> None:
    mesh = axes.pcolormesh(x.edges, y.edges, values.T, cmap=_MAP, rasterized=True)
    axes.grid(False)
    if x.log:
        axes.set_xscale("log")
    if y.log:
        axes.set_yscale("log")
    axes.set_xlabel(_label(x))
    axes.set_ylabel(_label(y))
    axes.figure.colorbar(mesh, ax=axes).set_label(words, fontsize=7)


def _label(axis: Axis) -> str:
    """Its name and unit, with characters escaped that Matplotlib reads as mathematics."""
    return axis.label.replace("$", r"\$")
