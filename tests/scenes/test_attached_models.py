"""[attach.NAME] with a model, [bodies] and [joints] beside a model: the same as one file."""

import re

import mujoco
import numpy as np
import pinocchio as pin
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.api import run
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mujoco_pairs import compared
from tests.support.scenes.robots import paired

INERTIAL = """<inertial><origin xyz="0.01 {0} 0.1"/><mass value="{1}"/><inertia ixx="0.02"
iyy="0.021" izz="0.003" ixy="1e-3" ixz="0" iyz="-2e-3"/></inertial>"""
ARM = f"""<robot name="arm"><link name="base"/><link name="upper">{INERTIAL.format(0, 2)}</link>
<link name="hand">{INERTIAL.format(0.02, 0.5)}</link>
<joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/>
<axis xyz="0 1 0"/></joint>
<joint name="elbow" type="continuous"><parent link="upper"/><child link="hand"/>
<origin xyz="0 0 0.4" rpy="0.1 0 0.3"/><axis xyz="1 0 0"/></joint>MORE</robot>"""
GRIPPER = f"""<robot name="gripper"><link name="PREpalm">{INERTIAL.format(0, 0.3)}</link>
<link name="PREleft">{INERTIAL.format(0.03, 0.1)}</link>
<link name="PREright">{INERTIAL.format(-0.03, 0.1)}</link>
<joint name="PREopen" type="prismatic"><parent link="PREpalm"/><child link="PREleft"/>
<origin xyz="0 0.05 0.1" rpy="0.2 0 0"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="1" effort="3" velocity="1"/><dynamics damping="0.2" friction="0.1"/>
</joint><joint name="PREshut" type="prismatic"><parent link="PREpalm"/><child link="PREright"/>
<origin xyz="0 -0.05 0.1"/><axis xyz="0 -1 0"/><mimic joint="PREopen" multiplier="0.5"/>
<limit lower="-1" upper="1" effort="3" velocity="1"/></joint>MORE</robot>"""
MOUNT = """<joint name="attach.{0}" type="fixed"><parent link="hand"/><child link="{1}palm"/>
<origin xyz="0 0 {2}" rpy="0 1.5 -0.4"/></joint>"""
EFFECTS = '\n[effects.gravity]\n[effects.viscous]\njoints = "all"\nd = "model"\n[effects.mimic]\n'


def attach(name, more, z=0.2):
    return (f'[attach.{name}]\nmodel = "gripper.urdf"\nto = "hand"\n'
            f"place = {{ xyz = [0, 0, {z}], rpy = [0, 1.5, -0.4] }}\n{more}\n")


@pytest.fixture
def scene(tmp_path):
    """Reads a scene beside arm.urdf, to which links may be added, and gripper.urdf."""
    def read(text, more="", head='model = "arm.urdf"\n', gripper=GRIPPER):
        (tmp_path / "arm.urdf").write_text(ARM.replace("MORE", more))
        (tmp_path / "gripper.urdf").write_text(gripper.replace("PRE", "").replace("MORE", ""))
        (tmp_path / "arm.toml").write_text(f'{head}name = "arm"\n{text}')
        return read_scene(tmp_path / "arm.toml")
    return read


def links(prefix):
    """The gripper's elements, as someone would copy them into the arm's file."""
    inside = re.sub("</?robot[^>]*>", "", GRIPPER)
    return inside.replace("PRE", prefix).replace("MORE", "")


@pytest.mark.parametrize(("more", "prefix"), (
    ("", "grip_"), ('prefix = "left/"', "left/"), ('prefix = ""', "")))
def test_an_attached_model_is_that_of_a_file_edited_by_hand(scene, more, prefix):
    """Model, functions and bits are equal: bodies, joints, damping, limits, followers."""
    ours = scene(attach("grip", more) + EFFECTS)
    theirs = scene(EFFECTS, links(prefix) + MOUNT.format("grip", prefix, 0.2))
    by_name = {x.name: x for x in theirs.model.joints}
    assert {x.name: x for x in ours.model.joints} == by_name
    assert by_name[f"{prefix}shut"].mimic.joint == f"{prefix}open"
    assert set(ours.model.bodies) == set(theirs.model.bodies)
    assert [x.text for x in ours.notices] == [x.text for x in theirs.notices]
    assert derive(ours) == derive(theirs)


def test_two_grippers_are_pinocchios_by_its_append_model(scene, tmp_path):
    """Inverse dynamics, mass matrix and bias of an arm with two, in 20 states."""
    ours = scene(attach("a", "") + attach("b", "", -0.1) + "[effects.gravity]\n")
    frame = pin.buildModelFromXML((tmp_path / "arm.urdf").read_text())
    whole = frame
    for name, z in (("a", 0.2), ("b", -0.1)):
        tool = pin.buildModelFromXML((tmp_path / "gripper.urdf").read_text())
        for k in range(1, tool.njoints):
            tool.names[k] = f"{name}_{tool.names[k]}"
        for of in tool.frames:
            of.name = f"{name}_{of.name}"
        place = pin.SE3(pin.rpy.rpyToMatrix(0, 1.5, -0.4), np.array([0, 0, z]))
        whole = pin.appendModel(whole, tool, whole.getFrameId("hand"), place)
    whole.gravity.linear = np.array([0, 0, -9.81])
    x = paired(ours, whole, ("inverse_dynamics", "mass_matrix"))
    kernels = load_scene(ours, functions=["inverse_dynamics", "mass_matrix"]).double
    data = whole.createData()
    for q, v, a in zip(*x.states(20), strict=True):
        at, (v_there, a_there) = x.theirs(q), (x.follow @ y for y in (v, a))
        true = x.follow.T @ pin.rnea(whole, data, at, v_there, a_there)
        assert np.abs(kernels.inverse_dynamics(q, v, a) - true).max() <= 1e-14 * np.abs(true).max()
        upper = np.triu(pin.crba(whole, data, at))
        M = x.follow.T @ (upper + np.triu(upper, 1).T) @ x.follow
        assert np.abs(kernels.mass_matrix(q) - M).max() <= 1e-14 * np.abs(M).max()


SPRUNG = """<mujoco><compiler angle="radian"/><worldbody>
<body name="palm" pos="0 0 0.1" gravcomp="1"><geom type="box" size="0.05 0.02 0.03"/>
<body name="finger" gravcomp="0.5" pos="0 0.05 0"><geom type="sphere" size="0.03"/>
<joint name="open" type="slide" axis="0 1 0" stiffness="5" springref="0.1" damping="0.2"
  armature="0.01"/><body name="tip" pos="0 0 0.1"><geom type="sphere" size="0.02" pos="0.03 0 0"/>
<joint name="turn" type="ball" damping="0.3" armature="0.02"/><body name="nail" pos="0 0 0.05">
<geom type="sphere" size="0.01" pos="0.02 0 0"/><joint name="bend" axis="0 1 0"/></body></body>
</body></body></worldbody><tendon><fixed name="pull" stiffness="3" damping="0.4" limited="true"
  range="-1 2" springlength="0.1"><joint joint="open" coef="2"/><joint joint="bend" coef="-0.5"/>
</fixed></tendon></mujoco>"""


def test_effects_of_the_attached_file_are_named_by_the_prefix(scene, tmp_path):
    """Springs, armatures and damping of joints, effects on sums of coordinates, compensation of
    gravity, also of a body that moves only here; the remedies of the notices are tables that act.
    """
    (tmp_path / "sprung.xml").write_text(SPRUNG)
    table = '[attach.s]\nmodel = "sprung.xml"\nto = "hand"\nplace = { xyz = [0, 0, 0.1] }\n'
    notices = [x for x in scene(table).notices if x.remedy]
    of = {x.used_by for x in notices}
    assert {("spring", "s_pull"), ("viscous", "s_pull"), ("limit", "s_pull"),
            ("armature", "s_turn"), ("spring", "s_open"), ("armature", "s_open"),
            ("wrench", "s_gravcomp of palm"), ("wrench", "s_gravcomp of finger")} <= of
    assert not any(name == "gravity" for name, _ in of)  # it is the scene's
    effects = '[effects.gravity]\n[effects.viscous]\njoints = "all"\nd = "model"\n'
    for x in notices:
        if x.used_by[0] not in ("", "limit", "contact"):  # no part of MuJoCo's inverse dynamics
            head, _, values = x.remedy.removeprefix("add ").partition(" with ")
            pairs = re.split(r"(?:, | and )(?=\w+ = )(?![^{]*})", values)
            effects += "\n".join([head, *pairs, ""])
    whole = scene(table + effects)
    assert {x.used_by for x in whole.notices if x.used_by[0]} == {
        ("limit", "s_pull"), ("contact", "")}
    arm = ("<mujoco><compiler angle='radian'/><worldbody><body>"
           "<joint name='shoulder' axis='0 1 0'/>"
           "<inertial pos='0.01 0 0.1' mass='2' fullinertia='0.02 0.021 0.003 1e-3 0 -2e-3'/>"
           "<body pos='0 0 0.4' euler='0.1 0 0.3'><joint name='elbow' axis='1 0 0'/>"
           "<inertial pos='0.01 0.02 0.1' mass='0.5' fullinertia='0.02 0.021 0.003 1e-3 0 -2e-3'/>"
           "<body name='at' pos='0 0 0.1'><attach model='sprung' body='palm' prefix='s_'/></body>"
           "</body></body></worldbody></mujoco>").replace("<worldbody>", (
               "<compiler eulerseq='XYZ'/><asset><model name='sprung' file='sprung.xml'/></asset>"
               "<worldbody>"))
    (tmp_path / "whole.xml").write_text(arm)
    worst = compared(whole, mujoco.MjModel.from_xml_path(str(tmp_path / "whole.xml")))
    assert max(worst.mass_matrix, worst.bias, worst.torques) < 1e-13, worst


def test_bodies_and_joints_beside_a_model_move_on_it(scene):
    """A turning wheel and a tool on the hand, whose damping is the scene's own, are those of the
    file edited by hand."""
    damped = EFFECTS.replace("[effects.mimic]", "")
    ours = scene("""
[bodies]
wheel = { mass = 1, com = [0, 0, 0.1], inertia = [0.01, 0.02, 0.015] }
tool = {}
[joints.spin]
type = "continuous"
parent = "hand"
child = "wheel"
axis = [0, 0, 2]
origin = { xyz = [0, 0.1, 0] }
damping = 0.5
[joints.weld]
type = "fixed"
parent = "wheel"
child = "tool"
""" + damped)
    theirs = scene(damped, """<link name="wheel"><inertial><origin xyz="0 0 0.1"/><mass value="1"/>
<inertia ixx="0.01" iyy="0.02" izz="0.015" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="tool"/><joint name="spin" type="continuous"><parent link="hand"/><child link="wheel"/>
<axis xyz="0 0 2"/><origin xyz="0 0.1 0"/><dynamics damping="0.5"/></joint>
<joint name="weld" type="fixed"><parent link="wheel"/><child link="tool"/></joint>""")
    assert ours.model == theirs.model
    assert derive(ours) == derive(theirs)


def test_a_joint_beside_a_model_may_carry_its_root(scene):
    """An arm on a base that drives, and a second arm beside it."""
    model = scene("""
[bodies.cart]
mass = 10
inertia = [1, 1, 1]
[joints.drive]
type = "planar"
child = "cart"
axis = [0, 0, 1]
[joints.stand]
type = "fixed"
parent = "cart"
child = "base"
[attach.other]
model = "arm.urdf"
to = "cart"
place = { xyz = [0, 0.5, 0] }
""").model
    assert [x.name for x in model.joints if x.kind.moves] == [
        "drive", "shoulder", "elbow", "other_shoulder", "other_elbow"]
    assert model.links()["base"] == model.links()["other_base"] == "cart"


def test_what_is_attached_is_seen(scene):
    """Visuals of the file are those of the bodies here."""
    seen = GRIPPER.replace('<link name="PREpalm">', '<link name="PREpalm"><visual><geometry>'
                           '<sphere radius="0.25"/></geometry></visual>')
    bodies = {x.name: x for x in scene(attach("grip", ""), gripper=seen).model.bodies}
    (visual,) = bodies["grip_palm"].visuals
    assert (visual.shape, visual.size) == ("sphere", (0.25,))


def test_a_model_may_float_beside_another(scene):
    model = scene(attach("free", 'base = "free"').replace('"hand"', '"world"')).model
    floating, = (x for x in model.joints if x.name == "attach.free")
    assert (floating.kind, floating.parent, floating.child) == (Kind.FREE, "world", "free_palm")
    assert [float(x) for x in floating.placement.t] == [0, 0, 0.2]


def test_models_may_all_be_attached_to_the_world(scene):
    """Two arms beside each other, without a model that has another place than they."""
    arm = '[attach.{0}]\nmodel = "arm.urdf"\nto = "world"\nplace = {{ xyz = [0, {1}, 0] }}\n'
    text = arm.format("left", 0.5) + arm.format("right", -0.5)
    model = scene(text + "[effects.gravity]\n", head="").model
    assert [(x.name, x.parent, float(x.placement.t[1])) for x in model.joints[::3]] == [
        ("attach.left", "world", 0.5), ("attach.right", "world", -0.5)]
    assert model.links()["left_base"] == "world"
    with pytest.raises(SceneError, match="base: no model here has a root of its own; wanted it in"):
        scene(f'base = "free"\n{text}', head="")


def test_records_starts_and_parameters_name_what_is_attached(scene):
    result = scene("""runtime = ["grip_left.mass", "viscous.grip_open.d"]
functions = ["default", "jacobian_grip_left"]
""" + attach("grip", "") + EFFECTS + """
[start.q]
grip_open = 0.1
[outputs]
record = ["q.grip_open", "position.grip_right"]
[run]
duration = 0.01
""")
    assert [p.name for p in result.parameters] == ["grip_left.mass", "viscous.grip_open.d"]
    assert derive(result).has("jacobian_grip_left")
    recording = run(result).recording
    assert recording.of("q.grip_open")[0] == 0.1


REFUSED = {
    "taken": (attach("grip", 'prefix = ""').replace("gripper", "arm"), "attach.grip.prefix",
              "the model has a body 'base' already, and so has 'arm.urdf' with this prefix; wanted "
              "another one"),
    "taken by another": (attach("a", 'prefix = "x"') + attach("b", 'prefix = "x"'),
                         "attach.b.prefix", "[attach.a] has a body 'xpalm' already"),
    "to itself": (attach("grip", "").replace('"hand"', '"grip_palm"'), "attach.grip.to",
                  "no body 'grip_palm'; wanted one of base, hand, upper, world"),
    "unknown": (attach("grip", "").replace('"hand"', '"hnad"'), "attach.grip.to",
                "no body 'hnad'; did you mean 'hand'?"),
    "file": (attach("grip", "").replace("gripper.urdf", "griper.urdf"), "attach.grip.model",
             "'griper.urdf': there is no such file"),
    "mass": (attach("grip", "mass = 1"), "attach.grip.mass", "wanted one of both"),
    "of a model": ('[attach.x]\nto = "hand"\nmass = 1\nprefix = "y"\n', "attach.x.prefix",
                   "is for a `model`; wanted none"),
    "lines": (attach("grip", 'prefix = "a\\nb"'), "attach.grip.prefix", "wanted text on one line"),
    "floats": (attach("grip", 'base = "free"'), "line 1, joint 'base'", "lets its root float, and "
               "'hand' is to hold it; wanted base = \"fixed\", or to = \"world\""),
    "left out": (attach("grip", 'leave_out = ["loops"]'), "leave_out", "URDF has nothing to leave"),
    "body": ("[bodies.hand]\nmass = 1\n", "bodies.hand", "the model has a body 'hand' already; "
             "wanted another name"),
    "joint": ('[joints.elbow]\ntype = "fixed"\nparent = "hand"\nchild = "x"\n[bodies.x]\n',
              "joints.elbow", "the model has a joint 'elbow' already; wanted another name"),
    "two joints": ('[joints.x]\ntype = "fixed"\nparent = "base"\nchild = "hand"\n',
                   "joints.x.child", "'hand' is moved by joint 'elbow' already; wanted another"),
    "no joint": ("[bodies.x]\nmass = 1\n", "bodies.x", "no joint moves it; wanted [joints.NAME] "
                 "with child = 'x', or [attach.x] with `to`, which fixes it to a body"),
    "parent": ('[bodies.x]\n[joints.y]\ntype = "fixed"\nparent = "hnad"\nchild = "x"\n',
               "joints.y", "parent 'hnad' is no body; did you mean 'hand'?"),
    "leader": ('[bodies.x]\n[joints.y]\ntype = "continuous"\nchild = "x"\naxis = [0, 0, 1]\n'
               'mimic = { joint = "elbw" }\n', "joints.y", "mimics 'elbw', which is no joint"),
}


@pytest.mark.parametrize(("text", "where", "words"), REFUSED.values(), ids=REFUSED)
def test_errors_name_the_table_and_the_way(scene, text, where, words):
    with pytest.raises(SceneError) as caught:
        scene(text)
    assert caught.value.where == where
    assert words in str(caught.value)


def test_errors_in_the_attached_file_name_its_line(scene):
    """By its own names, with its own lines, as in the file alone."""
    wrong = GRIPPER.replace('<parent link="PREpalm"/><child link="PREright"/>',
                            '<parent link="PREplam"/><child link="PREright"/>')
    with pytest.raises(SceneError, match=r"gripper\.urdf: line 10, joint 'shut': parent 'plam' is "
                                         "no body; did you mean 'palm'"):
        scene(attach("grip", ""), gripper=wrong)
    light = GRIPPER.replace('ixx="0.02"', 'ixx="2"')
    with pytest.raises(SceneError, match=r"gripper\.urdf: line 1, body 'palm': moments"):
        scene(attach("grip", ""), gripper=light)


def test_a_world_with_a_mass_is_no_body_to_attach_to(scene):
    heavy = GRIPPER.replace("PREpalm", "world")
    with pytest.raises(SceneError, match="body 'world': has a mass, and stands for 'hand' here"):
        scene(attach("grip", ""), gripper=heavy)
    light = GRIPPER.replace(INERTIAL.format(0, 0.3), "").replace("PREpalm", "world")
    model = scene(attach("grip", ""), gripper=light).model
    assert {x.parent for x in model.joints if x.name.startswith("grip_")} == {"hand"}
