"""examples/scenes/arm6.toml, by Pinocchio's dynamics, effects written by hand, and DOP853."""

from collections.abc import Iterator

from tests.references import robots
from tests.references.figures import Figure, printed
from tests.references.peer import TOLERANCE

TIMES = (0.1, 0.5, 1.0, 1.5, 2.0)


def figures(times: tuple[float, ...] = TIMES, tolerance: float = TOLERANCE) -> Iterator[Figure]:
    """All joints, energy, and the reaction of the shoulder."""
    robot = robots.Robot("arm6")
    yield from robots.figures(robot, tuple(robot.joints), "lift", times, tolerance)


if __name__ == "__main__":
    printed("arm6", f"Pinocchio and SciPy's DOP853, rtol {TOLERANCE:g}.", figures())
