"""States, truths and errors of a scene's functions in a tier."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import mpmath
import numpy as np

from coscrew_codegen.program import Program
from coscrew_codegen.program.interpreter import interpreter
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import Precision
from tests.support.scenes.evaluation import MULTIPRECISE
from tests.support.truth.condition import conditions

DIGITS = 60


def states(scene: SceneFunctions, function: FunctionProgram, count: int, precision: Precision
           ) -> list[np.ndarray]:
    """Random arguments: parameters near their values, quaternions of norm 1, t and h positive."""
    draw = np.random.default_rng(len(function.name))
    results = []
    for a in function.program.inputs:
        x = draw.uniform(-2, 2, (count, *a.quantity.shape))
        if a.name == "q":
            for c in scene.coordinates:
                if c.kind in ("free", "spherical"):
                    part = x[:, c.q.stop - 4:c.q.stop]
                    part /= np.linalg.norm(part, axis=1)[:, None]
        if a.name == "p":
            x = np.array([value for _, value in scene.parameters]) * (1 + abs(x) / 8)
        results.append((abs(x) if a.name in ("t", "h") else x).astype(precision.numpy_type))
    return results


def components(program: Program, given: Sequence[np.ndarray]) -> list[list[np.ndarray]]:
    """The components of each argument, in double, as arrays of states."""
    return [[np.asarray(x, float).reshape(len(x), -1)[:, k] for k in range(a.quantity.size)]
            for a, x in zip(program.inputs, given, strict=True)]


@dataclass(frozen=True)
class Result:
    """A component of a function's results at a state."""

    place: int
    value: float
    true: mpmath.mpf
    condition: float

    def ulps(self, precision: Precision) -> float:
        """|value - true| in units of the last digit of the true result in a precision."""
        kind = getattr(np, precision.numpy_type)
        with mpmath.workdps(DIGITS):
            unit = mpmath.mpf(float(np.spacing(abs(kind(float(self.true))))))
            return float(abs(mpmath.mpf(float(self.value)) - self.true) / unit)


def truths(program: Program, given: Sequence[np.ndarray]) -> list[list[mpmath.mpf]]:
    """The plain program's results in 60 digits, by state."""
    rows = components(program, given)
    with mpmath.workdps(DIGITS):
        run = interpreter(program, MULTIPRECISE.arithmetic)
        return [[mpmath.mpf(x) for x in run(
            [[mpmath.mpf(float(x[k])) for x in parts] for parts in rows])]
            for k in range(len(given[0]))]


def flat(result: object, count: int) -> np.ndarray:
    """All components of one result or of several, a state a row."""
    parts = result if isinstance(result, tuple) else (result,)
    return np.concatenate([np.asarray(x).reshape(count, -1) for x in parts], axis=1)


def results(program: Program, given: Sequence[np.ndarray], result: object) -> Iterator[Result]:
    """Every component of the results at these states, beside the truth and its condition."""
    count = len(given[0])
    numbers, true = flat(result, count), truths(program, given)
    size = [np.broadcast_to(x, count) for x in conditions(program, components(program, given))]
    for k in range(count):
        for place in range(numbers.shape[1]):
            yield Result(place, numbers[k, place], true[k][place], float(size[place][k]))
