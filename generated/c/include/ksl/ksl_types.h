/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Types of the spatial algebra, in double and single precision.

   Every quantity is a union of several views.  Matrices are stored column by column.  Screws
   s = (v; ω) and coscrews c = (f; τ) have the linear part on top, so that power is their dot product.

   All functions: pointers must point to valid objects; an output may be the same object as an
   input; nothing else is read or written.  Every operation is rounded once, in the order written, so
   that results have the same bits on every machine, under every set of flags that compiles.

   Error bounds are derived from that order, to first order in u: u = 2^-53 in double and 2^-24 in
   single precision. */
#ifndef KSL_TYPES_H
#define KSL_TYPES_H

#include <math.h>
#include <string.h>

#include "ksl_rounding.h"

/* The version, for #if KSL_VERSION >= KSL_VERSION_NUMBER(1, 2, 3). */
#define KSL_VERSION_MAJOR 0
#define KSL_VERSION_MINOR 2
#define KSL_VERSION_PATCH 0
#define KSL_VERSION_NUMBER(major, minor, patch) (10000 * (major) + 100 * (minor) + (patch))
#define KSL_VERSION KSL_VERSION_NUMBER(KSL_VERSION_MAJOR, KSL_VERSION_MINOR, KSL_VERSION_PATCH)
#define KSL_VERSION_STRING "0.2.0"

#if defined(__GNUC__)
#define KSL_VIEW __extension__ struct
#else
#define KSL_VIEW struct
#endif

/* vector (x, y, z); double precision. */
typedef union ksl_vec3_t {
  KSL_VIEW { double at[3]; };
  KSL_VIEW { double x, y, z; };
} ksl_vec3_t;

/* vector (x, y, z); single precision. */
typedef union ksl_vec3f_t {
  KSL_VIEW { float at[3]; };
  KSL_VIEW { float x, y, z; };
} ksl_vec3f_t;

/* vector (x, y, z); integer precision. */
typedef union ksl_vec3i_t {
  KSL_VIEW { int at[3]; };
  KSL_VIEW { int x, y, z; };
} ksl_vec3i_t;

/* vector (x, y, z, w), r = (x, y, z), w a homogeneous coordinate; double precision. */
typedef union ksl_vec4_t {
  KSL_VIEW { double at[4]; };
  KSL_VIEW { double x, y, z, w; };
  KSL_VIEW { ksl_vec3_t r; };
} ksl_vec4_t;

/* vector (x, y, z, w), r = (x, y, z), w a homogeneous coordinate; single precision. */
typedef union ksl_vec4f_t {
  KSL_VIEW { float at[4]; };
  KSL_VIEW { float x, y, z, w; };
  KSL_VIEW { ksl_vec3f_t r; };
} ksl_vec4f_t;

/* vector (x, y, z, w), r = (x, y, z), w a homogeneous coordinate; integer precision. */
typedef union ksl_vec4i_t {
  KSL_VIEW { int at[4]; };
  KSL_VIEW { int x, y, z, w; };
  KSL_VIEW { ksl_vec3i_t r; };
} ksl_vec4i_t;

/* 3×3 matrix, stored column by column: m21 is row 2, column 1, also at[1][2]; double precision. */
typedef union ksl_mat3x3_t {
  KSL_VIEW { double as_array[9]; };
  KSL_VIEW { double at[3][3]; };
  KSL_VIEW {
    double m00, m10, m20;
    double m01, m11, m21;
    double m02, m12, m22;
  };
  KSL_VIEW { ksl_vec3_t v0, v1, v2; };
  KSL_VIEW { ksl_vec3_t v[3]; };
} ksl_mat3x3_t;

/* 3×3 matrix, stored column by column: m21 is row 2, column 1, also at[1][2]; single precision. */
typedef union ksl_mat3x3f_t {
  KSL_VIEW { float as_array[9]; };
  KSL_VIEW { float at[3][3]; };
  KSL_VIEW {
    float m00, m10, m20;
    float m01, m11, m21;
    float m02, m12, m22;
  };
  KSL_VIEW { ksl_vec3f_t v0, v1, v2; };
  KSL_VIEW { ksl_vec3f_t v[3]; };
} ksl_mat3x3f_t;

/* 4×4 matrix, stored column by column: m32 is row 3, column 2, also at[2][3]; double precision. */
typedef union ksl_mat4x4_t {
  KSL_VIEW { double as_array[16]; };
  KSL_VIEW { double at[4][4]; };
  KSL_VIEW {
    double m00, m10, m20, m30;
    double m01, m11, m21, m31;
    double m02, m12, m22, m32;
    double m03, m13, m23, m33;
  };
  KSL_VIEW { ksl_vec4_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec4_t v[4]; };
} ksl_mat4x4_t;

/* 4×4 matrix, stored column by column: m32 is row 3, column 2, also at[2][3]; single precision. */
typedef union ksl_mat4x4f_t {
  KSL_VIEW { float as_array[16]; };
  KSL_VIEW { float at[4][4]; };
  KSL_VIEW {
    float m00, m10, m20, m30;
    float m01, m11, m21, m31;
    float m02, m12, m22, m32;
    float m03, m13, m23, m33;
  };
  KSL_VIEW { ksl_vec4f_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec4f_t v[4]; };
} ksl_mat4x4f_t;

/* displacement [R | t], stored column by column: m13 is t.y, also at[3][1]; double precision. */
typedef union ksl_SE3_t {
  KSL_VIEW { double as_array[12]; };
  KSL_VIEW { double at[4][3]; };
  KSL_VIEW {
    ksl_mat3x3_t R;
    ksl_vec3_t t;
  };
  KSL_VIEW {
    double m00, m10, m20;
    double m01, m11, m21;
    double m02, m12, m22;
    double m03, m13, m23;
  };
  KSL_VIEW { ksl_vec3_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec3_t v[4]; };
} ksl_SE3_t;

/* displacement [R | t], stored column by column: m13 is t.y, also at[3][1]; single precision. */
typedef union ksl_SE3f_t {
  KSL_VIEW { float as_array[12]; };
  KSL_VIEW { float at[4][3]; };
  KSL_VIEW {
    ksl_mat3x3f_t R;
    ksl_vec3f_t t;
  };
  KSL_VIEW {
    float m00, m10, m20;
    float m01, m11, m21;
    float m02, m12, m22;
    float m03, m13, m23;
  };
  KSL_VIEW { ksl_vec3f_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec3f_t v[4]; };
} ksl_SE3f_t;

/* screw (lin; ang) = (v; ω); double precision. */
typedef union ksl_screw_t {
  KSL_VIEW { double at[6]; };
  KSL_VIEW { ksl_vec3_t lin, ang; };
  KSL_VIEW { double m0, m1, m2, m3, m4, m5; };
} ksl_screw_t;

/* screw (lin; ang) = (v; ω); single precision. */
typedef union ksl_screwf_t {
  KSL_VIEW { float at[6]; };
  KSL_VIEW { ksl_vec3f_t lin, ang; };
  KSL_VIEW { float m0, m1, m2, m3, m4, m5; };
} ksl_screwf_t;

/* coscrew (lin; ang) = (f; τ); double precision. */
typedef union ksl_coscrew_t {
  KSL_VIEW { double at[6]; };
  KSL_VIEW { ksl_vec3_t lin, ang; };
  KSL_VIEW { double m0, m1, m2, m3, m4, m5; };
} ksl_coscrew_t;

/* coscrew (lin; ang) = (f; τ); single precision. */
typedef union ksl_coscrewf_t {
  KSL_VIEW { float at[6]; };
  KSL_VIEW { ksl_vec3f_t lin, ang; };
  KSL_VIEW { float m0, m1, m2, m3, m4, m5; };
} ksl_coscrewf_t;

/* 6×6 operator, stored column by column: at[column][row]; double precision. */
typedef union ksl_mat6x6_t {
  KSL_VIEW { double as_array[36]; };
  KSL_VIEW { double at[6][6]; };
} ksl_mat6x6_t;

/* 6×6 operator, stored column by column: at[column][row]; single precision. */
typedef union ksl_mat6x6f_t {
  KSL_VIEW { float as_array[36]; };
  KSL_VIEW { float at[6][6]; };
} ksl_mat6x6f_t;

/* quaternion (x, y, z, w), r = (x, y, z); for rotations, of norm 1; double precision. */
typedef union ksl_quaternion_t {
  KSL_VIEW { double at[4]; };
  KSL_VIEW { double x, y, z, w; };
  KSL_VIEW { ksl_vec3_t r; };
} ksl_quaternion_t;

/* quaternion (x, y, z, w), r = (x, y, z); for rotations, of norm 1; single precision. */
typedef union ksl_quaternionf_t {
  KSL_VIEW { float at[4]; };
  KSL_VIEW { float x, y, z, w; };
  KSL_VIEW { ksl_vec3f_t r; };
} ksl_quaternionf_t;

/* inertia: mass m, first moment mt = m c, moments about the centre of mass c; double precision. */
typedef union ksl_inertia_t {
  KSL_VIEW { double at[10]; };
  KSL_VIEW {
    double m;
    ksl_vec3_t mt;
    double Ixx, Iyy, Izz, Ixy, Iyz, Izx;
  };
  KSL_VIEW {
    double mass;
    ksl_vec3_t mr;
    double diagonal[3];
    double Iyx, Izy, Ixz;
  };
} ksl_inertia_t;

/* inertia: mass m, first moment mt = m c, moments about the centre of mass c; single precision. */
typedef union ksl_inertiaf_t {
  KSL_VIEW { float at[10]; };
  KSL_VIEW {
    float m;
    ksl_vec3f_t mt;
    float Ixx, Iyy, Izz, Ixy, Iyz, Izx;
  };
  KSL_VIEW {
    float mass;
    ksl_vec3f_t mr;
    float diagonal[3];
    float Iyx, Izy, Ixz;
  };
} ksl_inertiaf_t;

/* spatial inertia: mass m, first moment h = m c, moments about the origin; double precision. */
typedef union ksl_spatial_inertia_t {
  KSL_VIEW { double at[10]; };
  KSL_VIEW {
    double m;
    ksl_vec3_t h;
    double xx, yy, zz, xy, xz, yz;
  };
} ksl_spatial_inertia_t;

/* spatial inertia: mass m, first moment h = m c, moments about the origin; single precision. */
typedef union ksl_spatial_inertiaf_t {
  KSL_VIEW { float at[10]; };
  KSL_VIEW {
    float m;
    ksl_vec3f_t h;
    float xx, yy, zz, xy, xz, yz;
  };
} ksl_spatial_inertiaf_t;

/* Sequences of axes of Euler angles.  Each rotation is about a current axis of the body, that is, as
   rotated by those before it. */
typedef enum ksl_axis_enum_t {
  KSL_AXIS_XYZ,
  KSL_AXIS_YZX,
  KSL_AXIS_ZXY,
  KSL_AXIS_XZY,
  KSL_AXIS_YXZ,
  KSL_AXIS_ZYX,
  KSL_AXIS_XYX,
  KSL_AXIS_XZX,
  KSL_AXIS_YXY,
  KSL_AXIS_YZY,
  KSL_AXIS_ZXZ,
  KSL_AXIS_ZYZ,
  KSL_AXIS_INVALID
} ksl_axis_enum_t;

#endif
