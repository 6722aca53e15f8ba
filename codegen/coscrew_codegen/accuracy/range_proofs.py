"""Proved bounds of the results of a scene's function in its tiers, for all arguments in the ranges
that the scene states."""

from math import inf
from typing import TYPE_CHECKING, NamedTuple

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import RoundingRule, ValueBounds
from coscrew_codegen.program import Program
from coscrew_codegen.program.roundoff import Upward
from coscrew_codegen.program.scene_functions import ArgumentRanges, FunctionProgram
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision

if TYPE_CHECKING:
    from coscrew_codegen.accuracy.tiers.mixed import Mixture


class ResultBound(NamedTuple):
    """ResultBounds of the size of an exact result, and of the error of the computed one."""

    size: float
    error: float


ResultBounds = tuple[ResultBound, ...]
"""The bounds of each component of the results."""


def values(program: Program, ranges: ArgumentRanges | None, precision: Precision,
           rule: RoundingRule) -> ValueBounds:
    """The bounds of all values of a program, for arguments in a precision."""
    if ranges is None:
        raise ValueError(f"{program.name} has no stated ranges; wanted [ranges] in the scene")
    return ValueBounds(program, ranges.sizes(precision), rule, ranges.quaternions)


def of_plain(function: FunctionProgram, precision: Precision) -> ResultBounds:
    """The bounds of the plain tier's results."""
    inside = values(function.program, function.ranges, precision, FloatRounding(precision))
    return tuple(ResultBound(x.size, x.error) for x in inside.results)


def of_accurate(function: FunctionProgram, precision: Precision) -> ResultBounds:
    """The bounds of the accurate tier's results: in single precision plain double precision is
    rounded once, in double precision all is carried in pairs."""
    if precision != SINGLE:
        return of_pairs(function, precision)
    program = function.program.fine or function.program
    inside = values(program, function.ranges, precision, FloatRounding(DOUBLE))
    u, eta, most = Upward(precision.u), Upward(precision.eta), float(precision.limit("max"))
    return tuple(ResultBound(x.size, x.error + u * (x.size + x.error) + eta
                             if x.size + x.error <= most else inf) for x in inside.results)


def of_pairs(function: FunctionProgram, precision: Precision) -> ResultBounds:
    """The bounds of results whose values are all carried in pairs."""
    return of_mixture(function.program.fine or function.program, function.ranges, precision)


def of_mixture(program: Program, ranges: ArgumentRanges | None, precision: Precision,
               mixture: "Mixture | None" = None) -> ResultBounds:
    """The bounds of a program's results; this mixture of instructions, or all, are carried in
    pairs."""
    from coscrew_codegen.accuracy.pair_rounding import PairRounding  # with it come all tiers

    inside = values(program, ranges, precision, PairRounding(precision, mixture))
    return tuple(ResultBound(x.size, x.error) for x in inside.results)
