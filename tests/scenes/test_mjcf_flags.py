"""MJCF files: what flags switch off is off here, too; masses, ranges and pairs easily lost."""

import mujoco
import pytest

from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.mujoco_pairs import mujoco_states
from tests.support.scenes.peer_states import derived, worst_of_programs

ROBOT = """<mujoco><option gravity="1 2 -9.81"/>
<default><geom type="capsule" size="0.05 0.2"/></default><worldbody>
<body gravcomp="0.7"><joint name="a" axis="0 1 0" stiffness="3" springref="0.2" damping="0.5"
  armature="0.1"/><geom name="x"/>
<body name="b" pos="0 0 -0.6"><joint name="b" axis="1 0 0" damping="0.1"/><geom name="y"/></body>
</body></worldbody>
<tendon><fixed name="t" stiffness="7" damping="2" springlength="0.3"><joint joint="a" coef="1"/>
<joint joint="b" coef="-2"/></fixed></tendon>MORE</mujoco>"""


@pytest.fixture
def read(tmp_path):
    def read(more="", old="MORE", new="MORE"):
        path = tmp_path / "robot.xml"
        path.write_text(ROBOT.replace(old, new).replace("MORE", more))
        return read_scene(path)

    return read


def worst(scene, path):
    """The largest difference from MuJoCo at two states."""
    functions = derived(scene)
    states = mujoco_states(scene, functions.coordinates, mujoco.MjModel.from_xml_path(str(path)), 2)
    return worst_of_programs(scene, functions, states).all


@pytest.mark.parametrize(("flags", "left"), (
    ('spring="disable"', {"viscous", "wrench"}), ('damper="disable"', {"spring", "wrench"}),
    ('gravity="disable"', {"spring", "viscous"}),
    ('spring="disable" damper="disable"', set())))
def test_flags_of_the_file_are_obeyed(read, tmp_path, flags, left):
    """Tendons obey, too; with neither springs nor dampers MuJoCo compensates no gravity."""
    scene = read(f"<option><flag {flags}/></option>")
    names = {x.effect.name for x in scene.effects}
    assert names & {"spring", "viscous", "wrench"} == left
    gravity = next(x for x in scene.effects if x.name == "gravity")
    assert any(gravity.values["g"]) == ("gravity" not in flags)
    assert worst(scene, tmp_path / "robot.xml") < 2e-14


@pytest.mark.parametrize("flag", ("equality", "constraint"))
def test_equalities_that_flags_switch_off_are_reported(read, flag):
    scene = read(f'<option><flag {flag}="disable"/></option><equality><joint joint1="a" '
                 'joint2="b"/></equality>')
    assert not any(x.mimic for x in scene.model.joints)
    assert "equality 0: is not active at the start, and not used" in scene.unused


def test_moments_without_mass_count(read, tmp_path):
    """A rotor without mass is fixed to the lower body."""
    rotor = '<body><inertial pos="0 0 0" mass="0" diaginertia="0.1 0.2 0.25"/></body>'
    scene = read(old='<geom name="y"/>', new=f'<geom name="y"/>{rotor}')
    assert worst(scene, tmp_path / "robot.xml") < 2e-14


@pytest.mark.parametrize("low", (-2, -1))
def test_ranges_of_what_actuators_exert_are_efforts_or_reported(read, low):
    """An effort is the same in both directions."""
    unused = read(old='name="b" axis', new='name="b" actuatorfrclimited="true" '
                  f'actuatorfrcrange="{low} 2" axis').unused
    held = f"what its actuators exert is held between {low} and 2 in MuJoCo, and not here"
    assert (f"joint b: {held}" in unused) == (low == -1)
    assert any(x.startswith("joint b: effort 2 N m is not used") for x in unused) == (low == -2)


def test_ranges_of_what_actuators_exert_on_tendons_are_reported(read):
    unused = read(old='name="t"', new='name="t" actuatorfrcrange="-1 3"').unused
    assert "tendon t: what its actuators exert is held between -1 and 3 in MuJoCo, and not here" \
        in unused


def test_geoms_of_a_pair_may_touch(read):
    """Geoms without bits by which others touch are kept, too."""
    scene = read('<contact><pair geom1="x" geom2="y"/></contact>', "<geom type",
                 '<geom contype="0" conaffinity="0" type')
    assert [x.name for x in scene.model.collisions] == ["x", "y"]
    assert any(x.startswith("pair of x and y: its friction and stiffness are not used")
               for x in scene.unused)
