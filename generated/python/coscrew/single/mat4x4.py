# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""4×4 matrices: displacements [[R, t], [0, 1]] and other maps of homogeneous coordinates.

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__)

mat4x4_fromSE3 = twin(double.mat4x4_fromSE3)
mat4x4_fromRt = twin(double.mat4x4_fromRt)
mat4x4_toSE3 = twin(double.mat4x4_toSE3)
mat4x4_setIdentity = twin(double.mat4x4_setIdentity)
mat4x4_getTranslation = twin(double.mat4x4_getTranslation)
