"""Axes of distributions and maps: bins of a varied quantity or of a recorded one."""

import math
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.simulation.sweep.specification import Grid, Range

_MOST = 40  # bins


@dataclass(frozen=True)
class Axis:
    """The points of a grid, if they are few, or else equal parts of a range; if `log`, in
    logarithms."""

    name: str
    unit: str
    low: float
    high: float
    parts: int
    log: bool = False
    points: tuple[float, ...] = ()  # ascending

    @property
    def label(self) -> str:
        """Its name and unit."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    @property
    def bins(self) -> int:
        """Number of bins."""
        return len(self.points) or self.parts

    def index(self, x: np.ndarray) -> np.ndarray:
        """The bin of each value."""
        if self.points:
            return np.asarray(np.searchsorted(self.points, x))
        if not self.high > self.low:
            return np.zeros(x.shape, int)
        low, high = self.low, self.high
        if self.log:
            x, low, high = np.log(x), math.log(low), math.log(high)
        result = ((x - low) / (high - low) * self.parts).astype(int)
        return np.asarray(np.clip(result, 0, self.parts - 1))

    @property
    def edges(self) -> np.ndarray:
        """The ends of the bins; half way between points."""
        if len(self.points) > 1:
            points = np.log(self.points) if self.log else np.array(self.points)
            inner = (points[1:] + points[:-1]) / 2
            ends = np.array([2 * points[0] - inner[0], *inner, 2 * points[-1] - inner[-1]])
            return np.asarray(np.exp(ends) if self.log else ends)
        if self.log:
            return np.geomspace(self.low, self.high, self.parts + 1)
        low, high = self.low, self.high
        if not high > low:
            low, high = low - 0.5, high + 0.5
        return np.linspace(low, high, self.bins + 1)

    @property
    def middles(self) -> np.ndarray:
        """Middles of the bins."""
        if self.points:
            return np.array(self.points)
        low, high = self.edges[:-1], self.edges[1:]
        return np.asarray(np.sqrt(low) * np.sqrt(high) if self.log else (low + high) / 2)


def parts_for(members: int) -> int:
    """Returns a number of bins for so many members: Sturges' for few, for many so many that each
    cell of a map has about nine members."""
    return min(_MOST, max(math.ceil(math.log2(members)) + 1, round(math.sqrt(members) / 3)))


def of_varied(x: Grid | Range, parts: int) -> Axis:
    """The axis of a varied quantity."""
    if isinstance(x, Range):
        return Axis(x.of.name, x.of.unit, x.low, x.high, parts, x.log)
    few = tuple(sorted({*x.values})) if len(x.values) <= _MOST else ()
    return Axis(x.of.name, x.of.unit, min(x.values), max(x.values), parts, _geometric(x.values),
                few)


def _geometric(values: tuple[float, ...]) -> bool:
    """Returns whether each is the one before times the same number."""
    if len(values) < 3 or min(values) <= 0:
        return False
    steps = np.diff(np.log(values))
    return bool(np.allclose(steps, steps[0], rtol=1e-9, atol=0))
