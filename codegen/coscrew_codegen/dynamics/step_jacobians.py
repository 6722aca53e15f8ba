"""Derivatives of steps of integrators with respect to the state, to torques of joints and to
run-time parameters: the chain rule over the functions that they call.

Coordinates are differentiated along velocities, before the step and after it: of q ⊕ φ.  The
accelerations of forward dynamics have their own derivatives, J.  Where no effect is damped or
stiff, implicit accelerations are those of forward dynamics, and the kick of the default integrator
is two of them:

    a' = f(q, v),   a = f(q, v + h/2 a'),   ∂a = J_q ∂q + J_v (∂v + h/2 ∂a') + J_tau ∂tau.

Accelerations that are implicit in damping and stiffness at joints have derivatives by the rule of
implicit functions.  All others, those of scenes whose effects have states, and all other functions,
are differentiated as Programs."""

from collections.abc import Sequence
from itertools import accumulate, pairwise
from typing import Protocol

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.dynamics import implicit_derivatives
from coscrew_codegen.dynamics.algorithms import coordinates, kicks
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.dynamics.inlined_steps import taken
from coscrew_codegen.program import Input, Program
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.scene.effect_quantities import count_of, states_of
from coscrew_codegen.scene.function_selection import FunctionsError
from coscrew_codegen.scene.scene_function import Results, SceneFunction

BY = ("q", "v", "tau", "p")
"""The inputs by which steps are differentiated."""
MOST = 600_000
"""Largest number of derivatives of instructions, of functions that are differentiated as Programs
along all directions: about 30 MB of C in each precision."""
Duals = Sequence[Dual[Number]]
_EXPLICIT, _KICK = "forward_dynamics", "midpoint_acceleration"
_IMPLICIT = "implicit_acceleration"


class OtherFunctions(Protocol):
    """Other functions of the scene as Programs."""

    def program(self, function: SceneFunction) -> Program:
        """A function, also a step, as one program."""

    def step_of(self, function: SceneFunction) -> SceneFunctions:
        """A step and the functions that it calls."""

    def named(self, name: str) -> Program:
        """The function of this name."""


def of_step(x: FunctionRecording, step: SceneFunction, others: OtherFunctions) -> Results:
    """q, v, and the derivatives of both by q and v, by tau and by p, row by row; those of effects'
    states stand behind those of velocities by q."""
    given = step.inputs_in(x.scene)
    widths = {name: _width(x, name) for name in BY if any(a.name == name for a in given)}
    still: tuple[Number | None, ...] = (None,) * sum(widths.values())
    with x.recorder.part("derivatives"):
        known = taken(others.step_of(step), {a.name: _seeded(x, a.name, widths) for a in given},
                      Dual(x.recorder.number(0), still), _Chain(x, step, others).evaluate)
        columns = [[*_velocities(x, known["q"], k), *_slopes(x, known["v"], k)]
                   for k in range(len(still))]
    size = widths["q"] + widths["v"]
    parts = pairwise((0, *accumulate((size, *list(widths.values())[2:]))))
    return [*([y.value for y in known[name]] for name in "qv"),
            *([column[i] for i in range(size) for column in columns[a:b]] for a, b in parts)]


def _width(x: FunctionRecording, name: str) -> int:
    """The number of directions by an input."""
    if name == "q":
        return x.tree.nv + count_of(states_of(x.scene))
    return len(x.scene.parameters) if name == "p" else x.tree.nv


def _seeded(x: FunctionRecording, name: str, widths: dict[str, int]) -> Duals:
    """An input's components with their derivatives along all directions."""
    numbers, count = x.recorder.argument(name), sum(widths.values())
    if name not in widths:
        return [Dual(n, (None,) * count) for n in numbers]
    one, width = x.recorder.number(1), widths[name]
    rows: list[list[Number | None]]
    rows = [[one if i == j else None for j in range(width)] for i in range(width)]
    if name == "q":
        rows = coordinates.chart(x.motion(moving=False, accelerating=False), states=True)
    before = sum(w for other, w in widths.items() if BY.index(other) < BY.index(name))
    return [Dual(n, (*[None] * before, *row, *[None] * (count - before - width)))
            for n, row in zip(numbers, rows, strict=True)]


def _slopes(x: FunctionRecording, y: Duals, k: int) -> list[Number]:
    """The derivatives along a direction."""
    return [x.recorder.number(0) if (s := dual.slopes[k]) is None else s for dual in y]


def _velocities(x: FunctionRecording, q: Duals, k: int) -> list[Number]:
    """The velocities at which coordinates change along a direction."""
    if all(dual.slopes[k] is None for dual in q):
        return [x.recorder.number(0)] * _width(x, "q")
    return coordinates.velocities(x.recorder, x.tree, x.names, [dual.value for dual in q],
                                  _slopes(x, q, k))


class _Chain:
    """Evaluates the functions that a step calls on numbers with derivatives."""

    def __init__(self, x: FunctionRecording, step: SceneFunction, others: OtherFunctions):
        self.x, self.step, self.others, self.size = x, step, others, 0

    def evaluate(self, function: FunctionProgram, given: Sequence[Duals]) -> Duals:
        """The components of the results."""
        name = function.name.removesuffix("_tau")
        slopes = None
        if name in (_EXPLICIT, _IMPLICIT, _KICK) and not states_of(self.x.scene):
            inputs = {a.name: y for a, y in zip(function.program.inputs, given, strict=True)}
            if name == _EXPLICIT or self._explicit():
                if name == _KICK:
                    inputs["v"] = self._half_kicked(inputs)
                slopes = self._accelerating(inputs)
            elif program := self._implicit(name, function.program):
                slopes = self._combined(_matrices(program, self.x.recorder.replay(
                    program, *map(_values, given))), inputs)
        if slopes is None:
            program = self.x.recorder.form(function.program)
            self._refuse_many(len(program.instructions) * len(given[0][0].slopes))
            return derivatives.along(program, self.x.recorder, given)
        values = self.x.recorder.replay(function.program, *map(_values, given))
        return [Dual(y, row) for y, row in zip(values, slopes, strict=True)]

    def _refuse_many(self, more: int) -> None:
        """Raises FunctionsError once more instructions are differentiated than compilers take."""
        self.size += more
        if self.size > MOST:
            own = self.step.name
            raise FunctionsError(
                f"{self.x.scene.name}: {own}_derivatives is too long for compilers, with more than "
                f"{MOST:,} derivatives of instructions; wanted {own}_tangent, a column of A for "
                f"each direction, or {own}_adjoint, a row for each weight")

    def _implicit(self, name: str, acceleration: Program) -> Program | None:
        """The derivatives of an implicit acceleration, where the rule of implicit functions gives
        them."""
        x, kicked = self.x, name == _KICK
        recording = FunctionRecording(x.scene, x.tree, x.names, Recorder(acceleration.inputs))
        return implicit_derivatives.program(
            recording, kicks.weights if kicked else kicks.end_weights, 2 if kicked else 1)

    def _explicit(self) -> bool:
        """True if no effect is damped or stiff: implicit accelerations do not depend on h."""
        program = self.others.named(_IMPLICIT)
        h = next((n for n, a in enumerate(program.inputs) if a.name == "h"), None)
        return all(not (isinstance(y, Input) and y.argument == h)
                   for step in program.instructions for y in step.operands)

    def _half_kicked(self, inputs: dict[str, Duals]) -> Duals:
        """v + h/2 f(q, v)."""
        (h,), v = _values(inputs["h"]), inputs["v"]
        values = self.x.recorder.replay(self.others.named(_EXPLICIT), *self._state(inputs))
        return [Dual(y.value + h / 2 * a, tuple(
            s if more is None else h / 2 * more if s is None else s + h / 2 * more
            for s, more in zip(y.slopes, slopes, strict=True)))
            for y, a, slopes in zip(v, values, self._accelerating(inputs), strict=True)]

    def _accelerating(self, inputs: dict[str, Duals]) -> list[tuple[Number | None, ...]]:
        """The derivatives of forward dynamics along all directions, by component."""
        program = self.others.named(f"{_EXPLICIT}_derivatives")
        of = _matrices(program, self.x.recorder.replay(program, *self._state(inputs)))
        by_p = self._by_parameters(inputs)
        slopes = self._combined(of, {name: y for name, y in inputs.items() if name != "p"})
        if not by_p:
            return slopes
        return [tuple(b if a is None else a if b is None else a + b
                      for a, b in zip(row, y.slopes, strict=True))
                for row, y in zip(slopes, by_p, strict=True)]

    def _combined(self, of: dict[str, list[Sequence[Number]]], inputs: dict[str, Duals]
                  ) -> list[tuple[Number | None, ...]]:
        """Σ J d of the derivatives J by inputs that have directions d, by component."""
        x = self.x
        given = {name: inputs[name] for name in of if name in inputs}
        columns = []
        for k in range(len(inputs["v"][0].slopes)):
            parts = [_velocities(x, y, k) if name == "q" else _slopes(x, y, k)
                     for name, y in given.items()]
            columns.append([_sum([of[name][i] for name in given], parts)
                            for i in range(x.tree.nv)])
        return list(zip(*columns, strict=True))

    def _by_parameters(self, inputs: dict[str, Duals]) -> Duals:
        """Forward dynamics with its derivatives by run-time parameters at a fixed state."""
        if "p" not in inputs:
            return ()
        program = self.others.named(_EXPLICIT)
        numbers = dict(zip((a.name for a in program.inputs), self._state(inputs), strict=True))
        still = (None,) * len(inputs["p"][0].slopes)
        return derivatives.along(self.x.recorder.form(program), self.x.recorder, [
            inputs["p"] if a.name == "p" else [Dual(y, still) for y in numbers[a.name]]
            for a in program.inputs])

    def _state(self, inputs: dict[str, Duals]) -> list[Sequence[Number]]:
        """The values of forward dynamics' inputs: tau is zero where the step does not take it."""
        zeros = [self.x.recorder.number(0)] * self.x.tree.nv
        return [_values(inputs[a.name]) if a.name in inputs else zeros
                for a in self.others.named(_EXPLICIT).inputs]


def _values(y: Duals) -> list[Number]:
    return [dual.value for dual in y]


def _matrices(program: Program, entries: Sequence[Number]) -> dict[str, list[Sequence[Number]]]:
    """The rows of the derivatives by each input: da_dv, of v."""
    results, first = {}, 0
    for a in program.outputs:
        rows, width = a.quantity.shape
        results[a.name.removeprefix("da_d")] = [
            entries[first + i * width:first + (i + 1) * width] for i in range(rows)]
        first += rows * width
    return results


def _sum(row: Sequence[Sequence[Number]], parts: Sequence[Sequence[Number]]) -> Number | None:
    """J_q dq + J_v dv + J_tau dtau + …; None if that is zero."""
    total = None
    for entries, slopes in zip(row, parts, strict=True):
        for entry, slope in zip(entries, slopes, strict=True):
            if not (product := entry * slope).is_zero:
                total = product if total is None else total + product
    return total
