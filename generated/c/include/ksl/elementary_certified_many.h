/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Elementary functions, with the same bits on every machine.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_ELEMENTARY_CERTIFIED_MANY_H
#define KSL_ELEMENTARY_CERTIFIED_MANY_H

#include "elementary_certified.h"
#include "ksl_planes.h"

/* ksl_sincos_certified of n elements. */
static KSL_INLINED void ksl_sincos_certified_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *c, ptrdiff_t c_stride, double *s_bound, ptrdiff_t s_bound_stride,
    double *c_bound, ptrdiff_t c_bound_stride, double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincos_certified(x[i * x_stride], c + i * c_stride,
        s_bound + i * s_bound_stride, c_bound + i * c_bound_stride);
  }
}

static KSL_INLINED void ksl_sincos_certified_planes(ptrdiff_t n, const double *x,
    ptrdiff_t x_stride, double *c, ptrdiff_t c_stride, double *s_bound,
    ptrdiff_t s_bound_stride, double *c_bound, ptrdiff_t c_bound_stride,
    double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincos_certified(x[i * x_stride], c + i * c_stride,
        s_bound + i * s_bound_stride, c_bound + i * c_bound_stride);
  }
}

/* ksl_sin_certified of n elements. */
static KSL_INLINED void ksl_sin_certified_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *s_bound, ptrdiff_t s_bound_stride, double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sin_certified(x[i * x_stride], s_bound + i * s_bound_stride);
  }
}

static KSL_INLINED void ksl_sin_certified_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *s_bound, ptrdiff_t s_bound_stride, double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sin_certified(x[i * x_stride], s_bound + i * s_bound_stride);
  }
}

/* ksl_cos_certified of n elements. */
static KSL_INLINED void ksl_cos_certified_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *c_bound, ptrdiff_t c_bound_stride, double *c, ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cos_certified(x[i * x_stride], c_bound + i * c_bound_stride);
  }
}

static KSL_INLINED void ksl_cos_certified_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *c_bound, ptrdiff_t c_bound_stride, double *c, ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cos_certified(x[i * x_stride], c_bound + i * c_bound_stride);
  }
}

/* ksl_exp_certified of n elements. */
static KSL_INLINED void ksl_exp_certified_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *y_bound, ptrdiff_t y_bound_stride, double *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_exp_certified(x[i * x_stride], y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_exp_certified_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *y_bound, ptrdiff_t y_bound_stride, double *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_exp_certified(x[i * x_stride], y_bound + i * y_bound_stride);
  }
}

/* ksl_tanh_certified of n elements. */
static KSL_INLINED void ksl_tanh_certified_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *y_bound, ptrdiff_t y_bound_stride, double *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanh_certified(x[i * x_stride], y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_tanh_certified_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *y_bound, ptrdiff_t y_bound_stride, double *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanh_certified(x[i * x_stride], y_bound + i * y_bound_stride);
  }
}

/* ksl_atan2_certified of n elements. */
static KSL_INLINED void ksl_atan2_certified_many(ptrdiff_t n, const double *y, ptrdiff_t y_stride,
    const double *x, ptrdiff_t x_stride, double *angle_bound,
    ptrdiff_t angle_bound_stride, double *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2_certified(y[i * y_stride], x[i * x_stride],
        angle_bound + i * angle_bound_stride);
  }
}

static KSL_INLINED void ksl_atan2_certified_planes(ptrdiff_t n, const double *y, ptrdiff_t y_stride,
    const double *x, ptrdiff_t x_stride, double *angle_bound,
    ptrdiff_t angle_bound_stride, double *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2_certified(y[i * y_stride], x[i * x_stride],
        angle_bound + i * angle_bound_stride);
  }
}

/* ksl_sincosf_certified of n elements. */
static KSL_INLINED void ksl_sincosf_certified_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *c, ptrdiff_t c_stride, float *s_bound, ptrdiff_t s_bound_stride,
    float *c_bound, ptrdiff_t c_bound_stride, float *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincosf_certified(x[i * x_stride], c + i * c_stride,
        s_bound + i * s_bound_stride, c_bound + i * c_bound_stride);
  }
}

static KSL_INLINED void ksl_sincosf_certified_planes(ptrdiff_t n, const float *x,
    ptrdiff_t x_stride, float *c, ptrdiff_t c_stride, float *s_bound,
    ptrdiff_t s_bound_stride, float *c_bound, ptrdiff_t c_bound_stride, float *s,
    ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincosf_certified(x[i * x_stride], c + i * c_stride,
        s_bound + i * s_bound_stride, c_bound + i * c_bound_stride);
  }
}

/* ksl_sinf_certified of n elements. */
static KSL_INLINED void ksl_sinf_certified_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *s_bound, ptrdiff_t s_bound_stride, float *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sinf_certified(x[i * x_stride], s_bound + i * s_bound_stride);
  }
}

static KSL_INLINED void ksl_sinf_certified_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *s_bound, ptrdiff_t s_bound_stride, float *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sinf_certified(x[i * x_stride], s_bound + i * s_bound_stride);
  }
}

/* ksl_cosf_certified of n elements. */
static KSL_INLINED void ksl_cosf_certified_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *c_bound, ptrdiff_t c_bound_stride, float *c, ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cosf_certified(x[i * x_stride], c_bound + i * c_bound_stride);
  }
}

static KSL_INLINED void ksl_cosf_certified_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *c_bound, ptrdiff_t c_bound_stride, float *c, ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cosf_certified(x[i * x_stride], c_bound + i * c_bound_stride);
  }
}

/* ksl_expf_certified of n elements. */
static KSL_INLINED void ksl_expf_certified_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *y_bound, ptrdiff_t y_bound_stride, float *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_expf_certified(x[i * x_stride], y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_expf_certified_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *y_bound, ptrdiff_t y_bound_stride, float *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_expf_certified(x[i * x_stride], y_bound + i * y_bound_stride);
  }
}

/* ksl_tanhf_certified of n elements. */
static KSL_INLINED void ksl_tanhf_certified_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *y_bound, ptrdiff_t y_bound_stride, float *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanhf_certified(x[i * x_stride], y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_tanhf_certified_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *y_bound, ptrdiff_t y_bound_stride, float *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanhf_certified(x[i * x_stride], y_bound + i * y_bound_stride);
  }
}

/* ksl_atan2f_certified of n elements. */
static KSL_INLINED void ksl_atan2f_certified_many(ptrdiff_t n, const float *y, ptrdiff_t y_stride,
    const float *x, ptrdiff_t x_stride, float *angle_bound,
    ptrdiff_t angle_bound_stride, float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2f_certified(y[i * y_stride], x[i * x_stride],
        angle_bound + i * angle_bound_stride);
  }
}

static KSL_INLINED void ksl_atan2f_certified_planes(ptrdiff_t n, const float *y, ptrdiff_t y_stride,
    const float *x, ptrdiff_t x_stride, float *angle_bound,
    ptrdiff_t angle_bound_stride, float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2f_certified(y[i * y_stride], x[i * x_stride],
        angle_bound + i * angle_bound_stride);
  }
}

#endif
