"""Examples in which bodies touch, and hard cases of contact, against closed forms."""

import math
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from scipy.optimize import brentq

import coscrew
from coscrew_codegen import load_scene, run

SCENES = Path(__file__).parents[2] / "examples/scenes"
G = 9.81
BALL = """
[bodies]
ball = { mass = 1, inertia = [0.004, 0.004, 0.004] }
[joints]
free = { type = "free", child = "ball" }
[effects.contact.ball]
shape = "sphere"
radius = 0.1
mu = 0.5
"""


class Touching(NamedTuple):
    """The results of `contacts`."""

    point: np.ndarray
    force: np.ndarray
    depth: np.ndarray
    share: np.ndarray
    normal: np.ndarray


@pytest.mark.parametrize("precision, within, moved", [
    ("double", 1e-5, 1e-6), ("single", 1e-3, 1e-3)])
def test_a_humanoid_stands_and_presses_with_its_weight(precision: str, within: float, moved: float
                                                       ) -> None:
    """After 20 s; no foot slips, and the feet are where they were 10 s before."""
    kernels = load_scene(SCENES / "humanoid.toml", functions=["default", "contacts"])
    result = run(kernels, until=20, every=10, precision=precision)
    f = getattr(kernels, precision).contacts
    before, now = (Touching(*f(result.q[k], result.v[k])) for k in (1, 2))
    assert np.sum(now.force, 0) == pytest.approx([0, 0, 65 * G], abs=within * 65 * G)
    assert now.share.max() < 0.5
    assert np.abs(np.asarray(now.point, float) - before.point)[:, :2].max() < moved


def test_a_rovers_wheels_roll_as_far_as_they_turn(tmp_path: Path) -> None:
    """On level ground v = r w, less the depth nothing."""
    text = (SCENES / "rover.toml").read_text()
    text = text[:text.index("[expect]")].replace('height = "0.02*sin(4*x)*cos(3*y)"', "")
    path = tmp_path / "rover.toml"
    path.write_text(text)
    result = run(path, until=3, precision="double")
    turned, went = (result.q[-1, k] - result.q[-101, k] for k in (7, 0))
    assert went / turned == pytest.approx(0.11, rel=1e-9)
    assert result.v[-1, 6] == pytest.approx(3, rel=1e-3)


def test_contacts_are_those_of_their_effects() -> None:
    """Points are where feet touch, forces those of single effects, to the bit."""
    names = ["fl", "fr", "rl", "rr"]
    kernels = load_scene(SCENES / "landing.toml", functions=["default", "contacts", *(
        f"effect_contact_feet_{x}_shank" for x in names)])
    result = run(kernels, until=0.5, precision="double")
    q, v = result.q[-1], result.v[-1]
    f = Touching(*kernels.double.contacts(q, v))
    for k, name in enumerate(names):
        own = getattr(kernels.double, f"effect_contact_feet_{name}_shank")(q, v)[0]
        assert np.asarray(own).tobytes() == f.force[k].tobytes()
        place = kernels.double.body_poses(q)[kernels.interface.bodies.index(f"{name}_shank")]
        foot = place[:, :3] @ (0, 0, -0.21) + place[:, 3] - (0, 0, 0.02)
        assert np.abs(f.point[k] - foot).max() < 1e-15
        assert f.depth[k] * 1e-3 == pytest.approx(-foot[2], rel=1e-9)
    assert (f.share <= 1 + 1e-12).all() and (f.force[:, 2] >= 0).all()
    assert np.abs(f.normal - (0, 0, 1)).max() < 1e-15


def test_a_grazing_contact_loses_as_much_speed_as_its_friction_takes(tmp_path: Path) -> None:
    """Sliding at 10 m/s, it sinks at 1 mm/s: along the ground it loses mu times what it gains
    across it, and no energy comes from nowhere."""
    path = tmp_path / "ball.toml"
    path.write_text(BALL + "load = 1\nk = 1e5\n[start.q]\nfree = [0, 0, 0.10001, 0, 0, 0, 1]\n"
                    "[start.v]\nfree = [10, 0, -1e-3, 0, 0, 0]\n")
    v = run(path, until=1, precision="double").v[-1]
    q = run(path, until=1, precision="double").q[-1]
    x, _, z = coscrew.rotate_qv(q[3:7], v[:3])
    assert 0.9e-3 < z < 1e-3
    assert 10 - x == pytest.approx(0.5 * (z + 1e-3), rel=1e-3)


def test_a_kilometre_away_single_precision_loses_places_not_speeds(tmp_path: Path) -> None:
    """Numbers are 61 µm apart there: a ball still rolls at 5/7 g sin α, and is within two of these
    spacings, and what it rolls in between, of where it would be."""
    slope = 0.1
    path = tmp_path / "ball.toml"
    path.write_text(f"{BALL}[effects.gravity]\ng = [{G * math.sin(slope)!r}, 0, "
                    f"{-G * math.cos(slope)!r}]\n[start.q]\nfree = [1000, 0, 0.099, 0, 0, 0, 1]\n")
    result = run(path, until=1, precision="single")
    a = 5 / 7 * G * math.sin(slope)
    q, v = (np.asarray(x[-1], float) for x in (result.q, result.v))
    assert abs(coscrew.rotate_qv(q[3:7], v[:3])[0] / a - 1) < 1e-4
    assert abs(q[0] - 1000 - a / 2) < 1000 * 6.2e-5 / 2
    assert abs(q[2] - 0.099) < 5e-6


def test_normals_are_those_of_the_ground(tmp_path: Path) -> None:
    """On a slope, and of two bodies from the second to the first."""
    path = tmp_path / "ball.toml"
    path.write_text(BALL + "load = 1\n[effects.ground]\nnormal = [0.6, 0, 0.8]\n")
    kernels = load_scene(path, functions=["contacts"])
    f = Touching(*kernels.double.contacts([0.06, 0, 0.0799, 0, 0, 0, 1, 0, 0, 0], np.zeros(6)))
    assert f.normal[0] == pytest.approx([0.6, 0, 0.8], abs=1e-15)
    assert f.force[0] == pytest.approx(np.linalg.norm(f.force[0]) * f.normal[0], abs=1e-15)
    assert np.linalg.norm(f.force[0]) > 0


def test_a_series_of_bounces_is_that_of_the_law(tmp_path: Path) -> None:
    """Each bounce of a hard ball keeps e v of its speed v, with log((1 + y)/(1 - e y)) = (1 + e) y,
    y = 1.5 alpha v; so do the heights, up to what gravity does while it touches, g τ/v."""
    text = (SCENES / "bouncing_ball.toml").read_text().replace("mu = 0.5", "mu = 0.5\nk = 1e9")
    text = text.replace("restitution = 0.7\nspeed = 4.4", "alpha = 0.1")
    path = tmp_path / "ball.toml"
    path.write_text(text[:text.index("[outputs]")] + "[outputs]\nevery = 1e-3\n")
    z = run(path, until=3.5, step=1e-3, precision="double").q[:, 2]
    tops = z[1:-1][(z[1:-1] > z[:-2]) & (z[1:-1] >= z[2:])]
    v, count = math.sqrt(2 * G), 0
    for top in tops[:4]:
        y = 0.15 * v
        e = brentq(lambda e, y=y: (1 + e) * y - math.log((1 + y) / (1 - e * y)), 1e-3, 1 - 1e-9)
        v, count = e * v, count + 1
        assert top - 0.1 == pytest.approx(v * v / (2 * G), rel=5e-3 * count)
    assert count == 4
