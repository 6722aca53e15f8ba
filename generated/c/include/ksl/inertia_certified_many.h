/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_INERTIA_CERTIFIED_MANY_H
#define KSL_INERTIA_CERTIFIED_MANY_H

#include "inertia_certified.h"
#include "ksl_planes.h"

/* ksl_inertia_certified of n elements. */
static KSL_INLINED void ksl_inertia_certified_many(ptrdiff_t n, const double *m, ptrdiff_t m_stride,
    const ksl_vec3_t *t, ptrdiff_t t_stride, const double *Ixx,
    ptrdiff_t Ixx_stride, const double *Iyy, ptrdiff_t Iyy_stride,
    const double *Izz, ptrdiff_t Izz_stride, const double *Ixy,
    ptrdiff_t Ixy_stride, const double *Iyz, ptrdiff_t Iyz_stride,
    const double *Izx, ptrdiff_t Izx_stride, ksl_inertia_t *J_bound,
    ptrdiff_t J_bound_stride, ksl_inertia_t *J, ptrdiff_t J_stride) {
  KSL_EACH_OF(n) {
    J[i * J_stride] = ksl_inertia_certified(m[i * m_stride], t[i * t_stride], Ixx[i * Ixx_stride],
        Iyy[i * Iyy_stride], Izz[i * Izz_stride], Ixy[i * Ixy_stride], Iyz[i * Iyz_stride],
        Izx[i * Izx_stride], J_bound + i * J_bound_stride);
  }
}

static KSL_INLINED void ksl_inertia_certified_planes(ptrdiff_t n, const double *m,
    ptrdiff_t m_stride, const double *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    const double *Ixx, ptrdiff_t Ixx_stride, const double *Iyy,
    ptrdiff_t Iyy_stride, const double *Izz, ptrdiff_t Izz_stride,
    const double *Ixy, ptrdiff_t Ixy_stride, const double *Iyz,
    ptrdiff_t Iyz_stride, const double *Izx, ptrdiff_t Izx_stride,
    double *J_bound, ptrdiff_t J_bound_plane, ptrdiff_t J_bound_stride,
    double *J, ptrdiff_t J_plane, ptrdiff_t J_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_inertia_t J_bound_i;
    ksl_inertia_t J_i;
    J_i = ksl_inertia_certified(m[i * m_stride], t_i, Ixx[i * Ixx_stride], Iyy[i * Iyy_stride],
        Izz[i * Izz_stride], Ixy[i * Ixy_stride], Iyz[i * Iyz_stride], Izx[i * Izx_stride],
        &J_bound_i);
    ksl_inertia_to_planes(&J_bound_i, J_bound + i * J_bound_stride, J_bound_plane);
    ksl_inertia_to_planes(&J_i, J + i * J_stride, J_plane);
  }
}

/* ksl_inertia_rotated_certified of n elements. */
static KSL_INLINED void ksl_inertia_rotated_certified_many(ptrdiff_t n, const ksl_inertia_t *Ji,
    ptrdiff_t Ji_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_inertia_t *Jo, ptrdiff_t Jo_stride, ksl_inertia_t *Jo_bound,
    ptrdiff_t Jo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_rotated_certified(Ji + i * Ji_stride, R + i * R_stride, Jo + i * Jo_stride,
        Jo_bound + i * Jo_bound_stride);
  }
}

static KSL_INLINED void ksl_inertia_rotated_certified_planes(ptrdiff_t n, const double *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride,
    double *Jo_bound, ptrdiff_t Jo_bound_plane, ptrdiff_t Jo_bound_stride) {
  ksl_inertia_t Ji_i;
  if (n > 0) Ji_i = ksl_inertia_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertia_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_inertia_t Jo_i;
    ksl_inertia_t Jo_bound_i;
    ksl_inertia_rotated_certified(&Ji_i, &R_i, &Jo_i, &Jo_bound_i);
    ksl_inertia_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
    ksl_inertia_to_planes(&Jo_bound_i, Jo_bound + i * Jo_bound_stride, Jo_bound_plane);
  }
}

/* ksl_inertia_rotate_certified of n elements. */
static KSL_INLINED void ksl_inertia_rotate_certified_many(ptrdiff_t n, ksl_inertia_t *self,
    ptrdiff_t self_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride,
    ksl_inertia_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_rotate_certified(self + i * self_stride, R + i * R_stride,
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_inertia_rotate_certified_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, double *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_t self_i = ksl_inertia_of_planes(self + i * self_stride, self_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_inertia_t self_bound_i;
    ksl_inertia_rotate_certified(&self_i, &R_i, &self_bound_i);
    ksl_inertia_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_inertia_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_inertia_translated_certified of n elements. */
static KSL_INLINED void ksl_inertia_translated_certified_many(ptrdiff_t n, const ksl_inertia_t *Ji,
    ptrdiff_t Ji_stride, const ksl_vec3_t *t, ptrdiff_t t_stride,
    ksl_inertia_t *Jo, ptrdiff_t Jo_stride, ksl_inertia_t *Jo_bound,
    ptrdiff_t Jo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_translated_certified(Ji + i * Ji_stride, t + i * t_stride, Jo + i * Jo_stride,
        Jo_bound + i * Jo_bound_stride);
  }
}

static KSL_INLINED void ksl_inertia_translated_certified_planes(ptrdiff_t n, const double *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride,
    double *Jo_bound, ptrdiff_t Jo_bound_plane, ptrdiff_t Jo_bound_stride) {
  ksl_inertia_t Ji_i;
  if (n > 0) Ji_i = ksl_inertia_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertia_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_inertia_t Jo_i;
    ksl_inertia_t Jo_bound_i;
    ksl_inertia_translated_certified(&Ji_i, &t_i, &Jo_i, &Jo_bound_i);
    ksl_inertia_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
    ksl_inertia_to_planes(&Jo_bound_i, Jo_bound + i * Jo_bound_stride, Jo_bound_plane);
  }
}

/* ksl_inertia_translate_certified of n elements. */
static KSL_INLINED void ksl_inertia_translate_certified_many(ptrdiff_t n, ksl_inertia_t *self,
    ptrdiff_t self_stride, const ksl_vec3_t *t, ptrdiff_t t_stride,
    ksl_inertia_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_translate_certified(self + i * self_stride, t + i * t_stride,
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_inertia_translate_certified_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, double *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_t self_i = ksl_inertia_of_planes(self + i * self_stride, self_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_inertia_t self_bound_i;
    ksl_inertia_translate_certified(&self_i, &t_i, &self_bound_i);
    ksl_inertia_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_inertia_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_inertia_transformed_certified of n elements. */
static KSL_INLINED void ksl_inertia_transformed_certified_many(ptrdiff_t n, const ksl_inertia_t *Ji,
    ptrdiff_t Ji_stride, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_inertia_t *Jo, ptrdiff_t Jo_stride, ksl_inertia_t *Jo_bound,
    ptrdiff_t Jo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_transformed_certified(Ji + i * Ji_stride, D + i * D_stride, Jo + i * Jo_stride,
        Jo_bound + i * Jo_bound_stride);
  }
}

static KSL_INLINED void ksl_inertia_transformed_certified_planes(ptrdiff_t n, const double *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride,
    double *Jo_bound, ptrdiff_t Jo_bound_plane, ptrdiff_t Jo_bound_stride) {
  ksl_inertia_t Ji_i;
  if (n > 0) Ji_i = ksl_inertia_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertia_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_SE3_t D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_inertia_t Jo_i;
    ksl_inertia_t Jo_bound_i;
    ksl_inertia_transformed_certified(&Ji_i, &D_i, &Jo_i, &Jo_bound_i);
    ksl_inertia_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
    ksl_inertia_to_planes(&Jo_bound_i, Jo_bound + i * Jo_bound_stride, Jo_bound_plane);
  }
}

/* ksl_inertia_transform_certified of n elements. */
static KSL_INLINED void ksl_inertia_transform_certified_many(ptrdiff_t n, ksl_inertia_t *self,
    ptrdiff_t self_stride, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_inertia_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_transform_certified(self + i * self_stride, D + i * D_stride,
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_inertia_transform_certified_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertia_t self_i = ksl_inertia_of_planes(self + i * self_stride, self_plane);
    const ksl_SE3_t D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_inertia_t self_bound_i;
    ksl_inertia_transform_certified(&self_i, &D_i, &self_bound_i);
    ksl_inertia_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_inertia_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_inertiaf_certified of n elements. */
static KSL_INLINED void ksl_inertiaf_certified_many(ptrdiff_t n, const float *m, ptrdiff_t m_stride,
    const ksl_vec3f_t *t, ptrdiff_t t_stride, const float *Ixx,
    ptrdiff_t Ixx_stride, const float *Iyy, ptrdiff_t Iyy_stride,
    const float *Izz, ptrdiff_t Izz_stride, const float *Ixy,
    ptrdiff_t Ixy_stride, const float *Iyz, ptrdiff_t Iyz_stride,
    const float *Izx, ptrdiff_t Izx_stride, ksl_inertiaf_t *J_bound,
    ptrdiff_t J_bound_stride, ksl_inertiaf_t *J, ptrdiff_t J_stride) {
  KSL_EACH_OF(n) {
    J[i * J_stride] = ksl_inertiaf_certified(m[i * m_stride], t[i * t_stride], Ixx[i * Ixx_stride],
        Iyy[i * Iyy_stride], Izz[i * Izz_stride], Ixy[i * Ixy_stride], Iyz[i * Iyz_stride],
        Izx[i * Izx_stride], J_bound + i * J_bound_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_certified_planes(ptrdiff_t n, const float *m,
    ptrdiff_t m_stride, const float *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    const float *Ixx, ptrdiff_t Ixx_stride, const float *Iyy,
    ptrdiff_t Iyy_stride, const float *Izz, ptrdiff_t Izz_stride,
    const float *Ixy, ptrdiff_t Ixy_stride, const float *Iyz,
    ptrdiff_t Iyz_stride, const float *Izx, ptrdiff_t Izx_stride, float *J_bound,
    ptrdiff_t J_bound_plane, ptrdiff_t J_bound_stride, float *J,
    ptrdiff_t J_plane, ptrdiff_t J_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_inertiaf_t J_bound_i;
    ksl_inertiaf_t J_i;
    J_i = ksl_inertiaf_certified(m[i * m_stride], t_i, Ixx[i * Ixx_stride], Iyy[i * Iyy_stride],
        Izz[i * Izz_stride], Ixy[i * Ixy_stride], Iyz[i * Iyz_stride], Izx[i * Izx_stride],
        &J_bound_i);
    ksl_inertiaf_to_planes(&J_bound_i, J_bound + i * J_bound_stride, J_bound_plane);
    ksl_inertiaf_to_planes(&J_i, J + i * J_stride, J_plane);
  }
}

/* ksl_inertiaf_rotated_certified of n elements. */
static KSL_INLINED void ksl_inertiaf_rotated_certified_many(ptrdiff_t n, const ksl_inertiaf_t *Ji,
    ptrdiff_t Ji_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_inertiaf_t *Jo, ptrdiff_t Jo_stride, ksl_inertiaf_t *Jo_bound,
    ptrdiff_t Jo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_rotated_certified(Ji + i * Ji_stride, R + i * R_stride, Jo + i * Jo_stride,
        Jo_bound + i * Jo_bound_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_rotated_certified_planes(ptrdiff_t n, const float *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride,
    float *Jo_bound, ptrdiff_t Jo_bound_plane, ptrdiff_t Jo_bound_stride) {
  ksl_inertiaf_t Ji_i;
  if (n > 0) Ji_i = ksl_inertiaf_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertiaf_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_inertiaf_t Jo_i;
    ksl_inertiaf_t Jo_bound_i;
    ksl_inertiaf_rotated_certified(&Ji_i, &R_i, &Jo_i, &Jo_bound_i);
    ksl_inertiaf_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
    ksl_inertiaf_to_planes(&Jo_bound_i, Jo_bound + i * Jo_bound_stride, Jo_bound_plane);
  }
}

/* ksl_inertiaf_rotate_certified of n elements. */
static KSL_INLINED void ksl_inertiaf_rotate_certified_many(ptrdiff_t n, ksl_inertiaf_t *self,
    ptrdiff_t self_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_inertiaf_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_rotate_certified(self + i * self_stride, R + i * R_stride,
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_rotate_certified_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, float *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_t self_i = ksl_inertiaf_of_planes(self + i * self_stride, self_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_inertiaf_t self_bound_i;
    ksl_inertiaf_rotate_certified(&self_i, &R_i, &self_bound_i);
    ksl_inertiaf_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_inertiaf_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_inertiaf_translated_certified of n elements. */
static KSL_INLINED void ksl_inertiaf_translated_certified_many(ptrdiff_t n,
    const ksl_inertiaf_t *Ji, ptrdiff_t Ji_stride, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, ksl_inertiaf_t *Jo, ptrdiff_t Jo_stride,
    ksl_inertiaf_t *Jo_bound, ptrdiff_t Jo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_translated_certified(Ji + i * Ji_stride, t + i * t_stride, Jo + i * Jo_stride,
        Jo_bound + i * Jo_bound_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_translated_certified_planes(ptrdiff_t n, const float *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride,
    float *Jo_bound, ptrdiff_t Jo_bound_plane, ptrdiff_t Jo_bound_stride) {
  ksl_inertiaf_t Ji_i;
  if (n > 0) Ji_i = ksl_inertiaf_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertiaf_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_inertiaf_t Jo_i;
    ksl_inertiaf_t Jo_bound_i;
    ksl_inertiaf_translated_certified(&Ji_i, &t_i, &Jo_i, &Jo_bound_i);
    ksl_inertiaf_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
    ksl_inertiaf_to_planes(&Jo_bound_i, Jo_bound + i * Jo_bound_stride, Jo_bound_plane);
  }
}

/* ksl_inertiaf_translate_certified of n elements. */
static KSL_INLINED void ksl_inertiaf_translate_certified_many(ptrdiff_t n, ksl_inertiaf_t *self,
    ptrdiff_t self_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride,
    ksl_inertiaf_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_translate_certified(self + i * self_stride, t + i * t_stride,
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_translate_certified_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, float *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_t self_i = ksl_inertiaf_of_planes(self + i * self_stride, self_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_inertiaf_t self_bound_i;
    ksl_inertiaf_translate_certified(&self_i, &t_i, &self_bound_i);
    ksl_inertiaf_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_inertiaf_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_inertiaf_transformed_certified of n elements. */
static KSL_INLINED void ksl_inertiaf_transformed_certified_many(ptrdiff_t n,
    const ksl_inertiaf_t *Ji, ptrdiff_t Ji_stride, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_inertiaf_t *Jo, ptrdiff_t Jo_stride,
    ksl_inertiaf_t *Jo_bound, ptrdiff_t Jo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_transformed_certified(Ji + i * Ji_stride, D + i * D_stride, Jo + i * Jo_stride,
        Jo_bound + i * Jo_bound_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_transformed_certified_planes(ptrdiff_t n, const float *Ji,
    ptrdiff_t Ji_plane, ptrdiff_t Ji_stride, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *Jo, ptrdiff_t Jo_plane, ptrdiff_t Jo_stride,
    float *Jo_bound, ptrdiff_t Jo_bound_plane, ptrdiff_t Jo_bound_stride) {
  ksl_inertiaf_t Ji_i;
  if (n > 0) Ji_i = ksl_inertiaf_of_planes(Ji, Ji_plane);
  KSL_EACH_OF(n) {
    if (Ji_stride) Ji_i = ksl_inertiaf_of_planes(Ji + i * Ji_stride, Ji_plane);
    const ksl_SE3f_t D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_inertiaf_t Jo_i;
    ksl_inertiaf_t Jo_bound_i;
    ksl_inertiaf_transformed_certified(&Ji_i, &D_i, &Jo_i, &Jo_bound_i);
    ksl_inertiaf_to_planes(&Jo_i, Jo + i * Jo_stride, Jo_plane);
    ksl_inertiaf_to_planes(&Jo_bound_i, Jo_bound + i * Jo_bound_stride, Jo_bound_plane);
  }
}

/* ksl_inertiaf_transform_certified of n elements. */
static KSL_INLINED void ksl_inertiaf_transform_certified_many(ptrdiff_t n, ksl_inertiaf_t *self,
    ptrdiff_t self_stride, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_inertiaf_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_transform_certified(self + i * self_stride, D + i * D_stride,
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_inertiaf_transform_certified_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_inertiaf_t self_i = ksl_inertiaf_of_planes(self + i * self_stride, self_plane);
    const ksl_SE3f_t D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_inertiaf_t self_bound_i;
    ksl_inertiaf_transform_certified(&self_i, &D_i, &self_bound_i);
    ksl_inertiaf_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_inertiaf_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

#endif
