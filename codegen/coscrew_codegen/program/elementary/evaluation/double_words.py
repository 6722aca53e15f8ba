"""Numbers of twice the digits: pairs high + low, with bounds of their errors.

Every rule below adds, in rationals, the largest errors of its roundings and of the terms that it
leaves out; a rounding errs by at most u of the rounded number, plus η. Products and sums of the
high parts are exact together with their errors (PRODUCT_ERROR; Knuth, Dekker)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from math import ceil, factorial, log2

from coscrew_codegen.program import Op
from coscrew_codegen.program.elementary.evaluation.polynomial import estrin
from coscrew_codegen.program.elementary.evaluation.reduction import nearest, ordered_sum, two_sum
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.roundoff import product_error
from coscrew_codegen.program.values.formats import Precision

_ZERO = Fraction(0)


def upward(x: Fraction) -> Fraction:
    """x >= 0 rounded up to about 48 bits, so that bounds stay short."""
    unit = Fraction(2)**(x.numerator.bit_length() - x.denominator.bit_length() - 48)
    return ceil(x / unit) * unit


def _bounded(high: StepValue, low: StepValue | None, *bounds: Fraction) -> "Pair":
    return Pair(high, low, *map(upward, bounds))


def _number(x: StepValue | None, size: Fraction) -> "Pair | None":
    return None if x is None else Pair(x, None, size)


def power_of_two(x: Fraction) -> str:
    """2^-100.9: x, rounded up."""
    return f"2^-{int(-log2(x) * 10) / 10:g}"


@dataclass(frozen=True, eq=False)
class Pair:
    """high + low; |high| <= size, |low| <= rest, |high + low - the number it stands for| <= error.
    """

    high: StepValue
    low: StepValue | None
    size: Fraction
    rest: Fraction = _ZERO
    error: Fraction = _ZERO

    @property
    def most(self) -> Fraction:
        """A bound of the number that it stands for."""
        return self.size + self.rest + self.error

    def scaled(self, size: Fraction) -> "Pair":
        """Returns the pair in a unit in which its size is `size`: for errors relative to a number.
        """
        factor = size / self.size
        return replace(self, size=size, rest=self.rest * factor, error=self.error * factor)

    def less(self, error: Fraction) -> "Pair":
        """Returns the pair for a number that differs by at most `error`."""
        return replace(self, error=self.error + error)


@dataclass(frozen=True)
class Series:
    """Σ ± x^n / n! / x^(first - step) for n = first, first + step, …, |x| <= size < 1; with
    alternating signs if `sign` is negative."""

    size: Fraction
    first: int
    step: int
    sign: int

    def terms(self, precision: Precision) -> tuple[Fraction, ...]:
        """Returns the coefficients that twice the digits need."""
        count = 1
        while self.left_out(count) > precision.u**2 / 32:
            count += 1
        return tuple(self.sign**(n + 1) / Fraction(factorial(self.first + n * self.step))
                     for n in range(count))

    def left_out(self, count: int) -> Fraction:
        """A bound of the terms after the first ones, each being less than half the one before."""
        n = self.first + count * self.step
        return 2 * self.size**(n - self.first + self.step) / factorial(n)


@dataclass(frozen=True)
class Pairs:
    """The operations of pairs in a precision."""

    precision: Precision

    @property
    def tiny(self) -> Fraction:
        """Largest r for which 1 + r and 1, and sin r and r, are the same to twice the digits."""
        return Fraction(1, 2**(self.precision.digits + 1))

    @property
    def eta(self) -> Fraction:
        """Half the least subnormal number, in a unit that is at least `tiny`."""
        return self.precision.eta / self.tiny

    def rounding(self, size: Fraction) -> Fraction:
        """Bounds the rounding error of numbers up to this size."""
        return self.precision.u * size + self.eta

    def product(self, name: str, a: Pair, b: Pair) -> Pair:
        """a b = high + (the error of high + (a_low b + a b_low)); a_low b_low is left out."""
        steps, product = a.high.steps, a.size * b.size
        high, lost = steps.named(name, a.high * b.high), self.rounding(product)
        missed = a.rest * b.rest + self.eta + product_error(
            a.size + a.rest, a.error, b.size + b.rest, b.error)
        low = Pair(steps.do(Op.PRODUCT_ERROR, a.high, b.high, high), None, lost, error=missed)
        steps.named(f"{name}_error", low.high)
        return self._with_lows(name, high, product + lost, low, self._sum_of_lows(
            self._product_of_lows(_number(a.high, a.size), _number(b.low, b.rest)),
            self._product_of_lows(_number(a.low, a.rest), _number(b.high, b.size))))

    def _with_lows(self, name: str, high: StepValue, size: Fraction, low: Pair, more: Pair | None
                   ) -> Pair:
        """high + (low + more)."""
        total = self._sum_of_lows(low, more)
        assert total is not None
        if more is not None:
            high.steps.named(f"{name}_low", total.high)
        return _bounded(high, total.high, size, total.size, total.error)

    def constant(self, steps: StepWriter, x: Fraction) -> Pair:
        """A number as a pair."""
        high = nearest(x, self.precision)
        low = nearest(x - high, self.precision)
        return Pair(steps.constant(high), steps.constant(low) if low else None, abs(high),
                    abs(low), abs(x - high - low))

    def sum(self, name: str, a: Pair, b: Pair, ordered: bool = False) -> Pair:
        """a + b = high + (the error of high + (b_low + a_low)); ordered: |a_high| >= |b_high|."""
        size = a.size + b.size
        high, low = (ordered_sum if ordered else two_sum)(name, a.high, b.high)
        lost = self.rounding(size)
        return self._with_lows(
            name, high, size + lost, Pair(low, None, lost, error=a.error + b.error),
            self._sum_of_lows(_number(b.low, b.rest), _number(a.low, a.rest)))

    def normal(self, name: str, x: Pair) -> Pair:
        """The pair whose high is high + low rounded, and whose low is the rest: at most u of it."""
        assert x.low is not None and x.rest < x.size / 2
        high = x.high.steps.named(name, x.high + x.low)
        low = x.high.steps.named(f"{name}_low", x.low - (high - x.high))
        size = x.most + self.rounding(x.most)
        return _bounded(high, low, size, self.rounding(x.most), x.error)

    def series(self, name: str, coefficients: Sequence[Fraction], z: Pair) -> Pair:
        """c1 z + c2 z² + …, to be added to 1."""
        return self.product(f"{name}_sum", z, self.horner(name, coefficients, z))

    def horner(self, name: str, coefficients: Sequence[Fraction], z: Pair,
               negligible: Fraction = Fraction(1, 64)) -> Pair:
        """c1 + c2 z + …, to be multiplied by z and added to 1. Values below so many u have no low
        parts, since their roundings then matter by as many u². The coefficients decrease so fast
        that |c z| is less than the one before."""
        limit, last = negligible * self.precision.u, len(coefficients)
        first = next(n for n in range(1, last + 1)
                     if n == last or abs(coefficients[n - 1]) * z.size**n <= limit)
        value = self._plain(f"{name}{first}", coefficients[first - 1:], z)
        for n in range(first - 1, 0, -1):
            c = coefficients[n - 1]
            assert abs(c) >= z.size * value.size * (1 + self.precision.u)
            brief = value.size * z.size**(n + 1) <= limit
            value = self._step(f"{name}{n}", c, z, value, brief)
        return value

    def _plain(self, name: str, coefficients: Sequence[Fraction], z: Pair) -> Pair:
        """c0 + c1 z + …, every operation rounded.  c0 is added last; the sum of the other terms is
        rounded at most twice per coefficient."""
        near = [nearest(c, self.precision) for c in coefficients]
        most = z.size + z.rest + z.error
        size = sum((abs(c) * most**n for n, c in enumerate(near)), _ZERO)
        slope = sum((n * abs(c) * most**(n - 1) for n, c in enumerate(near) if n), _ZERO)
        error = sum((abs(c - x) * most**n for n, (c, x) in enumerate(zip(
            coefficients, near, strict=True))), (z.rest + z.error) * slope)
        error += 3 * len(near) * self.rounding(size - abs(near[0])) + self.rounding(size + error)
        value = (z.high.steps.named(name, estrin(near, z.high)) if len(near) > 1 else
                 z.high.steps.constant(near[0]))
        return _bounded(value, None, size + error, _ZERO, error)

    def _step(self, name: str, c: Fraction, z: Pair, value: Pair, brief: bool) -> Pair:
        """c + z value, z value being rounded if `brief`. The low part of value, the slowest to
        arrive, is used last."""
        steps, constant = z.high.steps, self.constant(z.high.steps, c)
        product = z.size * value.size
        lost = self.rounding(product)
        p = steps.named(f"{name}_z", z.high * value.high)
        high, error = ordered_sum(name, constant.high, p)
        size = constant.size + product + lost
        lows = [_number(constant.low, constant.rest), _number(error, self.rounding(size))]
        missed = constant.error + product_error(
            z.size + z.rest, z.error, value.size + value.rest, value.error)
        if brief:
            assert value.low is None
            missed += lost + z.rest * value.size
        else:
            exact = _number(steps.do(Op.PRODUCT_ERROR, z.high, value.high, p), lost)
            missed += z.rest * value.rest + self.eta
            lows = [self._product_of_lows(_number(value.high, value.size), _number(z.low, z.rest)),
                    exact, *lows,
                    self._product_of_lows(_number(z.high, z.size), _number(value.low, value.rest))]
        low = reduce(self._sum_of_lows, lows)
        assert low is not None
        return _bounded(high, steps.named(f"{name}_low", low.high),
                        size + self.rounding(size), low.size, missed + low.error)

    def _product_of_lows(self, a: Pair | None, b: Pair | None) -> Pair | None:
        """a b of numbers, rounded; None is 0."""
        if a is None or b is None:
            return None
        lost = self.rounding(a.size * b.size)
        return Pair(a.high * b.high, None, a.size * b.size + lost, error=lost)

    def _sum_of_lows(self, a: Pair | None, b: Pair | None) -> Pair | None:
        """a + b, rounded; None is 0."""
        if a is None or b is None:
            return a or b
        size = a.size + b.size
        lost = self.rounding(size)
        return Pair(a.high + b.high, None, size + lost, error=a.error + b.error + lost)

    def grown(self, name: str, r: Pair, series: Pair) -> Pair:
        """r + r series, |series| < 1/2, in the unit of r."""
        assert series.size < Fraction(1, 2)
        return self.sum(name, r, self.product(f"{name}_more", r, series), ordered=True)

    def vanishing(self, name: str, r: Pair) -> StepValue:
        """r's high part, or 0 if |r| is tiny: so that no product with it underflows."""
        return r.high.steps.named(name, (abs(r.high) < self.tiny).where(0, r.high))
