"""`simulate` and `check` pass right motions and refuse wrong ones: a sample of the motions in
`python -m tests.motions_attack`."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motions.errors import ALLOWED, FLOOR, Error, errors, judged
from tests.support.motions.families import FAMILIES, drawn
from tests.support.motions.reference import reference
from tests.support.motions.table import converged, judge
from tests.support.motions.verdicts import Setting, advised

EXACT = ("servo_off_target", "spring_between", "stop_late", "stick_slip", "drag", "mimic",
         "two_appendages", "top", "far_and_free")


@pytest.mark.parametrize("family", EXACT)
def test_short_steps_converge_to_the_judge(family):
    """The judge and coscrew have the same equations."""
    worst = converged(drawn(family, 1))
    assert worst.q <= 1e-3 * ALLOWED.q and worst.v <= 1e-3 * ALLOWED.v, worst


def test_errors_are_itsby_each_parts_own_amplitude():
    """A hundredth of a joint's swing more is between right and wrong; six hundredths are wrong; and
    motion below a twentieth of the floor is rest."""
    motion = drawn("servos_of_an_arm", 2)
    run = judge(motion)
    true = reference(motion, run.runs.times(Setting(motion.steps[0], "rk4", "double")))
    swing = np.abs(true.q - true.q[:1]).max(0)
    for part in range(3):
        for off, verdict in ((0.005, "right"), (0.02, "between"), (0.06, "wrong")):
            q = true.q.copy()
            q[-1, part] += off * max(swing[part], FLOOR)
            result = errors(run.its, motion, true.q, true.v, true.q, true.v, q, true.v)
            assert judged(result) == verdict, (part, off, result)
    assert judged((Error("x", np.nan, 0.0),)) == "wrong"


def test_families_go_over_all_rates():
    motions = [drawn(family, number) for family in FAMILIES for number in range(12)]
    assert len({x.text(x.steps[0]) for x in motions}) >= 400
    turned = [x.rate * x.steps[0] for x in motions]
    assert min(turned) <= 0.05 and max(turned) >= 49.9


SAMPLE = (
    ("servo_at_rest", 11, "leapfrog", "double", "right"),
    ("servo_off_target", 2, "leapfrog", "double", "right"),
    ("servo_off_target", 8, "leapfrog", "double", "wrong"),
    ("servo_tracking", 3, "leapfrog", "double", "right"),
    ("heavy_carries_light", 6, "leapfrog", "double", "wrong"),
    ("mimic", 4, "semi-implicit-euler", "double", "wrong"),
    ("over_at_the_start", 2, "rk4", "double", "right"),
    ("over_at_the_start", 7, "leapfrog", "double", "wrong"),
    ("spring", 1, "rk4", "double", "right"),
    ("spring", 8, "linear-implicit-euler", "double", "wrong"),
    ("bounce", 6, "leapfrog", "double", "right"),
    ("stop_late", 3, "leapfrog", "double", "right"),
    ("lying_on_its_end", 8, "leapfrog", "double", "right"),
    ("coulomb", 4, "leapfrog", "double", "right"),
    ("stick_slip", 9, "rk4", "double", "right"),
    ("drag", 7, "leapfrog", "double", "wrong"),
    ("appendage", 6, "leapfrog", "double", "wrong"),
    ("appendage", 7, "leapfrog", "double", "wrong"),
)


@pytest.mark.parametrize("family, number, integrator, precision, truth", SAMPLE)
def test_right_motions_pass_and_wrong_ones_are_refused(family, number, integrator, precision,
                                                       truth):
    motion = drawn(family, number)
    row = judge(motion).row(Setting(motion.steps[0], integrator, precision), follow=False)
    assert row.truth == truth and not row.false, row.words


def test_advised_tolerances_do():
    motion = drawn("spring", 1)
    its = judge(motion)
    how = Setting(motion.steps[0], "dop853", "double", (1e-2, 1e-2))
    message = its.runs.verdicts(how)
    assert advised(message.text, how) == (replace(how, tolerances=(6.25e-4, 6.25e-4)),)
    assert not [*its.followed(how, message)] and its.truth(how)[0] == "wrong"


@pytest.mark.parametrize("number", (2, 6, 8))
def test_speed_attitude_and_neighbours_change_no_verdict(number):
    """A base's link moves alike however its base travels, is turned, or what flies beside it."""
    first, beside = drawn("appendage", number), drawn("appendage_and_neighbour", number)
    results = set()
    for motion in (first, beside):
        for speed, attitude in ((0.0, (0.0, 0.0, 0.0, 1.0)), (300.0, (0.5, -0.5, 0.1, 0.7))):
            run = replace(
                motion, mechanism=replace(motion.mechanism, acting=first.mechanism.acting),
                duration=first.duration, q={**motion.q, "hinge": first.q["hinge"],
                                            "root": (0.0, 0.0, 0.0, *attitude)},
                v={**motion.v, "root": (speed, 0.0, 0.0, 0.0, 0.0, 0.0)})
            row = judge(run).row(Setting(1e-3, "leapfrog", "double"), follow=False)
            its = row.verdicts
            assert its
            results.add((row.truth, bool(its.stopped), its.passed, its.strictly))
    assert len(results) == 1, results
