"""run: runs from Python have the bits of `coscrew simulate`; members of a batch those of runs."""

import ctypes
import warnings

import numpy as np
import pytest

from coscrew_codegen import Controller, load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.simulation import SimulateError, api
from tests.support.scenes.swing import SWING

LAW = ctypes.CFUNCTYPE(None, ctypes.c_double, *[ctypes.POINTER(ctypes.c_double)] * 3,
                       ctypes.c_void_p)


@pytest.fixture(scope="module")
def swing(tmp_path_factory):
    path = tmp_path_factory.mktemp("run") / "swing.toml"
    path.write_text(SWING)
    return path


@pytest.mark.parametrize("precision", ("double", "single"))
def test_a_run_writes_the_bytes_of_the_command(swing, tmp_path, capsys, precision):
    requested = ["--until", "0.3", "--step", "0.0007", "--set", "bob.mass=1.1"]
    assert main(["simulate", str(swing), *requested, "--precision", precision, "--output",
                 str(tmp_path / "command.csv")]) == 0
    result = run(swing, until=0.3, step=0.0007, p={"bob.mass": 1.1}, precision=precision)
    result.write(tmp_path / "run.csv")
    assert (tmp_path / "run.csv").read_bytes() == (tmp_path / "command.csv").read_bytes()


@pytest.mark.parametrize("precision", ("double", "single"))
def test_members_of_a_batch_are_runs(swing, precision):
    """To the last bit, whatever has a leading axis."""
    mass, q0, v0 = np.array([2, 1, 0.3]), np.array([[0.5], [3.1], [-2]]), np.array([[0], [5], [9]])
    many = run(swing, p={"bob.mass": mass}, q0=q0, v0=v0, until=0.2, precision=precision)
    assert many.q.shape == (3, 21, 1) and not many.failed
    for k in range(3):
        one = run(swing, p=[mass[k], 0], q0=q0[k], v0=v0[k], until=0.2, precision=precision)
        assert many.q[k].tobytes() == one.q.tobytes()
        assert many.v[k].tobytes() == one.v.tobytes()
        for name, values in one.recorded.items():
            assert many.recorded[name][k].tobytes() == values.tobytes(), name


LIMITED = SWING + """
[effects.limit.pivot]
lower = -3
upper = 3
k = 1e5
"""


@pytest.mark.parametrize("q0, message", (([3.5], "starts at 3.5"), ([3.0], None),
                                         ([[0.0], [-4.0], [3.5]], "starts at -4, outside")))
def test_joints_that_start_outside_their_ranges_are_told(tmp_path, q0, message):
    path = tmp_path / "limited.toml"
    path.write_text(LIMITED)
    with warnings.catch_warnings(record=True) as result:
        warnings.simplefilter("always")
        run(path, q0=q0, until=0.01)
    words = [str(x.message) for x in result if "outside its range from -3 to 3" in str(x.message)]
    assert len(words) == (message is not None) and (not words or message in words[0])


@pytest.mark.parametrize("words", ({"functions": []}, {"tiers": ()}))
def test_empty_lists_select_nothing_silently(swing, words):
    with pytest.raises(ValueError, match=f"{next(iter(words))}: an empty list; wanted names"):
        load_scene(swing, **words)


def test_members_that_diverge_are_told_and_others_go_on(swing):
    many = run(swing, v0=[[0], [1e200], [1e308]], until=0.2)
    with pytest.warns(RuntimeWarning, match="the run stopped: energy is not finite at t = "):
        one = run(swing, v0=[1e308], until=0.2)
    assert [x.member for x in many.failed] in ([1, 2], [2, 1])
    of_last = next(x for x in many.failed if x.member == 2)
    messages = [(x.t, x.joint, x.cause.rpartition("; ")[0]) for x in (of_last, one.failed[0])]
    assert messages[0] == messages[1]  # remedies differ: those of batches are not tried
    assert many.q[0].tobytes() == run(swing, until=0.2).q.tobytes()
    for x in many.failed:
        assert np.isnan(many.q[x.member, many.t >= x.t]).all()


@pytest.mark.parametrize("every", (1, 7))
def test_a_controller_holds_its_torque_between_calls(swing, every):
    """The run equals steps by hand with that torque; in C and in Python, alone and in a batch."""
    from coscrew_codegen import load_scene

    def law(t, q, v):
        return -3 * q - v

    its = load_scene(swing).double
    q, v, k = np.array([0.5]), np.array([0.0]), 0
    for k in range(50):
        if k % every == 0:
            p = np.array([2, law(0, q, v)[0]])
        q, v = its.step_leapfrog(1e-3, p, q, v)
    result = run(swing, controller=Controller(law, every), until=0.05)
    assert result.q[-1].tobytes() == q.tobytes() and result.v[-1].tobytes() == v.tobytes()

    @LAW
    def in_c(t, q, v, u, context):
        u[0] = -3 * q[0] - v[0]

    again = run(swing, controller=Controller(in_c, every), until=0.05)
    assert again.q.tobytes() == result.q.tobytes()
    many = run(swing, q0=[[0.1], [0.5]], controller=Controller(law, every), until=0.05)
    assert many.q[1].tobytes() == result.q.tobytes()


@pytest.mark.parametrize("requested, message", (
    ({"p": {"bob.mas": 1}}, "p: bob.mas: .*did you mean 'bob.mass'"),
    ({"p": {"bob.mass": [1, -1]}}, "p: bob.mass=-1: wanted a positive"),
    ({"q0": [1, 2, 3]}, r"q0: wanted \(1\) or \(members, 1\); got shape \(3,\)"),
    ({"q0": [[1], [2]], "v0": [[1]] * 3}, "as many members everywhere; got 2 of q0, 3 of v0"),
    ({"q0": ["x"]}, "q0: wanted real numbers"),
    ({"precision": "both"}, "precision: 'both'"),
    ({"integrator": "radau", "q0": [[1], [2]]}, "wanted an emitted integrator"),
    ({"controller": lambda t, q, v: [1, 2]}, "controller: wanted 1 numbers"),
    ({"controller": "law"}, "controller: wanted a function"),
    ({"q0": [[0.5]], "p": {"bob.mass": [1, 2]}}, "as many members everywhere"),
    ({"controller": Controller(abs, sets=["bob.mass"])}, "which is constant in a run"),
    ({"controller": Controller(abs, sets=["actuator.pivot.torque"] * 3)},
     "controller: sets 'actuator.pivot.torque' twice")))
def test_wrong_arguments_are_refused(swing, requested, message):
    with pytest.raises(SimulateError, match=message):
        run(swing, until=0.05, **requested)


def none(*_: object) -> None:
    raise AssertionError("called")


@pytest.mark.parametrize("requested, message", (
    ({"p": []}, r"p: wanted \(2\) or \(members, 2\); got shape \(0,\)"),
    ({"p": np.zeros((0, 2))}, r"p: wanted \(2\) or \(members, 2\); got shape \(0, 2\)"),
    ({"p": [[1, 2], [3]]}, r"p: wanted real numbers; got \[\[1, 2\], \[3\]\]"),
    ({"p": {"bob.mass": []}}, r"p: bob.mass: wanted a number or one for .*; got shape \(0,\)"),
    ({"p": {"bob.mass": [1, 2], "actuator.pivot.torque": [1, 2, 3]}},
     "as many members everywhere; got 2 of p: bob.mass, 3 of p: actuator.pivot.torque"),
    ({"p": {1: 2}}, "p: 1: wanted the name of a parameter"),
    ({"p": {"bob.mass": np.nan}}, "p: bob.mass=nan: wanted a finite number$"),
    ({"p": [[1, 0], [1, -np.inf]]}, "p: actuator.pivot.torque=-inf: wanted a finite number$"),
    ({"record": []}, r'record: an empty list; wanted quantities, as \["q", "v"\]'),
    ({"record": "q"}, "record: wanted a list of names, as .*; got 'q'"),
    ({"record": [1, 2]}, r"record: wanted a list of names, as .*; got \[1, 2\]"),
    ({"record": 3}, "record: wanted a list of names, as .*; got 3"),
    ({"integrator": 1}, "integrator: 1; wanted one of leapfrog, .*dop853$"),
    ({"integrator": ""}, "integrator: ''; wanted one of leapfrog, .*dop853$"),
    ({"integrator": "rk5"}, "integrator: 'rk5'; wanted .*dop853; did you mean 'rk4'")))
def test_what_has_the_wrong_type_is_refused_before_anything_is_compiled(
        swing, monkeypatch, requested, message):
    monkeypatch.setattr(api, "kernels_for", none)
    with pytest.raises(SimulateError, match=message):
        run(swing, until=0.05, **requested)


@pytest.mark.parametrize("name", ("q0", "v0"))
def test_a_batch_has_members(swing, name):
    with pytest.raises(SimulateError, match=rf"{name}: wanted \(1\) or .*; got shape \(0, 1\)"):
        run(swing, until=0.05, **{name: np.zeros((0, 1))})


def test_names_to_record_may_come_one_by_one(swing):
    result = run(swing, until=0.05, record=(x for x in ("energy.total", "v")))
    assert list(result.recorded) == ["energy.total", "v.pivot"]


@pytest.mark.parametrize("requested, message", (
    ({"sets": "x"}, r"sets: wanted a list of names, as \[.*\]; got 'x'"),
    ({"sets": [1]}, r"sets: wanted a list of names, as .*; got \[1\]"),
    ({"sets": 3}, "sets: wanted a list of names, as .*; got 3"),
    ({"sets": {"x"}}, r"sets: wanted a list of names, as .*; got \{'x'\}"),  # has no order
    ({"steps": True}, "steps: wanted a whole number of steps, from 1 to .*; got True"),
    ({"steps": -5}, "steps: wanted a whole number of steps, from 1 to .*; got -5"),
    ({"steps": 2**64}, "steps: wanted a whole number of steps, from 1 to .*; got 18446744073709"),
    ({"context": ctypes.byref(ctypes.c_long())}, "context: wanted an address.*; got CArgObject"),
    ({"context": ctypes.pointer(ctypes.c_long())}, "context: wanted an address, .*; got LP_c_long"),
    ({"context": "x"}, r"context: wanted an address, as ctypes.addressof\(x\); got str"),
    ({"context": True}, "context: wanted an address, .*; got True"),
    ({"context": -1}, "context: wanted an address, .*; got -1"),
    ({"context": 2**64}, "context: wanted an address, .*; got 18446744073709551616")))
def test_controllers_refuse_what_they_cannot_use(requested, message):
    with pytest.raises(SimulateError, match=f"controller: {message}"):
        Controller(none, **requested)


def test_steps_of_a_controller_may_be_of_numpy():
    assert Controller(none, np.int64(2)) == Controller(none, 2)


def test_an_untyped_pointer_is_an_address(swing):
    """This holds for the function and for its context."""
    count = ctypes.c_long(0)

    @LAW
    def law(t, q, v, u, context):
        ctypes.c_long.from_address(context).value += 1
        u[0] = -3 * q[0]

    by = Controller(ctypes.cast(law, ctypes.c_void_p),
                    context=ctypes.c_void_p(ctypes.addressof(count)))
    result = run(swing, controller=by, until=0.05)
    assert count.value == 51  # before each step, and at the end
    wanted = run(swing, controller=lambda t, q, v: -3 * q, until=0.05)
    assert result.q.tobytes() == wanted.q.tobytes()


@pytest.mark.parametrize("pointer", (0, False, True, LAW(), ctypes.c_void_p(), -5, 2**64))
def test_what_points_to_no_function_is_refused(pointer):
    with pytest.raises(SimulateError, match="controller: wanted a function of .*got"):
        Controller(pointer)


def test_quaternions_have_norm_1_as_in_files(tmp_path):
    path = tmp_path / "free.toml"
    path.write_text("""[bodies]
hull = { mass = 3, inertia = [0.3, 0.2, 0.4] }
[joints]
base = { type = "free", child = "hull" }
""")
    for wrong in ([0, 0, 0, 2], [0, 0, 0, 0]):
        with pytest.raises(SimulateError, match="joint base: a quaternion of norm .*wanted 1"):
            run(path, q0=[0, 0, 0, *wrong], until=0.1)
    assert run(path, q0=[0, 0, 0, 0, 0, 0, 1 + 1e-7], until=0.1).q[0, 6] == 1
