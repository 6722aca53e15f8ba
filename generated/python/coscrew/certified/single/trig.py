# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Sine and cosine of a joint angle.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew import _elementary_single as elementary
from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, elementary=elementary, quiet=True)

dc = twin(double.dc, c1=1.0800312e-12,
    doc="""dc = (sin θ, cos θ), θ in rad; |error of dc| <= dc_bound unless inf or NaN.

()->(2),(2).  theta: number; dc, dc_bound: (sin θ, cos θ).
65 mul, 100 add, 8 product error, 1 div, 5 abs, 1 less, 1 select.
""")
