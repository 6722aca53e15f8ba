"""Turns a plain Program into one of 32-bit integers that never overflows, for all arguments of a
box, with proved bounds of its results' errors.

The format of each value follows from its bounds: f is the largest with (size + error) 2^f <= 2^31 -
2.  Bounds are those of `program/roundoff.py`, with absolute errors of roundings:

    high product      half of the last bit, f = f_a + f_b - 32
    wide product      the last bit, where it is shifted to the right
    rounded shift     half of the last bit
    sine, cosine      that of `fixed_sine.py`, f = 30"""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from math import floor, frexp, inf, ldexp
from typing import NamedTuple

from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.fixed import fixed_sine
from coscrew_codegen.program.fixed.fixed_value import (
    OF_ANGLES,
    FixedValue,
    bits_for,
    fits,
    half_unit,
    of_integer,
    quantized,
    shift_error,
    shifts,
    vanishes,
)
from coscrew_codegen.program.program import is_power_of_two, scales, without_dead_steps
from coscrew_codegen.program.roundoff import (
    CIRCULAR,
    NONE,
    RoundedRange,
    Upward,
    combined,
    product,
    sine_or_cosine,
    total,
)

KNOWN = frozenset({Op.ADD, Op.SUB, Op.MUL, Op.NEG, *CIRCULAR})
"""Operations that fixed point has."""
_WIDEST = 62  # bits of a sum of products, at most
_EMPTY = 3
"""Empty bits of a factor of a high product from which it is shifted first: with 3, a UR5's inverse
dynamics take 24 instructions more on a Cortex-M4 and are 2.7 times as accurate."""


class Products(Enum):
    """Ways to multiply: results of 64 bits, which are shifted, or their upper 32 bits."""

    FULL = "full"
    HIGH = "high"


@dataclass(frozen=True)
class FixedProgram:
    """A Program of integers, and the values of its inputs, by argument, and of its results."""

    program: Program
    inputs: tuple[tuple[FixedValue, ...], ...]
    results: tuple[FixedValue, ...]
    lines: tuple["FixedLine", ...]


class FixedLine(NamedTuple):
    """An operation on values in fixed point, and its result: that of an instruction or, where a
    term is smaller than the last bit of its sum, of none."""

    op: Op
    operands: tuple[FixedValue, ...]
    value: FixedValue

    @property
    def name(self) -> str:
        """The name of its result."""
        return self.value.operand.name if isinstance(self.value.operand, Ref) else \
            self.value.stands_for


class NoFormatError(ValueError):
    """A value has no format of 32 bits: it is unbounded, or an angle that is too large."""


def of_inputs(sizes: Sequence[Sequence[float]], angles: frozenset[Operand] = frozenset()
              ) -> tuple[tuple[FixedValue, ...], ...]:
    """The inputs of a box whose components are up to these sizes.  Their integers are rounded, so
    that bounds are of the rounded arguments.  Raises NoFormatError for an infinite one."""
    return tuple(tuple(_of_input(Input(n, i), size, Input(n, i) in angles)
                       for i, size in enumerate(parts)) for n, parts in enumerate(sizes))


def _of_input(x: Input, size: float, angle: bool) -> FixedValue:
    if size == inf:
        raise NoFormatError("an argument has no bounds")
    bits = min(bits_for(size), OF_ANGLES) if angle else bits_for(size)
    return FixedValue(x, bits, RoundedRange(Upward(ldexp(-floor(-ldexp(size, bits)), -bits))))


def in_fixed_point(program: Program, inputs: tuple[tuple[FixedValue, ...], ...],
                   products: Products) -> FixedProgram:
    """The program in fixed point.  Raises NoFormatError; every operation must be KNOWN."""
    writer = _FixedWriter(program, inputs, products)
    for step in program.instructions:
        writer.write(step)
    results = tuple(map(writer.value, program.results))
    made = replace(program, instructions=tuple(writer.steps),
                   results=tuple(x.operand for x in results), fine=None)
    return FixedProgram(without_dead_steps(made), inputs, results, tuple(writer.lines))


def angles_of(program: Program) -> frozenset[Operand]:
    """The operands whose sines or cosines are taken."""
    return frozenset(step.operands[0] for step in program.instructions if step.op in CIRCULAR)


class _FixedWriter:
    """Writes instructions on integers for those of a plain program, in turn."""

    def __init__(self, program: Program, inputs: tuple[tuple[FixedValue, ...], ...],
                 products: Products) -> None:
        self._inputs, self._products = inputs, products
        self._values: dict[str, FixedValue] = {}
        self._angles = angles_of(program)
        self._plain = {step.name: step for step in program.instructions}
        self._uses = _uses(program)
        self._summed = _products_of_sums(program, self._uses) if products is Products.FULL \
            else frozenset()
        self._wide: dict[str, FixedValue] = {}  # by name of its rounded value: 64 bits
        self._number = 0
        self.steps: list[Instruction] = []
        self.lines: list[FixedLine] = []

    def value(self, x: Operand) -> FixedValue:
        """The value of an operand of the plain program; a constant has bits of its own."""
        if isinstance(x, Ref):
            return self._values[x.name]
        if isinstance(x, Constant):
            return quantized(x.double, bits_for(abs(float(x.double))))
        assert isinstance(x, Input)
        return self._inputs[x.argument][x.index]

    def write(self, step: Instruction) -> None:
        """Writes the instructions for this one."""
        if step.name in self._summed:  # written with its sum
            a, b = map(self.value, step.operands)
            self._values[step.name] = FixedValue(Ref(step.name), a.bits + b.bits,
                                                 product(a.bounds, b.bounds))
            return
        self._number = 0
        value = self._written(step)
        if Ref(step.name) in self._angles and value.bits > OF_ANGLES:
            value = self._shifted(step, value, OF_ANGLES)
        if isinstance(value.operand, Ref) and value.operand.name.startswith(f"{step.name}_term_"):
            value = value._replace(operand=Ref(step.name))
            self.steps.append(self.steps.pop()._replace(name=step.name))
            self.lines.append(self.lines.pop()._replace(value=value))
        if not value.reach < inf:
            raise NoFormatError(f"{step.name} has no bounds")
        self._values[step.name] = value

    def _written(self, step: Instruction) -> FixedValue:
        if step.op in CIRCULAR:
            return self._function(step)
        if step.op is Op.NEG:
            x = self.value(step.operands[0])
            return self._issue(step, Op.NEG, (x,), x.bits, combined(step, (x.bounds,)))
        if step.op is Op.MUL:
            return self._scaled(step) if scales(step) else self._product(step)
        return self._of_products(step) or self._total(step, *map(self.value, step.operands))

    def _issue(self, step: Instruction, op: Op, operands: Sequence[FixedValue], bits: int,
               bounds: RoundedRange, *integers: int) -> FixedValue:
        """An instruction towards `step`, whose result has this f and these bounds; the last gets
        its name.  Integers are further operands."""
        self._number += 1
        name = f"{step.name}_term_{self._number}"
        self.steps.append(step._replace(name=name, op=op, operands=(
            *(x.operand for x in operands), *map(of_integer, integers))))
        value = FixedValue(Ref(name), bits, bounds)
        self.lines.append(FixedLine(op, tuple(operands), value))
        return value

    # functions and products

    def _function(self, step: Instruction) -> FixedValue:
        """A sine or cosine."""
        x = self.value(step.operands[0])
        own = fixed_sine.error(x.bits, x.reach)
        if own is None:
            raise NoFormatError(f"the angle {step.operands[0]} is too large")
        exact = sine_or_cosine(step, x.bounds)
        return self._issue(step, step.op, (x,), fixed_sine.BITS, exact.rounded(own), x.bits)

    def _scaled(self, step: Instruction) -> FixedValue:
        """A product with a power of two: another f."""
        for x, factor in (step.operands, step.operands[::-1]):
            if isinstance(factor, Constant) and is_power_of_two(factor):
                value, power = self.value(x), frexp(factor.double)[1] - 1
                times = Upward(ldexp(1, power))
                return value._replace(bits=value.bits - power, bounds=RoundedRange(
                    value.size * times, value.error * times))
        raise AssertionError(step)

    def _product(self, step: Instruction) -> FixedValue:
        """A rounded product."""
        given = [self.value(x) for x in step.operands]
        if self._products is Products.HIGH:
            given = [self._filled(step, x) for x in given]
            bits = given[0].bits + given[1].bits - 32
            exact = product(*(x.bounds for x in given))
            return self._issue(step, Op.HIGH_PRODUCT, given, bits, exact.rounded(half_unit(bits)))
        wide = self._wide[step.name] = self._multiple(step, given, 0)
        return self._narrowed(step, wide, self._narrow(wide, wide.bits))

    def _multiple(self, step: Instruction, given: Sequence[FixedValue], shift: int) -> FixedValue:
        """A product of 64 bits, times a power of two: shifted to the right it is rounded down."""
        bits = given[0].bits + given[1].bits + shift
        exact = product(*(x.bounds for x in given))
        lost = Upward(ldexp(1, -bits)) if shift < 0 else NONE
        return self._issue(step, Op.WIDE_PRODUCT, given, bits, exact.rounded(lost), shift)

    def _filled(self, step: Instruction, x: FixedValue) -> FixedValue:
        """The factor with all its bits, if many are empty: a high product would lose as many."""
        empty = min(bits_for(x.reach) - x.bits, OF_ANGLES)
        if empty < _EMPTY or isinstance(x.operand, Constant):
            return x
        return self._to_the_left(step, x, x.bits + empty)

    def _to_the_left(self, step: Instruction, x: FixedValue, bits: int) -> FixedValue:
        """The value with this larger f."""
        return self._issue(step, Op.MUL, (x,), bits, x.bounds._replace(own=NONE),
                           2**(bits - x.bits))

    def _narrowed(self, step: Instruction, x: FixedValue, bits: int) -> FixedValue:
        """The value with this f, rounded if that is smaller."""
        lost = half_unit(bits) if bits < x.bits else NONE
        return self._issue(step, Op.ROUNDED_SHIFT, (x,), bits, x.bounds.rounded(lost),
                           x.bits - bits)

    def _narrow(self, x: FixedValue, most: int) -> int:
        """The largest f up to `most` of the value after a rounding."""
        bits = min(bits_for(x.reach), most)
        while not fits(x.reach + half_unit(bits), bits):
            bits -= 1
        return bits

    # sums

    def _total(self, step: Instruction, a: FixedValue, b: FixedValue) -> FixedValue:
        """A sum or difference."""
        exact = total(a.bounds, b.bounds)
        reach = exact.size + exact.error
        given = list(zip((a, b), step.operands, strict=True))
        bits = min(bits_for(reach), max(
            x.bits if not isinstance(of, Constant) or x.error else _least_bits(of)
            for x, of in given))
        bits = min(bits, *(min(bits_for(x.reach), x.bits + OF_ANGLES) for x, of in given
                           if not isinstance(of, Constant)))
        while not fits(reach + _lost(a, step.operands[0], bits) + _lost(
                b, step.operands[1], bits), bits):
            bits -= 1
        terms = [self._aligned(step, self._unrounded(x, of, bits), of, bits) for x, of in given]
        return self._issue(step, step.op, terms, bits, total(*(x.bounds for x in terms)))

    def _unrounded(self, x: FixedValue, of: Operand, bits: int) -> FixedValue:
        """The 64 bits of a value that this sum alone uses, if it shifts them: it rounds once."""
        wide = self._wide.get(of.name) if isinstance(of, Ref) else None
        if wide and isinstance(of, Ref) and self._uses[of.name] == 1 and \
                x.bits > bits >= wide.bits - _WIDEST:
            return wide
        return x

    def _aligned(self, step: Instruction, x: FixedValue, of: Operand, bits: int) -> FixedValue:
        """A term of a sum with this f."""
        return quantized(of.double, bits) if isinstance(of, Constant) else \
            self._shifted(step, x, bits)

    def _shifted(self, step: Instruction, x: FixedValue, bits: int) -> FixedValue:
        """The value with this f.  A term below half of the last bit is 0."""
        if bits > x.bits:
            return self._to_the_left(step, x, bits)
        if vanishes(x, bits):
            zero = FixedValue(of_integer(0), bits, x.bounds.rounded(half_unit(bits)),
                              f"{step.name}_zero_{len(self.lines)}")
            self.lines.append(FixedLine(Op.ROUNDED_SHIFT, (x,), zero))
            return zero
        for shift in shifts(x, bits):
            x = self._narrowed(step, x, x.bits - shift)
        return x

    def _of_products(self, step: Instruction) -> FixedValue | None:
        """A sum or difference of two products that is rounded once; None if it is another sum."""
        names = [x.name for x in step.operands if isinstance(x, Ref) and x.name in self._summed]
        if not names:
            return None
        a, b = (self._values[x] for x in names)
        wide = max(a.bits, b.bits)
        while ldexp(a.reach, wide) + ldexp(b.reach, wide) > 2.0**_WIDEST:
            wide -= 1
        if wide - min(a.bits, b.bits) > _WIDEST or max(a.bits, b.bits) - wide > _WIDEST:
            return self._total(step, *(self._product(self._plain[x]) for x in names))
        terms = [self._multiple(step, [self.value(y) for y in self._plain[name].operands],
                                wide - x.bits) for name, x in zip(names, (a, b), strict=True)]
        sum_ = self._issue(step, step.op, terms, wide, total(*(x.bounds for x in terms)))
        self._wide[step.name] = sum_
        return self._narrowed(step, sum_, self._narrow(sum_, wide))


def _lost(x: FixedValue, of: Operand, bits: int) -> Upward:
    """Bounds the error that a term has in a sum with this f."""
    return quantized(of.double, bits).error if isinstance(of, Constant) else shift_error(x, bits)


def _least_bits(x: Constant) -> int:
    """The least f >= 0 with which an exact constant is an integer."""
    return x.double.denominator.bit_length() - 1


def _uses(program: Program) -> Counter[str]:
    """Counts the uses of each instruction."""
    uses = Counter(x.name for step in program.instructions for x in step.operands
                   if isinstance(x, Ref))
    uses.update(x.name for x in program.results if isinstance(x, Ref))
    return uses


def _products_of_sums(program: Program, uses: Mapping[str, int]) -> frozenset[str]:
    """The names of products that only a sum or difference of two such products uses."""
    alone = {step.name for step in program.instructions
             if step.op is Op.MUL and not scales(step) and uses[step.name] == 1}
    pairs = [step.operands for step in program.instructions if step.op in (Op.ADD, Op.SUB)]
    return frozenset(x.name for pair in pairs if all(
        isinstance(x, Ref) and x.name in alone for x in pair)
        for x in pair if isinstance(x, Ref))
