/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Symmetric positive definite 3×3 and 6×6 matrices: A = L D L^T, solutions of A x = b. */
#ifndef KSL_SYMMETRIC_H
#define KSL_SYMMETRIC_H

#include "ksl_types.h"
#include "mat6x6.h"
#include "screw.h"
#include "coscrew.h"

/* L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
     triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
     not positive definite, and L is meaningless.
   A, L: rotation or other 3×3 matrix.
   4 mul, 4 add, 6 div, 6 less, 9 select.
   |L D L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline double ksl_mat3x3_ldl(const ksl_mat3x3_t *A, ksl_mat3x3_t *L) {
  const double divisor0 = 0.0 < A->m00 ? A->m00 : 1.0;
  const double l0_0 = A->m10 / divisor0, l0_1 = A->m20 / divisor0;
  const double u1_0 = A->m11 - KSL_MUL(A->m10, l0_0), u1_1 = A->m21 - KSL_MUL(A->m20, l0_0);
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1 = u1_1 / divisor1;
  const double u2 = A->m22 - KSL_MUL(A->m20, l0_1) - KSL_MUL(u1_1, l1);
  const double part0a = A->m00 / divisor0, part0 = 0.0 < A->m00 ? part0a : A->m00;
  const double own1 = 0.0 < A->m11 ? A->m11 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < A->m11 ? part1a : A->m11;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < A->m22 ? A->m22 : 1.0;
  const double part2a = u2 / own2, part2 = 0.0 < A->m22 ? part2a : A->m22;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  L->m00 = A->m00;
  L->m01 = 0.0;
  L->m02 = 0.0;
  L->m10 = l0_0;
  L->m11 = u1_0;
  L->m12 = 0.0;
  L->m20 = l0_1;
  L->m21 = l1;
  L->m22 = u2;
  return smallest2;
}

/* x = A^-1 b, L of mat3x3_ldl with a positive pivot.
   L: rotation or other 3×3 matrix; b, x: vector.
   6 mul, 6 add, 3 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat3x3_ldl_solve(const ksl_mat3x3_t *L, const ksl_vec3_t *b, ksl_vec3_t *x) {
  const double y1 = b->y - KSL_MUL(L->m10, b->x);
  const double y2 = b->z - KSL_MUL(L->m20, b->x) - KSL_MUL(L->m21, y1);
  const double z0 = b->x / L->m00;
  const double z1 = y1 / L->m11;
  const double z2 = y2 / L->m22;
  const double x1 = z1 - KSL_MUL(L->m21, z2);
  const double x0 = z0 - KSL_MUL(L->m10, x1) - KSL_MUL(L->m20, z2);
  x->x = x0;
  x->y = x1;
  x->z = z2;
}

/* x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
     Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
     rounding or indefinite (A - 50 u diag A is not positive definite).
   A: rotation or other 3×3 matrix; b, x: vector.
   32 mul, 32 add, 15 div, 11 less, 1 equal, 20 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline double ksl_mat3x3_solve(const ksl_mat3x3_t *A, const ksl_vec3_t *b, ksl_vec3_t *x) {
  const double divisor0 = 0.0 < A->m00 ? A->m00 : 1.0;
  const double l0_0 = A->m10 / divisor0, l0_1 = A->m20 / divisor0;
  const double u1_0 = A->m11 - KSL_MUL(A->m10, l0_0), u1_1 = A->m21 - KSL_MUL(A->m20, l0_0);
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1 = u1_1 / divisor1;
  const double u2 = A->m22 - KSL_MUL(A->m20, l0_1) - KSL_MUL(u1_1, l1);
  const double divisor2 = 0.0 < u2 ? u2 : 1.0;
  const double part0a = A->m00 / divisor0, part0 = 0.0 < A->m00 ? part0a : A->m00;
  const double own1 = 0.0 < A->m11 ? A->m11 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < A->m11 ? part1a : A->m11;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < A->m22 ? A->m22 : 1.0;
  const double part2a = u2 / own2, part2 = 0.0 < A->m22 ? part2a : A->m22;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double less_0 = KSL_MUL(A->m00, 0.9999999999999944),
      less_1 = KSL_MUL(A->m11, 0.9999999999999944), less_2 = KSL_MUL(A->m22, 0.9999999999999944);
  const double less_divisor0 = 0.0 < less_0 ? less_0 : 1.0;
  const double less_l0_0 = A->m10 / less_divisor0, less_l0_1 = A->m20 / less_divisor0;
  const double less_u1_0 = less_1 - KSL_MUL(A->m10, less_l0_0),
      less_u1_1 = A->m21 - KSL_MUL(A->m20, less_l0_0);
  const double less_divisor1 = 0.0 < less_u1_0 ? less_u1_0 : 1.0;
  const double less_l1 = less_u1_1 / less_divisor1;
  const double less_u2 = less_2 - KSL_MUL(A->m20, less_l0_1) - KSL_MUL(less_u1_1, less_l1);
  const double regular_b = 0.0 < less_u2 ? 1.0 : 0.0, regular_c = 0.0 < less_u1_0 ? regular_b : 0.0,
      regular = 0.0 < less_0 ? regular_c : 0.0;
  const double least = smallest2 < 0.0 ? smallest2 : 0.0;
  const double y1 = b->y - KSL_MUL(b->x, l0_0);
  const double y2 = b->z - KSL_MUL(b->x, l0_1) - KSL_MUL(l1, y1);
  const double z0 = b->x / divisor0;
  const double z1 = y1 / divisor1;
  const double z2 = y2 / divisor2;
  const double x1 = z1 - KSL_MUL(l1, z2);
  const double x0 = z0 - KSL_MUL(l0_0, x1) - KSL_MUL(l0_1, z2);
  const double residual_0 = b->x - KSL_MUL(A->m00, x0) - KSL_MUL(A->m10, x1) - KSL_MUL(A->m20, z2),
      residual_1 = b->y - KSL_MUL(A->m10, x0) - KSL_MUL(A->m11, x1) - KSL_MUL(A->m21, z2),
      residual_2 = b->z - KSL_MUL(A->m20, x0) - KSL_MUL(A->m21, x1) - KSL_MUL(A->m22, z2);
  const double refined_y1 = residual_1 - KSL_MUL(l0_0, residual_0);
  const double refined_y2 = residual_2 - KSL_MUL(l0_1, residual_0) - KSL_MUL(l1, refined_y1);
  const double refined_z0 = residual_0 / divisor0;
  const double refined_z1 = refined_y1 / divisor1;
  const double refined_z2 = refined_y2 / divisor2;
  const double refined_x1 = refined_z1 - KSL_MUL(l1, refined_z2);
  const double refined_x0 = refined_z0 - KSL_MUL(l0_0, refined_x1) - KSL_MUL(l0_1, refined_z2);
  const double found_0 = x0 + refined_x0, found_1 = x1 + refined_x1, found_2 = z2 + refined_z2;
  const double pivot = regular == 1.0 ? smallest2 : least;
  const double x_0 = regular == 1.0 ? found_0 : (double)NAN,
      x_1 = regular == 1.0 ? found_1 : (double)NAN, x_2 = regular == 1.0 ? found_2 : (double)NAN;
  x->x = x_0;
  x->y = x_1;
  x->z = x_2;
  return pivot;
}

/* L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
     triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
     not positive definite, and L is meaningless.
   A, L: 6×6 operator.
   35 mul, 35 add, 21 div, 15 less, 21 select.
   |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline double ksl_mat6x6_ldl(const ksl_mat6x6_t *A, ksl_mat6x6_t *L) {
  const double divisor0 = 0.0 < A->at[0][0] ? A->at[0][0] : 1.0;
  const double l0_0 = A->at[0][1] / divisor0, l0_1 = A->at[0][2] / divisor0,
      l0_2 = A->at[0][3] / divisor0, l0_3 = A->at[0][4] / divisor0, l0_4 = A->at[0][5] / divisor0;
  const double u1_0 = A->at[1][1] - KSL_MUL(A->at[0][1], l0_0),
      u1_1 = A->at[1][2] - KSL_MUL(A->at[0][2], l0_0),
      u1_2 = A->at[1][3] - KSL_MUL(A->at[0][3], l0_0),
      u1_3 = A->at[1][4] - KSL_MUL(A->at[0][4], l0_0),
      u1_4 = A->at[1][5] - KSL_MUL(A->at[0][5], l0_0);
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1, l1_1 = u1_2 / divisor1, l1_2 = u1_3 / divisor1,
      l1_3 = u1_4 / divisor1;
  const double u2_0 = A->at[2][2] - KSL_MUL(A->at[0][2], l0_1) - KSL_MUL(u1_1, l1_0),
      u2_1 = A->at[2][3] - KSL_MUL(A->at[0][3], l0_1) - KSL_MUL(u1_2, l1_0),
      u2_2 = A->at[2][4] - KSL_MUL(A->at[0][4], l0_1) - KSL_MUL(u1_3, l1_0),
      u2_3 = A->at[2][5] - KSL_MUL(A->at[0][5], l0_1) - KSL_MUL(u1_4, l1_0);
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2_0 = u2_1 / divisor2, l2_1 = u2_2 / divisor2, l2_2 = u2_3 / divisor2;
  const double u3_0 = A->at[3][3] - KSL_MUL(A->at[0][3], l0_2) - KSL_MUL(u1_2, l1_1)
          - KSL_MUL(u2_1, l2_0),
      u3_1 = A->at[3][4] - KSL_MUL(A->at[0][4], l0_2) - KSL_MUL(u1_3, l1_1) - KSL_MUL(u2_2, l2_0),
      u3_2 = A->at[3][5] - KSL_MUL(A->at[0][5], l0_2) - KSL_MUL(u1_4, l1_1) - KSL_MUL(u2_3, l2_0);
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0;
  const double l3_0 = u3_1 / divisor3, l3_1 = u3_2 / divisor3;
  const double u4_0 = A->at[4][4] - KSL_MUL(A->at[0][4], l0_3) - KSL_MUL(u1_3, l1_2)
          - KSL_MUL(u2_2, l2_1) - KSL_MUL(u3_1, l3_0),
      u4_1 = A->at[4][5] - KSL_MUL(A->at[0][5], l0_3) - KSL_MUL(u1_4, l1_2) - KSL_MUL(u2_3, l2_1)
          - KSL_MUL(u3_2, l3_0);
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0;
  const double l4 = u4_1 / divisor4;
  const double u5 = A->at[5][5] - KSL_MUL(A->at[0][5], l0_4) - KSL_MUL(u1_4, l1_3)
          - KSL_MUL(u2_3, l2_2) - KSL_MUL(u3_2, l3_1) - KSL_MUL(u4_1, l4);
  const double part0a = A->at[0][0] / divisor0, part0 = 0.0 < A->at[0][0] ? part0a : A->at[0][0];
  const double own1 = 0.0 < A->at[1][1] ? A->at[1][1] : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < A->at[1][1] ? part1a : A->at[1][1];
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < A->at[2][2] ? A->at[2][2] : 1.0;
  const double part2a = u2_0 / own2, part2 = 0.0 < A->at[2][2] ? part2a : A->at[2][2];
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double own3 = 0.0 < A->at[3][3] ? A->at[3][3] : 1.0;
  const double part3a = u3_0 / own3, part3 = 0.0 < A->at[3][3] ? part3a : A->at[3][3];
  const double smallest3 = smallest2 < part3 ? smallest2 : part3;
  const double own4 = 0.0 < A->at[4][4] ? A->at[4][4] : 1.0;
  const double part4a = u4_0 / own4, part4 = 0.0 < A->at[4][4] ? part4a : A->at[4][4];
  const double smallest4 = smallest3 < part4 ? smallest3 : part4;
  const double own5 = 0.0 < A->at[5][5] ? A->at[5][5] : 1.0;
  const double part5a = u5 / own5, part5 = 0.0 < A->at[5][5] ? part5a : A->at[5][5];
  const double smallest5 = smallest4 < part5 ? smallest4 : part5;
  L->at[0][0] = A->at[0][0];
  L->at[1][0] = 0.0;
  L->at[2][0] = 0.0;
  L->at[3][0] = 0.0;
  L->at[4][0] = 0.0;
  L->at[5][0] = 0.0;
  L->at[0][1] = l0_0;
  L->at[1][1] = u1_0;
  L->at[2][1] = 0.0;
  L->at[3][1] = 0.0;
  L->at[4][1] = 0.0;
  L->at[5][1] = 0.0;
  L->at[0][2] = l0_1;
  L->at[1][2] = l1_0;
  L->at[2][2] = u2_0;
  L->at[3][2] = 0.0;
  L->at[4][2] = 0.0;
  L->at[5][2] = 0.0;
  L->at[0][3] = l0_2;
  L->at[1][3] = l1_1;
  L->at[2][3] = l2_0;
  L->at[3][3] = u3_0;
  L->at[4][3] = 0.0;
  L->at[5][3] = 0.0;
  L->at[0][4] = l0_3;
  L->at[1][4] = l1_2;
  L->at[2][4] = l2_1;
  L->at[3][4] = l3_0;
  L->at[4][4] = u4_0;
  L->at[5][4] = 0.0;
  L->at[0][5] = l0_4;
  L->at[1][5] = l1_3;
  L->at[2][5] = l2_2;
  L->at[3][5] = l3_1;
  L->at[4][5] = l4;
  L->at[5][5] = u5;
  return smallest5;
}

/* x = A^-1 b, L of mat6x6_ldl with a positive pivot.
   L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   30 mul, 30 add, 6 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat6x6_ldl_solve(const ksl_mat6x6_t *L, const ksl_coscrew_t *b,
    ksl_screw_t *x) {
  const double y1 = b->m1 - KSL_MUL(L->at[0][1], b->m0);
  const double y2 = b->m2 - KSL_MUL(L->at[0][2], b->m0) - KSL_MUL(L->at[1][2], y1);
  const double y3 = b->m3 - KSL_MUL(L->at[0][3], b->m0) - KSL_MUL(L->at[1][3], y1)
          - KSL_MUL(L->at[2][3], y2);
  const double y4 = b->m4 - KSL_MUL(L->at[0][4], b->m0) - KSL_MUL(L->at[1][4], y1)
          - KSL_MUL(L->at[2][4], y2) - KSL_MUL(L->at[3][4], y3);
  const double y5 = b->m5 - KSL_MUL(L->at[0][5], b->m0) - KSL_MUL(L->at[1][5], y1)
          - KSL_MUL(L->at[2][5], y2) - KSL_MUL(L->at[3][5], y3) - KSL_MUL(L->at[4][5], y4);
  const double z0 = b->m0 / L->at[0][0];
  const double z1 = y1 / L->at[1][1];
  const double z2 = y2 / L->at[2][2];
  const double z3 = y3 / L->at[3][3];
  const double z4 = y4 / L->at[4][4];
  const double z5 = y5 / L->at[5][5];
  const double x4 = z4 - KSL_MUL(L->at[4][5], z5);
  const double x3 = z3 - KSL_MUL(L->at[3][4], x4) - KSL_MUL(L->at[3][5], z5);
  const double x2 = z2 - KSL_MUL(L->at[2][3], x3) - KSL_MUL(L->at[2][4], x4)
          - KSL_MUL(L->at[2][5], z5);
  const double x1 = z1 - KSL_MUL(L->at[1][2], x2) - KSL_MUL(L->at[1][3], x3)
          - KSL_MUL(L->at[1][4], x4) - KSL_MUL(L->at[1][5], z5);
  const double x0 = z0 - KSL_MUL(L->at[0][1], x1) - KSL_MUL(L->at[0][2], x2)
          - KSL_MUL(L->at[0][3], x3) - KSL_MUL(L->at[0][4], x4) - KSL_MUL(L->at[0][5], z5);
  x->m0 = x0;
  x->m1 = x1;
  x->m2 = x2;
  x->m3 = x3;
  x->m4 = x4;
  x->m5 = z5;
}

/* x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
     Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
     rounding or indefinite (A - 50 u diag A is not positive definite).
   A: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   172 mul, 172 add, 48 div, 23 less, 1 equal, 41 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline double ksl_mat6x6_solve(const ksl_mat6x6_t *A, const ksl_coscrew_t *b,
    ksl_screw_t *x) {
  const double divisor0 = 0.0 < A->at[0][0] ? A->at[0][0] : 1.0;
  const double l0_0 = A->at[0][1] / divisor0, l0_1 = A->at[0][2] / divisor0,
      l0_2 = A->at[0][3] / divisor0, l0_3 = A->at[0][4] / divisor0, l0_4 = A->at[0][5] / divisor0;
  const double u1_0 = A->at[1][1] - KSL_MUL(A->at[0][1], l0_0),
      u1_1 = A->at[1][2] - KSL_MUL(A->at[0][2], l0_0),
      u1_2 = A->at[1][3] - KSL_MUL(A->at[0][3], l0_0),
      u1_3 = A->at[1][4] - KSL_MUL(A->at[0][4], l0_0),
      u1_4 = A->at[1][5] - KSL_MUL(A->at[0][5], l0_0);
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1, l1_1 = u1_2 / divisor1, l1_2 = u1_3 / divisor1,
      l1_3 = u1_4 / divisor1;
  const double u2_0 = A->at[2][2] - KSL_MUL(A->at[0][2], l0_1) - KSL_MUL(u1_1, l1_0),
      u2_1 = A->at[2][3] - KSL_MUL(A->at[0][3], l0_1) - KSL_MUL(u1_2, l1_0),
      u2_2 = A->at[2][4] - KSL_MUL(A->at[0][4], l0_1) - KSL_MUL(u1_3, l1_0),
      u2_3 = A->at[2][5] - KSL_MUL(A->at[0][5], l0_1) - KSL_MUL(u1_4, l1_0);
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2_0 = u2_1 / divisor2, l2_1 = u2_2 / divisor2, l2_2 = u2_3 / divisor2;
  const double u3_0 = A->at[3][3] - KSL_MUL(A->at[0][3], l0_2) - KSL_MUL(u1_2, l1_1)
          - KSL_MUL(u2_1, l2_0),
      u3_1 = A->at[3][4] - KSL_MUL(A->at[0][4], l0_2) - KSL_MUL(u1_3, l1_1) - KSL_MUL(u2_2, l2_0),
      u3_2 = A->at[3][5] - KSL_MUL(A->at[0][5], l0_2) - KSL_MUL(u1_4, l1_1) - KSL_MUL(u2_3, l2_0);
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0;
  const double l3_0 = u3_1 / divisor3, l3_1 = u3_2 / divisor3;
  const double u4_0 = A->at[4][4] - KSL_MUL(A->at[0][4], l0_3) - KSL_MUL(u1_3, l1_2)
          - KSL_MUL(u2_2, l2_1) - KSL_MUL(u3_1, l3_0),
      u4_1 = A->at[4][5] - KSL_MUL(A->at[0][5], l0_3) - KSL_MUL(u1_4, l1_2) - KSL_MUL(u2_3, l2_1)
          - KSL_MUL(u3_2, l3_0);
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0;
  const double l4 = u4_1 / divisor4;
  const double u5 = A->at[5][5] - KSL_MUL(A->at[0][5], l0_4) - KSL_MUL(u1_4, l1_3)
          - KSL_MUL(u2_3, l2_2) - KSL_MUL(u3_2, l3_1) - KSL_MUL(u4_1, l4);
  const double divisor5 = 0.0 < u5 ? u5 : 1.0;
  const double part0a = A->at[0][0] / divisor0, part0 = 0.0 < A->at[0][0] ? part0a : A->at[0][0];
  const double own1 = 0.0 < A->at[1][1] ? A->at[1][1] : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < A->at[1][1] ? part1a : A->at[1][1];
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < A->at[2][2] ? A->at[2][2] : 1.0;
  const double part2a = u2_0 / own2, part2 = 0.0 < A->at[2][2] ? part2a : A->at[2][2];
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double own3 = 0.0 < A->at[3][3] ? A->at[3][3] : 1.0;
  const double part3a = u3_0 / own3, part3 = 0.0 < A->at[3][3] ? part3a : A->at[3][3];
  const double smallest3 = smallest2 < part3 ? smallest2 : part3;
  const double own4 = 0.0 < A->at[4][4] ? A->at[4][4] : 1.0;
  const double part4a = u4_0 / own4, part4 = 0.0 < A->at[4][4] ? part4a : A->at[4][4];
  const double smallest4 = smallest3 < part4 ? smallest3 : part4;
  const double own5 = 0.0 < A->at[5][5] ? A->at[5][5] : 1.0;
  const double part5a = u5 / own5, part5 = 0.0 < A->at[5][5] ? part5a : A->at[5][5];
  const double smallest5 = smallest4 < part5 ? smallest4 : part5;
  const double less_0 = KSL_MUL(A->at[0][0], 0.9999999999999944),
      less_1 = KSL_MUL(A->at[1][1], 0.9999999999999944),
      less_2 = KSL_MUL(A->at[2][2], 0.9999999999999944),
      less_3 = KSL_MUL(A->at[3][3], 0.9999999999999944),
      less_4 = KSL_MUL(A->at[4][4], 0.9999999999999944),
      less_5 = KSL_MUL(A->at[5][5], 0.9999999999999944);
  const double less_divisor0 = 0.0 < less_0 ? less_0 : 1.0;
  const double less_l0_0 = A->at[0][1] / less_divisor0, less_l0_1 = A->at[0][2] / less_divisor0,
      less_l0_2 = A->at[0][3] / less_divisor0, less_l0_3 = A->at[0][4] / less_divisor0,
      less_l0_4 = A->at[0][5] / less_divisor0;
  const double less_u1_0 = less_1 - KSL_MUL(A->at[0][1], less_l0_0),
      less_u1_1 = A->at[1][2] - KSL_MUL(A->at[0][2], less_l0_0),
      less_u1_2 = A->at[1][3] - KSL_MUL(A->at[0][3], less_l0_0),
      less_u1_3 = A->at[1][4] - KSL_MUL(A->at[0][4], less_l0_0),
      less_u1_4 = A->at[1][5] - KSL_MUL(A->at[0][5], less_l0_0);
  const double less_divisor1 = 0.0 < less_u1_0 ? less_u1_0 : 1.0;
  const double less_l1_0 = less_u1_1 / less_divisor1, less_l1_1 = less_u1_2 / less_divisor1,
      less_l1_2 = less_u1_3 / less_divisor1, less_l1_3 = less_u1_4 / less_divisor1;
  const double less_u2_0 = less_2 - KSL_MUL(A->at[0][2], less_l0_1) - KSL_MUL(less_u1_1, less_l1_0),
      less_u2_1 = A->at[2][3] - KSL_MUL(A->at[0][3], less_l0_1) - KSL_MUL(less_u1_2, less_l1_0),
      less_u2_2 = A->at[2][4] - KSL_MUL(A->at[0][4], less_l0_1) - KSL_MUL(less_u1_3, less_l1_0),
      less_u2_3 = A->at[2][5] - KSL_MUL(A->at[0][5], less_l0_1) - KSL_MUL(less_u1_4, less_l1_0);
  const double less_divisor2 = 0.0 < less_u2_0 ? less_u2_0 : 1.0;
  const double less_l2_0 = less_u2_1 / less_divisor2, less_l2_1 = less_u2_2 / less_divisor2,
      less_l2_2 = less_u2_3 / less_divisor2;
  const double less_u3_0 = less_3 - KSL_MUL(A->at[0][3], less_l0_2) - KSL_MUL(less_u1_2, less_l1_1)
          - KSL_MUL(less_u2_1, less_l2_0),
      less_u3_1 = A->at[3][4] - KSL_MUL(A->at[0][4], less_l0_2) - KSL_MUL(less_u1_3, less_l1_1)
          - KSL_MUL(less_u2_2, less_l2_0),
      less_u3_2 = A->at[3][5] - KSL_MUL(A->at[0][5], less_l0_2) - KSL_MUL(less_u1_4, less_l1_1)
          - KSL_MUL(less_u2_3, less_l2_0);
  const double less_divisor3 = 0.0 < less_u3_0 ? less_u3_0 : 1.0;
  const double less_l3_0 = less_u3_1 / less_divisor3, less_l3_1 = less_u3_2 / less_divisor3;
  const double less_u4_0 = less_4 - KSL_MUL(A->at[0][4], less_l0_3) - KSL_MUL(less_u1_3, less_l1_2)
          - KSL_MUL(less_u2_2, less_l2_1) - KSL_MUL(less_u3_1, less_l3_0);
  const double less_u4_1f = A->at[4][5] - KSL_MUL(A->at[0][5], less_l0_3)
          - KSL_MUL(less_u1_4, less_l1_2) - KSL_MUL(less_u2_3, less_l2_1),
      less_u4_1 = less_u4_1f - KSL_MUL(less_u3_2, less_l3_0);
  const double less_divisor4 = 0.0 < less_u4_0 ? less_u4_0 : 1.0;
  const double less_l4 = less_u4_1 / less_divisor4;
  const double less_u5h = less_5 - KSL_MUL(A->at[0][5], less_l0_4) - KSL_MUL(less_u1_4, less_l1_3)
          - KSL_MUL(less_u2_3, less_l2_2) - KSL_MUL(less_u3_2, less_l3_1),
      less_u5 = less_u5h - KSL_MUL(less_u4_1, less_l4);
  const double regular_b = 0.0 < less_u5 ? 1.0 : 0.0, regular_c = 0.0 < less_u4_0 ? regular_b : 0.0,
      regular_d = 0.0 < less_u3_0 ? regular_c : 0.0, regular_e = 0.0 < less_u2_0 ? regular_d : 0.0,
      regular_f = 0.0 < less_u1_0 ? regular_e : 0.0, regular = 0.0 < less_0 ? regular_f : 0.0;
  const double least = smallest5 < 0.0 ? smallest5 : 0.0;
  const double y1 = b->m1 - KSL_MUL(b->m0, l0_0);
  const double y2 = b->m2 - KSL_MUL(b->m0, l0_1) - KSL_MUL(l1_0, y1);
  const double y3 = b->m3 - KSL_MUL(b->m0, l0_2) - KSL_MUL(l1_1, y1) - KSL_MUL(l2_0, y2);
  const double y4 = b->m4 - KSL_MUL(b->m0, l0_3) - KSL_MUL(l1_2, y1) - KSL_MUL(l2_1, y2)
          - KSL_MUL(l3_0, y3);
  const double y5 = b->m5 - KSL_MUL(b->m0, l0_4) - KSL_MUL(l1_3, y1) - KSL_MUL(l2_2, y2)
          - KSL_MUL(l3_1, y3) - KSL_MUL(l4, y4);
  const double z0 = b->m0 / divisor0;
  const double z1 = y1 / divisor1;
  const double z2 = y2 / divisor2;
  const double z3 = y3 / divisor3;
  const double z4 = y4 / divisor4;
  const double z5 = y5 / divisor5;
  const double x4 = z4 - KSL_MUL(l4, z5);
  const double x3 = z3 - KSL_MUL(l3_0, x4) - KSL_MUL(l3_1, z5);
  const double x2 = z2 - KSL_MUL(l2_0, x3) - KSL_MUL(l2_1, x4) - KSL_MUL(l2_2, z5);
  const double x1 = z1 - KSL_MUL(l1_0, x2) - KSL_MUL(l1_1, x3) - KSL_MUL(l1_2, x4)
          - KSL_MUL(l1_3, z5);
  const double x0 = z0 - KSL_MUL(l0_0, x1) - KSL_MUL(l0_1, x2) - KSL_MUL(l0_2, x3)
          - KSL_MUL(l0_3, x4) - KSL_MUL(l0_4, z5);
  const double residual_0h = b->m0 - KSL_MUL(A->at[0][0], x0) - KSL_MUL(A->at[0][1], x1)
          - KSL_MUL(A->at[0][2], x2) - KSL_MUL(A->at[0][3], x3),
      residual_0 = residual_0h - KSL_MUL(A->at[0][4], x4) - KSL_MUL(A->at[0][5], z5);
  const double residual_1h = b->m1 - KSL_MUL(A->at[0][1], x0) - KSL_MUL(A->at[1][1], x1)
          - KSL_MUL(A->at[1][2], x2) - KSL_MUL(A->at[1][3], x3),
      residual_1 = residual_1h - KSL_MUL(A->at[1][4], x4) - KSL_MUL(A->at[1][5], z5);
  const double residual_2h = b->m2 - KSL_MUL(A->at[0][2], x0) - KSL_MUL(A->at[1][2], x1)
          - KSL_MUL(A->at[2][2], x2) - KSL_MUL(A->at[2][3], x3),
      residual_2 = residual_2h - KSL_MUL(A->at[2][4], x4) - KSL_MUL(A->at[2][5], z5);
  const double residual_3h = b->m3 - KSL_MUL(A->at[0][3], x0) - KSL_MUL(A->at[1][3], x1)
          - KSL_MUL(A->at[2][3], x2) - KSL_MUL(A->at[3][3], x3),
      residual_3 = residual_3h - KSL_MUL(A->at[3][4], x4) - KSL_MUL(A->at[3][5], z5);
  const double residual_4h = b->m4 - KSL_MUL(A->at[0][4], x0) - KSL_MUL(A->at[1][4], x1)
          - KSL_MUL(A->at[2][4], x2) - KSL_MUL(A->at[3][4], x3),
      residual_4 = residual_4h - KSL_MUL(A->at[4][4], x4) - KSL_MUL(A->at[4][5], z5);
  const double residual_5h = b->m5 - KSL_MUL(A->at[0][5], x0) - KSL_MUL(A->at[1][5], x1)
          - KSL_MUL(A->at[2][5], x2) - KSL_MUL(A->at[3][5], x3),
      residual_5 = residual_5h - KSL_MUL(A->at[4][5], x4) - KSL_MUL(A->at[5][5], z5);
  const double refined_y1 = residual_1 - KSL_MUL(l0_0, residual_0);
  const double refined_y2 = residual_2 - KSL_MUL(l0_1, residual_0) - KSL_MUL(l1_0, refined_y1);
  const double refined_y3 = residual_3 - KSL_MUL(l0_2, residual_0) - KSL_MUL(l1_1, refined_y1)
          - KSL_MUL(l2_0, refined_y2);
  const double refined_y4 = residual_4 - KSL_MUL(l0_3, residual_0) - KSL_MUL(l1_2, refined_y1)
          - KSL_MUL(l2_1, refined_y2) - KSL_MUL(l3_0, refined_y3);
  const double refined_y5h = residual_5 - KSL_MUL(l0_4, residual_0) - KSL_MUL(l1_3, refined_y1)
          - KSL_MUL(l2_2, refined_y2) - KSL_MUL(l3_1, refined_y3),
      refined_y5 = refined_y5h - KSL_MUL(l4, refined_y4);
  const double refined_z0 = residual_0 / divisor0;
  const double refined_z1 = refined_y1 / divisor1;
  const double refined_z2 = refined_y2 / divisor2;
  const double refined_z3 = refined_y3 / divisor3;
  const double refined_z4 = refined_y4 / divisor4;
  const double refined_z5 = refined_y5 / divisor5;
  const double refined_x4 = refined_z4 - KSL_MUL(l4, refined_z5);
  const double refined_x3 = refined_z3 - KSL_MUL(l3_0, refined_x4) - KSL_MUL(l3_1, refined_z5);
  const double refined_x2 = refined_z2 - KSL_MUL(l2_0, refined_x3) - KSL_MUL(l2_1, refined_x4)
          - KSL_MUL(l2_2, refined_z5);
  const double refined_x1 = refined_z1 - KSL_MUL(l1_0, refined_x2) - KSL_MUL(l1_1, refined_x3)
          - KSL_MUL(l1_2, refined_x4) - KSL_MUL(l1_3, refined_z5);
  const double refined_x0h = refined_z0 - KSL_MUL(l0_0, refined_x1) - KSL_MUL(l0_1, refined_x2)
          - KSL_MUL(l0_2, refined_x3) - KSL_MUL(l0_3, refined_x4),
      refined_x0 = refined_x0h - KSL_MUL(l0_4, refined_z5);
  const double found_0 = x0 + refined_x0, found_1 = x1 + refined_x1, found_2 = x2 + refined_x2,
      found_3 = x3 + refined_x3, found_4 = x4 + refined_x4, found_5 = z5 + refined_z5;
  const double pivot = regular == 1.0 ? smallest5 : least;
  const double x_0 = regular == 1.0 ? found_0 : (double)NAN,
      x_1 = regular == 1.0 ? found_1 : (double)NAN, x_2 = regular == 1.0 ? found_2 : (double)NAN,
      x_3 = regular == 1.0 ? found_3 : (double)NAN, x_4 = regular == 1.0 ? found_4 : (double)NAN,
      x_5 = regular == 1.0 ? found_5 : (double)NAN;
  x->m0 = x_0;
  x->m1 = x_1;
  x->m2 = x_2;
  x->m3 = x_3;
  x->m4 = x_4;
  x->m5 = x_5;
  return pivot;
}

/* L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
     triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
     not positive definite, and L is meaningless.
   A, L: rotation or other 3×3 matrix.
   4 mul, 4 add, 6 div, 6 less, 9 select.
   |L D L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline float ksl_mat3x3f_ldl(const ksl_mat3x3f_t *A, ksl_mat3x3f_t *L) {
  const float divisor0 = 0.0f < A->m00 ? A->m00 : 1.0f;
  const float l0_0 = A->m10 / divisor0, l0_1 = A->m20 / divisor0;
  const float u1_0 = A->m11 - KSL_MULF(A->m10, l0_0), u1_1 = A->m21 - KSL_MULF(A->m20, l0_0);
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1 = u1_1 / divisor1;
  const float u2 = A->m22 - KSL_MULF(A->m20, l0_1) - KSL_MULF(u1_1, l1);
  const float part0a = A->m00 / divisor0, part0 = 0.0f < A->m00 ? part0a : A->m00;
  const float own1 = 0.0f < A->m11 ? A->m11 : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < A->m11 ? part1a : A->m11;
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < A->m22 ? A->m22 : 1.0f;
  const float part2a = u2 / own2, part2 = 0.0f < A->m22 ? part2a : A->m22;
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  L->m00 = A->m00;
  L->m01 = 0.0f;
  L->m02 = 0.0f;
  L->m10 = l0_0;
  L->m11 = u1_0;
  L->m12 = 0.0f;
  L->m20 = l0_1;
  L->m21 = l1;
  L->m22 = u2;
  return smallest2;
}

/* x = A^-1 b, L of mat3x3_ldl with a positive pivot.
   L: rotation or other 3×3 matrix; b, x: vector.
   6 mul, 6 add, 3 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat3x3f_ldl_solve(const ksl_mat3x3f_t *L, const ksl_vec3f_t *b,
    ksl_vec3f_t *x) {
  const float y1 = b->y - KSL_MULF(L->m10, b->x);
  const float y2 = b->z - KSL_MULF(L->m20, b->x) - KSL_MULF(L->m21, y1);
  const float z0 = b->x / L->m00;
  const float z1 = y1 / L->m11;
  const float z2 = y2 / L->m22;
  const float x1 = z1 - KSL_MULF(L->m21, z2);
  const float x0 = z0 - KSL_MULF(L->m10, x1) - KSL_MULF(L->m20, z2);
  x->x = x0;
  x->y = x1;
  x->z = z2;
}

/* x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
     Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
     rounding or indefinite (A - 50 u diag A is not positive definite).
   A: rotation or other 3×3 matrix; b, x: vector.
   32 mul, 32 add, 15 div, 11 less, 1 equal, 20 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline float ksl_mat3x3f_solve(const ksl_mat3x3f_t *A, const ksl_vec3f_t *b,
    ksl_vec3f_t *x) {
  const float divisor0 = 0.0f < A->m00 ? A->m00 : 1.0f;
  const float l0_0 = A->m10 / divisor0, l0_1 = A->m20 / divisor0;
  const float u1_0 = A->m11 - KSL_MULF(A->m10, l0_0), u1_1 = A->m21 - KSL_MULF(A->m20, l0_0);
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1 = u1_1 / divisor1;
  const float u2 = A->m22 - KSL_MULF(A->m20, l0_1) - KSL_MULF(u1_1, l1);
  const float divisor2 = 0.0f < u2 ? u2 : 1.0f;
  const float part0a = A->m00 / divisor0, part0 = 0.0f < A->m00 ? part0a : A->m00;
  const float own1 = 0.0f < A->m11 ? A->m11 : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < A->m11 ? part1a : A->m11;
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < A->m22 ? A->m22 : 1.0f;
  const float part2a = u2 / own2, part2 = 0.0f < A->m22 ? part2a : A->m22;
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  const float less_0 = KSL_MULF(A->m00, 0.999997f), less_1 = KSL_MULF(A->m11, 0.999997f),
      less_2 = KSL_MULF(A->m22, 0.999997f);
  const float less_divisor0 = 0.0f < less_0 ? less_0 : 1.0f;
  const float less_l0_0 = A->m10 / less_divisor0, less_l0_1 = A->m20 / less_divisor0;
  const float less_u1_0 = less_1 - KSL_MULF(A->m10, less_l0_0),
      less_u1_1 = A->m21 - KSL_MULF(A->m20, less_l0_0);
  const float less_divisor1 = 0.0f < less_u1_0 ? less_u1_0 : 1.0f;
  const float less_l1 = less_u1_1 / less_divisor1;
  const float less_u2 = less_2 - KSL_MULF(A->m20, less_l0_1) - KSL_MULF(less_u1_1, less_l1);
  const float regular_b = 0.0f < less_u2 ? 1.0f : 0.0f,
      regular_c = 0.0f < less_u1_0 ? regular_b : 0.0f, regular = 0.0f < less_0 ? regular_c : 0.0f;
  const float least = smallest2 < 0.0f ? smallest2 : 0.0f;
  const float y1 = b->y - KSL_MULF(b->x, l0_0);
  const float y2 = b->z - KSL_MULF(b->x, l0_1) - KSL_MULF(l1, y1);
  const float z0 = b->x / divisor0;
  const float z1 = y1 / divisor1;
  const float z2 = y2 / divisor2;
  const float x1 = z1 - KSL_MULF(l1, z2);
  const float x0 = z0 - KSL_MULF(l0_0, x1) - KSL_MULF(l0_1, z2);
  const float residual_0 = b->x - KSL_MULF(A->m00, x0) - KSL_MULF(A->m10, x1)
          - KSL_MULF(A->m20, z2),
      residual_1 = b->y - KSL_MULF(A->m10, x0) - KSL_MULF(A->m11, x1) - KSL_MULF(A->m21, z2),
      residual_2 = b->z - KSL_MULF(A->m20, x0) - KSL_MULF(A->m21, x1) - KSL_MULF(A->m22, z2);
  const float refined_y1 = residual_1 - KSL_MULF(l0_0, residual_0);
  const float refined_y2 = residual_2 - KSL_MULF(l0_1, residual_0) - KSL_MULF(l1, refined_y1);
  const float refined_z0 = residual_0 / divisor0;
  const float refined_z1 = refined_y1 / divisor1;
  const float refined_z2 = refined_y2 / divisor2;
  const float refined_x1 = refined_z1 - KSL_MULF(l1, refined_z2);
  const float refined_x0 = refined_z0 - KSL_MULF(l0_0, refined_x1) - KSL_MULF(l0_1, refined_z2);
  const float found_0 = x0 + refined_x0, found_1 = x1 + refined_x1, found_2 = z2 + refined_z2;
  const float pivot = regular == 1.0f ? smallest2 : least;
  const float x_0 = regular == 1.0f ? found_0 : (float)NAN,
      x_1 = regular == 1.0f ? found_1 : (float)NAN, x_2 = regular == 1.0f ? found_2 : (float)NAN;
  x->x = x_0;
  x->y = x_1;
  x->z = x_2;
  return pivot;
}

/* L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
     triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
     not positive definite, and L is meaningless.
   A, L: 6×6 operator.
   35 mul, 35 add, 21 div, 15 less, 21 select.
   |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline float ksl_mat6x6f_ldl(const ksl_mat6x6f_t *A, ksl_mat6x6f_t *L) {
  const float divisor0 = 0.0f < A->at[0][0] ? A->at[0][0] : 1.0f;
  const float l0_0 = A->at[0][1] / divisor0, l0_1 = A->at[0][2] / divisor0,
      l0_2 = A->at[0][3] / divisor0, l0_3 = A->at[0][4] / divisor0, l0_4 = A->at[0][5] / divisor0;
  const float u1_0 = A->at[1][1] - KSL_MULF(A->at[0][1], l0_0),
      u1_1 = A->at[1][2] - KSL_MULF(A->at[0][2], l0_0),
      u1_2 = A->at[1][3] - KSL_MULF(A->at[0][3], l0_0),
      u1_3 = A->at[1][4] - KSL_MULF(A->at[0][4], l0_0),
      u1_4 = A->at[1][5] - KSL_MULF(A->at[0][5], l0_0);
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1_0 = u1_1 / divisor1, l1_1 = u1_2 / divisor1, l1_2 = u1_3 / divisor1,
      l1_3 = u1_4 / divisor1;
  const float u2_0 = A->at[2][2] - KSL_MULF(A->at[0][2], l0_1) - KSL_MULF(u1_1, l1_0),
      u2_1 = A->at[2][3] - KSL_MULF(A->at[0][3], l0_1) - KSL_MULF(u1_2, l1_0),
      u2_2 = A->at[2][4] - KSL_MULF(A->at[0][4], l0_1) - KSL_MULF(u1_3, l1_0),
      u2_3 = A->at[2][5] - KSL_MULF(A->at[0][5], l0_1) - KSL_MULF(u1_4, l1_0);
  const float divisor2 = 0.0f < u2_0 ? u2_0 : 1.0f;
  const float l2_0 = u2_1 / divisor2, l2_1 = u2_2 / divisor2, l2_2 = u2_3 / divisor2;
  const float u3_0 = A->at[3][3] - KSL_MULF(A->at[0][3], l0_2) - KSL_MULF(u1_2, l1_1)
          - KSL_MULF(u2_1, l2_0),
      u3_1 = A->at[3][4] - KSL_MULF(A->at[0][4], l0_2) - KSL_MULF(u1_3, l1_1)
          - KSL_MULF(u2_2, l2_0),
      u3_2 = A->at[3][5] - KSL_MULF(A->at[0][5], l0_2) - KSL_MULF(u1_4, l1_1)
          - KSL_MULF(u2_3, l2_0);
  const float divisor3 = 0.0f < u3_0 ? u3_0 : 1.0f;
  const float l3_0 = u3_1 / divisor3, l3_1 = u3_2 / divisor3;
  const float u4_0 = A->at[4][4] - KSL_MULF(A->at[0][4], l0_3) - KSL_MULF(u1_3, l1_2)
          - KSL_MULF(u2_2, l2_1) - KSL_MULF(u3_1, l3_0),
      u4_1 = A->at[4][5] - KSL_MULF(A->at[0][5], l0_3) - KSL_MULF(u1_4, l1_2)
          - KSL_MULF(u2_3, l2_1) - KSL_MULF(u3_2, l3_0);
  const float divisor4 = 0.0f < u4_0 ? u4_0 : 1.0f;
  const float l4 = u4_1 / divisor4;
  const float u5 = A->at[5][5] - KSL_MULF(A->at[0][5], l0_4) - KSL_MULF(u1_4, l1_3)
          - KSL_MULF(u2_3, l2_2) - KSL_MULF(u3_2, l3_1) - KSL_MULF(u4_1, l4);
  const float part0a = A->at[0][0] / divisor0, part0 = 0.0f < A->at[0][0] ? part0a : A->at[0][0];
  const float own1 = 0.0f < A->at[1][1] ? A->at[1][1] : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < A->at[1][1] ? part1a : A->at[1][1];
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < A->at[2][2] ? A->at[2][2] : 1.0f;
  const float part2a = u2_0 / own2, part2 = 0.0f < A->at[2][2] ? part2a : A->at[2][2];
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  const float own3 = 0.0f < A->at[3][3] ? A->at[3][3] : 1.0f;
  const float part3a = u3_0 / own3, part3 = 0.0f < A->at[3][3] ? part3a : A->at[3][3];
  const float smallest3 = smallest2 < part3 ? smallest2 : part3;
  const float own4 = 0.0f < A->at[4][4] ? A->at[4][4] : 1.0f;
  const float part4a = u4_0 / own4, part4 = 0.0f < A->at[4][4] ? part4a : A->at[4][4];
  const float smallest4 = smallest3 < part4 ? smallest3 : part4;
  const float own5 = 0.0f < A->at[5][5] ? A->at[5][5] : 1.0f;
  const float part5a = u5 / own5, part5 = 0.0f < A->at[5][5] ? part5a : A->at[5][5];
  const float smallest5 = smallest4 < part5 ? smallest4 : part5;
  L->at[0][0] = A->at[0][0];
  L->at[1][0] = 0.0f;
  L->at[2][0] = 0.0f;
  L->at[3][0] = 0.0f;
  L->at[4][0] = 0.0f;
  L->at[5][0] = 0.0f;
  L->at[0][1] = l0_0;
  L->at[1][1] = u1_0;
  L->at[2][1] = 0.0f;
  L->at[3][1] = 0.0f;
  L->at[4][1] = 0.0f;
  L->at[5][1] = 0.0f;
  L->at[0][2] = l0_1;
  L->at[1][2] = l1_0;
  L->at[2][2] = u2_0;
  L->at[3][2] = 0.0f;
  L->at[4][2] = 0.0f;
  L->at[5][2] = 0.0f;
  L->at[0][3] = l0_2;
  L->at[1][3] = l1_1;
  L->at[2][3] = l2_0;
  L->at[3][3] = u3_0;
  L->at[4][3] = 0.0f;
  L->at[5][3] = 0.0f;
  L->at[0][4] = l0_3;
  L->at[1][4] = l1_2;
  L->at[2][4] = l2_1;
  L->at[3][4] = l3_0;
  L->at[4][4] = u4_0;
  L->at[5][4] = 0.0f;
  L->at[0][5] = l0_4;
  L->at[1][5] = l1_3;
  L->at[2][5] = l2_2;
  L->at[3][5] = l3_1;
  L->at[4][5] = l4;
  L->at[5][5] = u5;
  return smallest5;
}

/* x = A^-1 b, L of mat6x6_ldl with a positive pivot.
   L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   30 mul, 30 add, 6 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat6x6f_ldl_solve(const ksl_mat6x6f_t *L, const ksl_coscrewf_t *b,
    ksl_screwf_t *x) {
  const float y1 = b->m1 - KSL_MULF(L->at[0][1], b->m0);
  const float y2 = b->m2 - KSL_MULF(L->at[0][2], b->m0) - KSL_MULF(L->at[1][2], y1);
  const float y3 = b->m3 - KSL_MULF(L->at[0][3], b->m0) - KSL_MULF(L->at[1][3], y1)
          - KSL_MULF(L->at[2][3], y2);
  const float y4 = b->m4 - KSL_MULF(L->at[0][4], b->m0) - KSL_MULF(L->at[1][4], y1)
          - KSL_MULF(L->at[2][4], y2) - KSL_MULF(L->at[3][4], y3);
  const float y5h = b->m5 - KSL_MULF(L->at[0][5], b->m0) - KSL_MULF(L->at[1][5], y1)
          - KSL_MULF(L->at[2][5], y2) - KSL_MULF(L->at[3][5], y3),
      y5 = y5h - KSL_MULF(L->at[4][5], y4);
  const float z0 = b->m0 / L->at[0][0];
  const float z1 = y1 / L->at[1][1];
  const float z2 = y2 / L->at[2][2];
  const float z3 = y3 / L->at[3][3];
  const float z4 = y4 / L->at[4][4];
  const float z5 = y5 / L->at[5][5];
  const float x4 = z4 - KSL_MULF(L->at[4][5], z5);
  const float x3 = z3 - KSL_MULF(L->at[3][4], x4) - KSL_MULF(L->at[3][5], z5);
  const float x2 = z2 - KSL_MULF(L->at[2][3], x3) - KSL_MULF(L->at[2][4], x4)
          - KSL_MULF(L->at[2][5], z5);
  const float x1 = z1 - KSL_MULF(L->at[1][2], x2) - KSL_MULF(L->at[1][3], x3)
          - KSL_MULF(L->at[1][4], x4) - KSL_MULF(L->at[1][5], z5);
  const float x0 = z0 - KSL_MULF(L->at[0][1], x1) - KSL_MULF(L->at[0][2], x2)
          - KSL_MULF(L->at[0][3], x3) - KSL_MULF(L->at[0][4], x4) - KSL_MULF(L->at[0][5], z5);
  x->m0 = x0;
  x->m1 = x1;
  x->m2 = x2;
  x->m3 = x3;
  x->m4 = x4;
  x->m5 = z5;
}

/* x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
     Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
     rounding or indefinite (A - 50 u diag A is not positive definite).
   A: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   172 mul, 172 add, 48 div, 23 less, 1 equal, 41 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline float ksl_mat6x6f_solve(const ksl_mat6x6f_t *A, const ksl_coscrewf_t *b,
    ksl_screwf_t *x) {
  const float divisor0 = 0.0f < A->at[0][0] ? A->at[0][0] : 1.0f;
  const float l0_0 = A->at[0][1] / divisor0, l0_1 = A->at[0][2] / divisor0,
      l0_2 = A->at[0][3] / divisor0, l0_3 = A->at[0][4] / divisor0, l0_4 = A->at[0][5] / divisor0;
  const float u1_0 = A->at[1][1] - KSL_MULF(A->at[0][1], l0_0),
      u1_1 = A->at[1][2] - KSL_MULF(A->at[0][2], l0_0),
      u1_2 = A->at[1][3] - KSL_MULF(A->at[0][3], l0_0),
      u1_3 = A->at[1][4] - KSL_MULF(A->at[0][4], l0_0),
      u1_4 = A->at[1][5] - KSL_MULF(A->at[0][5], l0_0);
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1_0 = u1_1 / divisor1, l1_1 = u1_2 / divisor1, l1_2 = u1_3 / divisor1,
      l1_3 = u1_4 / divisor1;
  const float u2_0 = A->at[2][2] - KSL_MULF(A->at[0][2], l0_1) - KSL_MULF(u1_1, l1_0),
      u2_1 = A->at[2][3] - KSL_MULF(A->at[0][3], l0_1) - KSL_MULF(u1_2, l1_0),
      u2_2 = A->at[2][4] - KSL_MULF(A->at[0][4], l0_1) - KSL_MULF(u1_3, l1_0),
      u2_3 = A->at[2][5] - KSL_MULF(A->at[0][5], l0_1) - KSL_MULF(u1_4, l1_0);
  const float divisor2 = 0.0f < u2_0 ? u2_0 : 1.0f;
  const float l2_0 = u2_1 / divisor2, l2_1 = u2_2 / divisor2, l2_2 = u2_3 / divisor2;
  const float u3_0 = A->at[3][3] - KSL_MULF(A->at[0][3], l0_2) - KSL_MULF(u1_2, l1_1)
          - KSL_MULF(u2_1, l2_0),
      u3_1 = A->at[3][4] - KSL_MULF(A->at[0][4], l0_2) - KSL_MULF(u1_3, l1_1)
          - KSL_MULF(u2_2, l2_0),
      u3_2 = A->at[3][5] - KSL_MULF(A->at[0][5], l0_2) - KSL_MULF(u1_4, l1_1)
          - KSL_MULF(u2_3, l2_0);
  const float divisor3 = 0.0f < u3_0 ? u3_0 : 1.0f;
  const float l3_0 = u3_1 / divisor3, l3_1 = u3_2 / divisor3;
  const float u4_0 = A->at[4][4] - KSL_MULF(A->at[0][4], l0_3) - KSL_MULF(u1_3, l1_2)
          - KSL_MULF(u2_2, l2_1) - KSL_MULF(u3_1, l3_0),
      u4_1 = A->at[4][5] - KSL_MULF(A->at[0][5], l0_3) - KSL_MULF(u1_4, l1_2)
          - KSL_MULF(u2_3, l2_1) - KSL_MULF(u3_2, l3_0);
  const float divisor4 = 0.0f < u4_0 ? u4_0 : 1.0f;
  const float l4 = u4_1 / divisor4;
  const float u5 = A->at[5][5] - KSL_MULF(A->at[0][5], l0_4) - KSL_MULF(u1_4, l1_3)
          - KSL_MULF(u2_3, l2_2) - KSL_MULF(u3_2, l3_1) - KSL_MULF(u4_1, l4);
  const float divisor5 = 0.0f < u5 ? u5 : 1.0f;
  const float part0a = A->at[0][0] / divisor0, part0 = 0.0f < A->at[0][0] ? part0a : A->at[0][0];
  const float own1 = 0.0f < A->at[1][1] ? A->at[1][1] : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < A->at[1][1] ? part1a : A->at[1][1];
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < A->at[2][2] ? A->at[2][2] : 1.0f;
  const float part2a = u2_0 / own2, part2 = 0.0f < A->at[2][2] ? part2a : A->at[2][2];
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  const float own3 = 0.0f < A->at[3][3] ? A->at[3][3] : 1.0f;
  const float part3a = u3_0 / own3, part3 = 0.0f < A->at[3][3] ? part3a : A->at[3][3];
  const float smallest3 = smallest2 < part3 ? smallest2 : part3;
  const float own4 = 0.0f < A->at[4][4] ? A->at[4][4] : 1.0f;
  const float part4a = u4_0 / own4, part4 = 0.0f < A->at[4][4] ? part4a : A->at[4][4];
  const float smallest4 = smallest3 < part4 ? smallest3 : part4;
  const float own5 = 0.0f < A->at[5][5] ? A->at[5][5] : 1.0f;
  const float part5a = u5 / own5, part5 = 0.0f < A->at[5][5] ? part5a : A->at[5][5];
  const float smallest5 = smallest4 < part5 ? smallest4 : part5;
  const float less_0 = KSL_MULF(A->at[0][0], 0.999997f), less_1 = KSL_MULF(A->at[1][1], 0.999997f),
      less_2 = KSL_MULF(A->at[2][2], 0.999997f), less_3 = KSL_MULF(A->at[3][3], 0.999997f),
      less_4 = KSL_MULF(A->at[4][4], 0.999997f), less_5 = KSL_MULF(A->at[5][5], 0.999997f);
  const float less_divisor0 = 0.0f < less_0 ? less_0 : 1.0f;
  const float less_l0_0 = A->at[0][1] / less_divisor0, less_l0_1 = A->at[0][2] / less_divisor0,
      less_l0_2 = A->at[0][3] / less_divisor0, less_l0_3 = A->at[0][4] / less_divisor0,
      less_l0_4 = A->at[0][5] / less_divisor0;
  const float less_u1_0 = less_1 - KSL_MULF(A->at[0][1], less_l0_0),
      less_u1_1 = A->at[1][2] - KSL_MULF(A->at[0][2], less_l0_0),
      less_u1_2 = A->at[1][3] - KSL_MULF(A->at[0][3], less_l0_0),
      less_u1_3 = A->at[1][4] - KSL_MULF(A->at[0][4], less_l0_0),
      less_u1_4 = A->at[1][5] - KSL_MULF(A->at[0][5], less_l0_0);
  const float less_divisor1 = 0.0f < less_u1_0 ? less_u1_0 : 1.0f;
  const float less_l1_0 = less_u1_1 / less_divisor1, less_l1_1 = less_u1_2 / less_divisor1,
      less_l1_2 = less_u1_3 / less_divisor1, less_l1_3 = less_u1_4 / less_divisor1;
  const float less_u2_0 = less_2 - KSL_MULF(A->at[0][2], less_l0_1)
          - KSL_MULF(less_u1_1, less_l1_0),
      less_u2_1 = A->at[2][3] - KSL_MULF(A->at[0][3], less_l0_1) - KSL_MULF(less_u1_2, less_l1_0),
      less_u2_2 = A->at[2][4] - KSL_MULF(A->at[0][4], less_l0_1) - KSL_MULF(less_u1_3, less_l1_0),
      less_u2_3 = A->at[2][5] - KSL_MULF(A->at[0][5], less_l0_1) - KSL_MULF(less_u1_4, less_l1_0);
  const float less_divisor2 = 0.0f < less_u2_0 ? less_u2_0 : 1.0f;
  const float less_l2_0 = less_u2_1 / less_divisor2, less_l2_1 = less_u2_2 / less_divisor2,
      less_l2_2 = less_u2_3 / less_divisor2;
  const float less_u3_0 = less_3 - KSL_MULF(A->at[0][3], less_l0_2)
          - KSL_MULF(less_u1_2, less_l1_1) - KSL_MULF(less_u2_1, less_l2_0),
      less_u3_1 = A->at[3][4] - KSL_MULF(A->at[0][4], less_l0_2) - KSL_MULF(less_u1_3, less_l1_1)
          - KSL_MULF(less_u2_2, less_l2_0),
      less_u3_2 = A->at[3][5] - KSL_MULF(A->at[0][5], less_l0_2) - KSL_MULF(less_u1_4, less_l1_1)
          - KSL_MULF(less_u2_3, less_l2_0);
  const float less_divisor3 = 0.0f < less_u3_0 ? less_u3_0 : 1.0f;
  const float less_l3_0 = less_u3_1 / less_divisor3, less_l3_1 = less_u3_2 / less_divisor3;
  const float less_u4_0f = less_4 - KSL_MULF(A->at[0][4], less_l0_3)
          - KSL_MULF(less_u1_3, less_l1_2) - KSL_MULF(less_u2_2, less_l2_1),
      less_u4_0 = less_u4_0f - KSL_MULF(less_u3_1, less_l3_0);
  const float less_u4_1f = A->at[4][5] - KSL_MULF(A->at[0][5], less_l0_3)
          - KSL_MULF(less_u1_4, less_l1_2) - KSL_MULF(less_u2_3, less_l2_1),
      less_u4_1 = less_u4_1f - KSL_MULF(less_u3_2, less_l3_0);
  const float less_divisor4 = 0.0f < less_u4_0 ? less_u4_0 : 1.0f;
  const float less_l4 = less_u4_1 / less_divisor4;
  const float less_u5f = less_5 - KSL_MULF(A->at[0][5], less_l0_4) - KSL_MULF(less_u1_4, less_l1_3)
          - KSL_MULF(less_u2_3, less_l2_2),
      less_u5 = less_u5f - KSL_MULF(less_u3_2, less_l3_1) - KSL_MULF(less_u4_1, less_l4);
  const float regular_b = 0.0f < less_u5 ? 1.0f : 0.0f,
      regular_c = 0.0f < less_u4_0 ? regular_b : 0.0f,
      regular_d = 0.0f < less_u3_0 ? regular_c : 0.0f,
      regular_e = 0.0f < less_u2_0 ? regular_d : 0.0f,
      regular_f = 0.0f < less_u1_0 ? regular_e : 0.0f, regular = 0.0f < less_0 ? regular_f : 0.0f;
  const float least = smallest5 < 0.0f ? smallest5 : 0.0f;
  const float y1 = b->m1 - KSL_MULF(b->m0, l0_0);
  const float y2 = b->m2 - KSL_MULF(b->m0, l0_1) - KSL_MULF(l1_0, y1);
  const float y3 = b->m3 - KSL_MULF(b->m0, l0_2) - KSL_MULF(l1_1, y1) - KSL_MULF(l2_0, y2);
  const float y4 = b->m4 - KSL_MULF(b->m0, l0_3) - KSL_MULF(l1_2, y1) - KSL_MULF(l2_1, y2)
          - KSL_MULF(l3_0, y3);
  const float y5 = b->m5 - KSL_MULF(b->m0, l0_4) - KSL_MULF(l1_3, y1) - KSL_MULF(l2_2, y2)
          - KSL_MULF(l3_1, y3) - KSL_MULF(l4, y4);
  const float z0 = b->m0 / divisor0;
  const float z1 = y1 / divisor1;
  const float z2 = y2 / divisor2;
  const float z3 = y3 / divisor3;
  const float z4 = y4 / divisor4;
  const float z5 = y5 / divisor5;
  const float x4 = z4 - KSL_MULF(l4, z5);
  const float x3 = z3 - KSL_MULF(l3_0, x4) - KSL_MULF(l3_1, z5);
  const float x2 = z2 - KSL_MULF(l2_0, x3) - KSL_MULF(l2_1, x4) - KSL_MULF(l2_2, z5);
  const float x1 = z1 - KSL_MULF(l1_0, x2) - KSL_MULF(l1_1, x3) - KSL_MULF(l1_2, x4)
          - KSL_MULF(l1_3, z5);
  const float x0 = z0 - KSL_MULF(l0_0, x1) - KSL_MULF(l0_1, x2) - KSL_MULF(l0_2, x3)
          - KSL_MULF(l0_3, x4) - KSL_MULF(l0_4, z5);
  const float residual_0h = b->m0 - KSL_MULF(A->at[0][0], x0) - KSL_MULF(A->at[0][1], x1)
          - KSL_MULF(A->at[0][2], x2) - KSL_MULF(A->at[0][3], x3),
      residual_0 = residual_0h - KSL_MULF(A->at[0][4], x4) - KSL_MULF(A->at[0][5], z5);
  const float residual_1h = b->m1 - KSL_MULF(A->at[0][1], x0) - KSL_MULF(A->at[1][1], x1)
          - KSL_MULF(A->at[1][2], x2) - KSL_MULF(A->at[1][3], x3),
      residual_1 = residual_1h - KSL_MULF(A->at[1][4], x4) - KSL_MULF(A->at[1][5], z5);
  const float residual_2h = b->m2 - KSL_MULF(A->at[0][2], x0) - KSL_MULF(A->at[1][2], x1)
          - KSL_MULF(A->at[2][2], x2) - KSL_MULF(A->at[2][3], x3),
      residual_2 = residual_2h - KSL_MULF(A->at[2][4], x4) - KSL_MULF(A->at[2][5], z5);
  const float residual_3h = b->m3 - KSL_MULF(A->at[0][3], x0) - KSL_MULF(A->at[1][3], x1)
          - KSL_MULF(A->at[2][3], x2) - KSL_MULF(A->at[3][3], x3),
      residual_3 = residual_3h - KSL_MULF(A->at[3][4], x4) - KSL_MULF(A->at[3][5], z5);
  const float residual_4h = b->m4 - KSL_MULF(A->at[0][4], x0) - KSL_MULF(A->at[1][4], x1)
          - KSL_MULF(A->at[2][4], x2) - KSL_MULF(A->at[3][4], x3),
      residual_4 = residual_4h - KSL_MULF(A->at[4][4], x4) - KSL_MULF(A->at[4][5], z5);
  const float residual_5h = b->m5 - KSL_MULF(A->at[0][5], x0) - KSL_MULF(A->at[1][5], x1)
          - KSL_MULF(A->at[2][5], x2) - KSL_MULF(A->at[3][5], x3),
      residual_5 = residual_5h - KSL_MULF(A->at[4][5], x4) - KSL_MULF(A->at[5][5], z5);
  const float refined_y1 = residual_1 - KSL_MULF(l0_0, residual_0);
  const float refined_y2 = residual_2 - KSL_MULF(l0_1, residual_0) - KSL_MULF(l1_0, refined_y1);
  const float refined_y3 = residual_3 - KSL_MULF(l0_2, residual_0) - KSL_MULF(l1_1, refined_y1)
          - KSL_MULF(l2_0, refined_y2);
  const float refined_y4 = residual_4 - KSL_MULF(l0_3, residual_0) - KSL_MULF(l1_2, refined_y1)
          - KSL_MULF(l2_1, refined_y2) - KSL_MULF(l3_0, refined_y3);
  const float refined_y5h = residual_5 - KSL_MULF(l0_4, residual_0) - KSL_MULF(l1_3, refined_y1)
          - KSL_MULF(l2_2, refined_y2) - KSL_MULF(l3_1, refined_y3),
      refined_y5 = refined_y5h - KSL_MULF(l4, refined_y4);
  const float refined_z0 = residual_0 / divisor0;
  const float refined_z1 = refined_y1 / divisor1;
  const float refined_z2 = refined_y2 / divisor2;
  const float refined_z3 = refined_y3 / divisor3;
  const float refined_z4 = refined_y4 / divisor4;
  const float refined_z5 = refined_y5 / divisor5;
  const float refined_x4 = refined_z4 - KSL_MULF(l4, refined_z5);
  const float refined_x3 = refined_z3 - KSL_MULF(l3_0, refined_x4) - KSL_MULF(l3_1, refined_z5);
  const float refined_x2 = refined_z2 - KSL_MULF(l2_0, refined_x3) - KSL_MULF(l2_1, refined_x4)
          - KSL_MULF(l2_2, refined_z5);
  const float refined_x1 = refined_z1 - KSL_MULF(l1_0, refined_x2) - KSL_MULF(l1_1, refined_x3)
          - KSL_MULF(l1_2, refined_x4) - KSL_MULF(l1_3, refined_z5);
  const float refined_x0h = refined_z0 - KSL_MULF(l0_0, refined_x1) - KSL_MULF(l0_1, refined_x2)
          - KSL_MULF(l0_2, refined_x3) - KSL_MULF(l0_3, refined_x4),
      refined_x0 = refined_x0h - KSL_MULF(l0_4, refined_z5);
  const float found_0 = x0 + refined_x0, found_1 = x1 + refined_x1, found_2 = x2 + refined_x2,
      found_3 = x3 + refined_x3, found_4 = x4 + refined_x4, found_5 = z5 + refined_z5;
  const float pivot = regular == 1.0f ? smallest5 : least;
  const float x_0 = regular == 1.0f ? found_0 : (float)NAN,
      x_1 = regular == 1.0f ? found_1 : (float)NAN, x_2 = regular == 1.0f ? found_2 : (float)NAN,
      x_3 = regular == 1.0f ? found_3 : (float)NAN, x_4 = regular == 1.0f ? found_4 : (float)NAN,
      x_5 = regular == 1.0f ? found_5 : (float)NAN;
  x->m0 = x_0;
  x->m1 = x_1;
  x->m2 = x_2;
  x->m3 = x_3;
  x->m4 = x_4;
  x->m5 = x_5;
  return pivot;
}

#endif
