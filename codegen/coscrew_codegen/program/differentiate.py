"""Derivatives of a Program on any kind of numbers: tangents forward, adjoints backward.

Both use the one interpreter, on numbers that carry derivatives, and the partial derivatives in the
table of operations.  Derivatives are those of the exact operations.  Where a Program compares (|x|,
a choice, a table) they are one-sided; at √0 and 0/0 there is none.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Generic, TypeVar, cast

from coscrew_codegen.program.interpreter import Arithmetic, interpreter
from coscrew_codegen.program.ops import DerivativeFunctions, Op, Slopes
from coscrew_codegen.program.program import Constant, Instruction, Program

V = TypeVar("V")
Partials = Callable[[Op], Slopes | None]
"""Returns an operation's partial derivatives: from the table, or finite ones where those are
infinite."""


def of_table(op: Op) -> Slopes | None:
    """Returns the operation's partial derivatives from the table of instructions."""
    return op.meaning.slopes


Product = Callable[[Instruction, Any, Any], Any]
"""Multiplies an instruction's partial derivative by a derivative."""


def times(step: Instruction, partial: Any, derivative: Any) -> Any:
    """Returns the plain product."""
    return partial * derivative


@dataclass(frozen=True)
class Dual(Generic[V]):
    """A number with its derivative along each direction; None is zero."""

    value: V
    slopes: tuple[V | None, ...]


def tangent(program: Program, arithmetic: Arithmetic[V], functions: DerivativeFunctions,
            inputs: Sequence[Sequence[Dual[V]]], partials_of: Partials = of_table,
            product: Product = times) -> list[Dual[V]]:
    """The results with their derivatives along the directions that the inputs carry."""
    count = len(next(x for given in inputs for x in given).slopes)

    def constant(x: Constant) -> Dual[V]:
        return Dual(arithmetic.constant(x), (None,) * count)

    def function(step: Instruction, number: int) -> Callable[..., Dual[V]]:
        compute, derived = arithmetic.function(step, number), partials_of(step.op)

        def apply(*operands: Dual[V]) -> Dual[V]:
            values = [x.value for x in operands]
            y = compute(*values)
            if step.op is Op.SELECT:
                test, a, b = operands
                return Dual(y, tuple(_chosen(functions, test.value, *pair)
                                     for pair in zip(a.slopes, b.slopes, strict=True)))
            if derived is None or all(s is None for x in operands for s in x.slopes):
                return Dual(y, (None,) * count)
            partials = derived(functions, *values, y)
            return Dual(y, tuple(_along(step, partials, slopes, product) for slopes in zip(
                *(x.slopes for x in operands), strict=True)))

        return apply

    nan = arithmetic.not_a_number
    duals = Arithmetic(constant, function, None if nan is None else Dual(nan, (None,) * count),
                       lambda x: Dual(arithmetic.column(x), (None,) * count))
    return interpreter(program, duals)(inputs)


def _chosen(functions: DerivativeFunctions, test: V, a: V | None, b: V | None) -> V | None:
    if a is None and b is None:
        return None
    chosen: V = functions.where(test, 0 if a is None else a, 0 if b is None else b)
    return chosen


def _along(step: Instruction, partials: Sequence[Any], slopes: Sequence[V | None],
           product: Product) -> V | None:
    """Σ ∂y/∂x_i x_i'."""
    total: Any = None  # numbers of any kind that has + and *
    for partial, slope in zip(partials, slopes, strict=True):
        if slope is not None and not (isinstance(partial, int) and partial == 0):
            more = product(step, partial, slope)
            total = more if total is None else total + more
    return None if total is None else cast(V, total)


@dataclass(frozen=True, eq=False)
class _Node(Generic[V]):
    """A number of the forward pass, and the numbers it was computed from."""

    value: V
    operands: tuple["_Node[V]", ...] = ()


def adjoint(program: Program, arithmetic: Arithmetic[V], functions: DerivativeFunctions,
            inputs: Sequence[Sequence[V]], weights: Sequence[V], partials_of: Partials = of_table,
            product: Product = times) -> tuple[list[V], list[list[V | None]]]:
    """(results, derivatives of Σ weight · result by the components of each input); None is zero.
    One pass forward and one back, for any number of inputs. """
    made: list[tuple[Instruction, _Node[V]]] = []

    def function(step: Instruction, number: int) -> Callable[..., _Node[V]]:
        compute = arithmetic.function(step, number)

        def apply(*operands: _Node[V]) -> _Node[V]:
            node = _Node(compute(*(x.value for x in operands)), operands)
            made.append((step, node))
            return node

        return apply

    nan = arithmetic.not_a_number
    tape = Arithmetic(lambda x: _Node(arithmetic.constant(x)), function,
                      None if nan is None else _Node(nan), lambda x: _Node(arithmetic.column(x)))
    given = [[_Node(x) for x in components] for components in inputs]
    results = interpreter(program, tape)(given)
    adjoints: dict[_Node[V], V] = {}
    for node, weight in zip(results, weights, strict=True):
        _accumulate(adjoints, node, weight)
    for step, node in reversed(made):
        if node in adjoints:
            _propagate(functions, adjoints, step, node, partials_of(step.op), product)
    return [x.value for x in results], [[adjoints.get(x) for x in row] for row in given]


def _propagate(functions: DerivativeFunctions, adjoints: dict[_Node[V], V], step: Instruction,
               node: _Node[V], derived: Slopes | None, product: Product) -> None:
    """Add a number's adjoint, times its partial derivatives, to the adjoints of its operands."""
    own, operands = adjoints[node], node.operands
    if step.op is Op.SELECT:
        test, a, b = operands
        _accumulate(adjoints, a, functions.where(test.value, own, 0))
        _accumulate(adjoints, b, functions.where(test.value, 0, own))
    elif derived is not None:
        partials = derived(functions, *(x.value for x in operands), node.value)
        for partial, x in zip(partials, operands, strict=True):
            if not (isinstance(partial, int) and partial == 0):
                _accumulate(adjoints, x, product(step, partial, own))


def _accumulate(adjoints: dict[_Node[V], Any], node: _Node[V], more: V) -> None:
    adjoints[node] = adjoints[node] + more if node in adjoints else more
