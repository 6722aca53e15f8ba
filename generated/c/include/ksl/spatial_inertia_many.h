/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_SPATIAL_INERTIA_MANY_H
#define KSL_SPATIAL_INERTIA_MANY_H

#include "spatial_inertia.h"
#include "ksl_planes.h"

/* ksl_spatial_inertia_copy of n elements. */
static KSL_INLINED void ksl_spatial_inertia_copy_many(ptrdiff_t n, const ksl_spatial_inertia_t *Bi,
    ptrdiff_t Bi_stride, ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_copy(Bi + i * Bi_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_copy_planes(ptrdiff_t n, const double *Bi,
    ptrdiff_t Bi_plane, ptrdiff_t Bi_stride, double *Bo, ptrdiff_t Bo_plane,
    ptrdiff_t Bo_stride) {
  ksl_spatial_inertia_t Bi_i;
  if (n > 0) Bi_i = ksl_spatial_inertia_of_planes(Bi, Bi_plane);
  KSL_EACH_OF(n) {
    if (Bi_stride) Bi_i = ksl_spatial_inertia_of_planes(Bi + i * Bi_stride, Bi_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_spatial_inertia_copy(&Bi_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertia_scale of n elements. */
static KSL_INLINED void ksl_spatial_inertia_scale_many(ptrdiff_t n, ksl_spatial_inertia_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_spatial_inertia_scale_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_t self_i = ksl_spatial_inertia_of_planes(self + i * self_stride, self_plane);
    ksl_spatial_inertia_scale(&self_i, a[i * a_stride]);
    ksl_spatial_inertia_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_add_BB of n elements. */
static KSL_INLINED void ksl_add_BB_many(ptrdiff_t n, const ksl_spatial_inertia_t *B1,
    ptrdiff_t B1_stride, const ksl_spatial_inertia_t *B2, ptrdiff_t B2_stride,
    ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_BB(B1 + i * B1_stride, B2 + i * B2_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_add_BB_planes(ptrdiff_t n, const double *B1, ptrdiff_t B1_plane,
    ptrdiff_t B1_stride, const double *B2, ptrdiff_t B2_plane,
    ptrdiff_t B2_stride, double *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_spatial_inertia_t B1_i;
  if (n > 0) B1_i = ksl_spatial_inertia_of_planes(B1, B1_plane);
  KSL_EACH_OF(n) {
    if (B1_stride) B1_i = ksl_spatial_inertia_of_planes(B1 + i * B1_stride, B1_plane);
    const ksl_spatial_inertia_t B2_i = ksl_spatial_inertia_of_planes(B2 + i * B2_stride, B2_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_add_BB(&B1_i, &B2_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_subtract_BB of n elements. */
static KSL_INLINED void ksl_subtract_BB_many(ptrdiff_t n, const ksl_spatial_inertia_t *B1,
    ptrdiff_t B1_stride, const ksl_spatial_inertia_t *B2, ptrdiff_t B2_stride,
    ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_BB(B1 + i * B1_stride, B2 + i * B2_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_subtract_BB_planes(ptrdiff_t n, const double *B1, ptrdiff_t B1_plane,
    ptrdiff_t B1_stride, const double *B2, ptrdiff_t B2_plane,
    ptrdiff_t B2_stride, double *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_spatial_inertia_t B1_i;
  if (n > 0) B1_i = ksl_spatial_inertia_of_planes(B1, B1_plane);
  KSL_EACH_OF(n) {
    if (B1_stride) B1_i = ksl_spatial_inertia_of_planes(B1 + i * B1_stride, B1_plane);
    const ksl_spatial_inertia_t B2_i = ksl_spatial_inertia_of_planes(B2 + i * B2_stride, B2_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_subtract_BB(&B1_i, &B2_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertia_from_com of n elements. */
static KSL_INLINED void ksl_spatial_inertia_from_com_many(ptrdiff_t n, const double *m,
    ptrdiff_t m_stride, const ksl_vec3_t *com, ptrdiff_t com_stride,
    const ksl_mat3x3_t *Ic, ptrdiff_t Ic_stride, ksl_spatial_inertia_t *Bo,
    ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_from_com(m[i * m_stride], com + i * com_stride, Ic + i * Ic_stride,
        Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_from_com_planes(ptrdiff_t n, const double *m,
    ptrdiff_t m_stride, const double *com, ptrdiff_t com_plane,
    ptrdiff_t com_stride, const double *Ic, ptrdiff_t Ic_plane,
    ptrdiff_t Ic_stride, double *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t com_i = ksl_vec3_of_planes(com + i * com_stride, com_plane);
    const ksl_mat3x3_t Ic_i = ksl_mat3x3_of_planes(Ic + i * Ic_stride, Ic_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_spatial_inertia_from_com(m[i * m_stride], &com_i, &Ic_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertia_from_inertia of n elements. */
static KSL_INLINED void ksl_spatial_inertia_from_inertia_many(ptrdiff_t n, const ksl_inertia_t *J,
    ptrdiff_t J_stride, ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_from_inertia(J + i * J_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_from_inertia_planes(ptrdiff_t n, const double *J,
    ptrdiff_t J_plane, ptrdiff_t J_stride, double *Bo, ptrdiff_t Bo_plane,
    ptrdiff_t Bo_stride) {
  ksl_inertia_t J_i;
  if (n > 0) J_i = ksl_inertia_of_planes(J, J_plane);
  KSL_EACH_OF(n) {
    if (J_stride) J_i = ksl_inertia_of_planes(J + i * J_stride, J_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_spatial_inertia_from_inertia(&J_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_inertia_from_spatial_inertia of n elements. */
static KSL_INLINED void ksl_inertia_from_spatial_inertia_many(ptrdiff_t n,
    const ksl_spatial_inertia_t *B, ptrdiff_t B_stride, ksl_inertia_t *Jo,
    ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_from_spatial_inertia(B + i * B_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertia_from_spatial_inertia_planes(ptrdiff_t n, const double *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, double *Jo, ptrdiff_t Jo_plane,
    ptrdiff_t Jo_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    ksl_inertia_t Jo_i;
    ksl_inertia_from_spatial_inertia(&B_i, &Jo_i);
    ksl_inertia_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_spatial_inertia_com of n elements. */
static KSL_INLINED void ksl_spatial_inertia_com_many(ptrdiff_t n, const ksl_spatial_inertia_t *B,
    ptrdiff_t B_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_com(B + i * B_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_com_planes(ptrdiff_t n, const double *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    ksl_vec3_t vo_i;
    ksl_spatial_inertia_com(&B_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_spatial_inertia_about_com of n elements. */
static KSL_INLINED void ksl_spatial_inertia_about_com_many(ptrdiff_t n,
    const ksl_spatial_inertia_t *B, ptrdiff_t B_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_about_com(B + i * B_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_about_com_planes(ptrdiff_t n, const double *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    ksl_mat3x3_t Ro_i;
    ksl_spatial_inertia_about_com(&B_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_spatial_inertia_matrix of n elements. */
static KSL_INLINED void ksl_spatial_inertia_matrix_many(ptrdiff_t n, const ksl_spatial_inertia_t *B,
    ptrdiff_t B_stride, ksl_mat6x6_t *Mo, ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_matrix(B + i * B_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_matrix_planes(ptrdiff_t n, const double *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, double *Mo, ptrdiff_t Mo_plane,
    ptrdiff_t Mo_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    ksl_mat6x6_t Mo_i;
    ksl_spatial_inertia_matrix(&B_i, &Mo_i);
    ksl_mat6x6_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_product_Bs of n elements. */
static KSL_INLINED void ksl_product_Bs_many(ptrdiff_t n, const ksl_spatial_inertia_t *B,
    ptrdiff_t B_stride, const ksl_screw_t *s, ptrdiff_t s_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Bs(B + i * B_stride, s + i * s_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_Bs_planes(ptrdiff_t n, const double *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, const double *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    const ksl_screw_t s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_coscrew_t co_i;
    ksl_product_Bs(&B_i, &s_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_spatial_inertia_energy of n elements. */
static KSL_INLINED void ksl_spatial_inertia_energy_many(ptrdiff_t n, const ksl_spatial_inertia_t *B,
    ptrdiff_t B_stride, const ksl_screw_t *s, ptrdiff_t s_stride, double *energy,
    ptrdiff_t energy_stride) {
  KSL_EACH_OF(n) {
    energy[i * energy_stride] = ksl_spatial_inertia_energy(B + i * B_stride, s + i * s_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_energy_planes(ptrdiff_t n, const double *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, double *energy, ptrdiff_t energy_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    const ksl_screw_t s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    energy[i * energy_stride] = ksl_spatial_inertia_energy(&B_i, &s_i);
  }
}

/* ksl_spatial_inertia_net_wrench of n elements. */
static KSL_INLINED void ksl_spatial_inertia_net_wrench_many(ptrdiff_t n,
    const ksl_spatial_inertia_t *B, ptrdiff_t B_stride, const ksl_vec3_t *w,
    ptrdiff_t w_stride, const ksl_screw_t *ds, ptrdiff_t ds_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_net_wrench(B + i * B_stride, w + i * w_stride, ds + i * ds_stride,
        co + i * co_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_net_wrench_planes(ptrdiff_t n, const double *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, const double *w, ptrdiff_t w_plane,
    ptrdiff_t w_stride, const double *ds, ptrdiff_t ds_plane,
    ptrdiff_t ds_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    const ksl_vec3_t w_i = ksl_vec3_of_planes(w + i * w_stride, w_plane);
    const ksl_screw_t ds_i = ksl_screw_of_planes(ds + i * ds_stride, ds_plane);
    ksl_coscrew_t co_i;
    ksl_spatial_inertia_net_wrench(&B_i, &w_i, &ds_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_spatial_inertia_shifted of n elements. */
static KSL_INLINED void ksl_spatial_inertia_shifted_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_spatial_inertia_t *B, ptrdiff_t B_stride,
    ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_shifted(t + i * t_stride, B + i * B_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_shifted_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, double *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_spatial_inertia_t B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_spatial_inertia_shifted(&t_i, &B_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertia_transformed of n elements. */
static KSL_INLINED void ksl_spatial_inertia_transformed_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_spatial_inertia_t *B, ptrdiff_t B_stride,
    ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_transformed(D + i * D_stride, B + i * B_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_transformed_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, double *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_spatial_inertia_t B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_spatial_inertia_transformed(&D_i, &B_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertia_consistency of n elements. */
static KSL_INLINED void ksl_spatial_inertia_consistency_many(ptrdiff_t n,
    const ksl_spatial_inertia_t *B, ptrdiff_t B_stride, double *pivot,
    ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_spatial_inertia_consistency(B + i * B_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_consistency_planes(ptrdiff_t n, const double *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, double *pivot, ptrdiff_t pivot_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    pivot[i * pivot_stride] = ksl_spatial_inertia_consistency(&B_i);
  }
}

/* ksl_spatial_inertiaf_copy of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_copy_many(ptrdiff_t n,
    const ksl_spatial_inertiaf_t *Bi, ptrdiff_t Bi_stride,
    ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_copy(Bi + i * Bi_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_copy_planes(ptrdiff_t n, const float *Bi,
    ptrdiff_t Bi_plane, ptrdiff_t Bi_stride, float *Bo, ptrdiff_t Bo_plane,
    ptrdiff_t Bo_stride) {
  ksl_spatial_inertiaf_t Bi_i;
  if (n > 0) Bi_i = ksl_spatial_inertiaf_of_planes(Bi, Bi_plane);
  KSL_EACH_OF(n) {
    if (Bi_stride) Bi_i = ksl_spatial_inertiaf_of_planes(Bi + i * Bi_stride, Bi_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_spatial_inertiaf_copy(&Bi_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertiaf_scale of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_scale_many(ptrdiff_t n, ksl_spatial_inertiaf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_scale_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_t self_i = ksl_spatial_inertiaf_of_planes(self + i * self_stride, self_plane);
    ksl_spatial_inertiaf_scale(&self_i, a[i * a_stride]);
    ksl_spatial_inertiaf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_add_BBf of n elements. */
static KSL_INLINED void ksl_add_BBf_many(ptrdiff_t n, const ksl_spatial_inertiaf_t *B1,
    ptrdiff_t B1_stride, const ksl_spatial_inertiaf_t *B2, ptrdiff_t B2_stride,
    ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_BBf(B1 + i * B1_stride, B2 + i * B2_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_add_BBf_planes(ptrdiff_t n, const float *B1, ptrdiff_t B1_plane,
    ptrdiff_t B1_stride, const float *B2, ptrdiff_t B2_plane,
    ptrdiff_t B2_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_spatial_inertiaf_t B1_i;
  if (n > 0) B1_i = ksl_spatial_inertiaf_of_planes(B1, B1_plane);
  KSL_EACH_OF(n) {
    if (B1_stride) B1_i = ksl_spatial_inertiaf_of_planes(B1 + i * B1_stride, B1_plane);
    const ksl_spatial_inertiaf_t B2_i = ksl_spatial_inertiaf_of_planes(B2 + i * B2_stride, B2_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_add_BBf(&B1_i, &B2_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_subtract_BBf of n elements. */
static KSL_INLINED void ksl_subtract_BBf_many(ptrdiff_t n, const ksl_spatial_inertiaf_t *B1,
    ptrdiff_t B1_stride, const ksl_spatial_inertiaf_t *B2, ptrdiff_t B2_stride,
    ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_BBf(B1 + i * B1_stride, B2 + i * B2_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_subtract_BBf_planes(ptrdiff_t n, const float *B1, ptrdiff_t B1_plane,
    ptrdiff_t B1_stride, const float *B2, ptrdiff_t B2_plane,
    ptrdiff_t B2_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_spatial_inertiaf_t B1_i;
  if (n > 0) B1_i = ksl_spatial_inertiaf_of_planes(B1, B1_plane);
  KSL_EACH_OF(n) {
    if (B1_stride) B1_i = ksl_spatial_inertiaf_of_planes(B1 + i * B1_stride, B1_plane);
    const ksl_spatial_inertiaf_t B2_i = ksl_spatial_inertiaf_of_planes(B2 + i * B2_stride, B2_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_subtract_BBf(&B1_i, &B2_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertiaf_from_com of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_from_com_many(ptrdiff_t n, const float *m,
    ptrdiff_t m_stride, const ksl_vec3f_t *com, ptrdiff_t com_stride,
    const ksl_mat3x3f_t *Ic, ptrdiff_t Ic_stride, ksl_spatial_inertiaf_t *Bo,
    ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_from_com(m[i * m_stride], com + i * com_stride, Ic + i * Ic_stride,
        Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_from_com_planes(ptrdiff_t n, const float *m,
    ptrdiff_t m_stride, const float *com, ptrdiff_t com_plane,
    ptrdiff_t com_stride, const float *Ic, ptrdiff_t Ic_plane,
    ptrdiff_t Ic_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t com_i = ksl_vec3f_of_planes(com + i * com_stride, com_plane);
    const ksl_mat3x3f_t Ic_i = ksl_mat3x3f_of_planes(Ic + i * Ic_stride, Ic_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_spatial_inertiaf_from_com(m[i * m_stride], &com_i, &Ic_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertiaf_from_inertia of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_from_inertia_many(ptrdiff_t n, const ksl_inertiaf_t *J,
    ptrdiff_t J_stride, ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_from_inertia(J + i * J_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_from_inertia_planes(ptrdiff_t n, const float *J,
    ptrdiff_t J_plane, ptrdiff_t J_stride, float *Bo, ptrdiff_t Bo_plane,
    ptrdiff_t Bo_stride) {
  ksl_inertiaf_t J_i;
  if (n > 0) J_i = ksl_inertiaf_of_planes(J, J_plane);
  KSL_EACH_OF(n) {
    if (J_stride) J_i = ksl_inertiaf_of_planes(J + i * J_stride, J_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_spatial_inertiaf_from_inertia(&J_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_inertiaf_from_spatial_inertia of n elements. */
static KSL_INLINED void ksl_inertiaf_from_spatial_inertia_many(ptrdiff_t n,
    const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride, ksl_inertiaf_t *Jo,
    ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_from_spatial_inertia(B + i * B_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_from_spatial_inertia_planes(ptrdiff_t n, const float *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, float *Jo, ptrdiff_t Jo_plane,
    ptrdiff_t Jo_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    ksl_inertiaf_t Jo_i;
    ksl_inertiaf_from_spatial_inertia(&B_i, &Jo_i);
    ksl_inertiaf_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_spatial_inertiaf_com of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_com_many(ptrdiff_t n, const ksl_spatial_inertiaf_t *B,
    ptrdiff_t B_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_com(B + i * B_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_com_planes(ptrdiff_t n, const float *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, float *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    ksl_vec3f_t vo_i;
    ksl_spatial_inertiaf_com(&B_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_spatial_inertiaf_about_com of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_about_com_many(ptrdiff_t n,
    const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_about_com(B + i * B_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_about_com_planes(ptrdiff_t n, const float *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, float *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_spatial_inertiaf_about_com(&B_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_spatial_inertiaf_matrix of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_matrix_many(ptrdiff_t n,
    const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride, ksl_mat6x6f_t *Mo,
    ptrdiff_t Mo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_matrix(B + i * B_stride, Mo + i * Mo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_matrix_planes(ptrdiff_t n, const float *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, float *Mo, ptrdiff_t Mo_plane,
    ptrdiff_t Mo_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    ksl_mat6x6f_t Mo_i;
    ksl_spatial_inertiaf_matrix(&B_i, &Mo_i);
    ksl_mat6x6f_to_planes(&Mo_i, Mo + i * Mo_stride, Mo_plane);
  }
}

/* ksl_product_Bsf of n elements. */
static KSL_INLINED void ksl_product_Bsf_many(ptrdiff_t n, const ksl_spatial_inertiaf_t *B,
    ptrdiff_t B_stride, const ksl_screwf_t *s, ptrdiff_t s_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Bsf(B + i * B_stride, s + i * s_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_Bsf_planes(ptrdiff_t n, const float *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, const float *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    const ksl_screwf_t s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_coscrewf_t co_i;
    ksl_product_Bsf(&B_i, &s_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_spatial_inertiaf_energy of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_energy_many(ptrdiff_t n,
    const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride, const ksl_screwf_t *s,
    ptrdiff_t s_stride, float *energy, ptrdiff_t energy_stride) {
  KSL_EACH_OF(n) {
    energy[i * energy_stride] = ksl_spatial_inertiaf_energy(B + i * B_stride, s + i * s_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_energy_planes(ptrdiff_t n, const float *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, float *energy, ptrdiff_t energy_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    const ksl_screwf_t s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    energy[i * energy_stride] = ksl_spatial_inertiaf_energy(&B_i, &s_i);
  }
}

/* ksl_spatial_inertiaf_net_wrench of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_net_wrench_many(ptrdiff_t n,
    const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride, const ksl_vec3f_t *w,
    ptrdiff_t w_stride, const ksl_screwf_t *ds, ptrdiff_t ds_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_net_wrench(B + i * B_stride, w + i * w_stride, ds + i * ds_stride,
        co + i * co_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_net_wrench_planes(ptrdiff_t n, const float *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, const float *w, ptrdiff_t w_plane,
    ptrdiff_t w_stride, const float *ds, ptrdiff_t ds_plane, ptrdiff_t ds_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    const ksl_vec3f_t w_i = ksl_vec3f_of_planes(w + i * w_stride, w_plane);
    const ksl_screwf_t ds_i = ksl_screwf_of_planes(ds + i * ds_stride, ds_plane);
    ksl_coscrewf_t co_i;
    ksl_spatial_inertiaf_net_wrench(&B_i, &w_i, &ds_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_spatial_inertiaf_shifted of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_shifted_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride,
    ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_shifted(t + i * t_stride, B + i * B_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_shifted_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_spatial_inertiaf_t B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_spatial_inertiaf_shifted(&t_i, &B_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertiaf_transformed of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_transformed_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride,
    ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_transformed(D + i * D_stride, B + i * B_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_transformed_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_spatial_inertiaf_t B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_spatial_inertiaf_transformed(&D_i, &B_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertiaf_consistency of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_consistency_many(ptrdiff_t n,
    const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride, float *pivot,
    ptrdiff_t pivot_stride) {
  KSL_EACH_OF(n) {
    pivot[i * pivot_stride] = ksl_spatial_inertiaf_consistency(B + i * B_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_consistency_planes(ptrdiff_t n, const float *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, float *pivot, ptrdiff_t pivot_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    pivot[i * pivot_stride] = ksl_spatial_inertiaf_consistency(&B_i);
  }
}

#endif
