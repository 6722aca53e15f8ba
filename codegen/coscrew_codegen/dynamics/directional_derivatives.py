"""Derivatives of a scene's functions along one direction, and of one weighted sum of their results.

Directions of coordinates are velocities: the derivatives are those of q ⊕ φ.  Directions and
weights of results that are coordinates are velocities, too.  Those of effects' states, the end of
q, stand behind them."""

from collections.abc import Mapping, Sequence

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.dynamics.algorithms import coordinates
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.program import Program
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.scene.scene_function import Array, Numbers, Results, SceneFunction

Row = Sequence[Number | None]
"""Derivatives by velocities; None is zero."""


def tangent(x: FunctionRecording, function: SceneFunction, program: Program) -> Results:
    """The results and, for inputs d_, their derivatives."""
    program, given = x.recorder.form(program), function.inputs_in(x.scene)
    numbers = [x.recorder.argument(a.name) for a in given]
    x.recorder.replay(program, *numbers)
    duals, known = [], dict[Number, Dual[Number]]()
    for a, n in zip(given, numbers, strict=True):
        direction: Numbers = x.recorder.argument(f"d_{a.name}")
        if a.is_coordinates:
            with x.recorder.part("rates", a.name):
                known |= {y: Dual(y, (_combined(row, direction),))
                          for y, row in coordinates.displacement_chart(_at(x, n)).items()}
                direction = coordinates.rates(_at(x, n), direction)
        duals.append([known.get(y, Dual(y, (d,))) for y, d in zip(n, direction, strict=True)])
    with x.recorder.part("tangent"):
        result = derivatives.along(program, x.recorder, duals, known)
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
    charts = {a.name: _chart(x, n) for a, n in zip(given, numbers, strict=True)
              if a.is_coordinates}
    independent = [y for chart in charts.values() for y in chart]
    with x.recorder.part("adjoint"):
        values, slopes = derivatives.weighted(program, x.recorder, numbers, weights, independent)
    own = dict(zip(independent, slopes.pop() if independent else (), strict=True))
    return [*_outputs(program, values), *(
        _along(x, a, charts[a.name], own) if a.is_coordinates else slope
        for a, slope in zip(given, slopes, strict=True))]


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
        return [_combined(column, weight) for column in columns]


def _chart(x: FunctionRecording, q: Numbers) -> dict[Number, Row]:
    """Derivatives by velocities of coordinates, and of the displacements that these determine."""
    with x.recorder.part("chart"):
        motion = _at(x, q)
        displacements = coordinates.displacement_chart(motion)
        rows = coordinates.chart(motion, states=True)
        return {**dict(zip(q, rows, strict=True)), **displacements}


def _along(x: FunctionRecording, a: Array, chart: Mapping[Number, Row],
           slopes: Mapping[Number, Number]) -> Numbers:
    """Derivatives by velocities, from those by the numbers of the chart: Σ slope · row."""
    with x.recorder.part("chart", a.name):
        weights = [slopes[y] for y in chart]
        return [_combined(column, weights) for column in zip(*chart.values(), strict=True)]


def _combined(row: Row, numbers: Numbers) -> Number:
    """Σ row · numbers, where None is zero."""
    total = numbers[0].like(0)
    for x, y in zip(row, numbers, strict=True):
        if x is not None:
            total = total + x * y
    return total
