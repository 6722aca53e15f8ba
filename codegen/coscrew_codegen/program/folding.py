"""Folds instructions by exact rules on constants, zeros, ones and signs.

A sum absorbs signs (a + (-b) is a - b), a product passes them on ((-a) b is -(a b)), so a negation
remains only where a result needs it.  The rules change two values only: the sign of zero, and 0
times infinity or NaN, which becomes 0."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from typing import NamedTuple

import mpmath

from coscrew_codegen.program import Constant, Instruction, Op, Operand, Ref, constant
from coscrew_codegen.program.interpreter import exactly
from coscrew_codegen.program.program import ONE, ZERO
from coscrew_codegen.program.tables import TableColumn

DIGITS = 60
"""Decimal digits of constants that are not short fractions: far beyond double precision."""

_ADD, _SUB, _MUL, _NEG = Op.ADD, Op.SUB, Op.MUL, Op.NEG
"""Names of this module are looked up five times as fast as members of an Enum."""
_OF_ZERO = {Op.ADD, Op.MUL, Op.SCALE}
_LONGEST = 1 << 1200
_CANCELLED = 120
"""Bits of a sum of constants that cancel when only the rounding of its terms keeps it from zero.
They have 50 digits: an entry of a product of rotations would be 6e-63, beyond single precision's
range.  Pairs of doubles carry 106 bits.
"""
_FAR = 1 << 14
"""For |x| beyond this, exp x is 0 or infinity in every format, even in one of 128 bits.  At t = 0 a
short pulse in time has such a factor, whose fraction would have 10^11 bits."""


class Folded(NamedTuple):
    """The instruction that remains to be issued."""

    op: Op
    operands: tuple[Operand, ...]


class KnownSign(NamedTuple):
    """The negative of the instruction that remains to be issued."""

    of: tuple[Op, tuple[Operand, ...]]


Known = Mapping[str, Instruction]
Result = Operand | Folded | KnownSign


def fraction(value: Fraction | int) -> Fraction:
    """Returns the exact number; refuses floats, which differ from the decimals in the file."""
    if isinstance(value, float):
        raise TypeError(f"{value!r} is a float; numbers of scenes are exact fractions")
    return Fraction(value)


def folded(op: Op, operands: tuple[Operand, ...], known: Known) -> Result:
    """op(operands) folded: an operand, or the instruction that remains to be issued."""
    if op in _OF_ZERO and (operands[0] is ZERO or operands[1] is ZERO):
        return _of_zero(op, *operands)
    constants = [x for x in operands if isinstance(x, Constant)]
    if len(constants) == len(operands) and op is not Op.SELECT:
        return _of_constants(op, tuple(constants))
    rule = _RULES.get(op)
    result = rule(known, *operands) if rule else None
    return Folded(op, operands) if result is None else result


def _of_constants(op: Op, operands: tuple[Constant, ...]) -> Constant | Folded:
    if op is _NEG:
        return _negative(*operands)
    if op is Op.EXP and max(operands[0].double, operands[0].single) > _FAR:
        return Folded(op, operands)
    return _constant(op, operands)


def _constant(op: Op, operands: tuple[Constant, ...]) -> Constant:
    doubles, singles = tuple([x.double for x in operands]), tuple([x.single for x in operands])
    double = _evaluated(op, doubles)
    return constant(double) if singles == doubles else Constant(double, _evaluated(op, singles))


def _of_zero(op: Op, a: Operand, b: Operand) -> Operand:
    """Returns 0 b = 0, or a + 0 = a, the most frequent of all operations: without arithmetic.
    A constant that is a sum has no name."""
    if op is not _ADD:
        return ZERO
    other = b if a is ZERO else a
    return Constant(other.double, other.single) \
        if isinstance(other, Constant) and other.name else other


def _negative(x: Constant) -> Constant:
    """-x, named with an n behind x's name, or without it."""
    name = x.name[:-1] if x.name.endswith("n") else x.name and f"{x.name}n"
    negative = _constant(_NEG, (x,))
    return Constant(negative.double, negative.single, name) if name else negative


def _is(x: Operand, number: int) -> bool:
    return isinstance(x, Constant) and x.double == number and x.single == number


def _negated(x: Operand, known: Known) -> Operand | None:
    """y if x is -y, either as an instruction or as a negative constant; else None."""
    if isinstance(x, Ref):
        step = known[x.name]
        return step.operands[0] if step.op is _NEG else None
    return _negative(x) if isinstance(x, Constant) and x.double.numerator < 0 else None


def _add(known: Known, a: Operand, b: Operand) -> Result | None:
    if _is(a, 0):
        return b
    if _is(b, 0):
        return a
    x, y = _negated(a, known), _negated(b, known)
    if x is not None and y is not None:
        return KnownSign((_ADD, (x, y)))
    if y is not None:
        return _sub(known, a, y) or Folded(_SUB, (a, y))
    if x is not None:
        return _sub(known, b, x) or Folded(_SUB, (b, x))
    return _completed(known, a, b) or _completed(known, b, a) or _joined(known, a, b, 1)


def _completed(known: Known, a: Operand, b: Operand) -> Operand | None:
    """(c - x) + x is c, for a constant c."""
    if isinstance(a, Ref):
        step = known[a.name]
        if step.op is _SUB and step.operands[1] == b and isinstance(step.operands[0], Constant):
            return step.operands[0]
    return None


def _joined(known: Known, a: Operand, b: Operand, sign: int) -> Result | None:
    """c x ± k x is (c ± k) x, for constants c and k, which may be 1."""
    (c, x), (k, y) = _scaled(known, a), _scaled(known, b)
    if x != y or isinstance(x, Constant):
        return None
    both = _constant(_ADD if sign > 0 else _SUB, (c, k))
    return _mul(known, both, x) or Folded(_MUL, (both, x))


def _scaled(known: Known, x: Operand) -> tuple[Constant, Operand]:
    """(c, y) if x is a product c y with a constant c; else (1, x)."""
    if isinstance(x, Ref):
        step = known[x.name]
        if step.op is _MUL and isinstance(factor := step.operands[0], Constant):
            return factor, step.operands[1]
    return ONE, x


def _sub(known: Known, a: Operand, b: Operand) -> Result | None:
    if _is(b, 0):
        return a
    if a == b:
        return ZERO
    if _is(a, 0):
        return _neg(known, b) or Folded(_NEG, (b,))
    if (y := _negated(b, known)) is not None:
        return _add(known, a, y) or Folded(_ADD, (a, y))
    if (x := _negated(a, known)) is not None:
        return KnownSign((_ADD, (x, b)))
    return _joined(known, a, b, -1)


def _mul(known: Known, a: Operand, b: Operand) -> Result | None:
    if isinstance(a, Constant) or isinstance(b, Constant):
        if _is(a, 0) or _is(b, 0):
            return ZERO
        if _is(a, 1):
            return b
        if _is(b, 1):
            return a
    negative_a, negative_b = _negated(a, known), _negated(b, known)
    if negative_a is not None and negative_b is not None:
        return _mul(known, negative_a, negative_b) or Folded(_MUL, (negative_a, negative_b))
    if negative_a is not None:
        return KnownSign((_MUL, (negative_a, b)))
    if negative_b is not None:
        return KnownSign((_MUL, (a, negative_b)))
    return _constants_joined(known, a, b) or _constants_joined(known, b, a)


def _constants_joined(known: Known, c: Operand, x: Operand) -> Result | None:
    """c (k y) is (c k) y."""
    if not (isinstance(c, Constant) and isinstance(x, Ref) and known[x.name].op is _MUL):
        return None
    k, y = known[x.name].operands
    if not isinstance(k, Constant):
        return None
    both = _constant(_MUL, (c, k))
    return y if _is(both, 1) else Folded(_MUL, (both, y))


def _div(known: Known, a: Operand, b: Operand) -> Result | None:
    if _is(a, 0):
        return ZERO
    if _is(b, 1):
        return a
    negative_a, negative_b = _negated(a, known), _negated(b, known)
    if negative_a is not None:
        return KnownSign((Op.DIV, (negative_a, b)))
    if negative_b is not None:
        return KnownSign((Op.DIV, (a, negative_b)))
    if isinstance(b, Constant) and _is_power_of_two(b):
        return Folded(_MUL, (Constant(1 / b.double, 1 / b.single), a))
    return None


def _neg(known: Known, a: Operand) -> Operand | None:
    return _negated(a, known)


def _abs(known: Known, a: Operand) -> Folded | None:
    y = _negated(a, known)
    return None if y is None else Folded(Op.ABS, (y,))


def _odd(op: Op) -> Callable[[Known, Operand], KnownSign | None]:
    def rule(known: Known, a: Operand) -> KnownSign | None:
        y = _negated(a, known)
        return None if y is None else KnownSign((op, (y,)))
    return rule


def _even(op: Op) -> Callable[[Known, Operand], Folded | None]:
    def rule(known: Known, a: Operand) -> Folded | None:
        y = _negated(a, known)
        return None if y is None else Folded(op, (y,))
    return rule


def _select(known: Known, test: Operand, a: Operand, b: Operand) -> Operand | None:
    if a == b:
        return a
    if isinstance(test, Constant) and test.double == test.single:
        return a if test.double else b
    return None


def _gather(known: Known, column: TableColumn, index: Operand) -> Constant | None:
    if column.only is not None:
        return constant(column.only)
    return Constant(column.at(index.double), column.at(index.single)) \
        if isinstance(index, Constant) else None


_RULES: Mapping[Op, Callable[..., Result | None]] = {
    Op.GATHER: _gather,
    Op.ADD: _add, Op.SUB: _sub, Op.MUL: _mul, Op.SCALE: _mul, Op.DIV: _div, Op.NEG: _neg,
    Op.ABS: _abs, Op.SELECT: _select, Op.SIN: _odd(Op.SIN), Op.TANH: _odd(Op.TANH),
    Op.COS: _even(Op.COS)}


def _is_power_of_two(x: Constant) -> bool:
    return x.double == x.single > 0 and all(
        n & (n - 1) == 0 for n in x.double.as_integer_ratio())


def _evaluated(op: Op, values: tuple[Fraction, ...]) -> Fraction:
    if op in _APPROXIMATED:
        return _approximated(op, values)
    exact = _EXACTLY[op](*values)
    if not isinstance(exact, Fraction):
        exact = Fraction(exact)
    if op in (Op.ADD, Op.SUB) and exact and _size(exact) < max(map(_size, values)) - _CANCELLED:
        return Fraction(0)
    return _shortened(exact)


def _size(x: Fraction) -> int:
    """The exponent e with 2^(e-1) < |x| < 2^(e+1); for zero, one below all others."""
    return x.numerator.bit_length() - x.denominator.bit_length() if x else -_LONGEST


@cache
def _approximated(op: Op, values: tuple[Fraction, ...]) -> Fraction:
    if op is Op.EXP and values[0] < -_FAR:
        return Fraction(0)
    with mpmath.workdps(DIGITS):
        numbers = [mpmath.mpf(x.numerator) / x.denominator for x in values]
        return _rational(_EXACTLY[op](*numbers))


_EXACTLY: Mapping[Op, Callable[..., Fraction | mpmath.mpf]] = exactly(mpmath)
_APPROXIMATED = {Op.SQRT, Op.SIN, Op.COS, Op.EXP, Op.TANH, Op.ATAN2}


def _rational(x: mpmath.mpf) -> Fraction:
    if not mpmath.isfinite(x):
        raise ZeroDivisionError(f"a constant of the scene is {x}")
    return Fraction(*map(int, mpmath.libmp.to_rational(x._mpf_)))


def _shortened(x: Fraction) -> Fraction:
    """x, or x to 60 digits if its numerator or denominator is too long."""
    if abs(x.numerator) < _LONGEST and x.denominator < _LONGEST:
        return x
    with mpmath.workdps(DIGITS):
        return _rational(mpmath.mpf(x.numerator) / x.denominator)


def constant_pi() -> Fraction:
    """π to 60 digits."""
    with mpmath.workdps(DIGITS):
        return _rational(+mpmath.pi)
