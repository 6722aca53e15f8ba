/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_INERTIA_MANY_H
#define KSL_INERTIA_MANY_H

#include "inertia.h"
#include "ksl_planes.h"

/* ksl_inertia of n elements. */
static KSL_INLINED void ksl_inertia_many(ptrdiff_t n, const double *m, ptrdiff_t m_stride,
    const ksl_vec3_t *t, ptrdiff_t t_stride, const double *Ixx,
    ptrdiff_t Ixx_stride, const double *Iyy, ptrdiff_t Iyy_stride,
    const double *Izz, ptrdiff_t Izz_stride, const double *Ixy,
    ptrdiff_t Ixy_stride, const double *Iyz, ptrdiff_t Iyz_stride,
    const double *Izx, ptrdiff_t Izx_stride, ksl_inertia_t *J,
    ptrdiff_t J_stride) {
  KSL_EACH_OF(n) {
    J[i * J_stride] = ksl_inertia(m[i * m_stride], t[i * t_stride], Ixx[i * Ixx_stride],
        Iyy[i * Iyy_stride], Izz[i * Izz_stride], Ixy[i * Ixy_stride], Iyz[i * Iyz_stride],
        Izx[i * Izx_stride]);
  }
}

static KSL_INLINED void ksl_inertia_planes(ptrdiff_t n, const double *m, ptrdiff_t m_stride,
    const double *t, ptrdiff_t t_plane, ptrdiff_t t_stride, const double *Ixx,
    ptrdiff_t Ixx_stride, const double *Iyy, ptrdiff_t Iyy_stride,
    const double *Izz, ptrdiff_t Izz_stride, const double *Ixy,
    ptrdiff_t Ixy_stride, const double *Iyz, ptrdiff_t Iyz_stride,
    const double *Izx, ptrdiff_t Izx_stride, double *J, ptrdiff_t J_plane,
    ptrdiff_t J_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_inertia_t J_i;
    J_i = ksl_inertia(m[i * m_stride], t_i, Ixx[i * Ixx_stride], Iyy[i * Iyy_stride],
        Izz[i * Izz_stride], Ixy[i * Ixy_stride], Iyz[i * Iyz_stride], Izx[i * Izx_stride]);
    ksl_inertia_to_planes(&J_i, J + i * J_stride, J_plane);
  }
}

/* ksl_inertia_copy of n elements. */
static KSL_INLINED void ksl_inertia_copy_many(ptrdiff_t n, const ksl_inertia_t *Ji,
    ptrdiff_t Ji_stride, ksl_inertia_t *Jo, ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_copy(Ji + i * Ji_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertia_copy_planes(ptrdiff_t n, const double *Ji, ptrdiff_t Ji_plane,
    ptrdiff_t Ji_stride, double *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride) {
  ksl_inertia_t Ji_i;
  if (n > 0) Ji_i = ksl_inertia_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertia_of_planes(Ji + i * Ji_stride, Ji_plane);
    ksl_inertia_t Jo_i;
    ksl_inertia_copy(&Ji_i, &Jo_i);
    ksl_inertia_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_inertia_rotated of n elements. */
static KSL_INLINED void ksl_inertia_rotated_many(ptrdiff_t n, const ksl_inertia_t *Ji,
    ptrdiff_t Ji_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_inertia_t *Jo, ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_rotated(Ji + i * Ji_stride, R + i * R_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertia_rotated_planes(ptrdiff_t n, const double *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride) {
  ksl_inertia_t Ji_i;
  if (n > 0) Ji_i = ksl_inertia_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertia_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_inertia_t Jo_i;
    ksl_inertia_rotated(&Ji_i, &R_i, &Jo_i);
    ksl_inertia_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_inertia_rotate of n elements. */
static KSL_INLINED void ksl_inertia_rotate_many(ptrdiff_t n, ksl_inertia_t *self,
    ptrdiff_t self_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_rotate(self + i * self_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_inertia_rotate_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_t self_i = ksl_inertia_of_planes(self + i * self_stride, self_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_inertia_rotate(&self_i, &R_i);
    ksl_inertia_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_inertia_translated of n elements. */
static KSL_INLINED void ksl_inertia_translated_many(ptrdiff_t n, const ksl_inertia_t *Ji,
    ptrdiff_t Ji_stride, const ksl_vec3_t *t, ptrdiff_t t_stride,
    ksl_inertia_t *Jo, ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_translated(Ji + i * Ji_stride, t + i * t_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertia_translated_planes(ptrdiff_t n, const double *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride) {
  ksl_inertia_t Ji_i;
  if (n > 0) Ji_i = ksl_inertia_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertia_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_inertia_t Jo_i;
    ksl_inertia_translated(&Ji_i, &t_i, &Jo_i);
    ksl_inertia_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_inertia_translate of n elements. */
static KSL_INLINED void ksl_inertia_translate_many(ptrdiff_t n, ksl_inertia_t *self,
    ptrdiff_t self_stride, const ksl_vec3_t *t, ptrdiff_t t_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_translate(self + i * self_stride, t + i * t_stride);
  }
}

static KSL_INLINED void ksl_inertia_translate_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_t self_i = ksl_inertia_of_planes(self + i * self_stride, self_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_inertia_translate(&self_i, &t_i);
    ksl_inertia_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_inertia_transformed of n elements. */
static KSL_INLINED void ksl_inertia_transformed_many(ptrdiff_t n, const ksl_inertia_t *Ji,
    ptrdiff_t Ji_stride, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_inertia_t *Jo, ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_transformed(Ji + i * Ji_stride, D + i * D_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertia_transformed_planes(ptrdiff_t n, const double *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride) {
  ksl_inertia_t Ji_i;
  if (n > 0) Ji_i = ksl_inertia_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertia_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_SE3_t D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_inertia_t Jo_i;
    ksl_inertia_transformed(&Ji_i, &D_i, &Jo_i);
    ksl_inertia_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_inertia_transform of n elements. */
static KSL_INLINED void ksl_inertia_transform_many(ptrdiff_t n, ksl_inertia_t *self,
    ptrdiff_t self_stride, const ksl_SE3_t *D, ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_transform(self + i * self_stride, D + i * D_stride);
  }
}

static KSL_INLINED void ksl_inertia_transform_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_t self_i = ksl_inertia_of_planes(self + i * self_stride, self_plane);
    const ksl_SE3_t D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_inertia_transform(&self_i, &D_i);
    ksl_inertia_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_inertia_merge of n elements. */
static KSL_INLINED void ksl_inertia_merge_many(ptrdiff_t n, ksl_inertia_t *Ji, ptrdiff_t Ji_stride,
    const ksl_vec3_t *t_ic, ptrdiff_t t_ic_stride, const ksl_inertia_t *Jj,
    ptrdiff_t Jj_stride, const ksl_vec3_t *t_jc, ptrdiff_t t_jc_stride,
    const ksl_SE3_t *D_ij, ptrdiff_t D_ij_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_merge(Ji + i * Ji_stride, t_ic + i * t_ic_stride, Jj + i * Jj_stride,
        t_jc + i * t_jc_stride, D_ij + i * D_ij_stride);
  }
}

static KSL_INLINED void ksl_inertia_merge_planes(ptrdiff_t n, double *Ji, ptrdiff_t Ji_plane,
    ptrdiff_t Ji_stride, const double *t_ic, ptrdiff_t t_ic_plane,
    ptrdiff_t t_ic_stride, const double *Jj, ptrdiff_t Jj_plane,
    ptrdiff_t Jj_stride, const double *t_jc, ptrdiff_t t_jc_plane,
    ptrdiff_t t_jc_stride, const double *D_ij, ptrdiff_t D_ij_plane,
    ptrdiff_t D_ij_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_t Ji_i = ksl_inertia_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_vec3_t t_ic_i = ksl_vec3_of_planes(t_ic + i * t_ic_stride, t_ic_plane);
    const ksl_inertia_t Jj_i = ksl_inertia_of_planes(Jj + i * Jj_stride, Jj_plane);
    const ksl_vec3_t t_jc_i = ksl_vec3_of_planes(t_jc + i * t_jc_stride, t_jc_plane);
    const ksl_SE3_t D_ij_i = ksl_SE3_of_planes(D_ij + i * D_ij_stride, D_ij_plane);
    ksl_inertia_merge(&Ji_i, &t_ic_i, &Jj_i, &t_jc_i, &D_ij_i);
    ksl_inertia_to_planes(&Ji_i, Ji + i * Ji_stride, Ji_plane);
  }
}

/* ksl_inertiaf of n elements. */
static KSL_INLINED void ksl_inertiaf_many(ptrdiff_t n, const float *m, ptrdiff_t m_stride,
    const ksl_vec3f_t *t, ptrdiff_t t_stride, const float *Ixx,
    ptrdiff_t Ixx_stride, const float *Iyy, ptrdiff_t Iyy_stride,
    const float *Izz, ptrdiff_t Izz_stride, const float *Ixy,
    ptrdiff_t Ixy_stride, const float *Iyz, ptrdiff_t Iyz_stride,
    const float *Izx, ptrdiff_t Izx_stride, ksl_inertiaf_t *J,
    ptrdiff_t J_stride) {
  KSL_EACH_OF(n) {
    J[i * J_stride] = ksl_inertiaf(m[i * m_stride], t[i * t_stride], Ixx[i * Ixx_stride],
        Iyy[i * Iyy_stride], Izz[i * Izz_stride], Ixy[i * Ixy_stride], Iyz[i * Iyz_stride],
        Izx[i * Izx_stride]);
  }
}

static KSL_INLINED void ksl_inertiaf_planes(ptrdiff_t n, const float *m, ptrdiff_t m_stride,
    const float *t, ptrdiff_t t_plane, ptrdiff_t t_stride, const float *Ixx,
    ptrdiff_t Ixx_stride, const float *Iyy, ptrdiff_t Iyy_stride,
    const float *Izz, ptrdiff_t Izz_stride, const float *Ixy,
    ptrdiff_t Ixy_stride, const float *Iyz, ptrdiff_t Iyz_stride,
    const float *Izx, ptrdiff_t Izx_stride, float *J, ptrdiff_t J_plane,
    ptrdiff_t J_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_inertiaf_t J_i;
    J_i = ksl_inertiaf(m[i * m_stride], t_i, Ixx[i * Ixx_stride], Iyy[i * Iyy_stride],
        Izz[i * Izz_stride], Ixy[i * Ixy_stride], Iyz[i * Iyz_stride], Izx[i * Izx_stride]);
    ksl_inertiaf_to_planes(&J_i, J + i * J_stride, J_plane);
  }
}

/* ksl_inertiaf_copy of n elements. */
static KSL_INLINED void ksl_inertiaf_copy_many(ptrdiff_t n, const ksl_inertiaf_t *Ji,
    ptrdiff_t Ji_stride, ksl_inertiaf_t *Jo, ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_copy(Ji + i * Ji_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_copy_planes(ptrdiff_t n, const float *Ji, ptrdiff_t Ji_plane,
    ptrdiff_t Ji_stride, float *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride) {
  ksl_inertiaf_t Ji_i;
  if (n > 0) Ji_i = ksl_inertiaf_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertiaf_of_planes(Ji + i * Ji_stride, Ji_plane);
    ksl_inertiaf_t Jo_i;
    ksl_inertiaf_copy(&Ji_i, &Jo_i);
    ksl_inertiaf_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_inertiaf_rotated of n elements. */
static KSL_INLINED void ksl_inertiaf_rotated_many(ptrdiff_t n, const ksl_inertiaf_t *Ji,
    ptrdiff_t Ji_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_inertiaf_t *Jo, ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_rotated(Ji + i * Ji_stride, R + i * R_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_rotated_planes(ptrdiff_t n, const float *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride) {
  ksl_inertiaf_t Ji_i;
  if (n > 0) Ji_i = ksl_inertiaf_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertiaf_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_inertiaf_t Jo_i;
    ksl_inertiaf_rotated(&Ji_i, &R_i, &Jo_i);
    ksl_inertiaf_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_inertiaf_rotate of n elements. */
static KSL_INLINED void ksl_inertiaf_rotate_many(ptrdiff_t n, ksl_inertiaf_t *self,
    ptrdiff_t self_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_rotate(self + i * self_stride, R + i * R_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_rotate_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const float *R, ptrdiff_t R_plane, ptrdiff_t R_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_t self_i = ksl_inertiaf_of_planes(self + i * self_stride, self_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_inertiaf_rotate(&self_i, &R_i);
    ksl_inertiaf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_inertiaf_translated of n elements. */
static KSL_INLINED void ksl_inertiaf_translated_many(ptrdiff_t n, const ksl_inertiaf_t *Ji,
    ptrdiff_t Ji_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride,
    ksl_inertiaf_t *Jo, ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_translated(Ji + i * Ji_stride, t + i * t_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_translated_planes(ptrdiff_t n, const float *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride) {
  ksl_inertiaf_t Ji_i;
  if (n > 0) Ji_i = ksl_inertiaf_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertiaf_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_inertiaf_t Jo_i;
    ksl_inertiaf_translated(&Ji_i, &t_i, &Jo_i);
    ksl_inertiaf_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_inertiaf_translate of n elements. */
static KSL_INLINED void ksl_inertiaf_translate_many(ptrdiff_t n, ksl_inertiaf_t *self,
    ptrdiff_t self_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_translate(self + i * self_stride, t + i * t_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_translate_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_t self_i = ksl_inertiaf_of_planes(self + i * self_stride, self_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_inertiaf_translate(&self_i, &t_i);
    ksl_inertiaf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_inertiaf_transformed of n elements. */
static KSL_INLINED void ksl_inertiaf_transformed_many(ptrdiff_t n, const ksl_inertiaf_t *Ji,
    ptrdiff_t Ji_stride, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_inertiaf_t *Jo, ptrdiff_t Jo_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_transformed(Ji + i * Ji_stride, D + i * D_stride, Jo + i * Jo_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_transformed_planes(ptrdiff_t n, const float *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride) {
  ksl_inertiaf_t Ji_i;
  if (n > 0) Ji_i = ksl_inertiaf_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertiaf_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_SE3f_t D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_inertiaf_t Jo_i;
    ksl_inertiaf_transformed(&Ji_i, &D_i, &Jo_i);
    ksl_inertiaf_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
  }
}

/* ksl_inertiaf_transform of n elements. */
static KSL_INLINED void ksl_inertiaf_transform_many(ptrdiff_t n, ksl_inertiaf_t *self,
    ptrdiff_t self_stride, const ksl_SE3f_t *D, ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_transform(self + i * self_stride, D + i * D_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_transform_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_t self_i = ksl_inertiaf_of_planes(self + i * self_stride, self_plane);
    const ksl_SE3f_t D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_inertiaf_transform(&self_i, &D_i);
    ksl_inertiaf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_inertiaf_merge of n elements. */
static KSL_INLINED void ksl_inertiaf_merge_many(ptrdiff_t n, ksl_inertiaf_t *Ji,
    ptrdiff_t Ji_stride, const ksl_vec3f_t *t_ic, ptrdiff_t t_ic_stride,
    const ksl_inertiaf_t *Jj, ptrdiff_t Jj_stride, const ksl_vec3f_t *t_jc,
    ptrdiff_t t_jc_stride, const ksl_SE3f_t *D_ij, ptrdiff_t D_ij_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_merge(Ji + i * Ji_stride, t_ic + i * t_ic_stride, Jj + i * Jj_stride,
        t_jc + i * t_jc_stride, D_ij + i * D_ij_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_merge_planes(ptrdiff_t n, float *Ji, ptrdiff_t Ji_plane,
    ptrdiff_t Ji_stride, const float *t_ic, ptrdiff_t t_ic_plane,
    ptrdiff_t t_ic_stride, const float *Jj, ptrdiff_t Jj_plane,
    ptrdiff_t Jj_stride, const float *t_jc, ptrdiff_t t_jc_plane,
    ptrdiff_t t_jc_stride, const float *D_ij, ptrdiff_t D_ij_plane,
    ptrdiff_t D_ij_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_t Ji_i = ksl_inertiaf_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_vec3f_t t_ic_i = ksl_vec3f_of_planes(t_ic + i * t_ic_stride, t_ic_plane);
    const ksl_inertiaf_t Jj_i = ksl_inertiaf_of_planes(Jj + i * Jj_stride, Jj_plane);
    const ksl_vec3f_t t_jc_i = ksl_vec3f_of_planes(t_jc + i * t_jc_stride, t_jc_plane);
    const ksl_SE3f_t D_ij_i = ksl_SE3f_of_planes(D_ij + i * D_ij_stride, D_ij_plane);
    ksl_inertiaf_merge(&Ji_i, &t_ic_i, &Jj_i, &t_jc_i, &D_ij_i);
    ksl_inertiaf_to_planes(&Ji_i, Ji + i * Ji_stride, Ji_plane);
  }
}

#endif
