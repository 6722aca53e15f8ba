"""Rules for functions of scenes carried as hi + lo.  They are longer than operations, products of
sums are long chains there, names are numbered, and constants are decimals.

The lo of a sum that cancels is not small, and its products would have rounding errors of the order
of u lo.  So every sum is first rounded to hi + lo with a small lo.  Each loss is then of the order
of u² of the value there, and a result's error of the order of u² times its condition, even where
intermediate results have lost all digits."""

import math
import re
from collections import Counter
from dataclasses import replace
from fractions import Fraction

import numpy as np

from coscrew_codegen.accuracy.tiers.compensated import (
    Carrier,
    CarrierFactory,
    Carrying,
    Name,
    Rule,
    rounded_constant,
)
from coscrew_codegen.accuracy.tiers.nonlinear import RULES, error_of
from coscrew_codegen.program import Constant, Instruction, Op, Operand, Program, Ref, with_constants
from coscrew_codegen.program.program import name_of
from coscrew_codegen.program.values.formats import Precision

_NUMBER = re.compile(r"_[0-9]+$")


def in_pairs(program: Program, precision: Precision, carrier: CarrierFactory = Carrier) -> Program:
    """The plain program with every value, constants included, as hi + lo in this precision."""
    program = compared_exactly(program.fine or program, precision)
    return rounded(carrier(program, precision, SCENES).of(program), precision)


def rounded(program: Program, precision: Precision) -> Program:
    """The program whose constants are numbers of this precision."""
    return replace(with_constants(program, lambda x: rounded_constant(x, precision)), fine=None)


def compared_exactly(program: Program, precision: Precision) -> Program:
    """The program with the constants on either side of < replaced by numbers of this precision that
    give the same results in every comparison."""
    return replace(program, instructions=tuple(
        step if step.op is not Op.LESS else step._replace(operands=tuple(
            _beyond(x, n > 0, precision) for n, x in enumerate(step.operands)))
        for step in program.instructions))


def _beyond(x: Operand, above: bool, precision: Precision) -> Operand:
    if not isinstance(x, Constant):
        return x
    true, near = precision.value(x), precision.rounded(precision.value(x))
    if near != true and (near > true) != above:
        near = np.nextafter(near, near.dtype.type(math.inf if above else -math.inf))
    return Constant(Fraction(float(near)), Fraction(float(near)), x.name)


def numbered(program: Program) -> Name:
    """Names with numbers, so that they may be nested; but lo of a named value has none."""
    taken = {step.name for step in program.instructions}
    numbers: Counter[str] = Counter()

    def name(of: str, suffix: str) -> str:
        stem = f"{_NUMBER.sub('', of)}_{suffix}"
        result = stem if suffix == "lo" and not _NUMBER.search(of) else ""
        while not result or result in taken:
            numbers[stem] += 1
            result = f"{stem}_{numbers[stem]}"
        taken.add(result)
        return result
    return name


def _fast_two_sum(c: Carrier, step: Instruction, hi: Ref, lo: Operand) -> tuple[Ref, Operand]:
    """hi + lo rounded, and the rest, which is exact if |hi| >= |lo|. Else it may err by u lo, but
    lo has errors of this size already, as a rounded sum.  Source: Dekker, A Floating-Point
    Technique."""
    total = c.issue(step._replace(name=hi.name), Op.ADD, (hi, lo), "nearest")
    at = step._replace(name=total.name)
    share = c.issue(at, Op.SUB, (total, hi), "share")
    return total, c.issue(at, Op.SUB, (lo, share), "lo")


def _once(op: Op) -> Rule:
    """A sum of exact operands has one rounding, and needs no lo; other sums overlap."""
    def rule(c: Carrier, step: Instruction) -> None:
        if all(map(c.is_exact, step.operands)):
            c.nearest.add(step.name)
        elif op in (Op.ADD, Op.SUB):
            c.overlapping.add(step.name)
        RULES[op](c, step)
    return rule


def _passing(op: Op) -> Rule:
    """Marks the result as overlapping if an operand is a sum that overlaps."""
    def rule(c: Carrier, step: Instruction) -> None:
        if any(name_of(x) in c.overlapping for x in step.operands):
            c.overlapping.add(step.name)
        RULES[op](c, step)
    return rule


def _turned(c: Carrier, step: Instruction) -> None:
    """Sine or cosine of x + x_lo by those of x and of x_lo, as sums of products.  A multiple of
    x_lo would have errors of u x_lo, which is not small where an angle is large."""
    if all(map(c.is_exact, step.operands)):
        RULES[step.op](c, step)
        return
    x = c.normalized(step, step.operands[0])
    low = c.low(step, x)
    assert low is not None
    (s, cosine), (s_lo, c_lo) = _circle(c, step, x), _circle(c, step, low)
    sine = step.op is Op.SIN
    products = tuple(step._replace(name=c.name(step.name, f"turn{n}"), op=Op.MUL, operands=pair)
                     for n, pair in enumerate((((s, c_lo), (cosine, s_lo)) if sine else
                                               ((cosine, c_lo), (s, s_lo))), start=1))
    for each in products:
        c.carry(each)
    c.carry(step._replace(op=Op.ADD if sine else Op.SUB,
                    operands=tuple(Ref(product.name) for product in products)))


def _circle(c: Carrier, step: Instruction, x: Operand) -> tuple[Ref, ...]:
    """Sine and cosine of a number, once, as hi + lo."""
    def both() -> tuple[Ref, ...]:
        steps = tuple(step._replace(name=c.name(step.name, op.value), op=op, operands=(x,))
                      for op in (Op.SIN, Op.COS))
        c.steps += steps
        for each in steps:
            c.keep(each.name, error_of(c, each))
        return tuple(Ref(each.name) for each in steps)
    return c.once("circle", x, both)


SCENES = Carrying(
    {**RULES, **{op: _once(op) for op in (Op.ADD, Op.SUB, Op.MUL, Op.DIV, Op.SQRT)},
     **{op: _passing(op) for op in (Op.NEG, Op.SELECT)}, Op.SIN: _turned, Op.COS: _turned},
    numbered, _fast_two_sum, last="hi + lo, rounded:")
