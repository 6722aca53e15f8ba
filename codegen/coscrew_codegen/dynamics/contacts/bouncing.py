"""Contacts of bodies, as far as they decide on the parts of a step.

A contact that bounces has ω² = 1.5 k √δ_p/m · f, with the depth that it reaches,
δ_p^2.5 = δ^2.5 + 1.25 m u²/k, and the share of the motion that bounces,

    f = (1.25 m u²/k + max(δ^2.5 - (2 δ_r)^2.5, 0))/δ_p^2.5:

1 when it closes, 0 at rest at the depth δ_r, so that what stands takes whole steps."""

from collections.abc import Iterator
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number, maximum, minimum, sqrt
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.scene.contacts.closeness import BodyContact
from coscrew_codegen.scene.functions.steps.step_parts import MOST_OF_CONTACTS

FINE = 8
"""A step is split into parts of length s such that ω s <= 1/FINE; then a bounce loses at most 0.2 %
of its energy by the steps."""
_LEAST = Fraction(1, 10**30)


@dataclass(frozen=True)
class Touching:
    """A contact of a body."""

    x: FunctionRecording
    links: tuple[int, ...]
    contact: BodyContact

    @property
    def link(self) -> int:
        """The first link that moves."""
        return next(k for k in self.links if k >= 0)

    @property
    def mass(self) -> Number:
        """The mass of the link, or the reduced mass of two links."""
        first, *others = [maximum(self.x.rigids[k].m, _LEAST) for k in self.links if k >= 0]
        return first if not others else first * others[0] / (first + others[0])

    def part(self) -> AbstractContextManager[None]:
        """Names instructions after the body's link."""
        return self.x.recorder.part(self.x.names[self.link], "own", self.x.tree.links[
            self.link].heading)

    @property
    def depths(self) -> Number:
        """The sum of the depths now and after h at the gap's rate: above zero if it is closed or
        closes."""
        h, = self.x.recorder.argument("h")
        gap, rise = self.contact.gap, self.contact.rise
        return maximum(-gap, 0) + maximum(-(gap + h * rise), 0)

    def fifth_power(self, number: Number) -> Number:
        """(FINE h ω)^5, at most MOST_OF_CONTACTS^5, of one of `number` contacts."""
        h, = self.x.recorder.argument("h")
        k, m = self.contact.k, self.mass
        hertz = _hertz(maximum(-self.contact.gap, 0))
        rise = self.contact.rise * self.contact.rise * m * Fraction(5, 4) / k
        bouncing = rise + maximum(hertz - _hertz(self.contact.resting * 2), 0)
        rate = h * h * k / m * number * Fraction(3 * FINE**2, 2) * bouncing
        share = rate / maximum(hertz + rise, _LEAST)
        return minimum(share * share * sqrt(rate), MOST_OF_CONTACTS**5)


def _hertz(depth: Number) -> Number:
    """δ^2.5."""
    return depth * depth * sqrt(depth)


def touching(x: FunctionRecording) -> Iterator[Touching]:
    """The contacts of bodies."""
    own = [y for y in x.scene.effects if y.effect.parts or y.effect.ground or y.effect.bodies_force]
    acting = AppliedEffects(replace(x.scene, effects=tuple(own)), x.motion(accelerating=False))
    for touch in acting.act().touches:
        yield Touching(x, tuple(state.link for state in touch.states), touch.between.law.contact)
    for link, forces in sorted(acting.forces.items()):
        for force in forces:
            if force.force.contact:
                yield Touching(x, (link,), force.force.contact)
