"""Visuals of model files: shapes, places, colours and meshes, and the reasons why some cannot be
shown.  They change no motion: a fault in one refuses nothing."""

import math
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.mechanism.rotations import from_rpy
from coscrew_codegen.scene.mechanism.visual import Visual, from_rotation
from coscrew_codegen.scene.readers.model_formats import reader_of
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import hashed

LINK = ('<link name="{name}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" '
        'ixz="0" iyz="0"/></inertial>{visuals}</link>')
URDF = ('<robot name="arm"><material name="steel"><color rgba="0.5 0.6 0.7 1"/></material>'
        '{links}</robot>')
HALF = math.sqrt(0.5)


def urdf(folder: Path, *visuals: str) -> Path:
    """A robot of one link with these visuals."""
    path = folder / "arm.urdf"
    path.write_text(URDF.format(links=LINK.format(name="base", visuals="".join(visuals))))
    return path


def read(path: Path, **settings: object) -> Model:
    reader = reader_of(path)
    assert reader is not None
    return reader.read(replace(ModelSource(path), **settings))


def visuals(path: Path, body: int = 0, **settings: object) -> tuple[Visual, ...]:
    return read(path, **settings).bodies[body].visuals


def visual(geometry: str, rest: str = "") -> str:
    return f"<visual>{rest}<geometry>{geometry}</geometry></visual>"


@pytest.mark.parametrize("geometry, shape, size", (
    ('<box size="1 2 3"/>', "box", (1, 2, 3)), ('<sphere radius="0.5"/>', "sphere", (0.5,)),
    ('<cylinder radius="0.1" length="2"/>', "cylinder", (0.1, 2)),
    ('<capsule radius="0.1" length="2"/>', "capsule", (0.1, 2))))
def test_shapes_of_urdf_have_their_sizes(tmp_path, geometry, shape, size):
    (x,) = visuals(urdf(tmp_path, visual(geometry)))
    assert (x.shape, x.size, x.place, x.colour, x.problem) == (
        shape, size, (0, 0, 0, 0, 0, 0, 1), (), "")


def test_places_and_colours_of_urdf_are_those_of_the_file(tmp_path):
    box = '<box size="1 1 1"/>'
    turned, named, own, other = visuals(urdf(
        tmp_path, visual(box, f'<origin xyz="1 2 3" rpy="0 0 {math.pi / 2}"/>'),
        visual(box, '<material name="steel"/>'),
        visual(box, '<material name="paint"><color rgba="2 0 0 0.5"/></material>'),
        visual(box, '<material name="paint"/>')))
    assert turned.place == pytest.approx((1, 2, 3, 0, 0, HALF, HALF))
    assert named.colour == (0.5, 0.6, 0.7, 1)
    assert own.colour == other.colour == (1, 0, 0, 0.5)


@pytest.mark.parametrize("angles", ((0.3, -1.2, 2.5), (-3, 1.5, 0.1), (0, 0, 0)))
def test_quaternions_turn_as_roll_pitch_yaw_do(angles):
    """Rz(y) Ry(p) Rx(r), by products of elementary matrices."""
    def about(axis: int, angle: float) -> np.ndarray:
        i, j = (axis + 1) % 3, (axis + 2) % 3
        R = np.eye(3)
        R[i, i] = R[j, j] = math.cos(angle)
        R[i, j], R[j, i] = -math.sin(angle), math.sin(angle)
        return R

    x, y, z, w = from_rotation([float(x) for x in from_rpy(*map(Fraction, angles))])
    R = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                  [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                  [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
    wanted = about(2, angles[2]) @ about(1, angles[1]) @ about(0, angles[0])
    assert np.abs(R - wanted).max() < 1e-15


@pytest.mark.parametrize("uri", (
    "meshes/a.stl", "package://arm_description/meshes/a.stl", "package://arm/meshes/a.stl",
    "model://arm_description/meshes/a.stl", "file://{folder}/meshes/a.stl",
    "{folder}/meshes/a.stl"))
def test_meshes_are_found_beside_the_file_and_by_packages(tmp_path, uri):
    """By the name of the folder, or that in its package.xml; a blank may be written %20."""
    folder = tmp_path / "arm_description"
    (folder / "meshes").mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>arm</name></package>")
    (folder / "meshes/a.stl").write_text("")
    mesh = f'<mesh filename="{uri.format(folder=folder)}" scale="1 -1 0.001"/>'
    (x,) = visuals(urdf(folder, visual(mesh)))
    assert (x.problem, x.mesh and x.mesh.resolve()) == ("", (folder / "meshes/a.stl").resolve())
    assert x.scale == (1, -1, 0.001)


def test_a_given_package_counts(tmp_path):
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere/b c.stl").write_text("")
    path = urdf(tmp_path, visual('<mesh filename="package://far/b%20c.stl"/>'))
    assert visuals(path)[0].problem == "line 1: no file 'package://far/b%20c.stl'"
    (x,) = visuals(path, packages={"far": tmp_path / "elsewhere"})
    assert x.mesh == tmp_path / "elsewhere/b c.stl"


@pytest.mark.parametrize("wrong, problem", (
    ("<visual/>", "<visual> has 0 shapes; wanted one"),
    (visual('<box size="1 2"/>'), "'size' of <box>: '1 2'; wanted 3 numbers"),
    (visual('<box size="1 2 x"/>'), "'size' of <box>: 'x' is no number; wanted a decimal number "
                                    "such as 1.5e-3"),
    (visual('<sphere radius="nan"/>'), "'radius' of <sphere>: nan is not finite; wanted a number"),
    (visual('<cone radius="1"/>'), "<cone> is no shape; wanted one of box, sphere, cylinder, "
                                   "capsule, mesh"),
    (visual('<mesh filename="none.stl"/>'), "no file 'none.stl'"),
    (visual("<mesh/>"), "no file ''"),
    (visual('<box size="1 1 1"/>', '<origin xyz="1 2"/>'),
     "'xyz' of <origin>: '1 2'; wanted 3 numbers")))
def test_a_visual_with_a_fault_is_kept_with_its_problem(tmp_path, wrong, problem):
    """The model is read all the same."""
    good, bad = visuals(urdf(tmp_path, visual('<sphere radius="1"/>'), wrong))
    assert (good.problem, bad.problem) == ("", f"line 1: {problem}")


def test_sizes_are_positive(tmp_path):
    (x,) = visuals(urdf(tmp_path, visual('<cylinder radius="0" length="1"/>')))
    assert x.problem == "a cylinder of the sizes 0, 1; wanted positive ones"


def test_visuals_change_no_hash(tmp_path):
    """Nothing is derived or compiled anew for them."""
    plain = hashed(read(urdf(tmp_path)))
    assert hashed(read(urdf(tmp_path, visual('<sphere radius="1"/>')))) == plain


def test_an_attached_model_keeps_its_visuals(tmp_path):
    urdf(tmp_path, visual('<sphere radius="0.5"/>'))
    (tmp_path / "two.toml").write_text(
        'model = "arm.urdf"\nbase = "free"\n'
        '[attach.hand]\nmodel = "arm.urdf"\nto = "base"\nprefix = "hand_"\n')
    bodies = read_scene(tmp_path / "two.toml").model.bodies
    assert [(x.name, [y.shape for y in x.visuals]) for x in bodies] == [
        ("base", ["sphere"]), ("hand_base", ["sphere"])]


SDF = """<sdf version="1.9"><model name="arm"><link name="base"><inertial><mass>1</mass><inertia>
<ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>{visuals}</link></model></sdf>"""


def sdf(folder: Path, *shapes: str) -> Path:
    path = folder / "arm.sdf"
    path.write_text(SDF.format(visuals="".join(
        f'<visual name="v{i}"><geometry>{x}</geometry>{_REST.get(i, "")}</visual>'
        for i, x in enumerate(shapes))))
    return path


_REST = {0: f"<pose>1 2 3 0 0 {math.pi / 2}</pose><material><diffuse>0.1 0.2 0.3</diffuse>"
            "<ambient>1 1 1 1</ambient></material><cast_shadows>false</cast_shadows>"}


def test_shapes_of_sdf_have_sizes_places_and_colours(tmp_path):
    (tmp_path / "a.dae").write_text("")
    box, ellipsoid, mesh, plane, lost, wrong = visuals(sdf(
        tmp_path, "<box><size>1 2 3</size></box>", "<ellipsoid><radii>1 2 3</radii></ellipsoid>",
        "<mesh><uri>a.dae</uri><scale>2 2 2</scale></mesh>",
        "<plane><normal>0 0 1</normal></plane>", "<mesh><uri>model://b/c.dae</uri></mesh>",
        "<sphere><radius>x</radius></sphere>"))
    assert (box.shape, box.size, box.colour) == ("box", (1, 2, 3), (0.1, 0.2, 0.3))
    assert box.place == pytest.approx((1, 2, 3, 0, 0, HALF, HALF))
    assert (ellipsoid.shape, ellipsoid.size) == ("ellipsoid", (1, 2, 3))
    assert (mesh.mesh, mesh.scale) == (tmp_path / "a.dae", (2, 2, 2))
    assert plane.problem == "line 2: <plane> is not drawn"
    assert lost.problem == "line 2: no file 'model://b/c.dae'"
    assert "'x'" in wrong.problem


MJCF = """<mujoco><asset><mesh name="tent" vertex="0 0 0  1 0 0  0 1 0  0 0 1"/>
<material name="steel" rgba="0.5 0.6 0.7 1"/></asset><worldbody><body name="arm">
<joint type="hinge"/><geom type="sphere" size="0.1" rgba="1 0 0 0.5"/>
<geom type="{quiet}" {size} material="steel" contype="0" conaffinity="0" pos="1 2 3"
quat="0 0 0 2"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize("quiet, size, shape, sizes", (
    ("capsule", 'size="0.1 0.5"', "capsule", (0.1, 1)),
    ("box", 'size="1 2 3"', "box", (2, 4, 6)),
    ("ellipsoid", 'size="1 2 3"', "ellipsoid", (1, 2, 3)),
    ("cylinder", 'size="1 2"', "cylinder", (1, 4))))
def test_geoms_that_touch_nothing_are_what_is_seen(tmp_path, quiet, size, shape, sizes):
    pytest.importorskip("mujoco")
    path = tmp_path / "arm.xml"
    path.write_text(MJCF.format(quiet=quiet, size=size))
    (x,) = visuals(path)
    assert (x.shape, x.size, x.colour) == (shape, sizes, pytest.approx((0.5, 0.6, 0.7, 1)))
    assert x.place == pytest.approx((1, 2, 3, 0, 0, 1, 0))


def test_meshes_of_mujoco_are_at_their_places(tmp_path):
    """MuJoCo moves vertices to the centre and the geom to where that was."""
    pytest.importorskip("mujoco")
    path = tmp_path / "arm.xml"
    path.write_text(MJCF.format(quiet="mesh", size='mesh="tent"').replace('quat="0 0 0 2"', ""))
    (x,) = visuals(path)
    q, v = np.array(x.place[3:]), x.mesh.vertices
    t = 2 * np.cross(q[:3], v)
    placed = v + q[3] * t + np.cross(q[:3], t) + x.place[:3]
    wanted = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) + [1, 2, 3]
    for corner in wanted:
        assert np.abs(placed - corner).max(1).min() < 1e-6
    assert len(x.mesh.faces) == 4


def test_all_geoms_are_seen_where_all_touch(tmp_path):
    pytest.importorskip("mujoco")
    path = tmp_path / "arm.xml"
    path.write_text(MJCF.format(quiet="box", size='size="1 1 1"').replace(
        'contype="0" conaffinity="0"', ""))
    assert [x.shape for x in visuals(path)] == ["sphere", "box"]
    assert visuals(path)[0].colour == (1, 0, 0, 0.5)
