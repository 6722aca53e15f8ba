"""Sine and cosine: within their proved error of the true values, with the right signs of zero."""

import mpmath
import numpy as np
import pytest

from coscrew_codegen.elementary import reduction
from coscrew_codegen.elementary.sincos import FUNCTION
from coscrew_codegen.formats import PRECISIONS, Precision
from tests.support.elementary import Array, on_arrays, ulps

DIGITS = 420  # decimal: those of the largest number before the point, and 60 after it


@pytest.fixture(params=PRECISIONS, ids=lambda x: x.name)
def precision(request: pytest.FixtureRequest) -> Precision:
    return request.param


def near(x: Array, precision: Precision) -> tuple[Array, ...]:
    """Sine and cosine up to the limit."""
    assert FUNCTION.near is not None
    kernel = on_arrays(FUNCTION.kernel(precision), precision)
    return kernel(*on_arrays(FUNCTION.near(precision), precision)(x))


def holds(x: Array, results: tuple[Array, ...], precision: Precision) -> None:
    """Sines and cosines are within their error."""
    with mpmath.workdps(DIGITS):
        for got, function in zip(results, (mpmath.sin, mpmath.cos), strict=True):
            errors = ulps(got.tolist(), [function(mpmath.mpf(float(y))) for y in x], precision)
            worst = int(np.argmax(errors))
            assert errors[worst] <= FUNCTION.error(precision), (
                f"{function.__name__} {float(x[worst]).hex()}: {errors[worst]} ulp")


def array(values: object, precision: Precision) -> Array:
    return np.asarray(values, getattr(np, precision.numpy_type))


def test_near_multiples_of_a_right_angle(precision: Precision) -> None:
    """The numbers nearest to k π/2, and their neighbours, evenly spread over k."""
    last = 2**reduction.split(precision).k_bits - 1
    k = sorted({*range(200), *np.geomspace(200, last, 500).astype(int).tolist(), last})
    x = array([float(n * reduction.HALF_PI) for n in k], precision)
    up, down = (np.nextafter(x, array(y, precision)) for y in (np.inf, -np.inf))
    points = np.concatenate([x, up, down, -x])
    holds(points, near(points, precision), precision)


def test_up_to_the_limit(precision: Precision) -> None:
    rng = np.random.default_rng(1)
    assert FUNCTION.limit is not None
    limit = float(FUNCTION.limit(precision))
    x = array(np.concatenate([rng.uniform(-1, 1, 700), rng.uniform(-9, 9, 700),
                              rng.uniform(-limit, limit, 700), [limit, -limit],
                              np.exp2(rng.uniform(precision.least_exponent, 0, 300))]), precision)
    holds(x, near(x, precision), precision)


def test_tiny_arguments_are_their_own_sines(precision: Precision) -> None:
    """Zeros of both signs and subnormal numbers among them, to the bit."""
    x = array([0.0, -0.0, *(float(precision.limit(name)) * n for n in (-3, -1, 1, 3) for name in (
        "smallest_subnormal", "smallest_normal"))], precision)
    s, c = near(x, precision)
    assert s.tobytes() == x.tobytes()
    assert (c == 1).all()
