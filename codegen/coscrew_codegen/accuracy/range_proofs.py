"""Proved bounds of the results of a scene's function in its tiers, for all arguments in the ranges
that the scene states."""

from typing import NamedTuple

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import RoundingRule, ValueBounds
from coscrew_codegen.program import Program
from coscrew_codegen.program.roundoff import Upward
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision


class ResultBound(NamedTuple):
    """ResultBounds of the size of an exact result, and of the error of the computed one."""

    size: float
    error: float


ResultBounds = tuple[ResultBound, ...]
"""The bounds of each component of the results."""


def values(program: Program, function: FunctionProgram, precision: Precision, rule: RoundingRule
           ) -> ValueBounds:
    """The bounds of all values of the function's program, for arguments in a precision."""
    ranges = function.ranges
    if ranges is None:
        raise ValueError(f"{function.name} has no stated ranges; wanted [ranges] in the scene")
    return ValueBounds(program, ranges.sizes(precision), rule, ranges.quaternions)


def of_plain(function: FunctionProgram, precision: Precision) -> ResultBounds:
    """The bounds of the plain tier's results."""
    return _bounds(values(function.program, function, precision, FloatRounding(precision)))


def of_accurate(function: FunctionProgram, precision: Precision) -> ResultBounds | None:
    """The bounds of the accurate tier's results in single precision, which is plain double
    precision rounded once."""
    if precision != SINGLE:
        return None
    program = function.program.fine or function.program
    inside = values(program, function, precision, FloatRounding(DOUBLE))
    u, eta = Upward(precision.u), Upward(precision.eta)
    return tuple(ResultBound(x.size, x.error + u * (x.size + x.error) + eta)
                 for x in inside.results)


def _bounds(inside: ValueBounds) -> ResultBounds:
    return tuple(ResultBound(x.size, x.error) for x in inside.results)
