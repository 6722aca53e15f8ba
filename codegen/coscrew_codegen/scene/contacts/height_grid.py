"""Heights over a uniform grid of places, between which they are smooth.

In each direction runs Catmull and Rom's cubic: through the points, with the slope of the chord
between a point's neighbours; at the edges that of the last two points.  So heights and slopes are
continuous, and a change of cell is no matter of choice:

    H(x, y) = Σ_ij K((x - x_i)/h) K((y - y_j)/k) H_ij,   K(u) = 0 for |u| > 2.

Beyond the edges the ground goes on level."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from coscrew_codegen.program.tables import ConstantTable, TableColumn
from coscrew_codegen.scene.formulas import Formula, V

MOST = 2**20
"""Largest number of points."""
_HALF = Fraction(1, 2)
_WEIGHTS = ((-_HALF, Fraction(1), -_HALF, Fraction(0)),
            (3 * _HALF, -5 * _HALF, Fraction(0), Fraction(1)),
            (-3 * _HALF, Fraction(2), _HALF, Fraction(0)),
            (_HALF, -_HALF, Fraction(0), Fraction(0)))
"""K(1 + u), K(u), K(1 - u), K(2 - u) for 0 <= u <= 1, powers of u from the third on."""


@dataclass(frozen=True)
class HeightGrid(Formula):
    """A function of x and y through heights at points; `text` says where they are from."""

    start: tuple[Fraction, ...] = ()  # x, y of the first point
    spacing: tuple[Fraction, ...] = ()
    rows: tuple[tuple[Fraction, ...], ...] = ()  # by y, then by x

    def __post_init__(self) -> None:
        """Takes the text as it is: it is no formula."""

    @property
    def timed(self) -> bool:
        """False: it depends on places alone."""
        return False

    @property
    def is_number(self) -> bool:
        """False: it is no number."""
        return False

    def value(self, t: V, functions: Mapping[str, object]) -> V:
        """The height at the place that `functions` give as x and y, for any kind of numbers."""
        f: Any = functions
        (column, across), (row, along) = (self._cell(f, k) for k in range(2))
        stride = len(self.rows[0]) + 2
        at = row * stride + (column + f["number"](Fraction(1, 2)))  # no rounding leaves the row
        rows = [[f["gather"](TableColumn(self._points, i * stride + k), at) for k in range(4)]
                for i in range(4)]
        result: V = _sum([weight * _sum([w * z for w, z in zip(across, heights, strict=True)])
                          for weight, heights in zip(along, rows, strict=True)])
        return result

    def _cell(self, f: Any, k: int) -> tuple[Any, list[Any]]:
        """The number of the cell in a direction, and the weights of the points around it."""
        last = (len(self.rows[0]), len(self.rows))[k] - 1
        number = f["number"]
        start, per = number(self.start[k]), number(1 / self.spacing[k])
        place = (f["xy"[k]]() - start) * per
        place = f["max"](f["min"](place, number(Fraction(last))), number(Fraction(0)))
        cell = f["index"](place, last)
        u = place - cell
        weights = [tuple(map(number, row)) for row in _WEIGHTS]
        return cell, [((a * u + b) * u + c) * u + d if row[2] else (a * u + b) * u * u + d
                      for row, (a, b, c, d) in zip(_WEIGHTS, weights, strict=True)]

    @cached_property
    def _points(self) -> ConstantTable:
        """The heights, with lines beyond the edges that go on straight, by row; every cell reads
        four heights of four rows."""
        rows = [_straight(row) for row in self.rows]
        first, last = ([2 * a - b for a, b in zip(rows[i], rows[k], strict=True)]
                       for i, k in ((0, 1), (-1, -2)))
        return ConstantTable(tuple(z for row in (first, *rows, last) for z in row), 1,
                             3 * len(first) + 4)


def _straight(line: Sequence[Fraction]) -> list[Fraction]:
    return [2 * line[0] - line[1], *line, 2 * line[-1] - line[-2]]


def _sum(terms: Sequence[Any]) -> Any:
    total = terms[0]
    for x in terms[1:]:
        total = total + x
    return total
