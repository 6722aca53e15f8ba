"""Single runs are also judged as a whole: errors that no few steps show stop them."""

import math

import numpy as np
import pytest

from coscrew_codegen import run
from coscrew_codegen.__main__ import main

OSCILLATOR = """
[outputs]
every = 0.1
[bodies]
block = { mass = 1, inertia = [1, 1, 1] }
[joints]
slide = { type = "prismatic", child = "block", axis = [1, 0, 0] }
[effects.spring.slide]
k = 1
[start.q]
slide = 1
[run]
duration = 200
"""
BOUNCING = """
[outputs]
every = 0.01
[bodies]
block = { mass = 1, inertia = [1, 1, 1] }
[joints]
slide = { type = "prismatic", child = "block", axis = [0, 0, 1], limits = { lower = 0, upper = 9 } }
[effects.gravity]
g = [0, 0, -10]
[effects.limit.slide]
k = 1e6
alpha = 0
[start.q]
slide = 0.05
[run]
duration = 1
"""


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory):
    folder = tmp_path_factory.mktemp("drifting")
    for name, text in (("oscillator", OSCILLATOR), ("bouncing", BOUNCING)):
        (folder / f"{name}.toml").write_text(text)
    return folder


@pytest.mark.filterwarnings("ignore:the run stopped")
@pytest.mark.parametrize("step, right", ((0.1, False), (0.01, True)))
def test_errors_of_phase_that_add_up_stop_a_run(files, step, right):
    """x = cos t; a few steps of 0.1 are right within 1e-3, and their phase is not after 200 s."""
    result = run(files / "oscillator.toml", step=step, integrator="leapfrog")
    errors = np.abs(result.q[:, 0] - np.cos(result.t))
    assert (errors.max() < 0.01) == right and (errors.max() > 0.05) != right
    assert not result.failed if right else "joint slide is off" in result.failed[0].cause
    early = run(files / "oscillator.toml", step=step, integrator="leapfrog", until=6.28)
    assert not early.failed
    assert np.abs(early.q[:, 0] - np.cos(early.t)).max() < 0.01


@pytest.mark.filterwarnings("ignore:the run stopped")
@pytest.mark.parametrize("until", (500, 2000, 5000))
def test_large_errors_of_phase_stop_a_run_as_small_ones_do(files, until):
    """Though no reference is known to the end."""
    result = run(files / "oscillator.toml", step=0.1, until=until, every=until)
    assert abs(result.q[-1, 0] - np.cos(until)) > 0.05 and "is off by" in result.failed[0].cause


@pytest.mark.filterwarnings("ignore:the run stopped")
@pytest.mark.parametrize("step", (0.1, 0.3, 10))
def test_it_is_the_steps_taken_that_count(files, step):
    """Samples every 0.1 s shorten all of these to 0.1 s."""
    result = run(files / "oscillator.toml", step=step, integrator="leapfrog")
    assert "joint slide is off" in result.failed[0].cause


@pytest.mark.filterwarnings("ignore:the run stopped")
@pytest.mark.parametrize("every", (0.0875, 1000))
def test_samples_do_not_matter(files, every):
    """The run ends at a turning point, where errors of phase are small."""
    result = run(files / "oscillator.toml", step=0.0875, every=every, until=65 * math.pi)
    assert "joint slide is off" in result.failed[0].cause


@pytest.mark.filterwarnings("ignore:the run stopped")
@pytest.mark.parametrize("precision", ("double", "single"))
def test_a_start_with_a_velocity_is_judged_as_one_without(files, precision):
    """x = sin t, though the line of start leads 200 m away."""
    result = run(files / "oscillator.toml", step=0.1, precision=precision, q0=[0], v0=[1])
    assert np.abs(result.q[:, 0] - np.sin(result.t)).max() > 0.05 and result.failed
    right = run(files / "oscillator.toml", step=0.01, precision=precision, q0=[0], v0=[1])
    assert np.abs(right.q[:, 0] - np.sin(right.t)).max() < 0.01 and not right.failed


@pytest.mark.filterwarnings("ignore:the run stopped")
@pytest.mark.parametrize("integrator, right", (
    ("rk4", False), ("linear-implicit-euler", False), ("leapfrog", True)))
def test_bounces_that_a_step_misses_stop_a_run(files, integrator, right):
    """Energy per mass g h is kept, so that each bounce ends where the first one started."""
    result = run(files / "bouncing.toml", step=0.01, integrator=integrator)
    heights = result.q[result.t > 0.5].max()
    assert (0.0495 < heights < 0.0505) == right
    assert bool(result.failed) != right


@pytest.mark.filterwarnings("ignore:the run stopped")
def test_its_advice_is_enough(files, capsys):
    assert main(["simulate", str(files / "oscillator.toml"), "--step", "0.1"]) == 1
    output = capsys.readouterr()
    step = (output.err + output.out).split("take a step of ")[1].split()[0]
    result = run(files / "oscillator.toml", step=float(step))
    assert np.abs(result.q[:, 0] - np.cos(result.t)).max() < 0.05
    assert not result.failed and math.log2(0.1 / float(step)) < 3
