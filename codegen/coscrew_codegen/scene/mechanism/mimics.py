"""Joints that follow others."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from coscrew_codegen.scene.joints import ONE_COORDINATE, called
from coscrew_codegen.scene.mechanism.assembly import ModelError
from coscrew_codegen.scene.mechanism.model import Fault, Joint, Mimic, Model
from coscrew_codegen.scene.names import MANY, did_you_mean
from coscrew_codegen.scene.scene import Scene


def followers(scene: Scene) -> Mapping[str, Mimic]:
    """The joints that follow others, by name: where a mimic effect lets them, all."""
    if not any(applied.effect.mimic for applied in scene.effects):
        return {}
    return {joint.name: joint.mimic for joint in scene.model.joints if joint.mimic}


def without_chains(model: Model) -> Model:
    """The model with every follower attached directly to a joint that follows no other.

    q2 = α2 q1 + β2, q1 = α1 q0 + β1: q2 = α1 α2 q0 + α2 β1 + β2.  Raises ModelError for leaders
    that do not exist or do not have one coordinate, and for followers in a circle."""
    attached, wrong = _resolved(model)
    for joint in model.joints:
        if joint.name in wrong:
            raise ModelError(f"joint {joint.name!r}", wrong[joint.name])
    return replace(model, joints=tuple(replace(joint, mimic=attached.get(joint.name))
                                       for joint in model.joints))


def wrong_mimics(model: Model) -> Mapping[str, str]:
    """The problems of followers that cannot follow, by name."""
    return _resolved(model)[1]


def with_faults(model: Model, places: Mapping[str, str]) -> Model:
    """The model with faults in place of mimics that cannot be followed, of those joints for which
    `places` says where in a file the mimic stands."""
    wrong = wrong_mimics(model) if places else {}
    return replace(model, joints=tuple(
        replace(joint, mimic=None, faults=(*joint.faults, Fault(
            "mimic", wrong[joint.name], places[joint.name])))
        if joint.name in wrong and joint.name in places else joint for joint in model.joints))


def _resolved(model: Model) -> tuple[Mapping[str, Mimic], Mapping[str, str]]:
    """(whom each follower follows at the end of its chain, what is wrong with the others).

    Every follower is resolved once, after its leader, so that long chains take linear time."""
    by_name = {joint.name: joint for joint in model.joints}
    attached: dict[str, Mimic] = {}
    wrong: dict[str, str] = {}
    for joint in model.joints:
        for follower, mimic in reversed(_chain(joint, by_name, attached, wrong)):
            leader = mimic.joint
            if leader in wrong:
                wrong.setdefault(follower, wrong[leader])
            elif follower not in wrong:
                attached[follower] = _composed(mimic, attached.get(leader))
    return attached, wrong


def _chain(joint: Joint, by_name: Mapping[str, Joint], attached: Mapping[str, Mimic],
           wrong: dict[str, str]) -> Sequence[tuple[str, Mimic]]:
    """The followers from a joint to the first that is resolved, or whose leader follows no other.
    If the last of them cannot follow, `wrong` gets the reason."""
    chain: dict[str, Mimic] = {}
    while joint.mimic and joint.name not in attached and joint.name not in wrong:
        chain[joint.name] = joint.mimic
        leader = by_name.get(joint.mimic.joint)
        if leader is None:
            near = did_you_mean(joint.mimic.joint, by_name) if len(wrong) < MANY else "wanted one"
            wrong[joint.name] = f"mimics {joint.mimic.joint!r}, which is no joint; {near}"
        elif not leader.kind.one_coordinate:
            wrong[joint.name] = (f"mimics {leader.name!r}, which is {leader.kind.name}; wanted a "
                                 f"{called(ONE_COORDINATE, 'or')} joint")
        elif leader.name in chain:
            wrong[joint.name] = f"mimics itself, through {leader.name!r}"
        else:
            joint = leader
            continue
        break
    return tuple(chain.items())


def _composed(mimic: Mimic, of_leader: Mimic | None) -> Mimic:
    if of_leader is None:
        return mimic
    return Mimic(of_leader.joint, mimic.multiplier * of_leader.multiplier,
                 mimic.multiplier * of_leader.offset + mimic.offset)
