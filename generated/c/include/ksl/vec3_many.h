/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_VEC3_MANY_H
#define KSL_VEC3_MANY_H

#include "vec3.h"
#include "ksl_states.h"

/* ksl_vec3_copy of n elements. */
static KSL_INLINED void ksl_vec3_copy_many(ptrdiff_t n, const ksl_vec3_t *vi, ptrdiff_t vi_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_copy(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_copy_planes(ptrdiff_t n, const double *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_copy(&vi_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_scale of n elements. */
static KSL_INLINED void ksl_vec3_scale_many(ptrdiff_t n, ksl_vec3_t *self, ptrdiff_t self_stride,
    const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec3_scale_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t self_i = ksl_vec3_of_planes(self + i * self_stride, self_plane);
    ksl_vec3_scale(&self_i, a[i * a_stride]);
    ksl_vec3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3_inverted of n elements. */
static KSL_INLINED void ksl_vec3_inverted_many(ptrdiff_t n, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_inverted(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_inverted_planes(ptrdiff_t n, const double *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_inverted(&vi_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_invert of n elements. */
static KSL_INLINED void ksl_vec3_invert_many(ptrdiff_t n, ksl_vec3_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3_invert_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t self_i = ksl_vec3_of_planes(self + i * self_stride, self_plane);
    ksl_vec3_invert(&self_i);
    ksl_vec3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_vv of n elements. */
static KSL_INLINED void ksl_axpy_vv_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_vec3_t *x, ptrdiff_t x_stride, ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_vv(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_vv_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_vv(a[i * a_stride], &x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_vv of n elements. */
static KSL_INLINED void ksl_xpy_vv_many(ptrdiff_t n, const ksl_vec3_t *x, ptrdiff_t x_stride,
    ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_vv(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_vv_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3_t x_i;
  if (n > 0) x_i = ksl_vec3_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_vv(&x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_vv of n elements. */
static KSL_INLINED void ksl_nxpy_vv_many(ptrdiff_t n, const ksl_vec3_t *x, ptrdiff_t x_stride,
    ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_vv(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_vv_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3_t x_i;
  if (n > 0) x_i = ksl_vec3_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_vv(&x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_av of n elements. */
static KSL_INLINED void ksl_product_av_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_vec3_t *vi, ptrdiff_t vi_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_av(a[i * a_stride], vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_av_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *vi, ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3_t vo_i;
    ksl_product_av(a[i * a_stride], &vi_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vv of n elements. */
static KSL_INLINED void ksl_add_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vv(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_add_vv(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_subtract_vv of n elements. */
static KSL_INLINED void ksl_subtract_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_vv(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_subtract_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_subtract_vv(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_scaled of n elements. */
static KSL_INLINED void ksl_vec3_scaled_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_scaled(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_scaled_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_scaled(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_swap of n elements. */
static KSL_INLINED void ksl_vec3_swap_many(ptrdiff_t n, ksl_vec3_t *v1, ptrdiff_t v1_stride,
    ksl_vec3_t *v2, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_swap(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_vec3_swap_planes(ptrdiff_t n, double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, double *v2, ptrdiff_t v2_plane, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_swap(&v1_i, &v2_i);
    ksl_vec3_to_planes(&v1_i, v1 + i * v1_stride, v1_plane);
    ksl_vec3_to_planes(&v2_i, v2 + i * v2_stride, v2_plane);
  }
}

/* ksl_vec3_l2norm of n elements. */
static KSL_INLINED void ksl_vec3_l2norm_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    double *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_vec3_l2norm(v + i * v_stride);
  }
}

static KSL_INLINED void ksl_vec3_l2norm_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *norm, ptrdiff_t norm_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    norm[i * norm_stride] = ksl_vec3_l2norm(&v_i);
  }
}

/* ksl_vec3_normalize of n elements. */
static KSL_INLINED void ksl_vec3_normalize_many(ptrdiff_t n, ksl_vec3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3_normalize_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t self_i = ksl_vec3_of_planes(self + i * self_stride, self_plane);
    ksl_vec3_normalize(&self_i);
    ksl_vec3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3_normalized of n elements. */
static KSL_INLINED void ksl_vec3_normalized_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_normalized(v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_normalized_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_normalized(&v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

#if KSL_LANE_BYTES
/* ksl_angle_vv of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_angle_vv_states(const ksl_states *v1, const ksl_states *v2,
    ksl_states *angle) {
  const ksl_states s1_size_1 = ksl_abs_lanes(v1[0]);
  const ksl_states s1_size_2 = ksl_abs_lanes(v1[1]);
  const ksl_states s1_size_3 = ksl_abs_lanes(v1[2]);
  const ksl_tests s1_largest1a = ksl_less_lanes(s1_size_1, s1_size_2);
  const ksl_states s1_largest1 = ksl_choice_lanes(s1_largest1a, s1_size_2, s1_size_1);
  const ksl_tests s1_largest2a = ksl_less_lanes(s1_largest1, s1_size_3);
  const ksl_states s1_largest2 = ksl_choice_lanes(s1_largest2a, s1_size_3, s1_largest1);
  const ksl_tests s1a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s1_largest2);
  const ksl_states s1b = ksl_choice_lanes(s1a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s1c = ksl_less_lanes(s1_largest2, ksl_each_lanes(256.0));
  const ksl_states s1d = ksl_choice_lanes(s1c, ksl_each_lanes(1.3093562431584567e+151), s1b);
  const ksl_tests s1e = ksl_less_lanes(s1_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s1 = ksl_choice_lanes(s1e, ksl_each_lanes(1.0715086071862673e+301), s1d);
  const ksl_states scaled_s1_1 = v1[0] * s1;
  const ksl_states scaled_s1_2 = v1[1] * s1;
  const ksl_states scaled_s1_3 = v1[2] * s1;
  const ksl_states s2_size_1 = ksl_abs_lanes(v2[0]);
  const ksl_states s2_size_2 = ksl_abs_lanes(v2[1]);
  const ksl_states s2_size_3 = ksl_abs_lanes(v2[2]);
  const ksl_tests s2_largest1a = ksl_less_lanes(s2_size_1, s2_size_2);
  const ksl_states s2_largest1 = ksl_choice_lanes(s2_largest1a, s2_size_2, s2_size_1);
  const ksl_tests s2_largest2a = ksl_less_lanes(s2_largest1, s2_size_3);
  const ksl_states s2_largest2 = ksl_choice_lanes(s2_largest2a, s2_size_3, s2_largest1);
  const ksl_tests s2a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s2_largest2);
  const ksl_states s2b = ksl_choice_lanes(s2a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s2c = ksl_less_lanes(s2_largest2, ksl_each_lanes(256.0));
  const ksl_states s2d = ksl_choice_lanes(s2c, ksl_each_lanes(1.3093562431584567e+151), s2b);
  const ksl_tests s2e = ksl_less_lanes(s2_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s2 = ksl_choice_lanes(s2e, ksl_each_lanes(1.0715086071862673e+301), s2d);
  const ksl_states scaled_s2_1 = v2[0] * s2;
  const ksl_states scaled_s2_2 = v2[1] * s2;
  const ksl_states scaled_s2_3 = v2[2] * s2;
  const ksl_states c_0a = KSL_RN_LANES(scaled_s1_2 * scaled_s2_3), c_0b = KSL_RN_LANES(scaled_s1_3 *
      scaled_s2_2),
      c_1 = c_0a - c_0b;
  const ksl_states c_1a = KSL_RN_LANES(scaled_s1_3 * scaled_s2_1), c_1b = KSL_RN_LANES(scaled_s1_1 *
      scaled_s2_3),
      c_2 = c_1a - c_1b;
  const ksl_states c_2a = KSL_RN_LANES(scaled_s1_1 * scaled_s2_2), c_2b = KSL_RN_LANES(scaled_s1_2 *
      scaled_s2_1),
      c_3 = c_2a - c_2b;
  const ksl_states s_size_1 = ksl_abs_lanes(c_1);
  const ksl_states s_size_2 = ksl_abs_lanes(c_2);
  const ksl_states s_size_3 = ksl_abs_lanes(c_3);
  const ksl_tests s_largest1a = ksl_less_lanes(s_size_1, s_size_2);
  const ksl_states s_largest1 = ksl_choice_lanes(s_largest1a, s_size_2, s_size_1);
  const ksl_tests s_largest2a = ksl_less_lanes(s_largest1, s_size_3);
  const ksl_states s_largest2 = ksl_choice_lanes(s_largest2a, s_size_3, s_largest1);
  const ksl_tests s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s_largest2);
  const ksl_states s_b = ksl_choice_lanes(s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s_c = ksl_less_lanes(s_largest2, ksl_each_lanes(256.0));
  const ksl_states s_d = ksl_choice_lanes(s_c, ksl_each_lanes(1.3093562431584567e+151), s_b);
  const ksl_tests s_e = ksl_less_lanes(s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s = ksl_choice_lanes(s_e, ksl_each_lanes(1.0715086071862673e+301), s_d);
  const ksl_states y_1 = c_1 * s;
  const ksl_states y_2 = c_2 * s;
  const ksl_states y_3 = c_3 * s;
  const ksl_states n_a = KSL_RN_LANES(y_1 * y_1), n_b = KSL_RN_LANES(y_2 * y_2), n_c = n_a + n_b,
      n_d = KSL_RN_LANES(y_3 * y_3),
      n_e = n_c + n_d, n = ksl_sqrt_lanes(n_e);
  const ksl_tests r_a = ksl_less_lanes(s, ksl_each_lanes(1.0));
  const ksl_states r_b = ksl_choice_lanes(r_a, ksl_each_lanes(2.6815615859885194e+154),
      ksl_each_lanes(1.0));
  const ksl_tests r_c = ksl_less_lanes(ksl_each_lanes(1.0), s);
  const ksl_states r_d = ksl_choice_lanes(r_c, ksl_each_lanes(7.637340908749012e-152), r_b);
  const ksl_tests r_e = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), s);
  const ksl_states r = ksl_choice_lanes(r_e, ksl_each_lanes(9.332636185032189e-302), r_d);
  const ksl_states cross = n * r;
  const ksl_states dot__a = KSL_RN_LANES(scaled_s1_1 * scaled_s2_1), dot__b =
      KSL_RN_LANES(scaled_s1_2 * scaled_s2_2),
      dot__c = dot__a + dot__b, dot__d = KSL_RN_LANES(scaled_s1_3 * scaled_s2_3), dot_ = dot__c +
          dot__d;
  const ksl_states angle_ = ksl_atan2_lanes(cross, dot_);
  angle[0] = angle_;
}
#endif

/* ksl_angle_vv of n elements. */
static KSL_INLINED void ksl_angle_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *angle, ptrdiff_t angle_stride) {
#if KSL_LANE_BYTES
  ksl_states v1_states[3], v2_states[3], angle_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(v1 + i * v1_stride, 3, v1_plane, v1_stride, last, v1_states);
    ksl_states_of_planes(v2 + i * v2_stride, 3, v2_plane, v2_stride, last, v2_states);
    ksl_angle_vv_states(v1_states, v2_states, angle_states);
    ksl_states_to_planes(angle_states, 1, angle + i * angle_stride, 1, angle_stride, last);
  }
#else
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    angle[i * angle_stride] = ksl_angle_vv(&v1_i, &v2_i);
  }
#endif
}

static KSL_INLINED void ksl_angle_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, double *angle,
    ptrdiff_t angle_stride) {
  ksl_angle_vv_planes(n, (const double *)v1, 1, 3 * v1_stride, (const double *)v2, 1, 3 * v2_stride,
      angle, angle_stride);
}

/* ksl_dot_vv of n elements. */
static KSL_INLINED void ksl_dot_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, double *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_vv(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_dot_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *dot, ptrdiff_t dot_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    dot[i * dot_stride] = ksl_dot_vv(&v1_i, &v2_i);
  }
}

/* ksl_product_avinv of n elements. */
static KSL_INLINED void ksl_product_avinv_many(ptrdiff_t n, const double *k, ptrdiff_t k_stride,
    const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avinv(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avinv_planes(ptrdiff_t n, const double *k, ptrdiff_t k_stride,
    const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_avinv(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_ainvv of n elements. */
static KSL_INLINED void ksl_product_ainvv_many(ptrdiff_t n, const double *k, ptrdiff_t k_stride,
    const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ainvv(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_ainvv_planes(ptrdiff_t n, const double *k, ptrdiff_t k_stride,
    const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_ainvv(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vv of n elements. */
static KSL_INLINED void ksl_cross_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vv(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_cross_vv(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvinv of n elements. */
static KSL_INLINED void ksl_cross_vvinv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvinv(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvinv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_cross_vvinv(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvx of n elements. */
static KSL_INLINED void ksl_add_vvx_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvx(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvx_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvx(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxinv of n elements. */
static KSL_INLINED void ksl_add_vvxinv_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxinv(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxinv_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvxinv(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvy of n elements. */
static KSL_INLINED void ksl_add_vvy_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvy(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvy_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvy(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyinv of n elements. */
static KSL_INLINED void ksl_add_vvyinv_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyinv(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyinv_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvyinv(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvz of n elements. */
static KSL_INLINED void ksl_add_vvz_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvz(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvz_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvz(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzinv of n elements. */
static KSL_INLINED void ksl_add_vvzinv_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzinv(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzinv_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvzinv(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_copy of n elements. */
static KSL_INLINED void ksl_vec3f_copy_many(ptrdiff_t n, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_copy(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_copy_planes(ptrdiff_t n, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_copy(&vi_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_scale of n elements. */
static KSL_INLINED void ksl_vec3f_scale_many(ptrdiff_t n, ksl_vec3f_t *self, ptrdiff_t self_stride,
    const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec3f_scale_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t self_i = ksl_vec3f_of_planes(self + i * self_stride, self_plane);
    ksl_vec3f_scale(&self_i, a[i * a_stride]);
    ksl_vec3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3f_inverted of n elements. */
static KSL_INLINED void ksl_vec3f_inverted_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_inverted(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_inverted_planes(ptrdiff_t n, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_inverted(&vi_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_invert of n elements. */
static KSL_INLINED void ksl_vec3f_invert_many(ptrdiff_t n, ksl_vec3f_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3f_invert_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t self_i = ksl_vec3f_of_planes(self + i * self_stride, self_plane);
    ksl_vec3f_invert(&self_i);
    ksl_vec3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_vvf of n elements. */
static KSL_INLINED void ksl_axpy_vvf_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_vec3f_t *x, ptrdiff_t x_stride, ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_vvf(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_vvf_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_vvf(a[i * a_stride], &x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_vvf of n elements. */
static KSL_INLINED void ksl_xpy_vvf_many(ptrdiff_t n, const ksl_vec3f_t *x, ptrdiff_t x_stride,
    ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_vvf(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_vvf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3f_t x_i;
  if (n > 0) x_i = ksl_vec3f_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_vvf(&x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_vvf of n elements. */
static KSL_INLINED void ksl_nxpy_vvf_many(ptrdiff_t n, const ksl_vec3f_t *x, ptrdiff_t x_stride,
    ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_vvf(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_vvf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3f_t x_i;
  if (n > 0) x_i = ksl_vec3f_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_vvf(&x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_avf of n elements. */
static KSL_INLINED void ksl_product_avf_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_vec3f_t *vi, ptrdiff_t vi_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avf(a[i * a_stride], vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avf_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *vi, ptrdiff_t vi_plane, ptrdiff_t vi_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3f_t vo_i;
    ksl_product_avf(a[i * a_stride], &vi_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvf of n elements. */
static KSL_INLINED void ksl_add_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3f_t *v2, ptrdiff_t v2_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvf(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvf(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_subtract_vvf of n elements. */
static KSL_INLINED void ksl_subtract_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_vvf(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_subtract_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_subtract_vvf(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_scaled of n elements. */
static KSL_INLINED void ksl_vec3f_scaled_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_scaled(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_scaled_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_scaled(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_swap of n elements. */
static KSL_INLINED void ksl_vec3f_swap_many(ptrdiff_t n, ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    ksl_vec3f_t *v2, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_swap(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_vec3f_swap_planes(ptrdiff_t n, float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, float *v2, ptrdiff_t v2_plane, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_swap(&v1_i, &v2_i);
    ksl_vec3f_to_planes(&v1_i, v1 + i * v1_stride, v1_plane);
    ksl_vec3f_to_planes(&v2_i, v2 + i * v2_stride, v2_plane);
  }
}

/* ksl_vec3f_l2norm of n elements. */
static KSL_INLINED void ksl_vec3f_l2norm_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    float *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_vec3f_l2norm(v + i * v_stride);
  }
}

static KSL_INLINED void ksl_vec3f_l2norm_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *norm, ptrdiff_t norm_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    norm[i * norm_stride] = ksl_vec3f_l2norm(&v_i);
  }
}

/* ksl_vec3f_normalize of n elements. */
static KSL_INLINED void ksl_vec3f_normalize_many(ptrdiff_t n, ksl_vec3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3f_normalize_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t self_i = ksl_vec3f_of_planes(self + i * self_stride, self_plane);
    ksl_vec3f_normalize(&self_i);
    ksl_vec3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3f_normalized of n elements. */
static KSL_INLINED void ksl_vec3f_normalized_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_normalized(v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_normalized_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_normalized(&v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

#if KSL_LANE_BYTES
/* ksl_angle_vvf of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_angle_vvf_states(const ksl_statesf *v1, const ksl_statesf *v2,
    ksl_statesf *angle) {
  const ksl_statesf s1_size_1 = ksl_abs_lanesf(v1[0]);
  const ksl_statesf s1_size_2 = ksl_abs_lanesf(v1[1]);
  const ksl_statesf s1_size_3 = ksl_abs_lanesf(v1[2]);
  const ksl_testsf s1_largest1a = ksl_less_lanesf(s1_size_1, s1_size_2);
  const ksl_statesf s1_largest1 = ksl_choice_lanesf(s1_largest1a, s1_size_2, s1_size_1);
  const ksl_testsf s1_largest2a = ksl_less_lanesf(s1_largest1, s1_size_3);
  const ksl_statesf s1_largest2 = ksl_choice_lanesf(s1_largest2a, s1_size_3, s1_largest1);
  const ksl_testsf s1a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s1_largest2);
  const ksl_statesf s1b = ksl_choice_lanesf(s1a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s1c = ksl_less_lanesf(s1_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf s1d = ksl_choice_lanesf(s1c, ksl_each_lanesf(1.8014399e+16f), s1b);
  const ksl_testsf s1e = ksl_less_lanesf(s1_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s1 = ksl_choice_lanesf(s1e, ksl_each_lanesf(3.2451855e+32f), s1d);
  const ksl_statesf scaled_s1_1 = v1[0] * s1;
  const ksl_statesf scaled_s1_2 = v1[1] * s1;
  const ksl_statesf scaled_s1_3 = v1[2] * s1;
  const ksl_statesf s2_size_1 = ksl_abs_lanesf(v2[0]);
  const ksl_statesf s2_size_2 = ksl_abs_lanesf(v2[1]);
  const ksl_statesf s2_size_3 = ksl_abs_lanesf(v2[2]);
  const ksl_testsf s2_largest1a = ksl_less_lanesf(s2_size_1, s2_size_2);
  const ksl_statesf s2_largest1 = ksl_choice_lanesf(s2_largest1a, s2_size_2, s2_size_1);
  const ksl_testsf s2_largest2a = ksl_less_lanesf(s2_largest1, s2_size_3);
  const ksl_statesf s2_largest2 = ksl_choice_lanesf(s2_largest2a, s2_size_3, s2_largest1);
  const ksl_testsf s2a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s2_largest2);
  const ksl_statesf s2b = ksl_choice_lanesf(s2a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s2c = ksl_less_lanesf(s2_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf s2d = ksl_choice_lanesf(s2c, ksl_each_lanesf(1.8014399e+16f), s2b);
  const ksl_testsf s2e = ksl_less_lanesf(s2_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s2 = ksl_choice_lanesf(s2e, ksl_each_lanesf(3.2451855e+32f), s2d);
  const ksl_statesf scaled_s2_1 = v2[0] * s2;
  const ksl_statesf scaled_s2_2 = v2[1] * s2;
  const ksl_statesf scaled_s2_3 = v2[2] * s2;
  const ksl_statesf c_0a = KSL_RN_LANESF(scaled_s1_2 * scaled_s2_3), c_0b =
      KSL_RN_LANESF(scaled_s1_3 * scaled_s2_2),
      c_1 = c_0a - c_0b;
  const ksl_statesf c_1a = KSL_RN_LANESF(scaled_s1_3 * scaled_s2_1), c_1b =
      KSL_RN_LANESF(scaled_s1_1 * scaled_s2_3),
      c_2 = c_1a - c_1b;
  const ksl_statesf c_2a = KSL_RN_LANESF(scaled_s1_1 * scaled_s2_2), c_2b =
      KSL_RN_LANESF(scaled_s1_2 * scaled_s2_1),
      c_3 = c_2a - c_2b;
  const ksl_statesf s_size_1 = ksl_abs_lanesf(c_1);
  const ksl_statesf s_size_2 = ksl_abs_lanesf(c_2);
  const ksl_statesf s_size_3 = ksl_abs_lanesf(c_3);
  const ksl_testsf s_largest1a = ksl_less_lanesf(s_size_1, s_size_2);
  const ksl_statesf s_largest1 = ksl_choice_lanesf(s_largest1a, s_size_2, s_size_1);
  const ksl_testsf s_largest2a = ksl_less_lanesf(s_largest1, s_size_3);
  const ksl_statesf s_largest2 = ksl_choice_lanesf(s_largest2a, s_size_3, s_largest1);
  const ksl_testsf s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s_largest2);
  const ksl_statesf s_b = ksl_choice_lanesf(s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s_c = ksl_less_lanesf(s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf s_d = ksl_choice_lanesf(s_c, ksl_each_lanesf(1.8014399e+16f), s_b);
  const ksl_testsf s_e = ksl_less_lanesf(s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s = ksl_choice_lanesf(s_e, ksl_each_lanesf(3.2451855e+32f), s_d);
  const ksl_statesf y_1 = c_1 * s;
  const ksl_statesf y_2 = c_2 * s;
  const ksl_statesf y_3 = c_3 * s;
  const ksl_statesf n_a = KSL_RN_LANESF(y_1 * y_1), n_b = KSL_RN_LANESF(y_2 * y_2), n_c = n_a + n_b,
      n_d = KSL_RN_LANESF(y_3 * y_3),
      n_e = n_c + n_d, n = ksl_sqrt_lanesf(n_e);
  const ksl_testsf r_a = ksl_less_lanesf(s, ksl_each_lanesf(1.0f));
  const ksl_statesf r_b = ksl_choice_lanesf(r_a, ksl_each_lanesf(3.689349e+19f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf r_c = ksl_less_lanesf(ksl_each_lanesf(1.0f), s);
  const ksl_statesf r_d = ksl_choice_lanesf(r_c, ksl_each_lanesf(5.551115e-17f), r_b);
  const ksl_testsf r_e = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), s);
  const ksl_statesf r = ksl_choice_lanesf(r_e, ksl_each_lanesf(3.081488e-33f), r_d);
  const ksl_statesf cross = n * r;
  const ksl_statesf dot__a = KSL_RN_LANESF(scaled_s1_1 * scaled_s2_1), dot__b =
      KSL_RN_LANESF(scaled_s1_2 * scaled_s2_2),
      dot__c = dot__a + dot__b, dot__d = KSL_RN_LANESF(scaled_s1_3 * scaled_s2_3), dot_ = dot__c +
          dot__d;
  const ksl_statesf angle_ = ksl_atan2_lanesf(cross, dot_);
  angle[0] = angle_;
}
#endif

/* ksl_angle_vvf of n elements. */
static KSL_INLINED void ksl_angle_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *angle, ptrdiff_t angle_stride) {
#if KSL_LANE_BYTES
  ksl_statesf v1_states[3], v2_states[3], angle_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(v1 + i * v1_stride, 3, v1_plane, v1_stride, last, v1_states);
    ksl_statesf_of_planes(v2 + i * v2_stride, 3, v2_plane, v2_stride, last, v2_states);
    ksl_angle_vvf_states(v1_states, v2_states, angle_states);
    ksl_statesf_to_planes(angle_states, 1, angle + i * angle_stride, 1, angle_stride, last);
  }
#else
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    angle[i * angle_stride] = ksl_angle_vvf(&v1_i, &v2_i);
  }
#endif
}

static KSL_INLINED void ksl_angle_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3f_t *v2, ptrdiff_t v2_stride, float *angle,
    ptrdiff_t angle_stride) {
  ksl_angle_vvf_planes(n, (const float *)v1, 1, 3 * v1_stride, (const float *)v2, 1, 3 * v2_stride,
      angle, angle_stride);
}

/* ksl_dot_vvf of n elements. */
static KSL_INLINED void ksl_dot_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3f_t *v2, ptrdiff_t v2_stride, float *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_vvf(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_dot_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *dot, ptrdiff_t dot_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    dot[i * dot_stride] = ksl_dot_vvf(&v1_i, &v2_i);
  }
}

/* ksl_product_avinvf of n elements. */
static KSL_INLINED void ksl_product_avinvf_many(ptrdiff_t n, const float *k, ptrdiff_t k_stride,
    const ksl_vec3f_t *v, ptrdiff_t v_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avinvf(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avinvf_planes(ptrdiff_t n, const float *k, ptrdiff_t k_stride,
    const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_avinvf(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_ainvvf of n elements. */
static KSL_INLINED void ksl_product_ainvvf_many(ptrdiff_t n, const float *k, ptrdiff_t k_stride,
    const ksl_vec3f_t *v, ptrdiff_t v_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ainvvf(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_ainvvf_planes(ptrdiff_t n, const float *k, ptrdiff_t k_stride,
    const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_ainvvf(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvf of n elements. */
static KSL_INLINED void ksl_cross_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3f_t *v2, ptrdiff_t v2_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvf(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_cross_vvf(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvinvf of n elements. */
static KSL_INLINED void ksl_cross_vvinvf_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvinvf(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvinvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_cross_vvinvf(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxf of n elements. */
static KSL_INLINED void ksl_add_vvxf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvxf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxinvf of n elements. */
static KSL_INLINED void ksl_add_vvxinvf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxinvf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxinvf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvxinvf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyf of n elements. */
static KSL_INLINED void ksl_add_vvyf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvyf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyinvf of n elements. */
static KSL_INLINED void ksl_add_vvyinvf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyinvf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyinvf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvyinvf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzf of n elements. */
static KSL_INLINED void ksl_add_vvzf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvzf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzinvf of n elements. */
static KSL_INLINED void ksl_add_vvzinvf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzinvf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzinvf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvzinvf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

#endif
