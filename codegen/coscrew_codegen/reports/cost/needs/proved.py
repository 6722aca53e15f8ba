"""Proves bounds of rounding errors for all states between the limits from which states are drawn.

The accurate tier's single precision is the plain program in double precision, rounded once."""

from math import inf

import numpy as np

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import ValueBounds
from coscrew_codegen.accuracy.tiers import PLAIN, tier_named
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.reports.cost.error_states import Box
from coscrew_codegen.reports.cost.measured import ACCURATE, CERTIFIED, TierChoice

_ROOM = 1 + 2.0**-20  # states are rounded to single precision; sums below are in double


def proved(function: FunctionProgram, choice: TierChoice, box: Box) -> tuple[float, ...]:
    """Bounds of the errors of each component of the plain function's results in this choice, over
    the scene's ranges if it states any; inf without a proof."""
    if function.ranges:
        return over_ranges(function, choice) or (inf,) * len(function.units)
    rounds = choice.tier == ACCURATE and choice.precision == SINGLE
    program, precision = function.program, choice.precision
    if rounds:
        program, precision = program.fine or program, DOUBLE
    if not rounds and choice.tier not in (PLAIN.name, CERTIFIED):  # certified: plain's results
        return (inf,) * len(function.units)
    sizes = [_sizes(a.name, a.quantity.size, box) for a in program.inputs]
    values = ValueBounds(program, sizes, FloatRounding(precision))
    return tuple(_rounded(x.size, x.error, SINGLE) if rounds else float(x.error)
                 for x in values.results)


def over_ranges(function: FunctionProgram, choice: TierChoice) -> tuple[float, ...] | None:
    """The bounds of each component over the ranges that the scene states; None without ranges, or
    if the tier has no proof."""
    tier = tier_named(choice.tier)
    if tier.on_request:  # proved within the request, when it was made
        request = function.accuracy
        return request.tolerances if request and request.stated else None
    bounds = tier.proof(function, choice.precision) if tier.proof and function.ranges else None
    return tuple(float(x.error) for x in bounds) if bounds else None


def _rounded(size: float, error: float, precision: Precision) -> float:
    """The error after one more rounding, underflow included."""
    return _ROOM * (error + float(precision.u) * (size + error)
                    + float(precision.limit("smallest_subnormal")))


def _sizes(name: str, count: int, box: Box) -> list[float]:
    """Bounds of the sizes of an input's components in the box; inf if it has none."""
    known = {"p": np.abs(np.array(box.system.p, float)), "h": np.array([box.step]),
             "phi": box.step * box.half["v"]}
    if name in box.half:
        known[name] = np.abs(box.centre[name]) + box.half[name]
    values = np.ravel(known.get(name, np.full(count, inf)))
    return [float(_ROOM * x) for x in values]
