# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Screws: twists, spatial velocities and accelerations, s = (v; ω).

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from numpy import absolute, float32 as real, sqrt, where
from coscrew._kernel import single_kernel as kernel
from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__)

screw_copy = twin(double.screw_copy)
screw_scale = twin(double.screw_scale)
screw_inverted = twin(double.screw_inverted)
screw_invert = twin(double.screw_invert)
axpy_ss = twin(double.axpy_ss)
xpy_ss = twin(double.xpy_ss)
nxpy_ss = twin(double.nxpy_ss)
product_as = twin(double.product_as)
add_ss = twin(double.add_ss)
subtract_ss = twin(double.subtract_ss)


@kernel("(6)->()")
def screw_norm(si):
    """|si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).

    (6)->().  si: screw (v in m/s; ω in rad/s); norm: number.
    7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    small = where(absolute(si_3) < 1e-06, where(absolute(si_4) < 1e-06,
        where(absolute(si_5) < 1e-06, real(1), real(0)), 0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, si_0, si_3)
    p_1 = where(p_0a, si_1, si_4)
    p_2 = where(p_0a, si_2, si_5)
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
def screw_normalize(self):
    """self = self / |self|, with screw_norm; the zero screw stays zero.

    (6)->(6).  self: screw (v in m/s; ω in rad/s).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    small_a = absolute(self_5)
    small_d = absolute(self_4)
    small_g = absolute(self_3)
    small = where(small_g < 1e-06, where(small_d < 1e-06, where(small_a < 1e-06, real(1), real(0)),
        0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, self_0, self_3)
    p_1 = where(p_0a, self_1, self_4)
    p_2 = where(p_0a, self_2, self_5)
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
    size_0 = absolute(self_0)
    size_1 = absolute(self_1)
    size_2 = absolute(self_2)
    before_0a = size_0 < 256
    before_0 = where(before_0a, up, down)
    before_1a = size_1 < 256
    before_1 = where(before_1a, up, down)
    before_2a = size_2 < 256
    before_2 = where(before_2a, up, down)
    before_3a = small_g < 256
    before_3 = where(before_3a, up, down)
    before_4a = small_d < 256
    before_4 = where(before_4a, up, down)
    before_5a = small_a < 256
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
def screw_normalized(si):
    """so = si / |si|, with screw_norm; the zero screw stays zero.

    (6)->(6).  si, so: screw (v in m/s; ω in rad/s).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    small_a = absolute(si_5)
    small_d = absolute(si_4)
    small_g = absolute(si_3)
    small = where(small_g < 1e-06, where(small_d < 1e-06, where(small_a < 1e-06, real(1), real(0)),
        0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, si_0, si_3)
    p_1 = where(p_0a, si_1, si_4)
    p_2 = where(p_0a, si_2, si_5)
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
    size_0 = absolute(si_0)
    size_1 = absolute(si_1)
    size_2 = absolute(si_2)
    before_0a = size_0 < 256
    before_0 = where(before_0a, up, down)
    before_1a = size_1 < 256
    before_1 = where(before_1a, up, down)
    before_2a = size_2 < 256
    before_2 = where(before_2a, up, down)
    before_3a = small_g < 256
    before_3 = where(before_3a, up, down)
    before_4a = small_d < 256
    before_4 = where(before_4a, up, down)
    before_5a = small_a < 256
    before_5 = where(before_5a, up, down)
    after_0 = where(before_0a, down, up)
    after_1 = where(before_1a, down, up)
    after_2 = where(before_2a, down, up)
    after_3 = where(before_3a, down, up)
    after_4 = where(before_4a, down, up)
    after_5 = where(before_5a, down, up)
    sized_0 = si_0 * before_0
    sized_1 = si_1 * before_1
    sized_2 = si_2 * before_2
    sized_3 = si_3 * before_3
    sized_4 = si_4 * before_4
    sized_5 = si_5 * before_5
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    quotient_4 = sized_4 / divisor
    quotient_5 = sized_5 / divisor
    so_0 = quotient_0 * after_0
    so_1 = quotient_1 * after_1
    so_2 = quotient_2 * after_2
    so_3 = quotient_3 * after_3
    so_4 = quotient_4 * after_4
    so_5 = quotient_5 * after_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)

screw_from_lin_ang = twin(double.screw_from_lin_ang)
screw_to_angular_first = twin(double.screw_to_angular_first)
screw_from_angular_first = twin(double.screw_from_angular_first)
add_sst = twin(double.add_sst)
product_Adts = twin(double.product_Adts)
product_Adtinvs = twin(double.product_Adtinvs)
product_Adtsinv = twin(double.product_Adtsinv)
product_Adrs = twin(double.product_Adrs)
product_Adrinvs = twin(double.product_Adrinvs)
product_Adrsinv = twin(double.product_Adrsinv)
product_Ads = twin(double.product_Ads)
product_Adinvs = twin(double.product_Adinvs)
product_Adsinv = twin(double.product_Adsinv)
hstx = twin(double.hstx)
hsty = twin(double.hsty)
hstz = twin(double.hstz)
hsrx = twin(double.hsrx)
hsry = twin(double.hsry)
hsrz = twin(double.hsrz)
hstxinv = twin(double.hstxinv)
hstyinv = twin(double.hstyinv)
hstzinv = twin(double.hstzinv)
hsrxinv = twin(double.hsrxinv)
hsryinv = twin(double.hsryinv)
hsrzinv = twin(double.hsrzinv)
Ad = twin(double.Ad)
dot_cs = twin(double.dot_cs)
cross_ss = twin(double.cross_ss)
cross_sst = twin(double.cross_sst)
hsra = twin(double.hsra)
hsta = twin(double.hsta)
hsrainv = twin(double.hsrainv)
hstainv = twin(double.hstainv)
ad = twin(double.ad)
