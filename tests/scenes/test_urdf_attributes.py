"""Every element and attribute of URDF that is read is known, by version, or refused by its line."""

from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.scene.mechanism.notices import summary
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.urdf.urdf_schema import ATTRIBUTES, CHILDREN
from tests.support.scenes.reading import ARM, read_urdf

FULL = """<robot name="full" version="1.2">
<link name="ground"/>
<link name="tool"><inertial><origin xyz="0 0 0.1" rpy="0 0 0"/><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="tip"><inertial><origin xyz="0 0 0.1" rpy="0 0 0"/><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="lead" type="continuous"><parent link="ground"/><child link="tool"/></joint>
<joint name="hinge" type="revolute"><parent link="tool"/><child link="tip"/>
<origin xyz="0 0 1" rpy="0 0 0.3"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="2" effort="3" velocity="4" acceleration="5" deceleration="6" jerk="7"/>
<dynamics damping="8" friction="9"/><mimic joint="lead" multiplier="2" offset="1"/>
<calibration reference_position="0" rising="0" falling="0"/>
<safety_controller soft_lower_limit="-0.9" soft_upper_limit="1.9" k_position="1" k_velocity="1"/>
</joint></robot>"""
"""A file with every element and most attributes of version 1.2."""


@pytest.fixture
def read(tmp_path):
    def read(text):
        path = tmp_path / "arm.urdf"
        path.write_text(text)
        return read_urdf(path)

    return read


@pytest.fixture
def refused(read):
    """Reads a file; returns the place and the problem for which it is refused."""

    def refused(text):
        with pytest.raises(SceneError) as caught:
            read(text)
        assert "\n" not in str(caught.value)
        return caught.value.where, caught.value.problem

    return refused


def misspellings(name):
    """Case, doubled, missing and exchanged letters."""
    results = {name.capitalize(), name.upper(), name + name[-1], name[:-1], name[1:],
               name[:-2] + name[-1] + name[-2]}
    return sorted(results - {name, ""})


@pytest.mark.parametrize("tag, name", [(tag, name) for tag, names in ATTRIBUTES.items()
                                       for name in names if f" {name}=" in FULL])
def test_misspelt_attributes_of_every_element_are_refused(refused, tag, name):
    for wrong in misspellings(name):
        if wrong in ATTRIBUTES[tag]:
            continue
        start = FULL.rindex(f"<{tag} ")
        place = FULL.index(f" {name}=", start)
        where, problem = refused(f"{FULL[:place]} {wrong}={FULL[place + len(name) + 2:]}")
        assert where.startswith(f"line {1 + FULL.count(chr(10), 0, start)}")
        assert problem.startswith(f"unknown attribute {wrong!r} of <{tag}>; ")


@pytest.mark.parametrize("tag", sorted({tag for tags in CHILDREN.values() for tag in tags}))
def test_misspelt_elements_are_refused(refused, tag):
    known = {tag for tags in CHILDREN.values() for tag in tags}
    for wrong in sorted({*misspellings(tag)[:4]} - known):
        text = FULL.replace(f"<{tag} ", f"<{wrong} ").replace(f"<{tag}>", f"<{wrong}>")
        _, problem = refused(text.replace(f"</{tag}>", f"</{wrong}>"))
        assert f"unknown element <{wrong}>; did you mean <{tag}>?" in problem


@pytest.mark.parametrize("old, new, where, words", [
    ('rpy="0 0 0.3"', 'RPY="0 0 0.3"', "line 9, joint 'hinge'", "did you mean 'rpy'?"),
    ('rpy="0 0 0.3"', 'ryp="0 0 0.3"', "line 9, joint 'hinge'", "did you mean 'rpy'?"),
    ('rpy="0 0 0.3"', 'wxyz="1 0 0 0"', "line 9, joint 'hinge'", "did you mean 'quat_xyzw'?"),
    ('rpy="0 0 0.3"', 'quaternion="1 0 0 0"', "line 9", "did you mean 'quat_xyzw'?"),
    ('rpy="0 0 0.3"', 'euler="0 0 0.3"', "line 9", "did you mean 'rpy'?"),
    ('type="revolute"><parent link="tool"', 'type="revolute" damping="2"><parent link="tool"',
     "line 8, joint 'hinge'", "'damping' of <joint>; it belongs to <dynamics>"),
    ('<axis xyz="0 1 0"/>', '<axis xyz="0 1 0" rpy="0 1 0"/>', "line 9, joint 'hinge'",
     "'rpy' of <axis>; it belongs to <origin>"),
    ('<mass value="1"/>', '<mass value="1" kg="1"/>', "line 3, body 'tool'",
     "'kg' of <mass>; wanted value"),
    ("<inertial>", '<inertial density="1">', "line 3, body 'tool'", "wanted none"),
    ('<link name="ground"/>', '<link name="ground"><mass value="2"/></link>',
     "line 2, body 'ground'", "<mass> stands in <link>; wanted it in <inertial>"),
    ('<link name="ground"/>', '<link name="ground"><origin xyz="0 0 1"/></link>',
     "line 2, body 'ground'", "<origin> stands in <link>; wanted it in <inertial> or <joint>"),
    ('<link name="ground"/>', '<link name="ground"/><limit effort="1"/>', "line 2",
     "<limit> stands in <robot>; wanted it in <joint>"),
    ('<dynamics damping="8" friction="9"/>', '<damping value="8"/>', "line 11, joint 'hinge'",
     "damping is an attribute of <dynamics>"),
    ('ixy="0"', 'ixy="0" iyx="0.1"', "line 4, body 'tool'", "wanted a symmetric matrix"),
])
def test_unknown_names_are_refused_with_what_was_meant(refused, old, new, where, words):
    assert old in FULL
    place, problem = refused(FULL.replace(old, new, 1))
    assert place.startswith(where) and words in problem


def test_what_gazebo_changes_in_the_motion_is_reported(read):
    """Springs with the effect to write; the usual texts change nothing."""
    usual = "<gazebo reference='tip'><gravity>true</gravity><static>0</static><mu1>1</mu1>" \
        "<springStiffness>0.0</springStiffness></gazebo></robot>"
    assert read(FULL.replace("</robot>", usual)).notices == read(FULL).notices
    model = read(FULL.replace("</robot>", """<gazebo><static>true</static></gazebo>
<gazebo reference="tip"><gravity>0</gravity><dampingFactor>0.1</dampingFactor></gazebo>
<gazebo reference="elbow"><springStiffness>7</springStiffness><springReference>0.2</springReference>
</gazebo><gazebo reference="x"><springStiffness>a</springStiffness></gazebo></robot>"""))
    assert [x.text for x in model.notices[len(read(FULL).notices):]] == [
        "robot: <static> 'true' of <gazebo> is not used",
        "tip: <gravity> '0' of <gazebo> is not used",
        "tip: <dampingFactor> '0.1' of <gazebo> is not used",
        "joint elbow: <springStiffness> of <gazebo> is not used: add [effects.spring.elbow] with "
        "k = 7.0 and q0 = 0.2", "joint x: <springStiffness> of <gazebo> is not used"]


@pytest.mark.parametrize("old, new", [
    ("<robot ", '<robot xmlns:xacro="http://ros.org/wiki/xacro" xml:lang="en" '),
    ('<link name="ground"/>', '<link name="ground" type="laser"><contact><inertia_scaling '
     'value="3"/></contact><collision_checking/></link>'),
    ('type="revolute"', 'type="revolute" dont_collapse="true"'),
    ('<axis xyz="0 1 0"/>', '<axis xyz="0 1 0" rpy="0 0 0"/>'),
    ('ixy="0"', 'ixy="0" iyx="0.0"'),
    ('<link name="ground"/>', '<link name="ground"><origin xyz="0 0 0" rpy="0 -0 0"/></link>'),
    ("</robot>", "<ros2_control><joint name='x'/></ros2_control><sensor type='camera'><parent "
     "link='tip'/></sensor><mujoco/><gazebo reference='tip'><Joint/></gazebo><transmission>"
     "<jont/></transmission><group name='arm'/></robot>"),
    ("</inertial></link>", "</inertial><visual><geometry><capsule radius='1' length='2'/>"
     "</geometry></visual><collision><geometry><capsule radius='1' length='2'/></geometry>"
     "</collision></link>")])
def test_other_tools_elements_and_attributes_without_influence_are_free(read, old, new):
    assert old in FULL
    model = read(FULL.replace(old, new, 1))
    assert model == read(FULL) and model.notices == read(FULL).notices


@pytest.mark.parametrize("old, new, text", [
    ('friction="9"', 'friction="9" spring_stiffness="30"', "joint hinge: spring_stiffness 30 of "
     "<dynamics> is another tool's and is not used: add [effects.spring.hinge] with k = 30.0"),
    ('friction="9"', 'friction="9" armature="0.1" stiffness="0"', "joint hinge: armature 0.1 of "
     "<dynamics> is another tool's and is not used: add [effects.armature.hinge] with inertia "
     "= 0.1"),
    ('jerk="7"', 'jerk="7" drake:torque="2"', "joint hinge: drake:torque 2 of <limit> is another "
     "tool's and is not used"),
    ("<axis", '<joint_properties damping="2" friction="0"/><axis', "joint hinge: damping 2 of "
     "<joint_properties> is another tool's and is not used"),
    ("</robot>", '<loop_joint name="close"/></robot>', "joint close: <loop_joint> is another "
     "tool's and is not used"),
    ("</robot>", '<drake:joint name="ball"/></robot>', "joint ball: <drake:joint> is another "
     "tool's and is not used")])
def test_other_tools_physical_numbers_are_told(read, old, new, text):
    assert old in FULL
    model = read(FULL.replace(old, new, 1))
    assert model == read(FULL)
    assert {x.text for x in model.notices} - {x.text for x in read(FULL).notices} == {text}


def test_other_tools_joints_are_told_first(read):
    model = read(FULL.replace("</robot>", '<loop_joint name="a"/><loop_joint name="b"/></robot>'))
    assert summary(model.notices).startswith("not used: other tools' joints of robot, acceleration")


def test_limits_of_version_1_2_and_safety_controllers_are_told(read):
    messages = [x.text for x in read(FULL).notices]
    assert messages[:3] == [f"joint hinge: {name} {number} of <limit> is used by no effect of a "
                            "revolute joint" for name, number in (
                            ("acceleration", 5), ("deceleration", 6), ("jerk", 7))]
    assert [line.split()[2] for line in messages[3:]] == ["soft_lower_limit", "soft_upper_limit",
                                                          "k_position", "k_velocity"]


@pytest.mark.parametrize("kind", ["spherical", "floating"])
def test_numbers_of_joints_with_several_coordinates_are_told(read, kind):
    model = read(FULL.replace('name="hinge" type="revolute"', f'name="hinge" type="{kind}"'))
    messages = [(x.subject, x.text) for x in model.notices if x.text.endswith(f"of a {kind} joint")]
    assert [subject for subject, _ in messages if subject != "safety controller"] == [
        "acceleration", "deceleration", "jerk", "limits", "limits", "effort",
        "velocity", "mimic"]
    assert any(subject == "effort" and f"of <limit> is used by no effect of a {kind} joint" in text
               for subject, text in messages)
    hinge, = (x for x in model.joints if x.name == "hinge")
    assert hinge.friction == 9


def test_fixed_joints_need_no_numbers(read):
    model = read(FULL.replace('name="hinge" type="revolute"', 'name="hinge" type="fixed"'))
    assert model.notices == ()


def test_the_guide_lists_all_attributes():
    guide = Path(__file__).parents[2] / "docs/urdf.md"
    rows = [line for line in guide.read_text().splitlines() if line.startswith("| `")]
    for tag, names in ATTRIBUTES.items():
        row = next(row for row in rows if f"`{tag}`" in row.split("|")[1])
        assert tag in ("calibration", "safety_controller") or all(f"`{x}`" in row for x in names)


# versions

@pytest.mark.parametrize("version", ["2.0", "1", "1.0.0", "1.3", "", "one"])
def test_other_versions_are_refused(refused, version):
    where, problem = refused(FULL.replace('"1.2"', f'"{version}"'))
    assert where == "line 1" and problem == (f"version {version!r} of URDF is unknown; wanted one "
                                             "of 1.0, 1.1, 1.2")


@pytest.mark.parametrize("version", ["1.0", "1.1", "1.2"])
def test_known_versions_are_read(read, version):
    assert read(FULL.replace('"1.2"', f'"{version}"')) == read(FULL.replace(' version="1.2"', ""))


U = 2.0**-53
QUATERNIONS = ("0 0 0.7071067811865476 0.7071067811865476", "0 0 1 1", "0.1 0.2 0.3 0.4",
               "-0.5 0.5 -0.5 0.5", "0 0 0 -2", "3e-3 0 0 4e-3")


@pytest.mark.parametrize("version", ["1.1", "1.2"])
@pytest.mark.parametrize("quaternion", QUATERNIONS)
def test_quaternions_equal_pinocchios(read, version, quaternion):
    """In joints and inertias, normalised as the specification says."""
    pinocchio = pytest.importorskip("pinocchio")
    text = FULL.replace('"1.2"', f'"{version}"').replace(
        'rpy="0 0 0.3"', f'quat_xyzw="{quaternion}"').replace(
        'rpy="0 0 0"', f'quat_xyzw="{quaternion}"').replace('iyy="1"', 'iyy="1.5"')
    model = read(text)
    theirs = pinocchio.buildModelFromXML(text.replace("<mimic", "<!--").replace(
        'offset="1"/>', 'offset="1" -->'))
    R = np.array(model.joints[-1].placement.R, float).reshape(3, 3)
    assert np.abs(R - theirs.jointPlacements[2].rotation).max() < 8 * U  # they round norms, too
    xx, yy, zz, xy, xz, yz = map(float, model.bodies[-1].inertia.moments)
    I = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    assert np.abs(I - theirs.inertias[2].inertia).max() < 16 * 1.5 * U  # theirs rounds R I R^T


def test_a_quarter_turn_by_a_quaternion_is_exact(read):
    joint = read(FULL.replace('rpy="0 0 0.3"', f'quat_xyzw="{QUATERNIONS[0]}"')).joints[-1]
    assert joint.placement.R == (0, -1, 0, 1, 0, 0, 0, 0, 1) and joint.placement.t == (0, 0, 1)


@pytest.mark.parametrize("version, origin, words", [
    ("1.0", 'quat_xyzw="0 0 0 1"', "is of URDF 1.1; wanted <robot version=\"1.1\">, or rpy"),
    ("1.1", 'quat_xyzw="0 0 0 0"', "is zero; wanted x, y, z, w of a unit quaternion"),
    ("1.1", 'quat_xyzw="0 0 1"', "'0 0 1'; wanted 4 numbers"),
    ("1.2", 'quat_xyzw="0 0 0 x"', "'x' is no number"),
    ("1.1", 'rpy="0 0 0" quat_xyzw="0 0 0 1"', "wanted one of both")])
def test_wrong_quaternions_are_refused(refused, version, origin, words):
    where, problem = refused(FULL.replace('"1.2"', f'"{version}"').replace(
        'rpy="0 0 0.3"', origin))
    assert where == "line 9, joint 'hinge'" and words in problem


# elements that occur twice

@pytest.mark.parametrize("once, other", [
    ('<axis xyz="0 1 0"/>', '<axis xyz="0 1.0 0"/>'),
    ('<origin xyz="0 0 1" rpy="0 0 0.3"/>', '<origin rpy="0 0 3e-1" xyz="0 0 1"/>'),
    ('<mass value="1"/>', '<mass value="1.0"/>'),
    ('<limit lower="-1" upper="2" effort="3" velocity="4" acceleration="5" deceleration="6" '
     'jerk="7"/>',) * 2])
def test_elements_that_say_the_same_twice_are_read_once(read, once, other):
    assert once in FULL
    model = read(FULL.replace(once, once + other, 1))
    assert model == read(FULL)
    messages = [x.text for x in model.notices if x.subject == "repeated element"]
    assert len(messages) == 1 and "says the same once more and is not used" in messages[0]


@pytest.mark.parametrize("once, other, element", [
    ('<axis xyz="0 1 0"/>', '<axis xyz="0 1 1"/>', "joint 'hinge'"),
    ('<mass value="1"/>', '<mass value="2"/>', "body 'tool'"),
    ('<parent link="tool"/>', '<parent link="tip"/>', "joint 'hinge'")])
def test_elements_that_differ_and_occur_twice_are_refused(refused, once, other, element):
    where, problem = refused(FULL.replace(once, once + other, 1))
    assert where.endswith(element) and "occurs twice; wanted it once" in problem


# joints that URDF has and coscrew has not

def test_what_replaces_a_universal_joint_is_told_and_works(tmp_path, refused):
    """The two joints that the message names turn a body as the scene's universal joint does."""
    text = ARM.replace('type="continuous"', 'type="universal"')
    assert text != ARM
    _, problem = refused(text)
    assert "type 'universal' is not supported" in problem
    assert "two continuous joints, with a link without <inertial> between them" in problem
    chain = "".join(
        f'<joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{child}"/>'
        f'<axis xyz="{axis}"/></joint>' for name, parent, child, axis in (
            ("one", "w", "a", "1 0 0"), ("two", "a", "b", "0 1 0")))
    path = tmp_path / "cross.urdf"
    path.write_text(f"""<robot name="p"><link name="w"/><link name="a"/><link name="b"><inertial>
<mass value="1"/><inertia ixx="1" iyy="2" izz="2" ixy="0" ixz="0" iyz="0"/></inertial></link>
{chain}</robot>""")
    scene = tmp_path / "cross.toml"
    scene.write_text('''[bodies.b]
mass = 1
inertia = [1, 2, 2]
[joints.cross]
type = "universal"
child = "b"
axis = [1, 0, 0]
axis2 = [0, 1, 0]
''')
    state = [0.5, -0.75], [1.0, 2.0], [3.0, -1.0]
    one, other = (load_scene(x, functions=["inverse_dynamics"]).double.inverse_dynamics(*state)
                  for x in (path, scene))
    np.testing.assert_array_max_ulp(one, other, 8)
