# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
from collections.abc import Callable
from types import ModuleType
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

_Array = NDArray[np.floating]
_Out = _Array | None

from coscrew import double as double, single as single

COMPILED: bool
__version__: str
Result = TypeVar("Result")

def arrays(xp: ModuleType) -> Any: ...

def unchecked(function: Callable[..., Result]) -> Callable[..., Result]: ...


def selfcheck() -> list[str]: ...

def get_include() -> str: ...

def mat3x3_is_rotation(R: ArrayLike) -> np.bool | NDArray[np.bool]: ...

def quaternion_is_unit(q: ArrayLike) -> np.bool | NDArray[np.bool]: ...

def sincos(x: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """s = sin x, c = cos x, x in rad.

    ()->(),().  x, s, c: number.
    28 mul, 33 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
    subnormal; proved.
    """

def sin(x: ArrayLike, out: _Out = ...) -> _Array:
    """s = sin x, x in rad.

    ()->().  x, s: number.
    28 mul, 33 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
    subnormal; proved.
    """

def cos(x: ArrayLike, out: _Out = ...) -> _Array:
    """c = cos x, x in rad.

    ()->().  x, c: number.
    28 mul, 33 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
    subnormal; proved.
    """

def exp(x: ArrayLike, out: _Out = ...) -> _Array:
    """y = e^x.

    ()->().  x, y: number.
    19 mul, 20 add, 1 power of two, 3 less, 4 select.  Error <= 0.755 ulp, in single precision
    0.757 ulp, unless a result is subnormal; proved.
    """

def tanh(x: ArrayLike, out: _Out = ...) -> _Array:
    """y = tanh x.

    ()->().  x, y: number.
    29 mul, 30 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select.  Error <= 0.979
    ulp, in single precision 0.967 ulp, unless a result is subnormal; proved.
    """

def atan2(y: ArrayLike, x: ArrayLike, out: _Out = ...) -> _Array:
    """angle of the vector (x, y) to the x axis, in rad, from -π to π.

    (),()->().  y, x, angle: number.
    29 mul, 35 add, 1 div, 1 neg, 2 abs, 2 copysign, 6 less, 1 equal, 14 select.  Error <= 0.934
    ulp, in single precision 0.896 ulp, unless a result is subnormal; proved.
    """

def vec3_copy(vi: ArrayLike, out: _Out = ...) -> _Array:
    """vo = vi.

    (3)->(3).  vi, vo: vector.
    No arithmetic.  Exact.
    """

def vec3_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (3),()->(3).  self: vector; a: number.
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def vec3_inverted(vi: ArrayLike, out: _Out = ...) -> _Array:
    """vo = -vi.

    (3)->(3).  vi, vo: vector.
    3 neg.  Exact.
    """

def vec3_invert(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = -self.

    (3)->(3).  self: vector.
    3 neg.  Exact.
    """

def axpy_vv(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = a x + y.

    (),(3),(3)->(3).  a: number; x, y: vector.
    3 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def xpy_vv(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = x + y.

    (3),(3)->(3).  x, y: vector.
    3 add.  Error <= u |result|, barring over- and underflow.
    """

def nxpy_vv(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = -x + y.

    (3),(3)->(3).  x, y: vector.
    3 add.  Error <= u |result|, barring over- and underflow.
    """

def product_av(a: ArrayLike, vi: ArrayLike, out: _Out = ...) -> _Array:
    """vo = a vi.

    (),(3)->(3).  a: number; vi, vo: vector.
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def add_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v1 + v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    3 add.  Error <= u |result|, barring over- and underflow.
    """

def subtract_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v1 - v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    3 add.  Error <= u |result|, barring over- and underflow.
    """

def vec3_scaled(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = k v.

    (3),()->(3).  v, vo: vector; k: number.
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def vec3_swap(v1: ArrayLike, v2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """v1, v2 = v2, v1.

    (3),(3)->(3),(3).  v1, v2: vector.
    No arithmetic.  Exact.
    """

def vec3_l2norm(v: ArrayLike, out: _Out = ...) -> _Array:
    """|v| = sqrt(v·v).

    (3)->().  v: vector; norm: number.
    7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select.
    """

def vec3_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|; the zero vector stays zero.

    (3)->(3).  self: vector.
    12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select.
    """

def vec3_normalized(v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v / |v|; the zero vector stays zero.

    (3)->(3).  v, vo: vector.
    12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select.
    """

def angle_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """angle = atan2(|v1 × v2|, v1·v2), in [0, π].

    (3),(3)->().  v1, v2: vector; angle: number.
    51 mul, 42 add, 1 div, 1 sqrt, 1 neg, 11 abs, 2 copysign, 24 less, 1 equal, 32 select.
    """

def dot_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """v1·v2.

    (3),(3)->().  v1, v2: vector; dot: number.
    3 mul, 2 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_avinv(k: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = k (-v).

    (),(3)->(3).  k: number; v, vo: vector.
    3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.
    """

def product_ainvv(k: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v / k.

    (),(3)->(3).  k: number; v, vo: vector.
    3 div.
    """

def cross_vv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def cross_vvinv(v1: ArrayLike, v2: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v1 × (-v2).

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def add_vvx(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v + k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvxinv(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v - k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvy(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v + k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvyinv(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v - k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvz(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v + k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """

def add_vvzinv(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v - k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """

def vec4_copy(vi: ArrayLike, out: _Out = ...) -> _Array:
    """vo = vi.

    (4)->(4).  vi, vo: vector (x, y, z) and a homogeneous coordinate w.
    No arithmetic.  Exact.
    """

def vec4_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (4),()->(4).  self: vector (x, y, z) and a homogeneous coordinate w; a: number.
    4 mul.  Error <= u |result|, barring over- and underflow.
    """

def vec4_inverted(vi: ArrayLike, out: _Out = ...) -> _Array:
    """vo = -vi.

    (4)->(4).  vi, vo: vector (x, y, z) and a homogeneous coordinate w.
    4 neg.  Exact.
    """

def vec4_invert(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = -self.

    (4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.
    4 neg.  Exact.
    """

def vec4_scaled(v: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = k v.

    (4),()->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
    4 mul.  Error <= u |result|, barring over- and underflow.
    """

def vec4_swap(v1: ArrayLike, v2: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """v1, v2 = v2, v1.

    (4),(4)->(4),(4).  v1, v2: vector (x, y, z) and a homogeneous coordinate w.
    No arithmetic.  Exact.
    """

def vec4_l2norm(v: ArrayLike, out: _Out = ...) -> _Array:
    """|v| = sqrt(v·v), all four components.

    (4)->().  v: vector (x, y, z) and a homogeneous coordinate w; norm: number.
    9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.
    """

def vec4_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|; the zero vector stays zero.

    (4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.
    16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
    """

def vec4_normalized(v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = v / |v|; the zero vector stays zero.

    (4)->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w.
    16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
    """

def mat3x3_copy(R: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """

def mat3x3_setIdentity(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = I.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """

def mat3x3_setFromVectors(x: ArrayLike, y: ArrayLike, z: ArrayLike, out: _Out = ...) -> _Array:
    """R = [x y z], the columns.

    (3),(3),(3)->(3,3).  x, y, z: vector; R: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """

def skew(v: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = v~, the matrix with v~ y = v × y.

    (3)->(3,3).  v: vector; Ro: rotation or other 3×3 matrix.
    3 neg.  Exact.
    """

def acceleration_tensor(w: ArrayLike, dw: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
    acceleration of its point x, less that of its origin, is Ro x.

    (3),(3)->(3,3).  w, dw: vector; Ro: rotation or other 3×3 matrix.
    6 mul, 9 add, 3 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def mat3x3_transpose(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self^T, the inverse of a rotation.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """

def mat3x3_transposed(R: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R^T, the inverse of a rotation.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """

def mat3x3_determinant(R: ArrayLike, out: _Out = ...) -> _Array:
    """det R.

    (3,3)->().  R: rotation or other 3×3 matrix; det: number.
    9 mul, 5 add.  Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def mat3x3_inverse(R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or
    overflows.  Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3
    (double 1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.

    (3,3)->(),(3,3).  R, Ro: rotation or other 3×3 matrix; det: number.
    56 mul, 17 add, 9 div, 1 neg, 19 abs, 16 less, 1 equal, 32 select.  Error of Ro_ij <= 2 u
    m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the sum of the |terms| of the cofactor, or
    2^-80 m^2 (double 2^-700 m^2) if that is more; barring over- and underflow of Ro_ij itself.
    """

def mat3x3_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
    its side of the first, the third on its side of both; NaN where the rows are linearly
    dependent to rounding.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.  |R R^T - I|_ij
    <= 8 u for the result R; searched, not proved.
    """

def mat3x3_normalized(R: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
    its side of the first, the third on its side of both; NaN where the rows are linearly
    dependent to rounding.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.  |R R^T - I|_ij
    <= 8 u for the result R; searched, not proved.
    """

def mat3x3_setFromAxisDC(axis: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
    dc = (sin θ, cos θ).

    (3),(2)->(3,3).  axis: vector; dc: (sin θ, cos θ); R: rotation or other 3×3 matrix.
    12 mul, 10 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def mat3x3_from_euler_xyz(angles: ArrayLike, out: _Out = ...) -> _Array:
    """R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).

    (3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.
    98 mul, 103 add, 3 neg, 3 abs.
    """

def euler_xyz_from_mat3x3(R: ArrayLike, out: _Out = ...) -> _Array:
    """angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
    [-π/2, π/2]; c = 0 in gimbal lock.

    (3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.
    93 mul, 109 add, 5 div, 1 sqrt, 4 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.  The
    rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock too;
    searched, not proved.
    """

def mat3x3_from_euler_xyx(angles: ArrayLike, out: _Out = ...) -> _Array:
    """R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).

    (3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.
    98 mul, 103 add, 2 neg, 3 abs.
    """

def euler_xyx_from_mat3x3(R: ArrayLike, out: _Out = ...) -> _Array:
    """angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in
    [0, π]; c = 0 in gimbal lock.

    (3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.
    93 mul, 109 add, 5 div, 1 sqrt, 3 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.  The
    rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock too;
    searched, not proved.
    """

def mat3x3_jacobi(A: ArrayLike, V: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes
    A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.
    Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.

    (3,3),(3,3)->(3,3),(3,3).  A, V: rotation or other 3×3 matrix.
    21 mul, 14 add, 3 div, 2 sqrt, 1 neg, 1 abs, 1 less, 1 equal, 3 select.  V A V^T changes by
    at most 28 u max |A| for orthonormal V; searched, not proved.
    """

def mat3x3_rotation_defect(R: ArrayLike, out: _Out = ...) -> _Array:
    """the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if
    an entry is NaN.

    (3,3)->().  R: rotation or other 3×3 matrix; defect: number.
    27 mul, 21 add, 7 abs, 6 less, 6 select.  Error <= 6 u near a rotation; measured, not
    proved.
    """

def mat3x3_nearest_rotation(A: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = the rotation nearest to A, U diag(1, 1, ±1) V^T of A = U diag(s1, s2, s3) V^T: no
    rotation R has a larger tr R^T A or a smaller |R - A|.  For every finite A but 0, for which
    it is NaN; where several are equally near (s2 ± s3 = 0: reflections with s2 = s3, matrices
    of rank 1) one of them.

    (3,3)->(3,3).  A, Ro: rotation or other 3×3 matrix.
    649 mul, 400 add, 51 div, 32 sqrt, 37 neg, 42 abs, 60 less, 34 equal, 169 select.  |Ro -
    nearest|_F <= 16 u s1 / (s2 ± s3), + if det A > 0, and |Ro^T Ro - I|_ij <= 6 u; measured,
    not proved.
    """

def SE3_fromRt(R: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """D = [R | t].

    (3,3),(3)->(3,4).  R: rotation or other 3×3 matrix; t: vector; D: displacement [R | t], R
    rotation, t in m.
    No arithmetic.  Exact.
    """

def SE3_copy(D: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D.

    (3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.
    No arithmetic.  Exact.
    """

def SE3_setIdentity(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = [I | 0].

    (3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.
    No arithmetic.  Exact.
    """

def SE3_getTranslation(D: ArrayLike, out: _Out = ...) -> _Array:
    """t of D = [R | t].

    (3,4)->(3).  D: displacement [R | t], R rotation, t in m; t: vector.
    No arithmetic.  Exact.
    """

def SE3_getRotation(D: ArrayLike, out: _Out = ...) -> _Array:
    """R of D = [R | t].

    (3,4)->(3,3).  D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """

def SE3_invert(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.
    9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def SE3_toMat4x4(D: ArrayLike, out: _Out = ...) -> _Array:
    """M = [[R, t], [0, 1]] of D = [R | t].

    (3,4)->(4,4).  D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.
    No arithmetic.  Exact.
    """

def SE3_inverted(D: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.
    9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def mat4x4_fromSE3(D: ArrayLike, out: _Out = ...) -> _Array:
    """M = [[R, t], [0, 1]] of D = [R | t].

    (3,4)->(4,4).  D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.
    No arithmetic.  Exact.
    """

def mat4x4_fromRt(R: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """M = [[R, t], [0, 1]].

    (3,3),(3)->(4,4).  R: rotation or other 3×3 matrix; t: vector; M: 4×4 matrix.
    No arithmetic.  Exact.
    """

def mat4x4_toSE3(M: ArrayLike, out: _Out = ...) -> _Array:
    """D = [R | t], the first three rows of M.

    (4,4)->(3,4).  M: 4×4 matrix; D: displacement [R | t], R rotation, t in m.
    No arithmetic.  Exact.
    """

def mat4x4_setIdentity(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = I.

    (4,4)->(4,4).  self: 4×4 matrix.
    No arithmetic.  Exact.
    """

def mat4x4_getTranslation(M: ArrayLike, out: _Out = ...) -> _Array:
    """t, the first three entries of the last column of M.

    (4,4)->(3).  M: 4×4 matrix; t: vector.
    No arithmetic.  Exact.
    """

def mat6x6_copy(M: ArrayLike, out: _Out = ...) -> _Array:
    """Mo = M.

    (6,6)->(6,6).  M, Mo: 6×6 operator.
    No arithmetic.  Exact.
    """

def mat6x6_setIdentity(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = I.

    (6,6)->(6,6).  self: 6×6 operator.
    No arithmetic.  Exact.
    """

def mat6x6_transposed(M: ArrayLike, out: _Out = ...) -> _Array:
    """Mo = M^T.

    (6,6)->(6,6).  M, Mo: 6×6 operator.
    No arithmetic.  Exact.
    """

def mat6x6_rotated(R: ArrayLike, M: ArrayLike, out: _Out = ...) -> _Array:
    """Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
    lower triangle is read.

    (3,3),(6,6)->(6,6).  R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
    144 mul, 96 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def mat6x6_shifted(t: ArrayLike, M: ArrayLike, out: _Out = ...) -> _Array:
    """Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
    lower triangle is read.

    (3),(6,6)->(6,6).  t: vector; M, Mo: 6×6 operator.
    39 mul, 42 add.  Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_drv(R: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R v.

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 6 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_drvinv(R: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (-v).

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 6 add, 3 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_drinvv(R: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R^T v.

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 6 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_drinvvinv(R: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R^T (-v).

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 6 add, 3 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_dv(D: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R v + t.

    (3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.
    9 mul, 9 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_dinvv(D: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R^T (v - t).

    (3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.
    9 mul, 9 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_drdr(R1: ArrayLike, R2: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R1 R2.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_drdrinv(R1: ArrayLike, R2: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R1 R2^T.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_drinvdr(R1: ArrayLike, R2: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R1^T R2.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_dd(D1: ArrayLike, D2: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D1 D2 = [R1 R2 | R1 t2 + t1].

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    36 mul, 27 add.  Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddinv(D1: ArrayLike, D2: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    36 mul, 27 add.  Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_dinvd(D1: ArrayLike, D2: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    36 mul, 27 add.  Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddr(D: ArrayLike, R: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R | 0].

    (3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other
    3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddrinv(D: ArrayLike, R: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R^T | 0].

    (3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other
    3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddt(D: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | t].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 9 add.  Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddtinv(D: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | -t].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 9 add.  Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_dinvdt(D: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 9 add.  Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_drvtx(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (k e_x).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def product_drdrx(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_x(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_ddrx(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddtx(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | k e_x].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_drvtxinv(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (-k e_x).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.
    """

def product_drdrxinv(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_x(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_ddrxinv(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddtxinv(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | -k e_x].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_drvty(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (k e_y).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def product_drdry(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_y(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_ddry(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddty(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | k e_y].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_drvtyinv(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (-k e_y).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.
    """

def product_drdryinv(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_y(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_ddryinv(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddtyinv(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | -k e_y].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_drvtz(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (k e_z).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def product_drdrz(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_z(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_ddrz(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddtz(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | k e_z].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_drvtzinv(R: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R (-k e_z).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.
    """

def product_drdrzinv(R: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R R_z(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_ddrzinv(D: ArrayLike, dc: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_ddtzinv(D: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D [I | -k e_z].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def dc(theta: ArrayLike, out: _Out = ...) -> _Array:
    """dc = (sin θ, cos θ), θ in rad.

    ()->(2).  theta: number; dc: (sin θ, cos θ).
    28 mul, 33 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
    subnormal; proved.
    """

def screw_copy(si: ArrayLike, out: _Out = ...) -> _Array:
    """so = si.

    (6)->(6).  si, so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """

def screw_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (6),()->(6).  self: screw (v in m/s; ω in rad/s); a: number.
    6 mul.  Error <= u |result|, barring over- and underflow.
    """

def screw_inverted(si: ArrayLike, out: _Out = ...) -> _Array:
    """so = -si.

    (6)->(6).  si, so: screw (v in m/s; ω in rad/s).
    6 neg.  Exact.
    """

def screw_invert(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = -self.

    (6)->(6).  self: screw (v in m/s; ω in rad/s).
    6 neg.  Exact.
    """

def axpy_ss(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = a x + y.

    (),(6),(6)->(6).  a: number; x, y: screw (v in m/s; ω in rad/s).
    6 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def xpy_ss(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = x + y.

    (6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).
    6 add.  Error <= u |result|, barring over- and underflow.
    """

def nxpy_ss(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = -x + y.

    (6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).
    6 add.  Error <= u |result|, barring over- and underflow.
    """

def product_as(a: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = a si.

    (),(6)->(6).  a: number; si, so: screw (v in m/s; ω in rad/s).
    6 mul.  Error <= u |result|, barring over- and underflow.
    """

def add_ss(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = s1 + s2.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    6 add.  Error <= u |result|, barring over- and underflow.
    """

def subtract_ss(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = s1 - s2.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    6 add.  Error <= u |result|, barring over- and underflow.
    """

def screw_norm(si: ArrayLike, out: _Out = ...) -> _Array:
    """|si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).

    (6)->().  si: screw (v in m/s; ω in rad/s); norm: number.
    7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select.
    """

def screw_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|, with screw_norm; the zero screw stays zero.

    (6)->(6).  self: screw (v in m/s; ω in rad/s).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """

def screw_normalized(si: ArrayLike, out: _Out = ...) -> _Array:
    """so = si / |si|, with screw_norm; the zero screw stays zero.

    (6)->(6).  si, so: screw (v in m/s; ω in rad/s).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """

def screw_from_lin_ang(lin: ArrayLike, ang: ArrayLike, out: _Out = ...) -> _Array:
    """so = (lin; ang).

    (3),(3)->(6).  lin, ang: vector; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """

def screw_to_angular_first(si: ArrayLike, out: _Out = ...) -> _Array:
    """x = (ang; lin) of si.

    (6)->(6).  si: screw (v in m/s; ω in rad/s); x: six components with the angular part on top.
    No arithmetic.  Exact.
    """

def screw_from_angular_first(x: ArrayLike, out: _Out = ...) -> _Array:
    """so = (lin; ang) of x = (ang; lin).

    (6)->(6).  x: six components with the angular part on top; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """

def add_sst(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = (s1.lin + s2.lin ; s1.ang).

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    3 add.  Error <= u |result|, barring over- and underflow.
    """

def product_Adts(t: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](t) si.

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 6 add.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_Adtinvs(t: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](t)^-1 si.

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 6 add.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_Adtsinv(t: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](t) (-si).

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_Adrs(R: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](R) si.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_Adrinvs(R: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](R)^-1 si.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_Adrsinv(R: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](R) (-si).

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 12 add, 6 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_Ads(D: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](D) si = [Ad](t) [Ad](R) si.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    24 mul, 18 add.  Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_Adinvs(D: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    24 mul, 18 add.  Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_Adsinv(D: ArrayLike, si: ArrayLike, out: _Out = ...) -> _Array:
    """so = [Ad](D) (-si).

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    24 mul, 18 add, 6 neg.  Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def hstx(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = h_tx: column 0 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """

def hsty(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = h_ty: column 1 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """

def hstz(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = h_tz: column 2 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """

def hsrx(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = h_rx: column 3 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def hsry(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = h_ry: column 4 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def hsrz(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = h_rz: column 5 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def hstxinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = -h_tx: -column 0 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    3 neg.  Exact.
    """

def hstyinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = -h_ty: -column 1 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    3 neg.  Exact.
    """

def hstzinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = -h_tz: -column 2 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    3 neg.  Exact.
    """

def hsrxinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = -h_rx: -column 3 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def hsryinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = -h_ry: -column 4 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def hsrzinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """so = -h_rz: -column 5 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def Ad(D: ArrayLike, out: _Out = ...) -> _Array:
    """M = [Ad](D).

    (3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
    18 mul, 9 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def dot_cs(c: ArrayLike, s: ArrayLike, out: _Out = ...) -> _Array:
    """power = f·v + τ·ω, in W.

    (6),(6)->().  c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power: number.
    6 mul, 5 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def cross_ss(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
    overflow.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    18 mul, 12 add.  Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def cross_sst(s1: ArrayLike, s2: ArrayLike, out: _Out = ...) -> _Array:
    """so = (ω1×v2 ; 0).

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def hsra(D: ArrayLike, axis: ArrayLike, out: _Out = ...) -> _Array:
    """so = (t×R a ; R a), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    15 mul, 9 add.  Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def hsta(D: ArrayLike, axis: ArrayLike, out: _Out = ...) -> _Array:
    """so = (R a ; 0), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    9 mul, 6 add.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def hsrainv(D: ArrayLike, axis: ArrayLike, out: _Out = ...) -> _Array:
    """so = -(t×R a ; R a), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    15 mul, 9 add, 3 neg.  Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def hstainv(D: ArrayLike, axis: ArrayLike, out: _Out = ...) -> _Array:
    """so = -(R a ; 0), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    9 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def ad(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]].

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    6 neg.  Exact.
    """

def coscrew_copy(ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = ci.

    (6)->(6).  ci, co: coscrew (f in N; τ in N m).
    No arithmetic.  Exact.
    """

def coscrew_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (6),()->(6).  self: coscrew (f in N; τ in N m); a: number.
    6 mul.  Error <= u |result|, barring over- and underflow.
    """

def coscrew_inverted(ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = -ci.

    (6)->(6).  ci, co: coscrew (f in N; τ in N m).
    6 neg.  Exact.
    """

def coscrew_invert(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = -self.

    (6)->(6).  self: coscrew (f in N; τ in N m).
    6 neg.  Exact.
    """

def axpy_cc(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = a x + y.

    (),(6),(6)->(6).  a: number; x, y: coscrew (f in N; τ in N m).
    6 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def xpy_cc(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = x + y.

    (6),(6)->(6).  x, y: coscrew (f in N; τ in N m).
    6 add.  Error <= u |result|, barring over- and underflow.
    """

def nxpy_cc(x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = -x + y.

    (6),(6)->(6).  x, y: coscrew (f in N; τ in N m).
    6 add.  Error <= u |result|, barring over- and underflow.
    """

def product_ac(a: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = a ci.

    (),(6)->(6).  a: number; ci, co: coscrew (f in N; τ in N m).
    6 mul.  Error <= u |result|, barring over- and underflow.
    """

def add_cc(c1: ArrayLike, c2: ArrayLike, out: _Out = ...) -> _Array:
    """co = c1 + c2.

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    6 add.  Error <= u |result|, barring over- and underflow.
    """

def subtract_cc(c1: ArrayLike, c2: ArrayLike, out: _Out = ...) -> _Array:
    """co = c1 - c2.

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    6 add.  Error <= u |result|, barring over- and underflow.
    """

def coscrew_norm(ci: ArrayLike, out: _Out = ...) -> _Array:
    """|ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).

    (6)->().  ci: coscrew (f in N; τ in N m); norm: number.
    7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select.
    """

def coscrew_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  self: coscrew (f in N; τ in N m).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """

def coscrew_normalized(ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  ci, co: coscrew (f in N; τ in N m).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """

def coscrew_from_lin_ang(lin: ArrayLike, ang: ArrayLike, out: _Out = ...) -> _Array:
    """co = (lin; ang).

    (3),(3)->(6).  lin, ang: vector; co: coscrew (f in N; τ in N m).
    No arithmetic.  Exact.
    """

def coscrew_to_angular_first(ci: ArrayLike, out: _Out = ...) -> _Array:
    """x = (ang; lin) of ci.

    (6)->(6).  ci: coscrew (f in N; τ in N m); x: six components with the angular part on top.
    No arithmetic.  Exact.
    """

def coscrew_from_angular_first(x: ArrayLike, out: _Out = ...) -> _Array:
    """co = (lin; ang) of x = (ang; lin).

    (6)->(6).  x: six components with the angular part on top; co: coscrew (f in N; τ in N m).
    No arithmetic.  Exact.
    """

def add_cct(c1: ArrayLike, c2: ArrayLike, out: _Out = ...) -> _Array:
    """co = (c1.lin + c2.lin ; c1.ang).

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    3 add.  Error <= u |result|, barring over- and underflow.
    """

def product_CoAdtc(t: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(t) ci.

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 6 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_CoAdtinvc(t: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(t)^-1 ci.

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 6 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_CoAdtcinv(t: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(t) (-ci).

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def product_CoAdrc(R: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(R) ci.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_CoAdrinvc(R: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(R)^-1 ci.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def product_CoAdrcinv(R: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(R) (-ci).

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 12 add, 6 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_CoAdc(D: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    24 mul, 18 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_CoAdinvc(D: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    24 mul, 18 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def product_CoAdcinv(D: ArrayLike, ci: ArrayLike, out: _Out = ...) -> _Array:
    """co = [Ad]*(D) (-ci).

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    24 mul, 18 add, 6 neg.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def hctx(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = h_tx: column 0 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def hcty(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = h_ty: column 1 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def hctz(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = h_tz: column 2 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def hcrx(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = h_rx: column 3 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    No arithmetic.  Exact.
    """

def hcry(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = h_ry: column 4 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    No arithmetic.  Exact.
    """

def hcrz(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = h_rz: column 5 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    No arithmetic.  Exact.
    """

def hctxinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = -h_tx: -column 0 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def hctyinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = -h_ty: -column 1 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def hctzinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = -h_tz: -column 2 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def hcrxinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = -h_rx: -column 3 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    3 neg.  Exact.
    """

def hcryinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = -h_ry: -column 4 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    3 neg.  Exact.
    """

def hcrzinv(D: ArrayLike, out: _Out = ...) -> _Array:
    """co = -h_rz: -column 5 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    3 neg.  Exact.
    """

def CoAd(D: ArrayLike, out: _Out = ...) -> _Array:
    """M = [Ad]*(D).

    (3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
    18 mul, 9 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def reciprocal_product(c: ArrayLike, x: ArrayLike, out: _Out = ...) -> _Array:
    """power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).

    (6),(6)->().  c: coscrew (f in N; τ in N m); x: six components with the angular part on top;
    power: number.
    6 mul, 5 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def cross_sc(s: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = [ad]*(s) c = (ω×f ; v×f + ω×τ).

    (6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
    18 mul, 12 add.  Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def cross_sca(s: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = (0 ; ω×τ).

    (6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
    6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def constraint_ctx(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def constraint_cty(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def constraint_ctz(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def constraint_crx(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def constraint_cry(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def constraint_crz(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def working_ctx(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    9 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def working_cty(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    9 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def working_ctz(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    9 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def working_crx(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def working_cry(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def working_crz(D: ArrayLike, c: ArrayLike, out: _Out = ...) -> _Array:
    """co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def coad(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]].

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    6 neg.  Exact.
    """

def quaternion_copy(qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi.

    (4)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last.
    No arithmetic.  Exact.
    """

def quaternion_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (4),()->(4).  self: quaternion (x, y, z, w), the scalar last; a: number.
    4 mul.  Error <= u |result|, barring over- and underflow.
    """

def axpy_qq(a: ArrayLike, x: ArrayLike, y: ArrayLike, out: _Out = ...) -> _Array:
    """y = a x + y.

    (),(4),(4)->(4).  a: number; x, y: quaternion (x, y, z, w), the scalar last.
    4 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_setIdentity(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = (0; 1).

    (4)->(4).  self: quaternion (x, y, z, w), the scalar last.
    No arithmetic.  Exact.
    """

def quaternion_conjugated(q: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (-v; w), the inverse of q if |q| = 1.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    3 neg.  Exact.
    """

def quaternion_norm(q: ArrayLike, out: _Out = ...) -> _Array:
    """|q| = sqrt(v·v + w^2).

    (4)->().  q: quaternion (x, y, z, w), the scalar last; norm: number.
    9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.
    """

def quaternion_normalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = self / |self|; zero stays zero.

    (4)->(4).  self: quaternion (x, y, z, w), the scalar last.
    16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
    """

def quaternion_normalized(q: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q / |q|; zero stays zero.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
    """

def quaternion_unit_defect(q: ArrayLike, out: _Out = ...) -> _Array:
    """|q| - 1: 0 for a unit quaternion, negative for a shorter one.

    (4)->().  q: quaternion (x, y, z, w), the scalar last; defect: number.
    9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select.
    """

def quaternion_nearest_unit(q: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 3 add, 4 div, 1 sqrt, 4 abs, 6 less, 1 equal, 11 select.
    """

def rotate_qv(q: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R(q) v, |q| = 1.

    (4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
    18 mul, 12 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def rotate_qconjv(q: ArrayLike, v: ArrayLike, out: _Out = ...) -> _Array:
    """vo = R(q)^T v, |q| = 1.

    (4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
    18 mul, 12 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qq(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1i q2i.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qqconj(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1i q2i*.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 12 add.  Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjq(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1i* q2i.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 12 add.  Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def quaternion_product_qconjqconj(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1i* q2i*.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qxq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qxqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qxconjq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qxconjqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qqx(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qqxconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qconjqx(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qconjqxconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qyq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qyqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qyconjq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qyconjqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qqy(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qqyconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qconjqy(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qconjqyconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qzq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qzqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qzconjq(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qzconjqconj(dci: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qqz(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qqzconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qconjqz(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qconjqzconj(qi: ArrayLike, dci: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qv(qi: ArrayLike, vi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi (vi; 0).

    (4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
    12 mul, 8 add, 1 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_qconjv(qi: ArrayLike, vi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = qi* (vi; 0).

    (4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
    12 mul, 8 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_vq(vi: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (vi; 0) qi.

    (3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
    12 mul, 8 add, 1 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def quaternion_product_vqconj(vi: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (vi; 0) qi*.

    (3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
    12 mul, 8 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def dot_qq(q1i: ArrayLike, q2i: ArrayLike, out: _Out = ...) -> _Array:
    """q1i·q2i.

    (4),(4)->().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot: number.
    4 mul, 3 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def add_dpiToq(dpi: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
    first order; not normalized.

    (3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
    15 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def subtract_dpiFromq(dpi: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.

    (3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
    15 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def omega_to_dquaternion(w: ArrayLike, qi: ArrayLike, out: _Out = ...) -> _Array:
    """dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
    reference frame, rad/s, and a term that draws its norm to 1.

    (3),(4)->(4).  w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
    23 mul, 16 add.  Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def mat3x3_from_quaternion(q: ArrayLike, out: _Out = ...) -> _Array:
    """R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.

    (4)->(3,3).  q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
    20 mul, 16 add, 1 div.  Error <= R: 8 u of its largest component for 2^-450 < |q| < 2^511,
    in single precision 2^-45 < |q| < 2^63; searched, not proved.
    """

def quaternion_from_mat3x3(R: ArrayLike, out: _Out = ...) -> _Array:
    """qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.

    (3,3)->(4).  R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
    4 mul, 17 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select.  Error <= qo: 6 u of its largest
    component for R a rotation; searched, not proved.
    """

def quaternion_from_axis_angle(axis: ArrayLike, angle: ArrayLike, out: _Out = ...) -> _Array:
    """qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
    rotation is by another angle.

    (3),()->(4).  axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
    32 mul, 33 add, 1 abs.  Error <= qo: 3 u of its largest component for |axis| = 1; searched,
    not proved.
    """

def axis_angle_from_quaternion(q: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
    angle is 0; any multiple of a quaternion.

    (4)->(),(3).  q: quaternion (x, y, z, w), the scalar last; angle: number; axis: vector.
    41 mul, 37 add, 4 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 32 select.  Error
    <= angle: 6 u, axis: 4 u of its largest component; searched, not proved.
    """

def quaternion_exp(v: ArrayLike, out: _Out = ...) -> _Array:
    """qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.

    (3)->(4).  v: vector; qo: quaternion (x, y, z, w), the scalar last.
    71 mul, 86 add, 2 div, 1 sqrt, 5 abs, 2 less, 6 select.  Error <= qo: (7 + θ/200) u of its
    largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.
    """

def quaternion_log(q: ArrayLike, out: _Out = ...) -> _Array:
    """vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of
    it.

    (4)->(3).  q: quaternion (x, y, z, w), the scalar last; vo: vector.
    44 mul, 37 add, 2 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 31 select.  Error
    <= vo: 6 u of its largest component; searched, not proved.
    """

def quaternion_interpolated(q1: ArrayLike, q2: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.

    (4),(4),()->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
    142 mul, 147 add, 4 div, 2 sqrt, 5 neg, 10 abs, 2 copysign, 17 less, 2 equal, 33 select.
    Error <= qo: 16 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1;
    searched, not proved.
    """

def SO3_exp(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    77 mul, 102 add, 3 div, 1 sqrt, 5 abs, 5 less, 11 select.  Error <= R: (6 + θ/200) u of its
    largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.
    """

def SO3_log(R: ArrayLike, out: _Out = ...) -> _Array:
    """vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.

    (3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.
    40 mul, 51 add, 2 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 39 select.  Error
    <= vo: 7 u of its largest component for R a rotation; searched, not proved.
    """

def SO3_leftJacobian(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    88 mul, 114 add, 4 div, 1 sqrt, 5 abs, 6 less, 12 select.  Error <= R: (7 + θ/200) u of its
    largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.
    """

def SO3_rightJacobian(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    88 mul, 114 add, 4 div, 1 sqrt, 3 neg, 5 abs, 6 less, 12 select.  Error <= R: (7 + θ/200) u
    of its largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.
    """

def SO3_leftJacobianInverse(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    71 mul, 96 add, 3 div, 1 sqrt, 3 neg, 5 abs, 7 less, 12 select.  Error <= R: 6 u of its
    largest component for |v| <= π; searched, not proved.
    """

def SO3_rightJacobianInverse(v: ArrayLike, out: _Out = ...) -> _Array:
    """R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    71 mul, 96 add, 3 div, 1 sqrt, 5 abs, 7 less, 12 select.  Error <= R: 6 u of its largest
    component for |v| <= π; searched, not proved.
    """

def mat3x3_from_axis_angle(axis: ArrayLike, angle: ArrayLike, out: _Out = ...) -> _Array:
    """R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
    not a rotation.

    (3),()->(3,3).  axis: vector; angle: number; R: rotation or other 3×3 matrix.
    71 mul, 79 add, 2 abs, 1 less, 1 select.  Error <= R: 9 u of its largest component for
    |axis| = 1; searched, not proved.
    """

def axis_angle_from_mat3x3(R: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.

    (3,3)->(),(3).  R: rotation or other 3×3 matrix; angle: number; axis: vector.
    37 mul, 51 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 40 select.  Error
    <= angle: 8 u, axis: 5 u of its largest component for R a rotation; searched, not proved.
    """

def mat3x3_orthonormalize(self: ArrayLike, out: _Out = ...) -> _Array:
    """self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    51 mul, 42 add, 3 neg.  Error <= u |result| + 7 u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def mat3x3_orthonormalized(R: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    51 mul, 42 add, 3 neg.  Error <= u |result| + 7 u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def SE3_exp(s: ArrayLike, out: _Out = ...) -> _Array:
    """D = exp s = [exp ω~ | J_l(ω) v].

    (6)->(3,4).  s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
    108 mul, 126 add, 4 div, 1 sqrt, 5 abs, 6 less, 13 select.  Error <= R: (6 + θ/200) u, t:
    (14 + θ/200) u of its largest component, or of s.lin if that is larger, for |ω of s| <=
    1e13, in single precision 1e5; searched, not proved.  Intermediate sums may overflow where
    |v|, or |ω| |v|, is above 2e306, in single precision 5e36.
    """

def SE3_log(D: ArrayLike, out: _Out = ...) -> _Array:
    """so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    79 mul, 80 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 20 less, 2 equal, 43 select.  Error
    <= lin: 18 u, ang: 8 u of its largest component for R of D a rotation; searched, not proved.
    Intermediate sums may overflow where |t| is above 2e306, in single precision 5e36.
    """

def SE3_leftJacobian(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = J_l(s) = Σ ([ad](s))^k / (k+1)!.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    149 mul, 166 add, 6 div, 1 sqrt, 1 neg, 5 abs, 7 less, 15 select.  Error <= M: 20 u of its
    largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow
    where |v| is above 2e306, in single precision 5e36.
    """

def SE3_rightJacobian(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    149 mul, 166 add, 6 div, 1 sqrt, 13 neg, 5 abs, 7 less, 15 select.  Error <= M: 20 u of its
    largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow
    where |v| is above 2e306, in single precision 5e36.
    """

def SE3_leftJacobianInverse(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    121 mul, 139 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.  Error <= M: 14 u of its
    largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow
    where |v| is above 2e306, in single precision 5e36.
    """

def SE3_rightJacobianInverse(s: ArrayLike, out: _Out = ...) -> _Array:
    """M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    121 mul, 139 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.  Error <= M: 14 u of its
    largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow
    where |v| is above 2e306, in single precision 5e36.
    """

def SE3_interpolated(D1: ArrayLike, D2: ArrayLike, k: ArrayLike, out: _Out = ...) -> _Array:
    """Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.

    (3,4),(3,4),()->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
    265 mul, 260 add, 8 div, 2 sqrt, 6 neg, 10 abs, 2 copysign, 26 less, 2 equal, 56 select.
    Error <= R: 22 u, t: 60 u of its largest component, or of D1.t or D2.t if that is larger,
    for R of D1 a rotation and R of D2 a rotation and 0 <= k <= 1; searched, not proved.
    Intermediate sums may overflow where |t| of D1 or D2 is above 2e306, in single precision
    5e36.
    """

def mat3x3_ldl(A: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
    triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
    not positive definite, and L is meaningless.

    (3,3)->(),(3,3).  A, L: rotation or other 3×3 matrix; pivot: number.
    4 mul, 4 add, 6 div, 6 less, 9 select.  |L D L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the
    pivot is positive, barring over- and underflow.
    """

def mat3x3_ldl_solve(L: ArrayLike, b: ArrayLike, out: _Out = ...) -> _Array:
    """x = A^-1 b, L of mat3x3_ldl with a positive pivot.

    (3,3),(3)->(3).  L: rotation or other 3×3 matrix; b, x: vector.
    6 mul, 6 add, 3 div.  Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj)
    |x_j|; measured, not proved; barring over- and underflow.
    """

def mat3x3_solve(A: ArrayLike, b: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
    Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
    rounding or indefinite (A - 50 u diag A is not positive definite).

    (3,3),(3)->(),(3).  A: rotation or other 3×3 matrix; b, x: vector; pivot: number.
    32 mul, 32 add, 15 div, 11 less, 1 equal, 20 select.  Backward error, of A: |b - A x|_i <= 4
    u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved; barring over- and underflow.
    """

def mat6x6_ldl(A: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
    triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
    not positive definite, and L is meaningless.

    (6,6)->(),(6,6).  A, L: 6×6 operator; pivot: number.
    35 mul, 35 add, 21 div, 15 less, 21 select.  |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where
    the pivot is positive, barring over- and underflow.
    """

def mat6x6_ldl_solve(L: ArrayLike, b: ArrayLike, out: _Out = ...) -> _Array:
    """x = A^-1 b, L of mat6x6_ldl with a positive pivot.

    (6,6),(6)->(6).  L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in
    rad/s).
    30 mul, 30 add, 6 div.  Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii
    a_jj) |x_j|; measured, not proved; barring over- and underflow.
    """

def mat6x6_solve(A: ArrayLike, b: ArrayLike, out: tuple[_Out, _Out] | None = ...) -> tuple[_Array, _Array]:
    """x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
    Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
    rounding or indefinite (A - 50 u diag A is not positive definite).

    (6,6),(6)->(),(6).  A: 6×6 operator; b: coscrew (f in N; τ in N m); pivot: number; x: screw
    (v in m/s; ω in rad/s).
    172 mul, 172 add, 48 div, 23 less, 1 equal, 41 select.  Backward error, of A: |b - A x|_i <=
    4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved; barring over- and underflow.
    """

def inertia(m: ArrayLike, t: ArrayLike, Ixx: ArrayLike, Iyy: ArrayLike, Izz: ArrayLike, Ixy: ArrayLike, Iyz: ArrayLike, Izx: ArrayLike, out: _Out = ...) -> _Array:
    """J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
    moments' matrix about it in kg m^2, Ixy = -∫ x y dm.

    (),(3),(),(),(),(),(),()->(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J:
    inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in
    kg m^2).
    3 mul.  Error <= u |result|, barring over- and underflow.
    """

def inertia_copy(Ji: ArrayLike, out: _Out = ...) -> _Array:
    """Jo = Ji.

    (10)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx,
    yy, zz, xy, yz, zx in kg m^2).
    No arithmetic.  Exact.
    """

def inertia_rotated(Ji: ArrayLike, R: ArrayLike, out: _Out = ...) -> _Array:
    """Jo = Ji rotated by R: m, R mt, R I R^T.

    (10),(3,3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    54 mul, 36 add.  Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def inertia_rotate(self: ArrayLike, R: ArrayLike, out: _Out = ...) -> _Array:
    """self = self rotated by R: m, R mt, R I R^T.

    (10),(3,3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    54 mul, 36 add.  Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def inertia_translated(Ji: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """Jo = Ji translated by t: m, mt + m t, I.

    (10),(3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); t: vector.
    3 mul, 3 add.  Error <= u |result| + (m: 0, mt: 1, I: 0) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def inertia_translate(self: ArrayLike, t: ArrayLike, out: _Out = ...) -> _Array:
    """self = self translated by t: m, mt + m t, I.

    (10),(3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx,
    yy, zz, xy, yz, zx in kg m^2); t: vector.
    3 mul, 3 add.  Error <= u |result| + (m: 0, mt: 1, I: 0) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def inertia_transformed(Ji: ArrayLike, D: ArrayLike, out: _Out = ...) -> _Array:
    """Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.

    (10),(3,4)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
    57 mul, 39 add.  Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def inertia_transform(self: ArrayLike, D: ArrayLike, out: _Out = ...) -> _Array:
    """self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.

    (10),(3,4)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
    57 mul, 39 add.  Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def inertia_merge(Ji: ArrayLike, t_ic: ArrayLike, Jj: ArrayLike, t_jc: ArrayLike, D_ij: ArrayLike, out: _Out = ...) -> _Array:
    """Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j,
    mt_i + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d =
    c - t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own
    frame; NaN where m_i + m_j = 0.

    (10),(3),(10),(3),(3,4)->(10).  Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement
    [R | t], R rotation, t in m.
    67 mul, 61 add, 1 div.  Error <= 18 u times the sum of the absolute values of all terms, for
    masses that are not negative, barring over- and underflow.
    """

def spatial_inertia_copy(Bi: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = Bi.

    (10)->(10).  Bi, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2).
    No arithmetic.  Exact.
    """

def spatial_inertia_scale(self: ArrayLike, a: ArrayLike, out: _Out = ...) -> _Array:
    """self = a self.

    (10),()->(10).  self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); a: number.
    10 mul.  Error <= u |result|, barring over- and underflow.
    """

def add_BB(B1: ArrayLike, B2: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = B1 + B2.

    (10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2).
    10 add.  Error <= u |result|, barring over- and underflow.
    """

def subtract_BB(B1: ArrayLike, B2: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = B1 - B2.

    (10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2).
    10 add.  Error <= u |result|, barring over- and underflow.
    """

def spatial_inertia_from_com(m: ArrayLike, com: ArrayLike, Ic: ArrayLike, out: _Out = ...) -> _Array:
    """Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle
    is read): h = m com, I = Ic - m com~ com~.

    (),(3),(3,3)->(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial
    inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    9 mul, 9 add.  Error <= u |result| + (m: 0, h: 0, I: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def spatial_inertia_from_inertia(J: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of
    mass; NaN where m = 0.

    (10)->(10).  J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
    zz, xy, yz, zx in kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the
    origin, xx, yy, zz, xy, xz, yz in kg m^2).
    6 mul, 9 add, 3 div.  Error of a moment <= 4 u times the sum of its |terms|, barring over-
    and underflow.
    """

def inertia_from_spatial_inertia(B: ArrayLike, out: _Out = ...) -> _Array:
    """Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of
    mass; NaN where m = 0.

    (10)->(10).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2).
    6 mul, 9 add, 3 div.  Error of a moment <= 4 u times the sum of its |terms|, barring over-
    and underflow.
    """

def spatial_inertia_com(B: ArrayLike, out: _Out = ...) -> _Array:
    """vo = h / m, the centre of mass in m.

    (10)->(3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); vo: vector.
    3 div.  Error <= u |result|, barring over- and underflow.
    """

def spatial_inertia_about_com(B: ArrayLike, out: _Out = ...) -> _Array:
    """Ro = I + h~ h~ / m, the second moments about the centre of mass.

    (10)->(3,3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Ro: rotation or other 3×3 matrix.
    6 mul, 9 add, 3 div.
    """

def spatial_inertia_matrix(B: ArrayLike, out: _Out = ...) -> _Array:
    """Mo = [[m 1, -h~], [h~, I]].

    (10)->(6,6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Mo: 6×6 operator.
    3 neg.  Exact.
    """

def product_Bs(B: ArrayLike, s: ArrayLike, out: _Out = ...) -> _Array:
    """co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.

    (10),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
    24 mul, 18 add.  Error <= u |result| + (lin: 2, ang: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """

def spatial_inertia_energy(B: ArrayLike, s: ArrayLike, out: _Out = ...) -> _Array:
    """s·B s / 2, the kinetic energy in J of a body that moves with s.

    (10),(6)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy: number.
    26 mul, 17 add.  Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """

def spatial_inertia_net_wrench(B: ArrayLike, w: ArrayLike, ds: ArrayLike, out: _Out = ...) -> _Array:
    """co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
    velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
    a is less gravity's, so is the wrench.

    (10),(3),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,
    yy, zz, xy, xz, yz in kg m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f
    in N; τ in N m).
    39 mul, 42 add, 3 neg.  Error <= u |result| + (lin: 5, ang: 6) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """

def spatial_inertia_shifted(t: ArrayLike, B: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.

    (3),(10)->(10).  t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the
    origin, xx, yy, zz, xy, xz, yz in kg m^2).
    18 mul, 18 add.  Error <= u |result| + (m: 0, h: 1, I: 4) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def spatial_inertia_transformed(D: ArrayLike, B: ArrayLike, out: _Out = ...) -> _Array:
    """Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.

    (3,4),(10)->(10).  D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in
    kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    72 mul, 54 add.  Error <= u |result| + (m: 0, h: 3, I: 6) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """

def spatial_inertia_consistency(B: ArrayLike, out: _Out = ...) -> _Array:
    """the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:
    positive exactly if a body of positive density has this inertia.

    (10)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,
    xz, yz in kg m^2); pivot: number.
    11 mul, 15 add, 10 div, 3 neg, 9 less, 13 select.
    """

SE3 = SE3_fromRt
screw = screw_from_lin_ang
coscrew = coscrew_from_lin_ang
