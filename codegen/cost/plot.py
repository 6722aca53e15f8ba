"""A scene's costs as a figure: rounding errors against time, time of forward dynamics by effect,
errors of runs against time."""

import math
from collections.abc import Sequence
from pathlib import Path

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from coscrew_codegen.cost.measure import Costs
from coscrew_codegen.cost.rounding import UNITS
from coscrew_codegen.cost.work_precision import Point
from coscrew_codegen.formats import PRECISIONS
from coscrew_codegen.native.intervals import Interval
from coscrew_codegen.plots import STYLE
from coscrew_codegen.simulate.write import delivered
from coscrew_codegen.tiers import PLAIN

_MARKERS = "osD^v"
_SHOWN = "forward_dynamics"


def plot(costs: Costs, path: Path) -> None:
    """Draw the costs to an SVG or PNG.  Raises SimulateError."""
    with matplotlib.rc_context(STYLE), delivered(path) as temporary:
        figure = Figure(figsize=(18, 4.6), layout="constrained")
        left, middle, right = figure.subplots(1, 3, width_ratios=(3, 2, 3))
        _rounding(left, costs)
        _bars(middle, costs)
        _accuracy(right, costs)
        kept = {"Date": None, "Creator": None} if path.suffix == ".svg" else {"Software": None}
        figure.savefig(temporary, metadata=kept)


def _rounding(axes: Axes, costs: Costs) -> None:
    """A point for each function, tier and precision: the worst error, a line from the typical."""
    for x in costs.roundings:
        colour = next(p.colour for p in PRECISIONS if p.name == x.precision)
        marker, plain = _MARKERS[list(UNITS).index(x.function)], x.tier == PLAIN.name
        axes.plot([x.time.median] * 2, [x.typical, x.worst], color=colour, linewidth=1)
        axes.plot([x.time.median], [x.worst], marker, color=colour, markersize=6,
                  markerfacecolor="white" if plain else colour,
                  gid=f"rounding {x.function} {x.tier} {x.precision}")
    if not costs.roundings:
        return
    for n, (name, unit) in enumerate(UNITS.items()):
        axes.plot((), (), _MARKERS[n], color="#5b6475", label=f"{name}, {unit}")
    for p in PRECISIONS:
        axes.plot((), (), color=p.colour, label=p.name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("ns per call in C")
    axes.set_ylabel("largest error of a component")
    axes.set_title("rounding: from the typical error to the worst")
    axes.legend(frameon=False, fontsize=7, title="hollow: plain; full: accurate",
                title_fontsize=7)


def _bars(axes: Axes, costs: Costs) -> None:
    rows = [x for x in costs.rows if x.function == _SHOWN]
    for i, precision in enumerate(PRECISIONS):
        bars = axes.barh([n + 0.4 * i for n in range(len(rows))],
                         [x.times[i].median for x in rows], 0.38, color=precision.colour,
                         label=precision.name, xerr=_whiskers([x.times[i] for x in rows]),
                         error_kw={"linewidth": 1})
        for bar, row in zip(bars, rows, strict=True):
            bar.set_gid(f"{row.part}-{precision.name}-ns")
    for n, x in enumerate(rows):
        axes.annotate(f"{x.flops} flops", (0, n), (4, 0), textcoords="offset points",
                      va="center", fontsize=7, color="white")
    axes.set_yticks([n + 0.2 for n in range(len(rows))], [x.part for x in rows])
    axes.invert_yaxis()
    axes.set_xlabel("ns per call in C")
    axes.set_title("forward dynamics, effect by effect")
    axes.legend(frameon=False)


def _whiskers(times: Sequence[Interval]) -> list[list[float]]:
    """The distances of the intervals' ends below and above their medians."""
    return [[x.median - x.low for x in times], [x.high - x.median for x in times]]


def _accuracy(axes: Axes, costs: Costs) -> None:
    axes.set_title("error at the end against time")
    names = list(dict.fromkeys(x.integrator for x in costs.points))
    for i, name in enumerate(names):
        for precision in PRECISIONS:
            found = sorted((x for x in costs.points
                            if (x.integrator, x.precision) == (name, precision.name)
                            and 0 < x.error < math.inf), key=lambda x: (x.time.median, x.error))
            if found:
                _curve(axes, found, costs, precision.dash, _MARKERS[i % len(_MARKERS)], f"C{i}")
    if not axes.lines:
        axes.text(0.5, 0.5, "no reference", transform=axes.transAxes, ha="center")
        return
    if costs.reference and costs.reference.error > 0:
        axes.axhline(costs.reference.error, color="#5b6475", linewidth=1, linestyle=":",
                     label=f"the reference's own, {costs.reference.error:.1g}", gid="reference")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("time of the run, µs (SciPy's in Python)")
    axes.set_ylabel("largest error of a coordinate, m or rad")
    axes.legend(frameon=False, fontsize=7, loc="upper left", bbox_to_anchor=(1, 1),
                title="hollow: no worse than the reference", title_fontsize=7)


def _curve(axes: Axes, points: Sequence[Point], costs: Costs, dash: str, marker: str,
           colour: str) -> None:
    """An integrator's runs in one precision; hollow if the error is below the reference's."""
    first = points[0]
    name = f"{first.integrator} {first.precision}"
    where = [(1e6 * x.time.median, x.error) for x in points]
    for x in points:
        axes.plot([1e6 * x.time.low, 1e6 * x.time.high], [x.error] * 2, color=colour, linewidth=2,
                  label="_", gid=f"{name} interval")
    axes.plot(*zip(*where, strict=True), dash, color=colour, linewidth=1, label="_", gid=name)
    for hollow in (False, True):
        chosen = [at for at, x in zip(where, points, strict=True) if costs.known(x) != hollow]
        axes.plot(*zip(*chosen, strict=True) if chosen else ((), ()), marker, linestyle="",
                  color=colour, markersize=4, markerfacecolor="white" if hollow else colour,
                  label="_", gid=f"{name} hollow" if hollow else f"{name} runs")
    axes.plot((), (), dash + marker, color=colour, markersize=4, linewidth=1,
              label=f"{first.integrator}, {first.precision}")
