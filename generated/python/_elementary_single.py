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
    being |x| and |y|; arctan q = q + q^3 p(q^2), p of degree 5, to 2^-31.7; the quotient to
    more than its digits; with all roundings within 0.896 ulp (both proved), results below the
    normal range within 0.51 of the least subnormal number.  22 mul, 29 add, 1 div, 1 neg, 2
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
    total = scaled_a + scaled_b
    n = sign * where(above, scaled_a - scaled_b, scaled_a)
    rest_of_d = where(above, scaled_b - total + scaled_a, 0.0)
    d = where(above, total, scaled_b)
    inverse = 1.0 / d
    q_high_1 = n * inverse
    q_high_2 = q_high_1 * 4097.0
    q_high = q_high_2 - (q_high_2 - q_high_1)
    d_high_1 = d * 4097.0
    d_high = d_high_1 - (d_high_1 - d)
    d_low = d - d_high
    but_high = n - q_high * d_high
    but_low = but_high - q_high * d_low
    c = (but_low - q_high * rest_of_d) * inverse
    q = q_high + c
    z = q * q
    tail_6 = z * z
    tail_8 = tail_6 * (z * -0.08009076 + 0.10948411) + (z * -0.14273107 + 0.19999555)
    tail_15 = q * z * (z * (tail_6 * tail_6 * 0.039042152 + tail_8) + -0.33333328) + c
    tail = tail_15 + quarters * -8.146034e-08
    sum = base + q_high
    positive = sum + (base - sum + q_high + tail)
    angle = copysign(positive, y)
    return angle


@errstate(all="ignore")
def exp(x):
    """y = exp x.  x = k ln 2 + r, |r| <= ln 2 / 2, ln 2 as a sum of two numbers; e^r = 1 + r + r^2
    q(r), q of degree 4, to 2^-27.9; with all roundings within 0.757 ulp (both proved), results
    below the normal range within 0.88 of the least subnormal number.  12 mul, 15 add, 1 power
    of two, 3 less, 4 select.
    """
    within_2 = where(89.0 < x, 89.0, x)
    within = where(within_2 < -104.0, -104.0, within_2)
    shifted = within * 1.442695 + 1.2582912e+07
    k = shifted - 1.2582912e+07
    high = within - k * 0.69314575
    rest = k * 1.4286068e-06
    r = high - rest
    low_10 = r * (r * r * (r * 0.0013863435 + 0.008367437) + (r * 0.04166724 + 0.16666535)) + 0.5
    low = r * r * low_10 - rest
    small = within < -80.0
    start = high + 1.0
    e_r = start + (1.0 - start + high + low)
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
    """Its reduction of angles up to 1607.0."""
    quadrant = x * 0.63661975 + 1.2582912e+07 - 1.2582912e+07
    high = x - quadrant * 1.5706787 - quadrant * 0.000117599964
    low = quadrant * 1.589251e-08
    r = high - low
    r_excess = r - high + low + quadrant * 7.443548e-13
    return quadrant, r, r_excess


def _sincos_far(x):
    """Its reduction of larger angles."""
    scaled = x * 1.2621775e-29
    x_high_1 = scaled * 4097.0
    x_high = x_high_1 - (x_high_1 - scaled)
    x_low = scaled - x_high
    chunk0 = two_over_pi(x, 0.0)
    chunk1 = two_over_pi(x, 1.0)
    chunk2 = two_over_pi(x, 2.0)
    chunk3 = two_over_pi(x, 3.0)
    chunk4 = two_over_pi(x, 4.0)
    chunk5 = two_over_pi(x, 5.0)
    chunk6 = two_over_pi(x, 6.0)
    chunk7 = two_over_pi(x, 7.0)
    chunk8 = two_over_pi(x, 8.0)
    t0 = x_low * chunk0 + x_high * chunk1
    t1 = x_low * chunk1 + x_high * chunk2
    t2 = x_low * chunk2 + x_high * chunk3
    t3 = x_low * chunk3 + x_high * chunk4
    t4 = x_low * chunk4 + x_high * chunk5
    t5 = x_low * chunk5 + x_high * chunk6
    t6 = x_low * chunk6 + x_high * chunk7
    t7 = x_low * chunk7 + x_high * chunk8
    rest0 = t0 - (t0 + 1.006633e+08 - 1.006633e+08)
    rest4 = rest0 - (rest0 + 5.033165e+07 - 5.033165e+07)
    k1 = t1 + 1.2582912e+07 - 1.2582912e+07
    sum2_2 = rest4 + (t1 - k1)
    sum2 = sum2_2 + t2
    sum2_error_1 = sum2 - sum2_2
    sum2_error = sum2_2 - (sum2 - sum2_error_1) + (t2 - sum2_error_1)
    k2 = sum2 + 1.2582912e+07 - 1.2582912e+07
    sum2_rest = sum2 - k2
    sum3 = sum2_rest + t3
    sum3_error_1 = sum3 - sum2_rest
    sum3_error = sum2_rest - (sum3 - sum3_error_1) + (t3 - sum3_error_1)
    low3 = sum2_error + sum3_error
    tail = t7 + t6
    low4 = low3 + t4
    low4_error_1 = low4 - low3
    low4_error = low3 - (low4 - low4_error_1) + (t4 - low4_error_1)
    tail4 = tail + low4_error
    low5 = low4 + t5
    low5_error_1 = low5 - low4
    low5_error = low4 - (low5 - low5_error_1) + (t5 - low5_error_1)
    tail5 = tail4 + low5_error
    f = sum3 + low5
    f_error_1 = f - sum3
    f_error = sum3 - (f - f_error_1) + (low5 - f_error_1)
    f_low = f_error + tail5
    f_part_high_1 = f * 4097.0
    f_part_high = f_part_high_1 - (f_part_high_1 - f)
    f_part_low = f - f_part_high
    product = f * 1.5707964
    product_excess_4 = product - f_part_high * 1.5708008 - f_part_high * -4.4107437e-06
    product_excess = product_excess_4 - f_part_low * 1.5708008 - f_part_low * -4.4107437e-06
    rest = product_excess - (f * -4.371139e-08 + f_low * 1.5707964)
    r = product - rest
    r_excess = r - product + rest
    quadrant = k1 + k2
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
    parts to 2^-13, 2^-24, 2^-39 and a rest, beyond the limit by the digits of 2/pi; polynomials
    of degrees 7 and 8 in r, to 2^-27.8; with all roundings within 0.85 ulp (both proved), for
    every finite x.  17 mul, 19 add, 1 abs.
    """
    quadrant, r, r_excess = _sincos_near(x)
    beyond = absolute(x) > 1607.0
    if beyond.any():
        far = _sincos_far(where(beyond, x, 1607.0))
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
    mul, 23 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select.
    """
    size = absolute(x)
    small = size < 0.625
    z = size * size
    above = size * z * ((z * 5.9599424e-05 + -0.0017358434) * z + -0.33333334)
    below = z * 0.4052077 + 1.0
    twice_1 = size + size
    twice = where(20.0 < twice_1, 20.0, twice_1)
    shifted = twice * 1.442695 + 1.2582912e+07
    k = shifted - 1.2582912e+07
    high = twice - k * 0.69314575
    rest = k * 1.4286068e-06
    r = high - rest
    low_10 = r * (r * r * (r * 0.0013863435 + 0.008367437) + (r * 0.04166724 + 0.16666535)) + 0.5
    low = r * r * low_10 - rest
    power = power_of_two(shifted)
    s_1 = power + 1.0
    s = high + low
    rest_of_e = s * power
    total = s_1 + rest_of_e
    low_of_total = s_1 - total + rest_of_e
    quotient = where(small, above, -2.0) / where(small, below, total)
    correction = where(small, 0.0, quotient * low_of_total * (quotient * 0.5))
    start = where(small, size, 1.0)
    sum_1 = start + quotient
    sum = sum_1 + (start - sum_1 + quotient + correction)
    y = copysign(sum, x)
    return y
