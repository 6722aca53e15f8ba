"""`coscrew check` of bouncing bodies: correct motions pass, limits do the work of Hunt and
Crossley's law, and the remedies that messages name help."""

import math
from dataclasses import replace
from types import SimpleNamespace

import mpmath
import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.simulation.check.check import check
from coscrew_codegen.simulation.check.check_report import table
from coscrew_codegen.simulation.run_summary import RunOverrides
from tests.support.scenes.selecting import checked

BALL = """
[bodies]
b = {{ mass = 1 }}
[joints]
z = {{ type = "prismatic", child = "b", axis = [0, 0, 1], limits = {{ {limits} }} }}
[effects.gravity]
g = [0, 0, {g}]
[effects.limit]
joints = "all"
k = {k}
alpha = {alpha}
[start.q]
z = {z}
[start.v]
z = {v}
[run]
duration = {duration}
"""
FALL = {"limits": "lower = 0", "g": -9.81, "z": 1, "v": 0, "duration": 3}
FALLS = tuple({**FALL, **x} for x in (
    {"k": 1e6, "alpha": 0.045}, {"k": 1e6, "alpha": 0.045, "limits": "lower = 0, upper = 2"},
    {"k": 1e8, "alpha": 0.2}, {"k": 1e8, "alpha": 0}, {"k": 1e7, "alpha": 0.5, "z": 0.05}))


@pytest.fixture
def loaded(tmp_path):
    """Kernels of a ball."""
    def load(**values: object):
        path = tmp_path / "ball.toml"
        path.write_text(BALL.format(**values))
        return checked(path, None, "rk4")

    return load


@pytest.mark.parametrize("values", FALLS)
def test_a_right_bounce_is_right_and_its_balance_falls_with_the_step(loaded, values):
    findings = check(loaded(**values), RunOverrides(precision="double"))
    double, = findings.along
    assert findings.passed, table(findings)
    result = math.log2(double.coarse.relative / double.fine.relative)
    assert result == pytest.approx(2, abs=0.5) and f"of order {result:.1f}" in table(findings)


@pytest.mark.parametrize("step", (1e-3, 1e-4))
def test_a_right_bounce_is_right_in_single_precision(loaded, step):
    findings = check(loaded(**{**FALL, "k": 1e8, "alpha": 0.2, "duration": 0.6}),
                     RunOverrides(precision="single", step=step))
    assert findings.passed and "DOUBTFUL" not in table(findings), table(findings)


def outgoing(v: float, alpha: float) -> mpmath.mpf:
    """The speed e v after a bounce without gravity, by Hunt and Crossley's law: G(v) = G(-e v),
    G(v) = v/a - ln(1 + a v)/a², a = 1.5 alpha."""
    a = mpmath.mpf(3) / 2 * alpha

    def kept(x: mpmath.mpf) -> mpmath.mpf:
        return x / a - mpmath.log(1 + a * x) / a**2

    with mpmath.workdps(30):
        return mpmath.findroot(lambda x: kept(-x) - kept(v), (0, (1 - 1e-12) / a), solver="bisect")


def lost(v: float, alpha: float) -> float:
    """The energy that a ball of 1 kg loses in a bounce."""
    return float((mpmath.mpf(v)**2 - outgoing(v, alpha)**2) / 2)


@pytest.mark.parametrize("e, alpha_v", ((0.95, 0.053), (0.9, 0.111), (0.8, 0.249), (0.7, 0.423),
                                        (0.6, 0.650), (0.5, 0.955)))
def test_alpha_for_a_restitution_is_as_the_readme_says(e, alpha_v):
    assert float(outgoing(2, alpha_v / 2)) / 2 == pytest.approx(e, abs=5e-4)
    assert float(outgoing(2, (1 / e - 1) / 2)) / 2 == pytest.approx(e, abs=0.013)


@pytest.mark.parametrize("k, alpha", ((1e6, 0.045), (1e8, 0.2), (1e7, 0.5)))
@pytest.mark.parametrize("step", (1e-3, 1e-4))
def test_the_work_of_a_limit_is_what_the_law_takes(loaded, k, alpha, step):
    ball = loaded(**{**FALL, "g": 0, "v": -4.4, "k": k, "alpha": alpha, "duration": 0.5})
    balance = check(ball, RunOverrides(precision="double", step=step)).along[0].coarse
    assert balance.work == pytest.approx(-lost(4.4, alpha), rel=1e-3)
    assert balance.after - balance.before == pytest.approx(-lost(4.4, alpha), rel=2e-3)


def test_a_limit_whose_power_is_wrong_is_found(loaded):
    kernels = loaded(**{**FALL, "k": 1e8, "alpha": 0.2, "duration": 0.6})
    own = {name: getattr(kernels.double, name) for name in kernels.double}
    wrong = SimpleNamespace(**{**own, "power": lambda *x: 1.01 * own["power"](*x)})
    findings = check(replace(kernels, double=wrong), RunOverrides(precision="double"))
    assert not findings.passed
    assert "neither half the step nor 1/8 of it helps" in table(findings)


@pytest.mark.parametrize("values, requested", (
    ({"k": 1e6, "alpha": 0.045, "duration": 1}, {"step": 5e-3, "integrator": "rk4"}),
    ({"k": 1e7, "alpha": 0.2, "duration": 1}, {"step": 2e-3, "integrator": "rk4"})))
def test_what_is_said_to_help_helps(loaded, values, requested):
    kernels = loaded(**{**FALL, **values})
    findings = check(kernels, RunOverrides(precision="double", **requested))
    assert not findings.passed
    findings_in_words = table(findings)
    again = {**requested, "step": float(findings_in_words.split("take a step of ")[1].split()[0])}
    assert check(kernels, RunOverrides(precision="double", **again)).passed


@pytest.mark.parametrize("k, integrator, out", (
    (1e6, "linear-implicit-euler", True), (10, "linear-implicit-euler", False),
    (1e6, "leapfrog", False)))
def test_lost_bounces_are_told(tmp_path, capsys, k, integrator, out):
    path = tmp_path / "ball.toml"
    path.write_text(BALL.format(**{**FALL, "k": k, "alpha": 0.045, "duration": 1}))
    assert main(["simulate", str(path), "--integrator", integrator]) == int(out)  # a wrong motion
    text = f"coscrew: limits close, and {integrator} does not resolve bounces"
    assert (text in capsys.readouterr().err) == out
