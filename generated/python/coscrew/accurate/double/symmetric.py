# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Symmetric positive definite 3×3 and 6×6 matrices: A = L D L^T, solutions of A x = b.

In double precision, accurate tier.
"""

from numpy import float64 as real, nan, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(3,3)->(),(3,3)")
def mat3x3_ldl(A):
    """L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
    triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
    not positive definite, and L is meaningless.

    (3,3)->(),(3,3).  A, L: rotation or other 3×3 matrix; pivot: number.
    16 mul, 96 add, 6 product error, 4 product rest, 12 div, 6 less, 6 equal, 21 select.  |L D
    L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and underflow.
    """
    A_00, A_01, A_02, A_10, A_11, A_12, A_20, A_21, A_22 = A
    divisor0a = 0 < A_00
    divisor0 = where(divisor0a, A_00, 1)
    l0_0 = A_10 / divisor0
    l0_0_product = l0_0 * divisor0
    l0_0_lo = (A_10 - l0_0_product - product_error(l0_0, divisor0, l0_0_product)) / divisor0
    l0_1 = A_20 / divisor0
    l0_1_product = l0_1 * divisor0
    l0_1_lo = (A_20 - l0_1_product - product_error(l0_1, divisor0, l0_1_product)) / divisor0
    u1_0a = A_10 * l0_0
    u1_0 = A_11 - u1_0a
    u1_0_right = A_11 - u1_0
    u1_0_lo = (A_11 - (u1_0 + u1_0_right) - product_rest(A_10, l0_0, u1_0a, u1_0_right) - A_10
        * l0_0_lo)
    u1_1a = A_20 * l0_0
    u1_1 = A_21 - u1_1a
    u1_1_right = A_21 - u1_1
    u1_1_lo = (A_21 - (u1_1 + u1_1_right) - product_rest(A_20, l0_0, u1_1a, u1_1_right) - A_20
        * l0_0_lo)
    u1_0_sum = u1_0 + u1_0_lo
    u1_0_sum_right = u1_0_sum - u1_0
    u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right)
    divisor1a = 0 < u1_0_sum
    divisor1 = where(divisor1a, u1_0_sum, 1)
    divisor1_lo = where(divisor1a, u1_0_sum_lo, 0)
    u1_1_sum = u1_1 + u1_1_lo
    u1_1_sum_right = u1_1_sum - u1_1
    u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right)
    divisor1_sum = divisor1 + divisor1_lo
    divisor1_sum_right = divisor1_sum - divisor1
    l1 = u1_1_sum / divisor1_sum
    l1_product = l1 * divisor1_sum
    l1_cross = (l1
        * (divisor1 - (divisor1_sum - divisor1_sum_right) + (divisor1_lo - divisor1_sum_right)))
    l1_lo = ((u1_1_sum - l1_product - product_error(l1, divisor1_sum, l1_product) + u1_1_sum_lo
        - l1_cross) / divisor1_sum)
    u2a = A_20 * l0_1
    u2b = A_22 - u2a
    u2b_right = A_22 - u2b
    u2c = u1_1_sum * l1
    u2 = u2b - u2c
    u2_right = u2b - u2
    u2_lo2 = (u2b - (u2 + u2_right) - product_rest(u1_1_sum, l1, u2c, u2_right)
        - (u1_1_sum_lo * l1 + u1_1_sum * l1_lo))
    u2_lo = (u2_lo2
        + (A_22 - (u2b + u2b_right) - product_rest(A_20, l0_1, u2a, u2b_right) - A_20 * l0_1_lo))
    part0a = A_00 / divisor0
    part0a_product = part0a * divisor0
    part0 = where(divisor0a, part0a, A_00)
    part0_lo = where(divisor0a, (A_00 - part0a_product - product_error(part0a, divisor0,
        part0a_product)) / divisor0, 0)
    own1a = 0 < A_11
    own1 = where(own1a, A_11, 1)
    part1a = u1_0_sum / own1
    part1a_product = part1a * own1
    part1 = where(own1a, part1a, A_11)
    part1_lo = where(own1a, (u1_0_sum - part1a_product - product_error(part1a, own1,
        part1a_product) + u1_0_sum_lo) / own1, 0)
    part0_sum = part0 + part0_lo
    part0_sum_right = part0_sum - part0
    part1_sum = part1 + part1_lo
    part1_sum_right = part1_sum - part1
    smallest1a = part0_sum < part1_sum
    smallest1 = where(smallest1a, part0_sum, part1_sum)
    part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right)
    smallest1_lo = where(smallest1a, part0_sum_lo,
        part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right))
    own2a = 0 < A_22
    own2 = where(own2a, A_22, 1)
    u2_sum = u2 + u2_lo
    u2_sum_right = u2_sum - u2
    part2a = u2_sum / own2
    part2a_product = part2a * own2
    part2 = where(own2a, part2a, A_22)
    part2a_lo = ((u2_sum - part2a_product - product_error(part2a, own2, part2a_product)
        + (u2 - (u2_sum - u2_sum_right) + (u2_lo - u2_sum_right))) / own2)
    part2_lo = where(own2a, part2a_lo, 0)
    smallest1_sum = smallest1 + smallest1_lo
    smallest1_sum_right = smallest1_sum - smallest1
    part2_sum = part2 + part2_lo
    part2_sum_right = part2_sum - part2
    smallest2a = smallest1_sum < part2_sum
    smallest2 = where(smallest2a, smallest1_sum, part2_sum)
    smallest1_sum_lo = (smallest1 - (smallest1_sum - smallest1_sum_right)
        + (smallest1_lo - smallest1_sum_right))
    smallest2_rounded = (smallest2
        + where(smallest2a, smallest1_sum_lo, part2 - (part2_sum - part2_sum_right)
        + (part2_lo - part2_sum_right)))
    l0_0_rounded = l0_0 + l0_0_lo
    u1_0_rounded = u1_0 + u1_0_lo
    l0_1_rounded = l0_1 + l0_1_lo
    l1_rounded = l1 + l1_lo
    u2_rounded = u2 + u2_lo
    smallest2_final = where(smallest2_rounded == smallest2_rounded, smallest2_rounded, smallest2)
    l0_0_final = where(l0_0_rounded == l0_0_rounded, l0_0_rounded, l0_0)
    u1_0_final = where(u1_0_rounded == u1_0_rounded, u1_0_rounded, u1_0)
    l0_1_final = where(l0_1_rounded == l0_1_rounded, l0_1_rounded, l0_1)
    l1_final = where(l1_rounded == l1_rounded, l1_rounded, l1)
    u2_final = where(u2_rounded == u2_rounded, u2_rounded, u2)
    return (smallest2_final, A_00, 0, 0, l0_0_final, u1_0_final, 0, l0_1_final, l1_final, u2_final)


@kernel("(3,3),(3)->(3)")
def mat3x3_ldl_solve(L, b):
    """x = A^-1 b, L of mat3x3_ldl with a positive pivot.

    (3,3),(3)->(3).  L: rotation or other 3×3 matrix; b, x: vector.
    13 mul, 61 add, 3 product error, 6 product rest, 6 div, 3 equal, 3 select.  Backward error,
    of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved; barring
    over- and underflow.
    """
    L_00, L_01, L_02, L_10, L_11, L_12, L_20, L_21, L_22 = L
    b_0, b_1, b_2 = b
    y1a = L_10 * b_0
    y1 = b_1 - y1a
    y1_right = b_1 - y1
    y1_lo = b_1 - (y1 + y1_right) - product_rest(L_10, b_0, y1a, y1_right)
    y2a = L_20 * b_0
    y2b = b_2 - y2a
    y2b_right = b_2 - y2b
    y2c = L_21 * y1
    y2 = y2b - y2c
    y2_right = y2b - y2
    y2_lo2 = y2b - (y2 + y2_right) - product_rest(L_21, y1, y2c, y2_right) - L_21 * y1_lo
    y2_lo = y2_lo2 + (b_2 - (y2b + y2b_right) - product_rest(L_20, b_0, y2a, y2b_right))
    z0 = b_0 / L_00
    z0_product = z0 * L_00
    y1_sum = y1 + y1_lo
    y1_sum_right = y1_sum - y1
    z1 = y1_sum / L_11
    z1_product = z1 * L_11
    y2_sum = y2 + y2_lo
    y2_sum_right = y2_sum - y2
    z2 = y2_sum / L_22
    z2_product = z2 * L_22
    z2_lo = ((y2_sum - z2_product - product_error(z2, L_22, z2_product)
        + (y2 - (y2_sum - y2_sum_right) + (y2_lo - y2_sum_right))) / L_22)
    x1a = L_21 * z2
    x1 = z1 - x1a
    x1_right = z1 - x1
    z1_lo = ((y1_sum - z1_product - product_error(z1, L_11, z1_product)
        + (y1 - (y1_sum - y1_sum_right) + (y1_lo - y1_sum_right))) / L_11)
    x1_lo = z1 - (x1 + x1_right) - product_rest(L_21, z2, x1a, x1_right) - L_21 * z2_lo + z1_lo
    x0a = L_10 * x1
    x0b = z0 - x0a
    x0b_right = z0 - x0b
    x0b_lo2 = z0 - (x0b + x0b_right) - product_rest(L_10, x1, x0a, x0b_right) - L_10 * x1_lo
    x0c = L_20 * z2
    x0 = x0b - x0c
    x0_right = x0b - x0
    x0_lo2 = x0b - (x0 + x0_right) - product_rest(L_20, z2, x0c, x0_right) - L_20 * z2_lo
    x0_rounded = (x0
        + (x0_lo2 + (x0b_lo2 + (b_0 - z0_product - product_error(z0, L_00, z0_product)) / L_00)))
    x1_rounded = x1 + x1_lo
    z2_rounded = z2 + z2_lo
    x0_final = where(x0_rounded == x0_rounded, x0_rounded, x0)
    x1_final = where(x1_rounded == x1_rounded, x1_rounded, x1)
    z2_final = where(z2_rounded == z2_rounded, z2_rounded, z2)
    return (x0_final, x1_final, z2_final)


@kernel("(3,3),(3)->(),(3)")
def mat3x3_solve(A, b):
    """x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
    Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
    rounding or indefinite (A - 50 u diag A is not positive definite).

    (3,3),(3)->(),(3).  A: rotation or other 3×3 matrix; b, x: vector; pivot: number.
    96 mul, 398 add, 16 product error, 31 product rest, 30 div, 11 less, 5 equal, 38 select.
    Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
    barring over- and underflow.
    """
    A_00, A_01, A_02, A_10, A_11, A_12, A_20, A_21, A_22 = A
    b_0, b_1, b_2 = b
    divisor0a = 0 < A_00
    divisor0 = where(divisor0a, A_00, 1)
    l0_0 = A_10 / divisor0
    l0_0_product = l0_0 * divisor0
    l0_0_lo = (A_10 - l0_0_product - product_error(l0_0, divisor0, l0_0_product)) / divisor0
    l0_1 = A_20 / divisor0
    l0_1_product = l0_1 * divisor0
    l0_1_lo = (A_20 - l0_1_product - product_error(l0_1, divisor0, l0_1_product)) / divisor0
    u1_0a = A_10 * l0_0
    u1_0 = A_11 - u1_0a
    u1_0_right = A_11 - u1_0
    u1_0_lo = (A_11 - (u1_0 + u1_0_right) - product_rest(A_10, l0_0, u1_0a, u1_0_right) - A_10
        * l0_0_lo)
    u1_1a = A_20 * l0_0
    u1_1 = A_21 - u1_1a
    u1_1_right = A_21 - u1_1
    u1_1_lo = (A_21 - (u1_1 + u1_1_right) - product_rest(A_20, l0_0, u1_1a, u1_1_right) - A_20
        * l0_0_lo)
    u1_0_sum = u1_0 + u1_0_lo
    u1_0_sum_right = u1_0_sum - u1_0
    u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right)
    divisor1a = 0 < u1_0_sum
    divisor1 = where(divisor1a, u1_0_sum, 1)
    divisor1_lo = where(divisor1a, u1_0_sum_lo, 0)
    u1_1_sum = u1_1 + u1_1_lo
    u1_1_sum_right = u1_1_sum - u1_1
    u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right)
    divisor1_sum = divisor1 + divisor1_lo
    divisor1_sum_right = divisor1_sum - divisor1
    divisor1_sum_lo = (divisor1 - (divisor1_sum - divisor1_sum_right)
        + (divisor1_lo - divisor1_sum_right))
    l1 = u1_1_sum / divisor1_sum
    l1_product = l1 * divisor1_sum
    l1_lo = ((u1_1_sum - l1_product - product_error(l1, divisor1_sum, l1_product) + u1_1_sum_lo
        - l1 * divisor1_sum_lo) / divisor1_sum)
    u2a = A_20 * l0_1
    u2b = A_22 - u2a
    u2b_right = A_22 - u2b
    u2c = u1_1_sum * l1
    u2 = u2b - u2c
    u2_right = u2b - u2
    u2_lo2 = (u2b - (u2 + u2_right) - product_rest(u1_1_sum, l1, u2c, u2_right)
        - (u1_1_sum_lo * l1 + u1_1_sum * l1_lo))
    u2_lo = (u2_lo2
        + (A_22 - (u2b + u2b_right) - product_rest(A_20, l0_1, u2a, u2b_right) - A_20 * l0_1_lo))
    u2_sum = u2 + u2_lo
    u2_sum_right = u2_sum - u2
    u2_sum_lo = u2 - (u2_sum - u2_sum_right) + (u2_lo - u2_sum_right)
    divisor2a = 0 < u2_sum
    divisor2 = where(divisor2a, u2_sum, 1)
    divisor2_lo = where(divisor2a, u2_sum_lo, 0)
    part0a = A_00 / divisor0
    part0a_product = part0a * divisor0
    part0 = where(divisor0a, part0a, A_00)
    part0_lo = where(divisor0a, (A_00 - part0a_product - product_error(part0a, divisor0,
        part0a_product)) / divisor0, 0)
    own1a = 0 < A_11
    own1 = where(own1a, A_11, 1)
    part1a = u1_0_sum / own1
    part1a_product = part1a * own1
    part1 = where(own1a, part1a, A_11)
    part1_lo = where(own1a, (u1_0_sum - part1a_product - product_error(part1a, own1,
        part1a_product) + u1_0_sum_lo) / own1, 0)
    part0_sum = part0 + part0_lo
    part0_sum_right = part0_sum - part0
    part1_sum = part1 + part1_lo
    part1_sum_right = part1_sum - part1
    smallest1a = part0_sum < part1_sum
    smallest1 = where(smallest1a, part0_sum, part1_sum)
    part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right)
    smallest1_lo = where(smallest1a, part0_sum_lo,
        part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right))
    own2a = 0 < A_22
    own2 = where(own2a, A_22, 1)
    part2a = u2_sum / own2
    part2a_product = part2a * own2
    part2 = where(own2a, part2a, A_22)
    part2_lo = where(own2a, (u2_sum - part2a_product - product_error(part2a, own2,
        part2a_product) + u2_sum_lo) / own2, 0)
    smallest1_sum = smallest1 + smallest1_lo
    smallest1_sum_right = smallest1_sum - smallest1
    part2_sum = part2 + part2_lo
    part2_sum_right = part2_sum - part2
    smallest2a = smallest1_sum < part2_sum
    smallest2 = where(smallest2a, smallest1_sum, part2_sum)
    smallest1_sum_lo = (smallest1 - (smallest1_sum - smallest1_sum_right)
        + (smallest1_lo - smallest1_sum_right))
    smallest2_lo = where(smallest2a, smallest1_sum_lo,
        part2 - (part2_sum - part2_sum_right) + (part2_lo - part2_sum_right))
    less_0 = A_00 * 0.9999999999999944
    less_1 = A_11 * 0.9999999999999944
    less_2 = A_22 * 0.9999999999999944
    less_0_lo = product_error(A_00, 0.9999999999999944, less_0)
    less_0_sum = less_0 + less_0_lo
    less_0_sum_right = less_0_sum - less_0
    less_divisor0a = 0 < less_0_sum
    less_divisor0 = where(less_divisor0a, less_0_sum, 1)
    less_divisor0_lo = where(less_divisor0a,
        less_0 - (less_0_sum - less_0_sum_right) + (less_0_lo - less_0_sum_right), 0)
    less_divisor0_sum = less_divisor0 + less_divisor0_lo
    less_divisor0_sum_right = less_divisor0_sum - less_divisor0
    less_divisor0_sum_lo = (less_divisor0 - (less_divisor0_sum - less_divisor0_sum_right)
        + (less_divisor0_lo - less_divisor0_sum_right))
    less_l0_0 = A_10 / less_divisor0_sum
    less_l0_0_product = less_l0_0 * less_divisor0_sum
    less_l0_0_residual = (A_10 - less_l0_0_product
        - product_error(less_l0_0, less_divisor0_sum, less_l0_0_product) - less_l0_0
        * less_divisor0_sum_lo)
    less_l0_0_lo = less_l0_0_residual / less_divisor0_sum
    less_l0_1 = A_20 / less_divisor0_sum
    less_l0_1_product = less_l0_1 * less_divisor0_sum
    less_l0_1_residual = (A_20 - less_l0_1_product
        - product_error(less_l0_1, less_divisor0_sum, less_l0_1_product) - less_l0_1
        * less_divisor0_sum_lo)
    less_u1_0a = A_10 * less_l0_0
    less_u1_0 = less_1 - less_u1_0a
    less_u1_0_right = less_1 - less_u1_0
    less_u1_0_left_rest = product_rest(A_11, 0.9999999999999944, less_1,
        less_u1_0 + less_u1_0_right)
    less_u1_0_lo = (less_u1_0_left_rest
        - product_rest(A_10, less_l0_0, less_u1_0a, less_u1_0_right) - A_10 * less_l0_0_lo)
    less_u1_1a = A_20 * less_l0_0
    less_u1_1 = A_21 - less_u1_1a
    less_u1_1_right = A_21 - less_u1_1
    less_u1_1_lo = (A_21 - (less_u1_1 + less_u1_1_right)
        - product_rest(A_20, less_l0_0, less_u1_1a, less_u1_1_right) - A_20 * less_l0_0_lo)
    less_u1_0_sum = less_u1_0 + less_u1_0_lo
    less_u1_0_sum_right = less_u1_0_sum - less_u1_0
    less_divisor1a = 0 < less_u1_0_sum
    less_divisor1 = where(less_divisor1a, less_u1_0_sum, 1)
    less_divisor1_lo = where(less_divisor1a,
        less_u1_0 - (less_u1_0_sum - less_u1_0_sum_right) + (less_u1_0_lo - less_u1_0_sum_right), 0)
    less_u1_1_sum = less_u1_1 + less_u1_1_lo
    less_u1_1_sum_right = less_u1_1_sum - less_u1_1
    less_u1_1_sum_lo = (less_u1_1 - (less_u1_1_sum - less_u1_1_sum_right)
        + (less_u1_1_lo - less_u1_1_sum_right))
    less_divisor1_sum = less_divisor1 + less_divisor1_lo
    less_divisor1_sum_right = less_divisor1_sum - less_divisor1
    less_l1 = less_u1_1_sum / less_divisor1_sum
    less_l1_product = less_l1 * less_divisor1_sum
    less_l1_cross = (less_l1
        * (less_divisor1 - (less_divisor1_sum - less_divisor1_sum_right)
        + (less_divisor1_lo - less_divisor1_sum_right)))
    less_l1_residual = (less_u1_1_sum - less_l1_product
        - product_error(less_l1, less_divisor1_sum, less_l1_product) + less_u1_1_sum_lo
        - less_l1_cross)
    less_u2a = A_20 * less_l0_1
    less_u2b = less_2 - less_u2a
    less_u2b_right = less_2 - less_u2b
    less_u2b_lo1 = (product_rest(A_22, 0.9999999999999944, less_2, less_u2b + less_u2b_right)
        - product_rest(A_20, less_l0_1, less_u2a, less_u2b_right))
    less_u2c = less_u1_1_sum * less_l1
    less_u2 = less_u2b - less_u2c
    less_u2_right = less_u2b - less_u2
    less_u2_lo1 = (less_u2b - (less_u2 + less_u2_right)
        - product_rest(less_u1_1_sum, less_l1, less_u2c, less_u2_right))
    less_u2_lo2 = (less_u2_lo1
        - (less_u1_1_sum_lo * less_l1 + less_u1_1_sum * (less_l1_residual / less_divisor1_sum)))
    regular_b = where(0 < less_u2 + (less_u2_lo2 + (less_u2b_lo1 - A_20 * (less_l0_1_residual /
        less_divisor0_sum))),
        real(1), real(0))
    regular = where(less_divisor0a, where(less_divisor1a, regular_b, 0), 0)
    smallest2_sum = smallest2 + smallest2_lo
    smallest2_sum_right = smallest2_sum - smallest2
    smallest2_sum_lo = (smallest2 - (smallest2_sum - smallest2_sum_right)
        + (smallest2_lo - smallest2_sum_right))
    least_a = smallest2_sum < 0
    least = where(least_a, smallest2_sum, 0)
    y1a = b_0 * l0_0
    y1 = b_1 - y1a
    y1_right = b_1 - y1
    y1_lo = b_1 - (y1 + y1_right) - product_rest(b_0, l0_0, y1a, y1_right) - b_0 * l0_0_lo
    y2a = b_0 * l0_1
    y2b = b_2 - y2a
    y2b_right = b_2 - y2b
    y2c = l1 * y1
    y2 = y2b - y2c
    y2_right = y2b - y2
    y2_lo2 = y2b - (y2 + y2_right) - product_rest(l1, y1, y2c, y2_right) - (l1_lo * y1 + l1 * y1_lo)
    y2_lo = (y2_lo2
        + (b_2 - (y2b + y2b_right) - product_rest(b_0, l0_1, y2a, y2b_right) - b_0 * l0_1_lo))
    z0 = b_0 / divisor0
    z0_product = z0 * divisor0
    y1_sum = y1 + y1_lo
    y1_sum_right = y1_sum - y1
    z1 = y1_sum / divisor1_sum
    z1_product = z1 * divisor1_sum
    z1_numerator = (y1_sum - z1_product - product_error(z1, divisor1_sum, z1_product)
        + (y1 - (y1_sum - y1_sum_right) + (y1_lo - y1_sum_right)))
    y2_sum = y2 + y2_lo
    y2_sum_right = y2_sum - y2
    divisor2_sum = divisor2 + divisor2_lo
    divisor2_sum_right = divisor2_sum - divisor2
    divisor2_sum_lo = (divisor2 - (divisor2_sum - divisor2_sum_right)
        + (divisor2_lo - divisor2_sum_right))
    z2 = y2_sum / divisor2_sum
    z2_product = z2 * divisor2_sum
    z2_numerator = (y2_sum - z2_product - product_error(z2, divisor2_sum, z2_product)
        + (y2 - (y2_sum - y2_sum_right) + (y2_lo - y2_sum_right)))
    z2_lo = (z2_numerator - z2 * divisor2_sum_lo) / divisor2_sum
    x1a = l1 * z2
    x1 = z1 - x1a
    x1_right = z1 - x1
    x1_lo = (z1 - (x1 + x1_right) - product_rest(l1, z2, x1a, x1_right) - (l1_lo * z2 + l1 * z2_lo)
        + (z1_numerator - z1 * divisor1_sum_lo) / divisor1_sum)
    x0a = l0_0 * x1
    x0b = z0 - x0a
    x0b_right = z0 - x0b
    x0b_lo2 = (z0 - (x0b + x0b_right) - product_rest(l0_0, x1, x0a, x0b_right)
        - (l0_0_lo * x1 + l0_0 * x1_lo))
    x0c = l0_1 * z2
    x0 = x0b - x0c
    x0_right = x0b - x0
    x0_lo2 = (x0b - (x0 + x0_right) - product_rest(l0_1, z2, x0c, x0_right)
        - (l0_1_lo * z2 + l0_1 * z2_lo))
    x0_lo = (x0_lo2
        + (x0b_lo2 + (b_0 - z0_product - product_error(z0, divisor0, z0_product)) / divisor0))
    residual_0a = A_00 * x0
    residual_0b = b_0 - residual_0a
    residual_0b_right = b_0 - residual_0b
    residual_0c = A_10 * x1
    residual_0d = residual_0b - residual_0c
    residual_0d_right = residual_0b - residual_0d
    residual_0d_lo2 = (residual_0b - (residual_0d + residual_0d_right)
        - product_rest(A_10, x1, residual_0c, residual_0d_right) - A_10 * x1_lo)
    residual_0e = A_20 * z2
    residual_0 = residual_0d - residual_0e
    residual_0_right = residual_0d - residual_0
    residual_0d_lo = (residual_0d_lo2
        + (b_0 - (residual_0b + residual_0b_right)
        - product_rest(A_00, x0, residual_0a, residual_0b_right) - A_00 * x0_lo))
    residual_0_lo = (residual_0d - (residual_0 + residual_0_right)
        - product_rest(A_20, z2, residual_0e, residual_0_right) - A_20 * z2_lo + residual_0d_lo)
    residual_1a = A_10 * x0
    residual_1b = b_1 - residual_1a
    residual_1b_right = b_1 - residual_1b
    residual_1c = A_11 * x1
    residual_1d = residual_1b - residual_1c
    residual_1d_right = residual_1b - residual_1d
    residual_1d_lo2 = (residual_1b - (residual_1d + residual_1d_right)
        - product_rest(A_11, x1, residual_1c, residual_1d_right) - A_11 * x1_lo)
    residual_1e = A_21 * z2
    residual_1 = residual_1d - residual_1e
    residual_1_right = residual_1d - residual_1
    residual_1d_lo = (residual_1d_lo2
        + (b_1 - (residual_1b + residual_1b_right)
        - product_rest(A_10, x0, residual_1a, residual_1b_right) - A_10 * x0_lo))
    residual_2a = A_20 * x0
    residual_2b = b_2 - residual_2a
    residual_2b_right = b_2 - residual_2b
    residual_2c = A_21 * x1
    residual_2d = residual_2b - residual_2c
    residual_2d_right = residual_2b - residual_2d
    residual_2d_lo2 = (residual_2b - (residual_2d + residual_2d_right)
        - product_rest(A_21, x1, residual_2c, residual_2d_right) - A_21 * x1_lo)
    residual_2e = A_22 * z2
    residual_2 = residual_2d - residual_2e
    residual_2_right = residual_2d - residual_2
    residual_2d_lo = (residual_2d_lo2
        + (b_2 - (residual_2b + residual_2b_right)
        - product_rest(A_20, x0, residual_2a, residual_2b_right) - A_20 * x0_lo))
    refined_y1a = l0_0 * residual_0
    refined_y1 = residual_1 - refined_y1a
    refined_y1_right = residual_1 - refined_y1
    refined_y1_lo1 = (residual_1 - (refined_y1 + refined_y1_right)
        - product_rest(l0_0, residual_0, refined_y1a, refined_y1_right))
    residual_1_lo = (residual_1d - (residual_1 + residual_1_right)
        - product_rest(A_21, z2, residual_1e, residual_1_right) - A_21 * z2_lo + residual_1d_lo)
    refined_y1_lo = refined_y1_lo1 - (l0_0_lo * residual_0 + l0_0 * residual_0_lo) + residual_1_lo
    refined_y2a = l0_1 * residual_0
    refined_y2b = residual_2 - refined_y2a
    refined_y2b_right = residual_2 - refined_y2b
    refined_y2b_lo1 = (residual_2 - (refined_y2b + refined_y2b_right)
        - product_rest(l0_1, residual_0, refined_y2a, refined_y2b_right))
    residual_2_lo = (residual_2d - (residual_2 + residual_2_right)
        - product_rest(A_22, z2, residual_2e, residual_2_right) - A_22 * z2_lo + residual_2d_lo)
    refined_y2c = l1 * refined_y1
    refined_y2 = refined_y2b - refined_y2c
    refined_y2_right = refined_y2b - refined_y2
    refined_y2_lo1 = (refined_y2b - (refined_y2 + refined_y2_right)
        - product_rest(l1, refined_y1, refined_y2c, refined_y2_right))
    refined_y2b_lo = refined_y2b_lo1 - (l0_1_lo * residual_0 + l0_1 * residual_0_lo) + residual_2_lo
    refined_y2_lo = refined_y2_lo1 - (l1_lo * refined_y1 + l1 * refined_y1_lo) + refined_y2b_lo
    residual_0_sum = residual_0 + residual_0_lo
    residual_0_sum_right = residual_0_sum - residual_0
    refined_z0 = residual_0_sum / divisor0
    refined_z0_product = refined_z0 * divisor0
    refined_z0_exact = (residual_0_sum - refined_z0_product
        - product_error(refined_z0, divisor0, refined_z0_product))
    refined_y1_sum = refined_y1 + refined_y1_lo
    refined_y1_sum_right = refined_y1_sum - refined_y1
    refined_z1 = refined_y1_sum / divisor1_sum
    refined_z1_product = refined_z1 * divisor1_sum
    refined_z1_exact = (refined_y1_sum - refined_z1_product
        - product_error(refined_z1, divisor1_sum, refined_z1_product))
    refined_z1_numerator = (refined_z1_exact
        + (refined_y1 - (refined_y1_sum - refined_y1_sum_right)
        + (refined_y1_lo - refined_y1_sum_right)))
    refined_y2_sum = refined_y2 + refined_y2_lo
    refined_y2_sum_right = refined_y2_sum - refined_y2
    refined_z2 = refined_y2_sum / divisor2_sum
    refined_z2_product = refined_z2 * divisor2_sum
    refined_z2_exact = (refined_y2_sum - refined_z2_product
        - product_error(refined_z2, divisor2_sum, refined_z2_product))
    refined_z2_numerator = (refined_z2_exact
        + (refined_y2 - (refined_y2_sum - refined_y2_sum_right)
        + (refined_y2_lo - refined_y2_sum_right)))
    refined_z2_lo = (refined_z2_numerator - refined_z2 * divisor2_sum_lo) / divisor2_sum
    refined_x1a = l1 * refined_z2
    refined_x1 = refined_z1 - refined_x1a
    refined_x1_right = refined_z1 - refined_x1
    refined_x1_lo1 = (refined_z1 - (refined_x1 + refined_x1_right)
        - product_rest(l1, refined_z2, refined_x1a, refined_x1_right))
    refined_x1_lo = (refined_x1_lo1 - (l1_lo * refined_z2 + l1 * refined_z2_lo)
        + (refined_z1_numerator - refined_z1 * divisor1_sum_lo) / divisor1_sum)
    refined_x0a = l0_0 * refined_x1
    refined_x0b = refined_z0 - refined_x0a
    refined_x0b_right = refined_z0 - refined_x0b
    refined_x0b_lo1 = (refined_z0 - (refined_x0b + refined_x0b_right)
        - product_rest(l0_0, refined_x1, refined_x0a, refined_x0b_right))
    refined_z0_lo = ((refined_z0_exact
        + (residual_0 - (residual_0_sum - residual_0_sum_right)
        + (residual_0_lo - residual_0_sum_right))) / divisor0)
    refined_x0c = l0_1 * refined_z2
    refined_x0 = refined_x0b - refined_x0c
    refined_x0_right = refined_x0b - refined_x0
    refined_x0_lo1 = (refined_x0b - (refined_x0 + refined_x0_right)
        - product_rest(l0_1, refined_z2, refined_x0c, refined_x0_right))
    refined_x0b_lo = refined_x0b_lo1 - (l0_0_lo * refined_x1 + l0_0 * refined_x1_lo) + refined_z0_lo
    found_0 = x0 + refined_x0
    found_0_right = found_0 - x0
    refined_x0_lo = refined_x0_lo1 - (l0_1_lo * refined_z2 + l0_1 * refined_z2_lo) + refined_x0b_lo
    found_1 = x1 + refined_x1
    found_1_right = found_1 - x1
    found_2 = z2 + refined_z2
    found_2_right = found_2 - z2
    pivot_a = regular == 1
    pivot = where(pivot_a, smallest2_sum, least)
    x_0 = where(pivot_a, found_0, nan)
    x_1 = where(pivot_a, found_1, nan)
    x_2 = where(pivot_a, found_2, nan)
    pivot_rounded = pivot + where(pivot_a, smallest2_sum_lo, where(least_a, smallest2_sum_lo, 0))
    x_0_rounded = (x_0
        + where(pivot_a, x0 - (found_0 - found_0_right) + (refined_x0 - found_0_right)
        + refined_x0_lo + x0_lo, 0))
    x_1_rounded = (x_1
        + where(pivot_a, x1 - (found_1 - found_1_right) + (refined_x1 - found_1_right)
        + refined_x1_lo + x1_lo, 0))
    x_2_rounded = (x_2
        + where(pivot_a, z2 - (found_2 - found_2_right) + (refined_z2 - found_2_right)
        + refined_z2_lo + z2_lo, 0))
    pivot_final = where(pivot_rounded == pivot_rounded, pivot_rounded, pivot)
    x_0_final = where(x_0_rounded == x_0_rounded, x_0_rounded, x_0)
    x_1_final = where(x_1_rounded == x_1_rounded, x_1_rounded, x_1)
    x_2_final = where(x_2_rounded == x_2_rounded, x_2_rounded, x_2)
    return (pivot_final, x_0_final, x_1_final, x_2_final)


@kernel("(6,6)->(),(6,6)")
def mat6x6_ldl(A):
    """L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
    triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
    not positive definite, and L is meaningless.

    (6,6)->(),(6,6).  A, L: 6×6 operator; pivot: number.
    121 mul, 512 add, 21 product error, 35 product rest, 42 div, 15 less, 21 equal, 57 select.
    |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where the pivot is positive, barring over- and
    underflow.
    """
    (A_00, A_01, A_02, A_03, A_04, A_05, A_10, A_11, A_12, A_13, A_14, A_15, A_20, A_21, A_22, A_23,
        A_24, A_25, A_30, A_31, A_32, A_33, A_34, A_35, A_40, A_41, A_42, A_43, A_44, A_45, A_50,
        A_51, A_52, A_53, A_54, A_55) = A
    divisor0a = 0 < A_00
    divisor0 = where(divisor0a, A_00, 1)
    l0_0 = A_10 / divisor0
    l0_0_product = l0_0 * divisor0
    l0_0_lo = (A_10 - l0_0_product - product_error(l0_0, divisor0, l0_0_product)) / divisor0
    l0_1 = A_20 / divisor0
    l0_1_product = l0_1 * divisor0
    l0_1_lo = (A_20 - l0_1_product - product_error(l0_1, divisor0, l0_1_product)) / divisor0
    l0_2 = A_30 / divisor0
    l0_2_product = l0_2 * divisor0
    l0_2_lo = (A_30 - l0_2_product - product_error(l0_2, divisor0, l0_2_product)) / divisor0
    l0_3 = A_40 / divisor0
    l0_3_product = l0_3 * divisor0
    l0_3_lo = (A_40 - l0_3_product - product_error(l0_3, divisor0, l0_3_product)) / divisor0
    l0_4 = A_50 / divisor0
    l0_4_product = l0_4 * divisor0
    l0_4_lo = (A_50 - l0_4_product - product_error(l0_4, divisor0, l0_4_product)) / divisor0
    u1_0a = A_10 * l0_0
    u1_0 = A_11 - u1_0a
    u1_0_right = A_11 - u1_0
    u1_0_lo = (A_11 - (u1_0 + u1_0_right) - product_rest(A_10, l0_0, u1_0a, u1_0_right) - A_10
        * l0_0_lo)
    u1_1a = A_20 * l0_0
    u1_1 = A_21 - u1_1a
    u1_1_right = A_21 - u1_1
    u1_1_lo = (A_21 - (u1_1 + u1_1_right) - product_rest(A_20, l0_0, u1_1a, u1_1_right) - A_20
        * l0_0_lo)
    u1_2a = A_30 * l0_0
    u1_2 = A_31 - u1_2a
    u1_2_right = A_31 - u1_2
    u1_2_lo = (A_31 - (u1_2 + u1_2_right) - product_rest(A_30, l0_0, u1_2a, u1_2_right) - A_30
        * l0_0_lo)
    u1_3a = A_40 * l0_0
    u1_3 = A_41 - u1_3a
    u1_3_right = A_41 - u1_3
    u1_3_lo = (A_41 - (u1_3 + u1_3_right) - product_rest(A_40, l0_0, u1_3a, u1_3_right) - A_40
        * l0_0_lo)
    u1_4a = A_50 * l0_0
    u1_4 = A_51 - u1_4a
    u1_4_right = A_51 - u1_4
    u1_4_lo = (A_51 - (u1_4 + u1_4_right) - product_rest(A_50, l0_0, u1_4a, u1_4_right) - A_50
        * l0_0_lo)
    u1_0_sum = u1_0 + u1_0_lo
    u1_0_sum_right = u1_0_sum - u1_0
    u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right)
    divisor1a = 0 < u1_0_sum
    divisor1 = where(divisor1a, u1_0_sum, 1)
    divisor1_lo = where(divisor1a, u1_0_sum_lo, 0)
    u1_1_sum = u1_1 + u1_1_lo
    u1_1_sum_right = u1_1_sum - u1_1
    u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right)
    divisor1_sum = divisor1 + divisor1_lo
    divisor1_sum_right = divisor1_sum - divisor1
    divisor1_sum_lo = (divisor1 - (divisor1_sum - divisor1_sum_right)
        + (divisor1_lo - divisor1_sum_right))
    l1_0 = u1_1_sum / divisor1_sum
    l1_0_product = l1_0 * divisor1_sum
    l1_0_lo = ((u1_1_sum - l1_0_product - product_error(l1_0, divisor1_sum, l1_0_product)
        + u1_1_sum_lo - l1_0 * divisor1_sum_lo) / divisor1_sum)
    u1_2_sum = u1_2 + u1_2_lo
    u1_2_sum_right = u1_2_sum - u1_2
    u1_2_sum_lo = u1_2 - (u1_2_sum - u1_2_sum_right) + (u1_2_lo - u1_2_sum_right)
    l1_1 = u1_2_sum / divisor1_sum
    l1_1_product = l1_1 * divisor1_sum
    l1_1_lo = ((u1_2_sum - l1_1_product - product_error(l1_1, divisor1_sum, l1_1_product)
        + u1_2_sum_lo - l1_1 * divisor1_sum_lo) / divisor1_sum)
    u1_3_sum = u1_3 + u1_3_lo
    u1_3_sum_right = u1_3_sum - u1_3
    u1_3_sum_lo = u1_3 - (u1_3_sum - u1_3_sum_right) + (u1_3_lo - u1_3_sum_right)
    l1_2 = u1_3_sum / divisor1_sum
    l1_2_product = l1_2 * divisor1_sum
    l1_2_lo = ((u1_3_sum - l1_2_product - product_error(l1_2, divisor1_sum, l1_2_product)
        + u1_3_sum_lo - l1_2 * divisor1_sum_lo) / divisor1_sum)
    u1_4_sum = u1_4 + u1_4_lo
    u1_4_sum_right = u1_4_sum - u1_4
    u1_4_sum_lo = u1_4 - (u1_4_sum - u1_4_sum_right) + (u1_4_lo - u1_4_sum_right)
    l1_3 = u1_4_sum / divisor1_sum
    l1_3_product = l1_3 * divisor1_sum
    l1_3_lo = ((u1_4_sum - l1_3_product - product_error(l1_3, divisor1_sum, l1_3_product)
        + u1_4_sum_lo - l1_3 * divisor1_sum_lo) / divisor1_sum)
    u2_0a = A_20 * l0_1
    u2_0b = A_22 - u2_0a
    u2_0b_right = A_22 - u2_0b
    u2_0c = u1_1_sum * l1_0
    u2_0 = u2_0b - u2_0c
    u2_0_right = u2_0b - u2_0
    u2_0_lo2 = (u2_0b - (u2_0 + u2_0_right) - product_rest(u1_1_sum, l1_0, u2_0c, u2_0_right)
        - (u1_1_sum_lo * l1_0 + u1_1_sum * l1_0_lo))
    u2_0_lo = (u2_0_lo2
        + (A_22 - (u2_0b + u2_0b_right) - product_rest(A_20, l0_1, u2_0a, u2_0b_right) - A_20
        * l0_1_lo))
    u2_1a = A_30 * l0_1
    u2_1b = A_32 - u2_1a
    u2_1b_right = A_32 - u2_1b
    u2_1c = u1_2_sum * l1_0
    u2_1 = u2_1b - u2_1c
    u2_1_right = u2_1b - u2_1
    u2_1_lo2 = (u2_1b - (u2_1 + u2_1_right) - product_rest(u1_2_sum, l1_0, u2_1c, u2_1_right)
        - (u1_2_sum_lo * l1_0 + u1_2_sum * l1_0_lo))
    u2_1_lo = (u2_1_lo2
        + (A_32 - (u2_1b + u2_1b_right) - product_rest(A_30, l0_1, u2_1a, u2_1b_right) - A_30
        * l0_1_lo))
    u2_2a = A_40 * l0_1
    u2_2b = A_42 - u2_2a
    u2_2b_right = A_42 - u2_2b
    u2_2c = u1_3_sum * l1_0
    u2_2 = u2_2b - u2_2c
    u2_2_right = u2_2b - u2_2
    u2_2_lo2 = (u2_2b - (u2_2 + u2_2_right) - product_rest(u1_3_sum, l1_0, u2_2c, u2_2_right)
        - (u1_3_sum_lo * l1_0 + u1_3_sum * l1_0_lo))
    u2_2_lo = (u2_2_lo2
        + (A_42 - (u2_2b + u2_2b_right) - product_rest(A_40, l0_1, u2_2a, u2_2b_right) - A_40
        * l0_1_lo))
    u2_3a = A_50 * l0_1
    u2_3b = A_52 - u2_3a
    u2_3b_right = A_52 - u2_3b
    u2_3c = u1_4_sum * l1_0
    u2_3 = u2_3b - u2_3c
    u2_3_right = u2_3b - u2_3
    u2_3_lo2 = (u2_3b - (u2_3 + u2_3_right) - product_rest(u1_4_sum, l1_0, u2_3c, u2_3_right)
        - (u1_4_sum_lo * l1_0 + u1_4_sum * l1_0_lo))
    u2_3_lo = (u2_3_lo2
        + (A_52 - (u2_3b + u2_3b_right) - product_rest(A_50, l0_1, u2_3a, u2_3b_right) - A_50
        * l0_1_lo))
    u2_0_sum = u2_0 + u2_0_lo
    u2_0_sum_right = u2_0_sum - u2_0
    u2_0_sum_lo = u2_0 - (u2_0_sum - u2_0_sum_right) + (u2_0_lo - u2_0_sum_right)
    divisor2a = 0 < u2_0_sum
    divisor2 = where(divisor2a, u2_0_sum, 1)
    divisor2_lo = where(divisor2a, u2_0_sum_lo, 0)
    u2_1_sum = u2_1 + u2_1_lo
    u2_1_sum_right = u2_1_sum - u2_1
    u2_1_sum_lo = u2_1 - (u2_1_sum - u2_1_sum_right) + (u2_1_lo - u2_1_sum_right)
    divisor2_sum = divisor2 + divisor2_lo
    divisor2_sum_right = divisor2_sum - divisor2
    divisor2_sum_lo = (divisor2 - (divisor2_sum - divisor2_sum_right)
        + (divisor2_lo - divisor2_sum_right))
    l2_0 = u2_1_sum / divisor2_sum
    l2_0_product = l2_0 * divisor2_sum
    l2_0_lo = ((u2_1_sum - l2_0_product - product_error(l2_0, divisor2_sum, l2_0_product)
        + u2_1_sum_lo - l2_0 * divisor2_sum_lo) / divisor2_sum)
    u2_2_sum = u2_2 + u2_2_lo
    u2_2_sum_right = u2_2_sum - u2_2
    u2_2_sum_lo = u2_2 - (u2_2_sum - u2_2_sum_right) + (u2_2_lo - u2_2_sum_right)
    l2_1 = u2_2_sum / divisor2_sum
    l2_1_product = l2_1 * divisor2_sum
    l2_1_lo = ((u2_2_sum - l2_1_product - product_error(l2_1, divisor2_sum, l2_1_product)
        + u2_2_sum_lo - l2_1 * divisor2_sum_lo) / divisor2_sum)
    u2_3_sum = u2_3 + u2_3_lo
    u2_3_sum_right = u2_3_sum - u2_3
    u2_3_sum_lo = u2_3 - (u2_3_sum - u2_3_sum_right) + (u2_3_lo - u2_3_sum_right)
    l2_2 = u2_3_sum / divisor2_sum
    l2_2_product = l2_2 * divisor2_sum
    l2_2_lo = ((u2_3_sum - l2_2_product - product_error(l2_2, divisor2_sum, l2_2_product)
        + u2_3_sum_lo - l2_2 * divisor2_sum_lo) / divisor2_sum)
    u3_0a = A_30 * l0_2
    u3_0b = A_33 - u3_0a
    u3_0b_right = A_33 - u3_0b
    u3_0c = u1_2_sum * l1_1
    u3_0d = u3_0b - u3_0c
    u3_0d_right = u3_0b - u3_0d
    u3_0d_lo2 = (u3_0b - (u3_0d + u3_0d_right) - product_rest(u1_2_sum, l1_1, u3_0c, u3_0d_right)
        - (u1_2_sum_lo * l1_1 + u1_2_sum * l1_1_lo))
    u3_0e = u2_1_sum * l2_0
    u3_0 = u3_0d - u3_0e
    u3_0_right = u3_0d - u3_0
    u3_0_lo2 = (u3_0d - (u3_0 + u3_0_right) - product_rest(u2_1_sum, l2_0, u3_0e, u3_0_right)
        - (u2_1_sum_lo * l2_0 + u2_1_sum * l2_0_lo))
    u3_0_lo = (u3_0_lo2
        + (u3_0d_lo2
        + (A_33 - (u3_0b + u3_0b_right) - product_rest(A_30, l0_2, u3_0a, u3_0b_right) - A_30
        * l0_2_lo)))
    u3_1a = A_40 * l0_2
    u3_1b = A_43 - u3_1a
    u3_1b_right = A_43 - u3_1b
    u3_1c = u1_3_sum * l1_1
    u3_1d = u3_1b - u3_1c
    u3_1d_right = u3_1b - u3_1d
    u3_1d_lo2 = (u3_1b - (u3_1d + u3_1d_right) - product_rest(u1_3_sum, l1_1, u3_1c, u3_1d_right)
        - (u1_3_sum_lo * l1_1 + u1_3_sum * l1_1_lo))
    u3_1e = u2_2_sum * l2_0
    u3_1 = u3_1d - u3_1e
    u3_1_right = u3_1d - u3_1
    u3_1_lo2 = (u3_1d - (u3_1 + u3_1_right) - product_rest(u2_2_sum, l2_0, u3_1e, u3_1_right)
        - (u2_2_sum_lo * l2_0 + u2_2_sum * l2_0_lo))
    u3_1_lo = (u3_1_lo2
        + (u3_1d_lo2
        + (A_43 - (u3_1b + u3_1b_right) - product_rest(A_40, l0_2, u3_1a, u3_1b_right) - A_40
        * l0_2_lo)))
    u3_2a = A_50 * l0_2
    u3_2b = A_53 - u3_2a
    u3_2b_right = A_53 - u3_2b
    u3_2c = u1_4_sum * l1_1
    u3_2d = u3_2b - u3_2c
    u3_2d_right = u3_2b - u3_2d
    u3_2d_lo2 = (u3_2b - (u3_2d + u3_2d_right) - product_rest(u1_4_sum, l1_1, u3_2c, u3_2d_right)
        - (u1_4_sum_lo * l1_1 + u1_4_sum * l1_1_lo))
    u3_2e = u2_3_sum * l2_0
    u3_2 = u3_2d - u3_2e
    u3_2_right = u3_2d - u3_2
    u3_2_lo2 = (u3_2d - (u3_2 + u3_2_right) - product_rest(u2_3_sum, l2_0, u3_2e, u3_2_right)
        - (u2_3_sum_lo * l2_0 + u2_3_sum * l2_0_lo))
    u3_2_lo = (u3_2_lo2
        + (u3_2d_lo2
        + (A_53 - (u3_2b + u3_2b_right) - product_rest(A_50, l0_2, u3_2a, u3_2b_right) - A_50
        * l0_2_lo)))
    u3_0_sum = u3_0 + u3_0_lo
    u3_0_sum_right = u3_0_sum - u3_0
    u3_0_sum_lo = u3_0 - (u3_0_sum - u3_0_sum_right) + (u3_0_lo - u3_0_sum_right)
    divisor3a = 0 < u3_0_sum
    divisor3 = where(divisor3a, u3_0_sum, 1)
    divisor3_lo = where(divisor3a, u3_0_sum_lo, 0)
    u3_1_sum = u3_1 + u3_1_lo
    u3_1_sum_right = u3_1_sum - u3_1
    u3_1_sum_lo = u3_1 - (u3_1_sum - u3_1_sum_right) + (u3_1_lo - u3_1_sum_right)
    divisor3_sum = divisor3 + divisor3_lo
    divisor3_sum_right = divisor3_sum - divisor3
    divisor3_sum_lo = (divisor3 - (divisor3_sum - divisor3_sum_right)
        + (divisor3_lo - divisor3_sum_right))
    l3_0 = u3_1_sum / divisor3_sum
    l3_0_product = l3_0 * divisor3_sum
    l3_0_lo = ((u3_1_sum - l3_0_product - product_error(l3_0, divisor3_sum, l3_0_product)
        + u3_1_sum_lo - l3_0 * divisor3_sum_lo) / divisor3_sum)
    u3_2_sum = u3_2 + u3_2_lo
    u3_2_sum_right = u3_2_sum - u3_2
    u3_2_sum_lo = u3_2 - (u3_2_sum - u3_2_sum_right) + (u3_2_lo - u3_2_sum_right)
    l3_1 = u3_2_sum / divisor3_sum
    l3_1_product = l3_1 * divisor3_sum
    l3_1_lo = ((u3_2_sum - l3_1_product - product_error(l3_1, divisor3_sum, l3_1_product)
        + u3_2_sum_lo - l3_1 * divisor3_sum_lo) / divisor3_sum)
    u4_0a = A_40 * l0_3
    u4_0b = A_44 - u4_0a
    u4_0b_right = A_44 - u4_0b
    u4_0c = u1_3_sum * l1_2
    u4_0d = u4_0b - u4_0c
    u4_0d_right = u4_0b - u4_0d
    u4_0d_lo2 = (u4_0b - (u4_0d + u4_0d_right) - product_rest(u1_3_sum, l1_2, u4_0c, u4_0d_right)
        - (u1_3_sum_lo * l1_2 + u1_3_sum * l1_2_lo))
    u4_0e = u2_2_sum * l2_1
    u4_0f = u4_0d - u4_0e
    u4_0f_right = u4_0d - u4_0f
    u4_0f_lo2 = (u4_0d - (u4_0f + u4_0f_right) - product_rest(u2_2_sum, l2_1, u4_0e, u4_0f_right)
        - (u2_2_sum_lo * l2_1 + u2_2_sum * l2_1_lo))
    u4_0g = u3_1_sum * l3_0
    u4_0 = u4_0f - u4_0g
    u4_0_right = u4_0f - u4_0
    u4_0_lo2 = (u4_0f - (u4_0 + u4_0_right) - product_rest(u3_1_sum, l3_0, u4_0g, u4_0_right)
        - (u3_1_sum_lo * l3_0 + u3_1_sum * l3_0_lo))
    u4_0_lo = (u4_0_lo2
        + (u4_0f_lo2
        + (u4_0d_lo2
        + (A_44 - (u4_0b + u4_0b_right) - product_rest(A_40, l0_3, u4_0a, u4_0b_right) - A_40
        * l0_3_lo))))
    u4_1a = A_50 * l0_3
    u4_1b = A_54 - u4_1a
    u4_1b_right = A_54 - u4_1b
    u4_1c = u1_4_sum * l1_2
    u4_1d = u4_1b - u4_1c
    u4_1d_right = u4_1b - u4_1d
    u4_1d_lo2 = (u4_1b - (u4_1d + u4_1d_right) - product_rest(u1_4_sum, l1_2, u4_1c, u4_1d_right)
        - (u1_4_sum_lo * l1_2 + u1_4_sum * l1_2_lo))
    u4_1e = u2_3_sum * l2_1
    u4_1f = u4_1d - u4_1e
    u4_1f_right = u4_1d - u4_1f
    u4_1f_lo2 = (u4_1d - (u4_1f + u4_1f_right) - product_rest(u2_3_sum, l2_1, u4_1e, u4_1f_right)
        - (u2_3_sum_lo * l2_1 + u2_3_sum * l2_1_lo))
    u4_1g = u3_2_sum * l3_0
    u4_1 = u4_1f - u4_1g
    u4_1_right = u4_1f - u4_1
    u4_1_lo2 = (u4_1f - (u4_1 + u4_1_right) - product_rest(u3_2_sum, l3_0, u4_1g, u4_1_right)
        - (u3_2_sum_lo * l3_0 + u3_2_sum * l3_0_lo))
    u4_1_lo = (u4_1_lo2
        + (u4_1f_lo2
        + (u4_1d_lo2
        + (A_54 - (u4_1b + u4_1b_right) - product_rest(A_50, l0_3, u4_1a, u4_1b_right) - A_50
        * l0_3_lo))))
    u4_0_sum = u4_0 + u4_0_lo
    u4_0_sum_right = u4_0_sum - u4_0
    u4_0_sum_lo = u4_0 - (u4_0_sum - u4_0_sum_right) + (u4_0_lo - u4_0_sum_right)
    divisor4a = 0 < u4_0_sum
    divisor4 = where(divisor4a, u4_0_sum, 1)
    divisor4_lo = where(divisor4a, u4_0_sum_lo, 0)
    u4_1_sum = u4_1 + u4_1_lo
    u4_1_sum_right = u4_1_sum - u4_1
    u4_1_sum_lo = u4_1 - (u4_1_sum - u4_1_sum_right) + (u4_1_lo - u4_1_sum_right)
    divisor4_sum = divisor4 + divisor4_lo
    divisor4_sum_right = divisor4_sum - divisor4
    l4 = u4_1_sum / divisor4_sum
    l4_product = l4 * divisor4_sum
    l4_cross = (l4
        * (divisor4 - (divisor4_sum - divisor4_sum_right) + (divisor4_lo - divisor4_sum_right)))
    l4_lo = ((u4_1_sum - l4_product - product_error(l4, divisor4_sum, l4_product) + u4_1_sum_lo
        - l4_cross) / divisor4_sum)
    u5a = A_50 * l0_4
    u5b = A_55 - u5a
    u5b_right = A_55 - u5b
    u5c = u1_4_sum * l1_3
    u5d = u5b - u5c
    u5d_right = u5b - u5d
    u5d_lo2 = (u5b - (u5d + u5d_right) - product_rest(u1_4_sum, l1_3, u5c, u5d_right)
        - (u1_4_sum_lo * l1_3 + u1_4_sum * l1_3_lo))
    u5e = u2_3_sum * l2_2
    u5f = u5d - u5e
    u5f_right = u5d - u5f
    u5f_lo2 = (u5d - (u5f + u5f_right) - product_rest(u2_3_sum, l2_2, u5e, u5f_right)
        - (u2_3_sum_lo * l2_2 + u2_3_sum * l2_2_lo))
    u5g = u3_2_sum * l3_1
    u5h = u5f - u5g
    u5h_right = u5f - u5h
    u5h_lo2 = (u5f - (u5h + u5h_right) - product_rest(u3_2_sum, l3_1, u5g, u5h_right)
        - (u3_2_sum_lo * l3_1 + u3_2_sum * l3_1_lo))
    u5i = u4_1_sum * l4
    u5 = u5h - u5i
    u5_right = u5h - u5
    u5h_lo = (u5h_lo2
        + (u5f_lo2
        + (u5d_lo2
        + (A_55 - (u5b + u5b_right) - product_rest(A_50, l0_4, u5a, u5b_right) - A_50 * l0_4_lo))))
    u5_lo = (u5h - (u5 + u5_right) - product_rest(u4_1_sum, l4, u5i, u5_right)
        - (u4_1_sum_lo * l4 + u4_1_sum * l4_lo) + u5h_lo)
    part0a = A_00 / divisor0
    part0a_product = part0a * divisor0
    part0 = where(divisor0a, part0a, A_00)
    part0_lo = where(divisor0a, (A_00 - part0a_product - product_error(part0a, divisor0,
        part0a_product)) / divisor0, 0)
    own1a = 0 < A_11
    own1 = where(own1a, A_11, 1)
    part1a = u1_0_sum / own1
    part1a_product = part1a * own1
    part1 = where(own1a, part1a, A_11)
    part1_lo = where(own1a, (u1_0_sum - part1a_product - product_error(part1a, own1,
        part1a_product) + u1_0_sum_lo) / own1, 0)
    part0_sum = part0 + part0_lo
    part0_sum_right = part0_sum - part0
    part1_sum = part1 + part1_lo
    part1_sum_right = part1_sum - part1
    smallest1a = part0_sum < part1_sum
    smallest1 = where(smallest1a, part0_sum, part1_sum)
    part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right)
    smallest1_lo = where(smallest1a, part0_sum_lo,
        part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right))
    own2a = 0 < A_22
    own2 = where(own2a, A_22, 1)
    part2a = u2_0_sum / own2
    part2a_product = part2a * own2
    part2 = where(own2a, part2a, A_22)
    part2_lo = where(own2a, (u2_0_sum - part2a_product - product_error(part2a, own2,
        part2a_product) + u2_0_sum_lo) / own2, 0)
    smallest1_sum = smallest1 + smallest1_lo
    smallest1_sum_right = smallest1_sum - smallest1
    part2_sum = part2 + part2_lo
    part2_sum_right = part2_sum - part2
    smallest2a = smallest1_sum < part2_sum
    smallest2 = where(smallest2a, smallest1_sum, part2_sum)
    smallest1_sum_lo = (smallest1 - (smallest1_sum - smallest1_sum_right)
        + (smallest1_lo - smallest1_sum_right))
    smallest2_lo = where(smallest2a, smallest1_sum_lo,
        part2 - (part2_sum - part2_sum_right) + (part2_lo - part2_sum_right))
    own3a = 0 < A_33
    own3 = where(own3a, A_33, 1)
    part3a = u3_0_sum / own3
    part3a_product = part3a * own3
    part3 = where(own3a, part3a, A_33)
    part3_lo = where(own3a, (u3_0_sum - part3a_product - product_error(part3a, own3,
        part3a_product) + u3_0_sum_lo) / own3, 0)
    smallest2_sum = smallest2 + smallest2_lo
    smallest2_sum_right = smallest2_sum - smallest2
    part3_sum = part3 + part3_lo
    part3_sum_right = part3_sum - part3
    smallest3a = smallest2_sum < part3_sum
    smallest3 = where(smallest3a, smallest2_sum, part3_sum)
    smallest2_sum_lo = (smallest2 - (smallest2_sum - smallest2_sum_right)
        + (smallest2_lo - smallest2_sum_right))
    smallest3_lo = where(smallest3a, smallest2_sum_lo,
        part3 - (part3_sum - part3_sum_right) + (part3_lo - part3_sum_right))
    own4a = 0 < A_44
    own4 = where(own4a, A_44, 1)
    part4a = u4_0_sum / own4
    part4a_product = part4a * own4
    part4 = where(own4a, part4a, A_44)
    part4_lo = where(own4a, (u4_0_sum - part4a_product - product_error(part4a, own4,
        part4a_product) + u4_0_sum_lo) / own4, 0)
    smallest3_sum = smallest3 + smallest3_lo
    smallest3_sum_right = smallest3_sum - smallest3
    part4_sum = part4 + part4_lo
    part4_sum_right = part4_sum - part4
    smallest4a = smallest3_sum < part4_sum
    smallest4 = where(smallest4a, smallest3_sum, part4_sum)
    smallest3_sum_lo = (smallest3 - (smallest3_sum - smallest3_sum_right)
        + (smallest3_lo - smallest3_sum_right))
    smallest4_lo = where(smallest4a, smallest3_sum_lo,
        part4 - (part4_sum - part4_sum_right) + (part4_lo - part4_sum_right))
    own5a = 0 < A_55
    own5 = where(own5a, A_55, 1)
    u5_sum = u5 + u5_lo
    u5_sum_right = u5_sum - u5
    part5a = u5_sum / own5
    part5a_product = part5a * own5
    part5 = where(own5a, part5a, A_55)
    part5a_lo = ((u5_sum - part5a_product - product_error(part5a, own5, part5a_product)
        + (u5 - (u5_sum - u5_sum_right) + (u5_lo - u5_sum_right))) / own5)
    part5_lo = where(own5a, part5a_lo, 0)
    smallest4_sum = smallest4 + smallest4_lo
    smallest4_sum_right = smallest4_sum - smallest4
    part5_sum = part5 + part5_lo
    part5_sum_right = part5_sum - part5
    smallest5a = smallest4_sum < part5_sum
    smallest5 = where(smallest5a, smallest4_sum, part5_sum)
    smallest4_sum_lo = (smallest4 - (smallest4_sum - smallest4_sum_right)
        + (smallest4_lo - smallest4_sum_right))
    smallest5_rounded = (smallest5
        + where(smallest5a, smallest4_sum_lo, part5 - (part5_sum - part5_sum_right)
        + (part5_lo - part5_sum_right)))
    l0_0_rounded = l0_0 + l0_0_lo
    u1_0_rounded = u1_0 + u1_0_lo
    l0_1_rounded = l0_1 + l0_1_lo
    l1_0_rounded = l1_0 + l1_0_lo
    u2_0_rounded = u2_0 + u2_0_lo
    l0_2_rounded = l0_2 + l0_2_lo
    l1_1_rounded = l1_1 + l1_1_lo
    l2_0_rounded = l2_0 + l2_0_lo
    u3_0_rounded = u3_0 + u3_0_lo
    l0_3_rounded = l0_3 + l0_3_lo
    l1_2_rounded = l1_2 + l1_2_lo
    l2_1_rounded = l2_1 + l2_1_lo
    l3_0_rounded = l3_0 + l3_0_lo
    u4_0_rounded = u4_0 + u4_0_lo
    l0_4_rounded = l0_4 + l0_4_lo
    l1_3_rounded = l1_3 + l1_3_lo
    l2_2_rounded = l2_2 + l2_2_lo
    l3_1_rounded = l3_1 + l3_1_lo
    l4_rounded = l4 + l4_lo
    u5_rounded = u5 + u5_lo
    smallest5_final = where(smallest5_rounded == smallest5_rounded, smallest5_rounded, smallest5)
    l0_0_final = where(l0_0_rounded == l0_0_rounded, l0_0_rounded, l0_0)
    u1_0_final = where(u1_0_rounded == u1_0_rounded, u1_0_rounded, u1_0)
    l0_1_final = where(l0_1_rounded == l0_1_rounded, l0_1_rounded, l0_1)
    l1_0_final = where(l1_0_rounded == l1_0_rounded, l1_0_rounded, l1_0)
    u2_0_final = where(u2_0_rounded == u2_0_rounded, u2_0_rounded, u2_0)
    l0_2_final = where(l0_2_rounded == l0_2_rounded, l0_2_rounded, l0_2)
    l1_1_final = where(l1_1_rounded == l1_1_rounded, l1_1_rounded, l1_1)
    l2_0_final = where(l2_0_rounded == l2_0_rounded, l2_0_rounded, l2_0)
    u3_0_final = where(u3_0_rounded == u3_0_rounded, u3_0_rounded, u3_0)
    l0_3_final = where(l0_3_rounded == l0_3_rounded, l0_3_rounded, l0_3)
    l1_2_final = where(l1_2_rounded == l1_2_rounded, l1_2_rounded, l1_2)
    l2_1_final = where(l2_1_rounded == l2_1_rounded, l2_1_rounded, l2_1)
    l3_0_final = where(l3_0_rounded == l3_0_rounded, l3_0_rounded, l3_0)
    u4_0_final = where(u4_0_rounded == u4_0_rounded, u4_0_rounded, u4_0)
    l0_4_final = where(l0_4_rounded == l0_4_rounded, l0_4_rounded, l0_4)
    l1_3_final = where(l1_3_rounded == l1_3_rounded, l1_3_rounded, l1_3)
    l2_2_final = where(l2_2_rounded == l2_2_rounded, l2_2_rounded, l2_2)
    l3_1_final = where(l3_1_rounded == l3_1_rounded, l3_1_rounded, l3_1)
    l4_final = where(l4_rounded == l4_rounded, l4_rounded, l4)
    u5_final = where(u5_rounded == u5_rounded, u5_rounded, u5)
    return (smallest5_final, A_00, 0, 0, 0, 0, 0, l0_0_final, u1_0_final, 0, 0, 0, 0, l0_1_final,
        l1_0_final, u2_0_final, 0, 0, 0, l0_2_final, l1_1_final, l2_0_final, u3_0_final, 0, 0,
        l0_3_final, l1_2_final, l2_1_final, l3_0_final, u4_0_final, 0, l0_4_final, l1_3_final,
        l2_2_final, l3_1_final, l4_final, u5_final)


@kernel("(6,6),(6)->(6)")
def mat6x6_ldl_solve(L, b):
    """x = A^-1 b, L of mat6x6_ldl with a positive pivot.

    (6,6),(6)->(6).  L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in
    rad/s).
    61 mul, 253 add, 6 product error, 30 product rest, 12 div, 6 equal, 6 select.  Backward
    error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
    barring over- and underflow.
    """
    (L_00, L_01, L_02, L_03, L_04, L_05, L_10, L_11, L_12, L_13, L_14, L_15, L_20, L_21, L_22, L_23,
        L_24, L_25, L_30, L_31, L_32, L_33, L_34, L_35, L_40, L_41, L_42, L_43, L_44, L_45, L_50,
        L_51, L_52, L_53, L_54, L_55) = L
    b_0, b_1, b_2, b_3, b_4, b_5 = b
    y1a = L_10 * b_0
    y1 = b_1 - y1a
    y1_right = b_1 - y1
    y1_lo = b_1 - (y1 + y1_right) - product_rest(L_10, b_0, y1a, y1_right)
    y2a = L_20 * b_0
    y2b = b_2 - y2a
    y2b_right = b_2 - y2b
    y2c = L_21 * y1
    y2 = y2b - y2c
    y2_right = y2b - y2
    y2_lo2 = y2b - (y2 + y2_right) - product_rest(L_21, y1, y2c, y2_right) - L_21 * y1_lo
    y2_lo = y2_lo2 + (b_2 - (y2b + y2b_right) - product_rest(L_20, b_0, y2a, y2b_right))
    y3a = L_30 * b_0
    y3b = b_3 - y3a
    y3b_right = b_3 - y3b
    y3c = L_31 * y1
    y3d = y3b - y3c
    y3d_right = y3b - y3d
    y3d_lo2 = y3b - (y3d + y3d_right) - product_rest(L_31, y1, y3c, y3d_right) - L_31 * y1_lo
    y3e = L_32 * y2
    y3 = y3d - y3e
    y3_right = y3d - y3
    y3d_lo = y3d_lo2 + (b_3 - (y3b + y3b_right) - product_rest(L_30, b_0, y3a, y3b_right))
    y3_lo = y3d - (y3 + y3_right) - product_rest(L_32, y2, y3e, y3_right) - L_32 * y2_lo + y3d_lo
    y4a = L_40 * b_0
    y4b = b_4 - y4a
    y4b_right = b_4 - y4b
    y4c = L_41 * y1
    y4d = y4b - y4c
    y4d_right = y4b - y4d
    y4d_lo2 = y4b - (y4d + y4d_right) - product_rest(L_41, y1, y4c, y4d_right) - L_41 * y1_lo
    y4e = L_42 * y2
    y4f = y4d - y4e
    y4f_right = y4d - y4f
    y4f_lo2 = y4d - (y4f + y4f_right) - product_rest(L_42, y2, y4e, y4f_right) - L_42 * y2_lo
    y4g = L_43 * y3
    y4 = y4f - y4g
    y4_right = y4f - y4
    y4f_lo = (y4f_lo2
        + (y4d_lo2 + (b_4 - (y4b + y4b_right) - product_rest(L_40, b_0, y4a, y4b_right))))
    y4_lo = y4f - (y4 + y4_right) - product_rest(L_43, y3, y4g, y4_right) - L_43 * y3_lo + y4f_lo
    y5a = L_50 * b_0
    y5b = b_5 - y5a
    y5b_right = b_5 - y5b
    y5c = L_51 * y1
    y5d = y5b - y5c
    y5d_right = y5b - y5d
    y5d_lo2 = y5b - (y5d + y5d_right) - product_rest(L_51, y1, y5c, y5d_right) - L_51 * y1_lo
    y5e = L_52 * y2
    y5f = y5d - y5e
    y5f_right = y5d - y5f
    y5f_lo2 = y5d - (y5f + y5f_right) - product_rest(L_52, y2, y5e, y5f_right) - L_52 * y2_lo
    y5g = L_53 * y3
    y5h = y5f - y5g
    y5h_right = y5f - y5h
    y5f_lo = (y5f_lo2
        + (y5d_lo2 + (b_5 - (y5b + y5b_right) - product_rest(L_50, b_0, y5a, y5b_right))))
    y5i = L_54 * y4
    y5 = y5h - y5i
    y5_right = y5h - y5
    y5h_lo = (y5f - (y5h + y5h_right) - product_rest(L_53, y3, y5g, y5h_right) - L_53 * y3_lo
        + y5f_lo)
    y5_lo = y5h - (y5 + y5_right) - product_rest(L_54, y4, y5i, y5_right) - L_54 * y4_lo + y5h_lo
    z0 = b_0 / L_00
    z0_product = z0 * L_00
    y1_sum = y1 + y1_lo
    y1_sum_right = y1_sum - y1
    z1 = y1_sum / L_11
    z1_product = z1 * L_11
    y2_sum = y2 + y2_lo
    y2_sum_right = y2_sum - y2
    z2 = y2_sum / L_22
    z2_product = z2 * L_22
    y3_sum = y3 + y3_lo
    y3_sum_right = y3_sum - y3
    z3 = y3_sum / L_33
    z3_product = z3 * L_33
    y4_sum = y4 + y4_lo
    y4_sum_right = y4_sum - y4
    z4 = y4_sum / L_44
    z4_product = z4 * L_44
    y5_sum = y5 + y5_lo
    y5_sum_right = y5_sum - y5
    z5 = y5_sum / L_55
    z5_product = z5 * L_55
    z5_lo = ((y5_sum - z5_product - product_error(z5, L_55, z5_product)
        + (y5 - (y5_sum - y5_sum_right) + (y5_lo - y5_sum_right))) / L_55)
    x4a = L_54 * z5
    x4 = z4 - x4a
    x4_right = z4 - x4
    z4_lo = ((y4_sum - z4_product - product_error(z4, L_44, z4_product)
        + (y4 - (y4_sum - y4_sum_right) + (y4_lo - y4_sum_right))) / L_44)
    x4_lo = z4 - (x4 + x4_right) - product_rest(L_54, z5, x4a, x4_right) - L_54 * z5_lo + z4_lo
    x3a = L_43 * x4
    x3b = z3 - x3a
    x3b_right = z3 - x3b
    z3_lo = ((y3_sum - z3_product - product_error(z3, L_33, z3_product)
        + (y3 - (y3_sum - y3_sum_right) + (y3_lo - y3_sum_right))) / L_33)
    x3c = L_53 * z5
    x3 = x3b - x3c
    x3_right = x3b - x3
    x3b_lo = z3 - (x3b + x3b_right) - product_rest(L_43, x4, x3a, x3b_right) - L_43 * x4_lo + z3_lo
    x3_lo = x3b - (x3 + x3_right) - product_rest(L_53, z5, x3c, x3_right) - L_53 * z5_lo + x3b_lo
    x2a = L_32 * x3
    x2b = z2 - x2a
    x2b_right = z2 - x2b
    z2_lo = ((y2_sum - z2_product - product_error(z2, L_22, z2_product)
        + (y2 - (y2_sum - y2_sum_right) + (y2_lo - y2_sum_right))) / L_22)
    x2c = L_42 * x4
    x2d = x2b - x2c
    x2d_right = x2b - x2d
    x2b_lo = z2 - (x2b + x2b_right) - product_rest(L_32, x3, x2a, x2b_right) - L_32 * x3_lo + z2_lo
    x2e = L_52 * z5
    x2 = x2d - x2e
    x2_right = x2d - x2
    x2d_lo = (x2b - (x2d + x2d_right) - product_rest(L_42, x4, x2c, x2d_right) - L_42 * x4_lo
        + x2b_lo)
    x2_lo = x2d - (x2 + x2_right) - product_rest(L_52, z5, x2e, x2_right) - L_52 * z5_lo + x2d_lo
    x1a = L_21 * x2
    x1b = z1 - x1a
    x1b_right = z1 - x1b
    z1_lo = ((y1_sum - z1_product - product_error(z1, L_11, z1_product)
        + (y1 - (y1_sum - y1_sum_right) + (y1_lo - y1_sum_right))) / L_11)
    x1c = L_31 * x3
    x1d = x1b - x1c
    x1d_right = x1b - x1d
    x1b_lo = z1 - (x1b + x1b_right) - product_rest(L_21, x2, x1a, x1b_right) - L_21 * x2_lo + z1_lo
    x1e = L_41 * x4
    x1f = x1d - x1e
    x1f_right = x1d - x1f
    x1d_lo = (x1b - (x1d + x1d_right) - product_rest(L_31, x3, x1c, x1d_right) - L_31 * x3_lo
        + x1b_lo)
    x1g = L_51 * z5
    x1 = x1f - x1g
    x1_right = x1f - x1
    x1f_lo = (x1d - (x1f + x1f_right) - product_rest(L_41, x4, x1e, x1f_right) - L_41 * x4_lo
        + x1d_lo)
    x1_lo = x1f - (x1 + x1_right) - product_rest(L_51, z5, x1g, x1_right) - L_51 * z5_lo + x1f_lo
    x0a = L_10 * x1
    x0b = z0 - x0a
    x0b_right = z0 - x0b
    x0b_lo2 = z0 - (x0b + x0b_right) - product_rest(L_10, x1, x0a, x0b_right) - L_10 * x1_lo
    x0c = L_20 * x2
    x0d = x0b - x0c
    x0d_right = x0b - x0d
    x0d_lo2 = x0b - (x0d + x0d_right) - product_rest(L_20, x2, x0c, x0d_right) - L_20 * x2_lo
    x0e = L_30 * x3
    x0f = x0d - x0e
    x0f_right = x0d - x0f
    x0d_lo = x0d_lo2 + (x0b_lo2 + (b_0 - z0_product - product_error(z0, L_00, z0_product)) / L_00)
    x0g = L_40 * x4
    x0h = x0f - x0g
    x0h_right = x0f - x0h
    x0f_lo = (x0d - (x0f + x0f_right) - product_rest(L_30, x3, x0e, x0f_right) - L_30 * x3_lo
        + x0d_lo)
    x0i = L_50 * z5
    x0 = x0h - x0i
    x0_right = x0h - x0
    x0h_lo = (x0f - (x0h + x0h_right) - product_rest(L_40, x4, x0g, x0h_right) - L_40 * x4_lo
        + x0f_lo)
    x0_rounded = (x0
        + (x0h - (x0 + x0_right) - product_rest(L_50, z5, x0i, x0_right) - L_50 * z5_lo + x0h_lo))
    x1_rounded = x1 + x1_lo
    x2_rounded = x2 + x2_lo
    x3_rounded = x3 + x3_lo
    x4_rounded = x4 + x4_lo
    z5_rounded = z5 + z5_lo
    x0_final = where(x0_rounded == x0_rounded, x0_rounded, x0)
    x1_final = where(x1_rounded == x1_rounded, x1_rounded, x1)
    x2_final = where(x2_rounded == x2_rounded, x2_rounded, x2)
    x3_final = where(x3_rounded == x3_rounded, x3_rounded, x3)
    x4_final = where(x4_rounded == x4_rounded, x4_rounded, x4)
    z5_final = where(z5_rounded == z5_rounded, z5_rounded, z5)
    return (x0_final, x1_final, x2_final, x3_final, x4_final, z5_final)


@kernel("(6,6),(6)->(),(6)")
def mat6x6_solve(A, b):
    """x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
    Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
    rounding or indefinite (A - 50 u diag A is not positive definite).

    (6,6),(6)->(),(6).  A: 6×6 operator; b: coscrew (f in N; τ in N m); pivot: number; x: screw
    (v in m/s; ω in rad/s).
    516 mul, 1806 add, 49 product error, 171 product rest, 96 div, 23 less, 8 equal, 77 select.
    Backward error, of A: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved;
    barring over- and underflow.
    """
    (A_00, A_01, A_02, A_03, A_04, A_05, A_10, A_11, A_12, A_13, A_14, A_15, A_20, A_21, A_22, A_23,
        A_24, A_25, A_30, A_31, A_32, A_33, A_34, A_35, A_40, A_41, A_42, A_43, A_44, A_45, A_50,
        A_51, A_52, A_53, A_54, A_55) = A
    b_0, b_1, b_2, b_3, b_4, b_5 = b
    divisor0a = 0 < A_00
    divisor0 = where(divisor0a, A_00, 1)
    l0_0 = A_10 / divisor0
    l0_0_product = l0_0 * divisor0
    l0_0_lo = (A_10 - l0_0_product - product_error(l0_0, divisor0, l0_0_product)) / divisor0
    l0_1 = A_20 / divisor0
    l0_1_product = l0_1 * divisor0
    l0_1_lo = (A_20 - l0_1_product - product_error(l0_1, divisor0, l0_1_product)) / divisor0
    l0_2 = A_30 / divisor0
    l0_2_product = l0_2 * divisor0
    l0_2_lo = (A_30 - l0_2_product - product_error(l0_2, divisor0, l0_2_product)) / divisor0
    l0_3 = A_40 / divisor0
    l0_3_product = l0_3 * divisor0
    l0_3_lo = (A_40 - l0_3_product - product_error(l0_3, divisor0, l0_3_product)) / divisor0
    l0_4 = A_50 / divisor0
    l0_4_product = l0_4 * divisor0
    l0_4_lo = (A_50 - l0_4_product - product_error(l0_4, divisor0, l0_4_product)) / divisor0
    u1_0a = A_10 * l0_0
    u1_0 = A_11 - u1_0a
    u1_0_right = A_11 - u1_0
    u1_0_lo = (A_11 - (u1_0 + u1_0_right) - product_rest(A_10, l0_0, u1_0a, u1_0_right) - A_10
        * l0_0_lo)
    u1_1a = A_20 * l0_0
    u1_1 = A_21 - u1_1a
    u1_1_right = A_21 - u1_1
    u1_1_lo = (A_21 - (u1_1 + u1_1_right) - product_rest(A_20, l0_0, u1_1a, u1_1_right) - A_20
        * l0_0_lo)
    u1_2a = A_30 * l0_0
    u1_2 = A_31 - u1_2a
    u1_2_right = A_31 - u1_2
    u1_2_lo = (A_31 - (u1_2 + u1_2_right) - product_rest(A_30, l0_0, u1_2a, u1_2_right) - A_30
        * l0_0_lo)
    u1_3a = A_40 * l0_0
    u1_3 = A_41 - u1_3a
    u1_3_right = A_41 - u1_3
    u1_3_lo = (A_41 - (u1_3 + u1_3_right) - product_rest(A_40, l0_0, u1_3a, u1_3_right) - A_40
        * l0_0_lo)
    u1_4a = A_50 * l0_0
    u1_4 = A_51 - u1_4a
    u1_4_right = A_51 - u1_4
    u1_4_lo = (A_51 - (u1_4 + u1_4_right) - product_rest(A_50, l0_0, u1_4a, u1_4_right) - A_50
        * l0_0_lo)
    u1_0_sum = u1_0 + u1_0_lo
    u1_0_sum_right = u1_0_sum - u1_0
    u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right)
    divisor1a = 0 < u1_0_sum
    divisor1 = where(divisor1a, u1_0_sum, 1)
    divisor1_lo = where(divisor1a, u1_0_sum_lo, 0)
    u1_1_sum = u1_1 + u1_1_lo
    u1_1_sum_right = u1_1_sum - u1_1
    u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right)
    divisor1_sum = divisor1 + divisor1_lo
    divisor1_sum_right = divisor1_sum - divisor1
    divisor1_sum_lo = (divisor1 - (divisor1_sum - divisor1_sum_right)
        + (divisor1_lo - divisor1_sum_right))
    l1_0 = u1_1_sum / divisor1_sum
    l1_0_product = l1_0 * divisor1_sum
    l1_0_lo = ((u1_1_sum - l1_0_product - product_error(l1_0, divisor1_sum, l1_0_product)
        + u1_1_sum_lo - l1_0 * divisor1_sum_lo) / divisor1_sum)
    u1_2_sum = u1_2 + u1_2_lo
    u1_2_sum_right = u1_2_sum - u1_2
    u1_2_sum_lo = u1_2 - (u1_2_sum - u1_2_sum_right) + (u1_2_lo - u1_2_sum_right)
    l1_1 = u1_2_sum / divisor1_sum
    l1_1_product = l1_1 * divisor1_sum
    l1_1_lo = ((u1_2_sum - l1_1_product - product_error(l1_1, divisor1_sum, l1_1_product)
        + u1_2_sum_lo - l1_1 * divisor1_sum_lo) / divisor1_sum)
    u1_3_sum = u1_3 + u1_3_lo
    u1_3_sum_right = u1_3_sum - u1_3
    u1_3_sum_lo = u1_3 - (u1_3_sum - u1_3_sum_right) + (u1_3_lo - u1_3_sum_right)
    l1_2 = u1_3_sum / divisor1_sum
    l1_2_product = l1_2 * divisor1_sum
    l1_2_lo = ((u1_3_sum - l1_2_product - product_error(l1_2, divisor1_sum, l1_2_product)
        + u1_3_sum_lo - l1_2 * divisor1_sum_lo) / divisor1_sum)
    u1_4_sum = u1_4 + u1_4_lo
    u1_4_sum_right = u1_4_sum - u1_4
    u1_4_sum_lo = u1_4 - (u1_4_sum - u1_4_sum_right) + (u1_4_lo - u1_4_sum_right)
    l1_3 = u1_4_sum / divisor1_sum
    l1_3_product = l1_3 * divisor1_sum
    l1_3_lo = ((u1_4_sum - l1_3_product - product_error(l1_3, divisor1_sum, l1_3_product)
        + u1_4_sum_lo - l1_3 * divisor1_sum_lo) / divisor1_sum)
    u2_0a = A_20 * l0_1
    u2_0b = A_22 - u2_0a
    u2_0b_right = A_22 - u2_0b
    u2_0c = u1_1_sum * l1_0
    u2_0 = u2_0b - u2_0c
    u2_0_right = u2_0b - u2_0
    u2_0_lo2 = (u2_0b - (u2_0 + u2_0_right) - product_rest(u1_1_sum, l1_0, u2_0c, u2_0_right)
        - (u1_1_sum_lo * l1_0 + u1_1_sum * l1_0_lo))
    u2_0_lo = (u2_0_lo2
        + (A_22 - (u2_0b + u2_0b_right) - product_rest(A_20, l0_1, u2_0a, u2_0b_right) - A_20
        * l0_1_lo))
    u2_1a = A_30 * l0_1
    u2_1b = A_32 - u2_1a
    u2_1b_right = A_32 - u2_1b
    u2_1c = u1_2_sum * l1_0
    u2_1 = u2_1b - u2_1c
    u2_1_right = u2_1b - u2_1
    u2_1_lo2 = (u2_1b - (u2_1 + u2_1_right) - product_rest(u1_2_sum, l1_0, u2_1c, u2_1_right)
        - (u1_2_sum_lo * l1_0 + u1_2_sum * l1_0_lo))
    u2_1_lo = (u2_1_lo2
        + (A_32 - (u2_1b + u2_1b_right) - product_rest(A_30, l0_1, u2_1a, u2_1b_right) - A_30
        * l0_1_lo))
    u2_2a = A_40 * l0_1
    u2_2b = A_42 - u2_2a
    u2_2b_right = A_42 - u2_2b
    u2_2c = u1_3_sum * l1_0
    u2_2 = u2_2b - u2_2c
    u2_2_right = u2_2b - u2_2
    u2_2_lo2 = (u2_2b - (u2_2 + u2_2_right) - product_rest(u1_3_sum, l1_0, u2_2c, u2_2_right)
        - (u1_3_sum_lo * l1_0 + u1_3_sum * l1_0_lo))
    u2_2_lo = (u2_2_lo2
        + (A_42 - (u2_2b + u2_2b_right) - product_rest(A_40, l0_1, u2_2a, u2_2b_right) - A_40
        * l0_1_lo))
    u2_3a = A_50 * l0_1
    u2_3b = A_52 - u2_3a
    u2_3b_right = A_52 - u2_3b
    u2_3c = u1_4_sum * l1_0
    u2_3 = u2_3b - u2_3c
    u2_3_right = u2_3b - u2_3
    u2_3_lo2 = (u2_3b - (u2_3 + u2_3_right) - product_rest(u1_4_sum, l1_0, u2_3c, u2_3_right)
        - (u1_4_sum_lo * l1_0 + u1_4_sum * l1_0_lo))
    u2_3_lo = (u2_3_lo2
        + (A_52 - (u2_3b + u2_3b_right) - product_rest(A_50, l0_1, u2_3a, u2_3b_right) - A_50
        * l0_1_lo))
    u2_0_sum = u2_0 + u2_0_lo
    u2_0_sum_right = u2_0_sum - u2_0
    u2_0_sum_lo = u2_0 - (u2_0_sum - u2_0_sum_right) + (u2_0_lo - u2_0_sum_right)
    divisor2a = 0 < u2_0_sum
    divisor2 = where(divisor2a, u2_0_sum, 1)
    divisor2_lo = where(divisor2a, u2_0_sum_lo, 0)
    u2_1_sum = u2_1 + u2_1_lo
    u2_1_sum_right = u2_1_sum - u2_1
    u2_1_sum_lo = u2_1 - (u2_1_sum - u2_1_sum_right) + (u2_1_lo - u2_1_sum_right)
    divisor2_sum = divisor2 + divisor2_lo
    divisor2_sum_right = divisor2_sum - divisor2
    divisor2_sum_lo = (divisor2 - (divisor2_sum - divisor2_sum_right)
        + (divisor2_lo - divisor2_sum_right))
    l2_0 = u2_1_sum / divisor2_sum
    l2_0_product = l2_0 * divisor2_sum
    l2_0_lo = ((u2_1_sum - l2_0_product - product_error(l2_0, divisor2_sum, l2_0_product)
        + u2_1_sum_lo - l2_0 * divisor2_sum_lo) / divisor2_sum)
    u2_2_sum = u2_2 + u2_2_lo
    u2_2_sum_right = u2_2_sum - u2_2
    u2_2_sum_lo = u2_2 - (u2_2_sum - u2_2_sum_right) + (u2_2_lo - u2_2_sum_right)
    l2_1 = u2_2_sum / divisor2_sum
    l2_1_product = l2_1 * divisor2_sum
    l2_1_lo = ((u2_2_sum - l2_1_product - product_error(l2_1, divisor2_sum, l2_1_product)
        + u2_2_sum_lo - l2_1 * divisor2_sum_lo) / divisor2_sum)
    u2_3_sum = u2_3 + u2_3_lo
    u2_3_sum_right = u2_3_sum - u2_3
    u2_3_sum_lo = u2_3 - (u2_3_sum - u2_3_sum_right) + (u2_3_lo - u2_3_sum_right)
    l2_2 = u2_3_sum / divisor2_sum
    l2_2_product = l2_2 * divisor2_sum
    l2_2_lo = ((u2_3_sum - l2_2_product - product_error(l2_2, divisor2_sum, l2_2_product)
        + u2_3_sum_lo - l2_2 * divisor2_sum_lo) / divisor2_sum)
    u3_0a = A_30 * l0_2
    u3_0b = A_33 - u3_0a
    u3_0b_right = A_33 - u3_0b
    u3_0c = u1_2_sum * l1_1
    u3_0d = u3_0b - u3_0c
    u3_0d_right = u3_0b - u3_0d
    u3_0d_lo2 = (u3_0b - (u3_0d + u3_0d_right) - product_rest(u1_2_sum, l1_1, u3_0c, u3_0d_right)
        - (u1_2_sum_lo * l1_1 + u1_2_sum * l1_1_lo))
    u3_0e = u2_1_sum * l2_0
    u3_0 = u3_0d - u3_0e
    u3_0_right = u3_0d - u3_0
    u3_0_lo2 = (u3_0d - (u3_0 + u3_0_right) - product_rest(u2_1_sum, l2_0, u3_0e, u3_0_right)
        - (u2_1_sum_lo * l2_0 + u2_1_sum * l2_0_lo))
    u3_0_lo = (u3_0_lo2
        + (u3_0d_lo2
        + (A_33 - (u3_0b + u3_0b_right) - product_rest(A_30, l0_2, u3_0a, u3_0b_right) - A_30
        * l0_2_lo)))
    u3_1a = A_40 * l0_2
    u3_1b = A_43 - u3_1a
    u3_1b_right = A_43 - u3_1b
    u3_1c = u1_3_sum * l1_1
    u3_1d = u3_1b - u3_1c
    u3_1d_right = u3_1b - u3_1d
    u3_1d_lo2 = (u3_1b - (u3_1d + u3_1d_right) - product_rest(u1_3_sum, l1_1, u3_1c, u3_1d_right)
        - (u1_3_sum_lo * l1_1 + u1_3_sum * l1_1_lo))
    u3_1e = u2_2_sum * l2_0
    u3_1 = u3_1d - u3_1e
    u3_1_right = u3_1d - u3_1
    u3_1_lo2 = (u3_1d - (u3_1 + u3_1_right) - product_rest(u2_2_sum, l2_0, u3_1e, u3_1_right)
        - (u2_2_sum_lo * l2_0 + u2_2_sum * l2_0_lo))
    u3_1_lo = (u3_1_lo2
        + (u3_1d_lo2
        + (A_43 - (u3_1b + u3_1b_right) - product_rest(A_40, l0_2, u3_1a, u3_1b_right) - A_40
        * l0_2_lo)))
    u3_2a = A_50 * l0_2
    u3_2b = A_53 - u3_2a
    u3_2b_right = A_53 - u3_2b
    u3_2c = u1_4_sum * l1_1
    u3_2d = u3_2b - u3_2c
    u3_2d_right = u3_2b - u3_2d
    u3_2d_lo2 = (u3_2b - (u3_2d + u3_2d_right) - product_rest(u1_4_sum, l1_1, u3_2c, u3_2d_right)
        - (u1_4_sum_lo * l1_1 + u1_4_sum * l1_1_lo))
    u3_2e = u2_3_sum * l2_0
    u3_2 = u3_2d - u3_2e
    u3_2_right = u3_2d - u3_2
    u3_2_lo2 = (u3_2d - (u3_2 + u3_2_right) - product_rest(u2_3_sum, l2_0, u3_2e, u3_2_right)
        - (u2_3_sum_lo * l2_0 + u2_3_sum * l2_0_lo))
    u3_2_lo = (u3_2_lo2
        + (u3_2d_lo2
        + (A_53 - (u3_2b + u3_2b_right) - product_rest(A_50, l0_2, u3_2a, u3_2b_right) - A_50
        * l0_2_lo)))
    u3_0_sum = u3_0 + u3_0_lo
    u3_0_sum_right = u3_0_sum - u3_0
    u3_0_sum_lo = u3_0 - (u3_0_sum - u3_0_sum_right) + (u3_0_lo - u3_0_sum_right)
    divisor3a = 0 < u3_0_sum
    divisor3 = where(divisor3a, u3_0_sum, 1)
    divisor3_lo = where(divisor3a, u3_0_sum_lo, 0)
    u3_1_sum = u3_1 + u3_1_lo
    u3_1_sum_right = u3_1_sum - u3_1
    u3_1_sum_lo = u3_1 - (u3_1_sum - u3_1_sum_right) + (u3_1_lo - u3_1_sum_right)
    divisor3_sum = divisor3 + divisor3_lo
    divisor3_sum_right = divisor3_sum - divisor3
    divisor3_sum_lo = (divisor3 - (divisor3_sum - divisor3_sum_right)
        + (divisor3_lo - divisor3_sum_right))
    l3_0 = u3_1_sum / divisor3_sum
    l3_0_product = l3_0 * divisor3_sum
    l3_0_lo = ((u3_1_sum - l3_0_product - product_error(l3_0, divisor3_sum, l3_0_product)
        + u3_1_sum_lo - l3_0 * divisor3_sum_lo) / divisor3_sum)
    u3_2_sum = u3_2 + u3_2_lo
    u3_2_sum_right = u3_2_sum - u3_2
    u3_2_sum_lo = u3_2 - (u3_2_sum - u3_2_sum_right) + (u3_2_lo - u3_2_sum_right)
    l3_1 = u3_2_sum / divisor3_sum
    l3_1_product = l3_1 * divisor3_sum
    l3_1_lo = ((u3_2_sum - l3_1_product - product_error(l3_1, divisor3_sum, l3_1_product)
        + u3_2_sum_lo - l3_1 * divisor3_sum_lo) / divisor3_sum)
    u4_0a = A_40 * l0_3
    u4_0b = A_44 - u4_0a
    u4_0b_right = A_44 - u4_0b
    u4_0c = u1_3_sum * l1_2
    u4_0d = u4_0b - u4_0c
    u4_0d_right = u4_0b - u4_0d
    u4_0d_lo2 = (u4_0b - (u4_0d + u4_0d_right) - product_rest(u1_3_sum, l1_2, u4_0c, u4_0d_right)
        - (u1_3_sum_lo * l1_2 + u1_3_sum * l1_2_lo))
    u4_0e = u2_2_sum * l2_1
    u4_0f = u4_0d - u4_0e
    u4_0f_right = u4_0d - u4_0f
    u4_0f_lo2 = (u4_0d - (u4_0f + u4_0f_right) - product_rest(u2_2_sum, l2_1, u4_0e, u4_0f_right)
        - (u2_2_sum_lo * l2_1 + u2_2_sum * l2_1_lo))
    u4_0g = u3_1_sum * l3_0
    u4_0 = u4_0f - u4_0g
    u4_0_right = u4_0f - u4_0
    u4_0_lo2 = (u4_0f - (u4_0 + u4_0_right) - product_rest(u3_1_sum, l3_0, u4_0g, u4_0_right)
        - (u3_1_sum_lo * l3_0 + u3_1_sum * l3_0_lo))
    u4_0_lo = (u4_0_lo2
        + (u4_0f_lo2
        + (u4_0d_lo2
        + (A_44 - (u4_0b + u4_0b_right) - product_rest(A_40, l0_3, u4_0a, u4_0b_right) - A_40
        * l0_3_lo))))
    u4_1a = A_50 * l0_3
    u4_1b = A_54 - u4_1a
    u4_1b_right = A_54 - u4_1b
    u4_1c = u1_4_sum * l1_2
    u4_1d = u4_1b - u4_1c
    u4_1d_right = u4_1b - u4_1d
    u4_1d_lo2 = (u4_1b - (u4_1d + u4_1d_right) - product_rest(u1_4_sum, l1_2, u4_1c, u4_1d_right)
        - (u1_4_sum_lo * l1_2 + u1_4_sum * l1_2_lo))
    u4_1e = u2_3_sum * l2_1
    u4_1f = u4_1d - u4_1e
    u4_1f_right = u4_1d - u4_1f
    u4_1f_lo2 = (u4_1d - (u4_1f + u4_1f_right) - product_rest(u2_3_sum, l2_1, u4_1e, u4_1f_right)
        - (u2_3_sum_lo * l2_1 + u2_3_sum * l2_1_lo))
    u4_1g = u3_2_sum * l3_0
    u4_1 = u4_1f - u4_1g
    u4_1_right = u4_1f - u4_1
    u4_1_lo2 = (u4_1f - (u4_1 + u4_1_right) - product_rest(u3_2_sum, l3_0, u4_1g, u4_1_right)
        - (u3_2_sum_lo * l3_0 + u3_2_sum * l3_0_lo))
    u4_1_lo = (u4_1_lo2
        + (u4_1f_lo2
        + (u4_1d_lo2
        + (A_54 - (u4_1b + u4_1b_right) - product_rest(A_50, l0_3, u4_1a, u4_1b_right) - A_50
        * l0_3_lo))))
    u4_0_sum = u4_0 + u4_0_lo
    u4_0_sum_right = u4_0_sum - u4_0
    u4_0_sum_lo = u4_0 - (u4_0_sum - u4_0_sum_right) + (u4_0_lo - u4_0_sum_right)
    divisor4a = 0 < u4_0_sum
    divisor4 = where(divisor4a, u4_0_sum, 1)
    divisor4_lo = where(divisor4a, u4_0_sum_lo, 0)
    u4_1_sum = u4_1 + u4_1_lo
    u4_1_sum_right = u4_1_sum - u4_1
    u4_1_sum_lo = u4_1 - (u4_1_sum - u4_1_sum_right) + (u4_1_lo - u4_1_sum_right)
    divisor4_sum = divisor4 + divisor4_lo
    divisor4_sum_right = divisor4_sum - divisor4
    divisor4_sum_lo = (divisor4 - (divisor4_sum - divisor4_sum_right)
        + (divisor4_lo - divisor4_sum_right))
    l4 = u4_1_sum / divisor4_sum
    l4_product = l4 * divisor4_sum
    l4_lo = ((u4_1_sum - l4_product - product_error(l4, divisor4_sum, l4_product) + u4_1_sum_lo
        - l4 * divisor4_sum_lo) / divisor4_sum)
    u5a = A_50 * l0_4
    u5b = A_55 - u5a
    u5b_right = A_55 - u5b
    u5c = u1_4_sum * l1_3
    u5d = u5b - u5c
    u5d_right = u5b - u5d
    u5d_lo2 = (u5b - (u5d + u5d_right) - product_rest(u1_4_sum, l1_3, u5c, u5d_right)
        - (u1_4_sum_lo * l1_3 + u1_4_sum * l1_3_lo))
    u5e = u2_3_sum * l2_2
    u5f = u5d - u5e
    u5f_right = u5d - u5f
    u5f_lo2 = (u5d - (u5f + u5f_right) - product_rest(u2_3_sum, l2_2, u5e, u5f_right)
        - (u2_3_sum_lo * l2_2 + u2_3_sum * l2_2_lo))
    u5g = u3_2_sum * l3_1
    u5h = u5f - u5g
    u5h_right = u5f - u5h
    u5h_lo2 = (u5f - (u5h + u5h_right) - product_rest(u3_2_sum, l3_1, u5g, u5h_right)
        - (u3_2_sum_lo * l3_1 + u3_2_sum * l3_1_lo))
    u5i = u4_1_sum * l4
    u5 = u5h - u5i
    u5_right = u5h - u5
    u5h_lo = (u5h_lo2
        + (u5f_lo2
        + (u5d_lo2
        + (A_55 - (u5b + u5b_right) - product_rest(A_50, l0_4, u5a, u5b_right) - A_50 * l0_4_lo))))
    u5_lo = (u5h - (u5 + u5_right) - product_rest(u4_1_sum, l4, u5i, u5_right)
        - (u4_1_sum_lo * l4 + u4_1_sum * l4_lo) + u5h_lo)
    u5_sum = u5 + u5_lo
    u5_sum_right = u5_sum - u5
    u5_sum_lo = u5 - (u5_sum - u5_sum_right) + (u5_lo - u5_sum_right)
    divisor5a = 0 < u5_sum
    divisor5 = where(divisor5a, u5_sum, 1)
    divisor5_lo = where(divisor5a, u5_sum_lo, 0)
    part0a = A_00 / divisor0
    part0a_product = part0a * divisor0
    part0 = where(divisor0a, part0a, A_00)
    part0_lo = where(divisor0a, (A_00 - part0a_product - product_error(part0a, divisor0,
        part0a_product)) / divisor0, 0)
    own1a = 0 < A_11
    own1 = where(own1a, A_11, 1)
    part1a = u1_0_sum / own1
    part1a_product = part1a * own1
    part1 = where(own1a, part1a, A_11)
    part1_lo = where(own1a, (u1_0_sum - part1a_product - product_error(part1a, own1,
        part1a_product) + u1_0_sum_lo) / own1, 0)
    part0_sum = part0 + part0_lo
    part0_sum_right = part0_sum - part0
    part1_sum = part1 + part1_lo
    part1_sum_right = part1_sum - part1
    smallest1a = part0_sum < part1_sum
    smallest1 = where(smallest1a, part0_sum, part1_sum)
    part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right)
    smallest1_lo = where(smallest1a, part0_sum_lo,
        part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right))
    own2a = 0 < A_22
    own2 = where(own2a, A_22, 1)
    part2a = u2_0_sum / own2
    part2a_product = part2a * own2
    part2 = where(own2a, part2a, A_22)
    part2_lo = where(own2a, (u2_0_sum - part2a_product - product_error(part2a, own2,
        part2a_product) + u2_0_sum_lo) / own2, 0)
    smallest1_sum = smallest1 + smallest1_lo
    smallest1_sum_right = smallest1_sum - smallest1
    part2_sum = part2 + part2_lo
    part2_sum_right = part2_sum - part2
    smallest2a = smallest1_sum < part2_sum
    smallest2 = where(smallest2a, smallest1_sum, part2_sum)
    smallest1_sum_lo = (smallest1 - (smallest1_sum - smallest1_sum_right)
        + (smallest1_lo - smallest1_sum_right))
    smallest2_lo = where(smallest2a, smallest1_sum_lo,
        part2 - (part2_sum - part2_sum_right) + (part2_lo - part2_sum_right))
    own3a = 0 < A_33
    own3 = where(own3a, A_33, 1)
    part3a = u3_0_sum / own3
    part3a_product = part3a * own3
    part3 = where(own3a, part3a, A_33)
    part3_lo = where(own3a, (u3_0_sum - part3a_product - product_error(part3a, own3,
        part3a_product) + u3_0_sum_lo) / own3, 0)
    smallest2_sum = smallest2 + smallest2_lo
    smallest2_sum_right = smallest2_sum - smallest2
    part3_sum = part3 + part3_lo
    part3_sum_right = part3_sum - part3
    smallest3a = smallest2_sum < part3_sum
    smallest3 = where(smallest3a, smallest2_sum, part3_sum)
    smallest2_sum_lo = (smallest2 - (smallest2_sum - smallest2_sum_right)
        + (smallest2_lo - smallest2_sum_right))
    smallest3_lo = where(smallest3a, smallest2_sum_lo,
        part3 - (part3_sum - part3_sum_right) + (part3_lo - part3_sum_right))
    own4a = 0 < A_44
    own4 = where(own4a, A_44, 1)
    part4a = u4_0_sum / own4
    part4a_product = part4a * own4
    part4 = where(own4a, part4a, A_44)
    part4_lo = where(own4a, (u4_0_sum - part4a_product - product_error(part4a, own4,
        part4a_product) + u4_0_sum_lo) / own4, 0)
    smallest3_sum = smallest3 + smallest3_lo
    smallest3_sum_right = smallest3_sum - smallest3
    part4_sum = part4 + part4_lo
    part4_sum_right = part4_sum - part4
    smallest4a = smallest3_sum < part4_sum
    smallest4 = where(smallest4a, smallest3_sum, part4_sum)
    smallest3_sum_lo = (smallest3 - (smallest3_sum - smallest3_sum_right)
        + (smallest3_lo - smallest3_sum_right))
    smallest4_lo = where(smallest4a, smallest3_sum_lo,
        part4 - (part4_sum - part4_sum_right) + (part4_lo - part4_sum_right))
    own5a = 0 < A_55
    own5 = where(own5a, A_55, 1)
    part5a = u5_sum / own5
    part5a_product = part5a * own5
    part5 = where(own5a, part5a, A_55)
    part5_lo = where(own5a, (u5_sum - part5a_product - product_error(part5a, own5,
        part5a_product) + u5_sum_lo) / own5, 0)
    smallest4_sum = smallest4 + smallest4_lo
    smallest4_sum_right = smallest4_sum - smallest4
    part5_sum = part5 + part5_lo
    part5_sum_right = part5_sum - part5
    smallest5a = smallest4_sum < part5_sum
    smallest5 = where(smallest5a, smallest4_sum, part5_sum)
    smallest4_sum_lo = (smallest4 - (smallest4_sum - smallest4_sum_right)
        + (smallest4_lo - smallest4_sum_right))
    smallest5_lo = where(smallest5a, smallest4_sum_lo,
        part5 - (part5_sum - part5_sum_right) + (part5_lo - part5_sum_right))
    less_0 = A_00 * 0.9999999999999944
    less_1 = A_11 * 0.9999999999999944
    less_2 = A_22 * 0.9999999999999944
    less_3 = A_33 * 0.9999999999999944
    less_4 = A_44 * 0.9999999999999944
    less_5 = A_55 * 0.9999999999999944
    less_0_lo = product_error(A_00, 0.9999999999999944, less_0)
    less_0_sum = less_0 + less_0_lo
    less_0_sum_right = less_0_sum - less_0
    less_divisor0a = 0 < less_0_sum
    less_divisor0 = where(less_divisor0a, less_0_sum, 1)
    less_divisor0_lo = where(less_divisor0a,
        less_0 - (less_0_sum - less_0_sum_right) + (less_0_lo - less_0_sum_right), 0)
    less_divisor0_sum = less_divisor0 + less_divisor0_lo
    less_divisor0_sum_right = less_divisor0_sum - less_divisor0
    less_divisor0_sum_lo = (less_divisor0 - (less_divisor0_sum - less_divisor0_sum_right)
        + (less_divisor0_lo - less_divisor0_sum_right))
    less_l0_0 = A_10 / less_divisor0_sum
    less_l0_0_product = less_l0_0 * less_divisor0_sum
    less_l0_0_residual = (A_10 - less_l0_0_product
        - product_error(less_l0_0, less_divisor0_sum, less_l0_0_product) - less_l0_0
        * less_divisor0_sum_lo)
    less_l0_0_lo = less_l0_0_residual / less_divisor0_sum
    less_l0_1 = A_20 / less_divisor0_sum
    less_l0_1_product = less_l0_1 * less_divisor0_sum
    less_l0_1_residual = (A_20 - less_l0_1_product
        - product_error(less_l0_1, less_divisor0_sum, less_l0_1_product) - less_l0_1
        * less_divisor0_sum_lo)
    less_l0_1_lo = less_l0_1_residual / less_divisor0_sum
    less_l0_2 = A_30 / less_divisor0_sum
    less_l0_2_product = less_l0_2 * less_divisor0_sum
    less_l0_2_residual = (A_30 - less_l0_2_product
        - product_error(less_l0_2, less_divisor0_sum, less_l0_2_product) - less_l0_2
        * less_divisor0_sum_lo)
    less_l0_2_lo = less_l0_2_residual / less_divisor0_sum
    less_l0_3 = A_40 / less_divisor0_sum
    less_l0_3_product = less_l0_3 * less_divisor0_sum
    less_l0_3_residual = (A_40 - less_l0_3_product
        - product_error(less_l0_3, less_divisor0_sum, less_l0_3_product) - less_l0_3
        * less_divisor0_sum_lo)
    less_l0_3_lo = less_l0_3_residual / less_divisor0_sum
    less_l0_4 = A_50 / less_divisor0_sum
    less_l0_4_product = less_l0_4 * less_divisor0_sum
    less_l0_4_residual = (A_50 - less_l0_4_product
        - product_error(less_l0_4, less_divisor0_sum, less_l0_4_product) - less_l0_4
        * less_divisor0_sum_lo)
    less_u1_0a = A_10 * less_l0_0
    less_u1_0 = less_1 - less_u1_0a
    less_u1_0_right = less_1 - less_u1_0
    less_u1_0_left_rest = product_rest(A_11, 0.9999999999999944, less_1,
        less_u1_0 + less_u1_0_right)
    less_u1_0_lo = (less_u1_0_left_rest
        - product_rest(A_10, less_l0_0, less_u1_0a, less_u1_0_right) - A_10 * less_l0_0_lo)
    less_u1_1a = A_20 * less_l0_0
    less_u1_1 = A_21 - less_u1_1a
    less_u1_1_right = A_21 - less_u1_1
    less_u1_1_lo = (A_21 - (less_u1_1 + less_u1_1_right)
        - product_rest(A_20, less_l0_0, less_u1_1a, less_u1_1_right) - A_20 * less_l0_0_lo)
    less_u1_2a = A_30 * less_l0_0
    less_u1_2 = A_31 - less_u1_2a
    less_u1_2_right = A_31 - less_u1_2
    less_u1_2_lo = (A_31 - (less_u1_2 + less_u1_2_right)
        - product_rest(A_30, less_l0_0, less_u1_2a, less_u1_2_right) - A_30 * less_l0_0_lo)
    less_u1_3a = A_40 * less_l0_0
    less_u1_3 = A_41 - less_u1_3a
    less_u1_3_right = A_41 - less_u1_3
    less_u1_3_lo = (A_41 - (less_u1_3 + less_u1_3_right)
        - product_rest(A_40, less_l0_0, less_u1_3a, less_u1_3_right) - A_40 * less_l0_0_lo)
    less_u1_4a = A_50 * less_l0_0
    less_u1_4 = A_51 - less_u1_4a
    less_u1_4_right = A_51 - less_u1_4
    less_u1_4_lo = (A_51 - (less_u1_4 + less_u1_4_right)
        - product_rest(A_50, less_l0_0, less_u1_4a, less_u1_4_right) - A_50 * less_l0_0_lo)
    less_u1_0_sum = less_u1_0 + less_u1_0_lo
    less_u1_0_sum_right = less_u1_0_sum - less_u1_0
    less_divisor1a = 0 < less_u1_0_sum
    less_divisor1 = where(less_divisor1a, less_u1_0_sum, 1)
    less_divisor1_lo = where(less_divisor1a,
        less_u1_0 - (less_u1_0_sum - less_u1_0_sum_right) + (less_u1_0_lo - less_u1_0_sum_right), 0)
    less_u1_1_sum = less_u1_1 + less_u1_1_lo
    less_u1_1_sum_right = less_u1_1_sum - less_u1_1
    less_u1_1_sum_lo = (less_u1_1 - (less_u1_1_sum - less_u1_1_sum_right)
        + (less_u1_1_lo - less_u1_1_sum_right))
    less_divisor1_sum = less_divisor1 + less_divisor1_lo
    less_divisor1_sum_right = less_divisor1_sum - less_divisor1
    less_divisor1_sum_lo = (less_divisor1 - (less_divisor1_sum - less_divisor1_sum_right)
        + (less_divisor1_lo - less_divisor1_sum_right))
    less_l1_0 = less_u1_1_sum / less_divisor1_sum
    less_l1_0_product = less_l1_0 * less_divisor1_sum
    less_l1_0_numerator = (less_u1_1_sum - less_l1_0_product
        - product_error(less_l1_0, less_divisor1_sum, less_l1_0_product) + less_u1_1_sum_lo)
    less_l1_0_lo = (less_l1_0_numerator - less_l1_0 * less_divisor1_sum_lo) / less_divisor1_sum
    less_u1_2_sum = less_u1_2 + less_u1_2_lo
    less_u1_2_sum_right = less_u1_2_sum - less_u1_2
    less_u1_2_sum_lo = (less_u1_2 - (less_u1_2_sum - less_u1_2_sum_right)
        + (less_u1_2_lo - less_u1_2_sum_right))
    less_l1_1 = less_u1_2_sum / less_divisor1_sum
    less_l1_1_product = less_l1_1 * less_divisor1_sum
    less_l1_1_numerator = (less_u1_2_sum - less_l1_1_product
        - product_error(less_l1_1, less_divisor1_sum, less_l1_1_product) + less_u1_2_sum_lo)
    less_l1_1_lo = (less_l1_1_numerator - less_l1_1 * less_divisor1_sum_lo) / less_divisor1_sum
    less_u1_3_sum = less_u1_3 + less_u1_3_lo
    less_u1_3_sum_right = less_u1_3_sum - less_u1_3
    less_u1_3_sum_lo = (less_u1_3 - (less_u1_3_sum - less_u1_3_sum_right)
        + (less_u1_3_lo - less_u1_3_sum_right))
    less_l1_2 = less_u1_3_sum / less_divisor1_sum
    less_l1_2_product = less_l1_2 * less_divisor1_sum
    less_l1_2_numerator = (less_u1_3_sum - less_l1_2_product
        - product_error(less_l1_2, less_divisor1_sum, less_l1_2_product) + less_u1_3_sum_lo)
    less_l1_2_lo = (less_l1_2_numerator - less_l1_2 * less_divisor1_sum_lo) / less_divisor1_sum
    less_u1_4_sum = less_u1_4 + less_u1_4_lo
    less_u1_4_sum_right = less_u1_4_sum - less_u1_4
    less_u1_4_sum_lo = (less_u1_4 - (less_u1_4_sum - less_u1_4_sum_right)
        + (less_u1_4_lo - less_u1_4_sum_right))
    less_l1_3 = less_u1_4_sum / less_divisor1_sum
    less_l1_3_product = less_l1_3 * less_divisor1_sum
    less_l1_3_numerator = (less_u1_4_sum - less_l1_3_product
        - product_error(less_l1_3, less_divisor1_sum, less_l1_3_product) + less_u1_4_sum_lo)
    less_u2_0a = A_20 * less_l0_1
    less_u2_0b = less_2 - less_u2_0a
    less_u2_0b_right = less_2 - less_u2_0b
    less_u2_0b_left_rest = product_rest(A_22, 0.9999999999999944, less_2,
        less_u2_0b + less_u2_0b_right)
    less_u2_0c = less_u1_1_sum * less_l1_0
    less_u2_0 = less_u2_0b - less_u2_0c
    less_u2_0_right = less_u2_0b - less_u2_0
    less_u2_0_lo1 = (less_u2_0b - (less_u2_0 + less_u2_0_right)
        - product_rest(less_u1_1_sum, less_l1_0, less_u2_0c, less_u2_0_right))
    less_u2_0b_lo = (less_u2_0b_left_rest
        - product_rest(A_20, less_l0_1, less_u2_0a, less_u2_0b_right) - A_20 * less_l0_1_lo)
    less_u2_0_lo = (less_u2_0_lo1 - (less_u1_1_sum_lo * less_l1_0 + less_u1_1_sum * less_l1_0_lo)
        + less_u2_0b_lo)
    less_u2_1a = A_30 * less_l0_1
    less_u2_1b = A_32 - less_u2_1a
    less_u2_1b_right = A_32 - less_u2_1b
    less_u2_1c = less_u1_2_sum * less_l1_0
    less_u2_1 = less_u2_1b - less_u2_1c
    less_u2_1_right = less_u2_1b - less_u2_1
    less_u2_1_lo1 = (less_u2_1b - (less_u2_1 + less_u2_1_right)
        - product_rest(less_u1_2_sum, less_l1_0, less_u2_1c, less_u2_1_right))
    less_u2_1b_lo = (A_32 - (less_u2_1b + less_u2_1b_right)
        - product_rest(A_30, less_l0_1, less_u2_1a, less_u2_1b_right) - A_30 * less_l0_1_lo)
    less_u2_1_lo = (less_u2_1_lo1 - (less_u1_2_sum_lo * less_l1_0 + less_u1_2_sum * less_l1_0_lo)
        + less_u2_1b_lo)
    less_u2_2a = A_40 * less_l0_1
    less_u2_2b = A_42 - less_u2_2a
    less_u2_2b_right = A_42 - less_u2_2b
    less_u2_2c = less_u1_3_sum * less_l1_0
    less_u2_2 = less_u2_2b - less_u2_2c
    less_u2_2_right = less_u2_2b - less_u2_2
    less_u2_2_lo1 = (less_u2_2b - (less_u2_2 + less_u2_2_right)
        - product_rest(less_u1_3_sum, less_l1_0, less_u2_2c, less_u2_2_right))
    less_u2_2b_lo = (A_42 - (less_u2_2b + less_u2_2b_right)
        - product_rest(A_40, less_l0_1, less_u2_2a, less_u2_2b_right) - A_40 * less_l0_1_lo)
    less_u2_2_lo = (less_u2_2_lo1 - (less_u1_3_sum_lo * less_l1_0 + less_u1_3_sum * less_l1_0_lo)
        + less_u2_2b_lo)
    less_u2_3a = A_50 * less_l0_1
    less_u2_3b = A_52 - less_u2_3a
    less_u2_3b_right = A_52 - less_u2_3b
    less_u2_3c = less_u1_4_sum * less_l1_0
    less_u2_3 = less_u2_3b - less_u2_3c
    less_u2_3_right = less_u2_3b - less_u2_3
    less_u2_3_lo1 = (less_u2_3b - (less_u2_3 + less_u2_3_right)
        - product_rest(less_u1_4_sum, less_l1_0, less_u2_3c, less_u2_3_right))
    less_u2_3b_lo = (A_52 - (less_u2_3b + less_u2_3b_right)
        - product_rest(A_50, less_l0_1, less_u2_3a, less_u2_3b_right) - A_50 * less_l0_1_lo)
    less_u2_3_lo = (less_u2_3_lo1 - (less_u1_4_sum_lo * less_l1_0 + less_u1_4_sum * less_l1_0_lo)
        + less_u2_3b_lo)
    less_u2_0_sum = less_u2_0 + less_u2_0_lo
    less_u2_0_sum_right = less_u2_0_sum - less_u2_0
    less_divisor2a = 0 < less_u2_0_sum
    less_divisor2 = where(less_divisor2a, less_u2_0_sum, 1)
    less_divisor2_lo = where(less_divisor2a,
        less_u2_0 - (less_u2_0_sum - less_u2_0_sum_right) + (less_u2_0_lo - less_u2_0_sum_right), 0)
    less_u2_1_sum = less_u2_1 + less_u2_1_lo
    less_u2_1_sum_right = less_u2_1_sum - less_u2_1
    less_u2_1_sum_lo = (less_u2_1 - (less_u2_1_sum - less_u2_1_sum_right)
        + (less_u2_1_lo - less_u2_1_sum_right))
    less_divisor2_sum = less_divisor2 + less_divisor2_lo
    less_divisor2_sum_right = less_divisor2_sum - less_divisor2
    less_divisor2_sum_lo = (less_divisor2 - (less_divisor2_sum - less_divisor2_sum_right)
        + (less_divisor2_lo - less_divisor2_sum_right))
    less_l2_0 = less_u2_1_sum / less_divisor2_sum
    less_l2_0_product = less_l2_0 * less_divisor2_sum
    less_l2_0_numerator = (less_u2_1_sum - less_l2_0_product
        - product_error(less_l2_0, less_divisor2_sum, less_l2_0_product) + less_u2_1_sum_lo)
    less_l2_0_lo = (less_l2_0_numerator - less_l2_0 * less_divisor2_sum_lo) / less_divisor2_sum
    less_u2_2_sum = less_u2_2 + less_u2_2_lo
    less_u2_2_sum_right = less_u2_2_sum - less_u2_2
    less_u2_2_sum_lo = (less_u2_2 - (less_u2_2_sum - less_u2_2_sum_right)
        + (less_u2_2_lo - less_u2_2_sum_right))
    less_l2_1 = less_u2_2_sum / less_divisor2_sum
    less_l2_1_product = less_l2_1 * less_divisor2_sum
    less_l2_1_numerator = (less_u2_2_sum - less_l2_1_product
        - product_error(less_l2_1, less_divisor2_sum, less_l2_1_product) + less_u2_2_sum_lo)
    less_l2_1_lo = (less_l2_1_numerator - less_l2_1 * less_divisor2_sum_lo) / less_divisor2_sum
    less_u2_3_sum = less_u2_3 + less_u2_3_lo
    less_u2_3_sum_right = less_u2_3_sum - less_u2_3
    less_u2_3_sum_lo = (less_u2_3 - (less_u2_3_sum - less_u2_3_sum_right)
        + (less_u2_3_lo - less_u2_3_sum_right))
    less_l2_2 = less_u2_3_sum / less_divisor2_sum
    less_l2_2_product = less_l2_2 * less_divisor2_sum
    less_l2_2_numerator = (less_u2_3_sum - less_l2_2_product
        - product_error(less_l2_2, less_divisor2_sum, less_l2_2_product) + less_u2_3_sum_lo)
    less_u3_0a = A_30 * less_l0_2
    less_u3_0b = less_3 - less_u3_0a
    less_u3_0b_right = less_3 - less_u3_0b
    less_u3_0b_left_rest = product_rest(A_33, 0.9999999999999944, less_3,
        less_u3_0b + less_u3_0b_right)
    less_u3_0c = less_u1_2_sum * less_l1_1
    less_u3_0d = less_u3_0b - less_u3_0c
    less_u3_0d_right = less_u3_0b - less_u3_0d
    less_u3_0d_lo1 = (less_u3_0b - (less_u3_0d + less_u3_0d_right)
        - product_rest(less_u1_2_sum, less_l1_1, less_u3_0c, less_u3_0d_right))
    less_u3_0b_lo = (less_u3_0b_left_rest
        - product_rest(A_30, less_l0_2, less_u3_0a, less_u3_0b_right) - A_30 * less_l0_2_lo)
    less_u3_0e = less_u2_1_sum * less_l2_0
    less_u3_0 = less_u3_0d - less_u3_0e
    less_u3_0_right = less_u3_0d - less_u3_0
    less_u3_0_lo1 = (less_u3_0d - (less_u3_0 + less_u3_0_right)
        - product_rest(less_u2_1_sum, less_l2_0, less_u3_0e, less_u3_0_right))
    less_u3_0d_lo = (less_u3_0d_lo1 - (less_u1_2_sum_lo * less_l1_1 + less_u1_2_sum * less_l1_1_lo)
        + less_u3_0b_lo)
    less_u3_0_lo = (less_u3_0_lo1 - (less_u2_1_sum_lo * less_l2_0 + less_u2_1_sum * less_l2_0_lo)
        + less_u3_0d_lo)
    less_u3_1a = A_40 * less_l0_2
    less_u3_1b = A_43 - less_u3_1a
    less_u3_1b_right = A_43 - less_u3_1b
    less_u3_1c = less_u1_3_sum * less_l1_1
    less_u3_1d = less_u3_1b - less_u3_1c
    less_u3_1d_right = less_u3_1b - less_u3_1d
    less_u3_1d_lo1 = (less_u3_1b - (less_u3_1d + less_u3_1d_right)
        - product_rest(less_u1_3_sum, less_l1_1, less_u3_1c, less_u3_1d_right))
    less_u3_1b_lo = (A_43 - (less_u3_1b + less_u3_1b_right)
        - product_rest(A_40, less_l0_2, less_u3_1a, less_u3_1b_right) - A_40 * less_l0_2_lo)
    less_u3_1e = less_u2_2_sum * less_l2_0
    less_u3_1 = less_u3_1d - less_u3_1e
    less_u3_1_right = less_u3_1d - less_u3_1
    less_u3_1_lo1 = (less_u3_1d - (less_u3_1 + less_u3_1_right)
        - product_rest(less_u2_2_sum, less_l2_0, less_u3_1e, less_u3_1_right))
    less_u3_1d_lo = (less_u3_1d_lo1 - (less_u1_3_sum_lo * less_l1_1 + less_u1_3_sum * less_l1_1_lo)
        + less_u3_1b_lo)
    less_u3_1_lo = (less_u3_1_lo1 - (less_u2_2_sum_lo * less_l2_0 + less_u2_2_sum * less_l2_0_lo)
        + less_u3_1d_lo)
    less_u3_2a = A_50 * less_l0_2
    less_u3_2b = A_53 - less_u3_2a
    less_u3_2b_right = A_53 - less_u3_2b
    less_u3_2c = less_u1_4_sum * less_l1_1
    less_u3_2d = less_u3_2b - less_u3_2c
    less_u3_2d_right = less_u3_2b - less_u3_2d
    less_u3_2d_lo1 = (less_u3_2b - (less_u3_2d + less_u3_2d_right)
        - product_rest(less_u1_4_sum, less_l1_1, less_u3_2c, less_u3_2d_right))
    less_u3_2b_lo = (A_53 - (less_u3_2b + less_u3_2b_right)
        - product_rest(A_50, less_l0_2, less_u3_2a, less_u3_2b_right) - A_50 * less_l0_2_lo)
    less_u3_2e = less_u2_3_sum * less_l2_0
    less_u3_2 = less_u3_2d - less_u3_2e
    less_u3_2_right = less_u3_2d - less_u3_2
    less_u3_2_lo1 = (less_u3_2d - (less_u3_2 + less_u3_2_right)
        - product_rest(less_u2_3_sum, less_l2_0, less_u3_2e, less_u3_2_right))
    less_u3_2d_lo = (less_u3_2d_lo1 - (less_u1_4_sum_lo * less_l1_1 + less_u1_4_sum * less_l1_1_lo)
        + less_u3_2b_lo)
    less_u3_2_lo = (less_u3_2_lo1 - (less_u2_3_sum_lo * less_l2_0 + less_u2_3_sum * less_l2_0_lo)
        + less_u3_2d_lo)
    less_u3_0_sum = less_u3_0 + less_u3_0_lo
    less_u3_0_sum_right = less_u3_0_sum - less_u3_0
    less_divisor3a = 0 < less_u3_0_sum
    less_divisor3 = where(less_divisor3a, less_u3_0_sum, 1)
    less_divisor3_lo = where(less_divisor3a,
        less_u3_0 - (less_u3_0_sum - less_u3_0_sum_right) + (less_u3_0_lo - less_u3_0_sum_right), 0)
    less_u3_1_sum = less_u3_1 + less_u3_1_lo
    less_u3_1_sum_right = less_u3_1_sum - less_u3_1
    less_u3_1_sum_lo = (less_u3_1 - (less_u3_1_sum - less_u3_1_sum_right)
        + (less_u3_1_lo - less_u3_1_sum_right))
    less_divisor3_sum = less_divisor3 + less_divisor3_lo
    less_divisor3_sum_right = less_divisor3_sum - less_divisor3
    less_divisor3_sum_lo = (less_divisor3 - (less_divisor3_sum - less_divisor3_sum_right)
        + (less_divisor3_lo - less_divisor3_sum_right))
    less_l3_0 = less_u3_1_sum / less_divisor3_sum
    less_l3_0_product = less_l3_0 * less_divisor3_sum
    less_l3_0_numerator = (less_u3_1_sum - less_l3_0_product
        - product_error(less_l3_0, less_divisor3_sum, less_l3_0_product) + less_u3_1_sum_lo)
    less_l3_0_lo = (less_l3_0_numerator - less_l3_0 * less_divisor3_sum_lo) / less_divisor3_sum
    less_u3_2_sum = less_u3_2 + less_u3_2_lo
    less_u3_2_sum_right = less_u3_2_sum - less_u3_2
    less_u3_2_sum_lo = (less_u3_2 - (less_u3_2_sum - less_u3_2_sum_right)
        + (less_u3_2_lo - less_u3_2_sum_right))
    less_l3_1 = less_u3_2_sum / less_divisor3_sum
    less_l3_1_product = less_l3_1 * less_divisor3_sum
    less_l3_1_numerator = (less_u3_2_sum - less_l3_1_product
        - product_error(less_l3_1, less_divisor3_sum, less_l3_1_product) + less_u3_2_sum_lo)
    less_u4_0a = A_40 * less_l0_3
    less_u4_0b = less_4 - less_u4_0a
    less_u4_0b_right = less_4 - less_u4_0b
    less_u4_0b_left_rest = product_rest(A_44, 0.9999999999999944, less_4,
        less_u4_0b + less_u4_0b_right)
    less_u4_0c = less_u1_3_sum * less_l1_2
    less_u4_0d = less_u4_0b - less_u4_0c
    less_u4_0d_right = less_u4_0b - less_u4_0d
    less_u4_0d_lo1 = (less_u4_0b - (less_u4_0d + less_u4_0d_right)
        - product_rest(less_u1_3_sum, less_l1_2, less_u4_0c, less_u4_0d_right))
    less_u4_0b_lo = (less_u4_0b_left_rest
        - product_rest(A_40, less_l0_3, less_u4_0a, less_u4_0b_right) - A_40 * less_l0_3_lo)
    less_u4_0e = less_u2_2_sum * less_l2_1
    less_u4_0f = less_u4_0d - less_u4_0e
    less_u4_0f_right = less_u4_0d - less_u4_0f
    less_u4_0f_lo1 = (less_u4_0d - (less_u4_0f + less_u4_0f_right)
        - product_rest(less_u2_2_sum, less_l2_1, less_u4_0e, less_u4_0f_right))
    less_u4_0d_lo = (less_u4_0d_lo1 - (less_u1_3_sum_lo * less_l1_2 + less_u1_3_sum * less_l1_2_lo)
        + less_u4_0b_lo)
    less_u4_0g = less_u3_1_sum * less_l3_0
    less_u4_0 = less_u4_0f - less_u4_0g
    less_u4_0_right = less_u4_0f - less_u4_0
    less_u4_0_lo1 = (less_u4_0f - (less_u4_0 + less_u4_0_right)
        - product_rest(less_u3_1_sum, less_l3_0, less_u4_0g, less_u4_0_right))
    less_u4_0f_lo = (less_u4_0f_lo1 - (less_u2_2_sum_lo * less_l2_1 + less_u2_2_sum * less_l2_1_lo)
        + less_u4_0d_lo)
    less_u4_0_lo = (less_u4_0_lo1 - (less_u3_1_sum_lo * less_l3_0 + less_u3_1_sum * less_l3_0_lo)
        + less_u4_0f_lo)
    less_u4_1a = A_50 * less_l0_3
    less_u4_1b = A_54 - less_u4_1a
    less_u4_1b_right = A_54 - less_u4_1b
    less_u4_1c = less_u1_4_sum * less_l1_2
    less_u4_1d = less_u4_1b - less_u4_1c
    less_u4_1d_right = less_u4_1b - less_u4_1d
    less_u4_1d_lo1 = (less_u4_1b - (less_u4_1d + less_u4_1d_right)
        - product_rest(less_u1_4_sum, less_l1_2, less_u4_1c, less_u4_1d_right))
    less_u4_1b_lo = (A_54 - (less_u4_1b + less_u4_1b_right)
        - product_rest(A_50, less_l0_3, less_u4_1a, less_u4_1b_right) - A_50 * less_l0_3_lo)
    less_u4_1e = less_u2_3_sum * less_l2_1
    less_u4_1f = less_u4_1d - less_u4_1e
    less_u4_1f_right = less_u4_1d - less_u4_1f
    less_u4_1f_lo1 = (less_u4_1d - (less_u4_1f + less_u4_1f_right)
        - product_rest(less_u2_3_sum, less_l2_1, less_u4_1e, less_u4_1f_right))
    less_u4_1d_lo = (less_u4_1d_lo1 - (less_u1_4_sum_lo * less_l1_2 + less_u1_4_sum * less_l1_2_lo)
        + less_u4_1b_lo)
    less_u4_1g = less_u3_2_sum * less_l3_0
    less_u4_1 = less_u4_1f - less_u4_1g
    less_u4_1_right = less_u4_1f - less_u4_1
    less_u4_1_lo1 = (less_u4_1f - (less_u4_1 + less_u4_1_right)
        - product_rest(less_u3_2_sum, less_l3_0, less_u4_1g, less_u4_1_right))
    less_u4_1f_lo = (less_u4_1f_lo1 - (less_u2_3_sum_lo * less_l2_1 + less_u2_3_sum * less_l2_1_lo)
        + less_u4_1d_lo)
    less_u4_1_lo = (less_u4_1_lo1 - (less_u3_2_sum_lo * less_l3_0 + less_u3_2_sum * less_l3_0_lo)
        + less_u4_1f_lo)
    less_u4_0_sum = less_u4_0 + less_u4_0_lo
    less_u4_0_sum_right = less_u4_0_sum - less_u4_0
    less_divisor4a = 0 < less_u4_0_sum
    less_divisor4 = where(less_divisor4a, less_u4_0_sum, 1)
    less_divisor4_lo = where(less_divisor4a,
        less_u4_0 - (less_u4_0_sum - less_u4_0_sum_right) + (less_u4_0_lo - less_u4_0_sum_right), 0)
    less_u4_1_sum = less_u4_1 + less_u4_1_lo
    less_u4_1_sum_right = less_u4_1_sum - less_u4_1
    less_u4_1_sum_lo = (less_u4_1 - (less_u4_1_sum - less_u4_1_sum_right)
        + (less_u4_1_lo - less_u4_1_sum_right))
    less_divisor4_sum = less_divisor4 + less_divisor4_lo
    less_divisor4_sum_right = less_divisor4_sum - less_divisor4
    less_l4 = less_u4_1_sum / less_divisor4_sum
    less_l4_product = less_l4 * less_divisor4_sum
    less_l4_cross = (less_l4
        * (less_divisor4 - (less_divisor4_sum - less_divisor4_sum_right)
        + (less_divisor4_lo - less_divisor4_sum_right)))
    less_l4_residual = (less_u4_1_sum - less_l4_product
        - product_error(less_l4, less_divisor4_sum, less_l4_product) + less_u4_1_sum_lo
        - less_l4_cross)
    less_u5a = A_50 * less_l0_4
    less_u5b = less_5 - less_u5a
    less_u5b_right = less_5 - less_u5b
    less_u5b_lo1 = (product_rest(A_55, 0.9999999999999944, less_5, less_u5b + less_u5b_right)
        - product_rest(A_50, less_l0_4, less_u5a, less_u5b_right))
    less_u5c = less_u1_4_sum * less_l1_3
    less_u5d = less_u5b - less_u5c
    less_u5d_right = less_u5b - less_u5d
    less_u5c_cross = (less_u1_4_sum_lo * less_l1_3 + less_u1_4_sum
        * ((less_l1_3_numerator - less_l1_3 * less_divisor1_sum_lo) / less_divisor1_sum))
    less_u5d_lo2 = (less_u5b - (less_u5d + less_u5d_right)
        - product_rest(less_u1_4_sum, less_l1_3, less_u5c, less_u5d_right) - less_u5c_cross)
    less_u5e = less_u2_3_sum * less_l2_2
    less_u5f = less_u5d - less_u5e
    less_u5f_right = less_u5d - less_u5f
    less_u5e_cross = (less_u2_3_sum_lo * less_l2_2 + less_u2_3_sum
        * ((less_l2_2_numerator - less_l2_2 * less_divisor2_sum_lo) / less_divisor2_sum))
    less_u5f_lo2 = (less_u5d - (less_u5f + less_u5f_right)
        - product_rest(less_u2_3_sum, less_l2_2, less_u5e, less_u5f_right) - less_u5e_cross)
    less_u5g = less_u3_2_sum * less_l3_1
    less_u5h = less_u5f - less_u5g
    less_u5h_right = less_u5f - less_u5h
    less_u5g_cross = (less_u3_2_sum_lo * less_l3_1 + less_u3_2_sum
        * ((less_l3_1_numerator - less_l3_1 * less_divisor3_sum_lo) / less_divisor3_sum))
    less_u5h_lo2 = (less_u5f - (less_u5h + less_u5h_right)
        - product_rest(less_u3_2_sum, less_l3_1, less_u5g, less_u5h_right) - less_u5g_cross)
    less_u5i = less_u4_1_sum * less_l4
    less_u5 = less_u5h - less_u5i
    less_u5_right = less_u5h - less_u5
    less_u5_lo1 = (less_u5h - (less_u5 + less_u5_right)
        - product_rest(less_u4_1_sum, less_l4, less_u5i, less_u5_right))
    less_u5h_lo = (less_u5h_lo2
        + (less_u5f_lo2
        + (less_u5d_lo2 + (less_u5b_lo1 - A_50 * (less_l0_4_residual / less_divisor0_sum)))))
    regular_a = (0 < less_u5
        + (less_u5_lo1
        - (less_u4_1_sum_lo * less_l4 + less_u4_1_sum * (less_l4_residual / less_divisor4_sum))
        + less_u5h_lo))
    regular_f = where(less_divisor1a, where(less_divisor2a, where(less_divisor3a,
        where(less_divisor4a, where(regular_a, real(1), real(0)), 0), 0), 0), 0)
    regular = where(less_divisor0a, regular_f, 0)
    smallest5_sum = smallest5 + smallest5_lo
    smallest5_sum_right = smallest5_sum - smallest5
    smallest5_sum_lo = (smallest5 - (smallest5_sum - smallest5_sum_right)
        + (smallest5_lo - smallest5_sum_right))
    least_a = smallest5_sum < 0
    least = where(least_a, smallest5_sum, 0)
    y1a = b_0 * l0_0
    y1 = b_1 - y1a
    y1_right = b_1 - y1
    y1_lo = b_1 - (y1 + y1_right) - product_rest(b_0, l0_0, y1a, y1_right) - b_0 * l0_0_lo
    y2a = b_0 * l0_1
    y2b = b_2 - y2a
    y2b_right = b_2 - y2b
    y2c = l1_0 * y1
    y2 = y2b - y2c
    y2_right = y2b - y2
    y2_lo2 = (y2b - (y2 + y2_right) - product_rest(l1_0, y1, y2c, y2_right)
        - (l1_0_lo * y1 + l1_0 * y1_lo))
    y2_lo = (y2_lo2
        + (b_2 - (y2b + y2b_right) - product_rest(b_0, l0_1, y2a, y2b_right) - b_0 * l0_1_lo))
    y3a = b_0 * l0_2
    y3b = b_3 - y3a
    y3b_right = b_3 - y3b
    y3c = l1_1 * y1
    y3d = y3b - y3c
    y3d_right = y3b - y3d
    y3d_lo2 = (y3b - (y3d + y3d_right) - product_rest(l1_1, y1, y3c, y3d_right)
        - (l1_1_lo * y1 + l1_1 * y1_lo))
    y3e = l2_0 * y2
    y3 = y3d - y3e
    y3_right = y3d - y3
    y3_lo2 = (y3d - (y3 + y3_right) - product_rest(l2_0, y2, y3e, y3_right)
        - (l2_0_lo * y2 + l2_0 * y2_lo))
    y3_lo = (y3_lo2
        + (y3d_lo2
        + (b_3 - (y3b + y3b_right) - product_rest(b_0, l0_2, y3a, y3b_right) - b_0 * l0_2_lo)))
    y4a = b_0 * l0_3
    y4b = b_4 - y4a
    y4b_right = b_4 - y4b
    y4c = l1_2 * y1
    y4d = y4b - y4c
    y4d_right = y4b - y4d
    y4d_lo2 = (y4b - (y4d + y4d_right) - product_rest(l1_2, y1, y4c, y4d_right)
        - (l1_2_lo * y1 + l1_2 * y1_lo))
    y4e = l2_1 * y2
    y4f = y4d - y4e
    y4f_right = y4d - y4f
    y4f_lo2 = (y4d - (y4f + y4f_right) - product_rest(l2_1, y2, y4e, y4f_right)
        - (l2_1_lo * y2 + l2_1 * y2_lo))
    y4g = l3_0 * y3
    y4 = y4f - y4g
    y4_right = y4f - y4
    y4f_lo = (y4f_lo2
        + (y4d_lo2
        + (b_4 - (y4b + y4b_right) - product_rest(b_0, l0_3, y4a, y4b_right) - b_0 * l0_3_lo)))
    y4_lo = (y4f - (y4 + y4_right) - product_rest(l3_0, y3, y4g, y4_right)
        - (l3_0_lo * y3 + l3_0 * y3_lo) + y4f_lo)
    y5a = b_0 * l0_4
    y5b = b_5 - y5a
    y5b_right = b_5 - y5b
    y5c = l1_3 * y1
    y5d = y5b - y5c
    y5d_right = y5b - y5d
    y5d_lo2 = (y5b - (y5d + y5d_right) - product_rest(l1_3, y1, y5c, y5d_right)
        - (l1_3_lo * y1 + l1_3 * y1_lo))
    y5e = l2_2 * y2
    y5f = y5d - y5e
    y5f_right = y5d - y5f
    y5f_lo2 = (y5d - (y5f + y5f_right) - product_rest(l2_2, y2, y5e, y5f_right)
        - (l2_2_lo * y2 + l2_2 * y2_lo))
    y5g = l3_1 * y3
    y5h = y5f - y5g
    y5h_right = y5f - y5h
    y5f_lo = (y5f_lo2
        + (y5d_lo2
        + (b_5 - (y5b + y5b_right) - product_rest(b_0, l0_4, y5a, y5b_right) - b_0 * l0_4_lo)))
    y5i = l4 * y4
    y5 = y5h - y5i
    y5_right = y5h - y5
    y5h_lo = (y5f - (y5h + y5h_right) - product_rest(l3_1, y3, y5g, y5h_right)
        - (l3_1_lo * y3 + l3_1 * y3_lo) + y5f_lo)
    y5_lo = (y5h - (y5 + y5_right) - product_rest(l4, y4, y5i, y5_right)
        - (l4_lo * y4 + l4 * y4_lo) + y5h_lo)
    z0 = b_0 / divisor0
    z0_product = z0 * divisor0
    y1_sum = y1 + y1_lo
    y1_sum_right = y1_sum - y1
    z1 = y1_sum / divisor1_sum
    z1_product = z1 * divisor1_sum
    z1_numerator = (y1_sum - z1_product - product_error(z1, divisor1_sum, z1_product)
        + (y1 - (y1_sum - y1_sum_right) + (y1_lo - y1_sum_right)))
    y2_sum = y2 + y2_lo
    y2_sum_right = y2_sum - y2
    z2 = y2_sum / divisor2_sum
    z2_product = z2 * divisor2_sum
    z2_numerator = (y2_sum - z2_product - product_error(z2, divisor2_sum, z2_product)
        + (y2 - (y2_sum - y2_sum_right) + (y2_lo - y2_sum_right)))
    y3_sum = y3 + y3_lo
    y3_sum_right = y3_sum - y3
    z3 = y3_sum / divisor3_sum
    z3_product = z3 * divisor3_sum
    z3_numerator = (y3_sum - z3_product - product_error(z3, divisor3_sum, z3_product)
        + (y3 - (y3_sum - y3_sum_right) + (y3_lo - y3_sum_right)))
    y4_sum = y4 + y4_lo
    y4_sum_right = y4_sum - y4
    z4 = y4_sum / divisor4_sum
    z4_product = z4 * divisor4_sum
    z4_numerator = (y4_sum - z4_product - product_error(z4, divisor4_sum, z4_product)
        + (y4 - (y4_sum - y4_sum_right) + (y4_lo - y4_sum_right)))
    y5_sum = y5 + y5_lo
    y5_sum_right = y5_sum - y5
    divisor5_sum = divisor5 + divisor5_lo
    divisor5_sum_right = divisor5_sum - divisor5
    divisor5_sum_lo = (divisor5 - (divisor5_sum - divisor5_sum_right)
        + (divisor5_lo - divisor5_sum_right))
    z5 = y5_sum / divisor5_sum
    z5_product = z5 * divisor5_sum
    z5_numerator = (y5_sum - z5_product - product_error(z5, divisor5_sum, z5_product)
        + (y5 - (y5_sum - y5_sum_right) + (y5_lo - y5_sum_right)))
    z5_lo = (z5_numerator - z5 * divisor5_sum_lo) / divisor5_sum
    x4a = l4 * z5
    x4 = z4 - x4a
    x4_right = z4 - x4
    x4_lo = (z4 - (x4 + x4_right) - product_rest(l4, z5, x4a, x4_right) - (l4_lo * z5 + l4 * z5_lo)
        + (z4_numerator - z4 * divisor4_sum_lo) / divisor4_sum)
    x3a = l3_0 * x4
    x3b = z3 - x3a
    x3b_right = z3 - x3b
    x3b_lo2 = (z3 - (x3b + x3b_right) - product_rest(l3_0, x4, x3a, x3b_right)
        - (l3_0_lo * x4 + l3_0 * x4_lo))
    x3c = l3_1 * z5
    x3 = x3b - x3c
    x3_right = x3b - x3
    x3_lo2 = (x3b - (x3 + x3_right) - product_rest(l3_1, z5, x3c, x3_right)
        - (l3_1_lo * z5 + l3_1 * z5_lo))
    x3_lo = x3_lo2 + (x3b_lo2 + (z3_numerator - z3 * divisor3_sum_lo) / divisor3_sum)
    x2a = l2_0 * x3
    x2b = z2 - x2a
    x2b_right = z2 - x2b
    x2b_lo2 = (z2 - (x2b + x2b_right) - product_rest(l2_0, x3, x2a, x2b_right)
        - (l2_0_lo * x3 + l2_0 * x3_lo))
    x2c = l2_1 * x4
    x2d = x2b - x2c
    x2d_right = x2b - x2d
    x2d_lo2 = (x2b - (x2d + x2d_right) - product_rest(l2_1, x4, x2c, x2d_right)
        - (l2_1_lo * x4 + l2_1 * x4_lo))
    x2e = l2_2 * z5
    x2 = x2d - x2e
    x2_right = x2d - x2
    x2_lo2 = (x2d - (x2 + x2_right) - product_rest(l2_2, z5, x2e, x2_right)
        - (l2_2_lo * z5 + l2_2 * z5_lo))
    x2_lo = x2_lo2 + (x2d_lo2 + (x2b_lo2 + (z2_numerator - z2 * divisor2_sum_lo) / divisor2_sum))
    x1a = l1_0 * x2
    x1b = z1 - x1a
    x1b_right = z1 - x1b
    x1b_lo2 = (z1 - (x1b + x1b_right) - product_rest(l1_0, x2, x1a, x1b_right)
        - (l1_0_lo * x2 + l1_0 * x2_lo))
    x1c = l1_1 * x3
    x1d = x1b - x1c
    x1d_right = x1b - x1d
    x1d_lo2 = (x1b - (x1d + x1d_right) - product_rest(l1_1, x3, x1c, x1d_right)
        - (l1_1_lo * x3 + l1_1 * x3_lo))
    x1e = l1_2 * x4
    x1f = x1d - x1e
    x1f_right = x1d - x1f
    x1f_lo2 = (x1d - (x1f + x1f_right) - product_rest(l1_2, x4, x1e, x1f_right)
        - (l1_2_lo * x4 + l1_2 * x4_lo))
    x1g = l1_3 * z5
    x1 = x1f - x1g
    x1_right = x1f - x1
    x1_lo2 = (x1f - (x1 + x1_right) - product_rest(l1_3, z5, x1g, x1_right)
        - (l1_3_lo * z5 + l1_3 * z5_lo))
    x1_lo = (x1_lo2
        + (x1f_lo2 + (x1d_lo2 + (x1b_lo2 + (z1_numerator - z1 * divisor1_sum_lo) / divisor1_sum))))
    x0a = l0_0 * x1
    x0b = z0 - x0a
    x0b_right = z0 - x0b
    x0b_lo2 = (z0 - (x0b + x0b_right) - product_rest(l0_0, x1, x0a, x0b_right)
        - (l0_0_lo * x1 + l0_0 * x1_lo))
    x0c = l0_1 * x2
    x0d = x0b - x0c
    x0d_right = x0b - x0d
    x0d_lo2 = (x0b - (x0d + x0d_right) - product_rest(l0_1, x2, x0c, x0d_right)
        - (l0_1_lo * x2 + l0_1 * x2_lo))
    x0e = l0_2 * x3
    x0f = x0d - x0e
    x0f_right = x0d - x0f
    x0f_lo2 = (x0d - (x0f + x0f_right) - product_rest(l0_2, x3, x0e, x0f_right)
        - (l0_2_lo * x3 + l0_2 * x3_lo))
    x0g = l0_3 * x4
    x0h = x0f - x0g
    x0h_right = x0f - x0h
    x0f_lo = (x0f_lo2
        + (x0d_lo2
        + (x0b_lo2 + (b_0 - z0_product - product_error(z0, divisor0, z0_product)) / divisor0)))
    x0i = l0_4 * z5
    x0 = x0h - x0i
    x0_right = x0h - x0
    x0h_lo = (x0f - (x0h + x0h_right) - product_rest(l0_3, x4, x0g, x0h_right)
        - (l0_3_lo * x4 + l0_3 * x4_lo) + x0f_lo)
    x0_lo = (x0h - (x0 + x0_right) - product_rest(l0_4, z5, x0i, x0_right)
        - (l0_4_lo * z5 + l0_4 * z5_lo) + x0h_lo)
    residual_0a = A_00 * x0
    residual_0b = b_0 - residual_0a
    residual_0b_right = b_0 - residual_0b
    residual_0c = A_10 * x1
    residual_0d = residual_0b - residual_0c
    residual_0d_right = residual_0b - residual_0d
    residual_0d_lo2 = (residual_0b - (residual_0d + residual_0d_right)
        - product_rest(A_10, x1, residual_0c, residual_0d_right) - A_10 * x1_lo)
    residual_0e = A_20 * x2
    residual_0f = residual_0d - residual_0e
    residual_0f_right = residual_0d - residual_0f
    residual_0d_lo = (residual_0d_lo2
        + (b_0 - (residual_0b + residual_0b_right)
        - product_rest(A_00, x0, residual_0a, residual_0b_right) - A_00 * x0_lo))
    residual_0f_lo2 = (residual_0d - (residual_0f + residual_0f_right)
        - product_rest(A_20, x2, residual_0e, residual_0f_right) - A_20 * x2_lo)
    residual_0g = A_30 * x3
    residual_0h = residual_0f - residual_0g
    residual_0h_right = residual_0f - residual_0h
    residual_0h_lo2 = (residual_0f - (residual_0h + residual_0h_right)
        - product_rest(A_30, x3, residual_0g, residual_0h_right) - A_30 * x3_lo)
    residual_0i = A_40 * x4
    residual_0j = residual_0h - residual_0i
    residual_0j_right = residual_0h - residual_0j
    residual_0j_lo2 = (residual_0h - (residual_0j + residual_0j_right)
        - product_rest(A_40, x4, residual_0i, residual_0j_right) - A_40 * x4_lo)
    residual_0k = A_50 * z5
    residual_0 = residual_0j - residual_0k
    residual_0_right = residual_0j - residual_0
    residual_0_lo2 = (residual_0j - (residual_0 + residual_0_right)
        - product_rest(A_50, z5, residual_0k, residual_0_right) - A_50 * z5_lo)
    residual_0_lo = (residual_0_lo2
        + (residual_0j_lo2 + (residual_0h_lo2 + (residual_0f_lo2 + residual_0d_lo))))
    residual_1a = A_10 * x0
    residual_1b = b_1 - residual_1a
    residual_1b_right = b_1 - residual_1b
    residual_1c = A_11 * x1
    residual_1d = residual_1b - residual_1c
    residual_1d_right = residual_1b - residual_1d
    residual_1d_lo2 = (residual_1b - (residual_1d + residual_1d_right)
        - product_rest(A_11, x1, residual_1c, residual_1d_right) - A_11 * x1_lo)
    residual_1e = A_21 * x2
    residual_1f = residual_1d - residual_1e
    residual_1f_right = residual_1d - residual_1f
    residual_1d_lo = (residual_1d_lo2
        + (b_1 - (residual_1b + residual_1b_right)
        - product_rest(A_10, x0, residual_1a, residual_1b_right) - A_10 * x0_lo))
    residual_1f_lo2 = (residual_1d - (residual_1f + residual_1f_right)
        - product_rest(A_21, x2, residual_1e, residual_1f_right) - A_21 * x2_lo)
    residual_1g = A_31 * x3
    residual_1h = residual_1f - residual_1g
    residual_1h_right = residual_1f - residual_1h
    residual_1h_lo2 = (residual_1f - (residual_1h + residual_1h_right)
        - product_rest(A_31, x3, residual_1g, residual_1h_right) - A_31 * x3_lo)
    residual_1i = A_41 * x4
    residual_1j = residual_1h - residual_1i
    residual_1j_right = residual_1h - residual_1j
    residual_1j_lo2 = (residual_1h - (residual_1j + residual_1j_right)
        - product_rest(A_41, x4, residual_1i, residual_1j_right) - A_41 * x4_lo)
    residual_1k = A_51 * z5
    residual_1 = residual_1j - residual_1k
    residual_1_right = residual_1j - residual_1
    residual_1_lo2 = (residual_1j - (residual_1 + residual_1_right)
        - product_rest(A_51, z5, residual_1k, residual_1_right) - A_51 * z5_lo)
    residual_2a = A_20 * x0
    residual_2b = b_2 - residual_2a
    residual_2b_right = b_2 - residual_2b
    residual_2c = A_21 * x1
    residual_2d = residual_2b - residual_2c
    residual_2d_right = residual_2b - residual_2d
    residual_2d_lo2 = (residual_2b - (residual_2d + residual_2d_right)
        - product_rest(A_21, x1, residual_2c, residual_2d_right) - A_21 * x1_lo)
    residual_2e = A_22 * x2
    residual_2f = residual_2d - residual_2e
    residual_2f_right = residual_2d - residual_2f
    residual_2d_lo = (residual_2d_lo2
        + (b_2 - (residual_2b + residual_2b_right)
        - product_rest(A_20, x0, residual_2a, residual_2b_right) - A_20 * x0_lo))
    residual_2f_lo2 = (residual_2d - (residual_2f + residual_2f_right)
        - product_rest(A_22, x2, residual_2e, residual_2f_right) - A_22 * x2_lo)
    residual_2g = A_32 * x3
    residual_2h = residual_2f - residual_2g
    residual_2h_right = residual_2f - residual_2h
    residual_2h_lo2 = (residual_2f - (residual_2h + residual_2h_right)
        - product_rest(A_32, x3, residual_2g, residual_2h_right) - A_32 * x3_lo)
    residual_2i = A_42 * x4
    residual_2j = residual_2h - residual_2i
    residual_2j_right = residual_2h - residual_2j
    residual_2j_lo2 = (residual_2h - (residual_2j + residual_2j_right)
        - product_rest(A_42, x4, residual_2i, residual_2j_right) - A_42 * x4_lo)
    residual_2k = A_52 * z5
    residual_2 = residual_2j - residual_2k
    residual_2_right = residual_2j - residual_2
    residual_2_lo2 = (residual_2j - (residual_2 + residual_2_right)
        - product_rest(A_52, z5, residual_2k, residual_2_right) - A_52 * z5_lo)
    residual_3a = A_30 * x0
    residual_3b = b_3 - residual_3a
    residual_3b_right = b_3 - residual_3b
    residual_3c = A_31 * x1
    residual_3d = residual_3b - residual_3c
    residual_3d_right = residual_3b - residual_3d
    residual_3d_lo2 = (residual_3b - (residual_3d + residual_3d_right)
        - product_rest(A_31, x1, residual_3c, residual_3d_right) - A_31 * x1_lo)
    residual_3e = A_32 * x2
    residual_3f = residual_3d - residual_3e
    residual_3f_right = residual_3d - residual_3f
    residual_3d_lo = (residual_3d_lo2
        + (b_3 - (residual_3b + residual_3b_right)
        - product_rest(A_30, x0, residual_3a, residual_3b_right) - A_30 * x0_lo))
    residual_3f_lo2 = (residual_3d - (residual_3f + residual_3f_right)
        - product_rest(A_32, x2, residual_3e, residual_3f_right) - A_32 * x2_lo)
    residual_3g = A_33 * x3
    residual_3h = residual_3f - residual_3g
    residual_3h_right = residual_3f - residual_3h
    residual_3h_lo2 = (residual_3f - (residual_3h + residual_3h_right)
        - product_rest(A_33, x3, residual_3g, residual_3h_right) - A_33 * x3_lo)
    residual_3i = A_43 * x4
    residual_3j = residual_3h - residual_3i
    residual_3j_right = residual_3h - residual_3j
    residual_3j_lo2 = (residual_3h - (residual_3j + residual_3j_right)
        - product_rest(A_43, x4, residual_3i, residual_3j_right) - A_43 * x4_lo)
    residual_3k = A_53 * z5
    residual_3 = residual_3j - residual_3k
    residual_3_right = residual_3j - residual_3
    residual_3_lo2 = (residual_3j - (residual_3 + residual_3_right)
        - product_rest(A_53, z5, residual_3k, residual_3_right) - A_53 * z5_lo)
    residual_4a = A_40 * x0
    residual_4b = b_4 - residual_4a
    residual_4b_right = b_4 - residual_4b
    residual_4c = A_41 * x1
    residual_4d = residual_4b - residual_4c
    residual_4d_right = residual_4b - residual_4d
    residual_4d_lo2 = (residual_4b - (residual_4d + residual_4d_right)
        - product_rest(A_41, x1, residual_4c, residual_4d_right) - A_41 * x1_lo)
    residual_4e = A_42 * x2
    residual_4f = residual_4d - residual_4e
    residual_4f_right = residual_4d - residual_4f
    residual_4d_lo = (residual_4d_lo2
        + (b_4 - (residual_4b + residual_4b_right)
        - product_rest(A_40, x0, residual_4a, residual_4b_right) - A_40 * x0_lo))
    residual_4f_lo2 = (residual_4d - (residual_4f + residual_4f_right)
        - product_rest(A_42, x2, residual_4e, residual_4f_right) - A_42 * x2_lo)
    residual_4g = A_43 * x3
    residual_4h = residual_4f - residual_4g
    residual_4h_right = residual_4f - residual_4h
    residual_4h_lo2 = (residual_4f - (residual_4h + residual_4h_right)
        - product_rest(A_43, x3, residual_4g, residual_4h_right) - A_43 * x3_lo)
    residual_4i = A_44 * x4
    residual_4j = residual_4h - residual_4i
    residual_4j_right = residual_4h - residual_4j
    residual_4j_lo2 = (residual_4h - (residual_4j + residual_4j_right)
        - product_rest(A_44, x4, residual_4i, residual_4j_right) - A_44 * x4_lo)
    residual_4k = A_54 * z5
    residual_4 = residual_4j - residual_4k
    residual_4_right = residual_4j - residual_4
    residual_4_lo2 = (residual_4j - (residual_4 + residual_4_right)
        - product_rest(A_54, z5, residual_4k, residual_4_right) - A_54 * z5_lo)
    residual_5a = A_50 * x0
    residual_5b = b_5 - residual_5a
    residual_5b_right = b_5 - residual_5b
    residual_5c = A_51 * x1
    residual_5d = residual_5b - residual_5c
    residual_5d_right = residual_5b - residual_5d
    residual_5d_lo2 = (residual_5b - (residual_5d + residual_5d_right)
        - product_rest(A_51, x1, residual_5c, residual_5d_right) - A_51 * x1_lo)
    residual_5e = A_52 * x2
    residual_5f = residual_5d - residual_5e
    residual_5f_right = residual_5d - residual_5f
    residual_5d_lo = (residual_5d_lo2
        + (b_5 - (residual_5b + residual_5b_right)
        - product_rest(A_50, x0, residual_5a, residual_5b_right) - A_50 * x0_lo))
    residual_5f_lo2 = (residual_5d - (residual_5f + residual_5f_right)
        - product_rest(A_52, x2, residual_5e, residual_5f_right) - A_52 * x2_lo)
    residual_5g = A_53 * x3
    residual_5h = residual_5f - residual_5g
    residual_5h_right = residual_5f - residual_5h
    residual_5h_lo2 = (residual_5f - (residual_5h + residual_5h_right)
        - product_rest(A_53, x3, residual_5g, residual_5h_right) - A_53 * x3_lo)
    residual_5i = A_54 * x4
    residual_5j = residual_5h - residual_5i
    residual_5j_right = residual_5h - residual_5j
    residual_5j_lo2 = (residual_5h - (residual_5j + residual_5j_right)
        - product_rest(A_54, x4, residual_5i, residual_5j_right) - A_54 * x4_lo)
    residual_5k = A_55 * z5
    residual_5 = residual_5j - residual_5k
    residual_5_right = residual_5j - residual_5
    residual_5_lo2 = (residual_5j - (residual_5 + residual_5_right)
        - product_rest(A_55, z5, residual_5k, residual_5_right) - A_55 * z5_lo)
    refined_y1a = l0_0 * residual_0
    refined_y1 = residual_1 - refined_y1a
    refined_y1_right = residual_1 - refined_y1
    refined_y1_lo1 = (residual_1 - (refined_y1 + refined_y1_right)
        - product_rest(l0_0, residual_0, refined_y1a, refined_y1_right))
    residual_1_lo = (residual_1_lo2
        + (residual_1j_lo2 + (residual_1h_lo2 + (residual_1f_lo2 + residual_1d_lo))))
    refined_y1_lo = refined_y1_lo1 - (l0_0_lo * residual_0 + l0_0 * residual_0_lo) + residual_1_lo
    refined_y2a = l0_1 * residual_0
    refined_y2b = residual_2 - refined_y2a
    refined_y2b_right = residual_2 - refined_y2b
    refined_y2b_lo1 = (residual_2 - (refined_y2b + refined_y2b_right)
        - product_rest(l0_1, residual_0, refined_y2a, refined_y2b_right))
    residual_2_lo = (residual_2_lo2
        + (residual_2j_lo2 + (residual_2h_lo2 + (residual_2f_lo2 + residual_2d_lo))))
    refined_y2c = l1_0 * refined_y1
    refined_y2 = refined_y2b - refined_y2c
    refined_y2_right = refined_y2b - refined_y2
    refined_y2_lo1 = (refined_y2b - (refined_y2 + refined_y2_right)
        - product_rest(l1_0, refined_y1, refined_y2c, refined_y2_right))
    refined_y2b_lo = refined_y2b_lo1 - (l0_1_lo * residual_0 + l0_1 * residual_0_lo) + residual_2_lo
    refined_y2_lo = refined_y2_lo1 - (l1_0_lo * refined_y1 + l1_0 * refined_y1_lo) + refined_y2b_lo
    refined_y3a = l0_2 * residual_0
    refined_y3b = residual_3 - refined_y3a
    refined_y3b_right = residual_3 - refined_y3b
    refined_y3b_lo1 = (residual_3 - (refined_y3b + refined_y3b_right)
        - product_rest(l0_2, residual_0, refined_y3a, refined_y3b_right))
    residual_3_lo = (residual_3_lo2
        + (residual_3j_lo2 + (residual_3h_lo2 + (residual_3f_lo2 + residual_3d_lo))))
    refined_y3c = l1_1 * refined_y1
    refined_y3d = refined_y3b - refined_y3c
    refined_y3d_right = refined_y3b - refined_y3d
    refined_y3d_lo1 = (refined_y3b - (refined_y3d + refined_y3d_right)
        - product_rest(l1_1, refined_y1, refined_y3c, refined_y3d_right))
    refined_y3b_lo = refined_y3b_lo1 - (l0_2_lo * residual_0 + l0_2 * residual_0_lo) + residual_3_lo
    refined_y3e = l2_0 * refined_y2
    refined_y3 = refined_y3d - refined_y3e
    refined_y3_right = refined_y3d - refined_y3
    refined_y3_lo1 = (refined_y3d - (refined_y3 + refined_y3_right)
        - product_rest(l2_0, refined_y2, refined_y3e, refined_y3_right))
    refined_y3d_lo = (refined_y3d_lo1 - (l1_1_lo * refined_y1 + l1_1 * refined_y1_lo)
        + refined_y3b_lo)
    refined_y3_lo = refined_y3_lo1 - (l2_0_lo * refined_y2 + l2_0 * refined_y2_lo) + refined_y3d_lo
    refined_y4a = l0_3 * residual_0
    refined_y4b = residual_4 - refined_y4a
    refined_y4b_right = residual_4 - refined_y4b
    refined_y4b_lo1 = (residual_4 - (refined_y4b + refined_y4b_right)
        - product_rest(l0_3, residual_0, refined_y4a, refined_y4b_right))
    residual_4_lo = (residual_4_lo2
        + (residual_4j_lo2 + (residual_4h_lo2 + (residual_4f_lo2 + residual_4d_lo))))
    refined_y4c = l1_2 * refined_y1
    refined_y4d = refined_y4b - refined_y4c
    refined_y4d_right = refined_y4b - refined_y4d
    refined_y4d_lo1 = (refined_y4b - (refined_y4d + refined_y4d_right)
        - product_rest(l1_2, refined_y1, refined_y4c, refined_y4d_right))
    refined_y4b_lo = refined_y4b_lo1 - (l0_3_lo * residual_0 + l0_3 * residual_0_lo) + residual_4_lo
    refined_y4e = l2_1 * refined_y2
    refined_y4f = refined_y4d - refined_y4e
    refined_y4f_right = refined_y4d - refined_y4f
    refined_y4f_lo1 = (refined_y4d - (refined_y4f + refined_y4f_right)
        - product_rest(l2_1, refined_y2, refined_y4e, refined_y4f_right))
    refined_y4d_lo = (refined_y4d_lo1 - (l1_2_lo * refined_y1 + l1_2 * refined_y1_lo)
        + refined_y4b_lo)
    refined_y4g = l3_0 * refined_y3
    refined_y4 = refined_y4f - refined_y4g
    refined_y4_right = refined_y4f - refined_y4
    refined_y4_lo1 = (refined_y4f - (refined_y4 + refined_y4_right)
        - product_rest(l3_0, refined_y3, refined_y4g, refined_y4_right))
    refined_y4f_lo = (refined_y4f_lo1 - (l2_1_lo * refined_y2 + l2_1 * refined_y2_lo)
        + refined_y4d_lo)
    refined_y4_lo = refined_y4_lo1 - (l3_0_lo * refined_y3 + l3_0 * refined_y3_lo) + refined_y4f_lo
    refined_y5a = l0_4 * residual_0
    refined_y5b = residual_5 - refined_y5a
    refined_y5b_right = residual_5 - refined_y5b
    refined_y5b_lo1 = (residual_5 - (refined_y5b + refined_y5b_right)
        - product_rest(l0_4, residual_0, refined_y5a, refined_y5b_right))
    residual_5_lo = (residual_5_lo2
        + (residual_5j_lo2 + (residual_5h_lo2 + (residual_5f_lo2 + residual_5d_lo))))
    refined_y5c = l1_3 * refined_y1
    refined_y5d = refined_y5b - refined_y5c
    refined_y5d_right = refined_y5b - refined_y5d
    refined_y5d_lo1 = (refined_y5b - (refined_y5d + refined_y5d_right)
        - product_rest(l1_3, refined_y1, refined_y5c, refined_y5d_right))
    refined_y5b_lo = refined_y5b_lo1 - (l0_4_lo * residual_0 + l0_4 * residual_0_lo) + residual_5_lo
    refined_y5e = l2_2 * refined_y2
    refined_y5f = refined_y5d - refined_y5e
    refined_y5f_right = refined_y5d - refined_y5f
    refined_y5f_lo1 = (refined_y5d - (refined_y5f + refined_y5f_right)
        - product_rest(l2_2, refined_y2, refined_y5e, refined_y5f_right))
    refined_y5d_lo = (refined_y5d_lo1 - (l1_3_lo * refined_y1 + l1_3 * refined_y1_lo)
        + refined_y5b_lo)
    refined_y5g = l3_1 * refined_y3
    refined_y5h = refined_y5f - refined_y5g
    refined_y5h_right = refined_y5f - refined_y5h
    refined_y5h_lo1 = (refined_y5f - (refined_y5h + refined_y5h_right)
        - product_rest(l3_1, refined_y3, refined_y5g, refined_y5h_right))
    refined_y5f_lo = (refined_y5f_lo1 - (l2_2_lo * refined_y2 + l2_2 * refined_y2_lo)
        + refined_y5d_lo)
    refined_y5i = l4 * refined_y4
    refined_y5 = refined_y5h - refined_y5i
    refined_y5_right = refined_y5h - refined_y5
    refined_y5_lo1 = (refined_y5h - (refined_y5 + refined_y5_right)
        - product_rest(l4, refined_y4, refined_y5i, refined_y5_right))
    refined_y5h_lo = (refined_y5h_lo1 - (l3_1_lo * refined_y3 + l3_1 * refined_y3_lo)
        + refined_y5f_lo)
    refined_y5_lo = refined_y5_lo1 - (l4_lo * refined_y4 + l4 * refined_y4_lo) + refined_y5h_lo
    residual_0_sum = residual_0 + residual_0_lo
    residual_0_sum_right = residual_0_sum - residual_0
    refined_z0 = residual_0_sum / divisor0
    refined_z0_product = refined_z0 * divisor0
    refined_z0_exact = (residual_0_sum - refined_z0_product
        - product_error(refined_z0, divisor0, refined_z0_product))
    refined_y1_sum = refined_y1 + refined_y1_lo
    refined_y1_sum_right = refined_y1_sum - refined_y1
    refined_z1 = refined_y1_sum / divisor1_sum
    refined_z1_product = refined_z1 * divisor1_sum
    refined_z1_exact = (refined_y1_sum - refined_z1_product
        - product_error(refined_z1, divisor1_sum, refined_z1_product))
    refined_z1_numerator = (refined_z1_exact
        + (refined_y1 - (refined_y1_sum - refined_y1_sum_right)
        + (refined_y1_lo - refined_y1_sum_right)))
    refined_y2_sum = refined_y2 + refined_y2_lo
    refined_y2_sum_right = refined_y2_sum - refined_y2
    refined_z2 = refined_y2_sum / divisor2_sum
    refined_z2_product = refined_z2 * divisor2_sum
    refined_z2_exact = (refined_y2_sum - refined_z2_product
        - product_error(refined_z2, divisor2_sum, refined_z2_product))
    refined_z2_numerator = (refined_z2_exact
        + (refined_y2 - (refined_y2_sum - refined_y2_sum_right)
        + (refined_y2_lo - refined_y2_sum_right)))
    refined_y3_sum = refined_y3 + refined_y3_lo
    refined_y3_sum_right = refined_y3_sum - refined_y3
    refined_z3 = refined_y3_sum / divisor3_sum
    refined_z3_product = refined_z3 * divisor3_sum
    refined_z3_exact = (refined_y3_sum - refined_z3_product
        - product_error(refined_z3, divisor3_sum, refined_z3_product))
    refined_z3_numerator = (refined_z3_exact
        + (refined_y3 - (refined_y3_sum - refined_y3_sum_right)
        + (refined_y3_lo - refined_y3_sum_right)))
    refined_y4_sum = refined_y4 + refined_y4_lo
    refined_y4_sum_right = refined_y4_sum - refined_y4
    refined_z4 = refined_y4_sum / divisor4_sum
    refined_z4_product = refined_z4 * divisor4_sum
    refined_z4_exact = (refined_y4_sum - refined_z4_product
        - product_error(refined_z4, divisor4_sum, refined_z4_product))
    refined_z4_numerator = (refined_z4_exact
        + (refined_y4 - (refined_y4_sum - refined_y4_sum_right)
        + (refined_y4_lo - refined_y4_sum_right)))
    refined_y5_sum = refined_y5 + refined_y5_lo
    refined_y5_sum_right = refined_y5_sum - refined_y5
    refined_z5 = refined_y5_sum / divisor5_sum
    refined_z5_product = refined_z5 * divisor5_sum
    refined_z5_exact = (refined_y5_sum - refined_z5_product
        - product_error(refined_z5, divisor5_sum, refined_z5_product))
    refined_z5_numerator = (refined_z5_exact
        + (refined_y5 - (refined_y5_sum - refined_y5_sum_right)
        + (refined_y5_lo - refined_y5_sum_right)))
    refined_z5_lo = (refined_z5_numerator - refined_z5 * divisor5_sum_lo) / divisor5_sum
    refined_x4a = l4 * refined_z5
    refined_x4 = refined_z4 - refined_x4a
    refined_x4_right = refined_z4 - refined_x4
    refined_x4_lo1 = (refined_z4 - (refined_x4 + refined_x4_right)
        - product_rest(l4, refined_z5, refined_x4a, refined_x4_right))
    refined_x4_lo = (refined_x4_lo1 - (l4_lo * refined_z5 + l4 * refined_z5_lo)
        + (refined_z4_numerator - refined_z4 * divisor4_sum_lo) / divisor4_sum)
    refined_x3a = l3_0 * refined_x4
    refined_x3b = refined_z3 - refined_x3a
    refined_x3b_right = refined_z3 - refined_x3b
    refined_x3b_lo1 = (refined_z3 - (refined_x3b + refined_x3b_right)
        - product_rest(l3_0, refined_x4, refined_x3a, refined_x3b_right))
    refined_z3_lo = (refined_z3_numerator - refined_z3 * divisor3_sum_lo) / divisor3_sum
    refined_x3c = l3_1 * refined_z5
    refined_x3 = refined_x3b - refined_x3c
    refined_x3_right = refined_x3b - refined_x3
    refined_x3_lo1 = (refined_x3b - (refined_x3 + refined_x3_right)
        - product_rest(l3_1, refined_z5, refined_x3c, refined_x3_right))
    refined_x3b_lo = refined_x3b_lo1 - (l3_0_lo * refined_x4 + l3_0 * refined_x4_lo) + refined_z3_lo
    refined_x3_lo = refined_x3_lo1 - (l3_1_lo * refined_z5 + l3_1 * refined_z5_lo) + refined_x3b_lo
    refined_x2a = l2_0 * refined_x3
    refined_x2b = refined_z2 - refined_x2a
    refined_x2b_right = refined_z2 - refined_x2b
    refined_x2b_lo1 = (refined_z2 - (refined_x2b + refined_x2b_right)
        - product_rest(l2_0, refined_x3, refined_x2a, refined_x2b_right))
    refined_z2_lo = (refined_z2_numerator - refined_z2 * divisor2_sum_lo) / divisor2_sum
    refined_x2c = l2_1 * refined_x4
    refined_x2d = refined_x2b - refined_x2c
    refined_x2d_right = refined_x2b - refined_x2d
    refined_x2d_lo1 = (refined_x2b - (refined_x2d + refined_x2d_right)
        - product_rest(l2_1, refined_x4, refined_x2c, refined_x2d_right))
    refined_x2b_lo = refined_x2b_lo1 - (l2_0_lo * refined_x3 + l2_0 * refined_x3_lo) + refined_z2_lo
    refined_x2e = l2_2 * refined_z5
    refined_x2 = refined_x2d - refined_x2e
    refined_x2_right = refined_x2d - refined_x2
    refined_x2_lo1 = (refined_x2d - (refined_x2 + refined_x2_right)
        - product_rest(l2_2, refined_z5, refined_x2e, refined_x2_right))
    refined_x2d_lo = (refined_x2d_lo1 - (l2_1_lo * refined_x4 + l2_1 * refined_x4_lo)
        + refined_x2b_lo)
    refined_x2_lo = refined_x2_lo1 - (l2_2_lo * refined_z5 + l2_2 * refined_z5_lo) + refined_x2d_lo
    refined_x1a = l1_0 * refined_x2
    refined_x1b = refined_z1 - refined_x1a
    refined_x1b_right = refined_z1 - refined_x1b
    refined_x1b_lo1 = (refined_z1 - (refined_x1b + refined_x1b_right)
        - product_rest(l1_0, refined_x2, refined_x1a, refined_x1b_right))
    refined_z1_lo = (refined_z1_numerator - refined_z1 * divisor1_sum_lo) / divisor1_sum
    refined_x1c = l1_1 * refined_x3
    refined_x1d = refined_x1b - refined_x1c
    refined_x1d_right = refined_x1b - refined_x1d
    refined_x1d_lo1 = (refined_x1b - (refined_x1d + refined_x1d_right)
        - product_rest(l1_1, refined_x3, refined_x1c, refined_x1d_right))
    refined_x1b_lo = refined_x1b_lo1 - (l1_0_lo * refined_x2 + l1_0 * refined_x2_lo) + refined_z1_lo
    refined_x1e = l1_2 * refined_x4
    refined_x1f = refined_x1d - refined_x1e
    refined_x1f_right = refined_x1d - refined_x1f
    refined_x1f_lo1 = (refined_x1d - (refined_x1f + refined_x1f_right)
        - product_rest(l1_2, refined_x4, refined_x1e, refined_x1f_right))
    refined_x1d_lo = (refined_x1d_lo1 - (l1_1_lo * refined_x3 + l1_1 * refined_x3_lo)
        + refined_x1b_lo)
    refined_x1g = l1_3 * refined_z5
    refined_x1 = refined_x1f - refined_x1g
    refined_x1_right = refined_x1f - refined_x1
    refined_x1_lo1 = (refined_x1f - (refined_x1 + refined_x1_right)
        - product_rest(l1_3, refined_z5, refined_x1g, refined_x1_right))
    refined_x1f_lo = (refined_x1f_lo1 - (l1_2_lo * refined_x4 + l1_2 * refined_x4_lo)
        + refined_x1d_lo)
    refined_x1_lo = refined_x1_lo1 - (l1_3_lo * refined_z5 + l1_3 * refined_z5_lo) + refined_x1f_lo
    refined_x0a = l0_0 * refined_x1
    refined_x0b = refined_z0 - refined_x0a
    refined_x0b_right = refined_z0 - refined_x0b
    refined_x0b_lo1 = (refined_z0 - (refined_x0b + refined_x0b_right)
        - product_rest(l0_0, refined_x1, refined_x0a, refined_x0b_right))
    refined_z0_lo = ((refined_z0_exact
        + (residual_0 - (residual_0_sum - residual_0_sum_right)
        + (residual_0_lo - residual_0_sum_right))) / divisor0)
    refined_x0c = l0_1 * refined_x2
    refined_x0d = refined_x0b - refined_x0c
    refined_x0d_right = refined_x0b - refined_x0d
    refined_x0d_lo1 = (refined_x0b - (refined_x0d + refined_x0d_right)
        - product_rest(l0_1, refined_x2, refined_x0c, refined_x0d_right))
    refined_x0b_lo = refined_x0b_lo1 - (l0_0_lo * refined_x1 + l0_0 * refined_x1_lo) + refined_z0_lo
    refined_x0e = l0_2 * refined_x3
    refined_x0f = refined_x0d - refined_x0e
    refined_x0f_right = refined_x0d - refined_x0f
    refined_x0f_lo1 = (refined_x0d - (refined_x0f + refined_x0f_right)
        - product_rest(l0_2, refined_x3, refined_x0e, refined_x0f_right))
    refined_x0d_lo = (refined_x0d_lo1 - (l0_1_lo * refined_x2 + l0_1 * refined_x2_lo)
        + refined_x0b_lo)
    refined_x0g = l0_3 * refined_x4
    refined_x0h = refined_x0f - refined_x0g
    refined_x0h_right = refined_x0f - refined_x0h
    refined_x0h_lo1 = (refined_x0f - (refined_x0h + refined_x0h_right)
        - product_rest(l0_3, refined_x4, refined_x0g, refined_x0h_right))
    refined_x0f_lo = (refined_x0f_lo1 - (l0_2_lo * refined_x3 + l0_2 * refined_x3_lo)
        + refined_x0d_lo)
    refined_x0i = l0_4 * refined_z5
    refined_x0 = refined_x0h - refined_x0i
    refined_x0_right = refined_x0h - refined_x0
    refined_x0_lo1 = (refined_x0h - (refined_x0 + refined_x0_right)
        - product_rest(l0_4, refined_z5, refined_x0i, refined_x0_right))
    refined_x0h_lo = (refined_x0h_lo1 - (l0_3_lo * refined_x4 + l0_3 * refined_x4_lo)
        + refined_x0f_lo)
    found_0 = x0 + refined_x0
    found_0_right = found_0 - x0
    refined_x0_lo = refined_x0_lo1 - (l0_4_lo * refined_z5 + l0_4 * refined_z5_lo) + refined_x0h_lo
    found_1 = x1 + refined_x1
    found_1_right = found_1 - x1
    found_2 = x2 + refined_x2
    found_2_right = found_2 - x2
    found_3 = x3 + refined_x3
    found_3_right = found_3 - x3
    found_4 = x4 + refined_x4
    found_4_right = found_4 - x4
    found_5 = z5 + refined_z5
    found_5_right = found_5 - z5
    pivot_a = regular == 1
    pivot = where(pivot_a, smallest5_sum, least)
    x_0 = where(pivot_a, found_0, nan)
    x_1 = where(pivot_a, found_1, nan)
    x_2 = where(pivot_a, found_2, nan)
    x_3 = where(pivot_a, found_3, nan)
    x_4 = where(pivot_a, found_4, nan)
    x_5 = where(pivot_a, found_5, nan)
    pivot_rounded = pivot + where(pivot_a, smallest5_sum_lo, where(least_a, smallest5_sum_lo, 0))
    x_0_rounded = (x_0
        + where(pivot_a, x0 - (found_0 - found_0_right) + (refined_x0 - found_0_right)
        + refined_x0_lo + x0_lo, 0))
    x_1_rounded = (x_1
        + where(pivot_a, x1 - (found_1 - found_1_right) + (refined_x1 - found_1_right)
        + refined_x1_lo + x1_lo, 0))
    x_2_rounded = (x_2
        + where(pivot_a, x2 - (found_2 - found_2_right) + (refined_x2 - found_2_right)
        + refined_x2_lo + x2_lo, 0))
    x_3_rounded = (x_3
        + where(pivot_a, x3 - (found_3 - found_3_right) + (refined_x3 - found_3_right)
        + refined_x3_lo + x3_lo, 0))
    x_4_rounded = (x_4
        + where(pivot_a, x4 - (found_4 - found_4_right) + (refined_x4 - found_4_right)
        + refined_x4_lo + x4_lo, 0))
    x_5_rounded = (x_5
        + where(pivot_a, z5 - (found_5 - found_5_right) + (refined_z5 - found_5_right)
        + refined_z5_lo + z5_lo, 0))
    pivot_final = where(pivot_rounded == pivot_rounded, pivot_rounded, pivot)
    x_0_final = where(x_0_rounded == x_0_rounded, x_0_rounded, x_0)
    x_1_final = where(x_1_rounded == x_1_rounded, x_1_rounded, x_1)
    x_2_final = where(x_2_rounded == x_2_rounded, x_2_rounded, x_2)
    x_3_final = where(x_3_rounded == x_3_rounded, x_3_rounded, x_3)
    x_4_final = where(x_4_rounded == x_4_rounded, x_4_rounded, x_4)
    x_5_final = where(x_5_rounded == x_5_rounded, x_5_rounded, x_5)
    return (pivot_final, x_0_final, x_1_final, x_2_final, x_3_final, x_4_final, x_5_final)
