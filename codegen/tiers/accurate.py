"""The accurate tier in double precision: every intermediate result is carried as hi + lo.

The plain program's operations give hi; lo collects their exact rounding errors and what the
operands' own lo contribute, rounded.  The last addition hi + lo rounds the result.  First-order
errors cancel; what remains is of order u² S.
"""

from dataclasses import replace

from coscrew_codegen.program import Instruction, Op, Operand, Program, Ref

_ERROR_OF = {Op.ADD: Op.SUM_ERROR, Op.SUB: Op.DIFFERENCE_ERROR, Op.MUL: Op.PRODUCT_ERROR}


def accurate(program: Program) -> Program:
    """The polynomial plain program compensated."""
    compensator = _Compensator()
    for step in program.instructions:
        compensator.compensate(step)
    results = tuple(map(compensator.rounded, program.results))
    return replace(program, instructions=tuple(compensator.steps), results=results)


class _Compensator:
    """Issues instructions; knows the lo of each hi."""

    def __init__(self) -> None:
        self.steps: list[Instruction] = []
        self._low: dict[str, Operand] = {}

    def compensate(self, step: Instruction) -> None:
        """hi and lo of one plain instruction, under its name and the same with _lo behind it."""
        self.steps.append(step)
        hi, low = Ref(step.name), [self._low.get(getattr(x, "name", "")) for x in step.operands]
        name = f"{step.name}_lo"
        if step.op is Op.NEG:
            if low[0] is not None:
                self._low[step.name] = self._issue(step, Op.NEG, (low[0],), name)
            return
        contributions = self._contributions(step, low)
        total = self._issue(step, _ERROR_OF[step.op], (*step.operands, hi),
                            f"{step.name}_error" if contributions else name)
        for number, (op, operand) in enumerate(contributions, start=1):
            last = number == len(contributions)
            total = self._issue(step, op, (total, operand), name if last else f"{name}{number}")
        self._low[step.name] = total

    def _contributions(self, step: Instruction,
                       low: list[Operand | None]) -> list[tuple[Op, Operand]]:
        """What the operands' lo add to the result's: (add or subtract, operand)."""
        left, right = low
        if step.op is Op.MUL:
            a, b = step.operands
            pairs = [pair for pair in ((left, b), (a, right)) if None not in pair]
            return [(Op.ADD, self._issue(step, Op.MUL, pair, f"{step.name}_cross{number}"))
                    for number, pair in enumerate(pairs, start=1)]
        return [(op, operand) for op, operand in ((Op.ADD, left), (step.op, right))
                if operand is not None]

    def _issue(self, step: Instruction, op: Op, operands: tuple[Operand, ...], name: str) -> Ref:
        self.steps.append(Instruction(name, op, operands, step.component))
        return Ref(name)

    def rounded(self, result: Operand) -> Operand:
        """hi + lo, the component's final value."""
        low = self._low.get(getattr(result, "name", ""))
        if low is None:
            return result
        name = f"{result.name}_rounded"
        if name not in (step.name for step in self.steps):
            self.steps.append(Instruction(name, Op.ADD, (result, low), name))
        return Ref(name)
