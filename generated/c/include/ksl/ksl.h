/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Everything: vectors, rotations, displacements, screws and coscrews. */
#ifndef KSL_H
#define KSL_H

#include "elementary.h"
#include "vec3.h"
#include "axis.h"
#include "array.h"
#include "vec4.h"
#include "mat3x3.h"
#include "SE3.h"
#include "mat4x4.h"
#include "mat6x6.h"
#include "matrix.h"
#include "trig.h"
#include "screw.h"
#include "coscrew.h"
#include "quaternion.h"
#include "exponential.h"
#include "symmetric.h"
#include "inertia.h"
#include "spatial_inertia.h"
#include "ksl_selfcheck.h"

#endif
