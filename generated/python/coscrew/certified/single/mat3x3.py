# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew import _elementary_single as elementary
from numpy import float32 as real
from coscrew._exact import product_error_single as product_error, product_rest_single as product_rest
from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, elementary=elementary, real=real, product_error=product_error,
    product_rest=product_rest, quiet=True)

acceleration_tensor = twin(double.acceleration_tensor, c1=1.9721522630525295e-31, c2=1.192093e-07)
mat3x3_determinant = twin(double.mat3x3_determinant, c1=1.9721522630525295e-31, c2=2.9802328e-07)
mat3x3_setFromAxisDC = twin(double.mat3x3_setFromAxisDC, c1=1.9721522630525295e-31,
    c2=2.3841864e-07)
mat3x3_from_euler_xyz = twin(double.mat3x3_from_euler_xyz, c1=2.252443e-12, c2=1.0800312e-12,
    c3=7.7379336e-12,
    doc="""R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.

(3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.
237 mul, 347 add, 30 product error, 8 product rest, 3 div, 9 neg, 18 abs, 3 less, 3 select.
""")
euler_xyz_from_mat3x3 = twin(double.euler_xyz_from_mat3x3, c1=3.308722450212111e-24,
    c2=2.7711354e-13, c3=262144, c4=1705893691392, c5=6.430494e-13, c6=549752635392,
    c7=1.875852e-12, c8=2.8564286e-12, c9=360860844032, c10=1.0800314e-12, c11=549754798080,
    c12=3.2294905e-12, c13=157071343616, c14=2.2026954e-13, c15=6.565516e-12, c16=157071294464,
    c17=274876317696, c18=6.5655177e-12, c19=3.751704e-12, c20=1.8758445e-12,
    c21=1.2676506002282294e+30,
    doc="""angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
[-π/2, π/2]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.

(3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.
353 mul, 588 add, 45 product error, 6 product rest, 27 div, 2 sqrt, 4 neg, 72 abs, 12
copysign, 59 less, 14 equal, 108 select.
""")
mat3x3_from_euler_xyx = twin(double.mat3x3_from_euler_xyx, c1=1.0800312e-12, c2=2.252443e-12,
    c3=7.7379336e-12,
    doc="""R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.

(3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.
237 mul, 347 add, 30 product error, 8 product rest, 3 div, 5 neg, 18 abs, 3 less, 3 select.
""")
euler_xyx_from_mat3x3 = twin(double.euler_xyx_from_mat3x3, c1=3.308722450212111e-24,
    c2=2.7711354e-13, c3=262144, c4=1705893691392, c5=6.430494e-13, c6=549752635392,
    c7=1.875852e-12, c8=2.8564286e-12, c9=360860844032, c10=1.0800314e-12, c11=549754798080,
    c12=3.2294905e-12, c13=157071343616, c14=2.2026954e-13, c15=6.565516e-12, c16=157071294464,
    c17=274876317696, c18=6.5655177e-12, c19=3.751704e-12, c20=1.8758445e-12,
    c21=1.2676506002282294e+30,
    doc="""angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in
[0, π]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.

(3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.
353 mul, 588 add, 45 product error, 6 product rest, 27 div, 2 sqrt, 3 neg, 72 abs, 12
copysign, 61 less, 14 equal, 110 select.
""")
mat3x3_from_axis_angle = twin(double.mat3x3_from_axis_angle, c1=3.308722450212111e-24,
    c2=1.0800312e-12, c3=2.6858765e-12, c4=2.5864118e-12, c5=137437683712, c6=8.6439935e-12,
    c7=8.189208e-12,
    doc="""R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
not a rotation; |error of R| <= R_bound unless inf or NaN.

(3),()->(3,3),(3,3).  axis: vector; angle: number; R, R_bound: rotation or other 3×3 matrix.
180 mul, 322 add, 20 product error, 18 product rest, 2 div, 24 abs, 4 less, 6 select.
""")
axis_angle_from_mat3x3 = twin(double.axis_angle_from_mat3x3, c1=3.308722450212111e-24,
    c2=4.6185646e-13, c3=549753683968, c4=4.611686018427388e+18, c5=2.710505431213761e-20,
    c6=1.8014398509481984e+16, c7=1.4210854715202004e-14, c8=3.2451855365842673e+32,
    c9=1.9326999e-12, c10=262144, c11=3.3147653e-12, c12=396154929152, c13=3.6893488147419103e+19,
    c14=5.551115123125783e-17, c15=3.0814879110195774e-33, c16=2.7161363e-12, c17=1.8758484e-12,
    c18=157070458880, c19=2.6379647e-12, c20=274872680448, c21=3.7517537e-12, c22=5.367124e-12,
    c23=191387877376, c24=6.6757142e-12, c25=5.3671256e-12, c26=1.2676506002282294e+30,
    doc="""angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0;
|error of angle| <= angle_bound, |error of axis| <= axis_bound unless inf or NaN.

(3,3)->(),(3),(),(3).  R: rotation or other 3×3 matrix; angle, angle_bound: number; axis,
axis_bound: vector.
199 mul, 408 add, 18 product error, 3 product rest, 24 div, 2 sqrt, 10 neg, 70 abs, 4
copysign, 41 less, 7 equal, 111 select.
""")
