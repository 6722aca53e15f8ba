# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions of components in single precision: the same bits as in C."""

from numpy import (absolute, array, asarray, copysign, errstate, float32, int64, uint32, where)

from ._exact import product_error_single as product_error


def power_of_two(shifted):
    """2^k by its bits, from 1.5 · 2^23 + k."""
    bits = asarray(shifted, float32).view(uint32)
    one = uint32(127) << 23
    return ((bits << 23) + one).view(float32)[()]

_TWO_OVER_PI = array((
    0.0, 7.9228163e+28, -2.8782106e+28, -7.843851e+24, 2.0349065e+21, -1.2497489e+17, 2.3295903e+13,
    -2.5836913e+10, 2.576384e+06, 2002.0, -0.042236328, 7.426739e-05, -1.4697434e-08, -4.195755e-12,
    -1.4762497e-15, -3.6676527e-19, 5.588639e-23, 8.330371e-28, -8.3200174e-32, 2.6782463e-34
), float32)


def two_over_pi(x, n):
    """2/π is the sum of chunks of 12 bits.  Returns 2^96 times the one that is n after the
    first that matters to x modulo 2 π, |x| >= 2 or not finite; for 0 <= n <= 9."""
    biased = (asarray(x, float32).view(uint32) >> 23) & 0xff
    return _TWO_OVER_PI[(biased.astype(int64) - 128) // 12 + int(n)]


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


@errstate(all="ignore")
def atan2_error(y, x, angle):
    """angle_error = atan2(y, x) - angle, angle as atan2 has it.  (y c - x s) / (x c + y s), s and
    c the angle's sine and cosine as pairs; angle + angle_error is within 2^-42.1 of atan2(y,
    x), relative to it (proved), and 0.51 of the least subnormal number; 0 where the angle is 0.
    66 mul, 124 add, 14 product error, 1 div, 6 abs, 2 copysign, 7 less, 2 equal, 9 select.
    """
    quadrant = angle * 0.63661975 + 1.2582912e+07 - 1.2582912e+07
    high = angle - quadrant * 1.5706787 - quadrant * 0.000117599964
    a_1 = quadrant * -1.589251e-08
    a = high + a_1
    a_error_1 = a - high
    a_error = high - (a - a_error_1) + (a_1 - a_error_1)
    fourth = a_error - quadrant * 7.442935e-13
    b = a + fourth
    b_error = fourth - (b - a)
    fifth = b_error - quadrant * 6.123032e-17
    r = b + fifth
    r_error = fifth - (r - b)
    r_low = r_error - quadrant * 2.0222662e-21
    argument = where(absolute(r) < 2.9802322e-08, 0.0, r)
    z = argument * argument
    z_error = product_error(argument, argument, z)
    z_low = z_error + (argument * r_low + r_low * argument)
    sin6 = z * (z * 2.8114574e-15 + -7.6471636e-13) + 1.6059044e-10
    sin5_z = z * sin6
    sin5 = -2.5052108e-08 + sin5_z
    sin5_error = sin5_z - (sin5 - -2.5052108e-08)
    sin5_low = -4.417623e-16 + sin5_error
    sin4_z = z * sin5
    sin4 = 2.7557319e-06 + sin4_z
    sin4_error = sin4_z - (sin4 - 2.7557319e-06)
    sin4_low_6 = sin5 * z_low + product_error(z, sin5, sin4_z) + 3.7935712e-14 + sin4_error
    sin4_low = sin4_low_6 + z * sin5_low
    sin3_z = z * sin4
    sin3 = -0.0001984127 + sin3_z
    sin3_error = sin3_z - (sin3 - -0.0001984127)
    sin3_low_6 = sin4 * z_low + product_error(z, sin4, sin3_z) + 2.7255969e-12 + sin3_error
    sin3_low = sin3_low_6 + z * sin4_low
    sin2_z = z * sin3
    sin2 = 0.008333334 + sin2_z
    sin2_error = sin2_z - (sin2 - 0.008333334)
    sin2_low_6 = sin3 * z_low + product_error(z, sin3, sin2_z) + -4.346172e-10 + sin2_error
    sin2_low = sin2_low_6 + z * sin3_low
    sin1_z = z * sin2
    sin1 = -0.16666667 + sin1_z
    sin1_error = sin1_z - (sin1 - -0.16666667)
    sin1_low_6 = sin2 * z_low + product_error(z, sin2, sin1_z) + 4.967054e-09 + sin1_error
    sin1_low = sin1_low_6 + z * sin2_low
    sin_sum = z * sin1
    sin_sum_error = product_error(z, sin1, sin_sum)
    sin_sum_low = sin_sum_error + (z * sin1_low + z_low * sin1)
    sin_r_more = r * sin_sum
    sin_r_more_error = product_error(r, sin_sum, sin_r_more)
    sin_r_more_low = sin_r_more_error + (r * sin_sum_low + r_low * sin_sum)
    sin_r = r + sin_r_more
    sin_r_error = sin_r_more - (sin_r - r)
    sin_r_low = sin_r_error + (sin_r_more_low + r_low)
    cos6 = z * (z * 4.7794773e-14 + -1.1470745e-11) + 2.0876756e-09
    cos5_z = z * cos6
    cos5 = -2.755732e-07 + cos5_z
    cos5_error = cos5_z - (cos5 - -2.755732e-07)
    cos5_low = 7.575112e-15 + cos5_error
    cos4_z = z * cos5
    cos4 = 2.4801588e-05 + cos4_z
    cos4_error = cos4_z - (cos4 - 2.4801588e-05)
    cos4_low_6 = cos5 * z_low + product_error(z, cos5, cos4_z) + -3.406996e-13 + cos4_error
    cos4_low = cos4_low_6 + z * cos5_low
    cos3_z = z * cos4
    cos3 = -0.0013888889 + cos3_z
    cos3_error = cos3_z - (cos3 - -0.0013888889)
    cos3_low_6 = cos4 * z_low + product_error(z, cos4, cos3_z) + 3.3631094e-11 + cos3_error
    cos3_low = cos3_low_6 + z * cos4_low
    cos2_z = z * cos3
    cos2 = 0.041666668 + cos2_z
    cos2_error = cos2_z - (cos2 - 0.041666668)
    cos2_low_6 = cos3 * z_low + product_error(z, cos3, cos2_z) + -1.2417635e-09 + cos2_error
    cos2_low = cos2_low_6 + z * cos3_low
    cos1_z = z * cos2
    cos1 = -0.5 + cos1_z
    cos1_error = cos1_z - (cos1 - -0.5)
    cos1_low = cos2 * z_low + product_error(z, cos2, cos1_z) + cos1_error + z * cos2_low
    cos_sum = z * cos1
    cos_sum_error = product_error(z, cos1, cos_sum)
    cos_sum_low = cos_sum_error + (z * cos1_low + z_low * cos1)
    cos_r = 1.0 + cos_sum
    cos_r_error = cos_sum - (cos_r - 1.0)
    cos_r_low = cos_r_error + cos_sum_low
    sine = sin_r + sin_r_low
    sine_low = sin_r_low - (sine - sin_r)
    cosine = cos_r + cos_r_low
    cosine_low = cos_r_low - (cosine - cos_r)
    q = quadrant + 5.033165e+07 - 5.033165e+07 - quadrant
    cos_k = 1.0 - absolute(q)
    minus_sin_k = q * (1.0 + cos_k)
    sin_x = sine * cos_k - cosine * minus_sin_k
    sin_x_low = sine_low * cos_k - cosine_low * minus_sin_k
    cos_x = cosine * cos_k + sine * minus_sin_k
    cos_x_low = cosine_low * cos_k + sine_low * minus_sin_k
    size_1 = absolute(y)
    size_2 = absolute(x)
    size = where(size_1 < size_2, size_2, size_1)
    scale_3 = where(1.2980742e+33 < size, float32(9.536743e-07), float32(1.0))
    scale = where(3.4028235e+38 < size, 0.0, where(size < 2.6843546e+08, 4.8357033e+24, scale_3))
    scaled_y_2 = copysign(1.0, x)
    scaled_y = where(3.4028235e+38 < absolute(y), copysign(1.0, y), y * scale)
    scaled_x_4 = where(3.4028235e+38 < absolute(x), scaled_y_2, x * scale)
    scaled_x = where(size == 0.0, scaled_y_2, scaled_x_4)
    upward = scaled_y * cos_x
    across = scaled_x * sin_x
    upward_rest = product_error(scaled_y, cos_x, upward)
    across_rest = product_error(scaled_x, sin_x, across)
    low = upward_rest - across_rest + (scaled_y * cos_x_low - scaled_x * sin_x_low)
    turn = (upward - across + low) / (scaled_x * cos_x + scaled_y * sin_x)
    angle_error = where(angle == 0.0, 0.0, turn)
    return angle_error


@errstate(all="ignore")
def exp_error(x, y):
    """y_error = exp x - y, y as exp has it.  x = k ln 2 + r, r as a pair; a Taylor polynomial of
    degree 13 in pairs; y + y_error is within 2^-43.7 of exp x, relative to it (proved), and
    0.51 of the least subnormal number; 0 where y is 0 or infinite.  39 mul, 81 add, 8 product
    error, 4 power of two, 1 abs, 4 less, 1 equal, 5 select.
    """
    within_2 = where(89.0 < x, 89.0, x)
    within = where(within_2 < -104.0, -104.0, within_2)
    shifted = within * 1.442695 + 1.2582912e+07
    k = shifted - 1.2582912e+07
    high = within - k * 0.69314575
    second = k * -1.4285906e-06
    rest = k * -1.619851e-11
    r = high + second
    r_error_1 = r - high
    r_error = high - (r - r_error_1) + (second - r_error_1)
    r_low = r_error + rest
    argument = where(absolute(r) < 2.9802322e-08, 0.0, r)
    term8_6 = argument * argument * (argument * 1.6059044e-10 + 2.0876756e-09)
    term8 = argument * (term8_6 + (argument * 2.5052108e-08 + 2.755732e-07)) + 2.7557319e-06
    term7_z = argument * term8
    term7 = 2.4801588e-05 + term7_z
    term7_error = term7_z - (term7 - 2.4801588e-05)
    term7_low = -3.406996e-13 + term7_error
    term6_z = argument * term7
    term6 = 0.0001984127 + term6_z
    term6_error = term6_z - (term6 - 0.0001984127)
    term6_low_5 = term7 * r_low + product_error(argument, term7, term6_z) + -2.7255969e-12
    term6_low = term6_low_5 + term6_error + argument * term7_low
    term5_z = argument * term6
    term5 = 0.0013888889 + term5_z
    term5_error = term5_z - (term5 - 0.0013888889)
    term5_low_5 = term6 * r_low + product_error(argument, term6, term5_z) + -3.3631094e-11
    term5_low = term5_low_5 + term5_error + argument * term6_low
    term4_z = argument * term5
    term4 = 0.008333334 + term4_z
    term4_error = term4_z - (term4 - 0.008333334)
    term4_low_5 = term5 * r_low + product_error(argument, term5, term4_z) + -4.346172e-10
    term4_low = term4_low_5 + term4_error + argument * term5_low
    term3_z = argument * term4
    term3 = 0.041666668 + term3_z
    term3_error = term3_z - (term3 - 0.041666668)
    term3_low_5 = term4 * r_low + product_error(argument, term4, term3_z) + -1.2417635e-09
    term3_low = term3_low_5 + term3_error + argument * term4_low
    term2_z = argument * term3
    term2 = 0.16666667 + term2_z
    term2_error = term2_z - (term2 - 0.16666667)
    term2_low_5 = term3 * r_low + product_error(argument, term3, term2_z) + -4.967054e-09
    term2_low = term2_low_5 + term2_error + argument * term3_low
    term1_z = argument * term2
    term1 = 0.5 + term1_z
    term1_error = term1_z - (term1 - 0.5)
    term1_low_5 = term2 * r_low + product_error(argument, term2, term1_z) + term1_error
    term1_low = term1_low_5 + argument * term2_low
    term_sum = argument * term1
    term_sum_error = product_error(argument, term1, term_sum)
    term_sum_low = term_sum_error + (argument * term1_low + r_low * term1)
    grown_more = r * term_sum
    grown_more_error = product_error(r, term_sum, grown_more)
    grown_more_low = grown_more_error + (r * term_sum_low + r_low * term_sum)
    grown = r + grown_more
    grown_error = grown_more - (grown - r)
    grown_low = grown_error + (grown_more_low + r_low)
    e_r = 1.0 + grown
    e_r_error = grown - (e_r - 1.0)
    e_r_low = e_r_error + grown_low
    first_shifted = k * 0.5 + 1.2582912e+07
    k_first = first_shifted - 1.2582912e+07
    k_second = k - k_first
    down0 = power_of_two(1.2582912e+07 - k_first)
    down1 = power_of_two(1.2582912e+07 - k_second)
    up0 = power_of_two(1.2582912e+07 + k_first)
    up1 = power_of_two(1.2582912e+07 + k_second)
    y_scaled = y * down0 * down1
    error = e_r - y_scaled + e_r_low
    scaled = error * up0 * up1
    y_error = where(y == 0.0, 0.0, where(3.4028235e+38 < y, 0.0, scaled))
    return y_error


def _sincos_error_near(x):
    """Its reduction of angles up to 1607.0."""
    quadrant = x * 0.63661975 + 1.2582912e+07 - 1.2582912e+07
    high = x - quadrant * 1.5706787 - quadrant * 0.000117599964
    a_1 = quadrant * -1.589251e-08
    a = high + a_1
    a_error_1 = a - high
    a_error = high - (a - a_error_1) + (a_1 - a_error_1)
    fourth = a_error - quadrant * 7.442935e-13
    b = a + fourth
    b_error = fourth - (b - a)
    fifth = b_error - quadrant * 6.123032e-17
    r = b + fifth
    r_error = fifth - (r - b)
    r_low = r_error - quadrant * 2.0222662e-21
    return quadrant, r, r_low


def _sincos_error_far(x):
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
    chunk9 = two_over_pi(x, 9.0)
    t0 = x_low * chunk0 + x_high * chunk1
    t1 = x_low * chunk1 + x_high * chunk2
    t2 = x_low * chunk2 + x_high * chunk3
    t3 = x_low * chunk3 + x_high * chunk4
    t4 = x_low * chunk4 + x_high * chunk5
    t5 = x_low * chunk5 + x_high * chunk6
    t6 = x_low * chunk6 + x_high * chunk7
    t7 = x_low * chunk7 + x_high * chunk8
    t8 = x_low * chunk8 + x_high * chunk9
    rest0 = t0 - (t0 + 1.006633e+08 - 1.006633e+08)
    rest4 = rest0 - (rest0 + 5.033165e+07 - 5.033165e+07)
    k1 = t1 + 1.2582912e+07 - 1.2582912e+07
    sum2_2 = rest4 + (t1 - k1)
    sum2 = sum2_2 + t2
    sum2_error_1 = sum2 - sum2_2
    sum2_error = sum2_2 - (sum2 - sum2_error_1) + (t2 - sum2_error_1)
    k2 = sum2 + 1.2582912e+07 - 1.2582912e+07
    sum2_rest = sum2 - k2
    f_a6 = t7 + t8
    f_a6_error_1 = f_a6 - t7
    f_a6_error = t7 - (f_a6 - f_a6_error_1) + (t8 - f_a6_error_1)
    f_a5 = t6 + f_a6
    f_a5_error_1 = f_a5 - t6
    f_a5_error = t6 - (f_a5 - f_a5_error_1) + (f_a6 - f_a5_error_1)
    f_a4 = t5 + f_a5
    f_a4_error_1 = f_a4 - t5
    f_a4_error = t5 - (f_a4 - f_a4_error_1) + (f_a5 - f_a4_error_1)
    f_a3 = t4 + f_a4
    f_a3_error_1 = f_a3 - t4
    f_a3_error = t4 - (f_a3 - f_a3_error_1) + (f_a4 - f_a3_error_1)
    f_a2 = sum2_error + f_a3
    f_a2_error_1 = f_a2 - sum2_error
    f_a2_error = sum2_error - (f_a2 - f_a2_error_1) + (f_a3 - f_a2_error_1)
    f_a1 = t3 + f_a2
    f_a1_error_1 = f_a1 - t3
    f_a1_error = t3 - (f_a1 - f_a1_error_1) + (f_a2 - f_a1_error_1)
    f_a0 = sum2_rest + f_a1
    f_a0_error_1 = f_a0 - sum2_rest
    f_a0_error = sum2_rest - (f_a0 - f_a0_error_1) + (f_a1 - f_a0_error_1)
    f_b6 = f_a5_error + f_a6_error
    f_b6_error_1 = f_b6 - f_a5_error
    f_b6_error = f_a5_error - (f_b6 - f_b6_error_1) + (f_a6_error - f_b6_error_1)
    f_b5 = f_a4_error + f_b6
    f_b5_error_1 = f_b5 - f_a4_error
    f_b5_error = f_a4_error - (f_b5 - f_b5_error_1) + (f_b6 - f_b5_error_1)
    f_b4 = f_a3_error + f_b5
    f_b4_error_1 = f_b4 - f_a3_error
    f_b4_error = f_a3_error - (f_b4 - f_b4_error_1) + (f_b5 - f_b4_error_1)
    f_b3 = f_a2_error + f_b4
    f_b3_error_1 = f_b3 - f_a2_error
    f_b3_error = f_a2_error - (f_b3 - f_b3_error_1) + (f_b4 - f_b3_error_1)
    f_b2 = f_a1_error + f_b3
    f_b2_error_1 = f_b2 - f_a1_error
    f_b2_error = f_a1_error - (f_b2 - f_b2_error_1) + (f_b3 - f_b2_error_1)
    f_b1 = f_a0_error + f_b2
    f_b1_error_1 = f_b1 - f_a0_error
    f_b1_error = f_a0_error - (f_b1 - f_b1_error_1) + (f_b2 - f_b1_error_1)
    f_b0 = f_a0 + f_b1
    f_b0_error_1 = f_b0 - f_a0
    f_b0_error = f_a0 - (f_b0 - f_b0_error_1) + (f_b1 - f_b0_error_1)
    f_low_5 = f_b1_error + (f_b2_error + (f_b3_error + (f_b4_error + (f_b5_error + f_b6_error))))
    f_low = f_b0_error + f_low_5
    angle = f_b0 * 1.5707964
    angle_error = product_error(f_b0, 1.5707964, angle)
    angle_low = angle_error + (f_b0 * -4.371139e-08 + f_low * 1.5707964)
    r = angle + angle_low
    r_low = angle_low - (r - angle)
    quadrant = k1 + k2
    return quadrant, r, r_low


def _sincos_error_of(quadrant, r, r_low, s, c):
    q = quadrant + 5.033165e+07 - 5.033165e+07 - quadrant
    cos_k = 1.0 - absolute(q)
    minus_sin_k = q * (1.0 + cos_k)
    sin_r = s * cos_k + c * minus_sin_k
    cos_r = c * cos_k - s * minus_sin_k
    argument = where(absolute(r) < 2.9802322e-08, 0.0, r)
    z = argument * argument
    z_error = product_error(argument, argument, z)
    cube = argument * z
    cube_error = product_error(argument, z, cube)
    cube_low = cube_error + argument * z_error
    sin5 = z * (z * z * 2.8114574e-15 + (z * -7.6471636e-13 + 1.6059044e-10)) + -2.5052108e-08
    sin4_z = z * sin5
    sin4 = 2.7557319e-06 + sin4_z
    sin4_error = sin4_z - (sin4 - 2.7557319e-06)
    sin4_low = 3.7935712e-14 + sin4_error
    sin3_z = z * sin4
    sin3 = -0.0001984127 + sin3_z
    sin3_error = sin3_z - (sin3 - -0.0001984127)
    sin3_low_6 = sin4 * z_error + product_error(z, sin4, sin3_z) + 2.7255969e-12 + sin3_error
    sin3_low = sin3_low_6 + z * sin4_low
    sin2_z = z * sin3
    sin2 = 0.008333334 + sin2_z
    sin2_error = sin2_z - (sin2 - 0.008333334)
    sin2_low_6 = sin3 * z_error + product_error(z, sin3, sin2_z) + -4.346172e-10 + sin2_error
    sin2_low = sin2_low_6 + z * sin3_low
    sin1_z = z * sin2
    sin1 = -0.16666667 + sin1_z
    sin1_error = sin1_z - (sin1 - -0.16666667)
    sin1_low_6 = sin2 * z_error + product_error(z, sin2, sin1_z) + 4.967054e-09 + sin1_error
    sin1_low = sin1_low_6 + z * sin2_low
    more = cube * sin1
    more_error = product_error(cube, sin1, more)
    more_low = more_error + cube_low * sin1
    last = cube * sin1_low
    difference = r - sin_r
    known_sin_r = argument - difference
    sin_r_error = difference + more + (more_low + r_low * cos_r) + last
    h = 1.0 - cos_r
    inverse = 1.0 / cos_r
    square = known_sin_r * known_sin_r
    square_error = product_error(known_sin_r, known_sin_r, square)
    h_square = h * h
    h_square_error = product_error(h, h, h_square)
    excess = h + h - square - h_square - (square_error + h_square_error)
    tangent = known_sin_r * inverse
    cos_r_error = excess * (inverse * 0.5) - tangent * sin_r_error
    s_error = sin_r_error * cos_k - cos_r_error * minus_sin_k
    c_error = cos_r_error * cos_k + sin_r_error * minus_sin_k
    return s_error, c_error


@errstate(all="ignore")
def sincos_error(x, s, c):
    """(s_error, c_error) = (sin x - s, cos x - c), (s, c) as sincos has them.  x = k pi/2 + r, r
    as a pair; Taylor's polynomial of degree 17 in pairs for sin r, whose error gives that of
    cos r, as their squares are 1 together; s + s_error and c + c_error are within 2^-42.2 of
    sin x and cos x, relative to these (proved), for every finite x.  36 mul, 52 add, 8 product
    error, 1 div, 2 abs, 1 less, 1 select.
    """
    quadrant, r, r_low = _sincos_error_near(x)
    beyond = absolute(x) > 1607.0
    if beyond.any():
        far = _sincos_error_far(where(beyond, x, 1607.0))
        quadrant, r, r_low = (
            where(beyond, a, b) for a, b in zip(far, (quadrant, r, r_low)))
    return _sincos_error_of(quadrant, r, r_low, s, c)


def sin_error(x, s):
    """sin x - s, as sincos_error."""
    return sincos_error(x, s, cos(x))[0]


def cos_error(x, c):
    """cos x - c, as sincos_error."""
    return sincos_error(x, sin(x), c)[1]


@errstate(all="ignore")
def tanh_error(x, y):
    """y_error = tanh x - y, y as tanh has it.  m / d = (e^2|x| - 1) / (e^2|x| + 1), m and d as
    pairs; y + y_error is within 2^-42 of tanh x, relative to it (proved); 0 for |x| below 2^-25
    and above 20.  39 mul, 97 add, 9 product error, 1 div, 1 power of two, 3 abs, 1 copysign, 3
    less, 6 select.
    """
    size = absolute(x)
    tiny = size < 2.9802322e-08
    beyond = 20.0 < size
    within = where(beyond, 20.0, where(tiny, 1.0, size))
    result = where(tiny, 1.0, absolute(y))
    twice = within + within
    shifted = twice * 1.442695 + 1.2582912e+07
    k = shifted - 1.2582912e+07
    high = twice - k * 0.69314575
    second = k * -1.4285906e-06
    rest = k * -1.619851e-11
    r = high + second
    r_error_1 = r - high
    r_error = high - (r - r_error_1) + (second - r_error_1)
    r_low = r_error + rest
    power = power_of_two(shifted)
    whole = power + -1.0
    whole_error = -1.0 - (whole - power)
    argument = where(absolute(r) < 2.9802322e-08, 0.0, r)
    term8_6 = argument * argument * (argument * 1.6059044e-10 + 2.0876756e-09)
    term8 = argument * (term8_6 + (argument * 2.5052108e-08 + 2.755732e-07)) + 2.7557319e-06
    term7_z = argument * term8
    term7 = 2.4801588e-05 + term7_z
    term7_error = term7_z - (term7 - 2.4801588e-05)
    term7_low = -3.406996e-13 + term7_error
    term6_z = argument * term7
    term6 = 0.0001984127 + term6_z
    term6_error = term6_z - (term6 - 0.0001984127)
    term6_low_5 = term7 * r_low + product_error(argument, term7, term6_z) + -2.7255969e-12
    term6_low = term6_low_5 + term6_error + argument * term7_low
    term5_z = argument * term6
    term5 = 0.0013888889 + term5_z
    term5_error = term5_z - (term5 - 0.0013888889)
    term5_low_5 = term6 * r_low + product_error(argument, term6, term5_z) + -3.3631094e-11
    term5_low = term5_low_5 + term5_error + argument * term6_low
    term4_z = argument * term5
    term4 = 0.008333334 + term4_z
    term4_error = term4_z - (term4 - 0.008333334)
    term4_low_5 = term5 * r_low + product_error(argument, term5, term4_z) + -4.346172e-10
    term4_low = term4_low_5 + term4_error + argument * term5_low
    term3_z = argument * term4
    term3 = 0.041666668 + term3_z
    term3_error = term3_z - (term3 - 0.041666668)
    term3_low_5 = term4 * r_low + product_error(argument, term4, term3_z) + -1.2417635e-09
    term3_low = term3_low_5 + term3_error + argument * term4_low
    term2_z = argument * term3
    term2 = 0.16666667 + term2_z
    term2_error = term2_z - (term2 - 0.16666667)
    term2_low_5 = term3 * r_low + product_error(argument, term3, term2_z) + -4.967054e-09
    term2_low = term2_low_5 + term2_error + argument * term3_low
    term1_z = argument * term2
    term1 = 0.5 + term1_z
    term1_error = term1_z - (term1 - 0.5)
    term1_low_5 = term2 * r_low + product_error(argument, term2, term1_z) + term1_error
    term1_low = term1_low_5 + argument * term2_low
    term_sum = argument * term1
    term_sum_error = product_error(argument, term1, term_sum)
    term_sum_low = term_sum_error + (argument * term1_low + r_low * term1)
    grown_more = r * term_sum
    grown_more_error = product_error(r, term_sum, grown_more)
    grown_more_low = grown_more_error + (r * term_sum_low + r_low * term_sum)
    grown = r + grown_more
    grown_error = grown_more - (grown - r)
    grown_low = grown_error + (grown_more_low + r_low)
    more = grown * power
    more_low = grown_low * power
    m_sum = whole + more
    m_sum_error_1 = m_sum - whole
    m_sum_error = whole - (m_sum - m_sum_error_1) + (more - m_sum_error_1)
    m_sum_low = m_sum_error + (more_low + whole_error)
    m = m_sum + m_sum_low
    m_low = m_sum_low - (m - m_sum)
    d_sum = 2.0 + m
    d_sum_error_1 = d_sum - 2.0
    d_sum_error = 2.0 - (d_sum - d_sum_error_1) + (m - d_sum_error_1)
    d_sum_low = d_sum_error + m_low
    d = d_sum + d_sum_low
    d_low = d_sum_low - (d - d_sum)
    product = result * d
    product_rest = product_error(result, d, product)
    error = (m - product - product_rest + (m_low - result * d_low)) / d
    known = where(tiny, 0.0, where(beyond, 0.0, error))
    y_error = known * copysign(1.0, x)
    return y_error
