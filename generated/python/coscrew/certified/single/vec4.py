# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of four components: three dimensions and a homogeneous coordinate.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, quiet=True)

vec4_scale = twin(double.vec4_scale, c1=1.9721522630525295e-31, c2=5.960465e-08)
vec4_scaled = twin(double.vec4_scaled, c1=1.9721522630525295e-31, c2=5.960465e-08)
