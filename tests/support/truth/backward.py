"""Backward errors of results: how far rows are from orthonormal, angles from those of the rotation
R, and V A V^T from A."""

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import mpmath as mp
import numpy as np
import sympy as sp

from coscrew_codegen.algebra.operations import OPERATIONS, Operation, mat3x3
from coscrew_codegen.algebra.operations.formulas import eigen, euler
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import Argument
from tests.support.truth.motions import DIGITS

TABLE = {op.name: op for op in OPERATIONS}


@dataclass(frozen=True)
class Backward:
    """A bound: no residual of a result exceeds k u size.  Both are functions of inputs and outputs.
    """

    k: int
    residuals: Callable[..., sp.Matrix]
    size: Callable[..., sp.Expr]


def _one(*_: sp.Matrix) -> sp.Expr:
    return sp.Integer(1)


def _euler(sequence: str) -> Backward:
    of_angles = TABLE[f"mat3x3_from_euler_{sequence}"].formula
    return Backward(euler.BACKWARD, lambda R, angles: of_angles(angles) - R, _one)


def _symmetric(A: sp.Matrix) -> sp.Matrix:
    return sp.Matrix(3, 3, lambda i, j: A[max(i, j), min(i, j)])


def _off_orthonormal(R: sp.Matrix, Ro: sp.Matrix) -> sp.Matrix:
    """Products of rows; on the diagonal their lengths less 1, to first order."""
    off = Ro * Ro.T - sp.eye(3)
    return sp.Matrix(3, 3, lambda i, j: off[i, j] / (2 if i == j else 1))


_ROWS = Backward(mat3x3.ORTHONORMAL, _off_orthonormal, _one)

BACKWARD = {
    "mat3x3_normalize": _ROWS, "mat3x3_normalized": _ROWS,
    "euler_xyz_from_mat3x3": _euler("xyz"), "euler_xyx_from_mat3x3": _euler("xyx"),
    "mat3x3_jacobi": Backward(
        eigen.BACKWARD,
        lambda A, V, Ao, Vo: Vo * _symmetric(Ao) * Vo.T - V * _symmetric(A) * V.T,
        lambda A, V, Ao, Vo: sp.Max(*map(sp.Abs, _symmetric(A))))}

# Results may be NaN instead if rows are linearly dependent within so many u.
MAY_DEPEND, DEPENDENT = ("mat3x3_normalize", "mat3x3_normalized"), 64


def expressions(operation: Operation) -> tuple[tuple[sp.Symbol, ...], list[sp.Expr], sp.Expr]:
    """Symbols in_0, …, out_0, …; residuals and size in them."""
    bound, symbols, values = BACKWARD[operation.name], [], []
    for prefix, arguments in (("in_", operation.inputs), ("out_", operation.outputs)):
        start = 0
        for a in arguments:
            own = sp.symbols(f"{prefix}{start}:{start + a.quantity.size}", real=True)
            symbols.extend(own)
            values.append(_shaped(a, own))
            start += a.quantity.size
    return tuple(symbols), list(bound.residuals(*values)), bound.size(*values)


def _shaped(argument: Argument, symbols: Sequence[sp.Symbol]) -> sp.Matrix:
    return sp.Matrix(*argument.quantity.rows_columns, list(symbols))


@functools.cache
def _evaluate(operation: Operation) -> Callable[..., tuple[list[mp.mpf], mp.mpf]]:
    symbols, residuals, size = expressions(operation)
    return sp.lambdify(symbols, (residuals, size), "mpmath", cse=True)


def ratio(operation: Operation, precision: Precision, given: Sequence[float],
          got: Sequence[float], slack: float) -> float:
    """The largest residual relative to its bound with k + `slack`."""
    info = np.finfo(precision.numpy_type)
    u = float(info.eps) / 2
    with mp.workdps(DIGITS):
        if not all(map(math.isfinite, got)):
            if operation.name in MAY_DEPEND and _dependent(given) <= DEPENDENT * u:
                return 0.0
            return 0.0 if max(map(abs, given)) >= float(info.max) / 64 else math.inf
        residuals, size = _evaluate(operation)(*map(mp.mpf, (*given, *got)))
        allowed = (BACKWARD[operation.name].k + slack) * u * (1 + 1024 * u) * size
        allowed += 16 * mp.mpf(float(info.smallest_subnormal))
        return float(max(map(abs, residuals)) / allowed)


def _dependent(given: Sequence[float]) -> mp.mpf:
    """|det| of the rows, each of length 1; 0 where one is zero."""
    a, b, c = ([mp.mpf(x) for x in given[i:i + 3]] for i in (0, 3, 6))
    cross = [b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2] for i in range(3)]
    size = mp.fprod(mp.norm(row) for row in (a, b, c))
    return abs(mp.fdot(a, cross)) / size if size else mp.mpf(0)
