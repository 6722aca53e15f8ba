# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Products between rotations, displacements and vectors.

In single precision, accurate tier.
"""

from coscrew._kernel import wide_kernel as kernel


@kernel("(3,3),(3)->(3)")
def product_drv(R, v):
    """vo = R v.

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 6 add.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0 = R_00 * v_0 + R_01 * v_1 + R_02 * v_2
    vo_1 = R_10 * v_0 + R_11 * v_1 + R_12 * v_2
    vo_2 = R_20 * v_0 + R_21 * v_1 + R_22 * v_2
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(3)->(3)")
def product_drvinv(R, v):
    """vo = R (-v).

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 6 add, 3 neg.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0 = -(R_00 * v_0) - R_01 * v_1 - R_02 * v_2
    vo_1 = -(R_10 * v_0) - R_11 * v_1 - R_12 * v_2
    vo_2 = -(R_20 * v_0) - R_21 * v_1 - R_22 * v_2
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(3)->(3)")
def product_drinvv(R, v):
    """vo = R^T v.

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 6 add.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0 = R_00 * v_0 + R_10 * v_1 + R_20 * v_2
    vo_1 = R_01 * v_0 + R_11 * v_1 + R_21 * v_2
    vo_2 = R_02 * v_0 + R_12 * v_1 + R_22 * v_2
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(3)->(3)")
def product_drinvvinv(R, v):
    """vo = R^T (-v).

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 6 add, 3 neg.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0 = -(R_00 * v_0) - R_10 * v_1 - R_20 * v_2
    vo_1 = -(R_01 * v_0) - R_11 * v_1 - R_21 * v_2
    vo_2 = -(R_02 * v_0) - R_12 * v_1 - R_22 * v_2
    return (vo_0, vo_1, vo_2)


@kernel("(3,4),(3)->(3)")
def product_dv(D, v):
    """vo = R v + t.

    (3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.
    9 mul, 9 add.  Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    v_0, v_1, v_2 = v
    vo_0 = D_00 * v_0 + D_01 * v_1 + D_02 * v_2 + D_03
    vo_1 = D_10 * v_0 + D_11 * v_1 + D_12 * v_2 + D_13
    vo_2 = D_20 * v_0 + D_21 * v_1 + D_22 * v_2 + D_23
    return (vo_0, vo_1, vo_2)


@kernel("(3,4),(3)->(3)")
def product_dinvv(D, v):
    """vo = R^T (v - t).

    (3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.
    9 mul, 9 add.  Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    v_0, v_1, v_2 = v
    p_0 = v_0 - D_03
    p_1 = v_1 - D_13
    p_2 = v_2 - D_23
    vo_0 = D_00 * p_0 + D_10 * p_1 + D_20 * p_2
    vo_1 = D_01 * p_0 + D_11 * p_1 + D_21 * p_2
    vo_2 = D_02 * p_0 + D_12 * p_1 + D_22 * p_2
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(3,3)->(3,3)")
def product_drdr(R1, R2):
    """Ro = R1 R2.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R1_00, R1_01, R1_02, R1_10, R1_11, R1_12, R1_20, R1_21, R1_22 = R1
    R2_00, R2_01, R2_02, R2_10, R2_11, R2_12, R2_20, R2_21, R2_22 = R2
    Ro_00 = R1_00 * R2_00 + R1_01 * R2_10 + R1_02 * R2_20
    Ro_01 = R1_00 * R2_01 + R1_01 * R2_11 + R1_02 * R2_21
    Ro_02 = R1_00 * R2_02 + R1_01 * R2_12 + R1_02 * R2_22
    Ro_10 = R1_10 * R2_00 + R1_11 * R2_10 + R1_12 * R2_20
    Ro_11 = R1_10 * R2_01 + R1_11 * R2_11 + R1_12 * R2_21
    Ro_12 = R1_10 * R2_02 + R1_11 * R2_12 + R1_12 * R2_22
    Ro_20 = R1_20 * R2_00 + R1_21 * R2_10 + R1_22 * R2_20
    Ro_21 = R1_20 * R2_01 + R1_21 * R2_11 + R1_22 * R2_21
    Ro_22 = R1_20 * R2_02 + R1_21 * R2_12 + R1_22 * R2_22
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22)


@kernel("(3,3),(3,3)->(3,3)")
def product_drdrinv(R1, R2):
    """Ro = R1 R2^T.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R1_00, R1_01, R1_02, R1_10, R1_11, R1_12, R1_20, R1_21, R1_22 = R1
    R2_00, R2_01, R2_02, R2_10, R2_11, R2_12, R2_20, R2_21, R2_22 = R2
    Ro_00 = R1_00 * R2_00 + R1_01 * R2_01 + R1_02 * R2_02
    Ro_01 = R1_00 * R2_10 + R1_01 * R2_11 + R1_02 * R2_12
    Ro_02 = R1_00 * R2_20 + R1_01 * R2_21 + R1_02 * R2_22
    Ro_10 = R1_10 * R2_00 + R1_11 * R2_01 + R1_12 * R2_02
    Ro_11 = R1_10 * R2_10 + R1_11 * R2_11 + R1_12 * R2_12
    Ro_12 = R1_10 * R2_20 + R1_11 * R2_21 + R1_12 * R2_22
    Ro_20 = R1_20 * R2_00 + R1_21 * R2_01 + R1_22 * R2_02
    Ro_21 = R1_20 * R2_10 + R1_21 * R2_11 + R1_22 * R2_12
    Ro_22 = R1_20 * R2_20 + R1_21 * R2_21 + R1_22 * R2_22
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22)


@kernel("(3,3),(3,3)->(3,3)")
def product_drinvdr(R1, R2):
    """Ro = R1^T R2.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R1_00, R1_01, R1_02, R1_10, R1_11, R1_12, R1_20, R1_21, R1_22 = R1
    R2_00, R2_01, R2_02, R2_10, R2_11, R2_12, R2_20, R2_21, R2_22 = R2
    Ro_00 = R1_00 * R2_00 + R1_10 * R2_10 + R1_20 * R2_20
    Ro_01 = R1_00 * R2_01 + R1_10 * R2_11 + R1_20 * R2_21
    Ro_02 = R1_00 * R2_02 + R1_10 * R2_12 + R1_20 * R2_22
    Ro_10 = R1_01 * R2_00 + R1_11 * R2_10 + R1_21 * R2_20
    Ro_11 = R1_01 * R2_01 + R1_11 * R2_11 + R1_21 * R2_21
    Ro_12 = R1_01 * R2_02 + R1_11 * R2_12 + R1_21 * R2_22
    Ro_20 = R1_02 * R2_00 + R1_12 * R2_10 + R1_22 * R2_20
    Ro_21 = R1_02 * R2_01 + R1_12 * R2_11 + R1_22 * R2_21
    Ro_22 = R1_02 * R2_02 + R1_12 * R2_12 + R1_22 * R2_22
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22)


@kernel("(3,4),(3,4)->(3,4)")
def product_dd(D1, D2):
    """Do = D1 D2 = [R1 R2 | R1 t2 + t1].

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    36 mul, 27 add.  Error <= u |result| + (R: 3/32, t: 1/8) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    Do_00 = D1_00 * D2_00 + D1_01 * D2_10 + D1_02 * D2_20
    Do_01 = D1_00 * D2_01 + D1_01 * D2_11 + D1_02 * D2_21
    Do_02 = D1_00 * D2_02 + D1_01 * D2_12 + D1_02 * D2_22
    Do_03 = D1_00 * D2_03 + D1_01 * D2_13 + D1_02 * D2_23 + D1_03
    Do_10 = D1_10 * D2_00 + D1_11 * D2_10 + D1_12 * D2_20
    Do_11 = D1_10 * D2_01 + D1_11 * D2_11 + D1_12 * D2_21
    Do_12 = D1_10 * D2_02 + D1_11 * D2_12 + D1_12 * D2_22
    Do_13 = D1_10 * D2_03 + D1_11 * D2_13 + D1_12 * D2_23 + D1_13
    Do_20 = D1_20 * D2_00 + D1_21 * D2_10 + D1_22 * D2_20
    Do_21 = D1_20 * D2_01 + D1_21 * D2_11 + D1_22 * D2_21
    Do_22 = D1_20 * D2_02 + D1_21 * D2_12 + D1_22 * D2_22
    Do_23 = D1_20 * D2_03 + D1_21 * D2_13 + D1_22 * D2_23 + D1_23
    return (Do_00, Do_01, Do_02, Do_03, Do_10, Do_11, Do_12, Do_13, Do_20, Do_21, Do_22, Do_23)


@kernel("(3,4),(3,4)->(3,4)")
def product_ddinv(D1, D2):
    """Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    36 mul, 27 add.  Error <= u |result| + (R: 3/32, t: 7/32) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    R_0 = D1_00 * D2_00 + D1_01 * D2_01 + D1_02 * D2_02
    R_1 = D1_00 * D2_10 + D1_01 * D2_11 + D1_02 * D2_12
    R_2 = D1_00 * D2_20 + D1_01 * D2_21 + D1_02 * D2_22
    R_3 = D1_10 * D2_00 + D1_11 * D2_01 + D1_12 * D2_02
    R_4 = D1_10 * D2_10 + D1_11 * D2_11 + D1_12 * D2_12
    R_5 = D1_10 * D2_20 + D1_11 * D2_21 + D1_12 * D2_22
    R_6 = D1_20 * D2_00 + D1_21 * D2_01 + D1_22 * D2_02
    R_7 = D1_20 * D2_10 + D1_21 * D2_11 + D1_22 * D2_12
    R_8 = D1_20 * D2_20 + D1_21 * D2_21 + D1_22 * D2_22
    Do_03 = D1_03 - (D2_03 * R_0 + D2_13 * R_1 + D2_23 * R_2)
    Do_13 = D1_13 - (D2_03 * R_3 + D2_13 * R_4 + D2_23 * R_5)
    Do_23 = D1_23 - (D2_03 * R_6 + D2_13 * R_7 + D2_23 * R_8)
    return (R_0, R_1, R_2, Do_03, R_3, R_4, R_5, Do_13, R_6, R_7, R_8, Do_23)


@kernel("(3,4),(3,4)->(3,4)")
def product_dinvd(D1, D2):
    """Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    36 mul, 27 add.  Error <= u |result| + (R: 3/32, t: 1/8) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    p_0 = D2_03 - D1_03
    p_1 = D2_13 - D1_13
    p_2 = D2_23 - D1_23
    Do_00 = D1_00 * D2_00 + D1_10 * D2_10 + D1_20 * D2_20
    Do_01 = D1_00 * D2_01 + D1_10 * D2_11 + D1_20 * D2_21
    Do_02 = D1_00 * D2_02 + D1_10 * D2_12 + D1_20 * D2_22
    Do_03 = D1_00 * p_0 + D1_10 * p_1 + D1_20 * p_2
    Do_10 = D1_01 * D2_00 + D1_11 * D2_10 + D1_21 * D2_20
    Do_11 = D1_01 * D2_01 + D1_11 * D2_11 + D1_21 * D2_21
    Do_12 = D1_01 * D2_02 + D1_11 * D2_12 + D1_21 * D2_22
    Do_13 = D1_01 * p_0 + D1_11 * p_1 + D1_21 * p_2
    Do_20 = D1_02 * D2_00 + D1_12 * D2_10 + D1_22 * D2_20
    Do_21 = D1_02 * D2_01 + D1_12 * D2_11 + D1_22 * D2_21
    Do_22 = D1_02 * D2_02 + D1_12 * D2_12 + D1_22 * D2_22
    Do_23 = D1_02 * p_0 + D1_12 * p_1 + D1_22 * p_2
    return (Do_00, Do_01, Do_02, Do_03, Do_10, Do_11, Do_12, Do_13, Do_20, Do_21, Do_22, Do_23)


@kernel("(3,4),(3,3)->(3,4)")
def product_ddr(D, R):
    """Do = D [R | 0].

    (3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other
    3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + (R: 3/32, t: 0) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    Do_00 = D_00 * R_00 + D_01 * R_10 + D_02 * R_20
    Do_01 = D_00 * R_01 + D_01 * R_11 + D_02 * R_21
    Do_02 = D_00 * R_02 + D_01 * R_12 + D_02 * R_22
    Do_10 = D_10 * R_00 + D_11 * R_10 + D_12 * R_20
    Do_11 = D_10 * R_01 + D_11 * R_11 + D_12 * R_21
    Do_12 = D_10 * R_02 + D_11 * R_12 + D_12 * R_22
    Do_20 = D_20 * R_00 + D_21 * R_10 + D_22 * R_20
    Do_21 = D_20 * R_01 + D_21 * R_11 + D_22 * R_21
    Do_22 = D_20 * R_02 + D_21 * R_12 + D_22 * R_22
    return (Do_00, Do_01, Do_02, D_03, Do_10, Do_11, Do_12, D_13, Do_20, Do_21, Do_22, D_23)


@kernel("(3,4),(3,3)->(3,4)")
def product_ddrinv(D, R):
    """Do = D [R^T | 0].

    (3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other
    3×3 matrix.
    27 mul, 18 add.  Error <= u |result| + (R: 3/32, t: 0) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    Do_00 = D_00 * R_00 + D_01 * R_01 + D_02 * R_02
    Do_01 = D_00 * R_10 + D_01 * R_11 + D_02 * R_12
    Do_02 = D_00 * R_20 + D_01 * R_21 + D_02 * R_22
    Do_10 = D_10 * R_00 + D_11 * R_01 + D_12 * R_02
    Do_11 = D_10 * R_10 + D_11 * R_11 + D_12 * R_12
    Do_12 = D_10 * R_20 + D_11 * R_21 + D_12 * R_22
    Do_20 = D_20 * R_00 + D_21 * R_01 + D_22 * R_02
    Do_21 = D_20 * R_10 + D_21 * R_11 + D_22 * R_12
    Do_22 = D_20 * R_20 + D_21 * R_21 + D_22 * R_22
    return (Do_00, Do_01, Do_02, D_03, Do_10, Do_11, Do_12, D_13, Do_20, Do_21, Do_22, D_23)


@kernel("(3,4),(3)->(3,4)")
def product_ddt(D, t):
    """Do = D [I | t].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 9 add.  Error <= u |result| + (R: 0, t: 1/8) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    t_0, t_1, t_2 = t
    Do_03 = D_00 * t_0 + D_01 * t_1 + D_02 * t_2 + D_03
    Do_13 = D_10 * t_0 + D_11 * t_1 + D_12 * t_2 + D_13
    Do_23 = D_20 * t_0 + D_21 * t_1 + D_22 * t_2 + D_23
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23)


@kernel("(3,4),(3)->(3,4)")
def product_ddtinv(D, t):
    """Do = D [I | -t].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 9 add.  Error <= u |result| + (R: 0, t: 1/8) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    t_0, t_1, t_2 = t
    Do_03 = D_03 - (D_00 * t_0 + D_01 * t_1 + D_02 * t_2)
    Do_13 = D_13 - (D_10 * t_0 + D_11 * t_1 + D_12 * t_2)
    Do_23 = D_23 - (D_20 * t_0 + D_21 * t_1 + D_22 * t_2)
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23)


@kernel("(3,4),(3)->(3,4)")
def product_dinvdt(D, t):
    """Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 9 add.  Error <= u |result| + (R: 0, t: 1/8) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    t_0, t_1, t_2 = t
    p_0 = t_0 - D_03
    p_1 = t_1 - D_13
    p_2 = t_2 - D_23
    Do_03 = D_00 * p_0 + D_10 * p_1 + D_20 * p_2
    Do_13 = D_01 * p_0 + D_11 * p_1 + D_21 * p_2
    Do_23 = D_02 * p_0 + D_12 * p_1 + D_22 * p_2
    return (D_00, D_10, D_20, Do_03, D_01, D_11, D_21, Do_13, D_02, D_12, D_22, Do_23)


@kernel("(3,3),()->(3)")
def product_drvtx(R, k):
    """vo = R (k e_x).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = R_00 * k
    vo_1 = R_10 * k
    vo_2 = R_20 * k
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(2)->(3,3)")
def product_drdrx(R, dc):
    """Ro = R R_x(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_01 = R_01 * dc_1 + R_02 * dc_0
    Ro_02 = R_02 * dc_1 - R_01 * dc_0
    Ro_11 = R_11 * dc_1 + R_12 * dc_0
    Ro_12 = R_12 * dc_1 - R_11 * dc_0
    Ro_21 = R_21 * dc_1 + R_22 * dc_0
    Ro_22 = R_22 * dc_1 - R_21 * dc_0
    return (R_00, Ro_01, Ro_02, R_10, Ro_11, Ro_12, R_20, Ro_21, Ro_22)


@kernel("(3,4),(2)->(3,4)")
def product_ddrx(D, dc):
    """Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_01 = D_01 * dc_1 + D_02 * dc_0
    Do_02 = D_02 * dc_1 - D_01 * dc_0
    Do_11 = D_11 * dc_1 + D_12 * dc_0
    Do_12 = D_12 * dc_1 - D_11 * dc_0
    Do_21 = D_21 * dc_1 + D_22 * dc_0
    Do_22 = D_22 * dc_1 - D_21 * dc_0
    return (D_00, Do_01, Do_02, D_03, D_10, Do_11, Do_12, D_13, D_20, Do_21, Do_22, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtx(D, k):
    """Do = D [I | k e_x].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03 = D_00 * k + D_03
    Do_13 = D_10 * k + D_13
    Do_23 = D_20 * k + D_23
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23)


@kernel("(3,3),()->(3)")
def product_drvtxinv(R, k):
    """vo = R (-k e_x).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 neg.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = -(R_00 * k)
    vo_1 = -(R_10 * k)
    vo_2 = -(R_20 * k)
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(2)->(3,3)")
def product_drdrxinv(R, dc):
    """Ro = R R_x(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_01 = R_01 * dc_1 - R_02 * dc_0
    Ro_02 = R_01 * dc_0 + R_02 * dc_1
    Ro_11 = R_11 * dc_1 - R_12 * dc_0
    Ro_12 = R_11 * dc_0 + R_12 * dc_1
    Ro_21 = R_21 * dc_1 - R_22 * dc_0
    Ro_22 = R_21 * dc_0 + R_22 * dc_1
    return (R_00, Ro_01, Ro_02, R_10, Ro_11, Ro_12, R_20, Ro_21, Ro_22)


@kernel("(3,4),(2)->(3,4)")
def product_ddrxinv(D, dc):
    """Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_01 = D_01 * dc_1 - D_02 * dc_0
    Do_02 = D_01 * dc_0 + D_02 * dc_1
    Do_11 = D_11 * dc_1 - D_12 * dc_0
    Do_12 = D_11 * dc_0 + D_12 * dc_1
    Do_21 = D_21 * dc_1 - D_22 * dc_0
    Do_22 = D_21 * dc_0 + D_22 * dc_1
    return (D_00, Do_01, Do_02, D_03, D_10, Do_11, Do_12, D_13, D_20, Do_21, Do_22, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtxinv(D, k):
    """Do = D [I | -k e_x].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03 = D_03 - D_00 * k
    Do_13 = D_13 - D_10 * k
    Do_23 = D_23 - D_20 * k
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23)


@kernel("(3,3),()->(3)")
def product_drvty(R, k):
    """vo = R (k e_y).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = R_01 * k
    vo_1 = R_11 * k
    vo_2 = R_21 * k
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(2)->(3,3)")
def product_drdry(R, dc):
    """Ro = R R_y(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00 = R_00 * dc_1 - R_02 * dc_0
    Ro_02 = R_00 * dc_0 + R_02 * dc_1
    Ro_10 = R_10 * dc_1 - R_12 * dc_0
    Ro_12 = R_10 * dc_0 + R_12 * dc_1
    Ro_20 = R_20 * dc_1 - R_22 * dc_0
    Ro_22 = R_20 * dc_0 + R_22 * dc_1
    return (Ro_00, R_01, Ro_02, Ro_10, R_11, Ro_12, Ro_20, R_21, Ro_22)


@kernel("(3,4),(2)->(3,4)")
def product_ddry(D, dc):
    """Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00 = D_00 * dc_1 - D_02 * dc_0
    Do_02 = D_00 * dc_0 + D_02 * dc_1
    Do_10 = D_10 * dc_1 - D_12 * dc_0
    Do_12 = D_10 * dc_0 + D_12 * dc_1
    Do_20 = D_20 * dc_1 - D_22 * dc_0
    Do_22 = D_20 * dc_0 + D_22 * dc_1
    return (Do_00, D_01, Do_02, D_03, Do_10, D_11, Do_12, D_13, Do_20, D_21, Do_22, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddty(D, k):
    """Do = D [I | k e_y].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03 = D_01 * k + D_03
    Do_13 = D_11 * k + D_13
    Do_23 = D_21 * k + D_23
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23)


@kernel("(3,3),()->(3)")
def product_drvtyinv(R, k):
    """vo = R (-k e_y).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 neg.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = -(R_01 * k)
    vo_1 = -(R_11 * k)
    vo_2 = -(R_21 * k)
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(2)->(3,3)")
def product_drdryinv(R, dc):
    """Ro = R R_y(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00 = R_00 * dc_1 + R_02 * dc_0
    Ro_02 = R_02 * dc_1 - R_00 * dc_0
    Ro_10 = R_10 * dc_1 + R_12 * dc_0
    Ro_12 = R_12 * dc_1 - R_10 * dc_0
    Ro_20 = R_20 * dc_1 + R_22 * dc_0
    Ro_22 = R_22 * dc_1 - R_20 * dc_0
    return (Ro_00, R_01, Ro_02, Ro_10, R_11, Ro_12, Ro_20, R_21, Ro_22)


@kernel("(3,4),(2)->(3,4)")
def product_ddryinv(D, dc):
    """Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00 = D_00 * dc_1 + D_02 * dc_0
    Do_02 = D_02 * dc_1 - D_00 * dc_0
    Do_10 = D_10 * dc_1 + D_12 * dc_0
    Do_12 = D_12 * dc_1 - D_10 * dc_0
    Do_20 = D_20 * dc_1 + D_22 * dc_0
    Do_22 = D_22 * dc_1 - D_20 * dc_0
    return (Do_00, D_01, Do_02, D_03, Do_10, D_11, Do_12, D_13, Do_20, D_21, Do_22, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtyinv(D, k):
    """Do = D [I | -k e_y].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03 = D_03 - D_01 * k
    Do_13 = D_13 - D_11 * k
    Do_23 = D_23 - D_21 * k
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23)


@kernel("(3,3),()->(3)")
def product_drvtz(R, k):
    """vo = R (k e_z).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = R_02 * k
    vo_1 = R_12 * k
    vo_2 = R_22 * k
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(2)->(3,3)")
def product_drdrz(R, dc):
    """Ro = R R_z(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00 = R_00 * dc_1 + R_01 * dc_0
    Ro_01 = R_01 * dc_1 - R_00 * dc_0
    Ro_10 = R_10 * dc_1 + R_11 * dc_0
    Ro_11 = R_11 * dc_1 - R_10 * dc_0
    Ro_20 = R_20 * dc_1 + R_21 * dc_0
    Ro_21 = R_21 * dc_1 - R_20 * dc_0
    return (Ro_00, Ro_01, R_02, Ro_10, Ro_11, R_12, Ro_20, Ro_21, R_22)


@kernel("(3,4),(2)->(3,4)")
def product_ddrz(D, dc):
    """Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00 = D_00 * dc_1 + D_01 * dc_0
    Do_01 = D_01 * dc_1 - D_00 * dc_0
    Do_10 = D_10 * dc_1 + D_11 * dc_0
    Do_11 = D_11 * dc_1 - D_10 * dc_0
    Do_20 = D_20 * dc_1 + D_21 * dc_0
    Do_21 = D_21 * dc_1 - D_20 * dc_0
    return (Do_00, Do_01, D_02, D_03, Do_10, Do_11, D_12, D_13, Do_20, Do_21, D_22, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtz(D, k):
    """Do = D [I | k e_z].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03 = D_02 * k + D_03
    Do_13 = D_12 * k + D_13
    Do_23 = D_22 * k + D_23
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23)


@kernel("(3,3),()->(3)")
def product_drvtzinv(R, k):
    """vo = R (-k e_z).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 neg.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = -(R_02 * k)
    vo_1 = -(R_12 * k)
    vo_2 = -(R_22 * k)
    return (vo_0, vo_1, vo_2)


@kernel("(3,3),(2)->(3,3)")
def product_drdrzinv(R, dc):
    """Ro = R R_z(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00 = R_00 * dc_1 - R_01 * dc_0
    Ro_01 = R_00 * dc_0 + R_01 * dc_1
    Ro_10 = R_10 * dc_1 - R_11 * dc_0
    Ro_11 = R_10 * dc_0 + R_11 * dc_1
    Ro_20 = R_20 * dc_1 - R_21 * dc_0
    Ro_21 = R_20 * dc_0 + R_21 * dc_1
    return (Ro_00, Ro_01, R_02, Ro_10, Ro_11, R_12, Ro_20, Ro_21, R_22)


@kernel("(3,4),(2)->(3,4)")
def product_ddrzinv(D, dc):
    """Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 6 add.  Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00 = D_00 * dc_1 - D_01 * dc_0
    Do_01 = D_00 * dc_0 + D_01 * dc_1
    Do_10 = D_10 * dc_1 - D_11 * dc_0
    Do_11 = D_10 * dc_0 + D_11 * dc_1
    Do_20 = D_20 * dc_1 - D_21 * dc_0
    Do_21 = D_20 * dc_0 + D_21 * dc_1
    return (Do_00, Do_01, D_02, D_03, Do_10, Do_11, D_12, D_13, Do_20, Do_21, D_22, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtzinv(D, k):
    """Do = D [I | -k e_z].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 3 add.  Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03 = D_03 - D_02 * k
    Do_13 = D_13 - D_12 * k
    Do_23 = D_23 - D_22 * k
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23)
