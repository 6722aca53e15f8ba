/* The baseline of the header benchmark: the same arithmetic as a library with calls. */
#ifndef OUT_OF_LINE_H
#define OUT_OF_LINE_H

#include <ksl/ksl.h>

/* PROTOTYPES(real, f): the library in one precision.  `one_…` is a single call; `composed_…` is built
   from calls, as a library of small functions is. */
#define PROTOTYPES(real, f)                                                                       \
  void vector_drv##f(const ksl_mat3x3##f##_t *, const ksl_vec3##f##_t *, ksl_vec3##f##_t *);      \
  void vector_drinvv##f(const ksl_mat3x3##f##_t *, const ksl_vec3##f##_t *, ksl_vec3##f##_t *);   \
  void vector_cross##f(const ksl_vec3##f##_t *, const ksl_vec3##f##_t *, ksl_vec3##f##_t *);      \
  void vector_xpy##f(const ksl_vec3##f##_t *, ksl_vec3##f##_t *);                                 \
  void vector_nxpy##f(const ksl_vec3##f##_t *, ksl_vec3##f##_t *);                                \
  void vector_axpy##f(real, const ksl_vec3##f##_t *, ksl_vec3##f##_t *);                          \
  void one_CoAdc##f(const ksl_SE3##f##_t *, const ksl_coscrew##f##_t *, ksl_coscrew##f##_t *);    \
  void one_CoAdinvc##f(const ksl_SE3##f##_t *, const ksl_coscrew##f##_t *, ksl_coscrew##f##_t *); \
  void one_cross_sc##f(const ksl_screw##f##_t *, const ksl_coscrew##f##_t *,                      \
      ksl_coscrew##f##_t *);                                                                      \
  void one_axpy_cc##f(real, const ksl_coscrew##f##_t *, ksl_coscrew##f##_t *);                    \
  void composed_CoAdc##f(const ksl_SE3##f##_t *, const ksl_coscrew##f##_t *,                      \
      ksl_coscrew##f##_t *);                                                                      \
  void composed_CoAdinvc##f(const ksl_SE3##f##_t *, const ksl_coscrew##f##_t *,                   \
      ksl_coscrew##f##_t *);                                                                      \
  void composed_cross_sc##f(const ksl_screw##f##_t *, const ksl_coscrew##f##_t *,                 \
      ksl_coscrew##f##_t *);                                                                      \
  void composed_axpy_cc##f(real, const ksl_coscrew##f##_t *, ksl_coscrew##f##_t *);

PROTOTYPES(double, )
PROTOTYPES(float, f)

#endif
