/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_EXPONENTIAL_FUSED_MANY_H
#define KSL_EXPONENTIAL_FUSED_MANY_H

#include "exponential_fused.h"
#include "ksl_planes.h"

/* ksl_mat3x3_orthonormalize_fused of n elements. */
static KSL_INLINED void ksl_mat3x3_orthonormalize_fused_many(ptrdiff_t n, ksl_mat3x3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_orthonormalize_fused(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_orthonormalize_fused_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_t self_i = ksl_mat3x3_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3_orthonormalize_fused(&self_i);
    ksl_mat3x3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3_orthonormalized_fused of n elements. */
static KSL_INLINED void ksl_mat3x3_orthonormalized_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_orthonormalized_fused(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_orthonormalized_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_orthonormalized_fused(&R_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_mat3x3f_orthonormalize_fused of n elements. */
static KSL_INLINED void ksl_mat3x3f_orthonormalize_fused_many(ptrdiff_t n, ksl_mat3x3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_orthonormalize_fused(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_orthonormalize_fused_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t self_i = ksl_mat3x3f_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3f_orthonormalize_fused(&self_i);
    ksl_mat3x3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3f_orthonormalized_fused of n elements. */
static KSL_INLINED void ksl_mat3x3f_orthonormalized_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_orthonormalized_fused(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_orthonormalized_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_orthonormalized_fused(&R_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

#endif
