"""A run that goes on from the end of another has the bits of one long run."""

import json

import numpy as np
import pytest

from coscrew_codegen import Controller, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.simulate import SimulateError
from tests.support.scenes.swing import SWING

INTEGRATORS = ("leapfrog", "rk4", "semi-implicit-euler", "linear-implicit-euler")
TUMBLING = """
[bodies]
hull = { mass = 3, com = [0.1, 0, 0.02], inertia = [0.3, 0.2, 0.4] }
arm = { mass = 1, com = [0, 0.3, 0], inertia = [0.05, 0.01, 0.05] }
[joints]
base = { type = "free", child = "hull" }
elbow = { type = "continuous", parent = "hull", child = "arm", axis = [1, 0, 0] }
[effects.gravity]
[start.v]
base = [0.1, 0.2, 0.3, 1.5, -0.7, 2.1]
elbow = 0.4
"""
ENDINGS = (".csv", ".npz", ".parquet")


@pytest.fixture(scope="module")
def scenes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("onward")
    for name, text in (("swing", SWING), ("tumbling", TUMBLING)):
        (folder / f"{name}.toml").write_text(text)
    return folder


def same(onward, whole):
    """The samples of `onward` are the last of `whole`, to the bit."""
    n = len(onward.t)
    for name in ("t", "q", "v"):
        last = getattr(whole, name)[-n:] if name == "t" else getattr(whole, name)[..., -n:, :]
        assert getattr(onward, name).tobytes() == last.tobytes(), name


@pytest.mark.parametrize("precision", ("double", "single"))
@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize("scene", ("swing", "tumbling"))
def test_from_a_result_and_from_a_recording(scenes, tmp_path, scene, integrator, precision):
    asked = {"integrator": integrator, "precision": precision, "step": 7e-4}
    path = scenes / f"{scene}.toml"
    first, whole = (run(path, until=end, **asked) for end in (0.3, 0.6))
    same(run(path, start=first, until=0.6, **asked), whole)
    for ending in ENDINGS:
        first.write(tmp_path / f"first{ending}")
        same(run(path, start=tmp_path / f"first{ending}", until=0.6, **asked), whole)


def test_again_and_again(scenes):
    path = scenes / "tumbling.toml"
    whole, onward = run(path, until=0.5), run(path, until=0.1)
    for end in (0.2, 0.3, 0.4, 0.5):
        onward = run(path, start=onward, until=end)
    same(onward, whole)
    assert dict(onward.provenance)["end"] == dict(whole.provenance)["end"]


def test_the_command_writes_the_last_lines(scenes, tmp_path, capsys):
    path, first = str(scenes / "swing.toml"), tmp_path / "first.csv"
    asked = ["--set", "bob.mass=1.1", "--output"]
    assert main(["simulate", path, "--until", "0.2", *asked, str(first)]) == 0
    assert main(["simulate", path, "--until", "0.4", *asked, str(tmp_path / "whole.csv")]) == 0
    assert main(["simulate", path, "--until", "0.4", "--start", str(first), "--output",
                 str(tmp_path / "onward.csv")]) == 0
    assert "0.2 to 0.4 s" in capsys.readouterr().out

    def lines(name):
        return [x for x in (tmp_path / name).read_text().splitlines() if not x.startswith("#")]

    onward = lines("onward.csv")[1:]
    assert len(onward) == 21 and onward == lines("whole.csv")[-21:]
    end = json.loads(next(x for x in first.read_text().splitlines() if x.startswith("# end: "))[7:])
    assert (end["t"], end["steps"], end["p"]) == (0.2, 200, [1.1, 0])


@pytest.mark.parametrize("every", (1, 7))
def test_batches_and_controllers_keep_their_phase(scenes, every):
    law = Controller(lambda t, q, v: -3 * q - v + np.sin(40 * t), every)
    path, asked = scenes / "swing.toml", {"controller": law}
    q0, p = [[0.1], [0.5], [2.0]], {"bob.mass": [1.0, 2.0, 3.0]}
    first, whole = (run(path, q0=q0, p=p, until=end, **asked) for end in (0.1, 0.2))
    onward = run(path, start=first, until=0.2, **asked)
    same(onward, whole)
    same(run(path, start=run(path, start=first, until=0.15, **asked), until=0.2, **asked),
         run(path, q0=q0, p=p, until=0.2, **asked))
    assert onward.trajectory.held.tobytes() == whole.trajectory.held[:, -11:].tobytes()
    assert "every" in dict(onward.provenance)["controller"]


def test_parameters_hold_unless_others_are_given(scenes):
    path = scenes / "swing.toml"
    first = run(path, p={"bob.mass": 1.3}, until=0.1)
    assert run(path, start=first, until=0.2).system.p[0] == 1.3
    assert run(path, start=first, p={"bob.mass": 4}, until=0.2).system.p[0] == 4


@pytest.mark.parametrize("asked, said", (
    ({"until": 0.1}, "until: wanted more than 0.1 s"),
    ({"until": 1, "q0": [1]}, "got both"),
    ({"until": 1, "precision": "single"}, "a run in double precision; wanted single"),
    ({"until": 1, "integrator": "radau"}, "wanted an emitted integrator")))
def test_what_cannot_go_on_is_refused(scenes, asked, said):
    path = scenes / "swing.toml"
    with pytest.raises(SimulateError, match=said):
        run(path, start=run(path, until=0.1), **asked)


def test_momentum_that_was_not_kept_is_not_made_up(scenes):
    """leapfrog corrects floating bases to the momentum at t = 0, which rk4 does not tell."""
    path = scenes / "tumbling.toml"
    with pytest.raises(SimulateError, match="wanted the integrator of that run"):
        run(path, start=run(path, until=0.1, integrator="rk4"), integrator="leapfrog", until=0.2)


def test_recordings_that_tell_no_end_are_refused(scenes, tmp_path):
    path = scenes / "swing.toml"
    run(path, until=0.1).write(tmp_path / "first.csv")
    text = (tmp_path / "first.csv").read_text()
    for name, broken, said in (
            ("a.csv", text.replace("# end: ", "# bend: "), "does not tell the end"),
            ("b.csv", text.replace('"t": 0.1', '"t": NaN'), "not as coscrew writes it"),
            ("c.csv", text.replace('"q": [', '"q": [1.0, '), "another scene: 2 coordinates"),
            ("d.csv", "x,y\n1,2\n", "no recording"), ("e.npz", "x", "no recording"),
            ("f.txt", "x", "wanted a recording, .csv")):
        (tmp_path / name).write_text(broken)
        with pytest.raises(SimulateError, match=said):
            run(path, start=tmp_path / name, until=1)
    with pytest.raises(SimulateError, match="cannot read"):
        run(path, start=tmp_path / "missing.csv", until=1)
    with pytest.raises(TypeError, match="start: wanted a Result or the path"):
        run(path, start=3, until=1)
    stopped = run(path, v0=[1e308], until=0.1)
    with pytest.raises(SimulateError, match="wanted one that reached its end"):
        run(path, start=stopped, until=1)


def test_the_recording_of_a_scene_that_changed_is_told(scenes, tmp_path):
    first = run(scenes / "swing.toml", until=0.1)
    (tmp_path / "other.toml").write_text(SWING.replace("damping = 0.1", "damping = 0.2"))
    with pytest.warns(RuntimeWarning, match="another scene, or of one that has changed"):
        run(tmp_path / "other.toml", start=first, until=0.2)
