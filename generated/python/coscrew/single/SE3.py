# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Displacements D = [R | t].

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__)

SE3_fromRt = twin(double.SE3_fromRt)
SE3_copy = twin(double.SE3_copy)
SE3_setIdentity = twin(double.SE3_setIdentity)
SE3_getTranslation = twin(double.SE3_getTranslation)
SE3_getRotation = twin(double.SE3_getRotation)
SE3_invert = twin(double.SE3_invert)
SE3_toMat4x4 = twin(double.SE3_toMat4x4)
SE3_inverted = twin(double.SE3_inverted)
