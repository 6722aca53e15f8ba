"""Refusals of readers that few files meet: the place, what came and what was wanted."""

import re
from fractions import Fraction

import pytest

from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.rotations import unit
from coscrew_codegen.scene.readers.declared_effects import notices
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.readers.toml.toml_text import toml_value
from tests.support.scenes.sdf_texts import chain, hinge, inertial

OWN = """[bodies.b]
mass = 1
inertia = [1, 1, 1]
[joints.j]
type = "continuous"
child = "b"
axis = [0, 0, 1]
"""
URDF = """<robot name="r" version="1.0"><link name="a"/><link name="b"><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="j" type="continuous"><parent link="a"/><child link="b"/><origin xyz="0 0 0"/></joint>
</robot>"""
VERSION_1_1 = URDF.replace('version="1.0"', 'version="1.1"')
QUATERNION = 'xyz="0 0 0" quat_xyzw="{}"'
MIMICS = URDF.replace("<origin", '<mimic joint="k"/><origin')

SCENES = {
    "number": (OWN.replace("mass = 1", "mass = 1e301"), "bodies.b.mass",
               "'1e301' is out of range; wanted 0, or 1e-300 to 1e300 in size"),
    "small number": (OWN.replace("mass = 1", "mass = 1e-301"), "bodies.b.mass",
                     "'1e-301' is out of range; wanted 0, or 1e-300"),
    "angle alone": (f"{OWN}origin = {{ angle = 1 }}", "joints.j.origin.axis",
                    "missing; wanted the axis to turn about"),
    "label of a body": (f"{OWN}[effects.wrench.b]\nbody = \"b\"\nforce = [1, 0, 0]",
                        "effects.wrench.b.body", "'b' is itself a body; wanted another label"),
    "no identifier": (f'name = "6 dof"\n{OWN}', "name", "'6 dof' is no identifier: a letter, then "
                      "letters, digits and _; wanted a C identifier such as 'scene_6_dof'"),
    "expected number": (f'{OWN}[expect]\n"q.j" = [1]', "expect.'q.j'",
                        "the number 1; wanted a table: at, value, rtol"),
    "no tolerance": (f'{OWN}[expect]\n"q.j" = {{ at = 0, value = 0 }}', "expect.'q.j'.rtol",
                     "missing; wanted a tolerance: rtol, atol or both"),
    "nested": (f"x = {'[' * 5000}{']' * 5000}", "", "lists or tables are nested too deeply"),
    "masses of a model": (f'{OWN}[attach.x]\nmodel = "m.urdf"\nto = "b"\nmass = 1',
                          "attach.x.mass", "the model that `model` names has masses; wanted one "
                          "of both"),
    "faulty follower": ('model = "m.urdf"\n[effects.mimic]\n', "effects.mimic", "joint 'j' cannot "
                        "follow (m.urdf, line 3: mimics 'k', which is no joint; wanted one of "
                        "base, j); mend the file, or leave out mimic"),
}


@pytest.mark.parametrize(("text", "where", "words"), SCENES.values(), ids=SCENES)
def test_scenes(tmp_path, text, where, words):
    (tmp_path / "m.urdf").write_text(MIMICS)
    (tmp_path / "own.toml").write_text(text)
    with pytest.raises(SceneError) as caught:
        read_scene(tmp_path / "own.toml")
    assert (caught.value.where, words in str(caught.value)) == (where, True), str(caught.value)


MODELS = {
    "quaternion of later": ("urdf", URDF.replace('xyz="0 0 0"', QUATERNION.format("0 0 0 1")),
                            "'quat_xyzw' of <origin> is of URDF 1.1; wanted <robot version="),
    "two rotations": ("urdf", VERSION_1_1.replace('xyz="0 0 0"', QUATERNION.format(
        "0 0 0 1") + ' rpy="0 0 0"'), "'rpy' and 'quat_xyzw' of <origin>; wanted one of both"),
    "no rotation": ("urdf", VERSION_1_1.replace('xyz="0 0 0"', QUATERNION.format("0 0 0 0")),
                    "'quat_xyzw' of <origin> is zero; wanted x, y, z, w"),
    "not symmetric": ("urdf", URDF.replace('ixy="0"', 'ixy="0" iyx="0.1"'),
                      "'iyx' of <inertia> is not 'ixy'; wanted a symmetric matrix"),
    "no parent": ("urdf", URDF.replace('<parent link="a"/>', ""), "<joint> lacks <parent>"),
    "unclosed": ("urdf", "<robot><link>", "no element found; wanted well-formed XML"),
    "deep": ("urdf", f"<robot>{'<a>' * 100}", "elements are nested deeper than 100"),
    "kinematic": ("sdf", chain(hinge()).replace("</link>", "<kinematic>1</kinematic></link>", 1),
                  "<kinematic> is 1; wanted false, as without <kinematic>"),
    "no moment": ("sdf", chain(hinge()).replace(inertial(1), inertial(1).replace("ixx", "gone")
                                                .replace("<gone>", "<!--").replace(
                                                    "</gone>", "-->"), 1),
                  "<inertia> lacks <ixx>"),
    "empty model": ("sdf", chain(hinge(parent="n"), more='<model name="n"/>'),
                    "model 'n': has no link"),
}


@pytest.mark.parametrize(("suffix", "text", "words"), MODELS.values(), ids=MODELS)
def test_models(tmp_path, suffix, text, words):
    path = tmp_path / f"m.{suffix}"
    path.write_text(text)
    with pytest.raises(SceneError, match="line [0-9]+") as caught:
        read_scene(path)
    assert words in str(caught.value)


def test_a_visual_without_a_shape_is_kept_as_a_problem(tmp_path):
    """It changes no motion, so that nothing is refused."""
    (tmp_path / "m.sdf").write_text(chain(hinge()).replace(
        "</link>", '<visual name="v"><geometry/></visual></link>', 1))
    (visual,) = (y for x in read_scene(tmp_path / "m.sdf").model.bodies for y in x.visuals)
    assert visual.problem.endswith("<visual> has 0 shapes; wanted one")


def test_numbers_and_values_that_no_file_gives():
    """Errors of the generator itself, which readers never let happen."""
    with pytest.raises(ValueError, match="the vector is zero"):
        unit([Fraction(0)] * 3)
    with pytest.raises(TypeError, match=re.escape("{1} is no value of TOML")):
        toml_value({1})


def test_notices_have_a_subject_that_is_known():
    """Effects that a file may declare are known subjects, too."""
    with pytest.raises(ValueError, match="a notice of 'range'; wanted one of weight, torque or "):
        Notice("range", "joint j", "joint j: range")
    model = Model("m", (), ())
    for effect in EFFECTS:
        (notice,) = notices({effect.name: {"j": {"k": 1}}}, model)
        assert notice.remedy == f"add [effects.{effect.name}.j] with k = 1"
