"""A scene's costs as tables."""

import math
from collections.abc import Sequence
from itertools import pairwise

from tabulate import tabulate

from coscrew_codegen.cost.leaving_out import SHOWN
from coscrew_codegen.cost.measure import Costs
from coscrew_codegen.cost.rounding import DIGITS, PLACES, UNITS, Rounding
from coscrew_codegen.cost.work_precision import Point
from coscrew_codegen.native.intervals import Interval

_MARKS = ("* no run is faster, the intervals apart, and as accurate\n"
          "< as accurate as the reference: it cannot tell more")


def table(costs: Costs) -> str:
    """The figure's numbers and more: functions, effects, accuracy."""
    parts = [f"{costs.scene}: {costs.compiler}\nns per call in C: median (95 % interval) of rounds "
             "in which all parts and both precisions take turns",
             roundings(costs.roundings), _functions(costs), _effects(costs), _accuracy(costs)]
    return "\n\n".join(x for x in parts if x)


def roundings(found: Sequence[Rounding]) -> str:
    """Errors and times in each tier and precision, and what the next better choice gains."""
    tables = [f"Rounding: the largest error of a component, against {DIGITS} digits: at "
              f"{PLACES['run']} states of the run, {PLACES['limits']} between\nthe limits of the "
              f"joints and {PLACES['search']} that a search found there; digits that are right of "
              "the largest component."]
    for name, unit in UNITS.items():
        rows = [x for x in found if x.function == name]
        lines = [(f"{x.precision} {x.tier}", x.typical, x.worst, f"{x.digits:.1f}", x.place,
                  _in_words(x.time), "" if _worse(x, rows) else "*") for x in rows]
        headers = (f"{name}, {unit}", "median", "worst", "digits", "found in", "ns", "best")
        if rows:
            tables += [str(tabulate(lines, headers, floatfmt=".2g")), *_advice(rows)]
    return "\n\n".join(tables)


def _worse(one: Rounding, rows: Sequence[Rounding]) -> bool:
    return any(other.better(one) for other in rows)


def _advice(rows: Sequence[Rounding]) -> list[str]:
    """What each step to a more accurate choice gains and costs, the fastest first."""
    best = sorted((x for x in rows if not _worse(x, rows)), key=lambda x: -x.worst)
    steps = [f"{b.precision} {b.tier} instead of {a.precision} {a.tier}: "
             f"{a.worst / b.worst:.3g} times less error in {b.time.median / a.time.median:.2f} "
             "times the time" for a, b in pairwise(best) if b.worst]
    return ["\n".join(steps)] if steps else []


def _functions(costs: Costs) -> str:
    rows = [(x.function, x.flops, *map(_in_words, x.times), x.words)
            for x in costs.rows if x.part == "all effects"]
    return str(tabulate(rows, ("all effects", "flops", "double, ns", "single, ns", "operations")))


def _effects(costs: Costs) -> str:
    """A table for each of the SHOWN functions: its cost in each part, and the savings."""
    tables = []
    for name in SHOWN:
        rows = [x for x in costs.rows if x.function == name]
        whole = rows[0].flops
        lines = [(x.part, x.flops, whole - x.flops or None, *map(_in_words, x.times))
                 for x in rows]
        tables.append(tabulate(lines, (name, "flops", "saved", "double, ns", "single, ns")))
    return "\n\n".join(tables) if len(rows) > 1 else ""


def _accuracy(costs: Costs) -> str:
    if costs.reference is None:
        return ("No accuracy against time: neither DOP853 nor Radau's method reaches the end of "
                "this run with tight tolerances in time.")
    truth = costs.reference
    head = (f"Error of the coordinates at t = {truth.t:g} s against time; the reference is "
            f"{truth.words}, good to about {truth.error:.1g}.\nSteps of emitted integrators, in C; "
            "tolerances of SciPy's, in Python.\nTimes: median (from low to high: in C a 95 % "
            "interval; in Python the shortest and the longest).")
    rows = [(x.integrator, x.precision, x.step, x.steps, _in_words(x.time, 1e6),
             x.error if math.isfinite(x.error) else "unstable", _mark(x, costs))
            for x in costs.points]
    headers = ("integrator", "precision", "step, s, or rtol", "steps", "time, µs",
               "error, m or rad", "best")
    return f"{head}\n{tabulate(rows, headers, floatfmt='.3g')}\n{_MARKS}"


def _in_words(time: Interval, scale: float = 1) -> str:
    return f"{scale * time.median:.3g} ({scale * time.low:.3g}–{scale * time.high:.3g})"


def _mark(point: Point, costs: Costs) -> str:
    if not costs.known(point):
        return "<"
    return "*" if _best(point, costs) else ""


def _best(point: Point, costs: Costs) -> bool:
    """Whether no other run is faster, with disjoint intervals, and at least as accurate."""
    return math.isfinite(point.error) and not any(
        x.time.below(point.time) and x.error <= point.error for x in costs.points)
