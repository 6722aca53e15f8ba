"""Results of operations with irrational values, to 60 digits, component by component.

The truth is motions.py where that has the operation, else its formula.  A rotation by π has two
rotation vectors.  Where rounded inputs do not tell which is shorter, `other_way` is the truth as
well.
"""

import functools
from collections.abc import Callable, Sequence
from itertools import accumulate

import mpmath as mp
import numpy as np
import sympy as sp
from gmpy2 import mpfr

from coscrew_codegen.algebra.lowering.programs import library_program
from coscrew_codegen.algebra.operations import PER_PRECISION, Operation
from coscrew_codegen.program import Program
from coscrew_codegen.program.interpreter import interpreter
from coscrew_codegen.program.multiprecise import MULTIPRECISE, precise
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import (
    DISPLACEMENT,
    ROTATION,
    UNIT_QUATERNION,
    Argument,
)
from tests.support.truth.motions import (
    DIGITS,
    TRUTHS,
    Matrix,
    SE3_exp,
    Truth,
    compose,
    conjugate,
    exponential_series,
    inverse,
    nearest_quaternion,
    norm,
    product,
    quaternion_exp,
    skew,
    to_mpf,
    to_mpfr,
    vector_of,
)

Components = list[mp.mpf]

# Where rounding has changed an axis's length, the truth is the formula, not exp.
_STATED = ("mat3x3_from_axis_angle",)


@functools.cache
def truth(operation: Operation, precision: Precision, given: tuple[float, ...]) -> Components:
    """All components of the exact result, row by row."""
    with mp.workdps(DIGITS):
        if operation.name in TRUTHS and operation.name not in _STATED:
            return _flat(TRUTHS[operation.name](*_arguments(operation, given)))
        return [mp.mpf(x) for x in _formula(operation, precision)(*map(mp.mpf, given))]


@functools.cache
def _formula(operation: Operation, precision: Precision) -> Callable[..., Components]:
    symbols = [symbol for a in operation.inputs for symbol in a.symbols]
    column = 0 if precision.name == "double" else 1
    constants = {symbol: values[column] for symbol, values in PER_PRECISION.items()}
    return sp.lambdify(symbols, [x.subs(constants) for x in operation.truth()], "mpmath")


ROUNDED = (ROTATION, DISPLACEMENT, UNIT_QUATERNION)
"""Domains that rounded inputs are not quite in."""


def fine(operation: Operation) -> Program:
    """The formula for twice the digits."""
    plain = library_program(operation.name)
    return plain.fine or plain


@functools.cache
def _run(operation: Operation) -> Callable[..., list[mpfr]]:
    return interpreter(fine(operation), MULTIPRECISE)


def of_formula(operation: Operation, given: Sequence[mpfr]) -> list[mpfr]:
    """The components of the formula's results, in the context's precision; of series to 2^-97."""
    ends = list(accumulate(a.quantity.size for a in operation.inputs))
    return _run(operation)([list(given[end - a.quantity.size:end])
                            for a, end in zip(operation.inputs, ends, strict=True)])


def by_formula(operation: Operation, given: Sequence[mp.mpf]) -> Components:
    """The truth by the formula, in 60 digits."""
    with precise(DIGITS):
        return list(map(to_mpf, of_formula(operation, list(map(to_mpfr, given)))))


def of_given(operation: Operation, precision: Precision, given: tuple[float, ...]) -> Components:
    """The truth for these very inputs, even if they are not quite rotations."""
    if not any(a.domain in ROUNDED for a in operation.inputs):
        return truth(operation, precision, given)
    with mp.workdps(DIGITS):
        return by_formula(operation, list(map(mp.mpf, given)))


def other_way(operation: Operation, given: Sequence[float],
              tolerance: float) -> Components | None:
    """The result from the rotation vector v - 2 π v / |v|; None where |v| < π - tolerance."""
    if operation.name not in _OTHER:
        return None
    vector, result = _OTHER[operation.name]
    with mp.workdps(DIGITS):
        arguments = _arguments(operation, given)
        v = vector(*arguments)
        if norm(v) < mp.pi - tolerance:
            return None
        return _flat(result(v * (1 - 2 * mp.pi / norm(v)), *arguments))


def _arguments(operation: Operation, given: Sequence[float]) -> list[Matrix | mp.mpf]:
    ends = list(accumulate(a.quantity.size for a in operation.inputs))
    return [_argument(a, given[end - a.quantity.size:end])
            for a, end in zip(operation.inputs, ends, strict=True)]


def _argument(argument: Argument, numbers: Sequence[float]) -> Matrix | mp.mpf:
    rows, columns = argument.quantity.rows_columns
    if not argument.quantity.shape:
        return mp.mpf(numbers[0])
    return mp.matrix(np.reshape(numbers, (rows, columns)).tolist())


def _flat(value: Truth) -> Components:
    if isinstance(value, tuple):
        return [x for part in value for x in _flat(part)]
    return list(value) if isinstance(value, mp.matrix) else [mp.mpf(value)]


def _of_matrix(R: Matrix) -> Matrix:
    return vector_of(nearest_quaternion(R))


def _between(D1: Matrix, D2: Matrix, k: mp.mpf) -> Matrix:
    return _of_matrix(compose(inverse(D1), D2)[0:3, 0:3])


def _screw(w: Matrix, t: Matrix) -> Matrix:
    return mp.matrix([*mp.lu_solve(exponential_series(skew(w), 1), t), *w])


# name → (rotation vector of the inputs, result by another rotation vector and the inputs)
_OTHER: dict[str, tuple[Callable[..., Matrix], Callable[..., Truth]]] = {
    "SO3_log": (_of_matrix, lambda w, R: w),
    "quaternion_log": (vector_of, lambda w, q: w),
    "quaternion_from_mat3x3": (_of_matrix, lambda w, R: -nearest_quaternion(R)),
    "axis_angle_from_mat3x3": (_of_matrix, lambda w, R: (norm(w), w / norm(w))),
    "axis_angle_from_quaternion": (vector_of, lambda w, q: (norm(w), w / norm(w))),
    "SE3_log": (lambda D: _of_matrix(D[0:3, 0:3]), lambda w, D: _screw(w, D[0:3, 3])),
    "quaternion_interpolated": (lambda p, q, k: vector_of(product(conjugate(p), q)),
                         lambda w, p, q, k: product(p, quaternion_exp(k * w))),
    "SE3_interpolated": (_between, lambda w, D1, D2, k: compose(
        D1, SE3_exp(k * _screw(w, compose(inverse(D1), D2)[0:3, 3])))),
}
