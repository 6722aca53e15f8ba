# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.

In double precision, certified tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(4),()->(4),(4)")
@errstate(all="ignore")
def quaternion_scale(self, a, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (4),()->(4),(4).  self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.
    8 mul, 4 add, 4 abs.
    """
    self_0, self_1, self_2, self_3 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_0_new_bound = c2 * (absolute(self_0_new) + c1)
    self_1_new_bound = c2 * (absolute(self_1_new) + c1)
    self_2_new_bound = c2 * (absolute(self_2_new) + c1)
    self_3_new_bound = c2 * (absolute(self_3_new) + c1)
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_0_new_bound, self_1_new_bound,
        self_2_new_bound, self_3_new_bound)


@kernel("(),(4),(4)->(4),(4)")
@errstate(all="ignore")
def axpy_qq(a, x, y, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """y = a x + y; |error of y| <= y_bound unless inf or NaN.

    (),(4),(4)->(4),(4).  a: number; x, y, y_bound: quaternion (x, y, z, w), the scalar last.
    8 mul, 12 add, 8 abs.
    """
    x_0, x_1, x_2, x_3 = x
    y_0, y_1, y_2, y_3 = y
    y_0_new_a = a * x_0
    y_0_new = y_0_new_a + y_0
    y_1_new_a = a * x_1
    y_1_new = y_1_new_a + y_1
    y_2_new_a = a * x_2
    y_2_new = y_2_new_a + y_2
    y_3_new_a = a * x_3
    y_3_new = y_3_new_a + y_3
    y_0_new_size = absolute(y_0_new_a) + absolute(y_0)
    y_1_new_size = absolute(y_1_new_a) + absolute(y_1)
    y_2_new_size = absolute(y_2_new_a) + absolute(y_2)
    y_3_new_size = absolute(y_3_new_a) + absolute(y_3)
    y_0_new_bound = c2 * (y_0_new_size + c1)
    y_1_new_bound = c2 * (y_1_new_size + c1)
    y_2_new_bound = c2 * (y_2_new_size + c1)
    y_3_new_bound = c2 * (y_3_new_size + c1)
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_0_new_bound, y_1_new_bound, y_2_new_bound,
        y_3_new_bound)


@kernel("(4),(3)->(3),(3)")
@errstate(all="ignore")
def rotate_qv(q, v, *, c1=2.004168360008973e-292, c2=7.7715611723761e-16):
    """vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.

    (4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
    33 mul, 33 add, 13 abs.
    """
    q_0, q_1, q_2, q_3 = q
    v_0, v_1, v_2 = v
    c_0a = q_1 * v_2
    c_0b = q_2 * v_1
    c_0 = c_0a - c_0b
    c_1a = q_2 * v_0
    c_1b = q_0 * v_2
    c_1 = c_1a - c_1b
    c_2a = q_0 * v_1
    c_2b = q_1 * v_0
    c_2 = c_2a - c_2b
    t_0 = 2 * c_0
    t_1 = 2 * c_1
    t_2 = 2 * c_2
    turn_0 = q_1 * t_2 - q_2 * t_1 + q_3 * t_0
    turn_1 = q_2 * t_0 - q_0 * t_2 + q_3 * t_1
    turn_2 = q_0 * t_1 - q_1 * t_0 + q_3 * t_2
    vo_0 = v_0 + turn_0
    vo_1 = v_1 + turn_1
    vo_2 = v_2 + turn_2
    c_0_size = absolute(c_0a) + absolute(c_0b)
    c_1_size = absolute(c_1a) + absolute(c_1b)
    c_2_size = absolute(c_2a) + absolute(c_2b)
    t_0_size = 2 * (c_0_size + c1)
    t_1_size = 2 * (c_1_size + c1)
    t_2_size = 2 * (c_2_size + c1)
    t_2_padded = t_2_size + c1
    q_1_abs = absolute(q_1)
    t_1_padded = t_1_size + c1
    q_2_abs = absolute(q_2)
    t_0_padded = t_0_size + c1
    q_3_abs = absolute(q_3)
    turn_0_size = q_1_abs * t_2_padded + q_2_abs * t_1_padded + q_3_abs * t_0_padded
    q_0_abs = absolute(q_0)
    turn_1_size = q_2_abs * t_0_padded + q_0_abs * t_2_padded + q_3_abs * t_1_padded
    turn_2_size = q_0_abs * t_1_padded + q_1_abs * t_0_padded + q_3_abs * t_2_padded
    vo_0_size = absolute(v_0) + turn_0_size
    vo_1_size = absolute(v_1) + turn_1_size
    vo_2_size = absolute(v_2) + turn_2_size
    vo_0_bound = c2 * (vo_0_size + c1)
    vo_1_bound = c2 * (vo_1_size + c1)
    vo_2_bound = c2 * (vo_2_size + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(4),(3)->(3),(3)")
@errstate(all="ignore")
def rotate_qconjv(q, v, *, c1=2.004168360008973e-292, c2=7.7715611723761e-16):
    """vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.

    (4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.
    33 mul, 33 add, 13 abs.
    """
    q_0, q_1, q_2, q_3 = q
    v_0, v_1, v_2 = v
    c_0a = q_2 * v_1
    c_0b = q_1 * v_2
    c_0 = c_0a - c_0b
    c_1a = q_0 * v_2
    c_1b = q_2 * v_0
    c_1 = c_1a - c_1b
    c_2a = q_1 * v_0
    c_2b = q_0 * v_1
    c_2 = c_2a - c_2b
    t_0 = 2 * c_0
    t_1 = 2 * c_1
    t_2 = 2 * c_2
    turn_0 = q_2 * t_1 - q_1 * t_2 + q_3 * t_0
    turn_1 = q_0 * t_2 - q_2 * t_0 + q_3 * t_1
    turn_2 = q_1 * t_0 - q_0 * t_1 + q_3 * t_2
    vo_0 = v_0 + turn_0
    vo_1 = v_1 + turn_1
    vo_2 = v_2 + turn_2
    c_0_size = absolute(c_0a) + absolute(c_0b)
    c_1_size = absolute(c_1a) + absolute(c_1b)
    c_2_size = absolute(c_2a) + absolute(c_2b)
    t_0_size = 2 * (c_0_size + c1)
    t_1_size = 2 * (c_1_size + c1)
    t_2_size = 2 * (c_2_size + c1)
    t_1_padded = t_1_size + c1
    q_2_abs = absolute(q_2)
    t_2_padded = t_2_size + c1
    q_1_abs = absolute(q_1)
    t_0_padded = t_0_size + c1
    q_3_abs = absolute(q_3)
    turn_0_size = q_2_abs * t_1_padded + q_1_abs * t_2_padded + q_3_abs * t_0_padded
    q_0_abs = absolute(q_0)
    turn_1_size = q_0_abs * t_2_padded + q_2_abs * t_0_padded + q_3_abs * t_1_padded
    turn_2_size = q_1_abs * t_0_padded + q_0_abs * t_1_padded + q_3_abs * t_2_padded
    vo_0_size = absolute(v_0) + turn_0_size
    vo_1_size = absolute(v_1) + turn_1_size
    vo_2_size = absolute(v_2) + turn_2_size
    vo_0_bound = c2 * (vo_0_size + c1)
    vo_1_bound = c2 * (vo_1_size + c1)
    vo_2_bound = c2 * (vo_2_size + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(4),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qq(q1i, q2i, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """qo = q1i q2i; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0a = q1i_0 * q2i_3
    qo_0b = q1i_1 * q2i_2
    qo_0c = q1i_2 * q2i_1
    qo_0f = q1i_3 * q2i_0
    qo_0 = qo_0a + (qo_0b - qo_0c) + qo_0f
    qo_1a = q1i_2 * q2i_0
    qo_1b = q1i_0 * q2i_2
    qo_1d = q1i_1 * q2i_3
    qo_1f = q1i_3 * q2i_1
    qo_1 = qo_1a - qo_1b + qo_1d + qo_1f
    qo_2a = q1i_0 * q2i_1
    qo_2b = q1i_1 * q2i_0
    qo_2d = q1i_2 * q2i_3
    qo_2f = q1i_3 * q2i_2
    qo_2 = qo_2a - qo_2b + qo_2d + qo_2f
    qo_3a = q1i_3 * q2i_3
    qo_3b = q1i_0 * q2i_0
    qo_3c = q1i_1 * q2i_1
    qo_3e = q1i_2 * q2i_2
    qo_3 = qo_3a - (qo_3b + qo_3c + qo_3e)
    qo_0_size = absolute(qo_0a) + (absolute(qo_0b) + absolute(qo_0c)) + absolute(qo_0f)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + absolute(qo_1d) + absolute(qo_1f)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + absolute(qo_2d) + absolute(qo_2f)
    qo_3_size = absolute(qo_3a) + (absolute(qo_3b) + absolute(qo_3c) + absolute(qo_3e))
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qqconj(q1i, q2i, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=4.440892098500628e-16):
    """qo = q1i q2i*; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0a = q1i_0 * q2i_3
    qo_0b = q1i_3 * q2i_0
    qo_0d = q1i_2 * q2i_1
    qo_0e = q1i_1 * q2i_2
    qo_0 = qo_0a - qo_0b + (qo_0d - qo_0e)
    qo_1a = q1i_0 * q2i_2
    qo_1b = q1i_2 * q2i_0
    qo_1d = q1i_1 * q2i_3
    qo_1e = q1i_3 * q2i_1
    qo_1 = qo_1a - qo_1b + (qo_1d - qo_1e)
    qo_2a = q1i_1 * q2i_0
    qo_2b = q1i_0 * q2i_1
    qo_2d = q1i_2 * q2i_3
    qo_2e = q1i_3 * q2i_2
    qo_2 = qo_2a - qo_2b + (qo_2d - qo_2e)
    qo_3a = q1i_0 * q2i_0
    qo_3b = q1i_1 * q2i_1
    qo_3d = q1i_2 * q2i_2
    qo_3f = q1i_3 * q2i_3
    qo_3 = qo_3a + qo_3b + qo_3d + qo_3f
    qo_0_size = absolute(qo_0a) + absolute(qo_0b) + (absolute(qo_0d) + absolute(qo_0e))
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + (absolute(qo_1d) + absolute(qo_1e))
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + (absolute(qo_2d) + absolute(qo_2e))
    qo_3_size = absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d) + absolute(qo_3f)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c3 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qconjq(q1i, q2i, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=4.440892098500628e-16):
    """qo = q1i* q2i; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0a = q1i_3 * q2i_0
    qo_0b = q1i_0 * q2i_3
    qo_0d = q1i_2 * q2i_1
    qo_0e = q1i_1 * q2i_2
    qo_0 = qo_0a - qo_0b + (qo_0d - qo_0e)
    qo_1a = q1i_0 * q2i_2
    qo_1b = q1i_2 * q2i_0
    qo_1d = q1i_3 * q2i_1
    qo_1e = q1i_1 * q2i_3
    qo_1 = qo_1a - qo_1b + (qo_1d - qo_1e)
    qo_2a = q1i_1 * q2i_0
    qo_2b = q1i_0 * q2i_1
    qo_2d = q1i_3 * q2i_2
    qo_2e = q1i_2 * q2i_3
    qo_2 = qo_2a - qo_2b + (qo_2d - qo_2e)
    qo_3a = q1i_0 * q2i_0
    qo_3b = q1i_1 * q2i_1
    qo_3d = q1i_2 * q2i_2
    qo_3f = q1i_3 * q2i_3
    qo_3 = qo_3a + qo_3b + qo_3d + qo_3f
    qo_0_size = absolute(qo_0a) + absolute(qo_0b) + (absolute(qo_0d) + absolute(qo_0e))
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + (absolute(qo_1d) + absolute(qo_1e))
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + (absolute(qo_2d) + absolute(qo_2e))
    qo_3_size = absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d) + absolute(qo_3f)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c3 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qconjqconj(q1i, q2i, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """qo = q1i* q2i*; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0a = q1i_1 * q2i_2
    qo_0b = q1i_2 * q2i_1
    qo_0d = q1i_0 * q2i_3
    qo_0f = q1i_3 * q2i_0
    qo_0 = qo_0a - qo_0b - qo_0d - qo_0f
    qo_1a = q1i_2 * q2i_0
    qo_1b = q1i_0 * q2i_2
    qo_1d = q1i_1 * q2i_3
    qo_1f = q1i_3 * q2i_1
    qo_1 = qo_1a - qo_1b - qo_1d - qo_1f
    qo_2a = q1i_0 * q2i_1
    qo_2b = q1i_1 * q2i_0
    qo_2d = q1i_2 * q2i_3
    qo_2f = q1i_3 * q2i_2
    qo_2 = qo_2a - qo_2b - qo_2d - qo_2f
    qo_3a = q1i_3 * q2i_3
    qo_3b = q1i_0 * q2i_0
    qo_3c = q1i_1 * q2i_1
    qo_3e = q1i_2 * q2i_2
    qo_3 = qo_3a - (qo_3b + qo_3c + qo_3e)
    qo_0_size = absolute(qo_0a) + absolute(qo_0b) + absolute(qo_0d) + absolute(qo_0f)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + absolute(qo_1d) + absolute(qo_1f)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + absolute(qo_2d) + absolute(qo_2f)
    qo_3_size = absolute(qo_3a) + (absolute(qo_3b) + absolute(qo_3c) + absolute(qo_3e))
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qxq(dci, qi, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_3
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a + qo_0b
    qo_1a = dci_1 * qi_1
    qo_1b = dci_0 * qi_2
    qo_1 = qo_1a - qo_1b
    qo_2a = dci_0 * qi_1
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a + qo_2b
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_0
    qo_3 = qo_3a - qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qxqconj(dci, qi, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 1 neg, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_3
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a - qo_0b
    qo_1a = dci_0 * qi_2
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a - qo_1b
    qo_2a = dci_0 * qi_1
    qo_2b = dci_1 * qi_2
    qo_2 = -(qo_2a + qo_2b)
    qo_3a = dci_0 * qi_0
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2c_bound = c2 * (absolute(qo_2a) + absolute(qo_2b) + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2c_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qxconjq(dci, qi, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_1 * qi_0
    qo_0b = dci_0 * qi_3
    qo_0 = qo_0a - qo_0b
    qo_1a = dci_0 * qi_2
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a + qo_1b
    qo_2a = dci_1 * qi_2
    qo_2b = dci_0 * qi_1
    qo_2 = qo_2a - qo_2b
    qo_3a = dci_0 * qi_0
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qxconjqconj(dci, qi, *, c1=2.004168360008973e-292,
        c2=2.2204460492503136e-16):
    """qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 2 neg, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_3
    qo_0b = dci_1 * qi_0
    qo_0 = -(qo_0a + qo_0b)
    qo_1a = dci_0 * qi_2
    qo_1b = dci_1 * qi_1
    qo_1 = -(qo_1a + qo_1b)
    qo_2a = dci_0 * qi_1
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a - qo_2b
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_0
    qo_3 = qo_3a - qo_3b
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0c_bound = c2 * (absolute(qo_0a) + absolute(qo_0b) + c1)
    qo_1c_bound = c2 * (absolute(qo_1a) + absolute(qo_1b) + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_bound, qo_1c_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qqx(qi, dci, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_3 * dci_0
    qo_0 = qo_0a + qo_0b
    qo_1a = qi_1 * dci_1
    qo_1b = qi_2 * dci_0
    qo_1 = qo_1a + qo_1b
    qo_2a = qi_2 * dci_1
    qo_2b = qi_1 * dci_0
    qo_2 = qo_2a - qo_2b
    qo_3a = qi_3 * dci_1
    qo_3b = qi_0 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qqxconj(qi, dci, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_3 * dci_0
    qo_0 = qo_0a - qo_0b
    qo_1a = qi_1 * dci_1
    qo_1b = qi_2 * dci_0
    qo_1 = qo_1a - qo_1b
    qo_2a = qi_1 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a + qo_2b
    qo_3a = qi_0 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qconjqx(qi, dci, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 1 neg, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_3 * dci_0
    qo_0b = qi_0 * dci_1
    qo_0 = qo_0a - qo_0b
    qo_1a = qi_1 * dci_1
    qo_1b = qi_2 * dci_0
    qo_1 = -(qo_1a + qo_1b)
    qo_2a = qi_1 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a - qo_2b
    qo_3a = qi_0 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1c_bound = c2 * (absolute(qo_1a) + absolute(qo_1b) + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1c_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qconjqxconj(qi, dci, *, c1=2.004168360008973e-292,
        c2=2.2204460492503136e-16):
    """qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 2 neg, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_3 * dci_0
    qo_0 = -(qo_0a + qo_0b)
    qo_1a = qi_2 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1 = qo_1a - qo_1b
    qo_2a = qi_1 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = -(qo_2a + qo_2b)
    qo_3a = qi_3 * dci_1
    qo_3b = qi_0 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0c_bound = c2 * (absolute(qo_0a) + absolute(qo_0b) + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2c_bound = c2 * (absolute(qo_2a) + absolute(qo_2b) + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_bound, qo_1_bound, qo_2c_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qyq(dci, qi, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_2
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a + qo_0b
    qo_1a = dci_0 * qi_3
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a + qo_1b
    qo_2a = dci_1 * qi_2
    qo_2b = dci_0 * qi_0
    qo_2 = qo_2a - qo_2b
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_1
    qo_3 = qo_3a - qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qyqconj(dci, qi, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 1 neg, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_2
    qo_0b = dci_1 * qi_0
    qo_0 = -(qo_0a + qo_0b)
    qo_1a = dci_0 * qi_3
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a - qo_1b
    qo_2a = dci_0 * qi_0
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a - qo_2b
    qo_3a = dci_0 * qi_1
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0c_bound = c2 * (absolute(qo_0a) + absolute(qo_0b) + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qyconjq(dci, qi, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_1 * qi_0
    qo_0b = dci_0 * qi_2
    qo_0 = qo_0a - qo_0b
    qo_1a = dci_1 * qi_1
    qo_1b = dci_0 * qi_3
    qo_1 = qo_1a - qo_1b
    qo_2a = dci_0 * qi_0
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a + qo_2b
    qo_3a = dci_0 * qi_1
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qyconjqconj(dci, qi, *, c1=2.004168360008973e-292,
        c2=2.2204460492503136e-16):
    """qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 2 neg, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_2
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a - qo_0b
    qo_1a = dci_0 * qi_3
    qo_1b = dci_1 * qi_1
    qo_1 = -(qo_1a + qo_1b)
    qo_2a = dci_0 * qi_0
    qo_2b = dci_1 * qi_2
    qo_2 = -(qo_2a + qo_2b)
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_1
    qo_3 = qo_3a - qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1c_bound = c2 * (absolute(qo_1a) + absolute(qo_1b) + c1)
    qo_2c_bound = c2 * (absolute(qo_2a) + absolute(qo_2b) + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1c_bound, qo_2c_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qqy(qi, dci, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_2 * dci_0
    qo_0 = qo_0a - qo_0b
    qo_1a = qi_1 * dci_1
    qo_1b = qi_3 * dci_0
    qo_1 = qo_1a + qo_1b
    qo_2a = qi_0 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a + qo_2b
    qo_3a = qi_3 * dci_1
    qo_3b = qi_1 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qqyconj(qi, dci, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_2 * dci_0
    qo_0 = qo_0a + qo_0b
    qo_1a = qi_1 * dci_1
    qo_1b = qi_3 * dci_0
    qo_1 = qo_1a - qo_1b
    qo_2a = qi_2 * dci_1
    qo_2b = qi_0 * dci_0
    qo_2 = qo_2a - qo_2b
    qo_3a = qi_1 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qconjqy(qi, dci, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 1 neg, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_2 * dci_0
    qo_0b = qi_0 * dci_1
    qo_0 = qo_0a - qo_0b
    qo_1a = qi_3 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1 = qo_1a - qo_1b
    qo_2a = qi_0 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = -(qo_2a + qo_2b)
    qo_3a = qi_1 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2c_bound = c2 * (absolute(qo_2a) + absolute(qo_2b) + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2c_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qconjqyconj(qi, dci, *, c1=2.004168360008973e-292,
        c2=2.2204460492503136e-16):
    """qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 2 neg, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_2 * dci_0
    qo_0 = -(qo_0a + qo_0b)
    qo_1a = qi_1 * dci_1
    qo_1b = qi_3 * dci_0
    qo_1 = -(qo_1a + qo_1b)
    qo_2a = qi_0 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a - qo_2b
    qo_3a = qi_3 * dci_1
    qo_3b = qi_1 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0c_bound = c2 * (absolute(qo_0a) + absolute(qo_0b) + c1)
    qo_1c_bound = c2 * (absolute(qo_1a) + absolute(qo_1b) + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_bound, qo_1c_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qzq(dci, qi, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_1 * qi_0
    qo_0b = dci_0 * qi_1
    qo_0 = qo_0a - qo_0b
    qo_1a = dci_0 * qi_0
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a + qo_1b
    qo_2a = dci_0 * qi_3
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a + qo_2b
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_2
    qo_3 = qo_3a - qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qzqconj(dci, qi, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 1 neg, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_1
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a - qo_0b
    qo_1a = dci_0 * qi_0
    qo_1b = dci_1 * qi_1
    qo_1 = -(qo_1a + qo_1b)
    qo_2a = dci_0 * qi_3
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a - qo_2b
    qo_3a = dci_0 * qi_2
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1c_bound = c2 * (absolute(qo_1a) + absolute(qo_1b) + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1c_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qzconjq(dci, qi, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_1
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a + qo_0b
    qo_1a = dci_1 * qi_1
    qo_1b = dci_0 * qi_0
    qo_1 = qo_1a - qo_1b
    qo_2a = dci_1 * qi_2
    qo_2b = dci_0 * qi_3
    qo_2 = qo_2a - qo_2b
    qo_3a = dci_0 * qi_2
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(2),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qzconjqconj(dci, qi, *, c1=2.004168360008973e-292,
        c2=2.2204460492503136e-16):
    """qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    12 mul, 12 add, 2 neg, 8 abs.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_1
    qo_0b = dci_1 * qi_0
    qo_0 = -(qo_0a + qo_0b)
    qo_1a = dci_0 * qi_0
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a - qo_1b
    qo_2a = dci_0 * qi_3
    qo_2b = dci_1 * qi_2
    qo_2 = -(qo_2a + qo_2b)
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_2
    qo_3 = qo_3a - qo_3b
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0c_bound = c2 * (absolute(qo_0a) + absolute(qo_0b) + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2c_bound = c2 * (absolute(qo_2a) + absolute(qo_2b) + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_bound, qo_1_bound, qo_2c_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qqz(qi, dci, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_1 * dci_0
    qo_0 = qo_0a + qo_0b
    qo_1a = qi_1 * dci_1
    qo_1b = qi_0 * dci_0
    qo_1 = qo_1a - qo_1b
    qo_2a = qi_2 * dci_1
    qo_2b = qi_3 * dci_0
    qo_2 = qo_2a + qo_2b
    qo_3a = qi_3 * dci_1
    qo_3b = qi_2 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qqzconj(qi, dci, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_1 * dci_0
    qo_0 = qo_0a - qo_0b
    qo_1a = qi_0 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1 = qo_1a + qo_1b
    qo_2a = qi_2 * dci_1
    qo_2b = qi_3 * dci_0
    qo_2 = qo_2a - qo_2b
    qo_3a = qi_2 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qconjqz(qi, dci, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 1 neg, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_1 * dci_0
    qo_0 = -(qo_0a + qo_0b)
    qo_1a = qi_0 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1 = qo_1a - qo_1b
    qo_2a = qi_3 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a - qo_2b
    qo_3a = qi_2 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_1_size = absolute(qo_1a) + absolute(qo_1b)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0c_bound = c2 * (absolute(qo_0a) + absolute(qo_0b) + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(2)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qconjqzconj(qi, dci, *, c1=2.004168360008973e-292,
        c2=2.2204460492503136e-16):
    """qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=
    qo_bound unless inf or NaN.

    (4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,
    cos θ).
    12 mul, 12 add, 2 neg, 8 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_1 * dci_0
    qo_0b = qi_0 * dci_1
    qo_0 = qo_0a - qo_0b
    qo_1a = qi_0 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1 = -(qo_1a + qo_1b)
    qo_2a = qi_2 * dci_1
    qo_2b = qi_3 * dci_0
    qo_2 = -(qo_2a + qo_2b)
    qo_3a = qi_3 * dci_1
    qo_3b = qi_2 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_0_size = absolute(qo_0a) + absolute(qo_0b)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1c_bound = c2 * (absolute(qo_1a) + absolute(qo_1b) + c1)
    qo_2c_bound = c2 * (absolute(qo_2a) + absolute(qo_2b) + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1c_bound, qo_2c_bound, qo_3_bound)


@kernel("(4),(3)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qv(qi, vi, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """qo = qi (vi; 0); |error of qo| <= qo_bound unless inf or NaN.

    (4),(3)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
    16 mul, 20 add, 1 neg, 12 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    vi_0, vi_1, vi_2 = vi
    qo_0a = qi_1 * vi_2
    qo_0b = qi_2 * vi_1
    qo_0d = qi_3 * vi_0
    qo_0 = qo_0a - qo_0b + qo_0d
    qo_1a = qi_2 * vi_0
    qo_1b = qi_0 * vi_2
    qo_1d = qi_3 * vi_1
    qo_1 = qo_1a - qo_1b + qo_1d
    qo_2a = qi_0 * vi_1
    qo_2b = qi_1 * vi_0
    qo_2d = qi_3 * vi_2
    qo_2 = qo_2a - qo_2b + qo_2d
    qo_3a = qi_0 * vi_0
    qo_3b = qi_1 * vi_1
    qo_3d = qi_2 * vi_2
    qo_3 = -(qo_3a + qo_3b + qo_3d)
    qo_0_size = absolute(qo_0a) + absolute(qo_0b) + absolute(qo_0d)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + absolute(qo_1d)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + absolute(qo_2d)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3e_bound = c2 * (absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d) + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3e_bound)


@kernel("(4),(3)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_qconjv(qi, vi, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """qo = qi* (vi; 0); |error of qo| <= qo_bound unless inf or NaN.

    (4),(3)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.
    16 mul, 20 add, 12 abs.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    vi_0, vi_1, vi_2 = vi
    qo_0a = qi_2 * vi_1
    qo_0b = qi_1 * vi_2
    qo_0d = qi_3 * vi_0
    qo_0 = qo_0a - qo_0b + qo_0d
    qo_1a = qi_0 * vi_2
    qo_1b = qi_2 * vi_0
    qo_1d = qi_3 * vi_1
    qo_1 = qo_1a - qo_1b + qo_1d
    qo_2a = qi_1 * vi_0
    qo_2b = qi_0 * vi_1
    qo_2d = qi_3 * vi_2
    qo_2 = qo_2a - qo_2b + qo_2d
    qo_3a = qi_0 * vi_0
    qo_3b = qi_1 * vi_1
    qo_3d = qi_2 * vi_2
    qo_3 = qo_3a + qo_3b + qo_3d
    qo_0_size = absolute(qo_0a) + absolute(qo_0b) + absolute(qo_0d)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + absolute(qo_1d)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + absolute(qo_2d)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(3),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_vq(vi, qi, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """qo = (vi; 0) qi; |error of qo| <= qo_bound unless inf or NaN.

    (3),(4)->(4),(4).  vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    16 mul, 20 add, 1 neg, 12 abs.
    """
    vi_0, vi_1, vi_2 = vi
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = vi_0 * qi_3
    qo_0b = vi_1 * qi_2
    qo_0c = vi_2 * qi_1
    qo_0 = qo_0a + (qo_0b - qo_0c)
    qo_1a = vi_2 * qi_0
    qo_1b = vi_0 * qi_2
    qo_1d = vi_1 * qi_3
    qo_1 = qo_1a - qo_1b + qo_1d
    qo_2a = vi_0 * qi_1
    qo_2b = vi_1 * qi_0
    qo_2d = vi_2 * qi_3
    qo_2 = qo_2a - qo_2b + qo_2d
    qo_3a = vi_0 * qi_0
    qo_3b = vi_1 * qi_1
    qo_3d = vi_2 * qi_2
    qo_3 = -(qo_3a + qo_3b + qo_3d)
    qo_0_size = absolute(qo_0a) + (absolute(qo_0b) + absolute(qo_0c))
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + absolute(qo_1d)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + absolute(qo_2d)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3e_bound = c2 * (absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d) + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3e_bound)


@kernel("(3),(4)->(4),(4)")
@errstate(all="ignore")
def quaternion_product_vqconj(vi, qi, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """qo = (vi; 0) qi*; |error of qo| <= qo_bound unless inf or NaN.

    (3),(4)->(4),(4).  vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    16 mul, 20 add, 12 abs.
    """
    vi_0, vi_1, vi_2 = vi
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = vi_0 * qi_3
    qo_0b = vi_2 * qi_1
    qo_0c = vi_1 * qi_2
    qo_0 = qo_0a + (qo_0b - qo_0c)
    qo_1a = vi_0 * qi_2
    qo_1b = vi_2 * qi_0
    qo_1d = vi_1 * qi_3
    qo_1 = qo_1a - qo_1b + qo_1d
    qo_2a = vi_1 * qi_0
    qo_2b = vi_0 * qi_1
    qo_2d = vi_2 * qi_3
    qo_2 = qo_2a - qo_2b + qo_2d
    qo_3a = vi_0 * qi_0
    qo_3b = vi_1 * qi_1
    qo_3d = vi_2 * qi_2
    qo_3 = qo_3a + qo_3b + qo_3d
    qo_0_size = absolute(qo_0a) + (absolute(qo_0b) + absolute(qo_0c))
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + absolute(qo_1d)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + absolute(qo_2d)
    qo_3_size = absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d)
    qo_0_bound = c2 * (qo_0_size + c1)
    qo_1_bound = c2 * (qo_1_size + c1)
    qo_2_bound = c2 * (qo_2_size + c1)
    qo_3_bound = c2 * (qo_3_size + c1)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_bound, qo_1_bound, qo_2_bound, qo_3_bound)


@kernel("(4),(4)->(),()")
@errstate(all="ignore")
def dot_qq(q1i, q2i, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """q1i·q2i; |error of dot| <= dot_bound unless inf or NaN.

    (4),(4)->(),().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot, dot_bound: number.
    5 mul, 7 add, 4 abs.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    dot_a = q1i_0 * q2i_0
    dot_b = q1i_1 * q2i_1
    dot_d = q1i_2 * q2i_2
    dot_f = q1i_3 * q2i_3
    dot = dot_a + dot_b + dot_d + dot_f
    dot_size = absolute(dot_a) + absolute(dot_b) + absolute(dot_d) + absolute(dot_f)
    dot_bound = c2 * (dot_size + c1)
    return (dot, dot_bound)


@kernel("(3),(4)->(4),(4)")
@errstate(all="ignore")
def add_dpiToq(dpi, qi, *, c1=2.004168360008973e-292, c2=5.551115123125785e-16):
    """qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
    first order; not normalized; |error of qi| <= qi_bound unless inf or NaN.

    (3),(4)->(4),(4).  dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
    31 mul, 31 add, 7 abs.
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
    qi_0_new_a_padded = absolute(qi_0_new_a) + c1
    qi_3_abs = absolute(qi_3)
    qi_0_new_c_padded = absolute(qi_0_new_c) + c1
    qi_1_abs = absolute(qi_1)
    qi_0_new_e_padded = absolute(qi_0_new_e) + c1
    qi_2_abs = absolute(qi_2)
    qi_0_abs = absolute(qi_0)
    qi_0_new_size = (qi_0_new_a_padded * qi_3_abs
        + (qi_0_new_c_padded * qi_1_abs + qi_0_new_e_padded * qi_2_abs) + qi_0_abs)
    qi_1_new_size = (qi_0_new_a_padded * qi_2_abs + qi_0_new_c_padded * qi_0_abs
        + qi_0_new_e_padded * qi_3_abs + qi_1_abs)
    qi_2_new_size = (qi_0_new_e_padded * qi_0_abs + qi_0_new_a_padded * qi_1_abs
        + qi_0_new_c_padded * qi_3_abs + qi_2_abs)
    qi_3_new_size = (qi_3_abs
        + (qi_0_new_a_padded * qi_0_abs + qi_0_new_e_padded * qi_1_abs + qi_0_new_c_padded
        * qi_2_abs))
    qi_0_new_bound = c2 * (qi_0_new_size + c1)
    qi_1_new_bound = c2 * (qi_1_new_size + c1)
    qi_2_new_bound = c2 * (qi_2_new_size + c1)
    qi_3_new_bound = c2 * (qi_3_new_size + c1)
    return (qi_0_new, qi_1_new, qi_2_new, qi_3_new, qi_0_new_bound, qi_1_new_bound, qi_2_new_bound,
        qi_3_new_bound)


@kernel("(3),(4)->(4),(4)")
@errstate(all="ignore")
def subtract_dpiFromq(dpi, qi, *, c1=2.004168360008973e-292, c2=5.551115123125785e-16):
    """qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order; |error of qi| <=
    qi_bound unless inf or NaN.

    (3),(4)->(4),(4).  dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.
    31 mul, 31 add, 7 abs.
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
    qi_0_new_a_padded = absolute(qi_0_new_a) + c1
    qi_2_abs = absolute(qi_2)
    qi_0_new_c_padded = absolute(qi_0_new_c) + c1
    qi_1_abs = absolute(qi_1)
    qi_0_new_f_padded = absolute(qi_0_new_f) + c1
    qi_3_abs = absolute(qi_3)
    qi_0_abs = absolute(qi_0)
    qi_0_new_size = (qi_0_new_a_padded * qi_2_abs + qi_0_new_c_padded * qi_1_abs
        + qi_0_new_f_padded * qi_3_abs + qi_0_abs)
    qi_1_new_size = (qi_0_new_c_padded * qi_0_abs + qi_0_new_f_padded * qi_2_abs
        + qi_0_new_a_padded * qi_3_abs + qi_1_abs)
    qi_2_new_size = (qi_0_new_f_padded * qi_1_abs + qi_0_new_a_padded * qi_0_abs
        + qi_0_new_c_padded * qi_3_abs + qi_2_abs)
    qi_3_new_size = (qi_0_new_f_padded * qi_0_abs + qi_0_new_a_padded * qi_1_abs
        + qi_0_new_c_padded * qi_2_abs + qi_3_abs)
    qi_0_new_bound = c2 * (qi_0_new_size + c1)
    qi_1_new_bound = c2 * (qi_1_new_size + c1)
    qi_2_new_bound = c2 * (qi_2_new_size + c1)
    qi_3_new_bound = c2 * (qi_3_new_size + c1)
    return (qi_0_new, qi_1_new, qi_2_new, qi_3_new, qi_0_new_bound, qi_1_new_bound, qi_2_new_bound,
        qi_3_new_bound)


@kernel("(3),(4)->(4),(4)")
@errstate(all="ignore")
def omega_to_dquaternion(w, qi, *, c1=2.004168360008973e-292, c2=7.7715611723761e-16):
    """dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
    reference frame, rad/s, and a term that draws its norm to 1; |error of dqo| <= dqo_bound
    unless inf or NaN.

    (3),(4)->(4),(4).  w: vector; qi, dqo, dqo_bound: quaternion (x, y, z, w), the scalar last.
    43 mul, 40 add, 11 abs.
    """
    w_0, w_1, w_2 = w
    qi_0, qi_1, qi_2, qi_3 = qi
    dqo_0a = 0.5 * w_0
    dqo_0c = 0.5 * w_1
    dqo_0e = 0.5 * w_2
    dqo_0i = qi_0 * qi_0
    dqo_0k = qi_1 * qi_1
    dqo_0m = qi_2 * qi_2
    dqo_0o = qi_3 * qi_3
    dqo_0p = 1 - dqo_0i - dqo_0k - dqo_0m - dqo_0o
    dqo_0 = dqo_0a * qi_3 + (dqo_0c * qi_2 - dqo_0e * qi_1) + qi_0 * dqo_0p
    dqo_1 = dqo_0e * qi_0 - dqo_0a * qi_2 + dqo_0c * qi_3 + qi_1 * dqo_0p
    dqo_2 = dqo_0a * qi_1 - dqo_0c * qi_0 + dqo_0e * qi_3 + qi_2 * dqo_0p
    dqo_3 = qi_3 * dqo_0p - (dqo_0a * qi_0 + dqo_0c * qi_1 + dqo_0e * qi_2)
    dqo_0a_padded = absolute(dqo_0a) + c1
    qi_3_abs = absolute(qi_3)
    dqo_0c_padded = absolute(dqo_0c) + c1
    qi_2_abs = absolute(qi_2)
    dqo_0e_padded = absolute(dqo_0e) + c1
    qi_1_abs = absolute(qi_1)
    dqo_0p_padded = (1 + absolute(dqo_0i) + absolute(dqo_0k) + absolute(dqo_0m) + absolute(dqo_0o)
        + c1)
    qi_0_abs = absolute(qi_0)
    dqo_0_size = (dqo_0a_padded * qi_3_abs + (dqo_0c_padded * qi_2_abs + dqo_0e_padded * qi_1_abs)
        + qi_0_abs * dqo_0p_padded)
    dqo_1_size = (dqo_0e_padded * qi_0_abs + dqo_0a_padded * qi_2_abs + dqo_0c_padded * qi_3_abs
        + qi_1_abs * dqo_0p_padded)
    dqo_2_size = (dqo_0a_padded * qi_1_abs + dqo_0c_padded * qi_0_abs + dqo_0e_padded * qi_3_abs
        + qi_2_abs * dqo_0p_padded)
    dqo_3_size = (qi_3_abs * dqo_0p_padded
        + (dqo_0a_padded * qi_0_abs + dqo_0c_padded * qi_1_abs + dqo_0e_padded * qi_2_abs))
    dqo_0_bound = c2 * (dqo_0_size + c1)
    dqo_1_bound = c2 * (dqo_1_size + c1)
    dqo_2_bound = c2 * (dqo_2_size + c1)
    dqo_3_bound = c2 * (dqo_3_size + c1)
    return (dqo_0, dqo_1, dqo_2, dqo_3, dqo_0_bound, dqo_1_bound, dqo_2_bound, dqo_3_bound)


@kernel("(3),()->(4),(4)")
@errstate(all="ignore")
def quaternion_from_axis_angle(axis, angle, *, c1=1.8051943758648296e-276,
        c2=4.3017579231195054e-30, c3=4.067564442213936e-30):
    """qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
    rotation is by another angle; |error of qo| <= qo_bound unless inf or NaN.

    (3),()->(4),(4).  axis: vector; angle: number; qo, qo_bound: quaternion (x, y, z, w), the
    scalar last.
    98 mul, 139 add, 14 product error, 1 div, 11 abs, 1 less, 1 select.
    """
    axis_0, axis_1, axis_2 = axis
    half = 0.5 * angle
    sine, qo_3 = elementary.sincos(half)
    sine_own_error_1, qo_own_error_1 = elementary.sincos_error(half, sine, qo_3)
    sine_size_1 = 1 + (c1 + 0.5 * absolute(angle))
    qo_0 = axis_0 * sine
    qo_1 = axis_1 * sine
    qo_2 = axis_2 * sine
    qo_bound_1 = (absolute(product_error(axis_0, sine, qo_0) + axis_0 * sine_own_error_1) + c2
        * (c1 + absolute(axis_0) * sine_size_1))
    qo_bound_2 = (absolute(product_error(axis_1, sine, qo_1) + axis_1 * sine_own_error_1) + c2
        * (c1 + absolute(axis_1) * sine_size_1))
    qo_bound_3 = (absolute(product_error(axis_2, sine, qo_2) + axis_2 * sine_own_error_1) + c2
        * (c1 + absolute(axis_2) * sine_size_1))
    qo_bound_4 = absolute(qo_own_error_1) + c3 * sine_size_1
    return (qo_0, qo_1, qo_2, qo_3, qo_bound_1, qo_bound_2, qo_bound_3, qo_bound_4)


@kernel("(4)->(),(3),(),(3)")
@errstate(all="ignore")
def axis_angle_from_quaternion(q, *, c1=6.703903964971299e+153, c2=3.7291703656001034e-155,
        c3=1.3093562431584567e+151, c4=1.955159272639747e-149, c5=1.0715086071862673e+301, c6=5e-324,
        c7=1.8051943758648296e-276, c8=1.1093356479670522e-31, c9=3.169126500570585e+29,
        c10=3.4142893812359766e-30, c11=140737488355328, c12=7.235336013082471e-30,
        c13=1.5970396877936164e+29, c14=7.637340908749012e-152, c15=9.332636185032189e-302,
        c16=6.859394487938082e-30, c17=3.254051621949822e-30, c18=4.875578158636172e+28,
        c19=6.606712056056508e-30, c20=9.054644677292507e+28, c21=1.1389183198259759e-29,
        c22=1.6442825652790928e-29, c23=6.250354999637554e+28, c24=2.1514956353001486e-29,
        c25=1.644282720444347e-29):
    """angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
    angle is 0; any multiple of a quaternion; |error of angle| <= angle_bound, |error of axis|
    <= axis_bound unless inf or NaN.

    (4)->(),(3),(),(3).  q: quaternion (x, y, z, w), the scalar last; angle, angle_bound:
    number; axis, axis_bound: vector.
    201 mul, 318 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 5 neg, 50 abs, 4
    copysign, 35 less, 10 equal, 69 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s = where(s_largest3 < c4, c5, where(s_largest3 < 256, c3, where(c1 < s_largest3, real(c2),
        real(1))))
    scaled_s_0 = q_0 * s
    scaled_s_inverse_1 = 1 / s
    scaled_s_size_4 = absolute(scaled_s_0)
    scaled_s_1 = q_1 * s
    scaled_s_size_8 = absolute(scaled_s_1)
    scaled_s_2 = q_2 * s
    scaled_s_size_12 = absolute(scaled_s_2)
    scaled_s_3 = q_3 * s
    scaled_s_size_15 = where(q_3 == scaled_s_3 * scaled_s_inverse_1, real(0), real(c6))
    scaled_s_size_16 = absolute(scaled_s_3)
    upper_0a = -scaled_s_0
    upper_0b = scaled_s_3 < 0
    upper_0 = where(upper_0b, upper_0a, scaled_s_0)
    upper_size_4 = scaled_s_size_15 < c6 + absolute(scaled_s_3 - 0)
    upper_size_8 = (where(q_0 == scaled_s_0 * scaled_s_inverse_1, real(0), real(c6))
        + (c8 * (c7 + scaled_s_size_4) + absolute(upper_0a - scaled_s_0)))
    upper_1a = -scaled_s_1
    upper_1 = where(upper_0b, upper_1a, scaled_s_1)
    upper_size_15 = (where(q_1 == scaled_s_1 * scaled_s_inverse_1, real(0), real(c6))
        + (c8 * (c7 + scaled_s_size_8) + absolute(upper_1a - scaled_s_1)))
    upper_2a = -scaled_s_2
    upper_2 = where(upper_0b, upper_2a, scaled_s_2)
    upper_size_22 = (where(q_2 == scaled_s_2 * scaled_s_inverse_1, real(0), real(c6))
        + (c8 * (c7 + scaled_s_size_12) + absolute(upper_2a - scaled_s_2)))
    upper_3a = -scaled_s_3
    upper_3 = where(upper_0b, upper_3a, scaled_s_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s_a = v_s_largest2 < 256
    v_s_c = v_s_largest2 < c4
    v_s = where(v_s_c, c5, where(v_s_a, real(c3), real(1)))
    v_s_size_3 = where(v_s_c, c5, where(v_s_a, real(c3), real(1)))
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_a_padded_1 = (c7 + v_s_size_3
        * (c7 + (scaled_s_size_4 + c9 * where(upper_size_4, 0, upper_size_8))))
    v_n_a_size_2 = v_n_a_padded_1 * (absolute(v_y_0) + c11 * (c10 * v_n_a_padded_1))
    v_n_b = v_y_1 * v_y_1
    v_n_b_padded_1 = (c7 + v_s_size_3
        * (c7 + (scaled_s_size_8 + c9 * where(upper_size_4, 0, upper_size_15))))
    v_n_b_size_2 = v_n_b_padded_1 * (absolute(v_y_1) + c11 * (c10 * v_n_b_padded_1))
    v_n_c = v_n_a + v_n_b
    v_n_c_right_1 = v_n_c - v_n_a
    v_n_d = v_y_2 * v_y_2
    v_n_d_padded_1 = (c7 + v_s_size_3
        * (c7 + (scaled_s_size_12 + c9 * where(upper_size_4, 0, upper_size_22))))
    v_n_d_size_2 = v_n_d_padded_1 * (absolute(v_y_2) + c11 * (c10 * v_n_d_padded_1))
    v_n_e = v_n_c + v_n_d
    v_n_e_right_1 = v_n_e - v_n_c
    v_n_c_lo = (product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
        + product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1))
    v_n_e_lo = (v_n_c - (v_n_e - v_n_e_right_1) + product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right_1)
        + v_n_c_lo)
    v_n = sqrt(v_n_e)
    v_n_product_1 = v_n * v_n
    v_n_lo = ((v_n_e - v_n_product_1 - product_error(v_n, v_n, v_n_product_1) + v_n_e_lo)
        / where(v_n == 0, 1, v_n + v_n))
    v_n_padded_1 = (c7
        + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
        + (v_n_d_size_2 + v_n_d_size_2)))
    v_n_bound_1 = absolute(v_n_e_lo) + c12 * v_n_padded_1
    v_n_size_6 = absolute(v_n_lo)
    v_n_size_4 = (absolute(v_n_e) + c11 * v_n_bound_1) * (v_n_padded_1 / v_n / v_n_e)
    v_n_size_12 = (v_n
        + where(4 * v_n_bound_1 < v_n_e, v_n_size_4, c13 * (sqrt(v_n_bound_1) + v_n_size_6)))
    v_r_a = 1 < v_s
    v_r_c = c3 < v_s
    v_r = where(v_r_c, c15, where(v_r_a, real(c14), real(1)))
    n = v_n * v_r
    n_lo = (v_n - n * (1 / v_r) + v_n_lo) * v_r
    n_padded_1 = c7 + v_n_size_12
    half = elementary.atan2(n, upper_3)
    half_size0_1 = absolute(n)
    half_size1_1 = absolute(upper_3)
    half_most_1 = where(half_size0_1 < half_size1_1, half_size1_1, half_size0_1)
    half_zero_1 = half_most_1 == 0
    half_divisor_1 = where(half_zero_1, 1, half_most_1)
    half_part0_1 = n / half_divisor_1
    half_part1_1 = upper_3 / half_divisor_1
    half_safe_1 = where(half_zero_1, 1,
        half_divisor_1 * (half_part1_1 * half_part1_1 + half_part0_1 * half_part0_1))
    half_lo = (elementary.atan2_error(n, upper_3, half) + (half_part1_1 * n_lo - half_part0_1 * 0)
        / half_safe_1)
    half_padded_1 = c7 + n_padded_1 * where(v_r_c, c15, where(v_r_a, real(c14), real(1)))
    upper_size_32 = (scaled_s_size_16 + c9
        * where(upper_size_4, 0, scaled_s_size_15
        + (c8 * (c7 + scaled_s_size_16) + absolute(upper_3a - scaled_s_3))))
    half_padded_2 = c7 + upper_size_32
    half_size_2 = absolute(n)
    half_size_3 = absolute(upper_3)
    half_size_5 = where(half_size_2 < half_size_3, half_size_3, half_size_2)
    half_bound_1 = absolute(n_lo) + c16 * half_padded_1
    half_rest_2 = c17 * half_padded_2
    half_size_11 = (half_rest_2 + (c7 + half_bound_1)) / half_size_5
    half_size_13 = half_size_11 * half_size_11
    half_size_15 = 7 + absolute(half_lo)
    half_size_19 = where(half_bound_1 < half_size_2, half_size_13, where(half_rest_2 < upper_3,
        half_size_13, half_size_15))
    divisor_a = v_n == 0
    divisor = where(divisor_a, 1, v_n)
    divisor_lo = where(divisor_a, 0, v_n_lo)
    divisor_bound_1 = c19 * n_padded_1 + v_n_size_6
    divisor_size_4 = divisor_bound_1 < absolute(v_n - 0)
    unit_0 = v_y_0 / divisor
    unit_product_1 = unit_0 * divisor
    unit_lo_1 = ((v_y_0 - unit_product_1 - product_error(unit_0, divisor, unit_product_1) - unit_0
        * divisor_lo) / divisor)
    unit_padded_1 = (c7
        + (where(divisor_a, 1, v_n_size_12) + c20
        * where(divisor_size_4, 0, divisor_bound_1 + absolute(1 - v_n))))
    unit_size_1 = absolute(unit_0)
    unit_size_2 = absolute(divisor)
    unit_bound_1 = absolute(divisor_lo) + c21 * unit_padded_1
    unit_size_7 = where(4 * unit_bound_1 < unit_size_2, unit_size_2, 0)
    unit_reach_1 = unit_size_2 + c11 * unit_bound_1
    unit_size_11 = (unit_size_1 + unit_reach_1
        * ((unit_padded_1 * unit_size_1 + v_n_a_padded_1) / unit_size_7) / unit_size_2)
    unit_1 = v_y_1 / divisor
    unit_product_2 = unit_1 * divisor
    unit_size_12 = absolute(unit_1)
    unit_2 = v_y_2 / divisor
    unit_product_3 = unit_2 * divisor
    unit_size_19 = absolute(unit_2)
    angle = 2 * half
    axis_0 = where(divisor_a, 1, unit_0)
    axis_size_6 = (c23
        * where(divisor_size_4, 0, absolute(unit_lo_1) + c22 * (c7 + unit_size_11)
        + absolute(1 - unit_0)))
    angle_size_1 = (2
        * (absolute(half) + (half_padded_1 + half_padded_2) / half_size_5 + c18
        * where(half_size_11 < 0.25, half_size_19, half_size_15)))
    unit_rest_5 = (c22
        * (c7
        + (unit_size_12 + unit_reach_1
        * ((unit_padded_1 * unit_size_12 + v_n_b_padded_1) / unit_size_7) / unit_size_2)))
    unit_rest_6 = (c22
        * (c7
        + (unit_size_19 + unit_reach_1
        * ((unit_padded_1 * unit_size_19 + v_n_d_padded_1) / unit_size_7) / unit_size_2)))
    angle_bound_1 = absolute(2 * half_lo) + c24 * (c7 + angle_size_1)
    axis_bound_2 = (absolute(where(divisor_a, 0, unit_lo_1)) + c25
        * (c7 + (where(divisor_a, 1, unit_size_11) + axis_size_6)))
    unit_bound_2 = (absolute((v_y_1 - unit_product_2
        - product_error(unit_1, divisor, unit_product_2) - unit_1 * divisor_lo) / divisor)
        + unit_rest_5)
    unit_bound_3 = (absolute((v_y_2 - unit_product_3
        - product_error(unit_2, divisor, unit_product_3) - unit_2 * divisor_lo) / divisor)
        + unit_rest_6)
    return (angle, axis_0, unit_1, unit_2, angle_bound_1, axis_bound_2, unit_bound_2, unit_bound_3)


@kernel("(3)->(4),(4)")
@errstate(all="ignore")
def quaternion_exp(v, *, c1=268435456, c2=1.8051943758648296e-276, c3=1.2325953113446296e-31,
        c4=6.703903964971299e+153, c5=3.7291703656001034e-155, c6=2.6815615859885194e+154,
        c7=3.229399894985818e-30, c8=140737488355328, c9=2.0056767005853705e+29,
        c10=5.7192432555642225e-30, c11=5e-324, c12=5.762046184631807e+28, c13=1.789728954546449e-29,
        c14=9.25185853854297e-18, c15=2290649224.7000003, c16=8.201505264386605e-28,
        c17=2.755262189115544e-29, c18=1.2206826306780646e+27, c19=8.201506228291972e-28,
        c20=1.0000000000000009, c21=8.21414129263252e-28, c22=1.0551017099379097e-29):
    """qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v; |error
    of qo| <= qo_bound unless inf or NaN.

    (3)->(4),(4).  v: vector; qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    266 mul, 346 add, 17 product error, 4 product rest, 11 div, 3 sqrt, 37 abs, 11 less, 1
    equal, 24 select.
    """
    v_0, v_1, v_2 = v
    h_0 = 0.5 * v_0
    h_1 = 0.5 * v_1
    h_2 = 0.5 * v_2
    size_0 = absolute(h_0)
    size_1 = absolute(h_1)
    size_2 = absolute(h_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * c1
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
    fine_h_0 = 0.5 * v_0
    fine_h_1 = 0.5 * v_1
    fine_h_2 = 0.5 * v_2
    h_size_0 = absolute(fine_h_0)
    h_size_padded_1 = c2 + 0.5 * absolute(v_0)
    h_size_1 = absolute(fine_h_1)
    h_size_padded_2 = c2 + 0.5 * absolute(v_1)
    h_size_2 = absolute(fine_h_2)
    h_size_padded_3 = c2 + 0.5 * absolute(v_2)
    h_largest1 = where(h_size_0 < h_size_1, h_size_1, h_size_0)
    h_largest2 = where(h_largest1 < h_size_2, h_size_2, h_largest1)
    s_a = c4 < h_largest2
    s = where(s_a, real(c5), real(1))
    s_size_1 = where(s_a, real(c5), real(1))
    reduced_0 = fine_h_0 * s
    reduced_1 = fine_h_1 * s
    reduced_2 = fine_h_2 * s
    up_a = s < 1
    up = where(up_a, real(c6), real(1))
    reduced_length_a = reduced_0 * reduced_0
    reduced_length_a_padded_1 = c2 + h_size_padded_1 * s_size_1
    reduced_length_b = reduced_1 * reduced_1
    reduced_length_b_padded_1 = c2 + h_size_padded_2 * s_size_1
    reduced_length_c = reduced_length_a + reduced_length_b
    reduced_length_c_right_1 = reduced_length_c - reduced_length_a
    reduced_length_c_left_rest_1 = product_rest(reduced_0, reduced_0, reduced_length_a,
        reduced_length_c - reduced_length_c_right_1)
    reduced_length_d = reduced_2 * reduced_2
    reduced_length_d_padded_1 = c2 + h_size_padded_3 * s_size_1
    reduced_length_e = reduced_length_c + reduced_length_d
    reduced_length_e_right_1 = reduced_length_e - reduced_length_c
    reduced_length_e_right_rest_1 = product_rest(reduced_2, reduced_2, reduced_length_d,
        reduced_length_e_right_1)
    reduced_length_c_lo = (reduced_length_c_left_rest_1
        + product_rest(reduced_1, reduced_1, reduced_length_b, reduced_length_c_right_1))
    reduced_length_e_lo = (reduced_length_c - (reduced_length_e - reduced_length_e_right_1)
        + reduced_length_e_right_rest_1 + reduced_length_c_lo)
    reduced_length_c_size_1 = (reduced_length_a_padded_1 * reduced_length_a_padded_1
        + reduced_length_b_padded_1 * reduced_length_b_padded_1)
    reduced_length = sqrt(reduced_length_e)
    reduced_length_product_1 = reduced_length * reduced_length
    reduced_length_exact_1 = (reduced_length_e - reduced_length_product_1
        - product_error(reduced_length, reduced_length, reduced_length_product_1))
    reduced_length_lo = ((reduced_length_exact_1 + reduced_length_e_lo)
        / where(reduced_length == 0, 1, reduced_length + reduced_length))
    reduced_length_padded_1 = (c2
        + (reduced_length_c_size_1 + reduced_length_d_padded_1 * reduced_length_d_padded_1))
    reduced_length_bound_1 = absolute(reduced_length_e_lo) + c7 * reduced_length_padded_1
    reduced_length_size_4 = ((absolute(reduced_length_e) + c8 * reduced_length_bound_1)
        * (reduced_length_padded_1 / reduced_length / reduced_length_e))
    reduced_length_size_8 = c9 * (sqrt(reduced_length_bound_1) + absolute(reduced_length_lo))
    half_angle = reduced_length * up
    half_angle_lo = (reduced_length - half_angle * (1 / up) + reduced_length_lo) * up
    half_angle_padded_1 = (c2
        + (reduced_length
        + where(4 * reduced_length_bound_1
        < reduced_length_e, reduced_length_size_4, reduced_length_size_8)))
    half_angle_size_1 = half_angle_padded_1 * where(up_a, real(c6), real(1))
    y = half_angle * half_angle
    y_padded_1 = c2 + half_angle_size_1
    y_bound_1 = absolute(half_angle_lo) + c10 * y_padded_1
    y_size_2 = y_padded_1 * (absolute(half_angle) + c8 * y_bound_1)
    fine_sine, c = elementary.sincos(half_angle)
    fine_sine_own_error_1, c_own_error_1 = elementary.sincos_error(half_angle, fine_sine, c)
    fine_sine_half_1 = half_angle_lo * 0.5
    fine_sine_half_sin_1, fine_sine_half_cos_1 = elementary.sincos(fine_sine_half_1)
    fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_divisor_lo = where(sinc_divisor_a, 0, half_angle_lo)
    sinc_divisor_size_5 = y_bound_1 < c11 + absolute(half_angle - 1.4901161193847656e-08)
    sinc_divisor_size_10 = (c12
        * where(sinc_divisor_size_5, 0, absolute(1.4901161193847656e-08 - half_angle) + y_bound_1))
    sinc_quotient = fine_sine / sinc_divisor
    sinc_quotient_product_1 = sinc_quotient * sinc_divisor
    sinc_quotient_exact_1 = (fine_sine - sinc_quotient_product_1
        - product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1))
    fine_sine_lo = (fine_sine_own_error_1
        + (fine_sine_half_cos_1 * c - fine_sine_half_sin_1 * fine_sine) * fine_sine_twice_1)
    sinc_quotient_lo = ((sinc_quotient_exact_1 + fine_sine_lo - sinc_quotient * sinc_divisor_lo)
        / sinc_divisor)
    sinc_quotient_padded_1 = c2 + (1 + y_padded_1)
    sinc_quotient_padded_2 = (c2
        + (where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_size_1) + sinc_divisor_size_10))
    sinc_quotient_size_1 = absolute(sinc_quotient)
    sinc_quotient_size_2 = absolute(sinc_divisor)
    sinc_quotient_bound_1 = absolute(sinc_divisor_lo) + c13 * sinc_quotient_padded_2
    sinc_quotient_size_7 = where(4 * sinc_quotient_bound_1 < sinc_quotient_size_2,
        sinc_quotient_size_2, 0)
    sinc_quotient_size_8 = ((sinc_quotient_padded_1 + sinc_quotient_padded_2
        * sinc_quotient_size_1) / sinc_quotient_size_7)
    sinc_quotient_size_11 = (sinc_quotient_size_1
        + (sinc_quotient_size_2 + c8 * sinc_quotient_bound_1) * sinc_quotient_size_8
        / sinc_quotient_size_2)
    sinc_a = 0.16666666666666666 * y
    sinc_a_cross2_1 = (0.16666666666666666
        * (product_error(half_angle, half_angle, y)
        + (half_angle_lo * half_angle + half_angle * half_angle_lo)))
    sinc_b = 1 - sinc_a
    sinc_b_right_1 = 1 - sinc_b
    sinc_b_lo = (1 - (sinc_b + sinc_b_right_1)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1)
        - (c14 * y + sinc_a_cross2_1))
    sinc_b_size_1 = 1 + c15 * (y_size_2 + y_size_2)
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo, sinc_quotient_lo)
    sinc_size_4 = (absolute(sinc_b_lo) + c16 * (c2 + sinc_b_size_1)
        + absolute(sinc_b - sinc_quotient))
    sinc_size_7 = (c18
        * where(sinc_divisor_size_5, 0, absolute(sinc_quotient_lo) + c17
        * (c2 + sinc_quotient_size_11) + sinc_size_4))
    fine_qo_0 = fine_h_0 * sinc
    fine_qo_padded_1 = (c2
        + (where(sinc_divisor_a, sinc_b_size_1, sinc_quotient_size_11) + sinc_size_7))
    fine_qo_reach_2 = absolute(sinc) + c8 * (absolute(sinc_lo) + c19 * fine_qo_padded_1)
    fine_qo_1 = fine_h_1 * sinc
    fine_qo_2 = fine_h_2 * sinc
    qo_rest_1 = (c21
        * (c2
        + (fine_qo_padded_1 * (absolute(fine_h_0) + c8 * (c3 * h_size_padded_1)) + fine_qo_reach_2
        * h_size_padded_1)))
    qo_rest_2 = (c21
        * (c2
        + (fine_qo_padded_1 * (absolute(fine_h_1) + c8 * (c3 * h_size_padded_2)) + fine_qo_reach_2
        * h_size_padded_2)))
    qo_rest_3 = (c21
        * (c2
        + (fine_qo_padded_1 * (absolute(fine_h_2) + c8 * (c3 * h_size_padded_3)) + fine_qo_reach_2
        * h_size_padded_3)))
    qo_error_8 = (c20
        * absolute(c_own_error_1 - (fine_sine_half_cos_1 * fine_sine + fine_sine_half_sin_1 * c)
        * fine_sine_twice_1 + (c - qo_3)))
    qo_bound_1 = (c20
        * absolute(product_error(fine_h_0, sinc, fine_qo_0) + fine_h_0 * sinc_lo
        + (fine_qo_0 - qo_0)) + qo_rest_1)
    qo_bound_2 = (c20
        * absolute(product_error(fine_h_1, sinc, fine_qo_1) + fine_h_1 * sinc_lo
        + (fine_qo_1 - qo_1)) + qo_rest_2)
    qo_bound_3 = (c20
        * absolute(product_error(fine_h_2, sinc, fine_qo_2) + fine_h_2 * sinc_lo
        + (fine_qo_2 - qo_2)) + qo_rest_3)
    qo_bound_4 = qo_error_8 + c22 * sinc_quotient_padded_1
    return (qo_0, qo_1, qo_2, qo_3, qo_bound_1, qo_bound_2, qo_bound_3, qo_bound_4)


@kernel("(4)->(3),(3)")
@errstate(all="ignore")
def quaternion_log(q, *, c1=6.703903964971299e+153, c2=3.7291703656001034e-155,
        c3=1.3093562431584567e+151, c4=1.955159272639747e-149, c5=1.0715086071862673e+301, c6=5e-324,
        c7=1.8051943758648296e-276, c8=1.1093356479670522e-31, c9=3.169126500570585e+29,
        c10=3.254051621949822e-30, c11=3.4142893812359766e-30, c12=140737488355328,
        c13=7.235336013082471e-30, c14=1.5970396877936164e+29, c15=7.637340908749012e-152,
        c16=9.332636185032189e-302, c17=6.859394487938082e-30, c18=4.875578158636172e+28,
        c19=7.042501095850493e+28, c20=1.464323675977526e-29, c21=3.097307347238718e-29,
        c22=3.2199508764278064e-29):
    """vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of
    it; |error of vo| <= vo_bound unless inf or NaN.

    (4)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; vo, vo_bound: vector.
    209 mul, 315 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 5 neg, 49 abs, 4
    copysign, 35 less, 10 equal, 65 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s = where(s_largest3 < c4, c5, where(s_largest3 < 256, c3, where(c1 < s_largest3, real(c2),
        real(1))))
    scaled_s_0 = q_0 * s
    scaled_s_inverse_1 = 1 / s
    scaled_s_size_4 = absolute(scaled_s_0)
    scaled_s_1 = q_1 * s
    scaled_s_size_8 = absolute(scaled_s_1)
    scaled_s_2 = q_2 * s
    scaled_s_size_12 = absolute(scaled_s_2)
    scaled_s_3 = q_3 * s
    scaled_s_size_15 = where(q_3 == scaled_s_3 * scaled_s_inverse_1, real(0), real(c6))
    scaled_s_size_16 = absolute(scaled_s_3)
    upper_0a = -scaled_s_0
    upper_0b = scaled_s_3 < 0
    upper_0 = where(upper_0b, upper_0a, scaled_s_0)
    upper_size_4 = scaled_s_size_15 < c6 + absolute(scaled_s_3 - 0)
    upper_size_8 = (where(q_0 == scaled_s_0 * scaled_s_inverse_1, real(0), real(c6))
        + (c8 * (c7 + scaled_s_size_4) + absolute(upper_0a - scaled_s_0)))
    upper_1a = -scaled_s_1
    upper_1 = where(upper_0b, upper_1a, scaled_s_1)
    upper_size_15 = (where(q_1 == scaled_s_1 * scaled_s_inverse_1, real(0), real(c6))
        + (c8 * (c7 + scaled_s_size_8) + absolute(upper_1a - scaled_s_1)))
    upper_2a = -scaled_s_2
    upper_2 = where(upper_0b, upper_2a, scaled_s_2)
    upper_size_22 = (where(q_2 == scaled_s_2 * scaled_s_inverse_1, real(0), real(c6))
        + (c8 * (c7 + scaled_s_size_12) + absolute(upper_2a - scaled_s_2)))
    upper_3a = -scaled_s_3
    upper_3 = where(upper_0b, upper_3a, scaled_s_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_padded_1 = c7 + (scaled_s_size_4 + c9 * where(upper_size_4, 0, upper_size_8))
    v_s_size_1 = absolute(upper_1)
    v_s_size_padded_2 = c7 + (scaled_s_size_8 + c9 * where(upper_size_4, 0, upper_size_15))
    v_s_size_2 = absolute(upper_2)
    v_s_size_padded_3 = c7 + (scaled_s_size_12 + c9 * where(upper_size_4, 0, upper_size_22))
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s_a = v_s_largest2 < 256
    v_s_c = v_s_largest2 < c4
    v_s = where(v_s_c, c5, where(v_s_a, real(c3), real(1)))
    v_s_size_3 = where(v_s_c, c5, where(v_s_a, real(c3), real(1)))
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_a_padded_1 = c7 + v_s_size_3 * v_s_size_padded_1
    v_n_a_size_2 = v_n_a_padded_1 * (absolute(v_y_0) + c12 * (c11 * v_n_a_padded_1))
    v_n_b = v_y_1 * v_y_1
    v_n_b_padded_1 = c7 + v_s_size_3 * v_s_size_padded_2
    v_n_b_size_2 = v_n_b_padded_1 * (absolute(v_y_1) + c12 * (c11 * v_n_b_padded_1))
    v_n_c = v_n_a + v_n_b
    v_n_c_right_1 = v_n_c - v_n_a
    v_n_d = v_y_2 * v_y_2
    v_n_d_padded_1 = c7 + v_s_size_3 * v_s_size_padded_3
    v_n_d_size_2 = v_n_d_padded_1 * (absolute(v_y_2) + c12 * (c11 * v_n_d_padded_1))
    v_n_e = v_n_c + v_n_d
    v_n_e_right_1 = v_n_e - v_n_c
    v_n_c_lo = (product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
        + product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1))
    v_n_e_lo = (v_n_c - (v_n_e - v_n_e_right_1) + product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right_1)
        + v_n_c_lo)
    v_n = sqrt(v_n_e)
    v_n_product_1 = v_n * v_n
    v_n_lo = ((v_n_e - v_n_product_1 - product_error(v_n, v_n, v_n_product_1) + v_n_e_lo)
        / where(v_n == 0, 1, v_n + v_n))
    v_n_padded_1 = (c7
        + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
        + (v_n_d_size_2 + v_n_d_size_2)))
    v_n_bound_1 = absolute(v_n_e_lo) + c13 * v_n_padded_1
    v_n_size_4 = (absolute(v_n_e) + c12 * v_n_bound_1) * (v_n_padded_1 / v_n / v_n_e)
    v_r_a = 1 < v_s
    v_r_c = c3 < v_s
    v_r = where(v_r_c, c16, where(v_r_a, real(c15), real(1)))
    n = v_n * v_r
    n_lo = (v_n - n * (1 / v_r) + v_n_lo) * v_r
    n_padded_1 = (c7
        + (v_n
        + where(4 * v_n_bound_1 < v_n_e, v_n_size_4, c14 * (sqrt(v_n_bound_1) + absolute(v_n_lo)))))
    n_size_1 = n_padded_1 * where(v_r_c, c16, where(v_r_a, real(c15), real(1)))
    half = elementary.atan2(n, upper_3)
    half_size0_1 = absolute(n)
    half_size1_1 = absolute(upper_3)
    half_most_1 = where(half_size0_1 < half_size1_1, half_size1_1, half_size0_1)
    half_zero_1 = half_most_1 == 0
    half_divisor_1 = where(half_zero_1, 1, half_most_1)
    half_part0_1 = n / half_divisor_1
    half_part1_1 = upper_3 / half_divisor_1
    half_safe_1 = where(half_zero_1, 1,
        half_divisor_1 * (half_part1_1 * half_part1_1 + half_part0_1 * half_part0_1))
    half_lo = (elementary.atan2_error(n, upper_3, half) + (half_part1_1 * n_lo - half_part0_1 * 0)
        / half_safe_1)
    half_padded_1 = c7 + n_size_1
    upper_size_32 = (scaled_s_size_16 + c9
        * where(upper_size_4, 0, scaled_s_size_15
        + (c8 * (c7 + scaled_s_size_16) + absolute(upper_3a - scaled_s_3))))
    half_padded_2 = c7 + upper_size_32
    half_size_2 = absolute(n)
    half_size_3 = absolute(upper_3)
    half_size_5 = where(half_size_2 < half_size_3, half_size_3, half_size_2)
    half_bound_1 = absolute(n_lo) + c17 * half_padded_1
    half_rest_2 = c10 * half_padded_2
    half_size_11 = (half_rest_2 + (c7 + half_bound_1)) / half_size_5
    half_size_13 = half_size_11 * half_size_11
    half_size_15 = 7 + absolute(half_lo)
    half_size_19 = where(half_bound_1 < half_size_2, half_size_13, where(half_rest_2 < upper_3,
        half_size_13, half_size_15))
    divisor_a = n == 0
    divisor = where(divisor_a, 1, n)
    divisor_lo = where(divisor_a, 0, n_lo)
    theta = 2 * half
    k = theta / divisor
    k_product_1 = k * divisor
    k_lo = ((theta - k_product_1 - product_error(k, divisor, k_product_1) + 2 * half_lo - k
        * divisor_lo) / divisor)
    k_padded_2 = (c7
        + (where(divisor_a, 1, n_size_1) + c19
        * where(half_bound_1 < c6 + absolute(n - 0), 0, absolute(1 - n) + half_bound_1)))
    k_size_1 = absolute(k)
    k_size_2 = absolute(divisor)
    k_padded_1 = (c7 + 2
        * (absolute(half) + (half_padded_1 + half_padded_2) / half_size_5 + c18
        * where(half_size_11 < 0.25, half_size_19, half_size_15)))
    k_bound_1 = absolute(divisor_lo) + c20 * k_padded_2
    vector_0 = upper_0 * k
    k_size_11 = (k_size_1 + (k_size_2 + c12 * k_bound_1)
        * ((k_padded_1 + k_padded_2 * k_size_1) / where(4 * k_bound_1 < k_size_2, k_size_2, 0))
        / k_size_2)
    vector_padded_1 = c7 + k_size_11
    vector_reach_2 = k_size_1 + c12 * (absolute(k_lo) + c21 * vector_padded_1)
    vector_1 = upper_1 * k
    vector_2 = upper_2 * k
    vector_rest_2 = (c22
        * (c7
        + (vector_padded_1 * (absolute(upper_0) + c12 * (c10 * v_s_size_padded_1))
        + v_s_size_padded_1 * vector_reach_2)))
    vector_rest_3 = (c22
        * (c7
        + (vector_padded_1 * (absolute(upper_1) + c12 * (c10 * v_s_size_padded_2))
        + v_s_size_padded_2 * vector_reach_2)))
    vector_rest_4 = (c22
        * (c7
        + (vector_padded_1 * (absolute(upper_2) + c12 * (c10 * v_s_size_padded_3))
        + v_s_size_padded_3 * vector_reach_2)))
    vector_bound_2 = absolute(product_error(upper_0, k, vector_0) + upper_0 * k_lo) + vector_rest_2
    vector_bound_3 = absolute(product_error(upper_1, k, vector_1) + upper_1 * k_lo) + vector_rest_3
    vector_bound_4 = absolute(product_error(upper_2, k, vector_2) + upper_2 * k_lo) + vector_rest_4
    return (vector_0, vector_1, vector_2, vector_bound_2, vector_bound_3, vector_bound_4)
