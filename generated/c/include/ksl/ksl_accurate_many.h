/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* All accurate kernels of many elements. */
#ifndef KSL_ACCURATE_MANY_H
#define KSL_ACCURATE_MANY_H

#include "elementary_accurate_many.h"
#include "vec3_accurate_many.h"
#include "vec4_accurate_many.h"
#include "mat3x3_accurate_many.h"
#include "SE3_accurate_many.h"
#include "mat6x6_accurate_many.h"
#include "matrix_accurate_many.h"
#include "trig_accurate_many.h"
#include "screw_accurate_many.h"
#include "coscrew_accurate_many.h"
#include "quaternion_accurate_many.h"
#include "exponential_accurate_many.h"
#include "symmetric_accurate_many.h"
#include "inertia_accurate_many.h"
#include "spatial_inertia_accurate_many.h"

#endif
