"""Evaluates emitted text and kernels to 60 digits, with the emitted constants.

In exact arithmetic the corrections of rounding errors are zero, and so are mistakes in them.
Therefore, if asked for, some operations are rounded as in the kernel's precision: roots, quotients,
multiples of GRID, sums with these, and squares of such sums, which are exact if they are right.
All other operations are never rounded.
"""

import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property, partial, reduce
from types import FunctionType, SimpleNamespace
from typing import TypeAlias

import mpmath as mp
import numpy as np
import sympy as sp

from coscrew_codegen.formats import PRECISIONS, Precision
from coscrew_codegen.kernel import Kernel
from coscrew_codegen.operations import OPERATIONS, PER_PRECISION, scaled
from coscrew_codegen.operations.operation import GRID
from coscrew_codegen.program import Op
from tests.support.compiled.c_reader import Arithmetic
from tests.support.truth.attack import plain_program

DIGITS = 60
Factor: TypeAlias = tuple[sp.Expr, sp.Rational]  # base and exponent


@dataclass(frozen=True)
class Rules:
    """Rules for numbers: whether constants and some operations are rounded to a precision."""

    precision: Precision
    rounds: bool = False
    exact: bool = False  # whether constants are exact, as in formulas

    def number(self, value: object) -> "Number":
        return value if isinstance(value, Number) else Number(mp.mpmathify(value), self)

    def literal(self, text: str) -> "Number":
        """The number in this precision that the text denotes."""
        return self.number(_literal(self.precision, text))

    def constant(self, value: sp.Rational) -> "Number":
        if self.exact:
            return self.number(mp.mpf(int(value.p)) / int(value.q))
        return self.number(_rounded(self.precision, value))

    def named(self, symbol: sp.Symbol) -> "Number":
        return self.constant(PER_PRECISION[symbol][PRECISIONS.index(self.precision)])

    def rounded(self, function: Callable[..., mp.mpf], *values: mp.mpf) -> mp.mpf:
        if not self.rounds:
            return function(*values)
        with mp.workprec(np.finfo(self.precision.numpy_type).nmant + 1):
            return function(*values)

    @cached_property
    def grid(self) -> mp.mpf:
        return mp.mpf(int(PER_PRECISION[GRID][PRECISIONS.index(self.precision)]))

    def sum(self, function: Callable[..., mp.mpf], x: "Number", y: "Like") -> "Number":
        on_grid = x.is_grid or isinstance(y, Number) and y.is_grid
        found = x._with(partial(self.rounded, function) if on_grid else function, y)
        found.on_grid = on_grid
        return found

    def product(self, x: "Number", y: "Like") -> "Number":
        square = x.on_grid and isinstance(y, Number) and y.on_grid and x.value == y.value
        is_grid = self.grid in (x.value, value_of(y))
        found = x._with(partial(self.rounded, operator.mul) if square or is_grid else
                        operator.mul, y)
        found.is_grid = is_grid
        return found

    def quotient(self, x: mp.mpf, y: mp.mpf) -> mp.mpf:
        return self.rounded(operator.truediv, x, y)

    def root(self, x: mp.mpf) -> mp.mpf:
        return self.rounded(mp.sqrt, x) if x >= 0 else mp.nan


@cache
def _literal(precision: Precision, text: str) -> mp.mpf:
    return mp.mpf(float(np.dtype(precision.numpy_type).type(text)))


@cache
def _rounded(precision: Precision, value: sp.Rational) -> float:
    return float(precision.rounded(Fraction(int(value.p), int(value.q))))


class Number:
    """A number under rules."""

    def __init__(self, value: mp.mpf, rules: Rules):
        self.value, self.rules = value, rules
        self.is_grid = False  # a multiple of GRID
        self.on_grid = False  # a sum with one

    def _with(self, function: Callable[..., mp.mpf], *others: "Like") -> "Number":
        return Number(function(self.value, *map(value_of, others)), self.rules)

    def __add__(self, other: "Like") -> "Number": return self.rules.sum(operator.add, self, other)
    def __sub__(self, other: "Like") -> "Number": return self.rules.sum(operator.sub, self, other)
    def __rsub__(self, other: "Like") -> "Number": return -self + other
    def __mul__(self, other: "Like") -> "Number": return self.rules.product(self, other)
    def __truediv__(self, other: "Like") -> "Number": return self._with(self.rules.quotient, other)
    def __rtruediv__(self, other: "Like") -> "Number": return self.rules.number(other) / self
    def __neg__(self) -> "Number": return self._with(operator.neg)
    def __lt__(self, other: "Like") -> bool: return bool(self.value < value_of(other))
    def __gt__(self, other: "Like") -> bool: return bool(self.value > value_of(other))
    def __eq__(self, other: object) -> bool: return bool(self.value == value_of(other))
    __radd__, __rmul__ = __add__, __mul__

    def sqrt(self) -> "Number":
        return self._with(self.rules.root)


Like: TypeAlias = Number | int


def value_of(x: object) -> mp.mpf:
    if isinstance(x, Number):
        return x.value
    if isinstance(x, int):
        return mp.mpf(x)
    raise TypeError(f"{x!r} came in beside the rules")


_FUNCTIONS: dict[str, Callable[..., Number]] = {
    "abs": lambda x: x._with(abs), "sqrt": Number.sqrt, "sin": lambda x: x._with(mp.sin),
    "cos": lambda x: x._with(mp.cos), "atan2": lambda y, x: y._with(mp.atan2, x)}

_FUNCTIONS["atan2_error"] = lambda y, x, angle: _FUNCTIONS["atan2"](y, x) - angle

_ELEMENTARY = ("sin", "cos", "atan2", "atan2_error")

_SYMPY: dict[type[sp.Basic], Callable[..., Number | bool]] = {
    sp.Equality: operator.eq, scaled: operator.mul, sp.Abs: _FUNCTIONS["abs"],
    sp.sin: _FUNCTIONS["sin"], sp.cos: _FUNCTIONS["cos"], sp.atan2: _FUNCTIONS["atan2"]}


def can_evaluate(expression: sp.Expr) -> bool:
    """Whether the expression contains none of the special functions of formulas."""
    return {type(f) for f in expression.atoms(sp.Function)} <= {*_SYMPY, sp.Piecewise}


def c_arithmetic(rules: Rules) -> Arithmetic:
    """C's operators and functions under these rules."""
    return Arithmetic(rules.literal, {
        "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv,
        "<": operator.lt, "==": operator.eq, "fabs": _FUNCTIONS["abs"],
        "sqrt": Number.sqrt, **{f"ksl_{name}": _FUNCTIONS[name] for name in _ELEMENTARY}})


def python_function(function: FunctionType, rules: Rules) -> FunctionType:
    """A kernel's Python function under these rules."""
    elementary = SimpleNamespace(
        **{name: _FUNCTIONS[name] for name in _ELEMENTARY},
        sincos=lambda x: (_FUNCTIONS["sin"](x), _FUNCTIONS["cos"](x)))
    names = {"absolute": _FUNCTIONS["abs"], "sqrt": Number.sqrt, "elementary": elementary,
             "where": lambda test, x, y: rules.number(x if test else y),
             "float64": rules.number, "float32": rules.number, "nan": rules.number(mp.nan)}
    constants = tuple(rules.literal(repr(x)) if isinstance(x, float) else x
                      for x in function.__code__.co_consts)
    return FunctionType(function.__code__.replace(co_consts=constants),
                        function.__globals__ | names, function.__name__)


class Evaluator:
    """SymPy expressions under rules; `seen` collects the conditions that were tested, with results.
    """

    def __init__(self, rules: Rules, values: Mapping[sp.Symbol, Number]):
        self.rules = rules
        self.values: dict[sp.Symbol, Number | bool] = dict(values)
        self.seen: set[tuple[sp.Basic, bool]] = set()

    def kernel(self, kernel: Kernel) -> list[Number]:
        """Every component of every output."""
        for binding in kernel.bindings:
            self.values[binding.symbol] = self(binding.expression)
        return [self.number(x) for x in kernel.values]

    def __call__(self, x: sp.Basic) -> Number | bool:
        if x.is_Symbol:
            return self.rules.named(x) if x in PER_PRECISION else self.values[x]
        if x is sp.nan:
            return self.rules.number(mp.nan)
        if x.is_Rational:
            return self.rules.constant(x)
        if isinstance(x, sp.Piecewise):
            return next(self(value) for value, test in x.args
                        if test == sp.true or self.holds(test))
        if x.is_Pow or x.is_Mul:
            return self._product(x)
        if isinstance(x, sp.ITE):
            test, yes, no = x.args
            return self(yes if self(test) else no)
        if isinstance(x, (sp.StrictLessThan, sp.StrictGreaterThan)):
            return self.number(x.lts) < self.number(x.gts)
        return self._by_type(x, [self(argument) for argument in x.args])

    def number(self, x: sp.Basic) -> Number:
        """The value of an expression that is a number."""
        found = self(x)
        if isinstance(found, bool):
            raise TypeError(f"{x} is a condition")
        return found

    def _by_type(self, x: sp.Basic, values: list[Number | bool]) -> Number | bool:
        kind = type(x)
        if kind in (sp.Add, sp.And):
            return reduce({sp.Add: operator.add, sp.And: operator.and_}[kind], values)
        return _SYMPY[kind](*values)

    def holds(self, test: sp.Basic) -> bool:
        for part in sp.And.make_args(test):
            result = bool(self(part))
            self.seen.add((part, result))
            if not result:
                return False
        return True

    def _product(self, x: sp.Expr) -> Number:
        above, below = ([self._power(*factor) for factor in part] for part in _factors(x))
        above = above or [self.rules.number(1)]
        product = reduce(operator.mul, above)
        return product / reduce(operator.mul, below) if below else product

    def _power(self, base: sp.Expr, exponent: sp.Rational) -> Number:
        x = self.number(base)
        if exponent == sp.Rational(1, 2):
            return x.sqrt()
        return reduce(operator.mul, [x] * int(exponent))


@cache
def _factors(x: sp.Expr) -> tuple[list[Factor], list[Factor]]:
    """Bases and exponents, above and below the line: all that divide do so at once."""
    factors = [factor.as_base_exp() for factor in sp.Mul.make_args(x)]
    return ([(base, exponent) for base, exponent in factors if not exponent.is_negative],
            [(base, -exponent) for base, exponent in factors if exponent.is_negative])


SYMBOLIC = {Op.ADD, Op.SUB, Op.MUL, Op.DIV, Op.NEG, Op.SIN, Op.COS}
NUMERIC = tuple(op for op in OPERATIONS if op.family != "elementary"
                and not set(plain_program(op).counts) <= SYMBOLIC)
