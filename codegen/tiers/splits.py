"""Numbers that a program splits in two: h = (x + g) - g, the first digits of x, and x - h.

In exact arithmetic h is x, and its rounding is no error: results are the same whatever h is.  That
is held by an identity test: they are computed modulo a prime with other numbers for h, and must
not change.
"""

import hashlib
from collections.abc import Callable
from fractions import Fraction

from coscrew_codegen.program import Constant, Instruction, Op, Program
from coscrew_codegen.program.interpreter import Arithmetic, interpreter
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.program.program import name_of

PRIME = 2**61 - 1
TRIALS = 16
"""Each takes other branches; where an identity fails, one misses it with a chance near 2^-50."""
_FIELD: dict[Op, Callable[..., int]] = {
    Op.ADD: lambda a, b: (a + b) % PRIME, Op.SUB: lambda a, b: (a - b) % PRIME,
    Op.MUL: lambda a, b: a * b % PRIME, Op.DIV: lambda a, b: a * pow(b, PRIME - 2, PRIME) % PRIME,
    Op.NEG: lambda a: -a % PRIME, Op.SELECT: lambda test, a, b: a if test else b}


def splits(program: Program) -> frozenset[str]:
    """The names of these h; none if a result depends on one."""
    steps = {step.name: step for step in program.instructions}

    def is_split(step: Instruction) -> bool:
        first = steps.get(name_of(step.operands[0]))
        return (step.op is Op.SUB and first is not None and first.op is Op.ADD
                and step.operands[1] in first.operands)

    found = frozenset(step.name for step in program.instructions if is_split(step))
    same = all(_results(program, trial, found) == _results(program, trial, frozenset())
               for trial in range(TRIALS if found else 0))
    return found if same else frozenset()


def _results(program: Program, trial: int, other: frozenset[str]) -> list[int]:
    """The program's results at random inputs; with other numbers for these values."""
    def function(step: Instruction, number: int) -> Callable[..., int]:
        if step.name in other:
            return lambda *operands: _drawn(trial, step.name)
        if step.op in _FIELD:
            return _FIELD[step.op]
        size = 2 if step.op in COMPARISONS else PRIME
        return lambda *operands: _drawn(trial, step.op.value, *operands) % size

    def constant(x: Constant) -> int:
        value = Fraction(x.double)
        return value.numerator * pow(value.denominator, -1, PRIME) % PRIME

    run = interpreter(program, Arithmetic(constant, function, 0))
    return run([[_drawn(trial, a.name, k) for k in range(a.quantity.size)]
                for a in program.inputs])


def _drawn(*words: object) -> int:
    """A number that looks random, the same for the same words."""
    return int.from_bytes(hashlib.sha256(repr(words).encode()).digest()[:16], "big") % PRIME
