"""Shared parts of error analyses: bounds that round up, and the error of a product."""

from fractions import Fraction
from itertools import product
from math import inf

import numpy as np
import pytest

from coscrew_codegen.program.roundoff import Upward, product_error

SAMPLE = np.random.default_rng(1).uniform(0, 1, 200) * 2.0**np.random.default_rng(2).integers(
    -60, 60, 200)


def exactly(x: float) -> Fraction:
    return Fraction(float(x))


@pytest.mark.parametrize("a, b", SAMPLE.reshape(-1, 2).tolist())
def test_sums_and_products_are_no_less_and_hardly_more(a: float, b: float):
    x, y = Upward(a), Upward(b)
    for result, exact in ((x + y, exactly(a) + exactly(b)), (x * y, exactly(a) * exactly(b))):
        assert isinstance(result, Upward)
        assert exact <= exactly(result) <= exact * (1 + Fraction(1, 2**51))


def test_zero_is_exact_also_times_infinity():
    zero, some, endless = Upward(0), Upward(0.1), Upward(inf)
    assert some + zero == some and zero * endless == 0 and endless * zero == 0
    assert some + endless == inf and isinstance(zero * endless, Upward)


def test_no_product_moves_further_and_some_do_as_far():
    """All factors at the ends of their ranges are tried."""
    (a, error_a), (b, error_b) = (Fraction(7, 3), Fraction(2, 5)), (Fraction(5, 11), Fraction(3, 7))
    moved = [abs((x + dx) * (y + dy) - x * y) for x, dx, y, dy in product(
        (a, -a, 0), (error_a, -error_a, 0), (b, -b, 0), (error_b, -error_b, 0))]
    assert max(moved) == product_error(a, error_a, b, error_b)


def test_bounds_of_products_round_up():
    """In floats, as for fractions."""
    sizes = [Upward(x) for x in SAMPLE[:8]]
    for a, da, b, db in product(sizes[:4], sizes[4:6], sizes[2:6], sizes[6:]):
        exact = product_error(*map(exactly, (a, da, b, db)))
        assert exact <= exactly(product_error(a, da, b, db)) <= exact * (1 + Fraction(1, 2**49))
