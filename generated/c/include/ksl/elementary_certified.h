/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Elementary functions, with the same bits on every machine.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_ELEMENTARY_CERTIFIED_H
#define KSL_ELEMENTARY_CERTIFIED_H

#include "ksl_types.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* s = sin x, c = cos x, x in rad; |error of s| <= s_bound, |error of c| <= c_bound unless inf or
     NaN.
   x, c, s_bound, c_bound: number.
   83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select. */
static inline double ksl_sincos_certified(const double x, double *c, double *s_bound,
    double *c_bound) {
  double c_; const double s = ksl_sincos(x, &c_);
  double c_own_error_1; const double s_own_error_1 = ksl_sincos_error(x, s, c_, &c_own_error_1);
  const double s_bound_1 = 3.7470896994678994e-30 + fabs(s_own_error_1),
      c_bound_1 = 3.7470896994678994e-30 + fabs(c_own_error_1);
  *c = c_;
  *s_bound = s_bound_1;
  *c_bound = c_bound_1;
  return s;
}

/* s = sin x, x in rad; |error of s| <= s_bound unless inf or NaN.
   x, s_bound: number.
   83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select. */
static inline double ksl_sin_certified(const double x, double *s_bound) {
  const double s = ksl_sin(x);
  const double s_bound_1 = 3.7470896994678994e-30 + fabs(ksl_sin_error(x, s));
  *s_bound = s_bound_1;
  return s;
}

/* c = cos x, x in rad; |error of c| <= c_bound unless inf or NaN.
   x, c_bound: number.
   83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select. */
static inline double ksl_cos_certified(const double x, double *c_bound) {
  const double c = ksl_cos(x);
  const double c_bound_1 = 3.7470896994678994e-30 + fabs(ksl_cos_error(x, c));
  *c_bound = c_bound_1;
  return c;
}

/* y = e^x; |error of y| <= y_bound unless inf or NaN.
   x, y_bound: number.
   82 mul, 149 add, 14 product error, 5 power of two, 2 abs, 7 less, 1 equal, 9 select. */
static inline double ksl_exp_certified(const double x, double *y_bound) {
  const double y = ksl_exp(x);
  const double y_bound_1 = fabs(ksl_exp_error(x, y))
          + KSL_MUL(3.7470896994679e-30, 1.8051943758648296e-276 + y);
  *y_bound = y_bound_1;
  return y;
}

/* y = tanh x; |error of y| <= y_bound unless inf or NaN.
   x, y_bound: number.
   92 mul, 175 add, 15 product error, 2 div, 2 power of two, 6 abs, 2 copysign, 5 less, 11
     select. */
static inline double ksl_tanh_certified(const double x, double *y_bound) {
  const double y = ksl_tanh(x);
  const double y_bound_1 = fabs(ksl_tanh_error(x, y))
          + KSL_MUL(3.7470896994679e-30, 1.8051943758648296e-276 + fabs(y));
  *y_bound = y_bound_1;
  return y;
}

/* angle of the vector (x, y) to the x axis, in rad, from -π to π; |error of angle| <=
     angle_bound unless inf or NaN.
   y, x, angle_bound: number.
   123 mul, 214 add, 21 product error, 2 div, 1 neg, 10 abs, 4 copysign, 13 less, 3 equal, 23
     select. */
static inline double ksl_atan2_certified(const double y, const double x, double *angle_bound) {
  const double angle = ksl_atan2(y, x);
  const double angle_bound_1 = fabs(ksl_atan2_error(y, x, angle))
          + KSL_MUL(3.7470896994679e-30, 1.8051943758648296e-276 + fabs(angle));
  *angle_bound = angle_bound_1;
  return angle;
}

/* s = sin x, c = cos x, x in rad; |error of s| <= s_bound, |error of c| <= c_bound unless inf or
     NaN.
   x, c, s_bound, c_bound: number.
   65 mul, 100 add, 8 product error, 1 div, 5 abs, 1 less, 1 select. */
static inline float ksl_sincosf_certified(const float x, float *c, float *s_bound, float *c_bound) {
  float c_; const float s = ksl_sincosf(x, &c_);
  float c_own_error_1; const float s_own_error_1 = ksl_sincos_errorf(x, s, c_, &c_own_error_1);
  const float s_bound_1 = 1.0800312e-12f + fabsf(s_own_error_1),
      c_bound_1 = 1.0800312e-12f + fabsf(c_own_error_1);
  *c = c_;
  *s_bound = s_bound_1;
  *c_bound = c_bound_1;
  return s;
}

/* s = sin x, x in rad; |error of s| <= s_bound unless inf or NaN.
   x, s_bound: number.
   65 mul, 99 add, 8 product error, 1 div, 4 abs, 1 less, 1 select. */
static inline float ksl_sinf_certified(const float x, float *s_bound) {
  const float s = ksl_sinf(x);
  const float s_bound_1 = 1.0800312e-12f + fabsf(ksl_sin_errorf(x, s));
  *s_bound = s_bound_1;
  return s;
}

/* c = cos x, x in rad; |error of c| <= c_bound unless inf or NaN.
   x, c_bound: number.
   65 mul, 99 add, 8 product error, 1 div, 4 abs, 1 less, 1 select. */
static inline float ksl_cosf_certified(const float x, float *c_bound) {
  const float c = ksl_cosf(x);
  const float c_bound_1 = 1.0800312e-12f + fabsf(ksl_cos_errorf(x, c));
  *c_bound = c_bound_1;
  return c;
}

/* y = e^x; |error of y| <= y_bound unless inf or NaN.
   x, y_bound: number.
   52 mul, 98 add, 8 product error, 5 power of two, 2 abs, 7 less, 1 equal, 9 select. */
static inline float ksl_expf_certified(const float x, float *y_bound) {
  const float y = ksl_expf(x);
  const float y_bound_1 = fabsf(ksl_exp_errorf(x, y))
          + KSL_MULF(1.0800314e-12f, 3.3087225e-24f + y);
  *y_bound = y_bound_1;
  return y;
}

/* y = tanh x; |error of y| <= y_bound unless inf or NaN.
   x, y_bound: number.
   60 mul, 122 add, 9 product error, 2 div, 2 power of two, 6 abs, 2 copysign, 5 less, 11 select. */
static inline float ksl_tanhf_certified(const float x, float *y_bound) {
  const float y = ksl_tanhf(x);
  const float y_bound_1 = fabsf(ksl_tanh_errorf(x, y))
          + KSL_MULF(1.0800314e-12f, 3.3087225e-24f + fabsf(y));
  *y_bound = y_bound_1;
  return y;
}

/* angle of the vector (x, y) to the x axis, in rad, from -π to π; |error of angle| <=
     angle_bound unless inf or NaN.
   y, x, angle_bound: number.
   89 mul, 155 add, 14 product error, 2 div, 1 neg, 10 abs, 4 copysign, 13 less, 3 equal, 23
     select. */
static inline float ksl_atan2f_certified(const float y, const float x, float *angle_bound) {
  const float angle = ksl_atan2f(y, x);
  const float angle_bound_1 = fabsf(ksl_atan2_errorf(y, x, angle))
          + KSL_MULF(1.0800314e-12f, 3.3087225e-24f + fabsf(angle));
  *angle_bound = angle_bound_1;
  return angle;
}

#endif
