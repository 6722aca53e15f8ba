/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_MAT3X3_CERTIFIED_H
#define KSL_MAT3X3_CERTIFIED_H

#include "ksl_types.h"
#include "ksl_exact.h"
#include "ksl_exactf.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x; |error of Ro| <= Ro_bound
     unless inf or NaN.
   w, dw: vector; Ro, Ro_bound: rotation or other 3×3 matrix.
   15 mul, 27 add, 3 neg, 9 abs. */
static inline void ksl_acceleration_tensor_certified(const ksl_vec3_t *w, const ksl_vec3_t *dw,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double ww_0 = KSL_MUL(w->x, w->x), ww_1 = KSL_MUL(w->y, w->y), ww_2 = KSL_MUL(w->z, w->z),
      ww_3 = KSL_MUL(w->x, w->y), ww_4 = KSL_MUL(w->x, w->z), ww_5 = KSL_MUL(w->y, w->z);
  const double Ro_00 = -(ww_1 + ww_2), Ro_01 = ww_3 - dw->z, Ro_02 = dw->y + ww_4,
      Ro_10 = dw->z + ww_3, Ro_11 = -(ww_0 + ww_2), Ro_12 = ww_5 - dw->x, Ro_20 = ww_4 - dw->y,
      Ro_21 = dw->x + ww_5, Ro_22 = -(ww_0 + ww_1);
  const double ww_1_abs = fabs(ww_1), ww_2_abs = fabs(ww_2);
  const double ww_3_abs = fabs(ww_3), dw_2_abs = fabs(dw->z), Ro_01_size = ww_3_abs + dw_2_abs;
  const double dw_1_abs = fabs(dw->y), ww_4_abs = fabs(ww_4), Ro_02_size = dw_1_abs + ww_4_abs;
  const double Ro_10_size = dw_2_abs + ww_3_abs, ww_0_abs = fabs(ww_0);
  const double ww_5_abs = fabs(ww_5), dw_0_abs = fabs(dw->x), Ro_12_size = ww_5_abs + dw_0_abs;
  const double Ro_20_size = ww_4_abs + dw_1_abs, Ro_21_size = dw_0_abs + ww_5_abs;
  const double Ro_00a_bound = KSL_MUL(2.2204460492503136e-16, ww_1_abs + ww_2_abs
          + 2.004168360008973e-292);
  const double Ro_01_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_size + 2.004168360008973e-292),
      Ro_02_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_size + 2.004168360008973e-292),
      Ro_10_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_size + 2.004168360008973e-292);
  const double Ro_11a_bound = KSL_MUL(2.2204460492503136e-16, ww_0_abs + ww_2_abs
          + 2.004168360008973e-292);
  const double Ro_12_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_size + 2.004168360008973e-292),
      Ro_20_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_size + 2.004168360008973e-292),
      Ro_21_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_size + 2.004168360008973e-292);
  const double Ro_22a_bound = KSL_MUL(2.2204460492503136e-16, ww_0_abs + ww_1_abs
          + 2.004168360008973e-292);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00a_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11a_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22a_bound;
}

/* det R; |error of det| <= det_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; det_bound: number.
   13 mul, 14 add, 9 abs. */
static inline double ksl_mat3x3_determinant_certified(const ksl_mat3x3_t *R, double *det_bound) {
  const double n_0a = KSL_MUL(R->m11, R->m22), n_0b = KSL_MUL(R->m12, R->m21), n_0 = n_0a - n_0b;
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1b = KSL_MUL(R->m01, R->m22), n_1 = n_1a - n_1b;
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2b = KSL_MUL(R->m02, R->m11), n_2 = n_2a - n_2b;
  const double det = KSL_MUL(R->m00, n_0) + KSL_MUL(R->m10, n_1) + KSL_MUL(R->m20, n_2);
  const double n_0_size = fabs(n_0a) + fabs(n_0b), n_1_size = fabs(n_1a) + fabs(n_1b),
      n_2_size = fabs(n_2a) + fabs(n_2b);
  const double det_c_size = KSL_MUL(fabs(R->m00), n_0_size + 2.004168360008973e-292)
          + KSL_MUL(fabs(R->m10), n_1_size + 2.004168360008973e-292),
      det_size = det_c_size + KSL_MUL(fabs(R->m20), n_2_size + 2.004168360008973e-292);
  const double det_bound_ = KSL_MUL(5.551115123125785e-16, det_size + 2.004168360008973e-292);
  *det_bound = det_bound_;
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ); |error of R| <= R_bound unless inf or NaN.
   R, R_bound: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   30 mul, 31 add, 8 abs. */
static inline void ksl_mat3x3_setFromAxisDC_certified(ksl_mat3x3_t *R, const ksl_vec3_t *axis,
    const double dc[2], ksl_mat3x3_t *R_bound) {
  const double versine = 1.0 - dc[1];
  const double versine_axis_0 = KSL_MUL(axis->x, versine),
      versine_axis_1 = KSL_MUL(axis->y, versine), versine_axis_2 = KSL_MUL(axis->z, versine);
  const double m_0 = KSL_MUL(axis->x, versine_axis_0);
  const double m_1 = KSL_MUL(axis->y, versine_axis_1);
  const double m_2 = KSL_MUL(axis->z, versine_axis_2), m_3 = KSL_MUL(axis->y, versine_axis_0),
      m_4 = KSL_MUL(axis->z, versine_axis_0), m_5 = KSL_MUL(axis->z, versine_axis_1);
  const double sine_axis_0 = KSL_MUL(axis->x, dc[0]), sine_axis_1 = KSL_MUL(axis->y, dc[0]),
      sine_axis_2 = KSL_MUL(axis->z, dc[0]);
  const double R_00 = dc[1] + m_0, R_01 = m_3 - sine_axis_2, R_02 = m_4 + sine_axis_1,
      R_10 = m_3 + sine_axis_2, R_11 = dc[1] + m_1, R_12 = m_5 - sine_axis_0,
      R_20 = m_4 - sine_axis_1, R_21 = m_5 + sine_axis_0, R_22 = dc[1] + m_2;
  const double axis_0_abs = fabs(axis->x), versine_abs = fabs(versine),
      versine_axis_0_size = KSL_MUL(axis_0_abs, versine_abs);
  const double axis_1_abs = fabs(axis->y), versine_axis_1_size = KSL_MUL(axis_1_abs, versine_abs);
  const double axis_2_abs = fabs(axis->z), versine_axis_2_size = KSL_MUL(axis_2_abs, versine_abs);
  const double versine_axis_0_padded = versine_axis_0_size + 2.004168360008973e-292;
  const double m_0_size = KSL_MUL(axis_0_abs, versine_axis_0_padded);
  const double versine_axis_1_padded = versine_axis_1_size + 2.004168360008973e-292;
  const double m_1_size = KSL_MUL(axis_1_abs, versine_axis_1_padded),
      m_2_size = KSL_MUL(axis_2_abs, versine_axis_2_size + 2.004168360008973e-292),
      m_3_size = KSL_MUL(axis_1_abs, versine_axis_0_padded),
      m_4_size = KSL_MUL(axis_2_abs, versine_axis_0_padded),
      m_5_size = KSL_MUL(axis_2_abs, versine_axis_1_padded);
  const double dc_1_abs = fabs(dc[1]), R_00_size = dc_1_abs + m_0_size;
  const double sine_axis_2_abs = fabs(sine_axis_2), R_01_size = m_3_size + sine_axis_2_abs;
  const double sine_axis_1_abs = fabs(sine_axis_1), R_02_size = m_4_size + sine_axis_1_abs;
  const double R_10_size = m_3_size + sine_axis_2_abs, R_11_size = dc_1_abs + m_1_size;
  const double sine_axis_0_abs = fabs(sine_axis_0), R_12_size = m_5_size + sine_axis_0_abs;
  const double R_20_size = m_4_size + sine_axis_1_abs, R_21_size = m_5_size + sine_axis_0_abs,
      R_22_size = dc_1_abs + m_2_size;
  const double R_00_bound = KSL_MUL(4.440892098500628e-16, R_00_size + 2.004168360008973e-292),
      R_01_bound = KSL_MUL(4.440892098500628e-16, R_01_size + 2.004168360008973e-292),
      R_02_bound = KSL_MUL(4.440892098500628e-16, R_02_size + 2.004168360008973e-292),
      R_10_bound = KSL_MUL(4.440892098500628e-16, R_10_size + 2.004168360008973e-292),
      R_11_bound = KSL_MUL(4.440892098500628e-16, R_11_size + 2.004168360008973e-292),
      R_12_bound = KSL_MUL(4.440892098500628e-16, R_12_size + 2.004168360008973e-292),
      R_20_bound = KSL_MUL(4.440892098500628e-16, R_20_size + 2.004168360008973e-292),
      R_21_bound = KSL_MUL(4.440892098500628e-16, R_21_size + 2.004168360008973e-292),
      R_22_bound = KSL_MUL(4.440892098500628e-16, R_22_size + 2.004168360008973e-292);
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
  R_bound->m00 = R_00_bound;
  R_bound->m01 = R_01_bound;
  R_bound->m02 = R_02_bound;
  R_bound->m10 = R_10_bound;
  R_bound->m11 = R_11_bound;
  R_bound->m12 = R_12_bound;
  R_bound->m20 = R_20_bound;
  R_bound->m21 = R_21_bound;
  R_bound->m22 = R_22_bound;
}

/* R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.
   angles: vector; R, R_bound: rotation or other 3×3 matrix.
   291 mul, 434 add, 39 product error, 8 product rest, 3 div, 9 neg, 18 abs, 3 less, 3 select. */
static inline void ksl_mat3x3_from_euler_xyz_certified(const ksl_vec3_t *angles, ksl_mat3x3_t *R,
    ksl_mat3x3_t *R_bound) {
  double c_0; const double s_0 = ksl_sincos(angles->x, &c_0);
  double c_own_error_1; const double s_own_error_1 = ksl_sincos_error(angles->x, s_0, c_0,
      &c_own_error_1);
  double c_1; const double s_1 = ksl_sincos(angles->y, &c_1);
  double c_own_error_2; const double s_own_error_2 = ksl_sincos_error(angles->y, s_1, c_1,
      &c_own_error_2);
  double c_2; const double s_2 = ksl_sincos(angles->z, &c_2);
  double c_own_error_3; const double s_own_error_3 = ksl_sincos_error(angles->z, s_2, c_2,
      &c_own_error_3);
  const double first_0 = KSL_MUL(c_1, c_2), first_1 = -KSL_MUL(s_2, c_1),
      first_6 = -KSL_MUL(s_1, c_2), first_7 = KSL_MUL(s_1, s_2);
  const double last_3a = KSL_MUL(s_2, c_0),
      first_lo_1 = ksl_product_error(-s_1, c_2, first_6) +
          -(KSL_MUL(s_own_error_2, c_2) + KSL_MUL(s_1, c_own_error_3)),
      last_3b = KSL_MUL(s_0, first_6), last_3 = last_3a - last_3b, last_right_1 = last_3a - last_3,
      last_cross_1 = KSL_MUL(s_own_error_3, c_0) + KSL_MUL(s_2, c_own_error_1)
          - (KSL_MUL(s_own_error_1, first_6) + KSL_MUL(s_0, first_lo_1));
  const double last_4a = KSL_MUL(c_0, c_2),
      first_lo_2 = ksl_product_error(s_1, s_2, first_7)
          + (KSL_MUL(s_own_error_2, s_2) + KSL_MUL(s_1, s_own_error_3)),
      last_4b = KSL_MUL(s_0, first_7), last_4 = last_4a - last_4b, last_right_2 = last_4a - last_4,
      last_cross_2 = KSL_MUL(c_own_error_1, c_2) + KSL_MUL(c_0, c_own_error_3)
          - (KSL_MUL(s_own_error_1, first_7) + KSL_MUL(s_0, first_lo_2));
  const double last_5 = -KSL_MUL(s_0, c_1);
  const double last_6a = KSL_MUL(s_0, s_2), last_6b = KSL_MUL(c_0, first_6),
      last_6 = last_6a + last_6b, last_right_3 = last_6 - last_6a,
      last_cross_4 = KSL_MUL(s_own_error_1, s_2) + KSL_MUL(s_0, s_own_error_3)
          + (KSL_MUL(c_own_error_1, first_6) + KSL_MUL(c_0, first_lo_1));
  const double last_7a = KSL_MUL(s_0, c_2), last_7b = KSL_MUL(c_0, first_7),
      last_7 = last_7a + last_7b, last_right_4 = last_7 - last_7a,
      last_cross_5 = KSL_MUL(s_own_error_1, c_2) + KSL_MUL(s_0, c_own_error_3)
          + (KSL_MUL(c_own_error_1, first_7) + KSL_MUL(c_0, first_lo_2));
  const double last_8 = KSL_MUL(c_0, c_1);
  const double last_error_1 = fabs(ksl_product_rest(s_2, c_0, last_3a, last_3 + last_right_1)
          - ksl_product_rest(s_0, first_6, last_3b, last_right_1) + last_cross_1),
      last_error_2 = fabs(ksl_product_rest(c_0, c_2, last_4a, last_4 + last_right_2)
          - ksl_product_rest(s_0, first_7, last_4b, last_right_2) + last_cross_2),
      last_error_5 = fabs(ksl_product_rest(s_0, s_2, last_6a, last_6 - last_right_3)
          + ksl_product_rest(c_0, first_6, last_6b, last_right_3) + last_cross_4),
      last_error_6 = fabs(ksl_product_rest(s_0, c_2, last_7a, last_7 - last_right_4)
          + ksl_product_rest(c_0, first_7, last_7b, last_right_4) + last_cross_5),
      first_bound_1 = 7.814654941017999e-30
          + fabs(ksl_product_error(c_1, c_2, first_0)
          + (KSL_MUL(c_own_error_2, c_2) + KSL_MUL(c_1, c_own_error_3))),
      first_bound_2 = 7.814654941017999e-30
          + fabs(ksl_product_error(-s_2, c_1, first_1) +
          -(KSL_MUL(s_own_error_3, c_1) + KSL_MUL(s_2, c_own_error_2))),
      s_bound_1 = 3.7470896994678994e-30 + fabs(s_own_error_2),
      last_bound_1 = 2.684592926357104e-29 + last_error_1,
      last_bound_2 = 2.684592926357104e-29 + last_error_2,
      last_bound_3 = 7.814654941017999e-30
          + fabs(ksl_product_error(-s_0, c_1, last_5) +
          -(KSL_MUL(s_own_error_1, c_1) + KSL_MUL(s_0, c_own_error_2))),
      last_bound_4 = 2.684592926357104e-29 + last_error_5,
      last_bound_5 = 2.684592926357104e-29 + last_error_6,
      last_bound_6 = 7.814654941017999e-30
          + fabs(ksl_product_error(c_0, c_1, last_8)
          + (KSL_MUL(c_own_error_1, c_1) + KSL_MUL(c_0, c_own_error_2)));
  R->m00 = first_0;
  R->m01 = first_1;
  R->m02 = s_1;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
  R_bound->m00 = first_bound_1;
  R_bound->m01 = first_bound_2;
  R_bound->m02 = s_bound_1;
  R_bound->m10 = last_bound_1;
  R_bound->m11 = last_bound_2;
  R_bound->m12 = last_bound_3;
  R_bound->m20 = last_bound_4;
  R_bound->m21 = last_bound_5;
  R_bound->m22 = last_bound_6;
}

/* angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
     [-π/2, π/2]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; angles, angles_bound: vector.
   455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 4 neg, 72 abs, 12
     copysign, 59 less, 14 equal, 108 select. */
static inline void ksl_euler_xyz_from_mat3x3_certified(const ksl_mat3x3_t *R, ksl_vec3_t *angles,
    ksl_vec3_t *angles_bound) {
  const double n_a = KSL_MUL(R->m00, R->m00), n_a_size_1 = fabs(R->m00),
      n_b = KSL_MUL(R->m01, R->m01), n_b_size_1 = fabs(R->m01), n_c = n_a + n_b,
      n_c_right_1 = n_c - n_a,
      n_c_lo = ksl_product_rest(R->m00, R->m00, n_a, n_c - n_c_right_1)
          + ksl_product_rest(R->m01, R->m01, n_b, n_c_right_1), n = sqrt(n_c),
      n_product_1 = KSL_MUL(n, n), n_twice_1 = n + n,
      n_lo = (n_c - n_product_1 - ksl_product_error(n, n, n_product_1) + n_c_lo)
          / (n == 0.0 ? 1.0 : n_twice_1),
      n_padded_1 = 1.8051943758648296e-276
          + (KSL_MUL(n_a_size_1, n_a_size_1) + KSL_MUL(n_b_size_1, n_b_size_1)),
      n_bound_1 = fabs(n_c_lo) + KSL_MUL(9.614242987677729e-31, n_padded_1),
      n_size_4 = KSL_MUL(fabs(n_c) + KSL_MUL(140737488355328.0, n_bound_1), n_padded_1 / n / n_c),
      n_size_6 = fabs(n_lo), n_size_8 = KSL_MUL(4.916947487854274e+29, sqrt(n_bound_1) + n_size_6),
      n_size_12 = n + (KSL_MUL(4.0, n_bound_1) < n_c ? n_size_4 : n_size_8);
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo,
      divisor_padded_1 = 1.8051943758648296e-276 + n_size_12,
      divisor_bound_1 = KSL_MUL(2.230997459167166e-30, divisor_padded_1) + n_size_6,
      divisor_size_3 = fabs(n - 0.0), divisor_size_7 = divisor_bound_1 + fabs(1.0 - n);
  const double cosine_a = R->m00 / divisor, cosine_a_product_1 = KSL_MUL(cosine_a, divisor),
      cosine_a_lo = (R->m00 - cosine_a_product_1
          - ksl_product_error(cosine_a, divisor, cosine_a_product_1)
          - KSL_MUL(cosine_a, divisor_lo)) / divisor;
  const double divisor_size_10 = (n == 0.0 ? 1.0 : n_size_12)
          + KSL_MUL(1.5845630613906556e+29, divisor_bound_1 < divisor_size_3 ? 0.0
          : divisor_size_7);
  const double cosine_a_padded_2 = 1.8051943758648296e-276 + divisor_size_10,
      cosine_a_size_1 = fabs(cosine_a), cosine_a_size_2 = fabs(divisor),
      cosine_a_bound_1 = fabs(divisor_lo) + KSL_MUL(6.508104019725916e-30, cosine_a_padded_2),
      cosine_a_size_7 = KSL_MUL(4.0, cosine_a_bound_1) < cosine_a_size_2 ? cosine_a_size_2 : 0.0,
      cosine_a_reach_1 = cosine_a_size_2 + KSL_MUL(140737488355328.0, cosine_a_bound_1),
      cosine_a_size_9 = KSL_MUL(cosine_a_reach_1, (1.8051943758648296e-276 + n_a_size_1
          + KSL_MUL(cosine_a_padded_2, cosine_a_size_1)) / cosine_a_size_7),
      cosine_a_size_11 = cosine_a_size_1 + cosine_a_size_9 / cosine_a_size_2,
      cosine = n == 0.0 ? 1.0 : cosine_a, cosine_lo = n == 0.0 ? 0.0 : cosine_a_lo,
      cosine_size_4 = fabs(cosine_a_lo)
          + KSL_MUL(9.910067449317813e-30, 1.8051943758648296e-276 + cosine_a_size_11)
          + fabs(1.0 - cosine_a);
  const double sine_a = -R->m01, sine = sine_a / divisor, sine_product_1 = KSL_MUL(sine, divisor),
      sine_lo = (sine_a - sine_product_1 - ksl_product_error(sine, divisor, sine_product_1)
          - KSL_MUL(sine, divisor_lo)) / divisor, sine_size_1 = fabs(sine),
      sine_size_5 = KSL_MUL(cosine_a_reach_1, (1.8051943758648296e-276 + n_b_size_1
          + KSL_MUL(cosine_a_padded_2, sine_size_1)) / cosine_a_size_7);
  const double polar = ksl_atan2(sine_a, R->m00),
      polar_own_error_1 = ksl_atan2_error(sine_a, R->m00, polar), polar_size_1 = fabs(polar);
  const double third = n == 0.0 ? 0.0 : polar,
      third_size_4 = fabs(polar_own_error_1)
          + KSL_MUL(3.7470896994679e-30, 1.8051943758648296e-276 + polar_size_1)
          + fabs(0.0 - polar);
  const double left_1a = KSL_MUL(R->m10, sine),
      left_1a_padded_1 = 1.8051943758648296e-276 + (sine_size_1 + sine_size_5 / cosine_a_size_2),
      left_1b = KSL_MUL(R->m11, cosine);
  const double cosine_size_7 = (n == 0.0 ? 1.0 : cosine_a_size_11)
          + KSL_MUL(1.0401233252484625e+29, divisor_bound_1 < divisor_size_3 ? 0.0 : cosine_size_4);
  const double left_1b_padded_1 = 1.8051943758648296e-276 + cosine_size_7,
      left_1 = left_1a + left_1b, left_right_1 = left_1 - left_1a,
      left_lo1_1 = ksl_product_rest(R->m10, sine, left_1a, left_1 - left_right_1)
          + ksl_product_rest(R->m11, cosine, left_1b, left_right_1),
      left_lo_1 = left_lo1_1 + (KSL_MUL(R->m10, sine_lo) + KSL_MUL(R->m11, cosine_lo));
  const double left_2a = KSL_MUL(R->m20, sine), left_2b = KSL_MUL(R->m21, cosine),
      left_2 = left_2a + left_2b, left_right_2 = left_2 - left_2a,
      left_lo1_2 = ksl_product_rest(R->m20, sine, left_2a, left_2 - left_right_2)
          + ksl_product_rest(R->m21, cosine, left_2b, left_right_2),
      left_lo_2 = left_lo1_2 + (KSL_MUL(R->m20, sine_lo) + KSL_MUL(R->m21, cosine_lo));
  const double rest = R->m12 + R->m22, rest_right_1 = rest - R->m12,
      rest_lo = R->m12 - (rest - rest_right_1) + (R->m22 - rest_right_1),
      rest_size_3 = fabs(R->m12) + fabs(R->m22);
  const double first = ksl_atan2(left_2, left_1), first_size0_1 = fabs(left_2),
      first_size1_1 = fabs(left_1),
      first_most_1 = first_size0_1 < first_size1_1 ? first_size1_1 : first_size0_1,
      first_divisor_1 = first_most_1 == 0.0 ? 1.0 : first_most_1,
      first_part0_1 = left_2 / first_divisor_1, first_part1_1 = left_1 / first_divisor_1,
      first_divisor2_1 = KSL_MUL(first_divisor_1, KSL_MUL(first_part1_1, first_part1_1)
          + KSL_MUL(first_part0_1, first_part0_1)),
      first_more_1 = (KSL_MUL(first_part1_1, left_lo_2) - KSL_MUL(first_part0_1, left_lo_1))
          / (first_most_1 == 0.0 ? 1.0 : first_divisor2_1),
      first_lo = ksl_atan2_error(left_2, left_1, first) + first_more_1,
      first_padded_1 = 1.8051943758648296e-276
          + (KSL_MUL(left_1a_padded_1, fabs(R->m20)) + KSL_MUL(left_1b_padded_1, fabs(R->m21))),
      first_padded_2 = 1.8051943758648296e-276
          + (KSL_MUL(left_1a_padded_1, fabs(R->m10)) + KSL_MUL(left_1b_padded_1, fabs(R->m11))),
      first_size_2 = fabs(left_2), first_size_3 = fabs(left_1),
      first_size_5 = first_size_2 < first_size_3 ? first_size_3 : first_size_2,
      first_bound_1 = fabs(left_lo_2) + KSL_MUL(1.120429474644463e-29, first_padded_1),
      first_bound_2 = fabs(left_lo_1) + KSL_MUL(1.120429474644463e-29, first_padded_2),
      first_size_11 = (first_bound_2 + (1.8051943758648296e-276 + first_bound_1)) / first_size_5,
      first_size_13 = KSL_MUL(first_size_11, first_size_11), first_size_14 = fabs(first_lo),
      first_size_15 = 7.0 + first_size_14,
      first_size_18 = first_bound_2 < left_1 ? first_size_13 : first_size_15,
      first_size_19 = first_bound_1 < first_size_2 ? first_size_13 : first_size_18,
      first_size_21 = KSL_MUL(4.527322338646221e+28, first_size_11 < 0.25 ? first_size_19
          : first_size_15),
      first_size_22 = fabs(first) + (first_padded_1 + first_padded_2) / first_size_5
          + first_size_21;
  const double angles_0 = rest < 1.2676506002282294e+30 ? first : rest,
      angles_bound_1 = fabs(rest_lo)
          + KSL_MUL(7.642090607075756e-31, 1.8051943758648296e-276 + rest_size_3),
      angles_size_8 = angles_bound_1
          + (KSL_MUL(2.2778366396519518e-29, 1.8051943758648296e-276 + first_size_22)
          + first_size_14 + fabs(first - rest)),
      angles_size_10 = KSL_MUL(4.527322030246999e+28, angles_bound_1
          < fabs(rest - 1.2676506002282294e+30) ? 0.0 : angles_size_8);
  const double angles_1 = ksl_atan2(R->m02, n), angles_size0_1 = fabs(R->m02),
      angles_size1_1 = fabs(n),
      angles_most_1 = angles_size0_1 < angles_size1_1 ? angles_size1_1 : angles_size0_1,
      angles_divisor_1 = angles_most_1 == 0.0 ? 1.0 : angles_most_1,
      angles_part0_1 = R->m02 / angles_divisor_1, angles_part1_1 = n / angles_divisor_1,
      angles_divisor2_1 = KSL_MUL(angles_divisor_1, KSL_MUL(angles_part1_1, angles_part1_1)
          + KSL_MUL(angles_part0_1, angles_part0_1)),
      angles_more_1 = (KSL_MUL(angles_part1_1, 0.0) - KSL_MUL(angles_part0_1, n_lo))
          / (angles_most_1 == 0.0 ? 1.0 : angles_divisor2_1), angles_size_13 = fabs(R->m02),
      angles_size_14 = fabs(n),
      angles_size_16 = angles_size_13 < angles_size_14 ? angles_size_14 : angles_size_13,
      angles_size_21 = (1.8051943758648296e-276 + divisor_bound_1) / angles_size_16,
      angles_size_23 = KSL_MUL(angles_size_21, angles_size_21),
      angles_size_24 = fabs(ksl_atan2_error(R->m02, n, angles_1) + angles_more_1),
      angles_size_25 = 7.0 + angles_size_24,
      angles_size_20 = fabs(angles_1)
          + (1.8051943758648296e-276 + angles_size_13 + divisor_padded_1) / angles_size_16;
  const double angles_padded_4 = 1.8051943758648296e-276
          + ((rest < 1.2676506002282294e+30 ? first_size_22 : rest_size_3) + angles_size_10);
  const double angles_size_28 = angles_size_20
          + KSL_MUL(7.9228157791897855e+28, angles_size_21 < 0.25 ? angles_size_23
          : angles_size_25);
  const double third_size_7 = (n == 0.0 ? 0.0 : polar_size_1)
          + KSL_MUL(1.5845630613906556e+29, divisor_bound_1 < divisor_size_3 ? 0.0 : third_size_4);
  const double R_n_0 = KSL_MUL(R->m11, R->m22) - KSL_MUL(R->m12, R->m21),
      R_n_1 = KSL_MUL(R->m02, R->m21) - KSL_MUL(R->m01, R->m22),
      R_n_2 = KSL_MUL(R->m01, R->m12) - KSL_MUL(R->m02, R->m11);
  const double R_det = KSL_MUL(R->m00, R_n_0) + KSL_MUL(R->m10, R_n_1) + KSL_MUL(R->m20, R_n_2);
  const double R_g_0 = KSL_MUL(R->m00, R->m00) + KSL_MUL(R->m10, R->m10) + KSL_MUL(R->m20, R->m20),
      R_g_1 = KSL_MUL(R->m00, R->m01) + KSL_MUL(R->m10, R->m11) + KSL_MUL(R->m20, R->m21),
      R_g_2 = KSL_MUL(R->m00, R->m02) + KSL_MUL(R->m10, R->m12) + KSL_MUL(R->m20, R->m22),
      R_g_3 = KSL_MUL(R->m01, R->m01) + KSL_MUL(R->m11, R->m11) + KSL_MUL(R->m21, R->m21),
      R_g_4 = KSL_MUL(R->m01, R->m02) + KSL_MUL(R->m11, R->m12) + KSL_MUL(R->m21, R->m22),
      R_g_5 = KSL_MUL(R->m02, R->m02) + KSL_MUL(R->m12, R->m12) + KSL_MUL(R->m22, R->m22);
  const double R_off_0 = R_det - 1.0, R_off_1 = R_g_0 - 1.0, R_off_4 = R_g_3 - 1.0,
      R_off_6 = R_g_5 - 1.0;
  const double R_defect_size_0 = fabs(R_off_0), R_defect_size_1 = fabs(R_off_1),
      R_defect_size_2 = fabs(R_g_1), R_defect_size_3 = fabs(R_g_2), R_defect_size_4 = fabs(R_off_4),
      R_defect_size_5 = fabs(R_g_4), R_defect_size_6 = fabs(R_off_6);
  const double R_defect_largest1 = R_defect_size_0 < R_defect_size_1 ? R_defect_size_1
          : R_defect_size_0;
  const double R_defect_largest2 = R_defect_largest1 < R_defect_size_2 ? R_defect_size_2
          : R_defect_largest1;
  const double R_defect_largest3 = R_defect_largest2 < R_defect_size_3 ? R_defect_size_3
          : R_defect_largest2;
  const double R_defect_largest4 = R_defect_largest3 < R_defect_size_4 ? R_defect_size_4
          : R_defect_largest3;
  const double R_defect_largest5 = R_defect_largest4 < R_defect_size_5 ? R_defect_size_5
          : R_defect_largest4;
  const double R_defect_largest6 = R_defect_largest5 < R_defect_size_6 ? R_defect_size_6
          : R_defect_largest5;
  const double R_unless_equal = R_defect_largest6 == 0.001 ? 0.0 : 1.0715086071862673e+301;
  const double R_unless_rotation = R_defect_largest6 < 0.001 ? 0.0 : R_unless_equal;
  const double R_excess = KSL_MUL(R_unless_rotation, 1.0715086071862673e+301),
      R_excess_0 = fabs(rest < 1.2676506002282294e+30 ? first_lo : rest_lo)
          + KSL_MUL(2.277836794817206e-29, angles_padded_4) + R_excess,
      R_excess_1 = KSL_MUL(1.3016206487799288e-29, 1.8051943758648296e-276 + angles_size_28)
          + angles_size_24 + R_excess,
      R_excess_2 = fabs(n == 0.0 ? 0.0 : polar_own_error_1)
          + KSL_MUL(6.508104019725916e-30, 1.8051943758648296e-276 + third_size_7) + R_excess;
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
  angles_bound->x = R_excess_0;
  angles_bound->y = R_excess_1;
  angles_bound->z = R_excess_2;
}

/* R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.
   angles: vector; R, R_bound: rotation or other 3×3 matrix.
   291 mul, 434 add, 39 product error, 8 product rest, 3 div, 5 neg, 18 abs, 3 less, 3 select. */
static inline void ksl_mat3x3_from_euler_xyx_certified(const ksl_vec3_t *angles, ksl_mat3x3_t *R,
    ksl_mat3x3_t *R_bound) {
  double c_0; const double s_0 = ksl_sincos(angles->x, &c_0);
  double c_own_error_1; const double s_own_error_1 = ksl_sincos_error(angles->x, s_0, c_0,
      &c_own_error_1);
  double c_1; const double s_1 = ksl_sincos(angles->y, &c_1);
  double c_own_error_2; const double s_own_error_2 = ksl_sincos_error(angles->y, s_1, c_1,
      &c_own_error_2);
  double c_2; const double s_2 = ksl_sincos(angles->z, &c_2);
  double c_own_error_3; const double s_own_error_3 = ksl_sincos_error(angles->z, s_2, c_2,
      &c_own_error_3);
  const double first_1 = KSL_MUL(s_1, s_2), first_2 = KSL_MUL(s_1, c_2),
      first_7 = KSL_MUL(s_2, c_1), first_8 = KSL_MUL(c_1, c_2);
  const double last_3 = KSL_MUL(s_0, s_1);
  const double last_4a = KSL_MUL(c_0, c_2),
      first_lo_1 = ksl_product_error(s_2, c_1, first_7)
          + (KSL_MUL(s_own_error_3, c_1) + KSL_MUL(s_2, c_own_error_2)),
      last_4b = KSL_MUL(s_0, first_7), last_4 = last_4a - last_4b, last_right_1 = last_4a - last_4,
      last_cross_2 = KSL_MUL(c_own_error_1, c_2) + KSL_MUL(c_0, c_own_error_3)
          - (KSL_MUL(s_own_error_1, first_7) + KSL_MUL(s_0, first_lo_1));
  const double first_lo_2 = ksl_product_error(c_1, c_2, first_8)
          + (KSL_MUL(c_own_error_2, c_2) + KSL_MUL(c_1, c_own_error_3)),
      last_5a = KSL_MUL(s_0, first_8), last_5b = KSL_MUL(s_2, c_0), last_5c = last_5a + last_5b,
      last_5c_right_1 = last_5c - last_5a,
      last_5c_lo1_1 = ksl_product_rest(s_0, first_8, last_5a, last_5c - last_5c_right_1)
          + ksl_product_rest(s_2, c_0, last_5b, last_5c_right_1),
      last_5c_cross_1 = KSL_MUL(s_own_error_1, first_8) + KSL_MUL(s_0, first_lo_2)
          + (KSL_MUL(s_own_error_3, c_0) + KSL_MUL(s_2, c_own_error_1)), last_5 = -last_5c;
  const double last_6 = -KSL_MUL(s_1, c_0);
  const double last_7a = KSL_MUL(s_0, c_2), last_7b = KSL_MUL(c_0, first_7),
      last_7 = last_7a + last_7b, last_right_2 = last_7 - last_7a,
      last_cross_4 = KSL_MUL(s_own_error_1, c_2) + KSL_MUL(s_0, c_own_error_3)
          + (KSL_MUL(c_own_error_1, first_7) + KSL_MUL(c_0, first_lo_1));
  const double last_8a = KSL_MUL(c_0, first_8), last_8b = KSL_MUL(s_0, s_2),
      last_8 = last_8a - last_8b, last_right_3 = last_8a - last_8,
      last_cross_5 = KSL_MUL(c_own_error_1, first_8) + KSL_MUL(c_0, first_lo_2)
          - (KSL_MUL(s_own_error_1, s_2) + KSL_MUL(s_0, s_own_error_3));
  const double last_error_3 = fabs(ksl_product_rest(c_0, c_2, last_4a, last_4 + last_right_1)
          - ksl_product_rest(s_0, first_7, last_4b, last_right_1) + last_cross_2),
      last_error_7 = fabs(ksl_product_rest(s_0, c_2, last_7a, last_7 - last_right_2)
          + ksl_product_rest(c_0, first_7, last_7b, last_right_2) + last_cross_4),
      last_error_8 = fabs(ksl_product_rest(c_0, first_8, last_8a, last_8 + last_right_3)
          - ksl_product_rest(s_0, s_2, last_8b, last_right_3) + last_cross_5),
      c_bound_1 = 3.7470896994678994e-30 + fabs(c_own_error_2),
      first_bound_1 = 7.814654941017999e-30
          + fabs(ksl_product_error(s_1, s_2, first_1)
          + (KSL_MUL(s_own_error_2, s_2) + KSL_MUL(s_1, s_own_error_3))),
      first_bound_2 = 7.814654941017999e-30
          + fabs(ksl_product_error(s_1, c_2, first_2)
          + (KSL_MUL(s_own_error_2, c_2) + KSL_MUL(s_1, c_own_error_3))),
      last_bound_1 = 7.814654941017999e-30
          + fabs(ksl_product_error(s_0, s_1, last_3)
          + (KSL_MUL(s_own_error_1, s_1) + KSL_MUL(s_0, s_own_error_2))),
      last_bound_2 = 2.684592926357104e-29 + last_error_3,
      last_bound_3 = 2.684592926357104e-29 + fabs(-(last_5c_lo1_1 + last_5c_cross_1)),
      last_bound_4 = 7.814654941017999e-30
          + fabs(ksl_product_error(-s_1, c_0, last_6) +
          -(KSL_MUL(s_own_error_2, c_0) + KSL_MUL(s_1, c_own_error_1))),
      last_bound_5 = 2.684592926357104e-29 + last_error_7,
      last_bound_6 = 2.684592926357104e-29 + last_error_8;
  R->m00 = c_1;
  R->m01 = first_1;
  R->m02 = first_2;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
  R_bound->m00 = c_bound_1;
  R_bound->m01 = first_bound_1;
  R_bound->m02 = first_bound_2;
  R_bound->m10 = last_bound_1;
  R_bound->m11 = last_bound_2;
  R_bound->m12 = last_bound_3;
  R_bound->m20 = last_bound_4;
  R_bound->m21 = last_bound_5;
  R_bound->m22 = last_bound_6;
}

/* angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in [0,
     π]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; angles, angles_bound: vector.
   455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 3 neg, 72 abs, 12
     copysign, 61 less, 14 equal, 110 select. */
static inline void ksl_euler_xyx_from_mat3x3_certified(const ksl_mat3x3_t *R, ksl_vec3_t *angles,
    ksl_vec3_t *angles_bound) {
  const double n_a = KSL_MUL(R->m01, R->m01), n_a_size_1 = fabs(R->m01),
      n_b = KSL_MUL(R->m02, R->m02), n_b_size_1 = fabs(R->m02), n_c = n_a + n_b,
      n_c_right_1 = n_c - n_a,
      n_c_lo = ksl_product_rest(R->m01, R->m01, n_a, n_c - n_c_right_1)
          + ksl_product_rest(R->m02, R->m02, n_b, n_c_right_1), n = sqrt(n_c),
      n_product_1 = KSL_MUL(n, n), n_twice_1 = n + n,
      n_lo = (n_c - n_product_1 - ksl_product_error(n, n, n_product_1) + n_c_lo)
          / (n == 0.0 ? 1.0 : n_twice_1),
      n_padded_1 = 1.8051943758648296e-276
          + (KSL_MUL(n_a_size_1, n_a_size_1) + KSL_MUL(n_b_size_1, n_b_size_1)),
      n_bound_1 = fabs(n_c_lo) + KSL_MUL(9.614242987677729e-31, n_padded_1),
      n_size_4 = KSL_MUL(fabs(n_c) + KSL_MUL(140737488355328.0, n_bound_1), n_padded_1 / n / n_c),
      n_size_6 = fabs(n_lo), n_size_8 = KSL_MUL(4.916947487854274e+29, sqrt(n_bound_1) + n_size_6),
      n_size_12 = n + (KSL_MUL(4.0, n_bound_1) < n_c ? n_size_4 : n_size_8);
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo,
      divisor_padded_1 = 1.8051943758648296e-276 + n_size_12,
      divisor_bound_1 = KSL_MUL(2.230997459167166e-30, divisor_padded_1) + n_size_6,
      divisor_size_3 = fabs(n - 0.0), divisor_size_7 = divisor_bound_1 + fabs(1.0 - n);
  const double cosine_a = R->m02 / divisor, cosine_a_product_1 = KSL_MUL(cosine_a, divisor),
      cosine_a_lo = (R->m02 - cosine_a_product_1
          - ksl_product_error(cosine_a, divisor, cosine_a_product_1)
          - KSL_MUL(cosine_a, divisor_lo)) / divisor;
  const double divisor_size_10 = (n == 0.0 ? 1.0 : n_size_12)
          + KSL_MUL(1.5845630613906556e+29, divisor_bound_1 < divisor_size_3 ? 0.0
          : divisor_size_7);
  const double cosine_a_padded_2 = 1.8051943758648296e-276 + divisor_size_10,
      cosine_a_size_1 = fabs(cosine_a), cosine_a_size_2 = fabs(divisor),
      cosine_a_bound_1 = fabs(divisor_lo) + KSL_MUL(6.508104019725916e-30, cosine_a_padded_2),
      cosine_a_size_7 = KSL_MUL(4.0, cosine_a_bound_1) < cosine_a_size_2 ? cosine_a_size_2 : 0.0,
      cosine_a_reach_1 = cosine_a_size_2 + KSL_MUL(140737488355328.0, cosine_a_bound_1),
      cosine_a_size_9 = KSL_MUL(cosine_a_reach_1, (1.8051943758648296e-276 + n_b_size_1
          + KSL_MUL(cosine_a_padded_2, cosine_a_size_1)) / cosine_a_size_7),
      cosine_a_size_11 = cosine_a_size_1 + cosine_a_size_9 / cosine_a_size_2,
      cosine = n == 0.0 ? 1.0 : cosine_a, cosine_lo = n == 0.0 ? 0.0 : cosine_a_lo,
      cosine_size_4 = fabs(cosine_a_lo)
          + KSL_MUL(9.910067449317813e-30, 1.8051943758648296e-276 + cosine_a_size_11)
          + fabs(1.0 - cosine_a);
  const double sine = R->m01 / divisor, sine_product_1 = KSL_MUL(sine, divisor),
      sine_lo = (R->m01 - sine_product_1 - ksl_product_error(sine, divisor, sine_product_1)
          - KSL_MUL(sine, divisor_lo)) / divisor, sine_size_1 = fabs(sine),
      sine_size_5 = KSL_MUL(cosine_a_reach_1, (1.8051943758648296e-276 + n_a_size_1
          + KSL_MUL(cosine_a_padded_2, sine_size_1)) / cosine_a_size_7);
  const double polar = ksl_atan2(R->m01, R->m02),
      polar_own_error_1 = ksl_atan2_error(R->m01, R->m02, polar), polar_size_1 = fabs(polar);
  const double third = n == 0.0 ? 0.0 : polar,
      third_size_4 = fabs(polar_own_error_1)
          + KSL_MUL(3.7470896994679e-30, 1.8051943758648296e-276 + polar_size_1)
          + fabs(0.0 - polar);
  const double left_1a = KSL_MUL(R->m11, cosine);
  const double cosine_size_7 = (n == 0.0 ? 1.0 : cosine_a_size_11)
          + KSL_MUL(1.0401233252484625e+29, divisor_bound_1 < divisor_size_3 ? 0.0 : cosine_size_4);
  const double left_1a_padded_1 = 1.8051943758648296e-276 + cosine_size_7,
      left_1b = KSL_MUL(R->m12, sine),
      left_1b_padded_1 = 1.8051943758648296e-276 + (sine_size_1 + sine_size_5 / cosine_a_size_2),
      left_1 = left_1a - left_1b, left_right_1 = left_1a - left_1,
      left_lo1_1 = ksl_product_rest(R->m11, cosine, left_1a, left_1 + left_right_1)
          - ksl_product_rest(R->m12, sine, left_1b, left_right_1),
      left_lo_1 = left_lo1_1 + (KSL_MUL(R->m11, cosine_lo) - KSL_MUL(R->m12, sine_lo));
  const double left_2a = KSL_MUL(R->m21, cosine), left_2b = KSL_MUL(R->m22, sine),
      left_2 = left_2a - left_2b, left_right_2 = left_2a - left_2,
      left_lo1_2 = ksl_product_rest(R->m21, cosine, left_2a, left_2 + left_right_2)
          - ksl_product_rest(R->m22, sine, left_2b, left_right_2),
      left_lo_2 = left_lo1_2 + (KSL_MUL(R->m21, cosine_lo) - KSL_MUL(R->m22, sine_lo));
  const double rest = R->m10 + R->m20, rest_right_1 = rest - R->m10,
      rest_lo = R->m10 - (rest - rest_right_1) + (R->m20 - rest_right_1),
      rest_size_3 = fabs(R->m10) + fabs(R->m20);
  const double first = ksl_atan2(left_2, left_1), first_size0_1 = fabs(left_2),
      first_size1_1 = fabs(left_1),
      first_most_1 = first_size0_1 < first_size1_1 ? first_size1_1 : first_size0_1,
      first_divisor_1 = first_most_1 == 0.0 ? 1.0 : first_most_1,
      first_part0_1 = left_2 / first_divisor_1, first_part1_1 = left_1 / first_divisor_1,
      first_divisor2_1 = KSL_MUL(first_divisor_1, KSL_MUL(first_part1_1, first_part1_1)
          + KSL_MUL(first_part0_1, first_part0_1)),
      first_more_1 = (KSL_MUL(first_part1_1, left_lo_2) - KSL_MUL(first_part0_1, left_lo_1))
          / (first_most_1 == 0.0 ? 1.0 : first_divisor2_1),
      first_lo = ksl_atan2_error(left_2, left_1, first) + first_more_1,
      first_padded_1 = 1.8051943758648296e-276
          + (KSL_MUL(left_1a_padded_1, fabs(R->m21)) + KSL_MUL(left_1b_padded_1, fabs(R->m22))),
      first_padded_2 = 1.8051943758648296e-276
          + (KSL_MUL(left_1a_padded_1, fabs(R->m11)) + KSL_MUL(left_1b_padded_1, fabs(R->m12))),
      first_size_2 = fabs(left_2), first_size_3 = fabs(left_1),
      first_size_5 = first_size_2 < first_size_3 ? first_size_3 : first_size_2,
      first_bound_1 = fabs(left_lo_2) + KSL_MUL(1.120429474644463e-29, first_padded_1),
      first_bound_2 = fabs(left_lo_1) + KSL_MUL(1.120429474644463e-29, first_padded_2),
      first_size_11 = (first_bound_2 + (1.8051943758648296e-276 + first_bound_1)) / first_size_5,
      first_size_13 = KSL_MUL(first_size_11, first_size_11), first_size_14 = fabs(first_lo),
      first_size_15 = 7.0 + first_size_14,
      first_size_18 = first_bound_2 < left_1 ? first_size_13 : first_size_15,
      first_size_19 = first_bound_1 < first_size_2 ? first_size_13 : first_size_18,
      first_size_21 = KSL_MUL(4.527322338646221e+28, first_size_11 < 0.25 ? first_size_19
          : first_size_15),
      first_size_22 = fabs(first) + (first_padded_1 + first_padded_2) / first_size_5
          + first_size_21;
  const double angles_0 = rest < 1.2676506002282294e+30 ? first : rest,
      angles_bound_1 = fabs(rest_lo)
          + KSL_MUL(7.642090607075756e-31, 1.8051943758648296e-276 + rest_size_3),
      angles_size_8 = angles_bound_1
          + (KSL_MUL(2.2778366396519518e-29, 1.8051943758648296e-276 + first_size_22)
          + first_size_14 + fabs(first - rest)),
      angles_size_10 = KSL_MUL(4.527322030246999e+28, angles_bound_1
          < fabs(rest - 1.2676506002282294e+30) ? 0.0 : angles_size_8);
  const double angles_1 = ksl_atan2(n, R->m00), angles_size0_1 = fabs(n),
      angles_size1_1 = fabs(R->m00),
      angles_most_1 = angles_size0_1 < angles_size1_1 ? angles_size1_1 : angles_size0_1,
      angles_divisor_1 = angles_most_1 == 0.0 ? 1.0 : angles_most_1,
      angles_part0_1 = n / angles_divisor_1, angles_part1_1 = R->m00 / angles_divisor_1,
      angles_divisor2_1 = KSL_MUL(angles_divisor_1, KSL_MUL(angles_part1_1, angles_part1_1)
          + KSL_MUL(angles_part0_1, angles_part0_1)),
      angles_more_1 = (KSL_MUL(angles_part1_1, n_lo) - KSL_MUL(angles_part0_1, 0.0))
          / (angles_most_1 == 0.0 ? 1.0 : angles_divisor2_1), angles_size_13 = fabs(R->m00),
      angles_size_14 = fabs(n),
      angles_size_16 = angles_size_14 < angles_size_13 ? angles_size_13 : angles_size_14,
      angles_size_21 = (1.8051943758648296e-276 + divisor_bound_1) / angles_size_16,
      angles_size_23 = KSL_MUL(angles_size_21, angles_size_21),
      angles_size_24 = fabs(ksl_atan2_error(n, R->m00, angles_1) + angles_more_1),
      angles_size_25 = 7.0 + angles_size_24,
      angles_size_28 = 0.0 < R->m00 ? angles_size_23 : angles_size_25,
      angles_size_29 = divisor_bound_1 < angles_size_14 ? angles_size_23 : angles_size_28,
      angles_size_20 = fabs(angles_1)
          + (1.8051943758648296e-276 + angles_size_13 + divisor_padded_1) / angles_size_16;
  const double angles_padded_4 = 1.8051943758648296e-276
          + ((rest < 1.2676506002282294e+30 ? first_size_22 : rest_size_3) + angles_size_10);
  const double angles_size_32 = angles_size_20
          + KSL_MUL(7.9228157791897855e+28, angles_size_21 < 0.25 ? angles_size_29
          : angles_size_25);
  const double third_size_7 = (n == 0.0 ? 0.0 : polar_size_1)
          + KSL_MUL(1.5845630613906556e+29, divisor_bound_1 < divisor_size_3 ? 0.0 : third_size_4);
  const double R_n_0 = KSL_MUL(R->m11, R->m22) - KSL_MUL(R->m12, R->m21),
      R_n_1 = KSL_MUL(R->m02, R->m21) - KSL_MUL(R->m01, R->m22),
      R_n_2 = KSL_MUL(R->m01, R->m12) - KSL_MUL(R->m02, R->m11);
  const double R_det = KSL_MUL(R->m00, R_n_0) + KSL_MUL(R->m10, R_n_1) + KSL_MUL(R->m20, R_n_2);
  const double R_g_0 = KSL_MUL(R->m00, R->m00) + KSL_MUL(R->m10, R->m10) + KSL_MUL(R->m20, R->m20),
      R_g_1 = KSL_MUL(R->m00, R->m01) + KSL_MUL(R->m10, R->m11) + KSL_MUL(R->m20, R->m21),
      R_g_2 = KSL_MUL(R->m00, R->m02) + KSL_MUL(R->m10, R->m12) + KSL_MUL(R->m20, R->m22),
      R_g_3 = KSL_MUL(R->m01, R->m01) + KSL_MUL(R->m11, R->m11) + KSL_MUL(R->m21, R->m21),
      R_g_4 = KSL_MUL(R->m01, R->m02) + KSL_MUL(R->m11, R->m12) + KSL_MUL(R->m21, R->m22),
      R_g_5 = KSL_MUL(R->m02, R->m02) + KSL_MUL(R->m12, R->m12) + KSL_MUL(R->m22, R->m22);
  const double R_off_0 = R_det - 1.0, R_off_1 = R_g_0 - 1.0, R_off_4 = R_g_3 - 1.0,
      R_off_6 = R_g_5 - 1.0;
  const double R_defect_size_0 = fabs(R_off_0), R_defect_size_1 = fabs(R_off_1),
      R_defect_size_2 = fabs(R_g_1), R_defect_size_3 = fabs(R_g_2), R_defect_size_4 = fabs(R_off_4),
      R_defect_size_5 = fabs(R_g_4), R_defect_size_6 = fabs(R_off_6);
  const double R_defect_largest1 = R_defect_size_0 < R_defect_size_1 ? R_defect_size_1
          : R_defect_size_0;
  const double R_defect_largest2 = R_defect_largest1 < R_defect_size_2 ? R_defect_size_2
          : R_defect_largest1;
  const double R_defect_largest3 = R_defect_largest2 < R_defect_size_3 ? R_defect_size_3
          : R_defect_largest2;
  const double R_defect_largest4 = R_defect_largest3 < R_defect_size_4 ? R_defect_size_4
          : R_defect_largest3;
  const double R_defect_largest5 = R_defect_largest4 < R_defect_size_5 ? R_defect_size_5
          : R_defect_largest4;
  const double R_defect_largest6 = R_defect_largest5 < R_defect_size_6 ? R_defect_size_6
          : R_defect_largest5;
  const double R_unless_equal = R_defect_largest6 == 0.001 ? 0.0 : 1.0715086071862673e+301;
  const double R_unless_rotation = R_defect_largest6 < 0.001 ? 0.0 : R_unless_equal;
  const double R_excess = KSL_MUL(R_unless_rotation, 1.0715086071862673e+301),
      R_excess_0 = fabs(rest < 1.2676506002282294e+30 ? first_lo : rest_lo)
          + KSL_MUL(2.277836794817206e-29, angles_padded_4) + R_excess,
      R_excess_1 = KSL_MUL(1.3016206487799288e-29, 1.8051943758648296e-276 + angles_size_32)
          + angles_size_24 + R_excess,
      R_excess_2 = fabs(n == 0.0 ? 0.0 : polar_own_error_1)
          + KSL_MUL(6.508104019725916e-30, 1.8051943758648296e-276 + third_size_7) + R_excess;
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
  angles_bound->x = R_excess_0;
  angles_bound->y = R_excess_1;
  angles_bound->z = R_excess_2;
}

/* R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
     not a rotation; |error of R| <= R_bound unless inf or NaN.
   axis: vector; angle: number; R, R_bound: rotation or other 3×3 matrix.
   216 mul, 380 add, 26 product error, 18 product rest, 2 div, 24 abs, 4 less, 6 select. */
static inline void ksl_mat3x3_from_axis_angle_certified(const ksl_vec3_t *axis,
    const double angle, ksl_mat3x3_t *R, ksl_mat3x3_t *R_bound) {
  const double half = KSL_MUL(0.5, angle);
  const double h = ksl_sin(half), h_own_error_1 = ksl_sin_error(half, h),
      h_size_1 = 1.0 + (1.8051943758648296e-276 + KSL_MUL(0.5, fabs(angle)));
  double cosine; const double sine = ksl_sincos(angle, &cosine);
  double cosine_own_error_1; const double sine_own_error_1 = ksl_sincos_error(angle, sine, cosine,
      &cosine_own_error_1);
  const double versine_a = KSL_MUL(h, h), versine_b = KSL_MUL(2.0, versine_a),
      versine_b_cross2_1 = KSL_MUL(2.0, ksl_product_error(h, h, versine_a)
          + (KSL_MUL(h_own_error_1, h) + KSL_MUL(h, h_own_error_1))),
      versine_b_size_1 = KSL_MUL(2.0, KSL_MUL(h_size_1, h_size_1)), versine_c = 1.0 - cosine,
      versine_c_right_1 = 1.0 - versine_c,
      versine_c_lo = 1.0 - (versine_c + versine_c_right_1) - (cosine - versine_c_right_1)
          - cosine_own_error_1, versine = cosine < 0.0 ? versine_c : versine_b,
      versine_lo = cosine < 0.0 ? versine_c_lo : versine_b_cross2_1,
      versine_bound_3 = fabs(versine_b_cross2_1)
          + KSL_MUL(8.973295241917294e-30, 1.8051943758648296e-276 + versine_b_size_1),
      versine_size_8 = versine_bound_3
          + (9.318421041595558e-30 + fabs(versine_c_lo) + fabs(versine_c - versine_b)),
      versine_size_10 = KSL_MUL(3.9614071812401596e+28, 3.7470896994678994e-30
          + fabs(cosine_own_error_1) < fabs(cosine - 0.0) ? 0.0 : versine_size_8);
  const double beta_v_0 = KSL_MUL(axis->x, versine), beta_v_size_1 = fabs(axis->x),
      beta_v_padded_1 = 1.8051943758648296e-276
          + ((cosine < 0.0 ? 2.0 : versine_b_size_1) + versine_size_10);
  const double beta_v_1 = KSL_MUL(axis->y, versine), beta_v_size_3 = fabs(axis->y);
  const double beta_v_2 = KSL_MUL(axis->z, versine), beta_v_size_5 = fabs(axis->z);
  const double beta_v_lo_1 = ksl_product_error(axis->x, versine, beta_v_0)
          + KSL_MUL(axis->x, versine_lo), m_0 = KSL_MUL(axis->x, beta_v_0),
      m_cross2_1 = KSL_MUL(axis->x, beta_v_lo_1),
      m_padded_1 = 1.8051943758648296e-276 + KSL_MUL(beta_v_padded_1, beta_v_size_1),
      m_size_1 = KSL_MUL(beta_v_size_1, m_padded_1);
  const double beta_v_lo_2 = ksl_product_error(axis->y, versine, beta_v_1)
          + KSL_MUL(axis->y, versine_lo), m_1 = KSL_MUL(axis->y, beta_v_1),
      m_cross2_2 = KSL_MUL(axis->y, beta_v_lo_2),
      m_padded_2 = 1.8051943758648296e-276 + KSL_MUL(beta_v_padded_1, beta_v_size_3),
      m_size_2 = KSL_MUL(beta_v_size_3, m_padded_2);
  const double m_2 = KSL_MUL(axis->z, beta_v_2),
      m_cross2_3 = KSL_MUL(axis->z, ksl_product_error(axis->z, versine, beta_v_2)
          + KSL_MUL(axis->z, versine_lo)),
      m_size_3 = KSL_MUL(beta_v_size_5, 1.8051943758648296e-276
          + KSL_MUL(beta_v_padded_1, beta_v_size_5));
  const double m_3 = KSL_MUL(axis->y, beta_v_0), m_cross2_4 = KSL_MUL(axis->y, beta_v_lo_1);
  const double m_4 = KSL_MUL(axis->z, beta_v_0), m_cross2_5 = KSL_MUL(axis->z, beta_v_lo_1);
  const double m_5 = KSL_MUL(axis->z, beta_v_1), m_cross2_6 = KSL_MUL(axis->z, beta_v_lo_2);
  const double others_0 = m_1 + m_2, others_right_1 = others_0 - m_1,
      others_lo1_1 = ksl_product_rest(axis->y, beta_v_1, m_1, others_0 - others_right_1)
          + ksl_product_rest(axis->z, beta_v_2, m_2, others_right_1);
  const double others_1 = m_0 + m_2, others_right_2 = others_1 - m_0,
      others_lo1_2 = ksl_product_rest(axis->x, beta_v_0, m_0, others_1 - others_right_2)
          + ksl_product_rest(axis->z, beta_v_2, m_2, others_right_2);
  const double others_2 = m_0 + m_1, others_right_3 = others_2 - m_0,
      others_lo1_3 = ksl_product_rest(axis->x, beta_v_0, m_0, others_2 - others_right_3)
          + ksl_product_rest(axis->y, beta_v_1, m_1, others_right_3);
  const double alpha_v_0 = KSL_MUL(axis->x, sine),
      alpha_v_cross2_1 = KSL_MUL(axis->x, sine_own_error_1);
  const double alpha_v_1 = KSL_MUL(axis->y, sine),
      alpha_v_cross2_2 = KSL_MUL(axis->y, sine_own_error_1);
  const double alpha_v_2 = KSL_MUL(axis->z, sine),
      alpha_v_cross2_3 = KSL_MUL(axis->z, sine_own_error_1);
  const double R_00 = 1.0 - others_0, R_right_1 = 1.0 - R_00;
  const double R_01 = m_3 - alpha_v_2, R_right_2 = m_3 - R_01,
      R_lo1_2 = ksl_product_rest(axis->y, beta_v_0, m_3, R_01 + R_right_2)
          - ksl_product_rest(axis->z, sine, alpha_v_2, R_right_2);
  const double R_02 = m_4 + alpha_v_1, R_right_3 = R_02 - m_4,
      R_lo1_3 = ksl_product_rest(axis->z, beta_v_0, m_4, R_02 - R_right_3)
          + ksl_product_rest(axis->y, sine, alpha_v_1, R_right_3);
  const double R_10 = m_3 + alpha_v_2, R_right_4 = R_10 - m_3,
      R_lo1_4 = ksl_product_rest(axis->y, beta_v_0, m_3, R_10 - R_right_4)
          + ksl_product_rest(axis->z, sine, alpha_v_2, R_right_4);
  const double R_11 = 1.0 - others_1, R_right_5 = 1.0 - R_11;
  const double R_12 = m_5 - alpha_v_0, R_right_6 = m_5 - R_12,
      R_lo1_6 = ksl_product_rest(axis->z, beta_v_1, m_5, R_12 + R_right_6)
          - ksl_product_rest(axis->x, sine, alpha_v_0, R_right_6);
  const double R_20 = m_4 - alpha_v_1, R_right_7 = m_4 - R_20,
      R_lo1_7 = ksl_product_rest(axis->z, beta_v_0, m_4, R_20 + R_right_7)
          - ksl_product_rest(axis->y, sine, alpha_v_1, R_right_7);
  const double R_21 = m_5 + alpha_v_0, R_right_8 = R_21 - m_5,
      R_lo1_8 = ksl_product_rest(axis->z, beta_v_1, m_5, R_21 - R_right_8)
          + ksl_product_rest(axis->x, sine, alpha_v_0, R_right_8);
  const double R_22 = 1.0 - others_2, R_right_9 = 1.0 - R_22;
  const double R_error_1 = fabs(1.0 - (R_00 + R_right_1) - (others_0 - R_right_1)
          - (others_lo1_1 + (m_cross2_2 + m_cross2_3))),
      R_rest_2 = KSL_MUL(2.841133715943113e-29, 1.8051943758648296e-276
          + (beta_v_size_5 + KSL_MUL(beta_v_size_3, m_padded_1))),
      R_rest_3 = KSL_MUL(2.841133715943113e-29, 1.8051943758648296e-276
          + (beta_v_size_3 + KSL_MUL(beta_v_size_5, m_padded_1))),
      R_error_5 = fabs(1.0 - (R_11 + R_right_5) - (others_1 - R_right_5)
          - (others_lo1_2 + (m_cross2_1 + m_cross2_3))),
      R_rest_5 = KSL_MUL(2.841133715943113e-29, 1.8051943758648296e-276
          + (beta_v_size_1 + KSL_MUL(beta_v_size_5, m_padded_2))),
      R_error_9 = fabs(1.0 - (R_22 + R_right_9) - (others_2 - R_right_9)
          - (others_lo1_3 + (m_cross2_1 + m_cross2_2))),
      R_bound_1 = R_error_1
          + KSL_MUL(2.998906207317825e-29, 1.8051943758648296e-276 + (1.0 + (m_size_2 + m_size_3))),
      R_bound_2 = fabs(R_lo1_2 + (m_cross2_4 - alpha_v_cross2_3)) + R_rest_2,
      R_bound_3 = fabs(R_lo1_3 + (m_cross2_5 + alpha_v_cross2_2)) + R_rest_3,
      R_bound_4 = fabs(R_lo1_4 + (m_cross2_4 + alpha_v_cross2_3)) + R_rest_2,
      R_bound_5 = R_error_5
          + KSL_MUL(2.998906207317825e-29, 1.8051943758648296e-276 + (1.0 + (m_size_1 + m_size_3))),
      R_bound_6 = fabs(R_lo1_6 + (m_cross2_6 - alpha_v_cross2_1)) + R_rest_5,
      R_bound_7 = fabs(R_lo1_7 + (m_cross2_5 - alpha_v_cross2_2)) + R_rest_3,
      R_bound_8 = fabs(R_lo1_8 + (m_cross2_6 + alpha_v_cross2_1)) + R_rest_5,
      R_bound_9 = R_error_9
          + KSL_MUL(2.998906207317825e-29, 1.8051943758648296e-276 + (1.0 + (m_size_1 + m_size_2)));
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
  R_bound->m00 = R_bound_1;
  R_bound->m01 = R_bound_2;
  R_bound->m02 = R_bound_3;
  R_bound->m10 = R_bound_4;
  R_bound->m11 = R_bound_5;
  R_bound->m12 = R_bound_6;
  R_bound->m20 = R_bound_7;
  R_bound->m21 = R_bound_8;
  R_bound->m22 = R_bound_9;
}

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0;
     |error of angle| <= angle_bound, |error of axis| <= axis_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; axis, axis_bound: vector; angle_bound: number.
   233 mul, 467 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 10 neg, 70 abs, 4
     copysign, 41 less, 7 equal, 111 select. */
static inline double ksl_axis_angle_from_mat3x3_certified(const ksl_mat3x3_t *R, ksl_vec3_t *axis,
    double *angle_bound, ksl_vec3_t *axis_bound) {
  const double p_0 = R->m21 - R->m12, p_right_1 = R->m21 - p_0,
      p_lo_1 = R->m21 - (p_0 + p_right_1) - (R->m12 - p_right_1),
      p_size_3 = fabs(R->m21) + fabs(R->m12);
  const double p_1 = R->m02 - R->m20, p_right_2 = R->m02 - p_1,
      p_lo_2 = R->m02 - (p_1 + p_right_2) - (R->m20 - p_right_2),
      p_size_6 = fabs(R->m02) + fabs(R->m20);
  const double p_2 = R->m10 - R->m01, p_right_3 = R->m10 - p_2,
      p_lo_3 = R->m10 - (p_2 + p_right_3) - (R->m01 - p_right_3),
      p_size_9 = fabs(R->m10) + fabs(R->m01);
  const double s_0 = R->m12 + R->m21, s_right_1 = s_0 - R->m12,
      s_lo_1 = R->m12 - (s_0 - s_right_1) + (R->m21 - s_right_1);
  const double s_1 = R->m02 + R->m20, s_right_2 = s_1 - R->m02,
      s_lo_2 = R->m02 - (s_1 - s_right_2) + (R->m20 - s_right_2);
  const double s_2 = R->m01 + R->m10, s_right_3 = s_2 - R->m01,
      s_lo_3 = R->m01 - (s_2 - s_right_3) + (R->m10 - s_right_3);
  const double first_0 = R->m00 + 1.0, first_right_1 = first_0 - R->m00,
      first_lo_1 = R->m00 - (first_0 - first_right_1) + (1.0 - first_right_1);
  const double first_1 = 1.0 - R->m00, first_right_2 = 1.0 - first_1,
      first_lo_2 = 1.0 - (first_1 + first_right_2) - (R->m00 - first_right_2);
  const double others_0 = R->m11 + R->m22, others_right_1 = others_0 - R->m11,
      others_lo_1 = R->m11 - (others_0 - others_right_1) + (R->m22 - others_right_1);
  const double others_1 = R->m11 - R->m22, others_right_2 = R->m11 - others_1,
      others_lo_2 = R->m11 - (others_1 + others_right_2) - (R->m22 - others_right_2);
  const double d_0 = first_0 + others_0, d_right_1 = d_0 - first_0,
      d_lo_1 = first_0 - (d_0 - d_right_1) + (others_0 - d_right_1) + others_lo_1 + first_lo_1,
      d_size_1 = 1.0 + fabs(R->m00) + (fabs(R->m11) + fabs(R->m22));
  const double d_1 = first_0 - others_0, d_right_2 = first_0 - d_1,
      d_lo_2 = first_0 - (d_1 + d_right_2) - (others_0 - d_right_2) - others_lo_1 + first_lo_1;
  const double d_2 = first_1 + others_1, d_right_3 = d_2 - first_1,
      d_lo_3 = first_1 - (d_2 - d_right_3) + (others_1 - d_right_3) + others_lo_2 + first_lo_2;
  const double d_3 = first_1 - others_1, d_right_4 = first_1 - d_3,
      d_lo_4 = first_1 - (d_3 + d_right_4) - (others_1 - d_right_4) - others_lo_2 + first_lo_2;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2, low_lo_1 = R->m11 < R->m00 ? d_lo_2 : s_lo_3,
      low_size_1 = R->m11 < R->m00 ? d_size_1 : p_size_9;
  const double low_1 = R->m11 < R->m00 ? s_2 : d_2, low_lo_2 = R->m11 < R->m00 ? s_lo_3 : d_lo_3,
      low_size_2 = R->m11 < R->m00 ? p_size_9 : d_size_1;
  const double low_2 = R->m11 < R->m00 ? s_1 : s_0, low_lo_3 = R->m11 < R->m00 ? s_lo_2 : s_lo_1,
      low_size_3 = R->m11 < R->m00 ? p_size_6 : p_size_3;
  const double low_3 = R->m11 < R->m00 ? p_0 : p_1, low_lo_4 = R->m11 < R->m00 ? p_lo_1 : p_lo_2,
      low_size_4 = R->m11 < R->m00 ? p_size_3 : p_size_6;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0,
      high_lo_1 = R->m00 < high_0a ? s_lo_2 : p_lo_1,
      high_size_1 = R->m00 < high_0a ? p_size_6 : p_size_3;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1,
      high_lo_2 = R->m00 < high_0a ? s_lo_1 : p_lo_2,
      high_size_2 = R->m00 < high_0a ? p_size_3 : p_size_6;
  const double high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_lo_3 = R->m00 < high_0a ? d_lo_4 : p_lo_3,
      high_size_3 = R->m00 < high_0a ? d_size_1 : p_size_9;
  const double high_3 = R->m00 < high_0a ? p_2 : d_0,
      high_lo_4 = R->m00 < high_0a ? p_lo_3 : d_lo_1,
      high_size_4 = R->m00 < high_0a ? p_size_9 : d_size_1;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0,
      column_lo_1 = R->m22 < 0.0 ? low_lo_1 : high_lo_1,
      column_size_1 = R->m22 < 0.0 ? low_size_1 : high_size_1;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_lo_2 = R->m22 < 0.0 ? low_lo_2 : high_lo_2,
      column_size_2 = R->m22 < 0.0 ? low_size_2 : high_size_2;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2,
      column_lo_3 = R->m22 < 0.0 ? low_lo_3 : high_lo_3,
      column_size_3 = R->m22 < 0.0 ? low_size_3 : high_size_3;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3,
      column_lo_4 = R->m22 < 0.0 ? low_lo_4 : high_lo_4,
      column_size_4 = R->m22 < 0.0 ? low_size_4 : high_size_4;
  const double upper_0a = -column_0, upper_0a_lo = -column_lo_1,
      upper_0 = column_3 < 0.0 ? upper_0a : column_0,
      upper_rest_1 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276 + column_size_4),
      upper_bound_1 = fabs(column_lo_4) + upper_rest_1, upper_size_2 = fabs(column_3 - 0.0),
      upper_rest_2 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276 + column_size_1),
      upper_size_7 = fabs(column_lo_1) + upper_rest_2
          + (fabs(upper_0a_lo) + upper_rest_2 + fabs(upper_0a - column_0));
  const double upper_1a = -column_1, upper_1a_lo = -column_lo_2,
      upper_1 = column_3 < 0.0 ? upper_1a : column_1,
      upper_rest_3 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276 + column_size_2),
      upper_size_14 = fabs(column_lo_2) + upper_rest_3
          + (fabs(upper_1a_lo) + upper_rest_3 + fabs(upper_1a - column_1));
  const double upper_2a = -column_2, upper_2a_lo = -column_lo_3,
      upper_2 = column_3 < 0.0 ? upper_2a : column_2,
      upper_rest_4 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276 + column_size_3),
      upper_size_21 = fabs(column_lo_3) + upper_rest_4
          + (fabs(upper_2a_lo) + upper_rest_4 + fabs(upper_2a - column_2));
  const double upper_3a = -column_3, upper_3a_lo = -column_lo_4,
      upper_3 = column_3 < 0.0 ? upper_3a : column_3,
      upper_lo_4 = column_3 < 0.0 ? upper_3a_lo : column_lo_4,
      upper_size_28 = upper_bound_1
          + (fabs(upper_3a_lo) + upper_rest_1 + fabs(upper_3a - column_3));
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_b_size_1 = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s_d_size_1 = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b_size_1,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d,
      v_s_size_3 = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d_size_1;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_inverse_1 = 1.0 / v_s,
      v_y_lo_1 = KSL_MUL(upper_0 - KSL_MUL(v_y_0, v_y_inverse_1)
          + (column_3 < 0.0 ? upper_0a_lo : column_lo_1), v_s);
  const double v_s_size_padded_1 = 1.8051943758648296e-276
          + (column_size_1
          + KSL_MUL(1.5845630613906556e+29, upper_bound_1 < upper_size_2 ? 0.0 : upper_size_7));
  const double v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_lo_2 = KSL_MUL(upper_1 - KSL_MUL(v_y_1, v_y_inverse_1)
          + (column_3 < 0.0 ? upper_1a_lo : column_lo_2), v_s);
  const double v_s_size_padded_2 = 1.8051943758648296e-276
          + (column_size_2
          + KSL_MUL(1.5845630613906556e+29, upper_bound_1 < upper_size_2 ? 0.0 : upper_size_14));
  const double v_y_2 = KSL_MUL(upper_2, v_s),
      v_y_lo_3 = KSL_MUL(upper_2 - KSL_MUL(v_y_2, v_y_inverse_1)
          + (column_3 < 0.0 ? upper_2a_lo : column_lo_3), v_s);
  const double v_s_size_padded_3 = 1.8051943758648296e-276
          + (column_size_3
          + KSL_MUL(1.5845630613906556e+29, upper_bound_1 < upper_size_2 ? 0.0 : upper_size_21));
  const double v_n_a = KSL_MUL(v_y_0, v_y_0),
      v_n_a_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_1),
      v_n_a_size_2 = KSL_MUL(v_n_a_padded_1, fabs(v_y_0)
          + KSL_MUL(140737488355328.0, fabs(v_y_lo_1)
          + KSL_MUL(6.705320021857442e-30, v_n_a_padded_1))), v_n_b = KSL_MUL(v_y_1, v_y_1),
      v_n_b_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_2),
      v_n_b_size_2 = KSL_MUL(v_n_b_padded_1, fabs(v_y_1)
          + KSL_MUL(140737488355328.0, fabs(v_y_lo_2)
          + KSL_MUL(6.705320021857442e-30, v_n_b_padded_1))), v_n_c = v_n_a + v_n_b,
      v_n_c_right_1 = v_n_c - v_n_a,
      v_n_c_lo1_1 = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1), v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_d_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_3),
      v_n_d_size_2 = KSL_MUL(v_n_d_padded_1, fabs(v_y_2)
          + KSL_MUL(140737488355328.0, fabs(v_y_lo_3)
          + KSL_MUL(6.705320021857442e-30, v_n_d_padded_1))), v_n_e = v_n_c + v_n_d,
      v_n_e_right_1 = v_n_e - v_n_c,
      v_n_e_lo1_1 = v_n_c - (v_n_e - v_n_e_right_1)
          + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right_1),
      v_n_c_lo = v_n_c_lo1_1
          + (KSL_MUL(v_y_lo_1, v_y_0) + KSL_MUL(v_y_0, v_y_lo_1)
          + (KSL_MUL(v_y_lo_2, v_y_1) + KSL_MUL(v_y_1, v_y_lo_2))),
      v_n_e_lo = v_n_e_lo1_1 + (KSL_MUL(v_y_lo_3, v_y_2) + KSL_MUL(v_y_2, v_y_lo_3)) + v_n_c_lo,
      v_n = sqrt(v_n_e), v_n_product_1 = KSL_MUL(v_n, v_n), v_n_twice_1 = v_n + v_n,
      v_n_lo = (v_n_e - v_n_product_1 - ksl_product_error(v_n, v_n, v_n_product_1) + v_n_e_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice_1),
      v_n_padded_1 = 1.8051943758648296e-276
          + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
          + (v_n_d_size_2 + v_n_d_size_2)),
      v_n_bound_1 = fabs(v_n_e_lo) + KSL_MUL(1.150011758590251e-29, v_n_padded_1),
      v_n_size_4 = KSL_MUL(fabs(v_n_e) + KSL_MUL(140737488355328.0, v_n_bound_1), v_n_padded_1
          / v_n / v_n_e), v_n_size_6 = fabs(v_n_lo),
      v_n_size_8 = KSL_MUL(1.1418664350501995e+29, sqrt(v_n_bound_1) + v_n_size_6),
      v_n_size_12 = v_n + (KSL_MUL(4.0, v_n_bound_1) < v_n_e ? v_n_size_4 : v_n_size_8);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_b_size_1 = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r_d_size_1 = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b_size_1,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n = KSL_MUL(v_n, v_r), n_lo = KSL_MUL(v_n - KSL_MUL(n, 1.0 / v_r) + v_n_lo, v_r),
      n_padded_1 = 1.8051943758648296e-276 + v_n_size_12;
  const double half = ksl_atan2(n, upper_3), half_size0_1 = fabs(n), half_size1_1 = fabs(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0 ? 1.0 : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1,
      half_divisor2_1 = KSL_MUL(half_divisor_1, KSL_MUL(half_part1_1, half_part1_1)
          + KSL_MUL(half_part0_1, half_part0_1)),
      half_more_1 = (KSL_MUL(half_part1_1, n_lo) - KSL_MUL(half_part0_1, upper_lo_4))
          / (half_most_1 == 0.0 ? 1.0 : half_divisor2_1),
      half_lo = ksl_atan2_error(n, upper_3, half) + half_more_1,
      half_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(n_padded_1, 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302
          : v_r_d_size_1),
      half_padded_2 = 1.8051943758648296e-276
          + (column_size_4
          + KSL_MUL(1.5845630613906556e+29, upper_bound_1 < upper_size_2 ? 0.0 : upper_size_28)),
      half_size_2 = fabs(n), half_size_3 = fabs(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_bound_1 = fabs(n_lo) + KSL_MUL(9.423194733875307e-30, half_padded_1),
      half_bound_2 = fabs(upper_lo_4) + KSL_MUL(6.508104019725916e-30, half_padded_2),
      half_size_11 = (half_bound_2 + (1.8051943758648296e-276 + half_bound_1)) / half_size_5,
      half_size_13 = KSL_MUL(half_size_11, half_size_11), half_size_15 = 7.0 + fabs(half_lo),
      half_size_18 = half_bound_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_21 = KSL_MUL(4.527322338646221e+28, half_size_11 < 0.25 ? half_size_19
          : half_size_15);
  const double divisor = v_n == 0.0 ? 1.0 : v_n, divisor_lo = v_n == 0.0 ? 0.0 : v_n_lo,
      divisor_bound_1 = KSL_MUL(9.152022998369425e-30, n_padded_1) + v_n_size_6,
      divisor_size_3 = fabs(v_n - 0.0), divisor_size_7 = divisor_bound_1 + fabs(1.0 - v_n);
  const double unit_0 = v_y_0 / divisor, unit_product_1 = KSL_MUL(unit_0, divisor),
      unit_lo_1 = (v_y_0 - unit_product_1 - ksl_product_error(unit_0, divisor, unit_product_1)
          + v_y_lo_1 - KSL_MUL(unit_0, divisor_lo)) / divisor;
  const double divisor_size_10 = (v_n == 0.0 ? 1.0 : v_n_size_12)
          + KSL_MUL(7.9228134180075855e+28, divisor_bound_1 < divisor_size_3 ? 0.0
          : divisor_size_7);
  const double unit_padded_1 = 1.8051943758648296e-276 + divisor_size_10,
      unit_size_1 = fabs(unit_0), unit_size_2 = fabs(divisor),
      unit_bound_1 = fabs(divisor_lo) + KSL_MUL(1.3016211142756918e-29, unit_padded_1),
      unit_size_7 = KSL_MUL(4.0, unit_bound_1) < unit_size_2 ? unit_size_2 : 0.0,
      unit_reach_1 = unit_size_2 + KSL_MUL(140737488355328.0, unit_bound_1),
      unit_size_11 = unit_size_1
          + KSL_MUL(unit_reach_1, (KSL_MUL(unit_padded_1, unit_size_1) + v_n_a_padded_1)
          / unit_size_7) / unit_size_2;
  const double unit_1 = v_y_1 / divisor, unit_product_2 = KSL_MUL(unit_1, divisor),
      unit_size_12 = fabs(unit_1);
  const double unit_2 = v_y_2 / divisor, unit_product_3 = KSL_MUL(unit_2, divisor),
      unit_size_19 = fabs(unit_2);
  const double angle = KSL_MUL(2.0, half);
  const double axis_0 = v_n == 0.0 ? 1.0 : unit_0,
      axis_size_4 = fabs(unit_lo_1)
          + KSL_MUL(1.86204130450056e-29, 1.8051943758648296e-276 + unit_size_11)
          + fabs(1.0 - unit_0);
  const double angle_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(2.0, fabs(half) + (half_padded_1 + half_padded_2) / half_size_5 + half_size_21);
  const double axis_size_7 = (v_n == 0.0 ? 1.0 : unit_size_11)
          + KSL_MUL(5.516518603020976e+28, divisor_bound_1 < divisor_size_3 ? 0.0 : axis_size_4);
  const double unit_size_18 = unit_size_12
          + KSL_MUL(unit_reach_1, (KSL_MUL(unit_padded_1, unit_size_12) + v_n_b_padded_1)
          / unit_size_7) / unit_size_2;
  const double unit_error_2 = fabs((v_y_1 - unit_product_2
          - ksl_product_error(unit_1, divisor, unit_product_2) + v_y_lo_2
          - KSL_MUL(unit_1, divisor_lo)) / divisor);
  const double unit_size_25 = unit_size_19
          + KSL_MUL(unit_reach_1, (KSL_MUL(unit_padded_1, unit_size_19) + v_n_d_padded_1)
          / unit_size_7) / unit_size_2;
  const double unit_error_3 = fabs((v_y_2 - unit_product_3
          - ksl_product_error(unit_2, divisor, unit_product_3) + v_y_lo_3
          - KSL_MUL(unit_2, divisor_lo)) / divisor);
  const double R_n_0 = KSL_MUL(R->m11, R->m22) - KSL_MUL(R->m12, R->m21),
      R_n_1 = KSL_MUL(R->m02, R->m21) - KSL_MUL(R->m01, R->m22),
      R_n_2 = KSL_MUL(R->m01, R->m12) - KSL_MUL(R->m02, R->m11);
  const double R_det = KSL_MUL(R->m00, R_n_0) + KSL_MUL(R->m10, R_n_1) + KSL_MUL(R->m20, R_n_2);
  const double R_g_0 = KSL_MUL(R->m00, R->m00) + KSL_MUL(R->m10, R->m10) + KSL_MUL(R->m20, R->m20),
      R_g_1 = KSL_MUL(R->m00, R->m01) + KSL_MUL(R->m10, R->m11) + KSL_MUL(R->m20, R->m21),
      R_g_2 = KSL_MUL(R->m00, R->m02) + KSL_MUL(R->m10, R->m12) + KSL_MUL(R->m20, R->m22),
      R_g_3 = KSL_MUL(R->m01, R->m01) + KSL_MUL(R->m11, R->m11) + KSL_MUL(R->m21, R->m21),
      R_g_4 = KSL_MUL(R->m01, R->m02) + KSL_MUL(R->m11, R->m12) + KSL_MUL(R->m21, R->m22),
      R_g_5 = KSL_MUL(R->m02, R->m02) + KSL_MUL(R->m12, R->m12) + KSL_MUL(R->m22, R->m22);
  const double R_off_0 = R_det - 1.0, R_off_1 = R_g_0 - 1.0, R_off_4 = R_g_3 - 1.0,
      R_off_6 = R_g_5 - 1.0;
  const double R_defect_size_0 = fabs(R_off_0), R_defect_size_1 = fabs(R_off_1),
      R_defect_size_2 = fabs(R_g_1), R_defect_size_3 = fabs(R_g_2), R_defect_size_4 = fabs(R_off_4),
      R_defect_size_5 = fabs(R_g_4), R_defect_size_6 = fabs(R_off_6);
  const double R_defect_largest1 = R_defect_size_0 < R_defect_size_1 ? R_defect_size_1
          : R_defect_size_0;
  const double R_defect_largest2 = R_defect_largest1 < R_defect_size_2 ? R_defect_size_2
          : R_defect_largest1;
  const double R_defect_largest3 = R_defect_largest2 < R_defect_size_3 ? R_defect_size_3
          : R_defect_largest2;
  const double R_defect_largest4 = R_defect_largest3 < R_defect_size_4 ? R_defect_size_4
          : R_defect_largest3;
  const double R_defect_largest5 = R_defect_largest4 < R_defect_size_5 ? R_defect_size_5
          : R_defect_largest4;
  const double R_defect_largest6 = R_defect_largest5 < R_defect_size_6 ? R_defect_size_6
          : R_defect_largest5;
  const double R_unless_equal = R_defect_largest6 == 0.001 ? 0.0 : 1.0715086071862673e+301;
  const double R_unless_rotation = R_defect_largest6 < 0.001 ? 0.0 : R_unless_equal;
  const double R_excess = KSL_MUL(R_unless_rotation, 1.0715086071862673e+301),
      R_excess_0 = fabs(KSL_MUL(2.0, half_lo)) + KSL_MUL(2.3160472449138492e-29, angle_padded_1)
          + R_excess,
      R_excess_1 = fabs(v_n == 0.0 ? 0.0 : unit_lo_1)
          + KSL_MUL(1.8620414596658144e-29, 1.8051943758648296e-276 + axis_size_7) + R_excess,
      R_excess_2 = unit_error_2
          + KSL_MUL(1.86204130450056e-29, 1.8051943758648296e-276 + unit_size_18) + R_excess,
      R_excess_3 = unit_error_3
          + KSL_MUL(1.86204130450056e-29, 1.8051943758648296e-276 + unit_size_25) + R_excess;
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  *angle_bound = R_excess_0;
  axis_bound->x = R_excess_1;
  axis_bound->y = R_excess_2;
  axis_bound->z = R_excess_3;
  return angle;
}

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x; |error of Ro| <= Ro_bound
     unless inf or NaN.
   w, dw: vector; Ro, Ro_bound: rotation or other 3×3 matrix.
   15 mul, 27 add, 3 neg, 9 abs. */
static inline void ksl_acceleration_tensorf_certified(const ksl_vec3f_t *w, const ksl_vec3f_t *dw,
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float ww_0 = KSL_MULF(w->x, w->x), ww_1 = KSL_MULF(w->y, w->y), ww_2 = KSL_MULF(w->z, w->z),
      ww_3 = KSL_MULF(w->x, w->y), ww_4 = KSL_MULF(w->x, w->z), ww_5 = KSL_MULF(w->y, w->z);
  const float Ro_00 = -(ww_1 + ww_2), Ro_01 = ww_3 - dw->z, Ro_02 = dw->y + ww_4,
      Ro_10 = dw->z + ww_3, Ro_11 = -(ww_0 + ww_2), Ro_12 = ww_5 - dw->x, Ro_20 = ww_4 - dw->y,
      Ro_21 = dw->x + ww_5, Ro_22 = -(ww_0 + ww_1);
  const float ww_1_abs = fabsf(ww_1), ww_2_abs = fabsf(ww_2);
  const float ww_3_abs = fabsf(ww_3), dw_2_abs = fabsf(dw->z), Ro_01_size = ww_3_abs + dw_2_abs;
  const float dw_1_abs = fabsf(dw->y), ww_4_abs = fabsf(ww_4), Ro_02_size = dw_1_abs + ww_4_abs;
  const float Ro_10_size = dw_2_abs + ww_3_abs, ww_0_abs = fabsf(ww_0);
  const float ww_5_abs = fabsf(ww_5), dw_0_abs = fabsf(dw->x), Ro_12_size = ww_5_abs + dw_0_abs;
  const float Ro_20_size = ww_4_abs + dw_1_abs, Ro_21_size = dw_0_abs + ww_5_abs;
  const float Ro_00a_bound = KSL_MULF(1.192093e-07f, ww_1_abs + ww_2_abs + 1.9721523e-31f);
  const float Ro_01_bound = KSL_MULF(1.192093e-07f, Ro_01_size + 1.9721523e-31f),
      Ro_02_bound = KSL_MULF(1.192093e-07f, Ro_02_size + 1.9721523e-31f),
      Ro_10_bound = KSL_MULF(1.192093e-07f, Ro_10_size + 1.9721523e-31f);
  const float Ro_11a_bound = KSL_MULF(1.192093e-07f, ww_0_abs + ww_2_abs + 1.9721523e-31f);
  const float Ro_12_bound = KSL_MULF(1.192093e-07f, Ro_12_size + 1.9721523e-31f),
      Ro_20_bound = KSL_MULF(1.192093e-07f, Ro_20_size + 1.9721523e-31f),
      Ro_21_bound = KSL_MULF(1.192093e-07f, Ro_21_size + 1.9721523e-31f);
  const float Ro_22a_bound = KSL_MULF(1.192093e-07f, ww_0_abs + ww_1_abs + 1.9721523e-31f);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00a_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11a_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22a_bound;
}

/* det R; |error of det| <= det_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; det_bound: number.
   13 mul, 14 add, 9 abs. */
static inline float ksl_mat3x3f_determinant_certified(const ksl_mat3x3f_t *R, float *det_bound) {
  const float n_0a = KSL_MULF(R->m11, R->m22), n_0b = KSL_MULF(R->m12, R->m21), n_0 = n_0a - n_0b;
  const float n_1a = KSL_MULF(R->m02, R->m21), n_1b = KSL_MULF(R->m01, R->m22), n_1 = n_1a - n_1b;
  const float n_2a = KSL_MULF(R->m01, R->m12), n_2b = KSL_MULF(R->m02, R->m11), n_2 = n_2a - n_2b;
  const float det = KSL_MULF(R->m00, n_0) + KSL_MULF(R->m10, n_1) + KSL_MULF(R->m20, n_2);
  const float n_0_size = fabsf(n_0a) + fabsf(n_0b), n_1_size = fabsf(n_1a) + fabsf(n_1b),
      n_2_size = fabsf(n_2a) + fabsf(n_2b);
  const float det_c_size = KSL_MULF(fabsf(R->m00), n_0_size + 1.9721523e-31f)
          + KSL_MULF(fabsf(R->m10), n_1_size + 1.9721523e-31f),
      det_size = det_c_size + KSL_MULF(fabsf(R->m20), n_2_size + 1.9721523e-31f);
  const float det_bound_ = KSL_MULF(2.9802328e-07f, det_size + 1.9721523e-31f);
  *det_bound = det_bound_;
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ); |error of R| <= R_bound unless inf or NaN.
   R, R_bound: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   30 mul, 31 add, 8 abs. */
static inline void ksl_mat3x3f_setFromAxisDC_certified(ksl_mat3x3f_t *R, const ksl_vec3f_t *axis,
    const float dc[2], ksl_mat3x3f_t *R_bound) {
  const float versine = 1.0f - dc[1];
  const float versine_axis_0 = KSL_MULF(axis->x, versine),
      versine_axis_1 = KSL_MULF(axis->y, versine), versine_axis_2 = KSL_MULF(axis->z, versine);
  const float m_0 = KSL_MULF(axis->x, versine_axis_0);
  const float m_1 = KSL_MULF(axis->y, versine_axis_1);
  const float m_2 = KSL_MULF(axis->z, versine_axis_2), m_3 = KSL_MULF(axis->y, versine_axis_0),
      m_4 = KSL_MULF(axis->z, versine_axis_0), m_5 = KSL_MULF(axis->z, versine_axis_1);
  const float sine_axis_0 = KSL_MULF(axis->x, dc[0]), sine_axis_1 = KSL_MULF(axis->y, dc[0]),
      sine_axis_2 = KSL_MULF(axis->z, dc[0]);
  const float R_00 = dc[1] + m_0, R_01 = m_3 - sine_axis_2, R_02 = m_4 + sine_axis_1,
      R_10 = m_3 + sine_axis_2, R_11 = dc[1] + m_1, R_12 = m_5 - sine_axis_0,
      R_20 = m_4 - sine_axis_1, R_21 = m_5 + sine_axis_0, R_22 = dc[1] + m_2;
  const float axis_0_abs = fabsf(axis->x), versine_abs = fabsf(versine),
      versine_axis_0_size = KSL_MULF(axis_0_abs, versine_abs);
  const float axis_1_abs = fabsf(axis->y), versine_axis_1_size = KSL_MULF(axis_1_abs, versine_abs);
  const float axis_2_abs = fabsf(axis->z), versine_axis_2_size = KSL_MULF(axis_2_abs, versine_abs);
  const float versine_axis_0_padded = versine_axis_0_size + 1.9721523e-31f;
  const float m_0_size = KSL_MULF(axis_0_abs, versine_axis_0_padded);
  const float versine_axis_1_padded = versine_axis_1_size + 1.9721523e-31f;
  const float m_1_size = KSL_MULF(axis_1_abs, versine_axis_1_padded),
      m_2_size = KSL_MULF(axis_2_abs, versine_axis_2_size + 1.9721523e-31f),
      m_3_size = KSL_MULF(axis_1_abs, versine_axis_0_padded),
      m_4_size = KSL_MULF(axis_2_abs, versine_axis_0_padded),
      m_5_size = KSL_MULF(axis_2_abs, versine_axis_1_padded);
  const float dc_1_abs = fabsf(dc[1]), R_00_size = dc_1_abs + m_0_size;
  const float sine_axis_2_abs = fabsf(sine_axis_2), R_01_size = m_3_size + sine_axis_2_abs;
  const float sine_axis_1_abs = fabsf(sine_axis_1), R_02_size = m_4_size + sine_axis_1_abs;
  const float R_10_size = m_3_size + sine_axis_2_abs, R_11_size = dc_1_abs + m_1_size;
  const float sine_axis_0_abs = fabsf(sine_axis_0), R_12_size = m_5_size + sine_axis_0_abs;
  const float R_20_size = m_4_size + sine_axis_1_abs, R_21_size = m_5_size + sine_axis_0_abs,
      R_22_size = dc_1_abs + m_2_size;
  const float R_00_bound = KSL_MULF(2.3841864e-07f, R_00_size + 1.9721523e-31f),
      R_01_bound = KSL_MULF(2.3841864e-07f, R_01_size + 1.9721523e-31f),
      R_02_bound = KSL_MULF(2.3841864e-07f, R_02_size + 1.9721523e-31f),
      R_10_bound = KSL_MULF(2.3841864e-07f, R_10_size + 1.9721523e-31f),
      R_11_bound = KSL_MULF(2.3841864e-07f, R_11_size + 1.9721523e-31f),
      R_12_bound = KSL_MULF(2.3841864e-07f, R_12_size + 1.9721523e-31f),
      R_20_bound = KSL_MULF(2.3841864e-07f, R_20_size + 1.9721523e-31f),
      R_21_bound = KSL_MULF(2.3841864e-07f, R_21_size + 1.9721523e-31f),
      R_22_bound = KSL_MULF(2.3841864e-07f, R_22_size + 1.9721523e-31f);
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
  R_bound->m00 = R_00_bound;
  R_bound->m01 = R_01_bound;
  R_bound->m02 = R_02_bound;
  R_bound->m10 = R_10_bound;
  R_bound->m11 = R_11_bound;
  R_bound->m12 = R_12_bound;
  R_bound->m20 = R_20_bound;
  R_bound->m21 = R_21_bound;
  R_bound->m22 = R_22_bound;
}

/* R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.
   angles: vector; R, R_bound: rotation or other 3×3 matrix.
   237 mul, 347 add, 30 product error, 8 product rest, 3 div, 9 neg, 18 abs, 3 less, 3 select. */
static inline void ksl_mat3x3f_from_euler_xyz_certified(const ksl_vec3f_t *angles,
    ksl_mat3x3f_t *R, ksl_mat3x3f_t *R_bound) {
  float c_0; const float s_0 = ksl_sincosf(angles->x, &c_0);
  float c_own_error_1; const float s_own_error_1 = ksl_sincos_errorf(angles->x, s_0, c_0,
      &c_own_error_1);
  float c_1; const float s_1 = ksl_sincosf(angles->y, &c_1);
  float c_own_error_2; const float s_own_error_2 = ksl_sincos_errorf(angles->y, s_1, c_1,
      &c_own_error_2);
  float c_2; const float s_2 = ksl_sincosf(angles->z, &c_2);
  float c_own_error_3; const float s_own_error_3 = ksl_sincos_errorf(angles->z, s_2, c_2,
      &c_own_error_3);
  const float first_0 = KSL_MULF(c_1, c_2), first_1 = -KSL_MULF(s_2, c_1),
      first_6 = -KSL_MULF(s_1, c_2), first_7 = KSL_MULF(s_1, s_2);
  const float last_3a = KSL_MULF(s_2, c_0),
      first_lo_1 = ksl_product_errorf(-s_1, c_2, first_6) +
          -(KSL_MULF(s_own_error_2, c_2) + KSL_MULF(s_1, c_own_error_3)),
      last_3b = KSL_MULF(s_0, first_6), last_3 = last_3a - last_3b, last_right_1 = last_3a - last_3,
      last_cross_1 = KSL_MULF(s_own_error_3, c_0) + KSL_MULF(s_2, c_own_error_1)
          - (KSL_MULF(s_own_error_1, first_6) + KSL_MULF(s_0, first_lo_1));
  const float last_4a = KSL_MULF(c_0, c_2),
      first_lo_2 = ksl_product_errorf(s_1, s_2, first_7)
          + (KSL_MULF(s_own_error_2, s_2) + KSL_MULF(s_1, s_own_error_3)),
      last_4b = KSL_MULF(s_0, first_7), last_4 = last_4a - last_4b, last_right_2 = last_4a - last_4,
      last_cross_2 = KSL_MULF(c_own_error_1, c_2) + KSL_MULF(c_0, c_own_error_3)
          - (KSL_MULF(s_own_error_1, first_7) + KSL_MULF(s_0, first_lo_2));
  const float last_5 = -KSL_MULF(s_0, c_1);
  const float last_6a = KSL_MULF(s_0, s_2), last_6b = KSL_MULF(c_0, first_6),
      last_6 = last_6a + last_6b, last_right_3 = last_6 - last_6a,
      last_cross_4 = KSL_MULF(s_own_error_1, s_2) + KSL_MULF(s_0, s_own_error_3)
          + (KSL_MULF(c_own_error_1, first_6) + KSL_MULF(c_0, first_lo_1));
  const float last_7a = KSL_MULF(s_0, c_2), last_7b = KSL_MULF(c_0, first_7),
      last_7 = last_7a + last_7b, last_right_4 = last_7 - last_7a,
      last_cross_5 = KSL_MULF(s_own_error_1, c_2) + KSL_MULF(s_0, c_own_error_3)
          + (KSL_MULF(c_own_error_1, first_7) + KSL_MULF(c_0, first_lo_2));
  const float last_8 = KSL_MULF(c_0, c_1);
  const float last_lo_1 = ksl_product_restf(s_2, c_0, last_3a, last_3 + last_right_1)
          - ksl_product_restf(s_0, first_6, last_3b, last_right_1) + last_cross_1;
  const float last_lo_2 = ksl_product_restf(c_0, c_2, last_4a, last_4 + last_right_2)
          - ksl_product_restf(s_0, first_7, last_4b, last_right_2) + last_cross_2;
  const float last_lo_3 = ksl_product_restf(s_0, s_2, last_6a, last_6 - last_right_3)
          + ksl_product_restf(c_0, first_6, last_6b, last_right_3) + last_cross_4;
  const float last_lo_4 = ksl_product_restf(s_0, c_2, last_7a, last_7 - last_right_4)
          + ksl_product_restf(c_0, first_7, last_7b, last_right_4) + last_cross_5;
  const float first_bound_1 = 2.252443e-12f
          + fabsf(ksl_product_errorf(c_1, c_2, first_0)
          + (KSL_MULF(c_own_error_2, c_2) + KSL_MULF(c_1, c_own_error_3))),
      first_bound_2 = 2.252443e-12f
          + fabsf(ksl_product_errorf(-s_2, c_1, first_1) +
          -(KSL_MULF(s_own_error_3, c_1) + KSL_MULF(s_2, c_own_error_2))),
      s_bound_1 = 1.0800312e-12f + fabsf(s_own_error_2),
      last_bound_1 = 7.7379336e-12f + fabsf(last_lo_1),
      last_bound_2 = 7.7379336e-12f + fabsf(last_lo_2),
      last_bound_3 = 2.252443e-12f
          + fabsf(ksl_product_errorf(-s_0, c_1, last_5) +
          -(KSL_MULF(s_own_error_1, c_1) + KSL_MULF(s_0, c_own_error_2))),
      last_bound_4 = 7.7379336e-12f + fabsf(last_lo_3),
      last_bound_5 = 7.7379336e-12f + fabsf(last_lo_4),
      last_bound_6 = 2.252443e-12f
          + fabsf(ksl_product_errorf(c_0, c_1, last_8)
          + (KSL_MULF(c_own_error_1, c_1) + KSL_MULF(c_0, c_own_error_2)));
  R->m00 = first_0;
  R->m01 = first_1;
  R->m02 = s_1;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
  R_bound->m00 = first_bound_1;
  R_bound->m01 = first_bound_2;
  R_bound->m02 = s_bound_1;
  R_bound->m10 = last_bound_1;
  R_bound->m11 = last_bound_2;
  R_bound->m12 = last_bound_3;
  R_bound->m20 = last_bound_4;
  R_bound->m21 = last_bound_5;
  R_bound->m22 = last_bound_6;
}

/* angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
     [-π/2, π/2]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; angles, angles_bound: vector.
   353 mul, 588 add, 45 product error, 6 product rest, 27 div, 2 sqrt, 4 neg, 72 abs, 12
     copysign, 59 less, 14 equal, 108 select. */
static inline void ksl_euler_xyz_from_mat3x3f_certified(const ksl_mat3x3f_t *R,
    ksl_vec3f_t *angles, ksl_vec3f_t *angles_bound) {
  const float n_a = KSL_MULF(R->m00, R->m00), n_a_size_1 = fabsf(R->m00),
      n_b = KSL_MULF(R->m01, R->m01), n_b_size_1 = fabsf(R->m01), n_c = n_a + n_b,
      n_c_right_1 = n_c - n_a,
      n_c_lo = ksl_product_restf(R->m00, R->m00, n_a, n_c - n_c_right_1)
          + ksl_product_restf(R->m01, R->m01, n_b, n_c_right_1), n = sqrtf(n_c),
      n_product_1 = KSL_MULF(n, n), n_twice_1 = n + n,
      n_lo = (n_c - n_product_1 - ksl_product_errorf(n, n, n_product_1) + n_c_lo)
          / (n == 0.0f ? 1.0f : n_twice_1),
      n_padded_1 = 3.3087225e-24f
          + (KSL_MULF(n_a_size_1, n_a_size_1) + KSL_MULF(n_b_size_1, n_b_size_1)),
      n_bound_1 = fabsf(n_c_lo) + KSL_MULF(2.7711354e-13f, n_padded_1),
      n_size_4 = KSL_MULF(fabsf(n_c) + KSL_MULF(262144.0f, n_bound_1), n_padded_1 / n / n_c),
      n_size_6 = fabsf(n_lo), n_size_8 = KSL_MULF(1.7058937e+12f, sqrtf(n_bound_1) + n_size_6),
      n_size_12 = n + (KSL_MULF(4.0f, n_bound_1) < n_c ? n_size_4 : n_size_8);
  const float divisor = n == 0.0f ? 1.0f : n, divisor_lo = n == 0.0f ? 0.0f : n_lo,
      divisor_padded_1 = 3.3087225e-24f + n_size_12,
      divisor_bound_1 = KSL_MULF(6.430494e-13f, divisor_padded_1) + n_size_6,
      divisor_size_3 = fabsf(n - 0.0f), divisor_size_7 = divisor_bound_1 + fabsf(1.0f - n);
  const float cosine_a = R->m00 / divisor, cosine_a_product_1 = KSL_MULF(cosine_a, divisor),
      cosine_a_lo = (R->m00 - cosine_a_product_1
          - ksl_product_errorf(cosine_a, divisor, cosine_a_product_1)
          - KSL_MULF(cosine_a, divisor_lo)) / divisor;
  const float divisor_size_10 = (n == 0.0f ? 1.0f : n_size_12)
          + KSL_MULF(5.4975264e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : divisor_size_7);
  const float cosine_a_padded_2 = 3.3087225e-24f + divisor_size_10,
      cosine_a_size_1 = fabsf(cosine_a), cosine_a_size_2 = fabsf(divisor),
      cosine_a_bound_1 = fabsf(divisor_lo) + KSL_MULF(1.875852e-12f, cosine_a_padded_2),
      cosine_a_size_7 = KSL_MULF(4.0f, cosine_a_bound_1) < cosine_a_size_2 ? cosine_a_size_2 : 0.0f,
      cosine_a_reach_1 = cosine_a_size_2 + KSL_MULF(262144.0f, cosine_a_bound_1),
      cosine_a_size_9 = KSL_MULF(cosine_a_reach_1, (3.3087225e-24f + n_a_size_1
          + KSL_MULF(cosine_a_padded_2, cosine_a_size_1)) / cosine_a_size_7),
      cosine_a_size_11 = cosine_a_size_1 + cosine_a_size_9 / cosine_a_size_2,
      cosine = n == 0.0f ? 1.0f : cosine_a, cosine_lo = n == 0.0f ? 0.0f : cosine_a_lo,
      cosine_size_4 = fabsf(cosine_a_lo)
          + KSL_MULF(2.8564286e-12f, 3.3087225e-24f + cosine_a_size_11) + fabsf(1.0f - cosine_a);
  const float sine_a = -R->m01, sine = sine_a / divisor, sine_product_1 = KSL_MULF(sine, divisor),
      sine_lo = (sine_a - sine_product_1 - ksl_product_errorf(sine, divisor, sine_product_1)
          - KSL_MULF(sine, divisor_lo)) / divisor, sine_size_1 = fabsf(sine),
      sine_size_6 = KSL_MULF(cosine_a_reach_1, (3.3087225e-24f + n_b_size_1
          + KSL_MULF(cosine_a_padded_2, sine_size_1)) / cosine_a_size_7) / cosine_a_size_2;
  const float polar = ksl_atan2f(sine_a, R->m00),
      polar_own_error_1 = ksl_atan2_errorf(sine_a, R->m00, polar), polar_size_1 = fabsf(polar);
  const float third = n == 0.0f ? 0.0f : polar,
      third_size_4 = fabsf(polar_own_error_1)
          + KSL_MULF(1.0800314e-12f, 3.3087225e-24f + polar_size_1) + fabsf(0.0f - polar);
  const float left_1a = KSL_MULF(R->m10, sine),
      left_1a_padded_1 = 3.3087225e-24f + (sine_size_1 + sine_size_6),
      left_1b = KSL_MULF(R->m11, cosine);
  const float cosine_size_7 = (n == 0.0f ? 1.0f : cosine_a_size_11)
          + KSL_MULF(3.6086084e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : cosine_size_4);
  const float left_1b_padded_1 = 3.3087225e-24f + cosine_size_7, left_1 = left_1a + left_1b,
      left_right_1 = left_1 - left_1a,
      left_lo1_1 = ksl_product_restf(R->m10, sine, left_1a, left_1 - left_right_1)
          + ksl_product_restf(R->m11, cosine, left_1b, left_right_1),
      left_lo_1 = left_lo1_1 + (KSL_MULF(R->m10, sine_lo) + KSL_MULF(R->m11, cosine_lo));
  const float left_2a = KSL_MULF(R->m20, sine), left_2b = KSL_MULF(R->m21, cosine),
      left_2 = left_2a + left_2b, left_right_2 = left_2 - left_2a,
      left_lo1_2 = ksl_product_restf(R->m20, sine, left_2a, left_2 - left_right_2)
          + ksl_product_restf(R->m21, cosine, left_2b, left_right_2),
      left_lo_2 = left_lo1_2 + (KSL_MULF(R->m20, sine_lo) + KSL_MULF(R->m21, cosine_lo));
  const float rest = R->m12 + R->m22, rest_right_1 = rest - R->m12,
      rest_lo = R->m12 - (rest - rest_right_1) + (R->m22 - rest_right_1),
      rest_size_3 = fabsf(R->m12) + fabsf(R->m22);
  const float first = ksl_atan2f(left_2, left_1), first_size0_1 = fabsf(left_2),
      first_size1_1 = fabsf(left_1),
      first_most_1 = first_size0_1 < first_size1_1 ? first_size1_1 : first_size0_1,
      first_divisor_1 = first_most_1 == 0.0f ? 1.0f : first_most_1,
      first_part0_1 = left_2 / first_divisor_1, first_part1_1 = left_1 / first_divisor_1,
      first_divisor2_1 = KSL_MULF(first_divisor_1, KSL_MULF(first_part1_1, first_part1_1)
          + KSL_MULF(first_part0_1, first_part0_1)),
      first_more_1 = (KSL_MULF(first_part1_1, left_lo_2) - KSL_MULF(first_part0_1, left_lo_1))
          / (first_most_1 == 0.0f ? 1.0f : first_divisor2_1),
      first_lo = ksl_atan2_errorf(left_2, left_1, first) + first_more_1,
      first_padded_1 = 3.3087225e-24f
          + (KSL_MULF(left_1a_padded_1, fabsf(R->m20)) + KSL_MULF(left_1b_padded_1, fabsf(R->m21))),
      first_padded_2 = 3.3087225e-24f
          + (KSL_MULF(left_1a_padded_1, fabsf(R->m10)) + KSL_MULF(left_1b_padded_1, fabsf(R->m11))),
      first_size_2 = fabsf(left_2), first_size_3 = fabsf(left_1),
      first_size_5 = first_size_2 < first_size_3 ? first_size_3 : first_size_2,
      first_bound_1 = fabsf(left_lo_2) + KSL_MULF(3.2294905e-12f, first_padded_1),
      first_bound_2 = fabsf(left_lo_1) + KSL_MULF(3.2294905e-12f, first_padded_2),
      first_size_11 = (first_bound_2 + (3.3087225e-24f + first_bound_1)) / first_size_5,
      first_size_13 = KSL_MULF(first_size_11, first_size_11), first_size_14 = fabsf(first_lo),
      first_size_15 = 7.0f + first_size_14,
      first_size_18 = first_bound_2 < left_1 ? first_size_13 : first_size_15,
      first_size_19 = first_bound_1 < first_size_2 ? first_size_13 : first_size_18,
      first_size_21 = KSL_MULF(1.5707134e+11f, first_size_11 < 0.25f ? first_size_19
          : first_size_15),
      first_size_22 = fabsf(first) + (first_padded_1 + first_padded_2) / first_size_5
          + first_size_21;
  const float angles_0 = rest < 1.2676506e+30f ? first : rest,
      angles_bound_1 = fabsf(rest_lo) + KSL_MULF(2.2026954e-13f, 3.3087225e-24f + rest_size_3),
      angles_size_8 = angles_bound_1
          + (KSL_MULF(6.565516e-12f, 3.3087225e-24f + first_size_22) + first_size_14
          + fabsf(first - rest)),
      angles_size_10 = KSL_MULF(1.570713e+11f, angles_bound_1 < fabsf(rest - 1.2676506e+30f) ? 0.0f
          : angles_size_8);
  const float angles_1 = ksl_atan2f(R->m02, n), angles_size0_1 = fabsf(R->m02),
      angles_size1_1 = fabsf(n),
      angles_most_1 = angles_size0_1 < angles_size1_1 ? angles_size1_1 : angles_size0_1,
      angles_divisor_1 = angles_most_1 == 0.0f ? 1.0f : angles_most_1,
      angles_part0_1 = R->m02 / angles_divisor_1, angles_part1_1 = n / angles_divisor_1,
      angles_divisor2_1 = KSL_MULF(angles_divisor_1, KSL_MULF(angles_part1_1, angles_part1_1)
          + KSL_MULF(angles_part0_1, angles_part0_1)),
      angles_more_1 = (KSL_MULF(angles_part1_1, 0.0f) - KSL_MULF(angles_part0_1, n_lo))
          / (angles_most_1 == 0.0f ? 1.0f : angles_divisor2_1), angles_size_13 = fabsf(R->m02),
      angles_size_14 = fabsf(n),
      angles_size_16 = angles_size_13 < angles_size_14 ? angles_size_14 : angles_size_13,
      angles_size_21 = (3.3087225e-24f + divisor_bound_1) / angles_size_16,
      angles_size_23 = KSL_MULF(angles_size_21, angles_size_21),
      angles_size_24 = fabsf(ksl_atan2_errorf(R->m02, n, angles_1) + angles_more_1),
      angles_size_25 = 7.0f + angles_size_24,
      angles_size_20 = fabsf(angles_1) + (3.3087225e-24f + angles_size_13 + divisor_padded_1)
          / angles_size_16;
  const float angles_rest_3 = KSL_MULF(6.5655177e-12f, 3.3087225e-24f
          + ((rest < 1.2676506e+30f ? first_size_22 : rest_size_3) + angles_size_10)),
      angles_padded_5 = 3.3087225e-24f
          + (angles_size_20
          + KSL_MULF(2.7487632e+11f, angles_size_21 < 0.25f ? angles_size_23 : angles_size_25));
  const float third_size_7 = (n == 0.0f ? 0.0f : polar_size_1)
          + KSL_MULF(5.497548e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : third_size_4);
  const float R_n_0 = KSL_MULF(R->m11, R->m22) - KSL_MULF(R->m12, R->m21),
      R_n_1 = KSL_MULF(R->m02, R->m21) - KSL_MULF(R->m01, R->m22),
      R_n_2 = KSL_MULF(R->m01, R->m12) - KSL_MULF(R->m02, R->m11);
  const float R_det = KSL_MULF(R->m00, R_n_0) + KSL_MULF(R->m10, R_n_1) + KSL_MULF(R->m20, R_n_2);
  const float R_g_0 = KSL_MULF(R->m00, R->m00) + KSL_MULF(R->m10, R->m10)
          + KSL_MULF(R->m20, R->m20),
      R_g_1 = KSL_MULF(R->m00, R->m01) + KSL_MULF(R->m10, R->m11) + KSL_MULF(R->m20, R->m21),
      R_g_2 = KSL_MULF(R->m00, R->m02) + KSL_MULF(R->m10, R->m12) + KSL_MULF(R->m20, R->m22),
      R_g_3 = KSL_MULF(R->m01, R->m01) + KSL_MULF(R->m11, R->m11) + KSL_MULF(R->m21, R->m21),
      R_g_4 = KSL_MULF(R->m01, R->m02) + KSL_MULF(R->m11, R->m12) + KSL_MULF(R->m21, R->m22),
      R_g_5 = KSL_MULF(R->m02, R->m02) + KSL_MULF(R->m12, R->m12) + KSL_MULF(R->m22, R->m22);
  const float R_off_0 = R_det - 1.0f, R_off_1 = R_g_0 - 1.0f, R_off_4 = R_g_3 - 1.0f,
      R_off_6 = R_g_5 - 1.0f;
  const float R_defect_size_0 = fabsf(R_off_0), R_defect_size_1 = fabsf(R_off_1),
      R_defect_size_2 = fabsf(R_g_1), R_defect_size_3 = fabsf(R_g_2),
      R_defect_size_4 = fabsf(R_off_4), R_defect_size_5 = fabsf(R_g_4),
      R_defect_size_6 = fabsf(R_off_6);
  const float R_defect_largest1 = R_defect_size_0 < R_defect_size_1 ? R_defect_size_1
          : R_defect_size_0;
  const float R_defect_largest2 = R_defect_largest1 < R_defect_size_2 ? R_defect_size_2
          : R_defect_largest1;
  const float R_defect_largest3 = R_defect_largest2 < R_defect_size_3 ? R_defect_size_3
          : R_defect_largest2;
  const float R_defect_largest4 = R_defect_largest3 < R_defect_size_4 ? R_defect_size_4
          : R_defect_largest3;
  const float R_defect_largest5 = R_defect_largest4 < R_defect_size_5 ? R_defect_size_5
          : R_defect_largest4;
  const float R_defect_largest6 = R_defect_largest5 < R_defect_size_6 ? R_defect_size_6
          : R_defect_largest5;
  const float R_unless_equal = R_defect_largest6 == 0.001f ? 0.0f : 1.2676506e+30f;
  const float R_unless_rotation = R_defect_largest6 < 0.001f ? 0.0f : R_unless_equal;
  const float R_excess = KSL_MULF(R_unless_rotation, 1.2676506e+30f),
      R_excess_0 = fabsf(rest < 1.2676506e+30f ? first_lo : rest_lo) + angles_rest_3 + R_excess,
      R_excess_1 = KSL_MULF(3.751704e-12f, angles_padded_5) + angles_size_24 + R_excess,
      R_excess_2 = fabsf(n == 0.0f ? 0.0f : polar_own_error_1)
          + KSL_MULF(1.8758445e-12f, 3.3087225e-24f + third_size_7) + R_excess;
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
  angles_bound->x = R_excess_0;
  angles_bound->y = R_excess_1;
  angles_bound->z = R_excess_2;
}

/* R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.
   angles: vector; R, R_bound: rotation or other 3×3 matrix.
   237 mul, 347 add, 30 product error, 8 product rest, 3 div, 5 neg, 18 abs, 3 less, 3 select. */
static inline void ksl_mat3x3f_from_euler_xyx_certified(const ksl_vec3f_t *angles,
    ksl_mat3x3f_t *R, ksl_mat3x3f_t *R_bound) {
  float c_0; const float s_0 = ksl_sincosf(angles->x, &c_0);
  float c_own_error_1; const float s_own_error_1 = ksl_sincos_errorf(angles->x, s_0, c_0,
      &c_own_error_1);
  float c_1; const float s_1 = ksl_sincosf(angles->y, &c_1);
  float c_own_error_2; const float s_own_error_2 = ksl_sincos_errorf(angles->y, s_1, c_1,
      &c_own_error_2);
  float c_2; const float s_2 = ksl_sincosf(angles->z, &c_2);
  float c_own_error_3; const float s_own_error_3 = ksl_sincos_errorf(angles->z, s_2, c_2,
      &c_own_error_3);
  const float first_1 = KSL_MULF(s_1, s_2), first_2 = KSL_MULF(s_1, c_2),
      first_7 = KSL_MULF(s_2, c_1), first_8 = KSL_MULF(c_1, c_2);
  const float last_3 = KSL_MULF(s_0, s_1);
  const float last_4a = KSL_MULF(c_0, c_2),
      first_lo_1 = ksl_product_errorf(s_2, c_1, first_7)
          + (KSL_MULF(s_own_error_3, c_1) + KSL_MULF(s_2, c_own_error_2)),
      last_4b = KSL_MULF(s_0, first_7), last_4 = last_4a - last_4b, last_right_1 = last_4a - last_4,
      last_cross_2 = KSL_MULF(c_own_error_1, c_2) + KSL_MULF(c_0, c_own_error_3)
          - (KSL_MULF(s_own_error_1, first_7) + KSL_MULF(s_0, first_lo_1));
  const float first_lo_2 = ksl_product_errorf(c_1, c_2, first_8)
          + (KSL_MULF(c_own_error_2, c_2) + KSL_MULF(c_1, c_own_error_3)),
      last_5a = KSL_MULF(s_0, first_8), last_5b = KSL_MULF(s_2, c_0), last_5c = last_5a + last_5b,
      last_5c_right_1 = last_5c - last_5a,
      last_5c_cross_1 = KSL_MULF(s_own_error_1, first_8) + KSL_MULF(s_0, first_lo_2)
          + (KSL_MULF(s_own_error_3, c_0) + KSL_MULF(s_2, c_own_error_1)),
      last_5c_lo1_1 = ksl_product_restf(s_0, first_8, last_5a, last_5c - last_5c_right_1)
          + ksl_product_restf(s_2, c_0, last_5b, last_5c_right_1), last_5 = -last_5c;
  const float last_6 = -KSL_MULF(s_1, c_0);
  const float last_7a = KSL_MULF(s_0, c_2), last_7b = KSL_MULF(c_0, first_7),
      last_7 = last_7a + last_7b, last_right_2 = last_7 - last_7a,
      last_cross_4 = KSL_MULF(s_own_error_1, c_2) + KSL_MULF(s_0, c_own_error_3)
          + (KSL_MULF(c_own_error_1, first_7) + KSL_MULF(c_0, first_lo_1));
  const float last_8a = KSL_MULF(c_0, first_8), last_8b = KSL_MULF(s_0, s_2),
      last_8 = last_8a - last_8b, last_right_3 = last_8a - last_8,
      last_cross_5 = KSL_MULF(c_own_error_1, first_8) + KSL_MULF(c_0, first_lo_2)
          - (KSL_MULF(s_own_error_1, s_2) + KSL_MULF(s_0, s_own_error_3));
  const float last_lo_1 = ksl_product_restf(c_0, c_2, last_4a, last_4 + last_right_1)
          - ksl_product_restf(s_0, first_7, last_4b, last_right_1) + last_cross_2;
  const float last_lo_3 = ksl_product_restf(s_0, c_2, last_7a, last_7 - last_right_2)
          + ksl_product_restf(c_0, first_7, last_7b, last_right_2) + last_cross_4;
  const float last_lo_4 = ksl_product_restf(c_0, first_8, last_8a, last_8 + last_right_3)
          - ksl_product_restf(s_0, s_2, last_8b, last_right_3) + last_cross_5;
  const float c_bound_1 = 1.0800312e-12f + fabsf(c_own_error_2),
      first_bound_1 = 2.252443e-12f
          + fabsf(ksl_product_errorf(s_1, s_2, first_1)
          + (KSL_MULF(s_own_error_2, s_2) + KSL_MULF(s_1, s_own_error_3))),
      first_bound_2 = 2.252443e-12f
          + fabsf(ksl_product_errorf(s_1, c_2, first_2)
          + (KSL_MULF(s_own_error_2, c_2) + KSL_MULF(s_1, c_own_error_3))),
      last_bound_1 = 2.252443e-12f
          + fabsf(ksl_product_errorf(s_0, s_1, last_3)
          + (KSL_MULF(s_own_error_1, s_1) + KSL_MULF(s_0, s_own_error_2))),
      last_bound_2 = 7.7379336e-12f + fabsf(last_lo_1),
      last_bound_3 = 7.7379336e-12f + fabsf(-(last_5c_lo1_1 + last_5c_cross_1)),
      last_bound_4 = 2.252443e-12f
          + fabsf(ksl_product_errorf(-s_1, c_0, last_6) +
          -(KSL_MULF(s_own_error_2, c_0) + KSL_MULF(s_1, c_own_error_1))),
      last_bound_5 = 7.7379336e-12f + fabsf(last_lo_3),
      last_bound_6 = 7.7379336e-12f + fabsf(last_lo_4);
  R->m00 = c_1;
  R->m01 = first_1;
  R->m02 = first_2;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
  R_bound->m00 = c_bound_1;
  R_bound->m01 = first_bound_1;
  R_bound->m02 = first_bound_2;
  R_bound->m10 = last_bound_1;
  R_bound->m11 = last_bound_2;
  R_bound->m12 = last_bound_3;
  R_bound->m20 = last_bound_4;
  R_bound->m21 = last_bound_5;
  R_bound->m22 = last_bound_6;
}

/* angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in [0,
     π]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; angles, angles_bound: vector.
   353 mul, 588 add, 45 product error, 6 product rest, 27 div, 2 sqrt, 3 neg, 72 abs, 12
     copysign, 61 less, 14 equal, 110 select. */
static inline void ksl_euler_xyx_from_mat3x3f_certified(const ksl_mat3x3f_t *R,
    ksl_vec3f_t *angles, ksl_vec3f_t *angles_bound) {
  const float n_a = KSL_MULF(R->m01, R->m01), n_a_size_1 = fabsf(R->m01),
      n_b = KSL_MULF(R->m02, R->m02), n_b_size_1 = fabsf(R->m02), n_c = n_a + n_b,
      n_c_right_1 = n_c - n_a,
      n_c_lo = ksl_product_restf(R->m01, R->m01, n_a, n_c - n_c_right_1)
          + ksl_product_restf(R->m02, R->m02, n_b, n_c_right_1), n = sqrtf(n_c),
      n_product_1 = KSL_MULF(n, n), n_twice_1 = n + n,
      n_lo = (n_c - n_product_1 - ksl_product_errorf(n, n, n_product_1) + n_c_lo)
          / (n == 0.0f ? 1.0f : n_twice_1),
      n_padded_1 = 3.3087225e-24f
          + (KSL_MULF(n_a_size_1, n_a_size_1) + KSL_MULF(n_b_size_1, n_b_size_1)),
      n_bound_1 = fabsf(n_c_lo) + KSL_MULF(2.7711354e-13f, n_padded_1),
      n_size_4 = KSL_MULF(fabsf(n_c) + KSL_MULF(262144.0f, n_bound_1), n_padded_1 / n / n_c),
      n_size_6 = fabsf(n_lo), n_size_8 = KSL_MULF(1.7058937e+12f, sqrtf(n_bound_1) + n_size_6),
      n_size_12 = n + (KSL_MULF(4.0f, n_bound_1) < n_c ? n_size_4 : n_size_8);
  const float divisor = n == 0.0f ? 1.0f : n, divisor_lo = n == 0.0f ? 0.0f : n_lo,
      divisor_padded_1 = 3.3087225e-24f + n_size_12,
      divisor_bound_1 = KSL_MULF(6.430494e-13f, divisor_padded_1) + n_size_6,
      divisor_size_3 = fabsf(n - 0.0f), divisor_size_7 = divisor_bound_1 + fabsf(1.0f - n);
  const float cosine_a = R->m02 / divisor, cosine_a_product_1 = KSL_MULF(cosine_a, divisor),
      cosine_a_lo = (R->m02 - cosine_a_product_1
          - ksl_product_errorf(cosine_a, divisor, cosine_a_product_1)
          - KSL_MULF(cosine_a, divisor_lo)) / divisor;
  const float divisor_size_10 = (n == 0.0f ? 1.0f : n_size_12)
          + KSL_MULF(5.4975264e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : divisor_size_7);
  const float cosine_a_padded_2 = 3.3087225e-24f + divisor_size_10,
      cosine_a_size_1 = fabsf(cosine_a), cosine_a_size_2 = fabsf(divisor),
      cosine_a_bound_1 = fabsf(divisor_lo) + KSL_MULF(1.875852e-12f, cosine_a_padded_2),
      cosine_a_size_7 = KSL_MULF(4.0f, cosine_a_bound_1) < cosine_a_size_2 ? cosine_a_size_2 : 0.0f,
      cosine_a_reach_1 = cosine_a_size_2 + KSL_MULF(262144.0f, cosine_a_bound_1),
      cosine_a_size_9 = KSL_MULF(cosine_a_reach_1, (3.3087225e-24f + n_b_size_1
          + KSL_MULF(cosine_a_padded_2, cosine_a_size_1)) / cosine_a_size_7),
      cosine_a_size_11 = cosine_a_size_1 + cosine_a_size_9 / cosine_a_size_2,
      cosine = n == 0.0f ? 1.0f : cosine_a, cosine_lo = n == 0.0f ? 0.0f : cosine_a_lo,
      cosine_size_4 = fabsf(cosine_a_lo)
          + KSL_MULF(2.8564286e-12f, 3.3087225e-24f + cosine_a_size_11) + fabsf(1.0f - cosine_a);
  const float sine = R->m01 / divisor, sine_product_1 = KSL_MULF(sine, divisor),
      sine_lo = (R->m01 - sine_product_1 - ksl_product_errorf(sine, divisor, sine_product_1)
          - KSL_MULF(sine, divisor_lo)) / divisor, sine_size_1 = fabsf(sine),
      sine_size_6 = KSL_MULF(cosine_a_reach_1, (3.3087225e-24f + n_a_size_1
          + KSL_MULF(cosine_a_padded_2, sine_size_1)) / cosine_a_size_7) / cosine_a_size_2;
  const float polar = ksl_atan2f(R->m01, R->m02),
      polar_own_error_1 = ksl_atan2_errorf(R->m01, R->m02, polar), polar_size_1 = fabsf(polar);
  const float third = n == 0.0f ? 0.0f : polar,
      third_size_4 = fabsf(polar_own_error_1)
          + KSL_MULF(1.0800314e-12f, 3.3087225e-24f + polar_size_1) + fabsf(0.0f - polar);
  const float left_1a = KSL_MULF(R->m11, cosine);
  const float cosine_size_7 = (n == 0.0f ? 1.0f : cosine_a_size_11)
          + KSL_MULF(3.6086084e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : cosine_size_4);
  const float left_1a_padded_1 = 3.3087225e-24f + cosine_size_7, left_1b = KSL_MULF(R->m12, sine),
      left_1b_padded_1 = 3.3087225e-24f + (sine_size_1 + sine_size_6), left_1 = left_1a - left_1b,
      left_right_1 = left_1a - left_1,
      left_lo1_1 = ksl_product_restf(R->m11, cosine, left_1a, left_1 + left_right_1)
          - ksl_product_restf(R->m12, sine, left_1b, left_right_1),
      left_lo_1 = left_lo1_1 + (KSL_MULF(R->m11, cosine_lo) - KSL_MULF(R->m12, sine_lo));
  const float left_2a = KSL_MULF(R->m21, cosine), left_2b = KSL_MULF(R->m22, sine),
      left_2 = left_2a - left_2b, left_right_2 = left_2a - left_2,
      left_lo1_2 = ksl_product_restf(R->m21, cosine, left_2a, left_2 + left_right_2)
          - ksl_product_restf(R->m22, sine, left_2b, left_right_2),
      left_lo_2 = left_lo1_2 + (KSL_MULF(R->m21, cosine_lo) - KSL_MULF(R->m22, sine_lo));
  const float rest = R->m10 + R->m20, rest_right_1 = rest - R->m10,
      rest_lo = R->m10 - (rest - rest_right_1) + (R->m20 - rest_right_1),
      rest_size_3 = fabsf(R->m10) + fabsf(R->m20);
  const float first = ksl_atan2f(left_2, left_1), first_size0_1 = fabsf(left_2),
      first_size1_1 = fabsf(left_1),
      first_most_1 = first_size0_1 < first_size1_1 ? first_size1_1 : first_size0_1,
      first_divisor_1 = first_most_1 == 0.0f ? 1.0f : first_most_1,
      first_part0_1 = left_2 / first_divisor_1, first_part1_1 = left_1 / first_divisor_1,
      first_divisor2_1 = KSL_MULF(first_divisor_1, KSL_MULF(first_part1_1, first_part1_1)
          + KSL_MULF(first_part0_1, first_part0_1)),
      first_more_1 = (KSL_MULF(first_part1_1, left_lo_2) - KSL_MULF(first_part0_1, left_lo_1))
          / (first_most_1 == 0.0f ? 1.0f : first_divisor2_1),
      first_lo = ksl_atan2_errorf(left_2, left_1, first) + first_more_1,
      first_padded_1 = 3.3087225e-24f
          + (KSL_MULF(left_1a_padded_1, fabsf(R->m21)) + KSL_MULF(left_1b_padded_1, fabsf(R->m22))),
      first_padded_2 = 3.3087225e-24f
          + (KSL_MULF(left_1a_padded_1, fabsf(R->m11)) + KSL_MULF(left_1b_padded_1, fabsf(R->m12))),
      first_size_2 = fabsf(left_2), first_size_3 = fabsf(left_1),
      first_size_5 = first_size_2 < first_size_3 ? first_size_3 : first_size_2,
      first_bound_1 = fabsf(left_lo_2) + KSL_MULF(3.2294905e-12f, first_padded_1),
      first_bound_2 = fabsf(left_lo_1) + KSL_MULF(3.2294905e-12f, first_padded_2),
      first_size_11 = (first_bound_2 + (3.3087225e-24f + first_bound_1)) / first_size_5,
      first_size_13 = KSL_MULF(first_size_11, first_size_11), first_size_14 = fabsf(first_lo),
      first_size_15 = 7.0f + first_size_14,
      first_size_18 = first_bound_2 < left_1 ? first_size_13 : first_size_15,
      first_size_19 = first_bound_1 < first_size_2 ? first_size_13 : first_size_18,
      first_size_21 = KSL_MULF(1.5707134e+11f, first_size_11 < 0.25f ? first_size_19
          : first_size_15),
      first_size_22 = fabsf(first) + (first_padded_1 + first_padded_2) / first_size_5
          + first_size_21;
  const float angles_0 = rest < 1.2676506e+30f ? first : rest,
      angles_bound_1 = fabsf(rest_lo) + KSL_MULF(2.2026954e-13f, 3.3087225e-24f + rest_size_3),
      angles_size_8 = angles_bound_1
          + (KSL_MULF(6.565516e-12f, 3.3087225e-24f + first_size_22) + first_size_14
          + fabsf(first - rest)),
      angles_size_10 = KSL_MULF(1.570713e+11f, angles_bound_1 < fabsf(rest - 1.2676506e+30f) ? 0.0f
          : angles_size_8);
  const float angles_1 = ksl_atan2f(n, R->m00), angles_size0_1 = fabsf(n),
      angles_size1_1 = fabsf(R->m00),
      angles_most_1 = angles_size0_1 < angles_size1_1 ? angles_size1_1 : angles_size0_1,
      angles_divisor_1 = angles_most_1 == 0.0f ? 1.0f : angles_most_1,
      angles_part0_1 = n / angles_divisor_1, angles_part1_1 = R->m00 / angles_divisor_1,
      angles_divisor2_1 = KSL_MULF(angles_divisor_1, KSL_MULF(angles_part1_1, angles_part1_1)
          + KSL_MULF(angles_part0_1, angles_part0_1)),
      angles_more_1 = (KSL_MULF(angles_part1_1, n_lo) - KSL_MULF(angles_part0_1, 0.0f))
          / (angles_most_1 == 0.0f ? 1.0f : angles_divisor2_1), angles_size_13 = fabsf(R->m00),
      angles_size_14 = fabsf(n),
      angles_size_16 = angles_size_14 < angles_size_13 ? angles_size_13 : angles_size_14,
      angles_size_21 = (3.3087225e-24f + divisor_bound_1) / angles_size_16,
      angles_size_23 = KSL_MULF(angles_size_21, angles_size_21),
      angles_size_24 = fabsf(ksl_atan2_errorf(n, R->m00, angles_1) + angles_more_1),
      angles_size_25 = 7.0f + angles_size_24,
      angles_size_28 = 0.0f < R->m00 ? angles_size_23 : angles_size_25,
      angles_size_29 = divisor_bound_1 < angles_size_14 ? angles_size_23 : angles_size_28,
      angles_size_20 = fabsf(angles_1) + (3.3087225e-24f + angles_size_13 + divisor_padded_1)
          / angles_size_16;
  const float angles_rest_3 = KSL_MULF(6.5655177e-12f, 3.3087225e-24f
          + ((rest < 1.2676506e+30f ? first_size_22 : rest_size_3) + angles_size_10)),
      angles_padded_5 = 3.3087225e-24f
          + (angles_size_20
          + KSL_MULF(2.7487632e+11f, angles_size_21 < 0.25f ? angles_size_29 : angles_size_25));
  const float third_size_7 = (n == 0.0f ? 0.0f : polar_size_1)
          + KSL_MULF(5.497548e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : third_size_4);
  const float R_n_0 = KSL_MULF(R->m11, R->m22) - KSL_MULF(R->m12, R->m21),
      R_n_1 = KSL_MULF(R->m02, R->m21) - KSL_MULF(R->m01, R->m22),
      R_n_2 = KSL_MULF(R->m01, R->m12) - KSL_MULF(R->m02, R->m11);
  const float R_det = KSL_MULF(R->m00, R_n_0) + KSL_MULF(R->m10, R_n_1) + KSL_MULF(R->m20, R_n_2);
  const float R_g_0 = KSL_MULF(R->m00, R->m00) + KSL_MULF(R->m10, R->m10)
          + KSL_MULF(R->m20, R->m20),
      R_g_1 = KSL_MULF(R->m00, R->m01) + KSL_MULF(R->m10, R->m11) + KSL_MULF(R->m20, R->m21),
      R_g_2 = KSL_MULF(R->m00, R->m02) + KSL_MULF(R->m10, R->m12) + KSL_MULF(R->m20, R->m22),
      R_g_3 = KSL_MULF(R->m01, R->m01) + KSL_MULF(R->m11, R->m11) + KSL_MULF(R->m21, R->m21),
      R_g_4 = KSL_MULF(R->m01, R->m02) + KSL_MULF(R->m11, R->m12) + KSL_MULF(R->m21, R->m22),
      R_g_5 = KSL_MULF(R->m02, R->m02) + KSL_MULF(R->m12, R->m12) + KSL_MULF(R->m22, R->m22);
  const float R_off_0 = R_det - 1.0f, R_off_1 = R_g_0 - 1.0f, R_off_4 = R_g_3 - 1.0f,
      R_off_6 = R_g_5 - 1.0f;
  const float R_defect_size_0 = fabsf(R_off_0), R_defect_size_1 = fabsf(R_off_1),
      R_defect_size_2 = fabsf(R_g_1), R_defect_size_3 = fabsf(R_g_2),
      R_defect_size_4 = fabsf(R_off_4), R_defect_size_5 = fabsf(R_g_4),
      R_defect_size_6 = fabsf(R_off_6);
  const float R_defect_largest1 = R_defect_size_0 < R_defect_size_1 ? R_defect_size_1
          : R_defect_size_0;
  const float R_defect_largest2 = R_defect_largest1 < R_defect_size_2 ? R_defect_size_2
          : R_defect_largest1;
  const float R_defect_largest3 = R_defect_largest2 < R_defect_size_3 ? R_defect_size_3
          : R_defect_largest2;
  const float R_defect_largest4 = R_defect_largest3 < R_defect_size_4 ? R_defect_size_4
          : R_defect_largest3;
  const float R_defect_largest5 = R_defect_largest4 < R_defect_size_5 ? R_defect_size_5
          : R_defect_largest4;
  const float R_defect_largest6 = R_defect_largest5 < R_defect_size_6 ? R_defect_size_6
          : R_defect_largest5;
  const float R_unless_equal = R_defect_largest6 == 0.001f ? 0.0f : 1.2676506e+30f;
  const float R_unless_rotation = R_defect_largest6 < 0.001f ? 0.0f : R_unless_equal;
  const float R_excess = KSL_MULF(R_unless_rotation, 1.2676506e+30f),
      R_excess_0 = fabsf(rest < 1.2676506e+30f ? first_lo : rest_lo) + angles_rest_3 + R_excess,
      R_excess_1 = KSL_MULF(3.751704e-12f, angles_padded_5) + angles_size_24 + R_excess,
      R_excess_2 = fabsf(n == 0.0f ? 0.0f : polar_own_error_1)
          + KSL_MULF(1.8758445e-12f, 3.3087225e-24f + third_size_7) + R_excess;
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
  angles_bound->x = R_excess_0;
  angles_bound->y = R_excess_1;
  angles_bound->z = R_excess_2;
}

/* R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
     not a rotation; |error of R| <= R_bound unless inf or NaN.
   axis: vector; angle: number; R, R_bound: rotation or other 3×3 matrix.
   180 mul, 322 add, 20 product error, 18 product rest, 2 div, 24 abs, 4 less, 6 select. */
static inline void ksl_mat3x3f_from_axis_angle_certified(const ksl_vec3f_t *axis,
    const float angle, ksl_mat3x3f_t *R, ksl_mat3x3f_t *R_bound) {
  const float half = KSL_MULF(0.5f, angle);
  const float h = ksl_sinf(half), h_own_error_1 = ksl_sin_errorf(half, h),
      h_size_1 = 1.0f + (3.3087225e-24f + KSL_MULF(0.5f, fabsf(angle)));
  float cosine; const float sine = ksl_sincosf(angle, &cosine);
  float cosine_own_error_1; const float sine_own_error_1 = ksl_sincos_errorf(angle, sine, cosine,
      &cosine_own_error_1);
  const float versine_a = KSL_MULF(h, h), versine_b = KSL_MULF(2.0f, versine_a),
      versine_b_cross2_1 = KSL_MULF(2.0f, ksl_product_errorf(h, h, versine_a)
          + (KSL_MULF(h_own_error_1, h) + KSL_MULF(h, h_own_error_1))),
      versine_b_size_1 = KSL_MULF(2.0f, KSL_MULF(h_size_1, h_size_1)), versine_c = 1.0f - cosine,
      versine_c_right_1 = 1.0f - versine_c,
      versine_c_lo = 1.0f - (versine_c + versine_c_right_1) - (cosine - versine_c_right_1)
          - cosine_own_error_1, versine = cosine < 0.0f ? versine_c : versine_b,
      versine_lo = cosine < 0.0f ? versine_c_lo : versine_b_cross2_1,
      versine_bound_3 = fabsf(versine_b_cross2_1)
          + KSL_MULF(2.5864118e-12f, 3.3087225e-24f + versine_b_size_1),
      versine_size_8 = versine_bound_3
          + (2.6858765e-12f + fabsf(versine_c_lo) + fabsf(versine_c - versine_b)),
      versine_size_10 = KSL_MULF(1.3743768e+11f, 1.0800312e-12f + fabsf(cosine_own_error_1)
          < fabsf(cosine - 0.0f) ? 0.0f : versine_size_8);
  const float beta_v_0 = KSL_MULF(axis->x, versine), beta_v_size_1 = fabsf(axis->x),
      beta_v_padded_1 = 3.3087225e-24f
          + ((cosine < 0.0f ? 2.0f : versine_b_size_1) + versine_size_10);
  const float beta_v_1 = KSL_MULF(axis->y, versine), beta_v_size_3 = fabsf(axis->y);
  const float beta_v_2 = KSL_MULF(axis->z, versine), beta_v_size_5 = fabsf(axis->z);
  const float beta_v_lo_1 = ksl_product_errorf(axis->x, versine, beta_v_0)
          + KSL_MULF(axis->x, versine_lo), m_0 = KSL_MULF(axis->x, beta_v_0),
      m_cross2_1 = KSL_MULF(axis->x, beta_v_lo_1),
      m_padded_1 = 3.3087225e-24f + KSL_MULF(beta_v_padded_1, beta_v_size_1),
      m_size_1 = KSL_MULF(beta_v_size_1, m_padded_1);
  const float beta_v_lo_2 = ksl_product_errorf(axis->y, versine, beta_v_1)
          + KSL_MULF(axis->y, versine_lo), m_1 = KSL_MULF(axis->y, beta_v_1),
      m_cross2_2 = KSL_MULF(axis->y, beta_v_lo_2),
      m_padded_2 = 3.3087225e-24f + KSL_MULF(beta_v_padded_1, beta_v_size_3),
      m_size_2 = KSL_MULF(beta_v_size_3, m_padded_2);
  const float m_2 = KSL_MULF(axis->z, beta_v_2),
      m_cross2_3 = KSL_MULF(axis->z, ksl_product_errorf(axis->z, versine, beta_v_2)
          + KSL_MULF(axis->z, versine_lo)),
      m_size_3 = KSL_MULF(beta_v_size_5, 3.3087225e-24f + KSL_MULF(beta_v_padded_1, beta_v_size_5));
  const float m_3 = KSL_MULF(axis->y, beta_v_0), m_cross2_4 = KSL_MULF(axis->y, beta_v_lo_1);
  const float m_4 = KSL_MULF(axis->z, beta_v_0), m_cross2_5 = KSL_MULF(axis->z, beta_v_lo_1);
  const float m_5 = KSL_MULF(axis->z, beta_v_1), m_cross2_6 = KSL_MULF(axis->z, beta_v_lo_2);
  const float others_0 = m_1 + m_2, others_right_1 = others_0 - m_1,
      others_lo1_1 = ksl_product_restf(axis->y, beta_v_1, m_1, others_0 - others_right_1)
          + ksl_product_restf(axis->z, beta_v_2, m_2, others_right_1);
  const float others_1 = m_0 + m_2, others_right_2 = others_1 - m_0,
      others_lo1_2 = ksl_product_restf(axis->x, beta_v_0, m_0, others_1 - others_right_2)
          + ksl_product_restf(axis->z, beta_v_2, m_2, others_right_2);
  const float others_2 = m_0 + m_1, others_right_3 = others_2 - m_0,
      others_lo1_3 = ksl_product_restf(axis->x, beta_v_0, m_0, others_2 - others_right_3)
          + ksl_product_restf(axis->y, beta_v_1, m_1, others_right_3);
  const float alpha_v_0 = KSL_MULF(axis->x, sine),
      alpha_v_cross2_1 = KSL_MULF(axis->x, sine_own_error_1);
  const float alpha_v_1 = KSL_MULF(axis->y, sine),
      alpha_v_cross2_2 = KSL_MULF(axis->y, sine_own_error_1);
  const float alpha_v_2 = KSL_MULF(axis->z, sine),
      alpha_v_cross2_3 = KSL_MULF(axis->z, sine_own_error_1);
  const float R_00 = 1.0f - others_0, R_right_1 = 1.0f - R_00;
  const float R_01 = m_3 - alpha_v_2, R_right_2 = m_3 - R_01,
      R_lo1_2 = ksl_product_restf(axis->y, beta_v_0, m_3, R_01 + R_right_2)
          - ksl_product_restf(axis->z, sine, alpha_v_2, R_right_2);
  const float R_02 = m_4 + alpha_v_1, R_right_3 = R_02 - m_4,
      R_lo1_3 = ksl_product_restf(axis->z, beta_v_0, m_4, R_02 - R_right_3)
          + ksl_product_restf(axis->y, sine, alpha_v_1, R_right_3);
  const float R_10 = m_3 + alpha_v_2, R_right_4 = R_10 - m_3,
      R_lo1_4 = ksl_product_restf(axis->y, beta_v_0, m_3, R_10 - R_right_4)
          + ksl_product_restf(axis->z, sine, alpha_v_2, R_right_4);
  const float R_11 = 1.0f - others_1, R_right_5 = 1.0f - R_11;
  const float R_12 = m_5 - alpha_v_0, R_right_6 = m_5 - R_12,
      R_lo1_6 = ksl_product_restf(axis->z, beta_v_1, m_5, R_12 + R_right_6)
          - ksl_product_restf(axis->x, sine, alpha_v_0, R_right_6);
  const float R_20 = m_4 - alpha_v_1, R_right_7 = m_4 - R_20,
      R_lo1_7 = ksl_product_restf(axis->z, beta_v_0, m_4, R_20 + R_right_7)
          - ksl_product_restf(axis->y, sine, alpha_v_1, R_right_7);
  const float R_21 = m_5 + alpha_v_0, R_right_8 = R_21 - m_5,
      R_lo1_8 = ksl_product_restf(axis->z, beta_v_1, m_5, R_21 - R_right_8)
          + ksl_product_restf(axis->x, sine, alpha_v_0, R_right_8);
  const float R_22 = 1.0f - others_2, R_right_9 = 1.0f - R_22;
  const float R_error_1 = fabsf(1.0f - (R_00 + R_right_1) - (others_0 - R_right_1)
          - (others_lo1_1 + (m_cross2_2 + m_cross2_3))),
      R_rest_2 = KSL_MULF(8.189208e-12f, 3.3087225e-24f
          + (beta_v_size_5 + KSL_MULF(beta_v_size_3, m_padded_1))),
      R_rest_3 = KSL_MULF(8.189208e-12f, 3.3087225e-24f
          + (beta_v_size_3 + KSL_MULF(beta_v_size_5, m_padded_1))),
      R_error_5 = fabsf(1.0f - (R_11 + R_right_5) - (others_1 - R_right_5)
          - (others_lo1_2 + (m_cross2_1 + m_cross2_3))),
      R_rest_5 = KSL_MULF(8.189208e-12f, 3.3087225e-24f
          + (beta_v_size_1 + KSL_MULF(beta_v_size_5, m_padded_2))),
      R_error_9 = fabsf(1.0f - (R_22 + R_right_9) - (others_2 - R_right_9)
          - (others_lo1_3 + (m_cross2_1 + m_cross2_2))),
      R_bound_1 = R_error_1
          + KSL_MULF(8.6439935e-12f, 3.3087225e-24f + (1.0f + (m_size_2 + m_size_3))),
      R_bound_2 = fabsf(R_lo1_2 + (m_cross2_4 - alpha_v_cross2_3)) + R_rest_2,
      R_bound_3 = fabsf(R_lo1_3 + (m_cross2_5 + alpha_v_cross2_2)) + R_rest_3,
      R_bound_4 = fabsf(R_lo1_4 + (m_cross2_4 + alpha_v_cross2_3)) + R_rest_2,
      R_bound_5 = R_error_5
          + KSL_MULF(8.6439935e-12f, 3.3087225e-24f + (1.0f + (m_size_1 + m_size_3))),
      R_bound_6 = fabsf(R_lo1_6 + (m_cross2_6 - alpha_v_cross2_1)) + R_rest_5,
      R_bound_7 = fabsf(R_lo1_7 + (m_cross2_5 - alpha_v_cross2_2)) + R_rest_3,
      R_bound_8 = fabsf(R_lo1_8 + (m_cross2_6 + alpha_v_cross2_1)) + R_rest_5,
      R_bound_9 = R_error_9
          + KSL_MULF(8.6439935e-12f, 3.3087225e-24f + (1.0f + (m_size_1 + m_size_2)));
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
  R_bound->m00 = R_bound_1;
  R_bound->m01 = R_bound_2;
  R_bound->m02 = R_bound_3;
  R_bound->m10 = R_bound_4;
  R_bound->m11 = R_bound_5;
  R_bound->m12 = R_bound_6;
  R_bound->m20 = R_bound_7;
  R_bound->m21 = R_bound_8;
  R_bound->m22 = R_bound_9;
}

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0;
     |error of angle| <= angle_bound, |error of axis| <= axis_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; axis, axis_bound: vector; angle_bound: number.
   199 mul, 408 add, 18 product error, 3 product rest, 24 div, 2 sqrt, 10 neg, 70 abs, 4
     copysign, 41 less, 7 equal, 111 select. */
static inline float ksl_axis_angle_from_mat3x3f_certified(const ksl_mat3x3f_t *R,
    ksl_vec3f_t *axis, float *angle_bound, ksl_vec3f_t *axis_bound) {
  const float p_0 = R->m21 - R->m12, p_right_1 = R->m21 - p_0,
      p_lo_1 = R->m21 - (p_0 + p_right_1) - (R->m12 - p_right_1),
      p_size_3 = fabsf(R->m21) + fabsf(R->m12);
  const float p_1 = R->m02 - R->m20, p_right_2 = R->m02 - p_1,
      p_lo_2 = R->m02 - (p_1 + p_right_2) - (R->m20 - p_right_2),
      p_size_6 = fabsf(R->m02) + fabsf(R->m20);
  const float p_2 = R->m10 - R->m01, p_right_3 = R->m10 - p_2,
      p_lo_3 = R->m10 - (p_2 + p_right_3) - (R->m01 - p_right_3),
      p_size_9 = fabsf(R->m10) + fabsf(R->m01);
  const float s_0 = R->m12 + R->m21, s_right_1 = s_0 - R->m12,
      s_lo_1 = R->m12 - (s_0 - s_right_1) + (R->m21 - s_right_1);
  const float s_1 = R->m02 + R->m20, s_right_2 = s_1 - R->m02,
      s_lo_2 = R->m02 - (s_1 - s_right_2) + (R->m20 - s_right_2);
  const float s_2 = R->m01 + R->m10, s_right_3 = s_2 - R->m01,
      s_lo_3 = R->m01 - (s_2 - s_right_3) + (R->m10 - s_right_3);
  const float first_0 = R->m00 + 1.0f, first_right_1 = first_0 - R->m00,
      first_lo_1 = R->m00 - (first_0 - first_right_1) + (1.0f - first_right_1);
  const float first_1 = 1.0f - R->m00, first_right_2 = 1.0f - first_1,
      first_lo_2 = 1.0f - (first_1 + first_right_2) - (R->m00 - first_right_2);
  const float others_0 = R->m11 + R->m22, others_right_1 = others_0 - R->m11,
      others_lo_1 = R->m11 - (others_0 - others_right_1) + (R->m22 - others_right_1);
  const float others_1 = R->m11 - R->m22, others_right_2 = R->m11 - others_1,
      others_lo_2 = R->m11 - (others_1 + others_right_2) - (R->m22 - others_right_2);
  const float d_0 = first_0 + others_0, d_right_1 = d_0 - first_0,
      d_lo_1 = first_0 - (d_0 - d_right_1) + (others_0 - d_right_1) + others_lo_1 + first_lo_1,
      d_size_1 = 1.0f + fabsf(R->m00) + (fabsf(R->m11) + fabsf(R->m22));
  const float d_1 = first_0 - others_0, d_right_2 = first_0 - d_1,
      d_lo_2 = first_0 - (d_1 + d_right_2) - (others_0 - d_right_2) - others_lo_1 + first_lo_1;
  const float d_2 = first_1 + others_1, d_right_3 = d_2 - first_1,
      d_lo_3 = first_1 - (d_2 - d_right_3) + (others_1 - d_right_3) + others_lo_2 + first_lo_2;
  const float d_3 = first_1 - others_1, d_right_4 = first_1 - d_3,
      d_lo_4 = first_1 - (d_3 + d_right_4) - (others_1 - d_right_4) - others_lo_2 + first_lo_2;
  const float low_0 = R->m11 < R->m00 ? d_1 : s_2, low_lo_1 = R->m11 < R->m00 ? d_lo_2 : s_lo_3,
      low_size_1 = R->m11 < R->m00 ? d_size_1 : p_size_9;
  const float low_1 = R->m11 < R->m00 ? s_2 : d_2, low_lo_2 = R->m11 < R->m00 ? s_lo_3 : d_lo_3,
      low_size_2 = R->m11 < R->m00 ? p_size_9 : d_size_1;
  const float low_2 = R->m11 < R->m00 ? s_1 : s_0, low_lo_3 = R->m11 < R->m00 ? s_lo_2 : s_lo_1,
      low_size_3 = R->m11 < R->m00 ? p_size_6 : p_size_3;
  const float low_3 = R->m11 < R->m00 ? p_0 : p_1, low_lo_4 = R->m11 < R->m00 ? p_lo_1 : p_lo_2,
      low_size_4 = R->m11 < R->m00 ? p_size_3 : p_size_6;
  const float high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0,
      high_lo_1 = R->m00 < high_0a ? s_lo_2 : p_lo_1,
      high_size_1 = R->m00 < high_0a ? p_size_6 : p_size_3;
  const float high_1 = R->m00 < high_0a ? s_0 : p_1, high_lo_2 = R->m00 < high_0a ? s_lo_1 : p_lo_2,
      high_size_2 = R->m00 < high_0a ? p_size_3 : p_size_6;
  const float high_2 = R->m00 < high_0a ? d_3 : p_2, high_lo_3 = R->m00 < high_0a ? d_lo_4 : p_lo_3,
      high_size_3 = R->m00 < high_0a ? d_size_1 : p_size_9;
  const float high_3 = R->m00 < high_0a ? p_2 : d_0, high_lo_4 = R->m00 < high_0a ? p_lo_3 : d_lo_1,
      high_size_4 = R->m00 < high_0a ? p_size_9 : d_size_1;
  const float column_0 = R->m22 < 0.0f ? low_0 : high_0,
      column_lo_1 = R->m22 < 0.0f ? low_lo_1 : high_lo_1,
      column_size_1 = R->m22 < 0.0f ? low_size_1 : high_size_1;
  const float column_1 = R->m22 < 0.0f ? low_1 : high_1,
      column_lo_2 = R->m22 < 0.0f ? low_lo_2 : high_lo_2,
      column_size_2 = R->m22 < 0.0f ? low_size_2 : high_size_2;
  const float column_2 = R->m22 < 0.0f ? low_2 : high_2,
      column_lo_3 = R->m22 < 0.0f ? low_lo_3 : high_lo_3,
      column_size_3 = R->m22 < 0.0f ? low_size_3 : high_size_3;
  const float column_3 = R->m22 < 0.0f ? low_3 : high_3,
      column_lo_4 = R->m22 < 0.0f ? low_lo_4 : high_lo_4,
      column_size_4 = R->m22 < 0.0f ? low_size_4 : high_size_4;
  const float upper_0a = -column_0, upper_0a_lo = -column_lo_1,
      upper_0 = column_3 < 0.0f ? upper_0a : column_0,
      upper_rest_1 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + column_size_4),
      upper_bound_1 = fabsf(column_lo_4) + upper_rest_1, upper_size_2 = fabsf(column_3 - 0.0f),
      upper_rest_2 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + column_size_1),
      upper_size_7 = fabsf(column_lo_1) + upper_rest_2
          + (fabsf(upper_0a_lo) + upper_rest_2 + fabsf(upper_0a - column_0));
  const float upper_1a = -column_1, upper_1a_lo = -column_lo_2,
      upper_1 = column_3 < 0.0f ? upper_1a : column_1,
      upper_rest_3 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + column_size_2),
      upper_size_14 = fabsf(column_lo_2) + upper_rest_3
          + (fabsf(upper_1a_lo) + upper_rest_3 + fabsf(upper_1a - column_1));
  const float upper_2a = -column_2, upper_2a_lo = -column_lo_3,
      upper_2 = column_3 < 0.0f ? upper_2a : column_2,
      upper_rest_4 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + column_size_3),
      upper_size_21 = fabsf(column_lo_3) + upper_rest_4
          + (fabsf(upper_2a_lo) + upper_rest_4 + fabsf(upper_2a - column_2));
  const float upper_3a = -column_3, upper_3a_lo = -column_lo_4,
      upper_3 = column_3 < 0.0f ? upper_3a : column_3,
      upper_lo_4 = column_3 < 0.0f ? upper_3a_lo : column_lo_4,
      upper_size_28 = upper_bound_1
          + (fabsf(upper_3a_lo) + upper_rest_1 + fabsf(upper_3a - column_3));
  const float v_s_size_0 = fabsf(upper_0), v_s_size_1 = fabsf(upper_1), v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_b_size_1 = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s_d_size_1 = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b_size_1,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d,
      v_s_size_3 = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d_size_1;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_inverse_1 = 1.0f / v_s,
      v_y_lo_1 = KSL_MULF(upper_0 - KSL_MULF(v_y_0, v_y_inverse_1)
          + (column_3 < 0.0f ? upper_0a_lo : column_lo_1), v_s);
  const float v_y_1 = KSL_MULF(upper_1, v_s),
      v_y_lo_2 = KSL_MULF(upper_1 - KSL_MULF(v_y_1, v_y_inverse_1)
          + (column_3 < 0.0f ? upper_1a_lo : column_lo_2), v_s);
  const float v_y_2 = KSL_MULF(upper_2, v_s),
      v_y_lo_3 = KSL_MULF(upper_2 - KSL_MULF(v_y_2, v_y_inverse_1)
          + (column_3 < 0.0f ? upper_2a_lo : column_lo_3), v_s);
  const float v_n_a = KSL_MULF(v_y_0, v_y_0);
  const float v_y_size_1 = KSL_MULF(v_s_size_3, 3.3087225e-24f
          + (column_size_1
          + KSL_MULF(5.497537e+11f, upper_bound_1 < upper_size_2 ? 0.0f : upper_size_7)));
  const float v_n_a_padded_1 = 3.3087225e-24f + v_y_size_1,
      v_n_a_size_2 = KSL_MULF(v_n_a_padded_1, fabsf(v_y_0)
          + KSL_MULF(262144.0f, fabsf(v_y_lo_1) + KSL_MULF(1.9326999e-12f, v_n_a_padded_1))),
      v_n_b = KSL_MULF(v_y_1, v_y_1);
  const float v_y_size_2 = KSL_MULF(v_s_size_3, 3.3087225e-24f
          + (column_size_2
          + KSL_MULF(5.497537e+11f, upper_bound_1 < upper_size_2 ? 0.0f : upper_size_14)));
  const float v_n_b_padded_1 = 3.3087225e-24f + v_y_size_2,
      v_n_b_size_2 = KSL_MULF(v_n_b_padded_1, fabsf(v_y_1)
          + KSL_MULF(262144.0f, fabsf(v_y_lo_2) + KSL_MULF(1.9326999e-12f, v_n_b_padded_1))),
      v_n_c = v_n_a + v_n_b, v_n_c_right_1 = v_n_c - v_n_a,
      v_n_c_lo1_1 = ksl_product_restf(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
          + ksl_product_restf(v_y_1, v_y_1, v_n_b, v_n_c_right_1), v_n_d = KSL_MULF(v_y_2, v_y_2);
  const float v_y_size_3 = KSL_MULF(v_s_size_3, 3.3087225e-24f
          + (column_size_3
          + KSL_MULF(5.497537e+11f, upper_bound_1 < upper_size_2 ? 0.0f : upper_size_21)));
  const float v_n_d_padded_1 = 3.3087225e-24f + v_y_size_3,
      v_n_d_size_2 = KSL_MULF(v_n_d_padded_1, fabsf(v_y_2)
          + KSL_MULF(262144.0f, fabsf(v_y_lo_3) + KSL_MULF(1.9326999e-12f, v_n_d_padded_1))),
      v_n_e = v_n_c + v_n_d, v_n_e_right_1 = v_n_e - v_n_c,
      v_n_e_lo1_1 = v_n_c - (v_n_e - v_n_e_right_1)
          + ksl_product_restf(v_y_2, v_y_2, v_n_d, v_n_e_right_1),
      v_n_c_lo = v_n_c_lo1_1
          + (KSL_MULF(v_y_lo_1, v_y_0) + KSL_MULF(v_y_0, v_y_lo_1)
          + (KSL_MULF(v_y_lo_2, v_y_1) + KSL_MULF(v_y_1, v_y_lo_2))),
      v_n_e_lo = v_n_e_lo1_1 + (KSL_MULF(v_y_lo_3, v_y_2) + KSL_MULF(v_y_2, v_y_lo_3)) + v_n_c_lo,
      v_n = sqrtf(v_n_e), v_n_product_1 = KSL_MULF(v_n, v_n), v_n_twice_1 = v_n + v_n,
      v_n_lo = (v_n_e - v_n_product_1 - ksl_product_errorf(v_n, v_n, v_n_product_1) + v_n_e_lo)
          / (v_n == 0.0f ? 1.0f : v_n_twice_1),
      v_n_padded_1 = 3.3087225e-24f
          + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
          + (v_n_d_size_2 + v_n_d_size_2)),
      v_n_bound_1 = fabsf(v_n_e_lo) + KSL_MULF(3.3147653e-12f, v_n_padded_1),
      v_n_size_4 = KSL_MULF(fabsf(v_n_e) + KSL_MULF(262144.0f, v_n_bound_1), v_n_padded_1 / v_n
          / v_n_e), v_n_size_6 = fabsf(v_n_lo),
      v_n_size_8 = KSL_MULF(3.9615493e+11f, sqrtf(v_n_bound_1) + v_n_size_6),
      v_n_size_12 = v_n + (KSL_MULF(4.0f, v_n_bound_1) < v_n_e ? v_n_size_4 : v_n_size_8);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f,
      v_r_b_size_1 = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r_d_size_1 = 1.0f < v_s ? 5.551115e-17f : v_r_b_size_1,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
  const float n = KSL_MULF(v_n, v_r), n_lo = KSL_MULF(v_n - KSL_MULF(n, 1.0f / v_r) + v_n_lo, v_r),
      n_padded_1 = 3.3087225e-24f + v_n_size_12;
  const float half = ksl_atan2f(n, upper_3), half_size0_1 = fabsf(n), half_size1_1 = fabsf(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0f ? 1.0f : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1,
      half_divisor2_1 = KSL_MULF(half_divisor_1, KSL_MULF(half_part1_1, half_part1_1)
          + KSL_MULF(half_part0_1, half_part0_1)),
      half_more_1 = (KSL_MULF(half_part1_1, n_lo) - KSL_MULF(half_part0_1, upper_lo_4))
          / (half_most_1 == 0.0f ? 1.0f : half_divisor2_1),
      half_lo = ksl_atan2_errorf(n, upper_3, half) + half_more_1,
      half_padded_1 = 3.3087225e-24f
          + KSL_MULF(n_padded_1, 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d_size_1),
      half_padded_2 = 3.3087225e-24f
          + (column_size_4
          + KSL_MULF(5.497537e+11f, upper_bound_1 < upper_size_2 ? 0.0f : upper_size_28)),
      half_size_2 = fabsf(n), half_size_3 = fabsf(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_bound_1 = fabsf(n_lo) + KSL_MULF(2.7161363e-12f, half_padded_1),
      half_bound_2 = fabsf(upper_lo_4) + KSL_MULF(1.8758484e-12f, half_padded_2),
      half_size_11 = (half_bound_2 + (3.3087225e-24f + half_bound_1)) / half_size_5,
      half_size_13 = KSL_MULF(half_size_11, half_size_11), half_size_15 = 7.0f + fabsf(half_lo),
      half_size_18 = half_bound_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_21 = KSL_MULF(1.5707046e+11f, half_size_11 < 0.25f ? half_size_19 : half_size_15);
  const float divisor = v_n == 0.0f ? 1.0f : v_n, divisor_lo = v_n == 0.0f ? 0.0f : v_n_lo,
      divisor_bound_1 = KSL_MULF(2.6379647e-12f, n_padded_1) + v_n_size_6,
      divisor_size_3 = fabsf(v_n - 0.0f), divisor_size_7 = divisor_bound_1 + fabsf(1.0f - v_n);
  const float unit_0 = v_y_0 / divisor, unit_product_1 = KSL_MULF(unit_0, divisor),
      unit_lo_1 = (v_y_0 - unit_product_1 - ksl_product_errorf(unit_0, divisor, unit_product_1)
          + v_y_lo_1 - KSL_MULF(unit_0, divisor_lo)) / divisor;
  const float divisor_size_10 = (v_n == 0.0f ? 1.0f : v_n_size_12)
          + KSL_MULF(2.7487268e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : divisor_size_7);
  const float unit_padded_1 = 3.3087225e-24f + divisor_size_10, unit_size_1 = fabsf(unit_0),
      unit_size_2 = fabsf(divisor),
      unit_bound_1 = fabsf(divisor_lo) + KSL_MULF(3.7517537e-12f, unit_padded_1),
      unit_size_7 = KSL_MULF(4.0f, unit_bound_1) < unit_size_2 ? unit_size_2 : 0.0f,
      unit_reach_1 = unit_size_2 + KSL_MULF(262144.0f, unit_bound_1),
      unit_size_11 = unit_size_1
          + KSL_MULF(unit_reach_1, (KSL_MULF(unit_padded_1, unit_size_1) + v_n_a_padded_1)
          / unit_size_7) / unit_size_2;
  const float unit_1 = v_y_1 / divisor, unit_product_2 = KSL_MULF(unit_1, divisor),
      unit_size_12 = fabsf(unit_1);
  const float unit_2 = v_y_2 / divisor, unit_product_3 = KSL_MULF(unit_2, divisor),
      unit_size_19 = fabsf(unit_2);
  const float angle = KSL_MULF(2.0f, half);
  const float axis_0 = v_n == 0.0f ? 1.0f : unit_0,
      axis_size_4 = fabsf(unit_lo_1) + KSL_MULF(5.367124e-12f, 3.3087225e-24f + unit_size_11)
          + fabsf(1.0f - unit_0);
  const float angle_rest_1 = KSL_MULF(6.6757142e-12f, 3.3087225e-24f
          + KSL_MULF(2.0f, fabsf(half) + (half_padded_1 + half_padded_2) / half_size_5
          + half_size_21));
  const float axis_size_7 = (v_n == 0.0f ? 1.0f : unit_size_11)
          + KSL_MULF(1.9138788e+11f, divisor_bound_1 < divisor_size_3 ? 0.0f : axis_size_4);
  const float unit_lo_2 = (v_y_1 - unit_product_2
          - ksl_product_errorf(unit_1, divisor, unit_product_2) + v_y_lo_2
          - KSL_MULF(unit_1, divisor_lo)) / divisor,
      unit_size_18 = unit_size_12
          + KSL_MULF(unit_reach_1, (KSL_MULF(unit_padded_1, unit_size_12) + v_n_b_padded_1)
          / unit_size_7) / unit_size_2;
  const float unit_lo_3 = (v_y_2 - unit_product_3
          - ksl_product_errorf(unit_2, divisor, unit_product_3) + v_y_lo_3
          - KSL_MULF(unit_2, divisor_lo)) / divisor,
      unit_size_25 = unit_size_19
          + KSL_MULF(unit_reach_1, (KSL_MULF(unit_padded_1, unit_size_19) + v_n_d_padded_1)
          / unit_size_7) / unit_size_2;
  const float R_n_0 = KSL_MULF(R->m11, R->m22) - KSL_MULF(R->m12, R->m21),
      R_n_1 = KSL_MULF(R->m02, R->m21) - KSL_MULF(R->m01, R->m22),
      R_n_2 = KSL_MULF(R->m01, R->m12) - KSL_MULF(R->m02, R->m11);
  const float R_det = KSL_MULF(R->m00, R_n_0) + KSL_MULF(R->m10, R_n_1) + KSL_MULF(R->m20, R_n_2);
  const float R_g_0 = KSL_MULF(R->m00, R->m00) + KSL_MULF(R->m10, R->m10)
          + KSL_MULF(R->m20, R->m20),
      R_g_1 = KSL_MULF(R->m00, R->m01) + KSL_MULF(R->m10, R->m11) + KSL_MULF(R->m20, R->m21),
      R_g_2 = KSL_MULF(R->m00, R->m02) + KSL_MULF(R->m10, R->m12) + KSL_MULF(R->m20, R->m22),
      R_g_3 = KSL_MULF(R->m01, R->m01) + KSL_MULF(R->m11, R->m11) + KSL_MULF(R->m21, R->m21),
      R_g_4 = KSL_MULF(R->m01, R->m02) + KSL_MULF(R->m11, R->m12) + KSL_MULF(R->m21, R->m22),
      R_g_5 = KSL_MULF(R->m02, R->m02) + KSL_MULF(R->m12, R->m12) + KSL_MULF(R->m22, R->m22);
  const float R_off_0 = R_det - 1.0f, R_off_1 = R_g_0 - 1.0f, R_off_4 = R_g_3 - 1.0f,
      R_off_6 = R_g_5 - 1.0f;
  const float R_defect_size_0 = fabsf(R_off_0), R_defect_size_1 = fabsf(R_off_1),
      R_defect_size_2 = fabsf(R_g_1), R_defect_size_3 = fabsf(R_g_2),
      R_defect_size_4 = fabsf(R_off_4), R_defect_size_5 = fabsf(R_g_4),
      R_defect_size_6 = fabsf(R_off_6);
  const float R_defect_largest1 = R_defect_size_0 < R_defect_size_1 ? R_defect_size_1
          : R_defect_size_0;
  const float R_defect_largest2 = R_defect_largest1 < R_defect_size_2 ? R_defect_size_2
          : R_defect_largest1;
  const float R_defect_largest3 = R_defect_largest2 < R_defect_size_3 ? R_defect_size_3
          : R_defect_largest2;
  const float R_defect_largest4 = R_defect_largest3 < R_defect_size_4 ? R_defect_size_4
          : R_defect_largest3;
  const float R_defect_largest5 = R_defect_largest4 < R_defect_size_5 ? R_defect_size_5
          : R_defect_largest4;
  const float R_defect_largest6 = R_defect_largest5 < R_defect_size_6 ? R_defect_size_6
          : R_defect_largest5;
  const float R_unless_equal = R_defect_largest6 == 0.001f ? 0.0f : 1.2676506e+30f;
  const float R_unless_rotation = R_defect_largest6 < 0.001f ? 0.0f : R_unless_equal;
  const float R_excess = KSL_MULF(R_unless_rotation, 1.2676506e+30f),
      R_excess_0 = fabsf(KSL_MULF(2.0f, half_lo)) + angle_rest_1 + R_excess,
      R_excess_1 = fabsf(v_n == 0.0f ? 0.0f : unit_lo_1)
          + KSL_MULF(5.3671256e-12f, 3.3087225e-24f + axis_size_7) + R_excess,
      R_excess_2 = fabsf(unit_lo_2) + KSL_MULF(5.367124e-12f, 3.3087225e-24f + unit_size_18)
          + R_excess,
      R_excess_3 = fabsf(unit_lo_3) + KSL_MULF(5.367124e-12f, 3.3087225e-24f + unit_size_25)
          + R_excess;
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  *angle_bound = R_excess_0;
  axis_bound->x = R_excess_1;
  axis_bound->y = R_excess_2;
  axis_bound->z = R_excess_3;
  return angle;
}

#endif
