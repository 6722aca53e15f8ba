/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Axes, and sequences of axes of Euler angles. */
#ifndef KSL_AXIS_H
#define KSL_AXIS_H

#include "ksl_types.h"
#include "vec3.h"

/* What KSL declares beside formulas. */

/* The axes of a sequence, x 0, y 1, z 2; -1 for KSL_AXIS_INVALID. */
static inline ksl_vec3i_t ksl_axis_getVector(ksl_axis_enum_t axisType) {
  switch (axisType) {
    case KSL_AXIS_XYZ: return ksl_vec3i(0, 1, 2);
    case KSL_AXIS_YZX: return ksl_vec3i(1, 2, 0);
    case KSL_AXIS_ZXY: return ksl_vec3i(2, 0, 1);
    case KSL_AXIS_XZY: return ksl_vec3i(0, 2, 1);
    case KSL_AXIS_YXZ: return ksl_vec3i(1, 0, 2);
    case KSL_AXIS_ZYX: return ksl_vec3i(2, 1, 0);
    case KSL_AXIS_XYX: return ksl_vec3i(0, 1, 0);
    case KSL_AXIS_XZX: return ksl_vec3i(0, 2, 0);
    case KSL_AXIS_YXY: return ksl_vec3i(1, 0, 1);
    case KSL_AXIS_YZY: return ksl_vec3i(1, 2, 1);
    case KSL_AXIS_ZXZ: return ksl_vec3i(2, 0, 2);
    case KSL_AXIS_ZYZ: return ksl_vec3i(2, 1, 2);
    case KSL_AXIS_INVALID:
    default: break;
  }
  return ksl_vec3i(-1, -1, -1);
}

/* The sequence of three axes, x 0, y 1, z 2; KSL_AXIS_INVALID if Euler angles do not have it. */
static inline ksl_axis_enum_t ksl_axis_getEulerAngles(ksl_vec3i_t angles) {
  if (angles.x == 0 && angles.y == 1 && angles.z == 2) {
    return KSL_AXIS_XYZ;
  }
  if (angles.x == 1 && angles.y == 2 && angles.z == 0) {
    return KSL_AXIS_YZX;
  }
  if (angles.x == 2 && angles.y == 0 && angles.z == 1) {
    return KSL_AXIS_ZXY;
  }
  if (angles.x == 0 && angles.y == 2 && angles.z == 1) {
    return KSL_AXIS_XZY;
  }
  if (angles.x == 1 && angles.y == 0 && angles.z == 2) {
    return KSL_AXIS_YXZ;
  }
  if (angles.x == 2 && angles.y == 1 && angles.z == 0) {
    return KSL_AXIS_ZYX;
  }
  if (angles.x == 0 && angles.y == 1 && angles.z == 0) {
    return KSL_AXIS_XYX;
  }
  if (angles.x == 0 && angles.y == 2 && angles.z == 0) {
    return KSL_AXIS_XZX;
  }
  if (angles.x == 1 && angles.y == 0 && angles.z == 1) {
    return KSL_AXIS_YXY;
  }
  if (angles.x == 1 && angles.y == 2 && angles.z == 1) {
    return KSL_AXIS_YZY;
  }
  if (angles.x == 2 && angles.y == 0 && angles.z == 2) {
    return KSL_AXIS_ZXZ;
  }
  if (angles.x == 2 && angles.y == 1 && angles.z == 2) {
    return KSL_AXIS_ZYZ;
  }
  return KSL_AXIS_INVALID;
}

#endif
