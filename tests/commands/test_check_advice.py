"""The step that a message names is enough, in the precision that it names, and hardly too small."""

import re
from pathlib import Path

import pytest

from coscrew_codegen.simulation.check import step_advice
from coscrew_codegen.simulation.check.check import check
from coscrew_codegen.simulation.check.check_report import table
from coscrew_codegen.simulation.check.findings import AlongRun
from coscrew_codegen.simulation.run_summary import RunOverrides
from tests.support.scenes.selecting import checked
from tests.support.scenes.simulated import outcome

SPRING = """
[bodies]
b = {{ mass = 1 }}
[joints]
j = {{ type = "prismatic", child = "b", axis = [0, 0, 1] }}
[effects.spring.j]
k = {k}
q0 = {rest}
[start.q]
j = {start}
[run]
duration = {duration}
step = 0.1
[outputs]
every = 0.1
"""
NEAR = {"k": 1, "rest": 10, "start": 11, "duration": 5}
FAR = {"k": 1, "rest": 1000, "start": 1000.1, "duration": 20}  # q is rounded to 3e-4 of its swing
EULER, DEFAULT = "semi-implicit-euler", "leapfrog"


@pytest.fixture
def tried(tmp_path: Path):
    """The check of a spring: its results, and its last paragraph."""
    def tried(values: dict[str, float], integrator: str, precision: str,
              step: float | None = None) -> tuple[AlongRun, str]:
        path = tmp_path / "spring.toml"
        path.write_text(SPRING.format(**values))
        findings = check(checked(path, integrator),
                         RunOverrides(None, step, integrator, precision))
        return findings.along[-1], table(findings).rpartition("\n\n")[2]

    return tried


def step_of(message: str) -> float:
    return float(re.search(r"take a step of (\S+) s", message)[1])


@pytest.mark.parametrize("precision", ("double", "single"))
def test_an_advised_step_passes_and_four_times_as_much_does_not(tried, precision):
    along, message = tried(NEAR, EULER, precision)
    assert not along.passed and "the step is too large" in message and "--precision" not in message
    assert tried(NEAR, EULER, precision, step_of(message))[0].passed
    assert not tried(NEAR, EULER, precision, min(0.1, 4 * step_of(message)))[0].passed


def test_another_integrator_is_named_where_it_does_with_the_same_step(tried):
    _, text = tried(NEAR, EULER, "double")
    assert text.endswith(f", or integrator {DEFAULT}") and tried(NEAR, DEFAULT, "double")[0].passed
    rough = {**NEAR, "k": 100}
    _, text = tried(rough, EULER, "double")
    assert DEFAULT not in text and not tried(rough, DEFAULT, "double")[0].passed


def test_simulate_names_a_step_with_which_it_goes_on(tmp_path, capsys):
    text, path = SPRING.format(**{**NEAR, "k": 100}), tmp_path / "spring.toml"
    status, message = outcome(path, capsys, "simulate", text)
    assert status == 1 and "joint j is off by" in message
    for command in ("simulate", "check"):
        assert outcome(path, capsys, command, text, "--step", f"{step_of(message):g}",
                       "--precision", "double")[0] == 0


@pytest.mark.parametrize("precision", ("single", "both"))
def test_double_precision_is_advised_where_no_step_helps_in_single(tried, precision, monkeypatch):
    """Small steps do not move a q that is rounded so coarsely."""
    monkeypatch.setattr(step_advice, "HALVINGS", 6)
    values = {**FAR, "rest": 1e6, "start": 1e6 + 0.125}
    along, message = tried(values, DEFAULT, precision)
    assert along.precision == "single" and not along.passed
    assert message.endswith("take --precision double")
    assert tried(values, DEFAULT, "double")[0].passed


def test_what_takes_long_is_not_tried_and_no_step_is_named(tried, monkeypatch):
    monkeypatch.setattr(step_advice, "MOST", 60)
    along, text = tried({**NEAR, "k": 100}, DEFAULT, "double")
    assert not along.passed and "smaller steps were not tried, since they would take long" in text


def test_a_step_that_is_much_shorter_is_judged_to_the_end_by_its_own_reference(tmp_path, capsys):
    """A servo without damping, h ω = 70: motions at 1/64 and 1/512 of the step differ early."""
    path, text = tmp_path / "stiff.toml", """
[bodies]
bob = { mass = 2, com = [0, 0, -0.5], inertia = [0.1, 0.1, 0.1] }
[joints]
pin = { type = "continuous", child = "bob", axis = [0, 1, 0] }
[effects.gravity]
[effects.actuator.pin]
kind = "pd"
kp = 3e6
target = 0.5
[run]
duration = 0.1
"""
    status, message = outcome(path, capsys, "simulate", text, "--precision", "double")
    assert status == 1
    for command in ("simulate", "check"):
        assert outcome(path, capsys, command, text, "--precision", "double", "--step",
                       f"{step_of(message):g}")[0] == 0


def test_a_run_that_is_not_finite_names_what_was_tried(tmp_path, capsys):
    """h ω is 10; and the root of a number that becomes negative, against which no step helps."""
    path = tmp_path / "spring.toml"
    text = SPRING.format(**{**NEAR, "k": 1e4, "rest": 0, "start": 0.1, "duration": 20})
    words = "--integrator", "rk4", "--precision", "double"
    status, out = outcome(path, capsys, "simulate", text, *words)
    assert status == 1 and ("not finite" in out or "too large" in out)
    assert outcome(path, capsys, "simulate", text, *words, "--step", f"{step_of(out):g}")[0] == 0
    root = text + '[effects.actuator.j]\nkind = "torque"\ntorque = "sqrt(0.5-t)"\n'
    status, out = outcome(path, capsys, "simulate", root.replace("k = 10000", "k = 1"), *words,
                          "--until", "2")
    assert status == 1 and "joint j: q is nan; so are motions with steps down to" in out


@pytest.mark.parametrize("integrator", ("dop853", "radau"))
def test_too_large_tolerances_are_told_and_smaller_ones_tried(tmp_path, capsys, integrator):
    path, text = tmp_path / "spring.toml", SPRING.format(**{**NEAR, "k": 1e4}).replace(
        "step = 0.1", f'integrator = "{integrator}"\nrtol = RTOL\natol = ATOL')
    loose = text.replace("RTOL", "0.1").replace("ATOL", "0.1")
    status, out = outcome(path, capsys, "simulate", loose, "--precision", "double")
    rtol, atol = re.search(r"too large at t = .*take rtol = (\S+) and atol = (\S+);", out).groups()
    assert status == 1
    tight = text.replace("RTOL", rtol).replace("ATOL", atol)
    assert outcome(path, capsys, "simulate", tight, "--precision", "double")[0] == 0


@pytest.mark.parametrize("eps", ("1e-6", "1e-4"))
def test_what_friction_holds_balances(tmp_path, capsys, eps):
    """It creeps by less than a micrometre, so that energies say nothing."""
    text = SPRING.format(**NEAR).replace("rest = 10", "").replace("q0 = 10", "").replace(
        "j = 11", "j = 0").replace("step = 0.1", "step = 1e-3") + f"""
[effects.actuator.j]
kind = "pd"
kp = 100
target = "0.01*sin(6*t)"
[effects.coulomb.j]
tau_c = 2
eps = {eps}
"""
    status, out = outcome(tmp_path / "held.toml", capsys, "check", text, "--precision", "double",
                          "--until", "1")
    assert status == 0 and "none: nothing moves" in out, out
