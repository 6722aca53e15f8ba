/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_QUATERNION_MANY_H
#define KSL_QUATERNION_MANY_H

#include "quaternion.h"
#include "ksl_planes.h"

/* ksl_quaternion_copy of n elements. */
static KSL_INLINED void ksl_quaternion_copy_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_copy(qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_copy_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_copy(&qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_scale of n elements. */
static KSL_INLINED void ksl_quaternion_scale_many(ptrdiff_t n, ksl_quaternion_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_quaternion_scale_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_t self_i = ksl_quaternion_of_planes(self + i * self_stride, self_plane);
    ksl_quaternion_scale(&self_i, a[i * a_stride]);
    ksl_quaternion_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_qq of n elements. */
static KSL_INLINED void ksl_axpy_qq_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_quaternion_t *x, ptrdiff_t x_stride, ksl_quaternion_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_qq(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_qq_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_quaternion_t x_i = ksl_quaternion_of_planes(x + i * x_stride, x_plane);
    ksl_quaternion_t y_i = ksl_quaternion_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_qq(a[i * a_stride], &x_i, &y_i);
    ksl_quaternion_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_quaternion_setIdentity of n elements. */
static KSL_INLINED void ksl_quaternion_setIdentity_many(ptrdiff_t n, ksl_quaternion_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_quaternion_setIdentity_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_t self_i = ksl_quaternion_of_planes(self + i * self_stride, self_plane);
    ksl_quaternion_setIdentity(&self_i);
    ksl_quaternion_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_quaternion_conjugated of n elements. */
static KSL_INLINED void ksl_quaternion_conjugated_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_conjugated(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_conjugated_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_conjugated(&q_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_norm of n elements. */
static KSL_INLINED void ksl_quaternion_norm_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, double *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_quaternion_norm(q + i * q_stride);
  }
}

static KSL_INLINED void ksl_quaternion_norm_planes(ptrdiff_t n, const double *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, double *norm, ptrdiff_t norm_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    norm[i * norm_stride] = ksl_quaternion_norm(&q_i);
  }
}

/* ksl_quaternion_normalize of n elements. */
static KSL_INLINED void ksl_quaternion_normalize_many(ptrdiff_t n, ksl_quaternion_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_quaternion_normalize_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_t self_i = ksl_quaternion_of_planes(self + i * self_stride, self_plane);
    ksl_quaternion_normalize(&self_i);
    ksl_quaternion_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_quaternion_normalized of n elements. */
static KSL_INLINED void ksl_quaternion_normalized_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_normalized(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_normalized_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_normalized(&q_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_rotate_qv of n elements. */
static KSL_INLINED void ksl_rotate_qv_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qv(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qv_planes(ptrdiff_t n, const double *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_rotate_qv(&q_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_rotate_qconjv of n elements. */
static KSL_INLINED void ksl_rotate_qconjv_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qconjv(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qconjv_planes(ptrdiff_t n, const double *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_rotate_qconjv(&q_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_quaternion_product_qq of n elements. */
static KSL_INLINED void ksl_quaternion_product_qq_many(ptrdiff_t n, const ksl_quaternion_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qq(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qq_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qq(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqconj_many(ptrdiff_t n, const ksl_quaternion_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqconj(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqconj_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqconj(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjq of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjq_many(ptrdiff_t n, const ksl_quaternion_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjq(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjq_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjq(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqconj_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqconj(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqconj_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqconj(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxq of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxq_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxq(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxq_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxq(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxqconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxqconj_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxqconj(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxqconj_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxqconj(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxconjq of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxconjq_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxconjq(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxconjq_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxconjq(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxconjqconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxconjqconj_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxconjqconj(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxconjqconj_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxconjqconj(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqx of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqx_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const double *dci, ptrdiff_t dci_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqx(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqx_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqx(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqxconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqxconj_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const double *dci, ptrdiff_t dci_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqxconj(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqxconj_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqxconj(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqx of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqx_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const double *dci, ptrdiff_t dci_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqx(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqx_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqx(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqxconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqxconj_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqxconj(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqxconj_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqxconj(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyq of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyq_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyq(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyq_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyq(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyqconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyqconj_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyqconj(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyqconj_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyqconj(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyconjq of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyconjq_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyconjq(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyconjq_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyconjq(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyconjqconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyconjqconj_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyconjqconj(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyconjqconj_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyconjqconj(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqy of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqy_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const double *dci, ptrdiff_t dci_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqy(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqy_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqy(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqyconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqyconj_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const double *dci, ptrdiff_t dci_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqyconj(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqyconj_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqyconj(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqy of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqy_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const double *dci, ptrdiff_t dci_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqy(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqy_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqy(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqyconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqyconj_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqyconj(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqyconj_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqyconj(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzq of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzq_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzq(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzq_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzq(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzqconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzqconj_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzqconj(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzqconj_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzqconj(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzconjq of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzconjq_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzconjq(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzconjq_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzconjq(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzconjqconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzconjqconj_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzconjqconj(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzconjqconj_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzconjqconj(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqz of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqz_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const double *dci, ptrdiff_t dci_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqz(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqz_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqz(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqzconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqzconj_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const double *dci, ptrdiff_t dci_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqzconj(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqzconj_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqzconj(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqz of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqz_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const double *dci, ptrdiff_t dci_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqz(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqz_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqz(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqzconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqzconj_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqzconj(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqzconj_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqzconj(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qv of n elements. */
static KSL_INLINED void ksl_quaternion_product_qv_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3_t *vi, ptrdiff_t vi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qv(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qv_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qv(&qi_i, &vi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjv of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjv_many(ptrdiff_t n, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3_t *vi, ptrdiff_t vi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjv(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjv_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjv(&qi_i, &vi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_vq of n elements. */
static KSL_INLINED void ksl_quaternion_product_vq_many(ptrdiff_t n, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_vq(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_vq_planes(ptrdiff_t n, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_vq(&vi_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_vqconj of n elements. */
static KSL_INLINED void ksl_quaternion_product_vqconj_many(ptrdiff_t n, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_vqconj(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_vqconj_planes(ptrdiff_t n, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_vqconj(&vi_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_dot_qq of n elements. */
static KSL_INLINED void ksl_dot_qq_many(ptrdiff_t n, const ksl_quaternion_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride,
    double *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_qq(q1i + i * q1i_stride, q2i + i * q2i_stride);
  }
}

static KSL_INLINED void ksl_dot_qq_planes(ptrdiff_t n, const double *q1i, ptrdiff_t q1i_plane,
    ptrdiff_t q1i_stride, const double *q2i, ptrdiff_t q2i_plane,
    ptrdiff_t q2i_stride, double *dot, ptrdiff_t dot_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    dot[i * dot_stride] = ksl_dot_qq(&q1i_i, &q2i_i);
  }
}

/* ksl_add_dpiToq of n elements. */
static KSL_INLINED void ksl_add_dpiToq_many(ptrdiff_t n, const ksl_vec3_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternion_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_add_dpiToq(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_add_dpiToq_planes(ptrdiff_t n, const double *dpi, ptrdiff_t dpi_plane,
    ptrdiff_t dpi_stride, double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride) {
  ksl_vec3_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_add_dpiToq(&dpi_i, &qi_i);
    ksl_quaternion_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_subtract_dpiFromq of n elements. */
static KSL_INLINED void ksl_subtract_dpiFromq_many(ptrdiff_t n, const ksl_vec3_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternion_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_dpiFromq(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_subtract_dpiFromq_planes(ptrdiff_t n, const double *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_subtract_dpiFromq(&dpi_i, &qi_i);
    ksl_quaternion_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_omega_to_dquaternion of n elements. */
static KSL_INLINED void ksl_omega_to_dquaternion_many(ptrdiff_t n, const ksl_vec3_t *w,
    ptrdiff_t w_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *dqo, ptrdiff_t dqo_stride) {
  KSL_EACH_OF(n) {
    ksl_omega_to_dquaternion(w + i * w_stride, qi + i * qi_stride, dqo + i * dqo_stride);
  }
}

static KSL_INLINED void ksl_omega_to_dquaternion_planes(ptrdiff_t n, const double *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, double *dqo, ptrdiff_t dqo_plane, ptrdiff_t dqo_stride) {
  ksl_vec3_t w_i;
  if (n > 0) w_i = ksl_vec3_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3_of_planes(w + i * w_stride, w_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t dqo_i;
    ksl_omega_to_dquaternion(&w_i, &qi_i, &dqo_i);
    ksl_quaternion_to_planes(&dqo_i, dqo + i * dqo_stride, dqo_plane);
  }
}

/* ksl_mat3x3_from_quaternion of n elements. */
static KSL_INLINED void ksl_mat3x3_from_quaternion_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3_from_quaternion(q + i * q_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3_from_quaternion_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_mat3x3_t R_i;
    ksl_mat3x3_from_quaternion(&q_i, &R_i);
    ksl_mat3x3_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_quaternion_from_mat3x3 of n elements. */
static KSL_INLINED void ksl_quaternion_from_mat3x3_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_from_mat3x3(R + i * R_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_from_mat3x3_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_from_mat3x3(&R_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_from_axis_angle of n elements. */
static KSL_INLINED void ksl_quaternion_from_axis_angle_many(ptrdiff_t n, const ksl_vec3_t *axis,
    ptrdiff_t axis_stride, const double *angle, ptrdiff_t angle_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_from_axis_angle(axis + i * axis_stride, angle[i * angle_stride],
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_from_axis_angle_planes(ptrdiff_t n, const double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const double *angle,
    ptrdiff_t angle_stride, double *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_from_axis_angle(&axis_i, angle[i * angle_stride], &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_axis_angle_from_quaternion of n elements. */
static KSL_INLINED void ksl_axis_angle_from_quaternion_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_vec3_t *axis, ptrdiff_t axis_stride, double *angle,
    ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_quaternion(q + i * q_stride,
        axis + i * axis_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_quaternion_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *angle, ptrdiff_t angle_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_vec3_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_quaternion(&q_i, &axis_i);
    ksl_vec3_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
}

/* ksl_quaternion_exp of n elements. */
static KSL_INLINED void ksl_quaternion_exp_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_exp(v + i * v_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_exp_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_exp(&v_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_log of n elements. */
static KSL_INLINED void ksl_quaternion_log_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_log(q + i * q_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_log_planes(ptrdiff_t n, const double *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_vec3_t vo_i;
    ksl_quaternion_log(&q_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_quaternion_interpolated of n elements. */
static KSL_INLINED void ksl_quaternion_interpolated_many(ptrdiff_t n, const ksl_quaternion_t *q1,
    ptrdiff_t q1_stride, const ksl_quaternion_t *q2, ptrdiff_t q2_stride,
    const double *k, ptrdiff_t k_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_interpolated(q1 + i * q1_stride, q2 + i * q2_stride, k[i * k_stride],
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_interpolated_planes(ptrdiff_t n, const double *q1,
    ptrdiff_t q1_plane, ptrdiff_t q1_stride, const double *q2,
    ptrdiff_t q2_plane, ptrdiff_t q2_stride, const double *k, ptrdiff_t k_stride,
    double *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternion_t q1_i;
  if (n > 0) q1_i = ksl_quaternion_of_planes(q1, q1_plane);
  KSL_EACH_OF(n) {
    if (q1_stride) q1_i = ksl_quaternion_of_planes(q1 + i * q1_stride, q1_plane);
    const ksl_quaternion_t q2_i = ksl_quaternion_of_planes(q2 + i * q2_stride, q2_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_interpolated(&q1_i, &q2_i, k[i * k_stride], &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternionf_copy of n elements. */
static KSL_INLINED void ksl_quaternionf_copy_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_copy(qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_copy_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_copy(&qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternionf_scale of n elements. */
static KSL_INLINED void ksl_quaternionf_scale_many(ptrdiff_t n, ksl_quaternionf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_quaternionf_scale_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_t self_i = ksl_quaternionf_of_planes(self + i * self_stride, self_plane);
    ksl_quaternionf_scale(&self_i, a[i * a_stride]);
    ksl_quaternionf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_qqf of n elements. */
static KSL_INLINED void ksl_axpy_qqf_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_quaternionf_t *x, ptrdiff_t x_stride, ksl_quaternionf_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_qqf(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_qqf_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_quaternionf_t x_i = ksl_quaternionf_of_planes(x + i * x_stride, x_plane);
    ksl_quaternionf_t y_i = ksl_quaternionf_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_qqf(a[i * a_stride], &x_i, &y_i);
    ksl_quaternionf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_quaternionf_setIdentity of n elements. */
static KSL_INLINED void ksl_quaternionf_setIdentity_many(ptrdiff_t n, ksl_quaternionf_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_setIdentity(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_setIdentity_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_t self_i = ksl_quaternionf_of_planes(self + i * self_stride, self_plane);
    ksl_quaternionf_setIdentity(&self_i);
    ksl_quaternionf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_quaternionf_conjugated of n elements. */
static KSL_INLINED void ksl_quaternionf_conjugated_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_conjugated(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_conjugated_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_conjugated(&q_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternionf_norm of n elements. */
static KSL_INLINED void ksl_quaternionf_norm_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, float *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_quaternionf_norm(q + i * q_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_norm_planes(ptrdiff_t n, const float *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, float *norm, ptrdiff_t norm_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    norm[i * norm_stride] = ksl_quaternionf_norm(&q_i);
  }
}

/* ksl_quaternionf_normalize of n elements. */
static KSL_INLINED void ksl_quaternionf_normalize_many(ptrdiff_t n, ksl_quaternionf_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_normalize_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_t self_i = ksl_quaternionf_of_planes(self + i * self_stride, self_plane);
    ksl_quaternionf_normalize(&self_i);
    ksl_quaternionf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_quaternionf_normalized of n elements. */
static KSL_INLINED void ksl_quaternionf_normalized_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_normalized(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_normalized_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_normalized(&q_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_rotate_qvf of n elements. */
static KSL_INLINED void ksl_rotate_qvf_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qvf(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qvf_planes(ptrdiff_t n, const float *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_rotate_qvf(&q_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_rotate_qconjvf of n elements. */
static KSL_INLINED void ksl_rotate_qconjvf_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qconjvf(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qconjvf_planes(ptrdiff_t n, const float *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_rotate_qconjvf(&q_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_qqf of n elements. */
static KSL_INLINED void ksl_product_qqf_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqf(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqf_planes(ptrdiff_t n, const float *q1i, ptrdiff_t q1i_plane,
    ptrdiff_t q1i_stride, const float *q2i, ptrdiff_t q2i_plane,
    ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qqf(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqconjf of n elements. */
static KSL_INLINED void ksl_product_qqconjf_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqconjf(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqconjf_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qqconjf(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqf of n elements. */
static KSL_INLINED void ksl_product_qconjqf_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqf(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqf_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqf(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqconjf of n elements. */
static KSL_INLINED void ksl_product_qconjqconjf_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqconjf(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqconjf_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqconjf(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxqf of n elements. */
static KSL_INLINED void ksl_product_qxqf_many(ptrdiff_t n, const float *dci, ptrdiff_t dci_stride,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxqf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxqf_planes(ptrdiff_t n, const float *dci, ptrdiff_t dci_plane,
    ptrdiff_t dci_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxqf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxqconjf of n elements. */
static KSL_INLINED void ksl_product_qxqconjf_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxqconjf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxqconjf_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxqconjf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxconjqf of n elements. */
static KSL_INLINED void ksl_product_qxconjqf_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxconjqf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxconjqf_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxconjqf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxconjqconjf of n elements. */
static KSL_INLINED void ksl_product_qxconjqconjf_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxconjqconjf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxconjqconjf_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxconjqconjf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqxf of n elements. */
static KSL_INLINED void ksl_product_qqxf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqxf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqxf_planes(ptrdiff_t n, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_plane,
    ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqxf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqxconjf of n elements. */
static KSL_INLINED void ksl_product_qqxconjf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqxconjf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqxconjf_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqxconjf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqxf of n elements. */
static KSL_INLINED void ksl_product_qconjqxf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqxf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqxf_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqxf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqxconjf of n elements. */
static KSL_INLINED void ksl_product_qconjqxconjf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqxconjf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqxconjf_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqxconjf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyqf of n elements. */
static KSL_INLINED void ksl_product_qyqf_many(ptrdiff_t n, const float *dci, ptrdiff_t dci_stride,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyqf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyqf_planes(ptrdiff_t n, const float *dci, ptrdiff_t dci_plane,
    ptrdiff_t dci_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyqf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyqconjf of n elements. */
static KSL_INLINED void ksl_product_qyqconjf_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyqconjf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyqconjf_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyqconjf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyconjqf of n elements. */
static KSL_INLINED void ksl_product_qyconjqf_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyconjqf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyconjqf_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyconjqf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyconjqconjf of n elements. */
static KSL_INLINED void ksl_product_qyconjqconjf_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyconjqconjf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyconjqconjf_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyconjqconjf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqyf of n elements. */
static KSL_INLINED void ksl_product_qqyf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqyf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqyf_planes(ptrdiff_t n, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_plane,
    ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqyf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqyconjf of n elements. */
static KSL_INLINED void ksl_product_qqyconjf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqyconjf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqyconjf_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqyconjf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqyf of n elements. */
static KSL_INLINED void ksl_product_qconjqyf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqyf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqyf_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqyf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqyconjf of n elements. */
static KSL_INLINED void ksl_product_qconjqyconjf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqyconjf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqyconjf_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqyconjf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzqf of n elements. */
static KSL_INLINED void ksl_product_qzqf_many(ptrdiff_t n, const float *dci, ptrdiff_t dci_stride,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzqf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzqf_planes(ptrdiff_t n, const float *dci, ptrdiff_t dci_plane,
    ptrdiff_t dci_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzqf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzqconjf of n elements. */
static KSL_INLINED void ksl_product_qzqconjf_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzqconjf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzqconjf_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzqconjf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzconjqf of n elements. */
static KSL_INLINED void ksl_product_qzconjqf_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzconjqf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzconjqf_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzconjqf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzconjqconjf of n elements. */
static KSL_INLINED void ksl_product_qzconjqconjf_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzconjqconjf(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzconjqconjf_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzconjqconjf(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqzf of n elements. */
static KSL_INLINED void ksl_product_qqzf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqzf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqzf_planes(ptrdiff_t n, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_plane,
    ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqzf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqzconjf of n elements. */
static KSL_INLINED void ksl_product_qqzconjf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqzconjf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqzconjf_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqzconjf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqzf of n elements. */
static KSL_INLINED void ksl_product_qconjqzf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqzf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqzf_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqzf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqzconjf of n elements. */
static KSL_INLINED void ksl_product_qconjqzconjf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqzconjf(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqzconjf_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqzconjf(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qvf of n elements. */
static KSL_INLINED void ksl_product_qvf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qvf(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qvf_planes(ptrdiff_t n, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qvf(&qi_i, &vi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjvf of n elements. */
static KSL_INLINED void ksl_product_qconjvf_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjvf(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjvf_planes(ptrdiff_t n, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qconjvf(&qi_i, &vi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_vqf of n elements. */
static KSL_INLINED void ksl_product_vqf_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_vqf(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_vqf_planes(ptrdiff_t n, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_vqf(&vi_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_vqconjf of n elements. */
static KSL_INLINED void ksl_product_vqconjf_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_vqconjf(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_vqconjf_planes(ptrdiff_t n, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_vqconjf(&vi_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_dot_qqf of n elements. */
static KSL_INLINED void ksl_dot_qqf_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    float *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_qqf(q1i + i * q1i_stride, q2i + i * q2i_stride);
  }
}

static KSL_INLINED void ksl_dot_qqf_planes(ptrdiff_t n, const float *q1i, ptrdiff_t q1i_plane,
    ptrdiff_t q1i_stride, const float *q2i, ptrdiff_t q2i_plane,
    ptrdiff_t q2i_stride, float *dot, ptrdiff_t dot_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    dot[i * dot_stride] = ksl_dot_qqf(&q1i_i, &q2i_i);
  }
}

/* ksl_add_dpiToqf of n elements. */
static KSL_INLINED void ksl_add_dpiToqf_many(ptrdiff_t n, const ksl_vec3f_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternionf_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_add_dpiToqf(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_add_dpiToqf_planes(ptrdiff_t n, const float *dpi, ptrdiff_t dpi_plane,
    ptrdiff_t dpi_stride, float *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride) {
  ksl_vec3f_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3f_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3f_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_add_dpiToqf(&dpi_i, &qi_i);
    ksl_quaternionf_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_subtract_dpiFromqf of n elements. */
static KSL_INLINED void ksl_subtract_dpiFromqf_many(ptrdiff_t n, const ksl_vec3f_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternionf_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_dpiFromqf(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_subtract_dpiFromqf_planes(ptrdiff_t n, const float *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3f_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3f_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3f_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_subtract_dpiFromqf(&dpi_i, &qi_i);
    ksl_quaternionf_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_omega_to_dquaternionf of n elements. */
static KSL_INLINED void ksl_omega_to_dquaternionf_many(ptrdiff_t n, const ksl_vec3f_t *w,
    ptrdiff_t w_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *dqo, ptrdiff_t dqo_stride) {
  KSL_EACH_OF(n) {
    ksl_omega_to_dquaternionf(w + i * w_stride, qi + i * qi_stride, dqo + i * dqo_stride);
  }
}

static KSL_INLINED void ksl_omega_to_dquaternionf_planes(ptrdiff_t n, const float *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *dqo, ptrdiff_t dqo_plane, ptrdiff_t dqo_stride) {
  ksl_vec3f_t w_i;
  if (n > 0) w_i = ksl_vec3f_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3f_of_planes(w + i * w_stride, w_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t dqo_i;
    ksl_omega_to_dquaternionf(&w_i, &qi_i, &dqo_i);
    ksl_quaternionf_to_planes(&dqo_i, dqo + i * dqo_stride, dqo_plane);
  }
}

/* ksl_mat3x3f_from_quaternion of n elements. */
static KSL_INLINED void ksl_mat3x3f_from_quaternion_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_mat3x3f_from_quaternion(q + i * q_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_mat3x3f_from_quaternion_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_mat3x3f_t R_i;
    ksl_mat3x3f_from_quaternion(&q_i, &R_i);
    ksl_mat3x3f_to_planes(&R_i, R + i * R_stride, R_plane);
  }
}

/* ksl_quaternionf_from_mat3x3 of n elements. */
static KSL_INLINED void ksl_quaternionf_from_mat3x3_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_from_mat3x3(R + i * R_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_from_mat3x3_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_from_mat3x3(&R_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternionf_from_axis_angle of n elements. */
static KSL_INLINED void ksl_quaternionf_from_axis_angle_many(ptrdiff_t n, const ksl_vec3f_t *axis,
    ptrdiff_t axis_stride, const float *angle, ptrdiff_t angle_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_from_axis_angle(axis + i * axis_stride, angle[i * angle_stride],
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_from_axis_angle_planes(ptrdiff_t n, const float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const float *angle,
    ptrdiff_t angle_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_from_axis_angle(&axis_i, angle[i * angle_stride], &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_axis_angle_from_quaternionf of n elements. */
static KSL_INLINED void ksl_axis_angle_from_quaternionf_many(ptrdiff_t n,
    const ksl_quaternionf_t *q, ptrdiff_t q_stride, ksl_vec3f_t *axis,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_axis_angle_from_quaternionf(q + i * q_stride,
        axis + i * axis_stride);
  }
}

static KSL_INLINED void ksl_axis_angle_from_quaternionf_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_vec3f_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_quaternionf(&q_i, &axis_i);
    ksl_vec3f_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
}

/* ksl_quaternionf_exp of n elements. */
static KSL_INLINED void ksl_quaternionf_exp_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_exp(v + i * v_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_exp_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_exp(&v_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternionf_log of n elements. */
static KSL_INLINED void ksl_quaternionf_log_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_log(q + i * q_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_log_planes(ptrdiff_t n, const float *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_vec3f_t vo_i;
    ksl_quaternionf_log(&q_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_quaternionf_interpolated of n elements. */
static KSL_INLINED void ksl_quaternionf_interpolated_many(ptrdiff_t n, const ksl_quaternionf_t *q1,
    ptrdiff_t q1_stride, const ksl_quaternionf_t *q2, ptrdiff_t q2_stride,
    const float *k, ptrdiff_t k_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_interpolated(q1 + i * q1_stride, q2 + i * q2_stride, k[i * k_stride],
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_interpolated_planes(ptrdiff_t n, const float *q1,
    ptrdiff_t q1_plane, ptrdiff_t q1_stride, const float *q2, ptrdiff_t q2_plane,
    ptrdiff_t q2_stride, const float *k, ptrdiff_t k_stride, float *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1_i;
  if (n > 0) q1_i = ksl_quaternionf_of_planes(q1, q1_plane);
  KSL_EACH_OF(n) {
    if (q1_stride) q1_i = ksl_quaternionf_of_planes(q1 + i * q1_stride, q1_plane);
    const ksl_quaternionf_t q2_i = ksl_quaternionf_of_planes(q2 + i * q2_stride, q2_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_interpolated(&q1_i, &q2_i, k[i * k_stride], &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

#endif
