# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, quiet=True)

mat6x6_rotated = twin(double.mat6x6_rotated, c1=1.9721522630525295e-31, c2=3.5762795e-07)
mat6x6_shifted = twin(double.mat6x6_shifted, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=4.1723263e-07)
