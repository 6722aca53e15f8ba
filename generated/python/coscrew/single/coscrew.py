# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Coscrews: wrenches and momenta, c = (f; τ).

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from numpy import absolute, float32 as real, sqrt, where
from coscrew._kernel import single_kernel as kernel
from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__)

coscrew_copy = twin(double.coscrew_copy)
coscrew_scale = twin(double.coscrew_scale)
coscrew_inverted = twin(double.coscrew_inverted)
coscrew_invert = twin(double.coscrew_invert)
axpy_cc = twin(double.axpy_cc)
xpy_cc = twin(double.xpy_cc)
nxpy_cc = twin(double.nxpy_cc)
product_ac = twin(double.product_ac)
add_cc = twin(double.add_cc)
subtract_cc = twin(double.subtract_cc)


@kernel("(6)->()")
def coscrew_norm(ci):
    """|ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).

    (6)->().  ci: coscrew (f in N; τ in N m); norm: number.
    7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select.
    """
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    small = where(absolute(ci_0) < 1e-06, where(absolute(ci_1) < 1e-06,
        where(absolute(ci_2) < 1e-06, real(1), real(0)), 0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, ci_3, ci_0)
    p_1 = where(p_0a, ci_4, ci_1)
    p_2 = where(p_0a, ci_5, ci_2)
    s_size_0 = absolute(p_0)
    s_size_1 = absolute(p_1)
    s_size_2 = absolute(p_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest2,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = p_0 * s
    y_1 = p_1 * s
    y_2 = p_2 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    r_d = where(1 < s, 5.551115123125783e-17, where(s < 1, real(3.6893488147419103e+19), real(1)))
    r = where(1.8014398509481984e+16 < s, 3.0814879110195774e-33, r_d)
    norm = n * r
    return norm


@kernel("(6)->(6)")
def coscrew_normalize(self):
    """self = self / |self|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  self: coscrew (f in N; τ in N m).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    small_a = absolute(self_2)
    small_d = absolute(self_1)
    small_g = absolute(self_0)
    small = where(small_g < 1e-06, where(small_d < 1e-06, where(small_a < 1e-06, real(1), real(0)),
        0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, self_3, self_0)
    p_1 = where(p_0a, self_4, self_1)
    p_2 = where(p_0a, self_5, self_2)
    s_size_0 = absolute(p_0)
    s_size_1 = absolute(p_1)
    s_size_2 = absolute(p_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest2,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = p_0 * s
    y_1 = p_1 * s
    y_2 = p_2 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    divisor = where(n == 0, up, n)
    size_3 = absolute(self_3)
    size_4 = absolute(self_4)
    size_5 = absolute(self_5)
    before_0a = small_g < 256
    before_0 = where(before_0a, up, down)
    before_1a = small_d < 256
    before_1 = where(before_1a, up, down)
    before_2a = small_a < 256
    before_2 = where(before_2a, up, down)
    before_3a = size_3 < 256
    before_3 = where(before_3a, up, down)
    before_4a = size_4 < 256
    before_4 = where(before_4a, up, down)
    before_5a = size_5 < 256
    before_5 = where(before_5a, up, down)
    after_0 = where(before_0a, down, up)
    after_1 = where(before_1a, down, up)
    after_2 = where(before_2a, down, up)
    after_3 = where(before_3a, down, up)
    after_4 = where(before_4a, down, up)
    after_5 = where(before_5a, down, up)
    sized_0 = self_0 * before_0
    sized_1 = self_1 * before_1
    sized_2 = self_2 * before_2
    sized_3 = self_3 * before_3
    sized_4 = self_4 * before_4
    sized_5 = self_5 * before_5
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    quotient_4 = sized_4 / divisor
    quotient_5 = sized_5 / divisor
    self_0_new = quotient_0 * after_0
    self_1_new = quotient_1 * after_1
    self_2_new = quotient_2 * after_2
    self_3_new = quotient_3 * after_3
    self_4_new = quotient_4 * after_4
    self_5_new = quotient_5 * after_5
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new)


@kernel("(6)->(6)")
def coscrew_normalized(ci):
    """co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  ci, co: coscrew (f in N; τ in N m).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    small_a = absolute(ci_2)
    small_d = absolute(ci_1)
    small_g = absolute(ci_0)
    small = where(small_g < 1e-06, where(small_d < 1e-06, where(small_a < 1e-06, real(1), real(0)),
        0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, ci_3, ci_0)
    p_1 = where(p_0a, ci_4, ci_1)
    p_2 = where(p_0a, ci_5, ci_2)
    s_size_0 = absolute(p_0)
    s_size_1 = absolute(p_1)
    s_size_2 = absolute(p_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest2,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = p_0 * s
    y_1 = p_1 * s
    y_2 = p_2 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    divisor = where(n == 0, up, n)
    size_3 = absolute(ci_3)
    size_4 = absolute(ci_4)
    size_5 = absolute(ci_5)
    before_0a = small_g < 256
    before_0 = where(before_0a, up, down)
    before_1a = small_d < 256
    before_1 = where(before_1a, up, down)
    before_2a = small_a < 256
    before_2 = where(before_2a, up, down)
    before_3a = size_3 < 256
    before_3 = where(before_3a, up, down)
    before_4a = size_4 < 256
    before_4 = where(before_4a, up, down)
    before_5a = size_5 < 256
    before_5 = where(before_5a, up, down)
    after_0 = where(before_0a, down, up)
    after_1 = where(before_1a, down, up)
    after_2 = where(before_2a, down, up)
    after_3 = where(before_3a, down, up)
    after_4 = where(before_4a, down, up)
    after_5 = where(before_5a, down, up)
    sized_0 = ci_0 * before_0
    sized_1 = ci_1 * before_1
    sized_2 = ci_2 * before_2
    sized_3 = ci_3 * before_3
    sized_4 = ci_4 * before_4
    sized_5 = ci_5 * before_5
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    quotient_4 = sized_4 / divisor
    quotient_5 = sized_5 / divisor
    co_0 = quotient_0 * after_0
    co_1 = quotient_1 * after_1
    co_2 = quotient_2 * after_2
    co_3 = quotient_3 * after_3
    co_4 = quotient_4 * after_4
    co_5 = quotient_5 * after_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)

coscrew_from_lin_ang = twin(double.coscrew_from_lin_ang)
coscrew_to_angular_first = twin(double.coscrew_to_angular_first)
coscrew_from_angular_first = twin(double.coscrew_from_angular_first)
add_cct = twin(double.add_cct)
product_CoAdtc = twin(double.product_CoAdtc)
product_CoAdtinvc = twin(double.product_CoAdtinvc)
product_CoAdtcinv = twin(double.product_CoAdtcinv)
product_CoAdrc = twin(double.product_CoAdrc)
product_CoAdrinvc = twin(double.product_CoAdrinvc)
product_CoAdrcinv = twin(double.product_CoAdrcinv)
product_CoAdc = twin(double.product_CoAdc)
product_CoAdinvc = twin(double.product_CoAdinvc)
product_CoAdcinv = twin(double.product_CoAdcinv)
hctx = twin(double.hctx)
hcty = twin(double.hcty)
hctz = twin(double.hctz)
hcrx = twin(double.hcrx)
hcry = twin(double.hcry)
hcrz = twin(double.hcrz)
hctxinv = twin(double.hctxinv)
hctyinv = twin(double.hctyinv)
hctzinv = twin(double.hctzinv)
hcrxinv = twin(double.hcrxinv)
hcryinv = twin(double.hcryinv)
hcrzinv = twin(double.hcrzinv)
CoAd = twin(double.CoAd)
reciprocal_product = twin(double.reciprocal_product)
cross_sc = twin(double.cross_sc)
cross_sca = twin(double.cross_sca)
constraint_ctx = twin(double.constraint_ctx)
constraint_cty = twin(double.constraint_cty)
constraint_ctz = twin(double.constraint_ctz)
constraint_crx = twin(double.constraint_crx)
constraint_cry = twin(double.constraint_cry)
constraint_crz = twin(double.constraint_crz)
working_ctx = twin(double.working_ctx)
working_cty = twin(double.working_cty)
working_ctz = twin(double.working_ctz)
working_crx = twin(double.working_crx)
working_cry = twin(double.working_cry)
working_crz = twin(double.working_crz)
coad = twin(double.coad)
