"""Evaluates a program in a wider precision, on whole batches: nearly exact, and fast.

It shows what rounding costs, but not the errors of a truncated series.  Only for the plain tier: in
a wider precision the rounding errors that other tiers compute and add back are different ones.
"""

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from coscrew_codegen.program import Constant, Op, Program
from coscrew_codegen.program.interpreter import Arithmetic, by_operation, exactly
from coscrew_codegen.program.interpreter import evaluate as evaluate_on
from coscrew_codegen.program.values.formats import Precision

_WIDE: dict[Op, Callable[..., np.ndarray]] = {**exactly(np), Op.SELECT: np.where}


def evaluate(program: Program, precision: Precision, rows: np.ndarray) -> np.ndarray:
    """Results (n, components) of a plain program for inputs (n, components): of double precision
    in long double, of single in double."""
    wide = np.dtype({"double": np.longdouble, "single": np.float64}[precision.name])
    starts = np.cumsum([0, *(a.quantity.size for a in program.inputs)])
    columns = [list(rows[:, start:end].astype(wide).T) for start, end in pairwise(starts)]

    def constant(x: Constant) -> np.ndarray:
        exact = precision.value(x)
        return np.full(len(rows), wide.type(exact.numerator) / wide.type(exact.denominator))

    nowhere = np.full(len(rows), wide.type(np.nan))
    numbers: Arithmetic[np.ndarray] = by_operation(constant, _WIDE, nowhere)
    with np.errstate(all="ignore"):
        result = evaluate_on(program, columns, numbers)
    return np.stack(result, axis=1)
