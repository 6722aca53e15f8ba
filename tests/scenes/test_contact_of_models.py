"""Contacts of a model's file: bodies touch with the collision shapes that the file gives them."""

import math
from fractions import Fraction
from itertools import combinations
from pathlib import Path

import mujoco
import numpy as np
import pytest

import coscrew
from coscrew_codegen import run
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Applied, Scene

INERTIAL = ('<inertial><mass value="1"/><inertia ixx="0.0025" iyy="0.0025" izz="0.005" ixy="0" '
            'ixz="0" iyz="0"/></inertial>')
SPHERE = '<sphere radius="0.1"/>'
MESH = '<mesh filename="none.stl"/>'
ALL = "[effects.contact]\nmu = 0.5\n"
G, SLOPE = 9.81, math.radians(20)


def scene(folder: Path, effects: str, **shapes: list[str]) -> Path:
    """A scene of bodies "base" and others that turn on it, with these collision shapes."""
    def collision(shape: str) -> str:
        geometry, _, origin = shape.partition("|")
        return f"<collision>{origin}<geometry>{geometry}</geometry></collision>"

    links = [f'<link name="{name}">{INERTIAL}{"".join(map(collision, own))}</link>'
             for name, own in shapes.items()]
    joints = [f'<joint name="to_{name}" type="continuous"><parent link="base"/><child '
              f'link="{name}"/><axis xyz="0 1 0"/></joint>' for name in shapes if name != "base"]
    (folder / "thing.urdf").write_text(f'<robot name="thing">{"".join(links + joints)}</robot>')
    path = folder / "thing.toml"
    path.write_text(f'model = "thing.urdf"\nbase = "free"\n[effects.gravity]\n{effects}')
    return path


def contacts(of: Scene) -> list[Applied]:
    return [x for x in of.effects if x.effect.name == "contact"]


@pytest.mark.parametrize("shape, table", [
    (SPHERE + '|<origin xyz="0.1 2 3"/>', 'shape = "sphere"\nradius = 0.1\npoint = [0.1, 2, 3]'),
    ('<capsule radius="0.1" length="2"/>|<origin xyz="0 0 1"/>',
     'shape = "capsule"\nradius = 0.1\nlength = 2\npoint = [0, 0, 1]'),
    ('<box size="0.1 2 3"/>|<origin xyz="1 0 0"/>',
     'shape = "box"\nsize = [0.1, 2, 3]\npoint = [1, 0, 0]')])
def test_a_shape_of_the_file_is_that_of_a_table(tmp_path: Path, shape: str, table: str) -> None:
    one = contacts(read_scene(scene(tmp_path, ALL, base=[shape])))
    other = contacts(read_scene(scene(tmp_path, f"[effects.contact.base]\nmu = 0.5\n{table}\n",
                                      base=[])))
    assert [(x.name, x.values) for x in one] == [(x.name, x.values) for x in other]


def test_places_of_shapes_turn_with_them(tmp_path: Path) -> None:
    """A box's corners are R (±x, ±y, ±z)/2 + t; the rims of a cylinder along y stand at ±y."""
    turned = '|<origin xyz="1 2 3" rpy="0.1 0.2 0.3"/>'
    of = contacts(read_scene(scene(tmp_path, ALL, base=[
        f'<box size="0.2 0.4 0.6"/>{turned}',
        '<cylinder radius="0.1" length="0.5"/>|<origin rpy="1.5707963267948966 0 0"/>'])))
    (cr, cp, cy), (sr, sp, sy) = ([f(x) for x in (0.1, 0.2, 0.3)] for f in (math.cos, math.sin))
    R = (np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
         @ [[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]] @ [[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    wanted = [R @ (x, y, z) + (1, 2, 3) for x in (-.1, .1) for y in (-.2, .2) for z in (-.3, .3)]
    corners, rims = of[:8], of[8:]
    assert np.abs(np.array([[*map(float, x.vector("point"))] for x in corners])
                  - wanted).max() < 1e-15
    assert [x.values["point"] for x in rims] == [(0, Fraction(y, 4), 0) for y in (1, -1)]
    assert {x.values["axis"] for x in rims} == {(0, -1, 0)}
    assert {x.values["shape"] for x in corners} == {"point"}


def test_a_cylinder_of_the_file_rolls_downhill_at_two_thirds(tmp_path: Path) -> None:
    """I = m r²/2 about its axis, y: g sin α/(1 + 1/2)."""
    path = scene(tmp_path, ALL, base=['<cylinder radius="0.1" length="0.3"/>'])
    g = f"g = [{G * math.sin(SLOPE)!r}, 0, {-G * math.cos(SLOPE)!r}]\n"
    lying = [0, 0, 0.099, -math.sqrt(0.5), 0, 0, math.sqrt(0.5)]
    path.write_text(path.read_text().replace("[effects.gravity]\n", f"[effects.gravity]\n{g}")
                    + f"[start.q]\nbase = {lying}\n")
    result = run(path, until=1)
    q, v = (np.asarray(x[-1], float) for x in (result.q, result.v))
    along = coscrew.rotate_qv(q[3:7], v[:3])[0]
    assert abs(along / (2 / 3 * G * math.sin(SLOPE)) - 1) < 1e-11


def test_bodies_with_tables_of_their_own_have_those(tmp_path: Path) -> None:
    of = contacts(read_scene(scene(
        tmp_path, ALL + '[effects.contact.foot]\nmu = 1\nshape = "sphere"\nradius = 0.2\n',
        base=[SPHERE], foot=[SPHERE], frame=[], hand=[SPHERE, SPHERE])))
    assert [(x.name, float(x.values["radius"]), x.values["mu"]) for x in of] == [
        ("contact.foot", 0.2, 1), ("contact.base", 0.1, Fraction(1, 2)),
        ("contact.hand.0", 0.1, Fraction(1, 2)), ("contact.hand.1", 0.1, Fraction(1, 2))]


def test_named_bodies_take_their_shapes(tmp_path: Path) -> None:
    """In a table with a label too, also by patterns; one without shapes touches with its origin."""
    text = '[effects.contact.feet]\nbodies = ["*_foot", "tip"]\nmu = 1\n'
    of = contacts(read_scene(scene(tmp_path, text, base=[SPHERE], l_foot=[SPHERE],
                                   r_foot=[SPHERE], tip=[])))
    assert [(x.name, x.values["shape"]) for x in of] == [
        ("contact.feet.l_foot", "sphere"), ("contact.feet.r_foot", "sphere"),
        ("contact.feet.tip", "point")]


def test_a_weight_rests_on_eight_contacts_at_most(tmp_path: Path) -> None:
    box = '<box size="0.1 0.1 0.1"/>'
    of = contacts(read_scene(scene(tmp_path, ALL, base=[box], one=[box], two=[SPHERE])))
    assert len(of) == 17 and {x.values["load"] for x in of} == {3 * Fraction("9.81") / 8}


@pytest.mark.parametrize("effects, shapes, words", [
    (ALL, [MESH], r"effects.contact: no body that moves has collision shapes \(sphere, capsule, "
                  r"box, cylinder\).*; wanted tables \[effects.contact.LABEL\]"),
    ("[effects.contact.base]\nmu = 1\n", [MESH], "the mesh of body 'base' in the model's file "
     "cannot touch; wanted a shape, as shape = \"sphere\""),
    (ALL + "bodies = 3\n", [SPHERE], 'effects.contact.bodies: .*; wanted "all" or a list of names'),
    (ALL + "radius = 1\n", [SPHERE], "radius: is for shape = 'sphere'"),
    ("[effects.contact]\nmu = 1\nbodys = []\n", [SPHERE], "did you mean 'bodies'"),
    ("[effects.contact]\n", [SPHERE], "is empty"),
    ("[effects.contact]\nk = 3\n", [SPHERE], "mu: missing"),
    (ALL + 'bodies = ["base"]\n[effects.contact.base]\nmu = 1\n', [SPHERE],
     "two contacts are called contact.base; wanted other labels"),
    (ALL + 'bodies = ["b??e_"]\n', [SPHERE], "matches nothing; wanted base")])
def test_what_cannot_touch_is_refused(tmp_path: Path, effects: str, shapes: list[str], words: str
                                      ) -> None:
    with pytest.raises(SceneError, match=words):
        read_scene(scene(tmp_path, effects, base=shapes))


def test_shapes_that_cannot_touch_beside_others_are_noted(tmp_path: Path) -> None:
    lines = read_scene(scene(tmp_path, ALL, base=[SPHERE, MESH], hand=[MESH])).unused
    assert any(x == "the mesh of base cannot touch, other shapes there do; write "
               "[effects.contact.base] with a shape for more" for x in lines)


def test_the_notice_of_falling_proposes_the_shapes_of_the_file(tmp_path: Path) -> None:
    """The table that it proposes holds the body."""
    path = scene(tmp_path, "", base=[SPHERE])
    (line,) = (x for x in read_scene(path).unused if "nothing holds" in x)
    assert "as [effects.contact] with mu or" in line
    path.write_text(path.read_text() + ALL + "[start.q]\nbase = [0, 0, 0.2, 0, 0, 0, 1]\n")
    assert not any("nothing holds" in x for x in read_scene(path).unused)
    assert 0.098 < run(path, until=2).q[-1, 2] < 0.1


# two bodies

CAPSULE = '<capsule radius="0.1" length="0.4"/>|<origin xyz="0 0 1" rpy="1.5707963267948966 0 0"/>'
PAIR = '[effects.contact_pair.grip]\nbodies = ["base", "hand"]\nmu = 0.5\nload = 1\n'


def pairs(of: Scene) -> list[Applied]:
    return [x for x in of.effects if x.effect.name == "contact_pair"]


def test_two_bodies_touch_with_spheres_and_capsules_of_the_file(tmp_path: Path) -> None:
    """Each shape of one with each of the other, as tables with their numbers say; a capsule's ends
    are turned with it.  A given side has its own numbers."""
    written = ("first = [0, 0.2, 1]\nfirst_end = [0, -0.2, 1]\nfirst_radius = 0.1\n",
               "first = [1, 2, 3]\nfirst_radius = 0.1\n")
    shapes = {"base": [CAPSULE, f'{SPHERE}|<origin xyz="1 2 3"/>'], "hand": [SPHERE]}
    of_file = pairs(read_scene(scene(tmp_path, PAIR, **shapes)))
    assert [x.name for x in of_file] == ["contact_pair.grip.0", "contact_pair.grip.1"]
    for x, first in zip(of_file, written, strict=True):
        (y,) = pairs(read_scene(scene(tmp_path, f"{PAIR}{first}second_radius = 0.1\n",
                                      base=[], hand=[])))
        assert x.values == y.values
    (y,) = pairs(read_scene(scene(tmp_path, f"{PAIR}first_radius = 0.3\n", **shapes)))
    assert (y.name, y.values["first_radius"], y.values["second_radius"]) == (
        "contact_pair.grip", Fraction(3, 10), Fraction(1, 10))


def test_balls_of_files_collide(tmp_path: Path) -> None:
    """A file's ball and the scene's bounce off each other, at the distance of their radii."""
    path = scene(tmp_path, "", base=[SPHERE])
    path.write_text('model = "thing.urdf"\nbase = "free"\n'
                    '[bodies.ball]\nmass = 1\ninertia = [0.0025, 0.0025, 0.005]\n'
                    '[joints.ball]\ntype = "free"\nchild = "ball"\n'
                    '[effects.contact_pair.both]\nbodies = ["base", "ball"]\nsecond_radius = 0.1\n'
                    'mu = 0.3\nload = 1\nk = 1e6\nrestitution = 0.8\nspeed = 2\n'
                    '[start.q]\nball = [0.25, 0, 0, 0, 0, 0, 1]\n[start.v]\n'
                    'base = [1, 0, 0, 0, 0, 0]\nball = [-1, 0, 0, 0, 0, 0]\n')
    result = run(path, until=0.2, precision="double")
    q, v = result.q, result.v[-1]
    assert v[6] - v[0] == pytest.approx(1.6, rel=5e-3)
    assert 0.19 < (q[:, 7] - q[:, 0]).min() < 0.2


@pytest.mark.parametrize("shapes, words", [
    ([MESH], "bodies: the mesh of 'hand' in the model's file touches no other body; wanted "
             "second_radius, and second for its centre, of a sphere in its place"),
    (['<box size="1 1 1"/>', MESH], r"2 shapes \(box, mesh\) of 'hand' in the model's file touch "
                                    "no other body"),
    ([], "grip: second_radius: missing; wanted the radius of the second body's sphere or capsule, "
         "or such shapes in the model's file")])
def test_pairs_without_balls_are_refused(tmp_path: Path, shapes: list[str], words: str) -> None:
    with pytest.raises(SceneError, match=words):
        read_scene(scene(tmp_path, PAIR, base=[SPHERE], hand=shapes))


def test_shapes_that_touch_no_body_beside_others_are_noted(tmp_path: Path) -> None:
    lines = read_scene(scene(tmp_path, PAIR, base=[SPHERE], hand=[SPHERE, MESH])).unused
    assert any(x == "the mesh of hand touches no other body, other shapes there do; write a table "
               "[effects.contact_pair.LABEL] with second_radius for more" for x in lines)


# the humanoid of docs/models.md

def test_a_humanoid_of_a_file_stands_and_moves_its_arm(tmp_path: Path) -> None:
    """With the scene of the document: after 5 s it is as high as it stood, and upright."""
    text = (Path(__file__).parents[2] / "docs/models.md").read_text("utf-8")
    _, _, stands = text.partition("### A humanoid stands")
    (tmp_path / "stand.toml").write_text(stands.split("```")[1].removeprefix("toml"))
    legs = "".join(f'''<body pos="0 {y} -0.4"><joint name="{side}_hip" axis="0 1 0"/>
<geom type="capsule" size="0.04" fromto="0 0 0 0 0 -0.3" contype="0" conaffinity="0"/>
<body pos="0 0 -0.35"><joint name="{side}_ankle" axis="0 1 0"/>
<geom type="box" size="0.12 0.05 0.02" pos="0.02 0 -0.03"/></body></body>''' for side, y in (
        ("left", 0.1), ("right", -0.1)))
    (tmp_path / "humanoid.xml").write_text(f"""<mujoco><worldbody>
<geom type="plane" size="1 1 1"/><body name="pelvis" pos="0 0 0.8"><freejoint/>
<geom type="box" size="0.06 0.12 0.2" pos="0 0 -0.2"/><body pos="0 -0.2 0">
<joint name="right_elbow" axis="0 1 0"/><geom type="capsule" size="0.03" fromto="0 0 0 0 0 -0.2"/>
</body>{legs}</body></worldbody></mujoco>""")
    result = run(tmp_path / "stand.toml")
    q = result.q[-1].astype(float)
    assert abs(q[2] - 0.8) < 2e-3 and q[6] > 0.999
    names = [x.name for x in result.system.scene.model.joints if x.kind.moves]
    assert names == ["pelvis", "right_elbow", "left_hip", "left_ankle", "right_hip", "right_ankle"]
    elbow = result.q[:, 7].astype(float)
    assert 0.3 < elbow.max() < 0.6 and -0.6 < elbow.min() < -0.3


# groups

BITS = ((1, 1), (1, 0), (0, 1), (2, 5), (4, 2), (6, 1), (-2**31, 0), (0, 2**31 - 1), (0, 0))


def crowd(folder: Path, floor: tuple[int, int], more: str = "") -> Path:
    """Balls in each other and in the floor, whose contype and conaffinity are BITS and `floor`."""
    def bits(of: tuple[int, int]) -> str:
        return f'contype="{of[0]}" conaffinity="{of[1]}"'

    balls = "".join(f'<body name="b{n}"><freejoint/><geom name="g{n}" size="0.1" mass="1" '
                    f'{bits(of)}/></body>' for n, of in enumerate(BITS))
    path = folder / "crowd.xml"
    path.write_text(f'<mujoco><worldbody><geom name="floor" type="plane" size="1 1 1" '
                    f'{bits(floor)}/>{balls}</worldbody>{more}</mujoco>')
    return path


def touching(path: Path) -> set[frozenset[str]]:
    """The pairs of bodies that touch in MuJoCo."""
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    body = [model.body(int(model.geom_bodyid[g])).name for g in range(model.ngeom)]
    return {frozenset(body[int(g)] for g in x.geom) for x in data.contact}


@pytest.mark.parametrize("floor", BITS[:-1])
def test_shapes_touch_the_ground_as_their_groups_say(tmp_path: Path, floor: tuple[int, int]
                                                     ) -> None:
    path = crowd(tmp_path, floor, '<contact><pair geom1="g8" geom2="floor"/></contact>')
    (tmp_path / "crowd.toml").write_text(f'model = "crowd.xml"\n[effects.gravity]\n{ALL}')
    of = read_scene(tmp_path / "crowd.toml")
    assert {x.on for x in contacts(of)} == {
        x for pair in touching(path) if "world" in pair for x in pair} - {"world"}
    assert not any("cannot touch" in x for x in of.unused)


def test_two_bodies_touch_as_their_groups_say(tmp_path: Path) -> None:
    path = crowd(tmp_path, (1, 1), '<contact><pair geom1="g8" geom2="g7"/></contact>')
    wanted = touching(path)
    for pair in combinations([f"b{n}" for n in range(len(BITS))], 2):
        (tmp_path / "crowd.toml").write_text(
            'model = "crowd.xml"\n[effects.gravity]\n[effects.contact_pair.of]\nmu = 1\n'
            f"bodies = {[*pair]}\n")
        if {*pair} in wanted:
            assert len(pairs(read_scene(tmp_path / "crowd.toml"))) == 1
            continue
        with pytest.raises(SceneError, match=r"bodies: their shapes in the model's file do not "
                                             r"touch each other \(by contype and conaffinity\); "
                                             "wanted first_radius"):
            read_scene(tmp_path / "crowd.toml")


def test_a_named_body_whose_groups_touch_no_plane_is_refused(tmp_path: Path) -> None:
    crowd(tmp_path, (1, 1))
    (tmp_path / "crowd.toml").write_text(
        'model = "crowd.xml"\n[effects.gravity]\n[effects.contact.b4]\nmu = 1\n')
    with pytest.raises(SceneError, match="b4: the sphere of body 'b4' in the model's file touches "
                                         r"no plane there \(by contype and conaffinity\); wanted"):
        read_scene(tmp_path / "crowd.toml")
