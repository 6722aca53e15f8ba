"""coscrew check passes correct runs and fails wrong ones."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.runtime import lanes
from coscrew_codegen.scene.scene import Expectation
from coscrew_codegen.simulation.check.check import check
from coscrew_codegen.simulation.check.check_report import table
from coscrew_codegen.simulation.check.findings import Met
from coscrew_codegen.simulation.run_summary import RunOverrides
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.selecting import checked
from tests.support.scenes.simulated import outcome


def expecting(text: str, **expected: str) -> str:
    lines = [f'"{name}" = {{ {value} }}' for name, value in expected.items()]
    return "\n".join((text, "[expect]", *lines))


@pytest.fixture(scope="module")
def loaded(tmp_path_factory):
    """Kernels of a scene's text."""
    folder = tmp_path_factory.mktemp("check")

    def load(text: str):
        path = folder / f"scene{len(list(folder.iterdir()))}.toml"
        path.write_text(text)
        return checked(path, "semi-implicit-euler", "rk4")

    return load


@pytest.fixture(scope="module")
def spring(loaded):
    """The findings for the spring."""
    return check(loaded(texts.SPRING), RunOverrides())


Q, V = (float(x) for x in texts.spring(1.2345))
RIGHT = expecting(texts.SPRING, **{
    "q.slide": f"at = 1.2345, value = {Q!r}, rtol = 1e-8",
    "v.slide": f"at = 1.2345, value = {V!r}, rtol = 1e-8",
    "energy": f"at = 0, value = {texts.STIFFNESS * 0.005!r}, rtol = 1e-12",
    "power": f"at = 1.2345, value = {-texts.DAMPING * V**2!r}, rtol = 1e-8"})


def test_what_is_expected_rightly_is_met(tmp_path, capsys):
    path = tmp_path / "scene.toml"
    path.write_text(RIGHT)
    assert main(["check", str(path)]) == 0
    out = capsys.readouterr().out
    assert out.count("pass  ") == 4
    assert "FAIL" not in out


@pytest.mark.parametrize("right, wrong", ((repr(Q), repr(Q * (1 + 1e-7))), (repr(V), repr(-V))))
def test_what_is_expected_wrongly_is_not(tmp_path, capsys, right, wrong):
    path = tmp_path / "scene.toml"
    path.write_text(RIGHT.replace(f"value = {right}", f"value = {wrong}"))
    assert main(["check", str(path)]) == 1
    out = capsys.readouterr().out
    assert (out.count("pass  "), out.count("FAIL  ")) == (3, 1)


def test_what_a_run_does_not_reach_is_not_met(loaded):
    findings = check(loaded(RIGHT), RunOverrides(until=1.0))
    assert [math.isnan(x.came) for x in findings.met] == [True, True, False, True]
    assert not findings.passed


def test_a_run_that_stops_does_not_pass(loaded):
    findings = check(loaded(texts.UNSTABLE), RunOverrides())
    assert not findings.passed
    message = table(findings)
    assert "double: not finite at t = 0.117 s: joint slide: q is -inf; " in message
    assert "single: not finite at t = 0.013 s: joint slide: q is -inf; " in message


@pytest.mark.parametrize("apart, passed", ((0.0, True), (0.2099, True), (0.2101, False),
                                           (math.nan, False)))
def test_expectations_allow_their_tolerances(apart, passed):
    assert Met(Expectation("q.a", 1.0, -2.0, 0.1, 0.01), -2.0 + apart, "rad").passed == passed


@pytest.mark.parametrize("integrator, order", (("semi-implicit-euler", 1), ("rk4", 4)))
def test_a_defect_of_energy_has_the_integrators_order(loaded, integrator, order):
    """The largest E - E(0) + ∫ d v² dt of a damped spring falls with the step, by the method's
    order."""
    findings = check(loaded(texts.SPRING), RunOverrides(integrator=integrator, step=1e-2))
    double = findings.along[0]
    result = math.log2(double.coarse.relative / double.fine.relative)
    assert result == pytest.approx(order, abs=0.3)
    assert f"of order {result:.1f}" in table(findings)


def test_the_work_of_damping_is_the_energy_lost(spring):
    for along, error in zip(spring.along, (1e-10, 1e-5), strict=True):
        q, v = (float(x) for x in texts.spring(2))
        lost = texts.STIFFNESS * (q**2 - 0.1**2) / 2 + texts.MASS * v**2 / 2
        assert along.coarse.work == pytest.approx(lost, abs=error)
        assert along.coarse.after - along.coarse.before == pytest.approx(lost, abs=error)


def test_power_that_does_not_account_for_the_loss_is_found(loaded, spring):
    """An effect's power that is wrong by 1 % is an error that smaller steps do not reduce."""
    kernels = loaded(texts.SPRING)

    def wrong(functions):
        own = {name: getattr(functions, name) for name in functions}
        return SimpleNamespace(**{**own, "power": lambda *x: 1.01 * own["power"](*x)})

    broken = replace(kernels, double=wrong(kernels.double), single=wrong(kernels.single))
    text = table(check(broken, RunOverrides()))
    assert text.count("DOUBTFUL: smaller steps do not help") == 2
    assert "largest error of energy" in text
    assert "DOUBTFUL" not in table(spring)


def test_dynamics_that_are_no_inverses_are_found(loaded):
    kernels = loaded(texts.BRICK)
    right = check(kernels, RunOverrides())
    assert all(x.round_trip < 100 for x in right.along)

    def wrong(functions):
        own = {name: getattr(functions, name) for name in functions}
        return SimpleNamespace(**{**own, "inverse_dynamics": lambda q, v, a: (
            own["inverse_dynamics"](q, v, a) * np.float32(1 + 2.0**-12))})

    broken = replace(kernels, double=wrong(kernels.double), single=wrong(kernels.single))
    result = check(broken, RunOverrides())
    assert result.along[0].round_trip > 1e10
    assert result.along[1].round_trip > 1e3


def compiled_anyway(lanes_of: lanes.CompiledLanes) -> None:
    pytest.fail(f"functions of many states of {lanes_of.request.name} are compiled")


def test_functions_of_many_states_are_not_compiled(loaded, monkeypatch):
    """They would take longer than the check, whichever kernels its functions belong to."""
    kernels = loaded(texts.SPRING)
    monkeypatch.setattr(lanes, "PAYS", 1)
    monkeypatch.setattr(lanes.CompiledLanes, "_library", property(compiled_anyway))
    check(replace(kernels), RunOverrides())


TWO_LINKS = """
[bodies.upper]
mass = 3
com = [0, 0, -0.4]
inertia = [0.1, 0.1, 0.01]
[bodies.lower]
mass = 1
com = [0, 0, -0.3]
inertia = [0.02, 0.02, 0.001]
[joints.shoulder]
type = "revolute"
child = "upper"
axis = [0, 1, 0]
[joints.elbow]
type = "revolute"
parent = "upper"
child = "lower"
axis = [0, 1, 0]
origin.xyz = [0, 0, -0.8]
[effects.gravity]
[start.q]
shoulder = 1
elbow = 0.7
[run]
duration = 1
integrator = "rk4"
"""


def test_the_condition_is_that_of_the_mass_matrix(loaded):
    """Two links in a plane have M = [[a + 2 b cos θ, c + b cos θ], [c + b cos θ, c]]."""
    kernels = loaded(TWO_LINKS)
    along = check(kernels, RunOverrides()).along[0]
    from coscrew_codegen.simulation.plan import plan
    from coscrew_codegen.simulation.run import integrate
    from coscrew_codegen.simulation.system import system

    its = system(kernels, "double")
    theta = integrate(its, plan(its, every=1e-3)).q[:, 1]
    a = 0.1 + 3 * 0.4**2 + 0.02 + 1 * (0.3**2 + 0.8**2)
    b, c = 1 * 0.8 * 0.3, 0.02 + 0.3**2
    conditions = []
    for x in b * np.cos(theta):
        trace, determinant = a + 2 * x + c, (a + 2 * x) * c - (c + x)**2
        root = math.sqrt(trace**2 / 4 - determinant)
        conditions.append((trace / 2 + root) / (trace / 2 - root))
    assert along.condition == pytest.approx(max(conditions), rel=1e-3)
    assert along.at == pytest.approx(int(np.argmax(conditions)) * 1e-3, abs=2e-3)


def test_both_precisions_are_compared(spring):
    assert [x.precision for x in spring.along] == ["double", "single"]
    gap = {x.quantity: x for x in spring.apart}
    assert 0 < gap["q"].apart < 1e-6
    assert gap["q"].size == pytest.approx(0.1)
    assert set(gap) == {"q", "v", "a", "energy", "power"}


@pytest.mark.parametrize("precision, other", (("double", "single"), ("single", "double")))
def test_only_the_selected_precision_is_checked(tmp_path, capsys, precision, other):
    path = tmp_path / "scene.toml"
    path.write_text(texts.SPRING)
    assert main(["check", str(path), "--precision", precision]) == 0
    out = capsys.readouterr().out
    assert f"{precision}, step 0.001 s" in out
    assert other not in out


# A stop so stiff that the time of contact is far below the step: no energy is kept.
BUMP = texts.SPRING + """
[effects.limit.slide]
lower = -0.05
upper = 1
k = 1e8
"""


def test_a_balance_that_is_off_fails(tmp_path, capsys):
    path = tmp_path / "scene.toml"
    path.write_text(BUMP)
    words = ["check", str(path), "--precision", "double", "--until", "0.6", "--step", "0.01",
             "--integrator", "rk4"]
    assert main(words) == 1
    output = capsys.readouterr().out
    assert "double: " in output and "joint slide is off by" in output
    assert main([*words[:-3], "0.0001", "--integrator", "leapfrog"]) == 0  # resolved
    assert main([*words, "--strict"]) == 1
    path.write_text(texts.SPRING)
    assert main([*words, "--strict"]) == 0


def test_help_tells_exit_statuses(capsys):
    with pytest.raises(SystemExit):
        main(["check", "--help"])
    output = " ".join(capsys.readouterr().out.split())
    assert "The exit status is 0 if all expectations are met; 1 if one is not" in output


def test_expectations_of_a_single_scene_are_of_single_precision(loaded):
    text = RIGHT.replace('precision = "both"', 'precision = "single"')
    findings = check(loaded(text), RunOverrides())
    came = findings.met[0].came
    assert came == float(np.float32(came))
    assert not findings.passed  # 1e-8 is more than single precision has


def test_a_scene_of_double_precision_alone_is_checked_in_it(tmp_path, capsys):
    status, text = outcome(tmp_path / "nut.toml", capsys, "check", 'precision = "double"\n' + NUT)
    assert status == 0 and "double" in text and "single" not in text


NUT = """
base = "free"
[bodies]
nut = { mass = 0.05, inertia = [1e-4, 2e-4, 2.5e-4] }
[start.v]
base = [0.02, 0, 0, 0.1, 10, 0]
[run]
duration = 10
"""
MOTORS = """
[bodies]
upper = { mass = 0.1, com = [0, 0, -0.01], inertia = [1e-4, 1e-4, 1e-4] }
lower = { mass = 0.1, com = [0, 0, -0.01], inertia = [1e-4, 1e-4, 1e-4] }
[joints]
shoulder = { type = "continuous", child = "upper", axis = [0, 1, 0] }
elbow = { type = "continuous", parent = "upper", child = "lower", axis = [0, 1, 0] }
[effects.gravity]
[effects.actuator]
joints = "all"
kind = "pd"
kp = 400
kd = 40
target = 0
limit = 50
[start.q]
shoulder = 0.5
"""
BALL = """
[bodies]
ball = { mass = 1 }
[joints]
fall = { type = "prismatic", child = "ball", axis = [0, 0, 1], limits = { lower = 0 } }
[effects.gravity]
[effects.limit.fall]
k = 1e9
alpha = 0.1
[start.q]
fall = 0.5
"""


@pytest.mark.parametrize("precision, strict", (("double", ("--strict",)), ("single", ()),
                                                ("both", ())))
def test_a_wing_nut_that_turns_wrongly_is_false(tmp_path, capsys, precision, strict):
    """After ten seconds on which nothing acts, integrated by a method of order 1, its energy and
    momentum are off by a few percent, and it has turned to another side."""
    path, old = tmp_path / "nut.toml", ("--integrator", "semi-implicit-euler")
    which = () if precision == "both" else ("--precision", precision)
    if precision == "both":
        assert outcome(path, capsys, "check", NUT, "--precision", "double")[0] == 0
    status, message = outcome(path, capsys, "check", NUT, *which, *old, *strict)
    assert status == 1 and "rounding" not in message
    assert "base is off by" in message and "the step is too large" in message
    assert "integrator leapfrog" in message and "error of the momentum of floating bases" in message


def test_single_precision_is_not_excused_as_rounding(tmp_path, capsys):
    """An error of energy that double precision has as well is the integrator's."""
    path, nut = tmp_path / "nut.toml", NUT.replace("[0.02, 0, 0,", "[0, 0, 0,")
    words = ("--integrator", "semi-implicit-euler", "--until", "2")
    status, message = outcome(path, capsys, "check", nut, *words)
    results = [float(x) for x in message.split("error of energy, relative")[1].split()[:2]]
    assert status == 0 and all(8e-3 < x < 1e-2 for x in results)
    assert message.count("integrator, of order") == 2 and "rounding" not in message
    for precision in ("both", "single"):
        which = () if precision == "both" else ("--precision", precision)
        status, message = outcome(path, capsys, "check", nut, *words, *which, "--strict")
        assert status == 1 and "FALSE with --strict: single: joint base is off by" in message


def test_work_within_steps_counts(tmp_path, capsys):
    """A bounce begins and ends within one step; the energy it dissipates is summed within that
    step."""
    status, message = outcome(tmp_path / "ball.toml", capsys, "check", BALL)
    assert status == 0, message
    assert outcome(tmp_path / "ball.toml", capsys, "check", BALL, "--integrator", "rk4")[0] == 1


@pytest.mark.parametrize("text, integrator, words", (
    (NUT.replace("duration = 10", "duration = 20"), "semi-implicit-euler",
     "energy is not kept at t = "),
    (NUT.replace("[run]", "[effects.spring_damper.tie]\nbodies = ['world', 'nut']\nk = 1e-9\n"
                 "d = 1e-9\n[run]").replace("duration = 10", "duration = 20"), "leapfrog", ""),
    (MOTORS, "semi-implicit-euler", "the step is too large at t = "),
    (MOTORS, "rk4", "the step is too large at t = "),
    (MOTORS, "leapfrog", ""), (MOTORS, "linear-implicit-euler", ""),
    (texts.SPRING.replace(f"k = {texts.STIFFNESS}", "k = 8e6"), "leapfrog",
     "the step is too large at t = "),
    (BALL, "leapfrog", ""), (BALL.replace("1e9", "1e17"), "leapfrog",
                             "a limit closes that is too stiff")))
def test_false_motion_stops_with_time_joint_cause_and_remedy(tmp_path, capsys, text, integrator,
                                                             words):
    status, message = outcome(tmp_path / "scene.toml", capsys, "simulate", text, "--integrator",
                        integrator, "--precision", "double")
    assert status == (1 if words else 0), message
    if words:
        assert words in message and "step" in message.split(words)[1] and "samples kept" in message
        assert "joint" in message or words.startswith("energy")
