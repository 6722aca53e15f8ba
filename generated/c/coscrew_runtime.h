/* Made by `coscrew generate SCENE`, the same for every scene; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* What the C of all scenes shares: products that are rounded once, sines and cosines, exp and tanh.
   A program vendors it once, beside the files of its scenes; arm.c, armf.c, … include it, and what
   calls them need not.  It has no state, and no function with external linkage.
   Flags that would break the bits promised are refused, unless COSCREW_ALLOW_FAST_MATH is defined.
   Define KSL_CONTRACT_OFF if clang is not given -ffp-contract=fast: products are faster then. */
#ifndef COSCREW_RUNTIME
/* Of this text, without comments: files that were made for another one refuse to compile. */
#define COSCREW_RUNTIME 0x33b50b35

#if !defined(COSCREW_ALLOW_FAST_MATH)
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "-ffast-math breaks the bits promised here; \
define COSCREW_ALLOW_FAST_MATH to accept that"
#elif defined(__RECIPROCAL_MATH__)
#error "-freciprocal-math breaks the bits promised here; \
define COSCREW_ALLOW_FAST_MATH to accept that"
#elif defined(__NO_SIGNED_ZEROS__)
#error "-fno-signed-zeros breaks the bits promised here; \
define COSCREW_ALLOW_FAST_MATH to accept that"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "-ffinite-math-only breaks what is promised of NaN; \
define COSCREW_ALLOW_FAST_MATH to accept that"
#elif defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 1
#error "floats are computed in double: compile with -fexcess-precision=fast; \
define COSCREW_ALLOW_FAST_MATH to accept that"
#elif defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "the x87 rounds twice: compile with -msse2 -mfpmath=sse; \
define COSCREW_ALLOW_FAST_MATH to accept that"
#elif defined(__GNUC__) && !defined(__clang__) && !defined(__STRICT_ANSI__) && \
    (defined(__x86_64__) || defined(__aarch64__)) && __GCC_IEC_559 == 0
#error "-funsafe-math-optimizations or a part of it breaks the bits promised here; \
define COSCREW_ALLOW_FAST_MATH to accept that"
#endif
#if defined(__GNUC__) && !defined(__clang__) && !defined(__cplusplus)
__extension__ _Static_assert(sizeof(.5) == __SIZEOF_DOUBLE__,
    "-fsingle-precision-constant breaks the bits promised here; "
    "define COSCREW_ALLOW_FAST_MATH to accept that");
#elif defined(__GNUC__) && !defined(__clang__) && __cplusplus >= 201103L
static_assert(sizeof(.5) == __SIZEOF_DOUBLE__,
    "-fsingle-precision-constant breaks the bits promised here; "
    "define COSCREW_ALLOW_FAST_MATH to accept that");
#elif defined(__GNUC__) && !defined(__clang__)
typedef char
    COSCREW_ALLOW_FAST_MATH_accepts_fsingle_precision_constant
    [sizeof(.5) == __SIZEOF_DOUBLE__ ? 1 : -1];
#endif
#endif


#include <float.h>
#include <math.h>
#include <string.h>

/* Whether the target has a fused multiply-add instruction, in double precision (KSL_HAS_FMA) and in
   single (KSL_HAS_FMAF).  Both may be defined before this is included. */
#ifndef KSL_HAS_FMA
#if defined(__FMA__) || defined(__FMA4__) || defined(__FP_FAST_FMA) || defined(__aarch64__) || \
    defined(__s390x__) || defined(__powerpc64__) || \
    (defined(__riscv_flen) && __riscv_flen >= 64) || \
    (defined(__ARM_FEATURE_FMA) && defined(__ARM_FP) && (__ARM_FP & 8))
#define KSL_HAS_FMA 1
#else
#define KSL_HAS_FMA 0
#endif
#endif
#ifndef KSL_HAS_FMAF
#if KSL_HAS_FMA || defined(__ARM_FEATURE_FMA) || defined(__FP_FAST_FMAF) || defined(__riscv_flen)
#define KSL_HAS_FMAF 1
#else
#define KSL_HAS_FMAF 0
#endif
#endif

/* Keeps gcc from contracting across statements.  gcc ignores a lone flag -fassociative-math, but
   any such pragma would put it in force; hence no-associative-math.  The pragma holds to the end of
   the compiled file: functions with different options would not be inlined. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off", "no-associative-math")
#elif defined(_MSC_VER) && !defined(__clang__)
#pragma fp_contract(off)
#endif
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 14 && defined(__riscv_vector)
#pragma GCC optimize("no-tree-vectorize") /* the vectoriser contracts in spite of the pragma */
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

#ifndef KSL_RN
/* KSL_RN(a * b) is the product, rounded to double on its own: never fused into a sum. */
#if defined(__clang__) && KSL_HAS_FMA && !defined(KSL_CONTRACT_OFF)
/* With -ffp-contract=fast, which no macro reveals, clang fuses every product into a sum.  So it is
   hidden that this is one.  Defining KSL_CONTRACT_OFF says that the flag is not given. */
static inline __attribute__((unused)) double ksl_rounded(double x) {
#if defined(__x86_64__) || defined(__i386__)
  __asm__("" : "+x"(x));
#elif defined(__aarch64__) || defined(__arm__)
  __asm__("" : "+w"(x));
#else
  __asm__("" : "+f"(x));
#endif
  return x;
}
#define KSL_RN(product) ksl_rounded(product)
#elif defined(__GNUC__) && !defined(__clang__) && (__GNUC__ == 12 || __GNUC__ == 13) && \
    (defined(__x86_64__) || defined(__i386__))
/* The vectoriser of these versions contracts in spite of flag and pragma where sums and differences
   alternate. */
#define KSL_RN(product) __builtin_assoc_barrier(product)
#else
#define KSL_RN(product) (product)
#endif
#endif

#ifndef KSL_RNF
/* KSL_RNF(a * b) is the product, rounded to float on its own: never fused into a sum. */
#if defined(__clang__) && KSL_HAS_FMAF && !defined(KSL_CONTRACT_OFF)
/* With -ffp-contract=fast, which no macro reveals, clang fuses every product into a sum.  So it is
   hidden that this is one.  Defining KSL_CONTRACT_OFF says that the flag is not given. */
static inline __attribute__((unused)) float ksl_roundedf(float x) {
#if defined(__x86_64__) || defined(__i386__)
  __asm__("" : "+x"(x));
#elif defined(__aarch64__) || defined(__arm__)
  __asm__("" : "+w"(x));
#else
  __asm__("" : "+f"(x));
#endif
  return x;
}
#define KSL_RNF(product) ksl_roundedf(product)
#elif defined(__GNUC__) && !defined(__clang__) && (__GNUC__ == 12 || __GNUC__ == 13) && \
    (defined(__x86_64__) || defined(__i386__))
/* The vectoriser of these versions contracts in spite of flag and pragma where sums and differences
   alternate. */
#define KSL_RNF(product) __builtin_assoc_barrier(product)
#else
#define KSL_RNF(product) (product)
#endif
#endif

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

/* Above a loop whose rounds processors compute several at a time. */
#ifndef COSCREW_UNROLLED
#if defined(__clang__)
#define COSCREW_UNROLLED _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__) && __GNUC__ >= 8
#define COSCREW_UNROLLED _Pragma("GCC unroll 64")
#else
#define COSCREW_UNROLLED
#endif
#endif

#if DBL_MANT_DIG == 53
#define RN(product) KSL_RN(product)
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
  const int steep = width < height;
  const double a = steep ? width : height, a_1 = steep ? height : width;
  const int infinite = 1.7976931348623157e+308 < a_1;
  const double scale = infinite ? 0.0
          : (a_1 < 1.152921504606847e+18 ? 9.076030935533344e+279
          : (1.0463951242053392e+298 < a_1 ? 9.094947017729282e-13 : 1.0));
  const double scaled_a = 1.7976931348623157e+308 < a ? 1.0 : RN(a * scale);
  const double scaled_b_1 = infinite ? 1.0 : RN(a_1 * scale),
      scaled_b = scaled_b_1 == 0.0 ? 1.0 : scaled_b_1;
  const int above = scaled_b < scaled_a + scaled_a;
  const double side = copysign(1.0, x);
  const double sign = steep ? -side : side;
  const double quarters = (steep ? 2.0 : 2.0 - (side + side)) + (above ? sign : 0.0);
  const double base = RN(quarters * 0.7853981633974483);
  const double total = scaled_a + scaled_b;
  const double n = RN(sign * (above ? scaled_a - scaled_b : scaled_a));
  const double rest_of_d = above ? scaled_b - total + scaled_a : 0.0;
  const double d = above ? total : scaled_b;
  const double inverse = 1.0 / d;
  const double q_high_1 = RN(n * inverse), q_high_2 = RN(q_high_1 * 134217729.0),
      q_high = q_high_2 - (q_high_2 - q_high_1);
  const double d_high_1 = RN(d * 134217729.0), d_high = d_high_1 - (d_high_1 - d);
  const double d_low = d - d_high;
  const double but_high = n - RN(q_high * d_high);
  const double but_low = but_high - RN(q_high * d_low);
  const double c = RN((but_low - RN(q_high * rest_of_d)) * inverse);
  const double q = q_high + c;
  const double z = q * q;
  const double tail_1 = z * z, tail_2 = tail_1 * tail_1,
      tail_3 = RN(tail_2
          * (RN(tail_1 * (RN(z * -0.05121994511422147) + 0.058582966172403564))
          + (RN(z * -0.06663810317366585) + 0.07692073887659807))),
      tail_4 = tail_3
          + (RN(tail_1 * (RN(z * -0.09090896243462607) + 0.11111110659599031))
          + (RN(z * -0.1428571427638533) + 0.19999999999903106)),
      tail_5 = RN(z
          * (RN(tail_2 * tail_2
          * (RN(tail_1 * 0.010116413558090894)
          + (RN(z * -0.0274343623051046) + 0.04186470045016432))) + tail_4)),
      tail = RN(q * z * (tail_5 + -0.3333333333333298)) + c + RN(quarters * 3.061616997868383e-17);
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
  const double within_1 = 710.0 < x ? 710.0 : x, within = within_1 < -746.0 ? -746.0 : within_1;
  const double shifted = RN(within * 1.4426950408889634) + 6755399441055744.0;
  const double k = shifted - 6755399441055744.0;
  const double high = within - RN(k * 0.6931471805598903);
  const double rest = RN(k * 5.497923018708371e-14);
  const double r = high - rest;
  const double low_1 = r * r,
      low_2 = RN(low_1 * (RN(r * 0.0013888888926860458) + 0.008333333333500498))
          + (RN(r * 0.04166666666660382) + 0.16666666666666433),
      low_3 = RN(low_1 * (RN(r * 2.762522584904681e-07) + 2.7557641500508844e-06))
          + (RN(r * 2.4801508592805324e-05) + 0.00019841269465342197), low_4 = low_1 * low_1,
      low = RN(r * r
          * (RN(r * (RN(low_4 * low_4 * 2.4978234152604323e-08) + (RN(low_4 * low_3) + low_2)))
          + 0.5)) - rest;
  const int small = within < -700.0;
  const double start = high + 1.0;
  const double e_r = start + (1.0 - start + high + low);
  const double scaled = e_r * ksl_power(shifted + (small ? 64.0 : -1.0));
  const double y_value = RN(scaled * (small ? 5.421010862427522e-20 : 2.0));
  return y_value;
}
#endif
#ifndef KSL_SINCOS
#define KSL_SINCOS
/* Its reduction of angles up to 6588396.0. */
static KSL_INLINED double ksl_sincos_near(const double x, double *r, double *r_excess) {
  const double shift = 6755399441055744.0;
  const double quadrant_value = RN(x * 0.6366197723675814) + shift - shift;
  const double high = x - RN(quadrant_value * 1.5707963267341256)
          - RN(quadrant_value * 6.077094383272197e-11);
  const double low = RN(quadrant_value * 6.12323399409214e-17);
  const double r_value = high - low;
  const double r_excess_value = r_value - high + low + RN(quadrant_value * 1.6446256936324258e-26);
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
  const double shift8 = 5.404319552844595e+16, shift4 = 2.7021597764222976e+16,
      shift = 6755399441055744.0;
  const double scaled = RN(x * 6.441148769597133e-232);
  const double x_high_1 = RN(scaled * 134217729.0), x_high = x_high_1 - (x_high_1 - scaled);
  const double x_low = scaled - x_high;
  const double chunk0 = ksl_two_over_pi(x, 0);
  const double chunk1 = ksl_two_over_pi(x, 1);
  const double chunk2 = ksl_two_over_pi(x, 2);
  const double chunk3 = ksl_two_over_pi(x, 3);
  const double chunk4 = ksl_two_over_pi(x, 4);
  const double chunk5 = ksl_two_over_pi(x, 5);
  const double chunk6 = ksl_two_over_pi(x, 6);
  const double chunk7 = ksl_two_over_pi(x, 7);
  const double t0 = RN(x_low * chunk0) + RN(x_high * chunk1);
  const double t1 = RN(x_low * chunk1) + RN(x_high * chunk2);
  const double t2 = RN(x_low * chunk2) + RN(x_high * chunk3);
  const double t3 = RN(x_low * chunk3) + RN(x_high * chunk4);
  const double t4 = RN(x_low * chunk4) + RN(x_high * chunk5);
  const double t5 = RN(x_low * chunk5) + RN(x_high * chunk6);
  const double t6 = RN(x_low * chunk6) + RN(x_high * chunk7);
  const double rest0 = t0 - (t0 + shift8 - shift8);
  const double rest4 = rest0 - (rest0 + shift4 - shift4);
  const double k1 = t1 + shift - shift;
  const double sum2_1 = rest4 + (t1 - k1), sum2 = sum2_1 + t2;
  const double sum2_error_1 = sum2 - sum2_1,
      sum2_error = sum2_1 - (sum2 - sum2_error_1) + (t2 - sum2_error_1);
  const double k2 = sum2 + shift - shift;
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
  const double f_part_high_1 = RN(f * 134217729.0),
      f_part_high = f_part_high_1 - (f_part_high_1 - f);
  const double f_part_low = f - f_part_high;
  const double product = RN(f * 1.5707963267948966);
  const double product_excess_1 = product - RN(f_part_high * 1.5707963407039642)
          - RN(f_part_high * -1.3909067675399456e-08) - RN(f_part_low * 1.5707963407039642),
      product_excess = product_excess_1 - RN(f_part_low * -1.3909067675399456e-08);
  const double rest = product_excess
          - (RN(f * 6.123233995736766e-17) + RN(f_low * 1.5707963267948966));
  const double r_value = product - rest;
  const double r_excess_value = r_value - product + rest;
  const double quadrant_value = k1 + k2;
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
  const double shift4 = 2.7021597764222976e+16;
  const double z = r * r;
  const double z2 = z * z;
  const double half_z = RN(z * 0.5);
  const double w = 1.0 - half_z;
  const double sin_r_1 = RN(z2
          * (0.00019841269829358447 + RN(z * -2.7557313538442266e-06)
          + RN(z2 * (2.5050734370397888e-08 + RN(z * -1.5895431762410801e-10))))),
      sin_r = r
          - (RN(z * r * (0.1666666666666663 + (RN(z * -0.00833333333332184) + sin_r_1)))
          + RN(r_excess * w));
  const double cos_r_1 = RN(z2
          * (2.48015872882953e-05 + RN(z * -2.7557314015067576e-07)
          + RN(z2 * (2.087567807349307e-09 + RN(z * -1.1357335951124145e-11))))),
      cos_r = w
          + (1.0 - w - half_z
          + (RN(z2 * (0.04166666666666659 + (RN(z * -0.0013888888888872186) + cos_r_1)))
          + RN(r * r_excess)));
  const double q = quadrant + shift4 - shift4 - quadrant;
  const double cos_k = 1.0 - fabs(q);
  const double minus_sin_k = q * (1.0 + cos_k);
  const double s_value = RN(sin_r * cos_k) - RN(cos_r * minus_sin_k);
  const double c_value = RN(cos_r * cos_k) + RN(sin_r * minus_sin_k);
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



#ifndef KSL_SINCOS_4
#define KSL_SINCOS_4
#if defined(__GNUC__) && defined(__SSE2__) && defined(__SSE2_MATH__)
#ifndef KSL_ABS_LANES
typedef double ksl_lanes __attribute__((vector_size(32)));
typedef uint64_t ksl_bits __attribute__((vector_size(32)));
#define KSL_ABS_LANES(x) ((ksl_lanes)((ksl_bits)(x) & 0x7fffffffffffffff))
#if defined(__clang__) && KSL_HAS_FMA && !defined(KSL_CONTRACT_OFF)
static inline __attribute__((unused)) ksl_lanes ksl_rounded_lanes(ksl_lanes x) {
  __asm__("" : "+x"(x));
  return x;
}
#define KSL_ROUNDED_LANES(product) ksl_rounded_lanes(product)
#else
#define KSL_ROUNDED_LANES(product) KSL_RN(product)
#endif
#endif

/* ksl_sincos of 4 angles, with the same bits. */
static KSL_INLINED void ksl_sincos_4(const double x0, const double x1, const double x2,
    const double x3, double s[4], double c[4]) {
  const ksl_lanes x = {x0, x1, x2, x3};
  const ksl_lanes quadrant_value = KSL_ROUNDED_LANES(x * 0.6366197723675814) + 6755399441055744.0
          - 6755399441055744.0;
  const ksl_lanes high = x - KSL_ROUNDED_LANES(quadrant_value * 1.5707963267341256)
          - KSL_ROUNDED_LANES(quadrant_value * 6.077094383272197e-11);
  const ksl_lanes low = KSL_ROUNDED_LANES(quadrant_value * 6.12323399409214e-17);
  const ksl_lanes r_value = high - low;
  const ksl_lanes r_excess_value = r_value - high + low
          + KSL_ROUNDED_LANES(quadrant_value * 1.6446256936324258e-26);
  ksl_lanes quadrant = quadrant_value, r = r_value, r_excess = r_excess_value;
  if (fabs(x0) > 6588396.0 || fabs(x1) > 6588396.0 ||
      fabs(x2) > 6588396.0 || fabs(x3) > 6588396.0) {
    for (int i = 0; i < 4; ++i) {
      if (fabs(x[i]) > 6588396.0) {
        double r_i, r_excess_i;
        quadrant[i] = ksl_sincos_far(x[i], &r_i, &r_excess_i);
        r[i] = r_i;
        r_excess[i] = r_excess_i;
      }
    }
  }
  const ksl_lanes z = r * r;
  const ksl_lanes z2 = z * z;
  const ksl_lanes half_z = KSL_ROUNDED_LANES(z * 0.5);
  const ksl_lanes w = 1.0 - half_z;
  const ksl_lanes sin_r_1 = KSL_ROUNDED_LANES(z2
          * (0.00019841269829358447 + KSL_ROUNDED_LANES(z * -2.7557313538442266e-06)
          + KSL_ROUNDED_LANES(z2
          * (2.5050734370397888e-08 + KSL_ROUNDED_LANES(z * -1.5895431762410801e-10))))),
      sin_r = r
          - (KSL_ROUNDED_LANES(z * r
          * (0.1666666666666663 + (KSL_ROUNDED_LANES(z * -0.00833333333332184) + sin_r_1)))
          + KSL_ROUNDED_LANES(r_excess * w));
  const ksl_lanes cos_r_1 = KSL_ROUNDED_LANES(z2
          * (2.48015872882953e-05 + KSL_ROUNDED_LANES(z * -2.7557314015067576e-07)
          + KSL_ROUNDED_LANES(z2
          * (2.087567807349307e-09 + KSL_ROUNDED_LANES(z * -1.1357335951124145e-11))))),
      cos_r = w
          + (1.0 - w - half_z
          + (KSL_ROUNDED_LANES(z2
          * (0.04166666666666659 + (KSL_ROUNDED_LANES(z * -0.0013888888888872186) + cos_r_1)))
          + KSL_ROUNDED_LANES(r * r_excess)));
  const ksl_lanes q = quadrant + 2.7021597764222976e+16 - 2.7021597764222976e+16 - quadrant;
  const ksl_lanes cos_k = 1.0 - KSL_ABS_LANES(q);
  const ksl_lanes minus_sin_k = q * (1.0 + cos_k);
  const ksl_lanes s_value = KSL_ROUNDED_LANES(sin_r * cos_k)
          - KSL_ROUNDED_LANES(cos_r * minus_sin_k);
  const ksl_lanes c_value = KSL_ROUNDED_LANES(cos_r * cos_k)
          + KSL_ROUNDED_LANES(sin_r * minus_sin_k);
  memcpy(s, &s_value, sizeof s_value);
  memcpy(c, &c_value, sizeof c_value);
}
#else
static KSL_INLINE void ksl_sincos_4(const double x0, const double x1, const double x2,
    const double x3, double s[4], double c[4]) {
  s[0] = ksl_sincos(x0, c);
  s[1] = ksl_sincos(x1, c + 1);
  s[2] = ksl_sincos(x2, c + 2);
  s[3] = ksl_sincos(x3, c + 3);
}
#endif
#endif

#ifndef KSL_SINCOS_2
#define KSL_SINCOS_2
static KSL_INLINED void ksl_sincos_2(const double x0, const double x1, double s[4], double c[4]) {
#ifdef KSL_ABS_LANES
  ksl_sincos_4(x0, x1, x1, x1, s, c);
#else
  s[0] = ksl_sincos(x0, c);
  s[1] = ksl_sincos(x1, c + 1);
#endif
}
#endif

#ifndef KSL_SINCOS_3
#define KSL_SINCOS_3
static KSL_INLINED void ksl_sincos_3(const double x0, const double x1, const double x2,
    double s[4], double c[4]) {
#ifdef KSL_ABS_LANES
  ksl_sincos_4(x0, x1, x2, x2, s, c);
#else
  s[0] = ksl_sincos(x0, c);
  s[1] = ksl_sincos(x1, c + 1);
  s[2] = ksl_sincos(x2, c + 2);
#endif
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
  const int small = size < 0.625;
  const double z = size * size;
  const double above = size * z
          * (RN((RN(z * -0.00019908890916339926) + -0.020496786093244908) * z) +
          -0.33333333333333326);
  const double below = RN((RN((RN(z * 0.00020643828172711687) + 0.023288648134874086) * z)
          + 0.4614903582797203) * z) + 1.0;
  const double twice_1 = size + size, twice = 40.0 < twice_1 ? 40.0 : twice_1;
  const double shifted = RN(twice * 1.4426950408889634) + 6755399441055744.0;
  const double k = shifted - 6755399441055744.0;
  const double high = twice - RN(k * 0.6931471805598903);
  const double rest = RN(k * 5.497923018708371e-14);
  const double r = high - rest;
  const double low_1 = r * r,
      low_2 = RN(low_1 * (RN(r * 0.0013888888926860458) + 0.008333333333500498))
          + (RN(r * 0.04166666666660382) + 0.16666666666666433),
      low_3 = RN(low_1 * (RN(r * 2.762522584904681e-07) + 2.7557641500508844e-06))
          + (RN(r * 2.4801508592805324e-05) + 0.00019841269465342197), low_4 = low_1 * low_1,
      low = RN(r * r
          * (RN(r * (RN(low_4 * low_4 * 2.4978234152604323e-08) + (RN(low_4 * low_3) + low_2)))
          + 0.5)) - rest;
  const double power = ksl_power(shifted);
  const double s_1 = power + 1.0, s = high + low;
  const double rest_of_e = RN(s * power);
  const double total = s_1 + rest_of_e;
  const double low_of_total = s_1 - total + rest_of_e;
  const double quotient = (small ? above : -2.0) / (small ? below : total);
  const double correction = small ? 0.0 : RN(quotient * low_of_total * (quotient * 0.5));
  const double start = small ? size : 1.0;
  const double sum_1 = start + quotient, sum = sum_1 + (start - sum_1 + quotient + correction);
  const double y_value = copysign(sum, x);
  return y_value;
}
#endif


#undef RN
#endif


#define RN(product) KSL_RNF(product)
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
  const int steep = width < height;
  const float a = steep ? width : height, a_1 = steep ? height : width;
  const int infinite = 3.4028235e+38f < a_1;
  const float scale = infinite ? 0.0f
          : (a_1 < 2.6843546e+08f ? 4.8357033e+24f : (1.2980742e+33f < a_1 ? 9.536743e-07f : 1.0f));
  const float scaled_a = 3.4028235e+38f < a ? 1.0f : RN(a * scale);
  const float scaled_b_1 = infinite ? 1.0f : RN(a_1 * scale),
      scaled_b = scaled_b_1 == 0.0f ? 1.0f : scaled_b_1;
  const int above = scaled_b < scaled_a + scaled_a;
  const float side = copysignf(1.0f, x);
  const float sign = steep ? -side : side;
  const float quarters = (steep ? 2.0f : 2.0f - (side + side)) + (above ? sign : 0.0f);
  const float base = RN(quarters * 0.78539824f);
  const float total = scaled_a + scaled_b;
  const float n = RN(sign * (above ? scaled_a - scaled_b : scaled_a));
  const float rest_of_d = above ? scaled_b - total + scaled_a : 0.0f;
  const float d = above ? total : scaled_b;
  const float inverse = 1.0f / d;
  const float q_high_1 = RN(n * inverse), q_high_2 = RN(q_high_1 * 4097.0f),
      q_high = q_high_2 - (q_high_2 - q_high_1);
  const float d_high_1 = RN(d * 4097.0f), d_high = d_high_1 - (d_high_1 - d);
  const float d_low = d - d_high;
  const float but_high = n - RN(q_high * d_high);
  const float but_low = but_high - RN(q_high * d_low);
  const float c = RN((but_low - RN(q_high * rest_of_d)) * inverse);
  const float q = q_high + c;
  const float z = q * q;
  const float tail_1 = z * z,
      tail_2 = RN(tail_1 * (RN(z * -0.08009076f) + 0.10948411f))
          + (RN(z * -0.14273107f) + 0.19999555f),
      tail = RN(q * z * (RN(z * (RN(tail_1 * tail_1 * 0.039042152f) + tail_2)) + -0.33333328f)) + c
          + RN(quarters * -8.146034e-08f);
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
  const float within_1 = 89.0f < x ? 89.0f : x, within = within_1 < -104.0f ? -104.0f : within_1;
  const float shifted = RN(within * 1.442695f) + 1.2582912e+07f;
  const float k = shifted - 1.2582912e+07f;
  const float high = within - RN(k * 0.69314575f);
  const float rest = RN(k * 1.4286068e-06f);
  const float r = high - rest;
  const float low_1 = RN(r
          * (RN(r * r * (RN(r * 0.0013863435f) + 0.008367437f))
          + (RN(r * 0.04166724f) + 0.16666535f))) + 0.5f, low = RN(r * r * low_1) - rest;
  const int small = within < -80.0f;
  const float start = high + 1.0f;
  const float e_r = start + (1.0f - start + high + low);
  const float scaled = e_r * ksl_powerf(shifted + (small ? 64.0f : -1.0f));
  const float y_value = RN(scaled * (small ? 5.421011e-20f : 2.0f));
  return y_value;
}
#endif
#ifndef KSL_SINCOSF
#define KSL_SINCOSF
/* Its reduction of angles up to 1607.0f. */
static KSL_INLINED float ksl_sincos_nearf(const float x, float *r, float *r_excess) {
  const float shift = 1.2582912e+07f;
  const float quadrant_value = RN(x * 0.63661975f) + shift - shift;
  const float high = x - RN(quadrant_value * 1.5706787f) - RN(quadrant_value * 0.000117599964f);
  const float low = RN(quadrant_value * 1.589251e-08f);
  const float r_value = high - low;
  const float r_excess_value = r_value - high + low + RN(quadrant_value * 7.443548e-13f);
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
  const float shift8 = 1.006633e+08f, shift4 = 5.033165e+07f, shift = 1.2582912e+07f;
  const float scaled = RN(x * 1.2621775e-29f);
  const float x_high_1 = RN(scaled * 4097.0f), x_high = x_high_1 - (x_high_1 - scaled);
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
  const float t0 = RN(x_low * chunk0) + RN(x_high * chunk1);
  const float t1 = RN(x_low * chunk1) + RN(x_high * chunk2);
  const float t2 = RN(x_low * chunk2) + RN(x_high * chunk3);
  const float t3 = RN(x_low * chunk3) + RN(x_high * chunk4);
  const float t4 = RN(x_low * chunk4) + RN(x_high * chunk5);
  const float t5 = RN(x_low * chunk5) + RN(x_high * chunk6);
  const float t6 = RN(x_low * chunk6) + RN(x_high * chunk7);
  const float t7 = RN(x_low * chunk7) + RN(x_high * chunk8);
  const float rest0 = t0 - (t0 + shift8 - shift8);
  const float rest4 = rest0 - (rest0 + shift4 - shift4);
  const float k1 = t1 + shift - shift;
  const float sum2_1 = rest4 + (t1 - k1), sum2 = sum2_1 + t2;
  const float sum2_error_1 = sum2 - sum2_1,
      sum2_error = sum2_1 - (sum2 - sum2_error_1) + (t2 - sum2_error_1);
  const float k2 = sum2 + shift - shift;
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
  const float f_part_high_1 = RN(f * 4097.0f), f_part_high = f_part_high_1 - (f_part_high_1 - f);
  const float f_part_low = f - f_part_high;
  const float product = RN(f * 1.5707964f);
  const float product_excess_1 = product - RN(f_part_high * 1.5708008f)
          - RN(f_part_high * -4.4107437e-06f) - RN(f_part_low * 1.5708008f),
      product_excess = product_excess_1 - RN(f_part_low * -4.4107437e-06f);
  const float rest = product_excess - (RN(f * -4.371139e-08f) + RN(f_low * 1.5707964f));
  const float r_value = product - rest;
  const float r_excess_value = r_value - product + rest;
  const float quadrant_value = k1 + k2;
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
  const float shift4 = 5.033165e+07f;
  const float z = r * r;
  const float z2 = z * z;
  const float half_z = RN(z * 0.5f);
  const float w = 1.0f - half_z;
  const float sin_r = r
          - (RN(z * r * (0.16666654f + (RN(z * -0.008332106f) + RN(z2 * 0.00019507883f))))
          + RN(r_excess * w));
  const float cos_r_1 = 1.0f - w - half_z
          + (RN(z2 * (0.041666646f + (RN(z * -0.0013887308f) + RN(z2 * 2.44321e-05f))))
          + RN(r * r_excess)), cos_r = w + cos_r_1;
  const float q = quadrant + shift4 - shift4 - quadrant;
  const float cos_k = 1.0f - fabsf(q);
  const float minus_sin_k = q * (1.0f + cos_k);
  const float s_value = RN(sin_r * cos_k) - RN(cos_r * minus_sin_k);
  const float c_value = RN(cos_r * cos_k) + RN(sin_r * minus_sin_k);
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



#ifndef KSL_SINCOS_4F
#define KSL_SINCOS_4F
#if defined(__GNUC__) && defined(__SSE2__) && defined(__SSE2_MATH__)
#ifndef KSL_ABS_LANESF
typedef float ksl_lanesf __attribute__((vector_size(16)));
typedef uint32_t ksl_bitsf __attribute__((vector_size(16)));
#define KSL_ABS_LANESF(x) ((ksl_lanesf)((ksl_bitsf)(x) & 0x7fffffff))
#if defined(__clang__) && KSL_HAS_FMA && !defined(KSL_CONTRACT_OFF)
static inline __attribute__((unused)) ksl_lanesf ksl_rounded_lanesf(ksl_lanesf x) {
  __asm__("" : "+x"(x));
  return x;
}
#define KSL_ROUNDED_LANESF(product) ksl_rounded_lanesf(product)
#else
#define KSL_ROUNDED_LANESF(product) KSL_RNF(product)
#endif
#endif

/* ksl_sincosf of 4 angles, with the same bits. */
static KSL_INLINED void ksl_sincos_4f(const float x0, const float x1, const float x2,
    const float x3, float s[4], float c[4]) {
  const ksl_lanesf x = {x0, x1, x2, x3};
  const ksl_lanesf quadrant_value = KSL_ROUNDED_LANESF(x * 0.63661975f) + 1.2582912e+07f
          - 1.2582912e+07f;
  const ksl_lanesf high = x - KSL_ROUNDED_LANESF(quadrant_value * 1.5706787f)
          - KSL_ROUNDED_LANESF(quadrant_value * 0.000117599964f);
  const ksl_lanesf low = KSL_ROUNDED_LANESF(quadrant_value * 1.589251e-08f);
  const ksl_lanesf r_value = high - low;
  const ksl_lanesf r_excess_value = r_value - high + low
          + KSL_ROUNDED_LANESF(quadrant_value * 7.443548e-13f);
  ksl_lanesf quadrant = quadrant_value, r = r_value, r_excess = r_excess_value;
  if (fabsf(x0) > 1607.0f || fabsf(x1) > 1607.0f ||
      fabsf(x2) > 1607.0f || fabsf(x3) > 1607.0f) {
    for (int i = 0; i < 4; ++i) {
      if (fabsf(x[i]) > 1607.0f) {
        float r_i, r_excess_i;
        quadrant[i] = ksl_sincos_farf(x[i], &r_i, &r_excess_i);
        r[i] = r_i;
        r_excess[i] = r_excess_i;
      }
    }
  }
  const ksl_lanesf z = r * r;
  const ksl_lanesf z2 = z * z;
  const ksl_lanesf half_z = KSL_ROUNDED_LANESF(z * 0.5f);
  const ksl_lanesf w = 1.0f - half_z;
  const ksl_lanesf sin_r = r
          - (KSL_ROUNDED_LANESF(z * r
          * (0.16666654f
          + (KSL_ROUNDED_LANESF(z * -0.008332106f) + KSL_ROUNDED_LANESF(z2 * 0.00019507883f))))
          + KSL_ROUNDED_LANESF(r_excess * w));
  const ksl_lanesf cos_r_1 = 1.0f - w - half_z
          + (KSL_ROUNDED_LANESF(z2
          * (0.041666646f
          + (KSL_ROUNDED_LANESF(z * -0.0013887308f) + KSL_ROUNDED_LANESF(z2 * 2.44321e-05f))))
          + KSL_ROUNDED_LANESF(r * r_excess)), cos_r = w + cos_r_1;
  const ksl_lanesf q = quadrant + 5.033165e+07f - 5.033165e+07f - quadrant;
  const ksl_lanesf cos_k = 1.0f - KSL_ABS_LANESF(q);
  const ksl_lanesf minus_sin_k = q * (1.0f + cos_k);
  const ksl_lanesf s_value = KSL_ROUNDED_LANESF(sin_r * cos_k)
          - KSL_ROUNDED_LANESF(cos_r * minus_sin_k);
  const ksl_lanesf c_value = KSL_ROUNDED_LANESF(cos_r * cos_k)
          + KSL_ROUNDED_LANESF(sin_r * minus_sin_k);
  memcpy(s, &s_value, sizeof s_value);
  memcpy(c, &c_value, sizeof c_value);
}
#else
static KSL_INLINE void ksl_sincos_4f(const float x0, const float x1, const float x2,
    const float x3, float s[4], float c[4]) {
  s[0] = ksl_sincosf(x0, c);
  s[1] = ksl_sincosf(x1, c + 1);
  s[2] = ksl_sincosf(x2, c + 2);
  s[3] = ksl_sincosf(x3, c + 3);
}
#endif
#endif

#ifndef KSL_SINCOS_2F
#define KSL_SINCOS_2F
static KSL_INLINED void ksl_sincos_2f(const float x0, const float x1, float s[4], float c[4]) {
#ifdef KSL_ABS_LANESF
  ksl_sincos_4f(x0, x1, x1, x1, s, c);
#else
  s[0] = ksl_sincosf(x0, c);
  s[1] = ksl_sincosf(x1, c + 1);
#endif
}
#endif

#ifndef KSL_SINCOS_3F
#define KSL_SINCOS_3F
static KSL_INLINED void ksl_sincos_3f(const float x0, const float x1, const float x2, float s[4],
    float c[4]) {
#ifdef KSL_ABS_LANESF
  ksl_sincos_4f(x0, x1, x2, x2, s, c);
#else
  s[0] = ksl_sincosf(x0, c);
  s[1] = ksl_sincosf(x1, c + 1);
  s[2] = ksl_sincosf(x2, c + 2);
#endif
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
  const int small = size < 0.625f;
  const float z = size * size;
  const float above = size * z * (RN((RN(z * 5.9599424e-05f) + -0.0017358434f) * z) + -0.33333334f);
  const float below = RN(z * 0.4052077f) + 1.0f;
  const float twice_1 = size + size, twice = 20.0f < twice_1 ? 20.0f : twice_1;
  const float shifted = RN(twice * 1.442695f) + 1.2582912e+07f;
  const float k = shifted - 1.2582912e+07f;
  const float high = twice - RN(k * 0.69314575f);
  const float rest = RN(k * 1.4286068e-06f);
  const float r = high - rest;
  const float low_1 = RN(r
          * (RN(r * r * (RN(r * 0.0013863435f) + 0.008367437f))
          + (RN(r * 0.04166724f) + 0.16666535f))) + 0.5f, low = RN(r * r * low_1) - rest;
  const float power = ksl_powerf(shifted);
  const float s_1 = power + 1.0f, s = high + low;
  const float rest_of_e = RN(s * power);
  const float total = s_1 + rest_of_e;
  const float low_of_total = s_1 - total + rest_of_e;
  const float quotient = (small ? above : -2.0f) / (small ? below : total);
  const float correction = small ? 0.0f : RN(quotient * low_of_total * (quotient * 0.5f));
  const float start = small ? size : 1.0f;
  const float sum_1 = start + quotient, sum = sum_1 + (start - sum_1 + quotient + correction);
  const float y_value = copysignf(sum, x);
  return y_value;
}
#endif


#undef RN


#endif

#if defined(COSCREW_RUNTIME_ERRORS) && !defined(COSCREW_RUNTIME_HAS_ERRORS)
#define COSCREW_RUNTIME_HAS_ERRORS
/* The rounding errors of products, and what the functions above err by: for scenes' accurate tiers,
   which define COSCREW_RUNTIME_ERRORS. */

#if DBL_MANT_DIG == 53
#ifndef KSL_PRODUCT_ERROR
#define KSL_PRODUCT_ERROR
#if !KSL_HAS_FMA
/* The upper half of x, rounded to 26 bits; what is left has 26 bits as well. */
static KSL_INLINE double ksl_upper_half(const double x) {
  uint64_t bits;
  double half;
  memcpy(&bits, &x, sizeof bits);
  bits = (bits + 0x4000000u) & 0xfffffffff8000000u;
  memcpy(&half, &bits, sizeof half);
  return half;
}

/* p - a b, p the rounded product, by halves, whose products are exact: fused into sums or not, they
   give the same bits.  *high is the product of the upper ones.  Source: Dekker. */
static KSL_INLINE double ksl_product_excess(
    const double a, const double b, const double p, double *high) {
  const double a_high = ksl_upper_half(a), a_low = a - a_high;
  const double b_high = ksl_upper_half(b), b_low = b - b_high;
  const double cross1 = a_high * b_low, cross2 = a_low * b_high, low = a_low * b_low;
  *high = a_high * b_high;
  const double c = p - *high, d = c - cross1, e = d - cross2;
  return e - low;
}

/* Whether halves and their products neither overflow nor underflow: 2^-967 <= |high| <= 2^996. */
static KSL_INLINE int ksl_halved(const double high) {
  const uint64_t least = (uint64_t)56 << 53, most = (uint64_t)2019 << 53;
  uint64_t bits, above;
  memcpy(&bits, &high, sizeof bits);
  above = (bits << 1) - least;
  return above <= most - least;
}

/* a b - c rounded once, where they do: the C standard requires it of fma. */
static KSL_COLD double ksl_fused(const double a, const double b, const double c) {
  const double zero = a * b; /* if a or b is */
  return a == 0.0 || b == 0.0 ? zero - c : fma(a, b, -c);
}
#endif

/* a b - p rounded once, p the rounded product: by fma where that is an instruction, else by halves.
   Both give the same bits. */
static KSL_INLINE double ksl_product_error(const double a, const double b, const double p) {
#if KSL_HAS_FMA
  return fma(a, b, -p);
#else
  double high;
  const double excess = ksl_product_excess(a, b, p, &high);
  return KSL_LIKELY(ksl_halved(high)) ? 0.0 - excess : ksl_fused(a, b, p);
#endif
}
#endif

#ifndef KSL_PRODUCT_REST
#define KSL_PRODUCT_REST
/* a b - h rounded once, where p is a b rounded and p - h is exact. */
static KSL_INLINE double ksl_product_rest(
    const double a, const double b, const double p, const double h) {
#if KSL_HAS_FMA
  (void)p;
  return fma(a, b, -h);
#else
  double high;
  const double excess = ksl_product_excess(a, b, p, &high); /* never -0: so -0 stays -0 */
  const double rest = p - h;
  return KSL_LIKELY(ksl_halved(high)) ? rest - excess : ksl_fused(a, b, h);
#endif
}
#endif


#define RN(product) KSL_RN(product)
#ifndef KSL_ATAN2_ERROR
#define KSL_ATAN2_ERROR
/* angle_error = atan2(y, x) - angle, angle as atan2 has it.
   (y c - x s) / (x c + y s), s and c the angle's sine and cosine as pairs; angle + angle_error
     is within 2^-100 of atan2(y, x), relative to it (proved), and 0.51 of the least subnormal
     number; 0 where the angle is 0.
   93 mul, 177 add, 21 product error, 1 div, 6 abs, 2 copysign, 7 less, 2 equal, 9 select. */
static KSL_INLINE double ksl_atan2_error(const double y, const double x, const double angle) {
  const double shift = 6755399441055744.0, shift4 = 2.7021597764222976e+16;
  const double quadrant = RN(angle * 0.6366197723675814) + shift - shift;
  const double high = angle - RN(quadrant * 1.5707963267341256)
          - RN(quadrant * 6.077094383272197e-11);
  const double a_1 = RN(quadrant * -6.12323399409214e-17), a = high + a_1;
  const double a_error_1 = a - high, a_error = high - (a - a_error_1) + (a_1 - a_error_1);
  const double fourth = a_error - RN(quadrant * 1.6446256917039331e-26);
  const double b = a + fourth;
  const double b_error = fourth - (b - a);
  const double fifth = b_error - RN(quadrant * 1.9284926340862225e-35);
  const double r = b + fifth;
  const double r_error = fifth - (r - b);
  const double r_low = r_error - RN(quadrant * 4.916232119866224e-45);
  const double argument = fabs(r) < 5.551115123125783e-17 ? 0.0 : r;
  const double z = RN(argument * argument);
  const double z_error = ksl_product_error(argument, argument, z);
  const double z_low = z_error + (RN(argument * r_low) + RN(r_low * argument));
  const double sin9_1 = RN(z
          * (RN(z * z * (RN(z * -9.183689863795546e-29) + 6.446950284384474e-26))
          + (RN(z * -3.868170170630684e-23) + 1.9572941063391263e-20))),
      sin9 = sin9_1 + -8.22063524662433e-18;
  const double sin8_z = RN(z * sin9);
  const double sin8 = 2.8114572543455206e-15 + sin8_z;
  const double sin8_error = sin8_z - (sin8 - 2.8114572543455206e-15);
  const double sin8_low = 1.6508842730861433e-31 + sin8_error;
  const double sin7_z = RN(z * sin8);
  const double sin7 = -7.647163731819816e-13 + sin7_z;
  const double sin7_error = sin7_z - (sin7 - -7.647163731819816e-13);
  const double sin7_low = RN(sin8 * z_low) + ksl_product_error(z, sin8, sin7_z) +
          -7.03872877733453e-30 + sin7_error + RN(z * sin8_low);
  const double sin6_z = RN(z * sin7);
  const double sin6 = 1.6059043836821613e-10 + sin6_z;
  const double sin6_error = sin6_z - (sin6 - 1.6059043836821613e-10);
  const double sin6_low = RN(sin7 * z_low) + ksl_product_error(z, sin7, sin6_z)
          + 1.2585294588752098e-26 + sin6_error + RN(z * sin7_low);
  const double sin5_z = RN(z * sin6);
  const double sin5 = -2.505210838544172e-08 + sin5_z;
  const double sin5_error = sin5_z - (sin5 - -2.505210838544172e-08);
  const double sin5_low = RN(sin6 * z_low) + ksl_product_error(z, sin6, sin5_z)
          + 1.448814070935912e-24 + sin5_error + RN(z * sin6_low);
  const double sin4_z = RN(z * sin5);
  const double sin4 = 2.7557319223985893e-06 + sin4_z;
  const double sin4_error = sin4_z - (sin4 - 2.7557319223985893e-06);
  const double sin4_low = RN(sin5 * z_low) + ksl_product_error(z, sin5, sin4_z) +
          -1.858393274046472e-22 + sin4_error + RN(z * sin5_low);
  const double sin3_z = RN(z * sin4);
  const double sin3 = -0.0001984126984126984 + sin3_z;
  const double sin3_error = sin3_z - (sin3 - -0.0001984126984126984);
  const double sin3_low = RN(sin4 * z_low) + ksl_product_error(z, sin4, sin3_z) +
          -1.7209558293420705e-22 + sin3_error + RN(z * sin4_low);
  const double sin2_z = RN(z * sin3);
  const double sin2 = 0.008333333333333333 + sin2_z;
  const double sin2_error = sin2_z - (sin2 - 0.008333333333333333);
  const double sin2_low = RN(sin3 * z_low) + ksl_product_error(z, sin3, sin2_z)
          + 1.1564823173178714e-19 + sin2_error + RN(z * sin3_low);
  const double sin1_z = RN(z * sin2);
  const double sin1 = -0.16666666666666666 + sin1_z;
  const double sin1_error = sin1_z - (sin1 - -0.16666666666666666);
  const double sin1_low = RN(sin2 * z_low) + ksl_product_error(z, sin2, sin1_z) +
          -9.25185853854297e-18 + sin1_error + RN(z * sin2_low);
  const double sin_sum = RN(z * sin1);
  const double sin_sum_error = ksl_product_error(z, sin1, sin_sum);
  const double sin_sum_low = sin_sum_error + (RN(z * sin1_low) + RN(z_low * sin1));
  const double sin_r_more = RN(r * sin_sum);
  const double sin_r_more_error = ksl_product_error(r, sin_sum, sin_r_more);
  const double sin_r_more_low = sin_r_more_error + (RN(r * sin_sum_low) + RN(r_low * sin_sum));
  const double sin_r = r + sin_r_more;
  const double sin_r_error = sin_r_more - (sin_r - r);
  const double sin_r_low = sin_r_error + (sin_r_more_low + r_low);
  const double cos10_1 = RN(z
          * (RN(z * z * (RN(z * 3.279889237069838e-30) + -2.4795962632247976e-27))
          + (RN(z * 1.6117375710961184e-24) + -8.896791392450574e-22))),
      cos10 = cos10_1 + 4.110317623312165e-19;
  const double cos9_z = RN(z * cos10);
  const double cos9 = -1.5619206968586225e-16 + cos9_z;
  const double cos9_error = cos9_z - (cos9 - -1.5619206968586225e-16);
  const double cos9_low = -1.1910679660273754e-32 + cos9_error;
  const double cos8_z = RN(z * cos9);
  const double cos8 = 4.779477332387385e-14 + cos8_z;
  const double cos8_error = cos8_z - (cos8 - 4.779477332387385e-14);
  const double cos8_low = RN(cos9 * z_low) + ksl_product_error(z, cos9, cos8_z)
          + 4.399205485834081e-31 + cos8_error + RN(z * cos9_low);
  const double cos7_z = RN(z * cos8);
  const double cos7 = -1.1470745597729725e-11 + cos7_z;
  const double cos7_error = cos7_z - (cos7 - -1.1470745597729725e-11);
  const double cos7_low = RN(cos8 * z_low) + ksl_product_error(z, cos8, cos7_z) +
          -2.0655512752830745e-28 + cos7_error + RN(z * cos8_low);
  const double cos6_z = RN(z * cos7);
  const double cos6 = 2.08767569878681e-09 + cos6_z;
  const double cos6_error = cos6_z - (cos6 - 2.08767569878681e-09);
  const double cos6_low = RN(cos7 * z_low) + ksl_product_error(z, cos7, cos6_z) +
          -1.20734505911326e-25 + cos6_error + RN(z * cos7_low);
  const double cos5_z = RN(z * cos6);
  const double cos5 = -2.755731922398589e-07 + cos5_z;
  const double cos5_error = cos5_z - (cos5 - -2.755731922398589e-07);
  const double cos5_low = RN(cos6 * z_low) + ksl_product_error(z, cos6, cos5_z) +
          -2.3767714622250297e-23 + cos5_error + RN(z * cos6_low);
  const double cos4_z = RN(z * cos5);
  const double cos4 = 2.48015873015873e-05 + cos4_z;
  const double cos4_error = cos4_z - (cos4 - 2.48015873015873e-05);
  const double cos4_low = RN(cos5 * z_low) + ksl_product_error(z, cos5, cos4_z)
          + 2.1511947866775882e-23 + cos4_error + RN(z * cos5_low);
  const double cos3_z = RN(z * cos4);
  const double cos3 = -0.001388888888888889 + cos3_z;
  const double cos3_error = cos3_z - (cos3 - -0.001388888888888889);
  const double cos3_low = RN(cos4 * z_low) + ksl_product_error(z, cos4, cos3_z)
          + 5.300543954373577e-20 + cos3_error + RN(z * cos4_low);
  const double cos2_z = RN(z * cos3);
  const double cos2 = 0.041666666666666664 + cos2_z;
  const double cos2_error = cos2_z - (cos2 - 0.041666666666666664);
  const double cos2_low = RN(cos3 * z_low) + ksl_product_error(z, cos3, cos2_z)
          + 2.3129646346357427e-18 + cos2_error + RN(z * cos3_low);
  const double cos1_z = RN(z * cos2);
  const double cos1 = -0.5 + cos1_z;
  const double cos1_error = cos1_z - (cos1 - -0.5);
  const double cos1_low = RN(cos2 * z_low) + ksl_product_error(z, cos2, cos1_z) + cos1_error
          + RN(z * cos2_low);
  const double cos_sum = RN(z * cos1);
  const double cos_sum_error = ksl_product_error(z, cos1, cos_sum);
  const double cos_sum_low = cos_sum_error + (RN(z * cos1_low) + RN(z_low * cos1));
  const double cos_r = 1.0 + cos_sum;
  const double cos_r_error = cos_sum - (cos_r - 1.0);
  const double cos_r_low = cos_r_error + cos_sum_low;
  const double sine = sin_r + sin_r_low;
  const double sine_low = sin_r_low - (sine - sin_r);
  const double cosine = cos_r + cos_r_low;
  const double cosine_low = cos_r_low - (cosine - cos_r);
  const double q = quadrant + shift4 - shift4 - quadrant;
  const double cos_k = 1.0 - fabs(q);
  const double minus_sin_k = q * (1.0 + cos_k);
  const double sin_x = RN(sine * cos_k) - RN(cosine * minus_sin_k);
  const double sin_x_low = RN(sine_low * cos_k) - RN(cosine_low * minus_sin_k);
  const double cos_x = RN(cosine * cos_k) + RN(sine * minus_sin_k);
  const double cos_x_low = RN(cosine_low * cos_k) + RN(sine_low * minus_sin_k);
  const double size_1 = fabs(y), size_2 = fabs(x), size = size_1 < size_2 ? size_2 : size_1;
  const double scale_1 = size < 1.152921504606847e+18 ? 9.076030935533344e+279
          : (1.0463951242053392e+298 < size ? 9.094947017729282e-13 : 1.0),
      scale = 1.7976931348623157e+308 < size ? 0.0 : scale_1;
  const double scaled_y_1 = copysign(1.0, x),
      scaled_y = 1.7976931348623157e+308 < fabs(y) ? copysign(1.0, y) : RN(y * scale);
  const double scaled_x = size == 0.0 ? scaled_y_1
          : (1.7976931348623157e+308 < fabs(x) ? scaled_y_1 : RN(x * scale));
  const double upward = RN(scaled_y * cos_x);
  const double across = RN(scaled_x * sin_x);
  const double upward_rest = ksl_product_error(scaled_y, cos_x, upward);
  const double across_rest = ksl_product_error(scaled_x, sin_x, across);
  const double low = upward_rest - across_rest
          + (RN(scaled_y * cos_x_low) - RN(scaled_x * sin_x_low));
  const double turn = (upward - across + low) / (RN(scaled_x * cos_x) + RN(scaled_y * sin_x));
  const double angle_error_value = angle == 0.0 ? 0.0 : turn;
  return angle_error_value;
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

#ifndef KSL_EXP_ERROR
#define KSL_EXP_ERROR
/* y_error = exp x - y, y as exp has it.
   x = k ln 2 + r, r as a pair; a Taylor polynomial of degree 23 in pairs; y + y_error is within
     2^-101.8 of exp x, relative to it (proved), and 0.51 of the least subnormal number; 0 where
     y is 0 or infinite.
   62 mul, 127 add, 14 product error, 4 power of two, 1 abs, 4 less, 1 equal, 5 select. */
static KSL_INLINE double ksl_exp_error(const double x, const double y) {
  const double within_1 = 710.0 < x ? 710.0 : x, within = within_1 < -746.0 ? -746.0 : within_1;
  const double shifted = RN(within * 1.4426950408889634) + 6755399441055744.0;
  const double k = shifted - 6755399441055744.0;
  const double high = within - RN(k * 0.6931471805598903);
  const double second = RN(k * -5.49792301870721e-14);
  const double rest = RN(k * -1.1612227229362532e-26);
  const double r = high + second;
  const double r_error_1 = r - high, r_error = high - (r - r_error_1) + (second - r_error_1);
  const double r_low = r_error + rest;
  const double argument = fabs(r) < 5.551115123125783e-17 ? 0.0 : r;
  const double term14_1 = argument * argument,
      term14_2 = RN(term14_1 * (RN(argument * 8.22063524662433e-18) + 1.5619206968586225e-16)),
      term14_3 = RN(term14_1 * (RN(argument * 3.868170170630684e-23) + 8.896791392450574e-22)),
      term14_4 = RN(term14_1 * term14_1
          * (term14_3 + (RN(argument * 1.9572941063391263e-20) + 4.110317623312165e-19))),
      term14 = RN(argument
          * (term14_4
          + (term14_2 + (RN(argument * 2.8114572543455206e-15) + 4.779477332387385e-14))))
          + 7.647163731819816e-13;
  const double term13_z = RN(argument * term14);
  const double term13 = 1.1470745597729725e-11 + term13_z;
  const double term13_error = term13_z - (term13 - 1.1470745597729725e-11);
  const double term13_low = 2.0655512752830745e-28 + term13_error;
  const double term12_z = RN(argument * term13);
  const double term12 = 1.6059043836821613e-10 + term12_z;
  const double term12_error = term12_z - (term12 - 1.6059043836821613e-10);
  const double term12_low = RN(term13 * r_low) + ksl_product_error(argument, term13, term12_z)
          + 1.2585294588752098e-26 + term12_error + RN(argument * term13_low);
  const double term11_z = RN(argument * term12);
  const double term11 = 2.08767569878681e-09 + term11_z;
  const double term11_error = term11_z - (term11 - 2.08767569878681e-09);
  const double term11_low = RN(term12 * r_low) + ksl_product_error(argument, term12, term11_z) +
          -1.20734505911326e-25 + term11_error + RN(argument * term12_low);
  const double term10_z = RN(argument * term11);
  const double term10 = 2.505210838544172e-08 + term10_z;
  const double term10_error = term10_z - (term10 - 2.505210838544172e-08);
  const double term10_low = RN(term11 * r_low) + ksl_product_error(argument, term11, term10_z) +
          -1.448814070935912e-24 + term10_error + RN(argument * term11_low);
  const double term9_z = RN(argument * term10);
  const double term9 = 2.755731922398589e-07 + term9_z;
  const double term9_error = term9_z - (term9 - 2.755731922398589e-07);
  const double term9_low = RN(term10 * r_low) + ksl_product_error(argument, term10, term9_z)
          + 2.3767714622250297e-23 + term9_error + RN(argument * term10_low);
  const double term8_z = RN(argument * term9);
  const double term8 = 2.7557319223985893e-06 + term8_z;
  const double term8_error = term8_z - (term8 - 2.7557319223985893e-06);
  const double term8_low = RN(term9 * r_low) + ksl_product_error(argument, term9, term8_z) +
          -1.858393274046472e-22 + term8_error + RN(argument * term9_low);
  const double term7_z = RN(argument * term8);
  const double term7 = 2.48015873015873e-05 + term7_z;
  const double term7_error = term7_z - (term7 - 2.48015873015873e-05);
  const double term7_low = RN(term8 * r_low) + ksl_product_error(argument, term8, term7_z)
          + 2.1511947866775882e-23 + term7_error + RN(argument * term8_low);
  const double term6_z = RN(argument * term7);
  const double term6 = 0.0001984126984126984 + term6_z;
  const double term6_error = term6_z - (term6 - 0.0001984126984126984);
  const double term6_low = RN(term7 * r_low) + ksl_product_error(argument, term7, term6_z)
          + 1.7209558293420705e-22 + term6_error + RN(argument * term7_low);
  const double term5_z = RN(argument * term6);
  const double term5 = 0.001388888888888889 + term5_z;
  const double term5_error = term5_z - (term5 - 0.001388888888888889);
  const double term5_low = RN(term6 * r_low) + ksl_product_error(argument, term6, term5_z) +
          -5.300543954373577e-20 + term5_error + RN(argument * term6_low);
  const double term4_z = RN(argument * term5);
  const double term4 = 0.008333333333333333 + term4_z;
  const double term4_error = term4_z - (term4 - 0.008333333333333333);
  const double term4_low = RN(term5 * r_low) + ksl_product_error(argument, term5, term4_z)
          + 1.1564823173178714e-19 + term4_error + RN(argument * term5_low);
  const double term3_z = RN(argument * term4);
  const double term3 = 0.041666666666666664 + term3_z;
  const double term3_error = term3_z - (term3 - 0.041666666666666664);
  const double term3_low = RN(term4 * r_low) + ksl_product_error(argument, term4, term3_z)
          + 2.3129646346357427e-18 + term3_error + RN(argument * term4_low);
  const double term2_z = RN(argument * term3);
  const double term2 = 0.16666666666666666 + term2_z;
  const double term2_error = term2_z - (term2 - 0.16666666666666666);
  const double term2_low = RN(term3 * r_low) + ksl_product_error(argument, term3, term2_z)
          + 9.25185853854297e-18 + term2_error + RN(argument * term3_low);
  const double term1_z = RN(argument * term2);
  const double term1 = 0.5 + term1_z;
  const double term1_error = term1_z - (term1 - 0.5);
  const double term1_low = RN(term2 * r_low) + ksl_product_error(argument, term2, term1_z)
          + term1_error + RN(argument * term2_low);
  const double term_sum = RN(argument * term1);
  const double term_sum_error = ksl_product_error(argument, term1, term_sum);
  const double term_sum_low = term_sum_error + (RN(argument * term1_low) + RN(r_low * term1));
  const double grown_more = RN(r * term_sum);
  const double grown_more_error = ksl_product_error(r, term_sum, grown_more);
  const double grown_more_low = grown_more_error + (RN(r * term_sum_low) + RN(r_low * term_sum));
  const double grown = r + grown_more;
  const double grown_error = grown_more - (grown - r);
  const double grown_low = grown_error + (grown_more_low + r_low);
  const double e_r = 1.0 + grown;
  const double e_r_error = grown - (e_r - 1.0);
  const double e_r_low = e_r_error + grown_low;
  const double first_shifted = RN(k * 0.5) + 6755399441055744.0;
  const double k_first = first_shifted - 6755399441055744.0;
  const double k_second = k - k_first;
  const double down0 = ksl_power(6755399441055744.0 - k_first);
  const double down1 = ksl_power(6755399441055744.0 - k_second);
  const double up0 = ksl_power(6755399441055744.0 + k_first);
  const double up1 = ksl_power(6755399441055744.0 + k_second);
  const double y_scaled = RN(y * down0 * down1);
  const double error = e_r - y_scaled + e_r_low;
  const double scaled = RN(error * up0 * up1);
  const double y_error_value = y == 0.0 ? 0.0 : (1.7976931348623157e+308 < y ? 0.0 : scaled);
  return y_error_value;
}
#endif
#ifndef KSL_SINCOS_ERROR
#define KSL_SINCOS_ERROR
/* Its reduction of angles up to 6588396.0. */
static KSL_INLINE double ksl_sincos_error_near(const double x, double *r, double *r_low) {
  const double shift = 6755399441055744.0;
  const double quadrant_value = RN(x * 0.6366197723675814) + shift - shift;
  const double high = x - RN(quadrant_value * 1.5707963267341256)
          - RN(quadrant_value * 6.077094383272197e-11);
  const double a_1 = RN(quadrant_value * -6.12323399409214e-17), a = high + a_1;
  const double a_error_1 = a - high, a_error = high - (a - a_error_1) + (a_1 - a_error_1);
  const double fourth = a_error - RN(quadrant_value * 1.6446256917039331e-26);
  const double b = a + fourth;
  const double b_error = fourth - (b - a);
  const double fifth = b_error - RN(quadrant_value * 1.9284926340862225e-35);
  const double r_value = b + fifth;
  const double r_error = fifth - (r_value - b);
  const double r_low_value = r_error - RN(quadrant_value * 4.916232119866224e-45);
  *r = r_value;
  *r_low = r_low_value;
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
static KSL_COLD double ksl_sincos_error_far(const double x, double *r, double *r_low) {
  const double shift8 = 5.404319552844595e+16, shift4 = 2.7021597764222976e+16,
      shift = 6755399441055744.0;
  const double scaled = RN(x * 6.441148769597133e-232);
  const double x_high_1 = RN(scaled * 134217729.0), x_high = x_high_1 - (x_high_1 - scaled);
  const double x_low = scaled - x_high;
  const double chunk0 = ksl_two_over_pi(x, 0);
  const double chunk1 = ksl_two_over_pi(x, 1);
  const double chunk2 = ksl_two_over_pi(x, 2);
  const double chunk3 = ksl_two_over_pi(x, 3);
  const double chunk4 = ksl_two_over_pi(x, 4);
  const double chunk5 = ksl_two_over_pi(x, 5);
  const double chunk6 = ksl_two_over_pi(x, 6);
  const double chunk7 = ksl_two_over_pi(x, 7);
  const double chunk8 = ksl_two_over_pi(x, 8);
  const double chunk9 = ksl_two_over_pi(x, 9);
  const double t0 = RN(x_low * chunk0) + RN(x_high * chunk1);
  const double t1 = RN(x_low * chunk1) + RN(x_high * chunk2);
  const double t2 = RN(x_low * chunk2) + RN(x_high * chunk3);
  const double t3 = RN(x_low * chunk3) + RN(x_high * chunk4);
  const double t4 = RN(x_low * chunk4) + RN(x_high * chunk5);
  const double t5 = RN(x_low * chunk5) + RN(x_high * chunk6);
  const double t6 = RN(x_low * chunk6) + RN(x_high * chunk7);
  const double t7 = RN(x_low * chunk7) + RN(x_high * chunk8);
  const double t8 = RN(x_low * chunk8) + RN(x_high * chunk9);
  const double rest0 = t0 - (t0 + shift8 - shift8);
  const double rest4 = rest0 - (rest0 + shift4 - shift4);
  const double k1 = t1 + shift - shift;
  const double sum2_1 = rest4 + (t1 - k1), sum2 = sum2_1 + t2;
  const double sum2_error_1 = sum2 - sum2_1,
      sum2_error = sum2_1 - (sum2 - sum2_error_1) + (t2 - sum2_error_1);
  const double k2 = sum2 + shift - shift;
  const double sum2_rest = sum2 - k2;
  const double f_a6 = t7 + t8;
  const double f_a6_error_1 = f_a6 - t7,
      f_a6_error = t7 - (f_a6 - f_a6_error_1) + (t8 - f_a6_error_1);
  const double f_a5 = t6 + f_a6;
  const double f_a5_error_1 = f_a5 - t6,
      f_a5_error = t6 - (f_a5 - f_a5_error_1) + (f_a6 - f_a5_error_1);
  const double f_a4 = t5 + f_a5;
  const double f_a4_error_1 = f_a4 - t5,
      f_a4_error = t5 - (f_a4 - f_a4_error_1) + (f_a5 - f_a4_error_1);
  const double f_a3 = t4 + f_a4;
  const double f_a3_error_1 = f_a3 - t4,
      f_a3_error = t4 - (f_a3 - f_a3_error_1) + (f_a4 - f_a3_error_1);
  const double f_a2 = sum2_error + f_a3;
  const double f_a2_error_1 = f_a2 - sum2_error,
      f_a2_error = sum2_error - (f_a2 - f_a2_error_1) + (f_a3 - f_a2_error_1);
  const double f_a1 = t3 + f_a2;
  const double f_a1_error_1 = f_a1 - t3,
      f_a1_error = t3 - (f_a1 - f_a1_error_1) + (f_a2 - f_a1_error_1);
  const double f_a0 = sum2_rest + f_a1;
  const double f_a0_error_1 = f_a0 - sum2_rest,
      f_a0_error = sum2_rest - (f_a0 - f_a0_error_1) + (f_a1 - f_a0_error_1);
  const double f_b6 = f_a5_error + f_a6_error;
  const double f_b6_error_1 = f_b6 - f_a5_error,
      f_b6_error = f_a5_error - (f_b6 - f_b6_error_1) + (f_a6_error - f_b6_error_1);
  const double f_b5 = f_a4_error + f_b6;
  const double f_b5_error_1 = f_b5 - f_a4_error,
      f_b5_error = f_a4_error - (f_b5 - f_b5_error_1) + (f_b6 - f_b5_error_1);
  const double f_b4 = f_a3_error + f_b5;
  const double f_b4_error_1 = f_b4 - f_a3_error,
      f_b4_error = f_a3_error - (f_b4 - f_b4_error_1) + (f_b5 - f_b4_error_1);
  const double f_b3 = f_a2_error + f_b4;
  const double f_b3_error_1 = f_b3 - f_a2_error,
      f_b3_error = f_a2_error - (f_b3 - f_b3_error_1) + (f_b4 - f_b3_error_1);
  const double f_b2 = f_a1_error + f_b3;
  const double f_b2_error_1 = f_b2 - f_a1_error,
      f_b2_error = f_a1_error - (f_b2 - f_b2_error_1) + (f_b3 - f_b2_error_1);
  const double f_b1 = f_a0_error + f_b2;
  const double f_b1_error_1 = f_b1 - f_a0_error,
      f_b1_error = f_a0_error - (f_b1 - f_b1_error_1) + (f_b2 - f_b1_error_1);
  const double f_b0 = f_a0 + f_b1;
  const double f_b0_error_1 = f_b0 - f_a0,
      f_b0_error = f_a0 - (f_b0 - f_b0_error_1) + (f_b1 - f_b0_error_1);
  const double f_low = f_b0_error
          + (f_b1_error + (f_b2_error + (f_b3_error + (f_b4_error + (f_b5_error + f_b6_error)))));
  const double angle = RN(f_b0 * 1.5707963267948966);
  const double angle_error = ksl_product_error(f_b0, 1.5707963267948966, angle);
  const double angle_low = angle_error
          + (RN(f_b0 * 6.123233995736766e-17) + RN(f_low * 1.5707963267948966));
  const double r_value = angle + angle_low;
  const double r_low_value = angle_low - (r_value - angle);
  const double quadrant_value = k1 + k2;
  *r = r_value;
  *r_low = r_low_value;
  return quadrant_value;
}

/* (s_error, c_error) = (sin x - s, cos x - c), (s, c) as sincos has them.
   x = k pi/2 + r, r as a pair; Taylor's polynomial of degree 27 in pairs for sin r, whose error
     gives that of cos r, as their squares are 1 together; s + s_error and c + c_error are within
     2^-100.2 of sin x and cos x, relative to these (proved), for every finite x.
   55 mul, 94 add, 11 product error, 1 div, 2 abs, 1 less, 1 select; beyond the limit, more. */
static KSL_INLINE double ksl_sincos_error(const double x, const double s, const double c,
    double *c_error) {
  double r, r_low,
      quadrant = ksl_sincos_error_near(x, &r, &r_low);
  if (fabs(x) > 6588396.0) {
    double far_r, far_r_low;
    quadrant = ksl_sincos_error_far(x, &far_r, &far_r_low);
    r = far_r;
    r_low = far_r_low;
  }
  const double shift4 = 2.7021597764222976e+16;
  const double q = quadrant + shift4 - shift4 - quadrant;
  const double cos_k = 1.0 - fabs(q);
  const double minus_sin_k = q * (1.0 + cos_k);
  const double sin_r = RN(s * cos_k) + RN(c * minus_sin_k);
  const double cos_r = RN(c * cos_k) - RN(s * minus_sin_k);
  const double argument = fabs(r) < 5.551115123125783e-17 ? 0.0 : r;
  const double z = RN(argument * argument);
  const double z_error = ksl_product_error(argument, argument, z);
  const double cube = RN(argument * z);
  const double cube_error = ksl_product_error(argument, z, cube);
  const double cube_low = cube_error + RN(argument * z_error);
  const double sin8_1 = z * z,
      sin8_2 = RN(sin8_1 * (RN(z * 6.446950284384474e-26) + -3.868170170630684e-23))
          + (RN(z * 1.9572941063391263e-20) + -8.22063524662433e-18),
      sin8 = RN(z * (RN(sin8_1 * sin8_1 * -9.183689863795546e-29) + sin8_2))
          + 2.8114572543455206e-15;
  const double sin7_z = RN(z * sin8);
  const double sin7 = -7.647163731819816e-13 + sin7_z;
  const double sin7_error = sin7_z - (sin7 - -7.647163731819816e-13);
  const double sin7_low = -7.03872877733453e-30 + sin7_error;
  const double sin6_z = RN(z * sin7);
  const double sin6 = 1.6059043836821613e-10 + sin6_z;
  const double sin6_error = sin6_z - (sin6 - 1.6059043836821613e-10);
  const double sin6_low = RN(sin7 * z_error) + ksl_product_error(z, sin7, sin6_z)
          + 1.2585294588752098e-26 + sin6_error + RN(z * sin7_low);
  const double sin5_z = RN(z * sin6);
  const double sin5 = -2.505210838544172e-08 + sin5_z;
  const double sin5_error = sin5_z - (sin5 - -2.505210838544172e-08);
  const double sin5_low = RN(sin6 * z_error) + ksl_product_error(z, sin6, sin5_z)
          + 1.448814070935912e-24 + sin5_error + RN(z * sin6_low);
  const double sin4_z = RN(z * sin5);
  const double sin4 = 2.7557319223985893e-06 + sin4_z;
  const double sin4_error = sin4_z - (sin4 - 2.7557319223985893e-06);
  const double sin4_low = RN(sin5 * z_error) + ksl_product_error(z, sin5, sin4_z) +
          -1.858393274046472e-22 + sin4_error + RN(z * sin5_low);
  const double sin3_z = RN(z * sin4);
  const double sin3 = -0.0001984126984126984 + sin3_z;
  const double sin3_error = sin3_z - (sin3 - -0.0001984126984126984);
  const double sin3_low = RN(sin4 * z_error) + ksl_product_error(z, sin4, sin3_z) +
          -1.7209558293420705e-22 + sin3_error + RN(z * sin4_low);
  const double sin2_z = RN(z * sin3);
  const double sin2 = 0.008333333333333333 + sin2_z;
  const double sin2_error = sin2_z - (sin2 - 0.008333333333333333);
  const double sin2_low = RN(sin3 * z_error) + ksl_product_error(z, sin3, sin2_z)
          + 1.1564823173178714e-19 + sin2_error + RN(z * sin3_low);
  const double sin1_z = RN(z * sin2);
  const double sin1 = -0.16666666666666666 + sin1_z;
  const double sin1_error = sin1_z - (sin1 - -0.16666666666666666);
  const double sin1_low = RN(sin2 * z_error) + ksl_product_error(z, sin2, sin1_z) +
          -9.25185853854297e-18 + sin1_error + RN(z * sin2_low);
  const double more = RN(cube * sin1);
  const double more_error = ksl_product_error(cube, sin1, more);
  const double more_low = more_error + RN(cube_low * sin1);
  const double last = RN(cube * sin1_low);
  const double difference = r - sin_r;
  const double known_sin_r = argument - difference;
  const double sin_r_error = difference + more + (more_low + RN(r_low * cos_r)) + last;
  const double h = 1.0 - cos_r;
  const double inverse = 1.0 / cos_r;
  const double square = RN(known_sin_r * known_sin_r);
  const double square_error = ksl_product_error(known_sin_r, known_sin_r, square);
  const double h_square = RN(h * h);
  const double h_square_error = ksl_product_error(h, h, h_square);
  const double excess = h + h - square - h_square - (square_error + h_square_error);
  const double tangent = known_sin_r * inverse;
  const double cos_r_error = RN(excess * (inverse * 0.5)) - RN(tangent * sin_r_error);
  const double s_error_value = RN(sin_r_error * cos_k) - RN(cos_r_error * minus_sin_k);
  const double c_error_value = RN(cos_r_error * cos_k) + RN(sin_r_error * minus_sin_k);
  *c_error = c_error_value;
  return s_error_value;
}
#endif

#ifndef KSL_SIN_ERROR
#define KSL_SIN_ERROR
/* sin x - s, as ksl_sincos_error. */
static KSL_INLINE double ksl_sin_error(const double x, const double s) {
  double c, c_error;
  (void)ksl_sincos(x, &c);
  return ksl_sincos_error(x, s, c, &c_error);
}
#endif

#ifndef KSL_COS_ERROR
#define KSL_COS_ERROR
/* cos x - c, as ksl_sincos_error. */
static KSL_INLINE double ksl_cos_error(const double x, const double c) {
  double unused, c_error;
  (void)ksl_sincos_error(x, ksl_sincos(x, &unused), c, &c_error);
  return c_error;
}
#endif



#ifndef KSL_SINCOS_ERROR_4
#define KSL_SINCOS_ERROR_4
#if defined(__GNUC__) && defined(__SSE2__) && defined(__SSE2_MATH__)
#ifndef KSL_ABS_LANES
typedef double ksl_lanes __attribute__((vector_size(32)));
typedef uint64_t ksl_bits __attribute__((vector_size(32)));
#define KSL_ABS_LANES(x) ((ksl_lanes)((ksl_bits)(x) & 0x7fffffffffffffff))
#if defined(__clang__) && KSL_HAS_FMA && !defined(KSL_CONTRACT_OFF)
static inline __attribute__((unused)) ksl_lanes ksl_rounded_lanes(ksl_lanes x) {
  __asm__("" : "+x"(x));
  return x;
}
#define KSL_ROUNDED_LANES(product) ksl_rounded_lanes(product)
#else
#define KSL_ROUNDED_LANES(product) KSL_RN(product)
#endif
#endif

/* x where the test fails, else 0. */
#define KSL_UNLESS_LANES(test, x) ((ksl_lanes)(~(ksl_bits)(test) & (ksl_bits)(x)))
/* a b - p, p the rounded product, where neither the halves nor their products overflow or
   underflow. */
#ifdef __FMA__
#include <immintrin.h>
#define KSL_PRODUCT_ERROR_LANES(a, b, p) \
    ((ksl_lanes)_mm256_fmsub_pd((__m256d)(a), (__m256d)(b), (__m256d)(p)))
#else
#define KSL_HIGH_LANES(x) ((ksl_lanes)(((ksl_bits)(x) + 0x4000000) & 0xfffffffff8000000))
#define KSL_LOW_LANES(x) ((x) - KSL_HIGH_LANES(x))
#define KSL_PRODUCT_ERROR_LANES(a, b, p) (KSL_HIGH_LANES(a) * KSL_HIGH_LANES(b) - (p) \
    + KSL_HIGH_LANES(a) * KSL_LOW_LANES(b) + KSL_LOW_LANES(a) * KSL_HIGH_LANES(b) \
    + KSL_LOW_LANES(a) * KSL_LOW_LANES(b))
#endif

/* ksl_sincos_error of 4 angles, with the same bits. */
static KSL_INLINED void ksl_sincos_error_4(const double x0, const double x1, const double x2,
    const double x3, const double s[4], const double c[4], double s_error[4],
    double c_error[4]) {
  const ksl_lanes x = {x0, x1, x2, x3};
  const ksl_lanes quadrant_value = KSL_ROUNDED_LANES(x * 0.6366197723675814) + 6755399441055744.0
          - 6755399441055744.0;
  const ksl_lanes high = x - KSL_ROUNDED_LANES(quadrant_value * 1.5707963267341256)
          - KSL_ROUNDED_LANES(quadrant_value * 6.077094383272197e-11);
  const ksl_lanes a_1 = KSL_ROUNDED_LANES(quadrant_value * -6.12323399409214e-17), a = high + a_1;
  const ksl_lanes a_error_1 = a - high, a_error = high - (a - a_error_1) + (a_1 - a_error_1);
  const ksl_lanes fourth = a_error - KSL_ROUNDED_LANES(quadrant_value * 1.6446256917039331e-26);
  const ksl_lanes b = a + fourth;
  const ksl_lanes b_error = fourth - (b - a);
  const ksl_lanes fifth = b_error - KSL_ROUNDED_LANES(quadrant_value * 1.9284926340862225e-35);
  const ksl_lanes r_value = b + fifth;
  const ksl_lanes r_error = fifth - (r_value - b);
  const ksl_lanes r_low_value = r_error - KSL_ROUNDED_LANES(quadrant_value * 4.916232119866224e-45);
  ksl_lanes quadrant = quadrant_value, r = r_value, r_low = r_low_value;
  ksl_lanes s_lanes;
  memcpy(&s_lanes, s, sizeof s_lanes);
  ksl_lanes c_lanes;
  memcpy(&c_lanes, c, sizeof c_lanes);
  if (fabs(x0) > 6588396.0 || fabs(x1) > 6588396.0 ||
      fabs(x2) > 6588396.0 || fabs(x3) > 6588396.0) {
    for (int i = 0; i < 4; ++i) {
      if (fabs(x[i]) > 6588396.0) {
        double r_i, r_low_i;
        quadrant[i] = ksl_sincos_error_far(x[i], &r_i, &r_low_i);
        r[i] = r_i;
        r_low[i] = r_low_i;
      }
    }
  }
  const ksl_lanes q = quadrant + 2.7021597764222976e+16 - 2.7021597764222976e+16 - quadrant;
  const ksl_lanes cos_k = 1.0 - KSL_ABS_LANES(q);
  const ksl_lanes minus_sin_k = q * (1.0 + cos_k);
  const ksl_lanes sin_r = KSL_ROUNDED_LANES(s_lanes * cos_k)
          + KSL_ROUNDED_LANES(c_lanes * minus_sin_k);
  const ksl_lanes cos_r = KSL_ROUNDED_LANES(c_lanes * cos_k)
          - KSL_ROUNDED_LANES(s_lanes * minus_sin_k);
  const ksl_lanes argument = KSL_UNLESS_LANES(KSL_ABS_LANES(r) < 5.551115123125783e-17, r);
  const ksl_lanes z = KSL_ROUNDED_LANES(argument * argument);
  const ksl_lanes z_error = KSL_PRODUCT_ERROR_LANES(argument, argument, z);
  const ksl_lanes cube = KSL_ROUNDED_LANES(argument * z);
  const ksl_lanes cube_error = KSL_PRODUCT_ERROR_LANES(argument, z, cube);
  const ksl_lanes cube_low = cube_error + KSL_ROUNDED_LANES(argument * z_error);
  const ksl_lanes sin8_1 = z * z,
      sin8_2 = KSL_ROUNDED_LANES(sin8_1
          * (KSL_ROUNDED_LANES(z * 6.446950284384474e-26) + -3.868170170630684e-23))
          + (KSL_ROUNDED_LANES(z * 1.9572941063391263e-20) + -8.22063524662433e-18),
      sin8 = KSL_ROUNDED_LANES(z
          * (KSL_ROUNDED_LANES(sin8_1 * sin8_1 * -9.183689863795546e-29) + sin8_2))
          + 2.8114572543455206e-15;
  const ksl_lanes sin7_z = KSL_ROUNDED_LANES(z * sin8);
  const ksl_lanes sin7 = -7.647163731819816e-13 + sin7_z;
  const ksl_lanes sin7_error = sin7_z - (sin7 - -7.647163731819816e-13);
  const ksl_lanes sin7_low = -7.03872877733453e-30 + sin7_error;
  const ksl_lanes sin6_z = KSL_ROUNDED_LANES(z * sin7);
  const ksl_lanes sin6 = 1.6059043836821613e-10 + sin6_z;
  const ksl_lanes sin6_error = sin6_z - (sin6 - 1.6059043836821613e-10);
  const ksl_lanes sin6_low = KSL_ROUNDED_LANES(sin7 * z_error)
          + KSL_PRODUCT_ERROR_LANES(z, sin7, sin6_z) + 1.2585294588752098e-26 + sin6_error
          + KSL_ROUNDED_LANES(z * sin7_low);
  const ksl_lanes sin5_z = KSL_ROUNDED_LANES(z * sin6);
  const ksl_lanes sin5 = -2.505210838544172e-08 + sin5_z;
  const ksl_lanes sin5_error = sin5_z - (sin5 - -2.505210838544172e-08);
  const ksl_lanes sin5_low = KSL_ROUNDED_LANES(sin6 * z_error)
          + KSL_PRODUCT_ERROR_LANES(z, sin6, sin5_z) + 1.448814070935912e-24 + sin5_error
          + KSL_ROUNDED_LANES(z * sin6_low);
  const ksl_lanes sin4_z = KSL_ROUNDED_LANES(z * sin5);
  const ksl_lanes sin4 = 2.7557319223985893e-06 + sin4_z;
  const ksl_lanes sin4_error = sin4_z - (sin4 - 2.7557319223985893e-06);
  const ksl_lanes sin4_low = KSL_ROUNDED_LANES(sin5 * z_error)
          + KSL_PRODUCT_ERROR_LANES(z, sin5, sin4_z) + -1.858393274046472e-22 + sin4_error
          + KSL_ROUNDED_LANES(z * sin5_low);
  const ksl_lanes sin3_z = KSL_ROUNDED_LANES(z * sin4);
  const ksl_lanes sin3 = -0.0001984126984126984 + sin3_z;
  const ksl_lanes sin3_error = sin3_z - (sin3 - -0.0001984126984126984);
  const ksl_lanes sin3_low = KSL_ROUNDED_LANES(sin4 * z_error)
          + KSL_PRODUCT_ERROR_LANES(z, sin4, sin3_z) + -1.7209558293420705e-22 + sin3_error
          + KSL_ROUNDED_LANES(z * sin4_low);
  const ksl_lanes sin2_z = KSL_ROUNDED_LANES(z * sin3);
  const ksl_lanes sin2 = 0.008333333333333333 + sin2_z;
  const ksl_lanes sin2_error = sin2_z - (sin2 - 0.008333333333333333);
  const ksl_lanes sin2_low = KSL_ROUNDED_LANES(sin3 * z_error)
          + KSL_PRODUCT_ERROR_LANES(z, sin3, sin2_z) + 1.1564823173178714e-19 + sin2_error
          + KSL_ROUNDED_LANES(z * sin3_low);
  const ksl_lanes sin1_z = KSL_ROUNDED_LANES(z * sin2);
  const ksl_lanes sin1 = -0.16666666666666666 + sin1_z;
  const ksl_lanes sin1_error = sin1_z - (sin1 - -0.16666666666666666);
  const ksl_lanes sin1_low = KSL_ROUNDED_LANES(sin2 * z_error)
          + KSL_PRODUCT_ERROR_LANES(z, sin2, sin1_z) + -9.25185853854297e-18 + sin1_error
          + KSL_ROUNDED_LANES(z * sin2_low);
  const ksl_lanes more = KSL_ROUNDED_LANES(cube * sin1);
  const ksl_lanes more_error = KSL_PRODUCT_ERROR_LANES(cube, sin1, more);
  const ksl_lanes more_low = more_error + KSL_ROUNDED_LANES(cube_low * sin1);
  const ksl_lanes last = KSL_ROUNDED_LANES(cube * sin1_low);
  const ksl_lanes difference = r - sin_r;
  const ksl_lanes known_sin_r = argument - difference;
  const ksl_lanes sin_r_error = difference + more + (more_low + KSL_ROUNDED_LANES(r_low * cos_r))
          + last;
  const ksl_lanes h = 1.0 - cos_r;
  const ksl_lanes inverse = 1.0 / cos_r;
  const ksl_lanes square = KSL_ROUNDED_LANES(known_sin_r * known_sin_r);
  const ksl_lanes square_error = KSL_PRODUCT_ERROR_LANES(known_sin_r, known_sin_r, square);
  const ksl_lanes h_square = KSL_ROUNDED_LANES(h * h);
  const ksl_lanes h_square_error = KSL_PRODUCT_ERROR_LANES(h, h, h_square);
  const ksl_lanes excess = h + h - square - h_square - (square_error + h_square_error);
  const ksl_lanes tangent = known_sin_r * inverse;
  const ksl_lanes cos_r_error = KSL_ROUNDED_LANES(excess * (inverse * 0.5))
          - KSL_ROUNDED_LANES(tangent * sin_r_error);
  const ksl_lanes s_error_value = KSL_ROUNDED_LANES(sin_r_error * cos_k)
          - KSL_ROUNDED_LANES(cos_r_error * minus_sin_k);
  const ksl_lanes c_error_value = KSL_ROUNDED_LANES(cos_r_error * cos_k)
          + KSL_ROUNDED_LANES(sin_r_error * minus_sin_k);
  memcpy(s_error, &s_error_value, sizeof s_error_value);
  memcpy(c_error, &c_error_value, sizeof c_error_value);
}
#else
static KSL_INLINE void ksl_sincos_error_4(const double x0, const double x1, const double x2,
    const double x3, const double s[4], const double c[4], double s_error[4],
    double c_error[4]) {
  s_error[0] = ksl_sincos_error(x0, s[0], c[0], c_error);
  s_error[1] = ksl_sincos_error(x1, s[1], c[1], c_error + 1);
  s_error[2] = ksl_sincos_error(x2, s[2], c[2], c_error + 2);
  s_error[3] = ksl_sincos_error(x3, s[3], c[3], c_error + 3);
}
#endif
#endif

#ifndef KSL_SINCOS_ERROR_2
#define KSL_SINCOS_ERROR_2
static KSL_INLINED void ksl_sincos_error_2(const double x0, const double x1, const double s[4],
    const double c[4], double s_error[4], double c_error[4]) {
#ifdef KSL_ABS_LANES
  ksl_sincos_error_4(x0, x1, x1, x1, s, c, s_error, c_error);
#else
  s_error[0] = ksl_sincos_error(x0, s[0], c[0], c_error);
  s_error[1] = ksl_sincos_error(x1, s[1], c[1], c_error + 1);
#endif
}
#endif

#ifndef KSL_SINCOS_ERROR_3
#define KSL_SINCOS_ERROR_3
static KSL_INLINED void ksl_sincos_error_3(const double x0, const double x1, const double x2,
    const double s[4], const double c[4], double s_error[4], double c_error[4]) {
#ifdef KSL_ABS_LANES
  ksl_sincos_error_4(x0, x1, x2, x2, s, c, s_error, c_error);
#else
  s_error[0] = ksl_sincos_error(x0, s[0], c[0], c_error);
  s_error[1] = ksl_sincos_error(x1, s[1], c[1], c_error + 1);
  s_error[2] = ksl_sincos_error(x2, s[2], c[2], c_error + 2);
#endif
}
#endif
#ifndef KSL_TANH_ERROR
#define KSL_TANH_ERROR
/* y_error = tanh x - y, y as tanh has it.
   m / d = (e^2|x| - 1) / (e^2|x| + 1), m and d as pairs; y + y_error is within 2^-100.1 of tanh
     x, relative to it (proved); 0 for |x| below 2^-54 and above 40.
   62 mul, 143 add, 15 product error, 1 div, 1 power of two, 3 abs, 1 copysign, 3 less, 6 select. */
static KSL_INLINE double ksl_tanh_error(const double x, const double y) {
  const double size = fabs(x);
  const int tiny = size < 5.551115123125783e-17;
  const int beyond = 40.0 < size;
  const double within = beyond ? 40.0 : (tiny ? 1.0 : size);
  const double result = tiny ? 1.0 : fabs(y);
  const double twice = within + within;
  const double shifted = RN(twice * 1.4426950408889634) + 6755399441055744.0;
  const double k = shifted - 6755399441055744.0;
  const double high = twice - RN(k * 0.6931471805598903);
  const double second = RN(k * -5.49792301870721e-14);
  const double rest = RN(k * -1.1612227229362532e-26);
  const double r = high + second;
  const double r_error_1 = r - high, r_error = high - (r - r_error_1) + (second - r_error_1);
  const double r_low = r_error + rest;
  const double power = ksl_power(shifted);
  const double whole = power + -1.0;
  const double whole_error = -1.0 - (whole - power);
  const double argument = fabs(r) < 5.551115123125783e-17 ? 0.0 : r;
  const double term14_1 = argument * argument,
      term14_2 = RN(term14_1 * (RN(argument * 8.22063524662433e-18) + 1.5619206968586225e-16)),
      term14_3 = RN(term14_1 * (RN(argument * 3.868170170630684e-23) + 8.896791392450574e-22)),
      term14_4 = RN(term14_1 * term14_1
          * (term14_3 + (RN(argument * 1.9572941063391263e-20) + 4.110317623312165e-19))),
      term14 = RN(argument
          * (term14_4
          + (term14_2 + (RN(argument * 2.8114572543455206e-15) + 4.779477332387385e-14))))
          + 7.647163731819816e-13;
  const double term13_z = RN(argument * term14);
  const double term13 = 1.1470745597729725e-11 + term13_z;
  const double term13_error = term13_z - (term13 - 1.1470745597729725e-11);
  const double term13_low = 2.0655512752830745e-28 + term13_error;
  const double term12_z = RN(argument * term13);
  const double term12 = 1.6059043836821613e-10 + term12_z;
  const double term12_error = term12_z - (term12 - 1.6059043836821613e-10);
  const double term12_low = RN(term13 * r_low) + ksl_product_error(argument, term13, term12_z)
          + 1.2585294588752098e-26 + term12_error + RN(argument * term13_low);
  const double term11_z = RN(argument * term12);
  const double term11 = 2.08767569878681e-09 + term11_z;
  const double term11_error = term11_z - (term11 - 2.08767569878681e-09);
  const double term11_low = RN(term12 * r_low) + ksl_product_error(argument, term12, term11_z) +
          -1.20734505911326e-25 + term11_error + RN(argument * term12_low);
  const double term10_z = RN(argument * term11);
  const double term10 = 2.505210838544172e-08 + term10_z;
  const double term10_error = term10_z - (term10 - 2.505210838544172e-08);
  const double term10_low = RN(term11 * r_low) + ksl_product_error(argument, term11, term10_z) +
          -1.448814070935912e-24 + term10_error + RN(argument * term11_low);
  const double term9_z = RN(argument * term10);
  const double term9 = 2.755731922398589e-07 + term9_z;
  const double term9_error = term9_z - (term9 - 2.755731922398589e-07);
  const double term9_low = RN(term10 * r_low) + ksl_product_error(argument, term10, term9_z)
          + 2.3767714622250297e-23 + term9_error + RN(argument * term10_low);
  const double term8_z = RN(argument * term9);
  const double term8 = 2.7557319223985893e-06 + term8_z;
  const double term8_error = term8_z - (term8 - 2.7557319223985893e-06);
  const double term8_low = RN(term9 * r_low) + ksl_product_error(argument, term9, term8_z) +
          -1.858393274046472e-22 + term8_error + RN(argument * term9_low);
  const double term7_z = RN(argument * term8);
  const double term7 = 2.48015873015873e-05 + term7_z;
  const double term7_error = term7_z - (term7 - 2.48015873015873e-05);
  const double term7_low = RN(term8 * r_low) + ksl_product_error(argument, term8, term7_z)
          + 2.1511947866775882e-23 + term7_error + RN(argument * term8_low);
  const double term6_z = RN(argument * term7);
  const double term6 = 0.0001984126984126984 + term6_z;
  const double term6_error = term6_z - (term6 - 0.0001984126984126984);
  const double term6_low = RN(term7 * r_low) + ksl_product_error(argument, term7, term6_z)
          + 1.7209558293420705e-22 + term6_error + RN(argument * term7_low);
  const double term5_z = RN(argument * term6);
  const double term5 = 0.001388888888888889 + term5_z;
  const double term5_error = term5_z - (term5 - 0.001388888888888889);
  const double term5_low = RN(term6 * r_low) + ksl_product_error(argument, term6, term5_z) +
          -5.300543954373577e-20 + term5_error + RN(argument * term6_low);
  const double term4_z = RN(argument * term5);
  const double term4 = 0.008333333333333333 + term4_z;
  const double term4_error = term4_z - (term4 - 0.008333333333333333);
  const double term4_low = RN(term5 * r_low) + ksl_product_error(argument, term5, term4_z)
          + 1.1564823173178714e-19 + term4_error + RN(argument * term5_low);
  const double term3_z = RN(argument * term4);
  const double term3 = 0.041666666666666664 + term3_z;
  const double term3_error = term3_z - (term3 - 0.041666666666666664);
  const double term3_low = RN(term4 * r_low) + ksl_product_error(argument, term4, term3_z)
          + 2.3129646346357427e-18 + term3_error + RN(argument * term4_low);
  const double term2_z = RN(argument * term3);
  const double term2 = 0.16666666666666666 + term2_z;
  const double term2_error = term2_z - (term2 - 0.16666666666666666);
  const double term2_low = RN(term3 * r_low) + ksl_product_error(argument, term3, term2_z)
          + 9.25185853854297e-18 + term2_error + RN(argument * term3_low);
  const double term1_z = RN(argument * term2);
  const double term1 = 0.5 + term1_z;
  const double term1_error = term1_z - (term1 - 0.5);
  const double term1_low = RN(term2 * r_low) + ksl_product_error(argument, term2, term1_z)
          + term1_error + RN(argument * term2_low);
  const double term_sum = RN(argument * term1);
  const double term_sum_error = ksl_product_error(argument, term1, term_sum);
  const double term_sum_low = term_sum_error + (RN(argument * term1_low) + RN(r_low * term1));
  const double grown_more = RN(r * term_sum);
  const double grown_more_error = ksl_product_error(r, term_sum, grown_more);
  const double grown_more_low = grown_more_error + (RN(r * term_sum_low) + RN(r_low * term_sum));
  const double grown = r + grown_more;
  const double grown_error = grown_more - (grown - r);
  const double grown_low = grown_error + (grown_more_low + r_low);
  const double more = RN(grown * power);
  const double more_low = RN(grown_low * power);
  const double m_sum = whole + more;
  const double m_sum_error_1 = m_sum - whole,
      m_sum_error = whole - (m_sum - m_sum_error_1) + (more - m_sum_error_1);
  const double m_sum_low = m_sum_error + (more_low + whole_error);
  const double m = m_sum + m_sum_low;
  const double m_low = m_sum_low - (m - m_sum);
  const double d_sum = 2.0 + m;
  const double d_sum_error_1 = d_sum - 2.0,
      d_sum_error = 2.0 - (d_sum - d_sum_error_1) + (m - d_sum_error_1);
  const double d_sum_low = d_sum_error + m_low;
  const double d = d_sum + d_sum_low;
  const double d_low = d_sum_low - (d - d_sum);
  const double product = RN(result * d);
  const double product_rest = ksl_product_error(result, d, product);
  const double error = (m - product - product_rest + (m_low - RN(result * d_low))) / d;
  const double known = tiny ? 0.0 : (beyond ? 0.0 : error);
  const double y_error_value = RN(known * copysign(1.0, x));
  return y_error_value;
}
#endif


#undef RN
#endif


#ifndef KSL_PRODUCT_ERRORF
#define KSL_PRODUCT_ERRORF
#if !KSL_HAS_FMAF
/* The upper half of x, rounded to 12 bits; what is left has 12 bits as well. */
static KSL_INLINE float ksl_upper_halff(const float x) {
  uint32_t bits;
  float half;
  memcpy(&bits, &x, sizeof bits);
  bits = (bits + 0x800u) & 0xfffff000u;
  memcpy(&half, &bits, sizeof half);
  return half;
}

/* p - a b, p the rounded product, by halves, whose products are exact: fused into sums or not, they
   give the same bits.  *high is the product of the upper ones.  Source: Dekker. */
static KSL_INLINE float ksl_product_excessf(
    const float a, const float b, const float p, float *high) {
  const float a_high = ksl_upper_halff(a), a_low = a - a_high;
  const float b_high = ksl_upper_halff(b), b_low = b - b_high;
  const float cross1 = a_high * b_low, cross2 = a_low * b_high, low = a_low * b_low;
  *high = a_high * b_high;
  const float c = p - *high, d = c - cross1, e = d - cross2;
  return e - low;
}

/* Whether halves and their products neither overflow nor underflow: 2^-100 <= |high| <= 2^100. */
static KSL_INLINE int ksl_halvedf(const float high) {
  const uint32_t least = (uint32_t)27 << 24, most = (uint32_t)227 << 24;
  uint32_t bits, above;
  memcpy(&bits, &high, sizeof bits);
  above = (bits << 1) - least;
  return above <= most - least;
}

/* a b - c rounded once, where they do: the C standard requires it of fmaf. */
static KSL_COLD float ksl_fusedf(const float a, const float b, const float c) {
  const float zero = a * b; /* if a or b is */
  return a == 0.0f || b == 0.0f ? zero - c : fmaf(a, b, -c);
}
#endif

/* a b - p in single precision, rounded once, p the rounded product: by fmaf where that is an
   instruction, else by halves.  Both give the same bits. */
static KSL_INLINE float ksl_product_errorf(const float a, const float b, const float p) {
#if KSL_HAS_FMAF
  return fmaf(a, b, -p);
#else
  float high;
  const float excess = ksl_product_excessf(a, b, p, &high);
  return KSL_LIKELY(ksl_halvedf(high)) ? 0.0f - excess : ksl_fusedf(a, b, p);
#endif
}
#endif

#ifndef KSL_PRODUCT_RESTF
#define KSL_PRODUCT_RESTF
/* a b - h in single precision, rounded once, where p is a b rounded and p - h is exact. */
static KSL_INLINE float ksl_product_restf(
    const float a, const float b, const float p, const float h) {
#if KSL_HAS_FMAF
  (void)p;
  return fmaf(a, b, -h);
#else
  float high;
  const float excess = ksl_product_excessf(a, b, p, &high); /* never -0: so -0 stays -0 */
  const float rest = p - h;
  return KSL_LIKELY(ksl_halvedf(high)) ? rest - excess : ksl_fusedf(a, b, h);
#endif
}
#endif


#define RN(product) KSL_RNF(product)
#ifndef KSL_ATAN2_ERRORF
#define KSL_ATAN2_ERRORF
/* angle_error = atan2(y, x) - angle, angle as atan2 has it.
   (y c - x s) / (x c + y s), s and c the angle's sine and cosine as pairs; angle + angle_error
     is within 2^-42.1 of atan2(y, x), relative to it (proved), and 0.51 of the least subnormal
     number; 0 where the angle is 0.
   66 mul, 124 add, 14 product error, 1 div, 6 abs, 2 copysign, 7 less, 2 equal, 9 select. */
static KSL_INLINE float ksl_atan2_errorf(const float y, const float x, const float angle) {
  const float shift = 1.2582912e+07f, shift4 = 5.033165e+07f;
  const float quadrant = RN(angle * 0.63661975f) + shift - shift;
  const float high = angle - RN(quadrant * 1.5706787f) - RN(quadrant * 0.000117599964f);
  const float a_1 = RN(quadrant * -1.589251e-08f), a = high + a_1;
  const float a_error_1 = a - high, a_error = high - (a - a_error_1) + (a_1 - a_error_1);
  const float fourth = a_error - RN(quadrant * 7.442935e-13f);
  const float b = a + fourth;
  const float b_error = fourth - (b - a);
  const float fifth = b_error - RN(quadrant * 6.123032e-17f);
  const float r = b + fifth;
  const float r_error = fifth - (r - b);
  const float r_low = r_error - RN(quadrant * 2.0222662e-21f);
  const float argument = fabsf(r) < 2.9802322e-08f ? 0.0f : r;
  const float z = RN(argument * argument);
  const float z_error = ksl_product_errorf(argument, argument, z);
  const float z_low = z_error + (RN(argument * r_low) + RN(r_low * argument));
  const float sin6 = RN(z * (RN(z * 2.8114574e-15f) + -7.6471636e-13f)) + 1.6059044e-10f;
  const float sin5_z = RN(z * sin6);
  const float sin5 = -2.5052108e-08f + sin5_z;
  const float sin5_error = sin5_z - (sin5 - -2.5052108e-08f);
  const float sin5_low = -4.417623e-16f + sin5_error;
  const float sin4_z = RN(z * sin5);
  const float sin4 = 2.7557319e-06f + sin4_z;
  const float sin4_error = sin4_z - (sin4 - 2.7557319e-06f);
  const float sin4_low = RN(sin5 * z_low) + ksl_product_errorf(z, sin5, sin4_z) + 3.7935712e-14f
          + sin4_error + RN(z * sin5_low);
  const float sin3_z = RN(z * sin4);
  const float sin3 = -0.0001984127f + sin3_z;
  const float sin3_error = sin3_z - (sin3 - -0.0001984127f);
  const float sin3_low = RN(sin4 * z_low) + ksl_product_errorf(z, sin4, sin3_z) + 2.7255969e-12f
          + sin3_error + RN(z * sin4_low);
  const float sin2_z = RN(z * sin3);
  const float sin2 = 0.008333334f + sin2_z;
  const float sin2_error = sin2_z - (sin2 - 0.008333334f);
  const float sin2_low = RN(sin3 * z_low) + ksl_product_errorf(z, sin3, sin2_z) + -4.346172e-10f
          + sin2_error + RN(z * sin3_low);
  const float sin1_z = RN(z * sin2);
  const float sin1 = -0.16666667f + sin1_z;
  const float sin1_error = sin1_z - (sin1 - -0.16666667f);
  const float sin1_low = RN(sin2 * z_low) + ksl_product_errorf(z, sin2, sin1_z) + 4.967054e-09f
          + sin1_error + RN(z * sin2_low);
  const float sin_sum = RN(z * sin1);
  const float sin_sum_error = ksl_product_errorf(z, sin1, sin_sum);
  const float sin_sum_low = sin_sum_error + (RN(z * sin1_low) + RN(z_low * sin1));
  const float sin_r_more = RN(r * sin_sum);
  const float sin_r_more_error = ksl_product_errorf(r, sin_sum, sin_r_more);
  const float sin_r_more_low = sin_r_more_error + (RN(r * sin_sum_low) + RN(r_low * sin_sum));
  const float sin_r = r + sin_r_more;
  const float sin_r_error = sin_r_more - (sin_r - r);
  const float sin_r_low = sin_r_error + (sin_r_more_low + r_low);
  const float cos6 = RN(z * (RN(z * 4.7794773e-14f) + -1.1470745e-11f)) + 2.0876756e-09f;
  const float cos5_z = RN(z * cos6);
  const float cos5 = -2.755732e-07f + cos5_z;
  const float cos5_error = cos5_z - (cos5 - -2.755732e-07f);
  const float cos5_low = 7.575112e-15f + cos5_error;
  const float cos4_z = RN(z * cos5);
  const float cos4 = 2.4801588e-05f + cos4_z;
  const float cos4_error = cos4_z - (cos4 - 2.4801588e-05f);
  const float cos4_low = RN(cos5 * z_low) + ksl_product_errorf(z, cos5, cos4_z) + -3.406996e-13f
          + cos4_error + RN(z * cos5_low);
  const float cos3_z = RN(z * cos4);
  const float cos3 = -0.0013888889f + cos3_z;
  const float cos3_error = cos3_z - (cos3 - -0.0013888889f);
  const float cos3_low = RN(cos4 * z_low) + ksl_product_errorf(z, cos4, cos3_z) + 3.3631094e-11f
          + cos3_error + RN(z * cos4_low);
  const float cos2_z = RN(z * cos3);
  const float cos2 = 0.041666668f + cos2_z;
  const float cos2_error = cos2_z - (cos2 - 0.041666668f);
  const float cos2_low = RN(cos3 * z_low) + ksl_product_errorf(z, cos3, cos2_z) + -1.2417635e-09f
          + cos2_error + RN(z * cos3_low);
  const float cos1_z = RN(z * cos2);
  const float cos1 = -0.5f + cos1_z;
  const float cos1_error = cos1_z - (cos1 - -0.5f);
  const float cos1_low = RN(cos2 * z_low) + ksl_product_errorf(z, cos2, cos1_z) + cos1_error
          + RN(z * cos2_low);
  const float cos_sum = RN(z * cos1);
  const float cos_sum_error = ksl_product_errorf(z, cos1, cos_sum);
  const float cos_sum_low = cos_sum_error + (RN(z * cos1_low) + RN(z_low * cos1));
  const float cos_r = 1.0f + cos_sum;
  const float cos_r_error = cos_sum - (cos_r - 1.0f);
  const float cos_r_low = cos_r_error + cos_sum_low;
  const float sine = sin_r + sin_r_low;
  const float sine_low = sin_r_low - (sine - sin_r);
  const float cosine = cos_r + cos_r_low;
  const float cosine_low = cos_r_low - (cosine - cos_r);
  const float q = quadrant + shift4 - shift4 - quadrant;
  const float cos_k = 1.0f - fabsf(q);
  const float minus_sin_k = q * (1.0f + cos_k);
  const float sin_x = RN(sine * cos_k) - RN(cosine * minus_sin_k);
  const float sin_x_low = RN(sine_low * cos_k) - RN(cosine_low * minus_sin_k);
  const float cos_x = RN(cosine * cos_k) + RN(sine * minus_sin_k);
  const float cos_x_low = RN(cosine_low * cos_k) + RN(sine_low * minus_sin_k);
  const float size_1 = fabsf(y), size_2 = fabsf(x), size = size_1 < size_2 ? size_2 : size_1;
  const float scale_1 = size < 2.6843546e+08f ? 4.8357033e+24f
          : (1.2980742e+33f < size ? 9.536743e-07f : 1.0f),
      scale = 3.4028235e+38f < size ? 0.0f : scale_1;
  const float scaled_y_1 = copysignf(1.0f, x),
      scaled_y = 3.4028235e+38f < fabsf(y) ? copysignf(1.0f, y) : RN(y * scale);
  const float scaled_x = size == 0.0f ? scaled_y_1
          : (3.4028235e+38f < fabsf(x) ? scaled_y_1 : RN(x * scale));
  const float upward = RN(scaled_y * cos_x);
  const float across = RN(scaled_x * sin_x);
  const float upward_rest = ksl_product_errorf(scaled_y, cos_x, upward);
  const float across_rest = ksl_product_errorf(scaled_x, sin_x, across);
  const float low = upward_rest - across_rest
          + (RN(scaled_y * cos_x_low) - RN(scaled_x * sin_x_low));
  const float turn = (upward - across + low) / (RN(scaled_x * cos_x) + RN(scaled_y * sin_x));
  const float angle_error_value = angle == 0.0f ? 0.0f : turn;
  return angle_error_value;
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

#ifndef KSL_EXP_ERRORF
#define KSL_EXP_ERRORF
/* y_error = exp x - y, y as exp has it.
   x = k ln 2 + r, r as a pair; a Taylor polynomial of degree 13 in pairs; y + y_error is within
     2^-43.7 of exp x, relative to it (proved), and 0.51 of the least subnormal number; 0 where y
     is 0 or infinite.
   39 mul, 81 add, 8 product error, 4 power of two, 1 abs, 4 less, 1 equal, 5 select. */
static KSL_INLINE float ksl_exp_errorf(const float x, const float y) {
  const float within_1 = 89.0f < x ? 89.0f : x, within = within_1 < -104.0f ? -104.0f : within_1;
  const float shifted = RN(within * 1.442695f) + 1.2582912e+07f;
  const float k = shifted - 1.2582912e+07f;
  const float high = within - RN(k * 0.69314575f);
  const float second = RN(k * -1.4285906e-06f);
  const float rest = RN(k * -1.619851e-11f);
  const float r = high + second;
  const float r_error_1 = r - high, r_error = high - (r - r_error_1) + (second - r_error_1);
  const float r_low = r_error + rest;
  const float argument = fabsf(r) < 2.9802322e-08f ? 0.0f : r;
  const float term8_1 = RN(argument * argument * (RN(argument * 1.6059044e-10f) + 2.0876756e-09f)),
      term8 = RN(argument * (term8_1 + (RN(argument * 2.5052108e-08f) + 2.755732e-07f)))
          + 2.7557319e-06f;
  const float term7_z = RN(argument * term8);
  const float term7 = 2.4801588e-05f + term7_z;
  const float term7_error = term7_z - (term7 - 2.4801588e-05f);
  const float term7_low = -3.406996e-13f + term7_error;
  const float term6_z = RN(argument * term7);
  const float term6 = 0.0001984127f + term6_z;
  const float term6_error = term6_z - (term6 - 0.0001984127f);
  const float term6_low = RN(term7 * r_low) + ksl_product_errorf(argument, term7, term6_z) +
          -2.7255969e-12f + term6_error + RN(argument * term7_low);
  const float term5_z = RN(argument * term6);
  const float term5 = 0.0013888889f + term5_z;
  const float term5_error = term5_z - (term5 - 0.0013888889f);
  const float term5_low = RN(term6 * r_low) + ksl_product_errorf(argument, term6, term5_z) +
          -3.3631094e-11f + term5_error + RN(argument * term6_low);
  const float term4_z = RN(argument * term5);
  const float term4 = 0.008333334f + term4_z;
  const float term4_error = term4_z - (term4 - 0.008333334f);
  const float term4_low = RN(term5 * r_low) + ksl_product_errorf(argument, term5, term4_z) +
          -4.346172e-10f + term4_error + RN(argument * term5_low);
  const float term3_z = RN(argument * term4);
  const float term3 = 0.041666668f + term3_z;
  const float term3_error = term3_z - (term3 - 0.041666668f);
  const float term3_low = RN(term4 * r_low) + ksl_product_errorf(argument, term4, term3_z) +
          -1.2417635e-09f + term3_error + RN(argument * term4_low);
  const float term2_z = RN(argument * term3);
  const float term2 = 0.16666667f + term2_z;
  const float term2_error = term2_z - (term2 - 0.16666667f);
  const float term2_low = RN(term3 * r_low) + ksl_product_errorf(argument, term3, term2_z) +
          -4.967054e-09f + term2_error + RN(argument * term3_low);
  const float term1_z = RN(argument * term2);
  const float term1 = 0.5f + term1_z;
  const float term1_error = term1_z - (term1 - 0.5f);
  const float term1_low = RN(term2 * r_low) + ksl_product_errorf(argument, term2, term1_z)
          + term1_error + RN(argument * term2_low);
  const float term_sum = RN(argument * term1);
  const float term_sum_error = ksl_product_errorf(argument, term1, term_sum);
  const float term_sum_low = term_sum_error + (RN(argument * term1_low) + RN(r_low * term1));
  const float grown_more = RN(r * term_sum);
  const float grown_more_error = ksl_product_errorf(r, term_sum, grown_more);
  const float grown_more_low = grown_more_error + (RN(r * term_sum_low) + RN(r_low * term_sum));
  const float grown = r + grown_more;
  const float grown_error = grown_more - (grown - r);
  const float grown_low = grown_error + (grown_more_low + r_low);
  const float e_r = 1.0f + grown;
  const float e_r_error = grown - (e_r - 1.0f);
  const float e_r_low = e_r_error + grown_low;
  const float first_shifted = RN(k * 0.5f) + 1.2582912e+07f;
  const float k_first = first_shifted - 1.2582912e+07f;
  const float k_second = k - k_first;
  const float down0 = ksl_powerf(1.2582912e+07f - k_first);
  const float down1 = ksl_powerf(1.2582912e+07f - k_second);
  const float up0 = ksl_powerf(1.2582912e+07f + k_first);
  const float up1 = ksl_powerf(1.2582912e+07f + k_second);
  const float y_scaled = RN(y * down0 * down1);
  const float error = e_r - y_scaled + e_r_low;
  const float scaled = RN(error * up0 * up1);
  const float y_error_value = y == 0.0f ? 0.0f : (3.4028235e+38f < y ? 0.0f : scaled);
  return y_error_value;
}
#endif
#ifndef KSL_SINCOS_ERRORF
#define KSL_SINCOS_ERRORF
/* Its reduction of angles up to 1607.0f. */
static KSL_INLINE float ksl_sincos_error_nearf(const float x, float *r, float *r_low) {
  const float shift = 1.2582912e+07f;
  const float quadrant_value = RN(x * 0.63661975f) + shift - shift;
  const float high = x - RN(quadrant_value * 1.5706787f) - RN(quadrant_value * 0.000117599964f);
  const float a_1 = RN(quadrant_value * -1.589251e-08f), a = high + a_1;
  const float a_error_1 = a - high, a_error = high - (a - a_error_1) + (a_1 - a_error_1);
  const float fourth = a_error - RN(quadrant_value * 7.442935e-13f);
  const float b = a + fourth;
  const float b_error = fourth - (b - a);
  const float fifth = b_error - RN(quadrant_value * 6.123032e-17f);
  const float r_value = b + fifth;
  const float r_error = fifth - (r_value - b);
  const float r_low_value = r_error - RN(quadrant_value * 2.0222662e-21f);
  *r = r_value;
  *r_low = r_low_value;
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
static KSL_COLD float ksl_sincos_error_farf(const float x, float *r, float *r_low) {
  const float shift8 = 1.006633e+08f, shift4 = 5.033165e+07f, shift = 1.2582912e+07f;
  const float scaled = RN(x * 1.2621775e-29f);
  const float x_high_1 = RN(scaled * 4097.0f), x_high = x_high_1 - (x_high_1 - scaled);
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
  const float chunk9 = ksl_two_over_pif(x, 9);
  const float t0 = RN(x_low * chunk0) + RN(x_high * chunk1);
  const float t1 = RN(x_low * chunk1) + RN(x_high * chunk2);
  const float t2 = RN(x_low * chunk2) + RN(x_high * chunk3);
  const float t3 = RN(x_low * chunk3) + RN(x_high * chunk4);
  const float t4 = RN(x_low * chunk4) + RN(x_high * chunk5);
  const float t5 = RN(x_low * chunk5) + RN(x_high * chunk6);
  const float t6 = RN(x_low * chunk6) + RN(x_high * chunk7);
  const float t7 = RN(x_low * chunk7) + RN(x_high * chunk8);
  const float t8 = RN(x_low * chunk8) + RN(x_high * chunk9);
  const float rest0 = t0 - (t0 + shift8 - shift8);
  const float rest4 = rest0 - (rest0 + shift4 - shift4);
  const float k1 = t1 + shift - shift;
  const float sum2_1 = rest4 + (t1 - k1), sum2 = sum2_1 + t2;
  const float sum2_error_1 = sum2 - sum2_1,
      sum2_error = sum2_1 - (sum2 - sum2_error_1) + (t2 - sum2_error_1);
  const float k2 = sum2 + shift - shift;
  const float sum2_rest = sum2 - k2;
  const float f_a6 = t7 + t8;
  const float f_a6_error_1 = f_a6 - t7,
      f_a6_error = t7 - (f_a6 - f_a6_error_1) + (t8 - f_a6_error_1);
  const float f_a5 = t6 + f_a6;
  const float f_a5_error_1 = f_a5 - t6,
      f_a5_error = t6 - (f_a5 - f_a5_error_1) + (f_a6 - f_a5_error_1);
  const float f_a4 = t5 + f_a5;
  const float f_a4_error_1 = f_a4 - t5,
      f_a4_error = t5 - (f_a4 - f_a4_error_1) + (f_a5 - f_a4_error_1);
  const float f_a3 = t4 + f_a4;
  const float f_a3_error_1 = f_a3 - t4,
      f_a3_error = t4 - (f_a3 - f_a3_error_1) + (f_a4 - f_a3_error_1);
  const float f_a2 = sum2_error + f_a3;
  const float f_a2_error_1 = f_a2 - sum2_error,
      f_a2_error = sum2_error - (f_a2 - f_a2_error_1) + (f_a3 - f_a2_error_1);
  const float f_a1 = t3 + f_a2;
  const float f_a1_error_1 = f_a1 - t3,
      f_a1_error = t3 - (f_a1 - f_a1_error_1) + (f_a2 - f_a1_error_1);
  const float f_a0 = sum2_rest + f_a1;
  const float f_a0_error_1 = f_a0 - sum2_rest,
      f_a0_error = sum2_rest - (f_a0 - f_a0_error_1) + (f_a1 - f_a0_error_1);
  const float f_b6 = f_a5_error + f_a6_error;
  const float f_b6_error_1 = f_b6 - f_a5_error,
      f_b6_error = f_a5_error - (f_b6 - f_b6_error_1) + (f_a6_error - f_b6_error_1);
  const float f_b5 = f_a4_error + f_b6;
  const float f_b5_error_1 = f_b5 - f_a4_error,
      f_b5_error = f_a4_error - (f_b5 - f_b5_error_1) + (f_b6 - f_b5_error_1);
  const float f_b4 = f_a3_error + f_b5;
  const float f_b4_error_1 = f_b4 - f_a3_error,
      f_b4_error = f_a3_error - (f_b4 - f_b4_error_1) + (f_b5 - f_b4_error_1);
  const float f_b3 = f_a2_error + f_b4;
  const float f_b3_error_1 = f_b3 - f_a2_error,
      f_b3_error = f_a2_error - (f_b3 - f_b3_error_1) + (f_b4 - f_b3_error_1);
  const float f_b2 = f_a1_error + f_b3;
  const float f_b2_error_1 = f_b2 - f_a1_error,
      f_b2_error = f_a1_error - (f_b2 - f_b2_error_1) + (f_b3 - f_b2_error_1);
  const float f_b1 = f_a0_error + f_b2;
  const float f_b1_error_1 = f_b1 - f_a0_error,
      f_b1_error = f_a0_error - (f_b1 - f_b1_error_1) + (f_b2 - f_b1_error_1);
  const float f_b0 = f_a0 + f_b1;
  const float f_b0_error_1 = f_b0 - f_a0,
      f_b0_error = f_a0 - (f_b0 - f_b0_error_1) + (f_b1 - f_b0_error_1);
  const float f_low = f_b0_error
          + (f_b1_error + (f_b2_error + (f_b3_error + (f_b4_error + (f_b5_error + f_b6_error)))));
  const float angle = RN(f_b0 * 1.5707964f);
  const float angle_error = ksl_product_errorf(f_b0, 1.5707964f, angle);
  const float angle_low = angle_error + (RN(f_b0 * -4.371139e-08f) + RN(f_low * 1.5707964f));
  const float r_value = angle + angle_low;
  const float r_low_value = angle_low - (r_value - angle);
  const float quadrant_value = k1 + k2;
  *r = r_value;
  *r_low = r_low_value;
  return quadrant_value;
}

/* (s_error, c_error) = (sin x - s, cos x - c), (s, c) as sincos has them.
   x = k pi/2 + r, r as a pair; Taylor's polynomial of degree 17 in pairs for sin r, whose error
     gives that of cos r, as their squares are 1 together; s + s_error and c + c_error are within
     2^-42.2 of sin x and cos x, relative to these (proved), for every finite x.
   43 mul, 71 add, 8 product error, 1 div, 2 abs, 1 less, 1 select; beyond the limit, more. */
static KSL_INLINE float ksl_sincos_errorf(const float x, const float s, const float c,
    float *c_error) {
  float r, r_low,
      quadrant = ksl_sincos_error_nearf(x, &r, &r_low);
  if (fabsf(x) > 1607.0f) {
    float far_r, far_r_low;
    quadrant = ksl_sincos_error_farf(x, &far_r, &far_r_low);
    r = far_r;
    r_low = far_r_low;
  }
  const float shift4 = 5.033165e+07f;
  const float q = quadrant + shift4 - shift4 - quadrant;
  const float cos_k = 1.0f - fabsf(q);
  const float minus_sin_k = q * (1.0f + cos_k);
  const float sin_r = RN(s * cos_k) + RN(c * minus_sin_k);
  const float cos_r = RN(c * cos_k) - RN(s * minus_sin_k);
  const float argument = fabsf(r) < 2.9802322e-08f ? 0.0f : r;
  const float z = RN(argument * argument);
  const float z_error = ksl_product_errorf(argument, argument, z);
  const float cube = RN(argument * z);
  const float cube_error = ksl_product_errorf(argument, z, cube);
  const float cube_low = cube_error + RN(argument * z_error);
  const float sin5 = RN(z
          * (RN(z * z * 2.8114574e-15f) + (RN(z * -7.6471636e-13f) + 1.6059044e-10f))) +
          -2.5052108e-08f;
  const float sin4_z = RN(z * sin5);
  const float sin4 = 2.7557319e-06f + sin4_z;
  const float sin4_error = sin4_z - (sin4 - 2.7557319e-06f);
  const float sin4_low = 3.7935712e-14f + sin4_error;
  const float sin3_z = RN(z * sin4);
  const float sin3 = -0.0001984127f + sin3_z;
  const float sin3_error = sin3_z - (sin3 - -0.0001984127f);
  const float sin3_low = RN(sin4 * z_error) + ksl_product_errorf(z, sin4, sin3_z) + 2.7255969e-12f
          + sin3_error + RN(z * sin4_low);
  const float sin2_z = RN(z * sin3);
  const float sin2 = 0.008333334f + sin2_z;
  const float sin2_error = sin2_z - (sin2 - 0.008333334f);
  const float sin2_low = RN(sin3 * z_error) + ksl_product_errorf(z, sin3, sin2_z) + -4.346172e-10f
          + sin2_error + RN(z * sin3_low);
  const float sin1_z = RN(z * sin2);
  const float sin1 = -0.16666667f + sin1_z;
  const float sin1_error = sin1_z - (sin1 - -0.16666667f);
  const float sin1_low = RN(sin2 * z_error) + ksl_product_errorf(z, sin2, sin1_z) + 4.967054e-09f
          + sin1_error + RN(z * sin2_low);
  const float more = RN(cube * sin1);
  const float more_error = ksl_product_errorf(cube, sin1, more);
  const float more_low = more_error + RN(cube_low * sin1);
  const float last = RN(cube * sin1_low);
  const float difference = r - sin_r;
  const float known_sin_r = argument - difference;
  const float sin_r_error = difference + more + (more_low + RN(r_low * cos_r)) + last;
  const float h = 1.0f - cos_r;
  const float inverse = 1.0f / cos_r;
  const float square = RN(known_sin_r * known_sin_r);
  const float square_error = ksl_product_errorf(known_sin_r, known_sin_r, square);
  const float h_square = RN(h * h);
  const float h_square_error = ksl_product_errorf(h, h, h_square);
  const float excess = h + h - square - h_square - (square_error + h_square_error);
  const float tangent = known_sin_r * inverse;
  const float cos_r_error = RN(excess * (inverse * 0.5f)) - RN(tangent * sin_r_error);
  const float s_error_value = RN(sin_r_error * cos_k) - RN(cos_r_error * minus_sin_k);
  const float c_error_value = RN(cos_r_error * cos_k) + RN(sin_r_error * minus_sin_k);
  *c_error = c_error_value;
  return s_error_value;
}
#endif

#ifndef KSL_SIN_ERRORF
#define KSL_SIN_ERRORF
/* sin x - s, as ksl_sincos_errorf. */
static KSL_INLINE float ksl_sin_errorf(const float x, const float s) {
  float c, c_error;
  (void)ksl_sincosf(x, &c);
  return ksl_sincos_errorf(x, s, c, &c_error);
}
#endif

#ifndef KSL_COS_ERRORF
#define KSL_COS_ERRORF
/* cos x - c, as ksl_sincos_errorf. */
static KSL_INLINE float ksl_cos_errorf(const float x, const float c) {
  float unused, c_error;
  (void)ksl_sincos_errorf(x, ksl_sincosf(x, &unused), c, &c_error);
  return c_error;
}
#endif



#ifndef KSL_SINCOS_ERROR_4F
#define KSL_SINCOS_ERROR_4F
#if defined(__GNUC__) && defined(__SSE2__) && defined(__SSE2_MATH__)
#ifndef KSL_ABS_LANESF
typedef float ksl_lanesf __attribute__((vector_size(16)));
typedef uint32_t ksl_bitsf __attribute__((vector_size(16)));
#define KSL_ABS_LANESF(x) ((ksl_lanesf)((ksl_bitsf)(x) & 0x7fffffff))
#if defined(__clang__) && KSL_HAS_FMA && !defined(KSL_CONTRACT_OFF)
static inline __attribute__((unused)) ksl_lanesf ksl_rounded_lanesf(ksl_lanesf x) {
  __asm__("" : "+x"(x));
  return x;
}
#define KSL_ROUNDED_LANESF(product) ksl_rounded_lanesf(product)
#else
#define KSL_ROUNDED_LANESF(product) KSL_RNF(product)
#endif
#endif

/* x where the test fails, else 0. */
#define KSL_UNLESS_LANESF(test, x) ((ksl_lanesf)(~(ksl_bitsf)(test) & (ksl_bitsf)(x)))
/* a b - p, p the rounded product, where neither the halves nor their products overflow or
   underflow. */
#ifdef __FMA__
#include <immintrin.h>
#define KSL_PRODUCT_ERROR_LANESF(a, b, p) \
    ((ksl_lanesf)_mm_fmsub_ps((__m128)(a), (__m128)(b), (__m128)(p)))
#else
#define KSL_HIGH_LANESF(x) ((ksl_lanesf)(((ksl_bitsf)(x) + 0x800) & 0xfffff000))
#define KSL_LOW_LANESF(x) ((x) - KSL_HIGH_LANESF(x))
#define KSL_PRODUCT_ERROR_LANESF(a, b, p) (KSL_HIGH_LANESF(a) * KSL_HIGH_LANESF(b) - (p) \
    + KSL_HIGH_LANESF(a) * KSL_LOW_LANESF(b) + KSL_LOW_LANESF(a) * KSL_HIGH_LANESF(b) \
    + KSL_LOW_LANESF(a) * KSL_LOW_LANESF(b))
#endif

/* ksl_sincos_errorf of 4 angles, with the same bits. */
static KSL_INLINED void ksl_sincos_error_4f(const float x0, const float x1, const float x2,
    const float x3, const float s[4], const float c[4], float s_error[4],
    float c_error[4]) {
  const ksl_lanesf x = {x0, x1, x2, x3};
  const ksl_lanesf quadrant_value = KSL_ROUNDED_LANESF(x * 0.63661975f) + 1.2582912e+07f
          - 1.2582912e+07f;
  const ksl_lanesf high = x - KSL_ROUNDED_LANESF(quadrant_value * 1.5706787f)
          - KSL_ROUNDED_LANESF(quadrant_value * 0.000117599964f);
  const ksl_lanesf a_1 = KSL_ROUNDED_LANESF(quadrant_value * -1.589251e-08f), a = high + a_1;
  const ksl_lanesf a_error_1 = a - high, a_error = high - (a - a_error_1) + (a_1 - a_error_1);
  const ksl_lanesf fourth = a_error - KSL_ROUNDED_LANESF(quadrant_value * 7.442935e-13f);
  const ksl_lanesf b = a + fourth;
  const ksl_lanesf b_error = fourth - (b - a);
  const ksl_lanesf fifth = b_error - KSL_ROUNDED_LANESF(quadrant_value * 6.123032e-17f);
  const ksl_lanesf r_value = b + fifth;
  const ksl_lanesf r_error = fifth - (r_value - b);
  const ksl_lanesf r_low_value = r_error - KSL_ROUNDED_LANESF(quadrant_value * 2.0222662e-21f);
  ksl_lanesf quadrant = quadrant_value, r = r_value, r_low = r_low_value;
  ksl_lanesf s_lanes;
  memcpy(&s_lanes, s, sizeof s_lanes);
  ksl_lanesf c_lanes;
  memcpy(&c_lanes, c, sizeof c_lanes);
  if (fabsf(x0) > 1607.0f || fabsf(x1) > 1607.0f ||
      fabsf(x2) > 1607.0f || fabsf(x3) > 1607.0f) {
    for (int i = 0; i < 4; ++i) {
      if (fabsf(x[i]) > 1607.0f) {
        float r_i, r_low_i;
        quadrant[i] = ksl_sincos_error_farf(x[i], &r_i, &r_low_i);
        r[i] = r_i;
        r_low[i] = r_low_i;
      }
    }
  }
  const ksl_lanesf q = quadrant + 5.033165e+07f - 5.033165e+07f - quadrant;
  const ksl_lanesf cos_k = 1.0f - KSL_ABS_LANESF(q);
  const ksl_lanesf minus_sin_k = q * (1.0f + cos_k);
  const ksl_lanesf sin_r = KSL_ROUNDED_LANESF(s_lanes * cos_k)
          + KSL_ROUNDED_LANESF(c_lanes * minus_sin_k);
  const ksl_lanesf cos_r = KSL_ROUNDED_LANESF(c_lanes * cos_k)
          - KSL_ROUNDED_LANESF(s_lanes * minus_sin_k);
  const ksl_lanesf argument = KSL_UNLESS_LANESF(KSL_ABS_LANESF(r) < 2.9802322e-08f, r);
  const ksl_lanesf z = KSL_ROUNDED_LANESF(argument * argument);
  const ksl_lanesf z_error = KSL_PRODUCT_ERROR_LANESF(argument, argument, z);
  const ksl_lanesf cube = KSL_ROUNDED_LANESF(argument * z);
  const ksl_lanesf cube_error = KSL_PRODUCT_ERROR_LANESF(argument, z, cube);
  const ksl_lanesf cube_low = cube_error + KSL_ROUNDED_LANESF(argument * z_error);
  const ksl_lanesf sin5 = KSL_ROUNDED_LANESF(z
          * (KSL_ROUNDED_LANESF(z * z * 2.8114574e-15f)
          + (KSL_ROUNDED_LANESF(z * -7.6471636e-13f) + 1.6059044e-10f))) + -2.5052108e-08f;
  const ksl_lanesf sin4_z = KSL_ROUNDED_LANESF(z * sin5);
  const ksl_lanesf sin4 = 2.7557319e-06f + sin4_z;
  const ksl_lanesf sin4_error = sin4_z - (sin4 - 2.7557319e-06f);
  const ksl_lanesf sin4_low = 3.7935712e-14f + sin4_error;
  const ksl_lanesf sin3_z = KSL_ROUNDED_LANESF(z * sin4);
  const ksl_lanesf sin3 = -0.0001984127f + sin3_z;
  const ksl_lanesf sin3_error = sin3_z - (sin3 - -0.0001984127f);
  const ksl_lanesf sin3_low = KSL_ROUNDED_LANESF(sin4 * z_error)
          + KSL_PRODUCT_ERROR_LANESF(z, sin4, sin3_z) + 2.7255969e-12f + sin3_error
          + KSL_ROUNDED_LANESF(z * sin4_low);
  const ksl_lanesf sin2_z = KSL_ROUNDED_LANESF(z * sin3);
  const ksl_lanesf sin2 = 0.008333334f + sin2_z;
  const ksl_lanesf sin2_error = sin2_z - (sin2 - 0.008333334f);
  const ksl_lanesf sin2_low = KSL_ROUNDED_LANESF(sin3 * z_error)
          + KSL_PRODUCT_ERROR_LANESF(z, sin3, sin2_z) + -4.346172e-10f + sin2_error
          + KSL_ROUNDED_LANESF(z * sin3_low);
  const ksl_lanesf sin1_z = KSL_ROUNDED_LANESF(z * sin2);
  const ksl_lanesf sin1 = -0.16666667f + sin1_z;
  const ksl_lanesf sin1_error = sin1_z - (sin1 - -0.16666667f);
  const ksl_lanesf sin1_low = KSL_ROUNDED_LANESF(sin2 * z_error)
          + KSL_PRODUCT_ERROR_LANESF(z, sin2, sin1_z) + 4.967054e-09f + sin1_error
          + KSL_ROUNDED_LANESF(z * sin2_low);
  const ksl_lanesf more = KSL_ROUNDED_LANESF(cube * sin1);
  const ksl_lanesf more_error = KSL_PRODUCT_ERROR_LANESF(cube, sin1, more);
  const ksl_lanesf more_low = more_error + KSL_ROUNDED_LANESF(cube_low * sin1);
  const ksl_lanesf last = KSL_ROUNDED_LANESF(cube * sin1_low);
  const ksl_lanesf difference = r - sin_r;
  const ksl_lanesf known_sin_r = argument - difference;
  const ksl_lanesf sin_r_error = difference + more + (more_low + KSL_ROUNDED_LANESF(r_low * cos_r))
          + last;
  const ksl_lanesf h = 1.0f - cos_r;
  const ksl_lanesf inverse = 1.0f / cos_r;
  const ksl_lanesf square = KSL_ROUNDED_LANESF(known_sin_r * known_sin_r);
  const ksl_lanesf square_error = KSL_PRODUCT_ERROR_LANESF(known_sin_r, known_sin_r, square);
  const ksl_lanesf h_square = KSL_ROUNDED_LANESF(h * h);
  const ksl_lanesf h_square_error = KSL_PRODUCT_ERROR_LANESF(h, h, h_square);
  const ksl_lanesf excess = h + h - square - h_square - (square_error + h_square_error);
  const ksl_lanesf tangent = known_sin_r * inverse;
  const ksl_lanesf cos_r_error = KSL_ROUNDED_LANESF(excess * (inverse * 0.5f))
          - KSL_ROUNDED_LANESF(tangent * sin_r_error);
  const ksl_lanesf s_error_value = KSL_ROUNDED_LANESF(sin_r_error * cos_k)
          - KSL_ROUNDED_LANESF(cos_r_error * minus_sin_k);
  const ksl_lanesf c_error_value = KSL_ROUNDED_LANESF(cos_r_error * cos_k)
          + KSL_ROUNDED_LANESF(sin_r_error * minus_sin_k);
  memcpy(s_error, &s_error_value, sizeof s_error_value);
  memcpy(c_error, &c_error_value, sizeof c_error_value);
}
#else
static KSL_INLINE void ksl_sincos_error_4f(const float x0, const float x1, const float x2,
    const float x3, const float s[4], const float c[4], float s_error[4],
    float c_error[4]) {
  s_error[0] = ksl_sincos_errorf(x0, s[0], c[0], c_error);
  s_error[1] = ksl_sincos_errorf(x1, s[1], c[1], c_error + 1);
  s_error[2] = ksl_sincos_errorf(x2, s[2], c[2], c_error + 2);
  s_error[3] = ksl_sincos_errorf(x3, s[3], c[3], c_error + 3);
}
#endif
#endif

#ifndef KSL_SINCOS_ERROR_2F
#define KSL_SINCOS_ERROR_2F
static KSL_INLINED void ksl_sincos_error_2f(const float x0, const float x1, const float s[4],
    const float c[4], float s_error[4], float c_error[4]) {
#ifdef KSL_ABS_LANESF
  ksl_sincos_error_4f(x0, x1, x1, x1, s, c, s_error, c_error);
#else
  s_error[0] = ksl_sincos_errorf(x0, s[0], c[0], c_error);
  s_error[1] = ksl_sincos_errorf(x1, s[1], c[1], c_error + 1);
#endif
}
#endif

#ifndef KSL_SINCOS_ERROR_3F
#define KSL_SINCOS_ERROR_3F
static KSL_INLINED void ksl_sincos_error_3f(const float x0, const float x1, const float x2,
    const float s[4], const float c[4], float s_error[4], float c_error[4]) {
#ifdef KSL_ABS_LANESF
  ksl_sincos_error_4f(x0, x1, x2, x2, s, c, s_error, c_error);
#else
  s_error[0] = ksl_sincos_errorf(x0, s[0], c[0], c_error);
  s_error[1] = ksl_sincos_errorf(x1, s[1], c[1], c_error + 1);
  s_error[2] = ksl_sincos_errorf(x2, s[2], c[2], c_error + 2);
#endif
}
#endif
#ifndef KSL_TANH_ERRORF
#define KSL_TANH_ERRORF
/* y_error = tanh x - y, y as tanh has it.
   m / d = (e^2|x| - 1) / (e^2|x| + 1), m and d as pairs; y + y_error is within 2^-42 of tanh x,
     relative to it (proved); 0 for |x| below 2^-25 and above 20.
   39 mul, 97 add, 9 product error, 1 div, 1 power of two, 3 abs, 1 copysign, 3 less, 6 select. */
static KSL_INLINE float ksl_tanh_errorf(const float x, const float y) {
  const float size = fabsf(x);
  const int tiny = size < 2.9802322e-08f;
  const int beyond = 20.0f < size;
  const float within = beyond ? 20.0f : (tiny ? 1.0f : size);
  const float result = tiny ? 1.0f : fabsf(y);
  const float twice = within + within;
  const float shifted = RN(twice * 1.442695f) + 1.2582912e+07f;
  const float k = shifted - 1.2582912e+07f;
  const float high = twice - RN(k * 0.69314575f);
  const float second = RN(k * -1.4285906e-06f);
  const float rest = RN(k * -1.619851e-11f);
  const float r = high + second;
  const float r_error_1 = r - high, r_error = high - (r - r_error_1) + (second - r_error_1);
  const float r_low = r_error + rest;
  const float power = ksl_powerf(shifted);
  const float whole = power + -1.0f;
  const float whole_error = -1.0f - (whole - power);
  const float argument = fabsf(r) < 2.9802322e-08f ? 0.0f : r;
  const float term8_1 = RN(argument * argument * (RN(argument * 1.6059044e-10f) + 2.0876756e-09f)),
      term8 = RN(argument * (term8_1 + (RN(argument * 2.5052108e-08f) + 2.755732e-07f)))
          + 2.7557319e-06f;
  const float term7_z = RN(argument * term8);
  const float term7 = 2.4801588e-05f + term7_z;
  const float term7_error = term7_z - (term7 - 2.4801588e-05f);
  const float term7_low = -3.406996e-13f + term7_error;
  const float term6_z = RN(argument * term7);
  const float term6 = 0.0001984127f + term6_z;
  const float term6_error = term6_z - (term6 - 0.0001984127f);
  const float term6_low = RN(term7 * r_low) + ksl_product_errorf(argument, term7, term6_z) +
          -2.7255969e-12f + term6_error + RN(argument * term7_low);
  const float term5_z = RN(argument * term6);
  const float term5 = 0.0013888889f + term5_z;
  const float term5_error = term5_z - (term5 - 0.0013888889f);
  const float term5_low = RN(term6 * r_low) + ksl_product_errorf(argument, term6, term5_z) +
          -3.3631094e-11f + term5_error + RN(argument * term6_low);
  const float term4_z = RN(argument * term5);
  const float term4 = 0.008333334f + term4_z;
  const float term4_error = term4_z - (term4 - 0.008333334f);
  const float term4_low = RN(term5 * r_low) + ksl_product_errorf(argument, term5, term4_z) +
          -4.346172e-10f + term4_error + RN(argument * term5_low);
  const float term3_z = RN(argument * term4);
  const float term3 = 0.041666668f + term3_z;
  const float term3_error = term3_z - (term3 - 0.041666668f);
  const float term3_low = RN(term4 * r_low) + ksl_product_errorf(argument, term4, term3_z) +
          -1.2417635e-09f + term3_error + RN(argument * term4_low);
  const float term2_z = RN(argument * term3);
  const float term2 = 0.16666667f + term2_z;
  const float term2_error = term2_z - (term2 - 0.16666667f);
  const float term2_low = RN(term3 * r_low) + ksl_product_errorf(argument, term3, term2_z) +
          -4.967054e-09f + term2_error + RN(argument * term3_low);
  const float term1_z = RN(argument * term2);
  const float term1 = 0.5f + term1_z;
  const float term1_error = term1_z - (term1 - 0.5f);
  const float term1_low = RN(term2 * r_low) + ksl_product_errorf(argument, term2, term1_z)
          + term1_error + RN(argument * term2_low);
  const float term_sum = RN(argument * term1);
  const float term_sum_error = ksl_product_errorf(argument, term1, term_sum);
  const float term_sum_low = term_sum_error + (RN(argument * term1_low) + RN(r_low * term1));
  const float grown_more = RN(r * term_sum);
  const float grown_more_error = ksl_product_errorf(r, term_sum, grown_more);
  const float grown_more_low = grown_more_error + (RN(r * term_sum_low) + RN(r_low * term_sum));
  const float grown = r + grown_more;
  const float grown_error = grown_more - (grown - r);
  const float grown_low = grown_error + (grown_more_low + r_low);
  const float more = RN(grown * power);
  const float more_low = RN(grown_low * power);
  const float m_sum = whole + more;
  const float m_sum_error_1 = m_sum - whole,
      m_sum_error = whole - (m_sum - m_sum_error_1) + (more - m_sum_error_1);
  const float m_sum_low = m_sum_error + (more_low + whole_error);
  const float m = m_sum + m_sum_low;
  const float m_low = m_sum_low - (m - m_sum);
  const float d_sum = 2.0f + m;
  const float d_sum_error_1 = d_sum - 2.0f,
      d_sum_error = 2.0f - (d_sum - d_sum_error_1) + (m - d_sum_error_1);
  const float d_sum_low = d_sum_error + m_low;
  const float d = d_sum + d_sum_low;
  const float d_low = d_sum_low - (d - d_sum);
  const float product = RN(result * d);
  const float product_rest = ksl_product_errorf(result, d, product);
  const float error = (m - product - product_rest + (m_low - RN(result * d_low))) / d;
  const float known = tiny ? 0.0f : (beyond ? 0.0f : error);
  const float y_error_value = RN(known * copysignf(1.0f, x));
  return y_error_value;
}
#endif


#undef RN


#endif
