"""Elementary functions of hi + lo in the accurate tier, against MPFR."""

import gmpy2
import numpy as np
import pytest

from coscrew_codegen.formats import DOUBLE
from coscrew_codegen.program import Input, Instruction, Op, Program, Ref
from coscrew_codegen.quantity import SCALAR, Argument
from coscrew_codegen.tiers.accurate import accurate
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
    a, c = (rng.uniform(-1, 1, 3000) * 2.0**rng.uniform(-20, 6, 3000) for _ in range(2))
    b, d = (x * rng.choice((2.0**-30, 2.0**-54, -1 + 2.0**-20, 1), 3000) *
            rng.uniform(0.9, 1, 3000) for x in (a, c))
    return [a, b, c, d]


@pytest.mark.parametrize("ops", [(Op.SIN, Op.COS), (Op.COS, Op.SIN), (Op.SIN,), (Op.COS,),
                                 (Op.EXP,), (Op.TANH,), (Op.ATAN2,)],
                         ids=lambda ops: " ".join(op.value for op in ops))
def test_of_a_sum_they_are_rounded_once(ops: tuple[Op, ...]):
    """Half an ulp of the function of the exact sum, and 2^-40 of that."""
    given = arguments()
    found = values(accurate(of_sums(*ops)), DOUBLE, *given)
    with gmpy2.context(precision=400):
        rows = [[gmpy2.mpfr(x) for x in row] for row in zip(*map(np.ndarray.tolist, given),
                                                            strict=True)]
        for op, results in zip(ops, found, strict=True):
            worst = max(
                float(abs((got - true) / true)) for got, (a, b, c, d) in zip(
                    results.tolist(), rows, strict=True)
                if (true := truth(op.value, [a + b, c + d][:op.meaning.arity])))
            assert worst <= float(DOUBLE.u) * (1 + 2.0**-40), op
