"""Parameters of effects on which the torques of joints depend linearly, and their columns.

A number of an effect is chosen if the slope of the torques along it depends neither on itself nor
on another chosen one, and no choice of the law depends on it.  So tau_c of -tau_c tanh(v/eps) is
chosen and eps is not; nothing is of a torque with a limit.  The torques are then

    Σ (chosen number) · (its column) + the rest
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import Number, subtract
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.algorithms import rnea
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.program import Input, Op, Operand, Program, Ref
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.effect_quantities import count_of, states_of
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.parameter_units import parameter_units
from coscrew_codegen.scene.scene import Applied, Scene, Setting

LETTERS = "xyz"


@dataclass(frozen=True)
class LinearParameter:
    """A parameter that torques depend on linearly: its name, its unit, its number, and whether it
    must not be negative."""

    name: str  # viscous.elbow.d
    unit: str
    number: Scalar
    nonnegative: bool


class LinearEffects:
    """The effects of a scene as functions of their numbers."""

    def __init__(self, scene: Scene, tree: Tree, names: tuple[str, ...]):
        self._tree, self._names = tree, names
        self._numbers: list[LinearParameter] = []
        self._first = len(scene.parameters)
        effects = tuple(x if x.effect.gravity else self._replaced(x) for x in scene.effects)
        self._scene = replace(scene, effects=effects)
        units = parameter_units(self._scene)
        self._numbers = [replace(x, unit=units[x.name]) for x in self._numbers]
        self._places = self._chosen() if self._numbers else ()

    @property
    def parameters(self) -> tuple[LinearParameter, ...]:
        """The chosen numbers."""
        return tuple(self._numbers[k] for k in self._places)

    def columns(self, x: FunctionRecording) -> tuple[list[Sequence[Number]], Sequence[Number]]:
        """(the column of each chosen number, the rest of the torques) for a function's inputs."""
        zero, count = x.recorder.number(0), len(self._places)
        if not x.scene.effects:
            return [], [zero] * x.tree.nv
        program = self._program(x)
        given = []
        for a in program.inputs:
            own = x.recorder.argument(a.name) if x.recorder.has(a.name) else ()
            duals = [Dual(n, (None,) * max(count, 1)) for n in own]
            given.append([*duals, *self._duals(x)] if a.name == "p" else duals)
        results = derivatives.along(program, x.recorder, given)
        columns: list[Sequence[Number]] = [
            [zero if (s := y.slopes[k]) is None else s for y in results] for k in range(count)]
        return columns, [y.value for y in results]

    def _duals(self, x: FunctionRecording) -> list[Dual[Number]]:
        """All numbers: the chosen ones as zeros, with their directions, the others with their
        values."""
        count, one = len(self._places), x.recorder.number(1)
        results = []
        for n, own in enumerate(self._numbers):
            slopes = tuple(one if n == k else None for k in self._places) or (None,)
            value = x.recorder.number(0 if n in self._places else own.number)
            results.append(Dual(value, slopes if count else (None,)))
        return results

    def _replaced(self, applied: Applied) -> Applied:
        """The effect with parameters in place of its numbers, except those of matrices."""
        signed = {x.name for x in applied.effect.parameters if x.sign}
        constant = {x.name for x in applied.effect.parameters if x.kind == "matrix"}

        def swap(name: str, value: object) -> object:
            if isinstance(value, tuple):
                return tuple(swap(f"{name}.{LETTERS[k]}" if k < 3 else f"{name}.{k}", part)
                             for k, part in enumerate(value))
            if not isinstance(value, Scalar):
                return value
            full = f"{applied.name}.{name}"
            exact = value.value if isinstance(value, Parameter) else value
            self._numbers.append(LinearParameter(full, "", value, name in signed))
            return Parameter(full, self._first + len(self._numbers) - 1, exact)

        values: Mapping[str, Setting] = {
            name: value if name in constant else swap(name, value)  # type: ignore[misc]
            for name, value in applied.values.items()}
        return replace(applied, values=values)

    def _program(self, x: FunctionRecording) -> Program:
        """The torques that joints must supply against effects and joints' inertias."""
        inputs = [a for a in x.recorder.inputs if a.name in ("t", "q", "v", "a")]
        recorder = Recorder([*inputs, array("p", (self._first + len(self._numbers),))])
        own = FunctionRecording(self._scene, self._tree, self._names, recorder)
        with recorder.part("tau"):
            motion = own.motion()
            applied = AppliedEffects(self._scene, motion).act()
            none = (*motion.zero, *motion.zero)
            wrenches = [subtract(none, applied.force(n)) for n in range(len(self._tree.links))]
            torques = rnea.joint_torques(
                motion, rnea.transmitted(motion, wrenches), applied, own.inertias)
            return recorder.program("torques", [(array("tau", (self._tree.nv,)), torques)])

    # the choice

    @property
    def _nq(self) -> int:
        return self._tree.nq + count_of(states_of(self._scene))

    def _chosen(self) -> tuple[int, ...]:
        """The places of numbers on which the torques depend linearly, all together."""
        nv = (self._tree.nv,)
        recorder = Recorder([array("t", ()), array("q", (self._nq,)), array("v", nv),
                             array("a", nv)])
        program = self._program(
            FunctionRecording(self._scene, self._tree, self._names, recorder))
        deciding = _deciding(program)
        slopes = self._slopes(program)
        chosen: list[int] = []
        for k in range(len(self._numbers)):
            needs = slopes[k]
            if needs is None or self._first + k in deciding or needs & {
                    self._first + j for j in (*chosen, k)}:
                continue
            if not any(self._first + k in (slopes[j] or ()) for j in chosen):
                chosen.append(k)
        return tuple(chosen)

    def _slopes(self, program: Program) -> list[set[int] | None]:
        """The elements of p that the slope along each number depends on; None where it is zero."""
        count, recorder = len(self._numbers), Recorder(program.inputs)
        one = recorder.number(1)
        given = []
        for a in program.inputs:
            first = self._first if a.name == "p" else a.quantity.size
            given.append([Dual(n, tuple(one if i - first == k else None for k in range(count)))
                          for i, n in enumerate(recorder.argument(a.name))])
        results = derivatives.along(program, recorder, given)
        with_slopes = []
        for k in range(count):
            own = [y.slopes[k] for y in results]
            with_slopes.append([x for x in own if x is not None and not x.is_zero])
        outputs = [(array(f"s{k}", (len(own),)), own) for k, own in enumerate(with_slopes)]
        derived = recorder.program("slopes", outputs)
        needs, places = _needs(derived), iter(derived.results)
        return [set().union(*(_of(next(places), needs, derived) for _ in own)) if own else None
                for own in with_slopes]


def _needs(program: Program) -> dict[str, frozenset[int]]:
    """The elements of p that each instruction depends on."""
    needs: dict[str, frozenset[int]] = {}
    for step in program.instructions:
        needs[step.name] = frozenset().union(*(_of(x, needs, program) for x in step.operands))
    return needs


def _of(x: Operand, needs: Mapping[str, frozenset[int]], program: Program) -> frozenset[int]:
    if isinstance(x, Ref):
        return needs[x.name]
    if isinstance(x, Input) and program.inputs[x.argument].name == "p":
        return frozenset((x.index,))
    return frozenset()


def _deciding(program: Program) -> set[int]:
    """The elements of p on which choices depend."""
    needs = _needs(program)
    return {k for step in program.instructions if step.op in (Op.LESS, Op.EQUAL)
            for k in needs[step.name]}
