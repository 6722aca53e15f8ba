/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Shared by the gufunc sources: reading and writing quantities through strides. */
#ifndef COSCREW_GUFUNC_H
#define COSCREW_GUFUNC_H

#define COSCREW_PACKAGE "coscrew.certified"
#define COSCREW_WITH_FMA 1
#define COSCREW_ON_VECTORS 0
#include "../runtime/numpy.h"
#include "../runtime/loops.h"
#include "../runtime/processors.h"
#include "../../c/include/ksl/ksl_types.h"

#define POINTERS_0
#define POINTERS_1 POINTERS_0 char *const p0 = data[0];
#define POINTERS_2 POINTERS_1 char *const p1 = data[1];
#define POINTERS_3 POINTERS_2 char *const p2 = data[2];
#define POINTERS_4 POINTERS_3 char *const p3 = data[3];
#define POINTERS_5 POINTERS_4 char *const p4 = data[4];
#define POINTERS_6 POINTERS_5 char *const p5 = data[5];
#define POINTERS_7 POINTERS_6 char *const p6 = data[6];
#define POINTERS_8 POINTERS_7 char *const p7 = data[7];
#define POINTERS_9 POINTERS_8 char *const p8 = data[8];
#define POINTERS_10 POINTERS_9 char *const p9 = data[9];
#define LOOPS(name) \
  static PyUFuncGenericFunction name##_loops[] = { \
      name##_double, \
      name##_single, \
  };

extern const coscrew_gufunc coscrew_elementary_gufuncs[], coscrew_elementary_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_vec3_gufuncs[], coscrew_vec3_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_vec4_gufuncs[], coscrew_vec4_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_mat3x3_gufuncs[], coscrew_mat3x3_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_SE3_gufuncs[], coscrew_SE3_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_mat6x6_gufuncs[], coscrew_mat6x6_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_matrix_gufuncs[], coscrew_matrix_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_trig_gufuncs[], coscrew_trig_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_screw_gufuncs[], coscrew_screw_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_coscrew_gufuncs[], coscrew_coscrew_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_quaternion_gufuncs[], coscrew_quaternion_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_exponential_gufuncs[], coscrew_exponential_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_inertia_gufuncs[], coscrew_inertia_gufuncs_avx2[];
extern const coscrew_gufunc coscrew_spatial_inertia_gufuncs[], coscrew_spatial_inertia_gufuncs_avx2[];

INLINED void load_scalar_double(
    double *x, const char *p, const npy_intp *s) {
  (void)s;
  x[0] = *(const double *)(p);
}

INLINED void store_scalar_double(
    const double *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x[0];
}

INLINED void load_scalar_single(
    float *x, const char *p, const npy_intp *s) {
  (void)s;
  x[0] = *(const float *)(p);
}

INLINED void store_scalar_single(
    const float *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x[0];
}

INLINED void load_dc_double(
    double *x, const char *p, const npy_intp *s) {
  (void)s;
  x[0] = *(const double *)(p);
  x[1] = *(const double *)(p + 1 * s[0]);
}

INLINED void store_dc_double(
    const double *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x[0];
  *(double *)(p + 1 * s[0]) = x[1];
}

INLINED void load_dc_single(
    float *x, const char *p, const npy_intp *s) {
  (void)s;
  x[0] = *(const float *)(p);
  x[1] = *(const float *)(p + 1 * s[0]);
}

INLINED void store_dc_single(
    const float *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x[0];
  *(float *)(p + 1 * s[0]) = x[1];
}

INLINED void load_vec3_double(
    ksl_vec3_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->x = *(const double *)(p);
  x->y = *(const double *)(p + 1 * s[0]);
  x->z = *(const double *)(p + 2 * s[0]);
}

INLINED void store_vec3_double(
    const ksl_vec3_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->x;
  *(double *)(p + 1 * s[0]) = x->y;
  *(double *)(p + 2 * s[0]) = x->z;
}

INLINED void load_vec3_single(
    ksl_vec3f_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->x = *(const float *)(p);
  x->y = *(const float *)(p + 1 * s[0]);
  x->z = *(const float *)(p + 2 * s[0]);
}

INLINED void store_vec3_single(
    const ksl_vec3f_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->x;
  *(float *)(p + 1 * s[0]) = x->y;
  *(float *)(p + 2 * s[0]) = x->z;
}

INLINED void load_vec4_double(
    ksl_vec4_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->x = *(const double *)(p);
  x->y = *(const double *)(p + 1 * s[0]);
  x->z = *(const double *)(p + 2 * s[0]);
  x->w = *(const double *)(p + 3 * s[0]);
}

INLINED void store_vec4_double(
    const ksl_vec4_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->x;
  *(double *)(p + 1 * s[0]) = x->y;
  *(double *)(p + 2 * s[0]) = x->z;
  *(double *)(p + 3 * s[0]) = x->w;
}

INLINED void load_vec4_single(
    ksl_vec4f_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->x = *(const float *)(p);
  x->y = *(const float *)(p + 1 * s[0]);
  x->z = *(const float *)(p + 2 * s[0]);
  x->w = *(const float *)(p + 3 * s[0]);
}

INLINED void store_vec4_single(
    const ksl_vec4f_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->x;
  *(float *)(p + 1 * s[0]) = x->y;
  *(float *)(p + 2 * s[0]) = x->z;
  *(float *)(p + 3 * s[0]) = x->w;
}

INLINED void load_mat3x3_double(
    ksl_mat3x3_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m00 = *(const double *)(p);
  x->m01 = *(const double *)(p + 1 * s[1]);
  x->m02 = *(const double *)(p + 2 * s[1]);
  x->m10 = *(const double *)(p + 1 * s[0]);
  x->m11 = *(const double *)(p + 1 * s[0] + 1 * s[1]);
  x->m12 = *(const double *)(p + 1 * s[0] + 2 * s[1]);
  x->m20 = *(const double *)(p + 2 * s[0]);
  x->m21 = *(const double *)(p + 2 * s[0] + 1 * s[1]);
  x->m22 = *(const double *)(p + 2 * s[0] + 2 * s[1]);
}

INLINED void store_mat3x3_double(
    const ksl_mat3x3_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->m00;
  *(double *)(p + 1 * s[1]) = x->m01;
  *(double *)(p + 2 * s[1]) = x->m02;
  *(double *)(p + 1 * s[0]) = x->m10;
  *(double *)(p + 1 * s[0] + 1 * s[1]) = x->m11;
  *(double *)(p + 1 * s[0] + 2 * s[1]) = x->m12;
  *(double *)(p + 2 * s[0]) = x->m20;
  *(double *)(p + 2 * s[0] + 1 * s[1]) = x->m21;
  *(double *)(p + 2 * s[0] + 2 * s[1]) = x->m22;
}

INLINED void load_mat3x3_single(
    ksl_mat3x3f_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m00 = *(const float *)(p);
  x->m01 = *(const float *)(p + 1 * s[1]);
  x->m02 = *(const float *)(p + 2 * s[1]);
  x->m10 = *(const float *)(p + 1 * s[0]);
  x->m11 = *(const float *)(p + 1 * s[0] + 1 * s[1]);
  x->m12 = *(const float *)(p + 1 * s[0] + 2 * s[1]);
  x->m20 = *(const float *)(p + 2 * s[0]);
  x->m21 = *(const float *)(p + 2 * s[0] + 1 * s[1]);
  x->m22 = *(const float *)(p + 2 * s[0] + 2 * s[1]);
}

INLINED void store_mat3x3_single(
    const ksl_mat3x3f_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->m00;
  *(float *)(p + 1 * s[1]) = x->m01;
  *(float *)(p + 2 * s[1]) = x->m02;
  *(float *)(p + 1 * s[0]) = x->m10;
  *(float *)(p + 1 * s[0] + 1 * s[1]) = x->m11;
  *(float *)(p + 1 * s[0] + 2 * s[1]) = x->m12;
  *(float *)(p + 2 * s[0]) = x->m20;
  *(float *)(p + 2 * s[0] + 1 * s[1]) = x->m21;
  *(float *)(p + 2 * s[0] + 2 * s[1]) = x->m22;
}

INLINED void load_mat4x4_double(
    ksl_mat4x4_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m00 = *(const double *)(p);
  x->m01 = *(const double *)(p + 1 * s[1]);
  x->m02 = *(const double *)(p + 2 * s[1]);
  x->m03 = *(const double *)(p + 3 * s[1]);
  x->m10 = *(const double *)(p + 1 * s[0]);
  x->m11 = *(const double *)(p + 1 * s[0] + 1 * s[1]);
  x->m12 = *(const double *)(p + 1 * s[0] + 2 * s[1]);
  x->m13 = *(const double *)(p + 1 * s[0] + 3 * s[1]);
  x->m20 = *(const double *)(p + 2 * s[0]);
  x->m21 = *(const double *)(p + 2 * s[0] + 1 * s[1]);
  x->m22 = *(const double *)(p + 2 * s[0] + 2 * s[1]);
  x->m23 = *(const double *)(p + 2 * s[0] + 3 * s[1]);
  x->m30 = *(const double *)(p + 3 * s[0]);
  x->m31 = *(const double *)(p + 3 * s[0] + 1 * s[1]);
  x->m32 = *(const double *)(p + 3 * s[0] + 2 * s[1]);
  x->m33 = *(const double *)(p + 3 * s[0] + 3 * s[1]);
}

INLINED void store_mat4x4_double(
    const ksl_mat4x4_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->m00;
  *(double *)(p + 1 * s[1]) = x->m01;
  *(double *)(p + 2 * s[1]) = x->m02;
  *(double *)(p + 3 * s[1]) = x->m03;
  *(double *)(p + 1 * s[0]) = x->m10;
  *(double *)(p + 1 * s[0] + 1 * s[1]) = x->m11;
  *(double *)(p + 1 * s[0] + 2 * s[1]) = x->m12;
  *(double *)(p + 1 * s[0] + 3 * s[1]) = x->m13;
  *(double *)(p + 2 * s[0]) = x->m20;
  *(double *)(p + 2 * s[0] + 1 * s[1]) = x->m21;
  *(double *)(p + 2 * s[0] + 2 * s[1]) = x->m22;
  *(double *)(p + 2 * s[0] + 3 * s[1]) = x->m23;
  *(double *)(p + 3 * s[0]) = x->m30;
  *(double *)(p + 3 * s[0] + 1 * s[1]) = x->m31;
  *(double *)(p + 3 * s[0] + 2 * s[1]) = x->m32;
  *(double *)(p + 3 * s[0] + 3 * s[1]) = x->m33;
}

INLINED void load_mat4x4_single(
    ksl_mat4x4f_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m00 = *(const float *)(p);
  x->m01 = *(const float *)(p + 1 * s[1]);
  x->m02 = *(const float *)(p + 2 * s[1]);
  x->m03 = *(const float *)(p + 3 * s[1]);
  x->m10 = *(const float *)(p + 1 * s[0]);
  x->m11 = *(const float *)(p + 1 * s[0] + 1 * s[1]);
  x->m12 = *(const float *)(p + 1 * s[0] + 2 * s[1]);
  x->m13 = *(const float *)(p + 1 * s[0] + 3 * s[1]);
  x->m20 = *(const float *)(p + 2 * s[0]);
  x->m21 = *(const float *)(p + 2 * s[0] + 1 * s[1]);
  x->m22 = *(const float *)(p + 2 * s[0] + 2 * s[1]);
  x->m23 = *(const float *)(p + 2 * s[0] + 3 * s[1]);
  x->m30 = *(const float *)(p + 3 * s[0]);
  x->m31 = *(const float *)(p + 3 * s[0] + 1 * s[1]);
  x->m32 = *(const float *)(p + 3 * s[0] + 2 * s[1]);
  x->m33 = *(const float *)(p + 3 * s[0] + 3 * s[1]);
}

INLINED void store_mat4x4_single(
    const ksl_mat4x4f_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->m00;
  *(float *)(p + 1 * s[1]) = x->m01;
  *(float *)(p + 2 * s[1]) = x->m02;
  *(float *)(p + 3 * s[1]) = x->m03;
  *(float *)(p + 1 * s[0]) = x->m10;
  *(float *)(p + 1 * s[0] + 1 * s[1]) = x->m11;
  *(float *)(p + 1 * s[0] + 2 * s[1]) = x->m12;
  *(float *)(p + 1 * s[0] + 3 * s[1]) = x->m13;
  *(float *)(p + 2 * s[0]) = x->m20;
  *(float *)(p + 2 * s[0] + 1 * s[1]) = x->m21;
  *(float *)(p + 2 * s[0] + 2 * s[1]) = x->m22;
  *(float *)(p + 2 * s[0] + 3 * s[1]) = x->m23;
  *(float *)(p + 3 * s[0]) = x->m30;
  *(float *)(p + 3 * s[0] + 1 * s[1]) = x->m31;
  *(float *)(p + 3 * s[0] + 2 * s[1]) = x->m32;
  *(float *)(p + 3 * s[0] + 3 * s[1]) = x->m33;
}

INLINED void load_SE3_double(
    ksl_SE3_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m00 = *(const double *)(p);
  x->m01 = *(const double *)(p + 1 * s[1]);
  x->m02 = *(const double *)(p + 2 * s[1]);
  x->m03 = *(const double *)(p + 3 * s[1]);
  x->m10 = *(const double *)(p + 1 * s[0]);
  x->m11 = *(const double *)(p + 1 * s[0] + 1 * s[1]);
  x->m12 = *(const double *)(p + 1 * s[0] + 2 * s[1]);
  x->m13 = *(const double *)(p + 1 * s[0] + 3 * s[1]);
  x->m20 = *(const double *)(p + 2 * s[0]);
  x->m21 = *(const double *)(p + 2 * s[0] + 1 * s[1]);
  x->m22 = *(const double *)(p + 2 * s[0] + 2 * s[1]);
  x->m23 = *(const double *)(p + 2 * s[0] + 3 * s[1]);
}

INLINED void store_SE3_double(
    const ksl_SE3_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->m00;
  *(double *)(p + 1 * s[1]) = x->m01;
  *(double *)(p + 2 * s[1]) = x->m02;
  *(double *)(p + 3 * s[1]) = x->m03;
  *(double *)(p + 1 * s[0]) = x->m10;
  *(double *)(p + 1 * s[0] + 1 * s[1]) = x->m11;
  *(double *)(p + 1 * s[0] + 2 * s[1]) = x->m12;
  *(double *)(p + 1 * s[0] + 3 * s[1]) = x->m13;
  *(double *)(p + 2 * s[0]) = x->m20;
  *(double *)(p + 2 * s[0] + 1 * s[1]) = x->m21;
  *(double *)(p + 2 * s[0] + 2 * s[1]) = x->m22;
  *(double *)(p + 2 * s[0] + 3 * s[1]) = x->m23;
}

INLINED void load_SE3_single(
    ksl_SE3f_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m00 = *(const float *)(p);
  x->m01 = *(const float *)(p + 1 * s[1]);
  x->m02 = *(const float *)(p + 2 * s[1]);
  x->m03 = *(const float *)(p + 3 * s[1]);
  x->m10 = *(const float *)(p + 1 * s[0]);
  x->m11 = *(const float *)(p + 1 * s[0] + 1 * s[1]);
  x->m12 = *(const float *)(p + 1 * s[0] + 2 * s[1]);
  x->m13 = *(const float *)(p + 1 * s[0] + 3 * s[1]);
  x->m20 = *(const float *)(p + 2 * s[0]);
  x->m21 = *(const float *)(p + 2 * s[0] + 1 * s[1]);
  x->m22 = *(const float *)(p + 2 * s[0] + 2 * s[1]);
  x->m23 = *(const float *)(p + 2 * s[0] + 3 * s[1]);
}

INLINED void store_SE3_single(
    const ksl_SE3f_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->m00;
  *(float *)(p + 1 * s[1]) = x->m01;
  *(float *)(p + 2 * s[1]) = x->m02;
  *(float *)(p + 3 * s[1]) = x->m03;
  *(float *)(p + 1 * s[0]) = x->m10;
  *(float *)(p + 1 * s[0] + 1 * s[1]) = x->m11;
  *(float *)(p + 1 * s[0] + 2 * s[1]) = x->m12;
  *(float *)(p + 1 * s[0] + 3 * s[1]) = x->m13;
  *(float *)(p + 2 * s[0]) = x->m20;
  *(float *)(p + 2 * s[0] + 1 * s[1]) = x->m21;
  *(float *)(p + 2 * s[0] + 2 * s[1]) = x->m22;
  *(float *)(p + 2 * s[0] + 3 * s[1]) = x->m23;
}

INLINED void load_screw_double(
    ksl_screw_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m0 = *(const double *)(p);
  x->m1 = *(const double *)(p + 1 * s[0]);
  x->m2 = *(const double *)(p + 2 * s[0]);
  x->m3 = *(const double *)(p + 3 * s[0]);
  x->m4 = *(const double *)(p + 4 * s[0]);
  x->m5 = *(const double *)(p + 5 * s[0]);
}

INLINED void store_screw_double(
    const ksl_screw_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->m0;
  *(double *)(p + 1 * s[0]) = x->m1;
  *(double *)(p + 2 * s[0]) = x->m2;
  *(double *)(p + 3 * s[0]) = x->m3;
  *(double *)(p + 4 * s[0]) = x->m4;
  *(double *)(p + 5 * s[0]) = x->m5;
}

INLINED void load_screw_single(
    ksl_screwf_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m0 = *(const float *)(p);
  x->m1 = *(const float *)(p + 1 * s[0]);
  x->m2 = *(const float *)(p + 2 * s[0]);
  x->m3 = *(const float *)(p + 3 * s[0]);
  x->m4 = *(const float *)(p + 4 * s[0]);
  x->m5 = *(const float *)(p + 5 * s[0]);
}

INLINED void store_screw_single(
    const ksl_screwf_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->m0;
  *(float *)(p + 1 * s[0]) = x->m1;
  *(float *)(p + 2 * s[0]) = x->m2;
  *(float *)(p + 3 * s[0]) = x->m3;
  *(float *)(p + 4 * s[0]) = x->m4;
  *(float *)(p + 5 * s[0]) = x->m5;
}

INLINED void load_coscrew_double(
    ksl_coscrew_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m0 = *(const double *)(p);
  x->m1 = *(const double *)(p + 1 * s[0]);
  x->m2 = *(const double *)(p + 2 * s[0]);
  x->m3 = *(const double *)(p + 3 * s[0]);
  x->m4 = *(const double *)(p + 4 * s[0]);
  x->m5 = *(const double *)(p + 5 * s[0]);
}

INLINED void store_coscrew_double(
    const ksl_coscrew_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->m0;
  *(double *)(p + 1 * s[0]) = x->m1;
  *(double *)(p + 2 * s[0]) = x->m2;
  *(double *)(p + 3 * s[0]) = x->m3;
  *(double *)(p + 4 * s[0]) = x->m4;
  *(double *)(p + 5 * s[0]) = x->m5;
}

INLINED void load_coscrew_single(
    ksl_coscrewf_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m0 = *(const float *)(p);
  x->m1 = *(const float *)(p + 1 * s[0]);
  x->m2 = *(const float *)(p + 2 * s[0]);
  x->m3 = *(const float *)(p + 3 * s[0]);
  x->m4 = *(const float *)(p + 4 * s[0]);
  x->m5 = *(const float *)(p + 5 * s[0]);
}

INLINED void store_coscrew_single(
    const ksl_coscrewf_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->m0;
  *(float *)(p + 1 * s[0]) = x->m1;
  *(float *)(p + 2 * s[0]) = x->m2;
  *(float *)(p + 3 * s[0]) = x->m3;
  *(float *)(p + 4 * s[0]) = x->m4;
  *(float *)(p + 5 * s[0]) = x->m5;
}

INLINED void load_angular_first_double(
    double *x, const char *p, const npy_intp *s) {
  (void)s;
  x[0] = *(const double *)(p);
  x[1] = *(const double *)(p + 1 * s[0]);
  x[2] = *(const double *)(p + 2 * s[0]);
  x[3] = *(const double *)(p + 3 * s[0]);
  x[4] = *(const double *)(p + 4 * s[0]);
  x[5] = *(const double *)(p + 5 * s[0]);
}

INLINED void store_angular_first_double(
    const double *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x[0];
  *(double *)(p + 1 * s[0]) = x[1];
  *(double *)(p + 2 * s[0]) = x[2];
  *(double *)(p + 3 * s[0]) = x[3];
  *(double *)(p + 4 * s[0]) = x[4];
  *(double *)(p + 5 * s[0]) = x[5];
}

INLINED void load_angular_first_single(
    float *x, const char *p, const npy_intp *s) {
  (void)s;
  x[0] = *(const float *)(p);
  x[1] = *(const float *)(p + 1 * s[0]);
  x[2] = *(const float *)(p + 2 * s[0]);
  x[3] = *(const float *)(p + 3 * s[0]);
  x[4] = *(const float *)(p + 4 * s[0]);
  x[5] = *(const float *)(p + 5 * s[0]);
}

INLINED void store_angular_first_single(
    const float *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x[0];
  *(float *)(p + 1 * s[0]) = x[1];
  *(float *)(p + 2 * s[0]) = x[2];
  *(float *)(p + 3 * s[0]) = x[3];
  *(float *)(p + 4 * s[0]) = x[4];
  *(float *)(p + 5 * s[0]) = x[5];
}

INLINED void load_mat6x6_double(
    ksl_mat6x6_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->at[0][0] = *(const double *)(p);
  x->at[1][0] = *(const double *)(p + 1 * s[1]);
  x->at[2][0] = *(const double *)(p + 2 * s[1]);
  x->at[3][0] = *(const double *)(p + 3 * s[1]);
  x->at[4][0] = *(const double *)(p + 4 * s[1]);
  x->at[5][0] = *(const double *)(p + 5 * s[1]);
  x->at[0][1] = *(const double *)(p + 1 * s[0]);
  x->at[1][1] = *(const double *)(p + 1 * s[0] + 1 * s[1]);
  x->at[2][1] = *(const double *)(p + 1 * s[0] + 2 * s[1]);
  x->at[3][1] = *(const double *)(p + 1 * s[0] + 3 * s[1]);
  x->at[4][1] = *(const double *)(p + 1 * s[0] + 4 * s[1]);
  x->at[5][1] = *(const double *)(p + 1 * s[0] + 5 * s[1]);
  x->at[0][2] = *(const double *)(p + 2 * s[0]);
  x->at[1][2] = *(const double *)(p + 2 * s[0] + 1 * s[1]);
  x->at[2][2] = *(const double *)(p + 2 * s[0] + 2 * s[1]);
  x->at[3][2] = *(const double *)(p + 2 * s[0] + 3 * s[1]);
  x->at[4][2] = *(const double *)(p + 2 * s[0] + 4 * s[1]);
  x->at[5][2] = *(const double *)(p + 2 * s[0] + 5 * s[1]);
  x->at[0][3] = *(const double *)(p + 3 * s[0]);
  x->at[1][3] = *(const double *)(p + 3 * s[0] + 1 * s[1]);
  x->at[2][3] = *(const double *)(p + 3 * s[0] + 2 * s[1]);
  x->at[3][3] = *(const double *)(p + 3 * s[0] + 3 * s[1]);
  x->at[4][3] = *(const double *)(p + 3 * s[0] + 4 * s[1]);
  x->at[5][3] = *(const double *)(p + 3 * s[0] + 5 * s[1]);
  x->at[0][4] = *(const double *)(p + 4 * s[0]);
  x->at[1][4] = *(const double *)(p + 4 * s[0] + 1 * s[1]);
  x->at[2][4] = *(const double *)(p + 4 * s[0] + 2 * s[1]);
  x->at[3][4] = *(const double *)(p + 4 * s[0] + 3 * s[1]);
  x->at[4][4] = *(const double *)(p + 4 * s[0] + 4 * s[1]);
  x->at[5][4] = *(const double *)(p + 4 * s[0] + 5 * s[1]);
  x->at[0][5] = *(const double *)(p + 5 * s[0]);
  x->at[1][5] = *(const double *)(p + 5 * s[0] + 1 * s[1]);
  x->at[2][5] = *(const double *)(p + 5 * s[0] + 2 * s[1]);
  x->at[3][5] = *(const double *)(p + 5 * s[0] + 3 * s[1]);
  x->at[4][5] = *(const double *)(p + 5 * s[0] + 4 * s[1]);
  x->at[5][5] = *(const double *)(p + 5 * s[0] + 5 * s[1]);
}

INLINED void store_mat6x6_double(
    const ksl_mat6x6_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->at[0][0];
  *(double *)(p + 1 * s[1]) = x->at[1][0];
  *(double *)(p + 2 * s[1]) = x->at[2][0];
  *(double *)(p + 3 * s[1]) = x->at[3][0];
  *(double *)(p + 4 * s[1]) = x->at[4][0];
  *(double *)(p + 5 * s[1]) = x->at[5][0];
  *(double *)(p + 1 * s[0]) = x->at[0][1];
  *(double *)(p + 1 * s[0] + 1 * s[1]) = x->at[1][1];
  *(double *)(p + 1 * s[0] + 2 * s[1]) = x->at[2][1];
  *(double *)(p + 1 * s[0] + 3 * s[1]) = x->at[3][1];
  *(double *)(p + 1 * s[0] + 4 * s[1]) = x->at[4][1];
  *(double *)(p + 1 * s[0] + 5 * s[1]) = x->at[5][1];
  *(double *)(p + 2 * s[0]) = x->at[0][2];
  *(double *)(p + 2 * s[0] + 1 * s[1]) = x->at[1][2];
  *(double *)(p + 2 * s[0] + 2 * s[1]) = x->at[2][2];
  *(double *)(p + 2 * s[0] + 3 * s[1]) = x->at[3][2];
  *(double *)(p + 2 * s[0] + 4 * s[1]) = x->at[4][2];
  *(double *)(p + 2 * s[0] + 5 * s[1]) = x->at[5][2];
  *(double *)(p + 3 * s[0]) = x->at[0][3];
  *(double *)(p + 3 * s[0] + 1 * s[1]) = x->at[1][3];
  *(double *)(p + 3 * s[0] + 2 * s[1]) = x->at[2][3];
  *(double *)(p + 3 * s[0] + 3 * s[1]) = x->at[3][3];
  *(double *)(p + 3 * s[0] + 4 * s[1]) = x->at[4][3];
  *(double *)(p + 3 * s[0] + 5 * s[1]) = x->at[5][3];
  *(double *)(p + 4 * s[0]) = x->at[0][4];
  *(double *)(p + 4 * s[0] + 1 * s[1]) = x->at[1][4];
  *(double *)(p + 4 * s[0] + 2 * s[1]) = x->at[2][4];
  *(double *)(p + 4 * s[0] + 3 * s[1]) = x->at[3][4];
  *(double *)(p + 4 * s[0] + 4 * s[1]) = x->at[4][4];
  *(double *)(p + 4 * s[0] + 5 * s[1]) = x->at[5][4];
  *(double *)(p + 5 * s[0]) = x->at[0][5];
  *(double *)(p + 5 * s[0] + 1 * s[1]) = x->at[1][5];
  *(double *)(p + 5 * s[0] + 2 * s[1]) = x->at[2][5];
  *(double *)(p + 5 * s[0] + 3 * s[1]) = x->at[3][5];
  *(double *)(p + 5 * s[0] + 4 * s[1]) = x->at[4][5];
  *(double *)(p + 5 * s[0] + 5 * s[1]) = x->at[5][5];
}

INLINED void load_mat6x6_single(
    ksl_mat6x6f_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->at[0][0] = *(const float *)(p);
  x->at[1][0] = *(const float *)(p + 1 * s[1]);
  x->at[2][0] = *(const float *)(p + 2 * s[1]);
  x->at[3][0] = *(const float *)(p + 3 * s[1]);
  x->at[4][0] = *(const float *)(p + 4 * s[1]);
  x->at[5][0] = *(const float *)(p + 5 * s[1]);
  x->at[0][1] = *(const float *)(p + 1 * s[0]);
  x->at[1][1] = *(const float *)(p + 1 * s[0] + 1 * s[1]);
  x->at[2][1] = *(const float *)(p + 1 * s[0] + 2 * s[1]);
  x->at[3][1] = *(const float *)(p + 1 * s[0] + 3 * s[1]);
  x->at[4][1] = *(const float *)(p + 1 * s[0] + 4 * s[1]);
  x->at[5][1] = *(const float *)(p + 1 * s[0] + 5 * s[1]);
  x->at[0][2] = *(const float *)(p + 2 * s[0]);
  x->at[1][2] = *(const float *)(p + 2 * s[0] + 1 * s[1]);
  x->at[2][2] = *(const float *)(p + 2 * s[0] + 2 * s[1]);
  x->at[3][2] = *(const float *)(p + 2 * s[0] + 3 * s[1]);
  x->at[4][2] = *(const float *)(p + 2 * s[0] + 4 * s[1]);
  x->at[5][2] = *(const float *)(p + 2 * s[0] + 5 * s[1]);
  x->at[0][3] = *(const float *)(p + 3 * s[0]);
  x->at[1][3] = *(const float *)(p + 3 * s[0] + 1 * s[1]);
  x->at[2][3] = *(const float *)(p + 3 * s[0] + 2 * s[1]);
  x->at[3][3] = *(const float *)(p + 3 * s[0] + 3 * s[1]);
  x->at[4][3] = *(const float *)(p + 3 * s[0] + 4 * s[1]);
  x->at[5][3] = *(const float *)(p + 3 * s[0] + 5 * s[1]);
  x->at[0][4] = *(const float *)(p + 4 * s[0]);
  x->at[1][4] = *(const float *)(p + 4 * s[0] + 1 * s[1]);
  x->at[2][4] = *(const float *)(p + 4 * s[0] + 2 * s[1]);
  x->at[3][4] = *(const float *)(p + 4 * s[0] + 3 * s[1]);
  x->at[4][4] = *(const float *)(p + 4 * s[0] + 4 * s[1]);
  x->at[5][4] = *(const float *)(p + 4 * s[0] + 5 * s[1]);
  x->at[0][5] = *(const float *)(p + 5 * s[0]);
  x->at[1][5] = *(const float *)(p + 5 * s[0] + 1 * s[1]);
  x->at[2][5] = *(const float *)(p + 5 * s[0] + 2 * s[1]);
  x->at[3][5] = *(const float *)(p + 5 * s[0] + 3 * s[1]);
  x->at[4][5] = *(const float *)(p + 5 * s[0] + 4 * s[1]);
  x->at[5][5] = *(const float *)(p + 5 * s[0] + 5 * s[1]);
}

INLINED void store_mat6x6_single(
    const ksl_mat6x6f_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->at[0][0];
  *(float *)(p + 1 * s[1]) = x->at[1][0];
  *(float *)(p + 2 * s[1]) = x->at[2][0];
  *(float *)(p + 3 * s[1]) = x->at[3][0];
  *(float *)(p + 4 * s[1]) = x->at[4][0];
  *(float *)(p + 5 * s[1]) = x->at[5][0];
  *(float *)(p + 1 * s[0]) = x->at[0][1];
  *(float *)(p + 1 * s[0] + 1 * s[1]) = x->at[1][1];
  *(float *)(p + 1 * s[0] + 2 * s[1]) = x->at[2][1];
  *(float *)(p + 1 * s[0] + 3 * s[1]) = x->at[3][1];
  *(float *)(p + 1 * s[0] + 4 * s[1]) = x->at[4][1];
  *(float *)(p + 1 * s[0] + 5 * s[1]) = x->at[5][1];
  *(float *)(p + 2 * s[0]) = x->at[0][2];
  *(float *)(p + 2 * s[0] + 1 * s[1]) = x->at[1][2];
  *(float *)(p + 2 * s[0] + 2 * s[1]) = x->at[2][2];
  *(float *)(p + 2 * s[0] + 3 * s[1]) = x->at[3][2];
  *(float *)(p + 2 * s[0] + 4 * s[1]) = x->at[4][2];
  *(float *)(p + 2 * s[0] + 5 * s[1]) = x->at[5][2];
  *(float *)(p + 3 * s[0]) = x->at[0][3];
  *(float *)(p + 3 * s[0] + 1 * s[1]) = x->at[1][3];
  *(float *)(p + 3 * s[0] + 2 * s[1]) = x->at[2][3];
  *(float *)(p + 3 * s[0] + 3 * s[1]) = x->at[3][3];
  *(float *)(p + 3 * s[0] + 4 * s[1]) = x->at[4][3];
  *(float *)(p + 3 * s[0] + 5 * s[1]) = x->at[5][3];
  *(float *)(p + 4 * s[0]) = x->at[0][4];
  *(float *)(p + 4 * s[0] + 1 * s[1]) = x->at[1][4];
  *(float *)(p + 4 * s[0] + 2 * s[1]) = x->at[2][4];
  *(float *)(p + 4 * s[0] + 3 * s[1]) = x->at[3][4];
  *(float *)(p + 4 * s[0] + 4 * s[1]) = x->at[4][4];
  *(float *)(p + 4 * s[0] + 5 * s[1]) = x->at[5][4];
  *(float *)(p + 5 * s[0]) = x->at[0][5];
  *(float *)(p + 5 * s[0] + 1 * s[1]) = x->at[1][5];
  *(float *)(p + 5 * s[0] + 2 * s[1]) = x->at[2][5];
  *(float *)(p + 5 * s[0] + 3 * s[1]) = x->at[3][5];
  *(float *)(p + 5 * s[0] + 4 * s[1]) = x->at[4][5];
  *(float *)(p + 5 * s[0] + 5 * s[1]) = x->at[5][5];
}

INLINED void load_quaternion_double(
    ksl_quaternion_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->x = *(const double *)(p);
  x->y = *(const double *)(p + 1 * s[0]);
  x->z = *(const double *)(p + 2 * s[0]);
  x->w = *(const double *)(p + 3 * s[0]);
}

INLINED void store_quaternion_double(
    const ksl_quaternion_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->x;
  *(double *)(p + 1 * s[0]) = x->y;
  *(double *)(p + 2 * s[0]) = x->z;
  *(double *)(p + 3 * s[0]) = x->w;
}

INLINED void load_quaternion_single(
    ksl_quaternionf_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->x = *(const float *)(p);
  x->y = *(const float *)(p + 1 * s[0]);
  x->z = *(const float *)(p + 2 * s[0]);
  x->w = *(const float *)(p + 3 * s[0]);
}

INLINED void store_quaternion_single(
    const ksl_quaternionf_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->x;
  *(float *)(p + 1 * s[0]) = x->y;
  *(float *)(p + 2 * s[0]) = x->z;
  *(float *)(p + 3 * s[0]) = x->w;
}

INLINED void load_inertia_double(
    ksl_inertia_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m = *(const double *)(p);
  x->mt.x = *(const double *)(p + 1 * s[0]);
  x->mt.y = *(const double *)(p + 2 * s[0]);
  x->mt.z = *(const double *)(p + 3 * s[0]);
  x->Ixx = *(const double *)(p + 4 * s[0]);
  x->Iyy = *(const double *)(p + 5 * s[0]);
  x->Izz = *(const double *)(p + 6 * s[0]);
  x->Ixy = *(const double *)(p + 7 * s[0]);
  x->Iyz = *(const double *)(p + 8 * s[0]);
  x->Izx = *(const double *)(p + 9 * s[0]);
}

INLINED void store_inertia_double(
    const ksl_inertia_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->m;
  *(double *)(p + 1 * s[0]) = x->mt.x;
  *(double *)(p + 2 * s[0]) = x->mt.y;
  *(double *)(p + 3 * s[0]) = x->mt.z;
  *(double *)(p + 4 * s[0]) = x->Ixx;
  *(double *)(p + 5 * s[0]) = x->Iyy;
  *(double *)(p + 6 * s[0]) = x->Izz;
  *(double *)(p + 7 * s[0]) = x->Ixy;
  *(double *)(p + 8 * s[0]) = x->Iyz;
  *(double *)(p + 9 * s[0]) = x->Izx;
}

INLINED void load_inertia_single(
    ksl_inertiaf_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m = *(const float *)(p);
  x->mt.x = *(const float *)(p + 1 * s[0]);
  x->mt.y = *(const float *)(p + 2 * s[0]);
  x->mt.z = *(const float *)(p + 3 * s[0]);
  x->Ixx = *(const float *)(p + 4 * s[0]);
  x->Iyy = *(const float *)(p + 5 * s[0]);
  x->Izz = *(const float *)(p + 6 * s[0]);
  x->Ixy = *(const float *)(p + 7 * s[0]);
  x->Iyz = *(const float *)(p + 8 * s[0]);
  x->Izx = *(const float *)(p + 9 * s[0]);
}

INLINED void store_inertia_single(
    const ksl_inertiaf_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->m;
  *(float *)(p + 1 * s[0]) = x->mt.x;
  *(float *)(p + 2 * s[0]) = x->mt.y;
  *(float *)(p + 3 * s[0]) = x->mt.z;
  *(float *)(p + 4 * s[0]) = x->Ixx;
  *(float *)(p + 5 * s[0]) = x->Iyy;
  *(float *)(p + 6 * s[0]) = x->Izz;
  *(float *)(p + 7 * s[0]) = x->Ixy;
  *(float *)(p + 8 * s[0]) = x->Iyz;
  *(float *)(p + 9 * s[0]) = x->Izx;
}

INLINED void load_spatial_inertia_double(
    ksl_spatial_inertia_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m = *(const double *)(p);
  x->h.x = *(const double *)(p + 1 * s[0]);
  x->h.y = *(const double *)(p + 2 * s[0]);
  x->h.z = *(const double *)(p + 3 * s[0]);
  x->xx = *(const double *)(p + 4 * s[0]);
  x->yy = *(const double *)(p + 5 * s[0]);
  x->zz = *(const double *)(p + 6 * s[0]);
  x->xy = *(const double *)(p + 7 * s[0]);
  x->xz = *(const double *)(p + 8 * s[0]);
  x->yz = *(const double *)(p + 9 * s[0]);
}

INLINED void store_spatial_inertia_double(
    const ksl_spatial_inertia_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(double *)(p) = x->m;
  *(double *)(p + 1 * s[0]) = x->h.x;
  *(double *)(p + 2 * s[0]) = x->h.y;
  *(double *)(p + 3 * s[0]) = x->h.z;
  *(double *)(p + 4 * s[0]) = x->xx;
  *(double *)(p + 5 * s[0]) = x->yy;
  *(double *)(p + 6 * s[0]) = x->zz;
  *(double *)(p + 7 * s[0]) = x->xy;
  *(double *)(p + 8 * s[0]) = x->xz;
  *(double *)(p + 9 * s[0]) = x->yz;
}

INLINED void load_spatial_inertia_single(
    ksl_spatial_inertiaf_t *x, const char *p, const npy_intp *s) {
  (void)s;
  x->m = *(const float *)(p);
  x->h.x = *(const float *)(p + 1 * s[0]);
  x->h.y = *(const float *)(p + 2 * s[0]);
  x->h.z = *(const float *)(p + 3 * s[0]);
  x->xx = *(const float *)(p + 4 * s[0]);
  x->yy = *(const float *)(p + 5 * s[0]);
  x->zz = *(const float *)(p + 6 * s[0]);
  x->xy = *(const float *)(p + 7 * s[0]);
  x->xz = *(const float *)(p + 8 * s[0]);
  x->yz = *(const float *)(p + 9 * s[0]);
}

INLINED void store_spatial_inertia_single(
    const ksl_spatial_inertiaf_t *x, char *p, const npy_intp *s) {
  (void)s;
  *(float *)(p) = x->m;
  *(float *)(p + 1 * s[0]) = x->h.x;
  *(float *)(p + 2 * s[0]) = x->h.y;
  *(float *)(p + 3 * s[0]) = x->h.z;
  *(float *)(p + 4 * s[0]) = x->xx;
  *(float *)(p + 5 * s[0]) = x->yy;
  *(float *)(p + 6 * s[0]) = x->zz;
  *(float *)(p + 7 * s[0]) = x->xy;
  *(float *)(p + 8 * s[0]) = x->xz;
  *(float *)(p + 9 * s[0]) = x->yz;
}

#endif
