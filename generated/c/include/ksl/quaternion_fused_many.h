/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_QUATERNION_FUSED_MANY_H
#define KSL_QUATERNION_FUSED_MANY_H

#include "quaternion_fused.h"
#include "ksl_planes.h"

/* ksl_quaternion_scale_fused of n elements. */
static KSL_INLINED void ksl_quaternion_scale_fused_many(ptrdiff_t n, ksl_quaternion_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_quaternion_scale_fused_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_t self_i = ksl_quaternion_of_planes(self + i * self_stride, self_plane);
    ksl_quaternion_scale_fused(&self_i, a[i * a_stride]);
    ksl_quaternion_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_qq_fused of n elements. */
static KSL_INLINED void ksl_axpy_qq_fused_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_quaternion_t *x, ptrdiff_t x_stride, ksl_quaternion_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_qq_fused(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_qq_fused_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_quaternion_t x_i = ksl_quaternion_of_planes(x + i * x_stride, x_plane);
    ksl_quaternion_t y_i = ksl_quaternion_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_qq_fused(a[i * a_stride], &x_i, &y_i);
    ksl_quaternion_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_rotate_qv_fused of n elements. */
static KSL_INLINED void ksl_rotate_qv_fused_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qv_fused(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qv_fused_planes(ptrdiff_t n, const double *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_rotate_qv_fused(&q_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_rotate_qconjv_fused of n elements. */
static KSL_INLINED void ksl_rotate_qconjv_fused_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qconjv_fused(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qconjv_fused_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_rotate_qconjv_fused(&q_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_quaternion_product_qq_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qq_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qq_fused(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qq_fused_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qq_fused(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqconj_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqconj_fused(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqconj_fused_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqconj_fused(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjq_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjq_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjq_fused(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjq_fused_planes(ptrdiff_t n, const double *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const double *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjq_fused(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqconj_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqconj_fused(q1i + i * q1i_stride, q2i + i * q2i_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqconj_fused_planes(ptrdiff_t n,
    const double *q1i, ptrdiff_t q1i_plane, ptrdiff_t q1i_stride,
    const double *q2i, ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqconj_fused(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxq_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxq_fused_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxq_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxq_fused_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxq_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxqconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxqconj_fused_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxqconj_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxqconj_fused_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxqconj_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxconjq_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxconjq_fused_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxconjq_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxconjq_fused_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxconjq_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qxconjqconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qxconjqconj_fused_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qxconjqconj_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qxconjqconj_fused_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qxconjqconj_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqx_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqx_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqx_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqx_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqx_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqxconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqxconj_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqxconj_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqxconj_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqxconj_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqx_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqx_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqx_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqx_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqx_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqxconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqxconj_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqxconj_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqxconj_fused_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqxconj_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyq_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyq_fused_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyq_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyq_fused_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyq_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyqconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyqconj_fused_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyqconj_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyqconj_fused_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyqconj_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyconjq_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyconjq_fused_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyconjq_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyconjq_fused_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyconjq_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qyconjqconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qyconjqconj_fused_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qyconjqconj_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qyconjqconj_fused_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qyconjqconj_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqy_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqy_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqy_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqy_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqy_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqyconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqyconj_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqyconj_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqyconj_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqyconj_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqy_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqy_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqy_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqy_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqy_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqyconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqyconj_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqyconj_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqyconj_fused_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqyconj_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzq_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzq_fused_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzq_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzq_fused_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzq_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzqconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzqconj_fused_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzqconj_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzqconj_fused_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzqconj_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzconjq_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzconjq_fused_many(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzconjq_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzconjq_fused_planes(ptrdiff_t n, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzconjq_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qzconjqconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qzconjqconj_fused_many(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_stride, const ksl_quaternion_t *qi,
    ptrdiff_t qi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qzconjqconj_fused(dci + 2 * i * dci_stride, qi + i * qi_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qzconjqconj_fused_planes(ptrdiff_t n,
    const double *dci, ptrdiff_t dci_plane, ptrdiff_t dci_stride,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qzconjqconj_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqz_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqz_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqz_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqz_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqz_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qqzconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qqzconj_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qqzconj_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qqzconj_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qqzconj_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqz_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqz_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqz_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqz_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqz_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjqzconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjqzconj_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjqzconj_fused(qi + i * qi_stride, dci + 2 * i * dci_stride,
        qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjqzconj_fused_planes(ptrdiff_t n,
    const double *qi, ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const double dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjqzconj_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qv_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qv_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qv_fused(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qv_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qv_fused(&qi_i, &vi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_qconjv_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_qconjv_fused_many(ptrdiff_t n,
    const ksl_quaternion_t *qi, ptrdiff_t qi_stride, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_qconjv_fused(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_qconjv_fused_planes(ptrdiff_t n, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t qi_i;
  if (n > 0) qi_i = ksl_quaternion_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_qconjv_fused(&qi_i, &vi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_vq_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_vq_fused_many(ptrdiff_t n, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_vq_fused(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_vq_fused_planes(ptrdiff_t n, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_vq_fused(&vi_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_quaternion_product_vqconj_fused of n elements. */
static KSL_INLINED void ksl_quaternion_product_vqconj_fused_many(ptrdiff_t n, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_product_vqconj_fused(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_product_vqconj_fused_planes(ptrdiff_t n, const double *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const double *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_product_vqconj_fused(&vi_i, &qi_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_dot_qq_fused of n elements. */
static KSL_INLINED void ksl_dot_qq_fused_many(ptrdiff_t n, const ksl_quaternion_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternion_t *q2i, ptrdiff_t q2i_stride,
    double *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_qq_fused(q1i + i * q1i_stride, q2i + i * q2i_stride);
  }
}

static KSL_INLINED void ksl_dot_qq_fused_planes(ptrdiff_t n, const double *q1i, ptrdiff_t q1i_plane,
    ptrdiff_t q1i_stride, const double *q2i, ptrdiff_t q2i_plane,
    ptrdiff_t q2i_stride, double *dot, ptrdiff_t dot_stride) {
  ksl_quaternion_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternion_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternion_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternion_t q2i_i = ksl_quaternion_of_planes(q2i + i * q2i_stride, q2i_plane);
    dot[i * dot_stride] = ksl_dot_qq_fused(&q1i_i, &q2i_i);
  }
}

/* ksl_add_dpiToq_fused of n elements. */
static KSL_INLINED void ksl_add_dpiToq_fused_many(ptrdiff_t n, const ksl_vec3_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternion_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_add_dpiToq_fused(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_add_dpiToq_fused_planes(ptrdiff_t n, const double *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_add_dpiToq_fused(&dpi_i, &qi_i);
    ksl_quaternion_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_subtract_dpiFromq_fused of n elements. */
static KSL_INLINED void ksl_subtract_dpiFromq_fused_many(ptrdiff_t n, const ksl_vec3_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternion_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_dpiFromq_fused(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_subtract_dpiFromq_fused_planes(ptrdiff_t n, const double *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_subtract_dpiFromq_fused(&dpi_i, &qi_i);
    ksl_quaternion_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_omega_to_dquaternion_fused of n elements. */
static KSL_INLINED void ksl_omega_to_dquaternion_fused_many(ptrdiff_t n, const ksl_vec3_t *w,
    ptrdiff_t w_stride, const ksl_quaternion_t *qi, ptrdiff_t qi_stride,
    ksl_quaternion_t *dqo, ptrdiff_t dqo_stride) {
  KSL_EACH_OF(n) {
    ksl_omega_to_dquaternion_fused(w + i * w_stride, qi + i * qi_stride, dqo + i * dqo_stride);
  }
}

static KSL_INLINED void ksl_omega_to_dquaternion_fused_planes(ptrdiff_t n, const double *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const double *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, double *dqo, ptrdiff_t dqo_plane, ptrdiff_t dqo_stride) {
  ksl_vec3_t w_i;
  if (n > 0) w_i = ksl_vec3_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3_of_planes(w + i * w_stride, w_plane);
    const ksl_quaternion_t qi_i = ksl_quaternion_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternion_t dqo_i;
    ksl_omega_to_dquaternion_fused(&w_i, &qi_i, &dqo_i);
    ksl_quaternion_to_planes(&dqo_i, dqo + i * dqo_stride, dqo_plane);
  }
}

/* ksl_quaternionf_scale_fused of n elements. */
static KSL_INLINED void ksl_quaternionf_scale_fused_many(ptrdiff_t n, ksl_quaternionf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_quaternionf_scale_fused_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_t self_i = ksl_quaternionf_of_planes(self + i * self_stride, self_plane);
    ksl_quaternionf_scale_fused(&self_i, a[i * a_stride]);
    ksl_quaternionf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_qqf_fused of n elements. */
static KSL_INLINED void ksl_axpy_qqf_fused_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_quaternionf_t *x, ptrdiff_t x_stride, ksl_quaternionf_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_qqf_fused(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_qqf_fused_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_quaternionf_t x_i = ksl_quaternionf_of_planes(x + i * x_stride, x_plane);
    ksl_quaternionf_t y_i = ksl_quaternionf_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_qqf_fused(a[i * a_stride], &x_i, &y_i);
    ksl_quaternionf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_rotate_qvf_fused of n elements. */
static KSL_INLINED void ksl_rotate_qvf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qvf_fused(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qvf_fused_planes(ptrdiff_t n, const float *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_rotate_qvf_fused(&q_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_rotate_qconjvf_fused of n elements. */
static KSL_INLINED void ksl_rotate_qconjvf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_rotate_qconjvf_fused(q + i * q_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_rotate_qconjvf_fused_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_rotate_qconjvf_fused(&q_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_qqf_fused of n elements. */
static KSL_INLINED void ksl_product_qqf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqf_fused(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqf_fused_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qqf_fused(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qqconjf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqconjf_fused(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqconjf_fused_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qqconjf_fused(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqf_fused of n elements. */
static KSL_INLINED void ksl_product_qconjqf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqf_fused(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqf_fused_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqf_fused(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qconjqconjf_fused_many(ptrdiff_t n,
    const ksl_quaternionf_t *q1i, ptrdiff_t q1i_stride,
    const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqconjf_fused(q1i + i * q1i_stride, q2i + i * q2i_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqconjf_fused_planes(ptrdiff_t n, const float *q1i,
    ptrdiff_t q1i_plane, ptrdiff_t q1i_stride, const float *q2i,
    ptrdiff_t q2i_plane, ptrdiff_t q2i_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqconjf_fused(&q1i_i, &q2i_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxqf_fused of n elements. */
static KSL_INLINED void ksl_product_qxqf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxqf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxqf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxqf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxqconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qxqconjf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxqconjf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxqconjf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxqconjf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxconjqf_fused of n elements. */
static KSL_INLINED void ksl_product_qxconjqf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxconjqf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxconjqf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxconjqf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qxconjqconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qxconjqconjf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qxconjqconjf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qxconjqconjf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qxconjqconjf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqxf_fused of n elements. */
static KSL_INLINED void ksl_product_qqxf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqxf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqxf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqxf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqxconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qqxconjf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqxconjf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqxconjf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqxconjf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqxf_fused of n elements. */
static KSL_INLINED void ksl_product_qconjqxf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqxf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqxf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqxf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqxconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qconjqxconjf_fused_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqxconjf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqxconjf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqxconjf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyqf_fused of n elements. */
static KSL_INLINED void ksl_product_qyqf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyqf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyqf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyqf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyqconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qyqconjf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyqconjf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyqconjf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyqconjf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyconjqf_fused of n elements. */
static KSL_INLINED void ksl_product_qyconjqf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyconjqf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyconjqf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyconjqf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qyconjqconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qyconjqconjf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qyconjqconjf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qyconjqconjf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qyconjqconjf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqyf_fused of n elements. */
static KSL_INLINED void ksl_product_qqyf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqyf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqyf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqyf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqyconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qqyconjf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqyconjf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqyconjf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqyconjf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqyf_fused of n elements. */
static KSL_INLINED void ksl_product_qconjqyf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqyf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqyf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqyf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqyconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qconjqyconjf_fused_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqyconjf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqyconjf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqyconjf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzqf_fused of n elements. */
static KSL_INLINED void ksl_product_qzqf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzqf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzqf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzqf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzqconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qzqconjf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzqconjf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzqconjf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzqconjf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzconjqf_fused of n elements. */
static KSL_INLINED void ksl_product_qzconjqf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzconjqf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzconjqf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzconjqf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qzconjqconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qzconjqconjf_fused_many(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qzconjqconjf_fused(dci + 2 * i * dci_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qzconjqconjf_fused_planes(ptrdiff_t n, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qzconjqconjf_fused(dci_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqzf_fused of n elements. */
static KSL_INLINED void ksl_product_qqzf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqzf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqzf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqzf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qqzconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qqzconjf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qqzconjf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qqzconjf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qqzconjf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqzf_fused of n elements. */
static KSL_INLINED void ksl_product_qconjqzf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const float *dci, ptrdiff_t dci_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqzf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqzf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqzf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjqzconjf_fused of n elements. */
static KSL_INLINED void ksl_product_qconjqzconjf_fused_many(ptrdiff_t n,
    const ksl_quaternionf_t *qi, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjqzconjf_fused(qi + i * qi_stride, dci + 2 * i * dci_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjqzconjf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *dci,
    ptrdiff_t dci_plane, ptrdiff_t dci_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const float dci_i[2] = {dci[0 + i * dci_stride], dci[dci_plane + i * dci_stride]};
    ksl_quaternionf_t qo_i;
    ksl_product_qconjqzconjf_fused(&qi_i, dci_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qvf_fused of n elements. */
static KSL_INLINED void ksl_product_qvf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qvf_fused(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qvf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qvf_fused(&qi_i, &vi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_qconjvf_fused of n elements. */
static KSL_INLINED void ksl_product_qconjvf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *qi,
    ptrdiff_t qi_stride, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_qconjvf_fused(qi + i * qi_stride, vi + i * vi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_qconjvf_fused_planes(ptrdiff_t n, const float *qi,
    ptrdiff_t qi_plane, ptrdiff_t qi_stride, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_quaternionf_t qi_i;
  if (n > 0) qi_i = ksl_quaternionf_of_planes(qi, qi_plane);
  KSL_EACH_OF(n) {
    if (qi_stride) qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_qconjvf_fused(&qi_i, &vi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_vqf_fused of n elements. */
static KSL_INLINED void ksl_product_vqf_fused_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_vqf_fused(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_vqf_fused_planes(ptrdiff_t n, const float *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_vqf_fused(&vi_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_product_vqconjf_fused of n elements. */
static KSL_INLINED void ksl_product_vqconjf_fused_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_vqconjf_fused(vi + i * vi_stride, qi + i * qi_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_product_vqconjf_fused_planes(ptrdiff_t n, const float *vi,
    ptrdiff_t vi_plane, ptrdiff_t vi_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t qo_i;
    ksl_product_vqconjf_fused(&vi_i, &qi_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
}

/* ksl_dot_qqf_fused of n elements. */
static KSL_INLINED void ksl_dot_qqf_fused_many(ptrdiff_t n, const ksl_quaternionf_t *q1i,
    ptrdiff_t q1i_stride, const ksl_quaternionf_t *q2i, ptrdiff_t q2i_stride,
    float *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_qqf_fused(q1i + i * q1i_stride, q2i + i * q2i_stride);
  }
}

static KSL_INLINED void ksl_dot_qqf_fused_planes(ptrdiff_t n, const float *q1i, ptrdiff_t q1i_plane,
    ptrdiff_t q1i_stride, const float *q2i, ptrdiff_t q2i_plane,
    ptrdiff_t q2i_stride, float *dot, ptrdiff_t dot_stride) {
  ksl_quaternionf_t q1i_i;
  if (n > 0) q1i_i = ksl_quaternionf_of_planes(q1i, q1i_plane);
  KSL_EACH_OF(n) {
    if (q1i_stride) q1i_i = ksl_quaternionf_of_planes(q1i + i * q1i_stride, q1i_plane);
    const ksl_quaternionf_t q2i_i = ksl_quaternionf_of_planes(q2i + i * q2i_stride, q2i_plane);
    dot[i * dot_stride] = ksl_dot_qqf_fused(&q1i_i, &q2i_i);
  }
}

/* ksl_add_dpiToqf_fused of n elements. */
static KSL_INLINED void ksl_add_dpiToqf_fused_many(ptrdiff_t n, const ksl_vec3f_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternionf_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_add_dpiToqf_fused(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_add_dpiToqf_fused_planes(ptrdiff_t n, const float *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3f_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3f_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3f_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_add_dpiToqf_fused(&dpi_i, &qi_i);
    ksl_quaternionf_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_subtract_dpiFromqf_fused of n elements. */
static KSL_INLINED void ksl_subtract_dpiFromqf_fused_many(ptrdiff_t n, const ksl_vec3f_t *dpi,
    ptrdiff_t dpi_stride, ksl_quaternionf_t *qi, ptrdiff_t qi_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_dpiFromqf_fused(dpi + i * dpi_stride, qi + i * qi_stride);
  }
}

static KSL_INLINED void ksl_subtract_dpiFromqf_fused_planes(ptrdiff_t n, const float *dpi,
    ptrdiff_t dpi_plane, ptrdiff_t dpi_stride, float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride) {
  ksl_vec3f_t dpi_i;
  if (n > 0) dpi_i = ksl_vec3f_of_planes(dpi, dpi_plane);
  KSL_EACH_OF(n) {
    if (dpi_stride) dpi_i = ksl_vec3f_of_planes(dpi + i * dpi_stride, dpi_plane);
    ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_subtract_dpiFromqf_fused(&dpi_i, &qi_i);
    ksl_quaternionf_to_planes(&qi_i, qi + i * qi_stride, qi_plane);
  }
}

/* ksl_omega_to_dquaternionf_fused of n elements. */
static KSL_INLINED void ksl_omega_to_dquaternionf_fused_many(ptrdiff_t n, const ksl_vec3f_t *w,
    ptrdiff_t w_stride, const ksl_quaternionf_t *qi, ptrdiff_t qi_stride,
    ksl_quaternionf_t *dqo, ptrdiff_t dqo_stride) {
  KSL_EACH_OF(n) {
    ksl_omega_to_dquaternionf_fused(w + i * w_stride, qi + i * qi_stride, dqo + i * dqo_stride);
  }
}

static KSL_INLINED void ksl_omega_to_dquaternionf_fused_planes(ptrdiff_t n, const float *w,
    ptrdiff_t w_plane, ptrdiff_t w_stride, const float *qi, ptrdiff_t qi_plane,
    ptrdiff_t qi_stride, float *dqo, ptrdiff_t dqo_plane, ptrdiff_t dqo_stride) {
  ksl_vec3f_t w_i;
  if (n > 0) w_i = ksl_vec3f_of_planes(w, w_plane);
  KSL_EACH_OF(n) {
    if (w_stride) w_i = ksl_vec3f_of_planes(w + i * w_stride, w_plane);
    const ksl_quaternionf_t qi_i = ksl_quaternionf_of_planes(qi + i * qi_stride, qi_plane);
    ksl_quaternionf_t dqo_i;
    ksl_omega_to_dquaternionf_fused(&w_i, &qi_i, &dqo_i);
    ksl_quaternionf_to_planes(&dqo_i, dqo + i * dqo_stride, dqo_plane);
  }
}

#endif
