/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Functions of many elements: what they share.

   ksl_…_many computes n elements of arrays of structs: element i of argument x is x[i * x_stride].
   ksl_…_planes computes n elements of structures of arrays, which hold one component of every
   element each: component j of element i is x[j * x_plane + i * x_stride], components in the order
   in which the struct has them, matrices column by column.  Strides are 1, or 0 for one element
   shared by all, or any other; planes that are a multiple of 2048 bytes apart are slower.

   The bits are those of the function of one element.  n may be 0, or less: then nothing is read or
   written.  Pointers need only their type's alignment.  An output may be an input with the same
   strides, not 0; else it must overlap neither inputs nor other outputs, which is not checked.
   No heap, no state: all functions are thread-safe.

   Compilers make vector instructions of these loops: gcc with -O3, clang with -O2, for your
   processor with -march=native or the oldest one that must run them.  They are inlined: write
   strides as numbers where you can.  Functions that call sine, cosine, arctangent, exp or tanh are
   on vector types where the compiler has them, as wide as the processor's, whatever the flags; in
   tiers they are loops over one element. */
#ifndef KSL_PLANES_H
#define KSL_PLANES_H

#include <stddef.h>

#include "ksl_types.h"

#include <stdint.h>

/* Functions that a file need not call.  Rare paths are never inlined; sine and cosine always are,
   unless the compiler optimises for size, so that processors compute several at the same time. */
#ifndef KSL_COLD
#ifdef __GNUC__
#define KSL_COLD __attribute__((noinline, cold, unused))
#define KSL_INLINE inline __attribute__((unused))
#define KSL_LIKELY(test) __builtin_expect(test, 1)
#else
#define KSL_COLD
#define KSL_INLINE inline
#define KSL_LIKELY(test) (test)
#endif
#if defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define KSL_INLINED inline __attribute__((always_inline, unused))
#else
#define KSL_INLINED KSL_INLINE
#endif
#endif

/* Of a loop: no iteration needs another's results. */
#if defined(__clang__)
#define KSL_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#pragma clang diagnostic ignored "-Wpass-failed" /* said of loops that it leaves as they are */
#elif defined(__GNUC__)
#define KSL_INDEPENDENT _Pragma("GCC ivdep")
#elif defined(_MSC_VER)
#define KSL_INDEPENDENT __pragma(loop(ivdep))
#else
#define KSL_INDEPENDENT
#endif
/* The loop, over i. */
#define KSL_EACH_OF(n) KSL_INDEPENDENT for (ptrdiff_t i = 0; i < (n); ++i)

static KSL_INLINED ksl_vec3_t ksl_vec3_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_vec3_t value = {{{x[0], x[plane], x[2 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_vec3_to_planes(
    const ksl_vec3_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
}

static KSL_INLINED ksl_vec3f_t ksl_vec3f_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_vec3f_t value = {{{x[0], x[plane], x[2 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_vec3f_to_planes(
    const ksl_vec3f_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
}

static KSL_INLINED ksl_vec4_t ksl_vec4_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_vec4_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_vec4_to_planes(
    const ksl_vec4_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
}

static KSL_INLINED ksl_vec4f_t ksl_vec4f_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_vec4f_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_vec4f_to_planes(
    const ksl_vec4f_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
}

static KSL_INLINED ksl_mat3x3_t ksl_mat3x3_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_mat3x3_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_mat3x3_to_planes(
    const ksl_mat3x3_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->as_array[0];
  x[plane] = value->as_array[1];
  x[2 * plane] = value->as_array[2];
  x[3 * plane] = value->as_array[3];
  x[4 * plane] = value->as_array[4];
  x[5 * plane] = value->as_array[5];
  x[6 * plane] = value->as_array[6];
  x[7 * plane] = value->as_array[7];
  x[8 * plane] = value->as_array[8];
}

static KSL_INLINED ksl_mat3x3f_t ksl_mat3x3f_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_mat3x3f_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_mat3x3f_to_planes(
    const ksl_mat3x3f_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->as_array[0];
  x[plane] = value->as_array[1];
  x[2 * plane] = value->as_array[2];
  x[3 * plane] = value->as_array[3];
  x[4 * plane] = value->as_array[4];
  x[5 * plane] = value->as_array[5];
  x[6 * plane] = value->as_array[6];
  x[7 * plane] = value->as_array[7];
  x[8 * plane] = value->as_array[8];
}

static KSL_INLINED ksl_mat4x4_t ksl_mat4x4_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_mat4x4_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane], x[10 * plane],
    x[11 * plane], x[12 * plane], x[13 * plane], x[14 * plane], x[15 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_mat4x4_to_planes(
    const ksl_mat4x4_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->as_array[0];
  x[plane] = value->as_array[1];
  x[2 * plane] = value->as_array[2];
  x[3 * plane] = value->as_array[3];
  x[4 * plane] = value->as_array[4];
  x[5 * plane] = value->as_array[5];
  x[6 * plane] = value->as_array[6];
  x[7 * plane] = value->as_array[7];
  x[8 * plane] = value->as_array[8];
  x[9 * plane] = value->as_array[9];
  x[10 * plane] = value->as_array[10];
  x[11 * plane] = value->as_array[11];
  x[12 * plane] = value->as_array[12];
  x[13 * plane] = value->as_array[13];
  x[14 * plane] = value->as_array[14];
  x[15 * plane] = value->as_array[15];
}

static KSL_INLINED ksl_mat4x4f_t ksl_mat4x4f_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_mat4x4f_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane], x[10 * plane],
    x[11 * plane], x[12 * plane], x[13 * plane], x[14 * plane], x[15 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_mat4x4f_to_planes(
    const ksl_mat4x4f_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->as_array[0];
  x[plane] = value->as_array[1];
  x[2 * plane] = value->as_array[2];
  x[3 * plane] = value->as_array[3];
  x[4 * plane] = value->as_array[4];
  x[5 * plane] = value->as_array[5];
  x[6 * plane] = value->as_array[6];
  x[7 * plane] = value->as_array[7];
  x[8 * plane] = value->as_array[8];
  x[9 * plane] = value->as_array[9];
  x[10 * plane] = value->as_array[10];
  x[11 * plane] = value->as_array[11];
  x[12 * plane] = value->as_array[12];
  x[13 * plane] = value->as_array[13];
  x[14 * plane] = value->as_array[14];
  x[15 * plane] = value->as_array[15];
}

static KSL_INLINED ksl_SE3_t ksl_SE3_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_SE3_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane], x[5 * plane],
    x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane], x[10 * plane], x[11 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_SE3_to_planes(
    const ksl_SE3_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->as_array[0];
  x[plane] = value->as_array[1];
  x[2 * plane] = value->as_array[2];
  x[3 * plane] = value->as_array[3];
  x[4 * plane] = value->as_array[4];
  x[5 * plane] = value->as_array[5];
  x[6 * plane] = value->as_array[6];
  x[7 * plane] = value->as_array[7];
  x[8 * plane] = value->as_array[8];
  x[9 * plane] = value->as_array[9];
  x[10 * plane] = value->as_array[10];
  x[11 * plane] = value->as_array[11];
}

static KSL_INLINED ksl_SE3f_t ksl_SE3f_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_SE3f_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane], x[10 * plane],
    x[11 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_SE3f_to_planes(
    const ksl_SE3f_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->as_array[0];
  x[plane] = value->as_array[1];
  x[2 * plane] = value->as_array[2];
  x[3 * plane] = value->as_array[3];
  x[4 * plane] = value->as_array[4];
  x[5 * plane] = value->as_array[5];
  x[6 * plane] = value->as_array[6];
  x[7 * plane] = value->as_array[7];
  x[8 * plane] = value->as_array[8];
  x[9 * plane] = value->as_array[9];
  x[10 * plane] = value->as_array[10];
  x[11 * plane] = value->as_array[11];
}

static KSL_INLINED ksl_screw_t ksl_screw_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_screw_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_screw_to_planes(
    const ksl_screw_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
  x[4 * plane] = value->at[4];
  x[5 * plane] = value->at[5];
}

static KSL_INLINED ksl_screwf_t ksl_screwf_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_screwf_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_screwf_to_planes(
    const ksl_screwf_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
  x[4 * plane] = value->at[4];
  x[5 * plane] = value->at[5];
}

static KSL_INLINED ksl_coscrew_t ksl_coscrew_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_coscrew_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_coscrew_to_planes(
    const ksl_coscrew_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
  x[4 * plane] = value->at[4];
  x[5 * plane] = value->at[5];
}

static KSL_INLINED ksl_coscrewf_t ksl_coscrewf_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_coscrewf_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_coscrewf_to_planes(
    const ksl_coscrewf_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
  x[4 * plane] = value->at[4];
  x[5 * plane] = value->at[5];
}

static KSL_INLINED ksl_mat6x6_t ksl_mat6x6_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_mat6x6_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane], x[10 * plane],
    x[11 * plane], x[12 * plane], x[13 * plane], x[14 * plane], x[15 * plane], x[16 * plane],
    x[17 * plane], x[18 * plane], x[19 * plane], x[20 * plane], x[21 * plane], x[22 * plane],
    x[23 * plane], x[24 * plane], x[25 * plane], x[26 * plane], x[27 * plane], x[28 * plane],
    x[29 * plane], x[30 * plane], x[31 * plane], x[32 * plane], x[33 * plane], x[34 * plane],
    x[35 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_mat6x6_to_planes(
    const ksl_mat6x6_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->as_array[0];
  x[plane] = value->as_array[1];
  x[2 * plane] = value->as_array[2];
  x[3 * plane] = value->as_array[3];
  x[4 * plane] = value->as_array[4];
  x[5 * plane] = value->as_array[5];
  x[6 * plane] = value->as_array[6];
  x[7 * plane] = value->as_array[7];
  x[8 * plane] = value->as_array[8];
  x[9 * plane] = value->as_array[9];
  x[10 * plane] = value->as_array[10];
  x[11 * plane] = value->as_array[11];
  x[12 * plane] = value->as_array[12];
  x[13 * plane] = value->as_array[13];
  x[14 * plane] = value->as_array[14];
  x[15 * plane] = value->as_array[15];
  x[16 * plane] = value->as_array[16];
  x[17 * plane] = value->as_array[17];
  x[18 * plane] = value->as_array[18];
  x[19 * plane] = value->as_array[19];
  x[20 * plane] = value->as_array[20];
  x[21 * plane] = value->as_array[21];
  x[22 * plane] = value->as_array[22];
  x[23 * plane] = value->as_array[23];
  x[24 * plane] = value->as_array[24];
  x[25 * plane] = value->as_array[25];
  x[26 * plane] = value->as_array[26];
  x[27 * plane] = value->as_array[27];
  x[28 * plane] = value->as_array[28];
  x[29 * plane] = value->as_array[29];
  x[30 * plane] = value->as_array[30];
  x[31 * plane] = value->as_array[31];
  x[32 * plane] = value->as_array[32];
  x[33 * plane] = value->as_array[33];
  x[34 * plane] = value->as_array[34];
  x[35 * plane] = value->as_array[35];
}

static KSL_INLINED ksl_mat6x6f_t ksl_mat6x6f_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_mat6x6f_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane], x[10 * plane],
    x[11 * plane], x[12 * plane], x[13 * plane], x[14 * plane], x[15 * plane], x[16 * plane],
    x[17 * plane], x[18 * plane], x[19 * plane], x[20 * plane], x[21 * plane], x[22 * plane],
    x[23 * plane], x[24 * plane], x[25 * plane], x[26 * plane], x[27 * plane], x[28 * plane],
    x[29 * plane], x[30 * plane], x[31 * plane], x[32 * plane], x[33 * plane], x[34 * plane],
    x[35 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_mat6x6f_to_planes(
    const ksl_mat6x6f_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->as_array[0];
  x[plane] = value->as_array[1];
  x[2 * plane] = value->as_array[2];
  x[3 * plane] = value->as_array[3];
  x[4 * plane] = value->as_array[4];
  x[5 * plane] = value->as_array[5];
  x[6 * plane] = value->as_array[6];
  x[7 * plane] = value->as_array[7];
  x[8 * plane] = value->as_array[8];
  x[9 * plane] = value->as_array[9];
  x[10 * plane] = value->as_array[10];
  x[11 * plane] = value->as_array[11];
  x[12 * plane] = value->as_array[12];
  x[13 * plane] = value->as_array[13];
  x[14 * plane] = value->as_array[14];
  x[15 * plane] = value->as_array[15];
  x[16 * plane] = value->as_array[16];
  x[17 * plane] = value->as_array[17];
  x[18 * plane] = value->as_array[18];
  x[19 * plane] = value->as_array[19];
  x[20 * plane] = value->as_array[20];
  x[21 * plane] = value->as_array[21];
  x[22 * plane] = value->as_array[22];
  x[23 * plane] = value->as_array[23];
  x[24 * plane] = value->as_array[24];
  x[25 * plane] = value->as_array[25];
  x[26 * plane] = value->as_array[26];
  x[27 * plane] = value->as_array[27];
  x[28 * plane] = value->as_array[28];
  x[29 * plane] = value->as_array[29];
  x[30 * plane] = value->as_array[30];
  x[31 * plane] = value->as_array[31];
  x[32 * plane] = value->as_array[32];
  x[33 * plane] = value->as_array[33];
  x[34 * plane] = value->as_array[34];
  x[35 * plane] = value->as_array[35];
}

static KSL_INLINED ksl_quaternion_t ksl_quaternion_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_quaternion_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_quaternion_to_planes(
    const ksl_quaternion_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
}

static KSL_INLINED ksl_quaternionf_t ksl_quaternionf_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_quaternionf_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_quaternionf_to_planes(
    const ksl_quaternionf_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
}

static KSL_INLINED ksl_inertia_t ksl_inertia_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_inertia_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_inertia_to_planes(
    const ksl_inertia_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
  x[4 * plane] = value->at[4];
  x[5 * plane] = value->at[5];
  x[6 * plane] = value->at[6];
  x[7 * plane] = value->at[7];
  x[8 * plane] = value->at[8];
  x[9 * plane] = value->at[9];
}

static KSL_INLINED ksl_inertiaf_t ksl_inertiaf_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_inertiaf_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_inertiaf_to_planes(
    const ksl_inertiaf_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
  x[4 * plane] = value->at[4];
  x[5 * plane] = value->at[5];
  x[6 * plane] = value->at[6];
  x[7 * plane] = value->at[7];
  x[8 * plane] = value->at[8];
  x[9 * plane] = value->at[9];
}

static KSL_INLINED ksl_spatial_inertia_t ksl_spatial_inertia_of_planes(const double *x, const ptrdiff_t plane) {
  const ksl_spatial_inertia_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_spatial_inertia_to_planes(
    const ksl_spatial_inertia_t *value, double *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
  x[4 * plane] = value->at[4];
  x[5 * plane] = value->at[5];
  x[6 * plane] = value->at[6];
  x[7 * plane] = value->at[7];
  x[8 * plane] = value->at[8];
  x[9 * plane] = value->at[9];
}

static KSL_INLINED ksl_spatial_inertiaf_t ksl_spatial_inertiaf_of_planes(const float *x, const ptrdiff_t plane) {
  const ksl_spatial_inertiaf_t value = {{{x[0], x[plane], x[2 * plane], x[3 * plane], x[4 * plane],
    x[5 * plane], x[6 * plane], x[7 * plane], x[8 * plane], x[9 * plane]}}};
  return value;
}

static KSL_INLINED void ksl_spatial_inertiaf_to_planes(
    const ksl_spatial_inertiaf_t *value, float *x, const ptrdiff_t plane) {
  x[0] = value->at[0];
  x[plane] = value->at[1];
  x[2 * plane] = value->at[2];
  x[3 * plane] = value->at[3];
  x[4 * plane] = value->at[4];
  x[5 * plane] = value->at[5];
  x[6 * plane] = value->at[6];
  x[7 * plane] = value->at[7];
  x[8 * plane] = value->at[8];
  x[9 * plane] = value->at[9];
}

#endif
