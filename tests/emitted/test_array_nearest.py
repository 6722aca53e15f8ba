"""Nearest rotations on arrays of JAX, whose compiler computes numbers again with other roundings,
and their derivatives.  Truth are singular values in 50 digits."""

from collections.abc import Callable, Iterator

import jax
import jax.numpy as jnp
import mpmath
import numpy as np
import pytest
from mpmath import mpf
from scipy.spatial.transform import Rotation

import coscrew
from coscrew_codegen.algebra.operations.formulas.nearest import BESIDE, NEAREST
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision
from tests.support.truth.nearest import nearest, off_orthonormal

ROWS = 25
SLOPE = 100
"""In u: the largest relative error of derivatives, divided by the square of their condition."""
NEAREST_ON_JAX = coscrew.arrays(jnp).mat3x3_nearest_rotation
CALLS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "each": lambda given: np.array([NEAREST_ON_JAX(A) for A in given]),
    "batch": lambda given: np.asarray(NEAREST_ON_JAX(given)),
    "jit": lambda given: np.asarray(jax.jit(NEAREST_ON_JAX)(given)),
    "vmap": lambda given: np.asarray(jax.vmap(jax.jit(NEAREST_ON_JAX))(given))}
VALUES = {"rotations": (1, 1, 1), "reflections": (1, 1, -0.5), "two alike": (2, 1, 1),
          "the longest alike": (1, 1, 0.5), "of rank 2": (1, 1, 0), "apart": (3, 2, 1),
          "nearly alike": (1, 1 - 1e-9, -0.5), "far from rank 1": (1, 1e-4, 1e-4)}


@pytest.fixture(autouse=True)
def with_x64_and_fifty_digits() -> Iterator[None]:
    with jax.enable_x64(True), mpmath.workdps(50):
        yield


def matrices(values: tuple[float, ...]) -> np.ndarray:
    U, V = (Rotation.random(ROWS, random_state=seed).as_matrix() for seed in (1, 2))
    return U @ np.diag(values) @ V


@each_precision
@pytest.mark.parametrize("how", CALLS)
def test_choices_are_made_once(how: str, precision: Precision) -> None:
    """Columns turn by angles that rounding errors choose where singular values coincide: all parts
    by the same angles."""
    u = mpf(2)**-precision.digits
    given = np.concatenate(
        [matrices(values) for values in VALUES.values()]
        + [[np.eye(3), np.diag([-1, 1, -1]), [[-1, -1, 2], [-1, 1, 0], [0, 2, 1]]]]
    ).astype(precision.numpy_type)
    for A, R in zip(given, CALLS[how](given), strict=True):
        wanted, gap = nearest(A)
        assert off_orthonormal(R) <= BESIDE * u
        error = mpmath.mnorm(mpmath.matrix(R.tolist()) - wanted, "f")
        assert error * gap <= NEAREST * u, A


def derivative(A: np.ndarray, D: np.ndarray) -> tuple[mpmath.matrix, mpf]:
    """The derivative of the nearest rotation R along D, R [ω]x with (tr S - S) ω = axial part of
    R^T D - D^T R and S = R^T A, and the condition s1² / ((s1 ± s3) (s2 ± s3)), at least 1."""
    R, _ = nearest(A)
    S, W = R.T * mpmath.matrix(A.tolist()), R.T * mpmath.matrix(D.tolist())
    S, W = (S + S.T) / 2, W - W.T
    least, middle, most = sorted(mpmath.eigsy(S, eigvals_only=True))
    x, y, z = mpmath.lu_solve((least + middle + most) * mpmath.eye(3) - S,
                              mpmath.matrix([W[2, 1], W[0, 2], W[1, 0]]))
    turned = R * mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return turned, max(1, most**2 / ((most + least) * (middle + least)))


@each_precision
@pytest.mark.parametrize("values", [
    (1, 1, 1), (3, 2, 1), (1, 1, -0.9), (1, 0.99, -0.98), (1, 0.5, -0.4), (1, 0.5, -0.499),
    (1, 0.5, -0.4999), (1, 1e-2, 0), (1, 1e-3, 1e-3), (1, 1e-4, 0), (1, 1e-5, 1e-5)])
def test_derivatives_near_several_nearest_rotations(values: tuple[float, ...],
                                                    precision: Precision) -> None:
    given, along = (x.astype(precision.numpy_type) for x in (
        matrices(values), np.random.default_rng(3).normal(size=(ROWS, 3, 3))))
    _, forward = jax.jvp(NEAREST_ON_JAX, (given,), (along,))
    _, transposed = jax.vjp(NEAREST_ON_JAX, given)
    for A, D, result in zip(given, along, np.asarray(forward), strict=True):
        assert_near(result, *derivative(A, D), precision)
    for A, W, result in zip(given[:3], along, np.asarray(transposed(along)[0]), strict=False):
        parts = [derivative(A, unit)[0] for unit in np.eye(9).reshape(9, 3, 3)]
        wanted = mpmath.matrix(3, 3)
        for k, part in enumerate(parts):
            wanted[k // 3, k % 3] = mpmath.fsum(
                part[i, j] * float(W[i, j]) for i, j in np.ndindex(3, 3))
        assert_near(result, wanted, derivative(A, W)[1], precision)


def assert_near(result: np.ndarray, wanted: mpmath.matrix, condition: mpf, precision: Precision
                ) -> None:
    """Within SLOPE u condition² of the largest component, as long as that is less than it."""
    bound = SLOPE * mpf(2)**-precision.digits * condition**2
    error = max(map(abs, mpmath.matrix(result.tolist()) - wanted))
    assert error <= bound * max(map(abs, wanted)) or bound >= 1
