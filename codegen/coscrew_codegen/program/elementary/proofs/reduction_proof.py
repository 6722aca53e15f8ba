"""Proofs that r - r_excess = (x - k π/2) (1 + ε), and bounds of ε."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Program
from coscrew_codegen.program.elementary.evaluation.reduction import (
    EXACT_LEVELS,
    HALF_PI,
    LEVELS,
    REDUCED,
    limit,
    near,
    reduced,
    split,
)
from coscrew_codegen.program.elementary.evaluation.step_writer import StepWriter
from coscrew_codegen.program.elementary.proofs.affine import Form
from coscrew_codegen.program.elementary.proofs.roundings import Known, Roundings, TrackedValue
from coscrew_codegen.program.two_over_pi import chunks
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument

TINY = Fraction(1, 2**1200)
"""More than the errors of HALF_PI and of the sum of all chunks, times the largest number."""


@dataclass(frozen=True)
class Binade:
    """Proved bounds for the numbers of an exponent: |r - r_excess - (x - k π/2)| is at most
    `absolute` more than the relative error; |r_excess| is at most `excess` and half an ulp of r; |x
    - k π/2| is at least `least`."""

    absolute: Fraction
    excess: Fraction
    least: Fraction


@dataclass(frozen=True)
class Reduction:
    """Proved bounds of a reduction for k ≠ 0; at k = 0 it is exact."""

    relative: Fraction  # |ε| is at most this, plus the binades' parts
    largest: Fraction  # |r|
    binades: tuple[Binade, ...]

    def error(self, angle: Fraction) -> Fraction:
        """A bound of |ε| where |x - k π/2| is at least the angle."""
        return self.relative + max(x.absolute / max(x.least, angle) for x in self.binades)

    def excess(self, angle: Fraction) -> Fraction:
        """A bound of |r_excess| beside half an ulp of r, where |x - k π/2| is at most the angle."""
        return max((x.excess for x in self.binades if x.least <= angle), default=Fraction(0))


@cache
def near_is_proved(precision: Precision) -> Reduction:
    """The reduction up to the limit.

    k times the rest of π/2 is rounded, and its sum with the rounding error of r; all else is exact.
    """
    parts, u = split(precision), precision.u
    missing = abs(HALF_PI - sum(parts.parts) - parts.rest)
    largest, binades = HALF_PI / 2, []  # for |x| < 1/2, where k = 0
    for exponent in range(-1, exponent_of(limit(precision)) + 1):
        analysis = Roundings(precision)
        ends = Fraction(2)**exponent, min(2 * Fraction(2)**exponent, limit(precision))
        k, high, low, r, excess = analysis.results(
            near(precision), ["quadrant", "high", "low", "r", "r_excess"],
            [analysis.within(*ends)], {"quadrant": analysis.chosen})
        assert not high.error.radius and not low.error.radius, "these are exact"
        k_high = analysis.number(k.high)
        assert k_high <= 2**parts.k_bits
        rest = k_high * parts.rest * (1 + 3 * u) + u * u
        lost = analysis.number((r.error - excess.error).radius)
        assert lost <= 2 * u * rest + u * u, "two roundings are left"  # the second relative to r
        largest = max(largest, *(abs(analysis.number(x)) for x in (r.low, r.high)))
        binades.append(Binade(2 * u * rest + k_high * missing + TINY, rest,
                              closest(precision, exponent)))
    assert all(32 * x.excess <= x.least for x in binades)
    return Reduction(2 * u * u, largest, tuple(binades))


def exponent_of(x: Fraction) -> int:
    """n with 2^n <= x < 2^(n + 1)"""
    n = x.numerator.bit_length() - x.denominator.bit_length()
    return n if Fraction(2)**n <= x else n - 1


@cache
def far_is_proved(precision: Precision) -> Reduction:
    """The reduction by the digits of 2/π, from the limit to the largest number."""
    u = precision.u
    exponents = range(exponent_of(limit(precision)), precision.bias + 1)
    missing = max(left_out(precision, exponent, LEVELS[precision.digits]) for exponent in exponents)
    least = min(closest(precision, exponent) for exponent in exponents)
    first_grids = {first_grid(precision, exponent) for exponent in exponents}
    results = [_sum_is_proved(precision, grid) for grid in sorted(first_grids)]
    error, tail, largest = (max(column) for column in zip(*results, strict=True))
    fraction = least / HALF_PI
    # times_half_pi rounds five numbers that are at most 3 u of r and the tail.
    relative = (error + missing + 6 * u * tail) / fraction + 12 * u * u
    return Reduction(relative, largest * HALF_PI * (1 + 2 * u),
                     (Binade(Fraction(0), Fraction(0), least),))


def first_grid(precision: Precision, exponent: int) -> int:
    """The first level of a number of this exponent is a multiple of 2^this."""
    some = chunks(precision.digits)
    return exponent + 1 - precision.digits - some.bits * (some.index(exponent) - 1)


def left_out(precision: Precision, exponent: int, count: int) -> Fraction:
    """Proves that so many levels are exact, and that the chunks left out before them are whole
    turns; bounds the chunks left out after them.

    x = high + low, |high| <= 2^(e + 1), a multiple of 2^(e + 1 - bits); |low| <= 2^(e - bits), a
    multiple of 2^(e + 1 - digits)."""
    some, e = chunks(precision.digits), Fraction(2)**exponent
    bits, first = some.bits, some.index(exponent)
    values, units = _levels(precision)
    assert units[first] * 2 * e / 2**bits % 4 == 0
    assert first == 0 or units[first - 1] * 2 * e / 2**precision.digits % 4 == 0
    for n in range(first, first + count):
        _level_is_exact(precision, n)
    last = first + count
    left: Fraction = e / 2**bits * abs(values[last]) + 2 * e * _after(precision, last)
    return left


@cache
def _level_is_exact(precision: Precision, n: int) -> None:
    """Proves exactness for 1 <= |x| < 2, and so for all x: both sides are in proportion to 2^e."""
    values, units = _levels(precision)
    bits, digits = chunks(precision.digits).bits, precision.digits
    unit_high, unit_low = Fraction(2, 2**bits), Fraction(2, 2**digits)
    assert values[n] % units[n] == 0 and abs(values[n]) <= units[n] * 2**(bits - 1)
    grid = units[n] * unit_low
    products = abs(values[n]) / 2**bits, 2 * abs(values[n + 1])
    assert units[n + 1] * unit_high % grid == 0
    assert sum(products) <= Fraction(3, 4) * 2**digits * grid
    assert products[1] <= 2**digits * units[n + 1] * unit_high


@cache
def _levels(precision: Precision) -> tuple[tuple[Fraction, ...], tuple[Fraction, ...]]:
    """The chunks of 2/π, and powers of 2 that divide them."""
    some = chunks(precision.digits)
    return (tuple(x / Fraction(2)**some.scale for x in some.values),
            tuple(Fraction(2)**(-some.bits * (n - 1)) for n in range(len(some.values))))


@cache
def _after(precision: Precision, last: int) -> Fraction:
    """A bound of 2/π less its chunks up to this one."""
    values, _ = _levels(precision)
    return abs(1 / HALF_PI - sum(values[:last + 1], Fraction(0))) + TINY


def _sum_is_proved(precision: Precision, first_grid: int) -> tuple[Fraction, Fraction, Fraction]:
    """Bounds of the error of f + f_low without the last rounding of f_low, of the last summand, and
    of |f + f_low|; levels are at most 3/4 of 2^digits times their units."""
    digits, bits = precision.digits, chunks(precision.digits).bits
    program, last = sum_program(precision), EXACT_LEVELS[digits] - 1
    analysis = Roundings(precision)
    levels = []
    for n in range(LEVELS[digits]):
        grid = first_grid - bits * n
        size = Fraction(3, 4) * 2**digits * Fraction(2)**grid
        levels.append(analysis.within(-size, size, grid))
    knowledge: dict[str, Callable[[Known], Known]] = dict.fromkeys(
        ("rest0_2", "rest4_2", "k1", "k2"), analysis.chosen)
    knowledge["sum2_rest"] = _exact  # k2 = 0, or |sum2| >= 1/2 is a multiple of 2^-digits
    for name in ("sum2", "sum3", "f", *(f"low{n}" for n in range(4, last + 1))):
        knowledge |= _two_sum(name)
    f, low, tail, low3 = analysis.results(
        program, ["f", "f_low", f"tail{last}", "low3"], levels, knowledge)
    assert low3.rounding is None, "exact, so that only the tail is rounded"
    lost = f.error + low.error
    parts = {symbol: x for symbol, x in lost.parts.items() if symbol != low.rounding}
    return (analysis.number(Form(lost.mid, parts, lost.spread).radius),
            analysis.number(max(-tail.low, tail.high)),
            analysis.number(max(-f.low, f.high) + max(-low.low, low.high)))


def sum_program(precision: Precision) -> Program:
    """The part of the reduction that adds levels, as a Program of these."""
    steps = StepWriter(*(Argument(f"t{n}", SCALAR) for n in range(LEVELS[precision.digits])))
    return steps.program("sum", REDUCED, reduced(list(steps.inputs()), precision))


def _two_sum(name: str) -> dict[str, Callable[[Known], Known]]:
    """States that the step `name`_error is exactly the rounding error of the sum `name` (Knuth)."""
    sums: list[TrackedValue] = []

    def remembered(value: Known) -> Known:
        assert isinstance(value, TrackedValue)
        sums.append(value)
        return value

    def missed(value: Known) -> Known:
        assert isinstance(value, TrackedValue)
        total = sums.pop()
        if total.rounding is None:
            return replace(value, low=0, high=0, exact=Form(0, {}, 0), error=Form(0, {}, 0))
        size = total.error.parts[total.rounding]
        return replace(value, low=-size, high=size, exact=Form(0, {}, 0), rounding=None,
                       error=Form(0, {total.rounding: -size}, 0))

    return {name: remembered, f"{name}_error": missed}


def _exact(value: Known) -> Known:
    """States that the last step did not round."""
    assert isinstance(value, TrackedValue)
    parts = {symbol: x for symbol, x in value.error.parts.items() if symbol != value.rounding}
    return replace(value, error=replace(value.error, parts=parts), rounding=None)


def closest(precision: Precision, exponent: int) -> Fraction:
    """A bound from below of |x - k π/2| for numbers x > 0 of this exponent: the least for any
    multiples of an ulp, at a convergent of ulp / (π/2)."""
    ratio = Fraction(2)**(exponent + 1 - precision.digits) / HALF_PI
    before, denominator = 0, 1
    x, y = ratio.denominator, ratio.numerator % ratio.denominator
    while True:
        quotient, rest = divmod(x, y)
        if quotient * denominator + before >= 2**precision.digits:
            return abs(denominator * ratio - round(denominator * ratio)) * HALF_PI - TINY
        before, denominator = denominator, quotient * denominator + before
        x, y = y, rest
