/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Elementary functions, with the same bits on every machine.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_ELEMENTARY_MANY_H
#define KSL_ELEMENTARY_MANY_H

#include "elementary.h"
#include "ksl_planes.h"

/* ksl_sincos of n elements. */
static KSL_INLINED void ksl_sincos_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *c,
    ptrdiff_t c_stride, double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincos(x[i * x_stride], c + i * c_stride);
  }
}

static KSL_INLINED void ksl_sincos_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *c, ptrdiff_t c_stride, double *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincos(x[i * x_stride], c + i * c_stride);
  }
}

/* ksl_sin of n elements. */
static KSL_INLINED void ksl_sin_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *s,
    ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sin(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_sin_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *s,
    ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sin(x[i * x_stride]);
  }
}

/* ksl_cos of n elements. */
static KSL_INLINED void ksl_cos_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *c,
    ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cos(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_cos_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *c,
    ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cos(x[i * x_stride]);
  }
}

/* ksl_exp of n elements. */
static KSL_INLINED void ksl_exp_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_exp(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_exp_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_exp(x[i * x_stride]);
  }
}

/* ksl_tanh of n elements. */
static KSL_INLINED void ksl_tanh_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanh(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_tanh_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanh(x[i * x_stride]);
  }
}

/* ksl_atan2 of n elements. */
static KSL_INLINED void ksl_atan2_many(ptrdiff_t n, const double *y, ptrdiff_t y_stride,
    const double *x, ptrdiff_t x_stride, double *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2(y[i * y_stride], x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_atan2_planes(ptrdiff_t n, const double *y, ptrdiff_t y_stride,
    const double *x, ptrdiff_t x_stride, double *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2(y[i * y_stride], x[i * x_stride]);
  }
}

/* ksl_sincosf of n elements. */
static KSL_INLINED void ksl_sincosf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *c,
    ptrdiff_t c_stride, float *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincosf(x[i * x_stride], c + i * c_stride);
  }
}

static KSL_INLINED void ksl_sincosf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *c, ptrdiff_t c_stride, float *s, ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincosf(x[i * x_stride], c + i * c_stride);
  }
}

/* ksl_sinf of n elements. */
static KSL_INLINED void ksl_sinf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *s,
    ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sinf(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_sinf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *s,
    ptrdiff_t s_stride) {
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sinf(x[i * x_stride]);
  }
}

/* ksl_cosf of n elements. */
static KSL_INLINED void ksl_cosf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *c,
    ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cosf(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_cosf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *c,
    ptrdiff_t c_stride) {
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cosf(x[i * x_stride]);
  }
}

/* ksl_expf of n elements. */
static KSL_INLINED void ksl_expf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_expf(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_expf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_expf(x[i * x_stride]);
  }
}

/* ksl_tanhf of n elements. */
static KSL_INLINED void ksl_tanhf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanhf(x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_tanhf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanhf(x[i * x_stride]);
  }
}

/* ksl_atan2f of n elements. */
static KSL_INLINED void ksl_atan2f_many(ptrdiff_t n, const float *y, ptrdiff_t y_stride,
    const float *x, ptrdiff_t x_stride, float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2f(y[i * y_stride], x[i * x_stride]);
  }
}

static KSL_INLINED void ksl_atan2f_planes(ptrdiff_t n, const float *y, ptrdiff_t y_stride,
    const float *x, ptrdiff_t x_stride, float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2f(y[i * y_stride], x[i * x_stride]);
  }
}

#endif
