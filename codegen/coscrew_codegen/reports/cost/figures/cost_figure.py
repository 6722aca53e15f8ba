"""Draws a scene's costs: errors of functions and of runs against time; time of forward dynamics by
effect."""

import math
from collections.abc import Iterator, Sequence
from functools import partial
from itertools import zip_longest
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from coscrew_codegen.backends.html import plots
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.reports.cost.cost_measurement import Costs
from coscrew_codegen.reports.cost.figures import run_panel
from coscrew_codegen.reports.cost.figures.panels import legend, panel, titles
from coscrew_codegen.reports.cost.function_errors import units_with_errors
from coscrew_codegen.reports.cost.work_precision import Point
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.simulation.recordings.recording_writer import delivered
from coscrew_codegen.simulation.result_units import written

_MARKERS = "osD^v"
_SHOWN = "forward_dynamics"
_ABREAST = 4  # panels in a row


def functions(costs: Costs) -> Iterator[plots.Panel]:
    """A panel for each function and unit in which any choice has an error."""
    for rows in costs.accuracy:
        for number in units_with_errors(rows):
            unit = written(rows[0].errors[number].unit)
            yield plots.Panel(f"Error of {rows[0].function} against time, {unit}",
                          partial(panel, rows=rows, number=number, needs=costs.needs),
                          dict(titles(rows, number)))


def runs(costs: Costs) -> Iterator[plots.Panel]:
    """Panels of effects and of runs, if they were measured."""
    if costs.runs:
        yield plots.Panel("Time of forward dynamics by effect", partial(_bars, costs=costs))
        yield plots.Panel("Error at the end of runs against time",
                          partial(_accuracy, costs=costs))
    if errors := costs.run_errors:
        names = [f"{x.cause}: {x.of}" for x in errors.rows]
        yield plots.Panel("Errors of the run over time", partial(run_panel.panel, errors=errors),
                      dict(zip(names, names, strict=True)))


def plot(costs: Costs, path: Path) -> None:
    """Draw the costs to an SVG or PNG.  Raises SimulateError."""
    with delivered(path) as temporary:
        plots.write(figure(costs), temporary)


@plots.styled
def figure(costs: Costs) -> Figure:
    """All panels, _ABREAST in a row."""
    drawings = [*functions(costs), *runs(costs)]
    across = min(_ABREAST, len(drawings))
    down = -(-len(drawings) // across)
    figure = Figure(figsize=(4.2 * across, 4.2 * down + 0.4), layout="constrained")
    panels = figure.subplots(down, across, squeeze=False).flat
    for axes, drawing in zip_longest(panels, drawings):
        if drawing:
            drawing.draw(axes)
        else:
            axes.set_axis_off()
    if costs.accuracy:
        legend(figure, [x for rows in costs.accuracy for x in rows])
    plots.place_labels(figure)
    return figure


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
    plots.legend_below(axes)


def _whiskers(times: Sequence[Interval]) -> list[list[float]]:
    """The distances of the intervals' ends below and above their medians."""
    return [[x.median - x.low for x in times], [x.high - x.median for x in times]]


def _accuracy(axes: Axes, costs: Costs) -> None:
    axes.set_title("error at the end against time")
    names = list(dict.fromkeys(x.integrator for x in costs.points))
    for i, name in enumerate(names):
        for precision in PRECISIONS:
            results = sorted((x for x in costs.points
                              if (x.integrator, x.precision) == (name, precision.name)
                              and 0 < x.error < math.inf), key=lambda x: (x.time.median, x.error))
            if results:
                _curve(axes, results, costs, precision.dash, _MARKERS[i % len(_MARKERS)], f"C{i}")
    if not axes.lines:
        axes.text(0.5, 0.5, "no reference", transform=axes.transAxes, ha="center")
        return
    if costs.reference and costs.reference.error > 0:
        axes.axhline(costs.reference.error, color=plots.QUIET, linewidth=1, linestyle=":",
                     label=f"the reference's own, {costs.reference.error:.1g}", gid="reference")
    plots.logarithmic(axes.xaxis)
    plots.logarithmic(axes.yaxis)
    axes.set(xlabel="time of the run, µs (SciPy's in Python)",
             ylabel="largest error of a coordinate, m or rad")
    plots.legend_below(axes, "hollow: no worse than the reference")


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
