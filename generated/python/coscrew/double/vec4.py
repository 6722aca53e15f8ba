# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of four components: three dimensions and a homogeneous coordinate.

In double precision, plain tier.
"""

from numpy import absolute, float64 as real, sqrt, where
from coscrew._kernel import double_kernel as kernel


@kernel("(4)->(4)")
def vec4_copy(vi):
    """vo = vi.

    (4)->(4).  vi, vo: vector (x, y, z) and a homogeneous coordinate w.
    No arithmetic.  Exact.
    """
    vi_0, vi_1, vi_2, vi_3 = vi
    return (vi_0, vi_1, vi_2, vi_3)


@kernel("(4),()->(4)")
def vec4_scale(self, a):
    """self = a self.

    (4),()->(4).  self: vector (x, y, z) and a homogeneous coordinate w; a: number.
    4 mul.  Error <= u |result|, barring over- and underflow.
    """
    self_0, self_1, self_2, self_3 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    return (self_0_new, self_1_new, self_2_new, self_3_new)


@kernel("(4)->(4)")
def vec4_inverted(vi):
    """vo = -vi.

    (4)->(4).  vi, vo: vector (x, y, z) and a homogeneous coordinate w.
    4 neg.  Exact.
    """
    vi_0, vi_1, vi_2, vi_3 = vi
    vo_0 = -vi_0
    vo_1 = -vi_1
    vo_2 = -vi_2
    vo_3 = -vi_3
    return (vo_0, vo_1, vo_2, vo_3)


@kernel("(4)->(4)")
def vec4_invert(self):
    """self = -self.

    (4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.
    4 neg.  Exact.
    """
    self_0, self_1, self_2, self_3 = self
    self_0_new = -self_0
    self_1_new = -self_1
    self_2_new = -self_2
    self_3_new = -self_3
    return (self_0_new, self_1_new, self_2_new, self_3_new)


@kernel("(4),()->(4)")
def vec4_scaled(v, k):
    """vo = k v.

    (4),()->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
    4 mul.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2, v_3 = v
    vo_0 = v_0 * k
    vo_1 = v_1 * k
    vo_2 = v_2 * k
    vo_3 = v_3 * k
    return (vo_0, vo_1, vo_2, vo_3)


@kernel("(4),(4)->(4),(4)")
def vec4_swap(v1, v2):
    """v1, v2 = v2, v1.

    (4),(4)->(4),(4).  v1, v2: vector (x, y, z) and a homogeneous coordinate w.
    No arithmetic.  Exact.
    """
    v1_0, v1_1, v1_2, v1_3 = v1
    v2_0, v2_1, v2_2, v2_3 = v2
    return (v2_0, v2_1, v2_2, v2_3, v1_0, v1_1, v1_2, v1_3)


@kernel("(4)->()")
def vec4_l2norm(v):
    """|v| = sqrt(v·v), all four components.

    (4)->().  v: vector (x, y, z) and a homogeneous coordinate w; norm: number.
    9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.
    """
    v_0, v_1, v_2, v_3 = v
    s_size_0 = absolute(v_0)
    s_size_1 = absolute(v_1)
    s_size_2 = absolute(v_2)
    s_size_3 = absolute(v_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = v_0 * s
    y_1 = v_1 * s
    y_2 = v_2 * s
    y_3 = v_3 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    r_d = where(1 < s, 7.637340908749012e-152, where(s < 1, real(2.6815615859885194e+154), real(1)))
    r = where(1.3093562431584567e+151 < s, 9.332636185032189e-302, r_d)
    norm = n * r
    return norm


@kernel("(4)->(4)")
def vec4_normalize(self):
    """self = self / |self|; the zero vector stays zero.

    (4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.
    16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
    """
    self_0, self_1, self_2, self_3 = self
    s_size_0 = absolute(self_0)
    s_size_1 = absolute(self_1)
    s_size_2 = absolute(self_2)
    s_size_3 = absolute(self_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = self_0 * s
    y_1 = self_1 * s
    y_2 = self_2 * s
    y_3 = self_3 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    divisor = where(n == 0, up, n)
    sized_0 = self_0 * up
    sized_1 = self_1 * up
    sized_2 = self_2 * up
    sized_3 = self_3 * up
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    self_0_new = quotient_0 * down
    self_1_new = quotient_1 * down
    self_2_new = quotient_2 * down
    self_3_new = quotient_3 * down
    return (self_0_new, self_1_new, self_2_new, self_3_new)


@kernel("(4)->(4)")
def vec4_normalized(v):
    """vo = v / |v|; the zero vector stays zero.

    (4)->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w.
    16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
    """
    v_0, v_1, v_2, v_3 = v
    s_size_0 = absolute(v_0)
    s_size_1 = absolute(v_1)
    s_size_2 = absolute(v_2)
    s_size_3 = absolute(v_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = v_0 * s
    y_1 = v_1 * s
    y_2 = v_2 * s
    y_3 = v_3 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    divisor = where(n == 0, up, n)
    sized_0 = v_0 * up
    sized_1 = v_1 * up
    sized_2 = v_2 * up
    sized_3 = v_3 * up
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    vo_0 = quotient_0 * down
    vo_1 = quotient_1 * down
    vo_2 = quotient_2 * down
    vo_3 = quotient_3 * down
    return (vo_0, vo_1, vo_2, vo_3)
