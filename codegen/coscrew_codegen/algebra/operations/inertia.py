"""Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.

The ten numbers and their names are KSL's.  The moments are about the centre of mass, along the axes
of the frame: translating a body changes only its first moment mt.  These numbers do not add up when
bodies are joined; those of spatial inertias do.
"""

from collections.abc import Callable
from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import rotation, translation
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas.linear_formulas import linear_space
from coscrew_codegen.algebra.operations.formulas.norm import Let, unnamed
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import (
    ANY,
    INERTIA,
    MASS,
    MAT3X3,
    ROTATION,
    SCALAR,
    SE3,
    VEC3,
    Argument,
)

_NAME = "inertia"

_Ji, _Jo, _self = (Argument(name, INERTIA) for name in ("Ji", "Jo", "self"))
_Jj, _J = Argument("Jj", INERTIA), Argument("J", INERTIA)
_t, _t_ic, _t_jc = (Argument(name, VEC3, ANY) for name in ("t", "t_ic", "t_jc"))
_m, _R = Argument("m", SCALAR, MASS), Argument("R", MAT3X3, ROTATION)
_D, _D_ij = Argument("D", SE3), Argument("D_ij", SE3)
_NUMBERS = tuple(Argument(name, SCALAR, ANY)
                 for name in ("Ixx", "Iyy", "Izz", "Ixy", "Iyz", "Izx"))

PLACES = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))
"""(row, column) of the six moments, in their order."""

MERGED = 18
"""In u: the error bound of a component of joined bodies, from a count of its roundings."""
_op = partial(Operation, _NAME)


def first(J: sp.Matrix) -> sp.Matrix:
    """mt."""
    return J[1:4, :]


def second(J: sp.Matrix) -> sp.Matrix:
    """The moments as a symmetric matrix."""
    xx, yy, zz, xy, yz, zx = J[4:, :]
    return sp.Matrix([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])


def inertia(m: sp.Expr, mt: sp.Matrix, moments: sp.Matrix) -> sp.Matrix:
    """The ten numbers (m; mt; moments)."""
    return sp.Matrix([m, *mt, *(moments[i, j] for i, j in PLACES)])


def of_point(let: Let, p: sp.Matrix, x: sp.Matrix) -> sp.Matrix:
    """x·p 1 - x p^T with p = m x: the moments of a point mass at x."""
    squares = let("squares", sp.Matrix([p[i] * x[i] for i in range(3)]))
    xx, yy, zz = squares[1] + squares[2], squares[0] + squares[2], squares[0] + squares[1]
    xy, yz, zx = (-p[i] * x[j] for i, j in PLACES[3:])
    return sp.Matrix([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])


def _made(m: sp.Expr, t: sp.Matrix, *moments: sp.Expr) -> sp.Matrix:
    return sp.Matrix([m, *(m * t), *moments])


def _rotated(let: Let, J: sp.Matrix, R: sp.Matrix) -> sp.Matrix:
    """m, R mt, R I R^T."""
    return inertia(J[0], R * first(J), let("RI", R * second(J)) * R.T)


def _translated(J: sp.Matrix, t: sp.Matrix) -> sp.Matrix:
    return inertia(J[0], first(J) + J[0] * t, second(J))


def _transformed(let: Let, J: sp.Matrix, D: sp.Matrix) -> sp.Matrix:
    return _translated(_rotated(let, J, rotation(D)), translation(D))


def _merged(let: Let, Ji: sp.Matrix, t_ic: sp.Matrix, Jj: sp.Matrix, t_jc: sp.Matrix,
            D: sp.Matrix) -> sp.Matrix:
    """m = m_i + m_j, mt = mt_i + m_j c, I = I_i + R I_j R^T + μ (d·d 1 - d d^T), where c is the
    second centre of mass, d the vector to it from the first, and μ = m_i m_j / m."""
    R, m = rotation(D), let("m", Ji[0] + Jj[0])
    c = let("c", R * t_jc + translation(D))
    d = let("d", c - t_ic)
    reduced = let("reduced", Ji[0] * let("part", Jj[0] / m))
    parallel_axis = of_point(let, let("p", reduced * d), d)
    rotated = let("RI", R * second(Jj)) * R.T
    return inertia(m, first(Ji) + Jj[0] * c, second(Ji) + rotated + parallel_axis)


def _in_place_too(verb: str, statement: str, by: Argument, formula: Callable[..., sp.Matrix],
                  derivation: Callable[..., sp.Matrix] | None = None) -> tuple[Operation, ...]:
    """inertia_rotated(Ji, R, Jo) and inertia_rotate(self, R)."""
    past = f"{verb}{'d' if verb.endswith('e') else 'ed'}"
    return (_op(f"inertia_{past}", f"Jo = {statement.format('Ji')}", (_Ji, by), (_Jo,), formula,
                derivation),
            _op(f"inertia_{verb}", f"self = {statement.format('self')}", (_self, by), (_self,),
                formula, derivation))


OPERATIONS = (
    _op("inertia", "J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, "
        "entries of the moments' matrix about it in kg m^2, Ixy = -∫ x y dm",
        (_m, _t, *_NUMBERS), (_J,), _made, by_value=True),
    *(op for op in linear_space(_NAME, INERTIA, "J") if op.name == "inertia_copy"),
    *_in_place_too("rotate", "{} rotated by R: m, R mt, R I R^T", _R, partial(_rotated, unnamed),
                   _rotated),
    *_in_place_too("translate", "{} translated by t: m, mt + m t, I", _t, _translated),
    *_in_place_too("transform", "{} displaced by D = [R | t]: m, R mt + m t, R I R^T", _D,
                   partial(_transformed, unnamed), _transformed),
    _op("inertia_merge", "Ji = the inertia of two joined bodies: Ji, and Jj displaced by "
        "D_ij = [R | t]: "
        "m_i + m_j, mt_i + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with "
        "c = R t_jc + t, d = c - t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of "
        "mass, each in its own frame; NaN where m_i + m_j = 0",
        (_Ji, _t_ic, _Jj, _t_jc, _D_ij), (_Ji,), partial(_merged, unnamed), _merged,
        rounding=f"Error <= {MERGED} u times the sum of the absolute values of all terms, for "
        "masses that are not negative, barring over- and underflow."),
)

FAMILY = Family(_NAME, 140, __doc__, OPERATIONS, includes=("SE3",))
