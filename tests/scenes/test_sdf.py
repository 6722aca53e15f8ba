"""SDF files: MuJoCo moves the robot alike, whatever frames give its poses and axes."""

from fractions import Fraction

import mujoco
import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.scene.mechanism.model import Mimic
from coscrew_codegen.scene.mechanism.notices import FALLING
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mujoco_pairs import compared
from tests.support.scenes.sdf_texts import LINK, chain, hinge, inertial

U = 2.0**-53


ARM = f"""<?xml version="1.0"?>
<sdf version="1.9"><world name="lab"><gravity>0.5 0 -9</gravity><model name="arm">
<pose>0 0 1 0 0 0</pose>
<link name="foot"><pose>0.1 0.2 -0.7 0 0 0.5</pose>{inertial(4)}
  <visual name="v"><any>thing</any></visual></link>
<joint name="weld" type="fixed"><parent>world</parent><child>foot</child></joint>
<link name="upper"><pose relative_to="foot">0.3 0 0.4 0.2 -0.3 0.1</pose>
  {inertial(2, "0.02 0.03 -0.01")}<gz:mark/></link>
<joint name="shoulder" type="revolute"><parent>foot</parent><child>upper</child>
  <pose>-0.1 0.05 -0.2 0 0 1.5707963267948966</pose>
  <axis><xyz>1 2 0.5</xyz><dynamics><damping>0.4</damping><friction>0.1</friction></dynamics>
  <limit><lower>-1</lower><upper>2</upper><effort>9</effort><velocity>-1</velocity></limit></axis>
</joint>
<frame name="wrist_at" attached_to="upper">
  <pose degrees="true">0.25 0 0.05 90 0 0</pose></frame>
<link name="hand"><pose relative_to="wrist_at">0.1 0.2 0.3 -1.5707963267948966 0 0</pose>
  {inertial(1, "0.05 0 0.02", "0.3 0.1 -0.2")}</link>
<joint name="wrist" type="universal"><parent>upper</parent><child>hand</child>
  <pose relative_to="wrist_at"/>
  <axis><xyz>0 0 1</xyz><dynamics><damping>0.2</damping></dynamics></axis>
  <axis2><xyz>0 1 0</xyz><dynamics><spring_stiffness>3.5</spring_stiffness>
  <spring_reference>0.25</spring_reference></dynamics></axis2></joint>
<link name="rod"><pose relative_to="hand">0.1 0.1 0.1 0 0 0.7</pose>{inertial(0.5)}</link>
<joint name="slide" type="prismatic"><parent>hand</parent><child>rod</child>
  <pose>0.3 0.3 0.3 1 1 1</pose><axis><xyz expressed_in="hand">1 1 0.5</xyz></axis></joint>
<link name="tip"><pose relative_to="rod">0 0 0.2 0 0 0</pose>{inertial(0.3, "0 0 0.1")}</link>
<joint name="ball" type="ball"><parent>rod</parent><child>tip</child>
  <pose>0 0.02 -0.1 0 0 0</pose></joint>
<frame name="probe" attached_to="tip"><pose relative_to="rod">0 0 0.25 0 0 0</pose></frame>
</model></world></sdf>"""

INERTIAS = 'fullinertia="0.05 0.06 0.07 0.01 0 -0.005"'
MJCF = f"""<mujoco><compiler angle="radian" eulerseq="XYZ"/><option gravity="0.5 0 -9"/><worldbody>
<body name="foot" pos="0.1 0.2 0.3" euler="0 0 0.5"><inertial pos="0 0 0" mass="4" {INERTIAS}/>
<body name="upper" pos="0.3 0 0.4" euler="0.2 -0.3 0.1">
  <inertial pos="0.02 0.03 -0.01" mass="2" {INERTIAS}/>
  <joint name="shoulder" pos="-0.1 0.05 -0.2" axis="-2 1 0.5" damping="0.4"/>
<body name="hand" pos="0.35 -0.3 0.25"><inertial pos="0.05 0 0.02" mass="1" FULL/>
  <joint name="wrist" pos="-0.1 0.3 -0.2" axis="0 -1 0" damping="0.2"/>
  <joint name="wrist/2" pos="-0.1 0.3 -0.2" axis="0 0 1" stiffness="3.5" springref="0.25"/>
<body name="rod" pos="0.1 0.1 0.1" euler="0 0 0.7"><inertial pos="0 0 0" mass="0.5" {INERTIAS}/>
  <joint name="slide" type="slide" axis="AXIS"/>
<body name="tip" pos="0 0 0.2"><inertial pos="0 0 0.1" mass="0.3" {INERTIAS}/>
  <joint name="ball" type="ball" pos="0 0.02 -0.1"/>
</body></body></body></body></body></worldbody></mujoco>"""


def rotation(roll, pitch, yaw):
    """R_z R_y R_x."""
    (a, b, c), (s, t, u) = np.cos([roll, pitch, yaw]), np.sin([roll, pitch, yaw])
    return (np.array([[c, -u, 0], [u, c, 0], [0, 0, 1]]) @ np.array([[b, 0, t], [0, 1, 0],
                                                                     [-t, 0, b]])
            @ np.array([[1, 0, 0], [0, a, -s], [0, s, a]]))


def theirs():
    """MuJoCo's robot; the hand's turned moments and the slide's axis are computed here."""
    R = rotation(0.3, 0.1, -0.2)
    I = R @ np.array([[0.05, 0.01, 0], [0.01, 0.06, -0.005], [0, -0.005, 0.07]]) @ R.T
    full = " ".join(repr(float(I[x])) for x in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))
    axis = rotation(0, 0, 0.7).T @ [1, 1, 0.5]
    return mujoco.MjModel.from_xml_string(MJCF.replace("FULL", f'fullinertia="{full}"').replace(
        "AXIS", " ".join(repr(float(x)) for x in axis)))


@pytest.fixture
def read(tmp_path):
    def read(text=ARM, scene="", name="arm.sdf", **overrides):
        path = tmp_path / name
        path.write_text(text)
        if scene:
            path = tmp_path / "scene.toml"
            path.write_text(f'model = "{name}"\n{scene}')
        return read_scene(path, overrides=SceneOverrides(**overrides))

    return read


def test_the_arm_moves_as_mujocos(read):
    """Poses relative to frames, axes in others' frames, joints beside their links' frames; damping,
    spring and gravity of the file act in it alone."""
    worst = compared(read(), theirs())
    assert max(worst.mass_matrix, worst.bias, worst.torques) < 200 * U, worst


def test_what_the_file_says_is_in_the_model(read):
    scene = read()
    joints = {x.name: x for x in scene.model.joints}
    shoulder = joints["shoulder"]
    assert (shoulder.lower, shoulder.upper, shoulder.effort, shoulder.velocity) == (-1, 2, 9, None)
    assert (shoulder.damping, shoulder.friction) == (Fraction(2, 5), Fraction(1, 10))
    assert [x.name for x in scene.effects] == ["gravity", "spring.wrist/2", "viscous.shoulder",
                                               "viscous.wrist"]
    assert {"foot", "upper", "hand", "rod", "tip", "wrist_at", "probe"} <= {
        x.name for x in scene.model.bodies}
    assert joints["probe/frame"].placement.t == (0, 0, Fraction(1, 20))
    assert any("<gz:mark> is another tool's" in x for x in scene.unused)
    assert any(x.startswith("joint shoulder: friction 0.1 N m is not used") for x in scene.unused)


def test_poses_are_where_the_file_puts_them(read, tmp_path):
    """Poses of links and frames, at zero, in the world."""
    read(scene='functions = ["body_poses"]\n[effects.gravity]\n')
    kernels = load_scene(tmp_path / "scene.toml")
    poses = dict(zip(kernels.bodies, kernels.double.body_poses(kernels.neutral_q), strict=True))
    at = np.eye(4)
    for xyz, rpy, name in (((0.1, 0.2, 0.3), (0, 0, 0.5), "foot"),
                           ((0.3, 0, 0.4), (0.2, -0.3, 0.1), "upper"),
                           ((0.25, 0, 0.05), (np.pi / 2, 0, 0), "wrist_at"),
                           ((0.1, 0.2, 0.3), (-np.pi / 2, 0, 0), "hand"),
                           ((0.1, 0.1, 0.1), (0, 0, 0.7), "rod"), ((0, 0, 0.2), (0,) * 3, "tip"),
                           ((0, 0, 0.05), (0,) * 3, "probe")):
        step = np.eye(4)
        step[:3, :3], step[:3, 3] = rotation(*rpy), xyz
        at = at @ step
        if name in poses:
            assert np.abs(poses[name] - at[:3]).max() < 16 * U, name
    assert {"hand", "rod", "probe"} <= poses.keys()


def test_a_root_that_no_joint_moves_floats_at_its_place(read):
    free = read(chain(hinge()))
    base = free.model.joints[0]
    assert (base.kind, base.child, base.placement.t) == (Kind.FREE, "a", (0, 0, 1))
    fixed = read(chain(hinge()), scene='base = "fixed"\n[effects.gravity]\n')
    assert fixed.model.joints[0].kind is Kind.FIXED
    assert fixed.model.joints[0].placement.t == (0, 0, 1)
    alone = read(chain(hinge(kind="fixed")))
    assert [x.kind for x in alone.model.joints] == [Kind.FREE, Kind.FIXED]


@pytest.mark.parametrize(("version", "axis", "wanted"), (
    ("1.9", "<xyz>1 0 0</xyz>", (1, 0, 0)),
    ("1.9", '<xyz expressed_in="a">1 0 0</xyz>', (0, -1, 0)),
    ("1.9", '<xyz expressed_in="__model__">0 3 0</xyz>', (1, 0, 0)),
    ("1.6", "<xyz>1 0 0</xyz>", (1, 0, 0)),
    ("1.6", "<xyz>1 0 0</xyz><use_parent_model_frame>1</use_parent_model_frame>", (0, -1, 0)),
    ("1.4", "<xyz>1 0 0</xyz>", (0, -1, 0)),
    ("1.9", "", (0, 0, 1))))
def test_axes_are_in_the_frame_that_their_version_says(read, version, axis, wanted):
    assert read(chain(hinge(axis), version)).model.joints[-1].axis == wanted


def test_links_keep_their_frames(read):
    """A link without mass turns where the joint is; on the axis, or sliding, none is needed."""
    aside = '<pose>{} 0 0 0</pose>'
    assert [x.name for x in read(chain(hinge(pose=aside.format("0.1 0 0")))).model.joints] == [
        "base", "j", "j/body"]
    for pose, kind in (("0 0 0.1", "revolute"), ("0.1 0.2 0.3", "prismatic")):
        joints = read(chain(hinge(pose=aside.format(pose), kind=kind))).model.joints
        assert [(x.name, x.child) for x in joints] == [("base", "a"), ("j", "b")]
        assert joints[1].placement.t == (Fraction(1, 2), 0, 0)


def test_limits_without_end_are_none(read):
    limit = ("<xyz>0 0 1</xyz><limit><lower>-1e16</lower><upper>inf</upper><effort>-1</effort>"
             "<velocity>inf</velocity><stiffness>1e8</stiffness></limit>")
    scene = read(chain(hinge(limit)))
    joint = scene.model.joints[-1]
    assert (joint.lower, joint.upper, joint.effort, joint.velocity) == (None,) * 4
    assert "joint j: <stiffness> in line 1 is used by no effect" in scene.unused
    ends = "<xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper><effort>3</effort></limit>"
    joint = read(chain(hinge(ends, kind="continuous"))).model.joints[-1]
    assert (joint.lower, joint.upper, joint.effort) == (None, None, 3)


def test_followers_count_from_their_reference(read):
    """q = multiplier (q of the leader - reference) + offset."""
    leader = '<joint name="lead" type="universal"><parent>world</parent><child>a</child><axis/>' \
             "<axis2><xyz>1 0 0</xyz></axis2></joint>"
    mimic = ('<xyz>0 0 1</xyz><mimic joint="lead"{}><multiplier>2</multiplier><offset>0.5</offset>'
             "<reference>0.125</reference></mimic>")
    for axis, name in (("", "lead"), (' axis="axis2"', "lead/2")):
        scene = read(chain(leader + hinge(mimic.format(axis)), "1.11"))
        follower = next(x for x in scene.model.joints if x.name == "j")
        assert follower.mimic == Mimic(name, Fraction(2), Fraction(1, 4))


def test_models_in_a_model_have_long_names(read):
    palm = LINK.format("palm", "0 0 1 0 0 0", "")
    finger = LINK.format("finger", "0.25 0 0 0 0 0", ' relative_to="palm"')
    inner = (f'<model name="grip"><pose>0 0 0.5 0 0 0</pose>{palm}{finger}'
             '<joint name="close" type="prismatic"><parent>palm</parent><child>finger</child>'
             "<axis/></joint></model>")
    mount = '<joint name="mount" type="fixed"><parent>b</parent><child>grip</child></joint>'
    joints = {x.name: x for x in read(chain(hinge() + inner + mount)).model.joints}
    assert list(joints) == ["base", "j", "mount", "grip::close"]
    assert (joints["mount"].parent, joints["mount"].child) == ("b", "grip::palm")
    assert joints["mount"].placement.t == (0, Fraction(1, 2), Fraction(1, 2))
    assert joints["grip::close"].placement.t == (Fraction(1, 4), 0, 0)


UNIVERSAL = """<sdf version="1.9"><model name="m">
<link name="a"><pose>0.1 0 0 0.3 0.2 0.1</pose>{}</link><link name="b">
<pose relative_to="a">0 0.1 0 0.5 -0.2 0.4</pose>{}</link>
<joint name="weld" type="fixed"><parent>world</parent><child>a</child></joint>
<joint name="j" type="TYPE"><parent>a</parent><child>b</child><pose>POSE</pose>
<axis><xyz>0 3 4</xyz></axis><axis2><xyz>0 -4 3</xyz>MORE</axis2></joint></model></sdf>""".format(
    inertial(2), inertial(1, "0.1 0.02 0.03"))


@pytest.mark.parametrize("pose", ("0 0 0 0 0 0", "0 0 0 0.7 0.1 0.2", "0.1 0.2 -0.3 0.7 0.1 0.2"))
def test_a_universal_joint_is_of_that_kind_and_moves_as_two(read, pose):
    """The child's frame at the joint's, turned there, or beside it: poses and torques are those of
    two revolute joints in series, to rounding."""
    text = UNIVERSAL.replace("POSE", pose)
    ours = read(text.replace("TYPE", "universal").replace("MORE", ""))
    two = read(text.replace("TYPE", "revolute2").replace("MORE", ""), name="two.sdf")
    assert [x.kind for x in ours.model.joints if x.kind.moves] == [Kind.UNIVERSAL]
    assert [x.name for x in two.model.joints if x.kind.moves] == ["j", "j/2"]
    q, v, a = np.random.default_rng(2).uniform(-2, 2, (3, 20, 2))
    names = ["body_poses", "inverse_dynamics"]
    ours, two = (load_scene(x, functions=names).double for x in (ours, two))
    pairs = [(ours.inverse_dynamics(q, v, a), two.inverse_dynamics(q, v, a)),
             (ours.body_poses(q)[..., 1 if "0.3" not in pose else 2, :, :],
              two.body_poses(q)[..., -1, :, :])]
    for x, y in pairs:
        assert np.abs(x - y).max() <= 50 * U * np.abs(y).max()


@pytest.mark.parametrize("more", (
    "<dynamics><damping>1</damping></dynamics>", "<limit><upper>1</upper></limit>",
    "<dynamics><spring_stiffness>1</spring_stiffness></dynamics>"))
def test_a_universal_joint_with_numbers_of_an_axis_is_two(read, more):
    text = UNIVERSAL.replace("POSE", "0 0 0 0 0 0").replace("TYPE", "universal")
    joints = read(text.replace("MORE", more)).model.joints
    assert [x.name for x in joints if x.kind is Kind.REVOLUTE] == ["j", "j/2"]
    skew = text.replace("MORE", "").replace("0 -4 3", "0 -4 2")
    assert [x.name for x in read(skew).model.joints if x.kind.moves] == ["j", "j/2"]


def test_axes_of_ball_joints_are_told_and_old_poses_read(read):
    """Old files give ball joints an axis, and poses an empty frame."""
    new = read(chain(hinge(kind="ball").replace("<axis><xyz>0 0 1</xyz></axis>", ""), "1.6"))
    old = read(chain(hinge(kind="ball", pose='<pose frame="">0 0 0 0 0 0</pose>'), "1.6"))
    assert old.model == new.model
    assert not [x for x in new.notices if x.subject != FALLING]
    assert any(x.endswith("of a ball joint, is not used") for x in old.unused)


def test_a_link_of_old_files_may_be_called_world(read):
    """Joints then refer to it: else it were a second root.  It has another name here, which is
    told."""
    plain = read(chain(hinge(), "1.6"))
    text = chain(hinge(parent="world"), "1.6").replace('link name="a"', 'link name="world"')
    scene = read(text)
    assert {x.name for x in scene.model.bodies} == {"world_", "b"}
    assert [(x.kind, x.parent, x.placement) for x in scene.model.joints] == [
        (x.kind, x.parent.replace("a", "world_"), x.placement) for x in plain.model.joints]
    assert "body world_: is the link 'world', to which joints refer here" in scene.unused
