"""Controllers: in C they are called by compiled steps, with the bits of calls from Python; returned
values are checked; exceptions pass with time and step."""

import ctypes

import numpy as np
import pytest

from coscrew_codegen import Controller, load_scene, run
from coscrew_codegen.runtime import lanes
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.system import System
from tests.support.compiled.c_harness import run as command
from tests.support.scenes.swing import SWING
from tests.support.scenes.tumbling import TUMBLING

SCENES = {
    "swing": SWING,
    "gust": SWING + '[effects.wrench.bob]\nforce = ["5*sin(9*t)", 0, 0]\n',
    "tumbling": 'runtime = ["actuator.elbow.torque"]' + TUMBLING.replace("[effects.gravity]", """
[effects.gravity]
[effects.actuator.elbow]
kind = "torque"
torque = 0
"""),
}
LAW_IN_C = """#include <math.h>
void law{f}(double t, const {real} *q, const {real} *v, {real} *u, void *context) {{
  {real} *last = ({real} *)q;
  while (last < q + {nq}) *last++ += 1; /* copies: this must not matter */
  if (context) ++*(long *)context;
  u[0] = ({real})(u[0] / 2 - 3 * (q[{nq} - 1] - 1) - v[{nv} - 1] + sin(40 * t));
  if (q[0] > 5) u[0] = ({real})(t > 0.05 ? NAN : 0);
}}
"""
LAW = ctypes.CFUNCTYPE(None, ctypes.c_double, *[ctypes.POINTER(ctypes.c_double)] * 3,
                       ctypes.c_void_p)
BOTH = pytest.mark.parametrize("precision", ("double", "single"))


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Files of scenes, and functions in C by scene and precision."""
    folder, laws = tmp_path_factory.mktemp("driven"), {}
    for name, text in SCENES.items():
        (folder / f"{name}.toml").write_text(text)
        size = {"nq": 1, "nv": 1} if name != "tumbling" else {"nq": 8, "nv": 7}
        (folder / f"{name}.c").write_text("\n".join(LAW_IN_C.format(real=real, f=f, **size) for
                                                    real, f in (("double", ""), ("float", "f"))))
        command(("gcc", "-O1", "-shared", "-fPIC", folder / f"{name}.c", "-o",
                 folder / f"{name}.so", "-lm"))
        library = ctypes.CDLL(str(folder / f"{name}.so"))
        laws |= {(name, "double"): library.law, (name, "single"): library.lawf}
    return folder, laws


def both_ways(monkeypatch, path, controller, **requested):
    """The run with calls by compiled steps and by Python, which have the same bits."""
    result = run(path, controller=controller, **requested)
    with monkeypatch.context() as patched:
        patched.setattr(System, "driver", lambda self, name: None)
        wanted = run(path, controller=controller, **requested)
    for name in ("q", "v", "held"):
        one, other = getattr(result.trajectory, name), getattr(wanted.trajectory, name)
        assert one.tobytes() == other.tobytes(), name
    assert result.failed == wanted.failed and result.provenance == wanted.provenance
    return result


@BOTH
@pytest.mark.parametrize("steps", (1, 7, 1000))
@pytest.mark.parametrize("scene", SCENES)
def test_compiled_steps_call_a_controller_in_c(made, monkeypatch, scene, steps, precision):
    folder, laws = made
    calls = ctypes.c_long(0)
    by = Controller(laws[scene, precision], steps, context=ctypes.addressof(calls))
    result = both_ways(monkeypatch, folder / f"{scene}.toml", by, precision=precision, until=0.2,
                       step=7e-4, every=0.05)
    assert result.trajectory.steps == 4 * 72
    assert calls.value == 2 * (1 + 4 * 72 // steps)  # both ways, and once more at the end


@BOTH
@pytest.mark.parametrize("scene", SCENES)
def test_for_each_member_of_a_batch_also_in_lanes(made, monkeypatch, scene, precision):
    folder, laws = made
    path, kernels = folder / f"{scene}.toml", load_scene(folder / f"{scene}.toml")
    q0 = np.stack([kernels.neutral_q] * 5)
    q0[:, -1], requested = np.linspace(-1, 1, 5), {"precision": precision, "until": 0.1}
    by = Controller(laws[scene, precision], 3)
    alone = [run(path, q0=x, controller=by, **requested) for x in q0]
    for pays in (10**9, 1):
        monkeypatch.setattr(lanes, "PAYS", pays)
        many = both_ways(monkeypatch, kernels, by, q0=q0, **requested)
        for k, one in enumerate(alone):
            assert many.q[k].tobytes() == one.q.tobytes()
            assert many.trajectory.held[k].tobytes() == one.trajectory.held.tobytes()


@BOTH
@pytest.mark.filterwarnings("ignore:swing runs in pure NumPy")
def test_without_a_compiler_too(made, monkeypatch, precision):
    folder, laws = made
    requested = {"precision": precision, "until": 0.03, "q0": [[0.1], [0.2]],
                 "controller": Controller(laws["swing", precision], 7)}
    wanted = run(folder / "swing.toml", **requested)
    monkeypatch.setenv("CC", "no-compiler")
    result = run(folder / "swing.toml", **requested)
    assert dict(result.provenance)["compiler"] == "none: NumPy"
    assert result.q.tobytes() == wanted.q.tobytes()
    assert result.trajectory.held.tobytes() == wanted.trajectory.held.tobytes()


def test_in_the_order_of_time_then_of_members(made, monkeypatch):
    folder, _ = made
    calls = []

    @LAW
    def law(t, q, v, u, context):
        calls.append((t, q[0]))
        u[0] = -q[0]

    both_ways(monkeypatch, folder / "gust.toml", Controller(law, 3), until=0.02,
              q0=[[0.1], [0.2], [0.3]])
    half = len(calls) // 2
    assert half == 3 * 7 and calls[:half] == calls[half:]
    assert [t for t, _ in calls[:half]] == [0.003 * k if k < 4 else 0.01 + (3 * k - 10) * 0.001
                                            for k in range(7) for _ in range(3)]


def test_by_hand(made):
    """The run equals steps of load_scene's functions with the value given to each."""
    folder, laws = made
    its = load_scene(folder / "swing.toml").double
    p, q, v = np.array([2.0, 0]), np.array([0.5]), np.array([0.0])
    for k in range(50):
        t = 0.01 * (k // 10) + k % 10 * 0.001
        p[1] = p[1] / 2 - 3 * q[0] - v[0] + np.sin(40 * t)
        q, v = its.step_leapfrog(1e-3, p, q, v)
    result = run(folder / "swing.toml", controller=laws["swing", "double"], until=0.05)
    assert result.q[-1].tobytes() == q.tobytes() and result.v[-1].tobytes() == v.tobytes()


@pytest.mark.parametrize("steps", (1, 3))
def test_what_is_not_finite_stops_its_member(made, monkeypatch, steps):
    folder, laws = made
    by = Controller(laws["swing", "double"], steps)
    many = both_ways(monkeypatch, folder / "swing.toml", by, q0=[[0.1], [7], [0.3], [9]], until=0.1)
    at = 0.05 + 0.001
    assert [(x.member, x.t, x.joint) for x in many.failed] == [(1, at, "pivot"), (3, at, "pivot")]
    assert many.failed[0].cause == ("the controller returned nan for actuator.pivot.torque at "
                                    "t = 0.051 s")
    assert np.isnan(many.q[[1, 3], 6:]).all() and np.isfinite(many.q[[0, 2]]).all()
    with pytest.warns(RuntimeWarning, match="stopped: the controller returned nan for actuator"):
        one = both_ways(monkeypatch, folder / "swing.toml", by, q0=[7], until=0.1)
    assert one.failed[0].t == at and one.t[-1] == 0.05


def test_members_stop_for_their_own_reasons_in_one_interval(made):
    """One by its controller's value, one since its torque takes it beyond the largest number."""
    path = made[0] / "swing.toml"

    def law(t, q, v):
        result = np.zeros_like(q)
        if t > 0.0125:
            result[q < 0.15] = np.nan
            result[q > 0.25] = 1e308
        return result

    many = run(path, q0=[[0.1], [0.2], [0.3]], v0=[0.1], controller=law, until=0.1)
    with pytest.warns(RuntimeWarning, match="the run stopped"):
        alone = [run(path, q0=[x], v0=[0.1], controller=law, until=0.1).failed[0]
                 for x in (0.1, 0.3)]
    assert [(x.t, x.joint, x.cause) for x in many.failed] == [
        (x.t, x.joint, x.cause) for x in alone]
    assert [x.member for x in many.failed] == [0, 2] and "returned nan" in many.failed[0].cause


def test_the_first_sample_has_what_the_controller_set(made):
    folder, _ = made
    result = run(folder / "swing.toml", controller=lambda t, q, v: [4.0], until=0.02, record=["a"])
    held = run(folder / "swing.toml", p={"actuator.pivot.torque": 4}, until=0.02, record=["a"])
    assert result.trajectory.held[:, 1].tolist() == [4, 4, 4]
    assert result.recording.values.tobytes() == held.recording.values.tobytes()


# In Python

@pytest.mark.parametrize("steps, t, step", ((1, 0.023, 23), (10, 0.03, 30)))
def test_what_it_raises_passes_with_time_and_step(made, steps, t, step):
    def law(t, q, v):
        if t > 0.0225:
            raise ZeroDivisionError("of mine")
        return 0 * q

    with pytest.raises(ZeroDivisionError, match="of mine") as raised:
        run(made[0] / "swing.toml", controller=Controller(law, steps), until=0.1)
    assert raised.value.__notes__ == [
        f"the controller was called at t = {t:g} s, before step {step}"]


def test_an_interrupt_in_it_is_an_interrupt(made):
    def law(t, q, v):
        if t > 0.05:
            raise KeyboardInterrupt
        return 0 * q

    with pytest.raises(KeyboardInterrupt):
        run(made[0] / "swing.toml", controller=law, until=0.1)


@pytest.mark.parametrize("returned, shown", (
    ([1, 2], r"\[1, 2\]"), ([[1.0]], r"\[\[1\.0\]\]"), ("1.5", "'1.5'"), (None, "None"),
    (1j, "1j"), (np.ones(1, bool), r"array\(\[ True\]\)"), ([[1], [2, 3]], r"\[\[1\], \[2, 3\]\]"),
    (np.zeros((0,)), r"array\(\[\]")))
def test_what_is_not_as_many_real_numbers_is_refused(made, returned, shown):
    message = f"controller: wanted 1 numbers, of actuator.pivot.torque; got {shown}"
    with pytest.raises(SimulateError, match=message):
        run(made[0] / "swing.toml", controller=lambda t, q, v: returned, until=0.1)


def test_of_a_batch_too(made):
    path, q0 = made[0] / "swing.toml", [[0.1], [0.2]]
    for returned in (3, [3], [[3], [3]], np.float32([[3], [3]])):
        many = run(path, q0=q0, controller=lambda t, q, v, x=returned: x, until=0.02)
        assert (many.trajectory.held[..., 1] == 3).all()
    for returned in ([3, 3], [[3, 3]], [[3], [3], [3]], [[[3], [3]]]):
        with pytest.raises(SimulateError, match="or a row of them for each of 2 members; got"):
            run(path, q0=q0, controller=lambda t, q, v, x=returned: x, until=0.02)


def test_it_may_keep_and_change_what_it_gets(made):
    kept = []

    def law(t, q, v):
        kept.append((q, v))
        result = -3 * q - v
        q += 100
        v *= 0
        return result

    path = made[0] / "swing.toml"
    wanted = run(path, controller=lambda t, q, v: -3 * q - v, until=0.05)
    assert run(path, controller=law, until=0.05).q.tobytes() == wanted.q.tobytes()
    assert [float(q[0]) for q, _ in kept[::10]] == (wanted.q[:, 0] + 100).tolist()


def test_it_may_return_the_same_array_each_time(made):
    u = np.zeros(1)

    def law(t, q, v):
        u[:] = -3 * q - v
        return u

    path = made[0] / "swing.toml"
    result, wanted = (run(path, controller=Controller(x, 5), until=0.05)
                      for x in (law, lambda t, q, v: -3 * q - v))
    assert result.trajectory.held.tobytes() == wanted.trajectory.held.tobytes()


@BOTH
def test_functions_of_the_other_precision_are_refused(made, precision):
    """They are refused where ctypes knows their type: they would write beyond the end."""
    folder, _ = made
    real = {"double": ctypes.c_float, "single": ctypes.c_double}[precision]
    law = ctypes.CFUNCTYPE(None, ctypes.c_double, *[ctypes.POINTER(real)] * 3, ctypes.c_void_p)
    with pytest.raises(SimulateError, match=f"a function in C of {real.__name__}; wanted c_"):
        run(folder / "swing.toml", controller=law(lambda *x: None), precision=precision, until=0.1)
