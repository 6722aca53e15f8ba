/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Elementary functions, with the same bits on every machine. */
#ifndef KSL_ELEMENTARY_H
#define KSL_ELEMENTARY_H

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

#ifndef KSL_ATAN2
#define KSL_ATAN2
/* angle = atan2(y, x).
   arctan(a/b), and pi/4 + arctan((a - b)/(a + b)) above 1/2, a <= b being |x| and |y|; arctan q
     = q + q^3 p(q^2), p of degree 11, to 2^-57.7; the quotient to more than its digits; with all
     roundings within 0.934 ulp (both proved), results below the normal range within 0.51 of the
     least subnormal number.
   29 mul, 35 add, 1 div, 1 neg, 2 abs, 2 copysign, 6 less, 1 equal, 14 select. */
static KSL_INLINE double ksl_atan2(const double y, const double x) {
  const double height = fabs(y);
  const double width = fabs(x);
  const double a = width < height ? width : height, a_1 = width < height ? height : width;
  const double scale_3 = 1.0463951242053392e+298 < a_1 ? 9.094947017729282e-13 : 1.0,
      scale_4 = a_1 < 1.152921504606847e+18 ? 9.076030935533344e+279 : scale_3,
      scale = 1.7976931348623157e+308 < a_1 ? 0.0 : scale_4;
  const double scaled_a_2 = KSL_MUL(a, scale),
      scaled_a = 1.7976931348623157e+308 < a ? 1.0 : scaled_a_2;
  const double scaled_b_1 = KSL_MUL(a_1, scale),
      scaled_b_2 = 1.7976931348623157e+308 < a_1 ? 1.0 : scaled_b_1,
      scaled_b = scaled_b_2 == 0.0 ? 1.0 : scaled_b_2;
  const double above_1 = scaled_a + scaled_a;
  const double side = copysign(1.0, x);
  const double sign_1 = -side, sign = width < height ? sign_1 : side;
  const double quarters_2 = 2.0 - (side + side),
      quarters = (width < height ? 2.0 : quarters_2) + (scaled_b < above_1 ? sign : 0.0);
  const double base = KSL_MUL(quarters, 0.7853981633974483);
  const double total = scaled_a + scaled_b;
  const double n_1 = scaled_a - scaled_b, n = KSL_MUL(sign, scaled_b < above_1 ? n_1 : scaled_a);
  const double rest_of_d_2 = scaled_b - total + scaled_a,
      rest_of_d = scaled_b < above_1 ? rest_of_d_2 : 0.0;
  const double d = scaled_b < above_1 ? total : scaled_b;
  const double inverse = 1.0 / d;
  const double q_high_1 = KSL_MUL(n, inverse), q_high_2 = KSL_MUL(q_high_1, 134217729.0),
      q_high = q_high_2 - (q_high_2 - q_high_1);
  const double d_high_1 = KSL_MUL(d, 134217729.0), d_high = d_high_1 - (d_high_1 - d);
  const double d_low = d - d_high;
  const double but_high = n - KSL_MUL(q_high, d_high);
  const double but_low = but_high - KSL_MUL(q_high, d_low);
  const double c = KSL_MUL(but_low - KSL_MUL(q_high, rest_of_d), inverse);
  const double q = q_high + c;
  const double z = KSL_MUL(q, q);
  const double tail_12 = KSL_MUL(z, z), tail_19 = KSL_MUL(tail_12, tail_12),
      tail_16 = KSL_MUL(tail_12, KSL_MUL(z, -0.05121994511422147) + 0.058582966172403564)
          + (KSL_MUL(z, -0.06663810317366585) + 0.07692073887659807),
      tail_14 = KSL_MUL(tail_12, KSL_MUL(z, -0.09090896243462607) + 0.11111110659599031)
          + (KSL_MUL(z, -0.1428571427638533) + 0.19999999999903106),
      tail_23 = KSL_MUL(KSL_MUL(tail_19, tail_19), KSL_MUL(tail_12, 0.010116413558090894)
          + (KSL_MUL(z, -0.0274343623051046) + 0.04186470045016432)),
      tail_28 = KSL_MUL(KSL_MUL(q, z), KSL_MUL(z, tail_23 + (KSL_MUL(tail_19, tail_16) + tail_14))
          + -0.3333333333333298) + c, tail = tail_28 + KSL_MUL(quarters, 3.061616997868383e-17);
  const double sum = base + q_high;
  const double positive = sum + (base - sum + q_high + tail);
  const double angle_value = copysign(positive, y);
  return angle_value;
}
#endif

#ifndef KSL_POWER
#define KSL_POWER
/* 2^k by its bits, from 1.5 · 2^52 + k. */
static KSL_INLINE double ksl_power(const double shifted) {
  const uint64_t one = ((uint64_t)1023) << 52;
  uint64_t bits;
  double power;
  memcpy(&bits, &shifted, sizeof bits);
  bits = (bits << 52) + one;
  memcpy(&power, &bits, sizeof power);
  return power;
}
#endif

#ifndef KSL_EXP
#define KSL_EXP
/* y = exp x.
   x = k ln 2 + r, |r| <= ln 2 / 2, ln 2 as a sum of two numbers; e^r = 1 + r + r^2 q(r), q of
     degree 9, to 2^-57.3; with all roundings within 0.755 ulp (both proved), results below the
     normal range within 0.88 of the least subnormal number.
   19 mul, 20 add, 1 power of two, 3 less, 4 select. */
static KSL_INLINE double ksl_exp(const double x) {
  const double within_2 = 710.0 < x ? 710.0 : x, within = within_2 < -746.0 ? -746.0 : within_2;
  const double shifted = KSL_MUL(within, 1.4426950408889634) + 6755399441055744.0;
  const double k = shifted - 6755399441055744.0;
  const double high = within - KSL_MUL(k, 0.6931471805598903);
  const double rest = KSL_MUL(k, 5.497923018708371e-14);
  const double r = high - rest;
  const double low_10 = KSL_MUL(r, r), low_15 = KSL_MUL(low_10, low_10),
      low_14 = KSL_MUL(low_10, KSL_MUL(r, 2.762522584904681e-07) + 2.7557641500508844e-06)
          + (KSL_MUL(r, 2.4801508592805324e-05) + 0.00019841269465342197),
      low_12 = KSL_MUL(low_10, KSL_MUL(r, 0.0013888888926860458) + 0.008333333333500498)
          + (KSL_MUL(r, 0.04166666666660382) + 0.16666666666666433),
      low = KSL_MUL(KSL_MUL(r, r), KSL_MUL(r, KSL_MUL(KSL_MUL(low_15, low_15),
          2.4978234152604323e-08) + (KSL_MUL(low_15, low_14) + low_12)) + 0.5) - rest;
  const double start = high + 1.0;
  const double e_r = start + (1.0 - start + high + low);
  const double scaled = KSL_MUL(e_r, ksl_power(shifted + (within < -700.0 ? 64.0 : -1.0)));
  const double y_value = KSL_MUL(scaled, within < -700.0 ? 5.421010862427522e-20 : 2.0);
  return y_value;
}
#endif
#ifndef KSL_SINCOS
#define KSL_SINCOS
/* Its reduction of angles up to 6588396.0. */
static KSL_INLINED double ksl_sincos_near(const double x, double *r, double *r_excess) {
  const double quadrant_value = KSL_MUL(x, 0.6366197723675814) + 6755399441055744.0
          - 6755399441055744.0;
  const double high = x - KSL_MUL(quadrant_value, 1.5707963267341256)
          - KSL_MUL(quadrant_value, 6.077094383272197e-11);
  const double low = KSL_MUL(quadrant_value, 6.12323399409214e-17);
  const double r_value = high - low;
  const double r_excess_value = r_value - high + low
          + KSL_MUL(quadrant_value, 1.6446256936324258e-26);
  *r = r_value;
  *r_excess = r_excess_value;
  return quadrant_value;
}

#ifndef KSL_TWO_OVER_PI
#define KSL_TWO_OVER_PI
/* 2/pi is the sum of chunks of 26 bits.  Returns 2^768 times the one that is n after the first that
   matters to x modulo 2 pi, |x| >= 4 or not finite; for 0 <= n <= 9. */
static inline double ksl_two_over_pi(const double x, const int n) {
  static const double chunks[49] = {
    0.0, 1.552518092300709e+231, -5.641543713876639e+230, -6.396016207391955e+222,
    1.1126113092409047e+215, -8.436669302237339e+206, 1.5807217683269026e+199,
    4.880580955706536e+191, -7.185865841686167e+183, 1.63221799194198e+175, 1.4693593606398383e+168,
    -3.715978157723569e+159, 3.7407297269622413e+152, -5.4349642156801825e+144,
    -2.3240991502638365e+136, -7.402069681053744e+128, 4.056081919863044e+120,
    -2.8984041972202763e+113, -2.825206553789984e+105, -2.3319926745997907e+96,
    7.585087249414347e+89, -5.55745127382766e+81, -1.7591066618906454e+74, -1.2244638908582199e+66,
    7.688706724690006e+57, -6.642335162327314e+50, 5.0486372198203834e+42, 2.2707088482197588e+34,
    -6.272424989160333e+26, -1.614298573854212e+19, -570064896.0, 6159.934326171875,
    -1.4213062968337908e-05, -1.7819479073734323e-12, 2.312672511709599e-20, 1.9128857412445226e-28,
    -4.7275159220664295e-36, -7.857766278129624e-44, 1.0013967854884192e-51, -6.748739759997069e-60,
    2.9382392389751967e-67, 3.275166641861633e-75, 2.9838823028238618e-83, 5.698810044393321e-91,
    -7.348167503787565e-99, 1.224385720857395e-106, 2.1156250393735652e-115,
    -2.378423370797896e-122, -4.1290598927684836e-130
  };
  uint64_t encoded;
  memcpy(&encoded, &x, sizeof encoded);
  const int biased = (int)(encoded >> 52 & 0x7ff);
  return chunks[(biased - 1025) / 26 + n];
}
#endif

/* Its reduction of any larger angle. */
static KSL_COLD double ksl_sincos_far(const double x, double *r, double *r_excess) {
  const double scaled = KSL_MUL(x, 6.441148769597133e-232);
  const double x_high_1 = KSL_MUL(scaled, 134217729.0), x_high = x_high_1 - (x_high_1 - scaled);
  const double x_low = scaled - x_high;
  const double chunk0 = ksl_two_over_pi(x, 0);
  const double chunk1 = ksl_two_over_pi(x, 1);
  const double chunk2 = ksl_two_over_pi(x, 2);
  const double chunk3 = ksl_two_over_pi(x, 3);
  const double chunk4 = ksl_two_over_pi(x, 4);
  const double chunk5 = ksl_two_over_pi(x, 5);
  const double chunk6 = ksl_two_over_pi(x, 6);
  const double chunk7 = ksl_two_over_pi(x, 7);
  const double t0 = KSL_MUL(x_low, chunk0) + KSL_MUL(x_high, chunk1);
  const double t1 = KSL_MUL(x_low, chunk1) + KSL_MUL(x_high, chunk2);
  const double t2 = KSL_MUL(x_low, chunk2) + KSL_MUL(x_high, chunk3);
  const double t3 = KSL_MUL(x_low, chunk3) + KSL_MUL(x_high, chunk4);
  const double t4 = KSL_MUL(x_low, chunk4) + KSL_MUL(x_high, chunk5);
  const double t5 = KSL_MUL(x_low, chunk5) + KSL_MUL(x_high, chunk6);
  const double t6 = KSL_MUL(x_low, chunk6) + KSL_MUL(x_high, chunk7);
  const double rest0 = t0 - (t0 + 5.404319552844595e+16 - 5.404319552844595e+16);
  const double rest4 = rest0 - (rest0 + 2.7021597764222976e+16 - 2.7021597764222976e+16);
  const double k1 = t1 + 6755399441055744.0 - 6755399441055744.0;
  const double sum2_2 = rest4 + (t1 - k1), sum2 = sum2_2 + t2;
  const double sum2_error_1 = sum2 - sum2_2,
      sum2_error = sum2_2 - (sum2 - sum2_error_1) + (t2 - sum2_error_1);
  const double k2 = sum2 + 6755399441055744.0 - 6755399441055744.0;
  const double sum2_rest = sum2 - k2;
  const double sum3 = sum2_rest + t3;
  const double sum3_error_1 = sum3 - sum2_rest,
      sum3_error = sum2_rest - (sum3 - sum3_error_1) + (t3 - sum3_error_1);
  const double low3 = sum2_error + sum3_error;
  const double tail = t6 + t5;
  const double low4 = low3 + t4;
  const double low4_error_1 = low4 - low3,
      low4_error = low3 - (low4 - low4_error_1) + (t4 - low4_error_1);
  const double tail4 = tail + low4_error;
  const double f = sum3 + low4;
  const double f_error_1 = f - sum3, f_error = sum3 - (f - f_error_1) + (low4 - f_error_1);
  const double f_low = f_error + tail4;
  const double f_part_high_1 = KSL_MUL(f, 134217729.0),
      f_part_high = f_part_high_1 - (f_part_high_1 - f);
  const double f_part_low = f - f_part_high;
  const double product = KSL_MUL(f, 1.5707963267948966);
  const double product_excess_4 = product - KSL_MUL(f_part_high, 1.5707963407039642)
          - KSL_MUL(f_part_high, -1.3909067675399456e-08),
      product_excess = product_excess_4 - KSL_MUL(f_part_low, 1.5707963407039642)
          - KSL_MUL(f_part_low, -1.3909067675399456e-08);
  const double rest = product_excess
          - (KSL_MUL(f, 6.123233995736766e-17) + KSL_MUL(f_low, 1.5707963267948966));
  const double r_value = product - rest;
  const double quadrant_value = k1 + k2;
  const double r_excess_value = r_value - product + rest;
  *r = r_value;
  *r_excess = r_excess_value;
  return quadrant_value;
}

/* (s, c) = (sin x, cos x).
   x = k pi/2 + r - r_excess, |r| <= pi/4 and little more; pi/2 in parts to 2^-30, 2^-53, 2^-84
     and a rest, beyond the limit by the digits of 2/pi; polynomials of degrees 13 and 14 in r,
     to 2^-57.8; with all roundings within 0.824 ulp (both proved), for every finite x.
   28 mul, 33 add, 1 abs; beyond the limit, more. */
static KSL_INLINED double ksl_sincos(const double x, double *c) {
  double r, r_excess,
      quadrant = ksl_sincos_near(x, &r, &r_excess);
  if (fabs(x) > 6588396.0) {
    double far_r, far_r_excess;
    quadrant = ksl_sincos_far(x, &far_r, &far_r_excess);
    r = far_r;
    r_excess = far_r_excess;
  }
  const double z = KSL_MUL(r, r);
  const double z2 = KSL_MUL(z, z);
  const double half_z = KSL_MUL(z, 0.5);
  const double w = 1.0 - half_z;
  const double sin_r_8 = 0.00019841269829358447 + KSL_MUL(z, -2.7557313538442266e-06)
          + KSL_MUL(z2, 2.5050734370397888e-08 + KSL_MUL(z, -1.5895431762410801e-10)),
      sin_r = r
          - (KSL_MUL(KSL_MUL(z, r), 0.1666666666666663
          + (KSL_MUL(z, -0.00833333333332184) + KSL_MUL(z2, sin_r_8))) + KSL_MUL(r_excess, w));
  const double cos_r_9 = 2.48015872882953e-05 + KSL_MUL(z, -2.7557314015067576e-07)
          + KSL_MUL(z2, 2.087567807349307e-09 + KSL_MUL(z, -1.1357335951124145e-11)),
      cos_r_16 = 1.0 - w - half_z
          + (KSL_MUL(z2, 0.04166666666666659
          + (KSL_MUL(z, -0.0013888888888872186) + KSL_MUL(z2, cos_r_9))) + KSL_MUL(r, r_excess)),
      cos_r = w + cos_r_16;
  const double q = quadrant + 2.7021597764222976e+16 - 2.7021597764222976e+16 - quadrant;
  const double cos_k = 1.0 - fabs(q);
  const double minus_sin_k = KSL_MUL(q, 1.0 + cos_k);
  const double s_value = KSL_MUL(sin_r, cos_k) - KSL_MUL(cos_r, minus_sin_k);
  const double c_value = KSL_MUL(cos_r, cos_k) + KSL_MUL(sin_r, minus_sin_k);
  *c = c_value;
  return s_value;
}
#endif

#ifndef KSL_SIN
#define KSL_SIN
/* sin x, as ksl_sincos. */
static KSL_INLINE double ksl_sin(const double x) {
  double c;
  return ksl_sincos(x, &c);
}
#endif

#ifndef KSL_COS
#define KSL_COS
/* cos x, as ksl_sincos. */
static KSL_INLINE double ksl_cos(const double x) {
  double c;
  (void)ksl_sincos(x, &c);
  return c;
}
#endif
#ifndef KSL_TANH
#define KSL_TANH
/* y = tanh x.
   |x| < 5/8: x + x^3 p/q, of degrees 2 and 3 in x^2, to 2^-59.3; beyond: 1 - 2 / (e^2|x| + 1),
     e^2|x| as exp has it; with all roundings within 0.979 ulp (both proved).
   29 mul, 30 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select. */
static KSL_INLINE double ksl_tanh(const double x) {
  const double size = fabs(x);
  const double z = KSL_MUL(size, size);
  const double above = KSL_MUL(KSL_MUL(size, z), KSL_MUL(KSL_MUL(z, -0.00019908890916339926) +
          -0.020496786093244908, z) + -0.33333333333333326);
  const double below = KSL_MUL(KSL_MUL(KSL_MUL(z, 0.00020643828172711687)
          + 0.023288648134874086, z) + 0.4614903582797203, z) + 1.0;
  const double twice_1 = size + size, twice = 40.0 < twice_1 ? 40.0 : twice_1;
  const double shifted = KSL_MUL(twice, 1.4426950408889634) + 6755399441055744.0;
  const double k = shifted - 6755399441055744.0;
  const double high = twice - KSL_MUL(k, 0.6931471805598903);
  const double rest = KSL_MUL(k, 5.497923018708371e-14);
  const double r = high - rest;
  const double low_10 = KSL_MUL(r, r), low_15 = KSL_MUL(low_10, low_10),
      low_14 = KSL_MUL(low_10, KSL_MUL(r, 2.762522584904681e-07) + 2.7557641500508844e-06)
          + (KSL_MUL(r, 2.4801508592805324e-05) + 0.00019841269465342197),
      low_12 = KSL_MUL(low_10, KSL_MUL(r, 0.0013888888926860458) + 0.008333333333500498)
          + (KSL_MUL(r, 0.04166666666660382) + 0.16666666666666433),
      low = KSL_MUL(KSL_MUL(r, r), KSL_MUL(r, KSL_MUL(KSL_MUL(low_15, low_15),
          2.4978234152604323e-08) + (KSL_MUL(low_15, low_14) + low_12)) + 0.5) - rest;
  const double power = ksl_power(shifted);
  const double s_1 = power + 1.0, s = high + low;
  const double rest_of_e = KSL_MUL(s, power);
  const double total = s_1 + rest_of_e;
  const double low_of_total = s_1 - total + rest_of_e;
  const double quotient = (size < 0.625 ? above : -2.0) / (size < 0.625 ? below : total);
  const double correction_3 = KSL_MUL(KSL_MUL(quotient, low_of_total), KSL_MUL(quotient, 0.5)),
      correction = size < 0.625 ? 0.0 : correction_3;
  const double start = size < 0.625 ? size : 1.0;
  const double sum_1 = start + quotient, sum = sum_1 + (start - sum_1 + quotient + correction);
  const double y_value = copysign(sum, x);
  return y_value;
}
#endif

#ifndef KSL_ATAN2F
#define KSL_ATAN2F
/* angle = atan2(y, x).
   arctan(a/b), and pi/4 + arctan((a - b)/(a + b)) above 1/2, a <= b being |x| and |y|; arctan q
     = q + q^3 p(q^2), p of degree 5, to 2^-31.7; the quotient to more than its digits; with all
     roundings within 0.896 ulp (both proved), results below the normal range within 0.51 of the
     least subnormal number.
   22 mul, 29 add, 1 div, 1 neg, 2 abs, 2 copysign, 6 less, 1 equal, 14 select. */
static KSL_INLINE float ksl_atan2f(const float y, const float x) {
  const float height = fabsf(y);
  const float width = fabsf(x);
  const float a = width < height ? width : height, a_1 = width < height ? height : width;
  const float scale_3 = 1.2980742e+33f < a_1 ? 9.536743e-07f : 1.0f,
      scale_4 = a_1 < 2.6843546e+08f ? 4.8357033e+24f : scale_3,
      scale = 3.4028235e+38f < a_1 ? 0.0f : scale_4;
  const float scaled_a_2 = KSL_MULF(a, scale), scaled_a = 3.4028235e+38f < a ? 1.0f : scaled_a_2;
  const float scaled_b_1 = KSL_MULF(a_1, scale),
      scaled_b_2 = 3.4028235e+38f < a_1 ? 1.0f : scaled_b_1,
      scaled_b = scaled_b_2 == 0.0f ? 1.0f : scaled_b_2;
  const float above_1 = scaled_a + scaled_a;
  const float side = copysignf(1.0f, x);
  const float sign_1 = -side, sign = width < height ? sign_1 : side;
  const float quarters_2 = 2.0f - (side + side),
      quarters = (width < height ? 2.0f : quarters_2) + (scaled_b < above_1 ? sign : 0.0f);
  const float base = KSL_MULF(quarters, 0.78539824f);
  const float total = scaled_a + scaled_b;
  const float n_1 = scaled_a - scaled_b, n = KSL_MULF(sign, scaled_b < above_1 ? n_1 : scaled_a);
  const float rest_of_d_2 = scaled_b - total + scaled_a,
      rest_of_d = scaled_b < above_1 ? rest_of_d_2 : 0.0f;
  const float d = scaled_b < above_1 ? total : scaled_b;
  const float inverse = 1.0f / d;
  const float q_high_1 = KSL_MULF(n, inverse), q_high_2 = KSL_MULF(q_high_1, 4097.0f),
      q_high = q_high_2 - (q_high_2 - q_high_1);
  const float d_high_1 = KSL_MULF(d, 4097.0f), d_high = d_high_1 - (d_high_1 - d);
  const float d_low = d - d_high;
  const float but_high = n - KSL_MULF(q_high, d_high);
  const float but_low = but_high - KSL_MULF(q_high, d_low);
  const float c = KSL_MULF(but_low - KSL_MULF(q_high, rest_of_d), inverse);
  const float q = q_high + c;
  const float z = KSL_MULF(q, q);
  const float tail_6 = KSL_MULF(z, z),
      tail_8 = KSL_MULF(tail_6, KSL_MULF(z, -0.08009076f) + 0.10948411f)
          + (KSL_MULF(z, -0.14273107f) + 0.19999555f),
      tail_15 = KSL_MULF(KSL_MULF(q, z), KSL_MULF(z, KSL_MULF(KSL_MULF(tail_6, tail_6),
          0.039042152f) + tail_8) + -0.33333328f) + c,
      tail = tail_15 + KSL_MULF(quarters, -8.146034e-08f);
  const float sum = base + q_high;
  const float positive = sum + (base - sum + q_high + tail);
  const float angle_value = copysignf(positive, y);
  return angle_value;
}
#endif

#ifndef KSL_POWERF
#define KSL_POWERF
/* 2^k by its bits, from 1.5 · 2^23 + k. */
static KSL_INLINE float ksl_powerf(const float shifted) {
  const uint32_t one = ((uint32_t)127) << 23;
  uint32_t bits;
  float power;
  memcpy(&bits, &shifted, sizeof bits);
  bits = (bits << 23) + one;
  memcpy(&power, &bits, sizeof power);
  return power;
}
#endif

#ifndef KSL_EXPF
#define KSL_EXPF
/* y = exp x.
   x = k ln 2 + r, |r| <= ln 2 / 2, ln 2 as a sum of two numbers; e^r = 1 + r + r^2 q(r), q of
     degree 4, to 2^-27.9; with all roundings within 0.757 ulp (both proved), results below the
     normal range within 0.88 of the least subnormal number.
   12 mul, 15 add, 1 power of two, 3 less, 4 select. */
static KSL_INLINE float ksl_expf(const float x) {
  const float within_2 = 89.0f < x ? 89.0f : x, within = within_2 < -104.0f ? -104.0f : within_2;
  const float shifted = KSL_MULF(within, 1.442695f) + 1.2582912e+07f;
  const float k = shifted - 1.2582912e+07f;
  const float high = within - KSL_MULF(k, 0.69314575f);
  const float rest = KSL_MULF(k, 1.4286068e-06f);
  const float r = high - rest;
  const float low_10 = KSL_MULF(r, KSL_MULF(KSL_MULF(r, r), KSL_MULF(r, 0.0013863435f)
          + 0.008367437f) + (KSL_MULF(r, 0.04166724f) + 0.16666535f)) + 0.5f,
      low = KSL_MULF(KSL_MULF(r, r), low_10) - rest;
  const float start = high + 1.0f;
  const float e_r = start + (1.0f - start + high + low);
  const float scaled = KSL_MULF(e_r, ksl_powerf(shifted + (within < -80.0f ? 64.0f : -1.0f)));
  const float y_value = KSL_MULF(scaled, within < -80.0f ? 5.421011e-20f : 2.0f);
  return y_value;
}
#endif
#ifndef KSL_SINCOSF
#define KSL_SINCOSF
/* Its reduction of angles up to 1607.0f. */
static KSL_INLINED float ksl_sincos_nearf(const float x, float *r, float *r_excess) {
  const float quadrant_value = KSL_MULF(x, 0.63661975f) + 1.2582912e+07f - 1.2582912e+07f;
  const float high = x - KSL_MULF(quadrant_value, 1.5706787f)
          - KSL_MULF(quadrant_value, 0.000117599964f);
  const float low = KSL_MULF(quadrant_value, 1.589251e-08f);
  const float r_value = high - low;
  const float r_excess_value = r_value - high + low + KSL_MULF(quadrant_value, 7.443548e-13f);
  *r = r_value;
  *r_excess = r_excess_value;
  return quadrant_value;
}

#ifndef KSL_TWO_OVER_PIF
#define KSL_TWO_OVER_PIF
/* 2/pi is the sum of chunks of 12 bits.  Returns 2^96 times the one that is n after the first that
   matters to x modulo 2 pi, |x| >= 2 or not finite; for 0 <= n <= 9. */
static inline float ksl_two_over_pif(const float x, const int n) {
  static const float chunks[20] = {
    0.0f, 7.9228163e+28f, -2.8782106e+28f, -7.843851e+24f, 2.0349065e+21f, -1.2497489e+17f,
    2.3295903e+13f, -2.5836913e+10f, 2.576384e+06f, 2002.0f, -0.042236328f, 7.426739e-05f,
    -1.4697434e-08f, -4.195755e-12f, -1.4762497e-15f, -3.6676527e-19f, 5.588639e-23f, 8.330371e-28f,
    -8.3200174e-32f, 2.6782463e-34f
  };
  uint32_t encoded;
  memcpy(&encoded, &x, sizeof encoded);
  const int biased = (int)(encoded >> 23 & 0xff);
  return chunks[(biased - 128) / 12 + n];
}
#endif

/* Its reduction of any larger angle. */
static KSL_COLD float ksl_sincos_farf(const float x, float *r, float *r_excess) {
  const float scaled = KSL_MULF(x, 1.2621775e-29f);
  const float x_high_1 = KSL_MULF(scaled, 4097.0f), x_high = x_high_1 - (x_high_1 - scaled);
  const float x_low = scaled - x_high;
  const float chunk0 = ksl_two_over_pif(x, 0);
  const float chunk1 = ksl_two_over_pif(x, 1);
  const float chunk2 = ksl_two_over_pif(x, 2);
  const float chunk3 = ksl_two_over_pif(x, 3);
  const float chunk4 = ksl_two_over_pif(x, 4);
  const float chunk5 = ksl_two_over_pif(x, 5);
  const float chunk6 = ksl_two_over_pif(x, 6);
  const float chunk7 = ksl_two_over_pif(x, 7);
  const float chunk8 = ksl_two_over_pif(x, 8);
  const float t0 = KSL_MULF(x_low, chunk0) + KSL_MULF(x_high, chunk1);
  const float t1 = KSL_MULF(x_low, chunk1) + KSL_MULF(x_high, chunk2);
  const float t2 = KSL_MULF(x_low, chunk2) + KSL_MULF(x_high, chunk3);
  const float t3 = KSL_MULF(x_low, chunk3) + KSL_MULF(x_high, chunk4);
  const float t4 = KSL_MULF(x_low, chunk4) + KSL_MULF(x_high, chunk5);
  const float t5 = KSL_MULF(x_low, chunk5) + KSL_MULF(x_high, chunk6);
  const float t6 = KSL_MULF(x_low, chunk6) + KSL_MULF(x_high, chunk7);
  const float t7 = KSL_MULF(x_low, chunk7) + KSL_MULF(x_high, chunk8);
  const float rest0 = t0 - (t0 + 1.006633e+08f - 1.006633e+08f);
  const float rest4 = rest0 - (rest0 + 5.033165e+07f - 5.033165e+07f);
  const float k1 = t1 + 1.2582912e+07f - 1.2582912e+07f;
  const float sum2_2 = rest4 + (t1 - k1), sum2 = sum2_2 + t2;
  const float sum2_error_1 = sum2 - sum2_2,
      sum2_error = sum2_2 - (sum2 - sum2_error_1) + (t2 - sum2_error_1);
  const float k2 = sum2 + 1.2582912e+07f - 1.2582912e+07f;
  const float sum2_rest = sum2 - k2;
  const float sum3 = sum2_rest + t3;
  const float sum3_error_1 = sum3 - sum2_rest,
      sum3_error = sum2_rest - (sum3 - sum3_error_1) + (t3 - sum3_error_1);
  const float low3 = sum2_error + sum3_error;
  const float tail = t7 + t6;
  const float low4 = low3 + t4;
  const float low4_error_1 = low4 - low3,
      low4_error = low3 - (low4 - low4_error_1) + (t4 - low4_error_1);
  const float tail4 = tail + low4_error;
  const float low5 = low4 + t5;
  const float low5_error_1 = low5 - low4,
      low5_error = low4 - (low5 - low5_error_1) + (t5 - low5_error_1);
  const float tail5 = tail4 + low5_error;
  const float f = sum3 + low5;
  const float f_error_1 = f - sum3, f_error = sum3 - (f - f_error_1) + (low5 - f_error_1);
  const float f_low = f_error + tail5;
  const float f_part_high_1 = KSL_MULF(f, 4097.0f),
      f_part_high = f_part_high_1 - (f_part_high_1 - f);
  const float f_part_low = f - f_part_high;
  const float product = KSL_MULF(f, 1.5707964f);
  const float product_excess_6 = product - KSL_MULF(f_part_high, 1.5708008f)
          - KSL_MULF(f_part_high, -4.4107437e-06f) - KSL_MULF(f_part_low, 1.5708008f),
      product_excess = product_excess_6 - KSL_MULF(f_part_low, -4.4107437e-06f);
  const float rest = product_excess - (KSL_MULF(f, -4.371139e-08f) + KSL_MULF(f_low, 1.5707964f));
  const float r_value = product - rest;
  const float quadrant_value = k1 + k2;
  const float r_excess_value = r_value - product + rest;
  *r = r_value;
  *r_excess = r_excess_value;
  return quadrant_value;
}

/* (s, c) = (sin x, cos x).
   x = k pi/2 + r - r_excess, |r| <= pi/4 and little more; pi/2 in parts to 2^-13, 2^-24, 2^-39
     and a rest, beyond the limit by the digits of 2/pi; polynomials of degrees 7 and 8 in r, to
     2^-27.8; with all roundings within 0.85 ulp (both proved), for every finite x.
   22 mul, 27 add, 1 abs; beyond the limit, more. */
static KSL_INLINED float ksl_sincosf(const float x, float *c) {
  float r, r_excess,
      quadrant = ksl_sincos_nearf(x, &r, &r_excess);
  if (fabsf(x) > 1607.0f) {
    float far_r, far_r_excess;
    quadrant = ksl_sincos_farf(x, &far_r, &far_r_excess);
    r = far_r;
    r_excess = far_r_excess;
  }
  const float z = KSL_MULF(r, r);
  const float z2 = KSL_MULF(z, z);
  const float half_z = KSL_MULF(z, 0.5f);
  const float w = 1.0f - half_z;
  const float sin_r = r
          - (KSL_MULF(KSL_MULF(z, r), 0.16666654f
          + (KSL_MULF(z, -0.008332106f) + KSL_MULF(z2, 0.00019507883f))) + KSL_MULF(r_excess, w));
  const float cos_r = w
          + (1.0f - w - half_z
          + (KSL_MULF(z2, 0.041666646f
          + (KSL_MULF(z, -0.0013887308f) + KSL_MULF(z2, 2.44321e-05f))) + KSL_MULF(r, r_excess)));
  const float q = quadrant + 5.033165e+07f - 5.033165e+07f - quadrant;
  const float cos_k = 1.0f - fabsf(q);
  const float minus_sin_k = KSL_MULF(q, 1.0f + cos_k);
  const float s_value = KSL_MULF(sin_r, cos_k) - KSL_MULF(cos_r, minus_sin_k);
  const float c_value = KSL_MULF(cos_r, cos_k) + KSL_MULF(sin_r, minus_sin_k);
  *c = c_value;
  return s_value;
}
#endif

#ifndef KSL_SINF
#define KSL_SINF
/* sin x, as ksl_sincosf. */
static KSL_INLINE float ksl_sinf(const float x) {
  float c;
  return ksl_sincosf(x, &c);
}
#endif

#ifndef KSL_COSF
#define KSL_COSF
/* cos x, as ksl_sincosf. */
static KSL_INLINE float ksl_cosf(const float x) {
  float c;
  (void)ksl_sincosf(x, &c);
  return c;
}
#endif
#ifndef KSL_TANHF
#define KSL_TANHF
/* y = tanh x.
   |x| < 5/8: x + x^3 p/q, of degrees 2 and 1 in x^2, to 2^-31.2; beyond: 1 - 2 / (e^2|x| + 1),
     e^2|x| as exp has it; with all roundings within 0.967 ulp (both proved).
   20 mul, 23 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select. */
static KSL_INLINE float ksl_tanhf(const float x) {
  const float size = fabsf(x);
  const float z = KSL_MULF(size, size);
  const float above = KSL_MULF(KSL_MULF(size, z), KSL_MULF(KSL_MULF(z, 5.9599424e-05f) +
          -0.0017358434f, z) + -0.33333334f);
  const float below = KSL_MULF(z, 0.4052077f) + 1.0f;
  const float twice_1 = size + size, twice = 20.0f < twice_1 ? 20.0f : twice_1;
  const float shifted = KSL_MULF(twice, 1.442695f) + 1.2582912e+07f;
  const float k = shifted - 1.2582912e+07f;
  const float high = twice - KSL_MULF(k, 0.69314575f);
  const float rest = KSL_MULF(k, 1.4286068e-06f);
  const float r = high - rest;
  const float low_10 = KSL_MULF(r, KSL_MULF(KSL_MULF(r, r), KSL_MULF(r, 0.0013863435f)
          + 0.008367437f) + (KSL_MULF(r, 0.04166724f) + 0.16666535f)) + 0.5f,
      low = KSL_MULF(KSL_MULF(r, r), low_10) - rest;
  const float power = ksl_powerf(shifted);
  const float s_1 = power + 1.0f, s = high + low;
  const float rest_of_e = KSL_MULF(s, power);
  const float total = s_1 + rest_of_e;
  const float low_of_total = s_1 - total + rest_of_e;
  const float quotient = (size < 0.625f ? above : -2.0f) / (size < 0.625f ? below : total);
  const float correction_3 = KSL_MULF(KSL_MULF(quotient, low_of_total), KSL_MULF(quotient, 0.5f)),
      correction = size < 0.625f ? 0.0f : correction_3;
  const float start = size < 0.625f ? size : 1.0f;
  const float sum_1 = start + quotient, sum = sum_1 + (start - sum_1 + quotient + correction);
  const float y_value = copysignf(sum, x);
  return y_value;
}
#endif


#endif
