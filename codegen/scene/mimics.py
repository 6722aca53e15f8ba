"""Joints that follow others."""

from dataclasses import replace

from coscrew_codegen.scene.assembly import ModelError
from coscrew_codegen.scene.model import Joint, Kind, Mimic, Model
from coscrew_codegen.scene.names import did_you_mean


def without_chains(model: Model) -> Model:
    """The model with every follower attached directly to a joint that follows no other.

    q2 = α2 q1 + β2, q1 = α1 q0 + β1: q2 = α1 α2 q0 + α2 β1 + β2.  Raises ModelError for leaders
    that do not exist or do not have one coordinate, and for followers in a circle."""
    by_name = {joint.name: joint for joint in model.joints}
    return replace(model, joints=tuple(
        replace(joint, mimic=_resolved(joint, joint.mimic, by_name)) if joint.mimic else joint
        for joint in model.joints))


def wrong_mimics(model: Model) -> dict[str, str]:
    """What is wrong with followers that cannot follow, by name."""
    by_name = {joint.name: joint for joint in model.joints}
    found = {}
    for joint in model.joints:
        try:
            if joint.mimic:
                _resolved(joint, joint.mimic, by_name)
        except ModelError as error:
            found[joint.name] = error.problem
    return found


def _resolved(follower: Joint, mimic: Mimic, by_name: dict[str, Joint]) -> Mimic:
    element = f"joint {follower.name!r}"
    passed = {follower.name}
    while True:
        leader = by_name.get(mimic.joint)
        if leader is None:
            raise ModelError(element, f"mimics {mimic.joint!r}, which is no joint; "
                             f"{did_you_mean(mimic.joint, by_name)}")
        if leader.kind not in (Kind.REVOLUTE, Kind.PRISMATIC):
            raise ModelError(element, f"mimics {leader.name!r}, which is {leader.kind.value}; "
                             "wanted a revolute or prismatic joint")
        if leader.name in passed:
            raise ModelError(element, f"mimics itself, through {leader.name!r}")
        if leader.mimic is None:
            return mimic
        passed.add(leader.name)
        mimic = Mimic(leader.mimic.joint, mimic.multiplier * leader.mimic.multiplier,
                      mimic.multiplier * leader.mimic.offset + mimic.offset)
