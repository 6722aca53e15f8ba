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
from functools import cache, cached_property, reduce
from types import FunctionType, SimpleNamespace
from typing import TypeAlias

import gmpy2
import mpmath as mp
import numpy as np
import sympy as sp
from gmpy2 import mpfr, mpq

from coscrew_codegen.algebra.lowering.kernel import Kernel
from coscrew_codegen.algebra.operations import OPERATIONS, PER_PRECISION, scaled, truncated
from coscrew_codegen.algebra.operations.operation import GRID
from coscrew_codegen.program import Op
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.support.compiled.c_reader import Arithmetic
from tests.support.truth.attack import plain_program

DIGITS = 60
WIDE = gmpy2.context(precision=203)  # DIGITS
_NARROW = {p: gmpy2.context(precision=p.digits) for p in PRECISIONS}
NAN, _ZERO = mpfr("nan"), mpfr(0)
Factor: TypeAlias = tuple[sp.Expr, sp.Rational]  # base and exponent


@dataclass(frozen=True)
class Rules:
    """Rules for numbers: whether constants and some operations are rounded to a precision."""

    precision: Precision
    rounds: bool = False
    exact: bool = False  # whether constants are exact, as in formulas

    def number(self, value: object) -> "Number":
        return value if isinstance(value, Number) else Number(wide(value), self)

    def literal(self, text: str) -> "Number":
        """The number in this precision that the text denotes."""
        return Number(_literal(self.precision, text), self)

    def constant(self, value: sp.Rational) -> "Number":
        return Number(_exactly(value) if self.exact else _rounded(self.precision, value), self)

    def named(self, symbol: sp.Symbol) -> "Number":
        return self.constant(PER_PRECISION[symbol][PRECISIONS.index(self.precision)])

    @cached_property
    def arithmetic(self) -> gmpy2.context:
        """The arithmetic of operations that may be rounded."""
        return _NARROW[self.precision] if self.rounds else WIDE

    @cached_property
    def grid(self) -> mpfr:
        return mpfr(int(PER_PRECISION[GRID][PRECISIONS.index(self.precision)]))


def wide(value: object) -> mpfr:
    """The number, exactly."""
    if isinstance(value, mp.mpf):
        sign, mantissa, exponent, _ = value._mpf_
        return WIDE.mul(mpfr(mpq(2)**exponent), (-1)**sign * mantissa)
    return mpfr(value, WIDE.precision)


@cache
def _literal(precision: Precision, text: str) -> mpfr:
    return mpfr(float(np.dtype(precision.numpy_type).type(text)))


@cache
def _rounded(precision: Precision, value: sp.Rational) -> mpfr:
    return mpfr(float(precision.rounded(Fraction(int(value.p), int(value.q)))))


@cache
def _exactly(value: sp.Rational) -> mpfr:
    return WIDE.div(int(value.p), int(value.q))


class Number:
    """A number under rules."""

    __slots__ = ("value", "rules", "is_grid", "on_grid")

    def __init__(self, value: mpfr, rules: Rules, is_grid: bool = False, on_grid: bool = False):
        self.value, self.rules = value, rules
        self.is_grid = is_grid  # a multiple of GRID
        self.on_grid = on_grid  # a sum with one

    def _added(self, other: "Like", sign: str) -> "Number":
        on_grid = self.is_grid or isinstance(other, Number) and other.is_grid
        add = getattr(self.rules.arithmetic if on_grid else WIDE, sign)
        return Number(add(self.value, value_of(other)), self.rules, False, on_grid)

    def __add__(self, other: "Like") -> "Number":
        return self._added(other, "add")

    def __sub__(self, other: "Like") -> "Number":
        return self._added(other, "sub")

    def __rsub__(self, other: "Like") -> "Number":
        return -self + other

    def __mul__(self, other: "Like") -> "Number":
        x, y, grid = self.value, value_of(other), self.rules.grid
        square = self.on_grid and isinstance(other, Number) and other.on_grid and x == y
        is_grid = grid in (x, y)
        arithmetic = self.rules.arithmetic if square or is_grid else WIDE
        return Number(arithmetic.mul(x, y), self.rules, is_grid)

    def __truediv__(self, other: "Like") -> "Number":
        if not (y := value_of(other)):
            raise ZeroDivisionError
        return Number(self.rules.arithmetic.div(self.value, y), self.rules)

    def __rtruediv__(self, other: "Like") -> "Number":
        return self.rules.number(other) / self

    def __neg__(self) -> "Number":
        return Number(WIDE.minus(self.value), self.rules)

    def __abs__(self) -> "Number":
        return Number(WIDE.abs(self.value), self.rules)

    def __lt__(self, other: "Like") -> bool:
        return bool(self.value < value_of(other))

    def __gt__(self, other: "Like") -> bool:
        return bool(self.value > value_of(other))

    def __eq__(self, other: object) -> bool:
        return bool(self.value == value_of(other))

    __radd__, __rmul__ = __add__, __mul__

    def sqrt(self) -> "Number":
        x = self.value
        return Number(self.rules.arithmetic.sqrt(x) if x >= 0 else NAN, self.rules)

    def sin(self) -> "Number":
        return Number(WIDE.sin(self.value), self.rules)

    def cos(self) -> "Number":
        return Number(WIDE.cos(self.value), self.rules)

    def atan2(self, other: "Number") -> "Number":
        """Zeros have no sign."""
        return Number(WIDE.atan2(self.value or _ZERO, other.value or _ZERO), self.rules)


Like: TypeAlias = Number | int


def value_of(x: object) -> mpfr:
    if isinstance(x, Number):
        return x.value
    if isinstance(x, int):
        return mpfr(x)
    raise TypeError(f"{x!r} came in beside the rules")


_FUNCTIONS: dict[str, Callable[..., Number]] = {
    "abs": abs, "sqrt": Number.sqrt, "sin": Number.sin, "cos": Number.cos,
    "atan2": Number.atan2, "atan2_error": lambda y, x, angle: y.atan2(x) - angle}

_ELEMENTARY = ("sin", "cos", "atan2", "atan2_error")

_SYMPY: dict[type[sp.Basic], Callable[..., Number | bool]] = {
    sp.Equality: operator.eq, scaled: operator.mul, truncated: lambda last, tail: last,
    sp.Abs: _FUNCTIONS["abs"],
    sp.sin: _FUNCTIONS["sin"], sp.cos: _FUNCTIONS["cos"], sp.atan2: _FUNCTIONS["atan2"]}


def can_evaluate(expression: sp.Expr) -> bool:
    """Returns whether the expression contains none of the special functions of formulas."""
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
             **dict.fromkeys(("float64", "float32", "real"), rules.number),
             "nan": rules.number(NAN)}

    def constant(x: object) -> object:
        return rules.literal(repr(x)) if isinstance(x, float) else x

    constants = tuple(map(constant, function.__code__.co_consts))
    made = FunctionType(function.__code__.replace(co_consts=constants),
                        function.__globals__ | names, function.__name__)
    made.__kwdefaults__ = {k: constant(x) for k, x in (function.__kwdefaults__ or {}).items()}
    return made


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
            return self.rules.number(NAN)
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
        result = self(x)
        if isinstance(result, bool):
            raise TypeError(f"{x} is a condition")
        return result

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
