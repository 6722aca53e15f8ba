"""Euler angles: R = R_i(a) R_j(b) R_k(c), each rotation about a current axis of the body.

Two sequences are enough: x y z, and x y x.  Every other sequence i, j, k follows from one of them
by renaming axes; all angles change their signs if the renamed axes are left-handed.
"""

from collections.abc import Callable

import sympy as sp

from coscrew_codegen.algebra.matrices import rotation_about
from coscrew_codegen.algebra.operations.formulas.norm import Let, l2, nonzero, unnamed
from coscrew_codegen.algebra.operations.operation import WITHIN, Operation
from coscrew_codegen.program.values.quantity import ANGLES, MAT3X3, ROTATION, VEC3, Argument

_R, _angles = Argument("R", MAT3X3, ROTATION), Argument("angles", VEC3, ANGLES)

_LARGE = sp.Integer(2)**100  # no entry of a rotation is as large
BACKWARD = 12
"""In u: the largest difference of an entry between R and the rotation by the angles; searched."""


def _turn(axis: int, angle: sp.Expr) -> sp.Matrix:
    return rotation_about(axis, sp.sin(angle), sp.cos(angle))


def _matrix(axes: tuple[int, int, int], angles: sp.Matrix) -> sp.Matrix:
    a, b, c = (_turn(axis, angle) for axis, angle in zip(axes, angles, strict=True))
    return a * b * c


def _bound_matrix(axes: tuple[int, int, int], let: Let, angles: sp.Matrix) -> sp.Matrix:
    sines, cosines = let("s", angles.applyfunc(sp.sin)), let("c", angles.applyfunc(sp.cos))
    a, b, c = (rotation_about(axis, sine, cosine)
               for axis, sine, cosine in zip(axes, sines, cosines, strict=True))
    return let("last", a * let("first", b * c))


def _angles_of(let: Let, R: sp.Matrix, y: sp.Expr, x: sp.Expr, middle: tuple[sp.Expr, sp.Expr],
               column: tuple[sp.Matrix, sp.Matrix], unread: tuple[sp.Expr, sp.Expr]
               ) -> sp.Matrix:
    """(a, b, c) of R = R_i(a) R_j(b) R_k(c), with c = atan2(y, x), or 0 in gimbal lock, where
    x = y = 0.

    Without its third rotation, R has the second column (0, cos a, sin a) = p cos c - q sin c, with
    `column` = (p, q). a is computed from c, so that the angles fit together even in gimbal lock.
    `middle` = (numerator, denominator) of tan b; None stands for |(x, y)|. The remaining entries of
    R are `unread`; where one is NaN, so is a."""
    n = let("n", l2(sp.Matrix([x, y])))
    locked = sp.Eq(n, 0)
    divisor = let("divisor", nonzero(n))
    cosine = let("cosine", sp.Piecewise((1, locked), (x / divisor, True)))
    sine = let("sine", y / divisor)
    third = let("third", sp.Piecewise((0, locked), (let("polar", sp.atan2(y, x)), True)))
    p, q = column
    left = let("left", cosine * p - sine * q)
    numerator, denominator = (n if z is None else z for z in middle)
    rest = let("rest", unread[0] + unread[1])
    first = sp.Piecewise((let("first", sp.atan2(left[2], left[1])), rest < _LARGE), (rest, True))
    return sp.Matrix([first, sp.atan2(numerator, denominator), third])


def _of_xyz(let: Let, R: sp.Matrix) -> sp.Matrix:
    y = let("y", -R[0, 1])
    return _angles_of(let, R, y, R[0, 0], (R[0, 2], None), (R[:, 1], -R[:, 0]),
                      (R[1, 2], R[2, 2]))


def _of_xyx(let: Let, R: sp.Matrix) -> sp.Matrix:
    return _angles_of(let, R, R[0, 1], R[0, 2], (None, R[0, 0]), (R[:, 1], R[:, 2]),
                      (R[1, 0], R[2, 0]))


def _pair(name: str, axes: tuple[int, int, int], derivation: Callable[[Let, sp.Matrix], sp.Matrix],
          middle: str) -> tuple[Operation, ...]:
    i, j, k = ("xyz"[axis] for axis in axes)
    turns = f"R_{i}(a) R_{j}(b) R_{k}(c), angles = (a, b, c)"
    return (
        Operation("mat3x3", f"mat3x3_from_euler_{name}", f"R = {turns}", (_angles,), (_R,),
                  lambda angles: _matrix(axes, angles),
                  lambda let, angles: _bound_matrix(axes, let, angles), accurate=WITHIN),
        Operation("mat3x3", f"euler_{name}_from_mat3x3",
                  f"angles of the rotation R = {turns}; a, c in [-π, π], {middle}; c = 0 in gimbal "
                  "lock", (_R,), (_angles,), lambda R: derivation(unnamed, R), derivation,
                  rounding=f"The rotation by these angles differs from R by at most {BACKWARD} u "
                  "in each entry, near gimbal lock too; searched, not proved.", accurate=WITHIN),
    )


OPERATIONS = (*_pair("xyz", (0, 1, 2), _of_xyz, "b in [-π/2, π/2]"),
              *_pair("xyx", (0, 1, 0), _of_xyx, "b in [0, π]"))
