"""Writes a scene's costs as a page: plots, recommendations, tables; its text is for a terminal."""

import math
from collections.abc import Iterator, Sequence
from pathlib import Path

from coscrew_codegen.accuracy.tiers import PLAIN
from coscrew_codegen.backends import version
from coscrew_codegen.backends.html.pages import Chapter, Page, Table, with_interval
from coscrew_codegen.program.values.digits import three_digits
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.reports.cost.cost_measurement import Costs, Row
from coscrew_codegen.reports.cost.effect_ablation import SHOWN, WHOLE
from coscrew_codegen.reports.cost.figures import cost_figure
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
from coscrew_codegen.reports.processor import processor, system
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.simulation.recordings.recording_writer import delivered
from coscrew_codegen.simulation.result_units import in_unit, written

_FUNCTIONS = ("Down is more accurate, left is faster. Marks show the worst error found, those of "
              "certified functions the largest bound; lines start at the typical error. A ring is "
              "around the choice that is recommended. Hollow: another choice is better.")
_RUNS = ("Errors of a run, told apart: what each precision and tier rounds, what a shorter step "
         "changes, what effects contribute.")
_ABOUT = (
    f"Errors against {DIGITS} digits, the model's decimals being exact: at states of the run, "
    "between the limits of the joints, and at the worst of a search there; of the component with "
    "the largest error. Digits: correct digits of the largest component, typical and worst. The "
    "certified tier returns plain's results and bounds: the largest, and the least, median and "
    "largest ratio of bound to error.",
    f"Recommended is, of all choices that take at most {AFFORDABLE:g} times as long as the "
    "fastest, the most accurate; not certified, whose results are plain's. A choice is better than "
    "another if it is faster, the intervals apart, and as accurate in every unit; than a certified "
    "one, if it is certified, too.",
    "Times hold for this compiler with these flags. Without FMA (gcc -O2 has none on x86-64, "
    "-march=native or -mfma gives it) accurate and certified functions in double precision take "
    "two to three times as long, certified ones in single precision 1.3 times.")
_COLUMNS = ("typical error", "worst", "digits", "found in", "bound", "bound / error", "ns",
            "choice")
_ENDS = ("integrator", "precision", "step, s, or rtol", "steps", "time, µs", "error, m or rad",
         "best")
_MARKS = ("* no run is faster, the intervals apart, and as accurate",
          "< as accurate as the reference, so the error is not known better")
_PARTS = (8, 4, 2, 1)  # errors of runs are shown after one in 8, 4, 2 and 1 of the times
_CAUSES = ("Rounding: in this precision, with all functions of the steps in this tier. Step: "
           "steps a quarter as long. Model: without an effect. No digit is left once an error "
           "exceeds a tenth of the largest coordinate with its unit, or of half a turn.")
_LIMITS = ("shorter steps would be more accurate", "shorter steps would gain nothing")


def write(costs: Costs, path: Path, command: str) -> None:
    """Write the page.  Raises SimulateError."""
    text = page(costs, command).html()
    with delivered(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def page(costs: Costs, command: str) -> Page:
    """The page; its text for a terminal has all tables and recommendations."""
    return Page(f"What accuracy costs in {costs.scene}", (
        "Times are in ns per call in C: the median (95 % interval) of rounds in which all "
        f"variants take turns. Compiler: {costs.compiler}.",), tuple(_chapters(costs)), (
            ("command", command), ("machine", f"{processor()}, {system()}"),
            ("software", f"coscrew {version.described()}")))


def _chapters(costs: Costs) -> Iterator[Chapter]:
    if costs.answers or costs.cores:
        yield Chapter("What suffices", tables=(
            *((need_table.table(costs.answers),) if costs.answers else ()),
            *((core_costs.table(costs.cores),) if costs.cores else ())))
    if costs.cores:
        yield Chapter("Bounds against time and instructions", figures=(*cost_figure.cores(costs),))
    if costs.accuracy:
        yield Chapter("Error against time", (_FUNCTIONS,), (*cost_figure.functions(costs),))
    if panels := (*cost_figure.runs(costs),):
        yield Chapter("Effects and runs", (_RUNS,), panels)
    if costs.accuracy:
        yield Chapter("What to choose", tuple(" ".join(sentences(x)) for x in costs.accuracy))
        yield Chapter("Errors, bounds and times", tuple(about(costs)),
                      tables=[x for rows in costs.accuracy for x in accuracies(rows)])
    if tables := (*others(costs),):
        yield Chapter("Operations, effects, runs", tables=tables)


def about(costs: Costs) -> Iterator[str]:
    """Explains the tables of errors."""
    yield from _ABOUT
    if costs.load:
        yield str(costs.load)
    kept, left = ({x.precision for x in costs.accuracy[0] if x.emitted == y} for y in (True, False))
    if left:
        yield (f"The scene is generated in {', '.join(kept)} precision alone: {', '.join(left)} is "
               "measured for comparison, not recommended.")


def accuracies(rows: Sequence[FunctionErrors]) -> Iterator[Table]:
    """A function's errors and times in each tier and precision, unit by unit.  Units in which all
    results are exact are left out, unless there are no others."""
    known = units_with_errors(rows)
    exact = ", ".join(written(e.unit) for n, e in enumerate(rows[0].errors) if n not in known)
    for n in known:
        yield Table(
            (f"{rows[0].function}, {written(rows[0].errors[n].unit)}", *_COLUMNS),
            tuple((x.name, *_errors(x.errors[n]), _in_words(x.time), _choice(x, rows))
                  for x in rows),
            (f"Exact in all choices: {exact}.",) if exact and n == known[-1] else ())


def _choice(x: FunctionErrors, rows: Sequence[FunctionErrors]) -> str:
    if x is recommended(rows):
        return "recommended"
    other = better(x, rows)
    return f"{other.name} is better" if other else ""


def _errors(x: ErrorStatistics) -> tuple[str, ...]:
    bounds = x.bounds and (x.bounds.least_ratio, x.bounds.typical_ratio, x.bounds.worst_ratio)
    typical, worst = (f"{y:.1f}" if math.isfinite(y) else "all"
                      for y in (x.typical_digits, x.worst_digits))
    return (in_unit(x.typical, x.unit), in_unit(x.worst, x.unit), f"{typical}, {worst}",
            x.place if x.worst else "", in_unit(x.bounds.worst, x.unit) if x.bounds else "",
            ", ".join(map(_ratio, bounds)) if bounds and x.worst else "")


def _ratio(x: float) -> str:
    """Writes three digits, also for 1: 1.00."""
    return f"{x:.2f}" if float(f"{x:.2e}") < 10 else three_digits(x)


def others(costs: Costs) -> Iterator[Table]:
    """Tables of operations, effects and runs, as far as they were measured: for each of the SHOWN
    functions its cost in each part that has other operations, and the savings."""
    if whole := [x for x in costs.rows if x.part == WHOLE]:
        yield Table.of({WHOLE: x.function, **_cost(x), "operations": x.words} for x in whole)
    for first in (x for name in SHOWN for x in whole if x.function == name):
        parts = [x for x in costs.rows if x.function == first.function
                 and (x is first or x.words != first.words)]
        if len(parts) > 1:
            yield Table.of({first.function: x.part, **_cost(x),
                            "flops saved": str(first.flops - x.flops or "")} for x in parts)
    if costs.runs:
        yield _ends(costs)
    if costs.run_errors:
        yield of_run(costs.run_errors)


def _cost(x: Row) -> dict[str, str]:
    return {"flops": str(x.flops), **{f"{precision.name}, ns": _in_words(time) for precision, time
                                      in zip(PRECISIONS, x.times, strict=True)}}


def _ends(costs: Costs) -> Table:
    truth = costs.reference
    if truth is None:
        return Table(_ENDS, (), (
            "No accuracy against time: neither DOP853 nor Radau's method reaches the end of this "
            "run with tight tolerances in time.",))
    return Table(_ENDS, tuple(
        (x.integrator, x.precision, three_digits(x.step), str(x.steps), _in_words(x.time, 1e6),
         three_digits(x.error) if math.isfinite(x.error) else "unstable",
         "<" if not costs.known(x) else "*" if costs.best(x) else "") for x in costs.points), (
             *_MARKS, f"Error of the coordinates at t = {truth.t:g} s against time; the reference "
             f"is {truth.words}, good to about {truth.error:.1g}. Steps of emitted integrators, in "
             "C; tolerances of SciPy's, in Python. Times: median (from low to high: in C a 95 % "
             "interval; in Python the shortest and the longest)."))


def of_run(errors: RunErrors) -> Table:
    """A column for each of a few times."""
    shown = sorted({max(0, len(errors.times) // n - 1) for n in _PARTS})
    covered = f"the whole {errors.until:g} s" if errors.whole else (
        f"the first {errors.times[-1]:.4g} s of {errors.until:g} s: more would take more than "
        f"{errors.most / 1e6:g} million instructions with {RUN_DIGITS} digits")
    return Table(
        ("cause", *(f"t = {errors.times[n]:.4g} s" for n in shown), "digits gone"), tuple(
            (f"{x.cause}: {x.of}", *(in_unit(x.errors[n], "1") for n in shown),
             f"from {x.gone:.4g} s" if x.gone is not None else "") for x in errors.rows), (
                 f"Errors of a run in m or rad, by cause: {errors.integrator}, step "
                 f"{errors.step:g} s, {covered}, against the same steps with {RUN_DIGITS} digits.",
                 _CAUSES, *_compared(errors)))


def _compared(errors: RunErrors) -> Iterator[str]:
    """States the largest error of the run in each precision, as long as digits are left."""
    (step,) = (x for x in errors.rows if x.cause == "step")
    for x in errors.rows:
        if x.cause != "rounding" or not x.of.endswith(f" {PLAIN.name}"):
            continue
        gone = [y.gone for y in (x, step) if y.gone is not None]
        if left := [n for n, t in enumerate(errors.times) if t < min(gone, default=math.inf)]:
            until = f"until t = {errors.times[left[-1]]:.4g} s " if gone else ""
            rounding, of_step = (max(y.errors[n] for n in left) for y in (x, step))
            yield (f"In {x.of.split()[0]} precision {until}rounding moves the run by at most "
                   f"{in_unit(rounding, '1')}, the step by {in_unit(of_step, '1')}: "
                   f"{_LIMITS[rounding > of_step]}.")


def _in_words(time: Interval, scale: float = 1) -> str:
    return with_interval(*time.numbers(scale))
