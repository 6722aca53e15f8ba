"""Derivatives of a scene's functions along one direction, and of one weighted sum of their results.

Directions of coordinates are velocities: the derivatives are those of q ⊕ φ.  Directions and
weights of results that are coordinates are velocities, too.  Those of effects' states, the end of
q, stand behind them."""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.dynamics.algorithms import coordinates
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.program import Program
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.scene.scene_function import Array, Numbers, Results, SceneFunction


def tangent(x: FunctionRecording, function: SceneFunction, program: Program) -> Results:
    """The results and, for inputs d_, their derivatives."""
    duals = []
    for a in function.inputs_in(x.scene):
        numbers = x.recorder.argument(a.name)
        direction: Numbers = x.recorder.argument(f"d_{a.name}")
        if a.is_coordinates:
            with x.recorder.part("rates", a.name):
                direction = coordinates.rates(_at(x, numbers), direction)
        duals.append([Dual(n, (d,)) for n, d in zip(numbers, direction, strict=True)])
    with x.recorder.part("tangent"):
        result = derivatives.along(x.recorder.form(program), x.recorder, duals)
    zero = x.recorder.number(0)
    values = _outputs(program, [y.value for y in result])
    slopes = _outputs(program, [zero if (s := y.slopes[0]) is None else s for y in result])
    return [*values, *(_velocities(x, a, y, rate) for a, y, rate in zip(
        function.outputs, values, slopes, strict=True))]


def adjoint(x: FunctionRecording, function: SceneFunction, program: Program) -> Results:
    """The results and, for weights w_ of them, the derivatives of their sum by each input."""
    program = x.recorder.form(program)
    given = function.inputs_in(x.scene)
    numbers = [x.recorder.argument(a.name) for a in given]
    names = [f"w_{a.name}" for a in function.outputs_in(x.scene)]
    weights = [w for name, a, y in zip(names, function.outputs, _outputs(
        program, x.recorder.replay(program, *numbers)), strict=True)
        for w in _weights(x, a, y, x.recorder.argument(name))]
    with x.recorder.part("adjoint"):
        values, slopes = derivatives.weighted(program, x.recorder, numbers, weights)
    return [*_outputs(program, values), *(
        _along(x, a, n, slope) for a, n, slope in zip(given, numbers, slopes, strict=True))]


def _outputs(program: Program, numbers: Sequence[Number]) -> list[Numbers]:
    """The components of each output."""
    results, first = [], 0
    for a in program.outputs:
        results.append(numbers[first:first + a.quantity.size])
        first += a.quantity.size
    return results


def _at(x: FunctionRecording, q: Numbers) -> Motion:
    """The links at these coordinates."""
    return x.motion(at=(q, x.recorder.numbers([0] * x.tree.nv)))


def _velocities(x: FunctionRecording, a: Array, y: Numbers, rate: Numbers) -> Numbers:
    """Rates of a result; of coordinates, the velocities."""
    if not a.is_coordinates:
        return rate
    return coordinates.velocities(x.recorder, x.tree, x.names, y, rate)


def _weights(x: FunctionRecording, a: Array, y: Numbers, weight: Numbers) -> Numbers:
    """Weights of a result's components; of coordinates, the velocities' transposed."""
    if not a.is_coordinates:
        return weight
    count = len(y)
    columns = [coordinates.velocities(x.recorder, x.tree, x.names, y, x.recorder.numbers(
        [int(i == k) for i in range(count)])) for k in range(count)]
    with x.recorder.part("weights", a.name):
        return [_product(weight, column) for column in columns]


def _along(x: FunctionRecording, a: Array, numbers: Numbers, slopes: Numbers) -> Numbers:
    """Derivatives by an input's components; of coordinates, along velocities."""
    if not a.is_coordinates:
        return slopes
    zero = x.recorder.number(0)
    with x.recorder.part("chart", a.name):
        rows = coordinates.chart(_at(x, numbers), states=True)
        return [_product(slopes, [zero if y is None else y for y in column])
                for column in zip(*rows, strict=True)]


def _product(a: Sequence[Number], b: Sequence[Number]) -> Number:
    total = a[0].like(0)
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total
