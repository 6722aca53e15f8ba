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
_SUMS, _PASSING = {Op.ADD, Op.SUB}, {Op.NEG, Op.SELECT}
_CIRCULAR = {Op.SIN, Op.COS}


class OfScene(Accurate):
    """Of a function of a scene: products of sums are long chains there, and names are numbered.

    The lo of a sum that cancels is not small, and what it is multiplied by would have rounding
    errors of the order of u lo.  So every sum is first rounded to hi + lo with a small lo.  What is
    lost anywhere is then of the order of u² of the value there, and a result's error of the order
    of u² times its condition, even where intermediate results have lost all digits."""

    last = "hi + lo, rounded:"

    def __init__(self, program: Program, precision: Precision = DOUBLE) -> None:
        super().__init__()
        self.precision = precision
        self._taken = {step.name for step in program.instructions}
        self._numbers: Counter[str] = Counter()
        self._circles: dict[Operand, tuple[Ref, Ref]] = {}  # sines and cosines
        self._nearest: set[str] = set()  # exact operands, one rounding: these need no lo

    def compensate(self, step: Instruction) -> None:
        """As of its base; sums, and what is chosen among them or is one's negative, overlap."""
        if step.op is Op.LESS:
            step = replace(step, operands=tuple(
                _beyond(x, n > 0, self.precision) for n, x in enumerate(step.operands)))
        exact = all(map(self.is_exact, step.operands))
        if step.op in _SUMS and not exact or step.op in _PASSING and any(
                name_of(x) in self.overlapping and name_of(x) not in self._normal
                for x in step.operands):
            self.overlapping.add(step.name)
        if step.op in _ONCE and exact:
            self._nearest.add(step.name)
        if step.op in _CIRCULAR and not exact:
            self._turn(step)
        else:
            super().compensate(step)

    def _turn(self, step: Instruction) -> None:
        """Sine or cosine of x + x_lo by those of x and of x_lo, as sums of products.  A multiple of
        x_lo would have errors of u x_lo, which is not small where an angle is large."""
        x = self._normalized(step, self._normal.get(name_of(step.operands[0]), step.operands[0]))
        low = self.low(step, x)
        assert low is not None
        (s, c), (s_lo, c_lo) = self._circle(step, x), self._circle(step, low)
        sine = step.op is Op.SIN
        products = tuple(replace(step, name=self.name(step.name, f"turn{n}"), op=Op.MUL,
                                 operands=pair)
                         for n, pair in enumerate((((s, c_lo), (c, s_lo)) if sine else
                                                   ((c, c_lo), (s, s_lo))), start=1))
        for product in products:
            self.compensate(product)
        self.compensate(replace(step, op=Op.ADD if sine else Op.SUB,
                                operands=tuple(Ref(product.name) for product in products)))

    def _circle(self, step: Instruction, x: Operand) -> tuple[Ref, Ref]:
        """Sine and cosine of a number, once, as hi + lo."""
        if x not in self._circles:
            both = tuple(replace(step, name=self.name(step.name, op.value), op=op, operands=(x,))
                         for op in (Op.SIN, Op.COS))
            self.steps += both
            for each in both:
                self._low[each.name] = self._error(each)
            self._circles[x] = Ref(both[0].name), Ref(both[1].name)
        return self._circles[x]

    def rounded(self, result: Operand) -> Operand:
        """hi alone if that is the nearest number."""
        return result if name_of(result) in self._nearest else super().rounded(result)

    def rest(self, total: Instruction, hi: Operand, lo: Operand) -> Operand:
        """Fast Two-Sum, exact if |hi| >= |lo|.  Else it may err by u lo, but lo has errors of this
        size already: it is itself a rounded sum.  Source: Dekker, A Floating-Point Technique."""
        share = self.issue(total, Op.SUB, (Ref(total.name), hi), "share")
        return self.issue(total, Op.SUB, (lo, share), "lo")

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
