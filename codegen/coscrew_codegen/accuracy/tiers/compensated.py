"""Values carried as hi + lo through a program, and the rules for sums and products.

The plain program's operations give hi.  lo is the sum, rounded, of their exact rounding errors and
of the contributions of the operands' lo.

The error of a sum s = a + b is found by Knuth's Two-Sum: t = s - a, rounded, is b's share of s, and
u = s - t is a's.  u, a - u and b - t are exact for all a and b (Shewchuk), and the last two add up
to the error.  Where a is a rounded product x y, its error belongs to lo as well:
(a - u) + (x y - a) is x y - u, rounded once by a single fma.

A constant that is rounded has a lo, too: the rest, rounded.
"""

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache, partial

from coscrew_codegen.program import (
    Constant,
    Instruction,
    Op,
    Operand,
    Program,
    Ref,
    scales,
    sine_cosine_pairs,
    without_dead_steps,
)
from coscrew_codegen.program.ops import ERROR_OF
from coscrew_codegen.program.program import name_of
from coscrew_codegen.program.tables import ConstantTable
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.values.table_arrays import rounded

Rule = Callable[["Carrier", Instruction], None]
"""Issues hi of a plain instruction under its name; and lo, or the parts of lo that are added where
it is used.  Operands that have been made non-overlapping are the new hi."""
Name = Callable[[str, str], str]
"""The name of an instruction, from that of the instruction it belongs to and a suffix."""
_MAY_FAIL = frozenset({Op.DIV, Op.SQRT, Op.SCALE, *ERROR_OF})
"""The operations whose lo may be NaN, by 0/0 or an infinite hi.  The result is then hi."""


@dataclass(frozen=True)
class Carrying:
    """A tier's way of carrying values: a rule for each operation, and the choices that rules leave
    open."""

    rules: Mapping[Op, Rule]
    names: Callable[[Program], Name]
    normal: Callable[["Carrier", Instruction, Ref, Operand], tuple[Ref, Operand]] | None
    """Returns hi + lo rounded, and the rest; None: hi stays the plain value."""
    last: str = ""  # component of final values; "": each is its own


class Carrier:
    """Carries a program's values: issues instructions, and knows the lo of each hi."""

    def __init__(self, program: Program, precision: Precision, how: Carrying) -> None:
        self.precision, self.name = precision, how.names(program)
        self.steps: list[Instruction] = []
        self.products: dict[str, Instruction] = {}  # whose rounding error their lo lacks, by name
        self.overlapping: set[str] = set()  # results to be normalized before they are multiplied
        self.nearest: set[str] = set()  # results that are the nearest numbers: hi alone is final
        self.pairs = sine_cosine_pairs(program)
        self.partners: dict[str, Ref] = {}  # of issued sines their cosines, of cosines their sines
        self._how = how
        self._low: dict[str, Operand] = {}  # lo by hi's name
        self._normal: dict[str, Ref] = {}  # hi of normalized results, by their plain name
        self._normals: set[str] = set()
        self._rounded: dict[str, Ref] = {}  # hi + lo rounded, by hi's name
        self._once: dict[tuple[str, Operand], tuple[Ref, ...]] = {}

    def carry(self, step: Instruction) -> None:
        """Issues a plain instruction and the instructions that carry it."""
        self._how.rules[step.op](self, step._replace(operands=tuple(map(self.hi, step.operands))))

    def of(self, program: Program, carry: Callable[[Instruction], None] | None = None) -> Program:
        """The plain program with its values carried by `carry`, by default all in pairs, and its
        results rounded."""
        for step in program.instructions:
            (carry or self.carry)(step)
            self.note(step)
        return self._finished(program)

    def note(self, step: Instruction) -> None:
        """Does nothing; a subclass notes a plain instruction that has been carried."""

    def _finished(self, program: Program) -> Program:
        guarded = bool(program.counts.keys() & _MAY_FAIL)
        results = tuple(self._final(result, guarded) for result in program.results)
        names = Counter(step.name for step in self.steps)
        if twice := [name for name, count in names.items() if count > 1]:
            raise ValueError(f"{program.name}: rename {twice[0]!r}, as its compensation is named")
        return without_dead_steps(replace(program, instructions=tuple(self.steps),
                                          results=results))

    # for rules

    def issue(self, step: Instruction, op: Op, operands: tuple[Operand, ...], suffix: str) -> Ref:
        """Issue an instruction towards the component of `step`, named after `step`."""
        name = self.name(step.name, suffix)
        self.steps.append(Instruction(name, op, operands, step.component))
        return Ref(name)

    def once(self, what: str, x: Operand, make: Callable[[], tuple[Ref, ...]]) -> tuple[Ref, ...]:
        """Returns the value that is made at the first use of an operand."""
        if (what, x) not in self._once:
            self._once[what, x] = make()
        return self._once[what, x]

    def keep(self, name: str, lo: Operand | None) -> None:
        """Registers the lo of the result with this name."""
        if lo is not None:
            self._low[name] = lo

    def known(self, x: Operand) -> Operand | None:
        """The lo of an operand, without its own rounding error if it is a product."""
        return rest_of(x, self.precision) if isinstance(x, Constant) else self._low.get(name_of(x))

    def low(self, step: Instruction, x: Operand) -> Operand | None:
        """lo of an operand, with its rounding error if it is a product."""
        product = self.products.pop(name_of(x), None)
        if product is not None:
            own = product._replace(component=step.component)
            cross, operands = self.known(x), (*product.operands, x)
            if cross is None:
                self.keep(own.name, self.issue(own, Op.PRODUCT_ERROR, operands, "lo"))
            else:
                error = self.issue(own, Op.PRODUCT_ERROR, operands, "error")
                self.keep(own.name, self.issue(own, Op.ADD, (error, cross), "lo"))
        return self.known(x)

    def is_exact(self, x: Operand) -> bool:
        """Returns whether an operand has no lo."""
        return self.known(x) is None and name_of(x) not in self.products

    def hi(self, x: Operand) -> Operand:
        """hi of a value of the plain program."""
        return self._normal.get(name_of(x), x)

    def normalized(self, step: Instruction, x: Operand) -> Operand:
        """hi + lo rounded; its rounding error is the new lo."""
        if self._how.normal is None:
            return x
        x = self.hi(x)  # it may be an operand twice
        low = self.low(step, x)
        if low is None or not isinstance(x, Ref) or x.name in self._normals:
            return x
        total, rest = self._how.normal(self, step, x, low)
        self._normal[x.name] = total
        self._normals.add(total.name)
        self.keep(total.name, rest)
        return total

    def factor(self, step: Instruction, x: Operand) -> Operand:
        """The operand in the form in which it is multiplied."""
        return self.normalized(step, x) if name_of(x) in self.overlapping else x

    # results

    def rounded(self, result: Operand) -> Operand:
        """hi + lo rounded: the component's final value."""
        if not isinstance(result, Ref) or result.name in self.nearest:
            return result
        if result.name not in self._rounded:
            name = self.name(result.name, "rounded")
            at = Instruction(name, Op.ADD, (), self._how.last or name)
            low = self.low(at, result)
            if low is None:
                return result
            self.steps.append(at._replace(operands=(result, low)))
            self._rounded[result.name] = Ref(name)
        return self._rounded[result.name]

    def _final(self, result: Operand, guarded: bool) -> Operand:
        """hi + lo rounded; if guarded, hi where that is NaN."""
        total = self.rounded(result)
        if not guarded or total == result:
            return total
        return self.once("final", total, partial(self._guarded, total, result))[0]

    def _guarded(self, total: Operand, result: Operand) -> tuple[Ref, ...]:
        last = self._how.last or name_of(total)
        at = Instruction(self.name(name_of(total), "number"), Op.EQUAL, (total, total), last)
        choice = Instruction(self.name(name_of(result), "final"), Op.SELECT,
                             (Ref(at.name), total, result), last)
        self.steps += [at, choice]
        return Ref(choice.name),


CarrierFactory = Callable[[Program, Precision, Carrying], Carrier]
"""Constructs the Carrier of a program."""


def carried(program: Program, precision: Precision, how: Carrying) -> Program:
    """The plain program with its values carried as hi + lo, its results rounded."""
    return Carrier(program, precision, how).of(program)


def suffixed(_: Program) -> Name:
    """Names that consist of the instruction's and a suffix."""
    return lambda of, suffix: f"{of}_{suffix}"


def two_sum(c: Carrier, step: Instruction, hi: Ref, lo: Operand) -> tuple[Ref, Operand]:
    """hi + lo rounded, and the exact rest."""
    total = c.issue(step._replace(name=hi.name), Op.ADD, (hi, lo), "sum")
    at = step._replace(name=total.name)
    right = c.issue(at, Op.SUB, (total, hi), "right")
    left = c.issue(at, Op.EXACT_SUB, (total, right), "left")
    rests = (c.issue(at, Op.EXACT_SUB, (hi, left), "left_rest"),
             c.issue(at, Op.EXACT_SUB, (lo, right), "right_rest"))
    return total, c.issue(at, Op.EXACT_ADD, rests, "lo")


# constants


def rounded_constant(x: Constant, precision: Precision = DOUBLE) -> Constant:
    """The constant rounded to a precision, as an exact number."""
    value = Fraction(float(precision.rounded(precision.value(x))))
    return Constant(value, value, x.name)


def rest_of(x: Constant, precision: Precision = DOUBLE) -> Constant | None:
    """Returns the rounded rest of a constant beyond its rounding; None if that is zero."""
    rest = precision.value(x) - precision.value(rounded_constant(x, precision))
    value = Fraction(float(precision.rounded(rest)))
    return Constant(value, value, x.name and f"{x.name}_lo") if value else None


@lru_cache(8)
def rest_of_table(x: ConstantTable, precision: Precision) -> ConstantTable:
    """The table of the rounded rests of a table's numbers beyond their roundings."""
    def rest(value: Fraction, near: float) -> Fraction:
        left = value - Fraction(near)
        return Fraction(float(precision.rounded(left))) if left else left

    return replace(x, values=tuple(map(rest, x.values, rounded(x, precision).tolist())))


# rules


def negation(c: Carrier, step: Instruction) -> None:
    """-a, -a_lo.  For a product, a factor and its cross terms are negated, not its error."""
    x, = step.operands
    product, low = c.products.get(name_of(x)), c.known(x)
    c.steps.append(step)
    if low is not None:
        c.keep(step.name, c.issue(step, Op.NEG, (low,), "lo" if product is None else "cross"))
    if product is not None:
        a, b = product.operands
        a = c.issue(step, Op.NEG, (a,), "factor")
        c.products[step.name] = step._replace(op=Op.MUL, operands=(a, b))


def product(c: Carrier, step: Instruction) -> None:
    """(a + a_lo)(b + b_lo): hi = a b rounded, lo = a_lo b + a b_lo and the rounding error, which is
    zero if a or b is a power of two."""
    step = step._replace(operands=tuple(c.factor(step, x) for x in step.operands))
    low = [c.low(step, x) for x in step.operands]
    c.steps.append(step)
    c.keep(step.name, cross_terms(c, step, *low))
    if not scales(step):
        c.products[step.name] = step


def cross_terms(c: Carrier, step: Instruction, a_lo: Operand | None, b_lo: Operand | None
                ) -> Operand | None:
    """a_lo b + a b_lo of a product a b; None for 0."""
    a, b = step.operands
    terms = [c.issue(step, Op.MUL, (x, y), f"cross{number}")
             for number, (x, y) in enumerate(((a_lo, b), (a, b_lo)), start=1)
             if x is not None and y is not None]
    return c.issue(step, Op.ADD, (terms[0], terms[1]), "cross") if len(terms) == 2 else (
        terms[0] if terms else None)


def total(c: Carrier, step: Instruction) -> None:
    """s = a ± b: lo is a and b less their shares of s, plus b's lo, plus a's, in this order.

    A chain of sums is the left operand, so that its lo, the largest, is added last and rounded
    least.  The cross terms of two products are added to each other first."""
    c.steps.append(step)
    a, b = step.operands
    s, add = Ref(step.name), step.op is Op.ADD
    right = c.issue(step, Op.SUB, (s, a) if add else (a, s), "right")
    left = c.issue(step, Op.EXACT_SUB if add else Op.EXACT_ADD, (s, right), "left")
    rests = _rest(c, step, a, left, "left_rest"), _rest(c, step, b, right, "right_rest")
    a_lo, b_lo = map(c.known, (a, b))
    products = [name_of(x) in c.products for x in (a, b)]
    exact = Op.EXACT_ADD if add else Op.EXACT_SUB
    more: list[tuple[Op, Operand]] = []
    if all(products) and a_lo is not None and b_lo is not None:
        more.append((Op.ADD, c.issue(step, step.op, (a_lo, b_lo), "cross")))
    else:
        more += [(op, x) for op, x in ((step.op, b_lo), (Op.ADD, a_lo)) if x is not None]
    c.keep(step.name, _added(c, step, step.op if any(products) else exact, rests, more))


def _added(c: Carrier, step: Instruction, op: Op, operands: tuple[Operand, ...],
           more: list[tuple[Op, Operand]]) -> Operand:
    """The terms added in order, the last partial sum named lo."""
    for number, (next_op, operand) in enumerate(more, start=1):
        operands, op = (c.issue(step, op, operands, f"lo{number}"), operand), next_op
    return c.issue(step, op, operands, "lo")


def _rest(c: Carrier, step: Instruction, x: Operand, share: Operand, name: str) -> Operand:
    """x less its share of the sum, exactly; a product's rounding error is added."""
    product = c.products.get(name_of(x))
    if product is None:
        return c.issue(step, Op.EXACT_SUB, (x, share), name)
    return c.issue(step, Op.PRODUCT_REST, (*product.operands, x, share), name)
