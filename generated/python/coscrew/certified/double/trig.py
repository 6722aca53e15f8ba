# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Sine and cosine of a joint angle.

In double precision, certified tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("()->(2),(2)")
@errstate(all="ignore")
def dc(theta, *, c1=3.7470896994678994e-30):
    """dc = (sin θ, cos θ), θ in rad; |error of dc| <= dc_bound unless inf or NaN.

    ()->(2),(2).  theta: number; dc, dc_bound: (sin θ, cos θ).
    83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select.
    """
    dc_0, dc_1 = elementary.sincos(theta)
    dc_own_error_1, dc_own_error_2 = elementary.sincos_error(theta, dc_0, dc_1)
    dc_bound_1 = c1 + absolute(dc_own_error_1)
    dc_bound_2 = c1 + absolute(dc_own_error_2)
    return (dc_0, dc_1, dc_bound_1, dc_bound_2)
