/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Sine and cosine of a joint angle. */
#ifndef KSL_TRIG_H
#define KSL_TRIG_H

#include "ksl_types.h"
#include "elementary.h"

/* dc = (sin θ, cos θ), θ in rad.
   theta: number; dc: (sin θ, cos θ).
   28 mul, 33 add, 1 abs.
   Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is subnormal; proved. */
static inline void ksl_dc(const double theta, double dc[2]) {
  double dc_1; const double dc_0 = ksl_sincos(theta, &dc_1);
  dc[0] = dc_0;
  dc[1] = dc_1;
}

/* dc = (sin θ, cos θ), θ in rad.
   theta: number; dc: (sin θ, cos θ).
   22 mul, 27 add, 1 abs.
   Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is subnormal; proved. */
static inline void ksl_dcf(const float theta, float dc[2]) {
  float dc_1; const float dc_0 = ksl_sincosf(theta, &dc_1);
  dc[0] = dc_0;
  dc[1] = dc_1;
}

/* What KSL declares beside formulas. */


/* The angle modulo 360, in [0, 360); exact, except for one rounding if the angle is negative. */
static inline double ksl_normalizeDegrees(double angle) {
  const double turn = 360.0, rest = fmod(angle, turn), above = rest + turn;
  const double zero = 0;
  return rest < zero ? (above < turn ? above : zero) : rest + zero;
}

/* The angle modulo 2 π, in [0, 2 π); error <= 1.2e-15 + 2e-32 |angle|, modulo 2 π.  Unchanged
   if it is in that interval and below the floating-point number nearest to 2 π. */
static inline double ksl_normalizeRadians(double angle) {
  /* 2 π = turn + beyond, except for 6e-33. */
  const double turn = 6.283185307179586, beyond = 2.4492935982947064e-16, zero = 0;
  const double rest = fmod(angle, turn), whole = angle - rest, turns = whole / turn;
  const double gathered = KSL_MUL(turns, beyond), less = fmod(gathered, turn);
  const double left = rest - less, part = fmod(left, turn);
  const double shifted = part + beyond, above = shifted + turn;
  return part < zero ? (above < turn ? above : zero) : part + zero;
}

/* The angle of the point (x, y) in [theta - π/4, theta - π/4 + 2 π).
   Error <= 4 u (|result| + π), modulo 2 π at the ends; NaN if theta is infinite. */
static inline double catan2pi(const double y, const double x, const double theta) {
  const double turn = 6.283185307179586, eighth = 0.7853981633974483;
  const double angle = ksl_atan2(y, x), least = theta - eighth, way = least - angle;
  const double turns = ceil(way / turn);
  const double whole = KSL_MUL(turns, turn);
  return angle + whole;
}

/* The angle of the point (x, y), or of its opposite, in [theta - π/4, theta - π/4 + π).
   Error <= 4 u (|result| + π), modulo π at the ends; NaN if theta is infinite. */
static inline double catan1pi(const double y, const double x, const double theta) {
  const double turn = 3.141592653589793, eighth = 0.7853981633974483;
  const double angle = ksl_atan2(y, x), least = theta - eighth, way = least - angle;
  const double turns = ceil(way / turn);
  const double whole = KSL_MUL(turns, turn);
  return angle + whole;
}

/* The angle modulo 360, in [0, 360); exact, except for one rounding if the angle is negative. */
static inline float ksl_normalizeDegreesf(float angle) {
  const float turn = 360.0f, rest = fmodf(angle, turn), above = rest + turn;
  const float zero = 0;
  return rest < zero ? (above < turn ? above : zero) : rest + zero;
}

/* The angle modulo 2 π, in [0, 2 π); error <= 8e-7 + 7e-15 |angle|, modulo 2 π.  Unchanged
   if it is in that interval and below the floating-point number nearest to 2 π. */
static inline float ksl_normalizeRadiansf(float angle) {
  /* 2 π = turn + beyond, except for 7e-15. */
  const float turn = 6.2831855f, beyond = -1.7484555e-07f, zero = 0;
  const float rest = fmodf(angle, turn), whole = angle - rest, turns = whole / turn;
  const float gathered = KSL_MULF(turns, beyond), less = fmodf(gathered, turn);
  const float left = rest - less, part = fmodf(left, turn);
  const float shifted = part + beyond, above = shifted + turn;
  return part < zero ? (above < turn ? above : zero) : part + zero;
}

/* The angle of the point (x, y) in [theta - π/4, theta - π/4 + 2 π).
   Error <= 4 u (|result| + π), modulo 2 π at the ends; NaN if theta is infinite. */
static inline float catan2pif(const float y, const float x, const float theta) {
  const float turn = 6.2831855f, eighth = 0.7853982f;
  const float angle = ksl_atan2f(y, x), least = theta - eighth, way = least - angle;
  const float turns = ceilf(way / turn);
  const float whole = KSL_MULF(turns, turn);
  return angle + whole;
}

/* The angle of the point (x, y), or of its opposite, in [theta - π/4, theta - π/4 + π).
   Error <= 4 u (|result| + π), modulo π at the ends; NaN if theta is infinite. */
static inline float catan1pif(const float y, const float x, const float theta) {
  const float turn = 3.1415927f, eighth = 0.7853982f;
  const float angle = ksl_atan2f(y, x), least = theta - eighth, way = least - angle;
  const float turns = ceilf(way / turn);
  const float whole = KSL_MULF(turns, turn);
  return angle + whole;
}

#endif
