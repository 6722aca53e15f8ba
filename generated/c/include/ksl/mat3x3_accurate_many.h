/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MAT3X3_ACCURATE_MANY_H
#define KSL_MAT3X3_ACCURATE_MANY_H

#include "mat3x3_accurate.h"
#include "ksl_planes.h"

/* ksl_acceleration_tensor_accurate of n elements. */
static KSL_INLINED void ksl_acceleration_tensor_accurate_many(ptrdiff_t n, const ksl_vec3_t *w,
    ptrdiff_t w_stride, const ksl_vec3_t *dw, ptrdiff_t dw_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_acceleration_tensor_accurate(w + i * w_stride, dw + i * dw_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_acceleration_tensor_accurate_planes(ptrdiff_t n, const double *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const double *dw, ptrdiff_t dw_plane,
    ptrdiff_t dw_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_vec3_t w_i;
  if (n > 0) w_i = ksl_vec3_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3_of_planes(w + i * w_stride, w_plane);
    const ksl_vec3_t dw_i = ksl_vec3_of_planes(dw + i * dw_stride, dw_plane);
    ksl_mat3x3_t Ro_i;
    ksl_acceleration_tensor_accurate(&w_i, &dw_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3_determinant_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_determinant_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, double *det, ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3_determinant_accurate(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_determinant_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *det, ptrdiff_t det_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    det[i * det_stride] = ksl_mat3x3_determinant_accurate(&R_i);
  }
}

/* ksl_mat3x3_inverse_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_inverse_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride, double *det,
    ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3_inverse_accurate(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_inverse_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride, double *det, ptrdiff_t det_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3_t Ro_i;
    det[i * det_stride] = ksl_mat3x3_inverse_accurate(&R_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3_normalize_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_normalize_accurate_many(ptrdiff_t n, ksl_mat3x3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_normalize_accurate(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_normalize_accurate_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_t self_i = ksl_mat3x3_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3_normalize_accurate(&self_i);
    ksl_mat3x3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3_normalized_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_normalized_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_normalized_accurate(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_normalized_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_normalized_accurate(&R_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3_setFromAxisDC_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_setFromAxisDC_accurate_many(ptrdiff_t n, ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *axis, ptrdiff_t axis_stride,
    const double *dc, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_setFromAxisDC_accurate(R + i * R_stride, axis + i * axis_stride,
        dc + 2 * i * dc_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_setFromAxisDC_accurate_planes(ptrdiff_t n, double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const double *dc,
    ptrdiff_t dc_plane, ptrdiff_t dc_stride) {
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    ksl_mat3x3_t R_i;
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_setFromAxisDC_accurate(&R_i, &axis_i, dc_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_mat3x3_from_euler_xyz_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_from_euler_xyz_accurate_many(ptrdiff_t n,
    const ksl_vec3_t *angles, ptrdiff_t angles_stride, ksl_mat3x3_t *R,
    ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_from_euler_xyz_accurate(angles + i * angles_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_from_euler_xyz_accurate_planes(ptrdiff_t n, const double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3_t angles_i;
  if (n > 0) angles_i = ksl_vec3_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_euler_xyz_accurate(&angles_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_euler_xyz_from_mat3x3_accurate of n elements. */
static KSL_INLINED void ksl_euler_xyz_from_mat3x3_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *angles, ptrdiff_t angles_stride) {
  KSL_EACH_OF(n) {
    ksl_euler_xyz_from_mat3x3_accurate(R + i * R_stride, angles + i * angles_stride);
  }
}

static KSL_INLINED void ksl_euler_xyz_from_mat3x3_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t angles_i;
    ksl_euler_xyz_from_mat3x3_accurate(&R_i, &angles_i);
    ksl_vec3_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
}

/* ksl_mat3x3_from_euler_xyx_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_from_euler_xyx_accurate_many(ptrdiff_t n,
    const ksl_vec3_t *angles, ptrdiff_t angles_stride, ksl_mat3x3_t *R,
    ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_from_euler_xyx_accurate(angles + i * angles_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_from_euler_xyx_accurate_planes(ptrdiff_t n, const double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3_t angles_i;
  if (n > 0) angles_i = ksl_vec3_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_euler_xyx_accurate(&angles_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_euler_xyx_from_mat3x3_accurate of n elements. */
static KSL_INLINED void ksl_euler_xyx_from_mat3x3_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *angles, ptrdiff_t angles_stride) {
  KSL_EACH_OF(n) {
    ksl_euler_xyx_from_mat3x3_accurate(R + i * R_stride, angles + i * angles_stride);
  }
}

static KSL_INLINED void ksl_euler_xyx_from_mat3x3_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t angles_i;
    ksl_euler_xyx_from_mat3x3_accurate(&R_i, &angles_i);
    ksl_vec3_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
}

/* ksl_mat3x3_jacobi_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_jacobi_accurate_many(ptrdiff_t n, ksl_mat3x3_t *A,
    ptrdiff_t A_stride, ksl_mat3x3_t *V, ptrdiff_t V_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_jacobi_accurate(A + i * A_stride, V + i * V_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_jacobi_accurate_planes(ptrdiff_t n, double *A, ptrdiff_t A_plane,
    ptrdiff_t A_stride, double *V, ptrdiff_t V_plane, ptrdiff_t V_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_t A_i = ksl_mat3x3_of_planes(A + i * A_stride, A_plane);
    ksl_mat3x3_t V_i = ksl_mat3x3_of_planes(V + i * V_stride, V_plane);
    ksl_mat3x3_jacobi_accurate(&A_i, &V_i);
    ksl_mat3x3_to_planes(&A_i, A + i * A_stride, A_plane);
    ksl_mat3x3_to_planes(&V_i, V + i * V_stride, V_plane);
  }
}

/* ksl_mat3x3_rotation_defect_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_rotation_defect_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, double *defect, ptrdiff_t defect_stride) {
  KSL_EACH_OF(n) {
    defect[i * defect_stride] = ksl_mat3x3_rotation_defect_accurate(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_rotation_defect_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *defect,
    ptrdiff_t defect_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    defect[i * defect_stride] = ksl_mat3x3_rotation_defect_accurate(&R_i);
  }
}

/* ksl_mat3x3_from_axis_angle_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_from_axis_angle_accurate_many(ptrdiff_t n,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, const double *angle,
    ptrdiff_t angle_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_from_axis_angle_accurate(axis + i * axis_stride, angle[i * angle_stride],
        R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_from_axis_angle_accurate_planes(ptrdiff_t n, const double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const double *angle,
    ptrdiff_t angle_stride, double *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_axis_angle_accurate(&axis_i, angle[i * angle_stride], &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_axis_angle_from_mat3x3_accurate of n elements. */
static KSL_INLINED void ksl_axis_angle_from_mat3x3_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *axis, ptrdiff_t axis_stride, double *angle,
    ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3_accurate(R + i * R_stride,
        axis + i * axis_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_mat3x3_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *angle, ptrdiff_t angle_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3_accurate(&R_i, &axis_i);
    ksl_vec3_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
}

/* ksl_acceleration_tensorf_accurate of n elements. */
static KSL_INLINED void ksl_acceleration_tensorf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *w,
    ptrdiff_t w_stride, const ksl_vec3f_t *dw, ptrdiff_t dw_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_acceleration_tensorf_accurate(w + i * w_stride, dw + i * dw_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_acceleration_tensorf_accurate_planes(ptrdiff_t n, const float *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const float *dw, ptrdiff_t dw_plane,
    ptrdiff_t dw_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_vec3f_t w_i;
  if (n > 0) w_i = ksl_vec3f_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3f_of_planes(w + i * w_stride, w_plane);
    const ksl_vec3f_t dw_i = ksl_vec3f_of_planes(dw + i * dw_stride, dw_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_acceleration_tensorf_accurate(&w_i, &dw_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_determinant_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_determinant_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, float *det, ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3f_determinant_accurate(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_determinant_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *det, ptrdiff_t det_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    det[i * det_stride] = ksl_mat3x3f_determinant_accurate(&R_i);
  }
}

/* ksl_mat3x3f_inverse_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_inverse_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride, float *det,
    ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3f_inverse_accurate(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_inverse_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride, float *det, ptrdiff_t det_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3f_t Ro_i;
    det[i * det_stride] = ksl_mat3x3f_inverse_accurate(&R_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_normalize_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_normalize_accurate_many(ptrdiff_t n, ksl_mat3x3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_normalize_accurate(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_normalize_accurate_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t self_i = ksl_mat3x3f_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3f_normalize_accurate(&self_i);
    ksl_mat3x3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3f_normalized_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_normalized_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_normalized_accurate(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_normalized_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_normalized_accurate(&R_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_setFromAxisDC_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_setFromAxisDC_accurate_many(ptrdiff_t n, ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *axis, ptrdiff_t axis_stride,
    const float *dc, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_setFromAxisDC_accurate(R + i * R_stride, axis + i * axis_stride,
        dc + 2 * i * dc_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_setFromAxisDC_accurate_planes(ptrdiff_t n, float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const float *dc,
    ptrdiff_t dc_plane, ptrdiff_t dc_stride) {
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t R_i;
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_setFromAxisDC_accurate(&R_i, &axis_i, dc_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_mat3x3f_from_euler_xyz_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_euler_xyz_accurate_many(ptrdiff_t n,
    const ksl_vec3f_t *angles, ptrdiff_t angles_stride, ksl_mat3x3f_t *R,
    ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_from_euler_xyz_accurate(angles + i * angles_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_from_euler_xyz_accurate_planes(ptrdiff_t n, const float *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3f_t angles_i;
  if (n > 0) angles_i = ksl_vec3f_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3f_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_euler_xyz_accurate(&angles_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_euler_xyz_from_mat3x3f_accurate of n elements. */
static KSL_INLINED void ksl_euler_xyz_from_mat3x3f_accurate_many(ptrdiff_t n,
    const ksl_mat3x3f_t *R, ptrdiff_t R_stride, ksl_vec3f_t *angles,
    ptrdiff_t angles_stride) {
  KSL_EACH_OF(n) {
    ksl_euler_xyz_from_mat3x3f_accurate(R + i * R_stride, angles + i * angles_stride);
  }
}

static KSL_INLINED void ksl_euler_xyz_from_mat3x3f_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *angles, ptrdiff_t angles_plane,
    ptrdiff_t angles_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t angles_i;
    ksl_euler_xyz_from_mat3x3f_accurate(&R_i, &angles_i);
    ksl_vec3f_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
}

/* ksl_mat3x3f_from_euler_xyx_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_euler_xyx_accurate_many(ptrdiff_t n,
    const ksl_vec3f_t *angles, ptrdiff_t angles_stride, ksl_mat3x3f_t *R,
    ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_from_euler_xyx_accurate(angles + i * angles_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_from_euler_xyx_accurate_planes(ptrdiff_t n, const float *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3f_t angles_i;
  if (n > 0) angles_i = ksl_vec3f_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3f_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_euler_xyx_accurate(&angles_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_euler_xyx_from_mat3x3f_accurate of n elements. */
static KSL_INLINED void ksl_euler_xyx_from_mat3x3f_accurate_many(ptrdiff_t n,
    const ksl_mat3x3f_t *R, ptrdiff_t R_stride, ksl_vec3f_t *angles,
    ptrdiff_t angles_stride) {
  KSL_EACH_OF(n) {
    ksl_euler_xyx_from_mat3x3f_accurate(R + i * R_stride, angles + i * angles_stride);
  }
}

static KSL_INLINED void ksl_euler_xyx_from_mat3x3f_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *angles, ptrdiff_t angles_plane,
    ptrdiff_t angles_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t angles_i;
    ksl_euler_xyx_from_mat3x3f_accurate(&R_i, &angles_i);
    ksl_vec3f_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
}

/* ksl_mat3x3f_jacobi_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_jacobi_accurate_many(ptrdiff_t n, ksl_mat3x3f_t *A,
    ptrdiff_t A_stride, ksl_mat3x3f_t *V, ptrdiff_t V_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_jacobi_accurate(A + i * A_stride, V + i * V_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_jacobi_accurate_planes(ptrdiff_t n, float *A, ptrdiff_t A_plane,
    ptrdiff_t A_stride, float *V, ptrdiff_t V_plane, ptrdiff_t V_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t A_i = ksl_mat3x3f_of_planes(A + i * A_stride, A_plane);
    ksl_mat3x3f_t V_i = ksl_mat3x3f_of_planes(V + i * V_stride, V_plane);
    ksl_mat3x3f_jacobi_accurate(&A_i, &V_i);
    ksl_mat3x3f_to_planes(&A_i, A + i * A_stride, A_plane);
    ksl_mat3x3f_to_planes(&V_i, V + i * V_stride, V_plane);
  }
}

/* ksl_mat3x3f_rotation_defect_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_rotation_defect_accurate_many(ptrdiff_t n,
    const ksl_mat3x3f_t *R, ptrdiff_t R_stride, float *defect,
    ptrdiff_t defect_stride) {
  KSL_EACH_OF(n) {
    defect[i * defect_stride] = ksl_mat3x3f_rotation_defect_accurate(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_rotation_defect_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *defect,
    ptrdiff_t defect_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    defect[i * defect_stride] = ksl_mat3x3f_rotation_defect_accurate(&R_i);
  }
}

/* ksl_mat3x3f_from_axis_angle_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_axis_angle_accurate_many(ptrdiff_t n,
    const ksl_vec3f_t *axis, ptrdiff_t axis_stride, const float *angle,
    ptrdiff_t angle_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_from_axis_angle_accurate(axis + i * axis_stride, angle[i * angle_stride],
        R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_from_axis_angle_accurate_planes(ptrdiff_t n, const float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const float *angle,
    ptrdiff_t angle_stride, float *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_axis_angle_accurate(&axis_i, angle[i * angle_stride], &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_axis_angle_from_mat3x3f_accurate of n elements. */
static KSL_INLINED void ksl_axis_angle_from_mat3x3f_accurate_many(ptrdiff_t n,
    const ksl_mat3x3f_t *R, ptrdiff_t R_stride, ksl_vec3f_t *axis,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3f_accurate(R + i * R_stride,
        axis + i * axis_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_mat3x3f_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3f_accurate(&R_i, &axis_i);
    ksl_vec3f_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
}

#endif
