/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors with a number of each of several elements, and elementary functions of them: what kernels
   on vectors need. */
#ifndef KSL_STATES_H
#define KSL_STATES_H

#include <stddef.h>

#include "elementary.h"

/* The registers of the processor that this is compiled for hold so many bytes of states, a number of
   each; 0 if they are not known.  KSL_LANE_BYTES may be defined as fewer: 16, 32, 64, or 0; and
   KSL_REGISTER_BYTES where attributes of functions choose a processor, which define no macros. */
#if defined(KSL_REGISTER_BYTES)
#elif !defined(__GNUC__)
#define KSL_REGISTER_BYTES 0
#elif defined(__AVX512F__)
#define KSL_REGISTER_BYTES 64
#elif defined(__AVX__)
#define KSL_REGISTER_BYTES 32
#elif defined(__SSE2__) || defined(__aarch64__)
#define KSL_REGISTER_BYTES 16
#else
#define KSL_REGISTER_BYTES 0
#endif
#ifndef KSL_LANE_BYTES
#define KSL_LANE_BYTES KSL_REGISTER_BYTES
#elif KSL_LANE_BYTES > KSL_REGISTER_BYTES
#error "KSL_LANE_BYTES: this processor's registers are smaller"
#endif
#if KSL_LANE_BYTES && (defined(__x86_64__) || defined(__i386__))
#include <immintrin.h>
#endif

#if KSL_LANE_BYTES

#ifndef KSL_LANES
/* As many numbers as a register holds, each of another state. */
#define KSL_LANES (KSL_LANE_BYTES / 8)
typedef double ksl_states __attribute__((vector_size(KSL_LANE_BYTES)));
typedef int64_t ksl_tests __attribute__((vector_size(KSL_LANE_BYTES)));
typedef uint64_t ksl_encoded __attribute__((vector_size(KSL_LANE_BYTES)));

/* x, of every state. */
static KSL_INLINED ksl_states ksl_each_lanes(const double x) {
  const ksl_states zero = {0};
  return x - zero;
}

static KSL_INLINED ksl_states ksl_product_lanes(ksl_states x) {
#if defined(__clang__) && KSL_HAS_FMA && !defined(KSL_CONTRACT_OFF)
#if defined(__aarch64__)
  __asm__("" : "+w"(x));
#else
  __asm__("" : "+x"(x));
#endif
#endif
  return x;
}
#if defined(__clang__)
#define KSL_RN_LANES(product) ksl_product_lanes(product)
#else
#define KSL_RN_LANES(product) (product)
#endif

static KSL_INLINED ksl_tests ksl_less_lanes(const ksl_states a, const ksl_states b) {
  return (ksl_tests)(a < b);
}

static KSL_INLINED ksl_tests ksl_equal_lanes(const ksl_states a, const ksl_states b) {
  return (ksl_tests)(a == b);
}

/* a where the test holds, else b. */
static KSL_INLINED ksl_states ksl_choice_lanes(
    const ksl_tests test, const ksl_states a, const ksl_states b) {
  return (ksl_states)((test & (ksl_tests)a) | (~test & (ksl_tests)b));
}

static KSL_INLINED ksl_states ksl_abs_lanes(const ksl_states x) {
  return (ksl_states)((ksl_encoded)x & 0x7fffffffffffffffu);
}

static KSL_INLINED ksl_states ksl_copysign_lanes(const ksl_states a, const ksl_states b) {
  return (ksl_states)(((ksl_encoded)a & 0x7fffffffffffffffu) | ((ksl_encoded)b & ~(uint64_t)0x7fffffffffffffffu));
}

/* 2^k by its bits, from 1.5 · 2^52 + k. */
static KSL_INLINED ksl_states ksl_power_lanes(const ksl_states shifted) {
  const uint64_t one = ((uint64_t)1023) << 52;
  return (ksl_states)(((ksl_encoded)shifted << 52) + one);
}

static KSL_INLINED ksl_states ksl_sqrt_lanes(ksl_states x) {
#if defined(__x86_64__) || defined(__i386__)
#if KSL_LANE_BYTES == 64
  return (ksl_states)_mm512_sqrt_pd(x);
#elif KSL_LANE_BYTES == 32
  return (ksl_states)_mm256_sqrt_pd(x);
#else
  return (ksl_states)_mm_sqrt_pd(x);
#endif
#else
  for (int i = 0; i < KSL_LANES; ++i) x[i] = sqrt(x[i]);
  return x;
#endif
}

/* Whether the test holds of any state. */
static KSL_INLINED int ksl_any_lanes(const ksl_tests test) {
#if defined(__SSE2__) && KSL_LANE_BYTES == 16
  return _mm_movemask_epi8((__m128i)test) != 0;
#elif KSL_LANE_BYTES == 32
  return !_mm256_testz_si256((__m256i)test, (__m256i)test);
#elif KSL_LANE_BYTES == 64
  return _mm512_test_epi32_mask((__m512i)test, (__m512i)test) != 0;
#else
  int any = 0;
  for (int i = 0; i < KSL_LANES; ++i) any |= test[i] != 0;
  return any;
#endif
}
#endif

#ifndef KSL_ATAN2_LANES
#define KSL_ATAN2_LANES

/* ksl_atan2 of KSL_LANES states, with the same bits. */
static KSL_INLINE ksl_states ksl_atan2_lanes(const ksl_states y, const ksl_states x) {
  const ksl_states height = ksl_abs_lanes(y);
  const ksl_states width = ksl_abs_lanes(x);
  const ksl_tests steep = ksl_less_lanes(width, height);
  const ksl_states a = ksl_choice_lanes(steep, width, height),
      a_1 = ksl_choice_lanes(steep, height, width);
  const ksl_tests infinite = ksl_less_lanes(ksl_each_lanes(1.7976931348623157e+308), a_1);
  const ksl_states scale = ksl_choice_lanes(infinite, ksl_each_lanes(0.0),
      ksl_choice_lanes(ksl_less_lanes(a_1, ksl_each_lanes(1.152921504606847e+18)),
      ksl_each_lanes(9.076030935533344e+279),
      ksl_choice_lanes(ksl_less_lanes(ksl_each_lanes(1.0463951242053392e+298), a_1),
      ksl_each_lanes(9.094947017729282e-13), ksl_each_lanes(1.0))));
  const ksl_states scaled_a =
      ksl_choice_lanes(ksl_less_lanes(ksl_each_lanes(1.7976931348623157e+308), a),
      ksl_each_lanes(1.0), KSL_RN_LANES(a * scale));
  const ksl_states scaled_b_1 = ksl_choice_lanes(infinite, ksl_each_lanes(1.0), KSL_RN_LANES(a_1 *
      scale)),
      scaled_b = ksl_choice_lanes(ksl_equal_lanes(scaled_b_1, ksl_each_lanes(0.0)),
          ksl_each_lanes(1.0), scaled_b_1);
  const ksl_tests above = ksl_less_lanes(scaled_b, scaled_a + scaled_a);
  const ksl_states side = ksl_copysign_lanes(ksl_each_lanes(1.0), x);
  const ksl_states sign = ksl_choice_lanes(steep, -side, side);
  const ksl_states quarters = ksl_choice_lanes(steep, ksl_each_lanes(2.0), 2.0 - (side + side))
          + ksl_choice_lanes(above, sign, ksl_each_lanes(0.0));
  const ksl_states base = KSL_RN_LANES(quarters * 0.7853981633974483);
  const ksl_states total = scaled_a + scaled_b;
  const ksl_states n = KSL_RN_LANES(sign * ksl_choice_lanes(above, scaled_a - scaled_b, scaled_a));
  const ksl_states rest_of_d = ksl_choice_lanes(above, scaled_b - total
          + scaled_a, ksl_each_lanes(0.0));
  const ksl_states d = ksl_choice_lanes(above, total, scaled_b);
  const ksl_states inverse = 1.0 / d;
  const ksl_states q_high_1 = KSL_RN_LANES(n * inverse), q_high_2 = KSL_RN_LANES(q_high_1 *
      134217729.0),
      q_high = q_high_2 - (q_high_2 - q_high_1);
  const ksl_states d_high_1 = KSL_RN_LANES(d * 134217729.0), d_high = d_high_1 - (d_high_1 - d);
  const ksl_states d_low = d - d_high;
  const ksl_states but_high = n - KSL_RN_LANES(q_high * d_high);
  const ksl_states but_low = but_high - KSL_RN_LANES(q_high * d_low);
  const ksl_states c = KSL_RN_LANES((but_low - KSL_RN_LANES(q_high * rest_of_d)) * inverse);
  const ksl_states q = q_high + c;
  const ksl_states z = q * q;
  const ksl_states tail_1 = z * z, tail_2 = tail_1 * tail_1,
      tail_3 = KSL_RN_LANES(tail_2
          * (KSL_RN_LANES(tail_1 * (KSL_RN_LANES(z * -0.05121994511422147) + 0.058582966172403564))
          + (KSL_RN_LANES(z * -0.06663810317366585) + 0.07692073887659807))),
      tail_4 = tail_3
          + (KSL_RN_LANES(tail_1 * (KSL_RN_LANES(z * -0.09090896243462607) + 0.11111110659599031))
          + (KSL_RN_LANES(z * -0.1428571427638533) + 0.19999999999903106)),
      tail_5 = KSL_RN_LANES(z
          * (KSL_RN_LANES(tail_2 * tail_2
          * (KSL_RN_LANES(tail_1 * 0.010116413558090894)
          + (KSL_RN_LANES(z * -0.0274343623051046) + 0.04186470045016432))) + tail_4)),
      tail = KSL_RN_LANES(q * z * (tail_5 + -0.3333333333333298)) + c + KSL_RN_LANES(quarters *
          3.061616997868383e-17);
  const ksl_states sum = base + q_high;
  const ksl_states positive = sum + (base - sum + q_high + tail);
  const ksl_states angle_value = ksl_copysign_lanes(positive, y);
  return angle_value;
}
#endif

#ifndef KSL_EXP_LANES
#define KSL_EXP_LANES

/* ksl_exp of KSL_LANES states, with the same bits. */
static KSL_INLINE ksl_states ksl_exp_lanes(const ksl_states x) {
  const ksl_states within_1 = ksl_choice_lanes(ksl_less_lanes(ksl_each_lanes(710.0), x),
      ksl_each_lanes(710.0), x),
      within = ksl_choice_lanes(ksl_less_lanes(within_1, ksl_each_lanes(-746.0)),
          ksl_each_lanes(-746.0), within_1);
  const ksl_states shifted = KSL_RN_LANES(within * 1.4426950408889634) + 6755399441055744.0;
  const ksl_states k = shifted - 6755399441055744.0;
  const ksl_states high = within - KSL_RN_LANES(k * 0.6931471805598903);
  const ksl_states rest = KSL_RN_LANES(k * 5.497923018708371e-14);
  const ksl_states r = high - rest;
  const ksl_states low_1 = r * r,
      low_2 = KSL_RN_LANES(low_1 * (KSL_RN_LANES(r * 0.0013888888926860458) + 0.008333333333500498))
          + (KSL_RN_LANES(r * 0.04166666666660382) + 0.16666666666666433),
      low_3 = KSL_RN_LANES(low_1 * (KSL_RN_LANES(r * 2.762522584904681e-07) +
          2.7557641500508844e-06))
          + (KSL_RN_LANES(r * 2.4801508592805324e-05) + 0.00019841269465342197), low_4 = low_1 *
              low_1,
      low = KSL_RN_LANES(r * r
          * (KSL_RN_LANES(r * (KSL_RN_LANES(low_4 * low_4 * 2.4978234152604323e-08) +
              (KSL_RN_LANES(low_4 * low_3) + low_2)))
          + 0.5)) - rest;
  const ksl_tests small = ksl_less_lanes(within, ksl_each_lanes(-700.0));
  const ksl_states start = high + 1.0;
  const ksl_states e_r = start + (1.0 - start + high + low);
  const ksl_states scaled = e_r
          * ksl_power_lanes(shifted
          + ksl_choice_lanes(small, ksl_each_lanes(64.0), ksl_each_lanes(-1.0)));
  const ksl_states y_value = KSL_RN_LANES(scaled
          * ksl_choice_lanes(small, ksl_each_lanes(5.421010862427522e-20), ksl_each_lanes(2.0)));
  return y_value;
}
#endif

#ifndef KSL_SINCOS_LANES
#define KSL_SINCOS_LANES
static KSL_INLINED ksl_states ksl_sincos_near_lanes(const ksl_states x, ksl_states *r,
    ksl_states *r_excess) {
  const double shift = 6755399441055744.0;
  const ksl_states quadrant_value = KSL_RN_LANES(x * 0.6366197723675814) + shift - shift;
  const ksl_states high = x - KSL_RN_LANES(quadrant_value * 1.5707963267341256)
          - KSL_RN_LANES(quadrant_value * 6.077094383272197e-11);
  const ksl_states low = KSL_RN_LANES(quadrant_value * 6.12323399409214e-17);
  const ksl_states r_value = high - low;
  const ksl_states r_excess_value = r_value - high + low
          + KSL_RN_LANES(quadrant_value * 1.6446256936324258e-26);
  *r = r_value;
  *r_excess = r_excess_value;
  return quadrant_value;
}

/* Its reduction where an angle is larger: of those one by one. */
static KSL_COLD void ksl_sincos_far_lanes(
    const ksl_states *x, ksl_states *quadrant, ksl_states *r, ksl_states *r_excess) {
  for (int i = 0; i < KSL_LANES; ++i) {
    const double x_i = (*x)[i];
    if (fabs(x_i) > 6588396.0) {
      double r_i, r_excess_i;
      (*quadrant)[i] = ksl_sincos_far(x_i, &r_i, &r_excess_i);
      (*r)[i] = r_i;
      (*r_excess)[i] = r_excess_i;
    }
  }
}

/* ksl_sincos of KSL_LANES states, with the same bits. */
static KSL_INLINED ksl_states ksl_sincos_lanes(const ksl_states x, ksl_states *c) {
  ksl_states r, r_excess,
      quadrant = ksl_sincos_near_lanes(x, &r, &r_excess);
  if (ksl_any_lanes((ksl_tests)(ksl_abs_lanes(x) > 6588396.0)))
    ksl_sincos_far_lanes(&x, &quadrant, &r, &r_excess);
  const double shift4 = 2.7021597764222976e+16;
  const ksl_states z = r * r;
  const ksl_states z2 = z * z;
  const ksl_states half_z = KSL_RN_LANES(z * 0.5);
  const ksl_states w = 1.0 - half_z;
  const ksl_states sin_r_1 = KSL_RN_LANES(z2
          * (0.00019841269829358447 + KSL_RN_LANES(z * -2.7557313538442266e-06)
          + KSL_RN_LANES(z2 * (2.5050734370397888e-08 + KSL_RN_LANES(z *
              -1.5895431762410801e-10))))),
      sin_r = r
          - (KSL_RN_LANES(z * r * (0.1666666666666663 + (KSL_RN_LANES(z * -0.00833333333332184) +
              sin_r_1)))
          + KSL_RN_LANES(r_excess * w));
  const ksl_states cos_r_1 = KSL_RN_LANES(z2
          * (2.48015872882953e-05 + KSL_RN_LANES(z * -2.7557314015067576e-07)
          + KSL_RN_LANES(z2 * (2.087567807349307e-09 + KSL_RN_LANES(z *
              -1.1357335951124145e-11))))),
      cos_r = w
          + (1.0 - w - half_z
          + (KSL_RN_LANES(z2 * (0.04166666666666659 + (KSL_RN_LANES(z * -0.0013888888888872186) +
              cos_r_1)))
          + KSL_RN_LANES(r * r_excess)));
  const ksl_states q = quadrant + shift4 - shift4 - quadrant;
  const ksl_states cos_k = 1.0 - ksl_abs_lanes(q);
  const ksl_states minus_sin_k = q * (1.0 + cos_k);
  const ksl_states s_value = KSL_RN_LANES(sin_r * cos_k) - KSL_RN_LANES(cos_r * minus_sin_k);
  const ksl_states c_value = KSL_RN_LANES(cos_r * cos_k) + KSL_RN_LANES(sin_r * minus_sin_k);
  *c = c_value;
  return s_value;
}
#endif

#ifndef KSL_SIN_LANES
#define KSL_SIN_LANES
static KSL_INLINE ksl_states ksl_sin_lanes(const ksl_states x) {
  ksl_states c, s = ksl_sincos_lanes(x, &c);
  (void)s;
  return s;
}

#endif

#ifndef KSL_COS_LANES
#define KSL_COS_LANES
static KSL_INLINE ksl_states ksl_cos_lanes(const ksl_states x) {
  ksl_states c, s = ksl_sincos_lanes(x, &c);
  (void)s;
  return c;
}

#endif

#ifndef KSL_TANH_LANES
#define KSL_TANH_LANES

/* ksl_tanh of KSL_LANES states, with the same bits. */
static KSL_INLINE ksl_states ksl_tanh_lanes(const ksl_states x) {
  const ksl_states size = ksl_abs_lanes(x);
  const ksl_tests small = ksl_less_lanes(size, ksl_each_lanes(0.625));
  const ksl_states z = size * size;
  const ksl_states above = size * z
          * (KSL_RN_LANES((KSL_RN_LANES(z * -0.00019908890916339926) + -0.020496786093244908) * z) +
          -0.33333333333333326);
  const ksl_states below = KSL_RN_LANES((KSL_RN_LANES((KSL_RN_LANES(z * 0.00020643828172711687) +
      0.023288648134874086) * z)
          + 0.4614903582797203) * z) + 1.0;
  const ksl_states twice_1 = size + size,
      twice = ksl_choice_lanes(ksl_less_lanes(ksl_each_lanes(40.0), twice_1), ksl_each_lanes(40.0),
          twice_1);
  const ksl_states shifted = KSL_RN_LANES(twice * 1.4426950408889634) + 6755399441055744.0;
  const ksl_states k = shifted - 6755399441055744.0;
  const ksl_states high = twice - KSL_RN_LANES(k * 0.6931471805598903);
  const ksl_states rest = KSL_RN_LANES(k * 5.497923018708371e-14);
  const ksl_states r = high - rest;
  const ksl_states low_1 = r * r,
      low_2 = KSL_RN_LANES(low_1 * (KSL_RN_LANES(r * 0.0013888888926860458) + 0.008333333333500498))
          + (KSL_RN_LANES(r * 0.04166666666660382) + 0.16666666666666433),
      low_3 = KSL_RN_LANES(low_1 * (KSL_RN_LANES(r * 2.762522584904681e-07) +
          2.7557641500508844e-06))
          + (KSL_RN_LANES(r * 2.4801508592805324e-05) + 0.00019841269465342197), low_4 = low_1 *
              low_1,
      low = KSL_RN_LANES(r * r
          * (KSL_RN_LANES(r * (KSL_RN_LANES(low_4 * low_4 * 2.4978234152604323e-08) +
              (KSL_RN_LANES(low_4 * low_3) + low_2)))
          + 0.5)) - rest;
  const ksl_states power = ksl_power_lanes(shifted);
  const ksl_states s_1 = power + 1.0, s = high + low;
  const ksl_states rest_of_e = KSL_RN_LANES(s * power);
  const ksl_states total = s_1 + rest_of_e;
  const ksl_states low_of_total = s_1 - total + rest_of_e;
  const ksl_states quotient = ksl_choice_lanes(small, above, ksl_each_lanes(-2.0))
          / ksl_choice_lanes(small, below, total);
  const ksl_states correction = ksl_choice_lanes(small, ksl_each_lanes(0.0), KSL_RN_LANES(quotient
          * low_of_total * (quotient * 0.5)));
  const ksl_states start = ksl_choice_lanes(small, size, ksl_each_lanes(1.0));
  const ksl_states sum_1 = start + quotient, sum = sum_1 + (start - sum_1 + quotient + correction);
  const ksl_states y_value = ksl_copysign_lanes(sum, x);
  return y_value;
}
#endif

/* KSL_LANES elements; those after the one numbered `last` are copies of it. */
static KSL_INLINED void ksl_states_of_planes(const double *from, const int size,
    const ptrdiff_t plane, const ptrdiff_t stride, const ptrdiff_t last, ksl_states *x) {
  for (int j = 0; j < size; ++j) {
    if (stride == 1 && last + 1 == KSL_LANES) {
      memcpy(&x[j], from + j * plane, sizeof x[j]);
    } else {
      for (int i = 0; i < KSL_LANES; ++i)
        x[j][i] = from[j * plane + (i < last ? i : last) * stride];
    }
  }
}

/* The first elements up to the one numbered `last`. */
static KSL_INLINED void ksl_states_to_planes(const ksl_states *x, const int size,
    double *to, const ptrdiff_t plane, const ptrdiff_t stride, const ptrdiff_t last) {
  for (int j = 0; j < size; ++j) {
    if (stride == 1 && last + 1 == KSL_LANES) {
      memcpy(to + j * plane, &x[j], sizeof x[j]);
    } else {
      for (ptrdiff_t i = 0; i <= last; ++i) to[j * plane + i * stride] = x[j][i];
    }
  }
}

#ifndef KSL_LANESF
/* As many numbers as a register holds, each of another state. */
#define KSL_LANESF (KSL_LANE_BYTES / 4)
typedef float ksl_statesf __attribute__((vector_size(KSL_LANE_BYTES)));
typedef int32_t ksl_testsf __attribute__((vector_size(KSL_LANE_BYTES)));
typedef uint32_t ksl_encodedf __attribute__((vector_size(KSL_LANE_BYTES)));

/* x, of every state. */
static KSL_INLINED ksl_statesf ksl_each_lanesf(const float x) {
  const ksl_statesf zero = {0};
  return x - zero;
}

static KSL_INLINED ksl_statesf ksl_product_lanesf(ksl_statesf x) {
#if defined(__clang__) && KSL_HAS_FMAF && !defined(KSL_CONTRACT_OFF)
#if defined(__aarch64__)
  __asm__("" : "+w"(x));
#else
  __asm__("" : "+x"(x));
#endif
#endif
  return x;
}
#if defined(__clang__)
#define KSL_RN_LANESF(product) ksl_product_lanesf(product)
#else
#define KSL_RN_LANESF(product) (product)
#endif

static KSL_INLINED ksl_testsf ksl_less_lanesf(const ksl_statesf a, const ksl_statesf b) {
  return (ksl_testsf)(a < b);
}

static KSL_INLINED ksl_testsf ksl_equal_lanesf(const ksl_statesf a, const ksl_statesf b) {
  return (ksl_testsf)(a == b);
}

/* a where the test holds, else b. */
static KSL_INLINED ksl_statesf ksl_choice_lanesf(
    const ksl_testsf test, const ksl_statesf a, const ksl_statesf b) {
  return (ksl_statesf)((test & (ksl_testsf)a) | (~test & (ksl_testsf)b));
}

static KSL_INLINED ksl_statesf ksl_abs_lanesf(const ksl_statesf x) {
  return (ksl_statesf)((ksl_encodedf)x & 0x7fffffffu);
}

static KSL_INLINED ksl_statesf ksl_copysign_lanesf(const ksl_statesf a, const ksl_statesf b) {
  return (ksl_statesf)(((ksl_encodedf)a & 0x7fffffffu) | ((ksl_encodedf)b & ~(uint32_t)0x7fffffffu));
}

/* 2^k by its bits, from 1.5 · 2^23 + k. */
static KSL_INLINED ksl_statesf ksl_power_lanesf(const ksl_statesf shifted) {
  const uint32_t one = ((uint32_t)127) << 23;
  return (ksl_statesf)(((ksl_encodedf)shifted << 23) + one);
}

static KSL_INLINED ksl_statesf ksl_sqrt_lanesf(ksl_statesf x) {
#if defined(__x86_64__) || defined(__i386__)
#if KSL_LANE_BYTES == 64
  return (ksl_statesf)_mm512_sqrt_ps(x);
#elif KSL_LANE_BYTES == 32
  return (ksl_statesf)_mm256_sqrt_ps(x);
#else
  return (ksl_statesf)_mm_sqrt_ps(x);
#endif
#else
  for (int i = 0; i < KSL_LANESF; ++i) x[i] = sqrtf(x[i]);
  return x;
#endif
}

/* Whether the test holds of any state. */
static KSL_INLINED int ksl_any_lanesf(const ksl_testsf test) {
#if defined(__SSE2__) && KSL_LANE_BYTES == 16
  return _mm_movemask_epi8((__m128i)test) != 0;
#elif KSL_LANE_BYTES == 32
  return !_mm256_testz_si256((__m256i)test, (__m256i)test);
#elif KSL_LANE_BYTES == 64
  return _mm512_test_epi32_mask((__m512i)test, (__m512i)test) != 0;
#else
  int any = 0;
  for (int i = 0; i < KSL_LANESF; ++i) any |= test[i] != 0;
  return any;
#endif
}
#endif

#ifndef KSL_ATAN2_LANESF
#define KSL_ATAN2_LANESF

/* ksl_atan2f of KSL_LANESF states, with the same bits. */
static KSL_INLINE ksl_statesf ksl_atan2_lanesf(const ksl_statesf y, const ksl_statesf x) {
  const ksl_statesf height = ksl_abs_lanesf(y);
  const ksl_statesf width = ksl_abs_lanesf(x);
  const ksl_testsf steep = ksl_less_lanesf(width, height);
  const ksl_statesf a = ksl_choice_lanesf(steep, width, height),
      a_1 = ksl_choice_lanesf(steep, height, width);
  const ksl_testsf infinite = ksl_less_lanesf(ksl_each_lanesf(3.4028235e+38f), a_1);
  const ksl_statesf scale = ksl_choice_lanesf(infinite, ksl_each_lanesf(0.0f),
      ksl_choice_lanesf(ksl_less_lanesf(a_1, ksl_each_lanesf(2.6843546e+08f)),
      ksl_each_lanesf(4.8357033e+24f),
      ksl_choice_lanesf(ksl_less_lanesf(ksl_each_lanesf(1.2980742e+33f), a_1),
      ksl_each_lanesf(9.536743e-07f), ksl_each_lanesf(1.0f))));
  const ksl_statesf scaled_a = ksl_choice_lanesf(ksl_less_lanesf(ksl_each_lanesf(3.4028235e+38f),
      a), ksl_each_lanesf(1.0f), KSL_RN_LANESF(a * scale));
  const ksl_statesf scaled_b_1 = ksl_choice_lanesf(infinite, ksl_each_lanesf(1.0f),
      KSL_RN_LANESF(a_1
          * scale)),
      scaled_b = ksl_choice_lanesf(ksl_equal_lanesf(scaled_b_1, ksl_each_lanesf(0.0f)),
          ksl_each_lanesf(1.0f), scaled_b_1);
  const ksl_testsf above = ksl_less_lanesf(scaled_b, scaled_a + scaled_a);
  const ksl_statesf side = ksl_copysign_lanesf(ksl_each_lanesf(1.0f), x);
  const ksl_statesf sign = ksl_choice_lanesf(steep, -side, side);
  const ksl_statesf quarters = ksl_choice_lanesf(steep, ksl_each_lanesf(2.0f), 2.0f
          - (side + side)) + ksl_choice_lanesf(above, sign, ksl_each_lanesf(0.0f));
  const ksl_statesf base = KSL_RN_LANESF(quarters * 0.78539824f);
  const ksl_statesf total = scaled_a + scaled_b;
  const ksl_statesf n = KSL_RN_LANESF(sign * ksl_choice_lanesf(above, scaled_a - scaled_b,
      scaled_a));
  const ksl_statesf rest_of_d = ksl_choice_lanesf(above, scaled_b - total
          + scaled_a, ksl_each_lanesf(0.0f));
  const ksl_statesf d = ksl_choice_lanesf(above, total, scaled_b);
  const ksl_statesf inverse = 1.0f / d;
  const ksl_statesf q_high_1 = KSL_RN_LANESF(n * inverse), q_high_2 = KSL_RN_LANESF(q_high_1 *
      4097.0f),
      q_high = q_high_2 - (q_high_2 - q_high_1);
  const ksl_statesf d_high_1 = KSL_RN_LANESF(d * 4097.0f), d_high = d_high_1 - (d_high_1 - d);
  const ksl_statesf d_low = d - d_high;
  const ksl_statesf but_high = n - KSL_RN_LANESF(q_high * d_high);
  const ksl_statesf but_low = but_high - KSL_RN_LANESF(q_high * d_low);
  const ksl_statesf c = KSL_RN_LANESF((but_low - KSL_RN_LANESF(q_high * rest_of_d)) * inverse);
  const ksl_statesf q = q_high + c;
  const ksl_statesf z = q * q;
  const ksl_statesf tail_1 = z * z,
      tail_2 = KSL_RN_LANESF(tail_1 * (KSL_RN_LANESF(z * -0.08009076f) + 0.10948411f))
          + (KSL_RN_LANESF(z * -0.14273107f) + 0.19999555f),
      tail = KSL_RN_LANESF(q * z * (KSL_RN_LANESF(z * (KSL_RN_LANESF(tail_1 * tail_1 * 0.039042152f)
          + tail_2)) + -0.33333328f)) + c
          + KSL_RN_LANESF(quarters * -8.146034e-08f);
  const ksl_statesf sum = base + q_high;
  const ksl_statesf positive = sum + (base - sum + q_high + tail);
  const ksl_statesf angle_value = ksl_copysign_lanesf(positive, y);
  return angle_value;
}
#endif

#ifndef KSL_EXP_LANESF
#define KSL_EXP_LANESF

/* ksl_expf of KSL_LANESF states, with the same bits. */
static KSL_INLINE ksl_statesf ksl_exp_lanesf(const ksl_statesf x) {
  const ksl_statesf within_1 = ksl_choice_lanesf(ksl_less_lanesf(ksl_each_lanesf(89.0f), x),
      ksl_each_lanesf(89.0f), x),
      within = ksl_choice_lanesf(ksl_less_lanesf(within_1, ksl_each_lanesf(-104.0f)),
          ksl_each_lanesf(-104.0f), within_1);
  const ksl_statesf shifted = KSL_RN_LANESF(within * 1.442695f) + 1.2582912e+07f;
  const ksl_statesf k = shifted - 1.2582912e+07f;
  const ksl_statesf high = within - KSL_RN_LANESF(k * 0.69314575f);
  const ksl_statesf rest = KSL_RN_LANESF(k * 1.4286068e-06f);
  const ksl_statesf r = high - rest;
  const ksl_statesf low_1 = KSL_RN_LANESF(r
          * (KSL_RN_LANESF(r * r * (KSL_RN_LANESF(r * 0.0013863435f) + 0.008367437f))
          + (KSL_RN_LANESF(r * 0.04166724f) + 0.16666535f))) + 0.5f, low = KSL_RN_LANESF(r * r *
              low_1) - rest;
  const ksl_testsf small = ksl_less_lanesf(within, ksl_each_lanesf(-80.0f));
  const ksl_statesf start = high + 1.0f;
  const ksl_statesf e_r = start + (1.0f - start + high + low);
  const ksl_statesf scaled = e_r
          * ksl_power_lanesf(shifted
          + ksl_choice_lanesf(small, ksl_each_lanesf(64.0f), ksl_each_lanesf(-1.0f)));
  const ksl_statesf y_value = KSL_RN_LANESF(scaled
          * ksl_choice_lanesf(small, ksl_each_lanesf(5.421011e-20f), ksl_each_lanesf(2.0f)));
  return y_value;
}
#endif

#ifndef KSL_SINCOS_LANESF
#define KSL_SINCOS_LANESF
static KSL_INLINED ksl_statesf ksl_sincos_near_lanesf(const ksl_statesf x, ksl_statesf *r,
    ksl_statesf *r_excess) {
  const float shift = 1.2582912e+07f;
  const ksl_statesf quadrant_value = KSL_RN_LANESF(x * 0.63661975f) + shift - shift;
  const ksl_statesf high = x - KSL_RN_LANESF(quadrant_value * 1.5706787f)
          - KSL_RN_LANESF(quadrant_value * 0.000117599964f);
  const ksl_statesf low = KSL_RN_LANESF(quadrant_value * 1.589251e-08f);
  const ksl_statesf r_value = high - low;
  const ksl_statesf r_excess_value = r_value - high + low + KSL_RN_LANESF(quadrant_value *
      7.443548e-13f);
  *r = r_value;
  *r_excess = r_excess_value;
  return quadrant_value;
}

/* Its reduction where an angle is larger: of those one by one. */
static KSL_COLD void ksl_sincos_far_lanesf(
    const ksl_statesf *x, ksl_statesf *quadrant, ksl_statesf *r, ksl_statesf *r_excess) {
  for (int i = 0; i < KSL_LANESF; ++i) {
    const float x_i = (*x)[i];
    if (fabsf(x_i) > 1607.0f) {
      float r_i, r_excess_i;
      (*quadrant)[i] = ksl_sincos_farf(x_i, &r_i, &r_excess_i);
      (*r)[i] = r_i;
      (*r_excess)[i] = r_excess_i;
    }
  }
}

/* ksl_sincosf of KSL_LANESF states, with the same bits. */
static KSL_INLINED ksl_statesf ksl_sincos_lanesf(const ksl_statesf x, ksl_statesf *c) {
  ksl_statesf r, r_excess,
      quadrant = ksl_sincos_near_lanesf(x, &r, &r_excess);
  if (ksl_any_lanesf((ksl_testsf)(ksl_abs_lanesf(x) > 1607.0f)))
    ksl_sincos_far_lanesf(&x, &quadrant, &r, &r_excess);
  const float shift4 = 5.033165e+07f;
  const ksl_statesf z = r * r;
  const ksl_statesf z2 = z * z;
  const ksl_statesf half_z = KSL_RN_LANESF(z * 0.5f);
  const ksl_statesf w = 1.0f - half_z;
  const ksl_statesf sin_r = r
          - (KSL_RN_LANESF(z * r * (0.16666654f + (KSL_RN_LANESF(z * -0.008332106f) +
              KSL_RN_LANESF(z2 * 0.00019507883f))))
          + KSL_RN_LANESF(r_excess * w));
  const ksl_statesf cos_r_1 = 1.0f - w - half_z
          + (KSL_RN_LANESF(z2 * (0.041666646f + (KSL_RN_LANESF(z * -0.0013887308f) +
              KSL_RN_LANESF(z2 * 2.44321e-05f))))
          + KSL_RN_LANESF(r * r_excess)), cos_r = w + cos_r_1;
  const ksl_statesf q = quadrant + shift4 - shift4 - quadrant;
  const ksl_statesf cos_k = 1.0f - ksl_abs_lanesf(q);
  const ksl_statesf minus_sin_k = q * (1.0f + cos_k);
  const ksl_statesf s_value = KSL_RN_LANESF(sin_r * cos_k) - KSL_RN_LANESF(cos_r * minus_sin_k);
  const ksl_statesf c_value = KSL_RN_LANESF(cos_r * cos_k) + KSL_RN_LANESF(sin_r * minus_sin_k);
  *c = c_value;
  return s_value;
}
#endif

#ifndef KSL_SIN_LANESF
#define KSL_SIN_LANESF
static KSL_INLINE ksl_statesf ksl_sin_lanesf(const ksl_statesf x) {
  ksl_statesf c, s = ksl_sincos_lanesf(x, &c);
  (void)s;
  return s;
}

#endif

#ifndef KSL_COS_LANESF
#define KSL_COS_LANESF
static KSL_INLINE ksl_statesf ksl_cos_lanesf(const ksl_statesf x) {
  ksl_statesf c, s = ksl_sincos_lanesf(x, &c);
  (void)s;
  return c;
}

#endif

#ifndef KSL_TANH_LANESF
#define KSL_TANH_LANESF

/* ksl_tanhf of KSL_LANESF states, with the same bits. */
static KSL_INLINE ksl_statesf ksl_tanh_lanesf(const ksl_statesf x) {
  const ksl_statesf size = ksl_abs_lanesf(x);
  const ksl_testsf small = ksl_less_lanesf(size, ksl_each_lanesf(0.625f));
  const ksl_statesf z = size * size;
  const ksl_statesf above = size * z
          * (KSL_RN_LANESF((KSL_RN_LANESF(z * 5.9599424e-05f) + -0.0017358434f) * z) +
              -0.33333334f);
  const ksl_statesf below = KSL_RN_LANESF(z * 0.4052077f) + 1.0f;
  const ksl_statesf twice_1 = size + size,
      twice = ksl_choice_lanesf(ksl_less_lanesf(ksl_each_lanesf(20.0f), twice_1),
          ksl_each_lanesf(20.0f), twice_1);
  const ksl_statesf shifted = KSL_RN_LANESF(twice * 1.442695f) + 1.2582912e+07f;
  const ksl_statesf k = shifted - 1.2582912e+07f;
  const ksl_statesf high = twice - KSL_RN_LANESF(k * 0.69314575f);
  const ksl_statesf rest = KSL_RN_LANESF(k * 1.4286068e-06f);
  const ksl_statesf r = high - rest;
  const ksl_statesf low_1 = KSL_RN_LANESF(r
          * (KSL_RN_LANESF(r * r * (KSL_RN_LANESF(r * 0.0013863435f) + 0.008367437f))
          + (KSL_RN_LANESF(r * 0.04166724f) + 0.16666535f))) + 0.5f, low = KSL_RN_LANESF(r * r *
              low_1) - rest;
  const ksl_statesf power = ksl_power_lanesf(shifted);
  const ksl_statesf s_1 = power + 1.0f, s = high + low;
  const ksl_statesf rest_of_e = KSL_RN_LANESF(s * power);
  const ksl_statesf total = s_1 + rest_of_e;
  const ksl_statesf low_of_total = s_1 - total + rest_of_e;
  const ksl_statesf quotient = ksl_choice_lanesf(small, above, ksl_each_lanesf(-2.0f))
          / ksl_choice_lanesf(small, below, total);
  const ksl_statesf correction = ksl_choice_lanesf(small, ksl_each_lanesf(0.0f),
      KSL_RN_LANESF(quotient
          * low_of_total * (quotient * 0.5f)));
  const ksl_statesf start = ksl_choice_lanesf(small, size, ksl_each_lanesf(1.0f));
  const ksl_statesf sum_1 = start + quotient, sum = sum_1 + (start - sum_1 + quotient + correction);
  const ksl_statesf y_value = ksl_copysign_lanesf(sum, x);
  return y_value;
}
#endif

/* KSL_LANESF elements; those after the one numbered `last` are copies of it. */
static KSL_INLINED void ksl_statesf_of_planes(const float *from, const int size,
    const ptrdiff_t plane, const ptrdiff_t stride, const ptrdiff_t last, ksl_statesf *x) {
  for (int j = 0; j < size; ++j) {
    if (stride == 1 && last + 1 == KSL_LANESF) {
      memcpy(&x[j], from + j * plane, sizeof x[j]);
    } else {
      for (int i = 0; i < KSL_LANESF; ++i)
        x[j][i] = from[j * plane + (i < last ? i : last) * stride];
    }
  }
}

/* The first elements up to the one numbered `last`. */
static KSL_INLINED void ksl_statesf_to_planes(const ksl_statesf *x, const int size,
    float *to, const ptrdiff_t plane, const ptrdiff_t stride, const ptrdiff_t last) {
  for (int j = 0; j < size; ++j) {
    if (stride == 1 && last + 1 == KSL_LANESF) {
      memcpy(to + j * plane, &x[j], sizeof x[j]);
    } else {
      for (ptrdiff_t i = 0; i <= last; ++i) to[j * plane + i * stride] = x[j][i];
    }
  }
}

#endif
#endif
