"""Evaluates elementary functions' Programs on arrays, and measures errors against mpmath."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache

import mpmath
import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.elementary import Elementary
from coscrew_codegen.formats import Precision
from coscrew_codegen.program import Program
from coscrew_codegen.program.interpreter import by_operation, exactly, interpreter

Array = NDArray[np.floating]
Function = Callable[..., tuple[Array, ...]]


@cache
def on_arrays(program: Program, precision: Precision) -> Function:
    """The Program on arrays, each operation rounded once in the precision."""
    number = getattr(np, precision.numpy_type)
    arithmetic = by_operation(lambda x: np.full(1, precision.rounded(x.double), number),
                              exactly(np))
    run = interpreter(program, arithmetic)

    def function(*inputs: Array) -> tuple[Array, ...]:
        with np.errstate(all="ignore"):
            return tuple(run([[x] for x in inputs]))

    return function


@cache
def function_of(elementary: Elementary, precision: Precision) -> Function:
    """An elementary function on arrays."""
    kernel = on_arrays(elementary.kernel(precision), precision)
    if elementary.near is None or elementary.far is None or elementary.limit is None:
        return kernel
    near = on_arrays(elementary.near(precision), precision)
    far = on_arrays(elementary.far(precision), precision)
    limit = float(elementary.limit(precision))

    def function(*inputs: Array) -> tuple[Array, ...]:
        beyond = ~(np.abs(inputs[0]) <= limit)
        reduced = near(*inputs)
        for some, right in zip(reduced, far(*(x[beyond] for x in inputs)), strict=True):
            some[beyond] = right
        return kernel(*reduced)

    return function


def ulps(got: Sequence[float], true: Sequence[mpmath.mpf], precision: Precision) -> NDArray[
        np.float64]:
    """|got - true| in units of the last place of the true value."""
    return np.array([_ulps(float(x), y, precision) for x, y in zip(got, true, strict=True)])


def _ulps(got: float, true: mpmath.mpf, precision: Precision) -> float:
    _, _, exponent, digits = true._mpf_
    last = max(exponent + digits, precision.least_exponent + 1) - precision.digits
    return float(abs(mpmath.mpf(got) - true) * mpmath.mpf(2)**-last)


def fraction(x: float) -> Fraction:
    """The number, exactly."""
    return Fraction(float(x))
