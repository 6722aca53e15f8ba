"""A program evaluated in a wider precision, on whole batches: nearly the truth, and fast.

It shows what rounding costs; not what a truncated series does, nor how exact errors are used:
programs of the plain tier only.
"""

from collections.abc import Callable

import numpy as np

from coscrew_codegen.formats import Precision
from coscrew_codegen.program import Constant, Input, NotANumber, Op, Operand, Program

_EVALUATE: dict[Op, Callable[..., np.ndarray]] = {
    Op.ADD: np.add, Op.SUB: np.subtract, Op.MUL: np.multiply, Op.SCALE: np.multiply,
    Op.DIV: np.divide, Op.NEG: np.negative, Op.ABS: np.abs, Op.SQRT: np.sqrt, Op.SIN: np.sin,
    Op.COS: np.cos, Op.ATAN2: np.arctan2, Op.LESS: np.less, Op.EQUAL: np.equal, Op.SELECT: np.where}


def evaluate(program: Program, precision: Precision, rows: np.ndarray) -> np.ndarray:
    """Results (n, components) of a plain program for inputs (n, components): of double precision
    in long double, of single in double."""
    wide = np.dtype({"double": np.longdouble, "single": np.float64}[precision.name])
    starts = np.cumsum([0, *(a.quantity.size for a in program.inputs)])
    values: dict[str, np.ndarray] = {}

    def value(x: Operand) -> np.ndarray:
        if isinstance(x, Input):
            return rows[:, starts[x.argument] + x.index].astype(wide)
        if isinstance(x, Constant):
            exact = precision.value(x)
            return np.full(len(rows), wide.type(exact.numerator) / wide.type(exact.denominator))
        if isinstance(x, NotANumber):
            return np.full(len(rows), wide.type(np.nan))
        return values[x.name]

    with np.errstate(all="ignore"):
        for step in program.instructions:
            values[step.name] = _EVALUATE[step.op](*map(value, step.operands))
        return np.stack([value(x) for x in program.results], axis=1)
