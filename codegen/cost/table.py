"""A scene's costs as tables."""

import math

from tabulate import tabulate

from coscrew_codegen.cost.leaving_out import SHOWN
from coscrew_codegen.cost.measure import Costs
from coscrew_codegen.cost.work_precision import Point
from coscrew_codegen.native.intervals import Interval

_MARKS = ("* no run is faster, the intervals apart, and as accurate\n"
          "< as accurate as the reference: it cannot tell more")


def table(costs: Costs) -> str:
    """The figure's numbers and more: functions, effects, accuracy."""
    parts = [f"{costs.scene}: {costs.compiler}\nns per call in C: median (95 % interval) of rounds "
             "in which all parts and both precisions take turns",
             _functions(costs), _effects(costs), _accuracy(costs)]
    return "\n\n".join(x for x in parts if x)


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
