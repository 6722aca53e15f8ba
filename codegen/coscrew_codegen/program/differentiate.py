"""Derivatives of a Program on any kind of numbers: tangents forward, adjoints backward.

Both use the one interpreter, on numbers that carry derivatives, and the partial derivatives in the
table of operations.  Derivatives are those of the exact operations.  Where a Program compares (|x|,
a choice, a table) they are one-sided; at √0 and 0/0 there is none.
"""

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Generic, NamedTuple, TypeVar, cast

from coscrew_codegen.program.interpreter import Arithmetic, interpreter
from coscrew_codegen.program.ops import DerivativeFunctions, Op, Slopes
from coscrew_codegen.program.program import Constant, Instruction, Operand, Program, Ref, name_of

V = TypeVar("V")
X = TypeVar("X", bound="Dual[Any] | _Node[Any]")
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
            product: Product = times,
            known: Mapping[V, Dual[V]] | None = None) -> list[Dual[V]]:
    """The results with their derivatives along the directions that the inputs carry.  `known` gives
    the derivatives of some intermediate values, which are then not derived."""
    count = len(next(x for given in inputs for x in given).slopes)
    chain = _ChainRule[Dual[V]](program, functions, partials_of)

    def constant(x: Constant) -> Dual[V]:
        return Dual(arithmetic.constant(x), (None,) * count)

    def function(step: Instruction, number: int) -> Callable[..., Dual[V]]:
        compute = arithmetic.function(step, number)

        def apply(*operands: Dual[V]) -> Dual[V]:
            y = compute(*(x.value for x in operands))
            chain.keep(step, operands)
            if known and y in known:
                return known[y]
            if step.op is Op.SELECT:
                test, a, b = operands
                return Dual(y, tuple(_chosen(functions, test.value, *pair)
                                     for pair in zip(a.slopes, b.slopes, strict=True)))
            if all(s is None for x in operands for s in x.slopes):
                return Dual(y, (None,) * count)
            partials, variables = chain.partials(step, y)
            return Dual(y, tuple(_along(step, partials, [x.slopes[k] for x in variables], product)
                                 for k in range(count)))

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


_DERIVATIVE = {Op.SIN: Op.COS, Op.COS: Op.SIN}
"""The function in the derivative of a sine and of a cosine."""


class _Term(NamedTuple):
    """±x sin θ or ±x cos θ."""

    negative: bool
    circular: Instruction  # the sine or the cosine
    product: Instruction
    place: int  # of x in the product

    @property
    def falls(self) -> bool:
        """True if its derivative by θ is minus a product."""
        return self.negative != (self.circular.op is Op.COS)


class _Turned(NamedTuple):
    """A component of a turned vector: a term, or a sum of two with one angle.

    Its derivative by the angle is the other component, up to signs.  The program computes a product
    of that at least; if `opposite`, all of it, with the opposite sign."""

    terms: tuple[_Term, ...]
    opposite: bool = False


def _turned(program: Program) -> Mapping[str, _Turned]:
    """The components of turned vectors, by the names of instructions."""
    steps = {step.name: step for step in program.instructions}
    circular = {(step.op, step.operands): Ref(step.name) for step in program.instructions
                if step.op in _DERIVATIVE}
    products = {frozenset(step.operands): Ref(step.name) for step in program.instructions
                if step.op is Op.MUL}
    differences = {step.operands for step in program.instructions if step.op is Op.SUB}

    def terms(x: Operand, negative: bool) -> list[_Term]:
        product = steps.get(name_of(x))
        if product is None or product.op is not Op.MUL:
            return []
        factors = [steps.get(name_of(factor)) for factor in product.operands]
        return [_Term(negative, factor, product, 1 - place) for place, factor
                in enumerate(factors) if factor and factor.op in _DERIVATIVE]

    def other(term: _Term) -> Operand | None:
        """The product of the other component with the same x."""
        factor = circular.get((_DERIVATIVE[term.circular.op], term.circular.operands))
        return factor and products.get(frozenset({factor, term.product.operands[term.place]}))

    def turned(step: Instruction) -> _Turned | None:
        if step.op is Op.MUL:
            return next((_Turned((x,)) for x in terms(Ref(step.name), False) if other(x)), None)
        if step.op not in (Op.ADD, Op.SUB):
            return None
        for pair in itertools.product(*(terms(x, k == 1 and step.op is Op.SUB)
                                        for k, x in enumerate(step.operands))):
            if pair[0].circular.operands == pair[1].circular.operands and any(map(other, pair)):
                a, b = sorted(pair, key=lambda x: not x.falls)
                return _Turned(pair, a.falls > b.falls and (other(a), other(b)) in differences)
        return None

    return {step.name: x for step in program.instructions if (x := turned(step))}


class _ChainRule(Generic[X]):
    """The variables of each step, and its partial derivatives with respect to them.

    Variables are the step's operands; but those of a sum ±x sin θ ± y cos θ are θ, x and y.  The
    derivative by θ is the other component of the turned vector, up to its sign.  Where that is
    computed anyway, each sum takes 5 operations along a direction instead of 7."""

    def __init__(self, program: Program, functions: DerivativeFunctions, partials_of: Partials):
        self._functions, self._partials_of = functions, partials_of
        self._turned = _turned(program)
        self._operands: dict[str, tuple[X, ...]] = {}

    def keep(self, step: Instruction, operands: tuple[X, ...]) -> None:
        """Keeps the step's operands, which steps that come later need."""
        self._operands[step.name] = operands

    def partials(self, step: Instruction, result: Any) -> tuple[Sequence[Any], Sequence[X]]:
        """Returns the partial derivatives, and the variables that they are with respect to."""
        if step.name in self._turned:
            return self._of_turned(self._turned[step.name])
        derived, operands = self._partials_of(step.op), self._operands[step.name]
        if derived is None:
            return (), ()
        return derived(self._functions, *(x.value for x in operands), result), operands

    def _of_turned(self, turned: _Turned) -> tuple[Sequence[Any], Sequence[X]]:
        of_angle: list[Any] = []
        others: list[Any] = []
        variables: list[X] = []
        for term in turned.terms:
            factors = self._operands[term.product.name]
            x, circular = factors[term.place], factors[1 - term.place].value
            (angle,), derived = (self._operands[term.circular.name],
                                 self._partials_of(term.circular.op))
            assert derived
            slope, = derived(self._functions, angle.value, circular)
            of_angle.append(-(slope * x.value) if term.negative else slope * x.value)
            others.append(-circular if term.negative else circular)
            variables.append(x)
        by_angle = of_angle[0]
        for y in of_angle[1:]:
            by_angle = -(-by_angle - y) if turned.opposite else by_angle + y
        return (by_angle, *others), (angle, *variables)


@dataclass(frozen=True, eq=False)
class _Node(Generic[V]):
    """A number of the forward pass, and the numbers it was computed from."""

    value: V
    operands: tuple["_Node[V]", ...] = ()


def adjoint(program: Program, arithmetic: Arithmetic[V], functions: DerivativeFunctions,
            inputs: Sequence[Sequence[V]], weights: Sequence[V], partials_of: Partials = of_table,
            product: Product = times, independent: Sequence[V] = ()
            ) -> tuple[list[V], list[list[V | None]]]:
    """(results, derivatives of Σ weight · result by the components of each input); None is zero.
    One pass forward and one back, for any number of inputs.  `independent` intermediate values
    count as a further input: derivatives by the other inputs do not pass through them."""
    made: list[tuple[Instruction, _Node[V]]] = []
    chain = _ChainRule[_Node[V]](program, functions, partials_of)
    leaves = {x: _Node(x) for x in independent}

    def function(step: Instruction, number: int) -> Callable[..., _Node[V]]:
        compute = arithmetic.function(step, number)

        def apply(*operands: _Node[V]) -> _Node[V]:
            node = _Node(compute(*(x.value for x in operands)), operands)
            chain.keep(step, operands)
            if leaves and node.value in leaves:
                return leaves[node.value]
            made.append((step, node))
            return node

        return apply

    nan = arithmetic.not_a_number
    tape = Arithmetic(lambda x: _Node(arithmetic.constant(x)), function,
                      None if nan is None else _Node(nan), lambda x: _Node(arithmetic.column(x)))
    given = [[leaves.get(x) or _Node(x) for x in row] if leaves else [*map(_Node, row)]
             for row in inputs]
    results = interpreter(program, tape)(given)
    adjoints: dict[_Node[V], V] = {}
    for node, weight in zip(results, weights, strict=True):
        _accumulate(adjoints, node, weight)
    for step, node in reversed(made):
        if node in adjoints:
            _propagate(functions, adjoints, step, node, chain, product)
    rows = [*given, [leaves[x] for x in independent]] if leaves else given
    return [x.value for x in results], [[adjoints.get(x) for x in row] for row in rows]


def _propagate(functions: DerivativeFunctions, adjoints: dict[_Node[V], V], step: Instruction,
               node: _Node[V], chain: "_ChainRule[_Node[V]]", product: Product) -> None:
    """Add a number's adjoint, times its partial derivatives, to the adjoints of its operands."""
    own = adjoints[node]
    if step.op is Op.SELECT:
        test, a, b = node.operands
        _accumulate(adjoints, a, functions.where(test.value, own, 0))
        _accumulate(adjoints, b, functions.where(test.value, 0, own))
    else:
        for partial, x in zip(*chain.partials(step, node.value), strict=True):
            if not (isinstance(partial, int) and partial == 0):
                _accumulate(adjoints, x, product(step, partial, own))


def _accumulate(adjoints: dict[_Node[V], Any], node: _Node[V], more: V) -> None:
    adjoints[node] = adjoints[node] + more if node in adjoints else more
