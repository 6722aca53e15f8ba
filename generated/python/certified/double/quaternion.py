# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel


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
    self_0_new_padded = absolute(self_0_new) + 2.004168360008973e-292
    self_0_new_error_bound = 1.1102230246251568e-16 * self_0_new_padded
    self_1_new_padded = absolute(self_1_new) + 2.004168360008973e-292
    self_1_new_error_bound = 1.1102230246251568e-16 * self_1_new_padded
    self_2_new_padded = absolute(self_2_new) + 2.004168360008973e-292
    self_2_new_error_bound = 1.1102230246251568e-16 * self_2_new_padded
    self_3_new_padded = absolute(self_3_new) + 2.004168360008973e-292
    self_3_new_error_bound = 1.1102230246251568e-16 * self_3_new_padded
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_0_new_error_bound,
        self_1_new_error_bound, self_2_new_error_bound, self_3_new_error_bound)


@kernel("(),(4),(4)->(4),(4)")
def axpy_qq(a, x, y):
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
    y_0_new_error_bound = 2.2204460492503136e-16 * (y_0_new_size + 2.004168360008973e-292)
    y_1_new_error_bound = 2.2204460492503136e-16 * (y_1_new_size + 2.004168360008973e-292)
    y_2_new_error_bound = 2.2204460492503136e-16 * (y_2_new_size + 2.004168360008973e-292)
    y_3_new_error_bound = 2.2204460492503136e-16 * (y_3_new_size + 2.004168360008973e-292)
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_0_new_error_bound, y_1_new_error_bound,
        y_2_new_error_bound, y_3_new_error_bound)


@kernel("(4),(3)->(3),(3)")
def rotate_qv(q, v):
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
    t_0_size = 2 * (c_0_size + 2.004168360008973e-292)
    t_1_size = 2 * (c_1_size + 2.004168360008973e-292)
    t_2_size = 2 * (c_2_size + 2.004168360008973e-292)
    t_2_padded = t_2_size + 2.004168360008973e-292
    q_1_abs = absolute(q_1)
    t_1_padded = t_1_size + 2.004168360008973e-292
    q_2_abs = absolute(q_2)
    t_0_padded = t_0_size + 2.004168360008973e-292
    q_3_abs = absolute(q_3)
    turn_0_size = q_1_abs * t_2_padded + q_2_abs * t_1_padded + q_3_abs * t_0_padded
    q_0_abs = absolute(q_0)
    turn_1_size = q_2_abs * t_0_padded + q_0_abs * t_2_padded + q_3_abs * t_1_padded
    turn_2_size = q_0_abs * t_1_padded + q_1_abs * t_0_padded + q_3_abs * t_2_padded
    vo_0_size = absolute(v_0) + turn_0_size
    vo_1_size = absolute(v_1) + turn_1_size
    vo_2_size = absolute(v_2) + turn_2_size
    vo_0_error_bound = 7.7715611723761e-16 * (vo_0_size + 2.004168360008973e-292)
    vo_1_error_bound = 7.7715611723761e-16 * (vo_1_size + 2.004168360008973e-292)
    vo_2_error_bound = 7.7715611723761e-16 * (vo_2_size + 2.004168360008973e-292)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)


@kernel("(4),(3)->(3),(3)")
def rotate_qconjv(q, v):
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
    t_0_size = 2 * (c_0_size + 2.004168360008973e-292)
    t_1_size = 2 * (c_1_size + 2.004168360008973e-292)
    t_2_size = 2 * (c_2_size + 2.004168360008973e-292)
    t_1_padded = t_1_size + 2.004168360008973e-292
    q_2_abs = absolute(q_2)
    t_2_padded = t_2_size + 2.004168360008973e-292
    q_1_abs = absolute(q_1)
    t_0_padded = t_0_size + 2.004168360008973e-292
    q_3_abs = absolute(q_3)
    turn_0_size = q_2_abs * t_1_padded + q_1_abs * t_2_padded + q_3_abs * t_0_padded
    q_0_abs = absolute(q_0)
    turn_1_size = q_0_abs * t_2_padded + q_2_abs * t_0_padded + q_3_abs * t_1_padded
    turn_2_size = q_1_abs * t_0_padded + q_0_abs * t_1_padded + q_3_abs * t_2_padded
    vo_0_size = absolute(v_0) + turn_0_size
    vo_1_size = absolute(v_1) + turn_1_size
    vo_2_size = absolute(v_2) + turn_2_size
    vo_0_error_bound = 7.7715611723761e-16 * (vo_0_size + 2.004168360008973e-292)
    vo_1_error_bound = 7.7715611723761e-16 * (vo_1_size + 2.004168360008973e-292)
    vo_2_error_bound = 7.7715611723761e-16 * (vo_2_size + 2.004168360008973e-292)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)


@kernel("(4),(4)->(4),(4)")
def quaternion_product_qq(q1i, q2i):
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
    qo_0_error_bound = 4.440892098500628e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 4.440892098500628e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 4.440892098500628e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 4.440892098500628e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(4)->(4),(4)")
def quaternion_product_qqconj(q1i, q2i):
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
    qo_0_error_bound = 3.3306690738754706e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 3.3306690738754706e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 3.3306690738754706e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 4.440892098500628e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(4)->(4),(4)")
def quaternion_product_qconjq(q1i, q2i):
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
    qo_0_error_bound = 3.3306690738754706e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 3.3306690738754706e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 3.3306690738754706e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 4.440892098500628e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(4)->(4),(4)")
def quaternion_product_qconjqconj(q1i, q2i):
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
    qo_0_error_bound = 4.440892098500628e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 4.440892098500628e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 4.440892098500628e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 4.440892098500628e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qxq(dci, qi):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qxqconj(dci, qi):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2c_padded = absolute(qo_2a) + absolute(qo_2b) + 2.004168360008973e-292
    qo_2c_error_bound = 2.2204460492503136e-16 * qo_2c_padded
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2c_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qxconjq(dci, qi):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qxconjqconj(dci, qi):
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
    qo_0c_padded = absolute(qo_0a) + absolute(qo_0b) + 2.004168360008973e-292
    qo_0c_error_bound = 2.2204460492503136e-16 * qo_0c_padded
    qo_1c_padded = absolute(qo_1a) + absolute(qo_1b) + 2.004168360008973e-292
    qo_1c_error_bound = 2.2204460492503136e-16 * qo_1c_padded
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_error_bound, qo_1c_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qqx(qi, dci):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qqxconj(qi, dci):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qconjqx(qi, dci):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1c_padded = absolute(qo_1a) + absolute(qo_1b) + 2.004168360008973e-292
    qo_1c_error_bound = 2.2204460492503136e-16 * qo_1c_padded
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1c_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qconjqxconj(qi, dci):
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
    qo_0c_padded = absolute(qo_0a) + absolute(qo_0b) + 2.004168360008973e-292
    qo_0c_error_bound = 2.2204460492503136e-16 * qo_0c_padded
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2c_padded = absolute(qo_2a) + absolute(qo_2b) + 2.004168360008973e-292
    qo_2c_error_bound = 2.2204460492503136e-16 * qo_2c_padded
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_error_bound, qo_1_error_bound, qo_2c_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qyq(dci, qi):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qyqconj(dci, qi):
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
    qo_0c_padded = absolute(qo_0a) + absolute(qo_0b) + 2.004168360008973e-292
    qo_0c_error_bound = 2.2204460492503136e-16 * qo_0c_padded
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qyconjq(dci, qi):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qyconjqconj(dci, qi):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1c_padded = absolute(qo_1a) + absolute(qo_1b) + 2.004168360008973e-292
    qo_1c_error_bound = 2.2204460492503136e-16 * qo_1c_padded
    qo_2c_padded = absolute(qo_2a) + absolute(qo_2b) + 2.004168360008973e-292
    qo_2c_error_bound = 2.2204460492503136e-16 * qo_2c_padded
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1c_error_bound, qo_2c_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qqy(qi, dci):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qqyconj(qi, dci):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qconjqy(qi, dci):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2c_padded = absolute(qo_2a) + absolute(qo_2b) + 2.004168360008973e-292
    qo_2c_error_bound = 2.2204460492503136e-16 * qo_2c_padded
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2c_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qconjqyconj(qi, dci):
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
    qo_0c_padded = absolute(qo_0a) + absolute(qo_0b) + 2.004168360008973e-292
    qo_0c_error_bound = 2.2204460492503136e-16 * qo_0c_padded
    qo_1c_padded = absolute(qo_1a) + absolute(qo_1b) + 2.004168360008973e-292
    qo_1c_error_bound = 2.2204460492503136e-16 * qo_1c_padded
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_error_bound, qo_1c_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qzq(dci, qi):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qzqconj(dci, qi):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1c_padded = absolute(qo_1a) + absolute(qo_1b) + 2.004168360008973e-292
    qo_1c_error_bound = 2.2204460492503136e-16 * qo_1c_padded
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1c_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qzconjq(dci, qi):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(2),(4)->(4),(4)")
def quaternion_product_qzconjqconj(dci, qi):
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
    qo_0c_padded = absolute(qo_0a) + absolute(qo_0b) + 2.004168360008973e-292
    qo_0c_error_bound = 2.2204460492503136e-16 * qo_0c_padded
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2c_padded = absolute(qo_2a) + absolute(qo_2b) + 2.004168360008973e-292
    qo_2c_error_bound = 2.2204460492503136e-16 * qo_2c_padded
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_error_bound, qo_1_error_bound, qo_2c_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qqz(qi, dci):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qqzconj(qi, dci):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qconjqz(qi, dci):
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
    qo_0c_padded = absolute(qo_0a) + absolute(qo_0b) + 2.004168360008973e-292
    qo_0c_error_bound = 2.2204460492503136e-16 * qo_0c_padded
    qo_1_error_bound = 2.2204460492503136e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 2.2204460492503136e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0c_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(2)->(4),(4)")
def quaternion_product_qconjqzconj(qi, dci):
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
    qo_0_error_bound = 2.2204460492503136e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1c_padded = absolute(qo_1a) + absolute(qo_1b) + 2.004168360008973e-292
    qo_1c_error_bound = 2.2204460492503136e-16 * qo_1c_padded
    qo_2c_padded = absolute(qo_2a) + absolute(qo_2b) + 2.004168360008973e-292
    qo_2c_error_bound = 2.2204460492503136e-16 * qo_2c_padded
    qo_3_error_bound = 2.2204460492503136e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1c_error_bound, qo_2c_error_bound,
        qo_3_error_bound)


@kernel("(4),(3)->(4),(4)")
def quaternion_product_qv(qi, vi):
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
    qo_0_error_bound = 3.3306690738754706e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 3.3306690738754706e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 3.3306690738754706e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3e_padded = absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d) + 2.004168360008973e-292
    qo_3e_error_bound = 3.3306690738754706e-16 * qo_3e_padded
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3e_error_bound)


@kernel("(4),(3)->(4),(4)")
def quaternion_product_qconjv(qi, vi):
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
    qo_0_error_bound = 3.3306690738754706e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 3.3306690738754706e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 3.3306690738754706e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 3.3306690738754706e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(3),(4)->(4),(4)")
def quaternion_product_vq(vi, qi):
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
    qo_0_error_bound = 3.3306690738754706e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 3.3306690738754706e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 3.3306690738754706e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3e_padded = absolute(qo_3a) + absolute(qo_3b) + absolute(qo_3d) + 2.004168360008973e-292
    qo_3e_error_bound = 3.3306690738754706e-16 * qo_3e_padded
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3e_error_bound)


@kernel("(3),(4)->(4),(4)")
def quaternion_product_vqconj(vi, qi):
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
    qo_0_error_bound = 3.3306690738754706e-16 * (qo_0_size + 2.004168360008973e-292)
    qo_1_error_bound = 3.3306690738754706e-16 * (qo_1_size + 2.004168360008973e-292)
    qo_2_error_bound = 3.3306690738754706e-16 * (qo_2_size + 2.004168360008973e-292)
    qo_3_error_bound = 3.3306690738754706e-16 * (qo_3_size + 2.004168360008973e-292)
    return (qo_0, qo_1, qo_2, qo_3, qo_0_error_bound, qo_1_error_bound, qo_2_error_bound,
        qo_3_error_bound)


@kernel("(4),(4)->(),()")
def dot_qq(q1i, q2i):
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
    dot_error_bound = 4.440892098500628e-16 * (dot_size + 2.004168360008973e-292)
    return (dot, dot_error_bound)


@kernel("(3),(4)->(4),(4)")
def add_dpiToq(dpi, qi):
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
    qi_0_new_a_padded = absolute(qi_0_new_a) + 2.004168360008973e-292
    qi_3_abs = absolute(qi_3)
    qi_0_new_c_padded = absolute(qi_0_new_c) + 2.004168360008973e-292
    qi_1_abs = absolute(qi_1)
    qi_0_new_e_padded = absolute(qi_0_new_e) + 2.004168360008973e-292
    qi_2_abs = absolute(qi_2)
    qi_0_new_g_size = qi_0_new_c_padded * qi_1_abs + qi_0_new_e_padded * qi_2_abs
    qi_0_abs = absolute(qi_0)
    qi_0_new_size = qi_0_new_a_padded * qi_3_abs + qi_0_new_g_size + qi_0_abs
    qi_1_new_c_size = qi_0_new_a_padded * qi_2_abs + qi_0_new_c_padded * qi_0_abs
    qi_1_new_size = qi_1_new_c_size + qi_0_new_e_padded * qi_3_abs + qi_1_abs
    qi_2_new_c_size = qi_0_new_e_padded * qi_0_abs + qi_0_new_a_padded * qi_1_abs
    qi_2_new_size = qi_2_new_c_size + qi_0_new_c_padded * qi_3_abs + qi_2_abs
    qi_3_new_c_size = qi_0_new_a_padded * qi_0_abs + qi_0_new_e_padded * qi_1_abs
    qi_3_new_size = qi_3_abs + (qi_3_new_c_size + qi_0_new_c_padded * qi_2_abs)
    qi_0_new_error_bound = 5.551115123125785e-16 * (qi_0_new_size + 2.004168360008973e-292)
    qi_1_new_error_bound = 5.551115123125785e-16 * (qi_1_new_size + 2.004168360008973e-292)
    qi_2_new_error_bound = 5.551115123125785e-16 * (qi_2_new_size + 2.004168360008973e-292)
    qi_3_new_error_bound = 5.551115123125785e-16 * (qi_3_new_size + 2.004168360008973e-292)
    return (qi_0_new, qi_1_new, qi_2_new, qi_3_new, qi_0_new_error_bound, qi_1_new_error_bound,
        qi_2_new_error_bound, qi_3_new_error_bound)


@kernel("(3),(4)->(4),(4)")
def subtract_dpiFromq(dpi, qi):
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
    qi_0_new_a_padded = absolute(qi_0_new_a) + 2.004168360008973e-292
    qi_2_abs = absolute(qi_2)
    qi_0_new_c_padded = absolute(qi_0_new_c) + 2.004168360008973e-292
    qi_1_abs = absolute(qi_1)
    qi_0_new_f_padded = absolute(qi_0_new_f) + 2.004168360008973e-292
    qi_3_abs = absolute(qi_3)
    qi_0_new_e_size = qi_0_new_a_padded * qi_2_abs + qi_0_new_c_padded * qi_1_abs
    qi_0_abs = absolute(qi_0)
    qi_0_new_size = qi_0_new_e_size + qi_0_new_f_padded * qi_3_abs + qi_0_abs
    qi_1_new_c_size = qi_0_new_c_padded * qi_0_abs + qi_0_new_f_padded * qi_2_abs
    qi_1_new_size = qi_1_new_c_size + qi_0_new_a_padded * qi_3_abs + qi_1_abs
    qi_2_new_c_size = qi_0_new_f_padded * qi_1_abs + qi_0_new_a_padded * qi_0_abs
    qi_2_new_size = qi_2_new_c_size + qi_0_new_c_padded * qi_3_abs + qi_2_abs
    qi_3_new_c_size = qi_0_new_f_padded * qi_0_abs + qi_0_new_a_padded * qi_1_abs
    qi_3_new_size = qi_3_new_c_size + qi_0_new_c_padded * qi_2_abs + qi_3_abs
    qi_0_new_error_bound = 5.551115123125785e-16 * (qi_0_new_size + 2.004168360008973e-292)
    qi_1_new_error_bound = 5.551115123125785e-16 * (qi_1_new_size + 2.004168360008973e-292)
    qi_2_new_error_bound = 5.551115123125785e-16 * (qi_2_new_size + 2.004168360008973e-292)
    qi_3_new_error_bound = 5.551115123125785e-16 * (qi_3_new_size + 2.004168360008973e-292)
    return (qi_0_new, qi_1_new, qi_2_new, qi_3_new, qi_0_new_error_bound, qi_1_new_error_bound,
        qi_2_new_error_bound, qi_3_new_error_bound)


@kernel("(3),(4)->(4),(4)")
def omega_to_dquaternion(w, qi):
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
    dqo_0a_padded = absolute(dqo_0a) + 2.004168360008973e-292
    qi_3_abs = absolute(qi_3)
    dqo_0c_padded = absolute(dqo_0c) + 2.004168360008973e-292
    qi_2_abs = absolute(qi_2)
    dqo_0e_padded = absolute(dqo_0e) + 2.004168360008973e-292
    qi_1_abs = absolute(qi_1)
    dqo_0p_size = 1 + absolute(dqo_0i) + absolute(dqo_0k) + absolute(dqo_0m) + absolute(dqo_0o)
    dqo_0p_padded = dqo_0p_size + 2.004168360008973e-292
    qi_0_abs = absolute(qi_0)
    dqo_0h_size = dqo_0a_padded * qi_3_abs + (dqo_0c_padded * qi_2_abs + dqo_0e_padded * qi_1_abs)
    dqo_0_size = dqo_0h_size + qi_0_abs * dqo_0p_padded
    dqo_1e_size = dqo_0e_padded * qi_0_abs + dqo_0a_padded * qi_2_abs + dqo_0c_padded * qi_3_abs
    dqo_1_size = dqo_1e_size + qi_1_abs * dqo_0p_padded
    dqo_2e_size = dqo_0a_padded * qi_1_abs + dqo_0c_padded * qi_0_abs + dqo_0e_padded * qi_3_abs
    dqo_2_size = dqo_2e_size + qi_2_abs * dqo_0p_padded
    dqo_3f_size = dqo_0a_padded * qi_0_abs + dqo_0c_padded * qi_1_abs + dqo_0e_padded * qi_2_abs
    dqo_3_size = qi_3_abs * dqo_0p_padded + dqo_3f_size
    dqo_0_error_bound = 7.7715611723761e-16 * (dqo_0_size + 2.004168360008973e-292)
    dqo_1_error_bound = 7.7715611723761e-16 * (dqo_1_size + 2.004168360008973e-292)
    dqo_2_error_bound = 7.7715611723761e-16 * (dqo_2_size + 2.004168360008973e-292)
    dqo_3_error_bound = 7.7715611723761e-16 * (dqo_3_size + 2.004168360008973e-292)
    return (dqo_0, dqo_1, dqo_2, dqo_3, dqo_0_error_bound, dqo_1_error_bound, dqo_2_error_bound,
        dqo_3_error_bound)
