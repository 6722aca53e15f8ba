/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MAT3X3_FUSED_MANY_H
#define KSL_MAT3X3_FUSED_MANY_H

#include "mat3x3_fused.h"
#include "ksl_planes.h"

/* ksl_acceleration_tensor_fused of n elements. */
static KSL_INLINED void ksl_acceleration_tensor_fused_many(ptrdiff_t n, const ksl_vec3_t *w,
    ptrdiff_t w_stride, const ksl_vec3_t *dw, ptrdiff_t dw_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_acceleration_tensor_fused(w + i * w_stride, dw + i * dw_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_acceleration_tensor_fused_planes(ptrdiff_t n, const double *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const double *dw, ptrdiff_t dw_plane,
    ptrdiff_t dw_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_vec3_t w_i;
  if (n > 0) w_i = ksl_vec3_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3_of_planes(w + i * w_stride, w_plane);
    const ksl_vec3_t dw_i = ksl_vec3_of_planes(dw + i * dw_stride, dw_plane);
    ksl_mat3x3_t Ro_i;
    ksl_acceleration_tensor_fused(&w_i, &dw_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3_determinant_fused of n elements. */
static KSL_INLINED void ksl_mat3x3_determinant_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, double *det, ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3_determinant_fused(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_determinant_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *det, ptrdiff_t det_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    det[i * det_stride] = ksl_mat3x3_determinant_fused(&R_i);
  }
}

/* ksl_mat3x3_setFromAxisDC_fused of n elements. */
static KSL_INLINED void ksl_mat3x3_setFromAxisDC_fused_many(ptrdiff_t n, ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *axis, ptrdiff_t axis_stride,
    const double *dc, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_setFromAxisDC_fused(R + i * R_stride, axis + i * axis_stride, dc + 2 * i * dc_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_setFromAxisDC_fused_planes(ptrdiff_t n, double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const double *dc,
    ptrdiff_t dc_plane, ptrdiff_t dc_stride) {
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    ksl_mat3x3_t R_i;
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_setFromAxisDC_fused(&R_i, &axis_i, dc_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_acceleration_tensorf_fused of n elements. */
static KSL_INLINED void ksl_acceleration_tensorf_fused_many(ptrdiff_t n, const ksl_vec3f_t *w,
    ptrdiff_t w_stride, const ksl_vec3f_t *dw, ptrdiff_t dw_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_acceleration_tensorf_fused(w + i * w_stride, dw + i * dw_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_acceleration_tensorf_fused_planes(ptrdiff_t n, const float *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const float *dw, ptrdiff_t dw_plane,
    ptrdiff_t dw_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_vec3f_t w_i;
  if (n > 0) w_i = ksl_vec3f_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3f_of_planes(w + i * w_stride, w_plane);
    const ksl_vec3f_t dw_i = ksl_vec3f_of_planes(dw + i * dw_stride, dw_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_acceleration_tensorf_fused(&w_i, &dw_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_determinant_fused of n elements. */
static KSL_INLINED void ksl_mat3x3f_determinant_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, float *det, ptrdiff_t det_stride) {
  KSL_EACH_OF(n) {
    det[i * det_stride] = ksl_mat3x3f_determinant_fused(R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_determinant_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *det, ptrdiff_t det_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    det[i * det_stride] = ksl_mat3x3f_determinant_fused(&R_i);
  }
}

/* ksl_mat3x3f_setFromAxisDC_fused of n elements. */
static KSL_INLINED void ksl_mat3x3f_setFromAxisDC_fused_many(ptrdiff_t n, ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *axis, ptrdiff_t axis_stride,
    const float *dc, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_setFromAxisDC_fused(R + i * R_stride, axis + i * axis_stride,
        dc + 2 * i * dc_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_setFromAxisDC_fused_planes(ptrdiff_t n, float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const float *dc,
    ptrdiff_t dc_plane, ptrdiff_t dc_stride) {
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t R_i;
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_setFromAxisDC_fused(&R_i, &axis_i, dc_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

#endif
