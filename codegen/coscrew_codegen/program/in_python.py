"""Turns a Program into a Python function, for any kind of numbers; defines Python's floats as one
kind."""

import math
import operator
from collections import ChainMap
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

import numpy as np

from coscrew_codegen.program.interpreter import Arithmetic, by_operation, exactly, number_of
from coscrew_codegen.program.ops import COMPARISONS, POLYNOMIAL, Op
from coscrew_codegen.program.program import Input, Operand, Program, Ref
from coscrew_codegen.program.text_module import imported

V = TypeVar("V")
_INFIX: dict[Callable[..., Any], str] = {
    operator.add: "+", operator.sub: "-", operator.mul: "*", operator.truediv: "/",
    operator.lt: "<", operator.eq: "=="}


def in_python(program: Program, arithmetic: Arithmetic[V]
              ) -> Callable[[Sequence[Sequence[V]]], list[V]]:
    """Returns a function with the results of `interpreter`'s, several times as fast; making it
    takes as long as interpreting about ten states."""
    used = (*(x for step in program.instructions for x in step.operands), *program.results)
    inputs = {x: f"x{n}" for n, x in enumerate(
        dict.fromkeys(x for x in used if isinstance(x, Input)))}
    others: dict[Operand, str] = {x: f"c{n}" for n, x in enumerate(
        dict.fromkeys(x for x in used if not isinstance(x, Input | Ref)))}
    refs = {Ref(step.name): f"y{n}" for n, step in enumerate(program.instructions)}
    names: Mapping[Operand, str] = ChainMap[Any, str](refs, inputs, others)
    known: dict[str, Any] = {
        name: number_of(x, program, arithmetic) for x, name in others.items()}
    lines = [f"{name} = given[{x.argument}][{x.index}]" for x, name in inputs.items()]
    for n, step in enumerate(program.instructions):
        function = arithmetic.function(step, n)
        operands = [names[x] for x in step.operands]
        infix = _INFIX.get(function)
        known[f"f{n}"] = function
        lines.append(f"y{n} = {f' {infix} '.join(operands)}" if infix else
                     f"y{n} = f{n}({', '.join(operands)})")
    lines.append(f"return [{', '.join(names[x] for x in program.results)}]")
    module = imported(program.name, "def function(given):\n " + "\n ".join(lines), known)
    made: Callable[[Sequence[Sequence[V]]], list[V]] = module.function
    return made


def _as_float(function: Callable[..., Any]) -> Callable[..., float]:
    return lambda *x: float(function(*x))


_BY_PYTHON = POLYNOMIAL | COMPARISONS | {Op.ABS, Op.SELECT}  # NumPy's numbers take longer
_EXACTLY: Mapping[Op, Callable[..., Any]] = {**exactly(np), Op.DIV: np.divide}
FLOATS: Arithmetic[float] = by_operation(
    lambda x: float(x.double),
    {op: function if op in _BY_PYTHON else _as_float(function)
     for op, function in _EXACTLY.items()}, math.nan)
"""Python's floats, that divide by zero and overflow as C's do (NumPy may warn)."""
