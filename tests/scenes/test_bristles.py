"""Energy that bristles store, and power of their effects, against the law in 50 digits; with it the
energies of a block that sticks and is pushed add up."""

from pathlib import Path

import mpmath
import numpy as np
import pytest

from coscrew_codegen import load_scene, run
from coscrew_codegen.program.values.formats import BY_NAME

PUSH, LOAD, DEPTH, MU, D_T, MASS = "2", "9.81", "0.001", "0.5", "30", "2"
K_T, K = "9810", repr(float(LOAD) / float(DEPTH)**1.5)
BLOCK = f"""
functions = ["default", "bristles"]
[bodies]
carriage = {{ mass = 1 }}
block = {{ mass = 1 }}
[joints]
x = {{ type = "prismatic", child = "carriage", axis = [1, 0, 0] }}
z = {{ type = "prismatic", parent = "carriage", child = "block", axis = [0, 0, 1] }}
[effects.gravity]
[effects.contact.block]
mu = {MU}
load = {LOAD}
d_t = {D_T}
[effects.actuator.x]
kind = "torque"
torque = {PUSH}
[start.q]
z = -{DEPTH}
[outputs]
every = 1e-3
record = ["energy", "power", "bristles"]
[run]
duration = 0.3
step = 1e-4
"""
HELD = """
functions = ["bristles"]
[bodies]
arm = { mass = 1 }
[joints]
slide = { type = "prismatic", child = "arm", axis = [1, 0, 0] }
[effects.stiction.slide]
tau_c = 4
k = 1024
d = 8
"""


def written(folder: Path, text: str) -> Path:
    path = folder / "scene.toml"
    path.write_text(text)
    return path


def of_law(q: list[float], v: list[float]) -> tuple[mpmath.mpf, mpmath.mpf]:
    """The energy of the block's bristles, and the power of friction and damping, which is
    negative, both in 50 digits."""
    depth, (x, y, _), u, rise = -mpmath.mpf(q[1]), q[2:], mpmath.mpf(v[0]), mpmath.mpf(v[1])
    elastic = mpmath.mpf(K) * mpmath.sqrt(max(depth, 0))**3
    N = elastic * max(1 - mpmath.mpf(3) / 2 * rise, 0)
    grip, k, d = mpmath.mpf(MU) * N, mpmath.mpf(K_T), mpmath.mpf(D_T)
    pull = [k * x + d * u, k * mpmath.mpf(y)]
    size, bent = mpmath.hypot(*pull), k * mpmath.hypot(x, y)
    share = min(grip / size, 1) if size else 1
    return min(grip, bent)**2 / (2 * k), (N - elastic) * rise - share * pull[0] * u


@pytest.mark.parametrize("precision", ["double", "single"])
def test_a_contact_stores_what_its_law_says(tmp_path: Path, precision: str) -> None:
    """Bristles that hold and that are at their bound, in contacts that close, open and are open."""
    kernels = load_scene(written(tmp_path, BLOCK))
    real, u = BY_NAME[precision].numpy_type, float(BY_NAME[precision].u)
    random, held, slipping = np.random.default_rng(1), 0, 0
    for _ in range(200):
        size = 10.0**random.uniform(-6, -3)
        depth = random.choice([-1e-4, 10.0**random.uniform(-5, -2.5)], p=[0.1, 0.9])
        q = [0.0, -depth, *random.uniform(-size, size, 2), 0.0]
        v = random.uniform(-0.3, 0.3, 2)
        q, v = (np.array(x, real).astype(float).tolist() for x in (q, v))
        came = getattr(kernels, precision).bristles(np.array(q, real), np.array(v, real))
        with mpmath.workdps(50):
            stored, power = of_law(q, v)
            N = mpmath.mpf(K) * mpmath.sqrt(max(-q[1], 0))**3
            scale = N * (1 + abs(v[1])) * (abs(v[0]) + abs(v[1]))
            assert abs(stored - float(came[0])) <= 16 * u * stored
            assert abs(power - float(came[1])) <= 16 * u * scale
        held += 0 < stored < (float(MU) * float(N))**2 / (2 * float(K_T)) * 0.99
        slipping += stored > 0
    assert held > 20 and slipping - held > 20


@pytest.mark.parametrize("z, stored", [(2**-10, 2**-11), (-2**-9, 2**-9), (2**-6, 2**-7)])
@pytest.mark.parametrize("precision", ["double", "single"])
def test_stiction_stores_half_k_z_squared_up_to_its_bound(tmp_path: Path, precision: str, z: float,
                                                          stored: float) -> None:
    """k = 1024, at most tau_c = 4 at |z| = 1/256; the torque of bristles and damping is at most
    tau_c, too."""
    kernels = load_scene(written(tmp_path, HELD))
    v = 0.0625
    came = getattr(kernels, precision).bristles([0, z], [v])
    torque = min(max(1024 * max(min(z, 2**-8), -2**-8) + 8 * v, -4), 4)
    assert [float(x) for x in came] == [stored, -torque * v]


def spring(t: float) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Place and speed of a mass on a spring and a damper, from rest under a constant force."""
    k, d, m, push = (mpmath.mpf(x) for x in (K_T, D_T, MASS, PUSH))
    a = d / (2 * m)
    w, fades = mpmath.sqrt(k / m - a * a), mpmath.exp(-a * t)
    return (push / k * (1 - fades * (mpmath.cos(w * t) + a / w * mpmath.sin(w * t))),
            push / k * fades * (a * a / w + w) * mpmath.sin(w * t))


@pytest.mark.parametrize("precision, within", [("double", 1e-9), ("single", 2e-5)])
def test_energies_of_a_block_that_sticks_and_is_pushed_add_up(tmp_path: Path, precision: str,
                                                              within: float) -> None:
    """Work of the push = kinetic + potential + stored energy + what the damping takes, each as on
    a spring k_t with a damper d_t, in 50 digits."""
    text = BLOCK + 'integrator = "dop853"\nrtol = 1e-12\natol = 1e-14\n' * (
        precision == "double")
    result = run(written(tmp_path, text), precision=precision)
    its = result.recorded
    for place in (20, 45, 100, 300):
        t = float(result.t[place])
        with mpmath.workdps(50):
            x, v = spring(t)
            stored = mpmath.mpf(K_T) * x * x / 2
            kinetic = mpmath.mpf(MASS) * v * v / 2
            lost = mpmath.mpf(D_T) * mpmath.quad(lambda s: spring(s)[1]**2,
                                                 mpmath.linspace(0, t, 12))
            work, scale = mpmath.mpf(PUSH) * x, mpmath.mpf(PUSH)**2 / mpmath.mpf(K_T)
            assert abs(work - kinetic - stored - lost) < 1e-40
        assert abs(its["bristles.energy"][place] - stored) < within * scale
        assert abs(its["energy.kinetic"][place] - kinetic) < within * scale
        taken = -(mpmath.mpf(K_T) * x + mpmath.mpf(D_T) * v) * v
        assert abs(its["bristles.power"][place] - taken) < 100 * within * scale
