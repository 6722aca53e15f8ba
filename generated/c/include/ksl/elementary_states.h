/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Elementary functions, with the same bits on every machine.  On vectors.
   An argument is its components, in the order of structs, each a vector with that of several
   elements: KSL_LANES of them, in single precision KSL_LANESF. */
#ifndef KSL_ELEMENTARY_STATES_H
#define KSL_ELEMENTARY_STATES_H

#include "ksl_states.h"

#if KSL_LANE_BYTES
static KSL_INLINE void ksl_sincos_states(const ksl_states *x, ksl_states *s, ksl_states *c) {
  ksl_states c_; const ksl_states s_ = ksl_sincos_lanes(x[0], &c_);
  s[0] = s_;
  c[0] = c_;
}

static KSL_INLINE void ksl_sin_states(const ksl_states *x, ksl_states *s) {
  const ksl_states s_ = ksl_sin_lanes(x[0]);
  s[0] = s_;
}

static KSL_INLINE void ksl_cos_states(const ksl_states *x, ksl_states *c) {
  const ksl_states c_ = ksl_cos_lanes(x[0]);
  c[0] = c_;
}

static KSL_INLINE void ksl_exp_states(const ksl_states *x, ksl_states *y) {
  const ksl_states y_ = ksl_exp_lanes(x[0]);
  y[0] = y_;
}

static KSL_INLINE void ksl_tanh_states(const ksl_states *x, ksl_states *y) {
  const ksl_states y_ = ksl_tanh_lanes(x[0]);
  y[0] = y_;
}

static KSL_INLINE void ksl_atan2_states(const ksl_states *y, const ksl_states *x,
    ksl_states *angle) {
  const ksl_states angle_ = ksl_atan2_lanes(y[0], x[0]);
  angle[0] = angle_;
}

static KSL_INLINE void ksl_sincosf_states(const ksl_statesf *x, ksl_statesf *s, ksl_statesf *c) {
  ksl_statesf c_; const ksl_statesf s_ = ksl_sincos_lanesf(x[0], &c_);
  s[0] = s_;
  c[0] = c_;
}

static KSL_INLINE void ksl_sinf_states(const ksl_statesf *x, ksl_statesf *s) {
  const ksl_statesf s_ = ksl_sin_lanesf(x[0]);
  s[0] = s_;
}

static KSL_INLINE void ksl_cosf_states(const ksl_statesf *x, ksl_statesf *c) {
  const ksl_statesf c_ = ksl_cos_lanesf(x[0]);
  c[0] = c_;
}

static KSL_INLINE void ksl_expf_states(const ksl_statesf *x, ksl_statesf *y) {
  const ksl_statesf y_ = ksl_exp_lanesf(x[0]);
  y[0] = y_;
}

static KSL_INLINE void ksl_tanhf_states(const ksl_statesf *x, ksl_statesf *y) {
  const ksl_statesf y_ = ksl_tanh_lanesf(x[0]);
  y[0] = y_;
}

static KSL_INLINE void ksl_atan2f_states(const ksl_statesf *y, const ksl_statesf *x,
    ksl_statesf *angle) {
  const ksl_statesf angle_ = ksl_atan2_lanesf(y[0], x[0]);
  angle[0] = angle_;
}

#endif
#endif
