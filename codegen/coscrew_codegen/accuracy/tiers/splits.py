"""Finds numbers that results do not depend on, so that their errors do not count.

A program splits numbers in two: h = (x + g) - g, the first digits of x, and x - h.  In exact
arithmetic h is x, and results are the same whatever h is.  It scales numbers by powers of two that
it chooses, and scales results back; they are the same for every choice.

An identity test verifies both: results are computed modulo a prime with other numbers for h and
other choices, and must not change.  A square's character stands for the sign there, so that sizes,
roots and comparisons are scaled as those of real numbers are: 2 is a square."""

import hashlib
from collections.abc import Callable
from fractions import Fraction

from coscrew_codegen.program import Constant, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.interpreter import Arithmetic, interpreter
from coscrew_codegen.program.program import is_power_of_two, name_of

PRIME = 2**61 - 1  # 7 modulo 8: 2 is a square, and x^((p + 1) / 4) is the root of a square x
TRIALS = 16
"""Number of trials; each takes other branches, and misses a wrong identity with a probability near
2^-50."""
Choose = Callable[[int, Instruction], Callable[..., int]]
"""Value of an instruction in a trial."""


def splits(program: Program) -> frozenset[str]:
    """The names of these h; none if a result depends on one."""
    steps = {step.name: step for step in program.instructions}

    def is_split(step: Instruction) -> bool:
        first = steps.get(name_of(step.operands[0]))
        return (step.op is Op.SUB and first is not None and first.op is Op.ADD
                and step.operands[1] in first.operands)

    result = frozenset(step.name for step in program.instructions if is_split(step))
    return _indifferent(program, result, lambda trial, step: lambda *x: _drawn(trial, step.name))


def scalings(program: Program) -> frozenset[str]:
    """The names of choices between powers of two; none if a result depends on one.  Choices that
    only compare powers of two, and so follow from others, do not count."""
    powers: dict[Operand, bool] = {}  # whether chosen freely

    def is_power(x: Operand) -> bool:
        return x in powers or isinstance(x, Constant) and is_power_of_two(x)

    steps = {step.name: step for step in program.instructions}
    for step in program.instructions:
        if step.op is Op.SELECT and all(map(is_power, step.operands[1:])):
            compared = steps[name_of(step.operands[0])].operands
            powers[Ref(step.name)] = not all(map(is_power, compared))
    result = frozenset(x.name for x, free in powers.items() if free and isinstance(x, Ref))
    return _indifferent(program, result, lambda trial, step: lambda test, *x: x[
        _drawn(trial, step.name) % 2])


def _indifferent(program: Program, names: frozenset[str], choose: Choose) -> frozenset[str]:
    """These names if no result depends on their values, else none."""
    same = all(_results(program, trial, names, choose) == _results(program, trial)
               for trial in range(TRIALS if names else 0))
    return names if same else frozenset()


def _results(program: Program, trial: int, other: frozenset[str] = frozenset(),
             choose: Choose | None = None) -> list[int]:
    """The program's results at random inputs, with other values for these names."""
    known: dict[int, Fraction] = {}

    def less(a: int, b: int) -> bool:
        return known[a] < known[b] if a in known and b in known else _character(b - a) == 1

    field: dict[Op, Callable[..., int]] = {
        Op.ADD: lambda a, b: (a + b) % PRIME, Op.SUB: lambda a, b: (a - b) % PRIME,
        Op.MUL: lambda a, b: a * b % PRIME, Op.SCALE: lambda a, b: a * b % PRIME,
        Op.DIV: _quotient, Op.NEG: lambda a: -a % PRIME,
        Op.ABS: lambda a: a * _character(a) % PRIME,
        Op.SQRT: lambda a: pow(a, (PRIME + 1) // 4, PRIME), Op.LESS: less,
        Op.EQUAL: lambda a, b: a == b, Op.SELECT: lambda test, a, b: a if test else b,
        Op.ATAN2: lambda y, x: _drawn(trial, "atan2", _quotient(y, x))}

    def function(step: Instruction, number: int) -> Callable[..., int]:
        if choose and step.name in other:
            return choose(trial, step)
        return field.get(step.op) or (lambda *operands: _drawn(trial, step.op.value, *operands))

    def constant(x: Constant) -> int:
        value = Fraction(x.double)
        residue = value.numerator * pow(value.denominator, -1, PRIME) % PRIME
        known[residue] = value
        return residue

    run = interpreter(program, Arithmetic(constant, function, 0))
    return run([[_drawn(trial, a.name, k) for k in range(a.quantity.size)]
                for a in program.inputs])


def _quotient(a: int, b: int) -> int:
    return a * pow(b, PRIME - 2, PRIME) % PRIME


def _character(x: int) -> int:
    """1 of squares, -1 of others, 0 of 0."""
    return {0: 0, 1: 1}.get(pow(x, (PRIME - 1) // 2, PRIME), -1)


def _drawn(*words: object) -> int:
    """A number that looks random, the same for the same words."""
    return int.from_bytes(hashlib.sha256(repr(words).encode()).digest()[:16], "big") % PRIME
