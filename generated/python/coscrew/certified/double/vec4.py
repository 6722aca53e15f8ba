# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of four components: three dimensions and a homogeneous coordinate.

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(4),()->(4),(4)")
@errstate(all="ignore")
def vec4_scale(self, a, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
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
    self_0_new_bound = c2 * (absolute(self_0_new) + c1)
    self_1_new_bound = c2 * (absolute(self_1_new) + c1)
    self_2_new_bound = c2 * (absolute(self_2_new) + c1)
    self_3_new_bound = c2 * (absolute(self_3_new) + c1)
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_0_new_bound, self_1_new_bound,
        self_2_new_bound, self_3_new_bound)


@kernel("(4),()->(4),(4)")
@errstate(all="ignore")
def vec4_scaled(v, k, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
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
    vo_0_bound = c2 * (absolute(vo_0) + c1)
    vo_1_bound = c2 * (absolute(vo_1) + c1)
    vo_2_bound = c2 * (absolute(vo_2) + c1)
    vo_3_bound = c2 * (absolute(vo_3) + c1)
    return (vo_0, vo_1, vo_2, vo_3, vo_0_bound, vo_1_bound, vo_2_bound, vo_3_bound)
