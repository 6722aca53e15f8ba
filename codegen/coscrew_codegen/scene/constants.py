"""Formulas without time as exact numbers: "pi/2", "0.1*3", "sqrt(0.5)"."""

import math
from collections.abc import Callable
from fractions import Fraction

import mpmath

from coscrew_codegen.scene.formulas import Formula, FormulaError

DIGITS = 50
LENGTH = 100  # characters: longer ones could make fractions of millions of digits

_SMALLEST = mpmath.mpf(10)**-300
_WORKING = (DIGITS + 10, 2 * DIGITS + 20, 500, 1000)  # digits; the sine of 1e300 takes 350


def _bounded(function: Callable[[mpmath.mpf], mpmath.mpf], largest: float
             ) -> Callable[[mpmath.mpf], mpmath.mpf]:
    """Limits a function to arguments up to `largest`, beyond which mpmath would need too many
    digits."""
    def apply(x: mpmath.mpf) -> mpmath.mpf:
        if abs(x) > largest:
            raise OverflowError
        return function(x)
    return apply


_FUNCTIONS = {"sin": _bounded(mpmath.sin, 1e300), "cos": _bounded(mpmath.cos, 1e300),
              "exp": _bounded(mpmath.exp, 1e3), "tanh": _bounded(mpmath.tanh, 1e3),
              "sqrt": mpmath.sqrt, "abs": abs, "min": min, "max": max,
              "number": lambda x: mpmath.mpf(x.numerator) / x.denominator}
_EXACT = {"abs": abs, "min": min, "max": max, "number": lambda x: x}


def constant(text: str) -> Fraction:
    """The value of a formula without t: exact if it is rational, else to 50 digits.

    Raises FormulaError for an invalid formula, for t, for a plain number, and for a value that is
    not finite or neither 0 nor from 1e-300 to 1e300 in magnitude."""
    formula = Formula(text)
    if formula.is_number:
        raise FormulaError(f"the text {text!r}; wanted the number, without quotes")
    if formula.timed:
        raise FormulaError(f"formula {text[:60]!r} depends on t; wanted a constant")
    if len(text) > LENGTH:
        raise FormulaError(f"formula of {len(text)} characters; wanted at most {LENGTH}")
    if math.isnan(formula.at(0.0)):
        raise FormulaError(f"formula {text!r} is not finite")
    try:
        number = _rational(formula)
        if number is None:
            number = _rounded(formula)
    except (ArithmeticError, ValueError, TypeError, MemoryError):
        raise FormulaError(f"formula {text!r} is out of range, or has no 50 digits") from None
    if number and not 1 / Fraction(10)**300 <= abs(number) <= Fraction(10)**300:
        raise FormulaError(f"formula {text!r} is out of range; wanted 0, or 1e-300 to 1e300 in "
                           "size")
    return number


def _rational(formula: Formula) -> Fraction | None:
    """The value, if the formula consists of decimal numbers and + - * / ** only."""
    try:
        return formula.value(Fraction(0), _EXACT)
    except KeyError:  # pi, or a function with irrational values
        return None


def _rounded(formula: Formula) -> Fraction:
    """The value to 50 digits, computed with more and more digits until two results agree; 0 if it
    shrinks with every added digit, as sin(pi) does."""
    last = mpmath.nan  # ends the loop: near no number
    for digits in _WORKING:
        number = _evaluated(formula, digits)
        with mpmath.workdps(digits):
            if abs(number - last) <= abs(number) / 10**DIGITS:
                return _fraction(number)
        last = number
    if abs(last) < _SMALLEST:
        return Fraction(0)
    raise OverflowError


def _fraction(x: mpmath.mpf) -> Fraction:
    if x and not _SMALLEST <= abs(x) <= 1 / _SMALLEST:
        raise OverflowError
    with mpmath.workdps(DIGITS):
        sign, mantissa, exponent, _ = (+x)._mpf_
    return Fraction((-1)**int(sign) * int(mantissa)) * Fraction(2)**int(exponent)


def _evaluated(formula: Formula, digits: int) -> mpmath.mpf:
    with mpmath.workdps(digits):
        return formula.value(mpmath.mpf(0), {**_FUNCTIONS, "pi": +mpmath.pi})
