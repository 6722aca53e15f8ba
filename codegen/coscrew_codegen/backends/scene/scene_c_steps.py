"""Steps of a scene's integrators in C: calls, the variables they write to, and loops over parts."""

from collections.abc import Callable, Sequence

from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.backends.c.c_function import FunctionBody, Stored
from coscrew_codegen.backends.c.c_nested import language
from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.nesting import planned
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene.scene_text import (
    access,
    outputs,
    size,
    step_inputs,
    step_shapes,
)
from coscrew_codegen.program.scene_functions import Call, IntegratorStep, SceneFunctions, Split
from coscrew_codegen.program.values.formats import DOUBLE, Precision

_WIDTH = 98  # of a statement, which is indented


def step_body(scene: SceneFunctions, step: IntegratorStep, precision: Precision,
              c_name: Callable[[str], str]) -> str:
    """The body of a function that takes `step_inputs` and moves q and v in place."""
    return _Body(scene, step, precision, c_name).text()


def begun() -> str:
    """The function of the time at which step k of a run begins, in double for all precisions."""
    return f"static double begun(double t, double h, double k) {{\n{body_of_begun(DOUBLE)}\n}}"


def body_of_begun(precision: Precision) -> str:
    """Its body, in this precision."""
    recorder = Recorder([array(x, ()) for x in ("t", "h", "k")])
    (t,), (h,), (k,) = (recorder.argument(x) for x in ("t", "h", "k"))
    with recorder.part("at"):
        program = recorder.program("begun", [(array("begun", ()), [t + k * h])])
    plan = planned(program, language(program, precision), access(program), WIDTH)
    return FunctionBody(program, precision, Stored(access(program), ("",), (), "begun"),
                        plan).text()


class _Body:
    def __init__(self, scene: SceneFunctions, step: IntegratorStep, precision: Precision,
                 c_name: Callable[[str], str]):
        self.scene, self.step, self.c_name = scene, step, c_name
        self.real, self.precision = precision.c_type, precision
        self.inputs = step_inputs(scene, step.takes_tau)
        self.scalars = {"t", "h"} & set(self.inputs)

    def text(self) -> str:
        """The statements, indented."""
        shapes = self._shapes()
        self.scalars |= {name for name, length in shapes.items() if not length}
        split = next((x for x in self.step.body if isinstance(x, Split)), None)
        own = {x for call in split.first for x in call.results} if split else set()
        declared = [f"{name}[{length}]" if length else name
                    for name, length in shapes.items() if name not in own]
        return render(
            "scene/step.c", real=self.real, f=self.precision.suffix, lanes=self.precision.lanes,
            unused=[x for x in self.inputs if x in ("t", "p") and not self._read(x)],
            zeros=[f"{x}[{self.scene.nv}]" for x in self.step.zeros],
            rooms=listed(f"{self.real} ", declared, ";", _WIDTH).replace("\n", "\n  "),
            declared=bool(declared), statements=list(map(self._statement, self.step.body)),
        ).rstrip("\n")

    def _shapes(self) -> dict[str, int]:
        """The variables other than the inputs, and their lengths; 0 for numbers."""
        shapes: dict[str, int] = {}
        for call in self.step.calls:
            of = outputs(self.scene.named(call.function))
            for name, a in zip(call.results, of, strict=True):
                if name not in self.inputs:
                    shapes[name] = size(a) if a.quantity.shape else 0
        return shapes

    def _read(self, name: str) -> bool:
        return any(name in self._arguments(call) for call in self.step.calls)

    def _arguments(self, call: Call) -> list[str]:
        given = dict(call.given)
        return [given.get(a.name, a.name) for a in self.scene.named(call.function).program.inputs]

    def _statement(self, statement: Call | Split) -> dict[str, object]:
        """The values for the template."""
        if isinstance(statement, Call):
            return {"call": self._call(statement)}
        test, (count, part) = statement.test, statement.parts.results
        return {"call": "", "test": test and test.results[0], "count": count, "part": part,
                "tested": test and self._call(test), "parted": self._call(statement.parts),
                "calls": [self._call(x) for x in statement.calls],
                "numbers": [x for x in statement.moved if x in self.scalars],
                "arrays": self._arrays([x for x in statement.moved if x not in self.scalars])}

    def _arrays(self, names: Sequence[str]) -> list[tuple[str, int]]:
        """Names and lengths."""
        shapes = step_shapes(self.scene)
        return [(x, shapes[x][0]) for x in names]

    def _call(self, call: Call) -> str:
        results = [f"&{x}" if x in self.scalars else x for x in call.results]
        return f"{self.c_name(call.function)}({', '.join((*self._arguments(call), *results))});"
