"""Errors of a scene's functions in every tier and precision, against 50 digits, and the certified
tier's bounds beside them.

The reference evaluates the functions' Programs on MPFR's numbers: not the emitted text, no tier, no
precision.  The model's decimals are exact in it.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import gmpy2
import numpy as np
from gmpy2 import mpfr

from coscrew_codegen.program.multiprecise import precise
from coscrew_codegen.reports.cost.error_states import Box, Reals, Values
from coscrew_codegen.reports.cost.loops import CompiledLoops
from coscrew_codegen.reports.cost.measured import (
    CERTIFIED,
    DIGITS,
    Counts,
    Exact,
    Measured,
    TierChoice,
    choices,
)
from coscrew_codegen.reports.cost.needs.proved import over_ranges
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.simulation.plan import Trajectory

_UNTOLD = 10.0**(10 - DIGITS)  # of the largest component: the error that these digits resolve


@dataclass(frozen=True)
class Bounds:
    """Error bounds that a certified function states in one unit, over all states."""

    worst: float  # the largest bound; infinite if a state has none
    least_ratio: float  # of bound to error, of the components whose error is not 0; 0 if none has
    typical_ratio: float  # the median
    worst_ratio: float


@dataclass(frozen=True)
class ErrorStatistics:
    """Errors of the components with this unit: at each state, that of the worst component.  Digits
    are the correct digits of the largest component."""

    unit: str
    typical: float  # the median of all states
    worst: float
    typical_digits: float  # infinite if the results are exact
    worst_digits: float
    largest: float  # result
    place: str  # source of the state of the worst error: run, limits, search
    bounds: Bounds | None
    proved: float | None = None  # bound for all arguments in the scene's ranges, if it states any


@dataclass(frozen=True)
class FunctionErrors:
    """A function's errors in a tier and precision, and its time."""

    function: str
    tier: str
    precision: str
    states: int
    time: Interval  # ns per call
    errors: tuple[ErrorStatistics, ...]  # the unit of most components first
    worst_at: dict[str, tuple[float, ...]]  # inputs of the first unit's worst error, by name
    emitted: bool = True  # whether the scene is generated in this precision

    @property
    def name(self) -> str:
        """single accurate"""
        return f"{self.precision} {self.tier}"

    @property
    def relative(self) -> float:
        """The worst error, relative to the largest result with its unit."""
        return max(x.worst / x.largest if x.worst else 0.0 for x in self.errors)

    def better(self, other: "FunctionErrors") -> bool:
        """Returns whether it is faster, with disjoint intervals, at least as accurate in every
        unit, and gives bounds if the other does: plain is not better than certified."""
        return (self.time.below(other.time) and (self.tier == CERTIFIED) >= (
            other.tier == CERTIFIED) and all(
                a.worst <= b.worst for a, b in zip(self.errors, other.errors, strict=True)))


def units_with_errors(rows: Sequence[FunctionErrors]) -> list[int]:
    """The numbers of a function's units in which any choice has an error, or the first."""
    return [n for n, _ in enumerate(rows[0].errors) if any(x.errors[n].worst for x in rows)] or [0]


def measured(built: CompiledLoops, names: Sequence[str], box: Box, trajectory: Trajectory,
             counts: Counts, timed: Callable[[str, Values], Sequence[Interval]]
             ) -> Iterator[tuple[FunctionErrors, ...]]:
    """Measures every function in all choices, with the times that `timed` returns for some states.
    """
    for name in names:
        function = Measured(built, name)
        states, places = function.states(box, trajectory, counts)
        truth, times = function.exact(states), timed(name, states)
        yield tuple(_accuracy(function, choice, states, places, truth, time)
                    for choice, time in zip(choices(built, name), times, strict=True))


def _accuracy(function: Measured, choice: TierChoice, states: Values, places: Sequence[str],
              truth: Exact, time: Interval) -> FunctionErrors:
    computed, *bounds = function.values(choice, states)
    with precise(DIGITS):
        off = np.array([[_apart(mpfr(float(x)), y) for x, y in zip(row, exact, strict=True)]
                        for row, exact in zip(computed, truth, strict=True)])
    sizes = np.nan_to_num([[abs(float(y)) for y in row] for row in truth])
    off[off < _UNTOLD * sizes.max(initial=0)] = 0
    values: list[ErrorStatistics] = []
    worst, proved = 0, over_ranges(function.built.part.functions.named(function.name), choice)
    for unit in function.different_units:
        of = [n for n, x in enumerate(function.units) if x == unit]
        largest = off[:, of].max(axis=1)
        at = int(np.argmax(largest))
        worst = worst if values else at
        results = sizes[:, of].max(axis=1)
        digits = _digits(largest, results)
        values.append(ErrorStatistics(
            unit, float(np.median(largest)), float(largest[at]), float(np.median(digits)),
            float(digits.min()), float(results.max()), places[at],
            _bounds(bounds[0][:, of], off[:, of]) if bounds else None,
            max((proved[n] for n in of), default=0.0) if proved else None))
    inputs = function.built.part.functions.named(function.name).program.inputs
    return FunctionErrors(function.name, choice.tier, choice.precision.name, len(truth), time,
                          tuple(values), {a.name: tuple(np.ravel(states[a.name][worst]).tolist())
                                          for a in inputs})


def _apart(x: mpfr, y: mpfr) -> float:
    """|x - y|; 0 if both are NaN, infinite if one is."""
    if gmpy2.is_nan(x) or gmpy2.is_nan(y):
        return 0.0 if gmpy2.is_nan(x) and gmpy2.is_nan(y) else math.inf
    return float(abs(x - y))


def _digits(errors: Reals, sizes: Reals) -> Reals:
    """Number of correct digits of results of these sizes: from 0 to infinity."""
    with np.errstate(divide="ignore", invalid="ignore"):
        result: Reals = np.log10(np.maximum(sizes, errors)) - np.log10(errors)
    return np.where(errors == 0, np.inf, np.where(np.isinf(errors), 0, result))


def _bounds(bounds: Reals, errors: Reals) -> Bounds:
    known = np.where(np.isnan(bounds), np.inf, bounds)
    ratios = known[errors > 0] / errors[errors > 0]
    least, typical, worst = (ratios.min(), np.median(ratios), ratios.max()) if ratios.size else (
        0.0, 0.0, 0.0)
    return Bounds(float(known.max()), float(least), float(typical), float(worst))
