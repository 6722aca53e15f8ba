"""Energies and momentum of a scene's links."""

from coscrew_codegen.algebra.recording.numbers import Number, add, angular, dot, linear
from coscrew_codegen.dynamics.algorithms import crba, rnea
from coscrew_codegen.dynamics.algorithms.aba import Articulated
from coscrew_codegen.dynamics.algorithms.motion import Motion, Twist
from coscrew_codegen.dynamics.function_recording import FunctionRecording


def kinetic(x: FunctionRecording, motion: Motion) -> Number:
    """Σ s·B s / 2 + Σ I v²/2, with the joints' own inertias I."""
    total = x.recorder.number(0)
    for number, (rigid, link) in enumerate(zip(x.rigids, x.tree.links, strict=True)):
        with motion.part(number, "T"):
            if not rigid.vanishes:
                (own,) = x.recorder.call("spatial_inertia_energy", rigid.numbers,
                                         motion.twist(number))
                total = total + own
            if rigid.added:
                total = total + of_inertia(Articulated(rigid.added), motion.twist(number))
            if link.joint.name in x.inertias:
                for v in motion.speeds(number):
                    total = total + x.inertias[link.joint.name] * (v * v) / 2
    return x.inertias.energy(motion.v, total)


def of_inertia(M: Articulated, twist: Twist) -> Number:
    """V·M V / 2."""
    momentum = M.times(twist)
    return dot(linear(momentum), linear(twist)) / 2 + dot(angular(momentum), angular(twist)) / 2


def potential(x: FunctionRecording, motion: Motion) -> Number:
    """-g·h, with the first moment h of all links in the world's frame."""
    total = x.recorder.number(0)
    bodies = crba.composites(motion, x.rigids)
    for number, link in enumerate(x.tree.links):
        if link.parent < 0:
            with motion.part(number, "V"):
                moved = x.recorder.call("spatial_inertia_transformed", motion.frame(number),
                                        bodies[number].numbers)
                total = total - dot(motion.gravity, moved[1:4])
    return total


def momenta(x: FunctionRecording, motion: Motion, added: bool = False) -> list[rnea.Wrench]:
    """(p; L) of each link and all beyond it, in its frame: B s + Σ [Ad]* (p; L) of its children;
    `added`: with that of the inertia that effects add."""
    results = []
    for number, rigid in enumerate(x.rigids):
        with motion.part(number, "p"):
            own = x.recorder.call("product_Bs", rigid.numbers, motion.twist(number))
            if added and rigid.added:
                own = add(own, Articulated(rigid.added).times(motion.twist(number)))
            rnea.label(motion, "p", "L", own)
            results.append(own)
    return rnea.transmitted(motion, results, ("pj", "Lj"))


def momentum(x: FunctionRecording, motion: Motion) -> tuple[Number, ...]:
    """Σ [Ad]*(D) B s over all links, in the world's frame."""
    total = (*motion.zero, *motion.zero)
    for number, own in enumerate(momenta(x, motion)):
        if x.tree.links[number].parent < 0:
            total = add(total, rnea.to_parent(motion, number, own))
    return total
