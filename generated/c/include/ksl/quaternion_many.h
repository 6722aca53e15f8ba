/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_QUATERNION_MANY_H
#define KSL_QUATERNION_MANY_H

#include "quaternion.h"
#include "ksl_states.h"

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

/* ksl_quaternion_unit_defect of n elements. */
static KSL_INLINED void ksl_quaternion_unit_defect_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, double *defect, ptrdiff_t defect_stride) {
  KSL_EACH_OF(n) {
    defect[i * defect_stride] = ksl_quaternion_unit_defect(q + i * q_stride);
  }
}

static KSL_INLINED void ksl_quaternion_unit_defect_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *defect,
    ptrdiff_t defect_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    defect[i * defect_stride] = ksl_quaternion_unit_defect(&q_i);
  }
}

/* ksl_quaternion_nearest_unit of n elements. */
static KSL_INLINED void ksl_quaternion_nearest_unit_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternion_nearest_unit(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternion_nearest_unit_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_nearest_unit(&q_i, &qo_i);
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

#if KSL_LANE_BYTES
/* ksl_quaternion_from_axis_angle of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_quaternion_from_axis_angle_states(const ksl_states *axis,
    const ksl_states *angle, ksl_states *qo) {
  const ksl_states half = 0.5 * angle[0];
  ksl_states qo_4; const ksl_states sine = ksl_sincos_lanes(half, &qo_4);
  const ksl_states qo_1 = KSL_RN_LANES(axis[0] * sine);
  const ksl_states qo_2 = KSL_RN_LANES(axis[1] * sine);
  const ksl_states qo_3 = KSL_RN_LANES(axis[2] * sine);
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}
#endif

/* ksl_quaternion_from_axis_angle of n elements. */
static KSL_INLINED void ksl_quaternion_from_axis_angle_planes(ptrdiff_t n, const double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const double *angle,
    ptrdiff_t angle_stride, double *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
#if KSL_LANE_BYTES
  ksl_states axis_states[3], angle_states[1], qo_states[4];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(axis + i * axis_stride, 3, axis_plane, axis_stride, last, axis_states);
    ksl_states_of_planes(angle + i * angle_stride, 1, 1, angle_stride, last, angle_states);
    ksl_quaternion_from_axis_angle_states(axis_states, angle_states, qo_states);
    ksl_states_to_planes(qo_states, 4, qo + i * qo_stride, qo_plane, qo_stride, last);
  }
#else
  ksl_vec3_t axis_i;
  if (n > 0) axis_i = ksl_vec3_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_from_axis_angle(&axis_i, angle[i * angle_stride], &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
#endif
}

static KSL_INLINED void ksl_quaternion_from_axis_angle_many(ptrdiff_t n, const ksl_vec3_t *axis,
    ptrdiff_t axis_stride, const double *angle, ptrdiff_t angle_stride,
    ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  ksl_quaternion_from_axis_angle_planes(n, (const double *)axis, 1, 3 * axis_stride, angle,
      angle_stride, (double *)qo, 1, 4 * qo_stride);
}

#if KSL_LANE_BYTES
/* ksl_axis_angle_from_quaternion of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_axis_angle_from_quaternion_states(const ksl_states *q,
    ksl_states *angle, ksl_states *axis) {
  const ksl_states s_size_1 = ksl_abs_lanes(q[0]);
  const ksl_states s_size_2 = ksl_abs_lanes(q[1]);
  const ksl_states s_size_3 = ksl_abs_lanes(q[2]);
  const ksl_states s_size_4 = ksl_abs_lanes(q[3]);
  const ksl_tests s_largest1a = ksl_less_lanes(s_size_1, s_size_2);
  const ksl_states s_largest1 = ksl_choice_lanes(s_largest1a, s_size_2, s_size_1);
  const ksl_tests s_largest2a = ksl_less_lanes(s_largest1, s_size_3);
  const ksl_states s_largest2 = ksl_choice_lanes(s_largest2a, s_size_3, s_largest1);
  const ksl_tests s_largest3a = ksl_less_lanes(s_largest2, s_size_4);
  const ksl_states s_largest3 = ksl_choice_lanes(s_largest3a, s_size_4, s_largest2);
  const ksl_tests s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s_largest3);
  const ksl_states s_b = ksl_choice_lanes(s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s_c = ksl_less_lanes(s_largest3, ksl_each_lanes(256.0));
  const ksl_states s_d = ksl_choice_lanes(s_c, ksl_each_lanes(1.3093562431584567e+151), s_b);
  const ksl_tests s_e = ksl_less_lanes(s_largest3, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s = ksl_choice_lanes(s_e, ksl_each_lanes(1.0715086071862673e+301), s_d);
  const ksl_states scaled_s_1 = q[0] * s;
  const ksl_states scaled_s_2 = q[1] * s;
  const ksl_states scaled_s_3 = q[2] * s;
  const ksl_states scaled_s_4 = q[3] * s;
  const ksl_states upper_0a = -scaled_s_1;
  const ksl_tests upper_0b = ksl_less_lanes(scaled_s_4, ksl_each_lanes(0.0));
  const ksl_states upper_1 = ksl_choice_lanes(upper_0b, upper_0a, scaled_s_1);
  const ksl_states upper_1a = -scaled_s_2,
      upper_2 = ksl_choice_lanes(upper_0b, upper_1a, scaled_s_2);
  const ksl_states upper_2a = -scaled_s_3,
      upper_3 = ksl_choice_lanes(upper_0b, upper_2a, scaled_s_3);
  const ksl_states upper_3a = -scaled_s_4;
  const ksl_states v_s_size_1 = ksl_abs_lanes(upper_1);
  const ksl_states v_s_size_2 = ksl_abs_lanes(upper_2);
  const ksl_states v_s_size_3 = ksl_abs_lanes(upper_3);
  const ksl_tests v_s_largest1a = ksl_less_lanes(v_s_size_1, v_s_size_2);
  const ksl_states v_s_largest1 = ksl_choice_lanes(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_tests v_s_largest2a = ksl_less_lanes(v_s_largest1, v_s_size_3);
  const ksl_states v_s_largest2 = ksl_choice_lanes(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_tests v_s_a = ksl_less_lanes(v_s_largest2, ksl_each_lanes(256.0));
  const ksl_states v_s_b = ksl_choice_lanes(v_s_a, ksl_each_lanes(1.3093562431584567e+151),
      ksl_each_lanes(1.0));
  const ksl_tests v_s_c = ksl_less_lanes(v_s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states v_s = ksl_choice_lanes(v_s_c, ksl_each_lanes(1.0715086071862673e+301), v_s_b);
  const ksl_states v_y_1 = upper_1 * v_s;
  const ksl_states v_y_2 = upper_2 * v_s;
  const ksl_states v_y_3 = upper_3 * v_s;
  const ksl_states v_n_a = KSL_RN_LANES(v_y_1 * v_y_1), v_n_b = KSL_RN_LANES(v_y_2 * v_y_2), v_n_c =
      v_n_a + v_n_b,
      v_n_d = KSL_RN_LANES(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanes(v_n_e);
  const ksl_tests v_r_a = ksl_less_lanes(ksl_each_lanes(1.0), v_s);
  const ksl_states v_r_b = ksl_choice_lanes(v_r_a, ksl_each_lanes(7.637340908749012e-152),
      ksl_each_lanes(1.0));
  const ksl_tests v_r_c = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), v_s);
  const ksl_states v_r = ksl_choice_lanes(v_r_c, ksl_each_lanes(9.332636185032189e-302), v_r_b);
  const ksl_states n = v_n * v_r;
  const ksl_states half = ksl_atan2_lanes(n, ksl_choice_lanes(upper_0b, upper_3a, scaled_s_4));
  const ksl_tests divisor_a = ksl_equal_lanes(v_n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), v_n);
  const ksl_states unit_1 = v_y_2 / divisor;
  const ksl_states unit_2 = v_y_3 / divisor;
  const ksl_states angle_ = KSL_RN_LANES(2.0 * half);
  const ksl_states axis_1 = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), v_y_1 / divisor);
  angle[0] = angle_;
  axis[0] = axis_1;
  axis[1] = unit_1;
  axis[2] = unit_2;
}
#endif

/* ksl_axis_angle_from_quaternion of n elements. */
static KSL_INLINED void ksl_axis_angle_from_quaternion_planes(ptrdiff_t n, const double *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *angle, ptrdiff_t angle_stride) {
#if KSL_LANE_BYTES
  ksl_states q_states[4], axis_states[3], angle_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(q + i * q_stride, 4, q_plane, q_stride, last, q_states);
    ksl_axis_angle_from_quaternion_states(q_states, angle_states, axis_states);
    ksl_states_to_planes(axis_states, 3, axis + i * axis_stride, axis_plane, axis_stride, last);
    ksl_states_to_planes(angle_states, 1, angle + i * angle_stride, 1, angle_stride, last);
  }
#else
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_vec3_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_quaternion(&q_i, &axis_i);
    ksl_vec3_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
#endif
}

static KSL_INLINED void ksl_axis_angle_from_quaternion_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_vec3_t *axis, ptrdiff_t axis_stride, double *angle,
    ptrdiff_t angle_stride) {
  ksl_axis_angle_from_quaternion_planes(n, (const double *)q, 1, 4 * q_stride, (double *)axis, 1,
      3 * axis_stride, angle, angle_stride);
}

#if KSL_LANE_BYTES
/* ksl_quaternion_exp of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_quaternion_exp_states(const ksl_states *v, ksl_states *qo) {
  const ksl_states h_1 = KSL_RN_LANES(0.5 * v[0]);
  const ksl_states h_2 = KSL_RN_LANES(0.5 * v[1]);
  const ksl_states h_3 = KSL_RN_LANES(0.5 * v[2]);
  const ksl_states sizes_a = ksl_abs_lanes(h_1) + ksl_abs_lanes(h_2),
      sizes = sizes_a + ksl_abs_lanes(h_3);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = h_1 + grid - grid;
  const ksl_states high_2 = h_2 + grid - grid;
  const ksl_states high_3 = h_3 + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((h_1 - high_1) * (h_1 + high_1)),
      cross_b = KSL_RN_LANES((h_2 - high_2) * (h_2 + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((h_3 - high_3) * (h_3 + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states far_k = sine / theta;
  const ksl_states k_a = KSL_RN_LANES(6.446950284384474e-26 * x), k_b = k_a - 3.868170170630684e-23,
      k_c = KSL_RN_LANES(x * k_b), k_d = k_c + 1.9572941063391263e-20, k_e = KSL_RN_LANES(x * k_d),
      k_f = k_e - 8.22063524662433e-18, k_g = KSL_RN_LANES(x * k_f), k_h = k_g +
          2.8114572543455206e-15,
      k_i = KSL_RN_LANES(x * k_h), k_j = k_i - 7.647163731819816e-13, k_k = KSL_RN_LANES(x * k_j),
      k_l = k_k + 1.6059043836821613e-10, k_m = KSL_RN_LANES(x * k_l), k_n = k_m -
          2.505210838544172e-08,
      k_o = KSL_RN_LANES(x * k_n), k_p = k_o + 2.7557319223985893e-06, k_q = KSL_RN_LANES(x * k_p),
      k_r = k_q - 0.0001984126984126984, k_s = KSL_RN_LANES(x * k_r), k_t = k_s +
          0.008333333333333333,
      k_u = KSL_RN_LANES(x * k_t), k_v = k_u - 0.16666666666666666, k_w = KSL_RN_LANES(x * k_v), k_x
          = k_w + 1.0,
      k = ksl_choice_lanes(theta_b, k_x, far_k);
  const ksl_states g2a = KSL_RN_LANES(2.4795962632247976e-27 * x), g2b = g2a -
      1.6117375710961184e-24,
      g2c = KSL_RN_LANES(x * g2b), g2d = g2c + 8.896791392450574e-22, g2e = KSL_RN_LANES(x * g2d),
      g2f = g2e - 4.110317623312165e-19, g2g = KSL_RN_LANES(x * g2f), g2h = g2g +
          1.5619206968586225e-16,
      g2i = KSL_RN_LANES(x * g2h), g2j = g2i - 4.779477332387385e-14, g2k = KSL_RN_LANES(x * g2j),
      g2l = g2k + 1.1470745597729725e-11, g2m = KSL_RN_LANES(x * g2l), g2n = g2m -
          2.08767569878681e-09,
      g2o = KSL_RN_LANES(x * g2n), g2p = g2o + 2.755731922398589e-07, g2q = KSL_RN_LANES(x * g2p),
      g2r = g2q - 2.48015873015873e-05, g2s = KSL_RN_LANES(x * g2r), g2t = g2s +
          0.001388888888888889,
      g2u = KSL_RN_LANES(x * g2t), g2v = g2u - 0.041666666666666664, g2w = KSL_RN_LANES(x * g2v), g2
          = g2w + 0.5;
  const ksl_states near_a = KSL_RN_LANES(x * g2), near = 1.0 - near_a;
  const ksl_states qo_1 = KSL_RN_LANES(h_1 * k);
  const ksl_states qo_2 = KSL_RN_LANES(h_2 * k);
  const ksl_states qo_3 = KSL_RN_LANES(h_3 * k);
  const ksl_states qo_4 = ksl_choice_lanes(theta_b, near, cosine);
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}
#endif

/* ksl_quaternion_exp of n elements. */
static KSL_INLINED void ksl_quaternion_exp_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
#if KSL_LANE_BYTES
  ksl_states v_states[3], qo_states[4];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(v + i * v_stride, 3, v_plane, v_stride, last, v_states);
    ksl_quaternion_exp_states(v_states, qo_states);
    ksl_states_to_planes(qo_states, 4, qo + i * qo_stride, qo_plane, qo_stride, last);
  }
#else
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_exp(&v_i, &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
#endif
}

static KSL_INLINED void ksl_quaternion_exp_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_quaternion_t *qo, ptrdiff_t qo_stride) {
  ksl_quaternion_exp_planes(n, (const double *)v, 1, 3 * v_stride, (double *)qo, 1, 4 * qo_stride);
}

#if KSL_LANE_BYTES
/* ksl_quaternion_log of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_quaternion_log_states(const ksl_states *q, ksl_states *vo) {
  const ksl_states s_size_1 = ksl_abs_lanes(q[0]);
  const ksl_states s_size_2 = ksl_abs_lanes(q[1]);
  const ksl_states s_size_3 = ksl_abs_lanes(q[2]);
  const ksl_states s_size_4 = ksl_abs_lanes(q[3]);
  const ksl_tests s_largest1a = ksl_less_lanes(s_size_1, s_size_2);
  const ksl_states s_largest1 = ksl_choice_lanes(s_largest1a, s_size_2, s_size_1);
  const ksl_tests s_largest2a = ksl_less_lanes(s_largest1, s_size_3);
  const ksl_states s_largest2 = ksl_choice_lanes(s_largest2a, s_size_3, s_largest1);
  const ksl_tests s_largest3a = ksl_less_lanes(s_largest2, s_size_4);
  const ksl_states s_largest3 = ksl_choice_lanes(s_largest3a, s_size_4, s_largest2);
  const ksl_tests s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s_largest3);
  const ksl_states s_b = ksl_choice_lanes(s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s_c = ksl_less_lanes(s_largest3, ksl_each_lanes(256.0));
  const ksl_states s_d = ksl_choice_lanes(s_c, ksl_each_lanes(1.3093562431584567e+151), s_b);
  const ksl_tests s_e = ksl_less_lanes(s_largest3, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s = ksl_choice_lanes(s_e, ksl_each_lanes(1.0715086071862673e+301), s_d);
  const ksl_states scaled_s_1 = q[0] * s;
  const ksl_states scaled_s_2 = q[1] * s;
  const ksl_states scaled_s_3 = q[2] * s;
  const ksl_states scaled_s_4 = q[3] * s;
  const ksl_states upper_0a = -scaled_s_1;
  const ksl_tests upper_0b = ksl_less_lanes(scaled_s_4, ksl_each_lanes(0.0));
  const ksl_states upper_1 = ksl_choice_lanes(upper_0b, upper_0a, scaled_s_1);
  const ksl_states upper_1a = -scaled_s_2,
      upper_2 = ksl_choice_lanes(upper_0b, upper_1a, scaled_s_2);
  const ksl_states upper_2a = -scaled_s_3,
      upper_3 = ksl_choice_lanes(upper_0b, upper_2a, scaled_s_3);
  const ksl_states upper_3a = -scaled_s_4;
  const ksl_states v_s_size_1 = ksl_abs_lanes(upper_1);
  const ksl_states v_s_size_2 = ksl_abs_lanes(upper_2);
  const ksl_states v_s_size_3 = ksl_abs_lanes(upper_3);
  const ksl_tests v_s_largest1a = ksl_less_lanes(v_s_size_1, v_s_size_2);
  const ksl_states v_s_largest1 = ksl_choice_lanes(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_tests v_s_largest2a = ksl_less_lanes(v_s_largest1, v_s_size_3);
  const ksl_states v_s_largest2 = ksl_choice_lanes(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_tests v_s_a = ksl_less_lanes(v_s_largest2, ksl_each_lanes(256.0));
  const ksl_states v_s_b = ksl_choice_lanes(v_s_a, ksl_each_lanes(1.3093562431584567e+151),
      ksl_each_lanes(1.0));
  const ksl_tests v_s_c = ksl_less_lanes(v_s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states v_s = ksl_choice_lanes(v_s_c, ksl_each_lanes(1.0715086071862673e+301), v_s_b);
  const ksl_states v_y_1 = upper_1 * v_s;
  const ksl_states v_y_2 = upper_2 * v_s;
  const ksl_states v_y_3 = upper_3 * v_s;
  const ksl_states v_n_a = KSL_RN_LANES(v_y_1 * v_y_1), v_n_b = KSL_RN_LANES(v_y_2 * v_y_2), v_n_c =
      v_n_a + v_n_b,
      v_n_d = KSL_RN_LANES(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanes(v_n_e);
  const ksl_tests v_r_a = ksl_less_lanes(ksl_each_lanes(1.0), v_s);
  const ksl_states v_r_b = ksl_choice_lanes(v_r_a, ksl_each_lanes(7.637340908749012e-152),
      ksl_each_lanes(1.0));
  const ksl_tests v_r_c = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), v_s);
  const ksl_states v_r = ksl_choice_lanes(v_r_c, ksl_each_lanes(9.332636185032189e-302), v_r_b);
  const ksl_states n = v_n * v_r;
  const ksl_states half = ksl_atan2_lanes(n, ksl_choice_lanes(upper_0b, upper_3a, scaled_s_4));
  const ksl_tests divisor_a = ksl_equal_lanes(n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), n);
  const ksl_states theta = 2.0 * half;
  const ksl_states k = theta / divisor;
  const ksl_states vector_1 = KSL_RN_LANES(upper_1 * k);
  const ksl_states vector_2 = KSL_RN_LANES(upper_2 * k);
  const ksl_states vector_3 = KSL_RN_LANES(upper_3 * k);
  vo[0] = vector_1;
  vo[1] = vector_2;
  vo[2] = vector_3;
}
#endif

/* ksl_quaternion_log of n elements. */
static KSL_INLINED void ksl_quaternion_log_planes(ptrdiff_t n, const double *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
#if KSL_LANE_BYTES
  ksl_states q_states[4], vo_states[3];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(q + i * q_stride, 4, q_plane, q_stride, last, q_states);
    ksl_quaternion_log_states(q_states, vo_states);
    ksl_states_to_planes(vo_states, 3, vo + i * vo_stride, vo_plane, vo_stride, last);
  }
#else
  ksl_quaternion_t q_i;
  if (n > 0) q_i = ksl_quaternion_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternion_of_planes(q + i * q_stride, q_plane);
    ksl_vec3_t vo_i;
    ksl_quaternion_log(&q_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
#endif
}

static KSL_INLINED void ksl_quaternion_log_many(ptrdiff_t n, const ksl_quaternion_t *q,
    ptrdiff_t q_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  ksl_quaternion_log_planes(n, (const double *)q, 1, 4 * q_stride, (double *)vo, 1, 3 * vo_stride);
}

#if KSL_LANE_BYTES
/* ksl_quaternion_interpolated of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_quaternion_interpolated_states(const ksl_states *q1,
    const ksl_states *q2, const ksl_states *k, ksl_states *qo) {
  const ksl_states between_0a = KSL_RN_LANES(q1[3] * q2[0]), between_0b = KSL_RN_LANES(q1[0] *
      q2[3]),
      between_0c = between_0a - between_0b, between_0d = KSL_RN_LANES(q1[2] * q2[1]),
      between_0e = KSL_RN_LANES(q1[1] * q2[2]), between_0f = between_0d - between_0e,
      between_1 = between_0c + between_0f;
  const ksl_states between_1a = KSL_RN_LANES(q1[0] * q2[2]), between_1b = KSL_RN_LANES(q1[2] *
      q2[0]),
      between_1c = between_1a - between_1b, between_1d = KSL_RN_LANES(q1[3] * q2[1]),
      between_1e = KSL_RN_LANES(q1[1] * q2[3]), between_1f = between_1d - between_1e,
      between_2 = between_1c + between_1f;
  const ksl_states between_2a = KSL_RN_LANES(q1[1] * q2[0]), between_2b = KSL_RN_LANES(q1[0] *
      q2[1]),
      between_2c = between_2a - between_2b, between_2d = KSL_RN_LANES(q1[3] * q2[2]),
      between_2e = KSL_RN_LANES(q1[2] * q2[3]), between_2f = between_2d - between_2e,
      between_3 = between_2c + between_2f;
  const ksl_states between_3a = KSL_RN_LANES(q1[0] * q2[0]), between_3b = KSL_RN_LANES(q1[1] *
      q2[1]),
      between_3c = between_3a + between_3b, between_3d = KSL_RN_LANES(q1[2] * q2[2]),
      between_3e = between_3c + between_3d, between_3f = KSL_RN_LANES(q1[3] * q2[3]),
      between_4 = between_3e + between_3f;
  const ksl_states upper_0a = -between_1;
  const ksl_tests upper_0b = ksl_less_lanes(between_4, ksl_each_lanes(0.0));
  const ksl_states upper_1 = ksl_choice_lanes(upper_0b, upper_0a, between_1);
  const ksl_states upper_1a = -between_2, upper_2 = ksl_choice_lanes(upper_0b, upper_1a, between_2);
  const ksl_states upper_2a = -between_3, upper_3 = ksl_choice_lanes(upper_0b, upper_2a, between_3);
  const ksl_states upper_3a = -between_4;
  const ksl_states v_s_size_1 = ksl_abs_lanes(upper_1);
  const ksl_states v_s_size_2 = ksl_abs_lanes(upper_2);
  const ksl_states v_s_size_3 = ksl_abs_lanes(upper_3);
  const ksl_tests v_s_largest1a = ksl_less_lanes(v_s_size_1, v_s_size_2);
  const ksl_states v_s_largest1 = ksl_choice_lanes(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_tests v_s_largest2a = ksl_less_lanes(v_s_largest1, v_s_size_3);
  const ksl_states v_s_largest2 = ksl_choice_lanes(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_tests v_s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), v_s_largest2);
  const ksl_states v_s_b = ksl_choice_lanes(v_s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests v_s_c = ksl_less_lanes(v_s_largest2, ksl_each_lanes(256.0));
  const ksl_states v_s_d = ksl_choice_lanes(v_s_c, ksl_each_lanes(1.3093562431584567e+151), v_s_b);
  const ksl_tests v_s_e = ksl_less_lanes(v_s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states v_s = ksl_choice_lanes(v_s_e, ksl_each_lanes(1.0715086071862673e+301), v_s_d);
  const ksl_states v_y_1 = upper_1 * v_s;
  const ksl_states v_y_2 = upper_2 * v_s;
  const ksl_states v_y_3 = upper_3 * v_s;
  const ksl_states v_n_a = KSL_RN_LANES(v_y_1 * v_y_1), v_n_b = KSL_RN_LANES(v_y_2 * v_y_2), v_n_c =
      v_n_a + v_n_b,
      v_n_d = KSL_RN_LANES(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanes(v_n_e);
  const ksl_tests v_r_a = ksl_less_lanes(v_s, ksl_each_lanes(1.0));
  const ksl_states v_r_b = ksl_choice_lanes(v_r_a, ksl_each_lanes(2.6815615859885194e+154),
      ksl_each_lanes(1.0));
  const ksl_tests v_r_c = ksl_less_lanes(ksl_each_lanes(1.0), v_s);
  const ksl_states v_r_d = ksl_choice_lanes(v_r_c, ksl_each_lanes(7.637340908749012e-152), v_r_b);
  const ksl_tests v_r_e = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), v_s);
  const ksl_states v_r = ksl_choice_lanes(v_r_e, ksl_each_lanes(9.332636185032189e-302), v_r_d);
  const ksl_states n = v_n * v_r;
  const ksl_states half = ksl_atan2_lanes(n, ksl_choice_lanes(upper_0b, upper_3a, between_4));
  const ksl_tests divisor_a = ksl_equal_lanes(n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), n);
  const ksl_states rate = half / divisor;
  const ksl_states step_1 = KSL_RN_LANES(rate * (k[0] * upper_1));
  const ksl_states step_2 = KSL_RN_LANES(rate * (k[0] * upper_2));
  const ksl_states step_3 = KSL_RN_LANES(rate * (k[0] * upper_3));
  const ksl_states exp_sizes_a = ksl_abs_lanes(step_1) + ksl_abs_lanes(step_2),
      exp_sizes = exp_sizes_a + ksl_abs_lanes(step_3);
  const ksl_states exp_grid = KSL_RN_LANES(exp_sizes * 268435456.0);
  const ksl_states exp_high_1 = step_1 + exp_grid - exp_grid;
  const ksl_states exp_high_2 = step_2 + exp_grid - exp_grid;
  const ksl_states exp_high_3 = step_3 + exp_grid - exp_grid;
  const ksl_states exp_squares_a = KSL_RN_LANES(exp_high_1 * exp_high_1),
      exp_squares_b = KSL_RN_LANES(exp_high_2 * exp_high_2), exp_squares_c = exp_squares_a +
          exp_squares_b,
      exp_squares_d = KSL_RN_LANES(exp_high_3 * exp_high_3), exp_squares = exp_squares_c +
          exp_squares_d;
  const ksl_states exp_cross_a = KSL_RN_LANES((step_1 - exp_high_1) * (step_1 + exp_high_1)),
      exp_cross_b = KSL_RN_LANES((step_2 - exp_high_2) * (step_2 + exp_high_2)),
      exp_cross_c = exp_cross_a + exp_cross_b,
      exp_cross_d = KSL_RN_LANES((step_3 - exp_high_3) * (step_3 + exp_high_3)),
      exp_cross = exp_cross_c + exp_cross_d;
  const ksl_states exp_x = exp_squares + exp_cross;
  const ksl_states exp_theta_a = ksl_sqrt_lanes(exp_x);
  const ksl_tests exp_theta_b = ksl_less_lanes(exp_x, ksl_each_lanes(1.0));
  const ksl_states exp_theta = ksl_choice_lanes(exp_theta_b, ksl_each_lanes(1.0), exp_theta_a);
  const ksl_states exp_theta_shifted = exp_grid + exp_theta;
  const ksl_states exp_theta_high = exp_theta_shifted - exp_grid;
  const ksl_states exp_theta_low = exp_theta - exp_theta_high;
  const ksl_states exp_theta_sum = exp_theta + exp_theta_high;
  const ksl_states exp_cross_rest_a = KSL_RN_LANES(exp_theta_low * exp_theta_sum),
      exp_cross_rest = exp_cross - exp_cross_rest_a;
  const ksl_states exp_exact_a = KSL_RN_LANES(exp_theta_high * exp_theta_high),
      exp_exact = exp_squares - exp_exact_a;
  const ksl_states exp_residual = exp_cross_rest + exp_exact;
  const ksl_states exp_small_a = 0.5 * exp_residual, exp_small = exp_small_a / exp_theta;
  const ksl_states exp_delta_a = ksl_abs_lanes(exp_small);
  const ksl_tests exp_delta_b = ksl_less_lanes(exp_delta_a, ksl_each_lanes(0.0078125));
  const ksl_states exp_delta = ksl_choice_lanes(exp_delta_b, exp_small, ksl_each_lanes(0.0));
  ksl_states exp_far_cosine_a; const ksl_states exp_far_sine_a = ksl_sincos_lanes(exp_theta,
      &exp_far_cosine_a);
  const ksl_states exp_far_sine = ksl_choice_lanes(exp_theta_b, ksl_each_lanes(1.0),
      exp_far_sine_a);
  const ksl_states exp_far_cosine = ksl_choice_lanes(exp_theta_b, ksl_each_lanes(0.0),
      exp_far_cosine_a);
  const ksl_states exp_sine_a = KSL_RN_LANES(exp_delta * exp_far_cosine),
      exp_sine = exp_sine_a + exp_far_sine;
  const ksl_states exp_cosine_a = KSL_RN_LANES(exp_delta * exp_far_sine),
      exp_cosine = exp_far_cosine - exp_cosine_a;
  const ksl_states exp_far_k = exp_sine / exp_theta;
  const ksl_states exp_k_a = KSL_RN_LANES(6.446950284384474e-26 * exp_x),
      exp_k_b = exp_k_a - 3.868170170630684e-23, exp_k_c = KSL_RN_LANES(exp_x * exp_k_b),
      exp_k_d = exp_k_c + 1.9572941063391263e-20, exp_k_e = KSL_RN_LANES(exp_x * exp_k_d),
      exp_k_f = exp_k_e - 8.22063524662433e-18, exp_k_g = KSL_RN_LANES(exp_x * exp_k_f),
      exp_k_h = exp_k_g + 2.8114572543455206e-15, exp_k_i = KSL_RN_LANES(exp_x * exp_k_h),
      exp_k_j = exp_k_i - 7.647163731819816e-13, exp_k_k = KSL_RN_LANES(exp_x * exp_k_j),
      exp_k_l = exp_k_k + 1.6059043836821613e-10, exp_k_m = KSL_RN_LANES(exp_x * exp_k_l),
      exp_k_n = exp_k_m - 2.505210838544172e-08, exp_k_o = KSL_RN_LANES(exp_x * exp_k_n),
      exp_k_p = exp_k_o + 2.7557319223985893e-06, exp_k_q = KSL_RN_LANES(exp_x * exp_k_p),
      exp_k_r = exp_k_q - 0.0001984126984126984, exp_k_s = KSL_RN_LANES(exp_x * exp_k_r),
      exp_k_t = exp_k_s + 0.008333333333333333, exp_k_u = KSL_RN_LANES(exp_x * exp_k_t),
      exp_k_v = exp_k_u - 0.16666666666666666, exp_k_w = KSL_RN_LANES(exp_x * exp_k_v),
      exp_k_x = exp_k_w + 1.0, exp_k = ksl_choice_lanes(exp_theta_b, exp_k_x, exp_far_k);
  const ksl_states exp_g2a = KSL_RN_LANES(2.4795962632247976e-27 * exp_x),
      exp_g2b = exp_g2a - 1.6117375710961184e-24, exp_g2c = KSL_RN_LANES(exp_x * exp_g2b),
      exp_g2d = exp_g2c + 8.896791392450574e-22, exp_g2e = KSL_RN_LANES(exp_x * exp_g2d),
      exp_g2f = exp_g2e - 4.110317623312165e-19, exp_g2g = KSL_RN_LANES(exp_x * exp_g2f),
      exp_g2h = exp_g2g + 1.5619206968586225e-16, exp_g2i = KSL_RN_LANES(exp_x * exp_g2h),
      exp_g2j = exp_g2i - 4.779477332387385e-14, exp_g2k = KSL_RN_LANES(exp_x * exp_g2j),
      exp_g2l = exp_g2k + 1.1470745597729725e-11, exp_g2m = KSL_RN_LANES(exp_x * exp_g2l),
      exp_g2n = exp_g2m - 2.08767569878681e-09, exp_g2o = KSL_RN_LANES(exp_x * exp_g2n),
      exp_g2p = exp_g2o + 2.755731922398589e-07, exp_g2q = KSL_RN_LANES(exp_x * exp_g2p),
      exp_g2r = exp_g2q - 2.48015873015873e-05, exp_g2s = KSL_RN_LANES(exp_x * exp_g2r),
      exp_g2t = exp_g2s + 0.001388888888888889, exp_g2u = KSL_RN_LANES(exp_x * exp_g2t),
      exp_g2v = exp_g2u - 0.041666666666666664, exp_g2w = KSL_RN_LANES(exp_x * exp_g2v),
      exp_g2 = exp_g2w + 0.5;
  const ksl_states exp_near_a = KSL_RN_LANES(exp_x * exp_g2), exp_near = 1.0 - exp_near_a;
  const ksl_states power_1 = step_1 * exp_k;
  const ksl_states power_2 = step_2 * exp_k;
  const ksl_states power_3 = step_3 * exp_k;
  const ksl_states power_4 = ksl_choice_lanes(exp_theta_b, exp_near, exp_cosine);
  const ksl_states qo_0a = KSL_RN_LANES(q1[0] * power_4), qo_0b = KSL_RN_LANES(q1[1] * power_3),
      qo_0c = KSL_RN_LANES(q1[2] * power_2), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_RN_LANES(q1[3] * power_1), qo_1 = qo_0e + qo_0f;
  const ksl_states qo_1a = KSL_RN_LANES(q1[2] * power_1), qo_1b = KSL_RN_LANES(q1[0] * power_3),
      qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_RN_LANES(q1[1] * power_4), qo_1e = qo_1c + qo_1d, qo_1f = KSL_RN_LANES(q1[3] *
          power_2),
      qo_2 = qo_1e + qo_1f;
  const ksl_states qo_2a = KSL_RN_LANES(q1[0] * power_2), qo_2b = KSL_RN_LANES(q1[1] * power_1),
      qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_RN_LANES(q1[2] * power_4), qo_2e = qo_2c + qo_2d, qo_2f = KSL_RN_LANES(q1[3] *
          power_3),
      qo_3 = qo_2e + qo_2f;
  const ksl_states qo_3a = KSL_RN_LANES(q1[3] * power_4), qo_3b = KSL_RN_LANES(q1[0] * power_1),
      qo_3c = KSL_RN_LANES(q1[1] * power_2), qo_3d = qo_3b + qo_3c, qo_3e = KSL_RN_LANES(q1[2] *
          power_3),
      qo_3f = qo_3d + qo_3e, qo_4 = qo_3a - qo_3f;
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}
#endif

/* ksl_quaternion_interpolated of n elements. */
static KSL_INLINED void ksl_quaternion_interpolated_planes(ptrdiff_t n, const double *q1,
    ptrdiff_t q1_plane, ptrdiff_t q1_stride, const double *q2,
    ptrdiff_t q2_plane, ptrdiff_t q2_stride, const double *k, ptrdiff_t k_stride,
    double *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
#if KSL_LANE_BYTES
  ksl_states q1_states[4], q2_states[4], k_states[1], qo_states[4];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(q1 + i * q1_stride, 4, q1_plane, q1_stride, last, q1_states);
    ksl_states_of_planes(q2 + i * q2_stride, 4, q2_plane, q2_stride, last, q2_states);
    ksl_states_of_planes(k + i * k_stride, 1, 1, k_stride, last, k_states);
    ksl_quaternion_interpolated_states(q1_states, q2_states, k_states, qo_states);
    ksl_states_to_planes(qo_states, 4, qo + i * qo_stride, qo_plane, qo_stride, last);
  }
#else
  ksl_quaternion_t q1_i;
  if (n > 0) q1_i = ksl_quaternion_of_planes(q1, q1_plane);
  KSL_EACH_OF(n) {
    if (q1_stride) q1_i = ksl_quaternion_of_planes(q1 + i * q1_stride, q1_plane);
    const ksl_quaternion_t q2_i = ksl_quaternion_of_planes(q2 + i * q2_stride, q2_plane);
    ksl_quaternion_t qo_i;
    ksl_quaternion_interpolated(&q1_i, &q2_i, k[i * k_stride], &qo_i);
    ksl_quaternion_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
#endif
}

static KSL_INLINED void ksl_quaternion_interpolated_many(ptrdiff_t n, const ksl_quaternion_t *q1,
    ptrdiff_t q1_stride, const ksl_quaternion_t *q2, ptrdiff_t q2_stride,
    const double *k, ptrdiff_t k_stride, ksl_quaternion_t *qo,
    ptrdiff_t qo_stride) {
  ksl_quaternion_interpolated_planes(n, (const double *)q1, 1, 4 * q1_stride, (const double *)q2, 1,
      4 * q2_stride, k, k_stride, (double *)qo, 1, 4 * qo_stride);
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

/* ksl_quaternionf_unit_defect of n elements. */
static KSL_INLINED void ksl_quaternionf_unit_defect_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, float *defect, ptrdiff_t defect_stride) {
  KSL_EACH_OF(n) {
    defect[i * defect_stride] = ksl_quaternionf_unit_defect(q + i * q_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_unit_defect_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *defect,
    ptrdiff_t defect_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    defect[i * defect_stride] = ksl_quaternionf_unit_defect(&q_i);
  }
}

/* ksl_quaternionf_nearest_unit of n elements. */
static KSL_INLINED void ksl_quaternionf_nearest_unit_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  KSL_EACH_OF(n) {
    ksl_quaternionf_nearest_unit(q + i * q_stride, qo + i * qo_stride);
  }
}

static KSL_INLINED void ksl_quaternionf_nearest_unit_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *qo, ptrdiff_t qo_plane,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_nearest_unit(&q_i, &qo_i);
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

#if KSL_LANE_BYTES
/* ksl_quaternionf_from_axis_angle of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_quaternionf_from_axis_angle_states(const ksl_statesf *axis,
    const ksl_statesf *angle, ksl_statesf *qo) {
  const ksl_statesf half = 0.5f * angle[0];
  ksl_statesf qo_4; const ksl_statesf sine = ksl_sincos_lanesf(half, &qo_4);
  const ksl_statesf qo_1 = KSL_RN_LANESF(axis[0] * sine);
  const ksl_statesf qo_2 = KSL_RN_LANESF(axis[1] * sine);
  const ksl_statesf qo_3 = KSL_RN_LANESF(axis[2] * sine);
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}
#endif

/* ksl_quaternionf_from_axis_angle of n elements. */
static KSL_INLINED void ksl_quaternionf_from_axis_angle_planes(ptrdiff_t n, const float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, const float *angle,
    ptrdiff_t angle_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
#if KSL_LANE_BYTES
  ksl_statesf axis_states[3], angle_states[1], qo_states[4];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(axis + i * axis_stride, 3, axis_plane, axis_stride, last, axis_states);
    ksl_statesf_of_planes(angle + i * angle_stride, 1, 1, angle_stride, last, angle_states);
    ksl_quaternionf_from_axis_angle_states(axis_states, angle_states, qo_states);
    ksl_statesf_to_planes(qo_states, 4, qo + i * qo_stride, qo_plane, qo_stride, last);
  }
#else
  ksl_vec3f_t axis_i;
  if (n > 0) axis_i = ksl_vec3f_of_planes(axis, axis_plane);
  KSL_EACH_OF(n) {
    if (axis_stride) axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_from_axis_angle(&axis_i, angle[i * angle_stride], &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
#endif
}

static KSL_INLINED void ksl_quaternionf_from_axis_angle_many(ptrdiff_t n, const ksl_vec3f_t *axis,
    ptrdiff_t axis_stride, const float *angle, ptrdiff_t angle_stride,
    ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  ksl_quaternionf_from_axis_angle_planes(n, (const float *)axis, 1, 3 * axis_stride, angle,
      angle_stride, (float *)qo, 1, 4 * qo_stride);
}

#if KSL_LANE_BYTES
/* ksl_axis_angle_from_quaternionf of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_axis_angle_from_quaternionf_states(const ksl_statesf *q,
    ksl_statesf *angle, ksl_statesf *axis) {
  const ksl_statesf s_size_1 = ksl_abs_lanesf(q[0]);
  const ksl_statesf s_size_2 = ksl_abs_lanesf(q[1]);
  const ksl_statesf s_size_3 = ksl_abs_lanesf(q[2]);
  const ksl_statesf s_size_4 = ksl_abs_lanesf(q[3]);
  const ksl_testsf s_largest1a = ksl_less_lanesf(s_size_1, s_size_2);
  const ksl_statesf s_largest1 = ksl_choice_lanesf(s_largest1a, s_size_2, s_size_1);
  const ksl_testsf s_largest2a = ksl_less_lanesf(s_largest1, s_size_3);
  const ksl_statesf s_largest2 = ksl_choice_lanesf(s_largest2a, s_size_3, s_largest1);
  const ksl_testsf s_largest3a = ksl_less_lanesf(s_largest2, s_size_4);
  const ksl_statesf s_largest3 = ksl_choice_lanesf(s_largest3a, s_size_4, s_largest2);
  const ksl_testsf s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s_largest3);
  const ksl_statesf s_b = ksl_choice_lanesf(s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s_c = ksl_less_lanesf(s_largest3, ksl_each_lanesf(256.0f));
  const ksl_statesf s_d = ksl_choice_lanesf(s_c, ksl_each_lanesf(1.8014399e+16f), s_b);
  const ksl_testsf s_e = ksl_less_lanesf(s_largest3, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s = ksl_choice_lanesf(s_e, ksl_each_lanesf(3.2451855e+32f), s_d);
  const ksl_statesf scaled_s_1 = q[0] * s;
  const ksl_statesf scaled_s_2 = q[1] * s;
  const ksl_statesf scaled_s_3 = q[2] * s;
  const ksl_statesf scaled_s_4 = q[3] * s;
  const ksl_statesf upper_0a = -scaled_s_1;
  const ksl_testsf upper_0b = ksl_less_lanesf(scaled_s_4, ksl_each_lanesf(0.0f));
  const ksl_statesf upper_1 = ksl_choice_lanesf(upper_0b, upper_0a, scaled_s_1);
  const ksl_statesf upper_1a = -scaled_s_2,
      upper_2 = ksl_choice_lanesf(upper_0b, upper_1a, scaled_s_2);
  const ksl_statesf upper_2a = -scaled_s_3,
      upper_3 = ksl_choice_lanesf(upper_0b, upper_2a, scaled_s_3);
  const ksl_statesf upper_3a = -scaled_s_4;
  const ksl_statesf v_s_size_1 = ksl_abs_lanesf(upper_1);
  const ksl_statesf v_s_size_2 = ksl_abs_lanesf(upper_2);
  const ksl_statesf v_s_size_3 = ksl_abs_lanesf(upper_3);
  const ksl_testsf v_s_largest1a = ksl_less_lanesf(v_s_size_1, v_s_size_2);
  const ksl_statesf v_s_largest1 = ksl_choice_lanesf(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_testsf v_s_largest2a = ksl_less_lanesf(v_s_largest1, v_s_size_3);
  const ksl_statesf v_s_largest2 = ksl_choice_lanesf(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_testsf v_s_a = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf v_s_b = ksl_choice_lanesf(v_s_a, ksl_each_lanesf(1.8014399e+16f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_s_c = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf v_s = ksl_choice_lanesf(v_s_c, ksl_each_lanesf(3.2451855e+32f), v_s_b);
  const ksl_statesf v_y_1 = upper_1 * v_s;
  const ksl_statesf v_y_2 = upper_2 * v_s;
  const ksl_statesf v_y_3 = upper_3 * v_s;
  const ksl_statesf v_n_a = KSL_RN_LANESF(v_y_1 * v_y_1), v_n_b = KSL_RN_LANESF(v_y_2 * v_y_2),
      v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_RN_LANESF(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanesf(v_n_e);
  const ksl_testsf v_r_a = ksl_less_lanesf(ksl_each_lanesf(1.0f), v_s);
  const ksl_statesf v_r_b = ksl_choice_lanesf(v_r_a, ksl_each_lanesf(5.551115e-17f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_r_c = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), v_s);
  const ksl_statesf v_r = ksl_choice_lanesf(v_r_c, ksl_each_lanesf(3.081488e-33f), v_r_b);
  const ksl_statesf n = v_n * v_r;
  const ksl_statesf half = ksl_atan2_lanesf(n, ksl_choice_lanesf(upper_0b, upper_3a, scaled_s_4));
  const ksl_testsf divisor_a = ksl_equal_lanesf(v_n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), v_n);
  const ksl_statesf unit_1 = v_y_2 / divisor;
  const ksl_statesf unit_2 = v_y_3 / divisor;
  const ksl_statesf angle_ = KSL_RN_LANESF(2.0f * half);
  const ksl_statesf axis_1 = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), v_y_1 / divisor);
  angle[0] = angle_;
  axis[0] = axis_1;
  axis[1] = unit_1;
  axis[2] = unit_2;
}
#endif

/* ksl_axis_angle_from_quaternionf of n elements. */
static KSL_INLINED void ksl_axis_angle_from_quaternionf_planes(ptrdiff_t n, const float *q,
    ptrdiff_t q_plane, ptrdiff_t q_stride, float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
#if KSL_LANE_BYTES
  ksl_statesf q_states[4], axis_states[3], angle_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(q + i * q_stride, 4, q_plane, q_stride, last, q_states);
    ksl_axis_angle_from_quaternionf_states(q_states, angle_states, axis_states);
    ksl_statesf_to_planes(axis_states, 3, axis + i * axis_stride, axis_plane, axis_stride, last);
    ksl_statesf_to_planes(angle_states, 1, angle + i * angle_stride, 1, angle_stride, last);
  }
#else
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_vec3f_t axis_i;
    angle[i * angle_stride] = ksl_axis_angle_from_quaternionf(&q_i, &axis_i);
    ksl_vec3f_to_planes(&axis_i, axis + i * axis_stride, axis_plane);
  }
#endif
}

static KSL_INLINED void ksl_axis_angle_from_quaternionf_many(ptrdiff_t n,
    const ksl_quaternionf_t *q, ptrdiff_t q_stride, ksl_vec3f_t *axis,
    ptrdiff_t axis_stride, float *angle, ptrdiff_t angle_stride) {
  ksl_axis_angle_from_quaternionf_planes(n, (const float *)q, 1, 4 * q_stride, (float *)axis, 1,
      3 * axis_stride, angle, angle_stride);
}

#if KSL_LANE_BYTES
/* ksl_quaternionf_exp of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_quaternionf_exp_states(const ksl_statesf *v, ksl_statesf *qo) {
  const ksl_statesf h_1 = KSL_RN_LANESF(0.5f * v[0]);
  const ksl_statesf h_2 = KSL_RN_LANESF(0.5f * v[1]);
  const ksl_statesf h_3 = KSL_RN_LANESF(0.5f * v[2]);
  const ksl_statesf sizes_a = ksl_abs_lanesf(h_1) + ksl_abs_lanesf(h_2),
      sizes = sizes_a + ksl_abs_lanesf(h_3);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = h_1 + grid - grid;
  const ksl_statesf high_2 = h_2 + grid - grid;
  const ksl_statesf high_3 = h_3 + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((h_1 - high_1) * (h_1 + high_1)),
      cross_b = KSL_RN_LANESF((h_2 - high_2) * (h_2 + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((h_3 - high_3) * (h_3 + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf far_k = sine / theta;
  const ksl_statesf k_a = KSL_RN_LANESF(6.4469503e-26f * x), k_b = k_a - 3.8681703e-23f, k_c =
      KSL_RN_LANESF(x * k_b),
      k_d = k_c + 1.9572942e-20f, k_e = KSL_RN_LANESF(x * k_d), k_f = k_e - 8.220635e-18f, k_g =
          KSL_RN_LANESF(x * k_f),
      k_h = k_g + 2.8114574e-15f, k_i = KSL_RN_LANESF(x * k_h), k_j = k_i - 7.6471636e-13f, k_k =
          KSL_RN_LANESF(x * k_j),
      k_l = k_k + 1.6059044e-10f, k_m = KSL_RN_LANESF(x * k_l), k_n = k_m - 2.5052108e-08f, k_o =
          KSL_RN_LANESF(x * k_n),
      k_p = k_o + 2.7557319e-06f, k_q = KSL_RN_LANESF(x * k_p), k_r = k_q - 0.0001984127f, k_s =
          KSL_RN_LANESF(x * k_r),
      k_t = k_s + 0.008333334f, k_u = KSL_RN_LANESF(x * k_t), k_v = k_u - 0.16666667f, k_w =
          KSL_RN_LANESF(x * k_v),
      k_x = k_w + 1.0f, k = ksl_choice_lanesf(theta_b, k_x, far_k);
  const ksl_statesf g2a = KSL_RN_LANESF(2.4795963e-27f * x), g2b = g2a - 1.6117376e-24f, g2c =
      KSL_RN_LANESF(x * g2b),
      g2d = g2c + 8.896791e-22f, g2e = KSL_RN_LANESF(x * g2d), g2f = g2e - 4.1103176e-19f, g2g =
          KSL_RN_LANESF(x * g2f),
      g2h = g2g + 1.5619207e-16f, g2i = KSL_RN_LANESF(x * g2h), g2j = g2i - 4.7794773e-14f, g2k =
          KSL_RN_LANESF(x * g2j),
      g2l = g2k + 1.1470745e-11f, g2m = KSL_RN_LANESF(x * g2l), g2n = g2m - 2.0876756e-09f, g2o =
          KSL_RN_LANESF(x * g2n),
      g2p = g2o + 2.755732e-07f, g2q = KSL_RN_LANESF(x * g2p), g2r = g2q - 2.4801588e-05f, g2s =
          KSL_RN_LANESF(x * g2r),
      g2t = g2s + 0.0013888889f, g2u = KSL_RN_LANESF(x * g2t), g2v = g2u - 0.041666668f, g2w =
          KSL_RN_LANESF(x * g2v),
      g2 = g2w + 0.5f;
  const ksl_statesf near_a = KSL_RN_LANESF(x * g2), near = 1.0f - near_a;
  const ksl_statesf qo_1 = KSL_RN_LANESF(h_1 * k);
  const ksl_statesf qo_2 = KSL_RN_LANESF(h_2 * k);
  const ksl_statesf qo_3 = KSL_RN_LANESF(h_3 * k);
  const ksl_statesf qo_4 = ksl_choice_lanesf(theta_b, near, cosine);
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}
#endif

/* ksl_quaternionf_exp of n elements. */
static KSL_INLINED void ksl_quaternionf_exp_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *qo, ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
#if KSL_LANE_BYTES
  ksl_statesf v_states[3], qo_states[4];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(v + i * v_stride, 3, v_plane, v_stride, last, v_states);
    ksl_quaternionf_exp_states(v_states, qo_states);
    ksl_statesf_to_planes(qo_states, 4, qo + i * qo_stride, qo_plane, qo_stride, last);
  }
#else
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_exp(&v_i, &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
#endif
}

static KSL_INLINED void ksl_quaternionf_exp_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_quaternionf_t *qo, ptrdiff_t qo_stride) {
  ksl_quaternionf_exp_planes(n, (const float *)v, 1, 3 * v_stride, (float *)qo, 1, 4 * qo_stride);
}

#if KSL_LANE_BYTES
/* ksl_quaternionf_log of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_quaternionf_log_states(const ksl_statesf *q, ksl_statesf *vo) {
  const ksl_statesf s_size_1 = ksl_abs_lanesf(q[0]);
  const ksl_statesf s_size_2 = ksl_abs_lanesf(q[1]);
  const ksl_statesf s_size_3 = ksl_abs_lanesf(q[2]);
  const ksl_statesf s_size_4 = ksl_abs_lanesf(q[3]);
  const ksl_testsf s_largest1a = ksl_less_lanesf(s_size_1, s_size_2);
  const ksl_statesf s_largest1 = ksl_choice_lanesf(s_largest1a, s_size_2, s_size_1);
  const ksl_testsf s_largest2a = ksl_less_lanesf(s_largest1, s_size_3);
  const ksl_statesf s_largest2 = ksl_choice_lanesf(s_largest2a, s_size_3, s_largest1);
  const ksl_testsf s_largest3a = ksl_less_lanesf(s_largest2, s_size_4);
  const ksl_statesf s_largest3 = ksl_choice_lanesf(s_largest3a, s_size_4, s_largest2);
  const ksl_testsf s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s_largest3);
  const ksl_statesf s_b = ksl_choice_lanesf(s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s_c = ksl_less_lanesf(s_largest3, ksl_each_lanesf(256.0f));
  const ksl_statesf s_d = ksl_choice_lanesf(s_c, ksl_each_lanesf(1.8014399e+16f), s_b);
  const ksl_testsf s_e = ksl_less_lanesf(s_largest3, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s = ksl_choice_lanesf(s_e, ksl_each_lanesf(3.2451855e+32f), s_d);
  const ksl_statesf scaled_s_1 = q[0] * s;
  const ksl_statesf scaled_s_2 = q[1] * s;
  const ksl_statesf scaled_s_3 = q[2] * s;
  const ksl_statesf scaled_s_4 = q[3] * s;
  const ksl_statesf upper_0a = -scaled_s_1;
  const ksl_testsf upper_0b = ksl_less_lanesf(scaled_s_4, ksl_each_lanesf(0.0f));
  const ksl_statesf upper_1 = ksl_choice_lanesf(upper_0b, upper_0a, scaled_s_1);
  const ksl_statesf upper_1a = -scaled_s_2,
      upper_2 = ksl_choice_lanesf(upper_0b, upper_1a, scaled_s_2);
  const ksl_statesf upper_2a = -scaled_s_3,
      upper_3 = ksl_choice_lanesf(upper_0b, upper_2a, scaled_s_3);
  const ksl_statesf upper_3a = -scaled_s_4;
  const ksl_statesf v_s_size_1 = ksl_abs_lanesf(upper_1);
  const ksl_statesf v_s_size_2 = ksl_abs_lanesf(upper_2);
  const ksl_statesf v_s_size_3 = ksl_abs_lanesf(upper_3);
  const ksl_testsf v_s_largest1a = ksl_less_lanesf(v_s_size_1, v_s_size_2);
  const ksl_statesf v_s_largest1 = ksl_choice_lanesf(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_testsf v_s_largest2a = ksl_less_lanesf(v_s_largest1, v_s_size_3);
  const ksl_statesf v_s_largest2 = ksl_choice_lanesf(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_testsf v_s_a = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf v_s_b = ksl_choice_lanesf(v_s_a, ksl_each_lanesf(1.8014399e+16f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_s_c = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf v_s = ksl_choice_lanesf(v_s_c, ksl_each_lanesf(3.2451855e+32f), v_s_b);
  const ksl_statesf v_y_1 = upper_1 * v_s;
  const ksl_statesf v_y_2 = upper_2 * v_s;
  const ksl_statesf v_y_3 = upper_3 * v_s;
  const ksl_statesf v_n_a = KSL_RN_LANESF(v_y_1 * v_y_1), v_n_b = KSL_RN_LANESF(v_y_2 * v_y_2),
      v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_RN_LANESF(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanesf(v_n_e);
  const ksl_testsf v_r_a = ksl_less_lanesf(ksl_each_lanesf(1.0f), v_s);
  const ksl_statesf v_r_b = ksl_choice_lanesf(v_r_a, ksl_each_lanesf(5.551115e-17f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_r_c = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), v_s);
  const ksl_statesf v_r = ksl_choice_lanesf(v_r_c, ksl_each_lanesf(3.081488e-33f), v_r_b);
  const ksl_statesf n = v_n * v_r;
  const ksl_statesf half = ksl_atan2_lanesf(n, ksl_choice_lanesf(upper_0b, upper_3a, scaled_s_4));
  const ksl_testsf divisor_a = ksl_equal_lanesf(n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf theta = 2.0f * half;
  const ksl_statesf k = theta / divisor;
  const ksl_statesf vector_1 = KSL_RN_LANESF(upper_1 * k);
  const ksl_statesf vector_2 = KSL_RN_LANESF(upper_2 * k);
  const ksl_statesf vector_3 = KSL_RN_LANESF(upper_3 * k);
  vo[0] = vector_1;
  vo[1] = vector_2;
  vo[2] = vector_3;
}
#endif

/* ksl_quaternionf_log of n elements. */
static KSL_INLINED void ksl_quaternionf_log_planes(ptrdiff_t n, const float *q, ptrdiff_t q_plane,
    ptrdiff_t q_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
#if KSL_LANE_BYTES
  ksl_statesf q_states[4], vo_states[3];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(q + i * q_stride, 4, q_plane, q_stride, last, q_states);
    ksl_quaternionf_log_states(q_states, vo_states);
    ksl_statesf_to_planes(vo_states, 3, vo + i * vo_stride, vo_plane, vo_stride, last);
  }
#else
  ksl_quaternionf_t q_i;
  if (n > 0) q_i = ksl_quaternionf_of_planes(q, q_plane);
  KSL_EACH_OF(n) {
    if (q_stride) q_i = ksl_quaternionf_of_planes(q + i * q_stride, q_plane);
    ksl_vec3f_t vo_i;
    ksl_quaternionf_log(&q_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
#endif
}

static KSL_INLINED void ksl_quaternionf_log_many(ptrdiff_t n, const ksl_quaternionf_t *q,
    ptrdiff_t q_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  ksl_quaternionf_log_planes(n, (const float *)q, 1, 4 * q_stride, (float *)vo, 1, 3 * vo_stride);
}

#if KSL_LANE_BYTES
/* ksl_quaternionf_interpolated of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_quaternionf_interpolated_states(const ksl_statesf *q1,
    const ksl_statesf *q2, const ksl_statesf *k, ksl_statesf *qo) {
  const ksl_statesf between_0a = KSL_RN_LANESF(q1[3] * q2[0]), between_0b = KSL_RN_LANESF(q1[0] *
      q2[3]),
      between_0c = between_0a - between_0b, between_0d = KSL_RN_LANESF(q1[2] * q2[1]),
      between_0e = KSL_RN_LANESF(q1[1] * q2[2]), between_0f = between_0d - between_0e,
      between_1 = between_0c + between_0f;
  const ksl_statesf between_1a = KSL_RN_LANESF(q1[0] * q2[2]), between_1b = KSL_RN_LANESF(q1[2] *
      q2[0]),
      between_1c = between_1a - between_1b, between_1d = KSL_RN_LANESF(q1[3] * q2[1]),
      between_1e = KSL_RN_LANESF(q1[1] * q2[3]), between_1f = between_1d - between_1e,
      between_2 = between_1c + between_1f;
  const ksl_statesf between_2a = KSL_RN_LANESF(q1[1] * q2[0]), between_2b = KSL_RN_LANESF(q1[0] *
      q2[1]),
      between_2c = between_2a - between_2b, between_2d = KSL_RN_LANESF(q1[3] * q2[2]),
      between_2e = KSL_RN_LANESF(q1[2] * q2[3]), between_2f = between_2d - between_2e,
      between_3 = between_2c + between_2f;
  const ksl_statesf between_3a = KSL_RN_LANESF(q1[0] * q2[0]), between_3b = KSL_RN_LANESF(q1[1] *
      q2[1]),
      between_3c = between_3a + between_3b, between_3d = KSL_RN_LANESF(q1[2] * q2[2]),
      between_3e = between_3c + between_3d, between_3f = KSL_RN_LANESF(q1[3] * q2[3]),
      between_4 = between_3e + between_3f;
  const ksl_statesf upper_0a = -between_1;
  const ksl_testsf upper_0b = ksl_less_lanesf(between_4, ksl_each_lanesf(0.0f));
  const ksl_statesf upper_1 = ksl_choice_lanesf(upper_0b, upper_0a, between_1);
  const ksl_statesf upper_1a = -between_2,
      upper_2 = ksl_choice_lanesf(upper_0b, upper_1a, between_2);
  const ksl_statesf upper_2a = -between_3,
      upper_3 = ksl_choice_lanesf(upper_0b, upper_2a, between_3);
  const ksl_statesf upper_3a = -between_4;
  const ksl_statesf v_s_size_1 = ksl_abs_lanesf(upper_1);
  const ksl_statesf v_s_size_2 = ksl_abs_lanesf(upper_2);
  const ksl_statesf v_s_size_3 = ksl_abs_lanesf(upper_3);
  const ksl_testsf v_s_largest1a = ksl_less_lanesf(v_s_size_1, v_s_size_2);
  const ksl_statesf v_s_largest1 = ksl_choice_lanesf(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_testsf v_s_largest2a = ksl_less_lanesf(v_s_largest1, v_s_size_3);
  const ksl_statesf v_s_largest2 = ksl_choice_lanesf(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_testsf v_s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), v_s_largest2);
  const ksl_statesf v_s_b = ksl_choice_lanesf(v_s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_s_c = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf v_s_d = ksl_choice_lanesf(v_s_c, ksl_each_lanesf(1.8014399e+16f), v_s_b);
  const ksl_testsf v_s_e = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf v_s = ksl_choice_lanesf(v_s_e, ksl_each_lanesf(3.2451855e+32f), v_s_d);
  const ksl_statesf v_y_1 = upper_1 * v_s;
  const ksl_statesf v_y_2 = upper_2 * v_s;
  const ksl_statesf v_y_3 = upper_3 * v_s;
  const ksl_statesf v_n_a = KSL_RN_LANESF(v_y_1 * v_y_1), v_n_b = KSL_RN_LANESF(v_y_2 * v_y_2),
      v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_RN_LANESF(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanesf(v_n_e);
  const ksl_testsf v_r_a = ksl_less_lanesf(v_s, ksl_each_lanesf(1.0f));
  const ksl_statesf v_r_b = ksl_choice_lanesf(v_r_a, ksl_each_lanesf(3.689349e+19f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_r_c = ksl_less_lanesf(ksl_each_lanesf(1.0f), v_s);
  const ksl_statesf v_r_d = ksl_choice_lanesf(v_r_c, ksl_each_lanesf(5.551115e-17f), v_r_b);
  const ksl_testsf v_r_e = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), v_s);
  const ksl_statesf v_r = ksl_choice_lanesf(v_r_e, ksl_each_lanesf(3.081488e-33f), v_r_d);
  const ksl_statesf n = v_n * v_r;
  const ksl_statesf half = ksl_atan2_lanesf(n, ksl_choice_lanesf(upper_0b, upper_3a, between_4));
  const ksl_testsf divisor_a = ksl_equal_lanesf(n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf rate = half / divisor;
  const ksl_statesf step_1 = KSL_RN_LANESF(rate * (k[0] * upper_1));
  const ksl_statesf step_2 = KSL_RN_LANESF(rate * (k[0] * upper_2));
  const ksl_statesf step_3 = KSL_RN_LANESF(rate * (k[0] * upper_3));
  const ksl_statesf exp_sizes_a = ksl_abs_lanesf(step_1) + ksl_abs_lanesf(step_2),
      exp_sizes = exp_sizes_a + ksl_abs_lanesf(step_3);
  const ksl_statesf exp_grid = KSL_RN_LANESF(exp_sizes * 8192.0f);
  const ksl_statesf exp_high_1 = step_1 + exp_grid - exp_grid;
  const ksl_statesf exp_high_2 = step_2 + exp_grid - exp_grid;
  const ksl_statesf exp_high_3 = step_3 + exp_grid - exp_grid;
  const ksl_statesf exp_squares_a = KSL_RN_LANESF(exp_high_1 * exp_high_1),
      exp_squares_b = KSL_RN_LANESF(exp_high_2 * exp_high_2), exp_squares_c = exp_squares_a +
          exp_squares_b,
      exp_squares_d = KSL_RN_LANESF(exp_high_3 * exp_high_3), exp_squares = exp_squares_c +
          exp_squares_d;
  const ksl_statesf exp_cross_a = KSL_RN_LANESF((step_1 - exp_high_1) * (step_1 + exp_high_1)),
      exp_cross_b = KSL_RN_LANESF((step_2 - exp_high_2) * (step_2 + exp_high_2)),
      exp_cross_c = exp_cross_a + exp_cross_b,
      exp_cross_d = KSL_RN_LANESF((step_3 - exp_high_3) * (step_3 + exp_high_3)),
      exp_cross = exp_cross_c + exp_cross_d;
  const ksl_statesf exp_x = exp_squares + exp_cross;
  const ksl_statesf exp_theta_a = ksl_sqrt_lanesf(exp_x);
  const ksl_testsf exp_theta_b = ksl_less_lanesf(exp_x, ksl_each_lanesf(1.0f));
  const ksl_statesf exp_theta = ksl_choice_lanesf(exp_theta_b, ksl_each_lanesf(1.0f), exp_theta_a);
  const ksl_statesf exp_theta_shifted = exp_grid + exp_theta;
  const ksl_statesf exp_theta_high = exp_theta_shifted - exp_grid;
  const ksl_statesf exp_theta_low = exp_theta - exp_theta_high;
  const ksl_statesf exp_theta_sum = exp_theta + exp_theta_high;
  const ksl_statesf exp_cross_rest_a = KSL_RN_LANESF(exp_theta_low * exp_theta_sum),
      exp_cross_rest = exp_cross - exp_cross_rest_a;
  const ksl_statesf exp_exact_a = KSL_RN_LANESF(exp_theta_high * exp_theta_high),
      exp_exact = exp_squares - exp_exact_a;
  const ksl_statesf exp_residual = exp_cross_rest + exp_exact;
  const ksl_statesf exp_small_a = 0.5f * exp_residual, exp_small = exp_small_a / exp_theta;
  const ksl_statesf exp_delta_a = ksl_abs_lanesf(exp_small);
  const ksl_testsf exp_delta_b = ksl_less_lanesf(exp_delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf exp_delta = ksl_choice_lanesf(exp_delta_b, exp_small, ksl_each_lanesf(0.0f));
  ksl_statesf exp_far_cosine_a; const ksl_statesf exp_far_sine_a = ksl_sincos_lanesf(exp_theta,
      &exp_far_cosine_a);
  const ksl_statesf exp_far_sine = ksl_choice_lanesf(exp_theta_b, ksl_each_lanesf(1.0f),
      exp_far_sine_a);
  const ksl_statesf exp_far_cosine = ksl_choice_lanesf(exp_theta_b, ksl_each_lanesf(0.0f),
      exp_far_cosine_a);
  const ksl_statesf exp_sine_a = KSL_RN_LANESF(exp_delta * exp_far_cosine),
      exp_sine = exp_sine_a + exp_far_sine;
  const ksl_statesf exp_cosine_a = KSL_RN_LANESF(exp_delta * exp_far_sine),
      exp_cosine = exp_far_cosine - exp_cosine_a;
  const ksl_statesf exp_far_k = exp_sine / exp_theta;
  const ksl_statesf exp_k_a = KSL_RN_LANESF(6.4469503e-26f * exp_x), exp_k_b = exp_k_a -
      3.8681703e-23f,
      exp_k_c = KSL_RN_LANESF(exp_x * exp_k_b), exp_k_d = exp_k_c + 1.9572942e-20f,
      exp_k_e = KSL_RN_LANESF(exp_x * exp_k_d), exp_k_f = exp_k_e - 8.220635e-18f,
      exp_k_g = KSL_RN_LANESF(exp_x * exp_k_f), exp_k_h = exp_k_g + 2.8114574e-15f,
      exp_k_i = KSL_RN_LANESF(exp_x * exp_k_h), exp_k_j = exp_k_i - 7.6471636e-13f,
      exp_k_k = KSL_RN_LANESF(exp_x * exp_k_j), exp_k_l = exp_k_k + 1.6059044e-10f,
      exp_k_m = KSL_RN_LANESF(exp_x * exp_k_l), exp_k_n = exp_k_m - 2.5052108e-08f,
      exp_k_o = KSL_RN_LANESF(exp_x * exp_k_n), exp_k_p = exp_k_o + 2.7557319e-06f,
      exp_k_q = KSL_RN_LANESF(exp_x * exp_k_p), exp_k_r = exp_k_q - 0.0001984127f,
      exp_k_s = KSL_RN_LANESF(exp_x * exp_k_r), exp_k_t = exp_k_s + 0.008333334f,
      exp_k_u = KSL_RN_LANESF(exp_x * exp_k_t), exp_k_v = exp_k_u - 0.16666667f, exp_k_w =
          KSL_RN_LANESF(exp_x * exp_k_v),
      exp_k_x = exp_k_w + 1.0f, exp_k = ksl_choice_lanesf(exp_theta_b, exp_k_x, exp_far_k);
  const ksl_statesf exp_g2a = KSL_RN_LANESF(2.4795963e-27f * exp_x), exp_g2b = exp_g2a -
      1.6117376e-24f,
      exp_g2c = KSL_RN_LANESF(exp_x * exp_g2b), exp_g2d = exp_g2c + 8.896791e-22f,
      exp_g2e = KSL_RN_LANESF(exp_x * exp_g2d), exp_g2f = exp_g2e - 4.1103176e-19f,
      exp_g2g = KSL_RN_LANESF(exp_x * exp_g2f), exp_g2h = exp_g2g + 1.5619207e-16f,
      exp_g2i = KSL_RN_LANESF(exp_x * exp_g2h), exp_g2j = exp_g2i - 4.7794773e-14f,
      exp_g2k = KSL_RN_LANESF(exp_x * exp_g2j), exp_g2l = exp_g2k + 1.1470745e-11f,
      exp_g2m = KSL_RN_LANESF(exp_x * exp_g2l), exp_g2n = exp_g2m - 2.0876756e-09f,
      exp_g2o = KSL_RN_LANESF(exp_x * exp_g2n), exp_g2p = exp_g2o + 2.755732e-07f,
      exp_g2q = KSL_RN_LANESF(exp_x * exp_g2p), exp_g2r = exp_g2q - 2.4801588e-05f,
      exp_g2s = KSL_RN_LANESF(exp_x * exp_g2r), exp_g2t = exp_g2s + 0.0013888889f,
      exp_g2u = KSL_RN_LANESF(exp_x * exp_g2t), exp_g2v = exp_g2u - 0.041666668f,
      exp_g2w = KSL_RN_LANESF(exp_x * exp_g2v), exp_g2 = exp_g2w + 0.5f;
  const ksl_statesf exp_near_a = KSL_RN_LANESF(exp_x * exp_g2), exp_near = 1.0f - exp_near_a;
  const ksl_statesf power_1 = step_1 * exp_k;
  const ksl_statesf power_2 = step_2 * exp_k;
  const ksl_statesf power_3 = step_3 * exp_k;
  const ksl_statesf power_4 = ksl_choice_lanesf(exp_theta_b, exp_near, exp_cosine);
  const ksl_statesf qo_0a = KSL_RN_LANESF(q1[0] * power_4), qo_0b = KSL_RN_LANESF(q1[1] * power_3),
      qo_0c = KSL_RN_LANESF(q1[2] * power_2), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_RN_LANESF(q1[3] * power_1), qo_1 = qo_0e + qo_0f;
  const ksl_statesf qo_1a = KSL_RN_LANESF(q1[2] * power_1), qo_1b = KSL_RN_LANESF(q1[0] * power_3),
      qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_RN_LANESF(q1[1] * power_4), qo_1e = qo_1c + qo_1d, qo_1f = KSL_RN_LANESF(q1[3] *
          power_2),
      qo_2 = qo_1e + qo_1f;
  const ksl_statesf qo_2a = KSL_RN_LANESF(q1[0] * power_2), qo_2b = KSL_RN_LANESF(q1[1] * power_1),
      qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_RN_LANESF(q1[2] * power_4), qo_2e = qo_2c + qo_2d, qo_2f = KSL_RN_LANESF(q1[3] *
          power_3),
      qo_3 = qo_2e + qo_2f;
  const ksl_statesf qo_3a = KSL_RN_LANESF(q1[3] * power_4), qo_3b = KSL_RN_LANESF(q1[0] * power_1),
      qo_3c = KSL_RN_LANESF(q1[1] * power_2), qo_3d = qo_3b + qo_3c, qo_3e = KSL_RN_LANESF(q1[2] *
          power_3),
      qo_3f = qo_3d + qo_3e, qo_4 = qo_3a - qo_3f;
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}
#endif

/* ksl_quaternionf_interpolated of n elements. */
static KSL_INLINED void ksl_quaternionf_interpolated_planes(ptrdiff_t n, const float *q1,
    ptrdiff_t q1_plane, ptrdiff_t q1_stride, const float *q2, ptrdiff_t q2_plane,
    ptrdiff_t q2_stride, const float *k, ptrdiff_t k_stride, float *qo,
    ptrdiff_t qo_plane, ptrdiff_t qo_stride) {
#if KSL_LANE_BYTES
  ksl_statesf q1_states[4], q2_states[4], k_states[1], qo_states[4];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(q1 + i * q1_stride, 4, q1_plane, q1_stride, last, q1_states);
    ksl_statesf_of_planes(q2 + i * q2_stride, 4, q2_plane, q2_stride, last, q2_states);
    ksl_statesf_of_planes(k + i * k_stride, 1, 1, k_stride, last, k_states);
    ksl_quaternionf_interpolated_states(q1_states, q2_states, k_states, qo_states);
    ksl_statesf_to_planes(qo_states, 4, qo + i * qo_stride, qo_plane, qo_stride, last);
  }
#else
  ksl_quaternionf_t q1_i;
  if (n > 0) q1_i = ksl_quaternionf_of_planes(q1, q1_plane);
  KSL_EACH_OF(n) {
    if (q1_stride) q1_i = ksl_quaternionf_of_planes(q1 + i * q1_stride, q1_plane);
    const ksl_quaternionf_t q2_i = ksl_quaternionf_of_planes(q2 + i * q2_stride, q2_plane);
    ksl_quaternionf_t qo_i;
    ksl_quaternionf_interpolated(&q1_i, &q2_i, k[i * k_stride], &qo_i);
    ksl_quaternionf_to_planes(&qo_i, qo + i * qo_stride, qo_plane);
  }
#endif
}

static KSL_INLINED void ksl_quaternionf_interpolated_many(ptrdiff_t n, const ksl_quaternionf_t *q1,
    ptrdiff_t q1_stride, const ksl_quaternionf_t *q2, ptrdiff_t q2_stride,
    const float *k, ptrdiff_t k_stride, ksl_quaternionf_t *qo,
    ptrdiff_t qo_stride) {
  ksl_quaternionf_interpolated_planes(n, (const float *)q1, 1, 4 * q1_stride, (const float *)q2, 1,
      4 * q2_stride, k, k_stride, (float *)qo, 1, 4 * qo_stride);
}

#endif
