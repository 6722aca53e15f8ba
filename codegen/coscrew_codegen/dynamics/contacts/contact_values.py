"""Points, forces and depths of all contacts of bodies, in the order of the scene's effects."""

from collections.abc import Iterator
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    dot,
    maximum,
    scaled,
    sqrt,
    subtract,
)
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.scene.contacts.closeness import BodyContact
from coscrew_codegen.scene.effect import required

_LEAST = Fraction(1, 10**30)
"""N: instead of a force of zero, so that there is no 0/0."""


def contact_values(motion: Motion, acting: AppliedEffects
                   ) -> tuple[list[Number], ...]:
    """The point of each contact and the force there on its (first) body, in the world's frame; the
    depth over the one at rest; the share of mu N that friction takes, 1 where it slips; and the
    normal."""
    points: list[Number] = []
    forces: list[Number] = []
    depths: list[Number] = []
    shares: list[Number] = []
    normals: list[Number] = []
    for point, force, n, contact, mu in _contacts(motion, acting):
        N = dot(force, n)
        friction = subtract(force, scaled(N, n))
        points += point
        forces += force
        normals += n
        depths.append(maximum(-contact.gap, 0) / contact.resting)
        shares.append(sqrt(dot(friction, friction)) / maximum(mu * N, _LEAST))
    return points, forces, depths, shares, normals


def _contacts(motion: Motion, acting: AppliedEffects
              ) -> Iterator[tuple[Vector, Vector, Vector, BodyContact, Number]]:
    """Point, force and normal in the world's frame, the contact, mu."""
    forces = {link: iter([x for x in own if x.force.contact])
              for link, own in acting.forces.items()}
    touches = iter(acting.touches)
    for applied in acting.scene.effects:
        effect = applied.effect
        if effect.parts or effect.bodies_force:
            mu = settings(motion.recorder, {"mu": applied.values["mu"]}, acting.t)["mu"]
        if effect.parts:
            x = next(forces[motion.tree.link_and_body(applied.on)[0]])
            state, force = x.state, x.force
            n = state.world_direction(required(x.normal))
            yield (state.world_position(required(force.point)),
                   state.world_direction(required(force.force)), n, required(force.contact), mu)
        elif effect.bodies_force:
            touch = next(touches)
            between, first = touch.between, touch.states[0]
            yield (first.world_position(between.places[0]), between.law.force, between.n,
                   between.law.contact, mu)
