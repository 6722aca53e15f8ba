# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Sine and cosine of a joint angle.

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew import _elementary_single as elementary
from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__, elementary=elementary)

dc = twin(double.dc,
    doc="""dc = (sin θ, cos θ), θ in rad.

()->(2).  theta: number; dc: (sin θ, cos θ).
22 mul, 27 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
subnormal; proved.
""")
