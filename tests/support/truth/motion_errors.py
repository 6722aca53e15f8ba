"""Errors of motions against motions.py, each part against its largest component."""

from typing import TypeAlias

import mpmath as mp
import numpy as np

from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import Precision
from tests.support.truth.motions import DIGITS, TRUTHS, alternatives

Matrix: TypeAlias = mp.matrix | mp.mpf
Objects = np.ndarray  # of mpf


def truth_of(operation: Operation, row: tuple[Matrix, ...],
             rounding: mp.mpf) -> list[list[Objects]]:
    """The exact results: alternatives, each with an array per output."""
    with mp.workdps(DIGITS):
        truth = TRUTHS[operation.name](*row)
        return [as_arrays(x) for x in alternatives(operation.name, truth, rounding)]


def multiprecise(x: np.ndarray) -> Matrix:
    """The numbers as they are."""
    x = np.asarray(x, float)
    return mp.matrix(x.tolist()) if x.ndim else mp.mpf(float(x))


def as_arrays(value: Matrix | tuple[Matrix, ...]) -> list[Objects]:
    """Each value as a matrix."""
    values = value if isinstance(value, tuple) else (value,)
    return [np.array(v.tolist() if isinstance(v, mp.matrix) else [[v]], dtype=object)
            for v in values]


def unit(precision: Precision) -> mp.mpf:
    """u, the unit roundoff."""
    return mp.mpf(float(np.finfo(precision.numpy_type).eps)) / 2


def errors(operation: Operation, given: list[Objects], results: list[Objects],
           truths: list[list[Objects]]) -> dict[str, mp.mpf]:
    """The largest error of each part with a bound, relative to its largest component, or to the
    parts of inputs named in the bound; for the closest of the alternatives."""
    return min((_errors(operation, given, results, truth) for truth in truths),
               key=lambda parts: max(parts.values()))


def _errors(operation: Operation, given: list[Objects], results: list[Objects],
            truth: list[Objects]) -> dict[str, mp.mpf]:
    result, bounds = {}, {bound.part: bound for bound in operation.normwise}
    for output, x, t in zip(operation.outputs, results, truth, strict=True):
        for part in output.quantity.parts:
            whole = part.name not in bounds
            inside = ... if whole else np.ix_(part.rows, part.columns)
            bound = bounds[output.name if whole else part.name]
            beside = [given[number][np.ix_(of.rows, of.columns)]
                      for number, a in enumerate(operation.inputs) for of in a.quantity.parts
                      if f"{a.name}.{of.name}" in bound.beside]
            size = max(abs(c) for y in (t[inside], *beside) for c in np.ravel(y))
            error = max(map(abs, np.ravel((x - t)[inside])))
            result[output.name if whole else part.name] = (
                error / size if size else mp.inf if error else mp.mpf(0))
    return result
