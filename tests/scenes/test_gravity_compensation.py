"""Actuators that compensate gravity, and torques fed forward to PD controllers."""

import json
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import run
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.integrators import NAMES
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Applied
from tests.support.scenes.effect_laws import assert_same, multiprecise
from tests.support.scenes.effect_scenes import mechanism
from tests.support.scenes.mechanisms import Formula, applied, chain_of_three, gravity, rotor

HALF = Fraction(1, 2)


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def held(joint: str, q: Fraction, **values: object) -> Applied:
    """A stiff controller whose target is q."""
    return applied("actuator", joint, kind="pd", kp=7, kd=2, target=q, gravity_compensation="true",
                   **values)


def test_an_arm_at_its_target_is_held_still() -> None:
    """With a follower, whose weight its leader holds; the acceleration is 0 to 45 digits."""
    q = [Fraction(x, 10) for x in (7, -13, 4)]
    hold = [held(f"j{k}", x) for k, x in enumerate(q)]
    f = multiprecise(chain_of_three(), gravity(1, 2, -9), applied("mimic"), *hold)
    assert_same(f("forward_dynamics", q=q, v=[0] * 3, tau=[0] * 3), [0, 0, 0])
    weights = multiprecise(chain_of_three(), gravity(1, 2, -9), applied("mimic"))
    tau = weights("gravity_torques", q=q)
    assert min(abs(x) for x in tau) > 1
    for k, x in enumerate(tau):
        assert_same([f(f"effect_actuator_j{k}", q=q, v=[0] * 3)], [x])


def test_joints_on_a_free_base_are_compensated() -> None:
    """By their part of gravity_torques, whatever the base's orientation."""
    q = [1, 2, 3, *(mpf(x) / 10 for x in (5, -7, 5, 1)), mpf("0.3"), mpf("-0.4"), 0, 0, 0, 1]
    f = multiprecise(mechanism(), gravity(), held("j1", Fraction(3, 10)))
    tau = multiprecise(mechanism(), gravity())("gravity_torques", q=q)
    assert_same([f("effect_actuator_j1", q=q, v=[0] * 11)], [tau[6]])


def test_a_torque_fed_forward_follows_a_target() -> None:
    """The inertia times the target's acceleration."""
    drive = applied("actuator", "j0", kind="pd", kp=5, kd=2, target=Formula("sin(3*t)"),
                    target_v=Formula("3*cos(3*t)"), torque=Formula("-18*sin(3*t)"))
    f = multiprecise(rotor(2), drive)
    for t in map(mpf, ("0", "0.3", "2")):
        at = {"t": t, "q": [mpmath.sin(3 * t)], "v": [3 * mpmath.cos(3 * t)], "tau": [0]}
        assert_same(f("forward_dynamics", **at), [-9 * mpmath.sin(3 * t)])


ARM = """
GIVEN
[bodies]
upper = { mass = 2, com = [0, 0.1, -0.25], inertia = [0.04, 0.04, 0.002] }
lower = { mass = 1, com = [0.05, 0, -0.2], inertia = [0.01, 0.01, 0.001] }
[joints]
shoulder = { type = "revolute", child = "upper", axis = [0, 1, 0] }
elbow = { parent = "upper", child = "lower", type = "revolute", MIMIC axis = [0, 1, 0], ORIGIN }
[effects.gravity]
[effects.actuator]
joints = "all"
kind = "pd"
kp = 50
kd = 5
target = { shoulder = 0.7, elbow = -1 }
gravity_compensation = true
[start.q]
shoulder = 0.7
elbow = -1
[run]
duration = 2
"""


def written(folder: Path, *changes: tuple[str, str]) -> Path:
    text = ARM.replace("ORIGIN", "origin = { xyz = [0, 0, -0.5] }")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    text = text.replace("GIVEN", "").replace("MIMIC", "")
    path = folder / "arm.toml"
    path.write_text(text)
    return path


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("integrator", NAMES)
def test_every_integrator_holds_it(tmp_path: Path, integrator: str, precision: str) -> None:
    """The deviation is rounding: the holding torques are rounded by a few units of 9 N m, k is 50 N
    m."""
    with mpmath.workdps(15):
        result = run(written(tmp_path), integrator=integrator, precision=precision)
    unit = np.finfo(result.q.dtype).eps
    assert np.abs(np.asarray(result.q, float) - [0.7, -1]).max() <= 8 * unit
    without = run(written(tmp_path, ("gravity_compensation = true", "")), integrator=integrator)
    assert np.abs(without.q - [0.7, -1]).max() > 0.02


def test_a_swinging_arm_keeps_the_balance_of_energy(tmp_path: Path) -> None:
    """The work of the actuators includes their torques against gravity."""
    path = written(tmp_path, ("-1 }\ngravity", '"-1 + 0.5*sin(2*t)" }\ntorque = { shoulder = '
                              '"cos(t)", elbow = 0 }\ngravity'))
    assert main(["check", str(path), "--precision", "double", "--step", "5e-4", "--strict"]) == 0


def test_gravity_at_run_time_is_compensated(tmp_path: Path) -> None:
    path = written(tmp_path, ("GIVEN", 'runtime = ["gravity.g", "upper.mass"]'))
    given = {"gravity.g.x": 3, "gravity.g.z": -1.6, "upper.mass": 9}
    with mpmath.workdps(15):
        result = run(path, p=given)
    assert np.abs(result.q - [0.7, -1]).max() <= 8 * np.finfo(float).eps


def test_a_limit_limits_what_is_compensated_too(tmp_path: Path) -> None:
    path = written(tmp_path, ("kd = 5", "kd = 5\nlimit = 1"))
    result = run(path, record=["actuator.shoulder.torque", "actuator.shoulder.saturated"])
    assert np.abs(result.recorded["actuator.shoulder.torque"]).max() == 1
    assert result.recorded["actuator.shoulder.saturated"][0] == 1
    assert np.abs(result.q - [0.7, -1]).max() > 0.5


MIMIC = 'mimic = { joint = "shoulder" },'


@pytest.mark.parametrize("changes, words", [
    ([("[effects.gravity]\n", "")], "has no gravity; wanted [effects.gravity]"),
    ([("MIMIC", MIMIC), ("[effects.gravity]", "[effects.gravity]\n[effects.mimic]"),
      ("elbow = -1\n[run]", "[run]")],
     "joint 'elbow' follows 'shoulder', which holds its weight"),
    ([("true", "1")], "wanted true or false"), ([("true", '"yes"')], "wanted true or false"),
    ([('kind = "pd"', 'kind = "dc"'), ("kp = 50\nkd = 5\n", "voltage = 1\nkt = 1\nke = 1\nR = 1\n"),
      ("target = { shoulder = 0.7, elbow = -1 }\n", "")],
     "is for kind = 'torque' or 'pd'; the kind is 'dc'"),
    ([("GIVEN", 'runtime = ["actuator.elbow.torque"]')], "not given; wanted a number")])
def test_what_cannot_be_compensated_is_refused(tmp_path: Path, changes: list[tuple[str, str]],
                                               words: str) -> None:
    with pytest.raises(SceneError) as error:
        read_scene(written(tmp_path, *changes))
    assert words in str(error.value)


def test_false_is_the_same_as_nothing(tmp_path: Path) -> None:
    off = read_scene(written(tmp_path, ("true", "false")))
    assert off == read_scene(written(tmp_path, ("gravity_compensation = true\n", "")))
    by_joint = read_scene(written(tmp_path, ("= true", "= { shoulder = true, elbow = false }")))
    assert [x.values["gravity_compensation"] for x in by_joint.effects if x.on] == ["true", None]


def test_the_schema_takes_true_and_false() -> None:
    schema = json.loads((Path(__file__).parents[2] / "generated/docs/scene.schema.json")
                        .read_text())
    flag = schema["definitions"]["actuator"]["properties"]["gravity_compensation"]
    assert flag["type"] == "boolean"
