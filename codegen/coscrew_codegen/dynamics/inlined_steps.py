"""Steps of integrators without calls: their functions in order, on any kind of numbers."""

from collections.abc import Callable, Mapping, Sequence
from typing import TypeVar

from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.program import Program
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions, Split
from coscrew_codegen.program.values.quantity import Argument

N = TypeVar("N")
Evaluate = Callable[[FunctionProgram, Sequence[Sequence[N]]], Sequence[N]]
"""(function, the components of its inputs) -> those of its outputs."""


def inlined(scene: SceneFunctions, inputs: Sequence[Argument]) -> Program:
    """The program from these inputs to q and v of the scene's one step."""
    recorder = Recorder(inputs)

    def evaluate(function: FunctionProgram, given: Sequence[Sequence[Number]]) -> Sequence[Number]:
        with recorder.part("step", function.name, function.name):
            return recorder.replay(function.program, *given)

    known = taken(scene, {a.name: recorder.argument(a.name) for a in inputs},
                  recorder.number(0), evaluate)
    step, = scene.steps
    return recorder.program(step.name, [(array(name, (len(known[name]),)), known[name])
                                        for name in ("q", "v")])


def taken(scene: SceneFunctions, inputs: Mapping[str, Sequence[N]], zero: N, evaluate: Evaluate[N]
          ) -> dict[str, Sequence[N]]:
    """The variables after the scene's one step from these inputs; of a step that is split at
    limits, after one part."""
    step, = scene.steps
    known = {**inputs, **{name: [zero] * scene.nv for name in step.zeros}}
    for part in step.body:
        if isinstance(part, Split):
            known["part"] = known["h"]
        for call in part.calls if isinstance(part, Split) else (part,):
            function, given = scene.named(call.function), dict(call.given)
            numbers = evaluate(function, [known[given.get(a.name, a.name)]
                                          for a in function.program.inputs])
            first = 0
            for name, a in zip(call.results, function.program.outputs, strict=True):
                known[name] = numbers[first:first + a.quantity.size]
                first += a.quantity.size
    return known
