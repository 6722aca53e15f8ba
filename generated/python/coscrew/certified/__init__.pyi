# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
import numpy as np
from numpy.typing import ArrayLike, NDArray

_Array = NDArray[np.floating]
_Out = _Array | None

from coscrew.certified import double as double, single as single

COMPILED: bool

def sincos(x: ArrayLike, out: tuple[_Out, _Out, _Out, _Out] | None = ...) -> tuple[_Array, _Array, _Array, _Array]:
    """s = sin x, c = cos x, x in rad; |error of s| <= s_bound, |error of c| <= c_bound unless inf
    or NaN.

    ()->(),(),(),().  x, s, c, s_bound, c_bound: number.
    83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select.
    """

def sin(x: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """s = sin x, x in rad; |error of s| <= s_bound unless inf or NaN.

    ()->(),().  x, s, s_bound: number.
    83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select.
    """

def cos(x: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """c = cos x, x in rad; |error of c| <= c_bound unless inf or NaN.

    ()->(),().  x, c, c_bound: number.
    83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select.
    """

def exp(x: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = e^x; |error of y| <= y_bound unless inf or NaN.

    ()->(),().  x, y, y_bound: number.
    82 mul, 149 add, 14 product error, 5 power of two, 2 abs, 7 less, 1 equal, 9 select.
    """

def tanh(x: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = tanh x; |error of y| <= y_bound unless inf or NaN.

    ()->(),().  x, y, y_bound: number.
    92 mul, 175 add, 15 product error, 2 div, 2 power of two, 6 abs, 2 copysign, 5 less, 11
    select.
    """

def atan2(y: ArrayLike, x: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """angle of the vector (x, y) to the x axis, in rad, from -π to π; |error of angle| <=
    angle_bound unless inf or NaN.

    (),()->(),().  y, x, angle, angle_bound: number.
    123 mul, 214 add, 21 product error, 2 div, 1 neg, 10 abs, 4 copysign, 13 less, 3 equal, 23
    select.
    """

def vec3_scale(self: ArrayLike, a: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (3),()->(3),(3).  self, self_bound: vector; a: number.
    6 mul, 3 add, 3 abs.
    """

def axpy_vv(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = a x + y; |error of y| <= y_bound unless inf or NaN.

    (),(3),(3)->(3),(3).  a: number; x, y, y_bound: vector.
    6 mul, 9 add, 6 abs.
    """

def xpy_vv(x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = x + y; |error of y| <= y_bound unless inf or NaN.

    (3),(3)->(3),(3).  x, y, y_bound: vector.
    3 mul, 3 add, 3 abs.
    """

def nxpy_vv(x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = -x + y; |error of y| <= y_bound unless inf or NaN.

    (3),(3)->(3),(3).  x, y, y_bound: vector.
    3 mul, 3 add, 3 abs.
    """

def product_av(a: ArrayLike, vi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = a vi; |error of vo| <= vo_bound unless inf or NaN.

    (),(3)->(3),(3).  a: number; vi, vo, vo_bound: vector.
    6 mul, 3 add, 3 abs.
    """

def add_vv(v1: ArrayLike, v2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    3 mul, 3 add, 3 abs.
    """

def subtract_vv(v1: ArrayLike, v2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    3 mul, 3 add, 3 abs.
    """

def vec3_scaled(v: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = k v; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    6 mul, 3 add, 3 abs.
    """

def angle_vv(v1: ArrayLike, v2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """angle = atan2(|v1 × v2|, v1·v2), in [0, π]; |error of angle| <= angle_bound unless inf or
    NaN.

    (3),(3)->(),().  v1, v2: vector; angle, angle_bound: number.
    196 mul, 311 add, 22 product error, 12 product rest, 12 div, 2 sqrt, 1 neg, 40 abs, 4
    copysign, 37 less, 5 equal, 56 select.
    """

def dot_vv(v1: ArrayLike, v2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """v1·v2; |error of dot| <= dot_bound unless inf or NaN.

    (3),(3)->(),().  v1, v2: vector; dot, dot_bound: number.
    4 mul, 5 add, 3 abs.
    """

def product_avinv(k: ArrayLike, v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = k (-v); |error of vo| <= vo_bound unless inf or NaN.

    (),(3)->(3),(3).  k: number; v, vo, vo_bound: vector.
    6 mul, 3 add, 3 neg, 3 abs.
    """

def cross_vv(v1: ArrayLike, v2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v1 × v2; |error of vo| <= vo_bound unless inf or NaN.  Exactly zero for v1 = v2, unless
    products overflow.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    9 mul, 9 add, 6 abs.
    """

def cross_vvinv(v1: ArrayLike, v2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    9 mul, 9 add, 6 abs.
    """

def add_vvx(v: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """

def add_vvxinv(v: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """

def add_vvy(v: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """

def add_vvyinv(v: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """

def add_vvz(v: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """

def add_vvzinv(v: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """

def vec4_scale(self: ArrayLike, a: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (4),()->(4),(4).  self, self_bound: vector (x, y, z) and a homogeneous coordinate w; a:
    number.
    8 mul, 4 add, 4 abs.
    """

def vec4_scaled(v: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = k v; |error of vo| <= vo_bound unless inf or NaN.

    (4),()->(4),(4).  v, vo, vo_bound: vector (x, y, z) and a homogeneous coordinate w; k:
    number.
    8 mul, 4 add, 4 abs.
    """

def acceleration_tensor(w: ArrayLike, dw: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
    acceleration of its point x, less that of its origin, is Ro x; |error of Ro| <= Ro_bound
    unless inf or NaN.

    (3),(3)->(3,3),(3,3).  w, dw: vector; Ro, Ro_bound: rotation or other 3×3 matrix.
    15 mul, 27 add, 3 neg, 9 abs.
    """

def mat3x3_determinant(R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """det R; |error of det| <= det_bound unless inf or NaN.

    (3,3)->(),().  R: rotation or other 3×3 matrix; det, det_bound: number.
    13 mul, 14 add, 9 abs.
    """

def mat3x3_setFromAxisDC(axis: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
    dc = (sin θ, cos θ); |error of R| <= R_bound unless inf or NaN.

    (3),(2)->(3,3),(3,3).  axis: vector; dc: (sin θ, cos θ); R, R_bound: rotation or other 3×3
    matrix.
    30 mul, 31 add, 8 abs.
    """

def mat3x3_from_euler_xyz(angles: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.

    (3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.
    291 mul, 434 add, 39 product error, 8 product rest, 3 div, 9 neg, 18 abs, 3 less, 3 select.
    """

def euler_xyz_from_mat3x3(R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
    [-π/2, π/2]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.

    (3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.
    455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 4 neg, 72 abs, 12
    copysign, 59 less, 14 equal, 108 select.
    """

def mat3x3_from_euler_xyx(angles: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.

    (3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.
    291 mul, 434 add, 39 product error, 8 product rest, 3 div, 5 neg, 18 abs, 3 less, 3 select.
    """

def euler_xyx_from_mat3x3(R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in
    [0, π]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.

    (3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.
    455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 3 neg, 72 abs, 12
    copysign, 61 less, 14 equal, 110 select.
    """

def SE3_invert(self: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = self^-1 = [R^T | -R^T t]; |error of self| <= self_bound unless inf or NaN.

    (3,4)->(3,4),(3,4).  self, self_bound: displacement [R | t], R rotation, t in m.
    12 mul, 15 add, 3 neg, 9 abs.
    """

def SE3_inverted(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D^-1 = [R^T | -R^T t]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m.
    12 mul, 15 add, 3 neg, 9 abs.
    """

def mat6x6_rotated(R: ArrayLike, M: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
    lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.

    (3,3),(6,6)->(6,6),(6,6).  R: rotation or other 3×3 matrix; M, Mo, Mo_bound: 6×6 operator.
    228 mul, 240 add, 90 abs.
    """

def mat6x6_shifted(t: ArrayLike, M: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
    lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.

    (3),(6,6)->(6,6),(6,6).  t: vector; M, Mo, Mo_bound: 6×6 operator.
    66 mul, 99 add, 45 abs.
    """

def product_drv(R: ArrayLike, v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R v; |error of vo| <= vo_bound unless inf or NaN.

    (3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
    12 mul, 15 add, 9 abs.
    """

def product_drvinv(R: ArrayLike, v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
    12 mul, 15 add, 3 neg, 9 abs.
    """

def product_drinvv(R: ArrayLike, v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.

    (3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
    12 mul, 15 add, 9 abs.
    """

def product_drinvvinv(R: ArrayLike, v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
    12 mul, 15 add, 3 neg, 9 abs.
    """

def product_dv(D: ArrayLike, v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.

    (3,4),(3)->(3),(3).  D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
    12 mul, 21 add, 12 abs.
    """

def product_dinvv(D: ArrayLike, v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.

    (3,4),(3)->(3),(3).  D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
    21 mul, 18 add, 12 abs.
    """

def product_drdr(R1: ArrayLike, R2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """

def product_drdrinv(R1: ArrayLike, R2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """

def product_drinvdr(R1: ArrayLike, R2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """

def product_dd(D1: ArrayLike, D2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
    48 mul, 66 add, 39 abs.
    """

def product_ddinv(D1: ArrayLike, D2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
    57 mul, 66 add, 33 abs.
    """

def product_dinvd(D1: ArrayLike, D2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
    57 mul, 63 add, 39 abs.
    """

def product_ddr(D: ArrayLike, R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; R:
    rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """

def product_ddrinv(D: ArrayLike, R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; R:
    rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """

def product_ddt(D: ArrayLike, t: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:
    vector.
    12 mul, 21 add, 12 abs.
    """

def product_ddtinv(D: ArrayLike, t: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:
    vector.
    12 mul, 21 add, 12 abs.
    """

def product_dinvdt(D: ArrayLike, t: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:
    vector.
    21 mul, 18 add, 12 abs.
    """

def product_drvtx(R: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 abs.
    """

def product_drdrx(R: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R R_x(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddrx(D: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [R_x(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddtx(D: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [I | k e_x]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """

def product_drvtxinv(R: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 neg, 3 abs.
    """

def product_drdrxinv(R: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R R_x(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddrxinv(D: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddtxinv(D: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [I | -k e_x]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """

def product_drvty(R: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 abs.
    """

def product_drdry(R: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R R_y(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddry(D: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [R_y(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddty(D: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [I | k e_y]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """

def product_drvtyinv(R: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 neg, 3 abs.
    """

def product_drdryinv(R: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R R_y(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddryinv(D: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddtyinv(D: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [I | -k e_y]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """

def product_drvtz(R: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 abs.
    """

def product_drdrz(R: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R R_z(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddrz(D: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [R_z(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddtz(D: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [I | k e_z]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """

def product_drvtzinv(R: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 neg, 3 abs.
    """

def product_drdrzinv(R: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R R_z(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddrzinv(D: ArrayLike, dc: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """

def product_ddtzinv(D: ArrayLike, k: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Do = D [I | -k e_z]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """

def dc(theta: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """dc = (sin θ, cos θ), θ in rad; |error of dc| <= dc_bound unless inf or NaN.

    ()->(2),(2).  theta: number; dc, dc_bound: (sin θ, cos θ).
    83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select.
    """

def screw_scale(self: ArrayLike, a: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (6),()->(6),(6).  self, self_bound: screw (v in m/s; ω in rad/s); a: number.
    12 mul, 6 add, 6 abs.
    """

def axpy_ss(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = a x + y; |error of y| <= y_bound unless inf or NaN.

    (),(6),(6)->(6),(6).  a: number; x, y, y_bound: screw (v in m/s; ω in rad/s).
    12 mul, 18 add, 12 abs.
    """

def xpy_ss(x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = x + y; |error of y| <= y_bound unless inf or NaN.

    (6),(6)->(6),(6).  x, y, y_bound: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 abs.
    """

def nxpy_ss(x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = -x + y; |error of y| <= y_bound unless inf or NaN.

    (6),(6)->(6),(6).  x, y, y_bound: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 abs.
    """

def product_as(a: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = a si; |error of so| <= so_bound unless inf or NaN.

    (),(6)->(6),(6).  a: number; si, so, so_bound: screw (v in m/s; ω in rad/s).
    12 mul, 6 add, 6 abs.
    """

def add_ss(s1: ArrayLike, s2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = s1 + s2; |error of so| <= so_bound unless inf or NaN.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 abs.
    """

def subtract_ss(s1: ArrayLike, s2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = s1 - s2; |error of so| <= so_bound unless inf or NaN.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 abs.
    """

def add_sst(s1: ArrayLike, s2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = (s1.lin + s2.lin ; s1.ang); |error of so| <= so_bound unless inf or NaN.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    3 mul, 3 add, 3 abs.
    """

def product_Adts(t: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [Ad](t) si; |error of so| <= so_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
    9 mul, 15 add, 9 abs.
    """

def product_Adtinvs(t: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [Ad](t)^-1 si; |error of so| <= so_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
    9 mul, 15 add, 9 abs.
    """

def product_Adtsinv(t: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [Ad](t) (-si); |error of so| <= so_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
    9 mul, 15 add, 3 neg, 9 abs.
    """

def product_Adrs(R: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [Ad](R) si; |error of so| <= so_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω
    in rad/s).
    24 mul, 30 add, 18 abs.
    """

def product_Adrinvs(R: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [Ad](R)^-1 si; |error of so| <= so_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω
    in rad/s).
    24 mul, 30 add, 18 abs.
    """

def product_Adrsinv(R: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [Ad](R) (-si); |error of so| <= so_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω
    in rad/s).
    24 mul, 30 add, 6 neg, 18 abs.
    """

def product_Ads(D: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [Ad](D) si = [Ad](t) [Ad](R) si; |error of so| <= so_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v
    in m/s; ω in rad/s).
    36 mul, 42 add, 21 abs.
    """

def product_Adinvs(D: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si; |error of so| <= so_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v
    in m/s; ω in rad/s).
    39 mul, 45 add, 27 abs.
    """

def product_Adsinv(D: ArrayLike, si: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [Ad](D) (-si); |error of so| <= so_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v
    in m/s; ω in rad/s).
    36 mul, 42 add, 6 neg, 21 abs.
    """

def hsrx(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = h_rx: column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 6 abs.
    """

def hsry(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = h_ry: column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 6 abs.
    """

def hsrz(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = h_rz: column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 6 abs.
    """

def hsrxinv(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = -h_rx: -column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 3 neg, 6 abs.
    """

def hsryinv(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = -h_ry: -column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 3 neg, 6 abs.
    """

def hsrzinv(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = -h_rz: -column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 3 neg, 6 abs.
    """

def Ad(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """M = [Ad](D); |error of M| <= M_bound unless inf or NaN.

    (3,4)->(6,6),(6,6).  D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
    27 mul, 27 add, 18 abs.
    """

def dot_cs(c: ArrayLike, s: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """power = f·v + τ·ω, in W; |error of power| <= power_bound unless inf or NaN.

    (6),(6)->(),().  c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power,
    power_bound: number.
    7 mul, 11 add, 6 abs.
    """

def cross_ss(s1: ArrayLike, s2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2); |error of so| <= so_bound unless inf or NaN.
    Exactly zero for s1 = s2, unless products overflow.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    24 mul, 30 add, 18 abs.
    """

def cross_sst(s1: ArrayLike, s2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = (ω1×v2 ; 0); |error of so| <= so_bound unless inf or NaN.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    9 mul, 9 add, 6 abs.
    """

def hsra(D: ArrayLike, axis: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = (t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or
    NaN.

    (3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,
    so_bound: screw (v in m/s; ω in rad/s).
    27 mul, 24 add, 12 abs.
    """

def hsta(D: ArrayLike, axis: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = (R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.

    (3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,
    so_bound: screw (v in m/s; ω in rad/s).
    12 mul, 15 add, 9 abs.
    """

def hsrainv(D: ArrayLike, axis: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = -(t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or
    NaN.

    (3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,
    so_bound: screw (v in m/s; ω in rad/s).
    27 mul, 24 add, 3 neg, 12 abs.
    """

def hstainv(D: ArrayLike, axis: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so = -(R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.

    (3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,
    so_bound: screw (v in m/s; ω in rad/s).
    12 mul, 15 add, 3 neg, 9 abs.
    """

def coscrew_scale(self: ArrayLike, a: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (6),()->(6),(6).  self, self_bound: coscrew (f in N; τ in N m); a: number.
    12 mul, 6 add, 6 abs.
    """

def axpy_cc(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = a x + y; |error of y| <= y_bound unless inf or NaN.

    (),(6),(6)->(6),(6).  a: number; x, y, y_bound: coscrew (f in N; τ in N m).
    12 mul, 18 add, 12 abs.
    """

def xpy_cc(x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = x + y; |error of y| <= y_bound unless inf or NaN.

    (6),(6)->(6),(6).  x, y, y_bound: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 abs.
    """

def nxpy_cc(x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = -x + y; |error of y| <= y_bound unless inf or NaN.

    (6),(6)->(6),(6).  x, y, y_bound: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 abs.
    """

def product_ac(a: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = a ci; |error of co| <= co_bound unless inf or NaN.

    (),(6)->(6),(6).  a: number; ci, co, co_bound: coscrew (f in N; τ in N m).
    12 mul, 6 add, 6 abs.
    """

def add_cc(c1: ArrayLike, c2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = c1 + c2; |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 abs.
    """

def subtract_cc(c1: ArrayLike, c2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = c1 - c2; |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 abs.
    """

def add_cct(c1: ArrayLike, c2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = (c1.lin + c2.lin ; c1.ang); |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).
    3 mul, 3 add, 3 abs.
    """

def product_CoAdtc(t: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [Ad]*(t) ci; |error of co| <= co_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
    9 mul, 15 add, 9 abs.
    """

def product_CoAdtinvc(t: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [Ad]*(t)^-1 ci; |error of co| <= co_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
    9 mul, 15 add, 9 abs.
    """

def product_CoAdtcinv(t: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [Ad]*(t) (-ci); |error of co| <= co_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
    9 mul, 15 add, 3 neg, 9 abs.
    """

def product_CoAdrc(R: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ
    in N m).
    24 mul, 30 add, 18 abs.
    """

def product_CoAdrinvc(R: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [Ad]*(R)^-1 ci; |error of co| <= co_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ
    in N m).
    24 mul, 30 add, 18 abs.
    """

def product_CoAdrcinv(R: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [Ad]*(R) (-ci); |error of co| <= co_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ
    in N m).
    24 mul, 30 add, 6 neg, 18 abs.
    """

def product_CoAdc(D: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew
    (f in N; τ in N m).
    36 mul, 42 add, 21 abs.
    """

def product_CoAdinvc(D: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci; |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew
    (f in N; τ in N m).
    39 mul, 45 add, 27 abs.
    """

def product_CoAdcinv(D: ArrayLike, ci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [Ad]*(D) (-ci); |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew
    (f in N; τ in N m).
    36 mul, 42 add, 6 neg, 21 abs.
    """

def hctx(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = h_tx: column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 6 abs.
    """

def hcty(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = h_ty: column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 6 abs.
    """

def hctz(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = h_tz: column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 6 abs.
    """

def hctxinv(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = -h_tx: -column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 3 neg, 6 abs.
    """

def hctyinv(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = -h_ty: -column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 3 neg, 6 abs.
    """

def hctzinv(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = -h_tz: -column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 3 neg, 6 abs.
    """

def CoAd(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """M = [Ad]*(D); |error of M| <= M_bound unless inf or NaN.

    (3,4)->(6,6),(6,6).  D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
    27 mul, 27 add, 18 abs.
    """

def reciprocal_product(c: ArrayLike, x: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v); |error of power| <= power_bound
    unless inf or NaN.

    (6),(6)->(),().  c: coscrew (f in N; τ in N m); x: six components with the angular part on
    top; power, power_bound: number.
    7 mul, 11 add, 6 abs.
    """

def cross_sc(s: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = [ad]*(s) c = (ω×f ; v×f + ω×τ); |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N
    m).
    24 mul, 30 add, 18 abs.
    """

def cross_sca(s: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = (0 ; ω×τ); |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N
    m).
    9 mul, 9 add, 6 abs.
    """

def constraint_ctx(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """

def constraint_cty(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """

def constraint_ctz(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """

def constraint_crx(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """

def constraint_cry(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """

def constraint_crz(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """

def working_ctx(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    21 mul, 12 add, 6 abs.
    """

def working_cty(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    21 mul, 12 add, 6 abs.
    """

def working_ctz(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    21 mul, 12 add, 6 abs.
    """

def working_crx(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    6 mul, 3 add, 3 abs.
    """

def working_cry(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    6 mul, 3 add, 3 abs.
    """

def working_crz(D: ArrayLike, c: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    6 mul, 3 add, 3 abs.
    """

def quaternion_scale(self: ArrayLike, a: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (4),()->(4),(4).  self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.
    8 mul, 4 add, 4 abs.
    """

def axpy_qq(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """y = a x + y; |error of y| <= y_bound unless inf or NaN.

    (),(4),(4)->(4),(4).  a: number; x, y, y_bound: quaternion (x, y, z, w), the scalar last.
    8 mul, 12 add, 8 abs.
    """

def rotate_qv(q: ArrayLike, v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.

    (4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
    33 mul, 33 add, 13 abs.
    """

def rotate_qconjv(q: ArrayLike, v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.

    (4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
    33 mul, 33 add, 13 abs.
    """

def quaternion_product_qq(q1i: ArrayLike, q2i: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = q1i q2i; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """

def quaternion_product_qqconj(q1i: ArrayLike, q2i: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = q1i q2i*; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """

def quaternion_product_qconjq(q1i: ArrayLike, q2i: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = q1i* q2i; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """

def quaternion_product_qconjqconj(q1i: ArrayLike, q2i: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = q1i* q2i*; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """

def quaternion_product_qxq(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qxqconj(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 1 neg, 8 abs.
    """

def quaternion_product_qxconjq(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qxconjqconj(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 2 neg, 8 abs.
    """

def quaternion_product_qqx(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qqxconj(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qconjqx(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 1 neg, 8 abs.
    """

def quaternion_product_qconjqxconj(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 2 neg, 8 abs.
    """

def quaternion_product_qyq(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qyqconj(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 1 neg, 8 abs.
    """

def quaternion_product_qyconjq(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qyconjqconj(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 2 neg, 8 abs.
    """

def quaternion_product_qqy(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qqyconj(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qconjqy(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 1 neg, 8 abs.
    """

def quaternion_product_qconjqyconj(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 2 neg, 8 abs.
    """

def quaternion_product_qzq(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qzqconj(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 1 neg, 8 abs.
    """

def quaternion_product_qzconjq(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qzconjqconj(dci: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 2 neg, 8 abs.
    """

def quaternion_product_qqz(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qqzconj(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """

def quaternion_product_qconjqz(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 1 neg, 8 abs.
    """

def quaternion_product_qconjqzconj(qi: ArrayLike, dci: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 2 neg, 8 abs.
    """

def quaternion_product_qv(qi: ArrayLike, vi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi (vi; 0); |error of qo| <= qo_bound unless inf or NaN.

    (4),(3)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
    16 mul, 20 add, 1 neg, 12 abs.
    """

def quaternion_product_qconjv(qi: ArrayLike, vi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = qi* (vi; 0); |error of qo| <= qo_bound unless inf or NaN.

    (4),(3)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
    16 mul, 20 add, 12 abs.
    """

def quaternion_product_vq(vi: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (vi; 0) qi; |error of qo| <= qo_bound unless inf or NaN.

    (3),(4)->(4),(4).  vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    16 mul, 20 add, 1 neg, 12 abs.
    """

def quaternion_product_vqconj(vi: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (vi; 0) qi*; |error of qo| <= qo_bound unless inf or NaN.

    (3),(4)->(4),(4).  vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    16 mul, 20 add, 12 abs.
    """

def dot_qq(q1i: ArrayLike, q2i: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """q1i·q2i; |error of dot| <= dot_bound unless inf or NaN.

    (4),(4)->(),().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot, dot_bound: number.
    5 mul, 7 add, 4 abs.
    """

def add_dpiToq(dpi: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
    first order; not normalized; |error of qi| <= qi_bound unless inf or NaN.

    (3),(4)->(4),(4).  dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
    31 mul, 31 add, 7 abs.
    """

def subtract_dpiFromq(dpi: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order; |error of qi| <=
    qi_bound unless inf or NaN.

    (3),(4)->(4),(4).  dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
    31 mul, 31 add, 7 abs.
    """

def omega_to_dquaternion(w: ArrayLike, qi: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
    reference frame, rad/s, and a term that draws its norm to 1; |error of dqo| <= dqo_bound
    unless inf or NaN.

    (3),(4)->(4),(4).  w: vector; qi, dqo, dqo_bound: quaternion (x, y, z, w), the scalar last.
    43 mul, 40 add, 11 abs.
    """

def quaternion_from_axis_angle(axis: ArrayLike, angle: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
    rotation is by another angle; |error of qo| <= qo_bound unless inf or NaN.

    (3),()->(4),(4).  axis: vector; angle: number; qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    98 mul, 139 add, 14 product error, 1 div, 11 abs, 1 less, 1 select.
    """

def axis_angle_from_quaternion(q: ArrayLike, out: tuple[_Out, _Out, _Out, _Out] | None = ...) -> tuple[_Array, _Array, _Array, _Array]:
    """angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
    angle is 0; any multiple of a quaternion; |error of angle| <= angle_bound, |error of axis|
    <= axis_bound unless inf or NaN.

    (4)->(),(3),(),(3).  q: quaternion (x, y, z, w), the scalar last; angle, angle_bound:
    number; axis, axis_bound: vector.
    201 mul, 318 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 5 neg, 50 abs, 4
    copysign, 35 less, 10 equal, 69 select.
    """

def quaternion_exp(v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v; |error
    of qo| <= qo_bound unless inf or NaN.

    (3)->(4),(4).  v: vector; qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    266 mul, 346 add, 17 product error, 4 product rest, 11 div, 3 sqrt, 37 abs, 11 less, 1
    equal, 24 select.
    """

def quaternion_log(q: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of
    it; |error of vo| <= vo_bound unless inf or NaN.

    (4)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; vo, vo_bound: vector.
    209 mul, 315 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 5 neg, 49 abs, 4
    copysign, 35 less, 10 equal, 65 select.
    """

def SO3_exp(v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|; |error of R| <= R_bound unless
    inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    336 mul, 494 add, 17 product error, 22 product rest, 12 div, 3 sqrt, 51 abs, 14 less, 1
    equal, 29 select.
    """

def SO3_log(R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo;
    |error of vo| <= vo_bound unless inf or NaN.

    (3,3)->(3),(3).  R: rotation or other 3×3 matrix; vo, vo_bound: vector.
    244 mul, 466 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 10 neg, 72 abs, 4
    copysign, 41 less, 7 equal, 107 select.
    """

def SO3_leftJacobian(v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound
    unless inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 90 abs, 20 less, 1
    equal, 45 select.
    """

def SO3_rightJacobian(v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound
    unless inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 12 neg, 90 abs, 20
    less, 1 equal, 45 select.
    """

def SO3_leftJacobianInverse(v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0; |error of R| <= R_bound unless inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 6 neg, 93 abs, 23 less,
    1 equal, 47 select.
    """

def SO3_rightJacobianInverse(v: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0; |error of R| <= R_bound unless inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 93 abs, 23 less, 1
    equal, 47 select.
    """

def mat3x3_from_axis_angle(axis: ArrayLike, angle: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
    not a rotation; |error of R| <= R_bound unless inf or NaN.

    (3),()->(3,3),(3,3).  axis: vector; angle: number; R, R_bound: rotation or other 3×3 matrix.
    216 mul, 380 add, 26 product error, 18 product rest, 2 div, 24 abs, 4 less, 6 select.
    """

def axis_angle_from_mat3x3(R: ArrayLike, out: tuple[_Out, _Out, _Out, _Out] | None = ...) -> tuple[_Array, _Array, _Array, _Array]:
    """angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0;
    |error of angle| <= angle_bound, |error of axis| <= axis_bound unless inf or NaN.

    (3,3)->(),(3),(),(3).  R: rotation or other 3×3 matrix; angle, angle_bound: number; axis,
    axis_bound: vector.
    233 mul, 467 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 10 neg, 70 abs, 4
    copysign, 41 less, 7 equal, 111 select.
    """

def mat3x3_orthonormalize(self: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of
    self| <= self_bound unless inf or NaN.

    (3,3)->(3,3),(3,3).  self, self_bound: rotation or other 3×3 matrix.
    93 mul, 105 add, 3 neg, 27 abs.
    """

def mat3x3_orthonormalized(R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of
    Ro| <= Ro_bound unless inf or NaN.

    (3,3)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix.
    93 mul, 105 add, 3 neg, 27 abs.
    """

def SE3_exp(s: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """D = exp s = [exp ω~ | J_l(ω) v]; |error of D| <= D_bound unless inf or NaN.

    (6)->(3,4),(3,4).  s: screw (v in m/s; ω in rad/s); D, D_bound: displacement [R | t], R
    rotation, t in m.
    524 mul, 876 add, 24 product error, 58 product rest, 16 div, 3 sqrt, 102 abs, 20 less, 1
    equal, 46 select.
    """

def SE3_log(D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R; |error of so| <= so_bound unless
    inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    599 mul, 986 add, 36 product error, 36 product rest, 47 div, 5 sqrt, 15 neg, 155 abs, 6
    copysign, 72 less, 10 equal, 171 select.
    """

def inertia(m: ArrayLike, t: ArrayLike, Ixx: ArrayLike, Iyy: ArrayLike, Izz: ArrayLike, Ixy: ArrayLike, Iyz: ArrayLike, Izx: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
    moments' matrix about it in kg m^2, Ixy = -∫ x y dm; |error of J| <= J_bound unless inf or
    NaN.

    (),(3),(),(),(),(),(),()->(10),(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J,
    J_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy,
    yz, zx in kg m^2).
    6 mul, 3 add, 3 abs.
    """

def inertia_rotated(Ji: ArrayLike, R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Jo = Ji rotated by R: m, R mt, R I R^T; |error of Jo| <= Jo_bound unless inf or NaN.

    (10),(3,3)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    81 mul, 90 add, 45 abs.
    """

def inertia_rotate(self: ArrayLike, R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = self rotated by R: m, R mt, R I R^T; |error of self| <= self_bound unless inf or NaN.

    (10),(3,3)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    81 mul, 90 add, 45 abs.
    """

def inertia_translated(Ji: ArrayLike, t: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Jo = Ji translated by t: m, mt + m t, I; |error of Jo| <= Jo_bound unless inf or NaN.

    (10),(3)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t: vector.
    6 mul, 9 add, 6 abs.
    """

def inertia_translate(self: ArrayLike, t: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = self translated by t: m, mt + m t, I; |error of self| <= self_bound unless inf or
    NaN.

    (10),(3)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t: vector.
    6 mul, 9 add, 6 abs.
    """

def inertia_transformed(Ji: ArrayLike, D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of Jo| <= Jo_bound unless
    inf or NaN.

    (10),(3,4)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t
    in m.
    84 mul, 96 add, 48 abs.
    """

def inertia_transform(self: ArrayLike, D: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = self displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of self| <= self_bound
    unless inf or NaN.

    (10),(3,4)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t
    in m.
    84 mul, 96 add, 48 abs.
    """

def spatial_inertia_scale(self: ArrayLike, a: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (10),()->(10),(10).  self, self_bound: spatial inertia (m in kg; h = m c in kg m; I about
    the origin, xx, yy, zz, xy, xz, yz in kg m^2); a: number.
    20 mul, 10 add, 10 abs.
    """

def add_BB(B1: ArrayLike, B2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Bo = B1 + B2; |error of Bo| <= Bo_bound unless inf or NaN.

    (10),(10)->(10),(10).  B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I
    about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    10 mul, 10 add, 10 abs.
    """

def subtract_BB(B1: ArrayLike, B2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Bo = B1 - B2; |error of Bo| <= Bo_bound unless inf or NaN.

    (10),(10)->(10),(10).  B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I
    about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    10 mul, 10 add, 10 abs.
    """

def spatial_inertia_from_com(m: ArrayLike, com: ArrayLike, Ic: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle
    is read): h = m com, I = Ic - m com~ com~; |error of Bo| <= Bo_bound unless inf or NaN.

    (),(3),(3,3)->(10),(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo,
    Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
    yz in kg m^2).
    24 mul, 27 add, 12 abs.
    """

def product_Bs(B: ArrayLike, s: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s; |error of
    co| <= co_bound unless inf or NaN.

    (10),(6)->(6),(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,
    yy, zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in
    N; τ in N m).
    30 mul, 42 add, 24 abs.
    """

def spatial_inertia_energy(B: ArrayLike, s: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """s·B s / 2, the kinetic energy in J of a body that moves with s; |error of energy| <=
    energy_bound unless inf or NaN.

    (10),(6)->(),().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy, energy_bound: number.
    35 mul, 43 add, 25 abs.
    """

def spatial_inertia_net_wrench(B: ArrayLike, w: ArrayLike, ds: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
    velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
    a is less gravity's, so is the wrench; |error of co| <= co_bound unless inf or NaN.

    (10),(3),(6)->(6),(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co,
    co_bound: coscrew (f in N; τ in N m).
    66 mul, 102 add, 3 neg, 30 abs.
    """

def spatial_inertia_shifted(t: ArrayLike, B: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~; |error of Bo| <= Bo_bound unless
    inf or NaN.

    (3),(10)->(10),(10).  t: vector; B, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m;
    I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    42 mul, 54 add, 15 abs.
    """

def spatial_inertia_transformed(D: ArrayLike, B: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame; |error of
    Bo| <= Bo_bound unless inf or NaN.

    (3,4),(10)->(10),(10).  D: displacement [R | t], R rotation, t in m; B, Bo, Bo_bound:
    spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
    m^2).
    114 mul, 135 add, 51 abs.
    """
