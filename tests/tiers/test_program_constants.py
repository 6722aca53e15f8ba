"""Constants and operations of Programs: which constants are rounded, and which are powers of two,
so that products with them are exact, without error and bound; how operations are counted; how far
the rest of a product moves with its operands.

The truth of the first comes from quotients of 1000 bits, that of the last from differences of exact
fractions.
"""

from collections.abc import Callable
from fractions import Fraction

import mpmath
import pytest

from coscrew_codegen.program import Constant, Input, Instruction, NotANumber, Op, Operand, Ref
from coscrew_codegen.program.program import in_words, is_power_of_two, is_rounded, scales
from tests.support.truth.condition import Functions

NUMBERS = [sign * Fraction(n, d) for sign in (1, -1) for n in (1, 2, 3, 5, 7, 8, 12, 2**70, 3**40)
           for d in (1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 1000, 1024, 2**70, 3 * 2**60, 10**20)]
POWERS = [Fraction(2)**k for k in range(-130, 131)]
X = Input(0, 0)


def same(value: Fraction) -> Constant:
    return Constant(value, value)


def product(a: Operand, b: Operand, op: Op = Op.MUL) -> Instruction:
    return Instruction("p", op, (a, b), "p")


@pytest.mark.parametrize("value", [*NUMBERS, *POWERS[::13], Fraction(0)], ids=str)
def test_binary_fractions_are_not_rounded(value: Fraction):
    with mpmath.workprec(1000):
        quotient = mpmath.mpf(value.numerator) / value.denominator
        binary = Fraction(*mpmath.libmp.to_rational(quotient._mpf_)) == value
    assert is_rounded(same(value)) is not binary


def test_what_is_no_constant_is_not_rounded():
    assert not any(map(is_rounded, (X, Ref("x"), NotANumber())))


@pytest.mark.parametrize("k", range(-130, 131, 10))
def test_powers_of_two_and_nothing_else_scale(k: int):
    """Neighbours, multiples and opposites of powers of two do not; a power counts only if both
    precisions have it."""
    power = Fraction(2)**k
    assert is_power_of_two(same(power)) and scales(product(X, same(power)))
    assert scales(product(same(power), X))
    others = (3 * power, power / 3, -power, power + Fraction(1, 2**200), 5 * power, 6 * power)
    for other in (*others, Fraction(0)):
        assert not is_power_of_two(same(other)), other
        assert not scales(product(X, same(other))), other
    for one in (Constant(power, 3 * power), Constant(3 * power, power)):
        assert not is_power_of_two(one) and not scales(product(X, one))
    both = Constant(power, 2 * power)  # a power of two in each, but not the same
    assert is_power_of_two(both) and not scales(product(X, both))


def test_only_products_scale():
    two = same(Fraction(2))
    results = [op for op in (Op.ADD, Op.SUB, Op.MUL, Op.DIV) if scales(product(X, two, op))]
    assert results == [Op.MUL]
    assert not scales(product(X, X))


def test_counts_say_sums_and_products_of_every_kind():
    results = {Op.MUL: 2, Op.SCALE: 1, Op.ADD: 3, Op.SUB: 1, Op.EXACT_ADD: 5, Op.EXACT_SUB: 7,
               Op.DIV: 1}
    assert in_words(results) == "3 mul, 16 add, 1 div"
    assert in_words({Op.MUL: 2}) == "2 mul" and in_words({}) == "no arithmetic"


@pytest.mark.parametrize("op, value", (
    (Op.PRODUCT_ERROR, lambda a, b, p: a * b - p),
    (Op.PRODUCT_REST, lambda a, b, p, h: a * b - h)), ids=lambda x: getattr(x, "name", ""))
def test_slopes_of_products_are_their_differences(op: Op, value: Callable[..., Fraction]):
    """They are linear in each operand, so that a difference of 1 gives the slope."""
    given = [Fraction(n, 7) for n in (3, -5, 11, 2)[:op.meaning.arity]]
    slopes = op.meaning.slopes
    assert slopes is not None
    for k, result in enumerate(slopes(Functions(), *given, value(*given))):
        moved = [x + (n == k) for n, x in enumerate(given)]
        assert result == value(*moved) - value(*given), k
