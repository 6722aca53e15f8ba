"""Lags of motors and elastic gears against closed forms, matrix exponentials, another solver on the
same laws, and their limits: no lag, and a rigid gear."""

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
import scipy.integrate
import scipy.linalg

from coscrew_codegen import load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.integrators import INTEGRATOR_NAMED, NAMES
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.sweep.chunk import states
from coscrew_codegen.simulation.sweep.specification import Specification

BLOCK = """
[bodies]
block = { mass = 2, inertia = [0.1, 0.1, 0.1] }
[joints]
slide = { type = "prismatic", child = "block", axis = [1, 0, 0] }
[run]
rtol = 1e-11
atol = 1e-13
"""
PENDULUM = """
[bodies]
link = { mass = 2, com = [0.3, 0, 0], inertia = [0.01, 0.02, 0.02] }
[joints]
hinge = { type = "revolute", child = "link", axis = [0, 1, 0] }
[effects.gravity]
[run]
rtol = 1e-11
atol = 1e-13
"""
MOTOR = """
[effects.actuator.hinge]
kind = "pd"
kp = 300
kd = 20
target = "0.5*sin(4*t)"
"""
INERTIA, WEIGHT, J = 0.02 + 2 * 0.3**2, 2 * 9.81 * 0.3, 0.1
Made = Callable[[str], Path]
each_integrator = pytest.mark.parametrize("integrator", NAMES)


@pytest.fixture
def made(tmp_path: Path) -> Made:
    def written(text: str) -> Path:
        path = tmp_path / "thing.toml"
        path.write_text(text)
        return path
    return written


def loaded(path: Path, integrator: str) -> Kernels:
    """The scene with the step of an integrator."""
    step = INTEGRATOR_NAMED[integrator].step_name
    return load_scene(path, functions=["default", *([step] if step else [])])


def order(integrator: str, error: Callable[[float], float], step: float) -> None:
    """Asserts the order of an emitted integrator, or that a solver's error is within its
    tolerances."""
    own = INTEGRATOR_NAMED[integrator]
    if own.emitted:
        assert np.log2(error(step) / error(step / 2)) == pytest.approx(own.order, abs=0.3)
    else:
        assert error(step) < 1e-9


# lags

@each_integrator
def test_a_torque_follows_its_demand_exponentially(made: Made, integrator: str) -> None:
    """x = f (1 - exp(-t/T)), exact in steps of any length but of solvers and rk4."""
    motor = '[effects.actuator.slide]\nkind = "torque"\ntorque = 3\nlag = 0.05\n'
    kernels = loaded(made(BLOCK + motor), integrator)

    def error(step: float) -> float:
        result = run(kernels, until=0.2, every=0.1, step=step, integrator=integrator)
        share = 1 - np.exp(-result.t / 0.05)
        if integrator != "rk4" and INTEGRATOR_NAMED[integrator].emitted:
            assert np.abs(result.q[:, 1] - 3 * share).max() < 1e-14
        return float(np.abs(result.v[-1, 0] - 1.5 * (result.t[-1] - 0.05 * share[-1])))

    order(integrator, error, 4e-3)


@each_integrator
def test_a_controlled_joint_with_a_lag_has_the_poles_of_its_equation(made: Made, integrator: str
                                                                     ) -> None:
    """(q, v, x)' = A (q, v, x) with x' = (-kp q - kd v - x)/T."""
    motor = ('[effects.actuator.slide]\nkind = "pd"\nkp = 200\nkd = 12\ntarget = 0\nlag = 0.02\n'
             '[start.q]\nslide = 0.3\n')
    kernels = loaded(made(BLOCK + motor), integrator)
    A = np.array([[0, 1, 0], [0, 0, 0.5], [-200 / 0.02, -12 / 0.02, -1 / 0.02]])
    exact = scipy.linalg.expm(A * 0.4) @ (0.3, 0, 0)

    def error(step: float) -> float:
        result = run(kernels, until=0.4, every=0.2, step=step, integrator=integrator)
        return float(np.abs(result.q[-1, 0] - exact[0]))

    order(integrator, error, 5e-4)


@pytest.mark.parametrize("integrator", ["leapfrog", "linear-implicit-euler"])
@pytest.mark.parametrize("precision, within", [("double", 1e-12), ("single", 1e-5)])
def test_without_lag_in_the_limit(made: Made, integrator: str, precision: str, within: float
                                  ) -> None:
    """A stiff controller on a light link, h kd/m = 400: with a lag far below the step it acts as
    without one."""
    text = BLOCK.replace("mass = 2", "mass = 1e-4")
    motor = '[effects.actuator.slide]\nkind = "pd"\nkp = 400\nkd = 40\ntarget = "sin(5*t)"\n'
    with_lag, without = (run(made(text + motor + lag), until=0.5, every=0.01, step=1e-3,
                             integrator=integrator, precision=precision)
                         for lag in ("lag = 1e-9\n", ""))
    assert np.abs(with_lag.q[:, 0] - without.q[:, 0]).max() < within


def test_a_lag_of_any_length_is_stable_in_default_steps(made: Made) -> None:
    """h kd/m = 20, lags from far below to above the step: the controller settles."""
    text = BLOCK.replace("mass = 2", "mass = 2e-3")
    motor = '[effects.actuator.slide]\nkind = "pd"\nkp = 40\nkd = 40\ntarget = 0.1\nlag = '
    for lag in (1e-7, 1e-5, 1e-4, 3e-4):
        result = run(made(f"{text}{motor}{lag}\n"), until=30, every=1, step=1e-3)
        assert abs(result.q[-1, 0] - 0.1) < 1e-9


def test_limits_clip_the_demand(made: Made) -> None:
    motor = '[effects.actuator.slide]\nkind = "torque"\ntorque = 9\nlimit = 3\nlag = 0.05\n'
    record = '[outputs]\nrecord = ["q", "x", "actuator.slide.torque", "actuator.slide.saturated"]\n'
    result = run(made(BLOCK + motor + record), until=0.2)
    acts = result.recorded["actuator.slide.torque"]
    assert np.abs(acts - 3 * (1 - np.exp(-result.t / 0.05))).max() < 1e-13
    assert np.array_equal(acts, result.recorded["x.actuator.slide"])
    assert (result.recorded["actuator.slide.saturated"] == 1).all()


# gears

TWO = """
[effects.gear.slide]
k = 1e3
d = 0
inertia = 0.5
[start.x]
"gear.slide" = [0.01, 0]
"""


@each_integrator
def test_two_masses_oscillate_about_their_centre(made: Made, integrator: str) -> None:
    """At √(k (1/m + 1/J)), momentum kept."""
    omega, m, own = np.sqrt(1e3 * (1 / 2 + 1 / 0.5)), 2, 0.5
    kernels = loaded(made(BLOCK + TWO), integrator)

    def error(step: float) -> float:
        result = run(kernels, until=0.05, every=0.05, step=step, integrator=integrator)
        twist = 0.01 * np.cos(omega * result.t[-1])
        if integrator not in ("semi-implicit-euler", "linear-implicit-euler"):
            assert m * result.v[-1, 0] + own * result.q[-1, 2] == pytest.approx(0, abs=1e-12)
        return float(np.abs(result.q[-1, 1] - result.q[-1, 0] - twist))

    order(integrator, error, 1e-4)


def test_energy_of_spring_and_rotor_is_kept(made: Made) -> None:
    """In 1e5 steps of h ω = 0.1, without drift."""
    result = run(made(BLOCK + TWO + '[outputs]\nrecord = ["energy"]\n'), until=200, every=0.1,
                 step=2e-3)
    energy = result.recorded["energy.total"]
    assert energy[0] == pytest.approx(0.5 * 1e3 * 0.01**2, rel=1e-12)
    assert np.abs(energy / energy[0] - 1).max() < 1e-2
    assert abs(energy[1000:].mean() / energy[:1000].mean() - 1) < 1e-4


def gear(k: float, d: str = "") -> str:
    return f"[effects.gear.hinge]\nk = {k}\n{d}inertia = {J}\n"


@pytest.mark.parametrize("precision, noise", [("double", 0.0), ("single", 2e-6)])
def test_a_stiff_gear_is_a_rigid_one_and_its_wind_up(made: Made, precision: str, noise: float
                                                     ) -> None:
    """1e6 N m/rad at 1 ms, h ω = 4: the joint is behind a rigid one by (inertia a + weight)/k."""
    rigid = f"[effects.armature.hinge]\ninertia = {J}\n"
    stiff, true = (run(made(PENDULUM + MOTOR + x), until=2, every=0.01, step=1e-3,
                       precision=precision) for x in (gear(1e6), rigid))
    q = np.asarray(stiff.q, float)
    torque = 0.5 * 4**2 * INERTIA + WEIGHT
    assert np.abs(q[:, 0] - true.q[:, 0]).max() < 3 * torque / 1e6 + noise
    assert np.abs(q[:, 1] - q[:, 0]).max() < 3 * torque / 1e6 + noise


def test_at_rest_the_gear_is_wound_up_by_the_weight(made: Made) -> None:
    motor = MOTOR.replace('"0.5*sin(4*t)"', "0")
    q, twist, _ = run(made(PENDULUM + motor + gear(1e4, "d = 5\n")), until=5).q[-1]
    weight = WEIGHT * np.cos(q)
    assert twist - q == pytest.approx(-weight / 1e4, rel=1e-9)
    assert twist == pytest.approx(weight / 300, rel=1e-9)


def test_an_infinitely_stiff_gear_is_an_armature(made: Made) -> None:
    rigid = f"[effects.armature.hinge]\ninertia = {J}\n"
    for integrator, within in (("leapfrog", 1e-9), ("linear-implicit-euler", 1e-9)):
        stiff, true = (run(made(PENDULUM + MOTOR + x), until=0.5, every=0.01, step=1e-3,
                           integrator=integrator) for x in (gear(1e13, "d = 1e9\n"), rigid))
        assert np.abs(stiff.q[:, 0] - true.q[:, 0]).max() < within


def both(t: float, y: np.ndarray) -> list[float]:
    """(q, v, θ, ω, x)' of a pendulum behind a gear, driven by a controller with a lag."""
    q, v, angle, speed, x = y
    push = 2e3 * (angle - q) + 3 * (speed - v)
    demand = 300 * (0.5 * np.sin(4 * t) - angle) - 20 * speed
    return [v, (push + WEIGHT * np.cos(q)) / INERTIA, speed, (x - push) / J, (demand - x) / 0.01]


@each_integrator
def test_gear_lag_and_controller_as_by_another_solver(made: Made, integrator: str) -> None:
    path = made(PENDULUM + MOTOR + "lag = 0.01\n" + gear(2e3, "d = 3\n"))
    kernels = loaded(path, integrator)
    assert kernels.interface.states == (
        ("x.actuator.hinge", "N m"), ("x.gear.hinge.0", "rad"), ("x.gear.hinge.1", "rad/s"))
    truth = scipy.integrate.solve_ivp(both, (0, 0.3), [0.0] * 5, "DOP853", rtol=1e-12, atol=1e-14)

    def error(step: float) -> float:
        result = run(kernels, until=0.3, every=0.15, step=step, integrator=integrator)
        own = (*result.q[-1, [0]], *result.v[-1], *result.q[-1, [2, 3, 1]])
        return float(np.abs(np.subtract(own, truth.y[:, -1])).max())

    order(integrator, error, 2e-3 if integrator == "rk4" else 2.5e-4)


@pytest.mark.parametrize("more", [gear(1e4), gear(1e6), "", gear(1e4) + "[effects.stiction.hinge]\n"
                                  "tau_c = 1\n[effects.viscous.hinge]\nd = 0.2\n"])
@pytest.mark.parametrize("lag", ["", "lag = 5e-3\n"])
def test_check_balances_the_energy_with_states(made: Made, capsys: pytest.CaptureFixture[str],
                                               more: str, lag: str) -> None:
    path = made(PENDULUM + MOTOR + lag + more + "[start.q]\nhinge = 0.2\n")
    status = main(["check", str(path), "--until", "0.5", "--precision", "double"])
    assert status == 0, capsys.readouterr().out


def test_a_rotor_starts_with_its_joint(made: Made) -> None:
    start = "[start.q]\nhinge = 0.4\n[start.v]\nhinge = -2\n"
    result = run(made(PENDULUM + gear(1e4) + start), until=0.01)
    assert result.q[0].tolist() == [0.4, 0.4, -2]
    both_starts = run(made(PENDULUM + gear(1e4) + start), until=0.01, v0=[[3.0], [4.0]])
    assert both_starts.q[:, 0].tolist() == [[0.4, 0.4, 3], [0.4, 0.4, 4]]
    own = '[start.x]\n"gear.hinge" = [0.3, 1]\n'
    assert run(made(PENDULUM + gear(1e4) + start + own), until=0.01).q[0].tolist() == [0.4, 0.3, 1]


def test_members_of_sweeps_start_rotors_with_their_joints(made: Made) -> None:
    varied = SimpleNamespace(columns=[SimpleNamespace(array="q", index=0)])
    conditions = SimpleNamespace(precision="double", settings=())
    its = cast(Specification, SimpleNamespace(varied=varied, conditions=conditions))
    starts = states(load_scene(made(PENDULUM + gear(1e4))), its, np.array([[0.1], [0.2]]))
    assert starts["q"].tolist() == [[0.1, 0.1, 0], [0.2, 0.2, 0]]


@pytest.mark.parametrize("text, words", [
    ("[effects.gear.hinge]\nk = 1e4\n", "inertia or rotor"),
    ("[effects.gear.hinge]\ninertia = 1\n", "k"),
    ("[effects.gear.hinge]\nk = 0\ninertia = 1\n", "k"),
    ("[effects.gear.both]\njoints = { hinge = 1 }\nk = 1\ninertia = 1\n", "not on a sum"),
    (MOTOR + "lag = 0\n", "lag")])
def test_what_cannot_be_is_refused(made: Made, text: str, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        read_scene(made(PENDULUM + text))


def test_followers_have_no_gear_of_their_own(made: Made) -> None:
    text = PENDULUM.replace("[joints]", "tip = { mass = 1, inertia = [1, 1, 1] }\n[joints]\n"
                            'end = { type = "revolute", parent = "link", child = "tip", '
                            'axis = [0, 1, 0], mimic = { joint = "hinge", multiplier = -1 } }')
    with pytest.raises(SceneError, match="'end' follows 'hinge', whose rotor drives both"):
        read_scene(made(text + "[effects.mimic]\n" + gear(1e4).replace("hinge", "end")))


def test_a_gear_at_a_leader_drives_its_followers(made: Made) -> None:
    """A follower's inertia swings on the same rotor: with J, at √(k (1/I + 1/J))."""
    text = """
[bodies]
link = { mass = 1, inertia = [1, 0.3, 1] }
tip = { mass = 1, inertia = [1, 0.2, 1] }
[joints]
hinge = { type = "revolute", child = "link", axis = [0, 1, 0] }
end = { type = "revolute", child = "tip", axis = [0, 1, 0], mimic = { joint = "hinge" } }
[effects.mimic]
[start.x]
"gear.hinge" = [0.01, 0]
"""
    result = run(made(text + gear(1e3, "d = 0\n")), until=0.2, every=0.1, integrator="dop853")
    twist = 0.01 * np.cos(np.sqrt(1e3 * (1 / 0.5 + 1 / J)) * result.t)
    assert np.abs(result.q[:, 1] - result.q[:, 0] - twist).max() < 1e-7
    leap = run(made(text + gear(1e3, "d = 0\n")), until=0.2, every=0.1, step=2e-5)
    assert np.abs(leap.q - result.q)[:, :2].max() < 1e-6
