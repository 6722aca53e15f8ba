"""Running error analysis: numbers to 50 digits with bounds on their errors in a precision."""

from collections.abc import Callable
from dataclasses import dataclass

import mpmath
from mpmath import mpf

from coscrew_codegen.program import Constant, Op
from coscrew_codegen.program.interpreter import by_operation, exactly
from tests.support.scenes.evaluation import Numbers

FUNCTION = 8
"""Errors of sines and their like, in units: NumPy's are within four spacings."""


@dataclass(frozen=True)
class Bounded:
    """The exact number, and a bound of |computed - exact| for the unit u."""

    exact: mpf
    error: mpf
    u: mpf

    def _rounded(self, exact: mpf, carried: mpf, units: int = 1) -> "Bounded":
        """`carried` is the error of the result due to those of the operands."""
        return Bounded(exact, carried + units * self.u * (abs(exact) + carried), self.u)

    def __add__(self, other: "Bounded") -> "Bounded":
        return self._rounded(self.exact + other.exact, self.error + other.error)

    def __sub__(self, other: "Bounded") -> "Bounded":
        return self._rounded(self.exact - other.exact, self.error + other.error)

    def __mul__(self, other: "Bounded") -> "Bounded":
        carried = (abs(self.exact) * other.error + abs(other.exact) * self.error
                   + self.error * other.error)
        return self._rounded(self.exact * other.exact, carried)

    def __truediv__(self, other: "Bounded") -> "Bounded":
        exact, left = self.exact / other.exact, abs(other.exact) - other.error
        assert left > 0, "the divisor may be zero"
        return self._rounded(exact, (self.error + abs(exact) * other.error) / left)

    def __neg__(self) -> "Bounded":
        return Bounded(-self.exact, self.error, self.u)

    def __abs__(self) -> "Bounded":
        return Bounded(abs(self.exact), self.error, self.u)

    def __lt__(self, other: "Bounded") -> bool:
        sure = abs(self.exact - other.exact) > self.error + other.error or not (
            self.error or other.error)
        assert sure, "which is smaller depends on the rounding"
        return self.exact < other.exact


def _root(x: Bounded) -> Bounded:
    root = mpmath.sqrt(x.exact)
    return x._rounded(root, x.error / root if root else mpmath.sqrt(x.error))


def _contracting(function: Callable[[mpf], mpf]) -> Callable[[Bounded], Bounded]:
    """A function whose derivative is at most 1."""
    return lambda x: x._rounded(function(x.exact), x.error, FUNCTION)


def _exponential(x: Bounded) -> Bounded:
    exact = mpmath.exp(x.exact)
    return x._rounded(exact, exact * mpmath.expm1(x.error), FUNCTION)


def bounded(precision: str, u: mpf) -> Numbers[Bounded]:
    """Running error bounds of Programs evaluated in this precision; inputs are its numbers."""
    def constant(x: Constant) -> Bounded:
        value = getattr(x, precision)
        exact = mpf(value.numerator) / value.denominator
        return Bounded(exact, u * abs(exact), u)

    functions: dict[Op, Callable[..., Bounded]] = {
        **exactly(), Op.SQRT: _root, Op.EXP: _exponential,
        **{op: _contracting(getattr(mpmath, op.value)) for op in (Op.SIN, Op.COS, Op.TANH)}}
    return Numbers(by_operation(constant, functions),
                   lambda x: x if isinstance(x, Bounded) else
                   Bounded(mpmath.mpmathify(float(x)), mpf(0), u))
