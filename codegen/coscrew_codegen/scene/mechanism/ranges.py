"""Ranges: the intervals in which the arguments of a scene's functions lie, as the scene or the
limits of its joints state them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf, nextafter

from coscrew_codegen.program.values.parameter import Parameter
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.mechanism.tree import Tree

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


LIMITS = {"q": ("lower", "upper"), "v": ("velocity",), "tau": ("effort",)}
"""The fields of a joint that limit an argument of functions."""


def ranges_of_model(tree: Tree, parameters: Sequence[Parameter]) -> Ranges:
    """Positions and velocities between the limits of joints, and run-time parameters up to their
    values in size; nothing else has a range."""
    joints = [link.joint for link in tree.links if link.driver is None]
    firsts: list[int] = []
    for link in tree.links:
        if link.driver is None:
            firsts += [link.q.start + places.start for places in link.joint.kind.quaternions]
    return Ranges(
        q=tuple(x for joint in joints for x in _positions(joint)),
        v=tuple(limits(joint, "v") or UNSTATED for joint in joints for _ in range(joint.kind.nv)),
        a=(UNSTATED,) * tree.nv, tau=(UNSTATED,) * tree.nv,
        p=tuple(symmetric(abs(x.value)) for x in parameters), quaternions=tuple(firsts))


def limits(joint: Joint, argument: str) -> Interval | None:
    """The interval between the limits of a joint; None unless it has them and one coordinate."""
    ends = [getattr(joint, field) for field in LIMITS[argument]]
    if not joint.kind.one_coordinate or None in ends:
        return None
    return interval(*ends) if len(ends) > 1 else symmetric(ends[0])


def _positions(joint: Joint) -> Intervals:
    if joint.kind.one_coordinate:
        return (limits(joint, "q") or UNSTATED,)
    parts = (QUATERNION if x.quaternion else (UNSTATED,) * x.count for x in joint.kind.parts)
    return tuple(x for part in parts for x in part)
