"""The table [ranges] of a scene: intervals of the arguments of functions, each read or refused by
name."""

from fractions import Fraction
from math import inf, nextafter
from pathlib import Path

import pytest

from coscrew_codegen.scene.mechanism.ranges import QUATERNION, UNSTATED
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene

ARM = """
name = "arm"
runtime = ["tip.mass"]
[bodies.a]
mass = 1
[bodies.b]
mass = 1
[bodies.c]
mass = 1
[bodies.tip]
mass = 0.5
[joints.base]
type = "free"
child = "a"
[joints.one]
type = "revolute"
parent = "a"
child = "b"
axis = [0, 0, 1]
limits = { lower = -1, upper = 2.1, velocity = 3.15, effort = 10 }
[joints.two]
type = "continuous"
parent = "b"
child = "c"
axis = [0, 1, 0]
[joints.ball]
type = "spherical"
parent = "c"
child = "tip"
[run]
duration = 2
"""
FAULTY = """<robot name="arm"><link name="a"><inertial><mass value="1"/><inertia ixx="1" iyy="1"
izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link><link name="w"/><joint name="one"
type="revolute"><parent link="w"/><child link="a"/><limit lower="-1" upper="inf" effort="1"
velocity="1"/></joint></robot>"""
ANYWHERE = (UNSTATED,) * 3 + QUATERNION
OVER = 3.15 if Fraction(3.15) >= Fraction("3.15") else nextafter(3.15, inf)
ACCEPTED = (
    ("", "q", (*ANYWHERE, (-1, 2.1), UNSTATED, *QUATERNION)),
    ("", "v", (*[UNSTATED] * 6, (-OVER, OVER), *[UNSTATED] * 4)),
    ("", "a", (UNSTATED,) * 11),
    ("", "tau", (UNSTATED,) * 11),
    ("", "p", ((-0.5, 0.5),)),
    ("", "t", (UNSTATED,)),
    ("q = 2", "q", (*[(-2, 2)] * 3, *QUATERNION, (-2, 2), (-2, 2), *QUATERNION)),
    ('q = { base = [1, 2, { lower = 0, upper = 3 }], one = "limits", two = 4 }', "q",
     ((-1, 1), (-2, 2), (0, 3), *QUATERNION, (-1, 2.1), (-4, 4), *QUATERNION)),
    ('q = [[1, 2, 3], "limits", { lower = -1, upper = 3 }, []]', "q",
     ((-1, 1), (-2, 2), (-3, 3), *QUATERNION, (-1, 2.1), (-1, 3), *QUATERNION)),
    ("v = 0", "v", ((0, 0),) * 11),
    ("v = { base = 2 }", "v", (*[(-2, 2)] * 6, (-OVER, OVER), *[UNSTATED] * 4)),
    ("a = [[1, 2, 3, 4, 5, 6], 7, 8, [9, 10, 11]]", "a", tuple((-k, k) for k in range(1, 12))),
    ('tau = { one = "limits" }', "tau", (*[UNSTATED] * 6, (-10, 10), *[UNSTATED] * 4)),
    ('p = { "tip.mass" = { lower = 0, upper = 0.25 } }', "p", ((0, 0.25),)),
    ("t = 5", "t", ((0, 5),)),
    ("t = { lower = -1, upper = 5 }", "t", ((-1, 5),)))
ONE = "a number, its largest size, or { lower = …, upper = … }"
REFUSED = (
    ('v = "limits"', "ranges.v: \"limits\": joint 'base' has no limit of its velocity; wanted v = "
     f"{{ base = … }} with {ONE}"),
    ('q = { two = "limits" }', "ranges.q.two: \"limits\": joint 'two' has no limits of its range; "
     f"wanted q = {{ two = … }} with {ONE}"),
    ('a = "limits"', f'ranges.a: "limits": a model has no limits of a; wanted {ONE}'),
    ("velocity = 1", "ranges.velocity: unknown key; wanted one of a, p, q, t, tau, v"),
    ("q = [1, 2]", "ranges.q: a list of 2; wanted an entry for each of the 4 joints: base, one, "
     "two, ball"),
    ("q = { oen = 1 }", "ranges.q.oen: no joint with coordinates of its own 'oen'; did you mean "
     "'one'?"),
    ("q = { base = [1, 2] }", "ranges.q.base: a list of 2 for joint 'base'; wanted 3 entries, "
     "quaternions left out"),
    ("q = { ball = 1 }", "ranges.q.ball: joint 'ball' has only a quaternion, of norm 1; wanted no "
     "range, in a list of all joints []"),
    ("v = -1", f"ranges.v: -1; wanted 0 or more: {ONE}"),
    ("v = true", f"ranges.v: the boolean true; wanted {ONE}"),
    ("q = { one = { lower = 2, upper = 1 } }", "ranges.q.one.lower: 2 is above upper, 1"),
    ("q = { one = { lower = 2 } }", "ranges.q.one.upper: missing; wanted a number"),
    ("q = { one = { lower = 2, uper = 3 } }", "ranges.q.one.uper: unknown key; did you mean "
     "'upper'?"),
    ("p = 1", "ranges.p: the number 1; wanted a table"),
    ('p = { "tip.mas" = 1 }', "ranges.p.'tip.mas': no run-time parameter 'tip.mas'; did you mean "
     "'tip.mass'?"),
    ("t = [1]", f"ranges.t: a list of 1; wanted {ONE}"))


def read(text: str, tmp_path: Path, arm: str = ARM):
    path = tmp_path / "arm.toml"
    path.write_text(f"{arm}[ranges]\n{text}\n", encoding="utf-8")
    return read_scene(path, overrides=SceneOverrides(implausible="warn"))


@pytest.mark.parametrize(("text", "argument", "intervals"), ACCEPTED)
def test_each_component_has_its_interval(text, argument, intervals, tmp_path):
    ranges = read(text, tmp_path).ranges
    assert ranges.by_name[argument] == intervals
    assert ranges.quaternions == (3, 9)


@pytest.mark.parametrize(("text", "message"), REFUSED)
def test_refusals_name_what_came_and_what_was_wanted(text, message, tmp_path):
    with pytest.raises(SceneError) as error:
        read(text, tmp_path)
    assert str(error.value).partition(": ")[2].startswith(message)


def test_intervals_hold_the_decimals_that_are_written(tmp_path):
    """0.1 as a double is above 1/10, 0.7 below 7/10: both ends are rounded outwards."""
    for text in ("0.1", "0.7", "3.15", "1e-3"):
        (low, high) = read(f"v = {text}", tmp_path).ranges.v[0]
        assert Fraction(low) <= -Fraction(text) and Fraction(text) <= Fraction(high)
        assert Fraction(nextafter(high, 0)) < Fraction(text)


def test_limits_in_ranges_are_used(tmp_path):
    whole = 'q = "limits"\nv = { one = 1 }'
    arm = ARM.replace('type = "free"', 'type = "fixed"').replace("spherical", "fixed").replace(
        'type = "continuous"\nparent = "b"\nchild = "c"\naxis = [0, 1, 0]',
        'type = "fixed"\nparent = "b"\nchild = "c"')
    effort, velocity = read(whole, tmp_path, arm).unused
    assert effort.startswith("joint one: effort 10 N m is not used: add [effects.actuator]")
    assert velocity.startswith("joint one: velocity 3.15 rad/s is ")
    assert not read('tau = "limits"', tmp_path, arm).unused


def test_limits_that_cannot_be_used_are_refused_where_ranges_need_them(tmp_path):
    (tmp_path / "arm.urdf").write_text(FAULTY, encoding="utf-8")
    with pytest.raises(SceneError, match=r"ranges.q: joint 'one' has no upper that can be used"):
        read("v = 1", tmp_path, 'model = "arm.urdf"\n')
    assert read("q = 1", tmp_path, 'model = "arm.urdf"\n').ranges.q == ((-1, 1),)


def test_without_the_table_a_scene_has_no_ranges(tmp_path):
    path = tmp_path / "arm.toml"
    path.write_text(ARM, encoding="utf-8")
    scene = read_scene(path, overrides=SceneOverrides(implausible="warn"))
    ranged = read("v = 1", tmp_path)
    assert scene.ranges is None and ranged.ranges is not None
    assert scene.content_hash != ranged.content_hash and scene.motion_hash == ranged.motion_hash
