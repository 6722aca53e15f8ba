"""The hopper of examples/scenes/hopper.toml: two masses, a spring, and Hertz's law with damping
while the foot touches; by DOP853, which starts anew where the foot touches the ground and where it
leaves it."""

from collections.abc import Iterator

import numpy as np
import scipy.integrate

from tests.references.figures import Figure, figure, printed
from tests.references.peer import TOLERANCE

TORSO, FOOT, G = 3.0, 0.3, 9.81  # kg, kg, m/s²
K, D, LENGTH, START = 2000.0, 12.0, 0.4, 0.45  # N/m, N s/m, m, m
THRUST, BEAT = 60.0, 2.5  # N, Hz
DEPTH, ALPHA = 1e-3, 1.0  # m, s/m: the defaults
STIFFNESS = (TORSO + FOOT) * G / DEPTH**1.5
TIMES = (0.5, 1.0, 2.0, 9.6, 10.0)


def push(y: np.ndarray) -> float:
    """The force of the ground at (height, leg, their rates)."""
    depth = max(LENGTH - y[0] - y[1], 0)
    return float(STIFFNESS * depth**1.5 * max(1 - 1.5 * ALPHA * (y[2] + y[3]), 0))


def rates(t: float, y: np.ndarray) -> np.ndarray:
    """The rates of the torso's height, of the leg's shortening, and of their rates."""
    leg = -K * y[1] - D * y[3] - THRUST * np.sin(2 * np.pi * BEAT * t)
    torso = -G - leg / TORSO
    return np.array([y[2], y[3], torso, -G + (push(y) + leg) / FOOT - torso])


def touches(_: float, y: np.ndarray) -> float:
    """Zero where the foot touches."""
    return float(y[0] + y[1] - LENGTH)


def figures(times: tuple[float, ...] = TIMES, tolerance: float = TOLERANCE) -> Iterator[Figure]:
    """The height of the torso and the shortening of the leg."""
    touches.terminal = True  # type: ignore[attr-defined]
    t, y = 0.0, np.array([START, 0.0, 0.0, 0.0])
    for at in times:
        while t < at:
            run = scipy.integrate.solve_ivp(rates, (t, at), y, "DOP853", rtol=tolerance,
                                            atol=tolerance, events=touches, max_step=2e-3)
            t, y = float(run.t[-1]), run.y[:, -1]
            if run.status == 1:  # at the ground: on to the other side of the event
                y[1] += np.copysign(1e-14, y[2] + y[3]) - touches(t, y)
        yield figure("q.rail", at, float(y[0]))
        yield figure("q.leg", at, float(y[1]))


if __name__ == "__main__":
    printed("hopper", f"SciPy's DOP853, rtol {TOLERANCE:g}.", figures())
