"""Attacks on the stated bounds of a plain function's rounding errors: the worst error found between
the limits, at random states and at states near the worst ones, is compared with the bound."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from math import prod

import numpy as np

from coscrew_codegen.dynamics.derivation import tree_for
from coscrew_codegen.program.interpreter import interpreter
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.tiers import components, flat, truths
from tests.support.truth.condition import ARRAYS

Given = Sequence[np.ndarray]
_BOUND = re.compile(r"(\w+) by at most ([^;,]+)")
_FIGURE = re.compile(r"(\S+) in (\w+)")


def stated(function: FunctionProgram) -> dict[tuple[str, str], float]:
    """The bounds in the statement, by output and precision."""
    return {(name, precision): float(figure)
            for name, words in _BOUND.findall(function.rounding)
            for figure, precision in _FIGURE.findall(words)}


@dataclass(frozen=True)
class Box:
    """The states that a statement is about."""

    scene: Scene

    def random(self, function: FunctionProgram, count: int, seed: int) -> Given:
        """Arguments between the limits, a third of them at one; angles without limits up to 10."""
        draw = np.random.default_rng(seed)
        results = []
        for a in function.program.inputs:
            low, high = self._ends(a.name)
            x = draw.uniform(low, high, (count, len(low)))
            ends = draw.random(x.shape)
            x = np.where(ends < 1 / 6, low, np.where(ends > 5 / 6, high, x))
            results.append(self._near(x, a.name))
        return results

    def around(self, function: FunctionProgram, given: Given, seed: int) -> Given:
        """Arguments near these: each number moved with probability 1/2, by 1e-7 to 0.1."""
        draw = np.random.default_rng(seed)
        return [self._near(x + draw.choice((0, 1), x.shape) * draw.uniform(-1, 1, x.shape)
                           * 10.0**draw.uniform(-7, -1, (len(x), 1)), a.name)
                for a, x in zip(function.program.inputs, given, strict=True)]

    def _near(self, x: np.ndarray, name: str) -> np.ndarray:
        """Numbers of single precision within the limits."""
        near = x.astype(np.float32)
        low, high = (np.asarray(end) for end in self._ends(name))
        near = np.where(near > high, np.nextafter(high.astype(np.float32), np.float32(-np.inf)),
                        near)
        return np.where(near < low, np.nextafter(low.astype(np.float32), np.float32(np.inf)), near)

    def _ends(self, name: str) -> tuple[list[float], list[float]]:
        if name == "p":
            values = [float(np.float32(p.value)) for p in self.scene.parameters]
            return [0.0] * len(values), values
        low, high = zip(*(_limits(x.joint, name) for x in tree_for(self.scene).links
                          if x.driver is None), strict=True)
        return list(low), list(high)


def _limits(joint: Joint, name: str) -> tuple[float, float]:
    speed = joint.velocity
    low, high = (joint.lower, joint.upper) if name == "q" else (speed and -speed, speed)
    return (-10.0, 10.0) if low is None or high is None else (float(low), float(high))


def worst_found(kernels: Kernels, function: FunctionProgram, output: str, states: int, rounds: int
                ) -> float:
    """The largest error of an output in single precision, against double with its decimals."""
    assert kernels.scene
    box, exact = Box(kernels.scene), interpreter(function.program, ARRAYS)
    plain = getattr(kernels.single, function.name)

    def errors(given: Given) -> np.ndarray:
        true = np.stack(np.broadcast_arrays(*exact(components(function.program, given))), axis=-1)
        return abs(flat(plain(*given), len(given[0])) - true)[:, _places(function, output)].max(1)

    given = box.random(function, states, 1)
    result = errors(given)
    for n in range(rounds):
        best = np.argsort(-result)[:states // 8]
        near = box.around(function, [np.repeat(x[best], 8, axis=0) for x in given], n)
        more = errors(near)
        given = [np.concatenate([x[best], y]) for x, y in zip(given, near, strict=True)]
        result = np.concatenate([result[best], more])
    return float(result.max())


def worst_exactly(kernels: Kernels, function: FunctionProgram, output: str, states: int,
                  precision: Precision) -> float:
    """The largest error of an output at random states, against 60 digits."""
    assert kernels.scene
    given = [x.astype(precision.numpy_type) for x in Box(kernels.scene).random(
        function, states, 2)]
    result = flat(getattr(getattr(kernels, precision.name), function.name)(*given), states)
    true = truths(function.program, given)
    return max(float(abs(true[k][place] - float(result[k, place])))
               for k in range(states)
               for place in range(result.shape[1])[_places(function, output)])


def _places(function: FunctionProgram, output: str) -> slice:
    start = 0
    for a in function.program.outputs:
        stop = start + prod(a.quantity.shape)
        if a.name == output:
            return slice(start, stop)
        start = stop
    raise KeyError(output)
