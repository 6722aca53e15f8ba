"""Contacts of two bodies: opposite forces at one point, stacks, and the distance of capsules."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import lsq_linear

import coscrew
from coscrew_codegen import load_scene, run
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

G = 9.81


def balls(*masses: float) -> str:
    """Free bodies b0, b1, … with the inertia of balls of radius 0.1 m."""
    bodies = "".join(f"b{i} = {{ mass = {m}, inertia = [{0.004 * m}, {0.004 * m}, {0.004 * m}] }}\n"
                     for i, m in enumerate(masses))
    joints = "".join(f'j{i} = {{ type = "free", child = "b{i}" }}\n' for i in range(len(masses)))
    return f"[bodies]\n{bodies}[joints]\n{joints}"


def pair(upper: str, lower: str, more: str = "") -> str:
    return (f'[effects.contact_pair.{upper}]\nbodies = ["{upper}", "{lower}"]\nmu = 0.5\n'
            f"first_radius = 0.1\nsecond_radius = 0.1\n{more}\n")


def start(table: str, *values: list[float]) -> str:
    return f"[start.{table}]\n" + "".join(f"j{i} = {x}\n" for i, x in enumerate(values))


def written(folder: Path, text: str) -> Path:
    path = folder / "balls.toml"
    path.write_text(text)
    return path


@pytest.mark.parametrize("precision, within", [("double", 1e-13), ("single", 2e-5)])
def test_colliding_bodies_keep_their_momenta(tmp_path: Path, precision: str, within: float) -> None:
    """With friction and spin; linear and angular momentum about the origin."""
    masses = (1, 2)
    text = (balls(*masses) + pair("b0", "b1", "load = 10")
            + start("q", [0, 0, 0, 0, 0, 0, 1], [0.25, 0.05, 0.02, 0, 0, 0, 1])
            + start("v", [1, 0, 0, 0, 3, 5], [-1, 0, 0, 1, 0, 2]))
    result = run(written(tmp_path, text), until=0.4, precision=precision)

    def momenta(q: np.ndarray, v: np.ndarray) -> np.ndarray:
        total = np.zeros(6)
        for i, m in enumerate(masses):
            at, turn = q[7 * i:7 * i + 3], q[7 * i + 3:7 * i + 7]
            p = m * coscrew.rotate_qv(turn, v[6 * i:6 * i + 3])
            L = 0.004 * m * coscrew.rotate_qv(turn, v[6 * i + 3:6 * i + 6])
            total += [*p, *(np.cross(at, p) + L)]
        return total

    ends = [momenta(*(np.asarray(x[k], float) for x in (result.q, result.v))) for k in (0, -1)]
    assert np.abs(ends[1] - ends[0]).max() < within
    assert abs(float(result.v[-1, 0]) - 1) > 0.5


@pytest.mark.parametrize("k", [1e5, 1e7])
@pytest.mark.parametrize("e", [0.9, 0.5])
def test_a_collision_keeps_the_share_that_is_wanted(tmp_path: Path, k: float, e: float) -> None:
    """The share of the speed at which two bodies meet, at eleven phases of the step."""
    law = f"load = 10\nk = {k}\nrestitution = {e}\nspeed = 2\n"
    kernels, n = load_scene(written(tmp_path, balls(1, 3) + pair("b0", "b1", law))), 11
    q0, v0 = np.zeros((n, 17)), np.zeros((n, 12))
    q0[:, 6] = q0[:, 13] = 1
    q0[:, 7], v0[:, 0], v0[:, 6] = 0.2 + 2e-3 * (3 + np.arange(n) / n), 1.5, -0.5
    v = run(kernels, until=0.1, every=0.1, q0=q0, v0=v0).v[:, -1]
    assert np.abs((v[:, 6] - v[:, 0]) / 2 / e - 1).max() < 5e-3


@pytest.mark.parametrize("masses", [(1,) * 9 + (100,), (0.001, 10)], ids=["ratio 100", "1 g"])
def test_light_balls_carry_heavy_ones(tmp_path: Path, masses: tuple[float, ...]) -> None:
    """Stacks stand, each contact as deep as the law says, with steps of 1 and 5 ms."""
    n = len(masses)
    text = balls(*masses) + "[effects.gravity]\n" + (
        '[effects.contact.b0]\nshape = "sphere"\nradius = 0.1\nmu = 0.5\n'
        f"load = {G * sum(masses)}\n")
    text += "".join(pair(f"b{i}", f"b{i - 1}", f"load = {G * sum(masses[i:])}")
                    for i in range(1, n))
    places = [[0, 0, 0.1 + 0.2 * i - 0.0008 * (i + 1), 0, 0, 0, 1] for i in range(n)]
    step = load_scene(written(tmp_path, text), functions=["step_leapfrog"]).double.step_leapfrog
    for h in (1e-3, 5e-3):
        q = np.array([*np.ravel(places), *[0.0] * 3 * n])
        q, _ = step.repeated(round(4 / h), 0.0, h, np.zeros(0), q, np.zeros(6 * n))
        depths = -np.diff([0, *(q[2:7 * n:7] - 0.1 - 0.2 * np.arange(n))])
        assert np.abs(depths / 1e-3 - 1).max() < 0.05


def force(path: Path) -> Callable:
    """The function of the force, the power and the energy of the contact of b0."""
    kernels = load_scene(path, functions=["effect_contact_pair_b0"])
    return kernels.double.effect_contact_pair_b0


def test_the_force_is_that_of_hertz_on_both(tmp_path: Path) -> None:
    """On the first, along the line to it from the second's centre; energy 0.4 k depth^2.5."""
    text = balls(1, 1) + pair("b0", "b1", "load = 1\nk = 1e5")
    f = force(written(tmp_path, text))
    q = np.zeros(17)
    q[[6, 13]], q[:3], q[7:10] = 1, (0.3, 0, 0.1), (0.2, 0.1, 0.2)
    apart, results = q[:3] - q[7:10], f(q, np.zeros(12))
    depth = 0.2 - np.linalg.norm(apart)
    wanted = 1e5 * depth**1.5 * apart / np.linalg.norm(apart)
    assert results[0] == pytest.approx(wanted, rel=1e-12)
    assert results[-1] == pytest.approx(0.4e5 * depth**2.5, rel=1e-12)


CAPSULES = """
first = [0, 0, -0.2]
first_end = [0, 0, 0.2]
second = [-0.1, 0, 0]
second_end = [0.3, 0.1, 0]
load = 1
k = 1e5
"""


def test_capsules_touch_where_their_axes_are_closest(tmp_path: Path) -> None:
    """The depth is that of another solver of |a + s d - b - t e|, 0 <= s, t <= 1, at poses where
    ends, sides and both are closest, and where the axes are parallel."""
    f = force(written(tmp_path, balls(1, 1) + pair("b0", "b1", CAPSULES)))
    rng = np.random.default_rng(5)
    touching = 0
    for n in range(200):
        q = np.zeros(17)
        q[7:10] = rng.uniform(-0.3, 0.3, 3)
        for at in (3, 10):
            q[at:at + 4] = rng.normal(size=4)
            q[at:at + 4] /= np.linalg.norm(q[at:at + 4])
        if n % 5 == 0:
            q[3:7], q[10:14] = (0, 0.7071067811865476, 0, 0.7071067811865476), (0, 0, 0, 1)
        a, d = (coscrew.rotate_qv(q[3:7], x) for x in ((0, 0, -0.2), (0, 0, 0.4)))
        b, e = (coscrew.rotate_qv(q[10:14], x) for x in ((-0.1, 0, 0), (0.4, 0.1, 0)))
        b += q[7:10]
        best = lsq_linear(np.array([d, -e]).T, b - a, (0, 1), tol=1e-14, method="bvls")
        distance = np.linalg.norm(best.fun)
        size = np.linalg.norm(f(q, np.zeros(12))[0])
        touching += distance < 0.2
        assert (size / 1e5)**(2 / 3) == pytest.approx(max(0.2 - distance, 0), abs=1e-9)
    assert 60 < touching < 190


def test_parallel_capsules_touch_at_their_middle(tmp_path: Path) -> None:
    """One lies on the other without turning."""
    own = CAPSULES.replace("[-0.1, 0, 0]", "[0, 0, -0.2]").replace("[0.3, 0.1, 0]", "[0, 0, 0.2]")
    f = load_scene(written(tmp_path, balls(1, 1) + pair("b0", "b1", own))).double
    q = np.zeros(17)
    q[[6, 13]], q[0] = 1, 0.19
    a = f.forward_dynamics(q, np.zeros(12), np.zeros(12))
    assert np.abs(a[3:6]).max() < 1e-9 * abs(a[0]) and a[0] > 0


def test_a_body_touches_one_on_the_world(tmp_path: Path) -> None:
    """A ball rests on a fixed sphere, until it is pushed off."""
    text = (balls(1) + pair("b0", "world", "second = [0, 0, -0.1]") + "[effects.gravity]\n"
            + start("q", [0, 0, 0.099, 0, 0, 0, 1]))
    kernels = load_scene(written(tmp_path, text))
    rests = run(kernels, until=1, precision="double")
    assert rests.q[-1, 2] == pytest.approx(0.099, abs=1e-9)
    pushed = run(kernels, until=2, precision="double", v0=[0.1, 0, 0, 0, 1, 0])
    assert pushed.q[-1, 2] < -1


def test_batches_have_the_bits_of_one_state(tmp_path: Path) -> None:
    kernels = load_scene(written(tmp_path, balls(1, 2) + pair("b0", "b1", "load = 10")))
    q0, v0 = np.zeros((5, 17)), np.zeros((5, 12))
    q0[:, [6, 13]], q0[:, 0] = 1, 0.2 + 0.003 * np.arange(5)
    v0[:, 0], v0[:, 5] = -1, 3
    many = run(kernels, until=0.1, q0=q0, v0=v0)
    alone = run(kernels, until=0.1, q0=q0[3], v0=v0[3])
    assert many.q[3].tobytes() == alone.q.tobytes()


@pytest.mark.parametrize("more, words", [
    ("", "without gravity no weight presses on the ground; wanted load in N"),
    ("load = 1\nrolling = 1", "unknown key"),
    ("load = 1\nfirst_end = 1", "first_end")])
def test_what_cannot_be_is_refused(tmp_path: Path, more: str, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        read_scene(written(tmp_path, balls(1, 1) + pair("b0", "b1", more)))
