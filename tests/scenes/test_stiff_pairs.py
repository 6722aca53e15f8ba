"""Stiff forces between bodies in steps: light bodies between heavy ones, in both precisions."""

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import coscrew
from coscrew_codegen import load_scene

G = 9.81
BOTH = pytest.mark.parametrize("precision", ["double", "single"])
PRECISIONS = {"double": np.float64, "single": np.float32}


def balls(*masses: float) -> str:
    """Free bodies b0, b1, … with the inertia of balls of radius 0.1 m."""
    bodies = "".join(f"b{i} = {{ mass = {m}, inertia = [{0.004 * m}, {0.004 * m}, {0.004 * m}] }}\n"
                     for i, m in enumerate(masses))
    joints = "".join(f'j{i} = {{ type = "free", child = "b{i}" }}\n' for i in range(len(masses)))
    return f"[bodies]\n{bodies}[joints]\n{joints}"


def spring(first: str, second: str, length: float, d: float = 0, k: float = 1e6) -> str:
    return (f'[effects.spring_damper.{first}_{second}]\nbodies = ["{first}", "{second}"]\n'
            f"k = {k}\nd = {d}\nlength = {length}\n")


Loaded = Callable[[str], object]


@pytest.fixture
def load(tmp_path: Path, precision: str) -> Loaded:
    """The functions of a scene in a precision."""
    def loaded(text: str) -> object:
        path = tmp_path / "balls.toml"
        path.write_text(text)
        kernels = load_scene(path, functions=["step_leapfrog", "energy", "forward_dynamics"])
        return getattr(kernels, precision)
    return loaded


def moved(f: object, precision: str, steps: int, h: float, q: list, v: list) -> tuple:
    """q and v after these steps."""
    number = PRECISIONS[precision]
    return f.step_leapfrog.repeated(steps, number(0), number(h), np.zeros(0, number),
                                    np.array(q, number), np.array(v, number))


def energy(f: object, q: np.ndarray, v: np.ndarray) -> float:
    return float(np.sum(f.energy(q, v)))


@BOTH
def test_a_zero_length_spring_is_that_of_the_exact_midpoint_rule(load: Loaded,
                                                                 precision: str) -> None:
    """In all directions, h² k/m = 1000: in rationals r_m = r + h/2 u, (1 + w) u' = u - w' r_m."""
    f, h = load(balls(0.001, 10) + spring("b0", "b1", 0)), Fraction(1, 1000)
    masses = [Fraction(repr(m)) for m in (0.001, 10)]
    r, u = [Fraction(1, 100), 0, 0], [Fraction(x) for x in (1, 2, -3)]
    q = [0, 0, 0, 0, 0, 0, 1, 0.01, 0, 0, 0, 0, 0, 1]
    v = [0] * 6 + [1, 2, -3, 0, 0, 0]
    square = 10**6 * sum(1 / m for m in masses)
    for _ in range(20):
        r = [x + h / 2 * y for x, y in zip(r, u, strict=True)]
        a = [-square * x / (1 + h * h * square / 4) for x in r]
        u = [x + h * y for x, y in zip(u, a, strict=True)]
        r = [x + h / 2 * y for x, y in zip(r, u, strict=True)]
    q, v = moved(f, precision, 20, float(h), q, v)
    unit = np.finfo(PRECISIONS[precision]).eps
    speed, length = 317, 0.01
    assert np.abs(v[6:9] - v[:3] - np.array(u, float)).max() < 200 * speed * unit
    assert np.abs(q[7:10] - q[:3] - np.array(r, float)).max() < 200 * length * unit


@BOTH
@pytest.mark.parametrize("h", [1e-3, 5e-3])
@pytest.mark.parametrize("masses", [(0.001, 10), (1,) * 9 + (100,)], ids=["1 g", "ratio 100"])
def test_light_bodies_carry_a_heavy_one(load: Loaded, precision: str, masses: tuple[float, ...],
                                        h: float) -> None:
    """On springs of 1e6 N/m, h² T/(l m) up to 24 across them; each as long as its load says."""
    n = len(masses)
    text = balls(*masses) + "[effects.gravity]\n" + "".join(
        spring(f"b{i - 1}" if i else "world", f"b{i}", 0.2, 1000) for i in range(n))
    lengths = [0.2 + G * sum(masses[i:]) / 1e6 for i in range(n)]
    q = np.ravel([[0, 0, -sum(lengths[:i + 1]), 0, 0, 0, 1] for i in range(n)])
    v = np.ravel([[0, 0.1 * (-1)**i, 0, 0, 0, 0] for i in range(n)])
    f = load(text)
    number = PRECISIONS[precision]
    first = energy(f, np.array(q, number), np.array(v, number))
    q, v = moved(f, precision, round(4 / h), h, q, v)
    assert energy(f, q, v) < first + 0.02 * (0.005 * sum(masses))
    ends = np.vstack([np.zeros(3), q.reshape(n, 7)[:, :3]])
    assert np.linalg.norm(np.diff(ends, axis=0), axis=1) == pytest.approx(lengths, abs=2e-5)
    assert np.abs(v).max() < 0.5


@BOTH
@pytest.mark.parametrize("length", [0, 0.5])
def test_stiff_springs_keep_energy_and_momenta(load: Loaded, precision: str, length: float) -> None:
    """1 g on 10 kg: the light one oscillates at 1 ms with ωh = 32, for 20 s."""
    masses, h = (0.001, 10), 1e-3
    f = load(balls(*masses) + spring("b0", "b1", length))
    q = np.array([0, 0, 0, 0, 0, 0, 1, length + 1e-3, 0, 0, 0, 0, 0, 1])
    v = np.array([0, 0.1, 0, 0, 0, 0, 0, -0.1, 0, 0, 0, 0.0])
    number = PRECISIONS[precision]

    def momenta(q: np.ndarray, v: np.ndarray) -> np.ndarray:
        total = np.zeros(6)
        for i, m in enumerate(masses):
            at, turn = q[7 * i:7 * i + 3], q[7 * i + 3:7 * i + 7]
            p = m * coscrew.rotate_qv(turn, v[6 * i:6 * i + 3])
            L = 0.004 * m * coscrew.rotate_qv(turn, v[6 * i + 3:6 * i + 6])
            total += [*p, *(np.cross(at, p) + L)]
        return total

    before = momenta(q, v), energy(f, q.astype(number), v.astype(number))
    q, v = moved(f, precision, 20000, h, q, v)
    single = precision == "single"
    drift = np.abs(momenta(q.astype(float), v.astype(float)) - before[0])
    assert drift[:3].max() < (3e-6 if single else 3e-13)
    assert drift[3:].max() < (3e-5 if single else 3e-13)
    own = {(0, False): 1e-11, (0, True): 3e-3, (0.5, False): 1e-4, (0.5, True): 0.1}
    assert abs(energy(f, q, v) / before[1] - 1) < own[length, single]


@pytest.mark.parametrize("precision", ["double"])
def test_the_order_of_pairs_does_not_matter(load: Loaded) -> None:
    """Three springs with dampers in a triangle: the state is the same to rounding."""
    ties = [spring("b0", "b1", 0.4, 3), spring("b1", "b2", 0.5, 1e4), spring("b2", "b0", 0, 100)]
    q = [0, 0, 0, 0, 0, 0, 1, 0.4, 0, 0, 0, 0, 0, 1, 0, 0.3, 0, 0, 0, 0, 1]
    v = np.sin(np.arange(18)).tolist()
    results = [moved(load(balls(1, 0.1, 3) + "".join(x)), "double", 20, 1e-3, q, v)
               for x in (ties, ties[::-1], ties[1:] + ties[:1])]
    for other in results[1:]:
        for x, y in zip(results[0], other, strict=True):
            assert np.abs(x - y).max() < 1e-11


@pytest.mark.parametrize("precision", ["single"])
@pytest.mark.parametrize("d", [0, 100, 1e6])
def test_parallel_springs_act_as_one(load: Loaded, d: float) -> None:
    """Three of 1e10 N/m on 1 g, h² k/m = 1e7, whose ulp is 1: they keep their lengths, and pass no
    energy on."""
    ties = [spring("b0", "b1", 0.2, d, 1e10), spring("b1", "b0", 0.2, d, 2e10),
            spring("b0", "b1", 0.2, d, 3e10).replace("b0_b1", "third")]
    f = load(balls(0.001, 0.002) + "".join(ties))
    for seed in range(5):
        rng = np.random.default_rng(seed)
        away, v = rng.normal(size=3), 0.1 * rng.normal(size=12)
        away *= 0.2 / np.linalg.norm(away)
        q = [0, 0, 0, 0, 0, 0, 1, *away, 0, 0, 0, 1]
        speed = np.abs(v).max()
        q, v = moved(f, "single", 200, 1e-3, q, v)
        assert np.linalg.norm(q[7:10] - q[:3]) == pytest.approx(0.2, abs=1e-4)
        assert np.abs(v).max() < 2 * speed
