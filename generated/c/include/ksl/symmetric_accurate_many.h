/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Symmetric positive definite 3×3 and 6×6 matrices: A = L D L^T, solutions of A x = b.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_SYMMETRIC_ACCURATE_MANY_H
#define KSL_SYMMETRIC_ACCURATE_MANY_H

#include "symmetric_accurate.h"
#include "ksl_planes.h"

/* ksl_mat3x3_ldl_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_ldl_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *A,
    ptrdiff_t A_stride, ksl_mat3x3_t *L, ptrdiff_t L_stride, double *pivot,
    ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_mat3x3_ldl_accurate(A + i * A_stride, L + i * L_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_ldl_accurate_planes(ptrdiff_t n, const double *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, double *L, ptrdiff_t L_plane,
    ptrdiff_t L_stride, double *pivot, ptrdiff_t pivot_stride) {
  ksl_mat3x3_t A_i;
  if (n > 0) A_i = ksl_mat3x3_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat3x3_of_planes(A + i * A_stride, A_plane);
    ksl_mat3x3_t L_i;
    pivot[i * pivot_stride] = ksl_mat3x3_ldl_accurate(&A_i, &L_i);
    ksl_mat3x3_to_planes(&L_i, L + i * L_stride, L_plane);
  }
}

/* ksl_mat3x3_ldl_solve_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_ldl_solve_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *L,
    ptrdiff_t L_stride, const ksl_vec3_t *b, ptrdiff_t b_stride, ksl_vec3_t *x,
    ptrdiff_t x_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_ldl_solve_accurate(L + i * L_stride, b + i * b_stride, x + i * x_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_ldl_solve_accurate_planes(ptrdiff_t n, const double *L,
    ptrdiff_t L_plane, ptrdiff_t L_stride, const double *b, ptrdiff_t b_plane,
    ptrdiff_t b_stride, double *x, ptrdiff_t x_plane, ptrdiff_t x_stride) {
  ksl_mat3x3_t L_i;
  if (n > 0) L_i = ksl_mat3x3_of_planes(L, L_plane);
  KSL_EACH_OF(n) {
    if (L_stride) L_i = ksl_mat3x3_of_planes(L + i * L_stride, L_plane);
    const ksl_vec3_t b_i = ksl_vec3_of_planes(b + i * b_stride, b_plane);
    ksl_vec3_t x_i;
    ksl_mat3x3_ldl_solve_accurate(&L_i, &b_i, &x_i);
    ksl_vec3_to_planes(&x_i, x + i * x_stride, x_plane);
  }
}

/* ksl_mat3x3_solve_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_solve_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *A,
    ptrdiff_t A_stride, const ksl_vec3_t *b, ptrdiff_t b_stride, ksl_vec3_t *x,
    ptrdiff_t x_stride, double *pivot, ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_mat3x3_solve_accurate(A + i * A_stride, b + i * b_stride,
        x + i * x_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_solve_accurate_planes(ptrdiff_t n, const double *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, const double *b, ptrdiff_t b_plane,
    ptrdiff_t b_stride, double *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    double *pivot, ptrdiff_t pivot_stride) {
  ksl_mat3x3_t A_i;
  if (n > 0) A_i = ksl_mat3x3_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat3x3_of_planes(A + i * A_stride, A_plane);
    const ksl_vec3_t b_i = ksl_vec3_of_planes(b + i * b_stride, b_plane);
    ksl_vec3_t x_i;
    pivot[i * pivot_stride] = ksl_mat3x3_solve_accurate(&A_i, &b_i, &x_i);
    ksl_vec3_to_planes(&x_i, x + i * x_stride, x_plane);
  }
}

/* ksl_mat6x6_ldl_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6_ldl_accurate_many(ptrdiff_t n, const ksl_mat6x6_t *A,
    ptrdiff_t A_stride, ksl_mat6x6_t *L, ptrdiff_t L_stride, double *pivot,
    ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_mat6x6_ldl_accurate(A + i * A_stride, L + i * L_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_ldl_accurate_planes(ptrdiff_t n, const double *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, double *L, ptrdiff_t L_plane,
    ptrdiff_t L_stride, double *pivot, ptrdiff_t pivot_stride) {
  ksl_mat6x6_t A_i;
  if (n > 0) A_i = ksl_mat6x6_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat6x6_of_planes(A + i * A_stride, A_plane);
    ksl_mat6x6_t L_i;
    pivot[i * pivot_stride] = ksl_mat6x6_ldl_accurate(&A_i, &L_i);
    ksl_mat6x6_to_planes(&L_i, L + i * L_stride, L_plane);
  }
}

/* ksl_mat6x6_ldl_solve_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6_ldl_solve_accurate_many(ptrdiff_t n, const ksl_mat6x6_t *L,
    ptrdiff_t L_stride, const ksl_coscrew_t *b, ptrdiff_t b_stride,
    ksl_screw_t *x, ptrdiff_t x_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6_ldl_solve_accurate(L + i * L_stride, b + i * b_stride, x + i * x_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_ldl_solve_accurate_planes(ptrdiff_t n, const double *L,
    ptrdiff_t L_plane, ptrdiff_t L_stride, const double *b, ptrdiff_t b_plane,
    ptrdiff_t b_stride, double *x, ptrdiff_t x_plane, ptrdiff_t x_stride) {
  ksl_mat6x6_t L_i;
  if (n > 0) L_i = ksl_mat6x6_of_planes(L, L_plane);
  KSL_EACH_OF(n) {
    if (L_stride) L_i = ksl_mat6x6_of_planes(L + i * L_stride, L_plane);
    const ksl_coscrew_t b_i = ksl_coscrew_of_planes(b + i * b_stride, b_plane);
    ksl_screw_t x_i;
    ksl_mat6x6_ldl_solve_accurate(&L_i, &b_i, &x_i);
    ksl_screw_to_planes(&x_i, x + i * x_stride, x_plane);
  }
}

/* ksl_mat6x6_solve_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6_solve_accurate_many(ptrdiff_t n, const ksl_mat6x6_t *A,
    ptrdiff_t A_stride, const ksl_coscrew_t *b, ptrdiff_t b_stride,
    ksl_screw_t *x, ptrdiff_t x_stride, double *pivot, ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_mat6x6_solve_accurate(A + i * A_stride, b + i * b_stride,
        x + i * x_stride);
  }
}

static KSL_INLINED void ksl_mat6x6_solve_accurate_planes(ptrdiff_t n, const double *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, const double *b, ptrdiff_t b_plane,
    ptrdiff_t b_stride, double *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    double *pivot, ptrdiff_t pivot_stride) {
  ksl_mat6x6_t A_i;
  if (n > 0) A_i = ksl_mat6x6_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat6x6_of_planes(A + i * A_stride, A_plane);
    const ksl_coscrew_t b_i = ksl_coscrew_of_planes(b + i * b_stride, b_plane);
    ksl_screw_t x_i;
    pivot[i * pivot_stride] = ksl_mat6x6_solve_accurate(&A_i, &b_i, &x_i);
    ksl_screw_to_planes(&x_i, x + i * x_stride, x_plane);
  }
}

/* ksl_mat3x3f_ldl_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_ldl_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *A,
    ptrdiff_t A_stride, ksl_mat3x3f_t *L, ptrdiff_t L_stride, float *pivot,
    ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_mat3x3f_ldl_accurate(A + i * A_stride, L + i * L_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_ldl_accurate_planes(ptrdiff_t n, const float *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, float *L, ptrdiff_t L_plane,
    ptrdiff_t L_stride, float *pivot, ptrdiff_t pivot_stride) {
  ksl_mat3x3f_t A_i;
  if (n > 0) A_i = ksl_mat3x3f_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat3x3f_of_planes(A + i * A_stride, A_plane);
    ksl_mat3x3f_t L_i;
    pivot[i * pivot_stride] = ksl_mat3x3f_ldl_accurate(&A_i, &L_i);
    ksl_mat3x3f_to_planes(&L_i, L + i * L_stride, L_plane);
  }
}

/* ksl_mat3x3f_ldl_solve_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_ldl_solve_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *L,
    ptrdiff_t L_stride, const ksl_vec3f_t *b, ptrdiff_t b_stride, ksl_vec3f_t *x,
    ptrdiff_t x_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_ldl_solve_accurate(L + i * L_stride, b + i * b_stride, x + i * x_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_ldl_solve_accurate_planes(ptrdiff_t n, const float *L,
    ptrdiff_t L_plane, ptrdiff_t L_stride, const float *b, ptrdiff_t b_plane,
    ptrdiff_t b_stride, float *x, ptrdiff_t x_plane, ptrdiff_t x_stride) {
  ksl_mat3x3f_t L_i;
  if (n > 0) L_i = ksl_mat3x3f_of_planes(L, L_plane);
  KSL_EACH_OF(n) {
    if (L_stride) L_i = ksl_mat3x3f_of_planes(L + i * L_stride, L_plane);
    const ksl_vec3f_t b_i = ksl_vec3f_of_planes(b + i * b_stride, b_plane);
    ksl_vec3f_t x_i;
    ksl_mat3x3f_ldl_solve_accurate(&L_i, &b_i, &x_i);
    ksl_vec3f_to_planes(&x_i, x + i * x_stride, x_plane);
  }
}

/* ksl_mat3x3f_solve_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_solve_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *A,
    ptrdiff_t A_stride, const ksl_vec3f_t *b, ptrdiff_t b_stride, ksl_vec3f_t *x,
    ptrdiff_t x_stride, float *pivot, ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_mat3x3f_solve_accurate(A + i * A_stride, b + i * b_stride,
        x + i * x_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_solve_accurate_planes(ptrdiff_t n, const float *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, const float *b, ptrdiff_t b_plane,
    ptrdiff_t b_stride, float *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    float *pivot, ptrdiff_t pivot_stride) {
  ksl_mat3x3f_t A_i;
  if (n > 0) A_i = ksl_mat3x3f_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat3x3f_of_planes(A + i * A_stride, A_plane);
    const ksl_vec3f_t b_i = ksl_vec3f_of_planes(b + i * b_stride, b_plane);
    ksl_vec3f_t x_i;
    pivot[i * pivot_stride] = ksl_mat3x3f_solve_accurate(&A_i, &b_i, &x_i);
    ksl_vec3f_to_planes(&x_i, x + i * x_stride, x_plane);
  }
}

/* ksl_mat6x6f_ldl_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6f_ldl_accurate_many(ptrdiff_t n, const ksl_mat6x6f_t *A,
    ptrdiff_t A_stride, ksl_mat6x6f_t *L, ptrdiff_t L_stride, float *pivot,
    ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_mat6x6f_ldl_accurate(A + i * A_stride, L + i * L_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_ldl_accurate_planes(ptrdiff_t n, const float *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, float *L, ptrdiff_t L_plane,
    ptrdiff_t L_stride, float *pivot, ptrdiff_t pivot_stride) {
  ksl_mat6x6f_t A_i;
  if (n > 0) A_i = ksl_mat6x6f_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat6x6f_of_planes(A + i * A_stride, A_plane);
    ksl_mat6x6f_t L_i;
    pivot[i * pivot_stride] = ksl_mat6x6f_ldl_accurate(&A_i, &L_i);
    ksl_mat6x6f_to_planes(&L_i, L + i * L_stride, L_plane);
  }
}

/* ksl_mat6x6f_ldl_solve_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6f_ldl_solve_accurate_many(ptrdiff_t n, const ksl_mat6x6f_t *L,
    ptrdiff_t L_stride, const ksl_coscrewf_t *b, ptrdiff_t b_stride,
    ksl_screwf_t *x, ptrdiff_t x_stride) {
  KSL_EACH_OF(n) {
    ksl_mat6x6f_ldl_solve_accurate(L + i * L_stride, b + i * b_stride, x + i * x_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_ldl_solve_accurate_planes(ptrdiff_t n, const float *L,
    ptrdiff_t L_plane, ptrdiff_t L_stride, const float *b, ptrdiff_t b_plane,
    ptrdiff_t b_stride, float *x, ptrdiff_t x_plane, ptrdiff_t x_stride) {
  ksl_mat6x6f_t L_i;
  if (n > 0) L_i = ksl_mat6x6f_of_planes(L, L_plane);
  KSL_EACH_OF(n) {
    if (L_stride) L_i = ksl_mat6x6f_of_planes(L + i * L_stride, L_plane);
    const ksl_coscrewf_t b_i = ksl_coscrewf_of_planes(b + i * b_stride, b_plane);
    ksl_screwf_t x_i;
    ksl_mat6x6f_ldl_solve_accurate(&L_i, &b_i, &x_i);
    ksl_screwf_to_planes(&x_i, x + i * x_stride, x_plane);
  }
}

/* ksl_mat6x6f_solve_accurate of n elements. */
static KSL_INLINED void ksl_mat6x6f_solve_accurate_many(ptrdiff_t n, const ksl_mat6x6f_t *A,
    ptrdiff_t A_stride, const ksl_coscrewf_t *b, ptrdiff_t b_stride,
    ksl_screwf_t *x, ptrdiff_t x_stride, float *pivot, ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_mat6x6f_solve_accurate(A + i * A_stride, b + i * b_stride,
        x + i * x_stride);
  }
}

static KSL_INLINED void ksl_mat6x6f_solve_accurate_planes(ptrdiff_t n, const float *A,
    ptrdiff_t A_plane, ptrdiff_t A_stride, const float *b, ptrdiff_t b_plane,
    ptrdiff_t b_stride, float *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    float *pivot, ptrdiff_t pivot_stride) {
  ksl_mat6x6f_t A_i;
  if (n > 0) A_i = ksl_mat6x6f_of_planes(A, A_plane);
  KSL_EACH_OF(n) {
    if (A_stride) A_i = ksl_mat6x6f_of_planes(A + i * A_stride, A_plane);
    const ksl_coscrewf_t b_i = ksl_coscrewf_of_planes(b + i * b_stride, b_plane);
    ksl_screwf_t x_i;
    pivot[i * pivot_stride] = ksl_mat6x6f_solve_accurate(&A_i, &b_i, &x_i);
    ksl_screwf_to_planes(&x_i, x + i * x_stride, x_plane);
  }
}

#endif
