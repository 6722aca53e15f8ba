"""Tables as NumPy arrays, in a precision."""

from functools import lru_cache

import numpy as np

from coscrew_codegen.program.tables import ConstantTable, TableColumn
from coscrew_codegen.program.values.formats import SINGLE, Precision


@lru_cache(16)  # both precisions of some tables, which may be large
def rounded(table: ConstantTable, precision: Precision) -> np.ndarray:
    """The numbers of a table, each rounded to nearest, ties to even."""
    made = np.array([x.numerator / x.denominator for x in table.values])
    if precision.digits != SINGLE.digits:
        return made
    with np.errstate(over="ignore"):
        result = made.astype(np.float32)
    halfway = made.view(np.uint64) & (2**29 - 1) == 2**28  # between two of single precision
    for place in np.flatnonzero(halfway | (abs(made) < float(precision.smallest_normal))):
        result[place] = precision.rounded(table.values[place])
    return result


def indices(x: np.ndarray, count: float) -> np.ndarray:
    """The integer parts of numbers, within 0 … count - 1; 0 for NaN."""
    return np.where(x > 0, np.minimum(x, count - 1), 0).astype(np.int64)


def gathered(precision: Precision, column: TableColumn, at: np.ndarray) -> np.ndarray:
    """The column's numbers in the rows of these indices."""
    of = column.table
    result: np.ndarray = rounded(of, precision)[of.stride * indices(at, of.rows) + column.place]
    return result
