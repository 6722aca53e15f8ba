"""Records arithmetic as a Program: the library's own Programs replayed on Numbers.

What is constant folds exactly, in rationals; zeros and ones cost nothing; equal instructions are
issued once; signs move outwards until a sum takes them up.  Knows no mechanics.
"""

import string
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial

from coscrew_codegen.parameter import Parameter, Scalar
from coscrew_codegen.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
    without_dead_steps,
)
from coscrew_codegen.program.folding import Folded, Sign, folded, fraction
from coscrew_codegen.program.interpreter import Arithmetic, interpreter
from coscrew_codegen.programs import library_program
from coscrew_codegen.quantity import Argument, Quantity
from coscrew_codegen.recording.numbers import Number

Numbers = Sequence[Number]




def array(name: str, shape: tuple[int, ...], words: str = "") -> Argument:
    """An argument of this shape, stored row by row: the last index runs fastest."""
    return Argument(name, Quantity(name, shape, (), words))


class Recorder:
    """Issues instructions in order and names them after what they are part of."""

    def __init__(self, inputs: Sequence[Argument]):
        self.inputs = tuple(inputs)
        self._instructions: list[Instruction] = []
        self._by_name: dict[str, Instruction] = {}
        self._issued: dict[tuple[Op, tuple[Operand, ...]], Ref] = {}
        self._component = "x"
        self._heading = ""
        self.heading = ""  # of the part in which something was divided by zero
        self._taken: dict[str, int] = {}
        self._arithmetic: Arithmetic[Operand] = Arithmetic(
            lambda x: x, lambda step, _: partial(self._issued_of, step.op), NotANumber())
        self._replays: dict[str, Callable[[Sequence[Sequence[Operand]]], list[Operand]]] = {}

    # what goes in

    def argument(self, name: str) -> tuple[Number, ...]:
        """The components of an input."""
        index = next(i for i, a in enumerate(self.inputs) if a.name == name)
        return tuple(Number(self, Input(index, k))
                     for k in range(self.inputs[index].quantity.size))

    def has(self, name: str) -> bool:
        """Whether there is such an input."""
        return any(a.name == name for a in self.inputs)

    def number(self, value: Scalar | int) -> Number:
        """A constant, or a parameter's element of the input p."""
        if isinstance(value, Parameter):
            return self.argument("p")[value.index]
        exact = fraction(value)
        return Number(self, Constant(exact, exact))

    def numbers(self, values: Sequence[Scalar | int]) -> tuple[Number, ...]:
        """Each of them as a Number."""
        return tuple(map(self.number, values))

    # what happens to it

    @contextmanager
    def part(self, component: str, heading: str = "") -> Iterator[None]:
        """Names what is issued within after `component`, below a heading in the text."""
        before = self._component, self._heading
        self._component, self._heading = component, heading or self._heading
        try:
            yield
        except ZeroDivisionError:
            self.heading = self.heading or self._heading
            raise
        finally:
            self._component, self._heading = before

    def call(self, operation: str, *arguments: Number | Numbers) -> tuple[Number, ...]:
        """All components of the operation's outputs, its plain program replayed."""
        given = [[x.operand for x in ([a] if isinstance(a, Number) else a)] for a in arguments]
        if operation not in self._replays:
            self._replays[operation] = interpreter(library_program(operation), self._arithmetic)
        return tuple(Number(self, x) for x in self._replays[operation](given))

    def _issued_of(self, op: Op, *operands: Operand) -> Operand:
        return self.issue(op, operands)

    def issue(self, op: Op, operands: tuple[Operand, ...]) -> Operand:
        """The operand that holds op(operands): folded, found, or issued anew."""
        result = folded(op, operands, self._by_name)
        if isinstance(result, Sign):
            return self.issue(Op.NEG, (self.issue(*result.of),))
        if not isinstance(result, Folded):
            return result
        op, operands = result.op, result.operands
        if op.meaning.commutes:
            operands = tuple(sorted(operands, key=_order))
        key = (op, operands)
        if key not in self._issued:
            self._issued[key] = self._new(op, operands)
        return self._issued[key]

    def _new(self, op: Op, operands: tuple[Operand, ...]) -> Ref:
        count = self._taken.get(self._component, 0)
        self._taken[self._component] = count + 1
        name = f"{self._component}_{_letters(count)}"
        instruction = Instruction(name, op, operands, f"{self._heading}:{self._component}")
        self._instructions.append(instruction)
        self._by_name[name] = instruction
        return Ref(name)

    # what comes out

    def program(self, name: str, outputs: Sequence[tuple[Argument, Numbers]]) -> Program:
        """The program with these outputs; what none of them needs is not in it."""
        results = tuple(x.operand for argument, numbers in outputs
                        for x in _exactly(argument, numbers))
        return without_dead_steps(Program(name, self.inputs, tuple(a for a, _ in outputs),
                                          tuple(self._instructions), results))


def headings(program: Program) -> tuple[tuple[int, str], ...]:
    """Where the heading of the instructions changes: (index, heading)."""
    found, last = [], ""
    for index, step in enumerate(program.instructions):
        heading = step.component.rpartition(":")[0]  # a body may be called a:b
        if heading != last:
            found.append((index, heading))
            last = heading
    return tuple(found)


def _exactly(argument: Argument, numbers: Numbers) -> Numbers:
    if len(numbers) != argument.quantity.size:
        raise ValueError(f"{argument.name} has {argument.quantity.size} components, not "
                         f"{len(numbers)}")
    return numbers


def _letters(count: int) -> str:
    """a, …, z, aa, ab, …"""
    letters = ""
    count += 1
    while count:
        count, last = divmod(count - 1, 26)
        letters = string.ascii_lowercase[last] + letters
    return letters


def _order(x: Operand) -> tuple:
    """Constants first, then inputs, then results by name."""
    if isinstance(x, Constant):
        return 0, "", x.double, x.single
    if isinstance(x, Input):
        return 1, "", x.argument, x.index
    return (2, x.name, 0, 0) if isinstance(x, Ref) else (3, "", 0, 0)
