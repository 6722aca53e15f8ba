"""Reads the emitted C headers: parses them and evaluates their functions on SymPy symbols.

Knows C as far as the headers use it, but not how they are generated.  Memory is a list of cells,
one scalar each; the unions' layouts come from their typedefs, so that `D->t.y`, `D->m13` and
`D->at[3][1]` are one cell.  Reading an unwritten cell is an error.
"""

import operator
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import TypeAlias

import sympy as sp
from pycparser import CParser, c_ast
from pycparser.c_generator import CGenerator

from coscrew_codegen.backends.c.c_ksl import MARK, REFUSED

INCLUDE = Path(__file__).parents[3] / "generated" / "c" / "include" / "ksl"
_OTHERS = re.compile("ksl|elementary|.*_(fused|accurate|certified|states)$")
FAMILIES = tuple(sorted(path.stem for path in INCLUDE.glob("*.h")
                        if not _OTHERS.match(path.stem) and path.stem not in REFUSED))
"""The plain headers of one element, except elementary functions, whose text is no formula of what
they compute."""

_MATH = {"fabs": sp.Abs, "sqrt": sp.sqrt, "ksl_sin": sp.sin, "ksl_cos": sp.cos,
         "ksl_atan2": sp.atan2}
_PAIR = "ksl_sincos"
"""Returns the sine and stores the cosine."""
_BINARY = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv,
           "<": operator.lt, ">=": operator.ge, "==": sp.Eq, "&&": sp.And}
_PRODUCTS = {"KSL_MUL": "double", "KSL_MULF": "float"}
"""The macro for a product that is never fused into a sum, in each precision."""
_FUNCTION = re.compile(r"^\w[^;{}]*?\b(ksl_\w+)\([^;{}]*\) \{\n.*?^\}\n",
                       re.MULTILINE | re.DOTALL)
_SIGNS = re.compile(r"(?<=\s)[+-](?=\s)|(?<=[=,(] )-(?=[\w(])|(?<=[(])-(?=[\w(])")


@dataclass(frozen=True)
class Arithmetic:
    """The meaning of literals (without f), operators and elementary functions."""

    literal: Callable[[str], object]
    functions: Mapping[str, Callable[..., sp.Expr]]


SYMBOLIC = Arithmetic(sp.Rational, _MATH | _BINARY)


@dataclass(frozen=True)
class Scalar:
    """double, float or another type of one cell."""

    name: str
    size = 1


@dataclass(frozen=True)
class Array:
    """length × element."""

    element: "Type"
    length: int

    @property
    def size(self) -> int:
        return self.length * self.element.size


@dataclass(frozen=True)
class Record:
    """A struct or union: where each member lies, those of anonymous members included."""

    size: int
    members: dict[str, tuple[int, "Type"]]


Type = Scalar | Array | Record


@dataclass(frozen=True)
class Place:
    """An object in memory, or a part of one; pointers are places too."""

    cells: list[sp.Expr | None]
    start: int
    type: Type

    @classmethod
    def new(cls, kind: Type) -> "Place":
        """A new, unwritten object."""
        return cls([None] * kind.size, 0, kind)

    def member(self, name: str) -> "Place":
        if not isinstance(self.type, Record):
            raise TypeError(f"{self.type} has no member {name}")
        offset, kind = self.type.members[name]
        return Place(self.cells, self.start + offset, kind)

    def element(self, index: int) -> "Place":
        if not isinstance(self.type, Array):
            raise TypeError(f"{self.type} has no elements")
        if not 0 <= index < self.type.length:
            raise IndexError(f"index {index} in an array of {self.type.length}")
        kind = self.type.element
        return Place(self.cells, self.start + index * kind.size, kind)

    def entry(self, *indices: int) -> "Place":
        """The scalar (i) or (row, column) through `at`; matrices lie column by column."""
        place = self.member("at") if isinstance(self.type, Record) else self
        for index in reversed(indices):
            place = place.element(index)
        return place

    def read(self) -> sp.Expr:
        if self.cells[self.start] is None:
            raise ValueError(f"cell {self.start} is read before it is written")
        return self.cells[self.start]

    def write(self, value: sp.Expr) -> None:
        if not isinstance(self.type, Scalar):
            raise TypeError("only scalars are assigned")
        self.cells[self.start] = value

    def copy(self) -> "Place":
        return replace(self, cells=list(self.cells))


Value: TypeAlias = sp.Expr | int | bool | Place


@cache
def header() -> "Header":
    """All functions of all headers."""
    texts = {name: text for family in FAMILIES for name, text in functions_in(family).items()}
    types: dict[str, Type] = {}
    for node in CParser().parse(_clean((INCLUDE / "ksl_types.h").read_text("utf-8"))).ext:
        types[node.name] = _layout(node.type, types)
    return Header(types, texts)


@cache
def functions_in(family: str) -> dict[str, str]:
    """The functions of one header: name → text without comment and `static inline`."""
    text = _clean((INCLUDE / f"{family}.h").read_text("utf-8"))
    if rest := _FUNCTION.sub("", text).strip():
        raise ValueError(f"{family}.h holds more than functions: {rest[:80]!r}")
    results = [(match[1], match[0]) for match in _FUNCTION.finditer(text)]
    if len(dict(results)) != len(results):
        raise ValueError(f"{family}.h defines a function twice")
    return dict(results)


def _clean(text: str) -> str:
    """The text without comments, directives and, at the end, functions that are not formulas."""
    text = text.partition(MARK)[0]
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r"^#(.*\\\n)*.*\n", "", text, flags=re.MULTILINE)
    return text.replace("KSL_VIEW", "struct").replace("static inline ", "")


def sign_flips(text: str, free: tuple[str, ...] = ()) -> Iterator[str]:
    """Yields the text with each binary + or - exchanged for the other, and without each unary -,
    except in calls named in `free`."""
    for match in _SIGNS.finditer(text):
        called = re.findall(r"(\w+) = ", text[:match.start()])
        if called and called[-1].startswith(free or "="):
            continue
        binary = text[match.end()].isspace()
        flipped = {"+": "-", "-": "+"}[match[0]] if binary else ""
        yield text[:match.start()] + flipped + text[match.end():]


_OTHER = {"+": "-", "-": "+"}


def _signs(node: c_ast.Node, free: tuple[str, ...]) -> Iterator[c_ast.BinaryOp | c_ast.UnaryOp]:
    """The sums, differences and negatives in a function, except in calls named in `free`."""
    if isinstance(node, c_ast.Decl) and node.name.startswith(free or "="):
        return
    if isinstance(node, (c_ast.BinaryOp, c_ast.UnaryOp)) and node.op in _OTHER:
        yield node
    for _, child in node.children():
        yield from _signs(child, free)


class Header:
    """Types and functions; each function is parsed when it is first needed."""

    def __init__(self, types: dict[str, Type], texts: dict[str, str],
                 arithmetic: Arithmetic = SYMBOLIC):
        self.types, self.texts, self.arithmetic = types, texts, arithmetic
        self._parsed: dict[str, c_ast.FuncDef] = {}

    def with_text(self, name: str, text: str) -> "Header":
        """Returns the functions with the text of one replaced."""
        return Header(self.types, self.texts | {name: text}, self.arithmetic)

    def flips(self, name: str, free: tuple[str, ...] = ()) -> Iterator["Header"]:
        """Yields the functions with one sign of this one flipped, one for each text of
        `sign_flips`; each is valid until the next is taken."""
        other = Header(self.types, self.texts, self.arithmetic)
        function = other._function(name)
        for node in _signs(function.body, free):
            node.op = _OTHER[node.op]
            yield other
            node.op = _OTHER[node.op]

    def text(self, name: str) -> str:
        """The parsed function."""
        return CGenerator().visit(self._function(name))

    def with_arithmetic(self, arithmetic: Arithmetic) -> "Header":
        """Returns the functions with another arithmetic."""
        other = Header(self.types, self.texts, arithmetic)
        other._parsed = self._parsed
        return other

    def parameters(self, name: str) -> dict[str, Type]:
        """Name → type, without pointer, in order."""
        arguments = self._function(name).decl.type.args.params
        return {p.name: _layout(p.type, self.types) for p in arguments if p.name}

    def constant_parameters(self, name: str) -> set[str]:
        """The parameters that the function promises not to write to."""
        types = ((p.name, getattr(p.type, "type", None)) for p in
                 self._function(name).decl.type.args.params if p.name)
        return {n for n, t in types if "const" in getattr(t, "quals", [])}

    def precisions(self, name: str) -> set[str]:
        """double or float, according to its types, literals and functions."""
        return set(self._precisions(self._function(name)))

    def call(self, name: str, *arguments: Value) -> Value | None:
        """Run the function; places given for pointers are written to.  Returns its value."""
        function = self._function(name)
        parameters = [p for p in function.decl.type.args.params if p.name]
        scope: dict[str, Value] = {}
        for parameter, value in zip(parameters, arguments, strict=True):
            if isinstance(value, Place) and isinstance(parameter.type, c_ast.TypeDecl):
                value = value.copy()  # passed by value
            scope[parameter.name] = value
        return self._run(function.body, scope)

    def _function(self, name: str) -> c_ast.FuncDef:
        if name not in self._parsed:
            names = "".join(f"typedef int {n};\n" for n in ("size_t", *self.types))
            function = CParser().parse(names + self.texts[name]).ext[-1]
            used = set(self._precisions(function))
            if len(used) > 1:
                raise TypeError(f"{name} mixes {' and '.join(sorted(used))}")
            self._parsed[name] = function
        return self._parsed[name]

    def _precisions(self, node: c_ast.Node) -> Iterator[str]:
        """double or float for every type, literal and called function."""
        if isinstance(node, c_ast.IdentifierType):
            yield from {s for s in _scalars(_layout(node, self.types)) if s in ("double", "float")}
        elif isinstance(node, c_ast.Constant) and node.type != "int":
            yield node.type
        elif isinstance(node, c_ast.FuncCall) and node.name.name.removesuffix("f") in {
                *_MATH, _PAIR}:
            yield "float" if node.name.name.endswith("f") else "double"
        elif isinstance(node, c_ast.FuncCall) and node.name.name in _PRODUCTS:
            yield _PRODUCTS[node.name.name]
        elif isinstance(node, c_ast.FuncCall) and node.name.name in self.texts:
            yield from self._precisions(self._function(node.name.name).decl)
        for _, child in node.children():
            yield from self._precisions(child)

    def _run(self, node: c_ast.Node, scope: dict[str, Value]) -> Value | None:
        match node:
            case c_ast.Compound():
                for statement in node.block_items:
                    if (value := self._run(statement, scope)) is not None:
                        return value
            case c_ast.Decl(init=None):
                scope[node.name] = Place.new(_layout(node.type, self.types))
            case c_ast.Decl():
                scope[node.name] = self._value(node.init, scope)
            case c_ast.Assignment(op="="):
                self._place(node.lvalue, scope).write(self._value(node.rvalue, scope))
            case c_ast.If(iffalse=None):
                return self._run(node.iftrue, scope) if self._value(node.cond, scope) else None
            case c_ast.Return():
                return self._value(node.expr, scope)
            case c_ast.Cast(expr=c_ast.ID()):
                pass  # (void)unused;
            case _:
                raise TypeError(f"this reader knows no such C statement: {node}")
        return None

    def _value(self, node: c_ast.Node, scope: dict[str, Value]) -> Value:
        match node:
            case c_ast.ID():
                result = sp.nan if node.name == "NAN" else scope[node.name]
                return result.read() if isinstance(result, Place) and _is_scalar(result) else result
            case c_ast.BinaryOp():
                left, right = self._value(node.left, scope), self._value(node.right, scope)
                return self.arithmetic.functions[node.op](left, right)
            case c_ast.StructRef() | c_ast.ArrayRef():
                place = self._place(node, scope)
                return place.read() if isinstance(place.type, Scalar) else place
            case c_ast.UnaryOp(op="&"):
                return self._place(node.expr, scope)
            case c_ast.Cast():
                return self._value(node.expr, scope)
            case c_ast.UnaryOp(op="-"):
                return -self._number(node.expr, scope)
            case c_ast.UnaryOp(op="+"):
                return self._value(node.expr, scope)
            case c_ast.Constant():
                return (int(node.value) if node.type == "int" else
                        self.arithmetic.literal(node.value.rstrip("f")))
            case c_ast.TernaryOp():
                return self._choice(node, scope)
            case c_ast.FuncCall():
                name, arguments = node.name.name, [self._value(a, scope) for a in node.args.exprs]
                operation = "*" if name in _PRODUCTS else name.removesuffix("f")
                if operation == _PAIR:
                    return self._sine_and_cosine(*arguments)
                known = self.arithmetic.functions.get(operation)
                return known(*arguments) if known else self.call(name, *arguments)
            case _:
                raise TypeError(f"this reader knows no such C expression: {node}")

    def _sine_and_cosine(self, angle: Value, cosine: Value) -> Value:
        assert isinstance(cosine, Place)
        cosine.write(self.arithmetic.functions["ksl_cos"](angle))
        return self.arithmetic.functions["ksl_sin"](angle)

    def _number(self, node: c_ast.Node, scope: dict[str, Value]) -> sp.Expr | int:
        value = self._value(node, scope)
        if isinstance(value, Place):
            raise TypeError(f"wanted a number, got an object: {node}")
        return value

    def _choice(self, node: c_ast.TernaryOp, scope: dict[str, Value]) -> Value:
        condition = self._value(node.cond, scope)
        if condition in (True, False):
            return self._value(node.iftrue if condition else node.iffalse, scope)
        return sp.Piecewise((self._value(node.iftrue, scope), condition),
                            (self._value(node.iffalse, scope), True))

    def _place(self, node: c_ast.Node, scope: dict[str, Value]) -> Place:
        match node:
            case c_ast.ID() if isinstance(place := scope[node.name], Place):
                return place
            case c_ast.StructRef():
                return self._place(node.name, scope).member(node.field.name)
            case c_ast.ArrayRef():
                index = int(self._number(node.subscript, scope))
                return self._place(node.name, scope).element(index)
        raise TypeError(f"this reader knows no such C expression: {node}")


def _layout(node: c_ast.Node, types: dict[str, Type]) -> Type:
    match node:
        case c_ast.IdentifierType():
            return types.get(node.names[-1]) or Scalar(node.names[-1])
        case c_ast.Enum():
            return Scalar("int")
        case c_ast.ArrayDecl():
            return Array(_layout(node.type, types), int(node.dim.value))
        case c_ast.Struct() | c_ast.Union():
            return _record(node, types)
    return _layout(node.type, types)


def _record(node: c_ast.Struct | c_ast.Union, types: dict[str, Type]) -> Record:
    members: dict[str, tuple[int, Type]] = {}
    offset = size = 0
    for declaration in node.decls:
        kind = _layout(declaration.type, types)
        inner = kind.members if isinstance(kind, Record) else {}
        if declaration.name:
            inner = {declaration.name: (0, kind)}
        members |= {name: (offset + start, part) for name, (start, part) in inner.items()}
        size = max(size, offset + kind.size)
        offset = size if isinstance(node, c_ast.Struct) else 0
    return Record(size, members)


def _is_scalar(value: Value) -> bool:
    """Returns whether this is a variable of one cell."""
    return isinstance(value, Place) and isinstance(value.type, Scalar)


def _scalars(kind: Type) -> Iterator[str]:
    match kind:
        case Scalar():
            yield kind.name
        case Array():
            yield from _scalars(kind.element)
        case Record():
            for _, part in kind.members.values():
                yield from _scalars(part)
