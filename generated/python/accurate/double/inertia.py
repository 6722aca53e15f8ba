# Made by `coscrew generate`; changes are overwritten.
"""Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.

In double precision, accurate tier.
"""

from numpy import where
from coscrew._exact import difference_error, product_error, sum_error
from coscrew._kernel import double_kernel as kernel


@kernel("(10),()->(10)")
def inertia_scale(self, a):
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
    20 add, 10 sum error.  Error <= u |result|, barring over- and underflow.
    """
    B1_0, B1_1, B1_2, B1_3, B1_4, B1_5, B1_6, B1_7, B1_8, B1_9 = B1
    B2_0, B2_1, B2_2, B2_3, B2_4, B2_5, B2_6, B2_7, B2_8, B2_9 = B2
    Bo_0 = B1_0 + B2_0
    Bo_1 = B1_1 + B2_1
    Bo_2 = B1_2 + B2_2
    Bo_3 = B1_3 + B2_3
    Bo_4 = B1_4 + B2_4
    Bo_5 = B1_5 + B2_5
    Bo_6 = B1_6 + B2_6
    Bo_7 = B1_7 + B2_7
    Bo_8 = B1_8 + B2_8
    Bo_9 = B1_9 + B2_9
    Bo_0_rounded = Bo_0 + sum_error(B1_0, B2_0, Bo_0)
    Bo_1_rounded = Bo_1 + sum_error(B1_1, B2_1, Bo_1)
    Bo_2_rounded = Bo_2 + sum_error(B1_2, B2_2, Bo_2)
    Bo_3_rounded = Bo_3 + sum_error(B1_3, B2_3, Bo_3)
    Bo_4_rounded = Bo_4 + sum_error(B1_4, B2_4, Bo_4)
    Bo_5_rounded = Bo_5 + sum_error(B1_5, B2_5, Bo_5)
    Bo_6_rounded = Bo_6 + sum_error(B1_6, B2_6, Bo_6)
    Bo_7_rounded = Bo_7 + sum_error(B1_7, B2_7, Bo_7)
    Bo_8_rounded = Bo_8 + sum_error(B1_8, B2_8, Bo_8)
    Bo_9_rounded = Bo_9 + sum_error(B1_9, B2_9, Bo_9)
    return (Bo_0_rounded, Bo_1_rounded, Bo_2_rounded, Bo_3_rounded, Bo_4_rounded, Bo_5_rounded,
        Bo_6_rounded, Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(10),(10)->(10)")
def subtract_BB(B1, B2):
    """Bo = B1 - B2.

    (10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2).
    20 add, 10 sum error.  Error <= u |result|, barring over- and underflow.
    """
    B1_0, B1_1, B1_2, B1_3, B1_4, B1_5, B1_6, B1_7, B1_8, B1_9 = B1
    B2_0, B2_1, B2_2, B2_3, B2_4, B2_5, B2_6, B2_7, B2_8, B2_9 = B2
    Bo_0 = B1_0 - B2_0
    Bo_1 = B1_1 - B2_1
    Bo_2 = B1_2 - B2_2
    Bo_3 = B1_3 - B2_3
    Bo_4 = B1_4 - B2_4
    Bo_5 = B1_5 - B2_5
    Bo_6 = B1_6 - B2_6
    Bo_7 = B1_7 - B2_7
    Bo_8 = B1_8 - B2_8
    Bo_9 = B1_9 - B2_9
    Bo_0_rounded = Bo_0 + difference_error(B1_0, B2_0, Bo_0)
    Bo_1_rounded = Bo_1 + difference_error(B1_1, B2_1, Bo_1)
    Bo_2_rounded = Bo_2 + difference_error(B1_2, B2_2, Bo_2)
    Bo_3_rounded = Bo_3 + difference_error(B1_3, B2_3, Bo_3)
    Bo_4_rounded = Bo_4 + difference_error(B1_4, B2_4, Bo_4)
    Bo_5_rounded = Bo_5 + difference_error(B1_5, B2_5, Bo_5)
    Bo_6_rounded = Bo_6 + difference_error(B1_6, B2_6, Bo_6)
    Bo_7_rounded = Bo_7 + difference_error(B1_7, B2_7, Bo_7)
    Bo_8_rounded = Bo_8 + difference_error(B1_8, B2_8, Bo_8)
    Bo_9_rounded = Bo_9 + difference_error(B1_9, B2_9, Bo_9)
    return (Bo_0_rounded, Bo_1_rounded, Bo_2_rounded, Bo_3_rounded, Bo_4_rounded, Bo_5_rounded,
        Bo_6_rounded, Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(),(3),(3,3)->(10)")
def inertia_from_com(m, com, Ic):
    """Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; of the symmetric matrix
    the upper triangle): h = m com, I = Ic - m com~ com~.

    (),(3),(3,3)->(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial
    inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    15 mul, 36 add, 9 product error, 9 sum error.  Error <= u |result| + (m: 0, h: 0, I: 13) u^2
    S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    com_0, com_1, com_2 = com
    Ic_00, Ic_01, Ic_02, Ic_10, Ic_11, Ic_12, Ic_20, Ic_21, Ic_22 = Ic
    h_0 = m * com_0
    h_0_lo = product_error(m, com_0, h_0)
    h_1 = m * com_1
    h_1_lo = product_error(m, com_1, h_1)
    h_2 = m * com_2
    h_2_lo = product_error(m, com_2, h_2)
    squares_0 = com_0 * h_0
    squares_0_lo = product_error(com_0, h_0, squares_0) + com_0 * h_0_lo
    squares_1 = com_1 * h_1
    squares_1_lo = product_error(com_1, h_1, squares_1) + com_1 * h_1_lo
    squares_2 = com_2 * h_2
    squares_2_lo = product_error(com_2, h_2, squares_2) + com_2 * h_2_lo
    Bo_4a = squares_1 + squares_2
    Bo_4a_lo = sum_error(squares_1, squares_2, Bo_4a) + squares_1_lo + squares_2_lo
    Bo_4 = Ic_00 + Bo_4a
    Bo_4_lo = sum_error(Ic_00, Bo_4a, Bo_4) + Bo_4a_lo
    Bo_5a = squares_0 + squares_2
    Bo_5a_lo = sum_error(squares_0, squares_2, Bo_5a) + squares_0_lo + squares_2_lo
    Bo_5 = Ic_11 + Bo_5a
    Bo_5_lo = sum_error(Ic_11, Bo_5a, Bo_5) + Bo_5a_lo
    Bo_6a = squares_0 + squares_1
    Bo_6a_lo = sum_error(squares_0, squares_1, Bo_6a) + squares_0_lo + squares_1_lo
    Bo_6 = Ic_22 + Bo_6a
    Bo_6_lo = sum_error(Ic_22, Bo_6a, Bo_6) + Bo_6a_lo
    Bo_7a = com_1 * h_0
    Bo_7a_lo = product_error(com_1, h_0, Bo_7a) + com_1 * h_0_lo
    Bo_7 = Ic_01 - Bo_7a
    Bo_7_lo = difference_error(Ic_01, Bo_7a, Bo_7) - Bo_7a_lo
    Bo_8a = com_2 * h_0
    Bo_8a_lo = product_error(com_2, h_0, Bo_8a) + com_2 * h_0_lo
    Bo_8 = Ic_02 - Bo_8a
    Bo_8_lo = difference_error(Ic_02, Bo_8a, Bo_8) - Bo_8a_lo
    Bo_9a = com_2 * h_1
    Bo_9a_lo = product_error(com_2, h_1, Bo_9a) + com_2 * h_1_lo
    Bo_9 = Ic_12 - Bo_9a
    Bo_9_lo = difference_error(Ic_12, Bo_9a, Bo_9) - Bo_9a_lo
    h_0_rounded = h_0 + h_0_lo
    h_1_rounded = h_1 + h_1_lo
    h_2_rounded = h_2 + h_2_lo
    Bo_4_rounded = Bo_4 + Bo_4_lo
    Bo_5_rounded = Bo_5 + Bo_5_lo
    Bo_6_rounded = Bo_6 + Bo_6_lo
    Bo_7_rounded = Bo_7 + Bo_7_lo
    Bo_8_rounded = Bo_8 + Bo_8_lo
    Bo_9_rounded = Bo_9 + Bo_9_lo
    return (m, h_0_rounded, h_1_rounded, h_2_rounded, Bo_4_rounded, Bo_5_rounded, Bo_6_rounded,
        Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(10)->(3)")
def inertia_com(B):
    """vo = h / m, the centre of mass in m.

    (10)->(3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); vo: vector.
    3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    vo_0 = B_1 / B_0
    vo_0_product = vo_0 * B_0
    vo_1 = B_2 / B_0
    vo_1_product = vo_1 * B_0
    vo_2 = B_3 / B_0
    vo_2_product = vo_2 * B_0
    vo_0_total = vo_0 + (B_1 - vo_0_product - product_error(vo_0, B_0, vo_0_product)) / B_0
    vo_0_rounded = where(vo_0_total == vo_0_total, vo_0_total, vo_0)
    vo_1_total = vo_1 + (B_2 - vo_1_product - product_error(vo_1, B_0, vo_1_product)) / B_0
    vo_1_rounded = where(vo_1_total == vo_1_total, vo_1_total, vo_1)
    vo_2_total = vo_2 + (B_3 - vo_2_product - product_error(vo_2, B_0, vo_2_product)) / B_0
    vo_2_rounded = where(vo_2_total == vo_2_total, vo_2_total, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(10)->(3,3)")
def inertia_about_com(B):
    """Ro = I + h~ h~ / m, the second moments about the centre of mass.

    (10)->(3,3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Ro: rotation or other 3×3 matrix.
    15 mul, 39 add, 9 product error, 9 sum error, 6 div, 6 equal, 6 select.
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
    squares_0_cross1 = B_1 * ((B_1 - c_0_product - product_error(c_0, B_0, c_0_product)) / B_0)
    squares_0_lo = product_error(B_1, c_0, squares_0) + squares_0_cross1
    squares_1 = B_2 * c_1
    squares_1_lo = product_error(B_2, c_1, squares_1) + B_2 * c_1_lo
    squares_2 = B_3 * c_2
    squares_2_lo = product_error(B_3, c_2, squares_2) + B_3 * c_2_lo
    about_0a = squares_1 + squares_2
    about_0a_lo = sum_error(squares_1, squares_2, about_0a) + squares_1_lo + squares_2_lo
    about_0 = B_4 - about_0a
    about_0_lo = difference_error(B_4, about_0a, about_0) - about_0a_lo
    about_1a = squares_0 + squares_2
    about_1a_lo = sum_error(squares_0, squares_2, about_1a) + squares_0_lo + squares_2_lo
    about_1 = B_5 - about_1a
    about_1_lo = difference_error(B_5, about_1a, about_1) - about_1a_lo
    about_2a = squares_0 + squares_1
    about_2a_lo = sum_error(squares_0, squares_1, about_2a) + squares_0_lo + squares_1_lo
    about_2 = B_6 - about_2a
    about_2_lo = difference_error(B_6, about_2a, about_2) - about_2a_lo
    about_3a = B_1 * c_1
    about_3a_lo = product_error(B_1, c_1, about_3a) + B_1 * c_1_lo
    about_3 = about_3a + B_7
    about_3_lo = sum_error(about_3a, B_7, about_3) + about_3a_lo
    about_4a = B_1 * c_2
    about_4a_lo = product_error(B_1, c_2, about_4a) + B_1 * c_2_lo
    about_4 = about_4a + B_8
    about_4_lo = sum_error(about_4a, B_8, about_4) + about_4a_lo
    about_5a = B_2 * c_2
    about_5a_lo = product_error(B_2, c_2, about_5a) + B_2 * c_2_lo
    about_5 = about_5a + B_9
    about_5_lo = sum_error(about_5a, B_9, about_5) + about_5a_lo
    about_0_total = about_0 + about_0_lo
    about_0_rounded = where(about_0_total == about_0_total, about_0_total, about_0)
    about_3_total = about_3 + about_3_lo
    about_3_rounded = where(about_3_total == about_3_total, about_3_total, about_3)
    about_4_total = about_4 + about_4_lo
    about_4_rounded = where(about_4_total == about_4_total, about_4_total, about_4)
    about_1_total = about_1 + about_1_lo
    about_1_rounded = where(about_1_total == about_1_total, about_1_total, about_1)
    about_5_total = about_5 + about_5_lo
    about_5_rounded = where(about_5_total == about_5_total, about_5_total, about_5)
    about_2_total = about_2 + about_2_lo
    about_2_rounded = where(about_2_total == about_2_total, about_2_total, about_2)
    return (about_0_rounded, about_3_rounded, about_4_rounded, about_3_rounded, about_1_rounded,
        about_5_rounded, about_4_rounded, about_5_rounded, about_2_rounded)


@kernel("(10),(6)->(6)")
def product_Bs(B, s):
    """co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.

    (10),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
    24 mul, 60 add, 24 product error, 18 sum error.  Error <= u |result| + (lin: 8, ang: 15) u^2
    S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    co_0a = B_0 * s_0
    co_0b = B_3 * s_4
    co_0c = B_2 * s_5
    co_0d = co_0b - co_0c
    co_0d_lo1 = difference_error(co_0b, co_0c, co_0d) + product_error(B_3, s_4, co_0b)
    co_0d_lo = co_0d_lo1 - product_error(B_2, s_5, co_0c)
    co_0 = co_0a + co_0d
    co_0_lo1 = sum_error(co_0a, co_0d, co_0) + product_error(B_0, s_0, co_0a)
    co_0_lo = co_0_lo1 + co_0d_lo
    co_1a = B_0 * s_1
    co_1b = B_1 * s_5
    co_1c = B_3 * s_3
    co_1d = co_1b - co_1c
    co_1d_lo1 = difference_error(co_1b, co_1c, co_1d) + product_error(B_1, s_5, co_1b)
    co_1d_lo = co_1d_lo1 - product_error(B_3, s_3, co_1c)
    co_1 = co_1a + co_1d
    co_1_lo1 = sum_error(co_1a, co_1d, co_1) + product_error(B_0, s_1, co_1a)
    co_1_lo = co_1_lo1 + co_1d_lo
    co_2a = B_0 * s_2
    co_2b = B_2 * s_3
    co_2c = B_1 * s_4
    co_2d = co_2b - co_2c
    co_2d_lo1 = difference_error(co_2b, co_2c, co_2d) + product_error(B_2, s_3, co_2b)
    co_2d_lo = co_2d_lo1 - product_error(B_1, s_4, co_2c)
    co_2 = co_2a + co_2d
    co_2_lo1 = sum_error(co_2a, co_2d, co_2) + product_error(B_0, s_2, co_2a)
    co_2_lo = co_2_lo1 + co_2d_lo
    co_3a = B_2 * s_2
    co_3b = B_3 * s_1
    co_3c = co_3a - co_3b
    co_3c_lo1 = difference_error(co_3a, co_3b, co_3c) + product_error(B_2, s_2, co_3a)
    co_3c_lo = co_3c_lo1 - product_error(B_3, s_1, co_3b)
    co_3d = B_4 * s_3
    co_3e = B_7 * s_4
    co_3f = co_3d + co_3e
    co_3f_lo1 = sum_error(co_3d, co_3e, co_3f) + product_error(B_4, s_3, co_3d)
    co_3f_lo = co_3f_lo1 + product_error(B_7, s_4, co_3e)
    co_3g = B_8 * s_5
    co_3h = co_3f + co_3g
    co_3h_lo1 = sum_error(co_3f, co_3g, co_3h) + co_3f_lo
    co_3h_lo = co_3h_lo1 + product_error(B_8, s_5, co_3g)
    co_3 = co_3c + co_3h
    co_3_lo1 = sum_error(co_3c, co_3h, co_3) + co_3c_lo
    co_3_lo = co_3_lo1 + co_3h_lo
    co_4a = B_3 * s_0
    co_4b = B_1 * s_2
    co_4c = co_4a - co_4b
    co_4c_lo1 = difference_error(co_4a, co_4b, co_4c) + product_error(B_3, s_0, co_4a)
    co_4c_lo = co_4c_lo1 - product_error(B_1, s_2, co_4b)
    co_4d = B_5 * s_4
    co_4e = B_7 * s_3
    co_4f = co_4d + co_4e
    co_4f_lo1 = sum_error(co_4d, co_4e, co_4f) + product_error(B_5, s_4, co_4d)
    co_4f_lo = co_4f_lo1 + product_error(B_7, s_3, co_4e)
    co_4g = B_9 * s_5
    co_4h = co_4f + co_4g
    co_4h_lo1 = sum_error(co_4f, co_4g, co_4h) + co_4f_lo
    co_4h_lo = co_4h_lo1 + product_error(B_9, s_5, co_4g)
    co_4 = co_4c + co_4h
    co_4_lo1 = sum_error(co_4c, co_4h, co_4) + co_4c_lo
    co_4_lo = co_4_lo1 + co_4h_lo
    co_5a = B_1 * s_1
    co_5b = B_2 * s_0
    co_5c = co_5a - co_5b
    co_5c_lo1 = difference_error(co_5a, co_5b, co_5c) + product_error(B_1, s_1, co_5a)
    co_5c_lo = co_5c_lo1 - product_error(B_2, s_0, co_5b)
    co_5d = B_6 * s_5
    co_5e = B_8 * s_3
    co_5f = co_5d + co_5e
    co_5f_lo1 = sum_error(co_5d, co_5e, co_5f) + product_error(B_6, s_5, co_5d)
    co_5f_lo = co_5f_lo1 + product_error(B_8, s_3, co_5e)
    co_5g = B_9 * s_4
    co_5h = co_5f + co_5g
    co_5h_lo1 = sum_error(co_5f, co_5g, co_5h) + co_5f_lo
    co_5h_lo = co_5h_lo1 + product_error(B_9, s_4, co_5g)
    co_5 = co_5c + co_5h
    co_5_lo1 = sum_error(co_5c, co_5h, co_5) + co_5c_lo
    co_5_lo = co_5_lo1 + co_5h_lo
    co_0_rounded = co_0 + co_0_lo
    co_1_rounded = co_1 + co_1_lo
    co_2_rounded = co_2 + co_2_lo
    co_3_rounded = co_3 + co_3_lo
    co_4_rounded = co_4 + co_4_lo
    co_5_rounded = co_5 + co_5_lo
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(10),(6)->()")
def inertia_energy(B, s):
    """s·B s / 2, the kinetic energy in J of a body that moves with s.

    (10),(6)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy: number.
    38 mul, 77 add, 31 product error, 23 sum error.  Error <= u |result| + 76 u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    p_0a = B_0 * s_0
    p_0b = B_3 * s_4
    p_0c = B_2 * s_5
    p_0d = p_0b - p_0c
    p_0d_lo1 = difference_error(p_0b, p_0c, p_0d) + product_error(B_3, s_4, p_0b)
    p_0d_lo = p_0d_lo1 - product_error(B_2, s_5, p_0c)
    p_0 = p_0a + p_0d
    p_0_lo1 = sum_error(p_0a, p_0d, p_0) + product_error(B_0, s_0, p_0a)
    p_0_lo = p_0_lo1 + p_0d_lo
    p_1a = B_0 * s_1
    p_1b = B_1 * s_5
    p_1c = B_3 * s_3
    p_1d = p_1b - p_1c
    p_1d_lo1 = difference_error(p_1b, p_1c, p_1d) + product_error(B_1, s_5, p_1b)
    p_1d_lo = p_1d_lo1 - product_error(B_3, s_3, p_1c)
    p_1 = p_1a + p_1d
    p_1_lo1 = sum_error(p_1a, p_1d, p_1) + product_error(B_0, s_1, p_1a)
    p_1_lo = p_1_lo1 + p_1d_lo
    p_2a = B_0 * s_2
    p_2b = B_2 * s_3
    p_2c = B_1 * s_4
    p_2d = p_2b - p_2c
    p_2d_lo1 = difference_error(p_2b, p_2c, p_2d) + product_error(B_2, s_3, p_2b)
    p_2d_lo = p_2d_lo1 - product_error(B_1, s_4, p_2c)
    p_2 = p_2a + p_2d
    p_2_lo1 = sum_error(p_2a, p_2d, p_2) + product_error(B_0, s_2, p_2a)
    p_2_lo = p_2_lo1 + p_2d_lo
    p_3a = B_2 * s_2
    p_3b = B_3 * s_1
    p_3c = p_3a - p_3b
    p_3c_lo1 = difference_error(p_3a, p_3b, p_3c) + product_error(B_2, s_2, p_3a)
    p_3c_lo = p_3c_lo1 - product_error(B_3, s_1, p_3b)
    p_3d = B_4 * s_3
    p_3e = B_7 * s_4
    p_3f = p_3d + p_3e
    p_3f_lo1 = sum_error(p_3d, p_3e, p_3f) + product_error(B_4, s_3, p_3d)
    p_3f_lo = p_3f_lo1 + product_error(B_7, s_4, p_3e)
    p_3g = B_8 * s_5
    p_3h = p_3f + p_3g
    p_3h_lo1 = sum_error(p_3f, p_3g, p_3h) + p_3f_lo
    p_3h_lo = p_3h_lo1 + product_error(B_8, s_5, p_3g)
    p_3 = p_3c + p_3h
    p_3_lo1 = sum_error(p_3c, p_3h, p_3) + p_3c_lo
    p_3_lo = p_3_lo1 + p_3h_lo
    p_4a = B_3 * s_0
    p_4b = B_1 * s_2
    p_4c = p_4a - p_4b
    p_4c_lo1 = difference_error(p_4a, p_4b, p_4c) + product_error(B_3, s_0, p_4a)
    p_4c_lo = p_4c_lo1 - product_error(B_1, s_2, p_4b)
    p_4d = B_5 * s_4
    p_4e = B_7 * s_3
    p_4f = p_4d + p_4e
    p_4f_lo1 = sum_error(p_4d, p_4e, p_4f) + product_error(B_5, s_4, p_4d)
    p_4f_lo = p_4f_lo1 + product_error(B_7, s_3, p_4e)
    p_4g = B_9 * s_5
    p_4h = p_4f + p_4g
    p_4h_lo1 = sum_error(p_4f, p_4g, p_4h) + p_4f_lo
    p_4h_lo = p_4h_lo1 + product_error(B_9, s_5, p_4g)
    p_4 = p_4c + p_4h
    p_4_lo1 = sum_error(p_4c, p_4h, p_4) + p_4c_lo
    p_4_lo = p_4_lo1 + p_4h_lo
    p_5a = B_1 * s_1
    p_5b = B_2 * s_0
    p_5c = p_5a - p_5b
    p_5c_lo1 = difference_error(p_5a, p_5b, p_5c) + product_error(B_1, s_1, p_5a)
    p_5c_lo = p_5c_lo1 - product_error(B_2, s_0, p_5b)
    p_5d = B_6 * s_5
    p_5e = B_8 * s_3
    p_5f = p_5d + p_5e
    p_5f_lo1 = sum_error(p_5d, p_5e, p_5f) + product_error(B_6, s_5, p_5d)
    p_5f_lo = p_5f_lo1 + product_error(B_8, s_3, p_5e)
    p_5g = B_9 * s_4
    p_5h = p_5f + p_5g
    p_5h_lo1 = sum_error(p_5f, p_5g, p_5h) + p_5f_lo
    p_5h_lo = p_5h_lo1 + product_error(B_9, s_4, p_5g)
    p_5 = p_5c + p_5h
    p_5_lo1 = sum_error(p_5c, p_5h, p_5) + p_5c_lo
    p_5_lo = p_5_lo1 + p_5h_lo
    twice_a = s_0 * p_0
    twice_a_cross1 = s_0 * p_0_lo
    twice_a_lo = product_error(s_0, p_0, twice_a) + twice_a_cross1
    twice_b = s_1 * p_1
    twice_b_cross1 = s_1 * p_1_lo
    twice_b_lo = product_error(s_1, p_1, twice_b) + twice_b_cross1
    twice_c = twice_a + twice_b
    twice_c_lo1 = sum_error(twice_a, twice_b, twice_c) + twice_a_lo
    twice_c_lo = twice_c_lo1 + twice_b_lo
    twice_d = s_2 * p_2
    twice_d_cross1 = s_2 * p_2_lo
    twice_d_lo = product_error(s_2, p_2, twice_d) + twice_d_cross1
    twice_e = twice_c + twice_d
    twice_e_lo1 = sum_error(twice_c, twice_d, twice_e) + twice_c_lo
    twice_e_lo = twice_e_lo1 + twice_d_lo
    twice_f = s_3 * p_3
    twice_f_cross1 = s_3 * p_3_lo
    twice_f_lo = product_error(s_3, p_3, twice_f) + twice_f_cross1
    twice_g = s_4 * p_4
    twice_g_cross1 = s_4 * p_4_lo
    twice_g_lo = product_error(s_4, p_4, twice_g) + twice_g_cross1
    twice_h = twice_f + twice_g
    twice_h_lo1 = sum_error(twice_f, twice_g, twice_h) + twice_f_lo
    twice_h_lo = twice_h_lo1 + twice_g_lo
    twice_i = s_5 * p_5
    twice_i_cross1 = s_5 * p_5_lo
    twice_i_lo = product_error(s_5, p_5, twice_i) + twice_i_cross1
    twice_j = twice_h + twice_i
    twice_j_lo1 = sum_error(twice_h, twice_i, twice_j) + twice_h_lo
    twice_j_lo = twice_j_lo1 + twice_i_lo
    twice = twice_e + twice_j
    twice_lo1 = sum_error(twice_e, twice_j, twice) + twice_e_lo
    twice_lo = twice_lo1 + twice_j_lo
    energy = 0.5 * twice
    energy_cross1 = 0.5 * twice_lo
    energy_lo = product_error(0.5, twice, energy) + energy_cross1
    energy_rounded = energy + energy_lo
    return energy_rounded


@kernel("(3),(10)->(10)")
def inertia_shifted(t, B):
    """Bo: the body moved by t: h + m t, I - t~ (h + m t)~ - h~ t~.

    (3),(10)->(10).  t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the
    origin, xx, yy, zz, xy, xz, yz in kg m^2).
    21 mul, 60 add, 15 product error, 18 sum error.  Error <= u |result| + (m: 0, h: 2, I: 28)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    moved_0a = t_0 * B_0
    moved_0 = moved_0a + B_1
    moved_0_lo = sum_error(moved_0a, B_1, moved_0) + product_error(t_0, B_0, moved_0a)
    moved_1a = t_1 * B_0
    moved_1 = moved_1a + B_2
    moved_1_lo = sum_error(moved_1a, B_2, moved_1) + product_error(t_1, B_0, moved_1a)
    moved_2a = t_2 * B_0
    moved_2 = moved_2a + B_3
    moved_2_lo = sum_error(moved_2a, B_3, moved_2) + product_error(t_2, B_0, moved_2a)
    own_0a = t_0 * B_1
    own_0b = t_0 * moved_0
    own_0 = own_0a + own_0b
    own_0_lo1 = sum_error(own_0a, own_0b, own_0) + product_error(t_0, B_1, own_0a)
    own_0_lo = own_0_lo1 + (product_error(t_0, moved_0, own_0b) + t_0 * moved_0_lo)
    own_1a = t_1 * B_2
    own_1b = t_1 * moved_1
    own_1 = own_1a + own_1b
    own_1_lo1 = sum_error(own_1a, own_1b, own_1) + product_error(t_1, B_2, own_1a)
    own_1_lo = own_1_lo1 + (product_error(t_1, moved_1, own_1b) + t_1 * moved_1_lo)
    own_2a = t_2 * B_3
    own_2b = t_2 * moved_2
    own_2 = own_2a + own_2b
    own_2_lo1 = sum_error(own_2a, own_2b, own_2) + product_error(t_2, B_3, own_2a)
    own_2_lo = own_2_lo1 + (product_error(t_2, moved_2, own_2b) + t_2 * moved_2_lo)
    Bo_4a = own_1 + own_2
    Bo_4 = B_4 + Bo_4a
    Bo_4_lo = sum_error(B_4, Bo_4a, Bo_4) + (sum_error(own_1, own_2, Bo_4a) + own_1_lo + own_2_lo)
    Bo_5a = own_0 + own_2
    Bo_5 = B_5 + Bo_5a
    Bo_5_lo = sum_error(B_5, Bo_5a, Bo_5) + (sum_error(own_0, own_2, Bo_5a) + own_0_lo + own_2_lo)
    Bo_6a = own_0 + own_1
    Bo_6 = B_6 + Bo_6a
    Bo_6_lo = sum_error(B_6, Bo_6a, Bo_6) + (sum_error(own_0, own_1, Bo_6a) + own_0_lo + own_1_lo)
    Bo_7a = t_0 * moved_1
    Bo_7a_lo = product_error(t_0, moved_1, Bo_7a) + t_0 * moved_1_lo
    Bo_7b = B_7 - Bo_7a
    Bo_7b_lo = difference_error(B_7, Bo_7a, Bo_7b) - Bo_7a_lo
    Bo_7c = t_1 * B_1
    Bo_7 = Bo_7b - Bo_7c
    Bo_7_lo1 = difference_error(Bo_7b, Bo_7c, Bo_7) + Bo_7b_lo
    Bo_7_lo = Bo_7_lo1 - product_error(t_1, B_1, Bo_7c)
    Bo_8a = t_0 * moved_2
    Bo_8a_lo = product_error(t_0, moved_2, Bo_8a) + t_0 * moved_2_lo
    Bo_8b = B_8 - Bo_8a
    Bo_8b_lo = difference_error(B_8, Bo_8a, Bo_8b) - Bo_8a_lo
    Bo_8c = t_2 * B_1
    Bo_8 = Bo_8b - Bo_8c
    Bo_8_lo1 = difference_error(Bo_8b, Bo_8c, Bo_8) + Bo_8b_lo
    Bo_8_lo = Bo_8_lo1 - product_error(t_2, B_1, Bo_8c)
    Bo_9a = t_1 * moved_2
    Bo_9a_lo = product_error(t_1, moved_2, Bo_9a) + t_1 * moved_2_lo
    Bo_9b = B_9 - Bo_9a
    Bo_9b_lo = difference_error(B_9, Bo_9a, Bo_9b) - Bo_9a_lo
    Bo_9c = t_2 * B_2
    Bo_9 = Bo_9b - Bo_9c
    Bo_9_lo1 = difference_error(Bo_9b, Bo_9c, Bo_9) + Bo_9b_lo
    Bo_9_lo = Bo_9_lo1 - product_error(t_2, B_2, Bo_9c)
    moved_0_rounded = moved_0 + moved_0_lo
    moved_1_rounded = moved_1 + moved_1_lo
    moved_2_rounded = moved_2 + moved_2_lo
    Bo_4_rounded = Bo_4 + Bo_4_lo
    Bo_5_rounded = Bo_5 + Bo_5_lo
    Bo_6_rounded = Bo_6 + Bo_6_lo
    Bo_7_rounded = Bo_7 + Bo_7_lo
    Bo_8_rounded = Bo_8 + Bo_8_lo
    Bo_9_rounded = Bo_9 + Bo_9_lo
    return (B_0, moved_0_rounded, moved_1_rounded, moved_2_rounded, Bo_4_rounded, Bo_5_rounded,
        Bo_6_rounded, Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(3,4),(10)->(10)")
def inertia_transformed(D, B):
    """Bo = [Ad]*(D) B [Ad]^-1(D): the inertia in the frame D takes its own to.

    (3,4),(10)->(10).  D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in
    kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    99 mul, 201 add, 69 product error, 54 sum error.  Error <= u |result| + (m: 0, h: 15, I: 69)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    RI_0a = D_00 * B_4
    RI_0b = D_01 * B_7
    RI_0c = RI_0a + RI_0b
    RI_0c_lo1 = sum_error(RI_0a, RI_0b, RI_0c) + product_error(D_00, B_4, RI_0a)
    RI_0c_lo = RI_0c_lo1 + product_error(D_01, B_7, RI_0b)
    RI_0d = D_02 * B_8
    RI_0 = RI_0c + RI_0d
    RI_0_lo1 = sum_error(RI_0c, RI_0d, RI_0) + RI_0c_lo
    RI_0_lo = RI_0_lo1 + product_error(D_02, B_8, RI_0d)
    RI_1a = D_00 * B_7
    RI_1b = D_01 * B_5
    RI_1c = RI_1a + RI_1b
    RI_1c_lo1 = sum_error(RI_1a, RI_1b, RI_1c) + product_error(D_00, B_7, RI_1a)
    RI_1c_lo = RI_1c_lo1 + product_error(D_01, B_5, RI_1b)
    RI_1d = D_02 * B_9
    RI_1 = RI_1c + RI_1d
    RI_1_lo1 = sum_error(RI_1c, RI_1d, RI_1) + RI_1c_lo
    RI_1_lo = RI_1_lo1 + product_error(D_02, B_9, RI_1d)
    RI_2a = D_00 * B_8
    RI_2b = D_01 * B_9
    RI_2c = RI_2a + RI_2b
    RI_2c_lo1 = sum_error(RI_2a, RI_2b, RI_2c) + product_error(D_00, B_8, RI_2a)
    RI_2c_lo = RI_2c_lo1 + product_error(D_01, B_9, RI_2b)
    RI_2d = D_02 * B_6
    RI_2 = RI_2c + RI_2d
    RI_2_lo1 = sum_error(RI_2c, RI_2d, RI_2) + RI_2c_lo
    RI_2_lo = RI_2_lo1 + product_error(D_02, B_6, RI_2d)
    RI_3a = D_10 * B_4
    RI_3b = D_11 * B_7
    RI_3c = RI_3a + RI_3b
    RI_3c_lo1 = sum_error(RI_3a, RI_3b, RI_3c) + product_error(D_10, B_4, RI_3a)
    RI_3c_lo = RI_3c_lo1 + product_error(D_11, B_7, RI_3b)
    RI_3d = D_12 * B_8
    RI_3 = RI_3c + RI_3d
    RI_3_lo1 = sum_error(RI_3c, RI_3d, RI_3) + RI_3c_lo
    RI_3_lo = RI_3_lo1 + product_error(D_12, B_8, RI_3d)
    RI_4a = D_10 * B_7
    RI_4b = D_11 * B_5
    RI_4c = RI_4a + RI_4b
    RI_4c_lo1 = sum_error(RI_4a, RI_4b, RI_4c) + product_error(D_10, B_7, RI_4a)
    RI_4c_lo = RI_4c_lo1 + product_error(D_11, B_5, RI_4b)
    RI_4d = D_12 * B_9
    RI_4 = RI_4c + RI_4d
    RI_4_lo1 = sum_error(RI_4c, RI_4d, RI_4) + RI_4c_lo
    RI_4_lo = RI_4_lo1 + product_error(D_12, B_9, RI_4d)
    RI_5a = D_10 * B_8
    RI_5b = D_11 * B_9
    RI_5c = RI_5a + RI_5b
    RI_5c_lo1 = sum_error(RI_5a, RI_5b, RI_5c) + product_error(D_10, B_8, RI_5a)
    RI_5c_lo = RI_5c_lo1 + product_error(D_11, B_9, RI_5b)
    RI_5d = D_12 * B_6
    RI_5 = RI_5c + RI_5d
    RI_5_lo1 = sum_error(RI_5c, RI_5d, RI_5) + RI_5c_lo
    RI_5_lo = RI_5_lo1 + product_error(D_12, B_6, RI_5d)
    RI_6a = D_20 * B_4
    RI_6b = D_21 * B_7
    RI_6c = RI_6a + RI_6b
    RI_6c_lo1 = sum_error(RI_6a, RI_6b, RI_6c) + product_error(D_20, B_4, RI_6a)
    RI_6c_lo = RI_6c_lo1 + product_error(D_21, B_7, RI_6b)
    RI_6d = D_22 * B_8
    RI_6 = RI_6c + RI_6d
    RI_6_lo1 = sum_error(RI_6c, RI_6d, RI_6) + RI_6c_lo
    RI_6_lo = RI_6_lo1 + product_error(D_22, B_8, RI_6d)
    RI_7a = D_20 * B_7
    RI_7b = D_21 * B_5
    RI_7c = RI_7a + RI_7b
    RI_7c_lo1 = sum_error(RI_7a, RI_7b, RI_7c) + product_error(D_20, B_7, RI_7a)
    RI_7c_lo = RI_7c_lo1 + product_error(D_21, B_5, RI_7b)
    RI_7d = D_22 * B_9
    RI_7 = RI_7c + RI_7d
    RI_7_lo1 = sum_error(RI_7c, RI_7d, RI_7) + RI_7c_lo
    RI_7_lo = RI_7_lo1 + product_error(D_22, B_9, RI_7d)
    RI_8a = D_20 * B_8
    RI_8b = D_21 * B_9
    RI_8c = RI_8a + RI_8b
    RI_8c_lo1 = sum_error(RI_8a, RI_8b, RI_8c) + product_error(D_20, B_8, RI_8a)
    RI_8c_lo = RI_8c_lo1 + product_error(D_21, B_9, RI_8b)
    RI_8d = D_22 * B_6
    RI_8 = RI_8c + RI_8d
    RI_8_lo1 = sum_error(RI_8c, RI_8d, RI_8) + RI_8c_lo
    RI_8_lo = RI_8_lo1 + product_error(D_22, B_6, RI_8d)
    turned_1a = D_00 * B_1
    turned_1b = D_01 * B_2
    turned_1c = turned_1a + turned_1b
    turned_1c_lo1 = sum_error(turned_1a, turned_1b, turned_1c) + product_error(D_00, B_1, turned_1a)
    turned_1c_lo = turned_1c_lo1 + product_error(D_01, B_2, turned_1b)
    turned_1d = D_02 * B_3
    turned_1 = turned_1c + turned_1d
    turned_1_lo1 = sum_error(turned_1c, turned_1d, turned_1) + turned_1c_lo
    turned_1_lo = turned_1_lo1 + product_error(D_02, B_3, turned_1d)
    turned_2a = D_10 * B_1
    turned_2b = D_11 * B_2
    turned_2c = turned_2a + turned_2b
    turned_2c_lo1 = sum_error(turned_2a, turned_2b, turned_2c) + product_error(D_10, B_1, turned_2a)
    turned_2c_lo = turned_2c_lo1 + product_error(D_11, B_2, turned_2b)
    turned_2d = D_12 * B_3
    turned_2 = turned_2c + turned_2d
    turned_2_lo1 = sum_error(turned_2c, turned_2d, turned_2) + turned_2c_lo
    turned_2_lo = turned_2_lo1 + product_error(D_12, B_3, turned_2d)
    turned_3a = D_20 * B_1
    turned_3b = D_21 * B_2
    turned_3c = turned_3a + turned_3b
    turned_3c_lo1 = sum_error(turned_3a, turned_3b, turned_3c) + product_error(D_20, B_1, turned_3a)
    turned_3c_lo = turned_3c_lo1 + product_error(D_21, B_2, turned_3b)
    turned_3d = D_22 * B_3
    turned_3 = turned_3c + turned_3d
    turned_3_lo1 = sum_error(turned_3c, turned_3d, turned_3) + turned_3c_lo
    turned_3_lo = turned_3_lo1 + product_error(D_22, B_3, turned_3d)
    turned_4a = D_00 * RI_0
    turned_4a_lo = product_error(D_00, RI_0, turned_4a) + D_00 * RI_0_lo
    turned_4b = D_01 * RI_1
    turned_4c = turned_4a + turned_4b
    turned_4c_lo1 = sum_error(turned_4a, turned_4b, turned_4c) + turned_4a_lo
    turned_4c_lo = turned_4c_lo1 + (product_error(D_01, RI_1, turned_4b) + D_01 * RI_1_lo)
    turned_4d = D_02 * RI_2
    turned_4 = turned_4c + turned_4d
    turned_4_lo1 = sum_error(turned_4c, turned_4d, turned_4) + turned_4c_lo
    turned_4_lo = turned_4_lo1 + (product_error(D_02, RI_2, turned_4d) + D_02 * RI_2_lo)
    turned_5a = D_10 * RI_3
    turned_5a_lo = product_error(D_10, RI_3, turned_5a) + D_10 * RI_3_lo
    turned_5b = D_11 * RI_4
    turned_5c = turned_5a + turned_5b
    turned_5c_lo1 = sum_error(turned_5a, turned_5b, turned_5c) + turned_5a_lo
    turned_5c_lo = turned_5c_lo1 + (product_error(D_11, RI_4, turned_5b) + D_11 * RI_4_lo)
    turned_5d = D_12 * RI_5
    turned_5 = turned_5c + turned_5d
    turned_5_lo1 = sum_error(turned_5c, turned_5d, turned_5) + turned_5c_lo
    turned_5_lo = turned_5_lo1 + (product_error(D_12, RI_5, turned_5d) + D_12 * RI_5_lo)
    turned_6a = D_20 * RI_6
    turned_6a_cross1 = D_20 * RI_6_lo
    turned_6a_lo = product_error(D_20, RI_6, turned_6a) + turned_6a_cross1
    turned_6b = D_21 * RI_7
    turned_6b_cross1 = D_21 * RI_7_lo
    turned_6b_lo = product_error(D_21, RI_7, turned_6b) + turned_6b_cross1
    turned_6c = turned_6a + turned_6b
    turned_6c_lo1 = sum_error(turned_6a, turned_6b, turned_6c) + turned_6a_lo
    turned_6c_lo = turned_6c_lo1 + turned_6b_lo
    turned_6d = D_22 * RI_8
    turned_6d_cross1 = D_22 * RI_8_lo
    turned_6d_lo = product_error(D_22, RI_8, turned_6d) + turned_6d_cross1
    turned_6 = turned_6c + turned_6d
    turned_6_lo1 = sum_error(turned_6c, turned_6d, turned_6) + turned_6c_lo
    turned_6_lo = turned_6_lo1 + turned_6d_lo
    turned_7a = D_10 * RI_0
    turned_7a_lo = product_error(D_10, RI_0, turned_7a) + D_10 * RI_0_lo
    turned_7b = D_11 * RI_1
    turned_7c = turned_7a + turned_7b
    turned_7c_lo1 = sum_error(turned_7a, turned_7b, turned_7c) + turned_7a_lo
    turned_7c_lo = turned_7c_lo1 + (product_error(D_11, RI_1, turned_7b) + D_11 * RI_1_lo)
    turned_7d = D_12 * RI_2
    turned_7 = turned_7c + turned_7d
    turned_7_lo1 = sum_error(turned_7c, turned_7d, turned_7) + turned_7c_lo
    turned_7_lo = turned_7_lo1 + (product_error(D_12, RI_2, turned_7d) + D_12 * RI_2_lo)
    turned_8a = D_20 * RI_0
    turned_8a_lo = product_error(D_20, RI_0, turned_8a) + D_20 * RI_0_lo
    turned_8b = D_21 * RI_1
    turned_8c = turned_8a + turned_8b
    turned_8c_lo1 = sum_error(turned_8a, turned_8b, turned_8c) + turned_8a_lo
    turned_8c_lo = turned_8c_lo1 + (product_error(D_21, RI_1, turned_8b) + D_21 * RI_1_lo)
    turned_8d = D_22 * RI_2
    turned_8 = turned_8c + turned_8d
    turned_8_lo1 = sum_error(turned_8c, turned_8d, turned_8) + turned_8c_lo
    turned_8_lo = turned_8_lo1 + (product_error(D_22, RI_2, turned_8d) + D_22 * RI_2_lo)
    turned_9a = D_20 * RI_3
    turned_9a_lo = product_error(D_20, RI_3, turned_9a) + D_20 * RI_3_lo
    turned_9b = D_21 * RI_4
    turned_9c = turned_9a + turned_9b
    turned_9c_lo1 = sum_error(turned_9a, turned_9b, turned_9c) + turned_9a_lo
    turned_9c_lo = turned_9c_lo1 + (product_error(D_21, RI_4, turned_9b) + D_21 * RI_4_lo)
    turned_9d = D_22 * RI_5
    turned_9 = turned_9c + turned_9d
    turned_9_lo1 = sum_error(turned_9c, turned_9d, turned_9) + turned_9c_lo
    turned_9_lo = turned_9_lo1 + (product_error(D_22, RI_5, turned_9d) + D_22 * RI_5_lo)
    moved_0a = D_03 * B_0
    moved_0 = moved_0a + turned_1
    moved_0_lo1 = sum_error(moved_0a, turned_1, moved_0) + product_error(D_03, B_0, moved_0a)
    moved_0_lo = moved_0_lo1 + turned_1_lo
    moved_1a = D_13 * B_0
    moved_1 = moved_1a + turned_2
    moved_1_lo1 = sum_error(moved_1a, turned_2, moved_1) + product_error(D_13, B_0, moved_1a)
    moved_1_lo = moved_1_lo1 + turned_2_lo
    moved_2a = D_23 * B_0
    moved_2 = moved_2a + turned_3
    moved_2_lo1 = sum_error(moved_2a, turned_3, moved_2) + product_error(D_23, B_0, moved_2a)
    moved_2_lo = moved_2_lo1 + turned_3_lo
    own_0a = D_03 * turned_1
    own_0a_lo = product_error(D_03, turned_1, own_0a) + D_03 * turned_1_lo
    own_0b = D_03 * moved_0
    own_0 = own_0a + own_0b
    own_0_lo1 = sum_error(own_0a, own_0b, own_0) + own_0a_lo
    own_0_lo = own_0_lo1 + (product_error(D_03, moved_0, own_0b) + D_03 * moved_0_lo)
    own_1a = D_13 * turned_2
    own_1a_lo = product_error(D_13, turned_2, own_1a) + D_13 * turned_2_lo
    own_1b = D_13 * moved_1
    own_1 = own_1a + own_1b
    own_1_lo1 = sum_error(own_1a, own_1b, own_1) + own_1a_lo
    own_1_lo = own_1_lo1 + (product_error(D_13, moved_1, own_1b) + D_13 * moved_1_lo)
    own_2a = D_23 * turned_3
    own_2a_lo = product_error(D_23, turned_3, own_2a) + D_23 * turned_3_lo
    own_2b = D_23 * moved_2
    own_2 = own_2a + own_2b
    own_2_lo1 = sum_error(own_2a, own_2b, own_2) + own_2a_lo
    own_2_lo = own_2_lo1 + (product_error(D_23, moved_2, own_2b) + D_23 * moved_2_lo)
    Bo_4a = own_1 + own_2
    Bo_4 = turned_4 + Bo_4a
    Bo_4_lo1 = sum_error(turned_4, Bo_4a, Bo_4) + turned_4_lo
    Bo_4_lo = Bo_4_lo1 + (sum_error(own_1, own_2, Bo_4a) + own_1_lo + own_2_lo)
    Bo_5a = own_0 + own_2
    Bo_5 = turned_5 + Bo_5a
    Bo_5_lo1 = sum_error(turned_5, Bo_5a, Bo_5) + turned_5_lo
    Bo_5_lo = Bo_5_lo1 + (sum_error(own_0, own_2, Bo_5a) + own_0_lo + own_2_lo)
    Bo_6a = own_0 + own_1
    Bo_6 = turned_6 + Bo_6a
    Bo_6_lo1 = sum_error(turned_6, Bo_6a, Bo_6) + turned_6_lo
    Bo_6_lo = Bo_6_lo1 + (sum_error(own_0, own_1, Bo_6a) + own_0_lo + own_1_lo)
    Bo_7a = D_03 * moved_1
    Bo_7b = turned_7 - Bo_7a
    Bo_7b_lo1 = difference_error(turned_7, Bo_7a, Bo_7b) + turned_7_lo
    Bo_7b_lo = Bo_7b_lo1 - (product_error(D_03, moved_1, Bo_7a) + D_03 * moved_1_lo)
    Bo_7c = D_13 * turned_1
    Bo_7 = Bo_7b - Bo_7c
    Bo_7_lo1 = difference_error(Bo_7b, Bo_7c, Bo_7) + Bo_7b_lo
    Bo_7_lo = Bo_7_lo1 - (product_error(D_13, turned_1, Bo_7c) + D_13 * turned_1_lo)
    Bo_8a = D_03 * moved_2
    Bo_8b = turned_8 - Bo_8a
    Bo_8b_lo1 = difference_error(turned_8, Bo_8a, Bo_8b) + turned_8_lo
    Bo_8b_lo = Bo_8b_lo1 - (product_error(D_03, moved_2, Bo_8a) + D_03 * moved_2_lo)
    Bo_8c = D_23 * turned_1
    Bo_8 = Bo_8b - Bo_8c
    Bo_8_lo1 = difference_error(Bo_8b, Bo_8c, Bo_8) + Bo_8b_lo
    Bo_8_lo = Bo_8_lo1 - (product_error(D_23, turned_1, Bo_8c) + D_23 * turned_1_lo)
    Bo_9a = D_13 * moved_2
    Bo_9b = turned_9 - Bo_9a
    Bo_9b_lo1 = difference_error(turned_9, Bo_9a, Bo_9b) + turned_9_lo
    Bo_9b_lo = Bo_9b_lo1 - (product_error(D_13, moved_2, Bo_9a) + D_13 * moved_2_lo)
    Bo_9c = D_23 * turned_2
    Bo_9 = Bo_9b - Bo_9c
    Bo_9_lo1 = difference_error(Bo_9b, Bo_9c, Bo_9) + Bo_9b_lo
    Bo_9_lo = Bo_9_lo1 - (product_error(D_23, turned_2, Bo_9c) + D_23 * turned_2_lo)
    moved_0_rounded = moved_0 + moved_0_lo
    moved_1_rounded = moved_1 + moved_1_lo
    moved_2_rounded = moved_2 + moved_2_lo
    Bo_4_rounded = Bo_4 + Bo_4_lo
    Bo_5_rounded = Bo_5 + Bo_5_lo
    Bo_6_rounded = Bo_6 + Bo_6_lo
    Bo_7_rounded = Bo_7 + Bo_7_lo
    Bo_8_rounded = Bo_8 + Bo_8_lo
    Bo_9_rounded = Bo_9 + Bo_9_lo
    return (B_0, moved_0_rounded, moved_1_rounded, moved_2_rounded, Bo_4_rounded, Bo_5_rounded,
        Bo_6_rounded, Bo_7_rounded, Bo_8_rounded, Bo_9_rounded)


@kernel("(10)->()")
def inertia_consistency(B):
    """the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each as a part of its diagonal entry:
    positive exactly if a body of positive density has this inertia.

    (10)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,
    xz, yz in kg m^2); pivot: number.
    43 mul, 97 add, 23 product error, 26 sum error, 20 div, 6 neg, 9 less, 1 equal, 26 select.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    trace_a = 0.5 * B_4
    trace_b = 0.5 * B_5
    trace_c = trace_a + trace_b
    trace_c_lo1 = sum_error(trace_a, trace_b, trace_c) + product_error(0.5, B_4, trace_a)
    trace_c_lo = trace_c_lo1 + product_error(0.5, B_5, trace_b)
    trace_d = 0.5 * B_6
    trace = trace_c + trace_d
    trace_lo1 = sum_error(trace_c, trace_d, trace) + trace_c_lo
    trace_lo = trace_lo1 + product_error(0.5, B_6, trace_d)
    sigma_0 = trace - B_4
    sigma_0_lo = difference_error(trace, B_4, sigma_0) + trace_lo
    sigma_1 = trace - B_5
    sigma_1_lo = difference_error(trace, B_5, sigma_1) + trace_lo
    sigma_2 = trace - B_6
    sigma_2_lo = difference_error(trace, B_6, sigma_2) + trace_lo
    divisor0 = where(0 < B_0, B_0, 1)
    l0_0 = B_1 / divisor0
    l0_0_product = l0_0 * divisor0
    l0_0_lo = (B_1 - l0_0_product - product_error(l0_0, divisor0, l0_0_product)) / divisor0
    l0_1 = B_2 / divisor0
    l0_1_product = l0_1 * divisor0
    l0_1_lo = (B_2 - l0_1_product - product_error(l0_1, divisor0, l0_1_product)) / divisor0
    l0_2 = B_3 / divisor0
    l0_2_product = l0_2 * divisor0
    l0_2_lo = (B_3 - l0_2_product - product_error(l0_2, divisor0, l0_2_product)) / divisor0
    u1_0a = B_1 * l0_0
    u1_0 = sigma_0 - u1_0a
    u1_0_lo1 = difference_error(sigma_0, u1_0a, u1_0) + sigma_0_lo
    u1_0_lo = u1_0_lo1 - (product_error(B_1, l0_0, u1_0a) + B_1 * l0_0_lo)
    u1_1a = B_2 * l0_0
    u1_1b = u1_1a + B_7
    u1_1 = -u1_1b
    u1_1_lo = -(sum_error(u1_1a, B_7, u1_1b) + (product_error(B_2, l0_0, u1_1a) + B_2 * l0_0_lo))
    u1_2a = B_3 * l0_0
    u1_2b = u1_2a + B_8
    u1_2 = -u1_2b
    u1_2_lo = -(sum_error(u1_2a, B_8, u1_2b) + (product_error(B_3, l0_0, u1_2a) + B_3 * l0_0_lo))
    divisor1 = where(0 < u1_0, u1_0, 1)
    divisor1_lo = where(0 < u1_0, u1_0_lo, 0)
    l1_0_of_u1_1 = u1_1 + u1_1_lo
    l1_0_of_u1_1_lo = sum_error(u1_1, u1_1_lo, l1_0_of_u1_1)
    l1_0_of_divisor1 = divisor1 + divisor1_lo
    l1_0_of_divisor1_lo = sum_error(divisor1, divisor1_lo, l1_0_of_divisor1)
    l1_0 = l1_0_of_u1_1 / l1_0_of_divisor1
    l1_0_product = l1_0 * l1_0_of_divisor1
    l1_0_exact = l1_0_of_u1_1 - l1_0_product - product_error(l1_0, l1_0_of_divisor1, l1_0_product)
    l1_0_lo1 = l1_0_exact + l1_0_of_u1_1_lo
    l1_0_residual = l1_0_lo1 - l1_0 * l1_0_of_divisor1_lo
    l1_0_lo = l1_0_residual / l1_0_of_divisor1
    l1_1_of_u1_2 = u1_2 + u1_2_lo
    l1_1_of_u1_2_lo = sum_error(u1_2, u1_2_lo, l1_1_of_u1_2)
    l1_1 = l1_1_of_u1_2 / l1_0_of_divisor1
    l1_1_product = l1_1 * l1_0_of_divisor1
    l1_1_exact = l1_1_of_u1_2 - l1_1_product - product_error(l1_1, l1_0_of_divisor1, l1_1_product)
    l1_1_lo1 = l1_1_exact + l1_1_of_u1_2_lo
    l1_1_residual = l1_1_lo1 - l1_1 * l1_0_of_divisor1_lo
    l1_1_lo = l1_1_residual / l1_0_of_divisor1
    u2_0a = B_2 * l0_1
    u2_0b = sigma_1 - u2_0a
    u2_0b_lo1 = difference_error(sigma_1, u2_0a, u2_0b) + sigma_1_lo
    u2_0b_lo = u2_0b_lo1 - (product_error(B_2, l0_1, u2_0a) + B_2 * l0_1_lo)
    u2_0c = l1_0_of_u1_1 * l1_0
    u2_0c_lo1 = product_error(l1_0_of_u1_1, l1_0, u2_0c) + l1_0_of_u1_1_lo * l1_0
    u2_0c_lo = u2_0c_lo1 + l1_0_of_u1_1 * l1_0_lo
    u2_0 = u2_0b - u2_0c
    u2_0_lo1 = difference_error(u2_0b, u2_0c, u2_0) + u2_0b_lo
    u2_0_lo = u2_0_lo1 - u2_0c_lo
    u2_1a = B_3 * l0_1
    u2_1b = u2_1a + B_9
    u2_1b_lo = sum_error(u2_1a, B_9, u2_1b) + (product_error(B_3, l0_1, u2_1a) + B_3 * l0_1_lo)
    u2_1c = l1_1_of_u1_2 * l1_0
    u2_1c_lo1 = product_error(l1_1_of_u1_2, l1_0, u2_1c) + l1_1_of_u1_2_lo * l1_0
    u2_1c_lo = u2_1c_lo1 + l1_1_of_u1_2 * l1_0_lo
    u2_1d = u2_1b + u2_1c
    u2_1d_lo1 = sum_error(u2_1b, u2_1c, u2_1d) + u2_1b_lo
    u2_1d_lo = u2_1d_lo1 + u2_1c_lo
    u2_1 = -u2_1d
    u2_1_lo = -u2_1d_lo
    divisor2 = where(0 < u2_0, u2_0, 1)
    divisor2_lo = where(0 < u2_0, u2_0_lo, 0)
    l2_of_u2_1 = u2_1 + u2_1_lo
    l2_of_u2_1_lo = sum_error(u2_1, u2_1_lo, l2_of_u2_1)
    l2_of_divisor2 = divisor2 + divisor2_lo
    l2 = l2_of_u2_1 / l2_of_divisor2
    l2_product = l2 * l2_of_divisor2
    l2_lo1 = l2_of_u2_1 - l2_product - product_error(l2, l2_of_divisor2, l2_product) + l2_of_u2_1_lo
    l2_residual = l2_lo1 - l2 * sum_error(divisor2, divisor2_lo, l2_of_divisor2)
    l2_lo = l2_residual / l2_of_divisor2
    u3a = B_3 * l0_2
    u3a_cross1 = B_3 * l0_2_lo
    u3a_lo = product_error(B_3, l0_2, u3a) + u3a_cross1
    u3b = sigma_2 - u3a
    u3b_lo = difference_error(sigma_2, u3a, u3b) + sigma_2_lo - u3a_lo
    u3c = l1_1_of_u1_2 * l1_1
    u3c_cross2 = l1_1_of_u1_2 * l1_1_lo
    u3c_lo1 = product_error(l1_1_of_u1_2, l1_1, u3c) + l1_1_of_u1_2_lo * l1_1
    u3c_lo = u3c_lo1 + u3c_cross2
    u3d = u3b - u3c
    u3d_lo1 = difference_error(u3b, u3c, u3d) + u3b_lo
    u3d_lo = u3d_lo1 - u3c_lo
    u3e = l2_of_u2_1 * l2
    u3e_cross2 = l2_of_u2_1 * l2_lo
    u3e_lo1 = product_error(l2_of_u2_1, l2, u3e) + l2_of_u2_1_lo * l2
    u3e_lo = u3e_lo1 + u3e_cross2
    u3 = u3d - u3e
    u3_lo1 = difference_error(u3d, u3e, u3) + u3d_lo
    u3_lo = u3_lo1 - u3e_lo
    part0a = B_0 / divisor0
    part0a_product = part0a * divisor0
    part0a_lo = (B_0 - part0a_product - product_error(part0a, divisor0, part0a_product)) / divisor0
    part0 = where(0 < B_0, part0a, B_0)
    part0_lo = where(0 < B_0, part0a_lo, 0)
    own1 = where(0 < sigma_0, sigma_0, 1)
    own1_lo = where(0 < sigma_0, sigma_0_lo, 0)
    part1a_of_u1_0 = u1_0 + u1_0_lo
    part1a_of_own1 = own1 + own1_lo
    part1a = part1a_of_u1_0 / part1a_of_own1
    part1a_product = part1a * part1a_of_own1
    part1a_product_error = product_error(part1a, part1a_of_own1, part1a_product)
    part1a_exact = part1a_of_u1_0 - part1a_product - part1a_product_error
    part1a_lo1 = part1a_exact + sum_error(u1_0, u1_0_lo, part1a_of_u1_0)
    part1a_residual = part1a_lo1 - part1a * sum_error(own1, own1_lo, part1a_of_own1)
    part1a_lo = part1a_residual / part1a_of_own1
    part1 = where(0 < sigma_0, part1a, sigma_0)
    part1_lo = where(0 < sigma_0, part1a_lo, sigma_0_lo)
    smallest1 = where(part0 < part1, part0, part1)
    smallest1_lo = where(part0 < part1, part0_lo, part1_lo)
    own2 = where(0 < sigma_1, sigma_1, 1)
    own2_lo = where(0 < sigma_1, sigma_1_lo, 0)
    part2a_of_u2_0 = u2_0 + u2_0_lo
    part2a_of_own2 = own2 + own2_lo
    part2a = part2a_of_u2_0 / part2a_of_own2
    part2a_product = part2a * part2a_of_own2
    part2a_product_error = product_error(part2a, part2a_of_own2, part2a_product)
    part2a_exact = part2a_of_u2_0 - part2a_product - part2a_product_error
    part2a_lo1 = part2a_exact + sum_error(u2_0, u2_0_lo, part2a_of_u2_0)
    part2a_residual = part2a_lo1 - part2a * sum_error(own2, own2_lo, part2a_of_own2)
    part2a_lo = part2a_residual / part2a_of_own2
    part2 = where(0 < sigma_1, part2a, sigma_1)
    part2_lo = where(0 < sigma_1, part2a_lo, sigma_1_lo)
    smallest2 = where(smallest1 < part2, smallest1, part2)
    smallest2_lo = where(smallest1 < part2, smallest1_lo, part2_lo)
    own3 = where(0 < sigma_2, sigma_2, 1)
    own3_lo = where(0 < sigma_2, sigma_2_lo, 0)
    part3a_of_u3 = u3 + u3_lo
    part3a_of_own3 = own3 + own3_lo
    part3a = part3a_of_u3 / part3a_of_own3
    part3a_product = part3a * part3a_of_own3
    part3a_product_error = product_error(part3a, part3a_of_own3, part3a_product)
    part3a_exact = part3a_of_u3 - part3a_product - part3a_product_error
    part3a_lo1 = part3a_exact + sum_error(u3, u3_lo, part3a_of_u3)
    part3a_residual = part3a_lo1 - part3a * sum_error(own3, own3_lo, part3a_of_own3)
    part3a_lo = part3a_residual / part3a_of_own3
    part3 = where(0 < sigma_2, part3a, sigma_2)
    part3_lo = where(0 < sigma_2, part3a_lo, sigma_2_lo)
    smallest3 = where(smallest2 < part3, smallest2, part3)
    smallest3_lo = where(smallest2 < part3, smallest2_lo, part3_lo)
    smallest3_total = smallest3 + smallest3_lo
    smallest3_rounded = where(smallest3_total == smallest3_total, smallest3_total, smallest3)
    return smallest3_rounded
