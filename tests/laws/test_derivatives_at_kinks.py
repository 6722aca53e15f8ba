"""Derivatives are right where differentiating formulas gives NaN: lengths of zero, exponentials and
logarithms at the identity, angles of π, choices whose other option is infinite.

Truth at the identity is the definition: exp' is the generator, log' its inverse.  Elsewhere it is
that log undoes exp, and differences at 50 digits.
"""

import itertools
from collections.abc import Iterator, Sequence

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.algebra.lowering.programs import program_of, smooth_program
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.algebra.recording.derivatives import adjoint, tangent
from coscrew_codegen.program import Op
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.program.values.quantity import (
    DISPLACEMENT,
    NEAR_ROTATION,
    NONZERO,
    NONZERO_MATRIX,
    ORDINARY,
    ROTATION,
    SINE_COSINE,
    UNIT_VECTOR,
    Argument,
)
from coscrew_codegen.reports.kernels.inputs import benign
from coscrew_codegen.runtime.arrays.array_function import ArrayFunction
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary
from tests.support.scenes.evaluation import evaluator, without_errors

CLOSE = mpf(10)**-24
MULTIPRECISE = without_errors("double")
NAMED = {operation.name: operation for operation in OPERATIONS}
SERIES = mpf(2)**-48  # series end below u / 4 of a function; a derivative has 26 times that at most


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def exact(*values: object) -> list[mpf]:
    return [mpf(str(x)) for x in values]


def along(name: str, x: Sequence[object], d: Sequence[object]) -> list[mpf]:
    """The derivative of an operation of one argument at x along d; by tangent and adjoint alike."""
    program = smooth_program(NAMED[name])
    result = evaluator(tangent(program), MULTIPRECISE)([exact(*x), exact(*d)])
    slopes = list(map(MULTIPRECISE.number, result[len(program.results):]))
    back = evaluator(adjoint(program), MULTIPRECISE)
    sizes = [a.quantity.size for a in program.outputs]
    for k, slope in enumerate(slopes):
        weights = [mpf(n == k) for n in range(len(slopes))]
        ends = list(itertools.accumulate(sizes))
        split = [weights[end - size:end] for size, end in zip(sizes, ends, strict=True)]
        gradient = back([exact(*x), *split])[len(slopes):]
        assert abs(sum(map(mpmath.fmul, exact(*d), map(MULTIPRECISE.number, gradient)))
                   - slope) <= CLOSE
    return slopes


def cross(w: Sequence[object]) -> list[object]:
    """w~, row by row."""
    x, y, z = w
    return [0, -z, y, z, 0, -x, -y, x, 0]


W, V = [mpf(2), mpf(-3), mpf(5)], [mpf(7), mpf(11), mpf(-13)]
ZERO, ONE = [0] * 3, [1, 0, 0, 0, 1, 0, 0, 0, 1]


def moving(R: Sequence[object], t: Sequence[object]) -> list[object]:
    """[R | t], row by row."""
    return [*R[:3], t[0], *R[3:6], t[1], *R[6:], t[2]]


@pytest.mark.parametrize("name, x, d, wanted", (
    ("SO3_exp", ZERO, W, cross(W)), ("SO3_log", ONE, cross(W), W),
    ("SE3_exp", [*ZERO, *ZERO], [*V, *W], moving(cross(W), V)),
    ("SE3_log", moving(ONE, ZERO), moving(cross(W), V), [*V, *W]),
    ("quaternion_exp", ZERO, W, [w / 2 for w in W] + [0]),
    ("quaternion_log", [*ZERO, 1], [*W, 0], [2 * w for w in W]),
    ("quaternion_log", [*ZERO, -4], [*W, 3], [-w / 2 for w in W]),
    ("SO3_leftJacobian", ZERO, W, [w / 2 for w in cross(W)]),
    ("SO3_leftJacobianInverse", ZERO, W, [-w / 2 for w in cross(W)]),
    ("vec3_l2norm", ZERO, W, [0]), ("screw_norm", [*ZERO, *ZERO], [*V, *W], [0])), ids=str)
def test_at_the_identity(name: str, x: list, d: list, wanted: list) -> None:
    for result, value in zip(along(name, x, d), wanted, strict=True):
        assert abs(result - value) <= CLOSE * 100


@pytest.mark.parametrize("angle", ("1e-300", "1e-20", "1e-8", "0.7", "1", "2", "3",
                                   "3.14159265358979"))
def test_logarithms_undo_exponentials(angle: str) -> None:
    """d log(exp v) = dv, whatever dv, up to half a turn."""
    length = mpmath.norm(W)
    v = [mpf(angle) * w / length for w in W]
    exp, log = (evaluator(tangent(smooth_program(NAMED[name])), MULTIPRECISE)
                for name in ("SO3_exp", "SO3_log"))
    moved_by = [MULTIPRECISE.number(x) for x in exp([v, V])]
    results = [MULTIPRECISE.number(x) for x in log([moved_by[:9], moved_by[9:]])[3:]]
    far = 1 / max(mpmath.pi - mpf(angle), mpf("1e-13"))  # w of the quaternion is that small
    for x, y in zip(results, V, strict=True):
        assert abs(x - y) <= SERIES * mpmath.norm(V) * max(1, far)


@pytest.mark.parametrize("name", ("SO3_exp", "SO3_log", "quaternion_log", "SE3_log"))
def test_second_derivatives(name: str) -> None:
    """Tangents of tangents and of adjoints equal differences of the first."""
    program = smooth_program(NAMED[name])
    step = mpf(10)**-16
    R = [mpf(k) / 3 for k in (2, -1, 2, 2, 2, -1, -1, 2, 2)]
    x = {"SO3_log": R, "SO3_exp": W, "quaternion_log": exact(1, 2, 3, 4), "SE3_log": moving(R, V)
         }[name]
    d, e = ([mpf(k + 1) / n for k in range(len(x))] for n in (7, -3))
    for first, direction in ((tangent(program), d),
                             (adjoint(program), d[:len(program.results)] * 3)):
        direction = direction[:first.inputs[1].quantity.size]
        value, second = evaluator(first, MULTIPRECISE), evaluator(tangent(first), MULTIPRECISE)
        zero = [mpf(0)] * len(direction)
        result = second([x, direction, e, zero])[len(first.results):]
        ends = [value([[a + s * b for a, b in zip(x, e, strict=True)], direction])
                for s in (step, -step)]
        for y, a, b in zip(result, *ends, strict=True):
            a, b, y = map(MULTIPRECISE.number, (a, b, y))
            assert abs(y - (a - b) / (2 * step)) <= CLOSE * (1 + abs(y)) * 10**6


def special(argument: Argument) -> list[np.ndarray]:
    """Values of the domain at which something is zero, or a half turn."""
    shape, domain = argument.quantity.shape, argument.domain
    turned = np.diag([1.0, -1, -1])
    if domain in (ROTATION, NEAR_ROTATION):
        return [np.eye(3), turned]
    if domain == DISPLACEMENT:
        return [np.eye(3, 4), np.hstack([turned, [[1], [2], [3]]])]
    if domain == NONZERO_MATRIX:  # equal singular values, a reflection, a singular one
        return [np.eye(3), np.diag([2.0, 2, -1]), np.diag([1.0, 1, 0])]
    if argument.quantity.name == "quaternion":
        return [np.array([0, 0, 0, 1.0]), np.array([0, 1.0, 0, 0])]
    first = np.zeros(shape)
    first[(0,) * len(shape)] = 1
    if domain in (UNIT_VECTOR, SINE_COSINE):
        return [first]
    return [first, *([] if domain in (NONZERO, ORDINARY) else [np.zeros(shape)]),
            np.full(shape, 1e-5)]


UNDEFINED = ("axis_angle_from_quaternion", "axis_angle_from_mat3x3")
"""The axis of no rotation has no derivative: it may be infinite."""
KINKED = tuple(op for op in OPERATIONS if op.name not in UNDEFINED and program_of(op).counts.keys()
               & {Op.SELECT, Op.SQRT, Op.ATAN2})


@pytest.mark.parametrize("operation", KINKED, ids=lambda op: op.name)
def test_gradients_are_numbers_wherever_results_are(operation: Operation) -> None:
    made = ArrayFunction(operation.name, program_of(operation), smooth_program(operation))
    value, back = (x.printed(ArrayLibrary(np), DOUBLE) for x in (made, made.adjoint))
    with np.errstate(all="ignore"):
        for given in itertools.product(*map(special, operation.inputs)):
            if all(np.isfinite(y).all() for y in value(*given, lead=())):
                weights = [np.reshape(1.0 + np.arange(size), shape)
                           for size, shape in zip(made.sizes, made.shapes, strict=True)]
                for result in back(*given, *weights, lead=()):
                    assert np.isfinite(result).all(), (operation.name, given)


SMOOTH = tuple(op for op in OPERATIONS if program_of(op) != smooth_program(op))


@pytest.mark.parametrize("operation", SMOOTH, ids=lambda op: op.name)
def test_smooth_programs_are_the_same_functions(operation: Operation) -> None:
    """At many digits they differ by the truncation of series, also where each argument is special.
    """
    compute = [evaluator(p, MULTIPRECISE) for p in (program_of(operation),
                                                    smooth_program(operation))]
    rows = benign(operation, DOUBLE, 9, 3)
    ends = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    for given in (*(np.split(row, ends) for row in rows),
                  *itertools.product(*map(special, operation.inputs))):
        x = [[mpf(float(y)) for y in np.ravel(part)] for part in given]
        values = [list(map(MULTIPRECISE.number, f(x))) for f in compute]
        size = max((abs(y) for y in values[0] if mpmath.isfinite(y)), default=0)
        for a, b in zip(*values, strict=True):
            assert abs(a - b) <= mpf(2)**-60 * size or mpmath.isnan(a) and mpmath.isnan(b)
