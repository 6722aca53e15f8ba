# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of three components.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew import _elementary_single as elementary
from numpy import float32 as real
from coscrew._exact import product_error_single as product_error, product_rest_single as product_rest
from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, elementary=elementary, real=real, product_error=product_error,
    product_rest=product_rest, quiet=True)

vec3_scale = twin(double.vec3_scale, c1=1.9721522630525295e-31, c2=5.960465e-08)
axpy_vv = twin(double.axpy_vv, c1=1.9721522630525295e-31, c2=1.192093e-07)
xpy_vv = twin(double.xpy_vv, c1=5.960465e-08)
nxpy_vv = twin(double.nxpy_vv, c1=5.960465e-08)
product_av = twin(double.product_av, c1=1.9721522630525295e-31, c2=5.960465e-08)
add_vv = twin(double.add_vv, c1=5.960465e-08)
subtract_vv = twin(double.subtract_vv, c1=5.960465e-08)
vec3_scaled = twin(double.vec3_scaled, c1=1.9721522630525295e-31, c2=5.960465e-08)
angle_vv = twin(double.angle_vv, c1=4.611686018427388e+18, c2=2.710505431213761e-20,
    c3=1.8014398509481984e+16, c4=1.4210854715202004e-14, c5=3.2451855365842673e+32,
    c6=3.308722450212111e-24, c7=4.8672736e-13, c8=262144, c9=2.4301075e-12, c10=436385742848,
    c11=3.6893488147419103e+19, c12=5.551115123125783e-17, c13=3.0814879110195774e-33,
    c14=2.5225009e-12, c15=7.141026e-13, c16=137436504064, c17=7.503497e-12,
    doc="""angle = atan2(|v1 × v2|, v1·v2), in [0, π]; |error of angle| <= angle_bound unless inf or
NaN.

(3),(3)->(),().  v1, v2: vector; angle, angle_bound: number.
162 mul, 252 add, 15 product error, 12 product rest, 12 div, 2 sqrt, 1 neg, 40 abs, 4
copysign, 37 less, 5 equal, 56 select.
""")
dot_vv = twin(double.dot_vv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_avinv = twin(double.product_avinv, c1=1.9721522630525295e-31, c2=5.960465e-08)
cross_vv = twin(double.cross_vv, c1=1.9721522630525295e-31, c2=1.192093e-07)
cross_vvinv = twin(double.cross_vvinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
add_vvx = twin(double.add_vvx, c1=5.960465e-08)
add_vvxinv = twin(double.add_vvxinv, c1=5.960465e-08)
add_vvy = twin(double.add_vvy, c1=5.960465e-08)
add_vvyinv = twin(double.add_vvyinv, c1=5.960465e-08)
add_vvz = twin(double.add_vvz, c1=5.960465e-08)
add_vvzinv = twin(double.add_vvzinv, c1=5.960465e-08)
