"""Records one function of a scene as a Program: its inputs, the kinematic tree, its results."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property
from math import prod

from coscrew_codegen.algebra.recording.recorder import Recorder, array, headings
from coscrew_codegen.dynamics.algorithms import coordinates, floating
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.dynamics.parameters.scene_parameters import LinearParameters
from coscrew_codegen.dynamics.ranges.ranges import refuse_products, refuse_quotients
from coscrew_codegen.dynamics.scene_dynamics import RecordedDynamics
from coscrew_codegen.program import Constant, Op, Operand, Program
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.quantity import Argument
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.functions.parameters import torque_regressor
from coscrew_codegen.scene.functions.steps import closing_contacts
from coscrew_codegen.scene.mechanism.assembly import ModelError
from coscrew_codegen.scene.mechanism.tree import Tree, heading_of_body, tree_of
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import (
    INPUTS,
    Array,
    AxisLength,
    Depends,
    Results,
    SceneFunction,
)


def is_timed(scene: Scene) -> bool:
    """Returns whether any effect is a function of time."""
    def timed(value: object) -> bool:
        parts = value if isinstance(value, tuple) else (value,)
        return any(isinstance(x, Formula) and x.timed for x in parts)

    return any(timed(value) for x in scene.effects for value in x.values.values())


def tree_for(scene: Scene) -> Tree:
    """The tree of a scene's model; joints follow others if the scene has the effect mimic."""
    return tree_of(scene.model, any(x.effect.mimic for x in scene.effects))


class Derivation:
    """Records the functions of a scene one by one, each from its inputs."""

    def __init__(self, scene: Scene, tell: Callable[[str], None] = lambda name: None):
        self.scene, self.tree, self.tell = scene, tree_for(scene), tell
        self.bodies = {body.name: str(n) for n, body in enumerate(scene.model.bodies)}
        self.names = tuple(self.bodies[link.name] for link in self.tree.links)
        self.kinds: tuple[str, ...] = tuple(c.kind for c in self.tree.coordinates)
        self.timed = is_timed(scene)
        self.headings = self._headings()
        self._made: dict[str, FunctionProgram] = {}

    # the scene, as far as functions depend on it

    @cached_property
    def _floating(self) -> tuple[int, ...]:
        return floating.floating(self.scene, self.tree)

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
                return self.tree.nq
            case AxisLength.NV:
                return self.tree.nv
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

    # recording

    def made(self, entry: SceneFunction) -> FunctionProgram:
        """The function, recorded once."""
        if entry.name not in self._made:
            self.tell(entry.name)
            self._made[entry.name] = self._derived(entry)
        return self._made[entry.name]

    def _derived(self, entry: SceneFunction) -> FunctionProgram:
        """The function of its inputs, with p if it depends on masses, and t if on effects."""
        scene, takes = self.scene, {*entry.takes}
        if entry.depends is Depends.EFFECTS and self.timed:
            takes.add("t")
        if entry.depends is not Depends.GEOMETRY and scene.parameters:
            takes.add("p")
        given = [name for name in INPUTS if name in takes]
        program = self._recorded(entry, [self._argument(INPUTS[x]) for x in given])
        words = entry.words_in(self) if entry.words_in else entry.words
        function = FunctionProgram(entry.name, words, program, tuple(
            (place, self.headings.get(heading, heading)) for place, heading in headings(program)),
            units=self._units(entry))
        refuse_products(scene, function)
        refuse_quotients(scene, function, self._at_rest(given))
        return function

    def _argument(self, x: Array) -> Argument:
        return array(x.name, x.sized(self.size), x.words)

    def _units(self, entry: SceneFunction) -> tuple[str, ...]:
        """The unit of each component of the results."""
        if entry.units_in:
            return entry.units_in(self)
        try:
            return tuple(unit for x in entry.outputs
                         for unit in x.units_of(x.sized(self.size), self.kinds))
        except ValueError as error:
            raise ValueError(f"{entry.name}: {error}") from None

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
                recording, entry, self._roots, lambda: self.linear))
        except ZeroDivisionError:
            raise self._division(entry, recorder.heading) from None
        except Exception as error:
            error.add_note(f"The function {entry.name} of {self.scene.name} raised it.")
            raise
        outputs = [self._argument(x) for x in entry.outputs]
        _fit(entry.name, outputs, results)
        program = recorder.program(entry.name, list(zip(outputs, results, strict=True)))
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

    def _at_rest(self, names: Sequence[str]) -> dict[str, tuple[float, ...]]:
        """Inputs by name, at rest: neutral coordinates, default parameters, zero velocities."""
        known = {"q": coordinates.neutral(self.tree), "h": (self.scene.run.step,),
                 "p": tuple(float(x.value) for x in self.scene.parameters)}
        return {name: known.get(name, (0.0,) * prod(INPUTS[name].sized(self.size)))
                for name in names}


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
