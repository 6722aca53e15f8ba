# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
import numpy as np
from numpy.typing import ArrayLike, NDArray

_Array = NDArray[np.floating]
_Out = _Array | None

from coscrew.accurate import double as double, single as single

COMPILED: bool

def sincos(x: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """s = sin x, c = cos x, x in rad.

    ()->(),().  x, s, c: number.
    83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.  Error <= 0.501
    ulp, unless a result is subnormal; proved.
    """

def sin(x: ArrayLike, out: _Out = ...) -> _Array:
    """s = sin x, x in rad.

    ()->().  x, s: number.
    83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.  Error <= 0.501
    ulp, unless a result is subnormal; proved.
    """

def cos(x: ArrayLike, out: _Out = ...) -> _Array:
    """c = cos x, x in rad.

    ()->().  x, c: number.
    83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.  Error <= 0.501
    ulp, unless a result is subnormal; proved.
    """

def exp(x: ArrayLike, out: _Out = ...) -> _Array:
    """y = e^x.

    ()->().  x, y: number.
    81 mul, 148 add, 14 product error, 5 power of two, 1 abs, 7 less, 2 equal, 10 select.  Error
    <= 0.501 ulp, unless a result is subnormal; proved.
    """

def tanh(x: ArrayLike, out: _Out = ...) -> _Array:
    """y = tanh x.

    ()->().  x, y: number.
    91 mul, 174 add, 15 product error, 2 div, 2 power of two, 4 abs, 2 copysign, 5 less, 1
    equal, 12 select.  Error <= 0.501 ulp, unless a result is subnormal; proved.
    """

def atan2(y: ArrayLike, x: ArrayLike, out: _Out = ...) -> _Array:
    """angle of the vector (x, y) to the x axis, in rad, from -π to π.

    (),()->().  y, x, angle: number.
    122 mul, 213 add, 21 product error, 2 div, 1 neg, 8 abs, 4 copysign, 13 less, 4 equal, 24
    select.  Error <= 0.501 ulp, unless a result is subnormal; proved.
    """

def vec3_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (3),()->(3).  self: vector; a: number.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def axpy_vv(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = a x + y.

    (),(3),(3)->(3).  a: number; x, y: vector.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def xpy_vv(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = x + y.

    (3),(3)->(3).  x, y: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """

def nxpy_vv(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = -x + y.

    (3),(3)->(3).  x, y: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """

def product_av(a: ArrayLike, vi: ArrayLike, out: _Out = ...) -> _Array:
    """vo = a vi.

    (),(3)->(3).  a: number; vi, vo: vector.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def add_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v1 + v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """

def subtract_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v1 - v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """

def vec3_scaled(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = k v.

    (3),()->(3).  v, vo: vector; k: number.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def vec3_l2norm(v: ArrayLike, out: _Out = ...) -> _Array:
    """|v| = sqrt(v·v).

    (3)->().  v: vector; norm: number.
    10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 3 abs, 8 less, 2 equal, 10
    select.
    """

def vec3_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|; the zero vector stays zero.

    (3)->(3).  self: vector.
    25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13
    select.
    """

def vec3_normalized(v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v / |v|; the zero vector stays zero.

    (3)->(3).  v, vo: vector.
    25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13
    select.
    """

def angle_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """angle = atan2(|v1 × v2|, v1·v2), in [0, π].

    (3),(3)->().  v1, v2: vector; angle: number.
    164 mul, 333 add, 22 product error, 12 product rest, 8 div, 1 sqrt, 4 neg, 19 abs, 4
    copysign, 35 less, 6 equal, 51 select.  Each component is within 1 ulp as long as its
    condition is below 1e13; in single precision it is the nearest number, except near ties, as
    long as that is below 1e5; searched, not proved.
    """

def dot_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """v1·v2.

    (3),(3)->().  v1, v2: vector; dot: number.
    3 mul, 11 add, 3 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_avinv(k: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = k (-v).

    (),(3)->(3).  k: number; v, vo: vector.
    3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.
    """

def product_ainvv(k: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v / k.

    (),(3)->(3).  k: number; v, vo: vector.
    3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select.
    """

def cross_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 15 add, 6 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def cross_vvinv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v1 × (-v2).

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 15 add, 6 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def add_vvx(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v + k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvxinv(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v - k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvy(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v + k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvyinv(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v - k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvz(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v + k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvzinv(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v - k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """

def vec4_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (4),()->(4).  self: vector (x, y, z) and a homogeneous coordinate w; a: number.
    4 mul, 4 add, 4 product error.  Error <= u |result|, barring over- and underflow.
    """

def vec4_scaled(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = k v.

    (4),()->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
    4 mul, 4 add, 4 product error.  Error <= u |result|, barring over- and underflow.
    """

def vec4_l2norm(v: ArrayLike, out: _Out = ...) -> _Array:
    """|v| = sqrt(v·v), all four components.

    (4)->().  v: vector (x, y, z) and a homogeneous coordinate w; norm: number.
    12 mul, 35 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11
    select.
    """

def vec4_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|; the zero vector stays zero.

    (4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.
    33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
    select.
    """

def vec4_normalized(v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v / |v|; the zero vector stays zero.

    (4)->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w.
    33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
    select.
    """

def acceleration_tensor(w: ArrayLike, dw: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
    acceleration of its point x, less that of its origin, is Ro x.

    (3),(3)->(3,3).  w, dw: vector; Ro: rotation or other 3×3 matrix.
    6 mul, 51 add, 12 product rest, 6 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def mat3x3_determinant(R: ArrayLike, out: _Out = ...) -> _Array:
    """det R.

    (3,3)->().  R: rotation or other 3×3 matrix; det: number.
    12 mul, 26 add, 9 product rest.  Error <= u |result| + 28 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def mat3x3_inverse(R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or
    overflows.  Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3
    (double 1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.

    (3,3)->(),(3,3).  R, Ro: rotation or other 3×3 matrix; det: number.
    106 mul, 290 add, 10 product error, 32 product rest, 22 div, 2 neg, 19 abs, 17 less, 11
    equal, 55 select.  Error of Ro_ij <= 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the
    sum of the |terms| of the cofactor, or 2^-80 m^2 (double 2^-700 m^2) if that is more;
    barring over- and underflow of Ro_ij itself.
    """

def mat3x3_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
    its side of the first, the third on its side of both; NaN where the rows are linearly
    dependent to rounding.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    154 mul, 405 add, 16 product error, 33 product rest, 31 div, 4 sqrt, 7 neg, 10 abs, 25 less,
    18 equal, 70 select.  |R R^T - I|_ij <= 8 u for the result R; searched, not proved.
    """

def mat3x3_normalized(R: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
    its side of the first, the third on its side of both; NaN where the rows are linearly
    dependent to rounding.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    154 mul, 405 add, 16 product error, 33 product rest, 31 div, 4 sqrt, 7 neg, 10 abs, 25 less,
    18 equal, 70 select.  |R R^T - I|_ij <= 8 u for the result R; searched, not proved.
    """

def mat3x3_setFromAxisDC(axis: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
    dc = (sin θ, cos θ).

    (3),(2)->(3,3).  axis: vector; dc: (sin θ, cos θ); R: rotation or other 3×3 matrix.
    21 mul, 66 add, 3 product error, 15 product rest.  Error <= u |result| + 14 u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def mat3x3_from_euler_xyz(angles: ArrayLike, out: _Out = ...) -> _Array:
    """R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).

    (3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.
    291 mul, 434 add, 39 product error, 8 product rest, 3 div, 9 neg, 9 abs, 3 less, 9 equal, 12
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def euler_xyz_from_mat3x3(R: ArrayLike, out: _Out = ...) -> _Array:
    """angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
    [-π/2, π/2]; c = 0 in gimbal lock.

    (3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.
    391 mul, 713 add, 66 product error, 6 product rest, 17 div, 1 sqrt, 4 neg, 28 abs, 12
    copysign, 42 less, 16 equal, 87 select.  Each component is within 1 ulp as long as its
    condition is below 1e13; in single precision it is the nearest number, except near ties, as
    long as that is below 1e5; searched, not proved.
    """

def mat3x3_from_euler_xyx(angles: ArrayLike, out: _Out = ...) -> _Array:
    """R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).

    (3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.
    291 mul, 434 add, 39 product error, 8 product rest, 3 div, 5 neg, 9 abs, 3 less, 9 equal, 12
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def euler_xyx_from_mat3x3(R: ArrayLike, out: _Out = ...) -> _Array:
    """angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in
    [0, π]; c = 0 in gimbal lock.

    (3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.
    391 mul, 713 add, 66 product error, 6 product rest, 17 div, 1 sqrt, 3 neg, 28 abs, 12
    copysign, 42 less, 16 equal, 87 select.  Each component is within 1 ulp as long as its
    condition is below 1e13; in single precision it is the nearest number, except near ties, as
    long as that is below 1e5; searched, not proved.
    """

def mat3x3_jacobi(A: ArrayLike, V: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes
    A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.
    Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.

    (3,3),(3,3)->(3,3),(3,3).  A, V: rotation or other 3×3 matrix.
    51 mul, 153 add, 6 product error, 20 product rest, 8 div, 2 sqrt, 3 neg, 1 abs, 2 less, 13
    equal, 18 select.  V A V^T changes by at most 28 u max |A| for orthonormal V; searched, not
    proved.
    """

def mat3x3_rotation_defect(R: ArrayLike, out: _Out = ...) -> _Array:
    """the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if
    an entry is NaN.

    (3,3)->().  R: rotation or other 3×3 matrix; defect: number.
    30 mul, 228 add, 27 product rest, 7 neg, 7 abs, 13 less, 19 select.  Error <= 6 u near a
    rotation; measured, not proved.
    """

def SE3_invert(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def SE3_inverted(D: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def mat6x6_rotated(R: ArrayLike, M: ArrayLike, out: _Out = ...) -> _Array:
    """Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
    lower triangle is read.

    (3,3),(6,6)->(6,6).  R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
    207 mul, 564 add, 144 product rest.  Error <= u |result| + 37 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def mat6x6_shifted(t: ArrayLike, M: ArrayLike, out: _Out = ...) -> _Array:
    """Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
    lower triangle is read.

    (3),(6,6)->(6,6).  t: vector; M, Mo: 6×6 operator.
    51 mul, 264 add, 42 product rest.  Error <= u |result| + 45 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_drv(R: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R v.

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 33 add, 9 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_drvinv(R: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (-v).

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_drinvv(R: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R^T v.

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 33 add, 9 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_drinvvinv(R: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R^T (-v).

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_dv(D: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R v + t.

    (3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.
    9 mul, 54 add, 9 product rest.  Error <= u |result| + 15 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_dinvv(D: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R^T (v - t).

    (3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.
    18 mul, 60 add, 9 product rest.  Error <= u |result| + 18 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_drdr(R1: ArrayLike, R2: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R1 R2.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_drdrinv(R1: ArrayLike, R2: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R1 R2^T.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_drinvdr(R1: ArrayLike, R2: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R1^T R2.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_dd(D1: ArrayLike, D2: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D1 D2 = [R1 R2 | R1 t2 + t1].

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    36 mul, 153 add, 36 product rest.  Error <= u |result| + (R: 11, t: 15) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddinv(D1: ArrayLike, D2: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    45 mul, 162 add, 36 product rest.  Error <= u |result| + (R: 11, t: 44) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def product_dinvd(D1: ArrayLike, D2: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    45 mul, 159 add, 36 product rest.  Error <= u |result| + (R: 11, t: 18) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddr(D: ArrayLike, R: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R | 0].

    (3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other
    3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + (R: 11, t: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddrinv(D: ArrayLike, R: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R^T | 0].

    (3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other
    3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + (R: 11, t: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddt(D: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | t].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 54 add, 9 product rest.  Error <= u |result| + (R: 0, t: 15) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddtinv(D: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | -t].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 54 add, 9 product rest.  Error <= u |result| + (R: 0, t: 15) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_dinvdt(D: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    18 mul, 60 add, 9 product rest.  Error <= u |result| + (R: 0, t: 18) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_drvtx(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (k e_x).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def product_drdrx(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_x(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_ddrx(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddtx(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | k e_x].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_drvtxinv(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (-k e_x).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.
    """

def product_drdrxinv(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_x(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_ddrxinv(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddtxinv(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | -k e_x].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_drvty(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (k e_y).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def product_drdry(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_y(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_ddry(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddty(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | k e_y].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_drvtyinv(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (-k e_y).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.
    """

def product_drdryinv(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_y(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_ddryinv(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddtyinv(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | -k e_y].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_drvtz(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (k e_z).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def product_drdrz(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_z(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_ddrz(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddtz(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | k e_z].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_drvtzinv(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (-k e_z).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.
    """

def product_drdrzinv(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_z(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def product_ddrzinv(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_ddtzinv(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | -k e_z].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def dc(theta: ArrayLike, out: _Out = ...) -> _Array:
    """dc = (sin θ, cos θ), θ in rad.

    ()->(2).  theta: number; dc: (sin θ, cos θ).
    83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.  Error <= 0.501
    ulp, unless a result is subnormal; proved.
    """

def screw_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (6),()->(6).  self: screw (v in m/s; ω in rad/s); a: number.
    6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.
    """

def axpy_ss(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = a x + y.

    (),(6),(6)->(6).  a: number; x, y: screw (v in m/s; ω in rad/s).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def xpy_ss(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = x + y.

    (6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).
    42 add.  Error <= u |result|, barring over- and underflow.
    """

def nxpy_ss(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = -x + y.

    (6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).
    42 add.  Error <= u |result|, barring over- and underflow.
    """

def product_as(a: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = a si.

    (),(6)->(6).  a: number; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.
    """

def add_ss(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = s1 + s2.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    42 add.  Error <= u |result|, barring over- and underflow.
    """

def subtract_ss(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = s1 - s2.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    42 add.  Error <= u |result|, barring over- and underflow.
    """

def screw_norm(si: ArrayLike, out: _Out = ...) -> _Array:
    """|si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).

    (6)->().  si: screw (v in m/s; ω in rad/s); norm: number.
    10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 6 abs, 11 less, 3 equal, 16
    select.
    """

def screw_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|, with screw_norm; the zero screw stays zero.

    (6)->(6).  self: screw (v in m/s; ω in rad/s).
    43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,
    34 select.
    """

def screw_normalized(si: ArrayLike, out: _Out = ...) -> _Array:
    """so = si / |si|, with screw_norm; the zero screw stays zero.

    (6)->(6).  si, so: screw (v in m/s; ω in rad/s).
    43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,
    34 select.
    """

def add_sst(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = (s1.lin + s2.lin ; s1.ang).

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    21 add.  Error <= u |result|, barring over- and underflow.
    """

def product_Adts(t: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](t) si.

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def product_Adtinvs(t: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](t)^-1 si.

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def product_Adtsinv(t: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](t) (-si).

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 36 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def product_Adrs(R: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](R) si.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_Adrinvs(R: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](R)^-1 si.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_Adrsinv(R: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](R) (-si).

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 66 add, 18 product rest, 12 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_Ads(D: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](D) si = [Ad](t) [Ad](R) si.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    30 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def product_Adinvs(D: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    33 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def product_Adsinv(D: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](D) (-si).

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    30 mul, 108 add, 24 product rest, 12 neg.  Error <= u |result| + (lin: 35, ang: 11) u^2 S, S
    the sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def hsrx(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = h_rx: column 3 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def hsry(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = h_ry: column 4 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def hsrz(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = h_rz: column 5 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def hsrxinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = -h_rx: -column 3 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def hsryinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = -h_ry: -column 4 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def hsrzinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = -h_rz: -column 5 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def Ad(D: ArrayLike, out: _Out = ...) -> _Array:
    """M = [Ad](D).

    (3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
    18 mul, 45 add, 18 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def dot_cs(c: ArrayLike, s: ArrayLike, out: _Out = ...) -> _Array:
    """power = f·v + τ·ω, in W.

    (6),(6)->().  c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power: number.
    6 mul, 29 add, 6 product rest.  Error <= u |result| + 19 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def cross_ss(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
    overflow.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + (lin: 12, ang: 6) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def cross_sst(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = (ω1×v2 ; 0).

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def hsra(D: ArrayLike, axis: ArrayLike, out: _Out = ...) -> _Array:
    """so = (t×R a ; R a), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    21 mul, 54 add, 15 product rest.  Error <= u |result| + (lin: 28, ang: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def hsta(D: ArrayLike, axis: ArrayLike, out: _Out = ...) -> _Array:
    """so = (R a ; 0), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    9 mul, 33 add, 9 product rest.  Error <= u |result| + (lin: 11, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def hsrainv(D: ArrayLike, axis: ArrayLike, out: _Out = ...) -> _Array:
    """so = -(t×R a ; R a), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    21 mul, 54 add, 15 product rest, 6 neg.  Error <= u |result| + (lin: 28, ang: 11) u^2 S, S
    the sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def hstainv(D: ArrayLike, axis: ArrayLike, out: _Out = ...) -> _Array:
    """so = -(R a ; 0), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + (lin: 11, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def coscrew_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (6),()->(6).  self: coscrew (f in N; τ in N m); a: number.
    6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.
    """

def axpy_cc(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = a x + y.

    (),(6),(6)->(6).  a: number; x, y: coscrew (f in N; τ in N m).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def xpy_cc(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = x + y.

    (6),(6)->(6).  x, y: coscrew (f in N; τ in N m).
    42 add.  Error <= u |result|, barring over- and underflow.
    """

def nxpy_cc(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = -x + y.

    (6),(6)->(6).  x, y: coscrew (f in N; τ in N m).
    42 add.  Error <= u |result|, barring over- and underflow.
    """

def product_ac(a: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = a ci.

    (),(6)->(6).  a: number; ci, co: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.
    """

def add_cc(c1: ArrayLike, c2: ArrayLike, out: _Out = ...) -> _Array:
    """co = c1 + c2.

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    42 add.  Error <= u |result|, barring over- and underflow.
    """

def subtract_cc(c1: ArrayLike, c2: ArrayLike, out: _Out = ...) -> _Array:
    """co = c1 - c2.

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    42 add.  Error <= u |result|, barring over- and underflow.
    """

def coscrew_norm(ci: ArrayLike, out: _Out = ...) -> _Array:
    """|ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).

    (6)->().  ci: coscrew (f in N; τ in N m); norm: number.
    10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 6 abs, 11 less, 3 equal, 16
    select.
    """

def coscrew_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  self: coscrew (f in N; τ in N m).
    43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,
    34 select.
    """

def coscrew_normalized(ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  ci, co: coscrew (f in N; τ in N m).
    43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,
    34 select.
    """

def add_cct(c1: ArrayLike, c2: ArrayLike, out: _Out = ...) -> _Array:
    """co = (c1.lin + c2.lin ; c1.ang).

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    21 add.  Error <= u |result|, barring over- and underflow.
    """

def product_CoAdtc(t: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(t) ci.

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def product_CoAdtinvc(t: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(t)^-1 ci.

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def product_CoAdtcinv(t: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(t) (-ci).

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 36 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def product_CoAdrc(R: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(R) ci.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_CoAdrinvc(R: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(R)^-1 ci.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_CoAdrcinv(R: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(R) (-ci).

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 66 add, 18 product rest, 12 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def product_CoAdc(D: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    30 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def product_CoAdinvc(D: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    33 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def product_CoAdcinv(D: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(D) (-ci).

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    30 mul, 108 add, 24 product rest, 12 neg.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S
    the sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def hctx(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = h_tx: column 0 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def hcty(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = h_ty: column 1 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def hctz(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = h_tz: column 2 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def hctxinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = -h_tx: -column 0 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def hctyinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = -h_ty: -column 1 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def hctzinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = -h_tz: -column 2 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def CoAd(D: ArrayLike, out: _Out = ...) -> _Array:
    """M = [Ad]*(D).

    (3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
    18 mul, 45 add, 18 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def reciprocal_product(c: ArrayLike, x: ArrayLike, out: _Out = ...) -> _Array:
    """power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).

    (6),(6)->().  c: coscrew (f in N; τ in N m); x: six components with the angular part on top;
    power: number.
    6 mul, 29 add, 6 product rest.  Error <= u |result| + 19 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def cross_sc(s: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = [ad]*(s) c = (ω×f ; v×f + ω×τ).

    (6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + (lin: 6, ang: 12) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def cross_sca(s: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = (0 ; ω×τ).

    (6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def constraint_ctx(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def constraint_cty(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def constraint_ctz(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def constraint_crx(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def constraint_cry(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def constraint_crz(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def working_ctx(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    15 mul, 24 add, 3 product error, 6 product rest.  Error <= u |result| + (lin: 0, ang: 11)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def working_cty(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    15 mul, 24 add, 3 product error, 6 product rest.  Error <= u |result| + (lin: 0, ang: 11)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def working_ctz(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    15 mul, 24 add, 3 product error, 6 product rest.  Error <= u |result| + (lin: 0, ang: 11)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def working_crx(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def working_cry(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def working_crz(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def quaternion_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (4),()->(4).  self: quaternion (x, y, z, w), the scalar last; a: number.
    4 mul, 4 add, 4 product error.  Error <= u |result|, barring over- and underflow.
    """

def axpy_qq(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = a x + y.

    (),(4),(4)->(4).  a: number; x, y: quaternion (x, y, z, w), the scalar last.
    4 mul, 24 add, 4 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_norm(q: ArrayLike, out: _Out = ...) -> _Array:
    """|q| = sqrt(v·v + w^2).

    (4)->().  q: quaternion (x, y, z, w), the scalar last; norm: number.
    12 mul, 35 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def quaternion_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|; zero stays zero.

    (4)->(4).  self: quaternion (x, y, z, w), the scalar last.
    33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def quaternion_normalized(q: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q / |q|; zero stays zero.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def quaternion_unit_defect(q: ArrayLike, out: _Out = ...) -> _Array:
    """|q| - 1: 0 for a unit quaternion, negative for a shorter one.

    (4)->().  q: quaternion (x, y, z, w), the scalar last; defect: number.
    12 mul, 42 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def quaternion_nearest_unit(q: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    17 mul, 54 add, 5 product error, 4 product rest, 9 div, 1 sqrt, 4 abs, 6 less, 6 equal, 21
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def rotate_qv(q: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R(q) v, |q| = 1.

    (4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
    30 mul, 75 add, 15 product rest.  Error <= u |result| + 34 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def rotate_qconjv(q: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R(q)^T v, |q| = 1.

    (4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
    30 mul, 75 add, 15 product rest.  Error <= u |result| + 34 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qq(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1i q2i.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 68 add, 16 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qqconj(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1i q2i*.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 68 add, 16 product rest.  Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjq(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1i* q2i.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 68 add, 16 product rest.  Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjqconj(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1i* q2i*.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 68 add, 16 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qxq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qxqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qxconjq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qxconjqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qqx(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qqxconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjqx(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjqxconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qyq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qyqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qyconjq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qyconjqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qqy(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qqyconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjqy(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjqyconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qzq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qzqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qzconjq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qzconjqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qqz(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qqzconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjqz(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjqzconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qv(qi: ArrayLike, vi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (vi; 0).

    (4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
    12 mul, 44 add, 12 product rest, 2 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjv(qi: ArrayLike, vi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (vi; 0).

    (4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
    12 mul, 44 add, 12 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def quaternion_product_vq(vi: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (vi; 0) qi.

    (3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
    12 mul, 44 add, 12 product rest, 2 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def quaternion_product_vqconj(vi: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (vi; 0) qi*.

    (3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
    12 mul, 44 add, 12 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def dot_qq(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """q1i·q2i.

    (4),(4)->().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot: number.
    4 mul, 17 add, 4 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def add_dpiToq(dpi: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
    first order; not normalized.

    (3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
    15 mul, 72 add, 12 product rest.  Error <= u |result| + 15 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def subtract_dpiFromq(dpi: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.

    (3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
    15 mul, 72 add, 12 product rest.  Error <= u |result| + 15 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def omega_to_dquaternion(w: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
    reference frame, rad/s, and a term that draws its norm to 1.

    (3),(4)->(4).  w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
    27 mul, 101 add, 20 product rest.  Error <= u |result| + (v: 35, w: 32) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """

def mat3x3_from_quaternion(q: ArrayLike, out: _Out = ...) -> _Array:
    """R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.

    (4)->(3,3).  q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
    41 mul, 116 add, 10 product error, 24 product rest, 2 div, 9 equal, 9 select.  Error <= R: 1
    u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 < |q| < 2^63;
    searched, not proved.  Each component is within 1 ulp as long as its condition is below
    1e13; in single precision it is the nearest number, except near ties, as long as that is
    below 1e5; searched, not proved.
    """

def quaternion_from_mat3x3(R: ArrayLike, out: _Out = ...) -> _Array:
    """qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.

    (3,3)->(4).  R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
    21 mul, 182 add, 5 product error, 4 product rest, 9 div, 1 sqrt, 9 neg, 4 less, 5 equal, 37
    select.  Error <= qo: 1 u of its largest component for R a rotation; searched, not proved.
    Each component is within 1 ulp as long as its condition is below 1e13; in single precision
    it is the nearest number, except near ties, as long as that is below 1e5; searched, not
    proved.
    """

def quaternion_from_axis_angle(axis: ArrayLike, angle: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
    rotation is by another angle.

    (3),()->(4).  axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
    90 mul, 134 add, 14 product error, 1 div, 3 abs, 1 less, 4 equal, 5 select.  Error <= qo: 1
    u of its largest component for |axis| = 1; searched, not proved.  Each component is within 1
    ulp as long as its condition is below 1e13; in single precision it is the nearest number,
    except near ties, as long as that is below 1e5; searched, not proved.
    """

def axis_angle_from_quaternion(q: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
    angle is 0; any multiple of a quaternion.

    (4)->(),(3).  q: quaternion (x, y, z, w), the scalar last; angle: number; axis: vector.
    149 mul, 268 add, 25 product error, 3 product rest, 13 div, 1 sqrt, 5 neg, 17 abs, 4
    copysign, 27 less, 10 equal, 51 select.  Error <= angle: 1 u, axis: 1 u of its largest
    component; searched, not proved.  Each component is within 1 ulp as long as its condition is
    below 1e13; in single precision it is the nearest number, except near ties, as long as that
    is below 1e5; searched, not proved.
    """

def quaternion_exp(v: ArrayLike, out: _Out = ...) -> _Array:
    """qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.

    (3)->(4).  v: vector; qo: quaternion (x, y, z, w), the scalar last.
    145 mul, 231 add, 17 product error, 4 product rest, 5 div, 1 sqrt, 7 abs, 6 less, 5 equal,
    14 select.  Error <= qo: 1 u of its largest component for |v| <= 1e13, in single precision
    1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below
    1e13; in single precision it is the nearest number, except near ties, as long as that is
    below 1e5; searched, not proved.
    """

def quaternion_log(q: ArrayLike, out: _Out = ...) -> _Array:
    """vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of
    it.

    (4)->(3).  q: quaternion (x, y, z, w), the scalar last; vo: vector.
    151 mul, 271 add, 26 product error, 3 product rest, 9 div, 1 sqrt, 5 neg, 17 abs, 4
    copysign, 27 less, 9 equal, 48 select.  Error <= vo: 1 u of its largest component; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def quaternion_interpolated(q1: ArrayLike, q2: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.

    (4),(4),()->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
    371 mul, 774 add, 46 product error, 39 product rest, 16 div, 2 sqrt, 14 neg, 21 abs, 4
    copysign, 36 less, 11 equal, 68 select.  Error <= qo: 1 u of its largest component for |q1|
    = 1 and |q2| = 1 and 0 <= k <= 1; searched, not proved.  Each component is within 1 ulp as
    long as its condition is below 1e13; in single precision it is the nearest number, except
    near ties, as long as that is below 1e5; searched, not proved.
    """

def SO3_exp(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    178 mul, 320 add, 17 product error, 22 product rest, 5 div, 1 sqrt, 7 abs, 6 less, 10 equal,
    19 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision
    1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below
    1e13; in single precision it is the nearest number, except near ties, as long as that is
    below 1e5; searched, not proved.
    """

def SO3_log(R: ArrayLike, out: _Out = ...) -> _Array:
    """vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.

    (3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.
    162 mul, 433 add, 26 product error, 3 product rest, 10 div, 1 sqrt, 13 neg, 13 abs, 4
    copysign, 29 less, 9 equal, 77 select.  Error <= vo: 1 u of its largest component for R a
    rotation; searched, not proved.  Each component is within 1 ulp as long as its condition is
    below 1e13; in single precision it is the nearest number, except near ties, as long as that
    is below 1e5; searched, not proved.
    """

def SO3_leftJacobian(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 10 equal,
    25 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision
    1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below
    1e13; in single precision it is the nearest number, except near ties, as long as that is
    below 1e5; searched, not proved.
    """

def SO3_rightJacobian(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 9 neg, 4 abs, 6 less, 10
    equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single
    precision 1e5; searched, not proved.  Each component is within 1 ulp as long as its
    condition is below 1e13; in single precision it is the nearest number, except near ties, as
    long as that is below 1e5; searched, not proved.
    """

def SO3_leftJacobianInverse(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less,
    10 equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= π; searched, not
    proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def SO3_rightJacobianInverse(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 4 abs, 6 less, 10
    equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= π; searched, not
    proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """

def mat3x3_from_axis_angle(axis: ArrayLike, angle: ArrayLike, out: _Out = ...) -> _Array:
    """R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
    not a rotation.

    (3),()->(3,3).  axis: vector; angle: number; R: rotation or other 3×3 matrix.
    196 mul, 351 add, 26 product error, 18 product rest, 2 div, 6 abs, 3 less, 9 equal, 13
    select.  Error <= R: 1 u of its largest component for |axis| = 1; searched, not proved.
    Each component is within 1 ulp as long as its condition is below 1e13; in single precision
    it is the nearest number, except near ties, as long as that is below 1e5; searched, not
    proved.
    """

def axis_angle_from_mat3x3(R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.

    (3,3)->(),(3).  R: rotation or other 3×3 matrix; angle: number; axis: vector.
    157 mul, 448 add, 25 product error, 3 product rest, 14 div, 1 sqrt, 13 neg, 13 abs, 4
    copysign, 29 less, 10 equal, 80 select.  Error <= angle: 1 u, axis: 1 u of its largest
    component for R a rotation; searched, not proved.  Each component is within 1 ulp as long as
    its condition is below 1e13; in single precision it is the nearest number, except near ties,
    as long as that is below 1e5; searched, not proved.
    """

def mat3x3_orthonormalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def mat3x3_orthonormalized(R: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """

def SE3_exp(s: ArrayLike, out: _Out = ...) -> _Array:
    """D = exp s = [exp ω~ | J_l(ω) v].

    (6)->(3,4).  s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
    246 mul, 553 add, 24 product error, 58 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 13 equal,
    28 select.  Error <= R: 1 u, t: 1 u of its largest component, or of s.lin if that is larger,
    for |ω of s| <= 1e13, in single precision 1e5; searched, not proved.  Each component is
    within 1 ulp as long as its condition is below 1e13; in single precision it is the nearest
    number, except near ties, as long as that is below 1e5; searched, not proved.  Intermediate
    sums may overflow where |v|, or |ω| |v|, is above 2e306, in single precision 5e36.
    """

def SE3_log(D: ArrayLike, out: _Out = ...) -> _Array:
    """so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    285 mul, 748 add, 36 product error, 36 product rest, 23 div, 2 sqrt, 12 neg, 14 abs, 4
    copysign, 32 less, 13 equal, 88 select.  Error <= lin: 1 u, ang: 1 u of its largest
    component for R of D a rotation; searched, not proved.  Each component is within 1 ulp as
    long as its condition is below 1e13; in single precision it is the nearest number, except
    near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may
    overflow where |t| is above 2e306, in single precision 5e36.
    """

def SE3_leftJacobian(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = J_l(s) = Σ ([ad](s))^k / (k+1)!.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less,
    19 equal, 38 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single
    precision 5e36.
    """

def SE3_rightJacobian(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 36 neg, 4 abs, 6 less,
    19 equal, 38 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single
    precision 5e36.
    """

def SE3_leftJacobianInverse(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 9 neg, 4 abs, 6 less,
    19 equal, 36 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single
    precision 5e36.
    """

def SE3_rightJacobianInverse(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 21 neg, 4 abs, 6 less,
    19 equal, 36 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single
    precision 5e36.
    """

def SE3_interpolated(D1: ArrayLike, D2: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.

    (3,4),(3,4),()->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
    717 mul, 1706 add, 66 product error, 166 product rest, 29 div, 3 sqrt, 13 neg, 18 abs, 4
    copysign, 38 less, 20 equal, 110 select.  Error <= R: 1 u, t: 1 u of its largest component,
    or of D1.t or D2.t if that is larger, for R of D1 a rotation and R of D2 a rotation and 0 <=
    k <= 1; searched, not proved.  Each component is within 1 ulp as long as its condition is
    below 1e13; in single precision it is the nearest number, except near ties, as long as that
    is below 1e5; searched, not proved.  Intermediate sums may overflow where |t| of D1 or D2 is
    above 2e306, in single precision 5e36.
    """

def mat3x3_ldl(A: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
    triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
    not positive definite, and L is meaningless.

    (3,3)->(),(3,3).  A, L: rotation or other 3×3 matrix; pivot: number.
    16 mul, 96 add, 6 product error, 4 product rest, 12 div, 6 less, 6 equal, 21 select.  |L D
    L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and underflow.
    """

def mat3x3_ldl_solve(L: ArrayLike, b: ArrayLike, out: _Out = ...) -> _Array:
    """x = A^-1 b, L of mat3x3_ldl with a positive pivot.

    (3,3),(3)->(3).  L: rotation or other 3×3 matrix; b, x: vector.
    13 mul, 61 add, 3 product error, 6 product rest, 6 div, 3 equal, 3 select.  Backward error,
    of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved; barring
    over- and underflow.
    """

def mat3x3_solve(A: ArrayLike, b: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
    Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
    rounding or indefinite (A - 50 u diag A is not positive definite).

    (3,3),(3)->(),(3).  A: rotation or other 3×3 matrix; b, x: vector; pivot: number.
    96 mul, 398 add, 16 product error, 31 product rest, 30 div, 11 less, 5 equal, 38 select.
    Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
    barring over- and underflow.
    """

def mat6x6_ldl(A: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
    triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
    not positive definite, and L is meaningless.

    (6,6)->(),(6,6).  A, L: 6×6 operator; pivot: number.
    121 mul, 512 add, 21 product error, 35 product rest, 42 div, 15 less, 21 equal, 57 select.
    |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
    underflow.
    """

def mat6x6_ldl_solve(L: ArrayLike, b: ArrayLike, out: _Out = ...) -> _Array:
    """x = A^-1 b, L of mat6x6_ldl with a positive pivot.

    (6,6),(6)->(6).  L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in
    rad/s).
    61 mul, 253 add, 6 product error, 30 product rest, 12 div, 6 equal, 6 select.  Backward
    error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
    barring over- and underflow.
    """

def mat6x6_solve(A: ArrayLike, b: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
    Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
    rounding or indefinite (A - 50 u diag A is not positive definite).

    (6,6),(6)->(),(6).  A: 6×6 operator; b: coscrew (f in N; τ in N m); pivot: number; x: screw
    (v in m/s; ω in rad/s).
    516 mul, 1806 add, 49 product error, 171 product rest, 96 div, 23 less, 8 equal, 77 select.
    Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
    barring over- and underflow.
    """

def inertia(m: ArrayLike, t: ArrayLike, Ixx: ArrayLike, Iyy: ArrayLike, Izz: ArrayLike, Ixy: ArrayLike, Iyz: ArrayLike, Izx: ArrayLike, out: _Out = ...) -> _Array:
    """J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
    moments' matrix about it in kg m^2, Ixy = -∫ x y dm.

    (),(3),(),(),(),(),(),()->(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J:
    inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in
    kg m^2).
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """

def inertia_rotated(Ji: ArrayLike, R: ArrayLike, out: _Out = ...) -> _Array:
    """Jo = Ji rotated by R: m, R mt, R I R^T.

    (10),(3,3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    72 mul, 207 add, 54 product rest.  Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def inertia_rotate(self: ArrayLike, R: ArrayLike, out: _Out = ...) -> _Array:
    """self = self rotated by R: m, R mt, R I R^T.

    (10),(3,3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    72 mul, 207 add, 54 product rest.  Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def inertia_translated(Ji: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """Jo = Ji translated by t: m, mt + m t, I.

    (10),(3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); t: vector.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def inertia_translate(self: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """self = self translated by t: m, mt + m t, I.

    (10),(3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx,
    yy, zz, xy, yz, zx in kg m^2); t: vector.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def inertia_transformed(Ji: ArrayLike, D: ArrayLike, out: _Out = ...) -> _Array:
    """Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.

    (10),(3,4)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
    75 mul, 225 add, 57 product rest.  Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def inertia_transform(self: ArrayLike, D: ArrayLike, out: _Out = ...) -> _Array:
    """self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.

    (10),(3,4)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
    75 mul, 225 add, 57 product rest.  Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def inertia_merge(Ji: ArrayLike, t_ic: ArrayLike, Jj: ArrayLike, t_jc: ArrayLike, D_ij: ArrayLike, out: _Out = ...) -> _Array:
    """Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j,
    mt_i + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d =
    c - t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own
    frame; NaN where m_i + m_j = 0.

    (10),(3),(10),(3),(3,4)->(10).  Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement
    [R | t], R rotation, t in m.
    109 mul, 401 add, 5 product error, 66 product rest, 2 div, 10 equal, 10 select.  Error <= 18
    u times the sum of the absolute values of all terms, for masses that are not negative,
    barring over- and underflow.
    """

def spatial_inertia_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (10),()->(10).  self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); a: number.
    10 mul, 10 add, 10 product error.  Error <= u |result|, barring over- and underflow.
    """

def add_BB(B1: ArrayLike, B2: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = B1 + B2.

    (10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2).
    70 add.  Error <= u |result|, barring over- and underflow.
    """

def subtract_BB(B1: ArrayLike, B2: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = B1 - B2.

    (10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2).
    70 add.  Error <= u |result|, barring over- and underflow.
    """

def spatial_inertia_from_com(m: ArrayLike, com: ArrayLike, Ic: ArrayLike, out: _Out = ...) -> _Array:
    """Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle
    is read): h = m com, I = Ic - m com~ com~.

    (),(3),(3,3)->(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial
    inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    15 mul, 66 add, 3 product error, 9 product rest.  Error <= u |result| + (m: 0, h: 0, I: 15)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def spatial_inertia_from_inertia(J: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of
    mass; NaN where m = 0.

    (10)->(10).  J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
    zz, xy, yz, zx in kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the
    origin, xx, yy, zz, xy, xz, yz in kg m^2).
    15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.  Error of a
    moment <= 4 u times the sum of its |terms|, barring over- and underflow.
    """

def inertia_from_spatial_inertia(B: ArrayLike, out: _Out = ...) -> _Array:
    """Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of
    mass; NaN where m = 0.

    (10)->(10).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2).
    15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.  Error of a
    moment <= 4 u times the sum of its |terms|, barring over- and underflow.
    """

def spatial_inertia_com(B: ArrayLike, out: _Out = ...) -> _Array:
    """vo = h / m, the centre of mass in m.

    (10)->(3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); vo: vector.
    3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select.  Error <= u |result|, barring over-
    and underflow.
    """

def spatial_inertia_about_com(B: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = I + h~ h~ / m, the second moments about the centre of mass.

    (10)->(3,3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Ro: rotation or other 3×3 matrix.
    15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.
    """

def product_Bs(B: ArrayLike, s: ArrayLike, out: _Out = ...) -> _Array:
    """co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.

    (10),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
    24 mul, 102 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 19) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """

def spatial_inertia_energy(B: ArrayLike, s: ArrayLike, out: _Out = ...) -> _Array:
    """s·B s / 2, the kinetic energy in J of a body that moves with s.

    (10),(6)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy: number.
    34 mul, 142 add, 25 product rest.  Error <= u |result| + 44 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def spatial_inertia_net_wrench(B: ArrayLike, w: ArrayLike, ds: ArrayLike, out: _Out = ...) -> _Array:
    """co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
    velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
    a is less gravity's, so is the wrench.

    (10),(3),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,
    yy, zz, xy, xz, yz in kg m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f
    in N; τ in N m).
    63 mul, 324 add, 3 product error, 51 product rest, 6 neg.  Error <= u |result| + (lin: 36,
    ang: 42) u^2 S, S the sum of the |terms| of the expanded formula; barring over- and
    underflow.
    """

def spatial_inertia_shifted(t: ArrayLike, B: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.

    (3),(10)->(10).  t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the
    origin, xx, yy, zz, xy, xz, yz in kg m^2).
    33 mul, 138 add, 6 product error, 6 product rest.  Error <= u |result| + (m: 0, h: 2, I: 20)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def spatial_inertia_transformed(D: ArrayLike, B: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.

    (3,4),(10)->(10).  D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in
    kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    105 mul, 420 add, 6 product error, 60 product rest.  Error <= u |result| + (m: 0, h: 16, I:
    35) u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """

def spatial_inertia_consistency(B: ArrayLike, out: _Out = ...) -> _Array:
    """the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:
    positive exactly if a body of positive density has this inertia.

    (10)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,
    xz, yz in kg m^2); pivot: number.
    42 mul, 258 add, 10 product error, 10 product rest, 20 div, 6 neg, 9 less, 1 equal, 26
    select.
    """
