"""Recorded values equal closed forms; other programs read the written files."""

import csv
import io
import json
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pyarrow.parquet
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.recordings import recording_writer
from coscrew_codegen.simulation.recordings.record import differences
from coscrew_codegen.simulation.recordings.recording import Column, Recording
from coscrew_codegen.simulation.recordings.recording_plot import plot
from coscrew_codegen.simulation.run_summary import RunOverrides, simulated
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.selecting import STEPPED

ENDINGS = tuple(recording_writer.FORMATS)
EVERYTHING = """record = ["q", "v", "a", "energy", "momentum", "power", "pose.bob", "position.bob",
    "twist.bob", "reaction.hinge", "energy.total", "pose.bob.3"]"""


def outcomes(folder: Path, text: str, **requested):
    path = folder / "scene.toml"
    path.write_text(text)
    return simulated(load_scene(path, functions=STEPPED), RunOverrides(**requested))


@pytest.fixture(scope="module")
def swings(tmp_path_factory):
    """The pendulum in both precisions for two seconds, everything recorded."""
    text = texts.PENDULUM.replace(
        'record = ["q", "v", "energy", "position.bob", "reaction.hinge"]', EVERYTHING)
    return outcomes(tmp_path_factory.mktemp("swings"), text, until=2.0)


def columns(recording: Recording, stem: str, count: int) -> np.ndarray:
    return np.column_stack([recording.of(f"{stem}.{i}") for i in range(count)]).astype(float)


# what is recorded

def truth(recording: Recording) -> tuple[np.ndarray, np.ndarray]:
    states = [texts.pendulum(t) for t in recording.t]
    return tuple(np.array([float(x) for x in column]) for column in zip(*states, strict=True))


@pytest.mark.parametrize("number, error", ((0, 1e-9), (1, 1e-4)))
def test_quantities_of_a_pendulum_are_its_closed_forms(swings, number, error):
    """A point mass of 1 kg at 1 m: all from angle and speed, which come from elliptic functions."""
    result, g = swings[number].recording, texts.GRAVITY
    q, v = truth(result)
    s, c, zero = np.sin(q), np.cos(q), 0 * q
    wanted = {
        "q.hinge": q, "v.hinge": v, "a.hinge": -g * s, "power": zero,
        "energy.kinetic": v**2 / 2, "energy.potential": -g * c, "energy.total": v**2 / 2 - g * c}
    for name, values in wanted.items():
        assert np.abs(result.of(name) - values).max() < error, name
    place, velocity = np.column_stack((-s, zero, -c)), np.column_stack((-c * v, zero, s * v))
    turn = np.column_stack((c, zero, s, -s, zero, 1 + zero, zero, zero, -s, zero, c, -c))
    own = np.column_stack((-v, zero, zero, zero, v, zero))  # the bob's frame moves with the bob
    reaction = np.column_stack((g * 0 * s, zero, v**2 + g * c, zero, zero, zero))
    for stem, count, values in (
            ("position.bob", 3, place), ("pose.bob", 12, turn), ("twist.bob", 6, own),
            ("momentum", 6, np.column_stack((velocity, np.cross(place, velocity)))),
            ("reaction.hinge", 6, reaction)):
        assert np.abs(columns(result, stem, count) - values).max() < error, stem


def test_the_power_of_damping_is_recorded(tmp_path):
    (result,) = [x.recording for x in outcomes(tmp_path, texts.SPRING, precision="double")]
    v = np.array([float(texts.spring(t)[1]) for t in result.t])
    assert np.abs(result.of("power") + texts.DAMPING * v**2).max() < 1e-9


def test_columns_have_names_and_units_once(swings):
    result = swings[0].recording
    names = [x.name for x in result.columns]
    assert len(set(names)) == len(names) == result.values.shape[1]
    units = {x.name: x.unit for x in result.columns}
    assert [units[x] for x in ("q.hinge", "v.hinge", "a.hinge", "energy.kinetic", "power",
                               "pose.bob.0", "pose.bob.3", "reaction.hinge.0", "reaction.hinge.5")
            ] == ["rad", "rad/s", "rad/s^2", "J", "W", "1", "m", "N", "N m"]


def test_values_are_of_the_precision_they_were_computed_in(swings):
    assert [x.recording.values.dtype for x in swings] == [np.float64, np.float32]


def test_what_is_recorded_does_not_depend_on_how_many_samples_at_once(swings, monkeypatch):
    monkeypatch.setattr("coscrew_codegen.simulation.recordings.record._AT_ONCE", 7)
    from coscrew_codegen.simulation.recordings.record import record

    again = record(swings[0].system, swings[0].trajectory, ())
    assert again.values.tobytes() == swings[0].recording.values.tobytes()


def test_differences_are_the_largest_of_each_quantity():
    columns = (Column("q.a", "rad", "q"), Column("q.b", "rad", "q"), Column("q.c", "m", "q"))
    double = Recording(np.array([0.0, 1.0]), columns,
                       np.array([[1.0, 2.0, 3.0], [4.0, -5.0, 6.0]]), ())
    single = Recording(np.array([0.0, 1.0, 2.0]), columns, np.array(
        [[1.0, 2.5, 3.0], [4.25, -5.0, np.nan], [9, 9, 9]], np.float32), ())
    first, second = differences(double, single)
    assert (first.quantity, first.unit, first.size, first.apart, first.column, first.t) == (
        "q", "rad", 5.0, 0.5, "q.b", 0.0)
    assert (second.unit, second.column, second.t) == ("m", "q.c", 1.0)
    assert np.isnan(second.apart)


# what is written

def read_back(path: Path) -> tuple[list[str], np.ndarray, np.ndarray, dict[str, str]]:
    """Names with units, t, values and provenance, read by programs that know nothing of coscrew."""
    if path.suffix == ".csv":
        lines = path.read_text().splitlines()
        provenance = dict(x[2:].split(": ", 1) for x in lines if x.startswith("#"))
        rows = list(csv.reader(io.StringIO("\n".join(x for x in lines if not x.startswith("#")))))
        numbers = np.array(rows[1:], float)
        return rows[0], numbers[:, 0], numbers[:, 1:], provenance
    if path.suffix == ".npz":
        with np.load(path, allow_pickle=False) as data:
            names = [f"{x} [{unit}]"
                     for x, unit in zip(data["columns"], data["units"], strict=True)]
            return ["t [s]", *names], data["t"], data["values"], dict(data["provenance"].tolist())
    table = pyarrow.parquet.read_table(path)
    names = [f"{x.name} [{x.metadata[b'unit'].decode()}]" for x in table.schema]
    columns = [x.to_numpy() for x in table.columns]
    return (names, columns[0], np.column_stack(columns[1:]),
            json.loads(table.schema.metadata[b"coscrew"]))


@pytest.mark.parametrize("number", (0, 1))
@pytest.mark.parametrize("ending", ENDINGS)
def test_files_read_back_to_the_same_bits(swings, tmp_path, ending, number):
    result, path = swings[number].recording, tmp_path / f"out{ending}"
    recording_writer.write(result, path)
    names, t, values, provenance = read_back(path)
    assert names == ["t [s]", *(f"{x.name} [{x.unit}]" for x in result.columns)]
    assert t.tobytes() == result.t.tobytes()
    assert values.astype(result.values.dtype).tobytes() == result.values.tobytes()
    assert provenance == dict(result.provenance)


def test_provenance_says_where_numbers_come_from(swings):
    provenance = dict(swings[1].recording.provenance)
    assert provenance["scene"] == "scene"
    assert len(provenance["scene sha256"]) == 64
    assert (provenance["precision"], provenance["integrator"]) == ("single", "rk4, step 0.001 s")
    assert "-ffp-contract=off" in provenance["compiler"]
    assert provenance["coscrew"]
    assert "/" not in provenance["coscrew"]


@pytest.mark.parametrize("every, step, messages", [
    (0.01, 1e-3, "step 0.001 s"),
    (1e-4, 1e-3, "step 0.0001 s (at most 0.001 s, and a part of every = 0.0001 s)"),
    (0.01, 0.5, "step 0.01 s (at most 0.5 s, and a part of every = 0.01 s)"),
    (0.0015, 1e-3, "step 0.00075 s (at most 0.001 s, and a part of every = 0.0015 s)")])
def test_provenance_tells_the_step_that_is_taken(tmp_path, every, step, messages):
    """A sample lies at the end of a step."""
    text = texts.PENDULUM.replace("every = 0.05", f"every = {every}")
    result = outcomes(tmp_path, text, until=0.03, step=step, precision="double")[0].recording
    assert dict(result.provenance)["integrator"] == f"rk4, {messages}"


@pytest.mark.parametrize("ending", (*ENDINGS, ".svg", ".png"))
def test_the_same_run_writes_the_same_bytes(swings, tmp_path, ending):
    for name in ("one", "two"):
        path = tmp_path / f"{name}{ending}"
        if ending in ENDINGS:
            recording_writer.write(swings[0].recording, path)
        else:
            plot([x.recording for x in swings], path)
    assert (tmp_path / f"one{ending}").read_bytes() == (tmp_path / f"two{ending}").read_bytes()


@pytest.mark.parametrize("ending", ENDINGS)
def test_an_error_leaves_the_old_file_whole(swings, tmp_path, monkeypatch, ending):
    path = tmp_path / f"out{ending}"
    path.write_text("old")

    def failing(recording, temporary):
        temporary.write_text("half")
        raise OSError(28, "No space left on device")

    monkeypatch.setitem(recording_writer.FORMATS, ending, failing)
    with pytest.raises(SimulateError, match="No space left on device"):
        recording_writer.write(swings[0].recording, path)
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_awkward_names_stay_one_column(tmp_path):
    columns = (Column('q.a,"b"', "rad", "q"), Column("q.$x_1$", "m", "q"))
    odd = Recording(np.array([0.0]), columns, np.array([[1.0, np.inf]]), (("what", "two\nlines"),))
    for ending in ENDINGS:
        path = tmp_path / f"out{ending}"
        recording_writer.write(odd, path)
        names, _, values, provenance = read_back(path)
        assert names == ["t [s]", 'q.a,"b" [rad]', "q.$x_1$ [m]"]
        assert values.tolist() == [[1.0, np.inf]]
        assert " ".join(provenance["what"].split()) == "two lines"
    plot([odd], tmp_path / "out.svg")


# what a scene's hash is of

def test_the_hash_is_of_what_the_scene_says_not_of_its_layout(tmp_path):
    def hashed(text: str) -> str:
        path = tmp_path / "scene.toml"
        path.write_text(text)
        return read_scene(path).content_hash

    own = hashed(texts.SPRING)
    assert hashed("# a comment\n" + texts.SPRING.replace("mass = 2", "mass = 2.0")) == own
    changed = {hashed(texts.SPRING.replace(*pair)) for pair in (
        ("k = 100", "k = 100.0000001"), ("slide = 0.1", "slide = 0.2"), ("d = 1", "d = 2"),
        ("axis = [1, 0, 0]", "axis = [0, 1, 0]"), ("rk4", "radau"), ('["q", "v"', '["v", "q"'))}
    assert len(changed | {own}) == 7


# plots

def test_a_plot_has_a_line_for_each_column_and_precision(swings, tmp_path):
    path = tmp_path / "out.svg"
    plot([x.recording for x in swings], path)
    drawn = [x.get("id") for x in ElementTree.parse(path).iter() if x.get("id")]
    columns = [c for c in swings[0].recording.columns if swings[0].recorded[c.name].any()]
    assert len(columns) > 4
    for column in columns:
        assert [drawn.count(f"{column.name}{x}") for x in ("", " single")] == [1, 1], column.name
    plot([x.recording for x in swings], tmp_path / "out.png")
    assert (tmp_path / "out.png").read_bytes().startswith(b"\x89PNG")
