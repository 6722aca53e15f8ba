"""A model's file alone is a scene: gravity acts, and what the file declares, and nothing else."""

import math

import mpmath
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.mechanism.model import Body, Inertia, Joint
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.model_reader import ModelReader, Parts
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals
from tests.support.scenes.kinds import Kind

LINK = ('<link name="{0}"><inertial><origin xyz="0 0 -0.5"/><mass value="2"/><inertia ixx="0.25" '
        'iyy="0.25" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>')
JOINT = ('<joint name="{0}" type="revolute"><parent link="{1}"/><child link="{2}"/>'
         '<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="9" velocity="9"/>{3}</joint>')


def pendulum(*inside):
    """Joints one, two, … in a chain, each with this inside."""
    names = ["one", "two", "three"][:len(inside)]
    links = "".join(LINK.format(f"link {x}") for x in names)
    parents = ["foot", *(f"link {x}" for x in names)]
    joints = "".join(JOINT.format(x, parent, f"link {x}", y)
                     for x, parent, y in zip(names, parents, inside, strict=False))
    return f'<robot name="r"><link name="foot"/>{links}{joints}</robot>'


@pytest.fixture
def read(tmp_path):
    def read(text, **overrides):
        path = tmp_path / "my-arm.urdf"
        path.write_text(text)
        return read_scene(path, overrides=SceneOverrides(**overrides))

    return read


def test_gravity_and_damping_act(tmp_path):
    """tau = (I + m l²) a + d v + m g l sin q."""
    (tmp_path / "arm.urdf").write_text(pendulum('<dynamics damping="0.75" friction="3"/>'))
    its = load_scene(tmp_path / "arm.urdf", functions=["inverse_dynamics"]).double
    tau, = its.inverse_dynamics([0.5], [2.0], [4.0])
    with mpmath.workdps(50):
        want = mpmath.mpf("0.75") * (4 + 2) + mpmath.mpf("9.81") * mpmath.sin(0.5)
    assert abs(mpmath.mpf(float(tau)) - want) <= 2 * math.ulp(float(want))


def test_it_is_the_scene_with_these_effects(read, tmp_path):
    """The content, which is hashed for the cache, is the same; limits and friction are reported."""
    alone = read(pendulum('<dynamics damping="0.75" friction="3"/>', ""))
    (tmp_path / "written.toml").write_text(
        'model = "my-arm.urdf"\nname = "my_arm"\n[effects.gravity]\n[effects.viscous.one]\n'
        'd = "model"\n')
    written = read_scene(tmp_path / "written.toml")
    assert [x.name for x in alone.effects] == ["gravity", "viscous.one"]
    assert alone.content_hash == written.content_hash and alone.unused == written.unused
    assert alone.unused[0].startswith("joint one: friction 3 N m is not used: add [effects.coulomb")


def test_settings_of_commands_hold(read):
    scene = read(pendulum(""), precision="single", implausible="warn", tiers=("accurate",),
                 functions=("energy",))
    assert (scene.precision, scene.implausible, scene.functions) == ("single", "warn", ("energy",))
    assert "accurate" in scene.tiers and scene.name == "my_arm"


MIMIC = '<mimic joint="{}" multiplier="2"/>'


def test_followers_follow_if_all_can(read):
    good = read(pendulum("", MIMIC.format("one"), MIMIC.format("two")))
    assert [x.name for x in good.effects] == ["gravity", "mimic"]
    wrong = read(pendulum("", MIMIC.format("one"), MIMIC.format("none")))
    assert [x.name for x in wrong.effects] == ["gravity"]
    for words in ("joint two: mimic of one (multiplier 2, offset 0) is not used: add [effects.mi",
                  "joint three: mimic is not used, and cannot be: my-arm.urdf, line 1: mimics 'no"):
        assert any(line.startswith(words) for line in wrong.unused)


def test_a_wrong_damping_is_told(read):
    scene = read(pendulum('<dynamics damping="1"/>', '<dynamics damping="-1"/>',
                          '<dynamics damping="0"/>'))
    assert [x.name for x in scene.effects] == ["gravity", "viscous.one"]
    assert any(x.startswith("joint two: damping is not used, and cannot be: my-arm.urdf, line 1")
               for x in scene.unused)


def wheel(**effects):
    """A format whose files hold a wheel with these effects."""
    one = decimal("1")
    inertia = Inertia(one, (one - one,) * 3, (one,) * 3 + (one - one,) * 3)
    pin = Joint("my pin", Kind.REVOLUTE, "world", "rim")
    parts = Parts("wheel", (Body("rim", inertia),), (pin,), effects=effects)
    return ModelReader("Wheel", (".wheel",), "a wheel", lambda source: parts)


@pytest.fixture
def declared(tmp_path, monkeypatch):
    """Reads a wheel with effects: alone, or in a scene with further text."""
    def declared(text, **effects):
        monkeypatch.setattr("coscrew_codegen.scene.readers.model_formats.readers",
                            lambda: (wheel(**effects),))
        (tmp_path / "w.wheel").touch()
        if text is None:
            return read_scene(tmp_path / "w.wheel", EFFECTS)
        (tmp_path / "w.toml").write_text(f'model = "w.wheel"\n{text}')
        return read_scene(tmp_path / "w.toml", EFFECTS)

    return declared


SPRING = {"my pin": {"k": Decimals("3.5"), "q0": Decimals("-0.25")}}
FALLS = {"g": [0, 0, Decimals("-1.62")]}


def test_effects_that_a_file_declares_act_in_it_alone(declared):
    scene = declared(None, spring=SPRING, gravity=FALLS)
    assert [x.name for x in scene.effects] == ["gravity", "spring.my pin"]
    assert [float(x) for x in scene.effects[0].values["g"]] == [0, 0, -1.62]
    assert (scene.effects[1].values["k"], scene.effects[1].values["q0"]) == (3.5, -0.25)
    assert scene.unused == ()


def test_in_a_scene_they_are_told_with_what_to_write(declared):
    """Until the scene has such an effect there; what is written then is what the file declares."""
    messages = declared("", spring=SPRING, gravity=FALLS)
    assert messages.unused == (
        'joint my pin: spring of the model\'s file is not used: add [effects.spring."my pin"] with '
        "k = 3.5 and q0 = -0.25",
        "effect gravity: gravity of the model's file is not used: add [effects.gravity] with g = "
        "[0, 0, -1.62]")
    remedies = "\n".join(x.remedy.removeprefix("add ") for x in messages.notices)
    again = declared(remedies.replace(" with ", "\n").replace(" and ", "\n"), spring=SPRING,
                     gravity=FALLS)
    assert again.unused == ()
    alone = declared(None, spring=SPRING, gravity=FALLS)
    assert again.content_hash == alone.content_hash
    other = declared('[effects.gravity]\n[effects.spring."my pin"]\nk = 1\n', spring=SPRING,
                     gravity=FALLS)
    assert other.unused == ()
