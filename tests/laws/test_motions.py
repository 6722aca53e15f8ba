"""Exponentials, logarithms, Jacobians, quaternions: as accurate as stated, for every rotation."""

from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest

import coscrew
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.algebra.operations.operation import Normwise
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, Precision
from tests.support.compiled.c_harness import COMPILERS, EXACT, call, harness
from tests.support.domains import angle
from tests.support.each import each_precision
from tests.support.limits import LARGEST_ANGLE
from tests.support.motion_inputs import axes, displacements, motions_of, rotation_vectors, rotations
from tests.support.truth.motion_errors import (
    Objects,
    as_arrays,
    errors,
    multiprecise,
    truth_of,
    unit,
)
from tests.support.truth.motions import DIGITS, TRUTHS, exponential_series, skew

ROWS = 120
MOTIONS = tuple(op for op in OPERATIONS if op.name in TRUTHS)
TABLE = {op.name: op for op in MOTIONS}
Arrays = tuple[np.ndarray, ...]
Evaluate = Callable[[Operation, Precision, Arrays], Arrays]

each_motion = pytest.mark.parametrize("operation", MOTIONS, ids=lambda op: op.name)


def tuple_of(result: np.ndarray | Arrays) -> Arrays:
    return result if isinstance(result, tuple) else (result,)


def gufunc(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
    assert coscrew.COMPILED
    return tuple_of(getattr(coscrew, operation.name)(*inputs))


def twin(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
    return tuple_of(getattr(getattr(coscrew, precision.name), operation.name)(*inputs))


@pytest.fixture(scope="session")
def c_kernels(tmp_path_factory: pytest.TempPathFactory) -> Evaluate:
    """Compiled C."""
    folder: Path = tmp_path_factory.mktemp("motions")
    library = harness(folder, COMPILERS[0], ("-O2", EXACT), "", MOTIONS)
    return lambda operation, precision, inputs: call(library, operation, precision, inputs)


@cache
def inputs_and_truths(operation: Operation,
                      precision: Precision) -> tuple[Arrays, list[list[list[Objects]]]]:
    inputs = motions_of(operation, precision, ROWS)
    rounding = 16 * unit(precision)
    return inputs, [truth_of(operation, tuple(map(multiprecise, row)), rounding)
                    for row in zip(*inputs, strict=True)]


@pytest.mark.parametrize("implementation", ["gufunc", "C", "twin"])
@each_precision
@each_motion
def test_errors_are_within_the_stated_bounds(operation: Operation, precision: Precision,
                                             implementation: str, c_kernels: Evaluate):
    """Rows with the gufunc's bits are judged once, as the gufunc's."""
    evaluate = {"gufunc": gufunc, "twin": twin, "C": c_kernels}[implementation]
    inputs, truths = inputs_and_truths(operation, precision)
    with np.errstate(all="ignore"):
        outputs = evaluate(operation, precision, inputs)
        judged = gufunc(operation, precision, inputs)
    own = [n for n in range(ROWS) if implementation == "gufunc" or any(
        x[n].tobytes() != y[n].tobytes() for x, y in zip(outputs, judged, strict=True))]
    check(operation, precision, [x[own] for x in inputs], [x[own] for x in outputs],
          [truths[n] for n in own], lambda part, row: 0)


def k_at(bound: Normwise, theta: float) -> float:
    """k + θ / per_angle."""
    return bound.k + theta / bound.per_angle if bound.per_angle else bound.k


def check(operation: Operation, precision: Precision, inputs: Sequence[np.ndarray],
          outputs: Sequence[np.ndarray], truths: list[list[list[Objects]]],
          more: Callable[[str, int], float]) -> None:
    """Every part's error is within the stated bound plus `more`, in u."""
    bounds, u = {b.part: b for b in operation.normwise}, unit(precision)
    with mp.workdps(DIGITS):
        for number, truth in enumerate(truths):
            given = [as_arrays(multiprecise(x[number]))[0] for x in inputs]
            results = [as_arrays(multiprecise(x[number]))[0] for x in outputs]
            for part, error in errors(operation, given, results, truth).items():
                numbers = [float(c) for x in given for c in np.ravel(x)]
                allowed = k_at(bounds[part], angle(operation, numbers)) + more(part, number)
                assert error <= allowed * u, (
                    f"{part}: {float(error / u):.3g} u at "
                    + "; ".join(" ".join(float(c).hex() for c in np.ravel(x)) for x in given))


@pytest.mark.parametrize("name", ["SO3_exp", "SO3_leftJacobian", "SO3_rightJacobian",
                                  "quaternion_exp", "SE3_exp"])
@each_precision
def test_angles_beyond_pi(name: str, precision: Precision):
    """The bound holds from π to the end of its domain; half of the angles are next to multiples of
    π/2, where J_l is nearly singular and translations nearly vanish."""
    operation, rng = TABLE[name], np.random.default_rng(1)
    (x,) = motions_of(operation, precision, 120)
    angles = np.exp(rng.uniform(np.log(np.pi), np.log(LARGEST_ANGLE[precision.name]), len(x)))
    angles[::3] = rng.uniform(np.pi, 20, len(angles[::3]))
    angles[::2] = np.rint(angles[::2] / (np.pi / 2)) * (np.pi / 2)
    x[:, -3:] = axes(np.random.default_rng(2), len(x)) * angles[:, None]
    truths = [truth_of(operation, (multiprecise(row),), mp.mpf(0)) for row in x]
    check(operation, precision, (x,), gufunc(operation, precision, (x,)), truths,
          lambda part, row: 0)


@each_precision
@pytest.mark.parametrize("name", ["SO3_exp", "SO3_leftJacobian", "quaternion_exp", "SE3_exp"])
def test_angles_beyond_the_domain(name: str, precision: Precision):
    """Rotations within 2^-14, whose angles have rounding errors: the first-order correction of θ is
    below 2^-7.  NaN where θ² overflows."""
    operation = TABLE[name]
    for size in (LARGEST_ANGLE[precision.name] * 100, 2.0**50):  # still rotations, of other angles
        x = np.zeros((1, operation.inputs[0].quantity.size), precision.numpy_type)
        x[0, -3:] = size, -size / 3, size / 7
        if name in ("SO3_exp", "quaternion_exp"):
            result = gufunc(operation, precision, (x,))[0].astype(float)
            R = result[0] if name == "SO3_exp" else coscrew.mat3x3_from_quaternion(result[0])
            assert np.abs(R @ R.T - np.eye(3)).max() <= 2.0**-14
            assert name == "SO3_exp" or abs(np.linalg.norm(result) - 1) <= 2.0**-15
    for size in np.finfo(precision.numpy_type).max / np.array([1, 8], precision.numpy_type):
        x = np.zeros((1, operation.inputs[0].quantity.size), precision.numpy_type)
        x[0, -2] = size
        for evaluate in (gufunc, twin):
            with np.errstate(all="ignore"):
                (result,) = evaluate(operation, precision, (x,))
            assert np.isnan(result).any(axis=tuple(range(1, result.ndim))).all()


# laws, to rounding


def close(a: np.ndarray, b: np.ndarray, bound: float) -> None:
    """|a - b| <= bound u of the largest component."""
    u = np.finfo(a.dtype).eps / 2
    lead = tuple(range(1, a.ndim))
    size = np.abs(b).max(axis=lead) if lead else np.abs(b)
    error = np.abs(a - b).max(axis=lead) if lead else np.abs(a - b)
    worst = np.argmax(error - bound * u * size)
    assert error[worst] <= bound * u * size[worst], (
        error[worst] / size[worst] / u, a[worst], b[worst])


@pytest.fixture(params=PRECISIONS, ids=lambda p: p.name)
def draw(request: pytest.FixtureRequest) -> Callable[[Callable], np.ndarray]:
    rng, kind = np.random.default_rng(5), request.param.numpy_type
    return lambda sample: sample(rng, 2000).astype(kind)


def test_logarithm_undoes_the_exponential(draw):
    """Up to the rounding errors of R: 5 u of its largest component, which change the angle by as
    much."""
    v = draw(rotation_vectors)
    v = v[np.linalg.norm(v.astype(float), axis=1) < 3]
    R = coscrew.SO3_exp(v)
    u, size = np.finfo(v.dtype).eps / 2, np.abs(v).max(axis=1)
    error = np.abs(coscrew.SO3_log(R) - v).max(axis=1)
    assert (error <= 4 * u * size + 10 * u).all()
    q = coscrew.quaternion_exp(v)
    close(coscrew.quaternion_log(q), v, 16)


def test_exponential_undoes_the_logarithm(draw):
    R = draw(rotations)
    close(coscrew.SO3_exp(coscrew.SO3_log(R)), R, 20)
    close(coscrew.mat3x3_from_quaternion(coscrew.quaternion_from_mat3x3(R)), R, 16)
    angle, axis = coscrew.axis_angle_from_mat3x3(R)
    assert (angle >= 0).all() and (angle <= angle.dtype.type(np.pi)).all()
    close(coscrew.mat3x3_from_axis_angle(axis, angle), R, 20)
    D = draw(displacements)
    back = coscrew.SE3_exp(coscrew.SE3_log(D))
    close(back[..., :3], D[..., :3], 20)
    close(back[..., 3], D[..., 3], 40)


def test_quaternions_multiply_as_their_rotations(draw):
    p, q = (coscrew.quaternion_exp(draw(rotation_vectors)) for _ in range(2))
    R = coscrew.mat3x3_from_quaternion
    close(R(coscrew.quaternion_product_qq(p, q)), coscrew.product_drdr(R(p), R(q)), 24)
    assert (R(-q) == R(q)).all()
    assert (coscrew.quaternion_log(-q) == coscrew.quaternion_log(q)).all()


def test_jacobians(draw):
    v = draw(rotation_vectors)
    left, inverse = coscrew.SO3_leftJacobian(v), coscrew.SO3_leftJacobianInverse(v)
    close(left @ inverse, np.broadcast_to(np.eye(3, dtype=v.dtype), left.shape), 24)
    assert (coscrew.SO3_rightJacobian(v) == coscrew.SO3_leftJacobian(-v)).all()
    assert (coscrew.SO3_rightJacobianInverse(v) == coscrew.SO3_leftJacobianInverse(-v)).all()


def hat(s: mp.matrix) -> mp.matrix:
    """v~ of a rotation vector, [[ω~, v], [0, 0]] of a screw."""
    if s.rows == 3:
        return skew(s)
    A = mp.zeros(4)
    A[0:3, 0:3], A[0:3, 3] = skew(s[3:6]), s[0:3]
    return A


@pytest.mark.parametrize("name, size", [("SO3_leftJacobianInverse", 3),
                                        ("SE3_leftJacobianInverse", 6)])
def test_jacobian_is_the_derivative(name: str, size: int):
    """exp (s + J_l^-1(s) δ)^ = exp δ^ exp s^ + O(δ²), in 60 digits except for the errors of J."""
    rng, delta = np.random.default_rng(8), mp.mpf(10)**-20
    s = np.hstack([rng.normal(size=(30, size - 3)), rotation_vectors(rng, 30).astype(float)])
    (bound,) = (b.k for b in TABLE[name].normwise)
    with mp.workdps(DIGITS):
        direction = mp.matrix([1, -2, 3, 2, -1, 4][:size])
        for row, J in zip(map(multiprecise, s), getattr(coscrew, name)(s), strict=True):
            moved = exponential_series(hat(row + multiprecise(J) * direction * delta))
            wanted = exponential_series(hat(direction * delta)) * exponential_series(hat(row))
            # J's error in its largest component, times δ, times what exp's own derivative enlarges.
            allowed = bound * unit(DOUBLE) * np.abs(J).max() * size * mp.norm(direction, 1) * (
                1 + mp.norm(row, 1))
            assert mp.mnorm(moved - wanted, 1) <= allowed * delta


def test_interpolation_starts_ends_and_keeps_its_speed(draw):
    number = draw(rotations).dtype.type
    D1, D2 = draw(displacements), draw(displacements)
    cosine = (np.einsum("...ij,...ij", D1[..., :3], D2[..., :3]) - 1) / 2
    D1, D2 = D1[cosine > -0.9], D2[cosine > -0.9]
    start, end = (coscrew.SE3_interpolated(D1, D2, number(k)) for k in (0, 1))
    close(start[..., :3], D1[..., :3], 12)
    close(end[..., :3], D2[..., :3], 24)
    largest = np.maximum(np.abs(D1[..., 3]).max(axis=1), np.abs(D2[..., 3]).max(axis=1))
    u = np.finfo(number).eps / 2
    assert (np.abs(end - D2)[..., 3].max(axis=1) <= 40 * u * largest).all()
    q1, q2 = (coscrew.quaternion_from_mat3x3(D[..., :3]) for D in (D1, D2))
    steps = [coscrew.quaternion_interpolated(q1, q2, number(k)) for k in (0, 0.25, 0.5, 0.75, 1)]
    close(steps[0], q1, 12)
    assert (np.minimum(np.abs(steps[4] - q2), np.abs(steps[4] + q2)) <= 24 * u).all()
    turns = [coscrew.quaternion_log(coscrew.quaternion_product_qconjq(a, b))
             for a, b in zip(steps, steps[1:], strict=False)]
    for turn in turns[1:]:
        assert (np.abs(turn - turns[0]) <= 48 * u).all()


@each_precision
def test_what_is_no_rotation_is_off_by_as_much(precision: Precision):
    """The logarithm of R + E with |E| <= ε is within 4 ε of that of the nearest rotation."""
    rng = np.random.default_rng(9)
    R = rotations(rng, 500).astype(float)
    R = R[np.trace(R, axis1=1, axis2=2) > -0.99]
    epsilon = 1e-6 if precision == DOUBLE else 1e-4
    near = (R + rng.uniform(-epsilon, epsilon, R.shape)).astype(precision.numpy_type)
    scale = 1 / np.sqrt(1 + np.trace(R, axis1=1, axis2=2))
    error = np.abs(coscrew.SO3_log(near) - coscrew.SO3_log(R)).max(axis=1)
    assert (error <= 8 * epsilon * np.maximum(scale, 1)).all()
    assert (error > epsilon / 100).any()


@each_motion
@each_precision
def test_no_rotation_at_all_raises_no_flag(operation: Operation, precision: Precision):
    """At zero and identity, and next to them, no operation is invalid, overflows or underflows."""
    still = {(): 0.0, (3,): np.zeros(3), (3, 3): np.eye(3), (3, 4): np.eye(3, 4), (6,): np.zeros(6),
             (4,): np.eye(4)[0]}
    inputs = tuple(
        np.asarray(still[a.quantity.shape], precision.numpy_type) if a.name != "axis" else
        np.eye(3, dtype=precision.numpy_type)[1] for a in operation.inputs)
    with np.errstate(all="raise"):
        for evaluate in (gufunc, twin):
            for result in evaluate(operation, precision, inputs):
                assert np.isfinite(result).all()


def test_leading_axes_broadcast():
    rng = np.random.default_rng(4)
    q1, q2 = map(coscrew.quaternion_exp, (rng.normal(size=(5, 1, 3)), rng.normal(size=(3, 3))))
    k = rng.uniform(size=(7, 1, 1))
    result = coscrew.quaternion_interpolated(q1, q2, k)
    assert result.shape == (7, 5, 3, 4)
    assert (result[2, 3, 1] == coscrew.quaternion_interpolated(q1[3, 0], q2[1], k[2, 0, 0])).all()


@each_precision
@pytest.mark.parametrize("implementation", [gufunc, twin], ids=["gufunc", "twin"])
def test_an_axis_is_as_accurate_however_small_the_turn(implementation, precision: Precision):
    """Down to subnormal vector parts, the direction is that of the vector part within 3 u."""
    info, u = np.finfo(precision.numpy_type), unit(precision)
    least = int(np.log2(info.smallest_subnormal))
    numbers = np.random.default_rng(8)
    v = np.vstack([numbers.integers(-9, 10, (60, 3)) * np.exp2(least + k) for k in (0, 5, 20, 60)])
    v = v[v.any(axis=1)]
    q = np.hstack([v, np.ones((len(v), 1))]).astype(precision.numpy_type)
    R = np.zeros((len(v), 3, 3), precision.numpy_type)
    R[:] = np.eye(3)
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        R[:, k, j], R[:, j, k] = q[:, i], -q[:, i]
    for name, given in (("axis_angle_from_quaternion", q), ("axis_angle_from_mat3x3", R)):
        angle, axis = implementation(TABLE[name], precision, (given,))
        for x, result in zip(v.tolist(), axis.astype(float).tolist(), strict=True):
            length = mp.norm(mp.matrix(x))
            assert max(abs(c / length - f) for c, f in zip(x, result, strict=True)) <= 3 * u
        assert (angle > 0).all()
