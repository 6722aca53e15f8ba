"""Hops on a leg with a spring: against another solver, by momentum, and with a controller in C that
reads the force under the foot."""

from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import run
from tests.references import figures, hopper
from tests.support.example_programs import example

SCENE = Path(__file__).parents[2] / "examples/scenes/hopper.toml"
WEIGHT = (hopper.TORSO + hopper.FOOT) * hopper.G


def test_the_figures_are_those_of_the_other_solver() -> None:
    own = list(hopper.figures(hopper.TIMES[:2]))
    assert own == list(figures.read("hopper"))[:len(own)]


@pytest.mark.parametrize("integrator, step, within", [("dop853", None, 1e-7),
                                                      ("leapfrog", 2.5e-4, 2e-5)])
def test_it_hops_as_another_solver_says(integrator: str, step: float | None, within: float
                                        ) -> None:
    """Through the first bounces."""
    until = hopper.TIMES[1]
    result = run(SCENE, until=until, every=until / 2, integrator=integrator, step=step,
                 precision="double")
    wanted = [float(x.value) for x in figures.read("hopper") if float(x.at) <= until]
    assert np.abs(result.q[1:, :2].ravel() - wanted).max() < within


def test_hops_fall_into_step_with_the_motor_and_the_ground_gives_the_weight() -> None:
    """A hop for each thrust; over one the ground gives as much momentum as gravity takes."""
    result = run(SCENE, until=40, every=5e-4, precision="double")
    per = round(1 / hopper.BEAT / 5e-4)
    last, before = (result.q[-(k + 1) * per - 1:len(result.q) - k * per, 0] for k in (0, 1))
    assert np.abs(last - before).max() < 1e-6
    assert last.max() - last.min() > 0.1
    press = result.recorded["contact.foot.force.2"][-per:]
    assert press.mean() == pytest.approx(WEIGHT, rel=1e-3)
    assert 0.2 < np.mean(press == 0) < 0.9  # it flies


def test_a_controller_in_c_hops_to_a_height_by_the_force_under_the_foot(
        tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The last hops reach 0.55 m, the motor pushes, never in flight, and from top to top the ground
    gives as much momentum as gravity takes."""
    t, height, press, motor = example("hop").run(tmp_path).T
    tops = np.flatnonzero((height[1:-1] > height[:-2]) & (height[1:-1] >= height[2:])
                          & (height[1:-1] > 0.5)) + 1
    assert np.abs(height[tops[-5:]] - 0.55).max() < 1e-3 < np.abs(height[tops[:3]] - 0.55).max()
    assert np.all(motor[press <= 0] == 0) and motor.min() < -10 and motor.max() <= 0
    whole = slice(tops[-4], tops[-1])
    assert press[whole].mean() == pytest.approx(WEIGHT, rel=5e-3)
    assert np.diff(t[tops[-5:]]).max() < 0.6
    assert "files" in capsys.readouterr().out
