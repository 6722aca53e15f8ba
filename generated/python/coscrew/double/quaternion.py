# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.

In double precision, plain tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, nan, sqrt, where
from coscrew._kernel import double_kernel as kernel


@kernel("(4)->(4)")
def quaternion_copy(qi):
    """qo = qi.

    (4)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last.
    No arithmetic.  Exact.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    return (qi_0, qi_1, qi_2, qi_3)


@kernel("(4),()->(4)")
def quaternion_scale(self, a):
    """self = a self.

    (4),()->(4).  self: quaternion (x, y, z, w), the scalar last; a: number.
    4 mul.  Error <= u |result|, barring over- and underflow.
    """
    self_0, self_1, self_2, self_3 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    return (self_0_new, self_1_new, self_2_new, self_3_new)


@kernel("(),(4),(4)->(4)")
def axpy_qq(a, x, y):
    """y = a x + y.

    (),(4),(4)->(4).  a: number; x, y: quaternion (x, y, z, w), the scalar last.
    4 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    x_0, x_1, x_2, x_3 = x
    y_0, y_1, y_2, y_3 = y
    y_0_new = a * x_0 + y_0
    y_1_new = a * x_1 + y_1
    y_2_new = a * x_2 + y_2
    y_3_new = a * x_3 + y_3
    return (y_0_new, y_1_new, y_2_new, y_3_new)


@kernel("(4)->(4)")
def quaternion_setIdentity(self):
    """self = (0; 1).

    (4)->(4).  self: quaternion (x, y, z, w), the scalar last.
    No arithmetic.  Exact.
    """
    return (0, 0, 0, 1)


@kernel("(4)->(4)")
def quaternion_conjugated(q):
    """qo = (-v; w), the inverse of q if |q| = 1.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    3 neg.  Exact.
    """
    q_0, q_1, q_2, q_3 = q
    qo_0 = -q_0
    qo_1 = -q_1
    qo_2 = -q_2
    return (qo_0, qo_1, qo_2, q_3)


@kernel("(4)->()")
def quaternion_norm(q):
    """|q| = sqrt(v·v + w^2).

    (4)->().  q: quaternion (x, y, z, w), the scalar last; norm: number.
    9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    r_d = where(1 < s, 7.637340908749012e-152, where(s < 1, real(2.6815615859885194e+154), real(1)))
    r = where(1.3093562431584567e+151 < s, 9.332636185032189e-302, r_d)
    norm = n * r
    return norm


@kernel("(4)->(4)")
def quaternion_normalize(self):
    """self = self / |self|; zero stays zero.

    (4)->(4).  self: quaternion (x, y, z, w), the scalar last.
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
def quaternion_normalized(q):
    """qo = q / |q|; zero stays zero.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    divisor = where(n == 0, up, n)
    sized_0 = q_0 * up
    sized_1 = q_1 * up
    sized_2 = q_2 * up
    sized_3 = q_3 * up
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    qo_0 = quotient_0 * down
    qo_1 = quotient_1 * down
    qo_2 = quotient_2 * down
    qo_3 = quotient_3 * down
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4)->()")
def quaternion_unit_defect(q):
    """|q| - 1: 0 for a unit quaternion, negative for a shorter one.

    (4)->().  q: quaternion (x, y, z, w), the scalar last; defect: number.
    9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    r_d = where(1 < s, 7.637340908749012e-152, where(s < 1, real(2.6815615859885194e+154), real(1)))
    r = where(1.3093562431584567e+151 < s, 9.332636185032189e-302, r_d)
    length = n * r
    defect = length - 1
    return defect


@kernel("(4)->(4)")
def quaternion_nearest_unit(q):
    """qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 3 add, 4 div, 1 sqrt, 4 abs, 6 less, 1 equal, 11 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    scaled_s_0 = q_0 * s
    scaled_s_1 = q_1 * s
    scaled_s_2 = q_2 * s
    scaled_s_3 = q_3 * s
    n = sqrt(scaled_s_0 * scaled_s_0 + scaled_s_1 * scaled_s_1 + scaled_s_2 * scaled_s_2 +
        scaled_s_3 * scaled_s_3)
    divisor_a = n == 0
    divisor = where(divisor_a, 1, n)
    unit_0 = scaled_s_0 / divisor
    unit_1 = scaled_s_1 / divisor
    unit_2 = scaled_s_2 / divisor
    unit_3 = scaled_s_3 / divisor
    qo_0 = where(divisor_a, nan, unit_0)
    qo_1 = where(divisor_a, nan, unit_1)
    qo_2 = where(divisor_a, nan, unit_2)
    qo_3 = where(divisor_a, nan, unit_3)
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(3)->(3)")
def rotate_qv(q, v):
    """vo = R(q) v, |q| = 1.

    (4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
    18 mul, 12 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    q_0, q_1, q_2, q_3 = q
    v_0, v_1, v_2 = v
    c_0 = q_1 * v_2 - q_2 * v_1
    c_1 = q_2 * v_0 - q_0 * v_2
    c_2 = q_0 * v_1 - q_1 * v_0
    t_0 = 2 * c_0
    t_1 = 2 * c_1
    t_2 = 2 * c_2
    turn_0 = q_1 * t_2 - q_2 * t_1 + q_3 * t_0
    turn_1 = q_2 * t_0 - q_0 * t_2 + q_3 * t_1
    turn_2 = q_0 * t_1 - q_1 * t_0 + q_3 * t_2
    vo_0 = v_0 + turn_0
    vo_1 = v_1 + turn_1
    vo_2 = v_2 + turn_2
    return (vo_0, vo_1, vo_2)


@kernel("(4),(3)->(3)")
def rotate_qconjv(q, v):
    """vo = R(q)^T v, |q| = 1.

    (4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
    18 mul, 12 add.  Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    q_0, q_1, q_2, q_3 = q
    v_0, v_1, v_2 = v
    c_0 = q_2 * v_1 - q_1 * v_2
    c_1 = q_0 * v_2 - q_2 * v_0
    c_2 = q_1 * v_0 - q_0 * v_1
    t_0 = 2 * c_0
    t_1 = 2 * c_1
    t_2 = 2 * c_2
    turn_0 = q_2 * t_1 - q_1 * t_2 + q_3 * t_0
    turn_1 = q_0 * t_2 - q_2 * t_0 + q_3 * t_1
    turn_2 = q_1 * t_0 - q_0 * t_1 + q_3 * t_2
    vo_0 = v_0 + turn_0
    vo_1 = v_1 + turn_1
    vo_2 = v_2 + turn_2
    return (vo_0, vo_1, vo_2)


@kernel("(4),(4)->(4)")
def quaternion_product_qq(q1i, q2i):
    """qo = q1i q2i.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0 = q1i_0 * q2i_3 + (q1i_1 * q2i_2 - q1i_2 * q2i_1) + q1i_3 * q2i_0
    qo_1 = q1i_2 * q2i_0 - q1i_0 * q2i_2 + q1i_1 * q2i_3 + q1i_3 * q2i_1
    qo_2 = q1i_0 * q2i_1 - q1i_1 * q2i_0 + q1i_2 * q2i_3 + q1i_3 * q2i_2
    qo_3 = q1i_3 * q2i_3 - (q1i_0 * q2i_0 + q1i_1 * q2i_1 + q1i_2 * q2i_2)
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(4)->(4)")
def quaternion_product_qqconj(q1i, q2i):
    """qo = q1i q2i*.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 12 add.  Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0 = q1i_0 * q2i_3 - q1i_3 * q2i_0 + (q1i_2 * q2i_1 - q1i_1 * q2i_2)
    qo_1 = q1i_0 * q2i_2 - q1i_2 * q2i_0 + (q1i_1 * q2i_3 - q1i_3 * q2i_1)
    qo_2 = q1i_1 * q2i_0 - q1i_0 * q2i_1 + (q1i_2 * q2i_3 - q1i_3 * q2i_2)
    qo_3 = q1i_0 * q2i_0 + q1i_1 * q2i_1 + q1i_2 * q2i_2 + q1i_3 * q2i_3
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(4)->(4)")
def quaternion_product_qconjq(q1i, q2i):
    """qo = q1i* q2i.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 12 add.  Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0 = q1i_3 * q2i_0 - q1i_0 * q2i_3 + (q1i_2 * q2i_1 - q1i_1 * q2i_2)
    qo_1 = q1i_0 * q2i_2 - q1i_2 * q2i_0 + (q1i_3 * q2i_1 - q1i_1 * q2i_3)
    qo_2 = q1i_1 * q2i_0 - q1i_0 * q2i_1 + (q1i_3 * q2i_2 - q1i_2 * q2i_3)
    qo_3 = q1i_0 * q2i_0 + q1i_1 * q2i_1 + q1i_2 * q2i_2 + q1i_3 * q2i_3
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(4)->(4)")
def quaternion_product_qconjqconj(q1i, q2i):
    """qo = q1i* q2i*.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0 = q1i_1 * q2i_2 - q1i_2 * q2i_1 - q1i_0 * q2i_3 - q1i_3 * q2i_0
    qo_1 = q1i_2 * q2i_0 - q1i_0 * q2i_2 - q1i_1 * q2i_3 - q1i_3 * q2i_1
    qo_2 = q1i_0 * q2i_1 - q1i_1 * q2i_0 - q1i_2 * q2i_3 - q1i_3 * q2i_2
    qo_3 = q1i_3 * q2i_3 - (q1i_0 * q2i_0 + q1i_1 * q2i_1 + q1i_2 * q2i_2)
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qxq(dci, qi):
    """qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = dci_0 * qi_3 + dci_1 * qi_0
    qo_1 = dci_1 * qi_1 - dci_0 * qi_2
    qo_2 = dci_0 * qi_1 + dci_1 * qi_2
    qo_3 = dci_1 * qi_3 - dci_0 * qi_0
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qxqconj(dci, qi):
    """qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = dci_0 * qi_3 - dci_1 * qi_0
    qo_1 = dci_0 * qi_2 - dci_1 * qi_1
    qo_2 = -(dci_0 * qi_1 + dci_1 * qi_2)
    qo_3 = dci_0 * qi_0 + dci_1 * qi_3
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qxconjq(dci, qi):
    """qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = dci_1 * qi_0 - dci_0 * qi_3
    qo_1 = dci_0 * qi_2 + dci_1 * qi_1
    qo_2 = dci_1 * qi_2 - dci_0 * qi_1
    qo_3 = dci_0 * qi_0 + dci_1 * qi_3
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qxconjqconj(dci, qi):
    """qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = -(dci_0 * qi_3 + dci_1 * qi_0)
    qo_1 = -(dci_0 * qi_2 + dci_1 * qi_1)
    qo_2 = dci_0 * qi_1 - dci_1 * qi_2
    qo_3 = dci_1 * qi_3 - dci_0 * qi_0
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qqx(qi, dci):
    """qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = qi_0 * dci_1 + qi_3 * dci_0
    qo_1 = qi_1 * dci_1 + qi_2 * dci_0
    qo_2 = qi_2 * dci_1 - qi_1 * dci_0
    qo_3 = qi_3 * dci_1 - qi_0 * dci_0
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qqxconj(qi, dci):
    """qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = qi_0 * dci_1 - qi_3 * dci_0
    qo_1 = qi_1 * dci_1 - qi_2 * dci_0
    qo_2 = qi_1 * dci_0 + qi_2 * dci_1
    qo_3 = qi_0 * dci_0 + qi_3 * dci_1
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqx(qi, dci):
    """qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = qi_3 * dci_0 - qi_0 * dci_1
    qo_1 = -(qi_1 * dci_1 + qi_2 * dci_0)
    qo_2 = qi_1 * dci_0 - qi_2 * dci_1
    qo_3 = qi_0 * dci_0 + qi_3 * dci_1
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqxconj(qi, dci):
    """qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = -(qi_0 * dci_1 + qi_3 * dci_0)
    qo_1 = qi_2 * dci_0 - qi_1 * dci_1
    qo_2 = -(qi_1 * dci_0 + qi_2 * dci_1)
    qo_3 = qi_3 * dci_1 - qi_0 * dci_0
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qyq(dci, qi):
    """qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = dci_0 * qi_2 + dci_1 * qi_0
    qo_1 = dci_0 * qi_3 + dci_1 * qi_1
    qo_2 = dci_1 * qi_2 - dci_0 * qi_0
    qo_3 = dci_1 * qi_3 - dci_0 * qi_1
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qyqconj(dci, qi):
    """qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = -(dci_0 * qi_2 + dci_1 * qi_0)
    qo_1 = dci_0 * qi_3 - dci_1 * qi_1
    qo_2 = dci_0 * qi_0 - dci_1 * qi_2
    qo_3 = dci_0 * qi_1 + dci_1 * qi_3
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qyconjq(dci, qi):
    """qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = dci_1 * qi_0 - dci_0 * qi_2
    qo_1 = dci_1 * qi_1 - dci_0 * qi_3
    qo_2 = dci_0 * qi_0 + dci_1 * qi_2
    qo_3 = dci_0 * qi_1 + dci_1 * qi_3
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qyconjqconj(dci, qi):
    """qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = dci_0 * qi_2 - dci_1 * qi_0
    qo_1 = -(dci_0 * qi_3 + dci_1 * qi_1)
    qo_2 = -(dci_0 * qi_0 + dci_1 * qi_2)
    qo_3 = dci_1 * qi_3 - dci_0 * qi_1
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qqy(qi, dci):
    """qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = qi_0 * dci_1 - qi_2 * dci_0
    qo_1 = qi_1 * dci_1 + qi_3 * dci_0
    qo_2 = qi_0 * dci_0 + qi_2 * dci_1
    qo_3 = qi_3 * dci_1 - qi_1 * dci_0
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qqyconj(qi, dci):
    """qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = qi_0 * dci_1 + qi_2 * dci_0
    qo_1 = qi_1 * dci_1 - qi_3 * dci_0
    qo_2 = qi_2 * dci_1 - qi_0 * dci_0
    qo_3 = qi_1 * dci_0 + qi_3 * dci_1
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqy(qi, dci):
    """qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = qi_2 * dci_0 - qi_0 * dci_1
    qo_1 = qi_3 * dci_0 - qi_1 * dci_1
    qo_2 = -(qi_0 * dci_0 + qi_2 * dci_1)
    qo_3 = qi_1 * dci_0 + qi_3 * dci_1
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqyconj(qi, dci):
    """qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = -(qi_0 * dci_1 + qi_2 * dci_0)
    qo_1 = -(qi_1 * dci_1 + qi_3 * dci_0)
    qo_2 = qi_0 * dci_0 - qi_2 * dci_1
    qo_3 = qi_3 * dci_1 - qi_1 * dci_0
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qzq(dci, qi):
    """qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = dci_1 * qi_0 - dci_0 * qi_1
    qo_1 = dci_0 * qi_0 + dci_1 * qi_1
    qo_2 = dci_0 * qi_3 + dci_1 * qi_2
    qo_3 = dci_1 * qi_3 - dci_0 * qi_2
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qzqconj(dci, qi):
    """qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = dci_0 * qi_1 - dci_1 * qi_0
    qo_1 = -(dci_0 * qi_0 + dci_1 * qi_1)
    qo_2 = dci_0 * qi_3 - dci_1 * qi_2
    qo_3 = dci_0 * qi_2 + dci_1 * qi_3
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qzconjq(dci, qi):
    """qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = dci_0 * qi_1 + dci_1 * qi_0
    qo_1 = dci_1 * qi_1 - dci_0 * qi_0
    qo_2 = dci_1 * qi_2 - dci_0 * qi_3
    qo_3 = dci_0 * qi_2 + dci_1 * qi_3
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(2),(4)->(4)")
def quaternion_product_qzconjqconj(dci, qi):
    """qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = -(dci_0 * qi_1 + dci_1 * qi_0)
    qo_1 = dci_0 * qi_0 - dci_1 * qi_1
    qo_2 = -(dci_0 * qi_3 + dci_1 * qi_2)
    qo_3 = dci_1 * qi_3 - dci_0 * qi_2
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qqz(qi, dci):
    """qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = qi_0 * dci_1 + qi_1 * dci_0
    qo_1 = qi_1 * dci_1 - qi_0 * dci_0
    qo_2 = qi_2 * dci_1 + qi_3 * dci_0
    qo_3 = qi_3 * dci_1 - qi_2 * dci_0
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qqzconj(qi, dci):
    """qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = qi_0 * dci_1 - qi_1 * dci_0
    qo_1 = qi_0 * dci_0 + qi_1 * dci_1
    qo_2 = qi_2 * dci_1 - qi_3 * dci_0
    qo_3 = qi_2 * dci_0 + qi_3 * dci_1
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqz(qi, dci):
    """qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 1 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = -(qi_0 * dci_1 + qi_1 * dci_0)
    qo_1 = qi_0 * dci_0 - qi_1 * dci_1
    qo_2 = qi_3 * dci_0 - qi_2 * dci_1
    qo_3 = qi_2 * dci_0 + qi_3 * dci_1
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqzconj(qi, dci):
    """qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 4 add, 2 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0 = qi_1 * dci_0 - qi_0 * dci_1
    qo_1 = -(qi_0 * dci_0 + qi_1 * dci_1)
    qo_2 = -(qi_2 * dci_1 + qi_3 * dci_0)
    qo_3 = qi_3 * dci_1 - qi_2 * dci_0
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(3)->(4)")
def quaternion_product_qv(qi, vi):
    """qo = qi (vi; 0).

    (4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
    12 mul, 8 add, 1 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    vi_0, vi_1, vi_2 = vi
    qo_0 = qi_1 * vi_2 - qi_2 * vi_1 + qi_3 * vi_0
    qo_1 = qi_2 * vi_0 - qi_0 * vi_2 + qi_3 * vi_1
    qo_2 = qi_0 * vi_1 - qi_1 * vi_0 + qi_3 * vi_2
    qo_3 = -(qi_0 * vi_0 + qi_1 * vi_1 + qi_2 * vi_2)
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(3)->(4)")
def quaternion_product_qconjv(qi, vi):
    """qo = qi* (vi; 0).

    (4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
    12 mul, 8 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    vi_0, vi_1, vi_2 = vi
    qo_0 = qi_2 * vi_1 - qi_1 * vi_2 + qi_3 * vi_0
    qo_1 = qi_0 * vi_2 - qi_2 * vi_0 + qi_3 * vi_1
    qo_2 = qi_1 * vi_0 - qi_0 * vi_1 + qi_3 * vi_2
    qo_3 = qi_0 * vi_0 + qi_1 * vi_1 + qi_2 * vi_2
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(3),(4)->(4)")
def quaternion_product_vq(vi, qi):
    """qo = (vi; 0) qi.

    (3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
    12 mul, 8 add, 1 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    vi_0, vi_1, vi_2 = vi
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = vi_0 * qi_3 + (vi_1 * qi_2 - vi_2 * qi_1)
    qo_1 = vi_2 * qi_0 - vi_0 * qi_2 + vi_1 * qi_3
    qo_2 = vi_0 * qi_1 - vi_1 * qi_0 + vi_2 * qi_3
    qo_3 = -(vi_0 * qi_0 + vi_1 * qi_1 + vi_2 * qi_2)
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(3),(4)->(4)")
def quaternion_product_vqconj(vi, qi):
    """qo = (vi; 0) qi*.

    (3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
    12 mul, 8 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    vi_0, vi_1, vi_2 = vi
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0 = vi_0 * qi_3 + (vi_2 * qi_1 - vi_1 * qi_2)
    qo_1 = vi_0 * qi_2 - vi_2 * qi_0 + vi_1 * qi_3
    qo_2 = vi_1 * qi_0 - vi_0 * qi_1 + vi_2 * qi_3
    qo_3 = vi_0 * qi_0 + vi_1 * qi_1 + vi_2 * qi_2
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4),(4)->()")
def dot_qq(q1i, q2i):
    """q1i·q2i.

    (4),(4)->().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot: number.
    4 mul, 3 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    dot = q1i_0 * q2i_0 + q1i_1 * q2i_1 + q1i_2 * q2i_2 + q1i_3 * q2i_3
    return dot


@kernel("(3),(4)->(4)")
def add_dpiToq(dpi, qi):
    """qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
    first order; not normalized.

    (3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
    15 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dpi_0, dpi_1, dpi_2 = dpi
    qi_0, qi_1, qi_2, qi_3 = qi
    qi_0_new_a = 0.5 * dpi_0
    qi_0_new_c = 0.5 * dpi_2
    qi_0_new_e = 0.5 * dpi_1
    qi_0_new = qi_0_new_a * qi_3 + (qi_0_new_c * qi_1 - qi_0_new_e * qi_2) + qi_0
    qi_1_new = qi_0_new_a * qi_2 - qi_0_new_c * qi_0 + qi_0_new_e * qi_3 + qi_1
    qi_2_new = qi_0_new_e * qi_0 - qi_0_new_a * qi_1 + qi_0_new_c * qi_3 + qi_2
    qi_3_new = qi_3 - (qi_0_new_a * qi_0 + qi_0_new_e * qi_1 + qi_0_new_c * qi_2)
    return (qi_0_new, qi_1_new, qi_2_new, qi_3_new)


@kernel("(3),(4)->(4)")
def subtract_dpiFromq(dpi, qi):
    """qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.

    (3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
    15 mul, 12 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    dpi_0, dpi_1, dpi_2 = dpi
    qi_0, qi_1, qi_2, qi_3 = qi
    qi_0_new_a = 0.5 * dpi_1
    qi_0_new_c = 0.5 * dpi_2
    qi_0_new_f = 0.5 * dpi_0
    qi_0_new = qi_0_new_a * qi_2 - qi_0_new_c * qi_1 - qi_0_new_f * qi_3 + qi_0
    qi_1_new = qi_0_new_c * qi_0 - qi_0_new_f * qi_2 - qi_0_new_a * qi_3 + qi_1
    qi_2_new = qi_0_new_f * qi_1 - qi_0_new_a * qi_0 - qi_0_new_c * qi_3 + qi_2
    qi_3_new = qi_0_new_f * qi_0 + qi_0_new_a * qi_1 + qi_0_new_c * qi_2 + qi_3
    return (qi_0_new, qi_1_new, qi_2_new, qi_3_new)


@kernel("(3),(4)->(4)")
def omega_to_dquaternion(w, qi):
    """dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
    reference frame, rad/s, and a term that draws its norm to 1.

    (3),(4)->(4).  w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
    23 mul, 16 add.  Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    w_0, w_1, w_2 = w
    qi_0, qi_1, qi_2, qi_3 = qi
    dqo_0a = 0.5 * w_0
    dqo_0c = 0.5 * w_1
    dqo_0e = 0.5 * w_2
    dqo_0p = 1 - qi_0 * qi_0 - qi_1 * qi_1 - qi_2 * qi_2 - qi_3 * qi_3
    dqo_0 = dqo_0a * qi_3 + (dqo_0c * qi_2 - dqo_0e * qi_1) + qi_0 * dqo_0p
    dqo_1 = dqo_0e * qi_0 - dqo_0a * qi_2 + dqo_0c * qi_3 + qi_1 * dqo_0p
    dqo_2 = dqo_0a * qi_1 - dqo_0c * qi_0 + dqo_0e * qi_3 + qi_2 * dqo_0p
    dqo_3 = qi_3 * dqo_0p - (dqo_0a * qi_0 + dqo_0c * qi_1 + dqo_0e * qi_2)
    return (dqo_0, dqo_1, dqo_2, dqo_3)


@kernel("(4)->(3,3)")
def mat3x3_from_quaternion(q):
    """R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.

    (4)->(3,3).  q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
    20 mul, 16 add, 1 div.  Error <= R: 8 u of its largest component for 2^-450 < |q| < 2^511,
    in single precision 2^-45 < |q| < 2^63; searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    squares_0 = q_3 * q_3
    squares_1 = q_0 * q_0
    squares_2 = q_1 * q_1
    squares_3 = q_2 * q_2
    pairs_0 = squares_0 + squares_1
    pairs_1 = squares_2 + squares_3
    pairs_2 = squares_0 + squares_2
    pairs_3 = squares_1 + squares_3
    pairs_4 = squares_0 + squares_3
    pairs_5 = squares_1 + squares_2
    square = pairs_0 + pairs_1
    factor = 1 / square
    d0 = pairs_0 - pairs_1
    d1 = pairs_2 - pairs_3
    d2 = pairs_4 - pairs_5
    twice = 2 * factor
    m_0a = q_0 * q_1
    m_0b = q_2 * q_3
    m_0 = m_0a - m_0b
    m_1a = q_0 * q_2
    m_1b = q_1 * q_3
    m_1 = m_1a + m_1b
    m_2a = q_1 * q_2
    m_2b = q_0 * q_3
    m_2 = m_2a - m_2b
    m_3 = m_0a + m_0b
    m_4 = m_1a - m_1b
    m_5 = m_2b + m_2a
    R_00 = factor * d0
    R_01 = twice * m_0
    R_02 = twice * m_1
    R_10 = twice * m_3
    R_11 = factor * d1
    R_12 = twice * m_2
    R_20 = twice * m_4
    R_21 = twice * m_5
    R_22 = factor * d2
    return (R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22)


@kernel("(3,3)->(4)")
def quaternion_from_mat3x3(R):
    """qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.

    (3,3)->(4).  R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
    4 mul, 17 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select.  Error <= qo: 6 u of its largest
    component for R a rotation; searched, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    p_0 = R_21 - R_12
    p_1 = R_02 - R_20
    p_2 = R_10 - R_01
    s_0 = R_12 + R_21
    s_1 = R_02 + R_20
    s_2 = R_01 + R_10
    first_0 = R_00 + 1
    first_1 = 1 - R_00
    others_0 = R_11 + R_22
    others_1 = R_11 - R_22
    d_0 = first_0 + others_0
    d_1 = first_0 - others_0
    d_2 = first_1 + others_1
    d_3 = first_1 - others_1
    low_0a = R_11 < R_00
    low_0 = where(low_0a, d_1, s_2)
    low_1 = where(low_0a, s_2, d_2)
    low_2 = where(low_0a, s_1, s_0)
    low_3 = where(low_0a, p_0, p_1)
    high_0b = R_00 < -R_11
    high_0 = where(high_0b, s_1, p_0)
    high_1 = where(high_0b, s_0, p_1)
    high_2 = where(high_0b, d_3, p_2)
    high_3 = where(high_0b, p_2, d_0)
    column_0a = R_22 < 0
    column_0 = where(column_0a, low_0, high_0)
    column_1 = where(column_0a, low_1, high_1)
    column_2 = where(column_0a, low_2, high_2)
    column_3 = where(column_0a, low_3, high_3)
    upper_0b = column_3 < 0
    upper_0 = where(upper_0b, -column_0, column_0)
    upper_1 = where(upper_0b, -column_1, column_1)
    upper_2 = where(upper_0b, -column_2, column_2)
    upper_3 = where(upper_0b, -column_3, column_3)
    length = sqrt(upper_0 * upper_0 + upper_1 * upper_1 + upper_2 * upper_2 + upper_3 * upper_3)
    qo_0 = upper_0 / length
    qo_1 = upper_1 / length
    qo_2 = upper_2 / length
    qo_3 = upper_3 / length
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(3),()->(4)")
def quaternion_from_axis_angle(axis, angle):
    """qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
    rotation is by another angle.

    (3),()->(4).  axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
    32 mul, 33 add, 1 abs.  Error <= qo: 3 u of its largest component for |axis| = 1; searched,
    not proved.
    """
    axis_0, axis_1, axis_2 = axis
    half = 0.5 * angle
    sine, qo_3 = elementary.sincos(half)
    qo_0 = axis_0 * sine
    qo_1 = axis_1 * sine
    qo_2 = axis_2 * sine
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4)->(),(3)")
def axis_angle_from_quaternion(q):
    """angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
    angle is 0; any multiple of a quaternion.

    (4)->(),(3).  q: quaternion (x, y, z, w), the scalar last; angle: number; axis: vector.
    41 mul, 37 add, 4 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 32 select.  Error
    <= angle: 6 u, axis: 4 u of its largest component; searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    scaled_s_0 = q_0 * s
    scaled_s_1 = q_1 * s
    scaled_s_2 = q_2 * s
    scaled_s_3 = q_3 * s
    upper_0b = scaled_s_3 < 0
    upper_0 = where(upper_0b, -scaled_s_0, scaled_s_0)
    upper_1 = where(upper_0b, -scaled_s_1, scaled_s_1)
    upper_2 = where(upper_0b, -scaled_s_2, scaled_s_2)
    upper_3 = where(upper_0b, -scaled_s_3, scaled_s_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s = where(v_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301,
        where(v_s_largest2 < 256, real(1.3093562431584567e+151), real(1)))
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r = where(1.3093562431584567e+151 < v_s, 9.332636185032189e-302, where(1 < v_s,
        real(7.637340908749012e-152), real(1)))
    n = v_n * v_r
    half = elementary.atan2(n, upper_3)
    divisor_a = v_n == 0
    divisor = where(divisor_a, 1, v_n)
    unit_0 = v_y_0 / divisor
    unit_1 = v_y_1 / divisor
    unit_2 = v_y_2 / divisor
    angle = 2 * half
    axis_0 = where(divisor_a, 1, unit_0)
    return (angle, axis_0, unit_1, unit_2)


@kernel("(3)->(4)")
def quaternion_exp(v):
    """qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.

    (3)->(4).  v: vector; qo: quaternion (x, y, z, w), the scalar last.
    71 mul, 86 add, 2 div, 1 sqrt, 5 abs, 2 less, 6 select.  Error <= qo: (7 + θ/200) u of its
    largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    h_0 = 0.5 * v_0
    h_1 = 0.5 * v_1
    h_2 = 0.5 * v_2
    size_0 = absolute(h_0)
    size_1 = absolute(h_1)
    size_2 = absolute(h_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 268435456
    shifted_0 = h_0 + grid
    shifted_1 = h_1 + grid
    shifted_2 = h_2 + grid
    high_0 = shifted_0 - grid
    high_1 = shifted_1 - grid
    high_2 = shifted_2 - grid
    low_0 = h_0 - high_0
    low_1 = h_1 - high_1
    low_2 = h_2 - high_2
    sum_0 = h_0 + high_0
    sum_1 = h_1 + high_1
    sum_2 = h_2 + high_2
    squares = high_0 * high_0 + high_1 * high_1 + high_2 * high_2
    cross = low_0 * sum_0 + low_1 * sum_1 + low_2 * sum_2
    x = squares + cross
    theta_b = x < 1
    theta = where(theta_b, 1, sqrt(x))
    theta_shifted = grid + theta
    theta_high = theta_shifted - grid
    theta_low = theta - theta_high
    theta_sum = theta + theta_high
    cross_rest = cross - theta_low * theta_sum
    exact = squares - theta_high * theta_high
    residual = cross_rest + exact
    small = 0.5 * residual / theta
    delta = where(absolute(small) < 0.0078125, small, 0)
    far_sine_a, far_cosine_a = elementary.sincos(theta)
    far_sine = where(theta_b, 1, far_sine_a)
    far_cosine = where(theta_b, 0, far_cosine_a)
    sine = delta * far_cosine + far_sine
    cosine = far_cosine - delta * far_sine
    far_k = sine / theta
    k_h = (x
        * (x * (x * (6.446950284384474e-26 * x - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15)
    k_q = (x
        * (x
        * (x * (x * (x * k_h - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    k = where(theta_b,
        x * (x * (x * (k_q - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666) +
            1,
        far_k)
    g2h = (x
        * (x * (x * (2.4795962632247976e-27 * x - 1.6117375710961184e-24) + 8.896791392450574e-22)
        - 4.110317623312165e-19) + 1.5619206968586225e-16)
    g2q = (x
        * (x
        * (x * (x * (x * g2h - 4.779477332387385e-14) + 1.1470745597729725e-11)
        - 2.08767569878681e-09) + 2.755731922398589e-07))
    g2 = (x
        * (x * (x * (g2q - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
        + 0.5)
    near = 1 - x * g2
    qo_0 = h_0 * k
    qo_1 = h_1 * k
    qo_2 = h_2 * k
    qo_3 = where(theta_b, near, cosine)
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4)->(3)")
def quaternion_log(q):
    """vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of
    it.

    (4)->(3).  q: quaternion (x, y, z, w), the scalar last; vo: vector.
    44 mul, 37 add, 2 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 31 select.  Error
    <= vo: 6 u of its largest component; searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    scaled_s_0 = q_0 * s
    scaled_s_1 = q_1 * s
    scaled_s_2 = q_2 * s
    scaled_s_3 = q_3 * s
    upper_0b = scaled_s_3 < 0
    upper_0 = where(upper_0b, -scaled_s_0, scaled_s_0)
    upper_1 = where(upper_0b, -scaled_s_1, scaled_s_1)
    upper_2 = where(upper_0b, -scaled_s_2, scaled_s_2)
    upper_3 = where(upper_0b, -scaled_s_3, scaled_s_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s = where(v_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301,
        where(v_s_largest2 < 256, real(1.3093562431584567e+151), real(1)))
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r = where(1.3093562431584567e+151 < v_s, 9.332636185032189e-302, where(1 < v_s,
        real(7.637340908749012e-152), real(1)))
    n = v_n * v_r
    half = elementary.atan2(n, upper_3)
    divisor = where(n == 0, 1, n)
    theta = 2 * half
    k = theta / divisor
    vector_0 = upper_0 * k
    vector_1 = upper_1 * k
    vector_2 = upper_2 * k
    return (vector_0, vector_1, vector_2)


@kernel("(4),(4),()->(4)")
def quaternion_interpolated(q1, q2, k):
    """qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.

    (4),(4),()->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
    142 mul, 147 add, 4 div, 2 sqrt, 5 neg, 10 abs, 2 copysign, 17 less, 2 equal, 33 select.
    Error <= qo: 16 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1;
    searched, not proved.
    """
    q1_0, q1_1, q1_2, q1_3 = q1
    q2_0, q2_1, q2_2, q2_3 = q2
    between_0 = q1_3 * q2_0 - q1_0 * q2_3 + (q1_2 * q2_1 - q1_1 * q2_2)
    between_1 = q1_0 * q2_2 - q1_2 * q2_0 + (q1_3 * q2_1 - q1_1 * q2_3)
    between_2 = q1_1 * q2_0 - q1_0 * q2_1 + (q1_3 * q2_2 - q1_2 * q2_3)
    between_3 = q1_0 * q2_0 + q1_1 * q2_1 + q1_2 * q2_2 + q1_3 * q2_3
    upper_0b = between_3 < 0
    upper_0 = where(upper_0b, -between_0, between_0)
    upper_1 = where(upper_0b, -between_1, between_1)
    upper_2 = where(upper_0b, -between_2, between_2)
    upper_3 = where(upper_0b, -between_3, between_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s_d = where(v_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < v_s_largest2, real(3.7291703656001034e-155), real(1)))
    v_s = where(v_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, v_s_d)
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r_d = where(1 < v_s, 7.637340908749012e-152, where(v_s < 1, real(2.6815615859885194e+154),
        real(1)))
    v_r = where(1.3093562431584567e+151 < v_s, 9.332636185032189e-302, v_r_d)
    n = v_n * v_r
    half = elementary.atan2(n, upper_3)
    divisor = where(n == 0, 1, n)
    rate = half / divisor
    kv_0 = k * upper_0
    kv_1 = k * upper_1
    kv_2 = k * upper_2
    step_0 = rate * kv_0
    step_1 = rate * kv_1
    step_2 = rate * kv_2
    exp_size_0 = absolute(step_0)
    exp_size_1 = absolute(step_1)
    exp_size_2 = absolute(step_2)
    exp_sizes = exp_size_0 + exp_size_1 + exp_size_2
    exp_grid = exp_sizes * 268435456
    exp_shifted_0 = step_0 + exp_grid
    exp_shifted_1 = step_1 + exp_grid
    exp_shifted_2 = step_2 + exp_grid
    exp_high_0 = exp_shifted_0 - exp_grid
    exp_high_1 = exp_shifted_1 - exp_grid
    exp_high_2 = exp_shifted_2 - exp_grid
    exp_low_0 = step_0 - exp_high_0
    exp_low_1 = step_1 - exp_high_1
    exp_low_2 = step_2 - exp_high_2
    exp_sum_0 = step_0 + exp_high_0
    exp_sum_1 = step_1 + exp_high_1
    exp_sum_2 = step_2 + exp_high_2
    exp_squares = exp_high_0 * exp_high_0 + exp_high_1 * exp_high_1 + exp_high_2 * exp_high_2
    exp_cross = exp_low_0 * exp_sum_0 + exp_low_1 * exp_sum_1 + exp_low_2 * exp_sum_2
    exp_x = exp_squares + exp_cross
    exp_theta_b = exp_x < 1
    exp_theta = where(exp_theta_b, 1, sqrt(exp_x))
    exp_theta_shifted = exp_grid + exp_theta
    exp_theta_high = exp_theta_shifted - exp_grid
    exp_theta_low = exp_theta - exp_theta_high
    exp_theta_sum = exp_theta + exp_theta_high
    exp_cross_rest = exp_cross - exp_theta_low * exp_theta_sum
    exp_exact = exp_squares - exp_theta_high * exp_theta_high
    exp_residual = exp_cross_rest + exp_exact
    exp_small = 0.5 * exp_residual / exp_theta
    exp_delta = where(absolute(exp_small) < 0.0078125, exp_small, 0)
    exp_far_sine_a, exp_far_cosine_a = elementary.sincos(exp_theta)
    exp_far_sine = where(exp_theta_b, 1, exp_far_sine_a)
    exp_far_cosine = where(exp_theta_b, 0, exp_far_cosine_a)
    exp_sine = exp_delta * exp_far_cosine + exp_far_sine
    exp_cosine = exp_far_cosine - exp_delta * exp_far_sine
    exp_far_k = exp_sine / exp_theta
    exp_k_g = (exp_x
        * (exp_x
        * (exp_x * (6.446950284384474e-26 * exp_x - 3.868170170630684e-23)
        + 1.9572941063391263e-20) - 8.22063524662433e-18))
    exp_k_n = (exp_x
        * (exp_x * (exp_x * (exp_k_g + 2.8114572543455206e-15) - 7.647163731819816e-13)
        + 1.6059043836821613e-10) - 2.505210838544172e-08)
    exp_k_v = (exp_x
        * (exp_x * (exp_x * (exp_x * exp_k_n + 2.7557319223985893e-06) - 0.0001984126984126984)
        + 0.008333333333333333) - 0.16666666666666666)
    exp_k = where(exp_theta_b, exp_x * exp_k_v + 1, exp_far_k)
    exp_g2g = (exp_x
        * (exp_x
        * (exp_x * (2.4795962632247976e-27 * exp_x - 1.6117375710961184e-24)
        + 8.896791392450574e-22) - 4.110317623312165e-19))
    exp_g2n = (exp_x
        * (exp_x * (exp_x * (exp_g2g + 1.5619206968586225e-16) - 4.779477332387385e-14)
        + 1.1470745597729725e-11) - 2.08767569878681e-09)
    exp_g2v = (exp_x
        * (exp_x * (exp_x * (exp_x * exp_g2n + 2.755731922398589e-07) - 2.48015873015873e-05)
        + 0.001388888888888889) - 0.041666666666666664)
    exp_g2 = exp_x * exp_g2v + 0.5
    exp_near = 1 - exp_x * exp_g2
    power_0 = step_0 * exp_k
    power_1 = step_1 * exp_k
    power_2 = step_2 * exp_k
    power_3 = where(exp_theta_b, exp_near, exp_cosine)
    qo_0 = q1_0 * power_3 + (q1_1 * power_2 - q1_2 * power_1) + q1_3 * power_0
    qo_1 = q1_2 * power_0 - q1_0 * power_2 + q1_1 * power_3 + q1_3 * power_1
    qo_2 = q1_0 * power_1 - q1_1 * power_0 + q1_2 * power_3 + q1_3 * power_2
    qo_3 = q1_3 * power_3 - (q1_0 * power_0 + q1_1 * power_1 + q1_2 * power_2)
    return (qo_0, qo_1, qo_2, qo_3)
