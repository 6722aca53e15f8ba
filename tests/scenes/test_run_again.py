"""A run is reproducible from its provenance: `again` makes the same bytes of a recording and its
scene."""

import json
import re

import numpy as np
import pytest

from coscrew_codegen import Controller, again, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.simulation import SimulateError
from tests.support.scenes.swing import SWING
from tests.support.scenes.tumbling import TUMBLING


def law(t, q, v):
    return -3 * q - v + np.sin(40 * t)


SPUN = [0.1, -0.2, 0.3, 0.1, 0.7, -0.3, 0.6403124237432849, 2.1]  # its norm is 1 within u
ASKED = {
    "as the scene says": ("swing", {}),
    "what a recording shows in few digits": ("swing", {
        "step": 1 / 1431, "every": 1 / 71, "until": 2 / 7, "record": ["energy.total", "a"]}),
    "parameters and start": ("swing", {
        "p": {"bob.mass": 1.1}, "q0": [1 / 3], "v0": [-2 / 7], "until": 0.2}),
    "whole numbers": ("swing", {"until": 1, "every": np.int64(1), "step": np.float32(0.01)}),
    "another integrator": ("tumbling", {"integrator": "rk4", "until": 0.2}),
    "a floating base": ("tumbling", {"q0": SPUN, "until": 0.3, "step": 7e-4}),
    "the integrator of SciPy": ("swing", {"integrator": "radau", "until": 0.1}),
    "a controller": ("swing", {"controller": Controller(law, 7), "until": 0.2, "record": ["a"]}),
    "a run that stops": ("swing", {"v0": [1e20], "until": 0.1}),
}
BOTH = pytest.mark.parametrize("precision", ("double", "single"))


@pytest.fixture(scope="module")
def scenes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("again")
    for name, text in (("swing", SWING), ("tumbling", TUMBLING)):
        (folder / f"{name}.toml").write_text(text)
    return folder


def same_bytes(path, first, folder, ending=".csv", controller=None):
    """Asserts that `first` and the repeated run of its recording write the same bytes."""
    one, other = folder / f"first{ending}", folder / f"again{ending}"
    first.write(one)
    again(path, one, controller=controller).write(other)
    assert other.read_bytes() == one.read_bytes()


@BOTH
@pytest.mark.parametrize("name", ASKED)
@pytest.mark.filterwarnings("ignore:the run stopped")
def test_a_recording_and_its_scene_make_the_same_bytes(scenes, tmp_path, name, precision):
    scene, requested = ASKED[name]
    path = scenes / f"{scene}.toml"
    first = run(path, precision=precision, **requested)
    same_bytes(path, first, tmp_path, controller=requested.get("controller"))
    twice = again(path, first, controller=requested.get("controller"))
    assert twice.q.tobytes() == first.q.tobytes() and twice.provenance == first.provenance


@BOTH
@pytest.mark.parametrize("controller", (None, Controller(law, 7)))
@pytest.mark.parametrize("scene", ("swing", "tumbling"))
def test_so_does_that_of_a_run_that_went_on(scenes, tmp_path, scene, controller, precision):
    """Without the recording from which it went on; in the phase of its controller."""
    if scene == "tumbling":
        controller = None
    path = scenes / f"{scene}.toml"
    given = {} if scene == "tumbling" else {"p": {"bob.mass": 1.1}}
    first = run(path, until=0.15, precision=precision, controller=controller, **given)
    onward = run(path, start=first, until=0.2, precision=precision, controller=controller,
                 step=7e-4)
    assert dict(onward.provenance)["start"] == dict(first.provenance)["end"]
    same_bytes(path, onward, tmp_path, controller=controller)


@pytest.mark.parametrize("ending", (".csv", ".npz", ".parquet"))
def test_so_does_every_file_of_the_command(scenes, tmp_path, capsys, ending):
    """Each file of runs in both precisions does, too."""
    path, both = scenes / "swing.toml", tmp_path / f"both{ending}"
    assert main(["simulate", str(path), "--until", "0.1", "--step", "0.0007", "--set",
                 "bob.mass=1.1", "--precision", "both", "--output", str(both)]) == 0
    for name in (both, tmp_path / f"both.single{ending}"):
        again(path, name).write(tmp_path / f"again{ending}")
        assert (tmp_path / f"again{ending}").read_bytes() == name.read_bytes()
        assert main(["simulate", str(path), "--again", str(name), "--output",
                     str(tmp_path / f"command{ending}")]) == 0
        assert (tmp_path / f"command{ending}").read_bytes() == name.read_bytes()


def test_the_command_refuses_other_settings_and_runs_with_a_controller(scenes, tmp_path, capsys):
    path, name = scenes / "swing.toml", tmp_path / "driven.csv"
    run(path, until=0.05, record=["a"], controller=law).write(name)
    for requested, message in (((), "again: controller: wanted function law, every step, sets"),
                               (("--until", "1"), "has all settings; wanted no --until"),
                               (("--set", "bob.mass=1"), "has all settings; wanted no --set")):
        assert main(["simulate", str(path), "--again", str(name), *requested]) == 2
        assert message in capsys.readouterr().err
    run(path, until=0.05, record=["a"]).write(name)
    assert main(["simulate", str(path), "--again", str(name), "--output", str(name)]) == 0


@pytest.mark.parametrize("controller", (None, Controller(law, 7)))
def test_a_batch_has_the_same_bits_and_tells_a_hash_of_its_start(scenes, controller):
    path, requested = scenes / "swing.toml", {"until": 0.1, "controller": controller}
    given = {"p": {"bob.mass": [1, 2, 3]}, "q0": [[0.1], [0.2], [0.3]]}
    first = run(path, **given, **requested)
    other = run(path, **{**given, "v0": [1e-9]}, **requested)
    twice = again(path, first, controller=controller)
    assert twice.recording.values.tobytes() == first.recording.values.tobytes()
    assert twice.provenance == first.provenance
    messages, others = (json.loads(dict(x.provenance)["start"]) for x in (first, other))
    assert messages["members"] == others["members"] == 3 and messages["sha256"] != others["sha256"]


def test_a_batch_s_table_holds_its_start(scenes):
    """Parameters and states that xarray keeps make the batch again."""
    path = scenes / "swing.toml"
    p, q0 = {"bob.mass": np.array([1.1, 2, 3])}, np.array([[1 / 3], [0.2], [0.3]])
    first = run(path, p=p, q0=q0, until=0.1, precision="single")
    data = first.to_xarray()
    result = run(path, p={"bob.mass": data["p.bob.mass"].values}, until=0.1, precision="single",
                 q0=data["q0.pivot"].values[:, None], v0=data["v0.pivot"].values[:, None])
    assert result.recording.values.tobytes() == first.recording.values.tobytes()
    assert result.provenance == first.provenance


@BOTH
def test_a_state_of_a_run_is_a_start_to_the_bit(scenes, precision):
    """Quaternions, too, are not divided by their norm once more."""
    path, draw = scenes / "tumbling.toml", np.random.default_rng(3)
    q0 = draw.normal(size=(200, 8))
    q0[:, 3:7] /= np.linalg.norm(q0[:, 3:7], axis=-1, keepdims=True)
    first = run(path, q0=q0, until=0.01, precision=precision)
    for q in (first.q[:, 0], first.q[:, -1]):
        result = run(path, q0=q, until=0.01, precision=precision)
        assert result.q[:, 0].tobytes() == q.tobytes()
    data = first.to_xarray()
    kept = np.stack([data[x].values for x in data.coords if x.startswith("q0.")], -1)
    assert kept.tobytes() == first.q[:, 0].tobytes()


def test_provenance_tells_the_controller(scenes):
    path = scenes / "swing.toml"
    origin = dict(run(path, until=0.01, controller=Controller(law, 7)).provenance)["controller"]
    assert origin.startswith(
        "function law, every 7 steps, sets actuator.pivot.torque, source sha256")
    class Law:
        def __call__(self, t, q, v):
            return 0 * q

    objects = dict(run(path, until=0.01, controller=Law()).provenance)["controller"]
    assert "function Law, every step" in objects and "source sha256" in objects
    wanted = dict(run(path, until=0.01, controller=law).provenance)["controller"]
    assert wanted == origin.replace("every 7 steps", "every step")


@pytest.mark.filterwarnings("error")
def test_another_scene_controller_or_version_is_refused(scenes, tmp_path):
    path, by = scenes / "swing.toml", Controller(law, 7)
    run(path, until=0.05).write(tmp_path / "free.csv")
    run(path, until=0.05, controller=by).write(tmp_path / "driven.csv")
    (tmp_path / "other.toml").write_text(SWING.replace("damping = 0.1", "damping = 0.2"))
    for scene, name, controller, message in (
            (tmp_path / "other.toml", "free.csv", None, "of another scene than other, or"),
            (path, "driven.csv", None, "controller: wanted function law, every 7 .*; got none"),
            (path, "driven.csv", Controller(law, 8), "got function law, every 8 steps"),
            (path, "driven.csv", Controller(lambda t, q, v: 0, 7), "got function .*<lambda>"),
            (path, "free.csv", by, "controller: wanted none; got function law")):
        with pytest.raises(SimulateError, match=f"again: .*{message}"):
            again(scene, tmp_path / name, controller=controller)
    text = (tmp_path / "free.csv").read_text()
    for name, broken, message in (
            ("a.csv", text.replace("# start: ", "# tart: "), "does not contain the start"),
            ("b.csv", text.replace('"until": 0.05', '"until": '), "settings are not as coscrew"),
            ("c.csv", text.replace('"steps": 0', '"steps": -1'), "its start is not as coscrew"),
            ("d.csv", "x,y\n1,2\n", "no recording"), ("e.txt", "x", "wanted a recording, .csv")):
        (tmp_path / name).write_text(broken)
        with pytest.raises(SimulateError, match=f"again: .*{message}"):
            again(path, tmp_path / name)
    with pytest.raises(TypeError, match="again: wanted the path of a recording, or a Result"):
        again(path, 3)
    (tmp_path / "old.csv").write_text(text.replace("# coscrew: ", "# coscrew: 0.1.9 or "))
    with pytest.warns(RuntimeWarning, match="the recording is of coscrew 0.1.9 or"):
        again(path, tmp_path / "old.csv")


@pytest.mark.parametrize("key, value, wanted", (
    ("until", "true", "until: wanted a number of seconds; got True"),
    ("until", '"0.05"', "until: wanted a number of seconds; got '0.05'"),
    ("step", "[0.001]", r"step: wanted a number of seconds; got \[0.001\]"),
    ("every", "null", "every: wanted a number of seconds; got None"),
    ("integrator", "1", "integrator: 1; wanted one of leapfrog, .*dop853$"),
    ("integrator", '"rk5"', "integrator: 'rk5'; wanted one of .*; did you mean 'rk4'"),
    ("record", '"q"', "record: wanted a list of names, as .*; got 'q'"),
    ("record", "[1]", r"record: wanted a list of names, as .*; got \[1\]"),
    ("record", "[]", r'record: an empty list; wanted quantities, as \["q", "v"\]')))
def test_settings_changed_by_hand_are_refused(scenes, tmp_path, key, value, wanted):
    path, name = scenes / "swing.toml", tmp_path / "changed.csv"
    run(path, until=0.05).write(name)
    text = name.read_text()
    old = json.dumps(json.loads(text.partition("# run: ")[2].partition("\n")[0])[key])
    name.write_text(text.replace(f'"{key}": {old}', f'"{key}": {value}', 1))
    with pytest.raises(SimulateError, match=f"again: .*changed.csv: {wanted}"):
        again(path, name)


def test_refusals_show_no_whole_hash(scenes, tmp_path):
    path, by = scenes / "swing.toml", Controller(law, 7)
    first = run(path, until=0.05, controller=by)
    (tmp_path / "other.toml").write_text(SWING.replace("damping = 0.1", "damping = 0.2"))
    for scene, controller in ((path, Controller(lambda t, q, v: 0 * q)), (tmp_path / "other.toml",
                                                                          by)):
        with pytest.raises(SimulateError) as refused:
            again(scene, first, controller=controller)
        assert not re.search("[0-9a-f]{9}", str(refused.value)), refused.value
