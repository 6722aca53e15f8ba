"""Draws a scene's costs: errors of functions and of runs against time; time of forward dynamics by
effect; errors of a run over time, by cause."""

import math
from collections.abc import Iterator, Sequence
from functools import partial
from itertools import product
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from coscrew_codegen.accuracy.tiers import PLAIN, tier_named
from coscrew_codegen.backends.html import plots
from coscrew_codegen.program.values.digits import three_digits
from coscrew_codegen.program.values.formats import BY_NAME, PRECISIONS
from coscrew_codegen.reports.cost.cost_measurement import Costs
from coscrew_codegen.reports.cost.function_errors import FunctionErrors, units_with_errors
from coscrew_codegen.reports.cost.needs.core_costs import CORES, CoreCost
from coscrew_codegen.reports.cost.needs.need import Need
from coscrew_codegen.reports.cost.recommendations import recommended, undominated
from coscrew_codegen.reports.cost.run_errors import RunErrors
from coscrew_codegen.simulation.recordings.recording_writer import delivered
from coscrew_codegen.simulation.result_units import in_unit, written

_MARKERS = "osD^v"
_SHOWN = "forward_dynamics"


def functions(costs: Costs) -> Iterator[plots.Panel]:
    """A panel for each function and unit in which any choice has an error."""
    for rows in costs.accuracy:
        for number in units_with_errors(rows):
            yield plots.Panel(
                f"Error of {rows[0].function} against time, {written(rows[0].errors[number].unit)}",
                partial(panel, rows=rows, number=number, needs=costs.needs))


def cores(costs: Costs) -> Iterator[plots.Panel]:
    """A panel for this machine and each core, for each function, if the scene selects fixed point:
    the proved bound against time or instructions."""
    for name in dict.fromkeys(x.function for x in costs.cores):
        rows = [x for x in costs.cores if x.function == name and x.bounds]
        for where in ("", *CORES):
            yield plots.Panel(
                f"Bound of {name} against {'instructions on a ' * bool(where)}{where or 'time'}",
                partial(bounds, rows=rows, where=where))


def bounds(axes: Axes, rows: Sequence[CoreCost], where: str, named: bool = True) -> None:
    """Draws a mark for each number format at the bound in the first unit, with a line from the
    worst error found: the proved bound or, of certified functions, the largest one returned.
    `where` is a core, or "" for this machine; bounds and tiers are `named` beside the marks."""
    unit = next(iter(rows[0].bounds))
    axes.set(title=f"{rows[0].function}, {where or 'this machine'}",
             xlabel="instructions per call" if where else "ns per call in C",
             ylabel="proved bound" if unit == "1" else f"proved bound, {written(unit)}")
    plots.scatter(axes, [_bound(x, unit, where, named) for x in rows])
    if named:
        plots.tier_legend(axes, (x.tier for x in rows))


def _bound(x: CoreCost, unit: str, where: str, named: bool) -> plots.Mark:
    middle, low, high = (x.instructions.get(where, math.nan),) * 3 if where else (
        x.time.numbers() if x.time else (math.nan,) * 3)
    word, bound = ("largest", x.returned[unit]) if unit in x.returned else (
        "proved", x.bounds[unit])
    worst, words = x.worst.get(unit, 0.0), in_unit(bound, unit)
    return plots.Mark(
        f"{x.function} {x.format} {where}".strip(), middle, low, high, bound,
        plots.COLOURS[x.tier], shape(x), label=words * named, foot=worst, title=(
            f"{x.format}: {word} {words}{f', found {in_unit(worst, unit)}' if worst else ''}, "
            f"{middle:,.0f}{' instructions' if where else ' ns'}"))


def shape(x: CoreCost) -> str:
    """The shape of a format's marks: its precision's, but mixtures and fixed point have others."""
    plain = BY_NAME[x.precision].marker if x.precision in BY_NAME else "D"
    return "^" if tier_named(x.tier).on_request else plain


def runs(costs: Costs) -> Iterator[plots.Panel]:
    """Panels of effects and of runs, if they were measured."""
    if costs.runs:
        yield plots.Panel("Time of forward dynamics by effect", partial(_bars, costs=costs))
        yield plots.Panel("Error at the end of runs against time", partial(_ends, costs=costs))
    if costs.run_errors:
        yield plots.Panel("Errors of the run over time", partial(_run, errors=costs.run_errors))


def plot(costs: Costs, path: Path) -> None:
    """Draw the costs to an SVG or PNG.  Raises SimulateError."""
    with delivered(path) as temporary:
        plots.write(plots.drawn((*cores(costs), *functions(costs), *runs(costs))), temporary)


def panel(axes: Axes, rows: Sequence[FunctionErrors], number: int = 0,
          needs: Sequence[Need] = ()) -> None:
    """Draws a mark for each tier and precision at the worst error, or bound if it is certified, in
    the function's unit of this number; a line from the typical error; a ring around the recommended
    choice; a line at each request."""
    unit, best, choice = rows[0].errors[number].unit, undominated(rows), recommended(rows)
    axes.set(xlabel="ns per call in C", title=rows[0].function,
             ylabel="error" if unit == "1" else f"error, {written(unit)}")
    for need in needs:
        if need.function == choice.function and need.concerns(unit):
            axes.axhline(need.within, color=plots.INK, linestyle="--", linewidth=1,
                         gid=f"{need} line")
            plots.name_beside(axes, (0, need.within), f"needed: {need.named((unit,))}",
                              "axes fraction")
    plots.scatter(axes, [_mark(x, number, x not in best, x is choice) for x in rows])
    plots.tier_legend(axes, (x.tier for x in rows))


def _mark(x: FunctionErrors, number: int, hollow: bool, ring: bool) -> plots.Mark:
    e, worst = x.errors[number], shown(x, number)
    return plots.Mark(
        f"{x.function} {x.name}", *x.time.numbers(), worst, plots.COLOURS[x.tier],
        BY_NAME[x.precision].marker, hollow, ring,
        in_unit(worst, e.unit) if 0 < worst < math.inf else "", foot=e.typical, title=(
            f"{x.name}: {'bound' if e.bounds else 'error'} {in_unit(worst, e.unit)}, typically an "
            f"error of {in_unit(e.typical, e.unit)}, {three_digits(x.time.median)} ns"))


def shown(x: FunctionErrors, number: int = 0) -> float:
    """The number of a mark: the worst error, or the largest bound of a certified function."""
    errors = x.errors[number]
    return errors.bounds.worst if errors.bounds else errors.worst


def _bars(axes: Axes, costs: Costs) -> None:
    rows = [x for x in costs.rows if x.function == _SHOWN]
    parts = [f"{x.part}\n{x.flops} flops" for x in rows]
    for i, precision in enumerate(PRECISIONS):
        times = [x.times[i] for x in rows]
        axes.barh(parts, [x.median for x in times], (0.4, -0.4)[i], align="edge",
                  xerr=[[x.median - x.low for x in times], [x.high - x.median for x in times]],
                  color=precision.colour, label=precision.name)
    axes.invert_yaxis()
    axes.set(xlabel="ns per call in C", title="forward dynamics, effect by effect")
    plots.legend_below(axes)


def _ends(axes: Axes, costs: Costs) -> None:
    """A curve for each integrator and precision; hollow marks are below the reference's error."""
    names = tuple(dict.fromkeys(x.integrator for x in costs.points))
    for (i, name), precision in product(enumerate(names), PRECISIONS):
        marks = [plots.Mark(
            f"{name} {precision.name} {x.error:g}", *x.time.numbers(1e6), x.error, f"C{i}",
            _MARKERS[i % len(_MARKERS)], not costs.known(x))
            for x in costs.points if (x.integrator, x.precision) == (name, precision.name)
            and 0 < x.error < math.inf]
        if marks:
            marks.sort(key=lambda x: (x.x, x.y))
            axes.plot([x.x for x in marks], [x.y for x in marks], precision.dash + marks[0].shape,
                      color=marks[0].colour, linewidth=1, label=f"{name}, {precision.name}",
                      gid=f"{name} {precision.name}")
            plots.scatter(axes, marks)
    axes.set(title="error at the end against time", ylabel="error of a coordinate, m or rad",
             xlabel="time of the run, µs (SciPy's in Python)")
    if not axes.lines:
        axes.text(0.5, 0.5, "no reference", transform=axes.transAxes, ha="center")
        return
    if costs.reference and costs.reference.error > 0:
        axes.axhline(costs.reference.error, color=plots.QUIET, linewidth=1, linestyle=":",
                     label=f"the reference's own, {costs.reference.error:.1g}", gid="reference")
    plots.legend_below(axes, "hollow: no worse than the reference")


def _run(axes: Axes, errors: RunErrors) -> None:
    """Draws a curve for each cause, and a cross where no digit is left; effects have other colours
    than tiers and the step, and dots."""
    for n, x in enumerate(errors.rows):
        name, (precision, *tier) = f"{x.cause}: {x.of}", x.of.split()
        colour, dash, width = (plots.INK, "-", 1.8) if x.cause == "step" else (f"C{n}", ":", 1.2)
        if x.cause == "rounding":  # wide where it coincides with plain's
            colour, dash = plots.COLOURS[tier[0]], BY_NAME[precision].dash
            width = 1.2 if tier[0] == PLAIN.name else 3
        values = np.array(x.errors)
        values[~np.isfinite(values) | (values == 0)] = np.nan
        axes.plot(errors.times, values, dash, color=colour, linewidth=width, label=name, gid=name,
                  alpha=1 if width < 3 else 0.5, zorder=2 if width < 3 else 1.9)
        if x.gone is not None:
            axes.plot([x.gone], [values[errors.times.index(x.gone)]], "x", color=colour,
                      gid=f"{name} gone")
    plots.logarithmic(axes.yaxis)
    axes.set(xlim=(0, errors.times[-1]), xlabel="t, s", ylabel="error of a coordinate, m or rad",
             title=f"errors of the run: {errors.integrator}, step {errors.step:g} s")
    plots.legend_below(axes, "×: no digit is right from here on")
