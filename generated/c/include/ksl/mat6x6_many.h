/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MAT6X6_MANY_H
#define KSL_MAT6X6_MANY_H

#include "mat6x6.h"
#include "ksl_planes.h"

/* ksl_mat6x6_copy of n elements. */
static KSL_INLINED void ksl_mat6x6_copy_many(ptrdiff_t n, const ksl_mat6x6_t *M, ptrdiff_t M_stride,
    ksl_mat6x6_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6_copy(M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_copy_planes(ptrdiff_t n, const double *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride, double *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_mat6x6_t M_i;
  if (n > 0) M_i = ksl_mat6x6_of_planes(M, M_plane);
  KSL_EACH_OF(n) {
    if (M_stride) M_i = ksl_mat6x6_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6_t Mo_i;
    ksl_mat6x6_copy(&M_i, &Mo_i);
    ksl_mat6x6_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6_setIdentity of n elements. */
static KSL_INLINED void ksl_mat6x6_setIdentity_many(ptrdiff_t n, ksl_mat6x6_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_setIdentity_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6_t self_i = ksl_mat6x6_of_planes(self + i * self_stride, self_plane);
    ksl_mat6x6_setIdentity(&self_i);
    ksl_mat6x6_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat6x6_transposed of n elements. */
static KSL_INLINED void ksl_mat6x6_transposed_many(ptrdiff_t n, const ksl_mat6x6_t *M,
    ptrdiff_t M_stride, ksl_mat6x6_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6_transposed(M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_transposed_planes(ptrdiff_t n, const double *M,
    ptrdiff_t M_plane, ptrdiff_t M_stride, double *Mo, ptrdiff_t Mo_plane,
    ptrdiff_t Mo_stride) {
  ksl_mat6x6_t M_i;
  if (n > 0) M_i = ksl_mat6x6_of_planes(M, M_plane);
  KSL_EACH_OF(n) {
    if (M_stride) M_i = ksl_mat6x6_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6_t Mo_i;
    ksl_mat6x6_transposed(&M_i, &Mo_i);
    ksl_mat6x6_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6_rotated of n elements. */
static KSL_INLINED void ksl_mat6x6_rotated_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_mat6x6_t *M, ptrdiff_t M_stride,
    ksl_mat6x6_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6_rotated(R + i * R_stride, M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_rotated_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *M, ptrdiff_t M_plane, ptrdiff_t M_stride,
    double *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_mat6x6_t M_i = ksl_mat6x6_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6_t Mo_i;
    ksl_mat6x6_rotated(&R_i, &M_i, &Mo_i);
    ksl_mat6x6_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6_shifted of n elements. */
static KSL_INLINED void ksl_mat6x6_shifted_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_mat6x6_t *M, ptrdiff_t M_stride,
    ksl_mat6x6_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6_shifted(t + i * t_stride, M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_shifted_planes(ptrdiff_t n, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const double *M, ptrdiff_t M_plane, ptrdiff_t M_stride,
    double *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_mat6x6_t M_i = ksl_mat6x6_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6_t Mo_i;
    ksl_mat6x6_shifted(&t_i, &M_i, &Mo_i);
    ksl_mat6x6_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6f_copy of n elements. */
static KSL_INLINED void ksl_mat6x6f_copy_many(ptrdiff_t n, const ksl_mat6x6f_t *M,
    ptrdiff_t M_stride, ksl_mat6x6f_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6f_copy(M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_copy_planes(ptrdiff_t n, const float *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride, float *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_mat6x6f_t M_i;
  if (n > 0) M_i = ksl_mat6x6f_of_planes(M, M_plane);
  KSL_EACH_OF(n) {
    if (M_stride) M_i = ksl_mat6x6f_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6f_t Mo_i;
    ksl_mat6x6f_copy(&M_i, &Mo_i);
    ksl_mat6x6f_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6f_setIdentity of n elements. */
static KSL_INLINED void ksl_mat6x6f_setIdentity_many(ptrdiff_t n, ksl_mat6x6f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6f_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_setIdentity_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6f_t self_i = ksl_mat6x6f_of_planes(self + i * self_stride, self_plane);
    ksl_mat6x6f_setIdentity(&self_i);
    ksl_mat6x6f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat6x6f_transposed of n elements. */
static KSL_INLINED void ksl_mat6x6f_transposed_many(ptrdiff_t n, const ksl_mat6x6f_t *M,
    ptrdiff_t M_stride, ksl_mat6x6f_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6f_transposed(M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_transposed_planes(ptrdiff_t n, const float *M,
    ptrdiff_t M_plane, ptrdiff_t M_stride, float *Mo, ptrdiff_t Mo_plane,
    ptrdiff_t Mo_stride) {
  ksl_mat6x6f_t M_i;
  if (n > 0) M_i = ksl_mat6x6f_of_planes(M, M_plane);
  KSL_EACH_OF(n) {
    if (M_stride) M_i = ksl_mat6x6f_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6f_t Mo_i;
    ksl_mat6x6f_transposed(&M_i, &Mo_i);
    ksl_mat6x6f_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6f_rotated of n elements. */
static KSL_INLINED void ksl_mat6x6f_rotated_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_mat6x6f_t *M, ptrdiff_t M_stride,
    ksl_mat6x6f_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6f_rotated(R + i * R_stride, M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_rotated_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *M, ptrdiff_t M_plane, ptrdiff_t M_stride,
    float *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_mat6x6f_t M_i = ksl_mat6x6f_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6f_t Mo_i;
    ksl_mat6x6f_rotated(&R_i, &M_i, &Mo_i);
    ksl_mat6x6f_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_mat6x6f_shifted of n elements. */
static KSL_INLINED void ksl_mat6x6f_shifted_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_mat6x6f_t *M, ptrdiff_t M_stride,
    ksl_mat6x6f_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6f_shifted(t + i * t_stride, M + i * M_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_shifted_planes(ptrdiff_t n, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const float *M, ptrdiff_t M_plane, ptrdiff_t M_stride,
    float *Mo, ptrdiff_t Mo_plane, ptrdiff_t Mo_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_mat6x6f_t M_i = ksl_mat6x6f_of_planes(M + i * M_stride, M_plane);
    ksl_mat6x6f_t Mo_i;
    ksl_mat6x6f_shifted(&t_i, &M_i, &Mo_i);
    ksl_mat6x6f_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

#endif
