"""Steps of a scene's integrators in Python: calls, and rounds over parts of steps."""

from coscrew_codegen.backends.render import render
from coscrew_codegen.program.scene_functions import (
    Call,
    FunctionProgram,
    IntegratorStep,
    SceneFunctions,
    Split,
)


def python_name(function: FunctionProgram) -> str:
    """arm.double.integrated; internal ones are private."""
    return f"_{function.name}" if function.internal else function.name


def step_lines(scene: SceneFunctions, step: IntegratorStep) -> list[str]:
    """The statements of a function that takes `step_inputs` as arrays and returns q and v."""
    def call(x: Call) -> str:
        function, given = scene.named(x.function), dict(x.given)
        arguments = ", ".join(given.get(a.name, a.name) for a in function.program.inputs)
        return f"{', '.join(x.results)} = {python_name(function)}({arguments})"

    def statement(x: Call | Split) -> dict[str, object]:
        if isinstance(x, Call):
            return {"call": call(x)}
        (count, part), test = x.parts.results, x.test
        return {"call": "", "test": test and test.results[0], "count": count, "part": part,
                "tested": test and call(test),
                "parted": call(x.parts), "calls": [call(y) for y in x.calls],
                "moved": ", ".join(x.moved)}

    text = render("scene/step.py", zeros=step.zeros, statements=list(map(statement, step.body)))
    return text.rstrip("\n").split("\n")
