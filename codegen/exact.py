"""What an operation's formula is on given inputs, exactly, and how far results are from it.

Polynomial formulas are evaluated in rationals, all others in DIGITS decimal digits.  Knows formulas
and formats; nothing of programs, tiers or languages.
"""

import functools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

import mpmath
import numpy as np
import sympy as sp
from gmpy2 import mpq

from coscrew_codegen.operations import PER_PRECISION, Operation
from coscrew_codegen.program import Constant
from coscrew_codegen.special import SPECIAL
from coscrew_codegen.targets.precision import Precision

UNIT = {"double": mpq(1, 2**53), "single": mpq(1, 2**24)}
CONDITION = {"double": mpq(9 * 10**14), "single": mpq(16 * 10**6)}
DIGITS = 120

_LEAST = {"double": mpq(1, 2**1074), "single": mpq(1, 2**149)}  # the subnormals' spacing


@dataclass(frozen=True)
class Truth:
    """The results of many rows of inputs, (rows, components), as pairs: x = near + rest · unit.

    `near` is x as the nearest double, `unit` what errors are counted in, `rest` what is missing, so
    that differences are exact to a few 2^-53 of themselves.  `terms` is S, the sum of the absolute
    values of the polynomial's terms; NaN where the formula is no polynomial."""

    near: np.ndarray
    rest: np.ndarray
    unit: np.ndarray
    terms: np.ndarray

    def errors(self, results: np.ndarray) -> np.ndarray:
        """|results - x| in units; infinite for what is not finite."""
        with np.errstate(all="ignore"):
            errors = np.abs((results.astype(float) - self.near) / self.unit - self.rest)
        return np.where(np.isfinite(results), errors, np.inf)

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
    """Whether every component is a polynomial in the inputs."""
    return all(x.is_polynomial(*_symbols(operation)) and not x.has(*PER_PRECISION)
               for x in formula(operation))


@functools.cache
def exact_functions(operation: Operation) -> tuple[tuple[Callable, Callable], ...]:
    """(x, S) of each result as functions of all input components, from the polynomial's terms."""
    symbols = _symbols(operation)

    def pair(expression: sp.Expr) -> tuple[Callable, Callable]:
        expanded = sp.expand(expression)
        terms = [term.as_coeff_Mul() for term in sp.Add.make_args(expanded)]
        absolute = sp.Add(*(abs(coefficient) * rest for coefficient, rest in terms))
        return over_one_denominator(expanded), over_one_denominator(absolute)

    def over_one_denominator(polynomial: sp.Expr) -> Callable:
        """Printed as it is, 1/2 would be a float, and what it multiplies would be rounded."""
        numerator, denominator = sp.fraction(sp.together(polynomial))
        function = sp.lambdify(symbols, sp.expand(numerator), "math")
        return lambda *values: function(*values) / int(denominator)

    return tuple(map(pair, formula(operation)))


def ulp(truth: mpq, precision: Precision) -> mpq:
    """The spacing of the numbers around `truth`, of the binade it lies in."""
    if not truth:
        return _LEAST[precision.name]
    top, bottom = abs(truth.numerator), truth.denominator
    exponent = top.bit_length() - bottom.bit_length()
    if mpq(top, bottom) < mpq(2)**exponent:
        exponent -= 1
    return max(2 * mpq(2)**exponent * UNIT[precision.name], _LEAST[precision.name])


def truth(operation: Operation, precision: Precision, rows: np.ndarray) -> Truth:
    """The exact results for rows that hold all input components of a call each."""
    evaluate, units_of = _evaluator(operation, precision), _units(operation, precision)
    found = [evaluate(row) for row in rows.tolist()]
    units = list(map(units_of, found))
    shape = (len(found), len(formula(operation)))
    near = np.array([[float(x) for x in values] for values in found]).reshape(shape)
    rest = [[float((x - mpq(n)) / unit) if np.isfinite(n) else 0.0
             for x, n, unit in zip(*row, strict=True)]
            for row in zip(found, near.tolist(), units, strict=True)]
    terms = np.full(shape, np.nan)
    if is_polynomial(operation):
        magnitudes = np.abs(rows.astype(float)).T
        for component, (_, absolute) in enumerate(exact_functions(operation)):
            terms[:, component] = absolute(*magnitudes)
    return Truth(near, np.array(rest).reshape(shape), np.array(units, float).reshape(shape), terms)


def _symbols(operation: Operation) -> list[sp.Symbol]:
    return [symbol for a in operation.inputs for symbol in a.symbols]


def _evaluator(operation: Operation,
               precision: Precision) -> Callable[[Sequence[float]], list[mpq]]:
    """The components for one row; of no polynomial, rounded to DIGITS digits."""
    if is_polynomial(operation):
        functions = [exact for exact, _ in exact_functions(operation)]

        def rational(row: Sequence[float]) -> list[mpq]:
            values = list(map(mpq, row))
            return [mpq(exact(*values)) for exact in functions]

        return rational
    function, constants = _multiprecise(operation), _constants(precision)

    def multiprecise(row: Sequence[float]) -> list[mpq]:
        with mpmath.workdps(DIGITS):
            found = function(*map(mpmath.mpf, (*row, *constants)))
            return [_rational(mpmath.mpf(x)) for x in found]

    return multiprecise


def _constants(precision: Precision) -> list[mpmath.mpf]:
    """The values of PER_PRECISION, as numbers of this precision."""
    values = (Constant(*(Fraction(int(x.p), int(x.q)) for x in pair))
              for pair in PER_PRECISION.values())
    return [mpmath.mpf(float(precision.rounded(precision.value(x)))) for x in values]


def _multiprecise(operation: Operation) -> Callable[..., Sequence[mpmath.mpf]]:
    return sp.lambdify([*_symbols(operation), *PER_PRECISION], formula(operation),
                       [SPECIAL, "mpmath"], cse=True)


def _rational(x: mpmath.mpf) -> mpq:
    """The number itself: mpmath's numbers are binary fractions."""
    return mpq(*mpmath.libmp.to_rational(x._mpf_))


def _units(operation: Operation,
           precision: Precision) -> Callable[[Sequence[mpq]], list[mpq]]:
    """What errors are counted in: ulp; in normwise operations u times the part's largest |x|."""
    if not operation.normwise:
        return lambda values: [ulp(x, precision) for x in values]
    parts = _parts(operation)

    def relative(values: Sequence[mpq]) -> list[mpq]:
        largest = {part: max(abs(x) for x, of in zip(values, parts, strict=True) if of == part)
                   for part in dict.fromkeys(parts)}
        return [max(largest[part] * UNIT[precision.name], _LEAST[precision.name])
                for part in parts]

    return relative


def _parts(operation: Operation) -> list[tuple[str, str]]:
    """What each component is measured with: the whole output where that is named, else the part."""
    named = {name for name, _ in operation.normwise}
    return [(a.name, "" if a.name in named else a.quantity.parts[a.quantity.place(*at)[0]].name)
            for a in operation.outputs for at in a.quantity.indices]
