"""Sensitivity of a function's results to the rounding of each intermediate result, to first order,
in units of the requested accuracy."""

from collections.abc import Iterator, Sequence

import numpy as np

from coscrew_codegen.accuracy.precision_tuning.array_evaluation import Array, arrays
from coscrew_codegen.accuracy.tiers.compensated import rest_of
from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref, scales
from coscrew_codegen.program.differentiate import adjoint
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE
from coscrew_codegen.program.values.quantity import Argument, Quantity

Place = tuple[str, int]
"""An operand of an instruction, by its number; the number OWN is the instruction's result."""
OWN = -1
_STATES = 16  # at once: the adjoints of every place are kept


def sensitivities(program: Program, given: Sequence[Sequence[Array]],
                  tolerances: Sequence[float]) -> dict[Place, float]:
    """The largest |adjoint · value| / tolerance at these states of each place that single precision
    may round; infinite where there is no derivative."""
    places = list(_places(program))
    scaled, result = _scaled(program, places), np.zeros(len(places))
    for first in range(0, len(given[0][0]), _STATES):
        some = [[x[first:first + _STATES] for x in each] for each in given]
        np.maximum(result, _largest(scaled, some, tolerances), out=result)
    return dict(zip(places, result.tolist(), strict=True))


def _places(program: Program) -> Iterator[Place]:
    for step in program.instructions:
        if step.op.rounds:
            for number, x in enumerate(step.operands):
                if isinstance(x, Ref) or isinstance(x, Constant) and rest_of(x, SINGLE):
                    yield step.name, number
            if not scales(step):
                yield step.name, OWN


def _scaled(program: Program, places: Sequence[Place]) -> Program:
    """The program with the value at each place multiplied by an element of a further input."""
    numbers, last = {place: k for k, place in enumerate(places)}, len(program.inputs)
    steps: list[Instruction] = []

    def times(place: Place, x: Operand, step: Instruction, name: str) -> Operand:
        if place not in numbers:
            return x
        factor = Input(last, numbers[place])
        steps.append(Instruction(name, Op.MUL, (x, factor), step.component))
        return Ref(name)

    for step in program.instructions:
        operands = tuple(times((step.name, k), x, step, f"{step.name} operand {k}")
                         for k, x in enumerate(step.operands))
        own = (step.name, OWN) in numbers
        name = f"{step.name} exact" if own else step.name
        steps.append(Instruction(name, step.op, operands, step.component))
        times((step.name, OWN), Ref(name), step, step.name)
    more = Argument("factors", Quantity("factors", (len(places),), (), ""))
    return Program(program.name, (*program.inputs, more), program.outputs, tuple(steps),
                   program.results)


def _largest(scaled: Program, given: Sequence[Sequence[Array]], tolerances: Sequence[float]
             ) -> Array:
    """Returns the largest sensitivity to each intermediate result, over all states and results."""
    numbers = arrays(DOUBLE)
    ones = [np.float64(1)] * scaled.inputs[-1].quantity.size
    weights = list((np.eye(len(tolerances)) / np.array(tolerances))[:, :, None])
    with np.errstate(all="ignore"):
        _, slopes = adjoint(scaled, numbers.arithmetic, numbers, [*given, ones], weights)
    sizes = [0 if x is None else np.max(np.absolute(x)) for x in slopes[-1]]
    return np.array([np.inf if np.isnan(x) else x for x in sizes])
