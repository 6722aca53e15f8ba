"""Proved bounds of the effect of roundings on the results of a Program, over ranges of its
arguments.

For every value the analysis keeps: the range of the computed value, and a power of two that it is a
multiple of; the value in exact arithmetic, as an affine form of the unknowns; and the difference of
the two, as an affine form of the roundings.  So a rounding that enters twice can cancel, and a
difference with few enough digits is known to be exact.

Numbers are integers in units of 2^-scale; their own rounding is added to the forms' remainders."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import count, pairwise
from math import isqrt
from typing import TypeAlias

from coscrew_codegen.program import Constant, Instruction, Op, Program, Ref, without_dead_steps
from coscrew_codegen.program.elementary.proofs.affine import Form, ceil_shift
from coscrew_codegen.program.elementary.proofs.tracked import (
    ANY_GRID,
    ImpossibleError,
    Known,
    TrackedValue,
    Undecided,
    UndecidedError,
    absolute,
    equal,
    last_bit,
    less,
    negated,
    selected,
    signed,
)
from coscrew_codegen.program.interpreter import Arithmetic, evaluate
from coscrew_codegen.program.values.formats import Format

__all__ = ["Before", "ImpossibleError", "Known", "Knowledge", "Roundings", "UndecidedError",
           "TrackedValue", "given", "pieces"]


@dataclass(frozen=True)
class Before:
    """States that a result, before it is rounded, lies between low and high."""

    low: Fraction
    high: Fraction


Knowledge: TypeAlias = Mapping[str, Callable[[Known], Known] | Before]
"""From names of steps to functions that refine their results by further knowledge."""


class Roundings:
    """The analysis in a format."""

    def __init__(self, precision: Format, scale: int = 320) -> None:
        self.precision, self.scale = precision, scale
        self._symbols = count()
        self._before: tuple[int, int] | None = None

    # --- ranges and knowledge ---

    def constant(self, x: Fraction | int) -> TrackedValue:
        return self.within(x, x)

    def within(self, low: Fraction | int, high: Fraction | int, grid: int
               | None = None) -> TrackedValue:
        """Returns an argument: any number of the format from low to high that is a multiple of
        2^grid."""
        bounds = self._down(Fraction(low)), -self._down(-Fraction(high))
        if grid is None:
            grid = last_bit(Fraction(low)) if low == high else self._least_grid(*bounds)
        return TrackedValue(*bounds, grid, self._between(*bounds), Form(0, {}, 0))

    def restricted(self, low: Fraction, high: Fraction) -> Callable[[Known], Known]:
        """Returns the value with its computed range limited to low … high."""
        def restrict(value: Known) -> Known:
            assert isinstance(value, TrackedValue)
            a, b = self._common(value.low, value.high, self._down(low), -self._down(-high))
            size = value.error.radius
            exact = self._between(a, b)
            exact = replace(exact, spread=exact.spread + size)
            return replace(value, low=a, high=b, exact=exact,
                           grid=max(value.grid, self._least_grid(a, b)))
        return restrict

    def chosen(self, value: Known) -> Known:
        """Returns the value whose exact arithmetic takes the computed value as its own, whatever it
        is."""
        assert isinstance(value, TrackedValue)
        exact = Form(value.exact.mid, dict(value.exact.parts), value.exact.spread)
        if value.low == value.high:
            exact = Form(value.low, {}, 0)
        elif value.error.radius:
            exact.parts[next(self._symbols)] = value.error.radius
        return replace(value, exact=exact, error=Form(0, {}, 0))

    def number(self, x: int) -> Fraction:
        """The number that an integer stands for."""
        return Fraction(x, 2**self.scale)

    # --- results ---

    def results(self, program: Program, steps: Sequence[str], arguments: Sequence[TrackedValue],
                knowledge: Knowledge) -> list[TrackedValue]:
        """The values of some steps of a Program."""
        part = without_dead_steps(replace(program, results=tuple(map(Ref, steps))))
        result = evaluate(part, [[x] for x in arguments], self._arithmetic(knowledge))
        for x in result:
            if isinstance(x, Undecided):
                raise UndecidedError(x.reason)
        return [x for x in result if isinstance(x, TrackedValue)]

    def ulps(self, value: TrackedValue, relative: Fraction = Fraction(0),
             absolute: Fraction = Fraction(0)) -> Fraction:
        """A bound of |computed - true| in ulps of the true value.

        It differs from the exact one by at most `relative` of itself and `absolute`.  Half an ulp
        is the last rounding: where only it crosses a power of two, it does so towards the true
        value, or leaves that with the larger ulp."""
        assert value.rounding is not None and value.before[0] * value.before[1] > 0
        parts = {s: x for s, x in value.error.parts.items() if s != value.rounding}
        least, largest = sorted(map(abs, value.before))
        others = self.number(Form(0, parts, value.error.spread).radius + abs(value.error.mid))
        ulp = self._ulp(least)
        in_ulps = (others + absolute) / ulp + relative * min(
            self.number(largest + 1) / ulp, Fraction(2)**self.precision.digits)
        assert in_ulps < Fraction(1, 2), "too much for the argument about the last rounding"
        return Fraction(1, 2) + in_ulps

    def _ulp(self, size: int) -> Fraction:
        exponent = size.bit_length() - 1 - self.scale
        return Fraction(2)**(max(exponent, self.precision.least_exponent)
                             + 1 - self.precision.digits)

    # --- operations ---

    def _arithmetic(self, knowledge: Knowledge) -> Arithmetic[Known]:
        table: dict[Op, Callable[..., Known]] = {
            Op.ADD: lambda a, b: self._sum(a, b, 1), Op.SUB: lambda a, b: self._sum(a, b, -1),
            Op.MUL: self._product, Op.SCALE: self._product, Op.DIV: self._quotient,
            Op.NEG: negated, Op.ABS: absolute, Op.COPYSIGN: signed, Op.LESS: less,
            Op.EQUAL: equal, Op.SELECT: selected, Op.POWER: self._power}

        def function(step: Instruction, _: int) -> Callable[..., Known]:
            known, operation = knowledge.get(step.name), table[step.op]
            before = (self._down(known.low), -self._down(-known.high)) if isinstance(
                known, Before) else None

            def computed(*operands: Known) -> Known:
                unknown = [x for x in operands if isinstance(x, Undecided)]
                if unknown and (step.op is not Op.SELECT or operands[0] in unknown):
                    result: Known = unknown[0]
                else:
                    self._before = before
                    try:
                        result = operation(*operands)
                    except UndecidedError as error:
                        result = Undecided(f"{step.name}: {error}")
                return known(result) if callable(known) else result
            return computed

        def constant(x: Constant) -> Known:
            return self.constant(x.double)
        return Arithmetic(constant, function)

    def _sum(self, a: TrackedValue, b: TrackedValue, sign: int) -> TrackedValue:
        other = b if sign > 0 else negated(b)
        for zero, rest in ((a, other), (other, a)):
            if zero.low == zero.high == 0 and not zero.error.radius:
                return replace(rest, exact=a.exact + other.exact, rounding=None)
        return self._rounded(a.low + other.low, a.high + other.high, min(a.grid, b.grid),
                             a.exact + other.exact, a.error + other.error)

    def _product(self, a: TrackedValue, b: TrackedValue) -> TrackedValue:
        """computed - exact = a error(b) + exact(b) error(a)"""
        low, high = self._corners(a, b)
        exact = self._times(a.exact, b.exact)
        error = (b.error.times(a.low, a.high, self.scale)
                 + a.error.times(*b.exact.range, self.scale))
        grid = a.grid + b.grid
        exact_power = any(x.low == x.high and abs(x.low).bit_count() == 1 for x in (a, b))
        return self._rounded(low, high, grid, exact, error, exact_power and grid >= self._finest)

    def _corners(self, a: TrackedValue, b: TrackedValue) -> tuple[int, int]:
        if a is b:
            least = 0 if a.low <= 0 <= a.high else min(abs(a.low), abs(a.high))
            largest = max(abs(a.low), abs(a.high))
            return least * least >> self.scale, ceil_shift(largest * largest, self.scale)
        corners = [x * y for x in (a.low, a.high) for y in (b.low, b.high)]
        return min(corners) >> self.scale, ceil_shift(max(corners), self.scale)

    def _times(self, a: Form, b: Form) -> Form:
        """Returns the product; terms of second order become a new symbol."""
        linear = a.times(b.mid, b.mid, self.scale) + Form(
            0, b.parts, b.spread).times(a.mid, a.mid, self.scale)
        size = ceil_shift(Form(0, a.parts, a.spread).radius * Form(0, b.parts, b.spread).radius,
                          self.scale)
        if not size:
            return linear
        half = size // 2 + 1
        second = Form(half, {next(self._symbols): half}, 0) if a is b else Form(
            0, {next(self._symbols): size}, 0)
        return linear + second

    def _quotient(self, a: TrackedValue, b: TrackedValue) -> TrackedValue:
        """computed - exact = (error(a) - exact quotient · error(b)) / b"""
        if b.high < 0:
            return self._quotient(negated(a), negated(b))
        least, largest = b.exact.range
        if b.low <= 0 or least <= 0:
            raise UndecidedError("the divisor may be 0")
        one = 1 << 2 * self.scale
        inverse = one // b.high, -(-one // b.low)
        exact = self._times(a.exact, self._inverse(b.exact))
        corners = [x * y for x in (a.low, a.high) for y in inverse]
        low, high = min(corners) >> self.scale, ceil_shift(max(corners), self.scale)
        weights = [x * y >> self.scale for x in exact.range for y in inverse]
        error = a.error.times(*inverse, self.scale) - b.error.times(
            min(weights), max(weights) + 1, self.scale)
        return self._rounded(low, high, -ANY_GRID, exact, error)

    def _inverse(self, b: Form) -> Form:
        """1/b: 1/b + b/(l h) is largest at the ends l and h, least at their geometric mean."""
        low, high = b.range
        s = self.scale
        slope = -((1 << 3 * s) // (low * high))
        most = -(-(1 << 2 * s) // low) - (-(1 << 2 * s) // high)
        least = 2 * ((1 << 2 * s) // (isqrt(low * high) + 1))
        line = b.times(slope, slope, s)
        middle, half = (most + least) // 2, (most - least) // 2 + 2
        slack = (b.radius + abs(b.mid) >> s) + 1  # of the slope's last digit
        return line + Form(middle, {next(self._symbols): half}, slack)

    def _power(self, a: TrackedValue, b: TrackedValue) -> TrackedValue:
        if a.low != a.high or b.low != b.high:
            raise UndecidedError("more than one exponent")
        return self.constant(Fraction(2)**((a.low - b.low) >> self.scale))

    # --- rounding ---

    @property
    def _finest(self) -> int:
        """The exponent of the least subnormal number."""
        return self.precision.least_exponent + 1 - self.precision.digits

    def _rounded(self, low: int, high: int, grid: int, exact: Form, error: Form,
                 is_exact: bool = False) -> TrackedValue:
        within = exact + error
        low, high = self._common(low, high, *within.range)
        if self._before:
            low, high = self._common(low, high, *self._before)
            if high - low < exact.radius:  # else the values that it depends on tell more
                exact = replace(self._between(low, high), spread=error.radius)
        size = 0 if is_exact else self._rounding(low, high, grid)
        symbol = next(self._symbols) if size else None
        if symbol is not None:
            error = Form(error.mid, {**error.parts, symbol: size}, error.spread)
        a, b = (self._nearest(low, -size), self._nearest(high, size)) if size else (low, high)
        return TrackedValue(a, b, max(grid, self._least_grid(a, b)), exact, error, symbol,
                            (low, high))

    def _rounding(self, low: int, high: int, grid: int) -> int:
        """The largest error of rounding multiples of 2^grid between low and high."""
        largest, digits = max(abs(low), abs(high)), self.precision.digits
        bits = grid + digits + self.scale
        if not largest or bits >= 0 and largest <= 1 << bits:
            return 0
        exponent = largest.bit_length() - 1  # in units of 2^-scale
        over = largest - (1 << exponent)
        half = self._power_of_two(exponent - digits)
        if over <= half:
            return max(over, self._power_of_two(exponent - 1 - digits))
        return half

    def _power_of_two(self, exponent: int) -> int:
        """2^exponent, at least half the least subnormal number, rounded up."""
        least = self.precision.least_exponent - self.precision.digits + self.scale
        return 1 << max(exponent, least, 0)

    def _nearest(self, x: int, size: int) -> int:
        """Returns the rounded x or, if that is no integer, a number beyond it, so that the rounding
        error is not underestimated."""
        ulp = 2 * self._power_of_two(abs(x).bit_length() - 1 - self.precision.digits)
        return round(Fraction(x, ulp)) * ulp if ulp > 2 else x + size

    def _least_grid(self, low: int, high: int) -> int:
        """The exponent of the ulp of the least number between."""
        if low == high == 0:
            return ANY_GRID
        least = self.precision.least_exponent
        if low > 0 or high < 0:
            least = max(min(abs(low), abs(high)).bit_length() - 1 - self.scale, least)
        return least + 1 - self.precision.digits

    def _common(self, a: int, b: int, c: int, d: int) -> tuple[int, int]:
        low, high = max(a, c), min(b, d)
        if low > high:
            raise ImpossibleError("no argument leads here")
        return low, high

    def _between(self, low: int, high: int) -> Form:
        half = (high - low + 1) // 2
        return Form(low + half, {next(self._symbols): half} if half else {}, 0)

    def _down(self, x: Fraction) -> int:
        return (x.numerator << self.scale) // x.denominator


def given(values: Mapping[str, Known | Before]) -> Knowledge:
    """States that these steps have these results, or lie within these ranges."""
    def instead(value: Known) -> Callable[[Known], Known]:
        return lambda _: value
    return {name: x if isinstance(x, Before) else instead(x) for name, x in values.items()}


def pieces(low: Fraction, high: Fraction, number: int, cuts: Sequence[Fraction] = ()
           ) -> list[tuple[Fraction, Fraction]]:
    """The interval in equal pieces, cut further."""
    ends = {low + (high - low) * i / number for i in range(number + 1)}
    return list(pairwise(sorted(ends | {x for x in cuts if low < x < high})))
