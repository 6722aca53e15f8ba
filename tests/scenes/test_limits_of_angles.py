"""Ends of the range of joints that turn about a point: limits of the angle from rest.

Hunt and Crossley's law along the axis of the rotation, in 50 digits, and MuJoCo's ball joints."""

from collections.abc import Iterator
from fractions import Fraction

import mpmath
import mujoco
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import load_scene, run
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.differences import check
from tests.support.scenes.effect_laws import assert_same, multiprecise
from tests.support.scenes.mechanisms import applied, ball, scene

HALF = Fraction(1, 2)
RANGE = applied("limit", "j0", upper=HALF, k=40, alpha=HALF)


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def quaternion(turned: list[mpf]) -> list[mpf]:
    angle = mpmath.norm(mpmath.matrix(turned))
    return [*(x / angle * mpmath.sin(angle / 2) for x in turned), mpmath.cos(angle / 2)]


@pytest.mark.parametrize("turned", ([0.3, -0.6, 0.2], [0.1, 0.2, -0.1], [0, 0, 1.4]))
@pytest.mark.parametrize("w", ([0.3, -0.2, 0.9], [-0.5, 0.7, -2.1]))
def test_the_torque_is_along_the_axis_of_the_rotation(turned, w):
    """τ = -k δ^1.5 (1 + 1.5 α θ') n, never above 0, δ = θ - upper; energy 0.4 k δ^2.5."""
    r, v = ([mpf(x) for x in y] for y in (turned, w))
    angle = mpmath.norm(mpmath.matrix(r))
    n = [x / angle for x in r]
    depth = max(angle - mpf(1) / 2, mpf(0))
    rate = sum(x * y for x, y in zip(n, v, strict=True))
    size = -max(40 * depth**mpf(1.5) * (1 + mpf("0.75") * rate), mpf(0))
    made = ball(moments=(2, 2, 2, 0, 0, 0))
    f, g = (multiprecise(made, *effects) for effects in ((RANGE,), ()))
    x = {"q": quaternion(r), "v": v}
    more = [a - b for a, b in zip(*(y("bias_torques", **x) for y in (f, g)), strict=True)]
    assert_same(more, [-size * y for y in n])
    assert_same(f.components("effect_limit_j0", **x)[:1], [size])
    assert_same(f("energy", **x)[1:], [mpf(16) * depth**mpf(2.5)])


def test_derivatives_are_differences():
    check(scene(ball(), applied("limit", "j0", upper=Fraction(1, 100), k=4, alpha=HALF)))


TOML = """[bodies]
bob = { mass = 1, com = [0, 0, -0.5], inertia = [0.02, 0.02, 0.01] }
[joints.neck]
type = "spherical"
child = "bob"
limits = { upper = 0.3 }
[effects.gravity]
[effects.limit.neck]
k = 5e3
[outputs]
record = ["q", "energy", "limit.neck.torque"]
[start.v]
neck = [0.7, 1.3, 0.4]
[run]
duration = 1
"""


def test_a_pendulum_bounces_within_its_cone(tmp_path):
    path = tmp_path / "bob.toml"
    path.write_text(TOML)
    result = run(path)
    q = np.array([result.recorded[f"q.neck.{x}"] for x in range(4)])
    angle = 2 * np.arctan2(np.linalg.norm(q[:3], axis=0), np.abs(q[3]))
    assert 0.3 < angle.max() < 0.33 and (angle < 0.29).any()
    energy = sum(result.recorded[f"energy.{kind}"] for kind in ("kinetic", "potential"))
    assert np.ptp(energy) < 1e-3 * np.ptp(result.recorded["energy.kinetic"])


@pytest.mark.parametrize("integrator", ["leapfrog", "rk4", "linear-implicit-euler", "dop853"])
def test_a_start_outside_the_cone_is_told_and_pushed_back(tmp_path, integrator):
    path = tmp_path / "bob.toml"
    text = TOML.replace("[start.v]\nneck = [0.7, 1.3, 0.4]", "[start.q]\nneck = [0, 0.6, 0, 0.8]")
    path.write_text(text.replace("duration = 1", "duration = 0.05\nstep = 1e-4\n"
                                 f'integrator = "{integrator}"'))
    with pytest.warns(RuntimeWarning, match="joint neck starts at 1.287, outside its range from "
                                            "-inf to 0.3: pushed from the start"):
        result = run(path)
    assert result.recorded["q.neck.1"][1] == pytest.approx(0.273, abs=1e-3)


@pytest.mark.parametrize(("old", "new", "words"), (
    ("upper = 0.3 }", "upper = 0.3, lower = 0 }", "limits.lower: unknown key; wanted upper"),
    ("upper = 0.3 }", "upper = 0 }", "upper: 0"),
    ("k = 5e3", "k = 5e3\nlower = 0.1", "joint 'neck' turns about a point: its angle is 0 or more; "
     "wanted upper alone"),
    ("k = 5e3", "k = 5e3\nupper = -1", "-1 for joint 'neck', which turns about a point; wanted an "
     "angle above 0")))
def test_wrong_ranges_are_refused(tmp_path, old, new, words):
    path = tmp_path / "bob.toml"
    path.write_text(TOML.replace(old, new))
    with pytest.raises(SceneError) as caught:
        read_scene(path)
    assert words in str(caught.value), caught.value


def test_ranges_of_mujocos_ball_joints_are_those_of_the_angle(tmp_path):
    """The distance from the end and the direction of its row."""
    path = tmp_path / "ball.xml"
    path.write_text('<mujoco><compiler angle="radian"/><option gravity="0 0 0"/><worldbody><body>'
                    '<joint name="neck" type="ball" range="0 0.4" limited="true"/><geom size="0.1" '
                    'pos="0 0 0.3"/></body></worldbody></mujoco>')
    scene = read_scene(path)
    assert scene.model.joints[0].upper == Fraction(2, 5)
    assert ('joint neck: upper 0.4 rad is not used: add [effects.limit] with joints = "all" and '
            "k = 1e4") in scene.unused
    (tmp_path / "scene.toml").write_text(f'model = "{path.name}"\n[effects.limit]\njoints = "all"\n'
                                         "k = 10\n")
    ours = load_scene(tmp_path / "scene.toml", functions=["bias_torques"]).double
    model_there = mujoco.MjModel.from_xml_path(str(path))
    data, rng = mujoco.MjData(model_there), np.random.default_rng(4)
    for _ in range(4):
        x, y, z, w = rng.normal(size=4) * [1, 1, 1, 0.5]
        data.qpos[:] = np.array([w, x, y, z]) / np.linalg.norm([w, x, y, z])
        mujoco.mj_forward(model_there, data)
        torque = -ours.bias_torques(np.roll(data.qpos, -1), np.zeros(3))
        wanted = 10 * max(0.0, -data.efc_pos[0])**1.5 * data.efc_J.reshape(-1, 3)[0]
        assert np.abs(torque - wanted).max() < 1e-13 * 10
