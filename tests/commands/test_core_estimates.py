"""Instructions on cores are estimated within a tenth of all counts; below a size nothing is stated.
"""

import numpy as np
import pytest

from coscrew_codegen.program.elementary.sincos import FUNCTION as SINCOS
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE
from coscrew_codegen.reports.cost.needs import core_estimates
from coscrew_codegen.reports.cost.needs.core_costs import CORES
from coscrew_codegen.reports.cost.needs.core_estimates import LEAST, Operations
from coscrew_codegen.reports.cost.needs.operations_at import counts_at
from tests.benchmarks import core_counts


def test_every_count_is_met_within_a_tenth():
    """In every number format, on every core, of arms and of pendulums."""
    counts = core_counts.committed()
    assert len(counts) == 888 and {x.robot for x in counts} == set(core_counts.ROBOTS)
    assert {x.core for x in counts} == set(CORES)
    assert {x.words for x in counts} == {
        "double", "single", "double accurate", "single accurate", "double certified",
        "single certified", "single pairs", "fixed", "fixed (high)"}
    errors = [core_counts.error(x, core_estimates.INSTRUCTIONS) for x in counts]
    assert max(map(abs, errors)) < 0.095
    assert all(abs(x.operations.on(x.core) / x.count - 1) < 0.1 for x in counts if x.count > 250)


def test_no_other_numbers_meet_the_counts_better():
    counts = core_counts.committed()
    for key, numbers in core_counts.fitted(counts).items():
        rows = [x for x in counts if (x.core, x.format) == key]
        table = {**core_estimates.INSTRUCTIONS, key: numbers}
        best, ours = (max(abs(core_counts.error(x, y)) for x in rows)
                      for y in (table, core_estimates.INSTRUCTIONS))
        assert ours == pytest.approx(best, rel=0.02), key


def test_a_robot_that_is_left_out_is_met_within_a_ninth():
    counts = core_counts.committed()
    table = core_counts.fitted([x for x in counts if x.robot != "ur5"])
    errors = [core_counts.error(x, table) for x in counts if x.robot == "ur5"]
    assert len(errors) == 162 and max(map(abs, errors)) < 0.107


def test_few_instructions_are_not_estimated():
    some = Operations("double", {"call": 1, "product": 1})
    assert some.on("Cortex-M0+") is not None
    assert Operations("fixed, high", {"call": 1, "high product": 2}).on("Cortex-M4F") is None
    assert Operations("fixed, high", {"call": 1, "sine and cosine": 4}).on("Cortex-M4F") >= LEAST


@pytest.mark.parametrize("precision", (DOUBLE, SINGLE), ids=lambda x: x.name)
def test_operations_are_counted_at_a_state(precision):
    """A small angle's sine multiplies by quadrants that are zero."""
    reduce, kernel = SINCOS.near(precision), SINCOS.kernel(precision)
    for angle in (0.3, 2.0):
        first, reduced = counts_at(reduce, precision, [[angle]])
        second, results = counts_at(kernel, precision, [[x] for x in reduced])
        assert np.allclose(results, (np.sin(angle), np.cos(angle)), atol=2**-22)
        counts = first + second
        assert (counts["product with zero"] > 3) == (angle == 0.3)
        operations = [*reduce.instructions, *kernel.instructions]
        named = sum(counts[x] for x in counts if x.startswith(("product", "sum", "move")))
        assert named == len(operations)
