"""The ball of examples/scenes/bouncing_ball.toml: free fall, and Hertz's law with damping while it
touches; by DOP853, which starts anew where the ball touches the ground and where it leaves it."""

import math
from collections.abc import Iterator

import numpy as np
import scipy.integrate
import scipy.optimize

from tests.references.figures import Figure, figure, printed
from tests.references.peer import TOLERANCE

MASS, RADIUS, G, HEIGHT = 1.0, 0.1, 9.81, 1.1  # kg, m, m/s², m
DEPTH, KEPT, SPEED = 1e-3, 0.7, 4.4  # m, 1, m/s
STIFFNESS = MASS * G / DEPTH**1.5
TIMES = (0.4, 0.7, 1.2, 1.5, 2.0)


def damping() -> float:
    """alpha of the restitution: (1 + e) y = log((1 + y)/(1 - e y)), y = 1.5 alpha v."""
    def beyond(y: float) -> float:
        return (1 + KEPT) * y - math.log((1 + y) / (1 - KEPT * y))

    return float(scipy.optimize.brentq(beyond, 1e-3, 1 / KEPT - 1e-9)) / (1.5 * SPEED)


def figures(times: tuple[float, ...] = TIMES, tolerance: float = TOLERANCE) -> Iterator[Figure]:
    """The height of the ball, and its speed."""
    alpha, t, y = damping(), 0.0, np.array([HEIGHT, 0.0])

    def rates(_: float, y: np.ndarray) -> np.ndarray:
        depth = max(RADIUS - y[0], 0)
        push = STIFFNESS * depth**1.5 * max(1 - 1.5 * alpha * y[1], 0)
        return np.array([y[1], push / MASS - G])

    def touches(_: float, y: np.ndarray) -> float:
        return float(y[0] - RADIUS)

    touches.terminal = True  # type: ignore[attr-defined]
    for at in times:
        while t < at:
            run = scipy.integrate.solve_ivp(rates, (t, at), y, "DOP853", rtol=tolerance,
                                            atol=tolerance, events=touches, max_step=1e-3)
            t, y = float(run.t[-1]), run.y[:, -1]
            if run.status == 1:  # at the ground: on to the other side of the event
                y[0] = RADIUS + math.copysign(1e-15, y[1])
        yield figure("q.free.2", at, float(y[0]))
        yield figure("v.free.2", at, float(y[1]))


if __name__ == "__main__":
    printed("bouncing_ball", f"SciPy's DOP853, rtol {TOLERANCE:g}.", figures())
