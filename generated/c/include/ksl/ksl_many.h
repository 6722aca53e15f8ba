/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* All plain kernels of many elements. */
#ifndef KSL_MANY_H
#define KSL_MANY_H

#include "elementary_many.h"
#include "vec3_many.h"
#include "vec4_many.h"
#include "mat3x3_many.h"
#include "SE3_many.h"
#include "mat4x4_many.h"
#include "mat6x6_many.h"
#include "matrix_many.h"
#include "trig_many.h"
#include "screw_many.h"
#include "coscrew_many.h"
#include "quaternion_many.h"
#include "exponential_many.h"
#include "symmetric_many.h"
#include "inertia_many.h"
#include "spatial_inertia_many.h"

#endif
