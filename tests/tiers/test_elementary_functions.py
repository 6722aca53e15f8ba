"""Elementary functions of hi + lo in the accurate tier, against MPFR."""

from dataclasses import replace

import gmpy2
import numpy as np
import pytest

from coscrew_codegen.accuracy.tiers.accurate import accurate
from coscrew_codegen.program import Input, Instruction, Op, Program, Ref
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.program.values.quantity import SCALAR, Argument
from tests.support.truth.elementary import Array, truth, values

NAMES = "abcd"


def of_sums(*ops: Op) -> Program:
    """The functions of a + b, of two operands of c + d, too."""
    steps = [Instruction("x", Op.ADD, (Input(0, 0), Input(1, 0)), "x"),
             Instruction("y", Op.ADD, (Input(2, 0), Input(3, 0)), "y")]
    for n, op in enumerate(ops):
        operands = (Ref("x"), Ref("y"))[:op.meaning.arity]
        steps.append(Instruction(f"f{n}", op, operands, f"f{n}"))
    return Program("functions", tuple(Argument(x, SCALAR) for x in NAMES), tuple(
        Argument(step.name, SCALAR) for step in steps[2:]), tuple(steps), tuple(
        Ref(step.name) for step in steps[2:]))


def arguments() -> list[Array]:
    """Sums whose last digits are lost, also where little remains of them."""
    rng = np.random.default_rng(3)
    a, c = (rng.uniform(-1, 1, 3000) * 2.0**rng.uniform(-20, 9.4, 3000) for _ in range(2))
    b, d = (x * rng.choice((2.0**-30, 2.0**-54, -1 + 2.0**-20, 1), 3000) *
            rng.uniform(0.9, 1, 3000) for x in (a, c))
    return [a, b, c, d]


@pytest.mark.parametrize("ops", [(Op.SIN, Op.COS), (Op.COS, Op.SIN), (Op.SIN,), (Op.COS,),
                                 (Op.EXP,), (Op.TANH,), (Op.ATAN2,)],
                         ids=lambda ops: " ".join(op.value for op in ops))
def test_of_a_sum_they_have_twice_the_digits(ops: tuple[Op, ...]):
    """hi + lo before they are rounded, of the exact sum x: within 2^-99, and 2 u² of x."""
    given, program = arguments(), accurate(of_sums(*ops))
    sums = {step.name: step for step in program.instructions if step.name.endswith("_rounded")}
    halves = [x for n in range(len(ops)) for x in sums[f"f{n}_rounded"].operands]
    result = values(replace(program, results=tuple(halves)), DOUBLE, *given)
    with gmpy2.context(precision=400):
        exact = [list(map(gmpy2.mpfr, row)) for row in zip(*map(np.ndarray.tolist, given),
                                                           strict=True)]
        for n, op in enumerate(ops):
            for hi, lo, (a, b, c, d) in zip(*map(np.ndarray.tolist, result[2 * n:2 * n + 2]), exact,
                                            strict=True):
                true = truth(op.value, [a + b, c + d][:op.meaning.arity])
                slope = {Op.ATAN2: 0, Op.EXP: true}.get(op, 1)
                bound = 2.0**-99 * abs(true) + 2.0**-105 * abs(a + b) * slope
                if np.isfinite(hi) and abs(true) > 1e-280:
                    assert abs(hi + gmpy2.mpfr(lo) - true) <= bound, (op, a, b, c, d)
