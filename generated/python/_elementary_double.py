# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions of components in double precision: the same bits as in C."""

from numpy import (absolute, array, asarray, copysign, errstate, float64, int64, uint64, where)


def power_of_two(shifted):
    """2^k by its bits, from 1.5 · 2^52 + k."""
    bits = asarray(shifted, float64).view(uint64)
    one = uint64(1023) << 52
    return ((bits << 52) + one).view(float64)[()]


@errstate(all="ignore")
def atan2(y, x):
    """angle = atan2(y, x).  arctan(a/b), and pi/4 + arctan((a - b)/(a + b)) above 1/2, a <= b
    being |x| and |y|; arctan q = q + q^3 p(q^2), p of degree 11, to 2^-57.7; the quotient to
    more than its digits; with all roundings within 0.934 ulp (both proved), results below the
    normal range within 0.51 of the least subnormal number.  29 mul, 35 add, 1 div, 1 neg, 2
    abs, 2 copysign, 6 less, 1 equal, 14 select.
    """
    height = absolute(y)
    width = absolute(x)
    steep = width < height
    a = where(steep, width, height)
    a_1 = where(steep, height, width)
    infinite = 1.7976931348623157e+308 < a_1
    scale_3 = where(1.0463951242053392e+298 < a_1, float64(9.094947017729282e-13), float64(1.0))
    scale_4 = where(a_1 < 1.152921504606847e+18, 9.076030935533344e+279, scale_3)
    scale = where(infinite, 0.0, scale_4)
    scaled_a = where(1.7976931348623157e+308 < a, 1.0, a * scale)
    scaled_b_2 = where(infinite, 1.0, a_1 * scale)
    scaled_b = where(scaled_b_2 == 0.0, 1.0, scaled_b_2)
    above = scaled_b < scaled_a + scaled_a
    side = copysign(1.0, x)
    sign = where(steep, -side, side)
    quarters = where(steep, 2.0, 2.0 - (side + side)) + where(above, sign, 0.0)
    base = quarters * 0.7853981633974483
    total = scaled_a + scaled_b
    n = sign * where(above, scaled_a - scaled_b, scaled_a)
    rest_of_d = where(above, scaled_b - total + scaled_a, 0.0)
    d = where(above, total, scaled_b)
    inverse = 1.0 / d
    q_high_1 = n * inverse
    q_high_2 = q_high_1 * 134217729.0
    q_high = q_high_2 - (q_high_2 - q_high_1)
    d_high_1 = d * 134217729.0
    d_high = d_high_1 - (d_high_1 - d)
    d_low = d - d_high
    but_high = n - q_high * d_high
    but_low = but_high - q_high * d_low
    c = (but_low - q_high * rest_of_d) * inverse
    q = q_high + c
    z = q * q
    tail_12 = z * z
    tail_13 = tail_12 * (z * -0.09090896243462607 + 0.11111110659599031)
    tail_15 = tail_12 * (z * -0.05121994511422147 + 0.058582966172403564)
    tail_19 = tail_12 * tail_12
    tail_20 = tail_19 * (tail_15 + (z * -0.06663810317366585 + 0.07692073887659807))
    tail_18 = tail_12 * 0.010116413558090894 + (z * -0.0274343623051046 + 0.04186470045016432)
    tail_21 = tail_20 + (tail_13 + (z * -0.1428571427638533 + 0.19999999999903106))
    tail_28 = q * z * (z * (tail_19 * tail_19 * tail_18 + tail_21) + -0.3333333333333298) + c
    tail = tail_28 + quarters * 3.061616997868383e-17
    sum = base + q_high
    positive = sum + (base - sum + q_high + tail)
    angle = copysign(positive, y)
    return angle


@errstate(all="ignore")
def exp(x):
    """y = exp x.  x = k ln 2 + r, |r| <= ln 2 / 2, ln 2 as a sum of two numbers; e^r = 1 + r + r^2
    q(r), q of degree 9, to 2^-57.3; with all roundings within 0.755 ulp (both proved), results
    below the normal range within 0.88 of the least subnormal number.  19 mul, 20 add, 1 power
    of two, 3 less, 4 select.
    """
    within_2 = where(710.0 < x, 710.0, x)
    within = where(within_2 < -746.0, -746.0, within_2)
    shifted = within * 1.4426950408889634 + 6755399441055744.0
    k = shifted - 6755399441055744.0
    high = within - k * 0.6931471805598903
    rest = k * 5.497923018708371e-14
    r = high - rest
    low_10 = r * r
    low_11 = low_10 * (r * 0.0013888888926860458 + 0.008333333333500498)
    low_13 = low_10 * (r * 2.762522584904681e-07 + 2.7557641500508844e-06)
    low_15 = low_10 * low_10
    low_16 = low_15 * (low_13 + (r * 2.4801508592805324e-05 + 0.00019841269465342197))
    low_17 = low_16 + (low_11 + (r * 0.04166666666660382 + 0.16666666666666433))
    low = r * r * (r * (low_15 * low_15 * 2.4978234152604323e-08 + low_17) + 0.5) - rest
    small = within < -700.0
    start = high + 1.0
    e_r = start + (1.0 - start + high + low)
    scaled = e_r * power_of_two(shifted + where(small, float64(64.0), float64(-1.0)))
    y = scaled * where(small, float64(5.421010862427522e-20), float64(2.0))
    return y


_TWO_OVER_PI = array((
    0.0, 1.552518092300709e+231, -5.641543713876639e+230, -6.396016207391955e+222,
    1.1126113092409047e+215, -8.436669302237339e+206, 1.5807217683269026e+199,
    4.880580955706536e+191, -7.185865841686167e+183, 1.63221799194198e+175, 1.4693593606398383e+168,
    -3.715978157723569e+159, 3.7407297269622413e+152, -5.4349642156801825e+144,
    -2.3240991502638365e+136, -7.402069681053744e+128, 4.056081919863044e+120,
    -2.8984041972202763e+113, -2.825206553789984e+105, -2.3319926745997907e+96,
    7.585087249414347e+89, -5.55745127382766e+81, -1.7591066618906454e+74, -1.2244638908582199e+66,
    7.688706724690006e+57, -6.642335162327314e+50, 5.0486372198203834e+42, 2.2707088482197588e+34,
    -6.272424989160333e+26, -1.614298573854212e+19, -570064896.0, 6159.934326171875,
    -1.4213062968337908e-05, -1.7819479073734323e-12, 2.312672511709599e-20, 1.9128857412445226e-28,
    -4.7275159220664295e-36, -7.857766278129624e-44, 1.0013967854884192e-51, -6.748739759997069e-60,
    2.9382392389751967e-67, 3.275166641861633e-75, 2.9838823028238618e-83, 5.698810044393321e-91,
    -7.348167503787565e-99, 1.224385720857395e-106, 2.1156250393735652e-115, -2.378423370797896e-122
), float64)


def two_over_pi(x, n):
    """2/π is the sum of chunks of 26 bits.  Returns 2^768 times the one that is n after the
    first that matters to x modulo 2 π, |x| >= 4 or not finite; for 0 <= n <= 8."""
    biased = (asarray(x, float64).view(uint64) >> 52) & 0x7ff
    return _TWO_OVER_PI[(biased.astype(int64) - 1025) // 26 + int(n)]


def _sincos_near(x):
    """Its reduction of angles up to 6588396.0."""
    quadrant = x * 0.6366197723675814 + 6755399441055744.0 - 6755399441055744.0
    high = x - quadrant * 1.5707963267341256 - quadrant * 6.077094383272197e-11
    low = quadrant * 6.12323399409214e-17
    r = high - low
    r_excess = r - high + low + quadrant * 1.6446256936324258e-26
    return quadrant, r, r_excess


def _sincos_far(x):
    """Its reduction of larger angles."""
    scaled = x * 6.441148769597133e-232
    x_high_1 = scaled * 134217729.0
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
    t0 = x_low * chunk0 + x_high * chunk1
    t1 = x_low * chunk1 + x_high * chunk2
    t2 = x_low * chunk2 + x_high * chunk3
    t3 = x_low * chunk3 + x_high * chunk4
    t4 = x_low * chunk4 + x_high * chunk5
    t5 = x_low * chunk5 + x_high * chunk6
    t6 = x_low * chunk6 + x_high * chunk7
    rest0 = t0 - (t0 + 5.404319552844595e+16 - 5.404319552844595e+16)
    rest4 = rest0 - (rest0 + 2.7021597764222976e+16 - 2.7021597764222976e+16)
    k1 = t1 + 6755399441055744.0 - 6755399441055744.0
    sum2_2 = rest4 + (t1 - k1)
    sum2 = sum2_2 + t2
    sum2_error_1 = sum2 - sum2_2
    sum2_error = sum2_2 - (sum2 - sum2_error_1) + (t2 - sum2_error_1)
    k2 = sum2 + 6755399441055744.0 - 6755399441055744.0
    sum2_rest = sum2 - k2
    sum3 = sum2_rest + t3
    sum3_error_1 = sum3 - sum2_rest
    sum3_error = sum2_rest - (sum3 - sum3_error_1) + (t3 - sum3_error_1)
    low3 = sum2_error + sum3_error
    tail = t6 + t5
    low4 = low3 + t4
    low4_error_1 = low4 - low3
    low4_error = low3 - (low4 - low4_error_1) + (t4 - low4_error_1)
    tail4 = tail + low4_error
    f = sum3 + low4
    f_error_1 = f - sum3
    f_error = sum3 - (f - f_error_1) + (low4 - f_error_1)
    f_low = f_error + tail4
    f_part_high_1 = f * 134217729.0
    f_part_high = f_part_high_1 - (f_part_high_1 - f)
    f_part_low = f - f_part_high
    product = f * 1.5707963267948966
    product_excess_2 = product - f_part_high * 1.5707963407039642
    product_excess_4 = product_excess_2 - f_part_high * -1.3909067675399456e-08
    product_excess_6 = product_excess_4 - f_part_low * 1.5707963407039642
    product_excess = product_excess_6 - f_part_low * -1.3909067675399456e-08
    rest = product_excess - (f * 6.123233995736766e-17 + f_low * 1.5707963267948966)
    r = product - rest
    r_excess = r - product + rest
    quadrant = k1 + k2
    return quadrant, r, r_excess


def _sincos_of(quadrant, r, r_excess):
    z = r * r
    z2 = z * z
    half_z = z * 0.5
    w = 1.0 - half_z
    sin_r_7 = z2 * (2.5050734370397888e-08 + z * -1.5895431762410801e-10)
    sin_r_9 = z2 * (0.00019841269829358447 + z * -2.7557313538442266e-06 + sin_r_7)
    sin_r = r - (z * r * (0.1666666666666663 + (z * -0.00833333333332184 + sin_r_9)) + r_excess * w)
    cos_r_8 = z2 * (2.087567807349307e-09 + z * -1.1357335951124145e-11)
    cos_r_10 = z2 * (2.48015872882953e-05 + z * -2.7557314015067576e-07 + cos_r_8)
    cos_r_15 = z2 * (0.04166666666666659 + (z * -0.0013888888888872186 + cos_r_10)) + r * r_excess
    cos_r = w + (1.0 - w - half_z + cos_r_15)
    q = quadrant + 2.7021597764222976e+16 - 2.7021597764222976e+16 - quadrant
    cos_k = 1.0 - absolute(q)
    minus_sin_k = q * (1.0 + cos_k)
    s = sin_r * cos_k - cos_r * minus_sin_k
    c = cos_r * cos_k + sin_r * minus_sin_k
    return s, c


@errstate(all="ignore")
def sincos(x):
    """(s, c) = (sin x, cos x).  x = k pi/2 + r - r_excess, |r| <= pi/4 and little more; pi/2 in
    parts to 2^-30, 2^-53, 2^-84 and a rest, beyond the limit by the digits of 2/pi; polynomials
    of degrees 13 and 14 in r, to 2^-57.8; with all roundings within 0.824 ulp (both proved),
    for every finite x.  23 mul, 25 add, 1 abs.
    """
    quadrant, r, r_excess = _sincos_near(x)
    beyond = absolute(x) > 6588396.0
    if beyond.any():
        far = _sincos_far(where(beyond, x, 6588396.0))
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
    """y = tanh x.  |x| < 5/8: x + x^3 p/q, of degrees 2 and 3 in x^2, to 2^-59.3; beyond: 1 - 2 /
    (e^2|x| + 1), e^2|x| as exp has it; with all roundings within 0.979 ulp (both proved).  29
    mul, 30 add, 1 div, 1 power of two, 1 abs, 1 copysign, 2 less, 5 select.
    """
    size = absolute(x)
    small = size < 0.625
    z = size * size
    above_5 = (z * -0.00019908890916339926 + -0.020496786093244908) * z + -0.33333333333333326
    above = size * z * above_5
    below = ((z * 0.00020643828172711687 + 0.023288648134874086) * z + 0.4614903582797203) * z + 1.0
    twice_1 = size + size
    twice = where(40.0 < twice_1, 40.0, twice_1)
    shifted = twice * 1.4426950408889634 + 6755399441055744.0
    k = shifted - 6755399441055744.0
    high = twice - k * 0.6931471805598903
    rest = k * 5.497923018708371e-14
    r = high - rest
    low_10 = r * r
    low_11 = low_10 * (r * 0.0013888888926860458 + 0.008333333333500498)
    low_13 = low_10 * (r * 2.762522584904681e-07 + 2.7557641500508844e-06)
    low_15 = low_10 * low_10
    low_16 = low_15 * (low_13 + (r * 2.4801508592805324e-05 + 0.00019841269465342197))
    low_17 = low_16 + (low_11 + (r * 0.04166666666660382 + 0.16666666666666433))
    low = r * r * (r * (low_15 * low_15 * 2.4978234152604323e-08 + low_17) + 0.5) - rest
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
