"""Sine and cosine against MPFR: special values, every binade, the numbers nearest to k π/2."""

from fractions import Fraction

import numpy as np
import pytest

from coscrew_codegen.program.elementary import sincos
from coscrew_codegen.program.elementary.evaluation import reduction
from coscrew_codegen.program.elementary.evaluation.reduction import HALF_PI
from coscrew_codegen.program.elementary.proofs import reduction_proof
from coscrew_codegen.program.elementary.proofs.reduction_proof import exponent_of
from coscrew_codegen.program.elementary.sincos import FUNCTION
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from tests.support.each import each_precision
from tests.support.truth.elementary import (
    Array,
    errors,
    results,
    same,
    values,
    worst_cases,
)


def holds(precision: Precision, x: Array) -> None:
    """Sines and cosines are within their error, those of -x the same except the sign."""
    s, c = results(FUNCTION, precision, x)
    for name, got in (("sin", s), ("cos", c)):
        result = errors(name, precision, got, x)
        worst = int(np.argmax(result))
        assert result[worst] <= FUNCTION.error(precision), f"{name} {float(x[worst]).hex()}"
    below = results(FUNCTION, precision, -x)
    assert same(below[0], -s) and same(below[1], c)


def around(x: list[float], precision: Precision) -> Array:
    """Numbers and their neighbours."""
    middle = np.array(x, precision.numpy_type)
    return np.concatenate([middle, *(np.nextafter(middle, middle.dtype.type(end))
                                     for end in (0, np.inf))])


@each_precision
def test_coefficients_are_those_derived(precision: Precision):
    data = sincos.DATA[precision]
    assert sincos.derived(precision) == (data.sine, data.cosine)


@each_precision
def test_the_approximation_is_within_what_is_stated(precision: Precision):
    """Stated as a logarithm to one decimal, so that tenth powers compare."""
    stated = Fraction(2)**int(10 * sincos.DATA[precision].approximation)
    assert stated / 2 < max(sincos.approximations(precision))**10 <= stated


@each_precision
def test_errors_are_proved(precision: Precision):
    stated = FUNCTION.error(precision)
    assert stated - Fraction(1, 500) < sincos.roundings(precision) <= stated


@each_precision
@pytest.mark.parametrize("place", ["near", "far"])
def test_reductions_are_within_what_is_proved(place: str, precision: Precision):
    """r - r_excess against x - k π/2; no number is closer to a multiple than is proved."""
    proved = getattr(reduction_proof, f"{place}_is_proved")(precision)
    first = exponent_of(reduction.limit(precision))
    exponents = np.arange(first) if place == "near" else np.arange(first + 1, precision.bias + 1)
    powers = 2.0**exponents
    x = np.concatenate([
        (np.random.default_rng(4).uniform(1, 2, (len(powers), 6)) * powers[:, None]).ravel(),
        [round(y / np.pi) * np.pi for y in powers], *worst_cases("sincos", precision)])
    x = x[(x > 1) & ((x > 2.0**(first + 1)) == (place == "far"))].astype(precision.numpy_type)
    reduced = values(getattr(reduction, place)(precision), precision, x)
    for given, k, r, excess in zip(*([Fraction(float(z)) for z in y] for y in (x, *reduced)),
                                   strict=True):
        whole = round(given / HALF_PI)
        angle = given - whole * HALF_PI
        assert (whole - k) % 4 == 0
        assert abs(angle) >= reduction_proof.closest(precision, exponent_of(given))
        assert abs(r) <= proved.largest
        assert abs(excess) <= precision.u * abs(r) + proved.excess(abs(angle))
        assert abs(r - excess - angle) <= proved.error(abs(angle)) * abs(angle)


@each_precision
def test_the_closest_multiples_are_closest(precision: Precision):
    """Closer than all others near the first thousand multiples, and as close as some."""
    numbers = [Fraction(float(precision.rounded(k * HALF_PI))) for k in range(1, 1000)]
    distances = [abs(x - k * HALF_PI) for k, x in enumerate(numbers, 1)]
    ratios = [distance / reduction_proof.closest(precision, exponent_of(x))
              for x, distance in zip(numbers, distances, strict=True)]
    assert 1 <= min(ratios) < 1 + Fraction(1, 2**200)


@each_precision
def test_quadrants(precision: Precision):
    """k right angles turn (sin, cos) to the bit, also for the largest k that reductions return."""
    kernel, most = FUNCTION.kernel(precision), 2**(precision.digits // 2 + 2)
    k = np.array([*range(-most, 9 - most), *range(-9, 9), *range(most - 9, most)])
    r, e, numbers = (np.full(k.shape, x, precision.numpy_type) for x in (0.3, 1e-9, 0))
    s, c = values(kernel, precision, numbers, r, e)
    got = values(kernel, precision, k.astype(precision.numpy_type), r, e)
    turned = [s, c, -s, -c]
    for shift, some in enumerate(got):
        assert same(some, np.choose((k + shift) % 4, turned).astype(precision.numpy_type))


@each_precision
def test_special_values(precision: Precision):
    """Signed zeros, subnormal numbers and the next larger ones are their own sines to the bit."""
    tiny = [float(precision.limit(name)) * n for n in (1, 3) for name in (
        "smallest_subnormal", "smallest_normal")]
    x = np.array([0.0, *tiny], precision.numpy_type)
    for given in (x, -x):
        s, c = results(FUNCTION, precision, given)
        assert same(s, given) and same(c, np.ones_like(x))
    for got in results(FUNCTION, precision, np.array([np.inf, -np.inf, np.nan, -np.nan],
                                                     precision.numpy_type)):
        assert np.isnan(got).all()


@each_precision
def test_up_to_the_limit(precision: Precision):
    rng = np.random.default_rng(1)
    limit = float(reduction.limit(precision))
    holds(precision, np.concatenate([
        *(rng.uniform(0, end, 8000) for end in (1, 9, limit)), around([limit], precision),
        np.exp2(rng.uniform(precision.least_exponent, 0, 2000))]).astype(precision.numpy_type))


@each_precision
def test_beyond_the_limit(precision: Precision):
    """In every binade up to the largest number."""
    first = int(np.log2(float(reduction.limit(precision))))
    exponents = np.arange(first, 1 - precision.least_exponent)[:, None]
    mantissas = np.random.default_rng(2).uniform(1, 2, (1, 40 if precision is DOUBLE else 400))
    x = (mantissas * 2.0**exponents).ravel()
    holds(precision, np.concatenate([
        x[x > float(reduction.limit(precision))], [float(precision.limit("max"))],
        2.0**exponents.ravel()[1:]]).astype(precision.numpy_type))


@each_precision
def test_next_to_multiples_of_a_right_angle(precision: Precision):
    """Up to the limit and beyond, in double precision to 2^1000."""
    last = 2**reduction.split(precision).k_bits
    k = [*range(1, 400), *np.geomspace(400, 20 * last, 4000).astype(int).tolist()]
    huge = [m * 2**n for n in range(30, 997, 7) for m in (1, 3, 5)] if precision is DOUBLE else [
        m * 2**n for n in range(14, 124) for m in (1, 3, 5)]
    holds(precision, around([float(n * HALF_PI) for n in (*k, *huge)], precision))


@each_precision
def test_worst_cases(precision: Precision):
    x, = worst_cases("sincos", precision)
    holds(precision, np.abs(x))
