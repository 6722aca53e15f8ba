# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In double precision, accurate tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, nan, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(3),(3)->(3,3)")
def acceleration_tensor(w, dw):
    """Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
    acceleration of its point x, less that of its origin, is Ro x.

    (3),(3)->(3,3).  w, dw: vector; Ro: rotation or other 3×3 matrix.
    6 mul, 51 add, 12 product rest, 6 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    w_0, w_1, w_2 = w
    dw_0, dw_1, dw_2 = dw
    ww_0 = w_0 * w_0
    ww_1 = w_1 * w_1
    ww_2 = w_2 * w_2
    ww_3 = w_0 * w_1
    ww_4 = w_0 * w_2
    ww_5 = w_1 * w_2
    Ro_00a = ww_1 + ww_2
    Ro_00a_right = Ro_00a - ww_1
    Ro_00 = -Ro_00a
    Ro_01 = ww_3 - dw_2
    Ro_01_right = ww_3 - Ro_01
    Ro_02 = dw_1 + ww_4
    Ro_02_right = Ro_02 - dw_1
    Ro_10 = dw_2 + ww_3
    Ro_10_right = Ro_10 - dw_2
    Ro_11a = ww_0 + ww_2
    Ro_11a_right = Ro_11a - ww_0
    Ro_11 = -Ro_11a
    Ro_12 = ww_5 - dw_0
    Ro_12_right = ww_5 - Ro_12
    Ro_20 = ww_4 - dw_1
    Ro_20_right = ww_4 - Ro_20
    Ro_21 = dw_0 + ww_5
    Ro_21_right = Ro_21 - dw_0
    Ro_22a = ww_0 + ww_1
    Ro_22a_right = Ro_22a - ww_0
    Ro_22 = -Ro_22a
    Ro_00_rounded = (Ro_00 +
        -(product_rest(w_1, w_1, ww_1, Ro_00a - Ro_00a_right)
        + product_rest(w_2, w_2, ww_2, Ro_00a_right)))
    Ro_01_rounded = (Ro_01
        + (product_rest(w_0, w_1, ww_3, Ro_01 + Ro_01_right) - (dw_2 - Ro_01_right)))
    Ro_02_rounded = (Ro_02
        + (dw_1 - (Ro_02 - Ro_02_right) + product_rest(w_0, w_2, ww_4, Ro_02_right)))
    Ro_10_rounded = (Ro_10
        + (dw_2 - (Ro_10 - Ro_10_right) + product_rest(w_0, w_1, ww_3, Ro_10_right)))
    Ro_11_rounded = (Ro_11 +
        -(product_rest(w_0, w_0, ww_0, Ro_11a - Ro_11a_right)
        + product_rest(w_2, w_2, ww_2, Ro_11a_right)))
    Ro_12_rounded = (Ro_12
        + (product_rest(w_1, w_2, ww_5, Ro_12 + Ro_12_right) - (dw_0 - Ro_12_right)))
    Ro_20_rounded = (Ro_20
        + (product_rest(w_0, w_2, ww_4, Ro_20 + Ro_20_right) - (dw_1 - Ro_20_right)))
    Ro_21_rounded = (Ro_21
        + (dw_0 - (Ro_21 - Ro_21_right) + product_rest(w_1, w_2, ww_5, Ro_21_right)))
    Ro_22_rounded = (Ro_22 +
        -(product_rest(w_0, w_0, ww_0, Ro_22a - Ro_22a_right)
        + product_rest(w_1, w_1, ww_1, Ro_22a_right)))
    return (Ro_00_rounded, Ro_01_rounded, Ro_02_rounded, Ro_10_rounded, Ro_11_rounded,
        Ro_12_rounded, Ro_20_rounded, Ro_21_rounded, Ro_22_rounded)


@kernel("(3,3)->()")
def mat3x3_determinant(R):
    """det R.

    (3,3)->().  R: rotation or other 3×3 matrix; det: number.
    12 mul, 26 add, 9 product rest.  Error <= u |result| + 28 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_0a = R_11 * R_22
    n_0b = R_12 * R_21
    n_0 = n_0a - n_0b
    n_0_right = n_0a - n_0
    n_1a = R_02 * R_21
    n_1b = R_01 * R_22
    n_1 = n_1a - n_1b
    n_1_right = n_1a - n_1
    n_2a = R_01 * R_12
    n_2b = R_02 * R_11
    n_2 = n_2a - n_2b
    n_2_right = n_2a - n_2
    det_a = R_00 * n_0
    det_b = R_10 * n_1
    det_c = det_a + det_b
    det_c_right = det_c - det_a
    det_a_cross2 = (R_00
        * (product_rest(R_11, R_22, n_0a, n_0 + n_0_right)
        - product_rest(R_12, R_21, n_0b, n_0_right)))
    det_c_cross = (det_a_cross2 + R_10
        * (product_rest(R_02, R_21, n_1a, n_1 + n_1_right)
        - product_rest(R_01, R_22, n_1b, n_1_right)))
    det_d = R_20 * n_2
    det = det_c + det_d
    det_right = det - det_c
    det_d_cross2 = (R_20
        * (product_rest(R_01, R_12, n_2a, n_2 + n_2_right)
        - product_rest(R_02, R_11, n_2b, n_2_right)))
    det_c_lo = (product_rest(R_00, n_0, det_a, det_c - det_c_right)
        + product_rest(R_10, n_1, det_b, det_c_right) + det_c_cross)
    det_rounded = (det
        + (det_c - (det - det_right) + product_rest(R_20, n_2, det_d, det_right) + det_d_cross2
        + det_c_lo))
    return det_rounded


@kernel("(3,3)->(),(3,3)")
def mat3x3_inverse(R):
    """Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or
    overflows.  Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3
    (double 1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.

    (3,3)->(),(3,3).  R, Ro: rotation or other 3×3 matrix; det: number.
    106 mul, 290 add, 10 product error, 32 product rest, 22 div, 2 neg, 19 abs, 17 less, 11
    equal, 55 select.  Error of Ro_ij <= 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the
    sum of the |terms| of the cofactor, or 2^-80 m^2 (double 2^-700 m^2) if that is more;
    barring over- and underflow of Ro_ij itself.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    R_size_0 = absolute(R_00)
    R_size_1 = absolute(R_01)
    R_size_2 = absolute(R_02)
    R_size_3 = absolute(R_10)
    R_size_4 = absolute(R_11)
    R_size_5 = absolute(R_12)
    R_size_6 = absolute(R_20)
    R_size_7 = absolute(R_21)
    R_size_8 = absolute(R_22)
    R_largest1 = where(R_size_0 < R_size_1, R_size_1, R_size_0)
    R_largest2 = where(R_largest1 < R_size_2, R_size_2, R_largest1)
    R_largest3 = where(R_largest2 < R_size_3, R_size_3, R_largest2)
    R_largest4 = where(R_largest3 < R_size_4, R_size_4, R_largest3)
    R_largest5 = where(R_largest4 < R_size_5, R_size_5, R_largest4)
    R_largest6 = where(R_largest5 < R_size_6, R_size_6, R_largest5)
    R_largest7 = where(R_largest6 < R_size_7, R_size_7, R_largest6)
    R_largest8 = where(R_largest7 < R_size_8, R_size_8, R_largest7)
    s_c = R_largest8 < 4.149515568880993e+180
    s_e = R_largest8 < 2.037035976334486e+90
    s_d = where(s_c, 4.909093465297727e-91, where(R_largest8 < 8.452712498170644e+270,
        real(2.409919865102884e-181), real(1.1830521861667747e-271)))
    s_g = R_largest8 < 1
    s_i = R_largest8 < 4.909093465297727e-91
    s_k = R_largest8 < 2.409919865102884e-181
    s = where(s_k, 8.452712498170644e+270, where(s_i, 4.149515568880993e+180, where(s_g,
        2.037035976334486e+90, where(s_e, 1, s_d))))
    A_0 = R_00 * s
    A_1 = R_01 * s
    A_2 = R_02 * s
    A_3 = R_10 * s
    A_4 = R_11 * s
    A_5 = R_12 * s
    A_6 = R_20 * s
    A_7 = R_21 * s
    A_8 = R_22 * s
    n0_0a = A_4 * A_8
    n0_0b = A_5 * A_7
    n0_0 = n0_0a - n0_0b
    n0_0_right = n0_0a - n0_0
    n0_0_lo = (product_rest(A_4, A_8, n0_0a, n0_0 + n0_0_right)
        - product_rest(A_5, A_7, n0_0b, n0_0_right))
    n0_1a = A_2 * A_7
    n0_1b = A_1 * A_8
    n0_1 = n0_1a - n0_1b
    n0_1_right = n0_1a - n0_1
    n0_1_lo = (product_rest(A_2, A_7, n0_1a, n0_1 + n0_1_right)
        - product_rest(A_1, A_8, n0_1b, n0_1_right))
    n0_2a = A_1 * A_5
    n0_2b = A_2 * A_4
    n0_2 = n0_2a - n0_2b
    n0_2_right = n0_2a - n0_2
    n0_2_lo = (product_rest(A_1, A_5, n0_2a, n0_2 + n0_2_right)
        - product_rest(A_2, A_4, n0_2b, n0_2_right))
    n1_0a = A_5 * A_6
    n1_0b = A_3 * A_8
    n1_0 = n1_0a - n1_0b
    n1_0_right = n1_0a - n1_0
    n1_0_lo = (product_rest(A_5, A_6, n1_0a, n1_0 + n1_0_right)
        - product_rest(A_3, A_8, n1_0b, n1_0_right))
    n1_1a = A_0 * A_8
    n1_1b = A_2 * A_6
    n1_1 = n1_1a - n1_1b
    n1_1_right = n1_1a - n1_1
    n1_1_lo = (product_rest(A_0, A_8, n1_1a, n1_1 + n1_1_right)
        - product_rest(A_2, A_6, n1_1b, n1_1_right))
    n1_2a = A_2 * A_3
    n1_2b = A_0 * A_5
    n1_2 = n1_2a - n1_2b
    n1_2_right = n1_2a - n1_2
    n1_2_lo = (product_rest(A_2, A_3, n1_2a, n1_2 + n1_2_right)
        - product_rest(A_0, A_5, n1_2b, n1_2_right))
    n2_0a = A_3 * A_7
    n2_0b = A_4 * A_6
    n2_0 = n2_0a - n2_0b
    n2_0_right = n2_0a - n2_0
    n2_0_lo = (product_rest(A_3, A_7, n2_0a, n2_0 + n2_0_right)
        - product_rest(A_4, A_6, n2_0b, n2_0_right))
    n2_1a = A_1 * A_6
    n2_1b = A_0 * A_7
    n2_1 = n2_1a - n2_1b
    n2_1_right = n2_1a - n2_1
    n2_1_lo = (product_rest(A_1, A_6, n2_1a, n2_1 + n2_1_right)
        - product_rest(A_0, A_7, n2_1b, n2_1_right))
    n2_2a = A_0 * A_4
    n2_2b = A_1 * A_3
    n2_2 = n2_2a - n2_2b
    n2_2_right = n2_2a - n2_2
    n2_2_lo = (product_rest(A_0, A_4, n2_2a, n2_2 + n2_2_right)
        - product_rest(A_1, A_3, n2_2b, n2_2_right))
    d_a = A_0 * n0_0
    d_b = A_3 * n0_1
    d_c = d_a + d_b
    d_c_right = d_c - d_a
    d_d = A_6 * n0_2
    d = d_c + d_d
    d_right = d - d_c
    d_c_lo = (product_rest(A_0, n0_0, d_a, d_c - d_c_right)
        + product_rest(A_3, n0_1, d_b, d_c_right) + (A_0 * n0_0_lo + A_3 * n0_1_lo))
    d_lo = d_c - (d - d_right) + product_rest(A_6, n0_2, d_d, d_right) + A_6 * n0_2_lo + d_c_lo
    size0_0 = absolute(A_0)
    size0_1 = absolute(A_3)
    size0_2 = absolute(A_6)
    size1_0 = absolute(A_1)
    size1_1 = absolute(A_4)
    size1_2 = absolute(A_7)
    size2_0 = absolute(A_2)
    size2_1 = absolute(A_5)
    size2_2 = absolute(A_8)
    permanent_a = size1_1 * size2_2
    permanent_b = size1_2 * size2_1
    permanent_c = permanent_a + permanent_b
    permanent_c_right = permanent_c - permanent_a
    permanent_c_left_rest = product_rest(size1_1, size2_2, permanent_a,
        permanent_c - permanent_c_right)
    permanent_d = size0_0 * permanent_c
    permanent_e = size1_0 * size2_2
    permanent_f = size1_2 * size2_0
    permanent_g = permanent_e + permanent_f
    permanent_g_right = permanent_g - permanent_e
    permanent_g_left_rest = product_rest(size1_0, size2_2, permanent_e,
        permanent_g - permanent_g_right)
    permanent_h = size0_1 * permanent_g
    permanent_i = permanent_d + permanent_h
    permanent_i_right = permanent_i - permanent_d
    permanent_d_cross2 = (size0_0
        * (permanent_c_left_rest + product_rest(size1_2, size2_1, permanent_b, permanent_c_right)))
    permanent_i_left_rest = product_rest(size0_0, permanent_c, permanent_d,
        permanent_i - permanent_i_right)
    permanent_i_cross = (permanent_d_cross2 + size0_1
        * (permanent_g_left_rest + product_rest(size1_2, size2_0, permanent_f, permanent_g_right)))
    permanent_j = size1_0 * size2_1
    permanent_k = size1_1 * size2_0
    permanent_l = permanent_j + permanent_k
    permanent_l_right = permanent_l - permanent_j
    permanent_l_left_rest = product_rest(size1_0, size2_1, permanent_j,
        permanent_l - permanent_l_right)
    permanent_m = size0_2 * permanent_l
    permanent = permanent_i + permanent_m
    permanent_right = permanent - permanent_i
    permanent_lo1 = (permanent_i - (permanent - permanent_right)
        + product_rest(size0_2, permanent_l, permanent_m, permanent_right))
    permanent_lo2 = (permanent_lo1 + size0_2
        * (permanent_l_left_rest + product_rest(size1_1, size2_0, permanent_k, permanent_l_right)))
    top = R_largest8 * s
    spoiled = top * 1.6489340850168661e-229
    least_a = permanent * 8.881784197001252e-16
    permanent_lo = (permanent_lo2
        + (permanent_i_left_rest
        + product_rest(size0_1, permanent_g, permanent_h, permanent_i_right) + permanent_i_cross))
    least_b = top * top
    least_c = spoiled * least_b
    least = least_a + least_c
    least_right = least - least_a
    least_lo1 = (product_rest(permanent, 8.881784197001252e-16, least_a, least - least_right)
        + product_rest(spoiled, least_b, least_c, least_right))
    d_sum = d + d_lo
    d_sum_right = d_sum - d
    d_sum_lo = d - (d_sum - d_sum_right) + (d_lo - d_sum_right)
    least_sum = (least
        + (least_lo1
        + (permanent_lo * 8.881784197001252e-16 + spoiled * product_error(top, top, least_b))))
    regular = where(least_sum < absolute(d_sum) + where(d_sum < 0, -d_sum_lo, d_sum_lo), real(1),
        real(0))
    divisor_a = regular == 1
    divisor = where(divisor_a, d_sum, 1)
    divisor_lo = where(divisor_a, d_sum_lo, 0)
    n0_0_sum = n0_0 + n0_0_lo
    n0_0_sum_right = n0_0_sum - n0_0
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    quotient_0 = n0_0_sum / divisor_sum
    quotient_0_product = quotient_0 * divisor_sum
    quotient_0_exact = (n0_0_sum - quotient_0_product
        - product_error(quotient_0, divisor_sum, quotient_0_product))
    quotient_0_lo = ((quotient_0_exact
        + (n0_0 - (n0_0_sum - n0_0_sum_right) + (n0_0_lo - n0_0_sum_right)) - quotient_0
        * divisor_sum_lo) / divisor_sum)
    n0_1_sum = n0_1 + n0_1_lo
    n0_1_sum_right = n0_1_sum - n0_1
    quotient_1 = n0_1_sum / divisor_sum
    quotient_1_product = quotient_1 * divisor_sum
    quotient_1_exact = (n0_1_sum - quotient_1_product
        - product_error(quotient_1, divisor_sum, quotient_1_product))
    quotient_1_lo = ((quotient_1_exact
        + (n0_1 - (n0_1_sum - n0_1_sum_right) + (n0_1_lo - n0_1_sum_right)) - quotient_1
        * divisor_sum_lo) / divisor_sum)
    n0_2_sum = n0_2 + n0_2_lo
    n0_2_sum_right = n0_2_sum - n0_2
    quotient_2 = n0_2_sum / divisor_sum
    quotient_2_product = quotient_2 * divisor_sum
    quotient_2_exact = (n0_2_sum - quotient_2_product
        - product_error(quotient_2, divisor_sum, quotient_2_product))
    quotient_2_lo = ((quotient_2_exact
        + (n0_2 - (n0_2_sum - n0_2_sum_right) + (n0_2_lo - n0_2_sum_right)) - quotient_2
        * divisor_sum_lo) / divisor_sum)
    n1_0_sum = n1_0 + n1_0_lo
    n1_0_sum_right = n1_0_sum - n1_0
    quotient_3 = n1_0_sum / divisor_sum
    quotient_3_product = quotient_3 * divisor_sum
    quotient_3_exact = (n1_0_sum - quotient_3_product
        - product_error(quotient_3, divisor_sum, quotient_3_product))
    quotient_3_lo = ((quotient_3_exact
        + (n1_0 - (n1_0_sum - n1_0_sum_right) + (n1_0_lo - n1_0_sum_right)) - quotient_3
        * divisor_sum_lo) / divisor_sum)
    n1_1_sum = n1_1 + n1_1_lo
    n1_1_sum_right = n1_1_sum - n1_1
    quotient_4 = n1_1_sum / divisor_sum
    quotient_4_product = quotient_4 * divisor_sum
    quotient_4_exact = (n1_1_sum - quotient_4_product
        - product_error(quotient_4, divisor_sum, quotient_4_product))
    quotient_4_lo = ((quotient_4_exact
        + (n1_1 - (n1_1_sum - n1_1_sum_right) + (n1_1_lo - n1_1_sum_right)) - quotient_4
        * divisor_sum_lo) / divisor_sum)
    n1_2_sum = n1_2 + n1_2_lo
    n1_2_sum_right = n1_2_sum - n1_2
    quotient_5 = n1_2_sum / divisor_sum
    quotient_5_product = quotient_5 * divisor_sum
    quotient_5_exact = (n1_2_sum - quotient_5_product
        - product_error(quotient_5, divisor_sum, quotient_5_product))
    quotient_5_lo = ((quotient_5_exact
        + (n1_2 - (n1_2_sum - n1_2_sum_right) + (n1_2_lo - n1_2_sum_right)) - quotient_5
        * divisor_sum_lo) / divisor_sum)
    n2_0_sum = n2_0 + n2_0_lo
    n2_0_sum_right = n2_0_sum - n2_0
    quotient_6 = n2_0_sum / divisor_sum
    quotient_6_product = quotient_6 * divisor_sum
    quotient_6_exact = (n2_0_sum - quotient_6_product
        - product_error(quotient_6, divisor_sum, quotient_6_product))
    quotient_6_lo = ((quotient_6_exact
        + (n2_0 - (n2_0_sum - n2_0_sum_right) + (n2_0_lo - n2_0_sum_right)) - quotient_6
        * divisor_sum_lo) / divisor_sum)
    n2_1_sum = n2_1 + n2_1_lo
    n2_1_sum_right = n2_1_sum - n2_1
    quotient_7 = n2_1_sum / divisor_sum
    quotient_7_product = quotient_7 * divisor_sum
    quotient_7_exact = (n2_1_sum - quotient_7_product
        - product_error(quotient_7, divisor_sum, quotient_7_product))
    quotient_7_lo = ((quotient_7_exact
        + (n2_1 - (n2_1_sum - n2_1_sum_right) + (n2_1_lo - n2_1_sum_right)) - quotient_7
        * divisor_sum_lo) / divisor_sum)
    n2_2_sum = n2_2 + n2_2_lo
    n2_2_sum_right = n2_2_sum - n2_2
    quotient_8 = n2_2_sum / divisor_sum
    quotient_8_product = quotient_8 * divisor_sum
    quotient_8_exact = (n2_2_sum - quotient_8_product
        - product_error(quotient_8, divisor_sum, quotient_8_product))
    quotient_8_lo = ((quotient_8_exact
        + (n2_2 - (n2_2_sum - n2_2_sum_right) + (n2_2_lo - n2_2_sum_right)) - quotient_8
        * divisor_sum_lo) / divisor_sum)
    quotient_0_sum = quotient_0 + quotient_0_lo
    quotient_0_sum_right = quotient_0_sum - quotient_0
    inverse_0 = quotient_0_sum * s
    inverse_0_inverse = 1 / s
    quotient_0_sum_lo = (quotient_0 - (quotient_0_sum - quotient_0_sum_right)
        + (quotient_0_lo - quotient_0_sum_right))
    quotient_1_sum = quotient_1 + quotient_1_lo
    quotient_1_sum_right = quotient_1_sum - quotient_1
    inverse_1 = quotient_1_sum * s
    quotient_1_sum_lo = (quotient_1 - (quotient_1_sum - quotient_1_sum_right)
        + (quotient_1_lo - quotient_1_sum_right))
    quotient_2_sum = quotient_2 + quotient_2_lo
    quotient_2_sum_right = quotient_2_sum - quotient_2
    inverse_2 = quotient_2_sum * s
    quotient_2_sum_lo = (quotient_2 - (quotient_2_sum - quotient_2_sum_right)
        + (quotient_2_lo - quotient_2_sum_right))
    quotient_3_sum = quotient_3 + quotient_3_lo
    quotient_3_sum_right = quotient_3_sum - quotient_3
    inverse_3 = quotient_3_sum * s
    quotient_3_sum_lo = (quotient_3 - (quotient_3_sum - quotient_3_sum_right)
        + (quotient_3_lo - quotient_3_sum_right))
    quotient_4_sum = quotient_4 + quotient_4_lo
    quotient_4_sum_right = quotient_4_sum - quotient_4
    inverse_4 = quotient_4_sum * s
    quotient_4_sum_lo = (quotient_4 - (quotient_4_sum - quotient_4_sum_right)
        + (quotient_4_lo - quotient_4_sum_right))
    quotient_5_sum = quotient_5 + quotient_5_lo
    quotient_5_sum_right = quotient_5_sum - quotient_5
    inverse_5 = quotient_5_sum * s
    quotient_5_sum_lo = (quotient_5 - (quotient_5_sum - quotient_5_sum_right)
        + (quotient_5_lo - quotient_5_sum_right))
    quotient_6_sum = quotient_6 + quotient_6_lo
    quotient_6_sum_right = quotient_6_sum - quotient_6
    inverse_6 = quotient_6_sum * s
    quotient_6_sum_lo = (quotient_6 - (quotient_6_sum - quotient_6_sum_right)
        + (quotient_6_lo - quotient_6_sum_right))
    quotient_7_sum = quotient_7 + quotient_7_lo
    quotient_7_sum_right = quotient_7_sum - quotient_7
    inverse_7 = quotient_7_sum * s
    quotient_7_sum_lo = (quotient_7 - (quotient_7_sum - quotient_7_sum_right)
        + (quotient_7_lo - quotient_7_sum_right))
    quotient_8_sum = quotient_8 + quotient_8_lo
    quotient_8_sum_right = quotient_8_sum - quotient_8
    inverse_8 = quotient_8_sum * s
    quotient_8_sum_lo = (quotient_8 - (quotient_8_sum - quotient_8_sum_right)
        + (quotient_8_lo - quotient_8_sum_right))
    start = where(s_c, d_sum, where(d_sum < 0, -8.452712498170644e+270, 8.452712498170644e+270))
    start_lo = where(s_c, d_sum_lo, 0)
    r2 = where(s_i, real(1.1830521861667747e-271), real(1))
    start_sum = start + start_lo
    start_sum_right = start_sum - start
    once = start_sum * r2
    once_lo = ((start_sum - once * (1 / r2)
        + (start - (start_sum - start_sum_right) + (start_lo - start_sum_right))) * r2)
    r3 = where(s_k, real(1.1830521861667747e-271), real(1))
    once_sum = once + once_lo
    once_sum_right = once_sum - once
    twice = once_sum * r3
    twice_lo = ((once_sum - twice * (1 / r3)
        + (once - (once_sum - once_sum_right) + (once_lo - once_sum_right))) * r3)
    r = where(s_g, 1.1830521861667747e-271, where(s_e, real(1), real(8.452712498170644e+270)))
    twice_sum = twice + twice_lo
    twice_sum_right = twice_sum - twice
    det_R = twice_sum * r
    det = where(divisor_a, det_R, 0)
    Ro_00 = where(divisor_a, inverse_0, nan)
    Ro_01 = where(divisor_a, inverse_1, nan)
    Ro_02 = where(divisor_a, inverse_2, nan)
    Ro_10 = where(divisor_a, inverse_3, nan)
    Ro_11 = where(divisor_a, inverse_4, nan)
    Ro_12 = where(divisor_a, inverse_5, nan)
    Ro_20 = where(divisor_a, inverse_6, nan)
    Ro_21 = where(divisor_a, inverse_7, nan)
    Ro_22 = where(divisor_a, inverse_8, nan)
    det_rounded = (det
        + where(divisor_a, (twice_sum - det_R * (1 / r)
        + (twice - (twice_sum - twice_sum_right) + (twice_lo - twice_sum_right))) * r, 0))
    Ro_00_rounded = (Ro_00
        + where(divisor_a, (quotient_0_sum - inverse_0 * inverse_0_inverse + quotient_0_sum_lo)
        * s, 0))
    Ro_01_rounded = (Ro_01
        + where(divisor_a, (quotient_1_sum - inverse_1 * inverse_0_inverse + quotient_1_sum_lo)
        * s, 0))
    Ro_02_rounded = (Ro_02
        + where(divisor_a, (quotient_2_sum - inverse_2 * inverse_0_inverse + quotient_2_sum_lo)
        * s, 0))
    Ro_10_rounded = (Ro_10
        + where(divisor_a, (quotient_3_sum - inverse_3 * inverse_0_inverse + quotient_3_sum_lo)
        * s, 0))
    Ro_11_rounded = (Ro_11
        + where(divisor_a, (quotient_4_sum - inverse_4 * inverse_0_inverse + quotient_4_sum_lo)
        * s, 0))
    Ro_12_rounded = (Ro_12
        + where(divisor_a, (quotient_5_sum - inverse_5 * inverse_0_inverse + quotient_5_sum_lo)
        * s, 0))
    Ro_20_rounded = (Ro_20
        + where(divisor_a, (quotient_6_sum - inverse_6 * inverse_0_inverse + quotient_6_sum_lo)
        * s, 0))
    Ro_21_rounded = (Ro_21
        + where(divisor_a, (quotient_7_sum - inverse_7 * inverse_0_inverse + quotient_7_sum_lo)
        * s, 0))
    Ro_22_rounded = (Ro_22
        + where(divisor_a, (quotient_8_sum - inverse_8 * inverse_0_inverse + quotient_8_sum_lo)
        * s, 0))
    det_final = where(det_rounded == det_rounded, det_rounded, det)
    Ro_00_final = where(Ro_00_rounded == Ro_00_rounded, Ro_00_rounded, Ro_00)
    Ro_01_final = where(Ro_01_rounded == Ro_01_rounded, Ro_01_rounded, Ro_01)
    Ro_02_final = where(Ro_02_rounded == Ro_02_rounded, Ro_02_rounded, Ro_02)
    Ro_10_final = where(Ro_10_rounded == Ro_10_rounded, Ro_10_rounded, Ro_10)
    Ro_11_final = where(Ro_11_rounded == Ro_11_rounded, Ro_11_rounded, Ro_11)
    Ro_12_final = where(Ro_12_rounded == Ro_12_rounded, Ro_12_rounded, Ro_12)
    Ro_20_final = where(Ro_20_rounded == Ro_20_rounded, Ro_20_rounded, Ro_20)
    Ro_21_final = where(Ro_21_rounded == Ro_21_rounded, Ro_21_rounded, Ro_21)
    Ro_22_final = where(Ro_22_rounded == Ro_22_rounded, Ro_22_rounded, Ro_22)
    return (det_final, Ro_00_final, Ro_01_final, Ro_02_final, Ro_10_final, Ro_11_final, Ro_12_final,
        Ro_20_final, Ro_21_final, Ro_22_final)


@kernel("(3,3)->(3,3)")
def mat3x3_normalize(self):
    """self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
    its side of the first, the third on its side of both; NaN where the rows are linearly
    dependent to rounding.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    154 mul, 405 add, 16 product error, 33 product rest, 31 div, 4 sqrt, 7 neg, 10 abs, 25 less,
    18 equal, 70 select.  |R R^T - I|_ij <= 8 u for the result R; searched, not proved.
    """
    self_00, self_01, self_02, self_10, self_11, self_12, self_20, self_21, self_22 = self
    q0_s_size_0 = absolute(self_00)
    q0_s_size_1 = absolute(self_01)
    q0_s_size_2 = absolute(self_02)
    q0_s_largest1 = where(q0_s_size_0 < q0_s_size_1, q0_s_size_1, q0_s_size_0)
    q0_s_largest2 = where(q0_s_largest1 < q0_s_size_2, q0_s_size_2, q0_s_largest1)
    q0_s_d = where(q0_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < q0_s_largest2, real(3.7291703656001034e-155), real(1)))
    q0_s = where(q0_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, q0_s_d)
    q0_y_0 = self_00 * q0_s
    q0_y_1 = self_01 * q0_s
    q0_y_2 = self_02 * q0_s
    q0_up = where(1 < q0_s, q0_s, 1)
    q0_down = where(q0_s < 1, q0_s, 1)
    q0_n_a = q0_y_0 * q0_y_0
    q0_n_b = q0_y_1 * q0_y_1
    q0_n_c = q0_n_a + q0_n_b
    q0_n_c_right = q0_n_c - q0_n_a
    q0_n_d = q0_y_2 * q0_y_2
    q0_n_e = q0_n_c + q0_n_d
    q0_n_e_right = q0_n_e - q0_n_c
    q0_n_c_lo = (product_rest(q0_y_0, q0_y_0, q0_n_a, q0_n_c - q0_n_c_right)
        + product_rest(q0_y_1, q0_y_1, q0_n_b, q0_n_c_right))
    q0_n_e_lo = (q0_n_c - (q0_n_e - q0_n_e_right)
        + product_rest(q0_y_2, q0_y_2, q0_n_d, q0_n_e_right) + q0_n_c_lo)
    q0_n_e_sum = q0_n_e + q0_n_e_lo
    q0_n_e_sum_right = q0_n_e_sum - q0_n_e
    q0_n = sqrt(q0_n_e_sum)
    q0_n_product = q0_n * q0_n
    q0_n_e_sum_lo = q0_n_e - (q0_n_e_sum - q0_n_e_sum_right) + (q0_n_e_lo - q0_n_e_sum_right)
    q0_n_lo = ((q0_n_e_sum - q0_n_product - product_error(q0_n, q0_n, q0_n_product)
        + q0_n_e_sum_lo) / where(q0_n == 0, 1, q0_n + q0_n))
    q0_n_sum = q0_n + q0_n_lo
    q0_n_sum_right = q0_n_sum - q0_n
    q0_divisor_a = q0_n_sum == 0
    q0_divisor = where(q0_divisor_a, q0_up, q0_n_sum)
    q0_divisor_lo = where(q0_divisor_a, 0,
        q0_n - (q0_n_sum - q0_n_sum_right) + (q0_n_lo - q0_n_sum_right))
    q0_sized_0 = self_00 * q0_up
    q0_sized_1 = self_01 * q0_up
    q0_sized_2 = self_02 * q0_up
    q0_divisor_sum = q0_divisor + q0_divisor_lo
    q0_divisor_sum_right = q0_divisor_sum - q0_divisor
    q0_divisor_sum_lo = (q0_divisor - (q0_divisor_sum - q0_divisor_sum_right)
        + (q0_divisor_lo - q0_divisor_sum_right))
    q0_quotient_0 = q0_sized_0 / q0_divisor_sum
    q0_quotient_0_product = q0_quotient_0 * q0_divisor_sum
    q0_quotient_0_exact = (q0_sized_0 - q0_quotient_0_product
        - product_error(q0_quotient_0, q0_divisor_sum, q0_quotient_0_product))
    q0_quotient_0_lo = (q0_quotient_0_exact - q0_quotient_0 * q0_divisor_sum_lo) / q0_divisor_sum
    q0_quotient_1 = q0_sized_1 / q0_divisor_sum
    q0_quotient_1_product = q0_quotient_1 * q0_divisor_sum
    q0_quotient_1_exact = (q0_sized_1 - q0_quotient_1_product
        - product_error(q0_quotient_1, q0_divisor_sum, q0_quotient_1_product))
    q0_quotient_1_lo = (q0_quotient_1_exact - q0_quotient_1 * q0_divisor_sum_lo) / q0_divisor_sum
    q0_quotient_2 = q0_sized_2 / q0_divisor_sum
    q0_quotient_2_product = q0_quotient_2 * q0_divisor_sum
    q0_quotient_2_exact = (q0_sized_2 - q0_quotient_2_product
        - product_error(q0_quotient_2, q0_divisor_sum, q0_quotient_2_product))
    q0_quotient_2_lo = (q0_quotient_2_exact - q0_quotient_2 * q0_divisor_sum_lo) / q0_divisor_sum
    q0_quotient_0_sum = q0_quotient_0 + q0_quotient_0_lo
    q0_quotient_0_sum_right = q0_quotient_0_sum - q0_quotient_0
    q0_0 = q0_quotient_0_sum * q0_down
    q0_0_inverse = 1 / q0_down
    q0_quotient_0_sum_lo = (q0_quotient_0 - (q0_quotient_0_sum - q0_quotient_0_sum_right)
        + (q0_quotient_0_lo - q0_quotient_0_sum_right))
    q0_0_lo = (q0_quotient_0_sum - q0_0 * q0_0_inverse + q0_quotient_0_sum_lo) * q0_down
    q0_quotient_1_sum = q0_quotient_1 + q0_quotient_1_lo
    q0_quotient_1_sum_right = q0_quotient_1_sum - q0_quotient_1
    q0_1 = q0_quotient_1_sum * q0_down
    q0_quotient_1_sum_lo = (q0_quotient_1 - (q0_quotient_1_sum - q0_quotient_1_sum_right)
        + (q0_quotient_1_lo - q0_quotient_1_sum_right))
    q0_1_lo = (q0_quotient_1_sum - q0_1 * q0_0_inverse + q0_quotient_1_sum_lo) * q0_down
    q0_quotient_2_sum = q0_quotient_2 + q0_quotient_2_lo
    q0_quotient_2_sum_right = q0_quotient_2_sum - q0_quotient_2
    q0_2 = q0_quotient_2_sum * q0_down
    q0_quotient_2_sum_lo = (q0_quotient_2 - (q0_quotient_2_sum - q0_quotient_2_sum_right)
        + (q0_quotient_2_lo - q0_quotient_2_sum_right))
    q0_2_lo = (q0_quotient_2_sum - q0_2 * q0_0_inverse + q0_quotient_2_sum_lo) * q0_down
    u1_s_size_0 = absolute(self_10)
    u1_s_size_1 = absolute(self_11)
    u1_s_size_2 = absolute(self_12)
    u1_s_largest1 = where(u1_s_size_0 < u1_s_size_1, u1_s_size_1, u1_s_size_0)
    u1_s_largest2 = where(u1_s_largest1 < u1_s_size_2, u1_s_size_2, u1_s_largest1)
    u1_s_d = where(u1_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < u1_s_largest2, real(3.7291703656001034e-155), real(1)))
    u1_s = where(u1_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, u1_s_d)
    u1_y_0 = self_10 * u1_s
    u1_y_1 = self_11 * u1_s
    u1_y_2 = self_12 * u1_s
    u1_up = where(1 < u1_s, u1_s, 1)
    u1_down = where(u1_s < 1, u1_s, 1)
    u1_n_a = u1_y_0 * u1_y_0
    u1_n_b = u1_y_1 * u1_y_1
    u1_n_c = u1_n_a + u1_n_b
    u1_n_c_right = u1_n_c - u1_n_a
    u1_n_d = u1_y_2 * u1_y_2
    u1_n_e = u1_n_c + u1_n_d
    u1_n_e_right = u1_n_e - u1_n_c
    u1_n_c_lo = (product_rest(u1_y_0, u1_y_0, u1_n_a, u1_n_c - u1_n_c_right)
        + product_rest(u1_y_1, u1_y_1, u1_n_b, u1_n_c_right))
    u1_n_e_lo = (u1_n_c - (u1_n_e - u1_n_e_right)
        + product_rest(u1_y_2, u1_y_2, u1_n_d, u1_n_e_right) + u1_n_c_lo)
    u1_n_e_sum = u1_n_e + u1_n_e_lo
    u1_n_e_sum_right = u1_n_e_sum - u1_n_e
    u1_n = sqrt(u1_n_e_sum)
    u1_n_product = u1_n * u1_n
    u1_n_e_sum_lo = u1_n_e - (u1_n_e_sum - u1_n_e_sum_right) + (u1_n_e_lo - u1_n_e_sum_right)
    u1_n_lo = ((u1_n_e_sum - u1_n_product - product_error(u1_n, u1_n, u1_n_product)
        + u1_n_e_sum_lo) / where(u1_n == 0, 1, u1_n + u1_n))
    u1_n_sum = u1_n + u1_n_lo
    u1_n_sum_right = u1_n_sum - u1_n
    u1_divisor_a = u1_n_sum == 0
    u1_divisor = where(u1_divisor_a, u1_up, u1_n_sum)
    u1_divisor_lo = where(u1_divisor_a, 0,
        u1_n - (u1_n_sum - u1_n_sum_right) + (u1_n_lo - u1_n_sum_right))
    u1_sized_0 = self_10 * u1_up
    u1_sized_1 = self_11 * u1_up
    u1_sized_2 = self_12 * u1_up
    u1_divisor_sum = u1_divisor + u1_divisor_lo
    u1_divisor_sum_right = u1_divisor_sum - u1_divisor
    u1_divisor_sum_lo = (u1_divisor - (u1_divisor_sum - u1_divisor_sum_right)
        + (u1_divisor_lo - u1_divisor_sum_right))
    u1_quotient_0 = u1_sized_0 / u1_divisor_sum
    u1_quotient_0_product = u1_quotient_0 * u1_divisor_sum
    u1_quotient_0_exact = (u1_sized_0 - u1_quotient_0_product
        - product_error(u1_quotient_0, u1_divisor_sum, u1_quotient_0_product))
    u1_quotient_0_lo = (u1_quotient_0_exact - u1_quotient_0 * u1_divisor_sum_lo) / u1_divisor_sum
    u1_quotient_1 = u1_sized_1 / u1_divisor_sum
    u1_quotient_1_product = u1_quotient_1 * u1_divisor_sum
    u1_quotient_1_exact = (u1_sized_1 - u1_quotient_1_product
        - product_error(u1_quotient_1, u1_divisor_sum, u1_quotient_1_product))
    u1_quotient_1_lo = (u1_quotient_1_exact - u1_quotient_1 * u1_divisor_sum_lo) / u1_divisor_sum
    u1_quotient_2 = u1_sized_2 / u1_divisor_sum
    u1_quotient_2_product = u1_quotient_2 * u1_divisor_sum
    u1_quotient_2_exact = (u1_sized_2 - u1_quotient_2_product
        - product_error(u1_quotient_2, u1_divisor_sum, u1_quotient_2_product))
    u1_quotient_2_lo = (u1_quotient_2_exact - u1_quotient_2 * u1_divisor_sum_lo) / u1_divisor_sum
    u1_quotient_0_sum = u1_quotient_0 + u1_quotient_0_lo
    u1_quotient_0_sum_right = u1_quotient_0_sum - u1_quotient_0
    u1_0 = u1_quotient_0_sum * u1_down
    u1_0_inverse = 1 / u1_down
    u1_quotient_0_sum_lo = (u1_quotient_0 - (u1_quotient_0_sum - u1_quotient_0_sum_right)
        + (u1_quotient_0_lo - u1_quotient_0_sum_right))
    u1_0_lo = (u1_quotient_0_sum - u1_0 * u1_0_inverse + u1_quotient_0_sum_lo) * u1_down
    u1_quotient_1_sum = u1_quotient_1 + u1_quotient_1_lo
    u1_quotient_1_sum_right = u1_quotient_1_sum - u1_quotient_1
    u1_1 = u1_quotient_1_sum * u1_down
    u1_quotient_1_sum_lo = (u1_quotient_1 - (u1_quotient_1_sum - u1_quotient_1_sum_right)
        + (u1_quotient_1_lo - u1_quotient_1_sum_right))
    u1_1_lo = (u1_quotient_1_sum - u1_1 * u1_0_inverse + u1_quotient_1_sum_lo) * u1_down
    u1_quotient_2_sum = u1_quotient_2 + u1_quotient_2_lo
    u1_quotient_2_sum_right = u1_quotient_2_sum - u1_quotient_2
    u1_2 = u1_quotient_2_sum * u1_down
    u1_quotient_2_sum_lo = (u1_quotient_2 - (u1_quotient_2_sum - u1_quotient_2_sum_right)
        + (u1_quotient_2_lo - u1_quotient_2_sum_right))
    u1_2_lo = (u1_quotient_2_sum - u1_2 * u1_0_inverse + u1_quotient_2_sum_lo) * u1_down
    along_a = q0_0 * u1_0
    along_b = q0_1 * u1_1
    along_c = along_a + along_b
    along_c_right = along_c - along_a
    along_c_lo1 = (product_rest(q0_0, u1_0, along_a, along_c - along_c_right)
        + product_rest(q0_1, u1_1, along_b, along_c_right))
    along_d = q0_2 * u1_2
    along = along_c + along_d
    along_right = along - along_c
    along_lo2 = (along_c - (along - along_right) + product_rest(q0_2, u1_2, along_d, along_right)
        + (q0_2_lo * u1_2 + q0_2 * u1_2_lo))
    along_lo = (along_lo2
        + (along_c_lo1 + (q0_0_lo * u1_0 + q0_0 * u1_0_lo + (q0_1_lo * u1_1 + q0_1 * u1_1_lo))))
    once_0a = q0_0 * along
    once_0 = u1_0 - once_0a
    once_0_right = u1_0 - once_0
    once_0_lo = (u1_0 - (once_0 + once_0_right) - product_rest(q0_0, along, once_0a, once_0_right)
        - (q0_0_lo * along + q0_0 * along_lo) + u1_0_lo)
    once_1a = q0_1 * along
    once_1 = u1_1 - once_1a
    once_1_right = u1_1 - once_1
    once_1_lo = (u1_1 - (once_1 + once_1_right) - product_rest(q0_1, along, once_1a, once_1_right)
        - (q0_1_lo * along + q0_1 * along_lo) + u1_1_lo)
    once_2a = q0_2 * along
    once_2 = u1_2 - once_2a
    once_2_right = u1_2 - once_2
    once_2_lo = (u1_2 - (once_2 + once_2_right) - product_rest(q0_2, along, once_2a, once_2_right)
        - (q0_2_lo * along + q0_2 * along_lo) + u1_2_lo)
    rest_a = q0_0 * once_0
    rest_b = q0_1 * once_1
    rest_c = rest_a + rest_b
    rest_c_right = rest_c - rest_a
    rest_c_lo1 = (product_rest(q0_0, once_0, rest_a, rest_c - rest_c_right)
        + product_rest(q0_1, once_1, rest_b, rest_c_right))
    rest_d = q0_2 * once_2
    rest = rest_c + rest_d
    rest_right = rest - rest_c
    rest_lo2 = (rest_c - (rest - rest_right) + product_rest(q0_2, once_2, rest_d, rest_right)
        + (q0_2_lo * once_2 + q0_2 * once_2_lo))
    rest_lo = (rest_lo2
        + (rest_c_lo1
        + (q0_0_lo * once_0 + q0_0 * once_0_lo + (q0_1_lo * once_1 + q0_1 * once_1_lo))))
    twice_0a = q0_0 * rest
    twice_0 = once_0 - twice_0a
    twice_0_right = once_0 - twice_0
    twice_0_lo = (once_0 - (twice_0 + twice_0_right)
        - product_rest(q0_0, rest, twice_0a, twice_0_right) - (q0_0_lo * rest + q0_0 * rest_lo)
        + once_0_lo)
    twice_1a = q0_1 * rest
    twice_1 = once_1 - twice_1a
    twice_1_right = once_1 - twice_1
    twice_1_lo = (once_1 - (twice_1 + twice_1_right)
        - product_rest(q0_1, rest, twice_1a, twice_1_right) - (q0_1_lo * rest + q0_1 * rest_lo)
        + once_1_lo)
    twice_2a = q0_2 * rest
    twice_2 = once_2 - twice_2a
    twice_2_right = once_2 - twice_2
    twice_2_lo = (once_2 - (twice_2 + twice_2_right)
        - product_rest(q0_2, rest, twice_2a, twice_2_right) - (q0_2_lo * rest + q0_2 * rest_lo)
        + once_2_lo)
    n_a = twice_0 * twice_0
    n_b = twice_1 * twice_1
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_c_lo1 = (product_rest(twice_0, twice_0, n_a, n_c - n_c_right)
        + product_rest(twice_1, twice_1, n_b, n_c_right))
    n_d = twice_2 * twice_2
    n_e = n_c + n_d
    n_e_right = n_e - n_c
    n_e_lo2 = (n_c - (n_e - n_e_right) + product_rest(twice_2, twice_2, n_d, n_e_right)
        + (twice_2_lo * twice_2 + twice_2 * twice_2_lo))
    n_e_lo = (n_e_lo2
        + (n_c_lo1
        + (twice_0_lo * twice_0 + twice_0 * twice_0_lo
        + (twice_1_lo * twice_1 + twice_1 * twice_1_lo))))
    n_e_sum = n_e + n_e_lo
    n_e_sum_right = n_e_sum - n_e
    n = sqrt(n_e_sum)
    n_product = n * n
    n_lo = ((n_e_sum - n_product - product_error(n, n, n_product)
        + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right))) / where(n == 0, 1, n + n))
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right)
    divisor_a = n_sum == 0
    divisor = where(divisor_a, 1, n_sum)
    divisor_lo = where(divisor_a, 0, n_sum_lo)
    twice_0_sum = twice_0 + twice_0_lo
    twice_0_sum_right = twice_0_sum - twice_0
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    q1_0 = twice_0_sum / divisor_sum
    q1_0_product = q1_0 * divisor_sum
    twice_0_sum_lo = twice_0 - (twice_0_sum - twice_0_sum_right) + (twice_0_lo - twice_0_sum_right)
    q1_0_lo = ((twice_0_sum - q1_0_product - product_error(q1_0, divisor_sum, q1_0_product)
        + twice_0_sum_lo - q1_0 * divisor_sum_lo) / divisor_sum)
    twice_1_sum = twice_1 + twice_1_lo
    twice_1_sum_right = twice_1_sum - twice_1
    q1_1 = twice_1_sum / divisor_sum
    q1_1_product = q1_1 * divisor_sum
    twice_1_sum_lo = twice_1 - (twice_1_sum - twice_1_sum_right) + (twice_1_lo - twice_1_sum_right)
    q1_1_lo = ((twice_1_sum - q1_1_product - product_error(q1_1, divisor_sum, q1_1_product)
        + twice_1_sum_lo - q1_1 * divisor_sum_lo) / divisor_sum)
    twice_2_sum = twice_2 + twice_2_lo
    twice_2_sum_right = twice_2_sum - twice_2
    q1_2 = twice_2_sum / divisor_sum
    q1_2_product = q1_2 * divisor_sum
    twice_2_sum_lo = twice_2 - (twice_2_sum - twice_2_sum_right) + (twice_2_lo - twice_2_sum_right)
    q1_2_lo = ((twice_2_sum - q1_2_product - product_error(q1_2, divisor_sum, q1_2_product)
        + twice_2_sum_lo - q1_2 * divisor_sum_lo) / divisor_sum)
    normal_0a = q0_1 * q1_2
    normal_0b = q0_2 * q1_1
    normal_0 = normal_0a - normal_0b
    normal_0_right = normal_0a - normal_0
    normal_0_lo1 = (product_rest(q0_1, q1_2, normal_0a, normal_0 + normal_0_right)
        - product_rest(q0_2, q1_1, normal_0b, normal_0_right))
    normal_0_lo = (normal_0_lo1
        + (q0_1_lo * q1_2 + q0_1 * q1_2_lo - (q0_2_lo * q1_1 + q0_2 * q1_1_lo)))
    normal_1a = q0_2 * q1_0
    normal_1b = q0_0 * q1_2
    normal_1 = normal_1a - normal_1b
    normal_1_right = normal_1a - normal_1
    normal_1_lo1 = (product_rest(q0_2, q1_0, normal_1a, normal_1 + normal_1_right)
        - product_rest(q0_0, q1_2, normal_1b, normal_1_right))
    normal_1_lo = (normal_1_lo1
        + (q0_2_lo * q1_0 + q0_2 * q1_0_lo - (q0_0_lo * q1_2 + q0_0 * q1_2_lo)))
    normal_2a = q0_0 * q1_1
    normal_2b = q0_1 * q1_0
    normal_2 = normal_2a - normal_2b
    normal_2_right = normal_2a - normal_2
    normal_2_lo1 = (product_rest(q0_0, q1_1, normal_2a, normal_2 + normal_2_right)
        - product_rest(q0_1, q1_0, normal_2b, normal_2_right))
    normal_2_lo = (normal_2_lo1
        + (q0_0_lo * q1_1 + q0_0 * q1_1_lo - (q0_1_lo * q1_0 + q0_1 * q1_0_lo)))
    u2_s_size_0 = absolute(self_20)
    u2_s_size_1 = absolute(self_21)
    u2_s_size_2 = absolute(self_22)
    u2_s_largest1 = where(u2_s_size_0 < u2_s_size_1, u2_s_size_1, u2_s_size_0)
    u2_s_largest2 = where(u2_s_largest1 < u2_s_size_2, u2_s_size_2, u2_s_largest1)
    u2_s_d = where(u2_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < u2_s_largest2, real(3.7291703656001034e-155), real(1)))
    u2_s = where(u2_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, u2_s_d)
    u2_y_0 = self_20 * u2_s
    u2_y_1 = self_21 * u2_s
    u2_y_2 = self_22 * u2_s
    u2_up = where(1 < u2_s, u2_s, 1)
    u2_down = where(u2_s < 1, u2_s, 1)
    u2_n_a = u2_y_0 * u2_y_0
    u2_n_b = u2_y_1 * u2_y_1
    u2_n_c = u2_n_a + u2_n_b
    u2_n_c_right = u2_n_c - u2_n_a
    u2_n_d = u2_y_2 * u2_y_2
    u2_n_e = u2_n_c + u2_n_d
    u2_n_e_right = u2_n_e - u2_n_c
    u2_n_c_lo = (product_rest(u2_y_0, u2_y_0, u2_n_a, u2_n_c - u2_n_c_right)
        + product_rest(u2_y_1, u2_y_1, u2_n_b, u2_n_c_right))
    u2_n_e_lo = (u2_n_c - (u2_n_e - u2_n_e_right)
        + product_rest(u2_y_2, u2_y_2, u2_n_d, u2_n_e_right) + u2_n_c_lo)
    u2_n_e_sum = u2_n_e + u2_n_e_lo
    u2_n_e_sum_right = u2_n_e_sum - u2_n_e
    u2_n = sqrt(u2_n_e_sum)
    u2_n_product = u2_n * u2_n
    u2_n_e_sum_lo = u2_n_e - (u2_n_e_sum - u2_n_e_sum_right) + (u2_n_e_lo - u2_n_e_sum_right)
    u2_n_lo = ((u2_n_e_sum - u2_n_product - product_error(u2_n, u2_n, u2_n_product)
        + u2_n_e_sum_lo) / where(u2_n == 0, 1, u2_n + u2_n))
    u2_n_sum = u2_n + u2_n_lo
    u2_n_sum_right = u2_n_sum - u2_n
    u2_divisor_a = u2_n_sum == 0
    u2_divisor = where(u2_divisor_a, u2_up, u2_n_sum)
    u2_divisor_lo = where(u2_divisor_a, 0,
        u2_n - (u2_n_sum - u2_n_sum_right) + (u2_n_lo - u2_n_sum_right))
    u2_sized_0 = self_20 * u2_up
    u2_sized_1 = self_21 * u2_up
    u2_sized_2 = self_22 * u2_up
    u2_divisor_sum = u2_divisor + u2_divisor_lo
    u2_divisor_sum_right = u2_divisor_sum - u2_divisor
    u2_divisor_sum_lo = (u2_divisor - (u2_divisor_sum - u2_divisor_sum_right)
        + (u2_divisor_lo - u2_divisor_sum_right))
    u2_quotient_0 = u2_sized_0 / u2_divisor_sum
    u2_quotient_0_product = u2_quotient_0 * u2_divisor_sum
    u2_quotient_0_exact = (u2_sized_0 - u2_quotient_0_product
        - product_error(u2_quotient_0, u2_divisor_sum, u2_quotient_0_product))
    u2_quotient_0_lo = (u2_quotient_0_exact - u2_quotient_0 * u2_divisor_sum_lo) / u2_divisor_sum
    u2_quotient_1 = u2_sized_1 / u2_divisor_sum
    u2_quotient_1_product = u2_quotient_1 * u2_divisor_sum
    u2_quotient_1_exact = (u2_sized_1 - u2_quotient_1_product
        - product_error(u2_quotient_1, u2_divisor_sum, u2_quotient_1_product))
    u2_quotient_1_lo = (u2_quotient_1_exact - u2_quotient_1 * u2_divisor_sum_lo) / u2_divisor_sum
    u2_quotient_2 = u2_sized_2 / u2_divisor_sum
    u2_quotient_2_product = u2_quotient_2 * u2_divisor_sum
    u2_quotient_2_exact = (u2_sized_2 - u2_quotient_2_product
        - product_error(u2_quotient_2, u2_divisor_sum, u2_quotient_2_product))
    u2_quotient_2_lo = (u2_quotient_2_exact - u2_quotient_2 * u2_divisor_sum_lo) / u2_divisor_sum
    u2_quotient_0_sum = u2_quotient_0 + u2_quotient_0_lo
    u2_quotient_0_sum_right = u2_quotient_0_sum - u2_quotient_0
    u2_0 = u2_quotient_0_sum * u2_down
    u2_0_inverse = 1 / u2_down
    u2_quotient_0_sum_lo = (u2_quotient_0 - (u2_quotient_0_sum - u2_quotient_0_sum_right)
        + (u2_quotient_0_lo - u2_quotient_0_sum_right))
    u2_quotient_1_sum = u2_quotient_1 + u2_quotient_1_lo
    u2_quotient_1_sum_right = u2_quotient_1_sum - u2_quotient_1
    u2_1 = u2_quotient_1_sum * u2_down
    u2_quotient_1_sum_lo = (u2_quotient_1 - (u2_quotient_1_sum - u2_quotient_1_sum_right)
        + (u2_quotient_1_lo - u2_quotient_1_sum_right))
    u2_quotient_2_sum = u2_quotient_2 + u2_quotient_2_lo
    u2_quotient_2_sum_right = u2_quotient_2_sum - u2_quotient_2
    u2_2 = u2_quotient_2_sum * u2_down
    u2_quotient_2_sum_lo = (u2_quotient_2 - (u2_quotient_2_sum - u2_quotient_2_sum_right)
        + (u2_quotient_2_lo - u2_quotient_2_sum_right))
    side_a = normal_0 * u2_0
    side_b = normal_1 * u2_1
    side_c = side_a + side_b
    side_c_right = side_c - side_a
    side_a_cross = (normal_0_lo * u2_0 + normal_0
        * ((u2_quotient_0_sum - u2_0 * u2_0_inverse + u2_quotient_0_sum_lo) * u2_down))
    side_c_cross = (side_a_cross
        + (normal_1_lo * u2_1 + normal_1
        * ((u2_quotient_1_sum - u2_1 * u2_0_inverse + u2_quotient_1_sum_lo) * u2_down)))
    side_d = normal_2 * u2_2
    side = side_c + side_d
    side_right = side - side_c
    side_d_cross = (normal_2_lo * u2_2 + normal_2
        * ((u2_quotient_2_sum - u2_2 * u2_0_inverse + u2_quotient_2_sum_lo) * u2_down))
    side_c_lo = (product_rest(normal_0, u2_0, side_a, side_c - side_c_right)
        + product_rest(normal_1, u2_1, side_b, side_c_right) + side_c_cross)
    side_lo = (side_c - (side - side_right) + product_rest(normal_2, u2_2, side_d, side_right)
        + side_d_cross + side_c_lo)
    side_sum = side + side_lo
    side_sum_right = side_sum - side
    side_sum_lo = side - (side_sum - side_sum_right) + (side_lo - side_sum_right)
    q2_0b = side_sum < 0
    q2_0 = where(q2_0b, -normal_0, normal_0)
    q2_1 = where(q2_0b, -normal_1, normal_1)
    q2_2 = where(q2_0b, -normal_2, normal_2)
    size = absolute(side_sum)
    size_lo = where(side_sum < 0, -side_sum_lo, side_sum_lo)
    size_sum = size + size_lo
    size_sum_right = size_sum - size
    less_a = n_sum < size_sum
    less = where(less_a, n_sum, size_sum)
    dependent_a = (less
        + where(less_a, n_sum_lo, size - (size_sum - size_sum_right) + (size_lo - size_sum_right))
        < 1.7763568394002505e-15)
    dependent = where(dependent_a, real(1), real(0))
    self_00_new_a = dependent == 1
    self_00_new = where(self_00_new_a, nan, q0_0)
    self_01_new = where(self_00_new_a, nan, q0_1)
    self_02_new = where(self_00_new_a, nan, q0_2)
    self_10_new = where(self_00_new_a, nan, q1_0)
    self_11_new = where(self_00_new_a, nan, q1_1)
    self_12_new = where(self_00_new_a, nan, q1_2)
    self_20_new = where(self_00_new_a, nan, q2_0)
    self_21_new = where(self_00_new_a, nan, q2_1)
    self_22_new = where(self_00_new_a, nan, q2_2)
    self_00_new_rounded = self_00_new + where(self_00_new_a, 0, q0_0_lo)
    self_01_new_rounded = self_01_new + where(self_00_new_a, 0, q0_1_lo)
    self_02_new_rounded = self_02_new + where(self_00_new_a, 0, q0_2_lo)
    self_10_new_rounded = self_10_new + where(self_00_new_a, 0, q1_0_lo)
    self_11_new_rounded = self_11_new + where(self_00_new_a, 0, q1_1_lo)
    self_12_new_rounded = self_12_new + where(self_00_new_a, 0, q1_2_lo)
    self_20_new_rounded = (self_20_new
        + where(self_00_new_a, 0, where(q2_0b, -normal_0_lo, normal_0_lo)))
    self_21_new_rounded = (self_21_new
        + where(self_00_new_a, 0, where(q2_0b, -normal_1_lo, normal_1_lo)))
    self_22_new_rounded = (self_22_new
        + where(self_00_new_a, 0, where(q2_0b, -normal_2_lo, normal_2_lo)))
    self_00_new_final = where(self_00_new_rounded == self_00_new_rounded, self_00_new_rounded,
        self_00_new)
    self_01_new_final = where(self_01_new_rounded == self_01_new_rounded, self_01_new_rounded,
        self_01_new)
    self_02_new_final = where(self_02_new_rounded == self_02_new_rounded, self_02_new_rounded,
        self_02_new)
    self_10_new_final = where(self_10_new_rounded == self_10_new_rounded, self_10_new_rounded,
        self_10_new)
    self_11_new_final = where(self_11_new_rounded == self_11_new_rounded, self_11_new_rounded,
        self_11_new)
    self_12_new_final = where(self_12_new_rounded == self_12_new_rounded, self_12_new_rounded,
        self_12_new)
    self_20_new_final = where(self_20_new_rounded == self_20_new_rounded, self_20_new_rounded,
        self_20_new)
    self_21_new_final = where(self_21_new_rounded == self_21_new_rounded, self_21_new_rounded,
        self_21_new)
    self_22_new_final = where(self_22_new_rounded == self_22_new_rounded, self_22_new_rounded,
        self_22_new)
    return (self_00_new_final, self_01_new_final, self_02_new_final, self_10_new_final,
        self_11_new_final, self_12_new_final, self_20_new_final, self_21_new_final,
        self_22_new_final)


@kernel("(3,3)->(3,3)")
def mat3x3_normalized(R):
    """Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
    its side of the first, the third on its side of both; NaN where the rows are linearly
    dependent to rounding.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    154 mul, 405 add, 16 product error, 33 product rest, 31 div, 4 sqrt, 7 neg, 10 abs, 25 less,
    18 equal, 70 select.  |R R^T - I|_ij <= 8 u for the result R; searched, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    q0_s_size_0 = absolute(R_00)
    q0_s_size_1 = absolute(R_01)
    q0_s_size_2 = absolute(R_02)
    q0_s_largest1 = where(q0_s_size_0 < q0_s_size_1, q0_s_size_1, q0_s_size_0)
    q0_s_largest2 = where(q0_s_largest1 < q0_s_size_2, q0_s_size_2, q0_s_largest1)
    q0_s_d = where(q0_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < q0_s_largest2, real(3.7291703656001034e-155), real(1)))
    q0_s = where(q0_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, q0_s_d)
    q0_y_0 = R_00 * q0_s
    q0_y_1 = R_01 * q0_s
    q0_y_2 = R_02 * q0_s
    q0_up = where(1 < q0_s, q0_s, 1)
    q0_down = where(q0_s < 1, q0_s, 1)
    q0_n_a = q0_y_0 * q0_y_0
    q0_n_b = q0_y_1 * q0_y_1
    q0_n_c = q0_n_a + q0_n_b
    q0_n_c_right = q0_n_c - q0_n_a
    q0_n_d = q0_y_2 * q0_y_2
    q0_n_e = q0_n_c + q0_n_d
    q0_n_e_right = q0_n_e - q0_n_c
    q0_n_c_lo = (product_rest(q0_y_0, q0_y_0, q0_n_a, q0_n_c - q0_n_c_right)
        + product_rest(q0_y_1, q0_y_1, q0_n_b, q0_n_c_right))
    q0_n_e_lo = (q0_n_c - (q0_n_e - q0_n_e_right)
        + product_rest(q0_y_2, q0_y_2, q0_n_d, q0_n_e_right) + q0_n_c_lo)
    q0_n_e_sum = q0_n_e + q0_n_e_lo
    q0_n_e_sum_right = q0_n_e_sum - q0_n_e
    q0_n = sqrt(q0_n_e_sum)
    q0_n_product = q0_n * q0_n
    q0_n_e_sum_lo = q0_n_e - (q0_n_e_sum - q0_n_e_sum_right) + (q0_n_e_lo - q0_n_e_sum_right)
    q0_n_lo = ((q0_n_e_sum - q0_n_product - product_error(q0_n, q0_n, q0_n_product)
        + q0_n_e_sum_lo) / where(q0_n == 0, 1, q0_n + q0_n))
    q0_n_sum = q0_n + q0_n_lo
    q0_n_sum_right = q0_n_sum - q0_n
    q0_divisor_a = q0_n_sum == 0
    q0_divisor = where(q0_divisor_a, q0_up, q0_n_sum)
    q0_divisor_lo = where(q0_divisor_a, 0,
        q0_n - (q0_n_sum - q0_n_sum_right) + (q0_n_lo - q0_n_sum_right))
    q0_sized_0 = R_00 * q0_up
    q0_sized_1 = R_01 * q0_up
    q0_sized_2 = R_02 * q0_up
    q0_divisor_sum = q0_divisor + q0_divisor_lo
    q0_divisor_sum_right = q0_divisor_sum - q0_divisor
    q0_divisor_sum_lo = (q0_divisor - (q0_divisor_sum - q0_divisor_sum_right)
        + (q0_divisor_lo - q0_divisor_sum_right))
    q0_quotient_0 = q0_sized_0 / q0_divisor_sum
    q0_quotient_0_product = q0_quotient_0 * q0_divisor_sum
    q0_quotient_0_exact = (q0_sized_0 - q0_quotient_0_product
        - product_error(q0_quotient_0, q0_divisor_sum, q0_quotient_0_product))
    q0_quotient_0_lo = (q0_quotient_0_exact - q0_quotient_0 * q0_divisor_sum_lo) / q0_divisor_sum
    q0_quotient_1 = q0_sized_1 / q0_divisor_sum
    q0_quotient_1_product = q0_quotient_1 * q0_divisor_sum
    q0_quotient_1_exact = (q0_sized_1 - q0_quotient_1_product
        - product_error(q0_quotient_1, q0_divisor_sum, q0_quotient_1_product))
    q0_quotient_1_lo = (q0_quotient_1_exact - q0_quotient_1 * q0_divisor_sum_lo) / q0_divisor_sum
    q0_quotient_2 = q0_sized_2 / q0_divisor_sum
    q0_quotient_2_product = q0_quotient_2 * q0_divisor_sum
    q0_quotient_2_exact = (q0_sized_2 - q0_quotient_2_product
        - product_error(q0_quotient_2, q0_divisor_sum, q0_quotient_2_product))
    q0_quotient_2_lo = (q0_quotient_2_exact - q0_quotient_2 * q0_divisor_sum_lo) / q0_divisor_sum
    q0_quotient_0_sum = q0_quotient_0 + q0_quotient_0_lo
    q0_quotient_0_sum_right = q0_quotient_0_sum - q0_quotient_0
    q0_0 = q0_quotient_0_sum * q0_down
    q0_0_inverse = 1 / q0_down
    q0_quotient_0_sum_lo = (q0_quotient_0 - (q0_quotient_0_sum - q0_quotient_0_sum_right)
        + (q0_quotient_0_lo - q0_quotient_0_sum_right))
    q0_0_lo = (q0_quotient_0_sum - q0_0 * q0_0_inverse + q0_quotient_0_sum_lo) * q0_down
    q0_quotient_1_sum = q0_quotient_1 + q0_quotient_1_lo
    q0_quotient_1_sum_right = q0_quotient_1_sum - q0_quotient_1
    q0_1 = q0_quotient_1_sum * q0_down
    q0_quotient_1_sum_lo = (q0_quotient_1 - (q0_quotient_1_sum - q0_quotient_1_sum_right)
        + (q0_quotient_1_lo - q0_quotient_1_sum_right))
    q0_1_lo = (q0_quotient_1_sum - q0_1 * q0_0_inverse + q0_quotient_1_sum_lo) * q0_down
    q0_quotient_2_sum = q0_quotient_2 + q0_quotient_2_lo
    q0_quotient_2_sum_right = q0_quotient_2_sum - q0_quotient_2
    q0_2 = q0_quotient_2_sum * q0_down
    q0_quotient_2_sum_lo = (q0_quotient_2 - (q0_quotient_2_sum - q0_quotient_2_sum_right)
        + (q0_quotient_2_lo - q0_quotient_2_sum_right))
    q0_2_lo = (q0_quotient_2_sum - q0_2 * q0_0_inverse + q0_quotient_2_sum_lo) * q0_down
    u1_s_size_0 = absolute(R_10)
    u1_s_size_1 = absolute(R_11)
    u1_s_size_2 = absolute(R_12)
    u1_s_largest1 = where(u1_s_size_0 < u1_s_size_1, u1_s_size_1, u1_s_size_0)
    u1_s_largest2 = where(u1_s_largest1 < u1_s_size_2, u1_s_size_2, u1_s_largest1)
    u1_s_d = where(u1_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < u1_s_largest2, real(3.7291703656001034e-155), real(1)))
    u1_s = where(u1_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, u1_s_d)
    u1_y_0 = R_10 * u1_s
    u1_y_1 = R_11 * u1_s
    u1_y_2 = R_12 * u1_s
    u1_up = where(1 < u1_s, u1_s, 1)
    u1_down = where(u1_s < 1, u1_s, 1)
    u1_n_a = u1_y_0 * u1_y_0
    u1_n_b = u1_y_1 * u1_y_1
    u1_n_c = u1_n_a + u1_n_b
    u1_n_c_right = u1_n_c - u1_n_a
    u1_n_d = u1_y_2 * u1_y_2
    u1_n_e = u1_n_c + u1_n_d
    u1_n_e_right = u1_n_e - u1_n_c
    u1_n_c_lo = (product_rest(u1_y_0, u1_y_0, u1_n_a, u1_n_c - u1_n_c_right)
        + product_rest(u1_y_1, u1_y_1, u1_n_b, u1_n_c_right))
    u1_n_e_lo = (u1_n_c - (u1_n_e - u1_n_e_right)
        + product_rest(u1_y_2, u1_y_2, u1_n_d, u1_n_e_right) + u1_n_c_lo)
    u1_n_e_sum = u1_n_e + u1_n_e_lo
    u1_n_e_sum_right = u1_n_e_sum - u1_n_e
    u1_n = sqrt(u1_n_e_sum)
    u1_n_product = u1_n * u1_n
    u1_n_e_sum_lo = u1_n_e - (u1_n_e_sum - u1_n_e_sum_right) + (u1_n_e_lo - u1_n_e_sum_right)
    u1_n_lo = ((u1_n_e_sum - u1_n_product - product_error(u1_n, u1_n, u1_n_product)
        + u1_n_e_sum_lo) / where(u1_n == 0, 1, u1_n + u1_n))
    u1_n_sum = u1_n + u1_n_lo
    u1_n_sum_right = u1_n_sum - u1_n
    u1_divisor_a = u1_n_sum == 0
    u1_divisor = where(u1_divisor_a, u1_up, u1_n_sum)
    u1_divisor_lo = where(u1_divisor_a, 0,
        u1_n - (u1_n_sum - u1_n_sum_right) + (u1_n_lo - u1_n_sum_right))
    u1_sized_0 = R_10 * u1_up
    u1_sized_1 = R_11 * u1_up
    u1_sized_2 = R_12 * u1_up
    u1_divisor_sum = u1_divisor + u1_divisor_lo
    u1_divisor_sum_right = u1_divisor_sum - u1_divisor
    u1_divisor_sum_lo = (u1_divisor - (u1_divisor_sum - u1_divisor_sum_right)
        + (u1_divisor_lo - u1_divisor_sum_right))
    u1_quotient_0 = u1_sized_0 / u1_divisor_sum
    u1_quotient_0_product = u1_quotient_0 * u1_divisor_sum
    u1_quotient_0_exact = (u1_sized_0 - u1_quotient_0_product
        - product_error(u1_quotient_0, u1_divisor_sum, u1_quotient_0_product))
    u1_quotient_0_lo = (u1_quotient_0_exact - u1_quotient_0 * u1_divisor_sum_lo) / u1_divisor_sum
    u1_quotient_1 = u1_sized_1 / u1_divisor_sum
    u1_quotient_1_product = u1_quotient_1 * u1_divisor_sum
    u1_quotient_1_exact = (u1_sized_1 - u1_quotient_1_product
        - product_error(u1_quotient_1, u1_divisor_sum, u1_quotient_1_product))
    u1_quotient_1_lo = (u1_quotient_1_exact - u1_quotient_1 * u1_divisor_sum_lo) / u1_divisor_sum
    u1_quotient_2 = u1_sized_2 / u1_divisor_sum
    u1_quotient_2_product = u1_quotient_2 * u1_divisor_sum
    u1_quotient_2_exact = (u1_sized_2 - u1_quotient_2_product
        - product_error(u1_quotient_2, u1_divisor_sum, u1_quotient_2_product))
    u1_quotient_2_lo = (u1_quotient_2_exact - u1_quotient_2 * u1_divisor_sum_lo) / u1_divisor_sum
    u1_quotient_0_sum = u1_quotient_0 + u1_quotient_0_lo
    u1_quotient_0_sum_right = u1_quotient_0_sum - u1_quotient_0
    u1_0 = u1_quotient_0_sum * u1_down
    u1_0_inverse = 1 / u1_down
    u1_quotient_0_sum_lo = (u1_quotient_0 - (u1_quotient_0_sum - u1_quotient_0_sum_right)
        + (u1_quotient_0_lo - u1_quotient_0_sum_right))
    u1_0_lo = (u1_quotient_0_sum - u1_0 * u1_0_inverse + u1_quotient_0_sum_lo) * u1_down
    u1_quotient_1_sum = u1_quotient_1 + u1_quotient_1_lo
    u1_quotient_1_sum_right = u1_quotient_1_sum - u1_quotient_1
    u1_1 = u1_quotient_1_sum * u1_down
    u1_quotient_1_sum_lo = (u1_quotient_1 - (u1_quotient_1_sum - u1_quotient_1_sum_right)
        + (u1_quotient_1_lo - u1_quotient_1_sum_right))
    u1_1_lo = (u1_quotient_1_sum - u1_1 * u1_0_inverse + u1_quotient_1_sum_lo) * u1_down
    u1_quotient_2_sum = u1_quotient_2 + u1_quotient_2_lo
    u1_quotient_2_sum_right = u1_quotient_2_sum - u1_quotient_2
    u1_2 = u1_quotient_2_sum * u1_down
    u1_quotient_2_sum_lo = (u1_quotient_2 - (u1_quotient_2_sum - u1_quotient_2_sum_right)
        + (u1_quotient_2_lo - u1_quotient_2_sum_right))
    u1_2_lo = (u1_quotient_2_sum - u1_2 * u1_0_inverse + u1_quotient_2_sum_lo) * u1_down
    along_a = q0_0 * u1_0
    along_b = q0_1 * u1_1
    along_c = along_a + along_b
    along_c_right = along_c - along_a
    along_c_lo1 = (product_rest(q0_0, u1_0, along_a, along_c - along_c_right)
        + product_rest(q0_1, u1_1, along_b, along_c_right))
    along_d = q0_2 * u1_2
    along = along_c + along_d
    along_right = along - along_c
    along_lo2 = (along_c - (along - along_right) + product_rest(q0_2, u1_2, along_d, along_right)
        + (q0_2_lo * u1_2 + q0_2 * u1_2_lo))
    along_lo = (along_lo2
        + (along_c_lo1 + (q0_0_lo * u1_0 + q0_0 * u1_0_lo + (q0_1_lo * u1_1 + q0_1 * u1_1_lo))))
    once_0a = q0_0 * along
    once_0 = u1_0 - once_0a
    once_0_right = u1_0 - once_0
    once_0_lo = (u1_0 - (once_0 + once_0_right) - product_rest(q0_0, along, once_0a, once_0_right)
        - (q0_0_lo * along + q0_0 * along_lo) + u1_0_lo)
    once_1a = q0_1 * along
    once_1 = u1_1 - once_1a
    once_1_right = u1_1 - once_1
    once_1_lo = (u1_1 - (once_1 + once_1_right) - product_rest(q0_1, along, once_1a, once_1_right)
        - (q0_1_lo * along + q0_1 * along_lo) + u1_1_lo)
    once_2a = q0_2 * along
    once_2 = u1_2 - once_2a
    once_2_right = u1_2 - once_2
    once_2_lo = (u1_2 - (once_2 + once_2_right) - product_rest(q0_2, along, once_2a, once_2_right)
        - (q0_2_lo * along + q0_2 * along_lo) + u1_2_lo)
    rest_a = q0_0 * once_0
    rest_b = q0_1 * once_1
    rest_c = rest_a + rest_b
    rest_c_right = rest_c - rest_a
    rest_c_lo1 = (product_rest(q0_0, once_0, rest_a, rest_c - rest_c_right)
        + product_rest(q0_1, once_1, rest_b, rest_c_right))
    rest_d = q0_2 * once_2
    rest = rest_c + rest_d
    rest_right = rest - rest_c
    rest_lo2 = (rest_c - (rest - rest_right) + product_rest(q0_2, once_2, rest_d, rest_right)
        + (q0_2_lo * once_2 + q0_2 * once_2_lo))
    rest_lo = (rest_lo2
        + (rest_c_lo1
        + (q0_0_lo * once_0 + q0_0 * once_0_lo + (q0_1_lo * once_1 + q0_1 * once_1_lo))))
    twice_0a = q0_0 * rest
    twice_0 = once_0 - twice_0a
    twice_0_right = once_0 - twice_0
    twice_0_lo = (once_0 - (twice_0 + twice_0_right)
        - product_rest(q0_0, rest, twice_0a, twice_0_right) - (q0_0_lo * rest + q0_0 * rest_lo)
        + once_0_lo)
    twice_1a = q0_1 * rest
    twice_1 = once_1 - twice_1a
    twice_1_right = once_1 - twice_1
    twice_1_lo = (once_1 - (twice_1 + twice_1_right)
        - product_rest(q0_1, rest, twice_1a, twice_1_right) - (q0_1_lo * rest + q0_1 * rest_lo)
        + once_1_lo)
    twice_2a = q0_2 * rest
    twice_2 = once_2 - twice_2a
    twice_2_right = once_2 - twice_2
    twice_2_lo = (once_2 - (twice_2 + twice_2_right)
        - product_rest(q0_2, rest, twice_2a, twice_2_right) - (q0_2_lo * rest + q0_2 * rest_lo)
        + once_2_lo)
    n_a = twice_0 * twice_0
    n_b = twice_1 * twice_1
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_c_lo1 = (product_rest(twice_0, twice_0, n_a, n_c - n_c_right)
        + product_rest(twice_1, twice_1, n_b, n_c_right))
    n_d = twice_2 * twice_2
    n_e = n_c + n_d
    n_e_right = n_e - n_c
    n_e_lo2 = (n_c - (n_e - n_e_right) + product_rest(twice_2, twice_2, n_d, n_e_right)
        + (twice_2_lo * twice_2 + twice_2 * twice_2_lo))
    n_e_lo = (n_e_lo2
        + (n_c_lo1
        + (twice_0_lo * twice_0 + twice_0 * twice_0_lo
        + (twice_1_lo * twice_1 + twice_1 * twice_1_lo))))
    n_e_sum = n_e + n_e_lo
    n_e_sum_right = n_e_sum - n_e
    n = sqrt(n_e_sum)
    n_product = n * n
    n_lo = ((n_e_sum - n_product - product_error(n, n, n_product)
        + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right))) / where(n == 0, 1, n + n))
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right)
    divisor_a = n_sum == 0
    divisor = where(divisor_a, 1, n_sum)
    divisor_lo = where(divisor_a, 0, n_sum_lo)
    twice_0_sum = twice_0 + twice_0_lo
    twice_0_sum_right = twice_0_sum - twice_0
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    q1_0 = twice_0_sum / divisor_sum
    q1_0_product = q1_0 * divisor_sum
    twice_0_sum_lo = twice_0 - (twice_0_sum - twice_0_sum_right) + (twice_0_lo - twice_0_sum_right)
    q1_0_lo = ((twice_0_sum - q1_0_product - product_error(q1_0, divisor_sum, q1_0_product)
        + twice_0_sum_lo - q1_0 * divisor_sum_lo) / divisor_sum)
    twice_1_sum = twice_1 + twice_1_lo
    twice_1_sum_right = twice_1_sum - twice_1
    q1_1 = twice_1_sum / divisor_sum
    q1_1_product = q1_1 * divisor_sum
    twice_1_sum_lo = twice_1 - (twice_1_sum - twice_1_sum_right) + (twice_1_lo - twice_1_sum_right)
    q1_1_lo = ((twice_1_sum - q1_1_product - product_error(q1_1, divisor_sum, q1_1_product)
        + twice_1_sum_lo - q1_1 * divisor_sum_lo) / divisor_sum)
    twice_2_sum = twice_2 + twice_2_lo
    twice_2_sum_right = twice_2_sum - twice_2
    q1_2 = twice_2_sum / divisor_sum
    q1_2_product = q1_2 * divisor_sum
    twice_2_sum_lo = twice_2 - (twice_2_sum - twice_2_sum_right) + (twice_2_lo - twice_2_sum_right)
    q1_2_lo = ((twice_2_sum - q1_2_product - product_error(q1_2, divisor_sum, q1_2_product)
        + twice_2_sum_lo - q1_2 * divisor_sum_lo) / divisor_sum)
    normal_0a = q0_1 * q1_2
    normal_0b = q0_2 * q1_1
    normal_0 = normal_0a - normal_0b
    normal_0_right = normal_0a - normal_0
    normal_0_lo1 = (product_rest(q0_1, q1_2, normal_0a, normal_0 + normal_0_right)
        - product_rest(q0_2, q1_1, normal_0b, normal_0_right))
    normal_0_lo = (normal_0_lo1
        + (q0_1_lo * q1_2 + q0_1 * q1_2_lo - (q0_2_lo * q1_1 + q0_2 * q1_1_lo)))
    normal_1a = q0_2 * q1_0
    normal_1b = q0_0 * q1_2
    normal_1 = normal_1a - normal_1b
    normal_1_right = normal_1a - normal_1
    normal_1_lo1 = (product_rest(q0_2, q1_0, normal_1a, normal_1 + normal_1_right)
        - product_rest(q0_0, q1_2, normal_1b, normal_1_right))
    normal_1_lo = (normal_1_lo1
        + (q0_2_lo * q1_0 + q0_2 * q1_0_lo - (q0_0_lo * q1_2 + q0_0 * q1_2_lo)))
    normal_2a = q0_0 * q1_1
    normal_2b = q0_1 * q1_0
    normal_2 = normal_2a - normal_2b
    normal_2_right = normal_2a - normal_2
    normal_2_lo1 = (product_rest(q0_0, q1_1, normal_2a, normal_2 + normal_2_right)
        - product_rest(q0_1, q1_0, normal_2b, normal_2_right))
    normal_2_lo = (normal_2_lo1
        + (q0_0_lo * q1_1 + q0_0 * q1_1_lo - (q0_1_lo * q1_0 + q0_1 * q1_0_lo)))
    u2_s_size_0 = absolute(R_20)
    u2_s_size_1 = absolute(R_21)
    u2_s_size_2 = absolute(R_22)
    u2_s_largest1 = where(u2_s_size_0 < u2_s_size_1, u2_s_size_1, u2_s_size_0)
    u2_s_largest2 = where(u2_s_largest1 < u2_s_size_2, u2_s_size_2, u2_s_largest1)
    u2_s_d = where(u2_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < u2_s_largest2, real(3.7291703656001034e-155), real(1)))
    u2_s = where(u2_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, u2_s_d)
    u2_y_0 = R_20 * u2_s
    u2_y_1 = R_21 * u2_s
    u2_y_2 = R_22 * u2_s
    u2_up = where(1 < u2_s, u2_s, 1)
    u2_down = where(u2_s < 1, u2_s, 1)
    u2_n_a = u2_y_0 * u2_y_0
    u2_n_b = u2_y_1 * u2_y_1
    u2_n_c = u2_n_a + u2_n_b
    u2_n_c_right = u2_n_c - u2_n_a
    u2_n_d = u2_y_2 * u2_y_2
    u2_n_e = u2_n_c + u2_n_d
    u2_n_e_right = u2_n_e - u2_n_c
    u2_n_c_lo = (product_rest(u2_y_0, u2_y_0, u2_n_a, u2_n_c - u2_n_c_right)
        + product_rest(u2_y_1, u2_y_1, u2_n_b, u2_n_c_right))
    u2_n_e_lo = (u2_n_c - (u2_n_e - u2_n_e_right)
        + product_rest(u2_y_2, u2_y_2, u2_n_d, u2_n_e_right) + u2_n_c_lo)
    u2_n_e_sum = u2_n_e + u2_n_e_lo
    u2_n_e_sum_right = u2_n_e_sum - u2_n_e
    u2_n = sqrt(u2_n_e_sum)
    u2_n_product = u2_n * u2_n
    u2_n_e_sum_lo = u2_n_e - (u2_n_e_sum - u2_n_e_sum_right) + (u2_n_e_lo - u2_n_e_sum_right)
    u2_n_lo = ((u2_n_e_sum - u2_n_product - product_error(u2_n, u2_n, u2_n_product)
        + u2_n_e_sum_lo) / where(u2_n == 0, 1, u2_n + u2_n))
    u2_n_sum = u2_n + u2_n_lo
    u2_n_sum_right = u2_n_sum - u2_n
    u2_divisor_a = u2_n_sum == 0
    u2_divisor = where(u2_divisor_a, u2_up, u2_n_sum)
    u2_divisor_lo = where(u2_divisor_a, 0,
        u2_n - (u2_n_sum - u2_n_sum_right) + (u2_n_lo - u2_n_sum_right))
    u2_sized_0 = R_20 * u2_up
    u2_sized_1 = R_21 * u2_up
    u2_sized_2 = R_22 * u2_up
    u2_divisor_sum = u2_divisor + u2_divisor_lo
    u2_divisor_sum_right = u2_divisor_sum - u2_divisor
    u2_divisor_sum_lo = (u2_divisor - (u2_divisor_sum - u2_divisor_sum_right)
        + (u2_divisor_lo - u2_divisor_sum_right))
    u2_quotient_0 = u2_sized_0 / u2_divisor_sum
    u2_quotient_0_product = u2_quotient_0 * u2_divisor_sum
    u2_quotient_0_exact = (u2_sized_0 - u2_quotient_0_product
        - product_error(u2_quotient_0, u2_divisor_sum, u2_quotient_0_product))
    u2_quotient_0_lo = (u2_quotient_0_exact - u2_quotient_0 * u2_divisor_sum_lo) / u2_divisor_sum
    u2_quotient_1 = u2_sized_1 / u2_divisor_sum
    u2_quotient_1_product = u2_quotient_1 * u2_divisor_sum
    u2_quotient_1_exact = (u2_sized_1 - u2_quotient_1_product
        - product_error(u2_quotient_1, u2_divisor_sum, u2_quotient_1_product))
    u2_quotient_1_lo = (u2_quotient_1_exact - u2_quotient_1 * u2_divisor_sum_lo) / u2_divisor_sum
    u2_quotient_2 = u2_sized_2 / u2_divisor_sum
    u2_quotient_2_product = u2_quotient_2 * u2_divisor_sum
    u2_quotient_2_exact = (u2_sized_2 - u2_quotient_2_product
        - product_error(u2_quotient_2, u2_divisor_sum, u2_quotient_2_product))
    u2_quotient_2_lo = (u2_quotient_2_exact - u2_quotient_2 * u2_divisor_sum_lo) / u2_divisor_sum
    u2_quotient_0_sum = u2_quotient_0 + u2_quotient_0_lo
    u2_quotient_0_sum_right = u2_quotient_0_sum - u2_quotient_0
    u2_0 = u2_quotient_0_sum * u2_down
    u2_0_inverse = 1 / u2_down
    u2_quotient_0_sum_lo = (u2_quotient_0 - (u2_quotient_0_sum - u2_quotient_0_sum_right)
        + (u2_quotient_0_lo - u2_quotient_0_sum_right))
    u2_quotient_1_sum = u2_quotient_1 + u2_quotient_1_lo
    u2_quotient_1_sum_right = u2_quotient_1_sum - u2_quotient_1
    u2_1 = u2_quotient_1_sum * u2_down
    u2_quotient_1_sum_lo = (u2_quotient_1 - (u2_quotient_1_sum - u2_quotient_1_sum_right)
        + (u2_quotient_1_lo - u2_quotient_1_sum_right))
    u2_quotient_2_sum = u2_quotient_2 + u2_quotient_2_lo
    u2_quotient_2_sum_right = u2_quotient_2_sum - u2_quotient_2
    u2_2 = u2_quotient_2_sum * u2_down
    u2_quotient_2_sum_lo = (u2_quotient_2 - (u2_quotient_2_sum - u2_quotient_2_sum_right)
        + (u2_quotient_2_lo - u2_quotient_2_sum_right))
    side_a = normal_0 * u2_0
    side_b = normal_1 * u2_1
    side_c = side_a + side_b
    side_c_right = side_c - side_a
    side_a_cross = (normal_0_lo * u2_0 + normal_0
        * ((u2_quotient_0_sum - u2_0 * u2_0_inverse + u2_quotient_0_sum_lo) * u2_down))
    side_c_cross = (side_a_cross
        + (normal_1_lo * u2_1 + normal_1
        * ((u2_quotient_1_sum - u2_1 * u2_0_inverse + u2_quotient_1_sum_lo) * u2_down)))
    side_d = normal_2 * u2_2
    side = side_c + side_d
    side_right = side - side_c
    side_d_cross = (normal_2_lo * u2_2 + normal_2
        * ((u2_quotient_2_sum - u2_2 * u2_0_inverse + u2_quotient_2_sum_lo) * u2_down))
    side_c_lo = (product_rest(normal_0, u2_0, side_a, side_c - side_c_right)
        + product_rest(normal_1, u2_1, side_b, side_c_right) + side_c_cross)
    side_lo = (side_c - (side - side_right) + product_rest(normal_2, u2_2, side_d, side_right)
        + side_d_cross + side_c_lo)
    side_sum = side + side_lo
    side_sum_right = side_sum - side
    side_sum_lo = side - (side_sum - side_sum_right) + (side_lo - side_sum_right)
    q2_0b = side_sum < 0
    q2_0 = where(q2_0b, -normal_0, normal_0)
    q2_1 = where(q2_0b, -normal_1, normal_1)
    q2_2 = where(q2_0b, -normal_2, normal_2)
    size = absolute(side_sum)
    size_lo = where(side_sum < 0, -side_sum_lo, side_sum_lo)
    size_sum = size + size_lo
    size_sum_right = size_sum - size
    less_a = n_sum < size_sum
    less = where(less_a, n_sum, size_sum)
    dependent_a = (less
        + where(less_a, n_sum_lo, size - (size_sum - size_sum_right) + (size_lo - size_sum_right))
        < 1.7763568394002505e-15)
    dependent = where(dependent_a, real(1), real(0))
    Ro_00a = dependent == 1
    Ro_00 = where(Ro_00a, nan, q0_0)
    Ro_01 = where(Ro_00a, nan, q0_1)
    Ro_02 = where(Ro_00a, nan, q0_2)
    Ro_10 = where(Ro_00a, nan, q1_0)
    Ro_11 = where(Ro_00a, nan, q1_1)
    Ro_12 = where(Ro_00a, nan, q1_2)
    Ro_20 = where(Ro_00a, nan, q2_0)
    Ro_21 = where(Ro_00a, nan, q2_1)
    Ro_22 = where(Ro_00a, nan, q2_2)
    Ro_00_rounded = Ro_00 + where(Ro_00a, 0, q0_0_lo)
    Ro_01_rounded = Ro_01 + where(Ro_00a, 0, q0_1_lo)
    Ro_02_rounded = Ro_02 + where(Ro_00a, 0, q0_2_lo)
    Ro_10_rounded = Ro_10 + where(Ro_00a, 0, q1_0_lo)
    Ro_11_rounded = Ro_11 + where(Ro_00a, 0, q1_1_lo)
    Ro_12_rounded = Ro_12 + where(Ro_00a, 0, q1_2_lo)
    Ro_20_rounded = Ro_20 + where(Ro_00a, 0, where(q2_0b, -normal_0_lo, normal_0_lo))
    Ro_21_rounded = Ro_21 + where(Ro_00a, 0, where(q2_0b, -normal_1_lo, normal_1_lo))
    Ro_22_rounded = Ro_22 + where(Ro_00a, 0, where(q2_0b, -normal_2_lo, normal_2_lo))
    Ro_00_final = where(Ro_00_rounded == Ro_00_rounded, Ro_00_rounded, Ro_00)
    Ro_01_final = where(Ro_01_rounded == Ro_01_rounded, Ro_01_rounded, Ro_01)
    Ro_02_final = where(Ro_02_rounded == Ro_02_rounded, Ro_02_rounded, Ro_02)
    Ro_10_final = where(Ro_10_rounded == Ro_10_rounded, Ro_10_rounded, Ro_10)
    Ro_11_final = where(Ro_11_rounded == Ro_11_rounded, Ro_11_rounded, Ro_11)
    Ro_12_final = where(Ro_12_rounded == Ro_12_rounded, Ro_12_rounded, Ro_12)
    Ro_20_final = where(Ro_20_rounded == Ro_20_rounded, Ro_20_rounded, Ro_20)
    Ro_21_final = where(Ro_21_rounded == Ro_21_rounded, Ro_21_rounded, Ro_21)
    Ro_22_final = where(Ro_22_rounded == Ro_22_rounded, Ro_22_rounded, Ro_22)
    return (Ro_00_final, Ro_01_final, Ro_02_final, Ro_10_final, Ro_11_final, Ro_12_final,
        Ro_20_final, Ro_21_final, Ro_22_final)


@kernel("(3),(2)->(3,3)")
def mat3x3_setFromAxisDC(axis, dc):
    """R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
    dc = (sin θ, cos θ).

    (3),(2)->(3,3).  axis: vector; dc: (sin θ, cos θ); R: rotation or other 3×3 matrix.
    21 mul, 66 add, 3 product error, 15 product rest.  Error <= u |result| + 14 u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    axis_0, axis_1, axis_2 = axis
    dc_0, dc_1 = dc
    versine = 1 - dc_1
    versine_right = 1 - versine
    versine_lo = 1 - (versine + versine_right) - (dc_1 - versine_right)
    versine_axis_0 = axis_0 * versine
    versine_axis_1 = axis_1 * versine
    versine_axis_2 = axis_2 * versine
    versine_axis_0_lo = product_error(axis_0, versine, versine_axis_0) + axis_0 * versine_lo
    m_0 = axis_0 * versine_axis_0
    versine_axis_1_lo = product_error(axis_1, versine, versine_axis_1) + axis_1 * versine_lo
    m_1 = axis_1 * versine_axis_1
    m_2 = axis_2 * versine_axis_2
    m_3 = axis_1 * versine_axis_0
    m_3_cross2 = axis_1 * versine_axis_0_lo
    m_4 = axis_2 * versine_axis_0
    m_4_cross2 = axis_2 * versine_axis_0_lo
    m_5 = axis_2 * versine_axis_1
    m_5_cross2 = axis_2 * versine_axis_1_lo
    sine_axis_0 = axis_0 * dc_0
    sine_axis_1 = axis_1 * dc_0
    sine_axis_2 = axis_2 * dc_0
    R_00 = dc_1 + m_0
    R_00_right = R_00 - dc_1
    R_01 = m_3 - sine_axis_2
    R_01_right = m_3 - R_01
    R_02 = m_4 + sine_axis_1
    R_02_right = R_02 - m_4
    R_10 = m_3 + sine_axis_2
    R_10_right = R_10 - m_3
    R_11 = dc_1 + m_1
    R_11_right = R_11 - dc_1
    R_12 = m_5 - sine_axis_0
    R_12_right = m_5 - R_12
    R_20 = m_4 - sine_axis_1
    R_20_right = m_4 - R_20
    R_21 = m_5 + sine_axis_0
    R_21_right = R_21 - m_5
    R_22 = dc_1 + m_2
    R_22_right = R_22 - dc_1
    R_22_lo1 = dc_1 - (R_22 - R_22_right) + product_rest(axis_2, versine_axis_2, m_2, R_22_right)
    R_00_rounded = (R_00
        + (dc_1 - (R_00 - R_00_right) + product_rest(axis_0, versine_axis_0, m_0, R_00_right)
        + axis_0 * versine_axis_0_lo))
    R_01_lo = (product_rest(axis_1, versine_axis_0, m_3, R_01 + R_01_right)
        - product_rest(axis_2, dc_0, sine_axis_2, R_01_right) + m_3_cross2)
    R_01_rounded = R_01 + R_01_lo
    R_02_lo = (product_rest(axis_2, versine_axis_0, m_4, R_02 - R_02_right)
        + product_rest(axis_1, dc_0, sine_axis_1, R_02_right) + m_4_cross2)
    R_02_rounded = R_02 + R_02_lo
    R_10_lo = (product_rest(axis_1, versine_axis_0, m_3, R_10 - R_10_right)
        + product_rest(axis_2, dc_0, sine_axis_2, R_10_right) + m_3_cross2)
    R_10_rounded = R_10 + R_10_lo
    R_11_rounded = (R_11
        + (dc_1 - (R_11 - R_11_right) + product_rest(axis_1, versine_axis_1, m_1, R_11_right)
        + axis_1 * versine_axis_1_lo))
    R_12_lo = (product_rest(axis_2, versine_axis_1, m_5, R_12 + R_12_right)
        - product_rest(axis_0, dc_0, sine_axis_0, R_12_right) + m_5_cross2)
    R_12_rounded = R_12 + R_12_lo
    R_20_lo = (product_rest(axis_2, versine_axis_0, m_4, R_20 + R_20_right)
        - product_rest(axis_1, dc_0, sine_axis_1, R_20_right) + m_4_cross2)
    R_20_rounded = R_20 + R_20_lo
    R_21_lo = (product_rest(axis_2, versine_axis_1, m_5, R_21 - R_21_right)
        + product_rest(axis_0, dc_0, sine_axis_0, R_21_right) + m_5_cross2)
    R_21_rounded = R_21 + R_21_lo
    R_22_rounded = (R_22
        + (R_22_lo1 + axis_2
        * (product_error(axis_2, versine, versine_axis_2) + axis_2 * versine_lo)))
    return (R_00_rounded, R_01_rounded, R_02_rounded, R_10_rounded, R_11_rounded, R_12_rounded,
        R_20_rounded, R_21_rounded, R_22_rounded)


@kernel("(3)->(3,3)")
def mat3x3_from_euler_xyz(angles):
    """R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).

    (3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.
    291 mul, 434 add, 39 product error, 8 product rest, 3 div, 9 neg, 9 abs, 3 less, 9 equal, 12
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """
    angles_0, angles_1, angles_2 = angles
    s_0, c_0 = elementary.sincos(angles_0)
    s_0_own_error, c_0_own_error = elementary.sincos_error(angles_0, s_0, c_0)
    s_1, c_1 = elementary.sincos(angles_1)
    s_1_own_error, c_1_own_error = elementary.sincos_error(angles_1, s_1, c_1)
    s_2, c_2 = elementary.sincos(angles_2)
    s_2_own_error, c_2_own_error = elementary.sincos_error(angles_2, s_2, c_2)
    first_0 = c_1 * c_2
    first_1 = -(s_2 * c_1)
    first_6 = -(s_1 * c_2)
    first_7 = s_1 * s_2
    last_3a = s_2 * c_0
    first_6_lo = product_error(-s_1, c_2, first_6) + -(s_1_own_error * c_2 + s_1 * c_2_own_error)
    last_3b = s_0 * first_6
    last_3 = last_3a - last_3b
    last_3_right = last_3a - last_3
    last_3_lo1 = (product_rest(s_2, c_0, last_3a, last_3 + last_3_right)
        - product_rest(s_0, first_6, last_3b, last_3_right))
    last_4a = c_0 * c_2
    first_7_lo = product_error(s_1, s_2, first_7) + (s_1_own_error * s_2 + s_1 * s_2_own_error)
    last_4b = s_0 * first_7
    last_4 = last_4a - last_4b
    last_4_right = last_4a - last_4
    last_4_lo1 = (product_rest(c_0, c_2, last_4a, last_4 + last_4_right)
        - product_rest(s_0, first_7, last_4b, last_4_right))
    last_5 = -(s_0 * c_1)
    last_6a = s_0 * s_2
    last_6b = c_0 * first_6
    last_6 = last_6a + last_6b
    last_6_right = last_6 - last_6a
    last_6_lo1 = (product_rest(s_0, s_2, last_6a, last_6 - last_6_right)
        + product_rest(c_0, first_6, last_6b, last_6_right))
    last_7a = s_0 * c_2
    last_7b = c_0 * first_7
    last_7 = last_7a + last_7b
    last_7_right = last_7 - last_7a
    last_7_lo1 = (product_rest(s_0, c_2, last_7a, last_7 - last_7_right)
        + product_rest(c_0, first_7, last_7b, last_7_right))
    last_8 = c_0 * c_1
    first_0_rounded = (first_0
        + (product_error(c_1, c_2, first_0) + (c_1_own_error * c_2 + c_1 * c_2_own_error)))
    first_1_rounded = (first_1
        + (product_error(-s_2, c_1, first_1) + -(s_2_own_error * c_1 + s_2 * c_1_own_error)))
    s_1_rounded = s_1 + s_1_own_error
    last_3_rounded = (last_3
        + (last_3_lo1
        + (s_2_own_error * c_0 + s_2 * c_0_own_error
        - (s_0_own_error * first_6 + s_0 * first_6_lo))))
    last_4_rounded = (last_4
        + (last_4_lo1
        + (c_0_own_error * c_2 + c_0 * c_2_own_error
        - (s_0_own_error * first_7 + s_0 * first_7_lo))))
    last_5_rounded = (last_5
        + (product_error(-s_0, c_1, last_5) + -(s_0_own_error * c_1 + s_0 * c_1_own_error)))
    last_6_rounded = (last_6
        + (last_6_lo1
        + (s_0_own_error * s_2 + s_0 * s_2_own_error
        + (c_0_own_error * first_6 + c_0 * first_6_lo))))
    last_7_rounded = (last_7
        + (last_7_lo1
        + (s_0_own_error * c_2 + s_0 * c_2_own_error
        + (c_0_own_error * first_7 + c_0 * first_7_lo))))
    last_8_rounded = (last_8
        + (product_error(c_0, c_1, last_8) + (c_0_own_error * c_1 + c_0 * c_1_own_error)))
    first_0_final = where(first_0_rounded == first_0_rounded, first_0_rounded, first_0)
    first_1_final = where(first_1_rounded == first_1_rounded, first_1_rounded, first_1)
    s_1_final = where(s_1_rounded == s_1_rounded, s_1_rounded, s_1)
    last_3_final = where(last_3_rounded == last_3_rounded, last_3_rounded, last_3)
    last_4_final = where(last_4_rounded == last_4_rounded, last_4_rounded, last_4)
    last_5_final = where(last_5_rounded == last_5_rounded, last_5_rounded, last_5)
    last_6_final = where(last_6_rounded == last_6_rounded, last_6_rounded, last_6)
    last_7_final = where(last_7_rounded == last_7_rounded, last_7_rounded, last_7)
    last_8_final = where(last_8_rounded == last_8_rounded, last_8_rounded, last_8)
    return (first_0_final, first_1_final, s_1_final, last_3_final, last_4_final, last_5_final,
        last_6_final, last_7_final, last_8_final)


@kernel("(3,3)->(3)")
def euler_xyz_from_mat3x3(R):
    """angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
    [-π/2, π/2]; c = 0 in gimbal lock.

    (3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.
    391 mul, 713 add, 66 product error, 6 product rest, 17 div, 1 sqrt, 4 neg, 28 abs, 12
    copysign, 42 less, 16 equal, 87 select.  Each component is within 1 ulp as long as its
    condition is below 1e13; in single precision it is the nearest number, except near ties, as
    long as that is below 1e5; searched, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_a = R_00 * R_00
    n_b = R_01 * R_01
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_c_lo = (product_rest(R_00, R_00, n_a, n_c - n_c_right)
        + product_rest(R_01, R_01, n_b, n_c_right))
    n_c_sum = n_c + n_c_lo
    n_c_sum_right = n_c_sum - n_c
    n = sqrt(n_c_sum)
    n_product = n * n
    n_lo = ((n_c_sum - n_product - product_error(n, n, n_product)
        + (n_c - (n_c_sum - n_c_sum_right) + (n_c_lo - n_c_sum_right))) / where(n == 0, 1, n + n))
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right)
    divisor_a = n_sum == 0
    divisor = where(divisor_a, 1, n_sum)
    divisor_lo = where(divisor_a, 0, n_sum_lo)
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    cosine_a = R_00 / divisor_sum
    cosine_a_product = cosine_a * divisor_sum
    cosine = where(divisor_a, 1, cosine_a)
    cosine_a_lo = ((R_00 - cosine_a_product
        - product_error(cosine_a, divisor_sum, cosine_a_product) - cosine_a * divisor_sum_lo)
        / divisor_sum)
    cosine_lo = where(divisor_a, 0, cosine_a_lo)
    sine_a = -R_01
    sine = sine_a / divisor_sum
    sine_product = sine * divisor_sum
    sine_lo = ((sine_a - sine_product - product_error(sine, divisor_sum, sine_product) - sine
        * divisor_sum_lo) / divisor_sum)
    polar = elementary.atan2(sine_a, R_00)
    third = where(divisor_a, 0, polar)
    left_1a = R_10 * sine
    left_1b = R_11 * cosine
    left_1 = left_1a + left_1b
    left_1_right = left_1 - left_1a
    left_1_lo1 = (product_rest(R_10, sine, left_1a, left_1 - left_1_right)
        + product_rest(R_11, cosine, left_1b, left_1_right))
    left_1_lo = left_1_lo1 + (R_10 * sine_lo + R_11 * cosine_lo)
    left_2a = R_20 * sine
    left_2b = R_21 * cosine
    left_2 = left_2a + left_2b
    left_2_right = left_2 - left_2a
    left_2_lo1 = (product_rest(R_20, sine, left_2a, left_2 - left_2_right)
        + product_rest(R_21, cosine, left_2b, left_2_right))
    left_2_lo = left_2_lo1 + (R_20 * sine_lo + R_21 * cosine_lo)
    rest = R_12 + R_22
    rest_right = rest - R_12
    rest_lo = R_12 - (rest - rest_right) + (R_22 - rest_right)
    left_2_sum = left_2 + left_2_lo
    left_2_sum_right = left_2_sum - left_2
    left_1_sum = left_1 + left_1_lo
    left_1_sum_right = left_1_sum - left_1
    first = elementary.atan2(left_2_sum, left_1_sum)
    first_size0 = absolute(left_2_sum)
    first_size1 = absolute(left_1_sum)
    first_most = where(first_size0 < first_size1, first_size1, first_size0)
    first_zero = first_most == 0
    first_divisor = where(first_zero, 1, first_most)
    first_part0 = left_2_sum / first_divisor
    first_part1 = left_1_sum / first_divisor
    first_cross1 = (first_part1
        * (left_2 - (left_2_sum - left_2_sum_right) + (left_2_lo - left_2_sum_right)))
    first_cross = (first_cross1 - first_part0
        * (left_1 - (left_1_sum - left_1_sum_right) + (left_1_lo - left_1_sum_right)))
    first_more = (first_cross
        / where(first_zero, 1, first_divisor
        * (first_part1 * first_part1 + first_part0 * first_part0)))
    rest_sum = rest + rest_lo
    rest_sum_right = rest_sum - rest
    angles_0a = rest_sum < 1.2676506002282294e+30
    angles_0 = where(angles_0a, first, rest_sum)
    first_lo = elementary.atan2_error(left_2_sum, left_1_sum, first) + first_more
    angles_1 = elementary.atan2(R_02, n_sum)
    angles_1_size0 = absolute(R_02)
    angles_1_size1 = absolute(n_sum)
    angles_1_most = where(angles_1_size0 < angles_1_size1, angles_1_size1, angles_1_size0)
    angles_1_zero = angles_1_most == 0
    angles_1_divisor = where(angles_1_zero, 1, angles_1_most)
    angles_1_part0 = R_02 / angles_1_divisor
    angles_1_part1 = n_sum / angles_1_divisor
    angles_1_safe = where(angles_1_zero, 1,
        angles_1_divisor * (angles_1_part1 * angles_1_part1 + angles_1_part0 * angles_1_part0))
    angles_0_rounded = (angles_0
        + where(angles_0a, first_lo, rest - (rest_sum - rest_sum_right)
        + (rest_lo - rest_sum_right)))
    angles_1_rounded = (angles_1
        + (elementary.atan2_error(R_02, n_sum, angles_1)
        + (angles_1_part1 * 0 - angles_1_part0 * n_sum_lo) / angles_1_safe))
    third_rounded = third + where(divisor_a, 0, elementary.atan2_error(sine_a, R_00, polar))
    angles_0_final = where(angles_0_rounded == angles_0_rounded, angles_0_rounded, angles_0)
    angles_1_final = where(angles_1_rounded == angles_1_rounded, angles_1_rounded, angles_1)
    third_final = where(third_rounded == third_rounded, third_rounded, third)
    return (angles_0_final, angles_1_final, third_final)


@kernel("(3)->(3,3)")
def mat3x3_from_euler_xyx(angles):
    """R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).

    (3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.
    291 mul, 434 add, 39 product error, 8 product rest, 3 div, 5 neg, 9 abs, 3 less, 9 equal, 12
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """
    angles_0, angles_1, angles_2 = angles
    s_0, c_0 = elementary.sincos(angles_0)
    s_0_own_error, c_0_own_error = elementary.sincos_error(angles_0, s_0, c_0)
    s_1, c_1 = elementary.sincos(angles_1)
    s_1_own_error, c_1_own_error = elementary.sincos_error(angles_1, s_1, c_1)
    s_2, c_2 = elementary.sincos(angles_2)
    s_2_own_error, c_2_own_error = elementary.sincos_error(angles_2, s_2, c_2)
    first_1 = s_1 * s_2
    first_2 = s_1 * c_2
    first_7 = s_2 * c_1
    first_8 = c_1 * c_2
    last_3 = s_0 * s_1
    last_4a = c_0 * c_2
    first_7_lo = product_error(s_2, c_1, first_7) + (s_2_own_error * c_1 + s_2 * c_1_own_error)
    last_4b = s_0 * first_7
    last_4 = last_4a - last_4b
    last_4_right = last_4a - last_4
    last_4_lo1 = (product_rest(c_0, c_2, last_4a, last_4 + last_4_right)
        - product_rest(s_0, first_7, last_4b, last_4_right))
    first_8_lo = product_error(c_1, c_2, first_8) + (c_1_own_error * c_2 + c_1 * c_2_own_error)
    last_5a = s_0 * first_8
    last_5b = s_2 * c_0
    last_5c = last_5a + last_5b
    last_5c_right = last_5c - last_5a
    last_5c_lo1 = (product_rest(s_0, first_8, last_5a, last_5c - last_5c_right)
        + product_rest(s_2, c_0, last_5b, last_5c_right))
    last_5 = -last_5c
    last_6 = -(s_1 * c_0)
    last_7a = s_0 * c_2
    last_7b = c_0 * first_7
    last_7 = last_7a + last_7b
    last_7_right = last_7 - last_7a
    last_7_lo1 = (product_rest(s_0, c_2, last_7a, last_7 - last_7_right)
        + product_rest(c_0, first_7, last_7b, last_7_right))
    last_8a = c_0 * first_8
    last_8b = s_0 * s_2
    last_8 = last_8a - last_8b
    last_8_right = last_8a - last_8
    last_8_lo1 = (product_rest(c_0, first_8, last_8a, last_8 + last_8_right)
        - product_rest(s_0, s_2, last_8b, last_8_right))
    c_1_rounded = c_1 + c_1_own_error
    first_1_rounded = (first_1
        + (product_error(s_1, s_2, first_1) + (s_1_own_error * s_2 + s_1 * s_2_own_error)))
    first_2_rounded = (first_2
        + (product_error(s_1, c_2, first_2) + (s_1_own_error * c_2 + s_1 * c_2_own_error)))
    last_3_rounded = (last_3
        + (product_error(s_0, s_1, last_3) + (s_0_own_error * s_1 + s_0 * s_1_own_error)))
    last_4_rounded = (last_4
        + (last_4_lo1
        + (c_0_own_error * c_2 + c_0 * c_2_own_error
        - (s_0_own_error * first_7 + s_0 * first_7_lo))))
    last_5_rounded = (last_5 +
        -(last_5c_lo1
        + (s_0_own_error * first_8 + s_0 * first_8_lo
        + (s_2_own_error * c_0 + s_2 * c_0_own_error))))
    last_6_rounded = (last_6
        + (product_error(-s_1, c_0, last_6) + -(s_1_own_error * c_0 + s_1 * c_0_own_error)))
    last_7_rounded = (last_7
        + (last_7_lo1
        + (s_0_own_error * c_2 + s_0 * c_2_own_error
        + (c_0_own_error * first_7 + c_0 * first_7_lo))))
    last_8_rounded = (last_8
        + (last_8_lo1
        + (c_0_own_error * first_8 + c_0 * first_8_lo
        - (s_0_own_error * s_2 + s_0 * s_2_own_error))))
    c_1_final = where(c_1_rounded == c_1_rounded, c_1_rounded, c_1)
    first_1_final = where(first_1_rounded == first_1_rounded, first_1_rounded, first_1)
    first_2_final = where(first_2_rounded == first_2_rounded, first_2_rounded, first_2)
    last_3_final = where(last_3_rounded == last_3_rounded, last_3_rounded, last_3)
    last_4_final = where(last_4_rounded == last_4_rounded, last_4_rounded, last_4)
    last_5_final = where(last_5_rounded == last_5_rounded, last_5_rounded, last_5)
    last_6_final = where(last_6_rounded == last_6_rounded, last_6_rounded, last_6)
    last_7_final = where(last_7_rounded == last_7_rounded, last_7_rounded, last_7)
    last_8_final = where(last_8_rounded == last_8_rounded, last_8_rounded, last_8)
    return (c_1_final, first_1_final, first_2_final, last_3_final, last_4_final, last_5_final,
        last_6_final, last_7_final, last_8_final)


@kernel("(3,3)->(3)")
def euler_xyx_from_mat3x3(R):
    """angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in
    [0, π]; c = 0 in gimbal lock.

    (3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.
    391 mul, 713 add, 66 product error, 6 product rest, 17 div, 1 sqrt, 3 neg, 28 abs, 12
    copysign, 42 less, 16 equal, 87 select.  Each component is within 1 ulp as long as its
    condition is below 1e13; in single precision it is the nearest number, except near ties, as
    long as that is below 1e5; searched, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_a = R_01 * R_01
    n_b = R_02 * R_02
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_c_lo = (product_rest(R_01, R_01, n_a, n_c - n_c_right)
        + product_rest(R_02, R_02, n_b, n_c_right))
    n_c_sum = n_c + n_c_lo
    n_c_sum_right = n_c_sum - n_c
    n = sqrt(n_c_sum)
    n_product = n * n
    n_lo = ((n_c_sum - n_product - product_error(n, n, n_product)
        + (n_c - (n_c_sum - n_c_sum_right) + (n_c_lo - n_c_sum_right))) / where(n == 0, 1, n + n))
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right)
    divisor_a = n_sum == 0
    divisor = where(divisor_a, 1, n_sum)
    divisor_lo = where(divisor_a, 0, n_sum_lo)
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    cosine_a = R_02 / divisor_sum
    cosine_a_product = cosine_a * divisor_sum
    cosine = where(divisor_a, 1, cosine_a)
    cosine_a_lo = ((R_02 - cosine_a_product
        - product_error(cosine_a, divisor_sum, cosine_a_product) - cosine_a * divisor_sum_lo)
        / divisor_sum)
    cosine_lo = where(divisor_a, 0, cosine_a_lo)
    sine = R_01 / divisor_sum
    sine_product = sine * divisor_sum
    sine_lo = ((R_01 - sine_product - product_error(sine, divisor_sum, sine_product) - sine
        * divisor_sum_lo) / divisor_sum)
    polar = elementary.atan2(R_01, R_02)
    third = where(divisor_a, 0, polar)
    left_1a = R_11 * cosine
    left_1b = R_12 * sine
    left_1 = left_1a - left_1b
    left_1_right = left_1a - left_1
    left_1_lo1 = (product_rest(R_11, cosine, left_1a, left_1 + left_1_right)
        - product_rest(R_12, sine, left_1b, left_1_right))
    left_1_lo = left_1_lo1 + (R_11 * cosine_lo - R_12 * sine_lo)
    left_2a = R_21 * cosine
    left_2b = R_22 * sine
    left_2 = left_2a - left_2b
    left_2_right = left_2a - left_2
    left_2_lo1 = (product_rest(R_21, cosine, left_2a, left_2 + left_2_right)
        - product_rest(R_22, sine, left_2b, left_2_right))
    left_2_lo = left_2_lo1 + (R_21 * cosine_lo - R_22 * sine_lo)
    rest = R_10 + R_20
    rest_right = rest - R_10
    rest_lo = R_10 - (rest - rest_right) + (R_20 - rest_right)
    left_2_sum = left_2 + left_2_lo
    left_2_sum_right = left_2_sum - left_2
    left_1_sum = left_1 + left_1_lo
    left_1_sum_right = left_1_sum - left_1
    first = elementary.atan2(left_2_sum, left_1_sum)
    first_size0 = absolute(left_2_sum)
    first_size1 = absolute(left_1_sum)
    first_most = where(first_size0 < first_size1, first_size1, first_size0)
    first_zero = first_most == 0
    first_divisor = where(first_zero, 1, first_most)
    first_part0 = left_2_sum / first_divisor
    first_part1 = left_1_sum / first_divisor
    first_cross1 = (first_part1
        * (left_2 - (left_2_sum - left_2_sum_right) + (left_2_lo - left_2_sum_right)))
    first_cross = (first_cross1 - first_part0
        * (left_1 - (left_1_sum - left_1_sum_right) + (left_1_lo - left_1_sum_right)))
    first_more = (first_cross
        / where(first_zero, 1, first_divisor
        * (first_part1 * first_part1 + first_part0 * first_part0)))
    rest_sum = rest + rest_lo
    rest_sum_right = rest_sum - rest
    angles_0a = rest_sum < 1.2676506002282294e+30
    angles_0 = where(angles_0a, first, rest_sum)
    first_lo = elementary.atan2_error(left_2_sum, left_1_sum, first) + first_more
    angles_1 = elementary.atan2(n_sum, R_00)
    angles_1_size0 = absolute(n_sum)
    angles_1_size1 = absolute(R_00)
    angles_1_most = where(angles_1_size0 < angles_1_size1, angles_1_size1, angles_1_size0)
    angles_1_zero = angles_1_most == 0
    angles_1_divisor = where(angles_1_zero, 1, angles_1_most)
    angles_1_part0 = n_sum / angles_1_divisor
    angles_1_part1 = R_00 / angles_1_divisor
    angles_1_safe = where(angles_1_zero, 1,
        angles_1_divisor * (angles_1_part1 * angles_1_part1 + angles_1_part0 * angles_1_part0))
    angles_0_rounded = (angles_0
        + where(angles_0a, first_lo, rest - (rest_sum - rest_sum_right)
        + (rest_lo - rest_sum_right)))
    angles_1_rounded = (angles_1
        + (elementary.atan2_error(n_sum, R_00, angles_1)
        + (angles_1_part1 * n_sum_lo - angles_1_part0 * 0) / angles_1_safe))
    third_rounded = third + where(divisor_a, 0, elementary.atan2_error(R_01, R_02, polar))
    angles_0_final = where(angles_0_rounded == angles_0_rounded, angles_0_rounded, angles_0)
    angles_1_final = where(angles_1_rounded == angles_1_rounded, angles_1_rounded, angles_1)
    third_final = where(third_rounded == third_rounded, third_rounded, third)
    return (angles_0_final, angles_1_final, third_final)


@kernel("(3,3),(3,3)->(3,3),(3,3)")
def mat3x3_jacobi(A, V):
    """A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes
    A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.
    Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.

    (3,3),(3,3)->(3,3),(3,3).  A, V: rotation or other 3×3 matrix.
    51 mul, 153 add, 6 product error, 20 product rest, 8 div, 2 sqrt, 3 neg, 1 abs, 2 less, 13
    equal, 18 select.  V A V^T changes by at most 28 u max |A| for orthonormal V; searched, not
    proved.
    """
    A_00, A_01, A_02, A_10, A_11, A_12, A_20, A_21, A_22 = A
    V_00, V_01, V_02, V_10, V_11, V_12, V_20, V_21, V_22 = V
    twice = 2 * A_10
    apart = A_11 - A_00
    apart_right = A_11 - apart
    apart_lo = A_11 - (apart + apart_right) - (A_00 - apart_right)
    divisor_a = twice == 0
    divisor = where(divisor_a, 1, twice)
    apart_sum = apart + apart_lo
    apart_sum_right = apart_sum - apart
    theta = apart_sum / divisor
    theta_product = theta * divisor
    theta_exact = apart_sum - theta_product - product_error(theta, divisor, theta_product)
    theta_lo = ((theta_exact
        + (apart - (apart_sum - apart_sum_right) + (apart_lo - apart_sum_right))) / divisor)
    theta_sum = theta + theta_lo
    theta_sum_right = theta_sum - theta
    theta_sum_lo = theta - (theta_sum - theta_sum_right) + (theta_lo - theta_sum_right)
    magnitude = absolute(theta_sum)
    size_a = theta_sum * theta_sum
    size_b = 1 + size_a
    size_b_right = size_b - 1
    size_b_lo1 = (1 - (size_b - size_b_right)
        + product_rest(theta_sum, theta_sum, size_a, size_b_right))
    size_b_lo = size_b_lo1 + (theta_sum_lo * theta_sum + theta_sum * theta_sum_lo)
    size_b_sum = size_b + size_b_lo
    size_b_sum_right = size_b_sum - size_b
    size_c = sqrt(size_b_sum)
    size_c_product = size_c * size_c
    size_c_exact = size_b_sum - size_c_product - product_error(size_c, size_c, size_c_product)
    size = magnitude + size_c
    size_right = size - magnitude
    size_c_lo = ((size_c_exact
        + (size_b - (size_b_sum - size_b_sum_right) + (size_b_lo - size_b_sum_right)))
        / where(size_c == 0, 1, size_c + size_c))
    size_lo = (magnitude - (size - size_right) + (size_c - size_right) + size_c_lo
        + where(theta_sum < 0, -theta_sum_lo, theta_sum_lo))
    along_b = theta_sum < 0
    along = where(along_b, -size, size)
    along_lo = where(along_b, -size_lo, size_lo)
    along_sum = along + along_lo
    along_sum_right = along_sum - along
    t_a = 1 / along_sum
    t_a_product = t_a * along_sum
    t_a_cross = t_a * (along - (along_sum - along_sum_right) + (along_lo - along_sum_right))
    t = where(divisor_a, 0, t_a)
    t_lo = where(divisor_a, 0, (1 - t_a_product - product_error(t_a, along_sum,
        t_a_product) - t_a_cross) / along_sum)
    secant_a = t * t
    secant_b = 1 + secant_a
    secant_b_right = secant_b - 1
    secant_b_lo = (1 - (secant_b - secant_b_right) + product_rest(t, t, secant_a, secant_b_right)
        + (t_lo * t + t * t_lo))
    secant_b_sum = secant_b + secant_b_lo
    secant_b_sum_right = secant_b_sum - secant_b
    secant = sqrt(secant_b_sum)
    secant_product = secant * secant
    secant_b_sum_lo = (secant_b - (secant_b_sum - secant_b_sum_right)
        + (secant_b_lo - secant_b_sum_right))
    secant_lo = ((secant_b_sum - secant_product - product_error(secant, secant, secant_product)
        + secant_b_sum_lo) / where(secant == 0, 1, secant + secant))
    secant_sum = secant + secant_lo
    secant_sum_right = secant_sum - secant
    c = 1 / secant_sum
    c_product = c * secant_sum
    c_residual = (1 - c_product - product_error(c, secant_sum, c_product) - c
        * (secant - (secant_sum - secant_sum_right) + (secant_lo - secant_sum_right)))
    c_lo = c_residual / secant_sum
    s = t * c
    change = A_10 * t
    change_cross2 = A_10 * t_lo
    zp_a = A_20 * c
    s_lo = product_error(t, c, s) + (t_lo * c + t * c_lo)
    zp_b = A_21 * s
    zp = zp_a - zp_b
    zp_right = zp_a - zp
    zq_a = A_20 * s
    zq_b = A_21 * c
    zq = zq_a + zq_b
    zq_right = zq - zq_a
    vp_0a = V_00 * c
    vp_0b = V_01 * s
    vp_0 = vp_0a - vp_0b
    vp_0_right = vp_0a - vp_0
    vp_1a = V_10 * c
    vp_1b = V_11 * s
    vp_1 = vp_1a - vp_1b
    vp_1_right = vp_1a - vp_1
    vp_2a = V_20 * c
    vp_2b = V_21 * s
    vp_2 = vp_2a - vp_2b
    vp_2_right = vp_2a - vp_2
    vq_0a = V_00 * s
    vq_0b = V_01 * c
    vq_0 = vq_0a + vq_0b
    vq_0_right = vq_0 - vq_0a
    vq_1a = V_10 * s
    vq_1b = V_11 * c
    vq_1 = vq_1a + vq_1b
    vq_1_right = vq_1 - vq_1a
    vq_2a = V_20 * s
    vq_2b = V_21 * c
    vq_2 = vq_2a + vq_2b
    vq_2_right = vq_2 - vq_2a
    A_00_new = A_11 + change
    A_00_new_right = A_00_new - A_11
    A_22_new = A_00 - change
    A_22_new_right = A_00 - A_22_new
    A_00_new_rounded = (A_00_new
        + (A_11 - (A_00_new - A_00_new_right) + product_rest(A_10, t, change, A_00_new_right)
        + change_cross2))
    zq_rounded = (zq
        + (product_rest(A_20, s, zq_a, zq - zq_right) + product_rest(A_21, c, zq_b, zq_right)
        + (A_20 * s_lo + A_21 * c_lo)))
    zq_final = where(zq_rounded == zq_rounded, zq_rounded, zq)
    zp_rounded = (zp
        + (product_rest(A_20, c, zp_a, zp + zp_right) - product_rest(A_21, s, zp_b, zp_right)
        + (A_20 * c_lo - A_21 * s_lo)))
    zp_final = where(zp_rounded == zp_rounded, zp_rounded, zp)
    A_22_new_rounded = (A_22_new
        + (A_00 - (A_22_new + A_22_new_right) - product_rest(A_10, t, change, A_22_new_right)
        - change_cross2))
    vq_0_rounded = (vq_0
        + (product_rest(V_00, s, vq_0a, vq_0 - vq_0_right)
        + product_rest(V_01, c, vq_0b, vq_0_right) + (V_00 * s_lo + V_01 * c_lo)))
    vp_0_rounded = (vp_0
        + (product_rest(V_00, c, vp_0a, vp_0 + vp_0_right)
        - product_rest(V_01, s, vp_0b, vp_0_right) + (V_00 * c_lo - V_01 * s_lo)))
    vq_1_rounded = (vq_1
        + (product_rest(V_10, s, vq_1a, vq_1 - vq_1_right)
        + product_rest(V_11, c, vq_1b, vq_1_right) + (V_10 * s_lo + V_11 * c_lo)))
    vp_1_rounded = (vp_1
        + (product_rest(V_10, c, vp_1a, vp_1 + vp_1_right)
        - product_rest(V_11, s, vp_1b, vp_1_right) + (V_10 * c_lo - V_11 * s_lo)))
    vq_2_rounded = (vq_2
        + (product_rest(V_20, s, vq_2a, vq_2 - vq_2_right)
        + product_rest(V_21, c, vq_2b, vq_2_right) + (V_20 * s_lo + V_21 * c_lo)))
    vp_2_rounded = (vp_2
        + (product_rest(V_20, c, vp_2a, vp_2 + vp_2_right)
        - product_rest(V_21, s, vp_2b, vp_2_right) + (V_20 * c_lo - V_21 * s_lo)))
    A_00_new_final = where(A_00_new_rounded == A_00_new_rounded, A_00_new_rounded, A_00_new)
    A_22_new_final = where(A_22_new_rounded == A_22_new_rounded, A_22_new_rounded, A_22_new)
    vq_0_final = where(vq_0_rounded == vq_0_rounded, vq_0_rounded, vq_0)
    vp_0_final = where(vp_0_rounded == vp_0_rounded, vp_0_rounded, vp_0)
    vq_1_final = where(vq_1_rounded == vq_1_rounded, vq_1_rounded, vq_1)
    vp_1_final = where(vp_1_rounded == vp_1_rounded, vp_1_rounded, vp_1)
    vq_2_final = where(vq_2_rounded == vq_2_rounded, vq_2_rounded, vq_2)
    vp_2_final = where(vp_2_rounded == vp_2_rounded, vp_2_rounded, vp_2)
    return (A_00_new_final, zq_final, 0, zq_final, A_22, zp_final, 0, zp_final, A_22_new_final,
        vq_0_final, V_02, vp_0_final, vq_1_final, V_12, vp_1_final, vq_2_final, V_22, vp_2_final)


@kernel("(3,3)->()")
def mat3x3_rotation_defect(R):
    """the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if
    an entry is NaN.

    (3,3)->().  R: rotation or other 3×3 matrix; defect: number.
    30 mul, 228 add, 27 product rest, 7 neg, 7 abs, 13 less, 19 select.  Error <= 6 u near a
    rotation; measured, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_0a = R_11 * R_22
    n_0b = R_12 * R_21
    n_0 = n_0a - n_0b
    n_0_right = n_0a - n_0
    n_1a = R_02 * R_21
    n_1b = R_01 * R_22
    n_1 = n_1a - n_1b
    n_1_right = n_1a - n_1
    n_2a = R_01 * R_12
    n_2b = R_02 * R_11
    n_2 = n_2a - n_2b
    n_2_right = n_2a - n_2
    det_a = R_00 * n_0
    det_b = R_10 * n_1
    det_c = det_a + det_b
    det_c_right = det_c - det_a
    det_a_cross2 = (R_00
        * (product_rest(R_11, R_22, n_0a, n_0 + n_0_right)
        - product_rest(R_12, R_21, n_0b, n_0_right)))
    det_c_cross = (det_a_cross2 + R_10
        * (product_rest(R_02, R_21, n_1a, n_1 + n_1_right)
        - product_rest(R_01, R_22, n_1b, n_1_right)))
    det_d = R_20 * n_2
    det = det_c + det_d
    det_right = det - det_c
    det_d_cross2 = (R_20
        * (product_rest(R_01, R_12, n_2a, n_2 + n_2_right)
        - product_rest(R_02, R_11, n_2b, n_2_right)))
    det_c_lo = (product_rest(R_00, n_0, det_a, det_c - det_c_right)
        + product_rest(R_10, n_1, det_b, det_c_right) + det_c_cross)
    g_0a = R_00 * R_00
    g_0b = R_10 * R_10
    g_0c = g_0a + g_0b
    g_0c_right = g_0c - g_0a
    g_0d = R_20 * R_20
    g_0 = g_0c + g_0d
    g_0_right = g_0 - g_0c
    g_0c_lo = (product_rest(R_00, R_00, g_0a, g_0c - g_0c_right)
        + product_rest(R_10, R_10, g_0b, g_0c_right))
    g_1a = R_00 * R_01
    g_1b = R_10 * R_11
    g_1c = g_1a + g_1b
    g_1c_right = g_1c - g_1a
    g_1d = R_20 * R_21
    g_1 = g_1c + g_1d
    g_1_right = g_1 - g_1c
    g_1c_lo = (product_rest(R_00, R_01, g_1a, g_1c - g_1c_right)
        + product_rest(R_10, R_11, g_1b, g_1c_right))
    g_1_lo = g_1c - (g_1 - g_1_right) + product_rest(R_20, R_21, g_1d, g_1_right) + g_1c_lo
    g_2a = R_00 * R_02
    g_2b = R_10 * R_12
    g_2c = g_2a + g_2b
    g_2c_right = g_2c - g_2a
    g_2d = R_20 * R_22
    g_2 = g_2c + g_2d
    g_2_right = g_2 - g_2c
    g_2c_lo = (product_rest(R_00, R_02, g_2a, g_2c - g_2c_right)
        + product_rest(R_10, R_12, g_2b, g_2c_right))
    g_2_lo = g_2c - (g_2 - g_2_right) + product_rest(R_20, R_22, g_2d, g_2_right) + g_2c_lo
    g_3a = R_01 * R_01
    g_3b = R_11 * R_11
    g_3c = g_3a + g_3b
    g_3c_right = g_3c - g_3a
    g_3d = R_21 * R_21
    g_3 = g_3c + g_3d
    g_3_right = g_3 - g_3c
    g_3c_lo = (product_rest(R_01, R_01, g_3a, g_3c - g_3c_right)
        + product_rest(R_11, R_11, g_3b, g_3c_right))
    g_4a = R_01 * R_02
    g_4b = R_11 * R_12
    g_4c = g_4a + g_4b
    g_4c_right = g_4c - g_4a
    g_4d = R_21 * R_22
    g_4 = g_4c + g_4d
    g_4_right = g_4 - g_4c
    g_4c_lo = (product_rest(R_01, R_02, g_4a, g_4c - g_4c_right)
        + product_rest(R_11, R_12, g_4b, g_4c_right))
    g_4_lo = g_4c - (g_4 - g_4_right) + product_rest(R_21, R_22, g_4d, g_4_right) + g_4c_lo
    g_5a = R_02 * R_02
    g_5b = R_12 * R_12
    g_5c = g_5a + g_5b
    g_5c_right = g_5c - g_5a
    g_5d = R_22 * R_22
    g_5 = g_5c + g_5d
    g_5_right = g_5 - g_5c
    g_5c_lo = (product_rest(R_02, R_02, g_5a, g_5c - g_5c_right)
        + product_rest(R_12, R_12, g_5b, g_5c_right))
    off_0 = det - 1
    off_0_right = det - off_0
    det_lo = (det_c - (det - det_right) + product_rest(R_20, n_2, det_d, det_right) + det_d_cross2
        + det_c_lo)
    off_0_lo = det - (off_0 + off_0_right) - (1 - off_0_right) + det_lo
    off_1 = g_0 - 1
    off_1_right = g_0 - off_1
    off_1_lo = (g_0 - (off_1 + off_1_right) - (1 - off_1_right)
        + (g_0c - (g_0 - g_0_right) + product_rest(R_20, R_20, g_0d, g_0_right) + g_0c_lo))
    off_4 = g_3 - 1
    off_4_right = g_3 - off_4
    off_4_lo = (g_3 - (off_4 + off_4_right) - (1 - off_4_right)
        + (g_3c - (g_3 - g_3_right) + product_rest(R_21, R_21, g_3d, g_3_right) + g_3c_lo))
    off_6 = g_5 - 1
    off_6_right = g_5 - off_6
    off_6_lo = (g_5 - (off_6 + off_6_right) - (1 - off_6_right)
        + (g_5c - (g_5 - g_5_right) + product_rest(R_22, R_22, g_5d, g_5_right) + g_5c_lo))
    off_0_sum = off_0 + off_0_lo
    off_0_sum_right = off_0_sum - off_0
    off_0_sum_lo = off_0 - (off_0_sum - off_0_sum_right) + (off_0_lo - off_0_sum_right)
    defect_size_0 = absolute(off_0_sum)
    defect_size_0_lo = where(off_0_sum < 0, -off_0_sum_lo, off_0_sum_lo)
    off_1_sum = off_1 + off_1_lo
    off_1_sum_right = off_1_sum - off_1
    off_1_sum_lo = off_1 - (off_1_sum - off_1_sum_right) + (off_1_lo - off_1_sum_right)
    defect_size_1 = absolute(off_1_sum)
    defect_size_1_lo = where(off_1_sum < 0, -off_1_sum_lo, off_1_sum_lo)
    g_1_sum = g_1 + g_1_lo
    g_1_sum_right = g_1_sum - g_1
    g_1_sum_lo = g_1 - (g_1_sum - g_1_sum_right) + (g_1_lo - g_1_sum_right)
    defect_size_2 = absolute(g_1_sum)
    defect_size_2_lo = where(g_1_sum < 0, -g_1_sum_lo, g_1_sum_lo)
    g_2_sum = g_2 + g_2_lo
    g_2_sum_right = g_2_sum - g_2
    g_2_sum_lo = g_2 - (g_2_sum - g_2_sum_right) + (g_2_lo - g_2_sum_right)
    defect_size_3 = absolute(g_2_sum)
    defect_size_3_lo = where(g_2_sum < 0, -g_2_sum_lo, g_2_sum_lo)
    off_4_sum = off_4 + off_4_lo
    off_4_sum_right = off_4_sum - off_4
    off_4_sum_lo = off_4 - (off_4_sum - off_4_sum_right) + (off_4_lo - off_4_sum_right)
    defect_size_4 = absolute(off_4_sum)
    defect_size_4_lo = where(off_4_sum < 0, -off_4_sum_lo, off_4_sum_lo)
    g_4_sum = g_4 + g_4_lo
    g_4_sum_right = g_4_sum - g_4
    g_4_sum_lo = g_4 - (g_4_sum - g_4_sum_right) + (g_4_lo - g_4_sum_right)
    defect_size_5 = absolute(g_4_sum)
    defect_size_5_lo = where(g_4_sum < 0, -g_4_sum_lo, g_4_sum_lo)
    off_6_sum = off_6 + off_6_lo
    off_6_sum_right = off_6_sum - off_6
    off_6_sum_lo = off_6 - (off_6_sum - off_6_sum_right) + (off_6_lo - off_6_sum_right)
    defect_size_6 = absolute(off_6_sum)
    defect_size_6_lo = where(off_6_sum < 0, -off_6_sum_lo, off_6_sum_lo)
    defect_size_0_sum = defect_size_0 + defect_size_0_lo
    defect_size_0_sum_right = defect_size_0_sum - defect_size_0
    defect_size_1_sum = defect_size_1 + defect_size_1_lo
    defect_size_1_sum_right = defect_size_1_sum - defect_size_1
    defect_largest1a = defect_size_0_sum < defect_size_1_sum
    defect_largest1 = where(defect_largest1a, defect_size_1_sum, defect_size_0_sum)
    defect_size_1_sum_lo = (defect_size_1 - (defect_size_1_sum - defect_size_1_sum_right)
        + (defect_size_1_lo - defect_size_1_sum_right))
    defect_size_0_sum_lo = (defect_size_0 - (defect_size_0_sum - defect_size_0_sum_right)
        + (defect_size_0_lo - defect_size_0_sum_right))
    defect_largest1_lo = where(defect_largest1a, defect_size_1_sum_lo, defect_size_0_sum_lo)
    defect_largest1_sum = defect_largest1 + defect_largest1_lo
    defect_largest1_sum_right = defect_largest1_sum - defect_largest1
    defect_size_2_sum = defect_size_2 + defect_size_2_lo
    defect_size_2_sum_right = defect_size_2_sum - defect_size_2
    defect_largest2a = defect_largest1_sum < defect_size_2_sum
    defect_largest2 = where(defect_largest2a, defect_size_2_sum, defect_largest1_sum)
    defect_largest1_sum_lo = (defect_largest1 - (defect_largest1_sum - defect_largest1_sum_right)
        + (defect_largest1_lo - defect_largest1_sum_right))
    defect_size_2_sum_lo = (defect_size_2 - (defect_size_2_sum - defect_size_2_sum_right)
        + (defect_size_2_lo - defect_size_2_sum_right))
    defect_largest2_lo = where(defect_largest2a, defect_size_2_sum_lo, defect_largest1_sum_lo)
    defect_largest2_sum = defect_largest2 + defect_largest2_lo
    defect_largest2_sum_right = defect_largest2_sum - defect_largest2
    defect_size_3_sum = defect_size_3 + defect_size_3_lo
    defect_size_3_sum_right = defect_size_3_sum - defect_size_3
    defect_largest3a = defect_largest2_sum < defect_size_3_sum
    defect_largest3 = where(defect_largest3a, defect_size_3_sum, defect_largest2_sum)
    defect_largest2_sum_lo = (defect_largest2 - (defect_largest2_sum - defect_largest2_sum_right)
        + (defect_largest2_lo - defect_largest2_sum_right))
    defect_size_3_sum_lo = (defect_size_3 - (defect_size_3_sum - defect_size_3_sum_right)
        + (defect_size_3_lo - defect_size_3_sum_right))
    defect_largest3_lo = where(defect_largest3a, defect_size_3_sum_lo, defect_largest2_sum_lo)
    defect_largest3_sum = defect_largest3 + defect_largest3_lo
    defect_largest3_sum_right = defect_largest3_sum - defect_largest3
    defect_size_4_sum = defect_size_4 + defect_size_4_lo
    defect_size_4_sum_right = defect_size_4_sum - defect_size_4
    defect_largest4a = defect_largest3_sum < defect_size_4_sum
    defect_largest4 = where(defect_largest4a, defect_size_4_sum, defect_largest3_sum)
    defect_largest3_sum_lo = (defect_largest3 - (defect_largest3_sum - defect_largest3_sum_right)
        + (defect_largest3_lo - defect_largest3_sum_right))
    defect_size_4_sum_lo = (defect_size_4 - (defect_size_4_sum - defect_size_4_sum_right)
        + (defect_size_4_lo - defect_size_4_sum_right))
    defect_largest4_lo = where(defect_largest4a, defect_size_4_sum_lo, defect_largest3_sum_lo)
    defect_largest4_sum = defect_largest4 + defect_largest4_lo
    defect_largest4_sum_right = defect_largest4_sum - defect_largest4
    defect_size_5_sum = defect_size_5 + defect_size_5_lo
    defect_size_5_sum_right = defect_size_5_sum - defect_size_5
    defect_largest5a = defect_largest4_sum < defect_size_5_sum
    defect_largest5 = where(defect_largest5a, defect_size_5_sum, defect_largest4_sum)
    defect_largest4_sum_lo = (defect_largest4 - (defect_largest4_sum - defect_largest4_sum_right)
        + (defect_largest4_lo - defect_largest4_sum_right))
    defect_size_5_sum_lo = (defect_size_5 - (defect_size_5_sum - defect_size_5_sum_right)
        + (defect_size_5_lo - defect_size_5_sum_right))
    defect_largest5_lo = where(defect_largest5a, defect_size_5_sum_lo, defect_largest4_sum_lo)
    defect_largest5_sum = defect_largest5 + defect_largest5_lo
    defect_largest5_sum_right = defect_largest5_sum - defect_largest5
    defect_size_6_sum = defect_size_6 + defect_size_6_lo
    defect_size_6_sum_right = defect_size_6_sum - defect_size_6
    defect_largest6a = defect_largest5_sum < defect_size_6_sum
    defect_largest6 = where(defect_largest6a, defect_size_6_sum, defect_largest5_sum)
    defect_largest5_sum_lo = (defect_largest5 - (defect_largest5_sum - defect_largest5_sum_right)
        + (defect_largest5_lo - defect_largest5_sum_right))
    defect_size_6_sum_lo = (defect_size_6 - (defect_size_6_sum - defect_size_6_sum_right)
        + (defect_size_6_lo - defect_size_6_sum_right))
    defect_largest6_rounded = (defect_largest6
        + where(defect_largest6a, defect_size_6_sum_lo, defect_largest5_sum_lo))
    return defect_largest6_rounded


@kernel("(3),()->(3,3)")
def mat3x3_from_axis_angle(axis, angle):
    """R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
    not a rotation.

    (3),()->(3,3).  axis: vector; angle: number; R: rotation or other 3×3 matrix.
    196 mul, 351 add, 26 product error, 18 product rest, 2 div, 6 abs, 3 less, 9 equal, 13
    select.  Error <= R: 1 u of its largest component for |axis| = 1; searched, not proved.
    Each component is within 1 ulp as long as its condition is below 1e13; in single precision
    it is the nearest number, except near ties, as long as that is below 1e5; searched, not
    proved.
    """
    axis_0, axis_1, axis_2 = axis
    half = 0.5 * angle
    h = elementary.sin(half)
    h_own_error = elementary.sin_error(half, h)
    sine, cosine = elementary.sincos(angle)
    sine_own_error, cosine_own_error = elementary.sincos_error(angle, sine, cosine)
    versine_a = h * h
    versine_c = 1 - cosine
    versine_c_right = 1 - versine_c
    versine_d = cosine + cosine_own_error < 0
    versine = where(versine_d, versine_c, 2 * versine_a)
    versine_c_lo = 1 - (versine_c + versine_c_right) - (cosine - versine_c_right) - cosine_own_error
    versine_lo = where(versine_d, versine_c_lo, 2 * (product_error(h, h,
        versine_a) + (h_own_error * h + h * h_own_error)))
    beta_v_0 = axis_0 * versine
    beta_v_1 = axis_1 * versine
    beta_v_2 = axis_2 * versine
    beta_v_0_lo = product_error(axis_0, versine, beta_v_0) + axis_0 * versine_lo
    m_0 = axis_0 * beta_v_0
    m_0_cross2 = axis_0 * beta_v_0_lo
    beta_v_1_lo = product_error(axis_1, versine, beta_v_1) + axis_1 * versine_lo
    m_1 = axis_1 * beta_v_1
    m_1_cross2 = axis_1 * beta_v_1_lo
    m_2 = axis_2 * beta_v_2
    m_2_cross2 = axis_2 * (product_error(axis_2, versine, beta_v_2) + axis_2 * versine_lo)
    m_3 = axis_1 * beta_v_0
    m_3_cross2 = axis_1 * beta_v_0_lo
    m_4 = axis_2 * beta_v_0
    m_4_cross2 = axis_2 * beta_v_0_lo
    m_5 = axis_2 * beta_v_1
    m_5_cross2 = axis_2 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(axis_1, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(axis_2, beta_v_2, m_2, others_0_right))
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(axis_0, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(axis_2, beta_v_2, m_2, others_1_right))
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(axis_0, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(axis_1, beta_v_1, m_1, others_2_right))
    alpha_v_0 = axis_0 * sine
    alpha_v_0_cross2 = axis_0 * sine_own_error
    alpha_v_1 = axis_1 * sine
    alpha_v_1_cross2 = axis_1 * sine_own_error
    alpha_v_2 = axis_2 * sine
    alpha_v_2_cross2 = axis_2 * sine_own_error
    R_00 = 1 - others_0
    R_00_right = 1 - R_00
    R_01 = m_3 - alpha_v_2
    R_01_right = m_3 - R_01
    R_02 = m_4 + alpha_v_1
    R_02_right = R_02 - m_4
    R_10 = m_3 + alpha_v_2
    R_10_right = R_10 - m_3
    R_11 = 1 - others_1
    R_11_right = 1 - R_11
    R_12 = m_5 - alpha_v_0
    R_12_right = m_5 - R_12
    R_20 = m_4 - alpha_v_1
    R_20_right = m_4 - R_20
    R_21 = m_5 + alpha_v_0
    R_21_right = R_21 - m_5
    R_22 = 1 - others_2
    R_22_right = 1 - R_22
    R_00_rounded = (R_00
        + (1 - (R_00 + R_00_right) - (others_0 - R_00_right)
        - (others_0_lo1 + (m_1_cross2 + m_2_cross2))))
    R_01_lo = (product_rest(axis_1, beta_v_0, m_3, R_01 + R_01_right)
        - product_rest(axis_2, sine, alpha_v_2, R_01_right) + (m_3_cross2 - alpha_v_2_cross2))
    R_01_rounded = R_01 + R_01_lo
    R_02_lo = (product_rest(axis_2, beta_v_0, m_4, R_02 - R_02_right)
        + product_rest(axis_1, sine, alpha_v_1, R_02_right) + (m_4_cross2 + alpha_v_1_cross2))
    R_02_rounded = R_02 + R_02_lo
    R_10_lo = (product_rest(axis_1, beta_v_0, m_3, R_10 - R_10_right)
        + product_rest(axis_2, sine, alpha_v_2, R_10_right) + (m_3_cross2 + alpha_v_2_cross2))
    R_10_rounded = R_10 + R_10_lo
    R_11_rounded = (R_11
        + (1 - (R_11 + R_11_right) - (others_1 - R_11_right)
        - (others_1_lo1 + (m_0_cross2 + m_2_cross2))))
    R_12_lo = (product_rest(axis_2, beta_v_1, m_5, R_12 + R_12_right)
        - product_rest(axis_0, sine, alpha_v_0, R_12_right) + (m_5_cross2 - alpha_v_0_cross2))
    R_12_rounded = R_12 + R_12_lo
    R_20_lo = (product_rest(axis_2, beta_v_0, m_4, R_20 + R_20_right)
        - product_rest(axis_1, sine, alpha_v_1, R_20_right) + (m_4_cross2 - alpha_v_1_cross2))
    R_20_rounded = R_20 + R_20_lo
    R_21_lo = (product_rest(axis_2, beta_v_1, m_5, R_21 - R_21_right)
        + product_rest(axis_0, sine, alpha_v_0, R_21_right) + (m_5_cross2 + alpha_v_0_cross2))
    R_21_rounded = R_21 + R_21_lo
    R_22_rounded = (R_22
        + (1 - (R_22 + R_22_right) - (others_2 - R_22_right)
        - (others_2_lo1 + (m_0_cross2 + m_1_cross2))))
    R_00_final = where(R_00_rounded == R_00_rounded, R_00_rounded, R_00)
    R_01_final = where(R_01_rounded == R_01_rounded, R_01_rounded, R_01)
    R_02_final = where(R_02_rounded == R_02_rounded, R_02_rounded, R_02)
    R_10_final = where(R_10_rounded == R_10_rounded, R_10_rounded, R_10)
    R_11_final = where(R_11_rounded == R_11_rounded, R_11_rounded, R_11)
    R_12_final = where(R_12_rounded == R_12_rounded, R_12_rounded, R_12)
    R_20_final = where(R_20_rounded == R_20_rounded, R_20_rounded, R_20)
    R_21_final = where(R_21_rounded == R_21_rounded, R_21_rounded, R_21)
    R_22_final = where(R_22_rounded == R_22_rounded, R_22_rounded, R_22)
    return (R_00_final, R_01_final, R_02_final, R_10_final, R_11_final, R_12_final, R_20_final,
        R_21_final, R_22_final)


@kernel("(3,3)->(),(3)")
def axis_angle_from_mat3x3(R):
    """angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.

    (3,3)->(),(3).  R: rotation or other 3×3 matrix; angle: number; axis: vector.
    157 mul, 448 add, 25 product error, 3 product rest, 14 div, 1 sqrt, 13 neg, 13 abs, 4
    copysign, 29 less, 10 equal, 80 select.  Error <= angle: 1 u, axis: 1 u of its largest
    component for R a rotation; searched, not proved.  Each component is within 1 ulp as long as
    its condition is below 1e13; in single precision it is the nearest number, except near ties,
    as long as that is below 1e5; searched, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    p_0 = R_21 - R_12
    p_0_right = R_21 - p_0
    p_0_lo = R_21 - (p_0 + p_0_right) - (R_12 - p_0_right)
    p_1 = R_02 - R_20
    p_1_right = R_02 - p_1
    p_1_lo = R_02 - (p_1 + p_1_right) - (R_20 - p_1_right)
    p_2 = R_10 - R_01
    p_2_right = R_10 - p_2
    p_2_lo = R_10 - (p_2 + p_2_right) - (R_01 - p_2_right)
    s_0 = R_12 + R_21
    s_0_right = s_0 - R_12
    s_0_lo = R_12 - (s_0 - s_0_right) + (R_21 - s_0_right)
    s_1 = R_02 + R_20
    s_1_right = s_1 - R_02
    s_1_lo = R_02 - (s_1 - s_1_right) + (R_20 - s_1_right)
    s_2 = R_01 + R_10
    s_2_right = s_2 - R_01
    s_2_lo = R_01 - (s_2 - s_2_right) + (R_10 - s_2_right)
    first_0 = R_00 + 1
    first_0_right = first_0 - R_00
    first_0_lo = R_00 - (first_0 - first_0_right) + (1 - first_0_right)
    first_1 = 1 - R_00
    first_1_right = 1 - first_1
    first_1_lo = 1 - (first_1 + first_1_right) - (R_00 - first_1_right)
    others_0 = R_11 + R_22
    others_0_right = others_0 - R_11
    others_0_lo = R_11 - (others_0 - others_0_right) + (R_22 - others_0_right)
    others_1 = R_11 - R_22
    others_1_right = R_11 - others_1
    others_1_lo = R_11 - (others_1 + others_1_right) - (R_22 - others_1_right)
    d_0 = first_0 + others_0
    d_0_right = d_0 - first_0
    d_1 = first_0 - others_0
    d_1_right = first_0 - d_1
    d_2 = first_1 + others_1
    d_2_right = d_2 - first_1
    d_3 = first_1 - others_1
    d_3_right = first_1 - d_3
    low_0a = R_11 < R_00
    low_0 = where(low_0a, d_1, s_2)
    low_1 = where(low_0a, s_2, d_2)
    low_2 = where(low_0a, s_1, s_0)
    low_3 = where(low_0a, p_0, p_1)
    high_0b = R_00 < -R_11
    high_0 = where(high_0b, s_1, p_0)
    high_1 = where(high_0b, s_0, p_1)
    high_2 = where(high_0b, d_3, p_2)
    high_3 = where(high_0b, p_2, d_0)
    column_0a = R_22 < 0
    column_0 = where(column_0a, low_0, high_0)
    low_0_lo = where(low_0a,
        first_0 - (d_1 + d_1_right) - (others_0 - d_1_right) - others_0_lo + first_0_lo, s_2_lo)
    column_0_lo = where(column_0a, low_0_lo, where(high_0b, s_1_lo, p_0_lo))
    column_1 = where(column_0a, low_1, high_1)
    low_1_lo = where(low_0a, s_2_lo,
        first_1 - (d_2 - d_2_right) + (others_1 - d_2_right) + others_1_lo + first_1_lo)
    column_1_lo = where(column_0a, low_1_lo, where(high_0b, s_0_lo, p_1_lo))
    column_2 = where(column_0a, low_2, high_2)
    high_2_lo = where(high_0b,
        first_1 - (d_3 + d_3_right) - (others_1 - d_3_right) - others_1_lo + first_1_lo, p_2_lo)
    column_2_lo = where(column_0a, where(low_0a, s_1_lo, s_0_lo), high_2_lo)
    column_3 = where(column_0a, low_3, high_3)
    high_3_lo = where(high_0b, p_2_lo,
        first_0 - (d_0 - d_0_right) + (others_0 - d_0_right) + others_0_lo + first_0_lo)
    column_3_lo = where(column_0a, where(low_0a, p_0_lo, p_1_lo), high_3_lo)
    column_3_sum = column_3 + column_3_lo
    column_3_sum_right = column_3_sum - column_3
    column_3_sum_lo = (column_3 - (column_3_sum - column_3_sum_right)
        + (column_3_lo - column_3_sum_right))
    upper_0b = column_3_sum < 0
    upper_0 = where(upper_0b, -column_0, column_0)
    upper_0_lo = where(upper_0b, -column_0_lo, column_0_lo)
    upper_1 = where(upper_0b, -column_1, column_1)
    upper_1_lo = where(upper_0b, -column_1_lo, column_1_lo)
    upper_2 = where(upper_0b, -column_2, column_2)
    upper_2_lo = where(upper_0b, -column_2_lo, column_2_lo)
    upper_3 = where(upper_0b, -column_3_sum, column_3_sum)
    upper_3_lo = where(upper_0b, -column_3_sum_lo, column_3_sum_lo)
    upper_0_sum = upper_0 + upper_0_lo
    upper_0_sum_right = upper_0_sum - upper_0
    upper_0_sum_lo = upper_0 - (upper_0_sum - upper_0_sum_right) + (upper_0_lo - upper_0_sum_right)
    v_s_size_0 = absolute(upper_0_sum)
    v_s_size_0_lo = where(upper_0_sum < 0, -upper_0_sum_lo, upper_0_sum_lo)
    upper_1_sum = upper_1 + upper_1_lo
    upper_1_sum_right = upper_1_sum - upper_1
    upper_1_sum_lo = upper_1 - (upper_1_sum - upper_1_sum_right) + (upper_1_lo - upper_1_sum_right)
    v_s_size_1 = absolute(upper_1_sum)
    v_s_size_1_lo = where(upper_1_sum < 0, -upper_1_sum_lo, upper_1_sum_lo)
    upper_2_sum = upper_2 + upper_2_lo
    upper_2_sum_right = upper_2_sum - upper_2
    upper_2_sum_lo = upper_2 - (upper_2_sum - upper_2_sum_right) + (upper_2_lo - upper_2_sum_right)
    v_s_size_2 = absolute(upper_2_sum)
    v_s_size_2_lo = where(upper_2_sum < 0, -upper_2_sum_lo, upper_2_sum_lo)
    v_s_size_0_sum = v_s_size_0 + v_s_size_0_lo
    v_s_size_0_sum_right = v_s_size_0_sum - v_s_size_0
    v_s_size_1_sum = v_s_size_1 + v_s_size_1_lo
    v_s_size_1_sum_right = v_s_size_1_sum - v_s_size_1
    v_s_largest1a = v_s_size_0_sum < v_s_size_1_sum
    v_s_largest1 = where(v_s_largest1a, v_s_size_1_sum, v_s_size_0_sum)
    v_s_size_1_sum_lo = (v_s_size_1 - (v_s_size_1_sum - v_s_size_1_sum_right)
        + (v_s_size_1_lo - v_s_size_1_sum_right))
    v_s_size_0_sum_lo = (v_s_size_0 - (v_s_size_0_sum - v_s_size_0_sum_right)
        + (v_s_size_0_lo - v_s_size_0_sum_right))
    v_s_largest1_lo = where(v_s_largest1a, v_s_size_1_sum_lo, v_s_size_0_sum_lo)
    v_s_largest1_sum = v_s_largest1 + v_s_largest1_lo
    v_s_largest1_sum_right = v_s_largest1_sum - v_s_largest1
    v_s_size_2_sum = v_s_size_2 + v_s_size_2_lo
    v_s_size_2_sum_right = v_s_size_2_sum - v_s_size_2
    v_s_largest2a = v_s_largest1_sum < v_s_size_2_sum
    v_s_largest2 = where(v_s_largest2a, v_s_size_2_sum, v_s_largest1_sum)
    v_s_largest1_sum_lo = (v_s_largest1 - (v_s_largest1_sum - v_s_largest1_sum_right)
        + (v_s_largest1_lo - v_s_largest1_sum_right))
    v_s_size_2_sum_lo = (v_s_size_2 - (v_s_size_2_sum - v_s_size_2_sum_right)
        + (v_s_size_2_lo - v_s_size_2_sum_right))
    v_s_largest2_sum = v_s_largest2 + where(v_s_largest2a, v_s_size_2_sum_lo, v_s_largest1_sum_lo)
    v_s_b = where(6.703903964971299e+153 < v_s_largest2_sum, real(3.7291703656001034e-155), real(1))
    v_s = where(v_s_largest2_sum < 1.955159272639747e-149, 1.0715086071862673e+301,
        where(v_s_largest2_sum < 256, 1.3093562431584567e+151, v_s_b))
    v_y_0 = upper_0_sum * v_s
    v_y_0_inverse = 1 / v_s
    v_y_0_lo = (upper_0_sum - v_y_0 * v_y_0_inverse + upper_0_sum_lo) * v_s
    v_y_1 = upper_1_sum * v_s
    v_y_1_lo = (upper_1_sum - v_y_1 * v_y_0_inverse + upper_1_sum_lo) * v_s
    v_y_2 = upper_2_sum * v_s
    v_y_2_lo = (upper_2_sum - v_y_2 * v_y_0_inverse + upper_2_sum_lo) * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_b = v_y_1 * v_y_1
    v_n_c = v_n_a + v_n_b
    v_n_c_right = v_n_c - v_n_a
    v_n_c_lo1 = (product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
        + product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right))
    v_n_d = v_y_2 * v_y_2
    v_n_e = v_n_c + v_n_d
    v_n_e_right = v_n_e - v_n_c
    v_n_e_lo2 = (v_n_c - (v_n_e - v_n_e_right) + product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
        + (v_y_2_lo * v_y_2 + v_y_2 * v_y_2_lo))
    v_n_e_lo = (v_n_e_lo2
        + (v_n_c_lo1
        + (v_y_0_lo * v_y_0 + v_y_0 * v_y_0_lo + (v_y_1_lo * v_y_1 + v_y_1 * v_y_1_lo))))
    v_n_e_sum = v_n_e + v_n_e_lo
    v_n_e_sum_right = v_n_e_sum - v_n_e
    v_n = sqrt(v_n_e_sum)
    v_n_product = v_n * v_n
    v_n_residual = (v_n_e_sum - v_n_product - product_error(v_n, v_n, v_n_product)
        + (v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right)))
    v_n_lo = v_n_residual / where(v_n == 0, 1, v_n + v_n)
    v_r_d = where(1 < v_s, 7.637340908749012e-152, where(v_s < 1, real(2.6815615859885194e+154),
        real(1)))
    v_r = where(1.3093562431584567e+151 < v_s, 9.332636185032189e-302, v_r_d)
    v_n_sum = v_n + v_n_lo
    v_n_sum_right = v_n_sum - v_n
    v_n_sum_lo = v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right)
    n = v_n_sum * v_r
    n_lo = (v_n_sum - n * (1 / v_r) + v_n_sum_lo) * v_r
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    upper_3_sum = upper_3 + upper_3_lo
    upper_3_sum_right = upper_3_sum - upper_3
    half = elementary.atan2(n_sum, upper_3_sum)
    half_size0 = absolute(n_sum)
    half_size1 = absolute(upper_3_sum)
    half_most = where(half_size0 < half_size1, half_size1, half_size0)
    half_zero = half_most == 0
    half_divisor = where(half_zero, 1, half_most)
    half_part0 = n_sum / half_divisor
    half_part1 = upper_3_sum / half_divisor
    half_cross2 = (half_part0
        * (upper_3 - (upper_3_sum - upper_3_sum_right) + (upper_3_lo - upper_3_sum_right)))
    half_safe = where(half_zero, 1,
        half_divisor * (half_part1 * half_part1 + half_part0 * half_part0))
    half_more = ((half_part1 * (n - (n_sum - n_sum_right) + (n_lo - n_sum_right)) - half_cross2)
        / half_safe)
    divisor_a = v_n_sum == 0
    divisor = where(divisor_a, 1, v_n_sum)
    divisor_lo = where(divisor_a, 0, v_n_sum_lo)
    v_y_0_sum = v_y_0 + v_y_0_lo
    v_y_0_sum_right = v_y_0_sum - v_y_0
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    unit_0 = v_y_0_sum / divisor_sum
    unit_0_product = unit_0 * divisor_sum
    unit_0_exact = v_y_0_sum - unit_0_product - product_error(unit_0, divisor_sum, unit_0_product)
    v_y_1_sum = v_y_1 + v_y_1_lo
    v_y_1_sum_right = v_y_1_sum - v_y_1
    unit_1 = v_y_1_sum / divisor_sum
    unit_1_product = unit_1 * divisor_sum
    unit_1_exact = v_y_1_sum - unit_1_product - product_error(unit_1, divisor_sum, unit_1_product)
    v_y_2_sum = v_y_2 + v_y_2_lo
    v_y_2_sum_right = v_y_2_sum - v_y_2
    unit_2 = v_y_2_sum / divisor_sum
    unit_2_product = unit_2 * divisor_sum
    unit_2_exact = v_y_2_sum - unit_2_product - product_error(unit_2, divisor_sum, unit_2_product)
    angle = 2 * half
    axis_0 = where(divisor_a, 1, unit_0)
    unit_0_lo = ((unit_0_exact
        + (v_y_0 - (v_y_0_sum - v_y_0_sum_right) + (v_y_0_lo - v_y_0_sum_right)) - unit_0
        * divisor_sum_lo) / divisor_sum)
    angle_rounded = angle + 2 * (elementary.atan2_error(n_sum, upper_3_sum, half) + half_more)
    axis_0_rounded = axis_0 + where(divisor_a, 0, unit_0_lo)
    unit_1_lo = ((unit_1_exact
        + (v_y_1 - (v_y_1_sum - v_y_1_sum_right) + (v_y_1_lo - v_y_1_sum_right)) - unit_1
        * divisor_sum_lo) / divisor_sum)
    unit_1_rounded = unit_1 + unit_1_lo
    unit_2_lo = ((unit_2_exact
        + (v_y_2 - (v_y_2_sum - v_y_2_sum_right) + (v_y_2_lo - v_y_2_sum_right)) - unit_2
        * divisor_sum_lo) / divisor_sum)
    unit_2_rounded = unit_2 + unit_2_lo
    angle_final = where(angle_rounded == angle_rounded, angle_rounded, angle)
    axis_0_final = where(axis_0_rounded == axis_0_rounded, axis_0_rounded, axis_0)
    unit_1_final = where(unit_1_rounded == unit_1_rounded, unit_1_rounded, unit_1)
    unit_2_final = where(unit_2_rounded == unit_2_rounded, unit_2_rounded, unit_2)
    return (angle_final, axis_0_final, unit_1_final, unit_2_final)
