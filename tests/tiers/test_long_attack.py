"""The long attack: its truth is correct, and broken kernels do not pass."""


import numpy as np
import pytest
from gmpy2 import mpq

import coscrew
import coscrew.accurate
import coscrew.certified
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.long_attack import attack_at_length
from tests.search import joined, split
from tests.support.cases import for_all
from tests.support.compiled.implementations import gufuncs
from tests.support.each import each_precision
from tests.support.truth.attack import (
    TIERED,
    Arrays,
    Implementation,
    bounds,
    exact_functions,
    extreme_rows,
    plain_program,
    rows,
)
from tests.support.truth.judge import ratio
from tests.support.truth.wide import IS_WIDE, WIDE, enclosed, linear

pytestmark = pytest.mark.skipif(not IS_WIDE, reason="long double has no 64 bits here")
BY_NAME = {op.name: op for op in TIERED}
WAYS = {"plain": gufuncs(coscrew), "accurate": gufuncs(coscrew.accurate),
        "certified": gufuncs(coscrew.certified)}

operations = pytest.mark.parametrize("operation", TIERED, ids=lambda op: op.name)


def exactly(x: np.longdouble) -> mpq:
    """The long double as a rational."""
    fraction, exponent = np.frexp(x)
    return mpq(int(fraction * WIDE(2)**64)) * mpq(2)**(int(exponent) - 64)


@operations
@for_all(precision=PRECISIONS)
def test_truth_is_enclosed(operation: Operation, precision: Precision):
    """Within a radius far below any bound; S within 2^-50."""
    given = np.concatenate([joined(draw(operation, precision, count, 5)) for draw, count in
                            ((rows, 12), (extreme_rows, 4))])
    given = given[np.isfinite(given).all(axis=1)]
    result = enclosed(plain_program(operation), precision, given)
    for number, row in enumerate(given.tolist()):
        values = list(map(mpq, row))
        for place, (exact, absolute) in enumerate(exact_functions(operation)):
            at = number, place
            error = abs(exactly(result.hi[at]) + exactly(result.lo[at]) - exact(*values))
            assert error <= exactly(result.radius[at])
            S = absolute(*map(abs, values))
            assert abs(exactly(result.terms[at]) - S) <= S / 2**50
            c2 = max(bounds(operation, PRECISIONS[0], "accurate")[place].c2, 1)
            if precision.name == "double":
                assert exactly(result.radius[at]) <= mpq(c2) * S / 2**106 / 1000


def nudged(way: Implementation, by: int) -> Implementation:
    """One result in a thousand is off by this many spacings."""

    def evaluate(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
        results, *rest = way(operation, precision, inputs)
        results = results.copy()
        results[::1000] += by * np.spacing(results[::1000])
        return results, *rest

    return evaluate


@each_precision
@pytest.mark.parametrize("tier, by", [("plain", 4), ("accurate", 1), ("certified", 8)])
def test_what_is_broken_does_not_pass(tier: str, by: int, precision: Precision):
    operation, way = BY_NAME["dot_cs"], WAYS[tier]
    right = attack_at_length(operation, precision, {tier: way}, 20_000, 3)[tier]
    wrong = attack_at_length(operation, precision, {tier: nudged(way, by)}, 20_000, 3)[tier]
    assert right.violations == 0 and right.worst.outputs >= 20_000
    assert wrong.violations > 0 and wrong.worst.ratio > 1 > right.worst.ratio > 0.5


@each_precision
def test_cases_are_judged_with_the_rest(precision: Precision):
    operation = BY_NAME["dot_vv"]
    case = np.array([[1, 2, 3, 4, 5, 6]], precision.numpy_type)

    def wrong_there(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
        result, = WAYS["plain"](operation, precision, inputs)
        return (result + (joined(inputs) == case).all(axis=1).astype(result.dtype),)

    result = attack_at_length(operation, precision, {"plain": wrong_there}, 100, 1, case)["plain"]
    assert result.violations == 1
    assert result.worst.witness == tuple(float(x).hex() for x in case[0])


def test_the_worst_is_exact():
    operation, precision = BY_NAME["cross_sc"], PRECISIONS[0]
    result = attack_at_length(operation, precision, WAYS, 30_000, 2)
    for tier, way in WAYS.items():
        row = np.array([[float.fromhex(x) for x in result[tier].worst.witness]])
        got = joined(way(operation, precision, split(operation, row)))[0].tolist()
        exact = ratio(operation, precision, tier, row[0].tolist(), got)
        assert result[tier].worst.ratio == exact > 0.8


def test_linear_in_one_input():
    """det is linear in each entry: p + q m is it; a square is not."""
    operation, draw = BY_NAME["mat3x3_determinant"], np.random.default_rng(0)
    given = draw.integers(-9, 9, (5, 9)).astype(float)
    for place in range(9):
        p, q = linear(plain_program(operation), 0, place, given)
        assert np.allclose((p + q * given[:, place]).astype(float),
                           np.linalg.det(given.reshape(5, 3, 3)), atol=1e-9)
    energy = BY_NAME["spatial_inertia_energy"]
    assert np.isnan(linear(plain_program(energy), 0, 10, np.ones((2, 16)))[1]).all()
