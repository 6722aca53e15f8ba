"""Planar and universal joints in scenes and URDF files: their keys, starts, names and messages."""

from pathlib import Path

import pytest

from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.recorded_quantities import recorded
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.sweep.candidates import candidates
from tests.support.scenes.kinds import Kind

TEXT = """
[bodies]
puck = { mass = 2, com = [0.2, -0.1, 0.3], inertia = [0.5, 0.6, 0.7] }
cross = { mass = 1.5, com = [-0.3, 0.1, 0.2], inertia = [0.4, 0.3, 0.5] }
[joints]
table = { type = "planar", child = "puck", axis = [0, 0, 5] }
wrist = { type = "universal", parent = "puck", child = "cross", axis = [2, 0, 0], \
axis2 = [0, 3, 0] }
[start.q]
table = [1, 2, "pi/2"]
wrist = [0.5, 0]
"""
URDF = """<robot name="r"><link name="base"/>
<link name="puck"><inertial><mass value="2"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="table" type="planar"><parent link="base"/><child link="puck"/>MORE</joint></robot>
"""


def read(folder: Path, text: str = TEXT) -> Scene:
    (folder / "scene.toml").write_text(text)
    return read_scene(folder / "scene.toml", EFFECTS)


def test_joints_have_their_axes_and_starts(tmp_path):
    scene = read(tmp_path)
    table, wrist = scene.model.joints
    assert (table.kind, table.axis, table.axis2) == (Kind.PLANAR, (0, 0, 1), None)
    assert (wrist.kind, wrist.axis, wrist.axis2) == (Kind.UNIVERSAL, (1, 0, 0), (0, 1, 0))
    assert scene.start_q["wrist"] == (0.5, 0) and scene.start_q["table"][:2] == (1, 2)
    assert table.in_words == "table moves in the plane with the normal z"
    assert wrist.in_words == "wrist turns about x and y"


@pytest.mark.parametrize("old, new, message", [
    ("axis2 = [0, 3, 0]", "axis2 = [1, 3, 0]", "axis2: makes an angle of 71.56"),
    (", \\\naxis2 = [0, 3, 0]", "", "axis2"),
    (', axis = [0, 0, 5]', "", "axis"),
    ("axis = [0, 0, 5]", "axis = [0, 0, 5], axis2 = [1, 0, 0]",
     "axis2: is for universal joints; 'table' is planar"),
    ("axis = [0, 0, 5]", "axis = [0, 0, 5], limits = { effort = 1 }",
     "limits: is for revolute, prismatic and spherical joints; 'table' is planar"),
    ("axis = [0, 0, 5]", "axis = [0, 0, 0]", "axis: is zero; wanted a direction"),
    ("table = [1, 2,", "table = [2,", "table"),
    ('"universal"', '"cardan"', "did you mean 'universal'?"),
    ("[start.q]", "[effects.limit.table]\nk = 1\n[start.q]",
     "limit cannot act on joint 'table', which is planar"),
    ("[start.q]", '[effects.limit]\njoints = "all"\nk = 1\n[start.q]',
     "no joint of the model is revolute or prismatic, as limit needs: 'table' is planar, "
     "'wrist' is universal")])
def test_wrong_joints_are_refused(tmp_path, old, new, message):
    text = TEXT.replace(old, new) if old in TEXT else TEXT.replace(old.replace("\\\n", ""), new)
    assert text != TEXT
    with pytest.raises(SceneError) as caught:
        read(tmp_path, text)
    assert message in str(caught.value)


def test_their_numbers_have_names_and_units(tmp_path):
    scene = read(tmp_path)
    assert recorded("q.table", scene).units == ("m", "m", "rad")
    assert recorded("v", scene).names == ("v.table.0", "v.table.1", "v.table.2", "v.wrist.0",
                                          "v.wrist.1")
    assert recorded("a.wrist", scene).units == ("rad/s^2",) * 2
    result = candidates(scene, {})
    assert {x for x in result if x.startswith("start.q")} == {
        "start.q.table.0", "start.q.table.1", "start.q.table.2", "start.q.wrist.0",
        "start.q.wrist.1"}
    assert result["start.v.table.2"].unit == "rad/s"


def test_urdf_has_planar_joints_across_their_axis(tmp_path):
    """The axis is x unless it is given, as for others; what no effect takes is told."""
    for more, axis in (("", (1, 0, 0)), ('<axis xyz="0 -2 0"/>', (0, -1, 0))):
        (tmp_path / "r.urdf").write_text(URDF.replace("MORE", more))
        joint = read(tmp_path, 'model = "r.urdf"\n').model.joints[-1]
        assert (joint.kind, joint.axis) == (Kind.PLANAR, axis)
    (tmp_path / "r.urdf").write_text(URDF.replace(
        "MORE", '<axis xyz="0 0 1"/><dynamics damping="3"/><limit effort="2" velocity="1"/>'))
    messages = [x.text for x in read(tmp_path, 'model = "r.urdf"\n').notices]
    assert any("effort 2 of <limit> is used by no effect of a planar joint" in x for x in messages)
    assert read(tmp_path, 'model = "r.urdf"\n').model.joints[-1].damping == 3
    assert [x.name for x in read_scene(tmp_path / "r.urdf").effects] == ["gravity", "viscous.table"]
    (tmp_path / "r.urdf").write_text(URDF.replace("MORE", '<axis xyz="0 0 0"/>'))
    with pytest.raises(SceneError, match="the axis is zero"):
        read(tmp_path, 'model = "r.urdf"\n')
