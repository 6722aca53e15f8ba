"""Norms and divisions by them, shared by vectors, screws and coscrews."""

import sympy as sp

from coscrew_codegen.operations.operation import NORM_THRESHOLD


SQUARES = "squares must neither over- nor underflow"


def l2(x: sp.Matrix) -> sp.Expr:
    """sqrt(x·x)."""
    return sp.sqrt(x.dot(x))


def leading_part(first: sp.Matrix, second: sp.Matrix) -> sp.Piecewise:
    """second·second where every |component of first| < threshold, else first·first."""
    small = sp.And(*(sp.Abs(x) < NORM_THRESHOLD for x in first))
    return sp.Piecewise((second.dot(second), small), (first.dot(first), True))


def nonzero(n: sp.Expr) -> sp.Piecewise:
    """n, or 1 where n = 0, so that dividing leaves the zero quantity as it is."""
    return sp.Piecewise((sp.Integer(1), sp.Eq(n, 0)), (n, True))


def divided(x: sp.Matrix, n: sp.Expr) -> sp.Matrix:
    """x / n, component by component."""
    return x.applyfunc(lambda component: component / n)
