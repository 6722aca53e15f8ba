"""Energies and momentum of a scene's links."""

from coscrew_codegen.mechanics.bodies import kinetic_energy
from coscrew_codegen.mechanics.motion import Motion
from coscrew_codegen.mechanics.recorded import Recording
from coscrew_codegen.recording.numbers import Number, add, cross, dot, rotated, scaled


def kinetic(x: Recording, motion: Motion) -> Number:
    """Σ (m v·v)/2 + v·(ω × h) + (ω·I ω)/2, and of joints' own inertias I v²/2."""
    total = x.recorder.number(0)
    for number, (rigid, link) in enumerate(zip(x.rigids, x.tree.links, strict=True)):
        with x.recorder.part(f"{x.names[number]}_kinetic", link.name):
            if not rigid.vanishes:
                total = total + kinetic_energy(rigid, motion.velocity(number),
                                               motion.turning(number))
            if link.joint.name in x.inertias:
                v = motion.speeds(number)[0]
                total = total + x.inertias[link.joint.name] * (v * v) / 2
    return total


def potential(x: Recording, motion: Motion) -> Number:
    """-Σ g·(m t + R h)."""
    total = x.recorder.number(0)
    for number, (rigid, link) in enumerate(zip(x.rigids, x.tree.links, strict=True)):
        with x.recorder.part(f"{x.names[number]}_potential", link.name):
            R, t = motion.pose(number)
            moment = add(scaled(rigid.m, t), rotated(R, rigid.h))
            total = total - dot(motion.gravity, moment)
    return total


def momentum(x: Recording, motion: Motion) -> tuple[Number, ...]:
    """Σ [Ad]*(D) B s: of all links in the world's frame."""
    total = (*motion.zero, *motion.zero)
    for number, rigid in enumerate(x.rigids):
        with x.recorder.part(f"{x.names[number]}_momentum", x.tree.links[number].name):
            screw = (*motion.velocity(number), *motion.turning(number))
            own = x.recorder.call("product_Bs", rigid.numbers, screw)
            R, t = motion.pose(number)
            force = rotated(R, tuple(own[:3]))
            total = add(total, (*force, *add(rotated(R, tuple(own[3:])), cross(t, force))))
    return total
