"""The kick of the default integrator (drift, kick, drift), and the number of parts of split steps.

For half a step the coordinates move with the initial velocities v0, to q_m.  Then the velocities
change at once, at q_m, and the coordinates move on with the new ones, v1 = v0 + h a:

    q_m = q0 ⊕ h/2 v0,   M(q_m) a = f(q_m, (v0 + v1)/2, t + h/2),   q1 = q_m ⊕ h/2 v1.

The kick is solved in two passes: a' with the forces at v0, then a with those at v0 + h/2 a'.  Both
are implicit in the damping d and stiffness k of the effects, taken at v0: with z = h d/inertia and
θ = (1 + z)/(2 + z), forces act as at the time θ h, which adds θ (h d + h² k/2) to the inertia and
-(θ - ½) h k v0 to the torques.  So a damped velocity shrinks by 1/(1 + z + z²/2) for any z, and
undamped springs keep ½ v·M v + ½ q·K q.  Of second order.  The rows of closed loops reflect v,
E (v0 + v1) = 0, in a third pass.

States of effects, the end of q, move at q_m: x_m = x0 + h/2 x'(v0) before the kick, whose forces
are those at x_m, then x1 = x_m + h/2 x'(v1), put within their bounds.  The kick also changes the
speeds of rotors behind elastic gears, and what follows with a lag follows the demand at
(v0 + v1)/2: by h/2 for the kick, by h in all.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number, add, less, scaled, sqrt, where
from coscrew_codegen.dynamics.algorithms import forward
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.contacts.bouncing import Touching, touching
from coscrew_codegen.dynamics.forces.acted_coordinates import SUM, acted_coordinates, weights_of
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.dynamics.forces.rotors import Eliminated
from coscrew_codegen.dynamics.forces.soft_rows import Weights
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.dynamics.loops.demands import reflection
from coscrew_codegen.program import NotANumber
from coscrew_codegen.scene.contacts.closeness import Contact
from coscrew_codegen.scene.effect import CoordinateState, required
from coscrew_codegen.scene.effect_quantities import places_of
from coscrew_codegen.scene.functions.steps.step_parts import MOST
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.mechanism.loop import WeightedCoordinate
from coscrew_codegen.scene.scene import Applied
from coscrew_codegen.scene.situation import carries, has_contacts

FINE = 12
"""A step is split into parts of length s such that ω s <= 1/FINE, ω the contact's frequency at its
deepest point.  There the implicit midpoint rule, to which an elastic kick reduces, has an energy
error of s²/24 ∫ v² d³V/dq³ dq = 5/72 (ω s)², relative to the bounce's: 0.0005, half of the limit in
`check`. At the end of the bounce it is far less."""


def weights(h: Number) -> Weights:
    """(inertia, torque per velocity) that represent a damping d and a stiffness k in a step h; the
    rate is d over the inertia that it acts on, or d if that is given.

    Of forces on bodies, z also has h² k/inertia: stiff contacts are damped instead of thrown."""
    def represented(d: Number, k: Number, rate: Number, stiffening: Number | int = 0,
                    inertia: Number | int = 1) -> tuple[Number, Number]:
        beyond = _beyond(h, rate + h * stiffening, inertia)
        return (beyond + Fraction(1, 2)) * (h * (d + h * k / 2)), beyond * (h * k)
    return represented


def end_weights(h: Number) -> Weights:
    """(inertia, torque per velocity) for forces at the end of a step h."""
    return lambda d, k, *_: ((d + k * h) * h, k * h)


def _beyond(h: Number, rate: Number, inertia: Number | int = 1) -> Number:
    """θ - ½ for a rate over an inertia, correct also for an infinite rate."""
    return Fraction(1, 2) - inertia / (2 * inertia + h * rate)


def kick(x: FunctionRecording) -> tuple[list[Number], list[Number]]:
    """a of the kick at q, over a step of h, and q with effects' states at its end."""
    recorder = x.recorder
    h, = recorder.argument("h")
    v = recorder.argument("v")
    q, carried = _drifted(x, recorder.argument("q"), v, _rounded_before), carries(x.scene)
    first = x.motion(at=(q, v), carried=carried)
    start = AppliedEffects(x.scene, first, over=h / 2).act()
    kicked = forward.implicit(first, start, x.rigids, x.inertias, weights(h), x.tau)
    demand = reflection(x, first, h) if x.scene.model.loops else None
    a, later = kicked.a, delays(x, h, kicked.rates)
    for _ in range(2 if demand else 1):
        a = demand.met(a, kicked.inverse).a if demand else a
        again = x.motion(at=(_turned(x, q, a, kicked.rotors, h / 2),
                             _sum(v, scaled(h / 2, a))),
                         carried=carried)
        acting = AppliedEffects(x.scene, again, later, h / 2, _later(x, h, kicked)).act()
        slopes = start.with_later(acting)
        kicked = forward.implicit(again, acting, x.rigids, x.inertias, weights(h), x.tau, slopes)
        a = kicked.a
    a = demand.met(a, kicked.inverse).a if demand else a
    return a, _moved(x, acting, q, v, a, kicked.rotors)


def _moved(x: FunctionRecording, acting: AppliedEffects, q: Sequence[Number], v: Sequence[Number],
           a: Sequence[Number], rotors: Mapping[int, Eliminated]) -> list[Number]:
    """q with the effects' states after the kick and h/2 more, within their bounds."""
    h, = x.recorder.argument("h")
    if any(own.lagging for own in acting.states):
        amid = _turned(x, q, a, rotors, h / 2), _sum(v, scaled(h / 2, a))
        states = AppliedEffects(x.scene, x.motion(at=amid)).act().states
        followed = (y for own in states for y in own.followed(h))
        q = [*q[:x.tree.nq], *(new if own.lagging else old for own, old, new in zip(
            (own for own in states for _ in own.x), q[x.tree.nq:], followed, strict=True))]
    return _kept(x, _turned(x, q, a, rotors, h), _sum(v, scaled(h, a)))


def _turned(x: FunctionRecording, q: Sequence[Number], a: Sequence[Number],
            rotors: Mapping[int, Eliminated], time: Number) -> list[Number]:
    """q with the speeds of rotors after a time at the accelerations of the kick."""
    results, places = list(q), places_of(x.scene)
    for applied in x.scene.effects:
        if applied.effect.elastic:
            k, place = x.tree.link_of(applied.on).v.start, x.tree.nq + places[applied.name].stop - 1
            with x.recorder.part("x", heading="states of effects"):
                results[place] = results[place] + time * rotors[k].acceleration(a[k])
    return results


def _rounded_before(x: Number, step: Number) -> Number:
    """The rounding of a step that led to x: all numbers near x have the same spacing."""
    return x - (x - step) - step


def _rounded_after(x: Number, step: Number) -> Number:
    """The rounding of a step from x."""
    return x + step - x - step


def _drifted(x: FunctionRecording, q: Sequence[Number], v: Sequence[Number],
             rounded: Callable[[Number, Number], Number]) -> list[Number]:
    """q with the effects' states moved by h/2 x', bristles also by the rounding of coordinates.

    By h/2 v alone they would part from the bodies that they hold, which creep in single precision:
    where a joint rests between two numbers, each step is rounded alike."""
    nq, (h,) = x.tree.nq, x.recorder.argument("h")
    if len(q) == nq:
        return list(q)
    errors = list(x.recorder.numbers([0] * x.tree.nv))
    for link in x.tree.links:
        if not (link.driver or link.joint.kind.manifold):
            errors[link.v.start:link.v.stop] = map(
                rounded, q[link.q.start:link.q.stop], scaled(h / 2, v[link.v.start:link.v.stop]))
    states, off = (AppliedEffects(x.scene, x.motion(at=(q, y))).act().states for y in (v, errors))
    with x.recorder.part("x", heading="states of effects"):
        return [*q[:nq], *(y for own, by in zip(states, off, strict=True)
                           for y in own.drifted(h / 2, by.law.rates))]


def _kept(x: FunctionRecording, q: Sequence[Number], v: Sequence[Number]) -> list[Number]:
    """q with the effects' states moved by h/2 x' and put within their bounds."""
    if len(q) == x.tree.nq:
        return list(q)
    moved = _drifted(x, q, v, _rounded_after)
    states = AppliedEffects(x.scene, x.motion(at=(moved, v))).act().states
    return [*q[:x.tree.nq], *(y for own in states for y in own.kept)]


def delays(x: FunctionRecording, h: Number, rates: Sequence[Number]) -> dict[int, Number]:
    """(θ - ½) h of each joint: effects act as at the time θ h, as do damping and stiffness."""
    results = {}
    for number, link in enumerate(x.tree.links):
        own = x.tree.links[link.driver.link] if link.driver else link
        if not (rate := rates[own.v.start]).is_zero:
            with x.recorder.part(x.names[number], "own", link.heading):
                results[number] = h * _beyond(h, rate)
    return results


def _later(x: FunctionRecording, h: Number, kicked: forward.Implicit) -> dict[int, Number]:
    """The delays of motors that drive rotors, likewise, by the joint's link."""
    results = {}
    for number, link in enumerate(x.tree.links):
        rotor = None if link.driver else kicked.rotors.get(link.v.start)
        if rotor and not rotor.rate.is_zero:
            with x.recorder.part(x.names[number], "own", link.heading):
                results[number] = h * _beyond(h, rotor.rate)
    return results


def _touching(x: FunctionRecording) -> Iterable[Touching]:
    return touching(x) if has_contacts(x.scene) else ()


def closing(x: FunctionRecording) -> Number:
    """The number of contacts, of joints and bodies, that are closed now or will be after h at the
    velocity v."""
    count = x.recorder.number(0)
    every: list[_Closing | Touching] = [*_contacts(x), *_touching(x)]
    for contact in every:
        with contact.part():
            count = count + where(less(count.like(0), contact.depths), 1, 0)
    return count


def split(x: FunctionRecording) -> tuple[Number, Number]:
    """(n, h/n) with n = 2^j >= FINE h ω parts of a step h; h/n is NaN if n exceeds MOST.

    A contact gets as deep as δ_p = (δ^2.5 + 1.25 m v²/k)^0.4, where the joint moves the inertia m,
    and there ω² = 1.5 k √δ_p/m.  Several closed contacts together have at most their number times
    the largest ω².  Fifth roots are avoided: (FINE h ω)^5 is compared with 32^j."""
    recorder = x.recorder
    (h,), motion = recorder.argument("h"), x.motion(accelerating=False)
    number, worst = closing(x), recorder.number(0)
    for contact in _contacts(x):
        before, v = contact.before, contact.v
        with contact.part():
            mobility = forward.inverse_inertia(motion, x.rigids, x.inertias, contact.unit(motion))
            deepest = _power(before.depth, 2) * sqrt(before.depth)
            deepest = deepest + v * v * Fraction(5, 4) / (mobility * before.k)
            rate = h * h * before.k * mobility * number * Fraction(3 * FINE**2, 2)
            fifth = _power(rate, 2) * sqrt(rate * deepest)
            fifth = where(less(fifth.like(0), contact.depths), fifth, 0)
            worst = where(less(worst, fifth), fifth, worst)
    for body in _touching(x):
        with body.part():
            fifth = where(less(number.like(0), body.depths), body.fifth_power(number), 0)
            worst = where(less(worst, fifth), fifth, worst)
    with recorder.part("parts", heading="parts of the step"):
        parts, n = recorder.number(1), 1
        while n < MOST:
            parts, n = where(less(recorder.number(n**5), worst), 2 * n, parts), 2 * n
        too_many = less(recorder.number(MOST**5), worst)
        return parts, h / where(too_many, Number(recorder, NotANumber()), parts)


@dataclass(frozen=True)
class _Closing:
    """A contact now and after h at the velocity v along its coordinate."""

    x: FunctionRecording
    applied: Applied
    link: int
    v: Number
    before: Contact
    after: Contact
    weights: Mapping[int, Number | Fraction]  # of a sum, by velocity

    @property
    def depths(self) -> Number:
        """The sum of both depths: above zero if it is closed or closes."""
        return self.before.depth + self.after.depth

    def part(self) -> AbstractContextManager[None]:
        """Names instructions after the joint's link, or the sum."""
        return _part(self.x, self.applied, self.link)

    def unit(self, motion: Motion) -> list[Number]:
        """The torques of a torque of 1 along its coordinate."""
        return forward.row(motion, self.weights or weights_of(motion.tree, (
            WeightedCoordinate(self.applied.on, 0, Fraction(1)),)))


def _part(x: FunctionRecording, applied: Applied, link: int) -> AbstractContextManager[None]:
    if link == SUM:
        owner, = identifiers([applied.label or applied.on])
        return x.recorder.part(owner, "own", "sums of coordinates")
    return x.recorder.part(x.names[link], "own", x.tree.links[link].heading)


def _contacts(x: FunctionRecording) -> Iterator[_Closing]:
    """The contacts of joints and sums."""
    motion, zero = x.motion(accelerating=False), x.recorder.number(0)
    for applied in x.scene.effects:
        if applied.effect.joint_torque:
            law, at = applied.effect.joint_torque, acted_coordinates(motion, applied)[0]
            with _part(x, applied, at.link):
                values = settings(x.recorder, at.values, zero)
                own = motion.states(applied.name)
                before = law(CoordinateState(at.q, at.v, zero, x=own), values).contact
                if before:
                    h, = x.recorder.argument("h")
                    after = law(CoordinateState(at.q + h * at.v, at.v, zero, x=own), values)
                    yield _Closing(x, applied, at.link, at.v, before, required(after.contact),
                                   at.weights)


def _power(x: Number, n: int) -> Number:
    return x if n == 1 else x * _power(x, n - 1)


def _sum(v: Sequence[Number], change: Sequence[Number]) -> list[Number]:
    with v[0].recorder.part("speeds", heading="speeds"):
        return list(add(v, change))
