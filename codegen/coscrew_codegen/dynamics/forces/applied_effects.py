"""Applies the effects of a scene to a motion: torques at joints, forces on links, energies, powers.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from copy import copy
from dataclasses import replace
from functools import cached_property, partial
from operator import mul

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    displacement,
    dot,
    maximum,
    negative,
    scaled,
    sqrt,
    subtract,
)
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.algorithms.aba import Articulated
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.algorithms.rnea import holding_torques
from coscrew_codegen.dynamics.forces.acted_coordinates import (
    SUM,
    ActedCoordinate,
    acted_coordinates,
)
from coscrew_codegen.dynamics.forces.added_inertia import (
    Stream,
    inertia_in_link,
    power_of_stream,
    wrench,
)
from coscrew_codegen.dynamics.forces.body_motion import BodyOfLink, Ground
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.dynamics.forces.exerted_forces import (
    CLOSEST,
    AppliedForce,
    Paired,
    Summed,
    Touch,
)
from coscrew_codegen.dynamics.forces.linearization import JointEffect, Law, own_power
from coscrew_codegen.dynamics.forces.moving_states import MovingStates
from coscrew_codegen.dynamics.forces.own_inertias import owner
from coscrew_codegen.dynamics.forces.potentials import body_force
from coscrew_codegen.dynamics.forces.rotors import Rotor
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.scene.effect import (
    FIRST,
    SECOND,
    Between,
    CoordinateState,
    Effect,
    Force,
    TwoBodies,
    Values,
    required,
)
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.scene import Applied, Scene


class AppliedEffects:
    """The effects of a scene on one motion, at its time; each is evaluated once.

    At the joints of the links in `delays` the delay is added to the time, and for motors that drive
    a rotor there that in `of_rotors`.  Torques with a lag have
    followed their demands for the time `over`."""

    def __init__(self, scene: Scene, motion: Motion, delays: Mapping[int, Number] | None = None,
                 over: Number | None = None, of_rotors: Mapping[int, Number] | None = None):
        self.scene, self.motion, self._over = scene, motion, over
        self._of_rotors = of_rotors or {}
        recorder = motion.recorder
        self.recorder = recorder
        self.t = recorder.argument("t")[0] if recorder.has("t") else recorder.number(0)
        self.delays = delays or {}
        self.torques: dict[int, list[JointEffect]] = {}
        self.forces: dict[int, list[AppliedForce]] = {}
        self.pairs: list[Paired] = []
        self.touches: list[Touch] = []
        self.sums: list[Summed] = []
        self.states: list[MovingStates] = []
        self.rotors: dict[int, Rotor] = {}
        self._geared = {x.on: x for x in scene.effects if x.effect.elastic}
        self.inertias: dict[int, list[Articulated]] = {}

    def act(self) -> "AppliedEffects":
        """Evaluates the effects, in the order of the catalogue and of the scene."""
        effects = self.scene.effects
        owners = identifiers([owner(x) for x in effects])
        for prefix, applied in zip(owners, effects, strict=True):
            at = f" at {applied.on}" if applied.on else ""
            with self.recorder.part(prefix, heading=f"{applied.effect.name}{at}"):
                self._apply(applied.effect, applied)
        return self

    def _apply(self, effect: Effect, applied: Applied) -> None:
        if effect.joint_torque:
            for x in acted_coordinates(self.motion, applied):
                self._act_along(effect.joint_torque, x, applied)
        if effect.body_force:
            state = replace(self._body(applied.on), x=self.motion.states(applied.name))
            self._add(state, body_force(effect.body_force, state, applied.values))
            if state.x:
                self._note(applied, MovingStates(state.x, self.forces[state.link][-1].force))
        if effect.pair_force:
            pair = self._pair(effect.pair_force, applied)
            for state, force in zip(pair.states, pair.forces, strict=True):
                self._add(state, force, mutual=True)
            self.pairs.append(pair)
        if effect.bodies_force:
            self._touch(effect.bodies_force, applied)
        if effect.body_inertia:
            link, inertia = inertia_in_link(applied, self.recorder, self.motion.tree)
            if not inertia.is_zero:
                self.inertias.setdefault(link, []).append(inertia)

    def _act_along(self, law: Law, x: ActedCoordinate, applied: Applied) -> None:
        effect = applied.effect
        behind = self._geared.get(applied.on) if effect.drives and not applied.terms else None
        q, v = self.motion.states(behind.name) if behind else (x.q, x.v)
        delays = self._of_rotors if behind else self.delays
        at = CoordinateState(q, v, self.t + delays.get(x.link, 0),
                             self._holding(x.link, applied), self.motion.states(applied.name))
        along = JointEffect(law, at, x.values, self.recorder.current, x.freedom, over=self._over)
        if behind:
            self._rotor(x.link).motors.append(along)
        elif x.link == SUM:
            self.sums.append(Summed(x.weights, along))
        else:
            self.torques.setdefault(x.link, []).append(along)
        rotor = self._rotor(x.link) if effect.elastic else None
        if rotor:
            rotor.gears.append(along)
        if at.x:
            lagging = None if along.torque.lag is None else along
            self._note(applied, MovingStates(at.x, along.torque, lagging, rotor))

    def _rotor(self, link: int) -> Rotor:
        return self.rotors.setdefault(link, Rotor())

    def _note(self, applied: Applied, own: MovingStates) -> None:
        """Keeps the states of an effect, with their rates and bounds."""
        effect, law, count = applied.effect, own.law, len(own.x)
        for name, of, wanted in (("rates", law.rates, 0 if own.rotor else count),
                                 ("bounded", law.bounded, 0 if law.share is None else count),
                                 ("switches", law.switches, effect.switches)):
            if len(of) != wanted:
                raise TypeError(f"{effect.name} has {wanted} {name}; its law gives {len(of)}")
        self.states.append(own)

    def _holding(self, link: int, applied: Applied) -> Number | None:
        """Returns the torque that holds a joint against gravity, if the effect compensates it."""
        flag = applied.effect.compensates
        if not flag or applied.values[flag] is None:
            return None
        return self._holding_torques[self.motion.tree.links[link].v.start]

    @cached_property
    def _wind(self) -> Vector | None:
        """The velocity of the fluid, in the world's frame; None if it is at rest."""
        for applied in self.scene.effects:
            if applied.effect.wind:
                with self.recorder.part("wind", heading="wind"):
                    return applied.effect.wind(settings(self.recorder, applied.values, self.t))
        return None

    @cached_property
    def _ground(self) -> Ground:
        """The ground: by default the plane z = 0."""
        for applied in self.scene.effects:
            if applied.effect.ground:
                with self.recorder.part("ground", heading="ground"):
                    values = settings(self.recorder, applied.values, self.t)
                    return partial(applied.effect.ground, values)
        up = tuple(self.recorder.numbers((0, 0, 1)))
        return lambda position: (position[2], up)

    @cached_property
    def _stream(self) -> Stream | None:
        """The velocity of the fluid and its rate; None if it is at rest."""
        wind = self._wind
        if wind is None or all(x.is_zero for x in wind):
            return None
        applied = next(x for x in self.scene.effects if x.effect.wind)
        with self.recorder.part("wind", heading="wind"):
            return Stream(wind, _rate(applied, self.t))

    @cached_property
    def _holding_torques(self) -> list[Number]:
        return holding_torques(self.motion)

    def _body(self, name: str) -> BodyOfLink:
        (link, placed), numbers = self.motion.tree.link_and_body(name), self.recorder.numbers
        place = displacement(numbers(placed.placement.R), numbers(placed.placement.t))
        return BodyOfLink(placed.body.inertia, self.t, self.motion, link, place, self._wind,
                          ground=lambda position: self._ground(position))

    def _pair(self, law: Law, applied: Applied) -> Paired:
        first, second = (self._body(name) for name in applied.bodies)
        values = settings(self.recorder, applied.values, self.t)
        a, b = values.vector(FIRST), values.vector(SECOND)
        separation = first.line_to(a, second, b)
        length = sqrt(dot(separation, separation))
        direction = scaled(1 / maximum(length, CLOSEST), separation)
        u = subtract(second.world_direction(second.velocity(b)),
                     first.world_direction(first.velocity(a)))
        at = CoordinateState(length, dot(direction, u), self.t)
        return Paired((first, second), (a, b), direction, u,
                      JointEffect(law, at, applied.values, self.recorder.current))

    def _touch(self, law: Callable[[TwoBodies, Values], Between], applied: Applied) -> None:
        first, second = (self._body(name) for name in applied.bodies)
        two = TwoBodies(first, second, self.motion.states(applied.name),
                        lambda a, b: negative(first.line_to(a, second, b)))
        between = law(two, settings(self.recorder, applied.values, self.t))
        touch = Touch((first, second), between)
        for state, force in zip(touch.states, touch.forces, strict=True):
            self._add(state, force, mutual=True)
        if two.x:
            self._note(applied, MovingStates(two.x, between.law))
        self.touches.append(touch)

    def _add(self, state: BodyOfLink, force: Force, mutual: bool = False) -> None:
        self.forces.setdefault(state.link, []).append(AppliedForce(state, force, mutual))

    def without_rows(self) -> "AppliedEffects":
        """These effects, without forces between bodies and torques on sums of several coordinates.
        """
        result = copy(self)
        result.forces = {link: [x for x in forces if not x.mutual]
                         for link, forces in self.forces.items()}
        result.sums = [x for x in self.sums if len(x.weights) == 1]
        return result

    def with_later(self, later: "AppliedEffects") -> "AppliedEffects":
        """These effects, with the larger damping of both where it starts at once."""
        result = copy(self)
        result.torques = {link: [x.with_later(y) for x, y in zip(
            effects, later.torques[link], strict=True)] for link, effects in self.torques.items()}
        result.rotors = {link: x.with_later(later.rotors[link])
                         for link, x in self.rotors.items()}
        result.sums = [replace(x, along=x.along.with_later(y.along))
                       for x, y in zip(self.sums, later.sums, strict=True)]
        return result

    @property
    def looks_ahead(self) -> bool:
        """True if the damping of an effect depends on later velocities."""
        at_joints = (x for effects in self.torques.values() for x in effects)
        return any(x.looks_ahead for x in (*at_joints, *(x.along for x in self.sums)))

    # results

    def torque(self, link: int) -> list[Number]:
        """The sums of the torques at a link's joint, by velocity."""
        return self._by_velocity(link, lambda x: required(x.torque.torque))

    def damping(self, link: int) -> list[Number]:
        """-∂torque/∂v, or bounds of it."""
        return self._by_velocity(link, lambda x: x.slopes.damping)

    def stiffness(self, link: int) -> list[Number]:
        """-∂torque/∂q, or bounds of it."""
        return self._by_velocity(link, lambda x: x.slopes.stiffness)

    def _by_velocity(self, link: int, of: Callable[[JointEffect], Number]) -> list[Number]:
        x, effects = self.motion.tree.links[link], self.torques.get(link, ())
        return [self._sum(of(effect) for effect in effects if effect.freedom == k)
                for k in range(1 if x.driver else len(x.v))]

    def with_sums(self, torques: Sequence[Number], sign: int = 1) -> list[Number]:
        """Torques by velocity, with those of effects on sums of coordinates added, or subtracted.
        """
        results = list(torques)
        for x in self.sums:
            torque = required(x.along.torque.torque) * sign
            for place, weight in x.weights.items():
                results[place] = results[place] + torque * weight
        return results

    def force(self, link: int) -> tuple[Number, ...]:
        """The sum of the forces on a link: force; moment about its origin, in its frame."""
        total = (*self.motion.zero, *self.motion.zero)
        for x in self.forces.get(link, ()):
            total = add(total, x.on_link)
        for inertia in self.inertias.get(link, ()):
            total = subtract(total, wrench(self.motion, link, inertia, self._stream))
        return total

    def resisting(self, link: int) -> list[AppliedForce]:
        """The forces on a link that have slopes."""
        return [x for x in self.forces.get(link, ()) if x.force.slopes]

    def potential(self) -> Number:
        """The sum of the potential energies of effects."""
        torques = [x.torque.energy for link in sorted(self.torques) for x in self.torques[link]]
        torques += [x.along.torque.energy for x in self.sums]
        forces = [x.force.energy for link in sorted(self.forces) for x in self.forces[link]]
        return self._sum(x for x in (*torques, *forces) if x)

    def power(self) -> Number:
        """The power of the effects without potential energy, in W; negative if dissipated."""
        total = self.recorder.number(0)
        for link in sorted(self.torques):
            speeds = self.motion.speeds(link)
            for x in self.torques[link]:
                torque = x.torque
                total = total + own_power(torque, partial(mul, required(torque.torque),
                                                           speeds[x.freedom]))
        beside = [x.along for x in self.sums]
        beside += [x for link in sorted(self.rotors) for x in self.rotors[link].motors]
        for along in beside:
            at, torque = along.at, along.torque
            total = total + own_power(torque, partial(mul, required(torque.torque), at.v))
        for link in sorted(self.forces):
            for force in self.forces[link]:
                total = total + own_power(force.force, force.power)
        for link, inertias in self.inertias.items() if self._stream else ():
            for inertia in inertias:
                total = total + power_of_stream(self.motion, link, inertia,
                                                required(self._stream))
        return total

    def _sum(self, values: Iterable[Number]) -> Number:
        total = self.recorder.number(0)
        for value in values:
            total = total + value
        return total


def _rate(applied: Applied, t: Number) -> Vector:
    """The rate of wind, a velocity that depends on time alone: the tangent of its Program."""
    outer = t.recorder
    inputs = [array("t", ()), *(a for a in outer.inputs if a.name == "p")]
    recorder = Recorder(inputs)
    wind = required(applied.effect.wind)
    inner = wind(settings(recorder, applied.values, recorder.argument("t")[0]))
    program = recorder.program("wind", [(array("u", (3,)), inner)])
    one = outer.number(1)
    given = [[Dual(x, (one if a.name == "t" else None,)) for x in (
        (t,) if a.name == "t" else outer.argument("p"))] for a in program.inputs]
    slopes = derivatives.along(program, outer, given)
    return tuple(outer.number(0) if x.slopes[0] is None else x.slopes[0] for x in slopes)


def alone(scene: Scene, applied: Applied) -> Scene:
    """The scene with this effect alone, in the same wind, on the same ground and at the same rotor.
    """
    around = (x for x in scene.effects if x is not applied and (
        x.effect.wind or x.effect.ground or x.effect.elastic and x.on == applied.on))
    return replace(scene, effects=(applied, *around))
