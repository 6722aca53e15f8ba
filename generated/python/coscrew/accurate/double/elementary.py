# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions, with the same bits on every machine.

In double precision, accurate tier.
"""

from coscrew import _elementary_double as elementary
from numpy import where
from coscrew._kernel import double_kernel as kernel


@kernel("()->(),()")
def sincos(x):
    """s = sin x, c = cos x, x in rad.

    ()->(),().  x, s, c: number.
    83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.  Error <= 0.501
    ulp, unless a result is subnormal; proved.
    """
    s, c = elementary.sincos(x)
    s_own_error, c_own_error = elementary.sincos_error(x, s, c)
    s_rounded = s + s_own_error
    c_rounded = c + c_own_error
    s_final = where(s_rounded == s_rounded, s_rounded, s)
    c_final = where(c_rounded == c_rounded, c_rounded, c)
    return (s_final, c_final)


@kernel("()->()")
def sin(x):
    """s = sin x, x in rad.

    ()->().  x, s: number.
    83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.  Error <= 0.501
    ulp, unless a result is subnormal; proved.
    """
    s = elementary.sin(x)
    s_rounded = s + elementary.sin_error(x, s)
    s_final = where(s_rounded == s_rounded, s_rounded, s)
    return s_final


@kernel("()->()")
def cos(x):
    """c = cos x, x in rad.

    ()->().  x, c: number.
    83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.  Error <= 0.501
    ulp, unless a result is subnormal; proved.
    """
    c = elementary.cos(x)
    c_rounded = c + elementary.cos_error(x, c)
    c_final = where(c_rounded == c_rounded, c_rounded, c)
    return c_final


@kernel("()->()")
def exp(x):
    """y = e^x.

    ()->().  x, y: number.
    81 mul, 148 add, 14 product error, 5 power of two, 1 abs, 7 less, 2 equal, 10 select.  Error
    <= 0.501 ulp, unless a result is subnormal; proved.
    """
    y = elementary.exp(x)
    y_rounded = y + elementary.exp_error(x, y)
    y_final = where(y_rounded == y_rounded, y_rounded, y)
    return y_final


@kernel("()->()")
def tanh(x):
    """y = tanh x.

    ()->().  x, y: number.
    91 mul, 174 add, 15 product error, 2 div, 2 power of two, 4 abs, 2 copysign, 5 less, 1
    equal, 12 select.  Error <= 0.501 ulp, unless a result is subnormal; proved.
    """
    y = elementary.tanh(x)
    y_rounded = y + elementary.tanh_error(x, y)
    y_final = where(y_rounded == y_rounded, y_rounded, y)
    return y_final


@kernel("(),()->()")
def atan2(y, x):
    """angle of the vector (x, y) to the x axis, in rad, from -π to π.

    (),()->().  y, x, angle: number.
    122 mul, 213 add, 21 product error, 2 div, 1 neg, 8 abs, 4 copysign, 13 less, 4 equal, 24
    select.  Error <= 0.501 ulp, unless a result is subnormal; proved.
    """
    angle = elementary.atan2(y, x)
    angle_rounded = angle + elementary.atan2_error(y, x, angle)
    angle_final = where(angle_rounded == angle_rounded, angle_rounded, angle)
    return angle_final
