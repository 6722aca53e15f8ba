/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MAT3X3_MANY_H
#define KSL_MAT3X3_MANY_H

#include "mat3x3.h"
#include "ksl_states.h"

/* ksl_mat3x3_copy of n elements. */
static KSL_INLINED void ksl_mat3x3_copy_many(ptrdiff_t n, const ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_copy(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_copy_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_copy(&R_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3_setIdentity of n elements. */
static KSL_INLINED void ksl_mat3x3_setIdentity_many(ptrdiff_t n, ksl_mat3x3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_setIdentity_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_t self_i = ksl_mat3x3_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3_setIdentity(&self_i);
    ksl_mat3x3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3_setFromVectors of n elements. */
static KSL_INLINED void ksl_mat3x3_setFromVectors_many(ptrdiff_t n, ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *x, ptrdiff_t x_stride,
    const ksl_vec3_t *y, ptrdiff_t y_stride, const ksl_vec3_t *z,
    ptrdiff_t z_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_setFromVectors(R + i * R_stride, x + i * x_stride, y + i * y_stride,
        z + i * z_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_setFromVectors_planes(ptrdiff_t n, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    const double *y, ptrdiff_t y_plane, ptrdiff_t y_stride, const double *z,
    ptrdiff_t z_plane, ptrdiff_t z_stride) {
  ksl_vec3_t x_i;
  if (n > 0) x_i = ksl_vec3_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    ksl_mat3x3_t R_i;
    if (x_stride) x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    const ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    const ksl_vec3_t z_i = ksl_vec3_of_planes(z + i * z_stride, z_plane);
    ksl_mat3x3_setFromVectors(&R_i, &x_i, &y_i, &z_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_skew of n elements. */
static KSL_INLINED void ksl_skew_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_skew(v + i * v_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_skew_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t Ro_i;
    ksl_skew(&v_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_acceleration_tensor of n elements. */
static KSL_INLINED void ksl_acceleration_tensor_many(ptrdiff_t n, const ksl_vec3_t *w,
    ptrdiff_t w_stride, const ksl_vec3_t *dw, ptrdiff_t dw_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_acceleration_tensor(w + i * w_stride, dw + i * dw_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_acceleration_tensor_planes(ptrdiff_t n, const double *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const double *dw, ptrdiff_t dw_plane,
    ptrdiff_t dw_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_vec3_t w_i;
  if (n > 0) w_i = ksl_vec3_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3_of_planes(w + i * w_stride, w_plane);
    const ksl_vec3_t dw_i = ksl_vec3_of_planes(dw + i * dw_stride, dw_plane);
    ksl_mat3x3_t Ro_i;
    ksl_acceleration_tensor(&w_i, &dw_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3_transpose of n elements. */
static KSL_INLINED void ksl_mat3x3_transpose_many(ptrdiff_t n, ksl_mat3x3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_transpose(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_transpose_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_t self_i = ksl_mat3x3_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3_transpose(&self_i);
    ksl_mat3x3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3_transposed of n elements. */
static KSL_INLINED void ksl_mat3x3_transposed_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_transposed(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_transposed_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_transposed(&R_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3_determinant of n elements. */
static KSL_INLINED void ksl_mat3x3_determinant_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, double *det, ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3_determinant(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_determinant_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *det, ptrdiff_t det_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    det[i * det_stride] = ksl_mat3x3_determinant(&R_i);
  }
}

/* ksl_mat3x3_inverse of n elements. */
static KSL_INLINED void ksl_mat3x3_inverse_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride, double *det,
    ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3_inverse(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_inverse_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    double *det, ptrdiff_t det_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3_t Ro_i;
    det[i * det_stride] = ksl_mat3x3_inverse(&R_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3_normalize of n elements. */
static KSL_INLINED void ksl_mat3x3_normalize_many(ptrdiff_t n, ksl_mat3x3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_normalize_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_t self_i = ksl_mat3x3_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3_normalize(&self_i);
    ksl_mat3x3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3_normalized of n elements. */
static KSL_INLINED void ksl_mat3x3_normalized_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_normalized(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_normalized_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_normalized(&R_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3_setFromAxisDC of n elements. */
static KSL_INLINED void ksl_mat3x3_setFromAxisDC_many(ptrdiff_t n, ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *axis, ptrdiff_t axis_stride,
    const double *dc, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_setFromAxisDC(R + i * R_stride, axis + i * axis_stride, dc + 2 * i * dc_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_setFromAxisDC_planes(ptrdiff_t n, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride) {
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    ksl_mat3x3_t R_i;
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_setFromAxisDC(&R_i, &axis_i, dc_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

#if KSL_LANE_BYTES
/* ksl_mat3x3_from_euler_xyz of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_mat3x3_from_euler_xyz_states(const ksl_states *angles, ksl_states *R) {
  ksl_states c_1; const ksl_states s_1 = ksl_sincos_lanes(angles[0], &c_1);
  ksl_states c_2; const ksl_states s_2 = ksl_sincos_lanes(angles[1], &c_2);
  ksl_states c_3; const ksl_states s_3 = ksl_sincos_lanes(angles[2], &c_3);
  const ksl_states first_1 = KSL_RN_LANES(c_2 * c_3);
  const ksl_states first_1a = KSL_RN_LANES(s_3 * c_2), first_2 = -first_1a;
  const ksl_states first_6a = s_2 * c_3, first_3 = -first_6a;
  const ksl_states first_4 = s_2 * s_3;
  const ksl_states last_3a = KSL_RN_LANES(s_3 * c_1), last_3b = KSL_RN_LANES(s_1 * first_3), last_1
      = last_3a - last_3b;
  const ksl_states last_4a = KSL_RN_LANES(c_1 * c_3), last_4b = KSL_RN_LANES(s_1 * first_4), last_2
      = last_4a - last_4b;
  const ksl_states last_5a = KSL_RN_LANES(s_1 * c_2), last_3 = -last_5a;
  const ksl_states last_6a = KSL_RN_LANES(s_1 * s_3), last_6b = KSL_RN_LANES(c_1 * first_3), last_4
      = last_6a + last_6b;
  const ksl_states last_7a = KSL_RN_LANES(s_1 * c_3), last_7b = KSL_RN_LANES(c_1 * first_4), last_5
      = last_7a + last_7b;
  const ksl_states last_6 = KSL_RN_LANES(c_1 * c_2);
  R[0] = first_1;
  R[3] = first_2;
  R[6] = s_2;
  R[1] = last_1;
  R[4] = last_2;
  R[7] = last_3;
  R[2] = last_4;
  R[5] = last_5;
  R[8] = last_6;
}
#endif

/* ksl_mat3x3_from_euler_xyz of n elements. */
static KSL_INLINED void ksl_mat3x3_from_euler_xyz_planes(ptrdiff_t n, const double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride) {
#if KSL_LANE_BYTES
  ksl_states angles_states[3], R_states[9];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(angles + i * angles_stride, 3, angles_plane, angles_stride, last,
        angles_states);
    ksl_mat3x3_from_euler_xyz_states(angles_states, R_states);
    ksl_states_to_planes(R_states, 9, R + i * R_stride, R_plane, R_stride, last);
  }
#else
  ksl_vec3_t angles_i;
  if (n > 0) angles_i = ksl_vec3_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_euler_xyz(&angles_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
#endif
}

static KSL_INLINED void ksl_mat3x3_from_euler_xyz_many(ptrdiff_t n, const ksl_vec3_t *angles,
    ptrdiff_t angles_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  ksl_mat3x3_from_euler_xyz_planes(n, (const double *)angles, 1, 3 * angles_stride, (double *)R, 1,
      9 * R_stride);
}

#if KSL_LANE_BYTES
/* ksl_euler_xyz_from_mat3x3 of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_euler_xyz_from_mat3x3_states(const ksl_states *R, ksl_states *angles) {
  const ksl_states n_a = KSL_RN_LANES(R[0] * R[0]), n_b = KSL_RN_LANES(R[3] * R[3]), n_c = n_a +
      n_b,
      n = ksl_sqrt_lanes(n_c);
  const ksl_tests divisor_a = ksl_equal_lanes(n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), n);
  const ksl_states cosine_a = R[0] / divisor,
      cosine = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), cosine_a);
  const ksl_states sine_a = -R[3], sine = sine_a / divisor;
  const ksl_states polar = ksl_atan2_lanes(sine_a, R[0]);
  const ksl_states third = ksl_choice_lanes(divisor_a, ksl_each_lanes(0.0), polar);
  const ksl_states left_1a = KSL_RN_LANES(R[1] * sine), left_1b = KSL_RN_LANES(R[4] * cosine);
  const ksl_states left_2a = KSL_RN_LANES(R[2] * sine), left_2b = KSL_RN_LANES(R[5] * cosine);
  const ksl_states rest = R[7] + R[8];
  const ksl_states first = ksl_atan2_lanes(left_2a + left_2b, left_1a + left_1b);
  const ksl_tests angles_0a = ksl_less_lanes(rest, ksl_each_lanes(1.2676506002282294e+30));
  const ksl_states angles_1 = ksl_choice_lanes(angles_0a, first, rest);
  const ksl_states angles_2 = ksl_atan2_lanes(R[6], n);
  angles[0] = angles_1;
  angles[1] = angles_2;
  angles[2] = third;
}
#endif

/* ksl_euler_xyz_from_mat3x3 of n elements. */
static KSL_INLINED void ksl_euler_xyz_from_mat3x3_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride) {
#if KSL_LANE_BYTES
  ksl_states R_states[9], angles_states[3];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(R + i * R_stride, 9, R_plane, R_stride, last, R_states);
    ksl_euler_xyz_from_mat3x3_states(R_states, angles_states);
    ksl_states_to_planes(angles_states, 3, angles + i * angles_stride, angles_plane, angles_stride,
        last);
  }
#else
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t angles_i;
    ksl_euler_xyz_from_mat3x3(&R_i, &angles_i);
    ksl_vec3_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
#endif
}

static KSL_INLINED void ksl_euler_xyz_from_mat3x3_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *angles, ptrdiff_t angles_stride) {
  ksl_euler_xyz_from_mat3x3_planes(n, (const double *)R, 1, 9 * R_stride, (double *)angles, 1,
      3 * angles_stride);
}

#if KSL_LANE_BYTES
/* ksl_mat3x3_from_euler_xyx of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_mat3x3_from_euler_xyx_states(const ksl_states *angles, ksl_states *R) {
  ksl_states c_1; const ksl_states s_1 = ksl_sincos_lanes(angles[0], &c_1);
  ksl_states c_2; const ksl_states s_2 = ksl_sincos_lanes(angles[1], &c_2);
  ksl_states c_3; const ksl_states s_3 = ksl_sincos_lanes(angles[2], &c_3);
  const ksl_states first_1 = KSL_RN_LANES(s_2 * s_3);
  const ksl_states first_2 = KSL_RN_LANES(s_2 * c_3);
  const ksl_states first_3 = s_3 * c_2;
  const ksl_states first_4 = c_2 * c_3;
  const ksl_states last_1 = KSL_RN_LANES(s_1 * s_2);
  const ksl_states last_4a = KSL_RN_LANES(c_1 * c_3), last_4b = KSL_RN_LANES(s_1 * first_3), last_2
      = last_4a - last_4b;
  const ksl_states last_5a = KSL_RN_LANES(s_1 * first_4), last_5b = KSL_RN_LANES(s_3 * c_1),
      last_5c = last_5a + last_5b, last_3 = -last_5c;
  const ksl_states last_6a = KSL_RN_LANES(s_2 * c_1), last_4 = -last_6a;
  const ksl_states last_7a = KSL_RN_LANES(s_1 * c_3), last_7b = KSL_RN_LANES(c_1 * first_3), last_5
      = last_7a + last_7b;
  const ksl_states last_8a = KSL_RN_LANES(c_1 * first_4), last_8b = KSL_RN_LANES(s_1 * s_3), last_6
      = last_8a - last_8b;
  R[0] = c_2;
  R[3] = first_1;
  R[6] = first_2;
  R[1] = last_1;
  R[4] = last_2;
  R[7] = last_3;
  R[2] = last_4;
  R[5] = last_5;
  R[8] = last_6;
}
#endif

/* ksl_mat3x3_from_euler_xyx of n elements. */
static KSL_INLINED void ksl_mat3x3_from_euler_xyx_planes(ptrdiff_t n, const double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride) {
#if KSL_LANE_BYTES
  ksl_states angles_states[3], R_states[9];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(angles + i * angles_stride, 3, angles_plane, angles_stride, last,
        angles_states);
    ksl_mat3x3_from_euler_xyx_states(angles_states, R_states);
    ksl_states_to_planes(R_states, 9, R + i * R_stride, R_plane, R_stride, last);
  }
#else
  ksl_vec3_t angles_i;
  if (n > 0) angles_i = ksl_vec3_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_euler_xyx(&angles_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
#endif
}

static KSL_INLINED void ksl_mat3x3_from_euler_xyx_many(ptrdiff_t n, const ksl_vec3_t *angles,
    ptrdiff_t angles_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  ksl_mat3x3_from_euler_xyx_planes(n, (const double *)angles, 1, 3 * angles_stride, (double *)R, 1,
      9 * R_stride);
}

#if KSL_LANE_BYTES
/* ksl_euler_xyx_from_mat3x3 of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_euler_xyx_from_mat3x3_states(const ksl_states *R, ksl_states *angles) {
  const ksl_states n_a = KSL_RN_LANES(R[3] * R[3]), n_b = KSL_RN_LANES(R[6] * R[6]), n_c = n_a +
      n_b,
      n = ksl_sqrt_lanes(n_c);
  const ksl_tests divisor_a = ksl_equal_lanes(n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), n);
  const ksl_states cosine_a = R[6] / divisor,
      cosine = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), cosine_a);
  const ksl_states sine = R[3] / divisor;
  const ksl_states polar = ksl_atan2_lanes(R[3], R[6]);
  const ksl_states third = ksl_choice_lanes(divisor_a, ksl_each_lanes(0.0), polar);
  const ksl_states left_1a = KSL_RN_LANES(R[4] * cosine), left_1b = KSL_RN_LANES(R[7] * sine);
  const ksl_states left_2a = KSL_RN_LANES(R[5] * cosine), left_2b = KSL_RN_LANES(R[8] * sine);
  const ksl_states rest = R[1] + R[2];
  const ksl_states first = ksl_atan2_lanes(left_2a - left_2b, left_1a - left_1b);
  const ksl_tests angles_0a = ksl_less_lanes(rest, ksl_each_lanes(1.2676506002282294e+30));
  const ksl_states angles_1 = ksl_choice_lanes(angles_0a, first, rest);
  const ksl_states angles_2 = ksl_atan2_lanes(n, R[0]);
  angles[0] = angles_1;
  angles[1] = angles_2;
  angles[2] = third;
}
#endif

/* ksl_euler_xyx_from_mat3x3 of n elements. */
static KSL_INLINED void ksl_euler_xyx_from_mat3x3_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride) {
#if KSL_LANE_BYTES
  ksl_states R_states[9], angles_states[3];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(R + i * R_stride, 9, R_plane, R_stride, last, R_states);
    ksl_euler_xyx_from_mat3x3_states(R_states, angles_states);
    ksl_states_to_planes(angles_states, 3, angles + i * angles_stride, angles_plane, angles_stride,
        last);
  }
#else
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t angles_i;
    ksl_euler_xyx_from_mat3x3(&R_i, &angles_i);
    ksl_vec3_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
#endif
}

static KSL_INLINED void ksl_euler_xyx_from_mat3x3_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *angles, ptrdiff_t angles_stride) {
  ksl_euler_xyx_from_mat3x3_planes(n, (const double *)R, 1, 9 * R_stride, (double *)angles, 1,
      3 * angles_stride);
}

/* ksl_mat3x3_jacobi of n elements. */
static KSL_INLINED void ksl_mat3x3_jacobi_many(ptrdiff_t n, ksl_mat3x3_t *A, ptrdiff_t A_stride,
    ksl_mat3x3_t *V, ptrdiff_t V_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_jacobi(A + i * A_stride, V + i * V_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_jacobi_planes(ptrdiff_t n, double *A, ptrdiff_t A_plane,
    ptrdiff_t A_stride, double *V, ptrdiff_t V_plane, ptrdiff_t V_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_t A_i = ksl_mat3x3_of_planes(A + i * A_stride, A_plane);
    ksl_mat3x3_t V_i = ksl_mat3x3_of_planes(V + i * V_stride, V_plane);
    ksl_mat3x3_jacobi(&A_i, &V_i);
    ksl_mat3x3_to_planes(&A_i, A + i * A_stride, A_plane);
    ksl_mat3x3_to_planes(&V_i, V + i * V_stride, V_plane);
  }
}

/* ksl_mat3x3_rotation_defect of n elements. */
static KSL_INLINED void ksl_mat3x3_rotation_defect_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, double *defect, ptrdiff_t defect_stride) {
  KSL_EACH_OF(n) {
    defect[i * defect_stride] = ksl_mat3x3_rotation_defect(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_rotation_defect_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *defect,
    ptrdiff_t defect_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    defect[i * defect_stride] = ksl_mat3x3_rotation_defect(&R_i);
  }
}

/* ksl_mat3x3_nearest_rotation of n elements. */
static KSL_INLINED void ksl_mat3x3_nearest_rotation_many(ptrdiff_t n, const ksl_mat3x3_t *A,
    ptrdiff_t A_stride, ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_nearest_rotation(A + i * A_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_nearest_rotation_planes(ptrdiff_t n, const double *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t A_i;
  if (n > 0) A_i = ksl_mat3x3_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat3x3_of_planes(A + i * A_stride, A_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_nearest_rotation(&A_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

#if KSL_LANE_BYTES
/* ksl_mat3x3_from_axis_angle of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_mat3x3_from_axis_angle_states(const ksl_states *axis,
    const ksl_states *angle, ksl_states *R) {
  ksl_states cosine; const ksl_states sine = ksl_sincos_lanes(angle[0], &cosine);
  const ksl_states half = 0.5 * angle[0];
  const ksl_states h = ksl_sin_lanes(half);
  const ksl_states versine_a = KSL_RN_LANES(h * h), versine_b = 2.0 * versine_a, versine_c = 1.0 -
      cosine;
  const ksl_tests versine_d = ksl_less_lanes(cosine, ksl_each_lanes(0.0));
  const ksl_states versine = ksl_choice_lanes(versine_d, versine_c, versine_b);
  const ksl_states beta_v_1 = axis[0] * versine;
  const ksl_states beta_v_2 = axis[1] * versine;
  const ksl_states m_1 = KSL_RN_LANES(axis[0] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(axis[1] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(axis[2] * (axis[2] * versine));
  const ksl_states m_4 = KSL_RN_LANES(axis[1] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(axis[2] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(axis[2] * beta_v_2);
  const ksl_states alpha_v_1 = KSL_RN_LANES(axis[0] * sine);
  const ksl_states alpha_v_2 = KSL_RN_LANES(axis[1] * sine);
  const ksl_states alpha_v_3 = KSL_RN_LANES(axis[2] * sine);
  const ksl_states R_1 = 1.0 - (m_2 + m_3);
  const ksl_states R_2 = m_4 - alpha_v_3;
  const ksl_states R_3 = m_5 + alpha_v_2;
  const ksl_states R_4 = m_4 + alpha_v_3;
  const ksl_states R_5 = 1.0 - (m_1 + m_3);
  const ksl_states R_6 = m_6 - alpha_v_1;
  const ksl_states R_7 = m_5 - alpha_v_2;
  const ksl_states R_8 = m_6 + alpha_v_1;
  const ksl_states R_9 = 1.0 - (m_1 + m_2);
  R[0] = R_1;
  R[3] = R_2;
  R[6] = R_3;
  R[1] = R_4;
  R[4] = R_5;
  R[7] = R_6;
  R[2] = R_7;
  R[5] = R_8;
  R[8] = R_9;
}
#endif

/* ksl_mat3x3_from_axis_angle of n elements. */
static KSL_INLINED void ksl_mat3x3_from_axis_angle_planes(ptrdiff_t n, const double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const double *angle,
    ptrdiff_t angle_stride, double *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
#if KSL_LANE_BYTES
  ksl_states axis_states[3], angle_states[1], R_states[9];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(axis + i * axis_stride, 3, axis_plane, axis_stride, last, axis_states);
    ksl_states_of_planes(angle + i * angle_stride, 1, 1, angle_stride, last, angle_states);
    ksl_mat3x3_from_axis_angle_states(axis_states, angle_states, R_states);
    ksl_states_to_planes(R_states, 9, R + i * R_stride, R_plane, R_stride, last);
  }
#else
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_axis_angle(&axis_i, angle[i * angle_stride], &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
#endif
}

static KSL_INLINED void ksl_mat3x3_from_axis_angle_many(ptrdiff_t n, const ksl_vec3_t *axis,
    ptrdiff_t axis_stride, const double *angle, ptrdiff_t angle_stride,
    ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  ksl_mat3x3_from_axis_angle_planes(n, (const double *)axis, 1, 3 * axis_stride, angle,
      angle_stride, (double *)R, 1, 9 * R_stride);
}

#if KSL_LANE_BYTES
/* ksl_axis_angle_from_mat3x3 of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_axis_angle_from_mat3x3_states(const ksl_states *R, ksl_states *angle,
    ksl_states *axis) {
  const ksl_states p_1 = R[5] - R[7];
  const ksl_states p_2 = R[6] - R[2];
  const ksl_states p_3 = R[1] - R[3];
  const ksl_states s_1 = R[7] + R[5];
  const ksl_states s_2 = R[6] + R[2];
  const ksl_states s_3 = R[3] + R[1];
  const ksl_states first_1 = R[0] + 1.0;
  const ksl_states first_2 = 1.0 - R[0];
  const ksl_states others_1 = R[4] + R[8];
  const ksl_states others_2 = R[4] - R[8];
  const ksl_tests low_0a = ksl_less_lanes(R[4], R[0]);
  const ksl_states high_0a = -R[4];
  const ksl_tests high_0b = ksl_less_lanes(R[0], high_0a);
  const ksl_tests column_0a = ksl_less_lanes(R[8], ksl_each_lanes(0.0));
  const ksl_states column_1 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, first_1
          - others_1, s_3), ksl_choice_lanes(high_0b, s_2, p_1));
  const ksl_states column_2 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, s_3, first_2
          + others_2), ksl_choice_lanes(high_0b, s_1, p_2));
  const ksl_states column_3 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, s_2, s_1),
      ksl_choice_lanes(high_0b, first_2 - others_2, p_3));
  const ksl_states column_4 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, p_1, p_2),
      ksl_choice_lanes(high_0b, p_3, first_1 + others_1));
  const ksl_states upper_0a = -column_1;
  const ksl_tests upper_0b = ksl_less_lanes(column_4, ksl_each_lanes(0.0));
  const ksl_states upper_1 = ksl_choice_lanes(upper_0b, upper_0a, column_1);
  const ksl_states upper_1a = -column_2, upper_2 = ksl_choice_lanes(upper_0b, upper_1a, column_2);
  const ksl_states upper_2a = -column_3, upper_3 = ksl_choice_lanes(upper_0b, upper_2a, column_3);
  const ksl_states upper_3a = -column_4;
  const ksl_states v_s_size_1 = ksl_abs_lanes(upper_1);
  const ksl_states v_s_size_2 = ksl_abs_lanes(upper_2);
  const ksl_states v_s_size_3 = ksl_abs_lanes(upper_3);
  const ksl_tests v_s_largest1a = ksl_less_lanes(v_s_size_1, v_s_size_2);
  const ksl_states v_s_largest1 = ksl_choice_lanes(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_tests v_s_largest2a = ksl_less_lanes(v_s_largest1, v_s_size_3);
  const ksl_states v_s_largest2 = ksl_choice_lanes(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_tests v_s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), v_s_largest2);
  const ksl_states v_s_b = ksl_choice_lanes(v_s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests v_s_c = ksl_less_lanes(v_s_largest2, ksl_each_lanes(256.0));
  const ksl_states v_s_d = ksl_choice_lanes(v_s_c, ksl_each_lanes(1.3093562431584567e+151), v_s_b);
  const ksl_tests v_s_e = ksl_less_lanes(v_s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states v_s = ksl_choice_lanes(v_s_e, ksl_each_lanes(1.0715086071862673e+301), v_s_d);
  const ksl_states v_y_1 = upper_1 * v_s;
  const ksl_states v_y_2 = upper_2 * v_s;
  const ksl_states v_y_3 = upper_3 * v_s;
  const ksl_states v_n_a = KSL_RN_LANES(v_y_1 * v_y_1), v_n_b = KSL_RN_LANES(v_y_2 * v_y_2), v_n_c =
      v_n_a + v_n_b,
      v_n_d = KSL_RN_LANES(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanes(v_n_e);
  const ksl_tests v_r_a = ksl_less_lanes(v_s, ksl_each_lanes(1.0));
  const ksl_states v_r_b = ksl_choice_lanes(v_r_a, ksl_each_lanes(2.6815615859885194e+154),
      ksl_each_lanes(1.0));
  const ksl_tests v_r_c = ksl_less_lanes(ksl_each_lanes(1.0), v_s);
  const ksl_states v_r_d = ksl_choice_lanes(v_r_c, ksl_each_lanes(7.637340908749012e-152), v_r_b);
  const ksl_tests v_r_e = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), v_s);
  const ksl_states v_r = ksl_choice_lanes(v_r_e, ksl_each_lanes(9.332636185032189e-302), v_r_d);
  const ksl_states n = v_n * v_r;
  const ksl_states half = ksl_atan2_lanes(n, ksl_choice_lanes(upper_0b, upper_3a, column_4));
  const ksl_tests divisor_a = ksl_equal_lanes(v_n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), v_n);
  const ksl_states unit_1 = v_y_2 / divisor;
  const ksl_states unit_2 = v_y_3 / divisor;
  const ksl_states angle_ = KSL_RN_LANES(2.0 * half);
  const ksl_states axis_1 = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), v_y_1 / divisor);
  angle[0] = angle_;
  axis[0] = axis_1;
  axis[1] = unit_1;
  axis[2] = unit_2;
}
#endif

/* ksl_axis_angle_from_mat3x3 of n elements. */
static KSL_INLINED void ksl_axis_angle_from_mat3x3_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *angle, ptrdiff_t angle_stride) {
#if KSL_LANE_BYTES
  ksl_states R_states[9], axis_states[3], angle_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(R + i * R_stride, 9, R_plane, R_stride, last, R_states);
    ksl_axis_angle_from_mat3x3_states(R_states, angle_states, axis_states);
    ksl_states_to_planes(axis_states, 3, axis + i * axis_stride, axis_plane, axis_stride, last);
    ksl_states_to_planes(angle_states, 1, angle + i * angle_stride, 1, angle_stride, last);
  }
#else
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3(&R_i, &axis_i);
    ksl_vec3_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
#endif
}

static KSL_INLINED void ksl_axis_angle_from_mat3x3_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *axis, ptrdiff_t axis_stride, double *angle,
    ptrdiff_t angle_stride) {
  ksl_axis_angle_from_mat3x3_planes(n, (const double *)R, 1, 9 * R_stride, (double *)axis, 1,
      3 * axis_stride, angle, angle_stride);
}

/* ksl_mat3x3f_copy of n elements. */
static KSL_INLINED void ksl_mat3x3f_copy_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_copy(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_copy_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_copy(&R_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_setIdentity of n elements. */
static KSL_INLINED void ksl_mat3x3f_setIdentity_many(ptrdiff_t n, ksl_mat3x3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_setIdentity_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t self_i = ksl_mat3x3f_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3f_setIdentity(&self_i);
    ksl_mat3x3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3f_setFromVectors of n elements. */
static KSL_INLINED void ksl_mat3x3f_setFromVectors_many(ptrdiff_t n, ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *x, ptrdiff_t x_stride,
    const ksl_vec3f_t *y, ptrdiff_t y_stride, const ksl_vec3f_t *z,
    ptrdiff_t z_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_setFromVectors(R + i * R_stride, x + i * x_stride, y + i * y_stride,
        z + i * z_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_setFromVectors_planes(ptrdiff_t n, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    const float *y, ptrdiff_t y_plane, ptrdiff_t y_stride, const float *z,
    ptrdiff_t z_plane, ptrdiff_t z_stride) {
  ksl_vec3f_t x_i;
  if (n > 0) x_i = ksl_vec3f_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t R_i;
    if (x_stride) x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    const ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    const ksl_vec3f_t z_i = ksl_vec3f_of_planes(z + i * z_stride, z_plane);
    ksl_mat3x3f_setFromVectors(&R_i, &x_i, &y_i, &z_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_skewf of n elements. */
static KSL_INLINED void ksl_skewf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_skewf(v + i * v_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_skewf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_skewf(&v_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_acceleration_tensorf of n elements. */
static KSL_INLINED void ksl_acceleration_tensorf_many(ptrdiff_t n, const ksl_vec3f_t *w,
    ptrdiff_t w_stride, const ksl_vec3f_t *dw, ptrdiff_t dw_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_acceleration_tensorf(w + i * w_stride, dw + i * dw_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_acceleration_tensorf_planes(ptrdiff_t n, const float *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const float *dw, ptrdiff_t dw_plane,
    ptrdiff_t dw_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_vec3f_t w_i;
  if (n > 0) w_i = ksl_vec3f_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3f_of_planes(w + i * w_stride, w_plane);
    const ksl_vec3f_t dw_i = ksl_vec3f_of_planes(dw + i * dw_stride, dw_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_acceleration_tensorf(&w_i, &dw_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_transpose of n elements. */
static KSL_INLINED void ksl_mat3x3f_transpose_many(ptrdiff_t n, ksl_mat3x3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_transpose(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_transpose_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t self_i = ksl_mat3x3f_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3f_transpose(&self_i);
    ksl_mat3x3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3f_transposed of n elements. */
static KSL_INLINED void ksl_mat3x3f_transposed_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_transposed(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_transposed_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_transposed(&R_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_determinant of n elements. */
static KSL_INLINED void ksl_mat3x3f_determinant_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, float *det, ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3f_determinant(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_determinant_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *det, ptrdiff_t det_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    det[i * det_stride] = ksl_mat3x3f_determinant(&R_i);
  }
}

/* ksl_mat3x3f_inverse of n elements. */
static KSL_INLINED void ksl_mat3x3f_inverse_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride, float *det,
    ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3f_inverse(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_inverse_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *det, ptrdiff_t det_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3f_t Ro_i;
    det[i * det_stride] = ksl_mat3x3f_inverse(&R_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_normalize of n elements. */
static KSL_INLINED void ksl_mat3x3f_normalize_many(ptrdiff_t n, ksl_mat3x3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_normalize_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t self_i = ksl_mat3x3f_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3f_normalize(&self_i);
    ksl_mat3x3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3f_normalized of n elements. */
static KSL_INLINED void ksl_mat3x3f_normalized_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_normalized(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_normalized_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_normalized(&R_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_setFromAxisDC of n elements. */
static KSL_INLINED void ksl_mat3x3f_setFromAxisDC_many(ptrdiff_t n, ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *axis, ptrdiff_t axis_stride,
    const float *dc, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_setFromAxisDC(R + i * R_stride, axis + i * axis_stride, dc + 2 * i * dc_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_setFromAxisDC_planes(ptrdiff_t n, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride) {
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t R_i;
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_setFromAxisDC(&R_i, &axis_i, dc_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

#if KSL_LANE_BYTES
/* ksl_mat3x3f_from_euler_xyz of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_mat3x3f_from_euler_xyz_states(const ksl_statesf *angles, ksl_statesf *R) {
  ksl_statesf c_1; const ksl_statesf s_1 = ksl_sincos_lanesf(angles[0], &c_1);
  ksl_statesf c_2; const ksl_statesf s_2 = ksl_sincos_lanesf(angles[1], &c_2);
  ksl_statesf c_3; const ksl_statesf s_3 = ksl_sincos_lanesf(angles[2], &c_3);
  const ksl_statesf first_1 = KSL_RN_LANESF(c_2 * c_3);
  const ksl_statesf first_1a = KSL_RN_LANESF(s_3 * c_2), first_2 = -first_1a;
  const ksl_statesf first_6a = s_2 * c_3, first_3 = -first_6a;
  const ksl_statesf first_4 = s_2 * s_3;
  const ksl_statesf last_3a = KSL_RN_LANESF(s_3 * c_1), last_3b = KSL_RN_LANESF(s_1 * first_3),
      last_1 = last_3a - last_3b;
  const ksl_statesf last_4a = KSL_RN_LANESF(c_1 * c_3), last_4b = KSL_RN_LANESF(s_1 * first_4),
      last_2 = last_4a - last_4b;
  const ksl_statesf last_5a = KSL_RN_LANESF(s_1 * c_2), last_3 = -last_5a;
  const ksl_statesf last_6a = KSL_RN_LANESF(s_1 * s_3), last_6b = KSL_RN_LANESF(c_1 * first_3),
      last_4 = last_6a + last_6b;
  const ksl_statesf last_7a = KSL_RN_LANESF(s_1 * c_3), last_7b = KSL_RN_LANESF(c_1 * first_4),
      last_5 = last_7a + last_7b;
  const ksl_statesf last_6 = KSL_RN_LANESF(c_1 * c_2);
  R[0] = first_1;
  R[3] = first_2;
  R[6] = s_2;
  R[1] = last_1;
  R[4] = last_2;
  R[7] = last_3;
  R[2] = last_4;
  R[5] = last_5;
  R[8] = last_6;
}
#endif

/* ksl_mat3x3f_from_euler_xyz of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_euler_xyz_planes(ptrdiff_t n, const float *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
#if KSL_LANE_BYTES
  ksl_statesf angles_states[3], R_states[9];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(angles + i * angles_stride, 3, angles_plane, angles_stride, last,
        angles_states);
    ksl_mat3x3f_from_euler_xyz_states(angles_states, R_states);
    ksl_statesf_to_planes(R_states, 9, R + i * R_stride, R_plane, R_stride, last);
  }
#else
  ksl_vec3f_t angles_i;
  if (n > 0) angles_i = ksl_vec3f_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3f_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_euler_xyz(&angles_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
#endif
}

static KSL_INLINED void ksl_mat3x3f_from_euler_xyz_many(ptrdiff_t n, const ksl_vec3f_t *angles,
    ptrdiff_t angles_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  ksl_mat3x3f_from_euler_xyz_planes(n, (const float *)angles, 1, 3 * angles_stride, (float *)R, 1,
      9 * R_stride);
}

#if KSL_LANE_BYTES
/* ksl_euler_xyz_from_mat3x3f of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_euler_xyz_from_mat3x3f_states(const ksl_statesf *R, ksl_statesf *angles) {
  const ksl_statesf n_a = KSL_RN_LANESF(R[0] * R[0]), n_b = KSL_RN_LANESF(R[3] * R[3]), n_c = n_a +
      n_b,
      n = ksl_sqrt_lanesf(n_c);
  const ksl_testsf divisor_a = ksl_equal_lanesf(n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf cosine_a = R[0] / divisor,
      cosine = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), cosine_a);
  const ksl_statesf sine_a = -R[3], sine = sine_a / divisor;
  const ksl_statesf polar = ksl_atan2_lanesf(sine_a, R[0]);
  const ksl_statesf third = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(0.0f), polar);
  const ksl_statesf left_1a = KSL_RN_LANESF(R[1] * sine), left_1b = KSL_RN_LANESF(R[4] * cosine);
  const ksl_statesf left_2a = KSL_RN_LANESF(R[2] * sine), left_2b = KSL_RN_LANESF(R[5] * cosine);
  const ksl_statesf rest = R[7] + R[8];
  const ksl_statesf first = ksl_atan2_lanesf(left_2a + left_2b, left_1a + left_1b);
  const ksl_testsf angles_0a = ksl_less_lanesf(rest, ksl_each_lanesf(1.2676506e+30f));
  const ksl_statesf angles_1 = ksl_choice_lanesf(angles_0a, first, rest);
  const ksl_statesf angles_2 = ksl_atan2_lanesf(R[6], n);
  angles[0] = angles_1;
  angles[1] = angles_2;
  angles[2] = third;
}
#endif

/* ksl_euler_xyz_from_mat3x3f of n elements. */
static KSL_INLINED void ksl_euler_xyz_from_mat3x3f_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *angles, ptrdiff_t angles_plane,
    ptrdiff_t angles_stride) {
#if KSL_LANE_BYTES
  ksl_statesf R_states[9], angles_states[3];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(R + i * R_stride, 9, R_plane, R_stride, last, R_states);
    ksl_euler_xyz_from_mat3x3f_states(R_states, angles_states);
    ksl_statesf_to_planes(angles_states, 3, angles + i * angles_stride, angles_plane, angles_stride,
        last);
  }
#else
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t angles_i;
    ksl_euler_xyz_from_mat3x3f(&R_i, &angles_i);
    ksl_vec3f_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
#endif
}

static KSL_INLINED void ksl_euler_xyz_from_mat3x3f_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_vec3f_t *angles, ptrdiff_t angles_stride) {
  ksl_euler_xyz_from_mat3x3f_planes(n, (const float *)R, 1, 9 * R_stride, (float *)angles, 1,
      3 * angles_stride);
}

#if KSL_LANE_BYTES
/* ksl_mat3x3f_from_euler_xyx of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_mat3x3f_from_euler_xyx_states(const ksl_statesf *angles, ksl_statesf *R) {
  ksl_statesf c_1; const ksl_statesf s_1 = ksl_sincos_lanesf(angles[0], &c_1);
  ksl_statesf c_2; const ksl_statesf s_2 = ksl_sincos_lanesf(angles[1], &c_2);
  ksl_statesf c_3; const ksl_statesf s_3 = ksl_sincos_lanesf(angles[2], &c_3);
  const ksl_statesf first_1 = KSL_RN_LANESF(s_2 * s_3);
  const ksl_statesf first_2 = KSL_RN_LANESF(s_2 * c_3);
  const ksl_statesf first_3 = s_3 * c_2;
  const ksl_statesf first_4 = c_2 * c_3;
  const ksl_statesf last_1 = KSL_RN_LANESF(s_1 * s_2);
  const ksl_statesf last_4a = KSL_RN_LANESF(c_1 * c_3), last_4b = KSL_RN_LANESF(s_1 * first_3),
      last_2 = last_4a - last_4b;
  const ksl_statesf last_5a = KSL_RN_LANESF(s_1 * first_4), last_5b = KSL_RN_LANESF(s_3 * c_1),
      last_5c = last_5a + last_5b, last_3 = -last_5c;
  const ksl_statesf last_6a = KSL_RN_LANESF(s_2 * c_1), last_4 = -last_6a;
  const ksl_statesf last_7a = KSL_RN_LANESF(s_1 * c_3), last_7b = KSL_RN_LANESF(c_1 * first_3),
      last_5 = last_7a + last_7b;
  const ksl_statesf last_8a = KSL_RN_LANESF(c_1 * first_4), last_8b = KSL_RN_LANESF(s_1 * s_3),
      last_6 = last_8a - last_8b;
  R[0] = c_2;
  R[3] = first_1;
  R[6] = first_2;
  R[1] = last_1;
  R[4] = last_2;
  R[7] = last_3;
  R[2] = last_4;
  R[5] = last_5;
  R[8] = last_6;
}
#endif

/* ksl_mat3x3f_from_euler_xyx of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_euler_xyx_planes(ptrdiff_t n, const float *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
#if KSL_LANE_BYTES
  ksl_statesf angles_states[3], R_states[9];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(angles + i * angles_stride, 3, angles_plane, angles_stride, last,
        angles_states);
    ksl_mat3x3f_from_euler_xyx_states(angles_states, R_states);
    ksl_statesf_to_planes(R_states, 9, R + i * R_stride, R_plane, R_stride, last);
  }
#else
  ksl_vec3f_t angles_i;
  if (n > 0) angles_i = ksl_vec3f_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3f_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_euler_xyx(&angles_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
#endif
}

static KSL_INLINED void ksl_mat3x3f_from_euler_xyx_many(ptrdiff_t n, const ksl_vec3f_t *angles,
    ptrdiff_t angles_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  ksl_mat3x3f_from_euler_xyx_planes(n, (const float *)angles, 1, 3 * angles_stride, (float *)R, 1,
      9 * R_stride);
}

#if KSL_LANE_BYTES
/* ksl_euler_xyx_from_mat3x3f of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_euler_xyx_from_mat3x3f_states(const ksl_statesf *R, ksl_statesf *angles) {
  const ksl_statesf n_a = KSL_RN_LANESF(R[3] * R[3]), n_b = KSL_RN_LANESF(R[6] * R[6]), n_c = n_a +
      n_b,
      n = ksl_sqrt_lanesf(n_c);
  const ksl_testsf divisor_a = ksl_equal_lanesf(n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf cosine_a = R[6] / divisor,
      cosine = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), cosine_a);
  const ksl_statesf sine = R[3] / divisor;
  const ksl_statesf polar = ksl_atan2_lanesf(R[3], R[6]);
  const ksl_statesf third = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(0.0f), polar);
  const ksl_statesf left_1a = KSL_RN_LANESF(R[4] * cosine), left_1b = KSL_RN_LANESF(R[7] * sine);
  const ksl_statesf left_2a = KSL_RN_LANESF(R[5] * cosine), left_2b = KSL_RN_LANESF(R[8] * sine);
  const ksl_statesf rest = R[1] + R[2];
  const ksl_statesf first = ksl_atan2_lanesf(left_2a - left_2b, left_1a - left_1b);
  const ksl_testsf angles_0a = ksl_less_lanesf(rest, ksl_each_lanesf(1.2676506e+30f));
  const ksl_statesf angles_1 = ksl_choice_lanesf(angles_0a, first, rest);
  const ksl_statesf angles_2 = ksl_atan2_lanesf(n, R[0]);
  angles[0] = angles_1;
  angles[1] = angles_2;
  angles[2] = third;
}
#endif

/* ksl_euler_xyx_from_mat3x3f of n elements. */
static KSL_INLINED void ksl_euler_xyx_from_mat3x3f_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *angles, ptrdiff_t angles_plane,
    ptrdiff_t angles_stride) {
#if KSL_LANE_BYTES
  ksl_statesf R_states[9], angles_states[3];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(R + i * R_stride, 9, R_plane, R_stride, last, R_states);
    ksl_euler_xyx_from_mat3x3f_states(R_states, angles_states);
    ksl_statesf_to_planes(angles_states, 3, angles + i * angles_stride, angles_plane, angles_stride,
        last);
  }
#else
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t angles_i;
    ksl_euler_xyx_from_mat3x3f(&R_i, &angles_i);
    ksl_vec3f_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
#endif
}

static KSL_INLINED void ksl_euler_xyx_from_mat3x3f_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_vec3f_t *angles, ptrdiff_t angles_stride) {
  ksl_euler_xyx_from_mat3x3f_planes(n, (const float *)R, 1, 9 * R_stride, (float *)angles, 1,
      3 * angles_stride);
}

/* ksl_mat3x3f_jacobi of n elements. */
static KSL_INLINED void ksl_mat3x3f_jacobi_many(ptrdiff_t n, ksl_mat3x3f_t *A, ptrdiff_t A_stride,
    ksl_mat3x3f_t *V, ptrdiff_t V_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_jacobi(A + i * A_stride, V + i * V_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_jacobi_planes(ptrdiff_t n, float *A, ptrdiff_t A_plane,
    ptrdiff_t A_stride, float *V, ptrdiff_t V_plane, ptrdiff_t V_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t A_i = ksl_mat3x3f_of_planes(A + i * A_stride, A_plane);
    ksl_mat3x3f_t V_i = ksl_mat3x3f_of_planes(V + i * V_stride, V_plane);
    ksl_mat3x3f_jacobi(&A_i, &V_i);
    ksl_mat3x3f_to_planes(&A_i, A + i * A_stride, A_plane);
    ksl_mat3x3f_to_planes(&V_i, V + i * V_stride, V_plane);
  }
}

/* ksl_mat3x3f_rotation_defect of n elements. */
static KSL_INLINED void ksl_mat3x3f_rotation_defect_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, float *defect, ptrdiff_t defect_stride) {
  KSL_EACH_OF(n) {
    defect[i * defect_stride] = ksl_mat3x3f_rotation_defect(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_rotation_defect_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *defect,
    ptrdiff_t defect_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    defect[i * defect_stride] = ksl_mat3x3f_rotation_defect(&R_i);
  }
}

/* ksl_mat3x3f_nearest_rotation of n elements. */
static KSL_INLINED void ksl_mat3x3f_nearest_rotation_many(ptrdiff_t n, const ksl_mat3x3f_t *A,
    ptrdiff_t A_stride, ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_nearest_rotation(A + i * A_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_nearest_rotation_planes(ptrdiff_t n, const float *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, float *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t A_i;
  if (n > 0) A_i = ksl_mat3x3f_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat3x3f_of_planes(A + i * A_stride, A_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_nearest_rotation(&A_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

#if KSL_LANE_BYTES
/* ksl_mat3x3f_from_axis_angle of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_mat3x3f_from_axis_angle_states(const ksl_statesf *axis,
    const ksl_statesf *angle, ksl_statesf *R) {
  ksl_statesf cosine; const ksl_statesf sine = ksl_sincos_lanesf(angle[0], &cosine);
  const ksl_statesf half = 0.5f * angle[0];
  const ksl_statesf h = ksl_sin_lanesf(half);
  const ksl_statesf versine_a = KSL_RN_LANESF(h * h), versine_b = 2.0f * versine_a, versine_c = 1.0f
      - cosine;
  const ksl_testsf versine_d = ksl_less_lanesf(cosine, ksl_each_lanesf(0.0f));
  const ksl_statesf versine = ksl_choice_lanesf(versine_d, versine_c, versine_b);
  const ksl_statesf beta_v_1 = axis[0] * versine;
  const ksl_statesf beta_v_2 = axis[1] * versine;
  const ksl_statesf m_1 = KSL_RN_LANESF(axis[0] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(axis[1] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(axis[2] * (axis[2] * versine));
  const ksl_statesf m_4 = KSL_RN_LANESF(axis[1] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(axis[2] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(axis[2] * beta_v_2);
  const ksl_statesf alpha_v_1 = KSL_RN_LANESF(axis[0] * sine);
  const ksl_statesf alpha_v_2 = KSL_RN_LANESF(axis[1] * sine);
  const ksl_statesf alpha_v_3 = KSL_RN_LANESF(axis[2] * sine);
  const ksl_statesf R_1 = 1.0f - (m_2 + m_3);
  const ksl_statesf R_2 = m_4 - alpha_v_3;
  const ksl_statesf R_3 = m_5 + alpha_v_2;
  const ksl_statesf R_4 = m_4 + alpha_v_3;
  const ksl_statesf R_5 = 1.0f - (m_1 + m_3);
  const ksl_statesf R_6 = m_6 - alpha_v_1;
  const ksl_statesf R_7 = m_5 - alpha_v_2;
  const ksl_statesf R_8 = m_6 + alpha_v_1;
  const ksl_statesf R_9 = 1.0f - (m_1 + m_2);
  R[0] = R_1;
  R[3] = R_2;
  R[6] = R_3;
  R[1] = R_4;
  R[4] = R_5;
  R[7] = R_6;
  R[2] = R_7;
  R[5] = R_8;
  R[8] = R_9;
}
#endif

/* ksl_mat3x3f_from_axis_angle of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_axis_angle_planes(ptrdiff_t n, const float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const float *angle,
    ptrdiff_t angle_stride, float *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
#if KSL_LANE_BYTES
  ksl_statesf axis_states[3], angle_states[1], R_states[9];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(axis + i * axis_stride, 3, axis_plane, axis_stride, last, axis_states);
    ksl_statesf_of_planes(angle + i * angle_stride, 1, 1, angle_stride, last, angle_states);
    ksl_mat3x3f_from_axis_angle_states(axis_states, angle_states, R_states);
    ksl_statesf_to_planes(R_states, 9, R + i * R_stride, R_plane, R_stride, last);
  }
#else
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_axis_angle(&axis_i, angle[i * angle_stride], &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
#endif
}

static KSL_INLINED void ksl_mat3x3f_from_axis_angle_many(ptrdiff_t n, const ksl_vec3f_t *axis,
    ptrdiff_t axis_stride, const float *angle, ptrdiff_t angle_stride,
    ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  ksl_mat3x3f_from_axis_angle_planes(n, (const float *)axis, 1, 3 * axis_stride, angle,
      angle_stride, (float *)R, 1, 9 * R_stride);
}

#if KSL_LANE_BYTES
/* ksl_axis_angle_from_mat3x3f of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_axis_angle_from_mat3x3f_states(const ksl_statesf *R, ksl_statesf *angle,
    ksl_statesf *axis) {
  const ksl_statesf p_1 = R[5] - R[7];
  const ksl_statesf p_2 = R[6] - R[2];
  const ksl_statesf p_3 = R[1] - R[3];
  const ksl_statesf s_1 = R[7] + R[5];
  const ksl_statesf s_2 = R[6] + R[2];
  const ksl_statesf s_3 = R[3] + R[1];
  const ksl_statesf first_1 = R[0] + 1.0f;
  const ksl_statesf first_2 = 1.0f - R[0];
  const ksl_statesf others_1 = R[4] + R[8];
  const ksl_statesf others_2 = R[4] - R[8];
  const ksl_testsf low_0a = ksl_less_lanesf(R[4], R[0]);
  const ksl_statesf high_0a = -R[4];
  const ksl_testsf high_0b = ksl_less_lanesf(R[0], high_0a);
  const ksl_testsf column_0a = ksl_less_lanesf(R[8], ksl_each_lanesf(0.0f));
  const ksl_statesf column_1 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, first_1
          - others_1, s_3), ksl_choice_lanesf(high_0b, s_2, p_1));
  const ksl_statesf column_2 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, s_3, first_2
          + others_2), ksl_choice_lanesf(high_0b, s_1, p_2));
  const ksl_statesf column_3 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, s_2, s_1),
      ksl_choice_lanesf(high_0b, first_2 - others_2, p_3));
  const ksl_statesf column_4 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, p_1, p_2),
      ksl_choice_lanesf(high_0b, p_3, first_1 + others_1));
  const ksl_statesf upper_0a = -column_1;
  const ksl_testsf upper_0b = ksl_less_lanesf(column_4, ksl_each_lanesf(0.0f));
  const ksl_statesf upper_1 = ksl_choice_lanesf(upper_0b, upper_0a, column_1);
  const ksl_statesf upper_1a = -column_2, upper_2 = ksl_choice_lanesf(upper_0b, upper_1a, column_2);
  const ksl_statesf upper_2a = -column_3, upper_3 = ksl_choice_lanesf(upper_0b, upper_2a, column_3);
  const ksl_statesf upper_3a = -column_4;
  const ksl_statesf v_s_size_1 = ksl_abs_lanesf(upper_1);
  const ksl_statesf v_s_size_2 = ksl_abs_lanesf(upper_2);
  const ksl_statesf v_s_size_3 = ksl_abs_lanesf(upper_3);
  const ksl_testsf v_s_largest1a = ksl_less_lanesf(v_s_size_1, v_s_size_2);
  const ksl_statesf v_s_largest1 = ksl_choice_lanesf(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_testsf v_s_largest2a = ksl_less_lanesf(v_s_largest1, v_s_size_3);
  const ksl_statesf v_s_largest2 = ksl_choice_lanesf(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_testsf v_s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), v_s_largest2);
  const ksl_statesf v_s_b = ksl_choice_lanesf(v_s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_s_c = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf v_s_d = ksl_choice_lanesf(v_s_c, ksl_each_lanesf(1.8014399e+16f), v_s_b);
  const ksl_testsf v_s_e = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf v_s = ksl_choice_lanesf(v_s_e, ksl_each_lanesf(3.2451855e+32f), v_s_d);
  const ksl_statesf v_y_1 = upper_1 * v_s;
  const ksl_statesf v_y_2 = upper_2 * v_s;
  const ksl_statesf v_y_3 = upper_3 * v_s;
  const ksl_statesf v_n_a = KSL_RN_LANESF(v_y_1 * v_y_1), v_n_b = KSL_RN_LANESF(v_y_2 * v_y_2),
      v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_RN_LANESF(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanesf(v_n_e);
  const ksl_testsf v_r_a = ksl_less_lanesf(v_s, ksl_each_lanesf(1.0f));
  const ksl_statesf v_r_b = ksl_choice_lanesf(v_r_a, ksl_each_lanesf(3.689349e+19f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_r_c = ksl_less_lanesf(ksl_each_lanesf(1.0f), v_s);
  const ksl_statesf v_r_d = ksl_choice_lanesf(v_r_c, ksl_each_lanesf(5.551115e-17f), v_r_b);
  const ksl_testsf v_r_e = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), v_s);
  const ksl_statesf v_r = ksl_choice_lanesf(v_r_e, ksl_each_lanesf(3.081488e-33f), v_r_d);
  const ksl_statesf n = v_n * v_r;
  const ksl_statesf half = ksl_atan2_lanesf(n, ksl_choice_lanesf(upper_0b, upper_3a, column_4));
  const ksl_testsf divisor_a = ksl_equal_lanesf(v_n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), v_n);
  const ksl_statesf unit_1 = v_y_2 / divisor;
  const ksl_statesf unit_2 = v_y_3 / divisor;
  const ksl_statesf angle_ = KSL_RN_LANESF(2.0f * half);
  const ksl_statesf axis_1 = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), v_y_1 / divisor);
  angle[0] = angle_;
  axis[0] = axis_1;
  axis[1] = unit_1;
  axis[2] = unit_2;
}
#endif

/* ksl_axis_angle_from_mat3x3f of n elements. */
static KSL_INLINED void ksl_axis_angle_from_mat3x3f_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
#if KSL_LANE_BYTES
  ksl_statesf R_states[9], axis_states[3], angle_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(R + i * R_stride, 9, R_plane, R_stride, last, R_states);
    ksl_axis_angle_from_mat3x3f_states(R_states, angle_states, axis_states);
    ksl_statesf_to_planes(axis_states, 3, axis + i * axis_stride, axis_plane, axis_stride, last);
    ksl_statesf_to_planes(angle_states, 1, angle + i * angle_stride, 1, angle_stride, last);
  }
#else
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3f(&R_i, &axis_i);
    ksl_vec3f_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
#endif
}

static KSL_INLINED void ksl_axis_angle_from_mat3x3f_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_vec3f_t *axis, ptrdiff_t axis_stride, float *angle,
    ptrdiff_t angle_stride) {
  ksl_axis_angle_from_mat3x3f_planes(n, (const float *)R, 1, 9 * R_stride, (float *)axis, 1,
      3 * axis_stride, angle, angle_stride);
}

#endif
