# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.

In double precision, accurate tier.
"""

from numpy import where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(10),()->(10)")
def spatial_inertia_scale(self, a):
    """self = a self.

    (10),()->(10).  self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); a: number.
    10 mul, 10 add, 10 product error.  Error <= u |result|, barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_4_new = self_4 * a
    self_5_new = self_5 * a
    self_6_new = self_6 * a
    self_7_new = self_7 * a
    self_8_new = self_8 * a
    self_9_new = self_9 * a
    self_0_new_rounded = self_0_new + product_error(self_0, a, self_0_new)
    self_1_new_rounded = self_1_new + product_error(self_1, a, self_1_new)
    self_2_new_rounded = self_2_new + product_error(self_2, a, self_2_new)
    self_3_new_rounded = self_3_new + product_error(self_3, a, self_3_new)
    self_4_new_rounded = self_4_new + product_error(self_4, a, self_4_new)
    self_5_new_rounded = self_5_new + product_error(self_5, a, self_5_new)
    self_6_new_rounded = self_6_new + product_error(self_6, a, self_6_new)
    self_7_new_rounded = self_7_new + product_error(self_7, a, self_7_new)
    self_8_new_rounded = self_8_new + product_error(self_8, a, self_8_new)
    self_9_new_rounded = self_9_new + product_error(self_9, a, self_9_new)
    return (self_0_new_rounded, self_1_new_rounded, self_2_new_rounded, self_3_new_rounded,
        self_4_new_rounded, self_5_new_rounded, self_6_new_rounded, self_7_new_rounded,
        self_8_new_rounded, self_9_new_rounded)


@kernel("(10),(10)->(10)")
def add_BB(B1, B2):
    """Bo = B1 + B2.

    (10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2).
    70 add.  Error <= u |result|, barring over- and underflow.
    """
    B1_0, B1_1, B1_2, B1_3, B1_4, B1_5, B1_6, B1_7, B1_8, B1_9 = B1
    B2_0, B2_1, B2_2, B2_3, B2_4, B2_5, B2_6, B2_7, B2_8, B2_9 = B2
    Bo_0 = B1_0 + B2_0
    Bo_0_right = Bo_0 - B1_0
    Bo_1 = B1_1 + B2_1
    Bo_1_right = Bo_1 - B1_1
    Bo_2 = B1_2 + B2_2
    Bo_2_right = Bo_2 - B1_2
    Bo_3 = B1_3 + B2_3
    Bo_3_right = Bo_3 - B1_3
    Bo_4 = B1_4 + B2_4
    Bo_4_right = Bo_4 - B1_4
    Bo_5 = B1_5 + B2_5
    Bo_5_right = Bo_5 - B1_5
    Bo_6 = B1_6 + B2_6
    Bo_6_right = Bo_6 - B1_6
    Bo_7 = B1_7 + B2_7
    Bo_7_right = Bo_7 - B1_7
    Bo_8 = B1_8 + B2_8
    Bo_8_right = Bo_8 - B1_8
    Bo_9 = B1_9 + B2_9
    Bo_9_right = Bo_9 - B1_9
    Bo_0_rounded = Bo_0 + (B1_0 - (Bo_0 - Bo_0_right) + (B2_0 - Bo_0_right))
    Bo_1_rounded = Bo_1 + (B1_1 - (Bo_1 - Bo_1_right) + (B2_1 - Bo_1_right))
    Bo_2_rounded = Bo_2 + (B1_2 - (Bo_2 - Bo_2_right) + (B2_2 - Bo_2_right))
    Bo_3_rounded = Bo_3 + (B1_3 - (Bo_3 - Bo_3_right) + (B2_3 - Bo_3_right))
    Bo_4_rounded = Bo_4 + (B1_4 - (Bo_4 - Bo_4_right) + (B2_4 - Bo_4_right))
    Bo_5_rounded = Bo_5 + (B1_5 - (Bo_5 - Bo_5_right) + (B2_5 - Bo_5_right))
    Bo_6_rounded = Bo_6 + (B1_6 - (Bo_6 - Bo_6_right) + (B2_6 - Bo_6_right))
    Bo_7_rounded = Bo_7 + (B1_7 - (Bo_7 - Bo_7_right) + (B2_7 - Bo_7_right))
    Bo_8_rounded = Bo_8 + (B1_8 - (Bo_8 - Bo_8_right) + (B2_8 - Bo_8_right))
    Bo_9_rounded = Bo_9 + (B1_9 - (Bo_9 - Bo_9_right) + (B2_9 - Bo_9_right))
    return (Bo_0_rounded, Bo_1_rounded, Bo_2_rounded, Bo_3_rounded, Bo_4_rounded, Bo_5_rounded,
        Bo_6_rounded, Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(10),(10)->(10)")
def subtract_BB(B1, B2):
    """Bo = B1 - B2.

    (10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2).
    70 add.  Error <= u |result|, barring over- and underflow.
    """
    B1_0, B1_1, B1_2, B1_3, B1_4, B1_5, B1_6, B1_7, B1_8, B1_9 = B1
    B2_0, B2_1, B2_2, B2_3, B2_4, B2_5, B2_6, B2_7, B2_8, B2_9 = B2
    Bo_0 = B1_0 - B2_0
    Bo_0_right = B1_0 - Bo_0
    Bo_1 = B1_1 - B2_1
    Bo_1_right = B1_1 - Bo_1
    Bo_2 = B1_2 - B2_2
    Bo_2_right = B1_2 - Bo_2
    Bo_3 = B1_3 - B2_3
    Bo_3_right = B1_3 - Bo_3
    Bo_4 = B1_4 - B2_4
    Bo_4_right = B1_4 - Bo_4
    Bo_5 = B1_5 - B2_5
    Bo_5_right = B1_5 - Bo_5
    Bo_6 = B1_6 - B2_6
    Bo_6_right = B1_6 - Bo_6
    Bo_7 = B1_7 - B2_7
    Bo_7_right = B1_7 - Bo_7
    Bo_8 = B1_8 - B2_8
    Bo_8_right = B1_8 - Bo_8
    Bo_9 = B1_9 - B2_9
    Bo_9_right = B1_9 - Bo_9
    Bo_0_rounded = Bo_0 + (B1_0 - (Bo_0 + Bo_0_right) - (B2_0 - Bo_0_right))
    Bo_1_rounded = Bo_1 + (B1_1 - (Bo_1 + Bo_1_right) - (B2_1 - Bo_1_right))
    Bo_2_rounded = Bo_2 + (B1_2 - (Bo_2 + Bo_2_right) - (B2_2 - Bo_2_right))
    Bo_3_rounded = Bo_3 + (B1_3 - (Bo_3 + Bo_3_right) - (B2_3 - Bo_3_right))
    Bo_4_rounded = Bo_4 + (B1_4 - (Bo_4 + Bo_4_right) - (B2_4 - Bo_4_right))
    Bo_5_rounded = Bo_5 + (B1_5 - (Bo_5 + Bo_5_right) - (B2_5 - Bo_5_right))
    Bo_6_rounded = Bo_6 + (B1_6 - (Bo_6 + Bo_6_right) - (B2_6 - Bo_6_right))
    Bo_7_rounded = Bo_7 + (B1_7 - (Bo_7 + Bo_7_right) - (B2_7 - Bo_7_right))
    Bo_8_rounded = Bo_8 + (B1_8 - (Bo_8 + Bo_8_right) - (B2_8 - Bo_8_right))
    Bo_9_rounded = Bo_9 + (B1_9 - (Bo_9 + Bo_9_right) - (B2_9 - Bo_9_right))
    return (Bo_0_rounded, Bo_1_rounded, Bo_2_rounded, Bo_3_rounded, Bo_4_rounded, Bo_5_rounded,
        Bo_6_rounded, Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(),(3),(3,3)->(10)")
def spatial_inertia_from_com(m, com, Ic):
    """Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle
    is read): h = m com, I = Ic - m com~ com~.

    (),(3),(3,3)->(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial
    inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    15 mul, 66 add, 3 product error, 9 product rest.  Error <= u |result| + (m: 0, h: 0, I: 15)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    com_0, com_1, com_2 = com
    Ic_00, Ic_01, Ic_02, Ic_10, Ic_11, Ic_12, Ic_20, Ic_21, Ic_22 = Ic
    h_0 = m * com_0
    h_1 = m * com_1
    h_2 = m * com_2
    h_0_lo = product_error(m, com_0, h_0)
    squares_0 = com_0 * h_0
    squares_0_cross2 = com_0 * h_0_lo
    h_1_lo = product_error(m, com_1, h_1)
    squares_1 = com_1 * h_1
    squares_1_cross2 = com_1 * h_1_lo
    h_2_lo = product_error(m, com_2, h_2)
    squares_2 = com_2 * h_2
    squares_2_cross2 = com_2 * h_2_lo
    Bo_4a = squares_1 + squares_2
    Bo_4a_right = Bo_4a - squares_1
    Bo_4a_lo1 = (product_rest(com_1, h_1, squares_1, Bo_4a - Bo_4a_right)
        + product_rest(com_2, h_2, squares_2, Bo_4a_right))
    Bo_4 = Ic_00 + Bo_4a
    Bo_4_right = Bo_4 - Ic_00
    Bo_5a = squares_0 + squares_2
    Bo_5a_right = Bo_5a - squares_0
    Bo_5a_lo1 = (product_rest(com_0, h_0, squares_0, Bo_5a - Bo_5a_right)
        + product_rest(com_2, h_2, squares_2, Bo_5a_right))
    Bo_5 = Ic_11 + Bo_5a
    Bo_5_right = Bo_5 - Ic_11
    Bo_6a = squares_0 + squares_1
    Bo_6a_right = Bo_6a - squares_0
    Bo_6a_lo1 = (product_rest(com_0, h_0, squares_0, Bo_6a - Bo_6a_right)
        + product_rest(com_1, h_1, squares_1, Bo_6a_right))
    Bo_6 = Ic_22 + Bo_6a
    Bo_6_right = Bo_6 - Ic_22
    Bo_7a = com_1 * h_0
    Bo_7 = Ic_01 - Bo_7a
    Bo_7_right = Ic_01 - Bo_7
    Bo_8a = com_2 * h_0
    Bo_8 = Ic_02 - Bo_8a
    Bo_8_right = Ic_02 - Bo_8
    Bo_9a = com_2 * h_1
    Bo_9 = Ic_12 - Bo_9a
    Bo_9_right = Ic_12 - Bo_9
    h_0_rounded = h_0 + h_0_lo
    h_1_rounded = h_1 + h_1_lo
    h_2_rounded = h_2 + h_2_lo
    Bo_4_rounded = (Bo_4
        + (Ic_00 - (Bo_4 - Bo_4_right) + (Bo_4a - Bo_4_right)
        + (Bo_4a_lo1 + (squares_1_cross2 + squares_2_cross2))))
    Bo_5_rounded = (Bo_5
        + (Ic_11 - (Bo_5 - Bo_5_right) + (Bo_5a - Bo_5_right)
        + (Bo_5a_lo1 + (squares_0_cross2 + squares_2_cross2))))
    Bo_6_rounded = (Bo_6
        + (Ic_22 - (Bo_6 - Bo_6_right) + (Bo_6a - Bo_6_right)
        + (Bo_6a_lo1 + (squares_0_cross2 + squares_1_cross2))))
    Bo_7_rounded = (Bo_7
        + (Ic_01 - (Bo_7 + Bo_7_right) - product_rest(com_1, h_0, Bo_7a, Bo_7_right) - com_1
        * h_0_lo))
    Bo_8_rounded = (Bo_8
        + (Ic_02 - (Bo_8 + Bo_8_right) - product_rest(com_2, h_0, Bo_8a, Bo_8_right) - com_2
        * h_0_lo))
    Bo_9_rounded = (Bo_9
        + (Ic_12 - (Bo_9 + Bo_9_right) - product_rest(com_2, h_1, Bo_9a, Bo_9_right) - com_2
        * h_1_lo))
    return (m, h_0_rounded, h_1_rounded, h_2_rounded, Bo_4_rounded, Bo_5_rounded, Bo_6_rounded,
        Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(10)->(10)")
def spatial_inertia_from_inertia(J):
    """Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of
    mass; NaN where m = 0.

    (10)->(10).  J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
    zz, xy, yz, zx in kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the
    origin, xx, yy, zz, xy, xz, yz in kg m^2).
    15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.  Error of a
    moment <= 4 u times the sum of its |terms|, barring over- and underflow.
    """
    J_0, J_1, J_2, J_3, J_4, J_5, J_6, J_7, J_8, J_9 = J
    c_0 = J_1 / J_0
    c_0_product = c_0 * J_0
    c_1 = J_2 / J_0
    c_1_product = c_1 * J_0
    c_1_lo = (J_2 - c_1_product - product_error(c_1, J_0, c_1_product)) / J_0
    c_2 = J_3 / J_0
    c_2_product = c_2 * J_0
    c_2_lo = (J_3 - c_2_product - product_error(c_2, J_0, c_2_product)) / J_0
    squares_0 = J_1 * c_0
    squares_0_cross2 = J_1 * ((J_1 - c_0_product - product_error(c_0, J_0, c_0_product)) / J_0)
    squares_1 = J_2 * c_1
    squares_1_cross2 = J_2 * c_1_lo
    squares_2 = J_3 * c_2
    squares_2_cross2 = J_3 * c_2_lo
    Bo_4a = squares_1 + squares_2
    Bo_4a_right = Bo_4a - squares_1
    Bo_4a_lo1 = (product_rest(J_2, c_1, squares_1, Bo_4a - Bo_4a_right)
        + product_rest(J_3, c_2, squares_2, Bo_4a_right))
    Bo_4 = J_4 + Bo_4a
    Bo_4_right = Bo_4 - J_4
    Bo_5a = squares_0 + squares_2
    Bo_5a_right = Bo_5a - squares_0
    Bo_5a_lo1 = (product_rest(J_1, c_0, squares_0, Bo_5a - Bo_5a_right)
        + product_rest(J_3, c_2, squares_2, Bo_5a_right))
    Bo_5 = J_5 + Bo_5a
    Bo_5_right = Bo_5 - J_5
    Bo_6a = squares_0 + squares_1
    Bo_6a_right = Bo_6a - squares_0
    Bo_6a_lo1 = (product_rest(J_1, c_0, squares_0, Bo_6a - Bo_6a_right)
        + product_rest(J_2, c_1, squares_1, Bo_6a_right))
    Bo_6 = J_6 + Bo_6a
    Bo_6_right = Bo_6 - J_6
    Bo_7a = J_1 * c_1
    Bo_7 = J_7 - Bo_7a
    Bo_7_right = J_7 - Bo_7
    Bo_8a = J_1 * c_2
    Bo_8 = J_9 - Bo_8a
    Bo_8_right = J_9 - Bo_8
    Bo_9a = J_2 * c_2
    Bo_9 = J_8 - Bo_9a
    Bo_9_right = J_8 - Bo_9
    Bo_4_rounded = (Bo_4
        + (J_4 - (Bo_4 - Bo_4_right) + (Bo_4a - Bo_4_right)
        + (Bo_4a_lo1 + (squares_1_cross2 + squares_2_cross2))))
    Bo_5_rounded = (Bo_5
        + (J_5 - (Bo_5 - Bo_5_right) + (Bo_5a - Bo_5_right)
        + (Bo_5a_lo1 + (squares_0_cross2 + squares_2_cross2))))
    Bo_6_rounded = (Bo_6
        + (J_6 - (Bo_6 - Bo_6_right) + (Bo_6a - Bo_6_right)
        + (Bo_6a_lo1 + (squares_0_cross2 + squares_1_cross2))))
    Bo_7_rounded = (Bo_7
        + (J_7 - (Bo_7 + Bo_7_right) - product_rest(J_1, c_1, Bo_7a, Bo_7_right) - J_1 * c_1_lo))
    Bo_8_rounded = (Bo_8
        + (J_9 - (Bo_8 + Bo_8_right) - product_rest(J_1, c_2, Bo_8a, Bo_8_right) - J_1 * c_2_lo))
    Bo_9_rounded = (Bo_9
        + (J_8 - (Bo_9 + Bo_9_right) - product_rest(J_2, c_2, Bo_9a, Bo_9_right) - J_2 * c_2_lo))
    Bo_4_final = where(Bo_4_rounded == Bo_4_rounded, Bo_4_rounded, Bo_4)
    Bo_5_final = where(Bo_5_rounded == Bo_5_rounded, Bo_5_rounded, Bo_5)
    Bo_6_final = where(Bo_6_rounded == Bo_6_rounded, Bo_6_rounded, Bo_6)
    Bo_7_final = where(Bo_7_rounded == Bo_7_rounded, Bo_7_rounded, Bo_7)
    Bo_8_final = where(Bo_8_rounded == Bo_8_rounded, Bo_8_rounded, Bo_8)
    Bo_9_final = where(Bo_9_rounded == Bo_9_rounded, Bo_9_rounded, Bo_9)
    return (J_0, J_1, J_2, J_3, Bo_4_final, Bo_5_final, Bo_6_final, Bo_7_final, Bo_8_final,
        Bo_9_final)


@kernel("(10)->(10)")
def inertia_from_spatial_inertia(B):
    """Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of
    mass; NaN where m = 0.

    (10)->(10).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2).
    15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.  Error of a
    moment <= 4 u times the sum of its |terms|, barring over- and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    c_0 = B_1 / B_0
    c_0_product = c_0 * B_0
    c_1 = B_2 / B_0
    c_1_product = c_1 * B_0
    c_1_lo = (B_2 - c_1_product - product_error(c_1, B_0, c_1_product)) / B_0
    c_2 = B_3 / B_0
    c_2_product = c_2 * B_0
    c_2_lo = (B_3 - c_2_product - product_error(c_2, B_0, c_2_product)) / B_0
    squares_0 = B_1 * c_0
    squares_0_cross2 = B_1 * ((B_1 - c_0_product - product_error(c_0, B_0, c_0_product)) / B_0)
    squares_1 = B_2 * c_1
    squares_1_cross2 = B_2 * c_1_lo
    squares_2 = B_3 * c_2
    squares_2_cross2 = B_3 * c_2_lo
    Jo_4a = squares_1 + squares_2
    Jo_4a_right = Jo_4a - squares_1
    Jo_4a_lo1 = (product_rest(B_2, c_1, squares_1, Jo_4a - Jo_4a_right)
        + product_rest(B_3, c_2, squares_2, Jo_4a_right))
    Jo_4 = B_4 - Jo_4a
    Jo_4_right = B_4 - Jo_4
    Jo_5a = squares_0 + squares_2
    Jo_5a_right = Jo_5a - squares_0
    Jo_5a_lo1 = (product_rest(B_1, c_0, squares_0, Jo_5a - Jo_5a_right)
        + product_rest(B_3, c_2, squares_2, Jo_5a_right))
    Jo_5 = B_5 - Jo_5a
    Jo_5_right = B_5 - Jo_5
    Jo_6a = squares_0 + squares_1
    Jo_6a_right = Jo_6a - squares_0
    Jo_6a_lo1 = (product_rest(B_1, c_0, squares_0, Jo_6a - Jo_6a_right)
        + product_rest(B_2, c_1, squares_1, Jo_6a_right))
    Jo_6 = B_6 - Jo_6a
    Jo_6_right = B_6 - Jo_6
    Jo_7a = B_1 * c_1
    Jo_7 = Jo_7a + B_7
    Jo_7_right = Jo_7 - Jo_7a
    Jo_8a = B_2 * c_2
    Jo_8 = Jo_8a + B_9
    Jo_8_right = Jo_8 - Jo_8a
    Jo_9a = B_1 * c_2
    Jo_9 = Jo_9a + B_8
    Jo_9_right = Jo_9 - Jo_9a
    Jo_4_rounded = (Jo_4
        + (B_4 - (Jo_4 + Jo_4_right) - (Jo_4a - Jo_4_right)
        - (Jo_4a_lo1 + (squares_1_cross2 + squares_2_cross2))))
    Jo_5_rounded = (Jo_5
        + (B_5 - (Jo_5 + Jo_5_right) - (Jo_5a - Jo_5_right)
        - (Jo_5a_lo1 + (squares_0_cross2 + squares_2_cross2))))
    Jo_6_rounded = (Jo_6
        + (B_6 - (Jo_6 + Jo_6_right) - (Jo_6a - Jo_6_right)
        - (Jo_6a_lo1 + (squares_0_cross2 + squares_1_cross2))))
    Jo_7_rounded = (Jo_7
        + (product_rest(B_1, c_1, Jo_7a, Jo_7 - Jo_7_right) + (B_7 - Jo_7_right) + B_1 * c_1_lo))
    Jo_8_rounded = (Jo_8
        + (product_rest(B_2, c_2, Jo_8a, Jo_8 - Jo_8_right) + (B_9 - Jo_8_right) + B_2 * c_2_lo))
    Jo_9_rounded = (Jo_9
        + (product_rest(B_1, c_2, Jo_9a, Jo_9 - Jo_9_right) + (B_8 - Jo_9_right) + B_1 * c_2_lo))
    Jo_4_final = where(Jo_4_rounded == Jo_4_rounded, Jo_4_rounded, Jo_4)
    Jo_5_final = where(Jo_5_rounded == Jo_5_rounded, Jo_5_rounded, Jo_5)
    Jo_6_final = where(Jo_6_rounded == Jo_6_rounded, Jo_6_rounded, Jo_6)
    Jo_7_final = where(Jo_7_rounded == Jo_7_rounded, Jo_7_rounded, Jo_7)
    Jo_8_final = where(Jo_8_rounded == Jo_8_rounded, Jo_8_rounded, Jo_8)
    Jo_9_final = where(Jo_9_rounded == Jo_9_rounded, Jo_9_rounded, Jo_9)
    return (B_0, B_1, B_2, B_3, Jo_4_final, Jo_5_final, Jo_6_final, Jo_7_final, Jo_8_final,
        Jo_9_final)


@kernel("(10)->(3)")
def spatial_inertia_com(B):
    """vo = h / m, the centre of mass in m.

    (10)->(3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); vo: vector.
    3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select.  Error <= u |result|, barring over-
    and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    vo_0 = B_1 / B_0
    vo_0_product = vo_0 * B_0
    vo_1 = B_2 / B_0
    vo_1_product = vo_1 * B_0
    vo_2 = B_3 / B_0
    vo_2_product = vo_2 * B_0
    vo_0_rounded = vo_0 + (B_1 - vo_0_product - product_error(vo_0, B_0, vo_0_product)) / B_0
    vo_1_rounded = vo_1 + (B_2 - vo_1_product - product_error(vo_1, B_0, vo_1_product)) / B_0
    vo_2_rounded = vo_2 + (B_3 - vo_2_product - product_error(vo_2, B_0, vo_2_product)) / B_0
    vo_0_final = where(vo_0_rounded == vo_0_rounded, vo_0_rounded, vo_0)
    vo_1_final = where(vo_1_rounded == vo_1_rounded, vo_1_rounded, vo_1)
    vo_2_final = where(vo_2_rounded == vo_2_rounded, vo_2_rounded, vo_2)
    return (vo_0_final, vo_1_final, vo_2_final)


@kernel("(10)->(3,3)")
def spatial_inertia_about_com(B):
    """Ro = I + h~ h~ / m, the second moments about the centre of mass.

    (10)->(3,3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Ro: rotation or other 3×3 matrix.
    15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    c_0 = B_1 / B_0
    c_0_product = c_0 * B_0
    c_1 = B_2 / B_0
    c_1_product = c_1 * B_0
    c_1_lo = (B_2 - c_1_product - product_error(c_1, B_0, c_1_product)) / B_0
    c_2 = B_3 / B_0
    c_2_product = c_2 * B_0
    c_2_lo = (B_3 - c_2_product - product_error(c_2, B_0, c_2_product)) / B_0
    squares_0 = B_1 * c_0
    squares_0_cross2 = B_1 * ((B_1 - c_0_product - product_error(c_0, B_0, c_0_product)) / B_0)
    squares_1 = B_2 * c_1
    squares_1_cross2 = B_2 * c_1_lo
    squares_2 = B_3 * c_2
    squares_2_cross2 = B_3 * c_2_lo
    about_0a = squares_1 + squares_2
    about_0a_right = about_0a - squares_1
    about_0a_lo1 = (product_rest(B_2, c_1, squares_1, about_0a - about_0a_right)
        + product_rest(B_3, c_2, squares_2, about_0a_right))
    about_0 = B_4 - about_0a
    about_0_right = B_4 - about_0
    about_1a = squares_0 + squares_2
    about_1a_right = about_1a - squares_0
    about_1a_lo1 = (product_rest(B_1, c_0, squares_0, about_1a - about_1a_right)
        + product_rest(B_3, c_2, squares_2, about_1a_right))
    about_1 = B_5 - about_1a
    about_1_right = B_5 - about_1
    about_2a = squares_0 + squares_1
    about_2a_right = about_2a - squares_0
    about_2a_lo1 = (product_rest(B_1, c_0, squares_0, about_2a - about_2a_right)
        + product_rest(B_2, c_1, squares_1, about_2a_right))
    about_2 = B_6 - about_2a
    about_2_right = B_6 - about_2
    about_3a = B_1 * c_1
    about_3 = about_3a + B_7
    about_3_right = about_3 - about_3a
    about_4a = B_1 * c_2
    about_4 = about_4a + B_8
    about_4_right = about_4 - about_4a
    about_5a = B_2 * c_2
    about_5 = about_5a + B_9
    about_5_right = about_5 - about_5a
    about_0_rounded = (about_0
        + (B_4 - (about_0 + about_0_right) - (about_0a - about_0_right)
        - (about_0a_lo1 + (squares_1_cross2 + squares_2_cross2))))
    about_3_rounded = (about_3
        + (product_rest(B_1, c_1, about_3a, about_3 - about_3_right) + (B_7 - about_3_right) + B_1
        * c_1_lo))
    about_3_final = where(about_3_rounded == about_3_rounded, about_3_rounded, about_3)
    about_4_rounded = (about_4
        + (product_rest(B_1, c_2, about_4a, about_4 - about_4_right) + (B_8 - about_4_right) + B_1
        * c_2_lo))
    about_4_final = where(about_4_rounded == about_4_rounded, about_4_rounded, about_4)
    about_1_rounded = (about_1
        + (B_5 - (about_1 + about_1_right) - (about_1a - about_1_right)
        - (about_1a_lo1 + (squares_0_cross2 + squares_2_cross2))))
    about_5_rounded = (about_5
        + (product_rest(B_2, c_2, about_5a, about_5 - about_5_right) + (B_9 - about_5_right) + B_2
        * c_2_lo))
    about_5_final = where(about_5_rounded == about_5_rounded, about_5_rounded, about_5)
    about_2_rounded = (about_2
        + (B_6 - (about_2 + about_2_right) - (about_2a - about_2_right)
        - (about_2a_lo1 + (squares_0_cross2 + squares_1_cross2))))
    about_0_final = where(about_0_rounded == about_0_rounded, about_0_rounded, about_0)
    about_1_final = where(about_1_rounded == about_1_rounded, about_1_rounded, about_1)
    about_2_final = where(about_2_rounded == about_2_rounded, about_2_rounded, about_2)
    return (about_0_final, about_3_final, about_4_final, about_3_final, about_1_final,
        about_5_final, about_4_final, about_5_final, about_2_final)


@kernel("(10),(6)->(6)")
def product_Bs(B, s):
    """co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.

    (10),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
    24 mul, 102 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 19) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    co_0a = B_0 * s_0
    co_0b = B_3 * s_4
    co_0c = B_2 * s_5
    co_0d = co_0b - co_0c
    co_0d_right = co_0b - co_0d
    co_0 = co_0a + co_0d
    co_0_right = co_0 - co_0a
    co_0d_lo = (product_rest(B_3, s_4, co_0b, co_0d + co_0d_right)
        - product_rest(B_2, s_5, co_0c, co_0d_right))
    co_1a = B_0 * s_1
    co_1b = B_1 * s_5
    co_1c = B_3 * s_3
    co_1d = co_1b - co_1c
    co_1d_right = co_1b - co_1d
    co_1 = co_1a + co_1d
    co_1_right = co_1 - co_1a
    co_1d_lo = (product_rest(B_1, s_5, co_1b, co_1d + co_1d_right)
        - product_rest(B_3, s_3, co_1c, co_1d_right))
    co_2a = B_0 * s_2
    co_2b = B_2 * s_3
    co_2c = B_1 * s_4
    co_2d = co_2b - co_2c
    co_2d_right = co_2b - co_2d
    co_2 = co_2a + co_2d
    co_2_right = co_2 - co_2a
    co_2d_lo = (product_rest(B_2, s_3, co_2b, co_2d + co_2d_right)
        - product_rest(B_1, s_4, co_2c, co_2d_right))
    co_3a = B_2 * s_2
    co_3b = B_3 * s_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3d = B_4 * s_3
    co_3e = B_7 * s_4
    co_3f = co_3d + co_3e
    co_3f_right = co_3f - co_3d
    co_3g = B_8 * s_5
    co_3h = co_3f + co_3g
    co_3h_right = co_3h - co_3f
    co_3f_lo = (product_rest(B_4, s_3, co_3d, co_3f - co_3f_right)
        + product_rest(B_7, s_4, co_3e, co_3f_right))
    co_3 = co_3c + co_3h
    co_3_right = co_3 - co_3c
    co_3h_lo = co_3f - (co_3h - co_3h_right) + product_rest(B_8, s_5, co_3g, co_3h_right) + co_3f_lo
    co_3c_lo = (product_rest(B_2, s_2, co_3a, co_3c + co_3c_right)
        - product_rest(B_3, s_1, co_3b, co_3c_right))
    co_4a = B_3 * s_0
    co_4b = B_1 * s_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4d = B_5 * s_4
    co_4e = B_7 * s_3
    co_4f = co_4d + co_4e
    co_4f_right = co_4f - co_4d
    co_4g = B_9 * s_5
    co_4h = co_4f + co_4g
    co_4h_right = co_4h - co_4f
    co_4f_lo = (product_rest(B_5, s_4, co_4d, co_4f - co_4f_right)
        + product_rest(B_7, s_3, co_4e, co_4f_right))
    co_4 = co_4c + co_4h
    co_4_right = co_4 - co_4c
    co_4h_lo = co_4f - (co_4h - co_4h_right) + product_rest(B_9, s_5, co_4g, co_4h_right) + co_4f_lo
    co_4c_lo = (product_rest(B_3, s_0, co_4a, co_4c + co_4c_right)
        - product_rest(B_1, s_2, co_4b, co_4c_right))
    co_5a = B_1 * s_1
    co_5b = B_2 * s_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5d = B_6 * s_5
    co_5e = B_8 * s_3
    co_5f = co_5d + co_5e
    co_5f_right = co_5f - co_5d
    co_5g = B_9 * s_4
    co_5h = co_5f + co_5g
    co_5h_right = co_5h - co_5f
    co_5f_lo = (product_rest(B_6, s_5, co_5d, co_5f - co_5f_right)
        + product_rest(B_8, s_3, co_5e, co_5f_right))
    co_5 = co_5c + co_5h
    co_5_right = co_5 - co_5c
    co_5h_lo = co_5f - (co_5h - co_5h_right) + product_rest(B_9, s_4, co_5g, co_5h_right) + co_5f_lo
    co_5c_lo = (product_rest(B_1, s_1, co_5a, co_5c + co_5c_right)
        - product_rest(B_2, s_0, co_5b, co_5c_right))
    co_0_rounded = (co_0
        + (product_rest(B_0, s_0, co_0a, co_0 - co_0_right) + (co_0d - co_0_right) + co_0d_lo))
    co_1_rounded = (co_1
        + (product_rest(B_0, s_1, co_1a, co_1 - co_1_right) + (co_1d - co_1_right) + co_1d_lo))
    co_2_rounded = (co_2
        + (product_rest(B_0, s_2, co_2a, co_2 - co_2_right) + (co_2d - co_2_right) + co_2d_lo))
    co_3_rounded = co_3 + (co_3c - (co_3 - co_3_right) + (co_3h - co_3_right) + co_3h_lo + co_3c_lo)
    co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (co_4h - co_4_right) + co_4h_lo + co_4c_lo)
    co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (co_5h - co_5_right) + co_5h_lo + co_5c_lo)
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(10),(6)->()")
def spatial_inertia_energy(B, s):
    """s·B s / 2, the kinetic energy in J of a body that moves with s.

    (10),(6)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy: number.
    34 mul, 142 add, 25 product rest.  Error <= u |result| + 44 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    square_a = s_0 * s_0
    square_b = s_1 * s_1
    square_c = square_a + square_b
    square_c_right = square_c - square_a
    square_d = s_2 * s_2
    square = square_c + square_d
    square_right = square - square_c
    square_c_lo = (product_rest(s_0, s_0, square_a, square_c - square_c_right)
        + product_rest(s_1, s_1, square_b, square_c_right))
    square_lo = (square_c - (square - square_right)
        + product_rest(s_2, s_2, square_d, square_right) + square_c_lo)
    L_0a = B_4 * s_3
    L_0b = B_7 * s_4
    L_0c = L_0a + L_0b
    L_0c_right = L_0c - L_0a
    L_0d = B_8 * s_5
    L_0 = L_0c + L_0d
    L_0_right = L_0 - L_0c
    L_0c_lo = (product_rest(B_4, s_3, L_0a, L_0c - L_0c_right)
        + product_rest(B_7, s_4, L_0b, L_0c_right))
    L_0_lo = L_0c - (L_0 - L_0_right) + product_rest(B_8, s_5, L_0d, L_0_right) + L_0c_lo
    L_1a = B_5 * s_4
    L_1b = B_7 * s_3
    L_1c = L_1a + L_1b
    L_1c_right = L_1c - L_1a
    L_1d = B_9 * s_5
    L_1 = L_1c + L_1d
    L_1_right = L_1 - L_1c
    L_1c_lo = (product_rest(B_5, s_4, L_1a, L_1c - L_1c_right)
        + product_rest(B_7, s_3, L_1b, L_1c_right))
    L_1_lo = L_1c - (L_1 - L_1_right) + product_rest(B_9, s_5, L_1d, L_1_right) + L_1c_lo
    L_2a = B_6 * s_5
    L_2b = B_8 * s_3
    L_2c = L_2a + L_2b
    L_2c_right = L_2c - L_2a
    L_2d = B_9 * s_4
    L_2 = L_2c + L_2d
    L_2_right = L_2 - L_2c
    L_2c_lo = (product_rest(B_6, s_5, L_2a, L_2c - L_2c_right)
        + product_rest(B_8, s_3, L_2b, L_2c_right))
    L_2_lo = L_2c - (L_2 - L_2_right) + product_rest(B_9, s_4, L_2d, L_2_right) + L_2c_lo
    square_sum = square + square_lo
    square_sum_right = square_sum - square
    twice_a = B_0 * square_sum
    L_0_sum = L_0 + L_0_lo
    L_0_sum_right = L_0_sum - L_0
    twice_b = s_3 * L_0_sum
    L_1_sum = L_1 + L_1_lo
    L_1_sum_right = L_1_sum - L_1
    twice_c = s_4 * L_1_sum
    twice_d = twice_b + twice_c
    twice_d_right = twice_d - twice_b
    twice_b_cross2 = s_3 * (L_0 - (L_0_sum - L_0_sum_right) + (L_0_lo - L_0_sum_right))
    twice_d_lo1 = (product_rest(s_3, L_0_sum, twice_b, twice_d - twice_d_right)
        + product_rest(s_4, L_1_sum, twice_c, twice_d_right))
    L_2_sum = L_2 + L_2_lo
    L_2_sum_right = L_2_sum - L_2
    twice_e = s_5 * L_2_sum
    twice_f = twice_d + twice_e
    twice_f_right = twice_f - twice_d
    twice_f_lo1 = (twice_d - (twice_f - twice_f_right)
        + product_rest(s_5, L_2_sum, twice_e, twice_f_right))
    twice_d_lo = (twice_d_lo1
        + (twice_b_cross2 + s_4 * (L_1 - (L_1_sum - L_1_sum_right) + (L_1_lo - L_1_sum_right))))
    twice = twice_a + twice_f
    twice_right = twice - twice_a
    twice_f_lo = (twice_f_lo1 + s_5 * (L_2 - (L_2_sum - L_2_sum_right) + (L_2_lo - L_2_sum_right))
        + twice_d_lo)
    twice_lo2 = (product_rest(B_0, square_sum, twice_a, twice - twice_right)
        + (twice_f - twice_right) + twice_f_lo)
    twice_lo = (twice_lo2 + B_0
        * (square - (square_sum - square_sum_right) + (square_lo - square_sum_right)))
    across_0a = B_3 * s_4
    across_0b = B_2 * s_5
    across_0 = across_0a - across_0b
    across_0_right = across_0a - across_0
    across_0_lo = (product_rest(B_3, s_4, across_0a, across_0 + across_0_right)
        - product_rest(B_2, s_5, across_0b, across_0_right))
    across_1a = B_1 * s_5
    across_1b = B_3 * s_3
    across_1 = across_1a - across_1b
    across_1_right = across_1a - across_1
    across_1_lo = (product_rest(B_1, s_5, across_1a, across_1 + across_1_right)
        - product_rest(B_3, s_3, across_1b, across_1_right))
    across_2a = B_2 * s_3
    across_2b = B_1 * s_4
    across_2 = across_2a - across_2b
    across_2_right = across_2a - across_2
    across_2_lo = (product_rest(B_2, s_3, across_2a, across_2 + across_2_right)
        - product_rest(B_1, s_4, across_2b, across_2_right))
    across_0_sum = across_0 + across_0_lo
    across_0_sum_right = across_0_sum - across_0
    energy_a = s_0 * across_0_sum
    across_1_sum = across_1 + across_1_lo
    across_1_sum_right = across_1_sum - across_1
    energy_b = s_1 * across_1_sum
    energy_c = energy_a + energy_b
    energy_c_right = energy_c - energy_a
    energy_a_cross2 = (s_0
        * (across_0 - (across_0_sum - across_0_sum_right) + (across_0_lo - across_0_sum_right)))
    energy_c_lo1 = (product_rest(s_0, across_0_sum, energy_a, energy_c - energy_c_right)
        + product_rest(s_1, across_1_sum, energy_b, energy_c_right))
    across_2_sum = across_2 + across_2_lo
    across_2_sum_right = across_2_sum - across_2
    energy_d = s_2 * across_2_sum
    energy_e = energy_c + energy_d
    energy_e_right = energy_e - energy_c
    energy_e_lo1 = (energy_c - (energy_e - energy_e_right)
        + product_rest(s_2, across_2_sum, energy_d, energy_e_right))
    energy_c_lo = (energy_c_lo1
        + (energy_a_cross2 + s_1
        * (across_1 - (across_1_sum - across_1_sum_right) + (across_1_lo - across_1_sum_right))))
    twice_sum = twice + twice_lo
    twice_sum_right = twice_sum - twice
    energy_f = 0.5 * twice_sum
    energy = energy_e + energy_f
    energy_right = energy - energy_e
    energy_f_cross2 = 0.5 * (twice - (twice_sum - twice_sum_right) + (twice_lo - twice_sum_right))
    energy_e_lo = (energy_e_lo1 + s_2
        * (across_2 - (across_2_sum - across_2_sum_right) + (across_2_lo - across_2_sum_right))
        + energy_c_lo)
    energy_rounded = (energy
        + (energy_e - (energy - energy_right) + (energy_f - energy_right) + energy_f_cross2
        + energy_e_lo))
    return energy_rounded


@kernel("(10),(3),(6)->(6)")
def spatial_inertia_net_wrench(B, w, ds):
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
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    w_0, w_1, w_2 = w
    ds_0, ds_1, ds_2, ds_3, ds_4, ds_5 = ds
    ww_0 = w_0 * w_0
    ww_1 = w_1 * w_1
    ww_2 = w_2 * w_2
    ww_3 = w_0 * w_1
    ww_4 = w_0 * w_2
    ww_5 = w_1 * w_2
    U_0a = ww_1 + ww_2
    U_0a_right = U_0a - ww_1
    U_0 = -U_0a
    U_1 = ww_3 - ds_5
    U_1_right = ww_3 - U_1
    U_1_lo = product_rest(w_0, w_1, ww_3, U_1 + U_1_right) - (ds_5 - U_1_right)
    U_2 = ds_4 + ww_4
    U_2_right = U_2 - ds_4
    U_2_lo = ds_4 - (U_2 - U_2_right) + product_rest(w_0, w_2, ww_4, U_2_right)
    U_3 = ds_5 + ww_3
    U_3_right = U_3 - ds_5
    U_3_lo = ds_5 - (U_3 - U_3_right) + product_rest(w_0, w_1, ww_3, U_3_right)
    U_4a = ww_0 + ww_2
    U_4a_right = U_4a - ww_0
    U_4 = -U_4a
    U_5 = ww_5 - ds_3
    U_5_right = ww_5 - U_5
    U_5_lo = product_rest(w_1, w_2, ww_5, U_5 + U_5_right) - (ds_3 - U_5_right)
    U_6 = ww_4 - ds_4
    U_6_right = ww_4 - U_6
    U_6_lo = product_rest(w_0, w_2, ww_4, U_6 + U_6_right) - (ds_4 - U_6_right)
    U_7 = ds_3 + ww_5
    U_7_right = U_7 - ds_3
    U_7_lo = ds_3 - (U_7 - U_7_right) + product_rest(w_1, w_2, ww_5, U_7_right)
    U_8a = ww_0 + ww_1
    U_8a_right = U_8a - ww_0
    U_8 = -U_8a
    others_0 = B_6 - B_5
    others_0_right = B_6 - others_0
    others_0_lo = B_6 - (others_0 + others_0_right) - (B_5 - others_0_right)
    others_1 = B_4 - B_6
    others_1_right = B_4 - others_1
    others_1_lo = B_4 - (others_1 + others_1_right) - (B_6 - others_1_right)
    others_2 = B_5 - B_4
    others_2_right = B_5 - others_2
    others_2_lo = B_5 - (others_2 + others_2_right) - (B_4 - others_2_right)
    squares_0 = ww_1 - ww_2
    squares_0_right = ww_1 - squares_0
    squares_0_lo = (product_rest(w_1, w_1, ww_1, squares_0 + squares_0_right)
        - product_rest(w_2, w_2, ww_2, squares_0_right))
    squares_1 = ww_2 - ww_0
    squares_1_right = ww_2 - squares_1
    squares_1_lo = (product_rest(w_2, w_2, ww_2, squares_1 + squares_1_right)
        - product_rest(w_0, w_0, ww_0, squares_1_right))
    squares_2 = ww_0 - ww_1
    squares_2_right = ww_0 - squares_2
    squares_2_lo = (product_rest(w_0, w_0, ww_0, squares_2 + squares_2_right)
        - product_rest(w_1, w_1, ww_1, squares_2_right))
    own_0a = B_4 * ds_3
    others_0_sum = others_0 + others_0_lo
    others_0_sum_right = others_0_sum - others_0
    own_0b = ww_5 * others_0_sum
    own_0b_cross2 = (ww_5
        * (others_0 - (others_0_sum - others_0_sum_right) + (others_0_lo - others_0_sum_right)))
    own_0 = own_0a + own_0b
    own_0_right = own_0 - own_0a
    own_0_lo1 = (product_rest(B_4, ds_3, own_0a, own_0 - own_0_right)
        + product_rest(ww_5, others_0_sum, own_0b, own_0_right))
    own_1a = B_5 * ds_4
    others_1_sum = others_1 + others_1_lo
    others_1_sum_right = others_1_sum - others_1
    own_1b = ww_4 * others_1_sum
    own_1b_cross2 = (ww_4
        * (others_1 - (others_1_sum - others_1_sum_right) + (others_1_lo - others_1_sum_right)))
    own_1 = own_1a + own_1b
    own_1_right = own_1 - own_1a
    own_1_lo1 = (product_rest(B_5, ds_4, own_1a, own_1 - own_1_right)
        + product_rest(ww_4, others_1_sum, own_1b, own_1_right))
    own_2a = B_6 * ds_5
    others_2_sum = others_2 + others_2_lo
    others_2_sum_right = others_2_sum - others_2
    own_2b = ww_3 * others_2_sum
    own_2b_cross2 = (ww_3
        * (others_2 - (others_2_sum - others_2_sum_right) + (others_2_lo - others_2_sum_right)))
    own_2 = own_2a + own_2b
    own_2_right = own_2 - own_2a
    own_2_lo1 = (product_rest(B_6, ds_5, own_2a, own_2 - own_2_right)
        + product_rest(ww_3, others_2_sum, own_2b, own_2_right))
    U_3_sum = U_3 + U_3_lo
    U_3_sum_right = U_3_sum - U_3
    U_3_sum_lo = U_3 - (U_3_sum - U_3_sum_right) + (U_3_lo - U_3_sum_right)
    N_0a = B_8 * U_3_sum
    U_6_sum = U_6 + U_6_lo
    U_6_sum_right = U_6_sum - U_6
    U_6_sum_lo = U_6 - (U_6_sum - U_6_sum_right) + (U_6_lo - U_6_sum_right)
    N_0b = B_7 * U_6_sum
    N_0c = N_0a - N_0b
    N_0c_right = N_0a - N_0c
    squares_0_sum = squares_0 + squares_0_lo
    squares_0_sum_right = squares_0_sum - squares_0
    N_0d = B_9 * squares_0_sum
    N_0e = N_0c + N_0d
    N_0e_right = N_0e - N_0c
    N_0d_cross2 = (B_9
        * (squares_0 - (squares_0_sum - squares_0_sum_right)
        + (squares_0_lo - squares_0_sum_right)))
    N_0c_lo = (product_rest(B_8, U_3_sum, N_0a, N_0c + N_0c_right)
        - product_rest(B_7, U_6_sum, N_0b, N_0c_right) + (B_8 * U_3_sum_lo - B_7 * U_6_sum_lo))
    N_0 = N_0e + own_0
    N_0_right = N_0 - N_0e
    N_0_lo2 = (N_0e - (N_0 - N_0_right) + (own_0 - N_0_right)
        + (own_0_lo1 + (product_error(w_1, w_2, ww_5) * others_0_sum + own_0b_cross2)))
    U_7_sum = U_7 + U_7_lo
    U_7_sum_right = U_7_sum - U_7
    U_7_sum_lo = U_7 - (U_7_sum - U_7_sum_right) + (U_7_lo - U_7_sum_right)
    N_1a = B_7 * U_7_sum
    U_1_sum = U_1 + U_1_lo
    U_1_sum_right = U_1_sum - U_1
    U_1_sum_lo = U_1 - (U_1_sum - U_1_sum_right) + (U_1_lo - U_1_sum_right)
    N_1b = B_9 * U_1_sum
    N_1c = N_1a - N_1b
    N_1c_right = N_1a - N_1c
    squares_1_sum = squares_1 + squares_1_lo
    squares_1_sum_right = squares_1_sum - squares_1
    N_1d = B_8 * squares_1_sum
    N_1e = N_1c + N_1d
    N_1e_right = N_1e - N_1c
    N_1d_cross2 = (B_8
        * (squares_1 - (squares_1_sum - squares_1_sum_right)
        + (squares_1_lo - squares_1_sum_right)))
    N_1c_lo = (product_rest(B_7, U_7_sum, N_1a, N_1c + N_1c_right)
        - product_rest(B_9, U_1_sum, N_1b, N_1c_right) + (B_7 * U_7_sum_lo - B_9 * U_1_sum_lo))
    N_1 = N_1e + own_1
    N_1_right = N_1 - N_1e
    N_1_lo2 = (N_1e - (N_1 - N_1_right) + (own_1 - N_1_right)
        + (own_1_lo1 + (product_error(w_0, w_2, ww_4) * others_1_sum + own_1b_cross2)))
    squares_2_sum = squares_2 + squares_2_lo
    squares_2_sum_right = squares_2_sum - squares_2
    N_2a = B_7 * squares_2_sum
    U_2_sum = U_2 + U_2_lo
    U_2_sum_right = U_2_sum - U_2
    U_2_sum_lo = U_2 - (U_2_sum - U_2_sum_right) + (U_2_lo - U_2_sum_right)
    N_2b = B_9 * U_2_sum
    U_5_sum = U_5 + U_5_lo
    U_5_sum_right = U_5_sum - U_5
    U_5_sum_lo = U_5 - (U_5_sum - U_5_sum_right) + (U_5_lo - U_5_sum_right)
    N_2c = B_8 * U_5_sum
    N_2d = N_2b - N_2c
    N_2d_right = N_2b - N_2d
    N_2e = N_2a + N_2d
    N_2e_right = N_2e - N_2a
    N_2d_lo = (product_rest(B_9, U_2_sum, N_2b, N_2d + N_2d_right)
        - product_rest(B_8, U_5_sum, N_2c, N_2d_right) + (B_9 * U_2_sum_lo - B_8 * U_5_sum_lo))
    N_2a_cross2 = (B_7
        * (squares_2 - (squares_2_sum - squares_2_sum_right)
        + (squares_2_lo - squares_2_sum_right)))
    N_2 = N_2e + own_2
    N_2_right = N_2 - N_2e
    N_2_lo2 = (N_2e - (N_2 - N_2_right) + (own_2 - N_2_right)
        + (own_2_lo1 + (product_error(w_0, w_1, ww_3) * others_2_sum + own_2b_cross2)))
    co_0a = B_0 * ds_0
    co_0b = B_1 * U_0
    co_0c = B_2 * U_1_sum
    co_0d = co_0b + co_0c
    co_0d_right = co_0d - co_0b
    co_0d_cross = (B_1 *
        -(product_rest(w_1, w_1, ww_1, U_0a - U_0a_right)
        + product_rest(w_2, w_2, ww_2, U_0a_right)) + B_2 * U_1_sum_lo)
    co_0e = B_3 * U_2_sum
    co_0f = co_0d + co_0e
    co_0f_right = co_0f - co_0d
    co_0d_lo = (product_rest(B_1, U_0, co_0b, co_0d - co_0d_right)
        + product_rest(B_2, U_1_sum, co_0c, co_0d_right) + co_0d_cross)
    co_0 = co_0a + co_0f
    co_0_right = co_0 - co_0a
    co_0f_lo = (co_0d - (co_0f - co_0f_right) + product_rest(B_3, U_2_sum, co_0e, co_0f_right)
        + B_3 * U_2_sum_lo + co_0d_lo)
    co_1a = B_0 * ds_1
    co_1b = B_1 * U_3_sum
    co_1c = B_2 * U_4
    co_1d = co_1b + co_1c
    co_1d_right = co_1d - co_1b
    co_1d_cross = (B_1 * U_3_sum_lo + B_2 *
        -(product_rest(w_0, w_0, ww_0, U_4a - U_4a_right)
        + product_rest(w_2, w_2, ww_2, U_4a_right)))
    co_1e = B_3 * U_5_sum
    co_1f = co_1d + co_1e
    co_1f_right = co_1f - co_1d
    co_1d_lo = (product_rest(B_1, U_3_sum, co_1b, co_1d - co_1d_right)
        + product_rest(B_2, U_4, co_1c, co_1d_right) + co_1d_cross)
    co_1 = co_1a + co_1f
    co_1_right = co_1 - co_1a
    co_1f_lo = (co_1d - (co_1f - co_1f_right) + product_rest(B_3, U_5_sum, co_1e, co_1f_right)
        + B_3 * U_5_sum_lo + co_1d_lo)
    co_2a = B_0 * ds_2
    co_2b = B_1 * U_6_sum
    co_2c = B_2 * U_7_sum
    co_2d = co_2b + co_2c
    co_2d_right = co_2d - co_2b
    co_2d_lo1 = (product_rest(B_1, U_6_sum, co_2b, co_2d - co_2d_right)
        + product_rest(B_2, U_7_sum, co_2c, co_2d_right))
    co_2e = B_3 * U_8
    co_2f = co_2d + co_2e
    co_2f_right = co_2f - co_2d
    co_2e_cross2 = (B_3 *
        -(product_rest(w_0, w_0, ww_0, U_8a - U_8a_right)
        + product_rest(w_1, w_1, ww_1, U_8a_right)))
    co_2f_lo2 = (co_2d - (co_2f - co_2f_right) + product_rest(B_3, U_8, co_2e, co_2f_right)
        + co_2e_cross2)
    co_2 = co_2a + co_2f
    co_2_right = co_2 - co_2a
    co_3a = B_2 * ds_2
    co_3b = B_3 * ds_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + N_0
    co_3_right = co_3 - co_3c
    N_0_lo = (N_0_lo2
        + (N_0c - (N_0e - N_0e_right) + product_rest(B_9, squares_0_sum, N_0d, N_0e_right)
        + N_0d_cross2 + N_0c_lo))
    co_3c_lo = (product_rest(B_2, ds_2, co_3a, co_3c + co_3c_right)
        - product_rest(B_3, ds_1, co_3b, co_3c_right))
    co_4a = B_3 * ds_0
    co_4b = B_1 * ds_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + N_1
    co_4_right = co_4 - co_4c
    N_1_lo = (N_1_lo2
        + (N_1c - (N_1e - N_1e_right) + product_rest(B_8, squares_1_sum, N_1d, N_1e_right)
        + N_1d_cross2 + N_1c_lo))
    co_4c_lo = (product_rest(B_3, ds_0, co_4a, co_4c + co_4c_right)
        - product_rest(B_1, ds_2, co_4b, co_4c_right))
    co_5a = B_1 * ds_1
    co_5b = B_2 * ds_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + N_2
    co_5_right = co_5 - co_5c
    N_2_lo = (N_2_lo2
        + (product_rest(B_7, squares_2_sum, N_2a, N_2e - N_2e_right) + (N_2d - N_2e_right)
        + N_2d_lo + N_2a_cross2))
    co_5c_lo = (product_rest(B_1, ds_1, co_5a, co_5c + co_5c_right)
        - product_rest(B_2, ds_0, co_5b, co_5c_right))
    co_0_rounded = (co_0
        + (product_rest(B_0, ds_0, co_0a, co_0 - co_0_right) + (co_0f - co_0_right) + co_0f_lo))
    co_1_rounded = (co_1
        + (product_rest(B_0, ds_1, co_1a, co_1 - co_1_right) + (co_1f - co_1_right) + co_1f_lo))
    co_2_lo = (product_rest(B_0, ds_2, co_2a, co_2 - co_2_right) + (co_2f - co_2_right)
        + (co_2f_lo2 + (co_2d_lo1 + (B_1 * U_6_sum_lo + B_2 * U_7_sum_lo))))
    co_2_rounded = co_2 + co_2_lo
    co_3_rounded = co_3 + (co_3c - (co_3 - co_3_right) + (N_0 - co_3_right) + N_0_lo + co_3c_lo)
    co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (N_1 - co_4_right) + N_1_lo + co_4c_lo)
    co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (N_2 - co_5_right) + N_2_lo + co_5c_lo)
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3),(10)->(10)")
def spatial_inertia_shifted(t, B):
    """Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.

    (3),(10)->(10).  t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the
    origin, xx, yy, zz, xy, xz, yz in kg m^2).
    33 mul, 138 add, 6 product error, 6 product rest.  Error <= u |result| + (m: 0, h: 2, I: 20)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    mt_0 = t_0 * B_0
    mt_1 = t_1 * B_0
    mt_2 = t_2 * B_0
    mt_0_lo = product_error(t_0, B_0, mt_0)
    half_0 = 0.5 * mt_0
    mt_1_lo = product_error(t_1, B_0, mt_1)
    half_1 = 0.5 * mt_1
    mt_2_lo = product_error(t_2, B_0, mt_2)
    half_2 = 0.5 * mt_2
    n_0 = B_1 + half_0
    n_0_right = n_0 - B_1
    n_0_lo = B_1 - (n_0 - n_0_right) + (half_0 - n_0_right) + 0.5 * mt_0_lo
    n_1 = B_2 + half_1
    n_1_right = n_1 - B_2
    n_1_lo = B_2 - (n_1 - n_1_right) + (half_1 - n_1_right) + 0.5 * mt_1_lo
    n_2 = B_3 + half_2
    n_2_right = n_2 - B_3
    n_2_lo = B_3 - (n_2 - n_2_right) + (half_2 - n_2_right) + 0.5 * mt_2_lo
    tn0 = t_0 * n_0
    tn1 = t_1 * n_1
    tn2 = t_2 * n_2
    own_0 = 2 * tn0
    own_0_cross2 = 2 * (product_error(t_0, n_0, tn0) + t_0 * n_0_lo)
    own_1 = 2 * tn1
    own_1_cross2 = 2 * (product_error(t_1, n_1, tn1) + t_1 * n_1_lo)
    own_2 = 2 * tn2
    own_2_cross2 = 2 * (product_error(t_2, n_2, tn2) + t_2 * n_2_lo)
    pairs_0 = own_1 + own_2
    pairs_0_right = pairs_0 - own_1
    pairs_1 = own_0 + own_2
    pairs_1_right = pairs_1 - own_0
    pairs_2 = own_0 + own_1
    pairs_2_right = pairs_2 - own_0
    pairs_3a = t_0 * n_1
    pairs_3b = t_1 * n_0
    pairs_3 = pairs_3a + pairs_3b
    pairs_3_right = pairs_3 - pairs_3a
    pairs_3_lo1 = (product_rest(t_0, n_1, pairs_3a, pairs_3 - pairs_3_right)
        + product_rest(t_1, n_0, pairs_3b, pairs_3_right))
    pairs_4a = t_0 * n_2
    pairs_4b = t_2 * n_0
    pairs_4 = pairs_4a + pairs_4b
    pairs_4_right = pairs_4 - pairs_4a
    pairs_4_lo1 = (product_rest(t_0, n_2, pairs_4a, pairs_4 - pairs_4_right)
        + product_rest(t_2, n_0, pairs_4b, pairs_4_right))
    pairs_5a = t_1 * n_2
    pairs_5b = t_2 * n_1
    pairs_5 = pairs_5a + pairs_5b
    pairs_5_right = pairs_5 - pairs_5a
    pairs_5_lo1 = (product_rest(t_1, n_2, pairs_5a, pairs_5 - pairs_5_right)
        + product_rest(t_2, n_1, pairs_5b, pairs_5_right))
    moved_0 = B_1 + mt_0
    moved_0_right = moved_0 - B_1
    moved_1 = B_2 + mt_1
    moved_1_right = moved_1 - B_2
    moved_2 = B_3 + mt_2
    moved_2_right = moved_2 - B_3
    Bo_4 = B_4 + pairs_0
    Bo_4_right = Bo_4 - B_4
    pairs_0_lo = (own_1 - (pairs_0 - pairs_0_right) + (own_2 - pairs_0_right) + own_2_cross2
        + own_1_cross2)
    Bo_5 = B_5 + pairs_1
    Bo_5_right = Bo_5 - B_5
    pairs_1_lo = (own_0 - (pairs_1 - pairs_1_right) + (own_2 - pairs_1_right) + own_2_cross2
        + own_0_cross2)
    Bo_6 = B_6 + pairs_2
    Bo_6_right = Bo_6 - B_6
    pairs_2_lo = (own_0 - (pairs_2 - pairs_2_right) + (own_1 - pairs_2_right) + own_1_cross2
        + own_0_cross2)
    Bo_7 = B_7 - pairs_3
    Bo_7_right = B_7 - Bo_7
    Bo_8 = B_8 - pairs_4
    Bo_8_right = B_8 - Bo_8
    Bo_9 = B_9 - pairs_5
    Bo_9_right = B_9 - Bo_9
    moved_0_rounded = moved_0 + (B_1 - (moved_0 - moved_0_right) + (mt_0 - moved_0_right) + mt_0_lo)
    moved_1_rounded = moved_1 + (B_2 - (moved_1 - moved_1_right) + (mt_1 - moved_1_right) + mt_1_lo)
    moved_2_rounded = moved_2 + (B_3 - (moved_2 - moved_2_right) + (mt_2 - moved_2_right) + mt_2_lo)
    Bo_4_rounded = Bo_4 + (B_4 - (Bo_4 - Bo_4_right) + (pairs_0 - Bo_4_right) + pairs_0_lo)
    Bo_5_rounded = Bo_5 + (B_5 - (Bo_5 - Bo_5_right) + (pairs_1 - Bo_5_right) + pairs_1_lo)
    Bo_6_rounded = Bo_6 + (B_6 - (Bo_6 - Bo_6_right) + (pairs_2 - Bo_6_right) + pairs_2_lo)
    Bo_7_rounded = (Bo_7
        + (B_7 - (Bo_7 + Bo_7_right) - (pairs_3 - Bo_7_right)
        - (pairs_3_lo1 + (t_0 * n_1_lo + t_1 * n_0_lo))))
    Bo_8_rounded = (Bo_8
        + (B_8 - (Bo_8 + Bo_8_right) - (pairs_4 - Bo_8_right)
        - (pairs_4_lo1 + (t_0 * n_2_lo + t_2 * n_0_lo))))
    Bo_9_rounded = (Bo_9
        + (B_9 - (Bo_9 + Bo_9_right) - (pairs_5 - Bo_9_right)
        - (pairs_5_lo1 + (t_1 * n_2_lo + t_2 * n_1_lo))))
    return (B_0, moved_0_rounded, moved_1_rounded, moved_2_rounded, Bo_4_rounded, Bo_5_rounded,
        Bo_6_rounded, Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(3,4),(10)->(10)")
def spatial_inertia_transformed(D, B):
    """Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.

    (3,4),(10)->(10).  D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in
    kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    105 mul, 420 add, 6 product error, 60 product rest.  Error <= u |result| + (m: 0, h: 16, I:
    35) u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    RI_0a = D_00 * B_4
    RI_0b = D_01 * B_7
    RI_0c = RI_0a + RI_0b
    RI_0c_right = RI_0c - RI_0a
    RI_0d = D_02 * B_8
    RI_0 = RI_0c + RI_0d
    RI_0_right = RI_0 - RI_0c
    RI_0c_lo = (product_rest(D_00, B_4, RI_0a, RI_0c - RI_0c_right)
        + product_rest(D_01, B_7, RI_0b, RI_0c_right))
    RI_0_lo = RI_0c - (RI_0 - RI_0_right) + product_rest(D_02, B_8, RI_0d, RI_0_right) + RI_0c_lo
    RI_1a = D_00 * B_7
    RI_1b = D_01 * B_5
    RI_1c = RI_1a + RI_1b
    RI_1c_right = RI_1c - RI_1a
    RI_1d = D_02 * B_9
    RI_1 = RI_1c + RI_1d
    RI_1_right = RI_1 - RI_1c
    RI_1c_lo = (product_rest(D_00, B_7, RI_1a, RI_1c - RI_1c_right)
        + product_rest(D_01, B_5, RI_1b, RI_1c_right))
    RI_1_lo = RI_1c - (RI_1 - RI_1_right) + product_rest(D_02, B_9, RI_1d, RI_1_right) + RI_1c_lo
    RI_2a = D_00 * B_8
    RI_2b = D_01 * B_9
    RI_2c = RI_2a + RI_2b
    RI_2c_right = RI_2c - RI_2a
    RI_2d = D_02 * B_6
    RI_2 = RI_2c + RI_2d
    RI_2_right = RI_2 - RI_2c
    RI_2c_lo = (product_rest(D_00, B_8, RI_2a, RI_2c - RI_2c_right)
        + product_rest(D_01, B_9, RI_2b, RI_2c_right))
    RI_2_lo = RI_2c - (RI_2 - RI_2_right) + product_rest(D_02, B_6, RI_2d, RI_2_right) + RI_2c_lo
    RI_3a = D_10 * B_4
    RI_3b = D_11 * B_7
    RI_3c = RI_3a + RI_3b
    RI_3c_right = RI_3c - RI_3a
    RI_3d = D_12 * B_8
    RI_3 = RI_3c + RI_3d
    RI_3_right = RI_3 - RI_3c
    RI_3c_lo = (product_rest(D_10, B_4, RI_3a, RI_3c - RI_3c_right)
        + product_rest(D_11, B_7, RI_3b, RI_3c_right))
    RI_3_lo = RI_3c - (RI_3 - RI_3_right) + product_rest(D_12, B_8, RI_3d, RI_3_right) + RI_3c_lo
    RI_4a = D_10 * B_7
    RI_4b = D_11 * B_5
    RI_4c = RI_4a + RI_4b
    RI_4c_right = RI_4c - RI_4a
    RI_4d = D_12 * B_9
    RI_4 = RI_4c + RI_4d
    RI_4_right = RI_4 - RI_4c
    RI_4c_lo = (product_rest(D_10, B_7, RI_4a, RI_4c - RI_4c_right)
        + product_rest(D_11, B_5, RI_4b, RI_4c_right))
    RI_4_lo = RI_4c - (RI_4 - RI_4_right) + product_rest(D_12, B_9, RI_4d, RI_4_right) + RI_4c_lo
    RI_5a = D_10 * B_8
    RI_5b = D_11 * B_9
    RI_5c = RI_5a + RI_5b
    RI_5c_right = RI_5c - RI_5a
    RI_5d = D_12 * B_6
    RI_5 = RI_5c + RI_5d
    RI_5_right = RI_5 - RI_5c
    RI_5c_lo = (product_rest(D_10, B_8, RI_5a, RI_5c - RI_5c_right)
        + product_rest(D_11, B_9, RI_5b, RI_5c_right))
    RI_5_lo = RI_5c - (RI_5 - RI_5_right) + product_rest(D_12, B_6, RI_5d, RI_5_right) + RI_5c_lo
    RI_6a = D_20 * B_4
    RI_6b = D_21 * B_7
    RI_6c = RI_6a + RI_6b
    RI_6c_right = RI_6c - RI_6a
    RI_6d = D_22 * B_8
    RI_6 = RI_6c + RI_6d
    RI_6_right = RI_6 - RI_6c
    RI_6c_lo = (product_rest(D_20, B_4, RI_6a, RI_6c - RI_6c_right)
        + product_rest(D_21, B_7, RI_6b, RI_6c_right))
    RI_6_lo = RI_6c - (RI_6 - RI_6_right) + product_rest(D_22, B_8, RI_6d, RI_6_right) + RI_6c_lo
    RI_7a = D_20 * B_7
    RI_7b = D_21 * B_5
    RI_7c = RI_7a + RI_7b
    RI_7c_right = RI_7c - RI_7a
    RI_7d = D_22 * B_9
    RI_7 = RI_7c + RI_7d
    RI_7_right = RI_7 - RI_7c
    RI_7c_lo = (product_rest(D_20, B_7, RI_7a, RI_7c - RI_7c_right)
        + product_rest(D_21, B_5, RI_7b, RI_7c_right))
    RI_7_lo = RI_7c - (RI_7 - RI_7_right) + product_rest(D_22, B_9, RI_7d, RI_7_right) + RI_7c_lo
    RI_8a = D_20 * B_8
    RI_8b = D_21 * B_9
    RI_8c = RI_8a + RI_8b
    RI_8c_right = RI_8c - RI_8a
    RI_8d = D_22 * B_6
    RI_8 = RI_8c + RI_8d
    RI_8_right = RI_8 - RI_8c
    RI_8c_lo = (product_rest(D_20, B_8, RI_8a, RI_8c - RI_8c_right)
        + product_rest(D_21, B_9, RI_8b, RI_8c_right))
    RI_8_lo = RI_8c - (RI_8 - RI_8_right) + product_rest(D_22, B_6, RI_8d, RI_8_right) + RI_8c_lo
    turned_1a = D_00 * B_1
    turned_1b = D_01 * B_2
    turned_1c = turned_1a + turned_1b
    turned_1c_right = turned_1c - turned_1a
    turned_1d = D_02 * B_3
    turned_1 = turned_1c + turned_1d
    turned_1_right = turned_1 - turned_1c
    turned_1c_lo = (product_rest(D_00, B_1, turned_1a, turned_1c - turned_1c_right)
        + product_rest(D_01, B_2, turned_1b, turned_1c_right))
    turned_1_lo = (turned_1c - (turned_1 - turned_1_right)
        + product_rest(D_02, B_3, turned_1d, turned_1_right) + turned_1c_lo)
    turned_2a = D_10 * B_1
    turned_2b = D_11 * B_2
    turned_2c = turned_2a + turned_2b
    turned_2c_right = turned_2c - turned_2a
    turned_2d = D_12 * B_3
    turned_2 = turned_2c + turned_2d
    turned_2_right = turned_2 - turned_2c
    turned_2c_lo = (product_rest(D_10, B_1, turned_2a, turned_2c - turned_2c_right)
        + product_rest(D_11, B_2, turned_2b, turned_2c_right))
    turned_2_lo = (turned_2c - (turned_2 - turned_2_right)
        + product_rest(D_12, B_3, turned_2d, turned_2_right) + turned_2c_lo)
    turned_3a = D_20 * B_1
    turned_3b = D_21 * B_2
    turned_3c = turned_3a + turned_3b
    turned_3c_right = turned_3c - turned_3a
    turned_3d = D_22 * B_3
    turned_3 = turned_3c + turned_3d
    turned_3_right = turned_3 - turned_3c
    turned_3c_lo = (product_rest(D_20, B_1, turned_3a, turned_3c - turned_3c_right)
        + product_rest(D_21, B_2, turned_3b, turned_3c_right))
    turned_3_lo = (turned_3c - (turned_3 - turned_3_right)
        + product_rest(D_22, B_3, turned_3d, turned_3_right) + turned_3c_lo)
    RI_0_sum = RI_0 + RI_0_lo
    RI_0_sum_right = RI_0_sum - RI_0
    RI_0_sum_lo = RI_0 - (RI_0_sum - RI_0_sum_right) + (RI_0_lo - RI_0_sum_right)
    turned_4a = D_00 * RI_0_sum
    RI_1_sum = RI_1 + RI_1_lo
    RI_1_sum_right = RI_1_sum - RI_1
    RI_1_sum_lo = RI_1 - (RI_1_sum - RI_1_sum_right) + (RI_1_lo - RI_1_sum_right)
    turned_4b = D_01 * RI_1_sum
    turned_4c = turned_4a + turned_4b
    turned_4c_right = turned_4c - turned_4a
    turned_4c_lo1 = (product_rest(D_00, RI_0_sum, turned_4a, turned_4c - turned_4c_right)
        + product_rest(D_01, RI_1_sum, turned_4b, turned_4c_right))
    RI_2_sum = RI_2 + RI_2_lo
    RI_2_sum_right = RI_2_sum - RI_2
    RI_2_sum_lo = RI_2 - (RI_2_sum - RI_2_sum_right) + (RI_2_lo - RI_2_sum_right)
    turned_4d = D_02 * RI_2_sum
    turned_4 = turned_4c + turned_4d
    turned_4_right = turned_4 - turned_4c
    turned_4_lo2 = (turned_4c - (turned_4 - turned_4_right)
        + product_rest(D_02, RI_2_sum, turned_4d, turned_4_right) + D_02 * RI_2_sum_lo)
    RI_3_sum = RI_3 + RI_3_lo
    RI_3_sum_right = RI_3_sum - RI_3
    RI_3_sum_lo = RI_3 - (RI_3_sum - RI_3_sum_right) + (RI_3_lo - RI_3_sum_right)
    turned_5a = D_10 * RI_3_sum
    RI_4_sum = RI_4 + RI_4_lo
    RI_4_sum_right = RI_4_sum - RI_4
    RI_4_sum_lo = RI_4 - (RI_4_sum - RI_4_sum_right) + (RI_4_lo - RI_4_sum_right)
    turned_5b = D_11 * RI_4_sum
    turned_5c = turned_5a + turned_5b
    turned_5c_right = turned_5c - turned_5a
    turned_5c_lo1 = (product_rest(D_10, RI_3_sum, turned_5a, turned_5c - turned_5c_right)
        + product_rest(D_11, RI_4_sum, turned_5b, turned_5c_right))
    RI_5_sum = RI_5 + RI_5_lo
    RI_5_sum_right = RI_5_sum - RI_5
    RI_5_sum_lo = RI_5 - (RI_5_sum - RI_5_sum_right) + (RI_5_lo - RI_5_sum_right)
    turned_5d = D_12 * RI_5_sum
    turned_5 = turned_5c + turned_5d
    turned_5_right = turned_5 - turned_5c
    turned_5_lo2 = (turned_5c - (turned_5 - turned_5_right)
        + product_rest(D_12, RI_5_sum, turned_5d, turned_5_right) + D_12 * RI_5_sum_lo)
    RI_6_sum = RI_6 + RI_6_lo
    RI_6_sum_right = RI_6_sum - RI_6
    turned_6a = D_20 * RI_6_sum
    RI_7_sum = RI_7 + RI_7_lo
    RI_7_sum_right = RI_7_sum - RI_7
    turned_6b = D_21 * RI_7_sum
    turned_6c = turned_6a + turned_6b
    turned_6c_right = turned_6c - turned_6a
    turned_6a_cross2 = D_20 * (RI_6 - (RI_6_sum - RI_6_sum_right) + (RI_6_lo - RI_6_sum_right))
    turned_6c_lo1 = (product_rest(D_20, RI_6_sum, turned_6a, turned_6c - turned_6c_right)
        + product_rest(D_21, RI_7_sum, turned_6b, turned_6c_right))
    RI_8_sum = RI_8 + RI_8_lo
    RI_8_sum_right = RI_8_sum - RI_8
    turned_6d = D_22 * RI_8_sum
    turned_6 = turned_6c + turned_6d
    turned_6_right = turned_6 - turned_6c
    turned_6_lo1 = (turned_6c - (turned_6 - turned_6_right)
        + product_rest(D_22, RI_8_sum, turned_6d, turned_6_right))
    turned_6c_lo = (turned_6c_lo1
        + (turned_6a_cross2 + D_21
        * (RI_7 - (RI_7_sum - RI_7_sum_right) + (RI_7_lo - RI_7_sum_right))))
    turned_7a = D_10 * RI_0_sum
    turned_7b = D_11 * RI_1_sum
    turned_7c = turned_7a + turned_7b
    turned_7c_right = turned_7c - turned_7a
    turned_7c_lo1 = (product_rest(D_10, RI_0_sum, turned_7a, turned_7c - turned_7c_right)
        + product_rest(D_11, RI_1_sum, turned_7b, turned_7c_right))
    turned_7d = D_12 * RI_2_sum
    turned_7 = turned_7c + turned_7d
    turned_7_right = turned_7 - turned_7c
    turned_7_lo2 = (turned_7c - (turned_7 - turned_7_right)
        + product_rest(D_12, RI_2_sum, turned_7d, turned_7_right) + D_12 * RI_2_sum_lo)
    turned_8a = D_20 * RI_0_sum
    turned_8b = D_21 * RI_1_sum
    turned_8c = turned_8a + turned_8b
    turned_8c_right = turned_8c - turned_8a
    turned_8c_lo1 = (product_rest(D_20, RI_0_sum, turned_8a, turned_8c - turned_8c_right)
        + product_rest(D_21, RI_1_sum, turned_8b, turned_8c_right))
    turned_8d = D_22 * RI_2_sum
    turned_8 = turned_8c + turned_8d
    turned_8_right = turned_8 - turned_8c
    turned_8_lo2 = (turned_8c - (turned_8 - turned_8_right)
        + product_rest(D_22, RI_2_sum, turned_8d, turned_8_right) + D_22 * RI_2_sum_lo)
    turned_9a = D_20 * RI_3_sum
    turned_9b = D_21 * RI_4_sum
    turned_9c = turned_9a + turned_9b
    turned_9c_right = turned_9c - turned_9a
    turned_9c_lo1 = (product_rest(D_20, RI_3_sum, turned_9a, turned_9c - turned_9c_right)
        + product_rest(D_21, RI_4_sum, turned_9b, turned_9c_right))
    turned_9d = D_22 * RI_5_sum
    turned_9 = turned_9c + turned_9d
    turned_9_right = turned_9 - turned_9c
    turned_9_lo2 = (turned_9c - (turned_9 - turned_9_right)
        + product_rest(D_22, RI_5_sum, turned_9d, turned_9_right) + D_22 * RI_5_sum_lo)
    mt_0 = D_03 * B_0
    mt_1 = D_13 * B_0
    mt_2 = D_23 * B_0
    mt_0_lo = product_error(D_03, B_0, mt_0)
    half_0 = 0.5 * mt_0
    mt_1_lo = product_error(D_13, B_0, mt_1)
    half_1 = 0.5 * mt_1
    mt_2_lo = product_error(D_23, B_0, mt_2)
    half_2 = 0.5 * mt_2
    n_0 = turned_1 + half_0
    n_0_right = n_0 - turned_1
    n_0_lo = turned_1 - (n_0 - n_0_right) + (half_0 - n_0_right) + 0.5 * mt_0_lo + turned_1_lo
    n_1 = turned_2 + half_1
    n_1_right = n_1 - turned_2
    n_1_lo = turned_2 - (n_1 - n_1_right) + (half_1 - n_1_right) + 0.5 * mt_1_lo + turned_2_lo
    n_2 = turned_3 + half_2
    n_2_right = n_2 - turned_3
    n_2_lo = turned_3 - (n_2 - n_2_right) + (half_2 - n_2_right) + 0.5 * mt_2_lo + turned_3_lo
    n_0_sum = n_0 + n_0_lo
    n_0_sum_right = n_0_sum - n_0
    n_0_sum_lo = n_0 - (n_0_sum - n_0_sum_right) + (n_0_lo - n_0_sum_right)
    tn0 = D_03 * n_0_sum
    n_1_sum = n_1 + n_1_lo
    n_1_sum_right = n_1_sum - n_1
    n_1_sum_lo = n_1 - (n_1_sum - n_1_sum_right) + (n_1_lo - n_1_sum_right)
    tn1 = D_13 * n_1_sum
    n_2_sum = n_2 + n_2_lo
    n_2_sum_right = n_2_sum - n_2
    n_2_sum_lo = n_2 - (n_2_sum - n_2_sum_right) + (n_2_lo - n_2_sum_right)
    tn2 = D_23 * n_2_sum
    own_0 = 2 * tn0
    own_0_cross2 = 2 * (product_error(D_03, n_0_sum, tn0) + D_03 * n_0_sum_lo)
    own_1 = 2 * tn1
    own_1_cross2 = 2 * (product_error(D_13, n_1_sum, tn1) + D_13 * n_1_sum_lo)
    own_2 = 2 * tn2
    own_2_cross2 = 2 * (product_error(D_23, n_2_sum, tn2) + D_23 * n_2_sum_lo)
    pairs_0 = own_1 + own_2
    pairs_0_right = pairs_0 - own_1
    pairs_1 = own_0 + own_2
    pairs_1_right = pairs_1 - own_0
    pairs_2 = own_0 + own_1
    pairs_2_right = pairs_2 - own_0
    pairs_3a = D_03 * n_1_sum
    pairs_3b = D_13 * n_0_sum
    pairs_3 = pairs_3a + pairs_3b
    pairs_3_right = pairs_3 - pairs_3a
    pairs_3_lo1 = (product_rest(D_03, n_1_sum, pairs_3a, pairs_3 - pairs_3_right)
        + product_rest(D_13, n_0_sum, pairs_3b, pairs_3_right))
    pairs_4a = D_03 * n_2_sum
    pairs_4b = D_23 * n_0_sum
    pairs_4 = pairs_4a + pairs_4b
    pairs_4_right = pairs_4 - pairs_4a
    pairs_4_lo1 = (product_rest(D_03, n_2_sum, pairs_4a, pairs_4 - pairs_4_right)
        + product_rest(D_23, n_0_sum, pairs_4b, pairs_4_right))
    pairs_5a = D_13 * n_2_sum
    pairs_5b = D_23 * n_1_sum
    pairs_5 = pairs_5a + pairs_5b
    pairs_5_right = pairs_5 - pairs_5a
    pairs_5_lo1 = (product_rest(D_13, n_2_sum, pairs_5a, pairs_5 - pairs_5_right)
        + product_rest(D_23, n_1_sum, pairs_5b, pairs_5_right))
    moved_0 = turned_1 + mt_0
    moved_0_right = moved_0 - turned_1
    moved_1 = turned_2 + mt_1
    moved_1_right = moved_1 - turned_2
    moved_2 = turned_3 + mt_2
    moved_2_right = moved_2 - turned_3
    Bo_4 = turned_4 + pairs_0
    Bo_4_right = Bo_4 - turned_4
    pairs_0_lo = (own_1 - (pairs_0 - pairs_0_right) + (own_2 - pairs_0_right) + own_2_cross2
        + own_1_cross2)
    turned_4_lo = turned_4_lo2 + (turned_4c_lo1 + (D_00 * RI_0_sum_lo + D_01 * RI_1_sum_lo))
    Bo_5 = turned_5 + pairs_1
    Bo_5_right = Bo_5 - turned_5
    pairs_1_lo = (own_0 - (pairs_1 - pairs_1_right) + (own_2 - pairs_1_right) + own_2_cross2
        + own_0_cross2)
    turned_5_lo = turned_5_lo2 + (turned_5c_lo1 + (D_10 * RI_3_sum_lo + D_11 * RI_4_sum_lo))
    Bo_6 = turned_6 + pairs_2
    Bo_6_right = Bo_6 - turned_6
    pairs_2_lo = (own_0 - (pairs_2 - pairs_2_right) + (own_1 - pairs_2_right) + own_1_cross2
        + own_0_cross2)
    turned_6_lo = (turned_6_lo1 + D_22
        * (RI_8 - (RI_8_sum - RI_8_sum_right) + (RI_8_lo - RI_8_sum_right)) + turned_6c_lo)
    Bo_7 = turned_7 - pairs_3
    Bo_7_right = turned_7 - Bo_7
    Bo_7_lo2 = (turned_7 - (Bo_7 + Bo_7_right) - (pairs_3 - Bo_7_right)
        - (pairs_3_lo1 + (D_03 * n_1_sum_lo + D_13 * n_0_sum_lo)))
    Bo_8 = turned_8 - pairs_4
    Bo_8_right = turned_8 - Bo_8
    Bo_8_lo2 = (turned_8 - (Bo_8 + Bo_8_right) - (pairs_4 - Bo_8_right)
        - (pairs_4_lo1 + (D_03 * n_2_sum_lo + D_23 * n_0_sum_lo)))
    Bo_9 = turned_9 - pairs_5
    Bo_9_right = turned_9 - Bo_9
    Bo_9_lo2 = (turned_9 - (Bo_9 + Bo_9_right) - (pairs_5 - Bo_9_right)
        - (pairs_5_lo1 + (D_13 * n_2_sum_lo + D_23 * n_1_sum_lo)))
    moved_0_rounded = (moved_0
        + (turned_1 - (moved_0 - moved_0_right) + (mt_0 - moved_0_right) + mt_0_lo + turned_1_lo))
    moved_1_rounded = (moved_1
        + (turned_2 - (moved_1 - moved_1_right) + (mt_1 - moved_1_right) + mt_1_lo + turned_2_lo))
    moved_2_rounded = (moved_2
        + (turned_3 - (moved_2 - moved_2_right) + (mt_2 - moved_2_right) + mt_2_lo + turned_3_lo))
    Bo_4_rounded = (Bo_4
        + (turned_4 - (Bo_4 - Bo_4_right) + (pairs_0 - Bo_4_right) + pairs_0_lo + turned_4_lo))
    Bo_5_rounded = (Bo_5
        + (turned_5 - (Bo_5 - Bo_5_right) + (pairs_1 - Bo_5_right) + pairs_1_lo + turned_5_lo))
    Bo_6_rounded = (Bo_6
        + (turned_6 - (Bo_6 - Bo_6_right) + (pairs_2 - Bo_6_right) + pairs_2_lo + turned_6_lo))
    Bo_7_rounded = (Bo_7
        + (Bo_7_lo2 + (turned_7_lo2 + (turned_7c_lo1 + (D_10 * RI_0_sum_lo + D_11 * RI_1_sum_lo)))))
    Bo_8_rounded = (Bo_8
        + (Bo_8_lo2 + (turned_8_lo2 + (turned_8c_lo1 + (D_20 * RI_0_sum_lo + D_21 * RI_1_sum_lo)))))
    Bo_9_rounded = (Bo_9
        + (Bo_9_lo2 + (turned_9_lo2 + (turned_9c_lo1 + (D_20 * RI_3_sum_lo + D_21 * RI_4_sum_lo)))))
    return (B_0, moved_0_rounded, moved_1_rounded, moved_2_rounded, Bo_4_rounded, Bo_5_rounded,
        Bo_6_rounded, Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(10)->()")
def spatial_inertia_consistency(B):
    """the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:
    positive exactly if a body of positive density has this inertia.

    (10)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,
    xz, yz in kg m^2); pivot: number.
    42 mul, 258 add, 10 product error, 10 product rest, 20 div, 6 neg, 9 less, 1 equal, 26
    select.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    twice_trace_a = B_4 + B_5
    twice_trace_a_right = twice_trace_a - B_4
    twice_trace = twice_trace_a + B_6
    twice_trace_right = twice_trace - twice_trace_a
    twice_trace_lo1 = twice_trace_a - (twice_trace - twice_trace_right) + (B_6 - twice_trace_right)
    trace = 0.5 * twice_trace
    trace_cross2 = (0.5
        * (twice_trace_lo1
        + (B_4 - (twice_trace_a - twice_trace_a_right) + (B_5 - twice_trace_a_right))))
    sigma_0 = trace - B_4
    sigma_0_right = trace - sigma_0
    sigma_0_lo = trace - (sigma_0 + sigma_0_right) - (B_4 - sigma_0_right) + trace_cross2
    sigma_1 = trace - B_5
    sigma_1_right = trace - sigma_1
    sigma_1_lo = trace - (sigma_1 + sigma_1_right) - (B_5 - sigma_1_right) + trace_cross2
    sigma_2 = trace - B_6
    sigma_2_right = trace - sigma_2
    sigma_2_lo = trace - (sigma_2 + sigma_2_right) - (B_6 - sigma_2_right) + trace_cross2
    divisor0a = 0 < B_0
    divisor0 = where(divisor0a, B_0, 1)
    l0_0 = B_1 / divisor0
    l0_0_product = l0_0 * divisor0
    l0_0_lo = (B_1 - l0_0_product - product_error(l0_0, divisor0, l0_0_product)) / divisor0
    l0_1 = B_2 / divisor0
    l0_1_product = l0_1 * divisor0
    l0_1_lo = (B_2 - l0_1_product - product_error(l0_1, divisor0, l0_1_product)) / divisor0
    l0_2 = B_3 / divisor0
    l0_2_product = l0_2 * divisor0
    u1_0a = B_1 * l0_0
    u1_0 = sigma_0 - u1_0a
    u1_0_right = sigma_0 - u1_0
    u1_0_lo = (sigma_0 - (u1_0 + u1_0_right) - product_rest(B_1, l0_0, u1_0a, u1_0_right) - B_1
        * l0_0_lo + sigma_0_lo)
    u1_1a = B_2 * l0_0
    u1_1b = u1_1a + B_7
    u1_1b_right = u1_1b - u1_1a
    u1_1 = -u1_1b
    u1_1_lo = -(product_rest(B_2, l0_0, u1_1a,
        u1_1b - u1_1b_right) + (B_7 - u1_1b_right) + B_2 * l0_0_lo)
    u1_2a = B_3 * l0_0
    u1_2b = u1_2a + B_8
    u1_2b_right = u1_2b - u1_2a
    u1_2 = -u1_2b
    u1_2_lo = -(product_rest(B_3, l0_0, u1_2a,
        u1_2b - u1_2b_right) + (B_8 - u1_2b_right) + B_3 * l0_0_lo)
    u1_0_sum = u1_0 + u1_0_lo
    u1_0_sum_right = u1_0_sum - u1_0
    u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right)
    divisor1a = 0 < u1_0_sum
    divisor1 = where(divisor1a, u1_0_sum, 1)
    divisor1_lo = where(divisor1a, u1_0_sum_lo, 0)
    u1_1_sum = u1_1 + u1_1_lo
    u1_1_sum_right = u1_1_sum - u1_1
    u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right)
    divisor1_sum = divisor1 + divisor1_lo
    divisor1_sum_right = divisor1_sum - divisor1
    divisor1_sum_lo = (divisor1 - (divisor1_sum - divisor1_sum_right)
        + (divisor1_lo - divisor1_sum_right))
    l1_0 = u1_1_sum / divisor1_sum
    l1_0_product = l1_0 * divisor1_sum
    l1_0_lo = ((u1_1_sum - l1_0_product - product_error(l1_0, divisor1_sum, l1_0_product)
        + u1_1_sum_lo - l1_0 * divisor1_sum_lo) / divisor1_sum)
    u1_2_sum = u1_2 + u1_2_lo
    u1_2_sum_right = u1_2_sum - u1_2
    u1_2_sum_lo = u1_2 - (u1_2_sum - u1_2_sum_right) + (u1_2_lo - u1_2_sum_right)
    l1_1 = u1_2_sum / divisor1_sum
    l1_1_product = l1_1 * divisor1_sum
    u2_0a = B_2 * l0_1
    u2_0b = sigma_1 - u2_0a
    u2_0b_right = sigma_1 - u2_0b
    u2_0c = u1_1_sum * l1_0
    u2_0 = u2_0b - u2_0c
    u2_0_right = u2_0b - u2_0
    u2_0_lo2 = (u2_0b - (u2_0 + u2_0_right) - product_rest(u1_1_sum, l1_0, u2_0c, u2_0_right)
        - (u1_1_sum_lo * l1_0 + u1_1_sum * l1_0_lo))
    u2_0_lo = (u2_0_lo2
        + (sigma_1 - (u2_0b + u2_0b_right) - product_rest(B_2, l0_1, u2_0a, u2_0b_right) - B_2
        * l0_1_lo + sigma_1_lo))
    u2_1a = B_3 * l0_1
    u2_1b = u2_1a + B_9
    u2_1b_right = u2_1b - u2_1a
    u2_1c = u1_2_sum * l1_0
    u2_1d = u2_1b + u2_1c
    u2_1d_right = u2_1d - u2_1b
    u2_1d_lo2 = (u2_1b - (u2_1d - u2_1d_right) + product_rest(u1_2_sum, l1_0, u2_1c, u2_1d_right)
        + (u1_2_sum_lo * l1_0 + u1_2_sum * l1_0_lo))
    u2_1 = -u2_1d
    u2_1_lo = -(u2_1d_lo2 + (product_rest(B_3, l0_1, u2_1a,
        u2_1b - u2_1b_right) + (B_9 - u2_1b_right) + B_3 * l0_1_lo))
    u2_0_sum = u2_0 + u2_0_lo
    u2_0_sum_right = u2_0_sum - u2_0
    u2_0_sum_lo = u2_0 - (u2_0_sum - u2_0_sum_right) + (u2_0_lo - u2_0_sum_right)
    divisor2a = 0 < u2_0_sum
    divisor2 = where(divisor2a, u2_0_sum, 1)
    divisor2_lo = where(divisor2a, u2_0_sum_lo, 0)
    u2_1_sum = u2_1 + u2_1_lo
    u2_1_sum_right = u2_1_sum - u2_1
    u2_1_sum_lo = u2_1 - (u2_1_sum - u2_1_sum_right) + (u2_1_lo - u2_1_sum_right)
    divisor2_sum = divisor2 + divisor2_lo
    divisor2_sum_right = divisor2_sum - divisor2
    l2 = u2_1_sum / divisor2_sum
    l2_product = l2 * divisor2_sum
    l2_cross = (l2
        * (divisor2 - (divisor2_sum - divisor2_sum_right) + (divisor2_lo - divisor2_sum_right)))
    u3a = B_3 * l0_2
    u3b = sigma_2 - u3a
    u3b_right = sigma_2 - u3b
    u3a_cross2 = (B_3
        * ((B_3 - l0_2_product - product_error(l0_2, divisor0, l0_2_product)) / divisor0))
    u3c = u1_2_sum * l1_1
    l1_1_lo = ((u1_2_sum - l1_1_product - product_error(l1_1, divisor1_sum, l1_1_product)
        + u1_2_sum_lo - l1_1 * divisor1_sum_lo) / divisor1_sum)
    u3d = u3b - u3c
    u3d_right = u3b - u3d
    u3d_lo2 = (u3b - (u3d + u3d_right) - product_rest(u1_2_sum, l1_1, u3c, u3d_right)
        - (u1_2_sum_lo * l1_1 + u1_2_sum * l1_1_lo))
    u3e = u2_1_sum * l2
    u3e_cross2 = (u2_1_sum
        * ((u2_1_sum - l2_product - product_error(l2, divisor2_sum, l2_product) + u2_1_sum_lo
        - l2_cross) / divisor2_sum))
    u3 = u3d - u3e
    u3_right = u3d - u3
    u3d_lo = (u3d_lo2
        + (sigma_2 - (u3b + u3b_right) - product_rest(B_3, l0_2, u3a, u3b_right) - u3a_cross2
        + sigma_2_lo))
    u3_lo = (u3d - (u3 + u3_right) - product_rest(u2_1_sum, l2, u3e, u3_right)
        - (u2_1_sum_lo * l2 + u3e_cross2) + u3d_lo)
    part0a = B_0 / divisor0
    part0a_product = part0a * divisor0
    part0 = where(divisor0a, part0a, B_0)
    part0_lo = where(divisor0a, (B_0 - part0a_product - product_error(part0a, divisor0,
        part0a_product)) / divisor0, 0)
    sigma_0_sum = sigma_0 + sigma_0_lo
    sigma_0_sum_right = sigma_0_sum - sigma_0
    sigma_0_sum_lo = sigma_0 - (sigma_0_sum - sigma_0_sum_right) + (sigma_0_lo - sigma_0_sum_right)
    own1a = 0 < sigma_0_sum
    own1 = where(own1a, sigma_0_sum, 1)
    own1_lo = where(own1a, sigma_0_sum_lo, 0)
    own1_sum = own1 + own1_lo
    own1_sum_right = own1_sum - own1
    part1a = u1_0_sum / own1_sum
    part1a_product = part1a * own1_sum
    part1a_numerator = (u1_0_sum - part1a_product - product_error(part1a, own1_sum, part1a_product)
        + u1_0_sum_lo)
    part1 = where(own1a, part1a, sigma_0_sum)
    part1_lo = where(own1a,
        (part1a_numerator - part1a * (own1 - (own1_sum - own1_sum_right) + (own1_lo -
            own1_sum_right))) / own1_sum,
        sigma_0_sum_lo)
    part0_sum = part0 + part0_lo
    part0_sum_right = part0_sum - part0
    part1_sum = part1 + part1_lo
    part1_sum_right = part1_sum - part1
    smallest1a = part0_sum < part1_sum
    smallest1 = where(smallest1a, part0_sum, part1_sum)
    part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right)
    smallest1_lo = where(smallest1a, part0_sum_lo,
        part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right))
    sigma_1_sum = sigma_1 + sigma_1_lo
    sigma_1_sum_right = sigma_1_sum - sigma_1
    sigma_1_sum_lo = sigma_1 - (sigma_1_sum - sigma_1_sum_right) + (sigma_1_lo - sigma_1_sum_right)
    own2a = 0 < sigma_1_sum
    own2 = where(own2a, sigma_1_sum, 1)
    own2_lo = where(own2a, sigma_1_sum_lo, 0)
    own2_sum = own2 + own2_lo
    own2_sum_right = own2_sum - own2
    part2a = u2_0_sum / own2_sum
    part2a_product = part2a * own2_sum
    part2a_numerator = (u2_0_sum - part2a_product - product_error(part2a, own2_sum, part2a_product)
        + u2_0_sum_lo)
    part2 = where(own2a, part2a, sigma_1_sum)
    part2_lo = where(own2a,
        (part2a_numerator - part2a * (own2 - (own2_sum - own2_sum_right) + (own2_lo -
            own2_sum_right))) / own2_sum,
        sigma_1_sum_lo)
    smallest1_sum = smallest1 + smallest1_lo
    smallest1_sum_right = smallest1_sum - smallest1
    part2_sum = part2 + part2_lo
    part2_sum_right = part2_sum - part2
    smallest2a = smallest1_sum < part2_sum
    smallest2 = where(smallest2a, smallest1_sum, part2_sum)
    smallest1_sum_lo = (smallest1 - (smallest1_sum - smallest1_sum_right)
        + (smallest1_lo - smallest1_sum_right))
    smallest2_lo = where(smallest2a, smallest1_sum_lo,
        part2 - (part2_sum - part2_sum_right) + (part2_lo - part2_sum_right))
    sigma_2_sum = sigma_2 + sigma_2_lo
    sigma_2_sum_right = sigma_2_sum - sigma_2
    sigma_2_sum_lo = sigma_2 - (sigma_2_sum - sigma_2_sum_right) + (sigma_2_lo - sigma_2_sum_right)
    own3a = 0 < sigma_2_sum
    own3 = where(own3a, sigma_2_sum, 1)
    own3_lo = where(own3a, sigma_2_sum_lo, 0)
    u3_sum = u3 + u3_lo
    u3_sum_right = u3_sum - u3
    own3_sum = own3 + own3_lo
    own3_sum_right = own3_sum - own3
    part3a = u3_sum / own3_sum
    part3a_product = part3a * own3_sum
    part3a_numerator = (u3_sum - part3a_product - product_error(part3a, own3_sum, part3a_product)
        + (u3 - (u3_sum - u3_sum_right) + (u3_lo - u3_sum_right)))
    part3 = where(own3a, part3a, sigma_2_sum)
    part3_lo = where(own3a,
        (part3a_numerator - part3a * (own3 - (own3_sum - own3_sum_right) + (own3_lo -
            own3_sum_right))) / own3_sum,
        sigma_2_sum_lo)
    smallest2_sum = smallest2 + smallest2_lo
    smallest2_sum_right = smallest2_sum - smallest2
    part3_sum = part3 + part3_lo
    part3_sum_right = part3_sum - part3
    smallest3a = smallest2_sum < part3_sum
    smallest3 = where(smallest3a, smallest2_sum, part3_sum)
    smallest2_sum_lo = (smallest2 - (smallest2_sum - smallest2_sum_right)
        + (smallest2_lo - smallest2_sum_right))
    smallest3_rounded = (smallest3
        + where(smallest3a, smallest2_sum_lo, part3 - (part3_sum - part3_sum_right)
        + (part3_lo - part3_sum_right)))
    smallest3_final = where(smallest3_rounded == smallest3_rounded, smallest3_rounded, smallest3)
    return smallest3_final
