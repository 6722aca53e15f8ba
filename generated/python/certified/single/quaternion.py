# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors.
"""Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.

In single precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import single_kernel as kernel


@kernel("(4),()->(4),(4)")
def quaternion_scale(self, a):
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (4),()->(4),(4).  self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.
    8 mul, 4 add, 4 abs.
    """
    self_0, self_1, self_2, self_3 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_0_new_error_bound = 5.960465e-08 * (absolute(self_0_new) + 1.9721523e-31)
    self_1_new_error_bound = 5.960465e-08 * (absolute(self_1_new) + 1.9721523e-31)
    self_2_new_error_bound = 5.960465e-08 * (absolute(self_2_new) + 1.9721523e-31)
    self_3_new_error_bound = 5.960465e-08 * (absolute(self_3_new) + 1.9721523e-31)
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_0_new_error_bound,
        self_1_new_error_bound, self_2_new_error_bound, self_3_new_error_bound)


@kernel("(4),(4)->(4),(4)")
def product_qq(q1, q2):
    """qo = q1 q2 = (w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2); |error of qo| <= qo_bound unless inf
    or NaN.

    (4),(4)->(4),(4).  q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """
    q1_0, q1_1, q1_2, q1_3 = q1
    q2_0, q2_1, q2_2, q2_3 = q2
    qo_0a = q1_0 * q2_3
    qo_0b = q1_1 * q2_2
    qo_0c = q1_2 * q2_1
    qo_0f = q1_3 * q2_0
    qo_0 = qo_0a + (qo_0b - qo_0c) + qo_0f
    qo_1a = q1_2 * q2_0
    qo_1b = q1_0 * q2_2
    qo_1d = q1_1 * q2_3
    qo_1f = q1_3 * q2_1
    qo_1 = qo_1a - qo_1b + qo_1d + qo_1f
    qo_2a = q1_0 * q2_1
    qo_2b = q1_1 * q2_0
    qo_2d = q1_2 * q2_3
    qo_2f = q1_3 * q2_2
    qo_2 = qo_2a - qo_2b + qo_2d + qo_2f
    qo_3a = q1_3 * q2_3
    qo_3b = q1_0 * q2_0
    qo_3c = q1_1 * q2_1
    qo_3e = q1_2 * q2_2
    qo_3 = qo_3a - (qo_3b + qo_3c + qo_3e)
    qo_0_size = absolute(qo_0a) + (absolute(qo_0b) + absolute(qo_0c)) + absolute(qo_0f)
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + absolute(qo_1d) + absolute(qo_1f)
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + absolute(qo_2d) + absolute(qo_2f)
    qo_3_size = absolute(qo_3a) + (absolute(qo_3b) + absolute(qo_3c) + absolute(qo_3e))
    qo_0_error_bound = 2.3841864e-07 * (qo_0_size + 1.9721523e-31)
    qo_1_error_bound = 2.3841864e-07 * (qo_1_size + 1.9721523e-31)
    qo_2_error_bound = 2.3841864e-07 * (qo_2_size + 1.9721523e-31)
    qo_3_error_bound = 2.3841864e-07 * (qo_3_size + 1.9721523e-31)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(4)->(4),(4)")
def product_qconjq(q1, q2):
    """qo = q1* q2, q1* the conjugate; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """
    q1_0, q1_1, q1_2, q1_3 = q1
    q2_0, q2_1, q2_2, q2_3 = q2
    qo_0a = q1_3 * q2_0
    qo_0b = q1_0 * q2_3
    qo_0d = q1_2 * q2_1
    qo_0e = q1_1 * q2_2
    qo_0 = qo_0a - qo_0b + (qo_0d - qo_0e)
    qo_1a = q1_0 * q2_2
    qo_1b = q1_2 * q2_0
    qo_1d = q1_3 * q2_1
    qo_1e = q1_1 * q2_3
    qo_1 = qo_1a - qo_1b + (qo_1d - qo_1e)
    qo_2a = q1_1 * q2_0
    qo_2b = q1_0 * q2_1
    qo_2d = q1_3 * q2_2
    qo_2e = q1_2 * q2_3
    qo_2 = qo_2a - qo_2b + (qo_2d - qo_2e)
    qo_3a = q1_0 * q2_0
    qo_3b = q1_1 * q2_1
    qo_3d = q1_2 * q2_2
    qo_3f = q1_3 * q2_3
    qo_3 = qo_3a + qo_3b + qo_3d + qo_3f
    qo_0_size = absolute(qo_0a) + absolute(qo_0b) + (absolute(qo_0d) + absolute(qo_0e))
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + (absolute(qo_1d) + absolute(qo_1e))
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + (absolute(qo_2d) + absolute(qo_2e))
    qo_3_size = absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d) + absolute(qo_3f)
    qo_0_error_bound = 1.7881396e-07 * (qo_0_size + 1.9721523e-31)
    qo_1_error_bound = 1.7881396e-07 * (qo_1_size + 1.9721523e-31)
    qo_2_error_bound = 1.7881396e-07 * (qo_2_size + 1.9721523e-31)
    qo_3_error_bound = 2.3841864e-07 * (qo_3_size + 1.9721523e-31)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(4)->(4),(4)")
def product_qqconj(q1, q2):
    """qo = q1 q2*, q2* the conjugate; |error of qo| <= qo_bound unless inf or NaN.

    (4),(4)->(4),(4).  q1, q2, qo, qo_bound: quaternion (x, y, z, w), the scalar last.
    20 mul, 28 add, 16 abs.
    """
    q1_0, q1_1, q1_2, q1_3 = q1
    q2_0, q2_1, q2_2, q2_3 = q2
    qo_0a = q1_0 * q2_3
    qo_0b = q1_3 * q2_0
    qo_0d = q1_2 * q2_1
    qo_0e = q1_1 * q2_2
    qo_0 = qo_0a - qo_0b + (qo_0d - qo_0e)
    qo_1a = q1_0 * q2_2
    qo_1b = q1_2 * q2_0
    qo_1d = q1_1 * q2_3
    qo_1e = q1_3 * q2_1
    qo_1 = qo_1a - qo_1b + (qo_1d - qo_1e)
    qo_2a = q1_1 * q2_0
    qo_2b = q1_0 * q2_1
    qo_2d = q1_2 * q2_3
    qo_2e = q1_3 * q2_2
    qo_2 = qo_2a - qo_2b + (qo_2d - qo_2e)
    qo_3a = q1_0 * q2_0
    qo_3b = q1_1 * q2_1
    qo_3d = q1_2 * q2_2
    qo_3f = q1_3 * q2_3
    qo_3 = qo_3a + qo_3b + qo_3d + qo_3f
    qo_0_size = absolute(qo_0a) + absolute(qo_0b) + (absolute(qo_0d) + absolute(qo_0e))
    qo_1_size = absolute(qo_1a) + absolute(qo_1b) + (absolute(qo_1d) + absolute(qo_1e))
    qo_2_size = absolute(qo_2a) + absolute(qo_2b) + (absolute(qo_2d) + absolute(qo_2e))
    qo_3_size = absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d) + absolute(qo_3f)
    qo_0_error_bound = 1.7881396e-07 * (qo_0_size + 1.9721523e-31)
    qo_1_error_bound = 1.7881396e-07 * (qo_1_size + 1.9721523e-31)
    qo_2_error_bound = 1.7881396e-07 * (qo_2_size + 1.9721523e-31)
    qo_3_error_bound = 2.3841864e-07 * (qo_3_size + 1.9721523e-31)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(3)->(3),(3)")
def product_qv(q, v):
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
    t_0_size = 2 * (c_0_size + 1.9721523e-31)
    t_1_size = 2 * (c_1_size + 1.9721523e-31)
    t_2_size = 2 * (c_2_size + 1.9721523e-31)
    t_2_padded = t_2_size + 1.9721523e-31
    q_1_abs = absolute(q_1)
    t_1_padded = t_1_size + 1.9721523e-31
    q_2_abs = absolute(q_2)
    t_0_padded = t_0_size + 1.9721523e-31
    q_3_abs = absolute(q_3)
    turn_0_size = q_1_abs * t_2_padded + q_2_abs * t_1_padded + q_3_abs * t_0_padded
    q_0_abs = absolute(q_0)
    turn_1_size = q_2_abs * t_0_padded + q_0_abs * t_2_padded + q_3_abs * t_1_padded
    turn_2_size = q_0_abs * t_1_padded + q_1_abs * t_0_padded + q_3_abs * t_2_padded
    vo_0_size = absolute(v_0) + turn_0_size
    vo_1_size = absolute(v_1) + turn_1_size
    vo_2_size = absolute(v_2) + turn_2_size
    vo_0_error_bound = 4.1723263e-07 * (vo_0_size + 1.9721523e-31)
    vo_1_error_bound = 4.1723263e-07 * (vo_1_size + 1.9721523e-31)
    vo_2_error_bound = 4.1723263e-07 * (vo_2_size + 1.9721523e-31)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)


@kernel("(4),(3)->(3),(3)")
def product_qconjv(q, v):
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
    t_0_size = 2 * (c_0_size + 1.9721523e-31)
    t_1_size = 2 * (c_1_size + 1.9721523e-31)
    t_2_size = 2 * (c_2_size + 1.9721523e-31)
    t_1_padded = t_1_size + 1.9721523e-31
    q_2_abs = absolute(q_2)
    t_2_padded = t_2_size + 1.9721523e-31
    q_1_abs = absolute(q_1)
    t_0_padded = t_0_size + 1.9721523e-31
    q_3_abs = absolute(q_3)
    turn_0_size = q_2_abs * t_1_padded + q_1_abs * t_2_padded + q_3_abs * t_0_padded
    q_0_abs = absolute(q_0)
    turn_1_size = q_0_abs * t_2_padded + q_2_abs * t_0_padded + q_3_abs * t_1_padded
    turn_2_size = q_1_abs * t_0_padded + q_0_abs * t_1_padded + q_3_abs * t_2_padded
    vo_0_size = absolute(v_0) + turn_0_size
    vo_1_size = absolute(v_1) + turn_1_size
    vo_2_size = absolute(v_2) + turn_2_size
    vo_0_error_bound = 4.1723263e-07 * (vo_0_size + 1.9721523e-31)
    vo_1_error_bound = 4.1723263e-07 * (vo_1_size + 1.9721523e-31)
    vo_2_error_bound = 4.1723263e-07 * (vo_2_size + 1.9721523e-31)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)
