/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Elementary functions, with the same bits on every machine.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_ELEMENTARY_ACCURATE_H
#define KSL_ELEMENTARY_ACCURATE_H

#include "ksl_exact.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* s = sin x, c = cos x, x in rad.
   x, c: number.
   83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline double ksl_sincos_accurate(const double x, double *c) {
  double c_; const double s = ksl_sincos(x, &c_);
  double c_own_error; const double s_own_error = ksl_sincos_error(x, s, c_, &c_own_error);
  const double s_rounded = s + s_own_error;
  const double c_rounded = c_ + c_own_error;
  const double s_final = s_rounded == s_rounded ? s_rounded : s;
  const double c_final = c_rounded == c_rounded ? c_rounded : c_;
  *c = c_final;
  return s_final;
}

/* s = sin x, x in rad.
   x: number.
   83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline double ksl_sin_accurate(const double x) {
  const double s = ksl_sin(x);
  const double s_rounded = s + ksl_sin_error(x, s),
      s_final = s_rounded == s_rounded ? s_rounded : s;
  return s_final;
}

/* c = cos x, x in rad.
   x: number.
   83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline double ksl_cos_accurate(const double x) {
  const double c = ksl_cos(x);
  const double c_rounded = c + ksl_cos_error(x, c),
      c_final = c_rounded == c_rounded ? c_rounded : c;
  return c_final;
}

/* y = e^x.
   x: number.
   81 mul, 148 add, 14 product error, 5 power of two, 1 abs, 7 less, 2 equal, 10 select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline double ksl_exp_accurate(const double x) {
  const double y = ksl_exp(x);
  const double y_rounded = y + ksl_exp_error(x, y),
      y_final = y_rounded == y_rounded ? y_rounded : y;
  return y_final;
}

/* y = tanh x.
   x: number.
   91 mul, 174 add, 15 product error, 2 div, 2 power of two, 4 abs, 2 copysign, 5 less, 1 equal,
     12 select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline double ksl_tanh_accurate(const double x) {
  const double y = ksl_tanh(x);
  const double y_rounded = y + ksl_tanh_error(x, y),
      y_final = y_rounded == y_rounded ? y_rounded : y;
  return y_final;
}

/* angle of the vector (x, y) to the x axis, in rad, from -π to π.
   y, x: number.
   122 mul, 213 add, 21 product error, 2 div, 1 neg, 8 abs, 4 copysign, 13 less, 4 equal, 24
     select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline double ksl_atan2_accurate(const double y, const double x) {
  const double angle = ksl_atan2(y, x);
  const double angle_rounded = angle + ksl_atan2_error(y, x, angle),
      angle_final = angle_rounded == angle_rounded ? angle_rounded : angle;
  return angle_final;
}

/* s = sin x, c = cos x, x in rad.
   x, c: number.
   28 mul, 33 add, 1 abs.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline float ksl_sincosf_accurate(const float x, float *c) {
  double c_; const double s = ksl_sincos((double)x, &c_);
  *c = (float)c_;
  return (float)s;
}

/* s = sin x, x in rad.
   x: number.
   28 mul, 33 add, 1 abs.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline float ksl_sinf_accurate(const float x) {
  const double s = ksl_sin((double)x);
  return (float)s;
}

/* c = cos x, x in rad.
   x: number.
   28 mul, 33 add, 1 abs.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline float ksl_cosf_accurate(const float x) {
  const double c = ksl_cos((double)x);
  return (float)c;
}

/* y = e^x.
   x: number.
   19 mul, 20 add, 1 power of two, 3 less, 4 select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline float ksl_expf_accurate(const float x) {
  const double y = ksl_exp((double)x);
  return (float)y;
}

/* y = tanh x.
   x: number.
   29 mul, 30 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline float ksl_tanhf_accurate(const float x) {
  const double y = ksl_tanh((double)x);
  return (float)y;
}

/* angle of the vector (x, y) to the x axis, in rad, from -π to π.
   y, x: number.
   29 mul, 35 add, 1 div, 1 neg, 2 abs, 2 copysign, 6 less, 1 equal, 14 select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline float ksl_atan2f_accurate(const float y, const float x) {
  const double angle = ksl_atan2((double)y, (double)x);
  return (float)angle;
}

#endif
