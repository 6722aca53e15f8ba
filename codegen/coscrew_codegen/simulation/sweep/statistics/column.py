"""Counts and sums of one recorded column over the members of a sweep, chunk after chunk."""

from dataclasses import dataclass, field
from itertools import combinations

import numpy as np

from coscrew_codegen.simulation.sweep.member_summary import STATISTICS
from coscrew_codegen.simulation.sweep.statistics.axis import Axis

_PAIRED = 6  # largest number of varied quantities for maps of all pairs


@dataclass
class ColumnStatistics:
    """Counts and sums of the statistics of a recorded column over the members that did not fail,
    and counts of failed members."""

    own: Axis  # of its values, from the smallest minimum to the largest maximum
    axes: tuple[Axis, ...]  # of the varied quantities
    count: int = 0
    lowest: np.ndarray = field(init=False)  # of each statistic
    highest: np.ndarray = field(init=False)
    total: np.ndarray = field(init=False)
    square: np.ndarray = field(init=False)  # sum of squares about the middle of the range
    histogram: np.ndarray = field(init=False)  # (statistics, bins)
    sums: list[np.ndarray] = field(init=False)  # (statistics, bins) for each axis
    counts: list[np.ndarray] = field(init=False)  # (bins) for each axis
    joint: list[np.ndarray] = field(init=False)  # (bins, own bins) for each axis: of final values
    lost: list[np.ndarray] = field(init=False)  # (bins) for each axis: members that failed
    pairs: dict[tuple[int, int], np.ndarray] = field(init=False)  # counts, sums, failed members

    def __post_init__(self) -> None:
        n, axes = len(STATISTICS), self.axes
        self.lowest, self.highest = np.full(n, np.inf), np.full(n, -np.inf)
        self.total, self.square = np.zeros(n), np.zeros(n)
        self.histogram = np.zeros((n, self.own.bins))
        self.sums = [np.zeros((n, x.bins)) for x in axes]
        self.counts = [np.zeros(x.bins) for x in axes]
        self.joint = [np.zeros((x.bins, self.own.bins)) for x in axes]
        self.lost = [np.zeros(x.bins) for x in axes]
        self.pairs = {(i, j): np.zeros((3, axes[i].bins, axes[j].bins))
                      for i, j in combinations(range(min(len(axes), _PAIRED)), 2)}

    def add(self, values: np.ndarray, places: list[np.ndarray]) -> None:
        """Count a chunk: (statistics, members) and each member's bins of the axes."""
        kept = np.isfinite(values).all(0)
        self._lose([x[~kept] for x in places])
        values, places = values[:, kept], [x[kept] for x in places]
        if not values.size:
            return
        middle = values - self._middle
        self.count += values.shape[1]
        self.lowest = np.minimum(self.lowest, values.min(1))
        self.highest = np.maximum(self.highest, values.max(1))
        self.total += middle.sum(1)
        self.square += (middle**2).sum(1)
        result = self.own.index(values)
        self.histogram += [np.bincount(x, minlength=self.own.bins) for x in result]
        for i, (axis, at) in enumerate(zip(self.axes, places, strict=True)):
            self.counts[i] += np.bincount(at, minlength=axis.bins)
            self.sums[i] += [np.bincount(at, x, axis.bins) for x in middle]
            self.joint[i] += _both(at, result[0], axis.bins, self.own.bins)
        for (i, j), (counts, sums, _) in self.pairs.items():
            sizes = self.axes[i].bins, self.axes[j].bins
            counts += _both(places[i], places[j], *sizes)
            sums += _both(places[i], places[j], *sizes, middle[0])

    def _lose(self, places: list[np.ndarray]) -> None:
        """Count members that failed, by their bins of the axes."""
        for lost, axis, at in zip(self.lost, self.axes, places, strict=True):
            lost += np.bincount(at, minlength=axis.bins)
        for (i, j), (_, _, lost) in self.pairs.items():
            lost += _both(places[i], places[j], *lost.shape)

    @property
    def _middle(self) -> float:
        return (self.own.low + self.own.high) / 2

    @property
    def mean(self) -> np.ndarray:
        """Mean of each statistic over the members."""
        return np.asarray(self._middle + self.total / max(self.count, 1))

    def explained(self, axis: int) -> np.ndarray:
        """The share of each statistic's variance that an axis explains alone: the variance of the
        means in its bins, less that of as many bins of noise."""
        n, bins = self.count, self.counts[axis]
        filled = bins > 0
        whole = self.square - self.total**2 / max(n, 1)
        between = (self.sums[axis][:, filled]**2 / bins[filled]).sum(1) - self.total**2 / max(n, 1)
        spare = n - int(filled.sum())
        if spare <= 0:
            return np.full(len(whole), np.nan)
        noise = (whole - between) * (int(filled.sum()) - 1) / spare
        with np.errstate(all="ignore"):
            return np.clip(np.where(whole > 0, (between - noise) / whole, np.nan), 0, 1)

    def means(self, pair: tuple[int, int]) -> np.ndarray:
        """The mean of the final value in the bins of two axes; NaN in empty ones."""
        counts, sums, _ = self.pairs[pair]
        with np.errstate(all="ignore"):
            return np.asarray(self._middle + sums / counts)

    @property
    def varies(self) -> bool:
        """True if its values differ."""
        return self.count > 0 and self.own.high > self.own.low


def _both(i: np.ndarray, j: np.ndarray, rows: int, columns: int, weights: np.ndarray | None = None
          ) -> np.ndarray:
    """Counts, or sums of weights, in the cells of two bins."""
    return np.bincount(i * columns + j, weights, rows * columns).reshape(rows, columns)
