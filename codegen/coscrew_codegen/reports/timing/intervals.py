"""Medians with distribution-free confidence intervals.

The interval of a median reaches from the k-th shortest to the k-th longest sample, k the largest
with P(B < k) <= 2.5 %, B binomial with n and 1/2: of 100 such intervals 95 hold the true median, if
samples are independent.  With fewer than 6 samples that is impossible; the interval then reaches
from the shortest to the longest.
"""

from dataclasses import dataclass
from functools import cache
from math import comb

import numpy as np

FEWEST = 6
"""The number of samples that an interval of 95 % needs."""

_TAIL = 40  # one in 40 lies on either side


@dataclass(frozen=True)
class Interval:
    """A median and its confidence interval."""

    median: float
    low: float
    high: float

    def numbers(self, scale: float = 1.0) -> tuple[float, float, float]:
        """The median, low and high, times a factor."""
        return scale * self.median, scale * self.low, scale * self.high

    def below(self, other: "Interval") -> bool:
        """Returns whether this interval lies below the other, without overlap."""
        return self.high < other.low


def interval(samples: np.ndarray) -> Interval:
    """The median of at least one sample, and its interval."""
    ordered = np.sort(samples)
    k = rank(len(ordered))
    return Interval(float(np.median(ordered)), float(ordered[k - 1]), float(ordered[-k]))


@cache
def rank(count: int) -> int:
    """k, counted from 1."""
    below, k = 0, 0  # below: 2^count P(B < k)
    while _TAIL * (below + comb(count, k)) <= 2**count:
        below += comb(count, k)
        k += 1
    return max(k, 1)
