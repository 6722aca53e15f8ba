"""The plain tier: a fixed order of evaluation, every operation rounded once.

The order is decided here, never by a printer or by SymPy:

- A sum is a sum of items.  Two terms of opposite sign that are each other's mirror image form an
  item, so that an antisymmetric product of equal arguments is exactly zero: [ad](a) b is evaluated
  as (a1 b5 - a5 b1) + (a4 b2 - a2 b4).  The remaining terms form one item for each pair of parts
  that they multiply (the rows of R by f, say), summed by index.  Items are added in the order of
  their first terms, the first positive one leading.
- The factors of a product are multiplied in the order inputs, then lets, by index.
"""

import string
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial

import sympy as sp

from coscrew_codegen.algebra.lowering.kernel import Kernel
from coscrew_codegen.algebra.operations import PER_PRECISION, scaled, truncated
from coscrew_codegen.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
)

_NAMED = {symbol: Constant(Fraction(int(double.p), int(double.q)),
                           Fraction(int(single.p), int(single.q)))
          for symbol, (double, single) in PER_PRECISION.items()}


def plain(kernel: Kernel) -> Program:
    """The kernel's program in the plain tier."""
    scheduler = _Scheduler(kernel)
    for binding in kernel.bindings:
        scheduler.bind(binding.symbol, scheduler.evaluate(binding.expression, binding.symbol.name))
    names = [symbol.name for argument in kernel.outputs for symbol in argument.symbols]
    results = tuple(map(scheduler.evaluate, kernel.values, names))
    return Program(kernel.name, kernel.inputs, kernel.outputs, tuple(scheduler.instructions),
                   results)


@dataclass(frozen=True, order=True)
class Position:
    """Place of a symbol: its argument or let, the part of that, the index in the part."""

    source: int
    part: int
    index: int


@dataclass(frozen=True)
class ScheduledTerm:
    """sign · coefficient · factors, one term of a sum."""

    negative: bool
    coefficient: sp.Rational
    factors: tuple[sp.Expr, ...]
    places: tuple[Position, ...]  # of the factors; terms are sorted and grouped by them

    @property
    def parts(self) -> tuple[tuple[int, int], ...]:
        return tuple((place.source, place.part) for place in self.places)


@dataclass(frozen=True)
class Item:
    """Terms evaluated together, as one operand of the outer sum."""

    terms: tuple[ScheduledTerm, ...]

    @property
    def negative(self) -> bool:
        return all(term.negative for term in self.terms)


_LAST = Position(1 << 30, 0, 0)  # factors that are not symbols sort after all symbols


class _Scheduler:
    """Lowers SymPy expressions to instructions; equal instructions are issued once."""

    def __init__(self, kernel: Kernel):
        self.instructions: list[Instruction] = []
        self._issued: dict[tuple[Op, tuple[Operand, ...]], Ref] = {}
        self._operands: dict[sp.Symbol, Operand] = {}
        self._positions: dict[sp.Symbol, Position] = {}
        for number, argument in enumerate(kernel.inputs):
            places = (argument.quantity.place(*rc) for rc in argument.quantity.indices)
            for index, (symbol, place) in enumerate(zip(argument.symbols, places, strict=True)):
                self._operands[symbol] = Input(number, index)
                self._positions[symbol] = Position(number, *place)
        groups = tuple(dict.fromkeys(binding.group for binding in kernel.bindings))
        for binding in kernel.bindings:
            source = len(kernel.inputs) + groups.index(binding.group)
            self._positions[binding.symbol] = Position(source, 0, binding.index)
        self._inputs = {symbol.name for symbol in self._operands}
        self._component = ""
        self._temporaries = 0

    def bind(self, symbol: sp.Symbol, operand: Operand) -> None:
        """Let `symbol` stand for `operand` in later expressions."""
        self._operands[symbol] = operand

    def evaluate(self, expression: sp.Expr, component: str) -> Operand:
        """The operand that holds `expression`.  The last instruction is named after `component`,
        the earlier ones by that name and a letter."""
        self._component = f"{component}_new" if component in self._inputs else component
        self._temporaries = 0
        return self._lower(expression, self._component)

    def _lower(self, expression: sp.Expr, name: str = "") -> Operand:
        if expression.is_Symbol:
            return _NAMED.get(expression) or self._operands[expression]
        if expression is sp.nan:
            return NotANumber()
        if expression.is_Rational:
            return _constant(expression)
        if expression.is_Add:
            return self._sum(expression, name)
        if expression.is_Mul:
            return self._product(expression, name)
        if expression.is_Pow:
            return self._power(expression, name)
        if isinstance(expression, sp.Piecewise):
            return self._piecewise(expression, name)
        if isinstance(expression, (sp.StrictLessThan, sp.StrictGreaterThan)):
            return self._issue(Op.LESS, map(self._lower, (expression.lts, expression.gts)), name)
        if isinstance(expression, truncated):
            return replace(_constant(expression.args[0]), tail=_constant(expression.args[1]).double)
        if type(expression) in _FUNCTIONS:
            return self._issue(_FUNCTIONS[type(expression)], map(self._lower, expression.args),
                               name)
        raise TypeError(f"the plain tier cannot evaluate {expression.func.__name__}: {expression}")

    def _issue(self, op: Op, operands: Iterable[Operand], name: str = "") -> Ref:
        key = (op, tuple(operands))
        if key not in self._issued:
            if not name:
                name = self._temporary()
            self._issued[key] = Ref(name)
            self.instructions.append(Instruction(name, *key, self._component))
        return self._issued[key]

    def _temporary(self) -> str:
        """The component's name and a letter: co_3a, power_a; after z, two letters."""
        count, self._temporaries = self._temporaries, self._temporaries + 1
        high, low = divmod(count, 26)
        letters = (string.ascii_lowercase[high - 1] if high else "") + string.ascii_lowercase[low]
        joint = "" if self._component[-1].isdigit() else "_"
        return f"{self._component}{joint}{letters}"

    def _term(self, expression: sp.Expr) -> ScheduledTerm:
        coefficient, rest = expression.as_coeff_Mul()
        placed = sorted(((self._positions.get(factor, _LAST), sp.default_sort_key(factor), factor)
                         for factor in sp.Mul.make_args(rest)), key=lambda entry: entry[:2])
        return ScheduledTerm(bool(coefficient < 0), abs(coefficient),
                             tuple(entry[2] for entry in placed),
                             tuple(entry[0] for entry in placed))

    def _sum(self, expression: sp.Expr, name: str) -> Operand:
        terms = sorted(map(self._term, expression.args), key=lambda t: (t.places, t.negative))
        items = _items(terms)
        negative = all(item.negative for item in items)
        total = self._signed_sum([(item.negative, partial(self._item, item)) for item in items],
                                 "" if negative else name)
        return self._issue(Op.NEG, (total,), name) if negative else total

    def _item(self, item: Item, name: str) -> Operand:
        """The item's value, or its negative if all its terms are negative."""
        return self._signed_sum([(term.negative, partial(self._unsigned, term))
                                 for term in item.terms], name)

    def _signed_sum(self, parts: list[tuple[bool, Callable[[str], Operand]]],
                    name: str) -> Operand:
        """The parts added in order, the first positive one leading; negated if all are negative."""
        lead = next((i for i, (negative, _) in enumerate(parts) if not negative), 0)
        lead_negative, evaluate = parts.pop(lead)
        total = evaluate("" if parts else name)
        while parts:
            negative, evaluate = parts.pop(0)
            operand = evaluate("")
            total = self._issue(Op.ADD if negative == lead_negative else Op.SUB, (total, operand),
                                "" if parts else name)
        return total

    def _unsigned(self, term: ScheduledTerm, name: str) -> Operand:
        return self._lower(sp.Mul(term.coefficient, *term.factors), name)

    def _product(self, expression: sp.Expr, name: str) -> Operand:
        divisors = [x for x in sp.Mul.make_args(expression) if x.is_Pow and x.exp.is_negative]
        if divisors:
            denominator = sp.Mul(*(1 / x for x in divisors))
            operands = (self._lower(expression * denominator), self._lower(denominator))
            return self._issue(Op.DIV, operands, name)
        term = self._term(expression)
        factors = [self._lower(factor) for factor in sorted(
            term.factors, key=lambda x: not isinstance(x, truncated))]  # coefficients lead
        if term.coefficient != 1:
            factors.insert(0, _constant(term.coefficient))
        total = factors.pop(0)
        while factors:
            last = len(factors) == 1 and not term.negative
            total = self._issue(Op.MUL, (total, factors.pop(0)), name if last else "")
        return self._issue(Op.NEG, (total,), name) if term.negative else total

    def _power(self, expression: sp.Pow, name: str) -> Operand:
        base, exponent = expression.as_base_exp()
        if base in _NAMED and exponent == -1:
            return Constant(1 / _NAMED[base].double, 1 / _NAMED[base].single)
        if exponent == sp.Rational(1, 2):
            return self._issue(Op.SQRT, (self._lower(base),), name)
        if exponent.is_Integer and exponent > 1:
            operand = total = self._lower(base)
            for remaining in reversed(range(int(exponent) - 1)):
                total = self._issue(Op.MUL, (total, operand), "" if remaining else name)
            return total
        if exponent.is_negative:
            operands = (_constant(sp.Integer(1)), self._lower(base**-exponent))
            return self._issue(Op.DIV, operands, name)
        raise TypeError(f"the plain tier cannot evaluate the power {expression}")

    def _piecewise(self, expression: sp.Piecewise, name: str) -> Operand:
        *cases, (otherwise, always) = expression.args
        if always != sp.true:
            raise TypeError(f"a Piecewise needs a last case that always holds: {expression}")
        result = self._lower(otherwise)
        unissued = sum(len(sp.And.make_args(condition)) for _, condition in cases)
        for value, condition in reversed(cases):
            tests = sorted(sp.And.make_args(condition), key=sp.default_sort_key)
            chosen, other = self._lower(value), result
            for test in map(self._lower, reversed(tests)):
                unissued -= 1
                chosen = self._issue(Op.SELECT, (test, chosen, other), "" if unissued else name)
            result = chosen
        return result


_FUNCTIONS = {sp.Abs: Op.ABS, sp.sin: Op.SIN, sp.cos: Op.COS, sp.atan2: Op.ATAN2, sp.exp: Op.EXP,
              sp.tanh: Op.TANH,
              sp.Equality: Op.EQUAL, scaled: Op.SCALE}


def _constant(value: sp.Rational) -> Constant:
    fraction = Fraction(int(value.p), int(value.q))
    return Constant(fraction, fraction)


def _items(terms: list[ScheduledTerm]) -> list[Item]:
    """Mirrored pairs, and the other terms grouped by the parts they multiply; in the order of their
    first terms."""
    waiting = list(terms)
    items: list[Item] = []
    while waiting:
        term = waiting.pop(0)
        mirror = _mirror_image(term, waiting)
        if mirror is not None:
            waiting.remove(mirror)
            items.append(Item((term, mirror)))
            continue
        items.append(Item((term,)))
    grouped: dict[tuple[object, ...], Item] = {}
    for number, item in enumerate(items):
        key = ("pair", number) if len(item.terms) == 2 else ("parts", item.terms[0].parts)
        before = grouped[key].terms if key in grouped else ()
        grouped[key] = Item(before + item.terms)
    return list(grouped.values())


def _mirror_image(term: ScheduledTerm, others: list[ScheduledTerm]) -> ScheduledTerm | None:
    """The term's mirror image among the others: x_j y_i for x_i y_j, of opposite sign.  Prefers one
    with the whole places swapped to one with the indices swapped."""
    if len(term.places) != 2:
        return None
    x, y = term.places
    whole = (Position(x.source, y.part, y.index), Position(y.source, x.part, x.index))
    index = (Position(x.source, x.part, y.index), Position(y.source, y.part, x.index))
    for image in (whole, index):
        for other in others:
            if (other.places == image and other.negative != term.negative
                    and other.coefficient == term.coefficient):
                return other
    return None
