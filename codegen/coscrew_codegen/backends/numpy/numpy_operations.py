"""The NumPy target: pure-Python twins of the C kernels, component by component.

NumPy rounds every operation once and never contracts, so that expressions can be nested.
"""

import textwrap
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

from coscrew_codegen.accuracy import bounds
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.backends.c.c_statements import WIDTH, broken, listed
from coscrew_codegen.backends.nesting import (
    CALL,
    COMPARISON,
    PRODUCT,
    SIGN,
    SUM,
    Assignment,
    Language,
    Nesting,
    wrapped,
)
from coscrew_codegen.backends.numpy import numpy_tables
from coscrew_codegen.backends.numpy.shared_twins import SharedProgram
from coscrew_codegen.program import Constant, Input, Instruction, Op, Program
from coscrew_codegen.program.ops import OF_TABLES
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.values.quantity import Argument, in_words
from coscrew_codegen.program.whole_cost import whole_cost

# operation → (pattern, precedence)
SPELLING = {
    Op.ADD: ("{} + {}", SUM), Op.SUB: ("{} - {}", SUM), Op.MUL: ("{} * {}", PRODUCT),
    Op.DIV: ("{} / {}", PRODUCT), Op.EXACT_ADD: ("{} + {}", SUM), Op.EXACT_SUB: ("{} - {}", SUM),
    Op.NEG: ("-{}", SIGN), Op.PRODUCT_ERROR: ("product_error({}, {}, {})", CALL),
    Op.PRODUCT_REST: ("product_rest({}, {}, {}, {})", CALL),
    Op.ABS: ("absolute({})", CALL), Op.SQRT: ("sqrt({})", CALL),
    Op.POWER: ("power_of_two({})", CALL), Op.SCALE: ("{} * {}", PRODUCT),
    Op.COPYSIGN: ("copysign({}, {})", CALL), Op.TWO_OVER_PI: ("two_over_pi({}, {})", CALL),
    Op.LESS: ("{} < {}", COMPARISON), Op.EQUAL: ("{} == {}", COMPARISON),
    Op.SELECT: ("where({}, {}, {})", CALL),
}

NUMPY_NAMES: dict[Op | str, str] = {
    Op.ABS: "absolute", Op.SQRT: "sqrt", Op.SELECT: "where",
    Op.COPYSIGN: "copysign"}
EXACT: dict[Op | str, str] = {Op.PRODUCT_ERROR: "product_error", Op.PRODUCT_REST: "product_rest"}
IN_SINGLE: dict[Op | str, str] = {Op.PRODUCT_ERROR: "product_error_single as product_error",
                                  Op.PRODUCT_REST: "product_rest_single as product_rest"}
"""What kernels import that compute errors of products: in double, in single precision."""
ELEMENTARY = {Op.SIN: ("sin", "({})"), Op.COS: ("cos", "({})"), Op.ATAN2: ("atan2", "({}, {})"),
              Op.EXP: ("exp", "({})"), Op.TANH: ("tanh", "({})"),
              Op.SIN_ERROR: ("sin_error", "({}, {})"), Op.COS_ERROR: ("cos_error", "({}, {})"),
              Op.ATAN2_ERROR: ("atan2_error", "({}, {}, {})"),
              Op.EXP_ERROR: ("exp_error", "({}, {})"), Op.TANH_ERROR: ("tanh_error", "({}, {})")}
"""Functions of our own: name, arguments."""


@dataclass(frozen=True)
class PythonFunction:
    """The text of one kernel: name, signature, head, lines of docstring and body; or the statement
    that makes it from that of double precision."""

    name: str
    signature: str
    head: str
    docstring: str
    body: str
    shared: str = ""


def function(operation: Operation, program: Program, precision: Precision,
             both: SharedProgram | None = None) -> PythonFunction:
    """The operation as a NumPy kernel on tuples of components; of the program of `both` precisions,
    if there is one."""
    return _Writer(operation, program, precision, both).function()


@dataclass(frozen=True)
class Stub:
    """The typed signature of one operation, for .pyi files."""

    name: str
    arguments: str
    out: str
    result: str
    docstring: str


def stub(operation: Operation, docstring: str) -> Stub:
    """The operation's typed signature: its results are of the type _Array of the stubs, and the
    arrays that may be given for them _Out."""
    arguments = ", ".join(f"{a.name}: ArrayLike" for a in operation.inputs)
    count = len(operation.outputs)
    result = "_Array" if count == 1 else f"tuple[{', '.join(['_Array'] * count)}]"
    out = "_Out" if count == 1 else f"tuple[{', '.join(['_Out'] * count)}] | None"
    return Stub(operation.name, arguments, out, result, _indented(docstring))


def docstring_of(operation: Operation, program: Program, precision: Precision) -> str:
    """Equation, shapes, units, cost: the docstring of the operation in Python."""
    arguments = tuple({a.name: a for a in (*operation.inputs, *operation.outputs)}.values())
    remark = f"  {operation.remark}" if operation.remark else ""
    bound = bounds.in_words(program) or operation.tested_bounds
    cost = f"{whole_cost(program, precision).capitalize()}.  {bound}".rstrip()
    shapes = f"{operation.signature}.  {in_words(arguments)}."
    paragraphs = (f"{operation.statement}.{remark}", "", shapes, cost)
    return "\n".join(row for paragraph in paragraphs
                     for row in textwrap.wrap(paragraph, WIDTH - 8) or [""])


def exactly_in(precision: Precision) -> Mapping[Op | str, str]:
    """Returns the functions that compute errors of products in this precision."""
    return EXACT if precision == DOUBLE else IN_SINGLE


def _indented(docstring: str) -> str:
    first, *rest = docstring.splitlines()
    return "\n".join([first, *(f"    {line}" if line else "" for line in rest)])


def language(kind: str, constant: Callable[[Constant], str], module: str = "") -> Language:
    """Python with NumPy; elementary functions are in a module.  A `where` of two constants needs a
    type, of this name: NumPy takes it from the operands, and Python's numbers have none."""

    def spelling(step: Instruction) -> tuple[str, int]:
        if is_choice_of_constants(step):
            return f"where({{}}, {kind}({{}}), {kind}({{}}))", CALL
        if step.op in ELEMENTARY:
            return module + "".join(ELEMENTARY[step.op]), CALL
        if step.op in OF_TABLES:
            return numpy_tables.spelled(step), CALL
        return SPELLING[step.op]

    return Language(spelling, constant, "nan", "# ", f"{module}{{function}}({{arguments}})")


def statement(x: Assignment | str) -> str:
    """An assignment, in parentheses if it takes several lines, calls broken after commas; or a
    comment."""
    if isinstance(x, str):
        return f"# {x}"
    names = ", ".join(x.names)
    plain, width = f"{names} = {x.expression}", WIDTH - 4
    if len(plain) <= width:
        return plain
    if _is_call(x.expression):
        return broken(listed("", plain.split(", "), "", width), width)
    return broken("\n    ".join(wrapped(f"{names} = ({x.expression})", width, 4)), width)


def _is_call(expression: str) -> bool:
    """Returns whether no blank stands outside parentheses."""
    depth = 0
    for letter in expression:
        depth += (letter == "(") - (letter == ")")
        if letter == " " and not depth:
            return False
    return True


def is_choice_of_constants(step: Instruction) -> bool:
    """Returns whether this chooses between numbers that have no type of their own."""
    return step.op is Op.SELECT and all(isinstance(x, Constant) for x in step.operands[1:])


class _Writer:
    def __init__(self, operation: Operation, program: Program, precision: Precision,
                 both: SharedProgram | None = None):
        self.operation, self.plain, self.precision = operation, program, precision
        self.both = both
        self.program = both.program if both else program
        self.working = DOUBLE if program.wide else precision

    def function(self) -> PythonFunction:
        constants = (self.both.parameters(partial(literal, precision=self.working))
                     if self.both else [])
        items = [*(a.name for a in self.operation.inputs), *["*"][:len(constants)], *constants]
        return PythonFunction(self.operation.name, self.operation.signature,
                              listed(f"def {self.operation.name}(", items, "):").replace(
                                  "\n", "\n    "),
                              _indented(docstring_of(self.operation, self.plain, self.precision)),
                              "\n".join(f"    {line}" for line in self._body()))

    def _body(self) -> list[str]:
        used = {x.argument for x in self.program.used_inputs()}
        lines = [self._unpacked(a) for n, a in enumerate(self.program.inputs)
                 if n in used and a.quantity.shape]
        text = Nesting(self.program, language("real", self._constant, "elementary."),
                       self._component,
                       150, named=lambda step: step.name == step.component)
        lines += map(statement, text.assigned)
        lines.append(f"return {text.results[0]}" if len(text.results) == 1
                     else listed("return (", text.results, ")", WIDTH - 4))
        return [line.replace("\n", "\n    ") for line in lines]

    def _unpacked(self, argument: Argument) -> str:
        names = [symbol.name for symbol in argument.symbols]
        plain = f"{', '.join(names)} = {argument.name}"
        if len(plain) <= WIDTH - 4:
            return plain
        return listed("(", names, f") = {argument.name}", WIDTH - 4)

    def _component(self, operand: Input) -> str:
        return str(self.program.inputs[operand.argument].symbols[operand.index].name)

    def _constant(self, constant: Constant) -> str:
        names = self.both.names if self.both else {}
        return names.get(constant) or literal(constant, self.working)


def literal(constant: Constant, precision: Precision) -> str:
    """A constant; integers and powers of two exactly, so that arrays of objects stay exact."""
    value = precision.value(constant)
    if value.denominator == 1 and abs(value) < 2**DOUBLE.digits:
        return str(value)
    is_power = all(n & (n - 1) == 0 for n in map(abs, value.as_integer_ratio()))
    return repr(float(value)) if is_power else precision.literal(constant)
