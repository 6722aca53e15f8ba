"""Records arithmetic, and calls of the library's Programs, as a Program.

Constants fold exactly, in rationals; zeros and ones cost nothing; equal instructions are issued
once; signs move outwards until a sum absorbs them.  Knows no mechanics.

Instructions are named when the program is complete, so that the numbers in names have no gaps:

    w3x                  component x of the value w of link 3
    w3xn                 its negative
    w3xv2                the second value of that name in the function
    w3x_1                the first step towards w3x, used for nothing else
    w3_1                 the first step of the part w of link 3 that has several uses
    elbow_viscous_tau    the value tau of an owner that is no link
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.algebra.lowering.programs import library_program
from coscrew_codegen.algebra.recording.naming import NamePart, named
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
    constant,
    without_dead_steps,
)
from coscrew_codegen.program.folding import Folded, KnownSign, folded, fraction
from coscrew_codegen.program.interpreter import Arithmetic, interpreter
from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.program.values.quantity import Argument, Quantity

Numbers = Sequence[Number]
_COMMUTE = frozenset(op for op in Op if op.meaning.commutes)

COMPONENTS = {1: ("",), 3: ("x", "y", "z"), 6: ("xx", "yy", "zz", "xy", "xz", "yz"),
              9: ("xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz")}
"""Suffixes of components, by the number of components."""


def array(name: str, shape: tuple[int, ...], words: str = "") -> Argument:
    """An argument of this shape, row by row: the last index runs fastest."""
    return Argument(name, Quantity(name, shape, (), words))


class Recorder:
    """Issues instructions in order and names them after the values that they belong to.

    `fine` says that operations are recorded in the form for twice the digits; `differs` says that
    one of them has another program then."""

    def __init__(self, inputs: Sequence[Argument], fine: bool = False):
        self.inputs, self._fine, self.differs = tuple(inputs), fine, False
        self._instructions: list[Instruction] = []
        self._by_name: dict[str, Instruction] = {}
        self._issued: dict[tuple[Op, tuple[Operand, ...]], Ref] = {}
        self._folds = True
        self._part = NamePart("total")  # sums over several links or effects
        self._parts: dict[str, NamePart] = {}  # by the instruction's name
        self._labels: dict[str, NamePart] = {}  # of values, by the name of their instruction
        self.heading = ""  # of the part in which a division by zero occurred
        self._arithmetic: Arithmetic[Operand] = Arithmetic(
            lambda x: x, self._issuing, NotANumber())
        self._replays: dict[str, Callable[[Sequence[Sequence[Operand]]], list[Operand]]] = {}

    # inputs and constants

    def argument(self, name: str) -> tuple[Number, ...]:
        """The components of an input."""
        index = next(i for i, a in enumerate(self.inputs) if a.name == name)
        return tuple(Number(self, Input(index, k))
                     for k in range(self.inputs[index].quantity.size))

    def has(self, name: str) -> bool:
        """Returns whether there is an input of this name."""
        return any(a.name == name for a in self.inputs)

    def number(self, value: Scalar | int) -> Number:
        """A constant, or a parameter's element of the input p."""
        if isinstance(value, Parameter):
            return self.argument("p")[value.index]
        return Number(self, constant(fraction(value)))

    def numbers(self, values: Sequence[Scalar | int]) -> tuple[Number, ...]:
        """Each of them as a Number."""
        return tuple(map(self.number, values))

    # operations

    @contextmanager
    def part(self, owner: str, symbol: str = "", heading: str = "") -> Iterator[None]:
        """Names the instructions issued in this block by owner (a link's number or a name) and
        symbol, below a heading."""
        with self.resumed(NamePart(owner, symbol, heading or self._part.heading)):
            yield

    @property
    def current(self) -> NamePart:
        """The part that instructions issued now belong to."""
        return self._part

    @contextmanager
    def resumed(self, part: NamePart) -> Iterator[None]:
        """Name the instructions issued in this block after this part."""
        before, self._part = self._part, part
        try:
            yield
        except ZeroDivisionError:
            self.heading = self.heading or self._part.heading
            raise
        finally:
            self._part = before

    @contextmanager
    def unfolded(self) -> Iterator[None]:
        """Issues instructions on variables as they stand in this block: the same ones whatever
        their signs, zeros and ones."""
        before, self._folds = self._folds, False
        try:
            yield
        finally:
            self._folds = before

    def label(self, symbol: str, value: Number | Numbers,
              owner: str = "") -> tuple[Number, ...]:
        """Name the components of a value by owner (by default the current part's) and symbol.

        Those of vectors are x, y, z, of symmetric matrices xx, yy, zz, xy, xz, yz, of other 3×3
        matrices xx, xy, xz, yx, ….  A component that has a name keeps it.  Returns the components:
        constants but 0 and ±1 have their names."""
        numbers, of = [value] if isinstance(value, Number) else value, self._part
        return tuple(self._labelled(NamePart(owner or of.owner, symbol, of.heading, suffix), x)
                     for suffix, x in zip(COMPONENTS[len(numbers)], numbers, strict=True))

    def _labelled(self, part: NamePart, x: Number) -> Number:
        if isinstance(x.operand, Ref):
            self._labels.setdefault(x.operand.name, part)
        if not isinstance(x.operand, Constant) or x.operand.name or x.constant in (0, 1, -1):
            return x
        return Number(self, replace(x.operand, name=part.stem))

    def call(self, operation: str, *arguments: Number | Numbers) -> tuple[Number, ...]:
        """All components of the operation's outputs; records its program on the arguments."""
        if operation not in self._replays:
            self._replays[operation] = interpreter(
                self.form(library_program(operation)), self._arithmetic)
        return self._replayed(self._replays[operation], arguments)

    def form(self, program: Program) -> Program:
        """The program in the form that is recorded: `fine` if that is wanted and differs."""
        self.differs = self.differs or program.fine is not None
        return program.fine or program if self._fine else program

    def replay(self, program: Program, *arguments: Number | Numbers) -> tuple[Number, ...]:
        """All components of the program's outputs; records it on these arguments."""
        return self._replayed(interpreter(self.form(program), self._arithmetic), arguments)

    def _replayed(self, run: Callable[[Sequence[Sequence[Operand]]], list[Operand]],
                  arguments: Sequence[Number | Numbers]) -> tuple[Number, ...]:
        given = [[x.operand for x in ([a] if isinstance(a, Number) else a)] for a in arguments]
        return tuple([Number(self, x) for x in run(given)])

    @property
    def arithmetic(self) -> Arithmetic[Number]:
        """Returns the arithmetic that interprets a program on Numbers of this recording."""
        return Arithmetic(
            lambda x: Number(self, x),
            lambda step, _: lambda *numbers: Number(self, self.issue(
                step.op, tuple(x.operand for x in numbers))),
            Number(self, NotANumber()), lambda x: Number(self, x))

    def _issuing(self, step: Instruction, _: int) -> Callable[..., Operand]:
        return lambda *operands: self.issue(step.op, operands)

    def issue(self, op: Op, operands: tuple[Operand, ...]) -> Operand:
        """The operand that holds op(operands): folded, issued earlier, or issued now."""
        if self._folds or all(isinstance(x, Constant) for x in operands):
            result = folded(op, operands, self._by_name)
            if isinstance(result, KnownSign):
                return self.issue(Op.NEG, (self.issue(*result.of),))
            if not isinstance(result, Folded):
                return result
            op, operands = result
            if op in _COMMUTE and _order(operands[1]) < _order(operands[0]):
                operands = operands[1], operands[0]
        key = op, operands
        if (issued := self._issued.get(key)) is None:
            issued = self._issued[key] = self._new(op, operands)
        return issued

    def _new(self, op: Op, operands: tuple[Operand, ...]) -> Ref:
        name = f"{len(self._instructions):06}"
        instruction = Instruction(name, op, operands, self._part.component)
        self._instructions.append(instruction)
        self._by_name[name] = instruction
        self._parts[name] = self._part
        return Ref(name)

    # the program

    def issued(self, first: int) -> Sequence[Instruction]:
        """The instructions so far, from a number on."""
        return self._instructions[first:]

    def program(self, name: str, outputs: Sequence[tuple[Argument, Numbers]]) -> Program:
        """The program with these outputs, without the instructions that none of them needs."""
        results = tuple(x.operand for argument, numbers in outputs
                        for x in _exactly(argument, numbers))
        program = without_dead_steps(Program(name, self.inputs, tuple(a for a, _ in outputs),
                                             tuple(self._instructions), results))
        return named(program, self._parts, self._labels, self._by_name)

    def end(self) -> None:
        """Forgets the recording, whose program is made: numbers and effects refer to each other,
        and would keep all instructions until Python's garbage collector runs, which took a seventh
        of the time of derivations."""
        for held in (self._instructions, self._by_name, self._issued, self._parts, self._labels,
                     self._replays):
            held.clear()


def headings(program: Program) -> tuple[tuple[int, str], ...]:
    """(index, heading) of each instruction at which the heading changes."""
    result, last = [], ""
    for index, step in enumerate(program.instructions):
        heading = step.component.rpartition(":")[0]  # a body may be called a:b
        if heading != last:
            result.append((index, heading or "total"))
            last = heading
    return tuple(result)


def _exactly(argument: Argument, numbers: Numbers) -> Numbers:
    if len(numbers) != argument.quantity.size:
        raise ValueError(f"{argument.name} has {argument.quantity.size} components, not "
                         f"{len(numbers)}")
    return numbers


def _order(x: Operand) -> tuple[int, str, Fraction | int, Fraction | int]:
    """Sort key: constants first, then inputs, then results in their order."""
    if isinstance(x, Constant):
        return 0, "", x.double, x.single
    if isinstance(x, Input):
        return 1, "", x.argument, x.index
    return (2, x.name, 0, 0) if isinstance(x, Ref) else (3, "", 0, 0)
