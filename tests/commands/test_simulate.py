"""Runs of scenes: values against closed forms, samples, stops, progress."""

import fcntl
import math
import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import termios
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from coscrew_codegen import load_scene
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.integrators import EMITTED, NAMES, named
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.check.divergence_monitor import Alarm
from coscrew_codegen.simulation.plan import Plan, plan
from coscrew_codegen.simulation.progress import EnergyDrift, line
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.run_summary import RunOverrides, simulated
from coscrew_codegen.simulation.system import System, system
from tests.support.processes import interruptible
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.selecting import STEPPED
from tests.support.scenes.simulated import run, scene_file

EXAMPLES = Path(__file__).parents[2] / "examples/scenes"
ORDERS = {x.name: x.order for x in EMITTED}
INTEGRATORS = NAMES
ROUNDOFF = {"double": 2.0**-53, "single": 2.0**-24}


# results

@pytest.mark.parametrize("integrator, error", (("rk4", 1e-9), ("dop853", 1e-9), ("radau", 1e-9)))
def test_a_pendulum_is_where_the_benchmark_says(kernels, integrator, error):
    """Problem A01 of IFToMM's Library of Computational Benchmark Problems: its values at t = 10."""
    overrides = RunOverrides(integrator=integrator, precision="double")
    (first,) = simulated(kernels["PENDULUM"], overrides)
    x, _, z = (first.recording.of(f"position.bob.{i}")[-1] for i in range(3))
    assert abs(x + 0.275087462576117) < error
    assert abs(z + 0.961419205099125) < error


@pytest.mark.parametrize("integrator", ORDERS)
def test_errors_fall_with_the_integrators_order(kernels, integrator):
    """Errors of angle and speed together: from rest at a right angle, some of one alone fall
    faster."""
    wanted = np.array([float(x) for x in texts.pendulum(1)])
    results = [run(kernels["PENDULUM"], until=1.0, integrator=integrator, step=h)
               for h in (0.01, 0.005)]
    errors = [np.linalg.norm((*x.q[-1], *x.v[-1]) - wanted) for x in results]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(ORDERS[integrator], abs=0.15)


def test_dop853_takes_scipys_steps(kernels):
    """It takes as many as SciPy for the same equation: x'' = -(k x + d v) / m."""
    result = run(kernels["SPRING"], integrator="dop853")
    matrix = np.array([[0, 1], [-texts.STIFFNESS / texts.MASS, -texts.DAMPING / texts.MASS]])
    swing = solve_ivp(lambda t, y: matrix @ y, (0, 2), (0.1, 0), method="DOP853", rtol=1e-12,
                      atol=1e-12)
    assert result.steps == len(swing.t) - 1 > 10


@pytest.mark.parametrize("precision", ROUNDOFF)
@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_a_damped_spring_swings_as_its_closed_form(kernels, integrator, precision):
    result = run(kernels["SPRING"], precision, integrator=integrator)
    truth = np.array([[float(x) for x in texts.spring(t)] for t in result.t])
    error = np.abs(np.column_stack((result.q, result.v)) - truth).max(0)
    allowed = {1: 0.05, 2: 5e-5, 3: 1e-6}.get(ORDERS.get(integrator), 1e-9)
    allowed += 4e3 * ROUNDOFF[precision]
    assert (error / (0.1, 0.1 * math.sqrt(50))).max() < allowed


@pytest.mark.parametrize("integrator", ("rk4", "dop853", "radau"))
def test_a_brick_falls_and_keeps_its_angular_momentum(kernels, integrator):
    (first,) = simulated(kernels["BRICK"], RunOverrides(integrator=integrator, precision="double"))
    t = first.recording.t
    position = np.column_stack([first.recording.of(f"position.brick.{i}") for i in range(3)])
    thrown = np.column_stack((t, 2 * t, 5 * t - texts.GRAVITY * t**2 / 2))
    assert np.abs(position - thrown).max() < 1e-9
    about_centre = np.column_stack([first.recording.of(f"momentum.{3 + i}") for i in range(3)])
    about_centre -= np.cross(position, 2 * np.column_stack((1 + 0 * t, 2 + 0 * t,
                                                            5 - texts.GRAVITY * t)))
    assert np.abs(about_centre - [0.3, -0.2, 0.5]).max() < 1e-9


@pytest.mark.parametrize("precision", ROUNDOFF)
@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_quaternions_stay_of_norm_one(kernels, integrator, precision):
    result = run(kernels["BRICK"], precision, integrator=integrator)
    norms = np.linalg.norm(result.q[:, 3:].astype(float), axis=1)
    assert np.abs(norms - 1).max() < 1e4 * ROUNDOFF[precision]


@pytest.mark.parametrize("precision", ROUNDOFF)
@pytest.mark.parametrize("integrator", ORDERS)
def test_steps_in_one_call_are_those_one_by_one(kernels, integrator, precision):
    """To the last bit."""
    its = system(kernels["BRICK"], precision)
    name = named(integrator).step_name
    q, v = its.start()
    assert kernels["BRICK"].compiled and hasattr(getattr(its.kernels, name), "repeated")
    together = its.stepper(name)(100, 0.0, 1e-3, q, v)
    for _ in range(100):
        q, v = getattr(its.kernels, name)(its.dtype.type(1e-3), q, v)
    assert together[0].tobytes() == q.tobytes()
    assert together[1].tobytes() == v.tobytes()


@pytest.mark.parametrize("precision", ROUNDOFF)
@pytest.mark.parametrize("alarm", (None, Alarm))
@pytest.mark.parametrize("name, every", (("PENDULUM", 1e-3), ("PENDULUM", 0.0105),
                                         ("SPRING", 2e-3), ("UNSTABLE", 1e-3)))
def test_samples_in_one_loop_are_those_one_by_one(kernels, monkeypatch, name, every, alarm,
                                                  precision):
    """To the last bit, and with the same end, where a run stops, too."""
    its = system(kernels[name], precision)
    how = plan(its, until=0.5, step=1e-3, every=every)
    together, calls = integrate(its, how, alarm=alarm), []
    monkeypatch.setattr(System, "sampler", lambda *_: calls.append(1))
    alone = integrate(its, how, alarm=alarm)
    assert calls and bool(alone.stopped) == (name == "UNSTABLE")
    for of in ("t", "q", "v"):
        assert getattr(together, of).tobytes() == getattr(alone, of).tobytes()
    assert (together.steps, together.failed) == (alone.steps, alone.failed)


@pytest.fixture(scope="module")
def hopper() -> Kernels:
    """Its forces depend on time, and its foot bounces."""
    return load_scene(EXAMPLES / "hopper.toml")


@pytest.mark.parametrize("precision", ROUNDOFF)
@pytest.mark.parametrize("finer, shorter", ((2, True), (16, True), (1, False)))
def test_finer_parts_in_c_are_those_one_by_one(hopper, monkeypatch, finer, shorter, precision):
    """To the last bit, and elsewhere than with parts of the usual length."""
    its = system(hopper, precision)
    assert hopper.compiled
    usual = plan(its, until=0.7, step=1e-3, every=5e-3)
    together = integrate(its, replace(usual, finer=finer))
    assert (together.q.tobytes() != integrate(its, usual).q.tobytes()) == shorter
    monkeypatch.setattr(System, "sampler", lambda *_: None)
    alone = integrate(its, replace(usual, finer=finer))
    assert together.q.tobytes() == alone.q.tobytes()
    assert together.v.tobytes() == alone.v.tobytes()


@pytest.mark.parametrize("precision", ROUNDOFF)
def test_without_a_compiler_the_same_run_comes_from_numpy(kernels, tmp_path, monkeypatch,
                                                          precision):
    """To the last bit, since a spring needs only sums, products and quotients."""
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.warns(RuntimeWarning, match="pure NumPy"):
        others = load_scene(scene_file(tmp_path, texts.SPRING, "spring"), functions=STEPPED)
    result, wanted = (simulated(x, RunOverrides(until=0.1, precision=precision))[0]
                      for x in (others, kernels["SPRING"]))
    assert result.trajectory.q.tobytes() == wanted.trajectory.q.tobytes()
    assert result.recording.values.tobytes() == wanted.recording.values.tobytes()
    assert dict(result.recording.provenance)["compiler"] == "none: NumPy"


def test_a_parameter_may_be_set(kernels):
    (first,) = simulated(kernels["SPRING"], RunOverrides(precision="double",
                                                  settings=(("block.mass", 8.0),)))
    wanted = [float(texts.spring(t, 8)[0]) for t in first.trajectory.t]
    assert np.abs(first.trajectory.q[:, 0] - wanted).max() < 1e-10


# samples

@pytest.mark.parametrize("integrator", ("rk4", "dop853"))
@pytest.mark.parametrize("until, every, wanted", (
    (2.0, 0.5, [0, 0.5, 1, 1.5, 2]), (0.7, 0.3, [0, 0.3, 0.6, 0.7]), (0.1, 0.3, [0, 0.1]),
    (0.3, 0.1, [0, 0.1, 0.2, 0.3])))
def test_samples_are_at_multiples_and_at_the_end(kernels, integrator, until, every, wanted):
    result = run(kernels["PENDULUM"], until=until, every=every, integrator=integrator)
    assert result.t == pytest.approx(wanted, abs=1e-15)
    assert result.t[-1] == until
    truth = [float(texts.pendulum(t)[0]) for t in result.t]
    assert np.abs(result.q[:, 0] - truth).max() < 1e-9


@pytest.mark.parametrize("until, every, step, steps", (
    (1.0, 0.1, 0.01, 100), (1.0, 0.1, 0.03, 40), (0.25, 0.1, 0.1, 3), (1.0, 0.1, 7.0, 10)))
def test_steps_never_span_a_sample(kernels, until, every, step, steps):
    assert run(kernels["PENDULUM"], until=until, every=every, step=step).steps == steps


def test_further_times_are_sampled_too():
    wanted = Plan(1.0, 0.25, "rk4", 1e-3, 1e-9, 1e-9, (0.1, 0.25, 0.9, 1.0, 3.0))
    assert wanted.samples == pytest.approx([0, 0.1, 0.25, 0.5, 0.75, 0.9, 1])


@pytest.mark.parametrize("until", (0.5, 30.0))
def test_until_may_be_shorter_or_longer_than_the_scene_says(kernels, until):
    assert run(kernels["PENDULUM"], until=until).t[-1] == until


# stops

@pytest.mark.parametrize("precision", ROUNDOFF)
def test_a_state_that_is_not_finite_stops_and_keeps_the_rest(kernels, precision):
    result = run(kernels["UNSTABLE"], precision)
    at = float(re.fullmatch(r"not finite at t = (\S+) s: joint slide: [qv] is -?(?:inf|nan); .+",
                            result.stopped)[1])
    assert result.t[-1] < at <= result.t[-1] + 0.01 + 1e-12
    assert np.isfinite(result.q).all() and np.isfinite(result.v).all()
    growth = math.log(np.finfo(system(kernels["UNSTABLE"], precision).dtype).max) / math.log(400)
    assert at / 1e-3 == pytest.approx(growth, abs=4)


def test_a_solver_that_gives_up_keeps_the_rest(tmp_path):
    """A motor's force, and so the speed, has a pole at t = 0.5."""
    text = texts.SPRING.replace("[effects.viscous]\njoints = \"all\"\nd = 1", """
[effects.actuator.slide]
kind = "torque"
torque = "1/(0.5 - t)**2"
""").replace("tol = 1e-12", "tol = 1e-6")
    kernels = load_scene(scene_file(tmp_path, text), functions=STEPPED)
    result = run(kernels, integrator="dop853", until=2.0)
    assert "at t = 0.5" in result.stopped or "at t = 0.49" in result.stopped, result.stopped
    assert "joint slide: acceleration" in result.stopped
    assert 0.45 < result.t[-1] <= 0.5


def test_an_interrupt_keeps_what_was_sampled(kernels):
    its = system(kernels["PENDULUM"], "double")

    def watch(t, q, v):
        if t > 0.99:
            raise KeyboardInterrupt

    result = integrate(its, plan(its), watch)
    assert result.interrupted
    assert result.stopped == "interrupted after t = 1 s"
    assert result.t == pytest.approx(0.05 * np.arange(21))


@contextmanager
def on_a_terminal(*arguments: object) -> Iterator[tuple[subprocess.Popen, int]]:
    """The command, with its standard error on a terminal of 24 lines; returns the other end of
    that."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 100, 0, 0))
    words = (sys.executable, "-m", "coscrew_codegen", *arguments)
    with interruptible(words, stdout=subprocess.PIPE, stderr=slave) as process:
        os.close(slave)
        yield process, master
    os.close(master)


def said_until(master: int, pattern: bytes) -> bytes:
    """The output up to the pattern, or to the end."""
    message = b""
    while not re.search(pattern, message) and select.select([master], [], [], 300)[0]:
        try:
            message += os.read(master, 4096)
        except OSError:  # the other end was closed
            break
    return message


def test_ctrl_c_writes_what_was_sampled(tmp_path):
    text = texts.PENDULUM.replace("duration = 10", "duration = 1e6").replace(
        "every = 0.05", "every = 1").replace("step = 1e-3", "step = 1e-5")
    output = tmp_path / "out.csv"
    scene = scene_file(tmp_path, text)
    with on_a_terminal("simulate", scene, "--precision", "double", "--output", output) as (
            process, master):
        said_until(master, rb"t [1-9]\d*\S*/1e\+06 s ")
        process.send_signal(signal.SIGINT)
        message = said_until(master, rb"samples kept").decode()
        process.communicate(timeout=300)
    assert process.returncode == 130, message
    rows = [x for x in output.read_text().splitlines() if not x.startswith("#")][1:]
    assert len(rows) > 1
    assert re.search(rf"interrupted after t = \d+ s; {len(rows)} samples kept", message), message


# progress

def test_the_line_of_progress():
    assert (line(3.2, 10, 3.2 / 41, 2e-11)
            == "t 3.2/10 s  32 %  41x real time  dE/E 2e-11  ETA 0 s")
    assert line(1234.5, 3000, 1, 0.0).startswith("t 1234/3000 s  41 %  ")
    assert line(0, 10, 0.0, 0.0) == "t 0/10 s  0 %  0x real time  dE/E 0e+00  ETA ?"


def test_drift_is_relative_to_the_energy_exchanged():
    """A ball falls from 10 J and loses 1e-9 of them: wherever the potential energy is zero."""
    for zero in (0.0, -10.0, 1e3):
        drift = EnergyDrift()
        assert drift(0.0, 10 + zero) == 0
        assert drift(6.0, 4 + zero) == 0
        assert drift(10 - 1e-8, zero) == pytest.approx(1e-9, rel=1e-5)
        assert drift(0.0, 10 - 1e-8 + zero) == pytest.approx(1e-9, rel=1e-5)
    at_rest = EnergyDrift()
    assert (at_rest(0.0, -3.0), at_rest(0.0, -3.0)) == (0, 0)


def test_runs_tell_where_they_are_between_samples(kernels, monkeypatch, tmp_path):
    """However far the next sample is; the states are the same, to the last bit."""
    def watched(its, **requested):
        seen = []
        planned = plan(its, **requested)
        result = integrate(its, planned, lambda t, q, v: seen.append(float(t)))
        assert result.q.tobytes() == integrate(its, planned).q.tobytes()
        return seen, result

    its = system(kernels["SPRING"], "double")
    seen, _ = watched(its, until=0.1, every=0.1, step=1e-6, integrator="rk4")
    assert seen == pytest.approx([4e-4 * i for i in range(1, 251)])
    for integrator in ("radau", "dop853"):
        seen, result = watched(its, until=1.0, every=0.9, integrator=integrator)
        assert result.steps > 10 and abs(len(seen) - result.steps) <= 2
        assert seen == sorted(seen)
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.warns(RuntimeWarning, match="pure NumPy"):
        others = load_scene(scene_file(tmp_path, texts.SPRING, "spring"), functions=STEPPED)
    seen, _ = watched(system(others, "double"), until=0.01, every=0.01, integrator="rk4")
    assert seen == pytest.approx([1e-3 * i for i in range(1, 11)])


def test_progress_is_shown_within_a_long_step_of_samples(tmp_path):
    text = texts.PENDULUM.replace("every = 0.05", "every = 10")
    wanted = rb"t \S+/10 s  0 %  \S+x real time"
    with on_a_terminal("simulate", scene_file(tmp_path, text), "--precision", "double",
                       "--step", "1e-9") as (_, master):
        assert re.search(wanted, said_until(master, wanted))


def test_progress_is_shown_on_a_terminal(tmp_path):
    text = texts.PENDULUM.replace("duration = 10", "duration = 100").replace("1e-3", "1e-5")
    wanted = rb"t \S+/100 s  \d+ %  \S+x real time  dE/E \d+e[-+]\d+  ETA \d+ s"
    with on_a_terminal("simulate", scene_file(tmp_path, text), "--precision", "double") as (
            _, master):
        assert re.search(wanted, said_until(master, wanted))


@pytest.mark.parametrize("requested, words", [
    ({"step": 1e-300}, "steps of 1e-300 s; wanted at most 1e+12"),
    ({"integrator": ""}, "integrator: ''; wanted one of")])
def test_runs_that_would_never_end_or_mean_nothing_are_refused(kernels, requested, words):
    with pytest.raises(SimulateError, match=re.escape(words)):
        run(kernels["SPRING"], **requested)
