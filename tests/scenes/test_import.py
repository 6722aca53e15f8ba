"""`coscrew import` writes a scene of plain tables that moves, to the bit, as the file alone."""

import mujoco
import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.mujoco_pairs import compared

LINK = ('<link name="{0}"><inertial><origin xyz="0.1 0 0.2" rpy="0.3 0.1 0.2"/><mass value="{1}"/>'
        '<inertia ixx="0.05" iyy="0.06" izz="0.07" ixy="0.01" ixz="0" iyz="0"/></inertial></link>')
JOINT = ('<joint name="{0}" type="{1}"><parent link="{2}"/><child link="{3}"/><origin xyz="0.1 0.2 '
         '0.3" rpy="0.1 0.2 1.57079632679"/><axis xyz="0.3 1 2"/>{4}</joint>')
URDF = (f'<robot name="arm"><link name="foot"/>{LINK.format("a b", "1.5")}{LINK.format("c", "2")}'
        f'{LINK.format("d", "0.5")}'
        + JOINT.format("one.pin", "revolute", "foot", "a b", '<limit lower="-1" upper="2" '
                       'effort="3" velocity="inf"/><dynamics damping="0.25" friction="2"/>')
        + JOINT.format("slide", "prismatic", "a b", "c", '<mimic joint="one.pin" multiplier="0.5" '
                       'offset="0.1"/>')
        + JOINT.format("mount", "fixed", "c", "d", "") + JOINT.format(
            "ball", "spherical", "d", "e", '<dynamics damping="1"/>') + LINK.format("e", "1")
        + "</robot>")
MJCF = """<mujoco><worldbody><body name="trunk" pos="0 0 0.7" quat="0.9 0.1 0.2 0.3">
<freejoint name="root"/><geom type="box" size="0.1 0.2 0.05" euler="10 20 30"/>
<body name="leg" pos="0.1 0.2 0" gravcomp="0.25"><geom size="0.05" pos="0.1 0 0"/>
<joint name="knee" axis="0 1 0.5" ref="20" stiffness="5" armature="0.3" damping="0.1" pos="0 0 0.02"
/><body pos="0 0 -0.3"><joint name="ankle" type="ball" stiffness="3" damping="0.2" armature="0.1"/>
<geom size="0.05" pos="0.02 0 0"/><body><joint name="toe" type="slide" axis="0 1 0"/>
<geom size="0.05"/></body></body></body></body></worldbody>
<tendon><fixed name="knee" stiffness="7" damping="0.5"><joint joint="knee" coef="0.5"/>
<joint joint="toe" coef="-1"/></fixed></tendon><actuator><motor joint="toe" gear="3"/>
<position name="knee" joint="knee" kp="20" kv="1"/></actuator></mujoco>"""
SDF = """<sdf version="1.9"><model name="m"><link name="l"><pose degrees="true">0 0 1 30 0 0</pose>
<inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial></link>
<gz:extra/></model></sdf>"""


@pytest.fixture
def written(tmp_path, capsys):
    """The files that are written, and what is imported."""
    def written(text, name):
        source, target = tmp_path / name, tmp_path / "scene.toml"
        source.write_text(text)
        target.unlink(missing_ok=True)
        assert main(["import", str(source), "-o", str(target)]) == 0, capsys.readouterr().err
        return source, target

    return written


@pytest.mark.parametrize(("text", "name"), (
    (URDF, "arm.urdf"), (MJCF, "leg.xml"), (SDF, "body.sdf")))
def test_it_moves_as_the_file_to_the_bit(written, text, name):
    both = [load_scene(x, functions=["inverse_dynamics"]) for x in written(text, name)]
    given = [[0.3] * len(both[0].scene.parameters)] if both[0].scene.parameters else []
    one, other = (x.scene for x in both)
    assert one.model.bodies and [x.name for x in one.model.bodies] == [
        x.name for x in other.model.bodies]
    assert [(x.name, x.kind, x.lower, x.upper, x.effort, x.velocity, x.damping, x.friction, x.mimic)
            for x in one.model.joints] == [
        (x.name, x.kind, x.lower, x.upper, x.effort, x.velocity, x.damping, x.friction, x.mimic)
        for x in other.model.joints]
    assert [x.name for x in one.effects] == [x.name for x in other.effects]
    assert (one.start_q, one.name) == (other.start_q, other.name)
    assert one.parameters == other.parameters and len(one.parameters) == 2 * (text is MJCF)
    rng = np.random.default_rng(3)
    for _ in range(5):
        q = both[0].neutral_q + rng.normal(size=both[0].NQ)
        v, a = rng.normal(size=(2, both[0].NV))
        results = [x.double.inverse_dynamics(*given, q, v, a).tolist() for x in both]
        assert [x.hex() for x in results[0]] == [x.hex() for x in results[1]]


def test_it_moves_as_mujoco(written):
    source, target = written(MJCF, "leg.xml")
    worst = compared(read_scene(target), mujoco.MjModel.from_xml_path(str(source)))
    assert max(worst.mass_matrix, worst.bias, worst.torques) < 2e-13, worst


def test_what_a_scene_does_not_hold_is_in_comments(written):
    _, target = written(URDF, "arm.urdf")
    text = target.read_text()
    assert text.startswith("# Made of arm.urdf by `coscrew import`.\n# joint one.pin: arm.urdf, "
                           "line 1: 'velocity' of <limit>: inf is not finite; wanted a number\n")
    assert 'ball = { type = "spherical", parent = "d", child = "e"' in text
    assert '"one.pin" = { type = "revolute", parent = "foot", child = "a b", origin = { x' in text
    assert "[effects.mimic]\n" in text and '[effects.viscous]\njoints = ["one.pin", "ball"]' in text
    assert 'limits = { lower = -1, upper = 2, effort = 3 }, damping = 0.25, friction = 2' in text
    assert "shapes are not written" not in text
    shape = '<link name="d"><collision><geometry><sphere radius="1"/></geometry></collision>'
    _, target = written(URDF.replace('<link name="d">', shape), "round.urdf")
    assert ('# 1 collision shape is not written: a scene with model = "round.urdf" has it\n'
            in target.read_text())
    shape += "<visual><geometry><sphere radius='1'/></geometry></visual>"
    _, target = written(URDF.replace('<link name="d">', shape), "seen.urdf")
    assert ('# 1 visual and 1 collision shapes are not written: a scene with model = "seen.urdf" '
            "has them\n" in target.read_text())
    _, target = written(SDF, "body.sdf")
    assert "# line 3: <gz:extra> is another tool's and is not used" in target.read_text()
    _, target = written(URDF.replace('lower="-1"', 'lower="3"'), "wrong.urdf")
    assert target.read_text().count("lower limit 3 is above the upper one, 2") == 1


def test_inertias_that_no_body_has_stay_accepted(tmp_path, capsys):
    text = URDF.replace('ixx="0.05"', 'ixx="5"')
    (tmp_path / "arm.urdf").write_text(text)
    assert main(["import", str(tmp_path / "arm.urdf")]) == 2
    assert main(["import", str(tmp_path / "arm.urdf"), "--implausible", "warn"]) == 0
    printed = capsys.readouterr().out
    assert '\nimplausible = "warn"\n' in printed
    (tmp_path / "out.toml").write_text(printed)
    assert read_scene(tmp_path / "out.toml").model.implausible


def test_files_that_are_not_written(tmp_path, capsys):
    (tmp_path / "arm.urdf").write_text(URDF)
    (tmp_path / "arm.toml").write_text("")
    for words, text in ((["arm.urdf", "-o", "arm.toml"], "is there already; wanted another name"),
                        (["arm.urdf", "-o", "arm.txt"], "wanted a name that ends in .toml"),
                        (["arm.toml"], "is a scene; wanted a model's file"),
                        (["arm.step"], "has the suffix '.step'; wanted a scene (.toml) or a mo")):
        files = [x if x == "-o" else str(tmp_path / x) for x in words]
        assert main(["import", *files]) == 2
        assert text in capsys.readouterr().err


@pytest.mark.parametrize("wxyz", ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1),
                                  (1, 2, 3, 4), (1, -2, 0.5, 0), (-0.125, 1, 1, 1), (0, 1, 1, 0)))
def test_quaternions_of_rotations(wxyz):
    """R of the quaternion of R is R, to 49 digits."""
    w, x, y, z = (decimal(str(n)) for n in wxyz)
    R = rotations.from_quaternion((x, y, z, w))
    again = rotations.from_quaternion(rotations.quaternion(R))
    assert all(abs(a - b) < decimal("1e-48") for a, b in zip(R, again, strict=True))
