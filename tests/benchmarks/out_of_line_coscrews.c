/* The coscrew part of the baseline library: one call each, and composed of vector calls. */
#include "out_of_line.h"

#define COSCREWS(real, f)                                                                         \
  void one_CoAdc##f(const ksl_SE3##f##_t *D, const ksl_coscrew##f##_t *c,                         \
      ksl_coscrew##f##_t *o) {                                                                    \
    ksl_product_CoAdc##f(D, c, o);                                                                \
  }                                                                                               \
  void one_CoAdinvc##f(const ksl_SE3##f##_t *D, const ksl_coscrew##f##_t *c,                      \
      ksl_coscrew##f##_t *o) {                                                                    \
    ksl_product_CoAdinvc##f(D, c, o);                                                             \
  }                                                                                               \
  void one_cross_sc##f(const ksl_screw##f##_t *s, const ksl_coscrew##f##_t *c,                    \
      ksl_coscrew##f##_t *o) {                                                                    \
    ksl_cross_sc##f(s, c, o);                                                                     \
  }                                                                                               \
  void one_axpy_cc##f(real a, const ksl_coscrew##f##_t *x, ksl_coscrew##f##_t *y) {               \
    ksl_axpy_cc##f(a, x, y);                                                                      \
  }                                                                                               \
  void composed_CoAdc##f(const ksl_SE3##f##_t *D, const ksl_coscrew##f##_t *c,                    \
      ksl_coscrew##f##_t *o) {                                                                    \
    ksl_vec3##f##_t moment;                                                                       \
    vector_drv##f(&D->R, &c->lin, &o->lin);                                                       \
    vector_drv##f(&D->R, &c->ang, &o->ang);                                                       \
    vector_cross##f(&D->t, &o->lin, &moment);                                                     \
    vector_xpy##f(&moment, &o->ang);                                                              \
  }                                                                                               \
  void composed_CoAdinvc##f(const ksl_SE3##f##_t *D, const ksl_coscrew##f##_t *c,                 \
      ksl_coscrew##f##_t *o) {                                                                    \
    ksl_vec3##f##_t moment, rest = c->ang;                                                        \
    vector_cross##f(&D->t, &c->lin, &moment);                                                     \
    vector_nxpy##f(&moment, &rest);                                                               \
    vector_drinvv##f(&D->R, &c->lin, &o->lin);                                                    \
    vector_drinvv##f(&D->R, &rest, &o->ang);                                                      \
  }                                                                                               \
  void composed_cross_sc##f(const ksl_screw##f##_t *s, const ksl_coscrew##f##_t *c,               \
      ksl_coscrew##f##_t *o) {                                                                    \
    ksl_vec3##f##_t moment;                                                                       \
    vector_cross##f(&s->lin, &c->lin, &moment);                                                   \
    vector_cross##f(&s->ang, &c->lin, &o->lin);                                                   \
    vector_cross##f(&s->ang, &c->ang, &o->ang);                                                   \
    vector_xpy##f(&moment, &o->ang);                                                              \
  }                                                                                               \
  void composed_axpy_cc##f(real a, const ksl_coscrew##f##_t *x, ksl_coscrew##f##_t *y) {          \
    vector_axpy##f(a, &x->lin, &y->lin);                                                          \
    vector_axpy##f(a, &x->ang, &y->ang);                                                          \
  }

COSCREWS(double, )
COSCREWS(float, f)
