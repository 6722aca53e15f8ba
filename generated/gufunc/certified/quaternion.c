/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the quaternion operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/quaternion_certified.h"
#include <fenv.h>

/* (4),()->(4),(4) */
OVER(quaternion_scale_double) {
  POINTERS_4
  EACH {
    ksl_quaternion_t self;
    double a;
    ksl_quaternion_t self_bound;
    LOAD(quaternion_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_quaternion_scale_certified(&self, a, &self_bound);
    STORE(quaternion_double, &self, 2, 1);
    STORE(quaternion_double, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_scale_double)
LOOP(quaternion_scale_double, 4, DENSE, 32, 8, 32, 32, 8, 8, 8)

OVER(quaternion_scale_single) {
  POINTERS_4
  EACH {
    ksl_quaternionf_t self;
    float a;
    ksl_quaternionf_t self_bound;
    LOAD(quaternion_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_quaternionf_scale_certified(&self, a, &self_bound);
    STORE(quaternion_single, &self, 2, 1);
    STORE(quaternion_single, &self_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_scale_single)
LOOP(quaternion_scale_single, 4, DENSE, 16, 4, 16, 16, 4, 4, 4)
LOOPS(quaternion_scale)

/* (),(4),(4)->(4),(4) */
OVER(axpy_qq_double) {
  POINTERS_5
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_quaternion_t x;
    ksl_quaternion_t y;
    ksl_quaternion_t y_bound;
    LOAD_OTHER(scalar_double, &a);
    LOAD(quaternion_double, &x, 1, 0);
    LOAD(quaternion_double, &y, 2, 1);
    ksl_axpy_qq_certified(a, &x, &y, &y_bound);
    STORE(quaternion_double, &y, 3, 2);
    STORE(quaternion_double, &y_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(axpy_qq_double)
LOOP(axpy_qq_double, 5, DENSE_OR_ONE, 8, 32, 32, 32, 32, 8, 8, 8, 8)

OVER(axpy_qq_single) {
  POINTERS_5
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_quaternionf_t x;
    ksl_quaternionf_t y;
    ksl_quaternionf_t y_bound;
    LOAD_OTHER(scalar_single, &a);
    LOAD(quaternion_single, &x, 1, 0);
    LOAD(quaternion_single, &y, 2, 1);
    ksl_axpy_qqf_certified(a, &x, &y, &y_bound);
    STORE(quaternion_single, &y, 3, 2);
    STORE(quaternion_single, &y_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(axpy_qq_single)
LOOP(axpy_qq_single, 5, DENSE_OR_ONE, 4, 16, 16, 16, 16, 4, 4, 4, 4)
LOOPS(axpy_qq)

/* (4),(3)->(3),(3) */
OVER(rotate_qv_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q, &q);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(quaternion_double, &q);
    LOAD(vec3_double, &v, 1, 1);
    ksl_rotate_qv_certified(&q, &v, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(rotate_qv_double)
LOOP(rotate_qv_double, 4, DENSE_OR_ONE, 32, 24, 24, 24, 8, 8, 8, 8)

OVER(rotate_qv_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q, &q);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(quaternion_single, &q);
    LOAD(vec3_single, &v, 1, 1);
    ksl_rotate_qvf_certified(&q, &v, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(rotate_qv_single)
LOOP(rotate_qv_single, 4, DENSE_OR_ONE, 16, 12, 12, 12, 4, 4, 4, 4)
LOOPS(rotate_qv)

/* (4),(3)->(3),(3) */
OVER(rotate_qconjv_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q, &q);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD_OTHER(quaternion_double, &q);
    LOAD(vec3_double, &v, 1, 1);
    ksl_rotate_qconjv_certified(&q, &v, &vo, &vo_bound);
    STORE(vec3_double, &vo, 2, 2);
    STORE(vec3_double, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(rotate_qconjv_double)
LOOP(rotate_qconjv_double, 4, DENSE_OR_ONE, 32, 24, 24, 24, 8, 8, 8, 8)

OVER(rotate_qconjv_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q, &q);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD_OTHER(quaternion_single, &q);
    LOAD(vec3_single, &v, 1, 1);
    ksl_rotate_qconjvf_certified(&q, &v, &vo, &vo_bound);
    STORE(vec3_single, &vo, 2, 2);
    STORE(vec3_single, &vo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(rotate_qconjv_single)
LOOP(rotate_qconjv_single, 4, DENSE_OR_ONE, 16, 12, 12, 12, 4, 4, 4, 4)
LOOPS(rotate_qconjv)

/* (4),(4)->(4),(4) */
OVER(quaternion_product_qq_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    ksl_quaternion_product_qq_certified(&q1i, &q2i, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qq_double)
LOOP(quaternion_product_qq_double, 4, DENSE_OR_ONE, 32, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qq_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    ksl_product_qqf_certified(&q1i, &q2i, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qq_single)
LOOP(quaternion_product_qq_single, 4, DENSE_OR_ONE, 16, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qq)

/* (4),(4)->(4),(4) */
OVER(quaternion_product_qqconj_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    ksl_quaternion_product_qqconj_certified(&q1i, &q2i, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqconj_double)
LOOP(quaternion_product_qqconj_double, 4, DENSE_OR_ONE, 32, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qqconj_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    ksl_product_qqconjf_certified(&q1i, &q2i, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqconj_single)
LOOP(quaternion_product_qqconj_single, 4, DENSE_OR_ONE, 16, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qqconj)

/* (4),(4)->(4),(4) */
OVER(quaternion_product_qconjq_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    ksl_quaternion_product_qconjq_certified(&q1i, &q2i, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjq_double)
LOOP(quaternion_product_qconjq_double, 4, DENSE_OR_ONE, 32, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qconjq_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    ksl_product_qconjqf_certified(&q1i, &q2i, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjq_single)
LOOP(quaternion_product_qconjq_single, 4, DENSE_OR_ONE, 16, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qconjq)

/* (4),(4)->(4),(4) */
OVER(quaternion_product_qconjqconj_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    ksl_quaternion_product_qconjqconj_certified(&q1i, &q2i, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqconj_double)
LOOP(quaternion_product_qconjqconj_double, 4, DENSE_OR_ONE, 32, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qconjqconj_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    ksl_product_qconjqconjf_certified(&q1i, &q2i, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqconj_single)
LOOP(quaternion_product_qconjqconj_single, 4, DENSE_OR_ONE, 16, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qconjqconj)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qxq_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qxq_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qxq_double)
LOOP(quaternion_product_qxq_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qxq_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qxqf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qxq_single)
LOOP(quaternion_product_qxq_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qxq)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qxqconj_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qxqconj_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qxqconj_double)
LOOP(quaternion_product_qxqconj_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qxqconj_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qxqconjf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qxqconj_single)
LOOP(quaternion_product_qxqconj_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qxqconj)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qxconjq_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qxconjq_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qxconjq_double)
LOOP(quaternion_product_qxconjq_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qxconjq_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qxconjqf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qxconjq_single)
LOOP(quaternion_product_qxconjq_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qxconjq)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qxconjqconj_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qxconjqconj_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qxconjqconj_double)
LOOP(quaternion_product_qxconjqconj_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qxconjqconj_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qxconjqconjf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qxconjqconj_single)
LOOP(quaternion_product_qxconjqconj_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qxconjqconj)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qqx_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqx_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqx_double)
LOOP(quaternion_product_qqx_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qqx_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqxf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqx_single)
LOOP(quaternion_product_qqx_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qqx)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qqxconj_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqxconj_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqxconj_double)
LOOP(quaternion_product_qqxconj_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qqxconj_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqxconjf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqxconj_single)
LOOP(quaternion_product_qqxconj_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qqxconj)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qconjqx_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqx_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqx_double)
LOOP(quaternion_product_qconjqx_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qconjqx_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqxf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqx_single)
LOOP(quaternion_product_qconjqx_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qconjqx)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qconjqxconj_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqxconj_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqxconj_double)
LOOP(quaternion_product_qconjqxconj_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qconjqxconj_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqxconjf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqxconj_single)
LOOP(quaternion_product_qconjqxconj_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qconjqxconj)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qyq_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qyq_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qyq_double)
LOOP(quaternion_product_qyq_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qyq_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qyqf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qyq_single)
LOOP(quaternion_product_qyq_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qyq)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qyqconj_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qyqconj_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qyqconj_double)
LOOP(quaternion_product_qyqconj_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qyqconj_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qyqconjf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qyqconj_single)
LOOP(quaternion_product_qyqconj_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qyqconj)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qyconjq_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qyconjq_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qyconjq_double)
LOOP(quaternion_product_qyconjq_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qyconjq_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qyconjqf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qyconjq_single)
LOOP(quaternion_product_qyconjq_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qyconjq)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qyconjqconj_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qyconjqconj_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qyconjqconj_double)
LOOP(quaternion_product_qyconjqconj_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qyconjqconj_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qyconjqconjf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qyconjqconj_single)
LOOP(quaternion_product_qyconjqconj_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qyconjqconj)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qqy_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqy_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqy_double)
LOOP(quaternion_product_qqy_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qqy_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqyf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqy_single)
LOOP(quaternion_product_qqy_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qqy)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qqyconj_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqyconj_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqyconj_double)
LOOP(quaternion_product_qqyconj_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qqyconj_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqyconjf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqyconj_single)
LOOP(quaternion_product_qqyconj_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qqyconj)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qconjqy_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqy_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqy_double)
LOOP(quaternion_product_qconjqy_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qconjqy_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqyf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqy_single)
LOOP(quaternion_product_qconjqy_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qconjqy)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qconjqyconj_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqyconj_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqyconj_double)
LOOP(quaternion_product_qconjqyconj_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qconjqyconj_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqyconjf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqyconj_single)
LOOP(quaternion_product_qconjqyconj_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qconjqyconj)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qzq_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qzq_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qzq_double)
LOOP(quaternion_product_qzq_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qzq_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qzqf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qzq_single)
LOOP(quaternion_product_qzq_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qzq)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qzqconj_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qzqconj_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qzqconj_double)
LOOP(quaternion_product_qzqconj_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qzqconj_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qzqconjf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qzqconj_single)
LOOP(quaternion_product_qzqconj_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qzqconj)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qzconjq_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qzconjq_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qzconjq_double)
LOOP(quaternion_product_qzconjq_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qzconjq_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qzconjqf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qzconjq_single)
LOOP(quaternion_product_qzconjq_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qzconjq)

/* (2),(4)->(4),(4) */
OVER(quaternion_product_qzconjqconj_double) {
  POINTERS_4
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qzconjqconj_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qzconjqconj_double)
LOOP(quaternion_product_qzconjqconj_double, 4, DENSE_OR_ONE, 16, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qzconjqconj_single) {
  POINTERS_4
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qzconjqconjf_certified(dci, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qzconjqconj_single)
LOOP(quaternion_product_qzconjqconj_single, 4, DENSE_OR_ONE, 8, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qzconjqconj)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qqz_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqz_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqz_double)
LOOP(quaternion_product_qqz_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qqz_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqzf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqz_single)
LOOP(quaternion_product_qqz_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qqz)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qqzconj_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqzconj_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqzconj_double)
LOOP(quaternion_product_qqzconj_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qqzconj_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqzconjf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qqzconj_single)
LOOP(quaternion_product_qqzconj_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qqzconj)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qconjqz_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqz_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqz_double)
LOOP(quaternion_product_qconjqz_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qconjqz_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqzf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqz_single)
LOOP(quaternion_product_qconjqz_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qconjqz)

/* (4),(2)->(4),(4) */
OVER(quaternion_product_qconjqzconj_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqzconj_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqzconj_double)
LOOP(quaternion_product_qconjqzconj_double, 4, DENSE_OR_ONE, 32, 16, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qconjqzconj_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqzconjf_certified(&qi, dci, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjqzconj_single)
LOOP(quaternion_product_qconjqzconj_single, 4, DENSE_OR_ONE, 16, 8, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qconjqzconj)

/* (4),(3)->(4),(4) */
OVER(quaternion_product_qv_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    ksl_vec3_t vi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(vec3_double, &vi, 1, 1);
    ksl_quaternion_product_qv_certified(&qi, &vi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qv_double)
LOOP(quaternion_product_qv_double, 4, DENSE_OR_ONE, 32, 24, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qv_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    ksl_vec3f_t vi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(vec3_single, &vi, 1, 1);
    ksl_product_qvf_certified(&qi, &vi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qv_single)
LOOP(quaternion_product_qv_single, 4, DENSE_OR_ONE, 16, 12, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qv)

/* (4),(3)->(4),(4) */
OVER(quaternion_product_qconjv_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    ksl_vec3_t vi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(vec3_double, &vi, 1, 1);
    ksl_quaternion_product_qconjv_certified(&qi, &vi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjv_double)
LOOP(quaternion_product_qconjv_double, 4, DENSE_OR_ONE, 32, 24, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_qconjv_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    ksl_vec3f_t vi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(vec3_single, &vi, 1, 1);
    ksl_product_qconjvf_certified(&qi, &vi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_qconjv_single)
LOOP(quaternion_product_qconjv_single, 4, DENSE_OR_ONE, 16, 12, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_qconjv)

/* (3),(4)->(4),(4) */
OVER(quaternion_product_vq_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t vi, &vi);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(vec3_double, &vi);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_vq_certified(&vi, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_vq_double)
LOOP(quaternion_product_vq_double, 4, DENSE_OR_ONE, 24, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_vq_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t vi, &vi);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(vec3_single, &vi);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_vqf_certified(&vi, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_vq_single)
LOOP(quaternion_product_vq_single, 4, DENSE_OR_ONE, 12, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_vq)

/* (3),(4)->(4),(4) */
OVER(quaternion_product_vqconj_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t vi, &vi);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(vec3_double, &vi);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_vqconj_certified(&vi, &qi, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 2);
    STORE(quaternion_double, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_vqconj_double)
LOOP(quaternion_product_vqconj_double, 4, DENSE_OR_ONE, 24, 32, 32, 32, 8, 8, 8, 8)

OVER(quaternion_product_vqconj_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t vi, &vi);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(vec3_single, &vi);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_vqconjf_certified(&vi, &qi, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 2);
    STORE(quaternion_single, &qo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(quaternion_product_vqconj_single)
LOOP(quaternion_product_vqconj_single, 4, DENSE_OR_ONE, 12, 16, 16, 16, 4, 4, 4, 4)
LOOPS(quaternion_product_vqconj)

/* (4),(4)->(),() */
OVER(dot_qq_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    double dot;
    double dot_bound;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    dot = ksl_dot_qq_certified(&q1i, &q2i, &dot_bound);
    STORE(scalar_double, &dot, 2, 2);
    STORE(scalar_double, &dot_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(dot_qq_double)
LOOP(dot_qq_double, 4, DENSE_OR_ONE, 32, 32, 8, 8, 8, 8)

OVER(dot_qq_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    float dot;
    float dot_bound;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    dot = ksl_dot_qqf_certified(&q1i, &q2i, &dot_bound);
    STORE(scalar_single, &dot, 2, 2);
    STORE(scalar_single, &dot_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(dot_qq_single)
LOOP(dot_qq_single, 4, DENSE_OR_ONE, 16, 16, 4, 4, 4, 4)
LOOPS(dot_qq)

/* (3),(4)->(4),(4) */
OVER(add_dpiToq_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t dpi, &dpi);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qi_bound;
    LOAD_OTHER(vec3_double, &dpi);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_add_dpiToq_certified(&dpi, &qi, &qi_bound);
    STORE(quaternion_double, &qi, 2, 2);
    STORE(quaternion_double, &qi_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_dpiToq_double)
LOOP(add_dpiToq_double, 4, DENSE_OR_ONE, 24, 32, 32, 32, 8, 8, 8, 8)

OVER(add_dpiToq_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t dpi, &dpi);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qi_bound;
    LOAD_OTHER(vec3_single, &dpi);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_add_dpiToqf_certified(&dpi, &qi, &qi_bound);
    STORE(quaternion_single, &qi, 2, 2);
    STORE(quaternion_single, &qi_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(add_dpiToq_single)
LOOP(add_dpiToq_single, 4, DENSE_OR_ONE, 12, 16, 16, 16, 4, 4, 4, 4)
LOOPS(add_dpiToq)

/* (3),(4)->(4),(4) */
OVER(subtract_dpiFromq_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t dpi, &dpi);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qi_bound;
    LOAD_OTHER(vec3_double, &dpi);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_subtract_dpiFromq_certified(&dpi, &qi, &qi_bound);
    STORE(quaternion_double, &qi, 2, 2);
    STORE(quaternion_double, &qi_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_dpiFromq_double)
LOOP(subtract_dpiFromq_double, 4, DENSE_OR_ONE, 24, 32, 32, 32, 8, 8, 8, 8)

OVER(subtract_dpiFromq_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t dpi, &dpi);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qi_bound;
    LOAD_OTHER(vec3_single, &dpi);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_subtract_dpiFromqf_certified(&dpi, &qi, &qi_bound);
    STORE(quaternion_single, &qi, 2, 2);
    STORE(quaternion_single, &qi_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(subtract_dpiFromq_single)
LOOP(subtract_dpiFromq_single, 4, DENSE_OR_ONE, 12, 16, 16, 16, 4, 4, 4, 4)
LOOPS(subtract_dpiFromq)

/* (3),(4)->(4),(4) */
OVER(omega_to_dquaternion_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t w, &w);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t dqo;
    ksl_quaternion_t dqo_bound;
    LOAD_OTHER(vec3_double, &w);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_omega_to_dquaternion_certified(&w, &qi, &dqo, &dqo_bound);
    STORE(quaternion_double, &dqo, 2, 2);
    STORE(quaternion_double, &dqo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(omega_to_dquaternion_double)
LOOP(omega_to_dquaternion_double, 4, DENSE_OR_ONE, 24, 32, 32, 32, 8, 8, 8, 8)

OVER(omega_to_dquaternion_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t w, &w);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t dqo;
    ksl_quaternionf_t dqo_bound;
    LOAD_OTHER(vec3_single, &w);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_omega_to_dquaternionf_certified(&w, &qi, &dqo, &dqo_bound);
    STORE(quaternion_single, &dqo, 2, 2);
    STORE(quaternion_single, &dqo_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(omega_to_dquaternion_single)
LOOP(omega_to_dquaternion_single, 4, DENSE_OR_ONE, 12, 16, 16, 16, 4, 4, 4, 4)
LOOPS(omega_to_dquaternion)

/* (3),()->(4),(4) */
OVER(quaternion_from_axis_angle_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t axis, &axis);
  EACH {
    double angle;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD_OTHER(vec3_double, &axis);
    LOAD(scalar_double, &angle, 1, 1);
    ksl_quaternion_from_axis_angle_certified(&axis, angle, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 2, 1);
    STORE(quaternion_double, &qo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(quaternion_from_axis_angle_double)
LOOP(quaternion_from_axis_angle_double, 4, DENSE_OR_ONE, 24, 8, 32, 32, 8, 8, 8)

OVER(quaternion_from_axis_angle_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t axis, &axis);
  EACH {
    float angle;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD_OTHER(vec3_single, &axis);
    LOAD(scalar_single, &angle, 1, 1);
    ksl_quaternionf_from_axis_angle_certified(&axis, angle, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 2, 1);
    STORE(quaternion_single, &qo_bound, 3, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(quaternion_from_axis_angle_single)
LOOP(quaternion_from_axis_angle_single, 4, DENSE_OR_ONE, 12, 4, 16, 16, 4, 4, 4)
LOOPS(quaternion_from_axis_angle)

/* (4)->(),(3),(),(3) */
OVER(axis_angle_from_quaternion_double) {
  POINTERS_5
  EACH {
    ksl_quaternion_t q;
    double angle;
    ksl_vec3_t axis;
    double angle_bound;
    ksl_vec3_t axis_bound;
    LOAD(quaternion_double, &q, 0, 0);
    angle = ksl_axis_angle_from_quaternion_certified(&q, &axis, &angle_bound, &axis_bound);
    STORE(scalar_double, &angle, 1, 1);
    STORE(vec3_double, &axis, 2, 1);
    STORE(scalar_double, &angle_bound, 3, 2);
    STORE(vec3_double, &axis_bound, 4, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(axis_angle_from_quaternion_double)
LOOP(axis_angle_from_quaternion_double, 5, ANY, 32, 8, 24, 8, 24, 8, 8, 8)

OVER(axis_angle_from_quaternion_single) {
  POINTERS_5
  EACH {
    ksl_quaternionf_t q;
    float angle;
    ksl_vec3f_t axis;
    float angle_bound;
    ksl_vec3f_t axis_bound;
    LOAD(quaternion_single, &q, 0, 0);
    angle = ksl_axis_angle_from_quaternionf_certified(&q, &axis, &angle_bound, &axis_bound);
    STORE(scalar_single, &angle, 1, 1);
    STORE(vec3_single, &axis, 2, 1);
    STORE(scalar_single, &angle_bound, 3, 2);
    STORE(vec3_single, &axis_bound, 4, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(axis_angle_from_quaternion_single)
LOOP(axis_angle_from_quaternion_single, 5, ANY, 16, 4, 12, 4, 12, 4, 4, 4)
LOOPS(axis_angle_from_quaternion)

/* (3)->(4),(4) */
OVER(quaternion_exp_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t v;
    ksl_quaternion_t qo;
    ksl_quaternion_t qo_bound;
    LOAD(vec3_double, &v, 0, 0);
    ksl_quaternion_exp_certified(&v, &qo, &qo_bound);
    STORE(quaternion_double, &qo, 1, 1);
    STORE(quaternion_double, &qo_bound, 2, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(quaternion_exp_double)
LOOP(quaternion_exp_double, 3, ANY, 24, 32, 32, 8, 8, 8)

OVER(quaternion_exp_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t v;
    ksl_quaternionf_t qo;
    ksl_quaternionf_t qo_bound;
    LOAD(vec3_single, &v, 0, 0);
    ksl_quaternionf_exp_certified(&v, &qo, &qo_bound);
    STORE(quaternion_single, &qo, 1, 1);
    STORE(quaternion_single, &qo_bound, 2, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(quaternion_exp_single)
LOOP(quaternion_exp_single, 3, ANY, 12, 16, 16, 4, 4, 4)
LOOPS(quaternion_exp)

/* (4)->(3),(3) */
OVER(quaternion_log_double) {
  POINTERS_3
  EACH {
    ksl_quaternion_t q;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD(quaternion_double, &q, 0, 0);
    ksl_quaternion_log_certified(&q, &vo, &vo_bound);
    STORE(vec3_double, &vo, 1, 1);
    STORE(vec3_double, &vo_bound, 2, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(quaternion_log_double)
LOOP(quaternion_log_double, 3, ANY, 32, 24, 24, 8, 8, 8)

OVER(quaternion_log_single) {
  POINTERS_3
  EACH {
    ksl_quaternionf_t q;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD(quaternion_single, &q, 0, 0);
    ksl_quaternionf_log_certified(&q, &vo, &vo_bound);
    STORE(vec3_single, &vo, 1, 1);
    STORE(vec3_single, &vo_bound, 2, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(quaternion_log_single)
LOOP(quaternion_log_single, 3, ANY, 16, 12, 12, 4, 4, 4)
LOOPS(quaternion_log)

const coscrew_gufunc TABLE(quaternion)[] = {
  {"quaternion_scale", "(4),()->(4),(4)",
    "self = a self; |error of self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(4),()->(4),(4).  self, self_bound: quaternion (x, y, z, w), the scalar last; a: number.\n"
    "8 mul, 4 add, 4 abs.\n",
   2, 2, "", quaternion_scale_loops},
  {"axpy_qq", "(),(4),(4)->(4),(4)",
    "y = a x + y; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "(),(4),(4)->(4),(4).  a: number; x, y, y_bound: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 12 add, 8 abs.\n",
   3, 2, "", axpy_qq_loops},
  {"rotate_qv", "(4),(3)->(3),(3)",
    "vo = R(q) v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.\n"
    "33 mul, 33 add, 13 abs.\n",
   2, 2, "U.", rotate_qv_loops},
  {"rotate_qconjv", "(4),(3)->(3),(3)",
    "vo = R(q)^T v, |q| = 1; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; v, vo, vo_bound: vector.\n"
    "33 mul, 33 add, 13 abs.\n",
   2, 2, "U.", rotate_qconjv_loops},
  {"quaternion_product_qq", "(4),(4)->(4),(4)",
    "qo = q1i q2i; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, "", quaternion_product_qq_loops},
  {"quaternion_product_qqconj", "(4),(4)->(4),(4)",
    "qo = q1i q2i*; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, "", quaternion_product_qqconj_loops},
  {"quaternion_product_qconjq", "(4),(4)->(4),(4)",
    "qo = q1i* q2i; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, "", quaternion_product_qconjq_loops},
  {"quaternion_product_qconjqconj", "(4),(4)->(4),(4)",
    "qo = q1i* q2i*; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(4),(4).  q1i, q2i, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "20 mul, 28 add, 16 abs.\n",
   2, 2, "", quaternion_product_qconjqconj_loops},
  {"quaternion_product_qxq", "(2),(4)->(4),(4)",
    "qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qxq_loops},
  {"quaternion_product_qxqconj", "(2),(4)->(4),(4)",
    "qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qxqconj_loops},
  {"quaternion_product_qxconjq", "(2),(4)->(4),(4)",
    "qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qxconjq_loops},
  {"quaternion_product_qxconjqconj", "(2),(4)->(4),(4)",
    "qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qxconjqconj_loops},
  {"quaternion_product_qqx", "(4),(2)->(4),(4)",
    "qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqx_loops},
  {"quaternion_product_qqxconj", "(4),(2)->(4),(4)",
    "qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqxconj_loops},
  {"quaternion_product_qconjqx", "(4),(2)->(4),(4)",
    "qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqx_loops},
  {"quaternion_product_qconjqxconj", "(4),(2)->(4),(4)",
    "qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqxconj_loops},
  {"quaternion_product_qyq", "(2),(4)->(4),(4)",
    "qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qyq_loops},
  {"quaternion_product_qyqconj", "(2),(4)->(4),(4)",
    "qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qyqconj_loops},
  {"quaternion_product_qyconjq", "(2),(4)->(4),(4)",
    "qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qyconjq_loops},
  {"quaternion_product_qyconjqconj", "(2),(4)->(4),(4)",
    "qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qyconjqconj_loops},
  {"quaternion_product_qqy", "(4),(2)->(4),(4)",
    "qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqy_loops},
  {"quaternion_product_qqyconj", "(4),(2)->(4),(4)",
    "qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqyconj_loops},
  {"quaternion_product_qconjqy", "(4),(2)->(4),(4)",
    "qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqy_loops},
  {"quaternion_product_qconjqyconj", "(4),(2)->(4),(4)",
    "qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqyconj_loops},
  {"quaternion_product_qzq", "(2),(4)->(4),(4)",
    "qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qzq_loops},
  {"quaternion_product_qzqconj", "(2),(4)->(4),(4)",
    "qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qzqconj_loops},
  {"quaternion_product_qzconjq", "(2),(4)->(4),(4)",
    "qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qzconjq_loops},
  {"quaternion_product_qzconjqconj", "(2),(4)->(4),(4)",
    "qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(2),(4)->(4),(4).  dci: (sin θ, cos θ); qi, qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qzconjqconj_loops},
  {"quaternion_product_qqz", "(4),(2)->(4),(4)",
    "qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqz_loops},
  {"quaternion_product_qqzconj", "(4),(2)->(4),(4)",
    "qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 8 abs.\n",
   2, 2, "", quaternion_product_qqzconj_loops},
  {"quaternion_product_qconjqz", "(4),(2)->(4),(4)",
    "qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 1 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqz_loops},
  {"quaternion_product_qconjqzconj", "(4),(2)->(4),(4)",
    "qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle; |error of qo| <=\n"
    "qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(2)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; dci: (sin θ,\n"
    "cos θ).\n"
    "12 mul, 12 add, 2 neg, 8 abs.\n",
   2, 2, "", quaternion_product_qconjqzconj_loops},
  {"quaternion_product_qv", "(4),(3)->(4),(4)",
    "qo = qi (vi; 0); |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.\n"
    "16 mul, 20 add, 1 neg, 12 abs.\n",
   2, 2, "", quaternion_product_qv_loops},
  {"quaternion_product_qconjv", "(4),(3)->(4),(4)",
    "qo = qi* (vi; 0); |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(4),(3)->(4),(4).  qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last; vi: vector.\n"
    "16 mul, 20 add, 12 abs.\n",
   2, 2, "", quaternion_product_qconjv_loops},
  {"quaternion_product_vq", "(3),(4)->(4),(4)",
    "qo = (vi; 0) qi; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 20 add, 1 neg, 12 abs.\n",
   2, 2, "", quaternion_product_vq_loops},
  {"quaternion_product_vqconj", "(3),(4)->(4),(4)",
    "qo = (vi; 0) qi*; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  vi: vector; qi, qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 20 add, 12 abs.\n",
   2, 2, "", quaternion_product_vqconj_loops},
  {"dot_qq", "(4),(4)->(),()",
    "q1i·q2i; |error of dot| <= dot_bound unless inf or NaN.\n"
    "\n"
    "(4),(4)->(),().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot, dot_bound: number.\n"
    "5 mul, 7 add, 4 abs.\n",
   2, 2, "", dot_qq_loops},
  {"add_dpiToq", "(3),(4)->(4),(4)",
    "qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to\n"
    "first order; not normalized; |error of qi| <= qi_bound unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.\n"
    "31 mul, 31 add, 7 abs.\n",
   2, 2, "", add_dpiToq_loops},
  {"subtract_dpiFromq", "(3),(4)->(4),(4)",
    "qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order; |error of qi| <=\n"
    "qi_bound unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  dpi: vector; qi, qi_bound: quaternion (x, y, z, w), the scalar last.\n"
    "31 mul, 31 add, 7 abs.\n",
   2, 2, "", subtract_dpiFromq_loops},
  {"omega_to_dquaternion", "(3),(4)->(4),(4)",
    "dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the\n"
    "reference frame, rad/s, and a term that draws its norm to 1; |error of dqo| <= dqo_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(3),(4)->(4),(4).  w: vector; qi, dqo, dqo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "43 mul, 40 add, 11 abs.\n",
   2, 2, "", omega_to_dquaternion_loops},
  {"quaternion_from_axis_angle", "(3),()->(4),(4)",
    "qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its\n"
    "rotation is by another angle; |error of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(4),(4).  axis: vector; angle: number; qo, qo_bound: quaternion (x, y, z, w), the\n"
    "scalar last.\n"
    "98 mul, 139 add, 14 product error, 1 div, 11 abs, 1 less, 1 select.\n",
   2, 2, "", quaternion_from_axis_angle_loops},
  {"axis_angle_from_quaternion", "(4)->(),(3),(),(3)",
    "angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the\n"
    "angle is 0; any multiple of a quaternion; |error of angle| <= angle_bound, |error of axis|\n"
    "<= axis_bound unless inf or NaN.\n"
    "\n"
    "(4)->(),(3),(),(3).  q: quaternion (x, y, z, w), the scalar last; angle, angle_bound:\n"
    "number; axis, axis_bound: vector.\n"
    "201 mul, 318 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 5 neg, 50 abs, 4\n"
    "copysign, 35 less, 10 equal, 69 select.\n",
   1, 4, "N", axis_angle_from_quaternion_loops},
  {"quaternion_exp", "(3)->(4),(4)",
    "qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v; |error\n"
    "of qo| <= qo_bound unless inf or NaN.\n"
    "\n"
    "(3)->(4),(4).  v: vector; qo, qo_bound: quaternion (x, y, z, w), the scalar last.\n"
    "266 mul, 346 add, 17 product error, 4 product rest, 11 div, 3 sqrt, 37 abs, 11 less, 1\n"
    "equal, 24 select.\n",
   1, 2, "", quaternion_exp_loops},
  {"quaternion_log", "(4)->(3),(3)",
    "vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of\n"
    "it; |error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(4)->(3),(3).  q: quaternion (x, y, z, w), the scalar last; vo, vo_bound: vector.\n"
    "209 mul, 315 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 5 neg, 49 abs, 4\n"
    "copysign, 35 less, 10 equal, 65 select.\n",
   1, 2, "N", quaternion_log_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
