# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Coscrews: wrenches and momenta, c = (f; τ).

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(6),()->(6),(6)")
@errstate(all="ignore")
def coscrew_scale(self, a, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (6),()->(6),(6).  self, self_bound: coscrew (f in N; τ in N m); a: number.
    12 mul, 6 add, 6 abs.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_4_new = self_4 * a
    self_5_new = self_5 * a
    self_0_new_bound = c2 * (absolute(self_0_new) + c1)
    self_1_new_bound = c2 * (absolute(self_1_new) + c1)
    self_2_new_bound = c2 * (absolute(self_2_new) + c1)
    self_3_new_bound = c2 * (absolute(self_3_new) + c1)
    self_4_new_bound = c2 * (absolute(self_4_new) + c1)
    self_5_new_bound = c2 * (absolute(self_5_new) + c1)
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new,
        self_0_new_bound, self_1_new_bound, self_2_new_bound, self_3_new_bound, self_4_new_bound,
        self_5_new_bound)


@kernel("(),(6),(6)->(6),(6)")
@errstate(all="ignore")
def axpy_cc(a, x, y, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """y = a x + y; |error of y| <= y_bound unless inf or NaN.

    (),(6),(6)->(6),(6).  a: number; x, y, y_bound: coscrew (f in N; τ in N m).
    12 mul, 18 add, 12 abs.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new_a = a * x_0
    y_0_new = y_0_new_a + y_0
    y_1_new_a = a * x_1
    y_1_new = y_1_new_a + y_1
    y_2_new_a = a * x_2
    y_2_new = y_2_new_a + y_2
    y_3_new_a = a * x_3
    y_3_new = y_3_new_a + y_3
    y_4_new_a = a * x_4
    y_4_new = y_4_new_a + y_4
    y_5_new_a = a * x_5
    y_5_new = y_5_new_a + y_5
    y_0_new_size = absolute(y_0_new_a) + absolute(y_0)
    y_1_new_size = absolute(y_1_new_a) + absolute(y_1)
    y_2_new_size = absolute(y_2_new_a) + absolute(y_2)
    y_3_new_size = absolute(y_3_new_a) + absolute(y_3)
    y_4_new_size = absolute(y_4_new_a) + absolute(y_4)
    y_5_new_size = absolute(y_5_new_a) + absolute(y_5)
    y_0_new_bound = c2 * (y_0_new_size + c1)
    y_1_new_bound = c2 * (y_1_new_size + c1)
    y_2_new_bound = c2 * (y_2_new_size + c1)
    y_3_new_bound = c2 * (y_3_new_size + c1)
    y_4_new_bound = c2 * (y_4_new_size + c1)
    y_5_new_bound = c2 * (y_5_new_size + c1)
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_4_new, y_5_new, y_0_new_bound, y_1_new_bound,
        y_2_new_bound, y_3_new_bound, y_4_new_bound, y_5_new_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def xpy_cc(x, y, *, c1=1.1102230246251568e-16):
    """y = x + y; |error of y| <= y_bound unless inf or NaN.

    (6),(6)->(6),(6).  x, y, y_bound: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 abs.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new = x_0 + y_0
    y_1_new = x_1 + y_1
    y_2_new = x_2 + y_2
    y_3_new = x_3 + y_3
    y_4_new = x_4 + y_4
    y_5_new = x_5 + y_5
    y_0_new_bound = c1 * absolute(y_0_new)
    y_1_new_bound = c1 * absolute(y_1_new)
    y_2_new_bound = c1 * absolute(y_2_new)
    y_3_new_bound = c1 * absolute(y_3_new)
    y_4_new_bound = c1 * absolute(y_4_new)
    y_5_new_bound = c1 * absolute(y_5_new)
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_4_new, y_5_new, y_0_new_bound, y_1_new_bound,
        y_2_new_bound, y_3_new_bound, y_4_new_bound, y_5_new_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def nxpy_cc(x, y, *, c1=1.1102230246251568e-16):
    """y = -x + y; |error of y| <= y_bound unless inf or NaN.

    (6),(6)->(6),(6).  x, y, y_bound: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 abs.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new = y_0 - x_0
    y_1_new = y_1 - x_1
    y_2_new = y_2 - x_2
    y_3_new = y_3 - x_3
    y_4_new = y_4 - x_4
    y_5_new = y_5 - x_5
    y_0_new_bound = c1 * absolute(y_0_new)
    y_1_new_bound = c1 * absolute(y_1_new)
    y_2_new_bound = c1 * absolute(y_2_new)
    y_3_new_bound = c1 * absolute(y_3_new)
    y_4_new_bound = c1 * absolute(y_4_new)
    y_5_new_bound = c1 * absolute(y_5_new)
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_4_new, y_5_new, y_0_new_bound, y_1_new_bound,
        y_2_new_bound, y_3_new_bound, y_4_new_bound, y_5_new_bound)


@kernel("(),(6)->(6),(6)")
@errstate(all="ignore")
def product_ac(a, ci, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """co = a ci; |error of co| <= co_bound unless inf or NaN.

    (),(6)->(6),(6).  a: number; ci, co, co_bound: coscrew (f in N; τ in N m).
    12 mul, 6 add, 6 abs.
    """
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0 = a * ci_0
    co_1 = a * ci_1
    co_2 = a * ci_2
    co_3 = a * ci_3
    co_4 = a * ci_4
    co_5 = a * ci_5
    co_0_bound = c2 * (absolute(co_0) + c1)
    co_1_bound = c2 * (absolute(co_1) + c1)
    co_2_bound = c2 * (absolute(co_2) + c1)
    co_3_bound = c2 * (absolute(co_3) + c1)
    co_4_bound = c2 * (absolute(co_4) + c1)
    co_5_bound = c2 * (absolute(co_5) + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0_bound, co_1_bound, co_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def add_cc(c1, c2, *, c3=1.1102230246251568e-16):
    """co = c1 + c2; |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 abs.
    """
    c1_0, c1_1, c1_2, c1_3, c1_4, c1_5 = c1
    c2_0, c2_1, c2_2, c2_3, c2_4, c2_5 = c2
    co_0 = c1_0 + c2_0
    co_1 = c1_1 + c2_1
    co_2 = c1_2 + c2_2
    co_3 = c1_3 + c2_3
    co_4 = c1_4 + c2_4
    co_5 = c1_5 + c2_5
    co_0_bound = c3 * absolute(co_0)
    co_1_bound = c3 * absolute(co_1)
    co_2_bound = c3 * absolute(co_2)
    co_3_bound = c3 * absolute(co_3)
    co_4_bound = c3 * absolute(co_4)
    co_5_bound = c3 * absolute(co_5)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0_bound, co_1_bound, co_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def subtract_cc(c1, c2, *, c3=1.1102230246251568e-16):
    """co = c1 - c2; |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 abs.
    """
    c1_0, c1_1, c1_2, c1_3, c1_4, c1_5 = c1
    c2_0, c2_1, c2_2, c2_3, c2_4, c2_5 = c2
    co_0 = c1_0 - c2_0
    co_1 = c1_1 - c2_1
    co_2 = c1_2 - c2_2
    co_3 = c1_3 - c2_3
    co_4 = c1_4 - c2_4
    co_5 = c1_5 - c2_5
    co_0_bound = c3 * absolute(co_0)
    co_1_bound = c3 * absolute(co_1)
    co_2_bound = c3 * absolute(co_2)
    co_3_bound = c3 * absolute(co_3)
    co_4_bound = c3 * absolute(co_4)
    co_5_bound = c3 * absolute(co_5)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0_bound, co_1_bound, co_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def add_cct(c1, c2, *, c3=1.1102230246251568e-16):
    """co = (c1.lin + c2.lin ; c1.ang); |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  c1, c2, co, co_bound: coscrew (f in N; τ in N m).
    3 mul, 3 add, 3 abs.
    """
    c1_0, c1_1, c1_2, c1_3, c1_4, c1_5 = c1
    c2_0, c2_1, c2_2, c2_3, c2_4, c2_5 = c2
    co_0 = c1_0 + c2_0
    co_1 = c1_1 + c2_1
    co_2 = c1_2 + c2_2
    co_0_bound = c3 * absolute(co_0)
    co_1_bound = c3 * absolute(co_1)
    co_2_bound = c3 * absolute(co_2)
    return (co_0, co_1, co_2, c1_3, c1_4, c1_5, co_0_bound, co_1_bound, co_2_bound, 0, 0, 0)


@kernel("(3),(6)->(6),(6)")
@errstate(all="ignore")
def product_CoAdtc(t, ci, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """co = [Ad]*(t) ci; |error of co| <= co_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
    9 mul, 15 add, 9 abs.
    """
    t_0, t_1, t_2 = t
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_3a = t_1 * ci_2
    co_3b = t_2 * ci_1
    co_3 = co_3a - co_3b + ci_3
    co_4a = t_2 * ci_0
    co_4b = t_0 * ci_2
    co_4 = co_4a - co_4b + ci_4
    co_5a = t_0 * ci_1
    co_5b = t_1 * ci_0
    co_5 = co_5a - co_5b + ci_5
    co_3_size = absolute(co_3a) + absolute(co_3b) + absolute(ci_3)
    co_4_size = absolute(co_4a) + absolute(co_4b) + absolute(ci_4)
    co_5_size = absolute(co_5a) + absolute(co_5b) + absolute(ci_5)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (ci_0, ci_1, ci_2, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3),(6)->(6),(6)")
@errstate(all="ignore")
def product_CoAdtinvc(t, ci, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """co = [Ad]*(t)^-1 ci; |error of co| <= co_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
    9 mul, 15 add, 9 abs.
    """
    t_0, t_1, t_2 = t
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_3a = t_2 * ci_1
    co_3b = t_1 * ci_2
    co_3 = co_3a - co_3b + ci_3
    co_4a = t_0 * ci_2
    co_4b = t_2 * ci_0
    co_4 = co_4a - co_4b + ci_4
    co_5a = t_1 * ci_0
    co_5b = t_0 * ci_1
    co_5 = co_5a - co_5b + ci_5
    co_3_size = absolute(co_3a) + absolute(co_3b) + absolute(ci_3)
    co_4_size = absolute(co_4a) + absolute(co_4b) + absolute(ci_4)
    co_5_size = absolute(co_5a) + absolute(co_5b) + absolute(ci_5)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (ci_0, ci_1, ci_2, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3),(6)->(6),(6)")
@errstate(all="ignore")
def product_CoAdtcinv(t, ci, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """co = [Ad]*(t) (-ci); |error of co| <= co_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
    9 mul, 15 add, 3 neg, 9 abs.
    """
    t_0, t_1, t_2 = t
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0 = -ci_0
    co_1 = -ci_1
    co_2 = -ci_2
    co_3a = t_2 * ci_1
    co_3b = t_1 * ci_2
    co_3 = co_3a - co_3b - ci_3
    co_4a = t_0 * ci_2
    co_4b = t_2 * ci_0
    co_4 = co_4a - co_4b - ci_4
    co_5a = t_1 * ci_0
    co_5b = t_0 * ci_1
    co_5 = co_5a - co_5b - ci_5
    co_3_size = absolute(co_3a) + absolute(co_3b) + absolute(ci_3)
    co_4_size = absolute(co_4a) + absolute(co_4b) + absolute(ci_4)
    co_5_size = absolute(co_5a) + absolute(co_5b) + absolute(ci_5)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3,3),(6)->(6),(6)")
@errstate(all="ignore")
def product_CoAdrc(R, ci, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """co = [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ
    in N m).
    24 mul, 30 add, 18 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0a = R_00 * ci_0
    co_0b = R_01 * ci_1
    co_0d = R_02 * ci_2
    co_0 = co_0a + co_0b + co_0d
    co_1a = R_10 * ci_0
    co_1b = R_11 * ci_1
    co_1d = R_12 * ci_2
    co_1 = co_1a + co_1b + co_1d
    co_2a = R_20 * ci_0
    co_2b = R_21 * ci_1
    co_2d = R_22 * ci_2
    co_2 = co_2a + co_2b + co_2d
    co_3a = R_00 * ci_3
    co_3b = R_01 * ci_4
    co_3d = R_02 * ci_5
    co_3 = co_3a + co_3b + co_3d
    co_4a = R_10 * ci_3
    co_4b = R_11 * ci_4
    co_4d = R_12 * ci_5
    co_4 = co_4a + co_4b + co_4d
    co_5a = R_20 * ci_3
    co_5b = R_21 * ci_4
    co_5d = R_22 * ci_5
    co_5 = co_5a + co_5b + co_5d
    co_0_size = absolute(co_0a) + absolute(co_0b) + absolute(co_0d)
    co_1_size = absolute(co_1a) + absolute(co_1b) + absolute(co_1d)
    co_2_size = absolute(co_2a) + absolute(co_2b) + absolute(co_2d)
    co_3_size = absolute(co_3a) + absolute(co_3b) + absolute(co_3d)
    co_4_size = absolute(co_4a) + absolute(co_4b) + absolute(co_4d)
    co_5_size = absolute(co_5a) + absolute(co_5b) + absolute(co_5d)
    co_0_bound = c2 * (co_0_size + c1)
    co_1_bound = c2 * (co_1_size + c1)
    co_2_bound = c2 * (co_2_size + c1)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0_bound, co_1_bound, co_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,3),(6)->(6),(6)")
@errstate(all="ignore")
def product_CoAdrinvc(R, ci, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """co = [Ad]*(R)^-1 ci; |error of co| <= co_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ
    in N m).
    24 mul, 30 add, 18 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0a = R_00 * ci_0
    co_0b = R_10 * ci_1
    co_0d = R_20 * ci_2
    co_0 = co_0a + co_0b + co_0d
    co_1a = R_01 * ci_0
    co_1b = R_11 * ci_1
    co_1d = R_21 * ci_2
    co_1 = co_1a + co_1b + co_1d
    co_2a = R_02 * ci_0
    co_2b = R_12 * ci_1
    co_2d = R_22 * ci_2
    co_2 = co_2a + co_2b + co_2d
    co_3a = R_00 * ci_3
    co_3b = R_10 * ci_4
    co_3d = R_20 * ci_5
    co_3 = co_3a + co_3b + co_3d
    co_4a = R_01 * ci_3
    co_4b = R_11 * ci_4
    co_4d = R_21 * ci_5
    co_4 = co_4a + co_4b + co_4d
    co_5a = R_02 * ci_3
    co_5b = R_12 * ci_4
    co_5d = R_22 * ci_5
    co_5 = co_5a + co_5b + co_5d
    co_0_size = absolute(co_0a) + absolute(co_0b) + absolute(co_0d)
    co_1_size = absolute(co_1a) + absolute(co_1b) + absolute(co_1d)
    co_2_size = absolute(co_2a) + absolute(co_2b) + absolute(co_2d)
    co_3_size = absolute(co_3a) + absolute(co_3b) + absolute(co_3d)
    co_4_size = absolute(co_4a) + absolute(co_4b) + absolute(co_4d)
    co_5_size = absolute(co_5a) + absolute(co_5b) + absolute(co_5d)
    co_0_bound = c2 * (co_0_size + c1)
    co_1_bound = c2 * (co_1_size + c1)
    co_2_bound = c2 * (co_2_size + c1)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0_bound, co_1_bound, co_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,3),(6)->(6),(6)")
@errstate(all="ignore")
def product_CoAdrcinv(R, ci, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """co = [Ad]*(R) (-ci); |error of co| <= co_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ
    in N m).
    24 mul, 30 add, 6 neg, 18 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0a = R_00 * ci_0
    co_0b = R_01 * ci_1
    co_0d = R_02 * ci_2
    co_0 = -(co_0a + co_0b + co_0d)
    co_1a = R_10 * ci_0
    co_1b = R_11 * ci_1
    co_1d = R_12 * ci_2
    co_1 = -(co_1a + co_1b + co_1d)
    co_2a = R_20 * ci_0
    co_2b = R_21 * ci_1
    co_2d = R_22 * ci_2
    co_2 = -(co_2a + co_2b + co_2d)
    co_3a = R_00 * ci_3
    co_3b = R_01 * ci_4
    co_3d = R_02 * ci_5
    co_3 = -(co_3a + co_3b + co_3d)
    co_4a = R_10 * ci_3
    co_4b = R_11 * ci_4
    co_4d = R_12 * ci_5
    co_4 = -(co_4a + co_4b + co_4d)
    co_5a = R_20 * ci_3
    co_5b = R_21 * ci_4
    co_5d = R_22 * ci_5
    co_5 = -(co_5a + co_5b + co_5d)
    co_0e_bound = c2 * (absolute(co_0a) + absolute(co_0b) + absolute(co_0d) + c1)
    co_1e_bound = c2 * (absolute(co_1a) + absolute(co_1b) + absolute(co_1d) + c1)
    co_2e_bound = c2 * (absolute(co_2a) + absolute(co_2b) + absolute(co_2d) + c1)
    co_3e_bound = c2 * (absolute(co_3a) + absolute(co_3b) + absolute(co_3d) + c1)
    co_4e_bound = c2 * (absolute(co_4a) + absolute(co_4b) + absolute(co_4d) + c1)
    co_5e_bound = c2 * (absolute(co_5a) + absolute(co_5b) + absolute(co_5d) + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0e_bound, co_1e_bound, co_2e_bound, co_3e_bound,
        co_4e_bound, co_5e_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def product_CoAdc(D, ci, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=6.661338147750942e-16):
    """co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew
    (f in N; τ in N m).
    36 mul, 42 add, 21 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    w_0a = D_00 * ci_0
    w_0b = D_01 * ci_1
    w_0d = D_02 * ci_2
    w_0 = w_0a + w_0b + w_0d
    w_1a = D_10 * ci_0
    w_1b = D_11 * ci_1
    w_1d = D_12 * ci_2
    w_1 = w_1a + w_1b + w_1d
    w_2a = D_20 * ci_0
    w_2b = D_21 * ci_1
    w_2d = D_22 * ci_2
    w_2 = w_2a + w_2b + w_2d
    w_3a = D_00 * ci_3
    w_3b = D_01 * ci_4
    w_3d = D_02 * ci_5
    w_3 = w_3a + w_3b + w_3d
    w_4a = D_10 * ci_3
    w_4b = D_11 * ci_4
    w_4d = D_12 * ci_5
    w_4 = w_4a + w_4b + w_4d
    w_5a = D_20 * ci_3
    w_5b = D_21 * ci_4
    w_5d = D_22 * ci_5
    w_5 = w_5a + w_5b + w_5d
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    w_0_size = absolute(w_0a) + absolute(w_0b) + absolute(w_0d)
    w_1_size = absolute(w_1a) + absolute(w_1b) + absolute(w_1d)
    w_2_size = absolute(w_2a) + absolute(w_2b) + absolute(w_2d)
    w_3_size = absolute(w_3a) + absolute(w_3b) + absolute(w_3d)
    w_4_size = absolute(w_4a) + absolute(w_4b) + absolute(w_4d)
    w_5_size = absolute(w_5a) + absolute(w_5b) + absolute(w_5d)
    w_2_padded = w_2_size + c1
    D_13_abs = absolute(D_13)
    w_1_padded = w_1_size + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded + w_3_size
    w_0_padded = w_0_size + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded + w_4_size
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded + w_5_size
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def product_CoAdinvc(D, ci, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=6.661338147750942e-16):
    """co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci; |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew
    (f in N; τ in N m).
    39 mul, 45 add, 27 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    w_3a = D_23 * ci_1
    w_3b = D_13 * ci_2
    w_3 = w_3a - w_3b + ci_3
    w_4a = D_03 * ci_2
    w_4b = D_23 * ci_0
    w_4 = w_4a - w_4b + ci_4
    w_5a = D_13 * ci_0
    w_5b = D_03 * ci_1
    w_5 = w_5a - w_5b + ci_5
    co_0a = D_00 * ci_0
    co_0b = D_10 * ci_1
    co_0d = D_20 * ci_2
    co_0 = co_0a + co_0b + co_0d
    co_1a = D_01 * ci_0
    co_1b = D_11 * ci_1
    co_1d = D_21 * ci_2
    co_1 = co_1a + co_1b + co_1d
    co_2a = D_02 * ci_0
    co_2b = D_12 * ci_1
    co_2d = D_22 * ci_2
    co_2 = co_2a + co_2b + co_2d
    co_3 = D_00 * w_3 + D_10 * w_4 + D_20 * w_5
    co_4 = D_01 * w_3 + D_11 * w_4 + D_21 * w_5
    co_5 = D_02 * w_3 + D_12 * w_4 + D_22 * w_5
    w_3_size = absolute(w_3a) + absolute(w_3b) + absolute(ci_3)
    w_4_size = absolute(w_4a) + absolute(w_4b) + absolute(ci_4)
    w_5_size = absolute(w_5a) + absolute(w_5b) + absolute(ci_5)
    co_0_size = absolute(co_0a) + absolute(co_0b) + absolute(co_0d)
    co_1_size = absolute(co_1a) + absolute(co_1b) + absolute(co_1d)
    co_2_size = absolute(co_2a) + absolute(co_2b) + absolute(co_2d)
    w_3_padded = w_3_size + c1
    w_4_padded = w_4_size + c1
    w_5_padded = w_5_size + c1
    co_3_size = (absolute(D_00) * w_3_padded + absolute(D_10) * w_4_padded + absolute(D_20)
        * w_5_padded)
    co_4_size = (absolute(D_01) * w_3_padded + absolute(D_11) * w_4_padded + absolute(D_21)
        * w_5_padded)
    co_5_size = (absolute(D_02) * w_3_padded + absolute(D_12) * w_4_padded + absolute(D_22)
        * w_5_padded)
    co_0_bound = c2 * (co_0_size + c1)
    co_1_bound = c2 * (co_1_size + c1)
    co_2_bound = c2 * (co_2_size + c1)
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0_bound, co_1_bound, co_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def product_CoAdcinv(D, ci, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=6.661338147750942e-16):
    """co = [Ad]*(D) (-ci); |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew
    (f in N; τ in N m).
    36 mul, 42 add, 6 neg, 21 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    w_0a = D_00 * ci_0
    w_0b = D_01 * ci_1
    w_0d = D_02 * ci_2
    w_0 = -(w_0a + w_0b + w_0d)
    w_1a = D_10 * ci_0
    w_1b = D_11 * ci_1
    w_1d = D_12 * ci_2
    w_1 = -(w_1a + w_1b + w_1d)
    w_2a = D_20 * ci_0
    w_2b = D_21 * ci_1
    w_2d = D_22 * ci_2
    w_2 = -(w_2a + w_2b + w_2d)
    w_3a = D_00 * ci_3
    w_3b = D_01 * ci_4
    w_3d = D_02 * ci_5
    w_3 = -(w_3a + w_3b + w_3d)
    w_4a = D_10 * ci_3
    w_4b = D_11 * ci_4
    w_4d = D_12 * ci_5
    w_4 = -(w_4a + w_4b + w_4d)
    w_5a = D_20 * ci_3
    w_5b = D_21 * ci_4
    w_5d = D_22 * ci_5
    w_5 = -(w_5a + w_5b + w_5d)
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    w_2e_padded = absolute(w_2a) + absolute(w_2b) + absolute(w_2d) + c1
    D_13_abs = absolute(D_13)
    w_1e_padded = absolute(w_1a) + absolute(w_1b) + absolute(w_1d) + c1
    D_23_abs = absolute(D_23)
    co_3_size = (D_13_abs * w_2e_padded + D_23_abs * w_1e_padded
        + (absolute(w_3a) + absolute(w_3b) + absolute(w_3d)))
    w_0e_padded = absolute(w_0a) + absolute(w_0b) + absolute(w_0d) + c1
    D_03_abs = absolute(D_03)
    co_4_size = (D_23_abs * w_0e_padded + D_03_abs * w_2e_padded
        + (absolute(w_4a) + absolute(w_4b) + absolute(w_4d)))
    co_5_size = (D_03_abs * w_1e_padded + D_13_abs * w_0e_padded
        + (absolute(w_5a) + absolute(w_5b) + absolute(w_5d)))
    w_0e_bound = c2 * w_0e_padded
    w_1e_bound = c2 * w_1e_padded
    w_2e_bound = c2 * w_2e_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0e_bound, w_1e_bound, w_2e_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hctx(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """co = h_tx: column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_3a = D_20 * D_13
    co_3b = D_10 * D_23
    co_3 = co_3a - co_3b
    co_4a = D_00 * D_23
    co_4b = D_20 * D_03
    co_4 = co_4a - co_4b
    co_5a = D_10 * D_03
    co_5b = D_00 * D_13
    co_5 = co_5a - co_5b
    co_3_size = absolute(co_3a) + absolute(co_3b)
    co_4_size = absolute(co_4a) + absolute(co_4b)
    co_5_size = absolute(co_5a) + absolute(co_5b)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (D_00, D_10, D_20, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hcty(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """co = h_ty: column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_3a = D_21 * D_13
    co_3b = D_11 * D_23
    co_3 = co_3a - co_3b
    co_4a = D_01 * D_23
    co_4b = D_21 * D_03
    co_4 = co_4a - co_4b
    co_5a = D_11 * D_03
    co_5b = D_01 * D_13
    co_5 = co_5a - co_5b
    co_3_size = absolute(co_3a) + absolute(co_3b)
    co_4_size = absolute(co_4a) + absolute(co_4b)
    co_5_size = absolute(co_5a) + absolute(co_5b)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (D_01, D_11, D_21, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hctz(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """co = h_tz: column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_3a = D_22 * D_13
    co_3b = D_12 * D_23
    co_3 = co_3a - co_3b
    co_4a = D_02 * D_23
    co_4b = D_22 * D_03
    co_4 = co_4a - co_4b
    co_5a = D_12 * D_03
    co_5b = D_02 * D_13
    co_5 = co_5a - co_5b
    co_3_size = absolute(co_3a) + absolute(co_3b)
    co_4_size = absolute(co_4a) + absolute(co_4b)
    co_5_size = absolute(co_5a) + absolute(co_5b)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (D_02, D_12, D_22, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hctxinv(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """co = -h_tx: -column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 3 neg, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_0 = -D_00
    co_1 = -D_10
    co_2 = -D_20
    co_3a = D_10 * D_23
    co_3b = D_20 * D_13
    co_3 = co_3a - co_3b
    co_4a = D_20 * D_03
    co_4b = D_00 * D_23
    co_4 = co_4a - co_4b
    co_5a = D_00 * D_13
    co_5b = D_10 * D_03
    co_5 = co_5a - co_5b
    co_3_size = absolute(co_3a) + absolute(co_3b)
    co_4_size = absolute(co_4a) + absolute(co_4b)
    co_5_size = absolute(co_5a) + absolute(co_5b)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hctyinv(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """co = -h_ty: -column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 3 neg, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_0 = -D_01
    co_1 = -D_11
    co_2 = -D_21
    co_3a = D_11 * D_23
    co_3b = D_21 * D_13
    co_3 = co_3a - co_3b
    co_4a = D_21 * D_03
    co_4b = D_01 * D_23
    co_4 = co_4a - co_4b
    co_5a = D_01 * D_13
    co_5b = D_11 * D_03
    co_5 = co_5a - co_5b
    co_3_size = absolute(co_3a) + absolute(co_3b)
    co_4_size = absolute(co_4a) + absolute(co_4b)
    co_5_size = absolute(co_5a) + absolute(co_5b)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hctzinv(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """co = -h_tz: -column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N;
    τ in N m).
    9 mul, 9 add, 3 neg, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_0 = -D_02
    co_1 = -D_12
    co_2 = -D_22
    co_3a = D_12 * D_23
    co_3b = D_22 * D_13
    co_3 = co_3a - co_3b
    co_4a = D_22 * D_03
    co_4b = D_02 * D_23
    co_4 = co_4a - co_4b
    co_5a = D_02 * D_13
    co_5b = D_12 * D_03
    co_5 = co_5a - co_5b
    co_3_size = absolute(co_3a) + absolute(co_3b)
    co_4_size = absolute(co_4a) + absolute(co_4b)
    co_5_size = absolute(co_5a) + absolute(co_5b)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3,4)->(6,6),(6,6)")
@errstate(all="ignore")
def CoAd(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """M = [Ad]*(D); |error of M| <= M_bound unless inf or NaN.

    (3,4)->(6,6),(6,6).  D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
    27 mul, 27 add, 18 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    M_30a = D_20 * D_13
    M_30b = D_10 * D_23
    M_30 = M_30a - M_30b
    M_31a = D_21 * D_13
    M_31b = D_11 * D_23
    M_31 = M_31a - M_31b
    M_32a = D_22 * D_13
    M_32b = D_12 * D_23
    M_32 = M_32a - M_32b
    M_40a = D_00 * D_23
    M_40b = D_20 * D_03
    M_40 = M_40a - M_40b
    M_41a = D_01 * D_23
    M_41b = D_21 * D_03
    M_41 = M_41a - M_41b
    M_42a = D_02 * D_23
    M_42b = D_22 * D_03
    M_42 = M_42a - M_42b
    M_50a = D_10 * D_03
    M_50b = D_00 * D_13
    M_50 = M_50a - M_50b
    M_51a = D_11 * D_03
    M_51b = D_01 * D_13
    M_51 = M_51a - M_51b
    M_52a = D_12 * D_03
    M_52b = D_02 * D_13
    M_52 = M_52a - M_52b
    M_30_size = absolute(M_30a) + absolute(M_30b)
    M_31_size = absolute(M_31a) + absolute(M_31b)
    M_32_size = absolute(M_32a) + absolute(M_32b)
    M_40_size = absolute(M_40a) + absolute(M_40b)
    M_41_size = absolute(M_41a) + absolute(M_41b)
    M_42_size = absolute(M_42a) + absolute(M_42b)
    M_50_size = absolute(M_50a) + absolute(M_50b)
    M_51_size = absolute(M_51a) + absolute(M_51b)
    M_52_size = absolute(M_52a) + absolute(M_52b)
    M_30_bound = c2 * (M_30_size + c1)
    M_31_bound = c2 * (M_31_size + c1)
    M_32_bound = c2 * (M_32_size + c1)
    M_40_bound = c2 * (M_40_size + c1)
    M_41_bound = c2 * (M_41_size + c1)
    M_42_bound = c2 * (M_42_size + c1)
    M_50_bound = c2 * (M_50_size + c1)
    M_51_bound = c2 * (M_51_size + c1)
    M_52_bound = c2 * (M_52_size + c1)
    return (D_00, D_01, D_02, 0, 0, 0, D_10, D_11, D_12, 0, 0, 0, D_20, D_21, D_22, 0, 0, 0, M_30,
        M_31, M_32, D_00, D_01, D_02, M_40, M_41, M_42, D_10, D_11, D_12, M_50, M_51, M_52, D_20,
        D_21, D_22, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, M_30_bound, M_31_bound,
        M_32_bound, 0, 0, 0, M_40_bound, M_41_bound, M_42_bound, 0, 0, 0, M_50_bound, M_51_bound,
        M_52_bound, 0, 0, 0)


@kernel("(6),(6)->(),()")
@errstate(all="ignore")
def reciprocal_product(c, x, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v); |error of power| <= power_bound
    unless inf or NaN.

    (6),(6)->(),().  c: coscrew (f in N; τ in N m); x: six components with the angular part on
    top; power, power_bound: number.
    7 mul, 11 add, 6 abs.
    """
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    power_a = c_0 * x_3
    power_b = c_1 * x_4
    power_d = c_2 * x_5
    power_f = c_3 * x_0
    power_g = c_4 * x_1
    power_i = c_5 * x_2
    power = power_a + power_b + power_d + (power_f + power_g + power_i)
    power_size = (absolute(power_a) + absolute(power_b) + absolute(power_d)
        + (absolute(power_f) + absolute(power_g) + absolute(power_i)))
    power_bound = c2 * (power_size + c1)
    return (power, power_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def cross_sc(s, c, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16,
        c3=3.3306690738754706e-16):
    """co = [ad]*(s) c = (ω×f ; v×f + ω×τ); |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N
    m).
    24 mul, 30 add, 18 abs.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    co_0a = s_4 * c_2
    co_0b = s_5 * c_1
    co_0 = co_0a - co_0b
    co_1a = s_5 * c_0
    co_1b = s_3 * c_2
    co_1 = co_1a - co_1b
    co_2a = s_3 * c_1
    co_2b = s_4 * c_0
    co_2 = co_2a - co_2b
    co_3a = s_1 * c_2
    co_3b = s_2 * c_1
    co_3d = s_4 * c_5
    co_3e = s_5 * c_4
    co_3 = co_3a - co_3b + (co_3d - co_3e)
    co_4a = s_2 * c_0
    co_4b = s_0 * c_2
    co_4d = s_5 * c_3
    co_4e = s_3 * c_5
    co_4 = co_4a - co_4b + (co_4d - co_4e)
    co_5a = s_0 * c_1
    co_5b = s_1 * c_0
    co_5d = s_3 * c_4
    co_5e = s_4 * c_3
    co_5 = co_5a - co_5b + (co_5d - co_5e)
    co_0_size = absolute(co_0a) + absolute(co_0b)
    co_1_size = absolute(co_1a) + absolute(co_1b)
    co_2_size = absolute(co_2a) + absolute(co_2b)
    co_3_size = absolute(co_3a) + absolute(co_3b) + (absolute(co_3d) + absolute(co_3e))
    co_4_size = absolute(co_4a) + absolute(co_4b) + (absolute(co_4d) + absolute(co_4e))
    co_5_size = absolute(co_5a) + absolute(co_5b) + (absolute(co_5d) + absolute(co_5e))
    co_0_bound = c2 * (co_0_size + c1)
    co_1_bound = c2 * (co_1_size + c1)
    co_2_bound = c2 * (co_2_size + c1)
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0_bound, co_1_bound, co_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def cross_sca(s, c, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """co = (0 ; ω×τ); |error of co| <= co_bound unless inf or NaN.

    (6),(6)->(6),(6).  s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N
    m).
    9 mul, 9 add, 6 abs.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    co_3a = s_4 * c_5
    co_3b = s_5 * c_4
    co_3 = co_3a - co_3b
    co_4a = s_5 * c_3
    co_4b = s_3 * c_5
    co_4 = co_4a - co_4b
    co_5a = s_3 * c_4
    co_5b = s_4 * c_3
    co_5 = co_5a - co_5b
    co_3_size = absolute(co_3a) + absolute(co_3b)
    co_4_size = absolute(co_4a) + absolute(co_4b)
    co_5_size = absolute(co_5a) + absolute(co_5b)
    co_3_bound = c2 * (co_3_size + c1)
    co_4_bound = c2 * (co_4_size + c1)
    co_5_bound = c2 * (co_5_size + c1)
    return (0, 0, 0, co_3, co_4, co_5, 0, 0, 0, co_3_bound, co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def constraint_ctx(D, c, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16,
        c3=5.551115123125785e-16):
    """co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_01 * c_1
    w_0b = D_02 * c_2
    w_0 = w_0a + w_0b
    w_1a = D_11 * c_1
    w_1b = D_12 * c_2
    w_1 = w_1a + w_1b
    w_2a = D_21 * c_1
    w_2b = D_22 * c_2
    w_2 = w_2a + w_2b
    w_3a = D_00 * c_3
    w_3b = D_01 * c_4
    w_3d = D_02 * c_5
    w_3 = w_3a + w_3b + w_3d
    w_4a = D_10 * c_3
    w_4b = D_11 * c_4
    w_4d = D_12 * c_5
    w_4 = w_4a + w_4b + w_4d
    w_5a = D_20 * c_3
    w_5b = D_21 * c_4
    w_5d = D_22 * c_5
    w_5 = w_5a + w_5b + w_5d
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    w_0_size = absolute(w_0a) + absolute(w_0b)
    w_1_size = absolute(w_1a) + absolute(w_1b)
    w_2_size = absolute(w_2a) + absolute(w_2b)
    w_3_size = absolute(w_3a) + absolute(w_3b) + absolute(w_3d)
    w_4_size = absolute(w_4a) + absolute(w_4b) + absolute(w_4d)
    w_5_size = absolute(w_5a) + absolute(w_5b) + absolute(w_5d)
    w_2_padded = w_2_size + c1
    D_13_abs = absolute(D_13)
    w_1_padded = w_1_size + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded + w_3_size
    w_0_padded = w_0_size + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded + w_4_size
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded + w_5_size
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def constraint_cty(D, c, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16,
        c3=5.551115123125785e-16):
    """co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_02 * c_2
    w_0 = w_0a + w_0b
    w_1a = D_10 * c_0
    w_1b = D_12 * c_2
    w_1 = w_1a + w_1b
    w_2a = D_20 * c_0
    w_2b = D_22 * c_2
    w_2 = w_2a + w_2b
    w_3a = D_00 * c_3
    w_3b = D_01 * c_4
    w_3d = D_02 * c_5
    w_3 = w_3a + w_3b + w_3d
    w_4a = D_10 * c_3
    w_4b = D_11 * c_4
    w_4d = D_12 * c_5
    w_4 = w_4a + w_4b + w_4d
    w_5a = D_20 * c_3
    w_5b = D_21 * c_4
    w_5d = D_22 * c_5
    w_5 = w_5a + w_5b + w_5d
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    w_0_size = absolute(w_0a) + absolute(w_0b)
    w_1_size = absolute(w_1a) + absolute(w_1b)
    w_2_size = absolute(w_2a) + absolute(w_2b)
    w_3_size = absolute(w_3a) + absolute(w_3b) + absolute(w_3d)
    w_4_size = absolute(w_4a) + absolute(w_4b) + absolute(w_4d)
    w_5_size = absolute(w_5a) + absolute(w_5b) + absolute(w_5d)
    w_2_padded = w_2_size + c1
    D_13_abs = absolute(D_13)
    w_1_padded = w_1_size + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded + w_3_size
    w_0_padded = w_0_size + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded + w_4_size
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded + w_5_size
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def constraint_ctz(D, c, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16,
        c3=5.551115123125785e-16):
    """co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_01 * c_1
    w_0 = w_0a + w_0b
    w_1a = D_10 * c_0
    w_1b = D_11 * c_1
    w_1 = w_1a + w_1b
    w_2a = D_20 * c_0
    w_2b = D_21 * c_1
    w_2 = w_2a + w_2b
    w_3a = D_00 * c_3
    w_3b = D_01 * c_4
    w_3d = D_02 * c_5
    w_3 = w_3a + w_3b + w_3d
    w_4a = D_10 * c_3
    w_4b = D_11 * c_4
    w_4d = D_12 * c_5
    w_4 = w_4a + w_4b + w_4d
    w_5a = D_20 * c_3
    w_5b = D_21 * c_4
    w_5d = D_22 * c_5
    w_5 = w_5a + w_5b + w_5d
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    w_0_size = absolute(w_0a) + absolute(w_0b)
    w_1_size = absolute(w_1a) + absolute(w_1b)
    w_2_size = absolute(w_2a) + absolute(w_2b)
    w_3_size = absolute(w_3a) + absolute(w_3b) + absolute(w_3d)
    w_4_size = absolute(w_4a) + absolute(w_4b) + absolute(w_4d)
    w_5_size = absolute(w_5a) + absolute(w_5b) + absolute(w_5d)
    w_2_padded = w_2_size + c1
    D_13_abs = absolute(D_13)
    w_1_padded = w_1_size + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded + w_3_size
    w_0_padded = w_0_size + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded + w_4_size
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded + w_5_size
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def constraint_crx(D, c, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=6.661338147750942e-16):
    """co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_01 * c_1
    w_0d = D_02 * c_2
    w_0 = w_0a + w_0b + w_0d
    w_1a = D_10 * c_0
    w_1b = D_11 * c_1
    w_1d = D_12 * c_2
    w_1 = w_1a + w_1b + w_1d
    w_2a = D_20 * c_0
    w_2b = D_21 * c_1
    w_2d = D_22 * c_2
    w_2 = w_2a + w_2b + w_2d
    w_3a = D_01 * c_4
    w_3b = D_02 * c_5
    w_3 = w_3a + w_3b
    w_4a = D_11 * c_4
    w_4b = D_12 * c_5
    w_4 = w_4a + w_4b
    w_5a = D_21 * c_4
    w_5b = D_22 * c_5
    w_5 = w_5a + w_5b
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    w_0_size = absolute(w_0a) + absolute(w_0b) + absolute(w_0d)
    w_1_size = absolute(w_1a) + absolute(w_1b) + absolute(w_1d)
    w_2_size = absolute(w_2a) + absolute(w_2b) + absolute(w_2d)
    w_3_size = absolute(w_3a) + absolute(w_3b)
    w_4_size = absolute(w_4a) + absolute(w_4b)
    w_5_size = absolute(w_5a) + absolute(w_5b)
    w_2_padded = w_2_size + c1
    D_13_abs = absolute(D_13)
    w_1_padded = w_1_size + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded + w_3_size
    w_0_padded = w_0_size + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded + w_4_size
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded + w_5_size
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def constraint_cry(D, c, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=6.661338147750942e-16):
    """co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_01 * c_1
    w_0d = D_02 * c_2
    w_0 = w_0a + w_0b + w_0d
    w_1a = D_10 * c_0
    w_1b = D_11 * c_1
    w_1d = D_12 * c_2
    w_1 = w_1a + w_1b + w_1d
    w_2a = D_20 * c_0
    w_2b = D_21 * c_1
    w_2d = D_22 * c_2
    w_2 = w_2a + w_2b + w_2d
    w_3a = D_00 * c_3
    w_3b = D_02 * c_5
    w_3 = w_3a + w_3b
    w_4a = D_10 * c_3
    w_4b = D_12 * c_5
    w_4 = w_4a + w_4b
    w_5a = D_20 * c_3
    w_5b = D_22 * c_5
    w_5 = w_5a + w_5b
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    w_0_size = absolute(w_0a) + absolute(w_0b) + absolute(w_0d)
    w_1_size = absolute(w_1a) + absolute(w_1b) + absolute(w_1d)
    w_2_size = absolute(w_2a) + absolute(w_2b) + absolute(w_2d)
    w_3_size = absolute(w_3a) + absolute(w_3b)
    w_4_size = absolute(w_4a) + absolute(w_4b)
    w_5_size = absolute(w_5a) + absolute(w_5b)
    w_2_padded = w_2_size + c1
    D_13_abs = absolute(D_13)
    w_1_padded = w_1_size + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded + w_3_size
    w_0_padded = w_0_size + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded + w_4_size
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded + w_5_size
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def constraint_crz(D, c, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=6.661338147750942e-16):
    """co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    33 mul, 36 add, 18 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_01 * c_1
    w_0d = D_02 * c_2
    w_0 = w_0a + w_0b + w_0d
    w_1a = D_10 * c_0
    w_1b = D_11 * c_1
    w_1d = D_12 * c_2
    w_1 = w_1a + w_1b + w_1d
    w_2a = D_20 * c_0
    w_2b = D_21 * c_1
    w_2d = D_22 * c_2
    w_2 = w_2a + w_2b + w_2d
    w_3a = D_00 * c_3
    w_3b = D_01 * c_4
    w_3 = w_3a + w_3b
    w_4a = D_10 * c_3
    w_4b = D_11 * c_4
    w_4 = w_4a + w_4b
    w_5a = D_20 * c_3
    w_5b = D_21 * c_4
    w_5 = w_5a + w_5b
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    w_0_size = absolute(w_0a) + absolute(w_0b) + absolute(w_0d)
    w_1_size = absolute(w_1a) + absolute(w_1b) + absolute(w_1d)
    w_2_size = absolute(w_2a) + absolute(w_2b) + absolute(w_2d)
    w_3_size = absolute(w_3a) + absolute(w_3b)
    w_4_size = absolute(w_4a) + absolute(w_4b)
    w_5_size = absolute(w_5a) + absolute(w_5b)
    w_2_padded = w_2_size + c1
    D_13_abs = absolute(D_13)
    w_1_padded = w_1_size + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded + w_3_size
    w_0_padded = w_0_size + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded + w_4_size
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded + w_5_size
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def working_ctx(D, c, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16,
        c3=3.3306690738754706e-16):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    21 mul, 12 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_00 * c_0
    w_1 = D_10 * c_0
    w_2 = D_20 * c_0
    co_3 = D_13 * w_2 - D_23 * w_1
    co_4 = D_23 * w_0 - D_03 * w_2
    co_5 = D_03 * w_1 - D_13 * w_0
    w_2_padded = absolute(w_2) + c1
    D_13_abs = absolute(D_13)
    w_1_padded = absolute(w_1) + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded
    w_0_padded = absolute(w_0) + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def working_cty(D, c, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16,
        c3=3.3306690738754706e-16):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    21 mul, 12 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_01 * c_1
    w_1 = D_11 * c_1
    w_2 = D_21 * c_1
    co_3 = D_13 * w_2 - D_23 * w_1
    co_4 = D_23 * w_0 - D_03 * w_2
    co_5 = D_03 * w_1 - D_13 * w_0
    w_2_padded = absolute(w_2) + c1
    D_13_abs = absolute(D_13)
    w_1_padded = absolute(w_1) + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded
    w_0_padded = absolute(w_0) + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def working_ctz(D, c, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16,
        c3=3.3306690738754706e-16):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    21 mul, 12 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_02 * c_2
    w_1 = D_12 * c_2
    w_2 = D_22 * c_2
    co_3 = D_13 * w_2 - D_23 * w_1
    co_4 = D_23 * w_0 - D_03 * w_2
    co_5 = D_03 * w_1 - D_13 * w_0
    w_2_padded = absolute(w_2) + c1
    D_13_abs = absolute(D_13)
    w_1_padded = absolute(w_1) + c1
    D_23_abs = absolute(D_23)
    co_3_size = D_13_abs * w_2_padded + D_23_abs * w_1_padded
    w_0_padded = absolute(w_0) + c1
    D_03_abs = absolute(D_03)
    co_4_size = D_23_abs * w_0_padded + D_03_abs * w_2_padded
    co_5_size = D_03_abs * w_1_padded + D_13_abs * w_0_padded
    w_0_bound = c2 * w_0_padded
    w_1_bound = c2 * w_1_padded
    w_2_bound = c2 * w_2_padded
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (w_0, w_1, w_2, co_3, co_4, co_5, w_0_bound, w_1_bound, w_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def working_crx(D, c, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    6 mul, 3 add, 3 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_3 = D_00 * c_3
    w_4 = D_10 * c_3
    w_5 = D_20 * c_3
    w_3_bound = c2 * (absolute(w_3) + c1)
    w_4_bound = c2 * (absolute(w_4) + c1)
    w_5_bound = c2 * (absolute(w_5) + c1)
    return (0, 0, 0, w_3, w_4, w_5, 0, 0, 0, w_3_bound, w_4_bound, w_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def working_cry(D, c, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    6 mul, 3 add, 3 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_3 = D_01 * c_4
    w_4 = D_11 * c_4
    w_5 = D_21 * c_4
    w_3_bound = c2 * (absolute(w_3) + c1)
    w_4_bound = c2 * (absolute(w_4) + c1)
    w_5_bound = c2 * (absolute(w_5) + c1)
    return (0, 0, 0, w_3, w_4, w_5, 0, 0, 0, w_3_bound, w_4_bound, w_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def working_crz(D, c, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D;
    |error of co| <= co_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew
    (f in N; τ in N m).
    6 mul, 3 add, 3 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_3 = D_02 * c_5
    w_4 = D_12 * c_5
    w_5 = D_22 * c_5
    w_3_bound = c2 * (absolute(w_3) + c1)
    w_4_bound = c2 * (absolute(w_4) + c1)
    w_5_bound = c2 * (absolute(w_5) + c1)
    return (0, 0, 0, w_3, w_4, w_5, 0, 0, 0, w_3_bound, w_4_bound, w_5_bound)
