"""Heights over a uniform grid of places, between which they are smooth.

In each direction runs Catmull and Rom's cubic: through the points, with the slope of the chord
between a point's neighbours; at the edges that of the last two points.  So heights and slopes are
continuous, and a change of cell is no matter of choice:

    H(x, y) = Σ_ij K((x - x_i)/h) K((y - y_j)/k) H_ij,   K(u) = 0 for |u| > 2.

Beyond the edges the ground goes on level."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from coscrew_codegen.scene.formulas import Formula, V

MOST = 128
"""Largest number of points: each costs two products, wherever the place is."""
_CORE = (Fraction(3, 2), Fraction(-5, 2), Fraction(0), Fraction(1))
_SKIRT = (Fraction(-1, 2), Fraction(5, 2), Fraction(-4), Fraction(2))
"""K(u) for |u| < 1 and |u| < 2, powers of |u| from the third on."""


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
        counts = (len(self.rows[0]), len(self.rows))
        across, along = ([_kernel(f, u) for u in self._distances(f, name, k, counts[k])]
                         for k, name in enumerate(("x", "y")))
        total: Any = None
        for own, row in zip(along, self._extended(), strict=True):
            part = own * _sum([k * z for k, z in zip(across, row, strict=True) if z] or [
                across[0] * 0])
            total = part if total is None else total + part
        result: V = total
        return result

    def _distances(self, f: Any, name: str, k: int, count: int) -> list[Any]:
        """The distances from all grid lines of a direction, and one beyond each edge, in
        spacings."""
        place = (f[name]() - self.start[k]) * (1 / self.spacing[k])
        first, last = (f["number"](Fraction(x)) for x in (0, count - 1))
        inside = f["max"](f["min"](place, last), first)
        return [f["abs"](inside - i) for i in range(-1, count + 1)]

    def _extended(self) -> list[list[Fraction]]:
        """The heights, with lines beyond the edges that go on straight."""
        rows = [_straight([*row]) for row in self.rows]
        columns = [_straight([row[k] for row in rows]) for k in range(len(rows[0]))]
        return [list(row) for row in zip(*columns, strict=True)]


def _straight(line: Sequence[Fraction]) -> list[Fraction]:
    return [2 * line[0] - line[1], *line, 2 * line[-1] - line[-2]]


def _kernel(f: Any, u: Any) -> Any:
    """K(u) for u >= 0."""
    core, skirt = (((a * u + b) * u + c) * u + d if c else (a * u + b) * u * u + d
                   for a, b, c, d in (_CORE, _SKIRT))
    return f["where"](f["less"](u, 1), core, f["where"](f["less"](u, 2), skirt, 0))


def _sum(terms: Sequence[Any]) -> Any:
    total = terms[0]
    for x in terms[1:]:
        total = total + x
    return total
