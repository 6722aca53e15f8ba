"""Evaluates polynomial programs on whole batches, in arithmetic whose own errors are negligible.

Numbers of single precision are computed with in long double, of double precision in pairs of long
doubles hi + lo, |lo| <= ulp(hi)/2.  With w = 2^-64, long double's u, each operation is off by at
most w, or 8 w², of its result: sums of pairs by 3 w² + 13 w³ (AccurateDWPlusDW), products by 5 w²
(DWTimesDW1).  Source: M. Joldes, J.-M. Muller, V. Popescu, ACM TOMS 44 (2017) 15; J.-M. Muller,
L. Rideau, ACM TOMS 48 (2022) 9.  So the analysis that counts a program's roundings bounds what it
computes here, too: |found - x| <= (c1 + 1) e S (1 + O(e)), e = w or 8 w².  Long double reaches from
2^-16382 to 2^16383: no product of five doubles leaves it.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.accuracy.bounds import Bound, Polynomial, bounds_of
from coscrew_codegen.program import Input, Op, Program
from coscrew_codegen.program.interpreter import by_operation, evaluate
from coscrew_codegen.program.values.formats import Precision

WIDE = np.longdouble
IS_WIDE = np.finfo(WIDE).nmant == 63 and np.finfo(WIDE).maxexp == 16384
_SPLIT = WIDE(2**32 + 1)
_UNIT = {"single": 2.0**-64, "double": 2.0**-125}  # of an operation: e


@dataclass(frozen=True)
class Wide:
    """hi + lo; lo is None if it is zero."""

    hi: np.ndarray
    lo: np.ndarray | None = None

    def __neg__(self) -> "Wide":
        return Wide(-self.hi, None if self.lo is None else -self.lo)


@dataclass(frozen=True)
class Enclosed:
    """Results (n, components): |hi + lo - x| <= radius."""

    hi: np.ndarray
    lo: np.ndarray
    radius: np.ndarray
    terms: np.ndarray  # S

    def farthest(self, results: np.ndarray) -> np.ndarray:
        """A bound on |results - x|.  The difference is rounded twice, by 2^-64 each."""
        difference = np.abs((results.astype(WIDE) - self.hi) - self.lo)
        return difference * WIDE(1 + 2.0**-60) + self.radius


def enclosed(program: Program, precision: Precision, rows: np.ndarray) -> Enclosed:
    """The exact results of a polynomial program for rows of all input components."""
    columns = rows.astype(WIDE).T
    result = _evaluated(program, precision, columns)
    bounds = _bounds(program)
    sizes, unit = np.abs(columns), WIDE(_UNIT[precision.name])
    terms = np.stack([_sum(program, bound.terms, sizes) for bound in bounds], axis=1)
    factors = np.array([float(bound.c1) + 1 if bound.rounded else 0 for bound in bounds], WIDE)
    hi = np.stack([np.broadcast_to(x.hi, len(rows)) for x in result], axis=1)
    lo = np.stack([np.broadcast_to(WIDE(0) if x.lo is None else x.lo, len(rows)) for x in result],
                  axis=1)
    return Enclosed(hi, lo, factors * unit * terms * WIDE(1 + 2.0**-40), terms)


def _bounds(program: Program) -> tuple[Bound, ...]:
    result = bounds_of(program)
    assert result, "only polynomial programs have bounds"
    return result


def _evaluated(program: Program, precision: Precision, columns: np.ndarray) -> list[Wide]:
    places = _places(program)
    product, total = ((_pair_product, _pair_sum) if precision.name == "double" else
                      (lambda a, b: Wide(a.hi * b.hi), lambda a, b: Wide(a.hi + b.hi)))
    rules = {Op.ADD: total, Op.SUB: lambda a, b: total(a, -b), Op.MUL: product,
             Op.NEG: Wide.__neg__}
    inputs = [[Wide(columns[places[Input(number, i)]]) for i in range(argument.quantity.size)]
              for number, argument in enumerate(program.inputs)]
    return evaluate(program, inputs, by_operation(
        lambda x: Wide(np.array(float(precision.value(x)), WIDE)), rules))


def _places(program: Program) -> dict[Input, int]:
    inputs = [Input(number, i) for number, a in enumerate(program.inputs)
              for i in range(a.quantity.size)]
    return {x: place for place, x in enumerate(inputs)}


def _sum(program: Program, terms: Polynomial, sizes: np.ndarray) -> np.ndarray:
    """Σ |coefficient| · |monomial|, off by fewer than 2^-50 of it."""
    places = _places(program)
    total = np.zeros(sizes.shape[1], WIDE)
    for monomial, coefficient in terms.items():
        term = WIDE(abs(float(coefficient)))
        for x in monomial:
            term = term * sizes[places[x]]
        total += term
    return total


def linear(program: Program, component: int, place: int,
           rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(p, q) with component = p + q · input number `place`; q is NaN if there is none."""
    places, columns = _places(program), rows.astype(WIDE).T
    parts = np.zeros((2, len(rows)), WIDE)
    for monomial, coefficient in _bounds(program)[component].terms.items():
        own = [x for x in monomial if places[x] == place]
        if len(own) > 1:
            return parts[0], np.full(len(rows), np.nan, WIDE)
        term = WIDE(float(coefficient))
        for x in monomial:
            term = term * (1 if places[x] == place else columns[places[x]])
        parts[len(own)] += term
    return parts[0], parts[1]


# pairs


def _two_sum(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def _fast_two_sum(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    s = a + b
    return s, b - (s - a)


def _two_product(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    p = a * b
    (ah, al), (bh, bl) = _halves(a), _halves(b)
    return p, ((ah * bh - p) + ah * bl + al * bh) + al * bl


def _halves(a: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    c = _SPLIT * a
    high = c - (c - a)
    return high, a - high


def _pair_sum(a: Wide, b: Wide) -> Wide:
    s, rest = _two_sum(a.hi, b.hi)
    lows: Sequence[np.ndarray] = [x.lo for x in (a, b) if x.lo is not None]
    if not lows:
        return Wide(s, rest)
    t, last = _two_sum(*lows) if len(lows) == 2 else (lows[0], 0)
    v, v_rest = _fast_two_sum(s, rest + t)
    return Wide(*_fast_two_sum(v, last + v_rest))


def _pair_product(a: Wide, b: Wide) -> Wide:
    p, rest = _two_product(a.hi, b.hi)
    cross = [x.hi * y.lo for x, y in ((a, b), (b, a)) if y.lo is not None]
    return Wide(*_fast_two_sum(p, rest + sum(cross))) if cross else Wide(p, rest)
