"""Steps that take torques of joints: those of actuators at run time, bit for bit."""

from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.function_selection import FunctionsError, by_default, resolved
from coscrew_codegen.scene.integrators import EMITTED
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene

WITH_TAU = [x.step_with_tau for x in EMITTED]
ARM = """
RUNTIME
[bodies]
cart = { mass = 2, com = [0, 0.1, 0.2], inertia = [0.1, 0.2, 0.3] }
upper = { mass = 2, com = [0, 0.1, -0.25], inertia = [0.04, 0.04, 0.002] }
lower = { mass = 1, com = [0.05, 0, -0.2], inertia = [0.01, 0.01, 0.001] }
[joints]
slide = { BASE, child = "cart" }
shoulder = { type = "revolute", parent = "cart", child = "upper", axis = [0, 1, 0] }
elbow = { type = "revolute", parent = "upper", child = "lower", axis = [0, 0.6, 0.8], ORIGIN }
[effects.gravity]
[effects.viscous]
d = { elbow = 0.3 }
[effects.limit.shoulder]
lower = -1
upper = 1
k = 1e4
alpha = 0.3
ACTUATORS
"""
SLIDES, FLOATS = 'type = "prismatic", axis = [1, 0, 0]', 'type = "free"'
JOINTS = ("slide", "shoulder", "elbow")


def scenes(folder: Path, base: str, *driven: str) -> tuple[Path, Path]:
    """The scene without actuators, and the one with a torque at run time at each `driven` joint."""
    names = ", ".join(f'"actuator.{x}.torque"' for x in driven)
    tables = "".join(f'[effects.actuator.{x}]\nkind = "torque"\ntorque = 0\n' for x in driven)
    results = []
    for name, runtime, actuators in (("free", "", ""), ("driven", f"runtime = [{names}]", tables)):
        path = folder / f"{name}.toml"
        path.write_text(ARM.replace("BASE", base).replace("RUNTIME", runtime)
                        .replace("ORIGIN", "origin = { xyz = [0, 0, -0.5] }")
                        .replace("ACTUATORS", actuators))
        results.append(path)
    return tuple(results)


@pytest.fixture(scope="module")
def arms(tmp_path_factory: pytest.TempPathFactory) -> tuple[Kernels, Kernels]:
    free, driven = scenes(tmp_path_factory.mktemp("arms"), SLIDES, *JOINTS)
    steps = [x.step_name for x in EMITTED]
    return (load_scene(free, functions=["default", *steps, *WITH_TAU]),
            load_scene(driven, functions=["default", *steps]))


def states(kernels: Kernels, count: int) -> tuple[np.ndarray, ...]:
    """Random q, v and torques; some at the ends of the shoulder's range, or soon."""
    rng = np.random.default_rng(5)
    q, v = rng.uniform(-1.5, 1.5, (count, kernels.NQ)), rng.normal(size=(count, kernels.NV))
    return q, v, 20 * rng.normal(size=(count, kernels.NV))


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("integrator", EMITTED, ids=lambda x: x.name)
def test_tau_is_the_torque_of_actuators_bit_for_bit(arms: tuple[Kernels, Kernels],
                                                    integrator: object, precision: str) -> None:
    """Each joint has one other effect at most, so that the order of sums is the same."""
    free, driven = (getattr(x, precision) for x in arms)
    q, v, tau = (x.astype(free.energy(np.zeros(3), np.zeros(3)).dtype)
                 for x in states(arms[0], 300))
    result = getattr(free, integrator.step_with_tau)(0.005, q, v, tau)
    wanted = getattr(driven, integrator.step_name)(0.005, tau, q, v)
    for x, y in zip(result, wanted, strict=True):
        assert x.tobytes() == y.tobytes()
    one = getattr(free, integrator.step_with_tau)(0.005, q[7], v[7], tau[7])
    assert all((x == y[7]).all() for x, y in zip(one, result, strict=True))
    still = getattr(free, integrator.step_with_tau)(0.005, q, v, np.zeros(3))
    plain = getattr(free, integrator.step_name)(0.005, q, v)
    assert all((x == y).all() for x, y in zip(still, plain, strict=True))
    assert (np.abs(result[1] - plain[1]).max(0) > 0.1).all()


def test_python_without_a_compiler_has_the_same_bits(
        arms: tuple[Kernels, Kernels], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("CC", "/no/such/compiler")
    with pytest.warns(RuntimeWarning, match="compiler"):
        twins = load_scene(scenes(tmp_path, SLIDES)[0], functions=WITH_TAU)
        q, v, tau = states(arms[0], 50)
        for name in WITH_TAU:
            compiled = getattr(arms[0].double, name)(0.005, q, v, tau)
            for x, y in zip(getattr(twins.double, name)(0.005, q, v, tau), compiled, strict=True):
                assert x.tobytes() == y.tobytes()


def test_a_constant_torque_gives_a_parabola(tmp_path: Path) -> None:
    """Exactly, in binary fractions: v = tau t/J, q = tau t²/(2 J)."""
    path = tmp_path / "wheel.toml"
    path.write_text('[bodies]\nw = { mass = 1, inertia = [2, 2, 2] }\n[joints]\n'
                    'j = { type = "continuous", child = "w", axis = [0, 0, 1] }\n')
    step = load_scene(path, functions=["step_leapfrog_tau"]).double.step_leapfrog_tau
    q, v = np.zeros(1), np.zeros(1)
    for _ in range(256):
        q, v = step(2**-7, q, v, [3.0])
    assert (q[0], v[0]) == (3.0, 3.0)


def test_a_base_that_floats_is_pushed(tmp_path: Path) -> None:
    """Torques of its own joint act on it; the momentum that is known can be kept as by steps
    without tau, with the same bits."""
    free, driven = scenes(tmp_path, FLOATS, "shoulder", "elbow")
    its = load_scene(free, functions=["default", "step_leapfrog_tau"]).double
    others = load_scene(driven).double
    rng = np.random.default_rng(6)
    q = np.array([1, 2, 3, 0.1, 0.7, -0.5, 0.5, 0.3, -0.4])
    v, tau, h = rng.normal(size=8), np.append(np.zeros(6), [3.0, -2.0]), 1e-3
    q[3:7] /= np.linalg.norm(q[3:7])
    c = its.free_momentum(q, v)
    after, speeds = its.step_leapfrog_tau(h, q, v, tau)
    after, speeds = its.with_free_momentum(h, after, speeds, c)
    for x, y in zip((after, speeds), others.step_leapfrog(h, tau[6:], q, v), strict=True):
        assert x.tobytes() == y.tobytes()
    push = np.array([4.0, -5, 6, 0, 0, 0, 0, 0])
    after, speeds = its.step_leapfrog_tau(h, q, v, push)
    gained = its.free_momentum(after, speeds) - its.free_momentum(*its.step_leapfrog_tau(
        h, q, v, 0 * push))
    R = its.body_poses(q)[0, :, :3]
    assert np.abs(gained[0, :3] - h * R @ push[:3]).max() < 20 * h**2


def test_steps_with_tau_are_selected_by_name(tmp_path: Path) -> None:
    read: Scene = read_scene(scenes(tmp_path, SLIDES)[0])
    assert not set(WITH_TAU) & set(by_default(read))
    assert set(WITH_TAU) <= resolved(read, ("all",))
    with pytest.raises(FunctionsError, match="did you mean 'step_leapfrog_tau'"):
        resolved(read, ("step_leapfrog_taus",))


def test_headers_have_them(tmp_path: Path) -> None:
    """In the order t, h, p, q, v, tau; also of many states."""
    path = scenes(tmp_path, SLIDES, "elbow")[1]
    path.write_text('functions = ["step_rk4_tau"]\n' + path.read_text())
    assert main(["generate", str(path), "-o", str(tmp_path / "out"), "--many"]) == 0
    one, many = ((tmp_path / f"out/{name}.h").read_text() for name in ("driven", "driven_many"))
    assert ("void driven_step_rk4_tau(double h, const double p[1], double q[3], double v[3],\n"
            "    const double tau[3]);") in one
    words = " ".join(many.split())
    assert "double *v, ptrdiff_t v_stride, const double *tau, ptrdiff_t tau_stride);" in words
