"""The NumPy target: pure-Python twins of the C kernels, component by component.

NumPy rounds every operation once and never contracts, so that expressions can be nested.
"""

import textwrap
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from coscrew_codegen.accuracy import bounds
from coscrew_codegen.accuracy.tiers import TIERS, Tier
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.backends.c.c_statements import WIDTH, broken, listed
from coscrew_codegen.backends.library import FamilyKernels, Kernels, Library
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
from coscrew_codegen.program import Constant, Input, Instruction, NotANumber, Op, Program
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
    """The text of one kernel: name, signature, arguments, lines of docstring and body."""

    name: str
    signature: str
    arguments: str
    docstring: str
    body: str


def function(operation: Operation, program: Program, precision: Precision) -> PythonFunction:
    """The operation as a NumPy kernel on tuples of components."""
    return _Writer(operation, program, precision).function()


@dataclass(frozen=True)
class Twins:
    """A family's kernels in a tier and a precision; docstrings by their names."""

    functions: tuple[PythonFunction, ...]
    docstrings: Mapping[str, str]
    imports: tuple[tuple[str, str], ...]  # module, names
    wide: bool


def twins(kernels: FamilyKernels) -> Mapping[tuple[str, str], Twins]:
    """A family's kernels, by tier and precision."""
    return {(tier.name, precision.name): twins_of(kernels.of(tier, precision), precision)
            for tier in TIERS for precision in kernels.precisions}


def twins_of(kernels: Kernels, precision: Precision) -> Twins:
    """Returns the twins of these kernels in a precision."""
    return Twins(tuple(function(op, program, precision) for op, program in kernels.items()),
                 {op.name: docstring_of(op, program, precision) for op, program in kernels.items()},
                 imports(tuple(kernels.values()), precision),
                 any(program.wide for program in kernels.values()))


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


def imports(programs: tuple[Program, ...], precision: Precision) -> tuple[tuple[str, str], ...]:
    """(module, names) of the functions these programs call."""
    called: set[Op | str] = {op for program in programs for op in program.counts}
    called |= {kind for program in programs for kind in _types(program, precision)}
    working = DOUBLE if any(program.wide for program in programs) else precision
    module = f"_elementary_{working.name} as elementary"
    found: list[tuple[str, Mapping[Any, str]]] = [
        ("coscrew", dict.fromkeys(ELEMENTARY, module)),
        ("numpy", NUMPY_NAMES | {kind: kind for kind in ("float32", "float64", "nan")}),
        ("coscrew._exact", exactly_in(working))]
    return tuple((place, ", ".join(sorted({names[op] for op in called & set(names)})))
                 for place, names in found if called & set(names))


def exactly_in(precision: Precision) -> Mapping[Op | str, str]:
    """Returns the functions that compute errors of products in this precision."""
    return EXACT if precision == DOUBLE else IN_SINGLE


def _types(program: Program, precision: Precision) -> set[str]:
    """The NumPy names that choices need: nan, and the type of constants to choose between."""
    working = DOUBLE if program.wide else precision
    choices = [step for step in program.instructions if step.op is Op.SELECT]
    return ({working.numpy_type for step in choices if _is_choice_of_constants(step)}
            | {"nan" for step in choices if NotANumber() in step.operands})


def docstrings(library: Library, tier: Tier, precision: Precision) -> Mapping[str, str]:
    """The docstrings of a tier's kernels, by name."""
    return {name: text for made in library.made(twins).values()
            for name, text in made[tier.name, precision.name].docstrings.items()}


def _indented(docstring: str) -> str:
    first, *rest = docstring.splitlines()
    return "\n".join([first, *(f"    {line}" if line else "" for line in rest)])


def language(precision: Precision, constant: Callable[[Constant], str], module: str = ""
             ) -> Language:
    """Python with NumPy in a precision; elementary functions are in a module.  A `where` of two
    constants needs a type: NumPy takes it from the operands, and Python's numbers have none."""
    kind = precision.numpy_type

    def spelling(step: Instruction) -> tuple[str, int]:
        if _is_choice_of_constants(step):
            return f"where({{}}, {kind}({{}}), {kind}({{}}))", CALL
        if step.op in ELEMENTARY:
            return module + "".join(ELEMENTARY[step.op]), CALL
        return SPELLING[step.op]

    return Language(spelling, constant, "nan", "# ", f"{module}{{function}}({{arguments}})")


def statement(x: Assignment | str) -> str:
    """An assignment, in parentheses if it takes several lines; or a comment."""
    if isinstance(x, str):
        return f"# {x}"
    names = ", ".join(x.names)
    plain = f"{names} = {x.expression}"
    if len(plain) <= WIDTH - 4:
        return plain
    rows = list(wrapped(f"{names} = ({x.expression})", WIDTH - 4, 4))
    return broken("\n    ".join(rows) if len(rows) > 1 else plain, WIDTH - 4)


def _is_choice_of_constants(step: Instruction) -> bool:
    """Returns whether this chooses between numbers that have no type of their own."""
    return step.op is Op.SELECT and all(isinstance(x, Constant) for x in step.operands[1:])


class _Writer:
    def __init__(self, operation: Operation, program: Program, precision: Precision):
        self.operation, self.program, self.precision = operation, program, precision
        self.working = DOUBLE if program.wide else precision

    def function(self) -> PythonFunction:
        return PythonFunction(self.operation.name, self.operation.signature,
                              ", ".join(a.name for a in self.operation.inputs),
                              _indented(docstring_of(self.operation, self.program, self.precision)),
                              "\n".join(f"    {line}" for line in self._body()))

    def _body(self) -> list[str]:
        used = {x.argument for x in self.program.used_inputs()}
        lines = [self._unpacked(a) for n, a in enumerate(self.program.inputs)
                 if n in used and a.quantity.shape]
        text = Nesting(self.program, language(self.working, self._constant, "elementary."),
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
        """A constant; integers and powers of two exactly, so that arrays of objects stay exact."""
        value = self.working.value(constant)
        if value.denominator == 1 and abs(value) < 2**DOUBLE.digits:
            return str(value)
        is_power = all(n & (n - 1) == 0 for n in map(abs, value.as_integer_ratio()))
        return repr(float(value)) if is_power else self.working.literal(constant)
