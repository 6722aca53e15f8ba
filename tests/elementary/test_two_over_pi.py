"""The digits of 2/π: their value, their places, and how generated Python finds them."""

from fractions import Fraction
from importlib import import_module

import mpmath
import numpy as np

from coscrew_codegen.program.elementary.proofs.minimax import exact
from coscrew_codegen.program.two_over_pi import EXTRA, chunk, chunks, pi
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision


def test_pi_to_many_digits():
    with mpmath.workprec(2600):
        for bits in (50, 300, 2400):
            assert abs(pi(bits) - exact(+mpmath.pi)) < Fraction(1, 2**bits)


@each_precision
def test_the_first_chunks_are_two_over_pi_rounded(precision: Precision):
    some, total = chunks(precision.digits), Fraction(0)
    with mpmath.workprec(2600):
        true = exact(2 / mpmath.pi)
    for n, value in enumerate(some.values):
        unit = Fraction(2)**(-some.bits * (n - 1))
        total += value / 2**some.scale
        assert abs(total - true) <= unit / 2
        assert value == 0 or precision.smallest_normal <= abs(value) <= precision.limit("max")


@each_precision
def test_every_exponent_finds_its_chunks(precision: Precision):
    """The generated Python finds them for every exponent, up to infinity and NaN, which find some.
    """
    generated = import_module(f"coscrew._elementary_{precision.name}").two_over_pi
    x = 1.75 * 2.0**np.arange(2, precision.bias + 1)
    x = np.concatenate([x, [np.inf, np.nan]]).astype(precision.numpy_type)
    for n in range(EXTRA + 1):
        result = np.asarray(generated(x, n))
        assert result.dtype == x.dtype and np.isfinite(result).all()
        assert result[:-2].tolist() == [
            float(chunk(Fraction(float(y)), n, precision.digits)) for y in x[:-2]]
