"""Laws of spatial inertias, exactly; LDL^T solutions, exactly and in both precisions."""

from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest

import coscrew
import coscrew.accurate
from tests.support.each import each_precision
from tests.support.truth.bodies import operator, pivots, pseudo_inertia, second_moments
from tests.support.truth.exact import Matrix, Sample, array, eye

each_kind = pytest.mark.parametrize("kind, n", [("mat3x3", 3), ("mat6x6", 6)])


def physical(sample: Sample) -> Matrix:
    """The inertia of five point masses."""
    B = array([Fraction(0)] * 10)
    for _ in range(5):
        m, r = abs(sample.scalar()), sample.vector()
        I = m * ((r @ r) * eye(3) - np.outer(r, r))
        B = B + array([m, *(m * r), I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2]])
    return B


def positive_definite(sample: Sample, n: int) -> Matrix:
    G = sample.vector(n * n).reshape(n, n)
    return G @ G.T


# inertias


def test_kinetic_energy_does_not_depend_on_the_frame(k, sample):
    D, B, s = sample.displacement(), sample.of("spatial_inertia"), sample.vector(6)
    there = k.spatial_inertia_energy(k.spatial_inertia_transformed(D, B), k.product_Ads(D, s))
    assert there == k.spatial_inertia_energy(B, s)


def test_momentum_moves_as_a_coscrew(k, sample):
    D, B, s = sample.displacement(), sample.of("spatial_inertia"), sample.vector(6)
    there = k.product_Bs(k.spatial_inertia_transformed(D, B), k.product_Ads(D, s))
    assert (there == k.product_CoAdc(D, k.product_Bs(B, s))).all()


def test_transforms_of_inertias_compose(k, sample):
    D1, D2, B = sample.displacement(), sample.displacement(), sample.of("spatial_inertia")
    both = k.spatial_inertia_transformed(k.product_dd(D1, D2), B)
    assert (both == k.spatial_inertia_transformed(D1, k.spatial_inertia_transformed(D2, B))).all()
    back = k.spatial_inertia_transformed(k.SE3_inverted(D1), k.spatial_inertia_transformed(D1, B))
    assert (back == B).all()


def test_momentum_of_joined_bodies_adds_up(k, sample):
    B1, B2, s = sample.of("spatial_inertia"), sample.of("inertia"), sample.vector(6)
    joined = k.product_Bs(k.add_BB(B1, B2), s)
    assert (joined == k.product_Bs(B1, s) + k.product_Bs(B2, s)).all()


def test_centre_of_mass_and_moments_about_it_make_the_inertia(k, sample):
    B = physical(sample)
    com, moments = k.spatial_inertia_com(B), k.spatial_inertia_about_com(B)
    made = k.spatial_inertia_from_com(B[0], com, moments)
    assert (made == B).all()


def test_a_point_mass_has_its_textbook_moments(k, sample):
    m, r = abs(sample.scalar()), sample.vector()
    B = k.spatial_inertia_from_com(m, r, array([[Fraction(0)] * 3] * 3))
    assert (second_moments(B) == m * ((r @ r) * eye(3) - np.outer(r, r))).all()


def test_consistency_is_the_smallest_pivot_of_the_pseudo_inertia(k, sample):
    J = pseudo_inertia(physical(sample))
    wanted = min(d / J[i, i] for i, d in enumerate(pivots(J)))
    assert k.spatial_inertia_consistency(physical(Sample(sample.scalar().numerator))) > 0
    B = physical(Sample(5))
    J = pseudo_inertia(B)
    assert k.spatial_inertia_consistency(B) == min(d / J[i, i] for i, d in enumerate(pivots(J)))
    assert wanted > 0


@pytest.mark.parametrize("spoil", [
    lambda B: B * ([-1] + [1] * 9),  # negative mass
    lambda B: B * ([1] * 4 + [Fraction(1, 100)] * 3 + [1] * 3),  # moments smaller than m c²
    lambda B: B + array([0] * 6 + [10**6] + [0] * 3),  # zz > xx + yy: no triangle
])
def test_an_impossible_inertia_is_not_consistent(k, spoil):
    assert k.spatial_inertia_consistency(spoil(physical(Sample(1)))) <= 0


def test_a_plate_is_on_the_edge_of_consistency(k):
    plate = array([Fraction(x) for x in (1, 0, 0, 0, 1, 2, 3, 0, 0, 0)])  # zz = xx + yy
    assert k.spatial_inertia_consistency(plate) == 0


# symmetric matrices


@each_kind
def test_factors_make_the_matrix(k, sample, kind, n):
    A = positive_definite(sample, n)
    pivot, packed = getattr(k, f"{kind}_ldl")(A)
    D = np.diag(np.diag(packed))
    L = packed - D + eye(n)
    assert (L @ D @ L.T == A).all() and not np.triu(packed, 1).any()
    assert pivot == min(d / A[i, i] for i, d in enumerate(np.diag(packed)))


@each_kind
def test_solutions_solve(k, sample, kind, n):
    A, b = positive_definite(sample, n), sample.vector(n)
    pivot, x = getattr(k, f"{kind}_solve")(A, b)
    factor_pivot, L = getattr(k, f"{kind}_ldl")(A)
    assert pivot == factor_pivot > 0
    assert (A @ x == b).all() and (getattr(k, f"{kind}_ldl_solve")(L, b) == x).all()


@each_kind
def test_only_the_lower_triangle_is_read(k, sample, kind, n):
    A, b = positive_definite(sample, n), sample.vector(n)
    spoiled = np.tril(A) + np.triu(sample.vector(n * n).reshape(n, n), 1)
    x, y = (getattr(k, f"{kind}_solve")(M, b)[1] for M in (A, spoiled))
    assert (x == y).all()


@each_kind
@each_precision
@pytest.mark.parametrize("tier", [coscrew, coscrew.accurate], ids=["plain", "accurate"])
def test_singular_and_indefinite_matrices_are_reported(kind, n, precision, tier):
    real = np.dtype(precision.numpy_type)
    solve, ones = getattr(tier, f"{kind}_solve"), np.ones(n, real)
    indefinite = np.diag([-1.0 if i == n - 1 else 1.0 for i in range(n)]).astype(real)
    for A in (np.zeros((n, n), real), np.ones((n, n), real), -np.eye(n, dtype=real), indefinite):
        with np.errstate(all="raise"):
            pivot, x = solve(A, ones)
        assert pivot <= 0 and np.isnan(x).all()
    pivot, x = solve(np.eye(n, dtype=real), ones)
    assert pivot == 1 and (x == 1).all()


# Largest error of the accurate tier in u of the largest component.
ACCURATE = 1


@each_kind
@each_precision
def test_accurate_solutions_are_within_1_u(kind, n, precision):
    """… up to condition 1e14 in double, 1e5 in single; plain ones within n condition u."""
    real, u = np.dtype(precision.numpy_type), 2.0**-{"double": 53, "single": 24}[precision.name]
    numbers = np.random.default_rng(n)
    for exponent in ((0, 4, 8, 12, 14) if precision.name == "double" else (0, 3, 5)):
        for _ in range(20):
            Q, _ = np.linalg.qr(numbers.normal(size=(n, n)))
            A = (Q * np.logspace(0, -exponent, n)) @ Q.T
            A, b = (np.tril(A) + np.tril(A, -1).T).astype(real), numbers.normal(size=n).astype(real)
            truth, condition = solution(A, b)
            for tier, bound in ((coscrew.accurate, ACCURATE), (coscrew, n * condition)):
                pivot, x = getattr(tier, f"{kind}_solve")(A, b)
                error = max(abs(mp.mpf(float(c)) - t) for c, t in zip(x, truth, strict=True))
                assert pivot > 0 and x.dtype == real
                assert error <= bound * u * max(map(abs, truth)), (tier.__name__, exponent)


def solution(A: np.ndarray, b: np.ndarray) -> tuple[list[mp.mpf], float]:
    """The solution in 60 digits, and the condition of A."""
    with mp.workdps(60):
        x = mp.lu_solve(mp.matrix(A.astype(float).tolist()), mp.matrix(b.astype(float).tolist()))
    return list(x), float(np.linalg.cond(A.astype(float)))


@each_precision
def test_angle_between_vectors(precision):
    """Accurate: within 4 u for angles from 1e-30 to π and vectors of every size; plain: within 4 u
    for angles from 1/4 to 3."""
    real, u = np.dtype(precision.numpy_type), 2.0**-{"double": 53, "single": 24}[precision.name]
    numbers, top = np.random.default_rng(3), {"double": 300, "single": 30}[precision.name]
    for angle in (*10.0**numbers.uniform(-top / 2, 0, 60), *numbers.uniform(0, np.pi, 60)):
        Q, _ = np.linalg.qr(numbers.normal(size=(3, 3)))
        a, b = Q[0], Q[0] * np.cos(angle) + Q[1] * np.sin(angle)
        if angle < 1e-6:  # smaller than rounding: along the axes
            a, b = np.array([1, 0, 0]), np.array([1, angle, 0])
        a, b = ((x * 10.0**numbers.integers(-top // 2, top // 2)).astype(real) for x in (a, b))
        truth = angle_between(a, b)
        for tier in (coscrew.accurate, coscrew):
            if tier is coscrew.accurate or 0.25 < angle < 3:
                result = tier.angle_vv(a, b)
                assert abs(mp.mpf(float(result)) - truth) <= 4 * u * truth, (a, b)


def angle_between(a: np.ndarray, b: np.ndarray) -> mp.mpf:
    with mp.workdps(400):
        x, y = (mp.matrix([float(c) for c in v]) for v in (a, b))
        cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
        return mp.atan2(mp.norm(mp.matrix(cross)), mp.fdot(x, y))


@pytest.mark.parametrize("a, b, angle", [
    ([1, 0, 0], [2, 0, 0], 0), ([1, 0, 0], [0, 3, 0], np.pi / 2), ([1, 0, 0], [-2, 0, 0], np.pi),
    ([0, 0, 0], [1, 0, 0], 0)])
def test_angles_between_axes(a, b, angle):
    with np.errstate(all="raise"):
        assert coscrew.angle_vv(a, b) == coscrew.double.angle_vv(a, b) == angle


def test_operators_of_inertias_are_symmetric_and_as_stated(sample):
    M = operator(physical(sample))
    assert (M == M.T).all()
