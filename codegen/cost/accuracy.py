"""Errors of a scene's functions in every tier and precision, against 50 digits, and the certified
tier's bounds beside them.

The reference evaluates the functions' Programs in mpmath: not the emitted text, no tier, no
precision.  The model's decimals are exact in it.
"""

import math
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import mpmath
import numpy as np
from mpmath import mpf

from coscrew_codegen.cost.loops import Compiled
from coscrew_codegen.cost.states import Box, Reals, Values, joined, searched
from coscrew_codegen.cost.units import units
from coscrew_codegen.formats import DOUBLE, PRECISIONS, Precision
from coscrew_codegen.native.intervals import Interval
from coscrew_codegen.program.interpreter import interpreter
from coscrew_codegen.program.multiprecise import MULTIPRECISE
from coscrew_codegen.simulate.plan import Trajectory
from coscrew_codegen.tiers import PLAIN, tier_named

DIGITS = 50
_UNTOLD = 10.0**(10 - DIGITS)  # of the largest component: an error that these digits cannot tell
ACCURATE, CERTIFIED = (tier_named(name).name for name in ("accurate", "certified"))
Exact = list[list[mpf]]
"""A function's results for each state."""


@dataclass(frozen=True)
class Bounds:
    """What a certified function states of its errors in one unit, over all states."""

    worst: float  # the largest bound; infinite if a state has none
    least_ratio: float  # of bound to error, of the components whose error is not 0; 0 if none has
    typical_ratio: float  # the median
    worst_ratio: float


@dataclass(frozen=True)
class Errors:
    """Errors of the components with this unit: at each state, that of the component with the
    largest.  Digits are those that are right of the largest component."""

    unit: str
    typical: float  # the median of all states
    worst: float
    typical_digits: float  # infinite if the results are exact
    worst_digits: float
    largest: float  # result
    place: str  # where the state of the worst error is from: run, limits, search
    bounds: Bounds | None


@dataclass(frozen=True)
class Accuracy:
    """A function's errors in a tier and precision, and its time."""

    function: str
    tier: str
    precision: str
    states: int
    time: Interval  # ns per call
    errors: tuple[Errors, ...]  # the unit of most components first
    worst_at: dict[str, tuple[float, ...]]  # inputs of the first unit's worst error, by name

    @property
    def name(self) -> str:
        """single accurate"""
        return f"{self.precision} {self.tier}"

    @property
    def relative(self) -> float:
        """The worst error, relative to the largest result with its unit."""
        return max(x.worst / x.largest if x.worst else 0.0 for x in self.errors)

    def better(self, other: "Accuracy") -> bool:
        """Whether it is faster, with disjoint intervals, and at least as accurate in every unit,
        and says as much of its errors."""
        return (self.time.below(other.time) and (self.tier == CERTIFIED) >= (
            other.tier == CERTIFIED) and all(
                a.worst <= b.worst for a, b in zip(self.errors, other.errors, strict=True)))


@dataclass(frozen=True)
class Choice:
    """A tier and precision to compute in."""

    tier: str
    precision: Precision


CHOICES = tuple(Choice(tier, p) for tier in (PLAIN.name, ACCURATE, CERTIFIED) for p in PRECISIONS)


@dataclass(frozen=True)
class Counts:
    """How many states are of the run, between the limits of the joints, and of the search there."""

    run: int = 16
    limits: int = 32
    search: int = 16

    @classmethod
    def of(cls, total: int) -> "Counts":
        """These states, divided alike."""
        return cls(total // 4, total - 2 * (total // 4), total // 4)


@dataclass(frozen=True)
class Measured:
    """A function of a scene, to be computed in every tier and precision."""

    built: Compiled
    name: str

    @property
    def units(self) -> tuple[str, ...]:
        """Of its components."""
        return units(self.built.part.functions, self.name)

    @property
    def different_units(self) -> list[str]:
        """Each once, that of most components first."""
        return [unit for unit, _ in Counter(self.units).most_common()]

    def inputs(self, states: Values) -> list[Reals]:
        """In the function's order."""
        program = self.built.part.functions.named(self.name).program
        return [states[a.name] for a in program.inputs]

    def values(self, choice: Choice, states: Values) -> list[Reals]:
        """The results and, if it is certified, their bounds: (states, components) each."""
        made = self.built.values(self.name, choice.precision, self.inputs(states), choice.tier)
        found = [x.astype(float) for x in made]
        if choice.tier != CERTIFIED:
            return [np.concatenate(found, axis=1)]
        half = len(found) // 2
        return [np.concatenate(x, axis=1) for x in (found[:half], found[half:])]

    def exact(self, states: Values) -> Exact:
        """The results to many digits."""
        program = self.built.part.functions.named(self.name).program
        with mpmath.workdps(DIGITS):
            evaluate = interpreter(program, MULTIPRECISE)
            return [evaluate([[mpf(float(x)) for x in np.ravel(part[row])]
                              for part in self.inputs(states)]) for row in range(len(states["t"]))]

    def states(self, box: Box, trajectory: Trajectory, counts: Counts
               ) -> tuple[dict[str, Reals], tuple[str, ...]]:
        """The states at which it is measured, and where each is from."""
        searches = [(precision, unit) for precision in PRECISIONS
                    for unit in self.different_units]
        each = max(1, counts.search // max(len(searches), 1))
        parts = [("run", box.of_run(trajectory, counts.run)),
                 ("limits", box.drawn(np.random.default_rng(2), counts.limits))]
        parts += [("search", searched(box, partial(self._apart, *x), each)) for x in searches]
        return (joined([x for _, x in parts]),
                tuple(place for place, x in parts for _ in x["t"]))

    def _apart(self, precision: Precision, unit: str, states: Values) -> Reals:
        """How far plain results are from those that are accurate in double: the largest component
        with this unit, for each state."""
        (plain,), (accurate,) = (self.values(x, states) for x in (
            Choice(PLAIN.name, precision), Choice(ACCURATE, DOUBLE)))
        found: Reals = np.abs(plain - accurate)[:, [x == unit for x in self.units]].max(axis=1)
        return found


def measured(built: Compiled, names: Sequence[str], box: Box, trajectory: Trajectory,
             counts: Counts, timed: Callable[[str, Values], Sequence[Interval]]
             ) -> Iterator[tuple[Accuracy, ...]]:
    """Every function in all CHOICES, with the times that `timed` returns for some states."""
    for name in names:
        function = Measured(built, name)
        states, places = function.states(box, trajectory, counts)
        truth, times = function.exact(states), timed(name, states)
        yield tuple(_accuracy(function, choice, states, places, truth, time)
                    for choice, time in zip(CHOICES, times, strict=True))


def _accuracy(function: Measured, choice: Choice, states: Values, places: Sequence[str],
              truth: Exact, time: Interval) -> Accuracy:
    computed, *bounds = function.values(choice, states)
    with mpmath.workdps(DIGITS):
        off = np.array([[_apart(mpf(float(x)), y) for x, y in zip(row, exact, strict=True)]
                        for row, exact in zip(computed, truth, strict=True)])
    sizes = np.nan_to_num([[abs(float(y)) for y in row] for row in truth])
    off[off < _UNTOLD * sizes.max(initial=0)] = 0
    found: list[Errors] = []
    worst = 0
    for unit in function.different_units:
        of = [n for n, x in enumerate(function.units) if x == unit]
        largest = off[:, of].max(axis=1)
        at = int(np.argmax(largest))
        worst = worst if found else at
        results = sizes[:, of].max(axis=1)
        digits = _digits(largest, results)
        found.append(Errors(
            unit, float(np.median(largest)), float(largest[at]), float(np.median(digits)),
            float(digits.min()), float(results.max()), places[at],
            _bounds(bounds[0][:, of], off[:, of]) if bounds else None))
    inputs = function.built.part.functions.named(function.name).program.inputs
    return Accuracy(function.name, choice.tier, choice.precision.name, len(truth), time,
                    tuple(found), {a.name: tuple(np.ravel(states[a.name][worst]).tolist())
                                   for a in inputs})


def _apart(x: mpf, y: mpf) -> float:
    """|x - y|; 0 if both are NaN, infinite if one is."""
    if mpmath.isnan(x) or mpmath.isnan(y):
        return 0.0 if mpmath.isnan(x) and mpmath.isnan(y) else math.inf
    return float(abs(x - y))


def _digits(errors: Reals, sizes: Reals) -> Reals:
    """Digits that are right of numbers of these sizes: from 0 to infinity."""
    with np.errstate(divide="ignore", invalid="ignore"):
        found: Reals = np.log10(np.maximum(sizes, errors)) - np.log10(errors)
    return np.where(errors == 0, np.inf, np.where(np.isinf(errors), 0, found))


def _bounds(bounds: Reals, errors: Reals) -> Bounds:
    known = np.where(np.isnan(bounds), np.inf, bounds)
    ratios = known[errors > 0] / errors[errors > 0]
    least, typical, worst = (ratios.min(), np.median(ratios), ratios.max()) if ratios.size else (
        0.0, 0.0, 0.0)
    return Bounds(float(known.max()), float(least), float(typical), float(worst))
