# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__)

spatial_inertia_copy = twin(double.spatial_inertia_copy)
spatial_inertia_scale = twin(double.spatial_inertia_scale)
add_BB = twin(double.add_BB)
subtract_BB = twin(double.subtract_BB)
spatial_inertia_from_com = twin(double.spatial_inertia_from_com)
spatial_inertia_from_inertia = twin(double.spatial_inertia_from_inertia)
inertia_from_spatial_inertia = twin(double.inertia_from_spatial_inertia)
spatial_inertia_com = twin(double.spatial_inertia_com)
spatial_inertia_about_com = twin(double.spatial_inertia_about_com)
spatial_inertia_matrix = twin(double.spatial_inertia_matrix)
product_Bs = twin(double.product_Bs)
spatial_inertia_energy = twin(double.spatial_inertia_energy)
spatial_inertia_net_wrench = twin(double.spatial_inertia_net_wrench)
spatial_inertia_shifted = twin(double.spatial_inertia_shifted)
spatial_inertia_transformed = twin(double.spatial_inertia_transformed)
spatial_inertia_consistency = twin(double.spatial_inertia_consistency)
