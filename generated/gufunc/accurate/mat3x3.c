/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the mat3x3 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/mat3x3_accurate.h"

/* (3),(3)->(3,3) */
OVER(acceleration_tensor_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t w, &w);
  EACH {
    ksl_vec3_t dw;
    ksl_mat3x3_t Ro;
    LOAD_OTHER(vec3_double, &w);
    LOAD(vec3_double, &dw, 1, 1);
    ksl_acceleration_tensor_accurate(&w, &dw, &Ro);
    STORE(mat3x3_double, &Ro, 2, 2);
  }
}
STRIDED_WITH_FMA(acceleration_tensor_double)
LOOP(acceleration_tensor_double, 3, DENSE_OR_ONE, 24, 24, 72, 8, 8, 24, 8)

OVER(acceleration_tensor_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t w, &w);
  EACH {
    ksl_vec3f_t dw;
    ksl_mat3x3f_t Ro;
    LOAD_OTHER(vec3_single, &w);
    LOAD(vec3_single, &dw, 1, 1);
    ksl_acceleration_tensorf_accurate(&w, &dw, &Ro);
    STORE(mat3x3_single, &Ro, 2, 2);
  }
}
STRIDED(acceleration_tensor_single)
LOOP(acceleration_tensor_single, 3, DENSE_OR_ONE, 12, 12, 36, 4, 4, 12, 4)
LOOPS(acceleration_tensor)

/* (3,3)->() */
OVER(mat3x3_determinant_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    double det;
    LOAD(mat3x3_double, &R, 0, 0);
    det = ksl_mat3x3_determinant_accurate(&R);
    STORE(scalar_double, &det, 1, 2);
  }
}
STRIDED_WITH_FMA(mat3x3_determinant_double)
LOOP(mat3x3_determinant_double, 2, DENSE, 72, 8, 24, 8)

OVER(mat3x3_determinant_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    float det;
    LOAD(mat3x3_single, &R, 0, 0);
    det = ksl_mat3x3f_determinant_accurate(&R);
    STORE(scalar_single, &det, 1, 2);
  }
}
STRIDED(mat3x3_determinant_single)
LOOP(mat3x3_determinant_single, 2, DENSE, 36, 4, 12, 4)
LOOPS(mat3x3_determinant)

/* (3,3)->(),(3,3) */
OVER(mat3x3_inverse_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t R;
    double det;
    ksl_mat3x3_t Ro;
    LOAD(mat3x3_double, &R, 0, 0);
    det = ksl_mat3x3_inverse_accurate(&R, &Ro);
    STORE(scalar_double, &det, 1, 2);
    STORE(mat3x3_double, &Ro, 2, 2);
  }
}
STRIDED_WITH_FMA(mat3x3_inverse_double)
LOOP(mat3x3_inverse_double, 3, ANY, 72, 8, 72, 24, 8, 24, 8)

OVER(mat3x3_inverse_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t R;
    float det;
    ksl_mat3x3f_t Ro;
    LOAD(mat3x3_single, &R, 0, 0);
    det = ksl_mat3x3f_inverse_accurate(&R, &Ro);
    STORE(scalar_single, &det, 1, 2);
    STORE(mat3x3_single, &Ro, 2, 2);
  }
}
STRIDED(mat3x3_inverse_single)
LOOP(mat3x3_inverse_single, 3, DENSE, 36, 4, 36, 12, 4, 12, 4)
LOOPS(mat3x3_inverse)

/* (3,3)->(3,3) */
OVER(mat3x3_normalize_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t self;
    LOAD(mat3x3_double, &self, 0, 0);
    ksl_mat3x3_normalize_accurate(&self);
    STORE(mat3x3_double, &self, 1, 2);
  }
}
STRIDED_WITH_FMA(mat3x3_normalize_double)
LOOP(mat3x3_normalize_double, 2, ANY, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_normalize_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t self;
    LOAD(mat3x3_single, &self, 0, 0);
    ksl_mat3x3f_normalize_accurate(&self);
    STORE(mat3x3_single, &self, 1, 2);
  }
}
STRIDED(mat3x3_normalize_single)
LOOP(mat3x3_normalize_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_normalize)

/* (3,3)->(3,3) */
OVER(mat3x3_normalized_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_mat3x3_t Ro;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_mat3x3_normalized_accurate(&R, &Ro);
    STORE(mat3x3_double, &Ro, 1, 2);
  }
}
STRIDED_WITH_FMA(mat3x3_normalized_double)
LOOP(mat3x3_normalized_double, 2, ANY, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_normalized_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t Ro;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_mat3x3f_normalized_accurate(&R, &Ro);
    STORE(mat3x3_single, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_normalized_single)
LOOP(mat3x3_normalized_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_normalized)

/* (3),(2)->(3,3) */
OVER(mat3x3_setFromAxisDC_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t axis, &axis);
  EACH {
    double dc[2];
    ksl_mat3x3_t R;
    LOAD_OTHER(vec3_double, &axis);
    LOAD(dc_double, dc, 1, 1);
    ksl_mat3x3_setFromAxisDC_accurate(&R, &axis, dc);
    STORE(mat3x3_double, &R, 2, 2);
  }
}
STRIDED_WITH_FMA(mat3x3_setFromAxisDC_double)
LOOP(mat3x3_setFromAxisDC_double, 3, DENSE_OR_ONE, 24, 16, 72, 8, 8, 24, 8)

OVER(mat3x3_setFromAxisDC_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t axis, &axis);
  EACH {
    float dc[2];
    ksl_mat3x3f_t R;
    LOAD_OTHER(vec3_single, &axis);
    LOAD(dc_single, dc, 1, 1);
    ksl_mat3x3f_setFromAxisDC_accurate(&R, &axis, dc);
    STORE(mat3x3_single, &R, 2, 2);
  }
}
STRIDED(mat3x3_setFromAxisDC_single)
LOOP(mat3x3_setFromAxisDC_single, 3, DENSE_OR_ONE, 12, 8, 36, 4, 4, 12, 4)
LOOPS(mat3x3_setFromAxisDC)

/* (3)->(3,3) */
OVER(mat3x3_from_euler_xyz_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t angles;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &angles, 0, 0);
    ksl_mat3x3_from_euler_xyz_accurate(&angles, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED_WITH_FMA(mat3x3_from_euler_xyz_double)
LOOP(mat3x3_from_euler_xyz_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(mat3x3_from_euler_xyz_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t angles;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &angles, 0, 0);
    ksl_mat3x3f_from_euler_xyz_accurate(&angles, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(mat3x3_from_euler_xyz_single)
LOOP(mat3x3_from_euler_xyz_single, 2, ANY, 12, 36, 4, 12, 4)
LOOPS(mat3x3_from_euler_xyz)

/* (3,3)->(3) */
OVER(euler_xyz_from_mat3x3_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_vec3_t angles;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_euler_xyz_from_mat3x3_accurate(&R, &angles);
    STORE(vec3_double, &angles, 1, 2);
  }
}
STRIDED_WITH_FMA(euler_xyz_from_mat3x3_double)
LOOP(euler_xyz_from_mat3x3_double, 2, ANY, 72, 24, 24, 8, 8)

OVER(euler_xyz_from_mat3x3_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_vec3f_t angles;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_euler_xyz_from_mat3x3f_accurate(&R, &angles);
    STORE(vec3_single, &angles, 1, 2);
  }
}
STRIDED(euler_xyz_from_mat3x3_single)
LOOP(euler_xyz_from_mat3x3_single, 2, ANY, 36, 12, 12, 4, 4)
LOOPS(euler_xyz_from_mat3x3)

/* (3)->(3,3) */
OVER(mat3x3_from_euler_xyx_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t angles;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &angles, 0, 0);
    ksl_mat3x3_from_euler_xyx_accurate(&angles, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED_WITH_FMA(mat3x3_from_euler_xyx_double)
LOOP(mat3x3_from_euler_xyx_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(mat3x3_from_euler_xyx_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t angles;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &angles, 0, 0);
    ksl_mat3x3f_from_euler_xyx_accurate(&angles, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(mat3x3_from_euler_xyx_single)
LOOP(mat3x3_from_euler_xyx_single, 2, ANY, 12, 36, 4, 12, 4)
LOOPS(mat3x3_from_euler_xyx)

/* (3,3)->(3) */
OVER(euler_xyx_from_mat3x3_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_vec3_t angles;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_euler_xyx_from_mat3x3_accurate(&R, &angles);
    STORE(vec3_double, &angles, 1, 2);
  }
}
STRIDED_WITH_FMA(euler_xyx_from_mat3x3_double)
LOOP(euler_xyx_from_mat3x3_double, 2, ANY, 72, 24, 24, 8, 8)

OVER(euler_xyx_from_mat3x3_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_vec3f_t angles;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_euler_xyx_from_mat3x3f_accurate(&R, &angles);
    STORE(vec3_single, &angles, 1, 2);
  }
}
STRIDED(euler_xyx_from_mat3x3_single)
LOOP(euler_xyx_from_mat3x3_single, 2, ANY, 36, 12, 12, 4, 4)
LOOPS(euler_xyx_from_mat3x3)

/* (3,3),(3,3)->(3,3),(3,3) */
OVER(mat3x3_jacobi_double) {
  POINTERS_4
  EACH {
    ksl_mat3x3_t A;
    ksl_mat3x3_t V;
    LOAD(mat3x3_double, &A, 0, 0);
    LOAD(mat3x3_double, &V, 1, 2);
    ksl_mat3x3_jacobi_accurate(&A, &V);
    STORE(mat3x3_double, &A, 2, 4);
    STORE(mat3x3_double, &V, 3, 6);
  }
}
STRIDED_WITH_FMA(mat3x3_jacobi_double)
LOOP(mat3x3_jacobi_double, 4, ANY, 72, 72, 72, 72, 24, 8, 24, 8, 24, 8, 24, 8)

OVER(mat3x3_jacobi_single) {
  POINTERS_4
  EACH {
    ksl_mat3x3f_t A;
    ksl_mat3x3f_t V;
    LOAD(mat3x3_single, &A, 0, 0);
    LOAD(mat3x3_single, &V, 1, 2);
    ksl_mat3x3f_jacobi_accurate(&A, &V);
    STORE(mat3x3_single, &A, 2, 4);
    STORE(mat3x3_single, &V, 3, 6);
  }
}
STRIDED(mat3x3_jacobi_single)
LOOP(mat3x3_jacobi_single, 4, DENSE, 36, 36, 36, 36, 12, 4, 12, 4, 12, 4, 12, 4)
LOOPS(mat3x3_jacobi)

/* (3,3)->() */
OVER(mat3x3_rotation_defect_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    double defect;
    LOAD(mat3x3_double, &R, 0, 0);
    defect = ksl_mat3x3_rotation_defect_accurate(&R);
    STORE(scalar_double, &defect, 1, 2);
  }
}
STRIDED_WITH_FMA(mat3x3_rotation_defect_double)
LOOP(mat3x3_rotation_defect_double, 2, ANY, 72, 8, 24, 8)

OVER(mat3x3_rotation_defect_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    float defect;
    LOAD(mat3x3_single, &R, 0, 0);
    defect = ksl_mat3x3f_rotation_defect_accurate(&R);
    STORE(scalar_single, &defect, 1, 2);
  }
}
STRIDED(mat3x3_rotation_defect_single)
LOOP(mat3x3_rotation_defect_single, 2, DENSE, 36, 4, 12, 4)
LOOPS(mat3x3_rotation_defect)

/* (3),()->(3,3) */
OVER(mat3x3_from_axis_angle_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t axis, &axis);
  EACH {
    double angle;
    ksl_mat3x3_t R;
    LOAD_OTHER(vec3_double, &axis);
    LOAD(scalar_double, &angle, 1, 1);
    ksl_mat3x3_from_axis_angle_accurate(&axis, angle, &R);
    STORE(mat3x3_double, &R, 2, 1);
  }
}
STRIDED_WITH_FMA(mat3x3_from_axis_angle_double)
LOOP(mat3x3_from_axis_angle_double, 3, DENSE_OR_ONE, 24, 8, 72, 8, 24, 8)

OVER(mat3x3_from_axis_angle_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t axis, &axis);
  EACH {
    float angle;
    ksl_mat3x3f_t R;
    LOAD_OTHER(vec3_single, &axis);
    LOAD(scalar_single, &angle, 1, 1);
    ksl_mat3x3f_from_axis_angle_accurate(&axis, angle, &R);
    STORE(mat3x3_single, &R, 2, 1);
  }
}
STRIDED(mat3x3_from_axis_angle_single)
LOOP(mat3x3_from_axis_angle_single, 3, DENSE_OR_ONE, 12, 4, 36, 4, 12, 4)
LOOPS(mat3x3_from_axis_angle)

/* (3,3)->(),(3) */
OVER(axis_angle_from_mat3x3_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t R;
    double angle;
    ksl_vec3_t axis;
    LOAD(mat3x3_double, &R, 0, 0);
    angle = ksl_axis_angle_from_mat3x3_accurate(&R, &axis);
    STORE(scalar_double, &angle, 1, 2);
    STORE(vec3_double, &axis, 2, 2);
  }
}
STRIDED_WITH_FMA(axis_angle_from_mat3x3_double)
LOOP(axis_angle_from_mat3x3_double, 3, ANY, 72, 8, 24, 24, 8, 8)

OVER(axis_angle_from_mat3x3_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t R;
    float angle;
    ksl_vec3f_t axis;
    LOAD(mat3x3_single, &R, 0, 0);
    angle = ksl_axis_angle_from_mat3x3f_accurate(&R, &axis);
    STORE(scalar_single, &angle, 1, 2);
    STORE(vec3_single, &axis, 2, 2);
  }
}
STRIDED(axis_angle_from_mat3x3_single)
LOOP(axis_angle_from_mat3x3_single, 3, DENSE, 36, 4, 12, 12, 4, 4)
LOOPS(axis_angle_from_mat3x3)

const coscrew_gufunc TABLE(mat3x3)[] = {
  {"acceleration_tensor", "(3),(3)->(3,3)",
    "Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the\n"
    "acceleration of its point x, less that of its origin, is Ro x.\n"
    "\n"
    "(3),(3)->(3,3).  w, dw: vector; Ro: rotation or other 3×3 matrix.\n"
    "6 mul, 51 add, 12 product rest, 6 neg.  Error <= u |result| + 6 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", acceleration_tensor_loops},
  {"mat3x3_determinant", "(3,3)->()",
    "det R.\n"
    "\n"
    "(3,3)->().  R: rotation or other 3×3 matrix; det: number.\n"
    "12 mul, 26 add, 9 product rest.  Error <= u |result| + 28 u^2 S, S the sum of the |terms| of\n"
    "the expanded formula; barring over- and underflow.\n",
   1, 1, "", mat3x3_determinant_loops},
  {"mat3x3_inverse", "(3,3)->(),(3,3)",
    "Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or\n"
    "overflows.  Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3\n"
    "(double 1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.\n"
    "\n"
    "(3,3)->(),(3,3).  R, Ro: rotation or other 3×3 matrix; det: number.\n"
    "106 mul, 290 add, 10 product error, 32 product rest, 22 div, 2 neg, 19 abs, 17 less, 11\n"
    "equal, 55 select.  Error of Ro_ij <= 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the\n"
    "sum of the |terms| of the cofactor, or 2^-80 m^2 (double 2^-700 m^2) if that is more;\n"
    "barring over- and underflow of Ro_ij itself.\n",
   1, 2, "", mat3x3_inverse_loops},
  {"mat3x3_normalize", "(3,3)->(3,3)",
    "self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on\n"
    "its side of the first, the third on its side of both; NaN where the rows are linearly\n"
    "dependent to rounding.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "154 mul, 405 add, 16 product error, 33 product rest, 31 div, 4 sqrt, 7 neg, 10 abs, 25 less,\n"
    "18 equal, 70 select.  |R R^T - I|_ij <= 8 u for the result R; searched, not proved.\n",
   1, 1, "", mat3x3_normalize_loops},
  {"mat3x3_normalized", "(3,3)->(3,3)",
    "Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on\n"
    "its side of the first, the third on its side of both; NaN where the rows are linearly\n"
    "dependent to rounding.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "154 mul, 405 add, 16 product error, 33 product rest, 31 div, 4 sqrt, 7 neg, 10 abs, 25 less,\n"
    "18 equal, 70 select.  |R R^T - I|_ij <= 8 u for the result R; searched, not proved.\n",
   1, 1, "", mat3x3_normalized_loops},
  {"mat3x3_setFromAxisDC", "(3),(2)->(3,3)",
    "R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),\n"
    "dc = (sin θ, cos θ).\n"
    "\n"
    "(3),(2)->(3,3).  axis: vector; dc: (sin θ, cos θ); R: rotation or other 3×3 matrix.\n"
    "21 mul, 66 add, 3 product error, 15 product rest.  Error <= u |result| + 14 u^2 S, S the sum\n"
    "of the |terms| of the expanded formula; barring over- and underflow.\n",
   2, 1, "", mat3x3_setFromAxisDC_loops},
  {"mat3x3_from_euler_xyz", "(3)->(3,3)",
    "R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).\n"
    "\n"
    "(3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.\n"
    "291 mul, 434 add, 39 product error, 8 product rest, 3 div, 9 neg, 9 abs, 3 less, 9 equal, 12\n"
    "select.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", mat3x3_from_euler_xyz_loops},
  {"euler_xyz_from_mat3x3", "(3,3)->(3)",
    "angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in\n"
    "[-π/2, π/2]; c = 0 in gimbal lock.\n"
    "\n"
    "(3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.\n"
    "391 mul, 713 add, 66 product error, 6 product rest, 17 div, 1 sqrt, 4 neg, 28 abs, 12\n"
    "copysign, 42 less, 16 equal, 87 select.  Each component is within 1 ulp as long as its\n"
    "condition is below 1e13; in single precision it is the nearest number, except near ties, as\n"
    "long as that is below 1e5; searched, not proved.\n",
   1, 1, "R", euler_xyz_from_mat3x3_loops},
  {"mat3x3_from_euler_xyx", "(3)->(3,3)",
    "R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).\n"
    "\n"
    "(3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.\n"
    "291 mul, 434 add, 39 product error, 8 product rest, 3 div, 5 neg, 9 abs, 3 less, 9 equal, 12\n"
    "select.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", mat3x3_from_euler_xyx_loops},
  {"euler_xyx_from_mat3x3", "(3,3)->(3)",
    "angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in\n"
    "[0, π]; c = 0 in gimbal lock.\n"
    "\n"
    "(3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.\n"
    "391 mul, 713 add, 66 product error, 6 product rest, 17 div, 1 sqrt, 3 neg, 28 abs, 12\n"
    "copysign, 42 less, 16 equal, 87 select.  Each component is within 1 ulp as long as its\n"
    "condition is below 1e13; in single precision it is the nearest number, except near ties, as\n"
    "long as that is below 1e5; searched, not proved.\n",
   1, 1, "R", euler_xyx_from_mat3x3_loops},
  {"mat3x3_jacobi", "(3,3),(3,3)->(3,3),(3,3)",
    "A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes\n"
    "A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.\n"
    "Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.\n"
    "\n"
    "(3,3),(3,3)->(3,3),(3,3).  A, V: rotation or other 3×3 matrix.\n"
    "51 mul, 153 add, 6 product error, 20 product rest, 8 div, 2 sqrt, 3 neg, 1 abs, 2 less, 13\n"
    "equal, 18 select.  V A V^T changes by at most 28 u max |A| for orthonormal V; searched, not\n"
    "proved.\n",
   2, 2, ".R", mat3x3_jacobi_loops},
  {"mat3x3_rotation_defect", "(3,3)->()",
    "the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if\n"
    "an entry is NaN.\n"
    "\n"
    "(3,3)->().  R: rotation or other 3×3 matrix; defect: number.\n"
    "30 mul, 228 add, 27 product rest, 7 neg, 7 abs, 13 less, 19 select.  Error <= 6 u near a\n"
    "rotation; measured, not proved.\n",
   1, 1, "", mat3x3_rotation_defect_loops},
  {"mat3x3_from_axis_angle", "(3),()->(3,3)",
    "R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is\n"
    "not a rotation.\n"
    "\n"
    "(3),()->(3,3).  axis: vector; angle: number; R: rotation or other 3×3 matrix.\n"
    "196 mul, 351 add, 26 product error, 18 product rest, 2 div, 6 abs, 3 less, 9 equal, 13\n"
    "select.  Error <= R: 1 u of its largest component for |axis| = 1; searched, not proved.\n"
    "Each component is within 1 ulp as long as its condition is below 1e13; in single precision\n"
    "it is the nearest number, except near ties, as long as that is below 1e5; searched, not\n"
    "proved.\n",
   2, 1, "", mat3x3_from_axis_angle_loops},
  {"axis_angle_from_mat3x3", "(3,3)->(),(3)",
    "angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.\n"
    "\n"
    "(3,3)->(),(3).  R: rotation or other 3×3 matrix; angle: number; axis: vector.\n"
    "157 mul, 448 add, 25 product error, 3 product rest, 14 div, 1 sqrt, 13 neg, 13 abs, 4\n"
    "copysign, 29 less, 10 equal, 80 select.  Error <= angle: 1 u, axis: 1 u of its largest\n"
    "component for R a rotation; searched, not proved.  Each component is within 1 ulp as long as\n"
    "its condition is below 1e13; in single precision it is the nearest number, except near ties,\n"
    "as long as that is below 1e5; searched, not proved.\n",
   1, 2, "R", axis_angle_from_mat3x3_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
