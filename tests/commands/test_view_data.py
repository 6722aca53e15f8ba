"""The data of a playback page: meshes, poses and signals as they are in the page, ghosts, arrows,
springs, and its size."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

import coscrew_codegen
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.mechanism.visual import MESH, Triangles, Visual
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.view import body_shapes, mesh_files
from coscrew_codegen.simulation.view.body_shapes import box_of, drawn
from coscrew_codegen.simulation.view.mesh_files import meshes
from coscrew_codegen.simulation.view.page_text import page
from tests.support.playback_data import ARM, MESHED, PageData, arm, run
from tests.support.scenes import scene_texts as texts

trimesh = pytest.importorskip("trimesh", reason='needs pip install "coscrew[view]"')


def bumpy(count: int) -> "trimesh.Trimesh":
    """A closed mesh of 20 4^count triangles with waves on it."""
    mesh = trimesh.creation.icosphere(count)
    x, y, z = mesh.vertices.T
    mesh.vertices *= (1 + 0.1 * np.sin(9 * x) * np.cos(7 * y) * np.sin(5 * z))[:, None]
    return mesh


# sizes and accuracy

def test_a_page_of_40000_triangles_and_500_samples_is_a_megabyte_at_most(tmp_path):
    bumpy(6).export(tmp_path / "bumpy.stl")  # 81,920 triangles
    results = arm(tmp_path, MESHED.format("bumpy.stl"), precision="double")
    text = page(results)
    data = PageData(text)
    vertices, faces = data.mesh(0)
    assert 38_000 <= len(faces) <= 40_000
    assert len(results[0].t) == 501 and len(text) <= 2**20
    assert trimesh.Trimesh(vertices, faces).volume == pytest.approx(bumpy(6).volume, rel=1e-3)


def test_exactly_40000_triangles_stay_as_they_are(tmp_path):
    """A torus of 200 by 100 quadrilaterals; the page is within a megabyte, too."""
    torus = trimesh.creation.torus(0.5, 0.2, major_sections=200, minor_sections=100)
    torus.export(tmp_path / "torus.stl")
    results = arm(tmp_path, MESHED.format("torus.stl"), precision="double")
    text = page(results)
    assert len(PageData(text).mesh(0)[1]) == len(torus.faces) == 40_000
    assert len(results[0].t) == 501 and len(text) <= 2**20, len(text)


def test_vertices_are_within_a_step_of_their_box(tmp_path):
    """Half a step of 16 bits, and the single precision in which they are kept."""
    bumpy(3).export(tmp_path / "bumpy.stl")
    vertices, faces = PageData(page(arm(tmp_path, MESHED.format("bumpy.stl"),
                                        precision="double"))).mesh(0)
    wanted = bumpy(3)
    corners = wanted.vertices[wanted.faces].reshape(-1, 3)
    step = np.ptp(wanted.vertices, 0) / (2**16 - 1)
    assert len(faces) == len(wanted.faces)
    assert (np.abs(vertices[faces].reshape(-1, 3) - corners) <= 0.51 * step + 1e-6).all()


def test_poses_and_signals_are_those_of_the_run(tmp_path):
    (result,) = run(tmp_path / "pendulum.toml", texts.PENDULUM, until=2.0, precision="double")
    data = PageData(page([result]))
    angles = [float(texts.pendulum(t)[0]) for t in result.t]
    poses = data.poses()[1]
    assert np.abs(poses[0] + np.sin(angles)).max() < 1e-6
    assert np.abs(poses[2] + np.cos(angles)).max() < 1e-6
    assert np.abs(data.signal("q.hinge") - angles).max() < 1e-6
    speeds = np.array([float(texts.pendulum(t)[1]) for t in result.t])
    assert np.abs(data.signal("energy.kinetic") - speeds**2 / 2).max() < 1e-6


# meshes

def piece_of(mesh, suffix: str, folder: Path, most: int = mesh_files.TRIANGLES, **settings):
    mesh.export(folder / f"mesh.{suffix}")
    (pieces,) = meshes([Visual(MESH, mesh=folder / f"mesh.{suffix}", **settings)], most)
    return pieces


@pytest.mark.parametrize("suffix", ("stl", "obj", "dae", "ply"))
def test_meshes_of_all_formats_are_the_same(tmp_path, suffix):
    """Their corners are welded: an STL repeats each."""
    box = trimesh.creation.box((1, 2, 3))
    (piece,) = piece_of(box, suffix, tmp_path)
    assert (len(piece.vertices), len(piece.faces)) == (8, 12)
    assert trimesh.Trimesh(piece.vertices, piece.faces).volume == pytest.approx(6)


def test_a_mirrored_mesh_keeps_its_outside(tmp_path):
    (piece,) = piece_of(trimesh.creation.box((1, 2, 3)), "stl", tmp_path, scale=(1.0, -1.0, 2.0))
    assert trimesh.Trimesh(piece.vertices, piece.faces).volume == pytest.approx(12)


def test_lengths_are_in_the_unit_of_a_collada_file(tmp_path):
    mesh = trimesh.creation.box((1, 2, 3))
    mesh.export(tmp_path / "mesh.dae")
    text = (tmp_path / "mesh.dae").read_text()
    (tmp_path / "mesh.dae").write_text(re.sub(
        r"<asset>", '<asset><unit name="inch" meter="0.0254"/>', re.sub(
            r"<unit [^>]*/>", "", text), count=1))
    (pieces,) = meshes([Visual(MESH, mesh=tmp_path / "mesh.dae")])
    assert np.ptp(pieces[0].vertices, 0) == pytest.approx([0.0254, 0.0508, 0.0762])


def test_a_coloured_file_has_a_piece_for_each_colour(tmp_path):
    scene = trimesh.Scene()
    for n, colour in enumerate(((255, 0, 0, 255), (0, 255, 0, 255), (255, 0, 0, 255))):
        box = trimesh.creation.box((1, 1, 1))
        box.apply_translation((3 * n, 0, 0))
        box.visual = trimesh.visual.TextureVisuals(
            material=trimesh.visual.material.PBRMaterial(baseColorFactor=colour))
        scene.add_geometry(box)
    scene.export(tmp_path / "mesh.glb")
    (pieces,) = meshes([Visual(MESH, mesh=tmp_path / "mesh.glb")])
    assert {x.colour[:3]: len(x.faces) for x in pieces} == {(1, 0, 0): 24, (0, 1, 0): 12}


def test_simplified_meshes_stay_near(tmp_path):
    """To a fifth of the triangles, within 1 % of the size, and near the number that is wanted."""
    (piece,) = piece_of(bumpy(5), "stl", tmp_path, 4000)
    assert 3600 <= len(piece.faces) <= 4000
    near = trimesh.proximity.signed_distance(bumpy(5), piece.vertices) \
        if trimesh.util.has_module("rtree") else np.zeros(1)
    assert np.abs(near).max() < 0.02
    assert trimesh.Trimesh(piece.vertices, piece.faces).volume == pytest.approx(
        bumpy(5).volume, rel=2e-3)


def test_equal_meshes_are_in_the_page_once(tmp_path):
    bumpy(2).export(tmp_path / "bumpy.stl")
    (tmp_path / "same.stl").write_bytes((tmp_path / "bumpy.stl").read_bytes())
    data = PageData(page(arm(tmp_path, MESHED.format("bumpy.stl"), MESHED.format("same.stl"),
                             precision="double"))).json
    assert [x["mesh"] for x in data["parts"]] == [0, 0]
    assert len(data["meshes"]) == 1


def test_a_broken_mesh_is_named_in_the_page_and_a_box_in_its_place(tmp_path):
    (tmp_path / "broken.dae").write_text("<COLLADA>")
    (result,) = arm(tmp_path, MESHED.format("broken.dae"), precision="double")
    drawing = drawn(result.system)
    assert [x.shape for x in drawing.parts] == ["box"]
    (note,) = drawing.notes
    assert note.startswith(f"arm: {tmp_path / 'broken.dae'}: trimesh says: ")
    assert f"<li>{note.partition(':')[0]}:" in page([result])


def test_without_the_extra_boxes_are_shown_and_a_sentence_says_so(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(mesh_files, "PACKAGES", ("no_such_module",))
    bumpy(1).export(tmp_path / "bumpy.stl")
    arm(tmp_path, MESHED.format("bumpy.stl"), MESHED.format("bumpy.stl"), precision="double")
    capsys.readouterr()
    assert main(["simulate", str(tmp_path / "arm.toml"), "--view", str(tmp_path / "arm.html"),
                 "--precision", "double", "--until", "0.1"]) == 0
    printed = capsys.readouterr().err
    wanted = ("2 meshes are not shown, boxes of inertia are in their place; run "
              '`pip install "coscrew[view]"`')
    assert printed.count(wanted) == 1
    data = PageData((tmp_path / "arm.html").read_text()).json
    assert [x["kind"] for x in data["parts"]] == ["box"]


def test_meshes_of_readers_need_no_package(monkeypatch):
    monkeypatch.setattr(mesh_files, "PACKAGES", ("no_such_module",))
    box = trimesh.creation.box((1, 2, 3))
    ((piece,),) = meshes([Visual(MESH, mesh=Triangles(box.vertices, box.faces))])
    assert (len(piece.vertices), len(piece.faces)) == (8, 12)


def y_up(folder: Path, at: tuple[float, float, float]):
    """The drawing of the arm, whose mesh is a box at this place and says that y is up."""
    box = trimesh.creation.box((0.2, 0.2, 0.2))
    box.apply_translation(at)
    box.export(folder / "mesh.dae")
    text = re.sub("<up_axis>.*?</up_axis>", "", (folder / "mesh.dae").read_text())
    (folder / "mesh.dae").write_text(re.sub(
        "</asset>", "<up_axis>Y_UP</up_axis></asset>", text, count=1))
    (result,) = arm(folder, MESHED.format("mesh.dae"), precision="double", until=0.1)
    (part,) = drawn(result.system).parts
    return part


@pytest.mark.parametrize("at, turned", (((0, -1, 0.1), True), ((0, 0.1, -1), False)))
def test_y_is_up_in_a_collada_file_where_the_mass_says_so(tmp_path, at, turned):
    """The centre of mass is 1 m below the joint: there the mesh is drawn, whatever its file says.
    """
    part = y_up(tmp_path, at)
    (x, y, z, w), (a, b, c) = part.place[3:], at
    assert (x, y, z, w) == pytest.approx((0.5**0.5, 0, 0, 0.5**0.5) if turned else (0, 0, 0, 1))
    placed = (a, -c, b) if turned else (a, b, c)
    assert placed[2] == -1


# what is drawn

@pytest.mark.parametrize("sides", ((1, 2, 3), (0.1, 0.1, 5), (2, 2, 2)))
def test_boxes_have_the_bodies_inertia(sides):
    a, b, c = sides
    mass = 7.0
    moments = mass / 12 * np.array([b * b + c * c, a * a + c * c, a * a + b * b])
    half, axes = box_of(np.array([mass]), np.array([*moments, 0, 0, 0]))
    assert half == pytest.approx(np.array(sides) / 2)
    assert np.array_equal(axes, np.eye(3))
    turn = np.linalg.qr(np.array([[1.0, 2, 3], [-1, 1, 0.5], [0.3, -2, 1]]))[0]
    xx, xy, xz, yy, yz, zz = (turn @ np.diag(moments) @ turn.T)[np.triu_indices(3)]
    half, axes = box_of(np.array([mass]), np.array([xx, yy, zz, xy, xz, yz]))
    assert sorted(2 * half) == pytest.approx(sorted(sides))
    assert np.linalg.det(axes) == pytest.approx(1)
    again = axes @ np.diag(mass / 3 * (np.sum(half**2) - half**2)) @ axes.T
    assert again == pytest.approx(turn @ np.diag(moments) @ turn.T)


def test_rods_go_from_origins_to_joints_and_balls_stand_where_they_move(tmp_path):
    (result,) = run(tmp_path / "pendulum.toml", texts.PENDULUM, until=0.1, precision="double")
    parts = drawn(result.system).parts
    (rod,) = (x for x in parts if x.shape == "cylinder")
    assert (rod.body, rod.size[1], rod.place[:3]) == (0, 1, (0, 0, -0.5))
    (ball,) = (x for x in parts if x.shape == "sphere")
    assert (ball.body, ball.place[:3]) == (-1, (0, 0, 0))
    assert [x.body for x in parts if x.shape == "box"] == [1]


def test_a_sliding_body_hangs_on_a_rod(tmp_path):
    results = run(tmp_path / "spring.toml", texts.SPRING, until=0.1, precision="double")
    assert PageData(page(results)).json["ties"] == [{"kind": "rod", "ends": [
        {"body": -1, "point": [0, 0, 0]}, {"body": 0, "point": [0, 0, 0]}]}]


def test_rods_that_close_loops_join_their_points(tmp_path):
    """Two pendulums, 1 m apart, and a rod between them."""
    body = "mass = 1, com = [0, 0, -1], inertia = [0.1, 0.1, 0.1]"
    results = run(tmp_path / "linked.toml", f"""[bodies]
left = {{ {body} }}
right = {{ {body} }}
[joints]
left = {{ type = "revolute", child = "left", axis = [0, 1, 0] }}
right = {{ type = "revolute", child = "right", axis = [0, 1, 0], origin.xyz = [1, 0, 0] }}
[loops.rod]
kind = "rod"
bodies = ["left", "right"]
first = [0, 0, -1]
second = [0, 0, -0.75]
length = 1.0307764064044151
[effects.gravity]
""", until=0.1, precision="double")
    assert PageData(page(results)).json["ties"][0] == {"kind": "rod", "ends": [
        {"body": 0, "point": [0, 0, -1]}, {"body": 1, "point": [0, 0, -0.75]}]}


def test_bodies_of_hardly_any_mass_without_visuals_are_frames(tmp_path, monkeypatch):
    (result,) = arm(tmp_path, '<visual><geometry><sphere radius="1"/></geometry></visual>',
                    text=ARM + """
[attach.payload]
to = "arm"
mass = 0.5
shape = { box = [0.1, 0.2, 0.3] }
[attach.screw]
to = "arm"
mass = 1e-3
shape = { box = [0.1, 0.2, 0.3] }
""", precision="double", until=0.1)
    names = [x.name for x in result.system.scene.model.bodies]
    shapes = {(names[x.body], x.shape): x.size for x in drawn(result.system).parts}
    assert shapes == {("arm", "sphere"): (1,), ("payload", "box"): pytest.approx((0.1, 0.2, 0.3))}
    monkeypatch.setattr(body_shapes, "_HARDLY", 0.0)
    assert ("screw", "box") in {(names[x.body], x.shape) for x in drawn(result.system).parts}


def test_collision_shapes_are_parts_of_their_own(tmp_path):
    """A mesh that a visual has, too, is in the page once; a further one is simplified apart."""
    bumpy(2).export(tmp_path / "bumpy.stl")
    bumpy(6).export(tmp_path / "rough.stl")  # 81,920 triangles
    shapes = (f'<collision><geometry><mesh filename="{x}"/></geometry></collision>'
              for x in ("bumpy.stl", "rough.stl", "none.stl"))
    (result,) = arm(tmp_path, MESHED.format("bumpy.stl"), *shapes,
                    '<collision><origin xyz="0 0 -1"/><geometry><sphere radius="0.5"/></geometry>'
                    "</collision>", precision="double", until=0.1)
    text = page([result])
    data = PageData(text)
    (seen,), (same, rough, ball) = data.json["parts"], data.json["collisions"]
    assert same["mesh"] == seen["mesh"] and len(data.json["meshes"]) == 2
    assert 9_000 <= len(data.mesh(rough["mesh"])[1]) <= 10_000
    assert (ball["kind"], ball["size"], ball["place"]) == ("sphere", [0.5], [0, 0, -1, 0, 0, 0, 1])
    assert "1 shape is not shown" in text
    (note,) = re.findall("<li>(arm: a collision.*?)</li>", text)
    assert re.fullmatch("arm: a collision shape: line [12]: no file .*none.stl.*", note)


# ghosts, arrows, springs

@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """The page's data of the arm in double and single precision, and its results."""
    results = arm(tmp_path_factory.mktemp("both"), precision="both", until=1.0)
    return PageData(page(results)), results


def test_single_precision_and_targets_are_ghosts(both):
    data, results = both
    assert [(x["label"], x["shown"]) for x in data.json["runs"]] == [
        ("double", True), ("single", True), ("target", False)]
    t = data.array(data.json["runs"][2]["t"])
    places = np.searchsorted(results[1].t, data.array(data.json["runs"][1]["t"]))
    single = results[1].recorded["q.hinge"].astype(float)[places]
    assert np.abs(data.signal("q.hinge", 1) - single).max() < 1e-7
    assert np.abs(data.signal("q.hinge", 2) - 0.5 * t).max() < 1e-6
    body = [x["name"] for x in data.json["bodies"]].index("arm")
    assert np.abs(data.poses(2)[body, 4] - np.sin(0.25 * t)).max() < 1e-6


def test_arrows_stand_where_recorded_forces_act(both):
    data, _ = both
    body = [x["name"] for x in data.json["bodies"]].index("arm")
    reaction, gust = data.json["arrows"]
    assert reaction["signals"] == [f"reaction.hinge.{i}" for i in range(3)]
    assert (reaction["body"], reaction["point"], reaction["turns"]) == (body, [0, 0, 0], True)
    assert (gust["body"], gust["point"], gust["turns"]) == (body, [0, 0, -1], False)
    assert [data.signal(x)[3] for x in gust["signals"]] == pytest.approx([3, 0, 0], abs=1e-6)


def test_springs_between_bodies_join_their_points(both):
    data, _ = both
    body = [x["name"] for x in data.json["bodies"]].index("arm")
    assert data.json["ties"] == [{"kind": "spring", "ends": [
        {"body": -1, "point": [1, 0, 0]}, {"body": body, "point": [0, 0, -1]}]}]


@pytest.mark.parametrize("suffix", ("csv", "npz", "parquet"))
def test_a_recording_is_shown_beside_the_run(tmp_path, suffix, capsys):
    """Its poses are those of its own coordinates."""
    scene, other = tmp_path / "pendulum.toml", tmp_path / f"before.{suffix}"
    scene.write_text(texts.PENDULUM)
    words = ["simulate", str(scene), "--until", "1", "--precision", "double"]
    assert main([*words, "--step", "0.005", "--integrator", "semi-implicit-euler", "--output",
                 str(other)]) == 0
    assert main([*words, "--view", str(tmp_path / "now.html"), str(other)]) == 0
    data = PageData((tmp_path / "now.html").read_text())
    assert [x["label"] for x in data.json["runs"]] == ["double", "before"]
    q = data.signal("q.hinge", 1)
    assert np.abs(q - data.signal("q.hinge", 0)).max() > 1e-4
    assert np.abs(data.poses(1)[1, 4] - np.sin(q / 2)).max() < 1e-6


@pytest.mark.parametrize("name, problem", (
    ("none.csv", "cannot read"), ("x.npz", "is no recording"),
    ("lacks.csv", "has no column q.hinge; wanted a recording of all coordinates")))
def test_what_is_no_recording_is_refused(tmp_path, capsys, name, problem):
    (tmp_path / "lacks.csv").write_text("t [s],v.hinge [rad/s]\n0,1\n")
    (tmp_path / "x.npz").write_text("")
    (tmp_path / "pendulum.toml").write_text(texts.PENDULUM)
    assert main(["simulate", str(tmp_path / "pendulum.toml"), "--until", "0.1", "--view",
                 str(tmp_path / "x.html"), str(tmp_path / name)]) != 0
    assert problem in capsys.readouterr().err
    assert not (tmp_path / "x.html").exists()


def test_runs_from_python_are_pages_too(tmp_path):
    """The poses are compiled for the page alone; a further run is a ghost."""
    (tmp_path / "pendulum.toml").write_text(texts.PENDULUM)
    one, other = (coscrew_codegen.run(tmp_path / "pendulum.toml", until=1.0, precision="double",
                                      record=["q"], q0=[q]) for q in (0.5, 0.6))
    assert not one.system.has("body_poses")
    one.view(tmp_path / "one.html", other)
    data = PageData((tmp_path / "one.html").read_text())
    assert [x["label"] for x in data.json["runs"]] == ["run 1", "run 2"]
    for n, q in enumerate((0.5, 0.6)):
        assert data.poses(n)[1, 4, 0] == pytest.approx(math.sin(q / 2), abs=1e-7)
    with pytest.raises(SimulateError, match="ends in .html"):
        one.view(tmp_path / "one.txt")


def test_gravity_says_where_up_is(tmp_path):
    (result,) = run(tmp_path / "pendulum.toml", texts.PENDULUM.replace(
        "[effects.gravity]", "[effects.gravity]\ng = [3, -4, 0]"), until=0.1, precision="double")
    up = PageData(page([result])).json["up"]
    assert up == pytest.approx([-0.6, 0.8, 0]) and math.hypot(*up) == pytest.approx(1)


def test_a_motor_that_drives_the_velocity_alone_has_no_ghost(tmp_path):
    (result,) = arm(tmp_path, text=ARM.replace("kp = 40", "kp = 0"), until=0.1)
    assert [x["label"] for x in PageData(page([result])).json["runs"]] == ["double"]
