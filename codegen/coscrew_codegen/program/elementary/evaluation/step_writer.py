"""Writes a Program step by step, in exactly the order and form in which it is written down.

Nothing is folded, reordered or shared: elementary functions rely on every rounding."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.program import renamed
from coscrew_codegen.program.values.quantity import Argument

Given: TypeAlias = "StepValue | Fraction | int"


@dataclass(frozen=True, eq=False)
class StepValue:
    """An operand of further steps."""

    steps: "StepWriter"
    operand: Operand

    def __add__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.ADD, self, other)

    def __radd__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.ADD, other, self)

    def __sub__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.SUB, self, other)

    def __rsub__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.SUB, other, self)

    def __mul__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.MUL, self, other)

    def __rmul__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.MUL, other, self)

    def __truediv__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.DIV, self, other)

    def __rtruediv__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.DIV, other, self)

    def __neg__(self) -> "StepValue":
        return self.steps.do(Op.NEG, self)

    def __abs__(self) -> "StepValue":
        return self.steps.do(Op.ABS, self)

    def __lt__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.LESS, self, other)

    def __gt__(self, other: Given) -> "StepValue":
        return self.steps.do(Op.LESS, other, self)

    def equals(self, other: Given) -> "StepValue":
        """self == other"""
        return self.steps.do(Op.EQUAL, self, other)

    def where(self, chosen: Given, otherwise: Given) -> "StepValue":
        """`chosen` where this comparison holds."""
        return self.steps.do(Op.SELECT, self, chosen, otherwise)


class StepWriter:
    """The steps of a Program.  `named` names a value; the steps that lead to it get names derived
    from it."""

    def __init__(self, *inputs: Argument) -> None:
        self._inputs = inputs
        self._instructions: list[Instruction] = []
        self._names: dict[str, str] = {}

    def inputs(self) -> tuple[StepValue, ...]:
        """The inputs, which are scalars."""
        return tuple(StepValue(self, Input(number, 0)) for number in range(len(self._inputs)))

    def constant(self, value: Fraction | int, name: str = "") -> StepValue:
        """A number that the format has."""
        exact = Fraction(value)
        return StepValue(self, Constant(exact, exact, name))

    def do(self, op: Op, *operands: Given) -> StepValue:
        """The result of a new instruction."""
        given = tuple(x.operand if isinstance(x, StepValue) else self.constant(x).operand
                      for x in operands)
        name = str(len(self._instructions))
        self._instructions.append(Instruction(name, op, given, ""))
        return StepValue(self, Ref(name))

    def named(self, name: str, value: StepValue) -> StepValue:
        """The value, named; the steps since the last name are name_1, name_2, …."""
        number = 0
        for at in range(len(self._names), len(self._instructions)):
            step = self._instructions[at]
            if Ref(step.name) == value.operand:
                self._names[step.name] = name
            else:
                number += 1
                self._names[step.name] = f"{name}_{number}"
            self._instructions[at] = step._replace(component=name)
        return value

    def program(self, name: str, outputs: Sequence[Argument],
                results: Sequence[StepValue]) -> Program:
        """The Program; every step must belong to a name, and names must differ."""
        if len(self._names) < len(self._instructions):
            raise ValueError(f"{name}: there are steps after the last name")
        names = Counter(self._names.values())
        if twice := [x for x, count in names.items() if count > 1]:
            raise ValueError(f"{name}: two steps are named {twice[0]}")
        plain = Program(name, self._inputs, tuple(outputs), tuple(self._instructions),
                        tuple(x.operand for x in results))
        return renamed(plain, self._names)
