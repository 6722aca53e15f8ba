/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Elementary functions, with the same bits on every machine.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_ELEMENTARY_ACCURATE_MANY_H
#define KSL_ELEMENTARY_ACCURATE_MANY_H

#include "elementary_accurate.h"
#include "ksl_planes.h"

/* ksl_sincos_accurate of n elements. */
static KSL_INLINED void ksl_sincos_accurate_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *c, ptrdiff_t c_stride, double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincos_accurate(x[i * x_stride], c + i * c_stride);
  }
}

static KSL_INLINED void ksl_sincos_accurate_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *c, ptrdiff_t c_stride, double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincos_accurate(x[i * x_stride], c + i * c_stride);
  }
}

/* ksl_sin_accurate of n elements. */
static KSL_INLINED void ksl_sin_accurate_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sin_accurate(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_sin_accurate_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sin_accurate(x[i * x_stride]);
  }
}

/* ksl_cos_accurate of n elements. */
static KSL_INLINED void ksl_cos_accurate_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *c, ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cos_accurate(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_cos_accurate_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *c, ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cos_accurate(x[i * x_stride]);
  }
}

/* ksl_exp_accurate of n elements. */
static KSL_INLINED void ksl_exp_accurate_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_exp_accurate(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_exp_accurate_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_exp_accurate(x[i * x_stride]);
  }
}

/* ksl_tanh_accurate of n elements. */
static KSL_INLINED void ksl_tanh_accurate_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanh_accurate(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_tanh_accurate_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanh_accurate(x[i * x_stride]);
  }
}

/* ksl_atan2_accurate of n elements. */
static KSL_INLINED void ksl_atan2_accurate_many(ptrdiff_t n, const double *y, ptrdiff_t y_stride,
    const double *x, ptrdiff_t x_stride, double *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2_accurate(y[i * y_stride], x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_atan2_accurate_planes(ptrdiff_t n, const double *y, ptrdiff_t y_stride,
    const double *x, ptrdiff_t x_stride, double *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2_accurate(y[i * y_stride], x[i * x_stride]);
  }
}

/* ksl_sincosf_accurate of n elements. */
static KSL_INLINED void ksl_sincosf_accurate_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *c, ptrdiff_t c_stride, float *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincosf_accurate(x[i * x_stride], c + i * c_stride);
  }
}

static KSL_INLINED void ksl_sincosf_accurate_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *c, ptrdiff_t c_stride, float *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincosf_accurate(x[i * x_stride], c + i * c_stride);
  }
}

/* ksl_sinf_accurate of n elements. */
static KSL_INLINED void ksl_sinf_accurate_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sinf_accurate(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_sinf_accurate_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sinf_accurate(x[i * x_stride]);
  }
}

/* ksl_cosf_accurate of n elements. */
static KSL_INLINED void ksl_cosf_accurate_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *c, ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cosf_accurate(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_cosf_accurate_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *c, ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cosf_accurate(x[i * x_stride]);
  }
}

/* ksl_expf_accurate of n elements. */
static KSL_INLINED void ksl_expf_accurate_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_expf_accurate(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_expf_accurate_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_expf_accurate(x[i * x_stride]);
  }
}

/* ksl_tanhf_accurate of n elements. */
static KSL_INLINED void ksl_tanhf_accurate_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanhf_accurate(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_tanhf_accurate_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanhf_accurate(x[i * x_stride]);
  }
}

/* ksl_atan2f_accurate of n elements. */
static KSL_INLINED void ksl_atan2f_accurate_many(ptrdiff_t n, const float *y, ptrdiff_t y_stride,
    const float *x, ptrdiff_t x_stride, float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2f_accurate(y[i * y_stride], x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_atan2f_accurate_planes(ptrdiff_t n, const float *y, ptrdiff_t y_stride,
    const float *x, ptrdiff_t x_stride, float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2f_accurate(y[i * y_stride], x[i * x_stride]);
  }
}

#endif
