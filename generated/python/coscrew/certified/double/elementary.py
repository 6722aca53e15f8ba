# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions, with the same bits on every machine.

In double precision, certified tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("()->(),(),(),()")
@errstate(all="ignore")
def sincos(x, *, c1=3.7470896994678994e-30):
    """s = sin x, c = cos x, x in rad; |error of s| <= s_bound, |error of c| <= c_bound unless inf
    or NaN.

    ()->(),(),(),().  x, s, c, s_bound, c_bound: number.
    83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select.
    """
    s, c = elementary.sincos(x)
    s_own_error_1, c_own_error_1 = elementary.sincos_error(x, s, c)
    s_bound_1 = c1 + absolute(s_own_error_1)
    c_bound_1 = c1 + absolute(c_own_error_1)
    return (s, c, s_bound_1, c_bound_1)


@kernel("()->(),()")
@errstate(all="ignore")
def sin(x, *, c1=3.7470896994678994e-30):
    """s = sin x, x in rad; |error of s| <= s_bound unless inf or NaN.

    ()->(),().  x, s, s_bound: number.
    83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select.
    """
    s = elementary.sin(x)
    s_bound_1 = c1 + absolute(elementary.sin_error(x, s))
    return (s, s_bound_1)


@kernel("()->(),()")
@errstate(all="ignore")
def cos(x, *, c1=3.7470896994678994e-30):
    """c = cos x, x in rad; |error of c| <= c_bound unless inf or NaN.

    ()->(),().  x, c, c_bound: number.
    83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select.
    """
    c = elementary.cos(x)
    c_bound_1 = c1 + absolute(elementary.cos_error(x, c))
    return (c, c_bound_1)


@kernel("()->(),()")
@errstate(all="ignore")
def exp(x, *, c1=1.8051943758648296e-276, c2=3.7470896994679e-30):
    """y = e^x; |error of y| <= y_bound unless inf or NaN.

    ()->(),().  x, y, y_bound: number.
    82 mul, 149 add, 14 product error, 5 power of two, 2 abs, 7 less, 1 equal, 9 select.
    """
    y = elementary.exp(x)
    y_bound_1 = absolute(elementary.exp_error(x, y)) + c2 * (c1 + y)
    return (y, y_bound_1)


@kernel("()->(),()")
@errstate(all="ignore")
def tanh(x, *, c1=1.8051943758648296e-276, c2=3.7470896994679e-30):
    """y = tanh x; |error of y| <= y_bound unless inf or NaN.

    ()->(),().  x, y, y_bound: number.
    92 mul, 175 add, 15 product error, 2 div, 2 power of two, 6 abs, 2 copysign, 5 less, 11
    select.
    """
    y = elementary.tanh(x)
    y_bound_1 = absolute(elementary.tanh_error(x, y)) + c2 * (c1 + absolute(y))
    return (y, y_bound_1)


@kernel("(),()->(),()")
@errstate(all="ignore")
def atan2(y, x, *, c1=1.8051943758648296e-276, c2=3.7470896994679e-30):
    """angle of the vector (x, y) to the x axis, in rad, from -π to π; |error of angle| <=
    angle_bound unless inf or NaN.

    (),()->(),().  y, x, angle, angle_bound: number.
    123 mul, 214 add, 21 product error, 2 div, 1 neg, 10 abs, 4 copysign, 13 less, 3 equal, 23
    select.
    """
    angle = elementary.atan2(y, x)
    angle_bound_1 = absolute(elementary.atan2_error(y, x, angle)) + c2 * (c1 + absolute(angle))
    return (angle, angle_bound_1)
