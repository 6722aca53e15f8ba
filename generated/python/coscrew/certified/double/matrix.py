# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Products between rotations, displacements and vectors.

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(3,3),(3)->(3),(3)")
@errstate(all="ignore")
def product_drv(R, v, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """vo = R v; |error of vo| <= vo_bound unless inf or NaN.

    (3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
    12 mul, 15 add, 9 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0a = R_00 * v_0
    vo_0b = R_01 * v_1
    vo_0d = R_02 * v_2
    vo_0 = vo_0a + vo_0b + vo_0d
    vo_1a = R_10 * v_0
    vo_1b = R_11 * v_1
    vo_1d = R_12 * v_2
    vo_1 = vo_1a + vo_1b + vo_1d
    vo_2a = R_20 * v_0
    vo_2b = R_21 * v_1
    vo_2d = R_22 * v_2
    vo_2 = vo_2a + vo_2b + vo_2d
    vo_0_size = absolute(vo_0a) + absolute(vo_0b) + absolute(vo_0d)
    vo_1_size = absolute(vo_1a) + absolute(vo_1b) + absolute(vo_1d)
    vo_2_size = absolute(vo_2a) + absolute(vo_2b) + absolute(vo_2d)
    vo_0_bound = c2 * (vo_0_size + c1)
    vo_1_bound = c2 * (vo_1_size + c1)
    vo_2_bound = c2 * (vo_2_size + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3,3),(3)->(3),(3)")
@errstate(all="ignore")
def product_drvinv(R, v, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
    12 mul, 15 add, 3 neg, 9 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0a = R_00 * v_0
    vo_0b = R_01 * v_1
    vo_0d = R_02 * v_2
    vo_0 = -(vo_0a + vo_0b + vo_0d)
    vo_1a = R_10 * v_0
    vo_1b = R_11 * v_1
    vo_1d = R_12 * v_2
    vo_1 = -(vo_1a + vo_1b + vo_1d)
    vo_2a = R_20 * v_0
    vo_2b = R_21 * v_1
    vo_2d = R_22 * v_2
    vo_2 = -(vo_2a + vo_2b + vo_2d)
    vo_0e_bound = c2 * (absolute(vo_0a) + absolute(vo_0b) + absolute(vo_0d) + c1)
    vo_1e_bound = c2 * (absolute(vo_1a) + absolute(vo_1b) + absolute(vo_1d) + c1)
    vo_2e_bound = c2 * (absolute(vo_2a) + absolute(vo_2b) + absolute(vo_2d) + c1)
    return (vo_0, vo_1, vo_2, vo_0e_bound, vo_1e_bound, vo_2e_bound)


@kernel("(3,3),(3)->(3),(3)")
@errstate(all="ignore")
def product_drinvv(R, v, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.

    (3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
    12 mul, 15 add, 9 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0a = R_00 * v_0
    vo_0b = R_10 * v_1
    vo_0d = R_20 * v_2
    vo_0 = vo_0a + vo_0b + vo_0d
    vo_1a = R_01 * v_0
    vo_1b = R_11 * v_1
    vo_1d = R_21 * v_2
    vo_1 = vo_1a + vo_1b + vo_1d
    vo_2a = R_02 * v_0
    vo_2b = R_12 * v_1
    vo_2d = R_22 * v_2
    vo_2 = vo_2a + vo_2b + vo_2d
    vo_0_size = absolute(vo_0a) + absolute(vo_0b) + absolute(vo_0d)
    vo_1_size = absolute(vo_1a) + absolute(vo_1b) + absolute(vo_1d)
    vo_2_size = absolute(vo_2a) + absolute(vo_2b) + absolute(vo_2d)
    vo_0_bound = c2 * (vo_0_size + c1)
    vo_1_bound = c2 * (vo_1_size + c1)
    vo_2_bound = c2 * (vo_2_size + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3,3),(3)->(3),(3)")
@errstate(all="ignore")
def product_drinvvinv(R, v, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),(3)->(3),(3).  R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
    12 mul, 15 add, 3 neg, 9 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    v_0, v_1, v_2 = v
    vo_0a = R_00 * v_0
    vo_0b = R_10 * v_1
    vo_0d = R_20 * v_2
    vo_0 = -(vo_0a + vo_0b + vo_0d)
    vo_1a = R_01 * v_0
    vo_1b = R_11 * v_1
    vo_1d = R_21 * v_2
    vo_1 = -(vo_1a + vo_1b + vo_1d)
    vo_2a = R_02 * v_0
    vo_2b = R_12 * v_1
    vo_2d = R_22 * v_2
    vo_2 = -(vo_2a + vo_2b + vo_2d)
    vo_0e_bound = c2 * (absolute(vo_0a) + absolute(vo_0b) + absolute(vo_0d) + c1)
    vo_1e_bound = c2 * (absolute(vo_1a) + absolute(vo_1b) + absolute(vo_1d) + c1)
    vo_2e_bound = c2 * (absolute(vo_2a) + absolute(vo_2b) + absolute(vo_2d) + c1)
    return (vo_0, vo_1, vo_2, vo_0e_bound, vo_1e_bound, vo_2e_bound)


@kernel("(3,4),(3)->(3),(3)")
@errstate(all="ignore")
def product_dv(D, v, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.

    (3,4),(3)->(3),(3).  D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
    12 mul, 21 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    v_0, v_1, v_2 = v
    vo_0a = D_00 * v_0
    vo_0b = D_01 * v_1
    vo_0d = D_02 * v_2
    vo_0 = vo_0a + vo_0b + vo_0d + D_03
    vo_1a = D_10 * v_0
    vo_1b = D_11 * v_1
    vo_1d = D_12 * v_2
    vo_1 = vo_1a + vo_1b + vo_1d + D_13
    vo_2a = D_20 * v_0
    vo_2b = D_21 * v_1
    vo_2d = D_22 * v_2
    vo_2 = vo_2a + vo_2b + vo_2d + D_23
    vo_0_size = absolute(vo_0a) + absolute(vo_0b) + absolute(vo_0d) + absolute(D_03)
    vo_1_size = absolute(vo_1a) + absolute(vo_1b) + absolute(vo_1d) + absolute(D_13)
    vo_2_size = absolute(vo_2a) + absolute(vo_2b) + absolute(vo_2d) + absolute(D_23)
    vo_0_bound = c2 * (vo_0_size + c1)
    vo_1_bound = c2 * (vo_1_size + c1)
    vo_2_bound = c2 * (vo_2_size + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3,4),(3)->(3),(3)")
@errstate(all="ignore")
def product_dinvv(D, v, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.

    (3,4),(3)->(3),(3).  D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
    21 mul, 18 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    v_0, v_1, v_2 = v
    p_0 = v_0 - D_03
    p_1 = v_1 - D_13
    p_2 = v_2 - D_23
    vo_0 = D_00 * p_0 + D_10 * p_1 + D_20 * p_2
    vo_1 = D_01 * p_0 + D_11 * p_1 + D_21 * p_2
    vo_2 = D_02 * p_0 + D_12 * p_1 + D_22 * p_2
    p_0_abs = absolute(p_0)
    p_1_abs = absolute(p_1)
    p_2_abs = absolute(p_2)
    vo_0_size = absolute(D_00) * p_0_abs + absolute(D_10) * p_1_abs + absolute(D_20) * p_2_abs
    vo_1_size = absolute(D_01) * p_0_abs + absolute(D_11) * p_1_abs + absolute(D_21) * p_2_abs
    vo_2_size = absolute(D_02) * p_0_abs + absolute(D_12) * p_1_abs + absolute(D_22) * p_2_abs
    vo_0_bound = c2 * (vo_0_size + c1)
    vo_1_bound = c2 * (vo_1_size + c1)
    vo_2_bound = c2 * (vo_2_size + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3,3),(3,3)->(3,3),(3,3)")
@errstate(all="ignore")
def product_drdr(R1, R2, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """
    R1_00, R1_01, R1_02, R1_10, R1_11, R1_12, R1_20, R1_21, R1_22 = R1
    R2_00, R2_01, R2_02, R2_10, R2_11, R2_12, R2_20, R2_21, R2_22 = R2
    Ro_00a = R1_00 * R2_00
    Ro_00b = R1_01 * R2_10
    Ro_00d = R1_02 * R2_20
    Ro_00 = Ro_00a + Ro_00b + Ro_00d
    Ro_01a = R1_00 * R2_01
    Ro_01b = R1_01 * R2_11
    Ro_01d = R1_02 * R2_21
    Ro_01 = Ro_01a + Ro_01b + Ro_01d
    Ro_02a = R1_00 * R2_02
    Ro_02b = R1_01 * R2_12
    Ro_02d = R1_02 * R2_22
    Ro_02 = Ro_02a + Ro_02b + Ro_02d
    Ro_10a = R1_10 * R2_00
    Ro_10b = R1_11 * R2_10
    Ro_10d = R1_12 * R2_20
    Ro_10 = Ro_10a + Ro_10b + Ro_10d
    Ro_11a = R1_10 * R2_01
    Ro_11b = R1_11 * R2_11
    Ro_11d = R1_12 * R2_21
    Ro_11 = Ro_11a + Ro_11b + Ro_11d
    Ro_12a = R1_10 * R2_02
    Ro_12b = R1_11 * R2_12
    Ro_12d = R1_12 * R2_22
    Ro_12 = Ro_12a + Ro_12b + Ro_12d
    Ro_20a = R1_20 * R2_00
    Ro_20b = R1_21 * R2_10
    Ro_20d = R1_22 * R2_20
    Ro_20 = Ro_20a + Ro_20b + Ro_20d
    Ro_21a = R1_20 * R2_01
    Ro_21b = R1_21 * R2_11
    Ro_21d = R1_22 * R2_21
    Ro_21 = Ro_21a + Ro_21b + Ro_21d
    Ro_22a = R1_20 * R2_02
    Ro_22b = R1_21 * R2_12
    Ro_22d = R1_22 * R2_22
    Ro_22 = Ro_22a + Ro_22b + Ro_22d
    Ro_00_size = absolute(Ro_00a) + absolute(Ro_00b) + absolute(Ro_00d)
    Ro_01_size = absolute(Ro_01a) + absolute(Ro_01b) + absolute(Ro_01d)
    Ro_02_size = absolute(Ro_02a) + absolute(Ro_02b) + absolute(Ro_02d)
    Ro_10_size = absolute(Ro_10a) + absolute(Ro_10b) + absolute(Ro_10d)
    Ro_11_size = absolute(Ro_11a) + absolute(Ro_11b) + absolute(Ro_11d)
    Ro_12_size = absolute(Ro_12a) + absolute(Ro_12b) + absolute(Ro_12d)
    Ro_20_size = absolute(Ro_20a) + absolute(Ro_20b) + absolute(Ro_20d)
    Ro_21_size = absolute(Ro_21a) + absolute(Ro_21b) + absolute(Ro_21d)
    Ro_22_size = absolute(Ro_22a) + absolute(Ro_22b) + absolute(Ro_22d)
    Ro_00_bound = c2 * (Ro_00_size + c1)
    Ro_01_bound = c2 * (Ro_01_size + c1)
    Ro_02_bound = c2 * (Ro_02_size + c1)
    Ro_10_bound = c2 * (Ro_10_size + c1)
    Ro_11_bound = c2 * (Ro_11_size + c1)
    Ro_12_bound = c2 * (Ro_12_size + c1)
    Ro_20_bound = c2 * (Ro_20_size + c1)
    Ro_21_bound = c2 * (Ro_21_size + c1)
    Ro_22_bound = c2 * (Ro_22_size + c1)
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22, Ro_00_bound, Ro_01_bound,
        Ro_02_bound, Ro_10_bound, Ro_11_bound, Ro_12_bound, Ro_20_bound, Ro_21_bound, Ro_22_bound)


@kernel("(3,3),(3,3)->(3,3),(3,3)")
@errstate(all="ignore")
def product_drdrinv(R1, R2, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """
    R1_00, R1_01, R1_02, R1_10, R1_11, R1_12, R1_20, R1_21, R1_22 = R1
    R2_00, R2_01, R2_02, R2_10, R2_11, R2_12, R2_20, R2_21, R2_22 = R2
    Ro_00a = R1_00 * R2_00
    Ro_00b = R1_01 * R2_01
    Ro_00d = R1_02 * R2_02
    Ro_00 = Ro_00a + Ro_00b + Ro_00d
    Ro_01a = R1_00 * R2_10
    Ro_01b = R1_01 * R2_11
    Ro_01d = R1_02 * R2_12
    Ro_01 = Ro_01a + Ro_01b + Ro_01d
    Ro_02a = R1_00 * R2_20
    Ro_02b = R1_01 * R2_21
    Ro_02d = R1_02 * R2_22
    Ro_02 = Ro_02a + Ro_02b + Ro_02d
    Ro_10a = R1_10 * R2_00
    Ro_10b = R1_11 * R2_01
    Ro_10d = R1_12 * R2_02
    Ro_10 = Ro_10a + Ro_10b + Ro_10d
    Ro_11a = R1_10 * R2_10
    Ro_11b = R1_11 * R2_11
    Ro_11d = R1_12 * R2_12
    Ro_11 = Ro_11a + Ro_11b + Ro_11d
    Ro_12a = R1_10 * R2_20
    Ro_12b = R1_11 * R2_21
    Ro_12d = R1_12 * R2_22
    Ro_12 = Ro_12a + Ro_12b + Ro_12d
    Ro_20a = R1_20 * R2_00
    Ro_20b = R1_21 * R2_01
    Ro_20d = R1_22 * R2_02
    Ro_20 = Ro_20a + Ro_20b + Ro_20d
    Ro_21a = R1_20 * R2_10
    Ro_21b = R1_21 * R2_11
    Ro_21d = R1_22 * R2_12
    Ro_21 = Ro_21a + Ro_21b + Ro_21d
    Ro_22a = R1_20 * R2_20
    Ro_22b = R1_21 * R2_21
    Ro_22d = R1_22 * R2_22
    Ro_22 = Ro_22a + Ro_22b + Ro_22d
    Ro_00_size = absolute(Ro_00a) + absolute(Ro_00b) + absolute(Ro_00d)
    Ro_01_size = absolute(Ro_01a) + absolute(Ro_01b) + absolute(Ro_01d)
    Ro_02_size = absolute(Ro_02a) + absolute(Ro_02b) + absolute(Ro_02d)
    Ro_10_size = absolute(Ro_10a) + absolute(Ro_10b) + absolute(Ro_10d)
    Ro_11_size = absolute(Ro_11a) + absolute(Ro_11b) + absolute(Ro_11d)
    Ro_12_size = absolute(Ro_12a) + absolute(Ro_12b) + absolute(Ro_12d)
    Ro_20_size = absolute(Ro_20a) + absolute(Ro_20b) + absolute(Ro_20d)
    Ro_21_size = absolute(Ro_21a) + absolute(Ro_21b) + absolute(Ro_21d)
    Ro_22_size = absolute(Ro_22a) + absolute(Ro_22b) + absolute(Ro_22d)
    Ro_00_bound = c2 * (Ro_00_size + c1)
    Ro_01_bound = c2 * (Ro_01_size + c1)
    Ro_02_bound = c2 * (Ro_02_size + c1)
    Ro_10_bound = c2 * (Ro_10_size + c1)
    Ro_11_bound = c2 * (Ro_11_size + c1)
    Ro_12_bound = c2 * (Ro_12_size + c1)
    Ro_20_bound = c2 * (Ro_20_size + c1)
    Ro_21_bound = c2 * (Ro_21_size + c1)
    Ro_22_bound = c2 * (Ro_22_size + c1)
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22, Ro_00_bound, Ro_01_bound,
        Ro_02_bound, Ro_10_bound, Ro_11_bound, Ro_12_bound, Ro_20_bound, Ro_21_bound, Ro_22_bound)


@kernel("(3,3),(3,3)->(3,3),(3,3)")
@errstate(all="ignore")
def product_drinvdr(R1, R2, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(3,3)->(3,3),(3,3).  R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """
    R1_00, R1_01, R1_02, R1_10, R1_11, R1_12, R1_20, R1_21, R1_22 = R1
    R2_00, R2_01, R2_02, R2_10, R2_11, R2_12, R2_20, R2_21, R2_22 = R2
    Ro_00a = R1_00 * R2_00
    Ro_00b = R1_10 * R2_10
    Ro_00d = R1_20 * R2_20
    Ro_00 = Ro_00a + Ro_00b + Ro_00d
    Ro_01a = R1_00 * R2_01
    Ro_01b = R1_10 * R2_11
    Ro_01d = R1_20 * R2_21
    Ro_01 = Ro_01a + Ro_01b + Ro_01d
    Ro_02a = R1_00 * R2_02
    Ro_02b = R1_10 * R2_12
    Ro_02d = R1_20 * R2_22
    Ro_02 = Ro_02a + Ro_02b + Ro_02d
    Ro_10a = R1_01 * R2_00
    Ro_10b = R1_11 * R2_10
    Ro_10d = R1_21 * R2_20
    Ro_10 = Ro_10a + Ro_10b + Ro_10d
    Ro_11a = R1_01 * R2_01
    Ro_11b = R1_11 * R2_11
    Ro_11d = R1_21 * R2_21
    Ro_11 = Ro_11a + Ro_11b + Ro_11d
    Ro_12a = R1_01 * R2_02
    Ro_12b = R1_11 * R2_12
    Ro_12d = R1_21 * R2_22
    Ro_12 = Ro_12a + Ro_12b + Ro_12d
    Ro_20a = R1_02 * R2_00
    Ro_20b = R1_12 * R2_10
    Ro_20d = R1_22 * R2_20
    Ro_20 = Ro_20a + Ro_20b + Ro_20d
    Ro_21a = R1_02 * R2_01
    Ro_21b = R1_12 * R2_11
    Ro_21d = R1_22 * R2_21
    Ro_21 = Ro_21a + Ro_21b + Ro_21d
    Ro_22a = R1_02 * R2_02
    Ro_22b = R1_12 * R2_12
    Ro_22d = R1_22 * R2_22
    Ro_22 = Ro_22a + Ro_22b + Ro_22d
    Ro_00_size = absolute(Ro_00a) + absolute(Ro_00b) + absolute(Ro_00d)
    Ro_01_size = absolute(Ro_01a) + absolute(Ro_01b) + absolute(Ro_01d)
    Ro_02_size = absolute(Ro_02a) + absolute(Ro_02b) + absolute(Ro_02d)
    Ro_10_size = absolute(Ro_10a) + absolute(Ro_10b) + absolute(Ro_10d)
    Ro_11_size = absolute(Ro_11a) + absolute(Ro_11b) + absolute(Ro_11d)
    Ro_12_size = absolute(Ro_12a) + absolute(Ro_12b) + absolute(Ro_12d)
    Ro_20_size = absolute(Ro_20a) + absolute(Ro_20b) + absolute(Ro_20d)
    Ro_21_size = absolute(Ro_21a) + absolute(Ro_21b) + absolute(Ro_21d)
    Ro_22_size = absolute(Ro_22a) + absolute(Ro_22b) + absolute(Ro_22d)
    Ro_00_bound = c2 * (Ro_00_size + c1)
    Ro_01_bound = c2 * (Ro_01_size + c1)
    Ro_02_bound = c2 * (Ro_02_size + c1)
    Ro_10_bound = c2 * (Ro_10_size + c1)
    Ro_11_bound = c2 * (Ro_11_size + c1)
    Ro_12_bound = c2 * (Ro_12_size + c1)
    Ro_20_bound = c2 * (Ro_20_size + c1)
    Ro_21_bound = c2 * (Ro_21_size + c1)
    Ro_22_bound = c2 * (Ro_22_size + c1)
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22, Ro_00_bound, Ro_01_bound,
        Ro_02_bound, Ro_10_bound, Ro_11_bound, Ro_12_bound, Ro_20_bound, Ro_21_bound, Ro_22_bound)


@kernel("(3,4),(3,4)->(3,4),(3,4)")
@errstate(all="ignore")
def product_dd(D1, D2, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=4.440892098500628e-16):
    """Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
    48 mul, 66 add, 39 abs.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    Do_00a = D1_00 * D2_00
    Do_00b = D1_01 * D2_10
    Do_00d = D1_02 * D2_20
    Do_00 = Do_00a + Do_00b + Do_00d
    Do_01a = D1_00 * D2_01
    Do_01b = D1_01 * D2_11
    Do_01d = D1_02 * D2_21
    Do_01 = Do_01a + Do_01b + Do_01d
    Do_02a = D1_00 * D2_02
    Do_02b = D1_01 * D2_12
    Do_02d = D1_02 * D2_22
    Do_02 = Do_02a + Do_02b + Do_02d
    Do_03a = D1_00 * D2_03
    Do_03b = D1_01 * D2_13
    Do_03d = D1_02 * D2_23
    Do_03 = Do_03a + Do_03b + Do_03d + D1_03
    Do_10a = D1_10 * D2_00
    Do_10b = D1_11 * D2_10
    Do_10d = D1_12 * D2_20
    Do_10 = Do_10a + Do_10b + Do_10d
    Do_11a = D1_10 * D2_01
    Do_11b = D1_11 * D2_11
    Do_11d = D1_12 * D2_21
    Do_11 = Do_11a + Do_11b + Do_11d
    Do_12a = D1_10 * D2_02
    Do_12b = D1_11 * D2_12
    Do_12d = D1_12 * D2_22
    Do_12 = Do_12a + Do_12b + Do_12d
    Do_13a = D1_10 * D2_03
    Do_13b = D1_11 * D2_13
    Do_13d = D1_12 * D2_23
    Do_13 = Do_13a + Do_13b + Do_13d + D1_13
    Do_20a = D1_20 * D2_00
    Do_20b = D1_21 * D2_10
    Do_20d = D1_22 * D2_20
    Do_20 = Do_20a + Do_20b + Do_20d
    Do_21a = D1_20 * D2_01
    Do_21b = D1_21 * D2_11
    Do_21d = D1_22 * D2_21
    Do_21 = Do_21a + Do_21b + Do_21d
    Do_22a = D1_20 * D2_02
    Do_22b = D1_21 * D2_12
    Do_22d = D1_22 * D2_22
    Do_22 = Do_22a + Do_22b + Do_22d
    Do_23a = D1_20 * D2_03
    Do_23b = D1_21 * D2_13
    Do_23d = D1_22 * D2_23
    Do_23 = Do_23a + Do_23b + Do_23d + D1_23
    Do_00_size = absolute(Do_00a) + absolute(Do_00b) + absolute(Do_00d)
    Do_01_size = absolute(Do_01a) + absolute(Do_01b) + absolute(Do_01d)
    Do_02_size = absolute(Do_02a) + absolute(Do_02b) + absolute(Do_02d)
    Do_03_size = absolute(Do_03a) + absolute(Do_03b) + absolute(Do_03d) + absolute(D1_03)
    Do_10_size = absolute(Do_10a) + absolute(Do_10b) + absolute(Do_10d)
    Do_11_size = absolute(Do_11a) + absolute(Do_11b) + absolute(Do_11d)
    Do_12_size = absolute(Do_12a) + absolute(Do_12b) + absolute(Do_12d)
    Do_13_size = absolute(Do_13a) + absolute(Do_13b) + absolute(Do_13d) + absolute(D1_13)
    Do_20_size = absolute(Do_20a) + absolute(Do_20b) + absolute(Do_20d)
    Do_21_size = absolute(Do_21a) + absolute(Do_21b) + absolute(Do_21d)
    Do_22_size = absolute(Do_22a) + absolute(Do_22b) + absolute(Do_22d)
    Do_23_size = absolute(Do_23a) + absolute(Do_23b) + absolute(Do_23d) + absolute(D1_23)
    Do_00_bound = c2 * (Do_00_size + c1)
    Do_01_bound = c2 * (Do_01_size + c1)
    Do_02_bound = c2 * (Do_02_size + c1)
    Do_03_bound = c3 * (Do_03_size + c1)
    Do_10_bound = c2 * (Do_10_size + c1)
    Do_11_bound = c2 * (Do_11_size + c1)
    Do_12_bound = c2 * (Do_12_size + c1)
    Do_13_bound = c3 * (Do_13_size + c1)
    Do_20_bound = c2 * (Do_20_size + c1)
    Do_21_bound = c2 * (Do_21_size + c1)
    Do_22_bound = c2 * (Do_22_size + c1)
    Do_23_bound = c3 * (Do_23_size + c1)
    return (Do_00, Do_01, Do_02, Do_03, Do_10, Do_11, Do_12, Do_13, Do_20, Do_21, Do_22, Do_23,
        Do_00_bound, Do_01_bound, Do_02_bound, Do_03_bound, Do_10_bound, Do_11_bound, Do_12_bound,
        Do_13_bound, Do_20_bound, Do_21_bound, Do_22_bound, Do_23_bound)


@kernel("(3,4),(3,4)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddinv(D1, D2, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=7.7715611723761e-16):
    """Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
    57 mul, 66 add, 33 abs.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    R_0a = D1_00 * D2_00
    R_0b = D1_01 * D2_01
    R_0d = D1_02 * D2_02
    R_0 = R_0a + R_0b + R_0d
    R_1a = D1_00 * D2_10
    R_1b = D1_01 * D2_11
    R_1d = D1_02 * D2_12
    R_1 = R_1a + R_1b + R_1d
    R_2a = D1_00 * D2_20
    R_2b = D1_01 * D2_21
    R_2d = D1_02 * D2_22
    R_2 = R_2a + R_2b + R_2d
    R_3a = D1_10 * D2_00
    R_3b = D1_11 * D2_01
    R_3d = D1_12 * D2_02
    R_3 = R_3a + R_3b + R_3d
    R_4a = D1_10 * D2_10
    R_4b = D1_11 * D2_11
    R_4d = D1_12 * D2_12
    R_4 = R_4a + R_4b + R_4d
    R_5a = D1_10 * D2_20
    R_5b = D1_11 * D2_21
    R_5d = D1_12 * D2_22
    R_5 = R_5a + R_5b + R_5d
    R_6a = D1_20 * D2_00
    R_6b = D1_21 * D2_01
    R_6d = D1_22 * D2_02
    R_6 = R_6a + R_6b + R_6d
    R_7a = D1_20 * D2_10
    R_7b = D1_21 * D2_11
    R_7d = D1_22 * D2_12
    R_7 = R_7a + R_7b + R_7d
    R_8a = D1_20 * D2_20
    R_8b = D1_21 * D2_21
    R_8d = D1_22 * D2_22
    R_8 = R_8a + R_8b + R_8d
    Do_03 = D1_03 - (D2_03 * R_0 + D2_13 * R_1 + D2_23 * R_2)
    Do_13 = D1_13 - (D2_03 * R_3 + D2_13 * R_4 + D2_23 * R_5)
    Do_23 = D1_23 - (D2_03 * R_6 + D2_13 * R_7 + D2_23 * R_8)
    R_0_size = absolute(R_0a) + absolute(R_0b) + absolute(R_0d)
    R_1_size = absolute(R_1a) + absolute(R_1b) + absolute(R_1d)
    R_2_size = absolute(R_2a) + absolute(R_2b) + absolute(R_2d)
    R_3_size = absolute(R_3a) + absolute(R_3b) + absolute(R_3d)
    R_4_size = absolute(R_4a) + absolute(R_4b) + absolute(R_4d)
    R_5_size = absolute(R_5a) + absolute(R_5b) + absolute(R_5d)
    R_6_size = absolute(R_6a) + absolute(R_6b) + absolute(R_6d)
    R_7_size = absolute(R_7a) + absolute(R_7b) + absolute(R_7d)
    R_8_size = absolute(R_8a) + absolute(R_8b) + absolute(R_8d)
    R_0_padded = R_0_size + c1
    D2_03_abs = absolute(D2_03)
    R_1_padded = R_1_size + c1
    D2_13_abs = absolute(D2_13)
    R_2_padded = R_2_size + c1
    D2_23_abs = absolute(D2_23)
    Do_03_size = (absolute(D1_03)
        + (D2_03_abs * R_0_padded + D2_13_abs * R_1_padded + D2_23_abs * R_2_padded))
    R_3_padded = R_3_size + c1
    R_4_padded = R_4_size + c1
    R_5_padded = R_5_size + c1
    Do_13_size = (absolute(D1_13)
        + (D2_03_abs * R_3_padded + D2_13_abs * R_4_padded + D2_23_abs * R_5_padded))
    R_6_padded = R_6_size + c1
    R_7_padded = R_7_size + c1
    R_8_padded = R_8_size + c1
    Do_23_size = (absolute(D1_23)
        + (D2_03_abs * R_6_padded + D2_13_abs * R_7_padded + D2_23_abs * R_8_padded))
    R_0_bound = c2 * R_0_padded
    R_1_bound = c2 * R_1_padded
    R_2_bound = c2 * R_2_padded
    Do_03_bound = c3 * (Do_03_size + c1)
    R_3_bound = c2 * R_3_padded
    R_4_bound = c2 * R_4_padded
    R_5_bound = c2 * R_5_padded
    Do_13_bound = c3 * (Do_13_size + c1)
    R_6_bound = c2 * R_6_padded
    R_7_bound = c2 * R_7_padded
    R_8_bound = c2 * R_8_padded
    Do_23_bound = c3 * (Do_23_size + c1)
    return (R_0, R_1, R_2, Do_03, R_3, R_4, R_5, Do_13, R_6, R_7, R_8, Do_23, R_0_bound, R_1_bound,
        R_2_bound, Do_03_bound, R_3_bound, R_4_bound, R_5_bound, Do_13_bound, R_6_bound, R_7_bound,
        R_8_bound, Do_23_bound)


@kernel("(3,4),(3,4)->(3,4),(3,4)")
@errstate(all="ignore")
def product_dinvd(D1, D2, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=4.440892098500628e-16):
    """Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,4)->(3,4),(3,4).  D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
    57 mul, 63 add, 39 abs.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    p_0 = D2_03 - D1_03
    p_1 = D2_13 - D1_13
    p_2 = D2_23 - D1_23
    Do_00a = D1_00 * D2_00
    Do_00b = D1_10 * D2_10
    Do_00d = D1_20 * D2_20
    Do_00 = Do_00a + Do_00b + Do_00d
    Do_01a = D1_00 * D2_01
    Do_01b = D1_10 * D2_11
    Do_01d = D1_20 * D2_21
    Do_01 = Do_01a + Do_01b + Do_01d
    Do_02a = D1_00 * D2_02
    Do_02b = D1_10 * D2_12
    Do_02d = D1_20 * D2_22
    Do_02 = Do_02a + Do_02b + Do_02d
    Do_03 = D1_00 * p_0 + D1_10 * p_1 + D1_20 * p_2
    Do_10a = D1_01 * D2_00
    Do_10b = D1_11 * D2_10
    Do_10d = D1_21 * D2_20
    Do_10 = Do_10a + Do_10b + Do_10d
    Do_11a = D1_01 * D2_01
    Do_11b = D1_11 * D2_11
    Do_11d = D1_21 * D2_21
    Do_11 = Do_11a + Do_11b + Do_11d
    Do_12a = D1_01 * D2_02
    Do_12b = D1_11 * D2_12
    Do_12d = D1_21 * D2_22
    Do_12 = Do_12a + Do_12b + Do_12d
    Do_13 = D1_01 * p_0 + D1_11 * p_1 + D1_21 * p_2
    Do_20a = D1_02 * D2_00
    Do_20b = D1_12 * D2_10
    Do_20d = D1_22 * D2_20
    Do_20 = Do_20a + Do_20b + Do_20d
    Do_21a = D1_02 * D2_01
    Do_21b = D1_12 * D2_11
    Do_21d = D1_22 * D2_21
    Do_21 = Do_21a + Do_21b + Do_21d
    Do_22a = D1_02 * D2_02
    Do_22b = D1_12 * D2_12
    Do_22d = D1_22 * D2_22
    Do_22 = Do_22a + Do_22b + Do_22d
    Do_23 = D1_02 * p_0 + D1_12 * p_1 + D1_22 * p_2
    Do_00_size = absolute(Do_00a) + absolute(Do_00b) + absolute(Do_00d)
    Do_01_size = absolute(Do_01a) + absolute(Do_01b) + absolute(Do_01d)
    Do_02_size = absolute(Do_02a) + absolute(Do_02b) + absolute(Do_02d)
    p_0_abs = absolute(p_0)
    p_1_abs = absolute(p_1)
    p_2_abs = absolute(p_2)
    Do_03_size = absolute(D1_00) * p_0_abs + absolute(D1_10) * p_1_abs + absolute(D1_20) * p_2_abs
    Do_10_size = absolute(Do_10a) + absolute(Do_10b) + absolute(Do_10d)
    Do_11_size = absolute(Do_11a) + absolute(Do_11b) + absolute(Do_11d)
    Do_12_size = absolute(Do_12a) + absolute(Do_12b) + absolute(Do_12d)
    Do_13_size = absolute(D1_01) * p_0_abs + absolute(D1_11) * p_1_abs + absolute(D1_21) * p_2_abs
    Do_20_size = absolute(Do_20a) + absolute(Do_20b) + absolute(Do_20d)
    Do_21_size = absolute(Do_21a) + absolute(Do_21b) + absolute(Do_21d)
    Do_22_size = absolute(Do_22a) + absolute(Do_22b) + absolute(Do_22d)
    Do_23_size = absolute(D1_02) * p_0_abs + absolute(D1_12) * p_1_abs + absolute(D1_22) * p_2_abs
    Do_00_bound = c2 * (Do_00_size + c1)
    Do_01_bound = c2 * (Do_01_size + c1)
    Do_02_bound = c2 * (Do_02_size + c1)
    Do_03_bound = c3 * (Do_03_size + c1)
    Do_10_bound = c2 * (Do_10_size + c1)
    Do_11_bound = c2 * (Do_11_size + c1)
    Do_12_bound = c2 * (Do_12_size + c1)
    Do_13_bound = c3 * (Do_13_size + c1)
    Do_20_bound = c2 * (Do_20_size + c1)
    Do_21_bound = c2 * (Do_21_size + c1)
    Do_22_bound = c2 * (Do_22_size + c1)
    Do_23_bound = c3 * (Do_23_size + c1)
    return (Do_00, Do_01, Do_02, Do_03, Do_10, Do_11, Do_12, Do_13, Do_20, Do_21, Do_22, Do_23,
        Do_00_bound, Do_01_bound, Do_02_bound, Do_03_bound, Do_10_bound, Do_11_bound, Do_12_bound,
        Do_13_bound, Do_20_bound, Do_21_bound, Do_22_bound, Do_23_bound)


@kernel("(3,4),(3,3)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddr(D, R, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; R:
    rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    Do_00a = D_00 * R_00
    Do_00b = D_01 * R_10
    Do_00d = D_02 * R_20
    Do_00 = Do_00a + Do_00b + Do_00d
    Do_01a = D_00 * R_01
    Do_01b = D_01 * R_11
    Do_01d = D_02 * R_21
    Do_01 = Do_01a + Do_01b + Do_01d
    Do_02a = D_00 * R_02
    Do_02b = D_01 * R_12
    Do_02d = D_02 * R_22
    Do_02 = Do_02a + Do_02b + Do_02d
    Do_10a = D_10 * R_00
    Do_10b = D_11 * R_10
    Do_10d = D_12 * R_20
    Do_10 = Do_10a + Do_10b + Do_10d
    Do_11a = D_10 * R_01
    Do_11b = D_11 * R_11
    Do_11d = D_12 * R_21
    Do_11 = Do_11a + Do_11b + Do_11d
    Do_12a = D_10 * R_02
    Do_12b = D_11 * R_12
    Do_12d = D_12 * R_22
    Do_12 = Do_12a + Do_12b + Do_12d
    Do_20a = D_20 * R_00
    Do_20b = D_21 * R_10
    Do_20d = D_22 * R_20
    Do_20 = Do_20a + Do_20b + Do_20d
    Do_21a = D_20 * R_01
    Do_21b = D_21 * R_11
    Do_21d = D_22 * R_21
    Do_21 = Do_21a + Do_21b + Do_21d
    Do_22a = D_20 * R_02
    Do_22b = D_21 * R_12
    Do_22d = D_22 * R_22
    Do_22 = Do_22a + Do_22b + Do_22d
    Do_00_size = absolute(Do_00a) + absolute(Do_00b) + absolute(Do_00d)
    Do_01_size = absolute(Do_01a) + absolute(Do_01b) + absolute(Do_01d)
    Do_02_size = absolute(Do_02a) + absolute(Do_02b) + absolute(Do_02d)
    Do_10_size = absolute(Do_10a) + absolute(Do_10b) + absolute(Do_10d)
    Do_11_size = absolute(Do_11a) + absolute(Do_11b) + absolute(Do_11d)
    Do_12_size = absolute(Do_12a) + absolute(Do_12b) + absolute(Do_12d)
    Do_20_size = absolute(Do_20a) + absolute(Do_20b) + absolute(Do_20d)
    Do_21_size = absolute(Do_21a) + absolute(Do_21b) + absolute(Do_21d)
    Do_22_size = absolute(Do_22a) + absolute(Do_22b) + absolute(Do_22d)
    Do_00_bound = c2 * (Do_00_size + c1)
    Do_01_bound = c2 * (Do_01_size + c1)
    Do_02_bound = c2 * (Do_02_size + c1)
    Do_10_bound = c2 * (Do_10_size + c1)
    Do_11_bound = c2 * (Do_11_size + c1)
    Do_12_bound = c2 * (Do_12_size + c1)
    Do_20_bound = c2 * (Do_20_size + c1)
    Do_21_bound = c2 * (Do_21_size + c1)
    Do_22_bound = c2 * (Do_22_size + c1)
    return (Do_00, Do_01, Do_02, D_03, Do_10, Do_11, Do_12, D_13, Do_20, Do_21, Do_22, D_23,
        Do_00_bound, Do_01_bound, Do_02_bound, 0, Do_10_bound, Do_11_bound, Do_12_bound, 0,
        Do_20_bound, Do_21_bound, Do_22_bound, 0)


@kernel("(3,4),(3,3)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddrinv(D, R, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3,3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; R:
    rotation or other 3×3 matrix.
    36 mul, 45 add, 27 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    Do_00a = D_00 * R_00
    Do_00b = D_01 * R_01
    Do_00d = D_02 * R_02
    Do_00 = Do_00a + Do_00b + Do_00d
    Do_01a = D_00 * R_10
    Do_01b = D_01 * R_11
    Do_01d = D_02 * R_12
    Do_01 = Do_01a + Do_01b + Do_01d
    Do_02a = D_00 * R_20
    Do_02b = D_01 * R_21
    Do_02d = D_02 * R_22
    Do_02 = Do_02a + Do_02b + Do_02d
    Do_10a = D_10 * R_00
    Do_10b = D_11 * R_01
    Do_10d = D_12 * R_02
    Do_10 = Do_10a + Do_10b + Do_10d
    Do_11a = D_10 * R_10
    Do_11b = D_11 * R_11
    Do_11d = D_12 * R_12
    Do_11 = Do_11a + Do_11b + Do_11d
    Do_12a = D_10 * R_20
    Do_12b = D_11 * R_21
    Do_12d = D_12 * R_22
    Do_12 = Do_12a + Do_12b + Do_12d
    Do_20a = D_20 * R_00
    Do_20b = D_21 * R_01
    Do_20d = D_22 * R_02
    Do_20 = Do_20a + Do_20b + Do_20d
    Do_21a = D_20 * R_10
    Do_21b = D_21 * R_11
    Do_21d = D_22 * R_12
    Do_21 = Do_21a + Do_21b + Do_21d
    Do_22a = D_20 * R_20
    Do_22b = D_21 * R_21
    Do_22d = D_22 * R_22
    Do_22 = Do_22a + Do_22b + Do_22d
    Do_00_size = absolute(Do_00a) + absolute(Do_00b) + absolute(Do_00d)
    Do_01_size = absolute(Do_01a) + absolute(Do_01b) + absolute(Do_01d)
    Do_02_size = absolute(Do_02a) + absolute(Do_02b) + absolute(Do_02d)
    Do_10_size = absolute(Do_10a) + absolute(Do_10b) + absolute(Do_10d)
    Do_11_size = absolute(Do_11a) + absolute(Do_11b) + absolute(Do_11d)
    Do_12_size = absolute(Do_12a) + absolute(Do_12b) + absolute(Do_12d)
    Do_20_size = absolute(Do_20a) + absolute(Do_20b) + absolute(Do_20d)
    Do_21_size = absolute(Do_21a) + absolute(Do_21b) + absolute(Do_21d)
    Do_22_size = absolute(Do_22a) + absolute(Do_22b) + absolute(Do_22d)
    Do_00_bound = c2 * (Do_00_size + c1)
    Do_01_bound = c2 * (Do_01_size + c1)
    Do_02_bound = c2 * (Do_02_size + c1)
    Do_10_bound = c2 * (Do_10_size + c1)
    Do_11_bound = c2 * (Do_11_size + c1)
    Do_12_bound = c2 * (Do_12_size + c1)
    Do_20_bound = c2 * (Do_20_size + c1)
    Do_21_bound = c2 * (Do_21_size + c1)
    Do_22_bound = c2 * (Do_22_size + c1)
    return (Do_00, Do_01, Do_02, D_03, Do_10, Do_11, Do_12, D_13, Do_20, Do_21, Do_22, D_23,
        Do_00_bound, Do_01_bound, Do_02_bound, 0, Do_10_bound, Do_11_bound, Do_12_bound, 0,
        Do_20_bound, Do_21_bound, Do_22_bound, 0)


@kernel("(3,4),(3)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddt(D, t, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:
    vector.
    12 mul, 21 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    t_0, t_1, t_2 = t
    Do_03a = D_00 * t_0
    Do_03b = D_01 * t_1
    Do_03d = D_02 * t_2
    Do_03 = Do_03a + Do_03b + Do_03d + D_03
    Do_13a = D_10 * t_0
    Do_13b = D_11 * t_1
    Do_13d = D_12 * t_2
    Do_13 = Do_13a + Do_13b + Do_13d + D_13
    Do_23a = D_20 * t_0
    Do_23b = D_21 * t_1
    Do_23d = D_22 * t_2
    Do_23 = Do_23a + Do_23b + Do_23d + D_23
    Do_03_size = absolute(Do_03a) + absolute(Do_03b) + absolute(Do_03d) + absolute(D_03)
    Do_13_size = absolute(Do_13a) + absolute(Do_13b) + absolute(Do_13d) + absolute(D_13)
    Do_23_size = absolute(Do_23a) + absolute(Do_23b) + absolute(Do_23d) + absolute(D_23)
    Do_03_bound = c2 * (Do_03_size + c1)
    Do_13_bound = c2 * (Do_13_size + c1)
    Do_23_bound = c2 * (Do_23_size + c1)
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23, 0, 0, 0,
        Do_03_bound, 0, 0, 0, Do_13_bound, 0, 0, 0, Do_23_bound)


@kernel("(3,4),(3)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddtinv(D, t, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:
    vector.
    12 mul, 21 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    t_0, t_1, t_2 = t
    Do_03a = D_00 * t_0
    Do_03b = D_01 * t_1
    Do_03d = D_02 * t_2
    Do_03 = D_03 - (Do_03a + Do_03b + Do_03d)
    Do_13a = D_10 * t_0
    Do_13b = D_11 * t_1
    Do_13d = D_12 * t_2
    Do_13 = D_13 - (Do_13a + Do_13b + Do_13d)
    Do_23a = D_20 * t_0
    Do_23b = D_21 * t_1
    Do_23d = D_22 * t_2
    Do_23 = D_23 - (Do_23a + Do_23b + Do_23d)
    Do_03_size = absolute(D_03) + (absolute(Do_03a) + absolute(Do_03b) + absolute(Do_03d))
    Do_13_size = absolute(D_13) + (absolute(Do_13a) + absolute(Do_13b) + absolute(Do_13d))
    Do_23_size = absolute(D_23) + (absolute(Do_23a) + absolute(Do_23b) + absolute(Do_23d))
    Do_03_bound = c2 * (Do_03_size + c1)
    Do_13_bound = c2 * (Do_13_size + c1)
    Do_23_bound = c2 * (Do_23_size + c1)
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23, 0, 0, 0,
        Do_03_bound, 0, 0, 0, Do_13_bound, 0, 0, 0, Do_23_bound)


@kernel("(3,4),(3)->(3,4),(3,4)")
@errstate(all="ignore")
def product_dinvdt(D, t, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(3)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; t:
    vector.
    21 mul, 18 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    t_0, t_1, t_2 = t
    p_0 = t_0 - D_03
    p_1 = t_1 - D_13
    p_2 = t_2 - D_23
    Do_03 = D_00 * p_0 + D_10 * p_1 + D_20 * p_2
    Do_13 = D_01 * p_0 + D_11 * p_1 + D_21 * p_2
    Do_23 = D_02 * p_0 + D_12 * p_1 + D_22 * p_2
    p_0_abs = absolute(p_0)
    p_1_abs = absolute(p_1)
    p_2_abs = absolute(p_2)
    Do_03_size = absolute(D_00) * p_0_abs + absolute(D_10) * p_1_abs + absolute(D_20) * p_2_abs
    Do_13_size = absolute(D_01) * p_0_abs + absolute(D_11) * p_1_abs + absolute(D_21) * p_2_abs
    Do_23_size = absolute(D_02) * p_0_abs + absolute(D_12) * p_1_abs + absolute(D_22) * p_2_abs
    Do_03_bound = c2 * (Do_03_size + c1)
    Do_13_bound = c2 * (Do_13_size + c1)
    Do_23_bound = c2 * (Do_23_size + c1)
    return (D_00, D_10, D_20, Do_03, D_01, D_11, D_21, Do_13, D_02, D_12, D_22, Do_23, 0, 0, 0,
        Do_03_bound, 0, 0, 0, Do_13_bound, 0, 0, 0, Do_23_bound)


@kernel("(3,3),()->(3),(3)")
@errstate(all="ignore")
def product_drvtx(R, k, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = R_00 * k
    vo_1 = R_10 * k
    vo_2 = R_20 * k
    vo_0_bound = c2 * (absolute(vo_0) + c1)
    vo_1_bound = c2 * (absolute(vo_1) + c1)
    vo_2_bound = c2 * (absolute(vo_2) + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3,3),(2)->(3,3),(3,3)")
@errstate(all="ignore")
def product_drdrx(R, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Ro = R R_x(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_01a = R_01 * dc_1
    Ro_01b = R_02 * dc_0
    Ro_01 = Ro_01a + Ro_01b
    Ro_02a = R_02 * dc_1
    Ro_02b = R_01 * dc_0
    Ro_02 = Ro_02a - Ro_02b
    Ro_11a = R_11 * dc_1
    Ro_11b = R_12 * dc_0
    Ro_11 = Ro_11a + Ro_11b
    Ro_12a = R_12 * dc_1
    Ro_12b = R_11 * dc_0
    Ro_12 = Ro_12a - Ro_12b
    Ro_21a = R_21 * dc_1
    Ro_21b = R_22 * dc_0
    Ro_21 = Ro_21a + Ro_21b
    Ro_22a = R_22 * dc_1
    Ro_22b = R_21 * dc_0
    Ro_22 = Ro_22a - Ro_22b
    Ro_01_size = absolute(Ro_01a) + absolute(Ro_01b)
    Ro_02_size = absolute(Ro_02a) + absolute(Ro_02b)
    Ro_11_size = absolute(Ro_11a) + absolute(Ro_11b)
    Ro_12_size = absolute(Ro_12a) + absolute(Ro_12b)
    Ro_21_size = absolute(Ro_21a) + absolute(Ro_21b)
    Ro_22_size = absolute(Ro_22a) + absolute(Ro_22b)
    Ro_01_bound = c2 * (Ro_01_size + c1)
    Ro_02_bound = c2 * (Ro_02_size + c1)
    Ro_11_bound = c2 * (Ro_11_size + c1)
    Ro_12_bound = c2 * (Ro_12_size + c1)
    Ro_21_bound = c2 * (Ro_21_size + c1)
    Ro_22_bound = c2 * (Ro_22_size + c1)
    return (R_00, Ro_01, Ro_02, R_10, Ro_11, Ro_12, R_20, Ro_21, Ro_22, 0, Ro_01_bound, Ro_02_bound,
        0, Ro_11_bound, Ro_12_bound, 0, Ro_21_bound, Ro_22_bound)


@kernel("(3,4),(2)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddrx(D, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [R_x(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_01a = D_01 * dc_1
    Do_01b = D_02 * dc_0
    Do_01 = Do_01a + Do_01b
    Do_02a = D_02 * dc_1
    Do_02b = D_01 * dc_0
    Do_02 = Do_02a - Do_02b
    Do_11a = D_11 * dc_1
    Do_11b = D_12 * dc_0
    Do_11 = Do_11a + Do_11b
    Do_12a = D_12 * dc_1
    Do_12b = D_11 * dc_0
    Do_12 = Do_12a - Do_12b
    Do_21a = D_21 * dc_1
    Do_21b = D_22 * dc_0
    Do_21 = Do_21a + Do_21b
    Do_22a = D_22 * dc_1
    Do_22b = D_21 * dc_0
    Do_22 = Do_22a - Do_22b
    Do_01_size = absolute(Do_01a) + absolute(Do_01b)
    Do_02_size = absolute(Do_02a) + absolute(Do_02b)
    Do_11_size = absolute(Do_11a) + absolute(Do_11b)
    Do_12_size = absolute(Do_12a) + absolute(Do_12b)
    Do_21_size = absolute(Do_21a) + absolute(Do_21b)
    Do_22_size = absolute(Do_22a) + absolute(Do_22b)
    Do_01_bound = c2 * (Do_01_size + c1)
    Do_02_bound = c2 * (Do_02_size + c1)
    Do_11_bound = c2 * (Do_11_size + c1)
    Do_12_bound = c2 * (Do_12_size + c1)
    Do_21_bound = c2 * (Do_21_size + c1)
    Do_22_bound = c2 * (Do_22_size + c1)
    return (D_00, Do_01, Do_02, D_03, D_10, Do_11, Do_12, D_13, D_20, Do_21, Do_22, D_23, 0,
        Do_01_bound, Do_02_bound, 0, 0, Do_11_bound, Do_12_bound, 0, 0, Do_21_bound, Do_22_bound, 0)


@kernel("(3,4),()->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddtx(D, k, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [I | k e_x]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_00 * k
    Do_03 = Do_03a + D_03
    Do_13a = D_10 * k
    Do_13 = Do_13a + D_13
    Do_23a = D_20 * k
    Do_23 = Do_23a + D_23
    Do_03_size = absolute(Do_03a) + absolute(D_03)
    Do_13_size = absolute(Do_13a) + absolute(D_13)
    Do_23_size = absolute(Do_23a) + absolute(D_23)
    Do_03_bound = c2 * (Do_03_size + c1)
    Do_13_bound = c2 * (Do_13_size + c1)
    Do_23_bound = c2 * (Do_23_size + c1)
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23, 0, 0, 0,
        Do_03_bound, 0, 0, 0, Do_13_bound, 0, 0, 0, Do_23_bound)


@kernel("(3,3),()->(3),(3)")
@errstate(all="ignore")
def product_drvtxinv(R, k, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 neg, 3 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0a = R_00 * k
    vo_0 = -vo_0a
    vo_1a = R_10 * k
    vo_1 = -vo_1a
    vo_2a = R_20 * k
    vo_2 = -vo_2a
    vo_0a_bound = c2 * (absolute(vo_0a) + c1)
    vo_1a_bound = c2 * (absolute(vo_1a) + c1)
    vo_2a_bound = c2 * (absolute(vo_2a) + c1)
    return (vo_0, vo_1, vo_2, vo_0a_bound, vo_1a_bound, vo_2a_bound)


@kernel("(3,3),(2)->(3,3),(3,3)")
@errstate(all="ignore")
def product_drdrxinv(R, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Ro = R R_x(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_01a = R_01 * dc_1
    Ro_01b = R_02 * dc_0
    Ro_01 = Ro_01a - Ro_01b
    Ro_02a = R_01 * dc_0
    Ro_02b = R_02 * dc_1
    Ro_02 = Ro_02a + Ro_02b
    Ro_11a = R_11 * dc_1
    Ro_11b = R_12 * dc_0
    Ro_11 = Ro_11a - Ro_11b
    Ro_12a = R_11 * dc_0
    Ro_12b = R_12 * dc_1
    Ro_12 = Ro_12a + Ro_12b
    Ro_21a = R_21 * dc_1
    Ro_21b = R_22 * dc_0
    Ro_21 = Ro_21a - Ro_21b
    Ro_22a = R_21 * dc_0
    Ro_22b = R_22 * dc_1
    Ro_22 = Ro_22a + Ro_22b
    Ro_01_size = absolute(Ro_01a) + absolute(Ro_01b)
    Ro_02_size = absolute(Ro_02a) + absolute(Ro_02b)
    Ro_11_size = absolute(Ro_11a) + absolute(Ro_11b)
    Ro_12_size = absolute(Ro_12a) + absolute(Ro_12b)
    Ro_21_size = absolute(Ro_21a) + absolute(Ro_21b)
    Ro_22_size = absolute(Ro_22a) + absolute(Ro_22b)
    Ro_01_bound = c2 * (Ro_01_size + c1)
    Ro_02_bound = c2 * (Ro_02_size + c1)
    Ro_11_bound = c2 * (Ro_11_size + c1)
    Ro_12_bound = c2 * (Ro_12_size + c1)
    Ro_21_bound = c2 * (Ro_21_size + c1)
    Ro_22_bound = c2 * (Ro_22_size + c1)
    return (R_00, Ro_01, Ro_02, R_10, Ro_11, Ro_12, R_20, Ro_21, Ro_22, 0, Ro_01_bound, Ro_02_bound,
        0, Ro_11_bound, Ro_12_bound, 0, Ro_21_bound, Ro_22_bound)


@kernel("(3,4),(2)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddrxinv(D, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_01a = D_01 * dc_1
    Do_01b = D_02 * dc_0
    Do_01 = Do_01a - Do_01b
    Do_02a = D_01 * dc_0
    Do_02b = D_02 * dc_1
    Do_02 = Do_02a + Do_02b
    Do_11a = D_11 * dc_1
    Do_11b = D_12 * dc_0
    Do_11 = Do_11a - Do_11b
    Do_12a = D_11 * dc_0
    Do_12b = D_12 * dc_1
    Do_12 = Do_12a + Do_12b
    Do_21a = D_21 * dc_1
    Do_21b = D_22 * dc_0
    Do_21 = Do_21a - Do_21b
    Do_22a = D_21 * dc_0
    Do_22b = D_22 * dc_1
    Do_22 = Do_22a + Do_22b
    Do_01_size = absolute(Do_01a) + absolute(Do_01b)
    Do_02_size = absolute(Do_02a) + absolute(Do_02b)
    Do_11_size = absolute(Do_11a) + absolute(Do_11b)
    Do_12_size = absolute(Do_12a) + absolute(Do_12b)
    Do_21_size = absolute(Do_21a) + absolute(Do_21b)
    Do_22_size = absolute(Do_22a) + absolute(Do_22b)
    Do_01_bound = c2 * (Do_01_size + c1)
    Do_02_bound = c2 * (Do_02_size + c1)
    Do_11_bound = c2 * (Do_11_size + c1)
    Do_12_bound = c2 * (Do_12_size + c1)
    Do_21_bound = c2 * (Do_21_size + c1)
    Do_22_bound = c2 * (Do_22_size + c1)
    return (D_00, Do_01, Do_02, D_03, D_10, Do_11, Do_12, D_13, D_20, Do_21, Do_22, D_23, 0,
        Do_01_bound, Do_02_bound, 0, 0, Do_11_bound, Do_12_bound, 0, 0, Do_21_bound, Do_22_bound, 0)


@kernel("(3,4),()->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddtxinv(D, k, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [I | -k e_x]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_00 * k
    Do_03 = D_03 - Do_03a
    Do_13a = D_10 * k
    Do_13 = D_13 - Do_13a
    Do_23a = D_20 * k
    Do_23 = D_23 - Do_23a
    Do_03_size = absolute(D_03) + absolute(Do_03a)
    Do_13_size = absolute(D_13) + absolute(Do_13a)
    Do_23_size = absolute(D_23) + absolute(Do_23a)
    Do_03_bound = c2 * (Do_03_size + c1)
    Do_13_bound = c2 * (Do_13_size + c1)
    Do_23_bound = c2 * (Do_23_size + c1)
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23, 0, 0, 0,
        Do_03_bound, 0, 0, 0, Do_13_bound, 0, 0, 0, Do_23_bound)


@kernel("(3,3),()->(3),(3)")
@errstate(all="ignore")
def product_drvty(R, k, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = R_01 * k
    vo_1 = R_11 * k
    vo_2 = R_21 * k
    vo_0_bound = c2 * (absolute(vo_0) + c1)
    vo_1_bound = c2 * (absolute(vo_1) + c1)
    vo_2_bound = c2 * (absolute(vo_2) + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3,3),(2)->(3,3),(3,3)")
@errstate(all="ignore")
def product_drdry(R, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Ro = R R_y(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00a = R_00 * dc_1
    Ro_00b = R_02 * dc_0
    Ro_00 = Ro_00a - Ro_00b
    Ro_02a = R_00 * dc_0
    Ro_02b = R_02 * dc_1
    Ro_02 = Ro_02a + Ro_02b
    Ro_10a = R_10 * dc_1
    Ro_10b = R_12 * dc_0
    Ro_10 = Ro_10a - Ro_10b
    Ro_12a = R_10 * dc_0
    Ro_12b = R_12 * dc_1
    Ro_12 = Ro_12a + Ro_12b
    Ro_20a = R_20 * dc_1
    Ro_20b = R_22 * dc_0
    Ro_20 = Ro_20a - Ro_20b
    Ro_22a = R_20 * dc_0
    Ro_22b = R_22 * dc_1
    Ro_22 = Ro_22a + Ro_22b
    Ro_00_size = absolute(Ro_00a) + absolute(Ro_00b)
    Ro_02_size = absolute(Ro_02a) + absolute(Ro_02b)
    Ro_10_size = absolute(Ro_10a) + absolute(Ro_10b)
    Ro_12_size = absolute(Ro_12a) + absolute(Ro_12b)
    Ro_20_size = absolute(Ro_20a) + absolute(Ro_20b)
    Ro_22_size = absolute(Ro_22a) + absolute(Ro_22b)
    Ro_00_bound = c2 * (Ro_00_size + c1)
    Ro_02_bound = c2 * (Ro_02_size + c1)
    Ro_10_bound = c2 * (Ro_10_size + c1)
    Ro_12_bound = c2 * (Ro_12_size + c1)
    Ro_20_bound = c2 * (Ro_20_size + c1)
    Ro_22_bound = c2 * (Ro_22_size + c1)
    return (Ro_00, R_01, Ro_02, Ro_10, R_11, Ro_12, Ro_20, R_21, Ro_22, Ro_00_bound, 0, Ro_02_bound,
        Ro_10_bound, 0, Ro_12_bound, Ro_20_bound, 0, Ro_22_bound)


@kernel("(3,4),(2)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddry(D, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [R_y(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00a = D_00 * dc_1
    Do_00b = D_02 * dc_0
    Do_00 = Do_00a - Do_00b
    Do_02a = D_00 * dc_0
    Do_02b = D_02 * dc_1
    Do_02 = Do_02a + Do_02b
    Do_10a = D_10 * dc_1
    Do_10b = D_12 * dc_0
    Do_10 = Do_10a - Do_10b
    Do_12a = D_10 * dc_0
    Do_12b = D_12 * dc_1
    Do_12 = Do_12a + Do_12b
    Do_20a = D_20 * dc_1
    Do_20b = D_22 * dc_0
    Do_20 = Do_20a - Do_20b
    Do_22a = D_20 * dc_0
    Do_22b = D_22 * dc_1
    Do_22 = Do_22a + Do_22b
    Do_00_size = absolute(Do_00a) + absolute(Do_00b)
    Do_02_size = absolute(Do_02a) + absolute(Do_02b)
    Do_10_size = absolute(Do_10a) + absolute(Do_10b)
    Do_12_size = absolute(Do_12a) + absolute(Do_12b)
    Do_20_size = absolute(Do_20a) + absolute(Do_20b)
    Do_22_size = absolute(Do_22a) + absolute(Do_22b)
    Do_00_bound = c2 * (Do_00_size + c1)
    Do_02_bound = c2 * (Do_02_size + c1)
    Do_10_bound = c2 * (Do_10_size + c1)
    Do_12_bound = c2 * (Do_12_size + c1)
    Do_20_bound = c2 * (Do_20_size + c1)
    Do_22_bound = c2 * (Do_22_size + c1)
    return (Do_00, D_01, Do_02, D_03, Do_10, D_11, Do_12, D_13, Do_20, D_21, Do_22, D_23,
        Do_00_bound, 0, Do_02_bound, 0, Do_10_bound, 0, Do_12_bound, 0, Do_20_bound, 0, Do_22_bound,
        0)


@kernel("(3,4),()->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddty(D, k, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [I | k e_y]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_01 * k
    Do_03 = Do_03a + D_03
    Do_13a = D_11 * k
    Do_13 = Do_13a + D_13
    Do_23a = D_21 * k
    Do_23 = Do_23a + D_23
    Do_03_size = absolute(Do_03a) + absolute(D_03)
    Do_13_size = absolute(Do_13a) + absolute(D_13)
    Do_23_size = absolute(Do_23a) + absolute(D_23)
    Do_03_bound = c2 * (Do_03_size + c1)
    Do_13_bound = c2 * (Do_13_size + c1)
    Do_23_bound = c2 * (Do_23_size + c1)
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23, 0, 0, 0,
        Do_03_bound, 0, 0, 0, Do_13_bound, 0, 0, 0, Do_23_bound)


@kernel("(3,3),()->(3),(3)")
@errstate(all="ignore")
def product_drvtyinv(R, k, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 neg, 3 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0a = R_01 * k
    vo_0 = -vo_0a
    vo_1a = R_11 * k
    vo_1 = -vo_1a
    vo_2a = R_21 * k
    vo_2 = -vo_2a
    vo_0a_bound = c2 * (absolute(vo_0a) + c1)
    vo_1a_bound = c2 * (absolute(vo_1a) + c1)
    vo_2a_bound = c2 * (absolute(vo_2a) + c1)
    return (vo_0, vo_1, vo_2, vo_0a_bound, vo_1a_bound, vo_2a_bound)


@kernel("(3,3),(2)->(3,3),(3,3)")
@errstate(all="ignore")
def product_drdryinv(R, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Ro = R R_y(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00a = R_00 * dc_1
    Ro_00b = R_02 * dc_0
    Ro_00 = Ro_00a + Ro_00b
    Ro_02a = R_02 * dc_1
    Ro_02b = R_00 * dc_0
    Ro_02 = Ro_02a - Ro_02b
    Ro_10a = R_10 * dc_1
    Ro_10b = R_12 * dc_0
    Ro_10 = Ro_10a + Ro_10b
    Ro_12a = R_12 * dc_1
    Ro_12b = R_10 * dc_0
    Ro_12 = Ro_12a - Ro_12b
    Ro_20a = R_20 * dc_1
    Ro_20b = R_22 * dc_0
    Ro_20 = Ro_20a + Ro_20b
    Ro_22a = R_22 * dc_1
    Ro_22b = R_20 * dc_0
    Ro_22 = Ro_22a - Ro_22b
    Ro_00_size = absolute(Ro_00a) + absolute(Ro_00b)
    Ro_02_size = absolute(Ro_02a) + absolute(Ro_02b)
    Ro_10_size = absolute(Ro_10a) + absolute(Ro_10b)
    Ro_12_size = absolute(Ro_12a) + absolute(Ro_12b)
    Ro_20_size = absolute(Ro_20a) + absolute(Ro_20b)
    Ro_22_size = absolute(Ro_22a) + absolute(Ro_22b)
    Ro_00_bound = c2 * (Ro_00_size + c1)
    Ro_02_bound = c2 * (Ro_02_size + c1)
    Ro_10_bound = c2 * (Ro_10_size + c1)
    Ro_12_bound = c2 * (Ro_12_size + c1)
    Ro_20_bound = c2 * (Ro_20_size + c1)
    Ro_22_bound = c2 * (Ro_22_size + c1)
    return (Ro_00, R_01, Ro_02, Ro_10, R_11, Ro_12, Ro_20, R_21, Ro_22, Ro_00_bound, 0, Ro_02_bound,
        Ro_10_bound, 0, Ro_12_bound, Ro_20_bound, 0, Ro_22_bound)


@kernel("(3,4),(2)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddryinv(D, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00a = D_00 * dc_1
    Do_00b = D_02 * dc_0
    Do_00 = Do_00a + Do_00b
    Do_02a = D_02 * dc_1
    Do_02b = D_00 * dc_0
    Do_02 = Do_02a - Do_02b
    Do_10a = D_10 * dc_1
    Do_10b = D_12 * dc_0
    Do_10 = Do_10a + Do_10b
    Do_12a = D_12 * dc_1
    Do_12b = D_10 * dc_0
    Do_12 = Do_12a - Do_12b
    Do_20a = D_20 * dc_1
    Do_20b = D_22 * dc_0
    Do_20 = Do_20a + Do_20b
    Do_22a = D_22 * dc_1
    Do_22b = D_20 * dc_0
    Do_22 = Do_22a - Do_22b
    Do_00_size = absolute(Do_00a) + absolute(Do_00b)
    Do_02_size = absolute(Do_02a) + absolute(Do_02b)
    Do_10_size = absolute(Do_10a) + absolute(Do_10b)
    Do_12_size = absolute(Do_12a) + absolute(Do_12b)
    Do_20_size = absolute(Do_20a) + absolute(Do_20b)
    Do_22_size = absolute(Do_22a) + absolute(Do_22b)
    Do_00_bound = c2 * (Do_00_size + c1)
    Do_02_bound = c2 * (Do_02_size + c1)
    Do_10_bound = c2 * (Do_10_size + c1)
    Do_12_bound = c2 * (Do_12_size + c1)
    Do_20_bound = c2 * (Do_20_size + c1)
    Do_22_bound = c2 * (Do_22_size + c1)
    return (Do_00, D_01, Do_02, D_03, Do_10, D_11, Do_12, D_13, Do_20, D_21, Do_22, D_23,
        Do_00_bound, 0, Do_02_bound, 0, Do_10_bound, 0, Do_12_bound, 0, Do_20_bound, 0, Do_22_bound,
        0)


@kernel("(3,4),()->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddtyinv(D, k, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [I | -k e_y]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_01 * k
    Do_03 = D_03 - Do_03a
    Do_13a = D_11 * k
    Do_13 = D_13 - Do_13a
    Do_23a = D_21 * k
    Do_23 = D_23 - Do_23a
    Do_03_size = absolute(D_03) + absolute(Do_03a)
    Do_13_size = absolute(D_13) + absolute(Do_13a)
    Do_23_size = absolute(D_23) + absolute(Do_23a)
    Do_03_bound = c2 * (Do_03_size + c1)
    Do_13_bound = c2 * (Do_13_size + c1)
    Do_23_bound = c2 * (Do_23_size + c1)
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23, 0, 0, 0,
        Do_03_bound, 0, 0, 0, Do_13_bound, 0, 0, 0, Do_23_bound)


@kernel("(3,3),()->(3),(3)")
@errstate(all="ignore")
def product_drvtz(R, k, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0 = R_02 * k
    vo_1 = R_12 * k
    vo_2 = R_22 * k
    vo_0_bound = c2 * (absolute(vo_0) + c1)
    vo_1_bound = c2 * (absolute(vo_1) + c1)
    vo_2_bound = c2 * (absolute(vo_2) + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3,3),(2)->(3,3),(3,3)")
@errstate(all="ignore")
def product_drdrz(R, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Ro = R R_z(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00a = R_00 * dc_1
    Ro_00b = R_01 * dc_0
    Ro_00 = Ro_00a + Ro_00b
    Ro_01a = R_01 * dc_1
    Ro_01b = R_00 * dc_0
    Ro_01 = Ro_01a - Ro_01b
    Ro_10a = R_10 * dc_1
    Ro_10b = R_11 * dc_0
    Ro_10 = Ro_10a + Ro_10b
    Ro_11a = R_11 * dc_1
    Ro_11b = R_10 * dc_0
    Ro_11 = Ro_11a - Ro_11b
    Ro_20a = R_20 * dc_1
    Ro_20b = R_21 * dc_0
    Ro_20 = Ro_20a + Ro_20b
    Ro_21a = R_21 * dc_1
    Ro_21b = R_20 * dc_0
    Ro_21 = Ro_21a - Ro_21b
    Ro_00_size = absolute(Ro_00a) + absolute(Ro_00b)
    Ro_01_size = absolute(Ro_01a) + absolute(Ro_01b)
    Ro_10_size = absolute(Ro_10a) + absolute(Ro_10b)
    Ro_11_size = absolute(Ro_11a) + absolute(Ro_11b)
    Ro_20_size = absolute(Ro_20a) + absolute(Ro_20b)
    Ro_21_size = absolute(Ro_21a) + absolute(Ro_21b)
    Ro_00_bound = c2 * (Ro_00_size + c1)
    Ro_01_bound = c2 * (Ro_01_size + c1)
    Ro_10_bound = c2 * (Ro_10_size + c1)
    Ro_11_bound = c2 * (Ro_11_size + c1)
    Ro_20_bound = c2 * (Ro_20_size + c1)
    Ro_21_bound = c2 * (Ro_21_size + c1)
    return (Ro_00, Ro_01, R_02, Ro_10, Ro_11, R_12, Ro_20, Ro_21, R_22, Ro_00_bound, Ro_01_bound, 0,
        Ro_10_bound, Ro_11_bound, 0, Ro_20_bound, Ro_21_bound, 0)


@kernel("(3,4),(2)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddrz(D, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [R_z(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00a = D_00 * dc_1
    Do_00b = D_01 * dc_0
    Do_00 = Do_00a + Do_00b
    Do_01a = D_01 * dc_1
    Do_01b = D_00 * dc_0
    Do_01 = Do_01a - Do_01b
    Do_10a = D_10 * dc_1
    Do_10b = D_11 * dc_0
    Do_10 = Do_10a + Do_10b
    Do_11a = D_11 * dc_1
    Do_11b = D_10 * dc_0
    Do_11 = Do_11a - Do_11b
    Do_20a = D_20 * dc_1
    Do_20b = D_21 * dc_0
    Do_20 = Do_20a + Do_20b
    Do_21a = D_21 * dc_1
    Do_21b = D_20 * dc_0
    Do_21 = Do_21a - Do_21b
    Do_00_size = absolute(Do_00a) + absolute(Do_00b)
    Do_01_size = absolute(Do_01a) + absolute(Do_01b)
    Do_10_size = absolute(Do_10a) + absolute(Do_10b)
    Do_11_size = absolute(Do_11a) + absolute(Do_11b)
    Do_20_size = absolute(Do_20a) + absolute(Do_20b)
    Do_21_size = absolute(Do_21a) + absolute(Do_21b)
    Do_00_bound = c2 * (Do_00_size + c1)
    Do_01_bound = c2 * (Do_01_size + c1)
    Do_10_bound = c2 * (Do_10_size + c1)
    Do_11_bound = c2 * (Do_11_size + c1)
    Do_20_bound = c2 * (Do_20_size + c1)
    Do_21_bound = c2 * (Do_21_size + c1)
    return (Do_00, Do_01, D_02, D_03, Do_10, Do_11, D_12, D_13, Do_20, Do_21, D_22, D_23,
        Do_00_bound, Do_01_bound, 0, 0, Do_10_bound, Do_11_bound, 0, 0, Do_20_bound, Do_21_bound, 0,
        0)


@kernel("(3,4),()->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddtz(D, k, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [I | k e_z]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_02 * k
    Do_03 = Do_03a + D_03
    Do_13a = D_12 * k
    Do_13 = Do_13a + D_13
    Do_23a = D_22 * k
    Do_23 = Do_23a + D_23
    Do_03_size = absolute(Do_03a) + absolute(D_03)
    Do_13_size = absolute(Do_13a) + absolute(D_13)
    Do_23_size = absolute(Do_23a) + absolute(D_23)
    Do_03_bound = c2 * (Do_03_size + c1)
    Do_13_bound = c2 * (Do_13_size + c1)
    Do_23_bound = c2 * (Do_23_size + c1)
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23, 0, 0, 0,
        Do_03_bound, 0, 0, 0, Do_13_bound, 0, 0, 0, Do_23_bound)


@kernel("(3,3),()->(3),(3)")
@errstate(all="ignore")
def product_drvtzinv(R, k, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.

    (3,3),()->(3),(3).  R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
    6 mul, 3 add, 3 neg, 3 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    vo_0a = R_02 * k
    vo_0 = -vo_0a
    vo_1a = R_12 * k
    vo_1 = -vo_1a
    vo_2a = R_22 * k
    vo_2 = -vo_2a
    vo_0a_bound = c2 * (absolute(vo_0a) + c1)
    vo_1a_bound = c2 * (absolute(vo_1a) + c1)
    vo_2a_bound = c2 * (absolute(vo_2a) + c1)
    return (vo_0, vo_1, vo_2, vo_0a_bound, vo_1a_bound, vo_2a_bound)


@kernel("(3,3),(2)->(3,3),(3,3)")
@errstate(all="ignore")
def product_drdrzinv(R, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Ro = R R_z(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.

    (3,3),(2)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    dc_0, dc_1 = dc
    Ro_00a = R_00 * dc_1
    Ro_00b = R_01 * dc_0
    Ro_00 = Ro_00a - Ro_00b
    Ro_01a = R_00 * dc_0
    Ro_01b = R_01 * dc_1
    Ro_01 = Ro_01a + Ro_01b
    Ro_10a = R_10 * dc_1
    Ro_10b = R_11 * dc_0
    Ro_10 = Ro_10a - Ro_10b
    Ro_11a = R_10 * dc_0
    Ro_11b = R_11 * dc_1
    Ro_11 = Ro_11a + Ro_11b
    Ro_20a = R_20 * dc_1
    Ro_20b = R_21 * dc_0
    Ro_20 = Ro_20a - Ro_20b
    Ro_21a = R_20 * dc_0
    Ro_21b = R_21 * dc_1
    Ro_21 = Ro_21a + Ro_21b
    Ro_00_size = absolute(Ro_00a) + absolute(Ro_00b)
    Ro_01_size = absolute(Ro_01a) + absolute(Ro_01b)
    Ro_10_size = absolute(Ro_10a) + absolute(Ro_10b)
    Ro_11_size = absolute(Ro_11a) + absolute(Ro_11b)
    Ro_20_size = absolute(Ro_20a) + absolute(Ro_20b)
    Ro_21_size = absolute(Ro_21a) + absolute(Ro_21b)
    Ro_00_bound = c2 * (Ro_00_size + c1)
    Ro_01_bound = c2 * (Ro_01_size + c1)
    Ro_10_bound = c2 * (Ro_10_size + c1)
    Ro_11_bound = c2 * (Ro_11_size + c1)
    Ro_20_bound = c2 * (Ro_20_size + c1)
    Ro_21_bound = c2 * (Ro_21_size + c1)
    return (Ro_00, Ro_01, R_02, Ro_10, Ro_11, R_12, Ro_20, Ro_21, R_22, Ro_00_bound, Ro_01_bound, 0,
        Ro_10_bound, Ro_11_bound, 0, Ro_20_bound, Ro_21_bound, 0)


@kernel("(3,4),(2)->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddrzinv(D, dc, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.

    (3,4),(2)->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin
    θ, cos θ).
    18 mul, 18 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    dc_0, dc_1 = dc
    Do_00a = D_00 * dc_1
    Do_00b = D_01 * dc_0
    Do_00 = Do_00a - Do_00b
    Do_01a = D_00 * dc_0
    Do_01b = D_01 * dc_1
    Do_01 = Do_01a + Do_01b
    Do_10a = D_10 * dc_1
    Do_10b = D_11 * dc_0
    Do_10 = Do_10a - Do_10b
    Do_11a = D_10 * dc_0
    Do_11b = D_11 * dc_1
    Do_11 = Do_11a + Do_11b
    Do_20a = D_20 * dc_1
    Do_20b = D_21 * dc_0
    Do_20 = Do_20a - Do_20b
    Do_21a = D_20 * dc_0
    Do_21b = D_21 * dc_1
    Do_21 = Do_21a + Do_21b
    Do_00_size = absolute(Do_00a) + absolute(Do_00b)
    Do_01_size = absolute(Do_01a) + absolute(Do_01b)
    Do_10_size = absolute(Do_10a) + absolute(Do_10b)
    Do_11_size = absolute(Do_11a) + absolute(Do_11b)
    Do_20_size = absolute(Do_20a) + absolute(Do_20b)
    Do_21_size = absolute(Do_21a) + absolute(Do_21b)
    Do_00_bound = c2 * (Do_00_size + c1)
    Do_01_bound = c2 * (Do_01_size + c1)
    Do_10_bound = c2 * (Do_10_size + c1)
    Do_11_bound = c2 * (Do_11_size + c1)
    Do_20_bound = c2 * (Do_20_size + c1)
    Do_21_bound = c2 * (Do_21_size + c1)
    return (Do_00, Do_01, D_02, D_03, Do_10, Do_11, D_12, D_13, Do_20, Do_21, D_22, D_23,
        Do_00_bound, Do_01_bound, 0, 0, Do_10_bound, Do_11_bound, 0, 0, Do_20_bound, Do_21_bound, 0,
        0)


@kernel("(3,4),()->(3,4),(3,4)")
@errstate(all="ignore")
def product_ddtzinv(D, k, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Do = D [I | -k e_z]; |error of Do| <= Do_bound unless inf or NaN.

    (3,4),()->(3,4),(3,4).  D, Do, Do_bound: displacement [R | t], R rotation, t in m; k:
    number.
    6 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03a = D_02 * k
    Do_03 = D_03 - Do_03a
    Do_13a = D_12 * k
    Do_13 = D_13 - Do_13a
    Do_23a = D_22 * k
    Do_23 = D_23 - Do_23a
    Do_03_size = absolute(D_03) + absolute(Do_03a)
    Do_13_size = absolute(D_13) + absolute(Do_13a)
    Do_23_size = absolute(D_23) + absolute(Do_23a)
    Do_03_bound = c2 * (Do_03_size + c1)
    Do_13_bound = c2 * (Do_13_size + c1)
    Do_23_bound = c2 * (Do_23_size + c1)
    return (D_00, D_01, D_02, Do_03, D_10, D_11, D_12, Do_13, D_20, D_21, D_22, Do_23, 0, 0, 0,
        Do_03_bound, 0, 0, 0, Do_13_bound, 0, 0, 0, Do_23_bound)
