"""Pairs of numbers: proved errors of their operations, against rationals."""

from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest

from coscrew_codegen.program.elementary.evaluation.double_words import (
    Pair,
    Pairs,
    Series,
    power_of_two,
    upward,
)
from coscrew_codegen.program.elementary.evaluation.step_writer import StepWriter
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument
from tests.support.each import each_precision
from tests.support.truth.elementary import Array, values

GIVEN = tuple(Argument(name, SCALAR) for name in ("a", "a_low", "b", "b_low"))
SERIES = Series(Fraction(7, 10), 2, 1, 1)  # (e^x - 1) / x - 1

Rule = Callable[[Pairs, Pair, Pair], Pair]
Exact = Callable[[Fraction, Fraction], Fraction]
RULES: dict[str, tuple[Rule, Exact]] = {
    "product": (lambda p, a, b: p.product("y", a, b), lambda a, b: a * b),
    "sum": (lambda p, a, b: p.sum("y", a, b), lambda a, b: a + b),
    "ordered sum": (lambda p, a, b: p.sum("y", p.constant(a.high.steps, Fraction(7, 3)), b,
                                          ordered=True), lambda a, b: Fraction(7, 3) + b),
    "normal": (lambda p, a, b: p.normal("y", a), lambda a, b: a),
    "series": (lambda p, a, b: p.series("y", SERIES.terms(p.precision), b),
               lambda a, b: sum((c * b**n for n, c in enumerate(SERIES.terms(DOUBLE), 1)),
                                Fraction(0))),
    "grown": (lambda p, a, b: p.grown("y", a, p.product("x", b, p.constant(
        b.high.steps, Fraction(1, 3)))), lambda a, b: a + a * b / 3)}


def samples(precision: Precision) -> list[Array]:
    """|a| <= 1 and |b| <= 7/10, whose lows are up to 3 u."""
    rng = np.random.default_rng(2)
    a, b = (rng.uniform(-1, 1, 400) * size * 2.0**-rng.choice((0, 0, 0, 9), 400)
            for size in (1, 0.7))
    lows = (rng.uniform(-3, 3, 400) * float(precision.u) * size for size in (1, 0.7))
    rows = [a, next(lows), b, next(lows)]
    return [x.astype(precision.numpy_type) for x in rows]


@each_precision
@pytest.mark.parametrize("name", RULES)
def test_operations_err_by_no_more_than_is_proved(name: str, precision: Precision):
    """Nor by less than a fiftieth of it, at worst."""
    rule, exact = RULES[name]
    steps, u = StepWriter(*GIVEN), precision.u
    a, a_low, b, b_low = steps.inputs()
    size = Fraction(float(precision.rounded(Fraction(7, 10))))
    result = rule(Pairs(precision), Pair(a, a_low, Fraction(1), 3 * u),
                  Pair(b, b_low, size, 3 * u * size))
    program = steps.program("rule", GIVEN[:2], (result.high, result.low))
    given, worst = samples(precision), Fraction(0)
    rows = zip(*(x.tolist() for x in (*given, *values(program, precision, *given))), strict=True)
    for row in rows:
        a1, a2, b1, b2, high, low = map(Fraction, row)
        worst = max(worst, abs(high + low - exact(a1 + a2, b1 + b2)))
        assert abs(high) <= result.size and abs(low) <= result.rest
    assert result.error / 50 <= worst <= result.error or name == "normal" and not worst


def test_constants_are_known_to_twice_the_digits():
    result = Pairs(DOUBLE).constant(StepWriter(), Fraction(1, 3))
    assert result.size == Fraction(1 / 3) and result.error <= Fraction(1, 3) / 2**106
    assert Pairs(DOUBLE).constant(StepWriter(), Fraction(1, 2)).low is None


def test_bounds_are_rounded_up():
    for x in (Fraction(1, 3), Fraction(2, 7) / 2**200, Fraction(10**30 + 1)):
        assert x <= upward(x) <= x * (1 + Fraction(1, 2**44))
    assert upward(Fraction(0)) == 0 and power_of_two(Fraction(1, 2**100)) == "2^-100"
    assert power_of_two(Fraction(9, 8) / 2**100) == "2^-99.8"


def test_series_that_are_not_ordered_are_refused():
    b, = StepWriter(GIVEN[0]).inputs()
    with pytest.raises(AssertionError):
        Pairs(DOUBLE).series("y", (Fraction(1, 9), Fraction(1)), Pair(b, None, Fraction(1)))
