"""The proof of the certified tier's bounds, step by step: for all numbers of toy formats, and its
constants in the real formats for the worst numbers.

A toy format has so few digits that terms of second order matter, and so few exponents that
everything underflows; its numbers, and the exact results on them, are doubles.
"""

from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from itertools import product

import numpy as np
import pytest

from coscrew_codegen.accuracy.tiers.certified import certified
from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Format
from coscrew_codegen.program.values.quantity import SCALAR, Argument
from tests.support.truth.attack import TIERED, plain_program

TOYS = (Format(2, -3), Format(3, -4))
FORMULAS = ("a*b", "a+b", "a*b+c", "a*b-c", "a*b*c", "(a+b)*c", "(a*b+c)*a", "a*b+b*c",
            "(a+b)*(b+c)", "((a+b)+c)*a", "(a*b)*(b*c)", "a*b*c+a", "(a+b)+c")


def rounded(x: np.ndarray, toy: Format) -> np.ndarray:
    """To nearest, ties to even; subnormal numbers have fewer digits."""
    exponent = np.maximum(np.frexp(x)[1] - 1, toy.least_exponent)
    return np.ldexp(np.rint(np.ldexp(x, toy.digits - 1 - exponent)), exponent - toy.digits + 1)


def numbers(toy: Format) -> np.ndarray:
    """Zero, all subnormal numbers, all normal numbers of a dozen binades, and their negatives."""
    least = 2.0**(toy.least_exponent - toy.digits + 1)
    few = np.arange(2**(toy.digits - 1), 2**toy.digits)
    normal = np.concatenate([np.ldexp(few * 1.0, toy.least_exponent - toy.digits + 1 + binade)
                             for binade in range(0, 12, toy.digits - 1)])
    positive = np.concatenate([np.arange(1, 2**(toy.digits - 1)) * least, normal])
    return np.concatenate([[0], positive, -positive])


class _Recorder:
    """Turns a Python formula into instructions."""

    def __init__(self, program: list[Instruction], operand: Operand):
        self.program, self.operand = program, operand

    def _with(self, op: Op, other: "_Recorder") -> "_Recorder":
        name = f"t{len(self.program)}"
        self.program.append(Instruction(name, op, (self.operand, other.operand), name))
        return _Recorder(self.program, Ref(name))

    def __add__(self, other): return self._with(Op.ADD, other)
    def __sub__(self, other): return self._with(Op.SUB, other)
    def __mul__(self, other): return self._with(Op.MUL, other)


def program_of(formula: str) -> Program:
    arguments, steps = tuple(Argument(name, SCALAR) for name in "abc"), []
    result = eval(formula, {a.name: _Recorder(steps, Input(n, 0))
                            for n, a in enumerate(arguments)})
    return Program("toy", arguments, (Argument("x", SCALAR),), tuple(steps), (result.operand,))


def evaluated(program: Program, inputs: list[np.ndarray], toy: Format | None) -> list[np.ndarray]:
    """The results, each instruction rounded; exactly without a toy."""
    values: dict[str, np.ndarray] = {}

    def value(x: Operand) -> np.ndarray | float:
        if isinstance(x, Input):
            return inputs[x.argument]
        return values[x.name] if isinstance(x, Ref) else float(x.double)

    rules = {Op.ADD: np.add, Op.SUB: np.subtract, Op.MUL: np.multiply, Op.ABS: np.abs}
    for step in program.instructions:
        exact = rules[step.op](*map(value, step.operands))
        values[step.name] = rounded(exact, toy) if toy else exact
    return [value(x) for x in program.results]


@pytest.mark.parametrize("toy", TOYS, ids=str)
@pytest.mark.parametrize("formula", FORMULAS)
def test_bounds_hold_for_all_numbers_of_a_toy_format(formula: str, toy: Format):
    plain, some = program_of(formula), numbers(toy)
    inputs = [x.ravel() for x in np.meshgrid(some, some, some)]
    (exact,) = evaluated(plain, inputs, None)
    try:
        result, bound = evaluated(certified(plain, toy), inputs, toy)
    except ValueError as refused:  # too many products for so few digits
        assert "padding" in str(refused) and toy.digits < 3
        return
    assert (result == evaluated(plain, inputs, toy)[0]).all()
    wrong = np.flatnonzero(np.abs(result - exact) > bound)
    assert not len(wrong), [(x[wrong[0]], len(wrong)) for x in (*inputs, result, exact)]


# The last step: C is such that fl(C s) >= g s for every s.


def sizes(C: Fraction, number: Format) -> Iterator[Fraction]:
    """The smallest significands s whose product with C is rounded down by nearly half an ulp, where
    its relative error is largest: C s = q 2^n + (2^(n-1) - 1 - few), in integers."""
    c = int(C / _ulp(C, number))
    p = number.digits
    while c % 2 == 0:
        c //= 2
    for n in (p - 1, p):
        inverse = pow(c, -1, 2**n)
        for few in range(200):
            m = (2**(n - 1) - 1 - few) * inverse % 2**n
            yield from (Fraction(m + k * 2**n) for k in range(3) if 0 < m + k * 2**n < 2**p)


def _ulp(x: Fraction, number: Format) -> Fraction:
    exponent = x.numerator.bit_length() - x.denominator.bit_length()
    exponent -= x < Fraction(2)**exponent
    return Fraction(2)**(exponent - number.digits + 1)


def nearest(x: Fraction, number: Format) -> Fraction:
    unit = _ulp(x, number)
    return round(x / unit) * unit  # of two, the even one


CHAINS, TOY_DIGITS = ("x + a", "x * a", "x * a + b", "(x + a) * (x + b)"), 11


def chain(step: str, length: int = 12) -> Program:
    """x = step(x), repeated from c; each x is a result."""
    arguments, steps = tuple(Argument(name, SCALAR) for name in "abc"), []
    a, b, x = (_Recorder(steps, Input(n, 0)) for n in range(3))
    results = []
    for _ in range(length if "(" not in step else 4):
        x = eval(step, {"a": a, "b": b, "x": x})
        results.append(x.operand)
    outputs = tuple(Argument(f"x{i}", SCALAR) for i in range(len(results)))
    return Program("chain", arguments, outputs, tuple(steps), tuple(results))


@cache
def constants(number: Format) -> dict[Fraction, Fraction]:
    """g → C of every result of every certified kernel, with g from the roundings by the proof; in
    toy formats also of longer and longer sums and products, so that g is often next to C."""
    results = {}
    chains = tuple(map(chain, CHAINS)) if number.digits <= TOY_DIGITS else ()
    for plain in (*map(plain_program, TIERED), *chains):
        made = certified(plain, number)
        steps = {step.name: step for step in made.instructions}
        growth = _growth(plain, number)
        for result, bound in zip(plain.results, made.results[len(plain.results):], strict=True):
            if isinstance(bound, Ref):
                C = next(x for x in steps[bound.name].operands if isinstance(x, Constant))
                results[growth(result)] = C.double
    return results


def _growth(plain: Program, number: Format):
    """g of an operand, padding counted where a product's underflow would be multiplied; by the
    module's docstring."""
    u, steps = number.u, {step.name: step for step in plain.instructions}

    @cache
    def parts(x: Operand) -> tuple[Fraction, Fraction]:
        """g and h / (η / u)."""
        step = steps.get(getattr(x, "name", ""))
        if step is None:
            return Fraction(0), Fraction(0)
        own = [parts(y) for y in step.operands]
        if step.op is Op.NEG:
            return own[0]
        if not any(g for g, _ in own):
            return u, Fraction(step.op is Op.MUL)
        if step.op is Op.MUL:
            a, b = (padded(*pair) for pair in own)
            return (1 + u) * (1 + a) * (1 + b) - 1, Fraction(2)
        return (1 + u) * max(g for g, _ in own) + u, sum(h for _, h in own)

    def padded(g: Fraction, h: Fraction) -> Fraction:
        slack, tau = h * number.eta / u, Fraction(2)**number.least_exponent / u
        return g * (1 + 4 * u * slack / tau)

    return lambda x: padded(*parts(x))


@pytest.mark.parametrize("number", [DOUBLE, SINGLE, Format(8, -40), Format(7, -40), Format(5, -40)],
                         ids=str)
def test_the_product_with_c_is_rounded_to_no_less_than_it_stands_for(number: Format):
    if number.digits <= TOY_DIGITS:
        some = [Fraction(m) for m in range(2**(number.digits - 1), 2**number.digits)]
    tight = Fraction(1)
    for g, C in constants(number).items():
        assert number.rounded_up((1 + number.u) * g) == C  # no less, nor more than the proof needs
        for s in some if number.digits <= TOY_DIGITS else sizes(C, number):
            assert nearest(C * s, number) >= g * s, (g, C, s)
            tight = min(tight, nearest(C * s, number) / (g * s) - 1)
    assert tight < 4 * number.u  # and hardly more: such s were tried


@pytest.mark.parametrize("digits", [1, 2, 5])
def test_rounding_up_is_to_the_least_number_that_is_not_below(digits: int):
    number = Format(digits, -10)
    grid = sorted(Fraction(m) * Fraction(2)**e for m in range(2**(digits - 1), 2**digits)
                  for e in range(-12, 12))
    for n, d in product(range(1, 70), (1, 3, 7, 32, 33, 64)):
        assert number.rounded_up(Fraction(n, d)) == next(x for x in grid if x >= Fraction(n, d))
    assert number.rounded_up(Fraction(0)) == 0


@pytest.mark.parametrize("number, dtype", [(DOUBLE, np.float64), (SINGLE, np.float32)])
def test_the_formats_are_those_of_the_machine(number: Format, dtype: type):
    info = np.finfo(dtype)
    assert number.u == Fraction(float(info.eps)) / 2
    assert number.eta == Fraction(float(info.smallest_subnormal)) / 2
    assert number.smallest_normal == Fraction(float(info.smallest_normal))
