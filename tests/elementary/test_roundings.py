"""Proofs of roundings are repeated; the analysis holds against random Programs in exact rationals.
"""

import operator
import random
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest

from coscrew_codegen.program import Op, Program, without_dead_steps
from coscrew_codegen.program.elementary import atan2, exp, tanh
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.elementary.proofs import atan2_proof
from coscrew_codegen.program.elementary.proofs.roundings import Roundings, UndecidedError, pieces
from coscrew_codegen.program.interpreter import by_operation, evaluate, exactly
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.program.values.quantity import ANY, SCALAR, Argument
from tests.support.each import each_precision
from tests.support.truth.elementary import values

INPUTS = tuple(Argument(name, SCALAR, ANY) for name in "ab")
OUT = (Argument("y", SCALAR),)


@each_precision
@pytest.mark.parametrize("module, proof", [(exp, exp), (tanh, tanh), (atan2, atan2_proof)],
                         ids=["exp", "tanh", "atan2"])
def test_errors_are_proved(module, proof, precision: Precision):
    stated = module.FUNCTION.error(precision)
    assert stated - Fraction(1, 500) < proof.roundings(precision) <= stated < 1


@each_precision
def test_the_reduction_of_exp_is_exact(precision: Precision):
    exp.reduction(precision)


def random_program(seed: int) -> Program:
    """Sums, differences, products and quotients of two inputs, constants and earlier steps."""
    rng, steps = random.Random(seed), StepWriter(*INPUTS)
    known = [*steps.inputs(), steps.constant(3), steps.constant(Fraction(5, 8))]
    for _ in range(9):
        a, b = rng.choices(known, k=2)
        operation = rng.choice([operator.add, operator.sub, operator.mul, operator.truediv])
        known.append(operation(a, b))
    y = steps.named("y", known[-1] + known[0])
    return without_dead_steps(steps.program("random", OUT, [y]))


RATIONAL = by_operation(lambda x: x.double, exactly())


@each_precision
def test_bounds_hold_for_random_programs(precision: Precision):
    """Ranges, grids and errors of results, at random arguments and at the ends of their ranges."""
    rng, decided = random.Random(11), 0
    for seed in range(300):
        program, analysis = random_program(seed), Roundings(precision)
        ends = [sorted(Fraction(rng.randint(-64, 64), 2**rng.randint(3, 9)) for _ in "ab")
                for _ in "ab"]
        ranges = [(low, low + (high - low) / 2**rng.randint(0, 8)) for low, high in ends]
        try:
            bound, = analysis.results(program, ["y"], [analysis.within(*x) for x in ranges], {})
        except UndecidedError:
            continue
        decided += 1
        given = [np.array([float(x) for x in low_high] + [
            rng.uniform(*map(float, low_high)) for _ in range(30)], precision.numpy_type)
            for low_high in ranges]
        got, = values(program, precision, *given)
        low, high, most = (analysis.number(x) for x in (bound.low, bound.high, bound.error.radius))
        most += abs(analysis.number(bound.error.mid))
        for a, b, y in zip(*(x.tolist() for x in (*given, got)), strict=True):
            exact, = evaluate(program, [[Fraction(a)], [Fraction(b)]], RATIONAL)
            y = Fraction(y)
            assert low <= y <= high and abs(y - exact) <= most, seed
            assert not y % Fraction(2)**min(bound.grid, 100), seed
            least, largest = (analysis.number(x) for x in bound.exact.range)
            assert least <= exact <= largest, seed
    assert decided > 150


def proved(program: Program, ranges: list[tuple[Fraction, Fraction]], precision: Precision,
           step: str = "y") -> tuple[Roundings, Fraction]:
    """The analysis and the largest error of a step."""
    analysis = Roundings(precision)
    value, = analysis.results(program, [step], [analysis.within(*x) for x in ranges], {})
    return analysis, analysis.number(value.error.radius)


def written(formula: Callable[..., StepValue]) -> Program:
    steps = StepWriter(*INPUTS)
    return steps.program("written", OUT, [steps.named("y", formula(*steps.inputs()))])


ONE_TWO, TWO_FOUR = (Fraction(1), Fraction(2)), (Fraction(2), Fraction(4))


def test_the_error_of_one_rounding():
    """Half an ulp of the largest result; a sum that is 4 at most has none of [4, 8)."""
    for formula, ranges, bits in ((operator.add, [ONE_TWO, ONE_TWO], -52),
                                  (operator.mul, [ONE_TWO, TWO_FOUR], -51),
                                  (operator.truediv, [ONE_TWO, TWO_FOUR], -54)):
        assert proved(written(formula), ranges, DOUBLE)[1] == Fraction(2)**bits


def test_differences_of_neighbours_are_exact():
    assert proved(written(operator.sub), [ONE_TWO, ONE_TWO], SINGLE)[1] == 0


def test_what_a_sum_rounds_cancels():
    """s + ((a - s) + b), s = a + b rounded: the error of s is gone, one of 2^-48 is left."""
    def corrected(a: StepValue, b: StepValue) -> StepValue:
        s = a + b
        return s + ((a - s) + b)

    ranges = [TWO_FOUR, (Fraction(1, 4), Fraction(1, 2))]
    _, error = proved(written(corrected), ranges, DOUBLE)
    assert error == Fraction(2)**-51
    _, error = proved(written(lambda a, b: (a - (a + b)) + b), ranges, DOUBLE)
    assert error == Fraction(2)**-51, "that of the sum, once"


def test_ulps_count_the_last_rounding_as_half_a_unit():
    program = written(lambda a, b: (a * b) + 1)
    analysis = Roundings(DOUBLE)
    piece = analysis.within(Fraction(1), Fraction(9, 8))
    value, = analysis.results(program, ["y"], [piece, analysis.constant(Fraction(1, 4))], {})
    assert analysis.ulps(value) == Fraction(1, 2), "the product is exact"
    value, = analysis.results(program, ["y"], [piece, analysis.constant(Fraction(3, 8))], {})
    assert analysis.ulps(value) == Fraction(1, 2) + Fraction(1, 8)
    assert analysis.ulps(value, relative=Fraction(2)**-60) < Fraction(1, 2) + Fraction(9, 64)


def test_choices_that_differ_are_refused_only_if_they_matter():
    analysis = Roundings(DOUBLE)
    steps = StepWriter(*INPUTS)
    a, b = steps.inputs()
    doubtful = steps.named("doubtful", (a < b).where(a, b))
    program = steps.program("choice", OUT, [steps.named("y", (b < 0).where(doubtful, a * 3))])
    ranges = [analysis.within(*ONE_TWO), analysis.within(*ONE_TWO)]
    assert analysis.results(program, ["y"], ranges, {})
    with pytest.raises(UndecidedError, match="doubtful_1"):
        analysis.results(program, ["doubtful"], ranges, {})
    known, = analysis.results(program, ["doubtful"], ranges, {"doubtful_1": lambda _: True})
    assert known.high == analysis.within(*ONE_TWO).high


def test_pieces_cover_the_interval():
    result = pieces(Fraction(-1), Fraction(3), 4, [Fraction(1, 3), Fraction(9)])
    assert [x for x, _ in result] == [-1, 0, Fraction(1, 3), 1, 2]
    assert [y for _, y in result] == [0, Fraction(1, 3), 1, 2, 3]


def test_operations_without_an_analysis_are_refused():
    steps = StepWriter(*INPUTS)
    a, _ = steps.inputs()
    program = steps.program("sine", OUT, [steps.named("y", steps.do(Op.SIN, a))])
    with pytest.raises(KeyError):
        Roundings(DOUBLE).results(program, ["y"], [Roundings(DOUBLE).within(*ONE_TWO)] * 2, {})
