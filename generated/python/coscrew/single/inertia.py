# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__)

inertia = twin(double.inertia)
inertia_copy = twin(double.inertia_copy)
inertia_rotated = twin(double.inertia_rotated)
inertia_rotate = twin(double.inertia_rotate)
inertia_translated = twin(double.inertia_translated)
inertia_translate = twin(double.inertia_translate)
inertia_transformed = twin(double.inertia_transformed)
inertia_transform = twin(double.inertia_transform)
inertia_merge = twin(double.inertia_merge)
