"""Inverses of 3×3 matrices of every size: correct if the matrix is numerically regular, else
refused.

Truth is exact rationals, which also decide which matrices are regular."""

from fractions import Fraction
from functools import cache
from itertools import permutations, product

import numpy as np
import pytest

import coscrew
import coscrew.accurate
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision

REACH = {"double": Fraction(1, 2**700), "single": Fraction(1, 2**80)}
SPOILED = {"double": Fraction(1, 2**760), "single": Fraction(1, 2**96)}
EDGE = {"double": (47453132, 47453133), "single": (2047, 2049)}
"""x with det [[x - 2, x], [x, x + 2]] = -4 just above, and just below, 8 u (2 x² - 4)."""

each_tier = pytest.mark.parametrize("tier", [coscrew, coscrew.accurate], ids=["plain", "accurate"])


class Exact:
    """Cofactors and determinant of a matrix, and the sums of the absolute values of their terms."""

    def __init__(self, R: np.ndarray) -> None:
        self.R = [[Fraction(float(x)) for x in row] for row in R]
        self.largest = max(abs(x) for row in self.R for x in row)
        self.adjugate = [[self._minor(j, i, -1) for j in range(3)] for i in range(3)]
        self.sizes = [[self._minor(j, i, 1) for j in range(3)] for i in range(3)]
        terms = [self.R[0][j] * self.adjugate[j][0] for j in range(3)]
        self.det = sum(terms)
        self.permanent = sum(abs(self.R[0][j]) * self.sizes[j][0] for j in range(3))

    def _minor(self, row: int, column: int, sign: int) -> Fraction:
        (a, b), (c, d) = ([self.R[(row + i) % 3][(column + j) % 3] for j in (1, 2)] for i in (1, 2))
        return a * d - b * c if sign < 0 else abs(a * d) + abs(b * c)

    def times(self, power: Fraction) -> "Exact":
        """The result for the matrix times this factor."""
        new = object.__new__(Exact)
        new.R = [[x * power for x in row] for row in self.R]
        new.adjugate, new.sizes = ([[x * power**2 for x in row] for row in M]
                                   for M in (self.adjugate, self.sizes))
        new.largest, new.det = self.largest * power, self.det * power**3
        new.permanent = self.permanent * power**3
        return new

    def regular(self, precision: Precision) -> bool:
        """Returns whether it can be distinguished from a singular matrix."""
        least = 8 * unit(precision) * self.permanent + SPOILED[precision.name] * self.largest**3
        return abs(self.det) > least


def unit(precision: Precision) -> Fraction:
    return Fraction(float(np.finfo(precision.numpy_type).eps)) / 2


def of(tier, R: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    with np.errstate(all="ignore"):
        det, Ro = tier.mat3x3_inverse(R)
    assert det.dtype == Ro.dtype == R.dtype
    return det, Ro


def excess(result: np.floating, exact: Fraction, allowed: Fraction) -> float:
    """The error as a multiple of the bound, after the rounding of subnormal numbers is subtracted;
    results that overflow may be infinite."""
    info = np.finfo(result.dtype)
    if not np.isfinite(result):
        too_large = abs(exact) + allowed >= Fraction(float(info.max))
        return 0.0 if too_large and result == (np.inf if exact > 0 else -np.inf) else np.inf
    error = abs(Fraction(float(result)) - exact)
    return float(error / (allowed + Fraction(float(info.smallest_subnormal))))


def worst(tier, precision: Precision, truth: Exact, det: np.floating, Ro: np.ndarray) -> float:
    """The largest error as a multiple of the stated one; in the accurate tier, of one unit and a
    second-order rest."""
    u, plain = unit(precision), tier is coscrew
    cancelled = truth.permanent / abs(truth.det)
    results = [excess(det, truth.det, (4 if plain else u * 64) * u * truth.permanent
                      + (0 if plain else u * abs(truth.det)))]
    for i, j in product(range(3), repeat=2):
        exact = truth.adjugate[i][j] / truth.det
        least = REACH[precision.name] * truth.largest**2
        terms = max(truth.sizes[i][j], least) / abs(truth.det)
        stated = 2 * u * terms + 6 * u * abs(exact) * cancelled
        if not plain:
            stated = u * abs(exact) + 64 * u * stated + 2 * u * least / abs(truth.det)
        results.append(excess(Ro[i, j], exact, stated))
    return max(results)


@cache
def small_integers() -> np.ndarray:
    """Regular matrices with few bits, so that they can be scaled by any power of two."""
    rng = np.random.default_rng(11)
    R = rng.integers(-7, 8, (40, 3, 3)).astype(float)
    return np.array([*R[np.abs(np.linalg.det(R)) > 0.5][:4], np.eye(3), np.eye(3)[[1, 2, 0]]])


@each_tier
@each_precision
def test_size_does_not_matter(precision, tier):
    """Matrices of small integers times every power of two for which they are finite and exact."""
    info = np.finfo(precision.numpy_type)
    exponents = np.arange(info.minexp - info.nmant, info.maxexp - 3, info.nmant // 10)
    for base in small_integers():
        truth = Exact(base)
        R = np.ldexp(base, exponents[:, None, None]).astype(precision.numpy_type)
        for k, det, Ro in zip(exponents.tolist(), *of(tier, R), strict=True):
            scaled = truth.times(Fraction(2)**k)
            assert not np.isnan(Ro).any(), (base, k)
            assert worst(tier, precision, scaled, det, Ro) <= 1, (base, k)


def test_ordinary_small_and_large_matrices_are_regular():
    for tier in (coscrew, coscrew.accurate):
        for size, dtype, det in ((1e-10, "f4", 1e-30), (1e13, "f4", 1e39), (1e-97, "f8", 1e-291),
                                 (1e110, "f8", np.inf), (1e-120, "f8", 0)):
            result, Ro = of(tier, (size * np.eye(3)).astype(dtype))
            assert np.allclose(Ro, np.eye(3) / size, rtol=1e-6, atol=0)
            with np.errstate(over="ignore"):
                wanted = np.float64(det).astype(dtype)
            assert result == wanted or np.isclose(result, wanted, rtol=1e-6)


@cache
def general(precision: Precision) -> np.ndarray:
    """Matrices of every size; with rows, columns and single entries of different sizes; nearly
    singular."""
    rng, info = np.random.default_rng(precision.bytes), np.finfo(precision.numpy_type)
    n, apart = 600, 8 if precision.name == "single" else 100
    R = rng.uniform(0.5, 1, (n, 3, 3)) * rng.choice((-1, 1), (n, 3, 3))
    near = np.arange(n) % 5 == 0  # the last row nearly a sum of the others
    sums = R[near, 0] * rng.normal(size=(near.sum(), 1)) + R[near, 1]
    R[near, 2] = sums * (1 + rng.uniform(-1, 1, sums.shape) * 2.0**-rng.uniform(4, info.nmant - 4,
                                                                                 (near.sum(), 1)))
    rows, columns = rng.integers(-apart, apart, (2, n, 3))
    single = rng.integers(-apart, apart, (n, 3, 3)) * (np.arange(n) % 3 == 1)[:, None, None]
    whole = rng.integers(info.minexp + 3 * apart, info.maxexp - 3 * apart, n)[:, None, None]
    exponents = whole + single + np.where(near, 0, 1)[:, None, None] * (
        rows[:, :, None] + columns[:, None, :])
    return np.ldexp(R, exponents).astype(precision.numpy_type)


@each_tier
@each_precision
def test_errors_are_as_stated(precision, tier):
    R, answered = general(precision), 0
    for matrix, det, Ro in zip(R, *of(tier, R), strict=True):
        truth = Exact(matrix)
        if np.isnan(Ro).any():
            least = 13 * unit(precision) * truth.permanent  # including the error of det R itself
            assert abs(truth.det) <= least + 2 * SPOILED[precision.name] * truth.largest**3, matrix
            continue
        answered += 1
        assert worst(tier, precision, truth, det, Ro) <= 1, [float(x).hex() for x in matrix.flat]
    assert answered > 0.9 * len(R)


@each_tier
@each_precision
def test_both_sides_of_the_threshold(precision, tier):
    """Determinants -4 from exact products, at every position, with entries of both signs."""
    info, rng = np.finfo(precision.numpy_type), np.random.default_rng(3)
    lowest = info.minexp - info.nmant
    for x, regular in zip(EDGE[precision.name], (True, False), strict=True):
        base = np.array([[x - 2, x, 0], [x, x + 2, 0], [0, 0, 2**9]], float)
        rows = []
        for order in permutations(range(3)):
            signs = rng.choice((-1, 1), (2, 3))
            turned = base[list(order)] * signs[0][:, None] * signs[1]
            assert Exact(turned).regular(precision) == regular
            exponents = np.arange(lowest, info.maxexp - 27, 7)
            rows.append(np.ldexp(turned, exponents[:, None, None]))
        R = np.concatenate(rows).astype(precision.numpy_type)
        det, Ro = of(tier, R)
        if regular:
            assert not np.isnan(Ro).any()
        else:
            assert np.isnan(Ro).all() and not det.any()


@each_tier
@each_precision
def test_no_singular_matrix_gets_an_answer(precision, tier):
    """Integer matrices of rank 0 to 2 times any power of two, and matrices with entries that are
    not finite."""
    info, rng = np.finfo(precision.numpy_type), np.random.default_rng(7)
    top = 2**10 if precision.name == "double" else 2**4
    rows = []
    for n in range(600):
        L, U = rng.integers(-top, top, (3, n % 3)), rng.integers(-top, top, (n % 3, 3))
        exponent = rng.integers(info.minexp - info.nmant, info.maxexp - 24)
        rows.append(np.ldexp((L @ U).astype(float), exponent))
    for i, x in product(range(9), (np.inf, -np.inf, np.nan)):
        for base in (np.eye(3), np.zeros((3, 3)), rng.normal(size=(3, 3))):
            base = base.copy()
            base.flat[i] = x
            rows.append(base)
    R = np.array(rows).astype(precision.numpy_type)
    det, Ro = of(tier, R)
    assert np.isnan(Ro).all() and not det.any()


@each_precision
def test_small_factors_beside_large_ones(precision):
    """The bound for entries of different sizes: 2^-96 (2^-760) of the third power of the largest
    one."""
    exponent = {"single": 48, "double": 380}[precision.name]
    for apart, regular in ((exponent - 1, True), (exponent + 1, False)):
        for whole in np.arange(-30, 60, 3):
            d = np.ldexp(1.0, [int(whole), int(whole) - apart, int(whole) - apart])
            det, Ro = of(coscrew, np.diag(d).astype(precision.numpy_type))
            assert np.array_equal(Ro, np.diag(1 / d)) if regular else np.isnan(Ro).all()
