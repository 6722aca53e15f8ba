"""The NumPy target: pure-Python twins of the C kernels, component by component.

NumPy rounds every operation once and contracts nothing, so steps used once are nested into readable
expressions; parentheses keep the Program's order.
"""

import textwrap
from collections import Counter
from dataclasses import dataclass

from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
    bounds,
    counts_in_words,
)
from coscrew_codegen.quantity import Argument, in_words
from coscrew_codegen.targets.c_statements import WIDTH, listed

# spelling, and how tightly it binds
SPELLING = {
    Op.ADD: ("{} + {}", 1), Op.SUB: ("{} - {}", 1), Op.MUL: ("{} * {}", 2), Op.DIV: ("{} / {}", 2),
    Op.EXACT_ADD: ("{} + {}", 1), Op.EXACT_SUB: ("{} - {}", 1), Op.NEG: ("-{}", 3),
    Op.PRODUCT_ERROR: ("product_error({}, {}, {})", 4),
    Op.PRODUCT_REST: ("product_rest({}, {}, {}, {})", 4),
    Op.ABS: ("absolute({})", 4), Op.SQRT: ("sqrt({})", 4),
    Op.SIN: ("sin({})", 4), Op.COS: ("cos({})", 4), Op.ATAN2: ("arctan2({}, {})", 4),
    Op.EXP: ("exp({})", 4), Op.TANH: ("tanh({})", 4), Op.SCALE: ("{} * {}", 2),
    Op.LESS: ("{} < {}", 0), Op.EQUAL: ("{} == {}", 0),
    Op.SELECT: ("where({}, {}, {})", 4),
}
CALLS = 4

NUMPY_NAMES = {Op.ABS: "absolute", Op.SQRT: "sqrt", Op.SIN: "sin", Op.COS: "cos",
               Op.ATAN2: "arctan2", Op.EXP: "exp", Op.TANH: "tanh", Op.SELECT: "where"}
_EXACT = {Op.PRODUCT_ERROR: "product_error", Op.PRODUCT_REST: "product_rest"}


@dataclass(frozen=True)
class PythonFunction:
    """The text of one kernel: name, signature, arguments, docstring lines, body lines."""

    name: str
    signature: str
    arguments: str
    docstring: str
    body: str


def function(operation: Operation, program: Program, precision: Precision) -> PythonFunction:
    """The operation as a NumPy kernel on tuples of components."""
    return _Writer(operation, program, precision).function()


@dataclass(frozen=True)
class Stub:
    """The typed signature of one operation, for .pyi files."""

    name: str
    arguments: str
    out: str
    result: str
    docstring: str


def stub(operation: Operation, program: Program, scalar: str) -> Stub:
    """The operation's typed signature, its results arrays of `scalar` (np.float64, …)."""
    arguments = ", ".join(f"{a.name}: ArrayLike" for a in operation.inputs)
    array, count = f"NDArray[{scalar}]", len(operation.outputs)
    result = array if count == 1 else f"tuple[{', '.join([array] * count)}]"
    out = array if count == 1 else f"tuple[{', '.join([f'{array} | None'] * count)}]"
    return Stub(operation.name, arguments, out, result, _indented(docstring_of(operation, program)))


def docstring_of(operation: Operation, program: Program) -> str:
    """Equation, shapes, units, cost: the docstring of the operation in Python."""
    arguments = tuple({a.name: a for a in (*operation.inputs, *operation.outputs)}.values())
    remark = f"  {operation.remark}" if operation.remark else ""
    bound = bounds.in_words(program) or operation.tested_bounds
    cost = f"{counts_in_words(program).capitalize()}.  {bound}".rstrip()
    shapes = f"{operation.signature}.  {in_words(arguments)}."
    paragraphs = (f"{operation.statement}.{remark}", "", shapes, cost)
    return "\n".join(row for paragraph in paragraphs
                     for row in textwrap.wrap(paragraph, WIDTH - 8) or [""])


def imports(programs: tuple[Program, ...], precision: Precision) -> list[tuple[str, str]]:
    """(module, names) of the functions these programs call."""
    called: set[Op | str] = {op for program in programs for op in program.counts}
    called |= {kind for program in programs for kind in _types(program, precision)}
    found = [("numpy", NUMPY_NAMES | {kind: kind for kind in ("float32", "float64", "nan")}),
             ("coscrew._exact", _EXACT)]
    return [(module, ", ".join(sorted(names[op] for op in called & set(names))))
            for module, names in found if called & set(names)]


def _types(program: Program, precision: Precision) -> set[str]:
    """The NumPy names that choices need: the type of one between constants, nan."""
    working = DOUBLE if program.wide else precision
    choices = [step for step in program.instructions if step.op is Op.SELECT]
    return ({working.numpy_type for step in choices if is_choice_of_constants(step)}
            | {"nan" for step in choices if NotANumber() in step.operands})


def is_choice_of_constants(step: Instruction) -> bool:
    """Whether NumPy would choose between numbers that have no type."""
    return step.op is Op.SELECT and all(isinstance(x, Constant) for x in step.operands[1:])


def _indented(docstring: str) -> str:
    first, *rest = docstring.splitlines()
    return "\n".join([first, *(f"    {line}" if line else "" for line in rest)])


class _Writer:
    def __init__(self, operation: Operation, program: Program, precision: Precision):
        self.operation, self.program = operation, program
        self.working = DOUBLE if program.wide else precision
        uses = Counter(x.name for step in program.instructions for x in step.operands
                       if isinstance(x, Ref))
        uses.update(x.name for x in program.results if isinstance(x, Ref))
        self.nested = {step.name: step for step in program.instructions
                       if step.op in (Op.LESS, Op.EQUAL)
                       or uses[step.name] == 1 and step.name != step.component}
        self._texts: dict[str, tuple[str, int]] = {}  # of nested expressions

    def function(self) -> PythonFunction:
        return PythonFunction(self.operation.name, self.operation.signature,
                              ", ".join(a.name for a in self.operation.inputs),
                              _indented(docstring_of(self.operation, self.program)),
                              "\n".join(f"    {line}" for line in self._body()))

    def _body(self) -> list[str]:
        used = {x.argument for x in self.program.used_inputs()}
        lines = [self._unpacked(a) for n, a in enumerate(self.program.inputs)
                 if n in used and a.quantity.shape]
        for step in self.program.instructions:
            if step.name not in self.nested:
                self._shorten(step)
        lines += [self._assigned(step) for step in self.program.instructions
                  if step.name not in self.nested]
        results = [self._operand(x, 0) for x in self.program.results]
        lines.append(f"return {results[0]}" if len(results) == 1
                     else listed("return (", results, ")", WIDTH - 4))
        return [line.replace("\n", "\n    ") for line in lines]

    def _unpacked(self, argument: Argument) -> str:
        names = [symbol.name for symbol in argument.symbols]
        plain = f"{', '.join(names)} = {argument.name}"
        if len(plain) <= WIDTH - 4:
            return plain
        return listed("(", names, f") = {argument.name}", WIDTH - 4)

    def _shorten(self, step: Instruction) -> None:
        """While the assignment is too wide, give the widest expression nested in it a line."""
        while len(self._assigned(step)) > WIDTH - 4 and (inner := self._nested_in(step)):
            widest = max(inner, key=lambda x: min(len(self._expression(x)[0]), WIDTH // 2))
            del self.nested[widest.name]
            self._texts.clear()
            self._shorten(widest)

    def _nested_in(self, step: Instruction) -> list[Instruction]:
        found = [self.nested[x.name] for x in step.operands
                 if isinstance(x, Ref) and x.name in self.nested]
        return [inner for x in found for inner in (x, *self._nested_in(x))
                if inner.op not in (Op.LESS, Op.EQUAL)]

    def _assigned(self, step: Instruction) -> str:
        return f"{step.name} = {self._expression(step)[0]}"

    def _expression(self, step: Instruction) -> tuple[str, int]:
        if is_choice_of_constants(step):
            return self._choice_of_constants(step), CALLS
        spelling, binding = SPELLING[step.op]
        needed = [0] * 4 if binding == CALLS else [binding, binding + 1]
        operands = [self._operand(x, n) for x, n in zip(step.operands, needed, strict=False)]
        return spelling.format(*operands), binding

    def _choice_of_constants(self, step: Instruction) -> str:
        """NumPy takes the type of `where` from its operands, and Python's numbers have none."""
        test = self._operand(step.operands[0], 0)
        values = [f"{self.working.numpy_type}({self._operand(x, 0)})" for x in step.operands[1:]]
        return f"where({', '.join((test, *values))})"

    def _constant(self, constant: Constant) -> str:
        """Integers and powers of two exactly, so that objects stay exact."""
        value = self.working.value(constant)
        if value.denominator == 1 and abs(value) < 2**53:
            return str(value)
        is_power = all(n & (n - 1) == 0 for n in map(abs, value.as_integer_ratio()))
        return repr(float(value)) if is_power else self.working.literal(constant)

    def _operand(self, operand: Operand, needed: int) -> str:
        """The operand's text, in parentheses where it binds less tightly than needed."""
        if isinstance(operand, Input):
            return self.program.inputs[operand.argument].symbols[operand.index].name
        if isinstance(operand, Constant):
            return self._constant(operand)
        if isinstance(operand, NotANumber):
            return "nan"
        if operand.name not in self.nested:
            return operand.name
        if operand.name not in self._texts:
            self._texts[operand.name] = self._expression(self.nested[operand.name])
        text, binding = self._texts[operand.name]
        return text if binding >= needed else f"({text})"
