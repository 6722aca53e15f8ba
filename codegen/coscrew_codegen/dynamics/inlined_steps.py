"""Steps of integrators as one Program."""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.program import Program
from coscrew_codegen.program.scene_functions import Call, SceneFunctions, Split
from coscrew_codegen.program.values.quantity import Argument


def inlined(scene: SceneFunctions, inputs: Sequence[Argument]) -> Program:
    """The program from these inputs to q and v of the scene's one step: its calls in order, and of
    a step that is split at limits, those of one part."""
    step, = scene.steps
    recorder = Recorder(inputs)
    known: dict[str, Sequence[Number]] = {a.name: recorder.argument(a.name) for a in inputs}
    known |= {name: recorder.numbers([0] * scene.nv) for name in step.zeros}
    calls = [call for x in step.body for call in (x.calls if isinstance(x, Split) else (x,))]
    if any(isinstance(x, Split) for x in step.body):
        known["part"] = known["h"]
    for call in calls:
        with recorder.part("step", call.function, call.function):
            known |= _called(scene, call, recorder, known)
    return recorder.program(step.name, [(array(name, (len(known[name]),)), known[name])
                                        for name in ("q", "v")])


def _called(scene: SceneFunctions, call: Call, recorder: Recorder,
            known: dict[str, Sequence[Number]]) -> dict[str, Sequence[Number]]:
    """The variables that a call assigns."""
    program, given = scene.named(call.function).program, dict(call.given)
    numbers = recorder.replay(program, *(known[given.get(a.name, a.name)] for a in program.inputs))
    results: dict[str, Sequence[Number]] = {}
    first = 0
    for name, a in zip(call.results, program.outputs, strict=True):
        results[name] = numbers[first:first + a.quantity.size]
        first += a.quantity.size
    return results
