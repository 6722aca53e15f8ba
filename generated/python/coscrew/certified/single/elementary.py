# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions, with the same bits on every machine.

In single precision, certified tier.
"""

from coscrew import _elementary_single as elementary
from numpy import absolute
from coscrew._kernel import single_kernel as kernel
from numpy import errstate


@kernel("()->(),(),(),()")
@errstate(all="ignore")
def sincos(x):
    """s = sin x, c = cos x, x in rad; |error of s| <= s_bound, |error of c| <= c_bound unless inf
    or NaN.

    ()->(),(),(),().  x, s, c, s_bound, c_bound: number.
    65 mul, 100 add, 8 product error, 1 div, 5 abs, 1 less, 1 select.
    """
    s, c = elementary.sincos(x)
    s_own_error_1, c_own_error_1 = elementary.sincos_error(x, s, c)
    s_bound_1 = 1.0800312e-12 + absolute(s_own_error_1)
    c_bound_1 = 1.0800312e-12 + absolute(c_own_error_1)
    return (s, c, s_bound_1, c_bound_1)


@kernel("()->(),()")
@errstate(all="ignore")
def sin(x):
    """s = sin x, x in rad; |error of s| <= s_bound unless inf or NaN.

    ()->(),().  x, s, s_bound: number.
    65 mul, 99 add, 8 product error, 1 div, 4 abs, 1 less, 1 select.
    """
    s = elementary.sin(x)
    s_bound_1 = 1.0800312e-12 + absolute(elementary.sin_error(x, s))
    return (s, s_bound_1)


@kernel("()->(),()")
@errstate(all="ignore")
def cos(x):
    """c = cos x, x in rad; |error of c| <= c_bound unless inf or NaN.

    ()->(),().  x, c, c_bound: number.
    65 mul, 99 add, 8 product error, 1 div, 4 abs, 1 less, 1 select.
    """
    c = elementary.cos(x)
    c_bound_1 = 1.0800312e-12 + absolute(elementary.cos_error(x, c))
    return (c, c_bound_1)


@kernel("()->(),()")
@errstate(all="ignore")
def exp(x):
    """y = e^x; |error of y| <= y_bound unless inf or NaN.

    ()->(),().  x, y, y_bound: number.
    52 mul, 98 add, 8 product error, 5 power of two, 2 abs, 7 less, 1 equal, 9 select.
    """
    y = elementary.exp(x)
    y_bound_1 = absolute(elementary.exp_error(x, y)) + 1.0800314e-12 * (3.308722450212111e-24 + y)
    return (y, y_bound_1)


@kernel("()->(),()")
@errstate(all="ignore")
def tanh(x):
    """y = tanh x; |error of y| <= y_bound unless inf or NaN.

    ()->(),().  x, y, y_bound: number.
    60 mul, 122 add, 9 product error, 2 div, 2 power of two, 6 abs, 2 copysign, 5 less, 11
    select.
    """
    y = elementary.tanh(x)
    y_bound_1 = (absolute(elementary.tanh_error(x, y)) + 1.0800314e-12
        * (3.308722450212111e-24 + absolute(y)))
    return (y, y_bound_1)


@kernel("(),()->(),()")
@errstate(all="ignore")
def atan2(y, x):
    """angle of the vector (x, y) to the x axis, in rad, from -π to π; |error of angle| <=
    angle_bound unless inf or NaN.

    (),()->(),().  y, x, angle, angle_bound: number.
    89 mul, 155 add, 14 product error, 2 div, 1 neg, 10 abs, 4 copysign, 13 less, 3 equal, 23
    select.
    """
    angle = elementary.atan2(y, x)
    angle_bound_1 = (absolute(elementary.atan2_error(y, x, angle)) + 1.0800314e-12
        * (3.308722450212111e-24 + absolute(angle)))
    return (angle, angle_bound_1)
