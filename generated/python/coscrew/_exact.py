# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Exact rounding errors, for compensated kernels: the same bits as fma for all numbers.

NumPy has no fma.  Factors are split into halves of 26 bits; elements for which that overflows or
underflows are computed in rationals.
"""

from fractions import Fraction
from math import isfinite

import numpy as np
from numpy import absolute

_SPLITTER = 134217729.0  # 2^27 + 1
_LEAST, _MOST = 2.0**-968, 2.0**996  # between these, halves and products of halves are exact


def product_error(a, b, p):
    """a b - p rounded once, p the rounded product; the exact error where |p| >= 2^-968."""
    return _elsewhere(_split(a, b, p), _dekker(a, b, p), a, b, p)


def product_error_single(a, b, p):
    """a b - p rounded once to single precision: a b is exact in double."""
    with np.errstate(all="ignore"):
        a, b, p = (np.asarray(x, np.float32).astype(np.float64) for x in (a, b, p))
        return np.float32(a * b - p)


def product_rest_single(a, b, p, h):
    """a b - h rounded once to single precision, where p is a b rounded and p - h is exact."""
    return product_error_single(a, b, h)


def product_rest(a, b, p, h):
    """a b - h rounded once, where p is a b rounded and p - h is exact."""
    with np.errstate(all="ignore"):
        rest, error = p - h, _dekker(a, b, p)
        found = np.where(error == 0, rest, rest + error)[()]  # -0 stays -0
    return _elsewhere(_split(a, b, p), found, a, b, h)


def _split(a, b, p):
    """Where the computation by halves is exact."""
    size = absolute(p)
    return (((size >= _LEAST) | (a == 0) | (b == 0)) & (size <= _MOST)
            & (absolute(a) <= _MOST) & (absolute(b) <= _MOST))


def _dekker(a, b, p):
    """a b - p.  Source: Dekker, TwoProduct."""
    with np.errstate(all="ignore"):
        a_high, a_low = _halves(a)
        b_high, b_low = _halves(b)
        return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low


def _halves(a):
    """a = high + low, each of at most 26 bits.  Source: Veltkamp."""
    c = _SPLITTER * a
    high = c - (c - a)
    return high, a - high


def _elsewhere(where, found, a, b, c):
    """`found` where the mask `where` holds, else a b - c rounded once."""
    if where.all():
        return found
    found, rest = np.array(found), ~where
    factors = [np.broadcast_to(x, found.shape)[rest].tolist() for x in (a, b, c)]
    found[rest] = list(map(_fused, *factors))
    return found[()]


def _fused(a, b, c):
    """a b - c rounded once, for three floats."""
    if not (isfinite(a) and isfinite(b)):
        return a * b - c
    if not isfinite(c):
        return -c
    exact = Fraction(a) * Fraction(b) - Fraction(c)
    try:
        return float(exact) if exact else a * b - c
    except OverflowError:
        return float("inf") if exact > 0 else -float("inf")
