# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors.
"""Exact rounding errors, for compensated kernels.

Exact while nothing over- or underflows: products of numbers below 2^996 in magnitude whose own
magnitude is above 2^-969.
"""

_SPLITTER = 134217729.0  # 2^27 + 1


def _halves(a):
    """a = high + low, each of at most 26 bits.  Source: Veltkamp."""
    c = _SPLITTER * a
    high = c - (c - a)
    return high, a - high


def product_error(a, b, p):
    """a b - p exactly, p the rounded product.  Source: Dekker, TwoProduct."""
    a_high, a_low = _halves(a)
    b_high, b_low = _halves(b)
    return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low


def product_rest(a, b, p, h):
    """a b - h rounded once, where p is a b rounded and p - h is exact."""
    return (p - h) + product_error(a, b, p)
