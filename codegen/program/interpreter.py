"""The interpreter of Programs, on whatever numbers: floats, arrays, 50 digits, fractions, series.

A kind of numbers is an Arithmetic: its constants, and what each operation does.
"""

import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from coscrew_codegen.program.ops import Op
from coscrew_codegen.program.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Operand,
    Program,
)

V = TypeVar("V")


@dataclass(frozen=True)
class Arithmetic(Generic[V]):
    """A kind of numbers.  `apply` gets an instruction, its number in the program and its operands'
    values."""

    constant: Callable[[Constant], V]
    apply: Callable[[Instruction, int, Sequence[V]], V]
    not_a_number: V | None = None


def evaluate(program: Program, inputs: Sequence[Sequence[V]],
             arithmetic: Arithmetic[V]) -> list[V]:
    """The results' components for the components of each input."""
    known: dict[str, V] = {}

    def value(x: Operand) -> V:
        if isinstance(x, Input):
            return inputs[x.argument][x.index]
        if isinstance(x, Constant):
            return arithmetic.constant(x)
        if isinstance(x, NotANumber):
            if arithmetic.not_a_number is None:
                raise TypeError(f"{program.name} may have no value, which these numbers lack")
            return arithmetic.not_a_number
        return known[x.name]

    for number, step in enumerate(program.instructions):
        known[step.name] = arithmetic.apply(step, number, [value(x) for x in step.operands])
    return [value(x) for x in program.results]


def by_operation(constant: Callable[[Constant], V], operations: Mapping[Op, Callable[..., V]],
                 not_a_number: V | None = None) -> Arithmetic[V]:
    """Numbers that a table of functions computes with."""
    return Arithmetic(constant, lambda step, _, operands: operations[step.op](*operands),
                      not_a_number)


def exactly(functions: object) -> Mapping[Op, Callable]:
    """Every operation without its rounding: by operators, and by the module's sqrt, sin, cos, exp,
    tanh, atan2 (math, mpmath, numpy)."""
    return _OPERATORS | {op: getattr(functions, op.value) for op in _FUNCTIONS
                         if hasattr(functions, op.value)}


_FUNCTIONS = (Op.SQRT, Op.SIN, Op.COS, Op.ATAN2, Op.EXP, Op.TANH)
_OPERATORS: Mapping[Op, Callable] = {
    Op.ADD: operator.add, Op.SUB: operator.sub, Op.MUL: operator.mul, Op.DIV: operator.truediv,
    Op.NEG: operator.neg, Op.ABS: abs, Op.SCALE: operator.mul,
    Op.FMA: lambda a, b, c: a * b + c, Op.FMS: lambda a, b, c: a * b - c,
    Op.FNMA: lambda a, b, c: c - a * b,
    Op.EXACT_ADD: operator.add, Op.EXACT_SUB: operator.sub,
    Op.PRODUCT_ERROR: lambda a, b, p: a * b - p, Op.PRODUCT_REST: lambda a, b, p, h: a * b - h,
    Op.LESS: operator.lt, Op.EQUAL: operator.eq, Op.SELECT: lambda a, b, c: b if a else c}
