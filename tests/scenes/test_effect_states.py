"""States of effects move with steps, stand at the end of q, and are recorded, started and continued
as coordinates are; stiction holds for ever, where dry friction without states creeps."""

import numpy as np
import pytest

from coscrew_codegen import again, load_scene, run
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.scene_texts import SLIDER


@pytest.fixture
def scene(tmp_path):
    def made(more="", text=SLIDER):
        path = tmp_path / "slider.toml"
        path.write_text(text + more)
        return path
    return made


def test_states_are_the_end_of_q(scene):
    its = load_scene(scene()).interface
    assert (its.nq, its.nv) == (4, 2)
    assert its.states == (("x.stiction.slide", "m"), ("x.stiction.hinge", "rad"))
    assert its.neutral == (0, 0, 0, 0)


def test_they_are_recorded_with_units(scene):
    result = run(scene(), until=0.1)
    columns = {x.name: x.unit for x in result.recording.columns}
    assert columns["x.stiction.slide"] == "m" and columns["x.stiction.hinge"] == "rad"
    assert np.array_equal(result.recorded["x.stiction.slide"], result.q[:, 2])


@pytest.mark.parametrize("precision, most", [("double", 1e-12), ("single", 1e-6)])
def test_it_holds_a_load_for_ever_whatever_shakes_it(scene, precision, most):
    """4.9 N at most, below the 5 N of break-away: after a start it stays where it is."""
    q = np.asarray(run(scene(), until=200, every=0.1, precision=precision).q, float)[:, 0]
    assert abs(q[-1] - q[10]) < most


def test_a_block_stops_where_its_energy_is_spent(scene):
    """m v²/(2 tau_c), less what the bristles yield.  A velocity is left that moves q by less than
    its rounding in a step."""
    text = SLIDER.replace("3 + 1.9*sin(20*pi*t)", "0*t").replace("tau_s = 5\n", "")
    result = run(scene("[start.v]\nslide = 2\n", text), until=2)
    way, mass = result.q[-1, 0], 2
    assert abs(way - mass * 2**2 / (2 * 4)) < 1e-4
    assert abs(result.v[-1, 0]) * 1e-3 < np.spacing(way)
    assert way == result.q[-50, 0]


def test_friction_is_the_level_while_it_slides(scene):
    text = SLIDER.replace("3 + 1.9*sin(20*pi*t)", "10 + 0*t").replace("tau_s = 5\n", "")
    result = run(scene("", text), until=1)
    a = (result.v[-1, 0] - result.v[50, 0]) / (result.t[-1] - result.t[50])
    assert a == pytest.approx((10 - 4) / 2, rel=2e-4)


def test_they_start_where_the_file_says(scene):
    result = run(scene('[start.x]\n"stiction.slide" = 1e-6\n'), until=0.01)
    assert result.q[0].tolist() == [0, 0, 1e-6, 0]


@pytest.mark.parametrize("precision", ["double", "single"])
def test_runs_go_on_to_the_bit(scene, tmp_path, precision):
    path = scene()
    first, whole = (run(path, until=end, precision=precision) for end in (0.3, 0.6))
    first.write(tmp_path / "first.csv")
    onward = run(path, start=tmp_path / "first.csv", until=0.6, precision=precision)
    assert onward.q.tobytes() == whole.q[-len(onward.t):].tobytes()
    whole.write(tmp_path / "whole.csv")
    repeated = again(path, tmp_path / "whole.csv")
    assert repeated.q.tobytes() == whole.q.tobytes()


def test_batches_and_numpy_have_the_bits_of_one_state(scene, monkeypatch):
    path = scene()
    q0 = np.linspace(0, 1e-5, 5)[:, None] * [0, 0, 1, 0]
    v0 = np.linspace(0, 0.1, 5)[:, None] * [1, -1]
    many = run(path, until=0.2, q0=q0, v0=v0)
    for n in range(5):
        one = run(path, until=0.2, q0=q0[n], v0=v0[n])
        assert one.q.tobytes() == many.q[n].tobytes()
    compiled = load_scene(path)
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.warns(RuntimeWarning):
        without = load_scene(path)
    ends = []
    for kernels in (compiled.double, without.double):
        q, v = q0[3], v0[3]
        for k in range(100):
            q, v = kernels.step_leapfrog(k * 1e-3, 1e-3, [5e5], q, v)
        ends.append((*q, *v))
    assert ends[0] == ends[1]


def test_derivatives_of_dynamics_hold_them(scene):
    """The slope of a bristle's force by v, with x held: d of the effect."""
    functions = load_scene(scene(), functions=["forward_dynamics_derivatives"]).double
    p = [5e5]
    _, by_v, by_tau = functions.forward_dynamics_derivatives(
        0.0, p, np.zeros(4), np.zeros(2), np.zeros(2))
    assert np.allclose(by_v[0, 0], -1000 * by_tau[0, 0], rtol=1e-12)


def test_unknown_effects_in_start_are_refused_with_the_nearest(scene):
    with pytest.raises(SceneError, match="stiction.slide"):
        read_scene(scene('[start.x]\n"stiction.slid" = 1\n'))


def test_without_states_there_is_no_quantity_x(scene):
    text = SLIDER.replace("stiction", "coulomb").replace("tau_s = 5\nk = 5e5\nd = 1000", "eps = 1")
    text = text.replace("tau_c = 0.1", "tau_c = 0.1\neps = 1").replace(
        'runtime = ["coulomb.slide.k"]', "")
    with pytest.raises(SceneError, match="no effect of the scene has states"):
        read_scene(scene('[outputs]\nrecord = ["x"]\n', text))
