"""Writes a scene's costs as tables, for the terminal and for the page."""

import math
from collections.abc import Iterator, Sequence

from coscrew_codegen.accuracy.tiers import PLAIN
from coscrew_codegen.backends.html.pages import Table, wrapped
from coscrew_codegen.program.values.digits import three_digits
from coscrew_codegen.reports.cost.cost_measurement import Costs
from coscrew_codegen.reports.cost.effect_ablation import SHOWN, WHOLE
from coscrew_codegen.reports.cost.function_errors import (
    ErrorStatistics,
    FunctionErrors,
    units_with_errors,
)
from coscrew_codegen.reports.cost.measured import DIGITS
from coscrew_codegen.reports.cost.needs import core_costs, need_table
from coscrew_codegen.reports.cost.recommendations import AFFORDABLE, better, recommended, sentences
from coscrew_codegen.reports.cost.run_errors import DIGITS as RUN_DIGITS
from coscrew_codegen.reports.cost.run_errors import RunErrors
from coscrew_codegen.reports.cost.work_precision import Point
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.simulation.result_units import in_unit, written

ABOUT = (f"Errors against {DIGITS} digits, the model's decimals being exact: at states of the run, "
         "between the limits of the joints, and at the worst of a search there; of the component "
         "with the largest error. Digits: correct digits of the largest component, typical and "
         "worst. The certified tier returns plain's results and bounds: the largest, and the "
         "least, median and largest ratio of bound to error.")
_HEADERS = ("typical error", "worst", "digits", "found in", "bound", "bound / error", "ns",
            "choice")
_PARTS = (8, 4, 2, 1)  # errors of runs are shown after one in 8, 4, 2 and 1 of the times
_CAUSES = ("Rounding: in this precision, with all functions of the steps in this tier. Step: "
           "steps a quarter as long. Model: without an effect. No digit is left once an error "
           "exceeds a tenth of the largest coordinate with its unit, or of half a turn.")
_LIMITS = ("shorter steps would be more accurate", "shorter steps would gain nothing")
RULE = (f"Recommended is, of all choices that take at most {AFFORDABLE:g} times as long as the "
        "fastest, the most accurate; not certified, whose results are plain's. A choice is better "
        "than another if it is faster, the intervals apart, and as accurate in every unit; than a "
        "certified one, if it is certified, too.")
FUSED = ("Times hold for this compiler with these flags. Without FMA (gcc -O2 has none on x86-64, "
         "-march=native or -mfma gives it) accurate and certified functions in double precision "
         "take two to three times as long, certified ones in single precision 1.3 times.")
_MARKS = ("* no run is faster, the intervals apart, and as accurate",
          "< as accurate as the reference, so the error is not known better")


def table(costs: Costs) -> str:
    """All tables, and the recommendations."""
    head = (f"{costs.scene}: {costs.compiler}\nns per call in C: median (95 % interval) of rounds "
            "in which all variants take turns")
    parts = [head, *([need_table.table(costs.answers).text()] if costs.answers else []),
             *([core_costs.table(costs.cores).text()] if costs.cores else []),
             *map(wrapped, about(costs))]
    for rows in costs.accuracy:
        parts += [x.text() for x in accuracies(rows)] + ["\n".join(sentences(rows))]
    return "\n\n".join((*parts, *(x.text() for x in others(costs))))


def about(costs: Costs) -> Iterator[str]:
    """Explains the tables of errors."""
    if costs.accuracy:
        yield from (ABOUT, RULE, FUSED)
        if costs.load:
            yield str(costs.load)
        left = {x.precision for x in costs.accuracy[0] if not x.emitted}
        if left:
            kept = {x.precision for x in costs.accuracy[0] if x.emitted}
            yield (f"The scene is generated in {', '.join(kept)} precision alone: "
                   f"{', '.join(left)} is measured for comparison, not recommended.")


def accuracies(rows: Sequence[FunctionErrors]) -> Iterator[Table]:
    """A function's errors and times in each tier and precision, unit by unit.  Units in which all
    results are exact are left out, unless there are no others."""
    known = units_with_errors(rows)
    exact = ", ".join(written(e.unit) for n, e in enumerate(rows[0].errors) if n not in known)
    for n in known:
        yield Table(
            (f"{rows[0].function}, {written(rows[0].errors[n].unit)}", *_HEADERS),
            tuple((x.name, *_errors(x.errors[n]), _in_words(x.time), _choice(x, rows))
                  for x in rows),
            below=(f"Exact in all choices: {exact}.",) if exact and n == known[-1] else ())


def _choice(x: FunctionErrors, rows: Sequence[FunctionErrors]) -> str:
    if x is recommended(rows):
        return "recommended"
    other = better(x, rows)
    return f"{other.name} is better" if other else ""


def others(costs: Costs) -> Iterator[Table]:
    """Tables of operations, effects and runs, as far as they were measured."""
    if costs.rows:
        yield _functions(costs)
        yield from _effects(costs)
    if costs.runs:
        yield _accuracy(costs)
    if costs.run_errors:
        yield of_run(costs.run_errors)


def _errors(x: ErrorStatistics) -> tuple[str, ...]:
    bounds = ("", "") if x.bounds is None else (
        in_unit(x.bounds.worst, x.unit),
        ", ".join(map(_ratio, (x.bounds.least_ratio, x.bounds.typical_ratio,
                                     x.bounds.worst_ratio))) if x.worst else "")
    digits = f"{_digits(x.typical_digits)}, {_digits(x.worst_digits)}"
    return (in_unit(x.typical, x.unit), in_unit(x.worst, x.unit), digits,
            x.place if x.worst else "", *bounds)


def _ratio(x: float) -> str:
    """Writes three digits, also for 1: 1.00."""
    return f"{x:.2f}" if float(f"{x:.2e}") < 10 else three_digits(x)


def _digits(x: float) -> str:
    return f"{x:.1f}" if math.isfinite(x) else "all"


def _functions(costs: Costs) -> Table:
    return Table((WHOLE, "flops", "double, ns", "single, ns", "operations"), tuple(
        (x.function, str(x.flops), *map(_in_words, x.times), x.words)
        for x in costs.rows if x.part == WHOLE))


def _effects(costs: Costs) -> Iterator[Table]:
    """A table for each of the SHOWN functions: its cost in each part that has other operations, and
    the savings."""
    for name in SHOWN:
        rows = [x for x in costs.rows if x.function == name]
        rows = [x for x in rows if x is rows[0] or x.words != rows[0].words]
        if len(rows) > 1:
            yield Table((name, "flops", "saved", "double, ns", "single, ns"), tuple(
                (x.part, str(x.flops), str(rows[0].flops - x.flops or ""),
                 *map(_in_words, x.times)) for x in rows))


def _accuracy(costs: Costs) -> Table:
    headers = ("integrator", "precision", "step, s, or rtol", "steps", "time, µs",
               "error, m or rad", "best")
    if costs.reference is None:
        return Table(headers, (), (
            "No accuracy against time: neither DOP853 nor Radau's method reaches the end of this "
            "run with tight tolerances in time.",))
    truth = costs.reference
    head = (f"Error of the coordinates at t = {truth.t:g} s against time; the reference is "
            f"{truth.words}, good to about {truth.error:.1g}.",
            "Steps of emitted integrators, in C; tolerances of SciPy's, in Python.",
            "Times: median (from low to high: in C a 95 % interval; in Python the shortest and the "
            "longest).")
    return Table(headers, tuple(
        (x.integrator, x.precision, three_digits(x.step), str(x.steps), _in_words(x.time, 1e6),
         three_digits(x.error) if math.isfinite(x.error) else "unstable", _mark(x, costs))
        for x in costs.points), head, _MARKS)


def of_run(errors: RunErrors) -> Table:
    """A column for each of a few times."""
    shown = sorted({max(0, len(errors.times) // n - 1) for n in _PARTS})
    headers = ("cause", *(f"t = {errors.times[n]:.4g} s" for n in shown), "digits gone")
    return Table(headers, tuple(
        (f"{x.cause}: {x.of}", *(in_unit(x.errors[n], "1") for n in shown),
         f"from {x.gone:.4g} s" if x.gone is not None else "") for x in errors.rows), (
             f"Errors of a run in m or rad, by cause: {errors.integrator}, step {errors.step:g} s, "
             f"{_covered(errors)}, against the same steps with {RUN_DIGITS} digits.",
             _CAUSES), tuple(_compared(errors)))


def _covered(errors: RunErrors) -> str:
    if errors.whole:
        return f"the whole {errors.until:g} s"
    return (f"the first {errors.times[-1]:.4g} s of {errors.until:g} s: more would take more than "
            f"{errors.most / 1e6:g} million instructions with {RUN_DIGITS} digits")


def _compared(errors: RunErrors) -> Iterator[str]:
    """States the largest error of the run in each precision, as long as digits are left."""
    (step,) = (x for x in errors.rows if x.cause == "step")
    for x in errors.rows:
        if x.cause != "rounding" or not x.of.endswith(f" {PLAIN.name}"):
            continue
        precision, gone = x.of.split()[0], [y.gone for y in (x, step) if y.gone is not None]
        left = [n for n, t in enumerate(errors.times) if t < min(gone, default=math.inf)]
        until = f"until t = {errors.times[left[-1]]:.4g} s " if gone and left else ""
        rounding, of_step = (max((y.errors[n] for n in left), default=math.inf) for y in (x, step))
        if left:
            yield (f"In {precision} precision {until}rounding moves the run by at most "
                   f"{in_unit(rounding, '1')}, the step by {in_unit(of_step, '1')}: "
                   f"{_LIMITS[rounding > of_step]}.")


def _in_words(time: Interval, scale: float = 1) -> str:
    median, low, high = (three_digits(scale * x) for x in (time.median, time.low, time.high))
    return f"{median} ({low}–{high})"


def _mark(point: Point, costs: Costs) -> str:
    if not costs.known(point):
        return "<"
    return "*" if best(point, costs) else ""


def best(point: Point, costs: Costs) -> bool:
    """Returns whether no other run is faster, with disjoint intervals, and at least as accurate."""
    return math.isfinite(point.error) and not any(
        x.time.below(point.time) and x.error <= point.error for x in costs.points)
