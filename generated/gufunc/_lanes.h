/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Several elements at a time, a component of each in a vector. */
#ifndef COSCREW_LANES_H
#define COSCREW_LANES_H

#include "_gufunc.h"
#include "../c/include/ksl/ksl_states.h"

#if KSL_LANE_BYTES
#include "runtime/vectors.h"

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_scalar_double(
    ksl_states *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(double) && left == KSL_LANES) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    return;
  }
  double lanes[1][KSL_LANES];
  for (npy_intp i = 0; i < KSL_LANES; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const double *)(p);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_scalar_double(
    const ksl_states *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(double) && left == KSL_LANES) {
    memcpy(first, x, sizeof *x);
    return;
  }
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(double *)(p) = x[0][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_scalar_single(
    ksl_statesf *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(float) && left == KSL_LANESF) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    return;
  }
  float lanes[1][KSL_LANESF];
  for (npy_intp i = 0; i < KSL_LANESF; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const float *)(p);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_scalar_single(
    const ksl_statesf *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(float) && left == KSL_LANESF) {
    memcpy(first, x, sizeof *x);
    return;
  }
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(float *)(p) = x[0][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_dc_double(
    ksl_states *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(double) && left == KSL_LANES) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    return;
  }
  double lanes[2][KSL_LANES];
  for (npy_intp i = 0; i < KSL_LANES; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const double *)(p);
    lanes[1][i] = *(const double *)(p + 1 * s[0]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_dc_double(
    const ksl_states *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(double *)(p) = x[0][i];
    *(double *)(p + 1 * s[0]) = x[1][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_dc_single(
    ksl_statesf *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(float) && left == KSL_LANESF) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    return;
  }
  float lanes[2][KSL_LANESF];
  for (npy_intp i = 0; i < KSL_LANESF; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const float *)(p);
    lanes[1][i] = *(const float *)(p + 1 * s[0]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_dc_single(
    const ksl_statesf *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(float *)(p) = x[0][i];
    *(float *)(p + 1 * s[0]) = x[1][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_vec3_double(
    ksl_states *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(double) && left == KSL_LANES) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    return;
  }
  double lanes[3][KSL_LANES];
  for (npy_intp i = 0; i < KSL_LANES; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const double *)(p);
    lanes[1][i] = *(const double *)(p + 1 * s[0]);
    lanes[2][i] = *(const double *)(p + 2 * s[0]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_vec3_double(
    const ksl_states *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(double *)(p) = x[0][i];
    *(double *)(p + 1 * s[0]) = x[1][i];
    *(double *)(p + 2 * s[0]) = x[2][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_vec3_single(
    ksl_statesf *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(float) && left == KSL_LANESF) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    return;
  }
  float lanes[3][KSL_LANESF];
  for (npy_intp i = 0; i < KSL_LANESF; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const float *)(p);
    lanes[1][i] = *(const float *)(p + 1 * s[0]);
    lanes[2][i] = *(const float *)(p + 2 * s[0]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_vec3_single(
    const ksl_statesf *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(float *)(p) = x[0][i];
    *(float *)(p + 1 * s[0]) = x[1][i];
    *(float *)(p + 2 * s[0]) = x[2][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_mat3x3_double(
    ksl_states *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(double) && left == KSL_LANES) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[3], p + 1 * s[1], sizeof x[3]);
    memcpy(&x[6], p + 2 * s[1], sizeof x[6]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[4], p + 1 * s[0] + 1 * s[1], sizeof x[4]);
    memcpy(&x[7], p + 1 * s[0] + 2 * s[1], sizeof x[7]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[5], p + 2 * s[0] + 1 * s[1], sizeof x[5]);
    memcpy(&x[8], p + 2 * s[0] + 2 * s[1], sizeof x[8]);
    return;
  }
  double lanes[9][KSL_LANES];
  for (npy_intp i = 0; i < KSL_LANES; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const double *)(p);
    lanes[3][i] = *(const double *)(p + 1 * s[1]);
    lanes[6][i] = *(const double *)(p + 2 * s[1]);
    lanes[1][i] = *(const double *)(p + 1 * s[0]);
    lanes[4][i] = *(const double *)(p + 1 * s[0] + 1 * s[1]);
    lanes[7][i] = *(const double *)(p + 1 * s[0] + 2 * s[1]);
    lanes[2][i] = *(const double *)(p + 2 * s[0]);
    lanes[5][i] = *(const double *)(p + 2 * s[0] + 1 * s[1]);
    lanes[8][i] = *(const double *)(p + 2 * s[0] + 2 * s[1]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_mat3x3_double(
    const ksl_states *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(double *)(p) = x[0][i];
    *(double *)(p + 1 * s[1]) = x[3][i];
    *(double *)(p + 2 * s[1]) = x[6][i];
    *(double *)(p + 1 * s[0]) = x[1][i];
    *(double *)(p + 1 * s[0] + 1 * s[1]) = x[4][i];
    *(double *)(p + 1 * s[0] + 2 * s[1]) = x[7][i];
    *(double *)(p + 2 * s[0]) = x[2][i];
    *(double *)(p + 2 * s[0] + 1 * s[1]) = x[5][i];
    *(double *)(p + 2 * s[0] + 2 * s[1]) = x[8][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_mat3x3_single(
    ksl_statesf *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(float) && left == KSL_LANESF) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[3], p + 1 * s[1], sizeof x[3]);
    memcpy(&x[6], p + 2 * s[1], sizeof x[6]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[4], p + 1 * s[0] + 1 * s[1], sizeof x[4]);
    memcpy(&x[7], p + 1 * s[0] + 2 * s[1], sizeof x[7]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[5], p + 2 * s[0] + 1 * s[1], sizeof x[5]);
    memcpy(&x[8], p + 2 * s[0] + 2 * s[1], sizeof x[8]);
    return;
  }
  float lanes[9][KSL_LANESF];
  for (npy_intp i = 0; i < KSL_LANESF; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const float *)(p);
    lanes[3][i] = *(const float *)(p + 1 * s[1]);
    lanes[6][i] = *(const float *)(p + 2 * s[1]);
    lanes[1][i] = *(const float *)(p + 1 * s[0]);
    lanes[4][i] = *(const float *)(p + 1 * s[0] + 1 * s[1]);
    lanes[7][i] = *(const float *)(p + 1 * s[0] + 2 * s[1]);
    lanes[2][i] = *(const float *)(p + 2 * s[0]);
    lanes[5][i] = *(const float *)(p + 2 * s[0] + 1 * s[1]);
    lanes[8][i] = *(const float *)(p + 2 * s[0] + 2 * s[1]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_mat3x3_single(
    const ksl_statesf *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(float *)(p) = x[0][i];
    *(float *)(p + 1 * s[1]) = x[3][i];
    *(float *)(p + 2 * s[1]) = x[6][i];
    *(float *)(p + 1 * s[0]) = x[1][i];
    *(float *)(p + 1 * s[0] + 1 * s[1]) = x[4][i];
    *(float *)(p + 1 * s[0] + 2 * s[1]) = x[7][i];
    *(float *)(p + 2 * s[0]) = x[2][i];
    *(float *)(p + 2 * s[0] + 1 * s[1]) = x[5][i];
    *(float *)(p + 2 * s[0] + 2 * s[1]) = x[8][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_SE3_double(
    ksl_states *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(double) && left == KSL_LANES) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[3], p + 1 * s[1], sizeof x[3]);
    memcpy(&x[6], p + 2 * s[1], sizeof x[6]);
    memcpy(&x[9], p + 3 * s[1], sizeof x[9]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[4], p + 1 * s[0] + 1 * s[1], sizeof x[4]);
    memcpy(&x[7], p + 1 * s[0] + 2 * s[1], sizeof x[7]);
    memcpy(&x[10], p + 1 * s[0] + 3 * s[1], sizeof x[10]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[5], p + 2 * s[0] + 1 * s[1], sizeof x[5]);
    memcpy(&x[8], p + 2 * s[0] + 2 * s[1], sizeof x[8]);
    memcpy(&x[11], p + 2 * s[0] + 3 * s[1], sizeof x[11]);
    return;
  }
  double lanes[12][KSL_LANES];
  for (npy_intp i = 0; i < KSL_LANES; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const double *)(p);
    lanes[3][i] = *(const double *)(p + 1 * s[1]);
    lanes[6][i] = *(const double *)(p + 2 * s[1]);
    lanes[9][i] = *(const double *)(p + 3 * s[1]);
    lanes[1][i] = *(const double *)(p + 1 * s[0]);
    lanes[4][i] = *(const double *)(p + 1 * s[0] + 1 * s[1]);
    lanes[7][i] = *(const double *)(p + 1 * s[0] + 2 * s[1]);
    lanes[10][i] = *(const double *)(p + 1 * s[0] + 3 * s[1]);
    lanes[2][i] = *(const double *)(p + 2 * s[0]);
    lanes[5][i] = *(const double *)(p + 2 * s[0] + 1 * s[1]);
    lanes[8][i] = *(const double *)(p + 2 * s[0] + 2 * s[1]);
    lanes[11][i] = *(const double *)(p + 2 * s[0] + 3 * s[1]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_SE3_double(
    const ksl_states *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(double *)(p) = x[0][i];
    *(double *)(p + 1 * s[1]) = x[3][i];
    *(double *)(p + 2 * s[1]) = x[6][i];
    *(double *)(p + 3 * s[1]) = x[9][i];
    *(double *)(p + 1 * s[0]) = x[1][i];
    *(double *)(p + 1 * s[0] + 1 * s[1]) = x[4][i];
    *(double *)(p + 1 * s[0] + 2 * s[1]) = x[7][i];
    *(double *)(p + 1 * s[0] + 3 * s[1]) = x[10][i];
    *(double *)(p + 2 * s[0]) = x[2][i];
    *(double *)(p + 2 * s[0] + 1 * s[1]) = x[5][i];
    *(double *)(p + 2 * s[0] + 2 * s[1]) = x[8][i];
    *(double *)(p + 2 * s[0] + 3 * s[1]) = x[11][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_SE3_single(
    ksl_statesf *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(float) && left == KSL_LANESF) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[3], p + 1 * s[1], sizeof x[3]);
    memcpy(&x[6], p + 2 * s[1], sizeof x[6]);
    memcpy(&x[9], p + 3 * s[1], sizeof x[9]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[4], p + 1 * s[0] + 1 * s[1], sizeof x[4]);
    memcpy(&x[7], p + 1 * s[0] + 2 * s[1], sizeof x[7]);
    memcpy(&x[10], p + 1 * s[0] + 3 * s[1], sizeof x[10]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[5], p + 2 * s[0] + 1 * s[1], sizeof x[5]);
    memcpy(&x[8], p + 2 * s[0] + 2 * s[1], sizeof x[8]);
    memcpy(&x[11], p + 2 * s[0] + 3 * s[1], sizeof x[11]);
    return;
  }
  float lanes[12][KSL_LANESF];
  for (npy_intp i = 0; i < KSL_LANESF; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const float *)(p);
    lanes[3][i] = *(const float *)(p + 1 * s[1]);
    lanes[6][i] = *(const float *)(p + 2 * s[1]);
    lanes[9][i] = *(const float *)(p + 3 * s[1]);
    lanes[1][i] = *(const float *)(p + 1 * s[0]);
    lanes[4][i] = *(const float *)(p + 1 * s[0] + 1 * s[1]);
    lanes[7][i] = *(const float *)(p + 1 * s[0] + 2 * s[1]);
    lanes[10][i] = *(const float *)(p + 1 * s[0] + 3 * s[1]);
    lanes[2][i] = *(const float *)(p + 2 * s[0]);
    lanes[5][i] = *(const float *)(p + 2 * s[0] + 1 * s[1]);
    lanes[8][i] = *(const float *)(p + 2 * s[0] + 2 * s[1]);
    lanes[11][i] = *(const float *)(p + 2 * s[0] + 3 * s[1]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_SE3_single(
    const ksl_statesf *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(float *)(p) = x[0][i];
    *(float *)(p + 1 * s[1]) = x[3][i];
    *(float *)(p + 2 * s[1]) = x[6][i];
    *(float *)(p + 3 * s[1]) = x[9][i];
    *(float *)(p + 1 * s[0]) = x[1][i];
    *(float *)(p + 1 * s[0] + 1 * s[1]) = x[4][i];
    *(float *)(p + 1 * s[0] + 2 * s[1]) = x[7][i];
    *(float *)(p + 1 * s[0] + 3 * s[1]) = x[10][i];
    *(float *)(p + 2 * s[0]) = x[2][i];
    *(float *)(p + 2 * s[0] + 1 * s[1]) = x[5][i];
    *(float *)(p + 2 * s[0] + 2 * s[1]) = x[8][i];
    *(float *)(p + 2 * s[0] + 3 * s[1]) = x[11][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_screw_double(
    ksl_states *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(double) && left == KSL_LANES) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[3], p + 3 * s[0], sizeof x[3]);
    memcpy(&x[4], p + 4 * s[0], sizeof x[4]);
    memcpy(&x[5], p + 5 * s[0], sizeof x[5]);
    return;
  }
  double lanes[6][KSL_LANES];
  for (npy_intp i = 0; i < KSL_LANES; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const double *)(p);
    lanes[1][i] = *(const double *)(p + 1 * s[0]);
    lanes[2][i] = *(const double *)(p + 2 * s[0]);
    lanes[3][i] = *(const double *)(p + 3 * s[0]);
    lanes[4][i] = *(const double *)(p + 4 * s[0]);
    lanes[5][i] = *(const double *)(p + 5 * s[0]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_screw_double(
    const ksl_states *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(double *)(p) = x[0][i];
    *(double *)(p + 1 * s[0]) = x[1][i];
    *(double *)(p + 2 * s[0]) = x[2][i];
    *(double *)(p + 3 * s[0]) = x[3][i];
    *(double *)(p + 4 * s[0]) = x[4][i];
    *(double *)(p + 5 * s[0]) = x[5][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_screw_single(
    ksl_statesf *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(float) && left == KSL_LANESF) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[3], p + 3 * s[0], sizeof x[3]);
    memcpy(&x[4], p + 4 * s[0], sizeof x[4]);
    memcpy(&x[5], p + 5 * s[0], sizeof x[5]);
    return;
  }
  float lanes[6][KSL_LANESF];
  for (npy_intp i = 0; i < KSL_LANESF; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const float *)(p);
    lanes[1][i] = *(const float *)(p + 1 * s[0]);
    lanes[2][i] = *(const float *)(p + 2 * s[0]);
    lanes[3][i] = *(const float *)(p + 3 * s[0]);
    lanes[4][i] = *(const float *)(p + 4 * s[0]);
    lanes[5][i] = *(const float *)(p + 5 * s[0]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_screw_single(
    const ksl_statesf *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(float *)(p) = x[0][i];
    *(float *)(p + 1 * s[0]) = x[1][i];
    *(float *)(p + 2 * s[0]) = x[2][i];
    *(float *)(p + 3 * s[0]) = x[3][i];
    *(float *)(p + 4 * s[0]) = x[4][i];
    *(float *)(p + 5 * s[0]) = x[5][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_mat6x6_double(
    ksl_states *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(double) && left == KSL_LANES) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[6], p + 1 * s[1], sizeof x[6]);
    memcpy(&x[12], p + 2 * s[1], sizeof x[12]);
    memcpy(&x[18], p + 3 * s[1], sizeof x[18]);
    memcpy(&x[24], p + 4 * s[1], sizeof x[24]);
    memcpy(&x[30], p + 5 * s[1], sizeof x[30]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[7], p + 1 * s[0] + 1 * s[1], sizeof x[7]);
    memcpy(&x[13], p + 1 * s[0] + 2 * s[1], sizeof x[13]);
    memcpy(&x[19], p + 1 * s[0] + 3 * s[1], sizeof x[19]);
    memcpy(&x[25], p + 1 * s[0] + 4 * s[1], sizeof x[25]);
    memcpy(&x[31], p + 1 * s[0] + 5 * s[1], sizeof x[31]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[8], p + 2 * s[0] + 1 * s[1], sizeof x[8]);
    memcpy(&x[14], p + 2 * s[0] + 2 * s[1], sizeof x[14]);
    memcpy(&x[20], p + 2 * s[0] + 3 * s[1], sizeof x[20]);
    memcpy(&x[26], p + 2 * s[0] + 4 * s[1], sizeof x[26]);
    memcpy(&x[32], p + 2 * s[0] + 5 * s[1], sizeof x[32]);
    memcpy(&x[3], p + 3 * s[0], sizeof x[3]);
    memcpy(&x[9], p + 3 * s[0] + 1 * s[1], sizeof x[9]);
    memcpy(&x[15], p + 3 * s[0] + 2 * s[1], sizeof x[15]);
    memcpy(&x[21], p + 3 * s[0] + 3 * s[1], sizeof x[21]);
    memcpy(&x[27], p + 3 * s[0] + 4 * s[1], sizeof x[27]);
    memcpy(&x[33], p + 3 * s[0] + 5 * s[1], sizeof x[33]);
    memcpy(&x[4], p + 4 * s[0], sizeof x[4]);
    memcpy(&x[10], p + 4 * s[0] + 1 * s[1], sizeof x[10]);
    memcpy(&x[16], p + 4 * s[0] + 2 * s[1], sizeof x[16]);
    memcpy(&x[22], p + 4 * s[0] + 3 * s[1], sizeof x[22]);
    memcpy(&x[28], p + 4 * s[0] + 4 * s[1], sizeof x[28]);
    memcpy(&x[34], p + 4 * s[0] + 5 * s[1], sizeof x[34]);
    memcpy(&x[5], p + 5 * s[0], sizeof x[5]);
    memcpy(&x[11], p + 5 * s[0] + 1 * s[1], sizeof x[11]);
    memcpy(&x[17], p + 5 * s[0] + 2 * s[1], sizeof x[17]);
    memcpy(&x[23], p + 5 * s[0] + 3 * s[1], sizeof x[23]);
    memcpy(&x[29], p + 5 * s[0] + 4 * s[1], sizeof x[29]);
    memcpy(&x[35], p + 5 * s[0] + 5 * s[1], sizeof x[35]);
    return;
  }
  double lanes[36][KSL_LANES];
  for (npy_intp i = 0; i < KSL_LANES; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const double *)(p);
    lanes[6][i] = *(const double *)(p + 1 * s[1]);
    lanes[12][i] = *(const double *)(p + 2 * s[1]);
    lanes[18][i] = *(const double *)(p + 3 * s[1]);
    lanes[24][i] = *(const double *)(p + 4 * s[1]);
    lanes[30][i] = *(const double *)(p + 5 * s[1]);
    lanes[1][i] = *(const double *)(p + 1 * s[0]);
    lanes[7][i] = *(const double *)(p + 1 * s[0] + 1 * s[1]);
    lanes[13][i] = *(const double *)(p + 1 * s[0] + 2 * s[1]);
    lanes[19][i] = *(const double *)(p + 1 * s[0] + 3 * s[1]);
    lanes[25][i] = *(const double *)(p + 1 * s[0] + 4 * s[1]);
    lanes[31][i] = *(const double *)(p + 1 * s[0] + 5 * s[1]);
    lanes[2][i] = *(const double *)(p + 2 * s[0]);
    lanes[8][i] = *(const double *)(p + 2 * s[0] + 1 * s[1]);
    lanes[14][i] = *(const double *)(p + 2 * s[0] + 2 * s[1]);
    lanes[20][i] = *(const double *)(p + 2 * s[0] + 3 * s[1]);
    lanes[26][i] = *(const double *)(p + 2 * s[0] + 4 * s[1]);
    lanes[32][i] = *(const double *)(p + 2 * s[0] + 5 * s[1]);
    lanes[3][i] = *(const double *)(p + 3 * s[0]);
    lanes[9][i] = *(const double *)(p + 3 * s[0] + 1 * s[1]);
    lanes[15][i] = *(const double *)(p + 3 * s[0] + 2 * s[1]);
    lanes[21][i] = *(const double *)(p + 3 * s[0] + 3 * s[1]);
    lanes[27][i] = *(const double *)(p + 3 * s[0] + 4 * s[1]);
    lanes[33][i] = *(const double *)(p + 3 * s[0] + 5 * s[1]);
    lanes[4][i] = *(const double *)(p + 4 * s[0]);
    lanes[10][i] = *(const double *)(p + 4 * s[0] + 1 * s[1]);
    lanes[16][i] = *(const double *)(p + 4 * s[0] + 2 * s[1]);
    lanes[22][i] = *(const double *)(p + 4 * s[0] + 3 * s[1]);
    lanes[28][i] = *(const double *)(p + 4 * s[0] + 4 * s[1]);
    lanes[34][i] = *(const double *)(p + 4 * s[0] + 5 * s[1]);
    lanes[5][i] = *(const double *)(p + 5 * s[0]);
    lanes[11][i] = *(const double *)(p + 5 * s[0] + 1 * s[1]);
    lanes[17][i] = *(const double *)(p + 5 * s[0] + 2 * s[1]);
    lanes[23][i] = *(const double *)(p + 5 * s[0] + 3 * s[1]);
    lanes[29][i] = *(const double *)(p + 5 * s[0] + 4 * s[1]);
    lanes[35][i] = *(const double *)(p + 5 * s[0] + 5 * s[1]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_mat6x6_double(
    const ksl_states *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(double *)(p) = x[0][i];
    *(double *)(p + 1 * s[1]) = x[6][i];
    *(double *)(p + 2 * s[1]) = x[12][i];
    *(double *)(p + 3 * s[1]) = x[18][i];
    *(double *)(p + 4 * s[1]) = x[24][i];
    *(double *)(p + 5 * s[1]) = x[30][i];
    *(double *)(p + 1 * s[0]) = x[1][i];
    *(double *)(p + 1 * s[0] + 1 * s[1]) = x[7][i];
    *(double *)(p + 1 * s[0] + 2 * s[1]) = x[13][i];
    *(double *)(p + 1 * s[0] + 3 * s[1]) = x[19][i];
    *(double *)(p + 1 * s[0] + 4 * s[1]) = x[25][i];
    *(double *)(p + 1 * s[0] + 5 * s[1]) = x[31][i];
    *(double *)(p + 2 * s[0]) = x[2][i];
    *(double *)(p + 2 * s[0] + 1 * s[1]) = x[8][i];
    *(double *)(p + 2 * s[0] + 2 * s[1]) = x[14][i];
    *(double *)(p + 2 * s[0] + 3 * s[1]) = x[20][i];
    *(double *)(p + 2 * s[0] + 4 * s[1]) = x[26][i];
    *(double *)(p + 2 * s[0] + 5 * s[1]) = x[32][i];
    *(double *)(p + 3 * s[0]) = x[3][i];
    *(double *)(p + 3 * s[0] + 1 * s[1]) = x[9][i];
    *(double *)(p + 3 * s[0] + 2 * s[1]) = x[15][i];
    *(double *)(p + 3 * s[0] + 3 * s[1]) = x[21][i];
    *(double *)(p + 3 * s[0] + 4 * s[1]) = x[27][i];
    *(double *)(p + 3 * s[0] + 5 * s[1]) = x[33][i];
    *(double *)(p + 4 * s[0]) = x[4][i];
    *(double *)(p + 4 * s[0] + 1 * s[1]) = x[10][i];
    *(double *)(p + 4 * s[0] + 2 * s[1]) = x[16][i];
    *(double *)(p + 4 * s[0] + 3 * s[1]) = x[22][i];
    *(double *)(p + 4 * s[0] + 4 * s[1]) = x[28][i];
    *(double *)(p + 4 * s[0] + 5 * s[1]) = x[34][i];
    *(double *)(p + 5 * s[0]) = x[5][i];
    *(double *)(p + 5 * s[0] + 1 * s[1]) = x[11][i];
    *(double *)(p + 5 * s[0] + 2 * s[1]) = x[17][i];
    *(double *)(p + 5 * s[0] + 3 * s[1]) = x[23][i];
    *(double *)(p + 5 * s[0] + 4 * s[1]) = x[29][i];
    *(double *)(p + 5 * s[0] + 5 * s[1]) = x[35][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_mat6x6_single(
    ksl_statesf *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(float) && left == KSL_LANESF) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[6], p + 1 * s[1], sizeof x[6]);
    memcpy(&x[12], p + 2 * s[1], sizeof x[12]);
    memcpy(&x[18], p + 3 * s[1], sizeof x[18]);
    memcpy(&x[24], p + 4 * s[1], sizeof x[24]);
    memcpy(&x[30], p + 5 * s[1], sizeof x[30]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[7], p + 1 * s[0] + 1 * s[1], sizeof x[7]);
    memcpy(&x[13], p + 1 * s[0] + 2 * s[1], sizeof x[13]);
    memcpy(&x[19], p + 1 * s[0] + 3 * s[1], sizeof x[19]);
    memcpy(&x[25], p + 1 * s[0] + 4 * s[1], sizeof x[25]);
    memcpy(&x[31], p + 1 * s[0] + 5 * s[1], sizeof x[31]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[8], p + 2 * s[0] + 1 * s[1], sizeof x[8]);
    memcpy(&x[14], p + 2 * s[0] + 2 * s[1], sizeof x[14]);
    memcpy(&x[20], p + 2 * s[0] + 3 * s[1], sizeof x[20]);
    memcpy(&x[26], p + 2 * s[0] + 4 * s[1], sizeof x[26]);
    memcpy(&x[32], p + 2 * s[0] + 5 * s[1], sizeof x[32]);
    memcpy(&x[3], p + 3 * s[0], sizeof x[3]);
    memcpy(&x[9], p + 3 * s[0] + 1 * s[1], sizeof x[9]);
    memcpy(&x[15], p + 3 * s[0] + 2 * s[1], sizeof x[15]);
    memcpy(&x[21], p + 3 * s[0] + 3 * s[1], sizeof x[21]);
    memcpy(&x[27], p + 3 * s[0] + 4 * s[1], sizeof x[27]);
    memcpy(&x[33], p + 3 * s[0] + 5 * s[1], sizeof x[33]);
    memcpy(&x[4], p + 4 * s[0], sizeof x[4]);
    memcpy(&x[10], p + 4 * s[0] + 1 * s[1], sizeof x[10]);
    memcpy(&x[16], p + 4 * s[0] + 2 * s[1], sizeof x[16]);
    memcpy(&x[22], p + 4 * s[0] + 3 * s[1], sizeof x[22]);
    memcpy(&x[28], p + 4 * s[0] + 4 * s[1], sizeof x[28]);
    memcpy(&x[34], p + 4 * s[0] + 5 * s[1], sizeof x[34]);
    memcpy(&x[5], p + 5 * s[0], sizeof x[5]);
    memcpy(&x[11], p + 5 * s[0] + 1 * s[1], sizeof x[11]);
    memcpy(&x[17], p + 5 * s[0] + 2 * s[1], sizeof x[17]);
    memcpy(&x[23], p + 5 * s[0] + 3 * s[1], sizeof x[23]);
    memcpy(&x[29], p + 5 * s[0] + 4 * s[1], sizeof x[29]);
    memcpy(&x[35], p + 5 * s[0] + 5 * s[1], sizeof x[35]);
    return;
  }
  float lanes[36][KSL_LANESF];
  for (npy_intp i = 0; i < KSL_LANESF; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const float *)(p);
    lanes[6][i] = *(const float *)(p + 1 * s[1]);
    lanes[12][i] = *(const float *)(p + 2 * s[1]);
    lanes[18][i] = *(const float *)(p + 3 * s[1]);
    lanes[24][i] = *(const float *)(p + 4 * s[1]);
    lanes[30][i] = *(const float *)(p + 5 * s[1]);
    lanes[1][i] = *(const float *)(p + 1 * s[0]);
    lanes[7][i] = *(const float *)(p + 1 * s[0] + 1 * s[1]);
    lanes[13][i] = *(const float *)(p + 1 * s[0] + 2 * s[1]);
    lanes[19][i] = *(const float *)(p + 1 * s[0] + 3 * s[1]);
    lanes[25][i] = *(const float *)(p + 1 * s[0] + 4 * s[1]);
    lanes[31][i] = *(const float *)(p + 1 * s[0] + 5 * s[1]);
    lanes[2][i] = *(const float *)(p + 2 * s[0]);
    lanes[8][i] = *(const float *)(p + 2 * s[0] + 1 * s[1]);
    lanes[14][i] = *(const float *)(p + 2 * s[0] + 2 * s[1]);
    lanes[20][i] = *(const float *)(p + 2 * s[0] + 3 * s[1]);
    lanes[26][i] = *(const float *)(p + 2 * s[0] + 4 * s[1]);
    lanes[32][i] = *(const float *)(p + 2 * s[0] + 5 * s[1]);
    lanes[3][i] = *(const float *)(p + 3 * s[0]);
    lanes[9][i] = *(const float *)(p + 3 * s[0] + 1 * s[1]);
    lanes[15][i] = *(const float *)(p + 3 * s[0] + 2 * s[1]);
    lanes[21][i] = *(const float *)(p + 3 * s[0] + 3 * s[1]);
    lanes[27][i] = *(const float *)(p + 3 * s[0] + 4 * s[1]);
    lanes[33][i] = *(const float *)(p + 3 * s[0] + 5 * s[1]);
    lanes[4][i] = *(const float *)(p + 4 * s[0]);
    lanes[10][i] = *(const float *)(p + 4 * s[0] + 1 * s[1]);
    lanes[16][i] = *(const float *)(p + 4 * s[0] + 2 * s[1]);
    lanes[22][i] = *(const float *)(p + 4 * s[0] + 3 * s[1]);
    lanes[28][i] = *(const float *)(p + 4 * s[0] + 4 * s[1]);
    lanes[34][i] = *(const float *)(p + 4 * s[0] + 5 * s[1]);
    lanes[5][i] = *(const float *)(p + 5 * s[0]);
    lanes[11][i] = *(const float *)(p + 5 * s[0] + 1 * s[1]);
    lanes[17][i] = *(const float *)(p + 5 * s[0] + 2 * s[1]);
    lanes[23][i] = *(const float *)(p + 5 * s[0] + 3 * s[1]);
    lanes[29][i] = *(const float *)(p + 5 * s[0] + 4 * s[1]);
    lanes[35][i] = *(const float *)(p + 5 * s[0] + 5 * s[1]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_mat6x6_single(
    const ksl_statesf *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(float *)(p) = x[0][i];
    *(float *)(p + 1 * s[1]) = x[6][i];
    *(float *)(p + 2 * s[1]) = x[12][i];
    *(float *)(p + 3 * s[1]) = x[18][i];
    *(float *)(p + 4 * s[1]) = x[24][i];
    *(float *)(p + 5 * s[1]) = x[30][i];
    *(float *)(p + 1 * s[0]) = x[1][i];
    *(float *)(p + 1 * s[0] + 1 * s[1]) = x[7][i];
    *(float *)(p + 1 * s[0] + 2 * s[1]) = x[13][i];
    *(float *)(p + 1 * s[0] + 3 * s[1]) = x[19][i];
    *(float *)(p + 1 * s[0] + 4 * s[1]) = x[25][i];
    *(float *)(p + 1 * s[0] + 5 * s[1]) = x[31][i];
    *(float *)(p + 2 * s[0]) = x[2][i];
    *(float *)(p + 2 * s[0] + 1 * s[1]) = x[8][i];
    *(float *)(p + 2 * s[0] + 2 * s[1]) = x[14][i];
    *(float *)(p + 2 * s[0] + 3 * s[1]) = x[20][i];
    *(float *)(p + 2 * s[0] + 4 * s[1]) = x[26][i];
    *(float *)(p + 2 * s[0] + 5 * s[1]) = x[32][i];
    *(float *)(p + 3 * s[0]) = x[3][i];
    *(float *)(p + 3 * s[0] + 1 * s[1]) = x[9][i];
    *(float *)(p + 3 * s[0] + 2 * s[1]) = x[15][i];
    *(float *)(p + 3 * s[0] + 3 * s[1]) = x[21][i];
    *(float *)(p + 3 * s[0] + 4 * s[1]) = x[27][i];
    *(float *)(p + 3 * s[0] + 5 * s[1]) = x[33][i];
    *(float *)(p + 4 * s[0]) = x[4][i];
    *(float *)(p + 4 * s[0] + 1 * s[1]) = x[10][i];
    *(float *)(p + 4 * s[0] + 2 * s[1]) = x[16][i];
    *(float *)(p + 4 * s[0] + 3 * s[1]) = x[22][i];
    *(float *)(p + 4 * s[0] + 4 * s[1]) = x[28][i];
    *(float *)(p + 4 * s[0] + 5 * s[1]) = x[34][i];
    *(float *)(p + 5 * s[0]) = x[5][i];
    *(float *)(p + 5 * s[0] + 1 * s[1]) = x[11][i];
    *(float *)(p + 5 * s[0] + 2 * s[1]) = x[17][i];
    *(float *)(p + 5 * s[0] + 3 * s[1]) = x[23][i];
    *(float *)(p + 5 * s[0] + 4 * s[1]) = x[29][i];
    *(float *)(p + 5 * s[0] + 5 * s[1]) = x[35][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_quaternion_double(
    ksl_states *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(double) && left == KSL_LANES) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[3], p + 3 * s[0], sizeof x[3]);
    return;
  }
  double lanes[4][KSL_LANES];
  for (npy_intp i = 0; i < KSL_LANES; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const double *)(p);
    lanes[1][i] = *(const double *)(p + 1 * s[0]);
    lanes[2][i] = *(const double *)(p + 2 * s[0]);
    lanes[3][i] = *(const double *)(p + 3 * s[0]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_quaternion_double(
    const ksl_states *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(double *)(p) = x[0][i];
    *(double *)(p + 1 * s[0]) = x[1][i];
    *(double *)(p + 2 * s[0]) = x[2][i];
    *(double *)(p + 3 * s[0]) = x[3][i];
  }
}

/* The next elements, at most as many as a vector holds; the last of them repeated. */
INLINED void load_lanes_quaternion_single(
    ksl_statesf *x, const char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  if (step == (npy_intp)sizeof(float) && left == KSL_LANESF) {
    const char *const p = first;
    memcpy(&x[0], p, sizeof x[0]);
    memcpy(&x[1], p + 1 * s[0], sizeof x[1]);
    memcpy(&x[2], p + 2 * s[0], sizeof x[2]);
    memcpy(&x[3], p + 3 * s[0], sizeof x[3]);
    return;
  }
  float lanes[4][KSL_LANESF];
  for (npy_intp i = 0; i < KSL_LANESF; i++) {
    const char *const p = first + (i < left ? i : left - 1) * step;
    lanes[0][i] = *(const float *)(p);
    lanes[1][i] = *(const float *)(p + 1 * s[0]);
    lanes[2][i] = *(const float *)(p + 2 * s[0]);
    lanes[3][i] = *(const float *)(p + 3 * s[0]);
  }
  memcpy(x, lanes, sizeof lanes);
}

INLINED void store_lanes_quaternion_single(
    const ksl_statesf *x, char *first, npy_intp step, const npy_intp *s, npy_intp left) {
  (void)s;
  for (npy_intp i = 0; i < left; i++) {
    char *const p = first + i * step;
    *(float *)(p) = x[0][i];
    *(float *)(p + 1 * s[0]) = x[1][i];
    *(float *)(p + 2 * s[0]) = x[2][i];
    *(float *)(p + 3 * s[0]) = x[3][i];
  }
}

#else
#define LOOP_ON_VECTORS LOOP
#endif
#endif
