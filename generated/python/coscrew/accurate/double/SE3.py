# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Displacements D = [R | t].

In double precision, accurate tier.
"""

from coscrew._exact import product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(3,4)->(3,4)")
def SE3_invert(self):
    """self = self^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    (self_00, self_01, self_02, self_03, self_10, self_11, self_12, self_13, self_20, self_21,
        self_22, self_23) = self
    self_03_new_a = self_00 * self_03
    self_03_new_b = self_10 * self_13
    self_03_new_c = self_03_new_a + self_03_new_b
    self_03_new_c_right = self_03_new_c - self_03_new_a
    self_03_new_c_left_rest = product_rest(self_00, self_03, self_03_new_a,
        self_03_new_c - self_03_new_c_right)
    self_03_new_d = self_20 * self_23
    self_03_new_e = self_03_new_c + self_03_new_d
    self_03_new_e_right = self_03_new_e - self_03_new_c
    self_03_new_e_lo1 = (self_03_new_c - (self_03_new_e - self_03_new_e_right)
        + product_rest(self_20, self_23, self_03_new_d, self_03_new_e_right))
    self_03_new = -self_03_new_e
    self_13_new_a = self_01 * self_03
    self_13_new_b = self_11 * self_13
    self_13_new_c = self_13_new_a + self_13_new_b
    self_13_new_c_right = self_13_new_c - self_13_new_a
    self_13_new_c_left_rest = product_rest(self_01, self_03, self_13_new_a,
        self_13_new_c - self_13_new_c_right)
    self_13_new_d = self_21 * self_23
    self_13_new_e = self_13_new_c + self_13_new_d
    self_13_new_e_right = self_13_new_e - self_13_new_c
    self_13_new_e_lo1 = (self_13_new_c - (self_13_new_e - self_13_new_e_right)
        + product_rest(self_21, self_23, self_13_new_d, self_13_new_e_right))
    self_13_new = -self_13_new_e
    self_23_new_a = self_02 * self_03
    self_23_new_b = self_12 * self_13
    self_23_new_c = self_23_new_a + self_23_new_b
    self_23_new_c_right = self_23_new_c - self_23_new_a
    self_23_new_c_left_rest = product_rest(self_02, self_03, self_23_new_a,
        self_23_new_c - self_23_new_c_right)
    self_23_new_d = self_22 * self_23
    self_23_new_e = self_23_new_c + self_23_new_d
    self_23_new_e_right = self_23_new_e - self_23_new_c
    self_23_new_e_lo1 = (self_23_new_c - (self_23_new_e - self_23_new_e_right)
        + product_rest(self_22, self_23, self_23_new_d, self_23_new_e_right))
    self_23_new = -self_23_new_e
    self_03_new_lo = -(self_03_new_e_lo1 + (self_03_new_c_left_rest + product_rest(self_10, self_13,
        self_03_new_b, self_03_new_c_right)))
    self_03_new_rounded = self_03_new + self_03_new_lo
    self_13_new_lo = -(self_13_new_e_lo1 + (self_13_new_c_left_rest + product_rest(self_11, self_13,
        self_13_new_b, self_13_new_c_right)))
    self_13_new_rounded = self_13_new + self_13_new_lo
    self_23_new_lo = -(self_23_new_e_lo1 + (self_23_new_c_left_rest + product_rest(self_12, self_13,
        self_23_new_b, self_23_new_c_right)))
    self_23_new_rounded = self_23_new + self_23_new_lo
    return (self_00, self_10, self_20, self_03_new_rounded, self_01, self_11, self_21,
        self_13_new_rounded, self_02, self_12, self_22, self_23_new_rounded)


@kernel("(3,4)->(3,4)")
def SE3_inverted(D):
    """Do = D^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_00 * D_03
    Do_03b = D_10 * D_13
    Do_03c = Do_03a + Do_03b
    Do_03c_right = Do_03c - Do_03a
    Do_03d = D_20 * D_23
    Do_03e = Do_03c + Do_03d
    Do_03e_right = Do_03e - Do_03c
    Do_03c_lo = (product_rest(D_00, D_03, Do_03a, Do_03c - Do_03c_right)
        + product_rest(D_10, D_13, Do_03b, Do_03c_right))
    Do_03 = -Do_03e
    Do_13a = D_01 * D_03
    Do_13b = D_11 * D_13
    Do_13c = Do_13a + Do_13b
    Do_13c_right = Do_13c - Do_13a
    Do_13d = D_21 * D_23
    Do_13e = Do_13c + Do_13d
    Do_13e_right = Do_13e - Do_13c
    Do_13c_lo = (product_rest(D_01, D_03, Do_13a, Do_13c - Do_13c_right)
        + product_rest(D_11, D_13, Do_13b, Do_13c_right))
    Do_13 = -Do_13e
    Do_23a = D_02 * D_03
    Do_23b = D_12 * D_13
    Do_23c = Do_23a + Do_23b
    Do_23c_right = Do_23c - Do_23a
    Do_23d = D_22 * D_23
    Do_23e = Do_23c + Do_23d
    Do_23e_right = Do_23e - Do_23c
    Do_23c_lo = (product_rest(D_02, D_03, Do_23a, Do_23c - Do_23c_right)
        + product_rest(D_12, D_13, Do_23b, Do_23c_right))
    Do_23 = -Do_23e
    Do_03_rounded = (Do_03 +
        -(Do_03c - (Do_03e - Do_03e_right) + product_rest(D_20, D_23, Do_03d, Do_03e_right)
        + Do_03c_lo))
    Do_13_rounded = (Do_13 +
        -(Do_13c - (Do_13e - Do_13e_right) + product_rest(D_21, D_23, Do_13d, Do_13e_right)
        + Do_13c_lo))
    Do_23_rounded = (Do_23 +
        -(Do_23c - (Do_23e - Do_23e_right) + product_rest(D_22, D_23, Do_23d, Do_23e_right)
        + Do_23c_lo))
    return (D_00, D_10, D_20, Do_03_rounded, D_01, D_11, D_21, Do_13_rounded, D_02, D_12, D_22,
        Do_23_rounded)
