"""Contacts in a playback page: their shapes, the ground, points of closed loops, and the arrows of
their forces."""

import math
import zlib
from base64 import b64decode
from types import SimpleNamespace

import numpy as np
import pytest

from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.view.body_shapes import drawn
from coscrew_codegen.simulation.view.ground_shape import ground_of
from coscrew_codegen.simulation.view.page_block import NumberBlock
from coscrew_codegen.simulation.view.page_text import page
from tests.support.playback_data import PageData, run

FREE = """
[bodies.thing]
mass = 1
com = {com}
inertia = [0.004, 0.004, 0.004]
[joints.free]
type = "free"
child = "thing"
[effects.gravity]
[effects.contact.thing]
{shape}
mu = 0.5
{ground}
[start.q]
free = [0, 0, 3, 0, 0, 0, 1]
[outputs]
record = ["q", "contact.*.force"]
[run]
duration = 0.02
"""
SHAPES = {
    'shape = "sphere"\nradius = 0.1': ("sphere", (0.1,), (0, 0, 0), (0, 0, 1)),
    'shape = "sphere"\nradius = 0.1\npoint = [0, 0, 0.05]': (
        "sphere", (0.1,), (0, 0, 0.05), (0, 0, 1)),
    'shape = "box"\nsize = [0.2, 0.3, 0.4]\npoint = [0.01, 0.02, 0.03]': (
        "box", (0.2, 0.3, 0.4), (0.01, 0.02, 0.03), (0, 0, 1)),
    'shape = "capsule"\nradius = 0.06\nlength = 0.5\naxis = [3, 0, 4]': (
        "capsule", (0.06, 0.5), (0, 0, 0), (0.6, 0, 0.8)),
    'shape = "disc"\nradius = 0.12\naxis = [0, 2, 0]': (
        "cylinder", (0.12, 0.012), (0, 0, 0), (0, 1, 0))}


def read(folder, shape: str, ground: str = "", com: str = "[0, 0, 0]") -> SimpleNamespace:
    """The scene without functions, which drawings do not call."""
    path = folder / "thing.toml"
    path.write_text(FREE.format(shape=shape, ground=ground, com=com))
    return SimpleNamespace(scene=read_scene(path), p=())


def parts(folder, shape: str, **others: str):
    """The visible parts of the body."""
    return [x for x in drawn(read(folder, shape, **others)).parts if x.body == 0]


def axis_of(place) -> tuple[float, ...]:
    """The direction to which the place turns z."""
    x, y, z, w = place[3:]
    return 2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)


@pytest.mark.parametrize("shape", SHAPES)
def test_a_body_is_drawn_as_the_shape_with_which_it_touches(tmp_path, shape):
    kind, size, at, axis = SHAPES[shape]
    (part,) = parts(tmp_path, shape)
    assert part.shape == kind
    assert part.size == pytest.approx(size)
    assert part.place[:3] == pytest.approx(at, abs=1e-15)
    assert axis_of(part.place) == pytest.approx(axis, abs=1e-15)


def test_a_cylinder_of_a_file_is_drawn_whole(tmp_path):
    """It touches with its two rims."""
    (tmp_path / "drum.urdf").write_text("""<robot name="drum"><link name="drum"><inertial>
<mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
<collision><origin xyz="0 0 0.1" rpy="0 0.5 0"/><geometry><cylinder radius="0.3" length="0.5"/>
</geometry></collision></link></robot>""")
    path = tmp_path / "drum.toml"
    path.write_text("""model = "drum.urdf"
base = "free"
[effects.gravity]
[effects.contact]
mu = 0.5
""")
    (part,) = drawn(SimpleNamespace(scene=read_scene(path), p=())).parts
    assert (part.shape, part.size) == ("cylinder", (pytest.approx(0.3), pytest.approx(0.5)))
    assert part.place[:3] == pytest.approx((0, 0, 0.1))
    assert np.abs(axis_of(part.place)) == pytest.approx((math.sin(0.5), 0, math.cos(0.5)))


@pytest.mark.parametrize("shape, com", (
    ('shape = "sphere"\nradius = 0.1', "[0, 0, 0.2]"), ('shape = "point"', "[0, 0, 0]"),
    ('shape = "capsule"\nradius = 0.06\nlength = 0.5', "[0.1, 0, 0]"),
    ('shape = "box"\nsize = [0.2, 0.3, 0.4]', "[0, 0, 0.21]")))
def test_where_no_shape_holds_the_mass_its_box_stays(tmp_path, shape, com):
    """Beside the shape, and, as ever, a rod to a centre that is off the origin."""
    every = parts(tmp_path, shape, com=com)
    (box,) = (x for x in every if x.shape == "box" and x.size[0] == pytest.approx(
        math.sqrt(0.024)))
    assert box.place[:3] == pytest.approx([float(x) for x in com[1:-1].split(",")])
    assert len([x for x in every if x.shape != "cylinder"]) == 2


BALL = 'shape = "sphere"\nradius = 0.1'


def ground(folder, text: str = "", shape: str = BALL):
    """The ground in the page, of a body that goes from x = -1 to 3, and its heights."""
    block, poses = NumberBlock(), np.zeros((2, 1, 7), np.float32)
    poses[:, 0, 0] = -1, 3
    data = ground_of(read(folder, shape, text), poses, block)
    return data, np.frombuffer(zlib.decompress(b64decode(block.text)), np.uint8)


def test_a_scene_with_contacts_has_its_ground(tmp_path):
    """z = 0 unless it says otherwise; normals of norm 1."""
    assert ground(tmp_path)[0] == {"normal": [0, 0, 1], "offset": 0}
    assert ground(tmp_path, "[effects.ground]\nnormal = [3, 0, 4]\noffset = 0.5")[0] == {
        "normal": [0.6, 0, 0.8], "offset": 0.5}


def test_heights_are_those_of_the_formula(tmp_path):
    data, block = ground(
        tmp_path, '[effects.ground]\nheight = "0.3*sin(2*x)*max(y, 0.1) + 1"')
    n, half = data["points"], data["half"]
    assert (data["middle"], half) == ([1, 0], pytest.approx(5))
    H = np.ascontiguousarray(block.reshape(4, n * n).T).view("<f4").reshape(n, n)
    for i in (0, 7, n - 1):
        for k in (0, 50, n - 1):
            x, y = (c + half * (2 * j / (n - 1) - 1)
                    for c, j in zip(data["middle"], (k, i), strict=True))
            assert H[i, k] == pytest.approx(0.3 * math.sin(2 * x) * max(y, 0.1) + 1, rel=1e-6)


def test_heights_of_a_grid_pass_through_its_points(tmp_path):
    """Between x = 0 and 1, and y = -1 and 0, the surface is Catmull and Rom's at the middle."""
    (tmp_path / "grid.csv").write_text("0,0,1,2\n-1,0.5,0.25,1\n0,-1,0,0.125\n")
    data, block = ground(tmp_path, '[effects.ground]\nheight = { file = "grid.csv" }')
    n, half = data["points"], data["half"]
    H = np.ascontiguousarray(block.reshape(4, n * n).T).view("<f4").reshape(n, n)
    x, y = (c + half * np.linspace(-1, 1, n) for c in data["middle"])
    for i in (0, 40, 47, n - 1):
        for k in (0, 18, 22, n - 1):
            assert H[i, k] == pytest.approx(bicubic(x[k], y[i]), abs=1e-6)


def bicubic(x: float, y: float) -> float:
    """Hermite's cubics with the slopes of chords, of those at the ends that of the last two."""
    x, y = min(max(x, 0.0), 2.0), min(max(y, -1.0), 0.0)

    def along_x(low: float, middle: float, high: float) -> float:
        slopes = middle - low, (high - low) / 2, high - middle
        return hermite(x, low, middle, *slopes[:2]) if x < 1 else hermite(
            x - 1, middle, high, *slopes[1:])

    first, last = along_x(0.5, 0.25, 1), along_x(-1, 0, 0.125)
    return hermite(y + 1, first, last, last - first, last - first)


def hermite(s: float, a: float, b: float, slope_a: float, slope_b: float) -> float:
    return ((1 + 2 * s) * (1 - s)**2 * a + s * (1 - s)**2 * slope_a
            + s * s * (3 - 2 * s) * b + s * s * (s - 1) * slope_b)


TOUCHING = """[bodies.ball]
mass = 1
inertia = [0.004, 0.004, 0.004]
[joints.free]
type = "free"
child = "ball"
[effects.gravity]
[effects.contact_pair.perch]
bodies = ["ball", "world"]
first_radius = 0.1
second = [0, -1, 0]
second_end = [0, 1, 0]
second_radius = 0.2
mu = 0.5
depth = 0.002
load = 7
[start.q]
free = [{x}, 0.25, {z}, 0, 0, 0, 1]
[outputs]
record = ["q", "contact_pair.perch.force"]
every = 0.001
[run]
duration = {duration}
step = 1e-3
"""


@pytest.fixture(scope="module")
def perch(tmp_path_factory):
    """A ball that lies as deep in a capsule of the world as the load 7 N makes it."""
    path, apart = tmp_path_factory.mktemp("perch") / "perch.toml", 0.1 + 0.2 - 0.002
    (result,) = run(path, TOUCHING.format(x=0.6 * apart, z=0.8 * apart, duration=0.01),
                    precision="double")
    return PageData(page([result]))


def test_contacts_of_two_bodies_are_drawn_as_the_law_says(perch):
    """At the start, halfway between both surfaces, along the line between their centres."""
    ((x, y, z, *force),) = ([perch.array(place)[0] for place in one]
                            for one in perch.json["contacts"])
    assert force == pytest.approx([0.6 * 7, 0, 0.8 * 7], rel=1e-6)
    assert (x, y, z) == pytest.approx((0.6 * 0.199, 0.25, 0.8 * 0.199), rel=1e-6)
    assert perch.json["arrows"] == []


def test_both_bodies_of_a_contact_are_drawn(perch):
    shapes = {x["body"]: (x["kind"], x["size"], x["place"]) for x in perch.json["parts"]}
    assert shapes[0] == ("sphere", [0.1], [0, 0, 0, 0, 0, 0, 1])
    kind, size, place = shapes[-1]
    assert (kind, size, place[:3]) == ("capsule", [0.2, 2], [0, 0, 0])
    assert axis_of(place) == pytest.approx((0, 1, 0), abs=1e-6)


def test_states_of_all_effects_are_one_group(tmp_path):
    """Each is labelled by its effect, and where its contact is."""
    (result,) = run(tmp_path / "thing.toml", FREE.format(shape=BALL, ground="", com="[0, 0, 0]"
                    ).replace('"q",', '"q", "x",'), precision="double")
    groups = {x["heading"].split(",")[0]: [y["label"] for y in x["signals"]]
              for x in PageData(page([result])).json["groups"]}
    assert groups["States x"] == [f"contact.thing.{i}" for i in range(3)]


def test_a_contact_that_never_touches_takes_no_room(tmp_path):
    """The numbers of one that does are zero except at the samples around."""
    (far,) = run(tmp_path / "far.toml", TOUCHING.format(x=0, z=5, duration=0.01),
                 precision="double")
    assert PageData(page([far])).json["contacts"] == []
    (falls,) = run(tmp_path / "falls.toml", TOUCHING.format(x=0, z=0.31, duration=0.1),
                   precision="double")
    data = PageData(page([falls]))
    (numbers,) = (np.array([data.array(x) for x in one]) for one in data.json["contacts"])
    touches = numbers[3:].any(0)
    first = int(np.argmax(touches))
    assert first > 3 and not numbers[:, :first - 1].any()
    assert numbers[:3, first - 1].any() and numbers[5, first] > 0


def test_the_ground_is_touched_at_the_lowest_point(tmp_path):
    """With the force of the recording."""
    path = tmp_path / "thing.toml"
    (result,) = run(path, FREE.format(shape=BALL, ground="", com="[0, 0, 0]").replace(
        "[0, 0, 3,", "[0.5, 0, 0.0995,"), precision="double")
    data = PageData(page([result]))
    ((x, y, z, *force),) = ([data.array(place)[0] for place in one]
                            for one in data.json["contacts"])
    assert force == pytest.approx([
        result.recorded[f"contact.thing.force.{i}"][0] for i in range(3)], rel=1e-6)
    assert (x, y) == (0.5, 0) and abs(z) <= 0.0005 and force[2] > 0
    assert data.json["arrows"] == []


PAIR = """[bodies]
left = { mass = 1, com = [0, 0, -1], inertia = [0.1, 0.1, 0.1] }
right = { mass = 1, com = [0, 0, -1], inertia = [0.1, 0.1, 0.1] }
beam = { mass = 1, com = [0.5, 0, 0], inertia = [0.1, 0.1, 0.1] }
[joints]
left = { type = "revolute", child = "left", axis = [0, 1, 0] }
right = { type = "revolute", child = "right", axis = [0, 1, 0], origin.xyz = [1, 0, 0] }
[joints.beam]
type = "revolute"
parent = "left"
child = "beam"
axis = [0, 1, 0]
origin = { xyz = [0, 0, -2] }
[loops.pin]
kind = "point"
bodies = ["beam", "right"]
first = [1, 0, 0]
second = [0, 0, -2]
[effects.gravity]
[outputs]
record = ["q", "closing.pin"]
[run]
duration = 0.02
"""


@pytest.fixture(scope="module")
def pair(tmp_path_factory):
    """A run of the pair, and the data of its page."""
    path = tmp_path_factory.mktemp("pair") / "pair.toml"
    (result,) = run(path, PAIR, precision="double")
    return result, PageData(page([result]))


def test_points_that_close_loops_are_drawn_with_their_force(pair):
    result, data = pair
    assert data.json["ground"] is None
    beam, right = (next(n for n, x in enumerate(data.json["bodies"]) if x["name"] == name)
                   for name in ("beam", "right"))
    assert data.json["ties"] == [{"kind": "closure", "ends": [
        {"body": beam, "point": [1, 0, 0]}, {"body": right, "point": [0, 0, -2]}]}]
    (arrow,) = data.json["arrows"]
    assert (arrow["body"], arrow["point"], arrow["turns"]) == (beam, [1, 0, 0], True)
    assert arrow["signals"] == [f"closing.pin.{i}" for i in range(3)]
    force = np.array([data.signal(x) for x in arrow["signals"]])
    assert np.abs(force - [result.recorded[x] for x in arrow["signals"]]).max() < 1e-5
    assert np.abs(force[2]).min() > 1  # it holds half of the beam
    rods = [x.size[1] for x in drawn(result.system).parts
            if x.shape == "cylinder" and x.body in (beam, right)]
    assert any(x == pytest.approx(2) for x in rods)  # to the pin at the end of `right`


def test_the_page_has_the_tree_of_bodies(pair):
    data = pair[1].json
    names = {-1: "world", **{n: x["name"] for n, x in enumerate(data["bodies"])}}
    assert {(x["name"], x["kind"], names[x["parent"]], names[x["child"]], tuple(x["axis"]))
            for x in data["joints"]} == {
        ("left", "revolute", "world", "left", (0, 1, 0)),
        ("right", "revolute", "world", "right", (0, 1, 0)),
        ("beam", "revolute", "left", "beam", (0, 1, 0))}
