"""Ranges: the intervals in which the arguments of a scene's functions are stated to lie."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import inf, nextafter

Interval = tuple[float, float]
Intervals = tuple[Interval, ...]

UNSTATED: Interval = (-inf, inf)


@dataclass(frozen=True)
class Ranges:
    """An interval for each component of each argument, with ends rounded outwards to double
    precision; infinite ends where nothing is stated."""

    q: Intervals
    v: Intervals
    a: Intervals
    tau: Intervals
    p: Intervals
    t: Intervals = (UNSTATED,)
    quaternions: tuple[int, ...] = ()  # where in q each unit quaternion begins

    def of(self, argument: str, count: int) -> Intervals:
        """The intervals of an argument's components; unstated ones of arguments without ranges, and
        of effects' states at the end of q."""
        own = self.by_name.get(argument, ())
        return *own, *(UNSTATED,) * (count - len(own))

    @property
    def sizes(self) -> tuple[tuple[str, tuple[float, ...]], ...]:
        """The largest sizes of each argument's components; infinite where nothing is stated."""
        return tuple((name, tuple(max(-lower, upper) for lower, upper in intervals))
                     for name, intervals in self.by_name.items())

    def stating(self, intervals: Mapping[str, Intervals]) -> "Ranges":
        """These ranges with other intervals for some arguments."""
        return Ranges(**{**self.by_name, **intervals}, quaternions=self.quaternions)

    @property
    def by_name(self) -> Mapping[str, Intervals]:
        """The intervals of each argument that has a range."""
        return {name: getattr(self, name) for name in ARGUMENTS}


ARGUMENTS = ("q", "v", "a", "tau", "p", "t")
"""Arguments of functions whose ranges a scene can state."""

_COMPONENT = 1.0005  # above √1.001, the largest norm of quaternions in stated ranges
QUATERNION: Intervals = ((-_COMPONENT, _COMPONENT),) * 4


def interval(lower: Fraction, upper: Fraction) -> Interval:
    """The smallest interval of numbers in double precision around these."""
    return _below(lower), -_below(-upper)


def symmetric(size: Fraction) -> Interval:
    """The numbers up to this size."""
    return interval(-size, size)


def _below(x: Fraction) -> float:
    near = float(x)
    return near if Fraction(near) <= x else nextafter(near, -inf)
