"""Bounds the difference of computed errors from true ones, by sizes of a plain program's values.

Let x̂ be a value of the plain program, exactly x, and d the error computed for it: the lo that the
rules of compensated.py and nonlinear.py give it where hi stays the plain value, bit for bit, and
comparisons those of the plain program.  Constants are the model's decimals.  A size s is computed
such that, with constants k, m and h known in advance,

    |x̂| <= s,    |d| <= k u S,    |x - x̂ - d| <= m u² S,    S = s + h;

so |d| + m u² S bounds the error of x̂.  Since d is the error to first order, that is hardly more
than the error itself, however generous m and s are; s costs about one operation per plain one.
u is the unit roundoff, η half the least subnormal number, |fl(z) - z| <= u |fl(z)| + η.

    exact x           s = |x|, k = m = h = 0
    constant          s = |x̂|, k = m = 1: d is the rest, rounded
    a series' last    s = |x̂| + t / m u², k = 1, m = TAIL: t, the most that the terms left out move
                      it by, is a part of S, and shrinks with the powers that it is multiplied by
    c = a ± b         s = fl(s_a + s_b), k = max(k_a, k_b) + 1, m = max(m_a, m_b) + 6 k + 54:
                      d is the sum of the two parts of the rounding error, each at most
                      4 u S + u² S, of d_a and d_b, in at most 6 roundings: of parts that contain
                      a product's error, of the sum of two products' other terms, of the total
    c = a b           s = fl(s_a s_b), k = k_a + k_b + 1,
                      m = k_a k_b + m_a + m_b + u (m_a k_b + k_a m_b) + u² m_a m_b
                          + 3 (k_a + k_b) + 2:
                      d_a d_b is neglected, d has 3 roundings
    c = a b           s = fl(A_a s_b + A_b s_a), k = max(k_a, k_b) + 1,
                      m = (1 + 2 κ u) max(m_a, m_b) + κ min(k_a, k_b) + 3 max(k_a, k_b) + 2,
                      where |x̂| <= A and |x - x̂| <= κ u A: |d_a d_b| <= κ k_b u² A_a s_b

    c = a b           s = fl(|ĉ| + D / k u + R / m u²), k = WIDE, m = 256 k,
                      D = |â| B_b + |b̂| B_a, R = |â| C_b + |b̂| C_a + B_a B_b + 4 u D, where
                      B >= |x - x̂| and C >= |x - x̂ - d|: |d| <= D + u |ĉ|, |d_a d_b| <= B_a B_b

Factors 1 + 64 u cover terms of higher order.  The first rule for products multiplies what sizes are
too large by; so it is used if one factor has k <= CLOSE, which is a number as it is, a constant, or
the sine or cosine of one.  For the second rule A is fl(|x̂| + B / κ u), B the bound of |x - x̂|; up
to κ = SPREAD units of relative error it is hardly more than |x̂|.  The third is used where an s
contains an error, which may be most of it, as after choices and roots of scenes.

Underflow.  Every operation adds h_0 = 16 η / u² to h: m u² h_0 is more than what its own underflows
and those of d, in which products' errors are computed to 8 η, can lose.  A product would multiply h
by its other factor; so first s' = fl(s + P), P the least normal number / u², and then h = 0:
s + h <= (1 + 2 u) s'.  A product with a constant does not need it.  Bounds are fl(|d| + fl(C s')),
C >= (1 + 32 u) (m + 8 k) u²; C s' is a normal number; 8 k covers the rounding of this sum, and
makes it at least (1 + 4 u) |x - x̂|.

Where something overflows, s or d and with them the bound are infinite or NaN: no statement is made.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.accuracy.tiers.accurate_scene import numbered
from coscrew_codegen.accuracy.tiers.compensated import Carrier, Carrying
from coscrew_codegen.accuracy.tiers.nonlinear import RULES
from coscrew_codegen.accuracy.tiers.splits import scalings, splits
from coscrew_codegen.program import (
    ONE,
    ZERO,
    Constant,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
    constant,
)
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.program.program import name_of
from coscrew_codegen.program.values.formats import Format, Precision

ERRORS = Carrying(RULES, numbered, normal=None, last="bounds of the errors:")
"""Rules by which errors are computed beside the plain program's values."""

CLOSE = 4
SPREAD = 64
WIDE = 4
TAIL = 2**16  # more than m of a series grows by from its last coefficient to its first
_BRIEF = Format(24, 0)  # k, m and h are rounded up to so many digits


@dataclass(frozen=True)
class Size:
    """s, k, m and h of a value."""

    s: Operand
    k: Fraction = Fraction(0)
    m: Fraction = Fraction(0)
    h: Fraction = Fraction(0)
    widened: bool = False  # whether s may be much more than |x̂|, an error being a part of it

    @property
    def exact(self) -> bool:
        """True if the plain value has no error."""
        return not self.k


@dataclass(frozen=True)
class Sizing:
    """Rules by which sizes follow from operations, and the assumptions of the proof."""

    rules: Mapping[Op, Callable[["Sizes", Instruction], Size]]
    spread: int = SPREAD  # κ
    computed: bool = True  # whether bounds contain d; else S covers it
    kinks: bool = True  # whether the options of a choice may differ by more than rounding


class Sizes:
    """Issues a plain program's instructions and, beside values, errors, sizes and bounds, each
    once."""

    def __init__(self, program: Program, precision: Precision, how: Sizing) -> None:
        self.precision, self.how = precision, how
        self.errors = Carrier(program, precision, ERRORS)
        u = self.u = precision.u
        self.slack = 16 * precision.eta / u**2  # h_0
        self.padding = precision.smallest_normal / u**2  # P
        self.plain = {step.name: step for step in program.instructions}
        self.known_bounds: dict[Operand, Operand] = {}
        self.counts, self.scalings = program.counts, scalings(program)
        self._splits = splits(program)
        self._at = Instruction("", Op.ADD, (), "")  # the plain instruction that is followed
        self._sizes: dict[Operand, Size] = {}
        self._done: dict[tuple[Op, tuple[Operand, ...]], Operand] = {}

    def follow(self, step: Instruction) -> None:
        """Issue a plain instruction, its error and its size."""
        self._at = step
        if step.name in self._splits:
            self.errors.steps.append(step)
            return
        self.errors.carry(step)
        if step.op not in COMPARISONS:
            self._keep(Ref(step.name), self.how.rules[step.op](self, step))

    def _keep(self, x: Ref, size: Size) -> None:
        k, m, h = (_BRIEF.rounded_up(x) if x else x for x in (size.k, size.m, size.h))
        self._sizes[x] = Size(size.s, k, m, h, size.widened)
        if 4 * h > self.padding:
            self._sizes[x] = self.padded(x)

    def of_result(self, x: Operand, plain: Operand) -> Operand:
        """The bound of a result's error, or of the error of `plain` if that is another number."""
        self._at = Instruction(name_of(plain) or "result", Op.ADD, (), ERRORS.last)
        if isinstance(x, NotANumber):
            return x
        return self.bound(x) or ZERO if x == plain else self._bound_beside(x, plain)

    def size(self, x: Operand) -> Size:
        """The size of a value."""
        if isinstance(x, Constant):
            return self._of_constant(x)
        if x not in self._sizes:
            self._sizes[x] = Size(self.do(Op.ABS, x))
        return self._sizes[x]

    def _of_constant(self, x: Constant) -> Size:
        value, near = self.precision.value(x), self.near(x).double
        if x.tail:
            s = abs(near) + x.tail / (TAIL * self.u**2)
            return Size(self.rounded_up(s), Fraction(1), Fraction(TAIL))
        if value == near:
            return Size(constant(abs(near)))
        tiny = abs(value) * self.u**2 < self.precision.smallest_normal  # lo may be subnormal
        return Size(constant(abs(near)), Fraction(1), Fraction(1), self.slack * tiny)

    def padded(self, x: Operand, even_exact: bool = False) -> Size:
        """The size with h = 0; left unpadded if h was 0, unless `even_exact`."""
        size, grown = self.size(x), 1 + 2 * self.u
        if not size.h and not even_exact:
            return size
        if size.h > self.padding:
            raise ValueError("more underflow than the padding covers")
        s = self.do(Op.ADD, size.s, constant(self.padding), name="padded")
        return Size(s, grown * size.k, grown * size.m, widened=size.widened)

    def of_sum(self, step: Instruction) -> Size:
        """The size of a + b or a - b."""
        a, b = map(self.size, step.operands)
        k, m, u = max(a.k, b.k), max(a.m, b.m), self.u
        return Size(self.do(Op.ADD, a.s, b.s), (1 + 64 * u) * (k + 1),
                    (1 + 64 * u) * (m + 6 * k + 54), a.h + b.h + self.slack,
                    a.widened or b.widened)

    def of_product(self, step: Instruction) -> Size:
        """The size of a b."""
        a, b = map(self.size, step.operands)
        widened = a.widened or b.widened
        plain = a.exact or b.exact or any(isinstance(x, Constant) for x in step.operands)
        if widened and not plain and self.how.kinks:
            return self._of_wide_product(step)
        if min(a.k, b.k) > CLOSE or widened and not plain:
            return self._of_far_product(*step.operands)
        h, u = self._slack_of_product(a, b), self.u
        if h is None:
            a, b = map(self.padded, step.operands)
        m = (a.k * b.k + a.m + b.m + u * (a.m * b.k + a.k * b.m) + u**2 * a.m * b.m
             + 3 * (a.k + b.k) + 2)
        return Size(self.do(Op.MUL, a.s, b.s), (1 + 64 * u) * (a.k + b.k + 1),
                    (1 + 64 * u) * m, (h or 0) + self.slack, widened)

    def _slack_of_product(self, a: Size, b: Size) -> Fraction | None:
        """The h of a product without padding, if one factor has a constant size and the other's h
        does not become too large; else None."""
        for one, other in ((a, b), (b, a)):
            if isinstance(one.s, Constant) and not one.h:
                h = (1 + 2 * self.u) * one.s.double * other.h
                return h if 2 * h <= self.padding else None
        return None

    def _of_far_product(self, x: Operand, y: Operand) -> Size:
        (a, b), u = map(self.padded, (x, y)), self.u
        terms = self.do(Op.MUL, self.reach(x), b.s), self.do(Op.MUL, self.reach(y), a.s)
        k, m, spread = max(a.k, b.k), max(a.m, b.m), self.how.spread
        return Size(self.do(Op.ADD, *terms), (1 + 64 * u) * (k + 1), (1 + 64 * u) * (
            (1 + 2 * spread * u) * m + spread * min(a.k, b.k) + 3 * k + 2), self.slack)

    def _of_wide_product(self, step: Instruction) -> Size:
        (x, y), u = step.operands, self.u
        p, q = map(self.magnitude, (x, y))
        a, b = (self.bound(z) or ZERO for z in (x, y))
        first = self.do(Op.ADD, self.do(Op.MUL, p, b), self.do(Op.MUL, q, a))
        second = self.do(Op.ADD, self.do(Op.MUL, p, self._beyond(y)),
                         self.do(Op.MUL, q, self._beyond(x)))
        second = self.do(Op.ADD, second, self.do(Op.MUL, a, b))
        second = self.do(Op.ADD, second, self.do(Op.MUL, first, constant(4 * u)))
        k, m = Fraction(WIDE), 256 * Fraction(WIDE)
        s = self.do(Op.ADD, self.do(Op.MUL, first, self.rounded_up((1 + 32 * u) / (k * u))),
                    self.do(Op.MUL, second, self.rounded_up((1 + 32 * u) / (m * u**2))))
        return Size(self.do(Op.ADD, self.do(Op.ABS, Ref(step.name)), s), (1 + 64 * u) * k,
                    (1 + 64 * u) * m, self.slack, widened=True)

    def reach(self, x: Operand) -> Operand:
        """A of an inexact value."""
        return self.do(Op.ADD, self.magnitude(x), self.units(x), name="reach")

    def units(self, x: Operand) -> Operand:
        """B / κ u of an inexact value."""
        factor = constant(1 / (self.how.spread * self.u))
        return self.do(Op.MUL, self.bound(x) or ZERO, factor, name="units")

    def magnitude(self, x: Operand) -> Operand:
        """|x̂|."""
        return constant(abs(self.near(x).double)) if isinstance(x, Constant) else \
            self.do(Op.ABS, x)

    def bound(self, x: Operand) -> Operand | None:
        """B >= (1 + 4 u) |x - x̂|; None for 0."""
        if x not in self.known_bounds:
            size = self.size(x)
            if size.exact:
                return None
            self.known_bounds[x] = self._bound(x, size)
        return self.known_bounds[x]

    def _bound(self, x: Operand, size: Size) -> Operand:
        if isinstance(x, Constant):
            known = abs(self.precision.value(x) - self.near(x).double) + x.tail
            return self.rounded_up((1 + 4 * self.u) * known)
        low = self.first_order(x)
        first = ZERO if low is None else self.do(Op.ABS, low, name="error")
        return self.do(Op.ADD, first, self._beyond(x), name="bound")

    def _bound_beside(self, x: Operand, other: Operand) -> Operand:
        """B >= |x - ŷ| for another approximation ŷ of x: with (1 + 8 u) |(x̂ - ŷ) + d| for |d|, as
        that need not be a part of S."""
        low = self.first_order(x)
        error = self.do(Op.SUB, x, other, name="apart")
        if low is not None:
            error = self.do(Op.ADD, error, low, name="apart")
        grown = self.do(Op.MUL, self.do(Op.ABS, error, name="error"),
                        self.rounded_up(1 + 8 * self.u), name="error")
        return self.do(Op.ADD, grown, self._beyond(x, even_exact=True), name="bound")

    def _beyond(self, x: Operand, even_exact: bool = False) -> Operand:
        """C s' >= |x - x̂ - d|."""
        size = self.padded(x, even_exact)
        rounding = 8 * size.k * self.u**2
        factor = self.rounded_up((1 + 32 * self.u) * (self.covered(size.k, size.m) + rounding))
        return self.do(Op.MUL, factor, size.s, name="rest")

    def first_order(self, x: Operand) -> Operand | None:
        """d; None for 0, and where S covers it."""
        return self.errors.low(self._at, x) if self.how.computed else None

    def covered(self, k: Fraction, m: Fraction) -> Fraction:
        """The errors besides d, or all errors, as a part of S."""
        return m * self.u**2 if self.how.computed else k * self.u + m * self.u**2

    def near(self, x: Constant) -> Constant:
        """The constant in this precision."""
        return constant(Fraction(float(self.precision.rounded(self.precision.value(x)))))

    def rounded_up(self, value: Fraction) -> Constant:
        """A constant no less than the value."""
        return constant(self.precision.rounded_up(value))

    def do(self, op: Op, *operands: Operand, name: str = "size") -> Operand:
        """Issue an instruction, once.  Sums and products of constant sizes, and certain NaNs, are
        computed here; 0 and 1 cost nothing."""
        if op not in (Op.SELECT, Op.LESS) and any(isinstance(x, NotANumber) for x in operands):
            return NotANumber()
        if op.meaning.commutes:
            operands = tuple(sorted(operands, key=_order))
        if op in (Op.ADD, Op.MUL):
            neutral = ZERO if op is Op.ADD else ONE
            if neutral in operands:
                return operands[operands[0] == neutral]
            numbers = [x.double for x in operands if isinstance(x, Constant)]
            if len(numbers) == 2:
                a, b = numbers
                return self.rounded_up(a + b if op is Op.ADD else a * b)
        if (op, operands) not in self._done:
            self._done[op, operands] = self.errors.issue(self._at, op, operands, name)
        return self._done[op, operands]


def _order(x: Operand) -> tuple[int, str]:
    """The key to sort by: constants first, then inputs, then results of instructions by name."""
    if isinstance(x, Ref):
        return 2, x.name
    return (0, "") if isinstance(x, Constant) else (1, str(x))
