# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Displacements D = [R | t].

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(3,4)->(3,4),(3,4)")
@errstate(all="ignore")
def SE3_invert(self, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """self = self^-1 = [R^T | -R^T t]; |error of self| <= self_bound unless inf or NaN.

    (3,4)->(3,4),(3,4).  self, self_bound: displacement [R | t], R rotation, t in m.
    12 mul, 15 add, 3 neg, 9 abs.
    """
    (self_00, self_01, self_02, self_03, self_10, self_11, self_12, self_13, self_20, self_21,
        self_22, self_23) = self
    self_03_new_a = self_00 * self_03
    self_03_new_b = self_10 * self_13
    self_03_new_d = self_20 * self_23
    self_03_new = -(self_03_new_a + self_03_new_b + self_03_new_d)
    self_13_new_a = self_01 * self_03
    self_13_new_b = self_11 * self_13
    self_13_new_d = self_21 * self_23
    self_13_new = -(self_13_new_a + self_13_new_b + self_13_new_d)
    self_23_new_a = self_02 * self_03
    self_23_new_b = self_12 * self_13
    self_23_new_d = self_22 * self_23
    self_23_new = -(self_23_new_a + self_23_new_b + self_23_new_d)
    self_03_new_e_bound = (c2
        * (absolute(self_03_new_a) + absolute(self_03_new_b) + absolute(self_03_new_d) + c1))
    self_13_new_e_bound = (c2
        * (absolute(self_13_new_a) + absolute(self_13_new_b) + absolute(self_13_new_d) + c1))
    self_23_new_e_bound = (c2
        * (absolute(self_23_new_a) + absolute(self_23_new_b) + absolute(self_23_new_d) + c1))
    return (self_00, self_10, self_20, self_03_new, self_01, self_11, self_21, self_13_new, self_02,
        self_12, self_22, self_23_new, 0, 0, 0, self_03_new_e_bound, 0, 0, 0, self_13_new_e_bound,
        0, 0, 0, self_23_new_e_bound)


@kernel("(3,4)->(3,4),(3,4)")
@errstate(all="ignore")
def SE3_inverted(D, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """Do = D^-1 = [R^T | -R^T t]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m.
    12 mul, 15 add, 3 neg, 9 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_00 * D_03
    Do_03b = D_10 * D_13
    Do_03d = D_20 * D_23
    Do_03 = -(Do_03a + Do_03b + Do_03d)
    Do_13a = D_01 * D_03
    Do_13b = D_11 * D_13
    Do_13d = D_21 * D_23
    Do_13 = -(Do_13a + Do_13b + Do_13d)
    Do_23a = D_02 * D_03
    Do_23b = D_12 * D_13
    Do_23d = D_22 * D_23
    Do_23 = -(Do_23a + Do_23b + Do_23d)
    Do_03e_bound = c2 * (absolute(Do_03a) + absolute(Do_03b) + absolute(Do_03d) + c1)
    Do_13e_bound = c2 * (absolute(Do_13a) + absolute(Do_13b) + absolute(Do_13d) + c1)
    Do_23e_bound = c2 * (absolute(Do_23a) + absolute(Do_23b) + absolute(Do_23d) + c1)
    return (D_00, D_10, D_20, Do_03, D_01, D_11, D_21, Do_13, D_02, D_12, D_22, Do_23, 0, 0, 0,
        Do_03e_bound, 0, 0, 0, Do_13e_bound, 0, 0, 0, Do_23e_bound)
