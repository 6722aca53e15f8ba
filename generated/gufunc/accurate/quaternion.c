/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the quaternion operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/quaternion_accurate.h"

/* (4),()->(4) */
OVER(quaternion_scale_double) {
  POINTERS_3
  EACH {
    ksl_quaternion_t self;
    double a;
    LOAD(quaternion_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_quaternion_scale_accurate(&self, a);
    STORE(quaternion_double, &self, 2, 1);
  }
}
STRIDED_WITH_FMA(quaternion_scale_double)
LOOP(quaternion_scale_double, 3, DENSE, 32, 8, 32, 8, 8)

OVER(quaternion_scale_single) {
  POINTERS_3
  EACH {
    ksl_quaternionf_t self;
    float a;
    LOAD(quaternion_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_quaternionf_scale_accurate(&self, a);
    STORE(quaternion_single, &self, 2, 1);
  }
}
STRIDED(quaternion_scale_single)
LOOP(quaternion_scale_single, 3, DENSE, 16, 4, 16, 4, 4)
LOOPS(quaternion_scale)

/* (),(4),(4)->(4) */
OVER(axpy_qq_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_quaternion_t x;
    ksl_quaternion_t y;
    LOAD_OTHER(scalar_double, &a);
    LOAD(quaternion_double, &x, 1, 0);
    LOAD(quaternion_double, &y, 2, 1);
    ksl_axpy_qq_accurate(a, &x, &y);
    STORE(quaternion_double, &y, 3, 2);
  }
}
STRIDED_WITH_FMA(axpy_qq_double)
LOOP(axpy_qq_double, 4, DENSE_OR_ONE, 8, 32, 32, 32, 8, 8, 8)

OVER(axpy_qq_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_quaternionf_t x;
    ksl_quaternionf_t y;
    LOAD_OTHER(scalar_single, &a);
    LOAD(quaternion_single, &x, 1, 0);
    LOAD(quaternion_single, &y, 2, 1);
    ksl_axpy_qqf_accurate(a, &x, &y);
    STORE(quaternion_single, &y, 3, 2);
  }
}
STRIDED(axpy_qq_single)
LOOP(axpy_qq_single, 4, DENSE_OR_ONE, 4, 16, 16, 16, 4, 4, 4)
LOOPS(axpy_qq)

/* (4)->() */
OVER(quaternion_norm_double) {
  POINTERS_2
  EACH {
    ksl_quaternion_t q;
    double norm;
    LOAD(quaternion_double, &q, 0, 0);
    norm = ksl_quaternion_norm_accurate(&q);
    STORE(scalar_double, &norm, 1, 1);
  }
}
STRIDED_WITH_FMA(quaternion_norm_double)
LOOP(quaternion_norm_double, 2, DENSE, 32, 8, 8)

OVER(quaternion_norm_single) {
  POINTERS_2
  EACH {
    ksl_quaternionf_t q;
    float norm;
    LOAD(quaternion_single, &q, 0, 0);
    norm = ksl_quaternionf_norm_accurate(&q);
    STORE(scalar_single, &norm, 1, 1);
  }
}
STRIDED(quaternion_norm_single)
LOOP(quaternion_norm_single, 2, DENSE, 16, 4, 4)
LOOPS(quaternion_norm)

/* (4)->(4) */
OVER(quaternion_normalize_double) {
  POINTERS_2
  EACH {
    ksl_quaternion_t self;
    LOAD(quaternion_double, &self, 0, 0);
    ksl_quaternion_normalize_accurate(&self);
    STORE(quaternion_double, &self, 1, 1);
  }
}
STRIDED_WITH_FMA(quaternion_normalize_double)
LOOP(quaternion_normalize_double, 2, DENSE, 32, 32, 8, 8)

OVER(quaternion_normalize_single) {
  POINTERS_2
  EACH {
    ksl_quaternionf_t self;
    LOAD(quaternion_single, &self, 0, 0);
    ksl_quaternionf_normalize_accurate(&self);
    STORE(quaternion_single, &self, 1, 1);
  }
}
STRIDED(quaternion_normalize_single)
LOOP(quaternion_normalize_single, 2, DENSE, 16, 16, 4, 4)
LOOPS(quaternion_normalize)

/* (4)->(4) */
OVER(quaternion_normalized_double) {
  POINTERS_2
  EACH {
    ksl_quaternion_t q;
    ksl_quaternion_t qo;
    LOAD(quaternion_double, &q, 0, 0);
    ksl_quaternion_normalized_accurate(&q, &qo);
    STORE(quaternion_double, &qo, 1, 1);
  }
}
STRIDED_WITH_FMA(quaternion_normalized_double)
LOOP(quaternion_normalized_double, 2, DENSE, 32, 32, 8, 8)

OVER(quaternion_normalized_single) {
  POINTERS_2
  EACH {
    ksl_quaternionf_t q;
    ksl_quaternionf_t qo;
    LOAD(quaternion_single, &q, 0, 0);
    ksl_quaternionf_normalized_accurate(&q, &qo);
    STORE(quaternion_single, &qo, 1, 1);
  }
}
STRIDED(quaternion_normalized_single)
LOOP(quaternion_normalized_single, 2, DENSE, 16, 16, 4, 4)
LOOPS(quaternion_normalized)

/* (4)->() */
OVER(quaternion_unit_defect_double) {
  POINTERS_2
  EACH {
    ksl_quaternion_t q;
    double defect;
    LOAD(quaternion_double, &q, 0, 0);
    defect = ksl_quaternion_unit_defect_accurate(&q);
    STORE(scalar_double, &defect, 1, 1);
  }
}
STRIDED_WITH_FMA(quaternion_unit_defect_double)
LOOP(quaternion_unit_defect_double, 2, DENSE, 32, 8, 8)

OVER(quaternion_unit_defect_single) {
  POINTERS_2
  EACH {
    ksl_quaternionf_t q;
    float defect;
    LOAD(quaternion_single, &q, 0, 0);
    defect = ksl_quaternionf_unit_defect_accurate(&q);
    STORE(scalar_single, &defect, 1, 1);
  }
}
STRIDED(quaternion_unit_defect_single)
LOOP(quaternion_unit_defect_single, 2, DENSE, 16, 4, 4)
LOOPS(quaternion_unit_defect)

/* (4)->(4) */
OVER(quaternion_nearest_unit_double) {
  POINTERS_2
  EACH {
    ksl_quaternion_t q;
    ksl_quaternion_t qo;
    LOAD(quaternion_double, &q, 0, 0);
    ksl_quaternion_nearest_unit_accurate(&q, &qo);
    STORE(quaternion_double, &qo, 1, 1);
  }
}
STRIDED_WITH_FMA(quaternion_nearest_unit_double)
LOOP(quaternion_nearest_unit_double, 2, DENSE, 32, 32, 8, 8)

OVER(quaternion_nearest_unit_single) {
  POINTERS_2
  EACH {
    ksl_quaternionf_t q;
    ksl_quaternionf_t qo;
    LOAD(quaternion_single, &q, 0, 0);
    ksl_quaternionf_nearest_unit_accurate(&q, &qo);
    STORE(quaternion_single, &qo, 1, 1);
  }
}
STRIDED(quaternion_nearest_unit_single)
LOOP(quaternion_nearest_unit_single, 2, DENSE, 16, 16, 4, 4)
LOOPS(quaternion_nearest_unit)

/* (4),(3)->(3) */
OVER(rotate_qv_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q, &q);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(quaternion_double, &q);
    LOAD(vec3_double, &v, 1, 1);
    ksl_rotate_qv_accurate(&q, &v, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED_WITH_FMA(rotate_qv_double)
LOOP(rotate_qv_double, 3, DENSE_OR_ONE, 32, 24, 24, 8, 8, 8)

OVER(rotate_qv_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q, &q);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(quaternion_single, &q);
    LOAD(vec3_single, &v, 1, 1);
    ksl_rotate_qvf_accurate(&q, &v, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(rotate_qv_single)
LOOP(rotate_qv_single, 3, DENSE_OR_ONE, 16, 12, 12, 4, 4, 4)
LOOPS(rotate_qv)

/* (4),(3)->(3) */
OVER(rotate_qconjv_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q, &q);
  EACH {
    ksl_vec3_t v;
    ksl_vec3_t vo;
    LOAD_OTHER(quaternion_double, &q);
    LOAD(vec3_double, &v, 1, 1);
    ksl_rotate_qconjv_accurate(&q, &v, &vo);
    STORE(vec3_double, &vo, 2, 2);
  }
}
STRIDED_WITH_FMA(rotate_qconjv_double)
LOOP(rotate_qconjv_double, 3, DENSE_OR_ONE, 32, 24, 24, 8, 8, 8)

OVER(rotate_qconjv_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q, &q);
  EACH {
    ksl_vec3f_t v;
    ksl_vec3f_t vo;
    LOAD_OTHER(quaternion_single, &q);
    LOAD(vec3_single, &v, 1, 1);
    ksl_rotate_qconjvf_accurate(&q, &v, &vo);
    STORE(vec3_single, &vo, 2, 2);
  }
}
STRIDED(rotate_qconjv_single)
LOOP(rotate_qconjv_single, 3, DENSE_OR_ONE, 16, 12, 12, 4, 4, 4)
LOOPS(rotate_qconjv)

/* (4),(4)->(4) */
OVER(quaternion_product_qq_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    ksl_quaternion_product_qq_accurate(&q1i, &q2i, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qq_double)
LOOP(quaternion_product_qq_double, 3, DENSE_OR_ONE, 32, 32, 32, 8, 8, 8)

OVER(quaternion_product_qq_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    ksl_product_qqf_accurate(&q1i, &q2i, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qq_single)
LOOP(quaternion_product_qq_single, 3, DENSE_OR_ONE, 16, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qq)

/* (4),(4)->(4) */
OVER(quaternion_product_qqconj_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    ksl_quaternion_product_qqconj_accurate(&q1i, &q2i, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qqconj_double)
LOOP(quaternion_product_qqconj_double, 3, DENSE_OR_ONE, 32, 32, 32, 8, 8, 8)

OVER(quaternion_product_qqconj_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    ksl_product_qqconjf_accurate(&q1i, &q2i, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qqconj_single)
LOOP(quaternion_product_qqconj_single, 3, DENSE_OR_ONE, 16, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qqconj)

/* (4),(4)->(4) */
OVER(quaternion_product_qconjq_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    ksl_quaternion_product_qconjq_accurate(&q1i, &q2i, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qconjq_double)
LOOP(quaternion_product_qconjq_double, 3, DENSE_OR_ONE, 32, 32, 32, 8, 8, 8)

OVER(quaternion_product_qconjq_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    ksl_product_qconjqf_accurate(&q1i, &q2i, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qconjq_single)
LOOP(quaternion_product_qconjq_single, 3, DENSE_OR_ONE, 16, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qconjq)

/* (4),(4)->(4) */
OVER(quaternion_product_qconjqconj_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    ksl_quaternion_product_qconjqconj_accurate(&q1i, &q2i, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qconjqconj_double)
LOOP(quaternion_product_qconjqconj_double, 3, DENSE_OR_ONE, 32, 32, 32, 8, 8, 8)

OVER(quaternion_product_qconjqconj_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    ksl_product_qconjqconjf_accurate(&q1i, &q2i, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qconjqconj_single)
LOOP(quaternion_product_qconjqconj_single, 3, DENSE_OR_ONE, 16, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qconjqconj)

/* (2),(4)->(4) */
OVER(quaternion_product_qxq_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qxq_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qxq_double)
LOOP(quaternion_product_qxq_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qxq_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qxqf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qxq_single)
LOOP(quaternion_product_qxq_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qxq)

/* (2),(4)->(4) */
OVER(quaternion_product_qxqconj_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qxqconj_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qxqconj_double)
LOOP(quaternion_product_qxqconj_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qxqconj_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qxqconjf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qxqconj_single)
LOOP(quaternion_product_qxqconj_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qxqconj)

/* (2),(4)->(4) */
OVER(quaternion_product_qxconjq_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qxconjq_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qxconjq_double)
LOOP(quaternion_product_qxconjq_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qxconjq_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qxconjqf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qxconjq_single)
LOOP(quaternion_product_qxconjq_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qxconjq)

/* (2),(4)->(4) */
OVER(quaternion_product_qxconjqconj_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qxconjqconj_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qxconjqconj_double)
LOOP(quaternion_product_qxconjqconj_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qxconjqconj_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qxconjqconjf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qxconjqconj_single)
LOOP(quaternion_product_qxconjqconj_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qxconjqconj)

/* (4),(2)->(4) */
OVER(quaternion_product_qqx_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqx_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qqx_double)
LOOP(quaternion_product_qqx_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qqx_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqxf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qqx_single)
LOOP(quaternion_product_qqx_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qqx)

/* (4),(2)->(4) */
OVER(quaternion_product_qqxconj_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqxconj_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qqxconj_double)
LOOP(quaternion_product_qqxconj_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qqxconj_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqxconjf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qqxconj_single)
LOOP(quaternion_product_qqxconj_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qqxconj)

/* (4),(2)->(4) */
OVER(quaternion_product_qconjqx_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqx_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qconjqx_double)
LOOP(quaternion_product_qconjqx_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qconjqx_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqxf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qconjqx_single)
LOOP(quaternion_product_qconjqx_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qconjqx)

/* (4),(2)->(4) */
OVER(quaternion_product_qconjqxconj_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqxconj_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qconjqxconj_double)
LOOP(quaternion_product_qconjqxconj_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qconjqxconj_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqxconjf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qconjqxconj_single)
LOOP(quaternion_product_qconjqxconj_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qconjqxconj)

/* (2),(4)->(4) */
OVER(quaternion_product_qyq_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qyq_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qyq_double)
LOOP(quaternion_product_qyq_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qyq_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qyqf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qyq_single)
LOOP(quaternion_product_qyq_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qyq)

/* (2),(4)->(4) */
OVER(quaternion_product_qyqconj_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qyqconj_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qyqconj_double)
LOOP(quaternion_product_qyqconj_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qyqconj_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qyqconjf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qyqconj_single)
LOOP(quaternion_product_qyqconj_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qyqconj)

/* (2),(4)->(4) */
OVER(quaternion_product_qyconjq_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qyconjq_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qyconjq_double)
LOOP(quaternion_product_qyconjq_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qyconjq_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qyconjqf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qyconjq_single)
LOOP(quaternion_product_qyconjq_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qyconjq)

/* (2),(4)->(4) */
OVER(quaternion_product_qyconjqconj_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qyconjqconj_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qyconjqconj_double)
LOOP(quaternion_product_qyconjqconj_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qyconjqconj_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qyconjqconjf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qyconjqconj_single)
LOOP(quaternion_product_qyconjqconj_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qyconjqconj)

/* (4),(2)->(4) */
OVER(quaternion_product_qqy_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqy_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qqy_double)
LOOP(quaternion_product_qqy_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qqy_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqyf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qqy_single)
LOOP(quaternion_product_qqy_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qqy)

/* (4),(2)->(4) */
OVER(quaternion_product_qqyconj_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqyconj_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qqyconj_double)
LOOP(quaternion_product_qqyconj_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qqyconj_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqyconjf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qqyconj_single)
LOOP(quaternion_product_qqyconj_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qqyconj)

/* (4),(2)->(4) */
OVER(quaternion_product_qconjqy_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqy_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qconjqy_double)
LOOP(quaternion_product_qconjqy_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qconjqy_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqyf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qconjqy_single)
LOOP(quaternion_product_qconjqy_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qconjqy)

/* (4),(2)->(4) */
OVER(quaternion_product_qconjqyconj_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqyconj_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qconjqyconj_double)
LOOP(quaternion_product_qconjqyconj_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qconjqyconj_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqyconjf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qconjqyconj_single)
LOOP(quaternion_product_qconjqyconj_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qconjqyconj)

/* (2),(4)->(4) */
OVER(quaternion_product_qzq_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qzq_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qzq_double)
LOOP(quaternion_product_qzq_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qzq_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qzqf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qzq_single)
LOOP(quaternion_product_qzq_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qzq)

/* (2),(4)->(4) */
OVER(quaternion_product_qzqconj_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qzqconj_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qzqconj_double)
LOOP(quaternion_product_qzqconj_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qzqconj_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qzqconjf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qzqconj_single)
LOOP(quaternion_product_qzqconj_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qzqconj)

/* (2),(4)->(4) */
OVER(quaternion_product_qzconjq_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qzconjq_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qzconjq_double)
LOOP(quaternion_product_qzconjq_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qzconjq_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qzconjqf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qzconjq_single)
LOOP(quaternion_product_qzconjq_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qzconjq)

/* (2),(4)->(4) */
OVER(quaternion_product_qzconjqconj_double) {
  POINTERS_3
  LOAD_FIRST(dc_double, double dci[2], dci);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(dc_double, dci);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_qzconjqconj_accurate(dci, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qzconjqconj_double)
LOOP(quaternion_product_qzconjqconj_double, 3, DENSE_OR_ONE, 16, 32, 32, 8, 8, 8)

OVER(quaternion_product_qzconjqconj_single) {
  POINTERS_3
  LOAD_FIRST(dc_single, float dci[2], dci);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(dc_single, dci);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_qzconjqconjf_accurate(dci, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qzconjqconj_single)
LOOP(quaternion_product_qzconjqconj_single, 3, DENSE_OR_ONE, 8, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_qzconjqconj)

/* (4),(2)->(4) */
OVER(quaternion_product_qqz_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqz_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qqz_double)
LOOP(quaternion_product_qqz_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qqz_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqzf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qqz_single)
LOOP(quaternion_product_qqz_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qqz)

/* (4),(2)->(4) */
OVER(quaternion_product_qqzconj_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qqzconj_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qqzconj_double)
LOOP(quaternion_product_qqzconj_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qqzconj_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qqzconjf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qqzconj_single)
LOOP(quaternion_product_qqzconj_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qqzconj)

/* (4),(2)->(4) */
OVER(quaternion_product_qconjqz_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqz_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qconjqz_double)
LOOP(quaternion_product_qconjqz_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qconjqz_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqzf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qconjqz_single)
LOOP(quaternion_product_qconjqz_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qconjqz)

/* (4),(2)->(4) */
OVER(quaternion_product_qconjqzconj_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    double dci[2];
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(dc_double, dci, 1, 1);
    ksl_quaternion_product_qconjqzconj_accurate(&qi, dci, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qconjqzconj_double)
LOOP(quaternion_product_qconjqzconj_double, 3, DENSE_OR_ONE, 32, 16, 32, 8, 8, 8)

OVER(quaternion_product_qconjqzconj_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    float dci[2];
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(dc_single, dci, 1, 1);
    ksl_product_qconjqzconjf_accurate(&qi, dci, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qconjqzconj_single)
LOOP(quaternion_product_qconjqzconj_single, 3, DENSE_OR_ONE, 16, 8, 16, 4, 4, 4)
LOOPS(quaternion_product_qconjqzconj)

/* (4),(3)->(4) */
OVER(quaternion_product_qv_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    ksl_vec3_t vi;
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(vec3_double, &vi, 1, 1);
    ksl_quaternion_product_qv_accurate(&qi, &vi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qv_double)
LOOP(quaternion_product_qv_double, 3, DENSE_OR_ONE, 32, 24, 32, 8, 8, 8)

OVER(quaternion_product_qv_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    ksl_vec3f_t vi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(vec3_single, &vi, 1, 1);
    ksl_product_qvf_accurate(&qi, &vi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qv_single)
LOOP(quaternion_product_qv_single, 3, DENSE_OR_ONE, 16, 12, 16, 4, 4, 4)
LOOPS(quaternion_product_qv)

/* (4),(3)->(4) */
OVER(quaternion_product_qconjv_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t qi, &qi);
  EACH {
    ksl_vec3_t vi;
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &qi);
    LOAD(vec3_double, &vi, 1, 1);
    ksl_quaternion_product_qconjv_accurate(&qi, &vi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_qconjv_double)
LOOP(quaternion_product_qconjv_double, 3, DENSE_OR_ONE, 32, 24, 32, 8, 8, 8)

OVER(quaternion_product_qconjv_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t qi, &qi);
  EACH {
    ksl_vec3f_t vi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &qi);
    LOAD(vec3_single, &vi, 1, 1);
    ksl_product_qconjvf_accurate(&qi, &vi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_qconjv_single)
LOOP(quaternion_product_qconjv_single, 3, DENSE_OR_ONE, 16, 12, 16, 4, 4, 4)
LOOPS(quaternion_product_qconjv)

/* (3),(4)->(4) */
OVER(quaternion_product_vq_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t vi, &vi);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(vec3_double, &vi);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_vq_accurate(&vi, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_vq_double)
LOOP(quaternion_product_vq_double, 3, DENSE_OR_ONE, 24, 32, 32, 8, 8, 8)

OVER(quaternion_product_vq_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t vi, &vi);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(vec3_single, &vi);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_vqf_accurate(&vi, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_vq_single)
LOOP(quaternion_product_vq_single, 3, DENSE_OR_ONE, 12, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_vq)

/* (3),(4)->(4) */
OVER(quaternion_product_vqconj_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t vi, &vi);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t qo;
    LOAD_OTHER(vec3_double, &vi);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_quaternion_product_vqconj_accurate(&vi, &qi, &qo);
    STORE(quaternion_double, &qo, 2, 2);
  }
}
STRIDED_WITH_FMA(quaternion_product_vqconj_double)
LOOP(quaternion_product_vqconj_double, 3, DENSE_OR_ONE, 24, 32, 32, 8, 8, 8)

OVER(quaternion_product_vqconj_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t vi, &vi);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t qo;
    LOAD_OTHER(vec3_single, &vi);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_product_vqconjf_accurate(&vi, &qi, &qo);
    STORE(quaternion_single, &qo, 2, 2);
  }
}
STRIDED(quaternion_product_vqconj_single)
LOOP(quaternion_product_vqconj_single, 3, DENSE_OR_ONE, 12, 16, 16, 4, 4, 4)
LOOPS(quaternion_product_vqconj)

/* (4),(4)->() */
OVER(dot_qq_double) {
  POINTERS_3
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1i, &q1i);
  EACH {
    ksl_quaternion_t q2i;
    double dot;
    LOAD_OTHER(quaternion_double, &q1i);
    LOAD(quaternion_double, &q2i, 1, 1);
    dot = ksl_dot_qq_accurate(&q1i, &q2i);
    STORE(scalar_double, &dot, 2, 2);
  }
}
STRIDED_WITH_FMA(dot_qq_double)
LOOP(dot_qq_double, 3, DENSE_OR_ONE, 32, 32, 8, 8, 8)

OVER(dot_qq_single) {
  POINTERS_3
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1i, &q1i);
  EACH {
    ksl_quaternionf_t q2i;
    float dot;
    LOAD_OTHER(quaternion_single, &q1i);
    LOAD(quaternion_single, &q2i, 1, 1);
    dot = ksl_dot_qqf_accurate(&q1i, &q2i);
    STORE(scalar_single, &dot, 2, 2);
  }
}
STRIDED(dot_qq_single)
LOOP(dot_qq_single, 3, DENSE_OR_ONE, 16, 16, 4, 4, 4)
LOOPS(dot_qq)

/* (3),(4)->(4) */
OVER(add_dpiToq_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t dpi, &dpi);
  EACH {
    ksl_quaternion_t qi;
    LOAD_OTHER(vec3_double, &dpi);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_add_dpiToq_accurate(&dpi, &qi);
    STORE(quaternion_double, &qi, 2, 2);
  }
}
STRIDED_WITH_FMA(add_dpiToq_double)
LOOP(add_dpiToq_double, 3, DENSE_OR_ONE, 24, 32, 32, 8, 8, 8)

OVER(add_dpiToq_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t dpi, &dpi);
  EACH {
    ksl_quaternionf_t qi;
    LOAD_OTHER(vec3_single, &dpi);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_add_dpiToqf_accurate(&dpi, &qi);
    STORE(quaternion_single, &qi, 2, 2);
  }
}
STRIDED(add_dpiToq_single)
LOOP(add_dpiToq_single, 3, DENSE_OR_ONE, 12, 16, 16, 4, 4, 4)
LOOPS(add_dpiToq)

/* (3),(4)->(4) */
OVER(subtract_dpiFromq_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t dpi, &dpi);
  EACH {
    ksl_quaternion_t qi;
    LOAD_OTHER(vec3_double, &dpi);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_subtract_dpiFromq_accurate(&dpi, &qi);
    STORE(quaternion_double, &qi, 2, 2);
  }
}
STRIDED_WITH_FMA(subtract_dpiFromq_double)
LOOP(subtract_dpiFromq_double, 3, DENSE_OR_ONE, 24, 32, 32, 8, 8, 8)

OVER(subtract_dpiFromq_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t dpi, &dpi);
  EACH {
    ksl_quaternionf_t qi;
    LOAD_OTHER(vec3_single, &dpi);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_subtract_dpiFromqf_accurate(&dpi, &qi);
    STORE(quaternion_single, &qi, 2, 2);
  }
}
STRIDED(subtract_dpiFromq_single)
LOOP(subtract_dpiFromq_single, 3, DENSE_OR_ONE, 12, 16, 16, 4, 4, 4)
LOOPS(subtract_dpiFromq)

/* (3),(4)->(4) */
OVER(omega_to_dquaternion_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t w, &w);
  EACH {
    ksl_quaternion_t qi;
    ksl_quaternion_t dqo;
    LOAD_OTHER(vec3_double, &w);
    LOAD(quaternion_double, &qi, 1, 1);
    ksl_omega_to_dquaternion_accurate(&w, &qi, &dqo);
    STORE(quaternion_double, &dqo, 2, 2);
  }
}
STRIDED_WITH_FMA(omega_to_dquaternion_double)
LOOP(omega_to_dquaternion_double, 3, DENSE_OR_ONE, 24, 32, 32, 8, 8, 8)

OVER(omega_to_dquaternion_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t w, &w);
  EACH {
    ksl_quaternionf_t qi;
    ksl_quaternionf_t dqo;
    LOAD_OTHER(vec3_single, &w);
    LOAD(quaternion_single, &qi, 1, 1);
    ksl_omega_to_dquaternionf_accurate(&w, &qi, &dqo);
    STORE(quaternion_single, &dqo, 2, 2);
  }
}
STRIDED(omega_to_dquaternion_single)
LOOP(omega_to_dquaternion_single, 3, DENSE_OR_ONE, 12, 16, 16, 4, 4, 4)
LOOPS(omega_to_dquaternion)

/* (4)->(3,3) */
OVER(mat3x3_from_quaternion_double) {
  POINTERS_2
  EACH {
    ksl_quaternion_t q;
    ksl_mat3x3_t R;
    LOAD(quaternion_double, &q, 0, 0);
    ksl_mat3x3_from_quaternion_accurate(&q, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED_WITH_FMA(mat3x3_from_quaternion_double)
LOOP(mat3x3_from_quaternion_double, 2, ANY, 32, 72, 8, 24, 8)

OVER(mat3x3_from_quaternion_single) {
  POINTERS_2
  EACH {
    ksl_quaternionf_t q;
    ksl_mat3x3f_t R;
    LOAD(quaternion_single, &q, 0, 0);
    ksl_mat3x3f_from_quaternion_accurate(&q, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(mat3x3_from_quaternion_single)
LOOP(mat3x3_from_quaternion_single, 2, DENSE, 16, 36, 4, 12, 4)
LOOPS(mat3x3_from_quaternion)

/* (3,3)->(4) */
OVER(quaternion_from_mat3x3_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_quaternion_t qo;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_quaternion_from_mat3x3_accurate(&R, &qo);
    STORE(quaternion_double, &qo, 1, 2);
  }
}
STRIDED_WITH_FMA(quaternion_from_mat3x3_double)
LOOP(quaternion_from_mat3x3_double, 2, ANY, 72, 32, 24, 8, 8)

OVER(quaternion_from_mat3x3_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_quaternionf_t qo;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_quaternionf_from_mat3x3_accurate(&R, &qo);
    STORE(quaternion_single, &qo, 1, 2);
  }
}
STRIDED(quaternion_from_mat3x3_single)
LOOP(quaternion_from_mat3x3_single, 2, DENSE, 36, 16, 12, 4, 4)
LOOPS(quaternion_from_mat3x3)

/* (3),()->(4) */
OVER(quaternion_from_axis_angle_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t axis, &axis);
  EACH {
    double angle;
    ksl_quaternion_t qo;
    LOAD_OTHER(vec3_double, &axis);
    LOAD(scalar_double, &angle, 1, 1);
    ksl_quaternion_from_axis_angle_accurate(&axis, angle, &qo);
    STORE(quaternion_double, &qo, 2, 1);
  }
}
STRIDED_WITH_FMA(quaternion_from_axis_angle_double)
LOOP(quaternion_from_axis_angle_double, 3, DENSE_OR_ONE, 24, 8, 32, 8, 8)

OVER(quaternion_from_axis_angle_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t axis, &axis);
  EACH {
    float angle;
    ksl_quaternionf_t qo;
    LOAD_OTHER(vec3_single, &axis);
    LOAD(scalar_single, &angle, 1, 1);
    ksl_quaternionf_from_axis_angle_accurate(&axis, angle, &qo);
    STORE(quaternion_single, &qo, 2, 1);
  }
}
STRIDED(quaternion_from_axis_angle_single)
LOOP(quaternion_from_axis_angle_single, 3, DENSE_OR_ONE, 12, 4, 16, 4, 4)
LOOPS(quaternion_from_axis_angle)

/* (4)->(),(3) */
OVER(axis_angle_from_quaternion_double) {
  POINTERS_3
  EACH {
    ksl_quaternion_t q;
    double angle;
    ksl_vec3_t axis;
    LOAD(quaternion_double, &q, 0, 0);
    angle = ksl_axis_angle_from_quaternion_accurate(&q, &axis);
    STORE(scalar_double, &angle, 1, 1);
    STORE(vec3_double, &axis, 2, 1);
  }
}
STRIDED_WITH_FMA(axis_angle_from_quaternion_double)
LOOP(axis_angle_from_quaternion_double, 3, ANY, 32, 8, 24, 8, 8)

OVER(axis_angle_from_quaternion_single) {
  POINTERS_3
  EACH {
    ksl_quaternionf_t q;
    float angle;
    ksl_vec3f_t axis;
    LOAD(quaternion_single, &q, 0, 0);
    angle = ksl_axis_angle_from_quaternionf_accurate(&q, &axis);
    STORE(scalar_single, &angle, 1, 1);
    STORE(vec3_single, &axis, 2, 1);
  }
}
STRIDED(axis_angle_from_quaternion_single)
LOOP(axis_angle_from_quaternion_single, 3, DENSE, 16, 4, 12, 4, 4)
LOOPS(axis_angle_from_quaternion)

/* (3)->(4) */
OVER(quaternion_exp_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_quaternion_t qo;
    LOAD(vec3_double, &v, 0, 0);
    ksl_quaternion_exp_accurate(&v, &qo);
    STORE(quaternion_double, &qo, 1, 1);
  }
}
STRIDED_WITH_FMA(quaternion_exp_double)
LOOP(quaternion_exp_double, 2, ANY, 24, 32, 8, 8)

OVER(quaternion_exp_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_quaternionf_t qo;
    LOAD(vec3_single, &v, 0, 0);
    ksl_quaternionf_exp_accurate(&v, &qo);
    STORE(quaternion_single, &qo, 1, 1);
  }
}
STRIDED(quaternion_exp_single)
LOOP(quaternion_exp_single, 2, DENSE, 12, 16, 4, 4)
LOOPS(quaternion_exp)

/* (4)->(3) */
OVER(quaternion_log_double) {
  POINTERS_2
  EACH {
    ksl_quaternion_t q;
    ksl_vec3_t vo;
    LOAD(quaternion_double, &q, 0, 0);
    ksl_quaternion_log_accurate(&q, &vo);
    STORE(vec3_double, &vo, 1, 1);
  }
}
STRIDED_WITH_FMA(quaternion_log_double)
LOOP(quaternion_log_double, 2, ANY, 32, 24, 8, 8)

OVER(quaternion_log_single) {
  POINTERS_2
  EACH {
    ksl_quaternionf_t q;
    ksl_vec3f_t vo;
    LOAD(quaternion_single, &q, 0, 0);
    ksl_quaternionf_log_accurate(&q, &vo);
    STORE(vec3_single, &vo, 1, 1);
  }
}
STRIDED(quaternion_log_single)
LOOP(quaternion_log_single, 2, DENSE, 16, 12, 4, 4)
LOOPS(quaternion_log)

/* (4),(4),()->(4) */
OVER(quaternion_interpolated_double) {
  POINTERS_4
  LOAD_FIRST(quaternion_double, ksl_quaternion_t q1, &q1);
  EACH {
    ksl_quaternion_t q2;
    double k;
    ksl_quaternion_t qo;
    LOAD_OTHER(quaternion_double, &q1);
    LOAD(quaternion_double, &q2, 1, 1);
    LOAD(scalar_double, &k, 2, 2);
    ksl_quaternion_interpolated_accurate(&q1, &q2, k, &qo);
    STORE(quaternion_double, &qo, 3, 2);
  }
}
STRIDED_WITH_FMA(quaternion_interpolated_double)
LOOP(quaternion_interpolated_double, 4, ANY, 32, 32, 8, 32, 8, 8, 8)

OVER(quaternion_interpolated_single) {
  POINTERS_4
  LOAD_FIRST(quaternion_single, ksl_quaternionf_t q1, &q1);
  EACH {
    ksl_quaternionf_t q2;
    float k;
    ksl_quaternionf_t qo;
    LOAD_OTHER(quaternion_single, &q1);
    LOAD(quaternion_single, &q2, 1, 1);
    LOAD(scalar_single, &k, 2, 2);
    ksl_quaternionf_interpolated_accurate(&q1, &q2, k, &qo);
    STORE(quaternion_single, &qo, 3, 2);
  }
}
STRIDED(quaternion_interpolated_single)
LOOP(quaternion_interpolated_single, 4, DENSE_OR_ONE, 16, 16, 4, 16, 4, 4, 4)
LOOPS(quaternion_interpolated)

const coscrew_gufunc TABLE(quaternion)[] = {
  {"quaternion_scale", "(4),()->(4)",
    "self = a self.\n"
    "\n"
    "(4),()->(4).  self: quaternion (x, y, z, w), the scalar last; a: number.\n"
    "4 mul, 4 add, 4 product error.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", quaternion_scale_loops},
  {"axpy_qq", "(),(4),(4)->(4)",
    "y = a x + y.\n"
    "\n"
    "(),(4),(4)->(4).  a: number; x, y: quaternion (x, y, z, w), the scalar last.\n"
    "4 mul, 24 add, 4 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   3, 1, "", axpy_qq_loops},
  {"quaternion_norm", "(4)->()",
    "|q| = sqrt(v·v + w^2).\n"
    "\n"
    "(4)->().  q: quaternion (x, y, z, w), the scalar last; norm: number.\n"
    "12 mul, 35 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11\n"
    "select.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", quaternion_norm_loops},
  {"quaternion_normalize", "(4)->(4)",
    "self = self / |self|; zero stays zero.\n"
    "\n"
    "(4)->(4).  self: quaternion (x, y, z, w), the scalar last.\n"
    "33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15\n"
    "select.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", quaternion_normalize_loops},
  {"quaternion_normalized", "(4)->(4)",
    "qo = q / |q|; zero stays zero.\n"
    "\n"
    "(4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.\n"
    "33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15\n"
    "select.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", quaternion_normalized_loops},
  {"quaternion_unit_defect", "(4)->()",
    "|q| - 1: 0 for a unit quaternion, negative for a shorter one.\n"
    "\n"
    "(4)->().  q: quaternion (x, y, z, w), the scalar last; defect: number.\n"
    "12 mul, 42 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11\n"
    "select.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", quaternion_unit_defect_loops},
  {"quaternion_nearest_unit", "(4)->(4)",
    "qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.\n"
    "\n"
    "(4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.\n"
    "17 mul, 54 add, 5 product error, 4 product rest, 9 div, 1 sqrt, 4 abs, 6 less, 6 equal, 21\n"
    "select.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "N", quaternion_nearest_unit_loops},
  {"rotate_qv", "(4),(3)->(3)",
    "vo = R(q) v, |q| = 1.\n"
    "\n"
    "(4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.\n"
    "30 mul, 75 add, 15 product rest.  Error <= u |result| + 34 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "U.", rotate_qv_loops},
  {"rotate_qconjv", "(4),(3)->(3)",
    "vo = R(q)^T v, |q| = 1.\n"
    "\n"
    "(4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.\n"
    "30 mul, 75 add, 15 product rest.  Error <= u |result| + 34 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "U.", rotate_qconjv_loops},
  {"quaternion_product_qq", "(4),(4)->(4)",
    "qo = q1i q2i.\n"
    "\n"
    "(4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 68 add, 16 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qq_loops},
  {"quaternion_product_qqconj", "(4),(4)->(4)",
    "qo = q1i q2i*.\n"
    "\n"
    "(4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 68 add, 16 product rest.  Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqconj_loops},
  {"quaternion_product_qconjq", "(4),(4)->(4)",
    "qo = q1i* q2i.\n"
    "\n"
    "(4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 68 add, 16 product rest.  Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjq_loops},
  {"quaternion_product_qconjqconj", "(4),(4)->(4)",
    "qo = q1i* q2i*.\n"
    "\n"
    "(4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.\n"
    "16 mul, 68 add, 16 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqconj_loops},
  {"quaternion_product_qxq", "(2),(4)->(4)",
    "qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qxq_loops},
  {"quaternion_product_qxqconj", "(2),(4)->(4)",
    "qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qxqconj_loops},
  {"quaternion_product_qxconjq", "(2),(4)->(4)",
    "qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qxconjq_loops},
  {"quaternion_product_qxconjqconj", "(2),(4)->(4)",
    "qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qxconjqconj_loops},
  {"quaternion_product_qqx", "(4),(2)->(4)",
    "qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqx_loops},
  {"quaternion_product_qqxconj", "(4),(2)->(4)",
    "qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqxconj_loops},
  {"quaternion_product_qconjqx", "(4),(2)->(4)",
    "qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqx_loops},
  {"quaternion_product_qconjqxconj", "(4),(2)->(4)",
    "qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqxconj_loops},
  {"quaternion_product_qyq", "(2),(4)->(4)",
    "qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qyq_loops},
  {"quaternion_product_qyqconj", "(2),(4)->(4)",
    "qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qyqconj_loops},
  {"quaternion_product_qyconjq", "(2),(4)->(4)",
    "qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qyconjq_loops},
  {"quaternion_product_qyconjqconj", "(2),(4)->(4)",
    "qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qyconjqconj_loops},
  {"quaternion_product_qqy", "(4),(2)->(4)",
    "qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqy_loops},
  {"quaternion_product_qqyconj", "(4),(2)->(4)",
    "qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqyconj_loops},
  {"quaternion_product_qconjqy", "(4),(2)->(4)",
    "qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqy_loops},
  {"quaternion_product_qconjqyconj", "(4),(2)->(4)",
    "qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqyconj_loops},
  {"quaternion_product_qzq", "(2),(4)->(4)",
    "qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qzq_loops},
  {"quaternion_product_qzqconj", "(2),(4)->(4)",
    "qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qzqconj_loops},
  {"quaternion_product_qzconjq", "(2),(4)->(4)",
    "qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qzconjq_loops},
  {"quaternion_product_qzconjqconj", "(2),(4)->(4)",
    "qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qzconjqconj_loops},
  {"quaternion_product_qqz", "(4),(2)->(4)",
    "qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqz_loops},
  {"quaternion_product_qqzconj", "(4),(2)->(4)",
    "qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qqzconj_loops},
  {"quaternion_product_qconjqz", "(4),(2)->(4)",
    "qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqz_loops},
  {"quaternion_product_qconjqzconj", "(4),(2)->(4)",
    "qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.\n"
    "\n"
    "(4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).\n"
    "8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjqzconj_loops},
  {"quaternion_product_qv", "(4),(3)->(4)",
    "qo = qi (vi; 0).\n"
    "\n"
    "(4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.\n"
    "12 mul, 44 add, 12 product rest, 2 neg.  Error <= u |result| + 11 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qv_loops},
  {"quaternion_product_qconjv", "(4),(3)->(4)",
    "qo = qi* (vi; 0).\n"
    "\n"
    "(4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.\n"
    "12 mul, 44 add, 12 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_qconjv_loops},
  {"quaternion_product_vq", "(3),(4)->(4)",
    "qo = (vi; 0) qi.\n"
    "\n"
    "(3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "12 mul, 44 add, 12 product rest, 2 neg.  Error <= u |result| + 11 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_vq_loops},
  {"quaternion_product_vqconj", "(3),(4)->(4)",
    "qo = (vi; 0) qi*.\n"
    "\n"
    "(3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.\n"
    "12 mul, 44 add, 12 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", quaternion_product_vqconj_loops},
  {"dot_qq", "(4),(4)->()",
    "q1i·q2i.\n"
    "\n"
    "(4),(4)->().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot: number.\n"
    "4 mul, 17 add, 4 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   2, 1, "", dot_qq_loops},
  {"add_dpiToq", "(3),(4)->(4)",
    "qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to\n"
    "first order; not normalized.\n"
    "\n"
    "(3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.\n"
    "15 mul, 72 add, 12 product rest.  Error <= u |result| + 15 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", add_dpiToq_loops},
  {"subtract_dpiFromq", "(3),(4)->(4)",
    "qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.\n"
    "\n"
    "(3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.\n"
    "15 mul, 72 add, 12 product rest.  Error <= u |result| + 15 u^2 S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", subtract_dpiFromq_loops},
  {"omega_to_dquaternion", "(3),(4)->(4)",
    "dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the\n"
    "reference frame, rad/s, and a term that draws its norm to 1.\n"
    "\n"
    "(3),(4)->(4).  w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.\n"
    "27 mul, 101 add, 20 product rest.  Error <= u |result| + (v: 35, w: 32) u^2 S, S the sum of\n"
    "the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", omega_to_dquaternion_loops},
  {"mat3x3_from_quaternion", "(4)->(3,3)",
    "R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.\n"
    "\n"
    "(4)->(3,3).  q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.\n"
    "41 mul, 116 add, 10 product error, 24 product rest, 2 div, 9 equal, 9 select.  Error <= R: 1\n"
    "u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 < |q| < 2^63;\n"
    "searched, not proved.  Each component is within 1 ulp as long as its condition is below\n"
    "1e13; in single precision it is the nearest number, except near ties, as long as that is\n"
    "below 1e5; searched, not proved.\n",
   1, 1, "N", mat3x3_from_quaternion_loops},
  {"quaternion_from_mat3x3", "(3,3)->(4)",
    "qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.\n"
    "\n"
    "(3,3)->(4).  R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.\n"
    "21 mul, 182 add, 5 product error, 4 product rest, 9 div, 1 sqrt, 9 neg, 4 less, 5 equal, 37\n"
    "select.  Error <= qo: 1 u of its largest component for R a rotation; searched, not proved.\n"
    "Each component is within 1 ulp as long as its condition is below 1e13; in single precision\n"
    "it is the nearest number, except near ties, as long as that is below 1e5; searched, not\n"
    "proved.\n",
   1, 1, "R", quaternion_from_mat3x3_loops},
  {"quaternion_from_axis_angle", "(3),()->(4)",
    "qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its\n"
    "rotation is by another angle.\n"
    "\n"
    "(3),()->(4).  axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.\n"
    "90 mul, 134 add, 14 product error, 1 div, 3 abs, 1 less, 4 equal, 5 select.  Error <= qo: 1\n"
    "u of its largest component for |axis| = 1; searched, not proved.  Each component is within 1\n"
    "ulp as long as its condition is below 1e13; in single precision it is the nearest number,\n"
    "except near ties, as long as that is below 1e5; searched, not proved.\n",
   2, 1, "", quaternion_from_axis_angle_loops},
  {"axis_angle_from_quaternion", "(4)->(),(3)",
    "angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the\n"
    "angle is 0; any multiple of a quaternion.\n"
    "\n"
    "(4)->(),(3).  q: quaternion (x, y, z, w), the scalar last; angle: number; axis: vector.\n"
    "149 mul, 268 add, 25 product error, 3 product rest, 13 div, 1 sqrt, 5 neg, 17 abs, 4\n"
    "copysign, 27 less, 10 equal, 51 select.  Error <= angle: 1 u, axis: 1 u of its largest\n"
    "component; searched, not proved.  Each component is within 1 ulp as long as its condition is\n"
    "below 1e13; in single precision it is the nearest number, except near ties, as long as that\n"
    "is below 1e5; searched, not proved.\n",
   1, 2, "N", axis_angle_from_quaternion_loops},
  {"quaternion_exp", "(3)->(4)",
    "qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.\n"
    "\n"
    "(3)->(4).  v: vector; qo: quaternion (x, y, z, w), the scalar last.\n"
    "145 mul, 231 add, 17 product error, 4 product rest, 5 div, 1 sqrt, 7 abs, 6 less, 5 equal,\n"
    "14 select.  Error <= qo: 1 u of its largest component for |v| <= 1e13, in single precision\n"
    "1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below\n"
    "1e13; in single precision it is the nearest number, except near ties, as long as that is\n"
    "below 1e5; searched, not proved.\n",
   1, 1, "", quaternion_exp_loops},
  {"quaternion_log", "(4)->(3)",
    "vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of\n"
    "it.\n"
    "\n"
    "(4)->(3).  q: quaternion (x, y, z, w), the scalar last; vo: vector.\n"
    "151 mul, 271 add, 26 product error, 3 product rest, 9 div, 1 sqrt, 5 neg, 17 abs, 4\n"
    "copysign, 27 less, 9 equal, 48 select.  Error <= vo: 1 u of its largest component; searched,\n"
    "not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in\n"
    "single precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "N", quaternion_log_loops},
  {"quaternion_interpolated", "(4),(4),()->(4)",
    "qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.\n"
    "\n"
    "(4),(4),()->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.\n"
    "371 mul, 774 add, 46 product error, 39 product rest, 16 div, 2 sqrt, 14 neg, 21 abs, 4\n"
    "copysign, 36 less, 11 equal, 68 select.  Error <= qo: 1 u of its largest component for |q1|\n"
    "= 1 and |q2| = 1 and 0 <= k <= 1; searched, not proved.  Each component is within 1 ulp as\n"
    "long as its condition is below 1e13; in single precision it is the nearest number, except\n"
    "near ties, as long as that is below 1e5; searched, not proved.\n",
   3, 1, "UU.", quaternion_interpolated_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
