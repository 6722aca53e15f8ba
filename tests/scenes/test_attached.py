"""[attach.NAME] and [frames.NAME] beside a model: the same as links at the end of its file."""

import json
import re
from fractions import Fraction as F

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.mechanism.model import value
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.api import run

ARM = """<robot name="arm"><link name="base"/>
<link name="upper"><inertial><origin xyz="0 0 0.2"/><mass value="2"/><inertia ixx="0.1" iyy="0.1"
izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="hand"><inertial><origin xyz="0.01 0 0.1"/><mass value="0.5"/><inertia ixx="0.01"
iyy="0.012" izz="0.003" ixy="1e-4" ixz="0" iyz="0"/></inertial></link>
<joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/>
<axis xyz="0 1 0"/></joint>
<joint name="elbow" type="continuous"><parent link="upper"/><child link="hand"/>
<origin xyz="0 0 0.4" rpy="0.1 0 0.3"/><axis xyz="1 0 0"/></joint>MORE</robot>"""
LINKS = """<link name="tool"/><link name="payload"><inertial><origin xyz="0 0.02 0.05"/>
<mass value="1.5"/><inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="1e-3" ixz="0" iyz="-2e-3"/>
</inertial></link>"""
OF_PAYLOAD = """<joint name="attach.payload" type="fixed"><parent link="hand"/>
<child link="payload"/><origin xyz="0 0 0.2" rpy="0 1.5708 -0.4"/></joint>"""
OF_TOOL = """<joint name="frames.tool" type="fixed"><parent link="payload"/><child link="tool"/>
<origin xyz="0.1 0 0.05" rpy="0.7 0 0"/></joint>"""
ATTACHED = """
[attach.payload]
to = "hand"
place = { xyz = [0, 0, 0.2], rpy = [0, 1.5708, -0.4] }
mass = 1.5
com = [0, 0.02, 0.05]
inertia = [0.02, 0.03, 0.04, 1e-3, 0, -2e-3]
[frames.tool]
to = "payload"
xyz = [0.1, 0, 0.05]
rpy = [0.7, 0, 0]
"""
HEAD = 'model = "arm.urdf"\nname = "arm"\n'
EFFECTS = "\n[effects.gravity]\n"


@pytest.fixture
def scene(tmp_path):
    """Writes and reads a scene beside the URDF file, to which links may be added."""
    def read(text, more="", head=HEAD):
        (tmp_path / "arm.urdf").write_text(ARM.replace("MORE", more))
        (tmp_path / "arm.toml").write_text(head + text)
        return read_scene(tmp_path / "arm.toml")
    return read


def refused(scene, text, where, words):
    with pytest.raises(SceneError) as caught:
        scene(text)
    assert caught.value.where == where
    assert words in str(caught.value)


@pytest.mark.parametrize("turned", [False, True])
def test_what_is_attached_is_what_the_files_end_would_add(scene, turned):
    """Model, functions and bits are equal, in either order of tables and of joints."""
    text = ATTACHED
    if turned:
        payload, _, tool = ATTACHED.partition("[frames.tool]")
        text = f"[frames.tool]{tool}{payload}"
    ours = scene(text + EFFECTS)
    theirs = scene(EFFECTS, LINKS + (OF_TOOL + OF_PAYLOAD if turned else OF_PAYLOAD + OF_TOOL))
    assert ours.model == theirs.model
    assert derive(ours) == derive(theirs)


def test_where_a_file_lists_the_payload_changes_no_bit(scene, tmp_path):
    """Inertias that move as one are summed exactly, in whatever order."""
    scene(ATTACHED + EFFECTS)
    ours = load_scene(tmp_path / "arm.toml").double
    scene(EFFECTS)
    file = tmp_path / "arm.urdf"
    file.write_text(file.read_text().replace(
        '<link name="base"/>', f'{LINKS}{OF_TOOL}{OF_PAYLOAD}<link name="base"/>'))
    theirs = load_scene(tmp_path / "arm.toml").double
    q, v, a = np.random.default_rng(3).uniform(-2, 2, (3, 20, 2))
    for name in ("inverse_dynamics", "forward_dynamics"):
        assert (getattr(ours, name)(q, v, a) == getattr(theirs, name)(q, v, a)).all()


def test_a_chain_of_attached_bodies_is_in_order_whatever_their_tables(scene):
    model = scene("""
[attach.last]
to = "middle"
mass = 1
[frames.mark]
to = "last"
[attach.middle]
to = "hand"
mass = 2
""").model
    assert [body.name for body in model.bodies][-3:] == ["middle", "last", "mark"]
    assert model.links()["mark"] == "hand"


def test_a_payload_weighs_where_its_centre_is(scene, tmp_path):
    """Torques with the payload, less those without, are the slopes of its potential energy."""
    scene(ATTACHED + EFFECTS)
    with_payload = load_scene(tmp_path / "arm.toml").double
    light = ATTACHED.replace("mass = 1.5", "mass = 1e-9").replace(
        "inertia = [0.02, 0.03, 0.04, 1e-3, 0, -2e-3]", "inertia = [1e-12, 1e-12, 1e-12]")
    scene(light + EFFECTS)
    without = load_scene(tmp_path / "arm.toml").double
    q, h = np.array([0.3, -0.8]), 1e-5

    def height(at):
        payload = with_payload.body_poses(at)[-2]
        return float(payload[2, :3] @ [0, 0.02, 0.05] + payload[2, 3])

    slopes = [(height(q + h * e) - height(q - h * e)) / (2 * h) for e in np.eye(2)]
    result = with_payload.gravity_torques(q) - without.gravity_torques(q)
    np.testing.assert_allclose(result, 1.5 * 9.81 * np.array(slopes), rtol=1e-8)


def test_effects_records_and_parameters_name_them(scene):
    result = scene("""runtime = ["payload.mass", "payload.com"]
functions = ["default", "jacobian_tool"]
""" + ATTACHED + EFFECTS + """
[effects.wrench.tool]
force = [0, 0, -5]
[effects.spring_damper.rope]
bodies = ["payload", "world"]
k = 10
[outputs]
record = ["position.tool", "pose.payload"]
[run]
duration = 0.01
""", head=HEAD)
    assert [p.name for p in result.parameters] == [
        "payload.mass", "payload.com.x", "payload.com.y", "payload.com.z"]
    assert derive(result).has("jacobian_tool")
    recording = run(result).recording
    assert {"position.tool.0", "pose.payload.11"} <= {x.name for x in recording.columns}


def test_a_payload_given_at_run_time_is_the_file_s(scene, tmp_path):
    """With the payload's mass as an argument: the same torques as with that mass in the file."""
    scene('runtime = ["payload.mass"]\n' + ATTACHED + EFFECTS)
    changing = load_scene(tmp_path / "arm.toml").double
    scene(ATTACHED.replace("mass = 1.5", "mass = 2.25") + EFFECTS)
    fixed = load_scene(tmp_path / "arm.toml").double
    q, v, a = np.array([[0.4, -0.2], [1.0, -3.0], [2.0, 0.5]])
    np.testing.assert_allclose(changing.inverse_dynamics([2.25], q, v, a),
                               fixed.inverse_dynamics(q, v, a), rtol=1e-14)


def test_they_stand_beside_tables_of_bodies_and_on_the_world(tmp_path):
    path = tmp_path / "own.toml"
    path.write_text("""
[bodies.bob]
mass = 1
[joints.pin]
type = "spherical"
child = "bob"
[attach.lamp]
to = "bob"
place = { quaternion = [0, 0, 1, 0] }
mass = 0.1
[frames.camera]
to = "world"
xyz = [0, 0, 2]
axis = [1, 0, 0]
angle = "pi"
""")
    model = read_scene(path).model
    assert model.links() == {"world": "world", "bob": "bob", "lamp": "bob", "camera": "world"}
    camera = model.joints[-1].placement
    assert camera.R == (1, 0, 0, 0, -1, 0, 0, 0, -1) and camera.t == (0, 0, 2)


@pytest.mark.parametrize("shape, about_com", [
    ("{ box = [0.1, 0.2, 0.3] }", (F(13, 100), F(10, 100), F(5, 100))),
    ("{ cylinder = { radius = 0.1, length = 0.6 } }", (F(39, 100), F(39, 100), F(6, 100))),
    ("{ sphere = 0.5 }", (F(12, 10),) * 3)])
def test_shapes_have_the_moments_of_homogeneous_solids(scene, shape, about_com):
    """m/12 (y² + z²); m/12 (3 r² + l²), m/2 r²; 2/5 m r², of 12 kg: exactly."""
    model = scene(f'[attach.load]\nto = "hand"\nmass = 12\nshape = {shape}\n').model
    (load,) = (x.inertia for x in model.bodies if x.name == "load")
    assert load.com == (0, 0, 0)
    assert tuple(map(value, load.moments)) == (*about_com, 0, 0, 0)
    own = scene(f"[bodies.load]\nmass = 12\nshape = {shape}\n[joints.pin]\n"
                'type = "spherical"\nchild = "load"\n', head="").model
    assert own.bodies[0].inertia == load


@pytest.mark.parametrize("old, new, where, words", [
    ('to = "hand"', 'to = "hnad"', "attach.payload.to",
     "no body 'hnad'; did you mean 'hand'?"),
    ('to = "hand"', 'to = "payload"', "attach.payload.to", "no body 'payload'"),
    ('to = "hand"', "", "attach.payload.to", "missing; wanted text"),
    ('to = "hand"', 'to = "tool"', "attach.payload", "is part of a loop"),
    ("mass = 1.5", "", "attach.payload.mass",
     "missing; wanted the mass in kg, or `model`, a file; a frame without mass is [frames.payl"),
    ("mass = 1.5", "mass = 0", "attach.payload.mass", "0; wanted a positive number"),
    ("mass = 1.5", "mass = -1", "attach.payload.mass", "-1; wanted a positive number"),
    ("mass = 1.5", "mas = 1.5", "attach.payload.mas", "unknown key; did you mean 'mass'?"),
    ("place =", "origin =", "attach.payload.origin", "unknown key; wanted one of arguments, base,"),
    ("rpy = [0, 1.5708, -0.4]", "ryp = [0, 1.5708, -0.4]", "attach.payload.place.ryp",
     "did you mean 'rpy'?"),
    ("[attach.payload]", "[attach.upper]", "attach.upper",
     "the model has a body 'upper' already; wanted another name"),
    ("[attach.payload]", "[attach.world]", "attach.world", "this name is the world's"),
    ("[frames.tool]", "[frames.payload]", "frames.payload", "[attach.payload] has this name"),
    ("xyz = [0.1, 0, 0.05]", "place = { xyz = [0, 0, 1] }", "frames.tool.place",
     "unknown key; wanted"),
    ("xyz = [0.1, 0, 0.05]", "mass = 1", "frames.tool.mass", "unknown key"),
    ("rpy = [0.7, 0, 0]", "angle = 1", "frames.tool.axis", "missing"),
    ("[0.02, 0.03, 0.04, 1e-3, 0, -2e-3]", "[0.02, 0.03, 4]", "attach.payload",
     "the largest principal moment is above the sum of the other two"),
    ("inertia = [0.02, 0.03, 0.04, 1e-3, 0, -2e-3]", "shape = { box = [1, 1] }",
     "attach.payload.shape.box", "a list of 2; wanted a list of 3 numbers"),
    ("inertia = [0.02, 0.03, 0.04, 1e-3, 0, -2e-3]", "shape = { box = [1, 0, 1] }",
     "attach.payload.shape.box", "an edge of 0 m; wanted positive lengths"),
    ("inertia = [0.02, 0.03, 0.04, 1e-3, 0, -2e-3]", "shape = { sphere = -1 }",
     "attach.payload.shape.sphere", "-1; wanted a positive number"),
    ("inertia = [0.02, 0.03, 0.04, 1e-3, 0, -2e-3]", "shape = { cylinder = { radius = 1 } }",
     "attach.payload.shape.cylinder.length", "missing"),
    ("inertia = [0.02, 0.03, 0.04, 1e-3, 0, -2e-3]", "shape = {}", "attach.payload.shape",
     "has 0 keys; wanted one of box, cylinder, sphere"),
    ("com = [0, 0.02, 0.05]", "shape = { sphere = 1 }", "attach.payload.shape",
     "`inertia` gives the moments already"),
    ("[attach.payload]", "[atach.payload]", "atach", "did you mean 'attach'?"),
    ("[frames.tool]", "[frame.tool]", "frame", "did you mean 'frames'?")])
def test_errors_name_the_key_and_the_way(scene, old, new, where, words):
    assert ATTACHED.count(old) >= 1
    refused(scene, ATTACHED.replace(old, new, 1), where, words)


@pytest.mark.parametrize("name", ["a'b", "a b", "it's 'so'", '"', "a.b"])
def test_a_loop_through_any_name_is_reported_at_its_table(scene, name):
    key = json.dumps(name)
    refused(scene, f"[attach.{key}]\nto = 'other'\nmass = 1\n[attach.other]\nto = {key}\n"
            "mass = 1\n", f"attach.{name!r}", "is part of a loop")


def test_joints_of_the_model_keep_their_names(scene):
    """A model may have a joint of the name that the attached body's would have."""
    taken = '<link name="x"/>' + re.sub("payload", "x", OF_PAYLOAD).replace(
        'name="attach.x"', 'name="attach.payload"')
    (tmp,) = {joint.name for joint in scene(ATTACHED, taken).model.joints
              if joint.child == "payload"}
    assert tmp == "attach.payload_"


def test_implausible_payloads_are_accepted_with_a_line(scene):
    text = ATTACHED.replace("[0.02, 0.03, 0.04, 1e-3, 0, -2e-3]", "[0.02, 0.03, 4]")
    (line,) = scene('implausible = "warn"\n' + text).model.implausible
    assert "(with what is fixed to it: hand, payload)" in line
