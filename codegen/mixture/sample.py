"""States drawn within the ranges of a function's inputs, and what is certified there: the same
numbers on every machine."""

from collections.abc import Sequence
from dataclasses import dataclass
from random import Random

import numpy as np

from coscrew_codegen.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.mixture.arrays import Array, evaluated
from coscrew_codegen.program import Program
from coscrew_codegen.scene_functions import Accuracy
from coscrew_codegen.tiers.certified_wide import LEAST, ROUNDED

_AT_ONCE = 4000
_ROUNDED, _LEAST = float(ROUNDED.double), float(LEAST.double)


@dataclass(frozen=True, eq=False)
class Sample:
    """States, as components of each input, and a function's results there in double precision, with
    their bounds; a component of the results a row."""

    given: Sequence[Sequence[Array]]
    results: Array
    bounds: Array

    @property
    def size(self) -> int:
        """How many states."""
        return int(self.results.shape[1])

    def certified(self, program: Program) -> Array:
        """Bounds of the errors of another program's results in single precision, as those of the
        certified tier: |x̂ - w| + B, rounded up; infinite where there are none."""
        found = _evaluated(program, SINGLE, self.given).astype(float)
        with np.errstate(all="ignore"):
            total = (np.absolute(found - self.results) + self.bounds) * _ROUNDED + _LEAST
        return np.where(np.isnan(total), np.inf, total)

    def at(self, chosen: Array) -> "Sample":
        """These of the states."""
        return Sample(tuple([x[chosen] for x in each] for each in self.given),
                      self.results[:, chosen], self.bounds[:, chosen])

    def joined(self, other: "Sample") -> "Sample":
        """The states of both."""
        given = tuple([np.concatenate(x) for x in zip(*each, strict=True)]
                      for each in zip(self.given, other.given, strict=True))
        return Sample(given, *(np.concatenate(x, axis=1) for x in (
            (self.results, other.results), (self.bounds, other.bounds))))


def _evaluated(program: Program, precision: Precision, given: Sequence[Sequence[Array]]
               ) -> Array:
    """The components of the results, a row each."""
    count, parts = len(given[0][0]), []
    for first in range(0, count, _AT_ONCE):
        some = [[x[first:first + _AT_ONCE] for x in each] for each in given]
        room = np.zeros(len(some[0][0]), precision.numpy_type)
        parts.append(np.stack([x + room for x in evaluated(program, precision, some)]))
    return np.concatenate(parts, axis=1)


class States:
    """A sequence of states of an accuracy; `certified` gives a function's results and bounds."""

    def __init__(self, accuracy: Accuracy, certified: Program) -> None:
        self._accuracy, self._certified, self._random = accuracy, certified, Random(1)

    def drawn(self, count: int) -> Sample:
        """The next states: every number evenly distributed, quaternions of norm 1, all numbers of
        single precision."""
        given = [[x.astype(np.float32) for x in each] for each in self._numbers(count)]
        wide = [[x.astype(float) for x in each] for each in given]
        found = _evaluated(self._certified, DOUBLE, wide)
        half = len(found) // 2
        return Sample(given, found[:half], found[half:])

    def _numbers(self, count: int) -> list[list[Array]]:
        uniform = self._random.random  # the method whose numbers never change
        found = []
        for ranges in self._accuracy.ranges:
            parts = np.array([uniform() for _ in range(count * len(ranges))]).reshape(-1, count)
            found.append([low + (high - low) * x
                          for (low, high), x in zip(ranges, parts, strict=True)])
        for argument, places in self._accuracy.quaternions:
            quaternion = found[argument][places.start:places.stop]
            norm = np.sqrt(sum(x * x for x in quaternion))
            found[argument][places.start:places.stop] = [x / norm for x in quaternion]
        return found
