# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Elementary functions of components in double precision: the same bits as in C."""

from numpy import (absolute, array, asarray, copysign, errstate, float64, int64, uint64, where)

from ._exact import product_error


def power_of_two(shifted):
    """2^k by its bits, from 1.5 · 2^52 + k."""
    bits = asarray(shifted, float64).view(uint64)
    one = uint64(1023) << 52
    return ((bits << 52) + one).view(float64)[()]

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
    -7.348167503787565e-99, 1.224385720857395e-106, 2.1156250393735652e-115,
    -2.378423370797896e-122, -4.1290598927684836e-130
), float64)


def two_over_pi(x, n):
    """2/π is the sum of chunks of 26 bits.  Returns 2^768 times the one that is n after the
    first that matters to x modulo 2 π, |x| >= 4 or not finite; for 0 <= n <= 9."""
    biased = (asarray(x, float64).view(uint64) >> 52) & 0x7ff
    return _TWO_OVER_PI[(biased.astype(int64) - 1025) // 26 + int(n)]


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


@errstate(all="ignore")
def atan2_error(y, x, angle):
    """angle_error = atan2(y, x) - angle, angle as atan2 has it.  (y c - x s) / (x c + y s), s and
    c the angle's sine and cosine as pairs; angle + angle_error is within 2^-100 of atan2(y, x),
    relative to it (proved), and 0.51 of the least subnormal number; 0 where the angle is 0.  93
    mul, 177 add, 21 product error, 1 div, 6 abs, 2 copysign, 7 less, 2 equal, 9 select.
    """
    quadrant = angle * 0.6366197723675814 + 6755399441055744.0 - 6755399441055744.0
    high = angle - quadrant * 1.5707963267341256 - quadrant * 6.077094383272197e-11
    a_1 = quadrant * -6.12323399409214e-17
    a = high + a_1
    a_error_1 = a - high
    a_error = high - (a - a_error_1) + (a_1 - a_error_1)
    fourth = a_error - quadrant * 1.6446256917039331e-26
    b = a + fourth
    b_error = fourth - (b - a)
    fifth = b_error - quadrant * 1.9284926340862225e-35
    r = b + fifth
    r_error = fifth - (r - b)
    r_low = r_error - quadrant * 4.916232119866224e-45
    argument = where(absolute(r) < 5.551115123125783e-17, 0.0, r)
    z = argument * argument
    z_error = product_error(argument, argument, z)
    z_low = z_error + (argument * r_low + r_low * argument)
    sin9_6 = z * z * (z * -9.183689863795546e-29 + 6.446950284384474e-26)
    sin9_8 = z * (sin9_6 + (z * -3.868170170630684e-23 + 1.9572941063391263e-20))
    sin9 = sin9_8 + -8.22063524662433e-18
    sin8_z = z * sin9
    sin8 = 2.8114572543455206e-15 + sin8_z
    sin8_error = sin8_z - (sin8 - 2.8114572543455206e-15)
    sin8_low = 1.6508842730861433e-31 + sin8_error
    sin7_z = z * sin8
    sin7 = -7.647163731819816e-13 + sin7_z
    sin7_error = sin7_z - (sin7 - -7.647163731819816e-13)
    sin7_low_6 = sin8 * z_low + product_error(z, sin8, sin7_z) + -7.03872877733453e-30 + sin7_error
    sin7_low = sin7_low_6 + z * sin8_low
    sin6_z = z * sin7
    sin6 = 1.6059043836821613e-10 + sin6_z
    sin6_error = sin6_z - (sin6 - 1.6059043836821613e-10)
    sin6_low_6 = sin7 * z_low + product_error(z, sin7, sin6_z) + 1.2585294588752098e-26 + sin6_error
    sin6_low = sin6_low_6 + z * sin7_low
    sin5_z = z * sin6
    sin5 = -2.505210838544172e-08 + sin5_z
    sin5_error = sin5_z - (sin5 - -2.505210838544172e-08)
    sin5_low_6 = sin6 * z_low + product_error(z, sin6, sin5_z) + 1.448814070935912e-24 + sin5_error
    sin5_low = sin5_low_6 + z * sin6_low
    sin4_z = z * sin5
    sin4 = 2.7557319223985893e-06 + sin4_z
    sin4_error = sin4_z - (sin4 - 2.7557319223985893e-06)
    sin4_low_6 = sin5 * z_low + product_error(z, sin5, sin4_z) + -1.858393274046472e-22 + sin4_error
    sin4_low = sin4_low_6 + z * sin5_low
    sin3_z = z * sin4
    sin3 = -0.0001984126984126984 + sin3_z
    sin3_error = sin3_z - (sin3 - -0.0001984126984126984)
    sin3_low_5 = sin4 * z_low + product_error(z, sin4, sin3_z) + -1.7209558293420705e-22
    sin3_low = sin3_low_5 + sin3_error + z * sin4_low
    sin2_z = z * sin3
    sin2 = 0.008333333333333333 + sin2_z
    sin2_error = sin2_z - (sin2 - 0.008333333333333333)
    sin2_low_6 = sin3 * z_low + product_error(z, sin3, sin2_z) + 1.1564823173178714e-19 + sin2_error
    sin2_low = sin2_low_6 + z * sin3_low
    sin1_z = z * sin2
    sin1 = -0.16666666666666666 + sin1_z
    sin1_error = sin1_z - (sin1 - -0.16666666666666666)
    sin1_low_6 = sin2 * z_low + product_error(z, sin2, sin1_z) + -9.25185853854297e-18 + sin1_error
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
    cos10_6 = z * z * (z * 3.279889237069838e-30 + -2.4795962632247976e-27)
    cos10_8 = z * (cos10_6 + (z * 1.6117375710961184e-24 + -8.896791392450574e-22))
    cos10 = cos10_8 + 4.110317623312165e-19
    cos9_z = z * cos10
    cos9 = -1.5619206968586225e-16 + cos9_z
    cos9_error = cos9_z - (cos9 - -1.5619206968586225e-16)
    cos9_low = -1.1910679660273754e-32 + cos9_error
    cos8_z = z * cos9
    cos8 = 4.779477332387385e-14 + cos8_z
    cos8_error = cos8_z - (cos8 - 4.779477332387385e-14)
    cos8_low_6 = cos9 * z_low + product_error(z, cos9, cos8_z) + 4.399205485834081e-31 + cos8_error
    cos8_low = cos8_low_6 + z * cos9_low
    cos7_z = z * cos8
    cos7 = -1.1470745597729725e-11 + cos7_z
    cos7_error = cos7_z - (cos7 - -1.1470745597729725e-11)
    cos7_low_5 = cos8 * z_low + product_error(z, cos8, cos7_z) + -2.0655512752830745e-28
    cos7_low = cos7_low_5 + cos7_error + z * cos8_low
    cos6_z = z * cos7
    cos6 = 2.08767569878681e-09 + cos6_z
    cos6_error = cos6_z - (cos6 - 2.08767569878681e-09)
    cos6_low_6 = cos7 * z_low + product_error(z, cos7, cos6_z) + -1.20734505911326e-25 + cos6_error
    cos6_low = cos6_low_6 + z * cos7_low
    cos5_z = z * cos6
    cos5 = -2.755731922398589e-07 + cos5_z
    cos5_error = cos5_z - (cos5 - -2.755731922398589e-07)
    cos5_low_5 = cos6 * z_low + product_error(z, cos6, cos5_z) + -2.3767714622250297e-23
    cos5_low = cos5_low_5 + cos5_error + z * cos6_low
    cos4_z = z * cos5
    cos4 = 2.48015873015873e-05 + cos4_z
    cos4_error = cos4_z - (cos4 - 2.48015873015873e-05)
    cos4_low_6 = cos5 * z_low + product_error(z, cos5, cos4_z) + 2.1511947866775882e-23 + cos4_error
    cos4_low = cos4_low_6 + z * cos5_low
    cos3_z = z * cos4
    cos3 = -0.001388888888888889 + cos3_z
    cos3_error = cos3_z - (cos3 - -0.001388888888888889)
    cos3_low_6 = cos4 * z_low + product_error(z, cos4, cos3_z) + 5.300543954373577e-20 + cos3_error
    cos3_low = cos3_low_6 + z * cos4_low
    cos2_z = z * cos3
    cos2 = 0.041666666666666664 + cos2_z
    cos2_error = cos2_z - (cos2 - 0.041666666666666664)
    cos2_low_6 = cos3 * z_low + product_error(z, cos3, cos2_z) + 2.3129646346357427e-18 + cos2_error
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
    q = quadrant + 2.7021597764222976e+16 - 2.7021597764222976e+16 - quadrant
    cos_k = 1.0 - absolute(q)
    minus_sin_k = q * (1.0 + cos_k)
    sin_x = sine * cos_k - cosine * minus_sin_k
    sin_x_low = sine_low * cos_k - cosine_low * minus_sin_k
    cos_x = cosine * cos_k + sine * minus_sin_k
    cos_x_low = cosine_low * cos_k + sine_low * minus_sin_k
    size_1 = absolute(y)
    size_2 = absolute(x)
    size = where(size_1 < size_2, size_2, size_1)
    scale_3 = where(1.0463951242053392e+298 < size, float64(9.094947017729282e-13), float64(1.0))
    scale_4 = where(size < 1.152921504606847e+18, 9.076030935533344e+279, scale_3)
    scale = where(1.7976931348623157e+308 < size, 0.0, scale_4)
    scaled_y_2 = copysign(1.0, x)
    scaled_y = where(1.7976931348623157e+308 < absolute(y), copysign(1.0, y), y * scale)
    scaled_x_4 = where(1.7976931348623157e+308 < absolute(x), scaled_y_2, x * scale)
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
    degree 23 in pairs; y + y_error is within 2^-101.8 of exp x, relative to it (proved), and
    0.51 of the least subnormal number; 0 where y is 0 or infinite.  62 mul, 127 add, 14 product
    error, 4 power of two, 1 abs, 4 less, 1 equal, 5 select.
    """
    within_2 = where(710.0 < x, 710.0, x)
    within = where(within_2 < -746.0, -746.0, within_2)
    shifted = within * 1.4426950408889634 + 6755399441055744.0
    k = shifted - 6755399441055744.0
    high = within - k * 0.6931471805598903
    second = k * -5.49792301870721e-14
    rest = k * -1.1612227229362532e-26
    r = high + second
    r_error_1 = r - high
    r_error = high - (r - r_error_1) + (second - r_error_1)
    r_low = r_error + rest
    argument = where(absolute(r) < 5.551115123125783e-17, 0.0, r)
    term14_9 = argument * argument
    term14_10 = term14_9 * (argument * 8.22063524662433e-18 + 1.5619206968586225e-16)
    term14_12 = term14_9 * (argument * 3.868170170630684e-23 + 8.896791392450574e-22)
    term14_13 = term14_12 + (argument * 1.9572941063391263e-20 + 4.110317623312165e-19)
    term14_11 = term14_10 + (argument * 2.8114572543455206e-15 + 4.779477332387385e-14)
    term14 = argument * (term14_9 * term14_9 * term14_13 + term14_11) + 7.647163731819816e-13
    term13_z = argument * term14
    term13 = 1.1470745597729725e-11 + term13_z
    term13_error = term13_z - (term13 - 1.1470745597729725e-11)
    term13_low = 2.0655512752830745e-28 + term13_error
    term12_z = argument * term13
    term12 = 1.6059043836821613e-10 + term12_z
    term12_error = term12_z - (term12 - 1.6059043836821613e-10)
    term12_low_4 = term13 * r_low + product_error(argument, term13, term12_z)
    term12_low = term12_low_4 + 1.2585294588752098e-26 + term12_error + argument * term13_low
    term11_z = argument * term12
    term11 = 2.08767569878681e-09 + term11_z
    term11_error = term11_z - (term11 - 2.08767569878681e-09)
    term11_low_4 = term12 * r_low + product_error(argument, term12, term11_z)
    term11_low = term11_low_4 + -1.20734505911326e-25 + term11_error + argument * term12_low
    term10_z = argument * term11
    term10 = 2.505210838544172e-08 + term10_z
    term10_error = term10_z - (term10 - 2.505210838544172e-08)
    term10_low_4 = term11 * r_low + product_error(argument, term11, term10_z)
    term10_low = term10_low_4 + -1.448814070935912e-24 + term10_error + argument * term11_low
    term9_z = argument * term10
    term9 = 2.755731922398589e-07 + term9_z
    term9_error = term9_z - (term9 - 2.755731922398589e-07)
    term9_low_5 = term10 * r_low + product_error(argument, term10, term9_z) + 2.3767714622250297e-23
    term9_low = term9_low_5 + term9_error + argument * term10_low
    term8_z = argument * term9
    term8 = 2.7557319223985893e-06 + term8_z
    term8_error = term8_z - (term8 - 2.7557319223985893e-06)
    term8_low_5 = term9 * r_low + product_error(argument, term9, term8_z) + -1.858393274046472e-22
    term8_low = term8_low_5 + term8_error + argument * term9_low
    term7_z = argument * term8
    term7 = 2.48015873015873e-05 + term7_z
    term7_error = term7_z - (term7 - 2.48015873015873e-05)
    term7_low_5 = term8 * r_low + product_error(argument, term8, term7_z) + 2.1511947866775882e-23
    term7_low = term7_low_5 + term7_error + argument * term8_low
    term6_z = argument * term7
    term6 = 0.0001984126984126984 + term6_z
    term6_error = term6_z - (term6 - 0.0001984126984126984)
    term6_low_5 = term7 * r_low + product_error(argument, term7, term6_z) + 1.7209558293420705e-22
    term6_low = term6_low_5 + term6_error + argument * term7_low
    term5_z = argument * term6
    term5 = 0.001388888888888889 + term5_z
    term5_error = term5_z - (term5 - 0.001388888888888889)
    term5_low_5 = term6 * r_low + product_error(argument, term6, term5_z) + -5.300543954373577e-20
    term5_low = term5_low_5 + term5_error + argument * term6_low
    term4_z = argument * term5
    term4 = 0.008333333333333333 + term4_z
    term4_error = term4_z - (term4 - 0.008333333333333333)
    term4_low_5 = term5 * r_low + product_error(argument, term5, term4_z) + 1.1564823173178714e-19
    term4_low = term4_low_5 + term4_error + argument * term5_low
    term3_z = argument * term4
    term3 = 0.041666666666666664 + term3_z
    term3_error = term3_z - (term3 - 0.041666666666666664)
    term3_low_5 = term4 * r_low + product_error(argument, term4, term3_z) + 2.3129646346357427e-18
    term3_low = term3_low_5 + term3_error + argument * term4_low
    term2_z = argument * term3
    term2 = 0.16666666666666666 + term2_z
    term2_error = term2_z - (term2 - 0.16666666666666666)
    term2_low_5 = term3 * r_low + product_error(argument, term3, term2_z) + 9.25185853854297e-18
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
    first_shifted = k * 0.5 + 6755399441055744.0
    k_first = first_shifted - 6755399441055744.0
    k_second = k - k_first
    down0 = power_of_two(6755399441055744.0 - k_first)
    down1 = power_of_two(6755399441055744.0 - k_second)
    up0 = power_of_two(6755399441055744.0 + k_first)
    up1 = power_of_two(6755399441055744.0 + k_second)
    y_scaled = y * down0 * down1
    error = e_r - y_scaled + e_r_low
    scaled = error * up0 * up1
    y_error = where(y == 0.0, 0.0, where(1.7976931348623157e+308 < y, 0.0, scaled))
    return y_error


def _sincos_error_near(x):
    """Its reduction of angles up to 6588396.0."""
    quadrant = x * 0.6366197723675814 + 6755399441055744.0 - 6755399441055744.0
    high = x - quadrant * 1.5707963267341256 - quadrant * 6.077094383272197e-11
    a_1 = quadrant * -6.12323399409214e-17
    a = high + a_1
    a_error_1 = a - high
    a_error = high - (a - a_error_1) + (a_1 - a_error_1)
    fourth = a_error - quadrant * 1.6446256917039331e-26
    b = a + fourth
    b_error = fourth - (b - a)
    fifth = b_error - quadrant * 1.9284926340862225e-35
    r = b + fifth
    r_error = fifth - (r - b)
    r_low = r_error - quadrant * 4.916232119866224e-45
    return quadrant, r, r_low


def _sincos_error_far(x):
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
    rest0 = t0 - (t0 + 5.404319552844595e+16 - 5.404319552844595e+16)
    rest4 = rest0 - (rest0 + 2.7021597764222976e+16 - 2.7021597764222976e+16)
    k1 = t1 + 6755399441055744.0 - 6755399441055744.0
    sum2_2 = rest4 + (t1 - k1)
    sum2 = sum2_2 + t2
    sum2_error_1 = sum2 - sum2_2
    sum2_error = sum2_2 - (sum2 - sum2_error_1) + (t2 - sum2_error_1)
    k2 = sum2 + 6755399441055744.0 - 6755399441055744.0
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
    angle = f_b0 * 1.5707963267948966
    angle_error = product_error(f_b0, 1.5707963267948966, angle)
    angle_low = angle_error + (f_b0 * 6.123233995736766e-17 + f_low * 1.5707963267948966)
    r = angle + angle_low
    r_low = angle_low - (r - angle)
    quadrant = k1 + k2
    return quadrant, r, r_low


def _sincos_error_of(quadrant, r, r_low, s, c):
    q = quadrant + 2.7021597764222976e+16 - 2.7021597764222976e+16 - quadrant
    cos_k = 1.0 - absolute(q)
    minus_sin_k = q * (1.0 + cos_k)
    sin_r = s * cos_k + c * minus_sin_k
    cos_r = c * cos_k - s * minus_sin_k
    argument = where(absolute(r) < 5.551115123125783e-17, 0.0, r)
    z = argument * argument
    z_error = product_error(argument, argument, z)
    cube = argument * z
    cube_error = product_error(argument, z, cube)
    cube_low = cube_error + argument * z_error
    sin8_5 = z * z
    sin8_6 = sin8_5 * (z * 6.446950284384474e-26 + -3.868170170630684e-23)
    sin8_7 = sin8_6 + (z * 1.9572941063391263e-20 + -8.22063524662433e-18)
    sin8 = z * (sin8_5 * sin8_5 * -9.183689863795546e-29 + sin8_7) + 2.8114572543455206e-15
    sin7_z = z * sin8
    sin7 = -7.647163731819816e-13 + sin7_z
    sin7_error = sin7_z - (sin7 - -7.647163731819816e-13)
    sin7_low = -7.03872877733453e-30 + sin7_error
    sin6_z = z * sin7
    sin6 = 1.6059043836821613e-10 + sin6_z
    sin6_error = sin6_z - (sin6 - 1.6059043836821613e-10)
    sin6_low_5 = sin7 * z_error + product_error(z, sin7, sin6_z) + 1.2585294588752098e-26
    sin6_low = sin6_low_5 + sin6_error + z * sin7_low
    sin5_z = z * sin6
    sin5 = -2.505210838544172e-08 + sin5_z
    sin5_error = sin5_z - (sin5 - -2.505210838544172e-08)
    sin5_low_5 = sin6 * z_error + product_error(z, sin6, sin5_z) + 1.448814070935912e-24
    sin5_low = sin5_low_5 + sin5_error + z * sin6_low
    sin4_z = z * sin5
    sin4 = 2.7557319223985893e-06 + sin4_z
    sin4_error = sin4_z - (sin4 - 2.7557319223985893e-06)
    sin4_low_5 = sin5 * z_error + product_error(z, sin5, sin4_z) + -1.858393274046472e-22
    sin4_low = sin4_low_5 + sin4_error + z * sin5_low
    sin3_z = z * sin4
    sin3 = -0.0001984126984126984 + sin3_z
    sin3_error = sin3_z - (sin3 - -0.0001984126984126984)
    sin3_low_5 = sin4 * z_error + product_error(z, sin4, sin3_z) + -1.7209558293420705e-22
    sin3_low = sin3_low_5 + sin3_error + z * sin4_low
    sin2_z = z * sin3
    sin2 = 0.008333333333333333 + sin2_z
    sin2_error = sin2_z - (sin2 - 0.008333333333333333)
    sin2_low_5 = sin3 * z_error + product_error(z, sin3, sin2_z) + 1.1564823173178714e-19
    sin2_low = sin2_low_5 + sin2_error + z * sin3_low
    sin1_z = z * sin2
    sin1 = -0.16666666666666666 + sin1_z
    sin1_error = sin1_z - (sin1 - -0.16666666666666666)
    sin1_low_5 = sin2 * z_error + product_error(z, sin2, sin1_z) + -9.25185853854297e-18
    sin1_low = sin1_low_5 + sin1_error + z * sin2_low
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
    as a pair; Taylor's polynomial of degree 27 in pairs for sin r, whose error gives that of
    cos r, as their squares are 1 together; s + s_error and c + c_error are within 2^-100.2 of
    sin x and cos x, relative to these (proved), for every finite x.  48 mul, 75 add, 11 product
    error, 1 div, 2 abs, 1 less, 1 select.
    """
    quadrant, r, r_low = _sincos_error_near(x)
    beyond = absolute(x) > 6588396.0
    if beyond.any():
        far = _sincos_error_far(where(beyond, x, 6588396.0))
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
    pairs; y + y_error is within 2^-100.1 of tanh x, relative to it (proved); 0 for |x| below
    2^-54 and above 40.  62 mul, 143 add, 15 product error, 1 div, 1 power of two, 3 abs, 1
    copysign, 3 less, 6 select.
    """
    size = absolute(x)
    tiny = size < 5.551115123125783e-17
    beyond = 40.0 < size
    within = where(beyond, 40.0, where(tiny, 1.0, size))
    result = where(tiny, 1.0, absolute(y))
    twice = within + within
    shifted = twice * 1.4426950408889634 + 6755399441055744.0
    k = shifted - 6755399441055744.0
    high = twice - k * 0.6931471805598903
    second = k * -5.49792301870721e-14
    rest = k * -1.1612227229362532e-26
    r = high + second
    r_error_1 = r - high
    r_error = high - (r - r_error_1) + (second - r_error_1)
    r_low = r_error + rest
    power = power_of_two(shifted)
    whole = power + -1.0
    whole_error = -1.0 - (whole - power)
    argument = where(absolute(r) < 5.551115123125783e-17, 0.0, r)
    term14_9 = argument * argument
    term14_10 = term14_9 * (argument * 8.22063524662433e-18 + 1.5619206968586225e-16)
    term14_12 = term14_9 * (argument * 3.868170170630684e-23 + 8.896791392450574e-22)
    term14_13 = term14_12 + (argument * 1.9572941063391263e-20 + 4.110317623312165e-19)
    term14_11 = term14_10 + (argument * 2.8114572543455206e-15 + 4.779477332387385e-14)
    term14 = argument * (term14_9 * term14_9 * term14_13 + term14_11) + 7.647163731819816e-13
    term13_z = argument * term14
    term13 = 1.1470745597729725e-11 + term13_z
    term13_error = term13_z - (term13 - 1.1470745597729725e-11)
    term13_low = 2.0655512752830745e-28 + term13_error
    term12_z = argument * term13
    term12 = 1.6059043836821613e-10 + term12_z
    term12_error = term12_z - (term12 - 1.6059043836821613e-10)
    term12_low_4 = term13 * r_low + product_error(argument, term13, term12_z)
    term12_low = term12_low_4 + 1.2585294588752098e-26 + term12_error + argument * term13_low
    term11_z = argument * term12
    term11 = 2.08767569878681e-09 + term11_z
    term11_error = term11_z - (term11 - 2.08767569878681e-09)
    term11_low_4 = term12 * r_low + product_error(argument, term12, term11_z)
    term11_low = term11_low_4 + -1.20734505911326e-25 + term11_error + argument * term12_low
    term10_z = argument * term11
    term10 = 2.505210838544172e-08 + term10_z
    term10_error = term10_z - (term10 - 2.505210838544172e-08)
    term10_low_4 = term11 * r_low + product_error(argument, term11, term10_z)
    term10_low = term10_low_4 + -1.448814070935912e-24 + term10_error + argument * term11_low
    term9_z = argument * term10
    term9 = 2.755731922398589e-07 + term9_z
    term9_error = term9_z - (term9 - 2.755731922398589e-07)
    term9_low_5 = term10 * r_low + product_error(argument, term10, term9_z) + 2.3767714622250297e-23
    term9_low = term9_low_5 + term9_error + argument * term10_low
    term8_z = argument * term9
    term8 = 2.7557319223985893e-06 + term8_z
    term8_error = term8_z - (term8 - 2.7557319223985893e-06)
    term8_low_5 = term9 * r_low + product_error(argument, term9, term8_z) + -1.858393274046472e-22
    term8_low = term8_low_5 + term8_error + argument * term9_low
    term7_z = argument * term8
    term7 = 2.48015873015873e-05 + term7_z
    term7_error = term7_z - (term7 - 2.48015873015873e-05)
    term7_low_5 = term8 * r_low + product_error(argument, term8, term7_z) + 2.1511947866775882e-23
    term7_low = term7_low_5 + term7_error + argument * term8_low
    term6_z = argument * term7
    term6 = 0.0001984126984126984 + term6_z
    term6_error = term6_z - (term6 - 0.0001984126984126984)
    term6_low_5 = term7 * r_low + product_error(argument, term7, term6_z) + 1.7209558293420705e-22
    term6_low = term6_low_5 + term6_error + argument * term7_low
    term5_z = argument * term6
    term5 = 0.001388888888888889 + term5_z
    term5_error = term5_z - (term5 - 0.001388888888888889)
    term5_low_5 = term6 * r_low + product_error(argument, term6, term5_z) + -5.300543954373577e-20
    term5_low = term5_low_5 + term5_error + argument * term6_low
    term4_z = argument * term5
    term4 = 0.008333333333333333 + term4_z
    term4_error = term4_z - (term4 - 0.008333333333333333)
    term4_low_5 = term5 * r_low + product_error(argument, term5, term4_z) + 1.1564823173178714e-19
    term4_low = term4_low_5 + term4_error + argument * term5_low
    term3_z = argument * term4
    term3 = 0.041666666666666664 + term3_z
    term3_error = term3_z - (term3 - 0.041666666666666664)
    term3_low_5 = term4 * r_low + product_error(argument, term4, term3_z) + 2.3129646346357427e-18
    term3_low = term3_low_5 + term3_error + argument * term4_low
    term2_z = argument * term3
    term2 = 0.16666666666666666 + term2_z
    term2_error = term2_z - (term2 - 0.16666666666666666)
    term2_low_5 = term3 * r_low + product_error(argument, term3, term2_z) + 9.25185853854297e-18
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
