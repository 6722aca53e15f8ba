# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of four components: three dimensions and a homogeneous coordinate.

In single precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import single_kernel as kernel
from numpy import errstate


@kernel("(4),()->(4),(4)")
@errstate(all="ignore")
def vec4_scale(self, a):
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (4),()->(4),(4).  self, self_bound: vector (x, y, z) and a homogeneous coordinate w; a:
    number.
    8 mul, 4 add, 4 abs.
    """
    self_0, self_1, self_2, self_3 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_0_new_bound = 5.960465e-08 * (absolute(self_0_new) + 1.9721522630525295e-31)
    self_1_new_bound = 5.960465e-08 * (absolute(self_1_new) + 1.9721522630525295e-31)
    self_2_new_bound = 5.960465e-08 * (absolute(self_2_new) + 1.9721522630525295e-31)
    self_3_new_bound = 5.960465e-08 * (absolute(self_3_new) + 1.9721522630525295e-31)
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_0_new_bound, self_1_new_bound,
        self_2_new_bound, self_3_new_bound)


@kernel("(4),()->(4),(4)")
@errstate(all="ignore")
def vec4_scaled(v, k):
    """vo = k v; |error of vo| <= vo_bound unless inf or NaN.

    (4),()->(4),(4).  v, vo, vo_bound: vector (x, y, z) and a homogeneous coordinate w; k:
    number.
    8 mul, 4 add, 4 abs.
    """
    v_0, v_1, v_2, v_3 = v
    vo_0 = v_0 * k
    vo_1 = v_1 * k
    vo_2 = v_2 * k
    vo_3 = v_3 * k
    vo_0_bound = 5.960465e-08 * (absolute(vo_0) + 1.9721522630525295e-31)
    vo_1_bound = 5.960465e-08 * (absolute(vo_1) + 1.9721522630525295e-31)
    vo_2_bound = 5.960465e-08 * (absolute(vo_2) + 1.9721522630525295e-31)
    vo_3_bound = 5.960465e-08 * (absolute(vo_3) + 1.9721522630525295e-31)
    return (vo_0, vo_1, vo_2, vo_3, vo_0_bound, vo_1_bound, vo_2_bound, vo_3_bound)
