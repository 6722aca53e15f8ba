"""Rules for quotients, roots, calls of elementary functions, comparisons and choices of values that
are carried as hi + lo.

Operands of quotients, roots, calls and comparisons are first made non-overlapping: hi becomes the
rounded hi + lo.  Then terms of order lo² do not matter, however much has cancelled.  The residuals
of quotients and roots, a - q b and a - s s, are exact; the errors of elementary functions are
computed by error functions."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial

from coscrew_codegen.accuracy.tiers.compensated import (
    Carrier,
    Rule,
    negation,
    product,
    rest_of_table,
    total,
)
from coscrew_codegen.program import ONE, ZERO, Instruction, Op, Operand, Ref, constant
from coscrew_codegen.program.ops import COMPARISONS, ERROR_OF
from coscrew_codegen.program.tables import TableColumn

Lows = list[Operand | None]
Low = Callable[[Carrier, Instruction, Lows], Operand | None]
"""Issues lo of a result whose hi has been issued, from the lo of its operands; None for 0."""
_HALF = constant(Fraction(1, 2))
_PARTNER = {Op.SIN: Op.COS, Op.COS: Op.SIN}


def _by(low: Low, normal: bool = True) -> Rule:
    """The rule that issues hi and this lo, of operands that are first normalized if `normal`."""
    def rule(c: Carrier, step: Instruction) -> None:
        if normal:
            step = step._replace(operands=tuple(c.normalized(step, x) for x in step.operands))
        lows = [c.low(step, x) for x in step.operands]
        if step.op in _PARTNER:
            _issue_both(c, step)
        else:
            c.steps.append(step)
        c.keep(step.name, low(c, step, lows))
    return rule


def _quotient(c: Carrier, step: Instruction, low: Lows) -> Operand:
    """lo of q = a / b: (a - q b + a_lo - q b_lo) / b."""
    (a, b), q = step.operands, Ref(step.name)
    rest = _residual(c, step, a, (q, b))
    if low[0] is not None:
        rest = c.issue(step, Op.ADD, (rest, low[0]), "numerator")
    if low[1] is not None:
        cross = c.issue(step, Op.MUL, (q, low[1]), "cross")
        rest = c.issue(step, Op.SUB, (rest, cross), "residual")
    return c.issue(step, Op.DIV, (rest, b), "lo")


def _root(c: Carrier, step: Instruction, low: Lows) -> Operand:
    """lo of s = sqrt(a): (a - s s + a_lo) / 2 s; 0 for s = 0."""
    (a,), s = step.operands, Ref(step.name)
    rest = _residual(c, step, a, (s, s))
    if low[0] is not None:
        rest = c.issue(step, Op.ADD, (rest, low[0]), "residual")
    is_zero = c.issue(step, Op.EQUAL, (s, ZERO), "zero")
    twice = c.issue(step, Op.ADD, (s, s), "twice")
    divisor = c.issue(step, Op.SELECT, (is_zero, ONE, twice), "divisor")
    return c.issue(step, Op.DIV, (rest, divisor), "lo")


def _residual(c: Carrier, step: Instruction, a: Operand, factors: tuple[Operand, Operand]) -> Ref:
    """a - b c exactly, where b c and a differ by a rounding only."""
    p = c.issue(step, Op.MUL, factors, "product")
    error = c.issue(step, Op.PRODUCT_ERROR, (*factors, p), "product_error")
    rest = c.issue(step, Op.SUB, (a, p), "rest")
    return c.issue(step, Op.SUB, (rest, error), "exact")


def inverse(c: Carrier, step: Instruction, s: Operand) -> Ref:
    """1 / s of a power of two, exactly."""
    return c.once("inverse", s, lambda: (c.issue(step, Op.DIV, (ONE, s), "inverse"),))[0]


def _scaled(c: Carrier, step: Instruction, low: Lows) -> Operand | None:
    """lo of p = a s, s a power of two: (a - p / s + a_lo) s; a and p / s differ only where p has
    lost digits by underflow."""
    if low[0] is None:
        return None
    (a, s), p = step.operands, Ref(step.name)
    back = c.issue(step, Op.MUL, (p, inverse(c, step, s)), "back")
    lost = c.issue(step, Op.SUB, (a, back), "lost")
    rest = c.issue(step, Op.ADD, (lost, low[0]), "rest")
    return c.issue(step, Op.MUL, (rest, s), "lo")


# calls


def error_of(c: Carrier, step: Instruction) -> Ref:
    """Issues the error of an elementary function."""
    return c.issue(step, ERROR_OF[step.op], (*step.operands, Ref(step.name)), "own_error")


def _called(c: Carrier, step: Instruction, low: Lows) -> Operand:
    """The lo of f(x): the error of f, plus f(x + x_lo) - f(x), which for a cosine is subtracted
    with the opposite sign."""
    error = error_of(c, step)
    if not any(low):
        return error
    moved = _MOVED[step.op](c, step, low)
    return c.issue(step, Op.SUB if step.op is Op.COS else Op.ADD, (error, moved), "lo")


def _issue_both(c: Carrier, step: Instruction) -> None:
    """Issues the sine and the cosine of an operand at the place of the first of them."""
    if step.name in c.partners:
        return
    names = {each.name for each in c.pairs.get(step.name, ())} - {step.name, *c.partners}
    name = names.pop() if names else c.name(step.name, "partner")
    c.steps += [step, step._replace(name=name, op=_PARTNER[step.op])]
    c.partners |= {step.name: Ref(name), name: Ref(step.name)}


def _turned(c: Carrier, step: Instruction, low: Lows) -> Operand:
    """Change of s = sin x: 2 p (q c - p s), where p and q are sine and cosine of x_lo / 2; of c =
    cos x: 2 p (q s + p c), with the other sign."""
    x_lo, = low
    assert x_lo is not None
    p, q, twice = c.once("turn", x_lo, partial(_half_turn, c, step, x_lo))
    terms = (c.issue(step, Op.MUL, (q, c.partners[step.name]), "slope1"),
             c.issue(step, Op.MUL, (p, Ref(step.name)), "slope2"))
    slope = c.issue(step, Op.SUB if step.op is Op.SIN else Op.ADD, terms, "slope")
    return c.issue(step, Op.MUL, (slope, twice), "more")


def _half_turn(c: Carrier, step: Instruction, angle: Operand) -> tuple[Ref, ...]:
    """Sine and cosine of half the angle, and twice that sine."""
    half = c.issue(step, Op.MUL, (angle, _HALF), "half")
    p, q = (c.issue(step, op, (half,), f"half_{op.value}") for op in (Op.SIN, Op.COS))
    return p, q, c.issue(step, Op.ADD, (p, p), "twice")


def _grown(c: Carrier, step: Instruction, low: Lows) -> Operand:
    """Change of y = exp x: y (x_lo + x_lo²/2); the square matters for large x."""
    x_lo, = low
    assert x_lo is not None
    half = c.issue(step, Op.MUL, (x_lo, _HALF), "half")
    bend = c.issue(step, Op.MUL, (half, x_lo), "bend")
    shift = c.issue(step, Op.ADD, (bend, x_lo), "shift")
    return c.issue(step, Op.MUL, (Ref(step.name), shift), "more")


def _saturated(c: Carrier, step: Instruction, low: Lows) -> Operand:
    """Change of y = tanh x: (1 - y) (1 + y) x_lo."""
    y, (x_lo,) = Ref(step.name), low
    assert x_lo is not None
    factors = (c.issue(step, Op.SUB, (ONE, y), "below"),
               c.issue(step, Op.ADD, (ONE, y), "above"))
    slope = c.issue(step, Op.MUL, factors, "slope")
    return c.issue(step, Op.MUL, (slope, x_lo), "more")


def _seen_from_the_origin(c: Carrier, step: Instruction, low: Lows) -> Operand:
    """Change of atan2(y, x): (x y_lo - y x_lo) / (x² + y²), computed with x / m and y / m, m =
    max(|x|, |y|), so that squares don't overflow."""
    sizes = [c.issue(step, Op.ABS, (z,), f"size{n}") for n, z in enumerate(step.operands)]
    larger = c.issue(step, Op.LESS, (sizes[0], sizes[1]), "larger")
    m = c.issue(step, Op.SELECT, (larger, sizes[1], sizes[0]), "most")
    zero = c.issue(step, Op.EQUAL, (m, ZERO), "zero")
    m = c.issue(step, Op.SELECT, (zero, ONE, m), "divisor")
    y, x = (c.issue(step, Op.DIV, (z, m), f"part{n}") for n, z in enumerate(step.operands))
    y_lo, x_lo = (ZERO if lo is None else lo for lo in low)
    terms = (c.issue(step, Op.MUL, (x, y_lo), "cross1"),
             c.issue(step, Op.MUL, (y, x_lo), "cross2"))
    squares = (c.issue(step, Op.MUL, (x, x), "square1"),
               c.issue(step, Op.MUL, (y, y), "square2"))
    cross = c.issue(step, Op.SUB, terms, "cross")
    square = c.issue(step, Op.ADD, squares, "square")
    divisor = c.issue(step, Op.MUL, (m, square), "divisor2")
    safe = c.issue(step, Op.SELECT, (zero, ONE, divisor), "safe")
    return c.issue(step, Op.DIV, (cross, safe), "more")


_MOVED: Mapping[Op, Callable[[Carrier, Instruction, Lows], Operand]] = {
    Op.SIN: _turned, Op.COS: _turned, Op.EXP: _grown, Op.TANH: _saturated,
    Op.ATAN2: _seen_from_the_origin}

# comparisons and choices


def _absolute(c: Carrier, step: Instruction, low: Lows) -> Operand | None:
    if low[0] is None:
        return None
    negative = c.issue(step, Op.LESS, (step.operands[0], ZERO), "negative")
    opposite = c.issue(step, Op.NEG, (low[0],), "opposite")
    return c.issue(step, Op.SELECT, (negative, opposite, low[0]), "lo")


def _selected(c: Carrier, step: Instruction, low: Lows) -> Operand | None:
    if low[1] is None and low[2] is None:
        return None
    chosen = tuple(ZERO if x is None else x for x in low[1:])
    return c.issue(step, Op.SELECT, (step.operands[0], *chosen), "lo")


def _gathered(c: Carrier, step: Instruction, low: Lows) -> Operand | None:
    """lo of a table's number: that of another table, in the same row."""
    of, at = step.operands
    assert isinstance(of, TableColumn)
    rests = rest_of_table(of.table, c.precision)
    column = replace(of, table=rests)
    return c.issue(step, Op.GATHER, (column, at), "lo") if any(column.values) else None


RULES: Mapping[Op, Rule] = {
    Op.ADD: total, Op.SUB: total, Op.MUL: product, Op.NEG: negation, Op.DIV: _by(_quotient),
    Op.SQRT: _by(_root), Op.SCALE: _by(_scaled), **{op: _by(_called) for op in _MOVED},
    Op.ABS: _by(_absolute), **{op: _by(lambda c, step, low: None) for op in COMPARISONS},
    Op.SELECT: _by(_selected, normal=False), Op.INDEX: _by(lambda c, step, low: None),
    Op.GATHER: _by(_gathered)}
"""A rule for every operation that tiers carry; truth values and indices have no lo."""
