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
  const double ww_0 = KSL_MUL(w->x, w->x);
  const double ww_1 = KSL_MUL(w->y, w->y);
  const double ww_2 = KSL_MUL(w->z, w->z);
  const double ww_3 = KSL_MUL(w->x, w->y);
  const double ww_4 = KSL_MUL(w->x, w->z);
  const double ww_5 = KSL_MUL(w->y, w->z);
  const double Ro_00a = ww_1 + ww_2, Ro_00a_right = Ro_00a - ww_1,
      Ro_00a_left = Ro_00a - Ro_00a_right,
      Ro_00a_left_rest = ksl_product_rest(w->y, w->y, ww_1, Ro_00a_left),
      Ro_00a_right_rest = ksl_product_rest(w->z, w->z, ww_2, Ro_00a_right),
      Ro_00a_lo = Ro_00a_left_rest + Ro_00a_right_rest, Ro_00 = -Ro_00a, Ro_00_lo = -Ro_00a_lo;
  const double Ro_01 = ww_3 - dw->z, Ro_01_right = ww_3 - Ro_01, Ro_01_left = Ro_01 + Ro_01_right,
      Ro_01_left_rest = ksl_product_rest(w->x, w->y, ww_3, Ro_01_left),
      Ro_01_right_rest = dw->z - Ro_01_right, Ro_01_lo = Ro_01_left_rest - Ro_01_right_rest;
  const double Ro_02 = dw->y + ww_4, Ro_02_right = Ro_02 - dw->y, Ro_02_left = Ro_02 - Ro_02_right,
      Ro_02_left_rest = dw->y - Ro_02_left,
      Ro_02_right_rest = ksl_product_rest(w->x, w->z, ww_4, Ro_02_right),
      Ro_02_lo = Ro_02_left_rest + Ro_02_right_rest;
  const double Ro_10 = dw->z + ww_3, Ro_10_right = Ro_10 - dw->z, Ro_10_left = Ro_10 - Ro_10_right,
      Ro_10_left_rest = dw->z - Ro_10_left,
      Ro_10_right_rest = ksl_product_rest(w->x, w->y, ww_3, Ro_10_right),
      Ro_10_lo = Ro_10_left_rest + Ro_10_right_rest;
  const double Ro_11a = ww_0 + ww_2, Ro_11a_right = Ro_11a - ww_0,
      Ro_11a_left = Ro_11a - Ro_11a_right,
      Ro_11a_left_rest = ksl_product_rest(w->x, w->x, ww_0, Ro_11a_left),
      Ro_11a_right_rest = ksl_product_rest(w->z, w->z, ww_2, Ro_11a_right),
      Ro_11a_lo = Ro_11a_left_rest + Ro_11a_right_rest, Ro_11 = -Ro_11a, Ro_11_lo = -Ro_11a_lo;
  const double Ro_12 = ww_5 - dw->x, Ro_12_right = ww_5 - Ro_12, Ro_12_left = Ro_12 + Ro_12_right,
      Ro_12_left_rest = ksl_product_rest(w->y, w->z, ww_5, Ro_12_left),
      Ro_12_right_rest = dw->x - Ro_12_right, Ro_12_lo = Ro_12_left_rest - Ro_12_right_rest;
  const double Ro_20 = ww_4 - dw->y, Ro_20_right = ww_4 - Ro_20, Ro_20_left = Ro_20 + Ro_20_right,
      Ro_20_left_rest = ksl_product_rest(w->x, w->z, ww_4, Ro_20_left),
      Ro_20_right_rest = dw->y - Ro_20_right, Ro_20_lo = Ro_20_left_rest - Ro_20_right_rest;
  const double Ro_21 = dw->x + ww_5, Ro_21_right = Ro_21 - dw->x, Ro_21_left = Ro_21 - Ro_21_right,
      Ro_21_left_rest = dw->x - Ro_21_left,
      Ro_21_right_rest = ksl_product_rest(w->y, w->z, ww_5, Ro_21_right),
      Ro_21_lo = Ro_21_left_rest + Ro_21_right_rest;
  const double Ro_22a = ww_0 + ww_1, Ro_22a_right = Ro_22a - ww_0,
      Ro_22a_left = Ro_22a - Ro_22a_right,
      Ro_22a_left_rest = ksl_product_rest(w->x, w->x, ww_0, Ro_22a_left),
      Ro_22a_right_rest = ksl_product_rest(w->y, w->y, ww_1, Ro_22a_right),
      Ro_22a_lo = Ro_22a_left_rest + Ro_22a_right_rest, Ro_22 = -Ro_22a, Ro_22_lo = -Ro_22a_lo;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo;
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
      n_0_right = n_0a - n_0, n_0_left = n_0 + n_0_right,
      n_0_left_rest = ksl_product_rest(R->m11, R->m22, n_0a, n_0_left),
      n_0_right_rest = ksl_product_rest(R->m12, R->m21, n_0b, n_0_right),
      n_0_lo = n_0_left_rest - n_0_right_rest;
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1b = KSL_MUL(R->m01, R->m22), n_1 = n_1a - n_1b,
      n_1_right = n_1a - n_1, n_1_left = n_1 + n_1_right,
      n_1_left_rest = ksl_product_rest(R->m02, R->m21, n_1a, n_1_left),
      n_1_right_rest = ksl_product_rest(R->m01, R->m22, n_1b, n_1_right),
      n_1_lo = n_1_left_rest - n_1_right_rest;
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2b = KSL_MUL(R->m02, R->m11), n_2 = n_2a - n_2b,
      n_2_right = n_2a - n_2, n_2_left = n_2 + n_2_right,
      n_2_left_rest = ksl_product_rest(R->m01, R->m12, n_2a, n_2_left),
      n_2_right_rest = ksl_product_rest(R->m02, R->m11, n_2b, n_2_right),
      n_2_lo = n_2_left_rest - n_2_right_rest;
  const double det_a = KSL_MUL(R->m00, n_0), det_a_cross2 = KSL_MUL(R->m00, n_0_lo),
      det_b = KSL_MUL(R->m10, n_1), det_b_cross2 = KSL_MUL(R->m10, n_1_lo), det_c = det_a + det_b,
      det_c_right = det_c - det_a, det_c_left = det_c - det_c_right,
      det_c_left_rest = ksl_product_rest(R->m00, n_0, det_a, det_c_left),
      det_c_right_rest = ksl_product_rest(R->m10, n_1, det_b, det_c_right),
      det_c_cross = det_a_cross2 + det_b_cross2, det_c_lo1 = det_c_left_rest + det_c_right_rest,
      det_c_lo = det_c_lo1 + det_c_cross, det_d = KSL_MUL(R->m20, n_2),
      det_d_cross2 = KSL_MUL(R->m20, n_2_lo), det = det_c + det_d, det_right = det - det_c,
      det_left = det - det_right, det_left_rest = det_c - det_left,
      det_right_rest = ksl_product_rest(R->m20, n_2, det_d, det_right),
      det_lo1 = det_left_rest + det_right_rest, det_lo2 = det_lo1 + det_d_cross2,
      det_lo = det_lo2 + det_c_lo;
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
  const double R_size_0 = fabs(R->m00);
  const double R_size_1 = fabs(R->m01);
  const double R_size_2 = fabs(R->m02);
  const double R_size_3 = fabs(R->m10);
  const double R_size_4 = fabs(R->m11);
  const double R_size_5 = fabs(R->m12);
  const double R_size_6 = fabs(R->m20);
  const double R_size_7 = fabs(R->m21);
  const double R_size_8 = fabs(R->m22);
  const double R_largest1 = R_size_0 < R_size_1 ? R_size_1 : R_size_0;
  const double R_largest2 = R_largest1 < R_size_2 ? R_size_2 : R_largest1;
  const double R_largest3 = R_largest2 < R_size_3 ? R_size_3 : R_largest2;
  const double R_largest4 = R_largest3 < R_size_4 ? R_size_4 : R_largest3;
  const double R_largest5 = R_largest4 < R_size_5 ? R_size_5 : R_largest4;
  const double R_largest6 = R_largest5 < R_size_6 ? R_size_6 : R_largest5;
  const double R_largest7 = R_largest6 < R_size_7 ? R_size_7 : R_largest6;
  const double R_largest8 = R_largest7 < R_size_8 ? R_size_8 : R_largest7;
  const double s_b = R_largest8 < 8.452712498170644e+270 ? 2.409919865102884e-181 :
      1.1830521861667747e-271,
      s_d = R_largest8 < 4.149515568880993e+180 ? 4.909093465297727e-91 : s_b,
      s_f = R_largest8 < 2.037035976334486e+90 ? 1.0 : s_d,
      s_h = R_largest8 < 1.0 ? 2.037035976334486e+90 : s_f,
      s_j = R_largest8 < 4.909093465297727e-91 ? 4.149515568880993e+180 : s_h,
      s = R_largest8 < 2.409919865102884e-181 ? 8.452712498170644e+270 : s_j;
  const double A_0 = KSL_MUL(R->m00, s);
  const double A_1 = KSL_MUL(R->m01, s);
  const double A_2 = KSL_MUL(R->m02, s);
  const double A_3 = KSL_MUL(R->m10, s);
  const double A_4 = KSL_MUL(R->m11, s);
  const double A_5 = KSL_MUL(R->m12, s);
  const double A_6 = KSL_MUL(R->m20, s);
  const double A_7 = KSL_MUL(R->m21, s);
  const double A_8 = KSL_MUL(R->m22, s);
  const double n0_0a = KSL_MUL(A_4, A_8), n0_0b = KSL_MUL(A_5, A_7), n0_0 = n0_0a - n0_0b,
      n0_0_right = n0_0a - n0_0, n0_0_left = n0_0 + n0_0_right,
      n0_0_left_rest = ksl_product_rest(A_4, A_8, n0_0a, n0_0_left),
      n0_0_right_rest = ksl_product_rest(A_5, A_7, n0_0b, n0_0_right),
      n0_0_lo = n0_0_left_rest - n0_0_right_rest;
  const double n0_1a = KSL_MUL(A_2, A_7), n0_1b = KSL_MUL(A_1, A_8), n0_1 = n0_1a - n0_1b,
      n0_1_right = n0_1a - n0_1, n0_1_left = n0_1 + n0_1_right,
      n0_1_left_rest = ksl_product_rest(A_2, A_7, n0_1a, n0_1_left),
      n0_1_right_rest = ksl_product_rest(A_1, A_8, n0_1b, n0_1_right),
      n0_1_lo = n0_1_left_rest - n0_1_right_rest;
  const double n0_2a = KSL_MUL(A_1, A_5), n0_2b = KSL_MUL(A_2, A_4), n0_2 = n0_2a - n0_2b,
      n0_2_right = n0_2a - n0_2, n0_2_left = n0_2 + n0_2_right,
      n0_2_left_rest = ksl_product_rest(A_1, A_5, n0_2a, n0_2_left),
      n0_2_right_rest = ksl_product_rest(A_2, A_4, n0_2b, n0_2_right),
      n0_2_lo = n0_2_left_rest - n0_2_right_rest;
  const double n1_0a = KSL_MUL(A_5, A_6), n1_0b = KSL_MUL(A_3, A_8), n1_0 = n1_0a - n1_0b,
      n1_0_right = n1_0a - n1_0, n1_0_left = n1_0 + n1_0_right,
      n1_0_left_rest = ksl_product_rest(A_5, A_6, n1_0a, n1_0_left),
      n1_0_right_rest = ksl_product_rest(A_3, A_8, n1_0b, n1_0_right),
      n1_0_lo = n1_0_left_rest - n1_0_right_rest;
  const double n1_1a = KSL_MUL(A_0, A_8), n1_1b = KSL_MUL(A_2, A_6), n1_1 = n1_1a - n1_1b,
      n1_1_right = n1_1a - n1_1, n1_1_left = n1_1 + n1_1_right,
      n1_1_left_rest = ksl_product_rest(A_0, A_8, n1_1a, n1_1_left),
      n1_1_right_rest = ksl_product_rest(A_2, A_6, n1_1b, n1_1_right),
      n1_1_lo = n1_1_left_rest - n1_1_right_rest;
  const double n1_2a = KSL_MUL(A_2, A_3), n1_2b = KSL_MUL(A_0, A_5), n1_2 = n1_2a - n1_2b,
      n1_2_right = n1_2a - n1_2, n1_2_left = n1_2 + n1_2_right,
      n1_2_left_rest = ksl_product_rest(A_2, A_3, n1_2a, n1_2_left),
      n1_2_right_rest = ksl_product_rest(A_0, A_5, n1_2b, n1_2_right),
      n1_2_lo = n1_2_left_rest - n1_2_right_rest;
  const double n2_0a = KSL_MUL(A_3, A_7), n2_0b = KSL_MUL(A_4, A_6), n2_0 = n2_0a - n2_0b,
      n2_0_right = n2_0a - n2_0, n2_0_left = n2_0 + n2_0_right,
      n2_0_left_rest = ksl_product_rest(A_3, A_7, n2_0a, n2_0_left),
      n2_0_right_rest = ksl_product_rest(A_4, A_6, n2_0b, n2_0_right),
      n2_0_lo = n2_0_left_rest - n2_0_right_rest;
  const double n2_1a = KSL_MUL(A_1, A_6), n2_1b = KSL_MUL(A_0, A_7), n2_1 = n2_1a - n2_1b,
      n2_1_right = n2_1a - n2_1, n2_1_left = n2_1 + n2_1_right,
      n2_1_left_rest = ksl_product_rest(A_1, A_6, n2_1a, n2_1_left),
      n2_1_right_rest = ksl_product_rest(A_0, A_7, n2_1b, n2_1_right),
      n2_1_lo = n2_1_left_rest - n2_1_right_rest;
  const double n2_2a = KSL_MUL(A_0, A_4), n2_2b = KSL_MUL(A_1, A_3), n2_2 = n2_2a - n2_2b,
      n2_2_right = n2_2a - n2_2, n2_2_left = n2_2 + n2_2_right,
      n2_2_left_rest = ksl_product_rest(A_0, A_4, n2_2a, n2_2_left),
      n2_2_right_rest = ksl_product_rest(A_1, A_3, n2_2b, n2_2_right),
      n2_2_lo = n2_2_left_rest - n2_2_right_rest;
  const double d_a = KSL_MUL(A_0, n0_0), d_a_cross2 = KSL_MUL(A_0, n0_0_lo),
      d_b = KSL_MUL(A_3, n0_1), d_b_cross2 = KSL_MUL(A_3, n0_1_lo), d_c = d_a + d_b,
      d_c_right = d_c - d_a, d_c_left = d_c - d_c_right,
      d_c_left_rest = ksl_product_rest(A_0, n0_0, d_a, d_c_left),
      d_c_right_rest = ksl_product_rest(A_3, n0_1, d_b, d_c_right),
      d_c_cross = d_a_cross2 + d_b_cross2, d_c_lo1 = d_c_left_rest + d_c_right_rest,
      d_c_lo = d_c_lo1 + d_c_cross, d_d = KSL_MUL(A_6, n0_2), d_d_cross2 = KSL_MUL(A_6, n0_2_lo),
      d = d_c + d_d, d_right = d - d_c, d_left = d - d_right, d_left_rest = d_c - d_left,
      d_right_rest = ksl_product_rest(A_6, n0_2, d_d, d_right), d_lo1 = d_left_rest + d_right_rest,
      d_lo2 = d_lo1 + d_d_cross2, d_lo = d_lo2 + d_c_lo;
  const double size0_0 = fabs(A_0);
  const double size0_1 = fabs(A_3);
  const double size0_2 = fabs(A_6);
  const double size1_0 = fabs(A_1);
  const double size1_1 = fabs(A_4);
  const double size1_2 = fabs(A_7);
  const double size2_0 = fabs(A_2);
  const double size2_1 = fabs(A_5);
  const double size2_2 = fabs(A_8);
  const double permanent_a = KSL_MUL(size1_1, size2_2), permanent_b = KSL_MUL(size1_2, size2_1),
      permanent_c = permanent_a + permanent_b, permanent_c_right = permanent_c - permanent_a,
      permanent_c_left = permanent_c - permanent_c_right,
      permanent_c_left_rest = ksl_product_rest(size1_1, size2_2, permanent_a, permanent_c_left),
      permanent_c_right_rest = ksl_product_rest(size1_2, size2_1, permanent_b, permanent_c_right),
      permanent_c_lo = permanent_c_left_rest + permanent_c_right_rest,
      permanent_d = KSL_MUL(size0_0, permanent_c),
      permanent_d_cross2 = KSL_MUL(size0_0, permanent_c_lo),
      permanent_e = KSL_MUL(size1_0, size2_2), permanent_f = KSL_MUL(size1_2, size2_0),
      permanent_g = permanent_e + permanent_f, permanent_g_right = permanent_g - permanent_e,
      permanent_g_left = permanent_g - permanent_g_right,
      permanent_g_left_rest = ksl_product_rest(size1_0, size2_2, permanent_e, permanent_g_left),
      permanent_g_right_rest = ksl_product_rest(size1_2, size2_0, permanent_f, permanent_g_right),
      permanent_g_lo = permanent_g_left_rest + permanent_g_right_rest,
      permanent_h = KSL_MUL(size0_1, permanent_g),
      permanent_h_cross2 = KSL_MUL(size0_1, permanent_g_lo),
      permanent_i = permanent_d + permanent_h, permanent_i_right = permanent_i - permanent_d,
      permanent_i_left = permanent_i - permanent_i_right,
      permanent_i_left_rest = ksl_product_rest(size0_0, permanent_c, permanent_d, permanent_i_left),
      permanent_i_right_rest = ksl_product_rest(size0_1, permanent_g, permanent_h,
          permanent_i_right),
      permanent_i_cross = permanent_d_cross2 + permanent_h_cross2,
      permanent_i_lo1 = permanent_i_left_rest + permanent_i_right_rest,
      permanent_i_lo = permanent_i_lo1 + permanent_i_cross, permanent_j = KSL_MUL(size1_0, size2_1),
      permanent_k = KSL_MUL(size1_1, size2_0), permanent_l = permanent_j + permanent_k,
      permanent_l_right = permanent_l - permanent_j,
      permanent_l_left = permanent_l - permanent_l_right,
      permanent_l_left_rest = ksl_product_rest(size1_0, size2_1, permanent_j, permanent_l_left),
      permanent_l_right_rest = ksl_product_rest(size1_1, size2_0, permanent_k, permanent_l_right),
      permanent_l_lo = permanent_l_left_rest + permanent_l_right_rest,
      permanent_m = KSL_MUL(size0_2, permanent_l),
      permanent_m_cross2 = KSL_MUL(size0_2, permanent_l_lo), permanent = permanent_i + permanent_m,
      permanent_right = permanent - permanent_i, permanent_left = permanent - permanent_right,
      permanent_left_rest = permanent_i - permanent_left,
      permanent_right_rest = ksl_product_rest(size0_2, permanent_l, permanent_m, permanent_right),
      permanent_lo1 = permanent_left_rest + permanent_right_rest,
      permanent_lo2 = permanent_lo1 + permanent_m_cross2,
      permanent_lo = permanent_lo2 + permanent_i_lo;
  const double top = KSL_MUL(R_largest8, s);
  const double spoiled = KSL_MUL(top, 1.6489340850168661e-229);
  const double least_a = KSL_MUL(permanent, 8.881784197001252e-16),
      least_a_cross1 = KSL_MUL(permanent_lo, 8.881784197001252e-16), least_b = KSL_MUL(top, top),
      least_b_lo = ksl_product_error(top, top, least_b), least_c = KSL_MUL(spoiled, least_b),
      least_c_cross2 = KSL_MUL(spoiled, least_b_lo), least = least_a + least_c,
      least_right = least - least_a, least_left = least - least_right,
      least_left_rest = ksl_product_rest(permanent, 8.881784197001252e-16, least_a, least_left),
      least_right_rest = ksl_product_rest(spoiled, least_b, least_c, least_right),
      least_cross = least_a_cross1 + least_c_cross2, least_lo1 = least_left_rest + least_right_rest,
      least_lo = least_lo1 + least_cross;
  const double regular_a_of_d = d + d_lo, regular_a_of_d_right = regular_a_of_d - d,
      regular_a_of_d_left = regular_a_of_d - regular_a_of_d_right,
      regular_a_of_d_left_rest = d - regular_a_of_d_left,
      regular_a_of_d_right_rest = d_lo - regular_a_of_d_right,
      regular_a_of_d_lo = regular_a_of_d_left_rest + regular_a_of_d_right_rest,
      regular_a = fabs(regular_a_of_d), regular_a_opposite = -regular_a_of_d_lo,
      regular_a_lo = regular_a_of_d < 0.0 ? regular_a_opposite : regular_a_of_d_lo,
      regular_b_of_least = least + least_lo, regular_b_of_regular_a = regular_a + regular_a_lo,
      regular = regular_b_of_least < regular_b_of_regular_a ? 1.0 : 0.0;
  const double divisor = regular == 1.0 ? regular_a_of_d : 1.0,
      divisor_lo = regular == 1.0 ? regular_a_of_d_lo : 0.0;
  const double quotient_0_of_n0_0 = n0_0 + n0_0_lo,
      quotient_0_of_n0_0_right = quotient_0_of_n0_0 - n0_0,
      quotient_0_of_n0_0_left = quotient_0_of_n0_0 - quotient_0_of_n0_0_right,
      quotient_0_of_n0_0_left_rest = n0_0 - quotient_0_of_n0_0_left,
      quotient_0_of_n0_0_right_rest = n0_0_lo - quotient_0_of_n0_0_right,
      quotient_0_of_n0_0_lo = quotient_0_of_n0_0_left_rest + quotient_0_of_n0_0_right_rest,
      quotient_0_of_divisor = divisor + divisor_lo,
      quotient_0_of_divisor_right = quotient_0_of_divisor - divisor,
      quotient_0_of_divisor_left = quotient_0_of_divisor - quotient_0_of_divisor_right,
      quotient_0_of_divisor_left_rest = divisor - quotient_0_of_divisor_left,
      quotient_0_of_divisor_right_rest = divisor_lo - quotient_0_of_divisor_right,
      quotient_0_of_divisor_lo = quotient_0_of_divisor_left_rest + quotient_0_of_divisor_right_rest,
      quotient_0 = quotient_0_of_n0_0 / quotient_0_of_divisor,
      quotient_0_product = KSL_MUL(quotient_0, quotient_0_of_divisor),
      quotient_0_product_error = ksl_product_error(quotient_0, quotient_0_of_divisor,
          quotient_0_product),
      quotient_0_rest = quotient_0_of_n0_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_numerator = quotient_0_exact + quotient_0_of_n0_0_lo,
      quotient_0_cross = KSL_MUL(quotient_0, quotient_0_of_divisor_lo),
      quotient_0_residual = quotient_0_numerator - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / quotient_0_of_divisor;
  const double quotient_1_of_n0_1 = n0_1 + n0_1_lo,
      quotient_1_of_n0_1_right = quotient_1_of_n0_1 - n0_1,
      quotient_1_of_n0_1_left = quotient_1_of_n0_1 - quotient_1_of_n0_1_right,
      quotient_1_of_n0_1_left_rest = n0_1 - quotient_1_of_n0_1_left,
      quotient_1_of_n0_1_right_rest = n0_1_lo - quotient_1_of_n0_1_right,
      quotient_1_of_n0_1_lo = quotient_1_of_n0_1_left_rest + quotient_1_of_n0_1_right_rest,
      quotient_1 = quotient_1_of_n0_1 / quotient_0_of_divisor,
      quotient_1_product = KSL_MUL(quotient_1, quotient_0_of_divisor),
      quotient_1_product_error = ksl_product_error(quotient_1, quotient_0_of_divisor,
          quotient_1_product),
      quotient_1_rest = quotient_1_of_n0_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_numerator = quotient_1_exact + quotient_1_of_n0_1_lo,
      quotient_1_cross = KSL_MUL(quotient_1, quotient_0_of_divisor_lo),
      quotient_1_residual = quotient_1_numerator - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / quotient_0_of_divisor;
  const double quotient_2_of_n0_2 = n0_2 + n0_2_lo,
      quotient_2_of_n0_2_right = quotient_2_of_n0_2 - n0_2,
      quotient_2_of_n0_2_left = quotient_2_of_n0_2 - quotient_2_of_n0_2_right,
      quotient_2_of_n0_2_left_rest = n0_2 - quotient_2_of_n0_2_left,
      quotient_2_of_n0_2_right_rest = n0_2_lo - quotient_2_of_n0_2_right,
      quotient_2_of_n0_2_lo = quotient_2_of_n0_2_left_rest + quotient_2_of_n0_2_right_rest,
      quotient_2 = quotient_2_of_n0_2 / quotient_0_of_divisor,
      quotient_2_product = KSL_MUL(quotient_2, quotient_0_of_divisor),
      quotient_2_product_error = ksl_product_error(quotient_2, quotient_0_of_divisor,
          quotient_2_product),
      quotient_2_rest = quotient_2_of_n0_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_numerator = quotient_2_exact + quotient_2_of_n0_2_lo,
      quotient_2_cross = KSL_MUL(quotient_2, quotient_0_of_divisor_lo),
      quotient_2_residual = quotient_2_numerator - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / quotient_0_of_divisor;
  const double quotient_3_of_n1_0 = n1_0 + n1_0_lo,
      quotient_3_of_n1_0_right = quotient_3_of_n1_0 - n1_0,
      quotient_3_of_n1_0_left = quotient_3_of_n1_0 - quotient_3_of_n1_0_right,
      quotient_3_of_n1_0_left_rest = n1_0 - quotient_3_of_n1_0_left,
      quotient_3_of_n1_0_right_rest = n1_0_lo - quotient_3_of_n1_0_right,
      quotient_3_of_n1_0_lo = quotient_3_of_n1_0_left_rest + quotient_3_of_n1_0_right_rest,
      quotient_3 = quotient_3_of_n1_0 / quotient_0_of_divisor,
      quotient_3_product = KSL_MUL(quotient_3, quotient_0_of_divisor),
      quotient_3_product_error = ksl_product_error(quotient_3, quotient_0_of_divisor,
          quotient_3_product),
      quotient_3_rest = quotient_3_of_n1_0 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_numerator = quotient_3_exact + quotient_3_of_n1_0_lo,
      quotient_3_cross = KSL_MUL(quotient_3, quotient_0_of_divisor_lo),
      quotient_3_residual = quotient_3_numerator - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / quotient_0_of_divisor;
  const double quotient_4_of_n1_1 = n1_1 + n1_1_lo,
      quotient_4_of_n1_1_right = quotient_4_of_n1_1 - n1_1,
      quotient_4_of_n1_1_left = quotient_4_of_n1_1 - quotient_4_of_n1_1_right,
      quotient_4_of_n1_1_left_rest = n1_1 - quotient_4_of_n1_1_left,
      quotient_4_of_n1_1_right_rest = n1_1_lo - quotient_4_of_n1_1_right,
      quotient_4_of_n1_1_lo = quotient_4_of_n1_1_left_rest + quotient_4_of_n1_1_right_rest,
      quotient_4 = quotient_4_of_n1_1 / quotient_0_of_divisor,
      quotient_4_product = KSL_MUL(quotient_4, quotient_0_of_divisor),
      quotient_4_product_error = ksl_product_error(quotient_4, quotient_0_of_divisor,
          quotient_4_product),
      quotient_4_rest = quotient_4_of_n1_1 - quotient_4_product,
      quotient_4_exact = quotient_4_rest - quotient_4_product_error,
      quotient_4_numerator = quotient_4_exact + quotient_4_of_n1_1_lo,
      quotient_4_cross = KSL_MUL(quotient_4, quotient_0_of_divisor_lo),
      quotient_4_residual = quotient_4_numerator - quotient_4_cross,
      quotient_4_lo = quotient_4_residual / quotient_0_of_divisor;
  const double quotient_5_of_n1_2 = n1_2 + n1_2_lo,
      quotient_5_of_n1_2_right = quotient_5_of_n1_2 - n1_2,
      quotient_5_of_n1_2_left = quotient_5_of_n1_2 - quotient_5_of_n1_2_right,
      quotient_5_of_n1_2_left_rest = n1_2 - quotient_5_of_n1_2_left,
      quotient_5_of_n1_2_right_rest = n1_2_lo - quotient_5_of_n1_2_right,
      quotient_5_of_n1_2_lo = quotient_5_of_n1_2_left_rest + quotient_5_of_n1_2_right_rest,
      quotient_5 = quotient_5_of_n1_2 / quotient_0_of_divisor,
      quotient_5_product = KSL_MUL(quotient_5, quotient_0_of_divisor),
      quotient_5_product_error = ksl_product_error(quotient_5, quotient_0_of_divisor,
          quotient_5_product),
      quotient_5_rest = quotient_5_of_n1_2 - quotient_5_product,
      quotient_5_exact = quotient_5_rest - quotient_5_product_error,
      quotient_5_numerator = quotient_5_exact + quotient_5_of_n1_2_lo,
      quotient_5_cross = KSL_MUL(quotient_5, quotient_0_of_divisor_lo),
      quotient_5_residual = quotient_5_numerator - quotient_5_cross,
      quotient_5_lo = quotient_5_residual / quotient_0_of_divisor;
  const double quotient_6_of_n2_0 = n2_0 + n2_0_lo,
      quotient_6_of_n2_0_right = quotient_6_of_n2_0 - n2_0,
      quotient_6_of_n2_0_left = quotient_6_of_n2_0 - quotient_6_of_n2_0_right,
      quotient_6_of_n2_0_left_rest = n2_0 - quotient_6_of_n2_0_left,
      quotient_6_of_n2_0_right_rest = n2_0_lo - quotient_6_of_n2_0_right,
      quotient_6_of_n2_0_lo = quotient_6_of_n2_0_left_rest + quotient_6_of_n2_0_right_rest,
      quotient_6 = quotient_6_of_n2_0 / quotient_0_of_divisor,
      quotient_6_product = KSL_MUL(quotient_6, quotient_0_of_divisor),
      quotient_6_product_error = ksl_product_error(quotient_6, quotient_0_of_divisor,
          quotient_6_product),
      quotient_6_rest = quotient_6_of_n2_0 - quotient_6_product,
      quotient_6_exact = quotient_6_rest - quotient_6_product_error,
      quotient_6_numerator = quotient_6_exact + quotient_6_of_n2_0_lo,
      quotient_6_cross = KSL_MUL(quotient_6, quotient_0_of_divisor_lo),
      quotient_6_residual = quotient_6_numerator - quotient_6_cross,
      quotient_6_lo = quotient_6_residual / quotient_0_of_divisor;
  const double quotient_7_of_n2_1 = n2_1 + n2_1_lo,
      quotient_7_of_n2_1_right = quotient_7_of_n2_1 - n2_1,
      quotient_7_of_n2_1_left = quotient_7_of_n2_1 - quotient_7_of_n2_1_right,
      quotient_7_of_n2_1_left_rest = n2_1 - quotient_7_of_n2_1_left,
      quotient_7_of_n2_1_right_rest = n2_1_lo - quotient_7_of_n2_1_right,
      quotient_7_of_n2_1_lo = quotient_7_of_n2_1_left_rest + quotient_7_of_n2_1_right_rest,
      quotient_7 = quotient_7_of_n2_1 / quotient_0_of_divisor,
      quotient_7_product = KSL_MUL(quotient_7, quotient_0_of_divisor),
      quotient_7_product_error = ksl_product_error(quotient_7, quotient_0_of_divisor,
          quotient_7_product),
      quotient_7_rest = quotient_7_of_n2_1 - quotient_7_product,
      quotient_7_exact = quotient_7_rest - quotient_7_product_error,
      quotient_7_numerator = quotient_7_exact + quotient_7_of_n2_1_lo,
      quotient_7_cross = KSL_MUL(quotient_7, quotient_0_of_divisor_lo),
      quotient_7_residual = quotient_7_numerator - quotient_7_cross,
      quotient_7_lo = quotient_7_residual / quotient_0_of_divisor;
  const double quotient_8_of_n2_2 = n2_2 + n2_2_lo,
      quotient_8_of_n2_2_right = quotient_8_of_n2_2 - n2_2,
      quotient_8_of_n2_2_left = quotient_8_of_n2_2 - quotient_8_of_n2_2_right,
      quotient_8_of_n2_2_left_rest = n2_2 - quotient_8_of_n2_2_left,
      quotient_8_of_n2_2_right_rest = n2_2_lo - quotient_8_of_n2_2_right,
      quotient_8_of_n2_2_lo = quotient_8_of_n2_2_left_rest + quotient_8_of_n2_2_right_rest,
      quotient_8 = quotient_8_of_n2_2 / quotient_0_of_divisor,
      quotient_8_product = KSL_MUL(quotient_8, quotient_0_of_divisor),
      quotient_8_product_error = ksl_product_error(quotient_8, quotient_0_of_divisor,
          quotient_8_product),
      quotient_8_rest = quotient_8_of_n2_2 - quotient_8_product,
      quotient_8_exact = quotient_8_rest - quotient_8_product_error,
      quotient_8_numerator = quotient_8_exact + quotient_8_of_n2_2_lo,
      quotient_8_cross = KSL_MUL(quotient_8, quotient_0_of_divisor_lo),
      quotient_8_residual = quotient_8_numerator - quotient_8_cross,
      quotient_8_lo = quotient_8_residual / quotient_0_of_divisor;
  const double inverse_0_of_quotient_0 = quotient_0 + quotient_0_lo,
      inverse_0_of_quotient_0_right = inverse_0_of_quotient_0 - quotient_0,
      inverse_0_of_quotient_0_left = inverse_0_of_quotient_0 - inverse_0_of_quotient_0_right,
      inverse_0_of_quotient_0_left_rest = quotient_0 - inverse_0_of_quotient_0_left,
      inverse_0_of_quotient_0_right_rest = quotient_0_lo - inverse_0_of_quotient_0_right,
      inverse_0_of_quotient_0_lo = inverse_0_of_quotient_0_left_rest +
          inverse_0_of_quotient_0_right_rest,
      inverse_0 = KSL_MUL(inverse_0_of_quotient_0, s), inverse_0_inverse = 1.0 / s,
      inverse_0_back = KSL_MUL(inverse_0, inverse_0_inverse),
      inverse_0_lost = inverse_0_of_quotient_0 - inverse_0_back,
      inverse_0_rest = inverse_0_lost + inverse_0_of_quotient_0_lo,
      inverse_0_lo = KSL_MUL(inverse_0_rest, s);
  const double inverse_1_of_quotient_1 = quotient_1 + quotient_1_lo,
      inverse_1_of_quotient_1_right = inverse_1_of_quotient_1 - quotient_1,
      inverse_1_of_quotient_1_left = inverse_1_of_quotient_1 - inverse_1_of_quotient_1_right,
      inverse_1_of_quotient_1_left_rest = quotient_1 - inverse_1_of_quotient_1_left,
      inverse_1_of_quotient_1_right_rest = quotient_1_lo - inverse_1_of_quotient_1_right,
      inverse_1_of_quotient_1_lo = inverse_1_of_quotient_1_left_rest +
          inverse_1_of_quotient_1_right_rest,
      inverse_1 = KSL_MUL(inverse_1_of_quotient_1, s),
      inverse_1_back = KSL_MUL(inverse_1, inverse_0_inverse),
      inverse_1_lost = inverse_1_of_quotient_1 - inverse_1_back,
      inverse_1_rest = inverse_1_lost + inverse_1_of_quotient_1_lo,
      inverse_1_lo = KSL_MUL(inverse_1_rest, s);
  const double inverse_2_of_quotient_2 = quotient_2 + quotient_2_lo,
      inverse_2_of_quotient_2_right = inverse_2_of_quotient_2 - quotient_2,
      inverse_2_of_quotient_2_left = inverse_2_of_quotient_2 - inverse_2_of_quotient_2_right,
      inverse_2_of_quotient_2_left_rest = quotient_2 - inverse_2_of_quotient_2_left,
      inverse_2_of_quotient_2_right_rest = quotient_2_lo - inverse_2_of_quotient_2_right,
      inverse_2_of_quotient_2_lo = inverse_2_of_quotient_2_left_rest +
          inverse_2_of_quotient_2_right_rest,
      inverse_2 = KSL_MUL(inverse_2_of_quotient_2, s),
      inverse_2_back = KSL_MUL(inverse_2, inverse_0_inverse),
      inverse_2_lost = inverse_2_of_quotient_2 - inverse_2_back,
      inverse_2_rest = inverse_2_lost + inverse_2_of_quotient_2_lo,
      inverse_2_lo = KSL_MUL(inverse_2_rest, s);
  const double inverse_3_of_quotient_3 = quotient_3 + quotient_3_lo,
      inverse_3_of_quotient_3_right = inverse_3_of_quotient_3 - quotient_3,
      inverse_3_of_quotient_3_left = inverse_3_of_quotient_3 - inverse_3_of_quotient_3_right,
      inverse_3_of_quotient_3_left_rest = quotient_3 - inverse_3_of_quotient_3_left,
      inverse_3_of_quotient_3_right_rest = quotient_3_lo - inverse_3_of_quotient_3_right,
      inverse_3_of_quotient_3_lo = inverse_3_of_quotient_3_left_rest +
          inverse_3_of_quotient_3_right_rest,
      inverse_3 = KSL_MUL(inverse_3_of_quotient_3, s),
      inverse_3_back = KSL_MUL(inverse_3, inverse_0_inverse),
      inverse_3_lost = inverse_3_of_quotient_3 - inverse_3_back,
      inverse_3_rest = inverse_3_lost + inverse_3_of_quotient_3_lo,
      inverse_3_lo = KSL_MUL(inverse_3_rest, s);
  const double inverse_4_of_quotient_4 = quotient_4 + quotient_4_lo,
      inverse_4_of_quotient_4_right = inverse_4_of_quotient_4 - quotient_4,
      inverse_4_of_quotient_4_left = inverse_4_of_quotient_4 - inverse_4_of_quotient_4_right,
      inverse_4_of_quotient_4_left_rest = quotient_4 - inverse_4_of_quotient_4_left,
      inverse_4_of_quotient_4_right_rest = quotient_4_lo - inverse_4_of_quotient_4_right,
      inverse_4_of_quotient_4_lo = inverse_4_of_quotient_4_left_rest +
          inverse_4_of_quotient_4_right_rest,
      inverse_4 = KSL_MUL(inverse_4_of_quotient_4, s),
      inverse_4_back = KSL_MUL(inverse_4, inverse_0_inverse),
      inverse_4_lost = inverse_4_of_quotient_4 - inverse_4_back,
      inverse_4_rest = inverse_4_lost + inverse_4_of_quotient_4_lo,
      inverse_4_lo = KSL_MUL(inverse_4_rest, s);
  const double inverse_5_of_quotient_5 = quotient_5 + quotient_5_lo,
      inverse_5_of_quotient_5_right = inverse_5_of_quotient_5 - quotient_5,
      inverse_5_of_quotient_5_left = inverse_5_of_quotient_5 - inverse_5_of_quotient_5_right,
      inverse_5_of_quotient_5_left_rest = quotient_5 - inverse_5_of_quotient_5_left,
      inverse_5_of_quotient_5_right_rest = quotient_5_lo - inverse_5_of_quotient_5_right,
      inverse_5_of_quotient_5_lo = inverse_5_of_quotient_5_left_rest +
          inverse_5_of_quotient_5_right_rest,
      inverse_5 = KSL_MUL(inverse_5_of_quotient_5, s),
      inverse_5_back = KSL_MUL(inverse_5, inverse_0_inverse),
      inverse_5_lost = inverse_5_of_quotient_5 - inverse_5_back,
      inverse_5_rest = inverse_5_lost + inverse_5_of_quotient_5_lo,
      inverse_5_lo = KSL_MUL(inverse_5_rest, s);
  const double inverse_6_of_quotient_6 = quotient_6 + quotient_6_lo,
      inverse_6_of_quotient_6_right = inverse_6_of_quotient_6 - quotient_6,
      inverse_6_of_quotient_6_left = inverse_6_of_quotient_6 - inverse_6_of_quotient_6_right,
      inverse_6_of_quotient_6_left_rest = quotient_6 - inverse_6_of_quotient_6_left,
      inverse_6_of_quotient_6_right_rest = quotient_6_lo - inverse_6_of_quotient_6_right,
      inverse_6_of_quotient_6_lo = inverse_6_of_quotient_6_left_rest +
          inverse_6_of_quotient_6_right_rest,
      inverse_6 = KSL_MUL(inverse_6_of_quotient_6, s),
      inverse_6_back = KSL_MUL(inverse_6, inverse_0_inverse),
      inverse_6_lost = inverse_6_of_quotient_6 - inverse_6_back,
      inverse_6_rest = inverse_6_lost + inverse_6_of_quotient_6_lo,
      inverse_6_lo = KSL_MUL(inverse_6_rest, s);
  const double inverse_7_of_quotient_7 = quotient_7 + quotient_7_lo,
      inverse_7_of_quotient_7_right = inverse_7_of_quotient_7 - quotient_7,
      inverse_7_of_quotient_7_left = inverse_7_of_quotient_7 - inverse_7_of_quotient_7_right,
      inverse_7_of_quotient_7_left_rest = quotient_7 - inverse_7_of_quotient_7_left,
      inverse_7_of_quotient_7_right_rest = quotient_7_lo - inverse_7_of_quotient_7_right,
      inverse_7_of_quotient_7_lo = inverse_7_of_quotient_7_left_rest +
          inverse_7_of_quotient_7_right_rest,
      inverse_7 = KSL_MUL(inverse_7_of_quotient_7, s),
      inverse_7_back = KSL_MUL(inverse_7, inverse_0_inverse),
      inverse_7_lost = inverse_7_of_quotient_7 - inverse_7_back,
      inverse_7_rest = inverse_7_lost + inverse_7_of_quotient_7_lo,
      inverse_7_lo = KSL_MUL(inverse_7_rest, s);
  const double inverse_8_of_quotient_8 = quotient_8 + quotient_8_lo,
      inverse_8_of_quotient_8_right = inverse_8_of_quotient_8 - quotient_8,
      inverse_8_of_quotient_8_left = inverse_8_of_quotient_8 - inverse_8_of_quotient_8_right,
      inverse_8_of_quotient_8_left_rest = quotient_8 - inverse_8_of_quotient_8_left,
      inverse_8_of_quotient_8_right_rest = quotient_8_lo - inverse_8_of_quotient_8_right,
      inverse_8_of_quotient_8_lo = inverse_8_of_quotient_8_left_rest +
          inverse_8_of_quotient_8_right_rest,
      inverse_8 = KSL_MUL(inverse_8_of_quotient_8, s),
      inverse_8_back = KSL_MUL(inverse_8, inverse_0_inverse),
      inverse_8_lost = inverse_8_of_quotient_8 - inverse_8_back,
      inverse_8_rest = inverse_8_lost + inverse_8_of_quotient_8_lo,
      inverse_8_lo = KSL_MUL(inverse_8_rest, s);
  const double start_a = -8.452712498170644e+270,
      start_c = regular_a_of_d < 0.0 ? start_a : 8.452712498170644e+270,
      start = R_largest8 < 4.149515568880993e+180 ? regular_a_of_d : start_c,
      start_lo = R_largest8 < 4.149515568880993e+180 ? regular_a_of_d_lo : 0.0;
  const double r2 = R_largest8 < 4.909093465297727e-91 ? 1.1830521861667747e-271 : 1.0;
  const double once_of_start = start + start_lo, once_of_start_right = once_of_start - start,
      once_of_start_left = once_of_start - once_of_start_right,
      once_of_start_left_rest = start - once_of_start_left,
      once_of_start_right_rest = start_lo - once_of_start_right,
      once_of_start_lo = once_of_start_left_rest + once_of_start_right_rest,
      once = KSL_MUL(once_of_start, r2), once_inverse = 1.0 / r2,
      once_back = KSL_MUL(once, once_inverse), once_lost = once_of_start - once_back,
      once_rest = once_lost + once_of_start_lo, once_lo = KSL_MUL(once_rest, r2);
  const double r3 = R_largest8 < 2.409919865102884e-181 ? 1.1830521861667747e-271 : 1.0;
  const double twice_of_once = once + once_lo, twice_of_once_right = twice_of_once - once,
      twice_of_once_left = twice_of_once - twice_of_once_right,
      twice_of_once_left_rest = once - twice_of_once_left,
      twice_of_once_right_rest = once_lo - twice_of_once_right,
      twice_of_once_lo = twice_of_once_left_rest + twice_of_once_right_rest,
      twice = KSL_MUL(twice_of_once, r3), twice_inverse = 1.0 / r3,
      twice_back = KSL_MUL(twice, twice_inverse), twice_lost = twice_of_once - twice_back,
      twice_rest = twice_lost + twice_of_once_lo, twice_lo = KSL_MUL(twice_rest, r3);
  const double r_a = R_largest8 < 2.037035976334486e+90 ? 1.0 : 8.452712498170644e+270,
      r = R_largest8 < 1.0 ? 1.1830521861667747e-271 : r_a;
  const double det_R_of_twice = twice + twice_lo, det_R_of_twice_right = det_R_of_twice - twice,
      det_R_of_twice_left = det_R_of_twice - det_R_of_twice_right,
      det_R_of_twice_left_rest = twice - det_R_of_twice_left,
      det_R_of_twice_right_rest = twice_lo - det_R_of_twice_right,
      det_R_of_twice_lo = det_R_of_twice_left_rest + det_R_of_twice_right_rest,
      det_R = KSL_MUL(det_R_of_twice, r), det_R_inverse = 1.0 / r,
      det_R_back = KSL_MUL(det_R, det_R_inverse), det_R_lost = det_R_of_twice - det_R_back,
      det_R_rest = det_R_lost + det_R_of_twice_lo, det_R_lo = KSL_MUL(det_R_rest, r);
  const double det = regular == 1.0 ? det_R : 0.0, det_lo = regular == 1.0 ? det_R_lo : 0.0;
  const double Ro_00 = regular == 1.0 ? inverse_0 : (double)NAN,
      Ro_00_lo = regular == 1.0 ? inverse_0_lo : 0.0;
  const double Ro_01 = regular == 1.0 ? inverse_1 : (double)NAN,
      Ro_01_lo = regular == 1.0 ? inverse_1_lo : 0.0;
  const double Ro_02 = regular == 1.0 ? inverse_2 : (double)NAN,
      Ro_02_lo = regular == 1.0 ? inverse_2_lo : 0.0;
  const double Ro_10 = regular == 1.0 ? inverse_3 : (double)NAN,
      Ro_10_lo = regular == 1.0 ? inverse_3_lo : 0.0;
  const double Ro_11 = regular == 1.0 ? inverse_4 : (double)NAN,
      Ro_11_lo = regular == 1.0 ? inverse_4_lo : 0.0;
  const double Ro_12 = regular == 1.0 ? inverse_5 : (double)NAN,
      Ro_12_lo = regular == 1.0 ? inverse_5_lo : 0.0;
  const double Ro_20 = regular == 1.0 ? inverse_6 : (double)NAN,
      Ro_20_lo = regular == 1.0 ? inverse_6_lo : 0.0;
  const double Ro_21 = regular == 1.0 ? inverse_7 : (double)NAN,
      Ro_21_lo = regular == 1.0 ? inverse_7_lo : 0.0;
  const double Ro_22 = regular == 1.0 ? inverse_8 : (double)NAN,
      Ro_22_lo = regular == 1.0 ? inverse_8_lo : 0.0;
  const double det_rounded = det + det_lo,
      det_final = det_rounded == det_rounded ? det_rounded : det;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo,
      Ro_00_final = Ro_00_rounded == Ro_00_rounded ? Ro_00_rounded : Ro_00;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo,
      Ro_01_final = Ro_01_rounded == Ro_01_rounded ? Ro_01_rounded : Ro_01;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo,
      Ro_02_final = Ro_02_rounded == Ro_02_rounded ? Ro_02_rounded : Ro_02;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo,
      Ro_10_final = Ro_10_rounded == Ro_10_rounded ? Ro_10_rounded : Ro_10;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo,
      Ro_11_final = Ro_11_rounded == Ro_11_rounded ? Ro_11_rounded : Ro_11;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo,
      Ro_12_final = Ro_12_rounded == Ro_12_rounded ? Ro_12_rounded : Ro_12;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo,
      Ro_20_final = Ro_20_rounded == Ro_20_rounded ? Ro_20_rounded : Ro_20;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo,
      Ro_21_final = Ro_21_rounded == Ro_21_rounded ? Ro_21_rounded : Ro_21;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo,
      Ro_22_final = Ro_22_rounded == Ro_22_rounded ? Ro_22_rounded : Ro_22;
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
  const double q0_s_size_0 = fabs(self->m00);
  const double q0_s_size_1 = fabs(self->m01);
  const double q0_s_size_2 = fabs(self->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = KSL_MUL(self->m00, q0_s);
  const double q0_y_1 = KSL_MUL(self->m01, q0_s);
  const double q0_y_2 = KSL_MUL(self->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = KSL_MUL(q0_y_0, q0_y_0), q0_n_b = KSL_MUL(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_c_right = q0_n_c - q0_n_a, q0_n_c_left = q0_n_c - q0_n_c_right,
      q0_n_c_left_rest = ksl_product_rest(q0_y_0, q0_y_0, q0_n_a, q0_n_c_left),
      q0_n_c_right_rest = ksl_product_rest(q0_y_1, q0_y_1, q0_n_b, q0_n_c_right),
      q0_n_c_lo = q0_n_c_left_rest + q0_n_c_right_rest, q0_n_d = KSL_MUL(q0_y_2, q0_y_2),
      q0_n_e = q0_n_c + q0_n_d, q0_n_e_right = q0_n_e - q0_n_c, q0_n_e_left = q0_n_e - q0_n_e_right,
      q0_n_e_left_rest = q0_n_c - q0_n_e_left,
      q0_n_e_right_rest = ksl_product_rest(q0_y_2, q0_y_2, q0_n_d, q0_n_e_right),
      q0_n_e_lo1 = q0_n_e_left_rest + q0_n_e_right_rest, q0_n_e_lo = q0_n_e_lo1 + q0_n_c_lo,
      q0_n_of_q0_n_e = q0_n_e + q0_n_e_lo, q0_n_of_q0_n_e_right = q0_n_of_q0_n_e - q0_n_e,
      q0_n_of_q0_n_e_left = q0_n_of_q0_n_e - q0_n_of_q0_n_e_right,
      q0_n_of_q0_n_e_left_rest = q0_n_e - q0_n_of_q0_n_e_left,
      q0_n_of_q0_n_e_right_rest = q0_n_e_lo - q0_n_of_q0_n_e_right,
      q0_n_of_q0_n_e_lo = q0_n_of_q0_n_e_left_rest + q0_n_of_q0_n_e_right_rest,
      q0_n = sqrt(q0_n_of_q0_n_e), q0_n_product = KSL_MUL(q0_n, q0_n),
      q0_n_product_error = ksl_product_error(q0_n, q0_n, q0_n_product),
      q0_n_rest = q0_n_of_q0_n_e - q0_n_product, q0_n_exact = q0_n_rest - q0_n_product_error,
      q0_n_residual = q0_n_exact + q0_n_of_q0_n_e_lo, q0_n_twice = q0_n + q0_n,
      q0_n_divisor = q0_n == 0.0 ? 1.0 : q0_n_twice, q0_n_lo = q0_n_residual / q0_n_divisor;
  const double q0_divisor_a_of_q0_n = q0_n + q0_n_lo,
      q0_divisor_a_of_q0_n_right = q0_divisor_a_of_q0_n - q0_n,
      q0_divisor_a_of_q0_n_left = q0_divisor_a_of_q0_n - q0_divisor_a_of_q0_n_right,
      q0_divisor_a_of_q0_n_left_rest = q0_n - q0_divisor_a_of_q0_n_left,
      q0_divisor_a_of_q0_n_right_rest = q0_n_lo - q0_divisor_a_of_q0_n_right,
      q0_divisor_a_of_q0_n_lo = q0_divisor_a_of_q0_n_left_rest + q0_divisor_a_of_q0_n_right_rest,
      q0_divisor = q0_divisor_a_of_q0_n == 0.0 ? q0_up : q0_divisor_a_of_q0_n,
      q0_divisor_lo = q0_divisor_a_of_q0_n == 0.0 ? 0.0 : q0_divisor_a_of_q0_n_lo;
  const double q0_sized_0 = KSL_MUL(self->m00, q0_up);
  const double q0_sized_1 = KSL_MUL(self->m01, q0_up);
  const double q0_sized_2 = KSL_MUL(self->m02, q0_up);
  const double q0_quotient_0_of_q0_divisor = q0_divisor + q0_divisor_lo,
      q0_quotient_0_of_q0_divisor_right = q0_quotient_0_of_q0_divisor - q0_divisor,
      q0_quotient_0_of_q0_divisor_left = q0_quotient_0_of_q0_divisor -
          q0_quotient_0_of_q0_divisor_right,
      q0_quotient_0_of_q0_divisor_left_rest = q0_divisor - q0_quotient_0_of_q0_divisor_left,
      q0_quotient_0_of_q0_divisor_right_rest = q0_divisor_lo - q0_quotient_0_of_q0_divisor_right,
      q0_quotient_0_of_q0_divisor_lo = q0_quotient_0_of_q0_divisor_left_rest +
          q0_quotient_0_of_q0_divisor_right_rest,
      q0_quotient_0 = q0_sized_0 / q0_quotient_0_of_q0_divisor,
      q0_quotient_0_product = KSL_MUL(q0_quotient_0, q0_quotient_0_of_q0_divisor),
      q0_quotient_0_product_error = ksl_product_error(q0_quotient_0, q0_quotient_0_of_q0_divisor,
          q0_quotient_0_product),
      q0_quotient_0_rest = q0_sized_0 - q0_quotient_0_product,
      q0_quotient_0_exact = q0_quotient_0_rest - q0_quotient_0_product_error,
      q0_quotient_0_cross = KSL_MUL(q0_quotient_0, q0_quotient_0_of_q0_divisor_lo),
      q0_quotient_0_residual = q0_quotient_0_exact - q0_quotient_0_cross,
      q0_quotient_0_lo = q0_quotient_0_residual / q0_quotient_0_of_q0_divisor;
  const double q0_quotient_1 = q0_sized_1 / q0_quotient_0_of_q0_divisor,
      q0_quotient_1_product = KSL_MUL(q0_quotient_1, q0_quotient_0_of_q0_divisor),
      q0_quotient_1_product_error = ksl_product_error(q0_quotient_1, q0_quotient_0_of_q0_divisor,
          q0_quotient_1_product),
      q0_quotient_1_rest = q0_sized_1 - q0_quotient_1_product,
      q0_quotient_1_exact = q0_quotient_1_rest - q0_quotient_1_product_error,
      q0_quotient_1_cross = KSL_MUL(q0_quotient_1, q0_quotient_0_of_q0_divisor_lo),
      q0_quotient_1_residual = q0_quotient_1_exact - q0_quotient_1_cross,
      q0_quotient_1_lo = q0_quotient_1_residual / q0_quotient_0_of_q0_divisor;
  const double q0_quotient_2 = q0_sized_2 / q0_quotient_0_of_q0_divisor,
      q0_quotient_2_product = KSL_MUL(q0_quotient_2, q0_quotient_0_of_q0_divisor),
      q0_quotient_2_product_error = ksl_product_error(q0_quotient_2, q0_quotient_0_of_q0_divisor,
          q0_quotient_2_product),
      q0_quotient_2_rest = q0_sized_2 - q0_quotient_2_product,
      q0_quotient_2_exact = q0_quotient_2_rest - q0_quotient_2_product_error,
      q0_quotient_2_cross = KSL_MUL(q0_quotient_2, q0_quotient_0_of_q0_divisor_lo),
      q0_quotient_2_residual = q0_quotient_2_exact - q0_quotient_2_cross,
      q0_quotient_2_lo = q0_quotient_2_residual / q0_quotient_0_of_q0_divisor;
  const double q0_0_of_q0_quotient_0 = q0_quotient_0 + q0_quotient_0_lo,
      q0_0_of_q0_quotient_0_right = q0_0_of_q0_quotient_0 - q0_quotient_0,
      q0_0_of_q0_quotient_0_left = q0_0_of_q0_quotient_0 - q0_0_of_q0_quotient_0_right,
      q0_0_of_q0_quotient_0_left_rest = q0_quotient_0 - q0_0_of_q0_quotient_0_left,
      q0_0_of_q0_quotient_0_right_rest = q0_quotient_0_lo - q0_0_of_q0_quotient_0_right,
      q0_0_of_q0_quotient_0_lo = q0_0_of_q0_quotient_0_left_rest + q0_0_of_q0_quotient_0_right_rest,
      q0_0 = KSL_MUL(q0_0_of_q0_quotient_0, q0_down), q0_0_inverse = 1.0 / q0_down,
      q0_0_back = KSL_MUL(q0_0, q0_0_inverse), q0_0_lost = q0_0_of_q0_quotient_0 - q0_0_back,
      q0_0_rest = q0_0_lost + q0_0_of_q0_quotient_0_lo, q0_0_lo = KSL_MUL(q0_0_rest, q0_down);
  const double q0_1_of_q0_quotient_1 = q0_quotient_1 + q0_quotient_1_lo,
      q0_1_of_q0_quotient_1_right = q0_1_of_q0_quotient_1 - q0_quotient_1,
      q0_1_of_q0_quotient_1_left = q0_1_of_q0_quotient_1 - q0_1_of_q0_quotient_1_right,
      q0_1_of_q0_quotient_1_left_rest = q0_quotient_1 - q0_1_of_q0_quotient_1_left,
      q0_1_of_q0_quotient_1_right_rest = q0_quotient_1_lo - q0_1_of_q0_quotient_1_right,
      q0_1_of_q0_quotient_1_lo = q0_1_of_q0_quotient_1_left_rest + q0_1_of_q0_quotient_1_right_rest,
      q0_1 = KSL_MUL(q0_1_of_q0_quotient_1, q0_down), q0_1_back = KSL_MUL(q0_1, q0_0_inverse),
      q0_1_lost = q0_1_of_q0_quotient_1 - q0_1_back,
      q0_1_rest = q0_1_lost + q0_1_of_q0_quotient_1_lo, q0_1_lo = KSL_MUL(q0_1_rest, q0_down);
  const double q0_2_of_q0_quotient_2 = q0_quotient_2 + q0_quotient_2_lo,
      q0_2_of_q0_quotient_2_right = q0_2_of_q0_quotient_2 - q0_quotient_2,
      q0_2_of_q0_quotient_2_left = q0_2_of_q0_quotient_2 - q0_2_of_q0_quotient_2_right,
      q0_2_of_q0_quotient_2_left_rest = q0_quotient_2 - q0_2_of_q0_quotient_2_left,
      q0_2_of_q0_quotient_2_right_rest = q0_quotient_2_lo - q0_2_of_q0_quotient_2_right,
      q0_2_of_q0_quotient_2_lo = q0_2_of_q0_quotient_2_left_rest + q0_2_of_q0_quotient_2_right_rest,
      q0_2 = KSL_MUL(q0_2_of_q0_quotient_2, q0_down), q0_2_back = KSL_MUL(q0_2, q0_0_inverse),
      q0_2_lost = q0_2_of_q0_quotient_2 - q0_2_back,
      q0_2_rest = q0_2_lost + q0_2_of_q0_quotient_2_lo, q0_2_lo = KSL_MUL(q0_2_rest, q0_down);
  const double u1_s_size_0 = fabs(self->m10);
  const double u1_s_size_1 = fabs(self->m11);
  const double u1_s_size_2 = fabs(self->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = KSL_MUL(self->m10, u1_s);
  const double u1_y_1 = KSL_MUL(self->m11, u1_s);
  const double u1_y_2 = KSL_MUL(self->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = KSL_MUL(u1_y_0, u1_y_0), u1_n_b = KSL_MUL(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_c_right = u1_n_c - u1_n_a, u1_n_c_left = u1_n_c - u1_n_c_right,
      u1_n_c_left_rest = ksl_product_rest(u1_y_0, u1_y_0, u1_n_a, u1_n_c_left),
      u1_n_c_right_rest = ksl_product_rest(u1_y_1, u1_y_1, u1_n_b, u1_n_c_right),
      u1_n_c_lo = u1_n_c_left_rest + u1_n_c_right_rest, u1_n_d = KSL_MUL(u1_y_2, u1_y_2),
      u1_n_e = u1_n_c + u1_n_d, u1_n_e_right = u1_n_e - u1_n_c, u1_n_e_left = u1_n_e - u1_n_e_right,
      u1_n_e_left_rest = u1_n_c - u1_n_e_left,
      u1_n_e_right_rest = ksl_product_rest(u1_y_2, u1_y_2, u1_n_d, u1_n_e_right),
      u1_n_e_lo1 = u1_n_e_left_rest + u1_n_e_right_rest, u1_n_e_lo = u1_n_e_lo1 + u1_n_c_lo,
      u1_n_of_u1_n_e = u1_n_e + u1_n_e_lo, u1_n_of_u1_n_e_right = u1_n_of_u1_n_e - u1_n_e,
      u1_n_of_u1_n_e_left = u1_n_of_u1_n_e - u1_n_of_u1_n_e_right,
      u1_n_of_u1_n_e_left_rest = u1_n_e - u1_n_of_u1_n_e_left,
      u1_n_of_u1_n_e_right_rest = u1_n_e_lo - u1_n_of_u1_n_e_right,
      u1_n_of_u1_n_e_lo = u1_n_of_u1_n_e_left_rest + u1_n_of_u1_n_e_right_rest,
      u1_n = sqrt(u1_n_of_u1_n_e), u1_n_product = KSL_MUL(u1_n, u1_n),
      u1_n_product_error = ksl_product_error(u1_n, u1_n, u1_n_product),
      u1_n_rest = u1_n_of_u1_n_e - u1_n_product, u1_n_exact = u1_n_rest - u1_n_product_error,
      u1_n_residual = u1_n_exact + u1_n_of_u1_n_e_lo, u1_n_twice = u1_n + u1_n,
      u1_n_divisor = u1_n == 0.0 ? 1.0 : u1_n_twice, u1_n_lo = u1_n_residual / u1_n_divisor;
  const double u1_divisor_a_of_u1_n = u1_n + u1_n_lo,
      u1_divisor_a_of_u1_n_right = u1_divisor_a_of_u1_n - u1_n,
      u1_divisor_a_of_u1_n_left = u1_divisor_a_of_u1_n - u1_divisor_a_of_u1_n_right,
      u1_divisor_a_of_u1_n_left_rest = u1_n - u1_divisor_a_of_u1_n_left,
      u1_divisor_a_of_u1_n_right_rest = u1_n_lo - u1_divisor_a_of_u1_n_right,
      u1_divisor_a_of_u1_n_lo = u1_divisor_a_of_u1_n_left_rest + u1_divisor_a_of_u1_n_right_rest,
      u1_divisor = u1_divisor_a_of_u1_n == 0.0 ? u1_up : u1_divisor_a_of_u1_n,
      u1_divisor_lo = u1_divisor_a_of_u1_n == 0.0 ? 0.0 : u1_divisor_a_of_u1_n_lo;
  const double u1_sized_0 = KSL_MUL(self->m10, u1_up);
  const double u1_sized_1 = KSL_MUL(self->m11, u1_up);
  const double u1_sized_2 = KSL_MUL(self->m12, u1_up);
  const double u1_quotient_0_of_u1_divisor = u1_divisor + u1_divisor_lo,
      u1_quotient_0_of_u1_divisor_right = u1_quotient_0_of_u1_divisor - u1_divisor,
      u1_quotient_0_of_u1_divisor_left = u1_quotient_0_of_u1_divisor -
          u1_quotient_0_of_u1_divisor_right,
      u1_quotient_0_of_u1_divisor_left_rest = u1_divisor - u1_quotient_0_of_u1_divisor_left,
      u1_quotient_0_of_u1_divisor_right_rest = u1_divisor_lo - u1_quotient_0_of_u1_divisor_right,
      u1_quotient_0_of_u1_divisor_lo = u1_quotient_0_of_u1_divisor_left_rest +
          u1_quotient_0_of_u1_divisor_right_rest,
      u1_quotient_0 = u1_sized_0 / u1_quotient_0_of_u1_divisor,
      u1_quotient_0_product = KSL_MUL(u1_quotient_0, u1_quotient_0_of_u1_divisor),
      u1_quotient_0_product_error = ksl_product_error(u1_quotient_0, u1_quotient_0_of_u1_divisor,
          u1_quotient_0_product),
      u1_quotient_0_rest = u1_sized_0 - u1_quotient_0_product,
      u1_quotient_0_exact = u1_quotient_0_rest - u1_quotient_0_product_error,
      u1_quotient_0_cross = KSL_MUL(u1_quotient_0, u1_quotient_0_of_u1_divisor_lo),
      u1_quotient_0_residual = u1_quotient_0_exact - u1_quotient_0_cross,
      u1_quotient_0_lo = u1_quotient_0_residual / u1_quotient_0_of_u1_divisor;
  const double u1_quotient_1 = u1_sized_1 / u1_quotient_0_of_u1_divisor,
      u1_quotient_1_product = KSL_MUL(u1_quotient_1, u1_quotient_0_of_u1_divisor),
      u1_quotient_1_product_error = ksl_product_error(u1_quotient_1, u1_quotient_0_of_u1_divisor,
          u1_quotient_1_product),
      u1_quotient_1_rest = u1_sized_1 - u1_quotient_1_product,
      u1_quotient_1_exact = u1_quotient_1_rest - u1_quotient_1_product_error,
      u1_quotient_1_cross = KSL_MUL(u1_quotient_1, u1_quotient_0_of_u1_divisor_lo),
      u1_quotient_1_residual = u1_quotient_1_exact - u1_quotient_1_cross,
      u1_quotient_1_lo = u1_quotient_1_residual / u1_quotient_0_of_u1_divisor;
  const double u1_quotient_2 = u1_sized_2 / u1_quotient_0_of_u1_divisor,
      u1_quotient_2_product = KSL_MUL(u1_quotient_2, u1_quotient_0_of_u1_divisor),
      u1_quotient_2_product_error = ksl_product_error(u1_quotient_2, u1_quotient_0_of_u1_divisor,
          u1_quotient_2_product),
      u1_quotient_2_rest = u1_sized_2 - u1_quotient_2_product,
      u1_quotient_2_exact = u1_quotient_2_rest - u1_quotient_2_product_error,
      u1_quotient_2_cross = KSL_MUL(u1_quotient_2, u1_quotient_0_of_u1_divisor_lo),
      u1_quotient_2_residual = u1_quotient_2_exact - u1_quotient_2_cross,
      u1_quotient_2_lo = u1_quotient_2_residual / u1_quotient_0_of_u1_divisor;
  const double u1_0_of_u1_quotient_0 = u1_quotient_0 + u1_quotient_0_lo,
      u1_0_of_u1_quotient_0_right = u1_0_of_u1_quotient_0 - u1_quotient_0,
      u1_0_of_u1_quotient_0_left = u1_0_of_u1_quotient_0 - u1_0_of_u1_quotient_0_right,
      u1_0_of_u1_quotient_0_left_rest = u1_quotient_0 - u1_0_of_u1_quotient_0_left,
      u1_0_of_u1_quotient_0_right_rest = u1_quotient_0_lo - u1_0_of_u1_quotient_0_right,
      u1_0_of_u1_quotient_0_lo = u1_0_of_u1_quotient_0_left_rest + u1_0_of_u1_quotient_0_right_rest,
      u1_0 = KSL_MUL(u1_0_of_u1_quotient_0, u1_down), u1_0_inverse = 1.0 / u1_down,
      u1_0_back = KSL_MUL(u1_0, u1_0_inverse), u1_0_lost = u1_0_of_u1_quotient_0 - u1_0_back,
      u1_0_rest = u1_0_lost + u1_0_of_u1_quotient_0_lo, u1_0_lo = KSL_MUL(u1_0_rest, u1_down);
  const double u1_1_of_u1_quotient_1 = u1_quotient_1 + u1_quotient_1_lo,
      u1_1_of_u1_quotient_1_right = u1_1_of_u1_quotient_1 - u1_quotient_1,
      u1_1_of_u1_quotient_1_left = u1_1_of_u1_quotient_1 - u1_1_of_u1_quotient_1_right,
      u1_1_of_u1_quotient_1_left_rest = u1_quotient_1 - u1_1_of_u1_quotient_1_left,
      u1_1_of_u1_quotient_1_right_rest = u1_quotient_1_lo - u1_1_of_u1_quotient_1_right,
      u1_1_of_u1_quotient_1_lo = u1_1_of_u1_quotient_1_left_rest + u1_1_of_u1_quotient_1_right_rest,
      u1_1 = KSL_MUL(u1_1_of_u1_quotient_1, u1_down), u1_1_back = KSL_MUL(u1_1, u1_0_inverse),
      u1_1_lost = u1_1_of_u1_quotient_1 - u1_1_back,
      u1_1_rest = u1_1_lost + u1_1_of_u1_quotient_1_lo, u1_1_lo = KSL_MUL(u1_1_rest, u1_down);
  const double u1_2_of_u1_quotient_2 = u1_quotient_2 + u1_quotient_2_lo,
      u1_2_of_u1_quotient_2_right = u1_2_of_u1_quotient_2 - u1_quotient_2,
      u1_2_of_u1_quotient_2_left = u1_2_of_u1_quotient_2 - u1_2_of_u1_quotient_2_right,
      u1_2_of_u1_quotient_2_left_rest = u1_quotient_2 - u1_2_of_u1_quotient_2_left,
      u1_2_of_u1_quotient_2_right_rest = u1_quotient_2_lo - u1_2_of_u1_quotient_2_right,
      u1_2_of_u1_quotient_2_lo = u1_2_of_u1_quotient_2_left_rest + u1_2_of_u1_quotient_2_right_rest,
      u1_2 = KSL_MUL(u1_2_of_u1_quotient_2, u1_down), u1_2_back = KSL_MUL(u1_2, u1_0_inverse),
      u1_2_lost = u1_2_of_u1_quotient_2 - u1_2_back,
      u1_2_rest = u1_2_lost + u1_2_of_u1_quotient_2_lo, u1_2_lo = KSL_MUL(u1_2_rest, u1_down);
  const double along_a = KSL_MUL(q0_0, u1_0), along_a_cross1 = KSL_MUL(q0_0_lo, u1_0),
      along_a_cross2 = KSL_MUL(q0_0, u1_0_lo), along_a_cross = along_a_cross1 + along_a_cross2,
      along_b = KSL_MUL(q0_1, u1_1), along_b_cross1 = KSL_MUL(q0_1_lo, u1_1),
      along_b_cross2 = KSL_MUL(q0_1, u1_1_lo), along_b_cross = along_b_cross1 + along_b_cross2,
      along_c = along_a + along_b, along_c_right = along_c - along_a,
      along_c_left = along_c - along_c_right,
      along_c_left_rest = ksl_product_rest(q0_0, u1_0, along_a, along_c_left),
      along_c_right_rest = ksl_product_rest(q0_1, u1_1, along_b, along_c_right),
      along_c_cross = along_a_cross + along_b_cross,
      along_c_lo1 = along_c_left_rest + along_c_right_rest,
      along_c_lo = along_c_lo1 + along_c_cross, along_d = KSL_MUL(q0_2, u1_2),
      along_d_cross1 = KSL_MUL(q0_2_lo, u1_2), along_d_cross2 = KSL_MUL(q0_2, u1_2_lo),
      along_d_cross = along_d_cross1 + along_d_cross2, along = along_c + along_d,
      along_right = along - along_c, along_left = along - along_right,
      along_left_rest = along_c - along_left,
      along_right_rest = ksl_product_rest(q0_2, u1_2, along_d, along_right),
      along_lo1 = along_left_rest + along_right_rest, along_lo2 = along_lo1 + along_d_cross,
      along_lo = along_lo2 + along_c_lo;
  const double once_0a = KSL_MUL(q0_0, along), once_0a_cross1 = KSL_MUL(q0_0_lo, along),
      once_0a_cross2 = KSL_MUL(q0_0, along_lo), once_0a_cross = once_0a_cross1 + once_0a_cross2,
      once_0 = u1_0 - once_0a, once_0_right = u1_0 - once_0, once_0_left = once_0 + once_0_right,
      once_0_left_rest = u1_0 - once_0_left,
      once_0_right_rest = ksl_product_rest(q0_0, along, once_0a, once_0_right),
      once_0_lo1 = once_0_left_rest - once_0_right_rest, once_0_lo2 = once_0_lo1 - once_0a_cross,
      once_0_lo = once_0_lo2 + u1_0_lo;
  const double once_1a = KSL_MUL(q0_1, along), once_1a_cross1 = KSL_MUL(q0_1_lo, along),
      once_1a_cross2 = KSL_MUL(q0_1, along_lo), once_1a_cross = once_1a_cross1 + once_1a_cross2,
      once_1 = u1_1 - once_1a, once_1_right = u1_1 - once_1, once_1_left = once_1 + once_1_right,
      once_1_left_rest = u1_1 - once_1_left,
      once_1_right_rest = ksl_product_rest(q0_1, along, once_1a, once_1_right),
      once_1_lo1 = once_1_left_rest - once_1_right_rest, once_1_lo2 = once_1_lo1 - once_1a_cross,
      once_1_lo = once_1_lo2 + u1_1_lo;
  const double once_2a = KSL_MUL(q0_2, along), once_2a_cross1 = KSL_MUL(q0_2_lo, along),
      once_2a_cross2 = KSL_MUL(q0_2, along_lo), once_2a_cross = once_2a_cross1 + once_2a_cross2,
      once_2 = u1_2 - once_2a, once_2_right = u1_2 - once_2, once_2_left = once_2 + once_2_right,
      once_2_left_rest = u1_2 - once_2_left,
      once_2_right_rest = ksl_product_rest(q0_2, along, once_2a, once_2_right),
      once_2_lo1 = once_2_left_rest - once_2_right_rest, once_2_lo2 = once_2_lo1 - once_2a_cross,
      once_2_lo = once_2_lo2 + u1_2_lo;
  const double rest_a = KSL_MUL(q0_0, once_0), rest_a_cross1 = KSL_MUL(q0_0_lo, once_0),
      rest_a_cross2 = KSL_MUL(q0_0, once_0_lo), rest_a_cross = rest_a_cross1 + rest_a_cross2,
      rest_b = KSL_MUL(q0_1, once_1), rest_b_cross1 = KSL_MUL(q0_1_lo, once_1),
      rest_b_cross2 = KSL_MUL(q0_1, once_1_lo), rest_b_cross = rest_b_cross1 + rest_b_cross2,
      rest_c = rest_a + rest_b, rest_c_right = rest_c - rest_a, rest_c_left = rest_c - rest_c_right,
      rest_c_left_rest = ksl_product_rest(q0_0, once_0, rest_a, rest_c_left),
      rest_c_right_rest = ksl_product_rest(q0_1, once_1, rest_b, rest_c_right),
      rest_c_cross = rest_a_cross + rest_b_cross, rest_c_lo1 = rest_c_left_rest + rest_c_right_rest,
      rest_c_lo = rest_c_lo1 + rest_c_cross, rest_d = KSL_MUL(q0_2, once_2),
      rest_d_cross1 = KSL_MUL(q0_2_lo, once_2), rest_d_cross2 = KSL_MUL(q0_2, once_2_lo),
      rest_d_cross = rest_d_cross1 + rest_d_cross2, rest = rest_c + rest_d,
      rest_right = rest - rest_c, rest_left = rest - rest_right,
      rest_left_rest = rest_c - rest_left,
      rest_right_rest = ksl_product_rest(q0_2, once_2, rest_d, rest_right),
      rest_lo1 = rest_left_rest + rest_right_rest, rest_lo2 = rest_lo1 + rest_d_cross,
      rest_lo = rest_lo2 + rest_c_lo;
  const double twice_0a = KSL_MUL(q0_0, rest), twice_0a_cross1 = KSL_MUL(q0_0_lo, rest),
      twice_0a_cross2 = KSL_MUL(q0_0, rest_lo), twice_0a_cross = twice_0a_cross1 + twice_0a_cross2,
      twice_0 = once_0 - twice_0a, twice_0_right = once_0 - twice_0,
      twice_0_left = twice_0 + twice_0_right, twice_0_left_rest = once_0 - twice_0_left,
      twice_0_right_rest = ksl_product_rest(q0_0, rest, twice_0a, twice_0_right),
      twice_0_lo1 = twice_0_left_rest - twice_0_right_rest,
      twice_0_lo2 = twice_0_lo1 - twice_0a_cross, twice_0_lo = twice_0_lo2 + once_0_lo;
  const double twice_1a = KSL_MUL(q0_1, rest), twice_1a_cross1 = KSL_MUL(q0_1_lo, rest),
      twice_1a_cross2 = KSL_MUL(q0_1, rest_lo), twice_1a_cross = twice_1a_cross1 + twice_1a_cross2,
      twice_1 = once_1 - twice_1a, twice_1_right = once_1 - twice_1,
      twice_1_left = twice_1 + twice_1_right, twice_1_left_rest = once_1 - twice_1_left,
      twice_1_right_rest = ksl_product_rest(q0_1, rest, twice_1a, twice_1_right),
      twice_1_lo1 = twice_1_left_rest - twice_1_right_rest,
      twice_1_lo2 = twice_1_lo1 - twice_1a_cross, twice_1_lo = twice_1_lo2 + once_1_lo;
  const double twice_2a = KSL_MUL(q0_2, rest), twice_2a_cross1 = KSL_MUL(q0_2_lo, rest),
      twice_2a_cross2 = KSL_MUL(q0_2, rest_lo), twice_2a_cross = twice_2a_cross1 + twice_2a_cross2,
      twice_2 = once_2 - twice_2a, twice_2_right = once_2 - twice_2,
      twice_2_left = twice_2 + twice_2_right, twice_2_left_rest = once_2 - twice_2_left,
      twice_2_right_rest = ksl_product_rest(q0_2, rest, twice_2a, twice_2_right),
      twice_2_lo1 = twice_2_left_rest - twice_2_right_rest,
      twice_2_lo2 = twice_2_lo1 - twice_2a_cross, twice_2_lo = twice_2_lo2 + once_2_lo;
  const double n_a = KSL_MUL(twice_0, twice_0), n_a_cross1 = KSL_MUL(twice_0_lo, twice_0),
      n_a_cross2 = KSL_MUL(twice_0, twice_0_lo), n_a_cross = n_a_cross1 + n_a_cross2,
      n_b = KSL_MUL(twice_1, twice_1), n_b_cross1 = KSL_MUL(twice_1_lo, twice_1),
      n_b_cross2 = KSL_MUL(twice_1, twice_1_lo), n_b_cross = n_b_cross1 + n_b_cross2,
      n_c = n_a + n_b, n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(twice_0, twice_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(twice_1, twice_1, n_b, n_c_right),
      n_c_cross = n_a_cross + n_b_cross, n_c_lo1 = n_c_left_rest + n_c_right_rest,
      n_c_lo = n_c_lo1 + n_c_cross, n_d = KSL_MUL(twice_2, twice_2),
      n_d_cross1 = KSL_MUL(twice_2_lo, twice_2), n_d_cross2 = KSL_MUL(twice_2, twice_2_lo),
      n_d_cross = n_d_cross1 + n_d_cross2, n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(twice_2, twice_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo2 = n_e_lo1 + n_d_cross,
      n_e_lo = n_e_lo2 + n_c_lo, n_of_n_e = n_e + n_e_lo, n_of_n_e_right = n_of_n_e - n_e,
      n_of_n_e_left = n_of_n_e - n_of_n_e_right, n_of_n_e_left_rest = n_e - n_of_n_e_left,
      n_of_n_e_right_rest = n_e_lo - n_of_n_e_right,
      n_of_n_e_lo = n_of_n_e_left_rest + n_of_n_e_right_rest, n = sqrt(n_of_n_e),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_e - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_e_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double divisor_a_of_n = n + n_lo, divisor_a_of_n_right = divisor_a_of_n - n,
      divisor_a_of_n_left = divisor_a_of_n - divisor_a_of_n_right,
      divisor_a_of_n_left_rest = n - divisor_a_of_n_left,
      divisor_a_of_n_right_rest = n_lo - divisor_a_of_n_right,
      divisor_a_of_n_lo = divisor_a_of_n_left_rest + divisor_a_of_n_right_rest,
      divisor = divisor_a_of_n == 0.0 ? 1.0 : divisor_a_of_n,
      divisor_lo = divisor_a_of_n == 0.0 ? 0.0 : divisor_a_of_n_lo;
  const double q1_0_of_twice_0 = twice_0 + twice_0_lo,
      q1_0_of_twice_0_right = q1_0_of_twice_0 - twice_0,
      q1_0_of_twice_0_left = q1_0_of_twice_0 - q1_0_of_twice_0_right,
      q1_0_of_twice_0_left_rest = twice_0 - q1_0_of_twice_0_left,
      q1_0_of_twice_0_right_rest = twice_0_lo - q1_0_of_twice_0_right,
      q1_0_of_twice_0_lo = q1_0_of_twice_0_left_rest + q1_0_of_twice_0_right_rest,
      q1_0_of_divisor = divisor + divisor_lo, q1_0_of_divisor_right = q1_0_of_divisor - divisor,
      q1_0_of_divisor_left = q1_0_of_divisor - q1_0_of_divisor_right,
      q1_0_of_divisor_left_rest = divisor - q1_0_of_divisor_left,
      q1_0_of_divisor_right_rest = divisor_lo - q1_0_of_divisor_right,
      q1_0_of_divisor_lo = q1_0_of_divisor_left_rest + q1_0_of_divisor_right_rest,
      q1_0 = q1_0_of_twice_0 / q1_0_of_divisor, q1_0_product = KSL_MUL(q1_0, q1_0_of_divisor),
      q1_0_product_error = ksl_product_error(q1_0, q1_0_of_divisor, q1_0_product),
      q1_0_rest = q1_0_of_twice_0 - q1_0_product, q1_0_exact = q1_0_rest - q1_0_product_error,
      q1_0_numerator = q1_0_exact + q1_0_of_twice_0_lo,
      q1_0_cross = KSL_MUL(q1_0, q1_0_of_divisor_lo), q1_0_residual = q1_0_numerator - q1_0_cross,
      q1_0_lo = q1_0_residual / q1_0_of_divisor;
  const double q1_1_of_twice_1 = twice_1 + twice_1_lo,
      q1_1_of_twice_1_right = q1_1_of_twice_1 - twice_1,
      q1_1_of_twice_1_left = q1_1_of_twice_1 - q1_1_of_twice_1_right,
      q1_1_of_twice_1_left_rest = twice_1 - q1_1_of_twice_1_left,
      q1_1_of_twice_1_right_rest = twice_1_lo - q1_1_of_twice_1_right,
      q1_1_of_twice_1_lo = q1_1_of_twice_1_left_rest + q1_1_of_twice_1_right_rest,
      q1_1 = q1_1_of_twice_1 / q1_0_of_divisor, q1_1_product = KSL_MUL(q1_1, q1_0_of_divisor),
      q1_1_product_error = ksl_product_error(q1_1, q1_0_of_divisor, q1_1_product),
      q1_1_rest = q1_1_of_twice_1 - q1_1_product, q1_1_exact = q1_1_rest - q1_1_product_error,
      q1_1_numerator = q1_1_exact + q1_1_of_twice_1_lo,
      q1_1_cross = KSL_MUL(q1_1, q1_0_of_divisor_lo), q1_1_residual = q1_1_numerator - q1_1_cross,
      q1_1_lo = q1_1_residual / q1_0_of_divisor;
  const double q1_2_of_twice_2 = twice_2 + twice_2_lo,
      q1_2_of_twice_2_right = q1_2_of_twice_2 - twice_2,
      q1_2_of_twice_2_left = q1_2_of_twice_2 - q1_2_of_twice_2_right,
      q1_2_of_twice_2_left_rest = twice_2 - q1_2_of_twice_2_left,
      q1_2_of_twice_2_right_rest = twice_2_lo - q1_2_of_twice_2_right,
      q1_2_of_twice_2_lo = q1_2_of_twice_2_left_rest + q1_2_of_twice_2_right_rest,
      q1_2 = q1_2_of_twice_2 / q1_0_of_divisor, q1_2_product = KSL_MUL(q1_2, q1_0_of_divisor),
      q1_2_product_error = ksl_product_error(q1_2, q1_0_of_divisor, q1_2_product),
      q1_2_rest = q1_2_of_twice_2 - q1_2_product, q1_2_exact = q1_2_rest - q1_2_product_error,
      q1_2_numerator = q1_2_exact + q1_2_of_twice_2_lo,
      q1_2_cross = KSL_MUL(q1_2, q1_0_of_divisor_lo), q1_2_residual = q1_2_numerator - q1_2_cross,
      q1_2_lo = q1_2_residual / q1_0_of_divisor;
  const double normal_0a = KSL_MUL(q0_1, q1_2), normal_0a_cross1 = KSL_MUL(q0_1_lo, q1_2),
      normal_0a_cross2 = KSL_MUL(q0_1, q1_2_lo),
      normal_0a_cross = normal_0a_cross1 + normal_0a_cross2, normal_0b = KSL_MUL(q0_2, q1_1),
      normal_0b_cross1 = KSL_MUL(q0_2_lo, q1_1), normal_0b_cross2 = KSL_MUL(q0_2, q1_1_lo),
      normal_0b_cross = normal_0b_cross1 + normal_0b_cross2, normal_0 = normal_0a - normal_0b,
      normal_0_right = normal_0a - normal_0, normal_0_left = normal_0 + normal_0_right,
      normal_0_left_rest = ksl_product_rest(q0_1, q1_2, normal_0a, normal_0_left),
      normal_0_right_rest = ksl_product_rest(q0_2, q1_1, normal_0b, normal_0_right),
      normal_0_cross = normal_0a_cross - normal_0b_cross,
      normal_0_lo1 = normal_0_left_rest - normal_0_right_rest,
      normal_0_lo = normal_0_lo1 + normal_0_cross;
  const double normal_1a = KSL_MUL(q0_2, q1_0), normal_1a_cross1 = KSL_MUL(q0_2_lo, q1_0),
      normal_1a_cross2 = KSL_MUL(q0_2, q1_0_lo),
      normal_1a_cross = normal_1a_cross1 + normal_1a_cross2, normal_1b = KSL_MUL(q0_0, q1_2),
      normal_1b_cross1 = KSL_MUL(q0_0_lo, q1_2), normal_1b_cross2 = KSL_MUL(q0_0, q1_2_lo),
      normal_1b_cross = normal_1b_cross1 + normal_1b_cross2, normal_1 = normal_1a - normal_1b,
      normal_1_right = normal_1a - normal_1, normal_1_left = normal_1 + normal_1_right,
      normal_1_left_rest = ksl_product_rest(q0_2, q1_0, normal_1a, normal_1_left),
      normal_1_right_rest = ksl_product_rest(q0_0, q1_2, normal_1b, normal_1_right),
      normal_1_cross = normal_1a_cross - normal_1b_cross,
      normal_1_lo1 = normal_1_left_rest - normal_1_right_rest,
      normal_1_lo = normal_1_lo1 + normal_1_cross;
  const double normal_2a = KSL_MUL(q0_0, q1_1), normal_2a_cross1 = KSL_MUL(q0_0_lo, q1_1),
      normal_2a_cross2 = KSL_MUL(q0_0, q1_1_lo),
      normal_2a_cross = normal_2a_cross1 + normal_2a_cross2, normal_2b = KSL_MUL(q0_1, q1_0),
      normal_2b_cross1 = KSL_MUL(q0_1_lo, q1_0), normal_2b_cross2 = KSL_MUL(q0_1, q1_0_lo),
      normal_2b_cross = normal_2b_cross1 + normal_2b_cross2, normal_2 = normal_2a - normal_2b,
      normal_2_right = normal_2a - normal_2, normal_2_left = normal_2 + normal_2_right,
      normal_2_left_rest = ksl_product_rest(q0_0, q1_1, normal_2a, normal_2_left),
      normal_2_right_rest = ksl_product_rest(q0_1, q1_0, normal_2b, normal_2_right),
      normal_2_cross = normal_2a_cross - normal_2b_cross,
      normal_2_lo1 = normal_2_left_rest - normal_2_right_rest,
      normal_2_lo = normal_2_lo1 + normal_2_cross;
  const double u2_s_size_0 = fabs(self->m20);
  const double u2_s_size_1 = fabs(self->m21);
  const double u2_s_size_2 = fabs(self->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = KSL_MUL(self->m20, u2_s);
  const double u2_y_1 = KSL_MUL(self->m21, u2_s);
  const double u2_y_2 = KSL_MUL(self->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = KSL_MUL(u2_y_0, u2_y_0), u2_n_b = KSL_MUL(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_c_right = u2_n_c - u2_n_a, u2_n_c_left = u2_n_c - u2_n_c_right,
      u2_n_c_left_rest = ksl_product_rest(u2_y_0, u2_y_0, u2_n_a, u2_n_c_left),
      u2_n_c_right_rest = ksl_product_rest(u2_y_1, u2_y_1, u2_n_b, u2_n_c_right),
      u2_n_c_lo = u2_n_c_left_rest + u2_n_c_right_rest, u2_n_d = KSL_MUL(u2_y_2, u2_y_2),
      u2_n_e = u2_n_c + u2_n_d, u2_n_e_right = u2_n_e - u2_n_c, u2_n_e_left = u2_n_e - u2_n_e_right,
      u2_n_e_left_rest = u2_n_c - u2_n_e_left,
      u2_n_e_right_rest = ksl_product_rest(u2_y_2, u2_y_2, u2_n_d, u2_n_e_right),
      u2_n_e_lo1 = u2_n_e_left_rest + u2_n_e_right_rest, u2_n_e_lo = u2_n_e_lo1 + u2_n_c_lo,
      u2_n_of_u2_n_e = u2_n_e + u2_n_e_lo, u2_n_of_u2_n_e_right = u2_n_of_u2_n_e - u2_n_e,
      u2_n_of_u2_n_e_left = u2_n_of_u2_n_e - u2_n_of_u2_n_e_right,
      u2_n_of_u2_n_e_left_rest = u2_n_e - u2_n_of_u2_n_e_left,
      u2_n_of_u2_n_e_right_rest = u2_n_e_lo - u2_n_of_u2_n_e_right,
      u2_n_of_u2_n_e_lo = u2_n_of_u2_n_e_left_rest + u2_n_of_u2_n_e_right_rest,
      u2_n = sqrt(u2_n_of_u2_n_e), u2_n_product = KSL_MUL(u2_n, u2_n),
      u2_n_product_error = ksl_product_error(u2_n, u2_n, u2_n_product),
      u2_n_rest = u2_n_of_u2_n_e - u2_n_product, u2_n_exact = u2_n_rest - u2_n_product_error,
      u2_n_residual = u2_n_exact + u2_n_of_u2_n_e_lo, u2_n_twice = u2_n + u2_n,
      u2_n_divisor = u2_n == 0.0 ? 1.0 : u2_n_twice, u2_n_lo = u2_n_residual / u2_n_divisor;
  const double u2_divisor_a_of_u2_n = u2_n + u2_n_lo,
      u2_divisor_a_of_u2_n_right = u2_divisor_a_of_u2_n - u2_n,
      u2_divisor_a_of_u2_n_left = u2_divisor_a_of_u2_n - u2_divisor_a_of_u2_n_right,
      u2_divisor_a_of_u2_n_left_rest = u2_n - u2_divisor_a_of_u2_n_left,
      u2_divisor_a_of_u2_n_right_rest = u2_n_lo - u2_divisor_a_of_u2_n_right,
      u2_divisor_a_of_u2_n_lo = u2_divisor_a_of_u2_n_left_rest + u2_divisor_a_of_u2_n_right_rest,
      u2_divisor = u2_divisor_a_of_u2_n == 0.0 ? u2_up : u2_divisor_a_of_u2_n,
      u2_divisor_lo = u2_divisor_a_of_u2_n == 0.0 ? 0.0 : u2_divisor_a_of_u2_n_lo;
  const double u2_sized_0 = KSL_MUL(self->m20, u2_up);
  const double u2_sized_1 = KSL_MUL(self->m21, u2_up);
  const double u2_sized_2 = KSL_MUL(self->m22, u2_up);
  const double u2_quotient_0_of_u2_divisor = u2_divisor + u2_divisor_lo,
      u2_quotient_0_of_u2_divisor_right = u2_quotient_0_of_u2_divisor - u2_divisor,
      u2_quotient_0_of_u2_divisor_left = u2_quotient_0_of_u2_divisor -
          u2_quotient_0_of_u2_divisor_right,
      u2_quotient_0_of_u2_divisor_left_rest = u2_divisor - u2_quotient_0_of_u2_divisor_left,
      u2_quotient_0_of_u2_divisor_right_rest = u2_divisor_lo - u2_quotient_0_of_u2_divisor_right,
      u2_quotient_0_of_u2_divisor_lo = u2_quotient_0_of_u2_divisor_left_rest +
          u2_quotient_0_of_u2_divisor_right_rest,
      u2_quotient_0 = u2_sized_0 / u2_quotient_0_of_u2_divisor,
      u2_quotient_0_product = KSL_MUL(u2_quotient_0, u2_quotient_0_of_u2_divisor),
      u2_quotient_0_product_error = ksl_product_error(u2_quotient_0, u2_quotient_0_of_u2_divisor,
          u2_quotient_0_product),
      u2_quotient_0_rest = u2_sized_0 - u2_quotient_0_product,
      u2_quotient_0_exact = u2_quotient_0_rest - u2_quotient_0_product_error,
      u2_quotient_0_cross = KSL_MUL(u2_quotient_0, u2_quotient_0_of_u2_divisor_lo),
      u2_quotient_0_residual = u2_quotient_0_exact - u2_quotient_0_cross,
      u2_quotient_0_lo = u2_quotient_0_residual / u2_quotient_0_of_u2_divisor;
  const double u2_quotient_1 = u2_sized_1 / u2_quotient_0_of_u2_divisor,
      u2_quotient_1_product = KSL_MUL(u2_quotient_1, u2_quotient_0_of_u2_divisor),
      u2_quotient_1_product_error = ksl_product_error(u2_quotient_1, u2_quotient_0_of_u2_divisor,
          u2_quotient_1_product),
      u2_quotient_1_rest = u2_sized_1 - u2_quotient_1_product,
      u2_quotient_1_exact = u2_quotient_1_rest - u2_quotient_1_product_error,
      u2_quotient_1_cross = KSL_MUL(u2_quotient_1, u2_quotient_0_of_u2_divisor_lo),
      u2_quotient_1_residual = u2_quotient_1_exact - u2_quotient_1_cross,
      u2_quotient_1_lo = u2_quotient_1_residual / u2_quotient_0_of_u2_divisor;
  const double u2_quotient_2 = u2_sized_2 / u2_quotient_0_of_u2_divisor,
      u2_quotient_2_product = KSL_MUL(u2_quotient_2, u2_quotient_0_of_u2_divisor),
      u2_quotient_2_product_error = ksl_product_error(u2_quotient_2, u2_quotient_0_of_u2_divisor,
          u2_quotient_2_product),
      u2_quotient_2_rest = u2_sized_2 - u2_quotient_2_product,
      u2_quotient_2_exact = u2_quotient_2_rest - u2_quotient_2_product_error,
      u2_quotient_2_cross = KSL_MUL(u2_quotient_2, u2_quotient_0_of_u2_divisor_lo),
      u2_quotient_2_residual = u2_quotient_2_exact - u2_quotient_2_cross,
      u2_quotient_2_lo = u2_quotient_2_residual / u2_quotient_0_of_u2_divisor;
  const double u2_0_of_u2_quotient_0 = u2_quotient_0 + u2_quotient_0_lo,
      u2_0_of_u2_quotient_0_right = u2_0_of_u2_quotient_0 - u2_quotient_0,
      u2_0_of_u2_quotient_0_left = u2_0_of_u2_quotient_0 - u2_0_of_u2_quotient_0_right,
      u2_0_of_u2_quotient_0_left_rest = u2_quotient_0 - u2_0_of_u2_quotient_0_left,
      u2_0_of_u2_quotient_0_right_rest = u2_quotient_0_lo - u2_0_of_u2_quotient_0_right,
      u2_0_of_u2_quotient_0_lo = u2_0_of_u2_quotient_0_left_rest + u2_0_of_u2_quotient_0_right_rest,
      u2_0 = KSL_MUL(u2_0_of_u2_quotient_0, u2_down), u2_0_inverse = 1.0 / u2_down,
      u2_0_back = KSL_MUL(u2_0, u2_0_inverse), u2_0_lost = u2_0_of_u2_quotient_0 - u2_0_back,
      u2_0_rest = u2_0_lost + u2_0_of_u2_quotient_0_lo, u2_0_lo = KSL_MUL(u2_0_rest, u2_down);
  const double u2_1_of_u2_quotient_1 = u2_quotient_1 + u2_quotient_1_lo,
      u2_1_of_u2_quotient_1_right = u2_1_of_u2_quotient_1 - u2_quotient_1,
      u2_1_of_u2_quotient_1_left = u2_1_of_u2_quotient_1 - u2_1_of_u2_quotient_1_right,
      u2_1_of_u2_quotient_1_left_rest = u2_quotient_1 - u2_1_of_u2_quotient_1_left,
      u2_1_of_u2_quotient_1_right_rest = u2_quotient_1_lo - u2_1_of_u2_quotient_1_right,
      u2_1_of_u2_quotient_1_lo = u2_1_of_u2_quotient_1_left_rest + u2_1_of_u2_quotient_1_right_rest,
      u2_1 = KSL_MUL(u2_1_of_u2_quotient_1, u2_down), u2_1_back = KSL_MUL(u2_1, u2_0_inverse),
      u2_1_lost = u2_1_of_u2_quotient_1 - u2_1_back,
      u2_1_rest = u2_1_lost + u2_1_of_u2_quotient_1_lo, u2_1_lo = KSL_MUL(u2_1_rest, u2_down);
  const double u2_2_of_u2_quotient_2 = u2_quotient_2 + u2_quotient_2_lo,
      u2_2_of_u2_quotient_2_right = u2_2_of_u2_quotient_2 - u2_quotient_2,
      u2_2_of_u2_quotient_2_left = u2_2_of_u2_quotient_2 - u2_2_of_u2_quotient_2_right,
      u2_2_of_u2_quotient_2_left_rest = u2_quotient_2 - u2_2_of_u2_quotient_2_left,
      u2_2_of_u2_quotient_2_right_rest = u2_quotient_2_lo - u2_2_of_u2_quotient_2_right,
      u2_2_of_u2_quotient_2_lo = u2_2_of_u2_quotient_2_left_rest + u2_2_of_u2_quotient_2_right_rest,
      u2_2 = KSL_MUL(u2_2_of_u2_quotient_2, u2_down), u2_2_back = KSL_MUL(u2_2, u2_0_inverse),
      u2_2_lost = u2_2_of_u2_quotient_2 - u2_2_back,
      u2_2_rest = u2_2_lost + u2_2_of_u2_quotient_2_lo, u2_2_lo = KSL_MUL(u2_2_rest, u2_down);
  const double side_a = KSL_MUL(normal_0, u2_0), side_a_cross1 = KSL_MUL(normal_0_lo, u2_0),
      side_a_cross2 = KSL_MUL(normal_0, u2_0_lo), side_a_cross = side_a_cross1 + side_a_cross2,
      side_b = KSL_MUL(normal_1, u2_1), side_b_cross1 = KSL_MUL(normal_1_lo, u2_1),
      side_b_cross2 = KSL_MUL(normal_1, u2_1_lo), side_b_cross = side_b_cross1 + side_b_cross2,
      side_c = side_a + side_b, side_c_right = side_c - side_a, side_c_left = side_c - side_c_right,
      side_c_left_rest = ksl_product_rest(normal_0, u2_0, side_a, side_c_left),
      side_c_right_rest = ksl_product_rest(normal_1, u2_1, side_b, side_c_right),
      side_c_cross = side_a_cross + side_b_cross, side_c_lo1 = side_c_left_rest + side_c_right_rest,
      side_c_lo = side_c_lo1 + side_c_cross, side_d = KSL_MUL(normal_2, u2_2),
      side_d_cross1 = KSL_MUL(normal_2_lo, u2_2), side_d_cross2 = KSL_MUL(normal_2, u2_2_lo),
      side_d_cross = side_d_cross1 + side_d_cross2, side = side_c + side_d,
      side_right = side - side_c, side_left = side - side_right,
      side_left_rest = side_c - side_left,
      side_right_rest = ksl_product_rest(normal_2, u2_2, side_d, side_right),
      side_lo1 = side_left_rest + side_right_rest, side_lo2 = side_lo1 + side_d_cross,
      side_lo = side_lo2 + side_c_lo;
  const double q2_0a = -normal_0, q2_0a_lo = -normal_0_lo, q2_0b_of_side = side + side_lo,
      q2_0b_of_side_right = q2_0b_of_side - side,
      q2_0b_of_side_left = q2_0b_of_side - q2_0b_of_side_right,
      q2_0b_of_side_left_rest = side - q2_0b_of_side_left,
      q2_0b_of_side_right_rest = side_lo - q2_0b_of_side_right,
      q2_0b_of_side_lo = q2_0b_of_side_left_rest + q2_0b_of_side_right_rest,
      q2_0 = q2_0b_of_side < 0.0 ? q2_0a : normal_0,
      q2_0_lo = q2_0b_of_side < 0.0 ? q2_0a_lo : normal_0_lo;
  const double q2_1a = -normal_1, q2_1a_lo = -normal_1_lo,
      q2_1 = q2_0b_of_side < 0.0 ? q2_1a : normal_1,
      q2_1_lo = q2_0b_of_side < 0.0 ? q2_1a_lo : normal_1_lo;
  const double q2_2a = -normal_2, q2_2a_lo = -normal_2_lo,
      q2_2 = q2_0b_of_side < 0.0 ? q2_2a : normal_2,
      q2_2_lo = q2_0b_of_side < 0.0 ? q2_2a_lo : normal_2_lo;
  const double size = fabs(q2_0b_of_side), size_opposite = -q2_0b_of_side_lo,
      size_lo = q2_0b_of_side < 0.0 ? size_opposite : q2_0b_of_side_lo;
  const double less_a_of_size = size + size_lo, less_a_of_size_right = less_a_of_size - size,
      less_a_of_size_left = less_a_of_size - less_a_of_size_right,
      less_a_of_size_left_rest = size - less_a_of_size_left,
      less_a_of_size_right_rest = size_lo - less_a_of_size_right,
      less_a_of_size_lo = less_a_of_size_left_rest + less_a_of_size_right_rest,
      less = divisor_a_of_n < less_a_of_size ? divisor_a_of_n : less_a_of_size,
      less_lo = divisor_a_of_n < less_a_of_size ? divisor_a_of_n_lo : less_a_of_size_lo;
  const double dependent_a_of_less = less + less_lo,
      dependent = dependent_a_of_less < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double self_00_new = dependent == 1.0 ? (double)NAN : q0_0,
      self_00_new_lo = dependent == 1.0 ? 0.0 : q0_0_lo;
  const double self_01_new = dependent == 1.0 ? (double)NAN : q0_1,
      self_01_new_lo = dependent == 1.0 ? 0.0 : q0_1_lo;
  const double self_02_new = dependent == 1.0 ? (double)NAN : q0_2,
      self_02_new_lo = dependent == 1.0 ? 0.0 : q0_2_lo;
  const double self_10_new = dependent == 1.0 ? (double)NAN : q1_0,
      self_10_new_lo = dependent == 1.0 ? 0.0 : q1_0_lo;
  const double self_11_new = dependent == 1.0 ? (double)NAN : q1_1,
      self_11_new_lo = dependent == 1.0 ? 0.0 : q1_1_lo;
  const double self_12_new = dependent == 1.0 ? (double)NAN : q1_2,
      self_12_new_lo = dependent == 1.0 ? 0.0 : q1_2_lo;
  const double self_20_new = dependent == 1.0 ? (double)NAN : q2_0,
      self_20_new_lo = dependent == 1.0 ? 0.0 : q2_0_lo;
  const double self_21_new = dependent == 1.0 ? (double)NAN : q2_1,
      self_21_new_lo = dependent == 1.0 ? 0.0 : q2_1_lo;
  const double self_22_new = dependent == 1.0 ? (double)NAN : q2_2,
      self_22_new_lo = dependent == 1.0 ? 0.0 : q2_2_lo;
  const double self_00_new_rounded = self_00_new + self_00_new_lo,
      self_00_new_final = self_00_new_rounded == self_00_new_rounded ? self_00_new_rounded :
          self_00_new;
  const double self_01_new_rounded = self_01_new + self_01_new_lo,
      self_01_new_final = self_01_new_rounded == self_01_new_rounded ? self_01_new_rounded :
          self_01_new;
  const double self_02_new_rounded = self_02_new + self_02_new_lo,
      self_02_new_final = self_02_new_rounded == self_02_new_rounded ? self_02_new_rounded :
          self_02_new;
  const double self_10_new_rounded = self_10_new + self_10_new_lo,
      self_10_new_final = self_10_new_rounded == self_10_new_rounded ? self_10_new_rounded :
          self_10_new;
  const double self_11_new_rounded = self_11_new + self_11_new_lo,
      self_11_new_final = self_11_new_rounded == self_11_new_rounded ? self_11_new_rounded :
          self_11_new;
  const double self_12_new_rounded = self_12_new + self_12_new_lo,
      self_12_new_final = self_12_new_rounded == self_12_new_rounded ? self_12_new_rounded :
          self_12_new;
  const double self_20_new_rounded = self_20_new + self_20_new_lo,
      self_20_new_final = self_20_new_rounded == self_20_new_rounded ? self_20_new_rounded :
          self_20_new;
  const double self_21_new_rounded = self_21_new + self_21_new_lo,
      self_21_new_final = self_21_new_rounded == self_21_new_rounded ? self_21_new_rounded :
          self_21_new;
  const double self_22_new_rounded = self_22_new + self_22_new_lo,
      self_22_new_final = self_22_new_rounded == self_22_new_rounded ? self_22_new_rounded :
          self_22_new;
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
  const double q0_s_size_0 = fabs(R->m00);
  const double q0_s_size_1 = fabs(R->m01);
  const double q0_s_size_2 = fabs(R->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = KSL_MUL(R->m00, q0_s);
  const double q0_y_1 = KSL_MUL(R->m01, q0_s);
  const double q0_y_2 = KSL_MUL(R->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = KSL_MUL(q0_y_0, q0_y_0), q0_n_b = KSL_MUL(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_c_right = q0_n_c - q0_n_a, q0_n_c_left = q0_n_c - q0_n_c_right,
      q0_n_c_left_rest = ksl_product_rest(q0_y_0, q0_y_0, q0_n_a, q0_n_c_left),
      q0_n_c_right_rest = ksl_product_rest(q0_y_1, q0_y_1, q0_n_b, q0_n_c_right),
      q0_n_c_lo = q0_n_c_left_rest + q0_n_c_right_rest, q0_n_d = KSL_MUL(q0_y_2, q0_y_2),
      q0_n_e = q0_n_c + q0_n_d, q0_n_e_right = q0_n_e - q0_n_c, q0_n_e_left = q0_n_e - q0_n_e_right,
      q0_n_e_left_rest = q0_n_c - q0_n_e_left,
      q0_n_e_right_rest = ksl_product_rest(q0_y_2, q0_y_2, q0_n_d, q0_n_e_right),
      q0_n_e_lo1 = q0_n_e_left_rest + q0_n_e_right_rest, q0_n_e_lo = q0_n_e_lo1 + q0_n_c_lo,
      q0_n_of_q0_n_e = q0_n_e + q0_n_e_lo, q0_n_of_q0_n_e_right = q0_n_of_q0_n_e - q0_n_e,
      q0_n_of_q0_n_e_left = q0_n_of_q0_n_e - q0_n_of_q0_n_e_right,
      q0_n_of_q0_n_e_left_rest = q0_n_e - q0_n_of_q0_n_e_left,
      q0_n_of_q0_n_e_right_rest = q0_n_e_lo - q0_n_of_q0_n_e_right,
      q0_n_of_q0_n_e_lo = q0_n_of_q0_n_e_left_rest + q0_n_of_q0_n_e_right_rest,
      q0_n = sqrt(q0_n_of_q0_n_e), q0_n_product = KSL_MUL(q0_n, q0_n),
      q0_n_product_error = ksl_product_error(q0_n, q0_n, q0_n_product),
      q0_n_rest = q0_n_of_q0_n_e - q0_n_product, q0_n_exact = q0_n_rest - q0_n_product_error,
      q0_n_residual = q0_n_exact + q0_n_of_q0_n_e_lo, q0_n_twice = q0_n + q0_n,
      q0_n_divisor = q0_n == 0.0 ? 1.0 : q0_n_twice, q0_n_lo = q0_n_residual / q0_n_divisor;
  const double q0_divisor_a_of_q0_n = q0_n + q0_n_lo,
      q0_divisor_a_of_q0_n_right = q0_divisor_a_of_q0_n - q0_n,
      q0_divisor_a_of_q0_n_left = q0_divisor_a_of_q0_n - q0_divisor_a_of_q0_n_right,
      q0_divisor_a_of_q0_n_left_rest = q0_n - q0_divisor_a_of_q0_n_left,
      q0_divisor_a_of_q0_n_right_rest = q0_n_lo - q0_divisor_a_of_q0_n_right,
      q0_divisor_a_of_q0_n_lo = q0_divisor_a_of_q0_n_left_rest + q0_divisor_a_of_q0_n_right_rest,
      q0_divisor = q0_divisor_a_of_q0_n == 0.0 ? q0_up : q0_divisor_a_of_q0_n,
      q0_divisor_lo = q0_divisor_a_of_q0_n == 0.0 ? 0.0 : q0_divisor_a_of_q0_n_lo;
  const double q0_sized_0 = KSL_MUL(R->m00, q0_up);
  const double q0_sized_1 = KSL_MUL(R->m01, q0_up);
  const double q0_sized_2 = KSL_MUL(R->m02, q0_up);
  const double q0_quotient_0_of_q0_divisor = q0_divisor + q0_divisor_lo,
      q0_quotient_0_of_q0_divisor_right = q0_quotient_0_of_q0_divisor - q0_divisor,
      q0_quotient_0_of_q0_divisor_left = q0_quotient_0_of_q0_divisor -
          q0_quotient_0_of_q0_divisor_right,
      q0_quotient_0_of_q0_divisor_left_rest = q0_divisor - q0_quotient_0_of_q0_divisor_left,
      q0_quotient_0_of_q0_divisor_right_rest = q0_divisor_lo - q0_quotient_0_of_q0_divisor_right,
      q0_quotient_0_of_q0_divisor_lo = q0_quotient_0_of_q0_divisor_left_rest +
          q0_quotient_0_of_q0_divisor_right_rest,
      q0_quotient_0 = q0_sized_0 / q0_quotient_0_of_q0_divisor,
      q0_quotient_0_product = KSL_MUL(q0_quotient_0, q0_quotient_0_of_q0_divisor),
      q0_quotient_0_product_error = ksl_product_error(q0_quotient_0, q0_quotient_0_of_q0_divisor,
          q0_quotient_0_product),
      q0_quotient_0_rest = q0_sized_0 - q0_quotient_0_product,
      q0_quotient_0_exact = q0_quotient_0_rest - q0_quotient_0_product_error,
      q0_quotient_0_cross = KSL_MUL(q0_quotient_0, q0_quotient_0_of_q0_divisor_lo),
      q0_quotient_0_residual = q0_quotient_0_exact - q0_quotient_0_cross,
      q0_quotient_0_lo = q0_quotient_0_residual / q0_quotient_0_of_q0_divisor;
  const double q0_quotient_1 = q0_sized_1 / q0_quotient_0_of_q0_divisor,
      q0_quotient_1_product = KSL_MUL(q0_quotient_1, q0_quotient_0_of_q0_divisor),
      q0_quotient_1_product_error = ksl_product_error(q0_quotient_1, q0_quotient_0_of_q0_divisor,
          q0_quotient_1_product),
      q0_quotient_1_rest = q0_sized_1 - q0_quotient_1_product,
      q0_quotient_1_exact = q0_quotient_1_rest - q0_quotient_1_product_error,
      q0_quotient_1_cross = KSL_MUL(q0_quotient_1, q0_quotient_0_of_q0_divisor_lo),
      q0_quotient_1_residual = q0_quotient_1_exact - q0_quotient_1_cross,
      q0_quotient_1_lo = q0_quotient_1_residual / q0_quotient_0_of_q0_divisor;
  const double q0_quotient_2 = q0_sized_2 / q0_quotient_0_of_q0_divisor,
      q0_quotient_2_product = KSL_MUL(q0_quotient_2, q0_quotient_0_of_q0_divisor),
      q0_quotient_2_product_error = ksl_product_error(q0_quotient_2, q0_quotient_0_of_q0_divisor,
          q0_quotient_2_product),
      q0_quotient_2_rest = q0_sized_2 - q0_quotient_2_product,
      q0_quotient_2_exact = q0_quotient_2_rest - q0_quotient_2_product_error,
      q0_quotient_2_cross = KSL_MUL(q0_quotient_2, q0_quotient_0_of_q0_divisor_lo),
      q0_quotient_2_residual = q0_quotient_2_exact - q0_quotient_2_cross,
      q0_quotient_2_lo = q0_quotient_2_residual / q0_quotient_0_of_q0_divisor;
  const double q0_0_of_q0_quotient_0 = q0_quotient_0 + q0_quotient_0_lo,
      q0_0_of_q0_quotient_0_right = q0_0_of_q0_quotient_0 - q0_quotient_0,
      q0_0_of_q0_quotient_0_left = q0_0_of_q0_quotient_0 - q0_0_of_q0_quotient_0_right,
      q0_0_of_q0_quotient_0_left_rest = q0_quotient_0 - q0_0_of_q0_quotient_0_left,
      q0_0_of_q0_quotient_0_right_rest = q0_quotient_0_lo - q0_0_of_q0_quotient_0_right,
      q0_0_of_q0_quotient_0_lo = q0_0_of_q0_quotient_0_left_rest + q0_0_of_q0_quotient_0_right_rest,
      q0_0 = KSL_MUL(q0_0_of_q0_quotient_0, q0_down), q0_0_inverse = 1.0 / q0_down,
      q0_0_back = KSL_MUL(q0_0, q0_0_inverse), q0_0_lost = q0_0_of_q0_quotient_0 - q0_0_back,
      q0_0_rest = q0_0_lost + q0_0_of_q0_quotient_0_lo, q0_0_lo = KSL_MUL(q0_0_rest, q0_down);
  const double q0_1_of_q0_quotient_1 = q0_quotient_1 + q0_quotient_1_lo,
      q0_1_of_q0_quotient_1_right = q0_1_of_q0_quotient_1 - q0_quotient_1,
      q0_1_of_q0_quotient_1_left = q0_1_of_q0_quotient_1 - q0_1_of_q0_quotient_1_right,
      q0_1_of_q0_quotient_1_left_rest = q0_quotient_1 - q0_1_of_q0_quotient_1_left,
      q0_1_of_q0_quotient_1_right_rest = q0_quotient_1_lo - q0_1_of_q0_quotient_1_right,
      q0_1_of_q0_quotient_1_lo = q0_1_of_q0_quotient_1_left_rest + q0_1_of_q0_quotient_1_right_rest,
      q0_1 = KSL_MUL(q0_1_of_q0_quotient_1, q0_down), q0_1_back = KSL_MUL(q0_1, q0_0_inverse),
      q0_1_lost = q0_1_of_q0_quotient_1 - q0_1_back,
      q0_1_rest = q0_1_lost + q0_1_of_q0_quotient_1_lo, q0_1_lo = KSL_MUL(q0_1_rest, q0_down);
  const double q0_2_of_q0_quotient_2 = q0_quotient_2 + q0_quotient_2_lo,
      q0_2_of_q0_quotient_2_right = q0_2_of_q0_quotient_2 - q0_quotient_2,
      q0_2_of_q0_quotient_2_left = q0_2_of_q0_quotient_2 - q0_2_of_q0_quotient_2_right,
      q0_2_of_q0_quotient_2_left_rest = q0_quotient_2 - q0_2_of_q0_quotient_2_left,
      q0_2_of_q0_quotient_2_right_rest = q0_quotient_2_lo - q0_2_of_q0_quotient_2_right,
      q0_2_of_q0_quotient_2_lo = q0_2_of_q0_quotient_2_left_rest + q0_2_of_q0_quotient_2_right_rest,
      q0_2 = KSL_MUL(q0_2_of_q0_quotient_2, q0_down), q0_2_back = KSL_MUL(q0_2, q0_0_inverse),
      q0_2_lost = q0_2_of_q0_quotient_2 - q0_2_back,
      q0_2_rest = q0_2_lost + q0_2_of_q0_quotient_2_lo, q0_2_lo = KSL_MUL(q0_2_rest, q0_down);
  const double u1_s_size_0 = fabs(R->m10);
  const double u1_s_size_1 = fabs(R->m11);
  const double u1_s_size_2 = fabs(R->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = KSL_MUL(R->m10, u1_s);
  const double u1_y_1 = KSL_MUL(R->m11, u1_s);
  const double u1_y_2 = KSL_MUL(R->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = KSL_MUL(u1_y_0, u1_y_0), u1_n_b = KSL_MUL(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_c_right = u1_n_c - u1_n_a, u1_n_c_left = u1_n_c - u1_n_c_right,
      u1_n_c_left_rest = ksl_product_rest(u1_y_0, u1_y_0, u1_n_a, u1_n_c_left),
      u1_n_c_right_rest = ksl_product_rest(u1_y_1, u1_y_1, u1_n_b, u1_n_c_right),
      u1_n_c_lo = u1_n_c_left_rest + u1_n_c_right_rest, u1_n_d = KSL_MUL(u1_y_2, u1_y_2),
      u1_n_e = u1_n_c + u1_n_d, u1_n_e_right = u1_n_e - u1_n_c, u1_n_e_left = u1_n_e - u1_n_e_right,
      u1_n_e_left_rest = u1_n_c - u1_n_e_left,
      u1_n_e_right_rest = ksl_product_rest(u1_y_2, u1_y_2, u1_n_d, u1_n_e_right),
      u1_n_e_lo1 = u1_n_e_left_rest + u1_n_e_right_rest, u1_n_e_lo = u1_n_e_lo1 + u1_n_c_lo,
      u1_n_of_u1_n_e = u1_n_e + u1_n_e_lo, u1_n_of_u1_n_e_right = u1_n_of_u1_n_e - u1_n_e,
      u1_n_of_u1_n_e_left = u1_n_of_u1_n_e - u1_n_of_u1_n_e_right,
      u1_n_of_u1_n_e_left_rest = u1_n_e - u1_n_of_u1_n_e_left,
      u1_n_of_u1_n_e_right_rest = u1_n_e_lo - u1_n_of_u1_n_e_right,
      u1_n_of_u1_n_e_lo = u1_n_of_u1_n_e_left_rest + u1_n_of_u1_n_e_right_rest,
      u1_n = sqrt(u1_n_of_u1_n_e), u1_n_product = KSL_MUL(u1_n, u1_n),
      u1_n_product_error = ksl_product_error(u1_n, u1_n, u1_n_product),
      u1_n_rest = u1_n_of_u1_n_e - u1_n_product, u1_n_exact = u1_n_rest - u1_n_product_error,
      u1_n_residual = u1_n_exact + u1_n_of_u1_n_e_lo, u1_n_twice = u1_n + u1_n,
      u1_n_divisor = u1_n == 0.0 ? 1.0 : u1_n_twice, u1_n_lo = u1_n_residual / u1_n_divisor;
  const double u1_divisor_a_of_u1_n = u1_n + u1_n_lo,
      u1_divisor_a_of_u1_n_right = u1_divisor_a_of_u1_n - u1_n,
      u1_divisor_a_of_u1_n_left = u1_divisor_a_of_u1_n - u1_divisor_a_of_u1_n_right,
      u1_divisor_a_of_u1_n_left_rest = u1_n - u1_divisor_a_of_u1_n_left,
      u1_divisor_a_of_u1_n_right_rest = u1_n_lo - u1_divisor_a_of_u1_n_right,
      u1_divisor_a_of_u1_n_lo = u1_divisor_a_of_u1_n_left_rest + u1_divisor_a_of_u1_n_right_rest,
      u1_divisor = u1_divisor_a_of_u1_n == 0.0 ? u1_up : u1_divisor_a_of_u1_n,
      u1_divisor_lo = u1_divisor_a_of_u1_n == 0.0 ? 0.0 : u1_divisor_a_of_u1_n_lo;
  const double u1_sized_0 = KSL_MUL(R->m10, u1_up);
  const double u1_sized_1 = KSL_MUL(R->m11, u1_up);
  const double u1_sized_2 = KSL_MUL(R->m12, u1_up);
  const double u1_quotient_0_of_u1_divisor = u1_divisor + u1_divisor_lo,
      u1_quotient_0_of_u1_divisor_right = u1_quotient_0_of_u1_divisor - u1_divisor,
      u1_quotient_0_of_u1_divisor_left = u1_quotient_0_of_u1_divisor -
          u1_quotient_0_of_u1_divisor_right,
      u1_quotient_0_of_u1_divisor_left_rest = u1_divisor - u1_quotient_0_of_u1_divisor_left,
      u1_quotient_0_of_u1_divisor_right_rest = u1_divisor_lo - u1_quotient_0_of_u1_divisor_right,
      u1_quotient_0_of_u1_divisor_lo = u1_quotient_0_of_u1_divisor_left_rest +
          u1_quotient_0_of_u1_divisor_right_rest,
      u1_quotient_0 = u1_sized_0 / u1_quotient_0_of_u1_divisor,
      u1_quotient_0_product = KSL_MUL(u1_quotient_0, u1_quotient_0_of_u1_divisor),
      u1_quotient_0_product_error = ksl_product_error(u1_quotient_0, u1_quotient_0_of_u1_divisor,
          u1_quotient_0_product),
      u1_quotient_0_rest = u1_sized_0 - u1_quotient_0_product,
      u1_quotient_0_exact = u1_quotient_0_rest - u1_quotient_0_product_error,
      u1_quotient_0_cross = KSL_MUL(u1_quotient_0, u1_quotient_0_of_u1_divisor_lo),
      u1_quotient_0_residual = u1_quotient_0_exact - u1_quotient_0_cross,
      u1_quotient_0_lo = u1_quotient_0_residual / u1_quotient_0_of_u1_divisor;
  const double u1_quotient_1 = u1_sized_1 / u1_quotient_0_of_u1_divisor,
      u1_quotient_1_product = KSL_MUL(u1_quotient_1, u1_quotient_0_of_u1_divisor),
      u1_quotient_1_product_error = ksl_product_error(u1_quotient_1, u1_quotient_0_of_u1_divisor,
          u1_quotient_1_product),
      u1_quotient_1_rest = u1_sized_1 - u1_quotient_1_product,
      u1_quotient_1_exact = u1_quotient_1_rest - u1_quotient_1_product_error,
      u1_quotient_1_cross = KSL_MUL(u1_quotient_1, u1_quotient_0_of_u1_divisor_lo),
      u1_quotient_1_residual = u1_quotient_1_exact - u1_quotient_1_cross,
      u1_quotient_1_lo = u1_quotient_1_residual / u1_quotient_0_of_u1_divisor;
  const double u1_quotient_2 = u1_sized_2 / u1_quotient_0_of_u1_divisor,
      u1_quotient_2_product = KSL_MUL(u1_quotient_2, u1_quotient_0_of_u1_divisor),
      u1_quotient_2_product_error = ksl_product_error(u1_quotient_2, u1_quotient_0_of_u1_divisor,
          u1_quotient_2_product),
      u1_quotient_2_rest = u1_sized_2 - u1_quotient_2_product,
      u1_quotient_2_exact = u1_quotient_2_rest - u1_quotient_2_product_error,
      u1_quotient_2_cross = KSL_MUL(u1_quotient_2, u1_quotient_0_of_u1_divisor_lo),
      u1_quotient_2_residual = u1_quotient_2_exact - u1_quotient_2_cross,
      u1_quotient_2_lo = u1_quotient_2_residual / u1_quotient_0_of_u1_divisor;
  const double u1_0_of_u1_quotient_0 = u1_quotient_0 + u1_quotient_0_lo,
      u1_0_of_u1_quotient_0_right = u1_0_of_u1_quotient_0 - u1_quotient_0,
      u1_0_of_u1_quotient_0_left = u1_0_of_u1_quotient_0 - u1_0_of_u1_quotient_0_right,
      u1_0_of_u1_quotient_0_left_rest = u1_quotient_0 - u1_0_of_u1_quotient_0_left,
      u1_0_of_u1_quotient_0_right_rest = u1_quotient_0_lo - u1_0_of_u1_quotient_0_right,
      u1_0_of_u1_quotient_0_lo = u1_0_of_u1_quotient_0_left_rest + u1_0_of_u1_quotient_0_right_rest,
      u1_0 = KSL_MUL(u1_0_of_u1_quotient_0, u1_down), u1_0_inverse = 1.0 / u1_down,
      u1_0_back = KSL_MUL(u1_0, u1_0_inverse), u1_0_lost = u1_0_of_u1_quotient_0 - u1_0_back,
      u1_0_rest = u1_0_lost + u1_0_of_u1_quotient_0_lo, u1_0_lo = KSL_MUL(u1_0_rest, u1_down);
  const double u1_1_of_u1_quotient_1 = u1_quotient_1 + u1_quotient_1_lo,
      u1_1_of_u1_quotient_1_right = u1_1_of_u1_quotient_1 - u1_quotient_1,
      u1_1_of_u1_quotient_1_left = u1_1_of_u1_quotient_1 - u1_1_of_u1_quotient_1_right,
      u1_1_of_u1_quotient_1_left_rest = u1_quotient_1 - u1_1_of_u1_quotient_1_left,
      u1_1_of_u1_quotient_1_right_rest = u1_quotient_1_lo - u1_1_of_u1_quotient_1_right,
      u1_1_of_u1_quotient_1_lo = u1_1_of_u1_quotient_1_left_rest + u1_1_of_u1_quotient_1_right_rest,
      u1_1 = KSL_MUL(u1_1_of_u1_quotient_1, u1_down), u1_1_back = KSL_MUL(u1_1, u1_0_inverse),
      u1_1_lost = u1_1_of_u1_quotient_1 - u1_1_back,
      u1_1_rest = u1_1_lost + u1_1_of_u1_quotient_1_lo, u1_1_lo = KSL_MUL(u1_1_rest, u1_down);
  const double u1_2_of_u1_quotient_2 = u1_quotient_2 + u1_quotient_2_lo,
      u1_2_of_u1_quotient_2_right = u1_2_of_u1_quotient_2 - u1_quotient_2,
      u1_2_of_u1_quotient_2_left = u1_2_of_u1_quotient_2 - u1_2_of_u1_quotient_2_right,
      u1_2_of_u1_quotient_2_left_rest = u1_quotient_2 - u1_2_of_u1_quotient_2_left,
      u1_2_of_u1_quotient_2_right_rest = u1_quotient_2_lo - u1_2_of_u1_quotient_2_right,
      u1_2_of_u1_quotient_2_lo = u1_2_of_u1_quotient_2_left_rest + u1_2_of_u1_quotient_2_right_rest,
      u1_2 = KSL_MUL(u1_2_of_u1_quotient_2, u1_down), u1_2_back = KSL_MUL(u1_2, u1_0_inverse),
      u1_2_lost = u1_2_of_u1_quotient_2 - u1_2_back,
      u1_2_rest = u1_2_lost + u1_2_of_u1_quotient_2_lo, u1_2_lo = KSL_MUL(u1_2_rest, u1_down);
  const double along_a = KSL_MUL(q0_0, u1_0), along_a_cross1 = KSL_MUL(q0_0_lo, u1_0),
      along_a_cross2 = KSL_MUL(q0_0, u1_0_lo), along_a_cross = along_a_cross1 + along_a_cross2,
      along_b = KSL_MUL(q0_1, u1_1), along_b_cross1 = KSL_MUL(q0_1_lo, u1_1),
      along_b_cross2 = KSL_MUL(q0_1, u1_1_lo), along_b_cross = along_b_cross1 + along_b_cross2,
      along_c = along_a + along_b, along_c_right = along_c - along_a,
      along_c_left = along_c - along_c_right,
      along_c_left_rest = ksl_product_rest(q0_0, u1_0, along_a, along_c_left),
      along_c_right_rest = ksl_product_rest(q0_1, u1_1, along_b, along_c_right),
      along_c_cross = along_a_cross + along_b_cross,
      along_c_lo1 = along_c_left_rest + along_c_right_rest,
      along_c_lo = along_c_lo1 + along_c_cross, along_d = KSL_MUL(q0_2, u1_2),
      along_d_cross1 = KSL_MUL(q0_2_lo, u1_2), along_d_cross2 = KSL_MUL(q0_2, u1_2_lo),
      along_d_cross = along_d_cross1 + along_d_cross2, along = along_c + along_d,
      along_right = along - along_c, along_left = along - along_right,
      along_left_rest = along_c - along_left,
      along_right_rest = ksl_product_rest(q0_2, u1_2, along_d, along_right),
      along_lo1 = along_left_rest + along_right_rest, along_lo2 = along_lo1 + along_d_cross,
      along_lo = along_lo2 + along_c_lo;
  const double once_0a = KSL_MUL(q0_0, along), once_0a_cross1 = KSL_MUL(q0_0_lo, along),
      once_0a_cross2 = KSL_MUL(q0_0, along_lo), once_0a_cross = once_0a_cross1 + once_0a_cross2,
      once_0 = u1_0 - once_0a, once_0_right = u1_0 - once_0, once_0_left = once_0 + once_0_right,
      once_0_left_rest = u1_0 - once_0_left,
      once_0_right_rest = ksl_product_rest(q0_0, along, once_0a, once_0_right),
      once_0_lo1 = once_0_left_rest - once_0_right_rest, once_0_lo2 = once_0_lo1 - once_0a_cross,
      once_0_lo = once_0_lo2 + u1_0_lo;
  const double once_1a = KSL_MUL(q0_1, along), once_1a_cross1 = KSL_MUL(q0_1_lo, along),
      once_1a_cross2 = KSL_MUL(q0_1, along_lo), once_1a_cross = once_1a_cross1 + once_1a_cross2,
      once_1 = u1_1 - once_1a, once_1_right = u1_1 - once_1, once_1_left = once_1 + once_1_right,
      once_1_left_rest = u1_1 - once_1_left,
      once_1_right_rest = ksl_product_rest(q0_1, along, once_1a, once_1_right),
      once_1_lo1 = once_1_left_rest - once_1_right_rest, once_1_lo2 = once_1_lo1 - once_1a_cross,
      once_1_lo = once_1_lo2 + u1_1_lo;
  const double once_2a = KSL_MUL(q0_2, along), once_2a_cross1 = KSL_MUL(q0_2_lo, along),
      once_2a_cross2 = KSL_MUL(q0_2, along_lo), once_2a_cross = once_2a_cross1 + once_2a_cross2,
      once_2 = u1_2 - once_2a, once_2_right = u1_2 - once_2, once_2_left = once_2 + once_2_right,
      once_2_left_rest = u1_2 - once_2_left,
      once_2_right_rest = ksl_product_rest(q0_2, along, once_2a, once_2_right),
      once_2_lo1 = once_2_left_rest - once_2_right_rest, once_2_lo2 = once_2_lo1 - once_2a_cross,
      once_2_lo = once_2_lo2 + u1_2_lo;
  const double rest_a = KSL_MUL(q0_0, once_0), rest_a_cross1 = KSL_MUL(q0_0_lo, once_0),
      rest_a_cross2 = KSL_MUL(q0_0, once_0_lo), rest_a_cross = rest_a_cross1 + rest_a_cross2,
      rest_b = KSL_MUL(q0_1, once_1), rest_b_cross1 = KSL_MUL(q0_1_lo, once_1),
      rest_b_cross2 = KSL_MUL(q0_1, once_1_lo), rest_b_cross = rest_b_cross1 + rest_b_cross2,
      rest_c = rest_a + rest_b, rest_c_right = rest_c - rest_a, rest_c_left = rest_c - rest_c_right,
      rest_c_left_rest = ksl_product_rest(q0_0, once_0, rest_a, rest_c_left),
      rest_c_right_rest = ksl_product_rest(q0_1, once_1, rest_b, rest_c_right),
      rest_c_cross = rest_a_cross + rest_b_cross, rest_c_lo1 = rest_c_left_rest + rest_c_right_rest,
      rest_c_lo = rest_c_lo1 + rest_c_cross, rest_d = KSL_MUL(q0_2, once_2),
      rest_d_cross1 = KSL_MUL(q0_2_lo, once_2), rest_d_cross2 = KSL_MUL(q0_2, once_2_lo),
      rest_d_cross = rest_d_cross1 + rest_d_cross2, rest = rest_c + rest_d,
      rest_right = rest - rest_c, rest_left = rest - rest_right,
      rest_left_rest = rest_c - rest_left,
      rest_right_rest = ksl_product_rest(q0_2, once_2, rest_d, rest_right),
      rest_lo1 = rest_left_rest + rest_right_rest, rest_lo2 = rest_lo1 + rest_d_cross,
      rest_lo = rest_lo2 + rest_c_lo;
  const double twice_0a = KSL_MUL(q0_0, rest), twice_0a_cross1 = KSL_MUL(q0_0_lo, rest),
      twice_0a_cross2 = KSL_MUL(q0_0, rest_lo), twice_0a_cross = twice_0a_cross1 + twice_0a_cross2,
      twice_0 = once_0 - twice_0a, twice_0_right = once_0 - twice_0,
      twice_0_left = twice_0 + twice_0_right, twice_0_left_rest = once_0 - twice_0_left,
      twice_0_right_rest = ksl_product_rest(q0_0, rest, twice_0a, twice_0_right),
      twice_0_lo1 = twice_0_left_rest - twice_0_right_rest,
      twice_0_lo2 = twice_0_lo1 - twice_0a_cross, twice_0_lo = twice_0_lo2 + once_0_lo;
  const double twice_1a = KSL_MUL(q0_1, rest), twice_1a_cross1 = KSL_MUL(q0_1_lo, rest),
      twice_1a_cross2 = KSL_MUL(q0_1, rest_lo), twice_1a_cross = twice_1a_cross1 + twice_1a_cross2,
      twice_1 = once_1 - twice_1a, twice_1_right = once_1 - twice_1,
      twice_1_left = twice_1 + twice_1_right, twice_1_left_rest = once_1 - twice_1_left,
      twice_1_right_rest = ksl_product_rest(q0_1, rest, twice_1a, twice_1_right),
      twice_1_lo1 = twice_1_left_rest - twice_1_right_rest,
      twice_1_lo2 = twice_1_lo1 - twice_1a_cross, twice_1_lo = twice_1_lo2 + once_1_lo;
  const double twice_2a = KSL_MUL(q0_2, rest), twice_2a_cross1 = KSL_MUL(q0_2_lo, rest),
      twice_2a_cross2 = KSL_MUL(q0_2, rest_lo), twice_2a_cross = twice_2a_cross1 + twice_2a_cross2,
      twice_2 = once_2 - twice_2a, twice_2_right = once_2 - twice_2,
      twice_2_left = twice_2 + twice_2_right, twice_2_left_rest = once_2 - twice_2_left,
      twice_2_right_rest = ksl_product_rest(q0_2, rest, twice_2a, twice_2_right),
      twice_2_lo1 = twice_2_left_rest - twice_2_right_rest,
      twice_2_lo2 = twice_2_lo1 - twice_2a_cross, twice_2_lo = twice_2_lo2 + once_2_lo;
  const double n_a = KSL_MUL(twice_0, twice_0), n_a_cross1 = KSL_MUL(twice_0_lo, twice_0),
      n_a_cross2 = KSL_MUL(twice_0, twice_0_lo), n_a_cross = n_a_cross1 + n_a_cross2,
      n_b = KSL_MUL(twice_1, twice_1), n_b_cross1 = KSL_MUL(twice_1_lo, twice_1),
      n_b_cross2 = KSL_MUL(twice_1, twice_1_lo), n_b_cross = n_b_cross1 + n_b_cross2,
      n_c = n_a + n_b, n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(twice_0, twice_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(twice_1, twice_1, n_b, n_c_right),
      n_c_cross = n_a_cross + n_b_cross, n_c_lo1 = n_c_left_rest + n_c_right_rest,
      n_c_lo = n_c_lo1 + n_c_cross, n_d = KSL_MUL(twice_2, twice_2),
      n_d_cross1 = KSL_MUL(twice_2_lo, twice_2), n_d_cross2 = KSL_MUL(twice_2, twice_2_lo),
      n_d_cross = n_d_cross1 + n_d_cross2, n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(twice_2, twice_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo2 = n_e_lo1 + n_d_cross,
      n_e_lo = n_e_lo2 + n_c_lo, n_of_n_e = n_e + n_e_lo, n_of_n_e_right = n_of_n_e - n_e,
      n_of_n_e_left = n_of_n_e - n_of_n_e_right, n_of_n_e_left_rest = n_e - n_of_n_e_left,
      n_of_n_e_right_rest = n_e_lo - n_of_n_e_right,
      n_of_n_e_lo = n_of_n_e_left_rest + n_of_n_e_right_rest, n = sqrt(n_of_n_e),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_e - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_e_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double divisor_a_of_n = n + n_lo, divisor_a_of_n_right = divisor_a_of_n - n,
      divisor_a_of_n_left = divisor_a_of_n - divisor_a_of_n_right,
      divisor_a_of_n_left_rest = n - divisor_a_of_n_left,
      divisor_a_of_n_right_rest = n_lo - divisor_a_of_n_right,
      divisor_a_of_n_lo = divisor_a_of_n_left_rest + divisor_a_of_n_right_rest,
      divisor = divisor_a_of_n == 0.0 ? 1.0 : divisor_a_of_n,
      divisor_lo = divisor_a_of_n == 0.0 ? 0.0 : divisor_a_of_n_lo;
  const double q1_0_of_twice_0 = twice_0 + twice_0_lo,
      q1_0_of_twice_0_right = q1_0_of_twice_0 - twice_0,
      q1_0_of_twice_0_left = q1_0_of_twice_0 - q1_0_of_twice_0_right,
      q1_0_of_twice_0_left_rest = twice_0 - q1_0_of_twice_0_left,
      q1_0_of_twice_0_right_rest = twice_0_lo - q1_0_of_twice_0_right,
      q1_0_of_twice_0_lo = q1_0_of_twice_0_left_rest + q1_0_of_twice_0_right_rest,
      q1_0_of_divisor = divisor + divisor_lo, q1_0_of_divisor_right = q1_0_of_divisor - divisor,
      q1_0_of_divisor_left = q1_0_of_divisor - q1_0_of_divisor_right,
      q1_0_of_divisor_left_rest = divisor - q1_0_of_divisor_left,
      q1_0_of_divisor_right_rest = divisor_lo - q1_0_of_divisor_right,
      q1_0_of_divisor_lo = q1_0_of_divisor_left_rest + q1_0_of_divisor_right_rest,
      q1_0 = q1_0_of_twice_0 / q1_0_of_divisor, q1_0_product = KSL_MUL(q1_0, q1_0_of_divisor),
      q1_0_product_error = ksl_product_error(q1_0, q1_0_of_divisor, q1_0_product),
      q1_0_rest = q1_0_of_twice_0 - q1_0_product, q1_0_exact = q1_0_rest - q1_0_product_error,
      q1_0_numerator = q1_0_exact + q1_0_of_twice_0_lo,
      q1_0_cross = KSL_MUL(q1_0, q1_0_of_divisor_lo), q1_0_residual = q1_0_numerator - q1_0_cross,
      q1_0_lo = q1_0_residual / q1_0_of_divisor;
  const double q1_1_of_twice_1 = twice_1 + twice_1_lo,
      q1_1_of_twice_1_right = q1_1_of_twice_1 - twice_1,
      q1_1_of_twice_1_left = q1_1_of_twice_1 - q1_1_of_twice_1_right,
      q1_1_of_twice_1_left_rest = twice_1 - q1_1_of_twice_1_left,
      q1_1_of_twice_1_right_rest = twice_1_lo - q1_1_of_twice_1_right,
      q1_1_of_twice_1_lo = q1_1_of_twice_1_left_rest + q1_1_of_twice_1_right_rest,
      q1_1 = q1_1_of_twice_1 / q1_0_of_divisor, q1_1_product = KSL_MUL(q1_1, q1_0_of_divisor),
      q1_1_product_error = ksl_product_error(q1_1, q1_0_of_divisor, q1_1_product),
      q1_1_rest = q1_1_of_twice_1 - q1_1_product, q1_1_exact = q1_1_rest - q1_1_product_error,
      q1_1_numerator = q1_1_exact + q1_1_of_twice_1_lo,
      q1_1_cross = KSL_MUL(q1_1, q1_0_of_divisor_lo), q1_1_residual = q1_1_numerator - q1_1_cross,
      q1_1_lo = q1_1_residual / q1_0_of_divisor;
  const double q1_2_of_twice_2 = twice_2 + twice_2_lo,
      q1_2_of_twice_2_right = q1_2_of_twice_2 - twice_2,
      q1_2_of_twice_2_left = q1_2_of_twice_2 - q1_2_of_twice_2_right,
      q1_2_of_twice_2_left_rest = twice_2 - q1_2_of_twice_2_left,
      q1_2_of_twice_2_right_rest = twice_2_lo - q1_2_of_twice_2_right,
      q1_2_of_twice_2_lo = q1_2_of_twice_2_left_rest + q1_2_of_twice_2_right_rest,
      q1_2 = q1_2_of_twice_2 / q1_0_of_divisor, q1_2_product = KSL_MUL(q1_2, q1_0_of_divisor),
      q1_2_product_error = ksl_product_error(q1_2, q1_0_of_divisor, q1_2_product),
      q1_2_rest = q1_2_of_twice_2 - q1_2_product, q1_2_exact = q1_2_rest - q1_2_product_error,
      q1_2_numerator = q1_2_exact + q1_2_of_twice_2_lo,
      q1_2_cross = KSL_MUL(q1_2, q1_0_of_divisor_lo), q1_2_residual = q1_2_numerator - q1_2_cross,
      q1_2_lo = q1_2_residual / q1_0_of_divisor;
  const double normal_0a = KSL_MUL(q0_1, q1_2), normal_0a_cross1 = KSL_MUL(q0_1_lo, q1_2),
      normal_0a_cross2 = KSL_MUL(q0_1, q1_2_lo),
      normal_0a_cross = normal_0a_cross1 + normal_0a_cross2, normal_0b = KSL_MUL(q0_2, q1_1),
      normal_0b_cross1 = KSL_MUL(q0_2_lo, q1_1), normal_0b_cross2 = KSL_MUL(q0_2, q1_1_lo),
      normal_0b_cross = normal_0b_cross1 + normal_0b_cross2, normal_0 = normal_0a - normal_0b,
      normal_0_right = normal_0a - normal_0, normal_0_left = normal_0 + normal_0_right,
      normal_0_left_rest = ksl_product_rest(q0_1, q1_2, normal_0a, normal_0_left),
      normal_0_right_rest = ksl_product_rest(q0_2, q1_1, normal_0b, normal_0_right),
      normal_0_cross = normal_0a_cross - normal_0b_cross,
      normal_0_lo1 = normal_0_left_rest - normal_0_right_rest,
      normal_0_lo = normal_0_lo1 + normal_0_cross;
  const double normal_1a = KSL_MUL(q0_2, q1_0), normal_1a_cross1 = KSL_MUL(q0_2_lo, q1_0),
      normal_1a_cross2 = KSL_MUL(q0_2, q1_0_lo),
      normal_1a_cross = normal_1a_cross1 + normal_1a_cross2, normal_1b = KSL_MUL(q0_0, q1_2),
      normal_1b_cross1 = KSL_MUL(q0_0_lo, q1_2), normal_1b_cross2 = KSL_MUL(q0_0, q1_2_lo),
      normal_1b_cross = normal_1b_cross1 + normal_1b_cross2, normal_1 = normal_1a - normal_1b,
      normal_1_right = normal_1a - normal_1, normal_1_left = normal_1 + normal_1_right,
      normal_1_left_rest = ksl_product_rest(q0_2, q1_0, normal_1a, normal_1_left),
      normal_1_right_rest = ksl_product_rest(q0_0, q1_2, normal_1b, normal_1_right),
      normal_1_cross = normal_1a_cross - normal_1b_cross,
      normal_1_lo1 = normal_1_left_rest - normal_1_right_rest,
      normal_1_lo = normal_1_lo1 + normal_1_cross;
  const double normal_2a = KSL_MUL(q0_0, q1_1), normal_2a_cross1 = KSL_MUL(q0_0_lo, q1_1),
      normal_2a_cross2 = KSL_MUL(q0_0, q1_1_lo),
      normal_2a_cross = normal_2a_cross1 + normal_2a_cross2, normal_2b = KSL_MUL(q0_1, q1_0),
      normal_2b_cross1 = KSL_MUL(q0_1_lo, q1_0), normal_2b_cross2 = KSL_MUL(q0_1, q1_0_lo),
      normal_2b_cross = normal_2b_cross1 + normal_2b_cross2, normal_2 = normal_2a - normal_2b,
      normal_2_right = normal_2a - normal_2, normal_2_left = normal_2 + normal_2_right,
      normal_2_left_rest = ksl_product_rest(q0_0, q1_1, normal_2a, normal_2_left),
      normal_2_right_rest = ksl_product_rest(q0_1, q1_0, normal_2b, normal_2_right),
      normal_2_cross = normal_2a_cross - normal_2b_cross,
      normal_2_lo1 = normal_2_left_rest - normal_2_right_rest,
      normal_2_lo = normal_2_lo1 + normal_2_cross;
  const double u2_s_size_0 = fabs(R->m20);
  const double u2_s_size_1 = fabs(R->m21);
  const double u2_s_size_2 = fabs(R->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = KSL_MUL(R->m20, u2_s);
  const double u2_y_1 = KSL_MUL(R->m21, u2_s);
  const double u2_y_2 = KSL_MUL(R->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = KSL_MUL(u2_y_0, u2_y_0), u2_n_b = KSL_MUL(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_c_right = u2_n_c - u2_n_a, u2_n_c_left = u2_n_c - u2_n_c_right,
      u2_n_c_left_rest = ksl_product_rest(u2_y_0, u2_y_0, u2_n_a, u2_n_c_left),
      u2_n_c_right_rest = ksl_product_rest(u2_y_1, u2_y_1, u2_n_b, u2_n_c_right),
      u2_n_c_lo = u2_n_c_left_rest + u2_n_c_right_rest, u2_n_d = KSL_MUL(u2_y_2, u2_y_2),
      u2_n_e = u2_n_c + u2_n_d, u2_n_e_right = u2_n_e - u2_n_c, u2_n_e_left = u2_n_e - u2_n_e_right,
      u2_n_e_left_rest = u2_n_c - u2_n_e_left,
      u2_n_e_right_rest = ksl_product_rest(u2_y_2, u2_y_2, u2_n_d, u2_n_e_right),
      u2_n_e_lo1 = u2_n_e_left_rest + u2_n_e_right_rest, u2_n_e_lo = u2_n_e_lo1 + u2_n_c_lo,
      u2_n_of_u2_n_e = u2_n_e + u2_n_e_lo, u2_n_of_u2_n_e_right = u2_n_of_u2_n_e - u2_n_e,
      u2_n_of_u2_n_e_left = u2_n_of_u2_n_e - u2_n_of_u2_n_e_right,
      u2_n_of_u2_n_e_left_rest = u2_n_e - u2_n_of_u2_n_e_left,
      u2_n_of_u2_n_e_right_rest = u2_n_e_lo - u2_n_of_u2_n_e_right,
      u2_n_of_u2_n_e_lo = u2_n_of_u2_n_e_left_rest + u2_n_of_u2_n_e_right_rest,
      u2_n = sqrt(u2_n_of_u2_n_e), u2_n_product = KSL_MUL(u2_n, u2_n),
      u2_n_product_error = ksl_product_error(u2_n, u2_n, u2_n_product),
      u2_n_rest = u2_n_of_u2_n_e - u2_n_product, u2_n_exact = u2_n_rest - u2_n_product_error,
      u2_n_residual = u2_n_exact + u2_n_of_u2_n_e_lo, u2_n_twice = u2_n + u2_n,
      u2_n_divisor = u2_n == 0.0 ? 1.0 : u2_n_twice, u2_n_lo = u2_n_residual / u2_n_divisor;
  const double u2_divisor_a_of_u2_n = u2_n + u2_n_lo,
      u2_divisor_a_of_u2_n_right = u2_divisor_a_of_u2_n - u2_n,
      u2_divisor_a_of_u2_n_left = u2_divisor_a_of_u2_n - u2_divisor_a_of_u2_n_right,
      u2_divisor_a_of_u2_n_left_rest = u2_n - u2_divisor_a_of_u2_n_left,
      u2_divisor_a_of_u2_n_right_rest = u2_n_lo - u2_divisor_a_of_u2_n_right,
      u2_divisor_a_of_u2_n_lo = u2_divisor_a_of_u2_n_left_rest + u2_divisor_a_of_u2_n_right_rest,
      u2_divisor = u2_divisor_a_of_u2_n == 0.0 ? u2_up : u2_divisor_a_of_u2_n,
      u2_divisor_lo = u2_divisor_a_of_u2_n == 0.0 ? 0.0 : u2_divisor_a_of_u2_n_lo;
  const double u2_sized_0 = KSL_MUL(R->m20, u2_up);
  const double u2_sized_1 = KSL_MUL(R->m21, u2_up);
  const double u2_sized_2 = KSL_MUL(R->m22, u2_up);
  const double u2_quotient_0_of_u2_divisor = u2_divisor + u2_divisor_lo,
      u2_quotient_0_of_u2_divisor_right = u2_quotient_0_of_u2_divisor - u2_divisor,
      u2_quotient_0_of_u2_divisor_left = u2_quotient_0_of_u2_divisor -
          u2_quotient_0_of_u2_divisor_right,
      u2_quotient_0_of_u2_divisor_left_rest = u2_divisor - u2_quotient_0_of_u2_divisor_left,
      u2_quotient_0_of_u2_divisor_right_rest = u2_divisor_lo - u2_quotient_0_of_u2_divisor_right,
      u2_quotient_0_of_u2_divisor_lo = u2_quotient_0_of_u2_divisor_left_rest +
          u2_quotient_0_of_u2_divisor_right_rest,
      u2_quotient_0 = u2_sized_0 / u2_quotient_0_of_u2_divisor,
      u2_quotient_0_product = KSL_MUL(u2_quotient_0, u2_quotient_0_of_u2_divisor),
      u2_quotient_0_product_error = ksl_product_error(u2_quotient_0, u2_quotient_0_of_u2_divisor,
          u2_quotient_0_product),
      u2_quotient_0_rest = u2_sized_0 - u2_quotient_0_product,
      u2_quotient_0_exact = u2_quotient_0_rest - u2_quotient_0_product_error,
      u2_quotient_0_cross = KSL_MUL(u2_quotient_0, u2_quotient_0_of_u2_divisor_lo),
      u2_quotient_0_residual = u2_quotient_0_exact - u2_quotient_0_cross,
      u2_quotient_0_lo = u2_quotient_0_residual / u2_quotient_0_of_u2_divisor;
  const double u2_quotient_1 = u2_sized_1 / u2_quotient_0_of_u2_divisor,
      u2_quotient_1_product = KSL_MUL(u2_quotient_1, u2_quotient_0_of_u2_divisor),
      u2_quotient_1_product_error = ksl_product_error(u2_quotient_1, u2_quotient_0_of_u2_divisor,
          u2_quotient_1_product),
      u2_quotient_1_rest = u2_sized_1 - u2_quotient_1_product,
      u2_quotient_1_exact = u2_quotient_1_rest - u2_quotient_1_product_error,
      u2_quotient_1_cross = KSL_MUL(u2_quotient_1, u2_quotient_0_of_u2_divisor_lo),
      u2_quotient_1_residual = u2_quotient_1_exact - u2_quotient_1_cross,
      u2_quotient_1_lo = u2_quotient_1_residual / u2_quotient_0_of_u2_divisor;
  const double u2_quotient_2 = u2_sized_2 / u2_quotient_0_of_u2_divisor,
      u2_quotient_2_product = KSL_MUL(u2_quotient_2, u2_quotient_0_of_u2_divisor),
      u2_quotient_2_product_error = ksl_product_error(u2_quotient_2, u2_quotient_0_of_u2_divisor,
          u2_quotient_2_product),
      u2_quotient_2_rest = u2_sized_2 - u2_quotient_2_product,
      u2_quotient_2_exact = u2_quotient_2_rest - u2_quotient_2_product_error,
      u2_quotient_2_cross = KSL_MUL(u2_quotient_2, u2_quotient_0_of_u2_divisor_lo),
      u2_quotient_2_residual = u2_quotient_2_exact - u2_quotient_2_cross,
      u2_quotient_2_lo = u2_quotient_2_residual / u2_quotient_0_of_u2_divisor;
  const double u2_0_of_u2_quotient_0 = u2_quotient_0 + u2_quotient_0_lo,
      u2_0_of_u2_quotient_0_right = u2_0_of_u2_quotient_0 - u2_quotient_0,
      u2_0_of_u2_quotient_0_left = u2_0_of_u2_quotient_0 - u2_0_of_u2_quotient_0_right,
      u2_0_of_u2_quotient_0_left_rest = u2_quotient_0 - u2_0_of_u2_quotient_0_left,
      u2_0_of_u2_quotient_0_right_rest = u2_quotient_0_lo - u2_0_of_u2_quotient_0_right,
      u2_0_of_u2_quotient_0_lo = u2_0_of_u2_quotient_0_left_rest + u2_0_of_u2_quotient_0_right_rest,
      u2_0 = KSL_MUL(u2_0_of_u2_quotient_0, u2_down), u2_0_inverse = 1.0 / u2_down,
      u2_0_back = KSL_MUL(u2_0, u2_0_inverse), u2_0_lost = u2_0_of_u2_quotient_0 - u2_0_back,
      u2_0_rest = u2_0_lost + u2_0_of_u2_quotient_0_lo, u2_0_lo = KSL_MUL(u2_0_rest, u2_down);
  const double u2_1_of_u2_quotient_1 = u2_quotient_1 + u2_quotient_1_lo,
      u2_1_of_u2_quotient_1_right = u2_1_of_u2_quotient_1 - u2_quotient_1,
      u2_1_of_u2_quotient_1_left = u2_1_of_u2_quotient_1 - u2_1_of_u2_quotient_1_right,
      u2_1_of_u2_quotient_1_left_rest = u2_quotient_1 - u2_1_of_u2_quotient_1_left,
      u2_1_of_u2_quotient_1_right_rest = u2_quotient_1_lo - u2_1_of_u2_quotient_1_right,
      u2_1_of_u2_quotient_1_lo = u2_1_of_u2_quotient_1_left_rest + u2_1_of_u2_quotient_1_right_rest,
      u2_1 = KSL_MUL(u2_1_of_u2_quotient_1, u2_down), u2_1_back = KSL_MUL(u2_1, u2_0_inverse),
      u2_1_lost = u2_1_of_u2_quotient_1 - u2_1_back,
      u2_1_rest = u2_1_lost + u2_1_of_u2_quotient_1_lo, u2_1_lo = KSL_MUL(u2_1_rest, u2_down);
  const double u2_2_of_u2_quotient_2 = u2_quotient_2 + u2_quotient_2_lo,
      u2_2_of_u2_quotient_2_right = u2_2_of_u2_quotient_2 - u2_quotient_2,
      u2_2_of_u2_quotient_2_left = u2_2_of_u2_quotient_2 - u2_2_of_u2_quotient_2_right,
      u2_2_of_u2_quotient_2_left_rest = u2_quotient_2 - u2_2_of_u2_quotient_2_left,
      u2_2_of_u2_quotient_2_right_rest = u2_quotient_2_lo - u2_2_of_u2_quotient_2_right,
      u2_2_of_u2_quotient_2_lo = u2_2_of_u2_quotient_2_left_rest + u2_2_of_u2_quotient_2_right_rest,
      u2_2 = KSL_MUL(u2_2_of_u2_quotient_2, u2_down), u2_2_back = KSL_MUL(u2_2, u2_0_inverse),
      u2_2_lost = u2_2_of_u2_quotient_2 - u2_2_back,
      u2_2_rest = u2_2_lost + u2_2_of_u2_quotient_2_lo, u2_2_lo = KSL_MUL(u2_2_rest, u2_down);
  const double side_a = KSL_MUL(normal_0, u2_0), side_a_cross1 = KSL_MUL(normal_0_lo, u2_0),
      side_a_cross2 = KSL_MUL(normal_0, u2_0_lo), side_a_cross = side_a_cross1 + side_a_cross2,
      side_b = KSL_MUL(normal_1, u2_1), side_b_cross1 = KSL_MUL(normal_1_lo, u2_1),
      side_b_cross2 = KSL_MUL(normal_1, u2_1_lo), side_b_cross = side_b_cross1 + side_b_cross2,
      side_c = side_a + side_b, side_c_right = side_c - side_a, side_c_left = side_c - side_c_right,
      side_c_left_rest = ksl_product_rest(normal_0, u2_0, side_a, side_c_left),
      side_c_right_rest = ksl_product_rest(normal_1, u2_1, side_b, side_c_right),
      side_c_cross = side_a_cross + side_b_cross, side_c_lo1 = side_c_left_rest + side_c_right_rest,
      side_c_lo = side_c_lo1 + side_c_cross, side_d = KSL_MUL(normal_2, u2_2),
      side_d_cross1 = KSL_MUL(normal_2_lo, u2_2), side_d_cross2 = KSL_MUL(normal_2, u2_2_lo),
      side_d_cross = side_d_cross1 + side_d_cross2, side = side_c + side_d,
      side_right = side - side_c, side_left = side - side_right,
      side_left_rest = side_c - side_left,
      side_right_rest = ksl_product_rest(normal_2, u2_2, side_d, side_right),
      side_lo1 = side_left_rest + side_right_rest, side_lo2 = side_lo1 + side_d_cross,
      side_lo = side_lo2 + side_c_lo;
  const double q2_0a = -normal_0, q2_0a_lo = -normal_0_lo, q2_0b_of_side = side + side_lo,
      q2_0b_of_side_right = q2_0b_of_side - side,
      q2_0b_of_side_left = q2_0b_of_side - q2_0b_of_side_right,
      q2_0b_of_side_left_rest = side - q2_0b_of_side_left,
      q2_0b_of_side_right_rest = side_lo - q2_0b_of_side_right,
      q2_0b_of_side_lo = q2_0b_of_side_left_rest + q2_0b_of_side_right_rest,
      q2_0 = q2_0b_of_side < 0.0 ? q2_0a : normal_0,
      q2_0_lo = q2_0b_of_side < 0.0 ? q2_0a_lo : normal_0_lo;
  const double q2_1a = -normal_1, q2_1a_lo = -normal_1_lo,
      q2_1 = q2_0b_of_side < 0.0 ? q2_1a : normal_1,
      q2_1_lo = q2_0b_of_side < 0.0 ? q2_1a_lo : normal_1_lo;
  const double q2_2a = -normal_2, q2_2a_lo = -normal_2_lo,
      q2_2 = q2_0b_of_side < 0.0 ? q2_2a : normal_2,
      q2_2_lo = q2_0b_of_side < 0.0 ? q2_2a_lo : normal_2_lo;
  const double size = fabs(q2_0b_of_side), size_opposite = -q2_0b_of_side_lo,
      size_lo = q2_0b_of_side < 0.0 ? size_opposite : q2_0b_of_side_lo;
  const double less_a_of_size = size + size_lo, less_a_of_size_right = less_a_of_size - size,
      less_a_of_size_left = less_a_of_size - less_a_of_size_right,
      less_a_of_size_left_rest = size - less_a_of_size_left,
      less_a_of_size_right_rest = size_lo - less_a_of_size_right,
      less_a_of_size_lo = less_a_of_size_left_rest + less_a_of_size_right_rest,
      less = divisor_a_of_n < less_a_of_size ? divisor_a_of_n : less_a_of_size,
      less_lo = divisor_a_of_n < less_a_of_size ? divisor_a_of_n_lo : less_a_of_size_lo;
  const double dependent_a_of_less = less + less_lo,
      dependent = dependent_a_of_less < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double Ro_00 = dependent == 1.0 ? (double)NAN : q0_0,
      Ro_00_lo = dependent == 1.0 ? 0.0 : q0_0_lo;
  const double Ro_01 = dependent == 1.0 ? (double)NAN : q0_1,
      Ro_01_lo = dependent == 1.0 ? 0.0 : q0_1_lo;
  const double Ro_02 = dependent == 1.0 ? (double)NAN : q0_2,
      Ro_02_lo = dependent == 1.0 ? 0.0 : q0_2_lo;
  const double Ro_10 = dependent == 1.0 ? (double)NAN : q1_0,
      Ro_10_lo = dependent == 1.0 ? 0.0 : q1_0_lo;
  const double Ro_11 = dependent == 1.0 ? (double)NAN : q1_1,
      Ro_11_lo = dependent == 1.0 ? 0.0 : q1_1_lo;
  const double Ro_12 = dependent == 1.0 ? (double)NAN : q1_2,
      Ro_12_lo = dependent == 1.0 ? 0.0 : q1_2_lo;
  const double Ro_20 = dependent == 1.0 ? (double)NAN : q2_0,
      Ro_20_lo = dependent == 1.0 ? 0.0 : q2_0_lo;
  const double Ro_21 = dependent == 1.0 ? (double)NAN : q2_1,
      Ro_21_lo = dependent == 1.0 ? 0.0 : q2_1_lo;
  const double Ro_22 = dependent == 1.0 ? (double)NAN : q2_2,
      Ro_22_lo = dependent == 1.0 ? 0.0 : q2_2_lo;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo,
      Ro_00_final = Ro_00_rounded == Ro_00_rounded ? Ro_00_rounded : Ro_00;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo,
      Ro_01_final = Ro_01_rounded == Ro_01_rounded ? Ro_01_rounded : Ro_01;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo,
      Ro_02_final = Ro_02_rounded == Ro_02_rounded ? Ro_02_rounded : Ro_02;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo,
      Ro_10_final = Ro_10_rounded == Ro_10_rounded ? Ro_10_rounded : Ro_10;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo,
      Ro_11_final = Ro_11_rounded == Ro_11_rounded ? Ro_11_rounded : Ro_11;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo,
      Ro_12_final = Ro_12_rounded == Ro_12_rounded ? Ro_12_rounded : Ro_12;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo,
      Ro_20_final = Ro_20_rounded == Ro_20_rounded ? Ro_20_rounded : Ro_20;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo,
      Ro_21_final = Ro_21_rounded == Ro_21_rounded ? Ro_21_rounded : Ro_21;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo,
      Ro_22_final = Ro_22_rounded == Ro_22_rounded ? Ro_22_rounded : Ro_22;
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
      versine_left = versine + versine_right, versine_left_rest = 1.0 - versine_left,
      versine_right_rest = dc[1] - versine_right,
      versine_lo = versine_left_rest - versine_right_rest;
  const double versine_axis_0 = KSL_MUL(axis->x, versine),
      versine_axis_0_cross2 = KSL_MUL(axis->x, versine_lo);
  const double versine_axis_1 = KSL_MUL(axis->y, versine),
      versine_axis_1_cross2 = KSL_MUL(axis->y, versine_lo);
  const double versine_axis_2 = KSL_MUL(axis->z, versine),
      versine_axis_2_cross2 = KSL_MUL(axis->z, versine_lo);
  const double versine_axis_0_error = ksl_product_error(axis->x, versine, versine_axis_0),
      versine_axis_0_lo = versine_axis_0_error + versine_axis_0_cross2,
      m_0 = KSL_MUL(axis->x, versine_axis_0), m_0_cross2 = KSL_MUL(axis->x, versine_axis_0_lo);
  const double versine_axis_1_error = ksl_product_error(axis->y, versine, versine_axis_1),
      versine_axis_1_lo = versine_axis_1_error + versine_axis_1_cross2,
      m_1 = KSL_MUL(axis->y, versine_axis_1), m_1_cross2 = KSL_MUL(axis->y, versine_axis_1_lo);
  const double versine_axis_2_error = ksl_product_error(axis->z, versine, versine_axis_2),
      versine_axis_2_lo = versine_axis_2_error + versine_axis_2_cross2,
      m_2 = KSL_MUL(axis->z, versine_axis_2), m_2_cross2 = KSL_MUL(axis->z, versine_axis_2_lo);
  const double m_3 = KSL_MUL(axis->y, versine_axis_0),
      m_3_cross2 = KSL_MUL(axis->y, versine_axis_0_lo);
  const double m_4 = KSL_MUL(axis->z, versine_axis_0),
      m_4_cross2 = KSL_MUL(axis->z, versine_axis_0_lo);
  const double m_5 = KSL_MUL(axis->z, versine_axis_1),
      m_5_cross2 = KSL_MUL(axis->z, versine_axis_1_lo);
  const double sine_axis_0 = KSL_MUL(axis->x, dc[0]);
  const double sine_axis_1 = KSL_MUL(axis->y, dc[0]);
  const double sine_axis_2 = KSL_MUL(axis->z, dc[0]);
  const double R_00 = dc[1] + m_0, R_00_right = R_00 - dc[1], R_00_left = R_00 - R_00_right,
      R_00_left_rest = dc[1] - R_00_left,
      R_00_right_rest = ksl_product_rest(axis->x, versine_axis_0, m_0, R_00_right),
      R_00_lo1 = R_00_left_rest + R_00_right_rest, R_00_lo = R_00_lo1 + m_0_cross2;
  const double R_01 = m_3 - sine_axis_2, R_01_right = m_3 - R_01, R_01_left = R_01 + R_01_right,
      R_01_left_rest = ksl_product_rest(axis->y, versine_axis_0, m_3, R_01_left),
      R_01_right_rest = ksl_product_rest(axis->z, dc[0], sine_axis_2, R_01_right),
      R_01_lo1 = R_01_left_rest - R_01_right_rest, R_01_lo = R_01_lo1 + m_3_cross2;
  const double R_02 = m_4 + sine_axis_1, R_02_right = R_02 - m_4, R_02_left = R_02 - R_02_right,
      R_02_left_rest = ksl_product_rest(axis->z, versine_axis_0, m_4, R_02_left),
      R_02_right_rest = ksl_product_rest(axis->y, dc[0], sine_axis_1, R_02_right),
      R_02_lo1 = R_02_left_rest + R_02_right_rest, R_02_lo = R_02_lo1 + m_4_cross2;
  const double R_10 = m_3 + sine_axis_2, R_10_right = R_10 - m_3, R_10_left = R_10 - R_10_right,
      R_10_left_rest = ksl_product_rest(axis->y, versine_axis_0, m_3, R_10_left),
      R_10_right_rest = ksl_product_rest(axis->z, dc[0], sine_axis_2, R_10_right),
      R_10_lo1 = R_10_left_rest + R_10_right_rest, R_10_lo = R_10_lo1 + m_3_cross2;
  const double R_11 = dc[1] + m_1, R_11_right = R_11 - dc[1], R_11_left = R_11 - R_11_right,
      R_11_left_rest = dc[1] - R_11_left,
      R_11_right_rest = ksl_product_rest(axis->y, versine_axis_1, m_1, R_11_right),
      R_11_lo1 = R_11_left_rest + R_11_right_rest, R_11_lo = R_11_lo1 + m_1_cross2;
  const double R_12 = m_5 - sine_axis_0, R_12_right = m_5 - R_12, R_12_left = R_12 + R_12_right,
      R_12_left_rest = ksl_product_rest(axis->z, versine_axis_1, m_5, R_12_left),
      R_12_right_rest = ksl_product_rest(axis->x, dc[0], sine_axis_0, R_12_right),
      R_12_lo1 = R_12_left_rest - R_12_right_rest, R_12_lo = R_12_lo1 + m_5_cross2;
  const double R_20 = m_4 - sine_axis_1, R_20_right = m_4 - R_20, R_20_left = R_20 + R_20_right,
      R_20_left_rest = ksl_product_rest(axis->z, versine_axis_0, m_4, R_20_left),
      R_20_right_rest = ksl_product_rest(axis->y, dc[0], sine_axis_1, R_20_right),
      R_20_lo1 = R_20_left_rest - R_20_right_rest, R_20_lo = R_20_lo1 + m_4_cross2;
  const double R_21 = m_5 + sine_axis_0, R_21_right = R_21 - m_5, R_21_left = R_21 - R_21_right,
      R_21_left_rest = ksl_product_rest(axis->z, versine_axis_1, m_5, R_21_left),
      R_21_right_rest = ksl_product_rest(axis->x, dc[0], sine_axis_0, R_21_right),
      R_21_lo1 = R_21_left_rest + R_21_right_rest, R_21_lo = R_21_lo1 + m_5_cross2;
  const double R_22 = dc[1] + m_2, R_22_right = R_22 - dc[1], R_22_left = R_22 - R_22_right,
      R_22_left_rest = dc[1] - R_22_left,
      R_22_right_rest = ksl_product_rest(axis->z, versine_axis_2, m_2, R_22_right),
      R_22_lo1 = R_22_left_rest + R_22_right_rest, R_22_lo = R_22_lo1 + m_2_cross2;
  const double R_00_rounded = R_00 + R_00_lo;
  const double R_01_rounded = R_01 + R_01_lo;
  const double R_02_rounded = R_02 + R_02_lo;
  const double R_10_rounded = R_10 + R_10_lo;
  const double R_11_rounded = R_11 + R_11_lo;
  const double R_12_rounded = R_12 + R_12_lo;
  const double R_20_rounded = R_20 + R_20_lo;
  const double R_21_rounded = R_21 + R_21_lo;
  const double R_22_rounded = R_22 + R_22_lo;
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
  const double first_0 = KSL_MUL(c_1, c_2), first_0_cross1 = KSL_MUL(c_1_own_error, c_2),
      first_0_cross2 = KSL_MUL(c_1, c_2_own_error), first_0_cross = first_0_cross1 + first_0_cross2;
  const double first_1a = KSL_MUL(s_2, c_1), first_1a_cross1 = KSL_MUL(s_2_own_error, c_1),
      first_1a_cross2 = KSL_MUL(s_2, c_1_own_error),
      first_1a_cross = first_1a_cross1 + first_1a_cross2, first_1 = -first_1a,
      first_1_cross = -first_1a_cross, first_1_factor = -s_2;
  const double first_6a = KSL_MUL(s_1, c_2), first_6a_cross1 = KSL_MUL(s_1_own_error, c_2),
      first_6a_cross2 = KSL_MUL(s_1, c_2_own_error),
      first_6a_cross = first_6a_cross1 + first_6a_cross2, first_6 = -first_6a,
      first_6_cross = -first_6a_cross, first_6_factor = -s_1;
  const double first_7 = KSL_MUL(s_1, s_2), first_7_cross1 = KSL_MUL(s_1_own_error, s_2),
      first_7_cross2 = KSL_MUL(s_1, s_2_own_error), first_7_cross = first_7_cross1 + first_7_cross2;
  const double last_3a = KSL_MUL(s_2, c_0), last_3a_cross1 = KSL_MUL(s_2_own_error, c_0),
      last_3a_cross2 = KSL_MUL(s_2, c_0_own_error), last_3a_cross = last_3a_cross1 + last_3a_cross2,
      first_6_error = ksl_product_error(first_6_factor, c_2, first_6),
      first_6_lo = first_6_error + first_6_cross, last_3b = KSL_MUL(s_0, first_6),
      last_3b_cross1 = KSL_MUL(s_0_own_error, first_6), last_3b_cross2 = KSL_MUL(s_0, first_6_lo),
      last_3b_cross = last_3b_cross1 + last_3b_cross2, last_3 = last_3a - last_3b,
      last_3_right = last_3a - last_3, last_3_left = last_3 + last_3_right,
      last_3_left_rest = ksl_product_rest(s_2, c_0, last_3a, last_3_left),
      last_3_right_rest = ksl_product_rest(s_0, first_6, last_3b, last_3_right),
      last_3_cross = last_3a_cross - last_3b_cross,
      last_3_lo1 = last_3_left_rest - last_3_right_rest, last_3_lo = last_3_lo1 + last_3_cross;
  const double last_4a = KSL_MUL(c_0, c_2), last_4a_cross1 = KSL_MUL(c_0_own_error, c_2),
      last_4a_cross2 = KSL_MUL(c_0, c_2_own_error), last_4a_cross = last_4a_cross1 + last_4a_cross2,
      first_7_error = ksl_product_error(s_1, s_2, first_7),
      first_7_lo = first_7_error + first_7_cross, last_4b = KSL_MUL(s_0, first_7),
      last_4b_cross1 = KSL_MUL(s_0_own_error, first_7), last_4b_cross2 = KSL_MUL(s_0, first_7_lo),
      last_4b_cross = last_4b_cross1 + last_4b_cross2, last_4 = last_4a - last_4b,
      last_4_right = last_4a - last_4, last_4_left = last_4 + last_4_right,
      last_4_left_rest = ksl_product_rest(c_0, c_2, last_4a, last_4_left),
      last_4_right_rest = ksl_product_rest(s_0, first_7, last_4b, last_4_right),
      last_4_cross = last_4a_cross - last_4b_cross,
      last_4_lo1 = last_4_left_rest - last_4_right_rest, last_4_lo = last_4_lo1 + last_4_cross;
  const double last_5a = KSL_MUL(s_0, c_1), last_5a_cross1 = KSL_MUL(s_0_own_error, c_1),
      last_5a_cross2 = KSL_MUL(s_0, c_1_own_error), last_5a_cross = last_5a_cross1 + last_5a_cross2,
      last_5 = -last_5a, last_5_cross = -last_5a_cross, last_5_factor = -s_0;
  const double last_6a = KSL_MUL(s_0, s_2), last_6a_cross1 = KSL_MUL(s_0_own_error, s_2),
      last_6a_cross2 = KSL_MUL(s_0, s_2_own_error), last_6a_cross = last_6a_cross1 + last_6a_cross2,
      last_6b = KSL_MUL(c_0, first_6), last_6b_cross1 = KSL_MUL(c_0_own_error, first_6),
      last_6b_cross2 = KSL_MUL(c_0, first_6_lo), last_6b_cross = last_6b_cross1 + last_6b_cross2,
      last_6 = last_6a + last_6b, last_6_right = last_6 - last_6a,
      last_6_left = last_6 - last_6_right,
      last_6_left_rest = ksl_product_rest(s_0, s_2, last_6a, last_6_left),
      last_6_right_rest = ksl_product_rest(c_0, first_6, last_6b, last_6_right),
      last_6_cross = last_6a_cross + last_6b_cross,
      last_6_lo1 = last_6_left_rest + last_6_right_rest, last_6_lo = last_6_lo1 + last_6_cross;
  const double last_7a = KSL_MUL(s_0, c_2), last_7a_cross1 = KSL_MUL(s_0_own_error, c_2),
      last_7a_cross2 = KSL_MUL(s_0, c_2_own_error), last_7a_cross = last_7a_cross1 + last_7a_cross2,
      last_7b = KSL_MUL(c_0, first_7), last_7b_cross1 = KSL_MUL(c_0_own_error, first_7),
      last_7b_cross2 = KSL_MUL(c_0, first_7_lo), last_7b_cross = last_7b_cross1 + last_7b_cross2,
      last_7 = last_7a + last_7b, last_7_right = last_7 - last_7a,
      last_7_left = last_7 - last_7_right,
      last_7_left_rest = ksl_product_rest(s_0, c_2, last_7a, last_7_left),
      last_7_right_rest = ksl_product_rest(c_0, first_7, last_7b, last_7_right),
      last_7_cross = last_7a_cross + last_7b_cross,
      last_7_lo1 = last_7_left_rest + last_7_right_rest, last_7_lo = last_7_lo1 + last_7_cross;
  const double last_8 = KSL_MUL(c_0, c_1), last_8_cross1 = KSL_MUL(c_0_own_error, c_1),
      last_8_cross2 = KSL_MUL(c_0, c_1_own_error), last_8_cross = last_8_cross1 + last_8_cross2;
  const double first_0_error = ksl_product_error(c_1, c_2, first_0),
      first_0_lo = first_0_error + first_0_cross, first_0_rounded = first_0 + first_0_lo,
      first_0_final = first_0_rounded == first_0_rounded ? first_0_rounded : first_0;
  const double first_1_error = ksl_product_error(first_1_factor, c_1, first_1),
      first_1_lo = first_1_error + first_1_cross, first_1_rounded = first_1 + first_1_lo,
      first_1_final = first_1_rounded == first_1_rounded ? first_1_rounded : first_1;
  const double s_1_rounded = s_1 + s_1_own_error,
      s_1_final = s_1_rounded == s_1_rounded ? s_1_rounded : s_1;
  const double last_3_rounded = last_3 + last_3_lo,
      last_3_final = last_3_rounded == last_3_rounded ? last_3_rounded : last_3;
  const double last_4_rounded = last_4 + last_4_lo,
      last_4_final = last_4_rounded == last_4_rounded ? last_4_rounded : last_4;
  const double last_5_error = ksl_product_error(last_5_factor, c_1, last_5),
      last_5_lo = last_5_error + last_5_cross, last_5_rounded = last_5 + last_5_lo,
      last_5_final = last_5_rounded == last_5_rounded ? last_5_rounded : last_5;
  const double last_6_rounded = last_6 + last_6_lo,
      last_6_final = last_6_rounded == last_6_rounded ? last_6_rounded : last_6;
  const double last_7_rounded = last_7 + last_7_lo,
      last_7_final = last_7_rounded == last_7_rounded ? last_7_rounded : last_7;
  const double last_8_error = ksl_product_error(c_0, c_1, last_8),
      last_8_lo = last_8_error + last_8_cross, last_8_rounded = last_8 + last_8_lo,
      last_8_final = last_8_rounded == last_8_rounded ? last_8_rounded : last_8;
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
      n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(R->m00, R->m00, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(R->m01, R->m01, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_of_n_c = n_c + n_c_lo,
      n_of_n_c_right = n_of_n_c - n_c, n_of_n_c_left = n_of_n_c - n_of_n_c_right,
      n_of_n_c_left_rest = n_c - n_of_n_c_left, n_of_n_c_right_rest = n_c_lo - n_of_n_c_right,
      n_of_n_c_lo = n_of_n_c_left_rest + n_of_n_c_right_rest, n = sqrt(n_of_n_c),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_c - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_c_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double divisor_a_of_n = n + n_lo, divisor_a_of_n_right = divisor_a_of_n - n,
      divisor_a_of_n_left = divisor_a_of_n - divisor_a_of_n_right,
      divisor_a_of_n_left_rest = n - divisor_a_of_n_left,
      divisor_a_of_n_right_rest = n_lo - divisor_a_of_n_right,
      divisor_a_of_n_lo = divisor_a_of_n_left_rest + divisor_a_of_n_right_rest,
      divisor = divisor_a_of_n == 0.0 ? 1.0 : divisor_a_of_n,
      divisor_lo = divisor_a_of_n == 0.0 ? 0.0 : divisor_a_of_n_lo;
  const double cosine_a_of_divisor = divisor + divisor_lo,
      cosine_a_of_divisor_right = cosine_a_of_divisor - divisor,
      cosine_a_of_divisor_left = cosine_a_of_divisor - cosine_a_of_divisor_right,
      cosine_a_of_divisor_left_rest = divisor - cosine_a_of_divisor_left,
      cosine_a_of_divisor_right_rest = divisor_lo - cosine_a_of_divisor_right,
      cosine_a_of_divisor_lo = cosine_a_of_divisor_left_rest + cosine_a_of_divisor_right_rest,
      cosine_a = R->m00 / cosine_a_of_divisor,
      cosine_a_product = KSL_MUL(cosine_a, cosine_a_of_divisor),
      cosine_a_product_error = ksl_product_error(cosine_a, cosine_a_of_divisor, cosine_a_product),
      cosine_a_rest = R->m00 - cosine_a_product,
      cosine_a_exact = cosine_a_rest - cosine_a_product_error,
      cosine_a_cross = KSL_MUL(cosine_a, cosine_a_of_divisor_lo),
      cosine_a_residual = cosine_a_exact - cosine_a_cross,
      cosine_a_lo = cosine_a_residual / cosine_a_of_divisor,
      cosine = divisor_a_of_n == 0.0 ? 1.0 : cosine_a,
      cosine_lo = divisor_a_of_n == 0.0 ? 0.0 : cosine_a_lo;
  const double sine_a = -R->m01, sine = sine_a / cosine_a_of_divisor,
      sine_product = KSL_MUL(sine, cosine_a_of_divisor),
      sine_product_error = ksl_product_error(sine, cosine_a_of_divisor, sine_product),
      sine_rest = sine_a - sine_product, sine_exact = sine_rest - sine_product_error,
      sine_cross = KSL_MUL(sine, cosine_a_of_divisor_lo), sine_residual = sine_exact - sine_cross,
      sine_lo = sine_residual / cosine_a_of_divisor;
  const double polar = ksl_atan2(sine_a, R->m00),
      polar_own_error = ksl_atan2_error(sine_a, R->m00, polar);
  const double third = divisor_a_of_n == 0.0 ? 0.0 : polar,
      third_lo = divisor_a_of_n == 0.0 ? 0.0 : polar_own_error;
  const double left_1a = KSL_MUL(R->m10, sine), left_1a_cross2 = KSL_MUL(R->m10, sine_lo),
      left_1b = KSL_MUL(R->m11, cosine), left_1b_cross2 = KSL_MUL(R->m11, cosine_lo),
      left_1 = left_1a + left_1b, left_1_right = left_1 - left_1a,
      left_1_left = left_1 - left_1_right,
      left_1_left_rest = ksl_product_rest(R->m10, sine, left_1a, left_1_left),
      left_1_right_rest = ksl_product_rest(R->m11, cosine, left_1b, left_1_right),
      left_1_cross = left_1a_cross2 + left_1b_cross2,
      left_1_lo1 = left_1_left_rest + left_1_right_rest, left_1_lo = left_1_lo1 + left_1_cross;
  const double left_2a = KSL_MUL(R->m20, sine), left_2a_cross2 = KSL_MUL(R->m20, sine_lo),
      left_2b = KSL_MUL(R->m21, cosine), left_2b_cross2 = KSL_MUL(R->m21, cosine_lo),
      left_2 = left_2a + left_2b, left_2_right = left_2 - left_2a,
      left_2_left = left_2 - left_2_right,
      left_2_left_rest = ksl_product_rest(R->m20, sine, left_2a, left_2_left),
      left_2_right_rest = ksl_product_rest(R->m21, cosine, left_2b, left_2_right),
      left_2_cross = left_2a_cross2 + left_2b_cross2,
      left_2_lo1 = left_2_left_rest + left_2_right_rest, left_2_lo = left_2_lo1 + left_2_cross;
  const double rest = R->m12 + R->m22, rest_right = rest - R->m12, rest_left = rest - rest_right,
      rest_left_rest = R->m12 - rest_left, rest_right_rest = R->m22 - rest_right,
      rest_lo = rest_left_rest + rest_right_rest;
  const double first_of_left_2 = left_2 + left_2_lo,
      first_of_left_2_right = first_of_left_2 - left_2,
      first_of_left_2_left = first_of_left_2 - first_of_left_2_right,
      first_of_left_2_left_rest = left_2 - first_of_left_2_left,
      first_of_left_2_right_rest = left_2_lo - first_of_left_2_right,
      first_of_left_2_lo = first_of_left_2_left_rest + first_of_left_2_right_rest,
      first_of_left_1 = left_1 + left_1_lo, first_of_left_1_right = first_of_left_1 - left_1,
      first_of_left_1_left = first_of_left_1 - first_of_left_1_right,
      first_of_left_1_left_rest = left_1 - first_of_left_1_left,
      first_of_left_1_right_rest = left_1_lo - first_of_left_1_right,
      first_of_left_1_lo = first_of_left_1_left_rest + first_of_left_1_right_rest,
      first = ksl_atan2(first_of_left_2, first_of_left_1),
      first_own_error = ksl_atan2_error(first_of_left_2, first_of_left_1, first),
      first_size0 = fabs(first_of_left_2), first_size1 = fabs(first_of_left_1),
      first_most = first_size0 < first_size1 ? first_size1 : first_size0,
      first_divisor = first_most == 0.0 ? 1.0 : first_most,
      first_part0 = first_of_left_2 / first_divisor, first_part1 = first_of_left_1 / first_divisor,
      first_cross1 = KSL_MUL(first_part1, first_of_left_2_lo),
      first_cross2 = KSL_MUL(first_part0, first_of_left_1_lo),
      first_square1 = KSL_MUL(first_part1, first_part1),
      first_square2 = KSL_MUL(first_part0, first_part0), first_cross = first_cross1 - first_cross2,
      first_square = first_square1 + first_square2,
      first_divisor2 = KSL_MUL(first_divisor, first_square),
      first_safe = first_most == 0.0 ? 1.0 : first_divisor2, first_more = first_cross / first_safe,
      first_lo = first_own_error + first_more;
  const double angles_0a_of_rest = rest + rest_lo,
      angles_0a_of_rest_right = angles_0a_of_rest - rest,
      angles_0a_of_rest_left = angles_0a_of_rest - angles_0a_of_rest_right,
      angles_0a_of_rest_left_rest = rest - angles_0a_of_rest_left,
      angles_0a_of_rest_right_rest = rest_lo - angles_0a_of_rest_right,
      angles_0a_of_rest_lo = angles_0a_of_rest_left_rest + angles_0a_of_rest_right_rest,
      angles_0 = angles_0a_of_rest < 1.2676506002282294e+30 ? first : angles_0a_of_rest,
      angles_0_lo = angles_0a_of_rest < 1.2676506002282294e+30 ? first_lo : angles_0a_of_rest_lo;
  const double angles_1 = ksl_atan2(R->m02, divisor_a_of_n),
      angles_1_own_error = ksl_atan2_error(R->m02, divisor_a_of_n, angles_1),
      angles_1_size0 = fabs(R->m02), angles_1_size1 = fabs(divisor_a_of_n),
      angles_1_most = angles_1_size0 < angles_1_size1 ? angles_1_size1 : angles_1_size0,
      angles_1_divisor = angles_1_most == 0.0 ? 1.0 : angles_1_most,
      angles_1_part0 = R->m02 / angles_1_divisor,
      angles_1_part1 = divisor_a_of_n / angles_1_divisor,
      angles_1_cross1 = KSL_MUL(angles_1_part1, 0.0),
      angles_1_cross2 = KSL_MUL(angles_1_part0, divisor_a_of_n_lo),
      angles_1_square1 = KSL_MUL(angles_1_part1, angles_1_part1),
      angles_1_square2 = KSL_MUL(angles_1_part0, angles_1_part0),
      angles_1_cross = angles_1_cross1 - angles_1_cross2,
      angles_1_square = angles_1_square1 + angles_1_square2,
      angles_1_divisor2 = KSL_MUL(angles_1_divisor, angles_1_square),
      angles_1_safe = angles_1_most == 0.0 ? 1.0 : angles_1_divisor2,
      angles_1_more = angles_1_cross / angles_1_safe,
      angles_1_lo = angles_1_own_error + angles_1_more;
  const double angles_0_rounded = angles_0 + angles_0_lo,
      angles_0_final = angles_0_rounded == angles_0_rounded ? angles_0_rounded : angles_0;
  const double angles_1_rounded = angles_1 + angles_1_lo,
      angles_1_final = angles_1_rounded == angles_1_rounded ? angles_1_rounded : angles_1;
  const double third_rounded = third + third_lo,
      third_final = third_rounded == third_rounded ? third_rounded : third;
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
  const double first_1 = KSL_MUL(s_1, s_2), first_1_cross1 = KSL_MUL(s_1_own_error, s_2),
      first_1_cross2 = KSL_MUL(s_1, s_2_own_error), first_1_cross = first_1_cross1 + first_1_cross2;
  const double first_2 = KSL_MUL(s_1, c_2), first_2_cross1 = KSL_MUL(s_1_own_error, c_2),
      first_2_cross2 = KSL_MUL(s_1, c_2_own_error), first_2_cross = first_2_cross1 + first_2_cross2;
  const double first_7 = KSL_MUL(s_2, c_1), first_7_cross1 = KSL_MUL(s_2_own_error, c_1),
      first_7_cross2 = KSL_MUL(s_2, c_1_own_error), first_7_cross = first_7_cross1 + first_7_cross2;
  const double first_8 = KSL_MUL(c_1, c_2), first_8_cross1 = KSL_MUL(c_1_own_error, c_2),
      first_8_cross2 = KSL_MUL(c_1, c_2_own_error), first_8_cross = first_8_cross1 + first_8_cross2;
  const double last_3 = KSL_MUL(s_0, s_1), last_3_cross1 = KSL_MUL(s_0_own_error, s_1),
      last_3_cross2 = KSL_MUL(s_0, s_1_own_error), last_3_cross = last_3_cross1 + last_3_cross2;
  const double last_4a = KSL_MUL(c_0, c_2), last_4a_cross1 = KSL_MUL(c_0_own_error, c_2),
      last_4a_cross2 = KSL_MUL(c_0, c_2_own_error), last_4a_cross = last_4a_cross1 + last_4a_cross2,
      first_7_error = ksl_product_error(s_2, c_1, first_7),
      first_7_lo = first_7_error + first_7_cross, last_4b = KSL_MUL(s_0, first_7),
      last_4b_cross1 = KSL_MUL(s_0_own_error, first_7), last_4b_cross2 = KSL_MUL(s_0, first_7_lo),
      last_4b_cross = last_4b_cross1 + last_4b_cross2, last_4 = last_4a - last_4b,
      last_4_right = last_4a - last_4, last_4_left = last_4 + last_4_right,
      last_4_left_rest = ksl_product_rest(c_0, c_2, last_4a, last_4_left),
      last_4_right_rest = ksl_product_rest(s_0, first_7, last_4b, last_4_right),
      last_4_cross = last_4a_cross - last_4b_cross,
      last_4_lo1 = last_4_left_rest - last_4_right_rest, last_4_lo = last_4_lo1 + last_4_cross;
  const double first_8_error = ksl_product_error(c_1, c_2, first_8),
      first_8_lo = first_8_error + first_8_cross, last_5a = KSL_MUL(s_0, first_8),
      last_5a_cross1 = KSL_MUL(s_0_own_error, first_8), last_5a_cross2 = KSL_MUL(s_0, first_8_lo),
      last_5a_cross = last_5a_cross1 + last_5a_cross2, last_5b = KSL_MUL(s_2, c_0),
      last_5b_cross1 = KSL_MUL(s_2_own_error, c_0), last_5b_cross2 = KSL_MUL(s_2, c_0_own_error),
      last_5b_cross = last_5b_cross1 + last_5b_cross2, last_5c = last_5a + last_5b,
      last_5c_right = last_5c - last_5a, last_5c_left = last_5c - last_5c_right,
      last_5c_left_rest = ksl_product_rest(s_0, first_8, last_5a, last_5c_left),
      last_5c_right_rest = ksl_product_rest(s_2, c_0, last_5b, last_5c_right),
      last_5c_cross = last_5a_cross + last_5b_cross,
      last_5c_lo1 = last_5c_left_rest + last_5c_right_rest,
      last_5c_lo = last_5c_lo1 + last_5c_cross, last_5 = -last_5c, last_5_lo = -last_5c_lo;
  const double last_6a = KSL_MUL(s_1, c_0), last_6a_cross1 = KSL_MUL(s_1_own_error, c_0),
      last_6a_cross2 = KSL_MUL(s_1, c_0_own_error), last_6a_cross = last_6a_cross1 + last_6a_cross2,
      last_6 = -last_6a, last_6_cross = -last_6a_cross, last_6_factor = -s_1;
  const double last_7a = KSL_MUL(s_0, c_2), last_7a_cross1 = KSL_MUL(s_0_own_error, c_2),
      last_7a_cross2 = KSL_MUL(s_0, c_2_own_error), last_7a_cross = last_7a_cross1 + last_7a_cross2,
      last_7b = KSL_MUL(c_0, first_7), last_7b_cross1 = KSL_MUL(c_0_own_error, first_7),
      last_7b_cross2 = KSL_MUL(c_0, first_7_lo), last_7b_cross = last_7b_cross1 + last_7b_cross2,
      last_7 = last_7a + last_7b, last_7_right = last_7 - last_7a,
      last_7_left = last_7 - last_7_right,
      last_7_left_rest = ksl_product_rest(s_0, c_2, last_7a, last_7_left),
      last_7_right_rest = ksl_product_rest(c_0, first_7, last_7b, last_7_right),
      last_7_cross = last_7a_cross + last_7b_cross,
      last_7_lo1 = last_7_left_rest + last_7_right_rest, last_7_lo = last_7_lo1 + last_7_cross;
  const double last_8a = KSL_MUL(c_0, first_8), last_8a_cross1 = KSL_MUL(c_0_own_error, first_8),
      last_8a_cross2 = KSL_MUL(c_0, first_8_lo), last_8a_cross = last_8a_cross1 + last_8a_cross2,
      last_8b = KSL_MUL(s_0, s_2), last_8b_cross1 = KSL_MUL(s_0_own_error, s_2),
      last_8b_cross2 = KSL_MUL(s_0, s_2_own_error), last_8b_cross = last_8b_cross1 + last_8b_cross2,
      last_8 = last_8a - last_8b, last_8_right = last_8a - last_8,
      last_8_left = last_8 + last_8_right,
      last_8_left_rest = ksl_product_rest(c_0, first_8, last_8a, last_8_left),
      last_8_right_rest = ksl_product_rest(s_0, s_2, last_8b, last_8_right),
      last_8_cross = last_8a_cross - last_8b_cross,
      last_8_lo1 = last_8_left_rest - last_8_right_rest, last_8_lo = last_8_lo1 + last_8_cross;
  const double c_1_rounded = c_1 + c_1_own_error,
      c_1_final = c_1_rounded == c_1_rounded ? c_1_rounded : c_1;
  const double first_1_error = ksl_product_error(s_1, s_2, first_1),
      first_1_lo = first_1_error + first_1_cross, first_1_rounded = first_1 + first_1_lo,
      first_1_final = first_1_rounded == first_1_rounded ? first_1_rounded : first_1;
  const double first_2_error = ksl_product_error(s_1, c_2, first_2),
      first_2_lo = first_2_error + first_2_cross, first_2_rounded = first_2 + first_2_lo,
      first_2_final = first_2_rounded == first_2_rounded ? first_2_rounded : first_2;
  const double last_3_error = ksl_product_error(s_0, s_1, last_3),
      last_3_lo = last_3_error + last_3_cross, last_3_rounded = last_3 + last_3_lo,
      last_3_final = last_3_rounded == last_3_rounded ? last_3_rounded : last_3;
  const double last_4_rounded = last_4 + last_4_lo,
      last_4_final = last_4_rounded == last_4_rounded ? last_4_rounded : last_4;
  const double last_5_rounded = last_5 + last_5_lo,
      last_5_final = last_5_rounded == last_5_rounded ? last_5_rounded : last_5;
  const double last_6_error = ksl_product_error(last_6_factor, c_0, last_6),
      last_6_lo = last_6_error + last_6_cross, last_6_rounded = last_6 + last_6_lo,
      last_6_final = last_6_rounded == last_6_rounded ? last_6_rounded : last_6;
  const double last_7_rounded = last_7 + last_7_lo,
      last_7_final = last_7_rounded == last_7_rounded ? last_7_rounded : last_7;
  const double last_8_rounded = last_8 + last_8_lo,
      last_8_final = last_8_rounded == last_8_rounded ? last_8_rounded : last_8;
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
      n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(R->m01, R->m01, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(R->m02, R->m02, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_of_n_c = n_c + n_c_lo,
      n_of_n_c_right = n_of_n_c - n_c, n_of_n_c_left = n_of_n_c - n_of_n_c_right,
      n_of_n_c_left_rest = n_c - n_of_n_c_left, n_of_n_c_right_rest = n_c_lo - n_of_n_c_right,
      n_of_n_c_lo = n_of_n_c_left_rest + n_of_n_c_right_rest, n = sqrt(n_of_n_c),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_c - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_c_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double divisor_a_of_n = n + n_lo, divisor_a_of_n_right = divisor_a_of_n - n,
      divisor_a_of_n_left = divisor_a_of_n - divisor_a_of_n_right,
      divisor_a_of_n_left_rest = n - divisor_a_of_n_left,
      divisor_a_of_n_right_rest = n_lo - divisor_a_of_n_right,
      divisor_a_of_n_lo = divisor_a_of_n_left_rest + divisor_a_of_n_right_rest,
      divisor = divisor_a_of_n == 0.0 ? 1.0 : divisor_a_of_n,
      divisor_lo = divisor_a_of_n == 0.0 ? 0.0 : divisor_a_of_n_lo;
  const double cosine_a_of_divisor = divisor + divisor_lo,
      cosine_a_of_divisor_right = cosine_a_of_divisor - divisor,
      cosine_a_of_divisor_left = cosine_a_of_divisor - cosine_a_of_divisor_right,
      cosine_a_of_divisor_left_rest = divisor - cosine_a_of_divisor_left,
      cosine_a_of_divisor_right_rest = divisor_lo - cosine_a_of_divisor_right,
      cosine_a_of_divisor_lo = cosine_a_of_divisor_left_rest + cosine_a_of_divisor_right_rest,
      cosine_a = R->m02 / cosine_a_of_divisor,
      cosine_a_product = KSL_MUL(cosine_a, cosine_a_of_divisor),
      cosine_a_product_error = ksl_product_error(cosine_a, cosine_a_of_divisor, cosine_a_product),
      cosine_a_rest = R->m02 - cosine_a_product,
      cosine_a_exact = cosine_a_rest - cosine_a_product_error,
      cosine_a_cross = KSL_MUL(cosine_a, cosine_a_of_divisor_lo),
      cosine_a_residual = cosine_a_exact - cosine_a_cross,
      cosine_a_lo = cosine_a_residual / cosine_a_of_divisor,
      cosine = divisor_a_of_n == 0.0 ? 1.0 : cosine_a,
      cosine_lo = divisor_a_of_n == 0.0 ? 0.0 : cosine_a_lo;
  const double sine = R->m01 / cosine_a_of_divisor,
      sine_product = KSL_MUL(sine, cosine_a_of_divisor),
      sine_product_error = ksl_product_error(sine, cosine_a_of_divisor, sine_product),
      sine_rest = R->m01 - sine_product, sine_exact = sine_rest - sine_product_error,
      sine_cross = KSL_MUL(sine, cosine_a_of_divisor_lo), sine_residual = sine_exact - sine_cross,
      sine_lo = sine_residual / cosine_a_of_divisor;
  const double polar = ksl_atan2(R->m01, R->m02),
      polar_own_error = ksl_atan2_error(R->m01, R->m02, polar);
  const double third = divisor_a_of_n == 0.0 ? 0.0 : polar,
      third_lo = divisor_a_of_n == 0.0 ? 0.0 : polar_own_error;
  const double left_1a = KSL_MUL(R->m11, cosine), left_1a_cross2 = KSL_MUL(R->m11, cosine_lo),
      left_1b = KSL_MUL(R->m12, sine), left_1b_cross2 = KSL_MUL(R->m12, sine_lo),
      left_1 = left_1a - left_1b, left_1_right = left_1a - left_1,
      left_1_left = left_1 + left_1_right,
      left_1_left_rest = ksl_product_rest(R->m11, cosine, left_1a, left_1_left),
      left_1_right_rest = ksl_product_rest(R->m12, sine, left_1b, left_1_right),
      left_1_cross = left_1a_cross2 - left_1b_cross2,
      left_1_lo1 = left_1_left_rest - left_1_right_rest, left_1_lo = left_1_lo1 + left_1_cross;
  const double left_2a = KSL_MUL(R->m21, cosine), left_2a_cross2 = KSL_MUL(R->m21, cosine_lo),
      left_2b = KSL_MUL(R->m22, sine), left_2b_cross2 = KSL_MUL(R->m22, sine_lo),
      left_2 = left_2a - left_2b, left_2_right = left_2a - left_2,
      left_2_left = left_2 + left_2_right,
      left_2_left_rest = ksl_product_rest(R->m21, cosine, left_2a, left_2_left),
      left_2_right_rest = ksl_product_rest(R->m22, sine, left_2b, left_2_right),
      left_2_cross = left_2a_cross2 - left_2b_cross2,
      left_2_lo1 = left_2_left_rest - left_2_right_rest, left_2_lo = left_2_lo1 + left_2_cross;
  const double rest = R->m10 + R->m20, rest_right = rest - R->m10, rest_left = rest - rest_right,
      rest_left_rest = R->m10 - rest_left, rest_right_rest = R->m20 - rest_right,
      rest_lo = rest_left_rest + rest_right_rest;
  const double first_of_left_2 = left_2 + left_2_lo,
      first_of_left_2_right = first_of_left_2 - left_2,
      first_of_left_2_left = first_of_left_2 - first_of_left_2_right,
      first_of_left_2_left_rest = left_2 - first_of_left_2_left,
      first_of_left_2_right_rest = left_2_lo - first_of_left_2_right,
      first_of_left_2_lo = first_of_left_2_left_rest + first_of_left_2_right_rest,
      first_of_left_1 = left_1 + left_1_lo, first_of_left_1_right = first_of_left_1 - left_1,
      first_of_left_1_left = first_of_left_1 - first_of_left_1_right,
      first_of_left_1_left_rest = left_1 - first_of_left_1_left,
      first_of_left_1_right_rest = left_1_lo - first_of_left_1_right,
      first_of_left_1_lo = first_of_left_1_left_rest + first_of_left_1_right_rest,
      first = ksl_atan2(first_of_left_2, first_of_left_1),
      first_own_error = ksl_atan2_error(first_of_left_2, first_of_left_1, first),
      first_size0 = fabs(first_of_left_2), first_size1 = fabs(first_of_left_1),
      first_most = first_size0 < first_size1 ? first_size1 : first_size0,
      first_divisor = first_most == 0.0 ? 1.0 : first_most,
      first_part0 = first_of_left_2 / first_divisor, first_part1 = first_of_left_1 / first_divisor,
      first_cross1 = KSL_MUL(first_part1, first_of_left_2_lo),
      first_cross2 = KSL_MUL(first_part0, first_of_left_1_lo),
      first_square1 = KSL_MUL(first_part1, first_part1),
      first_square2 = KSL_MUL(first_part0, first_part0), first_cross = first_cross1 - first_cross2,
      first_square = first_square1 + first_square2,
      first_divisor2 = KSL_MUL(first_divisor, first_square),
      first_safe = first_most == 0.0 ? 1.0 : first_divisor2, first_more = first_cross / first_safe,
      first_lo = first_own_error + first_more;
  const double angles_0a_of_rest = rest + rest_lo,
      angles_0a_of_rest_right = angles_0a_of_rest - rest,
      angles_0a_of_rest_left = angles_0a_of_rest - angles_0a_of_rest_right,
      angles_0a_of_rest_left_rest = rest - angles_0a_of_rest_left,
      angles_0a_of_rest_right_rest = rest_lo - angles_0a_of_rest_right,
      angles_0a_of_rest_lo = angles_0a_of_rest_left_rest + angles_0a_of_rest_right_rest,
      angles_0 = angles_0a_of_rest < 1.2676506002282294e+30 ? first : angles_0a_of_rest,
      angles_0_lo = angles_0a_of_rest < 1.2676506002282294e+30 ? first_lo : angles_0a_of_rest_lo;
  const double angles_1 = ksl_atan2(divisor_a_of_n, R->m00),
      angles_1_own_error = ksl_atan2_error(divisor_a_of_n, R->m00, angles_1),
      angles_1_size0 = fabs(divisor_a_of_n), angles_1_size1 = fabs(R->m00),
      angles_1_most = angles_1_size0 < angles_1_size1 ? angles_1_size1 : angles_1_size0,
      angles_1_divisor = angles_1_most == 0.0 ? 1.0 : angles_1_most,
      angles_1_part0 = divisor_a_of_n / angles_1_divisor,
      angles_1_part1 = R->m00 / angles_1_divisor,
      angles_1_cross1 = KSL_MUL(angles_1_part1, divisor_a_of_n_lo),
      angles_1_cross2 = KSL_MUL(angles_1_part0, 0.0),
      angles_1_square1 = KSL_MUL(angles_1_part1, angles_1_part1),
      angles_1_square2 = KSL_MUL(angles_1_part0, angles_1_part0),
      angles_1_cross = angles_1_cross1 - angles_1_cross2,
      angles_1_square = angles_1_square1 + angles_1_square2,
      angles_1_divisor2 = KSL_MUL(angles_1_divisor, angles_1_square),
      angles_1_safe = angles_1_most == 0.0 ? 1.0 : angles_1_divisor2,
      angles_1_more = angles_1_cross / angles_1_safe,
      angles_1_lo = angles_1_own_error + angles_1_more;
  const double angles_0_rounded = angles_0 + angles_0_lo,
      angles_0_final = angles_0_rounded == angles_0_rounded ? angles_0_rounded : angles_0;
  const double angles_1_rounded = angles_1 + angles_1_lo,
      angles_1_final = angles_1_rounded == angles_1_rounded ? angles_1_rounded : angles_1;
  const double third_rounded = third + third_lo,
      third_final = third_rounded == third_rounded ? third_rounded : third;
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
      apart_left = apart + apart_right, apart_left_rest = A->m11 - apart_left,
      apart_right_rest = A->m00 - apart_right, apart_lo = apart_left_rest - apart_right_rest;
  const double divisor = twice == 0.0 ? 1.0 : twice;
  const double theta_of_apart = apart + apart_lo, theta_of_apart_right = theta_of_apart - apart,
      theta_of_apart_left = theta_of_apart - theta_of_apart_right,
      theta_of_apart_left_rest = apart - theta_of_apart_left,
      theta_of_apart_right_rest = apart_lo - theta_of_apart_right,
      theta_of_apart_lo = theta_of_apart_left_rest + theta_of_apart_right_rest,
      theta = theta_of_apart / divisor, theta_product = KSL_MUL(theta, divisor),
      theta_product_error = ksl_product_error(theta, divisor, theta_product),
      theta_rest = theta_of_apart - theta_product, theta_exact = theta_rest - theta_product_error,
      theta_numerator = theta_exact + theta_of_apart_lo, theta_lo = theta_numerator / divisor;
  const double magnitude_of_theta = theta + theta_lo,
      magnitude_of_theta_right = magnitude_of_theta - theta,
      magnitude_of_theta_left = magnitude_of_theta - magnitude_of_theta_right,
      magnitude_of_theta_left_rest = theta - magnitude_of_theta_left,
      magnitude_of_theta_right_rest = theta_lo - magnitude_of_theta_right,
      magnitude_of_theta_lo = magnitude_of_theta_left_rest + magnitude_of_theta_right_rest,
      magnitude = fabs(magnitude_of_theta), magnitude_opposite = -magnitude_of_theta_lo,
      magnitude_lo = magnitude_of_theta < 0.0 ? magnitude_opposite : magnitude_of_theta_lo;
  const double size_a = KSL_MUL(magnitude_of_theta, magnitude_of_theta),
      size_a_cross1 = KSL_MUL(magnitude_of_theta_lo, magnitude_of_theta),
      size_a_cross2 = KSL_MUL(magnitude_of_theta, magnitude_of_theta_lo),
      size_a_cross = size_a_cross1 + size_a_cross2, size_b = 1.0 + size_a,
      size_b_right = size_b - 1.0, size_b_left = size_b - size_b_right,
      size_b_left_rest = 1.0 - size_b_left,
      size_b_right_rest = ksl_product_rest(magnitude_of_theta, magnitude_of_theta, size_a,
          size_b_right),
      size_b_lo1 = size_b_left_rest + size_b_right_rest, size_b_lo = size_b_lo1 + size_a_cross,
      size_c_of_size_b = size_b + size_b_lo, size_c_of_size_b_right = size_c_of_size_b - size_b,
      size_c_of_size_b_left = size_c_of_size_b - size_c_of_size_b_right,
      size_c_of_size_b_left_rest = size_b - size_c_of_size_b_left,
      size_c_of_size_b_right_rest = size_b_lo - size_c_of_size_b_right,
      size_c_of_size_b_lo = size_c_of_size_b_left_rest + size_c_of_size_b_right_rest,
      size_c = sqrt(size_c_of_size_b), size_c_product = KSL_MUL(size_c, size_c),
      size_c_product_error = ksl_product_error(size_c, size_c, size_c_product),
      size_c_rest = size_c_of_size_b - size_c_product,
      size_c_exact = size_c_rest - size_c_product_error,
      size_c_residual = size_c_exact + size_c_of_size_b_lo, size_c_twice = size_c + size_c,
      size_c_divisor = size_c == 0.0 ? 1.0 : size_c_twice,
      size_c_lo = size_c_residual / size_c_divisor, size = magnitude + size_c,
      size_right = size - magnitude, size_left = size - size_right,
      size_left_rest = magnitude - size_left, size_right_rest = size_c - size_right,
      size_lo1 = size_left_rest + size_right_rest, size_lo2 = size_lo1 + size_c_lo,
      size_lo = size_lo2 + magnitude_lo;
  const double along_a = -size, along_a_lo = -size_lo,
      along = magnitude_of_theta < 0.0 ? along_a : size,
      along_lo = magnitude_of_theta < 0.0 ? along_a_lo : size_lo;
  const double t_a_of_along = along + along_lo, t_a_of_along_right = t_a_of_along - along,
      t_a_of_along_left = t_a_of_along - t_a_of_along_right,
      t_a_of_along_left_rest = along - t_a_of_along_left,
      t_a_of_along_right_rest = along_lo - t_a_of_along_right,
      t_a_of_along_lo = t_a_of_along_left_rest + t_a_of_along_right_rest, t_a = 1.0 / t_a_of_along,
      t_a_product = KSL_MUL(t_a, t_a_of_along),
      t_a_product_error = ksl_product_error(t_a, t_a_of_along, t_a_product),
      t_a_rest = 1.0 - t_a_product, t_a_exact = t_a_rest - t_a_product_error,
      t_a_cross = KSL_MUL(t_a, t_a_of_along_lo), t_a_residual = t_a_exact - t_a_cross,
      t_a_lo = t_a_residual / t_a_of_along, t = twice == 0.0 ? 0.0 : t_a,
      t_lo = twice == 0.0 ? 0.0 : t_a_lo;
  const double secant_a = KSL_MUL(t, t), secant_a_cross1 = KSL_MUL(t_lo, t),
      secant_a_cross2 = KSL_MUL(t, t_lo), secant_a_cross = secant_a_cross1 + secant_a_cross2,
      secant_b = 1.0 + secant_a, secant_b_right = secant_b - 1.0,
      secant_b_left = secant_b - secant_b_right, secant_b_left_rest = 1.0 - secant_b_left,
      secant_b_right_rest = ksl_product_rest(t, t, secant_a, secant_b_right),
      secant_b_lo1 = secant_b_left_rest + secant_b_right_rest,
      secant_b_lo = secant_b_lo1 + secant_a_cross, secant_of_secant_b = secant_b + secant_b_lo,
      secant_of_secant_b_right = secant_of_secant_b - secant_b,
      secant_of_secant_b_left = secant_of_secant_b - secant_of_secant_b_right,
      secant_of_secant_b_left_rest = secant_b - secant_of_secant_b_left,
      secant_of_secant_b_right_rest = secant_b_lo - secant_of_secant_b_right,
      secant_of_secant_b_lo = secant_of_secant_b_left_rest + secant_of_secant_b_right_rest,
      secant = sqrt(secant_of_secant_b), secant_product = KSL_MUL(secant, secant),
      secant_product_error = ksl_product_error(secant, secant, secant_product),
      secant_rest = secant_of_secant_b - secant_product,
      secant_exact = secant_rest - secant_product_error,
      secant_residual = secant_exact + secant_of_secant_b_lo, secant_twice = secant + secant,
      secant_divisor = secant == 0.0 ? 1.0 : secant_twice,
      secant_lo = secant_residual / secant_divisor;
  const double c_of_secant = secant + secant_lo, c_of_secant_right = c_of_secant - secant,
      c_of_secant_left = c_of_secant - c_of_secant_right,
      c_of_secant_left_rest = secant - c_of_secant_left,
      c_of_secant_right_rest = secant_lo - c_of_secant_right,
      c_of_secant_lo = c_of_secant_left_rest + c_of_secant_right_rest, c = 1.0 / c_of_secant,
      c_product = KSL_MUL(c, c_of_secant),
      c_product_error = ksl_product_error(c, c_of_secant, c_product), c_rest = 1.0 - c_product,
      c_exact = c_rest - c_product_error, c_cross = KSL_MUL(c, c_of_secant_lo),
      c_residual = c_exact - c_cross, c_lo = c_residual / c_of_secant;
  const double s = KSL_MUL(t, c), s_cross1 = KSL_MUL(t_lo, c), s_cross2 = KSL_MUL(t, c_lo),
      s_cross = s_cross1 + s_cross2;
  const double change = KSL_MUL(A->m10, t), change_cross2 = KSL_MUL(A->m10, t_lo);
  const double zp_a = KSL_MUL(A->m20, c), zp_a_cross2 = KSL_MUL(A->m20, c_lo),
      s_error = ksl_product_error(t, c, s), s_lo = s_error + s_cross, zp_b = KSL_MUL(A->m21, s),
      zp_b_cross2 = KSL_MUL(A->m21, s_lo), zp = zp_a - zp_b, zp_right = zp_a - zp,
      zp_left = zp + zp_right, zp_left_rest = ksl_product_rest(A->m20, c, zp_a, zp_left),
      zp_right_rest = ksl_product_rest(A->m21, s, zp_b, zp_right),
      zp_cross = zp_a_cross2 - zp_b_cross2, zp_lo1 = zp_left_rest - zp_right_rest,
      zp_lo = zp_lo1 + zp_cross;
  const double zq_a = KSL_MUL(A->m20, s), zq_a_cross2 = KSL_MUL(A->m20, s_lo),
      zq_b = KSL_MUL(A->m21, c), zq_b_cross2 = KSL_MUL(A->m21, c_lo), zq = zq_a + zq_b,
      zq_right = zq - zq_a, zq_left = zq - zq_right,
      zq_left_rest = ksl_product_rest(A->m20, s, zq_a, zq_left),
      zq_right_rest = ksl_product_rest(A->m21, c, zq_b, zq_right),
      zq_cross = zq_a_cross2 + zq_b_cross2, zq_lo1 = zq_left_rest + zq_right_rest,
      zq_lo = zq_lo1 + zq_cross;
  const double vp_0a = KSL_MUL(V->m00, c), vp_0a_cross2 = KSL_MUL(V->m00, c_lo),
      vp_0b = KSL_MUL(V->m01, s), vp_0b_cross2 = KSL_MUL(V->m01, s_lo), vp_0 = vp_0a - vp_0b,
      vp_0_right = vp_0a - vp_0, vp_0_left = vp_0 + vp_0_right,
      vp_0_left_rest = ksl_product_rest(V->m00, c, vp_0a, vp_0_left),
      vp_0_right_rest = ksl_product_rest(V->m01, s, vp_0b, vp_0_right),
      vp_0_cross = vp_0a_cross2 - vp_0b_cross2, vp_0_lo1 = vp_0_left_rest - vp_0_right_rest,
      vp_0_lo = vp_0_lo1 + vp_0_cross;
  const double vp_1a = KSL_MUL(V->m10, c), vp_1a_cross2 = KSL_MUL(V->m10, c_lo),
      vp_1b = KSL_MUL(V->m11, s), vp_1b_cross2 = KSL_MUL(V->m11, s_lo), vp_1 = vp_1a - vp_1b,
      vp_1_right = vp_1a - vp_1, vp_1_left = vp_1 + vp_1_right,
      vp_1_left_rest = ksl_product_rest(V->m10, c, vp_1a, vp_1_left),
      vp_1_right_rest = ksl_product_rest(V->m11, s, vp_1b, vp_1_right),
      vp_1_cross = vp_1a_cross2 - vp_1b_cross2, vp_1_lo1 = vp_1_left_rest - vp_1_right_rest,
      vp_1_lo = vp_1_lo1 + vp_1_cross;
  const double vp_2a = KSL_MUL(V->m20, c), vp_2a_cross2 = KSL_MUL(V->m20, c_lo),
      vp_2b = KSL_MUL(V->m21, s), vp_2b_cross2 = KSL_MUL(V->m21, s_lo), vp_2 = vp_2a - vp_2b,
      vp_2_right = vp_2a - vp_2, vp_2_left = vp_2 + vp_2_right,
      vp_2_left_rest = ksl_product_rest(V->m20, c, vp_2a, vp_2_left),
      vp_2_right_rest = ksl_product_rest(V->m21, s, vp_2b, vp_2_right),
      vp_2_cross = vp_2a_cross2 - vp_2b_cross2, vp_2_lo1 = vp_2_left_rest - vp_2_right_rest,
      vp_2_lo = vp_2_lo1 + vp_2_cross;
  const double vq_0a = KSL_MUL(V->m00, s), vq_0a_cross2 = KSL_MUL(V->m00, s_lo),
      vq_0b = KSL_MUL(V->m01, c), vq_0b_cross2 = KSL_MUL(V->m01, c_lo), vq_0 = vq_0a + vq_0b,
      vq_0_right = vq_0 - vq_0a, vq_0_left = vq_0 - vq_0_right,
      vq_0_left_rest = ksl_product_rest(V->m00, s, vq_0a, vq_0_left),
      vq_0_right_rest = ksl_product_rest(V->m01, c, vq_0b, vq_0_right),
      vq_0_cross = vq_0a_cross2 + vq_0b_cross2, vq_0_lo1 = vq_0_left_rest + vq_0_right_rest,
      vq_0_lo = vq_0_lo1 + vq_0_cross;
  const double vq_1a = KSL_MUL(V->m10, s), vq_1a_cross2 = KSL_MUL(V->m10, s_lo),
      vq_1b = KSL_MUL(V->m11, c), vq_1b_cross2 = KSL_MUL(V->m11, c_lo), vq_1 = vq_1a + vq_1b,
      vq_1_right = vq_1 - vq_1a, vq_1_left = vq_1 - vq_1_right,
      vq_1_left_rest = ksl_product_rest(V->m10, s, vq_1a, vq_1_left),
      vq_1_right_rest = ksl_product_rest(V->m11, c, vq_1b, vq_1_right),
      vq_1_cross = vq_1a_cross2 + vq_1b_cross2, vq_1_lo1 = vq_1_left_rest + vq_1_right_rest,
      vq_1_lo = vq_1_lo1 + vq_1_cross;
  const double vq_2a = KSL_MUL(V->m20, s), vq_2a_cross2 = KSL_MUL(V->m20, s_lo),
      vq_2b = KSL_MUL(V->m21, c), vq_2b_cross2 = KSL_MUL(V->m21, c_lo), vq_2 = vq_2a + vq_2b,
      vq_2_right = vq_2 - vq_2a, vq_2_left = vq_2 - vq_2_right,
      vq_2_left_rest = ksl_product_rest(V->m20, s, vq_2a, vq_2_left),
      vq_2_right_rest = ksl_product_rest(V->m21, c, vq_2b, vq_2_right),
      vq_2_cross = vq_2a_cross2 + vq_2b_cross2, vq_2_lo1 = vq_2_left_rest + vq_2_right_rest,
      vq_2_lo = vq_2_lo1 + vq_2_cross;
  const double A_00_new = A->m11 + change, A_00_new_right = A_00_new - A->m11,
      A_00_new_left = A_00_new - A_00_new_right, A_00_new_left_rest = A->m11 - A_00_new_left,
      A_00_new_right_rest = ksl_product_rest(A->m10, t, change, A_00_new_right),
      A_00_new_lo1 = A_00_new_left_rest + A_00_new_right_rest,
      A_00_new_lo = A_00_new_lo1 + change_cross2;
  const double A_22_new = A->m00 - change, A_22_new_right = A->m00 - A_22_new,
      A_22_new_left = A_22_new + A_22_new_right, A_22_new_left_rest = A->m00 - A_22_new_left,
      A_22_new_right_rest = ksl_product_rest(A->m10, t, change, A_22_new_right),
      A_22_new_lo1 = A_22_new_left_rest - A_22_new_right_rest,
      A_22_new_lo = A_22_new_lo1 - change_cross2;
  const double A_00_new_rounded = A_00_new + A_00_new_lo,
      A_00_new_final = A_00_new_rounded == A_00_new_rounded ? A_00_new_rounded : A_00_new;
  const double zq_rounded = zq + zq_lo, zq_final = zq_rounded == zq_rounded ? zq_rounded : zq;
  const double zp_rounded = zp + zp_lo, zp_final = zp_rounded == zp_rounded ? zp_rounded : zp;
  const double A_22_new_rounded = A_22_new + A_22_new_lo,
      A_22_new_final = A_22_new_rounded == A_22_new_rounded ? A_22_new_rounded : A_22_new;
  const double vq_0_rounded = vq_0 + vq_0_lo,
      vq_0_final = vq_0_rounded == vq_0_rounded ? vq_0_rounded : vq_0;
  const double vp_0_rounded = vp_0 + vp_0_lo,
      vp_0_final = vp_0_rounded == vp_0_rounded ? vp_0_rounded : vp_0;
  const double vq_1_rounded = vq_1 + vq_1_lo,
      vq_1_final = vq_1_rounded == vq_1_rounded ? vq_1_rounded : vq_1;
  const double vp_1_rounded = vp_1 + vp_1_lo,
      vp_1_final = vp_1_rounded == vp_1_rounded ? vp_1_rounded : vp_1;
  const double vq_2_rounded = vq_2 + vq_2_lo,
      vq_2_final = vq_2_rounded == vq_2_rounded ? vq_2_rounded : vq_2;
  const double vp_2_rounded = vp_2 + vp_2_lo,
      vp_2_final = vp_2_rounded == vp_2_rounded ? vp_2_rounded : vp_2;
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
      n_0_right = n_0a - n_0, n_0_left = n_0 + n_0_right,
      n_0_left_rest = ksl_product_rest(R->m11, R->m22, n_0a, n_0_left),
      n_0_right_rest = ksl_product_rest(R->m12, R->m21, n_0b, n_0_right),
      n_0_lo = n_0_left_rest - n_0_right_rest;
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1b = KSL_MUL(R->m01, R->m22), n_1 = n_1a - n_1b,
      n_1_right = n_1a - n_1, n_1_left = n_1 + n_1_right,
      n_1_left_rest = ksl_product_rest(R->m02, R->m21, n_1a, n_1_left),
      n_1_right_rest = ksl_product_rest(R->m01, R->m22, n_1b, n_1_right),
      n_1_lo = n_1_left_rest - n_1_right_rest;
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2b = KSL_MUL(R->m02, R->m11), n_2 = n_2a - n_2b,
      n_2_right = n_2a - n_2, n_2_left = n_2 + n_2_right,
      n_2_left_rest = ksl_product_rest(R->m01, R->m12, n_2a, n_2_left),
      n_2_right_rest = ksl_product_rest(R->m02, R->m11, n_2b, n_2_right),
      n_2_lo = n_2_left_rest - n_2_right_rest;
  const double det_a = KSL_MUL(R->m00, n_0), det_a_cross2 = KSL_MUL(R->m00, n_0_lo),
      det_b = KSL_MUL(R->m10, n_1), det_b_cross2 = KSL_MUL(R->m10, n_1_lo), det_c = det_a + det_b,
      det_c_right = det_c - det_a, det_c_left = det_c - det_c_right,
      det_c_left_rest = ksl_product_rest(R->m00, n_0, det_a, det_c_left),
      det_c_right_rest = ksl_product_rest(R->m10, n_1, det_b, det_c_right),
      det_c_cross = det_a_cross2 + det_b_cross2, det_c_lo1 = det_c_left_rest + det_c_right_rest,
      det_c_lo = det_c_lo1 + det_c_cross, det_d = KSL_MUL(R->m20, n_2),
      det_d_cross2 = KSL_MUL(R->m20, n_2_lo), det = det_c + det_d, det_right = det - det_c,
      det_left = det - det_right, det_left_rest = det_c - det_left,
      det_right_rest = ksl_product_rest(R->m20, n_2, det_d, det_right),
      det_lo1 = det_left_rest + det_right_rest, det_lo2 = det_lo1 + det_d_cross2,
      det_lo = det_lo2 + det_c_lo;
  const double g_0a = KSL_MUL(R->m00, R->m00), g_0b = KSL_MUL(R->m10, R->m10), g_0c = g_0a + g_0b,
      g_0c_right = g_0c - g_0a, g_0c_left = g_0c - g_0c_right,
      g_0c_left_rest = ksl_product_rest(R->m00, R->m00, g_0a, g_0c_left),
      g_0c_right_rest = ksl_product_rest(R->m10, R->m10, g_0b, g_0c_right),
      g_0c_lo = g_0c_left_rest + g_0c_right_rest, g_0d = KSL_MUL(R->m20, R->m20), g_0 = g_0c + g_0d,
      g_0_right = g_0 - g_0c, g_0_left = g_0 - g_0_right, g_0_left_rest = g_0c - g_0_left,
      g_0_right_rest = ksl_product_rest(R->m20, R->m20, g_0d, g_0_right),
      g_0_lo1 = g_0_left_rest + g_0_right_rest, g_0_lo = g_0_lo1 + g_0c_lo;
  const double g_1a = KSL_MUL(R->m00, R->m01), g_1b = KSL_MUL(R->m10, R->m11), g_1c = g_1a + g_1b,
      g_1c_right = g_1c - g_1a, g_1c_left = g_1c - g_1c_right,
      g_1c_left_rest = ksl_product_rest(R->m00, R->m01, g_1a, g_1c_left),
      g_1c_right_rest = ksl_product_rest(R->m10, R->m11, g_1b, g_1c_right),
      g_1c_lo = g_1c_left_rest + g_1c_right_rest, g_1d = KSL_MUL(R->m20, R->m21), g_1 = g_1c + g_1d,
      g_1_right = g_1 - g_1c, g_1_left = g_1 - g_1_right, g_1_left_rest = g_1c - g_1_left,
      g_1_right_rest = ksl_product_rest(R->m20, R->m21, g_1d, g_1_right),
      g_1_lo1 = g_1_left_rest + g_1_right_rest, g_1_lo = g_1_lo1 + g_1c_lo;
  const double g_2a = KSL_MUL(R->m00, R->m02), g_2b = KSL_MUL(R->m10, R->m12), g_2c = g_2a + g_2b,
      g_2c_right = g_2c - g_2a, g_2c_left = g_2c - g_2c_right,
      g_2c_left_rest = ksl_product_rest(R->m00, R->m02, g_2a, g_2c_left),
      g_2c_right_rest = ksl_product_rest(R->m10, R->m12, g_2b, g_2c_right),
      g_2c_lo = g_2c_left_rest + g_2c_right_rest, g_2d = KSL_MUL(R->m20, R->m22), g_2 = g_2c + g_2d,
      g_2_right = g_2 - g_2c, g_2_left = g_2 - g_2_right, g_2_left_rest = g_2c - g_2_left,
      g_2_right_rest = ksl_product_rest(R->m20, R->m22, g_2d, g_2_right),
      g_2_lo1 = g_2_left_rest + g_2_right_rest, g_2_lo = g_2_lo1 + g_2c_lo;
  const double g_3a = KSL_MUL(R->m01, R->m01), g_3b = KSL_MUL(R->m11, R->m11), g_3c = g_3a + g_3b,
      g_3c_right = g_3c - g_3a, g_3c_left = g_3c - g_3c_right,
      g_3c_left_rest = ksl_product_rest(R->m01, R->m01, g_3a, g_3c_left),
      g_3c_right_rest = ksl_product_rest(R->m11, R->m11, g_3b, g_3c_right),
      g_3c_lo = g_3c_left_rest + g_3c_right_rest, g_3d = KSL_MUL(R->m21, R->m21), g_3 = g_3c + g_3d,
      g_3_right = g_3 - g_3c, g_3_left = g_3 - g_3_right, g_3_left_rest = g_3c - g_3_left,
      g_3_right_rest = ksl_product_rest(R->m21, R->m21, g_3d, g_3_right),
      g_3_lo1 = g_3_left_rest + g_3_right_rest, g_3_lo = g_3_lo1 + g_3c_lo;
  const double g_4a = KSL_MUL(R->m01, R->m02), g_4b = KSL_MUL(R->m11, R->m12), g_4c = g_4a + g_4b,
      g_4c_right = g_4c - g_4a, g_4c_left = g_4c - g_4c_right,
      g_4c_left_rest = ksl_product_rest(R->m01, R->m02, g_4a, g_4c_left),
      g_4c_right_rest = ksl_product_rest(R->m11, R->m12, g_4b, g_4c_right),
      g_4c_lo = g_4c_left_rest + g_4c_right_rest, g_4d = KSL_MUL(R->m21, R->m22), g_4 = g_4c + g_4d,
      g_4_right = g_4 - g_4c, g_4_left = g_4 - g_4_right, g_4_left_rest = g_4c - g_4_left,
      g_4_right_rest = ksl_product_rest(R->m21, R->m22, g_4d, g_4_right),
      g_4_lo1 = g_4_left_rest + g_4_right_rest, g_4_lo = g_4_lo1 + g_4c_lo;
  const double g_5a = KSL_MUL(R->m02, R->m02), g_5b = KSL_MUL(R->m12, R->m12), g_5c = g_5a + g_5b,
      g_5c_right = g_5c - g_5a, g_5c_left = g_5c - g_5c_right,
      g_5c_left_rest = ksl_product_rest(R->m02, R->m02, g_5a, g_5c_left),
      g_5c_right_rest = ksl_product_rest(R->m12, R->m12, g_5b, g_5c_right),
      g_5c_lo = g_5c_left_rest + g_5c_right_rest, g_5d = KSL_MUL(R->m22, R->m22), g_5 = g_5c + g_5d,
      g_5_right = g_5 - g_5c, g_5_left = g_5 - g_5_right, g_5_left_rest = g_5c - g_5_left,
      g_5_right_rest = ksl_product_rest(R->m22, R->m22, g_5d, g_5_right),
      g_5_lo1 = g_5_left_rest + g_5_right_rest, g_5_lo = g_5_lo1 + g_5c_lo;
  const double off_0 = det - 1.0, off_0_right = det - off_0, off_0_left = off_0 + off_0_right,
      off_0_left_rest = det - off_0_left, off_0_right_rest = 1.0 - off_0_right,
      off_0_lo1 = off_0_left_rest - off_0_right_rest, off_0_lo = off_0_lo1 + det_lo;
  const double off_1 = g_0 - 1.0, off_1_right = g_0 - off_1, off_1_left = off_1 + off_1_right,
      off_1_left_rest = g_0 - off_1_left, off_1_right_rest = 1.0 - off_1_right,
      off_1_lo1 = off_1_left_rest - off_1_right_rest, off_1_lo = off_1_lo1 + g_0_lo;
  const double off_4 = g_3 - 1.0, off_4_right = g_3 - off_4, off_4_left = off_4 + off_4_right,
      off_4_left_rest = g_3 - off_4_left, off_4_right_rest = 1.0 - off_4_right,
      off_4_lo1 = off_4_left_rest - off_4_right_rest, off_4_lo = off_4_lo1 + g_3_lo;
  const double off_6 = g_5 - 1.0, off_6_right = g_5 - off_6, off_6_left = off_6 + off_6_right,
      off_6_left_rest = g_5 - off_6_left, off_6_right_rest = 1.0 - off_6_right,
      off_6_lo1 = off_6_left_rest - off_6_right_rest, off_6_lo = off_6_lo1 + g_5_lo;
  const double defect_size_0_of_off_0 = off_0 + off_0_lo,
      defect_size_0_of_off_0_right = defect_size_0_of_off_0 - off_0,
      defect_size_0_of_off_0_left = defect_size_0_of_off_0 - defect_size_0_of_off_0_right,
      defect_size_0_of_off_0_left_rest = off_0 - defect_size_0_of_off_0_left,
      defect_size_0_of_off_0_right_rest = off_0_lo - defect_size_0_of_off_0_right,
      defect_size_0_of_off_0_lo = defect_size_0_of_off_0_left_rest +
          defect_size_0_of_off_0_right_rest,
      defect_size_0 = fabs(defect_size_0_of_off_0),
      defect_size_0_opposite = -defect_size_0_of_off_0_lo,
      defect_size_0_lo = defect_size_0_of_off_0 < 0.0 ? defect_size_0_opposite :
          defect_size_0_of_off_0_lo;
  const double defect_size_1_of_off_1 = off_1 + off_1_lo,
      defect_size_1_of_off_1_right = defect_size_1_of_off_1 - off_1,
      defect_size_1_of_off_1_left = defect_size_1_of_off_1 - defect_size_1_of_off_1_right,
      defect_size_1_of_off_1_left_rest = off_1 - defect_size_1_of_off_1_left,
      defect_size_1_of_off_1_right_rest = off_1_lo - defect_size_1_of_off_1_right,
      defect_size_1_of_off_1_lo = defect_size_1_of_off_1_left_rest +
          defect_size_1_of_off_1_right_rest,
      defect_size_1 = fabs(defect_size_1_of_off_1),
      defect_size_1_opposite = -defect_size_1_of_off_1_lo,
      defect_size_1_lo = defect_size_1_of_off_1 < 0.0 ? defect_size_1_opposite :
          defect_size_1_of_off_1_lo;
  const double defect_size_2_of_g_1 = g_1 + g_1_lo,
      defect_size_2_of_g_1_right = defect_size_2_of_g_1 - g_1,
      defect_size_2_of_g_1_left = defect_size_2_of_g_1 - defect_size_2_of_g_1_right,
      defect_size_2_of_g_1_left_rest = g_1 - defect_size_2_of_g_1_left,
      defect_size_2_of_g_1_right_rest = g_1_lo - defect_size_2_of_g_1_right,
      defect_size_2_of_g_1_lo = defect_size_2_of_g_1_left_rest + defect_size_2_of_g_1_right_rest,
      defect_size_2 = fabs(defect_size_2_of_g_1), defect_size_2_opposite = -defect_size_2_of_g_1_lo,
      defect_size_2_lo = defect_size_2_of_g_1 < 0.0 ? defect_size_2_opposite :
          defect_size_2_of_g_1_lo;
  const double defect_size_3_of_g_2 = g_2 + g_2_lo,
      defect_size_3_of_g_2_right = defect_size_3_of_g_2 - g_2,
      defect_size_3_of_g_2_left = defect_size_3_of_g_2 - defect_size_3_of_g_2_right,
      defect_size_3_of_g_2_left_rest = g_2 - defect_size_3_of_g_2_left,
      defect_size_3_of_g_2_right_rest = g_2_lo - defect_size_3_of_g_2_right,
      defect_size_3_of_g_2_lo = defect_size_3_of_g_2_left_rest + defect_size_3_of_g_2_right_rest,
      defect_size_3 = fabs(defect_size_3_of_g_2), defect_size_3_opposite = -defect_size_3_of_g_2_lo,
      defect_size_3_lo = defect_size_3_of_g_2 < 0.0 ? defect_size_3_opposite :
          defect_size_3_of_g_2_lo;
  const double defect_size_4_of_off_4 = off_4 + off_4_lo,
      defect_size_4_of_off_4_right = defect_size_4_of_off_4 - off_4,
      defect_size_4_of_off_4_left = defect_size_4_of_off_4 - defect_size_4_of_off_4_right,
      defect_size_4_of_off_4_left_rest = off_4 - defect_size_4_of_off_4_left,
      defect_size_4_of_off_4_right_rest = off_4_lo - defect_size_4_of_off_4_right,
      defect_size_4_of_off_4_lo = defect_size_4_of_off_4_left_rest +
          defect_size_4_of_off_4_right_rest,
      defect_size_4 = fabs(defect_size_4_of_off_4),
      defect_size_4_opposite = -defect_size_4_of_off_4_lo,
      defect_size_4_lo = defect_size_4_of_off_4 < 0.0 ? defect_size_4_opposite :
          defect_size_4_of_off_4_lo;
  const double defect_size_5_of_g_4 = g_4 + g_4_lo,
      defect_size_5_of_g_4_right = defect_size_5_of_g_4 - g_4,
      defect_size_5_of_g_4_left = defect_size_5_of_g_4 - defect_size_5_of_g_4_right,
      defect_size_5_of_g_4_left_rest = g_4 - defect_size_5_of_g_4_left,
      defect_size_5_of_g_4_right_rest = g_4_lo - defect_size_5_of_g_4_right,
      defect_size_5_of_g_4_lo = defect_size_5_of_g_4_left_rest + defect_size_5_of_g_4_right_rest,
      defect_size_5 = fabs(defect_size_5_of_g_4), defect_size_5_opposite = -defect_size_5_of_g_4_lo,
      defect_size_5_lo = defect_size_5_of_g_4 < 0.0 ? defect_size_5_opposite :
          defect_size_5_of_g_4_lo;
  const double defect_size_6_of_off_6 = off_6 + off_6_lo,
      defect_size_6_of_off_6_right = defect_size_6_of_off_6 - off_6,
      defect_size_6_of_off_6_left = defect_size_6_of_off_6 - defect_size_6_of_off_6_right,
      defect_size_6_of_off_6_left_rest = off_6 - defect_size_6_of_off_6_left,
      defect_size_6_of_off_6_right_rest = off_6_lo - defect_size_6_of_off_6_right,
      defect_size_6_of_off_6_lo = defect_size_6_of_off_6_left_rest +
          defect_size_6_of_off_6_right_rest,
      defect_size_6 = fabs(defect_size_6_of_off_6),
      defect_size_6_opposite = -defect_size_6_of_off_6_lo,
      defect_size_6_lo = defect_size_6_of_off_6 < 0.0 ? defect_size_6_opposite :
          defect_size_6_of_off_6_lo;
  const double defect_largest1a_of_defect_size_0 = defect_size_0 + defect_size_0_lo,
      defect_largest1a_of_defect_size_0_right = defect_largest1a_of_defect_size_0 - defect_size_0,
      defect_largest1a_of_defect_size_0_left = defect_largest1a_of_defect_size_0 -
          defect_largest1a_of_defect_size_0_right,
      defect_largest1a_of_defect_size_0_left_rest = defect_size_0 -
          defect_largest1a_of_defect_size_0_left,
      defect_largest1a_of_defect_size_0_right_rest = defect_size_0_lo -
          defect_largest1a_of_defect_size_0_right,
      defect_largest1a_of_defect_size_0_lo = defect_largest1a_of_defect_size_0_left_rest +
          defect_largest1a_of_defect_size_0_right_rest,
      defect_largest1a_of_defect_size_1 = defect_size_1 + defect_size_1_lo,
      defect_largest1a_of_defect_size_1_right = defect_largest1a_of_defect_size_1 - defect_size_1,
      defect_largest1a_of_defect_size_1_left = defect_largest1a_of_defect_size_1 -
          defect_largest1a_of_defect_size_1_right,
      defect_largest1a_of_defect_size_1_left_rest = defect_size_1 -
          defect_largest1a_of_defect_size_1_left,
      defect_largest1a_of_defect_size_1_right_rest = defect_size_1_lo -
          defect_largest1a_of_defect_size_1_right,
      defect_largest1a_of_defect_size_1_lo = defect_largest1a_of_defect_size_1_left_rest +
          defect_largest1a_of_defect_size_1_right_rest,
      defect_largest1 = defect_largest1a_of_defect_size_0 < defect_largest1a_of_defect_size_1 ?
          defect_largest1a_of_defect_size_1 : defect_largest1a_of_defect_size_0,
      defect_largest1_lo = defect_largest1a_of_defect_size_0 < defect_largest1a_of_defect_size_1 ?
          defect_largest1a_of_defect_size_1_lo : defect_largest1a_of_defect_size_0_lo;
  const double defect_largest2a_of_defect_largest1 = defect_largest1 + defect_largest1_lo,
      defect_largest2a_of_defect_largest1_right = defect_largest2a_of_defect_largest1 -
          defect_largest1,
      defect_largest2a_of_defect_largest1_left = defect_largest2a_of_defect_largest1 -
          defect_largest2a_of_defect_largest1_right,
      defect_largest2a_of_defect_largest1_left_rest = defect_largest1 -
          defect_largest2a_of_defect_largest1_left,
      defect_largest2a_of_defect_largest1_right_rest = defect_largest1_lo -
          defect_largest2a_of_defect_largest1_right,
      defect_largest2a_of_defect_largest1_lo = defect_largest2a_of_defect_largest1_left_rest +
          defect_largest2a_of_defect_largest1_right_rest,
      defect_largest2a_of_defect_size_2 = defect_size_2 + defect_size_2_lo,
      defect_largest2a_of_defect_size_2_right = defect_largest2a_of_defect_size_2 - defect_size_2,
      defect_largest2a_of_defect_size_2_left = defect_largest2a_of_defect_size_2 -
          defect_largest2a_of_defect_size_2_right,
      defect_largest2a_of_defect_size_2_left_rest = defect_size_2 -
          defect_largest2a_of_defect_size_2_left,
      defect_largest2a_of_defect_size_2_right_rest = defect_size_2_lo -
          defect_largest2a_of_defect_size_2_right,
      defect_largest2a_of_defect_size_2_lo = defect_largest2a_of_defect_size_2_left_rest +
          defect_largest2a_of_defect_size_2_right_rest,
      defect_largest2 = defect_largest2a_of_defect_largest1 < defect_largest2a_of_defect_size_2 ?
          defect_largest2a_of_defect_size_2 : defect_largest2a_of_defect_largest1,
      defect_largest2_lo = defect_largest2a_of_defect_largest1 < defect_largest2a_of_defect_size_2 ?
          defect_largest2a_of_defect_size_2_lo : defect_largest2a_of_defect_largest1_lo;
  const double defect_largest3a_of_defect_largest2 = defect_largest2 + defect_largest2_lo,
      defect_largest3a_of_defect_largest2_right = defect_largest3a_of_defect_largest2 -
          defect_largest2,
      defect_largest3a_of_defect_largest2_left = defect_largest3a_of_defect_largest2 -
          defect_largest3a_of_defect_largest2_right,
      defect_largest3a_of_defect_largest2_left_rest = defect_largest2 -
          defect_largest3a_of_defect_largest2_left,
      defect_largest3a_of_defect_largest2_right_rest = defect_largest2_lo -
          defect_largest3a_of_defect_largest2_right,
      defect_largest3a_of_defect_largest2_lo = defect_largest3a_of_defect_largest2_left_rest +
          defect_largest3a_of_defect_largest2_right_rest,
      defect_largest3a_of_defect_size_3 = defect_size_3 + defect_size_3_lo,
      defect_largest3a_of_defect_size_3_right = defect_largest3a_of_defect_size_3 - defect_size_3,
      defect_largest3a_of_defect_size_3_left = defect_largest3a_of_defect_size_3 -
          defect_largest3a_of_defect_size_3_right,
      defect_largest3a_of_defect_size_3_left_rest = defect_size_3 -
          defect_largest3a_of_defect_size_3_left,
      defect_largest3a_of_defect_size_3_right_rest = defect_size_3_lo -
          defect_largest3a_of_defect_size_3_right,
      defect_largest3a_of_defect_size_3_lo = defect_largest3a_of_defect_size_3_left_rest +
          defect_largest3a_of_defect_size_3_right_rest,
      defect_largest3 = defect_largest3a_of_defect_largest2 < defect_largest3a_of_defect_size_3 ?
          defect_largest3a_of_defect_size_3 : defect_largest3a_of_defect_largest2,
      defect_largest3_lo = defect_largest3a_of_defect_largest2 < defect_largest3a_of_defect_size_3 ?
          defect_largest3a_of_defect_size_3_lo : defect_largest3a_of_defect_largest2_lo;
  const double defect_largest4a_of_defect_largest3 = defect_largest3 + defect_largest3_lo,
      defect_largest4a_of_defect_largest3_right = defect_largest4a_of_defect_largest3 -
          defect_largest3,
      defect_largest4a_of_defect_largest3_left = defect_largest4a_of_defect_largest3 -
          defect_largest4a_of_defect_largest3_right,
      defect_largest4a_of_defect_largest3_left_rest = defect_largest3 -
          defect_largest4a_of_defect_largest3_left,
      defect_largest4a_of_defect_largest3_right_rest = defect_largest3_lo -
          defect_largest4a_of_defect_largest3_right,
      defect_largest4a_of_defect_largest3_lo = defect_largest4a_of_defect_largest3_left_rest +
          defect_largest4a_of_defect_largest3_right_rest,
      defect_largest4a_of_defect_size_4 = defect_size_4 + defect_size_4_lo,
      defect_largest4a_of_defect_size_4_right = defect_largest4a_of_defect_size_4 - defect_size_4,
      defect_largest4a_of_defect_size_4_left = defect_largest4a_of_defect_size_4 -
          defect_largest4a_of_defect_size_4_right,
      defect_largest4a_of_defect_size_4_left_rest = defect_size_4 -
          defect_largest4a_of_defect_size_4_left,
      defect_largest4a_of_defect_size_4_right_rest = defect_size_4_lo -
          defect_largest4a_of_defect_size_4_right,
      defect_largest4a_of_defect_size_4_lo = defect_largest4a_of_defect_size_4_left_rest +
          defect_largest4a_of_defect_size_4_right_rest,
      defect_largest4 = defect_largest4a_of_defect_largest3 < defect_largest4a_of_defect_size_4 ?
          defect_largest4a_of_defect_size_4 : defect_largest4a_of_defect_largest3,
      defect_largest4_lo = defect_largest4a_of_defect_largest3 < defect_largest4a_of_defect_size_4 ?
          defect_largest4a_of_defect_size_4_lo : defect_largest4a_of_defect_largest3_lo;
  const double defect_largest5a_of_defect_largest4 = defect_largest4 + defect_largest4_lo,
      defect_largest5a_of_defect_largest4_right = defect_largest5a_of_defect_largest4 -
          defect_largest4,
      defect_largest5a_of_defect_largest4_left = defect_largest5a_of_defect_largest4 -
          defect_largest5a_of_defect_largest4_right,
      defect_largest5a_of_defect_largest4_left_rest = defect_largest4 -
          defect_largest5a_of_defect_largest4_left,
      defect_largest5a_of_defect_largest4_right_rest = defect_largest4_lo -
          defect_largest5a_of_defect_largest4_right,
      defect_largest5a_of_defect_largest4_lo = defect_largest5a_of_defect_largest4_left_rest +
          defect_largest5a_of_defect_largest4_right_rest,
      defect_largest5a_of_defect_size_5 = defect_size_5 + defect_size_5_lo,
      defect_largest5a_of_defect_size_5_right = defect_largest5a_of_defect_size_5 - defect_size_5,
      defect_largest5a_of_defect_size_5_left = defect_largest5a_of_defect_size_5 -
          defect_largest5a_of_defect_size_5_right,
      defect_largest5a_of_defect_size_5_left_rest = defect_size_5 -
          defect_largest5a_of_defect_size_5_left,
      defect_largest5a_of_defect_size_5_right_rest = defect_size_5_lo -
          defect_largest5a_of_defect_size_5_right,
      defect_largest5a_of_defect_size_5_lo = defect_largest5a_of_defect_size_5_left_rest +
          defect_largest5a_of_defect_size_5_right_rest,
      defect_largest5 = defect_largest5a_of_defect_largest4 < defect_largest5a_of_defect_size_5 ?
          defect_largest5a_of_defect_size_5 : defect_largest5a_of_defect_largest4,
      defect_largest5_lo = defect_largest5a_of_defect_largest4 < defect_largest5a_of_defect_size_5 ?
          defect_largest5a_of_defect_size_5_lo : defect_largest5a_of_defect_largest4_lo;
  const double defect_largest6a_of_defect_largest5 = defect_largest5 + defect_largest5_lo,
      defect_largest6a_of_defect_largest5_right = defect_largest6a_of_defect_largest5 -
          defect_largest5,
      defect_largest6a_of_defect_largest5_left = defect_largest6a_of_defect_largest5 -
          defect_largest6a_of_defect_largest5_right,
      defect_largest6a_of_defect_largest5_left_rest = defect_largest5 -
          defect_largest6a_of_defect_largest5_left,
      defect_largest6a_of_defect_largest5_right_rest = defect_largest5_lo -
          defect_largest6a_of_defect_largest5_right,
      defect_largest6a_of_defect_largest5_lo = defect_largest6a_of_defect_largest5_left_rest +
          defect_largest6a_of_defect_largest5_right_rest,
      defect_largest6a_of_defect_size_6 = defect_size_6 + defect_size_6_lo,
      defect_largest6a_of_defect_size_6_right = defect_largest6a_of_defect_size_6 - defect_size_6,
      defect_largest6a_of_defect_size_6_left = defect_largest6a_of_defect_size_6 -
          defect_largest6a_of_defect_size_6_right,
      defect_largest6a_of_defect_size_6_left_rest = defect_size_6 -
          defect_largest6a_of_defect_size_6_left,
      defect_largest6a_of_defect_size_6_right_rest = defect_size_6_lo -
          defect_largest6a_of_defect_size_6_right,
      defect_largest6a_of_defect_size_6_lo = defect_largest6a_of_defect_size_6_left_rest +
          defect_largest6a_of_defect_size_6_right_rest,
      defect_largest6 = defect_largest6a_of_defect_largest5 < defect_largest6a_of_defect_size_6 ?
          defect_largest6a_of_defect_size_6 : defect_largest6a_of_defect_largest5,
      defect_largest6_lo = defect_largest6a_of_defect_largest5 < defect_largest6a_of_defect_size_6 ?
          defect_largest6a_of_defect_size_6_lo : defect_largest6a_of_defect_largest5_lo;
  const double defect_largest6_rounded = defect_largest6 + defect_largest6_lo;
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
  const double versine_a = KSL_MUL(h, h), versine_a_cross1 = KSL_MUL(h_own_error, h),
      versine_a_cross2 = KSL_MUL(h, h_own_error),
      versine_a_cross = versine_a_cross1 + versine_a_cross2,
      versine_a_error = ksl_product_error(h, h, versine_a),
      versine_a_lo = versine_a_error + versine_a_cross, versine_b = KSL_MUL(2.0, versine_a),
      versine_b_cross2 = KSL_MUL(2.0, versine_a_lo), versine_c = 1.0 - cosine,
      versine_c_right = 1.0 - versine_c, versine_c_left = versine_c + versine_c_right,
      versine_c_left_rest = 1.0 - versine_c_left, versine_c_right_rest = cosine - versine_c_right,
      versine_c_lo1 = versine_c_left_rest - versine_c_right_rest,
      versine_c_lo = versine_c_lo1 - cosine_own_error,
      versine_d_of_cosine = cosine + cosine_own_error,
      versine = versine_d_of_cosine < 0.0 ? versine_c : versine_b,
      versine_lo = versine_d_of_cosine < 0.0 ? versine_c_lo : versine_b_cross2;
  const double beta_v_0 = KSL_MUL(axis->x, versine), beta_v_0_cross2 = KSL_MUL(axis->x, versine_lo);
  const double beta_v_1 = KSL_MUL(axis->y, versine), beta_v_1_cross2 = KSL_MUL(axis->y, versine_lo);
  const double beta_v_2 = KSL_MUL(axis->z, versine), beta_v_2_cross2 = KSL_MUL(axis->z, versine_lo);
  const double beta_v_0_error = ksl_product_error(axis->x, versine, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(axis->x, beta_v_0),
      m_0_cross2 = KSL_MUL(axis->x, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(axis->y, versine, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(axis->y, beta_v_1),
      m_1_cross2 = KSL_MUL(axis->y, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(axis->z, versine, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(axis->z, beta_v_2),
      m_2_cross2 = KSL_MUL(axis->z, beta_v_2_lo);
  const double m_3 = KSL_MUL(axis->y, beta_v_0), m_3_cross2 = KSL_MUL(axis->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(axis->z, beta_v_0), m_4_cross2 = KSL_MUL(axis->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(axis->z, beta_v_1), m_5_cross2 = KSL_MUL(axis->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(axis->y, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(axis->z, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(axis->x, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(axis->z, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(axis->x, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(axis->y, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double alpha_v_0 = KSL_MUL(axis->x, sine),
      alpha_v_0_cross2 = KSL_MUL(axis->x, sine_own_error);
  const double alpha_v_1 = KSL_MUL(axis->y, sine),
      alpha_v_1_cross2 = KSL_MUL(axis->y, sine_own_error);
  const double alpha_v_2 = KSL_MUL(axis->z, sine),
      alpha_v_2_cross2 = KSL_MUL(axis->z, sine_own_error);
  const double R_00 = 1.0 - others_0, R_00_right = 1.0 - R_00, R_00_left = R_00 + R_00_right,
      R_00_left_rest = 1.0 - R_00_left, R_00_right_rest = others_0 - R_00_right,
      R_00_lo1 = R_00_left_rest - R_00_right_rest, R_00_lo = R_00_lo1 - others_0_lo;
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01, R_01_left = R_01 + R_01_right,
      R_01_left_rest = ksl_product_rest(axis->y, beta_v_0, m_3, R_01_left),
      R_01_right_rest = ksl_product_rest(axis->z, sine, alpha_v_2, R_01_right),
      R_01_cross = m_3_cross2 - alpha_v_2_cross2, R_01_lo1 = R_01_left_rest - R_01_right_rest,
      R_01_lo = R_01_lo1 + R_01_cross;
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4, R_02_left = R_02 - R_02_right,
      R_02_left_rest = ksl_product_rest(axis->z, beta_v_0, m_4, R_02_left),
      R_02_right_rest = ksl_product_rest(axis->y, sine, alpha_v_1, R_02_right),
      R_02_cross = m_4_cross2 + alpha_v_1_cross2, R_02_lo1 = R_02_left_rest + R_02_right_rest,
      R_02_lo = R_02_lo1 + R_02_cross;
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3, R_10_left = R_10 - R_10_right,
      R_10_left_rest = ksl_product_rest(axis->y, beta_v_0, m_3, R_10_left),
      R_10_right_rest = ksl_product_rest(axis->z, sine, alpha_v_2, R_10_right),
      R_10_cross = m_3_cross2 + alpha_v_2_cross2, R_10_lo1 = R_10_left_rest + R_10_right_rest,
      R_10_lo = R_10_lo1 + R_10_cross;
  const double R_11 = 1.0 - others_1, R_11_right = 1.0 - R_11, R_11_left = R_11 + R_11_right,
      R_11_left_rest = 1.0 - R_11_left, R_11_right_rest = others_1 - R_11_right,
      R_11_lo1 = R_11_left_rest - R_11_right_rest, R_11_lo = R_11_lo1 - others_1_lo;
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12, R_12_left = R_12 + R_12_right,
      R_12_left_rest = ksl_product_rest(axis->z, beta_v_1, m_5, R_12_left),
      R_12_right_rest = ksl_product_rest(axis->x, sine, alpha_v_0, R_12_right),
      R_12_cross = m_5_cross2 - alpha_v_0_cross2, R_12_lo1 = R_12_left_rest - R_12_right_rest,
      R_12_lo = R_12_lo1 + R_12_cross;
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20, R_20_left = R_20 + R_20_right,
      R_20_left_rest = ksl_product_rest(axis->z, beta_v_0, m_4, R_20_left),
      R_20_right_rest = ksl_product_rest(axis->y, sine, alpha_v_1, R_20_right),
      R_20_cross = m_4_cross2 - alpha_v_1_cross2, R_20_lo1 = R_20_left_rest - R_20_right_rest,
      R_20_lo = R_20_lo1 + R_20_cross;
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5, R_21_left = R_21 - R_21_right,
      R_21_left_rest = ksl_product_rest(axis->z, beta_v_1, m_5, R_21_left),
      R_21_right_rest = ksl_product_rest(axis->x, sine, alpha_v_0, R_21_right),
      R_21_cross = m_5_cross2 + alpha_v_0_cross2, R_21_lo1 = R_21_left_rest + R_21_right_rest,
      R_21_lo = R_21_lo1 + R_21_cross;
  const double R_22 = 1.0 - others_2, R_22_right = 1.0 - R_22, R_22_left = R_22 + R_22_right,
      R_22_left_rest = 1.0 - R_22_left, R_22_right_rest = others_2 - R_22_right,
      R_22_lo1 = R_22_left_rest - R_22_right_rest, R_22_lo = R_22_lo1 - others_2_lo;
  const double R_00_rounded = R_00 + R_00_lo,
      R_00_final = R_00_rounded == R_00_rounded ? R_00_rounded : R_00;
  const double R_01_rounded = R_01 + R_01_lo,
      R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_rounded = R_02 + R_02_lo,
      R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_rounded = R_10 + R_10_lo,
      R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double R_11_rounded = R_11 + R_11_lo,
      R_11_final = R_11_rounded == R_11_rounded ? R_11_rounded : R_11;
  const double R_12_rounded = R_12 + R_12_lo,
      R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_rounded = R_20 + R_20_lo,
      R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_rounded = R_21 + R_21_lo,
      R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double R_22_rounded = R_22 + R_22_lo,
      R_22_final = R_22_rounded == R_22_rounded ? R_22_rounded : R_22;
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
  const double p_0 = R->m21 - R->m12, p_0_right = R->m21 - p_0, p_0_left = p_0 + p_0_right,
      p_0_left_rest = R->m21 - p_0_left, p_0_right_rest = R->m12 - p_0_right,
      p_0_lo = p_0_left_rest - p_0_right_rest;
  const double p_1 = R->m02 - R->m20, p_1_right = R->m02 - p_1, p_1_left = p_1 + p_1_right,
      p_1_left_rest = R->m02 - p_1_left, p_1_right_rest = R->m20 - p_1_right,
      p_1_lo = p_1_left_rest - p_1_right_rest;
  const double p_2 = R->m10 - R->m01, p_2_right = R->m10 - p_2, p_2_left = p_2 + p_2_right,
      p_2_left_rest = R->m10 - p_2_left, p_2_right_rest = R->m01 - p_2_right,
      p_2_lo = p_2_left_rest - p_2_right_rest;
  const double s_0 = R->m12 + R->m21, s_0_right = s_0 - R->m12, s_0_left = s_0 - s_0_right,
      s_0_left_rest = R->m12 - s_0_left, s_0_right_rest = R->m21 - s_0_right,
      s_0_lo = s_0_left_rest + s_0_right_rest;
  const double s_1 = R->m02 + R->m20, s_1_right = s_1 - R->m02, s_1_left = s_1 - s_1_right,
      s_1_left_rest = R->m02 - s_1_left, s_1_right_rest = R->m20 - s_1_right,
      s_1_lo = s_1_left_rest + s_1_right_rest;
  const double s_2 = R->m01 + R->m10, s_2_right = s_2 - R->m01, s_2_left = s_2 - s_2_right,
      s_2_left_rest = R->m01 - s_2_left, s_2_right_rest = R->m10 - s_2_right,
      s_2_lo = s_2_left_rest + s_2_right_rest;
  const double first_0 = R->m00 + 1.0, first_0_right = first_0 - R->m00,
      first_0_left = first_0 - first_0_right, first_0_left_rest = R->m00 - first_0_left,
      first_0_right_rest = 1.0 - first_0_right, first_0_lo = first_0_left_rest + first_0_right_rest;
  const double first_1 = 1.0 - R->m00, first_1_right = 1.0 - first_1,
      first_1_left = first_1 + first_1_right, first_1_left_rest = 1.0 - first_1_left,
      first_1_right_rest = R->m00 - first_1_right,
      first_1_lo = first_1_left_rest - first_1_right_rest;
  const double others_0 = R->m11 + R->m22, others_0_right = others_0 - R->m11,
      others_0_left = others_0 - others_0_right, others_0_left_rest = R->m11 - others_0_left,
      others_0_right_rest = R->m22 - others_0_right,
      others_0_lo = others_0_left_rest + others_0_right_rest;
  const double others_1 = R->m11 - R->m22, others_1_right = R->m11 - others_1,
      others_1_left = others_1 + others_1_right, others_1_left_rest = R->m11 - others_1_left,
      others_1_right_rest = R->m22 - others_1_right,
      others_1_lo = others_1_left_rest - others_1_right_rest;
  const double d_0 = first_0 + others_0, d_0_right = d_0 - first_0, d_0_left = d_0 - d_0_right,
      d_0_left_rest = first_0 - d_0_left, d_0_right_rest = others_0 - d_0_right,
      d_0_lo1 = d_0_left_rest + d_0_right_rest, d_0_lo2 = d_0_lo1 + others_0_lo,
      d_0_lo = d_0_lo2 + first_0_lo;
  const double d_1 = first_0 - others_0, d_1_right = first_0 - d_1, d_1_left = d_1 + d_1_right,
      d_1_left_rest = first_0 - d_1_left, d_1_right_rest = others_0 - d_1_right,
      d_1_lo1 = d_1_left_rest - d_1_right_rest, d_1_lo2 = d_1_lo1 - others_0_lo,
      d_1_lo = d_1_lo2 + first_0_lo;
  const double d_2 = first_1 + others_1, d_2_right = d_2 - first_1, d_2_left = d_2 - d_2_right,
      d_2_left_rest = first_1 - d_2_left, d_2_right_rest = others_1 - d_2_right,
      d_2_lo1 = d_2_left_rest + d_2_right_rest, d_2_lo2 = d_2_lo1 + others_1_lo,
      d_2_lo = d_2_lo2 + first_1_lo;
  const double d_3 = first_1 - others_1, d_3_right = first_1 - d_3, d_3_left = d_3 + d_3_right,
      d_3_left_rest = first_1 - d_3_left, d_3_right_rest = others_1 - d_3_right,
      d_3_lo1 = d_3_left_rest - d_3_right_rest, d_3_lo2 = d_3_lo1 - others_1_lo,
      d_3_lo = d_3_lo2 + first_1_lo;
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
      upper_0b_of_column_3 = column_3 + column_3_lo,
      upper_0b_of_column_3_right = upper_0b_of_column_3 - column_3,
      upper_0b_of_column_3_left = upper_0b_of_column_3 - upper_0b_of_column_3_right,
      upper_0b_of_column_3_left_rest = column_3 - upper_0b_of_column_3_left,
      upper_0b_of_column_3_right_rest = column_3_lo - upper_0b_of_column_3_right,
      upper_0b_of_column_3_lo = upper_0b_of_column_3_left_rest + upper_0b_of_column_3_right_rest,
      upper_0 = upper_0b_of_column_3 < 0.0 ? upper_0a : column_0,
      upper_0_lo = upper_0b_of_column_3 < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = upper_0b_of_column_3 < 0.0 ? upper_1a : column_1,
      upper_1_lo = upper_0b_of_column_3 < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = upper_0b_of_column_3 < 0.0 ? upper_2a : column_2,
      upper_2_lo = upper_0b_of_column_3 < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -upper_0b_of_column_3, upper_3a_lo = -upper_0b_of_column_3_lo,
      upper_3 = upper_0b_of_column_3 < 0.0 ? upper_3a : upper_0b_of_column_3,
      upper_3_lo = upper_0b_of_column_3 < 0.0 ? upper_3a_lo : upper_0b_of_column_3_lo;
  const double v_s_size_0_of_upper_0 = upper_0 + upper_0_lo,
      v_s_size_0_of_upper_0_right = v_s_size_0_of_upper_0 - upper_0,
      v_s_size_0_of_upper_0_left = v_s_size_0_of_upper_0 - v_s_size_0_of_upper_0_right,
      v_s_size_0_of_upper_0_left_rest = upper_0 - v_s_size_0_of_upper_0_left,
      v_s_size_0_of_upper_0_right_rest = upper_0_lo - v_s_size_0_of_upper_0_right,
      v_s_size_0_of_upper_0_lo = v_s_size_0_of_upper_0_left_rest + v_s_size_0_of_upper_0_right_rest,
      v_s_size_0 = fabs(v_s_size_0_of_upper_0), v_s_size_0_opposite = -v_s_size_0_of_upper_0_lo,
      v_s_size_0_lo = v_s_size_0_of_upper_0 < 0.0 ? v_s_size_0_opposite : v_s_size_0_of_upper_0_lo;
  const double v_s_size_1_of_upper_1 = upper_1 + upper_1_lo,
      v_s_size_1_of_upper_1_right = v_s_size_1_of_upper_1 - upper_1,
      v_s_size_1_of_upper_1_left = v_s_size_1_of_upper_1 - v_s_size_1_of_upper_1_right,
      v_s_size_1_of_upper_1_left_rest = upper_1 - v_s_size_1_of_upper_1_left,
      v_s_size_1_of_upper_1_right_rest = upper_1_lo - v_s_size_1_of_upper_1_right,
      v_s_size_1_of_upper_1_lo = v_s_size_1_of_upper_1_left_rest + v_s_size_1_of_upper_1_right_rest,
      v_s_size_1 = fabs(v_s_size_1_of_upper_1), v_s_size_1_opposite = -v_s_size_1_of_upper_1_lo,
      v_s_size_1_lo = v_s_size_1_of_upper_1 < 0.0 ? v_s_size_1_opposite : v_s_size_1_of_upper_1_lo;
  const double v_s_size_2_of_upper_2 = upper_2 + upper_2_lo,
      v_s_size_2_of_upper_2_right = v_s_size_2_of_upper_2 - upper_2,
      v_s_size_2_of_upper_2_left = v_s_size_2_of_upper_2 - v_s_size_2_of_upper_2_right,
      v_s_size_2_of_upper_2_left_rest = upper_2 - v_s_size_2_of_upper_2_left,
      v_s_size_2_of_upper_2_right_rest = upper_2_lo - v_s_size_2_of_upper_2_right,
      v_s_size_2_of_upper_2_lo = v_s_size_2_of_upper_2_left_rest + v_s_size_2_of_upper_2_right_rest,
      v_s_size_2 = fabs(v_s_size_2_of_upper_2), v_s_size_2_opposite = -v_s_size_2_of_upper_2_lo,
      v_s_size_2_lo = v_s_size_2_of_upper_2 < 0.0 ? v_s_size_2_opposite : v_s_size_2_of_upper_2_lo;
  const double v_s_largest1a_of_v_s_size_0 = v_s_size_0 + v_s_size_0_lo,
      v_s_largest1a_of_v_s_size_0_right = v_s_largest1a_of_v_s_size_0 - v_s_size_0,
      v_s_largest1a_of_v_s_size_0_left = v_s_largest1a_of_v_s_size_0 -
          v_s_largest1a_of_v_s_size_0_right,
      v_s_largest1a_of_v_s_size_0_left_rest = v_s_size_0 - v_s_largest1a_of_v_s_size_0_left,
      v_s_largest1a_of_v_s_size_0_right_rest = v_s_size_0_lo - v_s_largest1a_of_v_s_size_0_right,
      v_s_largest1a_of_v_s_size_0_lo = v_s_largest1a_of_v_s_size_0_left_rest +
          v_s_largest1a_of_v_s_size_0_right_rest,
      v_s_largest1a_of_v_s_size_1 = v_s_size_1 + v_s_size_1_lo,
      v_s_largest1a_of_v_s_size_1_right = v_s_largest1a_of_v_s_size_1 - v_s_size_1,
      v_s_largest1a_of_v_s_size_1_left = v_s_largest1a_of_v_s_size_1 -
          v_s_largest1a_of_v_s_size_1_right,
      v_s_largest1a_of_v_s_size_1_left_rest = v_s_size_1 - v_s_largest1a_of_v_s_size_1_left,
      v_s_largest1a_of_v_s_size_1_right_rest = v_s_size_1_lo - v_s_largest1a_of_v_s_size_1_right,
      v_s_largest1a_of_v_s_size_1_lo = v_s_largest1a_of_v_s_size_1_left_rest +
          v_s_largest1a_of_v_s_size_1_right_rest,
      v_s_largest1 = v_s_largest1a_of_v_s_size_0 < v_s_largest1a_of_v_s_size_1 ?
          v_s_largest1a_of_v_s_size_1 : v_s_largest1a_of_v_s_size_0,
      v_s_largest1_lo = v_s_largest1a_of_v_s_size_0 < v_s_largest1a_of_v_s_size_1 ?
          v_s_largest1a_of_v_s_size_1_lo : v_s_largest1a_of_v_s_size_0_lo;
  const double v_s_largest2a_of_v_s_largest1 = v_s_largest1 + v_s_largest1_lo,
      v_s_largest2a_of_v_s_largest1_right = v_s_largest2a_of_v_s_largest1 - v_s_largest1,
      v_s_largest2a_of_v_s_largest1_left = v_s_largest2a_of_v_s_largest1 -
          v_s_largest2a_of_v_s_largest1_right,
      v_s_largest2a_of_v_s_largest1_left_rest = v_s_largest1 - v_s_largest2a_of_v_s_largest1_left,
      v_s_largest2a_of_v_s_largest1_right_rest = v_s_largest1_lo -
          v_s_largest2a_of_v_s_largest1_right,
      v_s_largest2a_of_v_s_largest1_lo = v_s_largest2a_of_v_s_largest1_left_rest +
          v_s_largest2a_of_v_s_largest1_right_rest,
      v_s_largest2a_of_v_s_size_2 = v_s_size_2 + v_s_size_2_lo,
      v_s_largest2a_of_v_s_size_2_right = v_s_largest2a_of_v_s_size_2 - v_s_size_2,
      v_s_largest2a_of_v_s_size_2_left = v_s_largest2a_of_v_s_size_2 -
          v_s_largest2a_of_v_s_size_2_right,
      v_s_largest2a_of_v_s_size_2_left_rest = v_s_size_2 - v_s_largest2a_of_v_s_size_2_left,
      v_s_largest2a_of_v_s_size_2_right_rest = v_s_size_2_lo - v_s_largest2a_of_v_s_size_2_right,
      v_s_largest2a_of_v_s_size_2_lo = v_s_largest2a_of_v_s_size_2_left_rest +
          v_s_largest2a_of_v_s_size_2_right_rest,
      v_s_largest2 = v_s_largest2a_of_v_s_largest1 < v_s_largest2a_of_v_s_size_2 ?
          v_s_largest2a_of_v_s_size_2 : v_s_largest2a_of_v_s_largest1,
      v_s_largest2_lo = v_s_largest2a_of_v_s_largest1 < v_s_largest2a_of_v_s_size_2 ?
          v_s_largest2a_of_v_s_size_2_lo : v_s_largest2a_of_v_s_largest1_lo;
  const double v_s_a_of_v_s_largest2 = v_s_largest2 + v_s_largest2_lo,
      v_s_b = 6.703903964971299e+153 < v_s_a_of_v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_a_of_v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_a_of_v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(v_s_size_0_of_upper_0, v_s), v_y_0_inverse = 1.0 / v_s,
      v_y_0_back = KSL_MUL(v_y_0, v_y_0_inverse), v_y_0_lost = v_s_size_0_of_upper_0 - v_y_0_back,
      v_y_0_rest = v_y_0_lost + v_s_size_0_of_upper_0_lo, v_y_0_lo = KSL_MUL(v_y_0_rest, v_s);
  const double v_y_1 = KSL_MUL(v_s_size_1_of_upper_1, v_s),
      v_y_1_back = KSL_MUL(v_y_1, v_y_0_inverse), v_y_1_lost = v_s_size_1_of_upper_1 - v_y_1_back,
      v_y_1_rest = v_y_1_lost + v_s_size_1_of_upper_1_lo, v_y_1_lo = KSL_MUL(v_y_1_rest, v_s);
  const double v_y_2 = KSL_MUL(v_s_size_2_of_upper_2, v_s),
      v_y_2_back = KSL_MUL(v_y_2, v_y_0_inverse), v_y_2_lost = v_s_size_2_of_upper_2 - v_y_2_back,
      v_y_2_rest = v_y_2_lost + v_s_size_2_of_upper_2_lo, v_y_2_lo = KSL_MUL(v_y_2_rest, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_a_cross1 = KSL_MUL(v_y_0_lo, v_y_0),
      v_n_a_cross2 = KSL_MUL(v_y_0, v_y_0_lo), v_n_a_cross = v_n_a_cross1 + v_n_a_cross2,
      v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_b_cross1 = KSL_MUL(v_y_1_lo, v_y_1),
      v_n_b_cross2 = KSL_MUL(v_y_1, v_y_1_lo), v_n_b_cross = v_n_b_cross1 + v_n_b_cross2,
      v_n_c = v_n_a + v_n_b, v_n_c_right = v_n_c - v_n_a, v_n_c_left = v_n_c - v_n_c_right,
      v_n_c_left_rest = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c_left),
      v_n_c_right_rest = ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right),
      v_n_c_cross = v_n_a_cross + v_n_b_cross, v_n_c_lo1 = v_n_c_left_rest + v_n_c_right_rest,
      v_n_c_lo = v_n_c_lo1 + v_n_c_cross, v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_d_cross1 = KSL_MUL(v_y_2_lo, v_y_2), v_n_d_cross2 = KSL_MUL(v_y_2, v_y_2_lo),
      v_n_d_cross = v_n_d_cross1 + v_n_d_cross2, v_n_e = v_n_c + v_n_d, v_n_e_right = v_n_e - v_n_c,
      v_n_e_left = v_n_e - v_n_e_right, v_n_e_left_rest = v_n_c - v_n_e_left,
      v_n_e_right_rest = ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right),
      v_n_e_lo1 = v_n_e_left_rest + v_n_e_right_rest, v_n_e_lo2 = v_n_e_lo1 + v_n_d_cross,
      v_n_e_lo = v_n_e_lo2 + v_n_c_lo, v_n_of_v_n_e = v_n_e + v_n_e_lo,
      v_n_of_v_n_e_right = v_n_of_v_n_e - v_n_e,
      v_n_of_v_n_e_left = v_n_of_v_n_e - v_n_of_v_n_e_right,
      v_n_of_v_n_e_left_rest = v_n_e - v_n_of_v_n_e_left,
      v_n_of_v_n_e_right_rest = v_n_e_lo - v_n_of_v_n_e_right,
      v_n_of_v_n_e_lo = v_n_of_v_n_e_left_rest + v_n_of_v_n_e_right_rest, v_n = sqrt(v_n_of_v_n_e),
      v_n_product = KSL_MUL(v_n, v_n), v_n_product_error = ksl_product_error(v_n, v_n, v_n_product),
      v_n_rest = v_n_of_v_n_e - v_n_product, v_n_exact = v_n_rest - v_n_product_error,
      v_n_residual = v_n_exact + v_n_of_v_n_e_lo, v_n_twice = v_n + v_n,
      v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice, v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n_of_v_n = v_n + v_n_lo, n_of_v_n_right = n_of_v_n - v_n,
      n_of_v_n_left = n_of_v_n - n_of_v_n_right, n_of_v_n_left_rest = v_n - n_of_v_n_left,
      n_of_v_n_right_rest = v_n_lo - n_of_v_n_right,
      n_of_v_n_lo = n_of_v_n_left_rest + n_of_v_n_right_rest, n = KSL_MUL(n_of_v_n, v_r),
      n_inverse = 1.0 / v_r, n_back = KSL_MUL(n, n_inverse), n_lost = n_of_v_n - n_back,
      n_rest = n_lost + n_of_v_n_lo, n_lo = KSL_MUL(n_rest, v_r);
  const double half_of_n = n + n_lo, half_of_n_right = half_of_n - n,
      half_of_n_left = half_of_n - half_of_n_right, half_of_n_left_rest = n - half_of_n_left,
      half_of_n_right_rest = n_lo - half_of_n_right,
      half_of_n_lo = half_of_n_left_rest + half_of_n_right_rest,
      half_of_upper_3 = upper_3 + upper_3_lo, half_of_upper_3_right = half_of_upper_3 - upper_3,
      half_of_upper_3_left = half_of_upper_3 - half_of_upper_3_right,
      half_of_upper_3_left_rest = upper_3 - half_of_upper_3_left,
      half_of_upper_3_right_rest = upper_3_lo - half_of_upper_3_right,
      half_of_upper_3_lo = half_of_upper_3_left_rest + half_of_upper_3_right_rest,
      half = ksl_atan2(half_of_n, half_of_upper_3),
      half_own_error = ksl_atan2_error(half_of_n, half_of_upper_3, half),
      half_size0 = fabs(half_of_n), half_size1 = fabs(half_of_upper_3),
      half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = half_of_n / half_divisor,
      half_part1 = half_of_upper_3 / half_divisor, half_cross1 = KSL_MUL(half_part1, half_of_n_lo),
      half_cross2 = KSL_MUL(half_part0, half_of_upper_3_lo),
      half_square1 = KSL_MUL(half_part1, half_part1),
      half_square2 = KSL_MUL(half_part0, half_part0), half_cross = half_cross1 - half_cross2,
      half_square = half_square1 + half_square2, half_divisor2 = KSL_MUL(half_divisor, half_square),
      half_safe = half_most == 0.0 ? 1.0 : half_divisor2, half_more = half_cross / half_safe,
      half_lo = half_own_error + half_more;
  const double divisor = n_of_v_n == 0.0 ? 1.0 : n_of_v_n,
      divisor_lo = n_of_v_n == 0.0 ? 0.0 : n_of_v_n_lo;
  const double unit_0_of_v_y_0 = v_y_0 + v_y_0_lo, unit_0_of_v_y_0_right = unit_0_of_v_y_0 - v_y_0,
      unit_0_of_v_y_0_left = unit_0_of_v_y_0 - unit_0_of_v_y_0_right,
      unit_0_of_v_y_0_left_rest = v_y_0 - unit_0_of_v_y_0_left,
      unit_0_of_v_y_0_right_rest = v_y_0_lo - unit_0_of_v_y_0_right,
      unit_0_of_v_y_0_lo = unit_0_of_v_y_0_left_rest + unit_0_of_v_y_0_right_rest,
      unit_0_of_divisor = divisor + divisor_lo,
      unit_0_of_divisor_right = unit_0_of_divisor - divisor,
      unit_0_of_divisor_left = unit_0_of_divisor - unit_0_of_divisor_right,
      unit_0_of_divisor_left_rest = divisor - unit_0_of_divisor_left,
      unit_0_of_divisor_right_rest = divisor_lo - unit_0_of_divisor_right,
      unit_0_of_divisor_lo = unit_0_of_divisor_left_rest + unit_0_of_divisor_right_rest,
      unit_0 = unit_0_of_v_y_0 / unit_0_of_divisor,
      unit_0_product = KSL_MUL(unit_0, unit_0_of_divisor),
      unit_0_product_error = ksl_product_error(unit_0, unit_0_of_divisor, unit_0_product),
      unit_0_rest = unit_0_of_v_y_0 - unit_0_product,
      unit_0_exact = unit_0_rest - unit_0_product_error,
      unit_0_numerator = unit_0_exact + unit_0_of_v_y_0_lo,
      unit_0_cross = KSL_MUL(unit_0, unit_0_of_divisor_lo),
      unit_0_residual = unit_0_numerator - unit_0_cross,
      unit_0_lo = unit_0_residual / unit_0_of_divisor;
  const double unit_1_of_v_y_1 = v_y_1 + v_y_1_lo, unit_1_of_v_y_1_right = unit_1_of_v_y_1 - v_y_1,
      unit_1_of_v_y_1_left = unit_1_of_v_y_1 - unit_1_of_v_y_1_right,
      unit_1_of_v_y_1_left_rest = v_y_1 - unit_1_of_v_y_1_left,
      unit_1_of_v_y_1_right_rest = v_y_1_lo - unit_1_of_v_y_1_right,
      unit_1_of_v_y_1_lo = unit_1_of_v_y_1_left_rest + unit_1_of_v_y_1_right_rest,
      unit_1 = unit_1_of_v_y_1 / unit_0_of_divisor,
      unit_1_product = KSL_MUL(unit_1, unit_0_of_divisor),
      unit_1_product_error = ksl_product_error(unit_1, unit_0_of_divisor, unit_1_product),
      unit_1_rest = unit_1_of_v_y_1 - unit_1_product,
      unit_1_exact = unit_1_rest - unit_1_product_error,
      unit_1_numerator = unit_1_exact + unit_1_of_v_y_1_lo,
      unit_1_cross = KSL_MUL(unit_1, unit_0_of_divisor_lo),
      unit_1_residual = unit_1_numerator - unit_1_cross,
      unit_1_lo = unit_1_residual / unit_0_of_divisor;
  const double unit_2_of_v_y_2 = v_y_2 + v_y_2_lo, unit_2_of_v_y_2_right = unit_2_of_v_y_2 - v_y_2,
      unit_2_of_v_y_2_left = unit_2_of_v_y_2 - unit_2_of_v_y_2_right,
      unit_2_of_v_y_2_left_rest = v_y_2 - unit_2_of_v_y_2_left,
      unit_2_of_v_y_2_right_rest = v_y_2_lo - unit_2_of_v_y_2_right,
      unit_2_of_v_y_2_lo = unit_2_of_v_y_2_left_rest + unit_2_of_v_y_2_right_rest,
      unit_2 = unit_2_of_v_y_2 / unit_0_of_divisor,
      unit_2_product = KSL_MUL(unit_2, unit_0_of_divisor),
      unit_2_product_error = ksl_product_error(unit_2, unit_0_of_divisor, unit_2_product),
      unit_2_rest = unit_2_of_v_y_2 - unit_2_product,
      unit_2_exact = unit_2_rest - unit_2_product_error,
      unit_2_numerator = unit_2_exact + unit_2_of_v_y_2_lo,
      unit_2_cross = KSL_MUL(unit_2, unit_0_of_divisor_lo),
      unit_2_residual = unit_2_numerator - unit_2_cross,
      unit_2_lo = unit_2_residual / unit_0_of_divisor;
  const double angle = KSL_MUL(2.0, half), angle_cross2 = KSL_MUL(2.0, half_lo);
  const double axis_0 = n_of_v_n == 0.0 ? 1.0 : unit_0,
      axis_0_lo = n_of_v_n == 0.0 ? 0.0 : unit_0_lo;
  const double angle_rounded = angle + angle_cross2,
      angle_final = angle_rounded == angle_rounded ? angle_rounded : angle;
  const double axis_0_rounded = axis_0 + axis_0_lo,
      axis_0_final = axis_0_rounded == axis_0_rounded ? axis_0_rounded : axis_0;
  const double unit_1_rounded = unit_1 + unit_1_lo,
      unit_1_final = unit_1_rounded == unit_1_rounded ? unit_1_rounded : unit_1;
  const double unit_2_rounded = unit_2 + unit_2_lo,
      unit_2_final = unit_2_rounded == unit_2_rounded ? unit_2_rounded : unit_2;
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
  const double ww_0 = (double)w->x * (double)w->x;
  const double ww_1 = (double)w->y * (double)w->y;
  const double ww_2 = (double)w->z * (double)w->z;
  const double ww_3 = (double)w->x * (double)w->y;
  const double ww_4 = (double)w->x * (double)w->z;
  const double ww_5 = (double)w->y * (double)w->z;
  const double Ro_00a_lead = -ww_1, Ro_00 = Ro_00a_lead - ww_2;
  const double Ro_01 = ww_3 - (double)dw->z;
  const double Ro_02 = (double)dw->y + ww_4;
  const double Ro_10 = (double)dw->z + ww_3;
  const double Ro_11a_lead = -ww_0, Ro_11 = Ro_11a_lead - ww_2;
  const double Ro_12 = ww_5 - (double)dw->x;
  const double Ro_20 = ww_4 - (double)dw->y;
  const double Ro_21 = (double)dw->x + ww_5;
  const double Ro_22a_lead = -ww_0, Ro_22 = Ro_22a_lead - ww_1;
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
  const double n_0a = (double)R->m11 * (double)R->m22,
      n_0 = ksl_product_sum(-(double)R->m12, (double)R->m21, n_0a);
  const double n_1a = (double)R->m02 * (double)R->m21,
      n_1 = ksl_product_sum(-(double)R->m01, (double)R->m22, n_1a);
  const double n_2a = (double)R->m01 * (double)R->m12,
      n_2 = ksl_product_sum(-(double)R->m02, (double)R->m11, n_2a);
  const double det_a = KSL_MUL((double)R->m00, n_0), det_b = KSL_MUL((double)R->m10, n_1),
      det_c = det_a + det_b, det_d = KSL_MUL((double)R->m20, n_2), det = det_c + det_d;
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
  const double R_size_0 = fabs((double)R->m00);
  const double R_size_1 = fabs((double)R->m01);
  const double R_size_2 = fabs((double)R->m02);
  const double R_size_3 = fabs((double)R->m10);
  const double R_size_4 = fabs((double)R->m11);
  const double R_size_5 = fabs((double)R->m12);
  const double R_size_6 = fabs((double)R->m20);
  const double R_size_7 = fabs((double)R->m21);
  const double R_size_8 = fabs((double)R->m22);
  const double R_largest1 = R_size_0 < R_size_1 ? R_size_1 : R_size_0;
  const double R_largest2 = R_largest1 < R_size_2 ? R_size_2 : R_largest1;
  const double R_largest3 = R_largest2 < R_size_3 ? R_size_3 : R_largest2;
  const double R_largest4 = R_largest3 < R_size_4 ? R_size_4 : R_largest3;
  const double R_largest5 = R_largest4 < R_size_5 ? R_size_5 : R_largest4;
  const double R_largest6 = R_largest5 < R_size_6 ? R_size_6 : R_largest5;
  const double R_largest7 = R_largest6 < R_size_7 ? R_size_7 : R_largest6;
  const double R_largest8 = R_largest7 < R_size_8 ? R_size_8 : R_largest7;
  const double s_b = R_largest8 < 1.329227995784916e+36 ? 8.271806125530277e-25 :
      7.52316384526264e-37,
      s_d = R_largest8 < 1.2089258196146292e+24 ? 9.094947017729282e-13 : s_b,
      s_f = R_largest8 < 1099511627776.0 ? 1.0 : s_d,
      s_h = R_largest8 < 1.0 ? 1099511627776.0 : s_f,
      s_j = R_largest8 < 9.094947017729282e-13 ? 1.2089258196146292e+24 : s_h,
      s = R_largest8 < 8.271806125530277e-25 ? 1.329227995784916e+36 : s_j;
  const double A_0 = KSL_MUL((double)R->m00, s);
  const double A_1 = KSL_MUL((double)R->m01, s);
  const double A_2 = KSL_MUL((double)R->m02, s);
  const double A_3 = KSL_MUL((double)R->m10, s);
  const double A_4 = KSL_MUL((double)R->m11, s);
  const double A_5 = KSL_MUL((double)R->m12, s);
  const double A_6 = KSL_MUL((double)R->m20, s);
  const double A_7 = KSL_MUL((double)R->m21, s);
  const double A_8 = KSL_MUL((double)R->m22, s);
  const double n0_0a = KSL_MUL(A_4, A_8), n0_0b = KSL_MUL(A_5, A_7), n0_0 = n0_0a - n0_0b;
  const double n0_1a = KSL_MUL(A_2, A_7), n0_1b = KSL_MUL(A_1, A_8), n0_1 = n0_1a - n0_1b;
  const double n0_2a = KSL_MUL(A_1, A_5), n0_2b = KSL_MUL(A_2, A_4), n0_2 = n0_2a - n0_2b;
  const double n1_0a = KSL_MUL(A_5, A_6), n1_0b = KSL_MUL(A_3, A_8), n1_0 = n1_0a - n1_0b;
  const double n1_1a = KSL_MUL(A_0, A_8), n1_1b = KSL_MUL(A_2, A_6), n1_1 = n1_1a - n1_1b;
  const double n1_2a = KSL_MUL(A_2, A_3), n1_2b = KSL_MUL(A_0, A_5), n1_2 = n1_2a - n1_2b;
  const double n2_0a = KSL_MUL(A_3, A_7), n2_0b = KSL_MUL(A_4, A_6), n2_0 = n2_0a - n2_0b;
  const double n2_1a = KSL_MUL(A_1, A_6), n2_1b = KSL_MUL(A_0, A_7), n2_1 = n2_1a - n2_1b;
  const double n2_2a = KSL_MUL(A_0, A_4), n2_2b = KSL_MUL(A_1, A_3), n2_2 = n2_2a - n2_2b;
  const double d_a = KSL_MUL(A_0, n0_0), d_b = KSL_MUL(A_3, n0_1), d_c = d_a + d_b,
      d_d = KSL_MUL(A_6, n0_2), d = d_c + d_d;
  const double size0_0 = fabs(A_0);
  const double size0_1 = fabs(A_3);
  const double size0_2 = fabs(A_6);
  const double size1_0 = fabs(A_1);
  const double size1_1 = fabs(A_4);
  const double size1_2 = fabs(A_7);
  const double size2_0 = fabs(A_2);
  const double size2_1 = fabs(A_5);
  const double size2_2 = fabs(A_8);
  const double permanent_a = KSL_MUL(size1_1, size2_2), permanent_b = KSL_MUL(size1_2, size2_1),
      permanent_c = permanent_a + permanent_b, permanent_d = KSL_MUL(size0_0, permanent_c),
      permanent_e = KSL_MUL(size1_0, size2_2), permanent_f = KSL_MUL(size1_2, size2_0),
      permanent_g = permanent_e + permanent_f, permanent_h = KSL_MUL(size0_1, permanent_g),
      permanent_i = permanent_d + permanent_h, permanent_j = KSL_MUL(size1_0, size2_1),
      permanent_k = KSL_MUL(size1_1, size2_0), permanent_l = permanent_j + permanent_k,
      permanent_m = KSL_MUL(size0_2, permanent_l), permanent = permanent_i + permanent_m;
  const double top = KSL_MUL(R_largest8, s);
  const double spoiled = KSL_MUL(top, 1.262177448353619e-29);
  const double least_a = KSL_MUL(permanent, 4.76837158203125e-07), least_b = KSL_MUL(top, top),
      least_c = KSL_MUL(spoiled, least_b), least = least_a + least_c;
  const double regular_a = fabs(d), regular = least < regular_a ? 1.0 : 0.0;
  const double divisor = regular == 1.0 ? d : 1.0;
  const double quotient_0 = n0_0 / divisor;
  const double quotient_1 = n0_1 / divisor;
  const double quotient_2 = n0_2 / divisor;
  const double quotient_3 = n1_0 / divisor;
  const double quotient_4 = n1_1 / divisor;
  const double quotient_5 = n1_2 / divisor;
  const double quotient_6 = n2_0 / divisor;
  const double quotient_7 = n2_1 / divisor;
  const double quotient_8 = n2_2 / divisor;
  const double inverse_0 = KSL_MUL(quotient_0, s);
  const double inverse_1 = KSL_MUL(quotient_1, s);
  const double inverse_2 = KSL_MUL(quotient_2, s);
  const double inverse_3 = KSL_MUL(quotient_3, s);
  const double inverse_4 = KSL_MUL(quotient_4, s);
  const double inverse_5 = KSL_MUL(quotient_5, s);
  const double inverse_6 = KSL_MUL(quotient_6, s);
  const double inverse_7 = KSL_MUL(quotient_7, s);
  const double inverse_8 = KSL_MUL(quotient_8, s);
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
  const double Ro_00 = regular == 1.0 ? inverse_0 : (double)NAN;
  const double Ro_01 = regular == 1.0 ? inverse_1 : (double)NAN;
  const double Ro_02 = regular == 1.0 ? inverse_2 : (double)NAN;
  const double Ro_10 = regular == 1.0 ? inverse_3 : (double)NAN;
  const double Ro_11 = regular == 1.0 ? inverse_4 : (double)NAN;
  const double Ro_12 = regular == 1.0 ? inverse_5 : (double)NAN;
  const double Ro_20 = regular == 1.0 ? inverse_6 : (double)NAN;
  const double Ro_21 = regular == 1.0 ? inverse_7 : (double)NAN;
  const double Ro_22 = regular == 1.0 ? inverse_8 : (double)NAN;
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
  const double q0_s_size_0 = fabs((double)self->m00);
  const double q0_s_size_1 = fabs((double)self->m01);
  const double q0_s_size_2 = fabs((double)self->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 4.611686018427388e+18 < q0_s_largest2 ? 2.710505431213761e-20 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.8014398509481984e+16 : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : q0_s_d;
  const double q0_y_0 = KSL_MUL((double)self->m00, q0_s);
  const double q0_y_1 = KSL_MUL((double)self->m01, q0_s);
  const double q0_y_2 = KSL_MUL((double)self->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = KSL_MUL(q0_y_0, q0_y_0), q0_n_b = KSL_MUL(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_d = KSL_MUL(q0_y_2, q0_y_2), q0_n_e = q0_n_c + q0_n_d,
      q0_n = sqrt(q0_n_e);
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_sized_0 = KSL_MUL((double)self->m00, q0_up);
  const double q0_sized_1 = KSL_MUL((double)self->m01, q0_up);
  const double q0_sized_2 = KSL_MUL((double)self->m02, q0_up);
  const double q0_quotient_0 = q0_sized_0 / q0_divisor;
  const double q0_quotient_1 = q0_sized_1 / q0_divisor;
  const double q0_quotient_2 = q0_sized_2 / q0_divisor;
  const double q0_0 = KSL_MUL(q0_quotient_0, q0_down);
  const double q0_1 = KSL_MUL(q0_quotient_1, q0_down);
  const double q0_2 = KSL_MUL(q0_quotient_2, q0_down);
  const double u1_s_size_0 = fabs((double)self->m10);
  const double u1_s_size_1 = fabs((double)self->m11);
  const double u1_s_size_2 = fabs((double)self->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 4.611686018427388e+18 < u1_s_largest2 ? 2.710505431213761e-20 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.8014398509481984e+16 : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : u1_s_d;
  const double u1_y_0 = KSL_MUL((double)self->m10, u1_s);
  const double u1_y_1 = KSL_MUL((double)self->m11, u1_s);
  const double u1_y_2 = KSL_MUL((double)self->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = KSL_MUL(u1_y_0, u1_y_0), u1_n_b = KSL_MUL(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_d = KSL_MUL(u1_y_2, u1_y_2), u1_n_e = u1_n_c + u1_n_d,
      u1_n = sqrt(u1_n_e);
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_sized_0 = KSL_MUL((double)self->m10, u1_up);
  const double u1_sized_1 = KSL_MUL((double)self->m11, u1_up);
  const double u1_sized_2 = KSL_MUL((double)self->m12, u1_up);
  const double u1_quotient_0 = u1_sized_0 / u1_divisor;
  const double u1_quotient_1 = u1_sized_1 / u1_divisor;
  const double u1_quotient_2 = u1_sized_2 / u1_divisor;
  const double u1_0 = KSL_MUL(u1_quotient_0, u1_down);
  const double u1_1 = KSL_MUL(u1_quotient_1, u1_down);
  const double u1_2 = KSL_MUL(u1_quotient_2, u1_down);
  const double along_a = KSL_MUL(q0_0, u1_0), along_b = KSL_MUL(q0_1, u1_1),
      along_c = along_a + along_b, along_d = KSL_MUL(q0_2, u1_2), along = along_c + along_d;
  const double once_0a = KSL_MUL(q0_0, along), once_0 = u1_0 - once_0a;
  const double once_1a = KSL_MUL(q0_1, along), once_1 = u1_1 - once_1a;
  const double once_2a = KSL_MUL(q0_2, along), once_2 = u1_2 - once_2a;
  const double rest_a = KSL_MUL(q0_0, once_0), rest_b = KSL_MUL(q0_1, once_1),
      rest_c = rest_a + rest_b, rest_d = KSL_MUL(q0_2, once_2), rest = rest_c + rest_d;
  const double twice_0a = KSL_MUL(q0_0, rest), twice_0 = once_0 - twice_0a;
  const double twice_1a = KSL_MUL(q0_1, rest), twice_1 = once_1 - twice_1a;
  const double twice_2a = KSL_MUL(q0_2, rest), twice_2 = once_2 - twice_2a;
  const double n_a = KSL_MUL(twice_0, twice_0), n_b = KSL_MUL(twice_1, twice_1), n_c = n_a + n_b,
      n_d = KSL_MUL(twice_2, twice_2), n_e = n_c + n_d, n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor;
  const double q1_1 = twice_1 / divisor;
  const double q1_2 = twice_2 / divisor;
  const double normal_0a = KSL_MUL(q0_1, q1_2), normal_0b = KSL_MUL(q0_2, q1_1),
      normal_0 = normal_0a - normal_0b;
  const double normal_1a = KSL_MUL(q0_2, q1_0), normal_1b = KSL_MUL(q0_0, q1_2),
      normal_1 = normal_1a - normal_1b;
  const double normal_2a = KSL_MUL(q0_0, q1_1), normal_2b = KSL_MUL(q0_1, q1_0),
      normal_2 = normal_2a - normal_2b;
  const double u2_s_size_0 = fabs((double)self->m20);
  const double u2_s_size_1 = fabs((double)self->m21);
  const double u2_s_size_2 = fabs((double)self->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 4.611686018427388e+18 < u2_s_largest2 ? 2.710505431213761e-20 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.8014398509481984e+16 : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : u2_s_d;
  const double u2_y_0 = KSL_MUL((double)self->m20, u2_s);
  const double u2_y_1 = KSL_MUL((double)self->m21, u2_s);
  const double u2_y_2 = KSL_MUL((double)self->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = KSL_MUL(u2_y_0, u2_y_0), u2_n_b = KSL_MUL(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_d = KSL_MUL(u2_y_2, u2_y_2), u2_n_e = u2_n_c + u2_n_d,
      u2_n = sqrt(u2_n_e);
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_sized_0 = KSL_MUL((double)self->m20, u2_up);
  const double u2_sized_1 = KSL_MUL((double)self->m21, u2_up);
  const double u2_sized_2 = KSL_MUL((double)self->m22, u2_up);
  const double u2_quotient_0 = u2_sized_0 / u2_divisor;
  const double u2_quotient_1 = u2_sized_1 / u2_divisor;
  const double u2_quotient_2 = u2_sized_2 / u2_divisor;
  const double u2_0 = KSL_MUL(u2_quotient_0, u2_down);
  const double u2_1 = KSL_MUL(u2_quotient_1, u2_down);
  const double u2_2 = KSL_MUL(u2_quotient_2, u2_down);
  const double side_a = KSL_MUL(normal_0, u2_0), side_b = KSL_MUL(normal_1, u2_1),
      side_c = side_a + side_b, side_d = KSL_MUL(normal_2, u2_2), side = side_c + side_d;
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 9.5367431640625e-07 ? 1.0 : 0.0;
  const double self_00_new = dependent == 1.0 ? (double)NAN : q0_0;
  const double self_01_new = dependent == 1.0 ? (double)NAN : q0_1;
  const double self_02_new = dependent == 1.0 ? (double)NAN : q0_2;
  const double self_10_new = dependent == 1.0 ? (double)NAN : q1_0;
  const double self_11_new = dependent == 1.0 ? (double)NAN : q1_1;
  const double self_12_new = dependent == 1.0 ? (double)NAN : q1_2;
  const double self_20_new = dependent == 1.0 ? (double)NAN : q2_0;
  const double self_21_new = dependent == 1.0 ? (double)NAN : q2_1;
  const double self_22_new = dependent == 1.0 ? (double)NAN : q2_2;
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
  const double q0_s_size_0 = fabs((double)R->m00);
  const double q0_s_size_1 = fabs((double)R->m01);
  const double q0_s_size_2 = fabs((double)R->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 4.611686018427388e+18 < q0_s_largest2 ? 2.710505431213761e-20 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.8014398509481984e+16 : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : q0_s_d;
  const double q0_y_0 = KSL_MUL((double)R->m00, q0_s);
  const double q0_y_1 = KSL_MUL((double)R->m01, q0_s);
  const double q0_y_2 = KSL_MUL((double)R->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = KSL_MUL(q0_y_0, q0_y_0), q0_n_b = KSL_MUL(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_d = KSL_MUL(q0_y_2, q0_y_2), q0_n_e = q0_n_c + q0_n_d,
      q0_n = sqrt(q0_n_e);
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_sized_0 = KSL_MUL((double)R->m00, q0_up);
  const double q0_sized_1 = KSL_MUL((double)R->m01, q0_up);
  const double q0_sized_2 = KSL_MUL((double)R->m02, q0_up);
  const double q0_quotient_0 = q0_sized_0 / q0_divisor;
  const double q0_quotient_1 = q0_sized_1 / q0_divisor;
  const double q0_quotient_2 = q0_sized_2 / q0_divisor;
  const double q0_0 = KSL_MUL(q0_quotient_0, q0_down);
  const double q0_1 = KSL_MUL(q0_quotient_1, q0_down);
  const double q0_2 = KSL_MUL(q0_quotient_2, q0_down);
  const double u1_s_size_0 = fabs((double)R->m10);
  const double u1_s_size_1 = fabs((double)R->m11);
  const double u1_s_size_2 = fabs((double)R->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 4.611686018427388e+18 < u1_s_largest2 ? 2.710505431213761e-20 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.8014398509481984e+16 : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : u1_s_d;
  const double u1_y_0 = KSL_MUL((double)R->m10, u1_s);
  const double u1_y_1 = KSL_MUL((double)R->m11, u1_s);
  const double u1_y_2 = KSL_MUL((double)R->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = KSL_MUL(u1_y_0, u1_y_0), u1_n_b = KSL_MUL(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_d = KSL_MUL(u1_y_2, u1_y_2), u1_n_e = u1_n_c + u1_n_d,
      u1_n = sqrt(u1_n_e);
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_sized_0 = KSL_MUL((double)R->m10, u1_up);
  const double u1_sized_1 = KSL_MUL((double)R->m11, u1_up);
  const double u1_sized_2 = KSL_MUL((double)R->m12, u1_up);
  const double u1_quotient_0 = u1_sized_0 / u1_divisor;
  const double u1_quotient_1 = u1_sized_1 / u1_divisor;
  const double u1_quotient_2 = u1_sized_2 / u1_divisor;
  const double u1_0 = KSL_MUL(u1_quotient_0, u1_down);
  const double u1_1 = KSL_MUL(u1_quotient_1, u1_down);
  const double u1_2 = KSL_MUL(u1_quotient_2, u1_down);
  const double along_a = KSL_MUL(q0_0, u1_0), along_b = KSL_MUL(q0_1, u1_1),
      along_c = along_a + along_b, along_d = KSL_MUL(q0_2, u1_2), along = along_c + along_d;
  const double once_0a = KSL_MUL(q0_0, along), once_0 = u1_0 - once_0a;
  const double once_1a = KSL_MUL(q0_1, along), once_1 = u1_1 - once_1a;
  const double once_2a = KSL_MUL(q0_2, along), once_2 = u1_2 - once_2a;
  const double rest_a = KSL_MUL(q0_0, once_0), rest_b = KSL_MUL(q0_1, once_1),
      rest_c = rest_a + rest_b, rest_d = KSL_MUL(q0_2, once_2), rest = rest_c + rest_d;
  const double twice_0a = KSL_MUL(q0_0, rest), twice_0 = once_0 - twice_0a;
  const double twice_1a = KSL_MUL(q0_1, rest), twice_1 = once_1 - twice_1a;
  const double twice_2a = KSL_MUL(q0_2, rest), twice_2 = once_2 - twice_2a;
  const double n_a = KSL_MUL(twice_0, twice_0), n_b = KSL_MUL(twice_1, twice_1), n_c = n_a + n_b,
      n_d = KSL_MUL(twice_2, twice_2), n_e = n_c + n_d, n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor;
  const double q1_1 = twice_1 / divisor;
  const double q1_2 = twice_2 / divisor;
  const double normal_0a = KSL_MUL(q0_1, q1_2), normal_0b = KSL_MUL(q0_2, q1_1),
      normal_0 = normal_0a - normal_0b;
  const double normal_1a = KSL_MUL(q0_2, q1_0), normal_1b = KSL_MUL(q0_0, q1_2),
      normal_1 = normal_1a - normal_1b;
  const double normal_2a = KSL_MUL(q0_0, q1_1), normal_2b = KSL_MUL(q0_1, q1_0),
      normal_2 = normal_2a - normal_2b;
  const double u2_s_size_0 = fabs((double)R->m20);
  const double u2_s_size_1 = fabs((double)R->m21);
  const double u2_s_size_2 = fabs((double)R->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 4.611686018427388e+18 < u2_s_largest2 ? 2.710505431213761e-20 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.8014398509481984e+16 : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : u2_s_d;
  const double u2_y_0 = KSL_MUL((double)R->m20, u2_s);
  const double u2_y_1 = KSL_MUL((double)R->m21, u2_s);
  const double u2_y_2 = KSL_MUL((double)R->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = KSL_MUL(u2_y_0, u2_y_0), u2_n_b = KSL_MUL(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_d = KSL_MUL(u2_y_2, u2_y_2), u2_n_e = u2_n_c + u2_n_d,
      u2_n = sqrt(u2_n_e);
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_sized_0 = KSL_MUL((double)R->m20, u2_up);
  const double u2_sized_1 = KSL_MUL((double)R->m21, u2_up);
  const double u2_sized_2 = KSL_MUL((double)R->m22, u2_up);
  const double u2_quotient_0 = u2_sized_0 / u2_divisor;
  const double u2_quotient_1 = u2_sized_1 / u2_divisor;
  const double u2_quotient_2 = u2_sized_2 / u2_divisor;
  const double u2_0 = KSL_MUL(u2_quotient_0, u2_down);
  const double u2_1 = KSL_MUL(u2_quotient_1, u2_down);
  const double u2_2 = KSL_MUL(u2_quotient_2, u2_down);
  const double side_a = KSL_MUL(normal_0, u2_0), side_b = KSL_MUL(normal_1, u2_1),
      side_c = side_a + side_b, side_d = KSL_MUL(normal_2, u2_2), side = side_c + side_d;
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 9.5367431640625e-07 ? 1.0 : 0.0;
  const double Ro_00 = dependent == 1.0 ? (double)NAN : q0_0;
  const double Ro_01 = dependent == 1.0 ? (double)NAN : q0_1;
  const double Ro_02 = dependent == 1.0 ? (double)NAN : q0_2;
  const double Ro_10 = dependent == 1.0 ? (double)NAN : q1_0;
  const double Ro_11 = dependent == 1.0 ? (double)NAN : q1_1;
  const double Ro_12 = dependent == 1.0 ? (double)NAN : q1_2;
  const double Ro_20 = dependent == 1.0 ? (double)NAN : q2_0;
  const double Ro_21 = dependent == 1.0 ? (double)NAN : q2_1;
  const double Ro_22 = dependent == 1.0 ? (double)NAN : q2_2;
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
  const double versine_axis_0 = KSL_MUL((double)axis->x, versine);
  const double versine_axis_1 = KSL_MUL((double)axis->y, versine);
  const double versine_axis_2 = KSL_MUL((double)axis->z, versine);
  const double m_0 = KSL_MUL((double)axis->x, versine_axis_0);
  const double m_1 = KSL_MUL((double)axis->y, versine_axis_1);
  const double m_2 = KSL_MUL((double)axis->z, versine_axis_2);
  const double m_3 = KSL_MUL((double)axis->y, versine_axis_0);
  const double m_4 = KSL_MUL((double)axis->z, versine_axis_0);
  const double m_5 = KSL_MUL((double)axis->z, versine_axis_1);
  const double sine_axis_0 = (double)axis->x * (double)dc[0];
  const double sine_axis_1 = (double)axis->y * (double)dc[0];
  const double sine_axis_2 = (double)axis->z * (double)dc[0];
  const double R_00 = (double)dc[1] + m_0;
  const double R_01 = m_3 - sine_axis_2;
  const double R_02 = m_4 + sine_axis_1;
  const double R_10 = m_3 + sine_axis_2;
  const double R_11 = (double)dc[1] + m_1;
  const double R_12 = m_5 - sine_axis_0;
  const double R_20 = m_4 - sine_axis_1;
  const double R_21 = m_5 + sine_axis_0;
  const double R_22 = (double)dc[1] + m_2;
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
  const double first_0 = KSL_MUL(c_1, c_2);
  const double first_1a = KSL_MUL(s_2, c_1), first_1 = -first_1a;
  const double first_6a = KSL_MUL(s_1, c_2), first_6 = -first_6a;
  const double first_7 = KSL_MUL(s_1, s_2);
  const double last_3a = KSL_MUL(s_2, c_0), last_3b = KSL_MUL(s_0, first_6),
      last_3 = last_3a - last_3b;
  const double last_4a = KSL_MUL(c_0, c_2), last_4b = KSL_MUL(s_0, first_7),
      last_4 = last_4a - last_4b;
  const double last_5a = KSL_MUL(s_0, c_1), last_5 = -last_5a;
  const double last_6a = KSL_MUL(s_0, s_2), last_6b = KSL_MUL(c_0, first_6),
      last_6 = last_6a + last_6b;
  const double last_7a = KSL_MUL(s_0, c_2), last_7b = KSL_MUL(c_0, first_7),
      last_7 = last_7a + last_7b;
  const double last_8 = KSL_MUL(c_0, c_1);
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
  const double n_a = (double)R->m00 * (double)R->m00,
      n_c = ksl_product_sum((double)R->m01, (double)R->m01, n_a), n = sqrt(n_c);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = (double)R->m00 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine_a = -(double)R->m01, sine = sine_a / divisor;
  const double polar = ksl_atan2(sine_a, (double)R->m00);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1a = KSL_MUL((double)R->m10, sine), left_1b = KSL_MUL((double)R->m11, cosine),
      left_1 = left_1a + left_1b;
  const double left_2a = KSL_MUL((double)R->m20, sine), left_2b = KSL_MUL((double)R->m21, cosine),
      left_2 = left_2a + left_2b;
  const double rest = (double)R->m12 + (double)R->m22;
  const double first = ksl_atan2(left_2, left_1);
  const double angles_0 = rest < 1.2676506002282294e+30 ? first : rest;
  const double angles_1 = ksl_atan2((double)R->m02, n);
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
  const double first_1 = KSL_MUL(s_1, s_2);
  const double first_2 = KSL_MUL(s_1, c_2);
  const double first_7 = KSL_MUL(s_2, c_1);
  const double first_8 = KSL_MUL(c_1, c_2);
  const double last_3 = KSL_MUL(s_0, s_1);
  const double last_4a = KSL_MUL(c_0, c_2), last_4b = KSL_MUL(s_0, first_7),
      last_4 = last_4a - last_4b;
  const double last_5a = KSL_MUL(s_0, first_8), last_5b = KSL_MUL(s_2, c_0),
      last_5c_lead = -last_5a, last_5 = last_5c_lead - last_5b;
  const double last_6a = KSL_MUL(s_1, c_0), last_6 = -last_6a;
  const double last_7a = KSL_MUL(s_0, c_2), last_7b = KSL_MUL(c_0, first_7),
      last_7 = last_7a + last_7b;
  const double last_8a = KSL_MUL(c_0, first_8), last_8b = KSL_MUL(s_0, s_2),
      last_8 = last_8a - last_8b;
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
  const double n_a = (double)R->m01 * (double)R->m01,
      n_c = ksl_product_sum((double)R->m02, (double)R->m02, n_a), n = sqrt(n_c);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = (double)R->m02 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine = (double)R->m01 / divisor;
  const double polar = ksl_atan2((double)R->m01, (double)R->m02);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1a = KSL_MUL((double)R->m11, cosine), left_1b = KSL_MUL((double)R->m12, sine),
      left_1 = left_1a - left_1b;
  const double left_2a = KSL_MUL((double)R->m21, cosine), left_2b = KSL_MUL((double)R->m22, sine),
      left_2 = left_2a - left_2b;
  const double rest = (double)R->m10 + (double)R->m20;
  const double first = ksl_atan2(left_2, left_1);
  const double angles_0 = rest < 1.2676506002282294e+30 ? first : rest;
  const double angles_1 = ksl_atan2(n, (double)R->m00);
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
  const double size_a = KSL_MUL(theta, theta), size_b = 1.0 + size_a, size_c = sqrt(size_b),
      size = magnitude + size_c;
  const double along_a = -size, along = theta < 0.0 ? along_a : size;
  const double t_a = 1.0 / along, t = twice == 0.0 ? 0.0 : t_a;
  const double secant_a = KSL_MUL(t, t), secant_b = 1.0 + secant_a, secant = sqrt(secant_b);
  const double c = 1.0 / secant;
  const double s = KSL_MUL(t, c);
  const double change = KSL_MUL((double)A->m10, t);
  const double zp_a = KSL_MUL((double)A->m20, c), zp_b = KSL_MUL((double)A->m21, s),
      zp = zp_a - zp_b;
  const double zq_a = KSL_MUL((double)A->m20, s), zq_b = KSL_MUL((double)A->m21, c),
      zq = zq_a + zq_b;
  const double vp_0a = KSL_MUL((double)V->m00, c), vp_0b = KSL_MUL((double)V->m01, s),
      vp_0 = vp_0a - vp_0b;
  const double vp_1a = KSL_MUL((double)V->m10, c), vp_1b = KSL_MUL((double)V->m11, s),
      vp_1 = vp_1a - vp_1b;
  const double vp_2a = KSL_MUL((double)V->m20, c), vp_2b = KSL_MUL((double)V->m21, s),
      vp_2 = vp_2a - vp_2b;
  const double vq_0a = KSL_MUL((double)V->m00, s), vq_0b = KSL_MUL((double)V->m01, c),
      vq_0 = vq_0a + vq_0b;
  const double vq_1a = KSL_MUL((double)V->m10, s), vq_1b = KSL_MUL((double)V->m11, c),
      vq_1 = vq_1a + vq_1b;
  const double vq_2a = KSL_MUL((double)V->m20, s), vq_2b = KSL_MUL((double)V->m21, c),
      vq_2 = vq_2a + vq_2b;
  const double A_00_new = (double)A->m11 + change;
  const double A_22_new = (double)A->m00 - change;
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
  const double n_0a = (double)R->m11 * (double)R->m22,
      n_0 = ksl_product_sum(-(double)R->m12, (double)R->m21, n_0a);
  const double n_1a = (double)R->m02 * (double)R->m21,
      n_1 = ksl_product_sum(-(double)R->m01, (double)R->m22, n_1a);
  const double n_2a = (double)R->m01 * (double)R->m12,
      n_2 = ksl_product_sum(-(double)R->m02, (double)R->m11, n_2a);
  const double det_a = KSL_MUL((double)R->m00, n_0), det_b = KSL_MUL((double)R->m10, n_1),
      det_c = det_a + det_b, det_d = KSL_MUL((double)R->m20, n_2), det = det_c + det_d;
  const double g_0a = (double)R->m00 * (double)R->m00,
      g_0c = ksl_product_sum((double)R->m10, (double)R->m10, g_0a),
      g_0 = ksl_product_sum((double)R->m20, (double)R->m20, g_0c);
  const double g_1a = (double)R->m00 * (double)R->m01,
      g_1c = ksl_product_sum((double)R->m10, (double)R->m11, g_1a),
      g_1 = ksl_product_sum((double)R->m20, (double)R->m21, g_1c);
  const double g_2a = (double)R->m00 * (double)R->m02,
      g_2c = ksl_product_sum((double)R->m10, (double)R->m12, g_2a),
      g_2 = ksl_product_sum((double)R->m20, (double)R->m22, g_2c);
  const double g_3a = (double)R->m01 * (double)R->m01,
      g_3c = ksl_product_sum((double)R->m11, (double)R->m11, g_3a),
      g_3 = ksl_product_sum((double)R->m21, (double)R->m21, g_3c);
  const double g_4a = (double)R->m01 * (double)R->m02,
      g_4c = ksl_product_sum((double)R->m11, (double)R->m12, g_4a),
      g_4 = ksl_product_sum((double)R->m21, (double)R->m22, g_4c);
  const double g_5a = (double)R->m02 * (double)R->m02,
      g_5c = ksl_product_sum((double)R->m12, (double)R->m12, g_5a),
      g_5 = ksl_product_sum((double)R->m22, (double)R->m22, g_5c);
  const double off_0 = det - 1.0;
  const double off_1 = g_0 - 1.0;
  const double off_4 = g_3 - 1.0;
  const double off_6 = g_5 - 1.0;
  const double defect_size_0 = fabs(off_0);
  const double defect_size_1 = fabs(off_1);
  const double defect_size_2 = fabs(g_1);
  const double defect_size_3 = fabs(g_2);
  const double defect_size_4 = fabs(off_4);
  const double defect_size_5 = fabs(g_4);
  const double defect_size_6 = fabs(off_6);
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
  const double versine_a = KSL_MUL(h, h), versine_b = KSL_MUL(2.0, versine_a),
      versine_c = 1.0 - cosine, versine = cosine < 0.0 ? versine_c : versine_b;
  const double beta_v_0 = KSL_MUL((double)axis->x, versine);
  const double beta_v_1 = KSL_MUL((double)axis->y, versine);
  const double beta_v_2 = KSL_MUL((double)axis->z, versine);
  const double m_0 = KSL_MUL((double)axis->x, beta_v_0);
  const double m_1 = KSL_MUL((double)axis->y, beta_v_1);
  const double m_2 = KSL_MUL((double)axis->z, beta_v_2);
  const double m_3 = KSL_MUL((double)axis->y, beta_v_0);
  const double m_4 = KSL_MUL((double)axis->z, beta_v_0);
  const double m_5 = KSL_MUL((double)axis->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double alpha_v_0 = KSL_MUL((double)axis->x, sine);
  const double alpha_v_1 = KSL_MUL((double)axis->y, sine);
  const double alpha_v_2 = KSL_MUL((double)axis->z, sine);
  const double R_00 = 1.0 - others_0;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_11 = 1.0 - others_1;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double R_22 = 1.0 - others_2;
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
  const double p_0 = (double)R->m21 - (double)R->m12;
  const double p_1 = (double)R->m02 - (double)R->m20;
  const double p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21;
  const double s_1 = (double)R->m02 + (double)R->m20;
  const double s_2 = (double)R->m01 + (double)R->m10;
  const double first_0 = (double)R->m00 + 1.0;
  const double first_1 = 1.0 - (double)R->m00;
  const double others_0 = (double)R->m11 + (double)R->m22;
  const double others_1 = (double)R->m11 - (double)R->m22;
  const double d_0 = first_0 + others_0;
  const double d_1 = first_0 - others_0;
  const double d_2 = first_1 + others_1;
  const double d_3 = first_1 - others_1;
  const double low_0 = (double)R->m11 < (double)R->m00 ? d_1 : s_2;
  const double low_1 = (double)R->m11 < (double)R->m00 ? s_2 : d_2;
  const double low_2 = (double)R->m11 < (double)R->m00 ? s_1 : s_0;
  const double low_3 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = (double)R->m00 < high_0a ? s_0 : p_1;
  const double high_2 = (double)R->m00 < high_0a ? d_3 : p_2;
  const double high_3 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = (double)R->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = (double)R->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : v_s_b,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r_d = 1.0 < v_s ? 5.551115123125783e-17 : v_r_b,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = v_n == 0.0 ? 1.0 : v_n;
  const double unit_0 = v_y_0 / divisor;
  const double unit_1 = v_y_1 / divisor;
  const double unit_2 = v_y_2 / divisor;
  const double angle = KSL_MUL(2.0, half);
  const double axis_0 = v_n == 0.0 ? 1.0 : unit_0;
  axis->x = (float)axis_0;
  axis->y = (float)unit_1;
  axis->z = (float)unit_2;
  return (float)angle;
}

#endif
