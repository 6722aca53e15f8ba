# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__)

mat6x6_copy = twin(double.mat6x6_copy)
mat6x6_setIdentity = twin(double.mat6x6_setIdentity)
mat6x6_transposed = twin(double.mat6x6_transposed)
mat6x6_rotated = twin(double.mat6x6_rotated)
mat6x6_shifted = twin(double.mat6x6_shifted)
