"""The certified tier of scenes' functions: the plain results, bit for bit, and bounds of their
errors that always hold.  The true model has the exact decimals.  One pass forward serves all
results.

An error computed beside each value is all but the true one (errors.py); sizes bound what it lacks
(sizes.py, with the rules for sums and products and the meaning of s, k, m, h, A, B, κ).  The other
rules:

    q = a / b    d = fl((a - q̂ b̂ + d_a - q̂ d_b) / b̂), where a - q̂ b̂ is exact, has 4 roundings.
                 s = fl(|q̂| + Z A_b / |b̂|), Z = (s_a + |q̂| s_b) / |b̂|, k = max(k_a, k_b) + 1,
                 m = max(m_a, m_b) + 4 k + 4/3 κ k if B_b <= |b̂| / 4: then 1/b differs from 1/b̂ by
                 4/3 B_b / |b̂| <= 4/3 κ u A_b / |b̂| at most.  Else there is no statement.
                 s_a is padded even for an exact a: P covers what underflows in a - q̂ b̂.
    y = √a       d = (a - ŷ² + d_a) / 2 ŷ alike, s = fl(ŷ + s_a / ŷ · A_a / â), m = m_a / 2 +
                 (3 + κ) k if B_a <= â / 4.  Else |√a - √â| <= √B_a, which is added.
    |a|          where the sign is uncertain, 2 (B - |â|) is added.
    t ? a : b    d and s of the chosen one.  Where |x̂ - ŷ| <= B_x + B_y, the comparison x < y may
                 have the other result: |â - b̂| + B_a + B_b is added, so that the bound stays small
                 where the choice is continuous, and covers a jump where it is not.
    sin, cos     d is what the function errs by, and sin (x̂ + d_x) - sin x̂, of which 13 roundings
                 are a part of d_x; s = 1 + s_x, or |ŷ| of an exact x, if there are many;
    tanh         d is what the function errs by, and slope d_x; s = |ŷ| + s_x (1 + B_x / κ u): the
                 square of x's error is at most κ u (1 + B_x / κ u) k u s_x;
    exp          alike, s = ŷ (1 + s_x (1 + B_x / κ u)) if B_x <= 1/4.

The first digits of a number that is split (splits.py) are exact: results do not depend on them.

To add e to a bound is to add e / m u² to s.  Inf and NaN are no statement.
"""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.errors import ReportedError
from coscrew_codegen.formats import Precision
from coscrew_codegen.program import (
    Constant,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
    without_dead_steps,
)
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.program.program import name_of, renamed
from coscrew_codegen.tiers.errors import ONE, ZERO, constant
from coscrew_codegen.tiers.sizes import Size, Sizes
from coscrew_codegen.tiers.splits import scalings, splits
from coscrew_codegen.tiers.tier import bounds_of_outputs

MANY = 16
"""Up to so many sines and cosines, 1 is a good size: it makes those of turned vectors up to √2
larger at each joint, but factors of 1 cost nothing."""
REST = 256
"""What is computed as an elementary function's error is right to REST u² of its result."""


BOUNDED = frozenset({*COMPARISONS, Op.ADD, Op.SUB, Op.MUL, Op.NEG, Op.ABS, Op.DIV, Op.SQRT,
                     Op.SELECT, Op.SIN, Op.COS, Op.TANH, Op.EXP, Op.ATAN2, Op.SCALE})
"""The operations whose errors have bounds."""


class NoRuleError(ReportedError, ValueError):
    """A function has an operation whose error the tier cannot bound."""


def of_scene(program: Program, precision: Precision, kinks: bool = True) -> Program:
    """The plain program of a scene's function or an operation, extended by bounds of its results'
    errors.  Raises NoRuleError."""
    apart = program
    if program.fine is not None:
        apart = renamed(program.fine, {step.name: f"fine_{step.name}"
                                       for step in program.fine.instructions})
    certifier = Certifier(apart, precision)
    certifier.kinks = kinks
    return extended(apart, certifier, None if program.fine is None else program)


def extended(program: Program, certifier: "Certifier", plain: Program | None = None) -> Program:
    """The program and the bounds that this certifier issues; of another program's results for the
    same, if `plain` is given."""
    first, given = ((), program.results) if plain is None else (plain.instructions, plain.results)
    for step in program.instructions:
        certifier.compensate(step)
    bounds = tuple(map(certifier.of_result, program.results, given))

    def near(x: Operand) -> Operand:
        return certifier.nearest(x) if isinstance(x, Constant) else x

    steps = tuple(replace(step, operands=tuple(map(near, step.operands)))
                  for step in (*first, *certifier.steps))
    return without_dead_steps(replace(
        program, outputs=(*program.outputs, *bounds_of_outputs(program.outputs)),
        instructions=steps, results=(*map(near, given), *bounds), fine=None))


class Certifier(Sizes):
    """Follows all operations of scenes."""

    def __init__(self, program: Program, precision: Precision) -> None:
        super().__init__(program, precision)
        self._tests: dict[str, Instruction] = {}
        self._many = len(self.circular) > MANY
        self._may_be_exact = {step.name for step in program.instructions if step.op is Op.SCALE}
        self._splits, self._scalings = splits(program), scalings(program)
        self._size_of: dict[Op, Callable[[Instruction], Size]] = {
            Op.ADD: self.of_sum, Op.SUB: self.of_sum, Op.MUL: self.of_product,
            Op.NEG: lambda step: self.size(step.operands[0]), Op.ABS: self._of_absolute,
            Op.DIV: self._of_quotient, Op.SQRT: self._of_root, Op.SELECT: self._of_choice,
            Op.SIN: self._of_angle, Op.COS: self._of_angle, Op.TANH: self._of_tangent,
            Op.EXP: self._of_exponential, Op.ATAN2: self._of_arctangent,
            Op.SCALE: self._of_scaled}
        unknown = sorted(op.value for op in program.counts if op not in BOUNDED)
        if unknown:
            raise NoRuleError(f"{program.name}: the certified tier has no rule for "
                              f"{' and '.join(unknown)}")

    def compensate(self, step: Instruction) -> None:
        """Issue a plain instruction, its error and its size."""
        self._at = step
        if step.name in self._splits:
            self.steps.append(step)
            return
        super().compensate(step)
        if step.op in COMPARISONS:
            self._tests[step.name] = step
        else:
            self.follow(step, self._size_of[step.op](step))

    def of_result(self, x: Operand, plain: Operand) -> Operand:
        """The bound of a result's error, or of what `plain` errs by if that is another number."""
        self._at = Instruction(name_of(plain) or "result", Op.ADD, (), self.last)
        if isinstance(x, NotANumber):
            return x
        return self.bound(x) or ZERO if x == plain else self.bound_beside(x, plain)

    def _of_quotient(self, step: Instruction) -> Size:
        (x, y), q, u = step.operands, Ref(step.name), self.u
        a, b = self.padded(x, even_exact=True), self.padded(y)
        size, divisor = self.do(Op.ABS, q), self.magnitude(y)
        total = self.do(Op.ADD, a.s, self.do(Op.MUL, size, b.s))
        k, m = max(a.k, b.k), max(a.m, b.m)
        more = Fraction(0)
        if not b.exact:
            total = self.do(Op.DIV, total, self._certain(y, divisor))
            total = self.do(Op.MUL, total, self.reach(y))
            more = Fraction(4, 3) * self.spread * (1 + k + u * m)
        s = self.do(Op.ADD, size, self.do(Op.DIV, total, divisor))
        return Size(s, (1 + 64 * u) * (k + 1), (1 + 64 * u) * (m + 4 * (k + 1) + more), self.slack)

    def _certain(self, x: Operand, size: Operand) -> Operand:
        """|x̂|; 0 if B may be larger than a fourth of it.  That of a constant never is."""
        if isinstance(x, Constant):
            return size
        return self.do(Op.SELECT, self._is_certain(x, size), size, ZERO)

    def _is_certain(self, x: Operand, size: Operand) -> Operand:
        four = self.do(Op.MUL, self.some_bound(x), constant(Fraction(4)))
        return self.do(Op.LESS, four, size)

    def _of_root(self, step: Instruction) -> Size:
        (x,), y, u = step.operands, Ref(step.name), self.u
        a = self.padded(x, even_exact=True)
        k = (1 + 64 * u) * (2 + a.k + a.m * u) / 2
        m = (1 + 64 * u) * (a.m / 2 + (3 + self.spread) * k)
        if a.exact:
            zero = self.do(Op.EQUAL, y, ZERO)
            part = self.do(Op.DIV, a.s, self.do(Op.SELECT, zero, ONE, y))
        else:
            near = self.do(Op.DIV, self.do(Op.DIV, a.s, y), x)
            near = self.do(Op.MUL, near, self.reach(x))
            far = self.do(Op.SQRT, self.some_bound(x))
            low = self.first_order(y)
            if low is not None:
                far = self.do(Op.ADD, far, self.do(Op.ABS, low))
            far = self._in_size(far, k, m)
            part = self.do(Op.SELECT, self._is_certain(x, x), near, far)
        return Size(self.do(Op.ADD, y, part), k, m, self.slack, widened=not a.exact)

    def _in_size(self, error: Operand, k: Fraction, m: Fraction) -> Operand:
        """What s grows by if the bound shall by this error."""
        return self.do(Op.MUL, error, self.rounded_up((1 + 32 * self.u) / self.covered(k, m)))

    def _widened(self, size: Size, error: Operand) -> Size:
        """With a further error."""
        k, grown = max(size.k, Fraction(1)), 1 + 4 * self.u
        m = max(size.m, 256 * k)  # of which the 8 k that bounds add are little
        return Size(self.do(Op.ADD, size.s, self._in_size(error, k, m)), grown * k, grown * m,
                    size.h + self.slack, widened=True)

    def _of_absolute(self, step: Instruction) -> Size:
        (x,), bound = step.operands, self.bound(step.operands[0])
        if bound is None:
            return Size(Ref(step.name))
        gap = self.do(Op.SUB, Ref(step.name), bound)
        return self._widened(self.size(x), self.do(Op.SUB, self.do(Op.ABS, gap), gap))

    def _of_choice(self, step: Instruction) -> Size:
        test, *options = step.operands
        a, b = map(self.size, options)
        s = a.s if a.s == b.s else self.do(Op.SELECT, test, a.s, b.s)
        chosen = Size(s, max(a.k, b.k), max(a.m, b.m), max(a.h, b.h), a.widened or b.widened)
        compared = self._tests[name_of(test)].operands
        bounds = self._bounds_of(compared)
        if not bounds or step.name in self._scalings:
            return chosen
        close = bounds[0] if len(bounds) == 1 else self.do(Op.ADD, *bounds)
        distance = self._distance(*compared)
        if any(name_of(x) in self._may_be_exact for x in compared):  # 0 may be right
            distance = self.do(Op.ADD, distance, constant(2 * self.precision.eta))
        certain = self.do(Op.LESS, close, distance)
        if NotANumber() in options:
            return replace(chosen, s=self.do(Op.SELECT, certain, s, NotANumber()))
        other = self._distance_up(*options)
        for bound in self._bounds_of(options):
            other = self.do(Op.ADD, other, bound)
        return self._widened(chosen, self.do(Op.SELECT, certain, ZERO, other))

    def _bounds_of(self, values: tuple[Operand, ...] | list[Operand]) -> list[Operand]:
        return [bound for x in values if (bound := self.bound(x)) is not None]

    def _distance_up(self, x: Operand, y: Operand) -> Operand:
        """|x̂ - ŷ|; of constants, a constant."""
        if isinstance(x, Constant) and isinstance(y, Constant):
            return self.rounded_up(abs(self.nearest(x).double - self.nearest(y).double))
        return self._distance(x, y)

    def _distance(self, x: Operand, y: Operand) -> Operand:
        return self.do(Op.ABS, self.do(Op.SUB, x, y))

    def _of_angle(self, step: Instruction) -> Size:
        a = self.padded(step.operands[0])
        if self._many and a.exact:
            return self._curved(step, self.do(Op.ABS, Ref(step.name)))
        s = ONE if a.exact else self.do(Op.ADD, ONE, a.s)
        return replace(self._right_to_rest(a, s), h=Fraction(0))

    def _of_arctangent(self, step: Instruction) -> Size:
        y, x = step.operands
        size, (a, b) = self.do(Op.ABS, Ref(step.name)), (self.padded(z, True) for z in (y, x))
        if a.exact and b.exact:
            return self._right_to_rest(a, size)
        largest = self._larger(self.magnitude(y), self.magnitude(x))
        apart: Operand = constant(self._padding)
        for bound in self._bounds_of((y, x)):
            apart = self.do(Op.ADD, apart, bound)
        s = self.do(Op.ADD, size, self.do(Op.DIV, self.do(Op.ADD, a.s, b.s), largest))
        both = Size(s, max(a.k, b.k), max(a.m, b.m))
        part = self.do(Op.DIV, apart, largest)
        return self._widened(self._right_to_rest(both, s), self._if_the_angle_is_certain(
            step, self.do(Op.LESS, part, constant(Fraction(1, 4))), self.do(Op.MUL, part, part)))

    def _larger(self, a: Operand, b: Operand) -> Operand:
        return self.do(Op.SELECT, self.do(Op.LESS, a, b), b, a)

    def _if_the_angle_is_certain(self, step: Instruction, near: Operand, small: Operand) -> Operand:
        """`small` if the point is certainly not next to the origin nor to the negative x axis; else
        more than a turn."""
        y, x = step.operands
        any_other: Operand = constant(Fraction(7))
        low = self.first_order(Ref(step.name))
        if low is not None:
            any_other = self.do(Op.ADD, any_other, self.do(Op.ABS, low))
        if (bound := self.bound(y)) is not None:
            right = self.do(Op.LESS, self.bound(x) or ZERO, x)
            small = self.do(Op.SELECT, self.do(Op.LESS, bound, self.magnitude(y)), small,
                            self.do(Op.SELECT, right, small, any_other))
        return self.do(Op.SELECT, near, small, any_other)

    def _of_scaled(self, step: Instruction) -> Size:
        """A product with an exact factor, but that of an exact number is exact unless digits are
        lost by underflow."""
        (x, s), p = step.operands, Ref(step.name)
        if not (self.size(x).exact and self.size(s).exact):
            return self.of_product(step)
        if s not in self._inverses:
            self._inverses[s] = self.issue(step, Op.DIV, (ONE, s), "inverse")
        kept = self.do(Op.EQUAL, self.do(Op.MUL, p, self._inverses[s]), x)
        self._bounds[p] = self.do(Op.SELECT, kept, ZERO, constant(2 * self.precision.eta))
        return Size(self.do(Op.ABS, p), Fraction(1), Fraction(1), self.slack)

    def _of_tangent(self, step: Instruction) -> Size:
        return self._curved(step, self.do(Op.ABS, Ref(step.name)))

    def _of_exponential(self, step: Instruction) -> Size:
        (x,), y = step.operands, Ref(step.name)
        if self.size(x).exact:
            return self._curved(step, y)
        size = self._curved(step, ONE)
        s = self.do(Op.MUL, y, self.do(Op.DIV, size.s, self._certain(x, ONE)))
        return replace(size, s=s)

    def _curved(self, step: Instruction, least: Operand) -> Size:
        """Of a function with derivatives of at most 1, whose result is at most `least`."""
        (x,), u = step.operands, self.u
        a, s = self.padded(x), least
        if not a.exact:
            spread = self.do(Op.MUL, a.s, self.do(Op.ADD, ONE, self.units(x)))
            s = self.do(Op.ADD, least, spread)
        return self._right_to_rest(a, s, self.spread * (a.k + u * a.m))

    def _right_to_rest(self, a: Size, s: Operand, bend: Fraction = Fraction(0)) -> Size:
        """Of a function of a; `bend` is what d lacks of second order."""
        m = a.m + bend + 16 * (a.k + 2) + REST
        return Size(s, (1 + 64 * self.u) * (a.k + 2), (1 + 64 * self.u) * m, self.slack)
