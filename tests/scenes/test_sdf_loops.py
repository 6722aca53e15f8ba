"""Joints of an SDF whose links are the children of several: closed loops.

A parallelogram of two cranks and a coupler moves by its closed form."""

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene

M1, M2, M3, I1, I3, G = 2.0, 3.0, 0.5, 0.2, 0.1, 9.5


def link(name, at, com, mass, moment):
    return (f'<link name="{name}"><pose>{at} 0 0 0</pose><inertial><pose>{com} 0 0 0</pose><mass>'
            f"{mass}</mass><inertia><ixx>{moment}</ixx><iyy>{moment}</iyy><izz>{moment}</izz>"
            "</inertia></inertial></link>")


def joint(name, kind, parent, child, at="", axis="<axis><xyz>0 0 1</xyz></axis>"):
    pose = f"<pose>{at} 0.3 0.2 0.5</pose>" if at else ""
    if at:
        axis = axis.replace("<xyz>", '<xyz expressed_in="__model__">')
    return (f'<joint name="{name}" type="{kind}"><parent>{parent}</parent><child>{child}</child>'
            f"{pose}{axis}</joint>")


LINKS = (link("a", "0 0 0", "0 0.5 0", M1, I1) + link("b", "0 1 0", "1 0 0", M2, 1)
         + link("c", "2 0 0", "0 0.5 0", M3, I3))
TREE = (joint("pin", "revolute", "world", "a") + joint("knee", "revolute", "a", "b")
        + joint("other", "revolute", "world", "c"))
CLOSING = {"hinge": joint("close", "revolute", "b", "c", "0 1 0"),
           "point": joint("close", "ball", "b", "c", "0 1 0", "")}


def text(joints):
    return (f'<sdf version="1.9"><world name="w"><gravity>0 -{G} 0</gravity><model name="m">'
            f"{LINKS}{joints}</model></world></sdf>")


@pytest.fixture
def read(tmp_path):
    def read(joints, **overrides):
        (tmp_path / "bars.sdf").write_text(text(joints))
        return read_scene(tmp_path / "bars.sdf", overrides=SceneOverrides(**overrides))

    return read


@pytest.mark.parametrize("kind", CLOSING)
def test_a_parallelogram_moves_by_its_closed_form(read, kind):
    """J a = (m1/2 + m2 + m3/2) g sin q, with the moments of the cranks about their pins and m2 at
    their length, 1 m: to the accuracy of three proximal steps."""
    scene = read(TREE + CLOSING[kind])
    assert [(x.name, x.kind.name, x.bodies) for x in scene.model.loops] == [
        ("close", kind, ("b", "c"))]
    ours = load_scene(scene, functions=["forward_dynamics", "closure"]).double
    J = I1 + M1 / 4 + M2 + I3 + M3 / 4
    for q in (0.4, -1.1, 2.5):
        at, v = np.array([q, -q, q]), 0.7 * np.array([1, -1, 1])
        a = (M1 / 2 + M2 + M3 / 2) * G * np.sin(q) / J
        assert np.abs(ours.forward_dynamics(at, v, np.zeros(3)) - a * np.array([1, -1, 1])
                      ).max() < 1e-9
        assert np.abs(ours.closure(at)[0]).max() < 1e-15


@pytest.mark.parametrize(("first", "names"), (
    ("", ["pin", "knee", "other"]),
    ("<dynamics><damping>2</damping></dynamics>", ["pin", "knee", "close"]),
    ("<dynamics><spring_stiffness>2</spring_stiffness></dynamics>", ["pin", "knee", "close"]),
    ("<limit><lower>-1</lower></limit>", ["pin", "knee", "close"]),
    ("<dynamics><damping>0.0</damping></dynamics>", ["pin", "knee", "other"])))
def test_joints_with_numbers_stay_in_the_tree(read, first, names):
    closing = CLOSING["hinge"].replace("</axis>", f"{first}</axis>")
    scene = read(TREE + closing)
    assert [x.name for x in scene.model.joints if x.kind.moves] == names
    assert len(scene.model.loops) == 1


def test_joints_that_close_nothing_stay_in_the_tree(read):
    """A prismatic joint is in the tree, and the first revolute one closes."""
    slide = joint("close", "prismatic", "b", "c", "0 1 0")
    scene = read(TREE + slide)
    assert [x.name for x in scene.model.joints if x.kind.moves] == ["pin", "knee", "close"]
    assert [(x.name, x.bodies) for x in scene.model.loops] == [("other", ("world", "c"))]


def test_numbers_of_a_joint_that_closes_are_told(read):
    damped = "<dynamics><damping>2</damping></dynamics></axis>"
    scene = read((TREE + CLOSING["hinge"]).replace("</axis>", damped))
    assert "joint close: closes a loop; its <dynamics> is not used" in scene.unused
    assert "damping" not in [x for x in scene.unused if "close" in x][0]


def test_a_fixed_joint_welds_frames(read, tmp_path):
    """A frame stands on the first link where the links' frames are turned against each other."""
    weld = joint("close", "fixed", "b", "c", axis="")
    scene = read(TREE + weld)
    assert [(x.kind.name, x.bodies) for x in scene.model.loops] == [("frame", ("b", "c"))]
    path = tmp_path / "turned.sdf"
    path.write_text(text(TREE + weld).replace("<pose>2 0 0 0 0 0<", "<pose>2 0 0 0.3 0 0.7<"))
    turned = read_scene(path)
    assert turned.model.loops[0].bodies == ("close/first", "c")
    ours = load_scene(turned, functions=["closure"]).double
    assert np.abs(ours.closure(np.zeros(3))[0]).max() < 1e-15


def test_loops_are_left_out_on_demand(read):
    scene = read(TREE + CLOSING["hinge"], leave_out=("loops",))
    assert not scene.model.loops and "joint close: left out (loops)" in scene.unused


def test_joints_of_bodies_that_cannot_move_against_each_other_are_told(read):
    twice = joint("weld", "fixed", "a", "b") + joint("again", "fixed", "a", "b")
    scene = read(joint("pin", "revolute", "world", "a") + twice
                 + joint("other", "revolute", "world", "c"))
    assert not scene.model.loops
    assert ("joint again: holds bodies that cannot move against each other, and is not used"
            in scene.unused)


def test_joints_that_no_closure_is_like_are_refused(read):
    slides = [joint(name, "prismatic", "b", "c", "0 1 0") for name in ("one", "two")]
    with pytest.raises(SceneError) as caught:
        read("".join((TREE, *slides)))
    assert ("joint 'two': 'c' is the child of 'one', too, and a prismatic joint closes no loop; "
            'wanted one of revolute, continuous, ball, fixed, or leave_out = ["loops"]'
            ) in str(caught.value)


def test_a_circle_of_links_floats_as_a_loop(read):
    """Each of two links is the child of the other."""
    scene = read(joint("j", "revolute", "a", "b") + joint("k", "revolute", "b", "a", "1 1 0")
                 + joint("other", "revolute", "b", "c"))
    assert [(x.name, x.bodies) for x in scene.model.loops] == [("k", ("b", "a"))]
    assert next(x for x in scene.model.joints if x.child == "a").kind.floats
