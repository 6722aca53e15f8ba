# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Sine and cosine of a joint angle.

In double precision, accurate tier.
"""

from coscrew import _elementary_double as elementary
from numpy import where
from coscrew._kernel import double_kernel as kernel


@kernel("()->(2)")
def dc(theta):
    """dc = (sin θ, cos θ), θ in rad.

    ()->(2).  theta: number; dc: (sin θ, cos θ).
    83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.  Error <= 0.501
    ulp, unless a result is subnormal; proved.
    """
    dc_0, dc_1 = elementary.sincos(theta)
    dc_0_own_error, dc_1_own_error = elementary.sincos_error(theta, dc_0, dc_1)
    dc_0_rounded = dc_0 + dc_0_own_error
    dc_1_rounded = dc_1 + dc_1_own_error
    dc_0_final = where(dc_0_rounded == dc_0_rounded, dc_0_rounded, dc_0)
    dc_1_final = where(dc_1_rounded == dc_1_rounded, dc_1_rounded, dc_1)
    return (dc_0_final, dc_1_final)
