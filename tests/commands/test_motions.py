"""`simulate` and `check` pass right motions and refuse wrong ones: a sample of those that
`python -m tests.motions_attack` judges."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motions.errors import ALLOWED, FLOOR, Error, errors, judged
from tests.support.motions.families import FAMILIES, drawn
from tests.support.motions.reference import reference
from tests.support.motions.table import converged, judge
from tests.support.motions.verdicts import Setting

EXACT = ("servo_off_target", "spring_between", "stop_late", "stick_slip", "drag", "mimic",
         "two_appendages", "top", "far_and_free")


@pytest.mark.parametrize("family", EXACT)
def test_short_steps_converge_to_the_judge(family):
    """The judge and coscrew have the same equations."""
    worst = converged(drawn(family, 1))
    assert worst.q <= 1e-3 * ALLOWED.q and worst.v <= 1e-3 * ALLOWED.v, worst


def test_errors_are_judged_by_each_parts_own_amplitude():
    """A hundredth of a joint's swing more is between right and wrong; six hundredths are wrong; and
    what is smaller than a twentieth of the floor is rest."""
    motion = drawn("servos_of_an_arm", 2)
    run = judge(motion)
    true = reference(motion, run.runs.times(Setting(motion.steps[0], "rk4", "double")))
    swing = np.abs(true.q - true.q[:1]).max(0)
    for part in range(3):
        for off, verdict in ((0.005, "right"), (0.02, "between"), (0.06, "wrong")):
            q = true.q.copy()
            q[-1, part] += off * max(swing[part], FLOOR)
            found = errors(run.its, motion, true.q, true.v, true.q, true.v, q, true.v)
            assert judged(found) == verdict, (part, off, found)
    assert judged((Error("x", np.nan, 0.0),)) == "wrong"


def test_families_go_over_all_rates():
    motions = [drawn(family, number) for family in FAMILIES for number in range(12)]
    assert len({x.text(x.steps[0]) for x in motions}) >= 400
    turned = [x.rate * x.steps[0] for x in motions]
    assert min(turned) <= 0.05 and max(turned) >= 49.9
