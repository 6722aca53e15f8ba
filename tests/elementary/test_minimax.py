"""Fits are derived again, and their proofs hold against values they know nothing of."""

from fractions import Fraction

import mpmath
import pytest

from coscrew_codegen.program.elementary import atan2, exp, tanh
from coscrew_codegen.program.elementary.proofs.minimax import (
    bernstein,
    difference,
    exact,
    fitted,
    fitted_denominator,
    ln2,
    pi,
    product,
    rounded,
    supremum,
)
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision

HALF = (Fraction(-1, 2), Fraction(1, 2))


@each_precision
def test_coefficients_are_those_derived(precision: Precision):
    assert exp.derived(precision) == exp.DATA[precision].q
    assert tanh.derived(precision) == (tanh.DATA[precision].p, tanh.DATA[precision].q)
    assert atan2.derived(precision) == atan2.DATA[precision].p


@each_precision
def test_approximations_are_within_what_is_stated(precision: Precision):
    """Stated as a logarithm to one decimal, so that tenth powers compare."""
    for function in (exp, tanh, atan2):
        stated = Fraction(2)**int(10 * function.DATA[precision].approximation)
        assert stated / 2 < function.approximation(precision)**10 <= stated, function.__name__


def test_the_least_largest_error_of_a_known_polynomial():
    """x^5 by degree 4: the error is a Chebyshev polynomial, 2^-4 on [-1, 1]."""
    with mpmath.workdps(60):
        result = fitted(lambda x: x**5, lambda x: 1, (Fraction(-1), Fraction(1)), 4, 200)
    want = [0, Fraction(-5, 16), 0, Fraction(5, 4), 0]
    assert all(abs(a - b) < Fraction(1, 500) for a, b in zip(result, want, strict=True))
    error = supremum(difference([Fraction(0)] * 5 + [Fraction(1)], result), [Fraction(1)],
                     (Fraction(-1), Fraction(1)), 512)
    assert Fraction(1, 16) < error < Fraction(1003, 16000)


def test_a_fraction_is_found_again():
    """(1 + x/3) / (1 + x/7), which is its own best approximation except 2^-40 of cos 9x."""
    denominator = fitted_denominator(
        lambda x: (1 + x / 3) / (1 + x / 7) + mpmath.mpf(2)**-40 * mpmath.cos(9 * x),
        lambda x: 1, HALF, (1, 1), 60)
    assert denominator[0] == 1 and abs(denominator[1] - Fraction(1, 7)) < Fraction(1, 2**30)


def test_coefficients_are_rounded_to_nearest():
    for digits in (24, 53):
        assert rounded(Fraction(2**digits + 1), digits) == 2**digits
        assert rounded(Fraction(-2**digits - 3), digits) == -2**digits - 4
        assert rounded(Fraction(1, 3), digits) == Fraction(round(Fraction(2**(digits + 1), 3)),
                                                           2**(digits + 1))
    assert float(rounded(Fraction(1, 10), 53)) == 0.1


def test_bernstein_coefficients_bound_a_polynomial():
    p = [Fraction(x) for x in (3, -7, 1, 5, -2)]
    lower, upper = Fraction(-2, 3), Fraction(5, 7)
    result = bernstein(p, (lower, upper))
    values = [sum(c * x**i for i, c in enumerate(p))
              for x in (lower + (upper - lower) * Fraction(k, 40) for k in range(41))]
    assert result[0] == values[0] and result[-1] == values[-1]
    assert min(result) <= min(values) and max(values) <= max(result)
    assert product([Fraction(1), Fraction(2)], [Fraction(3), Fraction(4)]) == [3, 10, 8]


def test_a_bound_over_a_denominator_that_may_vanish_is_refused():
    with pytest.raises(ValueError, match="may not be positive"):
        supremum([Fraction(1)], [Fraction(0), Fraction(1)], HALF)


@pytest.mark.parametrize("enclosed, value", [(ln2, mpmath.log), (pi, None)])
def test_constants_lie_between_their_bounds(enclosed, value):
    with mpmath.workdps(150):
        true = exact(mpmath.log(2) if value else +mpmath.pi)
        lower, upper = enclosed()
        assert lower < true < upper < lower + Fraction(1, 2**300)
