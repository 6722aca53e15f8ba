"""Inverse dynamics: the torques of a motion, by the recursive Newton–Euler algorithm (RNEA).

Outwards the motion of links, inwards the wrenches that joints transmit; a joint's torque is the
component of its wrench along its axis.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from coscrew_codegen.algebra.recording.numbers import Number, add, angular, dot, linear, subtract
from coscrew_codegen.dynamics.algorithms.bodies import Rigid, rigids
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.forces.own_inertias import OwnInertias

if TYPE_CHECKING:
    from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects

Wrench = tuple[Number, ...]  # force; moment about the link's origin, in the link's frame


def net_wrenches(motion: Motion, bodies: Sequence[Rigid], acting: "AppliedEffects | None"
                 ) -> list[Wrench]:
    """The net wrench of each link's motion, less the forces of effects."""
    wrenches: list[Wrench] = []
    for number, rigid in enumerate(bodies):
        if not rigid.vanishes:
            motion.acceleration_tensor(number)  # first, so that its instructions have its name
        with motion.part(number, "f"):
            wrench = (*motion.zero, *motion.zero)
            if not rigid.vanishes:
                acceleration = *motion.acceleration(number), *motion.angular_acceleration(number)
                wrench = motion.recorder.call("spatial_inertia_net_wrench", rigid.numbers,
                                              motion.angular_velocity(number), acceleration)
            if acting:
                wrench = subtract(wrench, acting.force(number))
            label(motion, "f", "m", wrench)
        wrenches.append(wrench)
    return wrenches


def label(motion: Motion, force: str, moment: str, wrench: Wrench) -> None:
    """Name a wrench of the part's link."""
    motion.recorder.label(force, linear(wrench))
    motion.recorder.label(moment, angular(wrench))


def transmitted(motion: Motion, wrenches: Sequence[Wrench],
                symbols: tuple[str, str] = ("fj", "mj")) -> list[Wrench]:
    """The wrench that each joint transmits: the sum for its link and all beyond, in its frame."""
    total = list(wrenches)
    for number in reversed(range(len(total))):
        parent = motion.tree.links[number].parent
        if parent >= 0:
            in_parent = to_parent(motion, number, total[number])
            with motion.part(parent, symbols[0]):
                total[parent] = add(total[parent], in_parent)
                label(motion, *symbols, total[parent])
    return total


def to_parent(motion: Motion, number: int, wrench: Wrench) -> Wrench:
    """[Ad]*(D) c: a wrench in the parent's frame."""
    with motion.part(number, "fp"):
        result = motion.recorder.call("product_CoAdc", motion.frame(number), wrench)
        label(motion, "fp", "mp", result)
    return result


def along(motion: Motion, number: int, wrench: Wrench) -> tuple[Number, ...]:
    """s·c: the components of a wrench along the joint's freedoms."""
    return tuple(dot(linear(s), linear(wrench)) + dot(angular(s), angular(wrench))
                 for s in motion.subspace(number))


def joint_torques(motion: Motion, wrenches: Sequence[Wrench], acting: "AppliedEffects | None",
                  inertias: OwnInertias) -> list[Number]:
    """A torque per velocity: the wrench along the freedom, plus the torque of the joint's own
    inertia, less the torques of effects; torques of followers are added to those of their leaders.
    """
    torques = [motion.recorder.number(0)] * motion.tree.nv
    for number, link in enumerate(motion.tree.links):
        with motion.part(number, "tau"):
            parts = list(along(motion, number, wrenches[number]))
            if link.joint.name in inertias:
                own = inertias[link.joint.name]
                for k, a in enumerate(motion.accelerations(number)):
                    parts[k] = parts[k] + own * a
                for k, torque in enumerate(own_bias(motion, number, own)):
                    parts[k] = parts[k] + torque
            if acting and number in acting.torques:
                parts = list(subtract(parts, acting.torque(number)))
            gather(motion, number, parts, torques)
    torques = inertias.with_sums(torques, motion.a)
    return acting.with_sums(torques, -1) if acting else torques


def own_bias(motion: Motion, number: int, inertia: Number) -> list[Number]:
    """The torques that a joint's own inertia takes at a = 0, by velocity; [] if they are zero."""
    manifold = motion.tree.links[number].joint.kind.manifold
    inertial = manifold.inertial if manifold else None
    return [inertia * x for x in inertial(motion.speeds(number))] if inertial else []


def holding_torques(motion: Motion) -> list[Number]:
    """The torques that hold the model still against gravity at the motion's q."""
    still = motion.at_rest()
    wrenches = net_wrenches(still, rigids(motion.recorder, motion.names, motion.tree), None)
    return joint_torques(still, transmitted(still, wrenches), None, OwnInertias())


def gather(motion: Motion, number: int, parts: Sequence[Number], total: list[Number]) -> None:
    """Adds torques along a joint's freedoms to the torques of the velocities that drive these
    freedoms."""
    link = motion.tree.links[number]
    start = link.v.start
    if link.driver:
        parts = [x * link.driver.multiplier for x in parts]
        start = motion.tree.links[link.driver.link].v.start
    for offset, part in enumerate(parts):
        total[start + offset] = total[start + offset] + part
