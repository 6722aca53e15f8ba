"""A motor drives up to its speed without load, as closed forms say at 50 digits; a speed limit
brakes beyond; steps of any length stay below."""

import warnings
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import run
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated
from tests.support.scenes.mechanisms import applied, rotor, scene

CLOSE = mpf(10)**-40
HALF = Fraction(1, 2)
INERTIA, LIMIT, SPEED = 3, 6, 4
TIME = mpf(INERTIA) * SPEED / LIMIT
"""T = I speed/limit, the time constant of a motor at full torque."""


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def motor(torque: object = LIMIT, **values: object) -> Evaluated:
    drive = {"kind": "torque", "torque": torque, "limit": LIMIT, "speed": SPEED, **values}
    return Evaluated(scene(rotor(INERTIA), applied("actuator", "j0", **drive)), MULTIPRECISE)


def speeds(f: Evaluated, h: mpf, count: int, v: object) -> list[mpf]:
    """The speeds after each of the default integrator's steps."""
    q, v, results = mpf(0), mpf(v), []
    for _ in range(count):
        q += h / 2 * v
        (a,) = f("midpoint_acceleration", h=h, q=[q], v=[v])
        v += h * a
        q += h / 2 * v
        results.append(v)
    return results


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("v, share", [("-9", 1), ("-0.5", 1), ("0", 1), ("1", "0.75"),
                                      ("3.5", "0.125"), ("4", 0), ("5", 0)])
def test_torque_falls_with_speed_where_it_drives(v: str, share: object, side: int) -> None:
    """The share 1 - v/speed of the limit is left, and all of it in braking."""
    (a,) = motor(side * 99)("forward_dynamics", q=[0], v=[side * mpf(v)], tau=[0])
    assert abs(a - side * mpf(share) * LIMIT / INERTIA) < CLOSE


@pytest.mark.parametrize("v, driven", [("0", 1), ("3.3", 1), ("3.4", "0.9"), ("-9", 1)])
def test_a_demand_below_the_line_is_met(v: str, driven: object) -> None:
    (a,) = motor(1)("forward_dynamics", q=[0], v=[mpf(v)], tau=[0])
    assert abs(a - mpf(driven) / INERTIA) < CLOSE


def test_a_motor_at_full_torque_approaches_its_speed_without_load() -> None:
    """v = speed (1 - e^(-t/T)); twice as many steps err by a quarter."""
    wanted = SPEED * (1 - mpmath.exp(-1))

    def error(count: int) -> mpf:
        return abs(speeds(motor(), TIME / count, count, 0)[-1] - wanted)

    coarse, fine = error(64), error(128)
    assert coarse < mpf("1e-3") * SPEED and mpf("3.8") < coarse / fine < mpf("4.2")


def test_braking_is_at_full_torque() -> None:
    """From -v to rest in the time I v/limit."""
    v, count = mpf(2), 256
    h = INERTIA * v / LIMIT / count
    assert abs(speeds(motor(), h, count, -v)[-1]) < v * mpf("1e-4")


@pytest.mark.parametrize("times", [1, 4, 100, 10**6])
@pytest.mark.parametrize("start", [-9, -1, 0, 3])
@pytest.mark.parametrize("torque", [HALF, LIMIT, 99])
def test_no_step_is_too_long(torque: object, start: int, times: int) -> None:
    """Steps of many times T neither pass the speed without load nor stop short of it."""
    reached = speeds(motor(torque), TIME * times, 40, start)
    assert all(x <= SPEED * (1 + mpf("1e-30")) for x in reached)
    assert reached == sorted(reached)
    if times >= 100:
        assert SPEED - reached[-1] < mpf("1e-6")


def test_a_far_target_is_approached_at_the_speed_without_load() -> None:
    f = motor(kind="pd", kp=10**6, kd=1, target=10**6, torque=None)
    (v,) = speeds(f, TIME * 20, 1, 0)
    assert SPEED * mpf("0.9") < v <= SPEED


# the limit of the speed itself


def limited(d: object, torque: object = LIMIT) -> Evaluated:
    effects = (applied("speed_limit", "j0", speed=SPEED, d=d),
               applied("actuator", "j0", kind="torque", torque=torque))
    return Evaluated(scene(rotor(INERTIA), *effects), MULTIPRECISE)


@pytest.mark.parametrize("side", [1, -1])
def test_a_speed_limit_brakes_only_beyond_it(side: int) -> None:
    for v, wanted in ((4, 0), (5, -7), (3, 0), (-3, 0), (-6, 14)):
        (a,) = limited(7, 0)("forward_dynamics", q=[0], v=[side * v], tau=[0])
        assert abs(a - mpf(side) * wanted / INERTIA) < CLOSE


def test_a_driven_joint_settles_where_the_brake_holds_it() -> None:
    """v = speed + u/d (1 - e^(-d s/I)), s after it reached the limit, within the step's error."""
    d, h = 12, mpf(1) / 512
    reached = INERTIA * mpf(SPEED) / LIMIT
    after = mpf(1) / 4
    wanted = SPEED + mpf(LIMIT) / d * (1 - mpmath.exp(-d * after / INERTIA))
    (*_, v) = speeds(limited(d), h, int((reached + after) / h), 0)
    assert abs(v - wanted) < mpf("1e-5")


@pytest.mark.parametrize("d", [10**2, 10**4, 10**9])
@pytest.mark.parametrize("h", ["0.01", "0.3"])
def test_no_brake_is_too_hard(d: int, h: str) -> None:
    """The step that meets the limit ends at it, within u/d and half the change of the step."""
    reached = speeds(limited(d), mpf(h), 400, "3.9")
    change = mpf(h) * LIMIT / INERTIA
    assert all(SPEED - change / 2 < x < SPEED + mpf(LIMIT) / d + change / 2
               for x in reached if x > SPEED - change / 2)
    assert abs(reached[-1] - SPEED - mpf(LIMIT) / d) < mpf(LIMIT) / d / 100
    assert min(reached) == reached[0]


# scene files


MODEL = """
[bodies]
a = { mass = 1, inertia = [1, 1, 1] }
b = { mass = 1, com = [0, 0, 1], inertia = [1, 1, 1] }
[joints.one]
type = "revolute"
child = "a"
axis = [0, 0, 1]
limits = { velocity = 2, effort = 30 }
[joints.two]
type = "revolute"
parent = "a"
child = "b"
axis = [0, 1, 0]
limits = { velocity = 3 }
"""


@pytest.fixture
def written(tmp_path: Path) -> Callable[[str], Path]:
    def written(text: str) -> Path:
        path = tmp_path / "arm.toml"
        path.write_text(MODEL + text)
        return path

    return written


DRIVE = '[effects.actuator]\njoints = "all"\nkind = "torque"\ntorque = 9\n'


def test_speeds_are_the_models(written: Callable[[str], Path]) -> None:
    """A joint without effort keeps its velocity, which a notice names."""
    made = read_scene(written(f'{DRIVE}limit = "model"\nspeed = "model"\n'))
    assert [(x.values["limit"], x.values["speed"]) for x in made.effects] == [(30, 2), (None, None)]
    assert [x for x in made.unused if "velocity" in x] == [
        "joint two: velocity 3 rad/s is not used: add [effects.speed_limit] with joints = "
        '"all", speed = "model" and d = 1e2']


def test_each_notice_of_a_velocity_is_a_remedy(written: Callable[[str], Path]) -> None:
    before = read_scene(written(""))
    (remedy,) = {x.remedy for x in before.notices if x.subject == "velocity"}
    assert remedy == 'add [effects.speed_limit] with joints = "all", speed = "model" and d = 1e2'
    made = read_scene(written('[effects.speed_limit]\njoints = "all"\nspeed = "model"\nd = 1e2\n'))
    assert [x.values["speed"] for x in made.effects] == [2, 3]
    assert not [x for x in made.unused if "velocity" in x]


@pytest.mark.parametrize("more, says", [
    ("speed = 3\n", "effects.actuator.limit: missing; wanted limit, which speed needs"),
    ('limit = "model"\nspeed = 3\n', "limit: missing; wanted limit, which speed needs"),
    ("limit = 3\nspeed = 0\n", "speed: 0; wanted"),
    ("limit = 3\nspeed = -2\n", "speed: -2; wanted")])
def test_a_speed_without_a_limit_is_refused(written: Callable[[str], Path], more: str, says: str
                                           ) -> None:
    with pytest.raises(SceneError) as error:
        read_scene(written(DRIVE.replace('"all"', '["two"]') + more))
    assert says in str(error.value)


def test_a_motor_of_a_scene_reaches_its_speed_to_rounding(written: Callable[[str], Path]) -> None:
    """By a one-step method of order 4, in both precisions, against v = speed (1 - e^(-t/T))."""
    path = written("""
[effects.actuator.one]
kind = "torque"
torque = 40
limit = 5
speed = 2
[run]
duration = 1
integrator = "rk4"
step = 1e-3
""")
    path.write_text(path.read_text().replace("com = [0, 0, 1], ", ""))
    for precision, close in (("double", 1e-13), ("single", 1e-6)):
        result = run(path, precision=precision)
        wanted = 2 * (1 - np.exp(-5 / 2 / 2 * np.asarray(result.t, float)))
        assert np.abs(np.asarray(result.v, float)[:, 0] - wanted).max() < close


# warnings of runs


FAST = """
[effects.actuator]
joints = "all"
kind = "torque"
torque = { one = 9, two = 0 }
[effects.viscous.two]
d = 1000
[run]
duration = 2
"""


@pytest.mark.parametrize("precision", ["double", "single"])
def test_a_run_names_the_joints_that_pass_the_models_limit(written: Callable[[str], Path],
                                                           precision: str) -> None:
    """Once, with the largest speed; of the fastest member of a batch."""
    path = written(FAST)
    with pytest.warns(RuntimeWarning, match="speed") as warned:
        result = run(path, precision=precision)
    (line,) = (str(x.message) for x in warned)
    fastest = float(np.abs(result.v[:, 0]).max())
    assert line == (f"joint one moves at {fastest:.3g} rad/s, above the model's limit, 2 rad/s; "
                    "[effects.speed_limit] brakes")
    with pytest.warns(RuntimeWarning, match=f"moves at {fastest + 10:.3g} rad/s"):
        run(path, precision=precision, v0=[[0, 0], [10, 0], [-1, 0]])


def test_slow_runs_tell_nothing(written: Callable[[str], Path], capsys: pytest.CaptureFixture
                                ) -> None:
    """A command prints the line once; the brake that it names keeps the speed, and the peace."""
    path = written(FAST)
    assert main(["simulate", str(path)]) == 0
    assert capsys.readouterr().err.count("above the model's limit, 2 rad/s") == 1
    held = '[effects.speed_limit.one]\nspeed = 1.9\nd = 1e3\n[effects.speed_limit.two]\nspeed = 3\n'
    written(FAST + held + "d = 1e3\n")
    assert main(["simulate", str(path)]) == 0
    assert "above the model's limit" not in capsys.readouterr().err
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert 1.85 < np.abs(run(path).v[-1, 0]) < 1.95


def test_followers_have_limits_too(tmp_path: Path) -> None:
    path = tmp_path / "hand.toml"
    path.write_text("""
[bodies]
a = { mass = 1, inertia = [1, 1, 1] }
b = { mass = 1, inertia = [1, 1, 1] }
[joints]
one = { type = "revolute", child = "a", axis = [0, 0, 1] }
[joints.two]
type = "revolute"
parent = "a"
child = "b"
axis = [0, 1, 0]
limits = { velocity = 3 }
mimic = { joint = "one", multiplier = -4 }
[effects.mimic]
[start.v]
one = 1
""")
    with pytest.warns(RuntimeWarning, match="joint two moves at 4 rad/s, above the model's limit"):
        run(path, until=0.1)
