"""The block of examples/scenes/stick_slip.toml: m x'' = k (c t - x) - friction(x'), by DOP853."""

import math
from collections.abc import Iterator

import numpy as np

from tests.references.figures import Figure, figure, printed
from tests.references.peer import TOLERANCE, solved

MASS, SPRING, PULL = 1.0, 40.0, 0.1  # kg, N/m, m/s
SLIDING, STICKING, FALL, REST = 2.0, 4.0, 0.05, 5e-3  # N, N, m/s, m/s
TIMES = (0.5, 1.0, 1.1, 1.2, 2.0, 3.0, 4.0, 5.0)


def friction(speed: float) -> float:
    """Stribeck friction, smooth where the block changes direction."""
    level = SLIDING + (STICKING - SLIDING) * math.exp(-(speed / FALL)**2)
    return level * math.tanh(speed / REST)


def rates(t: float, y: np.ndarray) -> np.ndarray:
    """(x', x'')."""
    return np.array([y[1], (SPRING * (PULL * t - y[0]) - friction(y[1])) / MASS])


def figures(times: tuple[float, ...] = TIMES, tolerance: float = TOLERANCE) -> Iterator[Figure]:
    """Position and speed of the block."""
    for t, (x, speed) in zip(times, solved(rates, (0, 0), times, tolerance), strict=True):
        yield figure("q.table", t, float(x))
        yield figure("v.table", t, float(speed))


if __name__ == "__main__":
    printed("stick_slip", f"SciPy's DOP853, rtol {TOLERANCE:g}.", figures())
