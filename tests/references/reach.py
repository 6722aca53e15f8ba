"""The carriage of examples/scenes/reach.toml: m x'' = motor - d x', the target by SciPy's monotone
cubic, by DOP853 from point to point."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from scipy.interpolate import PchipInterpolator

from tests.references.figures import Figure, figure, printed
from tests.references.peer import TOLERANCE, solved

MASS, STIFFNESS, DAMPING, FRICTION = 2.0, 800.0, 60.0, 3.0
LIMIT, NO_LOAD = 8.0, 1.5
TIMES = (0.8, 1.4, 2.0, 3.0)
TABLE = np.loadtxt(Path(__file__).parents[2] / "examples/scenes/reach.csv", delimiter=",",
                   skiprows=2)
TARGET = PchipInterpolator(*TABLE.T)


def motor(t: float, x: float, v: float) -> float:
    """The force of the PD controller, within what the motor gives at this speed."""
    held = min(max(t, TABLE[0, 0]), TABLE[-1, 0])
    rate = TARGET(held, 1) if held == t else 0.0
    u = STIFFNESS * (TARGET(held) - x) + DAMPING * (rate - v)
    most = LIMIT * (max(1 - abs(v) / NO_LOAD, 0) if u * v > 0 else 1)
    return float(np.clip(u, -most, most))


def rates(t: float, y: np.ndarray) -> np.ndarray:
    """(x', x'')."""
    x, v = y
    return np.array([v, (motor(t, x, v) - FRICTION * v) / MASS])


def figures(times: tuple[float, ...] = TIMES, tolerance: float = TOLERANCE) -> Iterator[Figure]:
    """Position and speed of the carriage."""
    for t, (x, v) in zip(times, solved(rates, (0, 0), times, tolerance), strict=True):
        yield figure("q.rail", t, float(x))
        yield figure("v.rail", t, float(v))


if __name__ == "__main__":
    printed("reach", f"SciPy's DOP853 and PchipInterpolator, rtol {TOLERANCE:g}.", figures())
