# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, quiet=True)

spatial_inertia_scale = twin(double.spatial_inertia_scale, c1=1.9721522630525295e-31,
    c2=5.960465e-08)
add_BB = twin(double.add_BB, c1=5.960465e-08)
subtract_BB = twin(double.subtract_BB, c1=5.960465e-08)
spatial_inertia_from_com = twin(double.spatial_inertia_from_com, c1=1.9721522630525295e-31,
    c2=5.960465e-08, c3=2.3841864e-07, c4=1.7881396e-07)
product_Bs = twin(double.product_Bs, c1=1.9721522630525295e-31, c2=1.7881396e-07, c3=2.3841864e-07)
spatial_inertia_energy = twin(double.spatial_inertia_energy, c1=1.9721522630525295e-31,
    c2=5.36442e-07)
spatial_inertia_net_wrench = twin(double.spatial_inertia_net_wrench, c1=1.9721522630525295e-31,
    c2=3.5762795e-07, c3=4.1723263e-07)
spatial_inertia_shifted = twin(double.spatial_inertia_shifted, c1=1.9721522630525295e-31,
    c2=1.192093e-07, c3=4.1723263e-07, c4=3.5762795e-07)
spatial_inertia_transformed = twin(double.spatial_inertia_transformed, c1=1.9721522630525295e-31,
    c2=2.3841864e-07, c3=4.7683733e-07, c4=4.1723263e-07)
