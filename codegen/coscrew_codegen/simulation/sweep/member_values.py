"""Computes the values of members: a function of the varied quantities and of the member's number
alone.

Member k is point k mod G of the G points of the grids, in which the last grid runs fastest, with
sample k div G of the Sobol sequence: every beginning of a sweep covers the grids and, as evenly as
the sequence does, the ranges."""

import warnings
from math import prod

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.simulation.sweep.specification import Varied

Values = NDArray[np.float64]
_BITS = 32


def values(varied: Varied, members: range) -> Values:
    """The values of consecutive members.  (number of members, number of columns)."""
    k = np.arange(members.start, members.stop)
    points = prod(varied.shape)
    result = np.empty((len(k), len(varied.columns)))
    remaining = k
    for i, grid in reversed(tuple(enumerate(varied.grids))):
        remaining, index = np.divmod(remaining, len(grid.values))
        result[:, i] = np.array(grid.values)[index]
    if varied.ranges:
        first, last = members[0] // points, members[-1] // points
        result[:, len(varied.grids):] = _samples(varied, first, last + 1)[k // points - first]
    return result


def _samples(varied: Varied, first: int, last: int) -> Values:
    """The ranges' values in samples first to last - 1."""
    from scipy.stats import qmc

    sequence = qmc.Sobol(len(varied.ranges), scramble=True, bits=_BITS,
                         rng=np.random.default_rng(varied.seed))
    if first:
        sequence.fast_forward(first)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # not a power of two: a chunk of them is
        unit = sequence.random(last - first)
    for i, x in enumerate(varied.ranges):
        unit[:, i] = _between(x.low, x.high, unit[:, i], x.log)
    return np.asarray(unit)


def _between(low: float, high: float, unit: Values, log: bool) -> Values:
    """low (high/low)^unit or low + unit (high - low), clipped to the ends."""
    if log:
        from mpmath import mp

        with mp.workdps(30):  # the C library's powers differ between machines
            step = mp.log(mp.mpf(high) / low)
            result = np.array([float(low * mp.exp(step * x)) for x in unit.tolist()])
    else:
        result = low + unit * (high - low)
    return np.asarray(np.clip(result, low, high))
