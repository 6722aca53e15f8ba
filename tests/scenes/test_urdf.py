"""URDF files give Pinocchio's masses, placements and axes; an error in one is reported with its
line."""

from fractions import Fraction as F
from functools import partial

import numpy as np
import pytest

from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.mechanism.model import Inertia, Mimic
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.example_effects import CATALOGUE
from tests.support.scenes.kinds import Kind
from tests.support.scenes.reading import ARM, read_urdf
from tests.support.scenes.robots import robots
from tests.support.work import calls_of

WRONG = {
    "romeo_small.urdf": ("body 'RShoulderYawLink'", "no distribution of mass"),
    "romeo_laas_small.urdf": ("body 'body'", "not positive definite"),
    "ur3.urdf": ("model", "has no bodies"),
}
"""Files of example-robot-data that are wrong, with what is: moments that no body has, and a file
that holds nothing but the comment of its generator."""

SNAPPED = 1.1e-11  # largest difference of an entry where a right angle was snapped

ROBOTS = robots()
RIGHT = [path for path in ROBOTS if path.name not in WRONG]


@pytest.mark.parametrize("path", [p for p in ROBOTS if p.name in WRONG], ids=lambda p: p.name)
def test_wrong_robots_are_refused_by_element(path):
    element, words = WRONG[path.name]
    with pytest.raises(SceneError) as caught:
        read_urdf(path)
    assert caught.value.where.startswith("line ") and caught.value.where.endswith(element)
    assert words in str(caught.value)


@pytest.mark.parametrize("path", RIGHT, ids=lambda p: p.name)
def test_robots_equal_pinocchios(path):
    """Each body's placement in its parent, at rest, and the axis of the joint between them."""
    pinocchio = pytest.importorskip("pinocchio")
    model, theirs = read_urdf(path), pinocchio.buildModelFromUrdf(str(path))
    data = theirs.createData()
    pinocchio.computeJointJacobians(theirs, data, pinocchio.neutral(theirs))
    pinocchio.updateFramePlacements(theirs, data)
    frames = {body.name: data.oMf[theirs.getFrameId(body.name, pinocchio.FrameType.BODY)]
              for body in model.bodies} | {"world": pinocchio.SE3.Identity()}
    for joint in model.joints:
        child = frames[joint.child]
        relative = frames[joint.parent].inverse() * child
        R = np.array(joint.placement.R, float).reshape(3, 3)
        assert np.abs(R - relative.rotation).max() < SNAPPED, joint.child
        t = np.array(joint.placement.t, float)
        scale = max(1, np.abs(child.translation).max())
        assert np.abs(t - relative.translation).max() < 1e-14 * scale, joint.child
        if joint.kind in (Kind.REVOLUTE, Kind.PRISMATIC):
            column = data.J[:, theirs.joints[theirs.getJointId(joint.name)].idx_v]
            line = column[3:] if joint.kind is Kind.REVOLUTE else column[:3]
            axis = child.rotation.T @ line
            assert np.abs(axis - np.array(joint.axis, float)).max() < SNAPPED, joint.name


@pytest.mark.parametrize("path", RIGHT, ids=lambda p: p.name)
def test_masses_equal_pinocchios(path):
    """Mass, centre of mass and moments, at rest, of the whole robot and of every link."""
    pinocchio = pytest.importorskip("pinocchio")
    model, theirs = read_urdf(path), pinocchio.buildModelFromUrdf(str(path))
    poses, ours = poses_at_rest(model), {}
    head = {"world": "universe"}
    for body, joint in zip(model.bodies, model.joints, strict=True):
        head[body.name] = head[joint.parent] if joint.kind is Kind.FIXED else joint.name
        if body.inertia:
            ours.setdefault(head[body.name], []).append((body.inertia, poses[body.name]))
    data = theirs.createData()
    pinocchio.forwardKinematics(theirs, data, pinocchio.neutral(theirs))
    for number in range(1, theirs.njoints):
        at, inertia = data.oMi[number], theirs.inertias[number]
        matrix = at.act(inertia).matrix()
        own = sum((world_inertia(x, pose) for x, pose in ours.get(theirs.names[number], [])),
                  np.zeros((6, 6)))
        scale = max(1e-3, np.abs(matrix).max())
        assert np.abs(own - matrix).max() < 1e-9 * scale, theirs.names[number]


@pytest.mark.parametrize("path", RIGHT, ids=lambda p: p.name)
def test_reading_takes_little_work_for_each_joint(path):
    assert calls_of(partial(read_urdf, path)) < 10_000 * (1 + path.read_text().count("<joint"))


def poses_at_rest(model):
    """4×4 poses of all bodies in the world while all coordinates are zero."""
    poses = {"world": np.eye(4)}
    for joint in model.joints:
        own = np.eye(4)
        own[:3, :3] = np.array(joint.placement.R, float).reshape(3, 3)
        own[:3, 3] = np.array(joint.placement.t, float)
        poses[joint.child] = poses[joint.parent] @ own
    return poses


def world_inertia(inertia, pose):
    """[[m 1, -m c~], [m c~, I - m c~²]] about the world's origin, along its axes."""
    xx, yy, zz, xy, xz, yz = map(float, inertia.moments)
    R, m = pose[:3, :3], float(inertia.mass)
    I = R @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ R.T
    x, y, z = R @ np.array(inertia.com, float) + pose[:3, 3]
    c = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.block([[m * np.eye(3), -m * c], [m * c, I - m * c @ c]])


# single elements



@pytest.fixture
def read(tmp_path):
    def read(text=ARM, base=Kind.FIXED, name="arm.urdf"):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return read_urdf(path, base)

    return read


def test_every_number_of_the_file_arrives(read):
    model = read()
    assert [joint.name for joint in model.joints] == ["base", "shoulder", "elbow", "tip"]
    assert [body.name for body in model.bodies] == ["foot", "upper", "tool", "frame"]
    base, shoulder, elbow, tip = model.joints
    assert (base.kind, base.parent, base.child) == (Kind.FIXED, "world", "foot")
    assert shoulder.axis == (0, 1, 0) and elbow.axis == (1, 0, 0)
    assert (shoulder.lower, shoulder.upper, shoulder.effort, shoulder.velocity) == (-1, F(3, 2),
                                                                                    100, 2)
    assert (shoulder.damping, shoulder.friction) == (F(1, 2), F(1, 8))
    assert (elbow.lower, elbow.upper, elbow.effort, elbow.velocity) == (None, None, 9, 3)
    assert (elbow.damping, elbow.friction) == (F(1, 4), None)
    assert elbow.mimic == Mimic("shoulder", F(-2), F(1, 2))
    assert elbow.placement.t == (0, 0, F(1, 2))
    assert tip.kind is Kind.FIXED
    foot, upper, _, frame = model.bodies
    assert foot.inertia is None and frame.inertia is None
    assert upper.inertia == Inertia(F(3, 2), (0, 0, F(1, 4)),
                                    (F(1, 5), F(1, 10), F(3, 20), F(-1, 100), 0, 0))


def test_bases(read):
    free = read(base=Kind.FREE).joints[0]
    assert (free.name, free.kind, free.child) == ("base", Kind.FREE, "foot")
    taken = read(ARM.replace('name="tip"', 'name="base"'), Kind.FREE).joints
    assert [joint.name for joint in taken] == ["base_", "shoulder", "elbow", "base"]


def test_a_root_called_world_is_the_world(read):
    model = read(ARM.replace('"foot"', '"world"'))
    assert [joint.name for joint in model.joints] == ["shoulder", "elbow", "tip"]
    assert model.joints[0].parent == "world"
    with pytest.raises(SceneError, match="cannot move freely"):
        read(ARM.replace('"foot"', '"world"'), Kind.FREE)


def test_followers_of_followers_follow_the_leader(read):
    text = ARM.replace("</robot>", """
        <link name="finger"><inertial><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <joint name="pinch" type="prismatic"><parent link="tool"/><child link="finger"/>
        <mimic joint="elbow" multiplier="3" offset="1"/></joint></robot>""")
    pinch = read(text).joints[-1]
    assert pinch.mimic == Mimic("shoulder", F(-6), F(5, 2))


def test_encodings(read):
    assert read(ARM.replace('version="1.0"', 'version="1.0" encoding="utf-16"').encode("utf-16"))
    latin = ARM.replace('version="1.0"', 'version="1.0" encoding="iso-8859-1"')
    model = read(latin.replace('"tip"', '"été"').encode("latin-1"))
    assert model.joints[-1].name == "été"


def test_a_file_alone_is_a_scene_without_effects(tmp_path):
    path = tmp_path / "6-arm.urdf"
    path.write_text(ARM)
    scene = read_scene(path, CATALOGUE)
    assert (scene.name, scene.effects) == ("scene_6_arm", ())
    assert scene.unused[0] == ("joint shoulder: damping 0.5 N m s/rad is not used: "
                               'add [effects.viscous] with joints = "all" and d = "model"')
    assert len(scene.unused) == 6 + 4 + 2
    assert scene.unused[-1] == ("joint elbow: upper -5 of <limit> is used by no effect of a "
                                "continuous joint")


def test_a_scene_names_its_file_beside_it(tmp_path):
    (tmp_path / "models").mkdir()
    (tmp_path / "models/arm.urdf").write_text(ARM)
    scene_file = tmp_path / "swing.toml"
    scene_file.write_text('model = "models/arm.urdf"\nbase = "free"\n[start.q]\n'
                          "base = [0, 0, 1, 0, 0, 0, 1]\n")
    scene = read_scene(scene_file, CATALOGUE)
    assert scene.model == read_urdf(tmp_path / "models/arm.urdf", Kind.FREE)
    assert scene.start_q == {"base": (0, 0, 1, 0, 0, 0, 1)}


@pytest.mark.parametrize("model, words", [
    ("arm.urd", "has the suffix '.urd'; wanted a model ("),
    ("arm.urd", "); did you mean '.urdf'?"), ("arm.URDF2", "); did you mean '.urdf'?"),
    ("none.urdf", "there is no such file"), (".", "has no suffix; wanted a model (")])
def test_files_that_are_not_there(tmp_path, model, words):
    path = tmp_path / "arm.toml"
    path.write_text(f'model = "{model}"\n')
    with pytest.raises(SceneError, match="arm.toml: model: ") as caught:
        read_scene(path, CATALOGUE)
    assert words in str(caught.value)


@pytest.mark.parametrize("old, new, element, words", [
    ('type="continuous"', 'type="hinge"', "joint 'elbow'", "wanted one of revolute, continuous"),
    ('type="continuous"', 'type="universal"', "joint 'elbow'",
     "type 'universal' is not supported"),
    ('type="continuous"', "", "joint 'elbow'", "lacks its 'type'"),
    ('name="elbow"', "", "<joint>", "lacks its 'name'"),
    ('name="elbow"', 'name="shoulder"', "joint 'shoulder'", "given to two"),
    ('<link name="frame"/>', '<link name="tool"/>', "body 'tool'", "given to two"),
    ('<child link="tool"/>', "", "joint 'elbow'", "lacks <child>"),
    ('<child link="tool"/>', '<child link="tol"/>', "joint 'elbow'", "did you mean 'tool'?"),
    ('<parent link="upper"/>', '<parent link="uper"/>', "joint 'elbow'", "did you mean 'upper'?"),
    ('<parent link="foot"/>', '<parent link="frame"/>', "joint", "loop"),
    ('<parent link="upper"/>', '<parent link="frame"/>', "joint", "loop"),
    ('<child link="frame"/>', '<child link="upper"/>', "body 'upper'", "two joints"),
    ("</robot>", '<link name="lost"/></robot>', "body 'lost'", "several roots"),
    ('xyz="0 2 0"', 'xyz="0 0 0"', "joint 'shoulder'", "the axis is zero"),
    ('xyz="0 2 0"', 'xyz="0 2"', "joint 'shoulder'", "wanted 3 numbers"),
    ('xyz="0 2 0"', 'xyz="0 nan 0"', "joint 'shoulder'", "nan is not finite"),
    ('xyz="0 2 0"', 'xyz="0 2 O"', "joint 'shoulder'", "'O' is no number"),
    ('<axis xyz="0 2 0"/>', "<axis/>", "joint 'shoulder'", "lacks its 'xyz'"),
    ('value="1.5"', 'value="inf"', "body 'upper'", "not finite"),
    ('value="1.5"', 'value="-1.5"', "body 'upper'", "wanted a positive mass"),
    ('value="1.5"', 'value="0"', "body 'upper'", "its mass is zero"),
    ('value="1.5"', 'value="1,5"', "body 'upper'", "'1,5' is no number"),
    ('value="1.5"', 'value="1e999"', "body 'upper'", "out of range"),
    ('value="1.5"', 'value="1e99999999999"', "body 'upper'", "no number"),
    ('value="1.5"', "", "body 'upper'", "lacks its 'value'"),
    ('<mass value="1.5"/>', "", "body 'upper'", "lacks <mass>"),
    ('<mass value="1.5"/>', '<mass value="1"/><mass value="2"/>', "body 'upper'", "occurs twice"),
    ('iyy="0.2"', "", "body 'upper'", "lacks its 'iyy'"),
    ('iyy="0.2"', 'iyy="0.3"', "body 'upper'", "no distribution of mass"),
    ('ixy="0.01"', 'ixy="0.2"', "body 'upper'", "not positive definite"),
    ('<dynamics damping="0.25"/>', '<dynamcs damping="0.25"/>', "joint 'elbow'", "<dynamics>?"),
    ('<robot name="arm">', '<robot name="arm"><xacro:include file="x"/>', "line 2", "xacro"),
])
def test_wrong_elements_are_named_with_their_line(read, old, new, element, words):
    assert old in ARM
    with pytest.raises(SceneError) as caught:
        read(ARM.replace(old, new, 1))
    assert element in caught.value.where and caught.value.where.startswith("line ")
    assert words in str(caught.value) and "\n" not in str(caught.value)


def test_the_line_is_the_elements(read):
    with pytest.raises(SceneError, match=r"arm.urdf: line 8, body 'upper': 'value' of <mass>"):
        read(ARM.replace('value="1.5"', 'value="x"'))


def test_thin_plates_with_rounded_moments_are_possible(read):
    """xx + yy = zz: rounding to six digits may leave zz above."""
    plate = ARM.replace('ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"',
                        'ixx="0.123456" ixy="0" ixz="0" iyy="0.234567" iyz="0" izz="{}"')
    assert read(plate.format("0.358023")) and read(plate.format("0.3580235"))
    with pytest.raises(SceneError):
        read(plate.format("0.358030"))


def test_residues_of_programs_that_write_files_are_zero(tmp_path):
    """Origins and centres of mass within 1e-18 m of zero are zero; so are products of inertia
    within 1e-15 √(xx yy), and differences of moments."""
    path = tmp_path / "arm.urdf"
    path.write_text("""<robot name="arm"><link name="a"><inertial><mass value="1"/>
<origin xyz="1e-19 2.67e-51 1e-17"/><inertia ixx="1" iyy="4" izz="4.000000000000004"
ixy="1.9e-15" ixz="2.1e-15" iyz="-3.9e-15"/>
</inertial></link><link name="b"/><joint name="j" type="revolute">
<parent link="b"/><child link="a"/><origin xyz="-1e-18 1 2e-18"/></joint></robot>""")
    model = read_urdf(path)
    (inertia,) = (body.inertia for body in model.bodies if body.inertia)
    assert inertia.com == (0, 0, F(1, 10**17))
    assert inertia.moments == (1, 4, 4, 0, F(21, 10**16), 0)
    assert model.joints[-1].placement.t == (0, 1, F(2, 10**18))


@pytest.mark.parametrize("rpy", ["0.3 0 0", "0 0.7 0", "2.9 0.4 1", "0 0 0.7853981633974483"])
def test_a_ball_that_is_turned_is_a_ball(tmp_path, rpy):
    """Rounded sines leave differences of equal moments that no file contains, and whose powers
    leave single precision's range."""
    path = tmp_path / "ball.urdf"
    path.write_text(f"""<robot name="ball"><link name="world"/><link name="a"><inertial>
<origin xyz="0 0 0.1" rpy="{rpy}"/><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01"
ixy="0" ixz="0" iyz="0"/></inertial></link><joint name="j" type="floating"><parent link="world"/>
<child link="a"/></joint></robot>""")
    model = read_urdf(path)
    (inertia,) = (body.inertia for body in model.bodies if body.inertia)
    assert inertia.moments[1:] == (inertia.moments[0], inertia.moments[0], 0, 0, 0)
    assert derive(Scene("ball", model)).functions
