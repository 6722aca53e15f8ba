"""Errors of sine and cosine, against MPFR: with their errors they have twice the digits."""

from fractions import Fraction
from math import log2

import numpy as np
import pytest

from coscrew_codegen.program.elementary import atan2_error, sincos, sincos_error
from coscrew_codegen.program.elementary.evaluation import reduction, reduction_pairs, sincos_pairs
from coscrew_codegen.program.elementary.evaluation.reduction import HALF_PI
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision
from tests.support.truth.elementary import Array, remaining, results, values, worst_cases


def computed(x: Array, precision: Precision) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """The sine with its error, and the cosine."""
    s, c = results(sincos.FUNCTION, precision, x)
    s_error, c_error = results(sincos_error.ERROR, precision, x, s, c)
    return (s, s_error), (c, c_error)


def holds(x: Array, precision: Precision) -> float:
    """Asserts that both are within the proved bounds; returns log2 of the worst."""
    stated, worst = log2(sincos_error.error(precision)), -np.inf
    for name, (got, rest) in zip(("sin", "cos"), computed(x, precision), strict=True):
        result = remaining(name, got, rest, x)
        at = int(np.argmax(result))
        assert result[at] <= stated, f"{name} {float(x[at]).hex()}: 2^{result[at]:.2f}"
        worst = max(worst, result[at])
    return worst


def hard(precision: Precision) -> Array:
    """Numbers next to multiples of a right angle, up to the largest."""
    rng, top = np.random.default_rng(11), precision.bias - 1
    multiples = [*range(1, 600), *(int(x) for x in 2.0**rng.uniform(10, 22, 400)),
                 *(m * 2**n for n in range(10, top, 5) for m in (1, 3, 5) if m * 2**n < 2**top / 8)]
    middle = np.array([float(k * HALF_PI) for k in multiples], precision.numpy_type)
    return np.concatenate([middle, np.nextafter(middle, middle.dtype.type(0)),
                           *worst_cases("sincos", precision)])


@each_precision
def test_results_with_their_errors_have_twice_the_digits(precision: Precision):
    """Below and beyond the limit, in all binades, for ordinary numbers and numbers next to right
    angles."""
    rng = np.random.default_rng(10)
    limit, top = float(reduction.limit(precision)), precision.bias
    x = np.concatenate([rng.uniform(-9, 9, 2000), rng.uniform(-limit, limit, 2000),
                        2.0**rng.uniform(-precision.digits - 4, 4, 2000),
                        -(2.0**rng.uniform(-top, top, 3000)), [limit, np.nextafter(limit, 9e9)]])
    worst = max(holds(x.astype(precision.numpy_type), precision), holds(hard(precision), precision))
    assert worst > log2(sincos_error.error(precision)) - 5, "so tight is the bound"


@each_precision
def test_errors_are_stated_as_they_are_proved(precision: Precision):
    """About u², and what comments say is rounded up."""
    proved = log2(sincos_error.error(precision))
    assert -2 * precision.digits < proved < 6 - 2 * precision.digits
    stated = float(sincos_error.comment(precision).split("within 2^")[1].split()[0])
    assert proved <= stated < proved + 0.1


@each_precision
@pytest.mark.parametrize("place", ["first", "near", "far"])
def test_reductions_are_within_what_is_proved(place: str, precision: Precision):
    """Results of atan2 come first: the distances next to them have all magnitudes."""
    x, ends = np.abs(hard(precision)), [0, atan2_error.LARGEST, reduction.limit(precision), np.inf]
    at, name = ("first", "near", "far").index(place), "far" if place == "far" else "near"
    beside = (n * HALF_PI * (1 + Fraction(3, 2**m)) for n in (1, 2) for m in range(9, 60))
    x = np.concatenate([x, np.array([float(y) for y in beside], x.dtype)])
    x = x[(x > float(ends[at])) & (x <= float(ends[at + 1]))]
    spread = (reduction_pairs.near_spread(precision, atan2_error.LARGEST) if place == "first" else
              getattr(reduction_pairs, f"{place}_spread")(precision))
    result = values(getattr(reduction_pairs, name)(precision), precision, x)
    for row in zip(x.tolist(), *(y.tolist() for y in result), strict=True):
        given, k, r, low = map(Fraction, row)
        whole = round(given / HALF_PI)
        angle = given - whole * HALF_PI
        assert (whole - k) % 4 == 0
        assert abs(r) <= min(spread.high * abs(angle), sincos_pairs.ANGLE)
        assert abs(low) <= spread.low * abs(angle)
        assert abs(r + low - angle) <= spread.error * abs(angle)


@each_precision
def test_special_values(precision: Precision):
    """0 where sines are exact or their errors have too few digits; NaN where the result is."""
    tiny = [float(precision.limit(name)) for name in ("smallest_subnormal", "smallest_normal")]
    x = np.array([0.0, -0.0, *tiny, *(-y for y in tiny), 1e-30], precision.numpy_type)
    for _, rest in computed(x, precision):
        assert (rest == 0).all()
    for _, rest in computed(np.array([np.inf, -np.inf, np.nan], precision.numpy_type), precision):
        assert np.isnan(rest).all()


@each_precision
def test_parts_of_a_right_angle(precision: Precision):
    """Their sum is π/2 to the stated bound; products with any k are exact."""
    data, k = reduction_pairs.parts(precision), 2**reduction.split(precision).k_bits - 1
    assert abs(HALF_PI - sum(data.parts) - data.rest) == data.missing
    for part in data.parts:
        assert (k * part).numerator.bit_length() <= precision.digits
