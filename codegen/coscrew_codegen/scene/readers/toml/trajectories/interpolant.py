"""Interpolant: a function of time through the points of a table, which never overshoots them.

Between two points it is a cubic with the slopes of Fritsch and Butland ("A method for constructing
local monotone piecewise cubic interpolants", 1984), as SciPy's PchipInterpolator: monotone where
the points are.  Before the first point and after the last it holds their values.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

from coscrew_codegen.scene.formulas import Formula, V

MOST = 128
"""Points of a trajectory: each takes a choice of five numbers at every evaluation."""

_Cubic = tuple[Fraction, ...]  # its start, and the coefficients of powers of the time since then


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
        "less" and "where"."""
        start, *powers = _chosen(functions, t, self._cubics())
        s, result = t - start, powers[-1]
        for power in reversed(powers[:-1]):
            result = result * s + power
        answer: V = result
        return answer

    def _cubics(self) -> list[_Cubic]:
        """A constant, the cubic after each point, a constant: value, or rate."""
        slopes, none = _slopes(self.times, self.values), (Fraction(0),) * 3
        results: list[_Cubic] = [(self.times[0], self.values[0], *none)]
        for i, (start, end) in enumerate(pairwise(self.times)):
            h, y = end - start, self.values[i]
            mean = (self.values[i + 1] - y) / h
            results.append((start, y, slopes[i], (3 * mean - 2 * slopes[i] - slopes[i + 1]) / h,
                            (slopes[i] + slopes[i + 1] - 2 * mean) / h**2))
        results.append((self.times[-1], self.values[-1], *none))
        return [(x, b, 2 * c, 3 * d) for x, _, b, c, d in results] if self.is_rate else results


def _chosen(functions: Mapping[str, Any], t: Any, cubics: Sequence[_Cubic]) -> list[Any]:
    """The numbers of the cubic at t, by halving: of the last that starts before, or the first."""
    if len(cubics) == 1:
        return [functions["number"](x) for x in cubics[0]]
    half = len(cubics) // 2
    before = functions["less"](t, functions["number"](cubics[half][0]))
    return [functions["where"](before, a, b) for a, b in zip(
        _chosen(functions, t, cubics[:half]), _chosen(functions, t, cubics[half:]), strict=True)]


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
