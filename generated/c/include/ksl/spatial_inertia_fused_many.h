/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_SPATIAL_INERTIA_FUSED_MANY_H
#define KSL_SPATIAL_INERTIA_FUSED_MANY_H

#include "spatial_inertia_fused.h"
#include "ksl_planes.h"

/* ksl_spatial_inertia_scale_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertia_scale_fused_many(ptrdiff_t n,
    ksl_spatial_inertia_t *self, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_spatial_inertia_scale_fused_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_t self_i = ksl_spatial_inertia_of_planes(self + i * self_stride, self_plane);
    ksl_spatial_inertia_scale_fused(&self_i, a[i * a_stride]);
    ksl_spatial_inertia_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_add_BB_fused of n elements. */
static KSL_INLINED void ksl_add_BB_fused_many(ptrdiff_t n, const ksl_spatial_inertia_t *B1,
    ptrdiff_t B1_stride, const ksl_spatial_inertia_t *B2, ptrdiff_t B2_stride,
    ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_BB_fused(B1 + i * B1_stride, B2 + i * B2_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_add_BB_fused_planes(ptrdiff_t n, const double *B1, ptrdiff_t B1_plane,
    ptrdiff_t B1_stride, const double *B2, ptrdiff_t B2_plane,
    ptrdiff_t B2_stride, double *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_spatial_inertia_t B1_i;
  if (n > 0) B1_i = ksl_spatial_inertia_of_planes(B1, B1_plane);
  KSL_EACH_OF(n) {
    if (B1_stride) B1_i = ksl_spatial_inertia_of_planes(B1 + i * B1_stride, B1_plane);
    const ksl_spatial_inertia_t B2_i = ksl_spatial_inertia_of_planes(B2 + i * B2_stride, B2_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_add_BB_fused(&B1_i, &B2_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_subtract_BB_fused of n elements. */
static KSL_INLINED void ksl_subtract_BB_fused_many(ptrdiff_t n, const ksl_spatial_inertia_t *B1,
    ptrdiff_t B1_stride, const ksl_spatial_inertia_t *B2, ptrdiff_t B2_stride,
    ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_BB_fused(B1 + i * B1_stride, B2 + i * B2_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_subtract_BB_fused_planes(ptrdiff_t n, const double *B1,
    ptrdiff_t B1_plane, ptrdiff_t B1_stride, const double *B2,
    ptrdiff_t B2_plane, ptrdiff_t B2_stride, double *Bo, ptrdiff_t Bo_plane,
    ptrdiff_t Bo_stride) {
  ksl_spatial_inertia_t B1_i;
  if (n > 0) B1_i = ksl_spatial_inertia_of_planes(B1, B1_plane);
  KSL_EACH_OF(n) {
    if (B1_stride) B1_i = ksl_spatial_inertia_of_planes(B1 + i * B1_stride, B1_plane);
    const ksl_spatial_inertia_t B2_i = ksl_spatial_inertia_of_planes(B2 + i * B2_stride, B2_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_subtract_BB_fused(&B1_i, &B2_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertia_from_com_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertia_from_com_fused_many(ptrdiff_t n, const double *m,
    ptrdiff_t m_stride, const ksl_vec3_t *com, ptrdiff_t com_stride,
    const ksl_mat3x3_t *Ic, ptrdiff_t Ic_stride, ksl_spatial_inertia_t *Bo,
    ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_from_com_fused(m[i * m_stride], com + i * com_stride, Ic + i * Ic_stride,
        Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_from_com_fused_planes(ptrdiff_t n, const double *m,
    ptrdiff_t m_stride, const double *com, ptrdiff_t com_plane,
    ptrdiff_t com_stride, const double *Ic, ptrdiff_t Ic_plane,
    ptrdiff_t Ic_stride, double *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t com_i = ksl_vec3_of_planes(com + i * com_stride, com_plane);
    const ksl_mat3x3_t Ic_i = ksl_mat3x3_of_planes(Ic + i * Ic_stride, Ic_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_spatial_inertia_from_com_fused(m[i * m_stride], &com_i, &Ic_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_product_Bs_fused of n elements. */
static KSL_INLINED void ksl_product_Bs_fused_many(ptrdiff_t n, const ksl_spatial_inertia_t *B,
    ptrdiff_t B_stride, const ksl_screw_t *s, ptrdiff_t s_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Bs_fused(B + i * B_stride, s + i * s_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_Bs_fused_planes(ptrdiff_t n, const double *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, const double *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    const ksl_screw_t s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_coscrew_t co_i;
    ksl_product_Bs_fused(&B_i, &s_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_spatial_inertia_energy_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertia_energy_fused_many(ptrdiff_t n,
    const ksl_spatial_inertia_t *B, ptrdiff_t B_stride, const ksl_screw_t *s,
    ptrdiff_t s_stride, double *energy, ptrdiff_t energy_stride) {
  KSL_EACH_OF(n) {
    energy[i * energy_stride] = ksl_spatial_inertia_energy_fused(B + i * B_stride, s + i * s_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_energy_fused_planes(ptrdiff_t n, const double *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, double *energy, ptrdiff_t energy_stride) {
  ksl_spatial_inertia_t B_i;
  if (n > 0) B_i = ksl_spatial_inertia_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    const ksl_screw_t s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    energy[i * energy_stride] = ksl_spatial_inertia_energy_fused(&B_i, &s_i);
  }
}

/* ksl_spatial_inertia_net_wrench_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertia_net_wrench_fused_many(ptrdiff_t n,
    const ksl_spatial_inertia_t *B, ptrdiff_t B_stride, const ksl_vec3_t *w,
    ptrdiff_t w_stride, const ksl_screw_t *ds, ptrdiff_t ds_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_net_wrench_fused(B + i * B_stride, w + i * w_stride, ds + i * ds_stride,
        co + i * co_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_net_wrench_fused_planes(ptrdiff_t n, const double *B,
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
    ksl_spatial_inertia_net_wrench_fused(&B_i, &w_i, &ds_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_spatial_inertia_shifted_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertia_shifted_fused_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_spatial_inertia_t *B, ptrdiff_t B_stride,
    ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_shifted_fused(t + i * t_stride, B + i * B_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_shifted_fused_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, double *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_spatial_inertia_t B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_spatial_inertia_shifted_fused(&t_i, &B_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertia_transformed_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertia_transformed_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_spatial_inertia_t *B, ptrdiff_t B_stride,
    ksl_spatial_inertia_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertia_transformed_fused(D + i * D_stride, B + i * B_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertia_transformed_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, double *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_spatial_inertia_t B_i = ksl_spatial_inertia_of_planes(B + i * B_stride, B_plane);
    ksl_spatial_inertia_t Bo_i;
    ksl_spatial_inertia_transformed_fused(&D_i, &B_i, &Bo_i);
    ksl_spatial_inertia_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertiaf_scale_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_scale_fused_many(ptrdiff_t n,
    ksl_spatial_inertiaf_t *self, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_scale_fused_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_t self_i = ksl_spatial_inertiaf_of_planes(self + i * self_stride, self_plane);
    ksl_spatial_inertiaf_scale_fused(&self_i, a[i * a_stride]);
    ksl_spatial_inertiaf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_add_BBf_fused of n elements. */
static KSL_INLINED void ksl_add_BBf_fused_many(ptrdiff_t n, const ksl_spatial_inertiaf_t *B1,
    ptrdiff_t B1_stride, const ksl_spatial_inertiaf_t *B2, ptrdiff_t B2_stride,
    ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_BBf_fused(B1 + i * B1_stride, B2 + i * B2_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_add_BBf_fused_planes(ptrdiff_t n, const float *B1, ptrdiff_t B1_plane,
    ptrdiff_t B1_stride, const float *B2, ptrdiff_t B2_plane,
    ptrdiff_t B2_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_spatial_inertiaf_t B1_i;
  if (n > 0) B1_i = ksl_spatial_inertiaf_of_planes(B1, B1_plane);
  KSL_EACH_OF(n) {
    if (B1_stride) B1_i = ksl_spatial_inertiaf_of_planes(B1 + i * B1_stride, B1_plane);
    const ksl_spatial_inertiaf_t B2_i = ksl_spatial_inertiaf_of_planes(B2 + i * B2_stride, B2_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_add_BBf_fused(&B1_i, &B2_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_subtract_BBf_fused of n elements. */
static KSL_INLINED void ksl_subtract_BBf_fused_many(ptrdiff_t n, const ksl_spatial_inertiaf_t *B1,
    ptrdiff_t B1_stride, const ksl_spatial_inertiaf_t *B2, ptrdiff_t B2_stride,
    ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_BBf_fused(B1 + i * B1_stride, B2 + i * B2_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_subtract_BBf_fused_planes(ptrdiff_t n, const float *B1,
    ptrdiff_t B1_plane, ptrdiff_t B1_stride, const float *B2, ptrdiff_t B2_plane,
    ptrdiff_t B2_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_spatial_inertiaf_t B1_i;
  if (n > 0) B1_i = ksl_spatial_inertiaf_of_planes(B1, B1_plane);
  KSL_EACH_OF(n) {
    if (B1_stride) B1_i = ksl_spatial_inertiaf_of_planes(B1 + i * B1_stride, B1_plane);
    const ksl_spatial_inertiaf_t B2_i = ksl_spatial_inertiaf_of_planes(B2 + i * B2_stride, B2_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_subtract_BBf_fused(&B1_i, &B2_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertiaf_from_com_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_from_com_fused_many(ptrdiff_t n, const float *m,
    ptrdiff_t m_stride, const ksl_vec3f_t *com, ptrdiff_t com_stride,
    const ksl_mat3x3f_t *Ic, ptrdiff_t Ic_stride, ksl_spatial_inertiaf_t *Bo,
    ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_from_com_fused(m[i * m_stride], com + i * com_stride, Ic + i * Ic_stride,
        Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_from_com_fused_planes(ptrdiff_t n, const float *m,
    ptrdiff_t m_stride, const float *com, ptrdiff_t com_plane,
    ptrdiff_t com_stride, const float *Ic, ptrdiff_t Ic_plane,
    ptrdiff_t Ic_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t com_i = ksl_vec3f_of_planes(com + i * com_stride, com_plane);
    const ksl_mat3x3f_t Ic_i = ksl_mat3x3f_of_planes(Ic + i * Ic_stride, Ic_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_spatial_inertiaf_from_com_fused(m[i * m_stride], &com_i, &Ic_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_product_Bsf_fused of n elements. */
static KSL_INLINED void ksl_product_Bsf_fused_many(ptrdiff_t n, const ksl_spatial_inertiaf_t *B,
    ptrdiff_t B_stride, const ksl_screwf_t *s, ptrdiff_t s_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Bsf_fused(B + i * B_stride, s + i * s_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_Bsf_fused_planes(ptrdiff_t n, const float *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, const float *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    const ksl_screwf_t s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_coscrewf_t co_i;
    ksl_product_Bsf_fused(&B_i, &s_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_spatial_inertiaf_energy_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_energy_fused_many(ptrdiff_t n,
    const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride, const ksl_screwf_t *s,
    ptrdiff_t s_stride, float *energy, ptrdiff_t energy_stride) {
  KSL_EACH_OF(n) {
    energy[i * energy_stride] = ksl_spatial_inertiaf_energy_fused(B + i * B_stride,
        s + i * s_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_energy_fused_planes(ptrdiff_t n, const float *B,
    ptrdiff_t B_plane, ptrdiff_t B_stride, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, float *energy, ptrdiff_t energy_stride) {
  ksl_spatial_inertiaf_t B_i;
  if (n > 0) B_i = ksl_spatial_inertiaf_of_planes(B, B_plane);
  KSL_EACH_OF(n) {
    if (B_stride) B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    const ksl_screwf_t s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    energy[i * energy_stride] = ksl_spatial_inertiaf_energy_fused(&B_i, &s_i);
  }
}

/* ksl_spatial_inertiaf_net_wrench_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_net_wrench_fused_many(ptrdiff_t n,
    const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride, const ksl_vec3f_t *w,
    ptrdiff_t w_stride, const ksl_screwf_t *ds, ptrdiff_t ds_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_net_wrench_fused(B + i * B_stride, w + i * w_stride, ds + i * ds_stride,
        co + i * co_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_net_wrench_fused_planes(ptrdiff_t n, const float *B,
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
    ksl_spatial_inertiaf_net_wrench_fused(&B_i, &w_i, &ds_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_spatial_inertiaf_shifted_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_shifted_fused_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_spatial_inertiaf_t *B, ptrdiff_t B_stride,
    ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_shifted_fused(t + i * t_stride, B + i * B_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_shifted_fused_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_spatial_inertiaf_t B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_spatial_inertiaf_shifted_fused(&t_i, &B_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

/* ksl_spatial_inertiaf_transformed_fused of n elements. */
static KSL_INLINED void ksl_spatial_inertiaf_transformed_fused_many(ptrdiff_t n,
    const ksl_SE3f_t *D, ptrdiff_t D_stride, const ksl_spatial_inertiaf_t *B,
    ptrdiff_t B_stride, ksl_spatial_inertiaf_t *Bo, ptrdiff_t Bo_stride) {
  KSL_EACH_OF(n) {
    ksl_spatial_inertiaf_transformed_fused(D + i * D_stride, B + i * B_stride, Bo + i * Bo_stride);
  }
}

static KSL_INLINED void ksl_spatial_inertiaf_transformed_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *B, ptrdiff_t B_plane,
    ptrdiff_t B_stride, float *Bo, ptrdiff_t Bo_plane, ptrdiff_t Bo_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_spatial_inertiaf_t B_i = ksl_spatial_inertiaf_of_planes(B + i * B_stride, B_plane);
    ksl_spatial_inertiaf_t Bo_i;
    ksl_spatial_inertiaf_transformed_fused(&D_i, &B_i, &Bo_i);
    ksl_spatial_inertiaf_to_planes(&Bo_i, Bo + i * Bo_stride, Bo_plane);
  }
}

#endif
