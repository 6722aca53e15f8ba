/* Loops over arrays of structs: header kernels, and out-of-line calls of the same. */
#include "out_of_line.h"

#define LOOP(way, name, f, pointers, ...)                                                 \
  __attribute__((visibility("default"))) void loop_##way##_##name##f(long n, void *const *p);\
  void loop_##way##_##name##f(long n, void *const *p) {                                   \
    pointers                                                                              \
    for (long i = 0; i < n; i++) {                                                        \
      __VA_ARGS__;                                                                        \
    }                                                                                     \
  }

/* `function` with the same arguments in the header, as one call, and composed of calls. */
#define THREE_WAYS(name, function, f, pointers, ...)                             \
  LOOP(header, name, f, pointers, ksl_##function##f(__VA_ARGS__))                \
  LOOP(one, name, f, pointers, CALL(one_, function, f)(__VA_ARGS__))             \
  LOOP(composed, name, f, pointers, CALL(composed_, function, f)(__VA_ARGS__))

#define ksl_CoAdc ksl_product_CoAdc
#define ksl_CoAdcf ksl_product_CoAdcf
#define ksl_CoAdinvc ksl_product_CoAdinvc
#define ksl_CoAdinvcf ksl_product_CoAdinvcf
#define CALL(kind, name, f) kind##name##f

/* p: displacements, screws, coscrews, results. */
#define DISPLACED(f)                       \
  const ksl_SE3##f##_t *const D = p[0];    \
  const ksl_coscrew##f##_t *const c = p[2]; \
  ksl_coscrew##f##_t *const o = p[3];
#define CROSSED(f)                         \
  const ksl_screw##f##_t *const s = p[1];  \
  const ksl_coscrew##f##_t *const c = p[2]; \
  ksl_coscrew##f##_t *const o = p[3];
#define ADDED(f)                           \
  const ksl_coscrew##f##_t *const c = p[2]; \
  ksl_coscrew##f##_t *const o = p[3];

#define ALL_OPERATIONS(real, f)                                             \
  THREE_WAYS(CoAdc_one_D, CoAdc, f, DISPLACED(f), D, c + i, o + i)          \
  THREE_WAYS(CoAdc_D_each, CoAdc, f, DISPLACED(f), D + i, c + i, o + i)     \
  THREE_WAYS(CoAdinvc_one_D, CoAdinvc, f, DISPLACED(f), D, c + i, o + i)    \
  THREE_WAYS(cross_sc, cross_sc, f, CROSSED(f), s + i, c + i, o + i)        \
  THREE_WAYS(axpy_cc, axpy_cc, f, ADDED(f), (real)1.25e-3, c + i, o + i)

ALL_OPERATIONS(double, )
ALL_OPERATIONS(float, f)
