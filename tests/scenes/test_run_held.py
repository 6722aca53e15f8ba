"""`run` warns of controllers that change too fast for how seldom they are called: on a joint whose
acceleration is w times its torque, T d w > 1 or T sqrt(k w) > 1."""

import ctypes
import re
import warnings
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import Controller, load_scene, run
from coscrew_codegen.simulation import execution
from tests.support.compiled.c_harness import run as command

SLIDERS = """
runtime = ["actuator.*.torque", "light.mass"]
base = "fixed"
[bodies]
heavy = { mass = 4, inertia = [1, 1, 1] }
light = { mass = 0.5, inertia = [1, 1, 1] }
[joints]
x = { type = "prismatic", child = "heavy", axis = [1, 0, 0] }
y = { type = "prismatic", parent = "heavy", child = "light", axis = [0, 1, 0] }
[effects.actuator]
joints = "all"
kind = "torque"
torque = 0
[run]
duration = 0.1
step = 1e-3
"""
"""Along x 4.5 kg are moved, along y 0.5 kg; the axes are at right angles, so that (M^-1)_ii is 1/m.
"""
MASSES = {"x": 4.5, "y": 0.5}


@pytest.fixture(scope="module")
def scene(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("held") / "sliders.toml"
    path.write_text(SLIDERS)
    return path


def law(k=(0.0, 0.0), d=(0.0, 0.0)):
    return lambda t, q, v: -np.array(k) * q - np.array(d) * v


def warned(scene, controller, **requested) -> str:
    with warnings.catch_warnings(record=True) as result:
        warnings.simplefilter("always")
        run(scene, controller=controller, **{"q0": [0.1, 0.1], "v0": [0.1, 0.1], **requested})
    return "".join(str(x.message) for x in result if "controller: at" in str(x.message))


@pytest.mark.parametrize("steps", (1, 5))
@pytest.mark.parametrize("precision", ("double", "single"))
@pytest.mark.parametrize("joint", (0, 1))
@pytest.mark.parametrize("share", (0.9, 1.1))
def test_the_warning_begins_where_the_held_law_overshoots(scene, steps, precision, joint, share):
    name, period = "xy"[joint], steps * 1e-3
    one = np.eye(2)[joint]
    for gains, what, unit in (({"d": share * MASSES[name] / period * one}, "speed", "N s/m"),
                              ({"k": MASSES[name] * (share / period)**2 * one}, "position", "N/m")):
        message = warned(scene, Controller(law(**gains), steps), precision=precision)
        assert bool(message) == (share > 1), (gains, message)
        if message:
            assert f"at joint {name} it answers {what} with " in message and f" {unit}, " in message
            slope = float(re.search(r" with (\S+) ", message)[1])
            assert slope == pytest.approx(sum(next(iter(gains.values()))), rel=1e-2)
            assert f"called every {period:g} s" in message and 'kind = "pd"' in message


def test_mass_that_moves_counts_as_the_run_has_it(scene):
    held = Controller(law(d=(0, 700)))
    assert "joint y" in warned(scene, held)
    assert not warned(scene, held, p={"light.mass": 0.75})
    many = warned(scene, held, p={"light.mass": [0.75, 0.6, 2]})
    assert "joint y" in many


@pytest.mark.parametrize(("gains", "steps", "wanted"), (
    ({"d": (0, 240)}, 10, "wanted steps=2, or "), ({"d": (0, 1200)}, 10, "wanted steps=1 and "
     "step=0.0004, or "), ({"d": (0, 1200)}, 1, "wanted step=0.0004, or "),
    ({"k": (0, 4e4)}, 5, "wanted steps=3, or ")))
def test_following_the_advice_once_is_enough(scene, gains, steps, wanted):
    message = warned(scene, Controller(law(**gains), steps))
    assert wanted in message
    (few,) = re.findall(r"steps=(\d+)", message) or ["1"]
    step = re.search(r"step=([\d.e-]+)", message)
    assert not warned(scene, Controller(law(**gains), int(few)),
                      step=float(step[1]) if step else 1e-3)


def test_the_run_is_as_without_the_warning_and_calls_come_after_it(scene, monkeypatch):
    def called(t, q, v):
        times.append(t)
        return -q - d * v

    times, d = [], 0.0
    run(scene, controller=called, q0=[0.1, 0.1])
    assert len(times) == 101 and times == sorted(times)  # nothing turned
    times, d = [], np.array([0, 750])
    with pytest.warns(RuntimeWarning, match="joint y"):
        result = run(scene, controller=called, v0=[0.1, 0.1])
    assert len(times) > 101 and times[:101] == sorted(times[:101])
    monkeypatch.setattr(execution, "too_fast", lambda *its: "")
    assert run(scene, controller=called, v0=[0.1, 0.1]).q.tobytes() == result.q.tobytes()


def test_laws_that_cannot_be_judged_cause_no_warning(scene):
    memory = []

    def with_memory(t, q, v):
        memory.append(0)
        return -750 * v + 1e-3 * len(memory)

    def ended(t, q, v):
        if memory and memory[-1] > t:
            raise RuntimeError("called for the past")
        memory.append(t)
        return -750 * v

    assert warned(scene, law(d=(750, 750)))
    assert not warned(scene, with_memory)
    memory.clear()
    assert not warned(scene, ended)


@pytest.mark.parametrize("precision", ("double", "single"))
def test_heavy_joints_under_gravity_are_judged_alike(tmp_path, precision):
    path = tmp_path / "scene.toml"
    path.write_text(SLIDERS.replace("mass = 4,", "mass = 4e6,").replace("mass = 0.5,", "mass = 1,")
                    + "[effects.gravity]\ng = [-9.81, 0, 0]\n")
    for share in (0.9, 1.1):
        one = Controller(law(d=(share * 4000001 / 1e-3, 0)))
        assert bool(warned(path, one, precision=precision)) == (share > 1)


def test_kernels_without_forward_dynamics_are_judged_alike(scene):
    few = load_scene(scene, functions=["energy", "power", "step_leapfrog"])
    with pytest.warns(RuntimeWarning, match="controller: at joint . it answers"):
        run(few, controller=law(d=(750, 750)), v0=[0.1, 0.1])


def test_laws_in_c_are_judged_unless_they_have_a_context(scene, tmp_path):
    (tmp_path / "law.c").write_text("""
void law(double t, const double *q, const double *v, double *u, void *context) {
  (void)t; (void)context; u[0] = -q[0]; u[1] = -600 * v[1];
}
""")
    command(("gcc", "-O1", "-shared", "-fPIC", tmp_path / "law.c", "-o", tmp_path / "law.so"))
    function = ctypes.CDLL(str(tmp_path / "law.so")).law
    pointer = ctypes.CFUNCTYPE(None, ctypes.c_double, *[ctypes.POINTER(ctypes.c_double)] * 3,
                               ctypes.c_void_p)(("law", ctypes.CDLL(str(tmp_path / "law.so"))))
    assert function and "joint y it answers speed with 600 N s/m" in warned(scene, pointer)
    own = ctypes.c_long()
    assert not warned(scene, Controller(pointer, context=ctypes.addressof(own)))
