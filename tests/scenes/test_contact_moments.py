"""Moments of contacts that resist spin and rolling, against closed forms."""

import math
from pathlib import Path

import numpy as np
import pytest

import coscrew
from coscrew_codegen import run

G, R = 9.81, 0.1
BALL = """
[bodies]
ball = { mass = 1, inertia = [0.004, 0.004, 0.004] }
[joints]
free = { type = "free", child = "ball" }
[effects.gravity]
[effects.contact.ball]
shape = "sphere"
radius = 0.1
mu = 0.5
"""


def of_ball(folder: Path, moments: str, *v: float) -> Path:
    """A ball as deep in the ground as it rests, with these velocities."""
    path = folder / "ball.toml"
    path.write_text(f"{BALL}{moments}\n[start.q]\nfree = [0, 0, 0.099, 0, 0, 0, 1]\n"
                    f"[start.v]\nfree = {[*v]}\n")
    return path


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("step", [1e-3, 5e-3])
def test_a_spinning_ball_stops_when_its_moment_has_taken_its_spin(
        tmp_path: Path, step: float, precision: str) -> None:
    """I w' = -torsional m g: w falls linearly, to zero after I w0/(torsional m g), within a third
    of a step's loss."""
    path = of_ball(tmp_path, "torsional = 0.001", 0, 0, 0, 0, 0, 5)
    result = run(path, until=3, step=step, precision=precision)
    rate = 0.001 * G / 0.004
    t, w = (np.asarray(x, float) for x in (result.t, result.v[:, 5]))
    wanted = np.maximum(5 - rate * t, 0)
    assert 5 / rate < 2.1
    assert np.abs(w - wanted).max() < rate * step / 3
    assert abs(w[-1]) < 1e-6


@pytest.mark.parametrize("step", [1e-3, 5e-3])
def test_a_ball_rolls_as_far_as_its_moment_lets_it(tmp_path: Path, step: float) -> None:
    """(m r² + I) v'/r = -rolling m g: it comes v²/(2 · 5/7 · rolling g/r) far."""
    path = of_ball(tmp_path, "rolling = 0.002", 1, 0, 0, 0, 10, 0)
    result = run(path, until=9, step=step, precision="double")
    far = 1 / (2 * 5 / 7 * 0.002 * G / R)
    assert result.q[-1, 0] == pytest.approx(far, rel=1e-3)
    assert np.abs(result.v[-1]).max() < 1e-5


def test_moments_take_what_energy_is_lost(tmp_path: Path) -> None:
    path = of_ball(tmp_path, "rolling = 0.002\ntorsional = 0.001", 1, 0, 0, 0, 10, 3)
    path.write_text(path.read_text() + '[outputs]\nrecord = ["q", "v", "energy", "power"]\n')
    result = run(path, until=3, precision="double")
    energy, power = (result.recorded[x] for x in ("energy.total", "power"))
    work = np.concatenate([[0], np.cumsum((power[1:] + power[:-1]) / 2 * np.diff(result.t))])
    assert np.abs(energy - energy[0] - work).max() < 1e-3 * (energy[0] - energy.min())
    assert (power < 1e-12).all()


def test_resisted_rolling_creeps_on_a_slope_as_slowly_as_stated(tmp_path: Path) -> None:
    """tan α r < rolling: w/sqrt(w² + eps²) is their quotient."""
    slope = 0.01
    path = of_ball(tmp_path, "rolling = 0.002", 0, 0, 0, 0, 0, 0)
    g = f"[effects.gravity]\ng = [{G * math.sin(slope)!r}, 0, {-G * math.cos(slope)!r}]"
    path.write_text(path.read_text().replace("[effects.gravity]", g))
    result = run(path, until=4, precision="double")
    share = math.tan(slope) * R / 0.002
    w = coscrew.rotate_qv(*(np.asarray(x, float) for x in (result.q[-1, 3:7], result.v[-1, 3:])))
    assert w[1] == pytest.approx(1e-3 * share / math.sqrt(1 - share**2), rel=1e-3)


def test_without_moments_a_ball_spins_for_ever(tmp_path: Path) -> None:
    assert run(of_ball(tmp_path, "", 0, 0, 0, 0, 0, 5), until=3).v[-1, 5] == 5
