"""Files of xacro are the URDF that they write; errors in them are told on one line."""

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from coscrew_codegen.scene.readers.xacro.xacro_reader import READER
from tests.support.scenes.reading import read_urdf

pytest.importorskip("xacro", reason='needs pip install "coscrew[xacro]"')

NS = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
LINK = ('<link name="{0}"><inertial><origin xyz="0 0 0.25"/><mass value="{1}"/>'
        '<inertia ixx="0.5" iyy="0.5" izz="0.5" ixy="0" ixz="0" iyz="0"/></inertial></link>')
JOINT = ('<joint name="{0}_pin" type="continuous"><parent link="{1}"/><child link="{0}"/>'
         '<origin xyz="0 0 {2}"/><axis xyz="0 1 0"/></joint>')
PLAIN = (f'<robot name="arm"><link name="foot"/>{LINK.format("upper", "1.5")}'
         f'{JOINT.format("upper", "foot", "0.5")}{LINK.format("l_hand", "0.75")}'
         f'{JOINT.format("l_hand", "upper", "1.0")}</robot>')
MACRO = (f'<robot {NS}><xacro:macro name="limb" params="name mass at on">'
         f'{LINK.format("${name}", "${mass}")}{JOINT.format("${name}", "${on}", "${at}")}'
         "</xacro:macro></robot>")
ARM = (f'<robot name="arm" {NS}><xacro:arg name="side" default="r"/>'
       '<xacro:include filename="$(find limbs)/macros/limb.xacro"/>\n'
       '<xacro:property name="m" value="1.5"/><link name="foot"/>\n'
       '<xacro:limb name="upper" mass="${m}" at="0.5" on="foot"/>\n'
       '<xacro:limb name="$(arg side)_hand" mass="${m/2}" at="${2*0.5}" on="upper"/></robot>')


@pytest.fixture
def site(tmp_path):
    """A folder with the arm beside its package, and the URDF that it writes with side = l."""
    (tmp_path / "robots").mkdir()
    (tmp_path / "limbs/macros").mkdir(parents=True)
    (tmp_path / "limbs/macros/limb.xacro").write_text(MACRO)
    (tmp_path / "robots/arm.urdf.xacro").write_text(ARM)
    (tmp_path / "plain.urdf").write_text(PLAIN)
    return tmp_path


def read(site, **words):
    return READER.read(ModelSource(site / "robots/arm.urdf.xacro", **words))


def test_it_is_the_urdf_that_it_writes(site):
    assert read(site, arguments={"side": "l"}) == read_urdf(site / "plain.urdf")
    assert [x.name for x in read(site).joints] == ["base", "upper_pin", "r_hand_pin"]


def test_packages_are_found_by_name_or_description(site):
    """Beside the file or above it; what is given comes first."""
    folder = site / "limbs"
    moved = folder.rename(site / "limbs-2.1")
    with pytest.raises(SceneError, match="xacro: package 'limbs' is not beside the file or above "
                                         "it; wanted --package limbs=FOLDER, or packages") as error:
        read(site)
    assert str(error.value).count("is not beside") == 1
    (moved / "package.xml").write_text("<package><name> limbs </name></package>")
    assert len(read(site).joints) == 3
    (site / "other/macros").mkdir(parents=True)
    (site / "other/macros/limb.xacro").write_text(MACRO.replace("continuous", "prismatic"))
    given = read(site, packages={"limbs": site / "other"})
    assert {x.kind.name for x in given.joints[1:]} == {"prismatic"}


def test_scenes_and_commands_give_arguments_and_packages(site, capsys):
    (site / "limbs").rename(site / "else")
    scene = site / "robots/scene.toml"
    scene.write_text('model = "arm.urdf.xacro"\narguments = { side = "l" }\n'
                     'packages = { limbs = "../else" }\n[effects.gravity]\n')
    assert read_scene(scene).model == read_urdf(site / "plain.urdf")
    more = SceneOverrides(arguments=(("side", "m"),))
    assert read_scene(scene, overrides=more).model.joints[-1].name == "m_hand_pin"
    words = ["generate", str(site / "robots/arm.urdf.xacro"), "--package", f"limbs={site / 'else'}",
             "--argument", "side=l", "-o", str(site / "out")]
    assert main(words) == 0, capsys.readouterr().err
    assert "L_HAND_PIN" in (site / "out/arm.h").read_text().upper()
    assert main([*words[:-2], "--argument", "sid=x", "-o", str(site / "out")]) == 2
    assert "arm.urdf.xacro: has no argument 'sid'; did you mean 'side'?" in capsys.readouterr().err


@pytest.mark.parametrize(("old", "new", "words"), (
    ("${m/2}", "${n/2}", "arm.urdf.xacro: xacro: name 'n' is not defined"),
    ("${m/2}", "${m/}", "arm.urdf.xacro: xacro: "),
    ('<xacro:arg name="side" default="r"/>', "", "arm.urdf.xacro: needs the argument 'side'; "
     "wanted --argument side=VALUE, or arguments = { side = … } in the scene"),
    ("limb.xacro", "limbs.xacro", "limbs.xacro"),
    ("${m/2}", "-1", "body 'r_hand': mass -1 kg"),
    ("${m/2}", "x", "of what xacro makes of it: 'value' of <mass>: 'x' is no number"),
    ("</robot>", "", "arm.urdf.xacro: xacro: "), (' at="0.5"', "", "Undefined parameters [at]")))
def test_errors_are_told_on_one_line(site, old, new, words):
    (site / "robots/arm.urdf.xacro").write_text(ARM.replace(old, new))
    with pytest.raises(SceneError) as caught:
        read(site)
    assert words in str(caught.value) and "\n" not in str(caught.value)


def test_an_error_in_an_included_file_names_it(site):
    (site / "limbs/macros/limb.xacro").write_text(MACRO.replace("</robot>", ""))
    with pytest.raises(SceneError, match="arm.urdf.xacro: in limb.xacro: xacro: "):
        read(site)


def test_xacros_warnings_are_told(site):
    text = ARM.replace('name="m" value="1.5"', 'name="pi" value="1.5"').replace("${m", "${pi")
    (site / "robots/arm.urdf.xacro").write_text(text)
    messages = [x.text for x in read(site).notices]
    assert messages and messages[0].startswith("xacro warns: redefining global symbol: pi")


def test_other_formats_take_no_arguments(site, tmp_path):
    overrides = SceneOverrides(arguments=(("side", "l"),))
    with pytest.raises(SceneError, match="is URDF, which takes no arguments; wanted none, or a fi"):
        read_scene(site / "plain.urdf", overrides=overrides)
    scene = tmp_path / "scene.toml"
    scene.write_text('packages = { a = "b" }\n[bodies]\na = { mass = 1 }\n[joints]\n'
                     'p = { type = "prismatic", child = "a", axis = [1, 0, 0] }\n')
    with pytest.raises(SceneError, match="packages: is for a `model` that is a file of xacro"):
        read_scene(scene)


def test_nothing_stays_changed_in_xacro(site):
    from xacro import substitution_args

    before = substitution_args._eval_find, substitution_args._eval_dict["find"]
    read(site)
    (site / "robots/arm.urdf.xacro").write_text(ARM.replace("${m/2}", "${n}"))
    with pytest.raises(SceneError):
        read(site)
    assert (substitution_args._eval_find, substitution_args._eval_dict["find"]) == before
