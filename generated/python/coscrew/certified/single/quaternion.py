# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew import _elementary_single as elementary
from numpy import float32 as real
from coscrew._exact import product_error_single as product_error, product_rest_single as product_rest
from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, elementary=elementary, real=real, product_error=product_error,
    product_rest=product_rest, quiet=True)

quaternion_scale = twin(double.quaternion_scale, c1=1.9721522630525295e-31, c2=5.960465e-08)
axpy_qq = twin(double.axpy_qq, c1=1.9721522630525295e-31, c2=1.192093e-07)
rotate_qv = twin(double.rotate_qv, c1=1.9721522630525295e-31, c2=4.1723263e-07)
rotate_qconjv = twin(double.rotate_qconjv, c1=1.9721522630525295e-31, c2=4.1723263e-07)
quaternion_product_qq = twin(double.quaternion_product_qq, c1=1.9721522630525295e-31,
    c2=2.3841864e-07)
quaternion_product_qqconj = twin(double.quaternion_product_qqconj, c1=1.9721522630525295e-31,
    c2=1.7881396e-07, c3=2.3841864e-07)
quaternion_product_qconjq = twin(double.quaternion_product_qconjq, c1=1.9721522630525295e-31,
    c2=1.7881396e-07, c3=2.3841864e-07)
quaternion_product_qconjqconj = twin(double.quaternion_product_qconjqconj,
    c1=1.9721522630525295e-31, c2=2.3841864e-07)
quaternion_product_qxq = twin(double.quaternion_product_qxq, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qxqconj = twin(double.quaternion_product_qxqconj, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qxconjq = twin(double.quaternion_product_qxconjq, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qxconjqconj = twin(double.quaternion_product_qxconjqconj,
    c1=1.9721522630525295e-31, c2=1.192093e-07)
quaternion_product_qqx = twin(double.quaternion_product_qqx, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qqxconj = twin(double.quaternion_product_qqxconj, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qconjqx = twin(double.quaternion_product_qconjqx, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qconjqxconj = twin(double.quaternion_product_qconjqxconj,
    c1=1.9721522630525295e-31, c2=1.192093e-07)
quaternion_product_qyq = twin(double.quaternion_product_qyq, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qyqconj = twin(double.quaternion_product_qyqconj, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qyconjq = twin(double.quaternion_product_qyconjq, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qyconjqconj = twin(double.quaternion_product_qyconjqconj,
    c1=1.9721522630525295e-31, c2=1.192093e-07)
quaternion_product_qqy = twin(double.quaternion_product_qqy, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qqyconj = twin(double.quaternion_product_qqyconj, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qconjqy = twin(double.quaternion_product_qconjqy, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qconjqyconj = twin(double.quaternion_product_qconjqyconj,
    c1=1.9721522630525295e-31, c2=1.192093e-07)
quaternion_product_qzq = twin(double.quaternion_product_qzq, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qzqconj = twin(double.quaternion_product_qzqconj, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qzconjq = twin(double.quaternion_product_qzconjq, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qzconjqconj = twin(double.quaternion_product_qzconjqconj,
    c1=1.9721522630525295e-31, c2=1.192093e-07)
quaternion_product_qqz = twin(double.quaternion_product_qqz, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qqzconj = twin(double.quaternion_product_qqzconj, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qconjqz = twin(double.quaternion_product_qconjqz, c1=1.9721522630525295e-31,
    c2=1.192093e-07)
quaternion_product_qconjqzconj = twin(double.quaternion_product_qconjqzconj,
    c1=1.9721522630525295e-31, c2=1.192093e-07)
quaternion_product_qv = twin(double.quaternion_product_qv, c1=1.9721522630525295e-31,
    c2=1.7881396e-07)
quaternion_product_qconjv = twin(double.quaternion_product_qconjv, c1=1.9721522630525295e-31,
    c2=1.7881396e-07)
quaternion_product_vq = twin(double.quaternion_product_vq, c1=1.9721522630525295e-31,
    c2=1.7881396e-07)
quaternion_product_vqconj = twin(double.quaternion_product_vqconj, c1=1.9721522630525295e-31,
    c2=1.7881396e-07)
dot_qq = twin(double.dot_qq, c1=1.9721522630525295e-31, c2=2.3841864e-07)
add_dpiToq = twin(double.add_dpiToq, c1=1.9721522630525295e-31, c2=2.9802328e-07)
subtract_dpiFromq = twin(double.subtract_dpiFromq, c1=1.9721522630525295e-31, c2=2.9802328e-07)
omega_to_dquaternion = twin(double.omega_to_dquaternion, c1=1.9721522630525295e-31,
    c2=4.1723263e-07)
quaternion_from_axis_angle = twin(double.quaternion_from_axis_angle, c1=3.308722450212111e-24,
    c2=1.2399095e-12, c3=1.1724027e-12,
    doc="""qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
rotation is by another angle; |error of qo| <= qo_bound unless inf or NaN.

(3),()->(4),(4).  axis: vector; angle: number; qo, qo_bound: quaternion (x, y, z, w), the
scalar last.
80 mul, 110 add, 11 product error, 1 div, 11 abs, 1 less, 1 select.
""")
axis_angle_from_quaternion = twin(double.axis_angle_from_quaternion, c1=4.611686018427388e+18,
    c2=2.710505431213761e-20, c3=1.8014398509481984e+16, c4=1.4210854715202004e-14,
    c5=3.2451855365842673e+32, c6=1.401298464324817e-45, c7=3.308722450212111e-24, c8=3.197449e-14,
    c9=1099513724928, c10=9.841079e-13, c11=262144, c12=2.0854824e-12, c13=554074177536,
    c14=5.551115123125783e-17, c15=3.0814879110195774e-33, c16=1.977137e-12, c17=9.379186e-13,
    c18=169153347584, c19=1.9042977e-12, c20=314141605888, c21=3.2827692e-12, c22=4.7394384e-12,
    c23=216848252928, c24=6.2013957e-12, c25=4.7394397e-12,
    doc="""angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
angle is 0; any multiple of a quaternion; |error of angle| <= angle_bound, |error of axis|
<= axis_bound unless inf or NaN.

(4)->(),(3),(),(3).  q: quaternion (x, y, z, w), the scalar last; angle, angle_bound:
number; axis, axis_bound: vector.
167 mul, 259 add, 18 product error, 3 product rest, 24 div, 2 sqrt, 5 neg, 50 abs, 4
copysign, 35 less, 10 equal, 69 select.
""")
quaternion_exp = twin(double.quaternion_exp, c1=8192, c2=3.308722450212111e-24, c3=3.5527347e-14,
    c4=4.611686018427388e+18, c5=2.710505431213761e-20, c6=3.6893488147419103e+19, c7=9.308236e-13,
    c8=262144, c9=695847616512, c10=1.6484983e-12, c11=1.401298464324817e-45, c12=199908212736,
    c13=5.1586396e-12, c14=-4.967054e-09, c15=0.16666669, c16=2.3639474e-10, c17=7.941701e-12,
    c18=4235066880, c19=2.3639482e-10, c20=1.0000005, c21=2.3676172e-10, c22=3.041182e-12,
    doc="""qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v; |error
of qo| <= qo_bound unless inf or NaN.

(3)->(4),(4).  v: vector; qo, qo_bound: quaternion (x, y, z, w), the scalar last.
236 mul, 305 add, 14 product error, 4 product rest, 11 div, 3 sqrt, 37 abs, 11 less, 1
equal, 24 select.
""")
quaternion_log = twin(double.quaternion_log, c1=4.611686018427388e+18, c2=2.710505431213761e-20,
    c3=1.8014398509481984e+16, c4=1.4210854715202004e-14, c5=3.2451855365842673e+32,
    c6=1.401298464324817e-45, c7=3.308722450212111e-24, c8=3.197449e-14, c9=1099513724928,
    c10=9.379186e-13, c11=9.841079e-13, c12=262144, c13=2.0854824e-12, c14=554074177536,
    c15=5.551115123125783e-17, c16=3.0814879110195774e-33, c17=1.977137e-12, c18=169153347584,
    c19=244332298240, c20=4.2207045e-12, c21=8.927625e-12, c22=9.281226e-12,
    doc="""vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of
it; |error of vo| <= vo_bound unless inf or NaN.

(4)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; vo, vo_bound: vector.
175 mul, 256 add, 19 product error, 3 product rest, 16 div, 2 sqrt, 5 neg, 49 abs, 4
copysign, 35 less, 10 equal, 65 select.
""")
