"""The kernels' promises in double and single precision: error bounds, exact zeros, norms."""

from fractions import Fraction
from functools import cache
from itertools import product

import mpmath
import numpy as np
import pytest
import sympy as sp

import coscrew
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program import Op
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.support.cases import for_all
from tests.support.each import each_precision
from tests.support.sampling import inputs_of
from tests.support.truth.attack import plain_program
from tests.support.truth.exact import FORMULAS, Matrix, array

TABLE = {op.name: op for op in OPERATIONS}
LINEAR, ANGULAR = slice(0, 3), slice(3, 6)
SPATIAL_NORMS = (("screw_norm", ANGULAR, LINEAR), ("coscrew_norm", LINEAR, ANGULAR))

POLYNOMIAL = [op for op in OPERATIONS
              if set(plain_program(op).counts) <= {Op.ADD, Op.SUB, Op.MUL, Op.NEG}]

each_norm = pytest.mark.parametrize("name, first", [
    ("vec3_l2norm", LINEAR), ("vec4_l2norm", slice(0, 4)), ("quaternion_norm", slice(0, 4)),
    *((name, first) for name, first, _ in SPATIAL_NORMS)])


@cache
def terms(operation: Operation) -> tuple[list[tuple[Fraction, list[int]]], ...]:
    """Each component of the exact result as a sum of (coefficient, numbers of its factors)."""
    arguments = [np.array(a.symbols).reshape(a.quantity.shape) for a in operation.inputs]
    symbols = [s for a in operation.inputs for s in a.symbols]
    if operation.name in ("product_Adinvs", "product_CoAdinvc"):  # for R that is rounded, too
        wanted = FORMULAS[operation.name](*arguments)
    else:
        wanted = operation.truth()
    return tuple([(Fraction(int(c.p), int(c.q)), np.repeat(range(len(symbols)), powers).tolist())
                  for powers, c in sp.Poly(x, *symbols).terms()] for x in wanted)


def flat(arrays: tuple[np.ndarray, ...]) -> np.ndarray:
    """All components of a call in one row."""
    return np.hstack([x.reshape(len(x), -1) for x in arrays])


def value_and_size(polynomial: list, numbers: list[Fraction]) -> tuple[Fraction, Fraction]:
    """x, the sum of the terms, and S, the sum of their absolute values."""
    value = size = Fraction(0)
    for coefficient, factors in polynomial:
        for i in factors:
            coefficient = coefficient * numbers[i]
        value, size = value + coefficient, size + abs(coefficient)
    return value, size


@pytest.mark.parametrize("operation", POLYNOMIAL, ids=lambda op: op.name)
@for_all(precision=PRECISIONS)
def test_error_is_within_bound(operation, precision):
    """|err| <= u|x| + 8 u S, and η M^d for each of d roundings of n terms that may underflow."""
    inputs = inputs_of(operation, precision, 60)
    with np.errstate(all="ignore"):
        value = coscrew.unchecked(getattr(coscrew, operation.name))(*inputs)
    value = flat(value if isinstance(value, tuple) else (value,))
    rows, info = flat(inputs), np.finfo(precision.numpy_type)
    u, eta = Fraction(float(info.eps)) / 2, Fraction(float(info.smallest_subnormal))
    assert value.dtype == info.dtype
    d = max(len(factors) for polynomial in terms(operation) for _, factors in polynomial)
    checked = 0
    finite = np.isfinite(rows).all(axis=1)
    for row, results in zip(rows[finite], value[finite], strict=True):
        numbers = [Fraction(float(x)) for x in row]
        M = max(1, *map(abs, numbers))
        for polynomial, result in zip(terms(operation), results, strict=True):
            n = len(polynomial)
            if n * M**d > Fraction(float(info.max)) / 2:
                continue  # may overflow
            x, S = value_and_size(polynomial, numbers)
            error = abs(Fraction(float(result)) - x)
            assert error <= u * abs(x) + 8 * u * S + n * d * eta * M**d, \
                f"{float(error / u / (S or 1)):.3g} u S at {[float(v).hex() for v in row]}"
            checked += 1
    assert checked >= 4 * len(results)


@each_precision
@pytest.mark.parametrize("name", ["cross_vv", "cross_ss"])
def test_bracket_of_equal_arguments_is_positive_zero(name, precision):
    """This holds as long as the products of components are finite."""
    a = finite_squares(inputs_of(TABLE[name], precision, 20_000)[0])
    result = getattr(coscrew, name)(a, a)
    assert len(a) > 5000 and not result.view(f"u{precision.bytes}").any()


@each_precision
@pytest.mark.parametrize("name", ["cross_vv", "cross_ss"])
def test_rounded_bracket_is_antisymmetric(name, precision):
    a, b = (finite_squares(x) for x in inputs_of(TABLE[name], precision, 20_000))
    n = min(len(a), len(b))
    with np.errstate(over="ignore"):
        forward, backward = (getattr(coscrew, name)(*x) for x in ((a[:n], b[:n]), (b[:n], a[:n])))
    assert np.array_equal(forward, -backward, equal_nan=True)


def finite_squares(rows: np.ndarray) -> np.ndarray:
    with np.errstate(all="ignore"):
        return rows[np.isfinite(rows * rows).all(axis=1)]


# norms


@each_precision
def test_quotient_is_rounded_twice(precision):
    """product_ainvv: |err| <= (2u + u²)|x|."""
    k, v = ordinary(precision, 1), ordinary(precision, 3)
    for k_i, v_i, value in zip(k[:, 0], v, coscrew.product_ainvv(k[:, 0], v), strict=True):
        for x, result in zip(fractions(v_i) / Fraction(float(k_i)), fractions(value), strict=True):
            assert abs(result - x) <= ((1 + half_ulp(precision))**2 - 1) * abs(x)


@each_precision
def test_dc_is_sine_and_cosine(precision):
    """|err| <= 4 ulp, NumPy's promise; the C library's is better."""
    theta = np.append(100 * ordinary(precision, 1)[:, 0], np.zeros(1, precision.numpy_type))
    with mpmath.workdps(50):
        for angle, value in zip(theta.tolist(), coscrew.dc(theta), strict=True):
            for x, result in zip((mpmath.sin(angle), mpmath.cos(angle)), value, strict=True):
                assert abs(mpmath.mpf(float(result)) - x) <= 4 * abs(float(np.spacing(result)))


@each_norm
@each_precision
def test_normalized_has_unit_norm(name, first, precision):
    """||x| - norm| <= 3u |x|;  components x_i / norm, rounded once;  ||x^| - 1| <= 4u."""
    kind, u = name.split("_")[0], half_ulp(precision)
    x = ordinary(precision, TABLE[name].inputs[0].quantity.size)
    norms, unit = getattr(coscrew, name)(x), getattr(coscrew, f"{kind}_normalized")(x)
    assert np.array_equal(getattr(coscrew, f"{kind}_normalize")(x), unit)
    for row, norm, result in zip(x, norms, unit, strict=True):
        row, norm, result = fractions(row), Fraction(float(norm)), fractions(result)
        square = row[first] @ row[first]
        assert (1 - 3*u)**2 * square <= norm**2 <= (1 + 3*u)**2 * square
        assert all(abs(result - row / norm) <= u * abs(row / norm))
        assert (1 - 4*u)**2 <= result[first] @ result[first] <= (1 + 4*u)**2


@each_norm
@each_precision
def test_norm_of_zero_and_nan(name, first, precision):
    zero = np.zeros(TABLE[name].inputs[0].quantity.size, precision.numpy_type)
    norm, unit = getattr(coscrew, name), getattr(coscrew, f"{name.split('_')[0]}_normalized")
    assert norm(zero) == 0 and not unit(zero).any()
    for i in range(len(zero)):
        spoiled = zero.copy()
        spoiled[i] = np.nan
        with np.errstate(invalid="ignore"):
            assert np.isnan(norm(spoiled)) and np.isnan(unit(spoiled)).all()


@pytest.mark.parametrize("name, first, second", SPATIAL_NORMS)
@each_precision
def test_norm_turns_to_the_other_part_below_the_threshold(name, first, second, precision):
    number = np.dtype(precision.numpy_type).type
    threshold = number(1e-9 if precision.name == "double" else 1e-6)
    x = np.zeros(6, number)
    x[second] = 3, -4, 12
    for signs in product((-1, 1), repeat=3):
        x[first] = np.array(signs, number) * np.nextafter(threshold, number(0))
        assert getattr(coscrew, name)(x) == 13
        for normalized in (f"{name}alized", f"{name}alize"):
            assert np.array_equal(getattr(coscrew, normalized)(x), x / number(13))
        for i in range(3):
            at = x.copy()
            at[first] = np.eye(3, dtype=number)[i] * signs[i] * threshold
            assert abs(getattr(coscrew, name)(at) - threshold) <= np.spacing(threshold)
            at[second] = np.nan
            assert abs(getattr(coscrew, name)(at) - threshold) <= np.spacing(threshold)


def half_ulp(precision: Precision) -> Fraction:
    """u, the unit roundoff."""
    return Fraction(float(np.finfo(precision.numpy_type).eps)) / 2


def fractions(x: np.ndarray) -> Matrix:
    return array([Fraction(float(component)) for component in x])


def ordinary(precision: Precision, n: int) -> np.ndarray:
    """200 rows of n numbers between 2^-8 and 2^8, of either sign."""
    rng = np.random.default_rng(n)
    x = np.exp2(rng.uniform(-8, 8, (200, n))) * rng.choice((-1, 1), (200, n))
    return x.astype(precision.numpy_type)
