# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, quiet=True)

inertia = twin(double.inertia, c1=1.9721522630525295e-31, c2=5.960465e-08)
inertia_rotated = twin(double.inertia_rotated, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=3.5762795e-07)
inertia_rotate = twin(double.inertia_rotate, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=3.5762795e-07)
inertia_translated = twin(double.inertia_translated, c1=1.9721522630525295e-31, c2=1.192093e-07)
inertia_translate = twin(double.inertia_translate, c1=1.9721522630525295e-31, c2=1.192093e-07)
inertia_transformed = twin(double.inertia_transformed, c1=1.9721522630525295e-31, c2=2.3841864e-07,
    c3=3.5762795e-07)
inertia_transform = twin(double.inertia_transform, c1=1.9721522630525295e-31, c2=2.3841864e-07,
    c3=3.5762795e-07)
