"""Searches for the worst rounding error of a function within its stated ranges: random states,
states at corners, and climbing from the worst of these, with restarts; judged in 60 digits."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import mpmath
import numpy as np

from coscrew_codegen.accuracy.range_proofs import ResultBounds
from coscrew_codegen.program import Op
from coscrew_codegen.program.interpreter import by_operation, exactly, interpreter
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import SINGLE, Precision
from tests.support.scenes.tiers import components, flat, truths
from tests.support.truth.condition import ARRAYS

Given = list[np.ndarray]
LONG = by_operation(lambda x: np.longdouble(str(x.double.numerator)) / np.longdouble(
    str(x.double.denominator)), {**exactly(np), Op.SELECT: lambda *x: np.where(*x)})
BEST = 64  # states from which a round climbs


@dataclass(frozen=True)
class Worst:
    """A component's largest error, in parts of its bound, and its state."""

    place: int
    error: float
    part: float
    state: tuple[np.ndarray, ...]


@dataclass(frozen=True)
class Search:
    """A search for states at which a function errs most in a precision, beside its bounds;
    `kernels` are those of a tier."""

    kernels: object
    function: FunctionProgram
    precision: Precision
    bounds: ResultBounds

    def states(self, count: int, seed: int, corners: float = 1 / 3) -> Given:
        """States in the ranges; each number is at an end with probability `corners`."""
        draw, ranges = np.random.default_rng(seed), self.function.ranges
        assert ranges
        results = []
        for each in ranges.intervals:
            low, high = (np.array(x) for x in zip(*np.clip(each, -10, 10), strict=True))
            ends = np.where(draw.random((count, len(low))) < 0.5, low, high)
            results.append(np.where(draw.random((count, len(low))) < corners, ends,
                                    draw.uniform(low, high, (count, len(low)))))
        for places in ranges.quaternions:
            part = np.array(draw.normal(size=(count, 4)))
            part *= np.sqrt(draw.uniform(0.9991, 1.0009, (count, 1))) / np.linalg.norm(
                part, axis=1, keepdims=True)
            results[places[0].argument][:, [x.index for x in places]] = part
        return self._within(results)

    def near(self, given: Given, seed: int) -> Given:
        """States near these: each number moved with probability 1/2, by 1e-7 to 0.3 of its range;
        quaternions keep their norm."""
        draw, ranges = np.random.default_rng(seed), self.function.ranges
        assert ranges
        results = []
        for x, each in zip(given, ranges.intervals, strict=True):
            low, high = (np.array(y) for y in zip(*np.clip(each, -10, 10), strict=True))
            step = draw.choice((0, 1), x.shape) * draw.uniform(-1, 1, x.shape) * (high - low)
            results.append(np.clip(x + step * 10.0**draw.uniform(-7, -0.5, (len(x), 1)), low, high))
        for places in ranges.quaternions:
            argument, at = places[0].argument, [x.index for x in places]
            old, new = given[argument][:, at], results[argument][:, at]
            results[argument][:, at] = new * np.linalg.norm(old, axis=1, keepdims=True) / \
                np.linalg.norm(new, axis=1, keepdims=True)
        return self._within(results)

    def _within(self, given: Given) -> Given:
        """Numbers of the precision, rounded towards zero where that leads into the ranges."""
        assert self.function.ranges
        results = []
        kind = getattr(np, self.precision.numpy_type)
        for x, each in zip(given, self.function.ranges.intervals, strict=True):
            low, high = (np.array(y) for y in zip(*each, strict=True))
            near = x.astype(kind)
            near = np.where(near > high, np.nextafter(near, kind(-np.inf)), near)
            results.append(np.where(near < low, np.nextafter(near, kind(np.inf)), near))
        return results

    def parts(self, given: Given) -> np.ndarray:
        """Errors in parts of their bounds, a component a row: against twice the digits."""
        function, wide = self.function, self.precision == SINGLE
        got = self.computed(given)
        rows = components(function.program, given)
        if not wide:
            rows = [[x.astype(np.longdouble) for x in each] for each in rows]
        true = interpreter(function.program, ARRAYS if wide else LONG)(rows)
        error = abs(got.T - np.stack([np.broadcast_to(x, len(got)) for x in true])).astype(float)
        bound = np.array([x.error for x in self.bounds])[:, None]
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where((bound > 0) & np.isfinite(bound), error / bound, 0.0)

    def computed(self, given: Given) -> np.ndarray:
        """The function's results, a state a row."""
        function = getattr(getattr(self.kernels, self.precision.name), self.function.name)
        return flat(function(*(x.reshape(len(x), *a.quantity.shape) for x, a in zip(
            given, self.function.program.inputs, strict=True))), len(given[0]))

    def climb(self, states: int, rounds: int, seed: int) -> Iterator[Worst]:
        """The worst state of every component after climbing from the worst of random states."""
        given = [np.concatenate(x) for x in zip(
            self.states(states, seed), self.states(states, seed + 1, 1.0), strict=True)]
        part = self.parts(given)
        for n in range(rounds):
            best = np.unique(np.concatenate((np.argsort(-part.max(axis=0))[:BEST],
                                             part.argmax(axis=1))))
            near = self.near([np.repeat(x[best], max(1, states // len(best)), axis=0)
                              for x in given], seed + n)
            more = self.parts(near)
            given = [np.concatenate([x[best], y]) for x, y in zip(given, near, strict=True)]
            part = np.concatenate([part[:, best], more], axis=1)
        for place, at in enumerate(part.argmax(axis=1)):
            yield self.judged(place, tuple(x[at] for x in given))

    def judged(self, place: int, state: Sequence[np.ndarray]) -> Worst:
        """The error of a component at a state, in 60 digits."""
        given = [np.asarray(x)[None] for x in state]
        value = self.computed(given)[0, place]
        with mpmath.workdps(60):
            error = float(abs(truths(self.function.program, given)[0][place] -
                              mpmath.mpf(float(value))))
        bound = self.bounds[place].error
        return Worst(place, error, error / bound if bound else float(error > 0), tuple(state))
