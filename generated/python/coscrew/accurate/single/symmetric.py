# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Symmetric positive definite 3×3 and 6×6 matrices: A = L D L^T, solutions of A x = b.

In single precision, accurate tier.
"""

from numpy import float64 as real, nan, where
from coscrew._kernel import wide_kernel as kernel


@kernel("(3,3)->(),(3,3)")
def mat3x3_ldl(A):
    """L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
    triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
    not positive definite, and L is meaningless.

    (3,3)->(),(3,3).  A, L: rotation or other 3×3 matrix; pivot: number.
    4 mul, 4 add, 6 div, 6 less, 9 select.  |L D L^T - A|_ij <= 4 u sqrt(a_ii a_jj) where the
    pivot is positive, barring over- and underflow.
    """
    A_00, A_01, A_02, A_10, A_11, A_12, A_20, A_21, A_22 = A
    divisor0a = 0 < A_00
    divisor0 = where(divisor0a, A_00, 1)
    l0_0 = A_10 / divisor0
    l0_1 = A_20 / divisor0
    u1_0 = A_11 - A_10 * l0_0
    u1_1 = A_21 - A_20 * l0_0
    divisor1 = where(0 < u1_0, u1_0, 1)
    l1 = u1_1 / divisor1
    u2 = A_22 - A_20 * l0_1 - u1_1 * l1
    part0 = where(divisor0a, A_00 / divisor0, A_00)
    own1a = 0 < A_11
    own1 = where(own1a, A_11, 1)
    part1 = where(own1a, u1_0 / own1, A_11)
    smallest1 = where(part0 < part1, part0, part1)
    own2a = 0 < A_22
    own2 = where(own2a, A_22, 1)
    part2 = where(own2a, u2 / own2, A_22)
    smallest2 = where(smallest1 < part2, smallest1, part2)
    return (smallest2, A_00, 0, 0, l0_0, u1_0, 0, l0_1, l1, u2)


@kernel("(3,3),(3)->(3)")
def mat3x3_ldl_solve(L, b):
    """x = A^-1 b, L of mat3x3_ldl with a positive pivot.

    (3,3),(3)->(3).  L: rotation or other 3×3 matrix; b, x: vector.
    6 mul, 6 add, 3 div.  Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii a_jj)
    |x_j|; measured, not proved; barring over- and underflow.
    """
    L_00, L_01, L_02, L_10, L_11, L_12, L_20, L_21, L_22 = L
    b_0, b_1, b_2 = b
    y1 = b_1 - L_10 * b_0
    y2 = b_2 - L_20 * b_0 - L_21 * y1
    z0 = b_0 / L_00
    z1 = y1 / L_11
    z2 = y2 / L_22
    x1 = z1 - L_21 * z2
    x0 = z0 - L_10 * x1 - L_20 * z2
    return (x0, x1, z2)


@kernel("(3,3),(3)->(),(3)")
def mat3x3_solve(A, b):
    """x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
    Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
    rounding or indefinite (A - 50 u diag A is not positive definite).

    (3,3),(3)->(),(3).  A: rotation or other 3×3 matrix; b, x: vector; pivot: number.
    32 mul, 32 add, 15 div, 11 less, 1 equal, 20 select.  Backward error, of A: |b - A x|_i <= 4
    u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved; barring over- and underflow.
    """
    A_00, A_01, A_02, A_10, A_11, A_12, A_20, A_21, A_22 = A
    b_0, b_1, b_2 = b
    divisor0a = 0 < A_00
    divisor0 = where(divisor0a, A_00, 1)
    l0_0 = A_10 / divisor0
    l0_1 = A_20 / divisor0
    u1_0 = A_11 - A_10 * l0_0
    u1_1 = A_21 - A_20 * l0_0
    divisor1 = where(0 < u1_0, u1_0, 1)
    l1 = u1_1 / divisor1
    u2 = A_22 - A_20 * l0_1 - u1_1 * l1
    divisor2 = where(0 < u2, u2, 1)
    part0 = where(divisor0a, A_00 / divisor0, A_00)
    own1a = 0 < A_11
    own1 = where(own1a, A_11, 1)
    part1 = where(own1a, u1_0 / own1, A_11)
    smallest1 = where(part0 < part1, part0, part1)
    own2a = 0 < A_22
    own2 = where(own2a, A_22, 1)
    part2 = where(own2a, u2 / own2, A_22)
    smallest2 = where(smallest1 < part2, smallest1, part2)
    less_0 = A_00 * 0.9999970197677612
    less_1 = A_11 * 0.9999970197677612
    less_2 = A_22 * 0.9999970197677612
    less_divisor0a = 0 < less_0
    less_divisor0 = where(less_divisor0a, less_0, 1)
    less_l0_0 = A_10 / less_divisor0
    less_l0_1 = A_20 / less_divisor0
    less_u1_0 = less_1 - A_10 * less_l0_0
    less_u1_1 = A_21 - A_20 * less_l0_0
    less_divisor1a = 0 < less_u1_0
    less_divisor1 = where(less_divisor1a, less_u1_0, 1)
    less_l1 = less_u1_1 / less_divisor1
    less_u2 = less_2 - A_20 * less_l0_1 - less_u1_1 * less_l1
    regular = where(less_divisor0a, where(less_divisor1a, where(0 < less_u2, real(1), real(0)), 0),
        0)
    least = where(smallest2 < 0, smallest2, 0)
    y1 = b_1 - b_0 * l0_0
    y2 = b_2 - b_0 * l0_1 - l1 * y1
    z0 = b_0 / divisor0
    z1 = y1 / divisor1
    z2 = y2 / divisor2
    x1 = z1 - l1 * z2
    x0 = z0 - l0_0 * x1 - l0_1 * z2
    residual_0 = b_0 - A_00 * x0 - A_10 * x1 - A_20 * z2
    residual_1 = b_1 - A_10 * x0 - A_11 * x1 - A_21 * z2
    residual_2 = b_2 - A_20 * x0 - A_21 * x1 - A_22 * z2
    refined_y1 = residual_1 - l0_0 * residual_0
    refined_y2 = residual_2 - l0_1 * residual_0 - l1 * refined_y1
    refined_z0 = residual_0 / divisor0
    refined_z1 = refined_y1 / divisor1
    refined_z2 = refined_y2 / divisor2
    refined_x1 = refined_z1 - l1 * refined_z2
    refined_x0 = refined_z0 - l0_0 * refined_x1 - l0_1 * refined_z2
    found_0 = x0 + refined_x0
    found_1 = x1 + refined_x1
    found_2 = z2 + refined_z2
    pivot_a = regular == 1
    pivot = where(pivot_a, smallest2, least)
    x_0 = where(pivot_a, found_0, nan)
    x_1 = where(pivot_a, found_1, nan)
    x_2 = where(pivot_a, found_2, nan)
    return (pivot, x_0, x_1, x_2)


@kernel("(6,6)->(),(6,6)")
def mat6x6_ldl(A):
    """L, D with L D L^T = A: unit lower triangular L, with D on its diagonal; only the lower
    triangle of A is read.  Returns the smallest pivot d_i / a_ii: if it is not positive, A is
    not positive definite, and L is meaningless.

    (6,6)->(),(6,6).  A, L: 6×6 operator; pivot: number.
    35 mul, 35 add, 21 div, 15 less, 21 select.  |L D L^T - A|_ij <= 7 u sqrt(a_ii a_jj) where
    the pivot is positive, barring over- and underflow.
    """
    (A_00, A_01, A_02, A_03, A_04, A_05, A_10, A_11, A_12, A_13, A_14, A_15, A_20, A_21, A_22, A_23,
        A_24, A_25, A_30, A_31, A_32, A_33, A_34, A_35, A_40, A_41, A_42, A_43, A_44, A_45, A_50,
        A_51, A_52, A_53, A_54, A_55) = A
    divisor0a = 0 < A_00
    divisor0 = where(divisor0a, A_00, 1)
    l0_0 = A_10 / divisor0
    l0_1 = A_20 / divisor0
    l0_2 = A_30 / divisor0
    l0_3 = A_40 / divisor0
    l0_4 = A_50 / divisor0
    u1_0 = A_11 - A_10 * l0_0
    u1_1 = A_21 - A_20 * l0_0
    u1_2 = A_31 - A_30 * l0_0
    u1_3 = A_41 - A_40 * l0_0
    u1_4 = A_51 - A_50 * l0_0
    divisor1 = where(0 < u1_0, u1_0, 1)
    l1_0 = u1_1 / divisor1
    l1_1 = u1_2 / divisor1
    l1_2 = u1_3 / divisor1
    l1_3 = u1_4 / divisor1
    u2_0 = A_22 - A_20 * l0_1 - u1_1 * l1_0
    u2_1 = A_32 - A_30 * l0_1 - u1_2 * l1_0
    u2_2 = A_42 - A_40 * l0_1 - u1_3 * l1_0
    u2_3 = A_52 - A_50 * l0_1 - u1_4 * l1_0
    divisor2 = where(0 < u2_0, u2_0, 1)
    l2_0 = u2_1 / divisor2
    l2_1 = u2_2 / divisor2
    l2_2 = u2_3 / divisor2
    u3_0 = A_33 - A_30 * l0_2 - u1_2 * l1_1 - u2_1 * l2_0
    u3_1 = A_43 - A_40 * l0_2 - u1_3 * l1_1 - u2_2 * l2_0
    u3_2 = A_53 - A_50 * l0_2 - u1_4 * l1_1 - u2_3 * l2_0
    divisor3 = where(0 < u3_0, u3_0, 1)
    l3_0 = u3_1 / divisor3
    l3_1 = u3_2 / divisor3
    u4_0 = A_44 - A_40 * l0_3 - u1_3 * l1_2 - u2_2 * l2_1 - u3_1 * l3_0
    u4_1 = A_54 - A_50 * l0_3 - u1_4 * l1_2 - u2_3 * l2_1 - u3_2 * l3_0
    divisor4 = where(0 < u4_0, u4_0, 1)
    l4 = u4_1 / divisor4
    u5 = A_55 - A_50 * l0_4 - u1_4 * l1_3 - u2_3 * l2_2 - u3_2 * l3_1 - u4_1 * l4
    part0 = where(divisor0a, A_00 / divisor0, A_00)
    own1a = 0 < A_11
    own1 = where(own1a, A_11, 1)
    part1 = where(own1a, u1_0 / own1, A_11)
    smallest1 = where(part0 < part1, part0, part1)
    own2a = 0 < A_22
    own2 = where(own2a, A_22, 1)
    part2 = where(own2a, u2_0 / own2, A_22)
    smallest2 = where(smallest1 < part2, smallest1, part2)
    own3a = 0 < A_33
    own3 = where(own3a, A_33, 1)
    part3 = where(own3a, u3_0 / own3, A_33)
    smallest3 = where(smallest2 < part3, smallest2, part3)
    own4a = 0 < A_44
    own4 = where(own4a, A_44, 1)
    part4 = where(own4a, u4_0 / own4, A_44)
    smallest4 = where(smallest3 < part4, smallest3, part4)
    own5a = 0 < A_55
    own5 = where(own5a, A_55, 1)
    part5 = where(own5a, u5 / own5, A_55)
    smallest5 = where(smallest4 < part5, smallest4, part5)
    return (smallest5, A_00, 0, 0, 0, 0, 0, l0_0, u1_0, 0, 0, 0, 0, l0_1, l1_0, u2_0, 0, 0, 0, l0_2,
        l1_1, l2_0, u3_0, 0, 0, l0_3, l1_2, l2_1, l3_0, u4_0, 0, l0_4, l1_3, l2_2, l3_1, l4, u5)


@kernel("(6,6),(6)->(6)")
def mat6x6_ldl_solve(L, b):
    """x = A^-1 b, L of mat6x6_ldl with a positive pivot.

    (6,6),(6)->(6).  L: 6×6 operator; b: coscrew (f in N; τ in N m); x: screw (v in m/s; ω in
    rad/s).
    30 mul, 30 add, 6 div.  Backward error, of A = L D L^T: |b - A x|_i <= 4 u Σ_j sqrt(a_ii
    a_jj) |x_j|; measured, not proved; barring over- and underflow.
    """
    (L_00, L_01, L_02, L_03, L_04, L_05, L_10, L_11, L_12, L_13, L_14, L_15, L_20, L_21, L_22, L_23,
        L_24, L_25, L_30, L_31, L_32, L_33, L_34, L_35, L_40, L_41, L_42, L_43, L_44, L_45, L_50,
        L_51, L_52, L_53, L_54, L_55) = L
    b_0, b_1, b_2, b_3, b_4, b_5 = b
    y1 = b_1 - L_10 * b_0
    y2 = b_2 - L_20 * b_0 - L_21 * y1
    y3 = b_3 - L_30 * b_0 - L_31 * y1 - L_32 * y2
    y4 = b_4 - L_40 * b_0 - L_41 * y1 - L_42 * y2 - L_43 * y3
    y5 = b_5 - L_50 * b_0 - L_51 * y1 - L_52 * y2 - L_53 * y3 - L_54 * y4
    z0 = b_0 / L_00
    z1 = y1 / L_11
    z2 = y2 / L_22
    z3 = y3 / L_33
    z4 = y4 / L_44
    z5 = y5 / L_55
    x4 = z4 - L_54 * z5
    x3 = z3 - L_43 * x4 - L_53 * z5
    x2 = z2 - L_32 * x3 - L_42 * x4 - L_52 * z5
    x1 = z1 - L_21 * x2 - L_31 * x3 - L_41 * x4 - L_51 * z5
    x0 = z0 - L_10 * x1 - L_20 * x2 - L_30 * x3 - L_40 * x4 - L_50 * z5
    return (x0, x1, x2, x3, x4, z5)


@kernel("(6,6),(6)->(),(6)")
def mat6x6_solve(A, b):
    """x = A^-1 b with one step of refinement; A is symmetric, only its lower triangle is read.
    Returns the smallest pivot d_i / a_ii: it is not positive, and x is NaN, if A is singular to
    rounding or indefinite (A - 50 u diag A is not positive definite).

    (6,6),(6)->(),(6).  A: 6×6 operator; b: coscrew (f in N; τ in N m); pivot: number; x: screw
    (v in m/s; ω in rad/s).
    172 mul, 172 add, 48 div, 23 less, 1 equal, 41 select.  Backward error, of A: |b - A x|_i <=
    4 u Σ_j sqrt(a_ii a_jj) |x_j|; measured, not proved; barring over- and underflow.
    """
    (A_00, A_01, A_02, A_03, A_04, A_05, A_10, A_11, A_12, A_13, A_14, A_15, A_20, A_21, A_22, A_23,
        A_24, A_25, A_30, A_31, A_32, A_33, A_34, A_35, A_40, A_41, A_42, A_43, A_44, A_45, A_50,
        A_51, A_52, A_53, A_54, A_55) = A
    b_0, b_1, b_2, b_3, b_4, b_5 = b
    divisor0a = 0 < A_00
    divisor0 = where(divisor0a, A_00, 1)
    l0_0 = A_10 / divisor0
    l0_1 = A_20 / divisor0
    l0_2 = A_30 / divisor0
    l0_3 = A_40 / divisor0
    l0_4 = A_50 / divisor0
    u1_0 = A_11 - A_10 * l0_0
    u1_1 = A_21 - A_20 * l0_0
    u1_2 = A_31 - A_30 * l0_0
    u1_3 = A_41 - A_40 * l0_0
    u1_4 = A_51 - A_50 * l0_0
    divisor1 = where(0 < u1_0, u1_0, 1)
    l1_0 = u1_1 / divisor1
    l1_1 = u1_2 / divisor1
    l1_2 = u1_3 / divisor1
    l1_3 = u1_4 / divisor1
    u2_0 = A_22 - A_20 * l0_1 - u1_1 * l1_0
    u2_1 = A_32 - A_30 * l0_1 - u1_2 * l1_0
    u2_2 = A_42 - A_40 * l0_1 - u1_3 * l1_0
    u2_3 = A_52 - A_50 * l0_1 - u1_4 * l1_0
    divisor2 = where(0 < u2_0, u2_0, 1)
    l2_0 = u2_1 / divisor2
    l2_1 = u2_2 / divisor2
    l2_2 = u2_3 / divisor2
    u3_0 = A_33 - A_30 * l0_2 - u1_2 * l1_1 - u2_1 * l2_0
    u3_1 = A_43 - A_40 * l0_2 - u1_3 * l1_1 - u2_2 * l2_0
    u3_2 = A_53 - A_50 * l0_2 - u1_4 * l1_1 - u2_3 * l2_0
    divisor3 = where(0 < u3_0, u3_0, 1)
    l3_0 = u3_1 / divisor3
    l3_1 = u3_2 / divisor3
    u4_0 = A_44 - A_40 * l0_3 - u1_3 * l1_2 - u2_2 * l2_1 - u3_1 * l3_0
    u4_1 = A_54 - A_50 * l0_3 - u1_4 * l1_2 - u2_3 * l2_1 - u3_2 * l3_0
    divisor4 = where(0 < u4_0, u4_0, 1)
    l4 = u4_1 / divisor4
    u5 = A_55 - A_50 * l0_4 - u1_4 * l1_3 - u2_3 * l2_2 - u3_2 * l3_1 - u4_1 * l4
    divisor5 = where(0 < u5, u5, 1)
    part0 = where(divisor0a, A_00 / divisor0, A_00)
    own1a = 0 < A_11
    own1 = where(own1a, A_11, 1)
    part1 = where(own1a, u1_0 / own1, A_11)
    smallest1 = where(part0 < part1, part0, part1)
    own2a = 0 < A_22
    own2 = where(own2a, A_22, 1)
    part2 = where(own2a, u2_0 / own2, A_22)
    smallest2 = where(smallest1 < part2, smallest1, part2)
    own3a = 0 < A_33
    own3 = where(own3a, A_33, 1)
    part3 = where(own3a, u3_0 / own3, A_33)
    smallest3 = where(smallest2 < part3, smallest2, part3)
    own4a = 0 < A_44
    own4 = where(own4a, A_44, 1)
    part4 = where(own4a, u4_0 / own4, A_44)
    smallest4 = where(smallest3 < part4, smallest3, part4)
    own5a = 0 < A_55
    own5 = where(own5a, A_55, 1)
    part5 = where(own5a, u5 / own5, A_55)
    smallest5 = where(smallest4 < part5, smallest4, part5)
    less_0 = A_00 * 0.9999970197677612
    less_1 = A_11 * 0.9999970197677612
    less_2 = A_22 * 0.9999970197677612
    less_3 = A_33 * 0.9999970197677612
    less_4 = A_44 * 0.9999970197677612
    less_5 = A_55 * 0.9999970197677612
    less_divisor0a = 0 < less_0
    less_divisor0 = where(less_divisor0a, less_0, 1)
    less_l0_0 = A_10 / less_divisor0
    less_l0_1 = A_20 / less_divisor0
    less_l0_2 = A_30 / less_divisor0
    less_l0_3 = A_40 / less_divisor0
    less_l0_4 = A_50 / less_divisor0
    less_u1_0 = less_1 - A_10 * less_l0_0
    less_u1_1 = A_21 - A_20 * less_l0_0
    less_u1_2 = A_31 - A_30 * less_l0_0
    less_u1_3 = A_41 - A_40 * less_l0_0
    less_u1_4 = A_51 - A_50 * less_l0_0
    less_divisor1a = 0 < less_u1_0
    less_divisor1 = where(less_divisor1a, less_u1_0, 1)
    less_l1_0 = less_u1_1 / less_divisor1
    less_l1_1 = less_u1_2 / less_divisor1
    less_l1_2 = less_u1_3 / less_divisor1
    less_l1_3 = less_u1_4 / less_divisor1
    less_u2_0 = less_2 - A_20 * less_l0_1 - less_u1_1 * less_l1_0
    less_u2_1 = A_32 - A_30 * less_l0_1 - less_u1_2 * less_l1_0
    less_u2_2 = A_42 - A_40 * less_l0_1 - less_u1_3 * less_l1_0
    less_u2_3 = A_52 - A_50 * less_l0_1 - less_u1_4 * less_l1_0
    less_divisor2a = 0 < less_u2_0
    less_divisor2 = where(less_divisor2a, less_u2_0, 1)
    less_l2_0 = less_u2_1 / less_divisor2
    less_l2_1 = less_u2_2 / less_divisor2
    less_l2_2 = less_u2_3 / less_divisor2
    less_u3_0 = less_3 - A_30 * less_l0_2 - less_u1_2 * less_l1_1 - less_u2_1 * less_l2_0
    less_u3_1 = A_43 - A_40 * less_l0_2 - less_u1_3 * less_l1_1 - less_u2_2 * less_l2_0
    less_u3_2 = A_53 - A_50 * less_l0_2 - less_u1_4 * less_l1_1 - less_u2_3 * less_l2_0
    less_divisor3a = 0 < less_u3_0
    less_divisor3 = where(less_divisor3a, less_u3_0, 1)
    less_l3_0 = less_u3_1 / less_divisor3
    less_l3_1 = less_u3_2 / less_divisor3
    less_u4_0 = (less_4 - A_40 * less_l0_3 - less_u1_3 * less_l1_2 - less_u2_2 * less_l2_1
        - less_u3_1 * less_l3_0)
    less_u4_1 = (A_54 - A_50 * less_l0_3 - less_u1_4 * less_l1_2 - less_u2_3 * less_l2_1
        - less_u3_2 * less_l3_0)
    less_divisor4a = 0 < less_u4_0
    less_divisor4 = where(less_divisor4a, less_u4_0, 1)
    less_l4 = less_u4_1 / less_divisor4
    less_u5 = (less_5 - A_50 * less_l0_4 - less_u1_4 * less_l1_3 - less_u2_3 * less_l2_2
        - less_u3_2 * less_l3_1 - less_u4_1 * less_l4)
    regular_e = where(less_divisor2a, where(less_divisor3a, where(less_divisor4a, where(0 < less_u5,
        real(1), real(0)), 0), 0), 0)
    regular = where(less_divisor0a, where(less_divisor1a, regular_e, 0), 0)
    least = where(smallest5 < 0, smallest5, 0)
    y1 = b_1 - b_0 * l0_0
    y2 = b_2 - b_0 * l0_1 - l1_0 * y1
    y3 = b_3 - b_0 * l0_2 - l1_1 * y1 - l2_0 * y2
    y4 = b_4 - b_0 * l0_3 - l1_2 * y1 - l2_1 * y2 - l3_0 * y3
    y5 = b_5 - b_0 * l0_4 - l1_3 * y1 - l2_2 * y2 - l3_1 * y3 - l4 * y4
    z0 = b_0 / divisor0
    z1 = y1 / divisor1
    z2 = y2 / divisor2
    z3 = y3 / divisor3
    z4 = y4 / divisor4
    z5 = y5 / divisor5
    x4 = z4 - l4 * z5
    x3 = z3 - l3_0 * x4 - l3_1 * z5
    x2 = z2 - l2_0 * x3 - l2_1 * x4 - l2_2 * z5
    x1 = z1 - l1_0 * x2 - l1_1 * x3 - l1_2 * x4 - l1_3 * z5
    x0 = z0 - l0_0 * x1 - l0_1 * x2 - l0_2 * x3 - l0_3 * x4 - l0_4 * z5
    residual_0 = b_0 - A_00 * x0 - A_10 * x1 - A_20 * x2 - A_30 * x3 - A_40 * x4 - A_50 * z5
    residual_1 = b_1 - A_10 * x0 - A_11 * x1 - A_21 * x2 - A_31 * x3 - A_41 * x4 - A_51 * z5
    residual_2 = b_2 - A_20 * x0 - A_21 * x1 - A_22 * x2 - A_32 * x3 - A_42 * x4 - A_52 * z5
    residual_3 = b_3 - A_30 * x0 - A_31 * x1 - A_32 * x2 - A_33 * x3 - A_43 * x4 - A_53 * z5
    residual_4 = b_4 - A_40 * x0 - A_41 * x1 - A_42 * x2 - A_43 * x3 - A_44 * x4 - A_54 * z5
    residual_5 = b_5 - A_50 * x0 - A_51 * x1 - A_52 * x2 - A_53 * x3 - A_54 * x4 - A_55 * z5
    refined_y1 = residual_1 - l0_0 * residual_0
    refined_y2 = residual_2 - l0_1 * residual_0 - l1_0 * refined_y1
    refined_y3 = residual_3 - l0_2 * residual_0 - l1_1 * refined_y1 - l2_0 * refined_y2
    refined_y4 = (residual_4 - l0_3 * residual_0 - l1_2 * refined_y1 - l2_1 * refined_y2 - l3_0
        * refined_y3)
    refined_y5 = (residual_5 - l0_4 * residual_0 - l1_3 * refined_y1 - l2_2 * refined_y2 - l3_1
        * refined_y3 - l4 * refined_y4)
    refined_z0 = residual_0 / divisor0
    refined_z1 = refined_y1 / divisor1
    refined_z2 = refined_y2 / divisor2
    refined_z3 = refined_y3 / divisor3
    refined_z4 = refined_y4 / divisor4
    refined_z5 = refined_y5 / divisor5
    refined_x4 = refined_z4 - l4 * refined_z5
    refined_x3 = refined_z3 - l3_0 * refined_x4 - l3_1 * refined_z5
    refined_x2 = refined_z2 - l2_0 * refined_x3 - l2_1 * refined_x4 - l2_2 * refined_z5
    refined_x1 = (refined_z1 - l1_0 * refined_x2 - l1_1 * refined_x3 - l1_2 * refined_x4 - l1_3
        * refined_z5)
    refined_x0 = (refined_z0 - l0_0 * refined_x1 - l0_1 * refined_x2 - l0_2 * refined_x3 - l0_3
        * refined_x4 - l0_4 * refined_z5)
    found_0 = x0 + refined_x0
    found_1 = x1 + refined_x1
    found_2 = x2 + refined_x2
    found_3 = x3 + refined_x3
    found_4 = x4 + refined_x4
    found_5 = z5 + refined_z5
    pivot_a = regular == 1
    pivot = where(pivot_a, smallest5, least)
    x_0 = where(pivot_a, found_0, nan)
    x_1 = where(pivot_a, found_1, nan)
    x_2 = where(pivot_a, found_2, nan)
    x_3 = where(pivot_a, found_3, nan)
    x_4 = where(pivot_a, found_4, nan)
    x_5 = where(pivot_a, found_5, nan)
    return (pivot, x_0, x_1, x_2, x_3, x_4, x_5)
