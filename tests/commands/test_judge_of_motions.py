"""The judge of motions reads all advice, computes stale references again, and reports errors."""

import ast
import inspect
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from coscrew_codegen.program.values.formats import BY_NAME, DOUBLE
from coscrew_codegen.simulation.check import step_advice
from coscrew_codegen.simulation.check.windows import remedy_of_rounding
from coscrew_codegen.simulation.plan import Plan
from tests.support.motions import reference
from tests.support.motions.dynamics import Dynamics
from tests.support.motions.errors import ALLOWED, Error, judged
from tests.support.motions.families import drawn
from tests.support.motions.mechanism import Acting, Body, Joint, Mechanism, Mimic
from tests.support.motions.reference import Unjudged
from tests.support.motions.table import Judge, exceptions
from tests.support.motions.verdicts import Said, Setting, advised

RK4, IN_SINGLE = Setting(0.1, "rk4", "double"), Setting(0.1, "leapfrog", "single")
SINGLE_RK4 = Setting(0.1, "rk4", "single")
ADAPTIVE = Setting(0.1, "dop853", "double", (1.6e-4, 3.2e-5))
TRIED: tuple[tuple[Setting, tuple[Setting, ...]], ...] = (
    (RK4, ()),
    (RK4, (replace(RK4, step=0.025),)),
    (RK4, (replace(RK4, step=3.9e-4),)),
    (RK4, (replace(RK4, integrator="leapfrog"),)),
    (RK4, (replace(RK4, step=0.025), replace(RK4, integrator="leapfrog"))),
    (IN_SINGLE, (replace(IN_SINGLE, step=0.05),)),
    (IN_SINGLE, (replace(IN_SINGLE, precision="double"),)),
    (IN_SINGLE, (replace(IN_SINGLE, precision="double", step=0.0125),)),
    (SINGLE_RK4, (Setting(0.1, "leapfrog", "double"),)),
    (SINGLE_RK4, (Setting(0.05, "rk4", "double"), Setting(0.1, "leapfrog", "double"))),
    (ADAPTIVE, ()),
    (ADAPTIVE, (replace(ADAPTIVE, tolerances=(1e-5, 2e-6)),)),
    (ADAPTIVE, (replace(ADAPTIVE, tolerances=(6.25e-7, 1.25e-7)),)),
    (ADAPTIVE, (Setting(0.1, "leapfrog", "double"),)))
"""Runs, and all settings that do instead of theirs."""


def advised_by(how: Setting, right: tuple[Setting, ...], monkeypatch: pytest.MonkeyPatch,
               stops: bool = False) -> str:
    """The advice for a run if these settings alone are right, and the reference `stops` or not."""
    def does(system: SimpleNamespace, planned: Plan, *_: object) -> bool:
        tolerances = (planned.rtol, planned.atol) if planned.adaptive else None
        tried = Setting(step_advice._shortened(planned.step), planned.integrator,
                        system.precision.name, tolerances)
        return tried in right

    rtol, atol = how.tolerances or (0.0, 0.0)
    planned = Plan(10.0, how.step, how.integrator, how.step, rtol, atol)
    monkeypatch.setattr(step_advice, "_right", does)
    monkeypatch.setattr(step_advice, "affordable", lambda *_: True)
    monkeypatch.setattr(step_advice, "in_double", lambda _: SimpleNamespace(precision=DOUBLE))
    known = SimpleNamespace(stops=stops, step=1e-3)
    return step_advice.advised(SimpleNamespace(precision=BY_NAME[how.precision]), planned, known)


@pytest.mark.parametrize("how, right", TRIED)
def test_advice_is_read_as_it_was_tried(how, right, monkeypatch):
    words = advised_by(how, right, monkeypatch)
    assert advised(words, how) == right, words
    assert advised(f"a table\n\nFALSE: single: off, allowed is 1: why; {words}", how) == right


def test_every_form_of_advice_is_read(monkeypatch):
    """The cases above contain every form of `advice`, except for advice without a name."""
    all_of_them = " | ".join([*(advised_by(*case, monkeypatch) for case in TRIED),
                              advised_by(RK4, (), monkeypatch, stops=True)])
    statements = [x for of in (step_advice.advised, step_advice._helping)
                  for x in ast.parse(inspect.getsource(of)).body[0].body[1:]]
    formats = {id(x) for s in statements for y in ast.walk(s) if isinstance(y, ast.FormattedValue)
               for x in ast.walk(y)}
    words = {x.value for s in statements for x in ast.walk(s) if isinstance(x, ast.Constant)
             and isinstance(x.value, str) and id(x) not in formats}
    assert len(words) > 8
    assert {x for x in words if x not in all_of_them} == {
        "smaller steps were not tried, since they would take long"}


@pytest.mark.parametrize("words, settings", (
    ("the step is too large at t = 1 s: joint a is off by 2 of the way it moves; take a smaller "
     "step", ()),
    ("smaller steps were not tried, since they would take long", ()),
    (f"rounding freezes joint a; {remedy_of_rounding(SimpleNamespace(precision=None))}",
     (replace(IN_SINGLE, precision="double"),)),
    (f"rounding freezes joint a; {remedy_of_rounding(SimpleNamespace(precision=DOUBLE))}", ())))
def test_other_remedies_are_read(words, settings):
    assert advised(words, IN_SINGLE) == settings


def test_advice_of_an_unknown_form_is_an_error():
    with pytest.raises(ValueError, match="of no known form: take a longer step"):
        advised("off; take a step of 0.1 s, or a longer step", RK4)


@pytest.mark.parametrize("how", (RK4, ADAPTIVE))
def test_a_scene_file_has_the_setting(how):
    lines = drawn("spring", 1).text(how.step, how.integrator, how.precision,
                                    how.tolerances).splitlines()
    assert {f'integrator = "{how.integrator}"', f"step = {how.step!r}"} <= {*lines}
    assert [x for x in lines if "tol = " in x] == (
        ["rtol = 0.00016", "atol = 3.2e-05"] if how.tolerances else [])


def imported(path: Path, results: set[Path]) -> set[str]:
    """The packages that a module needs; puts it, and those beside it that it needs, into `found`.
    """
    results.add(path)
    packages = set()
    for x in ast.walk(ast.parse(path.read_text())):
        if isinstance(x, ast.Import):
            packages |= {y.name.partition(".")[0] for y in x.names}
        elif isinstance(x, ast.ImportFrom) and x.module.startswith("tests.support.motions"):
            near = x.module.split(".")[3:] or [y.name for y in x.names]
            for other in {path.with_name(f"{name}.py") for name in near} - results:
                packages |= imported(other, results)
        elif isinstance(x, ast.ImportFrom):
            packages.add(x.module.partition(".")[0])
    return packages - sys.stdlib_module_names


def test_references_depend_on_all_that_computes_them():
    modules: set[Path] = set()
    packages = imported(Path(reference.__file__), modules)
    assert {Path(x.__file__) for x in reference.SOURCES} == modules
    assert {x.__name__ for x in reference.PACKAGES} == packages


@pytest.mark.parametrize("place", (*reference.SOURCES, *reference.PACKAGES),
                         ids=lambda x: x.__name__)
def test_a_reference_of_another_version_is_not_used(place, monkeypatch, tmp_path):
    motion, times = drawn("spring", 1), np.linspace(0, 1, 5)
    before = reference._key(motion, times)
    assert reference._key(drawn("spring", 1), times.copy()) == before
    assert reference._key(motion, 2 * times) != before != reference._key(drawn("top", 1), times)
    if place in reference.PACKAGES:
        monkeypatch.setattr(place, "__version__", "0.1")
    else:
        changed = tmp_path / "changed.py"
        changed.write_text(Path(place.__file__).read_text().replace("0", "1", 1))
        monkeypatch.setattr(place, "__file__", str(changed))
    assert reference._key(motion, times) != before


def test_errors_are_judged_by_what_is_allowed():
    assert Error("x", ALLOWED.q, ALLOWED.v / 2).of_allowed == 1
    assert Error("x", ALLOWED.q / 2, 2 * ALLOWED.v).of_allowed == 2
    assert judged((Error("x", 0.0, np.nan),)) == "between"


class Runs:
    """Runs that the commands refuse by an exception."""

    def __init__(self, says: dict[float, Said]) -> None:
        self.says = says

    def verdicts(self, how: Setting) -> Said:
        if how.step not in self.says:
            raise ZeroDivisionError("in a command")
        return self.says[how.step]


class Judged(Judge):
    """A judge who has no reference for any run."""

    def truth(self, how: Setting) -> tuple[str, Error]:
        raise Unjudged("takes too long")


def test_an_error_is_a_finding_though_the_motion_is_unjudged():
    motion = drawn("spring", 1)
    row = Judged(motion, Runs({}), Dynamics(motion.mechanism)).row(RK4, follow=True)
    assert row.false == ("an error was raised",) and "ZeroDivisionError: in a comm" in row.reason
    row = Judged(motion, Runs({0.1: Said("", True, True, "")}), None).row(RK4, follow=True)
    assert (row.false, row.truth, row.reason) == ((), "unjudged", " takes too long")


@pytest.mark.parametrize("then, says, false", (
    (replace(RK4, step=0.025), dict.fromkeys((0.025, 2.1 * 0.025), Said("", True, True, "")),
     ": twice this step passes, too"),
    (replace(RK4, step=0.025), {}, " raises ZeroDivisionError: in a command"),
    (replace(RK4, step=0.025), {0.025: Said("stopped", True, True, "")}, " does not pass"),
    (replace(RK4, step=0.025), {0.025: Said("", False, False, "")}, " does not pass"),
    (ADAPTIVE, {0.1: Said("", False, False, "")}, " does not pass")))
def test_advice_that_does_not_do_is_a_finding(then, says, false):
    motion = drawn("spring", 1)
    judge = Judged(motion, Runs({2.1 * 0.025: Said("stops", False, False, "")} | says), None)
    (result,) = judge._follow(RK4, then)
    assert result == then.words + false
    row = Judge(motion, Runs({}), None).row(RK4, follow=False)
    kind = exceptions([replace(row, verdicts=Said("", True, True, ""), advice=(result,))])
    assert f"advice: {false.lstrip(': ')}" in kind


def test_bodies_are_pushed_with_followers():
    """A follower on its leader moves k times as far along the same rail, beyond it: with a force F
    on it, M = m + (1 + k)² n, so that its leader's acceleration is (1 + k) F / M."""
    m, n, k, force = 2.0, 3.0, -0.25, 5.0
    bodies = tuple(Body(name, mass, (1.0, 1.0, 1.0)) for name, mass in (("a", m), ("b", n)))
    joints = (Joint("lead", "prismatic", "a", axis=(1.0, 0.0, 0.0)),
              Joint("follow", "prismatic", "b", "a", (1.0, 0.0, 0.0), mimic=Mimic("lead", k)))
    for pushed, share in (("a", 1.0), ("b", 1 + k)):
        its = Dynamics(Mechanism(bodies, joints, (
            Acting("mimic", ""), Acting("wrench", pushed, {"force": (force, 0.0, 0.0)}))))
        result = its.accelerations(0.0, np.zeros(2), np.zeros(2))
        wanted = share * force / (m + (1 + k)**2 * n)
        assert result == pytest.approx([wanted, k * wanted], rel=1e-14)
