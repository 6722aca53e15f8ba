"""The interpreter of Programs, for any kind of numbers: floats, arrays, fractions, 50 digits, ….

An Arithmetic says how a kind of numbers represents constants and computes each operation.
"""

import math
import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import groupby
from typing import Any, Generic, TypeVar

from coscrew_codegen.program.ops import ERROR_OF, Op
from coscrew_codegen.program.program import Constant, Input, Instruction, Operand, Program, Ref
from coscrew_codegen.program.program import constant as number
from coscrew_codegen.program.tables import TableColumn, index_of
from coscrew_codegen.program.two_over_pi import chunk

V = TypeVar("V")


@dataclass(frozen=True)
class Arithmetic(Generic[V]):
    """A kind of numbers V.

    `constant` converts a constant; `function` returns a callable that computes an instruction,
    given the instruction and its number in the program; `column` makes an operand of a table's
    column, which is itself unless numbers are wrapped."""

    constant: Callable[[Constant], V]
    function: Callable[[Instruction, int], Callable[..., V]]
    not_a_number: V | None = None
    column: Callable[[TableColumn], Any] = lambda x: x


def interpreter(program: Program, arithmetic: Arithmetic[V]
                ) -> Callable[[Sequence[Sequence[V]]], list[V]]:
    """The function from the components of each input to those of the results.

    Raises TypeError for a program with a NaN result if these numbers have no NaN."""
    operands = [x for step in program.instructions for x in step.operands]
    first = list(dict.fromkeys(x for x in (*operands, *program.results) if not isinstance(x, Ref)))
    inputs = [x for x in first if isinstance(x, Input)]
    others = [x for x in first if not isinstance(x, Input)]
    kept = [number_of(x, program, arithmetic) for x in others]
    names = [Ref(step.name) for step in program.instructions]
    places = {x: place for place, x in enumerate((*inputs, *others, *names))}
    steps: list[Any] = [
        (arithmetic.function(step, number), *(places[x] for x in step.operands))
        for number, step in enumerate(program.instructions)]
    alike = [(size - 1, list(block)) for size, block in groupby(steps, len)]
    results = [places[x] for x in program.results]

    def evaluated(given: Sequence[Sequence[V]]) -> list[V]:
        values: list[V] = [*(given[x.argument][x.index] for x in inputs), *kept]
        for operands, block in alike:  # a list of operands for each step takes three times as long
            if operands == 2:
                for function, x, y in block:
                    values.append(function(values[x], values[y]))
            elif operands == 1:
                for function, x in block:
                    values.append(function(values[x]))
            else:
                for function, *xs in block:
                    values.append(function(*[values[x] for x in xs]))
        return [values[place] for place in results]

    return evaluated


def number_of(x: Operand, program: Program, arithmetic: Arithmetic[V]) -> V:
    """A constant of the program, a column, or NaN, as a number.  Raises TypeError if there is no
    NaN."""
    if isinstance(x, Constant):
        return arithmetic.constant(x)
    if isinstance(x, TableColumn):
        made: V = arithmetic.column(x)
        return made
    if arithmetic.not_a_number is None:
        raise TypeError(f"{program.name} may have no value, which these numbers lack")
    return arithmetic.not_a_number


def evaluate(program: Program, inputs: Sequence[Sequence[V]],
             arithmetic: Arithmetic[V]) -> list[V]:
    """The components of the results, from the components of each input."""
    return interpreter(program, arithmetic)(inputs)


def by_operation(constant: Callable[[Constant], V], operations: Mapping[Op, Callable[..., V]],
                 not_a_number: V | None = None) -> Arithmetic[V]:
    """The Arithmetic whose operations are in a table."""
    def gathered(column: TableColumn, index: object) -> V:
        return constant(number(column.at(index)))

    known = {Op.GATHER: gathered} | dict(operations)
    return Arithmetic(constant, lambda step, _: known[step.op], not_a_number)


def exactly(functions: object = None) -> Mapping[Op, Callable[..., V]]:
    """Every operation without rounding: Python's operators, and the sqrt, sin, cos, exp, tanh and
    atan2 of a module (math, mpmath, numpy)."""
    known = {op: getattr(functions, op.value) for op in _FUNCTIONS if hasattr(functions, op.value)}
    return {**_OPERATORS} | known | {error: _difference(known[op]) for op, error in ERROR_OF.items()
                                     if op in known}


def _difference(function: Callable[..., Any]) -> Callable[..., Any]:
    """Turns a function of operands into one of operands and a number: the function's value less
    that number."""
    return lambda *x: function(*x[:-1]) - x[-1]


_FUNCTIONS = (Op.SQRT, Op.SIN, Op.COS, Op.ATAN2, Op.EXP, Op.TANH)
_OPERATORS: Mapping[Op, Callable[..., Any]] = {
    Op.ADD: operator.add, Op.SUB: operator.sub, Op.MUL: operator.mul, Op.DIV: operator.truediv,
    Op.NEG: operator.neg, Op.ABS: abs, Op.SCALE: operator.mul,
    Op.COPYSIGN: lambda a, b: abs(a) if math.copysign(1, b) > 0 else -abs(a),
    Op.POWER: lambda a, b: Fraction(2)**int(a - b),
    Op.TWO_OVER_PI: chunk,
    Op.EXACT_ADD: operator.add, Op.EXACT_SUB: operator.sub,
    Op.PRODUCT_ERROR: lambda a, b, p: a * b - p, Op.PRODUCT_REST: lambda a, b, p, h: a * b - h,
    Op.LESS: operator.lt, Op.EQUAL: operator.eq, Op.SELECT: lambda a, b, c: b if a else c,
    Op.INDEX: index_of}
