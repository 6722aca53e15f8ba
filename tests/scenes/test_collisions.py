"""Collision shapes of model files: kept as the files give them, where Pinocchio and MuJoCo have
them, with the reason where one cannot be used.  They change no motion: a fault refuses nothing."""

import math
from fractions import Fraction
from pathlib import Path

import mujoco
import numpy as np
import pinocchio as pin
import pytest

from coscrew_codegen.scene.mechanism.collision import PLANE, Collision, Friction
from coscrew_codegen.scene.mechanism.visual import MESH, Triangles
from coscrew_codegen.scene.readers.model_formats import reader_of
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import hashed
from tests.support.scenes import robots
from tests.support.scenes.selecting import checked

INERTIAL = ('<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
            "</inertial>")
TENTH, HALF = Fraction(1, 10), math.sqrt(0.5)


def collisions(path: Path) -> tuple[Collision, ...]:
    reader = reader_of(path)
    assert reader is not None
    return reader.read(ModelSource(path)).collisions


def rotation(x: Collision) -> np.ndarray:
    return np.array([*map(float, x.R)]).reshape(3, 3)


# URDF

def urdf(folder: Path, *shapes: str) -> Path:
    path = folder / "arm.urdf"
    path.write_text(f'<robot name="arm"><link name="base">{INERTIAL}{"".join(shapes)}</link>'
                    "</robot>")
    return path


def collision(geometry: str, rest: str = "", name: str = "") -> str:
    return f"<collision{name}>{rest}<geometry>{geometry}</geometry></collision>"


@pytest.mark.parametrize("geometry, shape, size", (
    ('<box size="0.1 2 3"/>', "box", (TENTH, 2, 3)),
    ('<sphere radius="0.1"/>', "sphere", (TENTH,)),
    ('<cylinder radius="0.1" length="2"/>', "cylinder", (TENTH, 2)),
    ('<capsule radius="0.1" length="2"/>', "capsule", (TENTH, 2))))
def test_shapes_of_urdf_have_exact_sizes_and_places(tmp_path, geometry, shape, size):
    x, named = collisions(urdf(tmp_path, collision(geometry), collision(
        geometry, '<origin xyz="0.1 2 3" rpy="0 0 1.5707963"/>', ' name="tip"')))
    assert x == Collision("", "base", shape, size)
    assert (named.name, named.shape, named.size, named.t) == ("tip", shape, size, (TENTH, 2, 3))
    assert np.abs(rotation(named) - [[0, -1, 0], [1, 0, 0], [0, 0, 1]]).max() < 1e-7


@pytest.mark.parametrize("text, problem", (
    ("<collision/>", "line 1: <collision> has 0 shapes; wanted one"),
    (collision('<cone radius="1"/>'), "line 1: <cone> is no shape; wanted one of box"),
    (collision('<sphere radius="-1"/>'), "a sphere of the sizes -1; wanted positive ones"),
    (collision('<sphere radius="wide"/>'), "line 1: 'radius' of <sphere>: 'wide' is no number"),
    (collision('<box size="1 2"/>'), "line 1: 'size' of <box>: '1 2'; wanted 3 numbers"),
    (collision('<mesh filename="none.stl"/>'), "line 1: no file 'none.stl'"),
    (collision('<sphere radius="1"/>', '<origin rpy="0 0"/>'), "line 1: 'rpy' of <origin>")))
def test_a_fault_in_a_shape_is_its_problem_and_refuses_nothing(tmp_path, text, problem):
    good, bad = collisions(urdf(tmp_path, collision('<sphere radius="1"/>'), text))
    assert not good.problem and bad.problem.startswith(problem)


def test_shapes_change_no_hash(tmp_path):
    """Recordings of the same robot without shapes stay valid, and so do kernels, unless a notice
    says what to do with shapes."""
    scene = tmp_path / "arm.toml"
    scene.write_text('model = "arm.urdf"\nbase = "free"\nfalling = "accept"\n[effects.gravity]\n')
    urdf(tmp_path)
    bare = read_scene(scene)
    urdf(tmp_path, collision('<sphere radius="1"/>'))
    shaped = read_scene(scene)
    assert len(shaped.model.collisions) == 1 and not bare.model.collisions
    assert hashed(shaped) == hashed(bare) and shaped.motion_hash == bare.motion_hash


PEERS = ("ur_description/urdf/ur5_robot.urdf", "kinova_description/robots/kinova.urdf",
         "solo_description/robots/solo12.urdf", "go2_description/urdf/go2.urdf")


@pytest.mark.parametrize("file", PEERS, ids=lambda x: Path(x).stem)
def test_shapes_are_where_pinocchio_has_them(file):
    """Every shape of each link, in its order: kind, sizes and place in the link."""
    path = robots.path_of(file)
    of = pin.buildModelFromUrdf(str(path))
    geometry = pin.buildGeomFromUrdf(of, str(path), pin.COLLISION, package_dirs=[
        str(robots.FOLDER.parents[1])])
    shapes: dict[str, list[Collision]] = {}
    for x in collisions(path):
        assert not x.problem
        shapes.setdefault(x.body, []).append(x)
    assert len(geometry.geometryObjects) == sum(map(len, shapes.values())) > 0
    for peer in geometry.geometryObjects:
        x = shapes[of.frames[peer.parentFrame].name].pop(0)
        at = of.frames[peer.parentFrame].placement.actInv(peer.placement)
        assert np.abs(at.translation - [*map(float, x.t)]).max() < 1e-12
        assert np.abs(at.rotation - rotation(x)).max() < 1e-10
        match type(peer.geometry).__name__:
            case "Box":
                assert x.shape == "box" and 2 * peer.geometry.halfSide == pytest.approx(
                    [*map(float, x.size)])
            case "Sphere":
                assert x.shape == "sphere" and peer.geometry.radius == float(x.size[0])
            case "Cylinder" | "Capsule" as kind:
                assert x.shape == kind.lower() and (
                    peer.geometry.radius, 2 * peer.geometry.halfLength) == pytest.approx(
                    [*map(float, x.size)])
            case _:
                assert x.shape == MESH and Path(peer.meshPath).samefile(x.mesh)
                assert [*map(float, x.scale)] == [*peer.meshScale]


# MJCF

MJCF = """<mujoco><default><default class="soft"><geom type="capsule" size="0.05 0.2"
friction="0.7 0.01 0.001" contype="2" conaffinity="5"/></default></default>
<asset><mesh name="wedge" vertex="0 0 0  1 0 0  0 1 0  0 0 1"/></asset>
<worldbody><geom name="floor" type="plane" size="0 0 1" pos="0 0 -0.5"/>
<body name="upper" pos="0.1 0.2 0.3" euler="0 30 0">
<joint name="shoulder" axis="0 1 0" pos="0 0.1 0.1" ref="20"/>
<joint name="slide" type="slide" axis="1 0 1"/>
<geom name="ball" type="sphere" size="0.1" pos="0 0 0.4" mass="1"/>
<geom name="seen" type="box" size="0.1 0.1 0.1" contype="0" conaffinity="0" mass="1"/>
<body name="lower" pos="0 0 0.5"><joint name="elbow" axis="1 0 0"/>
<geom name="bar" class="soft" fromto="0 0 0  0.1 0.2 0.6" mass="1"/>
<geom name="block" type="box" size="0.1 0.2 0.3" pos="0.1 0 0" quat="1 0.1 0.2 0.3" mass="1"/>
<geom name="egg" type="ellipsoid" size="0.1 0.2 0.3" mass="1"/>
<geom type="cylinder" size="0.1 0.2" mass="1"/>
<geom name="wedge" type="mesh" mesh="wedge" mass="1"/></body></body></worldbody></mujoco>"""


@pytest.fixture(scope="module")
def mjcf(tmp_path_factory):
    path = tmp_path_factory.mktemp("mjcf") / "arm.xml"
    path.write_text(MJCF)
    return path, {x.name: x for x in collisions(path)}


def test_geoms_that_may_touch_are_kept_as_the_file_says(mjcf):
    """Sizes, friction and groups, also those of a class and of MuJoCo's defaults; the world's, too.
    """
    _, of = mjcf
    usual = Friction(Fraction(1), Fraction(1), Fraction(5, 1000), Fraction(1, 10000))
    assert {*of} == {"floor", "ball", "bar", "block", "egg", "wedge", ""}
    assert (of["floor"].body, of["floor"].shape, of["floor"].size, of["floor"].t[2]) == (
        "world", PLANE, (), Fraction(-1, 2))
    assert of["ball"] == Collision("ball", "upper", "sphere", (TENTH,), (0, 0, Fraction(2, 5)),
                                   friction=usual, groups=(1, 1))
    assert of["block"].size == (Fraction(1, 5), Fraction(2, 5), Fraction(3, 5))
    bar = of["bar"]
    assert (bar.shape, bar.groups) == ("capsule", (2, 5))
    assert bar.friction == Friction(Fraction(7, 10), Fraction(7, 10), Fraction(1, 100),
                                    Fraction(1, 1000))
    assert [*map(float, bar.size)] == pytest.approx([0.05, math.sqrt(0.41)])
    assert isinstance(of["wedge"].mesh, Triangles) and len(of["wedge"].mesh.faces) == 4


def test_heights_of_an_mjcf_are_kept_as_unusable_with_the_reason(tmp_path):
    path = tmp_path / "hill.xml"
    path.write_text("""<mujoco><asset><hfield name="hill" nrow="2" ncol="2" size="1 1 1 0.1"
elevation="0 1 1 0"/></asset><worldbody><geom name="hill" type="hfield" hfield="hill"/>
<body><joint/><geom size="0.1" mass="1"/></body></worldbody></mujoco>""")
    hill, _ = collisions(path)
    assert hill.problem == "a geom of the type hfield is no shape that is kept"


def test_shapes_move_as_in_mujoco(mjcf, tmp_path):
    """Poses of geoms at random states: behind anchors off the origin, `ref` and slides."""
    path, of = mjcf
    (path.parent / "arm.toml").write_text('model = "arm.xml"\n[effects.gravity]\n')
    kernels = checked(path.parent / "arm.toml", None, others=("body_poses",),
                      precisions=("double",))
    names = kernels.interface.bodies
    model = mujoco.MjModel.from_xml_path(str(path))
    data, rng = mujoco.MjData(model), np.random.default_rng(0)
    for _ in range(5):
        data.qpos[:] = rng.uniform(-1, 1, model.nq)
        mujoco.mj_kinematics(model, data)
        poses = np.asarray(kernels.double.body_poses(data.qpos)).reshape(-1, 3, 4)
        for name in ("ball", "bar", "block", "wedge"):
            x, geom = of[name], model.geom(name).id
            D = poses[names.index(x.body)]
            assert D[:, :3] @ [*map(float, x.t)] + D[:, 3] == pytest.approx(
                data.geom_xpos[geom], abs=1e-12)
            assert D[:, :3] @ rotation(x) == pytest.approx(
                data.geom_xmat[geom].reshape(3, 3), abs=1e-12)


# SDF

SDF = """<sdf version="1.9"><model name="arm"><link name="base"><inertial><mass>1</mass><inertia>
<ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>{}</link></model></sdf>"""
GRIP = "<surface><friction><ode><mu>0.6</mu><mu2>0.5</mu2></ode></friction></surface>"


def sdf(folder: Path, *shapes: str) -> Path:
    path = folder / "arm.sdf"
    path.write_text(SDF.format("".join(shapes)))
    return path


@pytest.mark.parametrize("geometry, shape, size", (
    ("<box><size>0.1 2 3</size></box>", "box", (TENTH, 2, 3)),
    ("<sphere><radius>0.1</radius></sphere>", "sphere", (TENTH,)),
    ("<capsule><radius>0.1</radius><length>2</length></capsule>", "capsule", (TENTH, 2)),
    ("<ellipsoid><radii>0.1 2 3</radii></ellipsoid>", "ellipsoid", (TENTH, 2, 3))))
def test_shapes_of_sdf_have_exact_sizes_places_and_friction(tmp_path, geometry, shape, size):
    bare, rough = collisions(sdf(tmp_path, collision(geometry, name=' name="a"'), collision(
        geometry, f"<pose degrees='true'>0.1 0 0 90 0 0</pose>{GRIP}", ' name="b"')))
    assert bare == Collision("a", "base", shape, size)
    assert rough.friction == Friction(Fraction(6, 10), Fraction(1, 2))
    assert (rough.name, rough.t) == ("b", (TENTH, 0, 0))
    assert rotation(rough).tolist() == [[1, 0, 0], [0, 0, -1], [0, 1, 0]]


@pytest.mark.parametrize("normal", ((0, 0, 1), (0, 0, -1), (0, 3, 4), (-0.5, 0.1, -0.2)))
def test_planes_of_sdf_have_their_normals_along_z(tmp_path, normal):
    (x,) = collisions(sdf(tmp_path, collision(
        f"<plane><normal>{' '.join(map(str, normal))}</normal></plane>")))
    assert (x.shape, x.size) == (PLANE, ())
    assert rotation(x)[:, 2] == pytest.approx(np.array(normal) / np.linalg.norm(normal))
    assert np.linalg.det(rotation(x)) == pytest.approx(1)


def test_what_cannot_be_used_in_sdf_is_named(tmp_path):
    hills, bad = collisions(sdf(tmp_path, collision("<heightmap/>"), collision(
        "<sphere><radius>1</radius></sphere>", GRIP.replace("0.6", "-1"))))
    assert "<heightmap> is no shape; wanted one of box, sphere" in hills.problem
    assert bad.problem == "line 2: negative friction; wanted 0 or more"


# models in scenes

def test_shapes_of_attached_models_have_the_new_names_and_places(mjcf):
    """The world's stand on the body to which the model is attached."""
    path, of = mjcf
    urdf(path.parent, collision('<sphere radius="1"/>'))
    (path.parent / "both.toml").write_text("""model = "arm.urdf"
[effects.gravity]
[attach.tool]
model = "arm.xml"
to = "base"
prefix = "tool_"
place = { xyz = [1, 0, 0], rpy = [0, 0, 1.57079632679] }
[bodies.ball]
mass = 1
com = [0, 0, 0]
inertia = [1, 1, 1]
[joints.ball]
type = "free"
child = "ball"
""")
    own, floor, *rest = read_scene(path.parent / "both.toml").model.collisions
    assert (own.body, floor.body, floor.t) == ("base", "base", (1, 0, Fraction(-1, 2)))
    assert rotation(floor).tolist() == [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    assert {x.body for x in rest} == {"tool_upper", "tool_lower"}
    assert [x.t for x in rest] == [x.t for x in of.values() if x.body != "world"]
