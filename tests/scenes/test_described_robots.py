"""Names of robots of the package robot_descriptions, and the arguments by which a file is read.

A package of the same form stands in for robot_descriptions, which fetches files from the network.
"""

import sys

import pytest

from coscrew_codegen import again, load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.sdf_texts import chain, hinge

URDF = """<robot name="r"><link name="base"/><link name="{0}arm"><inertial><mass value="2"/>
<origin xyz="0 0 1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="{0}pin" type="continuous"><parent link="base"/><child link="{0}arm"/>
<axis xyz="0 1 0"/></joint></robot>"""
XACRO = ('<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="side" '
         'default="r"/><xacro:include filename="$(find parts)/arm.xacro"/></robot>')
INSIDE = URDF.format("$(arg side)_").replace("<robot name", "<robot xmlns:xacro="
                                             '"http://www.ros.org/wiki/xacro" name')


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package robot_descriptions with a URDF, an MJCF, a file of xacro, and faults."""
    folder = tmp_path / "site/robot_descriptions"
    (tmp_path / "away/ros").mkdir(parents=True)
    folder.mkdir(parents=True)
    files = {"panda": f"URDF_PATH = {str(tmp_path / 'panda.urdf')!r}",
             "two_mj": f"MJCF_PATH = {str(tmp_path / 'two.xml')!r}",
             "fr3": f"XACRO_PATH = {str(tmp_path / 'fr3.urdf.xacro')!r}\\nXACRO_ARGS = "
                    "{'side': 'l'}\\nXACRO_PACKAGE_PATHS = "
                    f"{{'parts': {str(tmp_path / 'away/ros')!r}}}",
             "away": "raise OSError('no network here')", "only_srdf": "SRDF_PATH = 'x'"}
    for name, text in files.items():
        (folder / f"{name}_description.py").write_text(text.replace("\\n", "\n"))
    (folder / "__init__.py").write_text(
        f"DESCRIPTIONS = {dict.fromkeys(f'{x}_description' for x in files)!r}")
    (tmp_path / "panda.urdf").write_text(URDF.format(""))
    (tmp_path / "fr3.urdf.xacro").write_text(XACRO)
    (tmp_path / "away/ros/arm.xacro").write_text(INSIDE)
    (tmp_path / "two.xml").write_text(
        '<mujoco><worldbody><body><joint name="pin" axis="0 1 0"/><geom size="0.1" pos="0 0 1"/>'
        "</body></worldbody></mujoco>")
    monkeypatch.syspath_prepend(str(folder.parent))
    monkeypatch.chdir(tmp_path)
    for name in [x for x in sys.modules if x.partition(".")[0] == "robot_descriptions"]:
        monkeypatch.delitem(sys.modules, name)
    yield tmp_path
    for name in [x for x in sys.modules if x.partition(".")[0] == "robot_descriptions"]:
        del sys.modules[name]


@pytest.mark.parametrize("name", ["panda", "panda_description"])
def test_a_robot_by_name_is_that_of_its_file(package, name):
    """From Python, from a scene, attached, and in commands."""
    named = f"robot_descriptions:{name}"
    (package / "own.toml").write_text(f'model = "{named}"\n[attach.b]\nmodel = "{named}"\n'
                                      'to = "arm"\n[effects.gravity]\n')
    assert load_scene(named, functions=["energy"]).scene.model == \
        read_scene(package / "panda.urdf").model
    model = read_scene(package / "own.toml").model
    assert [x.name for x in model.joints if x.kind.moves] == ["pin", "b_pin"]
    assert main(["import", named, "-o", str(package / "plain.toml")]) == 0
    assert read_scene(package / "plain.toml").model.joints == \
        read_scene(package / "panda.urdf").model.joints


def test_formats_and_arguments_are_those_of_the_package(package):
    """A file of xacro has the package's arguments and folders, which the caller's override."""
    pytest.importorskip("mujoco")
    pytest.importorskip("xacro")
    assert load_scene("robot_descriptions:two_mj", functions=["energy"]).joints == ("pin",)
    assert load_scene("robot_descriptions:fr3", functions=["energy"]).joints == ("l_pin",)
    assert load_scene("robot_descriptions:fr3", functions=["energy"],
                      arguments={"side": "x"}).joints == ("x_pin",)


@pytest.mark.parametrize(("name", "words"), [
    ("pnada", "is no robot of robot_descriptions; did you mean 'panda'?"),
    ("away", "cannot be fetched: no network here"),
    ("only_srdf", "has no model; wanted one of URDF_PATH, MJCF_PATH, XACRO_PATH")])
def test_what_cannot_be_had_is_refused_in_a_line(package, name, words):
    with pytest.raises(SceneError) as caught:
        load_scene(f"robot_descriptions:{name}")
    assert words in str(caught.value) and "\n" not in str(caught.value)
    (package / "own.toml").write_text(f'model = "robot_descriptions:{name}"\n')
    with pytest.raises(SceneError, match=r"own\.toml: model: ") as caught:
        load_scene(package / "own.toml")
    assert words in str(caught.value)


def test_without_the_package_there_is_one_command(monkeypatch):
    monkeypatch.setattr("coscrew_codegen.scene.readers.described_robots.find_spec",
                        lambda name: None)
    with pytest.raises(SceneError, match="^robot_descriptions:panda: needs the package "
                                         "robot_descriptions; run `pip install robot_desc"):
        load_scene("robot_descriptions:panda")


def test_python_reads_files_as_the_commands_do(package, capsys):
    """Arguments, packages and groups to leave out; a run, and the run once more."""
    pytest.importorskip("xacro")
    given = {"arguments": {"side": "l"}, "packages": {"parts": package / "away/ros"}}
    file = package / "fr3.urdf.xacro"
    assert load_scene(file, functions=["energy"], **given).joints == ("l_pin",)
    result = run(file, q0=[0.5], until=0.02, **given)
    assert (again(file, result, **given).q == result.q).all()
    assert main(["simulate", str(file), "--argument", "side=l", "--package", f"parts={package}/"
                 "away/ros", "--until", "0.02"]) == 0
    assert "l_pin" in capsys.readouterr().out
    (package / "swing.sdf").write_text(chain(hinge()))
    with pytest.raises(SceneError, match="'fluid'; wanted .*loops"):
        load_scene(package / "swing.sdf", leave_out=["fluid"])


def test_wrong_arguments_are_refused_by_name(package):
    with pytest.raises(TypeError, match="packages: wanted a mapping from names to texts, as "):
        load_scene(package / "panda.urdf", packages=[("a", "b")])
    with pytest.raises(TypeError, match=r"arguments: wanted a mapping .*; got {'n': 1}"):
        run(package / "panda.urdf", arguments={"n": 1})
    with pytest.raises(TypeError, match='leave_out: wanted a list of names, as ."loops".'):
        load_scene(package / "panda.urdf", leave_out="loops")
    kernels = load_scene(package / "panda.urdf", functions=["energy"])
    with pytest.raises(TypeError, match="load_scene: packages, leave_out are for a file; wanted"):
        load_scene(kernels.scene, packages={"a": "b"}, leave_out=["loops"])
    with pytest.raises(TypeError, match="run: arguments is for a file; wanted the path of one"):
        run(kernels, arguments={"a": "b"})
