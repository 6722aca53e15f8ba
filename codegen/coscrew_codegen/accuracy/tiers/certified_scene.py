"""The certified tier of scenes' functions: the plain results, bit for bit, and bounds of their
errors that always hold.  The true model has the exact decimals.  One pass forward serves all
results.

An error computed beside each value is all but the true one; sizes bound what it lacks (sizes.py,
with the rules for sums and products and the meaning of s, k, m, h, A, B, κ).  The other rules:

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
    t[a]         of a table, d and s are those of its number in the row.  Where â ∓ B_a lie in
                 two rows, the difference of their numbers is added, where in more, the extent of
                 the column; to the index itself, the difference of these rows.
    sin, cos     d is the function's error, plus sin (x̂ + d_x) - sin x̂, whose 13 roundings are a
                 part of d_x; s = 1 + s_x, or |ŷ| of an exact x, if there are many;
    tanh         d is the function's error, plus slope d_x; s = |ŷ| + s_x (1 + B_x / κ u): the
                 square of x's error is at most κ u (1 + B_x / κ u) k u s_x;
    exp          alike, s = ŷ (1 + s_x (1 + B_x / κ u)) if B_x <= 1/4.

The first digits of a number that is split (splits.py) are exact: results do not depend on them.

To add e to a bound is to add e / m u² to s.  Inf and NaN are no statement.
"""

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.accuracy.tiers.nonlinear import inverse
from coscrew_codegen.accuracy.tiers.sizes import Size, Sizes, Sizing
from coscrew_codegen.accuracy.tiers.tier import bounds_of_outputs
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
    renamed,
    with_constants,
    without_dead_steps,
)
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.program.program import name_of
from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.program.tables import TableColumn
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.table_arrays import rounded

MANY = 16
"""Largest number of sines and cosines for which their size is 1: this makes sizes of rotated
vectors up to √2 larger at each joint, but factors of 1 cost nothing."""
REST = 256
"""Bound of the error of an elementary function's computed error, in u² of the function's result."""


class NoRuleError(ReportedError, ValueError):
    """A function has an operation whose error the tier cannot bound."""


def of_scene(program: Program, precision: Precision, kinks: bool = True) -> Program:
    """The plain program of a scene's function or an operation, extended by bounds of its results'
    errors.  Raises NoRuleError."""
    how = replace(COMPUTED, kinks=kinks)
    if program.fine is None:
        return extended(program, precision, how)
    taken = {step.name for step in program.instructions}
    names = {step.name: f"fine_{step.name}" if step.name in taken else step.name
             for step in program.fine.instructions}
    return extended(renamed(program.fine, names), precision, how, program)


def extended(program: Program, precision: Precision, how: Sizing, plain: Program | None = None
             ) -> Program:
    """The program, extended by bounds of its results' errors; with `plain`, that program's results
    and bounds of their errors.  Raises NoRuleError."""
    unknown = sorted(op.value for op in program.counts if op not in BOUNDED)
    if unknown:
        raise NoRuleError(f"{program.name}: the certified tier has no rule for "
                          f"{' and '.join(unknown)}")
    first, given = ((), program.results) if plain is None else (plain.instructions, plain.results)
    sizes = Sizes(program, precision, how)
    for step in program.instructions:
        sizes.follow(step)
    bounds = tuple(map(sizes.of_result, program.results, given))
    steps = (*first, *sizes.errors.steps)
    made = with_constants(replace(program, instructions=steps, results=given), sizes.near)
    return without_dead_steps(replace(
        made, outputs=(*program.outputs, *bounds_of_outputs(program.outputs)),
        results=(*made.results, *bounds), fine=None))


def _of_quotient(sizes: Sizes, step: Instruction) -> Size:
    (x, y), q, u = step.operands, Ref(step.name), sizes.u
    a, b = sizes.padded(x, even_exact=True), sizes.padded(y)
    size, divisor = sizes.do(Op.ABS, q), sizes.magnitude(y)
    total = sizes.do(Op.ADD, a.s, sizes.do(Op.MUL, size, b.s))
    k, m = max(a.k, b.k), max(a.m, b.m)
    more = Fraction(0)
    if not b.exact:
        total = sizes.do(Op.DIV, total, _certain(sizes, y, divisor))
        total = sizes.do(Op.MUL, total, sizes.reach(y))
        more = Fraction(4, 3) * sizes.how.spread * (1 + k + u * m)
    s = sizes.do(Op.ADD, size, sizes.do(Op.DIV, total, divisor))
    return Size(s, (1 + 64 * u) * (k + 1), (1 + 64 * u) * (m + 4 * (k + 1) + more), sizes.slack)


def _certain(sizes: Sizes, x: Operand, size: Operand) -> Operand:
    """|x̂|; 0 if B may be larger than a fourth of it, which never holds for a constant."""
    if isinstance(x, Constant):
        return size
    return sizes.do(Op.SELECT, _is_certain(sizes, x, size), size, ZERO)


def _is_certain(sizes: Sizes, x: Operand, size: Operand) -> Operand:
    four = sizes.do(Op.MUL, sizes.bound(x) or ZERO, constant(Fraction(4)))
    return sizes.do(Op.LESS, four, size)


def _of_root(sizes: Sizes, step: Instruction) -> Size:
    (x,), y, u = step.operands, Ref(step.name), sizes.u
    a = sizes.padded(x, even_exact=True)
    k = (1 + 64 * u) * (2 + a.k + a.m * u) / 2
    m = (1 + 64 * u) * (a.m / 2 + (3 + sizes.how.spread) * k)
    if a.exact:
        zero = sizes.do(Op.EQUAL, y, ZERO)
        part = sizes.do(Op.DIV, a.s, sizes.do(Op.SELECT, zero, ONE, y))
    else:
        near = sizes.do(Op.DIV, sizes.do(Op.DIV, a.s, y), x)
        near = sizes.do(Op.MUL, near, sizes.reach(x))
        far = sizes.do(Op.SQRT, sizes.bound(x) or ZERO)
        low = sizes.first_order(y)
        if low is not None:
            far = sizes.do(Op.ADD, far, sizes.do(Op.ABS, low))
        far = _in_size(sizes, far, k, m)
        part = sizes.do(Op.SELECT, _is_certain(sizes, x, x), near, far)
    return Size(sizes.do(Op.ADD, y, part), k, m, sizes.slack, widened=not a.exact)


def _in_size(sizes: Sizes, error: Operand, k: Fraction, m: Fraction) -> Operand:
    """Returns the increase of s that makes the bound larger by this error."""
    return sizes.do(Op.MUL, error, sizes.rounded_up((1 + 32 * sizes.u) / sizes.covered(k, m)))


def _widened(sizes: Sizes, size: Size, error: Operand) -> Size:
    """The size, increased by a further error."""
    k, grown = max(size.k, Fraction(1)), 1 + 4 * sizes.u
    m = max(size.m, 256 * k)  # the 8 k that bounds add are little of it
    return Size(sizes.do(Op.ADD, size.s, _in_size(sizes, error, k, m)), grown * k, grown * m,
                size.h + sizes.slack, widened=True)


def _of_absolute(sizes: Sizes, step: Instruction) -> Size:
    (x,), bound = step.operands, sizes.bound(step.operands[0])
    if bound is None:
        return Size(Ref(step.name))
    gap = sizes.do(Op.SUB, Ref(step.name), bound)
    return _widened(sizes, sizes.size(x), sizes.do(Op.SUB, sizes.do(Op.ABS, gap), gap))


def _of_choice(sizes: Sizes, step: Instruction) -> Size:
    test, *options = step.operands
    a, b = map(sizes.size, options)
    s = a.s if a.s == b.s else sizes.do(Op.SELECT, test, a.s, b.s)
    chosen = Size(s, max(a.k, b.k), max(a.m, b.m), max(a.h, b.h), a.widened or b.widened)
    compared = sizes.plain[name_of(test)].operands
    bounds = _bounds_of(sizes, compared)
    if not bounds or step.name in sizes.scalings:
        return chosen
    close = bounds[0] if len(bounds) == 1 else sizes.do(Op.ADD, *bounds)
    distance = _distance(sizes, *compared)
    if any(name_of(x) in sizes.plain and sizes.plain[name_of(x)].op is Op.SCALE
           for x in compared):  # 0 may be right
        distance = sizes.do(Op.ADD, distance, constant(2 * sizes.precision.eta))
    certain = sizes.do(Op.LESS, close, distance)
    if NotANumber() in options:
        return replace(chosen, s=sizes.do(Op.SELECT, certain, s, NotANumber()))
    other = _distance_up(sizes, *options)
    for bound in _bounds_of(sizes, options):
        other = sizes.do(Op.ADD, other, bound)
    return _widened(sizes, chosen, sizes.do(Op.SELECT, certain, ZERO, other))


def _of_index(sizes: Sizes, step: Instruction) -> Size:
    least, most = _indices(sizes, step.operands[0], step.operands[1])
    size = Size(Ref(step.name))
    return size if least == most else _widened(sizes, size, sizes.do(Op.SUB, most, least))


def _of_gathered(sizes: Sizes, step: Instruction) -> Size:
    of, at = step.operands
    assert isinstance(of, TableColumn)
    exact = all(x == Fraction(y) for x, y in zip(
        of.table.values, rounded(of.table, sizes.precision).tolist(), strict=True))
    s = sizes.do(Op.ABS, Ref(step.name))
    size = Size(s) if exact else Size(s, Fraction(1), Fraction(1), sizes.slack)
    least, most = _indices(sizes, at, constant(Fraction(of.table.rows)))
    if least == most:
        return size
    grown = 1 + 8 * sizes.u
    ends = [sizes.do(Op.GATHER, of, x) for x in (least, most)]
    next_to = sizes.do(Op.MUL, _distance(sizes, *ends), sizes.rounded_up(grown))
    rounding = 4 * sizes.u * max(map(abs, of.values)) + 2 * sizes.precision.eta
    next_to = sizes.do(Op.ADD, next_to, sizes.rounded_up(rounding))
    extent = sizes.rounded_up(grown * (max(of.values) - min(of.values)) + rounding)
    rows = sizes.do(Op.SUB, most, least)
    apart = sizes.do(Op.SELECT, sizes.do(Op.LESS, rows, constant(Fraction(2))), next_to, extent)
    same = sizes.do(Op.EQUAL, least, most)
    return _widened(sizes, size, sizes.do(Op.SELECT, same, ZERO, apart))


def _indices(sizes: Sizes, x: Operand, count: Operand) -> tuple[Operand, Operand]:
    """The least and the largest index that x may stand for."""
    bound = sizes.bound(x)
    if bound is None:
        return x, x
    around = sizes.do(Op.MUL, sizes.do(Op.ABS, x), constant(4 * sizes.u))
    around = sizes.do(Op.ADD, around, bound)
    least, most = (sizes.do(Op.INDEX, sizes.do(op, x, around), count) for op in (Op.SUB, Op.ADD))
    return least, most


def _bounds_of(sizes: Sizes, values: tuple[Operand, ...] | list[Operand]) -> list[Operand]:
    return [bound for x in values if (bound := sizes.bound(x)) is not None]


def _distance_up(sizes: Sizes, x: Operand, y: Operand) -> Operand:
    """|x̂ - ŷ|; of constants, a constant."""
    if isinstance(x, Constant) and isinstance(y, Constant):
        return sizes.rounded_up(abs(sizes.near(x).double - sizes.near(y).double))
    return _distance(sizes, x, y)


def _distance(sizes: Sizes, x: Operand, y: Operand) -> Operand:
    return sizes.do(Op.ABS, sizes.do(Op.SUB, x, y))


def _of_angle(sizes: Sizes, step: Instruction) -> Size:
    a = sizes.padded(step.operands[0])
    many = sizes.counts.get(Op.SIN, 0) + sizes.counts.get(Op.COS, 0) > MANY
    if many and a.exact:
        return _curved(sizes, step)
    s = ONE if a.exact else sizes.do(Op.ADD, ONE, a.s)
    return replace(_right_to_rest(sizes, a, s), h=Fraction(0))


def _of_arctangent(sizes: Sizes, step: Instruction) -> Size:
    y, x = step.operands
    size, (a, b) = sizes.do(Op.ABS, Ref(step.name)), (sizes.padded(z, True) for z in (y, x))
    if a.exact and b.exact:
        return _right_to_rest(sizes, a, size)
    one, other = sizes.magnitude(y), sizes.magnitude(x)
    largest = sizes.do(Op.SELECT, sizes.do(Op.LESS, one, other), other, one)
    apart: Operand = constant(sizes.padding)
    for bound in _bounds_of(sizes, (y, x)):
        apart = sizes.do(Op.ADD, apart, bound)
    s = sizes.do(Op.ADD, size, sizes.do(Op.DIV, sizes.do(Op.ADD, a.s, b.s), largest))
    both = Size(s, max(a.k, b.k), max(a.m, b.m))
    part = sizes.do(Op.DIV, apart, largest)
    near = sizes.do(Op.LESS, part, constant(Fraction(1, 4)))
    small = sizes.do(Op.MUL, part, part)
    return _widened(sizes, _right_to_rest(sizes, both, s),
                    _if_the_angle_is_certain(sizes, step, near, small))


def _if_the_angle_is_certain(sizes: Sizes, step: Instruction, near: Operand, small: Operand
                             ) -> Operand:
    """`small` if the point is certainly not next to the origin nor to the negative x axis; else
    more than a turn."""
    y, x = step.operands
    any_other: Operand = constant(Fraction(7))
    low = sizes.first_order(Ref(step.name))
    if low is not None:
        any_other = sizes.do(Op.ADD, any_other, sizes.do(Op.ABS, low))
    if (bound := sizes.bound(y)) is not None:
        right = sizes.do(Op.LESS, sizes.bound(x) or ZERO, x)
        small = sizes.do(Op.SELECT, sizes.do(Op.LESS, bound, sizes.magnitude(y)), small,
                        sizes.do(Op.SELECT, right, small, any_other))
    return sizes.do(Op.SELECT, near, small, any_other)


def _of_scaled(sizes: Sizes, step: Instruction) -> Size:
    """The size of a product with a power of two: exact for an exact number, unless digits are lost
    by underflow."""
    (x, s), p = step.operands, Ref(step.name)
    if not (sizes.size(x).exact and sizes.size(s).exact):
        return sizes.of_product(step)
    kept = sizes.do(Op.EQUAL, sizes.do(Op.MUL, p, inverse(sizes.errors, step, s)), x)
    sizes.known_bounds[p] = sizes.do(Op.SELECT, kept, ZERO, constant(2 * sizes.precision.eta))
    return Size(sizes.do(Op.ABS, p), Fraction(1), Fraction(1), sizes.slack)


def _of_exponential(sizes: Sizes, step: Instruction) -> Size:
    (x,), y = step.operands, Ref(step.name)
    if sizes.size(x).exact:
        return _curved(sizes, step, y)
    size = _curved(sizes, step, ONE)
    s = sizes.do(Op.MUL, y, sizes.do(Op.DIV, size.s, _certain(sizes, x, ONE)))
    return replace(size, s=s)


def _curved(sizes: Sizes, step: Instruction, least: Operand | None = None) -> Size:
    """The size of the result of a function with derivatives of at most 1; the result is at most
    `least`."""
    (x,), u = step.operands, sizes.u
    s = least = least or sizes.do(Op.ABS, Ref(step.name))
    a = sizes.padded(x)
    if not a.exact:
        spread = sizes.do(Op.MUL, a.s, sizes.do(Op.ADD, ONE, sizes.units(x)))
        s = sizes.do(Op.ADD, least, spread)
    return _right_to_rest(sizes, a, s, sizes.how.spread * (a.k + u * a.m))


def _right_to_rest(sizes: Sizes, a: Size, s: Operand, bend: Fraction = Fraction(0)) -> Size:
    """The size of the result of a function of a; `bend` is the second-order remainder of d."""
    m = a.m + bend + 16 * (a.k + 2) + REST
    return Size(s, (1 + 64 * sizes.u) * (a.k + 2), (1 + 64 * sizes.u) * m, sizes.slack)


RULES: Mapping[Op, Callable[[Sizes, Instruction], Size]] = {
    Op.ADD: Sizes.of_sum, Op.SUB: Sizes.of_sum, Op.MUL: Sizes.of_product,
    Op.NEG: lambda sizes, step: sizes.size(step.operands[0]), Op.ABS: _of_absolute,
    Op.DIV: _of_quotient, Op.SQRT: _of_root, Op.SELECT: _of_choice, Op.SIN: _of_angle,
    Op.COS: _of_angle, Op.TANH: _curved, Op.EXP: _of_exponential, Op.ATAN2: _of_arctangent,
    Op.SCALE: _of_scaled, Op.INDEX: _of_index, Op.GATHER: _of_gathered}
BOUNDED = frozenset({*COMPARISONS, *RULES})
"""The operations whose errors have bounds."""
COMPUTED = Sizing(RULES)
"""Bounds that contain the errors computed."""
