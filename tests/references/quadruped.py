"""examples/scenes/quadruped.toml, by Pinocchio's dynamics, effects written by hand, and DOP853."""

from collections.abc import Iterator

from tests.references import robots
from tests.references.figures import Figure, printed
from tests.references.peer import TOLERANCE

TIMES = (0.05, 0.2, 0.35, 0.5)
_JOINTS = ("fl_abduct", "fl_swing", "fl_knee", "rr_swing")


def figures(times: tuple[float, ...] = TIMES, tolerance: float = TOLERANCE) -> Iterator[Figure]:
    """Pose of the trunk, some joints, energy, and the reaction of a knee."""
    yield from robots.figures(robots.Robot("quadruped"), _JOINTS, "fl_knee", times, tolerance)


if __name__ == "__main__":
    printed("quadruped", f"Pinocchio and SciPy's DOP853, rtol {TOLERANCE:g}.", figures())
