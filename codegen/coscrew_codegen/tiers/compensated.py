"""Compensated sums and products: every intermediate result is carried as hi + lo.

The plain program's operations give hi.  lo is the sum, rounded, of their exact rounding errors and
of the contributions of the operands' lo.

The error of a sum s = a + b is found by Knuth's Two-Sum: t = s - a, rounded, is b's share of s, and
u = s - t is a's.  u, a - u and b - t are exact for all a and b (Shewchuk), and the last two add up
to the error.  Where a is a rounded product x y, its error belongs to lo as well:
(a - u) + (x y - a) is x y - u, rounded once by a single fma.

A constant that is rounded has a lo, too: the rest, rounded.
"""

from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.program import Constant, Instruction, Op, Operand, Ref, scales
from coscrew_codegen.program.program import name_of


def rounded_constant(x: Constant, precision: Precision = DOUBLE) -> Constant:
    """The number that a precision has for this constant, exactly."""
    value = Fraction(float(precision.rounded(precision.value(x))))
    return Constant(value, value, x.name)


def rest_of(x: Constant, precision: Precision = DOUBLE) -> Constant | None:
    """What the rounding of a constant leaves, rounded; None for nothing."""
    rest = precision.value(x) - precision.value(rounded_constant(x, precision))
    value = Fraction(float(precision.rounded(rest)))
    return Constant(value, value, x.name and f"{x.name}_lo") if value else None


class Compensator:
    """Issues instructions; knows the lo of each hi."""

    last = ""  # component of final values; "": each is its own
    precision = DOUBLE

    def __init__(self) -> None:
        self.steps: list[Instruction] = []
        self._low: dict[str, Operand] = {}  # lo by hi's name; a product's rounding error may lack
        self._products: dict[str, Instruction] = {}  # products whose rounding error _low lacks
        self._rounded: dict[str, Ref] = {}  # hi + lo rounded, by hi's name

    def compensate(self, step: Instruction) -> None:
        """Issue hi of a plain instruction under its name; and lo, or the parts of lo that are added
        where it is used."""
        if step.op is Op.MUL:
            self._product(step)
        elif step.op is Op.NEG:
            self._negation(step)
        else:
            self._sum(step)

    def _negation(self, step: Instruction) -> None:
        """-a, -a_lo.  For a product, a factor and its cross terms are negated, not its error."""
        name = name_of(step.operands[0])
        product = self._products.get(name)
        self.steps.append(step)
        if name in self._low:
            suffix = "lo" if product is None else "cross"
            self._low[step.name] = self.issue(step, Op.NEG, (self._low[name],), suffix)
        if product is not None:
            a, b = product.operands
            a = self.issue(step, Op.NEG, (a,), "factor")
            self._products[step.name] = replace(step, op=Op.MUL, operands=(a, b))

    def _product(self, step: Instruction) -> None:
        """(a + a_lo)(b + b_lo): hi = a b rounded, lo = a_lo b + a b_lo and the rounding error,
        which is zero if a or b is a power of two."""
        a, b = step.operands
        a_lo, b_lo = (self.low(step, x) for x in step.operands)
        self.steps.append(step)
        cross = [self.issue(step, Op.MUL, (x, y), f"cross{number}")
                 for number, (x, y) in enumerate(((a_lo, b), (a, b_lo)), start=1)
                 if x is not None and y is not None]
        if scales(step):
            if cross:
                self._low[step.name] = cross[0]
            return
        if len(cross) == 2:
            cross = [self.issue(step, Op.ADD, tuple(cross), "cross")]
        if cross:
            self._low[step.name] = cross[0]
        self._products[step.name] = step

    def _sum(self, step: Instruction) -> None:
        """s = a ± b: lo is a and b less their shares of s, plus b's lo, plus a's, in this order.

        A chain of sums is the left operand, so that its lo, the largest, is added last and rounded
        least.  The cross terms of two products are added to each other first."""
        self.steps.append(step)
        a, b = step.operands
        s, add = Ref(step.name), step.op is Op.ADD
        right = self.issue(step, Op.SUB, (s, a) if add else (a, s), "right")
        left = self.issue(step, Op.EXACT_SUB if add else Op.EXACT_ADD, (s, right), "left")
        rests = self._rest(step, a, left, "left_rest"), self._rest(step, b, right, "right_rest")
        a_lo, b_lo = map(self._known, (a, b))
        products = [name_of(x) in self._products for x in (a, b)]
        exact = Op.EXACT_ADD if add else Op.EXACT_SUB
        more: list[tuple[Op, Operand]] = []
        if all(products) and a_lo is not None and b_lo is not None:
            cross = self.issue(step, step.op, (a_lo, b_lo), "cross")
            more.append((Op.ADD, cross))
        else:
            more += [(op, x) for op, x in ((step.op, b_lo), (Op.ADD, a_lo)) if x is not None]
        self._low[step.name] = self._total(step, step.op if any(products) else exact, rests, more)

    def _total(self, step: Instruction, op: Op, operands: tuple[Operand, ...],
               more: list[tuple[Op, Operand]]) -> Operand:
        """The terms added in order, the last partial sum named lo."""
        for number, (next_op, operand) in enumerate(more, start=1):
            operands, op = (self.issue(step, op, operands, f"lo{number}"), operand), next_op
        return self.issue(step, op, operands, "lo")

    def _rest(self, step: Instruction, x: Operand, share: Operand, name: str) -> Operand:
        """x less its share of the sum, exactly; a product's rounding error is added."""
        product = self._products.get(name_of(x))
        if product is None:
            return self.issue(step, Op.EXACT_SUB, (x, share), name)
        return self.issue(step, Op.PRODUCT_REST, (*product.operands, x, share), name)

    def low(self, step: Instruction, x: Operand) -> Operand | None:
        """lo of an operand, with its rounding error if it is a product."""
        product = self._products.pop(name_of(x), None)
        if product is not None:
            own = Instruction(product.name, Op.MUL, product.operands, step.component)
            cross = self._low.get(product.name)
            error = self.issue(own, Op.PRODUCT_ERROR, (*product.operands, x),
                                "lo" if cross is None else "error")
            self._low[product.name] = (error if cross is None else
                                       self.issue(own, Op.ADD, (error, cross), "lo"))
        return self._known(x)

    def is_exact(self, x: Operand) -> bool:
        """Whether an operand has no lo."""
        return self._known(x) is None and name_of(x) not in self._products

    def _known(self, x: Operand) -> Operand | None:
        """lo of an operand, as far as it is known."""
        if isinstance(x, Constant):
            return rest_of(x, self.precision)
        return self._low.get(name_of(x))

    def issue(self, step: Instruction, op: Op, operands: tuple[Operand, ...], suffix: str) -> Ref:
        """Issue an instruction towards the component of `step`, named after `step`."""
        name = self.name(step.name, suffix)
        self.steps.append(Instruction(name, op, operands, step.component))
        return Ref(name)

    def name(self, of: str, suffix: str) -> str:
        """The name of an instruction that belongs to the instruction `of`."""
        return f"{of}_{suffix}"

    def rounded(self, result: Operand) -> Operand:
        """hi + lo rounded: the component's final value."""
        if not isinstance(result, Ref):
            return result
        if result.name not in self._rounded:
            name = self.name(result.name, "rounded")
            at = Instruction(name, Op.ADD, (), self.last or name)
            low = self.low(at, result)
            if low is None:
                return result
            self.steps.append(replace(at, operands=(result, low)))
            self._rounded[result.name] = Ref(name)
        return self._rounded[result.name]
