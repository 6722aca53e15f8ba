"""The accurate tier of scenes: their functions are longer than operations, and their constants are
decimals."""

import math
import re
from collections import Counter
from dataclasses import replace
from fractions import Fraction

import numpy as np

from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.program import Constant, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.ops import ERROR_OF
from coscrew_codegen.program.program import name_of
from coscrew_codegen.tiers.compensated import rounded_constant
from coscrew_codegen.tiers.nonlinear import Accurate, compensated


def of_scene(program: Program, precision: Precision) -> Program:
    """The plain program of a scene's function, whose constants are decimals: hi + lo in double; in
    single precision doubles."""
    if precision == DOUBLE:
        return in_pairs(program, DOUBLE)
    return replace(rounded(program.fine or program, DOUBLE), wide=True)


def in_pairs(program: Program, precision: Precision) -> Program:
    """The plain program with every value, constants included, as hi + lo in this precision."""
    program = program.fine or program
    return rounded(compensated(program, OfScene(program, precision)), precision)


def rounded(program: Program, precision: Precision) -> Program:
    def rounded(x: Operand) -> Operand:
        return rounded_constant(x, precision) if isinstance(x, Constant) else x

    steps = tuple(replace(step, operands=tuple(map(rounded, step.operands)))
                  for step in program.instructions)
    return replace(program, instructions=steps, results=tuple(map(rounded, program.results)),
                   fine=None)


def _beyond(x: Operand, above: bool, precision: Precision) -> Operand:
    """For a number to the left or to the right of <: that of the precision which compares with all
    others as the constant does."""
    if not isinstance(x, Constant):
        return x
    true, near = precision.value(x), precision.rounded(precision.value(x))
    if near != true and (near > true) != above:
        near = np.nextafter(near, near.dtype.type(math.inf if above else -math.inf))
    return Constant(Fraction(float(near)), Fraction(float(near)), x.name)


_NUMBER = re.compile(r"_[0-9]+$")
_ONCE = {Op.ADD, Op.SUB, Op.MUL, Op.DIV, Op.SQRT}
_RESTING = {Op.DIV, Op.SQRT, *ERROR_OF}


class OfScene(Accurate):
    """Of a function of a scene: products of sums are long chains there, and names are numbered.

    After cancellation the lo of a sum is not small, nor is that of a product of such a sum: in a
    product of two of these, a_lo b_lo matters, and a_lo is multiplied by b + b_lo."""

    last = "hi + lo, rounded:"

    def __init__(self, program: Program, precision: Precision = DOUBLE) -> None:
        super().__init__()
        self.precision = precision
        self._taken = {step.name for step in program.instructions}
        self._numbers: Counter[str] = Counter()
        self._cancelled: set[str] = set()  # hi whose lo may not be small
        self._whole: dict[str, Ref] = {}
        self._nearest: set[str] = set()  # exact operands, one rounding: these need no lo

    def compensate(self, step: Instruction) -> None:
        """As of its base; a result may have cancelled if it is a sum or is made of one."""
        if step.op is Op.LESS:
            step = replace(step, operands=tuple(
                _beyond(x, n > 0, self.precision) for n, x in enumerate(step.operands)))
        if step.op in (Op.ADD, Op.SUB) or step.op not in _RESTING and any(
                name_of(x) in self._cancelled and name_of(x) not in self._normal
                for x in step.operands):
            self._cancelled.add(step.name)
        if step.op in _ONCE and all(map(self.is_exact, step.operands)):
            self._nearest.add(step.name)
        super().compensate(step)

    def rounded(self, result: Operand) -> Operand:
        """hi alone if that is the nearest number."""
        return result if name_of(result) in self._nearest else super().rounded(result)

    def factor(self, step: Instruction, a: Operand, b: Operand) -> Operand:
        """b + b_lo, computed once, if both may have cancelled."""
        low = self.low(step, b)
        if low is None or not self._cancelled.issuperset((name_of(a), name_of(b))):
            return b
        if name_of(b) not in self._whole:
            self._whole[name_of(b)] = self.issue(step, Op.ADD, (b, low), "whole")
        return self._whole[name_of(b)]

    def normal_name(self, step: Instruction, operand: str) -> str:
        """Named after the operand."""
        return self.name(operand, "nearest")

    def name(self, of: str, suffix: str) -> str:
        """Numbered, so that it may be nested and is numbered again; but lo of a named value."""
        stem = f"{_NUMBER.sub('', of)}_{suffix}"
        name = stem if suffix == "lo" and not _NUMBER.search(of) else ""
        while not name or name in self._taken:
            self._numbers[stem] += 1
            name = f"{stem}_{self._numbers[stem]}"
        self._taken.add(name)
        return name
