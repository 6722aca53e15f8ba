"""Wrong numbers of URDF's joints are refused where an effect uses them; unused numbers are
reported."""

import pytest

from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.candidates import candidates, limits_of

ROBOT = """<robot name="r" version="{version}"><link name="base"/>
<link name="a"><inertial><mass value="2"/>
<inertia ixx="2" iyy="3" izz="4" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="b"><inertial><mass value="2"/>
<inertia ixx="2" iyy="3" izz="4" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="one" type="revolute"><parent link="base"/><child link="a"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="1" effort="5" velocity="6"/><dynamics damping="1" friction="2"/></joint>
<joint name="two" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/>
{two}
</joint></robot>
"""
LIMIT = "[effects.limit]\njoints = 'all'\nk = 1e6\n"
LIMIT_OF_ONE = "[effects.limit.one]\nk = 1e6\n"
MOTOR = "[effects.actuator]\njoints = 'all'\nkind = 'torque'\ntorque = 1\nlimit = 'model'\n"
VISCOUS = "[effects.viscous]\njoints = 'all'\nd = 'model'\n"
COULOMB = "[effects.coulomb]\njoints = 'all'\neps = 0.01\ntau_c = 'model'\n"
MIMIC = "[effects.mimic]\n"
SPEED = "functions = ['inverse_dynamics']\naccuracy.inverse_dynamics = 1e-3\n"

DBL_MAX = "1.7976931348623157e+308"
WRONG = [
    ('<limit lower="-inf" upper="inf"/>', "lower", LIMIT, "-inf is not finite"),
    (f'<limit lower="-{DBL_MAX}" upper="{DBL_MAX}"/>', "upper", LIMIT, "out of range"),
    ('<limit lower="nan" upper="1"/>', "lower", LIMIT, "nan is not finite"),
    ('<limit lower="1" upper="-1"/>', "lower", LIMIT, "lower limit 1 is above the upper one, -1"),
    ('<limit lower="1" upper="-1"/>', "upper", LIMIT, "lower limit 1 is above the upper one, -1"),
    ('<limit lower="a" upper=""/>', "lower", LIMIT, "'a' is no number"),
    ('<limit lower="-1" upper="1"/><limit lower="-2" upper="1"/>', "lower", LIMIT,
     "<limit> occurs twice, with different numbers"),
    ('<limit effort="-5"/>', "effort", MOTOR, "effort -5; wanted 0 or more"),
    ('<limit effort="inf"/>', "effort", MOTOR, "inf is not finite"),
    ('<limit effort="1" velocity="-1"/>', "velocity", SPEED, "velocity -1; wanted 0 or more"),
    ('<dynamics damping="-1"/>', "damping", VISCOUS, "damping -1; wanted 0 or more"),
    ('<dynamics friction="1e400"/>', "friction", COULOMB, "out of range"),
    ('<dynamics friction="1"/><dynamics friction="3"/>', "friction", COULOMB, "occurs twice"),
    ('<mimic joint="none"/>', "mimic", MIMIC, "mimics 'none', which is no joint"),
    ('<mimic joint="two"/>', "mimic", MIMIC, "mimics itself"),
    ('<mimic/>', "mimic", MIMIC, "<mimic> lacks its 'joint'"),
    ('<mimic joint="one" multiplier="inf"/>', "mimic", MIMIC, "inf is not finite"),
    ('<mimic joint="one"/><mimic joint="one" offset="1"/>', "mimic", MIMIC, "occurs twice"),
]


@pytest.fixture
def read(tmp_path):
    def read(two, tail="", version="1.0"):
        (tmp_path / "robot.urdf").write_text(ROBOT.format(two=two, version=version))
        path = tmp_path / "scene.toml"
        path.write_text(f'model = "robot.urdf"\n{tail}')
        return read_scene(path, EFFECTS)

    return read


@pytest.mark.parametrize("two, field, _, words", WRONG)
def test_wrong_numbers_that_nothing_uses_are_told(read, two, field, _, words):
    scene = read(two, "[effects.gravity]\n")
    messages = [line for line in scene.unused if line.startswith(f"joint two: {field} is not used")]
    assert len(messages) == 1 and words in messages[0]
    assert messages[0].startswith(
        f"joint two: {field} is not used, and cannot be: robot.urdf, line 9")
    assert getattr(scene.model.joints[-1], field) is None


@pytest.mark.parametrize("two, field, effect, words", WRONG)
def test_wrong_numbers_are_refused_where_an_effect_takes_them(read, two, field, effect, words):
    with pytest.raises(SceneError) as caught:
        read(two, effect)
    message = str(caught.value)
    assert "scene.toml: " in message and "joint 'two'" in message and "\n" not in message
    assert "robot.urdf, line 9: " in message
    if field != "upper":  # of both ends the lower one is read first
        assert words in message


@pytest.mark.parametrize("two, effect", [
    ('<limit lower="1" upper="-1"/>', LIMIT_OF_ONE), ('<limit lower="1" upper="-1"/>', VISCOUS),
    ('<limit effort="-1"/>', LIMIT), ('<dynamics damping="-1"/>', COULOMB),
    ('<mimic joint="none"/>', LIMIT),
    ('<limit lower="1" upper="-1"/>', "[effects.limit]\njoints = ['one']\nk = 1\n[effects.limit.two"
     "]\nlower = -1\nupper = 1\nk = 1\n")])
def test_effects_that_do_not_take_a_wrong_number_act(read, two, effect):
    assert read(two, effect).effects


def test_an_effort_of_zero_is_refused_where_a_motor_takes_it(read):
    assert not [line for line in read('<limit effort="0" lower="0" upper="0"/>').unused
                if line.startswith("joint two")]
    with pytest.raises(SceneError, match=r"effects.actuator.limit: 0 of joint 'two'; wanted a pos"):
        read('<limit effort="0"/>', MOTOR)


@pytest.mark.parametrize("given, other", [("lower", "upper"), ("upper", "lower")])
def test_a_missing_end_is_zero_until_version_1_1_and_wrong_in_1_2(read, given, other):
    number = {"lower": "-1", "upper": "1"}[given]
    for version in ("1.0", "1.1"):
        joint = read(f'<limit {given}="{number}"/>', LIMIT, version).model.joints[-1]
        assert (joint.lower, joint.upper) == ((-1, 0) if given == "lower" else (0, 1))
    assert read(f'<limit {given}="{number}"/>', version="1.2").unused
    with pytest.raises(SceneError, match=f"lacks its '{other}', which URDF 1.2 requires"):
        read(f'<limit {given}="{number}"/>', LIMIT, "1.2")


def test_joints_without_numbers_are_left_out_of_all(read):
    assert [applied.on for applied in read("", LIMIT).effects] == ["one"]


def test_followers_that_cannot_follow_are_refused_together(read):
    with pytest.raises(SceneError) as caught:
        read('<mimic joint="three"/></joint><link name="c"/><joint name="three" type="prismatic">'
             '<parent link="base"/><child link="c"/><mimic joint="two"/>', MIMIC)
    assert "joint 'two' cannot follow" in str(caught.value)
    assert "joint 'three' cannot follow" in str(caught.value)


def test_sweeps_name_the_limit_that_they_cannot_use(read):
    scene = read('<limit lower="1" upper="-1" velocity="inf"/>')
    known = candidates(scene, {})
    for name, words in (("start.q.two", "lower limit 1 is above"), ("start.v.two", "inf is not")):
        with pytest.raises(SweepError, match=f"{words}.*; give --sobol {name}=LOW:HIGH"):
            limits_of("--sobol", known[name])
    assert limits_of("--sobol", known["start.q.one"]) == (-1, 1)
