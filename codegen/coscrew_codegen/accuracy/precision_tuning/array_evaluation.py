"""Evaluates Programs on NumPy arrays of states, with the emitted texts' bits on every machine.

Elementary functions are their own Programs; angles beyond the reach of their quick reduction have
no value here.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache, cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.program import Constant, Instruction, Op, Program
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.interpreter import Arithmetic, exactly, interpreter
from coscrew_codegen.program.values.formats import SINGLE, Precision
from coscrew_codegen.program.values.table_arrays import gathered, indices

Array = NDArray[Any]
Given = Sequence[Sequence[Array]]
"""States: an array of each component of each input."""
_FUNCTIONS = {function.name: function for function in (*ELEMENTARY, *ERRORS)}
_OPERATORS = exactly(np)
_SPLITTER = 2.0**27 + 1


class ArrayEvaluation:
    """Arithmetic of a precision, with the functions that partial derivatives need."""

    def __init__(self, precision: Precision) -> None:
        self.precision, self._type = precision, getattr(np, precision.numpy_type)
        exact = _in_double if precision == SINGLE else _by_halves
        self._operations: dict[Op, Callable[..., Any]] = {
            **_OPERATORS, Op.SELECT: np.where, Op.ABS: np.absolute, Op.COPYSIGN: np.copysign,
            Op.PRODUCT_ERROR: exact, Op.PRODUCT_REST: lambda a, b, p, h: exact(a, b, h),
            Op.POWER: self._power_of_two, Op.GATHER: partial(gathered, precision),
            Op.INDEX: lambda x, count: self._type(indices(x, count))}

    @cached_property
    def arithmetic(self) -> Arithmetic[Any]:
        """Arithmetic for the interpreter."""
        return Arithmetic(self._constant, self._function, self._type(np.nan))

    def sin(self, x: Array) -> Array:
        """sin x."""
        return _elementary(self.precision, Op.SIN)(x)

    def cos(self, x: Array) -> Array:
        """cos x."""
        return _elementary(self.precision, Op.COS)(x)

    less, where = staticmethod(np.less), staticmethod(np.where)

    def _constant(self, x: Constant) -> Any:
        return self.precision.rounded(self.precision.value(x))

    def _function(self, step: Instruction, number: int) -> Callable[..., Any]:
        if step.op in FUNCTION_OF:
            return _elementary(self.precision, step.op)
        return self._operations[step.op]

    def _power_of_two(self, shifted: Array, shift: Array) -> Array:
        power: Array = np.ldexp(self._type(1), (shifted - shift).astype(int))
        return power


@cache
def arrays(precision: Precision) -> ArrayEvaluation:
    """The numbers of this precision."""
    return ArrayEvaluation(precision)


def evaluator(program: Program, precision: Precision) -> Callable[[Given], list[Array]]:
    """Computes the components of the results at any states."""
    run = interpreter(program, arrays(precision).arithmetic)

    def results(given: Given) -> list[Array]:
        with np.errstate(all="ignore"):
            return run(given)

    return results


@cache
def _elementary(precision: Precision, op: Op) -> Callable[..., Array]:
    """The function that computes the operation."""
    run, place = _both(FUNCTION_OF[op], precision), int(op in (Op.COS, Op.COS_ERROR))
    return lambda *x: run(*x)[place]


@cache
def _both(name: str, precision: Precision) -> Callable[..., Sequence[Array]]:
    """All results of an elementary function; errors of angles take both sine and cosine."""
    function = _FUNCTIONS[name]
    kernel = interpreter(function.kernel(precision), arrays(precision).arithmetic)
    if not (function.near and function.limit):
        return lambda *x: kernel([[each] for each in x])
    reduced = interpreter(function.near(precision), arrays(precision).arithmetic)
    limit, number = function.limit(precision), getattr(np, precision.numpy_type)

    last: tuple[Array, Sequence[Array]] | None = None  # for the cosine after the sine

    def run(x: Array, *more: Array) -> Sequence[Array]:
        nonlocal last
        if last is None or last[0] is not x:
            inside = np.where(np.absolute(x) <= float(limit), x, number(np.nan))
            circular = [_elementary(precision, op)(x) for op in (Op.SIN, Op.COS)] if more else []
            last = x, kernel([[each] for each in (*reduced([[inside]]), *circular)])
        return last[1]

    return run


def _in_double(a: Array, b: Array, c: Array) -> Array:
    """a b - c of single precision, rounded once: a b is exact in double."""
    x, y, z = (np.asarray(each, np.float64) for each in (a, b, c))
    return np.asarray(x * y - z, np.float32)


def _by_halves(a: Array, b: Array, c: Array) -> Array:
    """a b - c by halves where that is exact, and else by fractions, rounded once.  Source: Dekker,
    TwoProduct."""
    p = a * b
    rest, (a_high, a_low), (b_high, b_low) = p - c, _halves(a), _halves(b)
    error = ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low
    size = np.absolute(p)
    exact = (size > 2.0**-960) & (size < 2.0**960) | (a == 0) | (b == 0)
    result = np.where(error == 0, rest, rest + error)
    other = ~exact & np.isfinite(p) & np.isfinite(c)
    result[other] = [float(Fraction(x) * Fraction(y) - Fraction(z)) for x, y, z in zip(
        *(np.broadcast_to(each, other.shape)[other].tolist() for each in (a, b, c)), strict=True)]
    return np.where(exact | other, result, np.nan)


def _halves(a: Array) -> tuple[Array, Array]:
    c = _SPLITTER * a
    high = c - (c - a)
    return high, a - high
