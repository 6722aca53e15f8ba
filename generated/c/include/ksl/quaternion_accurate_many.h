/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_QUATERNION_ACCURATE_MANY_H
#define KSL_QUATERNION_ACCURATE_MANY_H

#include "quaternion_accurate.h"
#include "ksl_planes.h"

/* ksl_quaternion_scale_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_scale_accurate_many(ptrdiff_t n, ksl_quaternion_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_scale_accurate(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_quaternion_scale_accurate_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_t self_i = ksl_quaternion_of_planes(self + i * self_stride, self_plane);
    ksl_quaternion_scale_accurate(&self_i, a[i * a_stride]);
    ksl_quaternion_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_qq_accurate of n elements. */
static KSL_INLINED void ksl_axpy_qq_accurate_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_quaternion_t *x, ptrdiff_t x_stride, ksl_quaternion_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_qq_accurate(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_qq_accurate_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_quaternion_t x_i = ksl_quaternion_of_planes(x + i * x_stride, x_plane);
    ksl_quaternion_t y_i = ksl_quaternion_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_qq_accurate(a[i * a_stride], &x_i, &y_i);
    ksl_quaternion_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_quaternion_norm_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_norm_accurate_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, double *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_quaternion_norm_accurate(q + i * q_stride);
  }
}

static KSL_INLINED void ksl_quaternion_norm_accurate_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *norm, ptrdiff_t norm_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    norm[i * norm_stride] = ksl_quaternion_norm_accurate(&q_i);
  }
}

/* ksl_quaternion_normalize_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_normalize_accurate_many(ptrdiff_t n, ksl_quaternion_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_normalize_accurate(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_quaternion_normalize_accurate_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_t self_i = ksl_quaternion_of_planes(self + i * self_stride, self_plane);
    ksl_quaternion_normalize_accurate(&self_i);
    ksl_quaternion_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_quaternion_normalized_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_normalized_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q, ptrdiff_t q_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_normalized_accurate(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_normalized_accurate_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_normalized_accurate(&q_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_unit_defect_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_unit_defect_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q, ptrdiff_t q_stride, double *defect,
    ptrdiff_t defect_stride) {
  KSL_EACH_OF(n) {
    defect[i * defect_stride] = ksl_quaternion_unit_defect_accurate(q + i * q_stride);
  }
}

static KSL_INLINED void ksl_quaternion_unit_defect_accurate_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *defect,
    ptrdiff_t defect_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    defect[i * defect_stride] = ksl_quaternion_unit_defect_accurate(&q_i);
  }
}

/* ksl_quaternion_nearest_unit_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_nearest_unit_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q, ptrdiff_t q_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_nearest_unit_accurate(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_nearest_unit_accurate_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_nearest_unit_accurate(&q_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_rotate_qv_accurate of n elements. */
static KSL_INLINED void ksl_rotate_qv_accurate_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qv_accurate(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qv_accurate_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_rotate_qv_accurate(&q_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_rotate_qconjv_accurate of n elements. */
static KSL_INLINED void ksl_rotate_qconjv_accurate_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qconjv_accurate(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qconjv_accurate_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_rotate_qconjv_accurate(&q_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_quaternion_product_qq_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qq_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qq_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qq_accurate_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qq_accurate(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqconj_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqconj_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqconj_accurate_planes(ptrdiff_t n,
    const double *q1i, ptrdiff_t q1i_plane, ptrdiff_t q1i_stride,
    const double *q2i, ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqconj_accurate(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjq_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjq_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjq_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjq_accurate_planes(ptrdiff_t n,
    const double *q1i, ptrdiff_t q1i_plane, ptrdiff_t q1i_stride,
    const double *q2i, ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjq_accurate(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqconj_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqconj_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqconj_accurate_planes(ptrdiff_t n,
    const double *q1i, ptrdiff_t q1i_plane, ptrdiff_t q1i_stride,
    const double *q2i, ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqconj_accurate(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxq_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxq_accurate_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxq_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxq_accurate_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxq_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxqconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxqconj_accurate_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxqconj_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxqconj_accurate_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxqconj_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxconjq_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxconjq_accurate_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxconjq_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxconjq_accurate_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxconjq_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxconjqconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxconjqconj_accurate_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxconjqconj_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxconjqconj_accurate_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxconjqconj_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqx_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqx_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqx_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqx_accurate_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqx_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqxconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqxconj_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqxconj_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqxconj_accurate_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqxconj_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqx_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqx_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqx_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqx_accurate_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqx_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqxconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqxconj_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqxconj_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqxconj_accurate_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqxconj_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyq_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyq_accurate_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyq_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyq_accurate_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyq_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyqconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyqconj_accurate_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyqconj_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyqconj_accurate_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyqconj_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyconjq_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyconjq_accurate_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyconjq_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyconjq_accurate_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyconjq_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyconjqconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyconjqconj_accurate_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyconjqconj_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyconjqconj_accurate_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyconjqconj_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqy_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqy_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqy_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqy_accurate_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqy_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqyconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqyconj_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqyconj_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqyconj_accurate_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqyconj_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqy_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqy_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqy_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqy_accurate_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqy_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqyconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqyconj_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqyconj_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqyconj_accurate_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqyconj_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzq_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzq_accurate_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzq_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzq_accurate_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzq_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzqconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzqconj_accurate_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzqconj_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzqconj_accurate_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzqconj_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzconjq_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzconjq_accurate_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzconjq_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzconjq_accurate_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzconjq_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzconjqconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzconjqconj_accurate_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzconjqconj_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzconjqconj_accurate_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzconjqconj_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqz_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqz_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqz_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqz_accurate_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqz_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqzconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqzconj_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqzconj_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqzconj_accurate_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqzconj_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqz_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqz_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqz_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqz_accurate_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqz_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqzconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqzconj_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqzconj_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqzconj_accurate_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqzconj_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qv_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qv_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qv_accurate(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qv_accurate_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qv_accurate(&qi_i, &vi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjv_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjv_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjv_accurate(qi + i * qi_stride, vi + i * vi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjv_accurate_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjv_accurate(&qi_i, &vi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_vq_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_vq_accurate_many(ptrdiff_t n, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_vq_accurate(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_vq_accurate_planes(ptrdiff_t n, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_vq_accurate(&vi_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_vqconj_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_product_vqconj_accurate_many(ptrdiff_t n,
    const ksl_vec3_t *vi, ptrdiff_t vi_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_vqconj_accurate(vi + i * vi_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_vqconj_accurate_planes(ptrdiff_t n, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_vqconj_accurate(&vi_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_dot_qq_accurate of n elements. */
static KSL_INLINED void ksl_dot_qq_accurate_many(ptrdiff_t n, const ksl_quaternion_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride,
    double *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_qq_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride);
  }
}

static KSL_INLINED void ksl_dot_qq_accurate_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *dot, ptrdiff_t dot_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    dot[i * dot_stride] = ksl_dot_qq_accurate(&q1i_i, &q2i_i);
  }
}

/* ksl_add_dpiToq_accurate of n elements. */
static KSL_INLINED void ksl_add_dpiToq_accurate_many(ptrdiff_t n, const ksl_vec3_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternion_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_add_dpiToq_accurate(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_add_dpiToq_accurate_planes(ptrdiff_t n, const double *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_add_dpiToq_accurate(&dpi_i, &qi_i);
    ksl_quaternion_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_subtract_dpiFromq_accurate of n elements. */
static KSL_INLINED void ksl_subtract_dpiFromq_accurate_many(ptrdiff_t n, const ksl_vec3_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternion_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_dpiFromq_accurate(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_subtract_dpiFromq_accurate_planes(ptrdiff_t n, const double *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_subtract_dpiFromq_accurate(&dpi_i, &qi_i);
    ksl_quaternion_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_omega_to_dquaternion_accurate of n elements. */
static KSL_INLINED void ksl_omega_to_dquaternion_accurate_many(ptrdiff_t n, const ksl_vec3_t *w,
    ptrdiff_t w_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *dqo, ptrdiff_t dqo_stride) {
  KSL_EACH_OF(n) {
    ksl_omega_to_dquaternion_accurate(w + i * w_stride, qi + i * qi_stride, dqo + i * dqo_stride);
  }
}

static KSL_INLINED void ksl_omega_to_dquaternion_accurate_planes(ptrdiff_t n, const double *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, double *dqo, ptrdiff_t dqo_plane, ptrdiff_t dqo_stride) {
  ksl_vec3_t w_i;
  if (n > 0) w_i = ksl_vec3_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3_of_planes(w + i * w_stride, w_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t dqo_i;
    ksl_omega_to_dquaternion_accurate(&w_i, &qi_i, &dqo_i);
    ksl_quaternion_to_planes(&dqo_i, dqo + i * dqo_stride, dqo_plane);
  }
}

/* ksl_mat3x3_from_quaternion_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3_from_quaternion_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q, ptrdiff_t q_stride, ksl_mat3x3_t *R,
    ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_from_quaternion_accurate(q + i * q_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_from_quaternion_accurate_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_quaternion_accurate(&q_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_quaternion_from_mat3x3_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_from_mat3x3_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_from_mat3x3_accurate(R + i * R_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_from_mat3x3_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_from_mat3x3_accurate(&R_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_from_axis_angle_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_from_axis_angle_accurate_many(ptrdiff_t n,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, const double *angle,
    ptrdiff_t angle_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_from_axis_angle_accurate(axis + i * axis_stride, angle[i * angle_stride],
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_from_axis_angle_accurate_planes(ptrdiff_t n,
    const double *axis, ptrdiff_t axis_plane, ptrdiff_t axis_stride,
    const double *angle, ptrdiff_t angle_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_from_axis_angle_accurate(&axis_i, angle[i * angle_stride], &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_axis_angle_from_quaternion_accurate of n elements. */
static KSL_INLINED void ksl_axis_angle_from_quaternion_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q, ptrdiff_t q_stride, ksl_vec3_t *axis,
    ptrdiff_t axis_stride, double *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_quaternion_accurate(q + i * q_stride,
        axis + i * axis_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_quaternion_accurate_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *angle, ptrdiff_t angle_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_vec3_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_quaternion_accurate(&q_i, &axis_i);
    ksl_vec3_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
}

/* ksl_quaternion_exp_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_exp_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_exp_accurate(v + i * v_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_exp_accurate_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_exp_accurate(&v_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_log_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_log_accurate_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_log_accurate(q + i * q_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_log_accurate_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_vec3_t vo_i;
    ksl_quaternion_log_accurate(&q_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_quaternion_interpolated_accurate of n elements. */
static KSL_INLINED void ksl_quaternion_interpolated_accurate_many(ptrdiff_t n,
    const ksl_quaternion_t *q1, ptrdiff_t q1_stride, const ksl_quaternion_t *q2,
    ptrdiff_t q2_stride, const double *k, ptrdiff_t k_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_interpolated_accurate(q1 + i * q1_stride, q2 + i * q2_stride, k[i * k_stride],
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_interpolated_accurate_planes(ptrdiff_t n, const double *q1,
    ptrdiff_t q1_plane, ptrdiff_t q1_stride, const double *q2,
    ptrdiff_t q2_plane, ptrdiff_t q2_stride, const double *k, ptrdiff_t k_stride,
    double *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternion_t q1_i;
  if (n > 0) q1_i = ksl_quaternion_of_planes(q1, q1_plane);
  KSL_EACH_OF(n) {
    if (q1_stride) q1_i = ksl_quaternion_of_planes(q1 + i * q1_stride, q1_plane);
    const ksl_quaternion_t q2_i = ksl_quaternion_of_planes(q2 + i * q2_stride, q2_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_interpolated_accurate(&q1_i, &q2_i, k[i * k_stride], &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternionf_scale_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_scale_accurate_many(ptrdiff_t n, ksl_quaternionf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_scale_accurate(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_quaternionf_scale_accurate_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_t self_i = ksl_quaternionf_of_planes(self + i * self_stride, self_plane);
    ksl_quaternionf_scale_accurate(&self_i, a[i * a_stride]);
    ksl_quaternionf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_qqf_accurate of n elements. */
static KSL_INLINED void ksl_axpy_qqf_accurate_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_quaternionf_t *x, ptrdiff_t x_stride, ksl_quaternionf_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_qqf_accurate(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_qqf_accurate_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_quaternionf_t x_i = ksl_quaternionf_of_planes(x + i * x_stride, x_plane);
    ksl_quaternionf_t y_i = ksl_quaternionf_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_qqf_accurate(a[i * a_stride], &x_i, &y_i);
    ksl_quaternionf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_quaternionf_norm_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_norm_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, float *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_quaternionf_norm_accurate(q + i * q_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_norm_accurate_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *norm, ptrdiff_t norm_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    norm[i * norm_stride] = ksl_quaternionf_norm_accurate(&q_i);
  }
}

/* ksl_quaternionf_normalize_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_normalize_accurate_many(ptrdiff_t n,
    ksl_quaternionf_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_normalize_accurate(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_normalize_accurate_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_t self_i = ksl_quaternionf_of_planes(self + i * self_stride, self_plane);
    ksl_quaternionf_normalize_accurate(&self_i);
    ksl_quaternionf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_quaternionf_normalized_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_normalized_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *q, ptrdiff_t q_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_normalized_accurate(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_normalized_accurate_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_normalized_accurate(&q_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternionf_unit_defect_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_unit_defect_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *q, ptrdiff_t q_stride, float *defect,
    ptrdiff_t defect_stride) {
  KSL_EACH_OF(n) {
    defect[i * defect_stride] = ksl_quaternionf_unit_defect_accurate(q + i * q_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_unit_defect_accurate_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *defect,
    ptrdiff_t defect_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    defect[i * defect_stride] = ksl_quaternionf_unit_defect_accurate(&q_i);
  }
}

/* ksl_quaternionf_nearest_unit_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_nearest_unit_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *q, ptrdiff_t q_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_nearest_unit_accurate(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_nearest_unit_accurate_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_nearest_unit_accurate(&q_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_rotate_qvf_accurate of n elements. */
static KSL_INLINED void ksl_rotate_qvf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qvf_accurate(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qvf_accurate_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_rotate_qvf_accurate(&q_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_rotate_qconjvf_accurate of n elements. */
static KSL_INLINED void ksl_rotate_qconjvf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qconjvf_accurate(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qconjvf_accurate_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_rotate_qconjvf_accurate(&q_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_qqf_accurate of n elements. */
static KSL_INLINED void ksl_product_qqf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqf_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqf_accurate_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qqf_accurate(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qqconjf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqconjf_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqconjf_accurate_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qqconjf_accurate(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqf_accurate of n elements. */
static KSL_INLINED void ksl_product_qconjqf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqf_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqf_accurate_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqf_accurate(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qconjqconjf_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqconjf_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqconjf_accurate_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqconjf_accurate(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxqf_accurate of n elements. */
static KSL_INLINED void ksl_product_qxqf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxqf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxqf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxqf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxqconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qxqconjf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxqconjf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxqconjf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxqconjf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxconjqf_accurate of n elements. */
static KSL_INLINED void ksl_product_qxconjqf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxconjqf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxconjqf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxconjqf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxconjqconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qxconjqconjf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxconjqconjf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxconjqconjf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxconjqconjf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqxf_accurate of n elements. */
static KSL_INLINED void ksl_product_qqxf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqxf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqxf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqxf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqxconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qqxconjf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqxconjf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqxconjf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqxconjf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqxf_accurate of n elements. */
static KSL_INLINED void ksl_product_qconjqxf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqxf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqxf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqxf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqxconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qconjqxconjf_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqxconjf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqxconjf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqxconjf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyqf_accurate of n elements. */
static KSL_INLINED void ksl_product_qyqf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyqf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyqf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyqf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyqconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qyqconjf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyqconjf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyqconjf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyqconjf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyconjqf_accurate of n elements. */
static KSL_INLINED void ksl_product_qyconjqf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyconjqf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyconjqf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyconjqf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyconjqconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qyconjqconjf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyconjqconjf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyconjqconjf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyconjqconjf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqyf_accurate of n elements. */
static KSL_INLINED void ksl_product_qqyf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqyf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqyf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqyf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqyconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qqyconjf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqyconjf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqyconjf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqyconjf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqyf_accurate of n elements. */
static KSL_INLINED void ksl_product_qconjqyf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqyf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqyf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqyf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqyconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qconjqyconjf_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqyconjf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqyconjf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqyconjf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzqf_accurate of n elements. */
static KSL_INLINED void ksl_product_qzqf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzqf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzqf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzqf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzqconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qzqconjf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzqconjf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzqconjf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzqconjf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzconjqf_accurate of n elements. */
static KSL_INLINED void ksl_product_qzconjqf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzconjqf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzconjqf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzconjqf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzconjqconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qzconjqconjf_accurate_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzconjqconjf_accurate(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzconjqconjf_accurate_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzconjqconjf_accurate(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqzf_accurate of n elements. */
static KSL_INLINED void ksl_product_qqzf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqzf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqzf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqzf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqzconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qqzconjf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqzconjf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqzconjf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqzconjf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqzf_accurate of n elements. */
static KSL_INLINED void ksl_product_qconjqzf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqzf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqzf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqzf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqzconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_qconjqzconjf_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqzconjf_accurate(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqzconjf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqzconjf_accurate(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qvf_accurate of n elements. */
static KSL_INLINED void ksl_product_qvf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qvf_accurate(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qvf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qvf_accurate(&qi_i, &vi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjvf_accurate of n elements. */
static KSL_INLINED void ksl_product_qconjvf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjvf_accurate(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjvf_accurate_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qconjvf_accurate(&qi_i, &vi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_vqf_accurate of n elements. */
static KSL_INLINED void ksl_product_vqf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_vqf_accurate(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_vqf_accurate_planes(ptrdiff_t n, const float *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_vqf_accurate(&vi_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_vqconjf_accurate of n elements. */
static KSL_INLINED void ksl_product_vqconjf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_vqconjf_accurate(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_vqconjf_accurate_planes(ptrdiff_t n, const float *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_vqconjf_accurate(&vi_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_dot_qqf_accurate of n elements. */
static KSL_INLINED void ksl_dot_qqf_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    float *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_qqf_accurate(q1i + i * q1i_stride, q2i + i * q2i_stride);
  }
}

static KSL_INLINED void ksl_dot_qqf_accurate_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *dot, ptrdiff_t dot_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    dot[i * dot_stride] = ksl_dot_qqf_accurate(&q1i_i, &q2i_i);
  }
}

/* ksl_add_dpiToqf_accurate of n elements. */
static KSL_INLINED void ksl_add_dpiToqf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternionf_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_add_dpiToqf_accurate(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_add_dpiToqf_accurate_planes(ptrdiff_t n, const float *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3f_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3f_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3f_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_add_dpiToqf_accurate(&dpi_i, &qi_i);
    ksl_quaternionf_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_subtract_dpiFromqf_accurate of n elements. */
static KSL_INLINED void ksl_subtract_dpiFromqf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternionf_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_dpiFromqf_accurate(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_subtract_dpiFromqf_accurate_planes(ptrdiff_t n, const float *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3f_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3f_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3f_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_subtract_dpiFromqf_accurate(&dpi_i, &qi_i);
    ksl_quaternionf_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_omega_to_dquaternionf_accurate of n elements. */
static KSL_INLINED void ksl_omega_to_dquaternionf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *w,
    ptrdiff_t w_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *dqo, ptrdiff_t dqo_stride) {
  KSL_EACH_OF(n) {
    ksl_omega_to_dquaternionf_accurate(w + i * w_stride, qi + i * qi_stride, dqo + i * dqo_stride);
  }
}

static KSL_INLINED void ksl_omega_to_dquaternionf_accurate_planes(ptrdiff_t n, const float *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *dqo, ptrdiff_t dqo_plane, ptrdiff_t dqo_stride) {
  ksl_vec3f_t w_i;
  if (n > 0) w_i = ksl_vec3f_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3f_of_planes(w + i * w_stride, w_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t dqo_i;
    ksl_omega_to_dquaternionf_accurate(&w_i, &qi_i, &dqo_i);
    ksl_quaternionf_to_planes(&dqo_i, dqo + i * dqo_stride, dqo_plane);
  }
}

/* ksl_mat3x3f_from_quaternion_accurate of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_quaternion_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *q, ptrdiff_t q_stride, ksl_mat3x3f_t *R,
    ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_from_quaternion_accurate(q + i * q_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_from_quaternion_accurate_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_quaternion_accurate(&q_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_quaternionf_from_mat3x3_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_from_mat3x3_accurate_many(ptrdiff_t n,
    const ksl_mat3x3f_t *R, ptrdiff_t R_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_from_mat3x3_accurate(R + i * R_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_from_mat3x3_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_from_mat3x3_accurate(&R_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternionf_from_axis_angle_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_from_axis_angle_accurate_many(ptrdiff_t n,
    const ksl_vec3f_t *axis, ptrdiff_t axis_stride, const float *angle,
    ptrdiff_t angle_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_from_axis_angle_accurate(axis + i * axis_stride, angle[i * angle_stride],
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_from_axis_angle_accurate_planes(ptrdiff_t n,
    const float *axis, ptrdiff_t axis_plane, ptrdiff_t axis_stride,
    const float *angle, ptrdiff_t angle_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_from_axis_angle_accurate(&axis_i, angle[i * angle_stride], &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_axis_angle_from_quaternionf_accurate of n elements. */
static KSL_INLINED void ksl_axis_angle_from_quaternionf_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *q, ptrdiff_t q_stride, ksl_vec3f_t *axis,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_quaternionf_accurate(q + i * q_stride,
        axis + i * axis_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_quaternionf_accurate_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_vec3f_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_quaternionf_accurate(&q_i, &axis_i);
    ksl_vec3f_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
}

/* ksl_quaternionf_exp_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_exp_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_exp_accurate(v + i * v_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_exp_accurate_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_exp_accurate(&v_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternionf_log_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_log_accurate_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_log_accurate(q + i * q_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_log_accurate_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_vec3f_t vo_i;
    ksl_quaternionf_log_accurate(&q_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_quaternionf_interpolated_accurate of n elements. */
static KSL_INLINED void ksl_quaternionf_interpolated_accurate_many(ptrdiff_t n,
    const ksl_quaternionf_t *q1, ptrdiff_t q1_stride,
    const ksl_quaternionf_t *q2, ptrdiff_t q2_stride, const float *k,
    ptrdiff_t k_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_interpolated_accurate(q1 + i * q1_stride, q2 + i * q2_stride, k[i * k_stride],
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_interpolated_accurate_planes(ptrdiff_t n, const float *q1,
    ptrdiff_t q1_plane, ptrdiff_t q1_stride, const float *q2, ptrdiff_t q2_plane,
    ptrdiff_t q2_stride, const float *k, ptrdiff_t k_stride, float *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1_i;
  if (n > 0) q1_i = ksl_quaternionf_of_planes(q1, q1_plane);
  KSL_EACH_OF(n) {
    if (q1_stride) q1_i = ksl_quaternionf_of_planes(q1 + i * q1_stride, q1_plane);
    const ksl_quaternionf_t q2_i = ksl_quaternionf_of_planes(q2 + i * q2_stride, q2_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_interpolated_accurate(&q1_i, &q2_i, k[i * k_stride], &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

#endif
