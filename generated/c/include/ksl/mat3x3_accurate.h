/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_MAT3X3_ACCURATE_H
#define KSL_MAT3X3_ACCURATE_H

#include "ksl_exact.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x.
   w, dw: vector; Ro: rotation or other 3×3 matrix.
   6 mul, 51 add, 12 product rest, 6 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_acceleration_tensor_accurate(const ksl_vec3_t *w, const ksl_vec3_t *dw,
    ksl_mat3x3_t *Ro) {
  const double ww_0 = KSL_MUL(w->x, w->x), ww_1 = KSL_MUL(w->y, w->y), ww_2 = KSL_MUL(w->z, w->z),
      ww_3 = KSL_MUL(w->x, w->y), ww_4 = KSL_MUL(w->x, w->z), ww_5 = KSL_MUL(w->y, w->z);
  const double Ro_00a = ww_1 + ww_2, Ro_00a_right = Ro_00a - ww_1, Ro_00 = -Ro_00a;
  const double Ro_01 = ww_3 - dw->z, Ro_01_right = ww_3 - Ro_01;
  const double Ro_02 = dw->y + ww_4, Ro_02_right = Ro_02 - dw->y;
  const double Ro_10 = dw->z + ww_3, Ro_10_right = Ro_10 - dw->z;
  const double Ro_11a = ww_0 + ww_2, Ro_11a_right = Ro_11a - ww_0, Ro_11 = -Ro_11a;
  const double Ro_12 = ww_5 - dw->x, Ro_12_right = ww_5 - Ro_12;
  const double Ro_20 = ww_4 - dw->y, Ro_20_right = ww_4 - Ro_20;
  const double Ro_21 = dw->x + ww_5, Ro_21_right = Ro_21 - dw->x;
  const double Ro_22a = ww_0 + ww_1, Ro_22a_right = Ro_22a - ww_0, Ro_22 = -Ro_22a;
  const double Ro_00_rounded = Ro_00 +
          -(ksl_product_rest(w->y, w->y, ww_1, Ro_00a - Ro_00a_right)
          + ksl_product_rest(w->z, w->z, ww_2, Ro_00a_right)),
      Ro_01_rounded = Ro_01
          + (ksl_product_rest(w->x, w->y, ww_3, Ro_01 + Ro_01_right) - (dw->z - Ro_01_right)),
      Ro_02_rounded = Ro_02
          + (dw->y - (Ro_02 - Ro_02_right) + ksl_product_rest(w->x, w->z, ww_4, Ro_02_right)),
      Ro_10_rounded = Ro_10
          + (dw->z - (Ro_10 - Ro_10_right) + ksl_product_rest(w->x, w->y, ww_3, Ro_10_right)),
      Ro_11_rounded = Ro_11 +
          -(ksl_product_rest(w->x, w->x, ww_0, Ro_11a - Ro_11a_right)
          + ksl_product_rest(w->z, w->z, ww_2, Ro_11a_right)),
      Ro_12_rounded = Ro_12
          + (ksl_product_rest(w->y, w->z, ww_5, Ro_12 + Ro_12_right) - (dw->x - Ro_12_right)),
      Ro_20_rounded = Ro_20
          + (ksl_product_rest(w->x, w->z, ww_4, Ro_20 + Ro_20_right) - (dw->y - Ro_20_right)),
      Ro_21_rounded = Ro_21
          + (dw->x - (Ro_21 - Ro_21_right) + ksl_product_rest(w->y, w->z, ww_5, Ro_21_right)),
      Ro_22_rounded = Ro_22 +
          -(ksl_product_rest(w->x, w->x, ww_0, Ro_22a - Ro_22a_right)
          + ksl_product_rest(w->y, w->y, ww_1, Ro_22a_right));
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* det R.
   R: rotation or other 3×3 matrix.
   12 mul, 26 add, 9 product rest.
   Error <= u |result| + 28 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_mat3x3_determinant_accurate(const ksl_mat3x3_t *R) {
  const double n_0a = KSL_MUL(R->m11, R->m22), n_0b = KSL_MUL(R->m12, R->m21), n_0 = n_0a - n_0b,
      n_0_right = n_0a - n_0;
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1b = KSL_MUL(R->m01, R->m22), n_1 = n_1a - n_1b,
      n_1_right = n_1a - n_1;
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2b = KSL_MUL(R->m02, R->m11), n_2 = n_2a - n_2b,
      n_2_right = n_2a - n_2;
  const double det_a = KSL_MUL(R->m00, n_0), det_b = KSL_MUL(R->m10, n_1), det_c = det_a + det_b,
      det_c_right = det_c - det_a,
      det_a_cross2 = KSL_MUL(R->m00, ksl_product_rest(R->m11, R->m22, n_0a, n_0 + n_0_right)
          - ksl_product_rest(R->m12, R->m21, n_0b, n_0_right)),
      det_b_cross2 = KSL_MUL(R->m10, ksl_product_rest(R->m02, R->m21, n_1a, n_1 + n_1_right)
          - ksl_product_rest(R->m01, R->m22, n_1b, n_1_right)),
      det_c_lo1 = ksl_product_rest(R->m00, n_0, det_a, det_c - det_c_right)
          + ksl_product_rest(R->m10, n_1, det_b, det_c_right), det_d = KSL_MUL(R->m20, n_2),
      det = det_c + det_d, det_right = det - det_c,
      det_d_cross2 = KSL_MUL(R->m20, ksl_product_rest(R->m01, R->m12, n_2a, n_2 + n_2_right)
          - ksl_product_rest(R->m02, R->m11, n_2b, n_2_right)),
      det_lo = det_c - (det - det_right) + ksl_product_rest(R->m20, n_2, det_d, det_right)
          + det_d_cross2 + (det_c_lo1 + (det_a_cross2 + det_b_cross2));
  const double det_rounded = det + det_lo;
  return det_rounded;
}

/* Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or overflows.
     Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3 (double
     1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.
   R, Ro: rotation or other 3×3 matrix.
   106 mul, 290 add, 10 product error, 32 product rest, 22 div, 2 neg, 19 abs, 17 less, 11 equal,
     55 select.
   Error of Ro_ij <= 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the sum of the |terms| of
     the cofactor, or 2^-80 m^2 (double 2^-700 m^2) if that is more; barring over- and underflow
     of Ro_ij itself. */
static inline double ksl_mat3x3_inverse_accurate(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double R_size_0 = fabs(R->m00), R_size_1 = fabs(R->m01), R_size_2 = fabs(R->m02),
      R_size_3 = fabs(R->m10), R_size_4 = fabs(R->m11), R_size_5 = fabs(R->m12),
      R_size_6 = fabs(R->m20), R_size_7 = fabs(R->m21), R_size_8 = fabs(R->m22);
  const double R_largest1 = R_size_0 < R_size_1 ? R_size_1 : R_size_0;
  const double R_largest2 = R_largest1 < R_size_2 ? R_size_2 : R_largest1;
  const double R_largest3 = R_largest2 < R_size_3 ? R_size_3 : R_largest2;
  const double R_largest4 = R_largest3 < R_size_4 ? R_size_4 : R_largest3;
  const double R_largest5 = R_largest4 < R_size_5 ? R_size_5 : R_largest4;
  const double R_largest6 = R_largest5 < R_size_6 ? R_size_6 : R_largest5;
  const double R_largest7 = R_largest6 < R_size_7 ? R_size_7 : R_largest6;
  const double R_largest8 = R_largest7 < R_size_8 ? R_size_8 : R_largest7;
  const double s_b = R_largest8 < 8.452712498170644e+270 ? 2.409919865102884e-181
          : 1.1830521861667747e-271,
      s_d = R_largest8 < 4.149515568880993e+180 ? 4.909093465297727e-91 : s_b,
      s_f = R_largest8 < 2.037035976334486e+90 ? 1.0 : s_d,
      s_h = R_largest8 < 1.0 ? 2.037035976334486e+90 : s_f,
      s_j = R_largest8 < 4.909093465297727e-91 ? 4.149515568880993e+180 : s_h,
      s = R_largest8 < 2.409919865102884e-181 ? 8.452712498170644e+270 : s_j;
  const double A_0 = KSL_MUL(R->m00, s), A_1 = KSL_MUL(R->m01, s), A_2 = KSL_MUL(R->m02, s),
      A_3 = KSL_MUL(R->m10, s), A_4 = KSL_MUL(R->m11, s), A_5 = KSL_MUL(R->m12, s),
      A_6 = KSL_MUL(R->m20, s), A_7 = KSL_MUL(R->m21, s), A_8 = KSL_MUL(R->m22, s);
  const double n0_0a = KSL_MUL(A_4, A_8), n0_0b = KSL_MUL(A_5, A_7), n0_0 = n0_0a - n0_0b,
      n0_0_right = n0_0a - n0_0,
      n0_0_lo = ksl_product_rest(A_4, A_8, n0_0a, n0_0 + n0_0_right)
          - ksl_product_rest(A_5, A_7, n0_0b, n0_0_right);
  const double n0_1a = KSL_MUL(A_2, A_7), n0_1b = KSL_MUL(A_1, A_8), n0_1 = n0_1a - n0_1b,
      n0_1_right = n0_1a - n0_1,
      n0_1_lo = ksl_product_rest(A_2, A_7, n0_1a, n0_1 + n0_1_right)
          - ksl_product_rest(A_1, A_8, n0_1b, n0_1_right);
  const double n0_2a = KSL_MUL(A_1, A_5), n0_2b = KSL_MUL(A_2, A_4), n0_2 = n0_2a - n0_2b,
      n0_2_right = n0_2a - n0_2,
      n0_2_lo = ksl_product_rest(A_1, A_5, n0_2a, n0_2 + n0_2_right)
          - ksl_product_rest(A_2, A_4, n0_2b, n0_2_right);
  const double n1_0a = KSL_MUL(A_5, A_6), n1_0b = KSL_MUL(A_3, A_8), n1_0 = n1_0a - n1_0b,
      n1_0_right = n1_0a - n1_0,
      n1_0_lo = ksl_product_rest(A_5, A_6, n1_0a, n1_0 + n1_0_right)
          - ksl_product_rest(A_3, A_8, n1_0b, n1_0_right);
  const double n1_1a = KSL_MUL(A_0, A_8), n1_1b = KSL_MUL(A_2, A_6), n1_1 = n1_1a - n1_1b,
      n1_1_right = n1_1a - n1_1,
      n1_1_lo = ksl_product_rest(A_0, A_8, n1_1a, n1_1 + n1_1_right)
          - ksl_product_rest(A_2, A_6, n1_1b, n1_1_right);
  const double n1_2a = KSL_MUL(A_2, A_3), n1_2b = KSL_MUL(A_0, A_5), n1_2 = n1_2a - n1_2b,
      n1_2_right = n1_2a - n1_2,
      n1_2_lo = ksl_product_rest(A_2, A_3, n1_2a, n1_2 + n1_2_right)
          - ksl_product_rest(A_0, A_5, n1_2b, n1_2_right);
  const double n2_0a = KSL_MUL(A_3, A_7), n2_0b = KSL_MUL(A_4, A_6), n2_0 = n2_0a - n2_0b,
      n2_0_right = n2_0a - n2_0,
      n2_0_lo = ksl_product_rest(A_3, A_7, n2_0a, n2_0 + n2_0_right)
          - ksl_product_rest(A_4, A_6, n2_0b, n2_0_right);
  const double n2_1a = KSL_MUL(A_1, A_6), n2_1b = KSL_MUL(A_0, A_7), n2_1 = n2_1a - n2_1b,
      n2_1_right = n2_1a - n2_1,
      n2_1_lo = ksl_product_rest(A_1, A_6, n2_1a, n2_1 + n2_1_right)
          - ksl_product_rest(A_0, A_7, n2_1b, n2_1_right);
  const double n2_2a = KSL_MUL(A_0, A_4), n2_2b = KSL_MUL(A_1, A_3), n2_2 = n2_2a - n2_2b,
      n2_2_right = n2_2a - n2_2,
      n2_2_lo = ksl_product_rest(A_0, A_4, n2_2a, n2_2 + n2_2_right)
          - ksl_product_rest(A_1, A_3, n2_2b, n2_2_right);
  const double d_a = KSL_MUL(A_0, n0_0), d_b = KSL_MUL(A_3, n0_1), d_c = d_a + d_b,
      d_c_right = d_c - d_a,
      d_c_lo1 = ksl_product_rest(A_0, n0_0, d_a, d_c - d_c_right)
          + ksl_product_rest(A_3, n0_1, d_b, d_c_right), d_d = KSL_MUL(A_6, n0_2), d = d_c + d_d,
      d_right = d - d_c,
      d_lo2 = d_c - (d - d_right) + ksl_product_rest(A_6, n0_2, d_d, d_right)
          + KSL_MUL(A_6, n0_2_lo),
      d_lo = d_lo2 + (d_c_lo1 + (KSL_MUL(A_0, n0_0_lo) + KSL_MUL(A_3, n0_1_lo)));
  const double size0_0 = fabs(A_0), size0_1 = fabs(A_3), size0_2 = fabs(A_6);
  const double size1_0 = fabs(A_1), size1_1 = fabs(A_4), size1_2 = fabs(A_7);
  const double size2_0 = fabs(A_2), size2_1 = fabs(A_5), size2_2 = fabs(A_8);
  const double permanent_a = KSL_MUL(size1_1, size2_2), permanent_b = KSL_MUL(size1_2, size2_1),
      permanent_c = permanent_a + permanent_b, permanent_c_right = permanent_c - permanent_a,
      permanent_c_left_rest = ksl_product_rest(size1_1, size2_2, permanent_a, permanent_c
          - permanent_c_right), permanent_d = KSL_MUL(size0_0, permanent_c),
      permanent_e = KSL_MUL(size1_0, size2_2), permanent_f = KSL_MUL(size1_2, size2_0),
      permanent_g = permanent_e + permanent_f, permanent_g_right = permanent_g - permanent_e,
      permanent_g_left_rest = ksl_product_rest(size1_0, size2_2, permanent_e, permanent_g
          - permanent_g_right), permanent_h = KSL_MUL(size0_1, permanent_g),
      permanent_i = permanent_d + permanent_h, permanent_i_right = permanent_i - permanent_d,
      permanent_d_cross2 = KSL_MUL(size0_0, permanent_c_left_rest
          + ksl_product_rest(size1_2, size2_1, permanent_b, permanent_c_right)),
      permanent_i_left_rest = ksl_product_rest(size0_0, permanent_c, permanent_d, permanent_i
          - permanent_i_right),
      permanent_i_cross = permanent_d_cross2
          + KSL_MUL(size0_1, permanent_g_left_rest
          + ksl_product_rest(size1_2, size2_0, permanent_f, permanent_g_right)),
      permanent_j = KSL_MUL(size1_0, size2_1), permanent_k = KSL_MUL(size1_1, size2_0),
      permanent_l = permanent_j + permanent_k, permanent_l_right = permanent_l - permanent_j,
      permanent_l_left_rest = ksl_product_rest(size1_0, size2_1, permanent_j, permanent_l
          - permanent_l_right), permanent_m = KSL_MUL(size0_2, permanent_l),
      permanent = permanent_i + permanent_m, permanent_right = permanent - permanent_i,
      permanent_lo1 = permanent_i - (permanent - permanent_right)
          + ksl_product_rest(size0_2, permanent_l, permanent_m, permanent_right),
      permanent_lo2 = permanent_lo1
          + KSL_MUL(size0_2, permanent_l_left_rest
          + ksl_product_rest(size1_1, size2_0, permanent_k, permanent_l_right));
  const double top = KSL_MUL(R_largest8, s);
  const double spoiled = KSL_MUL(top, 1.6489340850168661e-229);
  const double least_a = KSL_MUL(permanent, 8.881784197001252e-16);
  const double permanent_lo = permanent_lo2
          + (permanent_i_left_rest
          + ksl_product_rest(size0_1, permanent_g, permanent_h, permanent_i_right)
          + permanent_i_cross);
  const double least_b = KSL_MUL(top, top), least_c = KSL_MUL(spoiled, least_b),
      least = least_a + least_c, least_right = least - least_a,
      least_left_rest = ksl_product_rest(permanent, 8.881784197001252e-16, least_a, least
          - least_right),
      least_cross = KSL_MUL(permanent_lo, 8.881784197001252e-16)
          + KSL_MUL(spoiled, ksl_product_error(top, top, least_b));
  const double d_sum = d + d_lo, d_sum_right = d_sum - d,
      d_sum_lo = d - (d_sum - d_sum_right) + (d_lo - d_sum_right), regular_a_opposite = -d_sum_lo,
      least_sum = least
          + (least_left_rest + ksl_product_rest(spoiled, least_b, least_c, least_right)
          + least_cross),
      regular = least_sum < fabs(d_sum) + (d_sum < 0.0 ? regular_a_opposite : d_sum_lo) ? 1.0 : 0.0;
  const double divisor = regular == 1.0 ? d_sum : 1.0, divisor_lo = regular == 1.0 ? d_sum_lo : 0.0;
  const double n0_0_sum = n0_0 + n0_0_lo, n0_0_sum_right = n0_0_sum - n0_0,
      divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), quotient_0 = n0_0_sum / divisor_sum,
      quotient_0_product = KSL_MUL(quotient_0, divisor_sum),
      quotient_0_exact = n0_0_sum - quotient_0_product
          - ksl_product_error(quotient_0, divisor_sum, quotient_0_product),
      quotient_0_residual = quotient_0_exact
          + (n0_0 - (n0_0_sum - n0_0_sum_right) + (n0_0_lo - n0_0_sum_right))
          - KSL_MUL(quotient_0, divisor_sum_lo), quotient_0_lo = quotient_0_residual / divisor_sum;
  const double n0_1_sum = n0_1 + n0_1_lo, n0_1_sum_right = n0_1_sum - n0_1,
      quotient_1 = n0_1_sum / divisor_sum, quotient_1_product = KSL_MUL(quotient_1, divisor_sum),
      quotient_1_exact = n0_1_sum - quotient_1_product
          - ksl_product_error(quotient_1, divisor_sum, quotient_1_product),
      quotient_1_residual = quotient_1_exact
          + (n0_1 - (n0_1_sum - n0_1_sum_right) + (n0_1_lo - n0_1_sum_right))
          - KSL_MUL(quotient_1, divisor_sum_lo), quotient_1_lo = quotient_1_residual / divisor_sum;
  const double n0_2_sum = n0_2 + n0_2_lo, n0_2_sum_right = n0_2_sum - n0_2,
      quotient_2 = n0_2_sum / divisor_sum, quotient_2_product = KSL_MUL(quotient_2, divisor_sum),
      quotient_2_exact = n0_2_sum - quotient_2_product
          - ksl_product_error(quotient_2, divisor_sum, quotient_2_product),
      quotient_2_residual = quotient_2_exact
          + (n0_2 - (n0_2_sum - n0_2_sum_right) + (n0_2_lo - n0_2_sum_right))
          - KSL_MUL(quotient_2, divisor_sum_lo), quotient_2_lo = quotient_2_residual / divisor_sum;
  const double n1_0_sum = n1_0 + n1_0_lo, n1_0_sum_right = n1_0_sum - n1_0,
      quotient_3 = n1_0_sum / divisor_sum, quotient_3_product = KSL_MUL(quotient_3, divisor_sum),
      quotient_3_exact = n1_0_sum - quotient_3_product
          - ksl_product_error(quotient_3, divisor_sum, quotient_3_product),
      quotient_3_residual = quotient_3_exact
          + (n1_0 - (n1_0_sum - n1_0_sum_right) + (n1_0_lo - n1_0_sum_right))
          - KSL_MUL(quotient_3, divisor_sum_lo), quotient_3_lo = quotient_3_residual / divisor_sum;
  const double n1_1_sum = n1_1 + n1_1_lo, n1_1_sum_right = n1_1_sum - n1_1,
      quotient_4 = n1_1_sum / divisor_sum, quotient_4_product = KSL_MUL(quotient_4, divisor_sum),
      quotient_4_exact = n1_1_sum - quotient_4_product
          - ksl_product_error(quotient_4, divisor_sum, quotient_4_product),
      quotient_4_residual = quotient_4_exact
          + (n1_1 - (n1_1_sum - n1_1_sum_right) + (n1_1_lo - n1_1_sum_right))
          - KSL_MUL(quotient_4, divisor_sum_lo), quotient_4_lo = quotient_4_residual / divisor_sum;
  const double n1_2_sum = n1_2 + n1_2_lo, n1_2_sum_right = n1_2_sum - n1_2,
      quotient_5 = n1_2_sum / divisor_sum, quotient_5_product = KSL_MUL(quotient_5, divisor_sum),
      quotient_5_exact = n1_2_sum - quotient_5_product
          - ksl_product_error(quotient_5, divisor_sum, quotient_5_product),
      quotient_5_residual = quotient_5_exact
          + (n1_2 - (n1_2_sum - n1_2_sum_right) + (n1_2_lo - n1_2_sum_right))
          - KSL_MUL(quotient_5, divisor_sum_lo), quotient_5_lo = quotient_5_residual / divisor_sum;
  const double n2_0_sum = n2_0 + n2_0_lo, n2_0_sum_right = n2_0_sum - n2_0,
      quotient_6 = n2_0_sum / divisor_sum, quotient_6_product = KSL_MUL(quotient_6, divisor_sum),
      quotient_6_exact = n2_0_sum - quotient_6_product
          - ksl_product_error(quotient_6, divisor_sum, quotient_6_product),
      quotient_6_residual = quotient_6_exact
          + (n2_0 - (n2_0_sum - n2_0_sum_right) + (n2_0_lo - n2_0_sum_right))
          - KSL_MUL(quotient_6, divisor_sum_lo), quotient_6_lo = quotient_6_residual / divisor_sum;
  const double n2_1_sum = n2_1 + n2_1_lo, n2_1_sum_right = n2_1_sum - n2_1,
      quotient_7 = n2_1_sum / divisor_sum, quotient_7_product = KSL_MUL(quotient_7, divisor_sum),
      quotient_7_exact = n2_1_sum - quotient_7_product
          - ksl_product_error(quotient_7, divisor_sum, quotient_7_product),
      quotient_7_residual = quotient_7_exact
          + (n2_1 - (n2_1_sum - n2_1_sum_right) + (n2_1_lo - n2_1_sum_right))
          - KSL_MUL(quotient_7, divisor_sum_lo), quotient_7_lo = quotient_7_residual / divisor_sum;
  const double n2_2_sum = n2_2 + n2_2_lo, n2_2_sum_right = n2_2_sum - n2_2,
      quotient_8 = n2_2_sum / divisor_sum, quotient_8_product = KSL_MUL(quotient_8, divisor_sum),
      quotient_8_exact = n2_2_sum - quotient_8_product
          - ksl_product_error(quotient_8, divisor_sum, quotient_8_product),
      quotient_8_residual = quotient_8_exact
          + (n2_2 - (n2_2_sum - n2_2_sum_right) + (n2_2_lo - n2_2_sum_right))
          - KSL_MUL(quotient_8, divisor_sum_lo), quotient_8_lo = quotient_8_residual / divisor_sum;
  const double quotient_0_sum = quotient_0 + quotient_0_lo,
      quotient_0_sum_right = quotient_0_sum - quotient_0, inverse_0 = KSL_MUL(quotient_0_sum, s),
      inverse_0_inverse = 1.0 / s,
      quotient_0_sum_lo = quotient_0 - (quotient_0_sum - quotient_0_sum_right)
          + (quotient_0_lo - quotient_0_sum_right),
      inverse_0_lo = KSL_MUL(quotient_0_sum - KSL_MUL(inverse_0, inverse_0_inverse)
          + quotient_0_sum_lo, s);
  const double quotient_1_sum = quotient_1 + quotient_1_lo,
      quotient_1_sum_right = quotient_1_sum - quotient_1, inverse_1 = KSL_MUL(quotient_1_sum, s),
      quotient_1_sum_lo = quotient_1 - (quotient_1_sum - quotient_1_sum_right)
          + (quotient_1_lo - quotient_1_sum_right),
      inverse_1_lo = KSL_MUL(quotient_1_sum - KSL_MUL(inverse_1, inverse_0_inverse)
          + quotient_1_sum_lo, s);
  const double quotient_2_sum = quotient_2 + quotient_2_lo,
      quotient_2_sum_right = quotient_2_sum - quotient_2, inverse_2 = KSL_MUL(quotient_2_sum, s),
      quotient_2_sum_lo = quotient_2 - (quotient_2_sum - quotient_2_sum_right)
          + (quotient_2_lo - quotient_2_sum_right),
      inverse_2_lo = KSL_MUL(quotient_2_sum - KSL_MUL(inverse_2, inverse_0_inverse)
          + quotient_2_sum_lo, s);
  const double quotient_3_sum = quotient_3 + quotient_3_lo,
      quotient_3_sum_right = quotient_3_sum - quotient_3, inverse_3 = KSL_MUL(quotient_3_sum, s),
      quotient_3_sum_lo = quotient_3 - (quotient_3_sum - quotient_3_sum_right)
          + (quotient_3_lo - quotient_3_sum_right),
      inverse_3_lo = KSL_MUL(quotient_3_sum - KSL_MUL(inverse_3, inverse_0_inverse)
          + quotient_3_sum_lo, s);
  const double quotient_4_sum = quotient_4 + quotient_4_lo,
      quotient_4_sum_right = quotient_4_sum - quotient_4, inverse_4 = KSL_MUL(quotient_4_sum, s),
      quotient_4_sum_lo = quotient_4 - (quotient_4_sum - quotient_4_sum_right)
          + (quotient_4_lo - quotient_4_sum_right),
      inverse_4_lo = KSL_MUL(quotient_4_sum - KSL_MUL(inverse_4, inverse_0_inverse)
          + quotient_4_sum_lo, s);
  const double quotient_5_sum = quotient_5 + quotient_5_lo,
      quotient_5_sum_right = quotient_5_sum - quotient_5, inverse_5 = KSL_MUL(quotient_5_sum, s),
      quotient_5_sum_lo = quotient_5 - (quotient_5_sum - quotient_5_sum_right)
          + (quotient_5_lo - quotient_5_sum_right),
      inverse_5_lo = KSL_MUL(quotient_5_sum - KSL_MUL(inverse_5, inverse_0_inverse)
          + quotient_5_sum_lo, s);
  const double quotient_6_sum = quotient_6 + quotient_6_lo,
      quotient_6_sum_right = quotient_6_sum - quotient_6, inverse_6 = KSL_MUL(quotient_6_sum, s),
      quotient_6_sum_lo = quotient_6 - (quotient_6_sum - quotient_6_sum_right)
          + (quotient_6_lo - quotient_6_sum_right),
      inverse_6_lo = KSL_MUL(quotient_6_sum - KSL_MUL(inverse_6, inverse_0_inverse)
          + quotient_6_sum_lo, s);
  const double quotient_7_sum = quotient_7 + quotient_7_lo,
      quotient_7_sum_right = quotient_7_sum - quotient_7, inverse_7 = KSL_MUL(quotient_7_sum, s),
      quotient_7_sum_lo = quotient_7 - (quotient_7_sum - quotient_7_sum_right)
          + (quotient_7_lo - quotient_7_sum_right),
      inverse_7_lo = KSL_MUL(quotient_7_sum - KSL_MUL(inverse_7, inverse_0_inverse)
          + quotient_7_sum_lo, s);
  const double quotient_8_sum = quotient_8 + quotient_8_lo,
      quotient_8_sum_right = quotient_8_sum - quotient_8, inverse_8 = KSL_MUL(quotient_8_sum, s),
      quotient_8_sum_lo = quotient_8 - (quotient_8_sum - quotient_8_sum_right)
          + (quotient_8_lo - quotient_8_sum_right),
      inverse_8_lo = KSL_MUL(quotient_8_sum - KSL_MUL(inverse_8, inverse_0_inverse)
          + quotient_8_sum_lo, s);
  const double start_a = -8.452712498170644e+270,
      start_c = d_sum < 0.0 ? start_a : 8.452712498170644e+270,
      start = R_largest8 < 4.149515568880993e+180 ? d_sum : start_c,
      start_lo = R_largest8 < 4.149515568880993e+180 ? d_sum_lo : 0.0;
  const double r2 = R_largest8 < 4.909093465297727e-91 ? 1.1830521861667747e-271 : 1.0;
  const double start_sum = start + start_lo, start_sum_right = start_sum - start,
      once = KSL_MUL(start_sum, r2),
      once_lo = KSL_MUL(start_sum - KSL_MUL(once, 1.0 / r2)
          + (start - (start_sum - start_sum_right) + (start_lo - start_sum_right)), r2);
  const double r3 = R_largest8 < 2.409919865102884e-181 ? 1.1830521861667747e-271 : 1.0;
  const double once_sum = once + once_lo, once_sum_right = once_sum - once,
      twice = KSL_MUL(once_sum, r3),
      twice_lo = KSL_MUL(once_sum - KSL_MUL(twice, 1.0 / r3)
          + (once - (once_sum - once_sum_right) + (once_lo - once_sum_right)), r3);
  const double r_a = R_largest8 < 2.037035976334486e+90 ? 1.0 : 8.452712498170644e+270,
      r = R_largest8 < 1.0 ? 1.1830521861667747e-271 : r_a;
  const double twice_sum = twice + twice_lo, twice_sum_right = twice_sum - twice,
      det_R = KSL_MUL(twice_sum, r),
      det_R_lo = KSL_MUL(twice_sum - KSL_MUL(det_R, 1.0 / r)
          + (twice - (twice_sum - twice_sum_right) + (twice_lo - twice_sum_right)), r);
  const double det = regular == 1.0 ? det_R : 0.0;
  const double Ro_00 = regular == 1.0 ? inverse_0 : (double)NAN,
      Ro_01 = regular == 1.0 ? inverse_1 : (double)NAN,
      Ro_02 = regular == 1.0 ? inverse_2 : (double)NAN,
      Ro_10 = regular == 1.0 ? inverse_3 : (double)NAN,
      Ro_11 = regular == 1.0 ? inverse_4 : (double)NAN,
      Ro_12 = regular == 1.0 ? inverse_5 : (double)NAN,
      Ro_20 = regular == 1.0 ? inverse_6 : (double)NAN,
      Ro_21 = regular == 1.0 ? inverse_7 : (double)NAN,
      Ro_22 = regular == 1.0 ? inverse_8 : (double)NAN;
  const double det_rounded = det + (regular == 1.0 ? det_R_lo : 0.0);
  const double Ro_00_rounded = Ro_00 + (regular == 1.0 ? inverse_0_lo : 0.0);
  const double Ro_01_rounded = Ro_01 + (regular == 1.0 ? inverse_1_lo : 0.0);
  const double Ro_02_rounded = Ro_02 + (regular == 1.0 ? inverse_2_lo : 0.0);
  const double Ro_10_rounded = Ro_10 + (regular == 1.0 ? inverse_3_lo : 0.0);
  const double Ro_11_rounded = Ro_11 + (regular == 1.0 ? inverse_4_lo : 0.0);
  const double Ro_12_rounded = Ro_12 + (regular == 1.0 ? inverse_5_lo : 0.0);
  const double Ro_20_rounded = Ro_20 + (regular == 1.0 ? inverse_6_lo : 0.0);
  const double Ro_21_rounded = Ro_21 + (regular == 1.0 ? inverse_7_lo : 0.0);
  const double Ro_22_rounded = Ro_22 + (regular == 1.0 ? inverse_8_lo : 0.0);
  const double det_final = det_rounded == det_rounded ? det_rounded : det;
  const double Ro_00_final = Ro_00_rounded == Ro_00_rounded ? Ro_00_rounded : Ro_00;
  const double Ro_01_final = Ro_01_rounded == Ro_01_rounded ? Ro_01_rounded : Ro_01;
  const double Ro_02_final = Ro_02_rounded == Ro_02_rounded ? Ro_02_rounded : Ro_02;
  const double Ro_10_final = Ro_10_rounded == Ro_10_rounded ? Ro_10_rounded : Ro_10;
  const double Ro_11_final = Ro_11_rounded == Ro_11_rounded ? Ro_11_rounded : Ro_11;
  const double Ro_12_final = Ro_12_rounded == Ro_12_rounded ? Ro_12_rounded : Ro_12;
  const double Ro_20_final = Ro_20_rounded == Ro_20_rounded ? Ro_20_rounded : Ro_20;
  const double Ro_21_final = Ro_21_rounded == Ro_21_rounded ? Ro_21_rounded : Ro_21;
  const double Ro_22_final = Ro_22_rounded == Ro_22_rounded ? Ro_22_rounded : Ro_22;
  Ro->m00 = Ro_00_final;
  Ro->m01 = Ro_01_final;
  Ro->m02 = Ro_02_final;
  Ro->m10 = Ro_10_final;
  Ro->m11 = Ro_11_final;
  Ro->m12 = Ro_12_final;
  Ro->m20 = Ro_20_final;
  Ro->m21 = Ro_21_final;
  Ro->m22 = Ro_22_final;
  return det_final;
}

/* self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
     its side of the first, the third on its side of both; NaN where the rows are linearly
     dependent to rounding.
   self: rotation or other 3×3 matrix.
   154 mul, 405 add, 16 product error, 33 product rest, 31 div, 4 sqrt, 7 neg, 10 abs, 25 less,
     18 equal, 70 select.
   |R R^T - I|_ij <= 8 u for the result R; searched, not proved. */
static inline void ksl_mat3x3_normalize_accurate(ksl_mat3x3_t *self) {
  const double q0_s_size_0 = fabs(self->m00), q0_s_size_1 = fabs(self->m01),
      q0_s_size_2 = fabs(self->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = KSL_MUL(self->m00, q0_s), q0_y_1 = KSL_MUL(self->m01, q0_s),
      q0_y_2 = KSL_MUL(self->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = KSL_MUL(q0_y_0, q0_y_0), q0_n_b = KSL_MUL(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_c_right = q0_n_c - q0_n_a, q0_n_d = KSL_MUL(q0_y_2, q0_y_2),
      q0_n_e = q0_n_c + q0_n_d, q0_n_e_right = q0_n_e - q0_n_c,
      q0_n_c_lo = ksl_product_rest(q0_y_0, q0_y_0, q0_n_a, q0_n_c - q0_n_c_right)
          + ksl_product_rest(q0_y_1, q0_y_1, q0_n_b, q0_n_c_right),
      q0_n_e_lo = q0_n_c - (q0_n_e - q0_n_e_right)
          + ksl_product_rest(q0_y_2, q0_y_2, q0_n_d, q0_n_e_right) + q0_n_c_lo,
      q0_n_e_sum = q0_n_e + q0_n_e_lo, q0_n_e_sum_right = q0_n_e_sum - q0_n_e,
      q0_n = sqrt(q0_n_e_sum), q0_n_product = KSL_MUL(q0_n, q0_n),
      q0_n_e_sum_lo = q0_n_e - (q0_n_e_sum - q0_n_e_sum_right) + (q0_n_e_lo - q0_n_e_sum_right),
      q0_n_twice = q0_n + q0_n,
      q0_n_lo = (q0_n_e_sum - q0_n_product - ksl_product_error(q0_n, q0_n, q0_n_product)
          + q0_n_e_sum_lo) / (q0_n == 0.0 ? 1.0 : q0_n_twice);
  const double q0_n_sum = q0_n + q0_n_lo, q0_n_sum_right = q0_n_sum - q0_n,
      q0_n_sum_lo = q0_n - (q0_n_sum - q0_n_sum_right) + (q0_n_lo - q0_n_sum_right),
      q0_divisor = q0_n_sum == 0.0 ? q0_up : q0_n_sum,
      q0_divisor_lo = q0_n_sum == 0.0 ? 0.0 : q0_n_sum_lo;
  const double q0_sized_0 = KSL_MUL(self->m00, q0_up), q0_sized_1 = KSL_MUL(self->m01, q0_up),
      q0_sized_2 = KSL_MUL(self->m02, q0_up);
  const double q0_divisor_sum = q0_divisor + q0_divisor_lo,
      q0_divisor_sum_right = q0_divisor_sum - q0_divisor,
      q0_divisor_sum_lo = q0_divisor - (q0_divisor_sum - q0_divisor_sum_right)
          + (q0_divisor_lo - q0_divisor_sum_right), q0_quotient_0 = q0_sized_0 / q0_divisor_sum,
      q0_quotient_0_product = KSL_MUL(q0_quotient_0, q0_divisor_sum),
      q0_quotient_0_exact = q0_sized_0 - q0_quotient_0_product
          - ksl_product_error(q0_quotient_0, q0_divisor_sum, q0_quotient_0_product),
      q0_quotient_0_lo = (q0_quotient_0_exact - KSL_MUL(q0_quotient_0, q0_divisor_sum_lo))
          / q0_divisor_sum;
  const double q0_quotient_1 = q0_sized_1 / q0_divisor_sum,
      q0_quotient_1_product = KSL_MUL(q0_quotient_1, q0_divisor_sum),
      q0_quotient_1_exact = q0_sized_1 - q0_quotient_1_product
          - ksl_product_error(q0_quotient_1, q0_divisor_sum, q0_quotient_1_product),
      q0_quotient_1_lo = (q0_quotient_1_exact - KSL_MUL(q0_quotient_1, q0_divisor_sum_lo))
          / q0_divisor_sum;
  const double q0_quotient_2 = q0_sized_2 / q0_divisor_sum,
      q0_quotient_2_product = KSL_MUL(q0_quotient_2, q0_divisor_sum),
      q0_quotient_2_exact = q0_sized_2 - q0_quotient_2_product
          - ksl_product_error(q0_quotient_2, q0_divisor_sum, q0_quotient_2_product),
      q0_quotient_2_lo = (q0_quotient_2_exact - KSL_MUL(q0_quotient_2, q0_divisor_sum_lo))
          / q0_divisor_sum;
  const double q0_quotient_0_sum = q0_quotient_0 + q0_quotient_0_lo,
      q0_quotient_0_sum_right = q0_quotient_0_sum - q0_quotient_0,
      q0_0 = KSL_MUL(q0_quotient_0_sum, q0_down), q0_0_inverse = 1.0 / q0_down,
      q0_quotient_0_sum_lo = q0_quotient_0 - (q0_quotient_0_sum - q0_quotient_0_sum_right)
          + (q0_quotient_0_lo - q0_quotient_0_sum_right),
      q0_0_lo = KSL_MUL(q0_quotient_0_sum - KSL_MUL(q0_0, q0_0_inverse)
          + q0_quotient_0_sum_lo, q0_down);
  const double q0_quotient_1_sum = q0_quotient_1 + q0_quotient_1_lo,
      q0_quotient_1_sum_right = q0_quotient_1_sum - q0_quotient_1,
      q0_1 = KSL_MUL(q0_quotient_1_sum, q0_down),
      q0_quotient_1_sum_lo = q0_quotient_1 - (q0_quotient_1_sum - q0_quotient_1_sum_right)
          + (q0_quotient_1_lo - q0_quotient_1_sum_right),
      q0_1_lo = KSL_MUL(q0_quotient_1_sum - KSL_MUL(q0_1, q0_0_inverse)
          + q0_quotient_1_sum_lo, q0_down);
  const double q0_quotient_2_sum = q0_quotient_2 + q0_quotient_2_lo,
      q0_quotient_2_sum_right = q0_quotient_2_sum - q0_quotient_2,
      q0_2 = KSL_MUL(q0_quotient_2_sum, q0_down),
      q0_quotient_2_sum_lo = q0_quotient_2 - (q0_quotient_2_sum - q0_quotient_2_sum_right)
          + (q0_quotient_2_lo - q0_quotient_2_sum_right),
      q0_2_lo = KSL_MUL(q0_quotient_2_sum - KSL_MUL(q0_2, q0_0_inverse)
          + q0_quotient_2_sum_lo, q0_down);
  const double u1_s_size_0 = fabs(self->m10), u1_s_size_1 = fabs(self->m11),
      u1_s_size_2 = fabs(self->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = KSL_MUL(self->m10, u1_s), u1_y_1 = KSL_MUL(self->m11, u1_s),
      u1_y_2 = KSL_MUL(self->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = KSL_MUL(u1_y_0, u1_y_0), u1_n_b = KSL_MUL(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_c_right = u1_n_c - u1_n_a, u1_n_d = KSL_MUL(u1_y_2, u1_y_2),
      u1_n_e = u1_n_c + u1_n_d, u1_n_e_right = u1_n_e - u1_n_c,
      u1_n_c_lo = ksl_product_rest(u1_y_0, u1_y_0, u1_n_a, u1_n_c - u1_n_c_right)
          + ksl_product_rest(u1_y_1, u1_y_1, u1_n_b, u1_n_c_right),
      u1_n_e_lo = u1_n_c - (u1_n_e - u1_n_e_right)
          + ksl_product_rest(u1_y_2, u1_y_2, u1_n_d, u1_n_e_right) + u1_n_c_lo,
      u1_n_e_sum = u1_n_e + u1_n_e_lo, u1_n_e_sum_right = u1_n_e_sum - u1_n_e,
      u1_n = sqrt(u1_n_e_sum), u1_n_product = KSL_MUL(u1_n, u1_n),
      u1_n_e_sum_lo = u1_n_e - (u1_n_e_sum - u1_n_e_sum_right) + (u1_n_e_lo - u1_n_e_sum_right),
      u1_n_twice = u1_n + u1_n,
      u1_n_lo = (u1_n_e_sum - u1_n_product - ksl_product_error(u1_n, u1_n, u1_n_product)
          + u1_n_e_sum_lo) / (u1_n == 0.0 ? 1.0 : u1_n_twice);
  const double u1_n_sum = u1_n + u1_n_lo, u1_n_sum_right = u1_n_sum - u1_n,
      u1_n_sum_lo = u1_n - (u1_n_sum - u1_n_sum_right) + (u1_n_lo - u1_n_sum_right),
      u1_divisor = u1_n_sum == 0.0 ? u1_up : u1_n_sum,
      u1_divisor_lo = u1_n_sum == 0.0 ? 0.0 : u1_n_sum_lo;
  const double u1_sized_0 = KSL_MUL(self->m10, u1_up), u1_sized_1 = KSL_MUL(self->m11, u1_up),
      u1_sized_2 = KSL_MUL(self->m12, u1_up);
  const double u1_divisor_sum = u1_divisor + u1_divisor_lo,
      u1_divisor_sum_right = u1_divisor_sum - u1_divisor,
      u1_divisor_sum_lo = u1_divisor - (u1_divisor_sum - u1_divisor_sum_right)
          + (u1_divisor_lo - u1_divisor_sum_right), u1_quotient_0 = u1_sized_0 / u1_divisor_sum,
      u1_quotient_0_product = KSL_MUL(u1_quotient_0, u1_divisor_sum),
      u1_quotient_0_exact = u1_sized_0 - u1_quotient_0_product
          - ksl_product_error(u1_quotient_0, u1_divisor_sum, u1_quotient_0_product),
      u1_quotient_0_lo = (u1_quotient_0_exact - KSL_MUL(u1_quotient_0, u1_divisor_sum_lo))
          / u1_divisor_sum;
  const double u1_quotient_1 = u1_sized_1 / u1_divisor_sum,
      u1_quotient_1_product = KSL_MUL(u1_quotient_1, u1_divisor_sum),
      u1_quotient_1_exact = u1_sized_1 - u1_quotient_1_product
          - ksl_product_error(u1_quotient_1, u1_divisor_sum, u1_quotient_1_product),
      u1_quotient_1_lo = (u1_quotient_1_exact - KSL_MUL(u1_quotient_1, u1_divisor_sum_lo))
          / u1_divisor_sum;
  const double u1_quotient_2 = u1_sized_2 / u1_divisor_sum,
      u1_quotient_2_product = KSL_MUL(u1_quotient_2, u1_divisor_sum),
      u1_quotient_2_exact = u1_sized_2 - u1_quotient_2_product
          - ksl_product_error(u1_quotient_2, u1_divisor_sum, u1_quotient_2_product),
      u1_quotient_2_lo = (u1_quotient_2_exact - KSL_MUL(u1_quotient_2, u1_divisor_sum_lo))
          / u1_divisor_sum;
  const double u1_quotient_0_sum = u1_quotient_0 + u1_quotient_0_lo,
      u1_quotient_0_sum_right = u1_quotient_0_sum - u1_quotient_0,
      u1_0 = KSL_MUL(u1_quotient_0_sum, u1_down), u1_0_inverse = 1.0 / u1_down,
      u1_quotient_0_sum_lo = u1_quotient_0 - (u1_quotient_0_sum - u1_quotient_0_sum_right)
          + (u1_quotient_0_lo - u1_quotient_0_sum_right),
      u1_0_lo = KSL_MUL(u1_quotient_0_sum - KSL_MUL(u1_0, u1_0_inverse)
          + u1_quotient_0_sum_lo, u1_down);
  const double u1_quotient_1_sum = u1_quotient_1 + u1_quotient_1_lo,
      u1_quotient_1_sum_right = u1_quotient_1_sum - u1_quotient_1,
      u1_1 = KSL_MUL(u1_quotient_1_sum, u1_down),
      u1_quotient_1_sum_lo = u1_quotient_1 - (u1_quotient_1_sum - u1_quotient_1_sum_right)
          + (u1_quotient_1_lo - u1_quotient_1_sum_right),
      u1_1_lo = KSL_MUL(u1_quotient_1_sum - KSL_MUL(u1_1, u1_0_inverse)
          + u1_quotient_1_sum_lo, u1_down);
  const double u1_quotient_2_sum = u1_quotient_2 + u1_quotient_2_lo,
      u1_quotient_2_sum_right = u1_quotient_2_sum - u1_quotient_2,
      u1_2 = KSL_MUL(u1_quotient_2_sum, u1_down),
      u1_quotient_2_sum_lo = u1_quotient_2 - (u1_quotient_2_sum - u1_quotient_2_sum_right)
          + (u1_quotient_2_lo - u1_quotient_2_sum_right),
      u1_2_lo = KSL_MUL(u1_quotient_2_sum - KSL_MUL(u1_2, u1_0_inverse)
          + u1_quotient_2_sum_lo, u1_down);
  const double along_a = KSL_MUL(q0_0, u1_0), along_b = KSL_MUL(q0_1, u1_1),
      along_c = along_a + along_b, along_c_right = along_c - along_a,
      along_c_lo1 = ksl_product_rest(q0_0, u1_0, along_a, along_c - along_c_right)
          + ksl_product_rest(q0_1, u1_1, along_b, along_c_right), along_d = KSL_MUL(q0_2, u1_2),
      along = along_c + along_d, along_right = along - along_c,
      along_lo2 = along_c - (along - along_right)
          + ksl_product_rest(q0_2, u1_2, along_d, along_right)
          + (KSL_MUL(q0_2_lo, u1_2) + KSL_MUL(q0_2, u1_2_lo)),
      along_lo = along_lo2
          + (along_c_lo1
          + (KSL_MUL(q0_0_lo, u1_0) + KSL_MUL(q0_0, u1_0_lo)
          + (KSL_MUL(q0_1_lo, u1_1) + KSL_MUL(q0_1, u1_1_lo))));
  const double once_0a = KSL_MUL(q0_0, along), once_0 = u1_0 - once_0a,
      once_0_right = u1_0 - once_0,
      once_0_lo1 = u1_0 - (once_0 + once_0_right)
          - ksl_product_rest(q0_0, along, once_0a, once_0_right),
      once_0_lo = once_0_lo1 - (KSL_MUL(q0_0_lo, along) + KSL_MUL(q0_0, along_lo)) + u1_0_lo;
  const double once_1a = KSL_MUL(q0_1, along), once_1 = u1_1 - once_1a,
      once_1_right = u1_1 - once_1,
      once_1_lo1 = u1_1 - (once_1 + once_1_right)
          - ksl_product_rest(q0_1, along, once_1a, once_1_right),
      once_1_lo = once_1_lo1 - (KSL_MUL(q0_1_lo, along) + KSL_MUL(q0_1, along_lo)) + u1_1_lo;
  const double once_2a = KSL_MUL(q0_2, along), once_2 = u1_2 - once_2a,
      once_2_right = u1_2 - once_2,
      once_2_lo1 = u1_2 - (once_2 + once_2_right)
          - ksl_product_rest(q0_2, along, once_2a, once_2_right),
      once_2_lo = once_2_lo1 - (KSL_MUL(q0_2_lo, along) + KSL_MUL(q0_2, along_lo)) + u1_2_lo;
  const double rest_a = KSL_MUL(q0_0, once_0), rest_b = KSL_MUL(q0_1, once_1),
      rest_c = rest_a + rest_b, rest_c_right = rest_c - rest_a,
      rest_c_lo1 = ksl_product_rest(q0_0, once_0, rest_a, rest_c - rest_c_right)
          + ksl_product_rest(q0_1, once_1, rest_b, rest_c_right), rest_d = KSL_MUL(q0_2, once_2),
      rest = rest_c + rest_d, rest_right = rest - rest_c,
      rest_lo2 = rest_c - (rest - rest_right) + ksl_product_rest(q0_2, once_2, rest_d, rest_right)
          + (KSL_MUL(q0_2_lo, once_2) + KSL_MUL(q0_2, once_2_lo)),
      rest_lo = rest_lo2
          + (rest_c_lo1
          + (KSL_MUL(q0_0_lo, once_0) + KSL_MUL(q0_0, once_0_lo)
          + (KSL_MUL(q0_1_lo, once_1) + KSL_MUL(q0_1, once_1_lo))));
  const double twice_0a = KSL_MUL(q0_0, rest), twice_0 = once_0 - twice_0a,
      twice_0_right = once_0 - twice_0,
      twice_0_lo1 = once_0 - (twice_0 + twice_0_right)
          - ksl_product_rest(q0_0, rest, twice_0a, twice_0_right),
      twice_0_lo = twice_0_lo1 - (KSL_MUL(q0_0_lo, rest) + KSL_MUL(q0_0, rest_lo)) + once_0_lo;
  const double twice_1a = KSL_MUL(q0_1, rest), twice_1 = once_1 - twice_1a,
      twice_1_right = once_1 - twice_1,
      twice_1_lo1 = once_1 - (twice_1 + twice_1_right)
          - ksl_product_rest(q0_1, rest, twice_1a, twice_1_right),
      twice_1_lo = twice_1_lo1 - (KSL_MUL(q0_1_lo, rest) + KSL_MUL(q0_1, rest_lo)) + once_1_lo;
  const double twice_2a = KSL_MUL(q0_2, rest), twice_2 = once_2 - twice_2a,
      twice_2_right = once_2 - twice_2,
      twice_2_lo1 = once_2 - (twice_2 + twice_2_right)
          - ksl_product_rest(q0_2, rest, twice_2a, twice_2_right),
      twice_2_lo = twice_2_lo1 - (KSL_MUL(q0_2_lo, rest) + KSL_MUL(q0_2, rest_lo)) + once_2_lo;
  const double n_a = KSL_MUL(twice_0, twice_0), n_b = KSL_MUL(twice_1, twice_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a,
      n_c_cross = KSL_MUL(twice_0_lo, twice_0) + KSL_MUL(twice_0, twice_0_lo)
          + (KSL_MUL(twice_1_lo, twice_1) + KSL_MUL(twice_1, twice_1_lo)),
      n_d = KSL_MUL(twice_2, twice_2), n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_e_lo2 = n_c - (n_e - n_e_right) + ksl_product_rest(twice_2, twice_2, n_d, n_e_right)
          + (KSL_MUL(twice_2_lo, twice_2) + KSL_MUL(twice_2, twice_2_lo)),
      n_e_lo = n_e_lo2
          + (ksl_product_rest(twice_0, twice_0, n_a, n_c - n_c_right)
          + ksl_product_rest(twice_1, twice_1, n_b, n_c_right) + n_c_cross), n_e_sum = n_e + n_e_lo,
      n_e_sum_right = n_e_sum - n_e, n = sqrt(n_e_sum), n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_e_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      divisor = n_sum == 0.0 ? 1.0 : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double twice_0_sum = twice_0 + twice_0_lo, twice_0_sum_right = twice_0_sum - twice_0,
      divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), q1_0 = twice_0_sum / divisor_sum,
      q1_0_product = KSL_MUL(q1_0, divisor_sum),
      q1_0_exact = twice_0_sum - q1_0_product - ksl_product_error(q1_0, divisor_sum, q1_0_product),
      q1_0_residual = q1_0_exact
          + (twice_0 - (twice_0_sum - twice_0_sum_right) + (twice_0_lo - twice_0_sum_right))
          - KSL_MUL(q1_0, divisor_sum_lo), q1_0_lo = q1_0_residual / divisor_sum;
  const double twice_1_sum = twice_1 + twice_1_lo, twice_1_sum_right = twice_1_sum - twice_1,
      q1_1 = twice_1_sum / divisor_sum, q1_1_product = KSL_MUL(q1_1, divisor_sum),
      q1_1_exact = twice_1_sum - q1_1_product - ksl_product_error(q1_1, divisor_sum, q1_1_product),
      q1_1_residual = q1_1_exact
          + (twice_1 - (twice_1_sum - twice_1_sum_right) + (twice_1_lo - twice_1_sum_right))
          - KSL_MUL(q1_1, divisor_sum_lo), q1_1_lo = q1_1_residual / divisor_sum;
  const double twice_2_sum = twice_2 + twice_2_lo, twice_2_sum_right = twice_2_sum - twice_2,
      q1_2 = twice_2_sum / divisor_sum, q1_2_product = KSL_MUL(q1_2, divisor_sum),
      q1_2_exact = twice_2_sum - q1_2_product - ksl_product_error(q1_2, divisor_sum, q1_2_product),
      q1_2_residual = q1_2_exact
          + (twice_2 - (twice_2_sum - twice_2_sum_right) + (twice_2_lo - twice_2_sum_right))
          - KSL_MUL(q1_2, divisor_sum_lo), q1_2_lo = q1_2_residual / divisor_sum;
  const double normal_0a = KSL_MUL(q0_1, q1_2), normal_0b = KSL_MUL(q0_2, q1_1),
      normal_0 = normal_0a - normal_0b, normal_0_right = normal_0a - normal_0,
      normal_0_lo1 = ksl_product_rest(q0_1, q1_2, normal_0a, normal_0 + normal_0_right)
          - ksl_product_rest(q0_2, q1_1, normal_0b, normal_0_right),
      normal_0_lo = normal_0_lo1
          + (KSL_MUL(q0_1_lo, q1_2) + KSL_MUL(q0_1, q1_2_lo)
          - (KSL_MUL(q0_2_lo, q1_1) + KSL_MUL(q0_2, q1_1_lo)));
  const double normal_1a = KSL_MUL(q0_2, q1_0), normal_1b = KSL_MUL(q0_0, q1_2),
      normal_1 = normal_1a - normal_1b, normal_1_right = normal_1a - normal_1,
      normal_1_lo1 = ksl_product_rest(q0_2, q1_0, normal_1a, normal_1 + normal_1_right)
          - ksl_product_rest(q0_0, q1_2, normal_1b, normal_1_right),
      normal_1_lo = normal_1_lo1
          + (KSL_MUL(q0_2_lo, q1_0) + KSL_MUL(q0_2, q1_0_lo)
          - (KSL_MUL(q0_0_lo, q1_2) + KSL_MUL(q0_0, q1_2_lo)));
  const double normal_2a = KSL_MUL(q0_0, q1_1), normal_2b = KSL_MUL(q0_1, q1_0),
      normal_2 = normal_2a - normal_2b, normal_2_right = normal_2a - normal_2,
      normal_2_lo1 = ksl_product_rest(q0_0, q1_1, normal_2a, normal_2 + normal_2_right)
          - ksl_product_rest(q0_1, q1_0, normal_2b, normal_2_right),
      normal_2_lo = normal_2_lo1
          + (KSL_MUL(q0_0_lo, q1_1) + KSL_MUL(q0_0, q1_1_lo)
          - (KSL_MUL(q0_1_lo, q1_0) + KSL_MUL(q0_1, q1_0_lo)));
  const double u2_s_size_0 = fabs(self->m20), u2_s_size_1 = fabs(self->m21),
      u2_s_size_2 = fabs(self->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = KSL_MUL(self->m20, u2_s), u2_y_1 = KSL_MUL(self->m21, u2_s),
      u2_y_2 = KSL_MUL(self->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = KSL_MUL(u2_y_0, u2_y_0), u2_n_b = KSL_MUL(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_c_right = u2_n_c - u2_n_a, u2_n_d = KSL_MUL(u2_y_2, u2_y_2),
      u2_n_e = u2_n_c + u2_n_d, u2_n_e_right = u2_n_e - u2_n_c,
      u2_n_c_lo = ksl_product_rest(u2_y_0, u2_y_0, u2_n_a, u2_n_c - u2_n_c_right)
          + ksl_product_rest(u2_y_1, u2_y_1, u2_n_b, u2_n_c_right),
      u2_n_e_lo = u2_n_c - (u2_n_e - u2_n_e_right)
          + ksl_product_rest(u2_y_2, u2_y_2, u2_n_d, u2_n_e_right) + u2_n_c_lo,
      u2_n_e_sum = u2_n_e + u2_n_e_lo, u2_n_e_sum_right = u2_n_e_sum - u2_n_e,
      u2_n = sqrt(u2_n_e_sum), u2_n_product = KSL_MUL(u2_n, u2_n),
      u2_n_e_sum_lo = u2_n_e - (u2_n_e_sum - u2_n_e_sum_right) + (u2_n_e_lo - u2_n_e_sum_right),
      u2_n_twice = u2_n + u2_n,
      u2_n_lo = (u2_n_e_sum - u2_n_product - ksl_product_error(u2_n, u2_n, u2_n_product)
          + u2_n_e_sum_lo) / (u2_n == 0.0 ? 1.0 : u2_n_twice);
  const double u2_n_sum = u2_n + u2_n_lo, u2_n_sum_right = u2_n_sum - u2_n,
      u2_n_sum_lo = u2_n - (u2_n_sum - u2_n_sum_right) + (u2_n_lo - u2_n_sum_right),
      u2_divisor = u2_n_sum == 0.0 ? u2_up : u2_n_sum,
      u2_divisor_lo = u2_n_sum == 0.0 ? 0.0 : u2_n_sum_lo;
  const double u2_sized_0 = KSL_MUL(self->m20, u2_up), u2_sized_1 = KSL_MUL(self->m21, u2_up),
      u2_sized_2 = KSL_MUL(self->m22, u2_up);
  const double u2_divisor_sum = u2_divisor + u2_divisor_lo,
      u2_divisor_sum_right = u2_divisor_sum - u2_divisor,
      u2_divisor_sum_lo = u2_divisor - (u2_divisor_sum - u2_divisor_sum_right)
          + (u2_divisor_lo - u2_divisor_sum_right), u2_quotient_0 = u2_sized_0 / u2_divisor_sum,
      u2_quotient_0_product = KSL_MUL(u2_quotient_0, u2_divisor_sum),
      u2_quotient_0_exact = u2_sized_0 - u2_quotient_0_product
          - ksl_product_error(u2_quotient_0, u2_divisor_sum, u2_quotient_0_product),
      u2_quotient_0_lo = (u2_quotient_0_exact - KSL_MUL(u2_quotient_0, u2_divisor_sum_lo))
          / u2_divisor_sum;
  const double u2_quotient_1 = u2_sized_1 / u2_divisor_sum,
      u2_quotient_1_product = KSL_MUL(u2_quotient_1, u2_divisor_sum),
      u2_quotient_1_exact = u2_sized_1 - u2_quotient_1_product
          - ksl_product_error(u2_quotient_1, u2_divisor_sum, u2_quotient_1_product),
      u2_quotient_1_lo = (u2_quotient_1_exact - KSL_MUL(u2_quotient_1, u2_divisor_sum_lo))
          / u2_divisor_sum;
  const double u2_quotient_2 = u2_sized_2 / u2_divisor_sum,
      u2_quotient_2_product = KSL_MUL(u2_quotient_2, u2_divisor_sum),
      u2_quotient_2_exact = u2_sized_2 - u2_quotient_2_product
          - ksl_product_error(u2_quotient_2, u2_divisor_sum, u2_quotient_2_product),
      u2_quotient_2_lo = (u2_quotient_2_exact - KSL_MUL(u2_quotient_2, u2_divisor_sum_lo))
          / u2_divisor_sum;
  const double u2_quotient_0_sum = u2_quotient_0 + u2_quotient_0_lo,
      u2_quotient_0_sum_right = u2_quotient_0_sum - u2_quotient_0,
      u2_0 = KSL_MUL(u2_quotient_0_sum, u2_down), u2_0_inverse = 1.0 / u2_down,
      u2_quotient_0_sum_lo = u2_quotient_0 - (u2_quotient_0_sum - u2_quotient_0_sum_right)
          + (u2_quotient_0_lo - u2_quotient_0_sum_right);
  const double u2_quotient_1_sum = u2_quotient_1 + u2_quotient_1_lo,
      u2_quotient_1_sum_right = u2_quotient_1_sum - u2_quotient_1,
      u2_1 = KSL_MUL(u2_quotient_1_sum, u2_down),
      u2_quotient_1_sum_lo = u2_quotient_1 - (u2_quotient_1_sum - u2_quotient_1_sum_right)
          + (u2_quotient_1_lo - u2_quotient_1_sum_right);
  const double u2_quotient_2_sum = u2_quotient_2 + u2_quotient_2_lo,
      u2_quotient_2_sum_right = u2_quotient_2_sum - u2_quotient_2,
      u2_2 = KSL_MUL(u2_quotient_2_sum, u2_down),
      u2_quotient_2_sum_lo = u2_quotient_2 - (u2_quotient_2_sum - u2_quotient_2_sum_right)
          + (u2_quotient_2_lo - u2_quotient_2_sum_right);
  const double side_a = KSL_MUL(normal_0, u2_0),
      side_a_cross2 = KSL_MUL(normal_0, KSL_MUL(u2_quotient_0_sum - KSL_MUL(u2_0, u2_0_inverse)
          + u2_quotient_0_sum_lo, u2_down)), side_b = KSL_MUL(normal_1, u2_1),
      side_b_cross2 = KSL_MUL(normal_1, KSL_MUL(u2_quotient_1_sum - KSL_MUL(u2_1, u2_0_inverse)
          + u2_quotient_1_sum_lo, u2_down)), side_c = side_a + side_b,
      side_c_right = side_c - side_a,
      side_c_lo1 = ksl_product_rest(normal_0, u2_0, side_a, side_c - side_c_right)
          + ksl_product_rest(normal_1, u2_1, side_b, side_c_right),
      side_d = KSL_MUL(normal_2, u2_2),
      side_d_cross2 = KSL_MUL(normal_2, KSL_MUL(u2_quotient_2_sum - KSL_MUL(u2_2, u2_0_inverse)
          + u2_quotient_2_sum_lo, u2_down)), side = side_c + side_d, side_right = side - side_c,
      side_lo2 = side_c - (side - side_right)
          + ksl_product_rest(normal_2, u2_2, side_d, side_right)
          + (KSL_MUL(normal_2_lo, u2_2) + side_d_cross2),
      side_lo = side_lo2
          + (side_c_lo1
          + (KSL_MUL(normal_0_lo, u2_0) + side_a_cross2
          + (KSL_MUL(normal_1_lo, u2_1) + side_b_cross2)));
  const double q2_0a = -normal_0, q2_0a_lo = -normal_0_lo, side_sum = side + side_lo,
      side_sum_right = side_sum - side,
      side_sum_lo = side - (side_sum - side_sum_right) + (side_lo - side_sum_right),
      q2_0 = side_sum < 0.0 ? q2_0a : normal_0, q2_0_lo = side_sum < 0.0 ? q2_0a_lo : normal_0_lo;
  const double q2_1a = -normal_1, q2_1a_lo = -normal_1_lo, q2_1 = side_sum < 0.0 ? q2_1a : normal_1,
      q2_1_lo = side_sum < 0.0 ? q2_1a_lo : normal_1_lo;
  const double q2_2a = -normal_2, q2_2a_lo = -normal_2_lo, q2_2 = side_sum < 0.0 ? q2_2a : normal_2,
      q2_2_lo = side_sum < 0.0 ? q2_2a_lo : normal_2_lo;
  const double size = fabs(side_sum), size_opposite = -side_sum_lo,
      size_lo = side_sum < 0.0 ? size_opposite : side_sum_lo;
  const double size_sum = size + size_lo, size_sum_right = size_sum - size,
      size_sum_lo = size - (size_sum - size_sum_right) + (size_lo - size_sum_right),
      less = n_sum < size_sum ? n_sum : size_sum;
  const double dependent = less + (n_sum < size_sum ? n_sum_lo : size_sum_lo)
          < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double self_00_new = dependent == 1.0 ? (double)NAN : q0_0,
      self_01_new = dependent == 1.0 ? (double)NAN : q0_1,
      self_02_new = dependent == 1.0 ? (double)NAN : q0_2,
      self_10_new = dependent == 1.0 ? (double)NAN : q1_0,
      self_11_new = dependent == 1.0 ? (double)NAN : q1_1,
      self_12_new = dependent == 1.0 ? (double)NAN : q1_2,
      self_20_new = dependent == 1.0 ? (double)NAN : q2_0,
      self_21_new = dependent == 1.0 ? (double)NAN : q2_1,
      self_22_new = dependent == 1.0 ? (double)NAN : q2_2;
  const double self_00_new_rounded = self_00_new + (dependent == 1.0 ? 0.0 : q0_0_lo);
  const double self_01_new_rounded = self_01_new + (dependent == 1.0 ? 0.0 : q0_1_lo);
  const double self_02_new_rounded = self_02_new + (dependent == 1.0 ? 0.0 : q0_2_lo);
  const double self_10_new_rounded = self_10_new + (dependent == 1.0 ? 0.0 : q1_0_lo);
  const double self_11_new_rounded = self_11_new + (dependent == 1.0 ? 0.0 : q1_1_lo);
  const double self_12_new_rounded = self_12_new + (dependent == 1.0 ? 0.0 : q1_2_lo);
  const double self_20_new_rounded = self_20_new + (dependent == 1.0 ? 0.0 : q2_0_lo);
  const double self_21_new_rounded = self_21_new + (dependent == 1.0 ? 0.0 : q2_1_lo);
  const double self_22_new_rounded = self_22_new + (dependent == 1.0 ? 0.0 : q2_2_lo);
  const double self_00_new_final = self_00_new_rounded == self_00_new_rounded ? self_00_new_rounded
          : self_00_new;
  const double self_01_new_final = self_01_new_rounded == self_01_new_rounded ? self_01_new_rounded
          : self_01_new;
  const double self_02_new_final = self_02_new_rounded == self_02_new_rounded ? self_02_new_rounded
          : self_02_new;
  const double self_10_new_final = self_10_new_rounded == self_10_new_rounded ? self_10_new_rounded
          : self_10_new;
  const double self_11_new_final = self_11_new_rounded == self_11_new_rounded ? self_11_new_rounded
          : self_11_new;
  const double self_12_new_final = self_12_new_rounded == self_12_new_rounded ? self_12_new_rounded
          : self_12_new;
  const double self_20_new_final = self_20_new_rounded == self_20_new_rounded ? self_20_new_rounded
          : self_20_new;
  const double self_21_new_final = self_21_new_rounded == self_21_new_rounded ? self_21_new_rounded
          : self_21_new;
  const double self_22_new_final = self_22_new_rounded == self_22_new_rounded ? self_22_new_rounded
          : self_22_new;
  self->m00 = self_00_new_final;
  self->m01 = self_01_new_final;
  self->m02 = self_02_new_final;
  self->m10 = self_10_new_final;
  self->m11 = self_11_new_final;
  self->m12 = self_12_new_final;
  self->m20 = self_20_new_final;
  self->m21 = self_21_new_final;
  self->m22 = self_22_new_final;
}

/* Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on its
     side of the first, the third on its side of both; NaN where the rows are linearly dependent
     to rounding.
   R, Ro: rotation or other 3×3 matrix.
   154 mul, 405 add, 16 product error, 33 product rest, 31 div, 4 sqrt, 7 neg, 10 abs, 25 less,
     18 equal, 70 select.
   |R R^T - I|_ij <= 8 u for the result R; searched, not proved. */
static inline void ksl_mat3x3_normalized_accurate(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double q0_s_size_0 = fabs(R->m00), q0_s_size_1 = fabs(R->m01), q0_s_size_2 = fabs(R->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = KSL_MUL(R->m00, q0_s), q0_y_1 = KSL_MUL(R->m01, q0_s),
      q0_y_2 = KSL_MUL(R->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = KSL_MUL(q0_y_0, q0_y_0), q0_n_b = KSL_MUL(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_c_right = q0_n_c - q0_n_a, q0_n_d = KSL_MUL(q0_y_2, q0_y_2),
      q0_n_e = q0_n_c + q0_n_d, q0_n_e_right = q0_n_e - q0_n_c,
      q0_n_c_lo = ksl_product_rest(q0_y_0, q0_y_0, q0_n_a, q0_n_c - q0_n_c_right)
          + ksl_product_rest(q0_y_1, q0_y_1, q0_n_b, q0_n_c_right),
      q0_n_e_lo = q0_n_c - (q0_n_e - q0_n_e_right)
          + ksl_product_rest(q0_y_2, q0_y_2, q0_n_d, q0_n_e_right) + q0_n_c_lo,
      q0_n_e_sum = q0_n_e + q0_n_e_lo, q0_n_e_sum_right = q0_n_e_sum - q0_n_e,
      q0_n = sqrt(q0_n_e_sum), q0_n_product = KSL_MUL(q0_n, q0_n),
      q0_n_e_sum_lo = q0_n_e - (q0_n_e_sum - q0_n_e_sum_right) + (q0_n_e_lo - q0_n_e_sum_right),
      q0_n_twice = q0_n + q0_n,
      q0_n_lo = (q0_n_e_sum - q0_n_product - ksl_product_error(q0_n, q0_n, q0_n_product)
          + q0_n_e_sum_lo) / (q0_n == 0.0 ? 1.0 : q0_n_twice);
  const double q0_n_sum = q0_n + q0_n_lo, q0_n_sum_right = q0_n_sum - q0_n,
      q0_n_sum_lo = q0_n - (q0_n_sum - q0_n_sum_right) + (q0_n_lo - q0_n_sum_right),
      q0_divisor = q0_n_sum == 0.0 ? q0_up : q0_n_sum,
      q0_divisor_lo = q0_n_sum == 0.0 ? 0.0 : q0_n_sum_lo;
  const double q0_sized_0 = KSL_MUL(R->m00, q0_up), q0_sized_1 = KSL_MUL(R->m01, q0_up),
      q0_sized_2 = KSL_MUL(R->m02, q0_up);
  const double q0_divisor_sum = q0_divisor + q0_divisor_lo,
      q0_divisor_sum_right = q0_divisor_sum - q0_divisor,
      q0_divisor_sum_lo = q0_divisor - (q0_divisor_sum - q0_divisor_sum_right)
          + (q0_divisor_lo - q0_divisor_sum_right), q0_quotient_0 = q0_sized_0 / q0_divisor_sum,
      q0_quotient_0_product = KSL_MUL(q0_quotient_0, q0_divisor_sum),
      q0_quotient_0_exact = q0_sized_0 - q0_quotient_0_product
          - ksl_product_error(q0_quotient_0, q0_divisor_sum, q0_quotient_0_product),
      q0_quotient_0_lo = (q0_quotient_0_exact - KSL_MUL(q0_quotient_0, q0_divisor_sum_lo))
          / q0_divisor_sum;
  const double q0_quotient_1 = q0_sized_1 / q0_divisor_sum,
      q0_quotient_1_product = KSL_MUL(q0_quotient_1, q0_divisor_sum),
      q0_quotient_1_exact = q0_sized_1 - q0_quotient_1_product
          - ksl_product_error(q0_quotient_1, q0_divisor_sum, q0_quotient_1_product),
      q0_quotient_1_lo = (q0_quotient_1_exact - KSL_MUL(q0_quotient_1, q0_divisor_sum_lo))
          / q0_divisor_sum;
  const double q0_quotient_2 = q0_sized_2 / q0_divisor_sum,
      q0_quotient_2_product = KSL_MUL(q0_quotient_2, q0_divisor_sum),
      q0_quotient_2_exact = q0_sized_2 - q0_quotient_2_product
          - ksl_product_error(q0_quotient_2, q0_divisor_sum, q0_quotient_2_product),
      q0_quotient_2_lo = (q0_quotient_2_exact - KSL_MUL(q0_quotient_2, q0_divisor_sum_lo))
          / q0_divisor_sum;
  const double q0_quotient_0_sum = q0_quotient_0 + q0_quotient_0_lo,
      q0_quotient_0_sum_right = q0_quotient_0_sum - q0_quotient_0,
      q0_0 = KSL_MUL(q0_quotient_0_sum, q0_down), q0_0_inverse = 1.0 / q0_down,
      q0_quotient_0_sum_lo = q0_quotient_0 - (q0_quotient_0_sum - q0_quotient_0_sum_right)
          + (q0_quotient_0_lo - q0_quotient_0_sum_right),
      q0_0_lo = KSL_MUL(q0_quotient_0_sum - KSL_MUL(q0_0, q0_0_inverse)
          + q0_quotient_0_sum_lo, q0_down);
  const double q0_quotient_1_sum = q0_quotient_1 + q0_quotient_1_lo,
      q0_quotient_1_sum_right = q0_quotient_1_sum - q0_quotient_1,
      q0_1 = KSL_MUL(q0_quotient_1_sum, q0_down),
      q0_quotient_1_sum_lo = q0_quotient_1 - (q0_quotient_1_sum - q0_quotient_1_sum_right)
          + (q0_quotient_1_lo - q0_quotient_1_sum_right),
      q0_1_lo = KSL_MUL(q0_quotient_1_sum - KSL_MUL(q0_1, q0_0_inverse)
          + q0_quotient_1_sum_lo, q0_down);
  const double q0_quotient_2_sum = q0_quotient_2 + q0_quotient_2_lo,
      q0_quotient_2_sum_right = q0_quotient_2_sum - q0_quotient_2,
      q0_2 = KSL_MUL(q0_quotient_2_sum, q0_down),
      q0_quotient_2_sum_lo = q0_quotient_2 - (q0_quotient_2_sum - q0_quotient_2_sum_right)
          + (q0_quotient_2_lo - q0_quotient_2_sum_right),
      q0_2_lo = KSL_MUL(q0_quotient_2_sum - KSL_MUL(q0_2, q0_0_inverse)
          + q0_quotient_2_sum_lo, q0_down);
  const double u1_s_size_0 = fabs(R->m10), u1_s_size_1 = fabs(R->m11), u1_s_size_2 = fabs(R->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = KSL_MUL(R->m10, u1_s), u1_y_1 = KSL_MUL(R->m11, u1_s),
      u1_y_2 = KSL_MUL(R->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = KSL_MUL(u1_y_0, u1_y_0), u1_n_b = KSL_MUL(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_c_right = u1_n_c - u1_n_a, u1_n_d = KSL_MUL(u1_y_2, u1_y_2),
      u1_n_e = u1_n_c + u1_n_d, u1_n_e_right = u1_n_e - u1_n_c,
      u1_n_c_lo = ksl_product_rest(u1_y_0, u1_y_0, u1_n_a, u1_n_c - u1_n_c_right)
          + ksl_product_rest(u1_y_1, u1_y_1, u1_n_b, u1_n_c_right),
      u1_n_e_lo = u1_n_c - (u1_n_e - u1_n_e_right)
          + ksl_product_rest(u1_y_2, u1_y_2, u1_n_d, u1_n_e_right) + u1_n_c_lo,
      u1_n_e_sum = u1_n_e + u1_n_e_lo, u1_n_e_sum_right = u1_n_e_sum - u1_n_e,
      u1_n = sqrt(u1_n_e_sum), u1_n_product = KSL_MUL(u1_n, u1_n),
      u1_n_e_sum_lo = u1_n_e - (u1_n_e_sum - u1_n_e_sum_right) + (u1_n_e_lo - u1_n_e_sum_right),
      u1_n_twice = u1_n + u1_n,
      u1_n_lo = (u1_n_e_sum - u1_n_product - ksl_product_error(u1_n, u1_n, u1_n_product)
          + u1_n_e_sum_lo) / (u1_n == 0.0 ? 1.0 : u1_n_twice);
  const double u1_n_sum = u1_n + u1_n_lo, u1_n_sum_right = u1_n_sum - u1_n,
      u1_n_sum_lo = u1_n - (u1_n_sum - u1_n_sum_right) + (u1_n_lo - u1_n_sum_right),
      u1_divisor = u1_n_sum == 0.0 ? u1_up : u1_n_sum,
      u1_divisor_lo = u1_n_sum == 0.0 ? 0.0 : u1_n_sum_lo;
  const double u1_sized_0 = KSL_MUL(R->m10, u1_up), u1_sized_1 = KSL_MUL(R->m11, u1_up),
      u1_sized_2 = KSL_MUL(R->m12, u1_up);
  const double u1_divisor_sum = u1_divisor + u1_divisor_lo,
      u1_divisor_sum_right = u1_divisor_sum - u1_divisor,
      u1_divisor_sum_lo = u1_divisor - (u1_divisor_sum - u1_divisor_sum_right)
          + (u1_divisor_lo - u1_divisor_sum_right), u1_quotient_0 = u1_sized_0 / u1_divisor_sum,
      u1_quotient_0_product = KSL_MUL(u1_quotient_0, u1_divisor_sum),
      u1_quotient_0_exact = u1_sized_0 - u1_quotient_0_product
          - ksl_product_error(u1_quotient_0, u1_divisor_sum, u1_quotient_0_product),
      u1_quotient_0_lo = (u1_quotient_0_exact - KSL_MUL(u1_quotient_0, u1_divisor_sum_lo))
          / u1_divisor_sum;
  const double u1_quotient_1 = u1_sized_1 / u1_divisor_sum,
      u1_quotient_1_product = KSL_MUL(u1_quotient_1, u1_divisor_sum),
      u1_quotient_1_exact = u1_sized_1 - u1_quotient_1_product
          - ksl_product_error(u1_quotient_1, u1_divisor_sum, u1_quotient_1_product),
      u1_quotient_1_lo = (u1_quotient_1_exact - KSL_MUL(u1_quotient_1, u1_divisor_sum_lo))
          / u1_divisor_sum;
  const double u1_quotient_2 = u1_sized_2 / u1_divisor_sum,
      u1_quotient_2_product = KSL_MUL(u1_quotient_2, u1_divisor_sum),
      u1_quotient_2_exact = u1_sized_2 - u1_quotient_2_product
          - ksl_product_error(u1_quotient_2, u1_divisor_sum, u1_quotient_2_product),
      u1_quotient_2_lo = (u1_quotient_2_exact - KSL_MUL(u1_quotient_2, u1_divisor_sum_lo))
          / u1_divisor_sum;
  const double u1_quotient_0_sum = u1_quotient_0 + u1_quotient_0_lo,
      u1_quotient_0_sum_right = u1_quotient_0_sum - u1_quotient_0,
      u1_0 = KSL_MUL(u1_quotient_0_sum, u1_down), u1_0_inverse = 1.0 / u1_down,
      u1_quotient_0_sum_lo = u1_quotient_0 - (u1_quotient_0_sum - u1_quotient_0_sum_right)
          + (u1_quotient_0_lo - u1_quotient_0_sum_right),
      u1_0_lo = KSL_MUL(u1_quotient_0_sum - KSL_MUL(u1_0, u1_0_inverse)
          + u1_quotient_0_sum_lo, u1_down);
  const double u1_quotient_1_sum = u1_quotient_1 + u1_quotient_1_lo,
      u1_quotient_1_sum_right = u1_quotient_1_sum - u1_quotient_1,
      u1_1 = KSL_MUL(u1_quotient_1_sum, u1_down),
      u1_quotient_1_sum_lo = u1_quotient_1 - (u1_quotient_1_sum - u1_quotient_1_sum_right)
          + (u1_quotient_1_lo - u1_quotient_1_sum_right),
      u1_1_lo = KSL_MUL(u1_quotient_1_sum - KSL_MUL(u1_1, u1_0_inverse)
          + u1_quotient_1_sum_lo, u1_down);
  const double u1_quotient_2_sum = u1_quotient_2 + u1_quotient_2_lo,
      u1_quotient_2_sum_right = u1_quotient_2_sum - u1_quotient_2,
      u1_2 = KSL_MUL(u1_quotient_2_sum, u1_down),
      u1_quotient_2_sum_lo = u1_quotient_2 - (u1_quotient_2_sum - u1_quotient_2_sum_right)
          + (u1_quotient_2_lo - u1_quotient_2_sum_right),
      u1_2_lo = KSL_MUL(u1_quotient_2_sum - KSL_MUL(u1_2, u1_0_inverse)
          + u1_quotient_2_sum_lo, u1_down);
  const double along_a = KSL_MUL(q0_0, u1_0), along_b = KSL_MUL(q0_1, u1_1),
      along_c = along_a + along_b, along_c_right = along_c - along_a,
      along_c_lo1 = ksl_product_rest(q0_0, u1_0, along_a, along_c - along_c_right)
          + ksl_product_rest(q0_1, u1_1, along_b, along_c_right), along_d = KSL_MUL(q0_2, u1_2),
      along = along_c + along_d, along_right = along - along_c,
      along_lo2 = along_c - (along - along_right)
          + ksl_product_rest(q0_2, u1_2, along_d, along_right)
          + (KSL_MUL(q0_2_lo, u1_2) + KSL_MUL(q0_2, u1_2_lo)),
      along_lo = along_lo2
          + (along_c_lo1
          + (KSL_MUL(q0_0_lo, u1_0) + KSL_MUL(q0_0, u1_0_lo)
          + (KSL_MUL(q0_1_lo, u1_1) + KSL_MUL(q0_1, u1_1_lo))));
  const double once_0a = KSL_MUL(q0_0, along), once_0 = u1_0 - once_0a,
      once_0_right = u1_0 - once_0,
      once_0_lo1 = u1_0 - (once_0 + once_0_right)
          - ksl_product_rest(q0_0, along, once_0a, once_0_right),
      once_0_lo = once_0_lo1 - (KSL_MUL(q0_0_lo, along) + KSL_MUL(q0_0, along_lo)) + u1_0_lo;
  const double once_1a = KSL_MUL(q0_1, along), once_1 = u1_1 - once_1a,
      once_1_right = u1_1 - once_1,
      once_1_lo1 = u1_1 - (once_1 + once_1_right)
          - ksl_product_rest(q0_1, along, once_1a, once_1_right),
      once_1_lo = once_1_lo1 - (KSL_MUL(q0_1_lo, along) + KSL_MUL(q0_1, along_lo)) + u1_1_lo;
  const double once_2a = KSL_MUL(q0_2, along), once_2 = u1_2 - once_2a,
      once_2_right = u1_2 - once_2,
      once_2_lo1 = u1_2 - (once_2 + once_2_right)
          - ksl_product_rest(q0_2, along, once_2a, once_2_right),
      once_2_lo = once_2_lo1 - (KSL_MUL(q0_2_lo, along) + KSL_MUL(q0_2, along_lo)) + u1_2_lo;
  const double rest_a = KSL_MUL(q0_0, once_0), rest_b = KSL_MUL(q0_1, once_1),
      rest_c = rest_a + rest_b, rest_c_right = rest_c - rest_a,
      rest_c_lo1 = ksl_product_rest(q0_0, once_0, rest_a, rest_c - rest_c_right)
          + ksl_product_rest(q0_1, once_1, rest_b, rest_c_right), rest_d = KSL_MUL(q0_2, once_2),
      rest = rest_c + rest_d, rest_right = rest - rest_c,
      rest_lo2 = rest_c - (rest - rest_right) + ksl_product_rest(q0_2, once_2, rest_d, rest_right)
          + (KSL_MUL(q0_2_lo, once_2) + KSL_MUL(q0_2, once_2_lo)),
      rest_lo = rest_lo2
          + (rest_c_lo1
          + (KSL_MUL(q0_0_lo, once_0) + KSL_MUL(q0_0, once_0_lo)
          + (KSL_MUL(q0_1_lo, once_1) + KSL_MUL(q0_1, once_1_lo))));
  const double twice_0a = KSL_MUL(q0_0, rest), twice_0 = once_0 - twice_0a,
      twice_0_right = once_0 - twice_0,
      twice_0_lo1 = once_0 - (twice_0 + twice_0_right)
          - ksl_product_rest(q0_0, rest, twice_0a, twice_0_right),
      twice_0_lo = twice_0_lo1 - (KSL_MUL(q0_0_lo, rest) + KSL_MUL(q0_0, rest_lo)) + once_0_lo;
  const double twice_1a = KSL_MUL(q0_1, rest), twice_1 = once_1 - twice_1a,
      twice_1_right = once_1 - twice_1,
      twice_1_lo1 = once_1 - (twice_1 + twice_1_right)
          - ksl_product_rest(q0_1, rest, twice_1a, twice_1_right),
      twice_1_lo = twice_1_lo1 - (KSL_MUL(q0_1_lo, rest) + KSL_MUL(q0_1, rest_lo)) + once_1_lo;
  const double twice_2a = KSL_MUL(q0_2, rest), twice_2 = once_2 - twice_2a,
      twice_2_right = once_2 - twice_2,
      twice_2_lo1 = once_2 - (twice_2 + twice_2_right)
          - ksl_product_rest(q0_2, rest, twice_2a, twice_2_right),
      twice_2_lo = twice_2_lo1 - (KSL_MUL(q0_2_lo, rest) + KSL_MUL(q0_2, rest_lo)) + once_2_lo;
  const double n_a = KSL_MUL(twice_0, twice_0), n_b = KSL_MUL(twice_1, twice_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a,
      n_c_cross = KSL_MUL(twice_0_lo, twice_0) + KSL_MUL(twice_0, twice_0_lo)
          + (KSL_MUL(twice_1_lo, twice_1) + KSL_MUL(twice_1, twice_1_lo)),
      n_d = KSL_MUL(twice_2, twice_2), n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_e_lo2 = n_c - (n_e - n_e_right) + ksl_product_rest(twice_2, twice_2, n_d, n_e_right)
          + (KSL_MUL(twice_2_lo, twice_2) + KSL_MUL(twice_2, twice_2_lo)),
      n_e_lo = n_e_lo2
          + (ksl_product_rest(twice_0, twice_0, n_a, n_c - n_c_right)
          + ksl_product_rest(twice_1, twice_1, n_b, n_c_right) + n_c_cross), n_e_sum = n_e + n_e_lo,
      n_e_sum_right = n_e_sum - n_e, n = sqrt(n_e_sum), n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_e_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      divisor = n_sum == 0.0 ? 1.0 : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double twice_0_sum = twice_0 + twice_0_lo, twice_0_sum_right = twice_0_sum - twice_0,
      divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), q1_0 = twice_0_sum / divisor_sum,
      q1_0_product = KSL_MUL(q1_0, divisor_sum),
      q1_0_exact = twice_0_sum - q1_0_product - ksl_product_error(q1_0, divisor_sum, q1_0_product),
      q1_0_residual = q1_0_exact
          + (twice_0 - (twice_0_sum - twice_0_sum_right) + (twice_0_lo - twice_0_sum_right))
          - KSL_MUL(q1_0, divisor_sum_lo), q1_0_lo = q1_0_residual / divisor_sum;
  const double twice_1_sum = twice_1 + twice_1_lo, twice_1_sum_right = twice_1_sum - twice_1,
      q1_1 = twice_1_sum / divisor_sum, q1_1_product = KSL_MUL(q1_1, divisor_sum),
      q1_1_exact = twice_1_sum - q1_1_product - ksl_product_error(q1_1, divisor_sum, q1_1_product),
      q1_1_residual = q1_1_exact
          + (twice_1 - (twice_1_sum - twice_1_sum_right) + (twice_1_lo - twice_1_sum_right))
          - KSL_MUL(q1_1, divisor_sum_lo), q1_1_lo = q1_1_residual / divisor_sum;
  const double twice_2_sum = twice_2 + twice_2_lo, twice_2_sum_right = twice_2_sum - twice_2,
      q1_2 = twice_2_sum / divisor_sum, q1_2_product = KSL_MUL(q1_2, divisor_sum),
      q1_2_exact = twice_2_sum - q1_2_product - ksl_product_error(q1_2, divisor_sum, q1_2_product),
      q1_2_residual = q1_2_exact
          + (twice_2 - (twice_2_sum - twice_2_sum_right) + (twice_2_lo - twice_2_sum_right))
          - KSL_MUL(q1_2, divisor_sum_lo), q1_2_lo = q1_2_residual / divisor_sum;
  const double normal_0a = KSL_MUL(q0_1, q1_2), normal_0b = KSL_MUL(q0_2, q1_1),
      normal_0 = normal_0a - normal_0b, normal_0_right = normal_0a - normal_0,
      normal_0_lo1 = ksl_product_rest(q0_1, q1_2, normal_0a, normal_0 + normal_0_right)
          - ksl_product_rest(q0_2, q1_1, normal_0b, normal_0_right),
      normal_0_lo = normal_0_lo1
          + (KSL_MUL(q0_1_lo, q1_2) + KSL_MUL(q0_1, q1_2_lo)
          - (KSL_MUL(q0_2_lo, q1_1) + KSL_MUL(q0_2, q1_1_lo)));
  const double normal_1a = KSL_MUL(q0_2, q1_0), normal_1b = KSL_MUL(q0_0, q1_2),
      normal_1 = normal_1a - normal_1b, normal_1_right = normal_1a - normal_1,
      normal_1_lo1 = ksl_product_rest(q0_2, q1_0, normal_1a, normal_1 + normal_1_right)
          - ksl_product_rest(q0_0, q1_2, normal_1b, normal_1_right),
      normal_1_lo = normal_1_lo1
          + (KSL_MUL(q0_2_lo, q1_0) + KSL_MUL(q0_2, q1_0_lo)
          - (KSL_MUL(q0_0_lo, q1_2) + KSL_MUL(q0_0, q1_2_lo)));
  const double normal_2a = KSL_MUL(q0_0, q1_1), normal_2b = KSL_MUL(q0_1, q1_0),
      normal_2 = normal_2a - normal_2b, normal_2_right = normal_2a - normal_2,
      normal_2_lo1 = ksl_product_rest(q0_0, q1_1, normal_2a, normal_2 + normal_2_right)
          - ksl_product_rest(q0_1, q1_0, normal_2b, normal_2_right),
      normal_2_lo = normal_2_lo1
          + (KSL_MUL(q0_0_lo, q1_1) + KSL_MUL(q0_0, q1_1_lo)
          - (KSL_MUL(q0_1_lo, q1_0) + KSL_MUL(q0_1, q1_0_lo)));
  const double u2_s_size_0 = fabs(R->m20), u2_s_size_1 = fabs(R->m21), u2_s_size_2 = fabs(R->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = KSL_MUL(R->m20, u2_s), u2_y_1 = KSL_MUL(R->m21, u2_s),
      u2_y_2 = KSL_MUL(R->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = KSL_MUL(u2_y_0, u2_y_0), u2_n_b = KSL_MUL(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_c_right = u2_n_c - u2_n_a, u2_n_d = KSL_MUL(u2_y_2, u2_y_2),
      u2_n_e = u2_n_c + u2_n_d, u2_n_e_right = u2_n_e - u2_n_c,
      u2_n_c_lo = ksl_product_rest(u2_y_0, u2_y_0, u2_n_a, u2_n_c - u2_n_c_right)
          + ksl_product_rest(u2_y_1, u2_y_1, u2_n_b, u2_n_c_right),
      u2_n_e_lo = u2_n_c - (u2_n_e - u2_n_e_right)
          + ksl_product_rest(u2_y_2, u2_y_2, u2_n_d, u2_n_e_right) + u2_n_c_lo,
      u2_n_e_sum = u2_n_e + u2_n_e_lo, u2_n_e_sum_right = u2_n_e_sum - u2_n_e,
      u2_n = sqrt(u2_n_e_sum), u2_n_product = KSL_MUL(u2_n, u2_n),
      u2_n_e_sum_lo = u2_n_e - (u2_n_e_sum - u2_n_e_sum_right) + (u2_n_e_lo - u2_n_e_sum_right),
      u2_n_twice = u2_n + u2_n,
      u2_n_lo = (u2_n_e_sum - u2_n_product - ksl_product_error(u2_n, u2_n, u2_n_product)
          + u2_n_e_sum_lo) / (u2_n == 0.0 ? 1.0 : u2_n_twice);
  const double u2_n_sum = u2_n + u2_n_lo, u2_n_sum_right = u2_n_sum - u2_n,
      u2_n_sum_lo = u2_n - (u2_n_sum - u2_n_sum_right) + (u2_n_lo - u2_n_sum_right),
      u2_divisor = u2_n_sum == 0.0 ? u2_up : u2_n_sum,
      u2_divisor_lo = u2_n_sum == 0.0 ? 0.0 : u2_n_sum_lo;
  const double u2_sized_0 = KSL_MUL(R->m20, u2_up), u2_sized_1 = KSL_MUL(R->m21, u2_up),
      u2_sized_2 = KSL_MUL(R->m22, u2_up);
  const double u2_divisor_sum = u2_divisor + u2_divisor_lo,
      u2_divisor_sum_right = u2_divisor_sum - u2_divisor,
      u2_divisor_sum_lo = u2_divisor - (u2_divisor_sum - u2_divisor_sum_right)
          + (u2_divisor_lo - u2_divisor_sum_right), u2_quotient_0 = u2_sized_0 / u2_divisor_sum,
      u2_quotient_0_product = KSL_MUL(u2_quotient_0, u2_divisor_sum),
      u2_quotient_0_exact = u2_sized_0 - u2_quotient_0_product
          - ksl_product_error(u2_quotient_0, u2_divisor_sum, u2_quotient_0_product),
      u2_quotient_0_lo = (u2_quotient_0_exact - KSL_MUL(u2_quotient_0, u2_divisor_sum_lo))
          / u2_divisor_sum;
  const double u2_quotient_1 = u2_sized_1 / u2_divisor_sum,
      u2_quotient_1_product = KSL_MUL(u2_quotient_1, u2_divisor_sum),
      u2_quotient_1_exact = u2_sized_1 - u2_quotient_1_product
          - ksl_product_error(u2_quotient_1, u2_divisor_sum, u2_quotient_1_product),
      u2_quotient_1_lo = (u2_quotient_1_exact - KSL_MUL(u2_quotient_1, u2_divisor_sum_lo))
          / u2_divisor_sum;
  const double u2_quotient_2 = u2_sized_2 / u2_divisor_sum,
      u2_quotient_2_product = KSL_MUL(u2_quotient_2, u2_divisor_sum),
      u2_quotient_2_exact = u2_sized_2 - u2_quotient_2_product
          - ksl_product_error(u2_quotient_2, u2_divisor_sum, u2_quotient_2_product),
      u2_quotient_2_lo = (u2_quotient_2_exact - KSL_MUL(u2_quotient_2, u2_divisor_sum_lo))
          / u2_divisor_sum;
  const double u2_quotient_0_sum = u2_quotient_0 + u2_quotient_0_lo,
      u2_quotient_0_sum_right = u2_quotient_0_sum - u2_quotient_0,
      u2_0 = KSL_MUL(u2_quotient_0_sum, u2_down), u2_0_inverse = 1.0 / u2_down,
      u2_quotient_0_sum_lo = u2_quotient_0 - (u2_quotient_0_sum - u2_quotient_0_sum_right)
          + (u2_quotient_0_lo - u2_quotient_0_sum_right);
  const double u2_quotient_1_sum = u2_quotient_1 + u2_quotient_1_lo,
      u2_quotient_1_sum_right = u2_quotient_1_sum - u2_quotient_1,
      u2_1 = KSL_MUL(u2_quotient_1_sum, u2_down),
      u2_quotient_1_sum_lo = u2_quotient_1 - (u2_quotient_1_sum - u2_quotient_1_sum_right)
          + (u2_quotient_1_lo - u2_quotient_1_sum_right);
  const double u2_quotient_2_sum = u2_quotient_2 + u2_quotient_2_lo,
      u2_quotient_2_sum_right = u2_quotient_2_sum - u2_quotient_2,
      u2_2 = KSL_MUL(u2_quotient_2_sum, u2_down),
      u2_quotient_2_sum_lo = u2_quotient_2 - (u2_quotient_2_sum - u2_quotient_2_sum_right)
          + (u2_quotient_2_lo - u2_quotient_2_sum_right);
  const double side_a = KSL_MUL(normal_0, u2_0),
      side_a_cross2 = KSL_MUL(normal_0, KSL_MUL(u2_quotient_0_sum - KSL_MUL(u2_0, u2_0_inverse)
          + u2_quotient_0_sum_lo, u2_down)), side_b = KSL_MUL(normal_1, u2_1),
      side_b_cross2 = KSL_MUL(normal_1, KSL_MUL(u2_quotient_1_sum - KSL_MUL(u2_1, u2_0_inverse)
          + u2_quotient_1_sum_lo, u2_down)), side_c = side_a + side_b,
      side_c_right = side_c - side_a,
      side_c_lo1 = ksl_product_rest(normal_0, u2_0, side_a, side_c - side_c_right)
          + ksl_product_rest(normal_1, u2_1, side_b, side_c_right),
      side_d = KSL_MUL(normal_2, u2_2),
      side_d_cross2 = KSL_MUL(normal_2, KSL_MUL(u2_quotient_2_sum - KSL_MUL(u2_2, u2_0_inverse)
          + u2_quotient_2_sum_lo, u2_down)), side = side_c + side_d, side_right = side - side_c,
      side_lo2 = side_c - (side - side_right)
          + ksl_product_rest(normal_2, u2_2, side_d, side_right)
          + (KSL_MUL(normal_2_lo, u2_2) + side_d_cross2),
      side_lo = side_lo2
          + (side_c_lo1
          + (KSL_MUL(normal_0_lo, u2_0) + side_a_cross2
          + (KSL_MUL(normal_1_lo, u2_1) + side_b_cross2)));
  const double q2_0a = -normal_0, q2_0a_lo = -normal_0_lo, side_sum = side + side_lo,
      side_sum_right = side_sum - side,
      side_sum_lo = side - (side_sum - side_sum_right) + (side_lo - side_sum_right),
      q2_0 = side_sum < 0.0 ? q2_0a : normal_0, q2_0_lo = side_sum < 0.0 ? q2_0a_lo : normal_0_lo;
  const double q2_1a = -normal_1, q2_1a_lo = -normal_1_lo, q2_1 = side_sum < 0.0 ? q2_1a : normal_1,
      q2_1_lo = side_sum < 0.0 ? q2_1a_lo : normal_1_lo;
  const double q2_2a = -normal_2, q2_2a_lo = -normal_2_lo, q2_2 = side_sum < 0.0 ? q2_2a : normal_2,
      q2_2_lo = side_sum < 0.0 ? q2_2a_lo : normal_2_lo;
  const double size = fabs(side_sum), size_opposite = -side_sum_lo,
      size_lo = side_sum < 0.0 ? size_opposite : side_sum_lo;
  const double size_sum = size + size_lo, size_sum_right = size_sum - size,
      size_sum_lo = size - (size_sum - size_sum_right) + (size_lo - size_sum_right),
      less = n_sum < size_sum ? n_sum : size_sum;
  const double dependent = less + (n_sum < size_sum ? n_sum_lo : size_sum_lo)
          < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double Ro_00 = dependent == 1.0 ? (double)NAN : q0_0,
      Ro_01 = dependent == 1.0 ? (double)NAN : q0_1, Ro_02 = dependent == 1.0 ? (double)NAN : q0_2,
      Ro_10 = dependent == 1.0 ? (double)NAN : q1_0, Ro_11 = dependent == 1.0 ? (double)NAN : q1_1,
      Ro_12 = dependent == 1.0 ? (double)NAN : q1_2, Ro_20 = dependent == 1.0 ? (double)NAN : q2_0,
      Ro_21 = dependent == 1.0 ? (double)NAN : q2_1, Ro_22 = dependent == 1.0 ? (double)NAN : q2_2;
  const double Ro_00_rounded = Ro_00 + (dependent == 1.0 ? 0.0 : q0_0_lo);
  const double Ro_01_rounded = Ro_01 + (dependent == 1.0 ? 0.0 : q0_1_lo);
  const double Ro_02_rounded = Ro_02 + (dependent == 1.0 ? 0.0 : q0_2_lo);
  const double Ro_10_rounded = Ro_10 + (dependent == 1.0 ? 0.0 : q1_0_lo);
  const double Ro_11_rounded = Ro_11 + (dependent == 1.0 ? 0.0 : q1_1_lo);
  const double Ro_12_rounded = Ro_12 + (dependent == 1.0 ? 0.0 : q1_2_lo);
  const double Ro_20_rounded = Ro_20 + (dependent == 1.0 ? 0.0 : q2_0_lo);
  const double Ro_21_rounded = Ro_21 + (dependent == 1.0 ? 0.0 : q2_1_lo);
  const double Ro_22_rounded = Ro_22 + (dependent == 1.0 ? 0.0 : q2_2_lo);
  const double Ro_00_final = Ro_00_rounded == Ro_00_rounded ? Ro_00_rounded : Ro_00;
  const double Ro_01_final = Ro_01_rounded == Ro_01_rounded ? Ro_01_rounded : Ro_01;
  const double Ro_02_final = Ro_02_rounded == Ro_02_rounded ? Ro_02_rounded : Ro_02;
  const double Ro_10_final = Ro_10_rounded == Ro_10_rounded ? Ro_10_rounded : Ro_10;
  const double Ro_11_final = Ro_11_rounded == Ro_11_rounded ? Ro_11_rounded : Ro_11;
  const double Ro_12_final = Ro_12_rounded == Ro_12_rounded ? Ro_12_rounded : Ro_12;
  const double Ro_20_final = Ro_20_rounded == Ro_20_rounded ? Ro_20_rounded : Ro_20;
  const double Ro_21_final = Ro_21_rounded == Ro_21_rounded ? Ro_21_rounded : Ro_21;
  const double Ro_22_final = Ro_22_rounded == Ro_22_rounded ? Ro_22_rounded : Ro_22;
  Ro->m00 = Ro_00_final;
  Ro->m01 = Ro_01_final;
  Ro->m02 = Ro_02_final;
  Ro->m10 = Ro_10_final;
  Ro->m11 = Ro_11_final;
  Ro->m12 = Ro_12_final;
  Ro->m20 = Ro_20_final;
  Ro->m21 = Ro_21_final;
  Ro->m22 = Ro_22_final;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   21 mul, 66 add, 3 product error, 15 product rest.
   Error <= u |result| + 14 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3_setFromAxisDC_accurate(ksl_mat3x3_t *R, const ksl_vec3_t *axis,
    const double dc[2]) {
  const double versine = 1.0 - dc[1], versine_right = 1.0 - versine,
      versine_lo = 1.0 - (versine + versine_right) - (dc[1] - versine_right);
  const double versine_axis_0 = KSL_MUL(axis->x, versine),
      versine_axis_1 = KSL_MUL(axis->y, versine), versine_axis_2 = KSL_MUL(axis->z, versine);
  const double versine_axis_0_lo = ksl_product_error(axis->x, versine, versine_axis_0)
          + KSL_MUL(axis->x, versine_lo), m_0 = KSL_MUL(axis->x, versine_axis_0);
  const double versine_axis_1_lo = ksl_product_error(axis->y, versine, versine_axis_1)
          + KSL_MUL(axis->y, versine_lo), m_1 = KSL_MUL(axis->y, versine_axis_1);
  const double m_2 = KSL_MUL(axis->z, versine_axis_2);
  const double m_3 = KSL_MUL(axis->y, versine_axis_0),
      m_3_cross2 = KSL_MUL(axis->y, versine_axis_0_lo);
  const double m_4 = KSL_MUL(axis->z, versine_axis_0),
      m_4_cross2 = KSL_MUL(axis->z, versine_axis_0_lo);
  const double m_5 = KSL_MUL(axis->z, versine_axis_1),
      m_5_cross2 = KSL_MUL(axis->z, versine_axis_1_lo);
  const double sine_axis_0 = KSL_MUL(axis->x, dc[0]), sine_axis_1 = KSL_MUL(axis->y, dc[0]),
      sine_axis_2 = KSL_MUL(axis->z, dc[0]);
  const double R_00 = dc[1] + m_0, R_00_right = R_00 - dc[1];
  const double R_01 = m_3 - sine_axis_2, R_01_right = m_3 - R_01;
  const double R_02 = m_4 + sine_axis_1, R_02_right = R_02 - m_4;
  const double R_10 = m_3 + sine_axis_2, R_10_right = R_10 - m_3;
  const double R_11 = dc[1] + m_1, R_11_right = R_11 - dc[1];
  const double R_12 = m_5 - sine_axis_0, R_12_right = m_5 - R_12;
  const double R_20 = m_4 - sine_axis_1, R_20_right = m_4 - R_20;
  const double R_21 = m_5 + sine_axis_0, R_21_right = R_21 - m_5;
  const double R_22 = dc[1] + m_2, R_22_right = R_22 - dc[1];
  const double m_2_cross2 = KSL_MUL(axis->z, ksl_product_error(axis->z, versine, versine_axis_2)
          + KSL_MUL(axis->z, versine_lo));
  const double R_00_rounded = R_00
          + (dc[1] - (R_00 - R_00_right)
          + ksl_product_rest(axis->x, versine_axis_0, m_0, R_00_right)
          + KSL_MUL(axis->x, versine_axis_0_lo));
  const double R_01_lo = ksl_product_rest(axis->y, versine_axis_0, m_3, R_01 + R_01_right)
          - ksl_product_rest(axis->z, dc[0], sine_axis_2, R_01_right) + m_3_cross2;
  const double R_01_rounded = R_01 + R_01_lo;
  const double R_02_lo = ksl_product_rest(axis->z, versine_axis_0, m_4, R_02 - R_02_right)
          + ksl_product_rest(axis->y, dc[0], sine_axis_1, R_02_right) + m_4_cross2;
  const double R_02_rounded = R_02 + R_02_lo;
  const double R_10_lo = ksl_product_rest(axis->y, versine_axis_0, m_3, R_10 - R_10_right)
          + ksl_product_rest(axis->z, dc[0], sine_axis_2, R_10_right) + m_3_cross2;
  const double R_10_rounded = R_10 + R_10_lo,
      R_11_rounded = R_11
          + (dc[1] - (R_11 - R_11_right)
          + ksl_product_rest(axis->y, versine_axis_1, m_1, R_11_right)
          + KSL_MUL(axis->y, versine_axis_1_lo));
  const double R_12_lo = ksl_product_rest(axis->z, versine_axis_1, m_5, R_12 + R_12_right)
          - ksl_product_rest(axis->x, dc[0], sine_axis_0, R_12_right) + m_5_cross2;
  const double R_12_rounded = R_12 + R_12_lo;
  const double R_20_lo = ksl_product_rest(axis->z, versine_axis_0, m_4, R_20 + R_20_right)
          - ksl_product_rest(axis->y, dc[0], sine_axis_1, R_20_right) + m_4_cross2;
  const double R_20_rounded = R_20 + R_20_lo;
  const double R_21_lo = ksl_product_rest(axis->z, versine_axis_1, m_5, R_21 - R_21_right)
          + ksl_product_rest(axis->x, dc[0], sine_axis_0, R_21_right) + m_5_cross2;
  const double R_21_rounded = R_21 + R_21_lo,
      R_22_rounded = R_22
          + (dc[1] - (R_22 - R_22_right)
          + ksl_product_rest(axis->z, versine_axis_2, m_2, R_22_right) + m_2_cross2);
  R->m00 = R_00_rounded;
  R->m01 = R_01_rounded;
  R->m02 = R_02_rounded;
  R->m10 = R_10_rounded;
  R->m11 = R_11_rounded;
  R->m12 = R_12_rounded;
  R->m20 = R_20_rounded;
  R->m21 = R_21_rounded;
  R->m22 = R_22_rounded;
}

/* R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   291 mul, 434 add, 39 product error, 8 product rest, 3 div, 9 neg, 9 abs, 3 less, 9 equal, 12
     select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_mat3x3_from_euler_xyz_accurate(const ksl_vec3_t *angles, ksl_mat3x3_t *R) {
  double c_0; const double s_0 = ksl_sincos(angles->x, &c_0);
  double c_0_own_error; const double s_0_own_error = ksl_sincos_error(angles->x, s_0, c_0,
      &c_0_own_error);
  double c_1; const double s_1 = ksl_sincos(angles->y, &c_1);
  double c_1_own_error; const double s_1_own_error = ksl_sincos_error(angles->y, s_1, c_1,
      &c_1_own_error);
  double c_2; const double s_2 = ksl_sincos(angles->z, &c_2);
  double c_2_own_error; const double s_2_own_error = ksl_sincos_error(angles->z, s_2, c_2,
      &c_2_own_error);
  const double first_0 = KSL_MUL(c_1, c_2), first_1 = -KSL_MUL(s_2, c_1),
      first_6 = -KSL_MUL(s_1, c_2), first_7 = KSL_MUL(s_1, s_2);
  const double last_3a = KSL_MUL(s_2, c_0),
      first_6_lo = ksl_product_error(-s_1, c_2, first_6) +
          -(KSL_MUL(s_1_own_error, c_2) + KSL_MUL(s_1, c_2_own_error)),
      last_3b = KSL_MUL(s_0, first_6), last_3 = last_3a - last_3b, last_3_right = last_3a - last_3,
      last_3_cross = KSL_MUL(s_2_own_error, c_0) + KSL_MUL(s_2, c_0_own_error)
          - (KSL_MUL(s_0_own_error, first_6) + KSL_MUL(s_0, first_6_lo));
  const double last_4a = KSL_MUL(c_0, c_2),
      first_7_lo = ksl_product_error(s_1, s_2, first_7)
          + (KSL_MUL(s_1_own_error, s_2) + KSL_MUL(s_1, s_2_own_error)),
      last_4b = KSL_MUL(s_0, first_7), last_4 = last_4a - last_4b, last_4_right = last_4a - last_4,
      last_4_cross = KSL_MUL(c_0_own_error, c_2) + KSL_MUL(c_0, c_2_own_error)
          - (KSL_MUL(s_0_own_error, first_7) + KSL_MUL(s_0, first_7_lo));
  const double last_5 = -KSL_MUL(s_0, c_1);
  const double last_6a = KSL_MUL(s_0, s_2), last_6b = KSL_MUL(c_0, first_6),
      last_6 = last_6a + last_6b, last_6_right = last_6 - last_6a,
      last_6_cross = KSL_MUL(s_0_own_error, s_2) + KSL_MUL(s_0, s_2_own_error)
          + (KSL_MUL(c_0_own_error, first_6) + KSL_MUL(c_0, first_6_lo));
  const double last_7a = KSL_MUL(s_0, c_2), last_7b = KSL_MUL(c_0, first_7),
      last_7 = last_7a + last_7b, last_7_right = last_7 - last_7a,
      last_7_cross = KSL_MUL(s_0_own_error, c_2) + KSL_MUL(s_0, c_2_own_error)
          + (KSL_MUL(c_0_own_error, first_7) + KSL_MUL(c_0, first_7_lo));
  const double last_8 = KSL_MUL(c_0, c_1);
  const double first_0_rounded = first_0
          + (ksl_product_error(c_1, c_2, first_0)
          + (KSL_MUL(c_1_own_error, c_2) + KSL_MUL(c_1, c_2_own_error)));
  const double first_1_rounded = first_1
          + (ksl_product_error(-s_2, c_1, first_1) +
          -(KSL_MUL(s_2_own_error, c_1) + KSL_MUL(s_2, c_1_own_error)));
  const double s_1_rounded = s_1 + s_1_own_error;
  const double last_3_lo = ksl_product_rest(s_2, c_0, last_3a, last_3 + last_3_right)
          - ksl_product_rest(s_0, first_6, last_3b, last_3_right) + last_3_cross;
  const double last_3_rounded = last_3 + last_3_lo;
  const double last_4_lo = ksl_product_rest(c_0, c_2, last_4a, last_4 + last_4_right)
          - ksl_product_rest(s_0, first_7, last_4b, last_4_right) + last_4_cross;
  const double last_4_rounded = last_4 + last_4_lo;
  const double last_5_rounded = last_5
          + (ksl_product_error(-s_0, c_1, last_5) +
          -(KSL_MUL(s_0_own_error, c_1) + KSL_MUL(s_0, c_1_own_error)));
  const double last_6_lo = ksl_product_rest(s_0, s_2, last_6a, last_6 - last_6_right)
          + ksl_product_rest(c_0, first_6, last_6b, last_6_right) + last_6_cross;
  const double last_6_rounded = last_6 + last_6_lo;
  const double last_7_lo = ksl_product_rest(s_0, c_2, last_7a, last_7 - last_7_right)
          + ksl_product_rest(c_0, first_7, last_7b, last_7_right) + last_7_cross;
  const double last_7_rounded = last_7 + last_7_lo;
  const double last_8_rounded = last_8
          + (ksl_product_error(c_0, c_1, last_8)
          + (KSL_MUL(c_0_own_error, c_1) + KSL_MUL(c_0, c_1_own_error)));
  const double first_0_final = first_0_rounded == first_0_rounded ? first_0_rounded : first_0;
  const double first_1_final = first_1_rounded == first_1_rounded ? first_1_rounded : first_1;
  const double s_1_final = s_1_rounded == s_1_rounded ? s_1_rounded : s_1;
  const double last_3_final = last_3_rounded == last_3_rounded ? last_3_rounded : last_3;
  const double last_4_final = last_4_rounded == last_4_rounded ? last_4_rounded : last_4;
  const double last_5_final = last_5_rounded == last_5_rounded ? last_5_rounded : last_5;
  const double last_6_final = last_6_rounded == last_6_rounded ? last_6_rounded : last_6;
  const double last_7_final = last_7_rounded == last_7_rounded ? last_7_rounded : last_7;
  const double last_8_final = last_8_rounded == last_8_rounded ? last_8_rounded : last_8;
  R->m00 = first_0_final;
  R->m01 = first_1_final;
  R->m02 = s_1_final;
  R->m10 = last_3_final;
  R->m11 = last_4_final;
  R->m12 = last_5_final;
  R->m20 = last_6_final;
  R->m21 = last_7_final;
  R->m22 = last_8_final;
}

/* angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
     [-π/2, π/2]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   391 mul, 713 add, 66 product error, 6 product rest, 17 div, 1 sqrt, 4 neg, 28 abs, 12
     copysign, 42 less, 16 equal, 87 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_euler_xyz_from_mat3x3_accurate(const ksl_mat3x3_t *R, ksl_vec3_t *angles) {
  const double n_a = KSL_MUL(R->m00, R->m00), n_b = KSL_MUL(R->m01, R->m01), n_c = n_a + n_b,
      n_c_right = n_c - n_a,
      n_c_lo = ksl_product_rest(R->m00, R->m00, n_a, n_c - n_c_right)
          + ksl_product_rest(R->m01, R->m01, n_b, n_c_right), n_c_sum = n_c + n_c_lo,
      n_c_sum_right = n_c_sum - n_c, n = sqrt(n_c_sum), n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_c_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_c - (n_c_sum - n_c_sum_right) + (n_c_lo - n_c_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      divisor = n_sum == 0.0 ? 1.0 : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), cosine_a = R->m00 / divisor_sum,
      cosine_a_product = KSL_MUL(cosine_a, divisor_sum),
      cosine_a_residual = R->m00 - cosine_a_product
          - ksl_product_error(cosine_a, divisor_sum, cosine_a_product)
          - KSL_MUL(cosine_a, divisor_sum_lo), cosine_a_lo = cosine_a_residual / divisor_sum,
      cosine = n_sum == 0.0 ? 1.0 : cosine_a, cosine_lo = n_sum == 0.0 ? 0.0 : cosine_a_lo;
  const double sine_a = -R->m01, sine = sine_a / divisor_sum,
      sine_product = KSL_MUL(sine, divisor_sum),
      sine_lo = (sine_a - sine_product - ksl_product_error(sine, divisor_sum, sine_product)
          - KSL_MUL(sine, divisor_sum_lo)) / divisor_sum;
  const double polar = ksl_atan2(sine_a, R->m00),
      polar_own_error = ksl_atan2_error(sine_a, R->m00, polar);
  const double third = n_sum == 0.0 ? 0.0 : polar;
  const double left_1a = KSL_MUL(R->m10, sine), left_1b = KSL_MUL(R->m11, cosine),
      left_1 = left_1a + left_1b, left_1_right = left_1 - left_1a,
      left_1_lo1 = ksl_product_rest(R->m10, sine, left_1a, left_1 - left_1_right)
          + ksl_product_rest(R->m11, cosine, left_1b, left_1_right),
      left_1_lo = left_1_lo1 + (KSL_MUL(R->m10, sine_lo) + KSL_MUL(R->m11, cosine_lo));
  const double left_2a = KSL_MUL(R->m20, sine), left_2b = KSL_MUL(R->m21, cosine),
      left_2 = left_2a + left_2b, left_2_right = left_2 - left_2a,
      left_2_lo1 = ksl_product_rest(R->m20, sine, left_2a, left_2 - left_2_right)
          + ksl_product_rest(R->m21, cosine, left_2b, left_2_right),
      left_2_lo = left_2_lo1 + (KSL_MUL(R->m20, sine_lo) + KSL_MUL(R->m21, cosine_lo));
  const double rest = R->m12 + R->m22, rest_right = rest - R->m12,
      rest_lo = R->m12 - (rest - rest_right) + (R->m22 - rest_right);
  const double left_2_sum = left_2 + left_2_lo, left_2_sum_right = left_2_sum - left_2,
      left_1_sum = left_1 + left_1_lo, left_1_sum_right = left_1_sum - left_1,
      first = ksl_atan2(left_2_sum, left_1_sum), first_size0 = fabs(left_2_sum),
      first_size1 = fabs(left_1_sum),
      first_most = first_size0 < first_size1 ? first_size1 : first_size0,
      first_divisor = first_most == 0.0 ? 1.0 : first_most,
      first_part0 = left_2_sum / first_divisor, first_part1 = left_1_sum / first_divisor,
      first_cross1 = KSL_MUL(first_part1, left_2 - (left_2_sum - left_2_sum_right)
          + (left_2_lo - left_2_sum_right)),
      first_divisor2 = KSL_MUL(first_divisor, KSL_MUL(first_part1, first_part1)
          + KSL_MUL(first_part0, first_part0)),
      first_cross = first_cross1
          - KSL_MUL(first_part0, left_1 - (left_1_sum - left_1_sum_right)
          + (left_1_lo - left_1_sum_right)),
      first_lo = ksl_atan2_error(left_2_sum, left_1_sum, first) + first_cross
          / (first_most == 0.0 ? 1.0 : first_divisor2);
  const double rest_sum = rest + rest_lo, rest_sum_right = rest_sum - rest,
      rest_sum_lo = rest - (rest_sum - rest_sum_right) + (rest_lo - rest_sum_right),
      angles_0 = rest_sum < 1.2676506002282294e+30 ? first : rest_sum;
  const double angles_1 = ksl_atan2(R->m02, n_sum), angles_1_size0 = fabs(R->m02),
      angles_1_size1 = fabs(n_sum),
      angles_1_most = angles_1_size0 < angles_1_size1 ? angles_1_size1 : angles_1_size0,
      angles_1_divisor = angles_1_most == 0.0 ? 1.0 : angles_1_most,
      angles_1_part0 = R->m02 / angles_1_divisor, angles_1_part1 = n_sum / angles_1_divisor,
      angles_1_divisor2 = KSL_MUL(angles_1_divisor, KSL_MUL(angles_1_part1, angles_1_part1)
          + KSL_MUL(angles_1_part0, angles_1_part0)),
      angles_1_more = (KSL_MUL(angles_1_part1, 0.0) - KSL_MUL(angles_1_part0, n_sum_lo))
          / (angles_1_most == 0.0 ? 1.0 : angles_1_divisor2);
  const double angles_0_rounded = angles_0
          + (rest_sum < 1.2676506002282294e+30 ? first_lo : rest_sum_lo);
  const double angles_1_rounded = angles_1
          + (ksl_atan2_error(R->m02, n_sum, angles_1) + angles_1_more);
  const double third_rounded = third + (n_sum == 0.0 ? 0.0 : polar_own_error);
  const double angles_0_final = angles_0_rounded == angles_0_rounded ? angles_0_rounded : angles_0;
  const double angles_1_final = angles_1_rounded == angles_1_rounded ? angles_1_rounded : angles_1;
  const double third_final = third_rounded == third_rounded ? third_rounded : third;
  angles->x = angles_0_final;
  angles->y = angles_1_final;
  angles->z = third_final;
}

/* R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   291 mul, 434 add, 39 product error, 8 product rest, 3 div, 5 neg, 9 abs, 3 less, 9 equal, 12
     select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_mat3x3_from_euler_xyx_accurate(const ksl_vec3_t *angles, ksl_mat3x3_t *R) {
  double c_0; const double s_0 = ksl_sincos(angles->x, &c_0);
  double c_0_own_error; const double s_0_own_error = ksl_sincos_error(angles->x, s_0, c_0,
      &c_0_own_error);
  double c_1; const double s_1 = ksl_sincos(angles->y, &c_1);
  double c_1_own_error; const double s_1_own_error = ksl_sincos_error(angles->y, s_1, c_1,
      &c_1_own_error);
  double c_2; const double s_2 = ksl_sincos(angles->z, &c_2);
  double c_2_own_error; const double s_2_own_error = ksl_sincos_error(angles->z, s_2, c_2,
      &c_2_own_error);
  const double first_1 = KSL_MUL(s_1, s_2), first_2 = KSL_MUL(s_1, c_2),
      first_7 = KSL_MUL(s_2, c_1), first_8 = KSL_MUL(c_1, c_2);
  const double last_3 = KSL_MUL(s_0, s_1);
  const double last_4a = KSL_MUL(c_0, c_2),
      first_7_lo = ksl_product_error(s_2, c_1, first_7)
          + (KSL_MUL(s_2_own_error, c_1) + KSL_MUL(s_2, c_1_own_error)),
      last_4b = KSL_MUL(s_0, first_7), last_4 = last_4a - last_4b, last_4_right = last_4a - last_4,
      last_4_cross = KSL_MUL(c_0_own_error, c_2) + KSL_MUL(c_0, c_2_own_error)
          - (KSL_MUL(s_0_own_error, first_7) + KSL_MUL(s_0, first_7_lo));
  const double first_8_lo = ksl_product_error(c_1, c_2, first_8)
          + (KSL_MUL(c_1_own_error, c_2) + KSL_MUL(c_1, c_2_own_error)),
      last_5a = KSL_MUL(s_0, first_8), last_5b = KSL_MUL(s_2, c_0), last_5c = last_5a + last_5b,
      last_5c_right = last_5c - last_5a,
      last_5c_cross = KSL_MUL(s_0_own_error, first_8) + KSL_MUL(s_0, first_8_lo)
          + (KSL_MUL(s_2_own_error, c_0) + KSL_MUL(s_2, c_0_own_error)), last_5 = -last_5c;
  const double last_6 = -KSL_MUL(s_1, c_0);
  const double last_7a = KSL_MUL(s_0, c_2), last_7b = KSL_MUL(c_0, first_7),
      last_7 = last_7a + last_7b, last_7_right = last_7 - last_7a,
      last_7_cross = KSL_MUL(s_0_own_error, c_2) + KSL_MUL(s_0, c_2_own_error)
          + (KSL_MUL(c_0_own_error, first_7) + KSL_MUL(c_0, first_7_lo));
  const double last_8a = KSL_MUL(c_0, first_8), last_8b = KSL_MUL(s_0, s_2),
      last_8 = last_8a - last_8b, last_8_right = last_8a - last_8,
      last_8_cross = KSL_MUL(c_0_own_error, first_8) + KSL_MUL(c_0, first_8_lo)
          - (KSL_MUL(s_0_own_error, s_2) + KSL_MUL(s_0, s_2_own_error));
  const double c_1_rounded = c_1 + c_1_own_error;
  const double first_1_rounded = first_1
          + (ksl_product_error(s_1, s_2, first_1)
          + (KSL_MUL(s_1_own_error, s_2) + KSL_MUL(s_1, s_2_own_error)));
  const double first_2_rounded = first_2
          + (ksl_product_error(s_1, c_2, first_2)
          + (KSL_MUL(s_1_own_error, c_2) + KSL_MUL(s_1, c_2_own_error)));
  const double last_3_rounded = last_3
          + (ksl_product_error(s_0, s_1, last_3)
          + (KSL_MUL(s_0_own_error, s_1) + KSL_MUL(s_0, s_1_own_error)));
  const double last_4_lo = ksl_product_rest(c_0, c_2, last_4a, last_4 + last_4_right)
          - ksl_product_rest(s_0, first_7, last_4b, last_4_right) + last_4_cross;
  const double last_4_rounded = last_4 + last_4_lo;
  const double last_5_lo =
          -(ksl_product_rest(s_0, first_8, last_5a, last_5c - last_5c_right)
          + ksl_product_rest(s_2, c_0, last_5b, last_5c_right) + last_5c_cross);
  const double last_5_rounded = last_5 + last_5_lo;
  const double last_6_rounded = last_6
          + (ksl_product_error(-s_1, c_0, last_6) +
          -(KSL_MUL(s_1_own_error, c_0) + KSL_MUL(s_1, c_0_own_error)));
  const double last_7_lo = ksl_product_rest(s_0, c_2, last_7a, last_7 - last_7_right)
          + ksl_product_rest(c_0, first_7, last_7b, last_7_right) + last_7_cross;
  const double last_7_rounded = last_7 + last_7_lo;
  const double last_8_lo = ksl_product_rest(c_0, first_8, last_8a, last_8 + last_8_right)
          - ksl_product_rest(s_0, s_2, last_8b, last_8_right) + last_8_cross;
  const double last_8_rounded = last_8 + last_8_lo;
  const double c_1_final = c_1_rounded == c_1_rounded ? c_1_rounded : c_1;
  const double first_1_final = first_1_rounded == first_1_rounded ? first_1_rounded : first_1;
  const double first_2_final = first_2_rounded == first_2_rounded ? first_2_rounded : first_2;
  const double last_3_final = last_3_rounded == last_3_rounded ? last_3_rounded : last_3;
  const double last_4_final = last_4_rounded == last_4_rounded ? last_4_rounded : last_4;
  const double last_5_final = last_5_rounded == last_5_rounded ? last_5_rounded : last_5;
  const double last_6_final = last_6_rounded == last_6_rounded ? last_6_rounded : last_6;
  const double last_7_final = last_7_rounded == last_7_rounded ? last_7_rounded : last_7;
  const double last_8_final = last_8_rounded == last_8_rounded ? last_8_rounded : last_8;
  R->m00 = c_1_final;
  R->m01 = first_1_final;
  R->m02 = first_2_final;
  R->m10 = last_3_final;
  R->m11 = last_4_final;
  R->m12 = last_5_final;
  R->m20 = last_6_final;
  R->m21 = last_7_final;
  R->m22 = last_8_final;
}

/* angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in [0,
     π]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   391 mul, 713 add, 66 product error, 6 product rest, 17 div, 1 sqrt, 3 neg, 28 abs, 12
     copysign, 42 less, 16 equal, 87 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_euler_xyx_from_mat3x3_accurate(const ksl_mat3x3_t *R, ksl_vec3_t *angles) {
  const double n_a = KSL_MUL(R->m01, R->m01), n_b = KSL_MUL(R->m02, R->m02), n_c = n_a + n_b,
      n_c_right = n_c - n_a,
      n_c_lo = ksl_product_rest(R->m01, R->m01, n_a, n_c - n_c_right)
          + ksl_product_rest(R->m02, R->m02, n_b, n_c_right), n_c_sum = n_c + n_c_lo,
      n_c_sum_right = n_c_sum - n_c, n = sqrt(n_c_sum), n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_c_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_c - (n_c_sum - n_c_sum_right) + (n_c_lo - n_c_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      divisor = n_sum == 0.0 ? 1.0 : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), cosine_a = R->m02 / divisor_sum,
      cosine_a_product = KSL_MUL(cosine_a, divisor_sum),
      cosine_a_residual = R->m02 - cosine_a_product
          - ksl_product_error(cosine_a, divisor_sum, cosine_a_product)
          - KSL_MUL(cosine_a, divisor_sum_lo), cosine_a_lo = cosine_a_residual / divisor_sum,
      cosine = n_sum == 0.0 ? 1.0 : cosine_a, cosine_lo = n_sum == 0.0 ? 0.0 : cosine_a_lo;
  const double sine = R->m01 / divisor_sum, sine_product = KSL_MUL(sine, divisor_sum),
      sine_lo = (R->m01 - sine_product - ksl_product_error(sine, divisor_sum, sine_product)
          - KSL_MUL(sine, divisor_sum_lo)) / divisor_sum;
  const double polar = ksl_atan2(R->m01, R->m02),
      polar_own_error = ksl_atan2_error(R->m01, R->m02, polar);
  const double third = n_sum == 0.0 ? 0.0 : polar;
  const double left_1a = KSL_MUL(R->m11, cosine), left_1b = KSL_MUL(R->m12, sine),
      left_1 = left_1a - left_1b, left_1_right = left_1a - left_1,
      left_1_lo1 = ksl_product_rest(R->m11, cosine, left_1a, left_1 + left_1_right)
          - ksl_product_rest(R->m12, sine, left_1b, left_1_right),
      left_1_lo = left_1_lo1 + (KSL_MUL(R->m11, cosine_lo) - KSL_MUL(R->m12, sine_lo));
  const double left_2a = KSL_MUL(R->m21, cosine), left_2b = KSL_MUL(R->m22, sine),
      left_2 = left_2a - left_2b, left_2_right = left_2a - left_2,
      left_2_lo1 = ksl_product_rest(R->m21, cosine, left_2a, left_2 + left_2_right)
          - ksl_product_rest(R->m22, sine, left_2b, left_2_right),
      left_2_lo = left_2_lo1 + (KSL_MUL(R->m21, cosine_lo) - KSL_MUL(R->m22, sine_lo));
  const double rest = R->m10 + R->m20, rest_right = rest - R->m10,
      rest_lo = R->m10 - (rest - rest_right) + (R->m20 - rest_right);
  const double left_2_sum = left_2 + left_2_lo, left_2_sum_right = left_2_sum - left_2,
      left_1_sum = left_1 + left_1_lo, left_1_sum_right = left_1_sum - left_1,
      first = ksl_atan2(left_2_sum, left_1_sum), first_size0 = fabs(left_2_sum),
      first_size1 = fabs(left_1_sum),
      first_most = first_size0 < first_size1 ? first_size1 : first_size0,
      first_divisor = first_most == 0.0 ? 1.0 : first_most,
      first_part0 = left_2_sum / first_divisor, first_part1 = left_1_sum / first_divisor,
      first_cross1 = KSL_MUL(first_part1, left_2 - (left_2_sum - left_2_sum_right)
          + (left_2_lo - left_2_sum_right)),
      first_divisor2 = KSL_MUL(first_divisor, KSL_MUL(first_part1, first_part1)
          + KSL_MUL(first_part0, first_part0)),
      first_cross = first_cross1
          - KSL_MUL(first_part0, left_1 - (left_1_sum - left_1_sum_right)
          + (left_1_lo - left_1_sum_right)),
      first_lo = ksl_atan2_error(left_2_sum, left_1_sum, first) + first_cross
          / (first_most == 0.0 ? 1.0 : first_divisor2);
  const double rest_sum = rest + rest_lo, rest_sum_right = rest_sum - rest,
      rest_sum_lo = rest - (rest_sum - rest_sum_right) + (rest_lo - rest_sum_right),
      angles_0 = rest_sum < 1.2676506002282294e+30 ? first : rest_sum;
  const double angles_1 = ksl_atan2(n_sum, R->m00), angles_1_size0 = fabs(n_sum),
      angles_1_size1 = fabs(R->m00),
      angles_1_most = angles_1_size0 < angles_1_size1 ? angles_1_size1 : angles_1_size0,
      angles_1_divisor = angles_1_most == 0.0 ? 1.0 : angles_1_most,
      angles_1_part0 = n_sum / angles_1_divisor, angles_1_part1 = R->m00 / angles_1_divisor,
      angles_1_divisor2 = KSL_MUL(angles_1_divisor, KSL_MUL(angles_1_part1, angles_1_part1)
          + KSL_MUL(angles_1_part0, angles_1_part0)),
      angles_1_more = (KSL_MUL(angles_1_part1, n_sum_lo) - KSL_MUL(angles_1_part0, 0.0))
          / (angles_1_most == 0.0 ? 1.0 : angles_1_divisor2);
  const double angles_0_rounded = angles_0
          + (rest_sum < 1.2676506002282294e+30 ? first_lo : rest_sum_lo);
  const double angles_1_rounded = angles_1
          + (ksl_atan2_error(n_sum, R->m00, angles_1) + angles_1_more);
  const double third_rounded = third + (n_sum == 0.0 ? 0.0 : polar_own_error);
  const double angles_0_final = angles_0_rounded == angles_0_rounded ? angles_0_rounded : angles_0;
  const double angles_1_final = angles_1_rounded == angles_1_rounded ? angles_1_rounded : angles_1;
  const double third_final = third_rounded == third_rounded ? third_rounded : third;
  angles->x = angles_0_final;
  angles->y = angles_1_final;
  angles->z = third_final;
}

/* A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes
     A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.
     Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.
   A, V: rotation or other 3×3 matrix.
   51 mul, 153 add, 6 product error, 20 product rest, 8 div, 2 sqrt, 3 neg, 1 abs, 2 less, 13
     equal, 18 select.
   V A V^T changes by at most 28 u max |A| for orthonormal V; searched, not proved. */
static inline void ksl_mat3x3_jacobi_accurate(ksl_mat3x3_t *A, ksl_mat3x3_t *V) {
  const double twice = KSL_MUL(2.0, A->m10);
  const double apart = A->m11 - A->m00, apart_right = A->m11 - apart,
      apart_lo = A->m11 - (apart + apart_right) - (A->m00 - apart_right);
  const double divisor = twice == 0.0 ? 1.0 : twice;
  const double apart_sum = apart + apart_lo, apart_sum_right = apart_sum - apart,
      theta = apart_sum / divisor, theta_product = KSL_MUL(theta, divisor),
      theta_exact = apart_sum - theta_product - ksl_product_error(theta, divisor, theta_product),
      theta_lo = (theta_exact
          + (apart - (apart_sum - apart_sum_right) + (apart_lo - apart_sum_right))) / divisor;
  const double theta_sum = theta + theta_lo, theta_sum_right = theta_sum - theta,
      theta_sum_lo = theta - (theta_sum - theta_sum_right) + (theta_lo - theta_sum_right),
      magnitude = fabs(theta_sum), magnitude_opposite = -theta_sum_lo;
  const double size_a = KSL_MUL(theta_sum, theta_sum), size_b = 1.0 + size_a,
      size_b_right = size_b - 1.0,
      size_b_lo1 = 1.0 - (size_b - size_b_right)
          + ksl_product_rest(theta_sum, theta_sum, size_a, size_b_right),
      size_b_lo = size_b_lo1
          + (KSL_MUL(theta_sum_lo, theta_sum) + KSL_MUL(theta_sum, theta_sum_lo)),
      size_b_sum = size_b + size_b_lo, size_b_sum_right = size_b_sum - size_b,
      size_c = sqrt(size_b_sum), size_c_product = KSL_MUL(size_c, size_c),
      size_c_exact = size_b_sum - size_c_product
          - ksl_product_error(size_c, size_c, size_c_product), size_c_twice = size_c + size_c,
      size = magnitude + size_c, size_right = size - magnitude,
      size_c_lo = (size_c_exact
          + (size_b - (size_b_sum - size_b_sum_right) + (size_b_lo - size_b_sum_right)))
          / (size_c == 0.0 ? 1.0 : size_c_twice),
      size_lo = magnitude - (size - size_right) + (size_c - size_right) + size_c_lo
          + (theta_sum < 0.0 ? magnitude_opposite : theta_sum_lo);
  const double along_a = -size, along_a_lo = -size_lo, along = theta_sum < 0.0 ? along_a : size,
      along_lo = theta_sum < 0.0 ? along_a_lo : size_lo;
  const double along_sum = along + along_lo, along_sum_right = along_sum - along,
      t_a = 1.0 / along_sum, t_a_product = KSL_MUL(t_a, along_sum),
      t_a_cross = KSL_MUL(t_a, along - (along_sum - along_sum_right)
          + (along_lo - along_sum_right)),
      t_a_lo = (1.0 - t_a_product - ksl_product_error(t_a, along_sum, t_a_product) - t_a_cross)
          / along_sum, t = twice == 0.0 ? 0.0 : t_a, t_lo = twice == 0.0 ? 0.0 : t_a_lo;
  const double secant_a = KSL_MUL(t, t), secant_b = 1.0 + secant_a, secant_b_right = secant_b - 1.0,
      secant_b_lo = 1.0 - (secant_b - secant_b_right)
          + ksl_product_rest(t, t, secant_a, secant_b_right)
          + (KSL_MUL(t_lo, t) + KSL_MUL(t, t_lo)), secant_b_sum = secant_b + secant_b_lo,
      secant_b_sum_right = secant_b_sum - secant_b, secant = sqrt(secant_b_sum),
      secant_product = KSL_MUL(secant, secant),
      secant_b_sum_lo = secant_b - (secant_b_sum - secant_b_sum_right)
          + (secant_b_lo - secant_b_sum_right), secant_twice = secant + secant,
      secant_residual = secant_b_sum - secant_product
          - ksl_product_error(secant, secant, secant_product) + secant_b_sum_lo,
      secant_lo = secant_residual / (secant == 0.0 ? 1.0 : secant_twice);
  const double secant_sum = secant + secant_lo, secant_sum_right = secant_sum - secant,
      c = 1.0 / secant_sum, c_product = KSL_MUL(c, secant_sum),
      c_cross = KSL_MUL(c, secant - (secant_sum - secant_sum_right)
          + (secant_lo - secant_sum_right)),
      c_lo = (1.0 - c_product - ksl_product_error(c, secant_sum, c_product) - c_cross) / secant_sum;
  const double s = KSL_MUL(t, c);
  const double change = KSL_MUL(A->m10, t), change_cross2 = KSL_MUL(A->m10, t_lo);
  const double zp_a = KSL_MUL(A->m20, c),
      s_lo = ksl_product_error(t, c, s) + (KSL_MUL(t_lo, c) + KSL_MUL(t, c_lo)),
      zp_b = KSL_MUL(A->m21, s), zp = zp_a - zp_b, zp_right = zp_a - zp,
      zp_lo1 = ksl_product_rest(A->m20, c, zp_a, zp + zp_right)
          - ksl_product_rest(A->m21, s, zp_b, zp_right);
  const double zq_a = KSL_MUL(A->m20, s), zq_b = KSL_MUL(A->m21, c), zq = zq_a + zq_b,
      zq_right = zq - zq_a,
      zq_lo1 = ksl_product_rest(A->m20, s, zq_a, zq - zq_right)
          + ksl_product_rest(A->m21, c, zq_b, zq_right);
  const double vp_0a = KSL_MUL(V->m00, c), vp_0b = KSL_MUL(V->m01, s), vp_0 = vp_0a - vp_0b,
      vp_0_right = vp_0a - vp_0,
      vp_0_lo1 = ksl_product_rest(V->m00, c, vp_0a, vp_0 + vp_0_right)
          - ksl_product_rest(V->m01, s, vp_0b, vp_0_right);
  const double vp_1a = KSL_MUL(V->m10, c), vp_1b = KSL_MUL(V->m11, s), vp_1 = vp_1a - vp_1b,
      vp_1_right = vp_1a - vp_1,
      vp_1_lo1 = ksl_product_rest(V->m10, c, vp_1a, vp_1 + vp_1_right)
          - ksl_product_rest(V->m11, s, vp_1b, vp_1_right);
  const double vp_2a = KSL_MUL(V->m20, c), vp_2b = KSL_MUL(V->m21, s), vp_2 = vp_2a - vp_2b,
      vp_2_right = vp_2a - vp_2,
      vp_2_lo1 = ksl_product_rest(V->m20, c, vp_2a, vp_2 + vp_2_right)
          - ksl_product_rest(V->m21, s, vp_2b, vp_2_right);
  const double vq_0a = KSL_MUL(V->m00, s), vq_0b = KSL_MUL(V->m01, c), vq_0 = vq_0a + vq_0b,
      vq_0_right = vq_0 - vq_0a,
      vq_0_lo1 = ksl_product_rest(V->m00, s, vq_0a, vq_0 - vq_0_right)
          + ksl_product_rest(V->m01, c, vq_0b, vq_0_right);
  const double vq_1a = KSL_MUL(V->m10, s), vq_1b = KSL_MUL(V->m11, c), vq_1 = vq_1a + vq_1b,
      vq_1_right = vq_1 - vq_1a,
      vq_1_lo1 = ksl_product_rest(V->m10, s, vq_1a, vq_1 - vq_1_right)
          + ksl_product_rest(V->m11, c, vq_1b, vq_1_right);
  const double vq_2a = KSL_MUL(V->m20, s), vq_2b = KSL_MUL(V->m21, c), vq_2 = vq_2a + vq_2b,
      vq_2_right = vq_2 - vq_2a,
      vq_2_lo1 = ksl_product_rest(V->m20, s, vq_2a, vq_2 - vq_2_right)
          + ksl_product_rest(V->m21, c, vq_2b, vq_2_right);
  const double A_00_new = A->m11 + change, A_00_new_right = A_00_new - A->m11;
  const double A_22_new = A->m00 - change, A_22_new_right = A->m00 - A_22_new;
  const double A_00_new_rounded = A_00_new
          + (A->m11 - (A_00_new - A_00_new_right)
          + ksl_product_rest(A->m10, t, change, A_00_new_right) + change_cross2);
  const double zq_rounded = zq + (zq_lo1 + (KSL_MUL(A->m20, s_lo) + KSL_MUL(A->m21, c_lo))),
      zq_final = zq_rounded == zq_rounded ? zq_rounded : zq;
  const double zp_rounded = zp + (zp_lo1 + (KSL_MUL(A->m20, c_lo) - KSL_MUL(A->m21, s_lo))),
      zp_final = zp_rounded == zp_rounded ? zp_rounded : zp;
  const double A_22_new_rounded = A_22_new
          + (A->m00 - (A_22_new + A_22_new_right)
          - ksl_product_rest(A->m10, t, change, A_22_new_right) - change_cross2);
  const double vq_0_rounded = vq_0 + (vq_0_lo1 + (KSL_MUL(V->m00, s_lo) + KSL_MUL(V->m01, c_lo)));
  const double vp_0_rounded = vp_0 + (vp_0_lo1 + (KSL_MUL(V->m00, c_lo) - KSL_MUL(V->m01, s_lo)));
  const double vq_1_rounded = vq_1 + (vq_1_lo1 + (KSL_MUL(V->m10, s_lo) + KSL_MUL(V->m11, c_lo)));
  const double vp_1_rounded = vp_1 + (vp_1_lo1 + (KSL_MUL(V->m10, c_lo) - KSL_MUL(V->m11, s_lo)));
  const double vq_2_rounded = vq_2 + (vq_2_lo1 + (KSL_MUL(V->m20, s_lo) + KSL_MUL(V->m21, c_lo)));
  const double vp_2_rounded = vp_2 + (vp_2_lo1 + (KSL_MUL(V->m20, c_lo) - KSL_MUL(V->m21, s_lo)));
  const double A_00_new_final = A_00_new_rounded == A_00_new_rounded ? A_00_new_rounded : A_00_new;
  const double A_22_new_final = A_22_new_rounded == A_22_new_rounded ? A_22_new_rounded : A_22_new;
  const double vq_0_final = vq_0_rounded == vq_0_rounded ? vq_0_rounded : vq_0;
  const double vp_0_final = vp_0_rounded == vp_0_rounded ? vp_0_rounded : vp_0;
  const double vq_1_final = vq_1_rounded == vq_1_rounded ? vq_1_rounded : vq_1;
  const double vp_1_final = vp_1_rounded == vp_1_rounded ? vp_1_rounded : vp_1;
  const double vq_2_final = vq_2_rounded == vq_2_rounded ? vq_2_rounded : vq_2;
  const double vp_2_final = vp_2_rounded == vp_2_rounded ? vp_2_rounded : vp_2;
  const double A_m22 = A->m22;
  const double V_m02 = V->m02;
  const double V_m12 = V->m12;
  const double V_m22 = V->m22;
  A->m00 = A_00_new_final;
  A->m01 = zq_final;
  A->m02 = 0.0;
  A->m10 = zq_final;
  A->m11 = A_m22;
  A->m12 = zp_final;
  A->m20 = 0.0;
  A->m21 = zp_final;
  A->m22 = A_22_new_final;
  V->m00 = vq_0_final;
  V->m01 = V_m02;
  V->m02 = vp_0_final;
  V->m10 = vq_1_final;
  V->m11 = V_m12;
  V->m12 = vp_1_final;
  V->m20 = vq_2_final;
  V->m21 = V_m22;
  V->m22 = vp_2_final;
}

/* the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if an
     entry is NaN.
   R: rotation or other 3×3 matrix.
   30 mul, 228 add, 27 product rest, 7 neg, 7 abs, 13 less, 19 select.
   Error <= 6 u near a rotation; measured, not proved. */
static inline double ksl_mat3x3_rotation_defect_accurate(const ksl_mat3x3_t *R) {
  const double n_0a = KSL_MUL(R->m11, R->m22), n_0b = KSL_MUL(R->m12, R->m21), n_0 = n_0a - n_0b,
      n_0_right = n_0a - n_0;
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1b = KSL_MUL(R->m01, R->m22), n_1 = n_1a - n_1b,
      n_1_right = n_1a - n_1;
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2b = KSL_MUL(R->m02, R->m11), n_2 = n_2a - n_2b,
      n_2_right = n_2a - n_2;
  const double det_a = KSL_MUL(R->m00, n_0), det_b = KSL_MUL(R->m10, n_1), det_c = det_a + det_b,
      det_c_right = det_c - det_a,
      det_a_cross2 = KSL_MUL(R->m00, ksl_product_rest(R->m11, R->m22, n_0a, n_0 + n_0_right)
          - ksl_product_rest(R->m12, R->m21, n_0b, n_0_right)),
      det_b_cross2 = KSL_MUL(R->m10, ksl_product_rest(R->m02, R->m21, n_1a, n_1 + n_1_right)
          - ksl_product_rest(R->m01, R->m22, n_1b, n_1_right)),
      det_c_lo1 = ksl_product_rest(R->m00, n_0, det_a, det_c - det_c_right)
          + ksl_product_rest(R->m10, n_1, det_b, det_c_right), det_d = KSL_MUL(R->m20, n_2),
      det = det_c + det_d, det_right = det - det_c,
      det_d_cross2 = KSL_MUL(R->m20, ksl_product_rest(R->m01, R->m12, n_2a, n_2 + n_2_right)
          - ksl_product_rest(R->m02, R->m11, n_2b, n_2_right));
  const double g_0a = KSL_MUL(R->m00, R->m00), g_0b = KSL_MUL(R->m10, R->m10), g_0c = g_0a + g_0b,
      g_0c_right = g_0c - g_0a, g_0d = KSL_MUL(R->m20, R->m20), g_0 = g_0c + g_0d,
      g_0_right = g_0 - g_0c,
      g_0c_lo = ksl_product_rest(R->m00, R->m00, g_0a, g_0c - g_0c_right)
          + ksl_product_rest(R->m10, R->m10, g_0b, g_0c_right);
  const double g_1a = KSL_MUL(R->m00, R->m01), g_1b = KSL_MUL(R->m10, R->m11), g_1c = g_1a + g_1b,
      g_1c_right = g_1c - g_1a, g_1d = KSL_MUL(R->m20, R->m21), g_1 = g_1c + g_1d,
      g_1_right = g_1 - g_1c,
      g_1c_lo = ksl_product_rest(R->m00, R->m01, g_1a, g_1c - g_1c_right)
          + ksl_product_rest(R->m10, R->m11, g_1b, g_1c_right),
      g_1_lo = g_1c - (g_1 - g_1_right) + ksl_product_rest(R->m20, R->m21, g_1d, g_1_right)
          + g_1c_lo;
  const double g_2a = KSL_MUL(R->m00, R->m02), g_2b = KSL_MUL(R->m10, R->m12), g_2c = g_2a + g_2b,
      g_2c_right = g_2c - g_2a, g_2d = KSL_MUL(R->m20, R->m22), g_2 = g_2c + g_2d,
      g_2_right = g_2 - g_2c,
      g_2c_lo = ksl_product_rest(R->m00, R->m02, g_2a, g_2c - g_2c_right)
          + ksl_product_rest(R->m10, R->m12, g_2b, g_2c_right),
      g_2_lo = g_2c - (g_2 - g_2_right) + ksl_product_rest(R->m20, R->m22, g_2d, g_2_right)
          + g_2c_lo;
  const double g_3a = KSL_MUL(R->m01, R->m01), g_3b = KSL_MUL(R->m11, R->m11), g_3c = g_3a + g_3b,
      g_3c_right = g_3c - g_3a, g_3d = KSL_MUL(R->m21, R->m21), g_3 = g_3c + g_3d,
      g_3_right = g_3 - g_3c,
      g_3c_lo = ksl_product_rest(R->m01, R->m01, g_3a, g_3c - g_3c_right)
          + ksl_product_rest(R->m11, R->m11, g_3b, g_3c_right);
  const double g_4a = KSL_MUL(R->m01, R->m02), g_4b = KSL_MUL(R->m11, R->m12), g_4c = g_4a + g_4b,
      g_4c_right = g_4c - g_4a, g_4d = KSL_MUL(R->m21, R->m22), g_4 = g_4c + g_4d,
      g_4_right = g_4 - g_4c,
      g_4c_lo = ksl_product_rest(R->m01, R->m02, g_4a, g_4c - g_4c_right)
          + ksl_product_rest(R->m11, R->m12, g_4b, g_4c_right),
      g_4_lo = g_4c - (g_4 - g_4_right) + ksl_product_rest(R->m21, R->m22, g_4d, g_4_right)
          + g_4c_lo;
  const double g_5a = KSL_MUL(R->m02, R->m02), g_5b = KSL_MUL(R->m12, R->m12), g_5c = g_5a + g_5b,
      g_5c_right = g_5c - g_5a, g_5d = KSL_MUL(R->m22, R->m22), g_5 = g_5c + g_5d,
      g_5_right = g_5 - g_5c,
      g_5c_lo = ksl_product_rest(R->m02, R->m02, g_5a, g_5c - g_5c_right)
          + ksl_product_rest(R->m12, R->m12, g_5b, g_5c_right);
  const double off_0 = det - 1.0, off_0_right = det - off_0;
  const double det_lo = det_c - (det - det_right) + ksl_product_rest(R->m20, n_2, det_d, det_right)
          + det_d_cross2 + (det_c_lo1 + (det_a_cross2 + det_b_cross2));
  const double off_0_lo = det - (off_0 + off_0_right) - (1.0 - off_0_right) + det_lo;
  const double off_1 = g_0 - 1.0, off_1_right = g_0 - off_1;
  const double g_0_lo = g_0c - (g_0 - g_0_right)
          + ksl_product_rest(R->m20, R->m20, g_0d, g_0_right) + g_0c_lo;
  const double off_1_lo = g_0 - (off_1 + off_1_right) - (1.0 - off_1_right) + g_0_lo;
  const double off_4 = g_3 - 1.0, off_4_right = g_3 - off_4;
  const double g_3_lo = g_3c - (g_3 - g_3_right)
          + ksl_product_rest(R->m21, R->m21, g_3d, g_3_right) + g_3c_lo;
  const double off_4_lo = g_3 - (off_4 + off_4_right) - (1.0 - off_4_right) + g_3_lo;
  const double off_6 = g_5 - 1.0, off_6_right = g_5 - off_6;
  const double g_5_lo = g_5c - (g_5 - g_5_right)
          + ksl_product_rest(R->m22, R->m22, g_5d, g_5_right) + g_5c_lo;
  const double off_6_lo = g_5 - (off_6 + off_6_right) - (1.0 - off_6_right) + g_5_lo;
  const double off_0_sum = off_0 + off_0_lo, off_0_sum_right = off_0_sum - off_0,
      off_0_sum_lo = off_0 - (off_0_sum - off_0_sum_right) + (off_0_lo - off_0_sum_right),
      defect_size_0 = fabs(off_0_sum), defect_size_0_opposite = -off_0_sum_lo,
      defect_size_0_lo = off_0_sum < 0.0 ? defect_size_0_opposite : off_0_sum_lo;
  const double off_1_sum = off_1 + off_1_lo, off_1_sum_right = off_1_sum - off_1,
      off_1_sum_lo = off_1 - (off_1_sum - off_1_sum_right) + (off_1_lo - off_1_sum_right),
      defect_size_1 = fabs(off_1_sum), defect_size_1_opposite = -off_1_sum_lo,
      defect_size_1_lo = off_1_sum < 0.0 ? defect_size_1_opposite : off_1_sum_lo;
  const double g_1_sum = g_1 + g_1_lo, g_1_sum_right = g_1_sum - g_1,
      g_1_sum_lo = g_1 - (g_1_sum - g_1_sum_right) + (g_1_lo - g_1_sum_right),
      defect_size_2 = fabs(g_1_sum), defect_size_2_opposite = -g_1_sum_lo,
      defect_size_2_lo = g_1_sum < 0.0 ? defect_size_2_opposite : g_1_sum_lo;
  const double g_2_sum = g_2 + g_2_lo, g_2_sum_right = g_2_sum - g_2,
      g_2_sum_lo = g_2 - (g_2_sum - g_2_sum_right) + (g_2_lo - g_2_sum_right),
      defect_size_3 = fabs(g_2_sum), defect_size_3_opposite = -g_2_sum_lo,
      defect_size_3_lo = g_2_sum < 0.0 ? defect_size_3_opposite : g_2_sum_lo;
  const double off_4_sum = off_4 + off_4_lo, off_4_sum_right = off_4_sum - off_4,
      off_4_sum_lo = off_4 - (off_4_sum - off_4_sum_right) + (off_4_lo - off_4_sum_right),
      defect_size_4 = fabs(off_4_sum), defect_size_4_opposite = -off_4_sum_lo,
      defect_size_4_lo = off_4_sum < 0.0 ? defect_size_4_opposite : off_4_sum_lo;
  const double g_4_sum = g_4 + g_4_lo, g_4_sum_right = g_4_sum - g_4,
      g_4_sum_lo = g_4 - (g_4_sum - g_4_sum_right) + (g_4_lo - g_4_sum_right),
      defect_size_5 = fabs(g_4_sum), defect_size_5_opposite = -g_4_sum_lo,
      defect_size_5_lo = g_4_sum < 0.0 ? defect_size_5_opposite : g_4_sum_lo;
  const double off_6_sum = off_6 + off_6_lo, off_6_sum_right = off_6_sum - off_6,
      off_6_sum_lo = off_6 - (off_6_sum - off_6_sum_right) + (off_6_lo - off_6_sum_right),
      defect_size_6 = fabs(off_6_sum), defect_size_6_opposite = -off_6_sum_lo,
      defect_size_6_lo = off_6_sum < 0.0 ? defect_size_6_opposite : off_6_sum_lo;
  const double defect_size_0_sum = defect_size_0 + defect_size_0_lo,
      defect_size_0_sum_right = defect_size_0_sum - defect_size_0,
      defect_size_0_sum_lo = defect_size_0 - (defect_size_0_sum - defect_size_0_sum_right)
          + (defect_size_0_lo - defect_size_0_sum_right),
      defect_size_1_sum = defect_size_1 + defect_size_1_lo,
      defect_size_1_sum_right = defect_size_1_sum - defect_size_1,
      defect_size_1_sum_lo = defect_size_1 - (defect_size_1_sum - defect_size_1_sum_right)
          + (defect_size_1_lo - defect_size_1_sum_right),
      defect_largest1 = defect_size_0_sum < defect_size_1_sum ? defect_size_1_sum
          : defect_size_0_sum,
      defect_largest1_lo = defect_size_0_sum < defect_size_1_sum ? defect_size_1_sum_lo
          : defect_size_0_sum_lo;
  const double defect_largest1_sum = defect_largest1 + defect_largest1_lo,
      defect_largest1_sum_right = defect_largest1_sum - defect_largest1,
      defect_largest1_sum_lo = defect_largest1 - (defect_largest1_sum - defect_largest1_sum_right)
          + (defect_largest1_lo - defect_largest1_sum_right),
      defect_size_2_sum = defect_size_2 + defect_size_2_lo,
      defect_size_2_sum_right = defect_size_2_sum - defect_size_2,
      defect_size_2_sum_lo = defect_size_2 - (defect_size_2_sum - defect_size_2_sum_right)
          + (defect_size_2_lo - defect_size_2_sum_right),
      defect_largest2 = defect_largest1_sum < defect_size_2_sum ? defect_size_2_sum
          : defect_largest1_sum,
      defect_largest2_lo = defect_largest1_sum < defect_size_2_sum ? defect_size_2_sum_lo
          : defect_largest1_sum_lo;
  const double defect_largest2_sum = defect_largest2 + defect_largest2_lo,
      defect_largest2_sum_right = defect_largest2_sum - defect_largest2,
      defect_largest2_sum_lo = defect_largest2 - (defect_largest2_sum - defect_largest2_sum_right)
          + (defect_largest2_lo - defect_largest2_sum_right),
      defect_size_3_sum = defect_size_3 + defect_size_3_lo,
      defect_size_3_sum_right = defect_size_3_sum - defect_size_3,
      defect_size_3_sum_lo = defect_size_3 - (defect_size_3_sum - defect_size_3_sum_right)
          + (defect_size_3_lo - defect_size_3_sum_right),
      defect_largest3 = defect_largest2_sum < defect_size_3_sum ? defect_size_3_sum
          : defect_largest2_sum,
      defect_largest3_lo = defect_largest2_sum < defect_size_3_sum ? defect_size_3_sum_lo
          : defect_largest2_sum_lo;
  const double defect_largest3_sum = defect_largest3 + defect_largest3_lo,
      defect_largest3_sum_right = defect_largest3_sum - defect_largest3,
      defect_largest3_sum_lo = defect_largest3 - (defect_largest3_sum - defect_largest3_sum_right)
          + (defect_largest3_lo - defect_largest3_sum_right),
      defect_size_4_sum = defect_size_4 + defect_size_4_lo,
      defect_size_4_sum_right = defect_size_4_sum - defect_size_4,
      defect_size_4_sum_lo = defect_size_4 - (defect_size_4_sum - defect_size_4_sum_right)
          + (defect_size_4_lo - defect_size_4_sum_right),
      defect_largest4 = defect_largest3_sum < defect_size_4_sum ? defect_size_4_sum
          : defect_largest3_sum,
      defect_largest4_lo = defect_largest3_sum < defect_size_4_sum ? defect_size_4_sum_lo
          : defect_largest3_sum_lo;
  const double defect_largest4_sum = defect_largest4 + defect_largest4_lo,
      defect_largest4_sum_right = defect_largest4_sum - defect_largest4,
      defect_largest4_sum_lo = defect_largest4 - (defect_largest4_sum - defect_largest4_sum_right)
          + (defect_largest4_lo - defect_largest4_sum_right),
      defect_size_5_sum = defect_size_5 + defect_size_5_lo,
      defect_size_5_sum_right = defect_size_5_sum - defect_size_5,
      defect_size_5_sum_lo = defect_size_5 - (defect_size_5_sum - defect_size_5_sum_right)
          + (defect_size_5_lo - defect_size_5_sum_right),
      defect_largest5 = defect_largest4_sum < defect_size_5_sum ? defect_size_5_sum
          : defect_largest4_sum,
      defect_largest5_lo = defect_largest4_sum < defect_size_5_sum ? defect_size_5_sum_lo
          : defect_largest4_sum_lo;
  const double defect_largest5_sum = defect_largest5 + defect_largest5_lo,
      defect_largest5_sum_right = defect_largest5_sum - defect_largest5,
      defect_largest5_sum_lo = defect_largest5 - (defect_largest5_sum - defect_largest5_sum_right)
          + (defect_largest5_lo - defect_largest5_sum_right),
      defect_size_6_sum = defect_size_6 + defect_size_6_lo,
      defect_size_6_sum_right = defect_size_6_sum - defect_size_6,
      defect_size_6_sum_lo = defect_size_6 - (defect_size_6_sum - defect_size_6_sum_right)
          + (defect_size_6_lo - defect_size_6_sum_right),
      defect_largest6 = defect_largest5_sum < defect_size_6_sum ? defect_size_6_sum
          : defect_largest5_sum;
  const double defect_largest6_rounded = defect_largest6
          + (defect_largest5_sum < defect_size_6_sum ? defect_size_6_sum_lo
          : defect_largest5_sum_lo);
  return defect_largest6_rounded;
}

/* R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
     not a rotation.
   axis: vector; angle: number; R: rotation or other 3×3 matrix.
   196 mul, 351 add, 26 product error, 18 product rest, 2 div, 6 abs, 3 less, 9 equal, 13 select.
   Error <= R: 1 u of its largest component for |axis| = 1; searched, not proved.  Each component
     is within 1 ulp as long as its condition is below 1e13; in single precision it is the
     nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_mat3x3_from_axis_angle_accurate(const ksl_vec3_t *axis, const double angle,
    ksl_mat3x3_t *R) {
  const double half = KSL_MUL(0.5, angle);
  const double h = ksl_sin(half), h_own_error = ksl_sin_error(half, h);
  double cosine; const double sine = ksl_sincos(angle, &cosine);
  double cosine_own_error; const double sine_own_error = ksl_sincos_error(angle, sine, cosine,
      &cosine_own_error);
  const double versine_a = KSL_MUL(h, h), versine_b = KSL_MUL(2.0, versine_a),
      versine_b_cross2 = KSL_MUL(2.0, ksl_product_error(h, h, versine_a)
          + (KSL_MUL(h_own_error, h) + KSL_MUL(h, h_own_error))), versine_c = 1.0 - cosine,
      versine_c_right = 1.0 - versine_c,
      versine_c_lo = 1.0 - (versine_c + versine_c_right) - (cosine - versine_c_right)
          - cosine_own_error, cosine_sum = cosine + cosine_own_error,
      versine = cosine_sum < 0.0 ? versine_c : versine_b,
      versine_lo = cosine_sum < 0.0 ? versine_c_lo : versine_b_cross2;
  const double beta_v_0 = KSL_MUL(axis->x, versine), beta_v_1 = KSL_MUL(axis->y, versine),
      beta_v_2 = KSL_MUL(axis->z, versine);
  const double beta_v_0_lo = ksl_product_error(axis->x, versine, beta_v_0)
          + KSL_MUL(axis->x, versine_lo), m_0 = KSL_MUL(axis->x, beta_v_0),
      m_0_cross2 = KSL_MUL(axis->x, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(axis->y, versine, beta_v_1)
          + KSL_MUL(axis->y, versine_lo), m_1 = KSL_MUL(axis->y, beta_v_1),
      m_1_cross2 = KSL_MUL(axis->y, beta_v_1_lo);
  const double m_2 = KSL_MUL(axis->z, beta_v_2),
      m_2_cross2 = KSL_MUL(axis->z, ksl_product_error(axis->z, versine, beta_v_2)
          + KSL_MUL(axis->z, versine_lo));
  const double m_3 = KSL_MUL(axis->y, beta_v_0), m_3_cross2 = KSL_MUL(axis->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(axis->z, beta_v_0), m_4_cross2 = KSL_MUL(axis->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(axis->z, beta_v_1), m_5_cross2 = KSL_MUL(axis->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(axis->y, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(axis->z, beta_v_2, m_2, others_0_right);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(axis->x, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(axis->z, beta_v_2, m_2, others_1_right);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(axis->x, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(axis->y, beta_v_1, m_1, others_2_right);
  const double alpha_v_0 = KSL_MUL(axis->x, sine),
      alpha_v_0_cross2 = KSL_MUL(axis->x, sine_own_error);
  const double alpha_v_1 = KSL_MUL(axis->y, sine),
      alpha_v_1_cross2 = KSL_MUL(axis->y, sine_own_error);
  const double alpha_v_2 = KSL_MUL(axis->z, sine),
      alpha_v_2_cross2 = KSL_MUL(axis->z, sine_own_error);
  const double R_00 = 1.0 - others_0, R_00_right = 1.0 - R_00;
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01,
      R_01_lo1 = ksl_product_rest(axis->y, beta_v_0, m_3, R_01 + R_01_right)
          - ksl_product_rest(axis->z, sine, alpha_v_2, R_01_right);
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4,
      R_02_lo1 = ksl_product_rest(axis->z, beta_v_0, m_4, R_02 - R_02_right)
          + ksl_product_rest(axis->y, sine, alpha_v_1, R_02_right);
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3,
      R_10_lo1 = ksl_product_rest(axis->y, beta_v_0, m_3, R_10 - R_10_right)
          + ksl_product_rest(axis->z, sine, alpha_v_2, R_10_right);
  const double R_11 = 1.0 - others_1, R_11_right = 1.0 - R_11;
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12,
      R_12_lo1 = ksl_product_rest(axis->z, beta_v_1, m_5, R_12 + R_12_right)
          - ksl_product_rest(axis->x, sine, alpha_v_0, R_12_right);
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20,
      R_20_lo1 = ksl_product_rest(axis->z, beta_v_0, m_4, R_20 + R_20_right)
          - ksl_product_rest(axis->y, sine, alpha_v_1, R_20_right);
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5,
      R_21_lo1 = ksl_product_rest(axis->z, beta_v_1, m_5, R_21 - R_21_right)
          + ksl_product_rest(axis->x, sine, alpha_v_0, R_21_right);
  const double R_22 = 1.0 - others_2, R_22_right = 1.0 - R_22;
  const double R_00_rounded = R_00
          + (1.0 - (R_00 + R_00_right) - (others_0 - R_00_right)
          - (others_0_lo1 + (m_1_cross2 + m_2_cross2)));
  const double R_01_rounded = R_01 + (R_01_lo1 + (m_3_cross2 - alpha_v_2_cross2));
  const double R_02_rounded = R_02 + (R_02_lo1 + (m_4_cross2 + alpha_v_1_cross2));
  const double R_10_rounded = R_10 + (R_10_lo1 + (m_3_cross2 + alpha_v_2_cross2));
  const double R_11_rounded = R_11
          + (1.0 - (R_11 + R_11_right) - (others_1 - R_11_right)
          - (others_1_lo1 + (m_0_cross2 + m_2_cross2)));
  const double R_12_rounded = R_12 + (R_12_lo1 + (m_5_cross2 - alpha_v_0_cross2));
  const double R_20_rounded = R_20 + (R_20_lo1 + (m_4_cross2 - alpha_v_1_cross2));
  const double R_21_rounded = R_21 + (R_21_lo1 + (m_5_cross2 + alpha_v_0_cross2));
  const double R_22_rounded = R_22
          + (1.0 - (R_22 + R_22_right) - (others_2 - R_22_right)
          - (others_2_lo1 + (m_0_cross2 + m_1_cross2)));
  const double R_00_final = R_00_rounded == R_00_rounded ? R_00_rounded : R_00;
  const double R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double R_11_final = R_11_rounded == R_11_rounded ? R_11_rounded : R_11;
  const double R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double R_22_final = R_22_rounded == R_22_rounded ? R_22_rounded : R_22;
  R->m00 = R_00_final;
  R->m01 = R_01_final;
  R->m02 = R_02_final;
  R->m10 = R_10_final;
  R->m11 = R_11_final;
  R->m12 = R_12_final;
  R->m20 = R_20_final;
  R->m21 = R_21_final;
  R->m22 = R_22_final;
}

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.
   R: rotation or other 3×3 matrix; axis: vector.
   157 mul, 448 add, 25 product error, 3 product rest, 14 div, 1 sqrt, 13 neg, 13 abs, 4
     copysign, 29 less, 10 equal, 80 select.
   Error <= angle: 1 u, axis: 1 u of its largest component for R a rotation; searched, not
     proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single
     precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline double ksl_axis_angle_from_mat3x3_accurate(const ksl_mat3x3_t *R, ksl_vec3_t *axis) {
  const double p_0 = R->m21 - R->m12, p_0_right = R->m21 - p_0,
      p_0_lo = R->m21 - (p_0 + p_0_right) - (R->m12 - p_0_right);
  const double p_1 = R->m02 - R->m20, p_1_right = R->m02 - p_1,
      p_1_lo = R->m02 - (p_1 + p_1_right) - (R->m20 - p_1_right);
  const double p_2 = R->m10 - R->m01, p_2_right = R->m10 - p_2,
      p_2_lo = R->m10 - (p_2 + p_2_right) - (R->m01 - p_2_right);
  const double s_0 = R->m12 + R->m21, s_0_right = s_0 - R->m12,
      s_0_lo = R->m12 - (s_0 - s_0_right) + (R->m21 - s_0_right);
  const double s_1 = R->m02 + R->m20, s_1_right = s_1 - R->m02,
      s_1_lo = R->m02 - (s_1 - s_1_right) + (R->m20 - s_1_right);
  const double s_2 = R->m01 + R->m10, s_2_right = s_2 - R->m01,
      s_2_lo = R->m01 - (s_2 - s_2_right) + (R->m10 - s_2_right);
  const double first_0 = R->m00 + 1.0, first_0_right = first_0 - R->m00,
      first_0_lo = R->m00 - (first_0 - first_0_right) + (1.0 - first_0_right);
  const double first_1 = 1.0 - R->m00, first_1_right = 1.0 - first_1,
      first_1_lo = 1.0 - (first_1 + first_1_right) - (R->m00 - first_1_right);
  const double others_0 = R->m11 + R->m22, others_0_right = others_0 - R->m11,
      others_0_lo = R->m11 - (others_0 - others_0_right) + (R->m22 - others_0_right);
  const double others_1 = R->m11 - R->m22, others_1_right = R->m11 - others_1,
      others_1_lo = R->m11 - (others_1 + others_1_right) - (R->m22 - others_1_right);
  const double d_0 = first_0 + others_0, d_0_right = d_0 - first_0,
      d_0_lo = first_0 - (d_0 - d_0_right) + (others_0 - d_0_right) + others_0_lo + first_0_lo;
  const double d_1 = first_0 - others_0, d_1_right = first_0 - d_1,
      d_1_lo = first_0 - (d_1 + d_1_right) - (others_0 - d_1_right) - others_0_lo + first_0_lo;
  const double d_2 = first_1 + others_1, d_2_right = d_2 - first_1,
      d_2_lo = first_1 - (d_2 - d_2_right) + (others_1 - d_2_right) + others_1_lo + first_1_lo;
  const double d_3 = first_1 - others_1, d_3_right = first_1 - d_3,
      d_3_lo = first_1 - (d_3 + d_3_right) - (others_1 - d_3_right) - others_1_lo + first_1_lo;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2, low_0_lo = R->m11 < R->m00 ? d_1_lo : s_2_lo;
  const double low_1 = R->m11 < R->m00 ? s_2 : d_2, low_1_lo = R->m11 < R->m00 ? s_2_lo : d_2_lo;
  const double low_2 = R->m11 < R->m00 ? s_1 : s_0, low_2_lo = R->m11 < R->m00 ? s_1_lo : s_0_lo;
  const double low_3 = R->m11 < R->m00 ? p_0 : p_1, low_3_lo = R->m11 < R->m00 ? p_0_lo : p_1_lo;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0,
      high_0_lo = R->m00 < high_0a ? s_1_lo : p_0_lo;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1,
      high_1_lo = R->m00 < high_0a ? s_0_lo : p_1_lo;
  const double high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_2_lo = R->m00 < high_0a ? d_3_lo : p_2_lo;
  const double high_3 = R->m00 < high_0a ? p_2 : d_0,
      high_3_lo = R->m00 < high_0a ? p_2_lo : d_0_lo;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0,
      column_0_lo = R->m22 < 0.0 ? low_0_lo : high_0_lo;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_1_lo = R->m22 < 0.0 ? low_1_lo : high_1_lo;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2,
      column_2_lo = R->m22 < 0.0 ? low_2_lo : high_2_lo;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3,
      column_3_lo = R->m22 < 0.0 ? low_3_lo : high_3_lo;
  const double upper_0a = -column_0, upper_0a_lo = -column_0_lo,
      column_3_sum = column_3 + column_3_lo, column_3_sum_right = column_3_sum - column_3,
      column_3_sum_lo = column_3 - (column_3_sum - column_3_sum_right)
          + (column_3_lo - column_3_sum_right), upper_0 = column_3_sum < 0.0 ? upper_0a : column_0,
      upper_0_lo = column_3_sum < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = column_3_sum < 0.0 ? upper_1a : column_1,
      upper_1_lo = column_3_sum < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = column_3_sum < 0.0 ? upper_2a : column_2,
      upper_2_lo = column_3_sum < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -column_3_sum, upper_3a_lo = -column_3_sum_lo,
      upper_3 = column_3_sum < 0.0 ? upper_3a : column_3_sum,
      upper_3_lo = column_3_sum < 0.0 ? upper_3a_lo : column_3_sum_lo;
  const double upper_0_sum = upper_0 + upper_0_lo, upper_0_sum_right = upper_0_sum - upper_0,
      upper_0_sum_lo = upper_0 - (upper_0_sum - upper_0_sum_right)
          + (upper_0_lo - upper_0_sum_right), v_s_size_0 = fabs(upper_0_sum),
      v_s_size_0_opposite = -upper_0_sum_lo,
      v_s_size_0_lo = upper_0_sum < 0.0 ? v_s_size_0_opposite : upper_0_sum_lo;
  const double upper_1_sum = upper_1 + upper_1_lo, upper_1_sum_right = upper_1_sum - upper_1,
      upper_1_sum_lo = upper_1 - (upper_1_sum - upper_1_sum_right)
          + (upper_1_lo - upper_1_sum_right), v_s_size_1 = fabs(upper_1_sum),
      v_s_size_1_opposite = -upper_1_sum_lo,
      v_s_size_1_lo = upper_1_sum < 0.0 ? v_s_size_1_opposite : upper_1_sum_lo;
  const double upper_2_sum = upper_2 + upper_2_lo, upper_2_sum_right = upper_2_sum - upper_2,
      upper_2_sum_lo = upper_2 - (upper_2_sum - upper_2_sum_right)
          + (upper_2_lo - upper_2_sum_right), v_s_size_2 = fabs(upper_2_sum),
      v_s_size_2_opposite = -upper_2_sum_lo,
      v_s_size_2_lo = upper_2_sum < 0.0 ? v_s_size_2_opposite : upper_2_sum_lo;
  const double v_s_size_0_sum = v_s_size_0 + v_s_size_0_lo,
      v_s_size_0_sum_right = v_s_size_0_sum - v_s_size_0,
      v_s_size_0_sum_lo = v_s_size_0 - (v_s_size_0_sum - v_s_size_0_sum_right)
          + (v_s_size_0_lo - v_s_size_0_sum_right), v_s_size_1_sum = v_s_size_1 + v_s_size_1_lo,
      v_s_size_1_sum_right = v_s_size_1_sum - v_s_size_1,
      v_s_size_1_sum_lo = v_s_size_1 - (v_s_size_1_sum - v_s_size_1_sum_right)
          + (v_s_size_1_lo - v_s_size_1_sum_right),
      v_s_largest1 = v_s_size_0_sum < v_s_size_1_sum ? v_s_size_1_sum : v_s_size_0_sum,
      v_s_largest1_lo = v_s_size_0_sum < v_s_size_1_sum ? v_s_size_1_sum_lo : v_s_size_0_sum_lo;
  const double v_s_largest1_sum = v_s_largest1 + v_s_largest1_lo,
      v_s_largest1_sum_right = v_s_largest1_sum - v_s_largest1,
      v_s_largest1_sum_lo = v_s_largest1 - (v_s_largest1_sum - v_s_largest1_sum_right)
          + (v_s_largest1_lo - v_s_largest1_sum_right), v_s_size_2_sum = v_s_size_2 + v_s_size_2_lo,
      v_s_size_2_sum_right = v_s_size_2_sum - v_s_size_2,
      v_s_size_2_sum_lo = v_s_size_2 - (v_s_size_2_sum - v_s_size_2_sum_right)
          + (v_s_size_2_lo - v_s_size_2_sum_right),
      v_s_largest2 = v_s_largest1_sum < v_s_size_2_sum ? v_s_size_2_sum : v_s_largest1_sum;
  const double v_s_largest2_sum = v_s_largest2
          + (v_s_largest1_sum < v_s_size_2_sum ? v_s_size_2_sum_lo : v_s_largest1_sum_lo),
      v_s_b = 6.703903964971299e+153 < v_s_largest2_sum ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2_sum < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2_sum < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0_sum, v_s), v_y_0_inverse = 1.0 / v_s,
      v_y_0_lo = KSL_MUL(upper_0_sum - KSL_MUL(v_y_0, v_y_0_inverse) + upper_0_sum_lo, v_s);
  const double v_y_1 = KSL_MUL(upper_1_sum, v_s),
      v_y_1_lo = KSL_MUL(upper_1_sum - KSL_MUL(v_y_1, v_y_0_inverse) + upper_1_sum_lo, v_s);
  const double v_y_2 = KSL_MUL(upper_2_sum, v_s),
      v_y_2_lo = KSL_MUL(upper_2_sum - KSL_MUL(v_y_2, v_y_0_inverse) + upper_2_sum_lo, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_c_right = v_n_c - v_n_a,
      v_n_c_lo1 = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right), v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_e = v_n_c + v_n_d, v_n_e_right = v_n_e - v_n_c,
      v_n_e_lo2 = v_n_c - (v_n_e - v_n_e_right)
          + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
          + (KSL_MUL(v_y_2_lo, v_y_2) + KSL_MUL(v_y_2, v_y_2_lo)),
      v_n_e_lo = v_n_e_lo2
          + (v_n_c_lo1
          + (KSL_MUL(v_y_0_lo, v_y_0) + KSL_MUL(v_y_0, v_y_0_lo)
          + (KSL_MUL(v_y_1_lo, v_y_1) + KSL_MUL(v_y_1, v_y_1_lo)))), v_n_e_sum = v_n_e + v_n_e_lo,
      v_n_e_sum_right = v_n_e_sum - v_n_e, v_n = sqrt(v_n_e_sum), v_n_product = KSL_MUL(v_n, v_n),
      v_n_e_sum_lo = v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right),
      v_n_twice = v_n + v_n,
      v_n_lo = (v_n_e_sum - v_n_product - ksl_product_error(v_n, v_n, v_n_product) + v_n_e_sum_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double v_n_sum = v_n + v_n_lo, v_n_sum_right = v_n_sum - v_n,
      v_n_sum_lo = v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right),
      n = KSL_MUL(v_n_sum, v_r), n_lo = KSL_MUL(v_n_sum - KSL_MUL(n, 1.0 / v_r) + v_n_sum_lo, v_r);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n, upper_3_sum = upper_3 + upper_3_lo,
      upper_3_sum_right = upper_3_sum - upper_3, half = ksl_atan2(n_sum, upper_3_sum),
      half_size0 = fabs(n_sum), half_size1 = fabs(upper_3_sum),
      half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = n_sum / half_divisor,
      half_part1 = upper_3_sum / half_divisor,
      half_cross2 = KSL_MUL(half_part0, upper_3 - (upper_3_sum - upper_3_sum_right)
          + (upper_3_lo - upper_3_sum_right)),
      half_divisor2 = KSL_MUL(half_divisor, KSL_MUL(half_part1, half_part1)
          + KSL_MUL(half_part0, half_part0)),
      half_more = (KSL_MUL(half_part1, n - (n_sum - n_sum_right) + (n_lo - n_sum_right))
          - half_cross2) / (half_most == 0.0 ? 1.0 : half_divisor2);
  const double divisor = v_n_sum == 0.0 ? 1.0 : v_n_sum,
      divisor_lo = v_n_sum == 0.0 ? 0.0 : v_n_sum_lo;
  const double v_y_0_sum = v_y_0 + v_y_0_lo, v_y_0_sum_right = v_y_0_sum - v_y_0,
      divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), unit_0 = v_y_0_sum / divisor_sum,
      unit_0_product = KSL_MUL(unit_0, divisor_sum),
      unit_0_exact = v_y_0_sum - unit_0_product
          - ksl_product_error(unit_0, divisor_sum, unit_0_product),
      unit_0_lo = (unit_0_exact
          + (v_y_0 - (v_y_0_sum - v_y_0_sum_right) + (v_y_0_lo - v_y_0_sum_right))
          - KSL_MUL(unit_0, divisor_sum_lo)) / divisor_sum;
  const double v_y_1_sum = v_y_1 + v_y_1_lo, v_y_1_sum_right = v_y_1_sum - v_y_1,
      unit_1 = v_y_1_sum / divisor_sum, unit_1_product = KSL_MUL(unit_1, divisor_sum),
      unit_1_exact = v_y_1_sum - unit_1_product
          - ksl_product_error(unit_1, divisor_sum, unit_1_product);
  const double v_y_2_sum = v_y_2 + v_y_2_lo, v_y_2_sum_right = v_y_2_sum - v_y_2,
      unit_2 = v_y_2_sum / divisor_sum, unit_2_product = KSL_MUL(unit_2, divisor_sum),
      unit_2_exact = v_y_2_sum - unit_2_product
          - ksl_product_error(unit_2, divisor_sum, unit_2_product);
  const double angle = KSL_MUL(2.0, half);
  const double axis_0 = v_n_sum == 0.0 ? 1.0 : unit_0;
  const double angle_rounded = angle
          + KSL_MUL(2.0, ksl_atan2_error(n_sum, upper_3_sum, half) + half_more);
  const double axis_0_rounded = axis_0 + (v_n_sum == 0.0 ? 0.0 : unit_0_lo);
  const double unit_1_lo = (unit_1_exact
          + (v_y_1 - (v_y_1_sum - v_y_1_sum_right) + (v_y_1_lo - v_y_1_sum_right))
          - KSL_MUL(unit_1, divisor_sum_lo)) / divisor_sum;
  const double unit_1_rounded = unit_1 + unit_1_lo;
  const double unit_2_lo = (unit_2_exact
          + (v_y_2 - (v_y_2_sum - v_y_2_sum_right) + (v_y_2_lo - v_y_2_sum_right))
          - KSL_MUL(unit_2, divisor_sum_lo)) / divisor_sum;
  const double unit_2_rounded = unit_2 + unit_2_lo;
  const double angle_final = angle_rounded == angle_rounded ? angle_rounded : angle;
  const double axis_0_final = axis_0_rounded == axis_0_rounded ? axis_0_rounded : axis_0;
  const double unit_1_final = unit_1_rounded == unit_1_rounded ? unit_1_rounded : unit_1;
  const double unit_2_final = unit_2_rounded == unit_2_rounded ? unit_2_rounded : unit_2;
  axis->x = axis_0_final;
  axis->y = unit_1_final;
  axis->z = unit_2_final;
  return angle_final;
}

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x.
   w, dw: vector; Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_acceleration_tensorf_accurate(const ksl_vec3f_t *w, const ksl_vec3f_t *dw,
    ksl_mat3x3f_t *Ro) {
  const double ww_0 = (double)w->x * (double)w->x, ww_1 = (double)w->y * (double)w->y,
      ww_2 = (double)w->z * (double)w->z, ww_3 = (double)w->x * (double)w->y,
      ww_4 = (double)w->x * (double)w->z, ww_5 = (double)w->y * (double)w->z;
  const double Ro_00 = -ww_1 - ww_2, Ro_01 = ww_3 - (double)dw->z, Ro_02 = (double)dw->y + ww_4,
      Ro_10 = (double)dw->z + ww_3, Ro_11 = -ww_0 - ww_2, Ro_12 = ww_5 - (double)dw->x,
      Ro_20 = ww_4 - (double)dw->y, Ro_21 = (double)dw->x + ww_5, Ro_22 = -ww_0 - ww_1;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* det R.
   R: rotation or other 3×3 matrix.
   9 mul, 5 add.
   Error <= u |result| + 5/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_mat3x3f_determinant_accurate(const ksl_mat3x3f_t *R) {
  const double n_0 = ksl_product_sum(-(double)R->m12, (double)R->m21, (double)R->m11
          * (double)R->m22),
      n_1 = ksl_product_sum(-(double)R->m01, (double)R->m22, (double)R->m02 * (double)R->m21),
      n_2 = ksl_product_sum(-(double)R->m02, (double)R->m11, (double)R->m01 * (double)R->m12);
  const double det = KSL_MUL((double)R->m00, n_0) + KSL_MUL((double)R->m10, n_1)
          + KSL_MUL((double)R->m20, n_2);
  return (float)det;
}

/* Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or overflows.
     Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3 (double
     1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.
   R, Ro: rotation or other 3×3 matrix.
   56 mul, 17 add, 9 div, 1 neg, 19 abs, 16 less, 1 equal, 32 select.
   Error of Ro_ij <= 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the sum of the |terms| of
     the cofactor, or 2^-80 m^2 (double 2^-700 m^2) if that is more; barring over- and underflow
     of Ro_ij itself. */
static inline float ksl_mat3x3f_inverse_accurate(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const double R_size_0 = fabs((double)R->m00), R_size_1 = fabs((double)R->m01),
      R_size_2 = fabs((double)R->m02), R_size_3 = fabs((double)R->m10),
      R_size_4 = fabs((double)R->m11), R_size_5 = fabs((double)R->m12),
      R_size_6 = fabs((double)R->m20), R_size_7 = fabs((double)R->m21),
      R_size_8 = fabs((double)R->m22);
  const double R_largest1 = R_size_0 < R_size_1 ? R_size_1 : R_size_0;
  const double R_largest2 = R_largest1 < R_size_2 ? R_size_2 : R_largest1;
  const double R_largest3 = R_largest2 < R_size_3 ? R_size_3 : R_largest2;
  const double R_largest4 = R_largest3 < R_size_4 ? R_size_4 : R_largest3;
  const double R_largest5 = R_largest4 < R_size_5 ? R_size_5 : R_largest4;
  const double R_largest6 = R_largest5 < R_size_6 ? R_size_6 : R_largest5;
  const double R_largest7 = R_largest6 < R_size_7 ? R_size_7 : R_largest6;
  const double R_largest8 = R_largest7 < R_size_8 ? R_size_8 : R_largest7;
  const double s_b = R_largest8 < 1.329227995784916e+36 ? 8.271806125530277e-25
          : 7.52316384526264e-37,
      s_d = R_largest8 < 1.2089258196146292e+24 ? 9.094947017729282e-13 : s_b,
      s_f = R_largest8 < 1099511627776.0 ? 1.0 : s_d,
      s_h = R_largest8 < 1.0 ? 1099511627776.0 : s_f,
      s_j = R_largest8 < 9.094947017729282e-13 ? 1.2089258196146292e+24 : s_h,
      s = R_largest8 < 8.271806125530277e-25 ? 1.329227995784916e+36 : s_j;
  const double A_0 = KSL_MUL((double)R->m00, s), A_1 = KSL_MUL((double)R->m01, s),
      A_2 = KSL_MUL((double)R->m02, s), A_3 = KSL_MUL((double)R->m10, s),
      A_4 = KSL_MUL((double)R->m11, s), A_5 = KSL_MUL((double)R->m12, s),
      A_6 = KSL_MUL((double)R->m20, s), A_7 = KSL_MUL((double)R->m21, s),
      A_8 = KSL_MUL((double)R->m22, s);
  const double n0_0 = KSL_MUL(A_4, A_8) - KSL_MUL(A_5, A_7),
      n0_1 = KSL_MUL(A_2, A_7) - KSL_MUL(A_1, A_8), n0_2 = KSL_MUL(A_1, A_5) - KSL_MUL(A_2, A_4);
  const double n1_0 = KSL_MUL(A_5, A_6) - KSL_MUL(A_3, A_8),
      n1_1 = KSL_MUL(A_0, A_8) - KSL_MUL(A_2, A_6), n1_2 = KSL_MUL(A_2, A_3) - KSL_MUL(A_0, A_5);
  const double n2_0 = KSL_MUL(A_3, A_7) - KSL_MUL(A_4, A_6),
      n2_1 = KSL_MUL(A_1, A_6) - KSL_MUL(A_0, A_7), n2_2 = KSL_MUL(A_0, A_4) - KSL_MUL(A_1, A_3);
  const double d = KSL_MUL(A_0, n0_0) + KSL_MUL(A_3, n0_1) + KSL_MUL(A_6, n0_2);
  const double size0_0 = fabs(A_0), size0_1 = fabs(A_3), size0_2 = fabs(A_6);
  const double size1_0 = fabs(A_1), size1_1 = fabs(A_4), size1_2 = fabs(A_7);
  const double size2_0 = fabs(A_2), size2_1 = fabs(A_5), size2_2 = fabs(A_8);
  const double permanent_d = KSL_MUL(size0_0, KSL_MUL(size1_1, size2_2)
          + KSL_MUL(size1_2, size2_1)),
      permanent_i = permanent_d
          + KSL_MUL(size0_1, KSL_MUL(size1_0, size2_2) + KSL_MUL(size1_2, size2_0)),
      permanent = permanent_i
          + KSL_MUL(size0_2, KSL_MUL(size1_0, size2_1) + KSL_MUL(size1_1, size2_0));
  const double top = KSL_MUL(R_largest8, s);
  const double spoiled = KSL_MUL(top, 1.262177448353619e-29);
  const double least = KSL_MUL(permanent, 4.76837158203125e-07)
          + KSL_MUL(spoiled, KSL_MUL(top, top));
  const double regular = least < fabs(d) ? 1.0 : 0.0;
  const double divisor = regular == 1.0 ? d : 1.0;
  const double quotient_0 = n0_0 / divisor, quotient_1 = n0_1 / divisor,
      quotient_2 = n0_2 / divisor, quotient_3 = n1_0 / divisor, quotient_4 = n1_1 / divisor,
      quotient_5 = n1_2 / divisor, quotient_6 = n2_0 / divisor, quotient_7 = n2_1 / divisor,
      quotient_8 = n2_2 / divisor;
  const double inverse_0 = KSL_MUL(quotient_0, s), inverse_1 = KSL_MUL(quotient_1, s),
      inverse_2 = KSL_MUL(quotient_2, s), inverse_3 = KSL_MUL(quotient_3, s),
      inverse_4 = KSL_MUL(quotient_4, s), inverse_5 = KSL_MUL(quotient_5, s),
      inverse_6 = KSL_MUL(quotient_6, s), inverse_7 = KSL_MUL(quotient_7, s),
      inverse_8 = KSL_MUL(quotient_8, s);
  const double start_a = -1.329227995784916e+36,
      start_c = d < 0.0 ? start_a : 1.329227995784916e+36,
      start = R_largest8 < 1.2089258196146292e+24 ? d : start_c;
  const double r2 = R_largest8 < 9.094947017729282e-13 ? 7.52316384526264e-37 : 1.0;
  const double once = KSL_MUL(start, r2);
  const double r3 = R_largest8 < 8.271806125530277e-25 ? 7.52316384526264e-37 : 1.0;
  const double twice = KSL_MUL(once, r3);
  const double r_a = R_largest8 < 1099511627776.0 ? 1.0 : 1.329227995784916e+36,
      r = R_largest8 < 1.0 ? 7.52316384526264e-37 : r_a;
  const double det_R = KSL_MUL(twice, r);
  const double det = regular == 1.0 ? det_R : 0.0;
  const double Ro_00 = regular == 1.0 ? inverse_0 : (double)NAN,
      Ro_01 = regular == 1.0 ? inverse_1 : (double)NAN,
      Ro_02 = regular == 1.0 ? inverse_2 : (double)NAN,
      Ro_10 = regular == 1.0 ? inverse_3 : (double)NAN,
      Ro_11 = regular == 1.0 ? inverse_4 : (double)NAN,
      Ro_12 = regular == 1.0 ? inverse_5 : (double)NAN,
      Ro_20 = regular == 1.0 ? inverse_6 : (double)NAN,
      Ro_21 = regular == 1.0 ? inverse_7 : (double)NAN,
      Ro_22 = regular == 1.0 ? inverse_8 : (double)NAN;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
  return (float)det;
}

/* self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
     its side of the first, the third on its side of both; NaN where the rows are linearly
     dependent to rounding.
   self: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   |R R^T - I|_ij <= 8 u for the result R; searched, not proved. */
static inline void ksl_mat3x3f_normalize_accurate(ksl_mat3x3f_t *self) {
  const double q0_s_size_0 = fabs((double)self->m00), q0_s_size_1 = fabs((double)self->m01),
      q0_s_size_2 = fabs((double)self->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 4.611686018427388e+18 < q0_s_largest2 ? 2.710505431213761e-20 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.8014398509481984e+16 : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : q0_s_d;
  const double q0_y_0 = KSL_MUL((double)self->m00, q0_s), q0_y_1 = KSL_MUL((double)self->m01, q0_s),
      q0_y_2 = KSL_MUL((double)self->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n = sqrt(KSL_MUL(q0_y_0, q0_y_0) + KSL_MUL(q0_y_1, q0_y_1)
          + KSL_MUL(q0_y_2, q0_y_2));
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_sized_0 = KSL_MUL((double)self->m00, q0_up),
      q0_sized_1 = KSL_MUL((double)self->m01, q0_up),
      q0_sized_2 = KSL_MUL((double)self->m02, q0_up);
  const double q0_quotient_0 = q0_sized_0 / q0_divisor, q0_quotient_1 = q0_sized_1 / q0_divisor,
      q0_quotient_2 = q0_sized_2 / q0_divisor;
  const double q0_0 = KSL_MUL(q0_quotient_0, q0_down), q0_1 = KSL_MUL(q0_quotient_1, q0_down),
      q0_2 = KSL_MUL(q0_quotient_2, q0_down);
  const double u1_s_size_0 = fabs((double)self->m10), u1_s_size_1 = fabs((double)self->m11),
      u1_s_size_2 = fabs((double)self->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 4.611686018427388e+18 < u1_s_largest2 ? 2.710505431213761e-20 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.8014398509481984e+16 : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : u1_s_d;
  const double u1_y_0 = KSL_MUL((double)self->m10, u1_s), u1_y_1 = KSL_MUL((double)self->m11, u1_s),
      u1_y_2 = KSL_MUL((double)self->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n = sqrt(KSL_MUL(u1_y_0, u1_y_0) + KSL_MUL(u1_y_1, u1_y_1)
          + KSL_MUL(u1_y_2, u1_y_2));
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_sized_0 = KSL_MUL((double)self->m10, u1_up),
      u1_sized_1 = KSL_MUL((double)self->m11, u1_up),
      u1_sized_2 = KSL_MUL((double)self->m12, u1_up);
  const double u1_quotient_0 = u1_sized_0 / u1_divisor, u1_quotient_1 = u1_sized_1 / u1_divisor,
      u1_quotient_2 = u1_sized_2 / u1_divisor;
  const double u1_0 = KSL_MUL(u1_quotient_0, u1_down), u1_1 = KSL_MUL(u1_quotient_1, u1_down),
      u1_2 = KSL_MUL(u1_quotient_2, u1_down);
  const double along = KSL_MUL(q0_0, u1_0) + KSL_MUL(q0_1, u1_1) + KSL_MUL(q0_2, u1_2);
  const double once_0 = u1_0 - KSL_MUL(q0_0, along), once_1 = u1_1 - KSL_MUL(q0_1, along),
      once_2 = u1_2 - KSL_MUL(q0_2, along);
  const double rest = KSL_MUL(q0_0, once_0) + KSL_MUL(q0_1, once_1) + KSL_MUL(q0_2, once_2);
  const double twice_0 = once_0 - KSL_MUL(q0_0, rest), twice_1 = once_1 - KSL_MUL(q0_1, rest),
      twice_2 = once_2 - KSL_MUL(q0_2, rest);
  const double n = sqrt(KSL_MUL(twice_0, twice_0) + KSL_MUL(twice_1, twice_1)
          + KSL_MUL(twice_2, twice_2));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor, q1_1 = twice_1 / divisor, q1_2 = twice_2 / divisor;
  const double normal_0 = KSL_MUL(q0_1, q1_2) - KSL_MUL(q0_2, q1_1),
      normal_1 = KSL_MUL(q0_2, q1_0) - KSL_MUL(q0_0, q1_2),
      normal_2 = KSL_MUL(q0_0, q1_1) - KSL_MUL(q0_1, q1_0);
  const double u2_s_size_0 = fabs((double)self->m20), u2_s_size_1 = fabs((double)self->m21),
      u2_s_size_2 = fabs((double)self->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 4.611686018427388e+18 < u2_s_largest2 ? 2.710505431213761e-20 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.8014398509481984e+16 : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : u2_s_d;
  const double u2_y_0 = KSL_MUL((double)self->m20, u2_s), u2_y_1 = KSL_MUL((double)self->m21, u2_s),
      u2_y_2 = KSL_MUL((double)self->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n = sqrt(KSL_MUL(u2_y_0, u2_y_0) + KSL_MUL(u2_y_1, u2_y_1)
          + KSL_MUL(u2_y_2, u2_y_2));
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_sized_0 = KSL_MUL((double)self->m20, u2_up),
      u2_sized_1 = KSL_MUL((double)self->m21, u2_up),
      u2_sized_2 = KSL_MUL((double)self->m22, u2_up);
  const double u2_quotient_0 = u2_sized_0 / u2_divisor, u2_quotient_1 = u2_sized_1 / u2_divisor,
      u2_quotient_2 = u2_sized_2 / u2_divisor;
  const double u2_0 = KSL_MUL(u2_quotient_0, u2_down), u2_1 = KSL_MUL(u2_quotient_1, u2_down),
      u2_2 = KSL_MUL(u2_quotient_2, u2_down);
  const double side = KSL_MUL(normal_0, u2_0) + KSL_MUL(normal_1, u2_1) + KSL_MUL(normal_2, u2_2);
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 9.5367431640625e-07 ? 1.0 : 0.0;
  const double self_00_new = dependent == 1.0 ? (double)NAN : q0_0,
      self_01_new = dependent == 1.0 ? (double)NAN : q0_1,
      self_02_new = dependent == 1.0 ? (double)NAN : q0_2,
      self_10_new = dependent == 1.0 ? (double)NAN : q1_0,
      self_11_new = dependent == 1.0 ? (double)NAN : q1_1,
      self_12_new = dependent == 1.0 ? (double)NAN : q1_2,
      self_20_new = dependent == 1.0 ? (double)NAN : q2_0,
      self_21_new = dependent == 1.0 ? (double)NAN : q2_1,
      self_22_new = dependent == 1.0 ? (double)NAN : q2_2;
  self->m00 = (float)self_00_new;
  self->m01 = (float)self_01_new;
  self->m02 = (float)self_02_new;
  self->m10 = (float)self_10_new;
  self->m11 = (float)self_11_new;
  self->m12 = (float)self_12_new;
  self->m20 = (float)self_20_new;
  self->m21 = (float)self_21_new;
  self->m22 = (float)self_22_new;
}

/* Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on its
     side of the first, the third on its side of both; NaN where the rows are linearly dependent
     to rounding.
   R, Ro: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   |R R^T - I|_ij <= 8 u for the result R; searched, not proved. */
static inline void ksl_mat3x3f_normalized_accurate(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const double q0_s_size_0 = fabs((double)R->m00), q0_s_size_1 = fabs((double)R->m01),
      q0_s_size_2 = fabs((double)R->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 4.611686018427388e+18 < q0_s_largest2 ? 2.710505431213761e-20 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.8014398509481984e+16 : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : q0_s_d;
  const double q0_y_0 = KSL_MUL((double)R->m00, q0_s), q0_y_1 = KSL_MUL((double)R->m01, q0_s),
      q0_y_2 = KSL_MUL((double)R->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n = sqrt(KSL_MUL(q0_y_0, q0_y_0) + KSL_MUL(q0_y_1, q0_y_1)
          + KSL_MUL(q0_y_2, q0_y_2));
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_sized_0 = KSL_MUL((double)R->m00, q0_up),
      q0_sized_1 = KSL_MUL((double)R->m01, q0_up), q0_sized_2 = KSL_MUL((double)R->m02, q0_up);
  const double q0_quotient_0 = q0_sized_0 / q0_divisor, q0_quotient_1 = q0_sized_1 / q0_divisor,
      q0_quotient_2 = q0_sized_2 / q0_divisor;
  const double q0_0 = KSL_MUL(q0_quotient_0, q0_down), q0_1 = KSL_MUL(q0_quotient_1, q0_down),
      q0_2 = KSL_MUL(q0_quotient_2, q0_down);
  const double u1_s_size_0 = fabs((double)R->m10), u1_s_size_1 = fabs((double)R->m11),
      u1_s_size_2 = fabs((double)R->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 4.611686018427388e+18 < u1_s_largest2 ? 2.710505431213761e-20 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.8014398509481984e+16 : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : u1_s_d;
  const double u1_y_0 = KSL_MUL((double)R->m10, u1_s), u1_y_1 = KSL_MUL((double)R->m11, u1_s),
      u1_y_2 = KSL_MUL((double)R->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n = sqrt(KSL_MUL(u1_y_0, u1_y_0) + KSL_MUL(u1_y_1, u1_y_1)
          + KSL_MUL(u1_y_2, u1_y_2));
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_sized_0 = KSL_MUL((double)R->m10, u1_up),
      u1_sized_1 = KSL_MUL((double)R->m11, u1_up), u1_sized_2 = KSL_MUL((double)R->m12, u1_up);
  const double u1_quotient_0 = u1_sized_0 / u1_divisor, u1_quotient_1 = u1_sized_1 / u1_divisor,
      u1_quotient_2 = u1_sized_2 / u1_divisor;
  const double u1_0 = KSL_MUL(u1_quotient_0, u1_down), u1_1 = KSL_MUL(u1_quotient_1, u1_down),
      u1_2 = KSL_MUL(u1_quotient_2, u1_down);
  const double along = KSL_MUL(q0_0, u1_0) + KSL_MUL(q0_1, u1_1) + KSL_MUL(q0_2, u1_2);
  const double once_0 = u1_0 - KSL_MUL(q0_0, along), once_1 = u1_1 - KSL_MUL(q0_1, along),
      once_2 = u1_2 - KSL_MUL(q0_2, along);
  const double rest = KSL_MUL(q0_0, once_0) + KSL_MUL(q0_1, once_1) + KSL_MUL(q0_2, once_2);
  const double twice_0 = once_0 - KSL_MUL(q0_0, rest), twice_1 = once_1 - KSL_MUL(q0_1, rest),
      twice_2 = once_2 - KSL_MUL(q0_2, rest);
  const double n = sqrt(KSL_MUL(twice_0, twice_0) + KSL_MUL(twice_1, twice_1)
          + KSL_MUL(twice_2, twice_2));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor, q1_1 = twice_1 / divisor, q1_2 = twice_2 / divisor;
  const double normal_0 = KSL_MUL(q0_1, q1_2) - KSL_MUL(q0_2, q1_1),
      normal_1 = KSL_MUL(q0_2, q1_0) - KSL_MUL(q0_0, q1_2),
      normal_2 = KSL_MUL(q0_0, q1_1) - KSL_MUL(q0_1, q1_0);
  const double u2_s_size_0 = fabs((double)R->m20), u2_s_size_1 = fabs((double)R->m21),
      u2_s_size_2 = fabs((double)R->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 4.611686018427388e+18 < u2_s_largest2 ? 2.710505431213761e-20 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.8014398509481984e+16 : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : u2_s_d;
  const double u2_y_0 = KSL_MUL((double)R->m20, u2_s), u2_y_1 = KSL_MUL((double)R->m21, u2_s),
      u2_y_2 = KSL_MUL((double)R->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n = sqrt(KSL_MUL(u2_y_0, u2_y_0) + KSL_MUL(u2_y_1, u2_y_1)
          + KSL_MUL(u2_y_2, u2_y_2));
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_sized_0 = KSL_MUL((double)R->m20, u2_up),
      u2_sized_1 = KSL_MUL((double)R->m21, u2_up), u2_sized_2 = KSL_MUL((double)R->m22, u2_up);
  const double u2_quotient_0 = u2_sized_0 / u2_divisor, u2_quotient_1 = u2_sized_1 / u2_divisor,
      u2_quotient_2 = u2_sized_2 / u2_divisor;
  const double u2_0 = KSL_MUL(u2_quotient_0, u2_down), u2_1 = KSL_MUL(u2_quotient_1, u2_down),
      u2_2 = KSL_MUL(u2_quotient_2, u2_down);
  const double side = KSL_MUL(normal_0, u2_0) + KSL_MUL(normal_1, u2_1) + KSL_MUL(normal_2, u2_2);
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 9.5367431640625e-07 ? 1.0 : 0.0;
  const double Ro_00 = dependent == 1.0 ? (double)NAN : q0_0,
      Ro_01 = dependent == 1.0 ? (double)NAN : q0_1, Ro_02 = dependent == 1.0 ? (double)NAN : q0_2,
      Ro_10 = dependent == 1.0 ? (double)NAN : q1_0, Ro_11 = dependent == 1.0 ? (double)NAN : q1_1,
      Ro_12 = dependent == 1.0 ? (double)NAN : q1_2, Ro_20 = dependent == 1.0 ? (double)NAN : q2_0,
      Ro_21 = dependent == 1.0 ? (double)NAN : q2_1, Ro_22 = dependent == 1.0 ? (double)NAN : q2_2;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   12 mul, 10 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3f_setFromAxisDC_accurate(ksl_mat3x3f_t *R, const ksl_vec3f_t *axis,
    const float dc[2]) {
  const double versine = 1.0 - (double)dc[1];
  const double versine_axis_0 = KSL_MUL((double)axis->x, versine),
      versine_axis_1 = KSL_MUL((double)axis->y, versine),
      versine_axis_2 = KSL_MUL((double)axis->z, versine);
  const double m_0 = KSL_MUL((double)axis->x, versine_axis_0),
      m_1 = KSL_MUL((double)axis->y, versine_axis_1),
      m_2 = KSL_MUL((double)axis->z, versine_axis_2),
      m_3 = KSL_MUL((double)axis->y, versine_axis_0),
      m_4 = KSL_MUL((double)axis->z, versine_axis_0),
      m_5 = KSL_MUL((double)axis->z, versine_axis_1);
  const double sine_axis_0 = (double)axis->x * (double)dc[0],
      sine_axis_1 = (double)axis->y * (double)dc[0], sine_axis_2 = (double)axis->z * (double)dc[0];
  const double R_00 = (double)dc[1] + m_0, R_01 = m_3 - sine_axis_2, R_02 = m_4 + sine_axis_1,
      R_10 = m_3 + sine_axis_2, R_11 = (double)dc[1] + m_1, R_12 = m_5 - sine_axis_0,
      R_20 = m_4 - sine_axis_1, R_21 = m_5 + sine_axis_0, R_22 = (double)dc[1] + m_2;
  R->m00 = (float)R_00;
  R->m01 = (float)R_01;
  R->m02 = (float)R_02;
  R->m10 = (float)R_10;
  R->m11 = (float)R_11;
  R->m12 = (float)R_12;
  R->m20 = (float)R_20;
  R->m21 = (float)R_21;
  R->m22 = (float)R_22;
}

/* R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   98 mul, 103 add, 3 neg, 3 abs.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_mat3x3f_from_euler_xyz_accurate(const ksl_vec3f_t *angles,
    ksl_mat3x3f_t *R) {
  double c_0; const double s_0 = ksl_sincos((double)angles->x, &c_0);
  double c_1; const double s_1 = ksl_sincos((double)angles->y, &c_1);
  double c_2; const double s_2 = ksl_sincos((double)angles->z, &c_2);
  const double first_0 = KSL_MUL(c_1, c_2), first_1 = -KSL_MUL(s_2, c_1),
      first_6 = -KSL_MUL(s_1, c_2), first_7 = KSL_MUL(s_1, s_2);
  const double last_3 = KSL_MUL(s_2, c_0) - KSL_MUL(s_0, first_6),
      last_4 = KSL_MUL(c_0, c_2) - KSL_MUL(s_0, first_7), last_5 = -KSL_MUL(s_0, c_1),
      last_6 = KSL_MUL(s_0, s_2) + KSL_MUL(c_0, first_6),
      last_7 = KSL_MUL(s_0, c_2) + KSL_MUL(c_0, first_7), last_8 = KSL_MUL(c_0, c_1);
  R->m00 = (float)first_0;
  R->m01 = (float)first_1;
  R->m02 = (float)s_1;
  R->m10 = (float)last_3;
  R->m11 = (float)last_4;
  R->m12 = (float)last_5;
  R->m20 = (float)last_6;
  R->m21 = (float)last_7;
  R->m22 = (float)last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
     [-π/2, π/2]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   93 mul, 109 add, 5 div, 1 sqrt, 4 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_euler_xyz_from_mat3x3f_accurate(const ksl_mat3x3f_t *R,
    ksl_vec3f_t *angles) {
  const double n = sqrt(ksl_product_sum((double)R->m01, (double)R->m01, (double)R->m00
          * (double)R->m00));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = (double)R->m00 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine_a = -(double)R->m01, sine = sine_a / divisor;
  const double polar = ksl_atan2(sine_a, (double)R->m00);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1 = KSL_MUL((double)R->m10, sine) + KSL_MUL((double)R->m11, cosine),
      left_2 = KSL_MUL((double)R->m20, sine) + KSL_MUL((double)R->m21, cosine);
  const double rest = (double)R->m12 + (double)R->m22;
  const double first = ksl_atan2(left_2, left_1);
  const double angles_0 = rest < 1.2676506002282294e+30 ? first : rest,
      angles_1 = ksl_atan2((double)R->m02, n);
  angles->x = (float)angles_0;
  angles->y = (float)angles_1;
  angles->z = (float)third;
}

/* R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   98 mul, 103 add, 2 neg, 3 abs.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_mat3x3f_from_euler_xyx_accurate(const ksl_vec3f_t *angles,
    ksl_mat3x3f_t *R) {
  double c_0; const double s_0 = ksl_sincos((double)angles->x, &c_0);
  double c_1; const double s_1 = ksl_sincos((double)angles->y, &c_1);
  double c_2; const double s_2 = ksl_sincos((double)angles->z, &c_2);
  const double first_1 = KSL_MUL(s_1, s_2), first_2 = KSL_MUL(s_1, c_2),
      first_7 = KSL_MUL(s_2, c_1), first_8 = KSL_MUL(c_1, c_2);
  const double last_3 = KSL_MUL(s_0, s_1), last_4 = KSL_MUL(c_0, c_2) - KSL_MUL(s_0, first_7),
      last_5 = -KSL_MUL(s_0, first_8) - KSL_MUL(s_2, c_0), last_6 = -KSL_MUL(s_1, c_0),
      last_7 = KSL_MUL(s_0, c_2) + KSL_MUL(c_0, first_7),
      last_8 = KSL_MUL(c_0, first_8) - KSL_MUL(s_0, s_2);
  R->m00 = (float)c_1;
  R->m01 = (float)first_1;
  R->m02 = (float)first_2;
  R->m10 = (float)last_3;
  R->m11 = (float)last_4;
  R->m12 = (float)last_5;
  R->m20 = (float)last_6;
  R->m21 = (float)last_7;
  R->m22 = (float)last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in [0,
     π]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   93 mul, 109 add, 5 div, 1 sqrt, 3 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_euler_xyx_from_mat3x3f_accurate(const ksl_mat3x3f_t *R,
    ksl_vec3f_t *angles) {
  const double n = sqrt(ksl_product_sum((double)R->m02, (double)R->m02, (double)R->m01
          * (double)R->m01));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = (double)R->m02 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine = (double)R->m01 / divisor;
  const double polar = ksl_atan2((double)R->m01, (double)R->m02);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1 = KSL_MUL((double)R->m11, cosine) - KSL_MUL((double)R->m12, sine),
      left_2 = KSL_MUL((double)R->m21, cosine) - KSL_MUL((double)R->m22, sine);
  const double rest = (double)R->m10 + (double)R->m20;
  const double first = ksl_atan2(left_2, left_1);
  const double angles_0 = rest < 1.2676506002282294e+30 ? first : rest,
      angles_1 = ksl_atan2(n, (double)R->m00);
  angles->x = (float)angles_0;
  angles->y = (float)angles_1;
  angles->z = (float)third;
}

/* A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes
     A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.
     Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.
   A, V: rotation or other 3×3 matrix.
   21 mul, 14 add, 3 div, 2 sqrt, 1 neg, 1 abs, 1 less, 1 equal, 3 select.
   V A V^T changes by at most 28 u max |A| for orthonormal V; searched, not proved. */
static inline void ksl_mat3x3f_jacobi_accurate(ksl_mat3x3f_t *A, ksl_mat3x3f_t *V) {
  const double twice = 2.0 * (double)A->m10;
  const double apart = (double)A->m11 - (double)A->m00;
  const double divisor = twice == 0.0 ? 1.0 : twice;
  const double theta = apart / divisor;
  const double magnitude = fabs(theta);
  const double size = magnitude + sqrt(1.0 + KSL_MUL(theta, theta));
  const double along_a = -size, along = theta < 0.0 ? along_a : size;
  const double t_a = 1.0 / along, t = twice == 0.0 ? 0.0 : t_a;
  const double secant = sqrt(1.0 + KSL_MUL(t, t));
  const double c = 1.0 / secant;
  const double s = KSL_MUL(t, c);
  const double change = KSL_MUL((double)A->m10, t);
  const double zp = KSL_MUL((double)A->m20, c) - KSL_MUL((double)A->m21, s);
  const double zq = KSL_MUL((double)A->m20, s) + KSL_MUL((double)A->m21, c);
  const double vp_0 = KSL_MUL((double)V->m00, c) - KSL_MUL((double)V->m01, s),
      vp_1 = KSL_MUL((double)V->m10, c) - KSL_MUL((double)V->m11, s),
      vp_2 = KSL_MUL((double)V->m20, c) - KSL_MUL((double)V->m21, s);
  const double vq_0 = KSL_MUL((double)V->m00, s) + KSL_MUL((double)V->m01, c),
      vq_1 = KSL_MUL((double)V->m10, s) + KSL_MUL((double)V->m11, c),
      vq_2 = KSL_MUL((double)V->m20, s) + KSL_MUL((double)V->m21, c);
  const double A_00_new = (double)A->m11 + change, A_22_new = (double)A->m00 - change;
  const float A_m22 = A->m22;
  const float V_m02 = V->m02;
  const float V_m12 = V->m12;
  const float V_m22 = V->m22;
  A->m00 = (float)A_00_new;
  A->m01 = (float)zq;
  A->m02 = (float)0.0;
  A->m10 = (float)zq;
  A->m11 = A_m22;
  A->m12 = (float)zp;
  A->m20 = (float)0.0;
  A->m21 = (float)zp;
  A->m22 = (float)A_22_new;
  V->m00 = (float)vq_0;
  V->m01 = V_m02;
  V->m02 = (float)vp_0;
  V->m10 = (float)vq_1;
  V->m11 = V_m12;
  V->m12 = (float)vp_1;
  V->m20 = (float)vq_2;
  V->m21 = V_m22;
  V->m22 = (float)vp_2;
}

/* the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if an
     entry is NaN.
   R: rotation or other 3×3 matrix.
   27 mul, 21 add, 7 abs, 6 less, 6 select.
   Error <= 6 u near a rotation; measured, not proved. */
static inline float ksl_mat3x3f_rotation_defect_accurate(const ksl_mat3x3f_t *R) {
  const double n_0 = ksl_product_sum(-(double)R->m12, (double)R->m21, (double)R->m11
          * (double)R->m22),
      n_1 = ksl_product_sum(-(double)R->m01, (double)R->m22, (double)R->m02 * (double)R->m21),
      n_2 = ksl_product_sum(-(double)R->m02, (double)R->m11, (double)R->m01 * (double)R->m12);
  const double det = KSL_MUL((double)R->m00, n_0) + KSL_MUL((double)R->m10, n_1)
          + KSL_MUL((double)R->m20, n_2);
  const double g_0 = ksl_product_sum((double)R->m20, (double)R->m20, ksl_product_sum((double)R->m10,
      (double)R->m10, (double)R->m00 * (double)R->m00)),
      g_1 = ksl_product_sum((double)R->m20, (double)R->m21, ksl_product_sum((double)R->m10,
          (double)R->m11, (double)R->m00 * (double)R->m01)),
      g_2 = ksl_product_sum((double)R->m20, (double)R->m22, ksl_product_sum((double)R->m10,
          (double)R->m12, (double)R->m00 * (double)R->m02)),
      g_3 = ksl_product_sum((double)R->m21, (double)R->m21, ksl_product_sum((double)R->m11,
          (double)R->m11, (double)R->m01 * (double)R->m01)),
      g_4 = ksl_product_sum((double)R->m21, (double)R->m22, ksl_product_sum((double)R->m11,
          (double)R->m12, (double)R->m01 * (double)R->m02)),
      g_5 = ksl_product_sum((double)R->m22, (double)R->m22, ksl_product_sum((double)R->m12,
          (double)R->m12, (double)R->m02 * (double)R->m02));
  const double off_0 = det - 1.0, off_1 = g_0 - 1.0, off_4 = g_3 - 1.0, off_6 = g_5 - 1.0;
  const double defect_size_0 = fabs(off_0), defect_size_1 = fabs(off_1), defect_size_2 = fabs(g_1),
      defect_size_3 = fabs(g_2), defect_size_4 = fabs(off_4), defect_size_5 = fabs(g_4),
      defect_size_6 = fabs(off_6);
  const double defect_largest1 = defect_size_0 < defect_size_1 ? defect_size_1 : defect_size_0;
  const double defect_largest2 = defect_largest1 < defect_size_2 ? defect_size_2 : defect_largest1;
  const double defect_largest3 = defect_largest2 < defect_size_3 ? defect_size_3 : defect_largest2;
  const double defect_largest4 = defect_largest3 < defect_size_4 ? defect_size_4 : defect_largest3;
  const double defect_largest5 = defect_largest4 < defect_size_5 ? defect_size_5 : defect_largest4;
  const double defect_largest6 = defect_largest5 < defect_size_6 ? defect_size_6 : defect_largest5;
  return (float)defect_largest6;
}

/* R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
     not a rotation.
   axis: vector; angle: number; R: rotation or other 3×3 matrix.
   71 mul, 79 add, 2 abs, 1 less, 1 select.
   Error <= R: 1 u of its largest component for |axis| = 1; searched, not proved.  Each component
     is within 1 ulp as long as its condition is below 1e13; in single precision it is the
     nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_mat3x3f_from_axis_angle_accurate(const ksl_vec3f_t *axis,
    const float angle, ksl_mat3x3f_t *R) {
  const double half = 0.5 * (double)angle;
  const double h = ksl_sin(half);
  double cosine; const double sine = ksl_sincos((double)angle, &cosine);
  const double versine_b = KSL_MUL(2.0, KSL_MUL(h, h)), versine_c = 1.0 - cosine,
      versine = cosine < 0.0 ? versine_c : versine_b;
  const double beta_v_0 = KSL_MUL((double)axis->x, versine),
      beta_v_1 = KSL_MUL((double)axis->y, versine), beta_v_2 = KSL_MUL((double)axis->z, versine);
  const double m_0 = KSL_MUL((double)axis->x, beta_v_0), m_1 = KSL_MUL((double)axis->y, beta_v_1),
      m_2 = KSL_MUL((double)axis->z, beta_v_2), m_3 = KSL_MUL((double)axis->y, beta_v_0),
      m_4 = KSL_MUL((double)axis->z, beta_v_0), m_5 = KSL_MUL((double)axis->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double alpha_v_0 = KSL_MUL((double)axis->x, sine),
      alpha_v_1 = KSL_MUL((double)axis->y, sine), alpha_v_2 = KSL_MUL((double)axis->z, sine);
  const double R_00 = 1.0 - others_0, R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1,
      R_10 = m_3 + alpha_v_2, R_11 = 1.0 - others_1, R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1,
      R_21 = m_5 + alpha_v_0, R_22 = 1.0 - others_2;
  R->m00 = (float)R_00;
  R->m01 = (float)R_01;
  R->m02 = (float)R_02;
  R->m10 = (float)R_10;
  R->m11 = (float)R_11;
  R->m12 = (float)R_12;
  R->m20 = (float)R_20;
  R->m21 = (float)R_21;
  R->m22 = (float)R_22;
}

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.
   R: rotation or other 3×3 matrix; axis: vector.
   37 mul, 51 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 40 select.
   Error <= angle: 1 u, axis: 1 u of its largest component for R a rotation; searched, not
     proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single
     precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline float ksl_axis_angle_from_mat3x3f_accurate(const ksl_mat3x3f_t *R,
    ksl_vec3f_t *axis) {
  const double p_0 = (double)R->m21 - (double)R->m12, p_1 = (double)R->m02 - (double)R->m20,
      p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21, s_1 = (double)R->m02 + (double)R->m20,
      s_2 = (double)R->m01 + (double)R->m10;
  const double first_0 = (double)R->m00 + 1.0, first_1 = 1.0 - (double)R->m00;
  const double others_0 = (double)R->m11 + (double)R->m22,
      others_1 = (double)R->m11 - (double)R->m22;
  const double d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const double low_0 = (double)R->m11 < (double)R->m00 ? d_1 : s_2,
      low_1 = (double)R->m11 < (double)R->m00 ? s_2 : d_2,
      low_2 = (double)R->m11 < (double)R->m00 ? s_1 : s_0,
      low_3 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = (double)R->m00 < high_0a ? s_0 : p_1,
      high_2 = (double)R->m00 < high_0a ? d_3 : p_2, high_3 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0,
      column_1 = (double)R->m22 < 0.0 ? low_1 : high_1,
      column_2 = (double)R->m22 < 0.0 ? low_2 : high_2,
      column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : v_s_b,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r_d = 1.0 < v_s ? 5.551115123125783e-17 : v_r_b,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = v_n == 0.0 ? 1.0 : v_n;
  const double unit_0 = v_y_0 / divisor, unit_1 = v_y_1 / divisor, unit_2 = v_y_2 / divisor;
  const double angle = KSL_MUL(2.0, half);
  const double axis_0 = v_n == 0.0 ? 1.0 : unit_0;
  axis->x = (float)axis_0;
  axis->y = (float)unit_1;
  axis->z = (float)unit_2;
  return (float)angle;
}

#endif
