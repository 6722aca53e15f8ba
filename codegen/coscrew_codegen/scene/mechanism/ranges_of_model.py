"""Ranges that a model states by the limits of its joints."""

from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.mechanism.ranges import (
    QUATERNION,
    UNSTATED,
    Interval,
    Intervals,
    Ranges,
    interval,
    symmetric,
)
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Scene

LIMITS = {"q": ("lower", "upper"), "v": ("velocity",), "tau": ("effort",)}
"""The fields of a joint that limit an argument of functions."""


def ranges_of_model(scene: Scene, tree: Tree) -> Ranges:
    """Positions and velocities between the limits of joints, and parameters up to the scene's
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
        p=tuple(symmetric(abs(x.value)) for x in scene.parameters), quaternions=tuple(firsts))


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
