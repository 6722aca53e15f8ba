"""Chooses a mixture of single precision and pairs whose results reach a requested accuracy.

Instructions whose rounding moves a result by more than a threshold, to first order, are carried in
pairs; the threshold of an instruction grows with some power of its cost in pairs.  For each of a
few powers, the largest threshold is searched at which the certified bounds of the results' errors
are within the request, with a margin, at the states where single precision errs most among random
states and those of a search; the cheapest mixture is taken.  Then new states are drawn, and
searched where this mixture errs most.  As long as the bounds exceed the request there, the worst
states join the sample and the margin grows.

The bounds are those of the certified tier, |x̂ - w| + B with w of double precision, for the x̂ of
the mixture: they hold at their states for any mixture."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache
from math import prod, sqrt

import numpy as np

from coscrew_codegen.accuracy.precision_tuning.array_evaluation import Array
from coscrew_codegen.accuracy.precision_tuning.error_search import Sizes, climbed, errors, results
from coscrew_codegen.accuracy.precision_tuning.sample import States, StateSample
from coscrew_codegen.accuracy.precision_tuning.sample import in_double as double
from coscrew_codegen.accuracy.precision_tuning.sensitivity import OWN, Place, sensitivities
from coscrew_codegen.accuracy.range_proofs import of_mixture
from coscrew_codegen.accuracy.tiers.accurate_scene import in_pairs
from coscrew_codegen.accuracy.tiers.certified_wide import in_double
from coscrew_codegen.accuracy.tiers.mixed import CARRYING, Mixture, mixed
from coscrew_codegen.program import Instruction, Op, Program
from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.program.scene_functions import Accuracy, ArgumentRanges
from coscrew_codegen.program.values.digits import two_digits_up
from coscrew_codegen.program.values.formats import SINGLE
from coscrew_codegen.program.whole_cost import whole_counts

DRAWN, SEARCHED = 20_000, 4000
"""Numbers of states; the search uses those of the first where single precision errs most."""
_LEAST = 0.01  # least part of this budget; below it, everything is in pairs
SEARCHES = 3
"""Number of searches that must find no state where the mixture's bounds exceed the request."""
ROOM = 0.97
"""Initial fraction of the error budget left by all-pairs evaluation that mixtures may use at the
sampled states."""
_RANKED, _WORST = 64, 16  # states for sensitivities: random ones; the worst of each result
_MORE = {Op.ADD: 7, Op.SUB: 7, Op.MUL: 5, Op.DIV: 12, Op.SQRT: 12}
_FUNCTION = 120
"""Approximate numbers of additional operations in pairs: of instructions; of elementary functions.
"""
_POWERS = (0, 1, 2, 3)  # powers of the cost; later the one that was cheapest at first


class AccuracyError(ReportedError, ValueError):
    """A requested accuracy cannot be reached."""


@dataclass(frozen=True)
class PrecisionChoice:
    """A function's program in the mixed tier, with its bounds and costs."""

    program: Program
    pairs: Program  # all in pairs, for comparison
    mixture: Mixture
    worst: tuple[float, ...]  # largest certified bound of each component of the results; or, over
    # stated ranges, the proved one

    @property
    def paired(self) -> int:
        """The number of instructions of the plain program that are in pairs."""
        return len(self.mixture.paired)


@cache
def chosen(program: Program, accuracy: Accuracy) -> PrecisionChoice:
    """Chooses the mixture for a plain program, with the formulas for twice the digits.  Raises
    AccuracyError if not even pairs reach the accuracy."""
    search = _Search(program.fine or program, accuracy)
    return search.proved(accuracy.stated) if accuracy.stated else search.choice()


class _Search:
    def __init__(self, program: Program, accuracy: Accuracy) -> None:
        self.program, self.accuracy = program, accuracy
        self.tolerances = np.array(accuracy.tolerances)
        self.pairs = in_pairs(program, SINGLE)
        self.states = States(accuracy, in_double(program))
        self.sensitive: dict[Place, float] = {}
        self.powers: tuple[int, ...] = _POWERS

    def choice(self) -> PrecisionChoice:
        """Chooses mixtures, and draws and searches new states, until the bounds are met there and
        at the first states."""
        first = self.states.drawn(DRAWN)
        units = self._units(self.program, first)
        self._rank(first.at(np.arange(_RANKED)))
        self._rank(first.at(_worst(units)))
        self.sample = first.at(np.argsort(-units.max(axis=0), kind="stable")[:SEARCHED])
        for sizes in (results(self.program, self.tolerances), self._errors(self.program)):
            self._add(self._searched(sizes))
        room = ROOM
        while True:
            mixture = self._cheapest(room) if room > _LEAST else self._mixture(-1, 0)
            result = mixed(self.program, mixture) if room > _LEAST else self.pairs
            others = self._others(result)
            if self._units(result, others).max() <= 1:
                worst = self.sample.joined(first).joined(others).certified(result).max(axis=1)
                return PrecisionChoice(result, self.pairs, mixture,
                                       tuple(worst.tolist()))
            self._add(others.at(_worst(self._units(result, others))))
            room *= room

    def proved(self, ranges: ArgumentRanges) -> PrecisionChoice:
        """Chooses the cheapest mixture whose errors are proved for all arguments in these ranges;
        states only rank instructions."""
        self._refuse_bounds([x.error for x in of_mixture(self.program, ranges, SINGLE)])
        first = self.states.drawn(SEARCHED)
        self._rank(first.at(np.arange(_RANKED)))
        self._rank(first.at(_worst(self._units(self.program, first))))

        def meets(mixture: Mixture) -> bool:
            bounds = of_mixture(self.program, ranges, SINGLE, mixture)
            return all(x.error <= tolerance for x, tolerance in zip(
                bounds, self.accuracy.tolerances, strict=True))

        mixture = min((self._largest(power, meets) for power in _POWERS),
                      key=lambda x: operations(mixed(self.program, x)))
        bounds = of_mixture(self.program, ranges, SINGLE, mixture)
        return PrecisionChoice(mixed(self.program, mixture), self.pairs, mixture,
                               tuple(x.error for x in bounds))

    def _others(self, program: Program) -> StateSample:
        """Yields new states, random ones and those of searches, until bounds exceed the request at
        one."""
        given = self.states.drawn(DRAWN)
        for _ in range(SEARCHES):
            if self._units(program, given).max() > 1:
                break
            given = given.joined(self._searched(self._errors(program)))
        return given

    def _errors(self, program: Program) -> Sizes:
        return errors(program, self.program, self.tolerances)

    def _searched(self, sizes: Sizes) -> StateSample:
        """States where these errors are large, found by a search."""
        return self.states.sample(climbed(self.states, sizes))

    def _add(self, hard: StateSample) -> None:
        """Adds these states to those at which the mixture must reach the requested accuracy."""
        self._refuse(hard)
        self._rank(hard.at(_worst(self._units(self.program, hard))))
        self.sample = self.sample.joined(hard)

    def _units(self, program: Program, sample: StateSample) -> Array:
        """Certified bounds in units of the requested accuracy."""
        units: Array = sample.certified(program) / self.tolerances[:, None]
        return units

    def _rank(self, sample: StateSample) -> None:
        """Includes these states in the sensitivities."""
        for place, size in sensitivities(self.program, double(sample.given),
                                         self.accuracy.tolerances).items():
            self.sensitive[place] = max(size, self.sensitive.get(place, 0))

    def _cheapest(self, room: float) -> Mixture:
        """The cheapest mixture whose bounds at the sample use at most this fraction of the error
        budget left by all-pairs evaluation."""
        least = float(self._units(self.pairs, self.sample).max())
        aim = least + room * (1 - least)
        def meets(mixture: Mixture) -> bool:
            return bool(self._units(mixed(self.program, mixture), self.sample).max() <= aim)

        results = {power: self._largest(power, meets) for power in self.powers}
        cheapest = min(results, key=lambda x: operations(mixed(self.program, results[x])))
        self.powers = cheapest,
        return results[cheapest]

    def _largest(self, power: int, meets: Callable[[Mixture], bool]) -> Mixture:
        """Returns the mixture of the largest threshold that meets the aim; all in pairs if there is
        none."""
        thresholds = sorted({-1.0, *self.sensitive.values()})
        low, high = 0, len(thresholds) - 1
        while low < high:
            middle = (low + high + 1) // 2
            if meets(self._mixture(thresholds[middle], power)):
                low = middle
            else:
                high = middle - 1
        return self._mixture(thresholds[low], power)

    def _mixture(self, threshold: float, power: int) -> Mixture:
        """The mixture in which values more sensitive than the threshold are pairs."""
        paired: set[object] = set()
        kept: set[Place] = set()
        for step in self.program.instructions:
            operands = [(step.name, k) for k in range(len(step.operands))
                        if self.sensitive.get((step.name, k), -1) > threshold]
            weight = prod([sqrt(_MORE.get(step.op, _FUNCTION) / _MORE[Op.ADD])] * power)
            own = self.sensitive.get((step.name, OWN), -1) > threshold * weight
            if own or operands and step.op not in CARRYING:
                paired.add(_together(step))
            kept.update(operands)
        names = {step.name for step in self.program.instructions if _together(step) in paired}
        return Mixture(frozenset(names), frozenset(kept))

    def _refuse(self, sample: StateSample) -> None:
        """Raises AccuracyError if pairs do not reach the requested accuracy at these states."""
        self._refuse_bounds(sample.certified(self.pairs).max(axis=1))

    def _refuse_bounds(self, bounds: Iterable[float]) -> None:
        """Raises AccuracyError if these bounds of pairs exceed the requested accuracy."""
        for (name, number), bound, tolerance in zip(
                self.accuracy.components, bounds, self.accuracy.tolerances, strict=True):
            if bound > tolerance:
                words = f"err by up to {two_digits_up(bound)}" if np.isfinite(bound) else \
                    "have no certified bound at some states"
                raise AccuracyError(
                    f"accuracy of {self.program.name}: {tolerance:g} is requested for {name}; even "
                    f"pairs of floats, rounded at the end, {words} in component {number}")


def operations(program: Program) -> int:
    """Counts operations of all kinds, including those of elementary functions."""
    return sum(whole_counts(program, SINGLE).values())


def _together(step: Instruction) -> object:
    """Returns a key that is the same for a sine and a cosine of one angle, which are computed
    together."""
    return step.operands if step.op in (Op.SIN, Op.COS) else step.name


def _worst(units: Array) -> Array:
    """The states of the largest bounds of each component."""
    order = np.argsort(-units, axis=1, kind="stable")
    return np.unique(order[:, :_WORST])
