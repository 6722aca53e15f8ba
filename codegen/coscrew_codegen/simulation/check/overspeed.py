"""Reports joints that move faster than the model's limit of their velocity."""

from collections.abc import Iterator

import numpy as np

from coscrew_codegen.scene.mechanism.mimics import without_chains
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.simulation.recordings.result import Result

_MANY = 3
"""Joints that the warning lists."""


def overspeed(result: Result) -> str:
    """A warning that names joints whose speed passes the model's limit at a sample, those that pass
    it most first; else "".  Of several members it is the fastest."""
    speeds = dict(_speeds(result))
    passed = []
    for joint in result.system.scene.model.joints:
        if joint.velocity and joint.name in speeds:
            v, limit = np.abs(speeds[joint.name]), float(joint.velocity)
            fastest = float(np.max(v, initial=0, where=np.isfinite(v)))
            if fastest > limit * (1 + 4 * float(np.finfo(result.v.dtype).eps)):
                unit = "m/s" if joint.kind.slides else "rad/s"
                passed.append((fastest / limit, f"joint {joint.name} moves at {fastest:.3g} {unit}"
                               f", above the model's limit, {limit:g} {unit}"))
    first = [words for _, words in sorted(passed, reverse=True)[:_MANY]]
    more = f"; likewise {len(passed) - _MANY} more" if len(passed) > _MANY else ""
    cure = "; [effects.speed_limit] brakes" if passed else ""
    return "; ".join(first) + more + cure


def _speeds(result: Result) -> Iterator[tuple[str, np.ndarray]]:
    """The velocities of joints with one, (…); those of followers are multiples of their leaders'.
    """
    of = {}
    for c in result.system.functions.coordinates:
        if len(c.v) == 1:
            of[c.joint] = result.v[..., c.v.start].astype(float)
    yield from of.items()
    yield from ((joint.name, of[joint.mimic.joint] * float(joint.mimic.multiplier))
                for joint in _followers(result)
                if joint.mimic and joint.name not in of and joint.mimic.joint in of)


def _followers(result: Result) -> tuple[Joint, ...]:
    model = result.system.scene.model
    return (without_chains(model) if any(x.mimic for x in model.joints) else model).joints
