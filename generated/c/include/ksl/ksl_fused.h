/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* All kernels of the fused tier. */
#ifndef KSL_FUSED_H
#define KSL_FUSED_H

#include "vec3_fused.h"
#include "vec4_fused.h"
#include "mat3x3_fused.h"
#include "SE3_fused.h"
#include "mat6x6_fused.h"
#include "matrix_fused.h"
#include "screw_fused.h"
#include "coscrew_fused.h"
#include "quaternion_fused.h"
#include "exponential_fused.h"
#include "inertia_fused.h"
#include "spatial_inertia_fused.h"

#endif
