"""Compensated quotients, roots, elementary functions, comparisons and choices.

Operands of quotients, roots, arctangents and comparisons are first made non-overlapping: hi becomes
the rounded hi + lo.  Then terms of order lo² do not matter, however much has cancelled.  The
residuals of quotients and roots, a - q b and a - s s, are exact; what elementary functions err by
is computed by functions of their own.  Where lo is NaN (0/0, an infinite hi), the result is hi.
"""

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.program import (
    Constant,
    Instruction,
    Op,
    Operand,
    Program,
    Ref,
    without_dead_steps,
)
from coscrew_codegen.program.ops import ERROR_OF
from coscrew_codegen.program.program import name_of
from coscrew_codegen.tiers.compensated import Compensator

_ZERO, _HALF, _ONE = (Constant(Fraction(n, 2), Fraction(n, 2)) for n in (0, 1, 2))
_PARTNER = {Op.SIN: Op.COS, Op.COS: Op.SIN}
NONLINEAR = {Op.DIV, Op.SQRT, Op.SCALE, *ERROR_OF}
_JUDGING = {Op.ABS, Op.LESS, Op.EQUAL}  # after cancellation hi may be 0 and lo the whole value
COMPENSATED = frozenset({Op.ADD, Op.SUB, Op.MUL, Op.NEG, Op.ABS, Op.LESS, Op.EQUAL, Op.SELECT,
                         *NONLINEAR})
"""The operations that the tier can compensate."""


def compensated(program: Program, compensator: "Accurate") -> Program:
    """The program that the compensator issues for a plain one, its results rounded."""
    compensator.circular = {(step.op, step.operands): step for step in program.instructions
                            if step.op in _PARTNER}
    for step in program.instructions:
        compensator.compensate(step)
    guarded = bool(program.counts.keys() & NONLINEAR)
    results = tuple(compensator.final(result, guarded) for result in program.results)
    names = Counter(step.name for step in compensator.steps)
    if twice := [name for name, count in names.items() if count > 1]:
        raise ValueError(f"{program.name}: rename {twice[0]!r}, as its compensation is named")
    return without_dead_steps(replace(program, instructions=tuple(compensator.steps),
                                      results=results))


class Accurate(Compensator):
    """Adds to its base, which compensates sums and products, all other operations.

    `overlapping` names the results that are made non-overlapping before they are multiplied."""

    def __init__(self, overlapping: Iterable[str] = ()) -> None:
        super().__init__()
        self.overlapping = set(overlapping)
        self._normal: dict[str, Operand] = {}  # hi of normalized results, by their plain name
        self._normals: set[str] = set()
        self._finals: dict[Operand, Ref] = {}
        self._inverses: dict[Operand, Ref] = {}
        self.circular: dict[tuple[Op, tuple[Operand, ...]], Instruction] = {}  # sines, cosines
        self._partners: dict[str, Ref] = {}  # a sine's cosine, a cosine's sine
        self._turns: dict[Operand, tuple[Ref, Ref, Ref]] = {}  # by lo of an angle, sine and cosine
        # of its half, and twice that sine
        self._rules = {
            Op.SIN: self._sine_or_cosine, Op.COS: self._sine_or_cosine,
            Op.EXP: self._exponential, Op.TANH: self._hyperbolic_tangent,
            Op.DIV: self._quotient, Op.SQRT: self._root, Op.ATAN2: self._arctangent,
            Op.SCALE: self._scaled, Op.ABS: self._absolute, Op.SELECT: self._selected,
            Op.LESS: self._comparison, Op.EQUAL: self._comparison,
        }

    def compensate(self, step: Instruction) -> None:
        """Issue hi of a plain instruction under its name; and lo, or the parts of lo that are added
        where it is used."""
        known = (self._normal.get(name_of(x), x) for x in step.operands)
        partner = self.circular.get((_PARTNER.get(step.op, step.op), step.operands))
        step = replace(step, operands=tuple(known))
        if step.op not in self._rules:
            super().compensate(step)
            return
        if step.op in NONLINEAR | _JUDGING:
            step = replace(step, operands=tuple(self._normalized(step, x) for x in step.operands))
        low = [self.low(step, x) for x in step.operands]
        if step.op in _PARTNER:
            self._issue_both(step, partner)
        else:
            self.steps.append(step)
        total = self._rules[step.op](step, low)
        if total is not None:
            self._low[step.name] = total

    def _product(self, step: Instruction) -> None:
        factors = tuple(self.factor(step, x) for x in step.operands)
        super()._product(replace(step, operands=factors))

    def factor(self, step: Instruction, operand: Operand) -> Operand:
        """An operand as it is multiplied."""
        overlaps = name_of(operand) in self.overlapping
        return self._normalized(step, operand) if overlaps else operand

    def _normalized(self, step: Instruction, operand: Operand) -> Operand:
        """hi + lo rounded; its rounding error is the new lo."""
        low = self.low(step, operand)
        if low is None or isinstance(operand, Constant) or name_of(operand) in self._normals:
            return operand
        at = replace(step, name=self.normal_name(step, name_of(operand)), op=Op.ADD,
                     operands=(operand, low))
        self.steps.append(at)
        self._normals.add(at.name)
        self._low[at.name] = self.rest(at, operand, low)
        self._normal[name_of(operand)] = Ref(at.name)
        return Ref(at.name)

    def rest(self, total: Instruction, hi: Operand, lo: Operand) -> Operand:
        """What the rounding of hi + lo leaves, exactly: Two-Sum."""
        right = self.issue(total, Op.SUB, (Ref(total.name), hi), "right")
        left = self.issue(total, Op.EXACT_SUB, (Ref(total.name), right), "left")
        rests = (self.issue(total, Op.EXACT_SUB, (hi, left), "left_rest"),
                 self.issue(total, Op.EXACT_SUB, (lo, right), "right_rest"))
        return self.issue(total, Op.EXACT_ADD, rests, "lo")

    def normal_name(self, step: Instruction, operand: str) -> str:
        """The name of an operand of this instruction once it is normalized."""
        return f"{step.name}_of_{operand}"

    def _quotient(self, step: Instruction, low: list[Operand | None]) -> Operand:
        """lo of q = a / b: (a - q b + a_lo - q b_lo) / b."""
        (a, b), q = step.operands, Ref(step.name)
        total = self._residual(step, a, (q, b))
        if low[0] is not None:
            total = self.issue(step, Op.ADD, (total, low[0]), "numerator")
        if low[1] is not None:
            cross = self.issue(step, Op.MUL, (q, low[1]), "cross")
            total = self.issue(step, Op.SUB, (total, cross), "residual")
        return self.issue(step, Op.DIV, (total, b), "lo")

    def _root(self, step: Instruction, low: list[Operand | None]) -> Operand:
        """lo of s = sqrt(a): (a - s s + a_lo) / 2 s; 0 for s = 0."""
        (a,), s = step.operands, Ref(step.name)
        total = self._residual(step, a, (s, s))
        if low[0] is not None:
            total = self.issue(step, Op.ADD, (total, low[0]), "residual")
        is_zero = self.issue(step, Op.EQUAL, (s, _ZERO), "zero")
        twice = self.issue(step, Op.ADD, (s, s), "twice")
        divisor = self.issue(step, Op.SELECT, (is_zero, _ONE, twice), "divisor")
        return self.issue(step, Op.DIV, (total, divisor), "lo")

    def _residual(self, step: Instruction, a: Operand, factors: tuple[Operand, Operand]) -> Ref:
        """a - b c exactly, where b c and a differ by a rounding only."""
        p = self.issue(step, Op.MUL, factors, "product")
        error = self.issue(step, Op.PRODUCT_ERROR, (*factors, p), "product_error")
        rest = self.issue(step, Op.SUB, (a, p), "rest")
        return self.issue(step, Op.SUB, (rest, error), "exact")

    def _issue_both(self, step: Instruction, partner: Instruction | None) -> None:
        """A sine and the cosine of the same operand, where the first of them is."""
        if step.name not in self._partners:
            name = partner.name if partner and partner.name not in self._partners \
                else self.name(step.name, "partner")
            self.steps += [step, replace(step, name=name, op=_PARTNER[step.op])]
            self._partners |= {step.name: Ref(name), name: Ref(step.name)}

    def _sine_or_cosine(self, step: Instruction, low: list[Operand | None]) -> Operand:
        """lo of s = sin x: sin x - s + 2 p (q c - p s), where p and q are sine and cosine of
        x_lo / 2; of c = cos x: cos x - c - 2 p (q s + p c)."""
        error = self._error(step)
        x_lo, = low
        if x_lo is None:
            return error
        if x_lo not in self._turns:
            half = self.issue(step, Op.MUL, (x_lo, _HALF), "half")
            p, q = (self.issue(step, op, (half,), f"half_{op.value}") for op in (Op.SIN, Op.COS))
            self._turns[x_lo] = p, q, self.issue(step, Op.ADD, (p, p), "twice")
        p, q, twice = self._turns[x_lo]
        partner, sine = self._partners[step.name], step.op is Op.SIN
        terms = (self.issue(step, Op.MUL, (q, partner), "slope1"),
                 self.issue(step, Op.MUL, (p, Ref(step.name)), "slope2"))
        slope = self.issue(step, Op.SUB if sine else Op.ADD, terms, "slope")
        more = self.issue(step, Op.MUL, (slope, twice), "more")
        return self.issue(step, Op.ADD if sine else Op.SUB, (error, more), "lo")

    def _exponential(self, step: Instruction, low: list[Operand | None]) -> Operand:
        """lo of y = exp x: exp x - y + y (x_lo + x_lo²/2); the square matters for large x."""
        error = self._error(step)
        x_lo, = low
        if x_lo is None:
            return error
        half = self.issue(step, Op.MUL, (x_lo, _HALF), "half")
        bend = self.issue(step, Op.MUL, (half, x_lo), "bend")
        shift = self.issue(step, Op.ADD, (bend, x_lo), "shift")
        more = self.issue(step, Op.MUL, (Ref(step.name), shift), "more")
        return self.issue(step, Op.ADD, (error, more), "lo")

    def _hyperbolic_tangent(self, step: Instruction, low: list[Operand | None]) -> Operand:
        """lo of y = tanh x: tanh x - y + (1 - y) (1 + y) x_lo."""
        error, y = self._error(step), Ref(step.name)
        x_lo, = low
        if x_lo is None:
            return error
        factors = (self.issue(step, Op.SUB, (_ONE, y), "below"),
                   self.issue(step, Op.ADD, (_ONE, y), "above"))
        slope = self.issue(step, Op.MUL, factors, "slope")
        more = self.issue(step, Op.MUL, (slope, x_lo), "more")
        return self.issue(step, Op.ADD, (error, more), "lo")

    def _error(self, step: Instruction) -> Ref:
        """What an elementary function errs by."""
        return self.issue(step, ERROR_OF[step.op], (*step.operands, Ref(step.name)), "own_error")

    def _arctangent(self, step: Instruction, low: list[Operand | None]) -> Operand:
        """lo of atan2(y, x): what it errs by, and (x y_lo - y x_lo) / (x² + y²), computed with
        x / m and y / m, m = max(|x|, |y|), so that squares don't overflow."""
        error = self._error(step)
        if low == [None, None]:
            return error
        sizes = [self.issue(step, Op.ABS, (z,), f"size{n}") for n, z in enumerate(step.operands)]
        larger = self.issue(step, Op.LESS, (sizes[0], sizes[1]), "larger")
        m = self.issue(step, Op.SELECT, (larger, sizes[1], sizes[0]), "most")
        zero = self.issue(step, Op.EQUAL, (m, _ZERO), "zero")
        m = self.issue(step, Op.SELECT, (zero, _ONE, m), "divisor")
        y, x = (self.issue(step, Op.DIV, (z, m), f"part{n}") for n, z in enumerate(step.operands))
        y_lo, x_lo = (_ZERO if lo is None else lo for lo in low)
        terms = (self.issue(step, Op.MUL, (x, y_lo), "cross1"),
                 self.issue(step, Op.MUL, (y, x_lo), "cross2"))
        squares = (self.issue(step, Op.MUL, (x, x), "square1"),
                   self.issue(step, Op.MUL, (y, y), "square2"))
        total = self.issue(step, Op.SUB, terms, "cross")
        square = self.issue(step, Op.ADD, squares, "square")
        divisor = self.issue(step, Op.MUL, (m, square), "divisor2")
        safe = self.issue(step, Op.SELECT, (zero, _ONE, divisor), "safe")
        more = self.issue(step, Op.DIV, (total, safe), "more")
        return self.issue(step, Op.ADD, (error, more), "lo")

    def _scaled(self, step: Instruction, low: list[Operand | None]) -> Operand | None:
        """lo of p = a s, s a power of two: (a - p / s + a_lo) s; a and p / s differ only where
        p has lost digits by underflow."""
        if low[0] is None:
            return None
        (a, s), p = step.operands, Ref(step.name)
        if s not in self._inverses:
            self._inverses[s] = self.issue(step, Op.DIV, (_ONE, s), "inverse")
        back = self.issue(step, Op.MUL, (p, self._inverses[s]), "back")
        lost = self.issue(step, Op.SUB, (a, back), "lost")
        rest = self.issue(step, Op.ADD, (lost, low[0]), "rest")
        return self.issue(step, Op.MUL, (rest, s), "lo")

    def _absolute(self, step: Instruction, low: list[Operand | None]) -> Operand | None:
        if low[0] is None:
            return None
        negative = self.issue(step, Op.LESS, (step.operands[0], _ZERO), "negative")
        opposite = self.issue(step, Op.NEG, (low[0],), "opposite")
        return self.issue(step, Op.SELECT, (negative, opposite, low[0]), "lo")

    def _selected(self, step: Instruction, low: list[Operand | None]) -> Operand | None:
        if low[1] is None and low[2] is None:
            return None
        chosen = tuple(_ZERO if x is None else x for x in low[1:])
        return self.issue(step, Op.SELECT, (step.operands[0], *chosen), "lo")

    def _comparison(self, step: Instruction, low: list[Operand | None]) -> None:
        """Compare hi + lo rounded."""

    def final(self, result: Operand, guarded: bool) -> Operand:
        """hi + lo rounded; if guarded, hi where that is NaN."""
        total = self.rounded(result)
        if not guarded or total == result:
            return total
        if total not in self._finals:
            last = self.last or name_of(total)
            at = Instruction(self.name(name_of(total), "number"), Op.EQUAL, (total, total), last)
            choice = Instruction(self.name(name_of(result), "final"), Op.SELECT,
                                 (Ref(at.name), total, result), last)
            self.steps += [at, choice]
            self._finals[total] = Ref(choice.name)
        return self._finals[total]
