/* Times header kernels in a loop over arrays of structs against out-of-line calls; prints
   operation,precision,variant,minimum,median in ns per call. */
#include "out_of_line.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { COUNT = 256, ROUNDS = 4000 };

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

#define TIME(operation, precision, variant, statement)                             \
  do {                                                                             \
    for (int round = 0; round < ROUNDS; round++) {                                 \
      const long long start = now_ns();                                            \
      for (int i = 0; i < COUNT; i++) {                                            \
        statement;                                                                 \
      }                                                                            \
      __asm__ volatile("" ::"r"(o), "r"(c) : "memory");                            \
      samples[round] = (double)(now_ns() - start) / COUNT;                         \
    }                                                                              \
    qsort(samples, ROUNDS, sizeof samples[0], ascending);                          \
    printf("%s,%s,%s,%.4f,%.4f\n", operation, precision, variant, samples[0],      \
        samples[ROUNDS / 2]);                                                      \
  } while (0)

#define THREE_WAYS(operation, precision, name, f, ...)              \
  TIME(operation, precision, "header", ksl_##name##f(__VA_ARGS__)); \
  TIME(operation, precision, "one call", CALL(one_, name, f)(__VA_ARGS__)); \
  TIME(operation, precision, "composed calls", CALL(composed_, name, f)(__VA_ARGS__))

#define ksl_CoAdc ksl_product_CoAdc
#define ksl_CoAdcf ksl_product_CoAdcf
#define ksl_CoAdinvc ksl_product_CoAdinvc
#define ksl_CoAdinvcf ksl_product_CoAdinvcf
#define CALL(kind, name, f) kind##name##f

#define ALL_OPERATIONS(real, f, precision)                                                     \
  static void time_##precision(void) {                                                         \
    static ksl_SE3##f##_t D[COUNT];                                                            \
    static ksl_screw##f##_t s[COUNT];                                                          \
    static ksl_coscrew##f##_t c[COUNT], o[COUNT];                                              \
    for (int i = 0; i < COUNT; i++) {                                                          \
      for (int k = 0; k < 12; k++) {                                                           \
        D[i].as_array[k] = (real)(rand() % 2001 - 1000) / (real)1000;                          \
      }                                                                                        \
      for (int k = 0; k < 6; k++) {                                                            \
        s[i].at[k] = (real)(rand() % 2001 - 1000) / (real)100;                                 \
        c[i].at[k] = (real)(rand() % 2001 - 1000) / (real)10;                                  \
      }                                                                                        \
    }                                                                                          \
    const ksl_SE3##f##_t fixed = D[0];                                                         \
    THREE_WAYS("product_CoAdc, one D", #precision, CoAdc, f, &fixed, c + i, o + i);            \
    THREE_WAYS("product_CoAdc, D each", #precision, CoAdc, f, D + i, c + i, o + i);            \
    THREE_WAYS("product_CoAdinvc, one D", #precision, CoAdinvc, f, &fixed, c + i, o + i);      \
    THREE_WAYS("cross_sc", #precision, cross_sc, f, s + i, c + i, o + i);                      \
    THREE_WAYS("axpy_cc", #precision, axpy_cc, f, (real)1.25e-3, c + i, o + i);                \
  }

ALL_OPERATIONS(double, , double)
ALL_OPERATIONS(float, f, single)

int main(void) {
  time_double();
  time_single();
  return 0;
}
