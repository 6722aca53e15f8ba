/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MAT3X3_MANY_H
#define KSL_MAT3X3_MANY_H

#include "mat3x3.h"
#include "ksl_planes.h"

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

/* ksl_mat3x3_from_euler_xyz of n elements. */
static KSL_INLINED void ksl_mat3x3_from_euler_xyz_many(ptrdiff_t n, const ksl_vec3_t *angles,
    ptrdiff_t angles_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_from_euler_xyz(angles + i * angles_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_from_euler_xyz_planes(ptrdiff_t n, const double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3_t angles_i;
  if (n > 0) angles_i = ksl_vec3_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_euler_xyz(&angles_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_euler_xyz_from_mat3x3 of n elements. */
static KSL_INLINED void ksl_euler_xyz_from_mat3x3_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *angles, ptrdiff_t angles_stride) {
  KSL_EACH_OF(n) {
    ksl_euler_xyz_from_mat3x3(R + i * R_stride, angles + i * angles_stride);
  }
}

static KSL_INLINED void ksl_euler_xyz_from_mat3x3_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t angles_i;
    ksl_euler_xyz_from_mat3x3(&R_i, &angles_i);
    ksl_vec3_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
}

/* ksl_mat3x3_from_euler_xyx of n elements. */
static KSL_INLINED void ksl_mat3x3_from_euler_xyx_many(ptrdiff_t n, const ksl_vec3_t *angles,
    ptrdiff_t angles_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_from_euler_xyx(angles + i * angles_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_from_euler_xyx_planes(ptrdiff_t n, const double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3_t angles_i;
  if (n > 0) angles_i = ksl_vec3_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_euler_xyx(&angles_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_euler_xyx_from_mat3x3 of n elements. */
static KSL_INLINED void ksl_euler_xyx_from_mat3x3_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *angles, ptrdiff_t angles_stride) {
  KSL_EACH_OF(n) {
    ksl_euler_xyx_from_mat3x3(R + i * R_stride, angles + i * angles_stride);
  }
}

static KSL_INLINED void ksl_euler_xyx_from_mat3x3_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t angles_i;
    ksl_euler_xyx_from_mat3x3(&R_i, &angles_i);
    ksl_vec3_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
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

/* ksl_mat3x3_from_axis_angle of n elements. */
static KSL_INLINED void ksl_mat3x3_from_axis_angle_many(ptrdiff_t n, const ksl_vec3_t *axis,
    ptrdiff_t axis_stride, const double *angle, ptrdiff_t angle_stride,
    ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_from_axis_angle(axis + i * axis_stride, angle[i * angle_stride], R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_from_axis_angle_planes(ptrdiff_t n, const double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const double *angle,
    ptrdiff_t angle_stride, double *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_axis_angle(&axis_i, angle[i * angle_stride], &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_axis_angle_from_mat3x3 of n elements. */
static KSL_INLINED void ksl_axis_angle_from_mat3x3_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *axis, ptrdiff_t axis_stride, double *angle,
    ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3(R + i * R_stride, axis + i * axis_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_mat3x3_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *angle, ptrdiff_t angle_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3(&R_i, &axis_i);
    ksl_vec3_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
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

/* ksl_mat3x3f_from_euler_xyz of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_euler_xyz_many(ptrdiff_t n, const ksl_vec3f_t *angles,
    ptrdiff_t angles_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_from_euler_xyz(angles + i * angles_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_from_euler_xyz_planes(ptrdiff_t n, const float *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3f_t angles_i;
  if (n > 0) angles_i = ksl_vec3f_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3f_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_euler_xyz(&angles_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_euler_xyz_from_mat3x3f of n elements. */
static KSL_INLINED void ksl_euler_xyz_from_mat3x3f_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_vec3f_t *angles, ptrdiff_t angles_stride) {
  KSL_EACH_OF(n) {
    ksl_euler_xyz_from_mat3x3f(R + i * R_stride, angles + i * angles_stride);
  }
}

static KSL_INLINED void ksl_euler_xyz_from_mat3x3f_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *angles, ptrdiff_t angles_plane,
    ptrdiff_t angles_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t angles_i;
    ksl_euler_xyz_from_mat3x3f(&R_i, &angles_i);
    ksl_vec3f_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
}

/* ksl_mat3x3f_from_euler_xyx of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_euler_xyx_many(ptrdiff_t n, const ksl_vec3f_t *angles,
    ptrdiff_t angles_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_from_euler_xyx(angles + i * angles_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_from_euler_xyx_planes(ptrdiff_t n, const float *angles,
    ptrdiff_t angles_plane, ptrdiff_t angles_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3f_t angles_i;
  if (n > 0) angles_i = ksl_vec3f_of_planes(angles, angles_plane);
  KSL_EACH_OF(n) {
    if (angles_stride) angles_i = ksl_vec3f_of_planes(angles + i * angles_stride, angles_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_euler_xyx(&angles_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_euler_xyx_from_mat3x3f of n elements. */
static KSL_INLINED void ksl_euler_xyx_from_mat3x3f_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_vec3f_t *angles, ptrdiff_t angles_stride) {
  KSL_EACH_OF(n) {
    ksl_euler_xyx_from_mat3x3f(R + i * R_stride, angles + i * angles_stride);
  }
}

static KSL_INLINED void ksl_euler_xyx_from_mat3x3f_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *angles, ptrdiff_t angles_plane,
    ptrdiff_t angles_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t angles_i;
    ksl_euler_xyx_from_mat3x3f(&R_i, &angles_i);
    ksl_vec3f_to_planes(&angles_i, angles + i * angles_stride, angles_plane);
  }
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

/* ksl_mat3x3f_from_axis_angle of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_axis_angle_many(ptrdiff_t n, const ksl_vec3f_t *axis,
    ptrdiff_t axis_stride, const float *angle, ptrdiff_t angle_stride,
    ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_from_axis_angle(axis + i * axis_stride, angle[i * angle_stride], R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_from_axis_angle_planes(ptrdiff_t n, const float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const float *angle,
    ptrdiff_t angle_stride, float *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_axis_angle(&axis_i, angle[i * angle_stride], &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_axis_angle_from_mat3x3f of n elements. */
static KSL_INLINED void ksl_axis_angle_from_mat3x3f_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_vec3f_t *axis, ptrdiff_t axis_stride, float *angle,
    ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3f(R + i * R_stride, axis + i * axis_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_mat3x3f_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_mat3x3f(&R_i, &axis_i);
    ksl_vec3f_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
}

#endif
