/* Times the tiers on structures of arrays that fit the first-level cache; prints
   operation,precision,tier,minimum,median in ns per element. */
#include <ksl/ksl.h>
#include <ksl/ksl_accurate.h>
#include <ksl/ksl_certified.h>
#include <ksl/ksl_fused.h>

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { COUNT = 256, ROUNDS = 4000, PLANES = 6, PADDING = 8 };

static long long now_ns(void) {
  struct timespec t;
  timespec_get(&t, TIME_UTC);
  return (long long)t.tv_sec * 1000000000 + t.tv_nsec;
}

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static double samples[ROUNDS];

#if defined(__clang__)
#define INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define INDEPENDENT _Pragma("GCC ivdep")
#endif

/* Every element: its screw and coscrew are gathered from the planes, `statement` is run, the result
   is scattered to planes. */
#define TIME(operation, f, precision, tier, statement)                                      \
  do {                                                                                      \
    for (int round = 0; round < ROUNDS; round++) {                                          \
      const long long start = now_ns();                                                     \
      INDEPENDENT                                                                           \
      for (int i = 0; i < COUNT; i++) {                                                     \
        const ksl_screw##f##_t s = {{{S[0][i], S[1][i], S[2][i], S[3][i], S[4][i], S[5][i]}}};   \
        const ksl_coscrew##f##_t c = {{{C[0][i], C[1][i], C[2][i], C[3][i], C[4][i], C[5][i]}}}; \
        ksl_coscrew##f##_t o = {{{0, 0, 0, 0, 0, 0}}};                                      \
        ksl_coscrew##f##_t b = {{{0, 0, 0, 0, 0, 0}}};                                      \
        (void)s;                                                                            \
        (void)b;                                                                            \
        statement;                                                                          \
        for (int k = 0; k < PLANES; k++) {                                                  \
          O[k][i] = o.at[k];                                                                \
        }                                                                                   \
      }                                                                                     \
      __asm__ volatile("" ::"r"(O), "r"(B), "r"(S), "r"(C) : "memory");                             \
      samples[round] = (double)(now_ns() - start) / COUNT;                                  \
    }                                                                                       \
    qsort(samples, ROUNDS, sizeof samples[0], ascending);                                   \
    printf("%s,%s,%s,%.4f,%.4f\n", operation, precision, tier, samples[0],                  \
        samples[ROUNDS / 2]);                                                               \
  } while (0)

/* A certified kernel's bounds are scattered, too. */
#define BOUNDS for (int k = 0; k < PLANES; k++) { B[k][i] = b.at[k]; }

#define ALL(real, f, precision)                                                          \
  static void time_##precision(void) {                                                   \
    static real S[PLANES][COUNT + PADDING], C[PLANES][COUNT + PADDING];                  \
    static real O[PLANES][COUNT + PADDING], B[PLANES][COUNT + PADDING];                  \
    for (int k = 0; k < PLANES; k++) {                                                   \
      for (int i = 0; i < COUNT; i++) {                                                  \
        S[k][i] = (real)(rand() % 2001 - 1000) / (real)100;                              \
        C[k][i] = (real)(rand() % 2001 - 1000) / (real)10;                               \
      }                                                                                  \
    }                                                                                    \
    const ksl_SE3##f##_t D = ksl_SE3##f((real)0.36, (real)0.48, (real)-0.8, (real)1.5,   \
        (real)-0.8, (real)0.6, 0, (real)-0.25, (real)0.48, (real)0.64, (real)0.6, 2);    \
    COADC(real, f, precision);                                                           \
    CROSS(real, f, precision);                                                           \
    POWER(real, f, precision);                                                           \
  }

#define COADC(real, f, precision)                                                        \
  TIME("product_CoAdc", f, #precision, "plain", ksl_product_CoAdc##f(&D, &c, &o));       \
  TIME("product_CoAdc", f, #precision, "fused", ksl_product_CoAdc##f##_fused(&D, &c, &o)); \
  TIME("product_CoAdc", f, #precision, "accurate", ksl_product_CoAdc##f##_accurate(&D, &c, &o)); \
  TIME("product_CoAdc", f, #precision, "certified",                                      \
      ksl_product_CoAdc##f##_certified(&D, &c, &o, &b); BOUNDS)
#define CROSS(real, f, precision)                                                        \
  TIME("cross_sc", f, #precision, "plain", ksl_cross_sc##f(&s, &c, &o));                 \
  TIME("cross_sc", f, #precision, "fused", ksl_cross_sc##f##_fused(&s, &c, &o));         \
  TIME("cross_sc", f, #precision, "accurate", ksl_cross_sc##f##_accurate(&s, &c, &o)); \
  TIME("cross_sc", f, #precision, "certified", ksl_cross_sc##f##_certified(&s, &c, &o, &b); BOUNDS)
#define POWER(real, f, precision)                                                        \
  TIME("dot_cs", f, #precision, "plain", o.m0 = ksl_dot_cs##f(&c, &s));                  \
  TIME("dot_cs", f, #precision, "fused", o.m0 = ksl_dot_cs##f##_fused(&c, &s));          \
  TIME("dot_cs", f, #precision, "accurate", o.m0 = ksl_dot_cs##f##_accurate(&c, &s)); \
  TIME("dot_cs", f, #precision, "certified",                                             \
      o.m0 = ksl_dot_cs##f##_certified(&c, &s, &b.m0); BOUNDS)

ALL(double, , double)
ALL(float, f, single)

int main(void) {
  time_double();
  time_single();
  return 0;
}
