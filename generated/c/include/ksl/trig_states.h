/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Sine and cosine of a joint angle.  On vectors.
   An argument is its components, in the order of structs, each a vector with that of several
   elements: KSL_LANES of them, in single precision KSL_LANESF. */
#ifndef KSL_TRIG_STATES_H
#define KSL_TRIG_STATES_H

#include "ksl_states.h"

#if KSL_LANE_BYTES
static KSL_INLINE void ksl_dc_states(const ksl_states *theta, ksl_states *dc) {
  ksl_states dc_2; const ksl_states dc_1 = ksl_sincos_lanes(theta[0], &dc_2);
  dc[0] = dc_1;
  dc[1] = dc_2;
}

static KSL_INLINE void ksl_dcf_states(const ksl_statesf *theta, ksl_statesf *dc) {
  ksl_statesf dc_2; const ksl_statesf dc_1 = ksl_sincos_lanesf(theta[0], &dc_2);
  dc[0] = dc_1;
  dc[1] = dc_2;
}

#endif
#endif
