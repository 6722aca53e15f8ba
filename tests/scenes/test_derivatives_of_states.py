"""Derivatives of steps by the states of effects, which stand at the end of q: differences in 50
digits, within their bounds and beyond, and gradients of runs against differences of runs."""

from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import load_scene, run_adjoint
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.program import ZERO
from coscrew_codegen.scene.function_selection import FunctionsError, all_names
from coscrew_codegen.scene.integrator import Integrator
from coscrew_codegen.scene.integrators import EMITTED, named
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.differentiated import check, check_step, entry
from tests.support.scenes.scene_texts import SLIDER

EXAMPLES = Path(__file__).parents[2] / "examples" / "scenes"

GEARED = """
[bodies]
arm = { mass = 1, com = [0.1, 0, 0.2], inertia = [0.1, 0.1, 0.1] }
hand = { mass = 1, com = [0.1, 0, 0], inertia = [0.1, 0.1, 0.1] }
[joints]
elbow = { type = "revolute", child = "arm", axis = [0, 1, 0] }
wrist = { type = "revolute", parent = "arm", child = "hand", axis = [0, 1, 0] }
[effects.gravity]
[effects.actuator.elbow]
kind = "pd"
kp = 30
kd = 2
target = "0.5*sin(4*t)"
lag = 0.02
[effects.gear.wrist]
k = 200
d = 0.1
rotor = 1e-3
gear = 3
[effects.actuator.wrist]
kind = "pd"
kp = 3
kd = 0.2
target = 0
"""
ROLLING = """
[bodies]
ball = { mass = 1, inertia = [0.004, 0.004, 0.004] }
[joints]
base = { type = "free", child = "ball" }
[effects.gravity]
[effects.contact.ball]
shape = "sphere"
radius = 0.1
mu = 0.5
restitution = 0.5
speed = 1
rolling = 1e-3
[effects.ground]
height = "0.02*sin(3*x)*cos(2*y)"
"""
PAIR = """
[bodies]
low = { mass = 1, inertia = [0.004, 0.004, 0.004] }
high = { mass = 3, inertia = [0.04, 0.04, 0.04] }
[joints]
first = { type = "free", child = "low" }
second = { type = "free", child = "high" }
[effects.gravity]
[effects.contact_pair.both]
bodies = ["low", "high"]
first_radius = 0.1
second_radius = 0.2
mu = 0.5
load = 10
"""
TURN = [0.1, 0.1, -0.7, 0.7]
"""A unit quaternion, as decimals."""
HELD, SLID = [1e-5, 2e-5, 0], [1e-2, -2e-2, 0]
STATES = {
    "stiction": (SLIDER, [0.1, 0.2, 1e-6, 1e-5], [0.01, -0.02]),
    "stiction that slips": (SLIDER, [0.1, 0.2, 1e-4, -1e-2], [0.5, -2]),
    "lag and gear": (GEARED, [0.1, 0.2, 3, 0.21, 0.4], [1, -2]),
    "contact": (ROLLING, [0, 0, 0.0995, *TURN, *HELD], [0.01, 0.02, 0.03, 0.1, -0.2, 0.3]),
    "contact that slips": (ROLLING, [0, 0, 0.0995, *TURN, *SLID], [1, 2, -0.3, 0.1, -0.2, 0.3]),
    "open contact": (ROLLING, [0, 0, 0.5, *TURN, *HELD], [1, 2, 0.3, 0.1, -0.2, 0.3]),
    "pair": (PAIR, [0, 0, 0, *TURN, 0.05, 0.1, 0.27, *TURN, *HELD], [
        0.1, 0.2, -0.3, 0.4, 0.5, -0.6, 0.1, 0, -0.2, 0.3, 0, 0.2])}


def numbers(x: list[float]) -> list[mpf]:
    with mpmath.workdps(50):
        return [mpf(str(y)) for y in x]


@pytest.fixture
def scene(tmp_path: Path, text: str) -> Scene:
    path = tmp_path / "states.toml"
    path.write_text(text)
    return read_scene(path)


CASES = pytest.mark.parametrize("text, q, v", STATES.values(), ids=STATES)


@CASES
@pytest.mark.parametrize("integrator", EMITTED, ids=lambda x: x.name)
def test_steps_are_differentiated_by_states(scene: Scene, q: list[float], v: list[float],
                                            integrator: Integrator) -> None:
    """The tangent is a difference of steps, and the adjoint is its transpose."""
    check(scene, entry(scene, integrator.step_with_tau), q=numbers(q), v=numbers(v),
          h=[mpf("1e-3")])


@CASES
def test_matrices_of_a_step(scene: Scene, q: list[float], v: list[float]) -> None:
    """A, B_tau and B_p are tangents, with rows and columns of x behind those of q."""
    check_step(scene, named("leapfrog"), q=numbers(q), v=numbers(v), h=[mpf("1e-3")])


@pytest.mark.parametrize("name", ["forward_dynamics", "energy", "integrated", "difference",
                                  "contacts"])
@pytest.mark.parametrize("text", [ROLLING])
def test_of_other_functions(scene: Scene, name: str) -> None:
    """States count in all tangents and adjoints, where functions read or return them."""
    check(scene, entry(scene, name), q=numbers([0, 0, 0.0995, *TURN, *HELD]))


def test_matrices_have_rows_of_states(tmp_path: Path) -> None:
    """A sticking block's bristle moves with the block: its rate by v is h, and what it carries over
    is 1."""
    path = tmp_path / "slider.toml"
    path.write_text(SLIDER)
    functions = load_scene(path, functions=["step_leapfrog_derivatives"]).double
    h = 1e-6
    q, v, A, _ = functions.step_leapfrog_derivatives(0.0, h, [5e5], np.zeros(4), np.zeros(2))
    assert A.shape == (6, 6) and q.shape == (4,) and v.shape == (2,)
    assert A[2, 2] == pytest.approx(1, rel=1e-6)
    assert A[2, 4] == pytest.approx(h, rel=1e-2)
    assert np.array_equal(A[2, :2], [0, 0])  # the place of the block moves no bristle
    assert A[4, 2] == pytest.approx(-5e5 * h / 2, rel=1e-3)  # the bristle's force on 2 kg


@CASES
def test_the_chart_has_rows_of_zeros_for_states(scene: Scene, q: list[float], v: list[float]
                                                ) -> None:
    """Each of its numbers has a unit."""
    chart = derive(scene, ["chart"]).named("chart")
    rows = len(q)
    assert [a.quantity.shape for a in chart.program.outputs] == [(rows, len(v))]
    assert len(chart.units) == rows * len(v)
    given = sum(len(x.kind.units("q")) for x in scene.model.joints)
    zeros = chart.program.results[given * len(v):]
    assert zeros and all(x == ZERO for x in zeros)


@pytest.mark.parametrize("text", [GEARED])
def test_units_of_the_chart_are_of_states_over_displacements(scene: Scene) -> None:
    """Two angles; then the torque of a motor with lag, and a rotor's angle and speed."""
    assert derive(scene, ["chart"]).named("chart").units == (
        "1", "1", "1", "1", "N m/rad", "N m/rad", "1", "1", "rad/s/rad", "rad/s/rad")


def test_gradient_of_a_run_through_a_bounce(tmp_path: Path) -> None:
    """By start and states, through steps in parts: differences of runs."""
    path = tmp_path / "ball.toml"
    path.write_text(ROLLING)
    kernels = load_scene(path, functions=["default", "difference"])
    start = np.array([0, 0, 0.13, 0, 0, 0, 1, 0, 0, 0]), np.array([0.3, 0.1, -1, 0.1, 0.2, 0.3])
    cost = np.array([1, 2, 3, 0.5, 0.2, 0.1, 4, 5, 6])

    def run_from(q: np.ndarray, v: np.ndarray) -> object:
        return run_adjoint(kernels, 60, lambda k, q, v: (cost, np.ones(6)) if k == 60 else None,
                           step=1e-3, q0=q, v0=v)

    result = run_from(*start)
    assert result.v[2] > 0.2 and result.g_q.shape == (9,)  # it bounced
    for k, own in enumerate(result.g_v):
        moved = 1e-6 * np.eye(6)[k]
        ends = [run_from(start[0], start[1] + s * moved) for s in (1, -1)]
        phi = kernels.double.difference(*(x.q for x in reversed(ends)))
        by = np.concatenate([phi, (ends[0].q - ends[1].q)[7:], ends[0].v - ends[1].v]) / 2e-6
        assert own == pytest.approx(by @ np.concatenate([cost, np.ones(6)]), rel=1e-6, abs=1e-6)


def test_steps_too_long_for_compilers_are_refused() -> None:
    """A quadruped with bristles under its feet, by four stages: with what to take instead."""
    scene = read_scene(EXAMPLES / "landing.toml")
    with pytest.raises(FunctionsError, match="^landing: step_rk4_derivatives is too long for comp"
                       "ilers, with more than 600,000 .* wanted step_rk4_tangent, .*_rk4_adjoint"):
        derive(scene, ("step_rk4_derivatives",))
    assert {"step_rk4_tangent", "step_rk4_adjoint"} <= {*all_names(scene)}
