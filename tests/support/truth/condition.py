"""Conditions of a Program's results: Σ |adjoint · value| / |result| over all results of roundings
and all constants that are rounded.

u times this is how far the roundings of the plain program can move a result, to first order.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.differentiate import adjoint
from coscrew_codegen.program.interpreter import Arithmetic, by_operation, exactly
from tests.support.scenes.generated_scenes import argument

Array: TypeAlias = NDArray[Any]
ARRAYS: Arithmetic[Any] = by_operation(lambda x: np.float64(float(x.double)), {
    **exactly(np), Op.SELECT: lambda *x: np.where(*x), Op.ATAN2: np.arctan2}, np.float64(np.nan))


class Functions:
    """Functions on arrays that partial derivatives need."""

    sin, cos = staticmethod(np.sin), staticmethod(np.cos)
    less, where = staticmethod(np.less), staticmethod(np.where)


def perturbed(program: Program) -> Program:
    """The program with every rounded result and constant multiplied by an element of a further
    input."""
    rounding = [step.name for step in program.instructions if step.op.rounds]
    constants = dict.fromkeys(x for step in program.instructions for x in step.operands
                              if isinstance(x, Constant) and float(x.double) != x.double)
    place = len(program.inputs)
    numbers = {name: k for k, name in enumerate(rounding)}
    near: dict[Operand, Operand] = {x: Ref(f"constant{k}__") for k, x in enumerate(constants)}
    steps = [Instruction(f"constant{k}__", Op.MUL, (x, Input(place, len(rounding) + k)), "")
             for k, x in enumerate(constants)]
    for step in program.instructions:
        step = step._replace(operands=tuple(near.get(x, x) for x in step.operands))
        if step.name not in numbers:
            steps.append(step)
            continue
        steps += [step._replace(name=f"{step.name}__"), Instruction(
            step.name, Op.MUL, (Ref(f"{step.name}__"), Input(place, numbers[step.name])),
            step.component)]
    return replace(program, inputs=(*program.inputs, argument("by", len(rounding) + len(near))),
                   instructions=tuple(steps))


def conditions(program: Program, inputs: Sequence[Sequence[Array]]) -> list[Array]:
    """The condition of each result, for arrays of states; inf or NaN where there is no derivative.
    """
    changed, count = perturbed(program), len(program.results)
    given: list[Sequence[Any]] = [*inputs, [np.float64(1)] * changed.inputs[-1].quantity.size]
    weights = list(np.eye(count)[:, :, None])  # of result k: 1 in row k, by which adjoints differ
    with np.errstate(all="ignore"):
        results, slopes = adjoint(changed, ARRAYS, Functions(), given, weights)
        total = sum((abs(x) for x in slopes[-1] if x is not None), np.zeros((count, 1)))
        return [size / abs(x) if np.any(size) else np.zeros(1)
                for size, x in zip(total, results, strict=True)]
