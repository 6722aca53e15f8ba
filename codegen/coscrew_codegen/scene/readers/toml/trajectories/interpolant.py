"""Interpolant: a function of time through the points of a table, which never overshoots them.

Between two points it is a cubic with the slopes of Fritsch and Butland ("A method for constructing
local monotone piecewise cubic interpolants", 1984), as SciPy's PchipInterpolator: monotone where
the points are.  Before the first point and after the last it holds their values.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Any

from coscrew_codegen.program.tables import ConstantTable, TableColumn
from coscrew_codegen.scene.formulas import Formula, V

MOST = 100_000
"""Largest number of points of a trajectory."""


@dataclass(frozen=True)
class Interpolant(Formula):
    """A function of t through points, or its rate; `text` says where they are from."""

    times: tuple[Fraction, ...] = ()
    values: tuple[Fraction, ...] = ()
    is_rate: bool = False

    def __post_init__(self) -> None:
        """Takes the text as it is: it is no formula."""

    @property
    def timed(self) -> bool:
        """True: it depends on t."""
        return True

    @property
    def is_number(self) -> bool:
        """False: it is no number."""
        return False

    @property
    def rate(self) -> "Interpolant":
        """Its rate of change, zero before the first point and after the last."""
        return replace(self, is_rate=True)

    def value(self, t: V, functions: Mapping[str, object]) -> V:
        """The value at the time t, for any kind of numbers; `functions` as for formulas, with
        "less", "where" and "gather"."""
        f: Any = functions
        row = self._row(f, t)
        start, a, b, c, d = (f["gather"](TableColumn(self._cubics, k), row) for k in range(5))
        s = t - start
        result: V = ((3 * d) * s + 2 * c) * s + b if self.is_rate else ((d * s + c) * s + b) * s + a
        return result

    @cached_property
    def _cubics(self) -> ConstantTable:
        return _cubics(self.times, self.values)

    def _row(self, f: Any, t: Any) -> Any:
        """The last row that starts before t, or the first."""
        starts = TableColumn(self._cubics, 0)
        half = f["number"](Fraction(1, 2))
        if (step := self._even) is not None:
            first, per = f["number"](self.times[0]), f["number"](1 / step)
            return _later(f, t, starts, (t - first) * per + half, 1)  # its row, or one before
        row = half  # in its middle, so that no rounding leaves it
        for bit in reversed(range((self._cubics.rows - 1).bit_length())):
            row = _later(f, t, starts, row, 2**bit)
        return row

    @cached_property
    def _even(self) -> Fraction | None:
        """The step of times that are even, up to an eighth of it; None of others."""
        first, step = self.times[0], (self.times[-1] - self.times[0]) / (len(self.times) - 1)
        even = all(8 * abs(x - first - n * step) <= step for n, x in enumerate(self.times))
        return step if even else None


@lru_cache(8)  # a value and its rate read the same table
def _cubics(times: Sequence[Fraction], values: Sequence[Fraction]) -> ConstantTable:
    """A constant, the cubic after each point, a constant: of each its start, and the coefficients
    of powers of the time since then."""
    slopes, none = _slopes(times, values), (Fraction(0),) * 3
    rows = [(times[0], values[0], *none)]
    for i, (start, end) in enumerate(pairwise(times)):
        h, y = end - start, values[i]
        mean = (values[i + 1] - y) / h
        rows.append((start, y, slopes[i], (3 * mean - 2 * slopes[i] - slopes[i + 1]) / h,
                     (slopes[i] + slopes[i + 1] - 2 * mean) / h**2))
    rows.append((times[-1], values[-1], *none))
    return ConstantTable(tuple(x for row in rows for x in row), 5, 5)


def _later(f: Any, t: Any, starts: TableColumn, row: Any, more: int) -> Any:
    """A row, or one that is `more` rows behind it if that starts before t."""
    other = row + more
    return f["where"](f["less"](t, f["gather"](starts, other)), row, other)


def _slopes(times: Sequence[Fraction], values: Sequence[Fraction]) -> list[Fraction]:
    """The slopes at the points: of two neighbouring chords the weighted harmonic mean, zero where
    they have different signs; at the ends that of a parabola, limited."""
    h = [b - a for a, b in pairwise(times)]
    chords = [(b - a) / x for (a, b), x in zip(pairwise(values), h, strict=True)]
    if len(h) == 1:
        return [chords[0]] * 2
    inner = []
    for (h0, h1), (a, b) in zip(pairwise(h), pairwise(chords), strict=True):
        w0, w1 = 2 * h1 + h0, h1 + 2 * h0
        inner.append((w0 + w1) / (w0 / a + w1 / b) if a * b > 0 else Fraction(0))
    return [_at_end(h[0], h[1], chords[0], chords[1]), *inner,
            _at_end(h[-1], h[-2], chords[-1], chords[-2])]


def _at_end(h0: Fraction, h1: Fraction, a: Fraction, b: Fraction) -> Fraction:
    """The slope at an end beside the chord a, which the chord b follows."""
    slope = ((2 * h0 + h1) * a - h0 * b) / (h0 + h1)
    if slope * a <= 0:
        return Fraction(0)
    return 3 * a if a * b <= 0 and abs(slope) > 3 * abs(a) else slope
