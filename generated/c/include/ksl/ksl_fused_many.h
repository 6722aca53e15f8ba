/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* All fused kernels of many elements. */
#ifndef KSL_FUSED_MANY_H
#define KSL_FUSED_MANY_H

#include "vec3_fused_many.h"
#include "vec4_fused_many.h"
#include "mat3x3_fused_many.h"
#include "SE3_fused_many.h"
#include "mat6x6_fused_many.h"
#include "matrix_fused_many.h"
#include "screw_fused_many.h"
#include "coscrew_fused_many.h"
#include "quaternion_fused_many.h"
#include "exponential_fused_many.h"
#include "inertia_fused_many.h"
#include "spatial_inertia_fused_many.h"

#endif
