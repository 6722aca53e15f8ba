/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 4×4 matrices: displacements [[R, t], [0, 1]] and other maps of homogeneous coordinates.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MAT4X4_MANY_H
#define KSL_MAT4X4_MANY_H

#include "mat4x4.h"
#include "ksl_planes.h"

/* ksl_mat4x4_fromSE3 of n elements. */
static KSL_INLINED void ksl_mat4x4_fromSE3_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_mat4x4_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    M[i * M_stride] = ksl_mat4x4_fromSE3(D[i * D_stride]);
  }
}

static KSL_INLINED void ksl_mat4x4_fromSE3_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_mat4x4_t M_i;
    M_i = ksl_mat4x4_fromSE3(D_i);
    ksl_mat4x4_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_mat4x4_fromRt of n elements. */
static KSL_INLINED void ksl_mat4x4_fromRt_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_mat4x4_t *M,
    ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    M[i * M_stride] = ksl_mat4x4_fromRt(R[i * R_stride], t[i * t_stride]);
  }
}

static KSL_INLINED void ksl_mat4x4_fromRt_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_mat4x4_t M_i;
    M_i = ksl_mat4x4_fromRt(R_i, t_i);
    ksl_mat4x4_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_mat4x4_toSE3 of n elements. */
static KSL_INLINED void ksl_mat4x4_toSE3_many(ptrdiff_t n, const ksl_mat4x4_t *M,
    ptrdiff_t M_stride, ksl_SE3_t *D, ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    ksl_mat4x4_toSE3(M + i * M_stride, D + i * D_stride);
  }
}

static KSL_INLINED void ksl_mat4x4_toSE3_planes(ptrdiff_t n, const double *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride, double *D, ptrdiff_t D_plane, ptrdiff_t D_stride) {
  ksl_mat4x4_t M_i;
  if (n > 0) M_i = ksl_mat4x4_of_planes(M, M_plane);
  KSL_EACH_OF(n) {
    if (M_stride) M_i = ksl_mat4x4_of_planes(M + i * M_stride, M_plane);
    ksl_SE3_t D_i;
    ksl_mat4x4_toSE3(&M_i, &D_i);
    ksl_SE3_to_planes(&D_i, D + i * D_stride, D_plane);
  }
}

/* ksl_mat4x4_setIdentity of n elements. */
static KSL_INLINED void ksl_mat4x4_setIdentity_many(ptrdiff_t n, ksl_mat4x4_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat4x4_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat4x4_setIdentity_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat4x4_t self_i = ksl_mat4x4_of_planes(self + i * self_stride, self_plane);
    ksl_mat4x4_setIdentity(&self_i);
    ksl_mat4x4_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat4x4_getTranslation of n elements. */
static KSL_INLINED void ksl_mat4x4_getTranslation_many(ptrdiff_t n, const ksl_mat4x4_t *M,
    ptrdiff_t M_stride, ksl_vec3_t *t, ptrdiff_t t_stride) {
  KSL_EACH_OF(n) {
    ksl_mat4x4_getTranslation(M + i * M_stride, t + i * t_stride);
  }
}

static KSL_INLINED void ksl_mat4x4_getTranslation_planes(ptrdiff_t n, const double *M,
    ptrdiff_t M_plane, ptrdiff_t M_stride, double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride) {
  ksl_mat4x4_t M_i;
  if (n > 0) M_i = ksl_mat4x4_of_planes(M, M_plane);
  KSL_EACH_OF(n) {
    if (M_stride) M_i = ksl_mat4x4_of_planes(M + i * M_stride, M_plane);
    ksl_vec3_t t_i;
    ksl_mat4x4_getTranslation(&M_i, &t_i);
    ksl_vec3_to_planes(&t_i, t + i * t_stride, t_plane);
  }
}

/* ksl_mat4x4f_fromSE3f of n elements. */
static KSL_INLINED void ksl_mat4x4f_fromSE3f_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_mat4x4f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    M[i * M_stride] = ksl_mat4x4f_fromSE3f(D[i * D_stride]);
  }
}

static KSL_INLINED void ksl_mat4x4f_fromSE3f_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_mat4x4f_t M_i;
    M_i = ksl_mat4x4f_fromSE3f(D_i);
    ksl_mat4x4f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_mat4x4f_fromRt of n elements. */
static KSL_INLINED void ksl_mat4x4f_fromRt_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride,
    ksl_mat4x4f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    M[i * M_stride] = ksl_mat4x4f_fromRt(R[i * R_stride], t[i * t_stride]);
  }
}

static KSL_INLINED void ksl_mat4x4f_fromRt_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_mat4x4f_t M_i;
    M_i = ksl_mat4x4f_fromRt(R_i, t_i);
    ksl_mat4x4f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_mat4x4f_toSE3f of n elements. */
static KSL_INLINED void ksl_mat4x4f_toSE3f_many(ptrdiff_t n, const ksl_mat4x4f_t *M,
    ptrdiff_t M_stride, ksl_SE3f_t *D, ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    ksl_mat4x4f_toSE3f(M + i * M_stride, D + i * D_stride);
  }
}

static KSL_INLINED void ksl_mat4x4f_toSE3f_planes(ptrdiff_t n, const float *M, ptrdiff_t M_plane,
    ptrdiff_t M_stride, float *D, ptrdiff_t D_plane, ptrdiff_t D_stride) {
  ksl_mat4x4f_t M_i;
  if (n > 0) M_i = ksl_mat4x4f_of_planes(M, M_plane);
  KSL_EACH_OF(n) {
    if (M_stride) M_i = ksl_mat4x4f_of_planes(M + i * M_stride, M_plane);
    ksl_SE3f_t D_i;
    ksl_mat4x4f_toSE3f(&M_i, &D_i);
    ksl_SE3f_to_planes(&D_i, D + i * D_stride, D_plane);
  }
}

/* ksl_mat4x4f_setIdentity of n elements. */
static KSL_INLINED void ksl_mat4x4f_setIdentity_many(ptrdiff_t n, ksl_mat4x4f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat4x4f_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_mat4x4f_setIdentity_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_mat4x4f_t self_i = ksl_mat4x4f_of_planes(self + i * self_stride, self_plane);
    ksl_mat4x4f_setIdentity(&self_i);
    ksl_mat4x4f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_mat4x4f_getTranslation of n elements. */
static KSL_INLINED void ksl_mat4x4f_getTranslation_many(ptrdiff_t n, const ksl_mat4x4f_t *M,
    ptrdiff_t M_stride, ksl_vec3f_t *t, ptrdiff_t t_stride) {
  KSL_EACH_OF(n) {
    ksl_mat4x4f_getTranslation(M + i * M_stride, t + i * t_stride);
  }
}

static KSL_INLINED void ksl_mat4x4f_getTranslation_planes(ptrdiff_t n, const float *M,
    ptrdiff_t M_plane, ptrdiff_t M_stride, float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride) {
  ksl_mat4x4f_t M_i;
  if (n > 0) M_i = ksl_mat4x4f_of_planes(M, M_plane);
  KSL_EACH_OF(n) {
    if (M_stride) M_i = ksl_mat4x4f_of_planes(M + i * M_stride, M_plane);
    ksl_vec3f_t t_i;
    ksl_mat4x4f_getTranslation(&M_i, &t_i);
    ksl_vec3f_to_planes(&t_i, t + i * t_stride, t_plane);
  }
}

#endif
