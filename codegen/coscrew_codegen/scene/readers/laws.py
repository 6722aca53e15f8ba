"""Laws of joints as closed loops."""

from collections.abc import Iterable
from fractions import Fraction

from coscrew_codegen.scene.mechanism.loop import (
    LAW,
    LAW_OF_LENGTHS,
    ClosedLoop,
    Law,
    LoopEnd,
    WeightedCoordinate,
)
from coscrew_codegen.scene.mechanism.model import Joint


def law(name: str, every: Iterable[Joint], joints: tuple[WeightedCoordinate, ...],
        leaders: tuple[WeightedCoordinate, ...], polynomial: tuple[Fraction, ...]) -> ClosedLoop:
    """The law that the sum of some of these joints' coordinates is a polynomial of another.  It is
    one of lengths if a coordinate in the first sum is one."""
    by_name = {x.name: x for x in every}
    places = {name: place for place, name in enumerate(by_name)}
    joints, leaders = (tuple(sorted(of, key=lambda x: (places[x.joint], x.coordinate)))
                       for of in (joints, leaders))
    lengths = any(by_name[x.joint].kind.units("q")[x.coordinate] == "m" for x in joints)
    bodies = dict.fromkeys(by_name[x.joint].child for x in joints + leaders)
    first = by_name[joints[0].joint]
    return ClosedLoop(name, LAW_OF_LENGTHS if lengths else LAW, LoopEnd(first.child),
                      LoopEnd(first.parent), law=Law(joints, leaders, polynomial, tuple(bodies)))
