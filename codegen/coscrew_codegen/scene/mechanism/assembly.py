"""Assembles bodies and joints into the tree of a Model, with joints that follow others."""

import heapq
from collections.abc import Mapping, Sequence
from dataclasses import replace

from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.scene.joints import ONE_COORDINATE, called
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.model import (
    HERE,
    WORLD,
    Body,
    Fault,
    Joint,
    Mimic,
    Model,
    Placement,
)
from coscrew_codegen.scene.names import MANY, did_you_mean
from coscrew_codegen.scene.scene import Scene

BASE = "base"
"""The name of the joint that joins a model's root to the world."""


class ModelError(ReportedError, ValueError):
    """Bodies and joints do not form a tree; `element` is the cause: "joint 'elbow'"."""

    def __init__(self, element: str, problem: str) -> None:
        super().__init__(f"{element}: {problem}")
        self.element, self.problem = element, problem


def assembled(name: str, bodies: Sequence[Body], joints: Sequence[Joint], base: JointKind,
              roots: Mapping[str, Placement] | None = None) -> Model:
    """The model of these bodies and joints, parents first, otherwise in the given order.

    A root body other than WORLD is joined to it by a joint "base" ("base_" if that name is taken)
    of the kind `base`, at the place that `roots` gives a body, by default at the world's frame.  A
    body called WORLD is the world.  Raises ModelError for duplicate or unknown names, bodies with
    two parents, loops and several roots."""
    _refuse_twice("body", [body.name for body in bodies])
    _refuse_twice("joint", [joint.name for joint in joints])
    by_name = {body.name: body for body in bodies if body.name != WORLD}
    _check_ends(joints, by_name)
    root = _root(bodies, joints)
    if root == WORLD and base.moves:
        raise ModelError("base", 'wanted "fixed": the root is the world, which cannot move freely')
    if root != WORLD:
        at = (roots or {}).get(root, HERE)
        joints = (Joint(_unused(BASE, joints), base, WORLD, root, at), *joints)
    ordered = parents_first(joints)
    return Model(name, tuple(by_name[joint.child] for joint in ordered), ordered)


def _refuse_twice(what: str, names: list[str]) -> None:
    seen = set()
    for name in names:
        if name in seen:
            raise ModelError(f"{what} {name!r}", "this name is given to two of them")
        seen.add(name)


def _check_ends(joints: Sequence[Joint], bodies: dict[str, Body]) -> None:
    """Refuse joints of unknown bodies, and bodies that are the child of two joints."""
    mover: dict[str, str] = {}
    for joint in joints:
        element = f"joint {joint.name!r}"
        for word, body in (("parent", joint.parent), ("child", joint.child)):
            if body not in bodies and (body, word) != (WORLD, "parent"):
                hint = ("the world cannot be moved" if body == WORLD
                        else did_you_mean(body, (WORLD, *bodies) if word == "parent" else bodies))
                raise ModelError(element, f"{word} {body!r} is no body; {hint}")
        if joint.parent == joint.child:
            raise ModelError(element, f"parent and child are the same body, {joint.child!r}")
        if joint.child in mover:
            raise ModelError(f"body {joint.child!r}", "is the child of two joints, "
                             f"{mover[joint.child]!r} and {joint.name!r}; wanted one, and "
                             "[loops.NAME] in a scene, which closes loops of a tree")
        mover[joint.child] = joint.name


def _root(bodies: Sequence[Body], joints: Sequence[Joint]) -> str:
    """The one body that no joint moves, or WORLD."""
    if not any(body.name != WORLD for body in bodies):
        raise ModelError("model", "has no bodies")
    moved = {joint.child for joint in joints}
    roots = [body.name for body in bodies if body.name not in moved and body.name != WORLD]
    if any(joint.parent == WORLD for joint in joints):
        roots = [WORLD, *roots]
    if not roots:
        raise ModelError(f"joint {joints[0].name!r}", "is part of a loop: no body is the root")
    if len(roots) > 1:
        raise ModelError(f"body {roots[1]!r}", f"no joint moves it, but the root is {roots[0]!r}: "
                         f"several roots ({', '.join(map(repr, roots[:5]))}); bodies that float "
                         'free beside others take joints of type "free"')
    return roots[0]


def parents_first(joints: Sequence[Joint]) -> tuple[Joint, ...]:
    """The joints, each after the one that moves its parent, otherwise in the given order.  Raises
    ModelError for a loop."""
    moved_by = {joint.child: i for i, joint in enumerate(joints)}
    waiting: dict[str, list[int]] = {}
    for i, joint in enumerate(joints):
        waiting.setdefault(joint.parent, []).append(i)
    ready, ordered = list(waiting.get(WORLD, [])), []
    heapq.heapify(ready)
    while ready:
        joint = joints[heapq.heappop(ready)]
        ordered.append(joint)
        for i in waiting.get(joint.child, ()):
            heapq.heappush(ready, i)
    if len(ordered) < len(joints):
        done = {joint.name for joint in ordered}
        left = next(joint for joint in joints if joint.name not in done)
        raise ModelError(f"joint {left.name!r}", "is part of a loop, or moves on one: its parent "
                         f"{left.parent!r} is moved by {joints[moved_by[left.parent]].name!r}")
    return tuple(ordered)


def _unused(name: str, joints: Sequence[Joint]) -> str:
    names = {joint.name for joint in joints}
    while name in names:
        name += "_"
    return name


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
    """Returns (the leader at the end of each follower's chain, the faults of the others).

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
