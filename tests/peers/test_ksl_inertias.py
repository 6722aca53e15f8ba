"""Inertias with moments about the centre of mass, as KSL has them: exact laws; errors; factors in
C."""

import ctypes
import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import coscrew
import coscrew.accurate
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.algebra.operations.inertia import MERGED
from coscrew_codegen.algebra.operations.spatial_inertia import CONVERTED
from coscrew_codegen.program.values.formats import Precision
from tests.support.compiled.c_harness import C11, COMPILERS, EXACT, INCLUDE, STRICT, run
from tests.support.each import each_precision
from tests.support.truth import bodies
from tests.support.truth.exact import Matrix, Sample

SOURCE = Path(__file__).with_name("ksl_functions.c")
FACTORED = 160  # in u: the error of L L^T, relative to the largest moment
ROWS = 120
TIERS = {"plain": coscrew, "accurate": coscrew.accurate}
each_tier = pytest.mark.parametrize("tier", TIERS)


def points(sample: Sample) -> Matrix:
    """Masses and places of five points, (m, x, y, z) each."""
    return np.array([[abs(sample.scalar()), *sample.vector()] for _ in range(5)])


def of_points(given: Matrix) -> Matrix:
    """The ten numbers of their inertia, by definition."""
    m = given[:, 0].sum()
    c = (given[:, :1] * given[:, 1:]).sum(axis=0) / m
    I = sum(row[0] * bodies.steiner(row[1:] - c) for row in given)
    return bodies.inertia(m, m * c, I)


def test_moments_are_about_the_centre_of_mass(k, sample):
    """They equal those of the points: rotated, moved, and joined with other points."""
    D, one, other = sample.displacement(), points(sample), points(sample)
    moved = np.hstack([other[:, :1], other[:, 1:] @ D[:, :3].T + D[:, 3]])
    J, Jj = of_points(one), of_points(other)
    assert (k.inertia_transformed(Jj, D) == of_points(moved)).all()
    both = k.inertia_merge(J, J[1:4] / J[0], Jj, Jj[1:4] / Jj[0], D)
    assert (both == of_points(np.vstack([one, moved]))).all()


def test_moving_a_body_leaves_its_moments(k, sample):
    J, t = of_points(points(sample)), sample.vector()
    moved = k.inertia_translated(J, t)
    assert (moved[4:] == J[4:]).all() and (moved[1:4] / J[0] == J[1:4] / J[0] + t).all()


def test_transforms_compose_and_are_undone(k, sample):
    D1, D2, J = sample.displacement(), sample.displacement(), sample.of("inertia")
    both = k.inertia_transformed(J, k.product_dd(D1, D2))
    assert (both == k.inertia_transformed(k.inertia_transformed(J, D2), D1)).all()
    assert (k.inertia_transformed(k.inertia_transformed(J, D1), k.SE3_inverted(D1)) == J).all()


def test_spatial_inertias_know_the_same(k, sample):
    """Conversions undo each other, and commute with moving and joining bodies."""
    D, J, Jj = sample.displacement(), sample.of("inertia"), of_points(points(sample))
    B, Bj = map(k.spatial_inertia_from_inertia, (J, Jj))
    assert (k.inertia_from_spatial_inertia(B) == J).all() and (B[4:] != J[4:]).any()
    assert (k.inertia_from_spatial_inertia(k.spatial_inertia_transformed(D, B))
            == k.inertia_transformed(J, D)).all()
    joined = k.add_BB(B, k.spatial_inertia_transformed(D, Bj))
    merged = k.inertia_merge(J, J[1:4] / J[0], Jj, Jj[1:4] / Jj[0], D)
    assert (k.inertia_from_spatial_inertia(joined) == merged).all()


def test_the_moments_of_a_box(k):
    """m/12 (b² + c²), and m d²/4 more about a corner, for a box of 12 kg and 1 by 2 by 3 m."""
    J = k.inertia(Fraction(12), np.array([Fraction(n, 2) for n in (1, 2, 3)]),
                  *map(Fraction, (13, 10, 5, 0, 0, 0)))
    B = k.spatial_inertia_from_inertia(J)
    assert (B == [12, 6, 12, 18, 52, 40, 20, -6, -9, -18]).all()


# errors


def rational(x: np.ndarray) -> Matrix:
    return np.vectorize(lambda c: Fraction(float(c)), otypes=[object])(x)


def drawn(precision: Precision, shape: tuple[int, ...], n: int) -> np.ndarray:
    """Random numbers, of ordinary and of very different sizes."""
    rng = np.random.default_rng([n, precision.bytes, *shape])
    reach = {"double": 40, "single": 8}[precision.name] * (np.arange(ROWS) % 2)
    numbers = rng.normal(size=(ROWS, *shape))
    exponents = rng.uniform(-1, 1, numbers.shape) * reach.reshape(-1, *[1] * len(shape))
    return (numbers * np.exp2(exponents)).astype(precision.numpy_type)


def sizes_of_merged(Ji, t_ic, Jj, t_jc, D) -> Matrix:
    """The sum of the absolute values of the terms in the stated bound."""
    Ji, t_ic, Jj, t_jc, D = map(np.abs, (Ji, t_ic, Jj, t_jc, D))
    R, c = D[:, :3], D[:, :3] @ t_jc + D[:, 3]
    d, m = c + t_ic, Ji[0] + Jj[0]
    apart = Ji[0] * Jj[0] / m * np.abs(bodies.steiner(d))
    return bodies.inertia(m, Ji[1:4] + Jj[0] * c,
                          bodies.moments(Ji) + R @ bodies.moments(Jj) @ R.T + apart)


def worst(precision: Precision, tier: str, result: np.ndarray, truths: list[Matrix],
          sizes: list[Matrix]) -> float:
    """The largest error, in u times these sums; of the accurate tier the part above 1 u of the
    result, in u² times these sums."""
    u, largest = Fraction(unit(precision)), 0.0
    for got, truth, size in zip(rational(result), truths, sizes, strict=True):
        error = np.abs(got - truth)
        if tier == "accurate":
            error = np.maximum(error - u * np.abs(truth), 0) / u
        largest = max(largest, *(float(e / (u * s)) for e, s in zip(error, size, strict=True) if s))
    return largest


def unit(precision: Precision) -> float:
    return float(np.finfo(precision.numpy_type).eps) / 2


@each_tier
@each_precision
def test_joined_bodies_are_within_the_bound(tier, precision):
    given = [drawn(precision, shape, n) for n, shape in enumerate([(10,), (3,), (10,), (3,),
                                                                  (3, 4)])]
    for J in (given[0], given[2]):
        J[:, 0] = np.abs(J[:, 0])
    exactly = list(zip(*map(rational, given), strict=True))
    result = coscrew.unchecked(TIERS[tier].inertia_merge)(*given)
    assert result.dtype == precision.numpy_type
    k = worst(precision, tier, result, [bodies.merged(*x) for x in exactly],
              [sizes_of_merged(*x) for x in exactly])
    assert k <= MERGED and (tier == "accurate" or k > 2)


@each_tier
@each_precision
@pytest.mark.parametrize("name, truth", [("spatial_inertia_from_inertia", bodies.spatial),
                                         ("inertia_from_spatial_inertia", bodies.centroidal)])
def test_conversions_are_within_the_bound(name, truth, tier, precision):
    given = drawn(precision, (10,), 7)
    exactly = rational(given)
    sizes = []
    for x in exactly:
        own = [abs(c) for c in truth(np.array([*x[:4], *[0] * 6]))[4:]]
        order = [0, 1, 2, 3, 5, 4]  # xy, xz, yz and xy, yz, zx
        sizes.append(np.array([*map(abs, x[:4]), *(np.abs(x[4:])[order] + own)]))
    k = worst(precision, tier, getattr(TIERS[tier], name)(given), list(map(truth, exactly)), sizes)
    assert k <= CONVERTED and (tier == "accurate" or k > 1)


def test_comments_state_the_bounds():
    stated = {op.name: op.tested_bounds for op in OPERATIONS}
    assert f"<= {MERGED} u " in stated["inertia_merge"]
    for name in ("spatial_inertia_from_inertia", "inertia_from_spatial_inertia"):
        assert f"<= {CONVERTED} u " in stated[name]
    header = (INCLUDE / "ksl" / "inertia.h").read_text("utf-8")
    assert len(re.findall(rf"<= {FACTORED} u times the largest\s+moment", header)) == 2


@each_precision
def test_bodies_without_mass_are_no_numbers(precision):
    """NaN where a centre of mass is computed; other results are finite."""
    nothing = np.zeros(10, precision.numpy_type)
    with np.errstate(all="ignore"):
        assert np.isnan(coscrew.spatial_inertia_from_inertia(nothing)[4:]).all()
    assert not coscrew.inertia_transformed(nothing, np.eye(3, 4, dtype=nothing.dtype)).any()


# factors


@pytest.fixture(scope="module", params=COMPILERS)
def factor(request, tmp_path_factory):
    """The rank and L, by ksl_inertia_factor or ksl_inertiaf_factor."""
    library = tmp_path_factory.mktemp("ksl") / "functions.so"
    run((request.param, *C11, "-O2", *STRICT, "-Wno-pedantic", EXACT, "-fPIC", "-shared", "-I",
         INCLUDE, SOURCE, "-o", library, "-lm"))
    functions = ctypes.CDLL(str(library))

    def factored(I: np.ndarray) -> tuple[int, np.ndarray]:
        real = {8: "double", 4: "float"}[I.dtype.itemsize]
        J = np.array(bodies.inertia(3, [4, 5, 6], I), I.dtype)
        rank = getattr(functions, f"factor_{real}")(J.ctypes.data_as(ctypes.c_void_p))
        assert (J[:4] == [3, 4, 5, 6]).all()
        return rank, np.tril(bodies.moments(J).astype(I.dtype))

    return factored


def symmetric(rng, values, n: int) -> np.ndarray:
    """Matrices with these eigenvalues, every third one diagonal."""
    Q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    A = Q * np.array(values, float) @ Q.T if n % 3 else np.diag(rng.permutation(values) * 1.0)
    A = A * 2.0**rng.integers(-40, 40)
    return np.tril(A) + np.tril(A, -1).T


# Eigenvalues of moments: of bodies, rods, points, and along one direction alone.
RANKS = {3: ((3, 2, 1), (1, 1, 1), (2, 1.9, 0.01), (1, 1, 1e-3)), 2: ((1, 1, 0), (2, 1, 0)),
         1: ((1, 0, 0),), 0: ((0, 0, 0),)}


@each_precision
@pytest.mark.parametrize("rank", RANKS)
def test_factors_make_the_moments(rank, precision, factor):
    rng, u, largest = np.random.default_rng(rank), Fraction(unit(precision)), 0.0
    for n in range(240):
        I = symmetric(rng, RANKS[rank][n % len(RANKS[rank])], n).astype(precision.numpy_type)
        result, L = factor(I)
        assert result == rank and (np.diag(L) >= 0).all()
        error = np.abs(rational(L) @ rational(L).T - rational(I)).max()
        largest = max(largest, float(error / (u * rational(np.abs(I)).max())) if rank else error)
    assert largest <= FACTORED


@each_precision
@pytest.mark.parametrize("values", [(1, 1, -1), (2, 1e-1, -1e-1), (-1, -2, -3), (0, 0, -1)])
def test_negative_moments_have_no_factors(values, precision, factor):
    rng = np.random.default_rng(1)
    for n in range(20):
        rank, L = factor(symmetric(rng, values, n).astype(precision.numpy_type))
        assert rank == -1 and np.isnan(L[np.tril_indices(3)]).all()
    rank, L = factor((np.eye(3) * np.nan).astype(precision.numpy_type))
    assert rank == -1


def test_an_integer_factor_comes_back(factor):
    wanted = np.array([[2, 0, 0], [1, 3, 0], [-1, 2, 4]], float)
    rank, L = factor(wanted @ wanted.T)
    assert rank == 3 and np.abs(L - wanted).max() <= 1e-14
