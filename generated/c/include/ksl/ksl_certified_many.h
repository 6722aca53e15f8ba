/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* All certified kernels of many elements. */
#ifndef KSL_CERTIFIED_MANY_H
#define KSL_CERTIFIED_MANY_H

#include "elementary_certified_many.h"
#include "vec3_certified_many.h"
#include "vec4_certified_many.h"
#include "mat3x3_certified_many.h"
#include "SE3_certified_many.h"
#include "mat6x6_certified_many.h"
#include "matrix_certified_many.h"
#include "trig_certified_many.h"
#include "screw_certified_many.h"
#include "coscrew_certified_many.h"
#include "quaternion_certified_many.h"
#include "exponential_certified_many.h"
#include "inertia_certified_many.h"
#include "spatial_inertia_certified_many.h"

#endif
