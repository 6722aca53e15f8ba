# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Products between rotations, displacements and vectors.

In double precision, accurate tier.
"""

from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(3,3),(3)->(3)")
def product_drv(R, v):
    """vo = R v.

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 33 add, 9 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0a = R_00 * v_0
    vo_0b = R_01 * v_1
    vo_0c = vo_0a + vo_0b
    vo_0c_right = vo_0c - vo_0a
    vo_0d = R_02 * v_2
    vo_0 = vo_0c + vo_0d
    vo_0_right = vo_0 - vo_0c
    vo_0c_lo = (product_rest(R_00, v_0, vo_0a, vo_0c - vo_0c_right)
        + product_rest(R_01, v_1, vo_0b, vo_0c_right))
    vo_1a = R_10 * v_0
    vo_1b = R_11 * v_1
    vo_1c = vo_1a + vo_1b
    vo_1c_right = vo_1c - vo_1a
    vo_1d = R_12 * v_2
    vo_1 = vo_1c + vo_1d
    vo_1_right = vo_1 - vo_1c
    vo_1c_lo = (product_rest(R_10, v_0, vo_1a, vo_1c - vo_1c_right)
        + product_rest(R_11, v_1, vo_1b, vo_1c_right))
    vo_2a = R_20 * v_0
    vo_2b = R_21 * v_1
    vo_2c = vo_2a + vo_2b
    vo_2c_right = vo_2c - vo_2a
    vo_2d = R_22 * v_2
    vo_2 = vo_2c + vo_2d
    vo_2_right = vo_2 - vo_2c
    vo_2c_lo = (product_rest(R_20, v_0, vo_2a, vo_2c - vo_2c_right)
        + product_rest(R_21, v_1, vo_2b, vo_2c_right))
    vo_0_rounded = (vo_0
        + (vo_0c - (vo_0 - vo_0_right) + product_rest(R_02, v_2, vo_0d, vo_0_right) + vo_0c_lo))
    vo_1_rounded = (vo_1
        + (vo_1c - (vo_1 - vo_1_right) + product_rest(R_12, v_2, vo_1d, vo_1_right) + vo_1c_lo))
    vo_2_rounded = (vo_2
        + (vo_2c - (vo_2 - vo_2_right) + product_rest(R_22, v_2, vo_2d, vo_2_right) + vo_2c_lo))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(3)->(3)")
def product_drvinv(R, v):
    """vo = R (-v).

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0a = R_00 * v_0
    vo_0b = R_01 * v_1
    vo_0c = vo_0a + vo_0b
    vo_0c_right = vo_0c - vo_0a
    vo_0d = R_02 * v_2
    vo_0e = vo_0c + vo_0d
    vo_0e_right = vo_0e - vo_0c
    vo_0c_lo = (product_rest(R_00, v_0, vo_0a, vo_0c - vo_0c_right)
        + product_rest(R_01, v_1, vo_0b, vo_0c_right))
    vo_0 = -vo_0e
    vo_1a = R_10 * v_0
    vo_1b = R_11 * v_1
    vo_1c = vo_1a + vo_1b
    vo_1c_right = vo_1c - vo_1a
    vo_1d = R_12 * v_2
    vo_1e = vo_1c + vo_1d
    vo_1e_right = vo_1e - vo_1c
    vo_1c_lo = (product_rest(R_10, v_0, vo_1a, vo_1c - vo_1c_right)
        + product_rest(R_11, v_1, vo_1b, vo_1c_right))
    vo_1 = -vo_1e
    vo_2a = R_20 * v_0
    vo_2b = R_21 * v_1
    vo_2c = vo_2a + vo_2b
    vo_2c_right = vo_2c - vo_2a
    vo_2d = R_22 * v_2
    vo_2e = vo_2c + vo_2d
    vo_2e_right = vo_2e - vo_2c
    vo_2c_lo = (product_rest(R_20, v_0, vo_2a, vo_2c - vo_2c_right)
        + product_rest(R_21, v_1, vo_2b, vo_2c_right))
    vo_2 = -vo_2e
    vo_0_rounded = (vo_0 +
        -(vo_0c - (vo_0e - vo_0e_right) + product_rest(R_02, v_2, vo_0d, vo_0e_right) + vo_0c_lo))
    vo_1_rounded = (vo_1 +
        -(vo_1c - (vo_1e - vo_1e_right) + product_rest(R_12, v_2, vo_1d, vo_1e_right) + vo_1c_lo))
    vo_2_rounded = (vo_2 +
        -(vo_2c - (vo_2e - vo_2e_right) + product_rest(R_22, v_2, vo_2d, vo_2e_right) + vo_2c_lo))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(3)->(3)")
def product_drinvv(R, v):
    """vo = R^T v.

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 33 add, 9 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0a = R_00 * v_0
    vo_0b = R_10 * v_1
    vo_0c = vo_0a + vo_0b
    vo_0c_right = vo_0c - vo_0a
    vo_0d = R_20 * v_2
    vo_0 = vo_0c + vo_0d
    vo_0_right = vo_0 - vo_0c
    vo_0c_lo = (product_rest(R_00, v_0, vo_0a, vo_0c - vo_0c_right)
        + product_rest(R_10, v_1, vo_0b, vo_0c_right))
    vo_1a = R_01 * v_0
    vo_1b = R_11 * v_1
    vo_1c = vo_1a + vo_1b
    vo_1c_right = vo_1c - vo_1a
    vo_1d = R_21 * v_2
    vo_1 = vo_1c + vo_1d
    vo_1_right = vo_1 - vo_1c
    vo_1c_lo = (product_rest(R_01, v_0, vo_1a, vo_1c - vo_1c_right)
        + product_rest(R_11, v_1, vo_1b, vo_1c_right))
    vo_2a = R_02 * v_0
    vo_2b = R_12 * v_1
    vo_2c = vo_2a + vo_2b
    vo_2c_right = vo_2c - vo_2a
    vo_2d = R_22 * v_2
    vo_2 = vo_2c + vo_2d
    vo_2_right = vo_2 - vo_2c
    vo_2c_lo = (product_rest(R_02, v_0, vo_2a, vo_2c - vo_2c_right)
        + product_rest(R_12, v_1, vo_2b, vo_2c_right))
    vo_0_rounded = (vo_0
        + (vo_0c - (vo_0 - vo_0_right) + product_rest(R_20, v_2, vo_0d, vo_0_right) + vo_0c_lo))
    vo_1_rounded = (vo_1
        + (vo_1c - (vo_1 - vo_1_right) + product_rest(R_21, v_2, vo_1d, vo_1_right) + vo_1c_lo))
    vo_2_rounded = (vo_2
        + (vo_2c - (vo_2 - vo_2_right) + product_rest(R_22, v_2, vo_2d, vo_2_right) + vo_2c_lo))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(3)->(3)")
def product_drinvvinv(R, v):
    """vo = R^T (-v).

    (3,3),(3)->(3).  R: rotation or other 3×3 matrix; v, vo: vector.
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0a = R_00 * v_0
    vo_0b = R_10 * v_1
    vo_0c = vo_0a + vo_0b
    vo_0c_right = vo_0c - vo_0a
    vo_0d = R_20 * v_2
    vo_0e = vo_0c + vo_0d
    vo_0e_right = vo_0e - vo_0c
    vo_0c_lo = (product_rest(R_00, v_0, vo_0a, vo_0c - vo_0c_right)
        + product_rest(R_10, v_1, vo_0b, vo_0c_right))
    vo_0 = -vo_0e
    vo_1a = R_01 * v_0
    vo_1b = R_11 * v_1
    vo_1c = vo_1a + vo_1b
    vo_1c_right = vo_1c - vo_1a
    vo_1d = R_21 * v_2
    vo_1e = vo_1c + vo_1d
    vo_1e_right = vo_1e - vo_1c
    vo_1c_lo = (product_rest(R_01, v_0, vo_1a, vo_1c - vo_1c_right)
        + product_rest(R_11, v_1, vo_1b, vo_1c_right))
    vo_1 = -vo_1e
    vo_2a = R_02 * v_0
    vo_2b = R_12 * v_1
    vo_2c = vo_2a + vo_2b
    vo_2c_right = vo_2c - vo_2a
    vo_2d = R_22 * v_2
    vo_2e = vo_2c + vo_2d
    vo_2e_right = vo_2e - vo_2c
    vo_2c_lo = (product_rest(R_02, v_0, vo_2a, vo_2c - vo_2c_right)
        + product_rest(R_12, v_1, vo_2b, vo_2c_right))
    vo_2 = -vo_2e
    vo_0_rounded = (vo_0 +
        -(vo_0c - (vo_0e - vo_0e_right) + product_rest(R_20, v_2, vo_0d, vo_0e_right) + vo_0c_lo))
    vo_1_rounded = (vo_1 +
        -(vo_1c - (vo_1e - vo_1e_right) + product_rest(R_21, v_2, vo_1d, vo_1e_right) + vo_1c_lo))
    vo_2_rounded = (vo_2 +
        -(vo_2c - (vo_2e - vo_2e_right) + product_rest(R_22, v_2, vo_2d, vo_2e_right) + vo_2c_lo))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,4),(3)->(3)")
def product_dv(D, v):
    """vo = R v + t.

    (3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.
    9 mul, 54 add, 9 product rest.  Error <= u |result| + 15 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    v_0, v_1, v_2 = v
    vo_0a = D_00 * v_0
    vo_0b = D_01 * v_1
    vo_0c = vo_0a + vo_0b
    vo_0c_right = vo_0c - vo_0a
    vo_0d = D_02 * v_2
    vo_0e = vo_0c + vo_0d
    vo_0e_right = vo_0e - vo_0c
    vo_0c_lo = (product_rest(D_00, v_0, vo_0a, vo_0c - vo_0c_right)
        + product_rest(D_01, v_1, vo_0b, vo_0c_right))
    vo_0 = vo_0e + D_03
    vo_0_right = vo_0 - vo_0e
    vo_1a = D_10 * v_0
    vo_1b = D_11 * v_1
    vo_1c = vo_1a + vo_1b
    vo_1c_right = vo_1c - vo_1a
    vo_1d = D_12 * v_2
    vo_1e = vo_1c + vo_1d
    vo_1e_right = vo_1e - vo_1c
    vo_1c_lo = (product_rest(D_10, v_0, vo_1a, vo_1c - vo_1c_right)
        + product_rest(D_11, v_1, vo_1b, vo_1c_right))
    vo_1 = vo_1e + D_13
    vo_1_right = vo_1 - vo_1e
    vo_2a = D_20 * v_0
    vo_2b = D_21 * v_1
    vo_2c = vo_2a + vo_2b
    vo_2c_right = vo_2c - vo_2a
    vo_2d = D_22 * v_2
    vo_2e = vo_2c + vo_2d
    vo_2e_right = vo_2e - vo_2c
    vo_2c_lo = (product_rest(D_20, v_0, vo_2a, vo_2c - vo_2c_right)
        + product_rest(D_21, v_1, vo_2b, vo_2c_right))
    vo_2 = vo_2e + D_23
    vo_2_right = vo_2 - vo_2e
    vo_0_lo = (vo_0e - (vo_0 - vo_0_right) + (D_03 - vo_0_right)
        + (vo_0c - (vo_0e - vo_0e_right) + product_rest(D_02, v_2, vo_0d, vo_0e_right) + vo_0c_lo))
    vo_0_rounded = vo_0 + vo_0_lo
    vo_1_lo = (vo_1e - (vo_1 - vo_1_right) + (D_13 - vo_1_right)
        + (vo_1c - (vo_1e - vo_1e_right) + product_rest(D_12, v_2, vo_1d, vo_1e_right) + vo_1c_lo))
    vo_1_rounded = vo_1 + vo_1_lo
    vo_2_lo = (vo_2e - (vo_2 - vo_2_right) + (D_23 - vo_2_right)
        + (vo_2c - (vo_2e - vo_2e_right) + product_rest(D_22, v_2, vo_2d, vo_2e_right) + vo_2c_lo))
    vo_2_rounded = vo_2 + vo_2_lo
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,4),(3)->(3)")
def product_dinvv(D, v):
    """vo = R^T (v - t).

    (3,4),(3)->(3).  D: displacement [R | t], R rotation, t in m; v, vo: vector.
    18 mul, 60 add, 9 product rest.  Error <= u |result| + 18 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    v_0, v_1, v_2 = v
    p_0 = v_0 - D_03
    p_0_right = v_0 - p_0
    p_0_lo = v_0 - (p_0 + p_0_right) - (D_03 - p_0_right)
    p_1 = v_1 - D_13
    p_1_right = v_1 - p_1
    p_1_lo = v_1 - (p_1 + p_1_right) - (D_13 - p_1_right)
    p_2 = v_2 - D_23
    p_2_right = v_2 - p_2
    p_2_lo = v_2 - (p_2 + p_2_right) - (D_23 - p_2_right)
    vo_0a = D_00 * p_0
    vo_0b = D_10 * p_1
    vo_0c = vo_0a + vo_0b
    vo_0c_right = vo_0c - vo_0a
    vo_0d = D_20 * p_2
    vo_0 = vo_0c + vo_0d
    vo_0_right = vo_0 - vo_0c
    vo_0c_lo = (product_rest(D_00, p_0, vo_0a, vo_0c - vo_0c_right)
        + product_rest(D_10, p_1, vo_0b, vo_0c_right) + (D_00 * p_0_lo + D_10 * p_1_lo))
    vo_1a = D_01 * p_0
    vo_1b = D_11 * p_1
    vo_1c = vo_1a + vo_1b
    vo_1c_right = vo_1c - vo_1a
    vo_1d = D_21 * p_2
    vo_1 = vo_1c + vo_1d
    vo_1_right = vo_1 - vo_1c
    vo_1c_lo = (product_rest(D_01, p_0, vo_1a, vo_1c - vo_1c_right)
        + product_rest(D_11, p_1, vo_1b, vo_1c_right) + (D_01 * p_0_lo + D_11 * p_1_lo))
    vo_2a = D_02 * p_0
    vo_2b = D_12 * p_1
    vo_2c = vo_2a + vo_2b
    vo_2c_right = vo_2c - vo_2a
    vo_2d = D_22 * p_2
    vo_2 = vo_2c + vo_2d
    vo_2_right = vo_2 - vo_2c
    vo_2c_lo = (product_rest(D_02, p_0, vo_2a, vo_2c - vo_2c_right)
        + product_rest(D_12, p_1, vo_2b, vo_2c_right) + (D_02 * p_0_lo + D_12 * p_1_lo))
    vo_0_rounded = (vo_0
        + (vo_0c - (vo_0 - vo_0_right) + product_rest(D_20, p_2, vo_0d, vo_0_right) + D_20 * p_2_lo
        + vo_0c_lo))
    vo_1_rounded = (vo_1
        + (vo_1c - (vo_1 - vo_1_right) + product_rest(D_21, p_2, vo_1d, vo_1_right) + D_21 * p_2_lo
        + vo_1c_lo))
    vo_2_rounded = (vo_2
        + (vo_2c - (vo_2 - vo_2_right) + product_rest(D_22, p_2, vo_2d, vo_2_right) + D_22 * p_2_lo
        + vo_2c_lo))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(3,3)->(3,3)")
def product_drdr(R1, R2):
    """Ro = R1 R2.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    R1_00, R1_01, R1_02, R1_10, R1_11, R1_12, R1_20, R1_21, R1_22 = R1
    R2_00, R2_01, R2_02, R2_10, R2_11, R2_12, R2_20, R2_21, R2_22 = R2
    Ro_00a = R1_00 * R2_00
    Ro_00b = R1_01 * R2_10
    Ro_00c = Ro_00a + Ro_00b
    Ro_00c_right = Ro_00c - Ro_00a
    Ro_00d = R1_02 * R2_20
    Ro_00 = Ro_00c + Ro_00d
    Ro_00_right = Ro_00 - Ro_00c
    Ro_00c_lo = (product_rest(R1_00, R2_00, Ro_00a, Ro_00c - Ro_00c_right)
        + product_rest(R1_01, R2_10, Ro_00b, Ro_00c_right))
    Ro_01a = R1_00 * R2_01
    Ro_01b = R1_01 * R2_11
    Ro_01c = Ro_01a + Ro_01b
    Ro_01c_right = Ro_01c - Ro_01a
    Ro_01d = R1_02 * R2_21
    Ro_01 = Ro_01c + Ro_01d
    Ro_01_right = Ro_01 - Ro_01c
    Ro_01c_lo = (product_rest(R1_00, R2_01, Ro_01a, Ro_01c - Ro_01c_right)
        + product_rest(R1_01, R2_11, Ro_01b, Ro_01c_right))
    Ro_02a = R1_00 * R2_02
    Ro_02b = R1_01 * R2_12
    Ro_02c = Ro_02a + Ro_02b
    Ro_02c_right = Ro_02c - Ro_02a
    Ro_02d = R1_02 * R2_22
    Ro_02 = Ro_02c + Ro_02d
    Ro_02_right = Ro_02 - Ro_02c
    Ro_02c_lo = (product_rest(R1_00, R2_02, Ro_02a, Ro_02c - Ro_02c_right)
        + product_rest(R1_01, R2_12, Ro_02b, Ro_02c_right))
    Ro_10a = R1_10 * R2_00
    Ro_10b = R1_11 * R2_10
    Ro_10c = Ro_10a + Ro_10b
    Ro_10c_right = Ro_10c - Ro_10a
    Ro_10d = R1_12 * R2_20
    Ro_10 = Ro_10c + Ro_10d
    Ro_10_right = Ro_10 - Ro_10c
    Ro_10c_lo = (product_rest(R1_10, R2_00, Ro_10a, Ro_10c - Ro_10c_right)
        + product_rest(R1_11, R2_10, Ro_10b, Ro_10c_right))
    Ro_11a = R1_10 * R2_01
    Ro_11b = R1_11 * R2_11
    Ro_11c = Ro_11a + Ro_11b
    Ro_11c_right = Ro_11c - Ro_11a
    Ro_11d = R1_12 * R2_21
    Ro_11 = Ro_11c + Ro_11d
    Ro_11_right = Ro_11 - Ro_11c
    Ro_11c_lo = (product_rest(R1_10, R2_01, Ro_11a, Ro_11c - Ro_11c_right)
        + product_rest(R1_11, R2_11, Ro_11b, Ro_11c_right))
    Ro_12a = R1_10 * R2_02
    Ro_12b = R1_11 * R2_12
    Ro_12c = Ro_12a + Ro_12b
    Ro_12c_right = Ro_12c - Ro_12a
    Ro_12d = R1_12 * R2_22
    Ro_12 = Ro_12c + Ro_12d
    Ro_12_right = Ro_12 - Ro_12c
    Ro_12c_lo = (product_rest(R1_10, R2_02, Ro_12a, Ro_12c - Ro_12c_right)
        + product_rest(R1_11, R2_12, Ro_12b, Ro_12c_right))
    Ro_20a = R1_20 * R2_00
    Ro_20b = R1_21 * R2_10
    Ro_20c = Ro_20a + Ro_20b
    Ro_20c_right = Ro_20c - Ro_20a
    Ro_20d = R1_22 * R2_20
    Ro_20 = Ro_20c + Ro_20d
    Ro_20_right = Ro_20 - Ro_20c
    Ro_20c_lo = (product_rest(R1_20, R2_00, Ro_20a, Ro_20c - Ro_20c_right)
        + product_rest(R1_21, R2_10, Ro_20b, Ro_20c_right))
    Ro_21a = R1_20 * R2_01
    Ro_21b = R1_21 * R2_11
    Ro_21c = Ro_21a + Ro_21b
    Ro_21c_right = Ro_21c - Ro_21a
    Ro_21d = R1_22 * R2_21
    Ro_21 = Ro_21c + Ro_21d
    Ro_21_right = Ro_21 - Ro_21c
    Ro_21c_lo = (product_rest(R1_20, R2_01, Ro_21a, Ro_21c - Ro_21c_right)
        + product_rest(R1_21, R2_11, Ro_21b, Ro_21c_right))
    Ro_22a = R1_20 * R2_02
    Ro_22b = R1_21 * R2_12
    Ro_22c = Ro_22a + Ro_22b
    Ro_22c_right = Ro_22c - Ro_22a
    Ro_22d = R1_22 * R2_22
    Ro_22 = Ro_22c + Ro_22d
    Ro_22_right = Ro_22 - Ro_22c
    Ro_22c_lo = (product_rest(R1_20, R2_02, Ro_22a, Ro_22c - Ro_22c_right)
        + product_rest(R1_21, R2_12, Ro_22b, Ro_22c_right))
    Ro_00_rounded = (Ro_00
        + (Ro_00c - (Ro_00 - Ro_00_right) + product_rest(R1_02, R2_20, Ro_00d, Ro_00_right)
        + Ro_00c_lo))
    Ro_01_rounded = (Ro_01
        + (Ro_01c - (Ro_01 - Ro_01_right) + product_rest(R1_02, R2_21, Ro_01d, Ro_01_right)
        + Ro_01c_lo))
    Ro_02_rounded = (Ro_02
        + (Ro_02c - (Ro_02 - Ro_02_right) + product_rest(R1_02, R2_22, Ro_02d, Ro_02_right)
        + Ro_02c_lo))
    Ro_10_rounded = (Ro_10
        + (Ro_10c - (Ro_10 - Ro_10_right) + product_rest(R1_12, R2_20, Ro_10d, Ro_10_right)
        + Ro_10c_lo))
    Ro_11_rounded = (Ro_11
        + (Ro_11c - (Ro_11 - Ro_11_right) + product_rest(R1_12, R2_21, Ro_11d, Ro_11_right)
        + Ro_11c_lo))
    Ro_12_rounded = (Ro_12
        + (Ro_12c - (Ro_12 - Ro_12_right) + product_rest(R1_12, R2_22, Ro_12d, Ro_12_right)
        + Ro_12c_lo))
    Ro_20_rounded = (Ro_20
        + (Ro_20c - (Ro_20 - Ro_20_right) + product_rest(R1_22, R2_20, Ro_20d, Ro_20_right)
        + Ro_20c_lo))
    Ro_21_rounded = (Ro_21
        + (Ro_21c - (Ro_21 - Ro_21_right) + product_rest(R1_22, R2_21, Ro_21d, Ro_21_right)
        + Ro_21c_lo))
    Ro_22_rounded = (Ro_22
        + (Ro_22c - (Ro_22 - Ro_22_right) + product_rest(R1_22, R2_22, Ro_22d, Ro_22_right)
        + Ro_22c_lo))
    return (Ro_00_rounded, Ro_01_rounded, Ro_02_rounded, Ro_10_rounded, Ro_11_rounded,
        Ro_12_rounded, Ro_20_rounded, Ro_21_rounded, Ro_22_rounded)


@kernel("(3,3),(3,3)->(3,3)")
def product_drdrinv(R1, R2):
    """Ro = R1 R2^T.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    R1_00, R1_01, R1_02, R1_10, R1_11, R1_12, R1_20, R1_21, R1_22 = R1
    R2_00, R2_01, R2_02, R2_10, R2_11, R2_12, R2_20, R2_21, R2_22 = R2
    Ro_00a = R1_00 * R2_00
    Ro_00b = R1_01 * R2_01
    Ro_00c = Ro_00a + Ro_00b
    Ro_00c_right = Ro_00c - Ro_00a
    Ro_00d = R1_02 * R2_02
    Ro_00 = Ro_00c + Ro_00d
    Ro_00_right = Ro_00 - Ro_00c
    Ro_00c_lo = (product_rest(R1_00, R2_00, Ro_00a, Ro_00c - Ro_00c_right)
        + product_rest(R1_01, R2_01, Ro_00b, Ro_00c_right))
    Ro_01a = R1_00 * R2_10
    Ro_01b = R1_01 * R2_11
    Ro_01c = Ro_01a + Ro_01b
    Ro_01c_right = Ro_01c - Ro_01a
    Ro_01d = R1_02 * R2_12
    Ro_01 = Ro_01c + Ro_01d
    Ro_01_right = Ro_01 - Ro_01c
    Ro_01c_lo = (product_rest(R1_00, R2_10, Ro_01a, Ro_01c - Ro_01c_right)
        + product_rest(R1_01, R2_11, Ro_01b, Ro_01c_right))
    Ro_02a = R1_00 * R2_20
    Ro_02b = R1_01 * R2_21
    Ro_02c = Ro_02a + Ro_02b
    Ro_02c_right = Ro_02c - Ro_02a
    Ro_02d = R1_02 * R2_22
    Ro_02 = Ro_02c + Ro_02d
    Ro_02_right = Ro_02 - Ro_02c
    Ro_02c_lo = (product_rest(R1_00, R2_20, Ro_02a, Ro_02c - Ro_02c_right)
        + product_rest(R1_01, R2_21, Ro_02b, Ro_02c_right))
    Ro_10a = R1_10 * R2_00
    Ro_10b = R1_11 * R2_01
    Ro_10c = Ro_10a + Ro_10b
    Ro_10c_right = Ro_10c - Ro_10a
    Ro_10d = R1_12 * R2_02
    Ro_10 = Ro_10c + Ro_10d
    Ro_10_right = Ro_10 - Ro_10c
    Ro_10c_lo = (product_rest(R1_10, R2_00, Ro_10a, Ro_10c - Ro_10c_right)
        + product_rest(R1_11, R2_01, Ro_10b, Ro_10c_right))
    Ro_11a = R1_10 * R2_10
    Ro_11b = R1_11 * R2_11
    Ro_11c = Ro_11a + Ro_11b
    Ro_11c_right = Ro_11c - Ro_11a
    Ro_11d = R1_12 * R2_12
    Ro_11 = Ro_11c + Ro_11d
    Ro_11_right = Ro_11 - Ro_11c
    Ro_11c_lo = (product_rest(R1_10, R2_10, Ro_11a, Ro_11c - Ro_11c_right)
        + product_rest(R1_11, R2_11, Ro_11b, Ro_11c_right))
    Ro_12a = R1_10 * R2_20
    Ro_12b = R1_11 * R2_21
    Ro_12c = Ro_12a + Ro_12b
    Ro_12c_right = Ro_12c - Ro_12a
    Ro_12d = R1_12 * R2_22
    Ro_12 = Ro_12c + Ro_12d
    Ro_12_right = Ro_12 - Ro_12c
    Ro_12c_lo = (product_rest(R1_10, R2_20, Ro_12a, Ro_12c - Ro_12c_right)
        + product_rest(R1_11, R2_21, Ro_12b, Ro_12c_right))
    Ro_20a = R1_20 * R2_00
    Ro_20b = R1_21 * R2_01
    Ro_20c = Ro_20a + Ro_20b
    Ro_20c_right = Ro_20c - Ro_20a
    Ro_20d = R1_22 * R2_02
    Ro_20 = Ro_20c + Ro_20d
    Ro_20_right = Ro_20 - Ro_20c
    Ro_20c_lo = (product_rest(R1_20, R2_00, Ro_20a, Ro_20c - Ro_20c_right)
        + product_rest(R1_21, R2_01, Ro_20b, Ro_20c_right))
    Ro_21a = R1_20 * R2_10
    Ro_21b = R1_21 * R2_11
    Ro_21c = Ro_21a + Ro_21b
    Ro_21c_right = Ro_21c - Ro_21a
    Ro_21d = R1_22 * R2_12
    Ro_21 = Ro_21c + Ro_21d
    Ro_21_right = Ro_21 - Ro_21c
    Ro_21c_lo = (product_rest(R1_20, R2_10, Ro_21a, Ro_21c - Ro_21c_right)
        + product_rest(R1_21, R2_11, Ro_21b, Ro_21c_right))
    Ro_22a = R1_20 * R2_20
    Ro_22b = R1_21 * R2_21
    Ro_22c = Ro_22a + Ro_22b
    Ro_22c_right = Ro_22c - Ro_22a
    Ro_22d = R1_22 * R2_22
    Ro_22 = Ro_22c + Ro_22d
    Ro_22_right = Ro_22 - Ro_22c
    Ro_22c_lo = (product_rest(R1_20, R2_20, Ro_22a, Ro_22c - Ro_22c_right)
        + product_rest(R1_21, R2_21, Ro_22b, Ro_22c_right))
    Ro_00_rounded = (Ro_00
        + (Ro_00c - (Ro_00 - Ro_00_right) + product_rest(R1_02, R2_02, Ro_00d, Ro_00_right)
        + Ro_00c_lo))
    Ro_01_rounded = (Ro_01
        + (Ro_01c - (Ro_01 - Ro_01_right) + product_rest(R1_02, R2_12, Ro_01d, Ro_01_right)
        + Ro_01c_lo))
    Ro_02_rounded = (Ro_02
        + (Ro_02c - (Ro_02 - Ro_02_right) + product_rest(R1_02, R2_22, Ro_02d, Ro_02_right)
        + Ro_02c_lo))
    Ro_10_rounded = (Ro_10
        + (Ro_10c - (Ro_10 - Ro_10_right) + product_rest(R1_12, R2_02, Ro_10d, Ro_10_right)
        + Ro_10c_lo))
    Ro_11_rounded = (Ro_11
        + (Ro_11c - (Ro_11 - Ro_11_right) + product_rest(R1_12, R2_12, Ro_11d, Ro_11_right)
        + Ro_11c_lo))
    Ro_12_rounded = (Ro_12
        + (Ro_12c - (Ro_12 - Ro_12_right) + product_rest(R1_12, R2_22, Ro_12d, Ro_12_right)
        + Ro_12c_lo))
    Ro_20_rounded = (Ro_20
        + (Ro_20c - (Ro_20 - Ro_20_right) + product_rest(R1_22, R2_02, Ro_20d, Ro_20_right)
        + Ro_20c_lo))
    Ro_21_rounded = (Ro_21
        + (Ro_21c - (Ro_21 - Ro_21_right) + product_rest(R1_22, R2_12, Ro_21d, Ro_21_right)
        + Ro_21c_lo))
    Ro_22_rounded = (Ro_22
        + (Ro_22c - (Ro_22 - Ro_22_right) + product_rest(R1_22, R2_22, Ro_22d, Ro_22_right)
        + Ro_22c_lo))
    return (Ro_00_rounded, Ro_01_rounded, Ro_02_rounded, Ro_10_rounded, Ro_11_rounded,
        Ro_12_rounded, Ro_20_rounded, Ro_21_rounded, Ro_22_rounded)


@kernel("(3,3),(3,3)->(3,3)")
def product_drinvdr(R1, R2):
    """Ro = R1^T R2.

    (3,3),(3,3)->(3,3).  R1, R2, Ro: rotation or other 3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    R1_00, R1_01, R1_02, R1_10, R1_11, R1_12, R1_20, R1_21, R1_22 = R1
    R2_00, R2_01, R2_02, R2_10, R2_11, R2_12, R2_20, R2_21, R2_22 = R2
    Ro_00a = R1_00 * R2_00
    Ro_00b = R1_10 * R2_10
    Ro_00c = Ro_00a + Ro_00b
    Ro_00c_right = Ro_00c - Ro_00a
    Ro_00d = R1_20 * R2_20
    Ro_00 = Ro_00c + Ro_00d
    Ro_00_right = Ro_00 - Ro_00c
    Ro_00c_lo = (product_rest(R1_00, R2_00, Ro_00a, Ro_00c - Ro_00c_right)
        + product_rest(R1_10, R2_10, Ro_00b, Ro_00c_right))
    Ro_01a = R1_00 * R2_01
    Ro_01b = R1_10 * R2_11
    Ro_01c = Ro_01a + Ro_01b
    Ro_01c_right = Ro_01c - Ro_01a
    Ro_01d = R1_20 * R2_21
    Ro_01 = Ro_01c + Ro_01d
    Ro_01_right = Ro_01 - Ro_01c
    Ro_01c_lo = (product_rest(R1_00, R2_01, Ro_01a, Ro_01c - Ro_01c_right)
        + product_rest(R1_10, R2_11, Ro_01b, Ro_01c_right))
    Ro_02a = R1_00 * R2_02
    Ro_02b = R1_10 * R2_12
    Ro_02c = Ro_02a + Ro_02b
    Ro_02c_right = Ro_02c - Ro_02a
    Ro_02d = R1_20 * R2_22
    Ro_02 = Ro_02c + Ro_02d
    Ro_02_right = Ro_02 - Ro_02c
    Ro_02c_lo = (product_rest(R1_00, R2_02, Ro_02a, Ro_02c - Ro_02c_right)
        + product_rest(R1_10, R2_12, Ro_02b, Ro_02c_right))
    Ro_10a = R1_01 * R2_00
    Ro_10b = R1_11 * R2_10
    Ro_10c = Ro_10a + Ro_10b
    Ro_10c_right = Ro_10c - Ro_10a
    Ro_10d = R1_21 * R2_20
    Ro_10 = Ro_10c + Ro_10d
    Ro_10_right = Ro_10 - Ro_10c
    Ro_10c_lo = (product_rest(R1_01, R2_00, Ro_10a, Ro_10c - Ro_10c_right)
        + product_rest(R1_11, R2_10, Ro_10b, Ro_10c_right))
    Ro_11a = R1_01 * R2_01
    Ro_11b = R1_11 * R2_11
    Ro_11c = Ro_11a + Ro_11b
    Ro_11c_right = Ro_11c - Ro_11a
    Ro_11d = R1_21 * R2_21
    Ro_11 = Ro_11c + Ro_11d
    Ro_11_right = Ro_11 - Ro_11c
    Ro_11c_lo = (product_rest(R1_01, R2_01, Ro_11a, Ro_11c - Ro_11c_right)
        + product_rest(R1_11, R2_11, Ro_11b, Ro_11c_right))
    Ro_12a = R1_01 * R2_02
    Ro_12b = R1_11 * R2_12
    Ro_12c = Ro_12a + Ro_12b
    Ro_12c_right = Ro_12c - Ro_12a
    Ro_12d = R1_21 * R2_22
    Ro_12 = Ro_12c + Ro_12d
    Ro_12_right = Ro_12 - Ro_12c
    Ro_12c_lo = (product_rest(R1_01, R2_02, Ro_12a, Ro_12c - Ro_12c_right)
        + product_rest(R1_11, R2_12, Ro_12b, Ro_12c_right))
    Ro_20a = R1_02 * R2_00
    Ro_20b = R1_12 * R2_10
    Ro_20c = Ro_20a + Ro_20b
    Ro_20c_right = Ro_20c - Ro_20a
    Ro_20d = R1_22 * R2_20
    Ro_20 = Ro_20c + Ro_20d
    Ro_20_right = Ro_20 - Ro_20c
    Ro_20c_lo = (product_rest(R1_02, R2_00, Ro_20a, Ro_20c - Ro_20c_right)
        + product_rest(R1_12, R2_10, Ro_20b, Ro_20c_right))
    Ro_21a = R1_02 * R2_01
    Ro_21b = R1_12 * R2_11
    Ro_21c = Ro_21a + Ro_21b
    Ro_21c_right = Ro_21c - Ro_21a
    Ro_21d = R1_22 * R2_21
    Ro_21 = Ro_21c + Ro_21d
    Ro_21_right = Ro_21 - Ro_21c
    Ro_21c_lo = (product_rest(R1_02, R2_01, Ro_21a, Ro_21c - Ro_21c_right)
        + product_rest(R1_12, R2_11, Ro_21b, Ro_21c_right))
    Ro_22a = R1_02 * R2_02
    Ro_22b = R1_12 * R2_12
    Ro_22c = Ro_22a + Ro_22b
    Ro_22c_right = Ro_22c - Ro_22a
    Ro_22d = R1_22 * R2_22
    Ro_22 = Ro_22c + Ro_22d
    Ro_22_right = Ro_22 - Ro_22c
    Ro_22c_lo = (product_rest(R1_02, R2_02, Ro_22a, Ro_22c - Ro_22c_right)
        + product_rest(R1_12, R2_12, Ro_22b, Ro_22c_right))
    Ro_00_rounded = (Ro_00
        + (Ro_00c - (Ro_00 - Ro_00_right) + product_rest(R1_20, R2_20, Ro_00d, Ro_00_right)
        + Ro_00c_lo))
    Ro_01_rounded = (Ro_01
        + (Ro_01c - (Ro_01 - Ro_01_right) + product_rest(R1_20, R2_21, Ro_01d, Ro_01_right)
        + Ro_01c_lo))
    Ro_02_rounded = (Ro_02
        + (Ro_02c - (Ro_02 - Ro_02_right) + product_rest(R1_20, R2_22, Ro_02d, Ro_02_right)
        + Ro_02c_lo))
    Ro_10_rounded = (Ro_10
        + (Ro_10c - (Ro_10 - Ro_10_right) + product_rest(R1_21, R2_20, Ro_10d, Ro_10_right)
        + Ro_10c_lo))
    Ro_11_rounded = (Ro_11
        + (Ro_11c - (Ro_11 - Ro_11_right) + product_rest(R1_21, R2_21, Ro_11d, Ro_11_right)
        + Ro_11c_lo))
    Ro_12_rounded = (Ro_12
        + (Ro_12c - (Ro_12 - Ro_12_right) + product_rest(R1_21, R2_22, Ro_12d, Ro_12_right)
        + Ro_12c_lo))
    Ro_20_rounded = (Ro_20
        + (Ro_20c - (Ro_20 - Ro_20_right) + product_rest(R1_22, R2_20, Ro_20d, Ro_20_right)
        + Ro_20c_lo))
    Ro_21_rounded = (Ro_21
        + (Ro_21c - (Ro_21 - Ro_21_right) + product_rest(R1_22, R2_21, Ro_21d, Ro_21_right)
        + Ro_21c_lo))
    Ro_22_rounded = (Ro_22
        + (Ro_22c - (Ro_22 - Ro_22_right) + product_rest(R1_22, R2_22, Ro_22d, Ro_22_right)
        + Ro_22c_lo))
    return (Ro_00_rounded, Ro_01_rounded, Ro_02_rounded, Ro_10_rounded, Ro_11_rounded,
        Ro_12_rounded, Ro_20_rounded, Ro_21_rounded, Ro_22_rounded)


@kernel("(3,4),(3,4)->(3,4)")
def product_dd(D1, D2):
    """Do = D1 D2 = [R1 R2 | R1 t2 + t1].

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    36 mul, 153 add, 36 product rest.  Error <= u |result| + (R: 11, t: 15) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    Do_00a = D1_00 * D2_00
    Do_00b = D1_01 * D2_10
    Do_00c = Do_00a + Do_00b
    Do_00c_right = Do_00c - Do_00a
    Do_00d = D1_02 * D2_20
    Do_00 = Do_00c + Do_00d
    Do_00_right = Do_00 - Do_00c
    Do_00c_lo = (product_rest(D1_00, D2_00, Do_00a, Do_00c - Do_00c_right)
        + product_rest(D1_01, D2_10, Do_00b, Do_00c_right))
    Do_01a = D1_00 * D2_01
    Do_01b = D1_01 * D2_11
    Do_01c = Do_01a + Do_01b
    Do_01c_right = Do_01c - Do_01a
    Do_01d = D1_02 * D2_21
    Do_01 = Do_01c + Do_01d
    Do_01_right = Do_01 - Do_01c
    Do_01c_lo = (product_rest(D1_00, D2_01, Do_01a, Do_01c - Do_01c_right)
        + product_rest(D1_01, D2_11, Do_01b, Do_01c_right))
    Do_02a = D1_00 * D2_02
    Do_02b = D1_01 * D2_12
    Do_02c = Do_02a + Do_02b
    Do_02c_right = Do_02c - Do_02a
    Do_02d = D1_02 * D2_22
    Do_02 = Do_02c + Do_02d
    Do_02_right = Do_02 - Do_02c
    Do_02c_lo = (product_rest(D1_00, D2_02, Do_02a, Do_02c - Do_02c_right)
        + product_rest(D1_01, D2_12, Do_02b, Do_02c_right))
    Do_03a = D1_00 * D2_03
    Do_03b = D1_01 * D2_13
    Do_03c = Do_03a + Do_03b
    Do_03c_right = Do_03c - Do_03a
    Do_03d = D1_02 * D2_23
    Do_03e = Do_03c + Do_03d
    Do_03e_right = Do_03e - Do_03c
    Do_03c_lo = (product_rest(D1_00, D2_03, Do_03a, Do_03c - Do_03c_right)
        + product_rest(D1_01, D2_13, Do_03b, Do_03c_right))
    Do_03 = Do_03e + D1_03
    Do_03_right = Do_03 - Do_03e
    Do_03e_lo = (Do_03c - (Do_03e - Do_03e_right)
        + product_rest(D1_02, D2_23, Do_03d, Do_03e_right) + Do_03c_lo)
    Do_10a = D1_10 * D2_00
    Do_10b = D1_11 * D2_10
    Do_10c = Do_10a + Do_10b
    Do_10c_right = Do_10c - Do_10a
    Do_10d = D1_12 * D2_20
    Do_10 = Do_10c + Do_10d
    Do_10_right = Do_10 - Do_10c
    Do_10c_lo = (product_rest(D1_10, D2_00, Do_10a, Do_10c - Do_10c_right)
        + product_rest(D1_11, D2_10, Do_10b, Do_10c_right))
    Do_11a = D1_10 * D2_01
    Do_11b = D1_11 * D2_11
    Do_11c = Do_11a + Do_11b
    Do_11c_right = Do_11c - Do_11a
    Do_11d = D1_12 * D2_21
    Do_11 = Do_11c + Do_11d
    Do_11_right = Do_11 - Do_11c
    Do_11c_lo = (product_rest(D1_10, D2_01, Do_11a, Do_11c - Do_11c_right)
        + product_rest(D1_11, D2_11, Do_11b, Do_11c_right))
    Do_12a = D1_10 * D2_02
    Do_12b = D1_11 * D2_12
    Do_12c = Do_12a + Do_12b
    Do_12c_right = Do_12c - Do_12a
    Do_12d = D1_12 * D2_22
    Do_12 = Do_12c + Do_12d
    Do_12_right = Do_12 - Do_12c
    Do_12c_lo = (product_rest(D1_10, D2_02, Do_12a, Do_12c - Do_12c_right)
        + product_rest(D1_11, D2_12, Do_12b, Do_12c_right))
    Do_13a = D1_10 * D2_03
    Do_13b = D1_11 * D2_13
    Do_13c = Do_13a + Do_13b
    Do_13c_right = Do_13c - Do_13a
    Do_13d = D1_12 * D2_23
    Do_13e = Do_13c + Do_13d
    Do_13e_right = Do_13e - Do_13c
    Do_13c_lo = (product_rest(D1_10, D2_03, Do_13a, Do_13c - Do_13c_right)
        + product_rest(D1_11, D2_13, Do_13b, Do_13c_right))
    Do_13 = Do_13e + D1_13
    Do_13_right = Do_13 - Do_13e
    Do_13e_lo = (Do_13c - (Do_13e - Do_13e_right)
        + product_rest(D1_12, D2_23, Do_13d, Do_13e_right) + Do_13c_lo)
    Do_20a = D1_20 * D2_00
    Do_20b = D1_21 * D2_10
    Do_20c = Do_20a + Do_20b
    Do_20c_right = Do_20c - Do_20a
    Do_20d = D1_22 * D2_20
    Do_20 = Do_20c + Do_20d
    Do_20_right = Do_20 - Do_20c
    Do_20c_lo = (product_rest(D1_20, D2_00, Do_20a, Do_20c - Do_20c_right)
        + product_rest(D1_21, D2_10, Do_20b, Do_20c_right))
    Do_21a = D1_20 * D2_01
    Do_21b = D1_21 * D2_11
    Do_21c = Do_21a + Do_21b
    Do_21c_right = Do_21c - Do_21a
    Do_21d = D1_22 * D2_21
    Do_21 = Do_21c + Do_21d
    Do_21_right = Do_21 - Do_21c
    Do_21c_lo = (product_rest(D1_20, D2_01, Do_21a, Do_21c - Do_21c_right)
        + product_rest(D1_21, D2_11, Do_21b, Do_21c_right))
    Do_22a = D1_20 * D2_02
    Do_22b = D1_21 * D2_12
    Do_22c = Do_22a + Do_22b
    Do_22c_right = Do_22c - Do_22a
    Do_22d = D1_22 * D2_22
    Do_22 = Do_22c + Do_22d
    Do_22_right = Do_22 - Do_22c
    Do_22c_lo = (product_rest(D1_20, D2_02, Do_22a, Do_22c - Do_22c_right)
        + product_rest(D1_21, D2_12, Do_22b, Do_22c_right))
    Do_23a = D1_20 * D2_03
    Do_23b = D1_21 * D2_13
    Do_23c = Do_23a + Do_23b
    Do_23c_right = Do_23c - Do_23a
    Do_23d = D1_22 * D2_23
    Do_23e = Do_23c + Do_23d
    Do_23e_right = Do_23e - Do_23c
    Do_23c_lo = (product_rest(D1_20, D2_03, Do_23a, Do_23c - Do_23c_right)
        + product_rest(D1_21, D2_13, Do_23b, Do_23c_right))
    Do_23 = Do_23e + D1_23
    Do_23_right = Do_23 - Do_23e
    Do_23e_lo = (Do_23c - (Do_23e - Do_23e_right)
        + product_rest(D1_22, D2_23, Do_23d, Do_23e_right) + Do_23c_lo)
    Do_00_rounded = (Do_00
        + (Do_00c - (Do_00 - Do_00_right) + product_rest(D1_02, D2_20, Do_00d, Do_00_right)
        + Do_00c_lo))
    Do_01_rounded = (Do_01
        + (Do_01c - (Do_01 - Do_01_right) + product_rest(D1_02, D2_21, Do_01d, Do_01_right)
        + Do_01c_lo))
    Do_02_rounded = (Do_02
        + (Do_02c - (Do_02 - Do_02_right) + product_rest(D1_02, D2_22, Do_02d, Do_02_right)
        + Do_02c_lo))
    Do_03_rounded = Do_03 + (Do_03e - (Do_03 - Do_03_right) + (D1_03 - Do_03_right) + Do_03e_lo)
    Do_10_rounded = (Do_10
        + (Do_10c - (Do_10 - Do_10_right) + product_rest(D1_12, D2_20, Do_10d, Do_10_right)
        + Do_10c_lo))
    Do_11_rounded = (Do_11
        + (Do_11c - (Do_11 - Do_11_right) + product_rest(D1_12, D2_21, Do_11d, Do_11_right)
        + Do_11c_lo))
    Do_12_rounded = (Do_12
        + (Do_12c - (Do_12 - Do_12_right) + product_rest(D1_12, D2_22, Do_12d, Do_12_right)
        + Do_12c_lo))
    Do_13_rounded = Do_13 + (Do_13e - (Do_13 - Do_13_right) + (D1_13 - Do_13_right) + Do_13e_lo)
    Do_20_rounded = (Do_20
        + (Do_20c - (Do_20 - Do_20_right) + product_rest(D1_22, D2_20, Do_20d, Do_20_right)
        + Do_20c_lo))
    Do_21_rounded = (Do_21
        + (Do_21c - (Do_21 - Do_21_right) + product_rest(D1_22, D2_21, Do_21d, Do_21_right)
        + Do_21c_lo))
    Do_22_rounded = (Do_22
        + (Do_22c - (Do_22 - Do_22_right) + product_rest(D1_22, D2_22, Do_22d, Do_22_right)
        + Do_22c_lo))
    Do_23_rounded = Do_23 + (Do_23e - (Do_23 - Do_23_right) + (D1_23 - Do_23_right) + Do_23e_lo)
    return (Do_00_rounded, Do_01_rounded, Do_02_rounded, Do_03_rounded, Do_10_rounded,
        Do_11_rounded, Do_12_rounded, Do_13_rounded, Do_20_rounded, Do_21_rounded, Do_22_rounded,
        Do_23_rounded)


@kernel("(3,4),(3,4)->(3,4)")
def product_ddinv(D1, D2):
    """Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    45 mul, 162 add, 36 product rest.  Error <= u |result| + (R: 11, t: 44) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    R_0a = D1_00 * D2_00
    R_0b = D1_01 * D2_01
    R_0c = R_0a + R_0b
    R_0c_right = R_0c - R_0a
    R_0d = D1_02 * D2_02
    R_0 = R_0c + R_0d
    R_0_right = R_0 - R_0c
    R_0c_lo = (product_rest(D1_00, D2_00, R_0a, R_0c - R_0c_right)
        + product_rest(D1_01, D2_01, R_0b, R_0c_right))
    R_0_lo = R_0c - (R_0 - R_0_right) + product_rest(D1_02, D2_02, R_0d, R_0_right) + R_0c_lo
    R_1a = D1_00 * D2_10
    R_1b = D1_01 * D2_11
    R_1c = R_1a + R_1b
    R_1c_right = R_1c - R_1a
    R_1d = D1_02 * D2_12
    R_1 = R_1c + R_1d
    R_1_right = R_1 - R_1c
    R_1c_lo = (product_rest(D1_00, D2_10, R_1a, R_1c - R_1c_right)
        + product_rest(D1_01, D2_11, R_1b, R_1c_right))
    R_1_lo = R_1c - (R_1 - R_1_right) + product_rest(D1_02, D2_12, R_1d, R_1_right) + R_1c_lo
    R_2a = D1_00 * D2_20
    R_2b = D1_01 * D2_21
    R_2c = R_2a + R_2b
    R_2c_right = R_2c - R_2a
    R_2d = D1_02 * D2_22
    R_2 = R_2c + R_2d
    R_2_right = R_2 - R_2c
    R_2c_lo = (product_rest(D1_00, D2_20, R_2a, R_2c - R_2c_right)
        + product_rest(D1_01, D2_21, R_2b, R_2c_right))
    R_2_lo = R_2c - (R_2 - R_2_right) + product_rest(D1_02, D2_22, R_2d, R_2_right) + R_2c_lo
    R_3a = D1_10 * D2_00
    R_3b = D1_11 * D2_01
    R_3c = R_3a + R_3b
    R_3c_right = R_3c - R_3a
    R_3d = D1_12 * D2_02
    R_3 = R_3c + R_3d
    R_3_right = R_3 - R_3c
    R_3c_lo = (product_rest(D1_10, D2_00, R_3a, R_3c - R_3c_right)
        + product_rest(D1_11, D2_01, R_3b, R_3c_right))
    R_3_lo = R_3c - (R_3 - R_3_right) + product_rest(D1_12, D2_02, R_3d, R_3_right) + R_3c_lo
    R_4a = D1_10 * D2_10
    R_4b = D1_11 * D2_11
    R_4c = R_4a + R_4b
    R_4c_right = R_4c - R_4a
    R_4d = D1_12 * D2_12
    R_4 = R_4c + R_4d
    R_4_right = R_4 - R_4c
    R_4c_lo = (product_rest(D1_10, D2_10, R_4a, R_4c - R_4c_right)
        + product_rest(D1_11, D2_11, R_4b, R_4c_right))
    R_4_lo = R_4c - (R_4 - R_4_right) + product_rest(D1_12, D2_12, R_4d, R_4_right) + R_4c_lo
    R_5a = D1_10 * D2_20
    R_5b = D1_11 * D2_21
    R_5c = R_5a + R_5b
    R_5c_right = R_5c - R_5a
    R_5d = D1_12 * D2_22
    R_5 = R_5c + R_5d
    R_5_right = R_5 - R_5c
    R_5c_lo = (product_rest(D1_10, D2_20, R_5a, R_5c - R_5c_right)
        + product_rest(D1_11, D2_21, R_5b, R_5c_right))
    R_5_lo = R_5c - (R_5 - R_5_right) + product_rest(D1_12, D2_22, R_5d, R_5_right) + R_5c_lo
    R_6a = D1_20 * D2_00
    R_6b = D1_21 * D2_01
    R_6c = R_6a + R_6b
    R_6c_right = R_6c - R_6a
    R_6d = D1_22 * D2_02
    R_6 = R_6c + R_6d
    R_6_right = R_6 - R_6c
    R_6c_lo = (product_rest(D1_20, D2_00, R_6a, R_6c - R_6c_right)
        + product_rest(D1_21, D2_01, R_6b, R_6c_right))
    R_6_lo = R_6c - (R_6 - R_6_right) + product_rest(D1_22, D2_02, R_6d, R_6_right) + R_6c_lo
    R_7a = D1_20 * D2_10
    R_7b = D1_21 * D2_11
    R_7c = R_7a + R_7b
    R_7c_right = R_7c - R_7a
    R_7d = D1_22 * D2_12
    R_7 = R_7c + R_7d
    R_7_right = R_7 - R_7c
    R_7c_lo = (product_rest(D1_20, D2_10, R_7a, R_7c - R_7c_right)
        + product_rest(D1_21, D2_11, R_7b, R_7c_right))
    R_7_lo = R_7c - (R_7 - R_7_right) + product_rest(D1_22, D2_12, R_7d, R_7_right) + R_7c_lo
    R_8a = D1_20 * D2_20
    R_8b = D1_21 * D2_21
    R_8c = R_8a + R_8b
    R_8c_right = R_8c - R_8a
    R_8d = D1_22 * D2_22
    R_8 = R_8c + R_8d
    R_8_right = R_8 - R_8c
    R_8c_lo = (product_rest(D1_20, D2_20, R_8a, R_8c - R_8c_right)
        + product_rest(D1_21, D2_21, R_8b, R_8c_right))
    R_8_lo = R_8c - (R_8 - R_8_right) + product_rest(D1_22, D2_22, R_8d, R_8_right) + R_8c_lo
    Do_03a = D2_03 * R_0
    Do_03b = D2_13 * R_1
    Do_03c = Do_03a + Do_03b
    Do_03c_right = Do_03c - Do_03a
    Do_03c_lo1 = (product_rest(D2_03, R_0, Do_03a, Do_03c - Do_03c_right)
        + product_rest(D2_13, R_1, Do_03b, Do_03c_right))
    Do_03d = D2_23 * R_2
    Do_03e = Do_03c + Do_03d
    Do_03e_right = Do_03e - Do_03c
    Do_03e_lo2 = (Do_03c - (Do_03e - Do_03e_right) + product_rest(D2_23, R_2, Do_03d, Do_03e_right)
        + D2_23 * R_2_lo)
    Do_03 = D1_03 - Do_03e
    Do_03_right = D1_03 - Do_03
    Do_13a = D2_03 * R_3
    Do_13b = D2_13 * R_4
    Do_13c = Do_13a + Do_13b
    Do_13c_right = Do_13c - Do_13a
    Do_13c_lo1 = (product_rest(D2_03, R_3, Do_13a, Do_13c - Do_13c_right)
        + product_rest(D2_13, R_4, Do_13b, Do_13c_right))
    Do_13d = D2_23 * R_5
    Do_13e = Do_13c + Do_13d
    Do_13e_right = Do_13e - Do_13c
    Do_13e_lo2 = (Do_13c - (Do_13e - Do_13e_right) + product_rest(D2_23, R_5, Do_13d, Do_13e_right)
        + D2_23 * R_5_lo)
    Do_13 = D1_13 - Do_13e
    Do_13_right = D1_13 - Do_13
    Do_23a = D2_03 * R_6
    Do_23b = D2_13 * R_7
    Do_23c = Do_23a + Do_23b
    Do_23c_right = Do_23c - Do_23a
    Do_23c_lo1 = (product_rest(D2_03, R_6, Do_23a, Do_23c - Do_23c_right)
        + product_rest(D2_13, R_7, Do_23b, Do_23c_right))
    Do_23d = D2_23 * R_8
    Do_23e = Do_23c + Do_23d
    Do_23e_right = Do_23e - Do_23c
    Do_23e_lo2 = (Do_23c - (Do_23e - Do_23e_right) + product_rest(D2_23, R_8, Do_23d, Do_23e_right)
        + D2_23 * R_8_lo)
    Do_23 = D1_23 - Do_23e
    Do_23_right = D1_23 - Do_23
    R_0_rounded = R_0 + R_0_lo
    R_1_rounded = R_1 + R_1_lo
    R_2_rounded = R_2 + R_2_lo
    Do_03_rounded = (Do_03
        + (D1_03 - (Do_03 + Do_03_right) - (Do_03e - Do_03_right)
        - (Do_03e_lo2 + (Do_03c_lo1 + (D2_03 * R_0_lo + D2_13 * R_1_lo)))))
    R_3_rounded = R_3 + R_3_lo
    R_4_rounded = R_4 + R_4_lo
    R_5_rounded = R_5 + R_5_lo
    Do_13_rounded = (Do_13
        + (D1_13 - (Do_13 + Do_13_right) - (Do_13e - Do_13_right)
        - (Do_13e_lo2 + (Do_13c_lo1 + (D2_03 * R_3_lo + D2_13 * R_4_lo)))))
    R_6_rounded = R_6 + R_6_lo
    R_7_rounded = R_7 + R_7_lo
    R_8_rounded = R_8 + R_8_lo
    Do_23_rounded = (Do_23
        + (D1_23 - (Do_23 + Do_23_right) - (Do_23e - Do_23_right)
        - (Do_23e_lo2 + (Do_23c_lo1 + (D2_03 * R_6_lo + D2_13 * R_7_lo)))))
    return (R_0_rounded, R_1_rounded, R_2_rounded, Do_03_rounded, R_3_rounded, R_4_rounded,
        R_5_rounded, Do_13_rounded, R_6_rounded, R_7_rounded, R_8_rounded, Do_23_rounded)


@kernel("(3,4),(3,4)->(3,4)")
def product_dinvd(D1, D2):
    """Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].

    (3,4),(3,4)->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m.
    45 mul, 159 add, 36 product rest.  Error <= u |result| + (R: 11, t: 18) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    p_0 = D2_03 - D1_03
    p_0_right = D2_03 - p_0
    p_0_lo = D2_03 - (p_0 + p_0_right) - (D1_03 - p_0_right)
    p_1 = D2_13 - D1_13
    p_1_right = D2_13 - p_1
    p_1_lo = D2_13 - (p_1 + p_1_right) - (D1_13 - p_1_right)
    p_2 = D2_23 - D1_23
    p_2_right = D2_23 - p_2
    p_2_lo = D2_23 - (p_2 + p_2_right) - (D1_23 - p_2_right)
    Do_00a = D1_00 * D2_00
    Do_00b = D1_10 * D2_10
    Do_00c = Do_00a + Do_00b
    Do_00c_right = Do_00c - Do_00a
    Do_00d = D1_20 * D2_20
    Do_00 = Do_00c + Do_00d
    Do_00_right = Do_00 - Do_00c
    Do_00c_lo = (product_rest(D1_00, D2_00, Do_00a, Do_00c - Do_00c_right)
        + product_rest(D1_10, D2_10, Do_00b, Do_00c_right))
    Do_01a = D1_00 * D2_01
    Do_01b = D1_10 * D2_11
    Do_01c = Do_01a + Do_01b
    Do_01c_right = Do_01c - Do_01a
    Do_01d = D1_20 * D2_21
    Do_01 = Do_01c + Do_01d
    Do_01_right = Do_01 - Do_01c
    Do_01c_lo = (product_rest(D1_00, D2_01, Do_01a, Do_01c - Do_01c_right)
        + product_rest(D1_10, D2_11, Do_01b, Do_01c_right))
    Do_02a = D1_00 * D2_02
    Do_02b = D1_10 * D2_12
    Do_02c = Do_02a + Do_02b
    Do_02c_right = Do_02c - Do_02a
    Do_02d = D1_20 * D2_22
    Do_02 = Do_02c + Do_02d
    Do_02_right = Do_02 - Do_02c
    Do_02c_lo = (product_rest(D1_00, D2_02, Do_02a, Do_02c - Do_02c_right)
        + product_rest(D1_10, D2_12, Do_02b, Do_02c_right))
    Do_03a = D1_00 * p_0
    Do_03b = D1_10 * p_1
    Do_03c = Do_03a + Do_03b
    Do_03c_right = Do_03c - Do_03a
    Do_03c_lo1 = (product_rest(D1_00, p_0, Do_03a, Do_03c - Do_03c_right)
        + product_rest(D1_10, p_1, Do_03b, Do_03c_right))
    Do_03d = D1_20 * p_2
    Do_03 = Do_03c + Do_03d
    Do_03_right = Do_03 - Do_03c
    Do_03_lo2 = (Do_03c - (Do_03 - Do_03_right) + product_rest(D1_20, p_2, Do_03d, Do_03_right)
        + D1_20 * p_2_lo)
    Do_10a = D1_01 * D2_00
    Do_10b = D1_11 * D2_10
    Do_10c = Do_10a + Do_10b
    Do_10c_right = Do_10c - Do_10a
    Do_10d = D1_21 * D2_20
    Do_10 = Do_10c + Do_10d
    Do_10_right = Do_10 - Do_10c
    Do_10c_lo = (product_rest(D1_01, D2_00, Do_10a, Do_10c - Do_10c_right)
        + product_rest(D1_11, D2_10, Do_10b, Do_10c_right))
    Do_11a = D1_01 * D2_01
    Do_11b = D1_11 * D2_11
    Do_11c = Do_11a + Do_11b
    Do_11c_right = Do_11c - Do_11a
    Do_11d = D1_21 * D2_21
    Do_11 = Do_11c + Do_11d
    Do_11_right = Do_11 - Do_11c
    Do_11c_lo = (product_rest(D1_01, D2_01, Do_11a, Do_11c - Do_11c_right)
        + product_rest(D1_11, D2_11, Do_11b, Do_11c_right))
    Do_12a = D1_01 * D2_02
    Do_12b = D1_11 * D2_12
    Do_12c = Do_12a + Do_12b
    Do_12c_right = Do_12c - Do_12a
    Do_12d = D1_21 * D2_22
    Do_12 = Do_12c + Do_12d
    Do_12_right = Do_12 - Do_12c
    Do_12c_lo = (product_rest(D1_01, D2_02, Do_12a, Do_12c - Do_12c_right)
        + product_rest(D1_11, D2_12, Do_12b, Do_12c_right))
    Do_13a = D1_01 * p_0
    Do_13b = D1_11 * p_1
    Do_13c = Do_13a + Do_13b
    Do_13c_right = Do_13c - Do_13a
    Do_13c_lo1 = (product_rest(D1_01, p_0, Do_13a, Do_13c - Do_13c_right)
        + product_rest(D1_11, p_1, Do_13b, Do_13c_right))
    Do_13d = D1_21 * p_2
    Do_13 = Do_13c + Do_13d
    Do_13_right = Do_13 - Do_13c
    Do_13_lo2 = (Do_13c - (Do_13 - Do_13_right) + product_rest(D1_21, p_2, Do_13d, Do_13_right)
        + D1_21 * p_2_lo)
    Do_20a = D1_02 * D2_00
    Do_20b = D1_12 * D2_10
    Do_20c = Do_20a + Do_20b
    Do_20c_right = Do_20c - Do_20a
    Do_20d = D1_22 * D2_20
    Do_20 = Do_20c + Do_20d
    Do_20_right = Do_20 - Do_20c
    Do_20c_lo = (product_rest(D1_02, D2_00, Do_20a, Do_20c - Do_20c_right)
        + product_rest(D1_12, D2_10, Do_20b, Do_20c_right))
    Do_21a = D1_02 * D2_01
    Do_21b = D1_12 * D2_11
    Do_21c = Do_21a + Do_21b
    Do_21c_right = Do_21c - Do_21a
    Do_21d = D1_22 * D2_21
    Do_21 = Do_21c + Do_21d
    Do_21_right = Do_21 - Do_21c
    Do_21c_lo = (product_rest(D1_02, D2_01, Do_21a, Do_21c - Do_21c_right)
        + product_rest(D1_12, D2_11, Do_21b, Do_21c_right))
    Do_22a = D1_02 * D2_02
    Do_22b = D1_12 * D2_12
    Do_22c = Do_22a + Do_22b
    Do_22c_right = Do_22c - Do_22a
    Do_22d = D1_22 * D2_22
    Do_22 = Do_22c + Do_22d
    Do_22_right = Do_22 - Do_22c
    Do_22c_lo = (product_rest(D1_02, D2_02, Do_22a, Do_22c - Do_22c_right)
        + product_rest(D1_12, D2_12, Do_22b, Do_22c_right))
    Do_23a = D1_02 * p_0
    Do_23b = D1_12 * p_1
    Do_23c = Do_23a + Do_23b
    Do_23c_right = Do_23c - Do_23a
    Do_23c_lo1 = (product_rest(D1_02, p_0, Do_23a, Do_23c - Do_23c_right)
        + product_rest(D1_12, p_1, Do_23b, Do_23c_right))
    Do_23d = D1_22 * p_2
    Do_23 = Do_23c + Do_23d
    Do_23_right = Do_23 - Do_23c
    Do_23_lo2 = (Do_23c - (Do_23 - Do_23_right) + product_rest(D1_22, p_2, Do_23d, Do_23_right)
        + D1_22 * p_2_lo)
    Do_00_rounded = (Do_00
        + (Do_00c - (Do_00 - Do_00_right) + product_rest(D1_20, D2_20, Do_00d, Do_00_right)
        + Do_00c_lo))
    Do_01_rounded = (Do_01
        + (Do_01c - (Do_01 - Do_01_right) + product_rest(D1_20, D2_21, Do_01d, Do_01_right)
        + Do_01c_lo))
    Do_02_rounded = (Do_02
        + (Do_02c - (Do_02 - Do_02_right) + product_rest(D1_20, D2_22, Do_02d, Do_02_right)
        + Do_02c_lo))
    Do_03_rounded = Do_03 + (Do_03_lo2 + (Do_03c_lo1 + (D1_00 * p_0_lo + D1_10 * p_1_lo)))
    Do_10_rounded = (Do_10
        + (Do_10c - (Do_10 - Do_10_right) + product_rest(D1_21, D2_20, Do_10d, Do_10_right)
        + Do_10c_lo))
    Do_11_rounded = (Do_11
        + (Do_11c - (Do_11 - Do_11_right) + product_rest(D1_21, D2_21, Do_11d, Do_11_right)
        + Do_11c_lo))
    Do_12_rounded = (Do_12
        + (Do_12c - (Do_12 - Do_12_right) + product_rest(D1_21, D2_22, Do_12d, Do_12_right)
        + Do_12c_lo))
    Do_13_rounded = Do_13 + (Do_13_lo2 + (Do_13c_lo1 + (D1_01 * p_0_lo + D1_11 * p_1_lo)))
    Do_20_rounded = (Do_20
        + (Do_20c - (Do_20 - Do_20_right) + product_rest(D1_22, D2_20, Do_20d, Do_20_right)
        + Do_20c_lo))
    Do_21_rounded = (Do_21
        + (Do_21c - (Do_21 - Do_21_right) + product_rest(D1_22, D2_21, Do_21d, Do_21_right)
        + Do_21c_lo))
    Do_22_rounded = (Do_22
        + (Do_22c - (Do_22 - Do_22_right) + product_rest(D1_22, D2_22, Do_22d, Do_22_right)
        + Do_22c_lo))
    Do_23_rounded = Do_23 + (Do_23_lo2 + (Do_23c_lo1 + (D1_02 * p_0_lo + D1_12 * p_1_lo)))
    return (Do_00_rounded, Do_01_rounded, Do_02_rounded, Do_03_rounded, Do_10_rounded,
        Do_11_rounded, Do_12_rounded, Do_13_rounded, Do_20_rounded, Do_21_rounded, Do_22_rounded,
        Do_23_rounded)


@kernel("(3,4),(3,3)->(3,4)")
def product_ddr(D, R):
    """Do = D [R | 0].

    (3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other
    3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + (R: 11, t: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    Do_00a = D_00 * R_00
    Do_00b = D_01 * R_10
    Do_00c = Do_00a + Do_00b
    Do_00c_right = Do_00c - Do_00a
    Do_00d = D_02 * R_20
    Do_00 = Do_00c + Do_00d
    Do_00_right = Do_00 - Do_00c
    Do_00c_lo = (product_rest(D_00, R_00, Do_00a, Do_00c - Do_00c_right)
        + product_rest(D_01, R_10, Do_00b, Do_00c_right))
    Do_01a = D_00 * R_01
    Do_01b = D_01 * R_11
    Do_01c = Do_01a + Do_01b
    Do_01c_right = Do_01c - Do_01a
    Do_01d = D_02 * R_21
    Do_01 = Do_01c + Do_01d
    Do_01_right = Do_01 - Do_01c
    Do_01c_lo = (product_rest(D_00, R_01, Do_01a, Do_01c - Do_01c_right)
        + product_rest(D_01, R_11, Do_01b, Do_01c_right))
    Do_02a = D_00 * R_02
    Do_02b = D_01 * R_12
    Do_02c = Do_02a + Do_02b
    Do_02c_right = Do_02c - Do_02a
    Do_02d = D_02 * R_22
    Do_02 = Do_02c + Do_02d
    Do_02_right = Do_02 - Do_02c
    Do_02c_lo = (product_rest(D_00, R_02, Do_02a, Do_02c - Do_02c_right)
        + product_rest(D_01, R_12, Do_02b, Do_02c_right))
    Do_10a = D_10 * R_00
    Do_10b = D_11 * R_10
    Do_10c = Do_10a + Do_10b
    Do_10c_right = Do_10c - Do_10a
    Do_10d = D_12 * R_20
    Do_10 = Do_10c + Do_10d
    Do_10_right = Do_10 - Do_10c
    Do_10c_lo = (product_rest(D_10, R_00, Do_10a, Do_10c - Do_10c_right)
        + product_rest(D_11, R_10, Do_10b, Do_10c_right))
    Do_11a = D_10 * R_01
    Do_11b = D_11 * R_11
    Do_11c = Do_11a + Do_11b
    Do_11c_right = Do_11c - Do_11a
    Do_11d = D_12 * R_21
    Do_11 = Do_11c + Do_11d
    Do_11_right = Do_11 - Do_11c
    Do_11c_lo = (product_rest(D_10, R_01, Do_11a, Do_11c - Do_11c_right)
        + product_rest(D_11, R_11, Do_11b, Do_11c_right))
    Do_12a = D_10 * R_02
    Do_12b = D_11 * R_12
    Do_12c = Do_12a + Do_12b
    Do_12c_right = Do_12c - Do_12a
    Do_12d = D_12 * R_22
    Do_12 = Do_12c + Do_12d
    Do_12_right = Do_12 - Do_12c
    Do_12c_lo = (product_rest(D_10, R_02, Do_12a, Do_12c - Do_12c_right)
        + product_rest(D_11, R_12, Do_12b, Do_12c_right))
    Do_20a = D_20 * R_00
    Do_20b = D_21 * R_10
    Do_20c = Do_20a + Do_20b
    Do_20c_right = Do_20c - Do_20a
    Do_20d = D_22 * R_20
    Do_20 = Do_20c + Do_20d
    Do_20_right = Do_20 - Do_20c
    Do_20c_lo = (product_rest(D_20, R_00, Do_20a, Do_20c - Do_20c_right)
        + product_rest(D_21, R_10, Do_20b, Do_20c_right))
    Do_21a = D_20 * R_01
    Do_21b = D_21 * R_11
    Do_21c = Do_21a + Do_21b
    Do_21c_right = Do_21c - Do_21a
    Do_21d = D_22 * R_21
    Do_21 = Do_21c + Do_21d
    Do_21_right = Do_21 - Do_21c
    Do_21c_lo = (product_rest(D_20, R_01, Do_21a, Do_21c - Do_21c_right)
        + product_rest(D_21, R_11, Do_21b, Do_21c_right))
    Do_22a = D_20 * R_02
    Do_22b = D_21 * R_12
    Do_22c = Do_22a + Do_22b
    Do_22c_right = Do_22c - Do_22a
    Do_22d = D_22 * R_22
    Do_22 = Do_22c + Do_22d
    Do_22_right = Do_22 - Do_22c
    Do_22c_lo = (product_rest(D_20, R_02, Do_22a, Do_22c - Do_22c_right)
        + product_rest(D_21, R_12, Do_22b, Do_22c_right))
    Do_00_rounded = (Do_00
        + (Do_00c - (Do_00 - Do_00_right) + product_rest(D_02, R_20, Do_00d, Do_00_right)
        + Do_00c_lo))
    Do_01_rounded = (Do_01
        + (Do_01c - (Do_01 - Do_01_right) + product_rest(D_02, R_21, Do_01d, Do_01_right)
        + Do_01c_lo))
    Do_02_rounded = (Do_02
        + (Do_02c - (Do_02 - Do_02_right) + product_rest(D_02, R_22, Do_02d, Do_02_right)
        + Do_02c_lo))
    Do_10_rounded = (Do_10
        + (Do_10c - (Do_10 - Do_10_right) + product_rest(D_12, R_20, Do_10d, Do_10_right)
        + Do_10c_lo))
    Do_11_rounded = (Do_11
        + (Do_11c - (Do_11 - Do_11_right) + product_rest(D_12, R_21, Do_11d, Do_11_right)
        + Do_11c_lo))
    Do_12_rounded = (Do_12
        + (Do_12c - (Do_12 - Do_12_right) + product_rest(D_12, R_22, Do_12d, Do_12_right)
        + Do_12c_lo))
    Do_20_rounded = (Do_20
        + (Do_20c - (Do_20 - Do_20_right) + product_rest(D_22, R_20, Do_20d, Do_20_right)
        + Do_20c_lo))
    Do_21_rounded = (Do_21
        + (Do_21c - (Do_21 - Do_21_right) + product_rest(D_22, R_21, Do_21d, Do_21_right)
        + Do_21c_lo))
    Do_22_rounded = (Do_22
        + (Do_22c - (Do_22 - Do_22_right) + product_rest(D_22, R_22, Do_22d, Do_22_right)
        + Do_22c_lo))
    return (Do_00_rounded, Do_01_rounded, Do_02_rounded, D_03, Do_10_rounded, Do_11_rounded,
        Do_12_rounded, D_13, Do_20_rounded, Do_21_rounded, Do_22_rounded, D_23)


@kernel("(3,4),(3,3)->(3,4)")
def product_ddrinv(D, R):
    """Do = D [R^T | 0].

    (3,4),(3,3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; R: rotation or other
    3×3 matrix.
    27 mul, 99 add, 27 product rest.  Error <= u |result| + (R: 11, t: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    Do_00a = D_00 * R_00
    Do_00b = D_01 * R_01
    Do_00c = Do_00a + Do_00b
    Do_00c_right = Do_00c - Do_00a
    Do_00d = D_02 * R_02
    Do_00 = Do_00c + Do_00d
    Do_00_right = Do_00 - Do_00c
    Do_00c_lo = (product_rest(D_00, R_00, Do_00a, Do_00c - Do_00c_right)
        + product_rest(D_01, R_01, Do_00b, Do_00c_right))
    Do_01a = D_00 * R_10
    Do_01b = D_01 * R_11
    Do_01c = Do_01a + Do_01b
    Do_01c_right = Do_01c - Do_01a
    Do_01d = D_02 * R_12
    Do_01 = Do_01c + Do_01d
    Do_01_right = Do_01 - Do_01c
    Do_01c_lo = (product_rest(D_00, R_10, Do_01a, Do_01c - Do_01c_right)
        + product_rest(D_01, R_11, Do_01b, Do_01c_right))
    Do_02a = D_00 * R_20
    Do_02b = D_01 * R_21
    Do_02c = Do_02a + Do_02b
    Do_02c_right = Do_02c - Do_02a
    Do_02d = D_02 * R_22
    Do_02 = Do_02c + Do_02d
    Do_02_right = Do_02 - Do_02c
    Do_02c_lo = (product_rest(D_00, R_20, Do_02a, Do_02c - Do_02c_right)
        + product_rest(D_01, R_21, Do_02b, Do_02c_right))
    Do_10a = D_10 * R_00
    Do_10b = D_11 * R_01
    Do_10c = Do_10a + Do_10b
    Do_10c_right = Do_10c - Do_10a
    Do_10d = D_12 * R_02
    Do_10 = Do_10c + Do_10d
    Do_10_right = Do_10 - Do_10c
    Do_10c_lo = (product_rest(D_10, R_00, Do_10a, Do_10c - Do_10c_right)
        + product_rest(D_11, R_01, Do_10b, Do_10c_right))
    Do_11a = D_10 * R_10
    Do_11b = D_11 * R_11
    Do_11c = Do_11a + Do_11b
    Do_11c_right = Do_11c - Do_11a
    Do_11d = D_12 * R_12
    Do_11 = Do_11c + Do_11d
    Do_11_right = Do_11 - Do_11c
    Do_11c_lo = (product_rest(D_10, R_10, Do_11a, Do_11c - Do_11c_right)
        + product_rest(D_11, R_11, Do_11b, Do_11c_right))
    Do_12a = D_10 * R_20
    Do_12b = D_11 * R_21
    Do_12c = Do_12a + Do_12b
    Do_12c_right = Do_12c - Do_12a
    Do_12d = D_12 * R_22
    Do_12 = Do_12c + Do_12d
    Do_12_right = Do_12 - Do_12c
    Do_12c_lo = (product_rest(D_10, R_20, Do_12a, Do_12c - Do_12c_right)
        + product_rest(D_11, R_21, Do_12b, Do_12c_right))
    Do_20a = D_20 * R_00
    Do_20b = D_21 * R_01
    Do_20c = Do_20a + Do_20b
    Do_20c_right = Do_20c - Do_20a
    Do_20d = D_22 * R_02
    Do_20 = Do_20c + Do_20d
    Do_20_right = Do_20 - Do_20c
    Do_20c_lo = (product_rest(D_20, R_00, Do_20a, Do_20c - Do_20c_right)
        + product_rest(D_21, R_01, Do_20b, Do_20c_right))
    Do_21a = D_20 * R_10
    Do_21b = D_21 * R_11
    Do_21c = Do_21a + Do_21b
    Do_21c_right = Do_21c - Do_21a
    Do_21d = D_22 * R_12
    Do_21 = Do_21c + Do_21d
    Do_21_right = Do_21 - Do_21c
    Do_21c_lo = (product_rest(D_20, R_10, Do_21a, Do_21c - Do_21c_right)
        + product_rest(D_21, R_11, Do_21b, Do_21c_right))
    Do_22a = D_20 * R_20
    Do_22b = D_21 * R_21
    Do_22c = Do_22a + Do_22b
    Do_22c_right = Do_22c - Do_22a
    Do_22d = D_22 * R_22
    Do_22 = Do_22c + Do_22d
    Do_22_right = Do_22 - Do_22c
    Do_22c_lo = (product_rest(D_20, R_20, Do_22a, Do_22c - Do_22c_right)
        + product_rest(D_21, R_21, Do_22b, Do_22c_right))
    Do_00_rounded = (Do_00
        + (Do_00c - (Do_00 - Do_00_right) + product_rest(D_02, R_02, Do_00d, Do_00_right)
        + Do_00c_lo))
    Do_01_rounded = (Do_01
        + (Do_01c - (Do_01 - Do_01_right) + product_rest(D_02, R_12, Do_01d, Do_01_right)
        + Do_01c_lo))
    Do_02_rounded = (Do_02
        + (Do_02c - (Do_02 - Do_02_right) + product_rest(D_02, R_22, Do_02d, Do_02_right)
        + Do_02c_lo))
    Do_10_rounded = (Do_10
        + (Do_10c - (Do_10 - Do_10_right) + product_rest(D_12, R_02, Do_10d, Do_10_right)
        + Do_10c_lo))
    Do_11_rounded = (Do_11
        + (Do_11c - (Do_11 - Do_11_right) + product_rest(D_12, R_12, Do_11d, Do_11_right)
        + Do_11c_lo))
    Do_12_rounded = (Do_12
        + (Do_12c - (Do_12 - Do_12_right) + product_rest(D_12, R_22, Do_12d, Do_12_right)
        + Do_12c_lo))
    Do_20_rounded = (Do_20
        + (Do_20c - (Do_20 - Do_20_right) + product_rest(D_22, R_02, Do_20d, Do_20_right)
        + Do_20c_lo))
    Do_21_rounded = (Do_21
        + (Do_21c - (Do_21 - Do_21_right) + product_rest(D_22, R_12, Do_21d, Do_21_right)
        + Do_21c_lo))
    Do_22_rounded = (Do_22
        + (Do_22c - (Do_22 - Do_22_right) + product_rest(D_22, R_22, Do_22d, Do_22_right)
        + Do_22c_lo))
    return (Do_00_rounded, Do_01_rounded, Do_02_rounded, D_03, Do_10_rounded, Do_11_rounded,
        Do_12_rounded, D_13, Do_20_rounded, Do_21_rounded, Do_22_rounded, D_23)


@kernel("(3,4),(3)->(3,4)")
def product_ddt(D, t):
    """Do = D [I | t].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 54 add, 9 product rest.  Error <= u |result| + (R: 0, t: 15) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    t_0, t_1, t_2 = t
    Do_03a = D_00 * t_0
    Do_03b = D_01 * t_1
    Do_03c = Do_03a + Do_03b
    Do_03c_right = Do_03c - Do_03a
    Do_03d = D_02 * t_2
    Do_03e = Do_03c + Do_03d
    Do_03e_right = Do_03e - Do_03c
    Do_03c_lo = (product_rest(D_00, t_0, Do_03a, Do_03c - Do_03c_right)
        + product_rest(D_01, t_1, Do_03b, Do_03c_right))
    Do_03 = Do_03e + D_03
    Do_03_right = Do_03 - Do_03e
    Do_03e_lo = (Do_03c - (Do_03e - Do_03e_right) + product_rest(D_02, t_2, Do_03d, Do_03e_right)
        + Do_03c_lo)
    Do_13a = D_10 * t_0
    Do_13b = D_11 * t_1
    Do_13c = Do_13a + Do_13b
    Do_13c_right = Do_13c - Do_13a
    Do_13d = D_12 * t_2
    Do_13e = Do_13c + Do_13d
    Do_13e_right = Do_13e - Do_13c
    Do_13c_lo = (product_rest(D_10, t_0, Do_13a, Do_13c - Do_13c_right)
        + product_rest(D_11, t_1, Do_13b, Do_13c_right))
    Do_13 = Do_13e + D_13
    Do_13_right = Do_13 - Do_13e
    Do_13e_lo = (Do_13c - (Do_13e - Do_13e_right) + product_rest(D_12, t_2, Do_13d, Do_13e_right)
        + Do_13c_lo)
    Do_23a = D_20 * t_0
    Do_23b = D_21 * t_1
    Do_23c = Do_23a + Do_23b
    Do_23c_right = Do_23c - Do_23a
    Do_23d = D_22 * t_2
    Do_23e = Do_23c + Do_23d
    Do_23e_right = Do_23e - Do_23c
    Do_23c_lo = (product_rest(D_20, t_0, Do_23a, Do_23c - Do_23c_right)
        + product_rest(D_21, t_1, Do_23b, Do_23c_right))
    Do_23 = Do_23e + D_23
    Do_23_right = Do_23 - Do_23e
    Do_23e_lo = (Do_23c - (Do_23e - Do_23e_right) + product_rest(D_22, t_2, Do_23d, Do_23e_right)
        + Do_23c_lo)
    Do_03_rounded = Do_03 + (Do_03e - (Do_03 - Do_03_right) + (D_03 - Do_03_right) + Do_03e_lo)
    Do_13_rounded = Do_13 + (Do_13e - (Do_13 - Do_13_right) + (D_13 - Do_13_right) + Do_13e_lo)
    Do_23_rounded = Do_23 + (Do_23e - (Do_23 - Do_23_right) + (D_23 - Do_23_right) + Do_23e_lo)
    return (D_00, D_01, D_02, Do_03_rounded, D_10, D_11, D_12, Do_13_rounded, D_20, D_21, D_22,
        Do_23_rounded)


@kernel("(3,4),(3)->(3,4)")
def product_ddtinv(D, t):
    """Do = D [I | -t].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    9 mul, 54 add, 9 product rest.  Error <= u |result| + (R: 0, t: 15) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    t_0, t_1, t_2 = t
    Do_03a = D_00 * t_0
    Do_03b = D_01 * t_1
    Do_03c = Do_03a + Do_03b
    Do_03c_right = Do_03c - Do_03a
    Do_03d = D_02 * t_2
    Do_03e = Do_03c + Do_03d
    Do_03e_right = Do_03e - Do_03c
    Do_03c_lo = (product_rest(D_00, t_0, Do_03a, Do_03c - Do_03c_right)
        + product_rest(D_01, t_1, Do_03b, Do_03c_right))
    Do_03 = D_03 - Do_03e
    Do_03_right = D_03 - Do_03
    Do_03e_lo = (Do_03c - (Do_03e - Do_03e_right) + product_rest(D_02, t_2, Do_03d, Do_03e_right)
        + Do_03c_lo)
    Do_13a = D_10 * t_0
    Do_13b = D_11 * t_1
    Do_13c = Do_13a + Do_13b
    Do_13c_right = Do_13c - Do_13a
    Do_13d = D_12 * t_2
    Do_13e = Do_13c + Do_13d
    Do_13e_right = Do_13e - Do_13c
    Do_13c_lo = (product_rest(D_10, t_0, Do_13a, Do_13c - Do_13c_right)
        + product_rest(D_11, t_1, Do_13b, Do_13c_right))
    Do_13 = D_13 - Do_13e
    Do_13_right = D_13 - Do_13
    Do_13e_lo = (Do_13c - (Do_13e - Do_13e_right) + product_rest(D_12, t_2, Do_13d, Do_13e_right)
        + Do_13c_lo)
    Do_23a = D_20 * t_0
    Do_23b = D_21 * t_1
    Do_23c = Do_23a + Do_23b
    Do_23c_right = Do_23c - Do_23a
    Do_23d = D_22 * t_2
    Do_23e = Do_23c + Do_23d
    Do_23e_right = Do_23e - Do_23c
    Do_23c_lo = (product_rest(D_20, t_0, Do_23a, Do_23c - Do_23c_right)
        + product_rest(D_21, t_1, Do_23b, Do_23c_right))
    Do_23 = D_23 - Do_23e
    Do_23_right = D_23 - Do_23
    Do_23e_lo = (Do_23c - (Do_23e - Do_23e_right) + product_rest(D_22, t_2, Do_23d, Do_23e_right)
        + Do_23c_lo)
    Do_03_rounded = Do_03 + (D_03 - (Do_03 + Do_03_right) - (Do_03e - Do_03_right) - Do_03e_lo)
    Do_13_rounded = Do_13 + (D_13 - (Do_13 + Do_13_right) - (Do_13e - Do_13_right) - Do_13e_lo)
    Do_23_rounded = Do_23 + (D_23 - (Do_23 + Do_23_right) - (Do_23e - Do_23_right) - Do_23e_lo)
    return (D_00, D_01, D_02, Do_03_rounded, D_10, D_11, D_12, Do_13_rounded, D_20, D_21, D_22,
        Do_23_rounded)


@kernel("(3,4),(3)->(3,4)")
def product_dinvdt(D, t):
    """Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].

    (3,4),(3)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; t: vector.
    18 mul, 60 add, 9 product rest.  Error <= u |result| + (R: 0, t: 18) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    t_0, t_1, t_2 = t
    p_0 = t_0 - D_03
    p_0_right = t_0 - p_0
    p_0_lo = t_0 - (p_0 + p_0_right) - (D_03 - p_0_right)
    p_1 = t_1 - D_13
    p_1_right = t_1 - p_1
    p_1_lo = t_1 - (p_1 + p_1_right) - (D_13 - p_1_right)
    p_2 = t_2 - D_23
    p_2_right = t_2 - p_2
    p_2_lo = t_2 - (p_2 + p_2_right) - (D_23 - p_2_right)
    Do_03a = D_00 * p_0
    Do_03b = D_10 * p_1
    Do_03c = Do_03a + Do_03b
    Do_03c_right = Do_03c - Do_03a
    Do_03d = D_20 * p_2
    Do_03 = Do_03c + Do_03d
    Do_03_right = Do_03 - Do_03c
    Do_03c_lo = (product_rest(D_00, p_0, Do_03a, Do_03c - Do_03c_right)
        + product_rest(D_10, p_1, Do_03b, Do_03c_right) + (D_00 * p_0_lo + D_10 * p_1_lo))
    Do_13a = D_01 * p_0
    Do_13b = D_11 * p_1
    Do_13c = Do_13a + Do_13b
    Do_13c_right = Do_13c - Do_13a
    Do_13d = D_21 * p_2
    Do_13 = Do_13c + Do_13d
    Do_13_right = Do_13 - Do_13c
    Do_13c_lo = (product_rest(D_01, p_0, Do_13a, Do_13c - Do_13c_right)
        + product_rest(D_11, p_1, Do_13b, Do_13c_right) + (D_01 * p_0_lo + D_11 * p_1_lo))
    Do_23a = D_02 * p_0
    Do_23b = D_12 * p_1
    Do_23c = Do_23a + Do_23b
    Do_23c_right = Do_23c - Do_23a
    Do_23d = D_22 * p_2
    Do_23 = Do_23c + Do_23d
    Do_23_right = Do_23 - Do_23c
    Do_23c_lo = (product_rest(D_02, p_0, Do_23a, Do_23c - Do_23c_right)
        + product_rest(D_12, p_1, Do_23b, Do_23c_right) + (D_02 * p_0_lo + D_12 * p_1_lo))
    Do_03_rounded = (Do_03
        + (Do_03c - (Do_03 - Do_03_right) + product_rest(D_20, p_2, Do_03d, Do_03_right) + D_20
        * p_2_lo + Do_03c_lo))
    Do_13_rounded = (Do_13
        + (Do_13c - (Do_13 - Do_13_right) + product_rest(D_21, p_2, Do_13d, Do_13_right) + D_21
        * p_2_lo + Do_13c_lo))
    Do_23_rounded = (Do_23
        + (Do_23c - (Do_23 - Do_23_right) + product_rest(D_22, p_2, Do_23d, Do_23_right) + D_22
        * p_2_lo + Do_23c_lo))
    return (D_00, D_10, D_20, Do_03_rounded, D_01, D_11, D_21, Do_13_rounded, D_02, D_12, D_22,
        Do_23_rounded)


@kernel("(3,3),()->(3)")
def product_drvtx(R, k):
    """vo = R (k e_x).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = R_00 * k
    vo_1 = R_10 * k
    vo_2 = R_20 * k
    vo_0_rounded = vo_0 + product_error(R_00, k, vo_0)
    vo_1_rounded = vo_1 + product_error(R_10, k, vo_1)
    vo_2_rounded = vo_2 + product_error(R_20, k, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(2)->(3,3)")
def product_drdrx(R, dc):
    """Ro = R R_x(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_01a = R_01 * dc_1
    Ro_01b = R_02 * dc_0
    Ro_01 = Ro_01a + Ro_01b
    Ro_01_right = Ro_01 - Ro_01a
    Ro_02a = R_02 * dc_1
    Ro_02b = R_01 * dc_0
    Ro_02 = Ro_02a - Ro_02b
    Ro_02_right = Ro_02a - Ro_02
    Ro_11a = R_11 * dc_1
    Ro_11b = R_12 * dc_0
    Ro_11 = Ro_11a + Ro_11b
    Ro_11_right = Ro_11 - Ro_11a
    Ro_12a = R_12 * dc_1
    Ro_12b = R_11 * dc_0
    Ro_12 = Ro_12a - Ro_12b
    Ro_12_right = Ro_12a - Ro_12
    Ro_21a = R_21 * dc_1
    Ro_21b = R_22 * dc_0
    Ro_21 = Ro_21a + Ro_21b
    Ro_21_right = Ro_21 - Ro_21a
    Ro_22a = R_22 * dc_1
    Ro_22b = R_21 * dc_0
    Ro_22 = Ro_22a - Ro_22b
    Ro_22_right = Ro_22a - Ro_22
    Ro_01_rounded = (Ro_01
        + (product_rest(R_01, dc_1, Ro_01a, Ro_01 - Ro_01_right)
        + product_rest(R_02, dc_0, Ro_01b, Ro_01_right)))
    Ro_02_rounded = (Ro_02
        + (product_rest(R_02, dc_1, Ro_02a, Ro_02 + Ro_02_right)
        - product_rest(R_01, dc_0, Ro_02b, Ro_02_right)))
    Ro_11_rounded = (Ro_11
        + (product_rest(R_11, dc_1, Ro_11a, Ro_11 - Ro_11_right)
        + product_rest(R_12, dc_0, Ro_11b, Ro_11_right)))
    Ro_12_rounded = (Ro_12
        + (product_rest(R_12, dc_1, Ro_12a, Ro_12 + Ro_12_right)
        - product_rest(R_11, dc_0, Ro_12b, Ro_12_right)))
    Ro_21_rounded = (Ro_21
        + (product_rest(R_21, dc_1, Ro_21a, Ro_21 - Ro_21_right)
        + product_rest(R_22, dc_0, Ro_21b, Ro_21_right)))
    Ro_22_rounded = (Ro_22
        + (product_rest(R_22, dc_1, Ro_22a, Ro_22 + Ro_22_right)
        - product_rest(R_21, dc_0, Ro_22b, Ro_22_right)))
    return (R_00, Ro_01_rounded, Ro_02_rounded, R_10, Ro_11_rounded, Ro_12_rounded, R_20,
        Ro_21_rounded, Ro_22_rounded)


@kernel("(3,4),(2)->(3,4)")
def product_ddrx(D, dc):
    """Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_01a = D_01 * dc_1
    Do_01b = D_02 * dc_0
    Do_01 = Do_01a + Do_01b
    Do_01_right = Do_01 - Do_01a
    Do_02a = D_02 * dc_1
    Do_02b = D_01 * dc_0
    Do_02 = Do_02a - Do_02b
    Do_02_right = Do_02a - Do_02
    Do_11a = D_11 * dc_1
    Do_11b = D_12 * dc_0
    Do_11 = Do_11a + Do_11b
    Do_11_right = Do_11 - Do_11a
    Do_12a = D_12 * dc_1
    Do_12b = D_11 * dc_0
    Do_12 = Do_12a - Do_12b
    Do_12_right = Do_12a - Do_12
    Do_21a = D_21 * dc_1
    Do_21b = D_22 * dc_0
    Do_21 = Do_21a + Do_21b
    Do_21_right = Do_21 - Do_21a
    Do_22a = D_22 * dc_1
    Do_22b = D_21 * dc_0
    Do_22 = Do_22a - Do_22b
    Do_22_right = Do_22a - Do_22
    Do_01_rounded = (Do_01
        + (product_rest(D_01, dc_1, Do_01a, Do_01 - Do_01_right)
        + product_rest(D_02, dc_0, Do_01b, Do_01_right)))
    Do_02_rounded = (Do_02
        + (product_rest(D_02, dc_1, Do_02a, Do_02 + Do_02_right)
        - product_rest(D_01, dc_0, Do_02b, Do_02_right)))
    Do_11_rounded = (Do_11
        + (product_rest(D_11, dc_1, Do_11a, Do_11 - Do_11_right)
        + product_rest(D_12, dc_0, Do_11b, Do_11_right)))
    Do_12_rounded = (Do_12
        + (product_rest(D_12, dc_1, Do_12a, Do_12 + Do_12_right)
        - product_rest(D_11, dc_0, Do_12b, Do_12_right)))
    Do_21_rounded = (Do_21
        + (product_rest(D_21, dc_1, Do_21a, Do_21 - Do_21_right)
        + product_rest(D_22, dc_0, Do_21b, Do_21_right)))
    Do_22_rounded = (Do_22
        + (product_rest(D_22, dc_1, Do_22a, Do_22 + Do_22_right)
        - product_rest(D_21, dc_0, Do_22b, Do_22_right)))
    return (D_00, Do_01_rounded, Do_02_rounded, D_03, D_10, Do_11_rounded, Do_12_rounded, D_13,
        D_20, Do_21_rounded, Do_22_rounded, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtx(D, k):
    """Do = D [I | k e_x].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_00 * k
    Do_03 = Do_03a + D_03
    Do_03_right = Do_03 - Do_03a
    Do_13a = D_10 * k
    Do_13 = Do_13a + D_13
    Do_13_right = Do_13 - Do_13a
    Do_23a = D_20 * k
    Do_23 = Do_23a + D_23
    Do_23_right = Do_23 - Do_23a
    Do_03_rounded = (Do_03
        + (product_rest(D_00, k, Do_03a, Do_03 - Do_03_right) + (D_03 - Do_03_right)))
    Do_13_rounded = (Do_13
        + (product_rest(D_10, k, Do_13a, Do_13 - Do_13_right) + (D_13 - Do_13_right)))
    Do_23_rounded = (Do_23
        + (product_rest(D_20, k, Do_23a, Do_23 - Do_23_right) + (D_23 - Do_23_right)))
    return (D_00, D_01, D_02, Do_03_rounded, D_10, D_11, D_12, Do_13_rounded, D_20, D_21, D_22,
        Do_23_rounded)


@kernel("(3,3),()->(3)")
def product_drvtxinv(R, k):
    """vo = R (-k e_x).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = -(R_00 * k)
    vo_1 = -(R_10 * k)
    vo_2 = -(R_20 * k)
    vo_0_rounded = vo_0 + product_error(-R_00, k, vo_0)
    vo_1_rounded = vo_1 + product_error(-R_10, k, vo_1)
    vo_2_rounded = vo_2 + product_error(-R_20, k, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(2)->(3,3)")
def product_drdrxinv(R, dc):
    """Ro = R R_x(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_01a = R_01 * dc_1
    Ro_01b = R_02 * dc_0
    Ro_01 = Ro_01a - Ro_01b
    Ro_01_right = Ro_01a - Ro_01
    Ro_02a = R_01 * dc_0
    Ro_02b = R_02 * dc_1
    Ro_02 = Ro_02a + Ro_02b
    Ro_02_right = Ro_02 - Ro_02a
    Ro_11a = R_11 * dc_1
    Ro_11b = R_12 * dc_0
    Ro_11 = Ro_11a - Ro_11b
    Ro_11_right = Ro_11a - Ro_11
    Ro_12a = R_11 * dc_0
    Ro_12b = R_12 * dc_1
    Ro_12 = Ro_12a + Ro_12b
    Ro_12_right = Ro_12 - Ro_12a
    Ro_21a = R_21 * dc_1
    Ro_21b = R_22 * dc_0
    Ro_21 = Ro_21a - Ro_21b
    Ro_21_right = Ro_21a - Ro_21
    Ro_22a = R_21 * dc_0
    Ro_22b = R_22 * dc_1
    Ro_22 = Ro_22a + Ro_22b
    Ro_22_right = Ro_22 - Ro_22a
    Ro_01_rounded = (Ro_01
        + (product_rest(R_01, dc_1, Ro_01a, Ro_01 + Ro_01_right)
        - product_rest(R_02, dc_0, Ro_01b, Ro_01_right)))
    Ro_02_rounded = (Ro_02
        + (product_rest(R_01, dc_0, Ro_02a, Ro_02 - Ro_02_right)
        + product_rest(R_02, dc_1, Ro_02b, Ro_02_right)))
    Ro_11_rounded = (Ro_11
        + (product_rest(R_11, dc_1, Ro_11a, Ro_11 + Ro_11_right)
        - product_rest(R_12, dc_0, Ro_11b, Ro_11_right)))
    Ro_12_rounded = (Ro_12
        + (product_rest(R_11, dc_0, Ro_12a, Ro_12 - Ro_12_right)
        + product_rest(R_12, dc_1, Ro_12b, Ro_12_right)))
    Ro_21_rounded = (Ro_21
        + (product_rest(R_21, dc_1, Ro_21a, Ro_21 + Ro_21_right)
        - product_rest(R_22, dc_0, Ro_21b, Ro_21_right)))
    Ro_22_rounded = (Ro_22
        + (product_rest(R_21, dc_0, Ro_22a, Ro_22 - Ro_22_right)
        + product_rest(R_22, dc_1, Ro_22b, Ro_22_right)))
    return (R_00, Ro_01_rounded, Ro_02_rounded, R_10, Ro_11_rounded, Ro_12_rounded, R_20,
        Ro_21_rounded, Ro_22_rounded)


@kernel("(3,4),(2)->(3,4)")
def product_ddrxinv(D, dc):
    """Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_01a = D_01 * dc_1
    Do_01b = D_02 * dc_0
    Do_01 = Do_01a - Do_01b
    Do_01_right = Do_01a - Do_01
    Do_02a = D_01 * dc_0
    Do_02b = D_02 * dc_1
    Do_02 = Do_02a + Do_02b
    Do_02_right = Do_02 - Do_02a
    Do_11a = D_11 * dc_1
    Do_11b = D_12 * dc_0
    Do_11 = Do_11a - Do_11b
    Do_11_right = Do_11a - Do_11
    Do_12a = D_11 * dc_0
    Do_12b = D_12 * dc_1
    Do_12 = Do_12a + Do_12b
    Do_12_right = Do_12 - Do_12a
    Do_21a = D_21 * dc_1
    Do_21b = D_22 * dc_0
    Do_21 = Do_21a - Do_21b
    Do_21_right = Do_21a - Do_21
    Do_22a = D_21 * dc_0
    Do_22b = D_22 * dc_1
    Do_22 = Do_22a + Do_22b
    Do_22_right = Do_22 - Do_22a
    Do_01_rounded = (Do_01
        + (product_rest(D_01, dc_1, Do_01a, Do_01 + Do_01_right)
        - product_rest(D_02, dc_0, Do_01b, Do_01_right)))
    Do_02_rounded = (Do_02
        + (product_rest(D_01, dc_0, Do_02a, Do_02 - Do_02_right)
        + product_rest(D_02, dc_1, Do_02b, Do_02_right)))
    Do_11_rounded = (Do_11
        + (product_rest(D_11, dc_1, Do_11a, Do_11 + Do_11_right)
        - product_rest(D_12, dc_0, Do_11b, Do_11_right)))
    Do_12_rounded = (Do_12
        + (product_rest(D_11, dc_0, Do_12a, Do_12 - Do_12_right)
        + product_rest(D_12, dc_1, Do_12b, Do_12_right)))
    Do_21_rounded = (Do_21
        + (product_rest(D_21, dc_1, Do_21a, Do_21 + Do_21_right)
        - product_rest(D_22, dc_0, Do_21b, Do_21_right)))
    Do_22_rounded = (Do_22
        + (product_rest(D_21, dc_0, Do_22a, Do_22 - Do_22_right)
        + product_rest(D_22, dc_1, Do_22b, Do_22_right)))
    return (D_00, Do_01_rounded, Do_02_rounded, D_03, D_10, Do_11_rounded, Do_12_rounded, D_13,
        D_20, Do_21_rounded, Do_22_rounded, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtxinv(D, k):
    """Do = D [I | -k e_x].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_00 * k
    Do_03 = D_03 - Do_03a
    Do_03_right = D_03 - Do_03
    Do_13a = D_10 * k
    Do_13 = D_13 - Do_13a
    Do_13_right = D_13 - Do_13
    Do_23a = D_20 * k
    Do_23 = D_23 - Do_23a
    Do_23_right = D_23 - Do_23
    Do_03_rounded = (Do_03
        + (D_03 - (Do_03 + Do_03_right) - product_rest(D_00, k, Do_03a, Do_03_right)))
    Do_13_rounded = (Do_13
        + (D_13 - (Do_13 + Do_13_right) - product_rest(D_10, k, Do_13a, Do_13_right)))
    Do_23_rounded = (Do_23
        + (D_23 - (Do_23 + Do_23_right) - product_rest(D_20, k, Do_23a, Do_23_right)))
    return (D_00, D_01, D_02, Do_03_rounded, D_10, D_11, D_12, Do_13_rounded, D_20, D_21, D_22,
        Do_23_rounded)


@kernel("(3,3),()->(3)")
def product_drvty(R, k):
    """vo = R (k e_y).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = R_01 * k
    vo_1 = R_11 * k
    vo_2 = R_21 * k
    vo_0_rounded = vo_0 + product_error(R_01, k, vo_0)
    vo_1_rounded = vo_1 + product_error(R_11, k, vo_1)
    vo_2_rounded = vo_2 + product_error(R_21, k, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(2)->(3,3)")
def product_drdry(R, dc):
    """Ro = R R_y(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00a = R_00 * dc_1
    Ro_00b = R_02 * dc_0
    Ro_00 = Ro_00a - Ro_00b
    Ro_00_right = Ro_00a - Ro_00
    Ro_02a = R_00 * dc_0
    Ro_02b = R_02 * dc_1
    Ro_02 = Ro_02a + Ro_02b
    Ro_02_right = Ro_02 - Ro_02a
    Ro_10a = R_10 * dc_1
    Ro_10b = R_12 * dc_0
    Ro_10 = Ro_10a - Ro_10b
    Ro_10_right = Ro_10a - Ro_10
    Ro_12a = R_10 * dc_0
    Ro_12b = R_12 * dc_1
    Ro_12 = Ro_12a + Ro_12b
    Ro_12_right = Ro_12 - Ro_12a
    Ro_20a = R_20 * dc_1
    Ro_20b = R_22 * dc_0
    Ro_20 = Ro_20a - Ro_20b
    Ro_20_right = Ro_20a - Ro_20
    Ro_22a = R_20 * dc_0
    Ro_22b = R_22 * dc_1
    Ro_22 = Ro_22a + Ro_22b
    Ro_22_right = Ro_22 - Ro_22a
    Ro_00_rounded = (Ro_00
        + (product_rest(R_00, dc_1, Ro_00a, Ro_00 + Ro_00_right)
        - product_rest(R_02, dc_0, Ro_00b, Ro_00_right)))
    Ro_02_rounded = (Ro_02
        + (product_rest(R_00, dc_0, Ro_02a, Ro_02 - Ro_02_right)
        + product_rest(R_02, dc_1, Ro_02b, Ro_02_right)))
    Ro_10_rounded = (Ro_10
        + (product_rest(R_10, dc_1, Ro_10a, Ro_10 + Ro_10_right)
        - product_rest(R_12, dc_0, Ro_10b, Ro_10_right)))
    Ro_12_rounded = (Ro_12
        + (product_rest(R_10, dc_0, Ro_12a, Ro_12 - Ro_12_right)
        + product_rest(R_12, dc_1, Ro_12b, Ro_12_right)))
    Ro_20_rounded = (Ro_20
        + (product_rest(R_20, dc_1, Ro_20a, Ro_20 + Ro_20_right)
        - product_rest(R_22, dc_0, Ro_20b, Ro_20_right)))
    Ro_22_rounded = (Ro_22
        + (product_rest(R_20, dc_0, Ro_22a, Ro_22 - Ro_22_right)
        + product_rest(R_22, dc_1, Ro_22b, Ro_22_right)))
    return (Ro_00_rounded, R_01, Ro_02_rounded, Ro_10_rounded, R_11, Ro_12_rounded, Ro_20_rounded,
        R_21, Ro_22_rounded)


@kernel("(3,4),(2)->(3,4)")
def product_ddry(D, dc):
    """Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00a = D_00 * dc_1
    Do_00b = D_02 * dc_0
    Do_00 = Do_00a - Do_00b
    Do_00_right = Do_00a - Do_00
    Do_02a = D_00 * dc_0
    Do_02b = D_02 * dc_1
    Do_02 = Do_02a + Do_02b
    Do_02_right = Do_02 - Do_02a
    Do_10a = D_10 * dc_1
    Do_10b = D_12 * dc_0
    Do_10 = Do_10a - Do_10b
    Do_10_right = Do_10a - Do_10
    Do_12a = D_10 * dc_0
    Do_12b = D_12 * dc_1
    Do_12 = Do_12a + Do_12b
    Do_12_right = Do_12 - Do_12a
    Do_20a = D_20 * dc_1
    Do_20b = D_22 * dc_0
    Do_20 = Do_20a - Do_20b
    Do_20_right = Do_20a - Do_20
    Do_22a = D_20 * dc_0
    Do_22b = D_22 * dc_1
    Do_22 = Do_22a + Do_22b
    Do_22_right = Do_22 - Do_22a
    Do_00_rounded = (Do_00
        + (product_rest(D_00, dc_1, Do_00a, Do_00 + Do_00_right)
        - product_rest(D_02, dc_0, Do_00b, Do_00_right)))
    Do_02_rounded = (Do_02
        + (product_rest(D_00, dc_0, Do_02a, Do_02 - Do_02_right)
        + product_rest(D_02, dc_1, Do_02b, Do_02_right)))
    Do_10_rounded = (Do_10
        + (product_rest(D_10, dc_1, Do_10a, Do_10 + Do_10_right)
        - product_rest(D_12, dc_0, Do_10b, Do_10_right)))
    Do_12_rounded = (Do_12
        + (product_rest(D_10, dc_0, Do_12a, Do_12 - Do_12_right)
        + product_rest(D_12, dc_1, Do_12b, Do_12_right)))
    Do_20_rounded = (Do_20
        + (product_rest(D_20, dc_1, Do_20a, Do_20 + Do_20_right)
        - product_rest(D_22, dc_0, Do_20b, Do_20_right)))
    Do_22_rounded = (Do_22
        + (product_rest(D_20, dc_0, Do_22a, Do_22 - Do_22_right)
        + product_rest(D_22, dc_1, Do_22b, Do_22_right)))
    return (Do_00_rounded, D_01, Do_02_rounded, D_03, Do_10_rounded, D_11, Do_12_rounded, D_13,
        Do_20_rounded, D_21, Do_22_rounded, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddty(D, k):
    """Do = D [I | k e_y].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_01 * k
    Do_03 = Do_03a + D_03
    Do_03_right = Do_03 - Do_03a
    Do_13a = D_11 * k
    Do_13 = Do_13a + D_13
    Do_13_right = Do_13 - Do_13a
    Do_23a = D_21 * k
    Do_23 = Do_23a + D_23
    Do_23_right = Do_23 - Do_23a
    Do_03_rounded = (Do_03
        + (product_rest(D_01, k, Do_03a, Do_03 - Do_03_right) + (D_03 - Do_03_right)))
    Do_13_rounded = (Do_13
        + (product_rest(D_11, k, Do_13a, Do_13 - Do_13_right) + (D_13 - Do_13_right)))
    Do_23_rounded = (Do_23
        + (product_rest(D_21, k, Do_23a, Do_23 - Do_23_right) + (D_23 - Do_23_right)))
    return (D_00, D_01, D_02, Do_03_rounded, D_10, D_11, D_12, Do_13_rounded, D_20, D_21, D_22,
        Do_23_rounded)


@kernel("(3,3),()->(3)")
def product_drvtyinv(R, k):
    """vo = R (-k e_y).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = -(R_01 * k)
    vo_1 = -(R_11 * k)
    vo_2 = -(R_21 * k)
    vo_0_rounded = vo_0 + product_error(-R_01, k, vo_0)
    vo_1_rounded = vo_1 + product_error(-R_11, k, vo_1)
    vo_2_rounded = vo_2 + product_error(-R_21, k, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(2)->(3,3)")
def product_drdryinv(R, dc):
    """Ro = R R_y(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00a = R_00 * dc_1
    Ro_00b = R_02 * dc_0
    Ro_00 = Ro_00a + Ro_00b
    Ro_00_right = Ro_00 - Ro_00a
    Ro_02a = R_02 * dc_1
    Ro_02b = R_00 * dc_0
    Ro_02 = Ro_02a - Ro_02b
    Ro_02_right = Ro_02a - Ro_02
    Ro_10a = R_10 * dc_1
    Ro_10b = R_12 * dc_0
    Ro_10 = Ro_10a + Ro_10b
    Ro_10_right = Ro_10 - Ro_10a
    Ro_12a = R_12 * dc_1
    Ro_12b = R_10 * dc_0
    Ro_12 = Ro_12a - Ro_12b
    Ro_12_right = Ro_12a - Ro_12
    Ro_20a = R_20 * dc_1
    Ro_20b = R_22 * dc_0
    Ro_20 = Ro_20a + Ro_20b
    Ro_20_right = Ro_20 - Ro_20a
    Ro_22a = R_22 * dc_1
    Ro_22b = R_20 * dc_0
    Ro_22 = Ro_22a - Ro_22b
    Ro_22_right = Ro_22a - Ro_22
    Ro_00_rounded = (Ro_00
        + (product_rest(R_00, dc_1, Ro_00a, Ro_00 - Ro_00_right)
        + product_rest(R_02, dc_0, Ro_00b, Ro_00_right)))
    Ro_02_rounded = (Ro_02
        + (product_rest(R_02, dc_1, Ro_02a, Ro_02 + Ro_02_right)
        - product_rest(R_00, dc_0, Ro_02b, Ro_02_right)))
    Ro_10_rounded = (Ro_10
        + (product_rest(R_10, dc_1, Ro_10a, Ro_10 - Ro_10_right)
        + product_rest(R_12, dc_0, Ro_10b, Ro_10_right)))
    Ro_12_rounded = (Ro_12
        + (product_rest(R_12, dc_1, Ro_12a, Ro_12 + Ro_12_right)
        - product_rest(R_10, dc_0, Ro_12b, Ro_12_right)))
    Ro_20_rounded = (Ro_20
        + (product_rest(R_20, dc_1, Ro_20a, Ro_20 - Ro_20_right)
        + product_rest(R_22, dc_0, Ro_20b, Ro_20_right)))
    Ro_22_rounded = (Ro_22
        + (product_rest(R_22, dc_1, Ro_22a, Ro_22 + Ro_22_right)
        - product_rest(R_20, dc_0, Ro_22b, Ro_22_right)))
    return (Ro_00_rounded, R_01, Ro_02_rounded, Ro_10_rounded, R_11, Ro_12_rounded, Ro_20_rounded,
        R_21, Ro_22_rounded)


@kernel("(3,4),(2)->(3,4)")
def product_ddryinv(D, dc):
    """Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00a = D_00 * dc_1
    Do_00b = D_02 * dc_0
    Do_00 = Do_00a + Do_00b
    Do_00_right = Do_00 - Do_00a
    Do_02a = D_02 * dc_1
    Do_02b = D_00 * dc_0
    Do_02 = Do_02a - Do_02b
    Do_02_right = Do_02a - Do_02
    Do_10a = D_10 * dc_1
    Do_10b = D_12 * dc_0
    Do_10 = Do_10a + Do_10b
    Do_10_right = Do_10 - Do_10a
    Do_12a = D_12 * dc_1
    Do_12b = D_10 * dc_0
    Do_12 = Do_12a - Do_12b
    Do_12_right = Do_12a - Do_12
    Do_20a = D_20 * dc_1
    Do_20b = D_22 * dc_0
    Do_20 = Do_20a + Do_20b
    Do_20_right = Do_20 - Do_20a
    Do_22a = D_22 * dc_1
    Do_22b = D_20 * dc_0
    Do_22 = Do_22a - Do_22b
    Do_22_right = Do_22a - Do_22
    Do_00_rounded = (Do_00
        + (product_rest(D_00, dc_1, Do_00a, Do_00 - Do_00_right)
        + product_rest(D_02, dc_0, Do_00b, Do_00_right)))
    Do_02_rounded = (Do_02
        + (product_rest(D_02, dc_1, Do_02a, Do_02 + Do_02_right)
        - product_rest(D_00, dc_0, Do_02b, Do_02_right)))
    Do_10_rounded = (Do_10
        + (product_rest(D_10, dc_1, Do_10a, Do_10 - Do_10_right)
        + product_rest(D_12, dc_0, Do_10b, Do_10_right)))
    Do_12_rounded = (Do_12
        + (product_rest(D_12, dc_1, Do_12a, Do_12 + Do_12_right)
        - product_rest(D_10, dc_0, Do_12b, Do_12_right)))
    Do_20_rounded = (Do_20
        + (product_rest(D_20, dc_1, Do_20a, Do_20 - Do_20_right)
        + product_rest(D_22, dc_0, Do_20b, Do_20_right)))
    Do_22_rounded = (Do_22
        + (product_rest(D_22, dc_1, Do_22a, Do_22 + Do_22_right)
        - product_rest(D_20, dc_0, Do_22b, Do_22_right)))
    return (Do_00_rounded, D_01, Do_02_rounded, D_03, Do_10_rounded, D_11, Do_12_rounded, D_13,
        Do_20_rounded, D_21, Do_22_rounded, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtyinv(D, k):
    """Do = D [I | -k e_y].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_01 * k
    Do_03 = D_03 - Do_03a
    Do_03_right = D_03 - Do_03
    Do_13a = D_11 * k
    Do_13 = D_13 - Do_13a
    Do_13_right = D_13 - Do_13
    Do_23a = D_21 * k
    Do_23 = D_23 - Do_23a
    Do_23_right = D_23 - Do_23
    Do_03_rounded = (Do_03
        + (D_03 - (Do_03 + Do_03_right) - product_rest(D_01, k, Do_03a, Do_03_right)))
    Do_13_rounded = (Do_13
        + (D_13 - (Do_13 + Do_13_right) - product_rest(D_11, k, Do_13a, Do_13_right)))
    Do_23_rounded = (Do_23
        + (D_23 - (Do_23 + Do_23_right) - product_rest(D_21, k, Do_23a, Do_23_right)))
    return (D_00, D_01, D_02, Do_03_rounded, D_10, D_11, D_12, Do_13_rounded, D_20, D_21, D_22,
        Do_23_rounded)


@kernel("(3,3),()->(3)")
def product_drvtz(R, k):
    """vo = R (k e_z).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = R_02 * k
    vo_1 = R_12 * k
    vo_2 = R_22 * k
    vo_0_rounded = vo_0 + product_error(R_02, k, vo_0)
    vo_1_rounded = vo_1 + product_error(R_12, k, vo_1)
    vo_2_rounded = vo_2 + product_error(R_22, k, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(2)->(3,3)")
def product_drdrz(R, dc):
    """Ro = R R_z(θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00a = R_00 * dc_1
    Ro_00b = R_01 * dc_0
    Ro_00 = Ro_00a + Ro_00b
    Ro_00_right = Ro_00 - Ro_00a
    Ro_01a = R_01 * dc_1
    Ro_01b = R_00 * dc_0
    Ro_01 = Ro_01a - Ro_01b
    Ro_01_right = Ro_01a - Ro_01
    Ro_10a = R_10 * dc_1
    Ro_10b = R_11 * dc_0
    Ro_10 = Ro_10a + Ro_10b
    Ro_10_right = Ro_10 - Ro_10a
    Ro_11a = R_11 * dc_1
    Ro_11b = R_10 * dc_0
    Ro_11 = Ro_11a - Ro_11b
    Ro_11_right = Ro_11a - Ro_11
    Ro_20a = R_20 * dc_1
    Ro_20b = R_21 * dc_0
    Ro_20 = Ro_20a + Ro_20b
    Ro_20_right = Ro_20 - Ro_20a
    Ro_21a = R_21 * dc_1
    Ro_21b = R_20 * dc_0
    Ro_21 = Ro_21a - Ro_21b
    Ro_21_right = Ro_21a - Ro_21
    Ro_00_rounded = (Ro_00
        + (product_rest(R_00, dc_1, Ro_00a, Ro_00 - Ro_00_right)
        + product_rest(R_01, dc_0, Ro_00b, Ro_00_right)))
    Ro_01_rounded = (Ro_01
        + (product_rest(R_01, dc_1, Ro_01a, Ro_01 + Ro_01_right)
        - product_rest(R_00, dc_0, Ro_01b, Ro_01_right)))
    Ro_10_rounded = (Ro_10
        + (product_rest(R_10, dc_1, Ro_10a, Ro_10 - Ro_10_right)
        + product_rest(R_11, dc_0, Ro_10b, Ro_10_right)))
    Ro_11_rounded = (Ro_11
        + (product_rest(R_11, dc_1, Ro_11a, Ro_11 + Ro_11_right)
        - product_rest(R_10, dc_0, Ro_11b, Ro_11_right)))
    Ro_20_rounded = (Ro_20
        + (product_rest(R_20, dc_1, Ro_20a, Ro_20 - Ro_20_right)
        + product_rest(R_21, dc_0, Ro_20b, Ro_20_right)))
    Ro_21_rounded = (Ro_21
        + (product_rest(R_21, dc_1, Ro_21a, Ro_21 + Ro_21_right)
        - product_rest(R_20, dc_0, Ro_21b, Ro_21_right)))
    return (Ro_00_rounded, Ro_01_rounded, R_02, Ro_10_rounded, Ro_11_rounded, R_12, Ro_20_rounded,
        Ro_21_rounded, R_22)


@kernel("(3,4),(2)->(3,4)")
def product_ddrz(D, dc):
    """Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00a = D_00 * dc_1
    Do_00b = D_01 * dc_0
    Do_00 = Do_00a + Do_00b
    Do_00_right = Do_00 - Do_00a
    Do_01a = D_01 * dc_1
    Do_01b = D_00 * dc_0
    Do_01 = Do_01a - Do_01b
    Do_01_right = Do_01a - Do_01
    Do_10a = D_10 * dc_1
    Do_10b = D_11 * dc_0
    Do_10 = Do_10a + Do_10b
    Do_10_right = Do_10 - Do_10a
    Do_11a = D_11 * dc_1
    Do_11b = D_10 * dc_0
    Do_11 = Do_11a - Do_11b
    Do_11_right = Do_11a - Do_11
    Do_20a = D_20 * dc_1
    Do_20b = D_21 * dc_0
    Do_20 = Do_20a + Do_20b
    Do_20_right = Do_20 - Do_20a
    Do_21a = D_21 * dc_1
    Do_21b = D_20 * dc_0
    Do_21 = Do_21a - Do_21b
    Do_21_right = Do_21a - Do_21
    Do_00_rounded = (Do_00
        + (product_rest(D_00, dc_1, Do_00a, Do_00 - Do_00_right)
        + product_rest(D_01, dc_0, Do_00b, Do_00_right)))
    Do_01_rounded = (Do_01
        + (product_rest(D_01, dc_1, Do_01a, Do_01 + Do_01_right)
        - product_rest(D_00, dc_0, Do_01b, Do_01_right)))
    Do_10_rounded = (Do_10
        + (product_rest(D_10, dc_1, Do_10a, Do_10 - Do_10_right)
        + product_rest(D_11, dc_0, Do_10b, Do_10_right)))
    Do_11_rounded = (Do_11
        + (product_rest(D_11, dc_1, Do_11a, Do_11 + Do_11_right)
        - product_rest(D_10, dc_0, Do_11b, Do_11_right)))
    Do_20_rounded = (Do_20
        + (product_rest(D_20, dc_1, Do_20a, Do_20 - Do_20_right)
        + product_rest(D_21, dc_0, Do_20b, Do_20_right)))
    Do_21_rounded = (Do_21
        + (product_rest(D_21, dc_1, Do_21a, Do_21 + Do_21_right)
        - product_rest(D_20, dc_0, Do_21b, Do_21_right)))
    return (Do_00_rounded, Do_01_rounded, D_02, D_03, Do_10_rounded, Do_11_rounded, D_12, D_13,
        Do_20_rounded, Do_21_rounded, D_22, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtz(D, k):
    """Do = D [I | k e_z].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_02 * k
    Do_03 = Do_03a + D_03
    Do_03_right = Do_03 - Do_03a
    Do_13a = D_12 * k
    Do_13 = Do_13a + D_13
    Do_13_right = Do_13 - Do_13a
    Do_23a = D_22 * k
    Do_23 = Do_23a + D_23
    Do_23_right = Do_23 - Do_23a
    Do_03_rounded = (Do_03
        + (product_rest(D_02, k, Do_03a, Do_03 - Do_03_right) + (D_03 - Do_03_right)))
    Do_13_rounded = (Do_13
        + (product_rest(D_12, k, Do_13a, Do_13 - Do_13_right) + (D_13 - Do_13_right)))
    Do_23_rounded = (Do_23
        + (product_rest(D_22, k, Do_23a, Do_23 - Do_23_right) + (D_23 - Do_23_right)))
    return (D_00, D_01, D_02, Do_03_rounded, D_10, D_11, D_12, Do_13_rounded, D_20, D_21, D_22,
        Do_23_rounded)


@kernel("(3,3),()->(3)")
def product_drvtzinv(R, k):
    """vo = R (-k e_z).

    (3,3),()->(3).  R: rotation or other 3×3 matrix; k: number; vo: vector.
    3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = -(R_02 * k)
    vo_1 = -(R_12 * k)
    vo_2 = -(R_22 * k)
    vo_0_rounded = vo_0 + product_error(-R_02, k, vo_0)
    vo_1_rounded = vo_1 + product_error(-R_12, k, vo_1)
    vo_2_rounded = vo_2 + product_error(-R_22, k, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3,3),(2)->(3,3)")
def product_drdrzinv(R, dc):
    """Ro = R R_z(-θ), dc = (sin θ, cos θ).

    (3,3),(2)->(3,3).  R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00a = R_00 * dc_1
    Ro_00b = R_01 * dc_0
    Ro_00 = Ro_00a - Ro_00b
    Ro_00_right = Ro_00a - Ro_00
    Ro_01a = R_00 * dc_0
    Ro_01b = R_01 * dc_1
    Ro_01 = Ro_01a + Ro_01b
    Ro_01_right = Ro_01 - Ro_01a
    Ro_10a = R_10 * dc_1
    Ro_10b = R_11 * dc_0
    Ro_10 = Ro_10a - Ro_10b
    Ro_10_right = Ro_10a - Ro_10
    Ro_11a = R_10 * dc_0
    Ro_11b = R_11 * dc_1
    Ro_11 = Ro_11a + Ro_11b
    Ro_11_right = Ro_11 - Ro_11a
    Ro_20a = R_20 * dc_1
    Ro_20b = R_21 * dc_0
    Ro_20 = Ro_20a - Ro_20b
    Ro_20_right = Ro_20a - Ro_20
    Ro_21a = R_20 * dc_0
    Ro_21b = R_21 * dc_1
    Ro_21 = Ro_21a + Ro_21b
    Ro_21_right = Ro_21 - Ro_21a
    Ro_00_rounded = (Ro_00
        + (product_rest(R_00, dc_1, Ro_00a, Ro_00 + Ro_00_right)
        - product_rest(R_01, dc_0, Ro_00b, Ro_00_right)))
    Ro_01_rounded = (Ro_01
        + (product_rest(R_00, dc_0, Ro_01a, Ro_01 - Ro_01_right)
        + product_rest(R_01, dc_1, Ro_01b, Ro_01_right)))
    Ro_10_rounded = (Ro_10
        + (product_rest(R_10, dc_1, Ro_10a, Ro_10 + Ro_10_right)
        - product_rest(R_11, dc_0, Ro_10b, Ro_10_right)))
    Ro_11_rounded = (Ro_11
        + (product_rest(R_10, dc_0, Ro_11a, Ro_11 - Ro_11_right)
        + product_rest(R_11, dc_1, Ro_11b, Ro_11_right)))
    Ro_20_rounded = (Ro_20
        + (product_rest(R_20, dc_1, Ro_20a, Ro_20 + Ro_20_right)
        - product_rest(R_21, dc_0, Ro_20b, Ro_20_right)))
    Ro_21_rounded = (Ro_21
        + (product_rest(R_20, dc_0, Ro_21a, Ro_21 - Ro_21_right)
        + product_rest(R_21, dc_1, Ro_21b, Ro_21_right)))
    return (Ro_00_rounded, Ro_01_rounded, R_02, Ro_10_rounded, Ro_11_rounded, R_12, Ro_20_rounded,
        Ro_21_rounded, R_22)


@kernel("(3,4),(2)->(3,4)")
def product_ddrzinv(D, dc):
    """Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).

    (3,4),(2)->(3,4).  D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
    12 mul, 30 add, 12 product rest.  Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00a = D_00 * dc_1
    Do_00b = D_01 * dc_0
    Do_00 = Do_00a - Do_00b
    Do_00_right = Do_00a - Do_00
    Do_01a = D_00 * dc_0
    Do_01b = D_01 * dc_1
    Do_01 = Do_01a + Do_01b
    Do_01_right = Do_01 - Do_01a
    Do_10a = D_10 * dc_1
    Do_10b = D_11 * dc_0
    Do_10 = Do_10a - Do_10b
    Do_10_right = Do_10a - Do_10
    Do_11a = D_10 * dc_0
    Do_11b = D_11 * dc_1
    Do_11 = Do_11a + Do_11b
    Do_11_right = Do_11 - Do_11a
    Do_20a = D_20 * dc_1
    Do_20b = D_21 * dc_0
    Do_20 = Do_20a - Do_20b
    Do_20_right = Do_20a - Do_20
    Do_21a = D_20 * dc_0
    Do_21b = D_21 * dc_1
    Do_21 = Do_21a + Do_21b
    Do_21_right = Do_21 - Do_21a
    Do_00_rounded = (Do_00
        + (product_rest(D_00, dc_1, Do_00a, Do_00 + Do_00_right)
        - product_rest(D_01, dc_0, Do_00b, Do_00_right)))
    Do_01_rounded = (Do_01
        + (product_rest(D_00, dc_0, Do_01a, Do_01 - Do_01_right)
        + product_rest(D_01, dc_1, Do_01b, Do_01_right)))
    Do_10_rounded = (Do_10
        + (product_rest(D_10, dc_1, Do_10a, Do_10 + Do_10_right)
        - product_rest(D_11, dc_0, Do_10b, Do_10_right)))
    Do_11_rounded = (Do_11
        + (product_rest(D_10, dc_0, Do_11a, Do_11 - Do_11_right)
        + product_rest(D_11, dc_1, Do_11b, Do_11_right)))
    Do_20_rounded = (Do_20
        + (product_rest(D_20, dc_1, Do_20a, Do_20 + Do_20_right)
        - product_rest(D_21, dc_0, Do_20b, Do_20_right)))
    Do_21_rounded = (Do_21
        + (product_rest(D_20, dc_0, Do_21a, Do_21 - Do_21_right)
        + product_rest(D_21, dc_1, Do_21b, Do_21_right)))
    return (Do_00_rounded, Do_01_rounded, D_02, D_03, Do_10_rounded, Do_11_rounded, D_12, D_13,
        Do_20_rounded, Do_21_rounded, D_22, D_23)


@kernel("(3,4),()->(3,4)")
def product_ddtzinv(D, k):
    """Do = D [I | -k e_z].

    (3,4),()->(3,4).  D, Do: displacement [R | t], R rotation, t in m; k: number.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_02 * k
    Do_03 = D_03 - Do_03a
    Do_03_right = D_03 - Do_03
    Do_13a = D_12 * k
    Do_13 = D_13 - Do_13a
    Do_13_right = D_13 - Do_13
    Do_23a = D_22 * k
    Do_23 = D_23 - Do_23a
    Do_23_right = D_23 - Do_23
    Do_03_rounded = (Do_03
        + (D_03 - (Do_03 + Do_03_right) - product_rest(D_02, k, Do_03a, Do_03_right)))
    Do_13_rounded = (Do_13
        + (D_13 - (Do_13 + Do_13_right) - product_rest(D_12, k, Do_13a, Do_13_right)))
    Do_23_rounded = (Do_23
        + (D_23 - (Do_23 + Do_23_right) - product_rest(D_22, k, Do_23a, Do_23_right)))
    return (D_00, D_01, D_02, Do_03_rounded, D_10, D_11, D_12, Do_13_rounded, D_20, D_21, D_22,
        Do_23_rounded)
