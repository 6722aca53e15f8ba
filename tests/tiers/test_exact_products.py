"""Errors of products are the same bits with fma, in halves and in NumPy, whatever the numbers; sums
with products that are exact are the same bits with fma and without."""

import ctypes
from pathlib import Path
from platform import machine

import gmpy2
import numpy as np
import pytest

from coscrew._exact import product_error, product_rest, product_rest_single
from tests.support.compiled.c_harness import EXACT, INCLUDE, run
from tests.support.each import each_compiler

FLAGS = ("-march=x86-64", "-march=native") if machine() == "x86_64" else ("-march=native",)
IEEE = gmpy2.context(precision=53, emax=1024, emin=-1073, subnormalize=True)

C = """
#include <ksl/ksl_exact.h>
void errors(long n, const double *a, const double *b, const double *p, const double *h,
            double *error, double *rest);
void errors(long n, const double *a, const double *b, const double *p, const double *h,
            double *error, double *rest) {
  for (long i = 0; i < n; i++) {
    error[i] = ksl_product_error(a[i], b[i], p[i]);
    rest[i] = ksl_product_rest(a[i], b[i], p[i], h[i]);
  }
}
void sums(long n, const double *a, const double *b, const double *c, double *sum);
void sums(long n, const double *a, const double *b, const double *c, double *sum) {
  for (long i = 0; i < n; i++) { sum[i] = ksl_product_sum(a[i], b[i], c[i]); }
}
int has_fma(void);
int has_fma(void) { return KSL_HAS_FMA; }
"""


def numbers() -> tuple[np.ndarray, ...]:
    """a, b, a b rounded, and h, with a b - h exact except for the product's rounding: factors of
    every size, products near all ends of the range, zeros, infinities, NaN."""
    rng, n = np.random.default_rng(11), 40_000
    a = np.ldexp(rng.uniform(0.5, 1, n) * rng.choice((-1, 1), n), rng.integers(-1074, 1025, n))
    b = np.ldexp(rng.uniform(0.5, 1, n) * rng.choice((-1, 1), n), rng.integers(-1074, 1025, n))
    ends = rng.choice((-1076, -1074, -1060, -1022, -1021, -1000, -969, -968, -967, -900, 994, 996,
                       998, 1022, 1023, 1024), n)
    near = np.arange(n) % 4 != 0
    exponent = np.frexp(a)[1]
    reached = np.clip(ends - exponent + rng.integers(-1, 2, n), -1074, 1024)
    b = np.where(near, np.ldexp(np.frexp(b)[0], reached), b)
    short = np.arange(n) % 3 == 0  # few digits: ties between subnormal numbers
    with np.errstate(over="ignore"):
        a, b = (np.where(short, np.ldexp(np.rint(np.ldexp(np.frexp(x)[0], 5)), np.frexp(x)[1] - 5),
                         x) for x in (a, b))
    special = np.array([0.0, -0.0, np.inf, -np.inf, np.nan, 5e-324, -5e-324, 1e308, -1e308, 1.0])
    pairs = np.array(np.meshgrid(special, special)).reshape(2, -1)
    a, b = np.concatenate([a, pairs[0]]), np.concatenate([b, pairs[1]])
    with np.errstate(all="ignore"):
        p = a * b
        share = p * (1 + np.ldexp(rng.uniform(-1, 1, len(p)), rng.integers(-52, 0, len(p))))
    h = np.where(rng.random(len(p)) < 0.1, p, share)
    zeros = (p == 0) & (rng.random(len(p)) < 0.5)  # of either sign beside either
    return a, b, p, np.where(zeros, -h, h)


def truth(a: float, b: float, c: float) -> float:
    with gmpy2.context(IEEE):
        return float(gmpy2.fms(gmpy2.mpfr(a), gmpy2.mpfr(b), gmpy2.mpfr(c)))


def compiled(folder: Path, compiler: str, flag: str) -> ctypes.CDLL:
    path = folder / f"exact-{compiler}-{flag.strip('-').replace('=', '-')}"
    path.with_suffix(".c").write_text(C)
    run((compiler, "-std=c11", "-O2", EXACT, flag, "-shared", "-fPIC", "-I", INCLUDE,
         f"{path}.c", "-o", f"{path}.so", "-lm"))
    return ctypes.CDLL(f"{path}.so")


def bits(x: np.ndarray) -> np.ndarray:
    return np.where(np.isnan(x), np.nan, x).view(np.uint64)


@pytest.fixture(scope="module")
def rows() -> tuple[np.ndarray, ...]:
    return numbers()


@pytest.fixture(scope="module")
def right(rows: tuple[np.ndarray, ...]) -> tuple[np.ndarray, np.ndarray]:
    a, b, p, h = (x.tolist() for x in rows)
    return (np.array(list(map(truth, a, b, p))), np.array(list(map(truth, a, b, h))))


@pytest.mark.parametrize("flag", FLAGS)
@each_compiler
def test_c_rounds_once(compiler: str, flag: str, rows, right, tmp_path: Path):
    library = compiled(tmp_path, compiler, flag)
    results = [np.empty_like(rows[0]) for _ in right]
    library.errors(ctypes.c_long(len(rows[0])), *(x.ctypes.data_as(ctypes.c_void_p)
                                                  for x in (*rows, *results)))
    assert flag != "-march=x86-64" or not library.has_fma()
    for got, want, c in zip(results, right, (rows[2], rows[3]), strict=True):
        same(got, want, (*rows[:2], c))


def short_factors() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """a, b of single precision, of every size, with zeros, infinities and NaN; c is -a b, near
    it, or a double of any size."""
    rng, n = np.random.default_rng(12), 20_000
    a, b = (np.ldexp(rng.uniform(-1, 1, n), rng.integers(-149, 129, n)).astype(np.float32)
            .astype(np.float64) for _ in range(2))
    special = np.array([0.0, -0.0, np.inf, -np.inf, np.nan, 1e-45, 3.4028234663852886e38, -1.0])
    special = special.astype(np.float32).astype(np.float64)
    pairs = np.array(np.meshgrid(special, special)).reshape(2, -1)
    a, b = np.concatenate([a, pairs[0]]), np.concatenate([b, pairs[1]])
    with np.errstate(all="ignore"):
        less = -a * b
        near = less * (1 + np.ldexp(rng.uniform(-1, 1, len(a)), rng.integers(-52, 3, len(a))))
    any_size = np.ldexp(rng.uniform(-1, 1, len(a)), rng.integers(-1074, 1024, len(a)))
    return a, b, np.choose(rng.integers(0, 3, len(a)), (less, near, any_size))


@pytest.mark.parametrize("flag", FLAGS)
@each_compiler
def test_sums_with_exact_products_round_once(compiler: str, flag: str, tmp_path: Path):
    a, b, c = short_factors()
    result = np.empty_like(a)
    compiled(tmp_path, compiler, flag).sums(ctypes.c_long(len(a)), *(
        x.ctypes.data_as(ctypes.c_void_p) for x in (a, b, c, result)))
    with gmpy2.context(IEEE):
        wanted = np.array([float(gmpy2.fma(*map(gmpy2.mpfr, row)))
                           for row in zip(a.tolist(), b.tolist(), c.tolist(), strict=True)])
    same(result, wanted, (a, b, c))


def test_numpy_rounds_once(rows, right):
    a, b, p, h = rows
    same(product_error(a, b, p), right[0], (a, b, p))
    same(product_rest(a, b, p, h), right[1], (a, b, h))


def test_numpy_rounds_once_in_single_precision():
    """h is a product's share of a sum, as the errors of sums have it."""
    rng, n = np.random.default_rng(13), 20_000
    a, b, c = (np.ldexp(rng.uniform(-1, 1, n), rng.integers(-20, 20, n)).astype(np.float32)
               for _ in range(3))
    p = a * b
    h = p + c - (p + c - p)
    with gmpy2.context(precision=24, emax=128, emin=-148, subnormalize=True):
        wanted = [float(gmpy2.fms(*map(gmpy2.mpfr, row))) for row in zip(
            a.tolist(), b.tolist(), h.tolist(), strict=True)]
    assert product_rest_single(a, b, p, h).tolist() == wanted


def same(got: np.ndarray, want: np.ndarray, inputs: tuple[np.ndarray, ...]) -> None:
    wrong = np.flatnonzero(bits(got) != bits(want))
    assert not len(wrong), (len(wrong), [x[wrong[0]].hex() for x in (*inputs, got, want)])


def test_of_one_number():
    assert product_error(1e308, 1.1, 1e308 * 1.1) == truth(1e308, 1.1, 1e308 * 1.1)
    assert product_error(np.float64(3), 0.1, np.float64(3) * 0.1) == truth(3, 0.1, 3 * 0.1)
