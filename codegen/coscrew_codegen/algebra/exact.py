"""Evaluates an operation's formula exactly on given inputs, and measures the errors of results.

Polynomial formulas are evaluated in rationals, all others in DIGITS decimal digits.  Knows formulas
and formats; nothing of programs, tiers or languages."""

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

import mpmath
import numpy as np
import sympy as sp
from gmpy2 import mpq

from coscrew_codegen.algebra.operations import PER_PRECISION, Operation
from coscrew_codegen.algebra.special_values import SPECIAL, rational
from coscrew_codegen.program import Constant
from coscrew_codegen.program.text_module import imported
from coscrew_codegen.program.values.formats import PRECISIONS, Precision

Exact = Callable[..., mpq]  # of all input components

UNIT = {x.name: mpq(x.u.numerator, x.u.denominator) for x in PRECISIONS}
CONDITION = {"double": mpq(9 * 10**14), "single": mpq(16 * 10**6)}
DIGITS = 120

_LEAST = {x.name: 2 * mpq(x.eta.numerator, x.eta.denominator)
          for x in PRECISIONS}  # spacing of subnormal numbers


@dataclass(frozen=True)
class Truth:
    """The exact results x for many rows of inputs, (rows, components), as x = near + rest · unit.

    `near` is the double nearest to x, `unit` the unit that errors are counted in, `rest` the
    remainder: differences from x have a relative error of a few 2^-53.  Where the formula divides
    by zero, `near` is NaN.  `terms` is S, the sum of the absolute values of the polynomial's terms;
    NaN if the formula is not a polynomial.  `overflows`: intermediate results may overflow."""

    near: np.ndarray
    rest: np.ndarray
    unit: np.ndarray
    terms: np.ndarray
    overflows: np.ndarray

    def errors(self, results: np.ndarray) -> np.ndarray:
        """|results - x| in units; infinite where the result is not finite, or NaN where it may
        overflow or x does not exist."""
        with np.errstate(all="ignore"):
            errors = np.abs((results.astype(float) - self.near) / self.unit - self.rest)
        lost = np.where(self.overflows | np.isnan(self.near), np.nan, np.inf)
        return np.where(np.isfinite(results), errors, lost)

    @property
    def condition(self) -> np.ndarray:
        """S / |x|; infinite where the result is zero."""
        with np.errstate(all="ignore"):
            return np.where(self.near == 0, np.inf, self.terms / np.abs(self.near))


@functools.cache
def formula(operation: Operation) -> tuple[sp.Expr, ...]:
    """The components of the formula."""
    return operation.truth()


@functools.cache
def is_polynomial(operation: Operation) -> bool:
    """Returns whether every component is a polynomial in the inputs."""
    return all(x.is_polynomial(*_symbols(operation)) and not x.has(*PER_PRECISION)
               for x in formula(operation))


@functools.cache
def exact_functions(operation: Operation) -> tuple[tuple[Exact, Exact], ...]:
    """(x, S) of each result as functions of all input components, from the polynomial's terms."""
    symbols = _symbols(operation)
    ring = sp.ring(symbols, sp.QQ)[0]

    def pair(expression: sp.Expr) -> tuple[Exact, Exact]:
        terms = ring.from_expr(expression).terms()
        return _evaluating(terms), _evaluating([(powers, abs(x)) for powers, x in terms])

    return tuple(map(pair, formula(operation)))


def _evaluating(terms: Sequence[tuple[tuple[int, ...], mpq]]) -> Exact:
    """The sum of coefficients times powers of all variables, with integer coefficients over one
    denominator: 1/2 would be a float, and be rounded."""
    denominator = math.lcm(*(int(x.denominator) for _, x in terms))
    products = [" * ".join([str(x.numerator * (denominator // x.denominator)),
                            *(f"x{n}**{power}" if power > 1 else f"x{n}"
                              for n, power in enumerate(powers) if power)]).removeprefix("1 * ")
                for powers, x in terms]
    names = ", ".join(f"x{n}" for n in range(len(terms[0][0]))) if terms else "*_"
    divided = f" / {denominator}" if denominator > 1 else ""
    text = f"def function({names}):\n return ({' + '.join(products) or 0}){divided}"
    function: Exact = imported("polynomial", text).function
    return function


def ulp(truth: mpq, precision: Precision) -> mpq:
    """The unit in the last place: the spacing of numbers in the binade of `truth`."""
    if not truth:
        return _LEAST[precision.name]
    top, bottom = abs(truth.numerator), truth.denominator
    exponent = top.bit_length() - bottom.bit_length()
    if mpq(top, bottom) < mpq(2)**exponent:
        exponent -= 1
    return max(2 * mpq(2)**exponent * UNIT[precision.name], _LEAST[precision.name])


def truth(operation: Operation, precision: Precision, rows: np.ndarray) -> Truth:
    """The exact results; each row holds all input components of one call."""
    evaluate, units_of = _evaluator(operation, precision), _units(operation, precision)
    results = [_values(evaluate, row) for row in rows.tolist()]
    shape = (len(results), len(formula(operation)))
    near, rest, units = (np.full(shape, x) for x in (np.nan, 0.0, 1.0))
    for place, values in enumerate(results):
        for component, (x, unit) in enumerate(zip(values, units_of(values), strict=True)):
            n = near[place, component] = _nearest(x)
            if np.isfinite(n):
                units[place, component] = unit
                rest[place, component] = (x - mpq(n)) / unit
    return Truth(near, rest, units, *_sizes(operation, precision, rows, near))


def _values(evaluate: Callable[[Sequence[float]], list[mpq]], row: Sequence[float]) -> list[mpq]:
    """The components; none where the formula divides by zero."""
    try:
        return evaluate(row)
    except ZeroDivisionError:
        return []


def _nearest(x: mpq) -> float:
    try:
        return float(x)
    except OverflowError:
        return math.copysign(math.inf, int(x > 0) - 0.5)


def _sizes(operation: Operation, precision: Precision, rows: np.ndarray,
           near: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(S, whether anything may overflow).

    The second follows from S of the inputs, raised to 1 where they are smaller.  A formula that is
    not a polynomial may overflow only if its largest component does."""
    most = float(np.finfo(precision.numpy_type).max)
    if not is_polynomial(operation):
        largest = np.abs(near).max(axis=1, keepdims=True, initial=0)
        too_large = largest >= most / 64 if operation.normwise else largest > most
        return np.full(near.shape, np.nan), np.broadcast_to(too_large, near.shape)
    magnitudes = np.abs(rows.astype(float)).T
    with np.errstate(all="ignore"):
        terms, reach = (np.stack([np.broadcast_to(absolute(*sizes), len(rows)) for _, absolute in
                                  exact_functions(operation)], axis=1).astype(float)
                        for sizes in (magnitudes, np.maximum(magnitudes, 1)))
    return terms, ~(reach < most / 2**30)


def _symbols(operation: Operation) -> list[sp.Symbol]:
    return [symbol for a in operation.inputs for symbol in a.symbols]


def _evaluator(operation: Operation,
               precision: Precision) -> Callable[[Sequence[float]], list[mpq]]:
    """The function from a row to its components; rounded to DIGITS digits unless polynomial."""
    if is_polynomial(operation):
        functions = [exact for exact, _ in exact_functions(operation)]

        def polynomial(row: Sequence[float]) -> list[mpq]:
            values = list(map(mpq, row))
            return [mpq(exact(*values)) for exact in functions]

        return polynomial
    function, constants = _multiprecise(operation), _constants(precision)

    def multiprecise(row: Sequence[float]) -> list[mpq]:
        with mpmath.workdps(DIGITS):
            result = function(*map(mpmath.mpf, (*row, *constants)))
            return [rational(mpmath.mpf(x)) for x in result]

    return multiprecise


def _constants(precision: Precision) -> list[mpmath.mpf]:
    """The values of PER_PRECISION, as numbers of this precision."""
    values = (Constant(Fraction(int(double.p), int(double.q)),
                       Fraction(int(single.p), int(single.q)))
              for double, single in PER_PRECISION.values())
    return [mpmath.mpf(float(precision.rounded(precision.value(x)))) for x in values]


def _multiprecise(operation: Operation) -> Callable[..., Sequence[mpmath.mpf]]:
    function: Callable[..., Sequence[mpmath.mpf]] = sp.lambdify(
        [*_symbols(operation), *PER_PRECISION], formula(operation), [SPECIAL, "mpmath"], cse=True)
    return function


def _units(operation: Operation,
           precision: Precision) -> Callable[[Sequence[mpq]], list[mpq]]:
    """The units of errors: one ulp; for normwise operations u times the part's largest |x|."""
    if not operation.normwise:
        return lambda values: [ulp(x, precision) for x in values]
    parts = _parts(operation)

    def relative(values: Sequence[mpq]) -> list[mpq]:
        if not values:
            return []
        largest = {part: max(abs(x) for x, of in zip(values, parts, strict=True) if of == part)
                   for part in dict.fromkeys(parts)}
        return [max(largest[part] * UNIT[precision.name], _LEAST[precision.name])
                for part in parts]

    return relative


def _parts(operation: Operation) -> list[tuple[str, str]]:
    """Returns for each component the numbers that its error is relative to: the whole output if a
    bound names it, else its part."""
    named = {bound.part for bound in operation.normwise}
    return [(a.name, "" if a.name in named else a.quantity.parts[a.quantity.place(*at)[0]].name)
            for a in operation.outputs for at in a.quantity.indices]
