"""Quantities from which functions of scenes are built: poses, twists, torques, momenta, … of one
recording."""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    rotated,
    rotation,
    subtract,
    translation,
)
from coscrew_codegen.dynamics import (
    directional_derivatives,
    dynamics_derivatives,
    gradients,
    step_jacobians,
)
from coscrew_codegen.dynamics.algorithms import (
    centroidal,
    coordinates,
    crba,
    energies,
    floating,
    forward,
    frames,
    kicks,
    rnea,
    rnea_derivatives,
)
from coscrew_codegen.dynamics.algorithms.aba import Articulated
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.contacts.contact_values import contact_values
from coscrew_codegen.dynamics.forces import effect_states
from coscrew_codegen.dynamics.forces.added_inertia import with_coriolis
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.forces.effect_values import Values, values_of
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.dynamics.loops import demands
from coscrew_codegen.dynamics.loops.couplings import closures
from coscrew_codegen.dynamics.loops.multipliers import Constrained, ConstraintRows
from coscrew_codegen.dynamics.parameters.scene_parameters import LinearParameters
from coscrew_codegen.dynamics.step_jacobians import OtherFunctions
from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.mechanism.tree import heading_of_body
from coscrew_codegen.scene.scene import Applied
from coscrew_codegen.scene.scene_function import Depends, Frame, Numbers, Results, SceneFunction


class RecordedDynamics:
    """The dynamics of a scene, recorded: each quantity from the inputs that the function takes.

    `roots` returns the first links of floating trees, `linear` the parameters on which torques
    depend linearly."""

    def __init__(self, recording: FunctionRecording, function: SceneFunction,
                 roots: Callable[[], Sequence[int]], others: OtherFunctions,
                 linear: Callable[[], LinearParameters]):
        self._recording, self._function, self._roots = recording, function, roots
        self._others, self._linear = others, linear
        self.target = function.target
        self.scene, self.recorder, self._tree = (
            recording.scene, recording.recorder, recording.tree)

    # inputs and constants

    def argument(self, name: str) -> Numbers:
        """The components of an input.  Raises ValueError for one that the function lacks."""
        if not self.recorder.has(name):
            has = ", ".join(a.name for a in self.recorder.inputs)
            raise ValueError(f"no input {name!r}: it takes {has}")
        return self.recorder.argument(name)

    def number(self, value: Scalar | int) -> Number:
        """A number of the scene, or its element of p."""
        if isinstance(value, Parameter):
            self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return self.recorder.number(value)

    def numbers(self, values: Sequence[Scalar | int]) -> tuple[Number, ...]:
        """Numbers of the scene."""
        return tuple(map(self.number, values))

    @cached_property
    def _still(self) -> Motion:
        """Frames and velocities, without gravity, which takes masses."""
        return self._recording.motion(falling=False)

    @cached_property
    def _motion(self) -> Motion:
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return self._recording.motion()

    def _refuse_unless(self, *allowed: Depends) -> None:
        """Raises ValueError if the function uses p or t without declaring that it depends on them.
        """
        if self._function.depends not in allowed:
            raise ValueError(f"{self._function.name} depends on {allowed[0].name.lower()}; wanted "
                             f"depends = Depends.{allowed[0].name}")

    def pose(self, body: str) -> Numbers:
        """D of a body."""
        return frames.pose(self._recording, self._still, body)

    def position(self, body: str, point: Vector) -> Vector:
        """R x + t."""
        D = self.pose(body)
        with self.recorder.part(self._numbers[body], "xw", heading_of_body(body)):
            return add(rotated(rotation(D), point), translation(D))

    def twist(self, body: str) -> Numbers:
        """(v; ω) of a body."""
        with self.recorder.part(self._numbers[body], "v", heading_of_body(body)):
            return frames.twist(self._recording, self._still, body)

    def jacobian(self, body: str, frame: Frame, point: Numbers = ()) -> Numbers:
        """J of a body, row by row."""
        with self.recorder.part(self._numbers[body], "J", heading_of_body(body)):
            columns = frames.jacobian(self._recording, self._still, body, frame, point)
        return _by_columns(columns)

    def twist_rate(self, body: str, frame: Frame, point: Numbers = ()) -> Numbers:
        """J a + J' v of a body."""
        with self.recorder.part(self._numbers[body], "a", heading_of_body(body)):
            return frames.twist_rate(self._recording, self._still, body, frame, point)

    def acceleration(self, body: str) -> Numbers:
        """The acceleration of a body's origin and its angular acceleration, in its axes."""
        with self.recorder.part(self._numbers[body], "a", heading_of_body(body)):
            return frames.acceleration(self._recording, self._still, body)

    @cached_property
    def _numbers(self) -> dict[str, str]:
        """The numbers of bodies, which name their values."""
        return {body.name: str(n) for n, body in enumerate(self.scene.model.bodies)}

    @cached_property
    def _acting(self) -> AppliedEffects:
        self._refuse_unless(Depends.EFFECTS)
        return AppliedEffects(self.scene, self._motion).act()

    def mass_matrix(self) -> Numbers:
        """M(q), row by row."""
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        x = self._recording
        M = crba.mass_matrix(self._still, x.rigids, x.inertias)
        return [entry for row in M for entry in row]

    def coriolis_matrix(self) -> Numbers:
        """C(q, v), row by row."""
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        rigids, motion = self._recording.rigids, self._still
        C = rnea_derivatives.coriolis_matrix(motion, rigids)
        for link, rigid in enumerate(rigids):
            if rigid.added:
                C = with_coriolis(motion, link, Articulated(rigid.added), C)
        return _by_rows(C)

    def torques(self, effects: bool = True) -> Numbers:
        """The torques of inverse dynamics."""
        return self._recording.torques(self._motion, self._acting if effects else None)

    def accelerations(self) -> Numbers:
        """The accelerations of forward dynamics."""
        return self._constrained()[1].a if self.scene.model.loops else self._free_accelerations()

    def _free_accelerations(self) -> list[Number]:
        """Returns the accelerations with loops open."""
        x, acting = self._recording, self._acting
        return forward.accelerations(self._motion, acting, x.rigids, x.inertias, x.tau)

    def _constrained(self) -> tuple[ConstraintRows, Constrained]:
        """The rows of closed loops; the accelerations that meet them, and their multipliers."""
        x, demand = self._recording, demands.exact(self._recording, self._motion)
        inverse = forward.inverse(self._motion, x.rigids, x.inertias)
        return demand.rows, demand.met(self._free_accelerations(), inverse)

    def torque_derivatives(self) -> Results:
        """∂tau/∂q, ∂tau/∂v and ∂tau/∂a = M of inverse dynamics."""
        self._refuse_unless(Depends.EFFECTS)
        return [_by_rows(A) for A in dynamics_derivatives.of_inverse(self._recording)]

    def acceleration_derivatives(self) -> Results:
        """∂a/∂q, ∂a/∂v and ∂a/∂tau = M⁻¹ of forward dynamics."""
        self._refuse_unless(Depends.EFFECTS)
        return [_by_rows(A) for A in dynamics_derivatives.of_forward(self._recording)]

    def tangent(self, function: SceneFunction) -> Results:
        """The results of another function, and their derivatives along d_."""
        return directional_derivatives.tangent(
            self._recording, function, self._others.program(function))

    def adjoint(self, function: SceneFunction) -> Results:
        """The results of another function, and the derivatives of w_ times them by the inputs."""
        return directional_derivatives.adjoint(
            self._recording, function, self._others.program(function))

    def step_derivatives(self, step: SceneFunction) -> Results:
        """q and v after a step, and their derivatives."""
        return step_jacobians.of_step(self._recording, step, self._others)

    def torque_regressor(self) -> Results:
        """Y, row by row, and tau0 of tau = Y pi + tau0."""
        self._refuse_unless(Depends.EFFECTS)
        columns, rest = self._linear().columns(self._recording, self._motion)
        return [_by_columns(columns), rest]

    def linear_parameters(self) -> Numbers:
        """pi."""
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return self._linear().numbers(self._recording)

    def base_regressor(self) -> Results:
        """Y, row by row, and tau0 of tau = Y beta + tau0."""
        self._refuse_unless(Depends.EFFECTS)
        columns, rest = self._linear().columns(self._recording, self._motion)
        return [_by_columns([columns[k] for k in self._linear().base.places]), rest]

    def base_parameters(self) -> Numbers:
        """beta."""
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return self._linear().base_numbers(self._recording)

    def energies(self) -> Numbers:
        """(kinetic, potential) energy."""
        x, motion, acting = self._recording, self._motion, self._acting
        return [energies.kinetic(x, motion), energies.potential(x, motion) + acting.potential()]

    def energy_gradients(self) -> Results:
        """∂T/∂q, ∂T/∂v and ∂V/∂q."""
        self._refuse_unless(Depends.EFFECTS)
        x = self._recording
        return [*gradients.of_kinetic(x, self._still),
                gradients.of_potential(x, self._motion)]

    def power(self) -> Number:
        """The power of the effects without potential energy."""
        return self._acting.power()

    def bristles(self) -> Results:
        """The energy of bristles, and the power of their effects."""
        return effect_states.bristles(self._recording)

    def momentum(self) -> Numbers:
        """(p; L) about the world's origin."""
        return energies.momentum(self._recording, self._motion)

    def centre_of_mass(self) -> Numbers:
        """The centre of mass of all bodies that can move."""
        return self._centroid.position

    def centre_of_mass_velocity(self) -> Numbers:
        """Its velocity."""
        return self._centroid.velocity

    def centre_of_mass_jacobian(self) -> Numbers:
        """J of the centre of mass, row by row."""
        return _by_columns(self._centroid.jacobian())

    def centroidal_momentum_matrix(self) -> Numbers:
        """A, row by row."""
        return _by_columns(self._centroid.matrix())

    def centroidal_momentum_rate(self) -> Numbers:
        """A a + A' v."""
        return self._centroid.rate()

    @cached_property
    def _centroid(self) -> centroidal.Centroid:
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return centroidal.Centroid(self._recording, self._still)

    def transmitted(self, joint: str) -> Numbers:
        """(force; moment) that a joint exerts on its child."""
        x, motion, acting = self._recording, self._motion, self._acting
        closing: Mapping[int, Numbers] = {}
        if self.scene.model.loops:
            rows, its = self._constrained()
            motion, closing = x.motion(a=its.a), demands.wrenches(rows, its.multipliers)
            acting = AppliedEffects(self.scene, motion).act()
        net = rnea.net_wrenches(motion, x.rigids, acting)
        wrenches = rnea.transmitted(motion, [
            subtract(f, closing[n]) if n in closing else f for n, f in enumerate(net)])
        return wrenches[self._tree.links.index(self._tree.link_of(joint))]

    def of_effect(self, applied: Applied) -> Values:
        """Force or torque of an effect, its power and its energy."""
        self._refuse_unless(Depends.EFFECTS)
        return values_of(self._recording, self._motion, applied)

    # closed loops

    def closures(self) -> Results:
        """phi, and E row by row."""
        its = closures(self._still, self.scene.model.loops)
        return [[y for x in its for y in x.phi], _by_rows([y for x in its for y in x.rows])]

    def closings(self, *loops: str) -> Results:
        """The accelerations; (force; moment) on the first body of each of these loops."""
        rows, its = self._constrained()
        return [its.a, [y for x in loops for y in demands.wrench(rows, its.multipliers, x)]]

    def with_closed_loops(self) -> Results:
        """q and v moved onto the closures."""
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return demands.projected(self._recording)

    # steps

    def integrated(self) -> Numbers:
        """q ⊕ phi."""
        return coordinates.integrated(self.recorder, self._tree, self._recording.names,
                                      self.argument("q"), self.argument("phi"))

    def difference(self) -> Numbers:
        """q1 ⊖ q."""
        return coordinates.difference(self.recorder, self._tree, self._recording.names,
                                      self.argument("q1"), self.argument("q"))

    def chart(self) -> Numbers:
        """∂(q ⊕ phi)/∂phi at phi = 0, row by row."""
        zero = self.recorder.number(0)
        return [zero if x is None else x for row in coordinates.chart(self._still) for x in row]

    def chart_rate(self) -> Numbers:
        """phi' while q ⊕ phi moves with v."""
        return coordinates.chart_rate(self.recorder, self._tree, self._recording.names)

    def implicit_accelerations(self) -> Numbers:
        """a with (M + h d + h² k) a = tau - bias torques - h k v."""
        x, (h,) = self._recording, self.argument("h")
        acting = AppliedEffects(self.scene, self._motion, over=h).act()
        free = forward.implicit(self._motion, acting, x.rigids, x.inertias, kicks.end_weights(h),
                                x.tau)
        if not self.scene.model.loops:
            return free.a
        return demands.stop(x, self._motion, h).met(free.a, free.inverse).a

    def midpoint_accelerations(self) -> Numbers:
        """a of the default integrator's kick."""
        self._refuse_unless(Depends.EFFECTS)
        return kicks.kick(self._recording)[0]

    def kicked(self) -> Results:
        """a of the default integrator's kick, and q with the effects' states at its end."""
        self._refuse_unless(Depends.EFFECTS)
        return kicks.kick(self._recording)

    def carried(self) -> Results:
        """q and v after h/2, with free bases that move straight on."""
        (h,), q, v = (self.argument(x) for x in "hqv")
        return coordinates.carried(self.recorder, self._tree, self._recording.names, h, q, v)

    def state_rates(self) -> Results:
        """x' of effects' states, and q with them within their bounds."""
        return effect_states.rates(self._recording)

    def moved_states(self) -> Numbers:
        """q with effects' states moved by h at v."""
        return effect_states.moved(self._recording)

    def switches(self) -> Numbers:
        """Numbers that change their signs where another part of an effect's law begins."""
        return effect_states.switches(self._recording)

    def floating_momenta(self) -> Numbers:
        """(p; L; x) of each floating tree."""
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return floating.momentum(self._recording, self._roots())

    def with_floating_momenta(self) -> Results:
        """q and v corrected to the momenta c."""
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return floating.corrected(self._recording, self._roots())

    def contacts(self) -> Results:
        """Points, forces, depths and friction of the contacts of bodies."""
        self._refuse_unless(Depends.EFFECTS)
        return [*contact_values(self._motion, self._acting)]

    def closing(self) -> Number:
        """The number of contacts that are closed or close."""
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return kicks.closing(self._recording)

    def split(self) -> tuple[Number, Number]:
        """The number and length of a step's parts."""
        self._refuse_unless(Depends.MASSES, Depends.EFFECTS)
        return kicks.split(self._recording)


def _by_rows(A: Sequence[Numbers]) -> list[Number]:
    return [x for row in A for x in row]


def _by_columns(columns: Sequence[Numbers]) -> list[Number]:
    return [x for row in zip(*columns, strict=True) for x in row]
