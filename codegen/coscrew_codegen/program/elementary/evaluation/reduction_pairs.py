"""x = k π/2 + r + r_low to more than twice the digits, relative to r: the input of the errors of
sine and cosine."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Program
from coscrew_codegen.program.elementary.evaluation.double_words import Pair, Pairs, upward
from coscrew_codegen.program.elementary.evaluation.reduction import (
    HALF_PI,
    X,
    fraction,
    levels,
    limit,
    nearest,
    ordered_sum,
    split,
    to_integer,
    two_sum,
)
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.elementary.proofs.reduction_proof import (
    TINY,
    closest,
    exponent_of,
    first_grid,
    left_out,
)
from coscrew_codegen.program.two_over_pi import chunks
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument

REDUCED = (Argument("quadrant", SCALAR), Argument("r", SCALAR), Argument("r_low", SCALAR))

LEVELS = 9
"""Number of sums of products with chunks of 2/π for large angles."""


@dataclass(frozen=True)
class Spread:
    """Proved bounds of a sum R of numbers as high + low, unless that is exact: in units of |R|, of
    |high|, of |low| and of |high + low - R|."""

    high: Fraction
    low: Fraction
    error: Fraction


@dataclass(frozen=True)
class ReductionParts:
    """π/2 in parts whose products with any k are exact, and a rounded rest."""

    parts: tuple[Fraction, ...]
    rest: Fraction
    missing: Fraction


@cache
def parts(precision: Precision) -> ReductionParts:
    """The parts of `split` and two more, a bit shorter: sums of products have that bit to spare."""
    known = split(precision)
    result, size = list(known.parts), 2**(precision.digits - known.k_bits - 1)
    for _ in range(2):
        rest = HALF_PI - sum(result)
        unit = Fraction(1, 2**(int(size / rest).bit_length() - 1))
        result.append(int(rest / unit) * unit)
    rest = nearest(HALF_PI - sum(result), precision)
    return ReductionParts(tuple(result), rest, abs(HALF_PI - sum(result) - rest))


@cache
def near(precision: Precision) -> Program:
    """The reduction by Cody and Waite, for |x| <= limit."""
    steps = StepWriter(X)
    x, = steps.inputs()
    return steps.program("near", REDUCED, reduced_near(x, precision))


def reduced_near(x: StepValue, precision: Precision) -> tuple[StepValue, StepValue, StepValue]:
    """The quadrant, r and r_low, for |x| <= limit."""
    steps, data = x.steps, parts(precision)
    k = steps.named("quadrant", to_integer(steps, x * nearest(1 / HALF_PI, precision), precision))
    first, second, third, fourth, fifth = data.parts
    high = steps.named("high", (x - k * first) - k * second)  # exact
    a, low = two_sum("a", high, k * -third)
    b, low = ordered_sum("b", a, steps.named("fourth", low - k * fourth))
    r, low = ordered_sum("r", b, steps.named("fifth", low - k * fifth))
    return k, r, steps.named("r_low", low - k * data.rest)


@cache
def far(precision: Precision) -> Program:
    """The reduction by the digits of 2/π, for |x| from the limit up."""
    steps = StepWriter(X)
    x, = steps.inputs()
    t = levels(steps, x, precision, LEVELS)
    k1, k2, f, low = fraction(t, precision)
    f, low = _collected("f", [f, t[3], low, *t[4:]])
    some = _far_fraction(precision)
    angle = _angle(Pair(f, low, some.high, some.low, some.error), precision)
    assert angle.low is not None
    return steps.program("far", REDUCED, (steps.named("quadrant", k1 + k2), angle.high, angle.low))


def _angle(f: Pair, precision: Precision) -> Pair:
    """f π/2"""
    pairs = Pairs(precision)
    return pairs.normal("r", pairs.product("angle", f, pairs.constant(f.high.steps, HALF_PI)))


def _collected(name: str, terms: Sequence[StepValue]) -> tuple[StepValue, StepValue]:
    """The sum of the terms, the largest first, as high + low: every sum keeps its rounding error,
    twice over.  Source: Ogita, Rump, Oishi, SumK."""
    for again in range(2):
        sums = terms[-1]
        rests: list[StepValue] = []
        for n, term in reversed(list(enumerate(terms[:-1]))):
            sums, error = two_sum(f"{name}_{'ab'[again]}{n}", term, sums)
            rests.insert(0, error)
        terms = [sums, *rests]
    steps, low = terms[0].steps, terms[-1]
    for term in reversed(terms[1:-1]):
        low = term + low
    return terms[0], steps.named(f"{name}_low", low)


def collected(sizes: Sequence[Fraction], least: Fraction, precision: Precision) -> Spread:
    """A bound of the error of `_collected`, for terms up to these sizes and |R| >= least.

    A bound (a, b) stands for a |R| + b.  Each sum errs by at most u of itself."""
    u, bounds = precision.u, [(Fraction(0), size) for size in sizes]
    for _ in range(2):
        rests: list[tuple[Fraction, Fraction]] = []
        total = bounds[-1]
        for size in reversed(bounds[1:-1]):
            total = _plus(total, size, 1 + u)
            rests.insert(0, (total[0] * u, total[1] * u))
        others = (Fraction(1), Fraction(0))  # the first sum is R less the rounding errors
        for rest in rests:
            others = _plus(others, rest, Fraction(1))
        first = others[0] / (1 - u), others[1] / (1 - u)
        bounds = [first, (first[0] * u, first[1] * u), *rests]
    low, error = bounds[-1], (Fraction(0), Fraction(0))
    for size in reversed(bounds[1:-1]):
        low = _plus(low, size, 1 + u)
        error = _plus(error, (low[0] * u, low[1] * u), Fraction(1))
    return Spread(*(upward(a + b / least) for a, b in (bounds[0], low, error)))


def _plus(a: tuple[Fraction, Fraction], b: tuple[Fraction, Fraction], factor: Fraction
          ) -> tuple[Fraction, Fraction]:
    return (a[0] + b[0]) * factor, (a[1] + b[1]) * factor


@cache
def near_spread(precision: Precision, largest: Fraction | None = None) -> Spread:
    """The reduction up to the largest angle, or the limit, unless k = 0: there it is exact.

    Sums of high parts are exact together with their errors, the first by Knuth's, the others by
    Dekker's: the products with the fourth part and those beyond are less than a quarter of |R|."""
    data, u = parts(precision), precision.u
    largest = largest or limit(precision)
    k = int(largest / HALF_PI + Fraction(1, 2))
    assert all(part.numerator.bit_length() + k.bit_length() - 1 <= precision.digits
               for part in data.parts) and k <= 2**split(precision).k_bits
    exponents = range(-1, exponent_of(largest) + 1)
    least = min(closest(precision, exponent) for exponent in exponents)
    sizes = [k * part for part in (*data.parts[3:], data.rest * (1 + u))]
    left, beyond = (x / least for x in (sum(sizes), sizes[-1]))
    assert 4 * left <= 1
    lost = _late_roundings(sizes, least, precision)
    high = (1 + u) * (1 + lost + beyond)
    wrong = k * (data.missing + u * data.rest) + TINY
    return Spread(*map(upward, (high, (u * high + beyond) * (1 + u), lost + wrong / least)))


def _late_roundings(sizes: Sequence[Fraction], least: Fraction, precision: Precision) -> Fraction:
    """Bounds, in units of |R|, the roundings of an error's differences, at most u of a sum, and of
    a product of at most this size.

    All but the last are exact up to 2^digits units of the product's part, since all are multiples
    of that unit.  The rounding is at most u of the result, and at most the product."""
    data, u, worst = parts(precision), precision.u, Fraction(0)
    units = [Fraction(1, part.denominator) for part in data.parts[2:]]
    assert Fraction(1, 2**precision.digits) >= units[0] >= units[1] >= units[2]
    exact = [2**precision.digits * unit for unit in units[1:]] + [Fraction(0)]
    for exponent in range(exponent_of(least), 1):
        low, high = Fraction(2)**exponent, Fraction(2)**(exponent + 1)  # |R| is between
        worst = max(worst, sum((
            min(size, u * (u * (low + sum(sizes)) * (1 + 4 * u) + size)) / low
            for size, most in zip(sizes, exact, strict=True)
            if size + u * (high + sum(sizes)) * (1 + 4 * u) > most), Fraction(0)))
    return worst


@cache
def _far_fraction(precision: Precision) -> Spread:
    """f and f_low beyond the limit; their sum is x 2/π less a whole number."""
    exponents = range(exponent_of(limit(precision)), precision.bias + 1)
    wrong = max(left_out(precision, exponent, LEVELS) for exponent in exponents)
    least = min(closest(precision, exponent) for exponent in exponents) / HALF_PI - wrong
    digits, bits = precision.digits, chunks(precision.digits).bits
    grid = max(first_grid(precision, exponent) for exponent in exponents)
    sizes = [Fraction(3, 4) * 2**digits * Fraction(2)**(grid - bits * n) for n in range(LEVELS)]
    low = precision.u * (3 + sizes[2])  # of the sum of the first three levels' fractions
    result = collected([Fraction(1, 2), sizes[3], low, *sizes[4:]], least, precision)
    return Spread(result.high, result.low, upward(result.error + wrong / least))


@cache
def far_spread(precision: Precision) -> Spread:
    """The reduction beyond the limit."""
    some = _far_fraction(precision)
    x, = StepWriter(X).inputs()
    result = _angle(Pair(x, x, some.high, some.low, some.error), precision)
    return Spread(*(size / HALF_PI for size in (result.size, result.rest, result.error)))


@cache
def spread(precision: Precision) -> Spread:
    """Bounds for both reductions."""
    both = near_spread(precision), far_spread(precision)
    return Spread(*(max(getattr(x, name) for x in both) for name in ("high", "low", "error")))
