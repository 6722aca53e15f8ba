/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_QUATERNION_CERTIFIED_MANY_H
#define KSL_QUATERNION_CERTIFIED_MANY_H

#include "quaternion_certified.h"
#include "ksl_planes.h"

/* ksl_quaternion_scale_certified of n elements. */
static KSL_INLINED void ksl_quaternion_scale_certified_many(ptrdiff_t n, ksl_quaternion_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride,
    ksl_quaternion_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_scale_certified(self + i * self_stride, a[i * a_stride],
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_scale_certified_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride, double *self_bound, ptrdiff_t self_bound_plane,
    ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_t self_i = ksl_quaternion_of_planes(self + i * self_stride, self_plane);
    ksl_quaternion_t self_bound_i;
    ksl_quaternion_scale_certified(&self_i, a[i * a_stride], &self_bound_i);
    ksl_quaternion_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_quaternion_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_axpy_qq_certified of n elements. */
static KSL_INLINED void ksl_axpy_qq_certified_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_quaternion_t *x, ptrdiff_t x_stride, ksl_quaternion_t *y,
    ptrdiff_t y_stride, ksl_quaternion_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_qq_certified(a[i * a_stride], x + i * x_stride, y + i * y_stride,
        y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_axpy_qq_certified_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    double *y, ptrdiff_t y_plane, ptrdiff_t y_stride, double *y_bound,
    ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_quaternion_t x_i = ksl_quaternion_of_planes(x + i * x_stride, x_plane);
    ksl_quaternion_t y_i = ksl_quaternion_of_planes(y + i * y_stride, y_plane);
    ksl_quaternion_t y_bound_i;
    ksl_axpy_qq_certified(a[i * a_stride], &x_i, &y_i, &y_bound_i);
    ksl_quaternion_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_quaternion_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_rotate_qv_certified of n elements. */
static KSL_INLINED void ksl_rotate_qv_certified_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qv_certified(q + i * q_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_rotate_qv_certified_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    double *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_rotate_qv_certified(&q_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_rotate_qconjv_certified of n elements. */
static KSL_INLINED void ksl_rotate_qconjv_certified_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qconjv_certified(q + i * q_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_rotate_qconjv_certified_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    double *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_rotate_qconjv_certified(&q_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_quaternion_product_qq_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qq_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride, ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qq_certified(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qq_certified_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qq_certified(&q1i_i, &q2i_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qqconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqconj_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride, ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqconj_certified(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqconj_certified_planes(ptrdiff_t n,
    const double *q1i, ptrdiff_t q1i_plane, ptrdiff_t q1i_stride,
    const double *q2i, ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qqconj_certified(&q1i_i, &q2i_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qconjq_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjq_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride, ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjq_certified(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjq_certified_planes(ptrdiff_t n,
    const double *q1i, ptrdiff_t q1i_plane, ptrdiff_t q1i_stride,
    const double *q2i, ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qconjq_certified(&q1i_i, &q2i_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qconjqconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqconj_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride, ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqconj_certified(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqconj_certified_planes(ptrdiff_t n,
    const double *q1i, ptrdiff_t q1i_plane, ptrdiff_t q1i_stride,
    const double *q2i, ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qconjqconj_certified(&q1i_i, &q2i_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qxq_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxq_certified_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride, ksl_quaternion_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxq_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxq_certified_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qxq_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qxqconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxqconj_certified_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxqconj_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxqconj_certified_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qxqconj_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qxconjq_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxconjq_certified_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxconjq_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxconjq_certified_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qxconjq_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qxconjqconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxconjqconj_certified_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxconjqconj_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxconjqconj_certified_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qxconjqconj_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qqx_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqx_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqx_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqx_certified_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qqx_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qqxconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqxconj_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqxconj_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqxconj_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qqxconj_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qconjqx_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqx_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqx_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqx_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qconjqx_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qconjqxconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqxconj_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqxconj_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqxconj_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qconjqxconj_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qyq_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyq_certified_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride, ksl_quaternion_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyq_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyq_certified_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qyq_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qyqconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyqconj_certified_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyqconj_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyqconj_certified_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qyqconj_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qyconjq_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyconjq_certified_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyconjq_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyconjq_certified_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qyconjq_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qyconjqconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyconjqconj_certified_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyconjqconj_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyconjqconj_certified_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qyconjqconj_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qqy_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqy_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqy_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqy_certified_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qqy_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qqyconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqyconj_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqyconj_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqyconj_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qqyconj_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qconjqy_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqy_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqy_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqy_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qconjqy_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qconjqyconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqyconj_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqyconj_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqyconj_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qconjqyconj_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qzq_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzq_certified_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride, ksl_quaternion_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzq_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzq_certified_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qzq_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qzqconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzqconj_certified_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzqconj_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzqconj_certified_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qzqconj_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qzconjq_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzconjq_certified_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzconjq_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzconjq_certified_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qzconjq_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qzconjqconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzconjqconj_certified_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzconjqconj_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzconjqconj_certified_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride, double *qo_bound,
    ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qzconjqconj_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qqz_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqz_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqz_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqz_certified_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qqz_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qqzconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqzconj_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqzconj_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqzconj_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qqzconj_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qconjqz_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqz_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqz_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqz_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qconjqz_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qconjqzconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqzconj_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqzconj_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqzconj_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qconjqzconj_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qv_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qv_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qv_certified(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qv_certified_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qv_certified(&qi_i, &vi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_qconjv_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjv_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjv_certified(qi + i * qi_stride, vi + i * vi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjv_certified_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_qconjv_certified(&qi_i, &vi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_vq_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_vq_certified_many(ptrdiff_t n, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride, ksl_quaternion_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_vq_certified(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_vq_certified_planes(ptrdiff_t n, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_vq_certified(&vi_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_product_vqconj_certified of n elements. */
static KSL_INLINED void ksl_quaternion_product_vqconj_certified_many(ptrdiff_t n,
    const ksl_vec3_t *vi, ptrdiff_t vi_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_vqconj_certified(vi + i * vi_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_vqconj_certified_planes(ptrdiff_t n,
    const double *vi, ptrdiff_t vi_plane, ptrdiff_t vi_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_product_vqconj_certified(&vi_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_dot_qq_certified of n elements. */
static KSL_INLINED void ksl_dot_qq_certified_many(ptrdiff_t n, const ksl_quaternion_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride,
    double *dot_bound, ptrdiff_t dot_bound_stride, double *dot,
    ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_qq_certified(q1i + i * q1i_stride, q2i + i * q2i_stride,
        dot_bound + i * dot_bound_stride);
  }
}

static KSL_INLINED void ksl_dot_qq_certified_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *dot_bound,
    ptrdiff_t dot_bound_stride, double *dot, ptrdiff_t dot_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    dot[i * dot_stride] = ksl_dot_qq_certified(&q1i_i, &q2i_i, dot_bound + i * dot_bound_stride);
  }
}

/* ksl_add_dpiToq_certified of n elements. */
static KSL_INLINED void ksl_add_dpiToq_certified_many(ptrdiff_t n, const ksl_vec3_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qi_bound, ptrdiff_t qi_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_dpiToq_certified(dpi + i * dpi_stride, qi + i * qi_stride,
        qi_bound + i * qi_bound_stride);
  }
}

static KSL_INLINED void ksl_add_dpiToq_certified_planes(ptrdiff_t n, const double *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, double *qi_bound, ptrdiff_t qi_bound_plane,
    ptrdiff_t qi_bound_stride) {
  ksl_vec3_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qi_bound_i;
    ksl_add_dpiToq_certified(&dpi_i, &qi_i, &qi_bound_i);
    ksl_quaternion_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
    ksl_quaternion_to_planes(&qi_bound_i, qi_bound + i * qi_bound_stride, qi_bound_plane);
  }
}

/* ksl_subtract_dpiFromq_certified of n elements. */
static KSL_INLINED void ksl_subtract_dpiFromq_certified_many(ptrdiff_t n, const ksl_vec3_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qi_bound, ptrdiff_t qi_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_dpiFromq_certified(dpi + i * dpi_stride, qi + i * qi_stride,
        qi_bound + i * qi_bound_stride);
  }
}

static KSL_INLINED void ksl_subtract_dpiFromq_certified_planes(ptrdiff_t n, const double *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, double *qi_bound, ptrdiff_t qi_bound_plane,
    ptrdiff_t qi_bound_stride) {
  ksl_vec3_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qi_bound_i;
    ksl_subtract_dpiFromq_certified(&dpi_i, &qi_i, &qi_bound_i);
    ksl_quaternion_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
    ksl_quaternion_to_planes(&qi_bound_i, qi_bound + i * qi_bound_stride, qi_bound_plane);
  }
}

/* ksl_omega_to_dquaternion_certified of n elements. */
static KSL_INLINED void ksl_omega_to_dquaternion_certified_many(ptrdiff_t n, const ksl_vec3_t *w,
    ptrdiff_t w_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *dqo, ptrdiff_t dqo_stride, ksl_quaternion_t *dqo_bound,
    ptrdiff_t dqo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_omega_to_dquaternion_certified(w + i * w_stride, qi + i * qi_stride, dqo + i * dqo_stride,
        dqo_bound + i * dqo_bound_stride);
  }
}

static KSL_INLINED void ksl_omega_to_dquaternion_certified_planes(ptrdiff_t n, const double *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, double *dqo, ptrdiff_t dqo_plane, ptrdiff_t dqo_stride,
    double *dqo_bound, ptrdiff_t dqo_bound_plane, ptrdiff_t dqo_bound_stride) {
  ksl_vec3_t w_i;
  if (n > 0) w_i = ksl_vec3_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3_of_planes(w + i * w_stride, w_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t dqo_i;
    ksl_quaternion_t dqo_bound_i;
    ksl_omega_to_dquaternion_certified(&w_i, &qi_i, &dqo_i, &dqo_bound_i);
    ksl_quaternion_to_planes(&dqo_i, dqo + i * dqo_stride, dqo_plane);
    ksl_quaternion_to_planes(&dqo_bound_i, dqo_bound + i * dqo_bound_stride, dqo_bound_plane);
  }
}

/* ksl_quaternion_from_axis_angle_certified of n elements. */
static KSL_INLINED void ksl_quaternion_from_axis_angle_certified_many(ptrdiff_t n,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, const double *angle,
    ptrdiff_t angle_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_from_axis_angle_certified(axis + i * axis_stride, angle[i * angle_stride],
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_from_axis_angle_certified_planes(ptrdiff_t n,
    const double *axis, ptrdiff_t axis_plane, ptrdiff_t axis_stride,
    const double *angle, ptrdiff_t angle_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_from_axis_angle_certified(&axis_i, angle[i * angle_stride], &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_axis_angle_from_quaternion_certified of n elements. */
static KSL_INLINED void ksl_axis_angle_from_quaternion_certified_many(ptrdiff_t n,
    const ksl_quaternion_t *q, ptrdiff_t q_stride, ksl_vec3_t *axis,
    ptrdiff_t axis_stride, double *angle_bound, ptrdiff_t angle_bound_stride,
    ksl_vec3_t *axis_bound, ptrdiff_t axis_bound_stride, double *angle,
    ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_quaternion_certified(q + i * q_stride,
        axis + i * axis_stride, angle_bound + i * angle_bound_stride,
        axis_bound + i * axis_bound_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_quaternion_certified_planes(ptrdiff_t n,
    const double *q, ptrdiff_t q_plane, ptrdiff_t q_stride, double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, double *angle_bound,
    ptrdiff_t angle_bound_stride, double *axis_bound, ptrdiff_t axis_bound_plane,
    ptrdiff_t axis_bound_stride, double *angle, ptrdiff_t angle_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_vec3_t axis_i;
    ksl_vec3_t axis_bound_i;
    angle[i * angle_stride] = ksl_axis_angle_from_quaternion_certified(&q_i, &axis_i,
        angle_bound + i * angle_bound_stride, &axis_bound_i);
    ksl_vec3_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
    ksl_vec3_to_planes(&axis_bound_i, axis_bound + i * axis_bound_stride, axis_bound_plane);
  }
}

/* ksl_quaternion_exp_certified of n elements. */
static KSL_INLINED void ksl_quaternion_exp_certified_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride,
    ksl_quaternion_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_exp_certified(v + i * v_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_exp_certified_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, double *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_t qo_bound_i;
    ksl_quaternion_exp_certified(&v_i, &qo_i, &qo_bound_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternion_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternion_log_certified of n elements. */
static KSL_INLINED void ksl_quaternion_log_certified_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride,
    ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_log_certified(q + i * q_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternion_log_certified_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride, double *vo_bound, ptrdiff_t vo_bound_plane,
    ptrdiff_t vo_bound_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_quaternion_log_certified(&q_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_quaternionf_scale_certified of n elements. */
static KSL_INLINED void ksl_quaternionf_scale_certified_many(ptrdiff_t n, ksl_quaternionf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride,
    ksl_quaternionf_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_scale_certified(self + i * self_stride, a[i * a_stride],
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_scale_certified_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride, float *self_bound, ptrdiff_t self_bound_plane,
    ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_t self_i = ksl_quaternionf_of_planes(self + i * self_stride, self_plane);
    ksl_quaternionf_t self_bound_i;
    ksl_quaternionf_scale_certified(&self_i, a[i * a_stride], &self_bound_i);
    ksl_quaternionf_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_quaternionf_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_axpy_qqf_certified of n elements. */
static KSL_INLINED void ksl_axpy_qqf_certified_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_quaternionf_t *x, ptrdiff_t x_stride, ksl_quaternionf_t *y,
    ptrdiff_t y_stride, ksl_quaternionf_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_qqf_certified(a[i * a_stride], x + i * x_stride, y + i * y_stride,
        y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_axpy_qqf_certified_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    float *y, ptrdiff_t y_plane, ptrdiff_t y_stride, float *y_bound,
    ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_quaternionf_t x_i = ksl_quaternionf_of_planes(x + i * x_stride, x_plane);
    ksl_quaternionf_t y_i = ksl_quaternionf_of_planes(y + i * y_stride, y_plane);
    ksl_quaternionf_t y_bound_i;
    ksl_axpy_qqf_certified(a[i * a_stride], &x_i, &y_i, &y_bound_i);
    ksl_quaternionf_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_quaternionf_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_rotate_qvf_certified of n elements. */
static KSL_INLINED void ksl_rotate_qvf_certified_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound,
    ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qvf_certified(q + i * q_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_rotate_qvf_certified_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    float *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_rotate_qvf_certified(&q_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_rotate_qconjvf_certified of n elements. */
static KSL_INLINED void ksl_rotate_qconjvf_certified_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound,
    ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qconjvf_certified(q + i * q_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_rotate_qconjvf_certified_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    float *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_rotate_qconjvf_certified(&q_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_qqf_certified of n elements. */
static KSL_INLINED void ksl_product_qqf_certified_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqf_certified(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qqf_certified_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qqf_certified(&q1i_i, &q2i_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qqconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qqconjf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqconjf_certified(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qqconjf_certified_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qqconjf_certified(&q1i_i, &q2i_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qconjqf_certified of n elements. */
static KSL_INLINED void ksl_product_qconjqf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqf_certified(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqf_certified_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qconjqf_certified(&q1i_i, &q2i_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qconjqconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qconjqconjf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqconjf_certified(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqconjf_certified_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qconjqconjf_certified(&q1i_i, &q2i_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qxqf_certified of n elements. */
static KSL_INLINED void ksl_product_qxqf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxqf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qxqf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qxqf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qxqconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qxqconjf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxqconjf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qxqconjf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qxqconjf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qxconjqf_certified of n elements. */
static KSL_INLINED void ksl_product_qxconjqf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxconjqf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qxconjqf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qxconjqf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qxconjqconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qxconjqconjf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxconjqconjf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qxconjqconjf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qxconjqconjf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qqxf_certified of n elements. */
static KSL_INLINED void ksl_product_qqxf_certified_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqxf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qqxf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qqxf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qqxconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qqxconjf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqxconjf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qqxconjf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qqxconjf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qconjqxf_certified of n elements. */
static KSL_INLINED void ksl_product_qconjqxf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqxf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqxf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qconjqxf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qconjqxconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qconjqxconjf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqxconjf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqxconjf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qconjqxconjf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qyqf_certified of n elements. */
static KSL_INLINED void ksl_product_qyqf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyqf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qyqf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qyqf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qyqconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qyqconjf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyqconjf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qyqconjf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qyqconjf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qyconjqf_certified of n elements. */
static KSL_INLINED void ksl_product_qyconjqf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyconjqf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qyconjqf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qyconjqf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qyconjqconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qyconjqconjf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyconjqconjf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qyconjqconjf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qyconjqconjf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qqyf_certified of n elements. */
static KSL_INLINED void ksl_product_qqyf_certified_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqyf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qqyf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qqyf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qqyconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qqyconjf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqyconjf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qqyconjf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qqyconjf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qconjqyf_certified of n elements. */
static KSL_INLINED void ksl_product_qconjqyf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqyf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqyf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qconjqyf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qconjqyconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qconjqyconjf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqyconjf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqyconjf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qconjqyconjf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qzqf_certified of n elements. */
static KSL_INLINED void ksl_product_qzqf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzqf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qzqf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qzqf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qzqconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qzqconjf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzqconjf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qzqconjf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qzqconjf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qzconjqf_certified of n elements. */
static KSL_INLINED void ksl_product_qzconjqf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzconjqf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qzconjqf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qzconjqf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qzconjqconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qzconjqconjf_certified_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzconjqconjf_certified(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qzconjqconjf_certified_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qzconjqconjf_certified(dci_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qqzf_certified of n elements. */
static KSL_INLINED void ksl_product_qqzf_certified_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqzf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qqzf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qqzf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qqzconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qqzconjf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqzconjf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qqzconjf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qqzconjf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qconjqzf_certified of n elements. */
static KSL_INLINED void ksl_product_qconjqzf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqzf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqzf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qconjqzf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qconjqzconjf_certified of n elements. */
static KSL_INLINED void ksl_product_qconjqzconjf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqzconjf_certified(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqzconjf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qconjqzconjf_certified(&qi_i, dci_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qvf_certified of n elements. */
static KSL_INLINED void ksl_product_qvf_certified_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qvf_certified(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qvf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride,
    float *qo_bound, ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qvf_certified(&qi_i, &vi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_qconjvf_certified of n elements. */
static KSL_INLINED void ksl_product_qconjvf_certified_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjvf_certified(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_qconjvf_certified_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride,
    float *qo_bound, ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_qconjvf_certified(&qi_i, &vi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_vqf_certified of n elements. */
static KSL_INLINED void ksl_product_vqf_certified_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_vqf_certified(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_vqf_certified_planes(ptrdiff_t n, const float *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride,
    float *qo_bound, ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_vqf_certified(&vi_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_product_vqconjf_certified of n elements. */
static KSL_INLINED void ksl_product_vqconjf_certified_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride, ksl_quaternionf_t *qo_bound,
    ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_vqconjf_certified(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_vqconjf_certified_planes(ptrdiff_t n, const float *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride,
    float *qo_bound, ptrdiff_t qo_bound_plane, ptrdiff_t qo_bound_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_product_vqconjf_certified(&vi_i, &qi_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_dot_qqf_certified of n elements. */
static KSL_INLINED void ksl_dot_qqf_certified_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    float *dot_bound, ptrdiff_t dot_bound_stride, float *dot,
    ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_qqf_certified(q1i + i * q1i_stride, q2i + i * q2i_stride,
        dot_bound + i * dot_bound_stride);
  }
}

static KSL_INLINED void ksl_dot_qqf_certified_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *dot_bound,
    ptrdiff_t dot_bound_stride, float *dot, ptrdiff_t dot_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    dot[i * dot_stride] = ksl_dot_qqf_certified(&q1i_i, &q2i_i, dot_bound + i * dot_bound_stride);
  }
}

/* ksl_add_dpiToqf_certified of n elements. */
static KSL_INLINED void ksl_add_dpiToqf_certified_many(ptrdiff_t n, const ksl_vec3f_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qi_bound, ptrdiff_t qi_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_dpiToqf_certified(dpi + i * dpi_stride, qi + i * qi_stride,
        qi_bound + i * qi_bound_stride);
  }
}

static KSL_INLINED void ksl_add_dpiToqf_certified_planes(ptrdiff_t n, const float *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qi_bound, ptrdiff_t qi_bound_plane,
    ptrdiff_t qi_bound_stride) {
  ksl_vec3f_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3f_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3f_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qi_bound_i;
    ksl_add_dpiToqf_certified(&dpi_i, &qi_i, &qi_bound_i);
    ksl_quaternionf_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
    ksl_quaternionf_to_planes(&qi_bound_i, qi_bound + i * qi_bound_stride, qi_bound_plane);
  }
}

/* ksl_subtract_dpiFromqf_certified of n elements. */
static KSL_INLINED void ksl_subtract_dpiFromqf_certified_many(ptrdiff_t n, const ksl_vec3f_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qi_bound, ptrdiff_t qi_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_dpiFromqf_certified(dpi + i * dpi_stride, qi + i * qi_stride,
        qi_bound + i * qi_bound_stride);
  }
}

static KSL_INLINED void ksl_subtract_dpiFromqf_certified_planes(ptrdiff_t n, const float *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qi_bound, ptrdiff_t qi_bound_plane,
    ptrdiff_t qi_bound_stride) {
  ksl_vec3f_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3f_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3f_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qi_bound_i;
    ksl_subtract_dpiFromqf_certified(&dpi_i, &qi_i, &qi_bound_i);
    ksl_quaternionf_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
    ksl_quaternionf_to_planes(&qi_bound_i, qi_bound + i * qi_bound_stride, qi_bound_plane);
  }
}

/* ksl_omega_to_dquaternionf_certified of n elements. */
static KSL_INLINED void ksl_omega_to_dquaternionf_certified_many(ptrdiff_t n, const ksl_vec3f_t *w,
    ptrdiff_t w_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *dqo, ptrdiff_t dqo_stride, ksl_quaternionf_t *dqo_bound,
    ptrdiff_t dqo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_omega_to_dquaternionf_certified(w + i * w_stride, qi + i * qi_stride, dqo + i * dqo_stride,
        dqo_bound + i * dqo_bound_stride);
  }
}

static KSL_INLINED void ksl_omega_to_dquaternionf_certified_planes(ptrdiff_t n, const float *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *dqo, ptrdiff_t dqo_plane, ptrdiff_t dqo_stride,
    float *dqo_bound, ptrdiff_t dqo_bound_plane, ptrdiff_t dqo_bound_stride) {
  ksl_vec3f_t w_i;
  if (n > 0) w_i = ksl_vec3f_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3f_of_planes(w + i * w_stride, w_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t dqo_i;
    ksl_quaternionf_t dqo_bound_i;
    ksl_omega_to_dquaternionf_certified(&w_i, &qi_i, &dqo_i, &dqo_bound_i);
    ksl_quaternionf_to_planes(&dqo_i, dqo + i * dqo_stride, dqo_plane);
    ksl_quaternionf_to_planes(&dqo_bound_i, dqo_bound + i * dqo_bound_stride, dqo_bound_plane);
  }
}

/* ksl_quaternionf_from_axis_angle_certified of n elements. */
static KSL_INLINED void ksl_quaternionf_from_axis_angle_certified_many(ptrdiff_t n,
    const ksl_vec3f_t *axis, ptrdiff_t axis_stride, const float *angle,
    ptrdiff_t angle_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_from_axis_angle_certified(axis + i * axis_stride, angle[i * angle_stride],
        qo + i * qo_stride, qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_from_axis_angle_certified_planes(ptrdiff_t n,
    const float *axis, ptrdiff_t axis_plane, ptrdiff_t axis_stride,
    const float *angle, ptrdiff_t angle_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_quaternionf_from_axis_angle_certified(&axis_i, angle[i * angle_stride], &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_axis_angle_from_quaternionf_certified of n elements. */
static KSL_INLINED void ksl_axis_angle_from_quaternionf_certified_many(ptrdiff_t n,
    const ksl_quaternionf_t *q, ptrdiff_t q_stride, ksl_vec3f_t *axis,
    ptrdiff_t axis_stride, float *angle_bound, ptrdiff_t angle_bound_stride,
    ksl_vec3f_t *axis_bound, ptrdiff_t axis_bound_stride, float *angle,
    ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_quaternionf_certified(q + i * q_stride,
        axis + i * axis_stride, angle_bound + i * angle_bound_stride,
        axis_bound + i * axis_bound_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_quaternionf_certified_planes(ptrdiff_t n,
    const float *q, ptrdiff_t q_plane, ptrdiff_t q_stride, float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, float *angle_bound,
    ptrdiff_t angle_bound_stride, float *axis_bound, ptrdiff_t axis_bound_plane,
    ptrdiff_t axis_bound_stride, float *angle, ptrdiff_t angle_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_vec3f_t axis_i;
    ksl_vec3f_t axis_bound_i;
    angle[i * angle_stride] = ksl_axis_angle_from_quaternionf_certified(&q_i, &axis_i,
        angle_bound + i * angle_bound_stride, &axis_bound_i);
    ksl_vec3f_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
    ksl_vec3f_to_planes(&axis_bound_i, axis_bound + i * axis_bound_stride, axis_bound_plane);
  }
}

/* ksl_quaternionf_exp_certified of n elements. */
static KSL_INLINED void ksl_quaternionf_exp_certified_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride,
    ksl_quaternionf_t *qo_bound, ptrdiff_t qo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_exp_certified(v + i * v_stride, qo + i * qo_stride,
        qo_bound + i * qo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_exp_certified_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride, float *qo_bound, ptrdiff_t qo_bound_plane,
    ptrdiff_t qo_bound_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_t qo_bound_i;
    ksl_quaternionf_exp_certified(&v_i, &qo_i, &qo_bound_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
    ksl_quaternionf_to_planes(&qo_bound_i, qo_bound + i * qo_bound_stride, qo_bound_plane);
  }
}

/* ksl_quaternionf_log_certified of n elements. */
static KSL_INLINED void ksl_quaternionf_log_certified_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride,
    ksl_vec3f_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_log_certified(q + i * q_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_log_certified_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride, float *vo_bound, ptrdiff_t vo_bound_plane,
    ptrdiff_t vo_bound_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_quaternionf_log_certified(&q_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

#endif
