# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Displacements D = [R | t].

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, quiet=True)

SE3_invert = twin(double.SE3_invert, c1=1.9721522630525295e-31, c2=1.7881396e-07)
SE3_inverted = twin(double.SE3_inverted, c1=1.9721522630525295e-31, c2=1.7881396e-07)
