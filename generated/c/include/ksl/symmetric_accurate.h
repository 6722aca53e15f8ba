/* Made by `coscrew generate`; changes are overwritten. */
/* Symmetric positive definite 3×3 and 6×6 matrices: A = L D L^T, solutions of A x = b.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_SYMMETRIC_ACCURATE_H
#define KSL_SYMMETRIC_ACCURATE_H

#include "ksl_exact.h"

/* L, D with L D L^T = A: unit lower triangular L, D on its diagonal; returns the smallest pivot
     d_i / a_ii: where it is not positive, A is not positive definite, and L means nothing.
   A, L: rotation or other 3×3 matrix.
   16 mul, 40 add, 10 product error, 8 sum error, 12 div, 6 less, 6 equal, 21 select. */
static inline double ksl_mat3x3_ldl_accurate(const ksl_mat3x3_t *A, ksl_mat3x3_t *L) {
  const double divisor0 = 0.0 < A->m00 ? A->m00 : 1.0;
  const double l0_0 = A->m10 / divisor0, l0_0_product = l0_0 * divisor0,
      l0_0_product_error = ksl_product_error(l0_0, divisor0, l0_0_product),
      l0_0_rest = A->m10 - l0_0_product, l0_0_exact = l0_0_rest - l0_0_product_error,
      l0_0_lo = l0_0_exact / divisor0;
  const double l0_1 = A->m20 / divisor0, l0_1_product = l0_1 * divisor0,
      l0_1_product_error = ksl_product_error(l0_1, divisor0, l0_1_product),
      l0_1_rest = A->m20 - l0_1_product, l0_1_exact = l0_1_rest - l0_1_product_error,
      l0_1_lo = l0_1_exact / divisor0;
  const double u1_0a = A->m10 * l0_0, u1_0a_cross1 = A->m10 * l0_0_lo,
      u1_0a_error = ksl_product_error(A->m10, l0_0, u1_0a), u1_0a_lo = u1_0a_error + u1_0a_cross1,
      u1_0 = A->m11 - u1_0a, u1_0_error = ksl_difference_error(A->m11, u1_0a, u1_0),
      u1_0_lo = u1_0_error - u1_0a_lo;
  const double u1_1a = A->m20 * l0_0, u1_1a_cross1 = A->m20 * l0_0_lo,
      u1_1a_error = ksl_product_error(A->m20, l0_0, u1_1a), u1_1a_lo = u1_1a_error + u1_1a_cross1,
      u1_1 = A->m21 - u1_1a, u1_1_error = ksl_difference_error(A->m21, u1_1a, u1_1),
      u1_1_lo = u1_1_error - u1_1a_lo;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0, divisor1_lo = 0.0 < u1_0 ? u1_0_lo : 0.0;
  const double l1_of_u1_1 = u1_1 + u1_1_lo,
      l1_of_u1_1_lo = ksl_sum_error(u1_1, u1_1_lo, l1_of_u1_1),
      l1_of_divisor1 = divisor1 + divisor1_lo,
      l1_of_divisor1_lo = ksl_sum_error(divisor1, divisor1_lo, l1_of_divisor1),
      l1 = l1_of_u1_1 / l1_of_divisor1, l1_cross = l1 * l1_of_divisor1_lo,
      l1_product = l1 * l1_of_divisor1,
      l1_product_error = ksl_product_error(l1, l1_of_divisor1, l1_product),
      l1_rest = l1_of_u1_1 - l1_product, l1_exact = l1_rest - l1_product_error,
      l1_lo1 = l1_exact + l1_of_u1_1_lo, l1_residual = l1_lo1 - l1_cross,
      l1_lo = l1_residual / l1_of_divisor1;
  const double u2a = A->m20 * l0_1, u2a_cross1 = A->m20 * l0_1_lo,
      u2a_error = ksl_product_error(A->m20, l0_1, u2a), u2a_lo = u2a_error + u2a_cross1,
      u2b = A->m22 - u2a, u2b_error = ksl_difference_error(A->m22, u2a, u2b),
      u2b_lo = u2b_error - u2a_lo, u2c = l1_of_u1_1 * l1, u2c_cross1 = l1_of_u1_1_lo * l1,
      u2c_cross2 = l1_of_u1_1 * l1_lo, u2c_error = ksl_product_error(l1_of_u1_1, l1, u2c),
      u2c_lo1 = u2c_error + u2c_cross1, u2c_lo = u2c_lo1 + u2c_cross2, u2 = u2b - u2c,
      u2_error = ksl_difference_error(u2b, u2c, u2), u2_lo1 = u2_error + u2b_lo,
      u2_lo = u2_lo1 - u2c_lo;
  const double part0a = A->m00 / divisor0, part0a_product = part0a * divisor0,
      part0a_product_error = ksl_product_error(part0a, divisor0, part0a_product),
      part0a_rest = A->m00 - part0a_product, part0a_exact = part0a_rest - part0a_product_error,
      part0a_lo = part0a_exact / divisor0, part0 = 0.0 < A->m00 ? part0a : A->m00,
      part0_lo = 0.0 < A->m00 ? part0a_lo : 0.0;
  const double own1 = 0.0 < A->m11 ? A->m11 : 1.0;
  const double part1a_of_u1_0 = u1_0 + u1_0_lo,
      part1a_of_u1_0_lo = ksl_sum_error(u1_0, u1_0_lo, part1a_of_u1_0),
      part1a = part1a_of_u1_0 / own1, part1a_product = part1a * own1,
      part1a_product_error = ksl_product_error(part1a, own1, part1a_product),
      part1a_rest = part1a_of_u1_0 - part1a_product,
      part1a_exact = part1a_rest - part1a_product_error,
      part1a_residual = part1a_exact + part1a_of_u1_0_lo, part1a_lo = part1a_residual / own1,
      part1 = 0.0 < A->m11 ? part1a : A->m11, part1_lo = 0.0 < A->m11 ? part1a_lo : 0.0;
  const double smallest1 = part0 < part1 ? part0 : part1,
      smallest1_lo = part0 < part1 ? part0_lo : part1_lo;
  const double own2 = 0.0 < A->m22 ? A->m22 : 1.0;
  const double part2a_of_u2 = u2 + u2_lo, part2a_of_u2_lo = ksl_sum_error(u2, u2_lo, part2a_of_u2),
      part2a = part2a_of_u2 / own2, part2a_product = part2a * own2,
      part2a_product_error = ksl_product_error(part2a, own2, part2a_product),
      part2a_rest = part2a_of_u2 - part2a_product,
      part2a_exact = part2a_rest - part2a_product_error,
      part2a_residual = part2a_exact + part2a_of_u2_lo, part2a_lo = part2a_residual / own2,
      part2 = 0.0 < A->m22 ? part2a : A->m22, part2_lo = 0.0 < A->m22 ? part2a_lo : 0.0;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2,
      smallest2_lo = smallest1 < part2 ? smallest1_lo : part2_lo;
  const double smallest2_total = smallest2 + smallest2_lo,
      smallest2_rounded = smallest2_total == smallest2_total ? smallest2_total : smallest2;
  const double l0_0_total = l0_0 + l0_0_lo,
      l0_0_rounded = l0_0_total == l0_0_total ? l0_0_total : l0_0;
  const double u1_0_total = u1_0 + u1_0_lo,
      u1_0_rounded = u1_0_total == u1_0_total ? u1_0_total : u1_0;
  const double l0_1_total = l0_1 + l0_1_lo,
      l0_1_rounded = l0_1_total == l0_1_total ? l0_1_total : l0_1;
  const double l1_total = l1 + l1_lo, l1_rounded = l1_total == l1_total ? l1_total : l1;
  const double u2_total = u2 + u2_lo, u2_rounded = u2_total == u2_total ? u2_total : u2;
  const double A_m00 = A->m00;
  L->m00 = A_m00;
  L->m01 = 0.0;
  L->m02 = 0.0;
  L->m10 = l0_0_rounded;
  L->m11 = u1_0_rounded;
  L->m12 = 0.0;
  L->m20 = l0_1_rounded;
  L->m21 = l1_rounded;
  L->m22 = u2_rounded;
  return smallest2_rounded;
}

/* x = A^-1 b, L of mat3x3_ldl with a positive pivot.
   L: rotation or other 3×3 matrix; b, x: vector.
   13 mul, 33 add, 9 product error, 8 sum error, 6 div, 3 equal, 3 select. */
static inline void ksl_mat3x3_ldl_solve_accurate(const ksl_mat3x3_t *L, const ksl_vec3_t *b,
    ksl_vec3_t *x) {
  const double y1a = L->m10 * b->x, y1a_lo = ksl_product_error(L->m10, b->x, y1a), y1 = b->y - y1a,
      y1_error = ksl_difference_error(b->y, y1a, y1), y1_lo = y1_error - y1a_lo;
  const double y2a = L->m20 * b->x, y2a_lo = ksl_product_error(L->m20, b->x, y2a), y2b = b->z - y2a,
      y2b_error = ksl_difference_error(b->z, y2a, y2b), y2b_lo = y2b_error - y2a_lo,
      y2c = L->m21 * y1, y2c_cross1 = L->m21 * y1_lo,
      y2c_error = ksl_product_error(L->m21, y1, y2c), y2c_lo = y2c_error + y2c_cross1,
      y2 = y2b - y2c, y2_error = ksl_difference_error(y2b, y2c, y2), y2_lo1 = y2_error + y2b_lo,
      y2_lo = y2_lo1 - y2c_lo;
  const double z0 = b->x / L->m00, z0_product = z0 * L->m00,
      z0_product_error = ksl_product_error(z0, L->m00, z0_product), z0_rest = b->x - z0_product,
      z0_exact = z0_rest - z0_product_error, z0_lo = z0_exact / L->m00;
  const double z1_of_y1 = y1 + y1_lo, z1_of_y1_lo = ksl_sum_error(y1, y1_lo, z1_of_y1),
      z1 = z1_of_y1 / L->m11, z1_product = z1 * L->m11,
      z1_product_error = ksl_product_error(z1, L->m11, z1_product), z1_rest = z1_of_y1 - z1_product,
      z1_exact = z1_rest - z1_product_error, z1_residual = z1_exact + z1_of_y1_lo,
      z1_lo = z1_residual / L->m11;
  const double z2_of_y2 = y2 + y2_lo, z2_of_y2_lo = ksl_sum_error(y2, y2_lo, z2_of_y2),
      z2 = z2_of_y2 / L->m22, z2_product = z2 * L->m22,
      z2_product_error = ksl_product_error(z2, L->m22, z2_product), z2_rest = z2_of_y2 - z2_product,
      z2_exact = z2_rest - z2_product_error, z2_residual = z2_exact + z2_of_y2_lo,
      z2_lo = z2_residual / L->m22;
  const double x1a = L->m21 * z2, x1a_cross1 = L->m21 * z2_lo,
      x1a_error = ksl_product_error(L->m21, z2, x1a), x1a_lo = x1a_error + x1a_cross1,
      x1 = z1 - x1a, x1_error = ksl_difference_error(z1, x1a, x1), x1_lo1 = x1_error + z1_lo,
      x1_lo = x1_lo1 - x1a_lo;
  const double x0a = L->m10 * x1, x0a_cross1 = L->m10 * x1_lo,
      x0a_error = ksl_product_error(L->m10, x1, x0a), x0a_lo = x0a_error + x0a_cross1,
      x0b = z0 - x0a, x0b_error = ksl_difference_error(z0, x0a, x0b), x0b_lo1 = x0b_error + z0_lo,
      x0b_lo = x0b_lo1 - x0a_lo, x0c = L->m20 * z2, x0c_cross1 = L->m20 * z2_lo,
      x0c_error = ksl_product_error(L->m20, z2, x0c), x0c_lo = x0c_error + x0c_cross1,
      x0 = x0b - x0c, x0_error = ksl_difference_error(x0b, x0c, x0), x0_lo1 = x0_error + x0b_lo,
      x0_lo = x0_lo1 - x0c_lo;
  const double x0_total = x0 + x0_lo, x0_rounded = x0_total == x0_total ? x0_total : x0;
  const double x1_total = x1 + x1_lo, x1_rounded = x1_total == x1_total ? x1_total : x1;
  const double z2_total = z2 + z2_lo, z2_rounded = z2_total == z2_total ? z2_total : z2;
  x->x = x0_rounded;
  x->y = x1_rounded;
  x->z = z2_rounded;
}

/* x = A^-1 b with one step of refinement; returns the smallest pivot d_i / a_ii: where it is not
     above 8 u, A is singular or indefinite, and x not a number.
   A: rotation or other 3×3 matrix; b, x: vector.
   78 mul, 163 add, 37 product error, 38 sum error, 24 div, 8 less, 4 equal, 27 select. */
static inline double ksl_mat3x3_solve_accurate(const ksl_mat3x3_t *A, const ksl_vec3_t *b,
    ksl_vec3_t *x) {
  const double divisor0 = 0.0 < A->m00 ? A->m00 : 1.0;
  const double l0_0 = A->m10 / divisor0, l0_0_product = l0_0 * divisor0,
      l0_0_product_error = ksl_product_error(l0_0, divisor0, l0_0_product),
      l0_0_rest = A->m10 - l0_0_product, l0_0_exact = l0_0_rest - l0_0_product_error,
      l0_0_lo = l0_0_exact / divisor0;
  const double l0_1 = A->m20 / divisor0, l0_1_product = l0_1 * divisor0,
      l0_1_product_error = ksl_product_error(l0_1, divisor0, l0_1_product),
      l0_1_rest = A->m20 - l0_1_product, l0_1_exact = l0_1_rest - l0_1_product_error,
      l0_1_lo = l0_1_exact / divisor0;
  const double u1_0a = A->m10 * l0_0, u1_0a_cross1 = A->m10 * l0_0_lo,
      u1_0a_error = ksl_product_error(A->m10, l0_0, u1_0a), u1_0a_lo = u1_0a_error + u1_0a_cross1,
      u1_0 = A->m11 - u1_0a, u1_0_error = ksl_difference_error(A->m11, u1_0a, u1_0),
      u1_0_lo = u1_0_error - u1_0a_lo;
  const double u1_1a = A->m20 * l0_0, u1_1a_cross1 = A->m20 * l0_0_lo,
      u1_1a_error = ksl_product_error(A->m20, l0_0, u1_1a), u1_1a_lo = u1_1a_error + u1_1a_cross1,
      u1_1 = A->m21 - u1_1a, u1_1_error = ksl_difference_error(A->m21, u1_1a, u1_1),
      u1_1_lo = u1_1_error - u1_1a_lo;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0, divisor1_lo = 0.0 < u1_0 ? u1_0_lo : 0.0;
  const double l1_of_u1_1 = u1_1 + u1_1_lo,
      l1_of_u1_1_lo = ksl_sum_error(u1_1, u1_1_lo, l1_of_u1_1),
      l1_of_divisor1 = divisor1 + divisor1_lo,
      l1_of_divisor1_lo = ksl_sum_error(divisor1, divisor1_lo, l1_of_divisor1),
      l1 = l1_of_u1_1 / l1_of_divisor1, l1_cross = l1 * l1_of_divisor1_lo,
      l1_product = l1 * l1_of_divisor1,
      l1_product_error = ksl_product_error(l1, l1_of_divisor1, l1_product),
      l1_rest = l1_of_u1_1 - l1_product, l1_exact = l1_rest - l1_product_error,
      l1_lo1 = l1_exact + l1_of_u1_1_lo, l1_residual = l1_lo1 - l1_cross,
      l1_lo = l1_residual / l1_of_divisor1;
  const double u2a = A->m20 * l0_1, u2a_cross1 = A->m20 * l0_1_lo,
      u2a_error = ksl_product_error(A->m20, l0_1, u2a), u2a_lo = u2a_error + u2a_cross1,
      u2b = A->m22 - u2a, u2b_error = ksl_difference_error(A->m22, u2a, u2b),
      u2b_lo = u2b_error - u2a_lo, u2c = l1_of_u1_1 * l1, u2c_cross1 = l1_of_u1_1_lo * l1,
      u2c_cross2 = l1_of_u1_1 * l1_lo, u2c_error = ksl_product_error(l1_of_u1_1, l1, u2c),
      u2c_lo1 = u2c_error + u2c_cross1, u2c_lo = u2c_lo1 + u2c_cross2, u2 = u2b - u2c,
      u2_error = ksl_difference_error(u2b, u2c, u2), u2_lo1 = u2_error + u2b_lo,
      u2_lo = u2_lo1 - u2c_lo;
  const double divisor2 = 0.0 < u2 ? u2 : 1.0, divisor2_lo = 0.0 < u2 ? u2_lo : 0.0;
  const double part0a = A->m00 / divisor0, part0a_product = part0a * divisor0,
      part0a_product_error = ksl_product_error(part0a, divisor0, part0a_product),
      part0a_rest = A->m00 - part0a_product, part0a_exact = part0a_rest - part0a_product_error,
      part0a_lo = part0a_exact / divisor0, part0 = 0.0 < A->m00 ? part0a : A->m00,
      part0_lo = 0.0 < A->m00 ? part0a_lo : 0.0;
  const double own1 = 0.0 < A->m11 ? A->m11 : 1.0;
  const double part1a_of_u1_0 = u1_0 + u1_0_lo,
      part1a_of_u1_0_lo = ksl_sum_error(u1_0, u1_0_lo, part1a_of_u1_0),
      part1a = part1a_of_u1_0 / own1, part1a_product = part1a * own1,
      part1a_product_error = ksl_product_error(part1a, own1, part1a_product),
      part1a_rest = part1a_of_u1_0 - part1a_product,
      part1a_exact = part1a_rest - part1a_product_error,
      part1a_residual = part1a_exact + part1a_of_u1_0_lo, part1a_lo = part1a_residual / own1,
      part1 = 0.0 < A->m11 ? part1a : A->m11, part1_lo = 0.0 < A->m11 ? part1a_lo : 0.0;
  const double smallest1 = part0 < part1 ? part0 : part1,
      smallest1_lo = part0 < part1 ? part0_lo : part1_lo;
  const double own2 = 0.0 < A->m22 ? A->m22 : 1.0;
  const double part2a_of_u2 = u2 + u2_lo, part2a_of_u2_lo = ksl_sum_error(u2, u2_lo, part2a_of_u2),
      part2a = part2a_of_u2 / own2, part2a_product = part2a * own2,
      part2a_product_error = ksl_product_error(part2a, own2, part2a_product),
      part2a_rest = part2a_of_u2 - part2a_product,
      part2a_exact = part2a_rest - part2a_product_error,
      part2a_residual = part2a_exact + part2a_of_u2_lo, part2a_lo = part2a_residual / own2,
      part2 = 0.0 < A->m22 ? part2a : A->m22, part2_lo = 0.0 < A->m22 ? part2a_lo : 0.0;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2,
      smallest2_lo = smallest1 < part2 ? smallest1_lo : part2_lo;
  const double y1a = b->x * l0_0, y1a_cross1 = b->x * l0_0_lo,
      y1a_error = ksl_product_error(b->x, l0_0, y1a), y1a_lo = y1a_error + y1a_cross1,
      y1 = b->y - y1a, y1_error = ksl_difference_error(b->y, y1a, y1), y1_lo = y1_error - y1a_lo;
  const double y2a = b->x * l0_1, y2a_cross1 = b->x * l0_1_lo,
      y2a_error = ksl_product_error(b->x, l0_1, y2a), y2a_lo = y2a_error + y2a_cross1,
      y2b = b->z - y2a, y2b_error = ksl_difference_error(b->z, y2a, y2b),
      y2b_lo = y2b_error - y2a_lo, y2c = l1 * y1, y2c_cross1 = l1_lo * y1, y2c_cross2 = l1 * y1_lo,
      y2c_error = ksl_product_error(l1, y1, y2c), y2c_lo1 = y2c_error + y2c_cross1,
      y2c_lo = y2c_lo1 + y2c_cross2, y2 = y2b - y2c, y2_error = ksl_difference_error(y2b, y2c, y2),
      y2_lo1 = y2_error + y2b_lo, y2_lo = y2_lo1 - y2c_lo;
  const double z0 = b->x / divisor0, z0_product = z0 * divisor0,
      z0_product_error = ksl_product_error(z0, divisor0, z0_product), z0_rest = b->x - z0_product,
      z0_exact = z0_rest - z0_product_error, z0_lo = z0_exact / divisor0;
  const double z1_of_y1 = y1 + y1_lo, z1_of_y1_lo = ksl_sum_error(y1, y1_lo, z1_of_y1),
      z1 = z1_of_y1 / l1_of_divisor1, z1_cross = z1 * l1_of_divisor1_lo,
      z1_product = z1 * l1_of_divisor1,
      z1_product_error = ksl_product_error(z1, l1_of_divisor1, z1_product),
      z1_rest = z1_of_y1 - z1_product, z1_exact = z1_rest - z1_product_error,
      z1_lo1 = z1_exact + z1_of_y1_lo, z1_residual = z1_lo1 - z1_cross,
      z1_lo = z1_residual / l1_of_divisor1;
  const double z2_of_y2 = y2 + y2_lo, z2_of_y2_lo = ksl_sum_error(y2, y2_lo, z2_of_y2),
      z2_of_divisor2 = divisor2 + divisor2_lo,
      z2_of_divisor2_lo = ksl_sum_error(divisor2, divisor2_lo, z2_of_divisor2),
      z2 = z2_of_y2 / z2_of_divisor2, z2_cross = z2 * z2_of_divisor2_lo,
      z2_product = z2 * z2_of_divisor2,
      z2_product_error = ksl_product_error(z2, z2_of_divisor2, z2_product),
      z2_rest = z2_of_y2 - z2_product, z2_exact = z2_rest - z2_product_error,
      z2_lo1 = z2_exact + z2_of_y2_lo, z2_residual = z2_lo1 - z2_cross,
      z2_lo = z2_residual / z2_of_divisor2;
  const double x1a = l1 * z2, x1a_cross1 = l1_lo * z2, x1a_cross2 = l1 * z2_lo,
      x1a_error = ksl_product_error(l1, z2, x1a), x1a_lo1 = x1a_error + x1a_cross1,
      x1a_lo = x1a_lo1 + x1a_cross2, x1 = z1 - x1a, x1_error = ksl_difference_error(z1, x1a, x1),
      x1_lo1 = x1_error + z1_lo, x1_lo = x1_lo1 - x1a_lo;
  const double x0a = l0_0 * x1, x0a_cross1 = l0_0_lo * x1, x0a_cross2 = l0_0 * x1_lo,
      x0a_error = ksl_product_error(l0_0, x1, x0a), x0a_lo1 = x0a_error + x0a_cross1,
      x0a_lo = x0a_lo1 + x0a_cross2, x0b = z0 - x0a, x0b_error = ksl_difference_error(z0, x0a, x0b),
      x0b_lo1 = x0b_error + z0_lo, x0b_lo = x0b_lo1 - x0a_lo, x0c = l0_1 * z2,
      x0c_cross1 = l0_1_lo * z2, x0c_cross2 = l0_1 * z2_lo,
      x0c_error = ksl_product_error(l0_1, z2, x0c), x0c_lo1 = x0c_error + x0c_cross1,
      x0c_lo = x0c_lo1 + x0c_cross2, x0 = x0b - x0c, x0_error = ksl_difference_error(x0b, x0c, x0),
      x0_lo1 = x0_error + x0b_lo, x0_lo = x0_lo1 - x0c_lo;
  const double residual_0a = A->m00 * x0, residual_0a_cross1 = A->m00 * x0_lo,
      residual_0a_error = ksl_product_error(A->m00, x0, residual_0a),
      residual_0a_lo = residual_0a_error + residual_0a_cross1, residual_0b = b->x - residual_0a,
      residual_0b_error = ksl_difference_error(b->x, residual_0a, residual_0b),
      residual_0b_lo = residual_0b_error - residual_0a_lo, residual_0c = A->m10 * x1,
      residual_0c_cross1 = A->m10 * x1_lo,
      residual_0c_error = ksl_product_error(A->m10, x1, residual_0c),
      residual_0c_lo = residual_0c_error + residual_0c_cross1,
      residual_0d = residual_0b - residual_0c,
      residual_0d_error = ksl_difference_error(residual_0b, residual_0c, residual_0d),
      residual_0d_lo1 = residual_0d_error + residual_0b_lo,
      residual_0d_lo = residual_0d_lo1 - residual_0c_lo, residual_0e = A->m20 * z2,
      residual_0e_cross1 = A->m20 * z2_lo,
      residual_0e_error = ksl_product_error(A->m20, z2, residual_0e),
      residual_0e_lo = residual_0e_error + residual_0e_cross1,
      residual_0 = residual_0d - residual_0e,
      residual_0_error = ksl_difference_error(residual_0d, residual_0e, residual_0),
      residual_0_lo1 = residual_0_error + residual_0d_lo,
      residual_0_lo = residual_0_lo1 - residual_0e_lo;
  const double residual_1a = A->m10 * x0, residual_1a_cross1 = A->m10 * x0_lo,
      residual_1a_error = ksl_product_error(A->m10, x0, residual_1a),
      residual_1a_lo = residual_1a_error + residual_1a_cross1, residual_1b = b->y - residual_1a,
      residual_1b_error = ksl_difference_error(b->y, residual_1a, residual_1b),
      residual_1b_lo = residual_1b_error - residual_1a_lo, residual_1c = A->m11 * x1,
      residual_1c_cross1 = A->m11 * x1_lo,
      residual_1c_error = ksl_product_error(A->m11, x1, residual_1c),
      residual_1c_lo = residual_1c_error + residual_1c_cross1,
      residual_1d = residual_1b - residual_1c,
      residual_1d_error = ksl_difference_error(residual_1b, residual_1c, residual_1d),
      residual_1d_lo1 = residual_1d_error + residual_1b_lo,
      residual_1d_lo = residual_1d_lo1 - residual_1c_lo, residual_1e = A->m21 * z2,
      residual_1e_cross1 = A->m21 * z2_lo,
      residual_1e_error = ksl_product_error(A->m21, z2, residual_1e),
      residual_1e_lo = residual_1e_error + residual_1e_cross1,
      residual_1 = residual_1d - residual_1e,
      residual_1_error = ksl_difference_error(residual_1d, residual_1e, residual_1),
      residual_1_lo1 = residual_1_error + residual_1d_lo,
      residual_1_lo = residual_1_lo1 - residual_1e_lo;
  const double residual_2a = A->m20 * x0, residual_2a_cross1 = A->m20 * x0_lo,
      residual_2a_error = ksl_product_error(A->m20, x0, residual_2a),
      residual_2a_lo = residual_2a_error + residual_2a_cross1, residual_2b = b->z - residual_2a,
      residual_2b_error = ksl_difference_error(b->z, residual_2a, residual_2b),
      residual_2b_lo = residual_2b_error - residual_2a_lo, residual_2c = A->m21 * x1,
      residual_2c_cross1 = A->m21 * x1_lo,
      residual_2c_error = ksl_product_error(A->m21, x1, residual_2c),
      residual_2c_lo = residual_2c_error + residual_2c_cross1,
      residual_2d = residual_2b - residual_2c,
      residual_2d_error = ksl_difference_error(residual_2b, residual_2c, residual_2d),
      residual_2d_lo1 = residual_2d_error + residual_2b_lo,
      residual_2d_lo = residual_2d_lo1 - residual_2c_lo, residual_2e = A->m22 * z2,
      residual_2e_cross1 = A->m22 * z2_lo,
      residual_2e_error = ksl_product_error(A->m22, z2, residual_2e),
      residual_2e_lo = residual_2e_error + residual_2e_cross1,
      residual_2 = residual_2d - residual_2e,
      residual_2_error = ksl_difference_error(residual_2d, residual_2e, residual_2),
      residual_2_lo1 = residual_2_error + residual_2d_lo,
      residual_2_lo = residual_2_lo1 - residual_2e_lo;
  const double refined_y1a = l0_0 * residual_0, refined_y1a_cross1 = l0_0_lo * residual_0,
      refined_y1a_cross2 = l0_0 * residual_0_lo,
      refined_y1a_error = ksl_product_error(l0_0, residual_0, refined_y1a),
      refined_y1a_lo1 = refined_y1a_error + refined_y1a_cross1,
      refined_y1a_lo = refined_y1a_lo1 + refined_y1a_cross2, refined_y1 = residual_1 - refined_y1a,
      refined_y1_error = ksl_difference_error(residual_1, refined_y1a, refined_y1),
      refined_y1_lo1 = refined_y1_error + residual_1_lo,
      refined_y1_lo = refined_y1_lo1 - refined_y1a_lo;
  const double refined_y2a = l0_1 * residual_0, refined_y2a_cross1 = l0_1_lo * residual_0,
      refined_y2a_cross2 = l0_1 * residual_0_lo,
      refined_y2a_error = ksl_product_error(l0_1, residual_0, refined_y2a),
      refined_y2a_lo1 = refined_y2a_error + refined_y2a_cross1,
      refined_y2a_lo = refined_y2a_lo1 + refined_y2a_cross2, refined_y2b = residual_2 - refined_y2a,
      refined_y2b_error = ksl_difference_error(residual_2, refined_y2a, refined_y2b),
      refined_y2b_lo1 = refined_y2b_error + residual_2_lo,
      refined_y2b_lo = refined_y2b_lo1 - refined_y2a_lo, refined_y2c = l1 * refined_y1,
      refined_y2c_cross1 = l1_lo * refined_y1, refined_y2c_cross2 = l1 * refined_y1_lo,
      refined_y2c_error = ksl_product_error(l1, refined_y1, refined_y2c),
      refined_y2c_lo1 = refined_y2c_error + refined_y2c_cross1,
      refined_y2c_lo = refined_y2c_lo1 + refined_y2c_cross2, refined_y2 = refined_y2b - refined_y2c,
      refined_y2_error = ksl_difference_error(refined_y2b, refined_y2c, refined_y2),
      refined_y2_lo1 = refined_y2_error + refined_y2b_lo,
      refined_y2_lo = refined_y2_lo1 - refined_y2c_lo;
  const double refined_z0_of_residual_0 = residual_0 + residual_0_lo,
      refined_z0_of_residual_0_lo = ksl_sum_error(residual_0, residual_0_lo, refined_z0_of_residual_0),
      refined_z0 = refined_z0_of_residual_0 / divisor0, refined_z0_product = refined_z0 * divisor0,
      refined_z0_product_error = ksl_product_error(refined_z0, divisor0, refined_z0_product),
      refined_z0_rest = refined_z0_of_residual_0 - refined_z0_product,
      refined_z0_exact = refined_z0_rest - refined_z0_product_error,
      refined_z0_residual = refined_z0_exact + refined_z0_of_residual_0_lo,
      refined_z0_lo = refined_z0_residual / divisor0;
  const double refined_z1_of_refined_y1 = refined_y1 + refined_y1_lo,
      refined_z1_of_refined_y1_lo = ksl_sum_error(refined_y1, refined_y1_lo, refined_z1_of_refined_y1),
      refined_z1 = refined_z1_of_refined_y1 / l1_of_divisor1,
      refined_z1_cross = refined_z1 * l1_of_divisor1_lo,
      refined_z1_product = refined_z1 * l1_of_divisor1,
      refined_z1_product_error = ksl_product_error(refined_z1, l1_of_divisor1, refined_z1_product),
      refined_z1_rest = refined_z1_of_refined_y1 - refined_z1_product,
      refined_z1_exact = refined_z1_rest - refined_z1_product_error,
      refined_z1_lo1 = refined_z1_exact + refined_z1_of_refined_y1_lo,
      refined_z1_residual = refined_z1_lo1 - refined_z1_cross,
      refined_z1_lo = refined_z1_residual / l1_of_divisor1;
  const double refined_z2_of_refined_y2 = refined_y2 + refined_y2_lo,
      refined_z2_of_refined_y2_lo = ksl_sum_error(refined_y2, refined_y2_lo, refined_z2_of_refined_y2),
      refined_z2 = refined_z2_of_refined_y2 / z2_of_divisor2,
      refined_z2_cross = refined_z2 * z2_of_divisor2_lo,
      refined_z2_product = refined_z2 * z2_of_divisor2,
      refined_z2_product_error = ksl_product_error(refined_z2, z2_of_divisor2, refined_z2_product),
      refined_z2_rest = refined_z2_of_refined_y2 - refined_z2_product,
      refined_z2_exact = refined_z2_rest - refined_z2_product_error,
      refined_z2_lo1 = refined_z2_exact + refined_z2_of_refined_y2_lo,
      refined_z2_residual = refined_z2_lo1 - refined_z2_cross,
      refined_z2_lo = refined_z2_residual / z2_of_divisor2;
  const double refined_x1a = l1 * refined_z2, refined_x1a_cross1 = l1_lo * refined_z2,
      refined_x1a_cross2 = l1 * refined_z2_lo,
      refined_x1a_error = ksl_product_error(l1, refined_z2, refined_x1a),
      refined_x1a_lo1 = refined_x1a_error + refined_x1a_cross1,
      refined_x1a_lo = refined_x1a_lo1 + refined_x1a_cross2, refined_x1 = refined_z1 - refined_x1a,
      refined_x1_error = ksl_difference_error(refined_z1, refined_x1a, refined_x1),
      refined_x1_lo1 = refined_x1_error + refined_z1_lo,
      refined_x1_lo = refined_x1_lo1 - refined_x1a_lo;
  const double refined_x0a = l0_0 * refined_x1, refined_x0a_cross1 = l0_0_lo * refined_x1,
      refined_x0a_cross2 = l0_0 * refined_x1_lo,
      refined_x0a_error = ksl_product_error(l0_0, refined_x1, refined_x0a),
      refined_x0a_lo1 = refined_x0a_error + refined_x0a_cross1,
      refined_x0a_lo = refined_x0a_lo1 + refined_x0a_cross2, refined_x0b = refined_z0 - refined_x0a,
      refined_x0b_error = ksl_difference_error(refined_z0, refined_x0a, refined_x0b),
      refined_x0b_lo1 = refined_x0b_error + refined_z0_lo,
      refined_x0b_lo = refined_x0b_lo1 - refined_x0a_lo, refined_x0c = l0_1 * refined_z2,
      refined_x0c_cross1 = l0_1_lo * refined_z2, refined_x0c_cross2 = l0_1 * refined_z2_lo,
      refined_x0c_error = ksl_product_error(l0_1, refined_z2, refined_x0c),
      refined_x0c_lo1 = refined_x0c_error + refined_x0c_cross1,
      refined_x0c_lo = refined_x0c_lo1 + refined_x0c_cross2, refined_x0 = refined_x0b - refined_x0c,
      refined_x0_error = ksl_difference_error(refined_x0b, refined_x0c, refined_x0),
      refined_x0_lo1 = refined_x0_error + refined_x0b_lo,
      refined_x0_lo = refined_x0_lo1 - refined_x0c_lo;
  const double found_0 = x0 + refined_x0, found_0_error = ksl_sum_error(x0, refined_x0, found_0),
      found_0_lo1 = found_0_error + x0_lo, found_0_lo = found_0_lo1 + refined_x0_lo;
  const double found_1 = x1 + refined_x1, found_1_error = ksl_sum_error(x1, refined_x1, found_1),
      found_1_lo1 = found_1_error + x1_lo, found_1_lo = found_1_lo1 + refined_x1_lo;
  const double found_2 = z2 + refined_z2, found_2_error = ksl_sum_error(z2, refined_z2, found_2),
      found_2_lo1 = found_2_error + z2_lo, found_2_lo = found_2_lo1 + refined_z2_lo;
  const double x_0 = 8.881784197001252e-16 < smallest2 ? found_0 : (double)NAN,
      x_0_lo = 8.881784197001252e-16 < smallest2 ? found_0_lo : 0.0;
  const double x_1 = 8.881784197001252e-16 < smallest2 ? found_1 : (double)NAN,
      x_1_lo = 8.881784197001252e-16 < smallest2 ? found_1_lo : 0.0;
  const double x_2 = 8.881784197001252e-16 < smallest2 ? found_2 : (double)NAN,
      x_2_lo = 8.881784197001252e-16 < smallest2 ? found_2_lo : 0.0;
  const double smallest2_total = smallest2 + smallest2_lo,
      smallest2_rounded = smallest2_total == smallest2_total ? smallest2_total : smallest2;
  const double x_0_total = x_0 + x_0_lo, x_0_rounded = x_0_total == x_0_total ? x_0_total : x_0;
  const double x_1_total = x_1 + x_1_lo, x_1_rounded = x_1_total == x_1_total ? x_1_total : x_1;
  const double x_2_total = x_2 + x_2_lo, x_2_rounded = x_2_total == x_2_total ? x_2_total : x_2;
  x->x = x_0_rounded;
  x->y = x_1_rounded;
  x->z = x_2_rounded;
  return smallest2_rounded;
}

/* L, D with L D L^T = A: unit lower triangular L, D on its diagonal; returns the smallest pivot
     d_i / a_ii: where it is not positive, A is not positive definite, and L means nothing.
   A, L: 6×6 operator.
   121 mul, 252 add, 56 product error, 54 sum error, 42 div, 15 less, 21 equal, 57 select. */
static inline double ksl_mat6x6_ldl_accurate(const ksl_mat6x6_t *A, ksl_mat6x6_t *L) {
  const double divisor0 = 0.0 < A->at[0][0] ? A->at[0][0] : 1.0;
  const double l0_0 = A->at[0][1] / divisor0, l0_0_product = l0_0 * divisor0,
      l0_0_product_error = ksl_product_error(l0_0, divisor0, l0_0_product),
      l0_0_rest = A->at[0][1] - l0_0_product, l0_0_exact = l0_0_rest - l0_0_product_error,
      l0_0_lo = l0_0_exact / divisor0;
  const double l0_1 = A->at[0][2] / divisor0, l0_1_product = l0_1 * divisor0,
      l0_1_product_error = ksl_product_error(l0_1, divisor0, l0_1_product),
      l0_1_rest = A->at[0][2] - l0_1_product, l0_1_exact = l0_1_rest - l0_1_product_error,
      l0_1_lo = l0_1_exact / divisor0;
  const double l0_2 = A->at[0][3] / divisor0, l0_2_product = l0_2 * divisor0,
      l0_2_product_error = ksl_product_error(l0_2, divisor0, l0_2_product),
      l0_2_rest = A->at[0][3] - l0_2_product, l0_2_exact = l0_2_rest - l0_2_product_error,
      l0_2_lo = l0_2_exact / divisor0;
  const double l0_3 = A->at[0][4] / divisor0, l0_3_product = l0_3 * divisor0,
      l0_3_product_error = ksl_product_error(l0_3, divisor0, l0_3_product),
      l0_3_rest = A->at[0][4] - l0_3_product, l0_3_exact = l0_3_rest - l0_3_product_error,
      l0_3_lo = l0_3_exact / divisor0;
  const double l0_4 = A->at[0][5] / divisor0, l0_4_product = l0_4 * divisor0,
      l0_4_product_error = ksl_product_error(l0_4, divisor0, l0_4_product),
      l0_4_rest = A->at[0][5] - l0_4_product, l0_4_exact = l0_4_rest - l0_4_product_error,
      l0_4_lo = l0_4_exact / divisor0;
  const double u1_0a = A->at[0][1] * l0_0, u1_0a_cross1 = A->at[0][1] * l0_0_lo,
      u1_0a_error = ksl_product_error(A->at[0][1], l0_0, u1_0a),
      u1_0a_lo = u1_0a_error + u1_0a_cross1, u1_0 = A->at[1][1] - u1_0a,
      u1_0_error = ksl_difference_error(A->at[1][1], u1_0a, u1_0), u1_0_lo = u1_0_error - u1_0a_lo;
  const double u1_1a = A->at[0][2] * l0_0, u1_1a_cross1 = A->at[0][2] * l0_0_lo,
      u1_1a_error = ksl_product_error(A->at[0][2], l0_0, u1_1a),
      u1_1a_lo = u1_1a_error + u1_1a_cross1, u1_1 = A->at[1][2] - u1_1a,
      u1_1_error = ksl_difference_error(A->at[1][2], u1_1a, u1_1), u1_1_lo = u1_1_error - u1_1a_lo;
  const double u1_2a = A->at[0][3] * l0_0, u1_2a_cross1 = A->at[0][3] * l0_0_lo,
      u1_2a_error = ksl_product_error(A->at[0][3], l0_0, u1_2a),
      u1_2a_lo = u1_2a_error + u1_2a_cross1, u1_2 = A->at[1][3] - u1_2a,
      u1_2_error = ksl_difference_error(A->at[1][3], u1_2a, u1_2), u1_2_lo = u1_2_error - u1_2a_lo;
  const double u1_3a = A->at[0][4] * l0_0, u1_3a_cross1 = A->at[0][4] * l0_0_lo,
      u1_3a_error = ksl_product_error(A->at[0][4], l0_0, u1_3a),
      u1_3a_lo = u1_3a_error + u1_3a_cross1, u1_3 = A->at[1][4] - u1_3a,
      u1_3_error = ksl_difference_error(A->at[1][4], u1_3a, u1_3), u1_3_lo = u1_3_error - u1_3a_lo;
  const double u1_4a = A->at[0][5] * l0_0, u1_4a_cross1 = A->at[0][5] * l0_0_lo,
      u1_4a_error = ksl_product_error(A->at[0][5], l0_0, u1_4a),
      u1_4a_lo = u1_4a_error + u1_4a_cross1, u1_4 = A->at[1][5] - u1_4a,
      u1_4_error = ksl_difference_error(A->at[1][5], u1_4a, u1_4), u1_4_lo = u1_4_error - u1_4a_lo;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0, divisor1_lo = 0.0 < u1_0 ? u1_0_lo : 0.0;
  const double l1_0_of_u1_1 = u1_1 + u1_1_lo,
      l1_0_of_u1_1_lo = ksl_sum_error(u1_1, u1_1_lo, l1_0_of_u1_1),
      l1_0_of_divisor1 = divisor1 + divisor1_lo,
      l1_0_of_divisor1_lo = ksl_sum_error(divisor1, divisor1_lo, l1_0_of_divisor1),
      l1_0 = l1_0_of_u1_1 / l1_0_of_divisor1, l1_0_cross = l1_0 * l1_0_of_divisor1_lo,
      l1_0_product = l1_0 * l1_0_of_divisor1,
      l1_0_product_error = ksl_product_error(l1_0, l1_0_of_divisor1, l1_0_product),
      l1_0_rest = l1_0_of_u1_1 - l1_0_product, l1_0_exact = l1_0_rest - l1_0_product_error,
      l1_0_lo1 = l1_0_exact + l1_0_of_u1_1_lo, l1_0_residual = l1_0_lo1 - l1_0_cross,
      l1_0_lo = l1_0_residual / l1_0_of_divisor1;
  const double l1_1_of_u1_2 = u1_2 + u1_2_lo,
      l1_1_of_u1_2_lo = ksl_sum_error(u1_2, u1_2_lo, l1_1_of_u1_2),
      l1_1 = l1_1_of_u1_2 / l1_0_of_divisor1, l1_1_cross = l1_1 * l1_0_of_divisor1_lo,
      l1_1_product = l1_1 * l1_0_of_divisor1,
      l1_1_product_error = ksl_product_error(l1_1, l1_0_of_divisor1, l1_1_product),
      l1_1_rest = l1_1_of_u1_2 - l1_1_product, l1_1_exact = l1_1_rest - l1_1_product_error,
      l1_1_lo1 = l1_1_exact + l1_1_of_u1_2_lo, l1_1_residual = l1_1_lo1 - l1_1_cross,
      l1_1_lo = l1_1_residual / l1_0_of_divisor1;
  const double l1_2_of_u1_3 = u1_3 + u1_3_lo,
      l1_2_of_u1_3_lo = ksl_sum_error(u1_3, u1_3_lo, l1_2_of_u1_3),
      l1_2 = l1_2_of_u1_3 / l1_0_of_divisor1, l1_2_cross = l1_2 * l1_0_of_divisor1_lo,
      l1_2_product = l1_2 * l1_0_of_divisor1,
      l1_2_product_error = ksl_product_error(l1_2, l1_0_of_divisor1, l1_2_product),
      l1_2_rest = l1_2_of_u1_3 - l1_2_product, l1_2_exact = l1_2_rest - l1_2_product_error,
      l1_2_lo1 = l1_2_exact + l1_2_of_u1_3_lo, l1_2_residual = l1_2_lo1 - l1_2_cross,
      l1_2_lo = l1_2_residual / l1_0_of_divisor1;
  const double l1_3_of_u1_4 = u1_4 + u1_4_lo,
      l1_3_of_u1_4_lo = ksl_sum_error(u1_4, u1_4_lo, l1_3_of_u1_4),
      l1_3 = l1_3_of_u1_4 / l1_0_of_divisor1, l1_3_cross = l1_3 * l1_0_of_divisor1_lo,
      l1_3_product = l1_3 * l1_0_of_divisor1,
      l1_3_product_error = ksl_product_error(l1_3, l1_0_of_divisor1, l1_3_product),
      l1_3_rest = l1_3_of_u1_4 - l1_3_product, l1_3_exact = l1_3_rest - l1_3_product_error,
      l1_3_lo1 = l1_3_exact + l1_3_of_u1_4_lo, l1_3_residual = l1_3_lo1 - l1_3_cross,
      l1_3_lo = l1_3_residual / l1_0_of_divisor1;
  const double u2_0a = A->at[0][2] * l0_1, u2_0a_cross1 = A->at[0][2] * l0_1_lo,
      u2_0a_error = ksl_product_error(A->at[0][2], l0_1, u2_0a),
      u2_0a_lo = u2_0a_error + u2_0a_cross1, u2_0b = A->at[2][2] - u2_0a,
      u2_0b_error = ksl_difference_error(A->at[2][2], u2_0a, u2_0b),
      u2_0b_lo = u2_0b_error - u2_0a_lo, u2_0c = l1_0_of_u1_1 * l1_0,
      u2_0c_cross1 = l1_0_of_u1_1_lo * l1_0, u2_0c_cross2 = l1_0_of_u1_1 * l1_0_lo,
      u2_0c_error = ksl_product_error(l1_0_of_u1_1, l1_0, u2_0c),
      u2_0c_lo1 = u2_0c_error + u2_0c_cross1, u2_0c_lo = u2_0c_lo1 + u2_0c_cross2,
      u2_0 = u2_0b - u2_0c, u2_0_error = ksl_difference_error(u2_0b, u2_0c, u2_0),
      u2_0_lo1 = u2_0_error + u2_0b_lo, u2_0_lo = u2_0_lo1 - u2_0c_lo;
  const double u2_1a = A->at[0][3] * l0_1, u2_1a_cross1 = A->at[0][3] * l0_1_lo,
      u2_1a_error = ksl_product_error(A->at[0][3], l0_1, u2_1a),
      u2_1a_lo = u2_1a_error + u2_1a_cross1, u2_1b = A->at[2][3] - u2_1a,
      u2_1b_error = ksl_difference_error(A->at[2][3], u2_1a, u2_1b),
      u2_1b_lo = u2_1b_error - u2_1a_lo, u2_1c = l1_1_of_u1_2 * l1_0,
      u2_1c_cross1 = l1_1_of_u1_2_lo * l1_0, u2_1c_cross2 = l1_1_of_u1_2 * l1_0_lo,
      u2_1c_error = ksl_product_error(l1_1_of_u1_2, l1_0, u2_1c),
      u2_1c_lo1 = u2_1c_error + u2_1c_cross1, u2_1c_lo = u2_1c_lo1 + u2_1c_cross2,
      u2_1 = u2_1b - u2_1c, u2_1_error = ksl_difference_error(u2_1b, u2_1c, u2_1),
      u2_1_lo1 = u2_1_error + u2_1b_lo, u2_1_lo = u2_1_lo1 - u2_1c_lo;
  const double u2_2a = A->at[0][4] * l0_1, u2_2a_cross1 = A->at[0][4] * l0_1_lo,
      u2_2a_error = ksl_product_error(A->at[0][4], l0_1, u2_2a),
      u2_2a_lo = u2_2a_error + u2_2a_cross1, u2_2b = A->at[2][4] - u2_2a,
      u2_2b_error = ksl_difference_error(A->at[2][4], u2_2a, u2_2b),
      u2_2b_lo = u2_2b_error - u2_2a_lo, u2_2c = l1_2_of_u1_3 * l1_0,
      u2_2c_cross1 = l1_2_of_u1_3_lo * l1_0, u2_2c_cross2 = l1_2_of_u1_3 * l1_0_lo,
      u2_2c_error = ksl_product_error(l1_2_of_u1_3, l1_0, u2_2c),
      u2_2c_lo1 = u2_2c_error + u2_2c_cross1, u2_2c_lo = u2_2c_lo1 + u2_2c_cross2,
      u2_2 = u2_2b - u2_2c, u2_2_error = ksl_difference_error(u2_2b, u2_2c, u2_2),
      u2_2_lo1 = u2_2_error + u2_2b_lo, u2_2_lo = u2_2_lo1 - u2_2c_lo;
  const double u2_3a = A->at[0][5] * l0_1, u2_3a_cross1 = A->at[0][5] * l0_1_lo,
      u2_3a_error = ksl_product_error(A->at[0][5], l0_1, u2_3a),
      u2_3a_lo = u2_3a_error + u2_3a_cross1, u2_3b = A->at[2][5] - u2_3a,
      u2_3b_error = ksl_difference_error(A->at[2][5], u2_3a, u2_3b),
      u2_3b_lo = u2_3b_error - u2_3a_lo, u2_3c = l1_3_of_u1_4 * l1_0,
      u2_3c_cross1 = l1_3_of_u1_4_lo * l1_0, u2_3c_cross2 = l1_3_of_u1_4 * l1_0_lo,
      u2_3c_error = ksl_product_error(l1_3_of_u1_4, l1_0, u2_3c),
      u2_3c_lo1 = u2_3c_error + u2_3c_cross1, u2_3c_lo = u2_3c_lo1 + u2_3c_cross2,
      u2_3 = u2_3b - u2_3c, u2_3_error = ksl_difference_error(u2_3b, u2_3c, u2_3),
      u2_3_lo1 = u2_3_error + u2_3b_lo, u2_3_lo = u2_3_lo1 - u2_3c_lo;
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0, divisor2_lo = 0.0 < u2_0 ? u2_0_lo : 0.0;
  const double l2_0_of_u2_1 = u2_1 + u2_1_lo,
      l2_0_of_u2_1_lo = ksl_sum_error(u2_1, u2_1_lo, l2_0_of_u2_1),
      l2_0_of_divisor2 = divisor2 + divisor2_lo,
      l2_0_of_divisor2_lo = ksl_sum_error(divisor2, divisor2_lo, l2_0_of_divisor2),
      l2_0 = l2_0_of_u2_1 / l2_0_of_divisor2, l2_0_cross = l2_0 * l2_0_of_divisor2_lo,
      l2_0_product = l2_0 * l2_0_of_divisor2,
      l2_0_product_error = ksl_product_error(l2_0, l2_0_of_divisor2, l2_0_product),
      l2_0_rest = l2_0_of_u2_1 - l2_0_product, l2_0_exact = l2_0_rest - l2_0_product_error,
      l2_0_lo1 = l2_0_exact + l2_0_of_u2_1_lo, l2_0_residual = l2_0_lo1 - l2_0_cross,
      l2_0_lo = l2_0_residual / l2_0_of_divisor2;
  const double l2_1_of_u2_2 = u2_2 + u2_2_lo,
      l2_1_of_u2_2_lo = ksl_sum_error(u2_2, u2_2_lo, l2_1_of_u2_2),
      l2_1 = l2_1_of_u2_2 / l2_0_of_divisor2, l2_1_cross = l2_1 * l2_0_of_divisor2_lo,
      l2_1_product = l2_1 * l2_0_of_divisor2,
      l2_1_product_error = ksl_product_error(l2_1, l2_0_of_divisor2, l2_1_product),
      l2_1_rest = l2_1_of_u2_2 - l2_1_product, l2_1_exact = l2_1_rest - l2_1_product_error,
      l2_1_lo1 = l2_1_exact + l2_1_of_u2_2_lo, l2_1_residual = l2_1_lo1 - l2_1_cross,
      l2_1_lo = l2_1_residual / l2_0_of_divisor2;
  const double l2_2_of_u2_3 = u2_3 + u2_3_lo,
      l2_2_of_u2_3_lo = ksl_sum_error(u2_3, u2_3_lo, l2_2_of_u2_3),
      l2_2 = l2_2_of_u2_3 / l2_0_of_divisor2, l2_2_cross = l2_2 * l2_0_of_divisor2_lo,
      l2_2_product = l2_2 * l2_0_of_divisor2,
      l2_2_product_error = ksl_product_error(l2_2, l2_0_of_divisor2, l2_2_product),
      l2_2_rest = l2_2_of_u2_3 - l2_2_product, l2_2_exact = l2_2_rest - l2_2_product_error,
      l2_2_lo1 = l2_2_exact + l2_2_of_u2_3_lo, l2_2_residual = l2_2_lo1 - l2_2_cross,
      l2_2_lo = l2_2_residual / l2_0_of_divisor2;
  const double u3_0a = A->at[0][3] * l0_2, u3_0a_cross1 = A->at[0][3] * l0_2_lo,
      u3_0a_error = ksl_product_error(A->at[0][3], l0_2, u3_0a),
      u3_0a_lo = u3_0a_error + u3_0a_cross1, u3_0b = A->at[3][3] - u3_0a,
      u3_0b_error = ksl_difference_error(A->at[3][3], u3_0a, u3_0b),
      u3_0b_lo = u3_0b_error - u3_0a_lo, u3_0c = l1_1_of_u1_2 * l1_1,
      u3_0c_cross1 = l1_1_of_u1_2_lo * l1_1, u3_0c_cross2 = l1_1_of_u1_2 * l1_1_lo,
      u3_0c_error = ksl_product_error(l1_1_of_u1_2, l1_1, u3_0c),
      u3_0c_lo1 = u3_0c_error + u3_0c_cross1, u3_0c_lo = u3_0c_lo1 + u3_0c_cross2,
      u3_0d = u3_0b - u3_0c, u3_0d_error = ksl_difference_error(u3_0b, u3_0c, u3_0d),
      u3_0d_lo1 = u3_0d_error + u3_0b_lo, u3_0d_lo = u3_0d_lo1 - u3_0c_lo,
      u3_0e = l2_0_of_u2_1 * l2_0, u3_0e_cross1 = l2_0_of_u2_1_lo * l2_0,
      u3_0e_cross2 = l2_0_of_u2_1 * l2_0_lo,
      u3_0e_error = ksl_product_error(l2_0_of_u2_1, l2_0, u3_0e),
      u3_0e_lo1 = u3_0e_error + u3_0e_cross1, u3_0e_lo = u3_0e_lo1 + u3_0e_cross2,
      u3_0 = u3_0d - u3_0e, u3_0_error = ksl_difference_error(u3_0d, u3_0e, u3_0),
      u3_0_lo1 = u3_0_error + u3_0d_lo, u3_0_lo = u3_0_lo1 - u3_0e_lo;
  const double u3_1a = A->at[0][4] * l0_2, u3_1a_cross1 = A->at[0][4] * l0_2_lo,
      u3_1a_error = ksl_product_error(A->at[0][4], l0_2, u3_1a),
      u3_1a_lo = u3_1a_error + u3_1a_cross1, u3_1b = A->at[3][4] - u3_1a,
      u3_1b_error = ksl_difference_error(A->at[3][4], u3_1a, u3_1b),
      u3_1b_lo = u3_1b_error - u3_1a_lo, u3_1c = l1_2_of_u1_3 * l1_1,
      u3_1c_cross1 = l1_2_of_u1_3_lo * l1_1, u3_1c_cross2 = l1_2_of_u1_3 * l1_1_lo,
      u3_1c_error = ksl_product_error(l1_2_of_u1_3, l1_1, u3_1c),
      u3_1c_lo1 = u3_1c_error + u3_1c_cross1, u3_1c_lo = u3_1c_lo1 + u3_1c_cross2,
      u3_1d = u3_1b - u3_1c, u3_1d_error = ksl_difference_error(u3_1b, u3_1c, u3_1d),
      u3_1d_lo1 = u3_1d_error + u3_1b_lo, u3_1d_lo = u3_1d_lo1 - u3_1c_lo,
      u3_1e = l2_1_of_u2_2 * l2_0, u3_1e_cross1 = l2_1_of_u2_2_lo * l2_0,
      u3_1e_cross2 = l2_1_of_u2_2 * l2_0_lo,
      u3_1e_error = ksl_product_error(l2_1_of_u2_2, l2_0, u3_1e),
      u3_1e_lo1 = u3_1e_error + u3_1e_cross1, u3_1e_lo = u3_1e_lo1 + u3_1e_cross2,
      u3_1 = u3_1d - u3_1e, u3_1_error = ksl_difference_error(u3_1d, u3_1e, u3_1),
      u3_1_lo1 = u3_1_error + u3_1d_lo, u3_1_lo = u3_1_lo1 - u3_1e_lo;
  const double u3_2a = A->at[0][5] * l0_2, u3_2a_cross1 = A->at[0][5] * l0_2_lo,
      u3_2a_error = ksl_product_error(A->at[0][5], l0_2, u3_2a),
      u3_2a_lo = u3_2a_error + u3_2a_cross1, u3_2b = A->at[3][5] - u3_2a,
      u3_2b_error = ksl_difference_error(A->at[3][5], u3_2a, u3_2b),
      u3_2b_lo = u3_2b_error - u3_2a_lo, u3_2c = l1_3_of_u1_4 * l1_1,
      u3_2c_cross1 = l1_3_of_u1_4_lo * l1_1, u3_2c_cross2 = l1_3_of_u1_4 * l1_1_lo,
      u3_2c_error = ksl_product_error(l1_3_of_u1_4, l1_1, u3_2c),
      u3_2c_lo1 = u3_2c_error + u3_2c_cross1, u3_2c_lo = u3_2c_lo1 + u3_2c_cross2,
      u3_2d = u3_2b - u3_2c, u3_2d_error = ksl_difference_error(u3_2b, u3_2c, u3_2d),
      u3_2d_lo1 = u3_2d_error + u3_2b_lo, u3_2d_lo = u3_2d_lo1 - u3_2c_lo,
      u3_2e = l2_2_of_u2_3 * l2_0, u3_2e_cross1 = l2_2_of_u2_3_lo * l2_0,
      u3_2e_cross2 = l2_2_of_u2_3 * l2_0_lo,
      u3_2e_error = ksl_product_error(l2_2_of_u2_3, l2_0, u3_2e),
      u3_2e_lo1 = u3_2e_error + u3_2e_cross1, u3_2e_lo = u3_2e_lo1 + u3_2e_cross2,
      u3_2 = u3_2d - u3_2e, u3_2_error = ksl_difference_error(u3_2d, u3_2e, u3_2),
      u3_2_lo1 = u3_2_error + u3_2d_lo, u3_2_lo = u3_2_lo1 - u3_2e_lo;
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0, divisor3_lo = 0.0 < u3_0 ? u3_0_lo : 0.0;
  const double l3_0_of_u3_1 = u3_1 + u3_1_lo,
      l3_0_of_u3_1_lo = ksl_sum_error(u3_1, u3_1_lo, l3_0_of_u3_1),
      l3_0_of_divisor3 = divisor3 + divisor3_lo,
      l3_0_of_divisor3_lo = ksl_sum_error(divisor3, divisor3_lo, l3_0_of_divisor3),
      l3_0 = l3_0_of_u3_1 / l3_0_of_divisor3, l3_0_cross = l3_0 * l3_0_of_divisor3_lo,
      l3_0_product = l3_0 * l3_0_of_divisor3,
      l3_0_product_error = ksl_product_error(l3_0, l3_0_of_divisor3, l3_0_product),
      l3_0_rest = l3_0_of_u3_1 - l3_0_product, l3_0_exact = l3_0_rest - l3_0_product_error,
      l3_0_lo1 = l3_0_exact + l3_0_of_u3_1_lo, l3_0_residual = l3_0_lo1 - l3_0_cross,
      l3_0_lo = l3_0_residual / l3_0_of_divisor3;
  const double l3_1_of_u3_2 = u3_2 + u3_2_lo,
      l3_1_of_u3_2_lo = ksl_sum_error(u3_2, u3_2_lo, l3_1_of_u3_2),
      l3_1 = l3_1_of_u3_2 / l3_0_of_divisor3, l3_1_cross = l3_1 * l3_0_of_divisor3_lo,
      l3_1_product = l3_1 * l3_0_of_divisor3,
      l3_1_product_error = ksl_product_error(l3_1, l3_0_of_divisor3, l3_1_product),
      l3_1_rest = l3_1_of_u3_2 - l3_1_product, l3_1_exact = l3_1_rest - l3_1_product_error,
      l3_1_lo1 = l3_1_exact + l3_1_of_u3_2_lo, l3_1_residual = l3_1_lo1 - l3_1_cross,
      l3_1_lo = l3_1_residual / l3_0_of_divisor3;
  const double u4_0a = A->at[0][4] * l0_3, u4_0a_cross1 = A->at[0][4] * l0_3_lo,
      u4_0a_error = ksl_product_error(A->at[0][4], l0_3, u4_0a),
      u4_0a_lo = u4_0a_error + u4_0a_cross1, u4_0b = A->at[4][4] - u4_0a,
      u4_0b_error = ksl_difference_error(A->at[4][4], u4_0a, u4_0b),
      u4_0b_lo = u4_0b_error - u4_0a_lo, u4_0c = l1_2_of_u1_3 * l1_2,
      u4_0c_cross1 = l1_2_of_u1_3_lo * l1_2, u4_0c_cross2 = l1_2_of_u1_3 * l1_2_lo,
      u4_0c_error = ksl_product_error(l1_2_of_u1_3, l1_2, u4_0c),
      u4_0c_lo1 = u4_0c_error + u4_0c_cross1, u4_0c_lo = u4_0c_lo1 + u4_0c_cross2,
      u4_0d = u4_0b - u4_0c, u4_0d_error = ksl_difference_error(u4_0b, u4_0c, u4_0d),
      u4_0d_lo1 = u4_0d_error + u4_0b_lo, u4_0d_lo = u4_0d_lo1 - u4_0c_lo,
      u4_0e = l2_1_of_u2_2 * l2_1, u4_0e_cross1 = l2_1_of_u2_2_lo * l2_1,
      u4_0e_cross2 = l2_1_of_u2_2 * l2_1_lo,
      u4_0e_error = ksl_product_error(l2_1_of_u2_2, l2_1, u4_0e),
      u4_0e_lo1 = u4_0e_error + u4_0e_cross1, u4_0e_lo = u4_0e_lo1 + u4_0e_cross2,
      u4_0f = u4_0d - u4_0e, u4_0f_error = ksl_difference_error(u4_0d, u4_0e, u4_0f),
      u4_0f_lo1 = u4_0f_error + u4_0d_lo, u4_0f_lo = u4_0f_lo1 - u4_0e_lo,
      u4_0g = l3_0_of_u3_1 * l3_0, u4_0g_cross1 = l3_0_of_u3_1_lo * l3_0,
      u4_0g_cross2 = l3_0_of_u3_1 * l3_0_lo,
      u4_0g_error = ksl_product_error(l3_0_of_u3_1, l3_0, u4_0g),
      u4_0g_lo1 = u4_0g_error + u4_0g_cross1, u4_0g_lo = u4_0g_lo1 + u4_0g_cross2,
      u4_0 = u4_0f - u4_0g, u4_0_error = ksl_difference_error(u4_0f, u4_0g, u4_0),
      u4_0_lo1 = u4_0_error + u4_0f_lo, u4_0_lo = u4_0_lo1 - u4_0g_lo;
  const double u4_1a = A->at[0][5] * l0_3, u4_1a_cross1 = A->at[0][5] * l0_3_lo,
      u4_1a_error = ksl_product_error(A->at[0][5], l0_3, u4_1a),
      u4_1a_lo = u4_1a_error + u4_1a_cross1, u4_1b = A->at[4][5] - u4_1a,
      u4_1b_error = ksl_difference_error(A->at[4][5], u4_1a, u4_1b),
      u4_1b_lo = u4_1b_error - u4_1a_lo, u4_1c = l1_3_of_u1_4 * l1_2,
      u4_1c_cross1 = l1_3_of_u1_4_lo * l1_2, u4_1c_cross2 = l1_3_of_u1_4 * l1_2_lo,
      u4_1c_error = ksl_product_error(l1_3_of_u1_4, l1_2, u4_1c),
      u4_1c_lo1 = u4_1c_error + u4_1c_cross1, u4_1c_lo = u4_1c_lo1 + u4_1c_cross2,
      u4_1d = u4_1b - u4_1c, u4_1d_error = ksl_difference_error(u4_1b, u4_1c, u4_1d),
      u4_1d_lo1 = u4_1d_error + u4_1b_lo, u4_1d_lo = u4_1d_lo1 - u4_1c_lo,
      u4_1e = l2_2_of_u2_3 * l2_1, u4_1e_cross1 = l2_2_of_u2_3_lo * l2_1,
      u4_1e_cross2 = l2_2_of_u2_3 * l2_1_lo,
      u4_1e_error = ksl_product_error(l2_2_of_u2_3, l2_1, u4_1e),
      u4_1e_lo1 = u4_1e_error + u4_1e_cross1, u4_1e_lo = u4_1e_lo1 + u4_1e_cross2,
      u4_1f = u4_1d - u4_1e, u4_1f_error = ksl_difference_error(u4_1d, u4_1e, u4_1f),
      u4_1f_lo1 = u4_1f_error + u4_1d_lo, u4_1f_lo = u4_1f_lo1 - u4_1e_lo,
      u4_1g = l3_1_of_u3_2 * l3_0, u4_1g_cross1 = l3_1_of_u3_2_lo * l3_0,
      u4_1g_cross2 = l3_1_of_u3_2 * l3_0_lo,
      u4_1g_error = ksl_product_error(l3_1_of_u3_2, l3_0, u4_1g),
      u4_1g_lo1 = u4_1g_error + u4_1g_cross1, u4_1g_lo = u4_1g_lo1 + u4_1g_cross2,
      u4_1 = u4_1f - u4_1g, u4_1_error = ksl_difference_error(u4_1f, u4_1g, u4_1),
      u4_1_lo1 = u4_1_error + u4_1f_lo, u4_1_lo = u4_1_lo1 - u4_1g_lo;
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0, divisor4_lo = 0.0 < u4_0 ? u4_0_lo : 0.0;
  const double l4_of_u4_1 = u4_1 + u4_1_lo,
      l4_of_u4_1_lo = ksl_sum_error(u4_1, u4_1_lo, l4_of_u4_1),
      l4_of_divisor4 = divisor4 + divisor4_lo,
      l4_of_divisor4_lo = ksl_sum_error(divisor4, divisor4_lo, l4_of_divisor4),
      l4 = l4_of_u4_1 / l4_of_divisor4, l4_cross = l4 * l4_of_divisor4_lo,
      l4_product = l4 * l4_of_divisor4,
      l4_product_error = ksl_product_error(l4, l4_of_divisor4, l4_product),
      l4_rest = l4_of_u4_1 - l4_product, l4_exact = l4_rest - l4_product_error,
      l4_lo1 = l4_exact + l4_of_u4_1_lo, l4_residual = l4_lo1 - l4_cross,
      l4_lo = l4_residual / l4_of_divisor4;
  const double u5a = A->at[0][5] * l0_4, u5a_cross1 = A->at[0][5] * l0_4_lo,
      u5a_error = ksl_product_error(A->at[0][5], l0_4, u5a), u5a_lo = u5a_error + u5a_cross1,
      u5b = A->at[5][5] - u5a, u5b_error = ksl_difference_error(A->at[5][5], u5a, u5b),
      u5b_lo = u5b_error - u5a_lo, u5c = l1_3_of_u1_4 * l1_3, u5c_cross1 = l1_3_of_u1_4_lo * l1_3,
      u5c_cross2 = l1_3_of_u1_4 * l1_3_lo, u5c_error = ksl_product_error(l1_3_of_u1_4, l1_3, u5c),
      u5c_lo1 = u5c_error + u5c_cross1, u5c_lo = u5c_lo1 + u5c_cross2, u5d = u5b - u5c,
      u5d_error = ksl_difference_error(u5b, u5c, u5d), u5d_lo1 = u5d_error + u5b_lo,
      u5d_lo = u5d_lo1 - u5c_lo, u5e = l2_2_of_u2_3 * l2_2, u5e_cross1 = l2_2_of_u2_3_lo * l2_2,
      u5e_cross2 = l2_2_of_u2_3 * l2_2_lo, u5e_error = ksl_product_error(l2_2_of_u2_3, l2_2, u5e),
      u5e_lo1 = u5e_error + u5e_cross1, u5e_lo = u5e_lo1 + u5e_cross2, u5f = u5d - u5e,
      u5f_error = ksl_difference_error(u5d, u5e, u5f), u5f_lo1 = u5f_error + u5d_lo,
      u5f_lo = u5f_lo1 - u5e_lo, u5g = l3_1_of_u3_2 * l3_1, u5g_cross1 = l3_1_of_u3_2_lo * l3_1,
      u5g_cross2 = l3_1_of_u3_2 * l3_1_lo, u5g_error = ksl_product_error(l3_1_of_u3_2, l3_1, u5g),
      u5g_lo1 = u5g_error + u5g_cross1, u5g_lo = u5g_lo1 + u5g_cross2, u5h = u5f - u5g,
      u5h_error = ksl_difference_error(u5f, u5g, u5h), u5h_lo1 = u5h_error + u5f_lo,
      u5h_lo = u5h_lo1 - u5g_lo, u5i = l4_of_u4_1 * l4, u5i_cross1 = l4_of_u4_1_lo * l4,
      u5i_cross2 = l4_of_u4_1 * l4_lo, u5i_error = ksl_product_error(l4_of_u4_1, l4, u5i),
      u5i_lo1 = u5i_error + u5i_cross1, u5i_lo = u5i_lo1 + u5i_cross2, u5 = u5h - u5i,
      u5_error = ksl_difference_error(u5h, u5i, u5), u5_lo1 = u5_error + u5h_lo,
      u5_lo = u5_lo1 - u5i_lo;
  const double part0a = A->at[0][0] / divisor0, part0a_product = part0a * divisor0,
      part0a_product_error = ksl_product_error(part0a, divisor0, part0a_product),
      part0a_rest = A->at[0][0] - part0a_product, part0a_exact = part0a_rest - part0a_product_error,
      part0a_lo = part0a_exact / divisor0, part0 = 0.0 < A->at[0][0] ? part0a : A->at[0][0],
      part0_lo = 0.0 < A->at[0][0] ? part0a_lo : 0.0;
  const double own1 = 0.0 < A->at[1][1] ? A->at[1][1] : 1.0;
  const double part1a_of_u1_0 = u1_0 + u1_0_lo,
      part1a_of_u1_0_lo = ksl_sum_error(u1_0, u1_0_lo, part1a_of_u1_0),
      part1a = part1a_of_u1_0 / own1, part1a_product = part1a * own1,
      part1a_product_error = ksl_product_error(part1a, own1, part1a_product),
      part1a_rest = part1a_of_u1_0 - part1a_product,
      part1a_exact = part1a_rest - part1a_product_error,
      part1a_residual = part1a_exact + part1a_of_u1_0_lo, part1a_lo = part1a_residual / own1,
      part1 = 0.0 < A->at[1][1] ? part1a : A->at[1][1],
      part1_lo = 0.0 < A->at[1][1] ? part1a_lo : 0.0;
  const double smallest1 = part0 < part1 ? part0 : part1,
      smallest1_lo = part0 < part1 ? part0_lo : part1_lo;
  const double own2 = 0.0 < A->at[2][2] ? A->at[2][2] : 1.0;
  const double part2a_of_u2_0 = u2_0 + u2_0_lo,
      part2a_of_u2_0_lo = ksl_sum_error(u2_0, u2_0_lo, part2a_of_u2_0),
      part2a = part2a_of_u2_0 / own2, part2a_product = part2a * own2,
      part2a_product_error = ksl_product_error(part2a, own2, part2a_product),
      part2a_rest = part2a_of_u2_0 - part2a_product,
      part2a_exact = part2a_rest - part2a_product_error,
      part2a_residual = part2a_exact + part2a_of_u2_0_lo, part2a_lo = part2a_residual / own2,
      part2 = 0.0 < A->at[2][2] ? part2a : A->at[2][2],
      part2_lo = 0.0 < A->at[2][2] ? part2a_lo : 0.0;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2,
      smallest2_lo = smallest1 < part2 ? smallest1_lo : part2_lo;
  const double own3 = 0.0 < A->at[3][3] ? A->at[3][3] : 1.0;
  const double part3a_of_u3_0 = u3_0 + u3_0_lo,
      part3a_of_u3_0_lo = ksl_sum_error(u3_0, u3_0_lo, part3a_of_u3_0),
      part3a = part3a_of_u3_0 / own3, part3a_product = part3a * own3,
      part3a_product_error = ksl_product_error(part3a, own3, part3a_product),
      part3a_rest = part3a_of_u3_0 - part3a_product,
      part3a_exact = part3a_rest - part3a_product_error,
      part3a_residual = part3a_exact + part3a_of_u3_0_lo, part3a_lo = part3a_residual / own3,
      part3 = 0.0 < A->at[3][3] ? part3a : A->at[3][3],
      part3_lo = 0.0 < A->at[3][3] ? part3a_lo : 0.0;
  const double smallest3 = smallest2 < part3 ? smallest2 : part3,
      smallest3_lo = smallest2 < part3 ? smallest2_lo : part3_lo;
  const double own4 = 0.0 < A->at[4][4] ? A->at[4][4] : 1.0;
  const double part4a_of_u4_0 = u4_0 + u4_0_lo,
      part4a_of_u4_0_lo = ksl_sum_error(u4_0, u4_0_lo, part4a_of_u4_0),
      part4a = part4a_of_u4_0 / own4, part4a_product = part4a * own4,
      part4a_product_error = ksl_product_error(part4a, own4, part4a_product),
      part4a_rest = part4a_of_u4_0 - part4a_product,
      part4a_exact = part4a_rest - part4a_product_error,
      part4a_residual = part4a_exact + part4a_of_u4_0_lo, part4a_lo = part4a_residual / own4,
      part4 = 0.0 < A->at[4][4] ? part4a : A->at[4][4],
      part4_lo = 0.0 < A->at[4][4] ? part4a_lo : 0.0;
  const double smallest4 = smallest3 < part4 ? smallest3 : part4,
      smallest4_lo = smallest3 < part4 ? smallest3_lo : part4_lo;
  const double own5 = 0.0 < A->at[5][5] ? A->at[5][5] : 1.0;
  const double part5a_of_u5 = u5 + u5_lo, part5a_of_u5_lo = ksl_sum_error(u5, u5_lo, part5a_of_u5),
      part5a = part5a_of_u5 / own5, part5a_product = part5a * own5,
      part5a_product_error = ksl_product_error(part5a, own5, part5a_product),
      part5a_rest = part5a_of_u5 - part5a_product,
      part5a_exact = part5a_rest - part5a_product_error,
      part5a_residual = part5a_exact + part5a_of_u5_lo, part5a_lo = part5a_residual / own5,
      part5 = 0.0 < A->at[5][5] ? part5a : A->at[5][5],
      part5_lo = 0.0 < A->at[5][5] ? part5a_lo : 0.0;
  const double smallest5 = smallest4 < part5 ? smallest4 : part5,
      smallest5_lo = smallest4 < part5 ? smallest4_lo : part5_lo;
  const double smallest5_total = smallest5 + smallest5_lo,
      smallest5_rounded = smallest5_total == smallest5_total ? smallest5_total : smallest5;
  const double l0_0_total = l0_0 + l0_0_lo,
      l0_0_rounded = l0_0_total == l0_0_total ? l0_0_total : l0_0;
  const double u1_0_total = u1_0 + u1_0_lo,
      u1_0_rounded = u1_0_total == u1_0_total ? u1_0_total : u1_0;
  const double l0_1_total = l0_1 + l0_1_lo,
      l0_1_rounded = l0_1_total == l0_1_total ? l0_1_total : l0_1;
  const double l1_0_total = l1_0 + l1_0_lo,
      l1_0_rounded = l1_0_total == l1_0_total ? l1_0_total : l1_0;
  const double u2_0_total = u2_0 + u2_0_lo,
      u2_0_rounded = u2_0_total == u2_0_total ? u2_0_total : u2_0;
  const double l0_2_total = l0_2 + l0_2_lo,
      l0_2_rounded = l0_2_total == l0_2_total ? l0_2_total : l0_2;
  const double l1_1_total = l1_1 + l1_1_lo,
      l1_1_rounded = l1_1_total == l1_1_total ? l1_1_total : l1_1;
  const double l2_0_total = l2_0 + l2_0_lo,
      l2_0_rounded = l2_0_total == l2_0_total ? l2_0_total : l2_0;
  const double u3_0_total = u3_0 + u3_0_lo,
      u3_0_rounded = u3_0_total == u3_0_total ? u3_0_total : u3_0;
  const double l0_3_total = l0_3 + l0_3_lo,
      l0_3_rounded = l0_3_total == l0_3_total ? l0_3_total : l0_3;
  const double l1_2_total = l1_2 + l1_2_lo,
      l1_2_rounded = l1_2_total == l1_2_total ? l1_2_total : l1_2;
  const double l2_1_total = l2_1 + l2_1_lo,
      l2_1_rounded = l2_1_total == l2_1_total ? l2_1_total : l2_1;
  const double l3_0_total = l3_0 + l3_0_lo,
      l3_0_rounded = l3_0_total == l3_0_total ? l3_0_total : l3_0;
  const double u4_0_total = u4_0 + u4_0_lo,
      u4_0_rounded = u4_0_total == u4_0_total ? u4_0_total : u4_0;
  const double l0_4_total = l0_4 + l0_4_lo,
      l0_4_rounded = l0_4_total == l0_4_total ? l0_4_total : l0_4;
  const double l1_3_total = l1_3 + l1_3_lo,
      l1_3_rounded = l1_3_total == l1_3_total ? l1_3_total : l1_3;
  const double l2_2_total = l2_2 + l2_2_lo,
      l2_2_rounded = l2_2_total == l2_2_total ? l2_2_total : l2_2;
  const double l3_1_total = l3_1 + l3_1_lo,
      l3_1_rounded = l3_1_total == l3_1_total ? l3_1_total : l3_1;
  const double l4_total = l4 + l4_lo, l4_rounded = l4_total == l4_total ? l4_total : l4;
  const double u5_total = u5 + u5_lo, u5_rounded = u5_total == u5_total ? u5_total : u5;
  const double A_at_00 = A->at[0][0];
  L->at[0][0] = A_at_00;
  L->at[1][0] = 0.0;
  L->at[2][0] = 0.0;
  L->at[3][0] = 0.0;
  L->at[4][0] = 0.0;
  L->at[5][0] = 0.0;
  L->at[0][1] = l0_0_rounded;
  L->at[1][1] = u1_0_rounded;
  L->at[2][1] = 0.0;
  L->at[3][1] = 0.0;
  L->at[4][1] = 0.0;
  L->at[5][1] = 0.0;
  L->at[0][2] = l0_1_rounded;
  L->at[1][2] = l1_0_rounded;
  L->at[2][2] = u2_0_rounded;
  L->at[3][2] = 0.0;
  L->at[4][2] = 0.0;
  L->at[5][2] = 0.0;
  L->at[0][3] = l0_2_rounded;
  L->at[1][3] = l1_1_rounded;
  L->at[2][3] = l2_0_rounded;
  L->at[3][3] = u3_0_rounded;
  L->at[4][3] = 0.0;
  L->at[5][3] = 0.0;
  L->at[0][4] = l0_3_rounded;
  L->at[1][4] = l1_2_rounded;
  L->at[2][4] = l2_1_rounded;
  L->at[3][4] = l3_0_rounded;
  L->at[4][4] = u4_0_rounded;
  L->at[5][4] = 0.0;
  L->at[0][5] = l0_4_rounded;
  L->at[1][5] = l1_3_rounded;
  L->at[2][5] = l2_2_rounded;
  L->at[3][5] = l3_1_rounded;
  L->at[4][5] = l4_rounded;
  L->at[5][5] = u5_rounded;
  return smallest5_rounded;
}

/* x = A^-1 b, L of mat6x6_ldl with a positive pivot.
   L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   61 mul, 138 add, 36 product error, 35 sum error, 12 div, 6 equal, 6 select. */
static inline void ksl_mat6x6_ldl_solve_accurate(const ksl_mat6x6_t *L, const ksl_coscrew_t *b,
    ksl_screw_t *x) {
  const double y1a = L->at[0][1] * b->m0, y1a_lo = ksl_product_error(L->at[0][1], b->m0, y1a),
      y1 = b->m1 - y1a, y1_error = ksl_difference_error(b->m1, y1a, y1), y1_lo = y1_error - y1a_lo;
  const double y2a = L->at[0][2] * b->m0, y2a_lo = ksl_product_error(L->at[0][2], b->m0, y2a),
      y2b = b->m2 - y2a, y2b_error = ksl_difference_error(b->m2, y2a, y2b),
      y2b_lo = y2b_error - y2a_lo, y2c = L->at[1][2] * y1, y2c_cross1 = L->at[1][2] * y1_lo,
      y2c_error = ksl_product_error(L->at[1][2], y1, y2c), y2c_lo = y2c_error + y2c_cross1,
      y2 = y2b - y2c, y2_error = ksl_difference_error(y2b, y2c, y2), y2_lo1 = y2_error + y2b_lo,
      y2_lo = y2_lo1 - y2c_lo;
  const double y3a = L->at[0][3] * b->m0, y3a_lo = ksl_product_error(L->at[0][3], b->m0, y3a),
      y3b = b->m3 - y3a, y3b_error = ksl_difference_error(b->m3, y3a, y3b),
      y3b_lo = y3b_error - y3a_lo, y3c = L->at[1][3] * y1, y3c_cross1 = L->at[1][3] * y1_lo,
      y3c_error = ksl_product_error(L->at[1][3], y1, y3c), y3c_lo = y3c_error + y3c_cross1,
      y3d = y3b - y3c, y3d_error = ksl_difference_error(y3b, y3c, y3d),
      y3d_lo1 = y3d_error + y3b_lo, y3d_lo = y3d_lo1 - y3c_lo, y3e = L->at[2][3] * y2,
      y3e_cross1 = L->at[2][3] * y2_lo, y3e_error = ksl_product_error(L->at[2][3], y2, y3e),
      y3e_lo = y3e_error + y3e_cross1, y3 = y3d - y3e,
      y3_error = ksl_difference_error(y3d, y3e, y3), y3_lo1 = y3_error + y3d_lo,
      y3_lo = y3_lo1 - y3e_lo;
  const double y4a = L->at[0][4] * b->m0, y4a_lo = ksl_product_error(L->at[0][4], b->m0, y4a),
      y4b = b->m4 - y4a, y4b_error = ksl_difference_error(b->m4, y4a, y4b),
      y4b_lo = y4b_error - y4a_lo, y4c = L->at[1][4] * y1, y4c_cross1 = L->at[1][4] * y1_lo,
      y4c_error = ksl_product_error(L->at[1][4], y1, y4c), y4c_lo = y4c_error + y4c_cross1,
      y4d = y4b - y4c, y4d_error = ksl_difference_error(y4b, y4c, y4d),
      y4d_lo1 = y4d_error + y4b_lo, y4d_lo = y4d_lo1 - y4c_lo, y4e = L->at[2][4] * y2,
      y4e_cross1 = L->at[2][4] * y2_lo, y4e_error = ksl_product_error(L->at[2][4], y2, y4e),
      y4e_lo = y4e_error + y4e_cross1, y4f = y4d - y4e,
      y4f_error = ksl_difference_error(y4d, y4e, y4f), y4f_lo1 = y4f_error + y4d_lo,
      y4f_lo = y4f_lo1 - y4e_lo, y4g = L->at[3][4] * y3, y4g_cross1 = L->at[3][4] * y3_lo,
      y4g_error = ksl_product_error(L->at[3][4], y3, y4g), y4g_lo = y4g_error + y4g_cross1,
      y4 = y4f - y4g, y4_error = ksl_difference_error(y4f, y4g, y4), y4_lo1 = y4_error + y4f_lo,
      y4_lo = y4_lo1 - y4g_lo;
  const double y5a = L->at[0][5] * b->m0, y5a_lo = ksl_product_error(L->at[0][5], b->m0, y5a),
      y5b = b->m5 - y5a, y5b_error = ksl_difference_error(b->m5, y5a, y5b),
      y5b_lo = y5b_error - y5a_lo, y5c = L->at[1][5] * y1, y5c_cross1 = L->at[1][5] * y1_lo,
      y5c_error = ksl_product_error(L->at[1][5], y1, y5c), y5c_lo = y5c_error + y5c_cross1,
      y5d = y5b - y5c, y5d_error = ksl_difference_error(y5b, y5c, y5d),
      y5d_lo1 = y5d_error + y5b_lo, y5d_lo = y5d_lo1 - y5c_lo, y5e = L->at[2][5] * y2,
      y5e_cross1 = L->at[2][5] * y2_lo, y5e_error = ksl_product_error(L->at[2][5], y2, y5e),
      y5e_lo = y5e_error + y5e_cross1, y5f = y5d - y5e,
      y5f_error = ksl_difference_error(y5d, y5e, y5f), y5f_lo1 = y5f_error + y5d_lo,
      y5f_lo = y5f_lo1 - y5e_lo, y5g = L->at[3][5] * y3, y5g_cross1 = L->at[3][5] * y3_lo,
      y5g_error = ksl_product_error(L->at[3][5], y3, y5g), y5g_lo = y5g_error + y5g_cross1,
      y5h = y5f - y5g, y5h_error = ksl_difference_error(y5f, y5g, y5h),
      y5h_lo1 = y5h_error + y5f_lo, y5h_lo = y5h_lo1 - y5g_lo, y5i = L->at[4][5] * y4,
      y5i_cross1 = L->at[4][5] * y4_lo, y5i_error = ksl_product_error(L->at[4][5], y4, y5i),
      y5i_lo = y5i_error + y5i_cross1, y5 = y5h - y5i,
      y5_error = ksl_difference_error(y5h, y5i, y5), y5_lo1 = y5_error + y5h_lo,
      y5_lo = y5_lo1 - y5i_lo;
  const double z0 = b->m0 / L->at[0][0], z0_product = z0 * L->at[0][0],
      z0_product_error = ksl_product_error(z0, L->at[0][0], z0_product),
      z0_rest = b->m0 - z0_product, z0_exact = z0_rest - z0_product_error,
      z0_lo = z0_exact / L->at[0][0];
  const double z1_of_y1 = y1 + y1_lo, z1_of_y1_lo = ksl_sum_error(y1, y1_lo, z1_of_y1),
      z1 = z1_of_y1 / L->at[1][1], z1_product = z1 * L->at[1][1],
      z1_product_error = ksl_product_error(z1, L->at[1][1], z1_product),
      z1_rest = z1_of_y1 - z1_product, z1_exact = z1_rest - z1_product_error,
      z1_residual = z1_exact + z1_of_y1_lo, z1_lo = z1_residual / L->at[1][1];
  const double z2_of_y2 = y2 + y2_lo, z2_of_y2_lo = ksl_sum_error(y2, y2_lo, z2_of_y2),
      z2 = z2_of_y2 / L->at[2][2], z2_product = z2 * L->at[2][2],
      z2_product_error = ksl_product_error(z2, L->at[2][2], z2_product),
      z2_rest = z2_of_y2 - z2_product, z2_exact = z2_rest - z2_product_error,
      z2_residual = z2_exact + z2_of_y2_lo, z2_lo = z2_residual / L->at[2][2];
  const double z3_of_y3 = y3 + y3_lo, z3_of_y3_lo = ksl_sum_error(y3, y3_lo, z3_of_y3),
      z3 = z3_of_y3 / L->at[3][3], z3_product = z3 * L->at[3][3],
      z3_product_error = ksl_product_error(z3, L->at[3][3], z3_product),
      z3_rest = z3_of_y3 - z3_product, z3_exact = z3_rest - z3_product_error,
      z3_residual = z3_exact + z3_of_y3_lo, z3_lo = z3_residual / L->at[3][3];
  const double z4_of_y4 = y4 + y4_lo, z4_of_y4_lo = ksl_sum_error(y4, y4_lo, z4_of_y4),
      z4 = z4_of_y4 / L->at[4][4], z4_product = z4 * L->at[4][4],
      z4_product_error = ksl_product_error(z4, L->at[4][4], z4_product),
      z4_rest = z4_of_y4 - z4_product, z4_exact = z4_rest - z4_product_error,
      z4_residual = z4_exact + z4_of_y4_lo, z4_lo = z4_residual / L->at[4][4];
  const double z5_of_y5 = y5 + y5_lo, z5_of_y5_lo = ksl_sum_error(y5, y5_lo, z5_of_y5),
      z5 = z5_of_y5 / L->at[5][5], z5_product = z5 * L->at[5][5],
      z5_product_error = ksl_product_error(z5, L->at[5][5], z5_product),
      z5_rest = z5_of_y5 - z5_product, z5_exact = z5_rest - z5_product_error,
      z5_residual = z5_exact + z5_of_y5_lo, z5_lo = z5_residual / L->at[5][5];
  const double x4a = L->at[4][5] * z5, x4a_cross1 = L->at[4][5] * z5_lo,
      x4a_error = ksl_product_error(L->at[4][5], z5, x4a), x4a_lo = x4a_error + x4a_cross1,
      x4 = z4 - x4a, x4_error = ksl_difference_error(z4, x4a, x4), x4_lo1 = x4_error + z4_lo,
      x4_lo = x4_lo1 - x4a_lo;
  const double x3a = L->at[3][4] * x4, x3a_cross1 = L->at[3][4] * x4_lo,
      x3a_error = ksl_product_error(L->at[3][4], x4, x3a), x3a_lo = x3a_error + x3a_cross1,
      x3b = z3 - x3a, x3b_error = ksl_difference_error(z3, x3a, x3b), x3b_lo1 = x3b_error + z3_lo,
      x3b_lo = x3b_lo1 - x3a_lo, x3c = L->at[3][5] * z5, x3c_cross1 = L->at[3][5] * z5_lo,
      x3c_error = ksl_product_error(L->at[3][5], z5, x3c), x3c_lo = x3c_error + x3c_cross1,
      x3 = x3b - x3c, x3_error = ksl_difference_error(x3b, x3c, x3), x3_lo1 = x3_error + x3b_lo,
      x3_lo = x3_lo1 - x3c_lo;
  const double x2a = L->at[2][3] * x3, x2a_cross1 = L->at[2][3] * x3_lo,
      x2a_error = ksl_product_error(L->at[2][3], x3, x2a), x2a_lo = x2a_error + x2a_cross1,
      x2b = z2 - x2a, x2b_error = ksl_difference_error(z2, x2a, x2b), x2b_lo1 = x2b_error + z2_lo,
      x2b_lo = x2b_lo1 - x2a_lo, x2c = L->at[2][4] * x4, x2c_cross1 = L->at[2][4] * x4_lo,
      x2c_error = ksl_product_error(L->at[2][4], x4, x2c), x2c_lo = x2c_error + x2c_cross1,
      x2d = x2b - x2c, x2d_error = ksl_difference_error(x2b, x2c, x2d),
      x2d_lo1 = x2d_error + x2b_lo, x2d_lo = x2d_lo1 - x2c_lo, x2e = L->at[2][5] * z5,
      x2e_cross1 = L->at[2][5] * z5_lo, x2e_error = ksl_product_error(L->at[2][5], z5, x2e),
      x2e_lo = x2e_error + x2e_cross1, x2 = x2d - x2e,
      x2_error = ksl_difference_error(x2d, x2e, x2), x2_lo1 = x2_error + x2d_lo,
      x2_lo = x2_lo1 - x2e_lo;
  const double x1a = L->at[1][2] * x2, x1a_cross1 = L->at[1][2] * x2_lo,
      x1a_error = ksl_product_error(L->at[1][2], x2, x1a), x1a_lo = x1a_error + x1a_cross1,
      x1b = z1 - x1a, x1b_error = ksl_difference_error(z1, x1a, x1b), x1b_lo1 = x1b_error + z1_lo,
      x1b_lo = x1b_lo1 - x1a_lo, x1c = L->at[1][3] * x3, x1c_cross1 = L->at[1][3] * x3_lo,
      x1c_error = ksl_product_error(L->at[1][3], x3, x1c), x1c_lo = x1c_error + x1c_cross1,
      x1d = x1b - x1c, x1d_error = ksl_difference_error(x1b, x1c, x1d),
      x1d_lo1 = x1d_error + x1b_lo, x1d_lo = x1d_lo1 - x1c_lo, x1e = L->at[1][4] * x4,
      x1e_cross1 = L->at[1][4] * x4_lo, x1e_error = ksl_product_error(L->at[1][4], x4, x1e),
      x1e_lo = x1e_error + x1e_cross1, x1f = x1d - x1e,
      x1f_error = ksl_difference_error(x1d, x1e, x1f), x1f_lo1 = x1f_error + x1d_lo,
      x1f_lo = x1f_lo1 - x1e_lo, x1g = L->at[1][5] * z5, x1g_cross1 = L->at[1][5] * z5_lo,
      x1g_error = ksl_product_error(L->at[1][5], z5, x1g), x1g_lo = x1g_error + x1g_cross1,
      x1 = x1f - x1g, x1_error = ksl_difference_error(x1f, x1g, x1), x1_lo1 = x1_error + x1f_lo,
      x1_lo = x1_lo1 - x1g_lo;
  const double x0a = L->at[0][1] * x1, x0a_cross1 = L->at[0][1] * x1_lo,
      x0a_error = ksl_product_error(L->at[0][1], x1, x0a), x0a_lo = x0a_error + x0a_cross1,
      x0b = z0 - x0a, x0b_error = ksl_difference_error(z0, x0a, x0b), x0b_lo1 = x0b_error + z0_lo,
      x0b_lo = x0b_lo1 - x0a_lo, x0c = L->at[0][2] * x2, x0c_cross1 = L->at[0][2] * x2_lo,
      x0c_error = ksl_product_error(L->at[0][2], x2, x0c), x0c_lo = x0c_error + x0c_cross1,
      x0d = x0b - x0c, x0d_error = ksl_difference_error(x0b, x0c, x0d),
      x0d_lo1 = x0d_error + x0b_lo, x0d_lo = x0d_lo1 - x0c_lo, x0e = L->at[0][3] * x3,
      x0e_cross1 = L->at[0][3] * x3_lo, x0e_error = ksl_product_error(L->at[0][3], x3, x0e),
      x0e_lo = x0e_error + x0e_cross1, x0f = x0d - x0e,
      x0f_error = ksl_difference_error(x0d, x0e, x0f), x0f_lo1 = x0f_error + x0d_lo,
      x0f_lo = x0f_lo1 - x0e_lo, x0g = L->at[0][4] * x4, x0g_cross1 = L->at[0][4] * x4_lo,
      x0g_error = ksl_product_error(L->at[0][4], x4, x0g), x0g_lo = x0g_error + x0g_cross1,
      x0h = x0f - x0g, x0h_error = ksl_difference_error(x0f, x0g, x0h),
      x0h_lo1 = x0h_error + x0f_lo, x0h_lo = x0h_lo1 - x0g_lo, x0i = L->at[0][5] * z5,
      x0i_cross1 = L->at[0][5] * z5_lo, x0i_error = ksl_product_error(L->at[0][5], z5, x0i),
      x0i_lo = x0i_error + x0i_cross1, x0 = x0h - x0i,
      x0_error = ksl_difference_error(x0h, x0i, x0), x0_lo1 = x0_error + x0h_lo,
      x0_lo = x0_lo1 - x0i_lo;
  const double x0_total = x0 + x0_lo, x0_rounded = x0_total == x0_total ? x0_total : x0;
  const double x1_total = x1 + x1_lo, x1_rounded = x1_total == x1_total ? x1_total : x1;
  const double x2_total = x2 + x2_lo, x2_rounded = x2_total == x2_total ? x2_total : x2;
  const double x3_total = x3 + x3_lo, x3_rounded = x3_total == x3_total ? x3_total : x3;
  const double x4_total = x4 + x4_lo, x4_rounded = x4_total == x4_total ? x4_total : x4;
  const double z5_total = z5 + z5_lo, z5_rounded = z5_total == z5_total ? z5_total : z5;
  x->m0 = x0_rounded;
  x->m1 = x1_rounded;
  x->m2 = x2_rounded;
  x->m3 = x3_rounded;
  x->m4 = x4_rounded;
  x->m5 = z5_rounded;
}

/* x = A^-1 b with one step of refinement; returns the smallest pivot d_i / a_ii: where it is not
     above 8 u, A is singular or indefinite, and x not a number.
   A: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   390 mul, 741 add, 164 product error, 168 sum error, 66 div, 17 less, 7 equal, 57 select. */
static inline double ksl_mat6x6_solve_accurate(const ksl_mat6x6_t *A, const ksl_coscrew_t *b,
    ksl_screw_t *x) {
  const double divisor0 = 0.0 < A->at[0][0] ? A->at[0][0] : 1.0;
  const double l0_0 = A->at[0][1] / divisor0, l0_0_product = l0_0 * divisor0,
      l0_0_product_error = ksl_product_error(l0_0, divisor0, l0_0_product),
      l0_0_rest = A->at[0][1] - l0_0_product, l0_0_exact = l0_0_rest - l0_0_product_error,
      l0_0_lo = l0_0_exact / divisor0;
  const double l0_1 = A->at[0][2] / divisor0, l0_1_product = l0_1 * divisor0,
      l0_1_product_error = ksl_product_error(l0_1, divisor0, l0_1_product),
      l0_1_rest = A->at[0][2] - l0_1_product, l0_1_exact = l0_1_rest - l0_1_product_error,
      l0_1_lo = l0_1_exact / divisor0;
  const double l0_2 = A->at[0][3] / divisor0, l0_2_product = l0_2 * divisor0,
      l0_2_product_error = ksl_product_error(l0_2, divisor0, l0_2_product),
      l0_2_rest = A->at[0][3] - l0_2_product, l0_2_exact = l0_2_rest - l0_2_product_error,
      l0_2_lo = l0_2_exact / divisor0;
  const double l0_3 = A->at[0][4] / divisor0, l0_3_product = l0_3 * divisor0,
      l0_3_product_error = ksl_product_error(l0_3, divisor0, l0_3_product),
      l0_3_rest = A->at[0][4] - l0_3_product, l0_3_exact = l0_3_rest - l0_3_product_error,
      l0_3_lo = l0_3_exact / divisor0;
  const double l0_4 = A->at[0][5] / divisor0, l0_4_product = l0_4 * divisor0,
      l0_4_product_error = ksl_product_error(l0_4, divisor0, l0_4_product),
      l0_4_rest = A->at[0][5] - l0_4_product, l0_4_exact = l0_4_rest - l0_4_product_error,
      l0_4_lo = l0_4_exact / divisor0;
  const double u1_0a = A->at[0][1] * l0_0, u1_0a_cross1 = A->at[0][1] * l0_0_lo,
      u1_0a_error = ksl_product_error(A->at[0][1], l0_0, u1_0a),
      u1_0a_lo = u1_0a_error + u1_0a_cross1, u1_0 = A->at[1][1] - u1_0a,
      u1_0_error = ksl_difference_error(A->at[1][1], u1_0a, u1_0), u1_0_lo = u1_0_error - u1_0a_lo;
  const double u1_1a = A->at[0][2] * l0_0, u1_1a_cross1 = A->at[0][2] * l0_0_lo,
      u1_1a_error = ksl_product_error(A->at[0][2], l0_0, u1_1a),
      u1_1a_lo = u1_1a_error + u1_1a_cross1, u1_1 = A->at[1][2] - u1_1a,
      u1_1_error = ksl_difference_error(A->at[1][2], u1_1a, u1_1), u1_1_lo = u1_1_error - u1_1a_lo;
  const double u1_2a = A->at[0][3] * l0_0, u1_2a_cross1 = A->at[0][3] * l0_0_lo,
      u1_2a_error = ksl_product_error(A->at[0][3], l0_0, u1_2a),
      u1_2a_lo = u1_2a_error + u1_2a_cross1, u1_2 = A->at[1][3] - u1_2a,
      u1_2_error = ksl_difference_error(A->at[1][3], u1_2a, u1_2), u1_2_lo = u1_2_error - u1_2a_lo;
  const double u1_3a = A->at[0][4] * l0_0, u1_3a_cross1 = A->at[0][4] * l0_0_lo,
      u1_3a_error = ksl_product_error(A->at[0][4], l0_0, u1_3a),
      u1_3a_lo = u1_3a_error + u1_3a_cross1, u1_3 = A->at[1][4] - u1_3a,
      u1_3_error = ksl_difference_error(A->at[1][4], u1_3a, u1_3), u1_3_lo = u1_3_error - u1_3a_lo;
  const double u1_4a = A->at[0][5] * l0_0, u1_4a_cross1 = A->at[0][5] * l0_0_lo,
      u1_4a_error = ksl_product_error(A->at[0][5], l0_0, u1_4a),
      u1_4a_lo = u1_4a_error + u1_4a_cross1, u1_4 = A->at[1][5] - u1_4a,
      u1_4_error = ksl_difference_error(A->at[1][5], u1_4a, u1_4), u1_4_lo = u1_4_error - u1_4a_lo;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0, divisor1_lo = 0.0 < u1_0 ? u1_0_lo : 0.0;
  const double l1_0_of_u1_1 = u1_1 + u1_1_lo,
      l1_0_of_u1_1_lo = ksl_sum_error(u1_1, u1_1_lo, l1_0_of_u1_1),
      l1_0_of_divisor1 = divisor1 + divisor1_lo,
      l1_0_of_divisor1_lo = ksl_sum_error(divisor1, divisor1_lo, l1_0_of_divisor1),
      l1_0 = l1_0_of_u1_1 / l1_0_of_divisor1, l1_0_cross = l1_0 * l1_0_of_divisor1_lo,
      l1_0_product = l1_0 * l1_0_of_divisor1,
      l1_0_product_error = ksl_product_error(l1_0, l1_0_of_divisor1, l1_0_product),
      l1_0_rest = l1_0_of_u1_1 - l1_0_product, l1_0_exact = l1_0_rest - l1_0_product_error,
      l1_0_lo1 = l1_0_exact + l1_0_of_u1_1_lo, l1_0_residual = l1_0_lo1 - l1_0_cross,
      l1_0_lo = l1_0_residual / l1_0_of_divisor1;
  const double l1_1_of_u1_2 = u1_2 + u1_2_lo,
      l1_1_of_u1_2_lo = ksl_sum_error(u1_2, u1_2_lo, l1_1_of_u1_2),
      l1_1 = l1_1_of_u1_2 / l1_0_of_divisor1, l1_1_cross = l1_1 * l1_0_of_divisor1_lo,
      l1_1_product = l1_1 * l1_0_of_divisor1,
      l1_1_product_error = ksl_product_error(l1_1, l1_0_of_divisor1, l1_1_product),
      l1_1_rest = l1_1_of_u1_2 - l1_1_product, l1_1_exact = l1_1_rest - l1_1_product_error,
      l1_1_lo1 = l1_1_exact + l1_1_of_u1_2_lo, l1_1_residual = l1_1_lo1 - l1_1_cross,
      l1_1_lo = l1_1_residual / l1_0_of_divisor1;
  const double l1_2_of_u1_3 = u1_3 + u1_3_lo,
      l1_2_of_u1_3_lo = ksl_sum_error(u1_3, u1_3_lo, l1_2_of_u1_3),
      l1_2 = l1_2_of_u1_3 / l1_0_of_divisor1, l1_2_cross = l1_2 * l1_0_of_divisor1_lo,
      l1_2_product = l1_2 * l1_0_of_divisor1,
      l1_2_product_error = ksl_product_error(l1_2, l1_0_of_divisor1, l1_2_product),
      l1_2_rest = l1_2_of_u1_3 - l1_2_product, l1_2_exact = l1_2_rest - l1_2_product_error,
      l1_2_lo1 = l1_2_exact + l1_2_of_u1_3_lo, l1_2_residual = l1_2_lo1 - l1_2_cross,
      l1_2_lo = l1_2_residual / l1_0_of_divisor1;
  const double l1_3_of_u1_4 = u1_4 + u1_4_lo,
      l1_3_of_u1_4_lo = ksl_sum_error(u1_4, u1_4_lo, l1_3_of_u1_4),
      l1_3 = l1_3_of_u1_4 / l1_0_of_divisor1, l1_3_cross = l1_3 * l1_0_of_divisor1_lo,
      l1_3_product = l1_3 * l1_0_of_divisor1,
      l1_3_product_error = ksl_product_error(l1_3, l1_0_of_divisor1, l1_3_product),
      l1_3_rest = l1_3_of_u1_4 - l1_3_product, l1_3_exact = l1_3_rest - l1_3_product_error,
      l1_3_lo1 = l1_3_exact + l1_3_of_u1_4_lo, l1_3_residual = l1_3_lo1 - l1_3_cross,
      l1_3_lo = l1_3_residual / l1_0_of_divisor1;
  const double u2_0a = A->at[0][2] * l0_1, u2_0a_cross1 = A->at[0][2] * l0_1_lo,
      u2_0a_error = ksl_product_error(A->at[0][2], l0_1, u2_0a),
      u2_0a_lo = u2_0a_error + u2_0a_cross1, u2_0b = A->at[2][2] - u2_0a,
      u2_0b_error = ksl_difference_error(A->at[2][2], u2_0a, u2_0b),
      u2_0b_lo = u2_0b_error - u2_0a_lo, u2_0c = l1_0_of_u1_1 * l1_0,
      u2_0c_cross1 = l1_0_of_u1_1_lo * l1_0, u2_0c_cross2 = l1_0_of_u1_1 * l1_0_lo,
      u2_0c_error = ksl_product_error(l1_0_of_u1_1, l1_0, u2_0c),
      u2_0c_lo1 = u2_0c_error + u2_0c_cross1, u2_0c_lo = u2_0c_lo1 + u2_0c_cross2,
      u2_0 = u2_0b - u2_0c, u2_0_error = ksl_difference_error(u2_0b, u2_0c, u2_0),
      u2_0_lo1 = u2_0_error + u2_0b_lo, u2_0_lo = u2_0_lo1 - u2_0c_lo;
  const double u2_1a = A->at[0][3] * l0_1, u2_1a_cross1 = A->at[0][3] * l0_1_lo,
      u2_1a_error = ksl_product_error(A->at[0][3], l0_1, u2_1a),
      u2_1a_lo = u2_1a_error + u2_1a_cross1, u2_1b = A->at[2][3] - u2_1a,
      u2_1b_error = ksl_difference_error(A->at[2][3], u2_1a, u2_1b),
      u2_1b_lo = u2_1b_error - u2_1a_lo, u2_1c = l1_1_of_u1_2 * l1_0,
      u2_1c_cross1 = l1_1_of_u1_2_lo * l1_0, u2_1c_cross2 = l1_1_of_u1_2 * l1_0_lo,
      u2_1c_error = ksl_product_error(l1_1_of_u1_2, l1_0, u2_1c),
      u2_1c_lo1 = u2_1c_error + u2_1c_cross1, u2_1c_lo = u2_1c_lo1 + u2_1c_cross2,
      u2_1 = u2_1b - u2_1c, u2_1_error = ksl_difference_error(u2_1b, u2_1c, u2_1),
      u2_1_lo1 = u2_1_error + u2_1b_lo, u2_1_lo = u2_1_lo1 - u2_1c_lo;
  const double u2_2a = A->at[0][4] * l0_1, u2_2a_cross1 = A->at[0][4] * l0_1_lo,
      u2_2a_error = ksl_product_error(A->at[0][4], l0_1, u2_2a),
      u2_2a_lo = u2_2a_error + u2_2a_cross1, u2_2b = A->at[2][4] - u2_2a,
      u2_2b_error = ksl_difference_error(A->at[2][4], u2_2a, u2_2b),
      u2_2b_lo = u2_2b_error - u2_2a_lo, u2_2c = l1_2_of_u1_3 * l1_0,
      u2_2c_cross1 = l1_2_of_u1_3_lo * l1_0, u2_2c_cross2 = l1_2_of_u1_3 * l1_0_lo,
      u2_2c_error = ksl_product_error(l1_2_of_u1_3, l1_0, u2_2c),
      u2_2c_lo1 = u2_2c_error + u2_2c_cross1, u2_2c_lo = u2_2c_lo1 + u2_2c_cross2,
      u2_2 = u2_2b - u2_2c, u2_2_error = ksl_difference_error(u2_2b, u2_2c, u2_2),
      u2_2_lo1 = u2_2_error + u2_2b_lo, u2_2_lo = u2_2_lo1 - u2_2c_lo;
  const double u2_3a = A->at[0][5] * l0_1, u2_3a_cross1 = A->at[0][5] * l0_1_lo,
      u2_3a_error = ksl_product_error(A->at[0][5], l0_1, u2_3a),
      u2_3a_lo = u2_3a_error + u2_3a_cross1, u2_3b = A->at[2][5] - u2_3a,
      u2_3b_error = ksl_difference_error(A->at[2][5], u2_3a, u2_3b),
      u2_3b_lo = u2_3b_error - u2_3a_lo, u2_3c = l1_3_of_u1_4 * l1_0,
      u2_3c_cross1 = l1_3_of_u1_4_lo * l1_0, u2_3c_cross2 = l1_3_of_u1_4 * l1_0_lo,
      u2_3c_error = ksl_product_error(l1_3_of_u1_4, l1_0, u2_3c),
      u2_3c_lo1 = u2_3c_error + u2_3c_cross1, u2_3c_lo = u2_3c_lo1 + u2_3c_cross2,
      u2_3 = u2_3b - u2_3c, u2_3_error = ksl_difference_error(u2_3b, u2_3c, u2_3),
      u2_3_lo1 = u2_3_error + u2_3b_lo, u2_3_lo = u2_3_lo1 - u2_3c_lo;
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0, divisor2_lo = 0.0 < u2_0 ? u2_0_lo : 0.0;
  const double l2_0_of_u2_1 = u2_1 + u2_1_lo,
      l2_0_of_u2_1_lo = ksl_sum_error(u2_1, u2_1_lo, l2_0_of_u2_1),
      l2_0_of_divisor2 = divisor2 + divisor2_lo,
      l2_0_of_divisor2_lo = ksl_sum_error(divisor2, divisor2_lo, l2_0_of_divisor2),
      l2_0 = l2_0_of_u2_1 / l2_0_of_divisor2, l2_0_cross = l2_0 * l2_0_of_divisor2_lo,
      l2_0_product = l2_0 * l2_0_of_divisor2,
      l2_0_product_error = ksl_product_error(l2_0, l2_0_of_divisor2, l2_0_product),
      l2_0_rest = l2_0_of_u2_1 - l2_0_product, l2_0_exact = l2_0_rest - l2_0_product_error,
      l2_0_lo1 = l2_0_exact + l2_0_of_u2_1_lo, l2_0_residual = l2_0_lo1 - l2_0_cross,
      l2_0_lo = l2_0_residual / l2_0_of_divisor2;
  const double l2_1_of_u2_2 = u2_2 + u2_2_lo,
      l2_1_of_u2_2_lo = ksl_sum_error(u2_2, u2_2_lo, l2_1_of_u2_2),
      l2_1 = l2_1_of_u2_2 / l2_0_of_divisor2, l2_1_cross = l2_1 * l2_0_of_divisor2_lo,
      l2_1_product = l2_1 * l2_0_of_divisor2,
      l2_1_product_error = ksl_product_error(l2_1, l2_0_of_divisor2, l2_1_product),
      l2_1_rest = l2_1_of_u2_2 - l2_1_product, l2_1_exact = l2_1_rest - l2_1_product_error,
      l2_1_lo1 = l2_1_exact + l2_1_of_u2_2_lo, l2_1_residual = l2_1_lo1 - l2_1_cross,
      l2_1_lo = l2_1_residual / l2_0_of_divisor2;
  const double l2_2_of_u2_3 = u2_3 + u2_3_lo,
      l2_2_of_u2_3_lo = ksl_sum_error(u2_3, u2_3_lo, l2_2_of_u2_3),
      l2_2 = l2_2_of_u2_3 / l2_0_of_divisor2, l2_2_cross = l2_2 * l2_0_of_divisor2_lo,
      l2_2_product = l2_2 * l2_0_of_divisor2,
      l2_2_product_error = ksl_product_error(l2_2, l2_0_of_divisor2, l2_2_product),
      l2_2_rest = l2_2_of_u2_3 - l2_2_product, l2_2_exact = l2_2_rest - l2_2_product_error,
      l2_2_lo1 = l2_2_exact + l2_2_of_u2_3_lo, l2_2_residual = l2_2_lo1 - l2_2_cross,
      l2_2_lo = l2_2_residual / l2_0_of_divisor2;
  const double u3_0a = A->at[0][3] * l0_2, u3_0a_cross1 = A->at[0][3] * l0_2_lo,
      u3_0a_error = ksl_product_error(A->at[0][3], l0_2, u3_0a),
      u3_0a_lo = u3_0a_error + u3_0a_cross1, u3_0b = A->at[3][3] - u3_0a,
      u3_0b_error = ksl_difference_error(A->at[3][3], u3_0a, u3_0b),
      u3_0b_lo = u3_0b_error - u3_0a_lo, u3_0c = l1_1_of_u1_2 * l1_1,
      u3_0c_cross1 = l1_1_of_u1_2_lo * l1_1, u3_0c_cross2 = l1_1_of_u1_2 * l1_1_lo,
      u3_0c_error = ksl_product_error(l1_1_of_u1_2, l1_1, u3_0c),
      u3_0c_lo1 = u3_0c_error + u3_0c_cross1, u3_0c_lo = u3_0c_lo1 + u3_0c_cross2,
      u3_0d = u3_0b - u3_0c, u3_0d_error = ksl_difference_error(u3_0b, u3_0c, u3_0d),
      u3_0d_lo1 = u3_0d_error + u3_0b_lo, u3_0d_lo = u3_0d_lo1 - u3_0c_lo,
      u3_0e = l2_0_of_u2_1 * l2_0, u3_0e_cross1 = l2_0_of_u2_1_lo * l2_0,
      u3_0e_cross2 = l2_0_of_u2_1 * l2_0_lo,
      u3_0e_error = ksl_product_error(l2_0_of_u2_1, l2_0, u3_0e),
      u3_0e_lo1 = u3_0e_error + u3_0e_cross1, u3_0e_lo = u3_0e_lo1 + u3_0e_cross2,
      u3_0 = u3_0d - u3_0e, u3_0_error = ksl_difference_error(u3_0d, u3_0e, u3_0),
      u3_0_lo1 = u3_0_error + u3_0d_lo, u3_0_lo = u3_0_lo1 - u3_0e_lo;
  const double u3_1a = A->at[0][4] * l0_2, u3_1a_cross1 = A->at[0][4] * l0_2_lo,
      u3_1a_error = ksl_product_error(A->at[0][4], l0_2, u3_1a),
      u3_1a_lo = u3_1a_error + u3_1a_cross1, u3_1b = A->at[3][4] - u3_1a,
      u3_1b_error = ksl_difference_error(A->at[3][4], u3_1a, u3_1b),
      u3_1b_lo = u3_1b_error - u3_1a_lo, u3_1c = l1_2_of_u1_3 * l1_1,
      u3_1c_cross1 = l1_2_of_u1_3_lo * l1_1, u3_1c_cross2 = l1_2_of_u1_3 * l1_1_lo,
      u3_1c_error = ksl_product_error(l1_2_of_u1_3, l1_1, u3_1c),
      u3_1c_lo1 = u3_1c_error + u3_1c_cross1, u3_1c_lo = u3_1c_lo1 + u3_1c_cross2,
      u3_1d = u3_1b - u3_1c, u3_1d_error = ksl_difference_error(u3_1b, u3_1c, u3_1d),
      u3_1d_lo1 = u3_1d_error + u3_1b_lo, u3_1d_lo = u3_1d_lo1 - u3_1c_lo,
      u3_1e = l2_1_of_u2_2 * l2_0, u3_1e_cross1 = l2_1_of_u2_2_lo * l2_0,
      u3_1e_cross2 = l2_1_of_u2_2 * l2_0_lo,
      u3_1e_error = ksl_product_error(l2_1_of_u2_2, l2_0, u3_1e),
      u3_1e_lo1 = u3_1e_error + u3_1e_cross1, u3_1e_lo = u3_1e_lo1 + u3_1e_cross2,
      u3_1 = u3_1d - u3_1e, u3_1_error = ksl_difference_error(u3_1d, u3_1e, u3_1),
      u3_1_lo1 = u3_1_error + u3_1d_lo, u3_1_lo = u3_1_lo1 - u3_1e_lo;
  const double u3_2a = A->at[0][5] * l0_2, u3_2a_cross1 = A->at[0][5] * l0_2_lo,
      u3_2a_error = ksl_product_error(A->at[0][5], l0_2, u3_2a),
      u3_2a_lo = u3_2a_error + u3_2a_cross1, u3_2b = A->at[3][5] - u3_2a,
      u3_2b_error = ksl_difference_error(A->at[3][5], u3_2a, u3_2b),
      u3_2b_lo = u3_2b_error - u3_2a_lo, u3_2c = l1_3_of_u1_4 * l1_1,
      u3_2c_cross1 = l1_3_of_u1_4_lo * l1_1, u3_2c_cross2 = l1_3_of_u1_4 * l1_1_lo,
      u3_2c_error = ksl_product_error(l1_3_of_u1_4, l1_1, u3_2c),
      u3_2c_lo1 = u3_2c_error + u3_2c_cross1, u3_2c_lo = u3_2c_lo1 + u3_2c_cross2,
      u3_2d = u3_2b - u3_2c, u3_2d_error = ksl_difference_error(u3_2b, u3_2c, u3_2d),
      u3_2d_lo1 = u3_2d_error + u3_2b_lo, u3_2d_lo = u3_2d_lo1 - u3_2c_lo,
      u3_2e = l2_2_of_u2_3 * l2_0, u3_2e_cross1 = l2_2_of_u2_3_lo * l2_0,
      u3_2e_cross2 = l2_2_of_u2_3 * l2_0_lo,
      u3_2e_error = ksl_product_error(l2_2_of_u2_3, l2_0, u3_2e),
      u3_2e_lo1 = u3_2e_error + u3_2e_cross1, u3_2e_lo = u3_2e_lo1 + u3_2e_cross2,
      u3_2 = u3_2d - u3_2e, u3_2_error = ksl_difference_error(u3_2d, u3_2e, u3_2),
      u3_2_lo1 = u3_2_error + u3_2d_lo, u3_2_lo = u3_2_lo1 - u3_2e_lo;
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0, divisor3_lo = 0.0 < u3_0 ? u3_0_lo : 0.0;
  const double l3_0_of_u3_1 = u3_1 + u3_1_lo,
      l3_0_of_u3_1_lo = ksl_sum_error(u3_1, u3_1_lo, l3_0_of_u3_1),
      l3_0_of_divisor3 = divisor3 + divisor3_lo,
      l3_0_of_divisor3_lo = ksl_sum_error(divisor3, divisor3_lo, l3_0_of_divisor3),
      l3_0 = l3_0_of_u3_1 / l3_0_of_divisor3, l3_0_cross = l3_0 * l3_0_of_divisor3_lo,
      l3_0_product = l3_0 * l3_0_of_divisor3,
      l3_0_product_error = ksl_product_error(l3_0, l3_0_of_divisor3, l3_0_product),
      l3_0_rest = l3_0_of_u3_1 - l3_0_product, l3_0_exact = l3_0_rest - l3_0_product_error,
      l3_0_lo1 = l3_0_exact + l3_0_of_u3_1_lo, l3_0_residual = l3_0_lo1 - l3_0_cross,
      l3_0_lo = l3_0_residual / l3_0_of_divisor3;
  const double l3_1_of_u3_2 = u3_2 + u3_2_lo,
      l3_1_of_u3_2_lo = ksl_sum_error(u3_2, u3_2_lo, l3_1_of_u3_2),
      l3_1 = l3_1_of_u3_2 / l3_0_of_divisor3, l3_1_cross = l3_1 * l3_0_of_divisor3_lo,
      l3_1_product = l3_1 * l3_0_of_divisor3,
      l3_1_product_error = ksl_product_error(l3_1, l3_0_of_divisor3, l3_1_product),
      l3_1_rest = l3_1_of_u3_2 - l3_1_product, l3_1_exact = l3_1_rest - l3_1_product_error,
      l3_1_lo1 = l3_1_exact + l3_1_of_u3_2_lo, l3_1_residual = l3_1_lo1 - l3_1_cross,
      l3_1_lo = l3_1_residual / l3_0_of_divisor3;
  const double u4_0a = A->at[0][4] * l0_3, u4_0a_cross1 = A->at[0][4] * l0_3_lo,
      u4_0a_error = ksl_product_error(A->at[0][4], l0_3, u4_0a),
      u4_0a_lo = u4_0a_error + u4_0a_cross1, u4_0b = A->at[4][4] - u4_0a,
      u4_0b_error = ksl_difference_error(A->at[4][4], u4_0a, u4_0b),
      u4_0b_lo = u4_0b_error - u4_0a_lo, u4_0c = l1_2_of_u1_3 * l1_2,
      u4_0c_cross1 = l1_2_of_u1_3_lo * l1_2, u4_0c_cross2 = l1_2_of_u1_3 * l1_2_lo,
      u4_0c_error = ksl_product_error(l1_2_of_u1_3, l1_2, u4_0c),
      u4_0c_lo1 = u4_0c_error + u4_0c_cross1, u4_0c_lo = u4_0c_lo1 + u4_0c_cross2,
      u4_0d = u4_0b - u4_0c, u4_0d_error = ksl_difference_error(u4_0b, u4_0c, u4_0d),
      u4_0d_lo1 = u4_0d_error + u4_0b_lo, u4_0d_lo = u4_0d_lo1 - u4_0c_lo,
      u4_0e = l2_1_of_u2_2 * l2_1, u4_0e_cross1 = l2_1_of_u2_2_lo * l2_1,
      u4_0e_cross2 = l2_1_of_u2_2 * l2_1_lo,
      u4_0e_error = ksl_product_error(l2_1_of_u2_2, l2_1, u4_0e),
      u4_0e_lo1 = u4_0e_error + u4_0e_cross1, u4_0e_lo = u4_0e_lo1 + u4_0e_cross2,
      u4_0f = u4_0d - u4_0e, u4_0f_error = ksl_difference_error(u4_0d, u4_0e, u4_0f),
      u4_0f_lo1 = u4_0f_error + u4_0d_lo, u4_0f_lo = u4_0f_lo1 - u4_0e_lo,
      u4_0g = l3_0_of_u3_1 * l3_0, u4_0g_cross1 = l3_0_of_u3_1_lo * l3_0,
      u4_0g_cross2 = l3_0_of_u3_1 * l3_0_lo,
      u4_0g_error = ksl_product_error(l3_0_of_u3_1, l3_0, u4_0g),
      u4_0g_lo1 = u4_0g_error + u4_0g_cross1, u4_0g_lo = u4_0g_lo1 + u4_0g_cross2,
      u4_0 = u4_0f - u4_0g, u4_0_error = ksl_difference_error(u4_0f, u4_0g, u4_0),
      u4_0_lo1 = u4_0_error + u4_0f_lo, u4_0_lo = u4_0_lo1 - u4_0g_lo;
  const double u4_1a = A->at[0][5] * l0_3, u4_1a_cross1 = A->at[0][5] * l0_3_lo,
      u4_1a_error = ksl_product_error(A->at[0][5], l0_3, u4_1a),
      u4_1a_lo = u4_1a_error + u4_1a_cross1, u4_1b = A->at[4][5] - u4_1a,
      u4_1b_error = ksl_difference_error(A->at[4][5], u4_1a, u4_1b),
      u4_1b_lo = u4_1b_error - u4_1a_lo, u4_1c = l1_3_of_u1_4 * l1_2,
      u4_1c_cross1 = l1_3_of_u1_4_lo * l1_2, u4_1c_cross2 = l1_3_of_u1_4 * l1_2_lo,
      u4_1c_error = ksl_product_error(l1_3_of_u1_4, l1_2, u4_1c),
      u4_1c_lo1 = u4_1c_error + u4_1c_cross1, u4_1c_lo = u4_1c_lo1 + u4_1c_cross2,
      u4_1d = u4_1b - u4_1c, u4_1d_error = ksl_difference_error(u4_1b, u4_1c, u4_1d),
      u4_1d_lo1 = u4_1d_error + u4_1b_lo, u4_1d_lo = u4_1d_lo1 - u4_1c_lo,
      u4_1e = l2_2_of_u2_3 * l2_1, u4_1e_cross1 = l2_2_of_u2_3_lo * l2_1,
      u4_1e_cross2 = l2_2_of_u2_3 * l2_1_lo,
      u4_1e_error = ksl_product_error(l2_2_of_u2_3, l2_1, u4_1e),
      u4_1e_lo1 = u4_1e_error + u4_1e_cross1, u4_1e_lo = u4_1e_lo1 + u4_1e_cross2,
      u4_1f = u4_1d - u4_1e, u4_1f_error = ksl_difference_error(u4_1d, u4_1e, u4_1f),
      u4_1f_lo1 = u4_1f_error + u4_1d_lo, u4_1f_lo = u4_1f_lo1 - u4_1e_lo,
      u4_1g = l3_1_of_u3_2 * l3_0, u4_1g_cross1 = l3_1_of_u3_2_lo * l3_0,
      u4_1g_cross2 = l3_1_of_u3_2 * l3_0_lo,
      u4_1g_error = ksl_product_error(l3_1_of_u3_2, l3_0, u4_1g),
      u4_1g_lo1 = u4_1g_error + u4_1g_cross1, u4_1g_lo = u4_1g_lo1 + u4_1g_cross2,
      u4_1 = u4_1f - u4_1g, u4_1_error = ksl_difference_error(u4_1f, u4_1g, u4_1),
      u4_1_lo1 = u4_1_error + u4_1f_lo, u4_1_lo = u4_1_lo1 - u4_1g_lo;
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0, divisor4_lo = 0.0 < u4_0 ? u4_0_lo : 0.0;
  const double l4_of_u4_1 = u4_1 + u4_1_lo,
      l4_of_u4_1_lo = ksl_sum_error(u4_1, u4_1_lo, l4_of_u4_1),
      l4_of_divisor4 = divisor4 + divisor4_lo,
      l4_of_divisor4_lo = ksl_sum_error(divisor4, divisor4_lo, l4_of_divisor4),
      l4 = l4_of_u4_1 / l4_of_divisor4, l4_cross = l4 * l4_of_divisor4_lo,
      l4_product = l4 * l4_of_divisor4,
      l4_product_error = ksl_product_error(l4, l4_of_divisor4, l4_product),
      l4_rest = l4_of_u4_1 - l4_product, l4_exact = l4_rest - l4_product_error,
      l4_lo1 = l4_exact + l4_of_u4_1_lo, l4_residual = l4_lo1 - l4_cross,
      l4_lo = l4_residual / l4_of_divisor4;
  const double u5a = A->at[0][5] * l0_4, u5a_cross1 = A->at[0][5] * l0_4_lo,
      u5a_error = ksl_product_error(A->at[0][5], l0_4, u5a), u5a_lo = u5a_error + u5a_cross1,
      u5b = A->at[5][5] - u5a, u5b_error = ksl_difference_error(A->at[5][5], u5a, u5b),
      u5b_lo = u5b_error - u5a_lo, u5c = l1_3_of_u1_4 * l1_3, u5c_cross1 = l1_3_of_u1_4_lo * l1_3,
      u5c_cross2 = l1_3_of_u1_4 * l1_3_lo, u5c_error = ksl_product_error(l1_3_of_u1_4, l1_3, u5c),
      u5c_lo1 = u5c_error + u5c_cross1, u5c_lo = u5c_lo1 + u5c_cross2, u5d = u5b - u5c,
      u5d_error = ksl_difference_error(u5b, u5c, u5d), u5d_lo1 = u5d_error + u5b_lo,
      u5d_lo = u5d_lo1 - u5c_lo, u5e = l2_2_of_u2_3 * l2_2, u5e_cross1 = l2_2_of_u2_3_lo * l2_2,
      u5e_cross2 = l2_2_of_u2_3 * l2_2_lo, u5e_error = ksl_product_error(l2_2_of_u2_3, l2_2, u5e),
      u5e_lo1 = u5e_error + u5e_cross1, u5e_lo = u5e_lo1 + u5e_cross2, u5f = u5d - u5e,
      u5f_error = ksl_difference_error(u5d, u5e, u5f), u5f_lo1 = u5f_error + u5d_lo,
      u5f_lo = u5f_lo1 - u5e_lo, u5g = l3_1_of_u3_2 * l3_1, u5g_cross1 = l3_1_of_u3_2_lo * l3_1,
      u5g_cross2 = l3_1_of_u3_2 * l3_1_lo, u5g_error = ksl_product_error(l3_1_of_u3_2, l3_1, u5g),
      u5g_lo1 = u5g_error + u5g_cross1, u5g_lo = u5g_lo1 + u5g_cross2, u5h = u5f - u5g,
      u5h_error = ksl_difference_error(u5f, u5g, u5h), u5h_lo1 = u5h_error + u5f_lo,
      u5h_lo = u5h_lo1 - u5g_lo, u5i = l4_of_u4_1 * l4, u5i_cross1 = l4_of_u4_1_lo * l4,
      u5i_cross2 = l4_of_u4_1 * l4_lo, u5i_error = ksl_product_error(l4_of_u4_1, l4, u5i),
      u5i_lo1 = u5i_error + u5i_cross1, u5i_lo = u5i_lo1 + u5i_cross2, u5 = u5h - u5i,
      u5_error = ksl_difference_error(u5h, u5i, u5), u5_lo1 = u5_error + u5h_lo,
      u5_lo = u5_lo1 - u5i_lo;
  const double divisor5 = 0.0 < u5 ? u5 : 1.0, divisor5_lo = 0.0 < u5 ? u5_lo : 0.0;
  const double part0a = A->at[0][0] / divisor0, part0a_product = part0a * divisor0,
      part0a_product_error = ksl_product_error(part0a, divisor0, part0a_product),
      part0a_rest = A->at[0][0] - part0a_product, part0a_exact = part0a_rest - part0a_product_error,
      part0a_lo = part0a_exact / divisor0, part0 = 0.0 < A->at[0][0] ? part0a : A->at[0][0],
      part0_lo = 0.0 < A->at[0][0] ? part0a_lo : 0.0;
  const double own1 = 0.0 < A->at[1][1] ? A->at[1][1] : 1.0;
  const double part1a_of_u1_0 = u1_0 + u1_0_lo,
      part1a_of_u1_0_lo = ksl_sum_error(u1_0, u1_0_lo, part1a_of_u1_0),
      part1a = part1a_of_u1_0 / own1, part1a_product = part1a * own1,
      part1a_product_error = ksl_product_error(part1a, own1, part1a_product),
      part1a_rest = part1a_of_u1_0 - part1a_product,
      part1a_exact = part1a_rest - part1a_product_error,
      part1a_residual = part1a_exact + part1a_of_u1_0_lo, part1a_lo = part1a_residual / own1,
      part1 = 0.0 < A->at[1][1] ? part1a : A->at[1][1],
      part1_lo = 0.0 < A->at[1][1] ? part1a_lo : 0.0;
  const double smallest1 = part0 < part1 ? part0 : part1,
      smallest1_lo = part0 < part1 ? part0_lo : part1_lo;
  const double own2 = 0.0 < A->at[2][2] ? A->at[2][2] : 1.0;
  const double part2a_of_u2_0 = u2_0 + u2_0_lo,
      part2a_of_u2_0_lo = ksl_sum_error(u2_0, u2_0_lo, part2a_of_u2_0),
      part2a = part2a_of_u2_0 / own2, part2a_product = part2a * own2,
      part2a_product_error = ksl_product_error(part2a, own2, part2a_product),
      part2a_rest = part2a_of_u2_0 - part2a_product,
      part2a_exact = part2a_rest - part2a_product_error,
      part2a_residual = part2a_exact + part2a_of_u2_0_lo, part2a_lo = part2a_residual / own2,
      part2 = 0.0 < A->at[2][2] ? part2a : A->at[2][2],
      part2_lo = 0.0 < A->at[2][2] ? part2a_lo : 0.0;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2,
      smallest2_lo = smallest1 < part2 ? smallest1_lo : part2_lo;
  const double own3 = 0.0 < A->at[3][3] ? A->at[3][3] : 1.0;
  const double part3a_of_u3_0 = u3_0 + u3_0_lo,
      part3a_of_u3_0_lo = ksl_sum_error(u3_0, u3_0_lo, part3a_of_u3_0),
      part3a = part3a_of_u3_0 / own3, part3a_product = part3a * own3,
      part3a_product_error = ksl_product_error(part3a, own3, part3a_product),
      part3a_rest = part3a_of_u3_0 - part3a_product,
      part3a_exact = part3a_rest - part3a_product_error,
      part3a_residual = part3a_exact + part3a_of_u3_0_lo, part3a_lo = part3a_residual / own3,
      part3 = 0.0 < A->at[3][3] ? part3a : A->at[3][3],
      part3_lo = 0.0 < A->at[3][3] ? part3a_lo : 0.0;
  const double smallest3 = smallest2 < part3 ? smallest2 : part3,
      smallest3_lo = smallest2 < part3 ? smallest2_lo : part3_lo;
  const double own4 = 0.0 < A->at[4][4] ? A->at[4][4] : 1.0;
  const double part4a_of_u4_0 = u4_0 + u4_0_lo,
      part4a_of_u4_0_lo = ksl_sum_error(u4_0, u4_0_lo, part4a_of_u4_0),
      part4a = part4a_of_u4_0 / own4, part4a_product = part4a * own4,
      part4a_product_error = ksl_product_error(part4a, own4, part4a_product),
      part4a_rest = part4a_of_u4_0 - part4a_product,
      part4a_exact = part4a_rest - part4a_product_error,
      part4a_residual = part4a_exact + part4a_of_u4_0_lo, part4a_lo = part4a_residual / own4,
      part4 = 0.0 < A->at[4][4] ? part4a : A->at[4][4],
      part4_lo = 0.0 < A->at[4][4] ? part4a_lo : 0.0;
  const double smallest4 = smallest3 < part4 ? smallest3 : part4,
      smallest4_lo = smallest3 < part4 ? smallest3_lo : part4_lo;
  const double own5 = 0.0 < A->at[5][5] ? A->at[5][5] : 1.0;
  const double part5a_of_u5 = u5 + u5_lo, part5a_of_u5_lo = ksl_sum_error(u5, u5_lo, part5a_of_u5),
      part5a = part5a_of_u5 / own5, part5a_product = part5a * own5,
      part5a_product_error = ksl_product_error(part5a, own5, part5a_product),
      part5a_rest = part5a_of_u5 - part5a_product,
      part5a_exact = part5a_rest - part5a_product_error,
      part5a_residual = part5a_exact + part5a_of_u5_lo, part5a_lo = part5a_residual / own5,
      part5 = 0.0 < A->at[5][5] ? part5a : A->at[5][5],
      part5_lo = 0.0 < A->at[5][5] ? part5a_lo : 0.0;
  const double smallest5 = smallest4 < part5 ? smallest4 : part5,
      smallest5_lo = smallest4 < part5 ? smallest4_lo : part5_lo;
  const double y1a = b->m0 * l0_0, y1a_cross1 = b->m0 * l0_0_lo,
      y1a_error = ksl_product_error(b->m0, l0_0, y1a), y1a_lo = y1a_error + y1a_cross1,
      y1 = b->m1 - y1a, y1_error = ksl_difference_error(b->m1, y1a, y1), y1_lo = y1_error - y1a_lo;
  const double y2a = b->m0 * l0_1, y2a_cross1 = b->m0 * l0_1_lo,
      y2a_error = ksl_product_error(b->m0, l0_1, y2a), y2a_lo = y2a_error + y2a_cross1,
      y2b = b->m2 - y2a, y2b_error = ksl_difference_error(b->m2, y2a, y2b),
      y2b_lo = y2b_error - y2a_lo, y2c = l1_0 * y1, y2c_cross1 = l1_0_lo * y1,
      y2c_cross2 = l1_0 * y1_lo, y2c_error = ksl_product_error(l1_0, y1, y2c),
      y2c_lo1 = y2c_error + y2c_cross1, y2c_lo = y2c_lo1 + y2c_cross2, y2 = y2b - y2c,
      y2_error = ksl_difference_error(y2b, y2c, y2), y2_lo1 = y2_error + y2b_lo,
      y2_lo = y2_lo1 - y2c_lo;
  const double y3a = b->m0 * l0_2, y3a_cross1 = b->m0 * l0_2_lo,
      y3a_error = ksl_product_error(b->m0, l0_2, y3a), y3a_lo = y3a_error + y3a_cross1,
      y3b = b->m3 - y3a, y3b_error = ksl_difference_error(b->m3, y3a, y3b),
      y3b_lo = y3b_error - y3a_lo, y3c = l1_1 * y1, y3c_cross1 = l1_1_lo * y1,
      y3c_cross2 = l1_1 * y1_lo, y3c_error = ksl_product_error(l1_1, y1, y3c),
      y3c_lo1 = y3c_error + y3c_cross1, y3c_lo = y3c_lo1 + y3c_cross2, y3d = y3b - y3c,
      y3d_error = ksl_difference_error(y3b, y3c, y3d), y3d_lo1 = y3d_error + y3b_lo,
      y3d_lo = y3d_lo1 - y3c_lo, y3e = l2_0 * y2, y3e_cross1 = l2_0_lo * y2,
      y3e_cross2 = l2_0 * y2_lo, y3e_error = ksl_product_error(l2_0, y2, y3e),
      y3e_lo1 = y3e_error + y3e_cross1, y3e_lo = y3e_lo1 + y3e_cross2, y3 = y3d - y3e,
      y3_error = ksl_difference_error(y3d, y3e, y3), y3_lo1 = y3_error + y3d_lo,
      y3_lo = y3_lo1 - y3e_lo;
  const double y4a = b->m0 * l0_3, y4a_cross1 = b->m0 * l0_3_lo,
      y4a_error = ksl_product_error(b->m0, l0_3, y4a), y4a_lo = y4a_error + y4a_cross1,
      y4b = b->m4 - y4a, y4b_error = ksl_difference_error(b->m4, y4a, y4b),
      y4b_lo = y4b_error - y4a_lo, y4c = l1_2 * y1, y4c_cross1 = l1_2_lo * y1,
      y4c_cross2 = l1_2 * y1_lo, y4c_error = ksl_product_error(l1_2, y1, y4c),
      y4c_lo1 = y4c_error + y4c_cross1, y4c_lo = y4c_lo1 + y4c_cross2, y4d = y4b - y4c,
      y4d_error = ksl_difference_error(y4b, y4c, y4d), y4d_lo1 = y4d_error + y4b_lo,
      y4d_lo = y4d_lo1 - y4c_lo, y4e = l2_1 * y2, y4e_cross1 = l2_1_lo * y2,
      y4e_cross2 = l2_1 * y2_lo, y4e_error = ksl_product_error(l2_1, y2, y4e),
      y4e_lo1 = y4e_error + y4e_cross1, y4e_lo = y4e_lo1 + y4e_cross2, y4f = y4d - y4e,
      y4f_error = ksl_difference_error(y4d, y4e, y4f), y4f_lo1 = y4f_error + y4d_lo,
      y4f_lo = y4f_lo1 - y4e_lo, y4g = l3_0 * y3, y4g_cross1 = l3_0_lo * y3,
      y4g_cross2 = l3_0 * y3_lo, y4g_error = ksl_product_error(l3_0, y3, y4g),
      y4g_lo1 = y4g_error + y4g_cross1, y4g_lo = y4g_lo1 + y4g_cross2, y4 = y4f - y4g,
      y4_error = ksl_difference_error(y4f, y4g, y4), y4_lo1 = y4_error + y4f_lo,
      y4_lo = y4_lo1 - y4g_lo;
  const double y5a = b->m0 * l0_4, y5a_cross1 = b->m0 * l0_4_lo,
      y5a_error = ksl_product_error(b->m0, l0_4, y5a), y5a_lo = y5a_error + y5a_cross1,
      y5b = b->m5 - y5a, y5b_error = ksl_difference_error(b->m5, y5a, y5b),
      y5b_lo = y5b_error - y5a_lo, y5c = l1_3 * y1, y5c_cross1 = l1_3_lo * y1,
      y5c_cross2 = l1_3 * y1_lo, y5c_error = ksl_product_error(l1_3, y1, y5c),
      y5c_lo1 = y5c_error + y5c_cross1, y5c_lo = y5c_lo1 + y5c_cross2, y5d = y5b - y5c,
      y5d_error = ksl_difference_error(y5b, y5c, y5d), y5d_lo1 = y5d_error + y5b_lo,
      y5d_lo = y5d_lo1 - y5c_lo, y5e = l2_2 * y2, y5e_cross1 = l2_2_lo * y2,
      y5e_cross2 = l2_2 * y2_lo, y5e_error = ksl_product_error(l2_2, y2, y5e),
      y5e_lo1 = y5e_error + y5e_cross1, y5e_lo = y5e_lo1 + y5e_cross2, y5f = y5d - y5e,
      y5f_error = ksl_difference_error(y5d, y5e, y5f), y5f_lo1 = y5f_error + y5d_lo,
      y5f_lo = y5f_lo1 - y5e_lo, y5g = l3_1 * y3, y5g_cross1 = l3_1_lo * y3,
      y5g_cross2 = l3_1 * y3_lo, y5g_error = ksl_product_error(l3_1, y3, y5g),
      y5g_lo1 = y5g_error + y5g_cross1, y5g_lo = y5g_lo1 + y5g_cross2, y5h = y5f - y5g,
      y5h_error = ksl_difference_error(y5f, y5g, y5h), y5h_lo1 = y5h_error + y5f_lo,
      y5h_lo = y5h_lo1 - y5g_lo, y5i = l4 * y4, y5i_cross1 = l4_lo * y4, y5i_cross2 = l4 * y4_lo,
      y5i_error = ksl_product_error(l4, y4, y5i), y5i_lo1 = y5i_error + y5i_cross1,
      y5i_lo = y5i_lo1 + y5i_cross2, y5 = y5h - y5i, y5_error = ksl_difference_error(y5h, y5i, y5),
      y5_lo1 = y5_error + y5h_lo, y5_lo = y5_lo1 - y5i_lo;
  const double z0 = b->m0 / divisor0, z0_product = z0 * divisor0,
      z0_product_error = ksl_product_error(z0, divisor0, z0_product), z0_rest = b->m0 - z0_product,
      z0_exact = z0_rest - z0_product_error, z0_lo = z0_exact / divisor0;
  const double z1_of_y1 = y1 + y1_lo, z1_of_y1_lo = ksl_sum_error(y1, y1_lo, z1_of_y1),
      z1 = z1_of_y1 / l1_0_of_divisor1, z1_cross = z1 * l1_0_of_divisor1_lo,
      z1_product = z1 * l1_0_of_divisor1,
      z1_product_error = ksl_product_error(z1, l1_0_of_divisor1, z1_product),
      z1_rest = z1_of_y1 - z1_product, z1_exact = z1_rest - z1_product_error,
      z1_lo1 = z1_exact + z1_of_y1_lo, z1_residual = z1_lo1 - z1_cross,
      z1_lo = z1_residual / l1_0_of_divisor1;
  const double z2_of_y2 = y2 + y2_lo, z2_of_y2_lo = ksl_sum_error(y2, y2_lo, z2_of_y2),
      z2 = z2_of_y2 / l2_0_of_divisor2, z2_cross = z2 * l2_0_of_divisor2_lo,
      z2_product = z2 * l2_0_of_divisor2,
      z2_product_error = ksl_product_error(z2, l2_0_of_divisor2, z2_product),
      z2_rest = z2_of_y2 - z2_product, z2_exact = z2_rest - z2_product_error,
      z2_lo1 = z2_exact + z2_of_y2_lo, z2_residual = z2_lo1 - z2_cross,
      z2_lo = z2_residual / l2_0_of_divisor2;
  const double z3_of_y3 = y3 + y3_lo, z3_of_y3_lo = ksl_sum_error(y3, y3_lo, z3_of_y3),
      z3 = z3_of_y3 / l3_0_of_divisor3, z3_cross = z3 * l3_0_of_divisor3_lo,
      z3_product = z3 * l3_0_of_divisor3,
      z3_product_error = ksl_product_error(z3, l3_0_of_divisor3, z3_product),
      z3_rest = z3_of_y3 - z3_product, z3_exact = z3_rest - z3_product_error,
      z3_lo1 = z3_exact + z3_of_y3_lo, z3_residual = z3_lo1 - z3_cross,
      z3_lo = z3_residual / l3_0_of_divisor3;
  const double z4_of_y4 = y4 + y4_lo, z4_of_y4_lo = ksl_sum_error(y4, y4_lo, z4_of_y4),
      z4 = z4_of_y4 / l4_of_divisor4, z4_cross = z4 * l4_of_divisor4_lo,
      z4_product = z4 * l4_of_divisor4,
      z4_product_error = ksl_product_error(z4, l4_of_divisor4, z4_product),
      z4_rest = z4_of_y4 - z4_product, z4_exact = z4_rest - z4_product_error,
      z4_lo1 = z4_exact + z4_of_y4_lo, z4_residual = z4_lo1 - z4_cross,
      z4_lo = z4_residual / l4_of_divisor4;
  const double z5_of_y5 = y5 + y5_lo, z5_of_y5_lo = ksl_sum_error(y5, y5_lo, z5_of_y5),
      z5_of_divisor5 = divisor5 + divisor5_lo,
      z5_of_divisor5_lo = ksl_sum_error(divisor5, divisor5_lo, z5_of_divisor5),
      z5 = z5_of_y5 / z5_of_divisor5, z5_cross = z5 * z5_of_divisor5_lo,
      z5_product = z5 * z5_of_divisor5,
      z5_product_error = ksl_product_error(z5, z5_of_divisor5, z5_product),
      z5_rest = z5_of_y5 - z5_product, z5_exact = z5_rest - z5_product_error,
      z5_lo1 = z5_exact + z5_of_y5_lo, z5_residual = z5_lo1 - z5_cross,
      z5_lo = z5_residual / z5_of_divisor5;
  const double x4a = l4 * z5, x4a_cross1 = l4_lo * z5, x4a_cross2 = l4 * z5_lo,
      x4a_error = ksl_product_error(l4, z5, x4a), x4a_lo1 = x4a_error + x4a_cross1,
      x4a_lo = x4a_lo1 + x4a_cross2, x4 = z4 - x4a, x4_error = ksl_difference_error(z4, x4a, x4),
      x4_lo1 = x4_error + z4_lo, x4_lo = x4_lo1 - x4a_lo;
  const double x3a = l3_0 * x4, x3a_cross1 = l3_0_lo * x4, x3a_cross2 = l3_0 * x4_lo,
      x3a_error = ksl_product_error(l3_0, x4, x3a), x3a_lo1 = x3a_error + x3a_cross1,
      x3a_lo = x3a_lo1 + x3a_cross2, x3b = z3 - x3a, x3b_error = ksl_difference_error(z3, x3a, x3b),
      x3b_lo1 = x3b_error + z3_lo, x3b_lo = x3b_lo1 - x3a_lo, x3c = l3_1 * z5,
      x3c_cross1 = l3_1_lo * z5, x3c_cross2 = l3_1 * z5_lo,
      x3c_error = ksl_product_error(l3_1, z5, x3c), x3c_lo1 = x3c_error + x3c_cross1,
      x3c_lo = x3c_lo1 + x3c_cross2, x3 = x3b - x3c, x3_error = ksl_difference_error(x3b, x3c, x3),
      x3_lo1 = x3_error + x3b_lo, x3_lo = x3_lo1 - x3c_lo;
  const double x2a = l2_0 * x3, x2a_cross1 = l2_0_lo * x3, x2a_cross2 = l2_0 * x3_lo,
      x2a_error = ksl_product_error(l2_0, x3, x2a), x2a_lo1 = x2a_error + x2a_cross1,
      x2a_lo = x2a_lo1 + x2a_cross2, x2b = z2 - x2a, x2b_error = ksl_difference_error(z2, x2a, x2b),
      x2b_lo1 = x2b_error + z2_lo, x2b_lo = x2b_lo1 - x2a_lo, x2c = l2_1 * x4,
      x2c_cross1 = l2_1_lo * x4, x2c_cross2 = l2_1 * x4_lo,
      x2c_error = ksl_product_error(l2_1, x4, x2c), x2c_lo1 = x2c_error + x2c_cross1,
      x2c_lo = x2c_lo1 + x2c_cross2, x2d = x2b - x2c,
      x2d_error = ksl_difference_error(x2b, x2c, x2d), x2d_lo1 = x2d_error + x2b_lo,
      x2d_lo = x2d_lo1 - x2c_lo, x2e = l2_2 * z5, x2e_cross1 = l2_2_lo * z5,
      x2e_cross2 = l2_2 * z5_lo, x2e_error = ksl_product_error(l2_2, z5, x2e),
      x2e_lo1 = x2e_error + x2e_cross1, x2e_lo = x2e_lo1 + x2e_cross2, x2 = x2d - x2e,
      x2_error = ksl_difference_error(x2d, x2e, x2), x2_lo1 = x2_error + x2d_lo,
      x2_lo = x2_lo1 - x2e_lo;
  const double x1a = l1_0 * x2, x1a_cross1 = l1_0_lo * x2, x1a_cross2 = l1_0 * x2_lo,
      x1a_error = ksl_product_error(l1_0, x2, x1a), x1a_lo1 = x1a_error + x1a_cross1,
      x1a_lo = x1a_lo1 + x1a_cross2, x1b = z1 - x1a, x1b_error = ksl_difference_error(z1, x1a, x1b),
      x1b_lo1 = x1b_error + z1_lo, x1b_lo = x1b_lo1 - x1a_lo, x1c = l1_1 * x3,
      x1c_cross1 = l1_1_lo * x3, x1c_cross2 = l1_1 * x3_lo,
      x1c_error = ksl_product_error(l1_1, x3, x1c), x1c_lo1 = x1c_error + x1c_cross1,
      x1c_lo = x1c_lo1 + x1c_cross2, x1d = x1b - x1c,
      x1d_error = ksl_difference_error(x1b, x1c, x1d), x1d_lo1 = x1d_error + x1b_lo,
      x1d_lo = x1d_lo1 - x1c_lo, x1e = l1_2 * x4, x1e_cross1 = l1_2_lo * x4,
      x1e_cross2 = l1_2 * x4_lo, x1e_error = ksl_product_error(l1_2, x4, x1e),
      x1e_lo1 = x1e_error + x1e_cross1, x1e_lo = x1e_lo1 + x1e_cross2, x1f = x1d - x1e,
      x1f_error = ksl_difference_error(x1d, x1e, x1f), x1f_lo1 = x1f_error + x1d_lo,
      x1f_lo = x1f_lo1 - x1e_lo, x1g = l1_3 * z5, x1g_cross1 = l1_3_lo * z5,
      x1g_cross2 = l1_3 * z5_lo, x1g_error = ksl_product_error(l1_3, z5, x1g),
      x1g_lo1 = x1g_error + x1g_cross1, x1g_lo = x1g_lo1 + x1g_cross2, x1 = x1f - x1g,
      x1_error = ksl_difference_error(x1f, x1g, x1), x1_lo1 = x1_error + x1f_lo,
      x1_lo = x1_lo1 - x1g_lo;
  const double x0a = l0_0 * x1, x0a_cross1 = l0_0_lo * x1, x0a_cross2 = l0_0 * x1_lo,
      x0a_error = ksl_product_error(l0_0, x1, x0a), x0a_lo1 = x0a_error + x0a_cross1,
      x0a_lo = x0a_lo1 + x0a_cross2, x0b = z0 - x0a, x0b_error = ksl_difference_error(z0, x0a, x0b),
      x0b_lo1 = x0b_error + z0_lo, x0b_lo = x0b_lo1 - x0a_lo, x0c = l0_1 * x2,
      x0c_cross1 = l0_1_lo * x2, x0c_cross2 = l0_1 * x2_lo,
      x0c_error = ksl_product_error(l0_1, x2, x0c), x0c_lo1 = x0c_error + x0c_cross1,
      x0c_lo = x0c_lo1 + x0c_cross2, x0d = x0b - x0c,
      x0d_error = ksl_difference_error(x0b, x0c, x0d), x0d_lo1 = x0d_error + x0b_lo,
      x0d_lo = x0d_lo1 - x0c_lo, x0e = l0_2 * x3, x0e_cross1 = l0_2_lo * x3,
      x0e_cross2 = l0_2 * x3_lo, x0e_error = ksl_product_error(l0_2, x3, x0e),
      x0e_lo1 = x0e_error + x0e_cross1, x0e_lo = x0e_lo1 + x0e_cross2, x0f = x0d - x0e,
      x0f_error = ksl_difference_error(x0d, x0e, x0f), x0f_lo1 = x0f_error + x0d_lo,
      x0f_lo = x0f_lo1 - x0e_lo, x0g = l0_3 * x4, x0g_cross1 = l0_3_lo * x4,
      x0g_cross2 = l0_3 * x4_lo, x0g_error = ksl_product_error(l0_3, x4, x0g),
      x0g_lo1 = x0g_error + x0g_cross1, x0g_lo = x0g_lo1 + x0g_cross2, x0h = x0f - x0g,
      x0h_error = ksl_difference_error(x0f, x0g, x0h), x0h_lo1 = x0h_error + x0f_lo,
      x0h_lo = x0h_lo1 - x0g_lo, x0i = l0_4 * z5, x0i_cross1 = l0_4_lo * z5,
      x0i_cross2 = l0_4 * z5_lo, x0i_error = ksl_product_error(l0_4, z5, x0i),
      x0i_lo1 = x0i_error + x0i_cross1, x0i_lo = x0i_lo1 + x0i_cross2, x0 = x0h - x0i,
      x0_error = ksl_difference_error(x0h, x0i, x0), x0_lo1 = x0_error + x0h_lo,
      x0_lo = x0_lo1 - x0i_lo;
  const double residual_0a = A->at[0][0] * x0, residual_0a_cross1 = A->at[0][0] * x0_lo,
      residual_0a_error = ksl_product_error(A->at[0][0], x0, residual_0a),
      residual_0a_lo = residual_0a_error + residual_0a_cross1, residual_0b = b->m0 - residual_0a,
      residual_0b_error = ksl_difference_error(b->m0, residual_0a, residual_0b),
      residual_0b_lo = residual_0b_error - residual_0a_lo, residual_0c = A->at[0][1] * x1,
      residual_0c_cross1 = A->at[0][1] * x1_lo,
      residual_0c_error = ksl_product_error(A->at[0][1], x1, residual_0c),
      residual_0c_lo = residual_0c_error + residual_0c_cross1,
      residual_0d = residual_0b - residual_0c,
      residual_0d_error = ksl_difference_error(residual_0b, residual_0c, residual_0d),
      residual_0d_lo1 = residual_0d_error + residual_0b_lo,
      residual_0d_lo = residual_0d_lo1 - residual_0c_lo, residual_0e = A->at[0][2] * x2,
      residual_0e_cross1 = A->at[0][2] * x2_lo,
      residual_0e_error = ksl_product_error(A->at[0][2], x2, residual_0e),
      residual_0e_lo = residual_0e_error + residual_0e_cross1,
      residual_0f = residual_0d - residual_0e,
      residual_0f_error = ksl_difference_error(residual_0d, residual_0e, residual_0f),
      residual_0f_lo1 = residual_0f_error + residual_0d_lo,
      residual_0f_lo = residual_0f_lo1 - residual_0e_lo, residual_0g = A->at[0][3] * x3,
      residual_0g_cross1 = A->at[0][3] * x3_lo,
      residual_0g_error = ksl_product_error(A->at[0][3], x3, residual_0g),
      residual_0g_lo = residual_0g_error + residual_0g_cross1,
      residual_0h = residual_0f - residual_0g,
      residual_0h_error = ksl_difference_error(residual_0f, residual_0g, residual_0h),
      residual_0h_lo1 = residual_0h_error + residual_0f_lo,
      residual_0h_lo = residual_0h_lo1 - residual_0g_lo, residual_0i = A->at[0][4] * x4,
      residual_0i_cross1 = A->at[0][4] * x4_lo,
      residual_0i_error = ksl_product_error(A->at[0][4], x4, residual_0i),
      residual_0i_lo = residual_0i_error + residual_0i_cross1,
      residual_0j = residual_0h - residual_0i,
      residual_0j_error = ksl_difference_error(residual_0h, residual_0i, residual_0j),
      residual_0j_lo1 = residual_0j_error + residual_0h_lo,
      residual_0j_lo = residual_0j_lo1 - residual_0i_lo, residual_0k = A->at[0][5] * z5,
      residual_0k_cross1 = A->at[0][5] * z5_lo,
      residual_0k_error = ksl_product_error(A->at[0][5], z5, residual_0k),
      residual_0k_lo = residual_0k_error + residual_0k_cross1,
      residual_0 = residual_0j - residual_0k,
      residual_0_error = ksl_difference_error(residual_0j, residual_0k, residual_0),
      residual_0_lo1 = residual_0_error + residual_0j_lo,
      residual_0_lo = residual_0_lo1 - residual_0k_lo;
  const double residual_1a = A->at[0][1] * x0, residual_1a_cross1 = A->at[0][1] * x0_lo,
      residual_1a_error = ksl_product_error(A->at[0][1], x0, residual_1a),
      residual_1a_lo = residual_1a_error + residual_1a_cross1, residual_1b = b->m1 - residual_1a,
      residual_1b_error = ksl_difference_error(b->m1, residual_1a, residual_1b),
      residual_1b_lo = residual_1b_error - residual_1a_lo, residual_1c = A->at[1][1] * x1,
      residual_1c_cross1 = A->at[1][1] * x1_lo,
      residual_1c_error = ksl_product_error(A->at[1][1], x1, residual_1c),
      residual_1c_lo = residual_1c_error + residual_1c_cross1,
      residual_1d = residual_1b - residual_1c,
      residual_1d_error = ksl_difference_error(residual_1b, residual_1c, residual_1d),
      residual_1d_lo1 = residual_1d_error + residual_1b_lo,
      residual_1d_lo = residual_1d_lo1 - residual_1c_lo, residual_1e = A->at[1][2] * x2,
      residual_1e_cross1 = A->at[1][2] * x2_lo,
      residual_1e_error = ksl_product_error(A->at[1][2], x2, residual_1e),
      residual_1e_lo = residual_1e_error + residual_1e_cross1,
      residual_1f = residual_1d - residual_1e,
      residual_1f_error = ksl_difference_error(residual_1d, residual_1e, residual_1f),
      residual_1f_lo1 = residual_1f_error + residual_1d_lo,
      residual_1f_lo = residual_1f_lo1 - residual_1e_lo, residual_1g = A->at[1][3] * x3,
      residual_1g_cross1 = A->at[1][3] * x3_lo,
      residual_1g_error = ksl_product_error(A->at[1][3], x3, residual_1g),
      residual_1g_lo = residual_1g_error + residual_1g_cross1,
      residual_1h = residual_1f - residual_1g,
      residual_1h_error = ksl_difference_error(residual_1f, residual_1g, residual_1h),
      residual_1h_lo1 = residual_1h_error + residual_1f_lo,
      residual_1h_lo = residual_1h_lo1 - residual_1g_lo, residual_1i = A->at[1][4] * x4,
      residual_1i_cross1 = A->at[1][4] * x4_lo,
      residual_1i_error = ksl_product_error(A->at[1][4], x4, residual_1i),
      residual_1i_lo = residual_1i_error + residual_1i_cross1,
      residual_1j = residual_1h - residual_1i,
      residual_1j_error = ksl_difference_error(residual_1h, residual_1i, residual_1j),
      residual_1j_lo1 = residual_1j_error + residual_1h_lo,
      residual_1j_lo = residual_1j_lo1 - residual_1i_lo, residual_1k = A->at[1][5] * z5,
      residual_1k_cross1 = A->at[1][5] * z5_lo,
      residual_1k_error = ksl_product_error(A->at[1][5], z5, residual_1k),
      residual_1k_lo = residual_1k_error + residual_1k_cross1,
      residual_1 = residual_1j - residual_1k,
      residual_1_error = ksl_difference_error(residual_1j, residual_1k, residual_1),
      residual_1_lo1 = residual_1_error + residual_1j_lo,
      residual_1_lo = residual_1_lo1 - residual_1k_lo;
  const double residual_2a = A->at[0][2] * x0, residual_2a_cross1 = A->at[0][2] * x0_lo,
      residual_2a_error = ksl_product_error(A->at[0][2], x0, residual_2a),
      residual_2a_lo = residual_2a_error + residual_2a_cross1, residual_2b = b->m2 - residual_2a,
      residual_2b_error = ksl_difference_error(b->m2, residual_2a, residual_2b),
      residual_2b_lo = residual_2b_error - residual_2a_lo, residual_2c = A->at[1][2] * x1,
      residual_2c_cross1 = A->at[1][2] * x1_lo,
      residual_2c_error = ksl_product_error(A->at[1][2], x1, residual_2c),
      residual_2c_lo = residual_2c_error + residual_2c_cross1,
      residual_2d = residual_2b - residual_2c,
      residual_2d_error = ksl_difference_error(residual_2b, residual_2c, residual_2d),
      residual_2d_lo1 = residual_2d_error + residual_2b_lo,
      residual_2d_lo = residual_2d_lo1 - residual_2c_lo, residual_2e = A->at[2][2] * x2,
      residual_2e_cross1 = A->at[2][2] * x2_lo,
      residual_2e_error = ksl_product_error(A->at[2][2], x2, residual_2e),
      residual_2e_lo = residual_2e_error + residual_2e_cross1,
      residual_2f = residual_2d - residual_2e,
      residual_2f_error = ksl_difference_error(residual_2d, residual_2e, residual_2f),
      residual_2f_lo1 = residual_2f_error + residual_2d_lo,
      residual_2f_lo = residual_2f_lo1 - residual_2e_lo, residual_2g = A->at[2][3] * x3,
      residual_2g_cross1 = A->at[2][3] * x3_lo,
      residual_2g_error = ksl_product_error(A->at[2][3], x3, residual_2g),
      residual_2g_lo = residual_2g_error + residual_2g_cross1,
      residual_2h = residual_2f - residual_2g,
      residual_2h_error = ksl_difference_error(residual_2f, residual_2g, residual_2h),
      residual_2h_lo1 = residual_2h_error + residual_2f_lo,
      residual_2h_lo = residual_2h_lo1 - residual_2g_lo, residual_2i = A->at[2][4] * x4,
      residual_2i_cross1 = A->at[2][4] * x4_lo,
      residual_2i_error = ksl_product_error(A->at[2][4], x4, residual_2i),
      residual_2i_lo = residual_2i_error + residual_2i_cross1,
      residual_2j = residual_2h - residual_2i,
      residual_2j_error = ksl_difference_error(residual_2h, residual_2i, residual_2j),
      residual_2j_lo1 = residual_2j_error + residual_2h_lo,
      residual_2j_lo = residual_2j_lo1 - residual_2i_lo, residual_2k = A->at[2][5] * z5,
      residual_2k_cross1 = A->at[2][5] * z5_lo,
      residual_2k_error = ksl_product_error(A->at[2][5], z5, residual_2k),
      residual_2k_lo = residual_2k_error + residual_2k_cross1,
      residual_2 = residual_2j - residual_2k,
      residual_2_error = ksl_difference_error(residual_2j, residual_2k, residual_2),
      residual_2_lo1 = residual_2_error + residual_2j_lo,
      residual_2_lo = residual_2_lo1 - residual_2k_lo;
  const double residual_3a = A->at[0][3] * x0, residual_3a_cross1 = A->at[0][3] * x0_lo,
      residual_3a_error = ksl_product_error(A->at[0][3], x0, residual_3a),
      residual_3a_lo = residual_3a_error + residual_3a_cross1, residual_3b = b->m3 - residual_3a,
      residual_3b_error = ksl_difference_error(b->m3, residual_3a, residual_3b),
      residual_3b_lo = residual_3b_error - residual_3a_lo, residual_3c = A->at[1][3] * x1,
      residual_3c_cross1 = A->at[1][3] * x1_lo,
      residual_3c_error = ksl_product_error(A->at[1][3], x1, residual_3c),
      residual_3c_lo = residual_3c_error + residual_3c_cross1,
      residual_3d = residual_3b - residual_3c,
      residual_3d_error = ksl_difference_error(residual_3b, residual_3c, residual_3d),
      residual_3d_lo1 = residual_3d_error + residual_3b_lo,
      residual_3d_lo = residual_3d_lo1 - residual_3c_lo, residual_3e = A->at[2][3] * x2,
      residual_3e_cross1 = A->at[2][3] * x2_lo,
      residual_3e_error = ksl_product_error(A->at[2][3], x2, residual_3e),
      residual_3e_lo = residual_3e_error + residual_3e_cross1,
      residual_3f = residual_3d - residual_3e,
      residual_3f_error = ksl_difference_error(residual_3d, residual_3e, residual_3f),
      residual_3f_lo1 = residual_3f_error + residual_3d_lo,
      residual_3f_lo = residual_3f_lo1 - residual_3e_lo, residual_3g = A->at[3][3] * x3,
      residual_3g_cross1 = A->at[3][3] * x3_lo,
      residual_3g_error = ksl_product_error(A->at[3][3], x3, residual_3g),
      residual_3g_lo = residual_3g_error + residual_3g_cross1,
      residual_3h = residual_3f - residual_3g,
      residual_3h_error = ksl_difference_error(residual_3f, residual_3g, residual_3h),
      residual_3h_lo1 = residual_3h_error + residual_3f_lo,
      residual_3h_lo = residual_3h_lo1 - residual_3g_lo, residual_3i = A->at[3][4] * x4,
      residual_3i_cross1 = A->at[3][4] * x4_lo,
      residual_3i_error = ksl_product_error(A->at[3][4], x4, residual_3i),
      residual_3i_lo = residual_3i_error + residual_3i_cross1,
      residual_3j = residual_3h - residual_3i,
      residual_3j_error = ksl_difference_error(residual_3h, residual_3i, residual_3j),
      residual_3j_lo1 = residual_3j_error + residual_3h_lo,
      residual_3j_lo = residual_3j_lo1 - residual_3i_lo, residual_3k = A->at[3][5] * z5,
      residual_3k_cross1 = A->at[3][5] * z5_lo,
      residual_3k_error = ksl_product_error(A->at[3][5], z5, residual_3k),
      residual_3k_lo = residual_3k_error + residual_3k_cross1,
      residual_3 = residual_3j - residual_3k,
      residual_3_error = ksl_difference_error(residual_3j, residual_3k, residual_3),
      residual_3_lo1 = residual_3_error + residual_3j_lo,
      residual_3_lo = residual_3_lo1 - residual_3k_lo;
  const double residual_4a = A->at[0][4] * x0, residual_4a_cross1 = A->at[0][4] * x0_lo,
      residual_4a_error = ksl_product_error(A->at[0][4], x0, residual_4a),
      residual_4a_lo = residual_4a_error + residual_4a_cross1, residual_4b = b->m4 - residual_4a,
      residual_4b_error = ksl_difference_error(b->m4, residual_4a, residual_4b),
      residual_4b_lo = residual_4b_error - residual_4a_lo, residual_4c = A->at[1][4] * x1,
      residual_4c_cross1 = A->at[1][4] * x1_lo,
      residual_4c_error = ksl_product_error(A->at[1][4], x1, residual_4c),
      residual_4c_lo = residual_4c_error + residual_4c_cross1,
      residual_4d = residual_4b - residual_4c,
      residual_4d_error = ksl_difference_error(residual_4b, residual_4c, residual_4d),
      residual_4d_lo1 = residual_4d_error + residual_4b_lo,
      residual_4d_lo = residual_4d_lo1 - residual_4c_lo, residual_4e = A->at[2][4] * x2,
      residual_4e_cross1 = A->at[2][4] * x2_lo,
      residual_4e_error = ksl_product_error(A->at[2][4], x2, residual_4e),
      residual_4e_lo = residual_4e_error + residual_4e_cross1,
      residual_4f = residual_4d - residual_4e,
      residual_4f_error = ksl_difference_error(residual_4d, residual_4e, residual_4f),
      residual_4f_lo1 = residual_4f_error + residual_4d_lo,
      residual_4f_lo = residual_4f_lo1 - residual_4e_lo, residual_4g = A->at[3][4] * x3,
      residual_4g_cross1 = A->at[3][4] * x3_lo,
      residual_4g_error = ksl_product_error(A->at[3][4], x3, residual_4g),
      residual_4g_lo = residual_4g_error + residual_4g_cross1,
      residual_4h = residual_4f - residual_4g,
      residual_4h_error = ksl_difference_error(residual_4f, residual_4g, residual_4h),
      residual_4h_lo1 = residual_4h_error + residual_4f_lo,
      residual_4h_lo = residual_4h_lo1 - residual_4g_lo, residual_4i = A->at[4][4] * x4,
      residual_4i_cross1 = A->at[4][4] * x4_lo,
      residual_4i_error = ksl_product_error(A->at[4][4], x4, residual_4i),
      residual_4i_lo = residual_4i_error + residual_4i_cross1,
      residual_4j = residual_4h - residual_4i,
      residual_4j_error = ksl_difference_error(residual_4h, residual_4i, residual_4j),
      residual_4j_lo1 = residual_4j_error + residual_4h_lo,
      residual_4j_lo = residual_4j_lo1 - residual_4i_lo, residual_4k = A->at[4][5] * z5,
      residual_4k_cross1 = A->at[4][5] * z5_lo,
      residual_4k_error = ksl_product_error(A->at[4][5], z5, residual_4k),
      residual_4k_lo = residual_4k_error + residual_4k_cross1,
      residual_4 = residual_4j - residual_4k,
      residual_4_error = ksl_difference_error(residual_4j, residual_4k, residual_4),
      residual_4_lo1 = residual_4_error + residual_4j_lo,
      residual_4_lo = residual_4_lo1 - residual_4k_lo;
  const double residual_5a = A->at[0][5] * x0, residual_5a_cross1 = A->at[0][5] * x0_lo,
      residual_5a_error = ksl_product_error(A->at[0][5], x0, residual_5a),
      residual_5a_lo = residual_5a_error + residual_5a_cross1, residual_5b = b->m5 - residual_5a,
      residual_5b_error = ksl_difference_error(b->m5, residual_5a, residual_5b),
      residual_5b_lo = residual_5b_error - residual_5a_lo, residual_5c = A->at[1][5] * x1,
      residual_5c_cross1 = A->at[1][5] * x1_lo,
      residual_5c_error = ksl_product_error(A->at[1][5], x1, residual_5c),
      residual_5c_lo = residual_5c_error + residual_5c_cross1,
      residual_5d = residual_5b - residual_5c,
      residual_5d_error = ksl_difference_error(residual_5b, residual_5c, residual_5d),
      residual_5d_lo1 = residual_5d_error + residual_5b_lo,
      residual_5d_lo = residual_5d_lo1 - residual_5c_lo, residual_5e = A->at[2][5] * x2,
      residual_5e_cross1 = A->at[2][5] * x2_lo,
      residual_5e_error = ksl_product_error(A->at[2][5], x2, residual_5e),
      residual_5e_lo = residual_5e_error + residual_5e_cross1,
      residual_5f = residual_5d - residual_5e,
      residual_5f_error = ksl_difference_error(residual_5d, residual_5e, residual_5f),
      residual_5f_lo1 = residual_5f_error + residual_5d_lo,
      residual_5f_lo = residual_5f_lo1 - residual_5e_lo, residual_5g = A->at[3][5] * x3,
      residual_5g_cross1 = A->at[3][5] * x3_lo,
      residual_5g_error = ksl_product_error(A->at[3][5], x3, residual_5g),
      residual_5g_lo = residual_5g_error + residual_5g_cross1,
      residual_5h = residual_5f - residual_5g,
      residual_5h_error = ksl_difference_error(residual_5f, residual_5g, residual_5h),
      residual_5h_lo1 = residual_5h_error + residual_5f_lo,
      residual_5h_lo = residual_5h_lo1 - residual_5g_lo, residual_5i = A->at[4][5] * x4,
      residual_5i_cross1 = A->at[4][5] * x4_lo,
      residual_5i_error = ksl_product_error(A->at[4][5], x4, residual_5i),
      residual_5i_lo = residual_5i_error + residual_5i_cross1,
      residual_5j = residual_5h - residual_5i,
      residual_5j_error = ksl_difference_error(residual_5h, residual_5i, residual_5j),
      residual_5j_lo1 = residual_5j_error + residual_5h_lo,
      residual_5j_lo = residual_5j_lo1 - residual_5i_lo, residual_5k = A->at[5][5] * z5,
      residual_5k_cross1 = A->at[5][5] * z5_lo,
      residual_5k_error = ksl_product_error(A->at[5][5], z5, residual_5k),
      residual_5k_lo = residual_5k_error + residual_5k_cross1,
      residual_5 = residual_5j - residual_5k,
      residual_5_error = ksl_difference_error(residual_5j, residual_5k, residual_5),
      residual_5_lo1 = residual_5_error + residual_5j_lo,
      residual_5_lo = residual_5_lo1 - residual_5k_lo;
  const double refined_y1a = l0_0 * residual_0, refined_y1a_cross1 = l0_0_lo * residual_0,
      refined_y1a_cross2 = l0_0 * residual_0_lo,
      refined_y1a_error = ksl_product_error(l0_0, residual_0, refined_y1a),
      refined_y1a_lo1 = refined_y1a_error + refined_y1a_cross1,
      refined_y1a_lo = refined_y1a_lo1 + refined_y1a_cross2, refined_y1 = residual_1 - refined_y1a,
      refined_y1_error = ksl_difference_error(residual_1, refined_y1a, refined_y1),
      refined_y1_lo1 = refined_y1_error + residual_1_lo,
      refined_y1_lo = refined_y1_lo1 - refined_y1a_lo;
  const double refined_y2a = l0_1 * residual_0, refined_y2a_cross1 = l0_1_lo * residual_0,
      refined_y2a_cross2 = l0_1 * residual_0_lo,
      refined_y2a_error = ksl_product_error(l0_1, residual_0, refined_y2a),
      refined_y2a_lo1 = refined_y2a_error + refined_y2a_cross1,
      refined_y2a_lo = refined_y2a_lo1 + refined_y2a_cross2, refined_y2b = residual_2 - refined_y2a,
      refined_y2b_error = ksl_difference_error(residual_2, refined_y2a, refined_y2b),
      refined_y2b_lo1 = refined_y2b_error + residual_2_lo,
      refined_y2b_lo = refined_y2b_lo1 - refined_y2a_lo, refined_y2c = l1_0 * refined_y1,
      refined_y2c_cross1 = l1_0_lo * refined_y1, refined_y2c_cross2 = l1_0 * refined_y1_lo,
      refined_y2c_error = ksl_product_error(l1_0, refined_y1, refined_y2c),
      refined_y2c_lo1 = refined_y2c_error + refined_y2c_cross1,
      refined_y2c_lo = refined_y2c_lo1 + refined_y2c_cross2, refined_y2 = refined_y2b - refined_y2c,
      refined_y2_error = ksl_difference_error(refined_y2b, refined_y2c, refined_y2),
      refined_y2_lo1 = refined_y2_error + refined_y2b_lo,
      refined_y2_lo = refined_y2_lo1 - refined_y2c_lo;
  const double refined_y3a = l0_2 * residual_0, refined_y3a_cross1 = l0_2_lo * residual_0,
      refined_y3a_cross2 = l0_2 * residual_0_lo,
      refined_y3a_error = ksl_product_error(l0_2, residual_0, refined_y3a),
      refined_y3a_lo1 = refined_y3a_error + refined_y3a_cross1,
      refined_y3a_lo = refined_y3a_lo1 + refined_y3a_cross2, refined_y3b = residual_3 - refined_y3a,
      refined_y3b_error = ksl_difference_error(residual_3, refined_y3a, refined_y3b),
      refined_y3b_lo1 = refined_y3b_error + residual_3_lo,
      refined_y3b_lo = refined_y3b_lo1 - refined_y3a_lo, refined_y3c = l1_1 * refined_y1,
      refined_y3c_cross1 = l1_1_lo * refined_y1, refined_y3c_cross2 = l1_1 * refined_y1_lo,
      refined_y3c_error = ksl_product_error(l1_1, refined_y1, refined_y3c),
      refined_y3c_lo1 = refined_y3c_error + refined_y3c_cross1,
      refined_y3c_lo = refined_y3c_lo1 + refined_y3c_cross2,
      refined_y3d = refined_y3b - refined_y3c,
      refined_y3d_error = ksl_difference_error(refined_y3b, refined_y3c, refined_y3d),
      refined_y3d_lo1 = refined_y3d_error + refined_y3b_lo,
      refined_y3d_lo = refined_y3d_lo1 - refined_y3c_lo, refined_y3e = l2_0 * refined_y2,
      refined_y3e_cross1 = l2_0_lo * refined_y2, refined_y3e_cross2 = l2_0 * refined_y2_lo,
      refined_y3e_error = ksl_product_error(l2_0, refined_y2, refined_y3e),
      refined_y3e_lo1 = refined_y3e_error + refined_y3e_cross1,
      refined_y3e_lo = refined_y3e_lo1 + refined_y3e_cross2, refined_y3 = refined_y3d - refined_y3e,
      refined_y3_error = ksl_difference_error(refined_y3d, refined_y3e, refined_y3),
      refined_y3_lo1 = refined_y3_error + refined_y3d_lo,
      refined_y3_lo = refined_y3_lo1 - refined_y3e_lo;
  const double refined_y4a = l0_3 * residual_0, refined_y4a_cross1 = l0_3_lo * residual_0,
      refined_y4a_cross2 = l0_3 * residual_0_lo,
      refined_y4a_error = ksl_product_error(l0_3, residual_0, refined_y4a),
      refined_y4a_lo1 = refined_y4a_error + refined_y4a_cross1,
      refined_y4a_lo = refined_y4a_lo1 + refined_y4a_cross2, refined_y4b = residual_4 - refined_y4a,
      refined_y4b_error = ksl_difference_error(residual_4, refined_y4a, refined_y4b),
      refined_y4b_lo1 = refined_y4b_error + residual_4_lo,
      refined_y4b_lo = refined_y4b_lo1 - refined_y4a_lo, refined_y4c = l1_2 * refined_y1,
      refined_y4c_cross1 = l1_2_lo * refined_y1, refined_y4c_cross2 = l1_2 * refined_y1_lo,
      refined_y4c_error = ksl_product_error(l1_2, refined_y1, refined_y4c),
      refined_y4c_lo1 = refined_y4c_error + refined_y4c_cross1,
      refined_y4c_lo = refined_y4c_lo1 + refined_y4c_cross2,
      refined_y4d = refined_y4b - refined_y4c,
      refined_y4d_error = ksl_difference_error(refined_y4b, refined_y4c, refined_y4d),
      refined_y4d_lo1 = refined_y4d_error + refined_y4b_lo,
      refined_y4d_lo = refined_y4d_lo1 - refined_y4c_lo, refined_y4e = l2_1 * refined_y2,
      refined_y4e_cross1 = l2_1_lo * refined_y2, refined_y4e_cross2 = l2_1 * refined_y2_lo,
      refined_y4e_error = ksl_product_error(l2_1, refined_y2, refined_y4e),
      refined_y4e_lo1 = refined_y4e_error + refined_y4e_cross1,
      refined_y4e_lo = refined_y4e_lo1 + refined_y4e_cross2,
      refined_y4f = refined_y4d - refined_y4e,
      refined_y4f_error = ksl_difference_error(refined_y4d, refined_y4e, refined_y4f),
      refined_y4f_lo1 = refined_y4f_error + refined_y4d_lo,
      refined_y4f_lo = refined_y4f_lo1 - refined_y4e_lo, refined_y4g = l3_0 * refined_y3,
      refined_y4g_cross1 = l3_0_lo * refined_y3, refined_y4g_cross2 = l3_0 * refined_y3_lo,
      refined_y4g_error = ksl_product_error(l3_0, refined_y3, refined_y4g),
      refined_y4g_lo1 = refined_y4g_error + refined_y4g_cross1,
      refined_y4g_lo = refined_y4g_lo1 + refined_y4g_cross2, refined_y4 = refined_y4f - refined_y4g,
      refined_y4_error = ksl_difference_error(refined_y4f, refined_y4g, refined_y4),
      refined_y4_lo1 = refined_y4_error + refined_y4f_lo,
      refined_y4_lo = refined_y4_lo1 - refined_y4g_lo;
  const double refined_y5a = l0_4 * residual_0, refined_y5a_cross1 = l0_4_lo * residual_0,
      refined_y5a_cross2 = l0_4 * residual_0_lo,
      refined_y5a_error = ksl_product_error(l0_4, residual_0, refined_y5a),
      refined_y5a_lo1 = refined_y5a_error + refined_y5a_cross1,
      refined_y5a_lo = refined_y5a_lo1 + refined_y5a_cross2, refined_y5b = residual_5 - refined_y5a,
      refined_y5b_error = ksl_difference_error(residual_5, refined_y5a, refined_y5b),
      refined_y5b_lo1 = refined_y5b_error + residual_5_lo,
      refined_y5b_lo = refined_y5b_lo1 - refined_y5a_lo, refined_y5c = l1_3 * refined_y1,
      refined_y5c_cross1 = l1_3_lo * refined_y1, refined_y5c_cross2 = l1_3 * refined_y1_lo,
      refined_y5c_error = ksl_product_error(l1_3, refined_y1, refined_y5c),
      refined_y5c_lo1 = refined_y5c_error + refined_y5c_cross1,
      refined_y5c_lo = refined_y5c_lo1 + refined_y5c_cross2,
      refined_y5d = refined_y5b - refined_y5c,
      refined_y5d_error = ksl_difference_error(refined_y5b, refined_y5c, refined_y5d),
      refined_y5d_lo1 = refined_y5d_error + refined_y5b_lo,
      refined_y5d_lo = refined_y5d_lo1 - refined_y5c_lo, refined_y5e = l2_2 * refined_y2,
      refined_y5e_cross1 = l2_2_lo * refined_y2, refined_y5e_cross2 = l2_2 * refined_y2_lo,
      refined_y5e_error = ksl_product_error(l2_2, refined_y2, refined_y5e),
      refined_y5e_lo1 = refined_y5e_error + refined_y5e_cross1,
      refined_y5e_lo = refined_y5e_lo1 + refined_y5e_cross2,
      refined_y5f = refined_y5d - refined_y5e,
      refined_y5f_error = ksl_difference_error(refined_y5d, refined_y5e, refined_y5f),
      refined_y5f_lo1 = refined_y5f_error + refined_y5d_lo,
      refined_y5f_lo = refined_y5f_lo1 - refined_y5e_lo, refined_y5g = l3_1 * refined_y3,
      refined_y5g_cross1 = l3_1_lo * refined_y3, refined_y5g_cross2 = l3_1 * refined_y3_lo,
      refined_y5g_error = ksl_product_error(l3_1, refined_y3, refined_y5g),
      refined_y5g_lo1 = refined_y5g_error + refined_y5g_cross1,
      refined_y5g_lo = refined_y5g_lo1 + refined_y5g_cross2,
      refined_y5h = refined_y5f - refined_y5g,
      refined_y5h_error = ksl_difference_error(refined_y5f, refined_y5g, refined_y5h),
      refined_y5h_lo1 = refined_y5h_error + refined_y5f_lo,
      refined_y5h_lo = refined_y5h_lo1 - refined_y5g_lo, refined_y5i = l4 * refined_y4,
      refined_y5i_cross1 = l4_lo * refined_y4, refined_y5i_cross2 = l4 * refined_y4_lo,
      refined_y5i_error = ksl_product_error(l4, refined_y4, refined_y5i),
      refined_y5i_lo1 = refined_y5i_error + refined_y5i_cross1,
      refined_y5i_lo = refined_y5i_lo1 + refined_y5i_cross2, refined_y5 = refined_y5h - refined_y5i,
      refined_y5_error = ksl_difference_error(refined_y5h, refined_y5i, refined_y5),
      refined_y5_lo1 = refined_y5_error + refined_y5h_lo,
      refined_y5_lo = refined_y5_lo1 - refined_y5i_lo;
  const double refined_z0_of_residual_0 = residual_0 + residual_0_lo,
      refined_z0_of_residual_0_lo = ksl_sum_error(residual_0, residual_0_lo, refined_z0_of_residual_0),
      refined_z0 = refined_z0_of_residual_0 / divisor0, refined_z0_product = refined_z0 * divisor0,
      refined_z0_product_error = ksl_product_error(refined_z0, divisor0, refined_z0_product),
      refined_z0_rest = refined_z0_of_residual_0 - refined_z0_product,
      refined_z0_exact = refined_z0_rest - refined_z0_product_error,
      refined_z0_residual = refined_z0_exact + refined_z0_of_residual_0_lo,
      refined_z0_lo = refined_z0_residual / divisor0;
  const double refined_z1_of_refined_y1 = refined_y1 + refined_y1_lo,
      refined_z1_of_refined_y1_lo = ksl_sum_error(refined_y1, refined_y1_lo, refined_z1_of_refined_y1),
      refined_z1 = refined_z1_of_refined_y1 / l1_0_of_divisor1,
      refined_z1_cross = refined_z1 * l1_0_of_divisor1_lo,
      refined_z1_product = refined_z1 * l1_0_of_divisor1,
      refined_z1_product_error = ksl_product_error(refined_z1, l1_0_of_divisor1, refined_z1_product),
      refined_z1_rest = refined_z1_of_refined_y1 - refined_z1_product,
      refined_z1_exact = refined_z1_rest - refined_z1_product_error,
      refined_z1_lo1 = refined_z1_exact + refined_z1_of_refined_y1_lo,
      refined_z1_residual = refined_z1_lo1 - refined_z1_cross,
      refined_z1_lo = refined_z1_residual / l1_0_of_divisor1;
  const double refined_z2_of_refined_y2 = refined_y2 + refined_y2_lo,
      refined_z2_of_refined_y2_lo = ksl_sum_error(refined_y2, refined_y2_lo, refined_z2_of_refined_y2),
      refined_z2 = refined_z2_of_refined_y2 / l2_0_of_divisor2,
      refined_z2_cross = refined_z2 * l2_0_of_divisor2_lo,
      refined_z2_product = refined_z2 * l2_0_of_divisor2,
      refined_z2_product_error = ksl_product_error(refined_z2, l2_0_of_divisor2, refined_z2_product),
      refined_z2_rest = refined_z2_of_refined_y2 - refined_z2_product,
      refined_z2_exact = refined_z2_rest - refined_z2_product_error,
      refined_z2_lo1 = refined_z2_exact + refined_z2_of_refined_y2_lo,
      refined_z2_residual = refined_z2_lo1 - refined_z2_cross,
      refined_z2_lo = refined_z2_residual / l2_0_of_divisor2;
  const double refined_z3_of_refined_y3 = refined_y3 + refined_y3_lo,
      refined_z3_of_refined_y3_lo = ksl_sum_error(refined_y3, refined_y3_lo, refined_z3_of_refined_y3),
      refined_z3 = refined_z3_of_refined_y3 / l3_0_of_divisor3,
      refined_z3_cross = refined_z3 * l3_0_of_divisor3_lo,
      refined_z3_product = refined_z3 * l3_0_of_divisor3,
      refined_z3_product_error = ksl_product_error(refined_z3, l3_0_of_divisor3, refined_z3_product),
      refined_z3_rest = refined_z3_of_refined_y3 - refined_z3_product,
      refined_z3_exact = refined_z3_rest - refined_z3_product_error,
      refined_z3_lo1 = refined_z3_exact + refined_z3_of_refined_y3_lo,
      refined_z3_residual = refined_z3_lo1 - refined_z3_cross,
      refined_z3_lo = refined_z3_residual / l3_0_of_divisor3;
  const double refined_z4_of_refined_y4 = refined_y4 + refined_y4_lo,
      refined_z4_of_refined_y4_lo = ksl_sum_error(refined_y4, refined_y4_lo, refined_z4_of_refined_y4),
      refined_z4 = refined_z4_of_refined_y4 / l4_of_divisor4,
      refined_z4_cross = refined_z4 * l4_of_divisor4_lo,
      refined_z4_product = refined_z4 * l4_of_divisor4,
      refined_z4_product_error = ksl_product_error(refined_z4, l4_of_divisor4, refined_z4_product),
      refined_z4_rest = refined_z4_of_refined_y4 - refined_z4_product,
      refined_z4_exact = refined_z4_rest - refined_z4_product_error,
      refined_z4_lo1 = refined_z4_exact + refined_z4_of_refined_y4_lo,
      refined_z4_residual = refined_z4_lo1 - refined_z4_cross,
      refined_z4_lo = refined_z4_residual / l4_of_divisor4;
  const double refined_z5_of_refined_y5 = refined_y5 + refined_y5_lo,
      refined_z5_of_refined_y5_lo = ksl_sum_error(refined_y5, refined_y5_lo, refined_z5_of_refined_y5),
      refined_z5 = refined_z5_of_refined_y5 / z5_of_divisor5,
      refined_z5_cross = refined_z5 * z5_of_divisor5_lo,
      refined_z5_product = refined_z5 * z5_of_divisor5,
      refined_z5_product_error = ksl_product_error(refined_z5, z5_of_divisor5, refined_z5_product),
      refined_z5_rest = refined_z5_of_refined_y5 - refined_z5_product,
      refined_z5_exact = refined_z5_rest - refined_z5_product_error,
      refined_z5_lo1 = refined_z5_exact + refined_z5_of_refined_y5_lo,
      refined_z5_residual = refined_z5_lo1 - refined_z5_cross,
      refined_z5_lo = refined_z5_residual / z5_of_divisor5;
  const double refined_x4a = l4 * refined_z5, refined_x4a_cross1 = l4_lo * refined_z5,
      refined_x4a_cross2 = l4 * refined_z5_lo,
      refined_x4a_error = ksl_product_error(l4, refined_z5, refined_x4a),
      refined_x4a_lo1 = refined_x4a_error + refined_x4a_cross1,
      refined_x4a_lo = refined_x4a_lo1 + refined_x4a_cross2, refined_x4 = refined_z4 - refined_x4a,
      refined_x4_error = ksl_difference_error(refined_z4, refined_x4a, refined_x4),
      refined_x4_lo1 = refined_x4_error + refined_z4_lo,
      refined_x4_lo = refined_x4_lo1 - refined_x4a_lo;
  const double refined_x3a = l3_0 * refined_x4, refined_x3a_cross1 = l3_0_lo * refined_x4,
      refined_x3a_cross2 = l3_0 * refined_x4_lo,
      refined_x3a_error = ksl_product_error(l3_0, refined_x4, refined_x3a),
      refined_x3a_lo1 = refined_x3a_error + refined_x3a_cross1,
      refined_x3a_lo = refined_x3a_lo1 + refined_x3a_cross2, refined_x3b = refined_z3 - refined_x3a,
      refined_x3b_error = ksl_difference_error(refined_z3, refined_x3a, refined_x3b),
      refined_x3b_lo1 = refined_x3b_error + refined_z3_lo,
      refined_x3b_lo = refined_x3b_lo1 - refined_x3a_lo, refined_x3c = l3_1 * refined_z5,
      refined_x3c_cross1 = l3_1_lo * refined_z5, refined_x3c_cross2 = l3_1 * refined_z5_lo,
      refined_x3c_error = ksl_product_error(l3_1, refined_z5, refined_x3c),
      refined_x3c_lo1 = refined_x3c_error + refined_x3c_cross1,
      refined_x3c_lo = refined_x3c_lo1 + refined_x3c_cross2, refined_x3 = refined_x3b - refined_x3c,
      refined_x3_error = ksl_difference_error(refined_x3b, refined_x3c, refined_x3),
      refined_x3_lo1 = refined_x3_error + refined_x3b_lo,
      refined_x3_lo = refined_x3_lo1 - refined_x3c_lo;
  const double refined_x2a = l2_0 * refined_x3, refined_x2a_cross1 = l2_0_lo * refined_x3,
      refined_x2a_cross2 = l2_0 * refined_x3_lo,
      refined_x2a_error = ksl_product_error(l2_0, refined_x3, refined_x2a),
      refined_x2a_lo1 = refined_x2a_error + refined_x2a_cross1,
      refined_x2a_lo = refined_x2a_lo1 + refined_x2a_cross2, refined_x2b = refined_z2 - refined_x2a,
      refined_x2b_error = ksl_difference_error(refined_z2, refined_x2a, refined_x2b),
      refined_x2b_lo1 = refined_x2b_error + refined_z2_lo,
      refined_x2b_lo = refined_x2b_lo1 - refined_x2a_lo, refined_x2c = l2_1 * refined_x4,
      refined_x2c_cross1 = l2_1_lo * refined_x4, refined_x2c_cross2 = l2_1 * refined_x4_lo,
      refined_x2c_error = ksl_product_error(l2_1, refined_x4, refined_x2c),
      refined_x2c_lo1 = refined_x2c_error + refined_x2c_cross1,
      refined_x2c_lo = refined_x2c_lo1 + refined_x2c_cross2,
      refined_x2d = refined_x2b - refined_x2c,
      refined_x2d_error = ksl_difference_error(refined_x2b, refined_x2c, refined_x2d),
      refined_x2d_lo1 = refined_x2d_error + refined_x2b_lo,
      refined_x2d_lo = refined_x2d_lo1 - refined_x2c_lo, refined_x2e = l2_2 * refined_z5,
      refined_x2e_cross1 = l2_2_lo * refined_z5, refined_x2e_cross2 = l2_2 * refined_z5_lo,
      refined_x2e_error = ksl_product_error(l2_2, refined_z5, refined_x2e),
      refined_x2e_lo1 = refined_x2e_error + refined_x2e_cross1,
      refined_x2e_lo = refined_x2e_lo1 + refined_x2e_cross2, refined_x2 = refined_x2d - refined_x2e,
      refined_x2_error = ksl_difference_error(refined_x2d, refined_x2e, refined_x2),
      refined_x2_lo1 = refined_x2_error + refined_x2d_lo,
      refined_x2_lo = refined_x2_lo1 - refined_x2e_lo;
  const double refined_x1a = l1_0 * refined_x2, refined_x1a_cross1 = l1_0_lo * refined_x2,
      refined_x1a_cross2 = l1_0 * refined_x2_lo,
      refined_x1a_error = ksl_product_error(l1_0, refined_x2, refined_x1a),
      refined_x1a_lo1 = refined_x1a_error + refined_x1a_cross1,
      refined_x1a_lo = refined_x1a_lo1 + refined_x1a_cross2, refined_x1b = refined_z1 - refined_x1a,
      refined_x1b_error = ksl_difference_error(refined_z1, refined_x1a, refined_x1b),
      refined_x1b_lo1 = refined_x1b_error + refined_z1_lo,
      refined_x1b_lo = refined_x1b_lo1 - refined_x1a_lo, refined_x1c = l1_1 * refined_x3,
      refined_x1c_cross1 = l1_1_lo * refined_x3, refined_x1c_cross2 = l1_1 * refined_x3_lo,
      refined_x1c_error = ksl_product_error(l1_1, refined_x3, refined_x1c),
      refined_x1c_lo1 = refined_x1c_error + refined_x1c_cross1,
      refined_x1c_lo = refined_x1c_lo1 + refined_x1c_cross2,
      refined_x1d = refined_x1b - refined_x1c,
      refined_x1d_error = ksl_difference_error(refined_x1b, refined_x1c, refined_x1d),
      refined_x1d_lo1 = refined_x1d_error + refined_x1b_lo,
      refined_x1d_lo = refined_x1d_lo1 - refined_x1c_lo, refined_x1e = l1_2 * refined_x4,
      refined_x1e_cross1 = l1_2_lo * refined_x4, refined_x1e_cross2 = l1_2 * refined_x4_lo,
      refined_x1e_error = ksl_product_error(l1_2, refined_x4, refined_x1e),
      refined_x1e_lo1 = refined_x1e_error + refined_x1e_cross1,
      refined_x1e_lo = refined_x1e_lo1 + refined_x1e_cross2,
      refined_x1f = refined_x1d - refined_x1e,
      refined_x1f_error = ksl_difference_error(refined_x1d, refined_x1e, refined_x1f),
      refined_x1f_lo1 = refined_x1f_error + refined_x1d_lo,
      refined_x1f_lo = refined_x1f_lo1 - refined_x1e_lo, refined_x1g = l1_3 * refined_z5,
      refined_x1g_cross1 = l1_3_lo * refined_z5, refined_x1g_cross2 = l1_3 * refined_z5_lo,
      refined_x1g_error = ksl_product_error(l1_3, refined_z5, refined_x1g),
      refined_x1g_lo1 = refined_x1g_error + refined_x1g_cross1,
      refined_x1g_lo = refined_x1g_lo1 + refined_x1g_cross2, refined_x1 = refined_x1f - refined_x1g,
      refined_x1_error = ksl_difference_error(refined_x1f, refined_x1g, refined_x1),
      refined_x1_lo1 = refined_x1_error + refined_x1f_lo,
      refined_x1_lo = refined_x1_lo1 - refined_x1g_lo;
  const double refined_x0a = l0_0 * refined_x1, refined_x0a_cross1 = l0_0_lo * refined_x1,
      refined_x0a_cross2 = l0_0 * refined_x1_lo,
      refined_x0a_error = ksl_product_error(l0_0, refined_x1, refined_x0a),
      refined_x0a_lo1 = refined_x0a_error + refined_x0a_cross1,
      refined_x0a_lo = refined_x0a_lo1 + refined_x0a_cross2, refined_x0b = refined_z0 - refined_x0a,
      refined_x0b_error = ksl_difference_error(refined_z0, refined_x0a, refined_x0b),
      refined_x0b_lo1 = refined_x0b_error + refined_z0_lo,
      refined_x0b_lo = refined_x0b_lo1 - refined_x0a_lo, refined_x0c = l0_1 * refined_x2,
      refined_x0c_cross1 = l0_1_lo * refined_x2, refined_x0c_cross2 = l0_1 * refined_x2_lo,
      refined_x0c_error = ksl_product_error(l0_1, refined_x2, refined_x0c),
      refined_x0c_lo1 = refined_x0c_error + refined_x0c_cross1,
      refined_x0c_lo = refined_x0c_lo1 + refined_x0c_cross2,
      refined_x0d = refined_x0b - refined_x0c,
      refined_x0d_error = ksl_difference_error(refined_x0b, refined_x0c, refined_x0d),
      refined_x0d_lo1 = refined_x0d_error + refined_x0b_lo,
      refined_x0d_lo = refined_x0d_lo1 - refined_x0c_lo, refined_x0e = l0_2 * refined_x3,
      refined_x0e_cross1 = l0_2_lo * refined_x3, refined_x0e_cross2 = l0_2 * refined_x3_lo,
      refined_x0e_error = ksl_product_error(l0_2, refined_x3, refined_x0e),
      refined_x0e_lo1 = refined_x0e_error + refined_x0e_cross1,
      refined_x0e_lo = refined_x0e_lo1 + refined_x0e_cross2,
      refined_x0f = refined_x0d - refined_x0e,
      refined_x0f_error = ksl_difference_error(refined_x0d, refined_x0e, refined_x0f),
      refined_x0f_lo1 = refined_x0f_error + refined_x0d_lo,
      refined_x0f_lo = refined_x0f_lo1 - refined_x0e_lo, refined_x0g = l0_3 * refined_x4,
      refined_x0g_cross1 = l0_3_lo * refined_x4, refined_x0g_cross2 = l0_3 * refined_x4_lo,
      refined_x0g_error = ksl_product_error(l0_3, refined_x4, refined_x0g),
      refined_x0g_lo1 = refined_x0g_error + refined_x0g_cross1,
      refined_x0g_lo = refined_x0g_lo1 + refined_x0g_cross2,
      refined_x0h = refined_x0f - refined_x0g,
      refined_x0h_error = ksl_difference_error(refined_x0f, refined_x0g, refined_x0h),
      refined_x0h_lo1 = refined_x0h_error + refined_x0f_lo,
      refined_x0h_lo = refined_x0h_lo1 - refined_x0g_lo, refined_x0i = l0_4 * refined_z5,
      refined_x0i_cross1 = l0_4_lo * refined_z5, refined_x0i_cross2 = l0_4 * refined_z5_lo,
      refined_x0i_error = ksl_product_error(l0_4, refined_z5, refined_x0i),
      refined_x0i_lo1 = refined_x0i_error + refined_x0i_cross1,
      refined_x0i_lo = refined_x0i_lo1 + refined_x0i_cross2, refined_x0 = refined_x0h - refined_x0i,
      refined_x0_error = ksl_difference_error(refined_x0h, refined_x0i, refined_x0),
      refined_x0_lo1 = refined_x0_error + refined_x0h_lo,
      refined_x0_lo = refined_x0_lo1 - refined_x0i_lo;
  const double found_0 = x0 + refined_x0, found_0_error = ksl_sum_error(x0, refined_x0, found_0),
      found_0_lo1 = found_0_error + x0_lo, found_0_lo = found_0_lo1 + refined_x0_lo;
  const double found_1 = x1 + refined_x1, found_1_error = ksl_sum_error(x1, refined_x1, found_1),
      found_1_lo1 = found_1_error + x1_lo, found_1_lo = found_1_lo1 + refined_x1_lo;
  const double found_2 = x2 + refined_x2, found_2_error = ksl_sum_error(x2, refined_x2, found_2),
      found_2_lo1 = found_2_error + x2_lo, found_2_lo = found_2_lo1 + refined_x2_lo;
  const double found_3 = x3 + refined_x3, found_3_error = ksl_sum_error(x3, refined_x3, found_3),
      found_3_lo1 = found_3_error + x3_lo, found_3_lo = found_3_lo1 + refined_x3_lo;
  const double found_4 = x4 + refined_x4, found_4_error = ksl_sum_error(x4, refined_x4, found_4),
      found_4_lo1 = found_4_error + x4_lo, found_4_lo = found_4_lo1 + refined_x4_lo;
  const double found_5 = z5 + refined_z5, found_5_error = ksl_sum_error(z5, refined_z5, found_5),
      found_5_lo1 = found_5_error + z5_lo, found_5_lo = found_5_lo1 + refined_z5_lo;
  const double x_0 = 8.881784197001252e-16 < smallest5 ? found_0 : (double)NAN,
      x_0_lo = 8.881784197001252e-16 < smallest5 ? found_0_lo : 0.0;
  const double x_1 = 8.881784197001252e-16 < smallest5 ? found_1 : (double)NAN,
      x_1_lo = 8.881784197001252e-16 < smallest5 ? found_1_lo : 0.0;
  const double x_2 = 8.881784197001252e-16 < smallest5 ? found_2 : (double)NAN,
      x_2_lo = 8.881784197001252e-16 < smallest5 ? found_2_lo : 0.0;
  const double x_3 = 8.881784197001252e-16 < smallest5 ? found_3 : (double)NAN,
      x_3_lo = 8.881784197001252e-16 < smallest5 ? found_3_lo : 0.0;
  const double x_4 = 8.881784197001252e-16 < smallest5 ? found_4 : (double)NAN,
      x_4_lo = 8.881784197001252e-16 < smallest5 ? found_4_lo : 0.0;
  const double x_5 = 8.881784197001252e-16 < smallest5 ? found_5 : (double)NAN,
      x_5_lo = 8.881784197001252e-16 < smallest5 ? found_5_lo : 0.0;
  const double smallest5_total = smallest5 + smallest5_lo,
      smallest5_rounded = smallest5_total == smallest5_total ? smallest5_total : smallest5;
  const double x_0_total = x_0 + x_0_lo, x_0_rounded = x_0_total == x_0_total ? x_0_total : x_0;
  const double x_1_total = x_1 + x_1_lo, x_1_rounded = x_1_total == x_1_total ? x_1_total : x_1;
  const double x_2_total = x_2 + x_2_lo, x_2_rounded = x_2_total == x_2_total ? x_2_total : x_2;
  const double x_3_total = x_3 + x_3_lo, x_3_rounded = x_3_total == x_3_total ? x_3_total : x_3;
  const double x_4_total = x_4 + x_4_lo, x_4_rounded = x_4_total == x_4_total ? x_4_total : x_4;
  const double x_5_total = x_5 + x_5_lo, x_5_rounded = x_5_total == x_5_total ? x_5_total : x_5;
  x->m0 = x_0_rounded;
  x->m1 = x_1_rounded;
  x->m2 = x_2_rounded;
  x->m3 = x_3_rounded;
  x->m4 = x_4_rounded;
  x->m5 = x_5_rounded;
  return smallest5_rounded;
}

/* L, D with L D L^T = A: unit lower triangular L, D on its diagonal; returns the smallest pivot
     d_i / a_ii: where it is not positive, A is not positive definite, and L means nothing.
   A, L: rotation or other 3×3 matrix.
   4 mul, 4 add, 6 div, 6 less, 9 select. */
static inline float ksl_mat3x3f_ldl_accurate(const ksl_mat3x3f_t *A, ksl_mat3x3f_t *L) {
  const double divisor0 = 0.0 < (double)A->m00 ? (double)A->m00 : 1.0;
  const double l0_0 = (double)A->m10 / divisor0;
  const double l0_1 = (double)A->m20 / divisor0;
  const double u1_0a = (double)A->m10 * l0_0, u1_0 = (double)A->m11 - u1_0a;
  const double u1_1a = (double)A->m20 * l0_0, u1_1 = (double)A->m21 - u1_1a;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1 = u1_1 / divisor1;
  const double u2a = (double)A->m20 * l0_1, u2b = (double)A->m22 - u2a, u2c = u1_1 * l1,
      u2 = u2b - u2c;
  const double part0a = (double)A->m00 / divisor0,
      part0 = 0.0 < (double)A->m00 ? part0a : (double)A->m00;
  const double own1 = 0.0 < (double)A->m11 ? (double)A->m11 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < (double)A->m11 ? part1a : (double)A->m11;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < (double)A->m22 ? (double)A->m22 : 1.0;
  const double part2a = u2 / own2, part2 = 0.0 < (double)A->m22 ? part2a : (double)A->m22;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const float A_m00 = A->m00;
  L->m00 = A_m00;
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
   6 mul, 6 add, 3 div. */
static inline void ksl_mat3x3f_ldl_solve_accurate(const ksl_mat3x3f_t *L, const ksl_vec3f_t *b,
    ksl_vec3f_t *x) {
  const double y1a = (double)L->m10 * (double)b->x, y1 = (double)b->y - y1a;
  const double y2a = (double)L->m20 * (double)b->x, y2b = (double)b->z - y2a,
      y2c = (double)L->m21 * y1, y2 = y2b - y2c;
  const double z0 = (double)b->x / (double)L->m00;
  const double z1 = y1 / (double)L->m11;
  const double z2 = y2 / (double)L->m22;
  const double x1a = (double)L->m21 * z2, x1 = z1 - x1a;
  const double x0a = (double)L->m10 * x1, x0b = z0 - x0a, x0c = (double)L->m20 * z2, x0 = x0b - x0c;
  x->x = (float)x0;
  x->y = (float)x1;
  x->z = (float)z2;
}

/* x = A^-1 b with one step of refinement; returns the smallest pivot d_i / a_ii: where it is not
     above 8 u, A is singular or indefinite, and x not a number.
   A: rotation or other 3×3 matrix; b, x: vector.
   25 mul, 28 add, 12 div, 8 less, 13 select. */
static inline float ksl_mat3x3f_solve_accurate(const ksl_mat3x3f_t *A, const ksl_vec3f_t *b,
    ksl_vec3f_t *x) {
  const double divisor0 = 0.0 < (double)A->m00 ? (double)A->m00 : 1.0;
  const double l0_0 = (double)A->m10 / divisor0;
  const double l0_1 = (double)A->m20 / divisor0;
  const double u1_0a = (double)A->m10 * l0_0, u1_0 = (double)A->m11 - u1_0a;
  const double u1_1a = (double)A->m20 * l0_0, u1_1 = (double)A->m21 - u1_1a;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1 = u1_1 / divisor1;
  const double u2a = (double)A->m20 * l0_1, u2b = (double)A->m22 - u2a, u2c = u1_1 * l1,
      u2 = u2b - u2c;
  const double divisor2 = 0.0 < u2 ? u2 : 1.0;
  const double part0a = (double)A->m00 / divisor0,
      part0 = 0.0 < (double)A->m00 ? part0a : (double)A->m00;
  const double own1 = 0.0 < (double)A->m11 ? (double)A->m11 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < (double)A->m11 ? part1a : (double)A->m11;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < (double)A->m22 ? (double)A->m22 : 1.0;
  const double part2a = u2 / own2, part2 = 0.0 < (double)A->m22 ? part2a : (double)A->m22;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double y1a = (double)b->x * l0_0, y1 = (double)b->y - y1a;
  const double y2a = (double)b->x * l0_1, y2b = (double)b->z - y2a, y2c = l1 * y1, y2 = y2b - y2c;
  const double z0 = (double)b->x / divisor0;
  const double z1 = y1 / divisor1;
  const double z2 = y2 / divisor2;
  const double x1a = l1 * z2, x1 = z1 - x1a;
  const double x0a = l0_0 * x1, x0b = z0 - x0a, x0c = l0_1 * z2, x0 = x0b - x0c;
  const double residual_0a = (double)A->m00 * x0, residual_0b = (double)b->x - residual_0a,
      residual_0c = (double)A->m10 * x1, residual_0d = residual_0b - residual_0c,
      residual_0e = (double)A->m20 * z2, residual_0 = residual_0d - residual_0e;
  const double residual_1a = (double)A->m10 * x0, residual_1b = (double)b->y - residual_1a,
      residual_1c = (double)A->m11 * x1, residual_1d = residual_1b - residual_1c,
      residual_1e = (double)A->m21 * z2, residual_1 = residual_1d - residual_1e;
  const double residual_2a = (double)A->m20 * x0, residual_2b = (double)b->z - residual_2a,
      residual_2c = (double)A->m21 * x1, residual_2d = residual_2b - residual_2c,
      residual_2e = (double)A->m22 * z2, residual_2 = residual_2d - residual_2e;
  const double refined_y1a = l0_0 * residual_0, refined_y1 = residual_1 - refined_y1a;
  const double refined_y2a = l0_1 * residual_0, refined_y2b = residual_2 - refined_y2a,
      refined_y2c = l1 * refined_y1, refined_y2 = refined_y2b - refined_y2c;
  const double refined_z0 = residual_0 / divisor0;
  const double refined_z1 = refined_y1 / divisor1;
  const double refined_z2 = refined_y2 / divisor2;
  const double refined_x1a = l1 * refined_z2, refined_x1 = refined_z1 - refined_x1a;
  const double refined_x0a = l0_0 * refined_x1, refined_x0b = refined_z0 - refined_x0a,
      refined_x0c = l0_1 * refined_z2, refined_x0 = refined_x0b - refined_x0c;
  const double found_0 = x0 + refined_x0;
  const double found_1 = x1 + refined_x1;
  const double found_2 = z2 + refined_z2;
  const double x_0 = 4.76837158203125e-07 < smallest2 ? found_0 : (double)NAN;
  const double x_1 = 4.76837158203125e-07 < smallest2 ? found_1 : (double)NAN;
  const double x_2 = 4.76837158203125e-07 < smallest2 ? found_2 : (double)NAN;
  x->x = (float)x_0;
  x->y = (float)x_1;
  x->z = (float)x_2;
  return (float)smallest2;
}

/* L, D with L D L^T = A: unit lower triangular L, D on its diagonal; returns the smallest pivot
     d_i / a_ii: where it is not positive, A is not positive definite, and L means nothing.
   A, L: 6×6 operator.
   35 mul, 35 add, 21 div, 15 less, 21 select. */
static inline float ksl_mat6x6f_ldl_accurate(const ksl_mat6x6f_t *A, ksl_mat6x6f_t *L) {
  const double divisor0 = 0.0 < (double)A->at[0][0] ? (double)A->at[0][0] : 1.0;
  const double l0_0 = (double)A->at[0][1] / divisor0;
  const double l0_1 = (double)A->at[0][2] / divisor0;
  const double l0_2 = (double)A->at[0][3] / divisor0;
  const double l0_3 = (double)A->at[0][4] / divisor0;
  const double l0_4 = (double)A->at[0][5] / divisor0;
  const double u1_0a = (double)A->at[0][1] * l0_0, u1_0 = (double)A->at[1][1] - u1_0a;
  const double u1_1a = (double)A->at[0][2] * l0_0, u1_1 = (double)A->at[1][2] - u1_1a;
  const double u1_2a = (double)A->at[0][3] * l0_0, u1_2 = (double)A->at[1][3] - u1_2a;
  const double u1_3a = (double)A->at[0][4] * l0_0, u1_3 = (double)A->at[1][4] - u1_3a;
  const double u1_4a = (double)A->at[0][5] * l0_0, u1_4 = (double)A->at[1][5] - u1_4a;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1;
  const double l1_1 = u1_2 / divisor1;
  const double l1_2 = u1_3 / divisor1;
  const double l1_3 = u1_4 / divisor1;
  const double u2_0a = (double)A->at[0][2] * l0_1, u2_0b = (double)A->at[2][2] - u2_0a,
      u2_0c = u1_1 * l1_0, u2_0 = u2_0b - u2_0c;
  const double u2_1a = (double)A->at[0][3] * l0_1, u2_1b = (double)A->at[2][3] - u2_1a,
      u2_1c = u1_2 * l1_0, u2_1 = u2_1b - u2_1c;
  const double u2_2a = (double)A->at[0][4] * l0_1, u2_2b = (double)A->at[2][4] - u2_2a,
      u2_2c = u1_3 * l1_0, u2_2 = u2_2b - u2_2c;
  const double u2_3a = (double)A->at[0][5] * l0_1, u2_3b = (double)A->at[2][5] - u2_3a,
      u2_3c = u1_4 * l1_0, u2_3 = u2_3b - u2_3c;
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2_0 = u2_1 / divisor2;
  const double l2_1 = u2_2 / divisor2;
  const double l2_2 = u2_3 / divisor2;
  const double u3_0a = (double)A->at[0][3] * l0_2, u3_0b = (double)A->at[3][3] - u3_0a,
      u3_0c = u1_2 * l1_1, u3_0d = u3_0b - u3_0c, u3_0e = u2_1 * l2_0, u3_0 = u3_0d - u3_0e;
  const double u3_1a = (double)A->at[0][4] * l0_2, u3_1b = (double)A->at[3][4] - u3_1a,
      u3_1c = u1_3 * l1_1, u3_1d = u3_1b - u3_1c, u3_1e = u2_2 * l2_0, u3_1 = u3_1d - u3_1e;
  const double u3_2a = (double)A->at[0][5] * l0_2, u3_2b = (double)A->at[3][5] - u3_2a,
      u3_2c = u1_4 * l1_1, u3_2d = u3_2b - u3_2c, u3_2e = u2_3 * l2_0, u3_2 = u3_2d - u3_2e;
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0;
  const double l3_0 = u3_1 / divisor3;
  const double l3_1 = u3_2 / divisor3;
  const double u4_0a = (double)A->at[0][4] * l0_3, u4_0b = (double)A->at[4][4] - u4_0a,
      u4_0c = u1_3 * l1_2, u4_0d = u4_0b - u4_0c, u4_0e = u2_2 * l2_1, u4_0f = u4_0d - u4_0e,
      u4_0g = u3_1 * l3_0, u4_0 = u4_0f - u4_0g;
  const double u4_1a = (double)A->at[0][5] * l0_3, u4_1b = (double)A->at[4][5] - u4_1a,
      u4_1c = u1_4 * l1_2, u4_1d = u4_1b - u4_1c, u4_1e = u2_3 * l2_1, u4_1f = u4_1d - u4_1e,
      u4_1g = u3_2 * l3_0, u4_1 = u4_1f - u4_1g;
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0;
  const double l4 = u4_1 / divisor4;
  const double u5a = (double)A->at[0][5] * l0_4, u5b = (double)A->at[5][5] - u5a, u5c = u1_4 * l1_3,
      u5d = u5b - u5c, u5e = u2_3 * l2_2, u5f = u5d - u5e, u5g = u3_2 * l3_1, u5h = u5f - u5g,
      u5i = u4_1 * l4, u5 = u5h - u5i;
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
  const float A_at_00 = A->at[0][0];
  L->at[0][0] = A_at_00;
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
   30 mul, 30 add, 6 div. */
static inline void ksl_mat6x6f_ldl_solve_accurate(const ksl_mat6x6f_t *L, const ksl_coscrewf_t *b,
    ksl_screwf_t *x) {
  const double y1a = (double)L->at[0][1] * (double)b->m0, y1 = (double)b->m1 - y1a;
  const double y2a = (double)L->at[0][2] * (double)b->m0, y2b = (double)b->m2 - y2a,
      y2c = (double)L->at[1][2] * y1, y2 = y2b - y2c;
  const double y3a = (double)L->at[0][3] * (double)b->m0, y3b = (double)b->m3 - y3a,
      y3c = (double)L->at[1][3] * y1, y3d = y3b - y3c, y3e = (double)L->at[2][3] * y2,
      y3 = y3d - y3e;
  const double y4a = (double)L->at[0][4] * (double)b->m0, y4b = (double)b->m4 - y4a,
      y4c = (double)L->at[1][4] * y1, y4d = y4b - y4c, y4e = (double)L->at[2][4] * y2,
      y4f = y4d - y4e, y4g = (double)L->at[3][4] * y3, y4 = y4f - y4g;
  const double y5a = (double)L->at[0][5] * (double)b->m0, y5b = (double)b->m5 - y5a,
      y5c = (double)L->at[1][5] * y1, y5d = y5b - y5c, y5e = (double)L->at[2][5] * y2,
      y5f = y5d - y5e, y5g = (double)L->at[3][5] * y3, y5h = y5f - y5g,
      y5i = (double)L->at[4][5] * y4, y5 = y5h - y5i;
  const double z0 = (double)b->m0 / (double)L->at[0][0];
  const double z1 = y1 / (double)L->at[1][1];
  const double z2 = y2 / (double)L->at[2][2];
  const double z3 = y3 / (double)L->at[3][3];
  const double z4 = y4 / (double)L->at[4][4];
  const double z5 = y5 / (double)L->at[5][5];
  const double x4a = (double)L->at[4][5] * z5, x4 = z4 - x4a;
  const double x3a = (double)L->at[3][4] * x4, x3b = z3 - x3a, x3c = (double)L->at[3][5] * z5,
      x3 = x3b - x3c;
  const double x2a = (double)L->at[2][3] * x3, x2b = z2 - x2a, x2c = (double)L->at[2][4] * x4,
      x2d = x2b - x2c, x2e = (double)L->at[2][5] * z5, x2 = x2d - x2e;
  const double x1a = (double)L->at[1][2] * x2, x1b = z1 - x1a, x1c = (double)L->at[1][3] * x3,
      x1d = x1b - x1c, x1e = (double)L->at[1][4] * x4, x1f = x1d - x1e,
      x1g = (double)L->at[1][5] * z5, x1 = x1f - x1g;
  const double x0a = (double)L->at[0][1] * x1, x0b = z0 - x0a, x0c = (double)L->at[0][2] * x2,
      x0d = x0b - x0c, x0e = (double)L->at[0][3] * x3, x0f = x0d - x0e,
      x0g = (double)L->at[0][4] * x4, x0h = x0f - x0g, x0i = (double)L->at[0][5] * z5,
      x0 = x0h - x0i;
  x->m0 = (float)x0;
  x->m1 = (float)x1;
  x->m2 = (float)x2;
  x->m3 = (float)x3;
  x->m4 = (float)x4;
  x->m5 = (float)z5;
}

/* x = A^-1 b with one step of refinement; returns the smallest pivot d_i / a_ii: where it is not
     above 8 u, A is singular or indefinite, and x not a number.
   A: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in rad/s).
   131 mul, 137 add, 33 div, 17 less, 28 select. */
static inline float ksl_mat6x6f_solve_accurate(const ksl_mat6x6f_t *A, const ksl_coscrewf_t *b,
    ksl_screwf_t *x) {
  const double divisor0 = 0.0 < (double)A->at[0][0] ? (double)A->at[0][0] : 1.0;
  const double l0_0 = (double)A->at[0][1] / divisor0;
  const double l0_1 = (double)A->at[0][2] / divisor0;
  const double l0_2 = (double)A->at[0][3] / divisor0;
  const double l0_3 = (double)A->at[0][4] / divisor0;
  const double l0_4 = (double)A->at[0][5] / divisor0;
  const double u1_0a = (double)A->at[0][1] * l0_0, u1_0 = (double)A->at[1][1] - u1_0a;
  const double u1_1a = (double)A->at[0][2] * l0_0, u1_1 = (double)A->at[1][2] - u1_1a;
  const double u1_2a = (double)A->at[0][3] * l0_0, u1_2 = (double)A->at[1][3] - u1_2a;
  const double u1_3a = (double)A->at[0][4] * l0_0, u1_3 = (double)A->at[1][4] - u1_3a;
  const double u1_4a = (double)A->at[0][5] * l0_0, u1_4 = (double)A->at[1][5] - u1_4a;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1;
  const double l1_1 = u1_2 / divisor1;
  const double l1_2 = u1_3 / divisor1;
  const double l1_3 = u1_4 / divisor1;
  const double u2_0a = (double)A->at[0][2] * l0_1, u2_0b = (double)A->at[2][2] - u2_0a,
      u2_0c = u1_1 * l1_0, u2_0 = u2_0b - u2_0c;
  const double u2_1a = (double)A->at[0][3] * l0_1, u2_1b = (double)A->at[2][3] - u2_1a,
      u2_1c = u1_2 * l1_0, u2_1 = u2_1b - u2_1c;
  const double u2_2a = (double)A->at[0][4] * l0_1, u2_2b = (double)A->at[2][4] - u2_2a,
      u2_2c = u1_3 * l1_0, u2_2 = u2_2b - u2_2c;
  const double u2_3a = (double)A->at[0][5] * l0_1, u2_3b = (double)A->at[2][5] - u2_3a,
      u2_3c = u1_4 * l1_0, u2_3 = u2_3b - u2_3c;
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2_0 = u2_1 / divisor2;
  const double l2_1 = u2_2 / divisor2;
  const double l2_2 = u2_3 / divisor2;
  const double u3_0a = (double)A->at[0][3] * l0_2, u3_0b = (double)A->at[3][3] - u3_0a,
      u3_0c = u1_2 * l1_1, u3_0d = u3_0b - u3_0c, u3_0e = u2_1 * l2_0, u3_0 = u3_0d - u3_0e;
  const double u3_1a = (double)A->at[0][4] * l0_2, u3_1b = (double)A->at[3][4] - u3_1a,
      u3_1c = u1_3 * l1_1, u3_1d = u3_1b - u3_1c, u3_1e = u2_2 * l2_0, u3_1 = u3_1d - u3_1e;
  const double u3_2a = (double)A->at[0][5] * l0_2, u3_2b = (double)A->at[3][5] - u3_2a,
      u3_2c = u1_4 * l1_1, u3_2d = u3_2b - u3_2c, u3_2e = u2_3 * l2_0, u3_2 = u3_2d - u3_2e;
  const double divisor3 = 0.0 < u3_0 ? u3_0 : 1.0;
  const double l3_0 = u3_1 / divisor3;
  const double l3_1 = u3_2 / divisor3;
  const double u4_0a = (double)A->at[0][4] * l0_3, u4_0b = (double)A->at[4][4] - u4_0a,
      u4_0c = u1_3 * l1_2, u4_0d = u4_0b - u4_0c, u4_0e = u2_2 * l2_1, u4_0f = u4_0d - u4_0e,
      u4_0g = u3_1 * l3_0, u4_0 = u4_0f - u4_0g;
  const double u4_1a = (double)A->at[0][5] * l0_3, u4_1b = (double)A->at[4][5] - u4_1a,
      u4_1c = u1_4 * l1_2, u4_1d = u4_1b - u4_1c, u4_1e = u2_3 * l2_1, u4_1f = u4_1d - u4_1e,
      u4_1g = u3_2 * l3_0, u4_1 = u4_1f - u4_1g;
  const double divisor4 = 0.0 < u4_0 ? u4_0 : 1.0;
  const double l4 = u4_1 / divisor4;
  const double u5a = (double)A->at[0][5] * l0_4, u5b = (double)A->at[5][5] - u5a, u5c = u1_4 * l1_3,
      u5d = u5b - u5c, u5e = u2_3 * l2_2, u5f = u5d - u5e, u5g = u3_2 * l3_1, u5h = u5f - u5g,
      u5i = u4_1 * l4, u5 = u5h - u5i;
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
  const double y1a = (double)b->m0 * l0_0, y1 = (double)b->m1 - y1a;
  const double y2a = (double)b->m0 * l0_1, y2b = (double)b->m2 - y2a, y2c = l1_0 * y1,
      y2 = y2b - y2c;
  const double y3a = (double)b->m0 * l0_2, y3b = (double)b->m3 - y3a, y3c = l1_1 * y1,
      y3d = y3b - y3c, y3e = l2_0 * y2, y3 = y3d - y3e;
  const double y4a = (double)b->m0 * l0_3, y4b = (double)b->m4 - y4a, y4c = l1_2 * y1,
      y4d = y4b - y4c, y4e = l2_1 * y2, y4f = y4d - y4e, y4g = l3_0 * y3, y4 = y4f - y4g;
  const double y5a = (double)b->m0 * l0_4, y5b = (double)b->m5 - y5a, y5c = l1_3 * y1,
      y5d = y5b - y5c, y5e = l2_2 * y2, y5f = y5d - y5e, y5g = l3_1 * y3, y5h = y5f - y5g,
      y5i = l4 * y4, y5 = y5h - y5i;
  const double z0 = (double)b->m0 / divisor0;
  const double z1 = y1 / divisor1;
  const double z2 = y2 / divisor2;
  const double z3 = y3 / divisor3;
  const double z4 = y4 / divisor4;
  const double z5 = y5 / divisor5;
  const double x4a = l4 * z5, x4 = z4 - x4a;
  const double x3a = l3_0 * x4, x3b = z3 - x3a, x3c = l3_1 * z5, x3 = x3b - x3c;
  const double x2a = l2_0 * x3, x2b = z2 - x2a, x2c = l2_1 * x4, x2d = x2b - x2c, x2e = l2_2 * z5,
      x2 = x2d - x2e;
  const double x1a = l1_0 * x2, x1b = z1 - x1a, x1c = l1_1 * x3, x1d = x1b - x1c, x1e = l1_2 * x4,
      x1f = x1d - x1e, x1g = l1_3 * z5, x1 = x1f - x1g;
  const double x0a = l0_0 * x1, x0b = z0 - x0a, x0c = l0_1 * x2, x0d = x0b - x0c, x0e = l0_2 * x3,
      x0f = x0d - x0e, x0g = l0_3 * x4, x0h = x0f - x0g, x0i = l0_4 * z5, x0 = x0h - x0i;
  const double residual_0a = (double)A->at[0][0] * x0, residual_0b = (double)b->m0 - residual_0a,
      residual_0c = (double)A->at[0][1] * x1, residual_0d = residual_0b - residual_0c,
      residual_0e = (double)A->at[0][2] * x2, residual_0f = residual_0d - residual_0e,
      residual_0g = (double)A->at[0][3] * x3, residual_0h = residual_0f - residual_0g,
      residual_0i = (double)A->at[0][4] * x4, residual_0j = residual_0h - residual_0i,
      residual_0k = (double)A->at[0][5] * z5, residual_0 = residual_0j - residual_0k;
  const double residual_1a = (double)A->at[0][1] * x0, residual_1b = (double)b->m1 - residual_1a,
      residual_1c = (double)A->at[1][1] * x1, residual_1d = residual_1b - residual_1c,
      residual_1e = (double)A->at[1][2] * x2, residual_1f = residual_1d - residual_1e,
      residual_1g = (double)A->at[1][3] * x3, residual_1h = residual_1f - residual_1g,
      residual_1i = (double)A->at[1][4] * x4, residual_1j = residual_1h - residual_1i,
      residual_1k = (double)A->at[1][5] * z5, residual_1 = residual_1j - residual_1k;
  const double residual_2a = (double)A->at[0][2] * x0, residual_2b = (double)b->m2 - residual_2a,
      residual_2c = (double)A->at[1][2] * x1, residual_2d = residual_2b - residual_2c,
      residual_2e = (double)A->at[2][2] * x2, residual_2f = residual_2d - residual_2e,
      residual_2g = (double)A->at[2][3] * x3, residual_2h = residual_2f - residual_2g,
      residual_2i = (double)A->at[2][4] * x4, residual_2j = residual_2h - residual_2i,
      residual_2k = (double)A->at[2][5] * z5, residual_2 = residual_2j - residual_2k;
  const double residual_3a = (double)A->at[0][3] * x0, residual_3b = (double)b->m3 - residual_3a,
      residual_3c = (double)A->at[1][3] * x1, residual_3d = residual_3b - residual_3c,
      residual_3e = (double)A->at[2][3] * x2, residual_3f = residual_3d - residual_3e,
      residual_3g = (double)A->at[3][3] * x3, residual_3h = residual_3f - residual_3g,
      residual_3i = (double)A->at[3][4] * x4, residual_3j = residual_3h - residual_3i,
      residual_3k = (double)A->at[3][5] * z5, residual_3 = residual_3j - residual_3k;
  const double residual_4a = (double)A->at[0][4] * x0, residual_4b = (double)b->m4 - residual_4a,
      residual_4c = (double)A->at[1][4] * x1, residual_4d = residual_4b - residual_4c,
      residual_4e = (double)A->at[2][4] * x2, residual_4f = residual_4d - residual_4e,
      residual_4g = (double)A->at[3][4] * x3, residual_4h = residual_4f - residual_4g,
      residual_4i = (double)A->at[4][4] * x4, residual_4j = residual_4h - residual_4i,
      residual_4k = (double)A->at[4][5] * z5, residual_4 = residual_4j - residual_4k;
  const double residual_5a = (double)A->at[0][5] * x0, residual_5b = (double)b->m5 - residual_5a,
      residual_5c = (double)A->at[1][5] * x1, residual_5d = residual_5b - residual_5c,
      residual_5e = (double)A->at[2][5] * x2, residual_5f = residual_5d - residual_5e,
      residual_5g = (double)A->at[3][5] * x3, residual_5h = residual_5f - residual_5g,
      residual_5i = (double)A->at[4][5] * x4, residual_5j = residual_5h - residual_5i,
      residual_5k = (double)A->at[5][5] * z5, residual_5 = residual_5j - residual_5k;
  const double refined_y1a = l0_0 * residual_0, refined_y1 = residual_1 - refined_y1a;
  const double refined_y2a = l0_1 * residual_0, refined_y2b = residual_2 - refined_y2a,
      refined_y2c = l1_0 * refined_y1, refined_y2 = refined_y2b - refined_y2c;
  const double refined_y3a = l0_2 * residual_0, refined_y3b = residual_3 - refined_y3a,
      refined_y3c = l1_1 * refined_y1, refined_y3d = refined_y3b - refined_y3c,
      refined_y3e = l2_0 * refined_y2, refined_y3 = refined_y3d - refined_y3e;
  const double refined_y4a = l0_3 * residual_0, refined_y4b = residual_4 - refined_y4a,
      refined_y4c = l1_2 * refined_y1, refined_y4d = refined_y4b - refined_y4c,
      refined_y4e = l2_1 * refined_y2, refined_y4f = refined_y4d - refined_y4e,
      refined_y4g = l3_0 * refined_y3, refined_y4 = refined_y4f - refined_y4g;
  const double refined_y5a = l0_4 * residual_0, refined_y5b = residual_5 - refined_y5a,
      refined_y5c = l1_3 * refined_y1, refined_y5d = refined_y5b - refined_y5c,
      refined_y5e = l2_2 * refined_y2, refined_y5f = refined_y5d - refined_y5e,
      refined_y5g = l3_1 * refined_y3, refined_y5h = refined_y5f - refined_y5g,
      refined_y5i = l4 * refined_y4, refined_y5 = refined_y5h - refined_y5i;
  const double refined_z0 = residual_0 / divisor0;
  const double refined_z1 = refined_y1 / divisor1;
  const double refined_z2 = refined_y2 / divisor2;
  const double refined_z3 = refined_y3 / divisor3;
  const double refined_z4 = refined_y4 / divisor4;
  const double refined_z5 = refined_y5 / divisor5;
  const double refined_x4a = l4 * refined_z5, refined_x4 = refined_z4 - refined_x4a;
  const double refined_x3a = l3_0 * refined_x4, refined_x3b = refined_z3 - refined_x3a,
      refined_x3c = l3_1 * refined_z5, refined_x3 = refined_x3b - refined_x3c;
  const double refined_x2a = l2_0 * refined_x3, refined_x2b = refined_z2 - refined_x2a,
      refined_x2c = l2_1 * refined_x4, refined_x2d = refined_x2b - refined_x2c,
      refined_x2e = l2_2 * refined_z5, refined_x2 = refined_x2d - refined_x2e;
  const double refined_x1a = l1_0 * refined_x2, refined_x1b = refined_z1 - refined_x1a,
      refined_x1c = l1_1 * refined_x3, refined_x1d = refined_x1b - refined_x1c,
      refined_x1e = l1_2 * refined_x4, refined_x1f = refined_x1d - refined_x1e,
      refined_x1g = l1_3 * refined_z5, refined_x1 = refined_x1f - refined_x1g;
  const double refined_x0a = l0_0 * refined_x1, refined_x0b = refined_z0 - refined_x0a,
      refined_x0c = l0_1 * refined_x2, refined_x0d = refined_x0b - refined_x0c,
      refined_x0e = l0_2 * refined_x3, refined_x0f = refined_x0d - refined_x0e,
      refined_x0g = l0_3 * refined_x4, refined_x0h = refined_x0f - refined_x0g,
      refined_x0i = l0_4 * refined_z5, refined_x0 = refined_x0h - refined_x0i;
  const double found_0 = x0 + refined_x0;
  const double found_1 = x1 + refined_x1;
  const double found_2 = x2 + refined_x2;
  const double found_3 = x3 + refined_x3;
  const double found_4 = x4 + refined_x4;
  const double found_5 = z5 + refined_z5;
  const double x_0 = 4.76837158203125e-07 < smallest5 ? found_0 : (double)NAN;
  const double x_1 = 4.76837158203125e-07 < smallest5 ? found_1 : (double)NAN;
  const double x_2 = 4.76837158203125e-07 < smallest5 ? found_2 : (double)NAN;
  const double x_3 = 4.76837158203125e-07 < smallest5 ? found_3 : (double)NAN;
  const double x_4 = 4.76837158203125e-07 < smallest5 ? found_4 : (double)NAN;
  const double x_5 = 4.76837158203125e-07 < smallest5 ? found_5 : (double)NAN;
  x->m0 = (float)x_0;
  x->m1 = (float)x_1;
  x->m2 = (float)x_2;
  x->m3 = (float)x_3;
  x->m4 = (float)x_4;
  x->m5 = (float)x_5;
  return (float)smallest5;
}

#endif
