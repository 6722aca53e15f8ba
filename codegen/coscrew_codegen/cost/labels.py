"""Texts beside the marks of a panel, where they cover neither marks nor each other."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from matplotlib.axes import Axes
from matplotlib.transforms import Transform

_WIDTH = _HEIGHT = 225.0  # points, of a panel; nearly
_SIZE, _LETTER = 7.5, 4.5  # points: of the font, of one of its wider letters
_MARK = 10.0  # points across
_PLACES = ((9, 3, "left"), (-9, 3, "right"), (0, 10, "center"), (0, -16, "center"),
           (9, 12, "left"), (-9, 12, "right"), (9, -9, "left"), (-9, -9, "right"))
_SHIFT = {"left": 0.0, "center": 0.5, "right": 1.0}


@dataclass(frozen=True)
class Label:
    """A text at a mark, and the foot of the line below this, in coordinates of this transform."""

    text: str
    x: float
    y: float
    foot: float
    transform: Transform


class _Box(NamedTuple):
    left: float
    low: float
    right: float
    high: float

    def meets(self, other: "_Box") -> bool:
        return (self.left < other.right and other.left < self.right
                and self.low < other.high and other.low < self.high)


def label(axes: Axes, labels: Sequence[Label], colour: str) -> None:
    """Write them, each at the first place that is free; the limits of the axes are kept."""
    axes.set_xlim(axes.get_xlim())
    axes.set_ylim(axes.get_ylim())
    places = [_place(axes, x.transform, x.x, x.y) for x in labels]
    feet = [_place(axes, x.transform, x.x, x.foot)[1] for x in labels]
    taken = [_Box(x - _MARK / 2, y - _MARK / 2, x + _MARK / 2, y + _MARK / 2) for x, y in places]
    taken += [_Box(x - 1, low, x + 1, y) for (x, y), low in zip(places, feet, strict=True)]
    for one, (x, y) in zip(labels, places, strict=True):
        boxes = {place: _beside(x, y, one.text, *place) for place in _PLACES}
        free = [place for place, box in boxes.items() if _inside(box)
                and not any(box.meets(other) for other in taken)]
        dx, dy, side = (free or _PLACES)[0]
        taken.append(boxes[dx, dy, side])
        axes.annotate(one.text, (one.x, one.y), (dx, dy - 2), xycoords=one.transform, ha=side,
                      textcoords="offset points", fontsize=_SIZE, color=colour)


def _place(axes: Axes, transform: Transform, x: float, y: float) -> tuple[float, float]:
    """In points from the lower left corner of the panel."""
    across, up = axes.transAxes.inverted().transform(transform.transform((x, y))).tolist()
    return across * _WIDTH, up * _HEIGHT


def _beside(x: float, y: float, text: str, dx: float, dy: float, side: str) -> _Box:
    width = _LETTER * len(text)
    left = x + dx - _SHIFT[side] * width
    return _Box(left, y + dy - 3, left + width, y + dy - 3 + _SIZE)


def _inside(box: _Box) -> bool:
    return box.left > 0 and box.right < _WIDTH + 10
