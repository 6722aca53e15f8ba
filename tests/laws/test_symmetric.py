"""Symmetric solvers: singular matrices get no answer, regular ones do, errors are as stated."""

from functools import cache

import numpy as np
import pytest
from gmpy2 import mpq

import coscrew
import coscrew.accurate
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.algebra.operations.symmetric import BACKWARD, FACTOR
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision

ROWS = 4000
WELL = {"double": 14, "single": 5}  # decimal digits of the condition up to which nothing is refused
BITS = {"double": 11, "single": 4}  # of integers, so that sums of products are exact

each_kind = pytest.mark.parametrize("kind, n", [("mat3x3", 3), ("mat6x6", 6)])
each_tier = pytest.mark.parametrize("tier", [coscrew, coscrew.accurate], ids=["plain", "accurate"])


def singular(precision: Precision, n: int) -> np.ndarray:
    """G G^T of integer matrices G whose rank is below the number of rows, half of them scaled by
    powers of two: exact."""
    numbers, top = np.random.default_rng(n), 2**BITS[precision.name]
    rows = []
    for number in range(ROWS):
        G = numbers.integers(-top, top, (n, numbers.integers(1, n)))
        d = np.exp2(numbers.integers(-20, 20, n) * (number % 2))
        rows.append((G @ G.T) * np.outer(d, d))
    exact = np.array(rows)
    result = exact.astype(precision.numpy_type)
    assert (result == exact).all()
    return result


@cache
def regular(precision: Precision, n: int) -> tuple[np.ndarray, np.ndarray]:
    """A with eigenvalues spread evenly, all large but one, all small but one, and b."""
    numbers = np.random.default_rng([n, precision.bytes])
    rows = []
    for number in range(ROWS):
        Q, _ = np.linalg.qr(numbers.normal(size=(n, n)))
        least = 10.0**-numbers.uniform(0, WELL[precision.name])
        first = np.arange(n) == 0
        values = (np.geomspace(1, least, n), np.where(first, least, 1), np.where(first, 1, least))
        A = (Q * values[number % 3]) @ Q.T
        rows.append(np.tril(A) + np.tril(A, -1).T)
    return (np.array(rows).astype(precision.numpy_type),
            numbers.normal(size=(ROWS, n)).astype(precision.numpy_type))


@each_tier
@each_kind
@each_precision
def test_no_singular_matrix_gets_an_answer(tier, kind, n, precision):
    A = singular(precision, n)
    with np.errstate(all="ignore"):
        pivot, x = getattr(tier, f"{kind}_solve")(A, np.ones((ROWS, n), A.dtype))
    assert np.isnan(x).all() and (pivot <= 0).all()
    with np.errstate(all="ignore"):
        pivot, _ = getattr(coscrew, f"{kind}_ldl")(A)
    assert (pivot > 0).any()  # the factor alone does not show it


@each_tier
@each_kind
@each_precision
def test_no_regular_matrix_is_refused(tier, kind, n, precision):
    A, b = regular(precision, n)
    pivot, x = getattr(tier, f"{kind}_solve")(A, b)
    assert np.isfinite(x).all() and (pivot > 0).all()


@each_kind
def test_nothing_that_is_no_number_gets_an_answer(kind, n):
    for bad in (np.nan, np.inf):
        A = np.eye(n)
        A[n - 1, 0] = bad
        with np.errstate(all="ignore"):
            _, x = getattr(coscrew, f"{kind}_solve")(A, np.ones(n))
        assert np.isnan(x).all()


def residual_in_u(A: np.ndarray, b: np.ndarray, x: np.ndarray, u: float) -> float:
    """The largest |b - A x|_i / Σ_j sqrt(a_ii a_jj) |x_j|, the residual exactly."""
    residual = np.abs(rational(b) - (rational(A) * rational(x)[:, None, :]).sum(axis=2))
    roots = np.sqrt(np.einsum("kii->ki", A.astype(float)))
    size = roots * (roots * np.abs(x.astype(float))).sum(axis=1)[:, None]
    return float((residual.astype(float) / size).max() / u)


def rational(x: np.ndarray) -> np.ndarray:
    """Floats, or rationals, as exact rationals."""
    return np.vectorize(lambda c: c if isinstance(c, mpq) else mpq(float(c)), otypes=[object])(x)


@each_kind
@each_precision
def test_backward_errors_are_as_stated(kind, n, precision):
    (A, b), u = regular(precision, n), np.finfo(precision.numpy_type).eps / 2
    _, x = getattr(coscrew, f"{kind}_solve")(A, b)
    _, packed = getattr(coscrew, f"{kind}_ldl")(A)
    y = getattr(coscrew, f"{kind}_ldl_solve")(packed, b)
    D = rational(np.einsum("kii->ki", packed))
    L = rational(np.tril(packed, -1) + np.eye(n))
    product = ((L * D[:, None, :])[:, :, None, :] * L[:, None, :, :]).sum(axis=3)
    roots = np.sqrt(np.einsum("kii->ki", A.astype(float)))
    defect = np.abs(product - rational(A)).astype(float)
    factor = defect / (roots[:, :, None] * roots[:, None, :])
    assert FACTOR[n] / 4 < factor.max() / u <= FACTOR[n]
    for result in (residual_in_u(A, b, x, u), residual_in_u(product, b, y, u)):
        assert BACKWARD / 4 < result <= BACKWARD


@each_kind
def test_comments_state_them(kind, n):
    stated = {op.name: op.tested_bounds for op in OPERATIONS}
    assert f"<= {FACTOR[n]} u sqrt(a_ii a_jj)" in stated[f"{kind}_ldl"]
    for name in ("solve", "ldl_solve"):
        assert f"<= {BACKWARD} u Σ_j sqrt(a_ii a_jj)" in stated[f"{kind}_{name}"]
        documented = " ".join(getattr(coscrew, f"{kind}_{name}").__doc__.split())
        assert stated[f"{kind}_{name}"] in documented
    assert stated["spatial_inertia_com"] == "Error <= u |result|, barring over- and underflow."
