"""A run that continues another has the bits of one long run."""

import json
import re

import numpy as np
import pytest

from coscrew_codegen import Controller, again, load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.simulation import SimulateError
from tests.support.scenes.swing import SWING
from tests.support.scenes.tumbling import TUMBLING

INTEGRATORS = ("leapfrog", "rk4", "semi-implicit-euler", "linear-implicit-euler")
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
    requested = {"integrator": integrator, "precision": precision, "step": 7e-4}
    path = scenes / f"{scene}.toml"
    first, whole = (run(path, until=end, **requested) for end in (0.3, 0.6))
    same(run(path, start=first, until=0.6, **requested), whole)
    for ending in ENDINGS:
        first.write(tmp_path / f"first{ending}")
        same(run(path, start=tmp_path / f"first{ending}", until=0.6, **requested), whole)


def test_again_and_again(scenes):
    path = scenes / "tumbling.toml"
    whole, onward = run(path, until=0.5), run(path, until=0.1)
    for end in (0.2, 0.3, 0.4, 0.5):
        onward = run(path, start=onward, until=end)
    same(onward, whole)
    assert dict(onward.provenance)["end"] == dict(whole.provenance)["end"]


def test_the_command_writes_the_last_lines(scenes, tmp_path, capsys):
    path, first = str(scenes / "swing.toml"), tmp_path / "first.csv"
    requested = ["--set", "bob.mass=1.1", "--output"]
    assert main(["simulate", path, "--until", "0.2", *requested, str(first)]) == 0
    assert main(["simulate", path, "--until", "0.4", *requested, str(tmp_path / "whole.csv")]) == 0
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
    path, requested = scenes / "swing.toml", {"controller": law}
    q0, p = [[0.1], [0.5], [2.0]], {"bob.mass": [1.0, 2.0, 3.0]}
    first, whole = (run(path, q0=q0, p=p, until=end, **requested) for end in (0.1, 0.2))
    onward = run(path, start=first, until=0.2, **requested)
    same(onward, whole)
    same(run(path, start=run(path, start=first, until=0.15, **requested), until=0.2, **requested),
         run(path, q0=q0, p=p, until=0.2, **requested))
    assert onward.trajectory.held.tobytes() == whole.trajectory.held[:, -11:].tobytes()
    assert "every" in dict(onward.provenance)["controller"]


def test_parameters_hold_unless_others_are_given(scenes):
    path = scenes / "swing.toml"
    first = run(path, p={"bob.mass": 1.3}, until=0.1)
    assert run(path, start=first, until=0.2).system.p[0] == 1.3
    assert run(path, start=first, p={"bob.mass": 4}, until=0.2).system.p[0] == 4


def test_going_on_without_the_controller_is_told(scenes, tmp_path):
    path = scenes / "swing.toml"
    first = run(path, controller=Controller(lambda t, q, v: -3 * q), until=0.1)
    first.write(tmp_path / "first.csv")
    for start in (first, tmp_path / "first.csv"):
        with pytest.warns(RuntimeWarning, match="the run before had a controller .*lambda.* none"):
            run(path, start=start, until=0.2)


@pytest.mark.parametrize("requested, message", (
    ({"until": "1"}, "until: wanted a number of seconds; got '1'"),
    ({"until": 1, "step": True}, "step: wanted a number of seconds; got True"),
    ({"until": 0.1}, "until: wanted more than 0.1 s"),
    ({"until": 1, "q0": [1]}, "got both"),
    ({"until": 1, "precision": "single"}, "a run in double precision; wanted single"),
    ({"until": 1, "integrator": "radau"}, "wanted an emitted integrator")))
def test_what_cannot_go_on_is_refused(scenes, requested, message):
    path = scenes / "swing.toml"
    with pytest.raises(SimulateError, match=message):
        run(path, start=run(path, until=0.1), **requested)


def test_recordings_of_scenes_with_other_parameters_are_refused(scenes, tmp_path, capsys):
    """With fewer and with more, of this scene."""
    path, fewer = scenes / "swing.toml", tmp_path / "fewer.toml"
    fewer.write_text(SWING.replace('"bob.mass", ', ""))
    for scene, other, sizes in ((path, fewer, (1, 2)), (fewer, path, (2, 1))):
        run(other, until=0.05).write(tmp_path / "first.csv")
        message = (f"start: another scene: 1 coordinates, 1 velocities, {sizes[0]} parameters; "
                   f"wanted 1, 1, {sizes[1]}")
        for given in ({}, {"p": {"actuator.pivot.torque": 1}}):
            with pytest.raises(SimulateError, match=message):
                run(scene, start=tmp_path / "first.csv", until=1, **given)
        assert main(["simulate", str(scene), "--start", str(tmp_path / "first.csv"), "--set",
                     "actuator.pivot.torque=1"]) == 2
        assert message in capsys.readouterr().err


def test_settings_of_a_run_that_goes_on_are_refused_as_others_are(scenes, tmp_path, capsys):
    path, first = str(scenes / "swing.toml"), str(tmp_path / "first.csv")
    assert main(["simulate", path, "--until", "0.1", "--output", first]) == 0
    for setting, message in (
            ("bob.mas=1", "--set bob.mas: wanted a parameter that the scene lists"),
            ("bob.mass=-1", "--set bob.mass=-1: wanted a positive")):
        for onward in ((), ("--start", first)):
            assert main(["simulate", path, "--until", "0.2", "--set", setting, *onward]) == 2
            assert message in capsys.readouterr().err


def test_the_command_tells_how_many_steps_were_before(scenes, tmp_path, capsys):
    """A controller that is called every 7 steps is next called before the 161st, at t = 0.161."""
    path, names = scenes / "swing.toml", [tmp_path / f"{n}.csv" for n in range(2)]
    for name, until, onward in zip(names, ("0.1", "0.155"), ((), ("--start", str(names[0]))),
                                   strict=True):
        assert main(["simulate", str(path), "--until", until, "--output", str(name), *onward]) == 0
    calls = []

    def law(t, q, v):
        calls.append(t)
        return [3.0]

    result = run(path, start=names[1], controller=Controller(law, 7), until=0.2)
    assert calls == pytest.approx([0.161, 0.168, 0.175, 0.182, 0.189, 0.196], abs=1e-12)
    its, q, v = load_scene(path).double, np.array([0.5]), np.array([0.0])
    for k in range(200):
        q, v = its.step_leapfrog(1e-3, np.array([2, 3.0 if k >= 161 else 0]), q, v)
    assert result.q[-1].tobytes() == q.tobytes() and result.v[-1].tobytes() == v.tobytes()


@pytest.mark.parametrize("precision", ("double", "single"))
@pytest.mark.parametrize("controller", (None, Controller(lambda t, q, v: -3 * q, 7)))
def test_of_a_batch_the_members_that_did_not_fail_go_on(scenes, controller, precision):
    path, requested = scenes / "swing.toml", {"controller": controller, "precision": precision}
    huge = 1e200 if precision == "double" else 1e38
    given = {"v0": [[0], [huge], [1], [-huge]], "p": {"bob.mass": [1, 2, 3, 4]}}
    first, whole = (run(path, until=end, **given, **requested) for end in (0.1, 0.2))
    assert {x.member for x in first.failed} == {1, 3}
    onward = run(path, start=first, until=0.2, **requested)
    assert onward.failed == first.failed and np.isnan(onward.q[[1, 3]]).all()
    for k in (0, 2):
        assert onward.q[k].tobytes() == whole.q[k, -11:].tobytes()
        assert onward.v[k].tobytes() == whole.v[k, -11:].tobytes()
    twice = run(path, start=onward, until=0.3, **requested)
    assert twice.failed == first.failed and np.isfinite(twice.q[[0, 2]]).all()
    again_ = again(path, onward, controller=controller)
    assert again_.q.tobytes() == onward.q.tobytes() and again_.failed == first.failed
    assert again_.provenance == onward.provenance


def test_a_batch_fails_one_member_after_the_other(scenes):
    path = scenes / "swing.toml"
    first = run(path, v0=[[0], [1e200], [1]], until=0.1)
    onward = run(path, start=first, until=0.2, controller=lambda t, q, v: np.where(
        (t > 0.15) & (v > -0.9), np.nan, 0))
    assert [x.member for x in onward.failed] == [1, 2] and onward.failed[0] == first.failed[0]
    assert np.isnan(onward.q[:, -1, 0]).tolist() == [False, True, True]


def test_a_run_becomes_a_batch_that_goes_on(scenes, tmp_path):
    """By parameters; velocities do not jump, so that another mass has another momentum."""
    path = tmp_path / "tumbling.toml"
    path.write_text('runtime = ["arm.mass"]' + TUMBLING)
    one = run(path, until=0.1)
    many = run(path, start=one, until=0.2, p={"arm.mass": [1, 2]})
    result = run(path, start=many, until=0.3)
    whole = run(path, start=one, until=0.3, p={"arm.mass": [1, 2]})
    same(result, whole)
    assert not whole.failed and abs(np.diff(whole.v, axis=1)).max() < 0.11  # of gravity, 0.01 s
    assert whole.q[0].tobytes() == run(path, start=one, until=0.3).q.tobytes()
    heavy = run(path, start=one, until=0.3, p={"arm.mass": 2})
    assert whole.q[1].tobytes() == heavy.q.tobytes() == again(path, heavy).q.tobytes()


def test_momentum_that_was_not_kept_is_not_made_up(scenes):
    """leapfrog corrects floating bases to the momentum at t = 0, which rk4 does not tell."""
    path = scenes / "tumbling.toml"
    with pytest.raises(SimulateError, match="wanted the integrator of that run"):
        run(path, start=run(path, until=0.1, integrator="rk4"), integrator="leapfrog", until=0.2)


def test_recordings_that_tell_no_end_are_refused(scenes, tmp_path):
    path = scenes / "swing.toml"
    run(path, until=0.1).write(tmp_path / "first.csv")
    text = (tmp_path / "first.csv").read_text()
    for name, broken, message in (
            ("a.csv", text.replace("# end: ", "# bend: "), "does not contain the end"),
            ("b.csv", text.replace('"t": 0.1', '"t": NaN'), "not as coscrew writes it"),
            ("b1.csv", text.replace('"t": 0.1', f'"t": {10**400}'), "not as coscrew writes it"),
            ("b2.csv", re.sub(r'"steps": (\d+)', r'"steps": "\1"', text), "not as coscrew writes"),
            ("b3.csv", text.replace("# end: ", f"# end: {'[' * 100000}"), "not as coscrew writes"),
            ("c.csv", text.replace('"q": [', '"q": [1.0, '), "another scene: 2 coordinates"),
            ("d.csv", "x,y\n1,2\n", "no recording"), ("e.npz", "x", "no recording"),
            ("f.txt", "x", "wanted a recording, .csv")):
        (tmp_path / name).write_text(broken)
        with pytest.raises(SimulateError, match=message):
            run(path, start=tmp_path / name, until=1)
    with pytest.raises(SimulateError, match="cannot read"):
        run(path, start=tmp_path / "missing.csv", until=1)
    with pytest.raises(TypeError, match="start: wanted a Result or the path"):
        run(path, start=3, until=1)
    with pytest.warns(RuntimeWarning, match="the run stopped"):
        stopped = run(path, v0=[1e308], until=0.1)
    with pytest.raises(SimulateError, match="wanted one that reached its end"):
        run(path, start=stopped, until=1)
    with pytest.raises(SimulateError, match="wanted one that reached its end"):
        run(path, start=run(path, v0=[[1e308], [1e307]], until=0.1), until=1)


def test_the_recording_of_a_scene_that_changed_is_told(scenes, tmp_path):
    first = run(scenes / "swing.toml", until=0.1)
    (tmp_path / "other.toml").write_text(SWING.replace("damping = 0.1", "damping = 0.2"))
    with pytest.warns(RuntimeWarning, match="another scene, or of one that has changed"):
        run(tmp_path / "other.toml", start=first, until=0.2)
