"""The accurate tier in double precision: every intermediate result is carried as hi + lo.

The plain program's operations give hi; lo collects their exact rounding errors and what the
operands' own lo contribute, rounded.  The last addition hi + lo rounds the result.  First-order
errors cancel; what remains is of order u² S.

Operands of quotients, roots and arctangents are first made non-overlapping, hi the rounded hi + lo,
so that terms of order lo² do not matter however much has cancelled.  Residuals of quotients and roots,
a - q b and a - s s, are exact numbers; an arctangent's own rounding is the only one that stays.
Where lo is not a number (0/0, an infinite hi), hi stands.
"""

from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.program import (Constant, Instruction, Op, Operand, Program, Ref,
                                     without_dead_steps)

_ERROR_OF = {Op.ADD: Op.SUM_ERROR, Op.SUB: Op.DIFFERENCE_ERROR, Op.MUL: Op.PRODUCT_ERROR}
_ZERO, _ONE = (Constant(Fraction(n), Fraction(n)) for n in (0, 1))
COMPENSATED = {Op.ADD, Op.SUB, Op.MUL, Op.NEG, Op.DIV, Op.SQRT, Op.ATAN2, Op.SCALE, Op.ABS, Op.LESS,
               Op.EQUAL, Op.SELECT}
"""The operations whose results the tier knows how to carry."""
_NONLINEAR = {Op.DIV, Op.SQRT, Op.ATAN2, Op.SCALE}


def accurate(program: Program) -> Program:
    """The plain program compensated."""
    compensator = _Compensator()
    for step in program.instructions:
        compensator.compensate(step)
    guarded = bool(program.counts.keys() & _NONLINEAR)
    results = tuple(compensator.rounded(result, guarded) for result in program.results)
    return without_dead_steps(replace(program, instructions=tuple(compensator.steps),
                                      results=results))


class _Compensator:
    """Issues instructions; knows the lo of each hi."""

    def __init__(self) -> None:
        self.steps: list[Instruction] = []
        self._low: dict[str, Operand] = {}
        self._normal: dict[str, Operand] = {}  # what stands for a hi once it is normalized
        self._inverses: dict[Operand, Ref] = {}
        self._rules = {
            Op.DIV: self._quotient, Op.SQRT: self._root, Op.ATAN2: self._arctangent,
            Op.SCALE: self._scaled, Op.NEG: self._negated, Op.ABS: self._absolute,
            Op.SELECT: self._selected, Op.LESS: self._none, Op.EQUAL: self._none,
        }

    def compensate(self, step: Instruction) -> None:
        """hi and lo of one plain instruction, under its name and the same with _lo behind it."""
        known = (self._normal.get(getattr(x, "name", ""), x) for x in step.operands)
        step = replace(step, operands=tuple(known))
        if step.op in _NONLINEAR:
            step = replace(step, operands=tuple(self._normalized(step, x) for x in step.operands))
        self.steps.append(step)
        low = [self._low.get(getattr(x, "name", "")) for x in step.operands]
        total = self._rules.get(step.op, self._sum_or_product)(step, low)
        if total is not None:
            self._low[step.name] = total

    def _normalized(self, step: Instruction, operand: Operand) -> Operand:
        """hi + lo rounded, with its exact error as lo."""
        low = self._low.get(getattr(operand, "name", ""))
        if low is None or operand in self._normal.values():
            return operand
        name = operand.name
        total = self._issue(step, Op.ADD, (operand, low), f"of_{name}")
        error = self._issue(step, Op.SUM_ERROR, (operand, low, total), f"of_{name}_lo")
        self._low[total.name], self._normal[name] = error, total
        return total

    def _sum_or_product(self, step: Instruction, low: list[Operand | None]) -> Operand:
        contributions = self._contributions(step, low)
        operands = (*step.operands, Ref(step.name))
        error = self._issue(step, _ERROR_OF[step.op], operands, "error" if contributions else "lo")
        return self._total(step, error, contributions, "lo")

    def _contributions(self, step: Instruction,
                       low: list[Operand | None]) -> list[tuple[Op, Operand]]:
        """What the operands' lo add to the result's: (add or subtract, operand)."""
        left, right = low
        if step.op is Op.MUL:
            a, b = step.operands
            pairs = [pair for pair in ((left, b), (a, right)) if None not in pair]
            return [(Op.ADD, self._issue(step, Op.MUL, pair, f"cross{number}"))
                    for number, pair in enumerate(pairs, start=1)]
        return [(op, operand) for op, operand in ((Op.ADD, left), (step.op, right))
                if operand is not None]

    def _total(self, step: Instruction, first: Operand, contributions: list[tuple[Op, Operand]],
               suffix: str) -> Operand:
        """first ± contributions, the last sum under the name with this suffix."""
        total = first
        for number, (op, operand) in enumerate(contributions, start=1):
            last = number == len(contributions)
            total = self._issue(step, op, (total, operand), suffix if last else f"lo{number}")
        return total

    def _quotient(self, step: Instruction, low: list[Operand | None]) -> Operand:
        """(a - q b + a_lo - q b_lo) / b."""
        (a, b), q = step.operands, Ref(step.name)
        contributions = [(Op.ADD, low[0])] if low[0] is not None else []
        if low[1] is not None:
            contributions.append((Op.SUB, self._issue(step, Op.MUL, (q, low[1]), "cross")))
        residual = self._residual(step, a, (q, b))
        total = self._total(step, residual, contributions, "residual")
        return self._issue(step, Op.DIV, (total, b), "lo")

    def _root(self, step: Instruction, low: list[Operand | None]) -> Operand:
        """(a - s s + a_lo) / 2 s; 0 for s = 0."""
        (a,), s = step.operands, Ref(step.name)
        contributions = [(Op.ADD, low[0])] if low[0] is not None else []
        total = self._total(step, self._residual(step, a, (s, s)), contributions, "residual")
        is_zero = self._issue(step, Op.EQUAL, (s, _ZERO), "zero")
        twice = self._issue(step, Op.ADD, (s, s), "twice")
        divisor = self._issue(step, Op.SELECT, (is_zero, _ONE, twice), "divisor")
        return self._issue(step, Op.DIV, (total, divisor), "lo")

    def _residual(self, step: Instruction, a: Operand, factors: tuple[Operand, Operand]) -> Ref:
        """a - b c exactly, where b c is a but for a rounding."""
        p = self._issue(step, Op.MUL, factors, "product")
        error = self._issue(step, Op.PRODUCT_ERROR, (*factors, p), "product_error")
        rest = self._issue(step, Op.SUB, (a, p), "rest")
        return self._issue(step, Op.SUB, (rest, error), "exact")

    def _arctangent(self, step: Instruction, low: list[Operand | None]) -> Operand | None:
        """(x y_lo - y x_lo) / (x² + y²)."""
        y, x = step.operands
        pairs = [pair for pair in ((x, low[0]), (y, low[1])) if pair[1] is not None]
        if not pairs:
            return None
        terms = [self._issue(step, Op.MUL, pair, f"cross{n}") for n, pair in enumerate(pairs)]
        if low[0] is None:
            terms[0] = self._issue(step, Op.NEG, (terms[0],), "cross")
        total = self._issue(step, Op.SUB, tuple(terms), "cross") if len(terms) == 2 else terms[0]
        squares = [self._issue(step, Op.MUL, (z, z), f"square{n}") for n, z in enumerate((x, y))]
        divisor = self._issue(step, Op.ADD, tuple(squares), "square")
        return self._issue(step, Op.DIV, (total, divisor), "lo")

    def _scaled(self, step: Instruction, low: list[Operand | None]) -> Operand | None:
        """What a product p too small for all its digits lost, (a - p / s + a_lo) s; else 0, for p
        is a + a_lo rounded already."""
        if low[0] is None:
            return None
        (a, s), p = step.operands, Ref(step.name)
        if s not in self._inverses:
            self._inverses[s] = self._issue(step, Op.DIV, (_ONE, s), "inverse")
        back = self._issue(step, Op.MUL, (p, self._inverses[s]), "back")
        lost = self._issue(step, Op.SUB, (a, back), "lost")
        rest = self._issue(step, Op.ADD, (lost, low[0]), "rest")
        small = self._issue(step, Op.MUL, (rest, s), "small")
        nothing = self._issue(step, Op.EQUAL, (lost, _ZERO), "nothing_lost")
        return self._issue(step, Op.SELECT, (nothing, _ZERO, small), "lo")

    def _negated(self, step: Instruction, low: list[Operand | None]) -> Operand | None:
        return None if low[0] is None else self._issue(step, Op.NEG, (low[0],), "lo")

    def _absolute(self, step: Instruction, low: list[Operand | None]) -> Operand | None:
        if low[0] is None:
            return None
        negative = self._issue(step, Op.LESS, (step.operands[0], _ZERO), "negative")
        opposite = self._issue(step, Op.NEG, (low[0],), "opposite")
        return self._issue(step, Op.SELECT, (negative, opposite, low[0]), "lo")

    def _selected(self, step: Instruction, low: list[Operand | None]) -> Operand | None:
        if low[1] is None and low[2] is None:
            return None
        chosen = tuple(_ZERO if x is None else x for x in low[1:])
        return self._issue(step, Op.SELECT, (step.operands[0], *chosen), "lo")

    def _none(self, step: Instruction, low: list[Operand | None]) -> None:
        """Comparisons look at hi."""

    def _issue(self, step: Instruction, op: Op, operands: tuple[Operand, ...],
               suffix: str) -> Ref:
        name = f"{step.name}_{suffix}"
        self.steps.append(Instruction(name, op, operands, step.component))
        return Ref(name)

    def rounded(self, result: Operand, guarded: bool) -> Operand:
        """hi + lo, the component's final value; if guarded, hi where that is not a number."""
        low = self._low.get(getattr(result, "name", ""))
        if low is None:
            return result
        name = f"{result.name}_rounded"
        if name in (step.name for step in self.steps):
            return Ref(name)
        total = Instruction(f"{result.name}_total" if guarded else name, Op.ADD, (result, low), name)
        self.steps.append(total)
        if guarded:
            number = Instruction(f"{name}_number", Op.EQUAL, (Ref(total.name),) * 2, name)
            choice = Instruction(name, Op.SELECT, (Ref(number.name), Ref(total.name), result), name)
            self.steps += [number, choice]
        return Ref(name)
