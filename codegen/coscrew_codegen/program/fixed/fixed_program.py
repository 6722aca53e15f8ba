"""Turns a plain Program into one of 32-bit integers that never overflows, for all arguments of a
box, with proved bounds of its results' errors.

The format of each value follows from its bounds: f is the largest with (size + error) 2^f <= 2^31 -
2.  Bounds are those of roundings in floating point (`a b`: size a size b, …), with absolute errors:

    high product      half of the last bit, f = f_a + f_b - 32
    rounded shift     half of the last bit
    s x ± c y         where s and c are sine and cosine of the same number: at most √(x² + y²)

Constants are the exact decimals.  Each bound is rounded up."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from math import floor, frexp, inf, ldexp

from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.fixed import fixed_sine
from coscrew_codegen.program.fixed.fixed_value import (
    NONE,
    OF_ANGLES,
    AlignedTerm,
    FixedValue,
    bits_for,
    fits,
    half_unit,
    of_integer,
    quantized,
    rounded,
    shifts,
    sum_of,
)
from coscrew_codegen.program.program import is_power_of_two, scales, without_dead_steps
from coscrew_codegen.program.roundoff import Upward, product_error

CIRCULAR = frozenset({Op.SIN, Op.COS})
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
    return FixedValue(x, bits, Upward(ldexp(-floor(-ldexp(size, bits)), -bits)))


def in_fixed_point(program: Program, inputs: tuple[tuple[FixedValue, ...], ...],
                   products: Products) -> FixedProgram:
    """The program in fixed point.  Raises NoFormatError; every operation must be KNOWN."""
    writer = _FixedWriter(program, inputs, products)
    for step in program.instructions:
        writer.write(step)
    results = tuple(map(writer.value, program.results))
    made = replace(program, instructions=tuple(writer.steps),
                   results=tuple(x.operand for x in results), fine=None)
    return FixedProgram(without_dead_steps(made), inputs, results)


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
            self._values[step.name] = self._multiple(step)
            return
        self._number = 0
        value = self._written(step)
        if Ref(step.name) in self._angles and value.bits > OF_ANGLES:
            value = self._shifted(step, value, OF_ANGLES)
        if isinstance(value.operand, Ref) and value.operand.name.startswith(f"{step.name}_term_"):
            last = self.steps.pop()
            self.steps.append(last._replace(name=step.name))
            value = value._replace(operand=Ref(step.name))
        if not value.reach < inf:
            raise NoFormatError(f"{step.name} has no bounds")
        self._values[step.name] = value

    def _written(self, step: Instruction) -> FixedValue:
        if step.op in CIRCULAR:
            return self._function(step)
        if step.op is Op.NEG:
            x = self.value(step.operands[0])
            return x._replace(operand=self._issue(step, Op.NEG, x.operand))
        if step.op is Op.MUL:
            return self._scaled(step) if scales(step) else self._product(step)
        return self._of_products(step) or self._total(step, *map(self.value, step.operands))

    def _issue(self, step: Instruction, op: Op, *operands: Operand | int) -> Ref:
        """An instruction towards `step`; the last gets its name."""
        self._number += 1
        given = tuple(of_integer(x) if isinstance(x, int) else x for x in operands)
        self.steps.append(step._replace(name=f"{step.name}_term_{self._number}", op=op,
                                  operands=given))
        return Ref(self.steps[-1].name)

    # functions and products

    def _function(self, step: Instruction) -> FixedValue:
        """A sine or cosine."""
        x = self.value(step.operands[0])
        own = fixed_sine.error(x.bits, x.reach)
        if own is None:
            raise NoFormatError(f"the angle {step.operands[0]} is too large")
        size = min(Upward(1), x.size) if step.op is Op.SIN else Upward(1)
        return FixedValue(self._issue(step, step.op, x.operand, x.bits), fixed_sine.BITS, size,
                          x.error + own, (step.op, step.operands[0]))

    def _multiple(self, step: Instruction) -> FixedValue:
        """A product without a rounding: its bounds, and f of the 64-bit integer."""
        a, b = map(self.value, step.operands)
        result = FixedValue(Ref(step.name), a.bits + b.bits, a.size * b.size,
                            product_error(a.size, a.error, b.size, b.error))
        for x, y in ((a, b), (b, a)):
            if x.circular and not x.factor:
                rest = x.error * y.size + a.error * b.error
                return result._replace(circular=x.circular, factor=y, rest=rest)
        return result

    def _scaled(self, step: Instruction) -> FixedValue:
        """A product with a power of two: another f."""
        for x, factor in (step.operands, step.operands[::-1]):
            if isinstance(factor, Constant) and is_power_of_two(factor):
                value, power = self.value(x), frexp(factor.double)[1] - 1
                times = Upward(ldexp(1, power))
                return value._replace(
                    bits=value.bits - power, size=value.size * times, error=value.error * times,
                    circular=None, factor=None, rest=NONE)
        raise AssertionError(step)

    def _product(self, step: Instruction) -> FixedValue:
        """A rounded product."""
        exact = self._multiple(step)
        a, b = (self.value(x).operand for x in step.operands)
        if self._products is Products.HIGH:
            given = [self._filled(step, self.value(x)) for x in step.operands]
            bits = given[0].bits + given[1].bits - 32
            operand = self._issue(step, Op.HIGH_PRODUCT, *(x.operand for x in given))
        else:
            bits = self._narrow(exact, exact.bits)
            wide = self._issue(step, Op.WIDE_PRODUCT, a, b, 0)
            operand = self._issue(step, Op.ROUNDED_SHIFT, wide, exact.bits - bits)
            self._wide[step.name] = exact._replace(operand=wide)
        return rounded(exact, operand, bits, half_unit(bits) if bits < exact.bits else NONE)

    def _filled(self, step: Instruction, x: FixedValue) -> FixedValue:
        """The factor with all its bits, if many are empty: a high product would lose as many."""
        empty = min(bits_for(x.reach) - x.bits, OF_ANGLES)
        if empty < _EMPTY or isinstance(x.operand, Constant):
            return x
        return x._replace(bits=x.bits + empty, operand=self._issue(
            step, Op.MUL, x.operand, 2**empty))

    def _narrow(self, x: FixedValue, most: int, more: Upward = NONE) -> int:
        """The largest f up to `most` of the value after a rounding, and further errors."""
        bits = min(bits_for(x.reach + more), most)
        while not fits(x.reach + more + half_unit(bits), bits):
            bits -= 1
        return bits

    # sums

    def _total(self, step: Instruction, a: FixedValue, b: FixedValue) -> FixedValue:
        """A sum or difference."""
        exact = sum_of(a, b)
        given = list(zip((a, b), step.operands, strict=True))
        bits = min(bits_for(exact.reach), max(
            x.bits if not isinstance(of, Constant) or x.error else _least_bits(of)
            for x, of in given))
        bits = min(bits, *(min(bits_for(x.reach), x.bits + OF_ANGLES) for x, of in given
                           if not isinstance(of, Constant)))
        while True:
            terms = [self._term(step, x, of, bits) for x, of in given]
            rounding = terms[0].error + terms[1].error
            if fits(exact.reach + rounding, bits):
                break
            bits -= 1
        given = [(self._unrounded(x, of, bits), of) for x, of in given]
        exact, terms = sum_of(*(x for x, _ in given)), [self._term(step, x, of, bits)
                                                      for x, of in given]
        operands = [self._aligned(step, x.operand, term) for (x, _), term in
                    zip(given, terms, strict=True)]
        return rounded(exact, self._issue(step, step.op, *operands), bits,
                        terms[0].error + terms[1].error)

    def _unrounded(self, x: FixedValue, of: Operand, bits: int) -> FixedValue:
        """The 64 bits of a value that this sum alone uses, if it shifts them: it rounds once."""
        wide = self._wide.get(of.name) if isinstance(of, Ref) else None
        if wide and isinstance(of, Ref) and self._uses[of.name] == 1 and \
                x.bits > bits >= wide.bits - _WIDEST:
            return wide
        return x

    def _term(self, step: Instruction, x: FixedValue, of: Operand, bits: int) -> AlignedTerm:
        """A term of a sum with this f."""
        if isinstance(of, Constant):
            value = quantized(of.double, bits)
            return AlignedTerm((), value.error, value.operand)
        return shifts(x, bits)

    def _aligned(self, step: Instruction, x: Operand, term: AlignedTerm) -> Operand:
        """The term's operand, after the instructions that shift it."""
        x = term.operand or x
        for shift in term.shifts:
            x = self._issue(step, Op.ROUNDED_SHIFT, x, shift) if shift > 0 else \
                self._issue(step, Op.MUL, x, 2**-shift)
        return x

    def _shifted(self, step: Instruction, x: FixedValue, bits: int) -> FixedValue:
        """The value with this smaller f."""
        term = shifts(x, bits)
        return rounded(x, self._aligned(step, x.operand, term), bits, term.error)

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
        exact = sum_of(a, b)
        floors = NONE
        for x in (a, b):
            floors = floors + (Upward(ldexp(1, -wide)) if x.bits > wide else NONE)
        bits = self._narrow(exact, wide, floors)
        terms = [self._issue(step, Op.WIDE_PRODUCT, *(
            self.value(y).operand for y in self._plain[name].operands), wide - x.bits)
            for name, x in zip(names, (a, b), strict=True)]
        total = self._issue(step, step.op, *terms)
        rounding = floors + half_unit(bits) if bits < wide else floors
        self._wide[step.name] = exact._replace(operand=total, bits=wide, error=exact.error + floors)
        return rounded(exact, self._issue(step, Op.ROUNDED_SHIFT, total, wide - bits), bits,
                        rounding)


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
