"""Programs of derivatives: the tangent and the adjoint of any Program, recorded and folded."""

from coscrew_codegen.program import Program, differentiate
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.quantity import Argument
from coscrew_codegen.recording import numbers
from coscrew_codegen.recording.numbers import Number
from coscrew_codegen.recording.recorder import Recorder, array


def tangent(program: Program) -> Program:
    """The Program from inputs x and directions x' to the outputs y and y' = ∂y/∂x x'. The names of
    x' and y' are those of x and y with the prefix d_."""
    recorder = Recorder((*program.inputs, *map(_derivative, program.inputs)))
    given = [[Dual(x, (slope,)) for x, slope in zip(
        recorder.argument(a.name), recorder.argument(_derivative(a).name), strict=True)]
        for a in program.inputs]
    with recorder.part("tangent"):
        found = differentiate.tangent(program, recorder.arithmetic, numbers, given)
    values = [x.value for x in found]
    slopes = [recorder.number(0) if x.slopes[0] is None else x.slopes[0] for x in found]
    return recorder.program(f"{program.name}_tangent", [
        *_of(program.outputs, values), *_of(tuple(map(_derivative, program.outputs)), slopes)])


def adjoint(program: Program) -> Program:
    """The Program from inputs x and weights w of the outputs y to y and the derivatives of w·y by
    x, w ∂y/∂x.  The names of weights and derivatives are those of y and x with the prefix d_."""
    recorder = Recorder((*program.inputs, *map(_derivative, program.outputs)))
    given = [recorder.argument(a.name) for a in program.inputs]
    weights = [w for a in program.outputs for w in recorder.argument(_derivative(a).name)]
    with recorder.part("adjoint"):
        values, found = differentiate.adjoint(program, recorder.arithmetic, numbers, given, weights)
    slopes = [recorder.number(0) if x is None else x for row in found for x in row]
    return recorder.program(f"{program.name}_adjoint", [
        *_of(program.outputs, values), *_of(tuple(map(_derivative, program.inputs)), slopes)])


def _derivative(argument: Argument) -> Argument:
    return array(f"d_{argument.name}", argument.quantity.shape)


def _of(arguments: tuple[Argument, ...], components: list[Number]
        ) -> list[tuple[Argument, list[Number]]]:
    found, first = [], 0
    for argument in arguments:
        last = first + argument.quantity.size
        found.append((argument, components[first:last]))
        first = last
    return found
