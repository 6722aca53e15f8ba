"""Elementary functions: Programs by precision, and proved bounds of their errors."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.program import Program
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import Argument


@dataclass(frozen=True, eq=False)
class Elementary:
    """An elementary function of scalars.

    A module of this package adds one by assigning it to `FUNCTION`, and the error function of
    another one by assigning it to `ERROR`. Functions of angles reduce their first argument: `near`
    and `far` take x to (quadrant, r, r_excess), which `kernel` takes instead."""

    name: str  # exp, sincos: ends the names of its functions
    statement: str  # its equation
    inputs: tuple[Argument, ...]
    outputs: tuple[Argument, ...]
    kernel: Callable[[Precision], Program]  # straight-line, for every argument
    error: Callable[[Precision], Fraction]
    """Proved: |result - true| in ulps of the result, wherever the true result is in the normal
    range; approximation and roundings, each to nearest.  For an `ERROR`: the error of result +
    error, relative to the true result."""
    comment: Callable[[Precision], str]
    """States degree, interval and split; the proved errors of the approximation and of the result;
    and the error of results below the normal range, where it differs."""
    near: Callable[[Precision], Program] | None = None  # for |x| <= limit
    far: Callable[[Precision], Program] | None = None  # for every finite x
    limit: Callable[[Precision], Fraction] | None = None
