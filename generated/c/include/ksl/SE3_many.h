/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Displacements D = [R | t].  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_SE3_MANY_H
#define KSL_SE3_MANY_H

#include "SE3.h"
#include "ksl_planes.h"

/* ksl_SE3_fromRt of n elements. */
static KSL_INLINED void ksl_SE3_fromRt_many(ptrdiff_t n, const ksl_mat3x3_t *R, ptrdiff_t R_stride,
    const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *D, ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    D[i * D_stride] = ksl_SE3_fromRt(R[i * R_stride], t[i * t_stride]);
  }
}

static KSL_INLINED void ksl_SE3_fromRt_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    double *D, ptrdiff_t D_plane, ptrdiff_t D_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t D_i;
    D_i = ksl_SE3_fromRt(R_i, t_i);
    ksl_SE3_to_planes(&D_i, D + i * D_stride, D_plane);
  }
}

/* ksl_SE3_copy of n elements. */
static KSL_INLINED void ksl_SE3_copy_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_copy(D + i * D_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_SE3_copy_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_copy(&D_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_SE3_setIdentity of n elements. */
static KSL_INLINED void ksl_SE3_setIdentity_many(ptrdiff_t n, ksl_SE3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_SE3_setIdentity_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_t self_i = ksl_SE3_of_planes(self + i * self_stride, self_plane);
    ksl_SE3_setIdentity(&self_i);
    ksl_SE3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_SE3_getTranslation of n elements. */
static KSL_INLINED void ksl_SE3_getTranslation_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_vec3_t *t, ptrdiff_t t_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_getTranslation(D + i * D_stride, t + i * t_stride);
  }
}

static KSL_INLINED void ksl_SE3_getTranslation_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_vec3_t t_i;
    ksl_SE3_getTranslation(&D_i, &t_i);
    ksl_vec3_to_planes(&t_i, t + i * t_stride, t_plane);
  }
}

/* ksl_SE3_getRotation of n elements. */
static KSL_INLINED void ksl_SE3_getRotation_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_getRotation(D + i * D_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SE3_getRotation_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_mat3x3_t R_i;
    ksl_SE3_getRotation(&D_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SE3_invert of n elements. */
static KSL_INLINED void ksl_SE3_invert_many(ptrdiff_t n, ksl_SE3_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_SE3_invert_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_t self_i = ksl_SE3_of_planes(self + i * self_stride, self_plane);
    ksl_SE3_invert(&self_i);
    ksl_SE3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_SE3_toMat4x4 of n elements. */
static KSL_INLINED void ksl_SE3_toMat4x4_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_mat4x4_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_toMat4x4(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3_toMat4x4_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_mat4x4_t M_i;
    ksl_SE3_toMat4x4(&D_i, &M_i);
    ksl_mat4x4_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3_inverted of n elements. */
static KSL_INLINED void ksl_SE3_inverted_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_inverted(D + i * D_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_SE3_inverted_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_inverted(&D_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_SE3f_fromRt of n elements. */
static KSL_INLINED void ksl_SE3f_fromRt_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *D,
    ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    D[i * D_stride] = ksl_SE3f_fromRt(R[i * R_stride], t[i * t_stride]);
  }
}

static KSL_INLINED void ksl_SE3f_fromRt_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    float *D, ptrdiff_t D_plane, ptrdiff_t D_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t D_i;
    D_i = ksl_SE3f_fromRt(R_i, t_i);
    ksl_SE3f_to_planes(&D_i, D + i * D_stride, D_plane);
  }
}

/* ksl_SE3f_copy of n elements. */
static KSL_INLINED void ksl_SE3f_copy_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_copy(D + i * D_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_SE3f_copy_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_copy(&D_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_SE3f_setIdentity of n elements. */
static KSL_INLINED void ksl_SE3f_setIdentity_many(ptrdiff_t n, ksl_SE3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_SE3f_setIdentity_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_t self_i = ksl_SE3f_of_planes(self + i * self_stride, self_plane);
    ksl_SE3f_setIdentity(&self_i);
    ksl_SE3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_SE3f_getTranslation of n elements. */
static KSL_INLINED void ksl_SE3f_getTranslation_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_vec3f_t *t, ptrdiff_t t_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_getTranslation(D + i * D_stride, t + i * t_stride);
  }
}

static KSL_INLINED void ksl_SE3f_getTranslation_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_vec3f_t t_i;
    ksl_SE3f_getTranslation(&D_i, &t_i);
    ksl_vec3f_to_planes(&t_i, t + i * t_stride, t_plane);
  }
}

/* ksl_SE3f_getRotation of n elements. */
static KSL_INLINED void ksl_SE3f_getRotation_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_getRotation(D + i * D_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_SE3f_getRotation_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_mat3x3f_t R_i;
    ksl_SE3f_getRotation(&D_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_SE3f_invert of n elements. */
static KSL_INLINED void ksl_SE3f_invert_many(ptrdiff_t n, ksl_SE3f_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_SE3f_invert_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_t self_i = ksl_SE3f_of_planes(self + i * self_stride, self_plane);
    ksl_SE3f_invert(&self_i);
    ksl_SE3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_SE3f_toMat4x4f of n elements. */
static KSL_INLINED void ksl_SE3f_toMat4x4f_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_mat4x4f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_toMat4x4f(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_SE3f_toMat4x4f_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_mat4x4f_t M_i;
    ksl_SE3f_toMat4x4f(&D_i, &M_i);
    ksl_mat4x4f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_SE3f_inverted of n elements. */
static KSL_INLINED void ksl_SE3f_inverted_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_inverted(D + i * D_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_SE3f_inverted_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_inverted(&D_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

#endif
