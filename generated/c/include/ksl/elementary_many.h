/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Elementary functions, with the same bits on every machine.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_ELEMENTARY_MANY_H
#define KSL_ELEMENTARY_MANY_H

#include "elementary.h"
#include "ksl_states.h"

#if KSL_LANE_BYTES
/* ksl_sincos of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_sincos_states(const ksl_states *x, ksl_states *s, ksl_states *c) {
  ksl_states c_; const ksl_states s_ = ksl_sincos_lanes(x[0], &c_);
  s[0] = s_;
  c[0] = c_;
}
#endif

/* ksl_sincos of n elements. */
static KSL_INLINED void ksl_sincos_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride,
    double *c, ptrdiff_t c_stride, double *s, ptrdiff_t s_stride) {
#if KSL_LANE_BYTES
  ksl_states x_states[1], c_states[1], s_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_sincos_states(x_states, s_states, c_states);
    ksl_states_to_planes(c_states, 1, c + i * c_stride, 1, c_stride, last);
    ksl_states_to_planes(s_states, 1, s + i * s_stride, 1, s_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincos(x[i * x_stride], c + i * c_stride);
  }
#endif
}

static KSL_INLINED void ksl_sincos_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *c,
    ptrdiff_t c_stride, double *s, ptrdiff_t s_stride) {
  ksl_sincos_planes(n, x, x_stride, c, c_stride, s, s_stride);
}

#if KSL_LANE_BYTES
/* ksl_sin of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_sin_states(const ksl_states *x, ksl_states *s) {
  const ksl_states s_ = ksl_sin_lanes(x[0]);
  s[0] = s_;
}
#endif

/* ksl_sin of n elements. */
static KSL_INLINED void ksl_sin_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *s,
    ptrdiff_t s_stride) {
#if KSL_LANE_BYTES
  ksl_states x_states[1], s_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_sin_states(x_states, s_states);
    ksl_states_to_planes(s_states, 1, s + i * s_stride, 1, s_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sin(x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_sin_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *s,
    ptrdiff_t s_stride) {
  ksl_sin_planes(n, x, x_stride, s, s_stride);
}

#if KSL_LANE_BYTES
/* ksl_cos of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_cos_states(const ksl_states *x, ksl_states *c) {
  const ksl_states c_ = ksl_cos_lanes(x[0]);
  c[0] = c_;
}
#endif

/* ksl_cos of n elements. */
static KSL_INLINED void ksl_cos_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *c,
    ptrdiff_t c_stride) {
#if KSL_LANE_BYTES
  ksl_states x_states[1], c_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_cos_states(x_states, c_states);
    ksl_states_to_planes(c_states, 1, c + i * c_stride, 1, c_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cos(x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_cos_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *c,
    ptrdiff_t c_stride) {
  ksl_cos_planes(n, x, x_stride, c, c_stride);
}

#if KSL_LANE_BYTES
/* ksl_exp of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_exp_states(const ksl_states *x, ksl_states *y) {
  const ksl_states y_ = ksl_exp_lanes(x[0]);
  y[0] = y_;
}
#endif

/* ksl_exp of n elements. */
static KSL_INLINED void ksl_exp_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_stride) {
#if KSL_LANE_BYTES
  ksl_states x_states[1], y_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_exp_states(x_states, y_states);
    ksl_states_to_planes(y_states, 1, y + i * y_stride, 1, y_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_exp(x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_exp_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_stride) {
  ksl_exp_planes(n, x, x_stride, y, y_stride);
}

#if KSL_LANE_BYTES
/* ksl_tanh of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_tanh_states(const ksl_states *x, ksl_states *y) {
  const ksl_states y_ = ksl_tanh_lanes(x[0]);
  y[0] = y_;
}
#endif

/* ksl_tanh of n elements. */
static KSL_INLINED void ksl_tanh_planes(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_stride) {
#if KSL_LANE_BYTES
  ksl_states x_states[1], y_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_tanh_states(x_states, y_states);
    ksl_states_to_planes(y_states, 1, y + i * y_stride, 1, y_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanh(x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_tanh_many(ptrdiff_t n, const double *x, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_stride) {
  ksl_tanh_planes(n, x, x_stride, y, y_stride);
}

#if KSL_LANE_BYTES
/* ksl_atan2 of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_atan2_states(const ksl_states *y, const ksl_states *x,
    ksl_states *angle) {
  const ksl_states angle_ = ksl_atan2_lanes(y[0], x[0]);
  angle[0] = angle_;
}
#endif

/* ksl_atan2 of n elements. */
static KSL_INLINED void ksl_atan2_planes(ptrdiff_t n, const double *y, ptrdiff_t y_stride,
    const double *x, ptrdiff_t x_stride, double *angle, ptrdiff_t angle_stride) {
#if KSL_LANE_BYTES
  ksl_states y_states[1], x_states[1], angle_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(y + i * y_stride, 1, 1, y_stride, last, y_states);
    ksl_states_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_atan2_states(y_states, x_states, angle_states);
    ksl_states_to_planes(angle_states, 1, angle + i * angle_stride, 1, angle_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2(y[i * y_stride], x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_atan2_many(ptrdiff_t n, const double *y, ptrdiff_t y_stride,
    const double *x, ptrdiff_t x_stride, double *angle, ptrdiff_t angle_stride) {
  ksl_atan2_planes(n, y, y_stride, x, x_stride, angle, angle_stride);
}

#if KSL_LANE_BYTES
/* ksl_sincosf of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_sincosf_states(const ksl_statesf *x, ksl_statesf *s, ksl_statesf *c) {
  ksl_statesf c_; const ksl_statesf s_ = ksl_sincos_lanesf(x[0], &c_);
  s[0] = s_;
  c[0] = c_;
}
#endif

/* ksl_sincosf of n elements. */
static KSL_INLINED void ksl_sincosf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride,
    float *c, ptrdiff_t c_stride, float *s, ptrdiff_t s_stride) {
#if KSL_LANE_BYTES
  ksl_statesf x_states[1], c_states[1], s_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_sincosf_states(x_states, s_states, c_states);
    ksl_statesf_to_planes(c_states, 1, c + i * c_stride, 1, c_stride, last);
    ksl_statesf_to_planes(s_states, 1, s + i * s_stride, 1, s_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sincosf(x[i * x_stride], c + i * c_stride);
  }
#endif
}

static KSL_INLINED void ksl_sincosf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *c,
    ptrdiff_t c_stride, float *s, ptrdiff_t s_stride) {
  ksl_sincosf_planes(n, x, x_stride, c, c_stride, s, s_stride);
}

#if KSL_LANE_BYTES
/* ksl_sinf of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_sinf_states(const ksl_statesf *x, ksl_statesf *s) {
  const ksl_statesf s_ = ksl_sin_lanesf(x[0]);
  s[0] = s_;
}
#endif

/* ksl_sinf of n elements. */
static KSL_INLINED void ksl_sinf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *s,
    ptrdiff_t s_stride) {
#if KSL_LANE_BYTES
  ksl_statesf x_states[1], s_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_sinf_states(x_states, s_states);
    ksl_statesf_to_planes(s_states, 1, s + i * s_stride, 1, s_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    s[i * s_stride] = ksl_sinf(x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_sinf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *s,
    ptrdiff_t s_stride) {
  ksl_sinf_planes(n, x, x_stride, s, s_stride);
}

#if KSL_LANE_BYTES
/* ksl_cosf of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_cosf_states(const ksl_statesf *x, ksl_statesf *c) {
  const ksl_statesf c_ = ksl_cos_lanesf(x[0]);
  c[0] = c_;
}
#endif

/* ksl_cosf of n elements. */
static KSL_INLINED void ksl_cosf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *c,
    ptrdiff_t c_stride) {
#if KSL_LANE_BYTES
  ksl_statesf x_states[1], c_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_cosf_states(x_states, c_states);
    ksl_statesf_to_planes(c_states, 1, c + i * c_stride, 1, c_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    c[i * c_stride] = ksl_cosf(x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_cosf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *c,
    ptrdiff_t c_stride) {
  ksl_cosf_planes(n, x, x_stride, c, c_stride);
}

#if KSL_LANE_BYTES
/* ksl_expf of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_expf_states(const ksl_statesf *x, ksl_statesf *y) {
  const ksl_statesf y_ = ksl_exp_lanesf(x[0]);
  y[0] = y_;
}
#endif

/* ksl_expf of n elements. */
static KSL_INLINED void ksl_expf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_stride) {
#if KSL_LANE_BYTES
  ksl_statesf x_states[1], y_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_expf_states(x_states, y_states);
    ksl_statesf_to_planes(y_states, 1, y + i * y_stride, 1, y_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_expf(x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_expf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_stride) {
  ksl_expf_planes(n, x, x_stride, y, y_stride);
}

#if KSL_LANE_BYTES
/* ksl_tanhf of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_tanhf_states(const ksl_statesf *x, ksl_statesf *y) {
  const ksl_statesf y_ = ksl_tanh_lanesf(x[0]);
  y[0] = y_;
}
#endif

/* ksl_tanhf of n elements. */
static KSL_INLINED void ksl_tanhf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_stride) {
#if KSL_LANE_BYTES
  ksl_statesf x_states[1], y_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_tanhf_states(x_states, y_states);
    ksl_statesf_to_planes(y_states, 1, y + i * y_stride, 1, y_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    y[i * y_stride] = ksl_tanhf(x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_tanhf_many(ptrdiff_t n, const float *x, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_stride) {
  ksl_tanhf_planes(n, x, x_stride, y, y_stride);
}

#if KSL_LANE_BYTES
/* ksl_atan2f of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_atan2f_states(const ksl_statesf *y, const ksl_statesf *x,
    ksl_statesf *angle) {
  const ksl_statesf angle_ = ksl_atan2_lanesf(y[0], x[0]);
  angle[0] = angle_;
}
#endif

/* ksl_atan2f of n elements. */
static KSL_INLINED void ksl_atan2f_planes(ptrdiff_t n, const float *y, ptrdiff_t y_stride,
    const float *x, ptrdiff_t x_stride, float *angle, ptrdiff_t angle_stride) {
#if KSL_LANE_BYTES
  ksl_statesf y_states[1], x_states[1], angle_states[1];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(y + i * y_stride, 1, 1, y_stride, last, y_states);
    ksl_statesf_of_planes(x + i * x_stride, 1, 1, x_stride, last, x_states);
    ksl_atan2f_states(y_states, x_states, angle_states);
    ksl_statesf_to_planes(angle_states, 1, angle + i * angle_stride, 1, angle_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_atan2f(y[i * y_stride], x[i * x_stride]);
  }
#endif
}

static KSL_INLINED void ksl_atan2f_many(ptrdiff_t n, const float *y, ptrdiff_t y_stride,
    const float *x, ptrdiff_t x_stride, float *angle, ptrdiff_t angle_stride) {
  ksl_atan2f_planes(n, y, y_stride, x, x_stride, angle, angle_stride);
}

#endif
