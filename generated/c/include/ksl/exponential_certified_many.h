/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_EXPONENTIAL_CERTIFIED_MANY_H
#define KSL_EXPONENTIAL_CERTIFIED_MANY_H

#include "exponential_certified.h"
#include "ksl_planes.h"

/* ksl_SO3_exp_certified of n elements. */
static KSL_INLINED void ksl_SO3_exp_certified_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_mat3x3_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_exp_certified(v + i * v_stride, R + i * R_stride, R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_exp_certified_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_t R_bound_i;
    ksl_SO3_exp_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_SO3_log_certified of n elements. */
static KSL_INLINED void ksl_SO3_log_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride,
    ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_log_certified(R + i * R_stride, vo + i * vo_stride, vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_log_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride, double *vo_bound, ptrdiff_t vo_bound_plane,
    ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_SO3_log_certified(&R_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_SO3_leftJacobian_certified of n elements. */
static KSL_INLINED void ksl_SO3_leftJacobian_certified_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_mat3x3_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_leftJacobian_certified(v + i * v_stride, R + i * R_stride, R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_leftJacobian_certified_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_t R_bound_i;
    ksl_SO3_leftJacobian_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_SO3_rightJacobian_certified of n elements. */
static KSL_INLINED void ksl_SO3_rightJacobian_certified_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_mat3x3_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_rightJacobian_certified(v + i * v_stride, R + i * R_stride,
        R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_rightJacobian_certified_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_t R_bound_i;
    ksl_SO3_rightJacobian_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_SO3_leftJacobianInverse_certified of n elements. */
static KSL_INLINED void ksl_SO3_leftJacobianInverse_certified_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_mat3x3_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_leftJacobianInverse_certified(v + i * v_stride, R + i * R_stride,
        R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_leftJacobianInverse_certified_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_t R_bound_i;
    ksl_SO3_leftJacobianInverse_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_SO3_rightJacobianInverse_certified of n elements. */
static KSL_INLINED void ksl_SO3_rightJacobianInverse_certified_many(ptrdiff_t n,
    const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_mat3x3_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_rightJacobianInverse_certified(v + i * v_stride, R + i * R_stride,
        R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_rightJacobianInverse_certified_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_t R_bound_i;
    ksl_SO3_rightJacobianInverse_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_mat3x3_orthonormalize_certified of n elements. */
static KSL_INLINED void ksl_mat3x3_orthonormalize_certified_many(ptrdiff_t n, ksl_mat3x3_t *self,
    ptrdiff_t self_stride, ksl_mat3x3_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_orthonormalize_certified(self + i * self_stride, self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_orthonormalize_certified_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, double *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_t self_i = ksl_mat3x3_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3_t self_bound_i;
    ksl_mat3x3_orthonormalize_certified(&self_i, &self_bound_i);
    ksl_mat3x3_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_mat3x3_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_mat3x3_orthonormalized_certified of n elements. */
static KSL_INLINED void ksl_mat3x3_orthonormalized_certified_many(ptrdiff_t n,
    const ksl_mat3x3_t *R, ptrdiff_t R_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_orthonormalized_certified(R + i * R_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_orthonormalized_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride, double *Ro_bound, ptrdiff_t Ro_bound_plane,
    ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_mat3x3_orthonormalized_certified(&R_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_SE3_exp_certified of n elements. */
static KSL_INLINED void ksl_SE3_exp_certified_many(ptrdiff_t n, const ksl_screw_t *s,
    ptrdiff_t s_stride, ksl_SE3_t *D, ptrdiff_t D_stride, ksl_SE3_t *D_bound,
    ptrdiff_t D_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_exp_certified(s + i * s_stride, D + i * D_stride, D_bound + i * D_bound_stride);
  }
}

static KSL_INLINED void ksl_SE3_exp_certified_planes(ptrdiff_t n, const double *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *D_bound, ptrdiff_t D_bound_plane,
    ptrdiff_t D_bound_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_SE3_t D_i;
    ksl_SE3_t D_bound_i;
    ksl_SE3_exp_certified(&s_i, &D_i, &D_bound_i);
    ksl_SE3_to_planes(&D_i, D + i * D_stride, D_plane);
    ksl_SE3_to_planes(&D_bound_i, D_bound + i * D_bound_stride, D_bound_plane);
  }
}

/* ksl_SE3_log_certified of n elements. */
static KSL_INLINED void ksl_SE3_log_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_screw_t *so, ptrdiff_t so_stride,
    ksl_screw_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_log_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_SE3_log_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_SE3_log_certified(&D_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_SO3_expf_certified of n elements. */
static KSL_INLINED void ksl_SO3_expf_certified_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_mat3x3f_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_expf_certified(v + i * v_stride, R + i * R_stride, R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_expf_certified_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_t R_bound_i;
    ksl_SO3_expf_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3f_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_SO3_logf_certified of n elements. */
static KSL_INLINED void ksl_SO3_logf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride,
    ksl_vec3f_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_logf_certified(R + i * R_stride, vo + i * vo_stride, vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_logf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride, float *vo_bound, ptrdiff_t vo_bound_plane,
    ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_SO3_logf_certified(&R_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_SO3_leftJacobianf_certified of n elements. */
static KSL_INLINED void ksl_SO3_leftJacobianf_certified_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_mat3x3f_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_leftJacobianf_certified(v + i * v_stride, R + i * R_stride,
        R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_leftJacobianf_certified_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_t R_bound_i;
    ksl_SO3_leftJacobianf_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3f_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_SO3_rightJacobianf_certified of n elements. */
static KSL_INLINED void ksl_SO3_rightJacobianf_certified_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_mat3x3f_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_rightJacobianf_certified(v + i * v_stride, R + i * R_stride,
        R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_rightJacobianf_certified_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_t R_bound_i;
    ksl_SO3_rightJacobianf_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3f_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_SO3_leftJacobianInversef_certified of n elements. */
static KSL_INLINED void ksl_SO3_leftJacobianInversef_certified_many(ptrdiff_t n,
    const ksl_vec3f_t *v, ptrdiff_t v_stride, ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_leftJacobianInversef_certified(v + i * v_stride, R + i * R_stride,
        R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_leftJacobianInversef_certified_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_t R_bound_i;
    ksl_SO3_leftJacobianInversef_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3f_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_SO3_rightJacobianInversef_certified of n elements. */
static KSL_INLINED void ksl_SO3_rightJacobianInversef_certified_many(ptrdiff_t n,
    const ksl_vec3f_t *v, ptrdiff_t v_stride, ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *R_bound, ptrdiff_t R_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_rightJacobianInversef_certified(v + i * v_stride, R + i * R_stride,
        R_bound + i * R_bound_stride);
  }
}

static KSL_INLINED void ksl_SO3_rightJacobianInversef_certified_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *R_bound, ptrdiff_t R_bound_plane,
    ptrdiff_t R_bound_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_t R_bound_i;
    ksl_SO3_rightJacobianInversef_certified(&v_i, &R_i, &R_bound_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
    ksl_mat3x3f_to_planes(&R_bound_i, R_bound + i * R_bound_stride, R_bound_plane);
  }
}

/* ksl_mat3x3f_orthonormalize_certified of n elements. */
static KSL_INLINED void ksl_mat3x3f_orthonormalize_certified_many(ptrdiff_t n, ksl_mat3x3f_t *self,
    ptrdiff_t self_stride, ksl_mat3x3f_t *self_bound,
    ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_orthonormalize_certified(self + i * self_stride, self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_orthonormalize_certified_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, float *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t self_i = ksl_mat3x3f_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3f_t self_bound_i;
    ksl_mat3x3f_orthonormalize_certified(&self_i, &self_bound_i);
    ksl_mat3x3f_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_mat3x3f_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_mat3x3f_orthonormalized_certified of n elements. */
static KSL_INLINED void ksl_mat3x3f_orthonormalized_certified_many(ptrdiff_t n,
    const ksl_mat3x3f_t *R, ptrdiff_t R_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_orthonormalized_certified(R + i * R_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_orthonormalized_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride, float *Ro_bound, ptrdiff_t Ro_bound_plane,
    ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_mat3x3f_orthonormalized_certified(&R_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_SE3f_exp_certified of n elements. */
static KSL_INLINED void ksl_SE3f_exp_certified_many(ptrdiff_t n, const ksl_screwf_t *s,
    ptrdiff_t s_stride, ksl_SE3f_t *D, ptrdiff_t D_stride, ksl_SE3f_t *D_bound,
    ptrdiff_t D_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_exp_certified(s + i * s_stride, D + i * D_stride, D_bound + i * D_bound_stride);
  }
}

static KSL_INLINED void ksl_SE3f_exp_certified_planes(ptrdiff_t n, const float *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *D_bound, ptrdiff_t D_bound_plane,
    ptrdiff_t D_bound_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_SE3f_t D_i;
    ksl_SE3f_t D_bound_i;
    ksl_SE3f_exp_certified(&s_i, &D_i, &D_bound_i);
    ksl_SE3f_to_planes(&D_i, D + i * D_stride, D_plane);
    ksl_SE3f_to_planes(&D_bound_i, D_bound + i * D_bound_stride, D_bound_plane);
  }
}

/* ksl_SE3f_log_certified of n elements. */
static KSL_INLINED void ksl_SE3f_log_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride,
    ksl_screwf_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_log_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_SE3f_log_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, float *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_SE3f_log_certified(&D_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

#endif
