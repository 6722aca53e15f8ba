"""The documentation's table of errors holds the proved ones and the largest committed cases."""

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.backends.c.c_elementary import written
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS, Elementary
from coscrew_codegen.program.elementary.evaluation.double_words import power_of_two
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.program.whole_cost import whole_cost
from tests.hard_cases.corpus import TABLE
from tests.support.truth.attack import plain_program
from tests.support.truth.elementary import errors, results, worst_cases

_GUIDE = Path(__file__).parents[2] / "docs" / "accuracy.md"


def largest(function: Elementary, precision: Precision) -> dict[str, float]:
    """By the names of the results, the largest error of a committed case that is not subnormal."""
    given = worst_cases(function.name, precision)
    names = ("sin", "cos") if function.name == "sincos" else (function.name,)
    values = {}
    for name, got in zip(names, results(function, precision, *given), strict=True):
        normal = np.abs(got) >= np.finfo(got.dtype).tiny
        values[name] = errors(name, precision, got[normal], *(x[normal] for x in given)).max()
    return values


@pytest.mark.parametrize("function", ELEMENTARY, ids=lambda x: x.name)
def test_rows_are_true(function):
    results = {p.name: largest(function, p) for p in (DOUBLE, SINGLE)}
    for name in results["double"]:
        numbers = (x for p in (DOUBLE, SINGLE)
                   for x in (float(function.error(p)), results[p.name][name]))
        row = f"| `{name}` | {' | '.join(f'{x:.3f}' for x in numbers)} |"
        assert row in _GUIDE.read_text().splitlines(), row


@pytest.mark.parametrize("function", ELEMENTARY, ids=lambda x: x.name)
@pytest.mark.parametrize("precision", (DOUBLE, SINGLE), ids=lambda x: x.name)
def test_costs_are_those_of_the_operation(function: Elementary, precision: Precision):
    """The kernel's comment and the reference count the same operations: reductions take part."""
    kernel, = written(precision, [function.name])
    cost = whole_cost(plain_program(TABLE[function.name]), precision)
    assert f"   {cost.capitalize()}" in kernel.comment


@pytest.mark.parametrize("function", ERRORS, ids=lambda x: x.name)
def test_errors_of_errors_are_true(function):
    proved = [function.error(p) for p in (DOUBLE, SINGLE)]
    row = f"| `ksl_{function.name}` | {' | '.join(map(power_of_two, proved))} |"
    assert row in _GUIDE.read_text().splitlines(), row
    assert proved[0] <= Fraction(1, 2**100)
