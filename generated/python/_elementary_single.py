# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions of components in single precision: the same bits as in C."""

from numpy import (absolute, array, asarray, copysign, errstate, float32, int64, uint32, where)


def power_of_two(shifted):
    """2^k by its bits, from 1.5 · 2^23 + k."""
    bits = asarray(shifted, float32).view(uint32)
    one = uint32(127) << 23
    return ((bits << 23) + one).view(float32)[()]


@errstate(all="ignore")
def atan2(y, x):
    """angle = atan2(y, x).  arctan(a/b), and pi/4 + arctan((a - b)/(a + b)) above 1/2, a <= b
    being |x| and |y|; arctan q = q + q^3 p(q^2), p of degree 4, to 2^-27.4; the quotient
    corrected; with all roundings within 0.9 ulp (both proved).  24 mul, 33 add, 1 div, 1 neg, 2
    abs, 2 copysign, 6 less, 1 equal, 14 select.
    """
    height = absolute(y)
    width = absolute(x)
    steep = width < height
    a = where(steep, width, height)
    a_1 = where(steep, height, width)
    infinite = 3.4028235e+38 < a_1
    scale_3 = where(1.2980742e+33 < a_1, float32(9.536743e-07), float32(1.0))
    scale = where(infinite, 0.0, where(a_1 < 2.6843546e+08, 4.8357033e+24, scale_3))
    scaled_a = where(3.4028235e+38 < a, 1.0, a * scale)
    scaled_b_2 = where(infinite, 1.0, a_1 * scale)
    scaled_b = where(scaled_b_2 == 0.0, 1.0, scaled_b_2)
    above = scaled_b < scaled_a + scaled_a
    side = copysign(1.0, x)
    sign = where(steep, -side, side)
    quarters = where(steep, 2.0, 2.0 - (side + side)) + where(above, sign, 0.0)
    base = quarters * 0.78539824
    n_1 = scaled_a + scaled_b
    n = sign * where(above, scaled_a - scaled_b, scaled_a)
    rest_of_d = where(above, scaled_b - n_1 + scaled_a, 0.0)
    d = where(above, n_1, scaled_b)
    inverse = 1.0 / d
    q = n * inverse
    product = q * d
    error_wide_a = 4097.0 * q
    error_high_a = error_wide_a - (error_wide_a - q)
    error_low_a = q - error_high_a
    error_wide_b = 4097.0 * d
    error_high_b = error_wide_b - (error_wide_b - d)
    error_low_b = d - error_high_b
    error_rest2 = error_high_a * error_high_b - product + error_high_a * error_low_b
    error = error_rest2 + error_low_a * error_high_b + error_low_a * error_low_b
    c = (n - product - error - q * rest_of_d) * inverse
    z = q * q
    tail_9 = z * (z * z * (z * -0.051249776 + 0.101558015) + (z * -0.14174214 + 0.19994168))
    tail = q * z * (tail_9 + -0.33333233) + (c - c * z) + quarters * -8.146034e-08
    sum = base + q
    positive = sum + (base - sum + q + tail)
    angle = copysign(positive, y)
    return angle


@errstate(all="ignore")
def exp(x):
    """y = exp x.  x = k ln 2 + r, 3/4 <= e^r <= 3/2, ln 2 as a sum of two numbers; e^r = 1 + r +
    r^2 q(r), q of degree 4, to 2^-27.7; with all roundings within 0.992 ulp (both proved).  12
    mul, 13 add, 1 power of two, 3 less, 4 select.
    """
    within_2 = where(89.0 < x, 89.0, x)
    within = where(within_2 < -104.0, -104.0, within_2)
    shifted = within * 1.442695 - 0.08477783 + 1.2582912e+07
    k = shifted - 1.2582912e+07
    high = within - k * 0.69314575
    rest = k * 1.4286068e-06
    r = high - rest
    low_10 = r * (r * r * (r * 0.0014498823 + 0.008359645) + (r * 0.041661914 + 0.16666575)) + 0.5
    low = r * r * low_10 - rest
    s = high + low
    small = within < -80.0
    e_r = s + 1.0
    scaled = e_r * power_of_two(shifted + where(small, float32(64.0), float32(-1.0)))
    y = scaled * where(small, float32(5.421011e-20), float32(2.0))
    return y


_TWO_OVER_PI = array((
    0.0, 7.9228163e+28, -2.8782106e+28, -7.843851e+24, 2.0349065e+21, -1.2497489e+17, 2.3295903e+13,
    -2.5836913e+10, 2.576384e+06, 2002.0, -0.042236328, 7.426739e-05, -1.4697434e-08, -4.195755e-12,
    -1.4762497e-15, -3.6676527e-19, 5.588639e-23, 8.330371e-28, -8.3200174e-32
), float32)


def two_over_pi(x, n):
    """2/π is the sum of chunks of 12 bits.  Returns 2^96 times the one that is n after the
    first that matters to x modulo 2 π, |x| >= 2 or not finite; for 0 <= n <= 8."""
    biased = (asarray(x, float32).view(uint32) >> 23) & 0xff
    return _TWO_OVER_PI[(biased.astype(int64) - 128) // 12 + int(n)]


def _sincos_near(x):
    """Its reduction of angles up to 12867.0."""
    quadrant = x * 0.63661975 + 1.2582912e+07 - 1.2582912e+07
    high = x - quadrant * 1.5703125 - quadrant * 0.0004837513
    low = quadrant * 7.5495336e-08
    r = high - low
    r_excess = r - high + low + quadrant * 2.563344e-12
    return quadrant, r, r_excess


def _sincos_far(x):
    """Its reduction of larger angles."""
    t0_1 = x * 1.2621775e-29
    t0_2 = t0_1 * 4097.0
    t0_4 = t0_2 - (t0_2 - t0_1)
    t0_5 = t0_1 - t0_4
    t0_7 = two_over_pi(x, 1.0)
    t0_8 = two_over_pi(x, 2.0)
    t0_9 = two_over_pi(x, 3.0)
    t0_10 = two_over_pi(x, 4.0)
    t0_11 = two_over_pi(x, 5.0)
    t0_12 = two_over_pi(x, 6.0)
    t0_13 = two_over_pi(x, 7.0)
    t0 = t0_5 * two_over_pi(x, 0.0) + t0_4 * t0_7
    t1 = t0_5 * t0_7 + t0_4 * t0_8
    t2 = t0_5 * t0_8 + t0_4 * t0_9
    t3 = t0_5 * t0_9 + t0_4 * t0_10
    t4 = t0_5 * t0_10 + t0_4 * t0_11
    t5 = t0_5 * t0_11 + t0_4 * t0_12
    t6 = t0_5 * t0_12 + t0_4 * t0_13
    t7 = t0_5 * t0_13 + t0_4 * two_over_pi(x, 8.0)
    quadrant_3 = t0 - (t0 + 1.006633e+08 - 1.006633e+08)
    quadrant_8 = t1 + 1.2582912e+07 - 1.2582912e+07
    quadrant_10 = quadrant_3 - (quadrant_3 + 5.033165e+07 - 5.033165e+07) + (t1 - quadrant_8)
    quadrant_11 = quadrant_10 + t2
    quadrant_12 = quadrant_11 - quadrant_10
    quadrant_18 = quadrant_11 + 1.2582912e+07 - 1.2582912e+07
    quadrant = quadrant_8 + quadrant_18
    f_1 = quadrant_11 - quadrant_18
    f = f_1 + t3
    f_2 = f - f_1
    quadrant_16 = quadrant_10 - (quadrant_11 - quadrant_12) + (t2 - quadrant_12)
    f_7 = quadrant_16 + (f_1 - (f - f_2) + (t3 - f_2))
    f_9 = f_7 + t4
    f_10 = f_9 - f_7
    f_15 = f_9 + t5
    f_16 = f_15 - f_9
    f_low_1 = f + f_15
    f_low_2 = f_low_1 - f
    f_low_8 = t7 + t6 + (f_9 - (f_15 - f_16) + (t5 - f_16)) + (f_7 - (f_9 - f_10) + (t4 - f_10))
    f_low = f - (f_low_1 - f_low_2) + (f_15 - f_low_2) + f_low_8
    r_1 = f_low_1 * 4097.0
    r_3 = r_1 - (r_1 - f_low_1)
    r_4 = f_low_1 - r_3
    r = f_low_1 * 1.5707964
    r_excess_8 = r - r_3 * 1.5708008 - r_3 * -4.4107437e-06 - r_4 * 1.5708008 - r_4 * -4.4107437e-06
    r_excess = r_excess_8 - (f_low_1 * -4.371139e-08 + f_low * 1.5707964)
    return quadrant, r, r_excess


def _sincos_of(quadrant, r, r_excess):
    z = r * r
    z2 = z * z
    half_z = z * 0.5
    w = 1.0 - half_z
    sin_r = r - (z * r * (0.16666654 + (z * -0.008332106 + z2 * 0.00019507883)) + r_excess * w)
    cos_r_9 = z2 * (0.041666646 + (z * -0.0013887308 + z2 * 2.44321e-05)) + r * r_excess
    cos_r = w + (1.0 - w - half_z + cos_r_9)
    q = quadrant + 5.033165e+07 - 5.033165e+07 - quadrant
    cos_k = 1.0 - absolute(q)
    minus_sin_k = q * (1.0 + cos_k)
    s = sin_r * cos_k - cos_r * minus_sin_k
    c = cos_r * cos_k + sin_r * minus_sin_k
    return s, c


@errstate(all="ignore")
def sincos(x):
    """(s, c) = (sin x, cos x).  x = k pi/2 + r - r_excess, |r| <= pi/4 and little more; pi/2 in
    parts to 2^-10, 2^-22, 2^-34 and a rest, beyond the limit by the digits of 2/pi; polynomials
    of degrees 7 and 8 in r, to 2^-27.8; with all roundings within 0.9 ulp (both proved), for
    every finite x.  17 mul, 19 add, 1 abs.
    """
    quadrant, r, r_excess = _sincos_near(x)
    beyond = absolute(x) > 12867.0
    if beyond.any():
        far = _sincos_far(where(beyond, x, 12867.0))
        quadrant, r, r_excess = (
            where(beyond, a, b) for a, b in zip(far, (quadrant, r, r_excess)))
    return _sincos_of(quadrant, r, r_excess)


def sin(x):
    """sin x, as sincos."""
    return sincos(x)[0]


def cos(x):
    """cos x, as sincos."""
    return sincos(x)[1]


@errstate(all="ignore")
def tanh(x):
    """y = tanh x.  |x| < 5/8: x + x^3 p/q, of degrees 2 and 1 in x^2, to 2^-31.2; beyond: 1 - 2 /
    (e^2|x| + 1), e^2|x| as exp has it; with all roundings within 0.967 ulp (both proved).  20
    mul, 24 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select.
    """
    size = absolute(x)
    small = size < 0.625
    z = size * size
    above = size * z * ((z * 5.9599424e-05 + -0.0017358434) * z + -0.33333334)
    below = z * 0.4052077 + 1.0
    twice_1 = size + size
    twice = where(20.0 < twice_1, 20.0, twice_1)
    shifted = twice * 1.442695 - 0.08477783 + 1.2582912e+07
    k = shifted - 1.2582912e+07
    high = twice - k * 0.69314575
    rest = k * 1.4286068e-06
    r = high - rest
    low_10 = r * (r * r * (r * 0.0014498823 + 0.008359645) + (r * 0.041661914 + 0.16666575)) + 0.5
    low = r * r * low_10 - rest
    s = high + low
    power = power_of_two(shifted)
    rest_of_e_1 = power + 1.0
    rest_of_e = s * power
    total = rest_of_e_1 + rest_of_e
    low_of_total = rest_of_e_1 - total + rest_of_e
    quotient = where(small, above, -2.0) / where(small, below, total)
    correction = where(small, 0.0, quotient * low_of_total * (quotient * 0.5))
    start = where(small, size, 1.0)
    sum_1 = start + quotient
    sum = sum_1 + (start - sum_1 + quotient + correction)
    y = copysign(sum, x)
    return y
