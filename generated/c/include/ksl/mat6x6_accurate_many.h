/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MAT6X6_ACCURATE_MANY_H
#define KSL_MAT6X6_ACCURATE_MANY_H

#include "mat6x6_accurate.h"
#include "ksl_planes.h"

/* ksl_mat6x6_rotated_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6_rotated_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_mat6x6_t *M, ptrdiff_t M_stride,
    ksl_mat6x6_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6_rotated_accurate(R + i * R_stride, M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_rotated_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride, double *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_mat6x6_t M_i = ksl_mat6x6_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6_t Mo_i;
    ksl_mat6x6_rotated_accurate(&R_i, &M_i, &Mo_i);
    ksl_mat6x6_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6_shifted_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6_shifted_accurate_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_mat6x6_t *M, ptrdiff_t M_stride,
    ksl_mat6x6_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6_shifted_accurate(t + i * t_stride, M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_shifted_accurate_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride, double *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_mat6x6_t M_i = ksl_mat6x6_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6_t Mo_i;
    ksl_mat6x6_shifted_accurate(&t_i, &M_i, &Mo_i);
    ksl_mat6x6_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6f_rotated_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6f_rotated_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_mat6x6f_t *M, ptrdiff_t M_stride,
    ksl_mat6x6f_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6f_rotated_accurate(R + i * R_stride, M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_rotated_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride, float *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_mat6x6f_t M_i = ksl_mat6x6f_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6f_t Mo_i;
    ksl_mat6x6f_rotated_accurate(&R_i, &M_i, &Mo_i);
    ksl_mat6x6f_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6f_shifted_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6f_shifted_accurate_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_mat6x6f_t *M, ptrdiff_t M_stride,
    ksl_mat6x6f_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6f_shifted_accurate(t + i * t_stride, M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_shifted_accurate_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride, float *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_mat6x6f_t M_i = ksl_mat6x6f_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6f_t Mo_i;
    ksl_mat6x6f_shifted_accurate(&t_i, &M_i, &Mo_i);
    ksl_mat6x6f_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

#endif
