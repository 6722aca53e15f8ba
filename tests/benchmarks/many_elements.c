/* Loops over out-of-line calls and over functions of many elements: arrays of structs, planes, and
   planes by hand on vector types, a line of cache apart.  p: displacements, screws, coscrews,
   results. */
#include "out_of_line.h"
#include <ksl/ksl_many.h>

#if defined(__AVX512F__)
enum { BYTES = 64 };
#elif defined(__AVX__)
enum { BYTES = 32 };
#else
enum { BYTES = 16 };
#endif

#define LOOP(way, name, f) \
  __attribute__((visibility("default"))) void loop_##way##_##name##f(long n, void *const *p); \
  void loop_##way##_##name##f(long n, void *const *p)

#define CALLED(name, f, call) LOOP(called, name, f) { for (long i = 0; i < n; ++i) call; }

#define VECTORS(real, f)                                                     \
  typedef real vector##f __attribute__((vector_size(BYTES)));                \
  typedef real loose##f                                                      \
      __attribute__((vector_size(BYTES), aligned(sizeof(real)), may_alias)); \
  enum { LANES##f = BYTES / sizeof(real), LINE##f = 64 / sizeof(real) };

/* Component j of LANES elements; of one element, shared by all. */
#define READ(f, x, j) (*(const loose##f *)((x) + (j) * plane + i))
#define WRITE(f, x, j, value) (*(loose##f *)((x) + (j) * plane + i) = (value))
#define DISPLACED(f, D)                                           \
  const vector##f f0 = READ(f, c, 0), f1 = READ(f, c, 1),         \
      f2 = READ(f, c, 2), m0 = READ(f, c, 3), m1 = READ(f, c, 4), \
      m2 = READ(f, c, 5), g0 = D(0) * f0 + D(3) * f1 + D(6) * f2, \
      g1 = D(1) * f0 + D(4) * f1 + D(7) * f2,                     \
      g2 = D(2) * f0 + D(5) * f1 + D(8) * f2;                     \
  WRITE(f, o, 0, g0);                                             \
  WRITE(f, o, 1, g1);                                             \
  WRITE(f, o, 2, g2);                                             \
  WRITE(f, o, 3, D(0) * m0 + D(3) * m1 + D(6) * m2 + (D(10) * g2 - D(11) * g1)); \
  WRITE(f, o, 4, D(1) * m0 + D(4) * m1 + D(7) * m2 + (D(11) * g0 - D(9) * g2));  \
  WRITE(f, o, 5, D(2) * m0 + D(5) * m1 + D(8) * m2 + (D(9) * g1 - D(10) * g0));
#define CROSS(a, b, j, k) (a[j] * b[k] - a[k] * b[j])
#define ONE_D(j) D[j]
#define D_EACH(j) D[j]

#define OPERATIONS(real, f)                                                                      \
  VECTORS(real, f)                                                                               \
  CALLED(CoAdc_one_D, f, composed_CoAdc##f((const ksl_SE3##f##_t *)p[0],                         \
      (const ksl_coscrew##f##_t *)p[2] + i, (ksl_coscrew##f##_t *)p[3] + i))                     \
  CALLED(CoAdc_D_each, f, composed_CoAdc##f((const ksl_SE3##f##_t *)p[0] + i,                    \
      (const ksl_coscrew##f##_t *)p[2] + i, (ksl_coscrew##f##_t *)p[3] + i))                     \
  CALLED(cross_sc, f, composed_cross_sc##f((const ksl_screw##f##_t *)p[1] + i,                   \
      (const ksl_coscrew##f##_t *)p[2] + i, (ksl_coscrew##f##_t *)p[3] + i))                     \
  CALLED(axpy_cc, f, composed_axpy_cc##f((real)1.25e-3, (const ksl_coscrew##f##_t *)p[2] + i,    \
      (ksl_coscrew##f##_t *)p[3] + i))                                                           \
  LOOP(rows, CoAdc_one_D, f) { ksl_product_CoAdc##f##_many(n, p[0], 0, p[2], 1, p[3], 1); }      \
  LOOP(rows, CoAdc_D_each, f) { ksl_product_CoAdc##f##_many(n, p[0], 1, p[2], 1, p[3], 1); }     \
  LOOP(rows, cross_sc, f) { ksl_cross_sc##f##_many(n, p[1], 1, p[2], 1, p[3], 1); }              \
  LOOP(rows, axpy_cc, f) {                                                                       \
    const real a = (real)1.25e-3;                                                                \
    ksl_axpy_cc##f##_many(n, &a, 0, p[2], 1, p[3], 1);                                           \
  }                                                                                              \
  LOOP(planes, CoAdc_one_D, f) {                                                                 \
    ksl_product_CoAdc##f##_planes(n, p[0], 1, 0, p[2], n + LINE##f, 1, p[3], n + LINE##f, 1);            \
  }                                                                                              \
  LOOP(planes, CoAdc_D_each, f) {                                                                \
    ksl_product_CoAdc##f##_planes(n, p[0], n + LINE##f, 1, p[2], n + LINE##f, 1, p[3], n + LINE##f, 1);      \
  }                                                                                              \
  LOOP(planes, cross_sc, f) {                                                                    \
    ksl_cross_sc##f##_planes(n, p[1], n + LINE##f, 1, p[2], n + LINE##f, 1, p[3], n + LINE##f, 1);           \
  }                                                                                              \
  LOOP(planes, axpy_cc, f) {                                                                     \
    const real a = (real)1.25e-3;                                                                \
    ksl_axpy_cc##f##_planes(n, &a, 0, p[2], n + LINE##f, 1, p[3], n + LINE##f, 1);                       \
  }                                                                                              \
  LOOP(hand, CoAdc_one_D, f) {                                                                   \
    const real *const given = p[0], *const c = p[2];                                             \
    real *const o = p[3];                                                                        \
    const long plane = n + LINE##f;                                                                  \
    const vector##f zero = {0};                                                                  \
    vector##f D[12];                                                                             \
    for (int j = 0; j < 12; ++j) D[j] = given[j] - zero;                                         \
    for (long i = 0; i < n; i += LANES##f) { DISPLACED(f, ONE_D) }                               \
  }                                                                                              \
  LOOP(hand, CoAdc_D_each, f) {                                                                  \
    const real *const given = p[0], *const c = p[2];                                             \
    real *const o = p[3];                                                                        \
    const long plane = n + LINE##f;                                                                  \
    for (long i = 0; i < n; i += LANES##f) {                                                     \
      vector##f D[12];                                                                           \
      for (int j = 0; j < 12; ++j) D[j] = READ(f, given, j);                                     \
      DISPLACED(f, D_EACH)                                                                       \
    }                                                                                            \
  }                                                                                              \
  LOOP(hand, cross_sc, f) {                                                                      \
    const real *const given = p[1], *const c = p[2];                                             \
    real *const o = p[3];                                                                        \
    const long plane = n + LINE##f;                                                                  \
    for (long i = 0; i < n; i += LANES##f) {                                                     \
      vector##f s[6], x[6];                                                                      \
      for (int j = 0; j < 6; ++j) { s[j] = READ(f, given, j); x[j] = READ(f, c, j); }            \
      const vector##f *const v = s, *const w = s + 3, *const force = x, *const moment = x + 3;   \
      for (int j = 0; j < 3; ++j) {                                                              \
        const int k = (j + 1) % 3, l = (j + 2) % 3;                                              \
        WRITE(f, o, j, CROSS(w, force, k, l));                                                   \
        WRITE(f, o, j + 3, CROSS(v, force, k, l) + CROSS(w, moment, k, l));                      \
      }                                                                                          \
    }                                                                                            \
  }                                                                                              \
  LOOP(hand, axpy_cc, f) {                                                                       \
    const real *const c = p[2];                                                                  \
    real *const o = p[3];                                                                        \
    const long plane = n + LINE##f;                                                                  \
    for (long i = 0; i < n; i += LANES##f)                                                       \
      for (int j = 0; j < 6; ++j)                                                                \
        WRITE(f, o, j, READ(f, o, j) + (real)1.25e-3 * READ(f, c, j));                           \
  }

OPERATIONS(double, )
OPERATIONS(float, f)
