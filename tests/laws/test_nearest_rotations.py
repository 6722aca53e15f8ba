"""The rotation nearest to a matrix, the unit quaternion nearest to a quaternion, and their defects:
how far a matrix and a quaternion are from being such.

Truth are singular values in 50 digits; SciPy's polar factor agrees.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
import scipy.linalg
from mpmath import mpf

import coscrew.accurate
import coscrew.certified
from coscrew_codegen.accuracy.tiers.accurate import LARGEST
from coscrew_codegen.algebra.lowering.programs import library_program
from coscrew_codegen.algebra.operations.formulas.nearest import BESIDE, NEAREST
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision
from tests.support.truth.nearest import nearest, off_orthonormal

Draw = Callable[[np.random.Generator], np.ndarray]
SCALES = {"double": (1e-320, 1e-300, 1e-150, 1e150, 1e300), "single": (1e-44, 1e-37, 1e-18, 1e37)}
ROWS = 30
GUIDE = Path(__file__).parents[2] / "docs" / "accuracy.md"


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def rotation(rng: np.random.Generator) -> np.ndarray:
    return coscrew.SO3_exp(rng.uniform(-2, 2, 3))


def with_values(values: Callable[[np.random.Generator], tuple[float, ...]]) -> Draw:
    """Matrices with these singular values; a negative one makes a reflection."""
    return lambda rng: rotation(rng) @ np.diag(values(rng)) @ rotation(rng)


def small(rng: np.random.Generator) -> float:
    return float(10**rng.uniform(-12, 0))


DRAWN: dict[str, Draw] = {
    "any": lambda rng: rng.normal(size=(3, 3)),
    "nearly rotations": lambda rng: rotation(rng) + small(rng) * rng.normal(size=(3, 3)),
    "reflections": with_values(lambda rng: (3, 2, -1)),
    "reflections with nearly equal values": with_values(
        lambda rng: (1 + 2e-3 * rng.random(), 1 + 1e-3 * rng.random(), -1)),
    "nearly singular": with_values(lambda rng: (1, rng.uniform(0.1, 1), small(rng))),
    "of rank 2": with_values(lambda rng: (2, 1, 0)),
    "nearly of rank 1": with_values(lambda rng: (1, small(rng), -small(rng) / 1e3)),
    "columns of all sizes": lambda rng: rng.normal(size=(3, 3)) * 10**rng.uniform(-6, 6, (1, 3)),
    "rows of all sizes": lambda rng: rng.normal(size=(3, 3)) * 10**rng.uniform(-6, 6, (3, 1)),
    "nearly diagonal": lambda rng: np.diag(rng.normal(size=3)) + small(rng),
    "small integers": lambda rng: rng.integers(-2, 3, (3, 3)) + np.diag([0.0, 1, 4])}


@each_precision
@pytest.mark.parametrize("kind", DRAWN)
def test_the_nearest_rotation_is_that_of_the_singular_values(kind: str, precision: Precision):
    rng, real = np.random.default_rng([5, *kind.encode()]), np.dtype(precision.numpy_type)
    u = mpf(2)**-precision.digits
    given = np.array([DRAWN[kind](rng) for _ in range(ROWS)]).astype(real)
    for A, R in zip(given, coscrew.mat3x3_nearest_rotation(given), strict=True):
        assert R.dtype == real
        wanted, gap = nearest(A)
        assert off_orthonormal(R) <= BESIDE * u
        error = mpmath.mnorm(mpmath.matrix(R.tolist()) - wanted, "f")
        assert error * gap <= NEAREST * u, A


@each_precision
def test_sizes_do_not_matter(precision: Precision):
    rng, real = np.random.default_rng(6), np.dtype(precision.numpy_type)
    for scale in SCALES[precision.name]:
        A = (rng.normal(size=(ROWS, 3, 3)) * scale).astype(real)
        for a, R in zip(A, coscrew.mat3x3_nearest_rotation(A), strict=True):
            wanted, gap = nearest(a)
            error = mpmath.mnorm(mpmath.matrix(R.tolist()) - wanted, "f")
            assert error * gap <= NEAREST * mpf(2)**-precision.digits


@each_precision
@pytest.mark.parametrize("values", [(1, 1, -1), (2, 1, -1), (1, 0, 0), (5, 1e-40, 0)])
def test_where_several_are_equally_near_it_is_one_of_them(values: tuple[float, ...],
                                                          precision: Precision):
    """tr R^T A is s1 + s2 ± s3, to rounding."""
    rng, real = np.random.default_rng(7), np.dtype(precision.numpy_type)
    u = 2.0**-precision.digits
    cases = [np.diag(values), np.outer([1, 2, 3], [3, -1, 2]) * 1.0, -np.eye(3),
             *(with_values(lambda rng: values)(rng) for _ in range(ROWS))]
    for A in np.array(cases).astype(real):
        R = coscrew.mat3x3_nearest_rotation(A)
        assert off_orthonormal(R) <= BESIDE * u
        _, s, _ = np.linalg.svd(A.astype(float))
        best = s[0] + s[1] + (s[2] if np.linalg.det(A.astype(float)) > 0 else -s[2])
        assert abs(np.trace(R.astype(float).T @ A) - best) <= 16 * u * s[0]


@each_precision
def test_entries_of_all_exponents(precision: Precision):
    """Squares of the shorter columns underflow: any direction across the longest will do."""
    rng, info = np.random.default_rng(11), np.finfo(precision.numpy_type)
    least, most = np.log10(float(info.smallest_subnormal)), np.log10(float(info.max)) - 1
    wide = rng.normal(size=(2000, 3, 3)) * 10**rng.uniform(least, most, (2000, 3, 3))
    near = 10**rng.uniform(least, most, (2000, 1, 1)) * rng.normal(size=(2000, 3, 3))
    near *= 10**rng.uniform(-40, 0, (2000, 3, 3))
    given = np.concatenate([wide, near, [
        [[-2e-23, 0, 0], [6e-7, 6e-23, 0], [0, 0, 0]],
        [[0, -1e-161, 0], [2e-164, 4e-13, 0], [0, 0, 0]]]])
    given[:4000][rng.random((4000, 3, 3)) < 0.3] = 0
    given = given.astype(precision.numpy_type)
    given = given[given.any((1, 2))]
    R = coscrew.mat3x3_nearest_rotation(given).astype(np.longdouble)
    off = np.einsum("nki,nkj->nij", R, R) - np.eye(3)
    assert np.abs(off).max() <= BESIDE * 2.0**-precision.digits
    assert (np.linalg.det(R.astype(float)) > 0.99).all()


def test_the_guide_tells_why_no_tier_has_it():
    row = (f"| `mat3x3_nearest_rotation` | no: it has more than {LARGEST} instructions, and errs "
           f"by {NEAREST} u times its condition, s1 / (s2 ± s3) | no |")
    assert row in GUIDE.read_text(encoding="utf-8").splitlines()
    assert len(library_program("mat3x3_nearest_rotation").instructions) > LARGEST
    assert not hasattr(coscrew.accurate, "mat3x3_nearest_rotation")
    assert not hasattr(coscrew.certified, "mat3x3_nearest_rotation")


def test_rotations_are_their_own_nearest():
    """To rounding, and exactly if they only exchange axes."""
    turns = np.array([[[0, -1, 0], [1, 0, 0], [0, 0, 1]], np.eye(3), np.diag([-1, 1, -1])])
    assert np.array_equal(coscrew.mat3x3_nearest_rotation(turns), turns)


def test_scipy_agrees():
    A = np.random.default_rng(8).normal(size=(200, 3, 3))
    for a, R in zip(A, coscrew.mat3x3_nearest_rotation(A), strict=True):
        if np.linalg.det(a) > 0.1:
            assert np.abs(R - scipy.linalg.polar(a)[0]).max() <= 1e-13


@each_precision
def test_zero_has_no_nearest_rotation(precision: Precision):
    twins = getattr(coscrew, precision.name)
    assert np.isnan(twins.mat3x3_nearest_rotation(np.zeros((3, 3)))).all()
    assert np.isnan(twins.quaternion_nearest_unit(np.zeros(4))).all()
    for bad in (np.nan, np.inf):
        with np.errstate(all="ignore"):
            result = coscrew.mat3x3_nearest_rotation(np.diag([bad, 1, 1]))
        assert np.isnan(result).any()


@each_precision
def test_the_nearest_unit_quaternion_of_every_length(precision: Precision):
    """Within 3 u of q / |q|, component by component, unless that is subnormal."""
    info, rng = np.finfo(precision.numpy_type), np.random.default_rng(9)
    lengths = 10**rng.uniform(np.log10(float(info.tiny)), np.log10(float(info.max)) - 1, (200, 1))
    given = (rng.normal(size=(200, 4)) * lengths).astype(precision.numpy_type)
    for q, result in zip(given, coscrew.quaternion_nearest_unit(given), strict=True):
        exact = mpmath.matrix(q.tolist())
        for x, wanted in zip(result.tolist(), exact / mpmath.norm(exact), strict=True):
            assert abs(x - wanted) <= 3 * mpf(2)**-precision.digits * abs(wanted)


def exact_defect(R: np.ndarray) -> Fraction:
    """By rationals: the largest |entry| of R^T R - I, or |det R - 1|."""
    r = [[Fraction(float(x)) for x in row] for row in R]
    off = [sum(row[i] * row[j] for row in r) - (i == j) for i in range(3) for j in range(3)]
    det = sum(r[0][i] * (r[1][i - 2] * r[2][i - 1] - r[1][i - 1] * r[2][i - 2]) for i in range(3))
    return max(map(abs, (*off, det - 1)))


@each_precision
def test_defects_of_matrices(precision: Precision):
    rng, real = np.random.default_rng(10), np.dtype(precision.numpy_type)
    for R, wanted in ((np.eye(3), 0), (np.diag([-1, 1, 1]), 2), (-np.eye(3), 2),
                      (np.zeros((3, 3)), 1), (2 * np.eye(3), 7)):
        assert coscrew.mat3x3_rotation_defect(R.astype(real)) == wanted
        assert coscrew.mat3x3_is_rotation(R.astype(real)) == (wanted == 0)
    for _ in range(ROWS):
        R = (rotation(rng) + small(rng) * rng.normal(size=(3, 3))).astype(real)
        result, wanted = float(coscrew.mat3x3_rotation_defect(R)), exact_defect(R)
        assert abs(result - wanted) <= (6 + 20 * wanted) * Fraction(2)**-precision.digits
        assert coscrew.mat3x3_is_rotation(R) == (result <= 1e-3)
    assert np.isnan(coscrew.mat3x3_rotation_defect(np.full((3, 3), np.nan)))
    for i, j in np.ndindex(3, 3):
        R = np.eye(3, dtype=real)
        R[i, j] = np.nan
        assert np.isnan(coscrew.mat3x3_rotation_defect(R)) and not coscrew.mat3x3_is_rotation(R)


def test_defects_of_quaternions():
    q = np.array([[0, 0, 0, 1], [0.6, 0, 0, 0.8], [0, 0, 0, 0], [0, 3e200, 0, 0], [0, 0, 0, -2]])
    assert coscrew.quaternion_unit_defect(q).tolist() == [0, 0, -1, 3e200, 1]
    assert coscrew.quaternion_is_unit(q).tolist() == [True, True, False, False, False]
    assert not coscrew.quaternion_is_unit([0, np.nan, 0, 1])
