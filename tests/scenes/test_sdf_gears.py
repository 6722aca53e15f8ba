"""Gearboxes of SDF files: theta_2 = -ratio theta_1, the angles of two links against a third in the
directions of both axes, whatever the senses of the joints that turn them."""

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.scenes.sdf_texts import inertial

AXIS = "<axis><xyz>{}</xyz></axis>"
IZZ = 0.07  # of inertial()


def joint(name, parent, child, axis="0 0 1", kind="revolute", more=""):
    return (f'<joint name="{name}" type="{kind}"><parent>{parent}</parent><child>{child}</child>'
            f"{AXIS.format(axis)}{more}</joint>")


def gear(ratio="3", first="0 0 1", second="0 0 1", body="frame"):
    more = (f"{AXIS.format(second).replace('axis>', 'axis2>')}<gearbox_ratio>{ratio}"
            f"</gearbox_ratio><gearbox_reference_body>{body}</gearbox_reference_body>")
    return joint("gear", "sun", "planet", first, "gearbox", more)


def text(joints):
    links = "".join(f'<link name="{x}"><pose>{i} 0 0 0 0 0</pose>{inertial(1)}</link>'
                    for i, x in enumerate(("frame", "sun", "planet")))
    fixed = '<joint name="hold" type="fixed"><parent>world</parent><child>frame</child></joint>'
    return f'<sdf version="1.9"><model name="m">{links}{fixed}{joints}</model></sdf>'


SUN, PLANET = joint("s", "frame", "sun"), joint("p", "frame", "planet")


@pytest.fixture
def read(tmp_path):
    def read(joints, **overrides):
        (tmp_path / "gears.sdf").write_text(text(joints))
        return read_scene(tmp_path / "gears.sdf", overrides=SceneOverrides(**overrides))

    return read


def angle(pose):
    return np.arctan2(pose[1, 0], pose[0, 0])


@pytest.mark.parametrize("joints, sense", (
    (SUN + PLANET + gear(), -3),
    (SUN + joint("p", "frame", "planet", "0 0 -1") + gear(), -3),
    (joint("s", "frame", "sun", "0 0 -2") + PLANET + gear(), -3),
    (SUN + PLANET + gear(second="0 0 -1"), 3),
    (SUN + PLANET + gear(first="0 0 -4", second="0 0 -1"), -3),
    (gear("-3") + PLANET + SUN, 3)))
def test_links_turn_as_the_gearbox_says(read, joints, sense):
    """Angles about z in the world, at rest; the mass is I + ratio² I at the sun's angle."""
    scene = read(joints)
    assert [x.name for x in scene.effects] == ["gravity", "mimic"]
    kernels = load_scene(scene, functions=["body_poses", "mass_matrix"])
    assert len(kernels.neutral_q) == 1
    poses = dict(zip(kernels.bodies, kernels.double.body_poses([0.2]), strict=True))
    sun, planet = angle(poses["sun"]), angle(poses["planet"])
    assert abs(sun) == pytest.approx(0.2) and planet == pytest.approx(sense * sun, rel=1e-14)
    assert kernels.double.mass_matrix([0.2])[0, 0] == pytest.approx(IZZ * (1 + 9), rel=1e-14)


def test_a_link_may_carry_the_reference_body(read, tmp_path):
    """The sun is held, and carries the frame: its angle against the frame is that of the joint,
    backwards."""
    path = tmp_path / "carried.sdf"
    path.write_text(text(joint("s", "sun", "frame") + PLANET + gear()).replace(
        "<child>frame</child></joint>", "<child>sun</child></joint>", 1))
    kernels = load_scene(read_scene(path), functions=["body_poses"])
    poses = dict(zip(kernels.bodies, kernels.double.body_poses([0.2]), strict=True))
    carrier, planet = (angle(poses[x]) for x in ("frame", "planet"))
    assert carrier == pytest.approx(0.2) and planet - carrier == pytest.approx(0.6, rel=1e-13)


def test_gearboxes_are_left_out_on_demand(read):
    scene = read(SUN + PLANET + gear(), leave_out=("gearboxes",))
    assert not any(x.mimic for x in scene.model.joints)
    assert "joint gear: left out (gearboxes)" in scene.unused


FOLLOWS = PLANET.replace("</axis>", '<mimic joint="s"><multiplier>1</multiplier></mimic></axis>')


@pytest.mark.parametrize("joints, words", (
    (SUN + PLANET + gear(second="1 0 0"), "no revolute joint of the tree about its <axis2> "
     "connects 'planet' with 'frame'; wanted one, or leave_out = [\"gearboxes\"]"),
    (SUN + joint("p", "frame", "planet", kind="prismatic") + gear(), "about its <axis2> connects"),
    (SUN + PLANET + gear(body="sun"), "about its <axis> connects 'sun' with 'sun'"),
    (SUN + PLANET + gear(body="none"), "no frame 'none'"),
    (SUN + FOLLOWS + gear(), "joint 'p' follows another already; wanted one gear, or leave_out"),
    (SUN + PLANET + gear("x"), "<gearbox_ratio> of <joint>: 'x' is no number")))
def test_gearboxes_that_turn_no_joint_are_refused(read, joints, words):
    with pytest.raises(SceneError) as caught:
        read(joints)
    assert words in str(caught.value) and "joint 'gear'" in str(caught.value)
