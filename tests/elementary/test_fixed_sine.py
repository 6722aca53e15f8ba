"""Sine and cosine in fixed point: polynomials as fitted, errors as proved, angles at all limits."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest

from coscrew_codegen.program.elementary.proofs.minimax import pi
from coscrew_codegen.program.fixed import fixed_sine
from coscrew_codegen.program.fixed.fixed_arithmetic import sine_and_cosine

CASES = ((30, 1.9), (29, 3.2), (28, 7.9), (24, 127.0), (18, 8191.0))
"""Bits of angles, and the largest."""


def test_the_polynomials_are_fitted():
    assert fixed_sine.derived() == (fixed_sine.SINE, fixed_sine.COSINE)


def test_the_approximations_are_proved():
    for proved, stated in zip(fixed_sine.approximations(), fixed_sine.APPROXIMATION, strict=True):
        assert proved <= stated <= 1.05 * proved


def test_the_constants_are_nearest():
    lower, upper = pi()
    assert round(lower / 2 * 2**31) == round(upper / 2 * 2**31) == fixed_sine.HALF_PI
    assert round(2 / lower * 2**31) == round(2 / upper * 2**31) == fixed_sine.TWO_OVER_PI


def test_reduced_angles_are_in_the_interval_of_the_polynomials():
    """At the largest angle of the least bits, |r| <= π/2 (1/2 + 3/4 2^(1 - bits)) + |k| 2^-32."""
    bits = fixed_sine.LEAST_BITS
    turns = Fraction(2**31, 2**bits) * 2 / pi()[0] + 1
    largest = pi()[1] / 2 * (Fraction(1, 2) + Fraction(3, 4) / 2**(bits - 1)) + turns / 2**32
    assert largest <= fixed_sine.REDUCED
    assert fixed_sine.REDUCED * 2**31 < 2**31 - 2


@pytest.mark.parametrize(("bits", "largest"), CASES)
def test_errors_are_within_the_bound(bits, largest):
    most = int(largest * 2**bits)
    quarters = np.array([int(k * np.pi / 4 * 2**bits) + d for k in range(1, 40)
                         for d in (-1, 0, 1) if k * np.pi / 4 < largest])
    q = np.concatenate([np.random.default_rng(bits).integers(-most, most + 1, 200_000),
                        [0, 1, -1, most, -most], quarters, -quarters])
    bound = fixed_sine.error(bits, largest)
    assert bound is not None
    s, c = sine_and_cosine(q, bits)
    x = q / np.longdouble(2)**bits
    worst = 0.0
    for made, function, exact in ((s, np.sin, mpmath.sin), (c, np.cos, mpmath.cos)):
        error = np.abs(made / np.longdouble(2)**fixed_sine.BITS - function(x))
        at = int(np.argmax(error))
        with mpmath.workdps(50):
            true = exact(mpmath.mpf(int(q[at])) / 2**bits)
            worst = max(worst, float(abs(mpmath.mpf(int(made[at])) / 2**fixed_sine.BITS - true)))
        assert error.max() <= bound
    assert bound / 4 <= worst <= bound


def test_angles_beyond_the_reduction_have_no_bound():
    assert fixed_sine.error(fixed_sine.LEAST_BITS - 1, 1.0) is None
    assert fixed_sine.error(30, np.inf) is None
