/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Numbers in arrays: exchanged, added, compared, interpolated. */
#ifndef KSL_ARRAY_H
#define KSL_ARRAY_H

#include <stdbool.h>
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

/* Whether all count pairs are equal. */
static inline bool ksl_allclosei(const int count, const int *a1, const int *a2) {
  for (int i = 0; i < count; i++) {
    if (a1[i] != a2[i]) { return false; }
  }
  return true;
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

/* Whether |a1[i] - a2[i]| / max(|a1[i]|, 1), rounded, is at most 1e-6 for each of count pairs.  An
   infinity is close to itself only, NaN to nothing. */
static inline bool ksl_allclose(const int count, const double *a1, const double *a2) {
  for (int i = 0; i < count; i++) {
    const double size = fabs(a1[i]), scale = size > 1 ? size : 1, gap = a1[i] - a2[i];
    if (a1[i] != a2[i] && !(fabs(gap) / scale <= 1e-06)) { return false; }
  }
  return true;
}

/* yo = (1 - p) y1i + p y2i, count numbers each; y1i for p <= 0, y2i for p >= 1, and either where they
   are equal.  Error <= 3 u (|(1 - p) y1i| + |p y2i|).  yo is y1i or y2i, or doesn't overlap them. */
static inline void ksl_arraylerp(const int count, const double p, const double *y1i,
    const double *y2i, double *yo) {
  const double rest = 1 - p;
  for (int i = 0; i < count; i++) {
    const double first = y1i[i], last = y2i[i], whole = last - first;
    const double left = KSL_MUL(rest, first), right = KSL_MUL(p, last);
    const double onward = KSL_MUL(p, whole), back = KSL_MUL(rest, whole);
    if (p <= 0 || first == last) {
      yo[i] = first;
    } else if (p >= 1) {
      yo[i] = last;
    } else if ((first < 0) != (last < 0)) { /* whole may overflow, or be larger than both */
      yo[i] = left + right;
    } else { /* from the nearer end: 1 - p is exact there */
      yo[i] = p < rest ? first + onward : last - back;
    }
  }
}

/* The index of the first of n numbers with the largest magnitude; NaN counts as less than every
   number.  -1 if n <= 0. */
static inline int ksl_maxIndex(const int n, const double *a) {
  int largest = n > 0 ? 0 : -1;
  for (int i = 1; i < n; i++) {
    const double size = fabs(a[i]), found = fabs(a[largest]);
    if (size > found || (size == size && found != found)) { largest = i; }
  }
  return largest;
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

/* Whether |a1[i] - a2[i]| / max(|a1[i]|, 1), rounded, is at most 1e-6 for each of count pairs.  An
   infinity is close to itself only, NaN to nothing. */
static inline bool ksl_allclosef(const int count, const float *a1, const float *a2) {
  for (int i = 0; i < count; i++) {
    const float size = fabsf(a1[i]), scale = size > 1 ? size : 1, gap = a1[i] - a2[i];
    if (a1[i] != a2[i] && !(fabsf(gap) / scale <= 1e-06f)) { return false; }
  }
  return true;
}

/* yo = (1 - p) y1i + p y2i, count numbers each; y1i for p <= 0, y2i for p >= 1, and either where they
   are equal.  Error <= 3 u (|(1 - p) y1i| + |p y2i|).  yo is y1i or y2i, or doesn't overlap them. */
static inline void ksl_arraylerpf(const int count, const float p, const float *y1i,
    const float *y2i, float *yo) {
  const float rest = 1 - p;
  for (int i = 0; i < count; i++) {
    const float first = y1i[i], last = y2i[i], whole = last - first;
    const float left = KSL_MULF(rest, first), right = KSL_MULF(p, last);
    const float onward = KSL_MULF(p, whole), back = KSL_MULF(rest, whole);
    if (p <= 0 || first == last) {
      yo[i] = first;
    } else if (p >= 1) {
      yo[i] = last;
    } else if ((first < 0) != (last < 0)) { /* whole may overflow, or be larger than both */
      yo[i] = left + right;
    } else { /* from the nearer end: 1 - p is exact there */
      yo[i] = p < rest ? first + onward : last - back;
    }
  }
}

/* The index of the first of n numbers with the largest magnitude; NaN counts as less than every
   number.  -1 if n <= 0. */
static inline int ksl_maxIndexf(const int n, const float *a) {
  int largest = n > 0 ? 0 : -1;
  for (int i = 1; i < n; i++) {
    const float size = fabsf(a[i]), found = fabsf(a[largest]);
    if (size > found || (size == size && found != found)) { largest = i; }
  }
  return largest;
}

#endif
