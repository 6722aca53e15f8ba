/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* All kernels of the certified tier. */
#ifndef KSL_CERTIFIED_H
#define KSL_CERTIFIED_H

#include "elementary_certified.h"
#include "vec3_certified.h"
#include "vec4_certified.h"
#include "mat3x3_certified.h"
#include "SE3_certified.h"
#include "mat6x6_certified.h"
#include "matrix_certified.h"
#include "trig_certified.h"
#include "screw_certified.h"
#include "coscrew_certified.h"
#include "quaternion_certified.h"
#include "exponential_certified.h"
#include "inertia_certified.h"
#include "spatial_inertia_certified.h"

#endif
