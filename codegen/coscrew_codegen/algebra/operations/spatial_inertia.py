"""Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.

These ten numbers are linear: those of joined bodies add up, and momentum is linear in them.  As an
operator [[m 1, -h~], [h~, I]] a spatial inertia maps screws to coscrews (momenta).
"""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import (
    I3,
    ang,
    blocks,
    lin,
    rotation,
    skew,
    stack,
    translation,
)
from coscrew_codegen.algebra.operations import inertia as centroidal
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas.linear_formulas import linear_space
from coscrew_codegen.algebra.operations.formulas.norm import Let, unnamed
from coscrew_codegen.algebra.operations.formulas.special import smallest_pivot
from coscrew_codegen.algebra.operations.mat3x3 import acceleration_tensor, products_of
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.algebra.operations.symmetric import (
    bound_smallest_pivot,
    factored,
    lower_triangle,
)
from coscrew_codegen.program.values.quantity import (
    ANY,
    COSCREW,
    INERTIA,
    MASS,
    MAT3X3,
    MAT6X6,
    POSITIVE_DEFINITE,
    SCALAR,
    SCREW,
    SE3,
    SPATIAL_INERTIA,
    VEC3,
    Argument,
)

_NAME = "spatial_inertia"

_B, _Bo = Argument("B", SPATIAL_INERTIA), Argument("Bo", SPATIAL_INERTIA)
_J, _Jo, _m = Argument("J", INERTIA), Argument("Jo", INERTIA), Argument("m", SCALAR, MASS)
_com, _t = Argument("com", VEC3, ANY), Argument("t", VEC3, ANY)
_Ic = Argument("Ic", MAT3X3, POSITIVE_DEFINITE)
_D, _s, _co = Argument("D", SE3), Argument("s", SCREW), Argument("co", COSCREW)
_w, _ds = Argument("w", VEC3, ANY), Argument("ds", SCREW)
_energy, _pivot = Argument("energy", SCALAR), Argument("pivot", SCALAR)
_vo, _Ro, _Mo = Argument("vo", VEC3), Argument("Ro", MAT3X3), Argument("Mo", MAT6X6)

_CYCLES = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
_UPPER = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
_op = partial(Operation, _NAME)


def _first(B: sp.Matrix) -> sp.Matrix:
    return B[1:4, :]


def _second(B: sp.Matrix) -> sp.Matrix:
    xx, yy, zz, xy, xz, yz = B[4:, :]
    return sp.Matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def _inertia(m: sp.Expr, h: sp.Matrix, second: sp.Matrix) -> sp.Matrix:
    return sp.Matrix([m, *h, *(second[i, j] for i, j in _UPPER)])


def _operator(B: sp.Matrix) -> sp.Matrix:
    """[[m 1, -h~], [h~, I]]."""
    return blocks(B[0] * I3, -skew(_first(B)), skew(_first(B)), _second(B))


def _momentum(B: sp.Matrix, s: sp.Matrix) -> sp.Matrix:
    """(m v - h × ω; h × v + I ω)."""
    h = _first(B)
    return stack(B[0] * lin(s) - h.cross(ang(s)), h.cross(lin(s)) + _second(B) * ang(s))


def _energy_of(let: Let, B: sp.Matrix, s: sp.Matrix) -> sp.Expr:
    """(ω·I ω + m v·v) / 2 + v·(ω × h)."""
    v, w = lin(s), ang(s)
    square, L = let("square", v.dot(v)), let("L", _second(B) * w)
    return let("twice", w.dot(L) + B[0] * square) / 2 + v.dot(let("across", w.cross(_first(B))))


def _net_wrench(let: Let, B: sp.Matrix, w: sp.Matrix, ds: sp.Matrix) -> sp.Matrix:
    """(m a + U h; h × a + N) with U = ω'~ + ω~ ω~.

    N = I ω' + ω × I ω takes 15 products instead of 24, since it reuses entries of U and ω ω^T:
    N_x = I_xx ω'_x + (I_zz - I_yy) ω_y ω_z + I_yz (ω_y² - ω_z²) - I_xy U_zx + I_xz U_yx."""
    h, a, dw, I = _first(B), lin(ds), ang(ds), _second(B)
    xx, yy, zz, xy, xz, yz = ww = products_of(let, w)
    U = let("U", acceleration_tensor(ww, dw))
    others = let("others", sp.Matrix([I[k, k] - I[j, j] for _, j, k in _CYCLES]))
    squares = let("squares", sp.Matrix([yy - zz, zz - xx, xx - yy]))
    own = let("own", sp.Matrix([I[i, i] * dw[i] + others[i] * (yz, xz, xy)[i] for i in range(3)]))
    N = let("N", sp.Matrix([
        own[i] + I[j, k] * squares[i] - I[i, j] * U[k, i] + I[k, i] * U[j, i]
        for i, j, k in _CYCLES]))
    return stack(B[0] * a + U * h, N + h.cross(a))


def _wrench_formula(B: sp.Matrix, w: sp.Matrix, ds: sp.Matrix) -> sp.Matrix:
    """B s' + (ω × (ω × h); ω × I ω)."""
    return _momentum(B, ds) + stack(w.cross(w.cross(_first(B))), w.cross(_second(B) * w))


def _from_com(let: Let, m: sp.Expr, com: sp.Matrix, Ic: sp.Matrix) -> sp.Matrix:
    """h = m c, I = Ic - m c~ c~; only the upper triangle of Ic is read."""
    h = let("h", m * com)
    squares = let("squares", sp.Matrix([h[i] * com[i] for i in range(3)]))
    own = squares[1] + squares[2], squares[0] + squares[2], squares[0] + squares[1]
    second = [*own, -h[0] * com[1], -h[0] * com[2], -h[1] * com[2]]
    return sp.Matrix([m, *h, *(Ic[i, j] + x for (i, j), x in zip(_UPPER, second, strict=True))])


def _shifted(let: Let, t: sp.Matrix, B: sp.Matrix) -> sp.Matrix:
    """h + m t, I - t~ (h + m t)~ - h~ t~ = I - t~ n~ - n~ t~ with n = h + m t/2."""
    m, h = B[0], _first(B)
    mt = let("mt", m * t)
    n = let("n", h + let("half", mt / 2))
    own = let("own", sp.Matrix([2 * let(f"tn{i}", t[i] * n[i]) for i in range(3)]))
    pairs = let("pairs", sp.Matrix([own[1] + own[2], own[0] + own[2], own[0] + own[1],
                                    *(t[i] * n[j] + n[i] * t[j] for i, j in _UPPER[3:])]))
    second = [x + y if i < 3 else x - y
              for i, (x, y) in enumerate(zip(B[4:, :], pairs, strict=True))]
    return sp.Matrix([m, *let("moved", h + mt), *second])


def _turned(let: Let, R: sp.Matrix, B: sp.Matrix) -> sp.Matrix:
    """m, R h, R I R^T."""
    half = let("RI", R * _second(B))
    return let("turned", _inertia(B[0], R * _first(B), half * R.T))


def _transformed(let: Let, D: sp.Matrix, B: sp.Matrix) -> sp.Matrix:
    return _shifted(let, translation(D), _turned(let, rotation(D), B))


def _about_com(let: Let, B: sp.Matrix) -> sp.Matrix:
    """I + h~ h~ / m."""
    h, c = _first(B), let("c", _first(B) / B[0])
    squares = let("squares", sp.Matrix([h[i] * c[i] for i in range(3)]))
    own = squares[1] + squares[2], squares[0] + squares[2], squares[0] + squares[1]
    second = [*own, *(-h[i] * c[j] for i, j in _UPPER[3:])]
    xx, yy, zz, xy, xz, yz = let("about", sp.Matrix(
        [x - y for x, y in zip(B[4:, :], second, strict=True)]))
    return sp.Matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def _of_inertia(let: Let, J: sp.Matrix) -> sp.Matrix:
    """m, mt, I + mt·c 1 - mt c^T with c = mt / m."""
    h = centroidal.first(J)
    moved = centroidal.of_point(let, h, let("c", h / J[0]))
    return _inertia(J[0], h, centroidal.second(J) + moved)


def _to_inertia(let: Let, B: sp.Matrix) -> sp.Matrix:
    """m, h, I - h·c 1 + h c^T with c = h / m."""
    h = _first(B)
    moved = centroidal.of_point(let, h, let("c", h / B[0]))
    return centroidal.inertia(B[0], h, _second(B) - moved)


def _sigma(let: Let, B: sp.Matrix) -> sp.Matrix:
    """The diagonal of Σ = ∫ x x^T dm = tr(I)/2 1 - I; its other entries are those of -I."""
    second = _second(B)
    trace = let("trace", let("twice_trace", second.trace()) / 2)
    return let("sigma", sp.Matrix([trace - second[i, i] for i in range(3)]))


def _pseudo_inertia(let: Let, B: sp.Matrix) -> sp.Matrix:
    """[[m, h^T], [h, tr(I)/2 1 - I]]: ∫ (1; x) (1; x)^T dm."""
    second = _second(B)
    x, y, z = _sigma(let, B)
    xy, xz, yz = -second[0, 1], -second[0, 2], -second[1, 2]
    h = _first(B)
    return sp.Matrix([[B[0], h[0], h[1], h[2]], [h[0], x, xy, xz], [h[1], xy, y, yz],
                      [h[2], xz, yz, z]])


def _consistency(let: Let, B: sp.Matrix) -> sp.Expr:
    pseudo = _pseudo_inertia(let, B)
    return bound_smallest_pivot(let, pseudo, factored(let, pseudo)[1])


CONVERTED = 4
"""In u: the error bound of a converted moment, from a count of its roundings."""

_CONVERTED = (f"Error of a moment <= {CONVERTED} u times the sum of its |terms|, barring over- and "
              "underflow.")


OPERATIONS = (
    *(op for op in linear_space(_NAME, SPATIAL_INERTIA, "B")
      if op.name in ("spatial_inertia_copy", "spatial_inertia_scale", "add_BB", "subtract_BB")),
    _op("spatial_inertia_from_com", "Bo: mass m, centre of mass com, second moments Ic about it "
        "(kg m^2; only the upper triangle is read): h = m com, I = Ic - m com~ com~",
        (_m, _com, _Ic), (_Bo,), lambda *x: _from_com(unnamed, *x), _from_com),
    _op("spatial_inertia_from_inertia", "Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose "
        "moments are about the centre of mass; NaN where m = 0", (_J,), (_Bo,),
        lambda J: _of_inertia(unnamed, J), _of_inertia, rounding=_CONVERTED),
    _op("inertia_from_spatial_inertia", "Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, "
        "with moments about the centre of mass; NaN where m = 0", (_B,), (_Jo,),
        lambda B: _to_inertia(unnamed, B), _to_inertia, rounding=_CONVERTED),
    _op("spatial_inertia_com", "vo = h / m, the centre of mass in m", (_B,), (_vo,),
        lambda B: _first(B) / B[0],
        rounding="Error <= u |result|, barring over- and underflow."),
    _op("spatial_inertia_about_com", "Ro = I + h~ h~ / m, the second moments about the centre of "
        "mass", (_B,), (_Ro,), lambda B: _second(B) + skew(_first(B))**2 / B[0], _about_com),
    _op("spatial_inertia_matrix", "Mo = [[m 1, -h~], [h~, I]]", (_B,), (_Mo,), _operator),
    _op("product_Bs", "co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves "
        "with s", (_B, _s), (_co,), _momentum),
    _op("spatial_inertia_energy", "s·B s / 2, the kinetic energy in J of a body that moves with s",
        (_B, _s), (_energy,), lambda B, s: s.dot(_momentum(B, s)) / 2, _energy_of),
    _op("spatial_inertia_net_wrench", "co = B ds + (w × (w × h); w × I w): the net wrench, about "
        "the origin, of a body with angular velocity w and acceleration ds = (a; w'), where a is "
        "that of the point now at the origin; if a is less gravity's, so is the wrench",
        (_B, _w, _ds), (_co,), _wrench_formula, _net_wrench),
    _op("spatial_inertia_shifted", "Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~",
        (_t, _B), (_Bo,), lambda t, B: _shifted(unnamed, t, B), _shifted),
    _op("spatial_inertia_transformed", "Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in "
        "the reference frame",
        (_D, _B), (_Bo,), lambda D, B: _transformed(unnamed, D, B), _transformed),
    _op("spatial_inertia_consistency", "the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each "
        "divided by its diagonal entry: positive exactly if a body of positive density has this "
        "inertia", (_B,), (_pivot,),
        lambda B: smallest_pivot(*lower_triangle(_pseudo_inertia(unnamed, B))), _consistency),
)

FAMILY = Family(_NAME, 150, __doc__, OPERATIONS, includes=("inertia", "coscrew"))
