"""Derivatives of operations, computed in double and single precision, are right: the first and the
second, by tangents and adjoints, also where intermediate results are large, and about the identity.

Truth are differences of the operation at 420 digits, over steps of 1e-25 and 1e-22, whose errors
are about 1e-44 times the third derivative; where both disagree there is none.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import mpmath
import numpy as np
import pytest
from mpmath import mpf

import coscrew
from coscrew_codegen.algebra.lowering.programs import program_of, smooth_program
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program import Op
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.values.quantity import ANY, NEAR_ROTATION, NONZERO, ROTATION, Argument
from coscrew_codegen.reports.kernels.inputs import benign
from coscrew_codegen.runtime.arrays.array_function import ArrayFunction
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary
from tests.support.each import each_precision
from tests.support.scenes.evaluation import evaluator, without_errors

CURVED = tuple(op for op in OPERATIONS if program_of(op).counts.keys() & {
    Op.DIV, Op.SQRT, Op.ATAN2, Op.SIN, Op.EXP, Op.TANH})
ALLOWED = 1000
"""Units of rounding that the largest component may err by.  Here less than 200 were found; 781 for
an angle between nearly parallel vectors."""
STEPS = mpf("1e-25"), mpf("1e-22")
ANGLES = (1e-12, 1e-8, 1e-5, 1e-3, 0.03, 0.3, 0.49, 0.51, 1, 2, 3)
SCALES = {DOUBLE.name: (1, 1e-3, 1e3, 1e-9, 1e30, 1e-30),
          "single": (1, 1e-2, 1e2, 1e-3, 1e3)}
Parts = Sequence[np.ndarray]
Exact = list[mpf]


@pytest.fixture(autouse=True)
def many_digits() -> Iterator[None]:
    with mpmath.workdps(420):
        yield


@dataclass(frozen=True)
class Truth:
    """The operation at many digits, with the constants of a precision."""

    value: Callable[[Sequence[Exact]], Exact]

    @classmethod
    def of(cls, operation: Operation, precision: Precision) -> "Truth":
        compute = evaluator(program_of(operation), without_errors(precision.name))
        return cls(lambda x: list(map(mpf, compute(x))))

    def slopes(self, x: Parts, d: Parts, e: Parts) -> list[tuple[Exact, mpf]] | None:
        """The first derivative along d, and the second along d and e, each with the size of the
        largest along d or e, since a sum may cancel by chance; None where steps disagree."""
        def at(s: mpf, t: mpf) -> Exact:
            return self.value([[mpf(float(a)) + s * mpf(float(b)) + t * mpf(float(c))
                                for a, b, c in zip(*part, strict=True)]
                               for part in zip(x, d, e, strict=True)])

        here = at(mpf(0), mpf(0))

        def over(h: mpf) -> list[Exact]:
            ends = [(at(h, 0), at(-h, 0)), (at(0, h), at(0, -h))]
            firsts = [[(a - b) / (2 * h) for a, b in zip(*pair, strict=True)] for pair in ends]
            seconds = [[(a + b - 2 * c) / h**2 for a, b, c in zip(*pair, here, strict=True)]
                       for pair in ends]
            both = [(a - b - c + d) / (4 * h**2) for a, b, c, d in zip(
                at(h, h), at(h, -h), at(-h, h), at(-h, -h), strict=True)]
            return [*firsts, both, *seconds]

        got, coarse = map(over, STEPS)
        for a, b in zip(got, coarse, strict=True):
            if not all(abs(p - q) <= 1e-15 * largest(a) for p, q in zip(a, b, strict=True)):
                return None
        return [(got[0], max(map(largest, got[:2]))), (got[2], max(map(largest, got[2:])))]


def largest(values: Exact) -> mpf:
    return max(map(abs, values)) or mpf(10)**-400


def turned(argument: Argument, angle: float, rng: np.random.Generator) -> np.ndarray:
    """A rotation by this angle, or what holds one; of others, a fraction."""
    axis = rng.standard_normal(3)
    axis *= angle / np.linalg.norm(axis)
    shape = argument.quantity.shape
    if argument.quantity.name == "quaternion":
        return coscrew.quaternion_exp(axis)
    made = {(3, 3): lambda: coscrew.SO3_exp(axis), (3,): lambda: axis,
            (3, 4): lambda: np.hstack([coscrew.SO3_exp(axis), rng.standard_normal((3, 1))]),
            (6,): lambda: np.concatenate([rng.standard_normal(3), axis])}
    return made.get(shape, lambda: rng.uniform(0.1, 0.9, shape))()


def points(operation: Operation, precision: Precision, rng: np.random.Generator
           ) -> Iterator[list[np.ndarray]]:
    """Benign arguments, those without domain of several sizes; rotations by several angles."""
    ends = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    bounded = {Op.EXP, Op.TANH, Op.SIN} & program_of(operation).counts.keys()
    for scale in (1,) if bounded else SCALES[precision.name]:
        for row in benign(operation, precision, 2, 5):
            yield [x * (scale if a.domain in (ANY, NONZERO) else 1)
                   for x, a in zip(np.split(row, ends), operation.inputs, strict=True)]
    turning = [a.domain in (ROTATION, NEAR_ROTATION) if a.quantity.shape == (3, 3) else
               a.quantity.shape != (3,) or a.domain not in (ANY, NONZERO)
               for a in operation.inputs]
    for angle in ANGLES if all(turning) else ():
        yield [np.ravel(turned(a, angle, rng)) for a in operation.inputs]


@pytest.mark.parametrize("operation", CURVED, ids=lambda op: op.name)
@each_precision
def test_first_and_second_derivatives(operation: Operation, precision: Precision) -> None:
    made = ArrayFunction(operation.name, program_of(operation), smooth_program(operation))
    truth, rng = Truth.of(operation, precision), np.random.default_rng(5)
    real, compared = np.dtype(precision.numpy_type).type, 0

    def drawn(shapes: Sequence[tuple[int, ...]]) -> list[np.ndarray]:
        return [rng.standard_normal(shape).astype(real) for shape in shapes]

    def values(of: ArrayFunction, *given: np.ndarray) -> list[float]:
        with np.errstate(all="ignore"):
            results = of.printed(ArrayLibrary(np), precision)(*given, lead=())
        return [float(x) for y in results for x in np.ravel(y)]

    shapes = [shape for _, shape in made.inputs]
    for flat in points(operation, precision, rng):
        x = [a.astype(real).reshape(s) for a, s in zip(flat, shapes, strict=True)]
        d, e = drawn(shapes), drawn(shapes)
        wanted = truth.slopes(*(list(map(np.ravel, y)) for y in (x, d, e)))
        if wanted is None:
            continue
        compared += 1
        still, w = [np.zeros_like(y) for y in x], drawn(made.shapes)
        results = (values(made.tangent, *x, *d),
                   values(made.tangent.tangent, *x, *d, *e, *still))
        back = (values(made.adjoint, *x, *w),
                values(made.adjoint.tangent, *x, *w, *e, *map(np.zeros_like, w)))
        weights = [float(y) for z in w for y in np.ravel(z)]
        along = [float(y) for z in d for y in np.ravel(z)]
        for forward, reverse, (true, scale) in zip(results, back, wanted, strict=True):
            allowed = ALLOWED * float(precision.u) * scale
            for a, b in zip(forward, true, strict=True):
                assert abs(a - b) <= allowed, (operation.name, x, a, b)
            weighed = sum(a * b for a, b in zip(weights, true, strict=True))
            turned_back = sum(mpf(a) * b for a, b in zip(reverse, along, strict=True))
            assert abs(turned_back - weighed) <= allowed * max(1, *map(abs, weights))
    assert compared > 3
