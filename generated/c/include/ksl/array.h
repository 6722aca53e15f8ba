/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Numbers in arrays: exchanged, and added in multiples. */
#ifndef KSL_ARRAY_H
#define KSL_ARRAY_H

#include <stddef.h>
#include "ksl_types.h"

/* What KSL declares beside formulas. */


/* Exchanges two numbers. */
static inline void ksl_swap(double *a, double *b) {
  const double first = *a;
  *a = *b;
  *b = first;
}

/* Exchanges two numbers. */
static inline void ksl_swapf(float *a, float *b) {
  const float first = *a;
  *a = *b;
  *b = first;
}

/* Exchanges two numbers. */
static inline void ksl_swapi(int *a, int *b) {
  const int first = *a;
  *a = *b;
  *b = first;
}

/* y = a x + y, n numbers each; x and y are the same array or don't overlap. */
static inline void ksl_axpy(
    const int n, const double a, const double *x, double *y) {
  for (int i = 0; i < n; i++) {
    const double product = KSL_MUL(a, x[i]);
    y[i] = product + y[i];
  }
}

/* Exchanges n numbers of a with n numbers of b, each with its stride. */
static inline void ksl_swapArray(
    const int n, double *a, const int a_stride, double *b, const int b_stride) {
  for (int i = 0; i < n; i++) {
    ksl_swap(a + (ptrdiff_t)i * a_stride, b + (ptrdiff_t)i * b_stride);
  }
}

/* y = a x + y, n numbers each; x and y are the same array or don't overlap. */
static inline void ksl_axpyf(
    const int n, const float a, const float *x, float *y) {
  for (int i = 0; i < n; i++) {
    const float product = KSL_MULF(a, x[i]);
    y[i] = product + y[i];
  }
}

/* Exchanges n numbers of a with n numbers of b, each with its stride. */
static inline void ksl_swapArrayf(
    const int n, float *a, const int a_stride, float *b, const int b_stride) {
  for (int i = 0; i < n; i++) {
    ksl_swapf(a + (ptrdiff_t)i * a_stride, b + (ptrdiff_t)i * b_stride);
  }
}

#endif
