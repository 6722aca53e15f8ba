"""Elementary functions: Programs by precision, and what is proved of their results."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.program import Program
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import Argument


@dataclass(frozen=True, eq=False)
class Elementary:
    """An elementary function of scalars.

    A module of this package that assigns one to `FUNCTION` adds it, and to `ERROR` what another one
    errs by.  Functions of angles reduce their first argument: `near` and `far` take x to (quadrant,
    r, r_excess), which `kernel` takes instead."""

    name: str  # exp, sincos: ends the names of its functions
    statement: str  # its equation
    inputs: tuple[Argument, ...]
    outputs: tuple[Argument, ...]
    kernel: Callable[[Precision], Program]  # straight-line, for every argument
    error: Callable[[Precision], Fraction]
    """Proved: |result - true| in ulps of the result, wherever the true result is in the normal
    range; approximation and roundings, each to nearest.  Of an `ERROR`: relative to the true
    result, of the result and its error."""
    comment: Callable[[Precision], str]
    """Degree, interval and split; the proved errors of the approximation and of the result; what
    holds of results below the normal range, where it is something else."""
    near: Callable[[Precision], Program] | None = None  # for |x| <= limit
    far: Callable[[Precision], Program] | None = None  # for every finite x
    limit: Callable[[Precision], Fraction] | None = None
