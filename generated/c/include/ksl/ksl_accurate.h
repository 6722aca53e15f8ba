/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* All kernels of the accurate tier. */
#ifndef KSL_ACCURATE_H
#define KSL_ACCURATE_H

#include "elementary_accurate.h"
#include "vec3_accurate.h"
#include "vec4_accurate.h"
#include "mat3x3_accurate.h"
#include "SE3_accurate.h"
#include "mat6x6_accurate.h"
#include "matrix_accurate.h"
#include "trig_accurate.h"
#include "screw_accurate.h"
#include "coscrew_accurate.h"
#include "quaternion_accurate.h"
#include "exponential_accurate.h"
#include "symmetric_accurate.h"
#include "inertia_accurate.h"
#include "spatial_inertia_accurate.h"

#endif
