"""Functions of scenes: entries of the catalogue from which they are selected, recorded, emitted,
measured and documented.

A function's file knows no other function and no algorithm: its `compute` gets the scene's motion as
Dynamics, and returns Numbers."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING, Protocol

from coscrew_codegen.algebra.recording.numbers import Number, Vector
from coscrew_codegen.program.values.parameter import Scalar
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.integrator import Integrator
from coscrew_codegen.scene.mechanism.function_arguments import (
    COUNT,
    INPUTS,
    MOMENTA,
    TAU,
    A,
    Array,
    AxisLength,
    Frame,
    Of,
    Q,
    SceneQuantity,
    V,
)
from coscrew_codegen.scene.mechanism.model import WORLD, Model
from coscrew_codegen.scene.scene import Applied, Scene
from coscrew_codegen.scene.situation import Precondition, Situation

if TYPE_CHECKING:
    from coscrew_codegen.algebra.recording.recorder import Recorder

__all__ = ["A", "ALWAYS", "Array", "AxisLength", "COUNT", "Default", "Depends", "Dynamics",
           "Frame", "IF_SELECTED", "INPUTS", "MOMENTA", "Numbers", "Of", "Q", "Results",
           "SceneFunction", "SceneQuantity", "Situation", "TAU", "V"]

Numbers = Sequence[Number]
Results = Sequence[Numbers]
"""The components of each output, row by row."""


class Dynamics(Protocol):
    """Dynamics of a scene at the inputs of a function: constants and inputs as Numbers, and the
    results of algorithms.  Velocities, accelerations and torques that the function does not take
    are zero.

    `recorder.call` records an operation of the library."""

    scene: Scene
    recorder: "Recorder"
    target: str  # of a family's member: its body, joint or loop

    def argument(self, name: str) -> Numbers:
        """The components of an input."""

    def number(self, value: Scalar | int) -> Number:
        """A number of the scene: a constant, or its element of p if it is a run-time parameter."""

    def numbers(self, values: Sequence[Scalar | int]) -> tuple[Number, ...]:
        """Numbers of the scene."""

    def pose(self, body: str) -> Numbers:
        """D = [R | t] of a body, row by row."""

    def position(self, body: str, point: Vector) -> Vector:
        """R x + t of a point of a body, which is in the body's frame."""

    def twist(self, body: str) -> Numbers:
        """(v; ω) of a body at its origin, in its own frame."""

    def jacobian(self, body: str, frame: Frame, point: Numbers = ()) -> Numbers:
        """J with J v = (v; ω) of a body, row by row; at a point of it instead of its origin."""

    def twist_rate(self, body: str, frame: Frame, point: Numbers = ()) -> Numbers:
        """J a + J' v of that Jacobian: the rate of the components of (v; ω)."""

    def acceleration(self, body: str) -> Numbers:
        """The acceleration of a body's origin, and its angular acceleration, in its axes."""

    def mass_matrix(self) -> Numbers:
        """M(q), row by row."""

    def coriolis_matrix(self) -> Numbers:
        """C(q, v), row by row."""

    def torques(self, effects: bool = True) -> Numbers:
        """M(q) a + bias torques; without `effects`, those of inertia and gravity alone."""

    def accelerations(self) -> Numbers:
        """a with M(q) a + bias torques = tau."""

    def torque_derivatives(self) -> Results:
        """∂tau/∂q, ∂tau/∂v and ∂tau/∂a = M of inverse dynamics, row by row."""

    def acceleration_derivatives(self) -> Results:
        """∂a/∂q, ∂a/∂v and ∂a/∂tau = M⁻¹ of forward dynamics, row by row."""

    def torque_regressor(self) -> Results:
        """Y, row by row, and tau0 of tau = Y pi + tau0."""

    def linear_parameters(self) -> Numbers:
        """pi."""

    def base_regressor(self) -> Results:
        """Y, row by row, and tau0 of tau = Y beta + tau0."""

    def base_parameters(self) -> Numbers:
        """beta."""

    def energies(self) -> Numbers:
        """(kinetic, potential) energy."""

    def energy_gradients(self) -> Results:
        """∂T/∂q, ∂T/∂v and ∂V/∂q of the kinetic energy T and the potential energy V."""

    def tangent(self, function: "SceneFunction") -> Results:
        """The results of another function of the same inputs, and their derivatives along the
        directions d_."""

    def adjoint(self, function: "SceneFunction") -> Results:
        """Its results, and the derivatives of their sum with the weights w_ by the inputs."""

    def step_derivatives(self, step: "SceneFunction") -> Results:
        """q and v after a step of the same inputs; their derivatives by q and v, by tau if the step
        takes it, and by p if the scene has run-time parameters; row by row."""

    def power(self) -> Number:
        """The power of the effects without potential energy."""

    def bristles(self) -> Results:
        """The energy of bristles, and the power of the effects that have them."""

    def momentum(self) -> Numbers:
        """(p; L) of all bodies about the world's origin, in its axes; without armatures."""

    def centre_of_mass(self) -> Numbers:
        """The centre of mass of all bodies that can move, in the world."""

    def centre_of_mass_velocity(self) -> Numbers:
        """Its velocity."""

    def centre_of_mass_jacobian(self) -> Numbers:
        """J with J v = its velocity, row by row."""

    def centroidal_momentum_matrix(self) -> Numbers:
        """A with A v = (p; L) about the centre of mass, in the world's axes; row by row."""

    def centroidal_momentum_rate(self) -> Numbers:
        """A a + A' v."""

    def transmitted(self, joint: str) -> Numbers:
        """(force; moment) that a joint exerts on its child, in the child's frame, at its origin."""

    def of_effect(self, applied: Applied) -> Mapping[str, Callable[[], Numbers]]:
        """Force and torque of an effect, its power and its energy, by quantity."""

    def integrated(self) -> Numbers:
        """q ⊕ phi."""

    def difference(self) -> Numbers:
        """q1 ⊖ q: phi with q ⊕ phi = q1."""

    def chart(self) -> Numbers:
        """∂(q ⊕ phi)/∂phi at phi = 0, row by row."""

    def chart_rate(self) -> Numbers:
        """phi' while q ⊕ phi moves with v."""

    def implicit_accelerations(self) -> Numbers:
        """a with (M + h d + h² k) a = tau - bias torques - h k v."""

    def midpoint_accelerations(self) -> Numbers:
        """a of the default integrator's kick."""

    def kicked(self) -> Results:
        """These, and q with the states of effects at the end of the kick."""

    def carried(self) -> Results:
        """q and v after h/2, with free bases that move straight on."""

    def floating_momenta(self) -> Numbers:
        """(p; L; x) of each floating tree."""

    def with_floating_momenta(self) -> Results:
        """q and v corrected to the momenta c."""

    def closures(self) -> Results:
        """The closures of loops, and the rows E, row by row."""

    def closings(self, *loops: str) -> Results:
        """The accelerations; (force; moment) that each of these loops' closures exerts on its first
        body, in the body's frame, at the loop's point."""

    def with_closed_loops(self) -> Results:
        """q and v moved onto the closures of loops."""

    def contacts(self) -> Results:
        """Points, forces, depths and friction of the contacts of bodies."""

    def state_rates(self) -> Results:
        """x' of effects' states, and q with them within their bounds."""

    def moved_states(self) -> Numbers:
        """q with effects' states moved by h at v."""

    def switches(self) -> Numbers:
        """Numbers that change their signs where another part of an effect's law begins."""

    def closing(self) -> Number:
        """The number of limits that are closed, or would be after moving with v for h."""

    def split(self) -> tuple[Number, Number]:
        """The number and length of the parts of a step that resolve contacts of limits."""


class Depends(Enum):
    """Kinds of data that a function depends on, besides its inputs."""

    GEOMETRY = "frames of joints and bodies"
    MASSES = "masses, too, and so on p if the scene has run-time parameters"
    EFFECTS = "effects, too, and so on t if they depend on time"


@dataclass(frozen=True)
class Default:
    """Condition under which a scene that selects no functions has a function (of a target), also in
    words."""

    words: str
    holds: Callable[[Scene, str], bool]


ALWAYS = Default("by default", lambda scene, target: True)
IF_SELECTED = Default("if selected or recorded", lambda scene, target: False)


_OF_STATES = ("q", "v", "a", "tau")


@dataclass(frozen=True)
class SceneFunction:
    """A function of scenes, or a family of them: the members are those of a scene, one for each
    body, joint, effect or integrator.  A family's name and words are those of its members, with
    BODY, JOINT and so on in place of names."""

    name: str  # in scenes, C and Python
    place: int  # among the functions, in the order in which they are emitted
    words: str  # its equation, and its outputs
    inputs: str  # names of INPUTS; p and t, on which masses and effects depend, are added
    outputs: tuple[Array, ...]
    compute: Callable[[Dynamics], Results] | None  # None for a step, which calls others
    depends: Depends = Depends.MASSES
    default: Default = IF_SELECTED
    recorded: tuple[SceneQuantity, ...] = ()
    recorded_in: Callable[[Scene], bool] = lambda scene: True  # whether a scene can record these
    divides: bool = False  # by the mass matrix, or called only by functions that do
    needs: Precondition | None = None  # what a scene must have
    words_in: Callable[[Situation], str] | None = None  # where words depend on the scene
    units_in: Callable[[Situation], tuple[str, ...]] | None = None  # of all results, likewise
    internal: bool = False  # called by steps alone, so that it cannot be selected
    targets: Of = Of.SCENE  # of a family: members are for bodies or joints that move, or loops
    with_tau: bool = False  # whether NAME_tau, with the input tau, is made besides; here tau = 0
    members: Callable[["SceneFunction", Scene], tuple["SceneFunction", ...]] | None = None  # of a
    # family whose members differ in more than targets
    target: str = ""  # of a member: its body, joint or loop
    each: Callable[["SceneFunction", "SceneFunction", Scene], "SceneFunction | None"] | None = None
    # of a family that has a member for each other function, or None for it
    differentiates: "SceneFunction | None" = None  # of such a member: the other function
    more: tuple[Array, ...] = ()  # inputs of its own, after the others
    step: Integrator | None = None  # whose step it is
    shown: bool = False  # whether `coscrew cost` shows what each effect adds to it
    judged: bool = False  # whether `coscrew check` judges its rounding
    closed: "SceneFunction | None" = None  # in its place where loops are closed
    of_tree: bool = False  # wrong where loops are closed, so that such a scene cannot have it

    def __post_init__(self) -> None:
        for name in self.takes:
            if name not in INPUTS:
                raise ValueError(f"{self.name}: no input {name!r}; wanted {', '.join(INPUTS)}")
        for quantity in self.recorded:
            self.components_of(quantity)

    def components_of(self, quantity: SceneQuantity) -> tuple[tuple[str, tuple[int, ...]], ...]:
        """Returns (unit, places of the results that are added) of each component of a recorded
        quantity.  Raises ValueError for quantities that a state does not determine, or missing
        results."""
        what = f"{self.name}: {quantity.name!r} is recorded of it"
        if others := [name for name in self.takes if name not in _OF_STATES]:
            raise ValueError(f"{what}, but it takes {', '.join(others)}; wanted functions of "
                             f"{', '.join(_OF_STATES)}")
        units = self._units_recorded(quantity, what)
        places = quantity.places or tuple((i,) for i in range(len(units)))
        if quantity.components and len(quantity.components) != len(places):
            raise ValueError(f"{what} with {len(quantity.components)} names of its {len(places)} "
                             "components")
        for several in places:
            if not several or max(several) >= len(units) or len({units[i] for i in several}) > 1:
                raise ValueError(f"{what}: results {several}; wanted some of its {len(units)} "
                                 "results, of one unit")
        return tuple((units[several[0]], several) for several in places)

    def _units_recorded(self, quantity: SceneQuantity, what: str) -> tuple[str, ...]:
        """The unit of each result, of one body or joint."""
        of_all = quantity.of is Of.BODY and self.targets is Of.SCENE and (
            [x.shape[:1] for x in self.outputs] == [(AxisLength.BODIES,)])
        if not of_all and (self.members or quantity.of is not self.targets):
            raise ValueError(f"{what}; wanted a quantity of the scene, of bodies or joints that "
                             "are the function's targets, or of bodies along the first axis of "
                             "its only output")
        result: list[str] = []
        for x in self.outputs:
            shape = tuple(n for n in x.shape[of_all:] if isinstance(n, int))
            if callable(x.units) or len(shape) < len(x.shape) - of_all:
                raise ValueError(f"{what}, but the number or the units of {x.name} depend on the "
                                 "scene")
            result += x.units_of(shape, ())
        return tuple(result)

    @property
    def takes(self) -> tuple[str, ...]:
        """The names of its inputs."""
        return tuple(self.inputs.split())

    def inputs_in(self, scene: Scene) -> tuple[Array, ...]:
        """The inputs in a scene: with p if the function depends on masses, and t if on effects."""
        takes = {*self.takes}
        if self.depends is Depends.EFFECTS and scene.timed:
            takes.add("t")
        if self.depends is not Depends.GEOMETRY and scene.parameters:
            takes.add("p")
        return (*(x for name, x in INPUTS.items() if name in takes), *self.more)

    def outputs_in(self, scene: Scene) -> tuple[Array, ...]:
        """The outputs in a scene; those with an input's name get the suffix o."""
        taken = {x.name for x in self.inputs_in(scene)}
        return tuple(replace(x, name=f"{x.name}o") if x.name in taken else x
                     for x in self.outputs)

    def absent(self, its: Situation) -> str:
        """Says why a scene cannot have it; "" if it can."""
        return self.needs.missing if self.needs and not self.needs.met(its) else ""

    def within(self, scene: Scene) -> "SceneFunction":
        """The function, or the one in its place where the scene's loops are closed."""
        return self.closed if self.closed and scene.model.loops else self

    def of(self, scene: Scene) -> tuple["SceneFunction", ...]:
        """The function, or the members of the family that a scene has."""
        if self.within(scene) is not self:
            return self.within(scene).of(scene)
        own = self.members(self, scene) if self.members else self._of_targets(scene)
        return (*own, *(x._taking_tau() for x in own)) if self.with_tau else own

    def _of_targets(self, scene: Scene) -> tuple["SceneFunction", ...]:
        if self.targets is Of.SCENE:
            return (self,)
        word = self.targets.value.upper()
        return tuple(replace(self, name=name, words=self.words.replace(word, target), target=target)
                     for target, name in self.names(scene).items())

    def _taking_tau(self) -> "SceneFunction":
        return replace(self, name=f"{self.name}_tau", place=self.place + 2,
                       inputs=f"{self.inputs} tau",
                       words=self.words.replace("-bias_torques", "tau -bias_torques"))

    def names(self, scene: Scene) -> dict[str, str]:
        """The names of a family's members, by target."""
        word = self.targets.value.upper()
        return {target: self.name.replace(word, stem)
                for stem, target in _targets(self.targets, scene.model)}


def _targets(kind: Of, model: Model) -> list[tuple[str, str]]:
    """The bodies, joints or loops for which a family has members: (the identifier in the member's
    name, the name) of each."""
    match kind:
        case Of.BODY:
            names, links = [x.name for x in model.bodies], model.links()
            return [(stem, name) for stem, name in zip(identifiers(names), names, strict=True)
                    if links[name] != WORLD]
        case Of.JOINT:
            names = [x.name for x in model.joints if x.kind.moves]
        case Of.LOOP:
            names = [x.name for x in model.loops]
        case Of.SCENE:
            names = []
    return list(zip(identifiers(names), names, strict=True))
