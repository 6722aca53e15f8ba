# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of three components.

In double precision, plain tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, sqrt, where
from coscrew._kernel import double_kernel as kernel


@kernel("(3)->(3)")
def vec3_copy(vi):
    """vo = vi.

    (3)->(3).  vi, vo: vector.
    No arithmetic.  Exact.
    """
    vi_0, vi_1, vi_2 = vi
    return (vi_0, vi_1, vi_2)


@kernel("(3),()->(3)")
def vec3_scale(self, a):
    """self = a self.

    (3),()->(3).  self: vector; a: number.
    3 mul.  Error <= u |result|, barring over- and underflow.
    """
    self_0, self_1, self_2 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    return (self_0_new, self_1_new, self_2_new)


@kernel("(3)->(3)")
def vec3_inverted(vi):
    """vo = -vi.

    (3)->(3).  vi, vo: vector.
    3 neg.  Exact.
    """
    vi_0, vi_1, vi_2 = vi
    vo_0 = -vi_0
    vo_1 = -vi_1
    vo_2 = -vi_2
    return (vo_0, vo_1, vo_2)


@kernel("(3)->(3)")
def vec3_invert(self):
    """self = -self.

    (3)->(3).  self: vector.
    3 neg.  Exact.
    """
    self_0, self_1, self_2 = self
    self_0_new = -self_0
    self_1_new = -self_1
    self_2_new = -self_2
    return (self_0_new, self_1_new, self_2_new)


@kernel("(),(3),(3)->(3)")
def axpy_vv(a, x, y):
    """y = a x + y.

    (),(3),(3)->(3).  a: number; x, y: vector.
    3 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = a * x_0 + y_0
    y_1_new = a * x_1 + y_1
    y_2_new = a * x_2 + y_2
    return (y_0_new, y_1_new, y_2_new)


@kernel("(3),(3)->(3)")
def xpy_vv(x, y):
    """y = x + y.

    (3),(3)->(3).  x, y: vector.
    3 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = x_0 + y_0
    y_1_new = x_1 + y_1
    y_2_new = x_2 + y_2
    return (y_0_new, y_1_new, y_2_new)


@kernel("(3),(3)->(3)")
def nxpy_vv(x, y):
    """y = -x + y.

    (3),(3)->(3).  x, y: vector.
    3 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = y_0 - x_0
    y_1_new = y_1 - x_1
    y_2_new = y_2 - x_2
    return (y_0_new, y_1_new, y_2_new)


@kernel("(),(3)->(3)")
def product_av(a, vi):
    """vo = a vi.

    (),(3)->(3).  a: number; vi, vo: vector.
    3 mul.  Error <= u |result|, barring over- and underflow.
    """
    vi_0, vi_1, vi_2 = vi
    vo_0 = a * vi_0
    vo_1 = a * vi_1
    vo_2 = a * vi_2
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->(3)")
def add_vv(v1, v2):
    """vo = v1 + v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    3 add.  Error <= u |result|, barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 + v2_0
    vo_1 = v1_1 + v2_1
    vo_2 = v1_2 + v2_2
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->(3)")
def subtract_vv(v1, v2):
    """vo = v1 - v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    3 add.  Error <= u |result|, barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 - v2_0
    vo_1 = v1_1 - v2_1
    vo_2 = v1_2 - v2_2
    return (vo_0, vo_1, vo_2)


@kernel("(3),()->(3)")
def vec3_scaled(v, k):
    """vo = k v.

    (3),()->(3).  v, vo: vector; k: number.
    3 mul.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 * k
    vo_1 = v_1 * k
    vo_2 = v_2 * k
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->(3),(3)")
def vec3_swap(v1, v2):
    """v1, v2 = v2, v1.

    (3),(3)->(3),(3).  v1, v2: vector.
    No arithmetic.  Exact.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    return (v2_0, v2_1, v2_2, v1_0, v1_1, v1_2)


@kernel("(3)->()")
def vec3_l2norm(v):
    """|v| = sqrt(v·v).

    (3)->().  v: vector; norm: number.
    7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select.
    """
    v_0, v_1, v_2 = v
    s_size_0 = absolute(v_0)
    s_size_1 = absolute(v_1)
    s_size_2 = absolute(v_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = v_0 * s
    y_1 = v_1 * s
    y_2 = v_2 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    r_d = where(1 < s, 7.637340908749012e-152, where(s < 1, real(2.6815615859885194e+154), real(1)))
    r = where(1.3093562431584567e+151 < s, 9.332636185032189e-302, r_d)
    norm = n * r
    return norm


@kernel("(3)->(3)")
def vec3_normalize(self):
    """self = self / |self|; the zero vector stays zero.

    (3)->(3).  self: vector.
    12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select.
    """
    self_0, self_1, self_2 = self
    s_size_0 = absolute(self_0)
    s_size_1 = absolute(self_1)
    s_size_2 = absolute(self_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = self_0 * s
    y_1 = self_1 * s
    y_2 = self_2 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    divisor = where(n == 0, up, n)
    sized_0 = self_0 * up
    sized_1 = self_1 * up
    sized_2 = self_2 * up
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    self_0_new = quotient_0 * down
    self_1_new = quotient_1 * down
    self_2_new = quotient_2 * down
    return (self_0_new, self_1_new, self_2_new)


@kernel("(3)->(3)")
def vec3_normalized(v):
    """vo = v / |v|; the zero vector stays zero.

    (3)->(3).  v, vo: vector.
    12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select.
    """
    v_0, v_1, v_2 = v
    s_size_0 = absolute(v_0)
    s_size_1 = absolute(v_1)
    s_size_2 = absolute(v_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = v_0 * s
    y_1 = v_1 * s
    y_2 = v_2 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    divisor = where(n == 0, up, n)
    sized_0 = v_0 * up
    sized_1 = v_1 * up
    sized_2 = v_2 * up
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    vo_0 = quotient_0 * down
    vo_1 = quotient_1 * down
    vo_2 = quotient_2 * down
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->()")
def angle_vv(v1, v2):
    """angle = atan2(|v1 × v2|, v1·v2), in [0, π].

    (3),(3)->().  v1, v2: vector; angle: number.
    51 mul, 42 add, 1 div, 1 sqrt, 1 neg, 11 abs, 2 copysign, 24 less, 1 equal, 32 select.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    s1_size_0 = absolute(v1_0)
    s1_size_1 = absolute(v1_1)
    s1_size_2 = absolute(v1_2)
    s1_largest1 = where(s1_size_0 < s1_size_1, s1_size_1, s1_size_0)
    s1_largest2 = where(s1_largest1 < s1_size_2, s1_size_2, s1_largest1)
    s1d = where(s1_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s1_largest2, real(3.7291703656001034e-155), real(1)))
    s1 = where(s1_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s1d)
    scaled_s1_0 = v1_0 * s1
    scaled_s1_1 = v1_1 * s1
    scaled_s1_2 = v1_2 * s1
    s2_size_0 = absolute(v2_0)
    s2_size_1 = absolute(v2_1)
    s2_size_2 = absolute(v2_2)
    s2_largest1 = where(s2_size_0 < s2_size_1, s2_size_1, s2_size_0)
    s2_largest2 = where(s2_largest1 < s2_size_2, s2_size_2, s2_largest1)
    s2d = where(s2_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s2_largest2, real(3.7291703656001034e-155), real(1)))
    s2 = where(s2_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s2d)
    scaled_s2_0 = v2_0 * s2
    scaled_s2_1 = v2_1 * s2
    scaled_s2_2 = v2_2 * s2
    c_0 = scaled_s1_1 * scaled_s2_2 - scaled_s1_2 * scaled_s2_1
    c_1 = scaled_s1_2 * scaled_s2_0 - scaled_s1_0 * scaled_s2_2
    c_2 = scaled_s1_0 * scaled_s2_1 - scaled_s1_1 * scaled_s2_0
    s_size_0 = absolute(c_0)
    s_size_1 = absolute(c_1)
    s_size_2 = absolute(c_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = c_0 * s
    y_1 = c_1 * s
    y_2 = c_2 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    r_d = where(1 < s, 7.637340908749012e-152, where(s < 1, real(2.6815615859885194e+154), real(1)))
    r = where(1.3093562431584567e+151 < s, 9.332636185032189e-302, r_d)
    cross = n * r
    dot_ = scaled_s1_0 * scaled_s2_0 + scaled_s1_1 * scaled_s2_1 + scaled_s1_2 * scaled_s2_2
    angle = elementary.atan2(cross, dot_)
    return angle


@kernel("(3),(3)->()")
def dot_vv(v1, v2):
    """v1·v2.

    (3),(3)->().  v1, v2: vector; dot: number.
    3 mul, 2 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    dot = v1_0 * v2_0 + v1_1 * v2_1 + v1_2 * v2_2
    return dot


@kernel("(),(3)->(3)")
def product_avinv(k, v):
    """vo = k (-v).

    (),(3)->(3).  k: number; v, vo: vector.
    3 mul, 3 neg.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = -(k * v_0)
    vo_1 = -(k * v_1)
    vo_2 = -(k * v_2)
    return (vo_0, vo_1, vo_2)


@kernel("(),(3)->(3)")
def product_ainvv(k, v):
    """vo = v / k.

    (),(3)->(3).  k: number; v, vo: vector.
    3 div.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 / k
    vo_1 = v_1 / k
    vo_2 = v_2 / k
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->(3)")
def cross_vv(v1, v2):
    """vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_1 * v2_2 - v1_2 * v2_1
    vo_1 = v1_2 * v2_0 - v1_0 * v2_2
    vo_2 = v1_0 * v2_1 - v1_1 * v2_0
    return (vo_0, vo_1, vo_2)


@kernel("(3),(3)->(3)")
def cross_vvinv(v1, v2):
    """vo = v1 × (-v2).

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 3 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_2 * v2_1 - v1_1 * v2_2
    vo_1 = v1_0 * v2_2 - v1_2 * v2_0
    vo_2 = v1_1 * v2_0 - v1_0 * v2_1
    return (vo_0, vo_1, vo_2)


@kernel("(3),()->(3)")
def add_vvx(v, k):
    """vo = v + k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 + k
    return (vo_0, v_1, v_2)


@kernel("(3),()->(3)")
def add_vvxinv(v, k):
    """vo = v - k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 - k
    return (vo_0, v_1, v_2)


@kernel("(3),()->(3)")
def add_vvy(v, k):
    """vo = v + k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 + k
    return (v_0, vo_1, v_2)


@kernel("(3),()->(3)")
def add_vvyinv(v, k):
    """vo = v - k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 - k
    return (v_0, vo_1, v_2)


@kernel("(3),()->(3)")
def add_vvz(v, k):
    """vo = v + k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 + k
    return (v_0, v_1, vo_2)


@kernel("(3),()->(3)")
def add_vvzinv(v, k):
    """vo = v - k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    1 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 - k
    return (v_0, v_1, vo_2)
