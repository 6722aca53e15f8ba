"""Records one function of a scene as a Program: its inputs, the kinematic tree, its results."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property

from coscrew_codegen.algebra.recording.recorder import Recorder, array, headings
from coscrew_codegen.dynamics.algorithms import coordinates, floating
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.dynamics.inlined_steps import inlined
from coscrew_codegen.dynamics.integrator_steps import needs, stepped
from coscrew_codegen.dynamics.parameters.scene_parameters import LinearParameters
from coscrew_codegen.dynamics.ranges.representable import refuse_products, refuse_quotients
from coscrew_codegen.dynamics.scene_dynamics import RecordedDynamics
from coscrew_codegen.program import Constant, Op, Operand, Program
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.quantity import Argument
from coscrew_codegen.scene.effect_quantities import count_of, states_of
from coscrew_codegen.scene.functions import functions_of
from coscrew_codegen.scene.functions.parameters import torque_regressor
from coscrew_codegen.scene.functions.steps import closing_contacts
from coscrew_codegen.scene.mechanism.assembly import ModelError
from coscrew_codegen.scene.mechanism.tree import Tree, heading_of_body, tree_of
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import (
    Array,
    AxisLength,
    Results,
    SceneFunction,
)


def tree_for(scene: Scene) -> Tree:
    """The tree of a scene's model; joints follow others if the scene has the effect mimic."""
    return tree_of(scene.model, any(x.effect.mimic for x in scene.effects))


Keep = Callable[[str, Callable[[], FunctionProgram]], FunctionProgram]
"""(name, make) -> the function of this name, from a store, or made and stored."""


class Derivation:
    """Records the functions of a scene one by one, each from its inputs.  `tell` is called with the
    name of each before it is recorded, unless `keep` has it."""

    def __init__(self, scene: Scene, tell: Callable[[str], None] = lambda name: None,
                 keep: Keep = lambda name, make: make()):
        self.scene, self.tree, self.tell, self.keep = scene, tree_for(scene), tell, keep
        self.bodies = {body.name: str(n) for n, body in enumerate(scene.model.bodies)}
        self.names = tuple(self.bodies[link.name] for link in self.tree.links)
        self.kinds: tuple[str, ...] = tuple(c.kind for c in self.tree.coordinates)
        self.headings = self._headings()
        self._made: dict[str, FunctionProgram] = {}

    # the scene, as far as functions depend on it

    @cached_property
    def _floating(self) -> tuple[int, ...]:
        roots = [n for n, link in enumerate(self.tree.links)
                 if link.parent < 0 and link.joint.kind.floats]
        return floating.floating(self.scene, self.tree, roots) if roots else ()

    def _roots(self) -> tuple[int, ...]:
        """The first links of floating trees."""
        return self._floating

    @property
    def floating(self) -> tuple[str, ...]:
        """The first bodies of floating trees."""
        return tuple(self.tree.links[n].name for n in self._roots())

    @cached_property
    def linear(self) -> LinearParameters:
        """The parameters on which torques depend linearly."""
        return LinearParameters(self.scene, self.tree, self.names,
                                lambda: self.made(torque_regressor.FUNCTION).program)

    @cached_property
    def closes(self) -> bool:
        """True if any limit can be hit."""
        return bool(self.made(closing_contacts.FUNCTION).program.instructions)

    def size(self, size: AxisLength) -> int:
        """The length of an axis."""
        match size:
            case AxisLength.NQ:
                return self.tree.nq + count_of(states_of(self.scene))
            case AxisLength.NV:
                return self.tree.nv
            case AxisLength.DISPLACEMENTS:
                return self.tree.nv + count_of(states_of(self.scene))
            case AxisLength.STATE:
                return 2 * self.tree.nv + count_of(states_of(self.scene))
            case AxisLength.BODIES:
                return len(self.bodies)
            case AxisLength.PARAMETERS:
                return len(self.scene.parameters)
            case AxisLength.FLOATING:
                return len(self._roots())
            case AxisLength.LINEAR:
                return len(self.linear.names)
            case AxisLength.BASE:
                return len(self.linear.base.places)
            case AxisLength.LOOPS:
                return len(self.scene.model.loops)
            case AxisLength.ROWS:
                return sum(x.kind.count for x in self.scene.model.loops)
            case AxisLength.CONTACTS:
                return sum(bool(x.effect.parts or x.effect.bodies_force)
                           for x in self.scene.effects)
            case AxisLength.EFFECT_STATES:
                return count_of(states_of(self.scene))
            case AxisLength.SWITCHES:
                return sum(x.effect.switches for x in self.scene.effects)

    # recording

    def made(self, entry: SceneFunction) -> FunctionProgram:
        """The function, recorded once."""
        if entry.name not in self._made:
            self._made[entry.name] = self.keep(entry.name, lambda: self._derived(entry))
        return self._made[entry.name]

    def program(self, entry: SceneFunction) -> Program:
        """The function as one program, even if it is a step, which consists of calls."""
        if not entry.step:
            return self.made(entry).program
        return inlined(self.step_of(entry),
                       [self._argument(x) for x in entry.inputs_in(self.scene)])

    def step_of(self, entry: SceneFunction) -> SceneFunctions:
        """A step and the functions that it calls."""
        if entry.step is None:
            raise TypeError(f"{entry.name} is no step")
        tau = "tau" in entry.takes
        called = needs(entry.step, takes_tau=tau)
        functions = self.collected([self.made(x) for x in functions_of(self.scene)
                                    if x.name in called and not x.absent(self)])
        return stepped(functions, *(((), [entry.step]) if tau else ([entry.step],)))

    def named(self, name: str) -> Program:
        """The function of this name."""
        entry = next(x for x in functions_of(self.scene, (name,)) if x.name == name)
        return self.made(entry).program

    def collected(self, made: Sequence[FunctionProgram]) -> SceneFunctions:
        """These functions with the scene's data for targets; without steps."""
        scene, tree = self.scene, self.tree
        return SceneFunctions(
            scene.name, self.size(AxisLength.NQ), tree.nv, tree.coordinates, tuple(self.bodies),
            tuple((p.name, float(p.value)) for p in scene.parameters), self._neutral,
            tuple(made), (), scene.precisions, scene.timed, tuple(scene.signs.items()),
            scene.tiers, states=tuple(x for own in states_of(scene)
                                      for x in zip(own.columns, own.units, strict=True)),
            box=scene.ranges.sizes if scene.ranges else ())

    def _derived(self, entry: SceneFunction) -> FunctionProgram:
        """The function of its inputs."""
        self.tell(entry.name)
        scene, given = self.scene, [self._argument(x) for x in entry.inputs_in(self.scene)]
        program = self._recorded(entry, given)
        words = entry.words_in(self) if entry.words_in else entry.words
        function = FunctionProgram(entry.name, words, program, tuple(
            (place, self.headings.get(heading, heading)) for place, heading in headings(program)),
            units=self._units(entry))
        refuse_products(scene, function)
        if not entry.differentiates:  # which divide by squares where no option takes the quotient
            refuse_quotients(scene, function, self._at_rest(given))
        return function

    def _argument(self, x: Array) -> Argument:
        return array(x.name, x.sized(self.size), x.words)

    def _units(self, entry: SceneFunction) -> tuple[str, ...]:
        """The unit of each component of the results."""
        if entry.units_in:
            return entry.units_in(self)
        try:
            return tuple(unit for x in entry.outputs for unit in self._units_of(x))
        except ValueError as error:
            raise ValueError(f"{entry.name}: {error}") from None

    def _units_of(self, x: Array) -> tuple[str, ...]:
        """The unit of each component; those of q end with those of effects' states."""
        if not x.is_coordinates:
            return x.units_of(x.sized(self.size), self.kinds)
        own = x.units_of((self.tree.nq,), self.kinds)
        return *own, *(unit for states in states_of(self.scene) for unit in states.units)

    def _recorded(self, entry: SceneFunction, inputs: Sequence[Argument], fine: bool = False
                  ) -> Program:
        """Records the program of the outputs, and the program for twice the digits if that differs.
        """
        recorder = Recorder(inputs, fine)
        recording = FunctionRecording(self.scene, self.tree, self.names, recorder)
        if entry.compute is None:
            raise TypeError(f"{entry.name} has no compute function")
        try:
            results = entry.compute(RecordedDynamics(
                recording, entry, self._roots, self, lambda: self.linear))
        except ZeroDivisionError:
            raise self._division(entry, recorder.heading) from None
        except Exception as error:
            error.add_note(f"The function {entry.name} of {self.scene.name} raised it.")
            raise
        outputs = [self._argument(x) for x in entry.outputs]
        _fit(entry.name, outputs, results)
        program = recorder.program(entry.name, list(zip(outputs, results, strict=True)))
        recorder.end()
        for step in program.instructions:
            if step.op is Op.DIV and _is_zero(step.operands[1]):
                raise self._division(entry, step.component.rpartition(":")[0])
        if fine or not recorder.differs:
            return program
        return replace(program, fine=self._recorded(entry, inputs, fine=True))

    def _division(self, entry: SceneFunction, heading: str) -> ModelError:
        """Names the cause of a division by zero: the mass matrix, or a function's or an effect's
        own law."""
        what = f"its numbers make a division by zero in {entry.name}, whatever q is"
        of_effect = heading.partition(" at ")[0] in {x.effect.name for x in self.scene.effects}
        if entry.divides and not of_effect:
            what += (": the mass matrix is singular; wanted masses or armatures that resist every "
                     "joint, no joint that mimics another with multiplier 0, or functions that do "
                     'not divide by it, as ["inverse_dynamics"]')
        else:
            what += f"; wanted other numbers, or functions without {entry.name}"
        return ModelError(f"{self.scene.name}: {heading or self.scene.model.name}", what)

    def _headings(self) -> dict[str, str]:
        """Headings of bodies in text: number and name, and the joint that moves it if it is a
        link's first body: "4 forearm: elbow turns about y"."""
        results = {heading_of_body(x): f"{number} {x}" for x, number in self.bodies.items()}
        for link in self.tree.links:
            results[link.heading] += f": {link.joint.in_words}"
        return results

    @property
    def _neutral(self) -> tuple[float, ...]:
        """q with joints at the identity and effects' states at zero."""
        return *coordinates.neutral(self.tree), *[0.0] * count_of(states_of(self.scene))

    def _at_rest(self, given: Sequence[Argument]) -> dict[str, tuple[float, ...]]:
        """Inputs by name, at rest: neutral coordinates, default parameters, zero velocities."""
        neutral = self._neutral
        known = {"q": neutral, "q1": neutral, "h": (self.scene.run.step,),
                 "p": tuple(float(x.value) for x in self.scene.parameters)}
        return {x.name: known.get(x.name, (0.0,) * x.quantity.size) for x in given}


def _is_zero(x: Operand) -> bool:
    return isinstance(x, Constant) and not x.double


def _fit(name: str, outputs: Sequence[Argument], results: Results) -> None:
    """Raises ValueError if the results do not fit the function's outputs."""
    if len(results) != len(outputs):
        raise ValueError(f"{name}: compute returned {len(results)} results; wanted "
                         f"{len(outputs)}: {', '.join(a.name for a in outputs)}")
    for argument, numbers in zip(outputs, results, strict=True):
        if len(numbers) != argument.quantity.size:
            raise ValueError(f"{name}: compute returned {len(numbers)} components of "
                             f"{argument.name}; wanted {argument.quantity.size}")
