"""Playbacks as recordings of Rerun and Foxglove, read back by their own libraries; the files that
`--view` takes."""

import json
import math
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import coscrew_codegen
from coscrew_codegen.__main__ import main
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.recordings import recording_writer
from coscrew_codegen.simulation.view.mesh_normals import creased
from coscrew_codegen.simulation.view.view_files import view
from tests.support.playback_data import PageData, arm
from tests.support.scenes import scene_texts as texts

trimesh = pytest.importorskip("trimesh", reason='needs pip install "coscrew[view]"')
TILT = 0.5  # about y, of all shapes
SHAPES = ('<box size="1 2 3"/>', '<sphere radius="0.5"/>', '<cylinder radius="0.1" length="2"/>',
          '<capsule radius="0.1" length="2"/>', '<mesh filename="box.stl"/>')


@pytest.fixture(scope="module")
def seen(tmp_path_factory):
    """The folder with the files of an arm of all shapes, and its runs: in double and in single
    precision."""
    folder = tmp_path_factory.mktemp("seen")
    trimesh.creation.box((1, 2, 3)).export(folder / "box.stl")
    visuals = (f'<visual><origin xyz="0 0 -1" rpy="0 {TILT} 0"/><geometry>{x}</geometry>'
               '<material name="red"><color rgba="1 0 0 0.5"/></material></visual>' for x in SHAPES)
    results = arm(folder, *visuals, precision="both", until=1.0)
    view(results, [folder / "arm.mcap"])
    return folder, results


def half_angle(result) -> np.ndarray:
    """sin(q/2), the y of the arm's quaternion, at the samples that are shown: 60 a second."""
    frames = np.unique(np.linspace(0, len(result.t) - 1, 62).round().astype(int))
    return result.t[frames], np.sin(result.recorded["q.hinge"][frames].astype(float) / 2)


# Rerun

@pytest.fixture(scope="module")
def entities(seen):
    """Columns of the recording by entity and component; times stand beside them as `t`."""
    pytest.importorskip("rerun", reason='needs pip install "coscrew[rerun]"')
    from rerun.chunk import RrdReader

    folder, runs = seen
    view(runs, [folder / "arm.rrd"])
    results: dict[str, dict[str, list]] = {}
    for chunk in RrdReader(folder / "arm.rrd").stream():
        batch = chunk.to_record_batch()
        for name, column in zip(batch.schema.names, batch.columns, strict=True):
            if name == "t" or ":" in name:
                of = results.setdefault(chunk.entity_path.replace("\\", ""), {})
                of.setdefault(name, []).extend(column.to_pylist())
    return results


def test_rerun_reads_poses_and_signals_of_every_run(seen, entities):
    _, results = seen
    for label, result in zip(("double", "single"), results, strict=True):
        t, wanted = half_angle(result)
        of = entities[f"/world/{label}/arm"]
        assert [x.total_seconds() for x in of["t"]] == pytest.approx(t, abs=1e-6)
        turns = np.array([x[0] for x in of["Transform3D:quaternion"]])
        assert np.abs(turns - wanted[:, None] * [0, 1, 0, 0])[:, :3].max() < 1e-6
    q = entities["/signals/Positions q, rad/hinge (single)"]["Scalars:scalars"]
    assert np.abs(np.sin(np.ravel(q) / 2) - half_angle(results[1])[1]).max() < 1e-7
    target = entities["/signals/Positions q, rad/hinge (target)"]
    assert np.ravel(target["Scalars:scalars"]) == pytest.approx(
        [0.5 * x.total_seconds() for x in target["t"]], abs=1e-6)


def test_rerun_reads_the_shapes_at_their_places(entities):
    arm_of = "/world/double/arm"
    shapes = {n: entities[f"{arm_of}/shape {n}"] for n in range(len(SHAPES))}
    assert shapes[0]["Boxes3D:half_sizes"] == [[[0.5, 1, 1.5]]]
    assert shapes[1]["Ellipsoids3D:half_sizes"] == [[[0.5, 0.5, 0.5]]]
    for n, kind in ((2, "Cylinders3D"), (3, "Capsules3D")):
        assert shapes[n][f"{kind}:lengths"] == [[2]]
        assert shapes[n][f"{kind}:radii"] == [[pytest.approx(0.1)]]
    assert shapes[3]["Capsules3D:translations"] == [[[0, 0, -1]]]  # it starts at its first centre
    corners = np.array(shapes[4]["Mesh3D:vertex_positions"][0])
    faces = np.array(shapes[4]["Mesh3D:triangle_indices"][0])
    assert trimesh.Trimesh(corners, faces).volume == pytest.approx(6)
    normals = np.array(shapes[4]["Mesh3D:vertex_normals"][0])
    flat = np.cross(*np.diff(corners[faces], axis=1).transpose(1, 0, 2))  # of each face
    flat /= np.linalg.norm(flat, axis=1, keepdims=True)
    assert np.abs(normals[faces] - flat[:, None]).max() < 1e-6  # a box has edges
    for x in shapes.values():
        assert x["Transform3D:translation"] == [[[0, 0, -1]]]
        assert x["Transform3D:quaternion"][0][0] == pytest.approx(
            [0, math.sin(TILT / 2), 0, math.cos(TILT / 2)])
    opacities = [entities[f"/world/{x}/arm/shape 0"]["Boxes3D:colors"][0][0] & 255
                 for x in ("double", "single")]
    assert opacities == [128, 45]  # half, and 35 % of it
    assert "/world/double/base/shape 0" not in entities


def test_rerun_keeps_quantities_of_different_units_apart(tmp_path):
    """A plot shows all that stands below its place: angles and lengths have places of their own."""
    pytest.importorskip("rerun", reason='needs pip install "coscrew[rerun]"')
    from rerun.chunk import RrdReader

    scene = tmp_path / "crane.toml"
    scene.write_text("""
[bodies]
cart = { mass = 1 }
load = { mass = 1, com = [0, 0, -1] }
[joints]
rail = { type = "prismatic", child = "cart", axis = [1, 0, 0] }
rope = { type = "revolute", parent = "cart", child = "load", axis = [0, 1, 0] }
[effects.gravity]
[outputs]
record = ["q"]
[run]
duration = 0.1
""", encoding="utf-8")
    coscrew_codegen.run(scene).view(tmp_path / "crane.rrd")
    names = {x.entity_path.replace("\\", "")
             for x in RrdReader(tmp_path / "crane.rrd").stream()}
    assert {x for x in names if "Positions" in x} == {
        "/signals/Positions q, m/rail", "/signals/Positions q, rad/rope"}


def test_normals_are_those_of_a_round_surface_and_edges_stay():
    """A sphere's are its radii, to half the turn from one face to the next; a tube's rims are
    edges.  No face turns."""
    ball = trimesh.creation.icosphere(3)
    vertices, faces, normals = creased(ball.vertices, ball.faces)
    assert len(vertices) == len(ball.vertices)
    half = ball.face_adjacency_angles.max() / 2
    assert np.einsum("ij,ij->i", vertices, normals).min() > np.cos(half)
    tube = trimesh.creation.cylinder(1, 2, sections=64)
    vertices, faces, normals = creased(tube.vertices, tube.faces)
    assert (vertices[faces] == tube.vertices[tube.faces]).all()
    across = np.abs(normals[:, 2])
    assert set(np.round(across, 3)) == {0, 1}
    wall = across < 0.5
    assert np.einsum("ij,ij->i", vertices[wall, :2], normals[wall, :2]).min() > np.cos(0.05)


def test_a_recording_of_rerun_names_its_origin_and_has_a_layout(seen, entities):
    from rerun.chunk import RrdReader

    (text,) = entities["/origin"]["TextDocument:text"][0]
    assert "integrator: " in text and "scene: " in text
    (blueprint,) = RrdReader(seen[0] / "arm.rrd").blueprints()
    assert blueprint.application_id == "arm"


# Foxglove

@pytest.fixture(scope="module")
def topics(seen):
    """Times in s and messages by topic."""
    pytest.importorskip("foxglove", reason='needs pip install "coscrew[foxglove]"')
    reader = pytest.importorskip("mcap.reader", reason="needs pip install mcap")
    protobuf = pytest.importorskip("mcap_protobuf.decoder",
                                   reason="needs pip install mcap-protobuf-support")
    results: dict[str, list] = {}
    with (seen[0] / "arm.mcap").open("rb") as file:
        for schema, channel, message, decoded in reader.make_reader(
                file, decoder_factories=[protobuf.DecoderFactory(), Decoding()]
        ).iter_decoded_messages():
            results.setdefault(channel.topic, []).append((message.log_time / 1e9, decoded))
            assert schema.name.startswith("foxglove.") == (channel.message_encoding == "protobuf")
    return results


class Decoding:
    """Decodes messages of JSON."""

    def decoder_for(self, encoding, _):
        return json.loads if encoding == "json" else None


def test_foxglove_reads_poses_and_signals_of_every_run(seen, topics):
    for prefix, result in zip(("", "single/"), seen[1], strict=True):
        t, wanted = half_angle(result)
        frames = [(time, x) for time, message in topics["/frames"] for x in message.transforms
                  if x.child_frame_id == f"{prefix}arm"]
        assert [time for time, _ in frames] == pytest.approx(t, abs=1e-9)
        assert [x.rotation.y for _, x in frames] == pytest.approx(wanted, abs=1e-7)
        assert {x.parent_frame_id for _, x in frames} == {"world"}
        assert all(x.timestamp.seconds + x.timestamp.nanos / 1e9 == time for time, x in frames)
        q = [math.sin(x["hinge"] / 2) for _, x in topics[f"/{prefix}q"]]
        assert q == pytest.approx(wanted, abs=1e-7)
    assert {*topics["/energy"][0][1]} == {"kinetic", "potential", "total"}
    assert [x["0"] for _, x in topics["/wrench/gust/force"]] == pytest.approx(
        [3.0] * 62)
    assert [x["hinge"] for _, x in topics["/target/q"]] == pytest.approx(
        [0.5 * t for t, _ in topics["/target/q"]], abs=1e-12)


def test_foxglove_reads_the_shapes_at_their_places(topics):
    ((_, scene),) = topics["/scene"]
    of = {x.frame_id: x for x in scene.entities}
    assert {*of} == {"arm", "single/arm", "target/arm"} and of["arm"].frame_locked
    (box,), (cylinder, trunk) = of["arm"].cubes, of["arm"].cylinders
    ball, *ends = of["arm"].spheres
    (mesh,) = of["arm"].triangles
    assert [(x.size.x, x.size.y, x.size.z) for x in (box, ball, cylinder, trunk)] == [
        (1, 2, 3), (1, 1, 1), (0.2, 0.2, 2), (0.2, 0.2, 2)]
    assert {(x.top_scale, x.bottom_scale) for x in (cylinder, trunk)} == {(1, 1)}
    for x, side in zip(ends, (-1, 1), strict=True):  # half the length along the turned z
        assert (x.pose.position.x, x.pose.position.z) == pytest.approx(
            (side * math.sin(TILT), -1 + side * math.cos(TILT)))
    corners = np.array([(x.x, x.y, x.z) for x in mesh.points])
    assert trimesh.Trimesh(corners, np.reshape(mesh.indices, (-1, 3))).volume == pytest.approx(6)
    for x in (box, ball, cylinder, trunk, mesh):
        assert (x.pose.position.z, x.pose.orientation.y) == pytest.approx((-1, math.sin(TILT / 2)))
    assert [of[x].cubes[0].color.a for x in ("arm", "single/arm")] == pytest.approx([0.5, 0.175])


def test_messages_are_those_of_the_published_schemas(seen, topics):
    """Messages of Foxglove's types are read by the modules that Foxglove publishes for them, with
    the same content and nothing unknown; the others are valid by their own JSON Schema."""
    published = pytest.importorskip("foxglove_schemas_protobuf.SceneUpdate_pb2",
                                    reason="needs pip install foxglove-schemas-protobuf")
    from foxglove_schemas_protobuf.FrameTransforms_pb2 import FrameTransforms
    from google.protobuf.json_format import MessageToDict
    from google.protobuf.unknown_fields import UnknownFieldSet
    from mcap.reader import make_reader

    types = {"/scene": published.SceneUpdate, "/frames": FrameTransforms}
    counts = dict.fromkeys(topics, 0)
    with (seen[0] / "arm.mcap").open("rb") as file:
        for schema, channel, message in make_reader(file).iter_messages():
            topic, number = channel.topic, counts[channel.topic]
            counts[topic] += 1
            if topic not in types:
                assert (schema.encoding, channel.message_encoding) == ("jsonschema", "json")
                of = json.loads(schema.data)
                jsonschema.Draft202012Validator.check_schema(of)
                jsonschema.validate(json.loads(message.data), {**of, "additionalProperties": False})
                continue
            read = types[topic].FromString(message.data)
            assert (schema.encoding, schema.name) == ("protobuf", read.DESCRIPTOR.full_name)
            assert not len(UnknownFieldSet(read))
            assert MessageToDict(read) == MessageToDict(topics[topic][number][1])
    assert {*types} < {*counts} and all(counts.values())


# the command line, and Python

def test_one_run_is_written_in_every_format(tmp_path, capsys):
    for module in ("rerun", "foxglove"):
        pytest.importorskip(module)
    (tmp_path / "pendulum.toml").write_text(texts.PENDULUM)
    files = [tmp_path / f"run.{x}" for x in ("html", "rrd", "mcap")]
    assert main(["simulate", str(tmp_path / "pendulum.toml"), "--until", "0.2", "--precision",
                 "double", "--view", *map(str, files)]) == 0
    assert all(x.stat().st_size > 1000 for x in files)
    coscrew_codegen.run(tmp_path / "pendulum.toml", until=0.1, precision="double").view(
        tmp_path / "python.mcap")
    assert (tmp_path / "python.mcap").read_bytes().startswith(b"\x89MCAP0")


@pytest.mark.parametrize("words, problem", (
    (["SCENE", "--view", "a.csv", "b.csv"],
     "--view: a.csv b.csv: these are recordings to show; wanted, before them, a file to write: "
     "--view run.html a.csv b.csv"),
    (["--view", "run.html", "SCENE"],
     "pendulum.toml: wanted a file to write (.html, .rrd, .mcap) or recordings to show in it "
     "(.csv, .npz, .parquet); SCENE stands before --view"),
    (["SCENE", "--view", "run.gif"], "run.gif: wanted a file to write"),
    (["SCENE", "--view", "run.html", "none.csv"], "--view: cannot read none.csv")))
def test_files_that_cannot_be_meant_are_refused_before_the_run(tmp_path, capsys, monkeypatch, words,
                                                               problem):
    (tmp_path / "pendulum.toml").write_text(texts.PENDULUM)
    monkeypatch.chdir(tmp_path)
    try:
        status = main(["simulate", *("pendulum.toml" if x == "SCENE" else x for x in words)])
    except SystemExit as error:  # of argparse
        status = error.code
    assert status == 2
    assert problem in capsys.readouterr().err
    assert [x.name for x in tmp_path.iterdir()] == ["pendulum.toml"]


@pytest.mark.parametrize("suffix, extra", ((".rrd", "rerun"), (".mcap", "foxglove")))
def test_a_missing_library_is_named_with_the_command_that_installs_it(
        tmp_path, monkeypatch, suffix, extra):
    monkeypatch.setattr(recording_writer, "_NEEDED", {suffix: ("no_such_module", extra)})
    with pytest.raises(SimulateError) as error:
        recording_writer.check_target(tmp_path / f"run{suffix}", (suffix,))
    assert str(error.value).endswith(
        f'run{suffix}: {suffix} needs no_such_module; run `pip install "coscrew[{extra}]"`')


def test_two_recordings_are_overlaid_with_the_run(tmp_path):
    """Runs before and after a change: the second is repeated, with its bits."""
    pytest.importorskip("foxglove")
    (tmp_path / "pendulum.toml").write_text(texts.PENDULUM)
    words = ["simulate", str(tmp_path / "pendulum.toml")]
    before, after = (tmp_path / f"{x}.csv" for x in ("before", "after"))
    for path, step in ((before, "0.02"), (after, "0.005")):
        assert main([*words, "--precision", "double", "--until", "0.5", "--step", step, "--output",
                     str(path)]) == 0
    page = tmp_path / "both.html"
    assert main([*words, "--again", str(after), "--view", str(page), str(before), str(after)]) == 0
    data = PageData(Path(page).read_text())
    assert [x["label"] for x in data.json["runs"]] == ["double", "before", "after"]
    assert np.array_equal(data.signal("q.hinge", 0), data.signal("q.hinge", 2))
    assert not np.array_equal(data.signal("q.hinge", 0), data.signal("q.hinge", 1))
