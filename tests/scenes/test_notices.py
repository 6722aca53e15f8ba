"""One line sums up unused numbers; numbers that change the motion come first."""

import re

import pytest

from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.mechanism.notices import SUBJECTS, Notice, by_importance, summary
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene


def chain(joints, extra=""):
    """A robot with so many revolute joints; joint n follows joint n - 1 for n < 4."""
    links = "".join(
        f'<link name="l{n}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" '
        f'ixz="0" iyz="0"/></inertial></link><joint name="j{n}" type="revolute">'
        f'<parent link="l{n - 1}"/><child link="l{n}"/>'
        '<limit lower="-1" upper="1" effort="2" velocity="3"/>'
        f'<dynamics damping="4" friction="{5 if n < 8 else 0}"/>{extra}'
        + (f'<mimic joint="j{n - 1}"/>' if 1 < n < 4 else "") + "</joint>"
        for n in range(1, joints + 1))
    return f'<robot name="chain"><link name="l0"/>{links}</robot>'


@pytest.fixture
def read(tmp_path):
    def read(text, effects=""):
        (tmp_path / "robot.urdf").write_text(text)
        path = tmp_path / "scene.toml"
        path.write_text(f'model = "robot.urdf"\n{effects}')
        return read_scene(path, EFFECTS)

    return read


def test_a_robot_of_101_joints_costs_one_line(read):
    scene = read(chain(101))
    assert len(scene.unused) == 2 + 7 + 5 * 101
    assert summary(scene.notices) == (
        "not used: mimic of 2 joints, friction of 7, damping, limits, effort and velocity of 101 "
        "(add [effects.mimic], [effects.coulomb], [effects.viscous], [effects.limit], "
        "[effects.actuator], [effects.speed_limit]; --verbose lists them with what to write)")


def test_effects_shorten_the_line(read):
    scene = read(chain(9), "[effects.mimic]\n[effects.viscous]\njoints = 'all'\nd = 'model'\n"
                 "[effects.coulomb]\njoints = 'all'\neps = 0.1\ntau_c = 0\n")
    assert summary(scene.notices) == (
        "not used: friction of 7 joints, limits, effort and velocity of 9 (add [effects.limit], "
        "[effects.actuator], [effects.speed_limit]; --verbose lists them with what to write)")


WRONG = """<robot name="r"><link name="l0"/>
<link name="l1"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0"
iyz="0"/></inertial></link><joint name="a" type="revolute"><parent link="l0"/><child link="l1"/>
<limit lower="-1" upper="2" effort="3"/><dynamics damping="4" friction="5" armature="6" K="7"
stiffness="8" spring_reference="9"/></joint>
<link name="l2"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0"
iyz="0"/></inertial></link><joint name="b c" type="prismatic"><parent link="l1"/><child link="l2"/>
<limit lower="-1" upper="1" effort="0"/><dynamics damping="nan" friction="0" rotor_inertia=".5"/>
</joint></robot>"""
"""Numbers that no effect takes for all joints."""


def toml(remedy):
    """A remedy as a table: [effects.viscous], and its keys in lines."""
    table, _, keys = remedy.removeprefix("add ").partition(" with ")
    return f"{table}\n" + re.sub(r", (?=\w+ =)| and (?=\w+ =)", "\n", keys) + "\n"


@pytest.mark.parametrize("robot", [chain(4), WRONG], ids=["all", "wrong"])
@pytest.mark.parametrize("there", ["", "[effects.viscous.j9]\nd = 1\n[effects.limit.j9]\nk = 2\n"])
def test_each_remedy_works_as_it_is_written(read, robot, there):
    if there:  # effects that act on another joint
        robot = robot.replace("</robot>", """
<link name="l9"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0"
iyz="0"/></inertial></link><joint name="j9" type="revolute"><parent link="l0"/><child link="l9"/>
<limit lower="-1" upper="1"/></joint></robot>""")
    scene = read(robot, there)
    messages = [x for x in scene.notices if x.remedy]
    assert len(messages) > 8
    for notice in messages:
        cured = read(robot, there + toml(notice.remedy))
        assert len(cured.effects) > len(scene.effects)
        if "another tool's" not in notice.text:
            assert notice.text not in cured.unused


def test_a_single_notice_is_the_line_and_none_is_none():
    notice = Notice("mimic", "joint a", "joint a: mimic of b is not used")
    assert summary([notice]) == notice.text and summary([]) == ""


def test_what_changes_the_motion_comes_first(read):
    scene = read(chain(4, '<safety_controller k_velocity="1"/>'))
    subjects = [notice.subject for notice in by_importance(scene.notices)]
    assert subjects == sorted(subjects, key=SUBJECTS.index)
    assert list(dict.fromkeys(subjects)) == ["mimic", "friction", "damping", "limits", "effort",
                                             "velocity", "safety controller"]


def test_bodies_and_joints_are_counted_by_their_kind():
    notices = [Notice("repeated element", f"body {name}", "") for name in "ab"]
    assert summary(notices) == "not used: repeated element of 2 bodies (--verbose lists them)"
    assert "repeated element of 3 elements" in summary([*notices, Notice("repeated element",
                                                                         "joint a", "")])


def test_motions_do_not_depend_on_notices(read):
    """Recordings can be run again after a change of numbers that nothing uses."""
    one, other = (read(chain(4), "[effects.gravity]\n"),
                  read(chain(4, '<safety_controller k_velocity="1"/>'), "[effects.gravity]\n"))
    assert one.motion_hash == other.motion_hash and one.content_hash != other.content_hash
