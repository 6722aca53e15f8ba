"""Instructions on cores are estimated within a tenth of the counts, all except one, also on a
robot to whose counts the estimates were not fitted."""

from coscrew_codegen.reports.cost.needs import core_estimates
from tests.benchmarks import core_counts


def test_estimates_are_fitted_to_the_committed_counts():
    counts = core_counts.calibration()
    assert len(counts) == 150
    assert core_counts.fitted(counts) == core_estimates.INSTRUCTIONS
    assert max(abs(core_counts.error(x, core_estimates.INSTRUCTIONS)) for x in counts) < 0.1


def test_estimates_of_another_robot():
    """In every number format, on a Cortex-M0+ and M3."""
    counts = [x for x in core_counts.committed() if x.robot == core_counts.OTHER]
    assert {x.kind for x in counts} == {"double", "single", "fixed, full", "fixed, high"}
    assert {x.tier for x in counts} == {"plain", "accurate", "certified", "pairs", "fixed"}
    errors = [core_counts.error(x, core_estimates.INSTRUCTIONS) for x in counts]
    assert len(errors) == 50 and max(map(abs, errors)) < 0.12, errors
    assert sum(abs(x) > 0.1 for x in errors) <= 1, errors  # the mass matrix in fixed point
