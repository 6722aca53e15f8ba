/* The vector part of the baseline library. */
#include "out_of_line.h"

#define VECTORS(real, f)                                                                          \
  void vector_drv##f(const ksl_mat3x3##f##_t *R, const ksl_vec3##f##_t *v, ksl_vec3##f##_t *o) {  \
    ksl_product_drv##f(R, v, o);                                                                  \
  }                                                                                               \
  void vector_drinvv##f(const ksl_mat3x3##f##_t *R, const ksl_vec3##f##_t *v,                     \
      ksl_vec3##f##_t *o) {                                                                       \
    ksl_product_drinvv##f(R, v, o);                                                               \
  }                                                                                               \
  void vector_cross##f(const ksl_vec3##f##_t *a, const ksl_vec3##f##_t *b, ksl_vec3##f##_t *o) {  \
    ksl_cross_vv##f(a, b, o);                                                                     \
  }                                                                                               \
  void vector_xpy##f(const ksl_vec3##f##_t *x, ksl_vec3##f##_t *y) { ksl_xpy_vv##f(x, y); }       \
  void vector_nxpy##f(const ksl_vec3##f##_t *x, ksl_vec3##f##_t *y) { ksl_nxpy_vv##f(x, y); }     \
  void vector_axpy##f(real a, const ksl_vec3##f##_t *x, ksl_vec3##f##_t *y) {                     \
    ksl_axpy_vv##f(a, x, y);                                                                      \
  }

VECTORS(double, )
VECTORS(float, f)
