"""Programs of scenes in the accurate tier take decimals as they are: each operation with constants
that double precision rounds is right to half an ulp, and in single precision, computed in double.

Truth is exact: rationals, and for roots 60 digits.
"""

import math
import operator
import random
from collections.abc import Callable
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from coscrew_codegen.accuracy.tiers.accurate import of_scene
from coscrew_codegen.program import Constant, Op, Operand, Program, Ref
from coscrew_codegen.program.interpreter import by_operation, exactly, interpreter
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE
from tests.support.scenes.generated_scenes import Writer, argument, number

TENTH, THIRD, LARGE = "1/10", "-1/3", "12345678901/7"
EXACTLY = {
    **exactly(math),
    Op.PRODUCT_ERROR: lambda a, b, p: float(Fraction(a) * Fraction(b) - Fraction(p)),
    Op.PRODUCT_REST: lambda a, b, p, h: float(Fraction(a) * Fraction(b) - Fraction(h))}
Build = Callable[[Writer, Operand, Operand], Ref]


def _root(x: Fraction) -> Fraction:
    with mpmath.workdps(60):
        root = mpmath.sqrt(mpmath.mpf(x.numerator) / x.denominator)
        return Fraction(*map(int, mpmath.libmp.to_rational(root._mpf_)))


def _polynomial(w: Writer, x: Operand, y: Operand) -> Ref:
    """(x/10 + y/3) (x/10 - y/10) + a large number, cancelled again."""
    a = w.do("a", Op.SUB, w.do("a1", Op.MUL, TENTH, x), w.do("a2", Op.MUL, THIRD, y))
    b = w.do("b", Op.SUB, w.do("b1", Op.MUL, TENTH, x), w.do("b2", Op.MUL, TENTH, y))
    c = w.do("c", Op.ADD, LARGE, w.do("ab", Op.MUL, a, b))
    return w.do("d", Op.SUB, c, LARGE)


TRUE = {**exactly(), Op.SQRT: _root}

CASES: dict[str, Build] = {
    "sum": lambda w, x, y: w.do("r", Op.ADD, TENTH, x),
    "difference": lambda w, x, y: w.do("r", Op.SUB, x, THIRD),
    "product": lambda w, x, y: w.do("r", Op.MUL, THIRD, x),
    "dividend": lambda w, x, y: w.do("r", Op.DIV, TENTH, x),
    "divisor": lambda w, x, y: w.do("r", Op.DIV, x, THIRD),
    "root": lambda w, x, y: w.do("r", Op.SQRT, w.do("s", Op.MUL, TENTH, w.do("t", Op.ABS, x))),
    "negative": lambda w, x, y: w.do("r", Op.NEG, w.do("s", Op.ADD, THIRD, y)),
    "size": lambda w, x, y: w.do("r", Op.ABS, w.do("s", Op.SUB, x, TENTH)),
    "choice": lambda w, x, y: w.do("r", Op.ADD, y, w.do("c", Op.SELECT, w.do(
        "l", Op.LESS, x, 1), TENTH, THIRD)),
    "polynomial": _polynomial,
}


def _program(build: Build) -> Program:
    w = Writer(argument("x"), argument("y"))
    return w.function("f", "f", (argument("r"),), [build(w, w.at("x"), w.at("y"))]).program


def _results(program: Program, x: float, y: float) -> tuple[float, Fraction]:
    """The result of the accurate program in double, and the exact one of the plain program."""
    result = interpreter(of_scene(program, DOUBLE), by_operation(_held, EXACTLY, math.nan))
    wanted = interpreter(program, by_operation(lambda c: c.double, TRUE))
    return result([[x], [y]])[0], wanted([[Fraction(x)], [Fraction(y)]])[0]


def _held(constant: Constant) -> float:
    assert constant.double == Fraction(float(constant.double)), "a constant that is rounded again"
    return float(constant.double)


@pytest.mark.parametrize("case", CASES)
def test_decimals_are_exact_in_every_operation(case: str):
    program, draw = _program(CASES[case]), random.Random(case)
    for _ in range(300):
        x, y = (draw.uniform(0.01, 3) * draw.choice((-1, 1)) for _ in range(2))
        result, wanted = _results(program, x, y)
        assert abs(Fraction(result) - wanted) <= Fraction(501, 1000) * Fraction(
            math.ulp(result)), (x.hex(), y.hex(), result.hex())


@pytest.mark.parametrize("case", ("sum", "difference", "size"))
def test_what_is_left_after_cancellation_is_right(case: str):
    """x is the double next to a constant that is no double."""
    program = _program(CASES[case])
    for x, y in ((0.1, 0.1 + 2.0**-30), (-0.1, 0.3), (-1 / 3, 1 / 3), (0.1, -0.03)):
        result, wanted = _results(program, x, y)
        assert wanted and abs(Fraction(result) / wanted - 1) <= Fraction(1, 10**15)


def test_a_constant_result_is_the_nearest_double():
    w = Writer(argument("x"))
    program = w.function("f", "f", (argument("r", 2),), [TENTH, w.at("x")]).program
    for precision in (DOUBLE, SINGLE):
        tiered = of_scene(program, precision)
        assert tiered.results == (number(Fraction(0.1)), w.at("x")) and not tiered.instructions


@pytest.mark.parametrize("left", (False, True))
@pytest.mark.parametrize("limit", (TENTH, THIRD, "1/4"))
def test_comparisons_with_decimals_are_those_of_the_decimals(limit: str, left: bool):
    w = Writer(argument("x"))
    operands = (limit, w.at("x")) if left else (w.at("x"), limit)
    program = w.function("f", "f", (argument("r"),), [
        w.do("r", Op.SELECT, w.do("l", Op.LESS, *operands), 1, 0)]).program
    compare = interpreter(of_scene(program, DOUBLE), by_operation(_held, EXACTLY))
    near = float(Fraction(limit))
    for x in (np.nextafter(near, -9.0), near, np.nextafter(near, 9.0)):
        exact = (Fraction(limit), Fraction(float(x)))
        assert compare([[float(x)]])[0] == operator.lt(*(exact if left else exact[::-1]))


def test_single_precision_has_constants_of_double():
    tiered = of_scene(_program(CASES["product"]), SINGLE)
    (step,) = tiered.instructions
    assert tiered.wide and step.operands[0] == number(Fraction(-1 / 3))
