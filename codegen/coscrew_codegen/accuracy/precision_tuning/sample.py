"""States within the ranges of a function's inputs, random ones or near others, with certified
results: the same numbers on every machine."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from random import Random

import numpy as np

from coscrew_codegen.accuracy.precision_tuning.array_evaluation import Array, Given, evaluator
from coscrew_codegen.accuracy.tiers.certified_wide import LEAST, ROUNDED
from coscrew_codegen.program import Program
from coscrew_codegen.program.scene_functions import Accuracy
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision

_AT_ONCE = 4000
_MOVED, _SMALLEST = 0.25, 20  # of a state's numbers; steps are between 1 and 2^-20 of a range
_ROUNDED, _LEAST = float(ROUNDED.double), float(LEAST.double)


@dataclass(frozen=True, eq=False)
class StateSample:
    """States, as components of each input, and a function's results there in double precision, with
    their bounds; one row for each component of the results."""

    given: Given
    results: Array
    bounds: Array

    @property
    def size(self) -> int:
        """Number of states."""
        return int(self.results.shape[1])

    def certified(self, program: Program) -> Array:
        """Bounds of the errors of another program's results in single precision, as in the
        certified tier: |x̂ - w| + B, rounded up; infinite where there is no bound."""
        result = in_rows(program, SINGLE)(self.given).astype(float)
        with np.errstate(all="ignore"):
            total = (np.absolute(result - self.results) + self.bounds) * _ROUNDED + _LEAST
        return np.where(np.isnan(total), np.inf, total)

    def at(self, chosen: Array) -> "StateSample":
        """Returns the chosen states."""
        return StateSample(at(self.given, chosen), self.results[:, chosen], self.bounds[:, chosen])

    def joined(self, other: "StateSample") -> "StateSample":
        """The states of both."""
        return StateSample(joined(self.given, other.given), *(np.concatenate(x, axis=1) for x in (
            (self.results, other.results), (self.bounds, other.bounds))))


def at(given: Given, chosen: Array) -> Given:
    """The states with these indices."""
    return [[x[chosen] for x in each] for each in given]


def joined(given: Given, other: Given) -> Given:
    """The states of both."""
    return [[np.concatenate(x) for x in zip(*each, strict=True)]
            for each in zip(given, other, strict=True)]


def in_double(given: Given) -> Given:
    """The states in double precision."""
    return [[x.astype(float) for x in each] for each in given]


def in_rows(program: Program, precision: Precision) -> Callable[[Given], Array]:
    """Computes the components of the program's results at any states, a row each."""
    run = evaluator(program, precision)

    def results(given: Given) -> Array:
        count, parts = len(given[0][0]), []
        for first in range(0, count, _AT_ONCE):
            some = [[x[first:first + _AT_ONCE] for x in each] for each in given]
            room = np.zeros(len(some[0][0]), precision.numpy_type)
            parts.append(np.stack([x + room for x in run(some)]))
        return np.concatenate(parts, axis=1)

    return results


class States:
    """A sequence of states for a requested accuracy; `certified` gives a function's results and
    bounds."""

    def __init__(self, accuracy: Accuracy, certified: Program) -> None:
        self._accuracy, self._certified = accuracy, in_rows(certified, DOUBLE)
        self._random = Random(1)

    def drawn(self, count: int) -> StateSample:
        """The next states, as numbers."""
        return self.sample(self.numbers(count))

    def sample(self, given: Given) -> StateSample:
        """Returns the sample of these states, with certified results."""
        result = self._certified(in_double(given))
        half = len(result) // 2
        return StateSample(given, result[:half], result[half:])

    def numbers(self, count: int) -> Given:
        """The next states: every number evenly distributed, quaternions of norm 1, all numbers of
        single precision."""
        return self._single([low + (high - low) * self._uniform(count) for low, high in ranges]
                            for ranges in self._accuracy.ranges)

    def near(self, given: Given) -> Given:
        """A state near each of these, within the ranges: a step changes some of its numbers."""
        size = np.ldexp(1.0, -(_SMALLEST * self._uniform(len(given[0][0]))).astype(int))
        return self._single(
            [self._moved(x.astype(float), size, *range_)
             for x, range_ in zip(each, ranges, strict=True)]
            for each, ranges in zip(given, self._accuracy.ranges, strict=True))

    def _moved(self, x: Array, size: Array, low: float, high: float) -> Array:
        if low == high:
            return x
        share = self._uniform(len(x)) / _MOVED
        there: Array = np.clip(x + (high - low) * size * (2 * share - 1), low, high)
        return np.where(share < 1, there, x)

    def _uniform(self, count: int) -> Array:
        uniform = self._random.random  # the method whose random numbers never change
        return np.array([uniform() for _ in range(count)])

    def _single(self, results: Iterable[list[Array]]) -> Given:
        """Rounds to single precision, with quaternions of norm 1."""
        given = list(results)
        for argument, places in self._accuracy.quaternions:
            quaternion = given[argument][places.start:places.stop]
            norm = np.sqrt(sum(x * x for x in quaternion))
            given[argument][places.start:places.stop] = [x / norm for x in quaternion]
        return [[x.astype(np.float32) for x in each] for each in given]
