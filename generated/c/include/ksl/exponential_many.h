/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_EXPONENTIAL_MANY_H
#define KSL_EXPONENTIAL_MANY_H

#include "exponential.h"
#include "ksl_planes.h"

/* ksl_SO3_exp of n elements. */
static KSL_INLINED void ksl_SO3_exp_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_exp(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_exp_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_SO3_exp(&v_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SO3_log of n elements. */
static KSL_INLINED void ksl_SO3_log_many(ptrdiff_t n, const ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_log(R + i * R_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_SO3_log_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_SO3_log(&R_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_SO3_leftJacobian of n elements. */
static KSL_INLINED void ksl_SO3_leftJacobian_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_leftJacobian(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_leftJacobian_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_SO3_leftJacobian(&v_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SO3_rightJacobian of n elements. */
static KSL_INLINED void ksl_SO3_rightJacobian_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_rightJacobian(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_rightJacobian_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_SO3_rightJacobian(&v_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SO3_leftJacobianInverse of n elements. */
static KSL_INLINED void ksl_SO3_leftJacobianInverse_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_leftJacobianInverse(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_leftJacobianInverse_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_SO3_leftJacobianInverse(&v_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SO3_rightJacobianInverse of n elements. */
static KSL_INLINED void ksl_SO3_rightJacobianInverse_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_rightJacobianInverse(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_rightJacobianInverse_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3_t R_i;
    ksl_SO3_rightJacobianInverse(&v_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_mat3x3_orthonormalize of n elements. */
static KSL_INLINED void ksl_mat3x3_orthonormalize_many(ptrdiff_t n, ksl_mat3x3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_orthonormalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_orthonormalize_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_t self_i = ksl_mat3x3_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3_orthonormalize(&self_i);
    ksl_mat3x3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3_orthonormalized of n elements. */
static KSL_INLINED void ksl_mat3x3_orthonormalized_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_orthonormalized(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_orthonormalized_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_orthonormalized(&R_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_SE3_exp of n elements. */
static KSL_INLINED void ksl_SE3_exp_many(ptrdiff_t n, const ksl_screw_t *s, ptrdiff_t s_stride,
    ksl_SE3_t *D, ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_exp(s + i * s_stride, D + i * D_stride);
  }
}

static KSL_INLINED void ksl_SE3_exp_planes(ptrdiff_t n, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, double *D, ptrdiff_t D_plane, ptrdiff_t D_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_SE3_t D_i;
    ksl_SE3_exp(&s_i, &D_i);
    ksl_SE3_to_planes(&D_i, D + i * D_stride, D_plane);
  }
}

/* ksl_SE3_log of n elements. */
static KSL_INLINED void ksl_SE3_log_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_log(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_SE3_log_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_SE3_log(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_SE3_leftJacobian of n elements. */
static KSL_INLINED void ksl_SE3_leftJacobian_many(ptrdiff_t n, const ksl_screw_t *s,
    ptrdiff_t s_stride, ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_leftJacobian(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3_leftJacobian_planes(ptrdiff_t n, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6_t M_i;
    ksl_SE3_leftJacobian(&s_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3_rightJacobian of n elements. */
static KSL_INLINED void ksl_SE3_rightJacobian_many(ptrdiff_t n, const ksl_screw_t *s,
    ptrdiff_t s_stride, ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_rightJacobian(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3_rightJacobian_planes(ptrdiff_t n, const double *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, double *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6_t M_i;
    ksl_SE3_rightJacobian(&s_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3_leftJacobianInverse of n elements. */
static KSL_INLINED void ksl_SE3_leftJacobianInverse_many(ptrdiff_t n, const ksl_screw_t *s,
    ptrdiff_t s_stride, ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_leftJacobianInverse(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3_leftJacobianInverse_planes(ptrdiff_t n, const double *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, double *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6_t M_i;
    ksl_SE3_leftJacobianInverse(&s_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3_rightJacobianInverse of n elements. */
static KSL_INLINED void ksl_SE3_rightJacobianInverse_many(ptrdiff_t n, const ksl_screw_t *s,
    ptrdiff_t s_stride, ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_rightJacobianInverse(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3_rightJacobianInverse_planes(ptrdiff_t n, const double *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, double *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6_t M_i;
    ksl_SE3_rightJacobianInverse(&s_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3_interpolated of n elements. */
static KSL_INLINED void ksl_SE3_interpolated_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride,
    const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_interpolated(D1 + i * D1_stride, D2 + i * D2_stride, k[i * k_stride],
        Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_SE3_interpolated_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_interpolated(&D1_i, &D2_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_SO3_expf of n elements. */
static KSL_INLINED void ksl_SO3_expf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_expf(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_expf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_SO3_expf(&v_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SO3_logf of n elements. */
static KSL_INLINED void ksl_SO3_logf_many(ptrdiff_t n, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_logf(R + i * R_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_SO3_logf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_SO3_logf(&R_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_SO3_leftJacobianf of n elements. */
static KSL_INLINED void ksl_SO3_leftJacobianf_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_leftJacobianf(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_leftJacobianf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_SO3_leftJacobianf(&v_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SO3_rightJacobianf of n elements. */
static KSL_INLINED void ksl_SO3_rightJacobianf_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_rightJacobianf(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_rightJacobianf_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_SO3_rightJacobianf(&v_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SO3_leftJacobianInversef of n elements. */
static KSL_INLINED void ksl_SO3_leftJacobianInversef_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_leftJacobianInversef(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_leftJacobianInversef_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_SO3_leftJacobianInversef(&v_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SO3_rightJacobianInversef of n elements. */
static KSL_INLINED void ksl_SO3_rightJacobianInversef_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SO3_rightJacobianInversef(v + i * v_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SO3_rightJacobianInversef_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_mat3x3f_t R_i;
    ksl_SO3_rightJacobianInversef(&v_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_mat3x3f_orthonormalize of n elements. */
static KSL_INLINED void ksl_mat3x3f_orthonormalize_many(ptrdiff_t n, ksl_mat3x3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_orthonormalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_orthonormalize_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_t self_i = ksl_mat3x3f_of_planes(self + i * self_stride, self_plane);
    ksl_mat3x3f_orthonormalize(&self_i);
    ksl_mat3x3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat3x3f_orthonormalized of n elements. */
static KSL_INLINED void ksl_mat3x3f_orthonormalized_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_orthonormalized(R + i * R_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_orthonormalized_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_orthonormalized(&R_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_SE3f_exp of n elements. */
static KSL_INLINED void ksl_SE3f_exp_many(ptrdiff_t n, const ksl_screwf_t *s, ptrdiff_t s_stride,
    ksl_SE3f_t *D, ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_exp(s + i * s_stride, D + i * D_stride);
  }
}

static KSL_INLINED void ksl_SE3f_exp_planes(ptrdiff_t n, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, float *D, ptrdiff_t D_plane, ptrdiff_t D_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_SE3f_t D_i;
    ksl_SE3f_exp(&s_i, &D_i);
    ksl_SE3f_to_planes(&D_i, D + i * D_stride, D_plane);
  }
}

/* ksl_SE3f_log of n elements. */
static KSL_INLINED void ksl_SE3f_log_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_log(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_SE3f_log_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_SE3f_log(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_SE3f_leftJacobian of n elements. */
static KSL_INLINED void ksl_SE3f_leftJacobian_many(ptrdiff_t n, const ksl_screwf_t *s,
    ptrdiff_t s_stride, ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_leftJacobian(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3f_leftJacobian_planes(ptrdiff_t n, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6f_t M_i;
    ksl_SE3f_leftJacobian(&s_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3f_rightJacobian of n elements. */
static KSL_INLINED void ksl_SE3f_rightJacobian_many(ptrdiff_t n, const ksl_screwf_t *s,
    ptrdiff_t s_stride, ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_rightJacobian(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3f_rightJacobian_planes(ptrdiff_t n, const float *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, float *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6f_t M_i;
    ksl_SE3f_rightJacobian(&s_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3f_leftJacobianInverse of n elements. */
static KSL_INLINED void ksl_SE3f_leftJacobianInverse_many(ptrdiff_t n, const ksl_screwf_t *s,
    ptrdiff_t s_stride, ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_leftJacobianInverse(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3f_leftJacobianInverse_planes(ptrdiff_t n, const float *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, float *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6f_t M_i;
    ksl_SE3f_leftJacobianInverse(&s_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3f_rightJacobianInverse of n elements. */
static KSL_INLINED void ksl_SE3f_rightJacobianInverse_many(ptrdiff_t n, const ksl_screwf_t *s,
    ptrdiff_t s_stride, ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_rightJacobianInverse(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3f_rightJacobianInverse_planes(ptrdiff_t n, const float *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, float *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6f_t M_i;
    ksl_SE3f_rightJacobianInverse(&s_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3f_interpolated of n elements. */
static KSL_INLINED void ksl_SE3f_interpolated_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_interpolated(D1 + i * D1_stride, D2 + i * D2_stride, k[i * k_stride],
        Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_SE3f_interpolated_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, const float *k, ptrdiff_t k_stride, float *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_interpolated(&D1_i, &D2_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

#endif
