"""Inverse dynamics: the torques of a motion, by Newton and Euler's equations link by link (RNEA).

Outwards the motion, inwards the wrenches that joints transmit; a joint's torque is their part along
its axis.
"""

from collections.abc import Mapping, Sequence

from coscrew_codegen.mechanics.acting import Acting
from coscrew_codegen.mechanics.bodies import Rigid, net_force
from coscrew_codegen.mechanics.motion import Motion
from coscrew_codegen.recording.numbers import Number, Vector, add, cross, dot, rotated, subtract
from coscrew_codegen.scene.model import Kind

Wrench = tuple[Vector, Vector]  # force, moment about the link's origin; in the link's frame


def net_wrenches(motion: Motion, rigids: Sequence[Rigid], acting: Acting | None) -> list[Wrench]:
    """What gives each link its motion, less what effects supply of it."""
    wrenches: list[Wrench] = []
    for number, rigid in enumerate(rigids):
        with motion.recorder.part(f"{motion.names[number]}_net", motion.tree.links[number].name):
            wrench = motion.zero, motion.zero
            if not rigid.vanishes:
                wrench = net_force(rigid, motion.curl(number), motion.acceleration(number))
            if acting:
                wrench = tuple(map(subtract, wrench, acting.force(number)))
        wrenches.append(wrench)
    return wrenches


def transmitted(motion: Motion, wrenches: Sequence[Wrench]) -> list[Wrench]:
    """The wrench each joint transmits: that of its link and of all beyond."""
    total = list(wrenches)
    for number in reversed(range(len(total))):
        link = motion.tree.links[number]
        if link.parent >= 0:
            with motion.recorder.part(f"{motion.names[number]}_handed", link.name):
                total[link.parent] = tuple(map(add, total[link.parent],
                                               handed_on(motion, number, total[number])))
    return total


def handed_on(motion: Motion, number: int, wrench: Wrench) -> Wrench:
    """[Ad]*(D) c: a wrench in the parent's frame."""
    R, t = motion.frame(number)
    force = rotated(R, wrench[0])
    return force, add(rotated(R, wrench[1]), cross(t, force))


def along(motion: Motion, number: int, wrench: Wrench) -> tuple[Number, ...]:
    """h·c: the part of a wrench along each of the joint's freedoms."""
    link = motion.tree.links[number]
    if link.joint.kind is Kind.FREE:
        return (*wrench[0], *wrench[1])
    if link.joint.kind is Kind.SPHERICAL:
        return wrench[1]
    part = wrench[0] if link.joint.kind is Kind.PRISMATIC else wrench[1]
    return (dot(motion.axis(link), part),)


def joint_torques(motion: Motion, wrenches: Sequence[Wrench], acting: Acting | None,
                  inertias: Mapping[str, Number]) -> list[Number]:
    """One torque a speed: the joint's part of the wrench, its own inertia's, less the effects';
    followers' go to what they follow."""
    torques = [motion.recorder.number(0)] * motion.tree.nv
    for number, link in enumerate(motion.tree.links):
        with motion.recorder.part(f"{motion.names[number]}_torque", link.name):
            parts = list(along(motion, number, wrenches[number]))
            if link.joint.name in inertias:
                parts[0] = parts[0] + inertias[link.joint.name] * motion.accelerations(number)[0]
            if acting and number in acting.torques:
                parts[0] = parts[0] - acting.torque(number)
            gather(motion, number, parts, torques)
    return torques


def gather(motion: Motion, number: int, parts: Sequence[Number], total: list[Number]) -> None:
    """Adds the parts of a joint's freedoms to those of the speeds they belong to."""
    link = motion.tree.links[number]
    start = link.v.start
    if link.driver:
        parts = [x * link.driver.multiplier for x in parts]
        start = motion.tree.links[link.driver.link].v.start
    for offset, part in enumerate(parts):
        total[start + offset] = total[start + offset] + part
