"""A ball that slides and spins until it rolls: all integrators against another solver on the law of
contact, written here once more with its two modes: bristles that hold, and bristles that slip."""

from pathlib import Path

import numpy as np
import pytest
import scipy.integrate

from coscrew_codegen import run

R, MASS, INERTIA, MU, G, DEPTH = 0.1, 1.0, 0.004, 0.5, 9.81, 1e-3
K, K_T, D_T = G / DEPTH**1.5, G / DEPTH, 0.4 * np.sqrt(G / DEPTH * G / G)
V, W, END = (1.0, 0.5, 0.0), (0.0, 3.0, 8.0), 0.4
SCENE = f"""
[bodies]
ball = {{ mass = {MASS}, inertia = [{INERTIA}, {INERTIA}, {INERTIA}] }}
[joints]
free = {{ type = "free", child = "ball" }}
[effects.contact.ball]
shape = "sphere"
radius = {R}
mu = {MU}
[effects.gravity]
[run]
rtol = 1e-9
atol = 1e-12
[start.q]
free = [0, 0, {R - DEPTH}, 0, 0, 0, 1]
[start.v]
free = {[*V, *W]}
"""
UP, TO_SURFACE = np.array([0, 0, 1.0]), np.array([0, 0, -R])


class Ball:
    """The law at (x, v, w, z), all in the world's axes; where bristles slip, z is their direction
    alone."""

    def __init__(self, y: np.ndarray, slips: bool):
        self.v, w, z = y[3:6], y[6:9], y[9:12]
        u = self.v + np.cross(w, TO_SURFACE)
        self.slip, self.size = u - u[2] * UP, np.linalg.norm(z)
        self.N = K * max(R - y[2], 0)**1.5 * max(1 - 1.5 * u[2], 0)
        self.bound = MU * self.N / K_T
        self.z = z / self.size * self.bound if slips else z
        self.pull = K_T * self.z + D_T * self.slip
        size = np.linalg.norm(self.pull)
        self.friction = -self.pull * min(1, MU * self.N / max(size, 1e-30))
        self.out = self.slip @ self.z / self.bound
        self.slips = slips

    def rates(self) -> np.ndarray:
        along = self.slip
        if self.slips:
            along = (along - self.out * self.z / self.bound) * self.size / self.bound
        return np.concatenate((self.v, (self.N * UP + self.friction) / MASS - G * UP,
                               np.cross(TO_SURFACE, self.friction) / INERTIA, along))


def begins(_t: float, y: np.ndarray, slips: bool) -> float:
    """Below zero where bristles slip that held."""
    own = Ball(y, slips)
    return 1.0 if slips else own.bound - own.size


def limited(_t: float, y: np.ndarray, slips: bool) -> float:
    """Zero where friction reaches its limit."""
    own = Ball(y, slips)
    return MU * own.N - np.linalg.norm(own.pull)


def by_another_solver() -> np.ndarray:
    """The position, the velocities and the bristles at the end."""
    for event in (begins, limited):
        event.terminal = True  # type: ignore[attr-defined]
    begins.direction = -1  # type: ignore[attr-defined]
    t, y, slips = 0.0, np.array([0, 0, R - DEPTH, *V, *W, 0, 0, 0]), False
    while t < END:
        part = scipy.integrate.solve_ivp(
            lambda t, y, slips: Ball(y, slips).rates(), (t, END), y, "Radau", rtol=1e-10,
            atol=1e-13, events=(begins, limited), args=(slips,))
        t, y = part.t[-1], part.y[:, -1]
        if len(part.t_events[0]):
            slips = True
        elif part.status == 1 and slips and Ball(y, slips).out < 1e-9:
            slips = False  # the friction falls below its limit when the bristles begin to return
            y[9:12] *= Ball(y, slips).bound / np.linalg.norm(y[9:12]) * (1 - 1e-12)
        if part.status == 1:  # past the event
            y, t = y + 1e-12 * Ball(y, slips).rates(), t + 1e-12
    return y


@pytest.fixture(scope="module")
def truth() -> np.ndarray:
    return by_another_solver()


def test_it_ends_rolling(truth: np.ndarray) -> None:
    """At the speed that the moments about the surface leave, as if friction had no bristles."""
    v = np.array(V) - (np.array(V) + np.cross(W, TO_SURFACE)) / (1 + MASS * R**2 / INERTIA)
    assert truth[3:5] == pytest.approx(v[:2], rel=1e-9)


@pytest.mark.parametrize("integrator, step, within", [
    ("dop853", None, 1e-11), ("radau", None, 1e-10), ("leapfrog", 2e-5, 1e-8),
    ("rk4", 2e-5, 1e-9)])
def test_a_ball_slides_and_spins_until_it_rolls(truth: np.ndarray, tmp_path: Path, integrator: str,
                                                step: float | None, within: float) -> None:
    path = tmp_path / "ball.toml"
    path.write_text(SCENE)
    q = run(path, until=END, every=END / 2, integrator=integrator, step=step,
            precision="double").q[-1]
    assert np.abs(q[:3] - truth[:3]).max() < within
    assert np.abs(q[-3:] - truth[9:]).max() < within
