"""Formulas of scene files: functions of time such as "0.5*sin(2*pi*t)".

A formula is parsed once and kept in the order of evaluation, so that it can be evaluated on any
numbers (floats, 50 digits, Numbers of kernels) without recursion and without Python's `eval`.
"""

import ast
import math
import operator
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import Any, TypeVar

from coscrew_codegen.program.tables import index_of
from coscrew_codegen.scene.names import or_mean

LENGTH = 1000  # characters
NESTING = 50  # levels of parentheses, signs and exponents
POWER = 100  # the largest exponent, or product of nested exponents: (t**10)**10

FUNCTIONS = {"sin": 1, "cos": 1, "exp": 1, "tanh": 1, "sqrt": 1, "abs": 1, "min": 2, "max": 2}
"""The functions and their numbers of arguments; min and max also take more."""

_OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
              ast.Div: operator.truediv}
_DECIMAL = re.compile(r"(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,4})?")
_GLUED = re.compile(r"(?<![\w.])[0-9.]++(?:[eE][+-]?[0-9]+)?+[A-Za-z_]\w*")  # 2t
_UNIT = re.compile(r"\s*[+-]?[0-9.]++(?:[eE][+-]?[0-9]+)?+\s*(?!pi\b|t\b|x)"
                   r"([A-Za-z%°µ][\w/*^%°·]*)\s*")  # 2 kg
TIME: tuple[str, ...] = ("t",)
PLACE = ("x", "y")
"""Variables of formulas: the time, in s, or a place, in m."""

_DOUBLES = {"sin": math.sin, "cos": math.cos, "exp": math.exp, "tanh": math.tanh, "sqrt": math.sqrt,
            "abs": abs, "min": min, "max": max, "pi": math.pi, "number": float,
            "less": operator.lt, "where": lambda test, a, b: a if test else b, "index": index_of,
            "gather": lambda column, at: float(column.at(at))}


V = TypeVar("V")  # the kind of numbers that a formula is evaluated on


class FormulaError(ValueError):
    """The text is not a valid formula."""


@dataclass(frozen=True)
class _Step:
    """One step of the evaluation: pops its operands from a stack and pushes its result."""

    word: str  # number, t, pi, name of a function, operator, power, sqrt
    operands: int = 0
    number: Fraction | None = None  # of a number; of a power, its exponent
    apply: Callable[..., Any] | None = None  # of an operator, on any kind of numbers


@dataclass(frozen=True)
class Formula:
    """A function of the time t in s, or of other variables.

    It consists of numbers, t, pi, + - * /, ** (with a constant integer or half-integer exponent),
    sin, cos, exp, tanh, sqrt, abs, min, max.  Raises FormulaError for anything else, naming what
    came and what was wanted."""

    text: str
    of: tuple[str, ...] = field(default=TIME, repr=False, kw_only=True)
    _steps: tuple[_Step, ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_steps", tuple(_Reading(self.text, self.of).steps()))

    @property
    def timed(self) -> bool:
        """True if t occurs; without it a formula is a constant."""
        return any(step.word == "t" for step in self._steps)

    @property
    def is_number(self) -> bool:
        """True if it is a plain number, perhaps with a sign: "2", "-1e-3"."""
        return all(step.word in ("number", "negative") for step in self._steps)

    def value(self, t: V, functions: Mapping[str, object]) -> V:
        """The formula at the time t, for any kind of numbers.

        `functions` has an entry for each of FUNCTIONS (min and max with two arguments), "number",
        which converts a Fraction to this kind, and "pi"; and, of variables other than t, a function
        without arguments that returns each."""
        stack: list[V] = []
        for step in self._steps:
            operands = stack[len(stack) - step.operands:]
            del stack[len(stack) - step.operands:]
            stack.append(_evaluated(step, operands, t, functions))
        return stack.pop()

    def at(self, t: float) -> float:
        """The formula in double precision at the time t, or with t for each of its variables; NaN
        where it is not finite."""
        try:
            result = self.value(t, {**_DOUBLES, **{x: lambda: t for x in self.of}})
        except (ArithmeticError, ValueError):
            return math.nan
        return result if math.isfinite(result) else math.nan


def _evaluated(step: _Step, operands: list[V], t: V, functions: Mapping[str, Any]) -> V:
    if step.word == "t":
        return t
    if step.word == "pi":
        result: V = functions["pi"]
    elif step.word == "number":
        result = functions["number"](step.number)
    elif step.word == "power" and step.number is not None:
        result = _power(operands[0], step.number, functions)
    else:
        result = (step.apply or functions[step.word])(*operands)
    return result


def _power(base: Any, exponent: Fraction, functions: Mapping[str, Any]) -> Any:
    """base ** exponent by products and a square root; the exponent is a multiple of 1/2."""
    if exponent.denominator == 2:
        base = functions["sqrt"](base)
    result, square, left = None, base, abs(exponent.numerator)
    while left:
        if left & 1:
            result = square if result is None else result * square
        left >>= 1
        square = square * square if left else square
    one = functions["number"](Fraction(1))
    if result is None:
        return one
    return result if exponent > 0 else one / result


class _Reading:
    """Parses one formula."""

    def __init__(self, text: str, variables: tuple[str, ...]) -> None:
        self.text, self.variables = text, variables
        names = ", ".join((*variables, "pi"))
        self.wanted = f"numbers, {names}, + - * / **, parentheses and {', '.join(FUNCTIONS)}"
        self.known = (f"formulas know {', '.join(variables)}, pi and the functions "
                      f"{', '.join(FUNCTIONS)}")

    def steps(self) -> Iterator[_Step]:
        """The steps, operands before the operations on them."""
        text = self.text
        if len(text) > LENGTH:
            raise self._error(f"{len(text)} characters; wanted at most {LENGTH}")
        if not text.strip():
            raise self._error(f"nothing there; wanted {self.wanted}")
        if match := _UNIT.fullmatch(text):
            raise self._error(f"unexpected {_short(match[1])!r}; wanted the number alone: units "
                              "are those of SI, angles in rad")
        if match := re.search(r"[^A-Za-z0-9_+\-*/(),. ]", text):
            hint = "; powers are written **" if match[0] == "^" else ""
            raise self._error(f"unexpected {match[0]!r}{hint}; wanted {self.wanted}")
        if match := _GLUED.search(text):
            raise self._error(f"unexpected {match[0]!r}; wanted a number, or * between factors")
        if "//" in text:
            raise self._error(f"unexpected '//'; wanted {self.wanted}")
        try:
            tree = ast.parse(text.strip(), mode="eval").body
        except (SyntaxError, ValueError, MemoryError, RecursionError) as error:
            reason = error.msg if isinstance(error, SyntaxError) else "too deeply nested"
            raise self._error(f"cannot be read ({reason}); wanted {self.wanted}") from None
        return self._of(tree, NESTING, POWER)

    def _of(self, node: ast.expr, nesting: int, power: int) -> Iterator[_Step]:
        """The steps of a node.  The left operands of a long sum are visited in a loop and do not
        count as nesting."""
        if nesting == 0:
            raise self._error(f"wanted at most {NESTING} levels of nesting")
        later: list[_Step | ast.expr] = []
        while isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
            later += [_Step("operator", 2, apply=_OPERATORS[type(node.op)]), node.right]
            node = node.left
        yield from self._term(node, nesting, power)
        for item in reversed(later):
            if isinstance(item, _Step):
                yield item
            else:
                yield from self._of(item, nesting - 1, power)

    def _term(self, node: ast.expr, nesting: int, power: int) -> Iterator[_Step]:
        match node:
            case ast.Constant():
                yield _Step("number", number=self._number(node))
            case ast.Name():
                yield self._name(node.id)
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                yield from self._of(operand, nesting - 1, power)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                yield from self._of(operand, nesting - 1, power)
                yield _Step("negative", 1, apply=operator.neg)
            case ast.BinOp(left=base, op=ast.Pow(), right=right):
                exponent = self._exponent(right, power)
                yield from self._of(base, nesting - 1, power // max(1, -(-abs(exponent) // 1)))
                yield _Step("power", 1, number=exponent)
            case ast.Call():
                yield from self._call(node, nesting, power)
            case _:
                raise self._error(f"unexpected {_short(self._part(node))!r}; wanted {self.wanted}")

    def _name(self, name: str) -> _Step:
        if name in (*self.variables, "pi"):
            return _Step(name)
        if name in FUNCTIONS:
            raise self._error(f"{name!r} lacks its argument; wanted {name}(…)")
        hint = or_mean(name, (*self.variables, "pi", *FUNCTIONS))
        raise self._error(f"unknown name {_short(name)!r}{hint}; {self.known}")

    def _call(self, node: ast.Call, nesting: int, power: int) -> Iterator[_Step]:
        name = self._part(node.func)
        if name not in FUNCTIONS:
            hint = or_mean(name, FUNCTIONS)
            raise self._error(f"unknown function {_short(name)!r}{hint}; {self.known}")
        wanted, came = FUNCTIONS[name], len(node.args) + len(node.keywords)
        if node.keywords or came < wanted or (wanted == 1 and came > 1):
            count = "one argument" if wanted == 1 else "two arguments or more"
            raise self._error(f"{_short(self._part(node))!r} has {came} arguments; "
                              f"{name} takes {count}")
        for i, argument in enumerate(node.args):
            yield from self._of(argument, nesting - 1, power)
            if i >= wanted - 1:
                yield _Step(name, wanted)

    def _number(self, node: ast.Constant) -> Fraction:
        digits = self._part(node)
        if not _DECIMAL.fullmatch(digits):
            raise self._error(f"unexpected {_short(digits)!r}; wanted decimal numbers such as 1e-3")
        number = Fraction(Decimal(digits))
        if number and not Fraction(10)**-300 <= number <= Fraction(10)**300:
            raise self._error(f"{_short(digits)} is out of range; wanted 0, or 1e-300 to 1e300")
        return number

    def _exponent(self, node: ast.expr, power: int) -> Fraction:
        """A constant exponent such as 2, -1, 0.5 or (1/2)."""
        came = _short(self._part(node))
        exponent = self._constant(node, came, 3)
        if exponent.denominator > 2:
            raise self._error(f"exponent {came}: wanted an integer, or a half such as 1.5")
        if abs(exponent) > power:
            raise self._error(f"exponent {came}: wanted exponents, multiplied where they are "
                              f"nested, of at most {POWER}")
        return exponent

    def _constant(self, node: ast.expr, came: str, nesting: int) -> Fraction:
        if isinstance(node, ast.Constant):
            return self._number(node)
        if nesting and isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -self._constant(node.operand, came, nesting - 1)
        if nesting and isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
            above, below = (self._constant(x, came, nesting - 1) for x in (node.left, node.right))
            if not below:
                raise self._error(f"exponent {came!r} divides by zero")
            return above / below
        raise self._error(f"exponent {came!r} is no number; wanted a constant such as 2 or 1/2")

    def _part(self, node: ast.AST) -> str:
        """The text of a node."""
        return ast.get_source_segment(self.text.strip(), node) or ""

    def _error(self, problem: str) -> FormulaError:
        return FormulaError(f"formula {_short(self.text)!r}: {problem}")


def _short(text: str) -> str:
    """At most 60 characters of a text."""
    return text if len(text) <= 60 else f"{text[:59]}…"
