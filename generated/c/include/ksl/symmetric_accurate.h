/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Symmetric positive definite 3×3 and 6×6 matrices: A = L D L^T, solutions of A x = b.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_SYMMETRIC_ACCURATE_H
#define KSL_SYMMETRIC_ACCURATE_H

#include "ksl_exact.h"

/* L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
     triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
     not positive definite, and L is meaningless.
   A, L: rotation or other 3×3 matrix.
   16 mul, 96 add, 6 product error, 4 product rest, 12 div, 6 less, 6 equal, 21 select.
   |L D L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline double ksl_mat3x3_ldl_accurate(const ksl_mat3x3_t *A, ksl_mat3x3_t *L) {
  const double divisor0 = 0.0 < A->m00 ? A->m00 : 1.0;
  const double l0_0 = A->m10 / divisor0, l0_0_product = KSL_MUL(l0_0, divisor0),
      l0_0_lo = (A->m10 - l0_0_product - ksl_product_error(l0_0, divisor0, l0_0_product))
          / divisor0;
  const double l0_1 = A->m20 / divisor0, l0_1_product = KSL_MUL(l0_1, divisor0),
      l0_1_lo = (A->m20 - l0_1_product - ksl_product_error(l0_1, divisor0, l0_1_product))
          / divisor0;
  const double u1_0a = KSL_MUL(A->m10, l0_0), u1_0 = A->m11 - u1_0a, u1_0_right = A->m11 - u1_0,
      u1_0_lo = A->m11 - (u1_0 + u1_0_right) - ksl_product_rest(A->m10, l0_0, u1_0a, u1_0_right)
          - KSL_MUL(A->m10, l0_0_lo);
  const double u1_1a = KSL_MUL(A->m20, l0_0), u1_1 = A->m21 - u1_1a, u1_1_right = A->m21 - u1_1,
      u1_1_lo = A->m21 - (u1_1 + u1_1_right) - ksl_product_rest(A->m20, l0_0, u1_1a, u1_1_right)
          - KSL_MUL(A->m20, l0_0_lo);
  const double u1_0_sum = u1_0 + u1_0_lo, u1_0_sum_right = u1_0_sum - u1_0,
      u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right),
      divisor1 = 0.0 < u1_0_sum ? u1_0_sum : 1.0, divisor1_lo = 0.0 < u1_0_sum ? u1_0_sum_lo : 0.0;
  const double u1_1_sum = u1_1 + u1_1_lo, u1_1_sum_right = u1_1_sum - u1_1,
      u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right),
      divisor1_sum = divisor1 + divisor1_lo, divisor1_sum_right = divisor1_sum - divisor1,
      l1 = u1_1_sum / divisor1_sum, l1_product = KSL_MUL(l1, divisor1_sum),
      l1_cross = KSL_MUL(l1, divisor1 - (divisor1_sum - divisor1_sum_right)
          + (divisor1_lo - divisor1_sum_right)),
      l1_lo = (u1_1_sum - l1_product - ksl_product_error(l1, divisor1_sum, l1_product)
          + u1_1_sum_lo - l1_cross) / divisor1_sum;
  const double u2a = KSL_MUL(A->m20, l0_1), u2b = A->m22 - u2a, u2b_right = A->m22 - u2b,
      u2c = KSL_MUL(u1_1_sum, l1), u2 = u2b - u2c, u2_right = u2b - u2,
      u2_lo2 = u2b - (u2 + u2_right) - ksl_product_rest(u1_1_sum, l1, u2c, u2_right)
          - (KSL_MUL(u1_1_sum_lo, l1) + KSL_MUL(u1_1_sum, l1_lo)),
      u2_lo = u2_lo2
          + (A->m22 - (u2b + u2b_right) - ksl_product_rest(A->m20, l0_1, u2a, u2b_right)
          - KSL_MUL(A->m20, l0_1_lo));
  const double part0a = A->m00 / divisor0, part0a_product = KSL_MUL(part0a, divisor0),
      part0a_lo = (A->m00 - part0a_product - ksl_product_error(part0a, divisor0, part0a_product))
          / divisor0, part0 = 0.0 < A->m00 ? part0a : A->m00,
      part0_lo = 0.0 < A->m00 ? part0a_lo : 0.0;
  const double own1 = 0.0 < A->m11 ? A->m11 : 1.0;
  const double part1a = u1_0_sum / own1, part1a_product = KSL_MUL(part1a, own1),
      part1a_lo = (u1_0_sum - part1a_product - ksl_product_error(part1a, own1, part1a_product)
          + u1_0_sum_lo) / own1, part1 = 0.0 < A->m11 ? part1a : A->m11,
      part1_lo = 0.0 < A->m11 ? part1a_lo : 0.0;
  const double part0_sum = part0 + part0_lo, part0_sum_right = part0_sum - part0,
      part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right),
      part1_sum = part1 + part1_lo, part1_sum_right = part1_sum - part1,
      part1_sum_lo = part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right),
      smallest1 = part0_sum < part1_sum ? part0_sum : part1_sum,
      smallest1_lo = part0_sum < part1_sum ? part0_sum_lo : part1_sum_lo;
  const double own2 = 0.0 < A->m22 ? A->m22 : 1.0;
  const double u2_sum = u2 + u2_lo, u2_sum_right = u2_sum - u2, part2a = u2_sum / own2,
      part2a_product = KSL_MUL(part2a, own2),
      part2a_numerator = u2_sum - part2a_product - ksl_product_error(part2a, own2, part2a_product)
          + (u2 - (u2_sum - u2_sum_right) + (u2_lo - u2_sum_right)),
      part2a_lo = part2a_numerator / own2, part2 = 0.0 < A->m22 ? part2a : A->m22,
      part2_lo = 0.0 < A->m22 ? part2a_lo : 0.0;
  const double smallest1_sum = smallest1 + smallest1_lo,
      smallest1_sum_right = smallest1_sum - smallest1,
      smallest1_sum_lo = smallest1 - (smallest1_sum - smallest1_sum_right)
          + (smallest1_lo - smallest1_sum_right), part2_sum = part2 + part2_lo,
      part2_sum_right = part2_sum - part2,
      part2_sum_lo = part2 - (part2_sum - part2_sum_right) + (part2_lo - part2_sum_right),
      smallest2 = smallest1_sum < part2_sum ? smallest1_sum : part2_sum;
  const double smallest2_rounded = smallest2
          + (smallest1_sum < part2_sum ? smallest1_sum_lo : part2_sum_lo);
  const double l0_0_rounded = l0_0 + l0_0_lo;
  const double u1_0_rounded = u1_0 + u1_0_lo;
  const double l0_1_rounded = l0_1 + l0_1_lo;
  const double l1_rounded = l1 + l1_lo;
  const double u2_rounded = u2 + u2_lo;
  const double smallest2_final = smallest2_rounded == smallest2_rounded ? smallest2_rounded
          : smallest2;
  const double l0_0_final = l0_0_rounded == l0_0_rounded ? l0_0_rounded : l0_0;
  const double u1_0_final = u1_0_rounded == u1_0_rounded ? u1_0_rounded : u1_0;
  const double l0_1_final = l0_1_rounded == l0_1_rounded ? l0_1_rounded : l0_1;
  const double l1_final = l1_rounded == l1_rounded ? l1_rounded : l1;
  const double u2_final = u2_rounded == u2_rounded ? u2_rounded : u2;
  L->m00 = A->m00;
  L->m01 = 0.0;
  L->m02 = 0.0;
  L->m10 = l0_0_final;
  L->m11 = u1_0_final;
  L->m12 = 0.0;
  L->m20 = l0_1_final;
  L->m21 = l1_final;
  L->m22 = u2_final;
  return smallest2_final;
}

/* x = A^-1 b, L of mat3x3_ldl with a positive pivot.
   L: rotation or other 3×3 matrix; b, x: vector.
   13 mul, 61 add, 3 product error, 6 product rest, 6 div, 3 equal, 3 select.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat3x3_ldl_solve_accurate(const ksl_mat3x3_t *L, const ksl_vec3_t *b,
    ksl_vec3_t *x) {
  const double y1a = KSL_MUL(L->m10, b->x), y1 = b->y - y1a, y1_right = b->y - y1,
      y1_lo = b->y - (y1 + y1_right) - ksl_product_rest(L->m10, b->x, y1a, y1_right);
  const double y2a = KSL_MUL(L->m20, b->x), y2b = b->z - y2a, y2b_right = b->z - y2b,
      y2c = KSL_MUL(L->m21, y1), y2 = y2b - y2c, y2_right = y2b - y2,
      y2_lo2 = y2b - (y2 + y2_right) - ksl_product_rest(L->m21, y1, y2c, y2_right)
          - KSL_MUL(L->m21, y1_lo),
      y2_lo = y2_lo2 + (b->z - (y2b + y2b_right) - ksl_product_rest(L->m20, b->x, y2a, y2b_right));
  const double z0 = b->x / L->m00, z0_product = KSL_MUL(z0, L->m00);
  const double y1_sum = y1 + y1_lo, y1_sum_right = y1_sum - y1, z1 = y1_sum / L->m11,
      z1_product = KSL_MUL(z1, L->m11);
  const double y2_sum = y2 + y2_lo, y2_sum_right = y2_sum - y2, z2 = y2_sum / L->m22,
      z2_product = KSL_MUL(z2, L->m22),
      z2_lo = (y2_sum - z2_product - ksl_product_error(z2, L->m22, z2_product)
          + (y2 - (y2_sum - y2_sum_right) + (y2_lo - y2_sum_right))) / L->m22;
  const double x1a = KSL_MUL(L->m21, z2), x1 = z1 - x1a, x1_right = z1 - x1;
  const double z1_lo = (y1_sum - z1_product - ksl_product_error(z1, L->m11, z1_product)
          + (y1 - (y1_sum - y1_sum_right) + (y1_lo - y1_sum_right))) / L->m11;
  const double x1_lo = z1 - (x1 + x1_right) - ksl_product_rest(L->m21, z2, x1a, x1_right)
          - KSL_MUL(L->m21, z2_lo) + z1_lo;
  const double x0a = KSL_MUL(L->m10, x1), x0b = z0 - x0a, x0b_right = z0 - x0b,
      x0b_lo2 = z0 - (x0b + x0b_right) - ksl_product_rest(L->m10, x1, x0a, x0b_right)
          - KSL_MUL(L->m10, x1_lo), x0c = KSL_MUL(L->m20, z2), x0 = x0b - x0c, x0_right = x0b - x0,
      x0_lo2 = x0b - (x0 + x0_right) - ksl_product_rest(L->m20, z2, x0c, x0_right)
          - KSL_MUL(L->m20, z2_lo);
  const double x0_rounded = x0
          + (x0_lo2
          + (x0b_lo2 + (b->x - z0_product - ksl_product_error(z0, L->m00, z0_product)) / L->m00));
  const double x1_rounded = x1 + x1_lo;
  const double z2_rounded = z2 + z2_lo;
  const double x0_final = x0_rounded == x0_rounded ? x0_rounded : x0;
  const double x1_final = x1_rounded == x1_rounded ? x1_rounded : x1;
  const double z2_final = z2_rounded == z2_rounded ? z2_rounded : z2;
  x->x = x0_final;
  x->y = x1_final;
  x->z = z2_final;
}

/* x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
     Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
     rounding or indefinite (A - 50 u diag A is not positive definite).
   A: rotation or other 3×3 matrix; b, x: vector.
   96 mul, 398 add, 16 product error, 31 product rest, 30 div, 11 less, 5 equal, 38 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline double ksl_mat3x3_solve_accurate(const ksl_mat3x3_t *A, const ksl_vec3_t *b,
    ksl_vec3_t *x) {
  const double divisor0 = 0.0 < A->m00 ? A->m00 : 1.0;
  const double l0_0 = A->m10 / divisor0, l0_0_product = KSL_MUL(l0_0, divisor0),
      l0_0_lo = (A->m10 - l0_0_product - ksl_product_error(l0_0, divisor0, l0_0_product))
          / divisor0;
  const double l0_1 = A->m20 / divisor0, l0_1_product = KSL_MUL(l0_1, divisor0),
      l0_1_lo = (A->m20 - l0_1_product - ksl_product_error(l0_1, divisor0, l0_1_product))
          / divisor0;
  const double u1_0a = KSL_MUL(A->m10, l0_0), u1_0 = A->m11 - u1_0a, u1_0_right = A->m11 - u1_0,
      u1_0_lo = A->m11 - (u1_0 + u1_0_right) - ksl_product_rest(A->m10, l0_0, u1_0a, u1_0_right)
          - KSL_MUL(A->m10, l0_0_lo);
  const double u1_1a = KSL_MUL(A->m20, l0_0), u1_1 = A->m21 - u1_1a, u1_1_right = A->m21 - u1_1,
      u1_1_lo = A->m21 - (u1_1 + u1_1_right) - ksl_product_rest(A->m20, l0_0, u1_1a, u1_1_right)
          - KSL_MUL(A->m20, l0_0_lo);
  const double u1_0_sum = u1_0 + u1_0_lo, u1_0_sum_right = u1_0_sum - u1_0,
      u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right),
      divisor1 = 0.0 < u1_0_sum ? u1_0_sum : 1.0, divisor1_lo = 0.0 < u1_0_sum ? u1_0_sum_lo : 0.0;
  const double u1_1_sum = u1_1 + u1_1_lo, u1_1_sum_right = u1_1_sum - u1_1,
      u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right),
      divisor1_sum = divisor1 + divisor1_lo, divisor1_sum_right = divisor1_sum - divisor1,
      divisor1_sum_lo = divisor1 - (divisor1_sum - divisor1_sum_right)
          + (divisor1_lo - divisor1_sum_right), l1 = u1_1_sum / divisor1_sum,
      l1_product = KSL_MUL(l1, divisor1_sum),
      l1_lo = (u1_1_sum - l1_product - ksl_product_error(l1, divisor1_sum, l1_product)
          + u1_1_sum_lo - KSL_MUL(l1, divisor1_sum_lo)) / divisor1_sum;
  const double u2a = KSL_MUL(A->m20, l0_1), u2b = A->m22 - u2a, u2b_right = A->m22 - u2b,
      u2c = KSL_MUL(u1_1_sum, l1), u2 = u2b - u2c, u2_right = u2b - u2,
      u2_lo2 = u2b - (u2 + u2_right) - ksl_product_rest(u1_1_sum, l1, u2c, u2_right)
          - (KSL_MUL(u1_1_sum_lo, l1) + KSL_MUL(u1_1_sum, l1_lo)),
      u2_lo = u2_lo2
          + (A->m22 - (u2b + u2b_right) - ksl_product_rest(A->m20, l0_1, u2a, u2b_right)
          - KSL_MUL(A->m20, l0_1_lo));
  const double u2_sum = u2 + u2_lo, u2_sum_right = u2_sum - u2,
      u2_sum_lo = u2 - (u2_sum - u2_sum_right) + (u2_lo - u2_sum_right),
      divisor2 = 0.0 < u2_sum ? u2_sum : 1.0, divisor2_lo = 0.0 < u2_sum ? u2_sum_lo : 0.0;
  const double part0a = A->m00 / divisor0, part0a_product = KSL_MUL(part0a, divisor0),
      part0a_lo = (A->m00 - part0a_product - ksl_product_error(part0a, divisor0, part0a_product))
          / divisor0, part0 = 0.0 < A->m00 ? part0a : A->m00,
      part0_lo = 0.0 < A->m00 ? part0a_lo : 0.0;
  const double own1 = 0.0 < A->m11 ? A->m11 : 1.0;
  const double part1a = u1_0_sum / own1, part1a_product = KSL_MUL(part1a, own1),
      part1a_lo = (u1_0_sum - part1a_product - ksl_product_error(part1a, own1, part1a_product)
          + u1_0_sum_lo) / own1, part1 = 0.0 < A->m11 ? part1a : A->m11,
      part1_lo = 0.0 < A->m11 ? part1a_lo : 0.0;
  const double part0_sum = part0 + part0_lo, part0_sum_right = part0_sum - part0,
      part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right),
      part1_sum = part1 + part1_lo, part1_sum_right = part1_sum - part1,
      part1_sum_lo = part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right),
      smallest1 = part0_sum < part1_sum ? part0_sum : part1_sum,
      smallest1_lo = part0_sum < part1_sum ? part0_sum_lo : part1_sum_lo;
  const double own2 = 0.0 < A->m22 ? A->m22 : 1.0;
  const double part2a = u2_sum / own2, part2a_product = KSL_MUL(part2a, own2),
      part2a_lo = (u2_sum - part2a_product - ksl_product_error(part2a, own2, part2a_product)
          + u2_sum_lo) / own2, part2 = 0.0 < A->m22 ? part2a : A->m22,
      part2_lo = 0.0 < A->m22 ? part2a_lo : 0.0;
  const double smallest1_sum = smallest1 + smallest1_lo,
      smallest1_sum_right = smallest1_sum - smallest1,
      smallest1_sum_lo = smallest1 - (smallest1_sum - smallest1_sum_right)
          + (smallest1_lo - smallest1_sum_right), part2_sum = part2 + part2_lo,
      part2_sum_right = part2_sum - part2,
      part2_sum_lo = part2 - (part2_sum - part2_sum_right) + (part2_lo - part2_sum_right),
      smallest2 = smallest1_sum < part2_sum ? smallest1_sum : part2_sum,
      smallest2_lo = smallest1_sum < part2_sum ? smallest1_sum_lo : part2_sum_lo;
  const double less_0 = KSL_MUL(A->m00, 0.9999999999999944),
      less_1 = KSL_MUL(A->m11, 0.9999999999999944), less_2 = KSL_MUL(A->m22, 0.9999999999999944);
  const double less_0_lo = ksl_product_error(A->m00, 0.9999999999999944, less_0),
      less_0_sum = less_0 + less_0_lo, less_0_sum_right = less_0_sum - less_0,
      less_0_sum_lo = less_0 - (less_0_sum - less_0_sum_right) + (less_0_lo - less_0_sum_right),
      less_divisor0 = 0.0 < less_0_sum ? less_0_sum : 1.0,
      less_divisor0_lo = 0.0 < less_0_sum ? less_0_sum_lo : 0.0;
  const double less_divisor0_sum = less_divisor0 + less_divisor0_lo,
      less_divisor0_sum_right = less_divisor0_sum - less_divisor0,
      less_divisor0_sum_lo = less_divisor0 - (less_divisor0_sum - less_divisor0_sum_right)
          + (less_divisor0_lo - less_divisor0_sum_right), less_l0_0 = A->m10 / less_divisor0_sum,
      less_l0_0_product = KSL_MUL(less_l0_0, less_divisor0_sum),
      less_l0_0_exact = A->m10 - less_l0_0_product
          - ksl_product_error(less_l0_0, less_divisor0_sum, less_l0_0_product),
      less_l0_0_lo = (less_l0_0_exact - KSL_MUL(less_l0_0, less_divisor0_sum_lo))
          / less_divisor0_sum;
  const double less_l0_1 = A->m20 / less_divisor0_sum,
      less_l0_1_product = KSL_MUL(less_l0_1, less_divisor0_sum),
      less_l0_1_exact = A->m20 - less_l0_1_product
          - ksl_product_error(less_l0_1, less_divisor0_sum, less_l0_1_product);
  const double less_u1_0a = KSL_MUL(A->m10, less_l0_0), less_u1_0 = less_1 - less_u1_0a,
      less_u1_0_right = less_1 - less_u1_0,
      less_u1_0_left_rest = ksl_product_rest(A->m11, 0.9999999999999944, less_1, less_u1_0
          + less_u1_0_right),
      less_u1_0_lo = less_u1_0_left_rest
          - ksl_product_rest(A->m10, less_l0_0, less_u1_0a, less_u1_0_right)
          - KSL_MUL(A->m10, less_l0_0_lo);
  const double less_u1_1a = KSL_MUL(A->m20, less_l0_0), less_u1_1 = A->m21 - less_u1_1a,
      less_u1_1_right = A->m21 - less_u1_1,
      less_u1_1_lo1 = A->m21 - (less_u1_1 + less_u1_1_right)
          - ksl_product_rest(A->m20, less_l0_0, less_u1_1a, less_u1_1_right),
      less_u1_1_lo = less_u1_1_lo1 - KSL_MUL(A->m20, less_l0_0_lo);
  const double less_u1_0_sum = less_u1_0 + less_u1_0_lo,
      less_u1_0_sum_right = less_u1_0_sum - less_u1_0,
      less_u1_0_sum_lo = less_u1_0 - (less_u1_0_sum - less_u1_0_sum_right)
          + (less_u1_0_lo - less_u1_0_sum_right),
      less_divisor1 = 0.0 < less_u1_0_sum ? less_u1_0_sum : 1.0,
      less_divisor1_lo = 0.0 < less_u1_0_sum ? less_u1_0_sum_lo : 0.0;
  const double less_u1_1_sum = less_u1_1 + less_u1_1_lo,
      less_u1_1_sum_right = less_u1_1_sum - less_u1_1,
      less_u1_1_sum_lo = less_u1_1 - (less_u1_1_sum - less_u1_1_sum_right)
          + (less_u1_1_lo - less_u1_1_sum_right),
      less_divisor1_sum = less_divisor1 + less_divisor1_lo,
      less_divisor1_sum_right = less_divisor1_sum - less_divisor1,
      less_l1 = less_u1_1_sum / less_divisor1_sum,
      less_l1_product = KSL_MUL(less_l1, less_divisor1_sum),
      less_l1_cross = KSL_MUL(less_l1, less_divisor1
          - (less_divisor1_sum - less_divisor1_sum_right)
          + (less_divisor1_lo - less_divisor1_sum_right)),
      less_l1_residual = less_u1_1_sum - less_l1_product
          - ksl_product_error(less_l1, less_divisor1_sum, less_l1_product) + less_u1_1_sum_lo
          - less_l1_cross;
  const double less_u2a = KSL_MUL(A->m20, less_l0_1), less_u2b = less_2 - less_u2a,
      less_u2b_right = less_2 - less_u2b,
      less_u2b_left_rest = ksl_product_rest(A->m22, 0.9999999999999944, less_2, less_u2b
          + less_u2b_right),
      less_u2a_cross2 = KSL_MUL(A->m20, (less_l0_1_exact
          - KSL_MUL(less_l0_1, less_divisor0_sum_lo)) / less_divisor0_sum),
      less_u2c = KSL_MUL(less_u1_1_sum, less_l1), less_u2 = less_u2b - less_u2c,
      less_u2_right = less_u2b - less_u2,
      less_u2_lo1 = less_u2b - (less_u2 + less_u2_right)
          - ksl_product_rest(less_u1_1_sum, less_l1, less_u2c, less_u2_right),
      less_u2_lo2 = less_u2_lo1
          - (KSL_MUL(less_u1_1_sum_lo, less_l1)
          + KSL_MUL(less_u1_1_sum, less_l1_residual / less_divisor1_sum));
  const double less_u2_sum = less_u2
          + (less_u2_lo2
          + (less_u2b_left_rest - ksl_product_rest(A->m20, less_l0_1, less_u2a, less_u2b_right)
          - less_u2a_cross2)), regular_b = 0.0 < less_u2_sum ? 1.0 : 0.0,
      regular_c = 0.0 < less_u1_0_sum ? regular_b : 0.0,
      regular = 0.0 < less_0_sum ? regular_c : 0.0;
  const double smallest2_sum = smallest2 + smallest2_lo,
      smallest2_sum_right = smallest2_sum - smallest2,
      smallest2_sum_lo = smallest2 - (smallest2_sum - smallest2_sum_right)
          + (smallest2_lo - smallest2_sum_right), least = smallest2_sum < 0.0 ? smallest2_sum : 0.0,
      least_lo = smallest2_sum < 0.0 ? smallest2_sum_lo : 0.0;
  const double y1a = KSL_MUL(b->x, l0_0), y1 = b->y - y1a, y1_right = b->y - y1,
      y1_lo = b->y - (y1 + y1_right) - ksl_product_rest(b->x, l0_0, y1a, y1_right)
          - KSL_MUL(b->x, l0_0_lo);
  const double y2a = KSL_MUL(b->x, l0_1), y2b = b->z - y2a, y2b_right = b->z - y2b,
      y2c = KSL_MUL(l1, y1), y2 = y2b - y2c, y2_right = y2b - y2,
      y2_lo2 = y2b - (y2 + y2_right) - ksl_product_rest(l1, y1, y2c, y2_right)
          - (KSL_MUL(l1_lo, y1) + KSL_MUL(l1, y1_lo)),
      y2_lo = y2_lo2
          + (b->z - (y2b + y2b_right) - ksl_product_rest(b->x, l0_1, y2a, y2b_right)
          - KSL_MUL(b->x, l0_1_lo));
  const double z0 = b->x / divisor0, z0_product = KSL_MUL(z0, divisor0);
  const double y1_sum = y1 + y1_lo, y1_sum_right = y1_sum - y1, z1 = y1_sum / divisor1_sum,
      z1_product = KSL_MUL(z1, divisor1_sum),
      z1_numerator = y1_sum - z1_product - ksl_product_error(z1, divisor1_sum, z1_product)
          + (y1 - (y1_sum - y1_sum_right) + (y1_lo - y1_sum_right));
  const double y2_sum = y2 + y2_lo, y2_sum_right = y2_sum - y2,
      divisor2_sum = divisor2 + divisor2_lo, divisor2_sum_right = divisor2_sum - divisor2,
      divisor2_sum_lo = divisor2 - (divisor2_sum - divisor2_sum_right)
          + (divisor2_lo - divisor2_sum_right), z2 = y2_sum / divisor2_sum,
      z2_product = KSL_MUL(z2, divisor2_sum),
      z2_numerator = y2_sum - z2_product - ksl_product_error(z2, divisor2_sum, z2_product)
          + (y2 - (y2_sum - y2_sum_right) + (y2_lo - y2_sum_right)),
      z2_lo = (z2_numerator - KSL_MUL(z2, divisor2_sum_lo)) / divisor2_sum;
  const double x1a = KSL_MUL(l1, z2), x1 = z1 - x1a, x1_right = z1 - x1,
      x1_lo2 = z1 - (x1 + x1_right) - ksl_product_rest(l1, z2, x1a, x1_right)
          - (KSL_MUL(l1_lo, z2) + KSL_MUL(l1, z2_lo)),
      x1_lo = x1_lo2 + (z1_numerator - KSL_MUL(z1, divisor1_sum_lo)) / divisor1_sum;
  const double x0a = KSL_MUL(l0_0, x1), x0b = z0 - x0a, x0b_right = z0 - x0b,
      x0b_lo2 = z0 - (x0b + x0b_right) - ksl_product_rest(l0_0, x1, x0a, x0b_right)
          - (KSL_MUL(l0_0_lo, x1) + KSL_MUL(l0_0, x1_lo)), x0c = KSL_MUL(l0_1, z2), x0 = x0b - x0c,
      x0_right = x0b - x0,
      x0_lo2 = x0b - (x0 + x0_right) - ksl_product_rest(l0_1, z2, x0c, x0_right)
          - (KSL_MUL(l0_1_lo, z2) + KSL_MUL(l0_1, z2_lo)),
      x0_lo = x0_lo2
          + (x0b_lo2 + (b->x - z0_product - ksl_product_error(z0, divisor0, z0_product))
          / divisor0);
  const double residual_0a = KSL_MUL(A->m00, x0), residual_0b = b->x - residual_0a,
      residual_0b_right = b->x - residual_0b, residual_0c = KSL_MUL(A->m10, x1),
      residual_0d = residual_0b - residual_0c, residual_0d_right = residual_0b - residual_0d,
      residual_0d_lo1 = residual_0b - (residual_0d + residual_0d_right)
          - ksl_product_rest(A->m10, x1, residual_0c, residual_0d_right),
      residual_0b_lo = b->x - (residual_0b + residual_0b_right)
          - ksl_product_rest(A->m00, x0, residual_0a, residual_0b_right) - KSL_MUL(A->m00, x0_lo),
      residual_0e = KSL_MUL(A->m20, z2), residual_0 = residual_0d - residual_0e,
      residual_0_right = residual_0d - residual_0,
      residual_0_lo2 = residual_0d - (residual_0 + residual_0_right)
          - ksl_product_rest(A->m20, z2, residual_0e, residual_0_right) - KSL_MUL(A->m20, z2_lo),
      residual_0_lo = residual_0_lo2 + (residual_0d_lo1 - KSL_MUL(A->m10, x1_lo) + residual_0b_lo);
  const double residual_1a = KSL_MUL(A->m10, x0), residual_1b = b->y - residual_1a,
      residual_1b_right = b->y - residual_1b, residual_1c = KSL_MUL(A->m11, x1),
      residual_1d = residual_1b - residual_1c, residual_1d_right = residual_1b - residual_1d,
      residual_1d_lo1 = residual_1b - (residual_1d + residual_1d_right)
          - ksl_product_rest(A->m11, x1, residual_1c, residual_1d_right),
      residual_1b_lo = b->y - (residual_1b + residual_1b_right)
          - ksl_product_rest(A->m10, x0, residual_1a, residual_1b_right) - KSL_MUL(A->m10, x0_lo),
      residual_1e = KSL_MUL(A->m21, z2), residual_1 = residual_1d - residual_1e,
      residual_1_right = residual_1d - residual_1,
      residual_1_lo2 = residual_1d - (residual_1 + residual_1_right)
          - ksl_product_rest(A->m21, z2, residual_1e, residual_1_right) - KSL_MUL(A->m21, z2_lo);
  const double residual_2a = KSL_MUL(A->m20, x0), residual_2b = b->z - residual_2a,
      residual_2b_right = b->z - residual_2b, residual_2c = KSL_MUL(A->m21, x1),
      residual_2d = residual_2b - residual_2c, residual_2d_right = residual_2b - residual_2d,
      residual_2d_lo1 = residual_2b - (residual_2d + residual_2d_right)
          - ksl_product_rest(A->m21, x1, residual_2c, residual_2d_right),
      residual_2b_lo = b->z - (residual_2b + residual_2b_right)
          - ksl_product_rest(A->m20, x0, residual_2a, residual_2b_right) - KSL_MUL(A->m20, x0_lo),
      residual_2e = KSL_MUL(A->m22, z2), residual_2 = residual_2d - residual_2e,
      residual_2_right = residual_2d - residual_2,
      residual_2_lo2 = residual_2d - (residual_2 + residual_2_right)
          - ksl_product_rest(A->m22, z2, residual_2e, residual_2_right) - KSL_MUL(A->m22, z2_lo);
  const double refined_y1a = KSL_MUL(l0_0, residual_0), refined_y1 = residual_1 - refined_y1a,
      refined_y1_right = residual_1 - refined_y1,
      refined_y1_lo1 = residual_1 - (refined_y1 + refined_y1_right)
          - ksl_product_rest(l0_0, residual_0, refined_y1a, refined_y1_right),
      refined_y1_lo2 = refined_y1_lo1
          - (KSL_MUL(l0_0_lo, residual_0) + KSL_MUL(l0_0, residual_0_lo)),
      refined_y1_lo = refined_y1_lo2
          + (residual_1_lo2 + (residual_1d_lo1 - KSL_MUL(A->m11, x1_lo) + residual_1b_lo));
  const double refined_y2a = KSL_MUL(l0_1, residual_0), refined_y2b = residual_2 - refined_y2a,
      refined_y2b_right = residual_2 - refined_y2b,
      refined_y2b_lo1 = residual_2 - (refined_y2b + refined_y2b_right)
          - ksl_product_rest(l0_1, residual_0, refined_y2a, refined_y2b_right),
      refined_y2b_lo2 = refined_y2b_lo1
          - (KSL_MUL(l0_1_lo, residual_0) + KSL_MUL(l0_1, residual_0_lo)),
      refined_y2c = KSL_MUL(l1, refined_y1), refined_y2 = refined_y2b - refined_y2c,
      refined_y2_right = refined_y2b - refined_y2,
      refined_y2_lo1 = refined_y2b - (refined_y2 + refined_y2_right)
          - ksl_product_rest(l1, refined_y1, refined_y2c, refined_y2_right),
      refined_y2b_lo = refined_y2b_lo2
          + (residual_2_lo2 + (residual_2d_lo1 - KSL_MUL(A->m21, x1_lo) + residual_2b_lo)),
      refined_y2_lo = refined_y2_lo1 - (KSL_MUL(l1_lo, refined_y1) + KSL_MUL(l1, refined_y1_lo))
          + refined_y2b_lo;
  const double residual_0_sum = residual_0 + residual_0_lo,
      residual_0_sum_right = residual_0_sum - residual_0, refined_z0 = residual_0_sum / divisor0,
      refined_z0_product = KSL_MUL(refined_z0, divisor0),
      refined_z0_exact = residual_0_sum - refined_z0_product
          - ksl_product_error(refined_z0, divisor0, refined_z0_product);
  const double refined_y1_sum = refined_y1 + refined_y1_lo,
      refined_y1_sum_right = refined_y1_sum - refined_y1,
      refined_z1 = refined_y1_sum / divisor1_sum,
      refined_z1_product = KSL_MUL(refined_z1, divisor1_sum),
      refined_z1_exact = refined_y1_sum - refined_z1_product
          - ksl_product_error(refined_z1, divisor1_sum, refined_z1_product),
      refined_z1_numerator = refined_z1_exact
          + (refined_y1 - (refined_y1_sum - refined_y1_sum_right)
          + (refined_y1_lo - refined_y1_sum_right));
  const double refined_y2_sum = refined_y2 + refined_y2_lo,
      refined_y2_sum_right = refined_y2_sum - refined_y2,
      refined_z2 = refined_y2_sum / divisor2_sum,
      refined_z2_product = KSL_MUL(refined_z2, divisor2_sum),
      refined_z2_exact = refined_y2_sum - refined_z2_product
          - ksl_product_error(refined_z2, divisor2_sum, refined_z2_product),
      refined_z2_numerator = refined_z2_exact
          + (refined_y2 - (refined_y2_sum - refined_y2_sum_right)
          + (refined_y2_lo - refined_y2_sum_right)),
      refined_z2_lo = (refined_z2_numerator - KSL_MUL(refined_z2, divisor2_sum_lo)) / divisor2_sum;
  const double refined_x1a = KSL_MUL(l1, refined_z2), refined_x1 = refined_z1 - refined_x1a,
      refined_x1_right = refined_z1 - refined_x1,
      refined_x1_lo1 = refined_z1 - (refined_x1 + refined_x1_right)
          - ksl_product_rest(l1, refined_z2, refined_x1a, refined_x1_right);
  const double refined_z1_lo = (refined_z1_numerator - KSL_MUL(refined_z1, divisor1_sum_lo))
          / divisor1_sum;
  const double refined_x1_lo = refined_x1_lo1
          - (KSL_MUL(l1_lo, refined_z2) + KSL_MUL(l1, refined_z2_lo)) + refined_z1_lo;
  const double refined_x0a = KSL_MUL(l0_0, refined_x1), refined_x0b = refined_z0 - refined_x0a,
      refined_x0b_right = refined_z0 - refined_x0b,
      refined_x0b_lo1 = refined_z0 - (refined_x0b + refined_x0b_right)
          - ksl_product_rest(l0_0, refined_x1, refined_x0a, refined_x0b_right);
  const double refined_z0_lo = (refined_z0_exact
          + (residual_0 - (residual_0_sum - residual_0_sum_right)
          + (residual_0_lo - residual_0_sum_right))) / divisor0;
  const double refined_x0c = KSL_MUL(l0_1, refined_z2), refined_x0 = refined_x0b - refined_x0c,
      refined_x0_right = refined_x0b - refined_x0,
      refined_x0_lo1 = refined_x0b - (refined_x0 + refined_x0_right)
          - ksl_product_rest(l0_1, refined_z2, refined_x0c, refined_x0_right),
      refined_x0b_lo = refined_x0b_lo1
          - (KSL_MUL(l0_0_lo, refined_x1) + KSL_MUL(l0_0, refined_x1_lo)) + refined_z0_lo;
  const double found_0 = x0 + refined_x0, found_0_right = found_0 - x0;
  const double refined_x0_lo = refined_x0_lo1
          - (KSL_MUL(l0_1_lo, refined_z2) + KSL_MUL(l0_1, refined_z2_lo)) + refined_x0b_lo;
  const double found_0_lo = x0 - (found_0 - found_0_right) + (refined_x0 - found_0_right)
          + refined_x0_lo + x0_lo;
  const double found_1 = x1 + refined_x1, found_1_right = found_1 - x1,
      found_1_lo = x1 - (found_1 - found_1_right) + (refined_x1 - found_1_right) + refined_x1_lo
          + x1_lo;
  const double found_2 = z2 + refined_z2, found_2_right = found_2 - z2,
      found_2_lo = z2 - (found_2 - found_2_right) + (refined_z2 - found_2_right) + refined_z2_lo
          + z2_lo;
  const double pivot = regular == 1.0 ? smallest2_sum : least;
  const double x_0 = regular == 1.0 ? found_0 : (double)NAN,
      x_1 = regular == 1.0 ? found_1 : (double)NAN, x_2 = regular == 1.0 ? found_2 : (double)NAN;
  const double pivot_rounded = pivot + (regular == 1.0 ? smallest2_sum_lo : least_lo);
  const double x_0_rounded = x_0 + (regular == 1.0 ? found_0_lo : 0.0);
  const double x_1_rounded = x_1 + (regular == 1.0 ? found_1_lo : 0.0);
  const double x_2_rounded = x_2 + (regular == 1.0 ? found_2_lo : 0.0);
  const double pivot_final = pivot_rounded == pivot_rounded ? pivot_rounded : pivot;
  const double x_0_final = x_0_rounded == x_0_rounded ? x_0_rounded : x_0;
  const double x_1_final = x_1_rounded == x_1_rounded ? x_1_rounded : x_1;
  const double x_2_final = x_2_rounded == x_2_rounded ? x_2_rounded : x_2;
  x->x = x_0_final;
  x->y = x_1_final;
  x->z = x_2_final;
  return pivot_final;
}

/* L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
     triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
     not positive definite, and L is meaningless.
   A, L: 6×6 operator.
   121 mul, 512 add, 21 product error, 35 product rest, 42 div, 15 less, 21 equal, 57 select.
   |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline double ksl_mat6x6_ldl_accurate(const ksl_mat6x6_t *A, ksl_mat6x6_t *L) {
  const double divisor0 = 0.0 < A->at[0][0] ? A->at[0][0] : 1.0;
  const double l0_0 = A->at[0][1] / divisor0, l0_0_product = KSL_MUL(l0_0, divisor0),
      l0_0_lo = (A->at[0][1] - l0_0_product - ksl_product_error(l0_0, divisor0, l0_0_product))
          / divisor0;
  const double l0_1 = A->at[0][2] / divisor0, l0_1_product = KSL_MUL(l0_1, divisor0),
      l0_1_lo = (A->at[0][2] - l0_1_product - ksl_product_error(l0_1, divisor0, l0_1_product))
          / divisor0;
  const double l0_2 = A->at[0][3] / divisor0, l0_2_product = KSL_MUL(l0_2, divisor0),
      l0_2_lo = (A->at[0][3] - l0_2_product - ksl_product_error(l0_2, divisor0, l0_2_product))
          / divisor0;
  const double l0_3 = A->at[0][4] / divisor0, l0_3_product = KSL_MUL(l0_3, divisor0),
      l0_3_lo = (A->at[0][4] - l0_3_product - ksl_product_error(l0_3, divisor0, l0_3_product))
          / divisor0;
  const double l0_4 = A->at[0][5] / divisor0, l0_4_product = KSL_MUL(l0_4, divisor0),
      l0_4_lo = (A->at[0][5] - l0_4_product - ksl_product_error(l0_4, divisor0, l0_4_product))
          / divisor0;
  const double u1_0a = KSL_MUL(A->at[0][1], l0_0), u1_0 = A->at[1][1] - u1_0a,
      u1_0_right = A->at[1][1] - u1_0,
      u1_0_lo = A->at[1][1] - (u1_0 + u1_0_right)
          - ksl_product_rest(A->at[0][1], l0_0, u1_0a, u1_0_right) - KSL_MUL(A->at[0][1], l0_0_lo);
  const double u1_1a = KSL_MUL(A->at[0][2], l0_0), u1_1 = A->at[1][2] - u1_1a,
      u1_1_right = A->at[1][2] - u1_1,
      u1_1_lo = A->at[1][2] - (u1_1 + u1_1_right)
          - ksl_product_rest(A->at[0][2], l0_0, u1_1a, u1_1_right) - KSL_MUL(A->at[0][2], l0_0_lo);
  const double u1_2a = KSL_MUL(A->at[0][3], l0_0), u1_2 = A->at[1][3] - u1_2a,
      u1_2_right = A->at[1][3] - u1_2,
      u1_2_lo = A->at[1][3] - (u1_2 + u1_2_right)
          - ksl_product_rest(A->at[0][3], l0_0, u1_2a, u1_2_right) - KSL_MUL(A->at[0][3], l0_0_lo);
  const double u1_3a = KSL_MUL(A->at[0][4], l0_0), u1_3 = A->at[1][4] - u1_3a,
      u1_3_right = A->at[1][4] - u1_3,
      u1_3_lo = A->at[1][4] - (u1_3 + u1_3_right)
          - ksl_product_rest(A->at[0][4], l0_0, u1_3a, u1_3_right) - KSL_MUL(A->at[0][4], l0_0_lo);
  const double u1_4a = KSL_MUL(A->at[0][5], l0_0), u1_4 = A->at[1][5] - u1_4a,
      u1_4_right = A->at[1][5] - u1_4,
      u1_4_lo = A->at[1][5] - (u1_4 + u1_4_right)
          - ksl_product_rest(A->at[0][5], l0_0, u1_4a, u1_4_right) - KSL_MUL(A->at[0][5], l0_0_lo);
  const double u1_0_sum = u1_0 + u1_0_lo, u1_0_sum_right = u1_0_sum - u1_0,
      u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right),
      divisor1 = 0.0 < u1_0_sum ? u1_0_sum : 1.0, divisor1_lo = 0.0 < u1_0_sum ? u1_0_sum_lo : 0.0;
  const double u1_1_sum = u1_1 + u1_1_lo, u1_1_sum_right = u1_1_sum - u1_1,
      u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right),
      divisor1_sum = divisor1 + divisor1_lo, divisor1_sum_right = divisor1_sum - divisor1,
      divisor1_sum_lo = divisor1 - (divisor1_sum - divisor1_sum_right)
          + (divisor1_lo - divisor1_sum_right), l1_0 = u1_1_sum / divisor1_sum,
      l1_0_product = KSL_MUL(l1_0, divisor1_sum),
      l1_0_residual = u1_1_sum - l1_0_product - ksl_product_error(l1_0, divisor1_sum, l1_0_product)
          + u1_1_sum_lo - KSL_MUL(l1_0, divisor1_sum_lo), l1_0_lo = l1_0_residual / divisor1_sum;
  const double u1_2_sum = u1_2 + u1_2_lo, u1_2_sum_right = u1_2_sum - u1_2,
      u1_2_sum_lo = u1_2 - (u1_2_sum - u1_2_sum_right) + (u1_2_lo - u1_2_sum_right),
      l1_1 = u1_2_sum / divisor1_sum, l1_1_product = KSL_MUL(l1_1, divisor1_sum),
      l1_1_residual = u1_2_sum - l1_1_product - ksl_product_error(l1_1, divisor1_sum, l1_1_product)
          + u1_2_sum_lo - KSL_MUL(l1_1, divisor1_sum_lo), l1_1_lo = l1_1_residual / divisor1_sum;
  const double u1_3_sum = u1_3 + u1_3_lo, u1_3_sum_right = u1_3_sum - u1_3,
      u1_3_sum_lo = u1_3 - (u1_3_sum - u1_3_sum_right) + (u1_3_lo - u1_3_sum_right),
      l1_2 = u1_3_sum / divisor1_sum, l1_2_product = KSL_MUL(l1_2, divisor1_sum),
      l1_2_residual = u1_3_sum - l1_2_product - ksl_product_error(l1_2, divisor1_sum, l1_2_product)
          + u1_3_sum_lo - KSL_MUL(l1_2, divisor1_sum_lo), l1_2_lo = l1_2_residual / divisor1_sum;
  const double u1_4_sum = u1_4 + u1_4_lo, u1_4_sum_right = u1_4_sum - u1_4,
      u1_4_sum_lo = u1_4 - (u1_4_sum - u1_4_sum_right) + (u1_4_lo - u1_4_sum_right),
      l1_3 = u1_4_sum / divisor1_sum, l1_3_product = KSL_MUL(l1_3, divisor1_sum),
      l1_3_residual = u1_4_sum - l1_3_product - ksl_product_error(l1_3, divisor1_sum, l1_3_product)
          + u1_4_sum_lo - KSL_MUL(l1_3, divisor1_sum_lo), l1_3_lo = l1_3_residual / divisor1_sum;
  const double u2_0a = KSL_MUL(A->at[0][2], l0_1), u2_0b = A->at[2][2] - u2_0a,
      u2_0b_right = A->at[2][2] - u2_0b, u2_0c = KSL_MUL(u1_1_sum, l1_0), u2_0 = u2_0b - u2_0c,
      u2_0_right = u2_0b - u2_0,
      u2_0_lo1 = u2_0b - (u2_0 + u2_0_right) - ksl_product_rest(u1_1_sum, l1_0, u2_0c, u2_0_right),
      u2_0b_lo = A->at[2][2] - (u2_0b + u2_0b_right)
          - ksl_product_rest(A->at[0][2], l0_1, u2_0a, u2_0b_right) - KSL_MUL(A->at[0][2], l0_1_lo),
      u2_0_lo = u2_0_lo1 - (KSL_MUL(u1_1_sum_lo, l1_0) + KSL_MUL(u1_1_sum, l1_0_lo)) + u2_0b_lo;
  const double u2_1a = KSL_MUL(A->at[0][3], l0_1), u2_1b = A->at[2][3] - u2_1a,
      u2_1b_right = A->at[2][3] - u2_1b, u2_1c = KSL_MUL(u1_2_sum, l1_0), u2_1 = u2_1b - u2_1c,
      u2_1_right = u2_1b - u2_1,
      u2_1_lo1 = u2_1b - (u2_1 + u2_1_right) - ksl_product_rest(u1_2_sum, l1_0, u2_1c, u2_1_right),
      u2_1b_lo = A->at[2][3] - (u2_1b + u2_1b_right)
          - ksl_product_rest(A->at[0][3], l0_1, u2_1a, u2_1b_right) - KSL_MUL(A->at[0][3], l0_1_lo),
      u2_1_lo = u2_1_lo1 - (KSL_MUL(u1_2_sum_lo, l1_0) + KSL_MUL(u1_2_sum, l1_0_lo)) + u2_1b_lo;
  const double u2_2a = KSL_MUL(A->at[0][4], l0_1), u2_2b = A->at[2][4] - u2_2a,
      u2_2b_right = A->at[2][4] - u2_2b, u2_2c = KSL_MUL(u1_3_sum, l1_0), u2_2 = u2_2b - u2_2c,
      u2_2_right = u2_2b - u2_2,
      u2_2_lo1 = u2_2b - (u2_2 + u2_2_right) - ksl_product_rest(u1_3_sum, l1_0, u2_2c, u2_2_right),
      u2_2b_lo = A->at[2][4] - (u2_2b + u2_2b_right)
          - ksl_product_rest(A->at[0][4], l0_1, u2_2a, u2_2b_right) - KSL_MUL(A->at[0][4], l0_1_lo),
      u2_2_lo = u2_2_lo1 - (KSL_MUL(u1_3_sum_lo, l1_0) + KSL_MUL(u1_3_sum, l1_0_lo)) + u2_2b_lo;
  const double u2_3a = KSL_MUL(A->at[0][5], l0_1), u2_3b = A->at[2][5] - u2_3a,
      u2_3b_right = A->at[2][5] - u2_3b, u2_3c = KSL_MUL(u1_4_sum, l1_0), u2_3 = u2_3b - u2_3c,
      u2_3_right = u2_3b - u2_3,
      u2_3_lo1 = u2_3b - (u2_3 + u2_3_right) - ksl_product_rest(u1_4_sum, l1_0, u2_3c, u2_3_right),
      u2_3b_lo = A->at[2][5] - (u2_3b + u2_3b_right)
          - ksl_product_rest(A->at[0][5], l0_1, u2_3a, u2_3b_right) - KSL_MUL(A->at[0][5], l0_1_lo),
      u2_3_lo = u2_3_lo1 - (KSL_MUL(u1_4_sum_lo, l1_0) + KSL_MUL(u1_4_sum, l1_0_lo)) + u2_3b_lo;
  const double u2_0_sum = u2_0 + u2_0_lo, u2_0_sum_right = u2_0_sum - u2_0,
      u2_0_sum_lo = u2_0 - (u2_0_sum - u2_0_sum_right) + (u2_0_lo - u2_0_sum_right),
      divisor2 = 0.0 < u2_0_sum ? u2_0_sum : 1.0, divisor2_lo = 0.0 < u2_0_sum ? u2_0_sum_lo : 0.0;
  const double u2_1_sum = u2_1 + u2_1_lo, u2_1_sum_right = u2_1_sum - u2_1,
      u2_1_sum_lo = u2_1 - (u2_1_sum - u2_1_sum_right) + (u2_1_lo - u2_1_sum_right),
      divisor2_sum = divisor2 + divisor2_lo, divisor2_sum_right = divisor2_sum - divisor2,
      divisor2_sum_lo = divisor2 - (divisor2_sum - divisor2_sum_right)
          + (divisor2_lo - divisor2_sum_right), l2_0 = u2_1_sum / divisor2_sum,
      l2_0_product = KSL_MUL(l2_0, divisor2_sum),
      l2_0_residual = u2_1_sum - l2_0_product - ksl_product_error(l2_0, divisor2_sum, l2_0_product)
          + u2_1_sum_lo - KSL_MUL(l2_0, divisor2_sum_lo), l2_0_lo = l2_0_residual / divisor2_sum;
  const double u2_2_sum = u2_2 + u2_2_lo, u2_2_sum_right = u2_2_sum - u2_2,
      u2_2_sum_lo = u2_2 - (u2_2_sum - u2_2_sum_right) + (u2_2_lo - u2_2_sum_right),
      l2_1 = u2_2_sum / divisor2_sum, l2_1_product = KSL_MUL(l2_1, divisor2_sum),
      l2_1_residual = u2_2_sum - l2_1_product - ksl_product_error(l2_1, divisor2_sum, l2_1_product)
          + u2_2_sum_lo - KSL_MUL(l2_1, divisor2_sum_lo), l2_1_lo = l2_1_residual / divisor2_sum;
  const double u2_3_sum = u2_3 + u2_3_lo, u2_3_sum_right = u2_3_sum - u2_3,
      u2_3_sum_lo = u2_3 - (u2_3_sum - u2_3_sum_right) + (u2_3_lo - u2_3_sum_right),
      l2_2 = u2_3_sum / divisor2_sum, l2_2_product = KSL_MUL(l2_2, divisor2_sum),
      l2_2_residual = u2_3_sum - l2_2_product - ksl_product_error(l2_2, divisor2_sum, l2_2_product)
          + u2_3_sum_lo - KSL_MUL(l2_2, divisor2_sum_lo), l2_2_lo = l2_2_residual / divisor2_sum;
  const double u3_0a = KSL_MUL(A->at[0][3], l0_2), u3_0b = A->at[3][3] - u3_0a,
      u3_0b_right = A->at[3][3] - u3_0b, u3_0c = KSL_MUL(u1_2_sum, l1_1), u3_0d = u3_0b - u3_0c,
      u3_0d_right = u3_0b - u3_0d,
      u3_0d_lo1 = u3_0b - (u3_0d + u3_0d_right)
          - ksl_product_rest(u1_2_sum, l1_1, u3_0c, u3_0d_right),
      u3_0b_lo = A->at[3][3] - (u3_0b + u3_0b_right)
          - ksl_product_rest(A->at[0][3], l0_2, u3_0a, u3_0b_right) - KSL_MUL(A->at[0][3], l0_2_lo),
      u3_0e = KSL_MUL(u2_1_sum, l2_0), u3_0 = u3_0d - u3_0e, u3_0_right = u3_0d - u3_0,
      u3_0_lo1 = u3_0d - (u3_0 + u3_0_right) - ksl_product_rest(u2_1_sum, l2_0, u3_0e, u3_0_right),
      u3_0d_lo = u3_0d_lo1 - (KSL_MUL(u1_2_sum_lo, l1_1) + KSL_MUL(u1_2_sum, l1_1_lo)) + u3_0b_lo,
      u3_0_lo = u3_0_lo1 - (KSL_MUL(u2_1_sum_lo, l2_0) + KSL_MUL(u2_1_sum, l2_0_lo)) + u3_0d_lo;
  const double u3_1a = KSL_MUL(A->at[0][4], l0_2), u3_1b = A->at[3][4] - u3_1a,
      u3_1b_right = A->at[3][4] - u3_1b, u3_1c = KSL_MUL(u1_3_sum, l1_1), u3_1d = u3_1b - u3_1c,
      u3_1d_right = u3_1b - u3_1d,
      u3_1d_lo1 = u3_1b - (u3_1d + u3_1d_right)
          - ksl_product_rest(u1_3_sum, l1_1, u3_1c, u3_1d_right),
      u3_1b_lo = A->at[3][4] - (u3_1b + u3_1b_right)
          - ksl_product_rest(A->at[0][4], l0_2, u3_1a, u3_1b_right) - KSL_MUL(A->at[0][4], l0_2_lo),
      u3_1e = KSL_MUL(u2_2_sum, l2_0), u3_1 = u3_1d - u3_1e, u3_1_right = u3_1d - u3_1,
      u3_1_lo1 = u3_1d - (u3_1 + u3_1_right) - ksl_product_rest(u2_2_sum, l2_0, u3_1e, u3_1_right),
      u3_1d_lo = u3_1d_lo1 - (KSL_MUL(u1_3_sum_lo, l1_1) + KSL_MUL(u1_3_sum, l1_1_lo)) + u3_1b_lo,
      u3_1_lo = u3_1_lo1 - (KSL_MUL(u2_2_sum_lo, l2_0) + KSL_MUL(u2_2_sum, l2_0_lo)) + u3_1d_lo;
  const double u3_2a = KSL_MUL(A->at[0][5], l0_2), u3_2b = A->at[3][5] - u3_2a,
      u3_2b_right = A->at[3][5] - u3_2b, u3_2c = KSL_MUL(u1_4_sum, l1_1), u3_2d = u3_2b - u3_2c,
      u3_2d_right = u3_2b - u3_2d,
      u3_2d_lo1 = u3_2b - (u3_2d + u3_2d_right)
          - ksl_product_rest(u1_4_sum, l1_1, u3_2c, u3_2d_right),
      u3_2b_lo = A->at[3][5] - (u3_2b + u3_2b_right)
          - ksl_product_rest(A->at[0][5], l0_2, u3_2a, u3_2b_right) - KSL_MUL(A->at[0][5], l0_2_lo),
      u3_2e = KSL_MUL(u2_3_sum, l2_0), u3_2 = u3_2d - u3_2e, u3_2_right = u3_2d - u3_2,
      u3_2_lo1 = u3_2d - (u3_2 + u3_2_right) - ksl_product_rest(u2_3_sum, l2_0, u3_2e, u3_2_right),
      u3_2d_lo = u3_2d_lo1 - (KSL_MUL(u1_4_sum_lo, l1_1) + KSL_MUL(u1_4_sum, l1_1_lo)) + u3_2b_lo,
      u3_2_lo = u3_2_lo1 - (KSL_MUL(u2_3_sum_lo, l2_0) + KSL_MUL(u2_3_sum, l2_0_lo)) + u3_2d_lo;
  const double u3_0_sum = u3_0 + u3_0_lo, u3_0_sum_right = u3_0_sum - u3_0,
      u3_0_sum_lo = u3_0 - (u3_0_sum - u3_0_sum_right) + (u3_0_lo - u3_0_sum_right),
      divisor3 = 0.0 < u3_0_sum ? u3_0_sum : 1.0, divisor3_lo = 0.0 < u3_0_sum ? u3_0_sum_lo : 0.0;
  const double u3_1_sum = u3_1 + u3_1_lo, u3_1_sum_right = u3_1_sum - u3_1,
      u3_1_sum_lo = u3_1 - (u3_1_sum - u3_1_sum_right) + (u3_1_lo - u3_1_sum_right),
      divisor3_sum = divisor3 + divisor3_lo, divisor3_sum_right = divisor3_sum - divisor3,
      divisor3_sum_lo = divisor3 - (divisor3_sum - divisor3_sum_right)
          + (divisor3_lo - divisor3_sum_right), l3_0 = u3_1_sum / divisor3_sum,
      l3_0_product = KSL_MUL(l3_0, divisor3_sum),
      l3_0_residual = u3_1_sum - l3_0_product - ksl_product_error(l3_0, divisor3_sum, l3_0_product)
          + u3_1_sum_lo - KSL_MUL(l3_0, divisor3_sum_lo), l3_0_lo = l3_0_residual / divisor3_sum;
  const double u3_2_sum = u3_2 + u3_2_lo, u3_2_sum_right = u3_2_sum - u3_2,
      u3_2_sum_lo = u3_2 - (u3_2_sum - u3_2_sum_right) + (u3_2_lo - u3_2_sum_right),
      l3_1 = u3_2_sum / divisor3_sum, l3_1_product = KSL_MUL(l3_1, divisor3_sum),
      l3_1_residual = u3_2_sum - l3_1_product - ksl_product_error(l3_1, divisor3_sum, l3_1_product)
          + u3_2_sum_lo - KSL_MUL(l3_1, divisor3_sum_lo), l3_1_lo = l3_1_residual / divisor3_sum;
  const double u4_0a = KSL_MUL(A->at[0][4], l0_3), u4_0b = A->at[4][4] - u4_0a,
      u4_0b_right = A->at[4][4] - u4_0b, u4_0c = KSL_MUL(u1_3_sum, l1_2), u4_0d = u4_0b - u4_0c,
      u4_0d_right = u4_0b - u4_0d,
      u4_0d_lo1 = u4_0b - (u4_0d + u4_0d_right)
          - ksl_product_rest(u1_3_sum, l1_2, u4_0c, u4_0d_right),
      u4_0b_lo = A->at[4][4] - (u4_0b + u4_0b_right)
          - ksl_product_rest(A->at[0][4], l0_3, u4_0a, u4_0b_right) - KSL_MUL(A->at[0][4], l0_3_lo),
      u4_0e = KSL_MUL(u2_2_sum, l2_1), u4_0f = u4_0d - u4_0e, u4_0f_right = u4_0d - u4_0f,
      u4_0f_lo1 = u4_0d - (u4_0f + u4_0f_right)
          - ksl_product_rest(u2_2_sum, l2_1, u4_0e, u4_0f_right),
      u4_0d_lo = u4_0d_lo1 - (KSL_MUL(u1_3_sum_lo, l1_2) + KSL_MUL(u1_3_sum, l1_2_lo)) + u4_0b_lo,
      u4_0g = KSL_MUL(u3_1_sum, l3_0), u4_0 = u4_0f - u4_0g, u4_0_right = u4_0f - u4_0,
      u4_0_lo1 = u4_0f - (u4_0 + u4_0_right) - ksl_product_rest(u3_1_sum, l3_0, u4_0g, u4_0_right),
      u4_0f_lo = u4_0f_lo1 - (KSL_MUL(u2_2_sum_lo, l2_1) + KSL_MUL(u2_2_sum, l2_1_lo)) + u4_0d_lo,
      u4_0_lo = u4_0_lo1 - (KSL_MUL(u3_1_sum_lo, l3_0) + KSL_MUL(u3_1_sum, l3_0_lo)) + u4_0f_lo;
  const double u4_1a = KSL_MUL(A->at[0][5], l0_3), u4_1b = A->at[4][5] - u4_1a,
      u4_1b_right = A->at[4][5] - u4_1b, u4_1c = KSL_MUL(u1_4_sum, l1_2), u4_1d = u4_1b - u4_1c,
      u4_1d_right = u4_1b - u4_1d,
      u4_1d_lo1 = u4_1b - (u4_1d + u4_1d_right)
          - ksl_product_rest(u1_4_sum, l1_2, u4_1c, u4_1d_right),
      u4_1b_lo = A->at[4][5] - (u4_1b + u4_1b_right)
          - ksl_product_rest(A->at[0][5], l0_3, u4_1a, u4_1b_right) - KSL_MUL(A->at[0][5], l0_3_lo),
      u4_1e = KSL_MUL(u2_3_sum, l2_1), u4_1f = u4_1d - u4_1e, u4_1f_right = u4_1d - u4_1f,
      u4_1f_lo1 = u4_1d - (u4_1f + u4_1f_right)
          - ksl_product_rest(u2_3_sum, l2_1, u4_1e, u4_1f_right),
      u4_1d_lo = u4_1d_lo1 - (KSL_MUL(u1_4_sum_lo, l1_2) + KSL_MUL(u1_4_sum, l1_2_lo)) + u4_1b_lo,
      u4_1g = KSL_MUL(u3_2_sum, l3_0), u4_1 = u4_1f - u4_1g, u4_1_right = u4_1f - u4_1,
      u4_1_lo1 = u4_1f - (u4_1 + u4_1_right) - ksl_product_rest(u3_2_sum, l3_0, u4_1g, u4_1_right),
      u4_1f_lo = u4_1f_lo1 - (KSL_MUL(u2_3_sum_lo, l2_1) + KSL_MUL(u2_3_sum, l2_1_lo)) + u4_1d_lo,
      u4_1_lo = u4_1_lo1 - (KSL_MUL(u3_2_sum_lo, l3_0) + KSL_MUL(u3_2_sum, l3_0_lo)) + u4_1f_lo;
  const double u4_0_sum = u4_0 + u4_0_lo, u4_0_sum_right = u4_0_sum - u4_0,
      u4_0_sum_lo = u4_0 - (u4_0_sum - u4_0_sum_right) + (u4_0_lo - u4_0_sum_right),
      divisor4 = 0.0 < u4_0_sum ? u4_0_sum : 1.0, divisor4_lo = 0.0 < u4_0_sum ? u4_0_sum_lo : 0.0;
  const double u4_1_sum = u4_1 + u4_1_lo, u4_1_sum_right = u4_1_sum - u4_1,
      u4_1_sum_lo = u4_1 - (u4_1_sum - u4_1_sum_right) + (u4_1_lo - u4_1_sum_right),
      divisor4_sum = divisor4 + divisor4_lo, divisor4_sum_right = divisor4_sum - divisor4,
      l4 = u4_1_sum / divisor4_sum, l4_product = KSL_MUL(l4, divisor4_sum),
      l4_cross = KSL_MUL(l4, divisor4 - (divisor4_sum - divisor4_sum_right)
          + (divisor4_lo - divisor4_sum_right)),
      l4_lo = (u4_1_sum - l4_product - ksl_product_error(l4, divisor4_sum, l4_product)
          + u4_1_sum_lo - l4_cross) / divisor4_sum;
  const double u5a = KSL_MUL(A->at[0][5], l0_4), u5b = A->at[5][5] - u5a,
      u5b_right = A->at[5][5] - u5b, u5c = KSL_MUL(u1_4_sum, l1_3), u5d = u5b - u5c,
      u5d_right = u5b - u5d,
      u5d_lo2 = u5b - (u5d + u5d_right) - ksl_product_rest(u1_4_sum, l1_3, u5c, u5d_right)
          - (KSL_MUL(u1_4_sum_lo, l1_3) + KSL_MUL(u1_4_sum, l1_3_lo)),
      u5e = KSL_MUL(u2_3_sum, l2_2), u5f = u5d - u5e, u5f_right = u5d - u5f,
      u5f_lo2 = u5d - (u5f + u5f_right) - ksl_product_rest(u2_3_sum, l2_2, u5e, u5f_right)
          - (KSL_MUL(u2_3_sum_lo, l2_2) + KSL_MUL(u2_3_sum, l2_2_lo)),
      u5g = KSL_MUL(u3_2_sum, l3_1), u5h = u5f - u5g, u5h_right = u5f - u5h,
      u5f_lo = u5f_lo2
          + (u5d_lo2
          + (A->at[5][5] - (u5b + u5b_right) - ksl_product_rest(A->at[0][5], l0_4, u5a, u5b_right)
          - KSL_MUL(A->at[0][5], l0_4_lo))),
      u5h_lo2 = u5f - (u5h + u5h_right) - ksl_product_rest(u3_2_sum, l3_1, u5g, u5h_right)
          - (KSL_MUL(u3_2_sum_lo, l3_1) + KSL_MUL(u3_2_sum, l3_1_lo)), u5i = KSL_MUL(u4_1_sum, l4),
      u5 = u5h - u5i, u5_right = u5h - u5,
      u5_lo2 = u5h - (u5 + u5_right) - ksl_product_rest(u4_1_sum, l4, u5i, u5_right)
          - (KSL_MUL(u4_1_sum_lo, l4) + KSL_MUL(u4_1_sum, l4_lo)),
      u5_lo = u5_lo2 + (u5h_lo2 + u5f_lo);
  const double part0a = A->at[0][0] / divisor0, part0a_product = KSL_MUL(part0a, divisor0),
      part0a_lo = (A->at[0][0] - part0a_product
          - ksl_product_error(part0a, divisor0, part0a_product)) / divisor0,
      part0 = 0.0 < A->at[0][0] ? part0a : A->at[0][0],
      part0_lo = 0.0 < A->at[0][0] ? part0a_lo : 0.0;
  const double own1 = 0.0 < A->at[1][1] ? A->at[1][1] : 1.0;
  const double part1a = u1_0_sum / own1, part1a_product = KSL_MUL(part1a, own1),
      part1a_lo = (u1_0_sum - part1a_product - ksl_product_error(part1a, own1, part1a_product)
          + u1_0_sum_lo) / own1, part1 = 0.0 < A->at[1][1] ? part1a : A->at[1][1],
      part1_lo = 0.0 < A->at[1][1] ? part1a_lo : 0.0;
  const double part0_sum = part0 + part0_lo, part0_sum_right = part0_sum - part0,
      part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right),
      part1_sum = part1 + part1_lo, part1_sum_right = part1_sum - part1,
      part1_sum_lo = part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right),
      smallest1 = part0_sum < part1_sum ? part0_sum : part1_sum,
      smallest1_lo = part0_sum < part1_sum ? part0_sum_lo : part1_sum_lo;
  const double own2 = 0.0 < A->at[2][2] ? A->at[2][2] : 1.0;
  const double part2a = u2_0_sum / own2, part2a_product = KSL_MUL(part2a, own2),
      part2a_lo = (u2_0_sum - part2a_product - ksl_product_error(part2a, own2, part2a_product)
          + u2_0_sum_lo) / own2, part2 = 0.0 < A->at[2][2] ? part2a : A->at[2][2],
      part2_lo = 0.0 < A->at[2][2] ? part2a_lo : 0.0;
  const double smallest1_sum = smallest1 + smallest1_lo,
      smallest1_sum_right = smallest1_sum - smallest1,
      smallest1_sum_lo = smallest1 - (smallest1_sum - smallest1_sum_right)
          + (smallest1_lo - smallest1_sum_right), part2_sum = part2 + part2_lo,
      part2_sum_right = part2_sum - part2,
      part2_sum_lo = part2 - (part2_sum - part2_sum_right) + (part2_lo - part2_sum_right),
      smallest2 = smallest1_sum < part2_sum ? smallest1_sum : part2_sum,
      smallest2_lo = smallest1_sum < part2_sum ? smallest1_sum_lo : part2_sum_lo;
  const double own3 = 0.0 < A->at[3][3] ? A->at[3][3] : 1.0;
  const double part3a = u3_0_sum / own3, part3a_product = KSL_MUL(part3a, own3),
      part3a_lo = (u3_0_sum - part3a_product - ksl_product_error(part3a, own3, part3a_product)
          + u3_0_sum_lo) / own3, part3 = 0.0 < A->at[3][3] ? part3a : A->at[3][3],
      part3_lo = 0.0 < A->at[3][3] ? part3a_lo : 0.0;
  const double smallest2_sum = smallest2 + smallest2_lo,
      smallest2_sum_right = smallest2_sum - smallest2,
      smallest2_sum_lo = smallest2 - (smallest2_sum - smallest2_sum_right)
          + (smallest2_lo - smallest2_sum_right), part3_sum = part3 + part3_lo,
      part3_sum_right = part3_sum - part3,
      part3_sum_lo = part3 - (part3_sum - part3_sum_right) + (part3_lo - part3_sum_right),
      smallest3 = smallest2_sum < part3_sum ? smallest2_sum : part3_sum,
      smallest3_lo = smallest2_sum < part3_sum ? smallest2_sum_lo : part3_sum_lo;
  const double own4 = 0.0 < A->at[4][4] ? A->at[4][4] : 1.0;
  const double part4a = u4_0_sum / own4, part4a_product = KSL_MUL(part4a, own4),
      part4a_lo = (u4_0_sum - part4a_product - ksl_product_error(part4a, own4, part4a_product)
          + u4_0_sum_lo) / own4, part4 = 0.0 < A->at[4][4] ? part4a : A->at[4][4],
      part4_lo = 0.0 < A->at[4][4] ? part4a_lo : 0.0;
  const double smallest3_sum = smallest3 + smallest3_lo,
      smallest3_sum_right = smallest3_sum - smallest3,
      smallest3_sum_lo = smallest3 - (smallest3_sum - smallest3_sum_right)
          + (smallest3_lo - smallest3_sum_right), part4_sum = part4 + part4_lo,
      part4_sum_right = part4_sum - part4,
      part4_sum_lo = part4 - (part4_sum - part4_sum_right) + (part4_lo - part4_sum_right),
      smallest4 = smallest3_sum < part4_sum ? smallest3_sum : part4_sum,
      smallest4_lo = smallest3_sum < part4_sum ? smallest3_sum_lo : part4_sum_lo;
  const double own5 = 0.0 < A->at[5][5] ? A->at[5][5] : 1.0;
  const double u5_sum = u5 + u5_lo, u5_sum_right = u5_sum - u5, part5a = u5_sum / own5,
      part5a_product = KSL_MUL(part5a, own5),
      part5a_numerator = u5_sum - part5a_product - ksl_product_error(part5a, own5, part5a_product)
          + (u5 - (u5_sum - u5_sum_right) + (u5_lo - u5_sum_right)),
      part5a_lo = part5a_numerator / own5, part5 = 0.0 < A->at[5][5] ? part5a : A->at[5][5],
      part5_lo = 0.0 < A->at[5][5] ? part5a_lo : 0.0;
  const double smallest4_sum = smallest4 + smallest4_lo,
      smallest4_sum_right = smallest4_sum - smallest4,
      smallest4_sum_lo = smallest4 - (smallest4_sum - smallest4_sum_right)
          + (smallest4_lo - smallest4_sum_right), part5_sum = part5 + part5_lo,
      part5_sum_right = part5_sum - part5,
      part5_sum_lo = part5 - (part5_sum - part5_sum_right) + (part5_lo - part5_sum_right),
      smallest5 = smallest4_sum < part5_sum ? smallest4_sum : part5_sum;
  const double smallest5_rounded = smallest5
          + (smallest4_sum < part5_sum ? smallest4_sum_lo : part5_sum_lo);
  const double l0_0_rounded = l0_0 + l0_0_lo;
  const double u1_0_rounded = u1_0 + u1_0_lo;
  const double l0_1_rounded = l0_1 + l0_1_lo;
  const double l1_0_rounded = l1_0 + l1_0_lo;
  const double u2_0_rounded = u2_0 + u2_0_lo;
  const double l0_2_rounded = l0_2 + l0_2_lo;
  const double l1_1_rounded = l1_1 + l1_1_lo;
  const double l2_0_rounded = l2_0 + l2_0_lo;
  const double u3_0_rounded = u3_0 + u3_0_lo;
  const double l0_3_rounded = l0_3 + l0_3_lo;
  const double l1_2_rounded = l1_2 + l1_2_lo;
  const double l2_1_rounded = l2_1 + l2_1_lo;
  const double l3_0_rounded = l3_0 + l3_0_lo;
  const double u4_0_rounded = u4_0 + u4_0_lo;
  const double l0_4_rounded = l0_4 + l0_4_lo;
  const double l1_3_rounded = l1_3 + l1_3_lo;
  const double l2_2_rounded = l2_2 + l2_2_lo;
  const double l3_1_rounded = l3_1 + l3_1_lo;
  const double l4_rounded = l4 + l4_lo;
  const double u5_rounded = u5 + u5_lo;
  const double smallest5_final = smallest5_rounded == smallest5_rounded ? smallest5_rounded
          : smallest5;
  const double l0_0_final = l0_0_rounded == l0_0_rounded ? l0_0_rounded : l0_0;
  const double u1_0_final = u1_0_rounded == u1_0_rounded ? u1_0_rounded : u1_0;
  const double l0_1_final = l0_1_rounded == l0_1_rounded ? l0_1_rounded : l0_1;
  const double l1_0_final = l1_0_rounded == l1_0_rounded ? l1_0_rounded : l1_0;
  const double u2_0_final = u2_0_rounded == u2_0_rounded ? u2_0_rounded : u2_0;
  const double l0_2_final = l0_2_rounded == l0_2_rounded ? l0_2_rounded : l0_2;
  const double l1_1_final = l1_1_rounded == l1_1_rounded ? l1_1_rounded : l1_1;
  const double l2_0_final = l2_0_rounded == l2_0_rounded ? l2_0_rounded : l2_0;
  const double u3_0_final = u3_0_rounded == u3_0_rounded ? u3_0_rounded : u3_0;
  const double l0_3_final = l0_3_rounded == l0_3_rounded ? l0_3_rounded : l0_3;
  const double l1_2_final = l1_2_rounded == l1_2_rounded ? l1_2_rounded : l1_2;
  const double l2_1_final = l2_1_rounded == l2_1_rounded ? l2_1_rounded : l2_1;
  const double l3_0_final = l3_0_rounded == l3_0_rounded ? l3_0_rounded : l3_0;
  const double u4_0_final = u4_0_rounded == u4_0_rounded ? u4_0_rounded : u4_0;
  const double l0_4_final = l0_4_rounded == l0_4_rounded ? l0_4_rounded : l0_4;
  const double l1_3_final = l1_3_rounded == l1_3_rounded ? l1_3_rounded : l1_3;
  const double l2_2_final = l2_2_rounded == l2_2_rounded ? l2_2_rounded : l2_2;
  const double l3_1_final = l3_1_rounded == l3_1_rounded ? l3_1_rounded : l3_1;
  const double l4_final = l4_rounded == l4_rounded ? l4_rounded : l4;
  const double u5_final = u5_rounded == u5_rounded ? u5_rounded : u5;
  L->at[0][0] = A->at[0][0];
  L->at[1][0] = 0.0;
  L->at[2][0] = 0.0;
  L->at[3][0] = 0.0;
  L->at[4][0] = 0.0;
  L->at[5][0] = 0.0;
  L->at[0][1] = l0_0_final;
  L->at[1][1] = u1_0_final;
  L->at[2][1] = 0.0;
  L->at[3][1] = 0.0;
  L->at[4][1] = 0.0;
  L->at[5][1] = 0.0;
  L->at[0][2] = l0_1_final;
  L->at[1][2] = l1_0_final;
  L->at[2][2] = u2_0_final;
  L->at[3][2] = 0.0;
  L->at[4][2] = 0.0;
  L->at[5][2] = 0.0;
  L->at[0][3] = l0_2_final;
  L->at[1][3] = l1_1_final;
  L->at[2][3] = l2_0_final;
  L->at[3][3] = u3_0_final;
  L->at[4][3] = 0.0;
  L->at[5][3] = 0.0;
  L->at[0][4] = l0_3_final;
  L->at[1][4] = l1_2_final;
  L->at[2][4] = l2_1_final;
  L->at[3][4] = l3_0_final;
  L->at[4][4] = u4_0_final;
  L->at[5][4] = 0.0;
  L->at[0][5] = l0_4_final;
  L->at[1][5] = l1_3_final;
  L->at[2][5] = l2_2_final;
  L->at[3][5] = l3_1_final;
  L->at[4][5] = l4_final;
  L->at[5][5] = u5_final;
  return smallest5_final;
}

/* x = A^-1 b, L of mat6x6_ldl with a positive pivot.
   L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   61 mul, 253 add, 6 product error, 30 product rest, 12 div, 6 equal, 6 select.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat6x6_ldl_solve_accurate(const ksl_mat6x6_t *L, const ksl_coscrew_t *b,
    ksl_screw_t *x) {
  const double y1a = KSL_MUL(L->at[0][1], b->m0), y1 = b->m1 - y1a, y1_right = b->m1 - y1,
      y1_lo = b->m1 - (y1 + y1_right) - ksl_product_rest(L->at[0][1], b->m0, y1a, y1_right);
  const double y2a = KSL_MUL(L->at[0][2], b->m0), y2b = b->m2 - y2a, y2b_right = b->m2 - y2b,
      y2c = KSL_MUL(L->at[1][2], y1), y2 = y2b - y2c, y2_right = y2b - y2,
      y2_lo2 = y2b - (y2 + y2_right) - ksl_product_rest(L->at[1][2], y1, y2c, y2_right)
          - KSL_MUL(L->at[1][2], y1_lo),
      y2_lo = y2_lo2
          + (b->m2 - (y2b + y2b_right) - ksl_product_rest(L->at[0][2], b->m0, y2a, y2b_right));
  const double y3a = KSL_MUL(L->at[0][3], b->m0), y3b = b->m3 - y3a, y3b_right = b->m3 - y3b,
      y3c = KSL_MUL(L->at[1][3], y1), y3d = y3b - y3c, y3d_right = y3b - y3d,
      y3d_lo2 = y3b - (y3d + y3d_right) - ksl_product_rest(L->at[1][3], y1, y3c, y3d_right)
          - KSL_MUL(L->at[1][3], y1_lo), y3e = KSL_MUL(L->at[2][3], y2), y3 = y3d - y3e,
      y3_right = y3d - y3,
      y3_lo2 = y3d - (y3 + y3_right) - ksl_product_rest(L->at[2][3], y2, y3e, y3_right)
          - KSL_MUL(L->at[2][3], y2_lo),
      y3_lo = y3_lo2
          + (y3d_lo2
          + (b->m3 - (y3b + y3b_right) - ksl_product_rest(L->at[0][3], b->m0, y3a, y3b_right)));
  const double y4a = KSL_MUL(L->at[0][4], b->m0), y4b = b->m4 - y4a, y4b_right = b->m4 - y4b,
      y4c = KSL_MUL(L->at[1][4], y1), y4d = y4b - y4c, y4d_right = y4b - y4d,
      y4d_lo2 = y4b - (y4d + y4d_right) - ksl_product_rest(L->at[1][4], y1, y4c, y4d_right)
          - KSL_MUL(L->at[1][4], y1_lo), y4e = KSL_MUL(L->at[2][4], y2), y4f = y4d - y4e,
      y4f_right = y4d - y4f,
      y4f_lo2 = y4d - (y4f + y4f_right) - ksl_product_rest(L->at[2][4], y2, y4e, y4f_right)
          - KSL_MUL(L->at[2][4], y2_lo), y4g = KSL_MUL(L->at[3][4], y3), y4 = y4f - y4g,
      y4_right = y4f - y4,
      y4f_lo = y4f_lo2
          + (y4d_lo2
          + (b->m4 - (y4b + y4b_right) - ksl_product_rest(L->at[0][4], b->m0, y4a, y4b_right))),
      y4_lo = y4f - (y4 + y4_right) - ksl_product_rest(L->at[3][4], y3, y4g, y4_right)
          - KSL_MUL(L->at[3][4], y3_lo) + y4f_lo;
  const double y5a = KSL_MUL(L->at[0][5], b->m0), y5b = b->m5 - y5a, y5b_right = b->m5 - y5b,
      y5c = KSL_MUL(L->at[1][5], y1), y5d = y5b - y5c, y5d_right = y5b - y5d,
      y5d_lo2 = y5b - (y5d + y5d_right) - ksl_product_rest(L->at[1][5], y1, y5c, y5d_right)
          - KSL_MUL(L->at[1][5], y1_lo), y5e = KSL_MUL(L->at[2][5], y2), y5f = y5d - y5e,
      y5f_right = y5d - y5f,
      y5f_lo2 = y5d - (y5f + y5f_right) - ksl_product_rest(L->at[2][5], y2, y5e, y5f_right)
          - KSL_MUL(L->at[2][5], y2_lo), y5g = KSL_MUL(L->at[3][5], y3), y5h = y5f - y5g,
      y5h_right = y5f - y5h,
      y5h_lo2 = y5f - (y5h + y5h_right) - ksl_product_rest(L->at[3][5], y3, y5g, y5h_right)
          - KSL_MUL(L->at[3][5], y3_lo), y5i = KSL_MUL(L->at[4][5], y4), y5 = y5h - y5i,
      y5_right = y5h - y5,
      y5h_lo = y5h_lo2
          + (y5f_lo2
          + (y5d_lo2
          + (b->m5 - (y5b + y5b_right) - ksl_product_rest(L->at[0][5], b->m0, y5a, y5b_right)))),
      y5_lo = y5h - (y5 + y5_right) - ksl_product_rest(L->at[4][5], y4, y5i, y5_right)
          - KSL_MUL(L->at[4][5], y4_lo) + y5h_lo;
  const double z0 = b->m0 / L->at[0][0], z0_product = KSL_MUL(z0, L->at[0][0]);
  const double y1_sum = y1 + y1_lo, y1_sum_right = y1_sum - y1, z1 = y1_sum / L->at[1][1],
      z1_product = KSL_MUL(z1, L->at[1][1]);
  const double y2_sum = y2 + y2_lo, y2_sum_right = y2_sum - y2, z2 = y2_sum / L->at[2][2],
      z2_product = KSL_MUL(z2, L->at[2][2]);
  const double y3_sum = y3 + y3_lo, y3_sum_right = y3_sum - y3, z3 = y3_sum / L->at[3][3],
      z3_product = KSL_MUL(z3, L->at[3][3]);
  const double y4_sum = y4 + y4_lo, y4_sum_right = y4_sum - y4, z4 = y4_sum / L->at[4][4],
      z4_product = KSL_MUL(z4, L->at[4][4]);
  const double y5_sum = y5 + y5_lo, y5_sum_right = y5_sum - y5, z5 = y5_sum / L->at[5][5],
      z5_product = KSL_MUL(z5, L->at[5][5]),
      z5_lo = (y5_sum - z5_product - ksl_product_error(z5, L->at[5][5], z5_product)
          + (y5 - (y5_sum - y5_sum_right) + (y5_lo - y5_sum_right))) / L->at[5][5];
  const double x4a = KSL_MUL(L->at[4][5], z5), x4 = z4 - x4a, x4_right = z4 - x4;
  const double z4_lo = (y4_sum - z4_product - ksl_product_error(z4, L->at[4][4], z4_product)
          + (y4 - (y4_sum - y4_sum_right) + (y4_lo - y4_sum_right))) / L->at[4][4];
  const double x4_lo = z4 - (x4 + x4_right) - ksl_product_rest(L->at[4][5], z5, x4a, x4_right)
          - KSL_MUL(L->at[4][5], z5_lo) + z4_lo;
  const double x3a = KSL_MUL(L->at[3][4], x4), x3b = z3 - x3a, x3b_right = z3 - x3b;
  const double z3_lo = (y3_sum - z3_product - ksl_product_error(z3, L->at[3][3], z3_product)
          + (y3 - (y3_sum - y3_sum_right) + (y3_lo - y3_sum_right))) / L->at[3][3];
  const double x3c = KSL_MUL(L->at[3][5], z5), x3 = x3b - x3c, x3_right = x3b - x3,
      x3b_lo = z3 - (x3b + x3b_right) - ksl_product_rest(L->at[3][4], x4, x3a, x3b_right)
          - KSL_MUL(L->at[3][4], x4_lo) + z3_lo,
      x3_lo = x3b - (x3 + x3_right) - ksl_product_rest(L->at[3][5], z5, x3c, x3_right)
          - KSL_MUL(L->at[3][5], z5_lo) + x3b_lo;
  const double x2a = KSL_MUL(L->at[2][3], x3), x2b = z2 - x2a, x2b_right = z2 - x2b;
  const double z2_lo = (y2_sum - z2_product - ksl_product_error(z2, L->at[2][2], z2_product)
          + (y2 - (y2_sum - y2_sum_right) + (y2_lo - y2_sum_right))) / L->at[2][2];
  const double x2c = KSL_MUL(L->at[2][4], x4), x2d = x2b - x2c, x2d_right = x2b - x2d,
      x2b_lo = z2 - (x2b + x2b_right) - ksl_product_rest(L->at[2][3], x3, x2a, x2b_right)
          - KSL_MUL(L->at[2][3], x3_lo) + z2_lo, x2e = KSL_MUL(L->at[2][5], z5), x2 = x2d - x2e,
      x2_right = x2d - x2,
      x2d_lo = x2b - (x2d + x2d_right) - ksl_product_rest(L->at[2][4], x4, x2c, x2d_right)
          - KSL_MUL(L->at[2][4], x4_lo) + x2b_lo,
      x2_lo = x2d - (x2 + x2_right) - ksl_product_rest(L->at[2][5], z5, x2e, x2_right)
          - KSL_MUL(L->at[2][5], z5_lo) + x2d_lo;
  const double x1a = KSL_MUL(L->at[1][2], x2), x1b = z1 - x1a, x1b_right = z1 - x1b;
  const double z1_lo = (y1_sum - z1_product - ksl_product_error(z1, L->at[1][1], z1_product)
          + (y1 - (y1_sum - y1_sum_right) + (y1_lo - y1_sum_right))) / L->at[1][1];
  const double x1c = KSL_MUL(L->at[1][3], x3), x1d = x1b - x1c, x1d_right = x1b - x1d,
      x1b_lo = z1 - (x1b + x1b_right) - ksl_product_rest(L->at[1][2], x2, x1a, x1b_right)
          - KSL_MUL(L->at[1][2], x2_lo) + z1_lo, x1e = KSL_MUL(L->at[1][4], x4), x1f = x1d - x1e,
      x1f_right = x1d - x1f,
      x1d_lo = x1b - (x1d + x1d_right) - ksl_product_rest(L->at[1][3], x3, x1c, x1d_right)
          - KSL_MUL(L->at[1][3], x3_lo) + x1b_lo, x1g = KSL_MUL(L->at[1][5], z5), x1 = x1f - x1g,
      x1_right = x1f - x1,
      x1f_lo = x1d - (x1f + x1f_right) - ksl_product_rest(L->at[1][4], x4, x1e, x1f_right)
          - KSL_MUL(L->at[1][4], x4_lo) + x1d_lo,
      x1_lo = x1f - (x1 + x1_right) - ksl_product_rest(L->at[1][5], z5, x1g, x1_right)
          - KSL_MUL(L->at[1][5], z5_lo) + x1f_lo;
  const double x0a = KSL_MUL(L->at[0][1], x1), x0b = z0 - x0a, x0b_right = z0 - x0b,
      x0b_lo2 = z0 - (x0b + x0b_right) - ksl_product_rest(L->at[0][1], x1, x0a, x0b_right)
          - KSL_MUL(L->at[0][1], x1_lo), x0c = KSL_MUL(L->at[0][2], x2), x0d = x0b - x0c,
      x0d_right = x0b - x0d,
      x0d_lo2 = x0b - (x0d + x0d_right) - ksl_product_rest(L->at[0][2], x2, x0c, x0d_right)
          - KSL_MUL(L->at[0][2], x2_lo), x0e = KSL_MUL(L->at[0][3], x3), x0f = x0d - x0e,
      x0f_right = x0d - x0f,
      x0f_lo2 = x0d - (x0f + x0f_right) - ksl_product_rest(L->at[0][3], x3, x0e, x0f_right)
          - KSL_MUL(L->at[0][3], x3_lo), x0g = KSL_MUL(L->at[0][4], x4), x0h = x0f - x0g,
      x0h_right = x0f - x0h,
      x0f_lo = x0f_lo2
          + (x0d_lo2
          + (x0b_lo2 + (b->m0 - z0_product - ksl_product_error(z0, L->at[0][0], z0_product))
          / L->at[0][0])), x0i = KSL_MUL(L->at[0][5], z5), x0 = x0h - x0i, x0_right = x0h - x0,
      x0h_lo = x0f - (x0h + x0h_right) - ksl_product_rest(L->at[0][4], x4, x0g, x0h_right)
          - KSL_MUL(L->at[0][4], x4_lo) + x0f_lo;
  const double x0_rounded = x0
          + (x0h - (x0 + x0_right) - ksl_product_rest(L->at[0][5], z5, x0i, x0_right)
          - KSL_MUL(L->at[0][5], z5_lo) + x0h_lo);
  const double x1_rounded = x1 + x1_lo;
  const double x2_rounded = x2 + x2_lo;
  const double x3_rounded = x3 + x3_lo;
  const double x4_rounded = x4 + x4_lo;
  const double z5_rounded = z5 + z5_lo;
  const double x0_final = x0_rounded == x0_rounded ? x0_rounded : x0;
  const double x1_final = x1_rounded == x1_rounded ? x1_rounded : x1;
  const double x2_final = x2_rounded == x2_rounded ? x2_rounded : x2;
  const double x3_final = x3_rounded == x3_rounded ? x3_rounded : x3;
  const double x4_final = x4_rounded == x4_rounded ? x4_rounded : x4;
  const double z5_final = z5_rounded == z5_rounded ? z5_rounded : z5;
  x->m0 = x0_final;
  x->m1 = x1_final;
  x->m2 = x2_final;
  x->m3 = x3_final;
  x->m4 = x4_final;
  x->m5 = z5_final;
}

/* x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
     Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
     rounding or indefinite (A - 50 u diag A is not positive definite).
   A: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   516 mul, 1806 add, 49 product error, 171 product rest, 96 div, 23 less, 8 equal, 77 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline double ksl_mat6x6_solve_accurate(const ksl_mat6x6_t *A, const ksl_coscrew_t *b,
    ksl_screw_t *x) {
  const double divisor0 = 0.0 < A->at[0][0] ? A->at[0][0] : 1.0;
  const double l0_0 = A->at[0][1] / divisor0, l0_0_product = KSL_MUL(l0_0, divisor0),
      l0_0_lo = (A->at[0][1] - l0_0_product - ksl_product_error(l0_0, divisor0, l0_0_product))
          / divisor0;
  const double l0_1 = A->at[0][2] / divisor0, l0_1_product = KSL_MUL(l0_1, divisor0),
      l0_1_lo = (A->at[0][2] - l0_1_product - ksl_product_error(l0_1, divisor0, l0_1_product))
          / divisor0;
  const double l0_2 = A->at[0][3] / divisor0, l0_2_product = KSL_MUL(l0_2, divisor0),
      l0_2_lo = (A->at[0][3] - l0_2_product - ksl_product_error(l0_2, divisor0, l0_2_product))
          / divisor0;
  const double l0_3 = A->at[0][4] / divisor0, l0_3_product = KSL_MUL(l0_3, divisor0),
      l0_3_lo = (A->at[0][4] - l0_3_product - ksl_product_error(l0_3, divisor0, l0_3_product))
          / divisor0;
  const double l0_4 = A->at[0][5] / divisor0, l0_4_product = KSL_MUL(l0_4, divisor0),
      l0_4_lo = (A->at[0][5] - l0_4_product - ksl_product_error(l0_4, divisor0, l0_4_product))
          / divisor0;
  const double u1_0a = KSL_MUL(A->at[0][1], l0_0), u1_0 = A->at[1][1] - u1_0a,
      u1_0_right = A->at[1][1] - u1_0,
      u1_0_lo = A->at[1][1] - (u1_0 + u1_0_right)
          - ksl_product_rest(A->at[0][1], l0_0, u1_0a, u1_0_right) - KSL_MUL(A->at[0][1], l0_0_lo);
  const double u1_1a = KSL_MUL(A->at[0][2], l0_0), u1_1 = A->at[1][2] - u1_1a,
      u1_1_right = A->at[1][2] - u1_1,
      u1_1_lo = A->at[1][2] - (u1_1 + u1_1_right)
          - ksl_product_rest(A->at[0][2], l0_0, u1_1a, u1_1_right) - KSL_MUL(A->at[0][2], l0_0_lo);
  const double u1_2a = KSL_MUL(A->at[0][3], l0_0), u1_2 = A->at[1][3] - u1_2a,
      u1_2_right = A->at[1][3] - u1_2,
      u1_2_lo = A->at[1][3] - (u1_2 + u1_2_right)
          - ksl_product_rest(A->at[0][3], l0_0, u1_2a, u1_2_right) - KSL_MUL(A->at[0][3], l0_0_lo);
  const double u1_3a = KSL_MUL(A->at[0][4], l0_0), u1_3 = A->at[1][4] - u1_3a,
      u1_3_right = A->at[1][4] - u1_3,
      u1_3_lo = A->at[1][4] - (u1_3 + u1_3_right)
          - ksl_product_rest(A->at[0][4], l0_0, u1_3a, u1_3_right) - KSL_MUL(A->at[0][4], l0_0_lo);
  const double u1_4a = KSL_MUL(A->at[0][5], l0_0), u1_4 = A->at[1][5] - u1_4a,
      u1_4_right = A->at[1][5] - u1_4,
      u1_4_lo = A->at[1][5] - (u1_4 + u1_4_right)
          - ksl_product_rest(A->at[0][5], l0_0, u1_4a, u1_4_right) - KSL_MUL(A->at[0][5], l0_0_lo);
  const double u1_0_sum = u1_0 + u1_0_lo, u1_0_sum_right = u1_0_sum - u1_0,
      u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right),
      divisor1 = 0.0 < u1_0_sum ? u1_0_sum : 1.0, divisor1_lo = 0.0 < u1_0_sum ? u1_0_sum_lo : 0.0;
  const double u1_1_sum = u1_1 + u1_1_lo, u1_1_sum_right = u1_1_sum - u1_1,
      u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right),
      divisor1_sum = divisor1 + divisor1_lo, divisor1_sum_right = divisor1_sum - divisor1,
      divisor1_sum_lo = divisor1 - (divisor1_sum - divisor1_sum_right)
          + (divisor1_lo - divisor1_sum_right), l1_0 = u1_1_sum / divisor1_sum,
      l1_0_product = KSL_MUL(l1_0, divisor1_sum),
      l1_0_residual = u1_1_sum - l1_0_product - ksl_product_error(l1_0, divisor1_sum, l1_0_product)
          + u1_1_sum_lo - KSL_MUL(l1_0, divisor1_sum_lo), l1_0_lo = l1_0_residual / divisor1_sum;
  const double u1_2_sum = u1_2 + u1_2_lo, u1_2_sum_right = u1_2_sum - u1_2,
      u1_2_sum_lo = u1_2 - (u1_2_sum - u1_2_sum_right) + (u1_2_lo - u1_2_sum_right),
      l1_1 = u1_2_sum / divisor1_sum, l1_1_product = KSL_MUL(l1_1, divisor1_sum),
      l1_1_residual = u1_2_sum - l1_1_product - ksl_product_error(l1_1, divisor1_sum, l1_1_product)
          + u1_2_sum_lo - KSL_MUL(l1_1, divisor1_sum_lo), l1_1_lo = l1_1_residual / divisor1_sum;
  const double u1_3_sum = u1_3 + u1_3_lo, u1_3_sum_right = u1_3_sum - u1_3,
      u1_3_sum_lo = u1_3 - (u1_3_sum - u1_3_sum_right) + (u1_3_lo - u1_3_sum_right),
      l1_2 = u1_3_sum / divisor1_sum, l1_2_product = KSL_MUL(l1_2, divisor1_sum),
      l1_2_residual = u1_3_sum - l1_2_product - ksl_product_error(l1_2, divisor1_sum, l1_2_product)
          + u1_3_sum_lo - KSL_MUL(l1_2, divisor1_sum_lo), l1_2_lo = l1_2_residual / divisor1_sum;
  const double u1_4_sum = u1_4 + u1_4_lo, u1_4_sum_right = u1_4_sum - u1_4,
      u1_4_sum_lo = u1_4 - (u1_4_sum - u1_4_sum_right) + (u1_4_lo - u1_4_sum_right),
      l1_3 = u1_4_sum / divisor1_sum, l1_3_product = KSL_MUL(l1_3, divisor1_sum),
      l1_3_residual = u1_4_sum - l1_3_product - ksl_product_error(l1_3, divisor1_sum, l1_3_product)
          + u1_4_sum_lo - KSL_MUL(l1_3, divisor1_sum_lo), l1_3_lo = l1_3_residual / divisor1_sum;
  const double u2_0a = KSL_MUL(A->at[0][2], l0_1), u2_0b = A->at[2][2] - u2_0a,
      u2_0b_right = A->at[2][2] - u2_0b, u2_0c = KSL_MUL(u1_1_sum, l1_0), u2_0 = u2_0b - u2_0c,
      u2_0_right = u2_0b - u2_0,
      u2_0_lo1 = u2_0b - (u2_0 + u2_0_right) - ksl_product_rest(u1_1_sum, l1_0, u2_0c, u2_0_right),
      u2_0b_lo = A->at[2][2] - (u2_0b + u2_0b_right)
          - ksl_product_rest(A->at[0][2], l0_1, u2_0a, u2_0b_right) - KSL_MUL(A->at[0][2], l0_1_lo),
      u2_0_lo = u2_0_lo1 - (KSL_MUL(u1_1_sum_lo, l1_0) + KSL_MUL(u1_1_sum, l1_0_lo)) + u2_0b_lo;
  const double u2_1a = KSL_MUL(A->at[0][3], l0_1), u2_1b = A->at[2][3] - u2_1a,
      u2_1b_right = A->at[2][3] - u2_1b, u2_1c = KSL_MUL(u1_2_sum, l1_0), u2_1 = u2_1b - u2_1c,
      u2_1_right = u2_1b - u2_1,
      u2_1_lo1 = u2_1b - (u2_1 + u2_1_right) - ksl_product_rest(u1_2_sum, l1_0, u2_1c, u2_1_right),
      u2_1b_lo = A->at[2][3] - (u2_1b + u2_1b_right)
          - ksl_product_rest(A->at[0][3], l0_1, u2_1a, u2_1b_right) - KSL_MUL(A->at[0][3], l0_1_lo),
      u2_1_lo = u2_1_lo1 - (KSL_MUL(u1_2_sum_lo, l1_0) + KSL_MUL(u1_2_sum, l1_0_lo)) + u2_1b_lo;
  const double u2_2a = KSL_MUL(A->at[0][4], l0_1), u2_2b = A->at[2][4] - u2_2a,
      u2_2b_right = A->at[2][4] - u2_2b, u2_2c = KSL_MUL(u1_3_sum, l1_0), u2_2 = u2_2b - u2_2c,
      u2_2_right = u2_2b - u2_2,
      u2_2_lo1 = u2_2b - (u2_2 + u2_2_right) - ksl_product_rest(u1_3_sum, l1_0, u2_2c, u2_2_right),
      u2_2b_lo = A->at[2][4] - (u2_2b + u2_2b_right)
          - ksl_product_rest(A->at[0][4], l0_1, u2_2a, u2_2b_right) - KSL_MUL(A->at[0][4], l0_1_lo),
      u2_2_lo = u2_2_lo1 - (KSL_MUL(u1_3_sum_lo, l1_0) + KSL_MUL(u1_3_sum, l1_0_lo)) + u2_2b_lo;
  const double u2_3a = KSL_MUL(A->at[0][5], l0_1), u2_3b = A->at[2][5] - u2_3a,
      u2_3b_right = A->at[2][5] - u2_3b, u2_3c = KSL_MUL(u1_4_sum, l1_0), u2_3 = u2_3b - u2_3c,
      u2_3_right = u2_3b - u2_3,
      u2_3_lo1 = u2_3b - (u2_3 + u2_3_right) - ksl_product_rest(u1_4_sum, l1_0, u2_3c, u2_3_right),
      u2_3b_lo = A->at[2][5] - (u2_3b + u2_3b_right)
          - ksl_product_rest(A->at[0][5], l0_1, u2_3a, u2_3b_right) - KSL_MUL(A->at[0][5], l0_1_lo),
      u2_3_lo = u2_3_lo1 - (KSL_MUL(u1_4_sum_lo, l1_0) + KSL_MUL(u1_4_sum, l1_0_lo)) + u2_3b_lo;
  const double u2_0_sum = u2_0 + u2_0_lo, u2_0_sum_right = u2_0_sum - u2_0,
      u2_0_sum_lo = u2_0 - (u2_0_sum - u2_0_sum_right) + (u2_0_lo - u2_0_sum_right),
      divisor2 = 0.0 < u2_0_sum ? u2_0_sum : 1.0, divisor2_lo = 0.0 < u2_0_sum ? u2_0_sum_lo : 0.0;
  const double u2_1_sum = u2_1 + u2_1_lo, u2_1_sum_right = u2_1_sum - u2_1,
      u2_1_sum_lo = u2_1 - (u2_1_sum - u2_1_sum_right) + (u2_1_lo - u2_1_sum_right),
      divisor2_sum = divisor2 + divisor2_lo, divisor2_sum_right = divisor2_sum - divisor2,
      divisor2_sum_lo = divisor2 - (divisor2_sum - divisor2_sum_right)
          + (divisor2_lo - divisor2_sum_right), l2_0 = u2_1_sum / divisor2_sum,
      l2_0_product = KSL_MUL(l2_0, divisor2_sum),
      l2_0_residual = u2_1_sum - l2_0_product - ksl_product_error(l2_0, divisor2_sum, l2_0_product)
          + u2_1_sum_lo - KSL_MUL(l2_0, divisor2_sum_lo), l2_0_lo = l2_0_residual / divisor2_sum;
  const double u2_2_sum = u2_2 + u2_2_lo, u2_2_sum_right = u2_2_sum - u2_2,
      u2_2_sum_lo = u2_2 - (u2_2_sum - u2_2_sum_right) + (u2_2_lo - u2_2_sum_right),
      l2_1 = u2_2_sum / divisor2_sum, l2_1_product = KSL_MUL(l2_1, divisor2_sum),
      l2_1_residual = u2_2_sum - l2_1_product - ksl_product_error(l2_1, divisor2_sum, l2_1_product)
          + u2_2_sum_lo - KSL_MUL(l2_1, divisor2_sum_lo), l2_1_lo = l2_1_residual / divisor2_sum;
  const double u2_3_sum = u2_3 + u2_3_lo, u2_3_sum_right = u2_3_sum - u2_3,
      u2_3_sum_lo = u2_3 - (u2_3_sum - u2_3_sum_right) + (u2_3_lo - u2_3_sum_right),
      l2_2 = u2_3_sum / divisor2_sum, l2_2_product = KSL_MUL(l2_2, divisor2_sum),
      l2_2_residual = u2_3_sum - l2_2_product - ksl_product_error(l2_2, divisor2_sum, l2_2_product)
          + u2_3_sum_lo - KSL_MUL(l2_2, divisor2_sum_lo), l2_2_lo = l2_2_residual / divisor2_sum;
  const double u3_0a = KSL_MUL(A->at[0][3], l0_2), u3_0b = A->at[3][3] - u3_0a,
      u3_0b_right = A->at[3][3] - u3_0b, u3_0c = KSL_MUL(u1_2_sum, l1_1), u3_0d = u3_0b - u3_0c,
      u3_0d_right = u3_0b - u3_0d,
      u3_0d_lo1 = u3_0b - (u3_0d + u3_0d_right)
          - ksl_product_rest(u1_2_sum, l1_1, u3_0c, u3_0d_right),
      u3_0b_lo = A->at[3][3] - (u3_0b + u3_0b_right)
          - ksl_product_rest(A->at[0][3], l0_2, u3_0a, u3_0b_right) - KSL_MUL(A->at[0][3], l0_2_lo),
      u3_0e = KSL_MUL(u2_1_sum, l2_0), u3_0 = u3_0d - u3_0e, u3_0_right = u3_0d - u3_0,
      u3_0_lo1 = u3_0d - (u3_0 + u3_0_right) - ksl_product_rest(u2_1_sum, l2_0, u3_0e, u3_0_right),
      u3_0d_lo = u3_0d_lo1 - (KSL_MUL(u1_2_sum_lo, l1_1) + KSL_MUL(u1_2_sum, l1_1_lo)) + u3_0b_lo,
      u3_0_lo = u3_0_lo1 - (KSL_MUL(u2_1_sum_lo, l2_0) + KSL_MUL(u2_1_sum, l2_0_lo)) + u3_0d_lo;
  const double u3_1a = KSL_MUL(A->at[0][4], l0_2), u3_1b = A->at[3][4] - u3_1a,
      u3_1b_right = A->at[3][4] - u3_1b, u3_1c = KSL_MUL(u1_3_sum, l1_1), u3_1d = u3_1b - u3_1c,
      u3_1d_right = u3_1b - u3_1d,
      u3_1d_lo1 = u3_1b - (u3_1d + u3_1d_right)
          - ksl_product_rest(u1_3_sum, l1_1, u3_1c, u3_1d_right),
      u3_1b_lo = A->at[3][4] - (u3_1b + u3_1b_right)
          - ksl_product_rest(A->at[0][4], l0_2, u3_1a, u3_1b_right) - KSL_MUL(A->at[0][4], l0_2_lo),
      u3_1e = KSL_MUL(u2_2_sum, l2_0), u3_1 = u3_1d - u3_1e, u3_1_right = u3_1d - u3_1,
      u3_1_lo1 = u3_1d - (u3_1 + u3_1_right) - ksl_product_rest(u2_2_sum, l2_0, u3_1e, u3_1_right),
      u3_1d_lo = u3_1d_lo1 - (KSL_MUL(u1_3_sum_lo, l1_1) + KSL_MUL(u1_3_sum, l1_1_lo)) + u3_1b_lo,
      u3_1_lo = u3_1_lo1 - (KSL_MUL(u2_2_sum_lo, l2_0) + KSL_MUL(u2_2_sum, l2_0_lo)) + u3_1d_lo;
  const double u3_2a = KSL_MUL(A->at[0][5], l0_2), u3_2b = A->at[3][5] - u3_2a,
      u3_2b_right = A->at[3][5] - u3_2b, u3_2c = KSL_MUL(u1_4_sum, l1_1), u3_2d = u3_2b - u3_2c,
      u3_2d_right = u3_2b - u3_2d,
      u3_2d_lo1 = u3_2b - (u3_2d + u3_2d_right)
          - ksl_product_rest(u1_4_sum, l1_1, u3_2c, u3_2d_right),
      u3_2b_lo = A->at[3][5] - (u3_2b + u3_2b_right)
          - ksl_product_rest(A->at[0][5], l0_2, u3_2a, u3_2b_right) - KSL_MUL(A->at[0][5], l0_2_lo),
      u3_2e = KSL_MUL(u2_3_sum, l2_0), u3_2 = u3_2d - u3_2e, u3_2_right = u3_2d - u3_2,
      u3_2_lo1 = u3_2d - (u3_2 + u3_2_right) - ksl_product_rest(u2_3_sum, l2_0, u3_2e, u3_2_right),
      u3_2d_lo = u3_2d_lo1 - (KSL_MUL(u1_4_sum_lo, l1_1) + KSL_MUL(u1_4_sum, l1_1_lo)) + u3_2b_lo,
      u3_2_lo = u3_2_lo1 - (KSL_MUL(u2_3_sum_lo, l2_0) + KSL_MUL(u2_3_sum, l2_0_lo)) + u3_2d_lo;
  const double u3_0_sum = u3_0 + u3_0_lo, u3_0_sum_right = u3_0_sum - u3_0,
      u3_0_sum_lo = u3_0 - (u3_0_sum - u3_0_sum_right) + (u3_0_lo - u3_0_sum_right),
      divisor3 = 0.0 < u3_0_sum ? u3_0_sum : 1.0, divisor3_lo = 0.0 < u3_0_sum ? u3_0_sum_lo : 0.0;
  const double u3_1_sum = u3_1 + u3_1_lo, u3_1_sum_right = u3_1_sum - u3_1,
      u3_1_sum_lo = u3_1 - (u3_1_sum - u3_1_sum_right) + (u3_1_lo - u3_1_sum_right),
      divisor3_sum = divisor3 + divisor3_lo, divisor3_sum_right = divisor3_sum - divisor3,
      divisor3_sum_lo = divisor3 - (divisor3_sum - divisor3_sum_right)
          + (divisor3_lo - divisor3_sum_right), l3_0 = u3_1_sum / divisor3_sum,
      l3_0_product = KSL_MUL(l3_0, divisor3_sum),
      l3_0_residual = u3_1_sum - l3_0_product - ksl_product_error(l3_0, divisor3_sum, l3_0_product)
          + u3_1_sum_lo - KSL_MUL(l3_0, divisor3_sum_lo), l3_0_lo = l3_0_residual / divisor3_sum;
  const double u3_2_sum = u3_2 + u3_2_lo, u3_2_sum_right = u3_2_sum - u3_2,
      u3_2_sum_lo = u3_2 - (u3_2_sum - u3_2_sum_right) + (u3_2_lo - u3_2_sum_right),
      l3_1 = u3_2_sum / divisor3_sum, l3_1_product = KSL_MUL(l3_1, divisor3_sum),
      l3_1_residual = u3_2_sum - l3_1_product - ksl_product_error(l3_1, divisor3_sum, l3_1_product)
          + u3_2_sum_lo - KSL_MUL(l3_1, divisor3_sum_lo), l3_1_lo = l3_1_residual / divisor3_sum;
  const double u4_0a = KSL_MUL(A->at[0][4], l0_3), u4_0b = A->at[4][4] - u4_0a,
      u4_0b_right = A->at[4][4] - u4_0b, u4_0c = KSL_MUL(u1_3_sum, l1_2), u4_0d = u4_0b - u4_0c,
      u4_0d_right = u4_0b - u4_0d,
      u4_0d_lo1 = u4_0b - (u4_0d + u4_0d_right)
          - ksl_product_rest(u1_3_sum, l1_2, u4_0c, u4_0d_right),
      u4_0b_lo = A->at[4][4] - (u4_0b + u4_0b_right)
          - ksl_product_rest(A->at[0][4], l0_3, u4_0a, u4_0b_right) - KSL_MUL(A->at[0][4], l0_3_lo),
      u4_0e = KSL_MUL(u2_2_sum, l2_1), u4_0f = u4_0d - u4_0e, u4_0f_right = u4_0d - u4_0f,
      u4_0f_lo1 = u4_0d - (u4_0f + u4_0f_right)
          - ksl_product_rest(u2_2_sum, l2_1, u4_0e, u4_0f_right),
      u4_0d_lo = u4_0d_lo1 - (KSL_MUL(u1_3_sum_lo, l1_2) + KSL_MUL(u1_3_sum, l1_2_lo)) + u4_0b_lo,
      u4_0g = KSL_MUL(u3_1_sum, l3_0), u4_0 = u4_0f - u4_0g, u4_0_right = u4_0f - u4_0,
      u4_0_lo1 = u4_0f - (u4_0 + u4_0_right) - ksl_product_rest(u3_1_sum, l3_0, u4_0g, u4_0_right),
      u4_0f_lo = u4_0f_lo1 - (KSL_MUL(u2_2_sum_lo, l2_1) + KSL_MUL(u2_2_sum, l2_1_lo)) + u4_0d_lo,
      u4_0_lo = u4_0_lo1 - (KSL_MUL(u3_1_sum_lo, l3_0) + KSL_MUL(u3_1_sum, l3_0_lo)) + u4_0f_lo;
  const double u4_1a = KSL_MUL(A->at[0][5], l0_3), u4_1b = A->at[4][5] - u4_1a,
      u4_1b_right = A->at[4][5] - u4_1b, u4_1c = KSL_MUL(u1_4_sum, l1_2), u4_1d = u4_1b - u4_1c,
      u4_1d_right = u4_1b - u4_1d,
      u4_1d_lo1 = u4_1b - (u4_1d + u4_1d_right)
          - ksl_product_rest(u1_4_sum, l1_2, u4_1c, u4_1d_right),
      u4_1b_lo = A->at[4][5] - (u4_1b + u4_1b_right)
          - ksl_product_rest(A->at[0][5], l0_3, u4_1a, u4_1b_right) - KSL_MUL(A->at[0][5], l0_3_lo),
      u4_1e = KSL_MUL(u2_3_sum, l2_1), u4_1f = u4_1d - u4_1e, u4_1f_right = u4_1d - u4_1f,
      u4_1f_lo1 = u4_1d - (u4_1f + u4_1f_right)
          - ksl_product_rest(u2_3_sum, l2_1, u4_1e, u4_1f_right),
      u4_1d_lo = u4_1d_lo1 - (KSL_MUL(u1_4_sum_lo, l1_2) + KSL_MUL(u1_4_sum, l1_2_lo)) + u4_1b_lo,
      u4_1g = KSL_MUL(u3_2_sum, l3_0), u4_1 = u4_1f - u4_1g, u4_1_right = u4_1f - u4_1,
      u4_1_lo1 = u4_1f - (u4_1 + u4_1_right) - ksl_product_rest(u3_2_sum, l3_0, u4_1g, u4_1_right),
      u4_1f_lo = u4_1f_lo1 - (KSL_MUL(u2_3_sum_lo, l2_1) + KSL_MUL(u2_3_sum, l2_1_lo)) + u4_1d_lo,
      u4_1_lo = u4_1_lo1 - (KSL_MUL(u3_2_sum_lo, l3_0) + KSL_MUL(u3_2_sum, l3_0_lo)) + u4_1f_lo;
  const double u4_0_sum = u4_0 + u4_0_lo, u4_0_sum_right = u4_0_sum - u4_0,
      u4_0_sum_lo = u4_0 - (u4_0_sum - u4_0_sum_right) + (u4_0_lo - u4_0_sum_right),
      divisor4 = 0.0 < u4_0_sum ? u4_0_sum : 1.0, divisor4_lo = 0.0 < u4_0_sum ? u4_0_sum_lo : 0.0;
  const double u4_1_sum = u4_1 + u4_1_lo, u4_1_sum_right = u4_1_sum - u4_1,
      u4_1_sum_lo = u4_1 - (u4_1_sum - u4_1_sum_right) + (u4_1_lo - u4_1_sum_right),
      divisor4_sum = divisor4 + divisor4_lo, divisor4_sum_right = divisor4_sum - divisor4,
      divisor4_sum_lo = divisor4 - (divisor4_sum - divisor4_sum_right)
          + (divisor4_lo - divisor4_sum_right), l4 = u4_1_sum / divisor4_sum,
      l4_product = KSL_MUL(l4, divisor4_sum),
      l4_lo = (u4_1_sum - l4_product - ksl_product_error(l4, divisor4_sum, l4_product)
          + u4_1_sum_lo - KSL_MUL(l4, divisor4_sum_lo)) / divisor4_sum;
  const double u5a = KSL_MUL(A->at[0][5], l0_4), u5b = A->at[5][5] - u5a,
      u5b_right = A->at[5][5] - u5b, u5c = KSL_MUL(u1_4_sum, l1_3), u5d = u5b - u5c,
      u5d_right = u5b - u5d,
      u5d_lo2 = u5b - (u5d + u5d_right) - ksl_product_rest(u1_4_sum, l1_3, u5c, u5d_right)
          - (KSL_MUL(u1_4_sum_lo, l1_3) + KSL_MUL(u1_4_sum, l1_3_lo)),
      u5e = KSL_MUL(u2_3_sum, l2_2), u5f = u5d - u5e, u5f_right = u5d - u5f,
      u5f_lo2 = u5d - (u5f + u5f_right) - ksl_product_rest(u2_3_sum, l2_2, u5e, u5f_right)
          - (KSL_MUL(u2_3_sum_lo, l2_2) + KSL_MUL(u2_3_sum, l2_2_lo)),
      u5g = KSL_MUL(u3_2_sum, l3_1), u5h = u5f - u5g, u5h_right = u5f - u5h,
      u5f_lo = u5f_lo2
          + (u5d_lo2
          + (A->at[5][5] - (u5b + u5b_right) - ksl_product_rest(A->at[0][5], l0_4, u5a, u5b_right)
          - KSL_MUL(A->at[0][5], l0_4_lo))),
      u5h_lo2 = u5f - (u5h + u5h_right) - ksl_product_rest(u3_2_sum, l3_1, u5g, u5h_right)
          - (KSL_MUL(u3_2_sum_lo, l3_1) + KSL_MUL(u3_2_sum, l3_1_lo)), u5i = KSL_MUL(u4_1_sum, l4),
      u5 = u5h - u5i, u5_right = u5h - u5,
      u5_lo2 = u5h - (u5 + u5_right) - ksl_product_rest(u4_1_sum, l4, u5i, u5_right)
          - (KSL_MUL(u4_1_sum_lo, l4) + KSL_MUL(u4_1_sum, l4_lo)),
      u5_lo = u5_lo2 + (u5h_lo2 + u5f_lo);
  const double u5_sum = u5 + u5_lo, u5_sum_right = u5_sum - u5,
      u5_sum_lo = u5 - (u5_sum - u5_sum_right) + (u5_lo - u5_sum_right),
      divisor5 = 0.0 < u5_sum ? u5_sum : 1.0, divisor5_lo = 0.0 < u5_sum ? u5_sum_lo : 0.0;
  const double part0a = A->at[0][0] / divisor0, part0a_product = KSL_MUL(part0a, divisor0),
      part0a_lo = (A->at[0][0] - part0a_product
          - ksl_product_error(part0a, divisor0, part0a_product)) / divisor0,
      part0 = 0.0 < A->at[0][0] ? part0a : A->at[0][0],
      part0_lo = 0.0 < A->at[0][0] ? part0a_lo : 0.0;
  const double own1 = 0.0 < A->at[1][1] ? A->at[1][1] : 1.0;
  const double part1a = u1_0_sum / own1, part1a_product = KSL_MUL(part1a, own1),
      part1a_lo = (u1_0_sum - part1a_product - ksl_product_error(part1a, own1, part1a_product)
          + u1_0_sum_lo) / own1, part1 = 0.0 < A->at[1][1] ? part1a : A->at[1][1],
      part1_lo = 0.0 < A->at[1][1] ? part1a_lo : 0.0;
  const double part0_sum = part0 + part0_lo, part0_sum_right = part0_sum - part0,
      part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right),
      part1_sum = part1 + part1_lo, part1_sum_right = part1_sum - part1,
      part1_sum_lo = part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right),
      smallest1 = part0_sum < part1_sum ? part0_sum : part1_sum,
      smallest1_lo = part0_sum < part1_sum ? part0_sum_lo : part1_sum_lo;
  const double own2 = 0.0 < A->at[2][2] ? A->at[2][2] : 1.0;
  const double part2a = u2_0_sum / own2, part2a_product = KSL_MUL(part2a, own2),
      part2a_lo = (u2_0_sum - part2a_product - ksl_product_error(part2a, own2, part2a_product)
          + u2_0_sum_lo) / own2, part2 = 0.0 < A->at[2][2] ? part2a : A->at[2][2],
      part2_lo = 0.0 < A->at[2][2] ? part2a_lo : 0.0;
  const double smallest1_sum = smallest1 + smallest1_lo,
      smallest1_sum_right = smallest1_sum - smallest1,
      smallest1_sum_lo = smallest1 - (smallest1_sum - smallest1_sum_right)
          + (smallest1_lo - smallest1_sum_right), part2_sum = part2 + part2_lo,
      part2_sum_right = part2_sum - part2,
      part2_sum_lo = part2 - (part2_sum - part2_sum_right) + (part2_lo - part2_sum_right),
      smallest2 = smallest1_sum < part2_sum ? smallest1_sum : part2_sum,
      smallest2_lo = smallest1_sum < part2_sum ? smallest1_sum_lo : part2_sum_lo;
  const double own3 = 0.0 < A->at[3][3] ? A->at[3][3] : 1.0;
  const double part3a = u3_0_sum / own3, part3a_product = KSL_MUL(part3a, own3),
      part3a_lo = (u3_0_sum - part3a_product - ksl_product_error(part3a, own3, part3a_product)
          + u3_0_sum_lo) / own3, part3 = 0.0 < A->at[3][3] ? part3a : A->at[3][3],
      part3_lo = 0.0 < A->at[3][3] ? part3a_lo : 0.0;
  const double smallest2_sum = smallest2 + smallest2_lo,
      smallest2_sum_right = smallest2_sum - smallest2,
      smallest2_sum_lo = smallest2 - (smallest2_sum - smallest2_sum_right)
          + (smallest2_lo - smallest2_sum_right), part3_sum = part3 + part3_lo,
      part3_sum_right = part3_sum - part3,
      part3_sum_lo = part3 - (part3_sum - part3_sum_right) + (part3_lo - part3_sum_right),
      smallest3 = smallest2_sum < part3_sum ? smallest2_sum : part3_sum,
      smallest3_lo = smallest2_sum < part3_sum ? smallest2_sum_lo : part3_sum_lo;
  const double own4 = 0.0 < A->at[4][4] ? A->at[4][4] : 1.0;
  const double part4a = u4_0_sum / own4, part4a_product = KSL_MUL(part4a, own4),
      part4a_lo = (u4_0_sum - part4a_product - ksl_product_error(part4a, own4, part4a_product)
          + u4_0_sum_lo) / own4, part4 = 0.0 < A->at[4][4] ? part4a : A->at[4][4],
      part4_lo = 0.0 < A->at[4][4] ? part4a_lo : 0.0;
  const double smallest3_sum = smallest3 + smallest3_lo,
      smallest3_sum_right = smallest3_sum - smallest3,
      smallest3_sum_lo = smallest3 - (smallest3_sum - smallest3_sum_right)
          + (smallest3_lo - smallest3_sum_right), part4_sum = part4 + part4_lo,
      part4_sum_right = part4_sum - part4,
      part4_sum_lo = part4 - (part4_sum - part4_sum_right) + (part4_lo - part4_sum_right),
      smallest4 = smallest3_sum < part4_sum ? smallest3_sum : part4_sum,
      smallest4_lo = smallest3_sum < part4_sum ? smallest3_sum_lo : part4_sum_lo;
  const double own5 = 0.0 < A->at[5][5] ? A->at[5][5] : 1.0;
  const double part5a = u5_sum / own5, part5a_product = KSL_MUL(part5a, own5),
      part5a_lo = (u5_sum - part5a_product - ksl_product_error(part5a, own5, part5a_product)
          + u5_sum_lo) / own5, part5 = 0.0 < A->at[5][5] ? part5a : A->at[5][5],
      part5_lo = 0.0 < A->at[5][5] ? part5a_lo : 0.0;
  const double smallest4_sum = smallest4 + smallest4_lo,
      smallest4_sum_right = smallest4_sum - smallest4,
      smallest4_sum_lo = smallest4 - (smallest4_sum - smallest4_sum_right)
          + (smallest4_lo - smallest4_sum_right), part5_sum = part5 + part5_lo,
      part5_sum_right = part5_sum - part5,
      part5_sum_lo = part5 - (part5_sum - part5_sum_right) + (part5_lo - part5_sum_right),
      smallest5 = smallest4_sum < part5_sum ? smallest4_sum : part5_sum,
      smallest5_lo = smallest4_sum < part5_sum ? smallest4_sum_lo : part5_sum_lo;
  const double less_0 = KSL_MUL(A->at[0][0], 0.9999999999999944),
      less_1 = KSL_MUL(A->at[1][1], 0.9999999999999944),
      less_2 = KSL_MUL(A->at[2][2], 0.9999999999999944),
      less_3 = KSL_MUL(A->at[3][3], 0.9999999999999944),
      less_4 = KSL_MUL(A->at[4][4], 0.9999999999999944),
      less_5 = KSL_MUL(A->at[5][5], 0.9999999999999944);
  const double less_0_lo = ksl_product_error(A->at[0][0], 0.9999999999999944, less_0),
      less_0_sum = less_0 + less_0_lo, less_0_sum_right = less_0_sum - less_0,
      less_0_sum_lo = less_0 - (less_0_sum - less_0_sum_right) + (less_0_lo - less_0_sum_right),
      less_divisor0 = 0.0 < less_0_sum ? less_0_sum : 1.0,
      less_divisor0_lo = 0.0 < less_0_sum ? less_0_sum_lo : 0.0;
  const double less_divisor0_sum = less_divisor0 + less_divisor0_lo,
      less_divisor0_sum_right = less_divisor0_sum - less_divisor0,
      less_divisor0_sum_lo = less_divisor0 - (less_divisor0_sum - less_divisor0_sum_right)
          + (less_divisor0_lo - less_divisor0_sum_right),
      less_l0_0 = A->at[0][1] / less_divisor0_sum,
      less_l0_0_product = KSL_MUL(less_l0_0, less_divisor0_sum),
      less_l0_0_exact = A->at[0][1] - less_l0_0_product
          - ksl_product_error(less_l0_0, less_divisor0_sum, less_l0_0_product),
      less_l0_0_lo = (less_l0_0_exact - KSL_MUL(less_l0_0, less_divisor0_sum_lo))
          / less_divisor0_sum;
  const double less_l0_1 = A->at[0][2] / less_divisor0_sum,
      less_l0_1_product = KSL_MUL(less_l0_1, less_divisor0_sum),
      less_l0_1_exact = A->at[0][2] - less_l0_1_product
          - ksl_product_error(less_l0_1, less_divisor0_sum, less_l0_1_product),
      less_l0_1_lo = (less_l0_1_exact - KSL_MUL(less_l0_1, less_divisor0_sum_lo))
          / less_divisor0_sum;
  const double less_l0_2 = A->at[0][3] / less_divisor0_sum,
      less_l0_2_product = KSL_MUL(less_l0_2, less_divisor0_sum),
      less_l0_2_exact = A->at[0][3] - less_l0_2_product
          - ksl_product_error(less_l0_2, less_divisor0_sum, less_l0_2_product),
      less_l0_2_lo = (less_l0_2_exact - KSL_MUL(less_l0_2, less_divisor0_sum_lo))
          / less_divisor0_sum;
  const double less_l0_3 = A->at[0][4] / less_divisor0_sum,
      less_l0_3_product = KSL_MUL(less_l0_3, less_divisor0_sum),
      less_l0_3_exact = A->at[0][4] - less_l0_3_product
          - ksl_product_error(less_l0_3, less_divisor0_sum, less_l0_3_product),
      less_l0_3_lo = (less_l0_3_exact - KSL_MUL(less_l0_3, less_divisor0_sum_lo))
          / less_divisor0_sum;
  const double less_l0_4 = A->at[0][5] / less_divisor0_sum,
      less_l0_4_product = KSL_MUL(less_l0_4, less_divisor0_sum),
      less_l0_4_exact = A->at[0][5] - less_l0_4_product
          - ksl_product_error(less_l0_4, less_divisor0_sum, less_l0_4_product);
  const double less_u1_0a = KSL_MUL(A->at[0][1], less_l0_0), less_u1_0 = less_1 - less_u1_0a,
      less_u1_0_right = less_1 - less_u1_0,
      less_u1_0_left_rest = ksl_product_rest(A->at[1][1], 0.9999999999999944, less_1, less_u1_0
          + less_u1_0_right),
      less_u1_0_lo = less_u1_0_left_rest
          - ksl_product_rest(A->at[0][1], less_l0_0, less_u1_0a, less_u1_0_right)
          - KSL_MUL(A->at[0][1], less_l0_0_lo);
  const double less_u1_1a = KSL_MUL(A->at[0][2], less_l0_0), less_u1_1 = A->at[1][2] - less_u1_1a,
      less_u1_1_right = A->at[1][2] - less_u1_1,
      less_u1_1_lo1 = A->at[1][2] - (less_u1_1 + less_u1_1_right)
          - ksl_product_rest(A->at[0][2], less_l0_0, less_u1_1a, less_u1_1_right),
      less_u1_1_lo = less_u1_1_lo1 - KSL_MUL(A->at[0][2], less_l0_0_lo);
  const double less_u1_2a = KSL_MUL(A->at[0][3], less_l0_0), less_u1_2 = A->at[1][3] - less_u1_2a,
      less_u1_2_right = A->at[1][3] - less_u1_2,
      less_u1_2_lo1 = A->at[1][3] - (less_u1_2 + less_u1_2_right)
          - ksl_product_rest(A->at[0][3], less_l0_0, less_u1_2a, less_u1_2_right),
      less_u1_2_lo = less_u1_2_lo1 - KSL_MUL(A->at[0][3], less_l0_0_lo);
  const double less_u1_3a = KSL_MUL(A->at[0][4], less_l0_0), less_u1_3 = A->at[1][4] - less_u1_3a,
      less_u1_3_right = A->at[1][4] - less_u1_3,
      less_u1_3_lo1 = A->at[1][4] - (less_u1_3 + less_u1_3_right)
          - ksl_product_rest(A->at[0][4], less_l0_0, less_u1_3a, less_u1_3_right),
      less_u1_3_lo = less_u1_3_lo1 - KSL_MUL(A->at[0][4], less_l0_0_lo);
  const double less_u1_4a = KSL_MUL(A->at[0][5], less_l0_0), less_u1_4 = A->at[1][5] - less_u1_4a,
      less_u1_4_right = A->at[1][5] - less_u1_4,
      less_u1_4_lo1 = A->at[1][5] - (less_u1_4 + less_u1_4_right)
          - ksl_product_rest(A->at[0][5], less_l0_0, less_u1_4a, less_u1_4_right),
      less_u1_4_lo = less_u1_4_lo1 - KSL_MUL(A->at[0][5], less_l0_0_lo);
  const double less_u1_0_sum = less_u1_0 + less_u1_0_lo,
      less_u1_0_sum_right = less_u1_0_sum - less_u1_0,
      less_u1_0_sum_lo = less_u1_0 - (less_u1_0_sum - less_u1_0_sum_right)
          + (less_u1_0_lo - less_u1_0_sum_right),
      less_divisor1 = 0.0 < less_u1_0_sum ? less_u1_0_sum : 1.0,
      less_divisor1_lo = 0.0 < less_u1_0_sum ? less_u1_0_sum_lo : 0.0;
  const double less_u1_1_sum = less_u1_1 + less_u1_1_lo,
      less_u1_1_sum_right = less_u1_1_sum - less_u1_1,
      less_u1_1_sum_lo = less_u1_1 - (less_u1_1_sum - less_u1_1_sum_right)
          + (less_u1_1_lo - less_u1_1_sum_right),
      less_divisor1_sum = less_divisor1 + less_divisor1_lo,
      less_divisor1_sum_right = less_divisor1_sum - less_divisor1,
      less_divisor1_sum_lo = less_divisor1 - (less_divisor1_sum - less_divisor1_sum_right)
          + (less_divisor1_lo - less_divisor1_sum_right),
      less_l1_0 = less_u1_1_sum / less_divisor1_sum,
      less_l1_0_product = KSL_MUL(less_l1_0, less_divisor1_sum),
      less_l1_0_numerator = less_u1_1_sum - less_l1_0_product
          - ksl_product_error(less_l1_0, less_divisor1_sum, less_l1_0_product) + less_u1_1_sum_lo,
      less_l1_0_lo = (less_l1_0_numerator - KSL_MUL(less_l1_0, less_divisor1_sum_lo))
          / less_divisor1_sum;
  const double less_u1_2_sum = less_u1_2 + less_u1_2_lo,
      less_u1_2_sum_right = less_u1_2_sum - less_u1_2,
      less_u1_2_sum_lo = less_u1_2 - (less_u1_2_sum - less_u1_2_sum_right)
          + (less_u1_2_lo - less_u1_2_sum_right), less_l1_1 = less_u1_2_sum / less_divisor1_sum,
      less_l1_1_product = KSL_MUL(less_l1_1, less_divisor1_sum),
      less_l1_1_numerator = less_u1_2_sum - less_l1_1_product
          - ksl_product_error(less_l1_1, less_divisor1_sum, less_l1_1_product) + less_u1_2_sum_lo,
      less_l1_1_lo = (less_l1_1_numerator - KSL_MUL(less_l1_1, less_divisor1_sum_lo))
          / less_divisor1_sum;
  const double less_u1_3_sum = less_u1_3 + less_u1_3_lo,
      less_u1_3_sum_right = less_u1_3_sum - less_u1_3,
      less_u1_3_sum_lo = less_u1_3 - (less_u1_3_sum - less_u1_3_sum_right)
          + (less_u1_3_lo - less_u1_3_sum_right), less_l1_2 = less_u1_3_sum / less_divisor1_sum,
      less_l1_2_product = KSL_MUL(less_l1_2, less_divisor1_sum),
      less_l1_2_numerator = less_u1_3_sum - less_l1_2_product
          - ksl_product_error(less_l1_2, less_divisor1_sum, less_l1_2_product) + less_u1_3_sum_lo,
      less_l1_2_lo = (less_l1_2_numerator - KSL_MUL(less_l1_2, less_divisor1_sum_lo))
          / less_divisor1_sum;
  const double less_u1_4_sum = less_u1_4 + less_u1_4_lo,
      less_u1_4_sum_right = less_u1_4_sum - less_u1_4,
      less_u1_4_sum_lo = less_u1_4 - (less_u1_4_sum - less_u1_4_sum_right)
          + (less_u1_4_lo - less_u1_4_sum_right), less_l1_3 = less_u1_4_sum / less_divisor1_sum,
      less_l1_3_product = KSL_MUL(less_l1_3, less_divisor1_sum),
      less_l1_3_numerator = less_u1_4_sum - less_l1_3_product
          - ksl_product_error(less_l1_3, less_divisor1_sum, less_l1_3_product) + less_u1_4_sum_lo;
  const double less_u2_0a = KSL_MUL(A->at[0][2], less_l0_1), less_u2_0b = less_2 - less_u2_0a,
      less_u2_0b_right = less_2 - less_u2_0b,
      less_u2_0b_left_rest = ksl_product_rest(A->at[2][2], 0.9999999999999944, less_2, less_u2_0b
          + less_u2_0b_right), less_u2_0c = KSL_MUL(less_u1_1_sum, less_l1_0),
      less_u2_0 = less_u2_0b - less_u2_0c, less_u2_0_right = less_u2_0b - less_u2_0,
      less_u2_0_lo1 = less_u2_0b - (less_u2_0 + less_u2_0_right)
          - ksl_product_rest(less_u1_1_sum, less_l1_0, less_u2_0c, less_u2_0_right),
      less_u2_0b_lo = less_u2_0b_left_rest
          - ksl_product_rest(A->at[0][2], less_l0_1, less_u2_0a, less_u2_0b_right)
          - KSL_MUL(A->at[0][2], less_l0_1_lo),
      less_u2_0_lo = less_u2_0_lo1
          - (KSL_MUL(less_u1_1_sum_lo, less_l1_0) + KSL_MUL(less_u1_1_sum, less_l1_0_lo))
          + less_u2_0b_lo;
  const double less_u2_1a = KSL_MUL(A->at[0][3], less_l0_1), less_u2_1b = A->at[2][3] - less_u2_1a,
      less_u2_1b_right = A->at[2][3] - less_u2_1b,
      less_u2_1b_lo1 = A->at[2][3] - (less_u2_1b + less_u2_1b_right)
          - ksl_product_rest(A->at[0][3], less_l0_1, less_u2_1a, less_u2_1b_right),
      less_u2_1c = KSL_MUL(less_u1_2_sum, less_l1_0), less_u2_1 = less_u2_1b - less_u2_1c,
      less_u2_1_right = less_u2_1b - less_u2_1,
      less_u2_1_lo1 = less_u2_1b - (less_u2_1 + less_u2_1_right)
          - ksl_product_rest(less_u1_2_sum, less_l1_0, less_u2_1c, less_u2_1_right),
      less_u2_1_lo2 = less_u2_1_lo1
          - (KSL_MUL(less_u1_2_sum_lo, less_l1_0) + KSL_MUL(less_u1_2_sum, less_l1_0_lo)),
      less_u2_1_lo = less_u2_1_lo2 + (less_u2_1b_lo1 - KSL_MUL(A->at[0][3], less_l0_1_lo));
  const double less_u2_2a = KSL_MUL(A->at[0][4], less_l0_1), less_u2_2b = A->at[2][4] - less_u2_2a,
      less_u2_2b_right = A->at[2][4] - less_u2_2b,
      less_u2_2b_lo1 = A->at[2][4] - (less_u2_2b + less_u2_2b_right)
          - ksl_product_rest(A->at[0][4], less_l0_1, less_u2_2a, less_u2_2b_right),
      less_u2_2c = KSL_MUL(less_u1_3_sum, less_l1_0), less_u2_2 = less_u2_2b - less_u2_2c,
      less_u2_2_right = less_u2_2b - less_u2_2,
      less_u2_2_lo1 = less_u2_2b - (less_u2_2 + less_u2_2_right)
          - ksl_product_rest(less_u1_3_sum, less_l1_0, less_u2_2c, less_u2_2_right),
      less_u2_2_lo2 = less_u2_2_lo1
          - (KSL_MUL(less_u1_3_sum_lo, less_l1_0) + KSL_MUL(less_u1_3_sum, less_l1_0_lo)),
      less_u2_2_lo = less_u2_2_lo2 + (less_u2_2b_lo1 - KSL_MUL(A->at[0][4], less_l0_1_lo));
  const double less_u2_3a = KSL_MUL(A->at[0][5], less_l0_1), less_u2_3b = A->at[2][5] - less_u2_3a,
      less_u2_3b_right = A->at[2][5] - less_u2_3b,
      less_u2_3b_lo1 = A->at[2][5] - (less_u2_3b + less_u2_3b_right)
          - ksl_product_rest(A->at[0][5], less_l0_1, less_u2_3a, less_u2_3b_right),
      less_u2_3c = KSL_MUL(less_u1_4_sum, less_l1_0), less_u2_3 = less_u2_3b - less_u2_3c,
      less_u2_3_right = less_u2_3b - less_u2_3,
      less_u2_3_lo1 = less_u2_3b - (less_u2_3 + less_u2_3_right)
          - ksl_product_rest(less_u1_4_sum, less_l1_0, less_u2_3c, less_u2_3_right),
      less_u2_3_lo2 = less_u2_3_lo1
          - (KSL_MUL(less_u1_4_sum_lo, less_l1_0) + KSL_MUL(less_u1_4_sum, less_l1_0_lo)),
      less_u2_3_lo = less_u2_3_lo2 + (less_u2_3b_lo1 - KSL_MUL(A->at[0][5], less_l0_1_lo));
  const double less_u2_0_sum = less_u2_0 + less_u2_0_lo,
      less_u2_0_sum_right = less_u2_0_sum - less_u2_0,
      less_u2_0_sum_lo = less_u2_0 - (less_u2_0_sum - less_u2_0_sum_right)
          + (less_u2_0_lo - less_u2_0_sum_right),
      less_divisor2 = 0.0 < less_u2_0_sum ? less_u2_0_sum : 1.0,
      less_divisor2_lo = 0.0 < less_u2_0_sum ? less_u2_0_sum_lo : 0.0;
  const double less_u2_1_sum = less_u2_1 + less_u2_1_lo,
      less_u2_1_sum_right = less_u2_1_sum - less_u2_1,
      less_u2_1_sum_lo = less_u2_1 - (less_u2_1_sum - less_u2_1_sum_right)
          + (less_u2_1_lo - less_u2_1_sum_right),
      less_divisor2_sum = less_divisor2 + less_divisor2_lo,
      less_divisor2_sum_right = less_divisor2_sum - less_divisor2,
      less_divisor2_sum_lo = less_divisor2 - (less_divisor2_sum - less_divisor2_sum_right)
          + (less_divisor2_lo - less_divisor2_sum_right),
      less_l2_0 = less_u2_1_sum / less_divisor2_sum,
      less_l2_0_product = KSL_MUL(less_l2_0, less_divisor2_sum),
      less_l2_0_numerator = less_u2_1_sum - less_l2_0_product
          - ksl_product_error(less_l2_0, less_divisor2_sum, less_l2_0_product) + less_u2_1_sum_lo,
      less_l2_0_lo = (less_l2_0_numerator - KSL_MUL(less_l2_0, less_divisor2_sum_lo))
          / less_divisor2_sum;
  const double less_u2_2_sum = less_u2_2 + less_u2_2_lo,
      less_u2_2_sum_right = less_u2_2_sum - less_u2_2,
      less_u2_2_sum_lo = less_u2_2 - (less_u2_2_sum - less_u2_2_sum_right)
          + (less_u2_2_lo - less_u2_2_sum_right), less_l2_1 = less_u2_2_sum / less_divisor2_sum,
      less_l2_1_product = KSL_MUL(less_l2_1, less_divisor2_sum),
      less_l2_1_numerator = less_u2_2_sum - less_l2_1_product
          - ksl_product_error(less_l2_1, less_divisor2_sum, less_l2_1_product) + less_u2_2_sum_lo,
      less_l2_1_lo = (less_l2_1_numerator - KSL_MUL(less_l2_1, less_divisor2_sum_lo))
          / less_divisor2_sum;
  const double less_u2_3_sum = less_u2_3 + less_u2_3_lo,
      less_u2_3_sum_right = less_u2_3_sum - less_u2_3,
      less_u2_3_sum_lo = less_u2_3 - (less_u2_3_sum - less_u2_3_sum_right)
          + (less_u2_3_lo - less_u2_3_sum_right), less_l2_2 = less_u2_3_sum / less_divisor2_sum,
      less_l2_2_product = KSL_MUL(less_l2_2, less_divisor2_sum),
      less_l2_2_numerator = less_u2_3_sum - less_l2_2_product
          - ksl_product_error(less_l2_2, less_divisor2_sum, less_l2_2_product) + less_u2_3_sum_lo;
  const double less_u3_0a = KSL_MUL(A->at[0][3], less_l0_2), less_u3_0b = less_3 - less_u3_0a,
      less_u3_0b_right = less_3 - less_u3_0b,
      less_u3_0b_left_rest = ksl_product_rest(A->at[3][3], 0.9999999999999944, less_3, less_u3_0b
          + less_u3_0b_right), less_u3_0c = KSL_MUL(less_u1_2_sum, less_l1_1),
      less_u3_0d = less_u3_0b - less_u3_0c, less_u3_0d_right = less_u3_0b - less_u3_0d,
      less_u3_0d_lo1 = less_u3_0b - (less_u3_0d + less_u3_0d_right)
          - ksl_product_rest(less_u1_2_sum, less_l1_1, less_u3_0c, less_u3_0d_right),
      less_u3_0b_lo = less_u3_0b_left_rest
          - ksl_product_rest(A->at[0][3], less_l0_2, less_u3_0a, less_u3_0b_right)
          - KSL_MUL(A->at[0][3], less_l0_2_lo), less_u3_0e = KSL_MUL(less_u2_1_sum, less_l2_0),
      less_u3_0 = less_u3_0d - less_u3_0e, less_u3_0_right = less_u3_0d - less_u3_0,
      less_u3_0_lo1 = less_u3_0d - (less_u3_0 + less_u3_0_right)
          - ksl_product_rest(less_u2_1_sum, less_l2_0, less_u3_0e, less_u3_0_right),
      less_u3_0d_lo = less_u3_0d_lo1
          - (KSL_MUL(less_u1_2_sum_lo, less_l1_1) + KSL_MUL(less_u1_2_sum, less_l1_1_lo))
          + less_u3_0b_lo,
      less_u3_0_lo = less_u3_0_lo1
          - (KSL_MUL(less_u2_1_sum_lo, less_l2_0) + KSL_MUL(less_u2_1_sum, less_l2_0_lo))
          + less_u3_0d_lo;
  const double less_u3_1a = KSL_MUL(A->at[0][4], less_l0_2), less_u3_1b = A->at[3][4] - less_u3_1a,
      less_u3_1b_right = A->at[3][4] - less_u3_1b,
      less_u3_1b_lo1 = A->at[3][4] - (less_u3_1b + less_u3_1b_right)
          - ksl_product_rest(A->at[0][4], less_l0_2, less_u3_1a, less_u3_1b_right),
      less_u3_1c = KSL_MUL(less_u1_3_sum, less_l1_1), less_u3_1d = less_u3_1b - less_u3_1c,
      less_u3_1d_right = less_u3_1b - less_u3_1d,
      less_u3_1d_lo1 = less_u3_1b - (less_u3_1d + less_u3_1d_right)
          - ksl_product_rest(less_u1_3_sum, less_l1_1, less_u3_1c, less_u3_1d_right),
      less_u3_1d_lo2 = less_u3_1d_lo1
          - (KSL_MUL(less_u1_3_sum_lo, less_l1_1) + KSL_MUL(less_u1_3_sum, less_l1_1_lo)),
      less_u3_1e = KSL_MUL(less_u2_2_sum, less_l2_0), less_u3_1 = less_u3_1d - less_u3_1e,
      less_u3_1_right = less_u3_1d - less_u3_1,
      less_u3_1_lo1 = less_u3_1d - (less_u3_1 + less_u3_1_right)
          - ksl_product_rest(less_u2_2_sum, less_l2_0, less_u3_1e, less_u3_1_right),
      less_u3_1_lo2 = less_u3_1_lo1
          - (KSL_MUL(less_u2_2_sum_lo, less_l2_0) + KSL_MUL(less_u2_2_sum, less_l2_0_lo)),
      less_u3_1_lo = less_u3_1_lo2
          + (less_u3_1d_lo2 + (less_u3_1b_lo1 - KSL_MUL(A->at[0][4], less_l0_2_lo)));
  const double less_u3_2a = KSL_MUL(A->at[0][5], less_l0_2), less_u3_2b = A->at[3][5] - less_u3_2a,
      less_u3_2b_right = A->at[3][5] - less_u3_2b,
      less_u3_2b_lo1 = A->at[3][5] - (less_u3_2b + less_u3_2b_right)
          - ksl_product_rest(A->at[0][5], less_l0_2, less_u3_2a, less_u3_2b_right),
      less_u3_2c = KSL_MUL(less_u1_4_sum, less_l1_1), less_u3_2d = less_u3_2b - less_u3_2c,
      less_u3_2d_right = less_u3_2b - less_u3_2d,
      less_u3_2d_lo1 = less_u3_2b - (less_u3_2d + less_u3_2d_right)
          - ksl_product_rest(less_u1_4_sum, less_l1_1, less_u3_2c, less_u3_2d_right),
      less_u3_2d_lo2 = less_u3_2d_lo1
          - (KSL_MUL(less_u1_4_sum_lo, less_l1_1) + KSL_MUL(less_u1_4_sum, less_l1_1_lo)),
      less_u3_2e = KSL_MUL(less_u2_3_sum, less_l2_0), less_u3_2 = less_u3_2d - less_u3_2e,
      less_u3_2_right = less_u3_2d - less_u3_2,
      less_u3_2_lo1 = less_u3_2d - (less_u3_2 + less_u3_2_right)
          - ksl_product_rest(less_u2_3_sum, less_l2_0, less_u3_2e, less_u3_2_right),
      less_u3_2_lo2 = less_u3_2_lo1
          - (KSL_MUL(less_u2_3_sum_lo, less_l2_0) + KSL_MUL(less_u2_3_sum, less_l2_0_lo)),
      less_u3_2_lo = less_u3_2_lo2
          + (less_u3_2d_lo2 + (less_u3_2b_lo1 - KSL_MUL(A->at[0][5], less_l0_2_lo)));
  const double less_u3_0_sum = less_u3_0 + less_u3_0_lo,
      less_u3_0_sum_right = less_u3_0_sum - less_u3_0,
      less_u3_0_sum_lo = less_u3_0 - (less_u3_0_sum - less_u3_0_sum_right)
          + (less_u3_0_lo - less_u3_0_sum_right),
      less_divisor3 = 0.0 < less_u3_0_sum ? less_u3_0_sum : 1.0,
      less_divisor3_lo = 0.0 < less_u3_0_sum ? less_u3_0_sum_lo : 0.0;
  const double less_u3_1_sum = less_u3_1 + less_u3_1_lo,
      less_u3_1_sum_right = less_u3_1_sum - less_u3_1,
      less_u3_1_sum_lo = less_u3_1 - (less_u3_1_sum - less_u3_1_sum_right)
          + (less_u3_1_lo - less_u3_1_sum_right),
      less_divisor3_sum = less_divisor3 + less_divisor3_lo,
      less_divisor3_sum_right = less_divisor3_sum - less_divisor3,
      less_divisor3_sum_lo = less_divisor3 - (less_divisor3_sum - less_divisor3_sum_right)
          + (less_divisor3_lo - less_divisor3_sum_right),
      less_l3_0 = less_u3_1_sum / less_divisor3_sum,
      less_l3_0_product = KSL_MUL(less_l3_0, less_divisor3_sum),
      less_l3_0_numerator = less_u3_1_sum - less_l3_0_product
          - ksl_product_error(less_l3_0, less_divisor3_sum, less_l3_0_product) + less_u3_1_sum_lo,
      less_l3_0_lo = (less_l3_0_numerator - KSL_MUL(less_l3_0, less_divisor3_sum_lo))
          / less_divisor3_sum;
  const double less_u3_2_sum = less_u3_2 + less_u3_2_lo,
      less_u3_2_sum_right = less_u3_2_sum - less_u3_2,
      less_u3_2_sum_lo = less_u3_2 - (less_u3_2_sum - less_u3_2_sum_right)
          + (less_u3_2_lo - less_u3_2_sum_right), less_l3_1 = less_u3_2_sum / less_divisor3_sum,
      less_l3_1_product = KSL_MUL(less_l3_1, less_divisor3_sum),
      less_l3_1_numerator = less_u3_2_sum - less_l3_1_product
          - ksl_product_error(less_l3_1, less_divisor3_sum, less_l3_1_product) + less_u3_2_sum_lo;
  const double less_u4_0a = KSL_MUL(A->at[0][4], less_l0_3), less_u4_0b = less_4 - less_u4_0a,
      less_u4_0b_right = less_4 - less_u4_0b,
      less_u4_0b_left_rest = ksl_product_rest(A->at[4][4], 0.9999999999999944, less_4, less_u4_0b
          + less_u4_0b_right), less_u4_0c = KSL_MUL(less_u1_3_sum, less_l1_2),
      less_u4_0d = less_u4_0b - less_u4_0c, less_u4_0d_right = less_u4_0b - less_u4_0d,
      less_u4_0d_lo1 = less_u4_0b - (less_u4_0d + less_u4_0d_right)
          - ksl_product_rest(less_u1_3_sum, less_l1_2, less_u4_0c, less_u4_0d_right),
      less_u4_0b_lo = less_u4_0b_left_rest
          - ksl_product_rest(A->at[0][4], less_l0_3, less_u4_0a, less_u4_0b_right)
          - KSL_MUL(A->at[0][4], less_l0_3_lo), less_u4_0e = KSL_MUL(less_u2_2_sum, less_l2_1),
      less_u4_0f = less_u4_0d - less_u4_0e, less_u4_0f_right = less_u4_0d - less_u4_0f,
      less_u4_0f_lo1 = less_u4_0d - (less_u4_0f + less_u4_0f_right)
          - ksl_product_rest(less_u2_2_sum, less_l2_1, less_u4_0e, less_u4_0f_right),
      less_u4_0d_lo = less_u4_0d_lo1
          - (KSL_MUL(less_u1_3_sum_lo, less_l1_2) + KSL_MUL(less_u1_3_sum, less_l1_2_lo))
          + less_u4_0b_lo, less_u4_0g = KSL_MUL(less_u3_1_sum, less_l3_0),
      less_u4_0 = less_u4_0f - less_u4_0g, less_u4_0_right = less_u4_0f - less_u4_0,
      less_u4_0_lo1 = less_u4_0f - (less_u4_0 + less_u4_0_right)
          - ksl_product_rest(less_u3_1_sum, less_l3_0, less_u4_0g, less_u4_0_right),
      less_u4_0f_lo = less_u4_0f_lo1
          - (KSL_MUL(less_u2_2_sum_lo, less_l2_1) + KSL_MUL(less_u2_2_sum, less_l2_1_lo))
          + less_u4_0d_lo,
      less_u4_0_lo = less_u4_0_lo1
          - (KSL_MUL(less_u3_1_sum_lo, less_l3_0) + KSL_MUL(less_u3_1_sum, less_l3_0_lo))
          + less_u4_0f_lo;
  const double less_u4_1a = KSL_MUL(A->at[0][5], less_l0_3), less_u4_1b = A->at[4][5] - less_u4_1a,
      less_u4_1b_right = A->at[4][5] - less_u4_1b,
      less_u4_1b_lo1 = A->at[4][5] - (less_u4_1b + less_u4_1b_right)
          - ksl_product_rest(A->at[0][5], less_l0_3, less_u4_1a, less_u4_1b_right),
      less_u4_1c = KSL_MUL(less_u1_4_sum, less_l1_2), less_u4_1d = less_u4_1b - less_u4_1c,
      less_u4_1d_right = less_u4_1b - less_u4_1d,
      less_u4_1d_lo1 = less_u4_1b - (less_u4_1d + less_u4_1d_right)
          - ksl_product_rest(less_u1_4_sum, less_l1_2, less_u4_1c, less_u4_1d_right),
      less_u4_1d_lo2 = less_u4_1d_lo1
          - (KSL_MUL(less_u1_4_sum_lo, less_l1_2) + KSL_MUL(less_u1_4_sum, less_l1_2_lo)),
      less_u4_1e = KSL_MUL(less_u2_3_sum, less_l2_1), less_u4_1f = less_u4_1d - less_u4_1e,
      less_u4_1f_right = less_u4_1d - less_u4_1f,
      less_u4_1f_lo1 = less_u4_1d - (less_u4_1f + less_u4_1f_right)
          - ksl_product_rest(less_u2_3_sum, less_l2_1, less_u4_1e, less_u4_1f_right),
      less_u4_1f_lo2 = less_u4_1f_lo1
          - (KSL_MUL(less_u2_3_sum_lo, less_l2_1) + KSL_MUL(less_u2_3_sum, less_l2_1_lo)),
      less_u4_1g = KSL_MUL(less_u3_2_sum, less_l3_0), less_u4_1 = less_u4_1f - less_u4_1g,
      less_u4_1_right = less_u4_1f - less_u4_1,
      less_u4_1_lo1 = less_u4_1f - (less_u4_1 + less_u4_1_right)
          - ksl_product_rest(less_u3_2_sum, less_l3_0, less_u4_1g, less_u4_1_right),
      less_u4_1_lo2 = less_u4_1_lo1
          - (KSL_MUL(less_u3_2_sum_lo, less_l3_0) + KSL_MUL(less_u3_2_sum, less_l3_0_lo)),
      less_u4_1_lo = less_u4_1_lo2
          + (less_u4_1f_lo2
          + (less_u4_1d_lo2 + (less_u4_1b_lo1 - KSL_MUL(A->at[0][5], less_l0_3_lo))));
  const double less_u4_0_sum = less_u4_0 + less_u4_0_lo,
      less_u4_0_sum_right = less_u4_0_sum - less_u4_0,
      less_u4_0_sum_lo = less_u4_0 - (less_u4_0_sum - less_u4_0_sum_right)
          + (less_u4_0_lo - less_u4_0_sum_right),
      less_divisor4 = 0.0 < less_u4_0_sum ? less_u4_0_sum : 1.0,
      less_divisor4_lo = 0.0 < less_u4_0_sum ? less_u4_0_sum_lo : 0.0;
  const double less_u4_1_sum = less_u4_1 + less_u4_1_lo,
      less_u4_1_sum_right = less_u4_1_sum - less_u4_1,
      less_u4_1_sum_lo = less_u4_1 - (less_u4_1_sum - less_u4_1_sum_right)
          + (less_u4_1_lo - less_u4_1_sum_right),
      less_divisor4_sum = less_divisor4 + less_divisor4_lo,
      less_divisor4_sum_right = less_divisor4_sum - less_divisor4,
      less_l4 = less_u4_1_sum / less_divisor4_sum,
      less_l4_product = KSL_MUL(less_l4, less_divisor4_sum),
      less_l4_cross = KSL_MUL(less_l4, less_divisor4
          - (less_divisor4_sum - less_divisor4_sum_right)
          + (less_divisor4_lo - less_divisor4_sum_right)),
      less_l4_residual = less_u4_1_sum - less_l4_product
          - ksl_product_error(less_l4, less_divisor4_sum, less_l4_product) + less_u4_1_sum_lo
          - less_l4_cross;
  const double less_u5a = KSL_MUL(A->at[0][5], less_l0_4), less_u5b = less_5 - less_u5a,
      less_u5b_right = less_5 - less_u5b,
      less_u5b_left_rest = ksl_product_rest(A->at[5][5], 0.9999999999999944, less_5, less_u5b
          + less_u5b_right),
      less_u5a_cross2 = KSL_MUL(A->at[0][5], (less_l0_4_exact
          - KSL_MUL(less_l0_4, less_divisor0_sum_lo)) / less_divisor0_sum),
      less_u5c = KSL_MUL(less_u1_4_sum, less_l1_3),
      less_u5c_cross2 = KSL_MUL(less_u1_4_sum, (less_l1_3_numerator
          - KSL_MUL(less_l1_3, less_divisor1_sum_lo)) / less_divisor1_sum),
      less_u5d = less_u5b - less_u5c, less_u5d_right = less_u5b - less_u5d,
      less_u5d_lo1 = less_u5b - (less_u5d + less_u5d_right)
          - ksl_product_rest(less_u1_4_sum, less_l1_3, less_u5c, less_u5d_right),
      less_u5b_lo = less_u5b_left_rest
          - ksl_product_rest(A->at[0][5], less_l0_4, less_u5a, less_u5b_right) - less_u5a_cross2,
      less_u5e = KSL_MUL(less_u2_3_sum, less_l2_2),
      less_u5e_cross2 = KSL_MUL(less_u2_3_sum, (less_l2_2_numerator
          - KSL_MUL(less_l2_2, less_divisor2_sum_lo)) / less_divisor2_sum),
      less_u5f = less_u5d - less_u5e, less_u5f_right = less_u5d - less_u5f,
      less_u5f_lo1 = less_u5d - (less_u5f + less_u5f_right)
          - ksl_product_rest(less_u2_3_sum, less_l2_2, less_u5e, less_u5f_right),
      less_u5d_lo = less_u5d_lo1 - (KSL_MUL(less_u1_4_sum_lo, less_l1_3) + less_u5c_cross2)
          + less_u5b_lo, less_u5g = KSL_MUL(less_u3_2_sum, less_l3_1),
      less_u5g_cross2 = KSL_MUL(less_u3_2_sum, (less_l3_1_numerator
          - KSL_MUL(less_l3_1, less_divisor3_sum_lo)) / less_divisor3_sum),
      less_u5h = less_u5f - less_u5g, less_u5h_right = less_u5f - less_u5h,
      less_u5h_lo1 = less_u5f - (less_u5h + less_u5h_right)
          - ksl_product_rest(less_u3_2_sum, less_l3_1, less_u5g, less_u5h_right),
      less_u5f_lo = less_u5f_lo1 - (KSL_MUL(less_u2_3_sum_lo, less_l2_2) + less_u5e_cross2)
          + less_u5d_lo, less_u5i = KSL_MUL(less_u4_1_sum, less_l4), less_u5 = less_u5h - less_u5i,
      less_u5_right = less_u5h - less_u5,
      less_u5_lo1 = less_u5h - (less_u5 + less_u5_right)
          - ksl_product_rest(less_u4_1_sum, less_l4, less_u5i, less_u5_right),
      less_u5_lo2 = less_u5_lo1
          - (KSL_MUL(less_u4_1_sum_lo, less_l4)
          + KSL_MUL(less_u4_1_sum, less_l4_residual / less_divisor4_sum));
  const double regular_b = 0.0 < less_u5
          + (less_u5_lo2
          + (less_u5h_lo1 - (KSL_MUL(less_u3_2_sum_lo, less_l3_1) + less_u5g_cross2)
          + less_u5f_lo)) ? 1.0 : 0.0, regular_c = 0.0 < less_u4_0_sum ? regular_b : 0.0,
      regular_d = 0.0 < less_u3_0_sum ? regular_c : 0.0,
      regular_e = 0.0 < less_u2_0_sum ? regular_d : 0.0,
      regular_f = 0.0 < less_u1_0_sum ? regular_e : 0.0,
      regular = 0.0 < less_0_sum ? regular_f : 0.0;
  const double smallest5_sum = smallest5 + smallest5_lo,
      smallest5_sum_right = smallest5_sum - smallest5,
      smallest5_sum_lo = smallest5 - (smallest5_sum - smallest5_sum_right)
          + (smallest5_lo - smallest5_sum_right), least = smallest5_sum < 0.0 ? smallest5_sum : 0.0,
      least_lo = smallest5_sum < 0.0 ? smallest5_sum_lo : 0.0;
  const double y1a = KSL_MUL(b->m0, l0_0), y1 = b->m1 - y1a, y1_right = b->m1 - y1,
      y1_lo = b->m1 - (y1 + y1_right) - ksl_product_rest(b->m0, l0_0, y1a, y1_right)
          - KSL_MUL(b->m0, l0_0_lo);
  const double y2a = KSL_MUL(b->m0, l0_1), y2b = b->m2 - y2a, y2b_right = b->m2 - y2b,
      y2c = KSL_MUL(l1_0, y1), y2 = y2b - y2c, y2_right = y2b - y2,
      y2_lo2 = y2b - (y2 + y2_right) - ksl_product_rest(l1_0, y1, y2c, y2_right)
          - (KSL_MUL(l1_0_lo, y1) + KSL_MUL(l1_0, y1_lo)),
      y2_lo = y2_lo2
          + (b->m2 - (y2b + y2b_right) - ksl_product_rest(b->m0, l0_1, y2a, y2b_right)
          - KSL_MUL(b->m0, l0_1_lo));
  const double y3a = KSL_MUL(b->m0, l0_2), y3b = b->m3 - y3a, y3b_right = b->m3 - y3b,
      y3c = KSL_MUL(l1_1, y1), y3d = y3b - y3c, y3d_right = y3b - y3d,
      y3d_lo2 = y3b - (y3d + y3d_right) - ksl_product_rest(l1_1, y1, y3c, y3d_right)
          - (KSL_MUL(l1_1_lo, y1) + KSL_MUL(l1_1, y1_lo)), y3e = KSL_MUL(l2_0, y2), y3 = y3d - y3e,
      y3_right = y3d - y3,
      y3_lo2 = y3d - (y3 + y3_right) - ksl_product_rest(l2_0, y2, y3e, y3_right)
          - (KSL_MUL(l2_0_lo, y2) + KSL_MUL(l2_0, y2_lo)),
      y3_lo = y3_lo2
          + (y3d_lo2
          + (b->m3 - (y3b + y3b_right) - ksl_product_rest(b->m0, l0_2, y3a, y3b_right)
          - KSL_MUL(b->m0, l0_2_lo)));
  const double y4a = KSL_MUL(b->m0, l0_3), y4b = b->m4 - y4a, y4b_right = b->m4 - y4b,
      y4c = KSL_MUL(l1_2, y1), y4d = y4b - y4c, y4d_right = y4b - y4d,
      y4d_lo2 = y4b - (y4d + y4d_right) - ksl_product_rest(l1_2, y1, y4c, y4d_right)
          - (KSL_MUL(l1_2_lo, y1) + KSL_MUL(l1_2, y1_lo)), y4e = KSL_MUL(l2_1, y2), y4f = y4d - y4e,
      y4f_right = y4d - y4f,
      y4f_lo2 = y4d - (y4f + y4f_right) - ksl_product_rest(l2_1, y2, y4e, y4f_right)
          - (KSL_MUL(l2_1_lo, y2) + KSL_MUL(l2_1, y2_lo)), y4g = KSL_MUL(l3_0, y3), y4 = y4f - y4g,
      y4_right = y4f - y4,
      y4f_lo = y4f_lo2
          + (y4d_lo2
          + (b->m4 - (y4b + y4b_right) - ksl_product_rest(b->m0, l0_3, y4a, y4b_right)
          - KSL_MUL(b->m0, l0_3_lo))),
      y4_lo = y4f - (y4 + y4_right) - ksl_product_rest(l3_0, y3, y4g, y4_right)
          - (KSL_MUL(l3_0_lo, y3) + KSL_MUL(l3_0, y3_lo)) + y4f_lo;
  const double y5a = KSL_MUL(b->m0, l0_4), y5b = b->m5 - y5a, y5b_right = b->m5 - y5b,
      y5c = KSL_MUL(l1_3, y1), y5d = y5b - y5c, y5d_right = y5b - y5d,
      y5d_lo2 = y5b - (y5d + y5d_right) - ksl_product_rest(l1_3, y1, y5c, y5d_right)
          - (KSL_MUL(l1_3_lo, y1) + KSL_MUL(l1_3, y1_lo)), y5e = KSL_MUL(l2_2, y2), y5f = y5d - y5e,
      y5f_right = y5d - y5f,
      y5f_lo2 = y5d - (y5f + y5f_right) - ksl_product_rest(l2_2, y2, y5e, y5f_right)
          - (KSL_MUL(l2_2_lo, y2) + KSL_MUL(l2_2, y2_lo)), y5g = KSL_MUL(l3_1, y3), y5h = y5f - y5g,
      y5h_right = y5f - y5h,
      y5f_lo = y5f_lo2
          + (y5d_lo2
          + (b->m5 - (y5b + y5b_right) - ksl_product_rest(b->m0, l0_4, y5a, y5b_right)
          - KSL_MUL(b->m0, l0_4_lo))), y5i = KSL_MUL(l4, y4), y5 = y5h - y5i, y5_right = y5h - y5,
      y5h_lo = y5f - (y5h + y5h_right) - ksl_product_rest(l3_1, y3, y5g, y5h_right)
          - (KSL_MUL(l3_1_lo, y3) + KSL_MUL(l3_1, y3_lo)) + y5f_lo,
      y5_lo = y5h - (y5 + y5_right) - ksl_product_rest(l4, y4, y5i, y5_right)
          - (KSL_MUL(l4_lo, y4) + KSL_MUL(l4, y4_lo)) + y5h_lo;
  const double z0 = b->m0 / divisor0, z0_product = KSL_MUL(z0, divisor0);
  const double y1_sum = y1 + y1_lo, y1_sum_right = y1_sum - y1, z1 = y1_sum / divisor1_sum,
      z1_product = KSL_MUL(z1, divisor1_sum),
      z1_numerator = y1_sum - z1_product - ksl_product_error(z1, divisor1_sum, z1_product)
          + (y1 - (y1_sum - y1_sum_right) + (y1_lo - y1_sum_right));
  const double y2_sum = y2 + y2_lo, y2_sum_right = y2_sum - y2, z2 = y2_sum / divisor2_sum,
      z2_product = KSL_MUL(z2, divisor2_sum),
      z2_numerator = y2_sum - z2_product - ksl_product_error(z2, divisor2_sum, z2_product)
          + (y2 - (y2_sum - y2_sum_right) + (y2_lo - y2_sum_right));
  const double y3_sum = y3 + y3_lo, y3_sum_right = y3_sum - y3, z3 = y3_sum / divisor3_sum,
      z3_product = KSL_MUL(z3, divisor3_sum),
      z3_numerator = y3_sum - z3_product - ksl_product_error(z3, divisor3_sum, z3_product)
          + (y3 - (y3_sum - y3_sum_right) + (y3_lo - y3_sum_right));
  const double y4_sum = y4 + y4_lo, y4_sum_right = y4_sum - y4, z4 = y4_sum / divisor4_sum,
      z4_product = KSL_MUL(z4, divisor4_sum),
      z4_numerator = y4_sum - z4_product - ksl_product_error(z4, divisor4_sum, z4_product)
          + (y4 - (y4_sum - y4_sum_right) + (y4_lo - y4_sum_right));
  const double y5_sum = y5 + y5_lo, y5_sum_right = y5_sum - y5,
      divisor5_sum = divisor5 + divisor5_lo, divisor5_sum_right = divisor5_sum - divisor5,
      divisor5_sum_lo = divisor5 - (divisor5_sum - divisor5_sum_right)
          + (divisor5_lo - divisor5_sum_right), z5 = y5_sum / divisor5_sum,
      z5_product = KSL_MUL(z5, divisor5_sum),
      z5_numerator = y5_sum - z5_product - ksl_product_error(z5, divisor5_sum, z5_product)
          + (y5 - (y5_sum - y5_sum_right) + (y5_lo - y5_sum_right)),
      z5_lo = (z5_numerator - KSL_MUL(z5, divisor5_sum_lo)) / divisor5_sum;
  const double x4a = KSL_MUL(l4, z5), x4 = z4 - x4a, x4_right = z4 - x4,
      x4_lo2 = z4 - (x4 + x4_right) - ksl_product_rest(l4, z5, x4a, x4_right)
          - (KSL_MUL(l4_lo, z5) + KSL_MUL(l4, z5_lo)),
      x4_lo = x4_lo2 + (z4_numerator - KSL_MUL(z4, divisor4_sum_lo)) / divisor4_sum;
  const double x3a = KSL_MUL(l3_0, x4), x3b = z3 - x3a, x3b_right = z3 - x3b,
      x3b_lo2 = z3 - (x3b + x3b_right) - ksl_product_rest(l3_0, x4, x3a, x3b_right)
          - (KSL_MUL(l3_0_lo, x4) + KSL_MUL(l3_0, x4_lo)), x3c = KSL_MUL(l3_1, z5), x3 = x3b - x3c,
      x3_right = x3b - x3,
      x3_lo2 = x3b - (x3 + x3_right) - ksl_product_rest(l3_1, z5, x3c, x3_right)
          - (KSL_MUL(l3_1_lo, z5) + KSL_MUL(l3_1, z5_lo)),
      x3_lo = x3_lo2 + (x3b_lo2 + (z3_numerator - KSL_MUL(z3, divisor3_sum_lo)) / divisor3_sum);
  const double x2a = KSL_MUL(l2_0, x3), x2b = z2 - x2a, x2b_right = z2 - x2b,
      x2b_lo2 = z2 - (x2b + x2b_right) - ksl_product_rest(l2_0, x3, x2a, x2b_right)
          - (KSL_MUL(l2_0_lo, x3) + KSL_MUL(l2_0, x3_lo)), x2c = KSL_MUL(l2_1, x4), x2d = x2b - x2c,
      x2d_right = x2b - x2d,
      x2d_lo2 = x2b - (x2d + x2d_right) - ksl_product_rest(l2_1, x4, x2c, x2d_right)
          - (KSL_MUL(l2_1_lo, x4) + KSL_MUL(l2_1, x4_lo)), x2e = KSL_MUL(l2_2, z5), x2 = x2d - x2e,
      x2_right = x2d - x2,
      x2_lo2 = x2d - (x2 + x2_right) - ksl_product_rest(l2_2, z5, x2e, x2_right)
          - (KSL_MUL(l2_2_lo, z5) + KSL_MUL(l2_2, z5_lo)),
      x2_lo = x2_lo2
          + (x2d_lo2 + (x2b_lo2 + (z2_numerator - KSL_MUL(z2, divisor2_sum_lo)) / divisor2_sum));
  const double x1a = KSL_MUL(l1_0, x2), x1b = z1 - x1a, x1b_right = z1 - x1b,
      x1b_lo2 = z1 - (x1b + x1b_right) - ksl_product_rest(l1_0, x2, x1a, x1b_right)
          - (KSL_MUL(l1_0_lo, x2) + KSL_MUL(l1_0, x2_lo)), x1c = KSL_MUL(l1_1, x3), x1d = x1b - x1c,
      x1d_right = x1b - x1d,
      x1d_lo2 = x1b - (x1d + x1d_right) - ksl_product_rest(l1_1, x3, x1c, x1d_right)
          - (KSL_MUL(l1_1_lo, x3) + KSL_MUL(l1_1, x3_lo)), x1e = KSL_MUL(l1_2, x4), x1f = x1d - x1e,
      x1f_right = x1d - x1f,
      x1f_lo2 = x1d - (x1f + x1f_right) - ksl_product_rest(l1_2, x4, x1e, x1f_right)
          - (KSL_MUL(l1_2_lo, x4) + KSL_MUL(l1_2, x4_lo)), x1g = KSL_MUL(l1_3, z5), x1 = x1f - x1g,
      x1_right = x1f - x1,
      x1_lo2 = x1f - (x1 + x1_right) - ksl_product_rest(l1_3, z5, x1g, x1_right)
          - (KSL_MUL(l1_3_lo, z5) + KSL_MUL(l1_3, z5_lo)),
      x1_lo = x1_lo2
          + (x1f_lo2
          + (x1d_lo2 + (x1b_lo2 + (z1_numerator - KSL_MUL(z1, divisor1_sum_lo)) / divisor1_sum)));
  const double x0a = KSL_MUL(l0_0, x1), x0b = z0 - x0a, x0b_right = z0 - x0b,
      x0b_lo2 = z0 - (x0b + x0b_right) - ksl_product_rest(l0_0, x1, x0a, x0b_right)
          - (KSL_MUL(l0_0_lo, x1) + KSL_MUL(l0_0, x1_lo)), x0c = KSL_MUL(l0_1, x2), x0d = x0b - x0c,
      x0d_right = x0b - x0d,
      x0d_lo2 = x0b - (x0d + x0d_right) - ksl_product_rest(l0_1, x2, x0c, x0d_right)
          - (KSL_MUL(l0_1_lo, x2) + KSL_MUL(l0_1, x2_lo)), x0e = KSL_MUL(l0_2, x3), x0f = x0d - x0e,
      x0f_right = x0d - x0f,
      x0f_lo2 = x0d - (x0f + x0f_right) - ksl_product_rest(l0_2, x3, x0e, x0f_right)
          - (KSL_MUL(l0_2_lo, x3) + KSL_MUL(l0_2, x3_lo)), x0g = KSL_MUL(l0_3, x4), x0h = x0f - x0g,
      x0h_right = x0f - x0h,
      x0h_lo2 = x0f - (x0h + x0h_right) - ksl_product_rest(l0_3, x4, x0g, x0h_right)
          - (KSL_MUL(l0_3_lo, x4) + KSL_MUL(l0_3, x4_lo)), x0i = KSL_MUL(l0_4, z5), x0 = x0h - x0i,
      x0_right = x0h - x0,
      x0h_lo = x0h_lo2
          + (x0f_lo2
          + (x0d_lo2
          + (x0b_lo2 + (b->m0 - z0_product - ksl_product_error(z0, divisor0, z0_product))
          / divisor0))),
      x0_lo = x0h - (x0 + x0_right) - ksl_product_rest(l0_4, z5, x0i, x0_right)
          - (KSL_MUL(l0_4_lo, z5) + KSL_MUL(l0_4, z5_lo)) + x0h_lo;
  const double residual_0a = KSL_MUL(A->at[0][0], x0), residual_0b = b->m0 - residual_0a,
      residual_0b_right = b->m0 - residual_0b,
      residual_0b_lo1 = b->m0 - (residual_0b + residual_0b_right)
          - ksl_product_rest(A->at[0][0], x0, residual_0a, residual_0b_right),
      residual_0c = KSL_MUL(A->at[0][1], x1), residual_0d = residual_0b - residual_0c,
      residual_0d_right = residual_0b - residual_0d,
      residual_0d_lo1 = residual_0b - (residual_0d + residual_0d_right)
          - ksl_product_rest(A->at[0][1], x1, residual_0c, residual_0d_right),
      residual_0e = KSL_MUL(A->at[0][2], x2), residual_0f = residual_0d - residual_0e,
      residual_0f_right = residual_0d - residual_0f,
      residual_0f_lo1 = residual_0d - (residual_0f + residual_0f_right)
          - ksl_product_rest(A->at[0][2], x2, residual_0e, residual_0f_right),
      residual_0d_lo = residual_0d_lo1 - KSL_MUL(A->at[0][1], x1_lo)
          + (residual_0b_lo1 - KSL_MUL(A->at[0][0], x0_lo)), residual_0g = KSL_MUL(A->at[0][3], x3),
      residual_0h = residual_0f - residual_0g, residual_0h_right = residual_0f - residual_0h,
      residual_0h_lo1 = residual_0f - (residual_0h + residual_0h_right)
          - ksl_product_rest(A->at[0][3], x3, residual_0g, residual_0h_right),
      residual_0i = KSL_MUL(A->at[0][4], x4), residual_0j = residual_0h - residual_0i,
      residual_0j_right = residual_0h - residual_0j,
      residual_0j_lo1 = residual_0h - (residual_0j + residual_0j_right)
          - ksl_product_rest(A->at[0][4], x4, residual_0i, residual_0j_right),
      residual_0h_lo = residual_0h_lo1 - KSL_MUL(A->at[0][3], x3_lo)
          + (residual_0f_lo1 - KSL_MUL(A->at[0][2], x2_lo) + residual_0d_lo),
      residual_0k = KSL_MUL(A->at[0][5], z5), residual_0 = residual_0j - residual_0k,
      residual_0_right = residual_0j - residual_0,
      residual_0_lo1 = residual_0j - (residual_0 + residual_0_right)
          - ksl_product_rest(A->at[0][5], z5, residual_0k, residual_0_right),
      residual_0_lo = residual_0_lo1 - KSL_MUL(A->at[0][5], z5_lo)
          + (residual_0j_lo1 - KSL_MUL(A->at[0][4], x4_lo) + residual_0h_lo);
  const double residual_1a = KSL_MUL(A->at[0][1], x0), residual_1b = b->m1 - residual_1a,
      residual_1b_right = b->m1 - residual_1b,
      residual_1b_lo1 = b->m1 - (residual_1b + residual_1b_right)
          - ksl_product_rest(A->at[0][1], x0, residual_1a, residual_1b_right),
      residual_1c = KSL_MUL(A->at[1][1], x1), residual_1d = residual_1b - residual_1c,
      residual_1d_right = residual_1b - residual_1d,
      residual_1d_lo1 = residual_1b - (residual_1d + residual_1d_right)
          - ksl_product_rest(A->at[1][1], x1, residual_1c, residual_1d_right),
      residual_1e = KSL_MUL(A->at[1][2], x2), residual_1f = residual_1d - residual_1e,
      residual_1f_right = residual_1d - residual_1f,
      residual_1f_lo1 = residual_1d - (residual_1f + residual_1f_right)
          - ksl_product_rest(A->at[1][2], x2, residual_1e, residual_1f_right),
      residual_1d_lo = residual_1d_lo1 - KSL_MUL(A->at[1][1], x1_lo)
          + (residual_1b_lo1 - KSL_MUL(A->at[0][1], x0_lo)), residual_1g = KSL_MUL(A->at[1][3], x3),
      residual_1h = residual_1f - residual_1g, residual_1h_right = residual_1f - residual_1h,
      residual_1h_lo1 = residual_1f - (residual_1h + residual_1h_right)
          - ksl_product_rest(A->at[1][3], x3, residual_1g, residual_1h_right),
      residual_1i = KSL_MUL(A->at[1][4], x4), residual_1j = residual_1h - residual_1i,
      residual_1j_right = residual_1h - residual_1j,
      residual_1j_lo1 = residual_1h - (residual_1j + residual_1j_right)
          - ksl_product_rest(A->at[1][4], x4, residual_1i, residual_1j_right),
      residual_1h_lo = residual_1h_lo1 - KSL_MUL(A->at[1][3], x3_lo)
          + (residual_1f_lo1 - KSL_MUL(A->at[1][2], x2_lo) + residual_1d_lo),
      residual_1k = KSL_MUL(A->at[1][5], z5), residual_1 = residual_1j - residual_1k,
      residual_1_right = residual_1j - residual_1,
      residual_1_lo1 = residual_1j - (residual_1 + residual_1_right)
          - ksl_product_rest(A->at[1][5], z5, residual_1k, residual_1_right);
  const double residual_2a = KSL_MUL(A->at[0][2], x0), residual_2b = b->m2 - residual_2a,
      residual_2b_right = b->m2 - residual_2b,
      residual_2b_lo1 = b->m2 - (residual_2b + residual_2b_right)
          - ksl_product_rest(A->at[0][2], x0, residual_2a, residual_2b_right),
      residual_2c = KSL_MUL(A->at[1][2], x1), residual_2d = residual_2b - residual_2c,
      residual_2d_right = residual_2b - residual_2d,
      residual_2d_lo1 = residual_2b - (residual_2d + residual_2d_right)
          - ksl_product_rest(A->at[1][2], x1, residual_2c, residual_2d_right),
      residual_2e = KSL_MUL(A->at[2][2], x2), residual_2f = residual_2d - residual_2e,
      residual_2f_right = residual_2d - residual_2f,
      residual_2f_lo1 = residual_2d - (residual_2f + residual_2f_right)
          - ksl_product_rest(A->at[2][2], x2, residual_2e, residual_2f_right),
      residual_2d_lo = residual_2d_lo1 - KSL_MUL(A->at[1][2], x1_lo)
          + (residual_2b_lo1 - KSL_MUL(A->at[0][2], x0_lo)), residual_2g = KSL_MUL(A->at[2][3], x3),
      residual_2h = residual_2f - residual_2g, residual_2h_right = residual_2f - residual_2h,
      residual_2h_lo1 = residual_2f - (residual_2h + residual_2h_right)
          - ksl_product_rest(A->at[2][3], x3, residual_2g, residual_2h_right),
      residual_2i = KSL_MUL(A->at[2][4], x4), residual_2j = residual_2h - residual_2i,
      residual_2j_right = residual_2h - residual_2j,
      residual_2j_lo1 = residual_2h - (residual_2j + residual_2j_right)
          - ksl_product_rest(A->at[2][4], x4, residual_2i, residual_2j_right),
      residual_2h_lo = residual_2h_lo1 - KSL_MUL(A->at[2][3], x3_lo)
          + (residual_2f_lo1 - KSL_MUL(A->at[2][2], x2_lo) + residual_2d_lo),
      residual_2k = KSL_MUL(A->at[2][5], z5), residual_2 = residual_2j - residual_2k,
      residual_2_right = residual_2j - residual_2,
      residual_2_lo1 = residual_2j - (residual_2 + residual_2_right)
          - ksl_product_rest(A->at[2][5], z5, residual_2k, residual_2_right);
  const double residual_3a = KSL_MUL(A->at[0][3], x0), residual_3b = b->m3 - residual_3a,
      residual_3b_right = b->m3 - residual_3b,
      residual_3b_lo1 = b->m3 - (residual_3b + residual_3b_right)
          - ksl_product_rest(A->at[0][3], x0, residual_3a, residual_3b_right),
      residual_3c = KSL_MUL(A->at[1][3], x1), residual_3d = residual_3b - residual_3c,
      residual_3d_right = residual_3b - residual_3d,
      residual_3d_lo1 = residual_3b - (residual_3d + residual_3d_right)
          - ksl_product_rest(A->at[1][3], x1, residual_3c, residual_3d_right),
      residual_3e = KSL_MUL(A->at[2][3], x2), residual_3f = residual_3d - residual_3e,
      residual_3f_right = residual_3d - residual_3f,
      residual_3f_lo1 = residual_3d - (residual_3f + residual_3f_right)
          - ksl_product_rest(A->at[2][3], x2, residual_3e, residual_3f_right),
      residual_3d_lo = residual_3d_lo1 - KSL_MUL(A->at[1][3], x1_lo)
          + (residual_3b_lo1 - KSL_MUL(A->at[0][3], x0_lo)), residual_3g = KSL_MUL(A->at[3][3], x3),
      residual_3h = residual_3f - residual_3g, residual_3h_right = residual_3f - residual_3h,
      residual_3h_lo1 = residual_3f - (residual_3h + residual_3h_right)
          - ksl_product_rest(A->at[3][3], x3, residual_3g, residual_3h_right),
      residual_3i = KSL_MUL(A->at[3][4], x4), residual_3j = residual_3h - residual_3i,
      residual_3j_right = residual_3h - residual_3j,
      residual_3j_lo1 = residual_3h - (residual_3j + residual_3j_right)
          - ksl_product_rest(A->at[3][4], x4, residual_3i, residual_3j_right),
      residual_3h_lo = residual_3h_lo1 - KSL_MUL(A->at[3][3], x3_lo)
          + (residual_3f_lo1 - KSL_MUL(A->at[2][3], x2_lo) + residual_3d_lo),
      residual_3k = KSL_MUL(A->at[3][5], z5), residual_3 = residual_3j - residual_3k,
      residual_3_right = residual_3j - residual_3,
      residual_3_lo1 = residual_3j - (residual_3 + residual_3_right)
          - ksl_product_rest(A->at[3][5], z5, residual_3k, residual_3_right);
  const double residual_4a = KSL_MUL(A->at[0][4], x0), residual_4b = b->m4 - residual_4a,
      residual_4b_right = b->m4 - residual_4b,
      residual_4b_lo1 = b->m4 - (residual_4b + residual_4b_right)
          - ksl_product_rest(A->at[0][4], x0, residual_4a, residual_4b_right),
      residual_4c = KSL_MUL(A->at[1][4], x1), residual_4d = residual_4b - residual_4c,
      residual_4d_right = residual_4b - residual_4d,
      residual_4d_lo1 = residual_4b - (residual_4d + residual_4d_right)
          - ksl_product_rest(A->at[1][4], x1, residual_4c, residual_4d_right),
      residual_4e = KSL_MUL(A->at[2][4], x2), residual_4f = residual_4d - residual_4e,
      residual_4f_right = residual_4d - residual_4f,
      residual_4f_lo1 = residual_4d - (residual_4f + residual_4f_right)
          - ksl_product_rest(A->at[2][4], x2, residual_4e, residual_4f_right),
      residual_4d_lo = residual_4d_lo1 - KSL_MUL(A->at[1][4], x1_lo)
          + (residual_4b_lo1 - KSL_MUL(A->at[0][4], x0_lo)), residual_4g = KSL_MUL(A->at[3][4], x3),
      residual_4h = residual_4f - residual_4g, residual_4h_right = residual_4f - residual_4h,
      residual_4h_lo1 = residual_4f - (residual_4h + residual_4h_right)
          - ksl_product_rest(A->at[3][4], x3, residual_4g, residual_4h_right),
      residual_4i = KSL_MUL(A->at[4][4], x4), residual_4j = residual_4h - residual_4i,
      residual_4j_right = residual_4h - residual_4j,
      residual_4j_lo1 = residual_4h - (residual_4j + residual_4j_right)
          - ksl_product_rest(A->at[4][4], x4, residual_4i, residual_4j_right),
      residual_4h_lo = residual_4h_lo1 - KSL_MUL(A->at[3][4], x3_lo)
          + (residual_4f_lo1 - KSL_MUL(A->at[2][4], x2_lo) + residual_4d_lo),
      residual_4k = KSL_MUL(A->at[4][5], z5), residual_4 = residual_4j - residual_4k,
      residual_4_right = residual_4j - residual_4,
      residual_4_lo1 = residual_4j - (residual_4 + residual_4_right)
          - ksl_product_rest(A->at[4][5], z5, residual_4k, residual_4_right);
  const double residual_5a = KSL_MUL(A->at[0][5], x0), residual_5b = b->m5 - residual_5a,
      residual_5b_right = b->m5 - residual_5b,
      residual_5b_lo1 = b->m5 - (residual_5b + residual_5b_right)
          - ksl_product_rest(A->at[0][5], x0, residual_5a, residual_5b_right),
      residual_5c = KSL_MUL(A->at[1][5], x1), residual_5d = residual_5b - residual_5c,
      residual_5d_right = residual_5b - residual_5d,
      residual_5d_lo1 = residual_5b - (residual_5d + residual_5d_right)
          - ksl_product_rest(A->at[1][5], x1, residual_5c, residual_5d_right),
      residual_5e = KSL_MUL(A->at[2][5], x2), residual_5f = residual_5d - residual_5e,
      residual_5f_right = residual_5d - residual_5f,
      residual_5f_lo1 = residual_5d - (residual_5f + residual_5f_right)
          - ksl_product_rest(A->at[2][5], x2, residual_5e, residual_5f_right),
      residual_5d_lo = residual_5d_lo1 - KSL_MUL(A->at[1][5], x1_lo)
          + (residual_5b_lo1 - KSL_MUL(A->at[0][5], x0_lo)), residual_5g = KSL_MUL(A->at[3][5], x3),
      residual_5h = residual_5f - residual_5g, residual_5h_right = residual_5f - residual_5h,
      residual_5h_lo1 = residual_5f - (residual_5h + residual_5h_right)
          - ksl_product_rest(A->at[3][5], x3, residual_5g, residual_5h_right),
      residual_5i = KSL_MUL(A->at[4][5], x4), residual_5j = residual_5h - residual_5i,
      residual_5j_right = residual_5h - residual_5j,
      residual_5j_lo1 = residual_5h - (residual_5j + residual_5j_right)
          - ksl_product_rest(A->at[4][5], x4, residual_5i, residual_5j_right),
      residual_5h_lo = residual_5h_lo1 - KSL_MUL(A->at[3][5], x3_lo)
          + (residual_5f_lo1 - KSL_MUL(A->at[2][5], x2_lo) + residual_5d_lo),
      residual_5k = KSL_MUL(A->at[5][5], z5), residual_5 = residual_5j - residual_5k,
      residual_5_right = residual_5j - residual_5,
      residual_5_lo1 = residual_5j - (residual_5 + residual_5_right)
          - ksl_product_rest(A->at[5][5], z5, residual_5k, residual_5_right);
  const double refined_y1a = KSL_MUL(l0_0, residual_0), refined_y1 = residual_1 - refined_y1a,
      refined_y1_right = residual_1 - refined_y1,
      refined_y1_lo1 = residual_1 - (refined_y1 + refined_y1_right)
          - ksl_product_rest(l0_0, residual_0, refined_y1a, refined_y1_right);
  const double residual_1_lo = residual_1_lo1 - KSL_MUL(A->at[1][5], z5_lo)
          + (residual_1j_lo1 - KSL_MUL(A->at[1][4], x4_lo) + residual_1h_lo);
  const double refined_y1_lo = refined_y1_lo1
          - (KSL_MUL(l0_0_lo, residual_0) + KSL_MUL(l0_0, residual_0_lo)) + residual_1_lo;
  const double refined_y2a = KSL_MUL(l0_1, residual_0), refined_y2b = residual_2 - refined_y2a,
      refined_y2b_right = residual_2 - refined_y2b,
      refined_y2b_lo1 = residual_2 - (refined_y2b + refined_y2b_right)
          - ksl_product_rest(l0_1, residual_0, refined_y2a, refined_y2b_right);
  const double residual_2_lo = residual_2_lo1 - KSL_MUL(A->at[2][5], z5_lo)
          + (residual_2j_lo1 - KSL_MUL(A->at[2][4], x4_lo) + residual_2h_lo);
  const double refined_y2c = KSL_MUL(l1_0, refined_y1), refined_y2 = refined_y2b - refined_y2c,
      refined_y2_right = refined_y2b - refined_y2,
      refined_y2_lo1 = refined_y2b - (refined_y2 + refined_y2_right)
          - ksl_product_rest(l1_0, refined_y1, refined_y2c, refined_y2_right),
      refined_y2b_lo = refined_y2b_lo1
          - (KSL_MUL(l0_1_lo, residual_0) + KSL_MUL(l0_1, residual_0_lo)) + residual_2_lo,
      refined_y2_lo = refined_y2_lo1
          - (KSL_MUL(l1_0_lo, refined_y1) + KSL_MUL(l1_0, refined_y1_lo)) + refined_y2b_lo;
  const double refined_y3a = KSL_MUL(l0_2, residual_0), refined_y3b = residual_3 - refined_y3a,
      refined_y3b_right = residual_3 - refined_y3b,
      refined_y3b_lo1 = residual_3 - (refined_y3b + refined_y3b_right)
          - ksl_product_rest(l0_2, residual_0, refined_y3a, refined_y3b_right);
  const double residual_3_lo = residual_3_lo1 - KSL_MUL(A->at[3][5], z5_lo)
          + (residual_3j_lo1 - KSL_MUL(A->at[3][4], x4_lo) + residual_3h_lo);
  const double refined_y3c = KSL_MUL(l1_1, refined_y1), refined_y3d = refined_y3b - refined_y3c,
      refined_y3d_right = refined_y3b - refined_y3d,
      refined_y3d_lo1 = refined_y3b - (refined_y3d + refined_y3d_right)
          - ksl_product_rest(l1_1, refined_y1, refined_y3c, refined_y3d_right),
      refined_y3b_lo = refined_y3b_lo1
          - (KSL_MUL(l0_2_lo, residual_0) + KSL_MUL(l0_2, residual_0_lo)) + residual_3_lo,
      refined_y3e = KSL_MUL(l2_0, refined_y2), refined_y3 = refined_y3d - refined_y3e,
      refined_y3_right = refined_y3d - refined_y3,
      refined_y3_lo1 = refined_y3d - (refined_y3 + refined_y3_right)
          - ksl_product_rest(l2_0, refined_y2, refined_y3e, refined_y3_right),
      refined_y3d_lo = refined_y3d_lo1
          - (KSL_MUL(l1_1_lo, refined_y1) + KSL_MUL(l1_1, refined_y1_lo)) + refined_y3b_lo,
      refined_y3_lo = refined_y3_lo1
          - (KSL_MUL(l2_0_lo, refined_y2) + KSL_MUL(l2_0, refined_y2_lo)) + refined_y3d_lo;
  const double refined_y4a = KSL_MUL(l0_3, residual_0), refined_y4b = residual_4 - refined_y4a,
      refined_y4b_right = residual_4 - refined_y4b,
      refined_y4b_lo1 = residual_4 - (refined_y4b + refined_y4b_right)
          - ksl_product_rest(l0_3, residual_0, refined_y4a, refined_y4b_right);
  const double residual_4_lo = residual_4_lo1 - KSL_MUL(A->at[4][5], z5_lo)
          + (residual_4j_lo1 - KSL_MUL(A->at[4][4], x4_lo) + residual_4h_lo);
  const double refined_y4c = KSL_MUL(l1_2, refined_y1), refined_y4d = refined_y4b - refined_y4c,
      refined_y4d_right = refined_y4b - refined_y4d,
      refined_y4d_lo1 = refined_y4b - (refined_y4d + refined_y4d_right)
          - ksl_product_rest(l1_2, refined_y1, refined_y4c, refined_y4d_right),
      refined_y4b_lo = refined_y4b_lo1
          - (KSL_MUL(l0_3_lo, residual_0) + KSL_MUL(l0_3, residual_0_lo)) + residual_4_lo,
      refined_y4e = KSL_MUL(l2_1, refined_y2), refined_y4f = refined_y4d - refined_y4e,
      refined_y4f_right = refined_y4d - refined_y4f,
      refined_y4f_lo1 = refined_y4d - (refined_y4f + refined_y4f_right)
          - ksl_product_rest(l2_1, refined_y2, refined_y4e, refined_y4f_right),
      refined_y4d_lo = refined_y4d_lo1
          - (KSL_MUL(l1_2_lo, refined_y1) + KSL_MUL(l1_2, refined_y1_lo)) + refined_y4b_lo,
      refined_y4g = KSL_MUL(l3_0, refined_y3), refined_y4 = refined_y4f - refined_y4g,
      refined_y4_right = refined_y4f - refined_y4,
      refined_y4_lo1 = refined_y4f - (refined_y4 + refined_y4_right)
          - ksl_product_rest(l3_0, refined_y3, refined_y4g, refined_y4_right),
      refined_y4f_lo = refined_y4f_lo1
          - (KSL_MUL(l2_1_lo, refined_y2) + KSL_MUL(l2_1, refined_y2_lo)) + refined_y4d_lo,
      refined_y4_lo = refined_y4_lo1
          - (KSL_MUL(l3_0_lo, refined_y3) + KSL_MUL(l3_0, refined_y3_lo)) + refined_y4f_lo;
  const double refined_y5a = KSL_MUL(l0_4, residual_0), refined_y5b = residual_5 - refined_y5a,
      refined_y5b_right = residual_5 - refined_y5b,
      refined_y5b_lo1 = residual_5 - (refined_y5b + refined_y5b_right)
          - ksl_product_rest(l0_4, residual_0, refined_y5a, refined_y5b_right);
  const double residual_5_lo = residual_5_lo1 - KSL_MUL(A->at[5][5], z5_lo)
          + (residual_5j_lo1 - KSL_MUL(A->at[4][5], x4_lo) + residual_5h_lo);
  const double refined_y5c = KSL_MUL(l1_3, refined_y1), refined_y5d = refined_y5b - refined_y5c,
      refined_y5d_right = refined_y5b - refined_y5d,
      refined_y5d_lo1 = refined_y5b - (refined_y5d + refined_y5d_right)
          - ksl_product_rest(l1_3, refined_y1, refined_y5c, refined_y5d_right),
      refined_y5b_lo = refined_y5b_lo1
          - (KSL_MUL(l0_4_lo, residual_0) + KSL_MUL(l0_4, residual_0_lo)) + residual_5_lo,
      refined_y5e = KSL_MUL(l2_2, refined_y2), refined_y5f = refined_y5d - refined_y5e,
      refined_y5f_right = refined_y5d - refined_y5f,
      refined_y5f_lo1 = refined_y5d - (refined_y5f + refined_y5f_right)
          - ksl_product_rest(l2_2, refined_y2, refined_y5e, refined_y5f_right),
      refined_y5d_lo = refined_y5d_lo1
          - (KSL_MUL(l1_3_lo, refined_y1) + KSL_MUL(l1_3, refined_y1_lo)) + refined_y5b_lo,
      refined_y5g = KSL_MUL(l3_1, refined_y3), refined_y5h = refined_y5f - refined_y5g,
      refined_y5h_right = refined_y5f - refined_y5h,
      refined_y5h_lo1 = refined_y5f - (refined_y5h + refined_y5h_right)
          - ksl_product_rest(l3_1, refined_y3, refined_y5g, refined_y5h_right),
      refined_y5f_lo = refined_y5f_lo1
          - (KSL_MUL(l2_2_lo, refined_y2) + KSL_MUL(l2_2, refined_y2_lo)) + refined_y5d_lo,
      refined_y5i = KSL_MUL(l4, refined_y4), refined_y5 = refined_y5h - refined_y5i,
      refined_y5_right = refined_y5h - refined_y5,
      refined_y5_lo1 = refined_y5h - (refined_y5 + refined_y5_right)
          - ksl_product_rest(l4, refined_y4, refined_y5i, refined_y5_right),
      refined_y5h_lo = refined_y5h_lo1
          - (KSL_MUL(l3_1_lo, refined_y3) + KSL_MUL(l3_1, refined_y3_lo)) + refined_y5f_lo,
      refined_y5_lo = refined_y5_lo1 - (KSL_MUL(l4_lo, refined_y4) + KSL_MUL(l4, refined_y4_lo))
          + refined_y5h_lo;
  const double residual_0_sum = residual_0 + residual_0_lo,
      residual_0_sum_right = residual_0_sum - residual_0, refined_z0 = residual_0_sum / divisor0,
      refined_z0_product = KSL_MUL(refined_z0, divisor0),
      refined_z0_exact = residual_0_sum - refined_z0_product
          - ksl_product_error(refined_z0, divisor0, refined_z0_product);
  const double refined_y1_sum = refined_y1 + refined_y1_lo,
      refined_y1_sum_right = refined_y1_sum - refined_y1,
      refined_z1 = refined_y1_sum / divisor1_sum,
      refined_z1_product = KSL_MUL(refined_z1, divisor1_sum),
      refined_z1_exact = refined_y1_sum - refined_z1_product
          - ksl_product_error(refined_z1, divisor1_sum, refined_z1_product),
      refined_z1_numerator = refined_z1_exact
          + (refined_y1 - (refined_y1_sum - refined_y1_sum_right)
          + (refined_y1_lo - refined_y1_sum_right));
  const double refined_y2_sum = refined_y2 + refined_y2_lo,
      refined_y2_sum_right = refined_y2_sum - refined_y2,
      refined_z2 = refined_y2_sum / divisor2_sum,
      refined_z2_product = KSL_MUL(refined_z2, divisor2_sum),
      refined_z2_exact = refined_y2_sum - refined_z2_product
          - ksl_product_error(refined_z2, divisor2_sum, refined_z2_product),
      refined_z2_numerator = refined_z2_exact
          + (refined_y2 - (refined_y2_sum - refined_y2_sum_right)
          + (refined_y2_lo - refined_y2_sum_right));
  const double refined_y3_sum = refined_y3 + refined_y3_lo,
      refined_y3_sum_right = refined_y3_sum - refined_y3,
      refined_z3 = refined_y3_sum / divisor3_sum,
      refined_z3_product = KSL_MUL(refined_z3, divisor3_sum),
      refined_z3_exact = refined_y3_sum - refined_z3_product
          - ksl_product_error(refined_z3, divisor3_sum, refined_z3_product),
      refined_z3_numerator = refined_z3_exact
          + (refined_y3 - (refined_y3_sum - refined_y3_sum_right)
          + (refined_y3_lo - refined_y3_sum_right));
  const double refined_y4_sum = refined_y4 + refined_y4_lo,
      refined_y4_sum_right = refined_y4_sum - refined_y4,
      refined_z4 = refined_y4_sum / divisor4_sum,
      refined_z4_product = KSL_MUL(refined_z4, divisor4_sum),
      refined_z4_exact = refined_y4_sum - refined_z4_product
          - ksl_product_error(refined_z4, divisor4_sum, refined_z4_product),
      refined_z4_numerator = refined_z4_exact
          + (refined_y4 - (refined_y4_sum - refined_y4_sum_right)
          + (refined_y4_lo - refined_y4_sum_right));
  const double refined_y5_sum = refined_y5 + refined_y5_lo,
      refined_y5_sum_right = refined_y5_sum - refined_y5,
      refined_z5 = refined_y5_sum / divisor5_sum,
      refined_z5_product = KSL_MUL(refined_z5, divisor5_sum),
      refined_z5_exact = refined_y5_sum - refined_z5_product
          - ksl_product_error(refined_z5, divisor5_sum, refined_z5_product),
      refined_z5_numerator = refined_z5_exact
          + (refined_y5 - (refined_y5_sum - refined_y5_sum_right)
          + (refined_y5_lo - refined_y5_sum_right)),
      refined_z5_lo = (refined_z5_numerator - KSL_MUL(refined_z5, divisor5_sum_lo)) / divisor5_sum;
  const double refined_x4a = KSL_MUL(l4, refined_z5), refined_x4 = refined_z4 - refined_x4a,
      refined_x4_right = refined_z4 - refined_x4,
      refined_x4_lo1 = refined_z4 - (refined_x4 + refined_x4_right)
          - ksl_product_rest(l4, refined_z5, refined_x4a, refined_x4_right);
  const double refined_z4_lo = (refined_z4_numerator - KSL_MUL(refined_z4, divisor4_sum_lo))
          / divisor4_sum;
  const double refined_x4_lo = refined_x4_lo1
          - (KSL_MUL(l4_lo, refined_z5) + KSL_MUL(l4, refined_z5_lo)) + refined_z4_lo;
  const double refined_x3a = KSL_MUL(l3_0, refined_x4), refined_x3b = refined_z3 - refined_x3a,
      refined_x3b_right = refined_z3 - refined_x3b,
      refined_x3b_lo1 = refined_z3 - (refined_x3b + refined_x3b_right)
          - ksl_product_rest(l3_0, refined_x4, refined_x3a, refined_x3b_right),
      refined_x3b_lo2 = refined_x3b_lo1
          - (KSL_MUL(l3_0_lo, refined_x4) + KSL_MUL(l3_0, refined_x4_lo)),
      refined_x3c = KSL_MUL(l3_1, refined_z5), refined_x3 = refined_x3b - refined_x3c,
      refined_x3_right = refined_x3b - refined_x3,
      refined_x3_lo1 = refined_x3b - (refined_x3 + refined_x3_right)
          - ksl_product_rest(l3_1, refined_z5, refined_x3c, refined_x3_right),
      refined_x3b_lo = refined_x3b_lo2
          + (refined_z3_numerator - KSL_MUL(refined_z3, divisor3_sum_lo)) / divisor3_sum,
      refined_x3_lo = refined_x3_lo1
          - (KSL_MUL(l3_1_lo, refined_z5) + KSL_MUL(l3_1, refined_z5_lo)) + refined_x3b_lo;
  const double refined_x2a = KSL_MUL(l2_0, refined_x3), refined_x2b = refined_z2 - refined_x2a,
      refined_x2b_right = refined_z2 - refined_x2b,
      refined_x2b_lo1 = refined_z2 - (refined_x2b + refined_x2b_right)
          - ksl_product_rest(l2_0, refined_x3, refined_x2a, refined_x2b_right),
      refined_x2b_lo2 = refined_x2b_lo1
          - (KSL_MUL(l2_0_lo, refined_x3) + KSL_MUL(l2_0, refined_x3_lo)),
      refined_x2c = KSL_MUL(l2_1, refined_x4), refined_x2d = refined_x2b - refined_x2c,
      refined_x2d_right = refined_x2b - refined_x2d,
      refined_x2d_lo1 = refined_x2b - (refined_x2d + refined_x2d_right)
          - ksl_product_rest(l2_1, refined_x4, refined_x2c, refined_x2d_right),
      refined_x2b_lo = refined_x2b_lo2
          + (refined_z2_numerator - KSL_MUL(refined_z2, divisor2_sum_lo)) / divisor2_sum,
      refined_x2e = KSL_MUL(l2_2, refined_z5), refined_x2 = refined_x2d - refined_x2e,
      refined_x2_right = refined_x2d - refined_x2,
      refined_x2_lo1 = refined_x2d - (refined_x2 + refined_x2_right)
          - ksl_product_rest(l2_2, refined_z5, refined_x2e, refined_x2_right),
      refined_x2d_lo = refined_x2d_lo1
          - (KSL_MUL(l2_1_lo, refined_x4) + KSL_MUL(l2_1, refined_x4_lo)) + refined_x2b_lo,
      refined_x2_lo = refined_x2_lo1
          - (KSL_MUL(l2_2_lo, refined_z5) + KSL_MUL(l2_2, refined_z5_lo)) + refined_x2d_lo;
  const double refined_x1a = KSL_MUL(l1_0, refined_x2), refined_x1b = refined_z1 - refined_x1a,
      refined_x1b_right = refined_z1 - refined_x1b,
      refined_x1b_lo1 = refined_z1 - (refined_x1b + refined_x1b_right)
          - ksl_product_rest(l1_0, refined_x2, refined_x1a, refined_x1b_right),
      refined_x1b_lo2 = refined_x1b_lo1
          - (KSL_MUL(l1_0_lo, refined_x2) + KSL_MUL(l1_0, refined_x2_lo)),
      refined_x1c = KSL_MUL(l1_1, refined_x3), refined_x1d = refined_x1b - refined_x1c,
      refined_x1d_right = refined_x1b - refined_x1d,
      refined_x1d_lo1 = refined_x1b - (refined_x1d + refined_x1d_right)
          - ksl_product_rest(l1_1, refined_x3, refined_x1c, refined_x1d_right),
      refined_x1b_lo = refined_x1b_lo2
          + (refined_z1_numerator - KSL_MUL(refined_z1, divisor1_sum_lo)) / divisor1_sum,
      refined_x1e = KSL_MUL(l1_2, refined_x4), refined_x1f = refined_x1d - refined_x1e,
      refined_x1f_right = refined_x1d - refined_x1f,
      refined_x1f_lo1 = refined_x1d - (refined_x1f + refined_x1f_right)
          - ksl_product_rest(l1_2, refined_x4, refined_x1e, refined_x1f_right),
      refined_x1d_lo = refined_x1d_lo1
          - (KSL_MUL(l1_1_lo, refined_x3) + KSL_MUL(l1_1, refined_x3_lo)) + refined_x1b_lo,
      refined_x1g = KSL_MUL(l1_3, refined_z5), refined_x1 = refined_x1f - refined_x1g,
      refined_x1_right = refined_x1f - refined_x1,
      refined_x1_lo1 = refined_x1f - (refined_x1 + refined_x1_right)
          - ksl_product_rest(l1_3, refined_z5, refined_x1g, refined_x1_right),
      refined_x1f_lo = refined_x1f_lo1
          - (KSL_MUL(l1_2_lo, refined_x4) + KSL_MUL(l1_2, refined_x4_lo)) + refined_x1d_lo,
      refined_x1_lo = refined_x1_lo1
          - (KSL_MUL(l1_3_lo, refined_z5) + KSL_MUL(l1_3, refined_z5_lo)) + refined_x1f_lo;
  const double refined_x0a = KSL_MUL(l0_0, refined_x1), refined_x0b = refined_z0 - refined_x0a,
      refined_x0b_right = refined_z0 - refined_x0b,
      refined_x0b_lo1 = refined_z0 - (refined_x0b + refined_x0b_right)
          - ksl_product_rest(l0_0, refined_x1, refined_x0a, refined_x0b_right);
  const double refined_z0_lo = (refined_z0_exact
          + (residual_0 - (residual_0_sum - residual_0_sum_right)
          + (residual_0_lo - residual_0_sum_right))) / divisor0;
  const double refined_x0c = KSL_MUL(l0_1, refined_x2), refined_x0d = refined_x0b - refined_x0c,
      refined_x0d_right = refined_x0b - refined_x0d,
      refined_x0d_lo1 = refined_x0b - (refined_x0d + refined_x0d_right)
          - ksl_product_rest(l0_1, refined_x2, refined_x0c, refined_x0d_right),
      refined_x0b_lo = refined_x0b_lo1
          - (KSL_MUL(l0_0_lo, refined_x1) + KSL_MUL(l0_0, refined_x1_lo)) + refined_z0_lo,
      refined_x0e = KSL_MUL(l0_2, refined_x3), refined_x0f = refined_x0d - refined_x0e,
      refined_x0f_right = refined_x0d - refined_x0f,
      refined_x0f_lo1 = refined_x0d - (refined_x0f + refined_x0f_right)
          - ksl_product_rest(l0_2, refined_x3, refined_x0e, refined_x0f_right),
      refined_x0d_lo = refined_x0d_lo1
          - (KSL_MUL(l0_1_lo, refined_x2) + KSL_MUL(l0_1, refined_x2_lo)) + refined_x0b_lo,
      refined_x0g = KSL_MUL(l0_3, refined_x4), refined_x0h = refined_x0f - refined_x0g,
      refined_x0h_right = refined_x0f - refined_x0h,
      refined_x0h_lo1 = refined_x0f - (refined_x0h + refined_x0h_right)
          - ksl_product_rest(l0_3, refined_x4, refined_x0g, refined_x0h_right),
      refined_x0f_lo = refined_x0f_lo1
          - (KSL_MUL(l0_2_lo, refined_x3) + KSL_MUL(l0_2, refined_x3_lo)) + refined_x0d_lo,
      refined_x0i = KSL_MUL(l0_4, refined_z5), refined_x0 = refined_x0h - refined_x0i,
      refined_x0_right = refined_x0h - refined_x0,
      refined_x0_lo1 = refined_x0h - (refined_x0 + refined_x0_right)
          - ksl_product_rest(l0_4, refined_z5, refined_x0i, refined_x0_right),
      refined_x0h_lo = refined_x0h_lo1
          - (KSL_MUL(l0_3_lo, refined_x4) + KSL_MUL(l0_3, refined_x4_lo)) + refined_x0f_lo;
  const double found_0 = x0 + refined_x0, found_0_right = found_0 - x0;
  const double refined_x0_lo = refined_x0_lo1
          - (KSL_MUL(l0_4_lo, refined_z5) + KSL_MUL(l0_4, refined_z5_lo)) + refined_x0h_lo;
  const double found_0_lo = x0 - (found_0 - found_0_right) + (refined_x0 - found_0_right)
          + refined_x0_lo + x0_lo;
  const double found_1 = x1 + refined_x1, found_1_right = found_1 - x1,
      found_1_lo = x1 - (found_1 - found_1_right) + (refined_x1 - found_1_right) + refined_x1_lo
          + x1_lo;
  const double found_2 = x2 + refined_x2, found_2_right = found_2 - x2,
      found_2_lo = x2 - (found_2 - found_2_right) + (refined_x2 - found_2_right) + refined_x2_lo
          + x2_lo;
  const double found_3 = x3 + refined_x3, found_3_right = found_3 - x3,
      found_3_lo = x3 - (found_3 - found_3_right) + (refined_x3 - found_3_right) + refined_x3_lo
          + x3_lo;
  const double found_4 = x4 + refined_x4, found_4_right = found_4 - x4,
      found_4_lo = x4 - (found_4 - found_4_right) + (refined_x4 - found_4_right) + refined_x4_lo
          + x4_lo;
  const double found_5 = z5 + refined_z5, found_5_right = found_5 - z5,
      found_5_lo = z5 - (found_5 - found_5_right) + (refined_z5 - found_5_right) + refined_z5_lo
          + z5_lo;
  const double pivot = regular == 1.0 ? smallest5_sum : least;
  const double x_0 = regular == 1.0 ? found_0 : (double)NAN,
      x_1 = regular == 1.0 ? found_1 : (double)NAN, x_2 = regular == 1.0 ? found_2 : (double)NAN,
      x_3 = regular == 1.0 ? found_3 : (double)NAN, x_4 = regular == 1.0 ? found_4 : (double)NAN,
      x_5 = regular == 1.0 ? found_5 : (double)NAN;
  const double pivot_rounded = pivot + (regular == 1.0 ? smallest5_sum_lo : least_lo);
  const double x_0_rounded = x_0 + (regular == 1.0 ? found_0_lo : 0.0);
  const double x_1_rounded = x_1 + (regular == 1.0 ? found_1_lo : 0.0);
  const double x_2_rounded = x_2 + (regular == 1.0 ? found_2_lo : 0.0);
  const double x_3_rounded = x_3 + (regular == 1.0 ? found_3_lo : 0.0);
  const double x_4_rounded = x_4 + (regular == 1.0 ? found_4_lo : 0.0);
  const double x_5_rounded = x_5 + (regular == 1.0 ? found_5_lo : 0.0);
  const double pivot_final = pivot_rounded == pivot_rounded ? pivot_rounded : pivot;
  const double x_0_final = x_0_rounded == x_0_rounded ? x_0_rounded : x_0;
  const double x_1_final = x_1_rounded == x_1_rounded ? x_1_rounded : x_1;
  const double x_2_final = x_2_rounded == x_2_rounded ? x_2_rounded : x_2;
  const double x_3_final = x_3_rounded == x_3_rounded ? x_3_rounded : x_3;
  const double x_4_final = x_4_rounded == x_4_rounded ? x_4_rounded : x_4;
  const double x_5_final = x_5_rounded == x_5_rounded ? x_5_rounded : x_5;
  x->m0 = x_0_final;
  x->m1 = x_1_final;
  x->m2 = x_2_final;
  x->m3 = x_3_final;
  x->m4 = x_4_final;
  x->m5 = x_5_final;
  return pivot_final;
}

/* L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
     triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
     not positive definite, and L is meaningless.
   A, L: rotation or other 3×3 matrix.
   4 mul, 4 add, 6 div, 6 less, 9 select.
   |L D L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline float ksl_mat3x3f_ldl_accurate(const ksl_mat3x3f_t *A, ksl_mat3x3f_t *L) {
  const double divisor0 = 0.0 < (double)A->m00 ? (double)A->m00 : 1.0;
  const double l0_0 = (double)A->m10 / divisor0, l0_1 = (double)A->m20 / divisor0;
  const double u1_0 = (double)A->m11 - KSL_MUL((double)A->m10, l0_0),
      u1_1 = (double)A->m21 - KSL_MUL((double)A->m20, l0_0);
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1 = u1_1 / divisor1;
  const double u2 = (double)A->m22 - KSL_MUL((double)A->m20, l0_1) - KSL_MUL(u1_1, l1);
  const double part0a = (double)A->m00 / divisor0,
      part0 = 0.0 < (double)A->m00 ? part0a : (double)A->m00;
  const double own1 = 0.0 < (double)A->m11 ? (double)A->m11 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < (double)A->m11 ? part1a : (double)A->m11;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < (double)A->m22 ? (double)A->m22 : 1.0;
  const double part2a = u2 / own2, part2 = 0.0 < (double)A->m22 ? part2a : (double)A->m22;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  L->m00 = A->m00;
  L->m01 = (float)0.0;
  L->m02 = (float)0.0;
  L->m10 = (float)l0_0;
  L->m11 = (float)u1_0;
  L->m12 = (float)0.0;
  L->m20 = (float)l0_1;
  L->m21 = (float)l1;
  L->m22 = (float)u2;
  return (float)smallest2;
}

/* x = A^-1 b, L of mat3x3_ldl with a positive pivot.
   L: rotation or other 3×3 matrix; b, x: vector.
   6 mul, 6 add, 3 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat3x3f_ldl_solve_accurate(const ksl_mat3x3f_t *L, const ksl_vec3f_t *b,
    ksl_vec3f_t *x) {
  const double y1 = ksl_product_sum(-(double)L->m10, (double)b->x, (double)b->y);
  const double y2 = ksl_product_sum(-(double)L->m20, (double)b->x, (double)b->z)
          - KSL_MUL((double)L->m21, y1);
  const double z0 = (double)b->x / (double)L->m00;
  const double z1 = y1 / (double)L->m11;
  const double z2 = y2 / (double)L->m22;
  const double x1 = z1 - KSL_MUL((double)L->m21, z2);
  const double x0 = z0 - KSL_MUL((double)L->m10, x1) - KSL_MUL((double)L->m20, z2);
  x->x = (float)x0;
  x->y = (float)x1;
  x->z = (float)z2;
}

/* x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
     Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
     rounding or indefinite (A - 50 u diag A is not positive definite).
   A: rotation or other 3×3 matrix; b, x: vector.
   32 mul, 32 add, 15 div, 11 less, 1 equal, 20 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline float ksl_mat3x3f_solve_accurate(const ksl_mat3x3f_t *A, const ksl_vec3f_t *b,
    ksl_vec3f_t *x) {
  const double divisor0 = 0.0 < (double)A->m00 ? (double)A->m00 : 1.0;
  const double l0_0 = (double)A->m10 / divisor0, l0_1 = (double)A->m20 / divisor0;
  const double u1_0 = (double)A->m11 - KSL_MUL((double)A->m10, l0_0),
      u1_1 = (double)A->m21 - KSL_MUL((double)A->m20, l0_0);
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1 = u1_1 / divisor1;
  const double u2 = (double)A->m22 - KSL_MUL((double)A->m20, l0_1) - KSL_MUL(u1_1, l1);
  const double divisor2 = 0.0 < u2 ? u2 : 1.0;
  const double part0a = (double)A->m00 / divisor0,
      part0 = 0.0 < (double)A->m00 ? part0a : (double)A->m00;
  const double own1 = 0.0 < (double)A->m11 ? (double)A->m11 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < (double)A->m11 ? part1a : (double)A->m11;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < (double)A->m22 ? (double)A->m22 : 1.0;
  const double part2a = u2 / own2, part2 = 0.0 < (double)A->m22 ? part2a : (double)A->m22;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double less_0 = (double)A->m00 * 0.9999970197677612;
  const double less_divisor0 = 0.0 < less_0 ? less_0 : 1.0;
  const double less_l0_0 = (double)A->m10 / less_divisor0,
      less_l0_1 = (double)A->m20 / less_divisor0;
  const double less_u1_0 = ksl_product_sum((double)A->m11, 0.9999970197677612,
          -KSL_MUL((double)A->m10, less_l0_0)),
      less_u1_1 = (double)A->m21 - KSL_MUL((double)A->m20, less_l0_0);
  const double less_divisor1 = 0.0 < less_u1_0 ? less_u1_0 : 1.0;
  const double less_l1 = less_u1_1 / less_divisor1;
  const double less_u2 = ksl_product_sum((double)A->m22, 0.9999970197677612,
          -KSL_MUL((double)A->m20, less_l0_1)) - KSL_MUL(less_u1_1, less_l1);
  const double regular_b = 0.0 < less_u2 ? 1.0 : 0.0, regular_c = 0.0 < less_u1_0 ? regular_b : 0.0,
      regular = 0.0 < less_0 ? regular_c : 0.0;
  const double least = smallest2 < 0.0 ? smallest2 : 0.0;
  const double y1 = (double)b->y - KSL_MUL((double)b->x, l0_0);
  const double y2 = (double)b->z - KSL_MUL((double)b->x, l0_1) - KSL_MUL(l1, y1);
  const double z0 = (double)b->x / divisor0;
  const double z1 = y1 / divisor1;
  const double z2 = y2 / divisor2;
  const double x1 = z1 - KSL_MUL(l1, z2);
  const double x0 = z0 - KSL_MUL(l0_0, x1) - KSL_MUL(l0_1, z2);
  const double residual_0 = (double)b->x - KSL_MUL((double)A->m00, x0)
          - KSL_MUL((double)A->m10, x1) - KSL_MUL((double)A->m20, z2),
      residual_1 = (double)b->y - KSL_MUL((double)A->m10, x0) - KSL_MUL((double)A->m11, x1)
          - KSL_MUL((double)A->m21, z2),
      residual_2 = (double)b->z - KSL_MUL((double)A->m20, x0) - KSL_MUL((double)A->m21, x1)
          - KSL_MUL((double)A->m22, z2);
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
  x->x = (float)x_0;
  x->y = (float)x_1;
  x->z = (float)x_2;
  return (float)pivot;
}

/* L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
     triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
     not positive definite, and L is meaningless.
   A, L: 6×6 operator.
   35 mul, 35 add, 21 div, 15 less, 21 select.
   |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
     underflow. */
static inline float ksl_mat6x6f_ldl_accurate(const ksl_mat6x6f_t *A, ksl_mat6x6f_t *L) {
  const double divisor0 = 0.0 < (double)A->at[0][0] ? (double)A->at[0][0] : 1.0;
  const double l0_0 = (double)A->at[0][1] / divisor0, l0_1 = (double)A->at[0][2] / divisor0,
      l0_2 = (double)A->at[0][3] / divisor0, l0_3 = (double)A->at[0][4] / divisor0,
      l0_4 = (double)A->at[0][5] / divisor0;
  const double u1_0 = (double)A->at[1][1] - KSL_MUL((double)A->at[0][1], l0_0),
      u1_1 = (double)A->at[1][2] - KSL_MUL((double)A->at[0][2], l0_0),
      u1_2 = (double)A->at[1][3] - KSL_MUL((double)A->at[0][3], l0_0),
      u1_3 = (double)A->at[1][4] - KSL_MUL((double)A->at[0][4], l0_0),
      u1_4 = (double)A->at[1][5] - KSL_MUL((double)A->at[0][5], l0_0);
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1, l1_1 = u1_2 / divisor1, l1_2 = u1_3 / divisor1,
      l1_3 = u1_4 / divisor1;
  const double u2_0 = (double)A->at[2][2] - KSL_MUL((double)A->at[0][2], l0_1)
          - KSL_MUL(u1_1, l1_0),
      u2_1 = (double)A->at[2][3] - KSL_MUL((double)A->at[0][3], l0_1) - KSL_MUL(u1_2, l1_0),
      u2_2 = (double)A->at[2][4] - KSL_MUL((double)A->at[0][4], l0_1) - KSL_MUL(u1_3, l1_0),
      u2_3 = (double)A->at[2][5] - KSL_MUL((double)A->at[0][5], l0_1) - KSL_MUL(u1_4, l1_0);
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2_0 = u2_1 / divisor2, l2_1 = u2_2 / divisor2, l2_2 = u2_3 / divisor2;
  const double u3_0 = (double)A->at[3][3] - KSL_MUL((double)A->at[0][3], l0_2)
          - KSL_MUL(u1_2, l1_1) - KSL_MUL(u2_1, l2_0),
      u3_1 = (double)A->at[3][4] - KSL_MUL((double)A->at[0][4], l0_2) - KSL_MUL(u1_3, l1_1)
          - KSL_MUL(u2_2, l2_0),
      u3_2 = (double)A->at[3][5] - KSL_MUL((double)A->at[0][5], l0_2) - KSL_MUL(u1_4, l1_1)
          - KSL_MUL(u2_3, l2_0);
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0;
  const double l3_0 = u3_1 / divisor3, l3_1 = u3_2 / divisor3;
  const double u4_0 = (double)A->at[4][4] - KSL_MUL((double)A->at[0][4], l0_3)
          - KSL_MUL(u1_3, l1_2) - KSL_MUL(u2_2, l2_1) - KSL_MUL(u3_1, l3_0),
      u4_1 = (double)A->at[4][5] - KSL_MUL((double)A->at[0][5], l0_3) - KSL_MUL(u1_4, l1_2)
          - KSL_MUL(u2_3, l2_1) - KSL_MUL(u3_2, l3_0);
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0;
  const double l4 = u4_1 / divisor4;
  const double u5 = (double)A->at[5][5] - KSL_MUL((double)A->at[0][5], l0_4) - KSL_MUL(u1_4, l1_3)
          - KSL_MUL(u2_3, l2_2) - KSL_MUL(u3_2, l3_1) - KSL_MUL(u4_1, l4);
  const double part0a = (double)A->at[0][0] / divisor0,
      part0 = 0.0 < (double)A->at[0][0] ? part0a : (double)A->at[0][0];
  const double own1 = 0.0 < (double)A->at[1][1] ? (double)A->at[1][1] : 1.0;
  const double part1a = u1_0 / own1,
      part1 = 0.0 < (double)A->at[1][1] ? part1a : (double)A->at[1][1];
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < (double)A->at[2][2] ? (double)A->at[2][2] : 1.0;
  const double part2a = u2_0 / own2,
      part2 = 0.0 < (double)A->at[2][2] ? part2a : (double)A->at[2][2];
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double own3 = 0.0 < (double)A->at[3][3] ? (double)A->at[3][3] : 1.0;
  const double part3a = u3_0 / own3,
      part3 = 0.0 < (double)A->at[3][3] ? part3a : (double)A->at[3][3];
  const double smallest3 = smallest2 < part3 ? smallest2 : part3;
  const double own4 = 0.0 < (double)A->at[4][4] ? (double)A->at[4][4] : 1.0;
  const double part4a = u4_0 / own4,
      part4 = 0.0 < (double)A->at[4][4] ? part4a : (double)A->at[4][4];
  const double smallest4 = smallest3 < part4 ? smallest3 : part4;
  const double own5 = 0.0 < (double)A->at[5][5] ? (double)A->at[5][5] : 1.0;
  const double part5a = u5 / own5, part5 = 0.0 < (double)A->at[5][5] ? part5a : (double)A->at[5][5];
  const double smallest5 = smallest4 < part5 ? smallest4 : part5;
  L->at[0][0] = A->at[0][0];
  L->at[1][0] = (float)0.0;
  L->at[2][0] = (float)0.0;
  L->at[3][0] = (float)0.0;
  L->at[4][0] = (float)0.0;
  L->at[5][0] = (float)0.0;
  L->at[0][1] = (float)l0_0;
  L->at[1][1] = (float)u1_0;
  L->at[2][1] = (float)0.0;
  L->at[3][1] = (float)0.0;
  L->at[4][1] = (float)0.0;
  L->at[5][1] = (float)0.0;
  L->at[0][2] = (float)l0_1;
  L->at[1][2] = (float)l1_0;
  L->at[2][2] = (float)u2_0;
  L->at[3][2] = (float)0.0;
  L->at[4][2] = (float)0.0;
  L->at[5][2] = (float)0.0;
  L->at[0][3] = (float)l0_2;
  L->at[1][3] = (float)l1_1;
  L->at[2][3] = (float)l2_0;
  L->at[3][3] = (float)u3_0;
  L->at[4][3] = (float)0.0;
  L->at[5][3] = (float)0.0;
  L->at[0][4] = (float)l0_3;
  L->at[1][4] = (float)l1_2;
  L->at[2][4] = (float)l2_1;
  L->at[3][4] = (float)l3_0;
  L->at[4][4] = (float)u4_0;
  L->at[5][4] = (float)0.0;
  L->at[0][5] = (float)l0_4;
  L->at[1][5] = (float)l1_3;
  L->at[2][5] = (float)l2_2;
  L->at[3][5] = (float)l3_1;
  L->at[4][5] = (float)l4;
  L->at[5][5] = (float)u5;
  return (float)smallest5;
}

/* x = A^-1 b, L of mat6x6_ldl with a positive pivot.
   L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   30 mul, 30 add, 6 div.
   Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not
     proved; barring over- and underflow. */
static inline void ksl_mat6x6f_ldl_solve_accurate(const ksl_mat6x6f_t *L, const ksl_coscrewf_t *b,
    ksl_screwf_t *x) {
  const double y1 = ksl_product_sum(-(double)L->at[0][1], (double)b->m0, (double)b->m1);
  const double y2 = ksl_product_sum(-(double)L->at[0][2], (double)b->m0, (double)b->m2)
          - KSL_MUL((double)L->at[1][2], y1);
  const double y3 = ksl_product_sum(-(double)L->at[0][3], (double)b->m0, (double)b->m3)
          - KSL_MUL((double)L->at[1][3], y1) - KSL_MUL((double)L->at[2][3], y2);
  const double y4f = ksl_product_sum(-(double)L->at[0][4], (double)b->m0, (double)b->m4)
          - KSL_MUL((double)L->at[1][4], y1) - KSL_MUL((double)L->at[2][4], y2),
      y4 = y4f - KSL_MUL((double)L->at[3][4], y3);
  const double y5f = ksl_product_sum(-(double)L->at[0][5], (double)b->m0, (double)b->m5)
          - KSL_MUL((double)L->at[1][5], y1) - KSL_MUL((double)L->at[2][5], y2),
      y5 = y5f - KSL_MUL((double)L->at[3][5], y3) - KSL_MUL((double)L->at[4][5], y4);
  const double z0 = (double)b->m0 / (double)L->at[0][0];
  const double z1 = y1 / (double)L->at[1][1];
  const double z2 = y2 / (double)L->at[2][2];
  const double z3 = y3 / (double)L->at[3][3];
  const double z4 = y4 / (double)L->at[4][4];
  const double z5 = y5 / (double)L->at[5][5];
  const double x4 = z4 - KSL_MUL((double)L->at[4][5], z5);
  const double x3 = z3 - KSL_MUL((double)L->at[3][4], x4) - KSL_MUL((double)L->at[3][5], z5);
  const double x2 = z2 - KSL_MUL((double)L->at[2][3], x3) - KSL_MUL((double)L->at[2][4], x4)
          - KSL_MUL((double)L->at[2][5], z5);
  const double x1 = z1 - KSL_MUL((double)L->at[1][2], x2) - KSL_MUL((double)L->at[1][3], x3)
          - KSL_MUL((double)L->at[1][4], x4) - KSL_MUL((double)L->at[1][5], z5);
  const double x0h = z0 - KSL_MUL((double)L->at[0][1], x1) - KSL_MUL((double)L->at[0][2], x2)
          - KSL_MUL((double)L->at[0][3], x3) - KSL_MUL((double)L->at[0][4], x4),
      x0 = x0h - KSL_MUL((double)L->at[0][5], z5);
  x->m0 = (float)x0;
  x->m1 = (float)x1;
  x->m2 = (float)x2;
  x->m3 = (float)x3;
  x->m4 = (float)x4;
  x->m5 = (float)z5;
}

/* x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
     Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
     rounding or indefinite (A - 50 u diag A is not positive definite).
   A: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   172 mul, 172 add, 48 div, 23 less, 1 equal, 41 select.
   Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
     barring over- and underflow. */
static inline float ksl_mat6x6f_solve_accurate(const ksl_mat6x6f_t *A, const ksl_coscrewf_t *b,
    ksl_screwf_t *x) {
  const double divisor0 = 0.0 < (double)A->at[0][0] ? (double)A->at[0][0] : 1.0;
  const double l0_0 = (double)A->at[0][1] / divisor0, l0_1 = (double)A->at[0][2] / divisor0,
      l0_2 = (double)A->at[0][3] / divisor0, l0_3 = (double)A->at[0][4] / divisor0,
      l0_4 = (double)A->at[0][5] / divisor0;
  const double u1_0 = (double)A->at[1][1] - KSL_MUL((double)A->at[0][1], l0_0),
      u1_1 = (double)A->at[1][2] - KSL_MUL((double)A->at[0][2], l0_0),
      u1_2 = (double)A->at[1][3] - KSL_MUL((double)A->at[0][3], l0_0),
      u1_3 = (double)A->at[1][4] - KSL_MUL((double)A->at[0][4], l0_0),
      u1_4 = (double)A->at[1][5] - KSL_MUL((double)A->at[0][5], l0_0);
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1, l1_1 = u1_2 / divisor1, l1_2 = u1_3 / divisor1,
      l1_3 = u1_4 / divisor1;
  const double u2_0 = (double)A->at[2][2] - KSL_MUL((double)A->at[0][2], l0_1)
          - KSL_MUL(u1_1, l1_0),
      u2_1 = (double)A->at[2][3] - KSL_MUL((double)A->at[0][3], l0_1) - KSL_MUL(u1_2, l1_0),
      u2_2 = (double)A->at[2][4] - KSL_MUL((double)A->at[0][4], l0_1) - KSL_MUL(u1_3, l1_0),
      u2_3 = (double)A->at[2][5] - KSL_MUL((double)A->at[0][5], l0_1) - KSL_MUL(u1_4, l1_0);
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2_0 = u2_1 / divisor2, l2_1 = u2_2 / divisor2, l2_2 = u2_3 / divisor2;
  const double u3_0 = (double)A->at[3][3] - KSL_MUL((double)A->at[0][3], l0_2)
          - KSL_MUL(u1_2, l1_1) - KSL_MUL(u2_1, l2_0),
      u3_1 = (double)A->at[3][4] - KSL_MUL((double)A->at[0][4], l0_2) - KSL_MUL(u1_3, l1_1)
          - KSL_MUL(u2_2, l2_0),
      u3_2 = (double)A->at[3][5] - KSL_MUL((double)A->at[0][5], l0_2) - KSL_MUL(u1_4, l1_1)
          - KSL_MUL(u2_3, l2_0);
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0;
  const double l3_0 = u3_1 / divisor3, l3_1 = u3_2 / divisor3;
  const double u4_0 = (double)A->at[4][4] - KSL_MUL((double)A->at[0][4], l0_3)
          - KSL_MUL(u1_3, l1_2) - KSL_MUL(u2_2, l2_1) - KSL_MUL(u3_1, l3_0),
      u4_1 = (double)A->at[4][5] - KSL_MUL((double)A->at[0][5], l0_3) - KSL_MUL(u1_4, l1_2)
          - KSL_MUL(u2_3, l2_1) - KSL_MUL(u3_2, l3_0);
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0;
  const double l4 = u4_1 / divisor4;
  const double u5 = (double)A->at[5][5] - KSL_MUL((double)A->at[0][5], l0_4) - KSL_MUL(u1_4, l1_3)
          - KSL_MUL(u2_3, l2_2) - KSL_MUL(u3_2, l3_1) - KSL_MUL(u4_1, l4);
  const double divisor5 = 0.0 < u5 ? u5 : 1.0;
  const double part0a = (double)A->at[0][0] / divisor0,
      part0 = 0.0 < (double)A->at[0][0] ? part0a : (double)A->at[0][0];
  const double own1 = 0.0 < (double)A->at[1][1] ? (double)A->at[1][1] : 1.0;
  const double part1a = u1_0 / own1,
      part1 = 0.0 < (double)A->at[1][1] ? part1a : (double)A->at[1][1];
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < (double)A->at[2][2] ? (double)A->at[2][2] : 1.0;
  const double part2a = u2_0 / own2,
      part2 = 0.0 < (double)A->at[2][2] ? part2a : (double)A->at[2][2];
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double own3 = 0.0 < (double)A->at[3][3] ? (double)A->at[3][3] : 1.0;
  const double part3a = u3_0 / own3,
      part3 = 0.0 < (double)A->at[3][3] ? part3a : (double)A->at[3][3];
  const double smallest3 = smallest2 < part3 ? smallest2 : part3;
  const double own4 = 0.0 < (double)A->at[4][4] ? (double)A->at[4][4] : 1.0;
  const double part4a = u4_0 / own4,
      part4 = 0.0 < (double)A->at[4][4] ? part4a : (double)A->at[4][4];
  const double smallest4 = smallest3 < part4 ? smallest3 : part4;
  const double own5 = 0.0 < (double)A->at[5][5] ? (double)A->at[5][5] : 1.0;
  const double part5a = u5 / own5, part5 = 0.0 < (double)A->at[5][5] ? part5a : (double)A->at[5][5];
  const double smallest5 = smallest4 < part5 ? smallest4 : part5;
  const double less_0 = (double)A->at[0][0] * 0.9999970197677612;
  const double less_divisor0 = 0.0 < less_0 ? less_0 : 1.0;
  const double less_l0_0 = (double)A->at[0][1] / less_divisor0,
      less_l0_1 = (double)A->at[0][2] / less_divisor0,
      less_l0_2 = (double)A->at[0][3] / less_divisor0,
      less_l0_3 = (double)A->at[0][4] / less_divisor0,
      less_l0_4 = (double)A->at[0][5] / less_divisor0;
  const double less_u1_0 = ksl_product_sum((double)A->at[1][1], 0.9999970197677612,
          -KSL_MUL((double)A->at[0][1], less_l0_0)),
      less_u1_1 = (double)A->at[1][2] - KSL_MUL((double)A->at[0][2], less_l0_0),
      less_u1_2 = (double)A->at[1][3] - KSL_MUL((double)A->at[0][3], less_l0_0),
      less_u1_3 = (double)A->at[1][4] - KSL_MUL((double)A->at[0][4], less_l0_0),
      less_u1_4 = (double)A->at[1][5] - KSL_MUL((double)A->at[0][5], less_l0_0);
  const double less_divisor1 = 0.0 < less_u1_0 ? less_u1_0 : 1.0;
  const double less_l1_0 = less_u1_1 / less_divisor1, less_l1_1 = less_u1_2 / less_divisor1,
      less_l1_2 = less_u1_3 / less_divisor1, less_l1_3 = less_u1_4 / less_divisor1;
  const double less_u2_0 = ksl_product_sum((double)A->at[2][2], 0.9999970197677612,
          -KSL_MUL((double)A->at[0][2], less_l0_1)) - KSL_MUL(less_u1_1, less_l1_0),
      less_u2_1 = (double)A->at[2][3] - KSL_MUL((double)A->at[0][3], less_l0_1)
          - KSL_MUL(less_u1_2, less_l1_0),
      less_u2_2 = (double)A->at[2][4] - KSL_MUL((double)A->at[0][4], less_l0_1)
          - KSL_MUL(less_u1_3, less_l1_0),
      less_u2_3 = (double)A->at[2][5] - KSL_MUL((double)A->at[0][5], less_l0_1)
          - KSL_MUL(less_u1_4, less_l1_0);
  const double less_divisor2 = 0.0 < less_u2_0 ? less_u2_0 : 1.0;
  const double less_l2_0 = less_u2_1 / less_divisor2, less_l2_1 = less_u2_2 / less_divisor2,
      less_l2_2 = less_u2_3 / less_divisor2;
  const double less_u3_0d = ksl_product_sum((double)A->at[3][3], 0.9999970197677612,
          -KSL_MUL((double)A->at[0][3], less_l0_2)) - KSL_MUL(less_u1_2, less_l1_1),
      less_u3_0 = less_u3_0d - KSL_MUL(less_u2_1, less_l2_0);
  const double less_u3_1 = (double)A->at[3][4] - KSL_MUL((double)A->at[0][4], less_l0_2)
          - KSL_MUL(less_u1_3, less_l1_1) - KSL_MUL(less_u2_2, less_l2_0),
      less_u3_2 = (double)A->at[3][5] - KSL_MUL((double)A->at[0][5], less_l0_2)
          - KSL_MUL(less_u1_4, less_l1_1) - KSL_MUL(less_u2_3, less_l2_0);
  const double less_divisor3 = 0.0 < less_u3_0 ? less_u3_0 : 1.0;
  const double less_l3_0 = less_u3_1 / less_divisor3, less_l3_1 = less_u3_2 / less_divisor3;
  const double less_u4_0d = ksl_product_sum((double)A->at[4][4], 0.9999970197677612,
          -KSL_MUL((double)A->at[0][4], less_l0_3)) - KSL_MUL(less_u1_3, less_l1_2),
      less_u4_0 = less_u4_0d - KSL_MUL(less_u2_2, less_l2_1) - KSL_MUL(less_u3_1, less_l3_0);
  const double less_u4_1f = (double)A->at[4][5] - KSL_MUL((double)A->at[0][5], less_l0_3)
          - KSL_MUL(less_u1_4, less_l1_2) - KSL_MUL(less_u2_3, less_l2_1),
      less_u4_1 = less_u4_1f - KSL_MUL(less_u3_2, less_l3_0);
  const double less_divisor4 = 0.0 < less_u4_0 ? less_u4_0 : 1.0;
  const double less_l4 = less_u4_1 / less_divisor4;
  const double less_u5d = ksl_product_sum((double)A->at[5][5], 0.9999970197677612,
          -KSL_MUL((double)A->at[0][5], less_l0_4)) - KSL_MUL(less_u1_4, less_l1_3),
      less_u5 = less_u5d - KSL_MUL(less_u2_3, less_l2_2) - KSL_MUL(less_u3_2, less_l3_1)
          - KSL_MUL(less_u4_1, less_l4);
  const double regular_b = 0.0 < less_u5 ? 1.0 : 0.0, regular_c = 0.0 < less_u4_0 ? regular_b : 0.0,
      regular_d = 0.0 < less_u3_0 ? regular_c : 0.0, regular_e = 0.0 < less_u2_0 ? regular_d : 0.0,
      regular_f = 0.0 < less_u1_0 ? regular_e : 0.0, regular = 0.0 < less_0 ? regular_f : 0.0;
  const double least = smallest5 < 0.0 ? smallest5 : 0.0;
  const double y1 = (double)b->m1 - KSL_MUL((double)b->m0, l0_0);
  const double y2 = (double)b->m2 - KSL_MUL((double)b->m0, l0_1) - KSL_MUL(l1_0, y1);
  const double y3 = (double)b->m3 - KSL_MUL((double)b->m0, l0_2) - KSL_MUL(l1_1, y1)
          - KSL_MUL(l2_0, y2);
  const double y4 = (double)b->m4 - KSL_MUL((double)b->m0, l0_3) - KSL_MUL(l1_2, y1)
          - KSL_MUL(l2_1, y2) - KSL_MUL(l3_0, y3);
  const double y5 = (double)b->m5 - KSL_MUL((double)b->m0, l0_4) - KSL_MUL(l1_3, y1)
          - KSL_MUL(l2_2, y2) - KSL_MUL(l3_1, y3) - KSL_MUL(l4, y4);
  const double z0 = (double)b->m0 / divisor0;
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
  const double residual_0f = (double)b->m0 - KSL_MUL((double)A->at[0][0], x0)
          - KSL_MUL((double)A->at[0][1], x1) - KSL_MUL((double)A->at[0][2], x2),
      residual_0 = residual_0f - KSL_MUL((double)A->at[0][3], x3)
          - KSL_MUL((double)A->at[0][4], x4) - KSL_MUL((double)A->at[0][5], z5);
  const double residual_1f = (double)b->m1 - KSL_MUL((double)A->at[0][1], x0)
          - KSL_MUL((double)A->at[1][1], x1) - KSL_MUL((double)A->at[1][2], x2),
      residual_1 = residual_1f - KSL_MUL((double)A->at[1][3], x3)
          - KSL_MUL((double)A->at[1][4], x4) - KSL_MUL((double)A->at[1][5], z5);
  const double residual_2f = (double)b->m2 - KSL_MUL((double)A->at[0][2], x0)
          - KSL_MUL((double)A->at[1][2], x1) - KSL_MUL((double)A->at[2][2], x2),
      residual_2 = residual_2f - KSL_MUL((double)A->at[2][3], x3)
          - KSL_MUL((double)A->at[2][4], x4) - KSL_MUL((double)A->at[2][5], z5);
  const double residual_3f = (double)b->m3 - KSL_MUL((double)A->at[0][3], x0)
          - KSL_MUL((double)A->at[1][3], x1) - KSL_MUL((double)A->at[2][3], x2),
      residual_3 = residual_3f - KSL_MUL((double)A->at[3][3], x3)
          - KSL_MUL((double)A->at[3][4], x4) - KSL_MUL((double)A->at[3][5], z5);
  const double residual_4f = (double)b->m4 - KSL_MUL((double)A->at[0][4], x0)
          - KSL_MUL((double)A->at[1][4], x1) - KSL_MUL((double)A->at[2][4], x2),
      residual_4 = residual_4f - KSL_MUL((double)A->at[3][4], x3)
          - KSL_MUL((double)A->at[4][4], x4) - KSL_MUL((double)A->at[4][5], z5);
  const double residual_5f = (double)b->m5 - KSL_MUL((double)A->at[0][5], x0)
          - KSL_MUL((double)A->at[1][5], x1) - KSL_MUL((double)A->at[2][5], x2),
      residual_5 = residual_5f - KSL_MUL((double)A->at[3][5], x3)
          - KSL_MUL((double)A->at[4][5], x4) - KSL_MUL((double)A->at[5][5], z5);
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
  x->m0 = (float)x_0;
  x->m1 = (float)x_1;
  x->m2 = (float)x_2;
  x->m3 = (float)x_3;
  x->m4 = (float)x_4;
  x->m5 = (float)x_5;
  return (float)pivot;
}

#endif
