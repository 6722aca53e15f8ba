"""Programs of derivatives: the tangent and the adjoint of any Program, recorded and folded.

They are numbers wherever the function has a derivative.  At a root of zero, and for the angle of
(0, 0), where the derivative is infinite or does not exist, it is zero: zero is a subgradient of a
length, and an option that a choice does not take contributes nothing, even if infinite."""

from collections.abc import Mapping, Sequence
from typing import Any

from coscrew_codegen.algebra.recording import numbers
from coscrew_codegen.algebra.recording.choices import Choices
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.program import Instruction, Op, Program, differentiate
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.program.ops import DerivativeFunctions, Slopes
from coscrew_codegen.program.values.quantity import Argument


def tangent(program: Program) -> Program:
    """The Program from inputs x and directions x' to the outputs y and y' = ∂y/∂x x'. The names of
    x' and y' are those of x and y with the prefix d_, or d_d_ if one of those is taken."""
    directions, rates = _derivatives(program, program.inputs, program.outputs)
    recorder = Recorder((*program.inputs, *directions))
    given = [[Dual(x, (slope,)) for x, slope in zip(
        recorder.argument(a.name), recorder.argument(b.name), strict=True)]
        for a, b in zip(program.inputs, directions, strict=True)]
    with recorder.part("tangent"):
        result = along(program, recorder, given)
    values = [x.value for x in result]
    slopes = [recorder.number(0) if x.slopes[0] is None else x.slopes[0] for x in result]
    return recorder.program(f"{program.name}_tangent", [
        *_of(program.outputs, values), *_of(rates, slopes)])


def jacobian(program: Program) -> Program:
    """The Program from inputs x to the derivatives ∂y/∂x of each output by each input, row by row.
    """
    recorder = Recorder(program.inputs)
    numbers_of = [recorder.argument(a.name) for a in program.inputs]
    count, one = sum(map(len, numbers_of)), recorder.number(1)
    places = iter(range(count))
    given = [[Dual(x, tuple(one if i == k else None for i in range(count)))
              for x, k in zip(row, places, strict=False)] for row in numbers_of]
    with recorder.part("jacobian"):
        result = along(program, recorder, given)
    zero, rows, outputs = recorder.number(0), iter(result), list[tuple[Argument, list[Number]]]()
    for y in program.outputs:
        of, first = [next(rows).slopes for _ in range(y.quantity.size)], 0
        for x in program.inputs:
            end = first + x.quantity.size
            outputs.append((array(f"d_{y.name}_d_{x.name}", (y.quantity.size, end - first)), [
                zero if s is None else s for slopes in of for s in slopes[first:end]]))
            first = end
    return recorder.program(f"{program.name}_jacobian", outputs)


def along(program: Program, recorder: Recorder, given: Sequence[Sequence[Dual[Number]]],
          known: Mapping[Number, Dual[Number]] | None = None) -> list[Dual[Number]]:
    """The results on numbers of a recording, with their derivatives along the directions that these
    carry.  `known` gives the derivatives of some intermediate values."""
    return differentiate.tangent(program, recorder.arithmetic, numbers, given, _partials,
                                 _of_root_of_zero, known)


def adjoint(program: Program) -> Program:
    """The Program from inputs x and weights w of the outputs y to y and the derivatives of w·y by
    x, w ∂y/∂x.  The names of weights and derivatives are those of y and x with a prefix, as above.
    """
    weights, gradients = _derivatives(program, program.outputs, program.inputs)
    recorder = Recorder((*program.inputs, *weights))
    given = [recorder.argument(a.name) for a in program.inputs]
    weighed = [w for a in weights for w in recorder.argument(a.name)]
    with recorder.part("adjoint"):
        values, slopes = weighted(program, recorder, given, weighed)
    return recorder.program(f"{program.name}_adjoint", [
        *_of(program.outputs, values), *_of(gradients, [x for row in slopes for x in row])])


def weighted(program: Program, recorder: Recorder, given: Sequence[Sequence[Number]],
             weights: Sequence[Number], independent: Sequence[Number] = ()
             ) -> tuple[list[Number], list[list[Number]]]:
    """The results on numbers of a recording, and the derivatives of their sum with these weights by
    the components of each input; last by `independent` intermediate values, if there are any."""
    choices = Choices(program, recorder)
    values, slopes = differentiate.adjoint(program, choices.arithmetic, numbers, given, weights,
                                           _partials, choices.product, independent)
    return values, [[recorder.number(0) if x is None else x for x in row] for row in slopes]


def _partials(op: Op) -> Slopes | None:
    """Returns the table's partial derivatives, or zero at a root of zero and for the angle of (0,
    0)."""
    return _HERE.get(op, op.meaning.slopes)


def _of_root(f: DerivativeFunctions, x: Number, y: Number) -> tuple[Number, ...]:
    return (numbers.where(numbers.equal(y, 0), 0, 1 / (2 * y)),)


def _of_root_of_zero(step: Instruction, partial: Any, slope: Number) -> Any:
    """The product, or zero at a root of zero, even if the slope overflows."""
    if step.op is not Op.SQRT:
        return slope * partial
    return numbers.where(numbers.equal(partial, 0), 0, slope * partial)


def _of_angle(f: DerivativeFunctions, y: Number, x: Number, angle: Number) -> tuple[Number, ...]:
    """x / (x² + y²) and -y / (x² + y²), computed from quotients by the larger one, since squares
    would overflow or vanish."""
    larger = numbers.maximum(numbers.absolute(x), numbers.absolute(y))
    none = numbers.equal(larger, 0)
    larger = numbers.where(none, 1, larger)
    u, v = x / larger, y / larger
    divisor = larger * numbers.where(none, 1, u * u + v * v)
    return u / divisor, -(v / divisor)


_HERE: dict[Op, Slopes] = {Op.SQRT: _of_root, Op.ATAN2: _of_angle}


def _derivatives(program: Program, *sides: tuple[Argument, ...]
                 ) -> tuple[tuple[Argument, ...], ...]:
    """The arguments of derivatives, with names that the program does not use."""
    taken = {a.name for a in (*program.inputs, *program.outputs)}
    prefix = "d_"
    while any(f"{prefix}{a.name}" in taken for side in sides for a in side):
        prefix += "d_"
    return tuple(tuple(array(f"{prefix}{a.name}", a.quantity.shape) for a in side)
                 for side in sides)


def _of(arguments: tuple[Argument, ...], components: list[Number]
        ) -> list[tuple[Argument, list[Number]]]:
    result, first = [], 0
    for argument in arguments:
        last = first + argument.quantity.size
        result.append((argument, components[first:last]))
        first = last
    return result
