# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions, with the same bits on every machine.

In single precision, plain tier.
"""

from coscrew import _elementary_single as elementary
from coscrew._kernel import single_kernel as kernel


@kernel("()->(),()")
def sincos(x):
    """s = sin x, c = cos x, x in rad.

    ()->(),().  x, s, c: number.
    22 mul, 27 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
    subnormal; proved.
    """
    s, c = elementary.sincos(x)
    return (s, c)


@kernel("()->()")
def sin(x):
    """s = sin x, x in rad.

    ()->().  x, s: number.
    22 mul, 27 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
    subnormal; proved.
    """
    s = elementary.sin(x)
    return s


@kernel("()->()")
def cos(x):
    """c = cos x, x in rad.

    ()->().  x, c: number.
    22 mul, 27 add, 1 abs.  Error <= 0.824 ulp, in single precision 0.85 ulp, unless a result is
    subnormal; proved.
    """
    c = elementary.cos(x)
    return c


@kernel("()->()")
def exp(x):
    """y = e^x.

    ()->().  x, y: number.
    12 mul, 15 add, 1 power of two, 3 less, 4 select.  Error <= 0.755 ulp, in single precision
    0.757 ulp, unless a result is subnormal; proved.
    """
    y = elementary.exp(x)
    return y


@kernel("()->()")
def tanh(x):
    """y = tanh x.

    ()->().  x, y: number.
    20 mul, 23 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select.  Error <= 0.979
    ulp, in single precision 0.967 ulp, unless a result is subnormal; proved.
    """
    y = elementary.tanh(x)
    return y


@kernel("(),()->()")
def atan2(y, x):
    """angle of the vector (x, y) to the x axis, in rad, from -π to π.

    (),()->().  y, x, angle: number.
    22 mul, 29 add, 1 div, 1 neg, 2 abs, 2 copysign, 6 less, 1 equal, 14 select.  Error <= 0.934
    ulp, in single precision 0.896 ulp, unless a result is subnormal; proved.
    """
    angle = elementary.atan2(y, x)
    return angle
