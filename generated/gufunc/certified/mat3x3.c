/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat3x3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/mat3x3_certified.h"
#include <fenv.h>

/* (3),(3)->(3,3),(3,3) */
OVER(acceleration_tensor_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t w, &w);
  EACH {
    ksl_vec3_t dw;
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD_OTHER(vec3_double, &w);
    LOAD(vec3_double, &dw, 1, 1);
    ksl_acceleration_tensor_certified(&w, &dw, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 2, 2);
    STORE(mat3x3_double, &Ro_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(acceleration_tensor_double)
LOOP(acceleration_tensor_double, 4, DENSE_OR_ONE, 24, 24, 72, 72, 8, 8, 24, 8, 24, 8)

OVER(acceleration_tensor_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t w, &w);
  EACH {
    ksl_vec3f_t dw;
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD_OTHER(vec3_single, &w);
    LOAD(vec3_single, &dw, 1, 1);
    ksl_acceleration_tensorf_certified(&w, &dw, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 2, 2);
    STORE(mat3x3_single, &Ro_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(acceleration_tensor_single)
LOOP(acceleration_tensor_single, 4, DENSE_OR_ONE, 12, 12, 36, 36, 4, 4, 12, 4, 12, 4)
LOOPS(acceleration_tensor)

/* (3,3)->(),() */
OVER(mat3x3_determinant_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t R;
    double det;
    double det_bound;
    LOAD(mat3x3_double, &R, 0, 0);
    det = ksl_mat3x3_determinant_certified(&R, &det_bound);
    STORE(scalar_double, &det, 1, 2);
    STORE(scalar_double, &det_bound, 2, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat3x3_determinant_double)
LOOP(mat3x3_determinant_double, 3, DENSE, 72, 8, 8, 24, 8)

OVER(mat3x3_determinant_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t R;
    float det;
    float det_bound;
    LOAD(mat3x3_single, &R, 0, 0);
    det = ksl_mat3x3f_determinant_certified(&R, &det_bound);
    STORE(scalar_single, &det, 1, 2);
    STORE(scalar_single, &det_bound, 2, 2);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat3x3_determinant_single)
LOOP(mat3x3_determinant_single, 3, DENSE, 36, 4, 4, 12, 4)
LOOPS(mat3x3_determinant)

/* (3),(2)->(3,3),(3,3) */
OVER(mat3x3_setFromAxisDC_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t axis, &axis);
  EACH {
    double dc[2];
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    LOAD_OTHER(vec3_double, &axis);
    LOAD(dc_double, dc, 1, 1);
    ksl_mat3x3_setFromAxisDC_certified(&R, &axis, dc, &R_bound);
    STORE(mat3x3_double, &R, 2, 2);
    STORE(mat3x3_double, &R_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat3x3_setFromAxisDC_double)
LOOP(mat3x3_setFromAxisDC_double, 4, DENSE_OR_ONE, 24, 16, 72, 72, 8, 8, 24, 8, 24, 8)

OVER(mat3x3_setFromAxisDC_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t axis, &axis);
  EACH {
    float dc[2];
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    LOAD_OTHER(vec3_single, &axis);
    LOAD(dc_single, dc, 1, 1);
    ksl_mat3x3f_setFromAxisDC_certified(&R, &axis, dc, &R_bound);
    STORE(mat3x3_single, &R, 2, 2);
    STORE(mat3x3_single, &R_bound, 3, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat3x3_setFromAxisDC_single)
LOOP(mat3x3_setFromAxisDC_single, 4, DENSE_OR_ONE, 12, 8, 36, 36, 4, 4, 12, 4, 12, 4)
LOOPS(mat3x3_setFromAxisDC)

/* (3)->(3,3),(3,3) */
OVER(mat3x3_from_euler_xyz_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t angles;
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    LOAD(vec3_double, &angles, 0, 0);
    ksl_mat3x3_from_euler_xyz_certified(&angles, &R, &R_bound);
    STORE(mat3x3_double, &R, 1, 1);
    STORE(mat3x3_double, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(mat3x3_from_euler_xyz_double)
LOOP(mat3x3_from_euler_xyz_double, 3, ANY, 24, 72, 72, 8, 24, 8, 24, 8)

OVER(mat3x3_from_euler_xyz_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t angles;
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    LOAD(vec3_single, &angles, 0, 0);
    ksl_mat3x3f_from_euler_xyz_certified(&angles, &R, &R_bound);
    STORE(mat3x3_single, &R, 1, 1);
    STORE(mat3x3_single, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(mat3x3_from_euler_xyz_single)
LOOP(mat3x3_from_euler_xyz_single, 3, ANY, 12, 36, 36, 4, 12, 4, 12, 4)
LOOPS(mat3x3_from_euler_xyz)

/* (3,3)->(3),(3) */
OVER(euler_xyz_from_mat3x3_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t R;
    ksl_vec3_t angles;
    ksl_vec3_t angles_bound;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_euler_xyz_from_mat3x3_certified(&R, &angles, &angles_bound);
    STORE(vec3_double, &angles, 1, 2);
    STORE(vec3_double, &angles_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(euler_xyz_from_mat3x3_double)
LOOP(euler_xyz_from_mat3x3_double, 3, ANY, 72, 24, 24, 24, 8, 8, 8)

OVER(euler_xyz_from_mat3x3_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t R;
    ksl_vec3f_t angles;
    ksl_vec3f_t angles_bound;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_euler_xyz_from_mat3x3f_certified(&R, &angles, &angles_bound);
    STORE(vec3_single, &angles, 1, 2);
    STORE(vec3_single, &angles_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(euler_xyz_from_mat3x3_single)
LOOP(euler_xyz_from_mat3x3_single, 3, ANY, 36, 12, 12, 12, 4, 4, 4)
LOOPS(euler_xyz_from_mat3x3)

/* (3)->(3,3),(3,3) */
OVER(mat3x3_from_euler_xyx_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t angles;
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    LOAD(vec3_double, &angles, 0, 0);
    ksl_mat3x3_from_euler_xyx_certified(&angles, &R, &R_bound);
    STORE(mat3x3_double, &R, 1, 1);
    STORE(mat3x3_double, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(mat3x3_from_euler_xyx_double)
LOOP(mat3x3_from_euler_xyx_double, 3, ANY, 24, 72, 72, 8, 24, 8, 24, 8)

OVER(mat3x3_from_euler_xyx_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t angles;
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    LOAD(vec3_single, &angles, 0, 0);
    ksl_mat3x3f_from_euler_xyx_certified(&angles, &R, &R_bound);
    STORE(mat3x3_single, &R, 1, 1);
    STORE(mat3x3_single, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(mat3x3_from_euler_xyx_single)
LOOP(mat3x3_from_euler_xyx_single, 3, ANY, 12, 36, 36, 4, 12, 4, 12, 4)
LOOPS(mat3x3_from_euler_xyx)

/* (3,3)->(3),(3) */
OVER(euler_xyx_from_mat3x3_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t R;
    ksl_vec3_t angles;
    ksl_vec3_t angles_bound;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_euler_xyx_from_mat3x3_certified(&R, &angles, &angles_bound);
    STORE(vec3_double, &angles, 1, 2);
    STORE(vec3_double, &angles_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(euler_xyx_from_mat3x3_double)
LOOP(euler_xyx_from_mat3x3_double, 3, ANY, 72, 24, 24, 24, 8, 8, 8)

OVER(euler_xyx_from_mat3x3_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t R;
    ksl_vec3f_t angles;
    ksl_vec3f_t angles_bound;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_euler_xyx_from_mat3x3f_certified(&R, &angles, &angles_bound);
    STORE(vec3_single, &angles, 1, 2);
    STORE(vec3_single, &angles_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(euler_xyx_from_mat3x3_single)
LOOP(euler_xyx_from_mat3x3_single, 3, ANY, 36, 12, 12, 12, 4, 4, 4)
LOOPS(euler_xyx_from_mat3x3)

/* (3),()->(3,3),(3,3) */
OVER(mat3x3_from_axis_angle_double) {
  POINTERS_4
  LOAD_FIRST(vec3_double, ksl_vec3_t axis, &axis);
  EACH {
    double angle;
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    LOAD_OTHER(vec3_double, &axis);
    LOAD(scalar_double, &angle, 1, 1);
    ksl_mat3x3_from_axis_angle_certified(&axis, angle, &R, &R_bound);
    STORE(mat3x3_double, &R, 2, 1);
    STORE(mat3x3_double, &R_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(mat3x3_from_axis_angle_double)
LOOP(mat3x3_from_axis_angle_double, 4, DENSE_OR_ONE, 24, 8, 72, 72, 8, 24, 8, 24, 8)

OVER(mat3x3_from_axis_angle_single) {
  POINTERS_4
  LOAD_FIRST(vec3_single, ksl_vec3f_t axis, &axis);
  EACH {
    float angle;
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    LOAD_OTHER(vec3_single, &axis);
    LOAD(scalar_single, &angle, 1, 1);
    ksl_mat3x3f_from_axis_angle_certified(&axis, angle, &R, &R_bound);
    STORE(mat3x3_single, &R, 2, 1);
    STORE(mat3x3_single, &R_bound, 3, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(mat3x3_from_axis_angle_single)
LOOP(mat3x3_from_axis_angle_single, 4, DENSE_OR_ONE, 12, 4, 36, 36, 4, 12, 4, 12, 4)
LOOPS(mat3x3_from_axis_angle)

/* (3,3)->(),(3),(),(3) */
OVER(axis_angle_from_mat3x3_double) {
  POINTERS_5
  EACH {
    ksl_mat3x3_t R;
    double angle;
    ksl_vec3_t axis;
    double angle_bound;
    ksl_vec3_t axis_bound;
    LOAD(mat3x3_double, &R, 0, 0);
    angle = ksl_axis_angle_from_mat3x3_certified(&R, &axis, &angle_bound, &axis_bound);
    STORE(scalar_double, &angle, 1, 2);
    STORE(vec3_double, &axis, 2, 2);
    STORE(scalar_double, &angle_bound, 3, 3);
    STORE(vec3_double, &axis_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(axis_angle_from_mat3x3_double)
LOOP(axis_angle_from_mat3x3_double, 5, ANY, 72, 8, 24, 8, 24, 24, 8, 8, 8)

OVER(axis_angle_from_mat3x3_single) {
  POINTERS_5
  EACH {
    ksl_mat3x3f_t R;
    float angle;
    ksl_vec3f_t axis;
    float angle_bound;
    ksl_vec3f_t axis_bound;
    LOAD(mat3x3_single, &R, 0, 0);
    angle = ksl_axis_angle_from_mat3x3f_certified(&R, &axis, &angle_bound, &axis_bound);
    STORE(scalar_single, &angle, 1, 2);
    STORE(vec3_single, &axis, 2, 2);
    STORE(scalar_single, &angle_bound, 3, 3);
    STORE(vec3_single, &axis_bound, 4, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(axis_angle_from_mat3x3_single)
LOOP(axis_angle_from_mat3x3_single, 5, ANY, 36, 4, 12, 4, 12, 12, 4, 4, 4)
LOOPS(axis_angle_from_mat3x3)

const coscrew_gufunc TABLE(mat3x3)[] = {
  {"acceleration_tensor", "(3),(3)->(3,3),(3,3)",
    "Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the\n"
    "acceleration of its point x, less that of its origin, is Ro x; |error of Ro| <= Ro_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(3),(3)->(3,3),(3,3).  w, dw: vector; Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "15 mul, 27 add, 3 neg, 9 abs.\n",
   2, 2, "", acceleration_tensor_loops},
  {"mat3x3_determinant", "(3,3)->(),()",
    "det R; |error of det| <= det_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(),().  R: rotation or other 3×3 matrix; det, det_bound: number.\n"
    "13 mul, 14 add, 9 abs.\n",
   1, 2, "", mat3x3_determinant_loops},
  {"mat3x3_setFromAxisDC", "(3),(2)->(3,3),(3,3)",
    "R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),\n"
    "dc = (sin θ, cos θ); |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3),(2)->(3,3),(3,3).  axis: vector; dc: (sin θ, cos θ); R, R_bound: rotation or other 3×3\n"
    "matrix.\n"
    "30 mul, 31 add, 8 abs.\n",
   2, 2, "", mat3x3_setFromAxisDC_loops},
  {"mat3x3_from_euler_xyz", "(3)->(3,3),(3,3)",
    "R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "291 mul, 434 add, 39 product error, 8 product rest, 3 div, 9 neg, 18 abs, 3 less, 3 select.\n",
   1, 2, "", mat3x3_from_euler_xyz_loops},
  {"euler_xyz_from_mat3x3", "(3,3)->(3),(3)",
    "angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in\n"
    "[-π/2, π/2]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.\n"
    "455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 4 neg, 72 abs, 12\n"
    "copysign, 59 less, 14 equal, 108 select.\n",
   1, 2, "R", euler_xyz_from_mat3x3_loops},
  {"mat3x3_from_euler_xyx", "(3)->(3,3),(3,3)",
    "R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "291 mul, 434 add, 39 product error, 8 product rest, 3 div, 5 neg, 18 abs, 3 less, 3 select.\n",
   1, 2, "", mat3x3_from_euler_xyx_loops},
  {"euler_xyx_from_mat3x3", "(3,3)->(3),(3)",
    "angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in\n"
    "[0, π]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.\n"
    "455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 3 neg, 72 abs, 12\n"
    "copysign, 61 less, 14 equal, 110 select.\n",
   1, 2, "R", euler_xyx_from_mat3x3_loops},
  {"mat3x3_from_axis_angle", "(3),()->(3,3),(3,3)",
    "R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is\n"
    "not a rotation; |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3),()->(3,3),(3,3).  axis: vector; angle: number; R, R_bound: rotation or other 3×3 matrix.\n"
    "216 mul, 380 add, 26 product error, 18 product rest, 2 div, 24 abs, 4 less, 6 select.\n",
   2, 2, "", mat3x3_from_axis_angle_loops},
  {"axis_angle_from_mat3x3", "(3,3)->(),(3),(),(3)",
    "angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0;\n"
    "|error of angle| <= angle_bound, |error of axis| <= axis_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(),(3),(),(3).  R: rotation or other 3×3 matrix; angle, angle_bound: number; axis,\n"
    "axis_bound: vector.\n"
    "233 mul, 467 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 10 neg, 70 abs, 4\n"
    "copysign, 41 less, 7 equal, 111 select.\n",
   1, 4, "R", axis_angle_from_mat3x3_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
