"""Numbers of a scene as those of a picture, and turns of its parts."""

import numpy as np

from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.scene import Applied
from coscrew_codegen.simulation.system import System


def numbers_of(system: System, values: tuple[Scalar, ...]) -> np.ndarray:
    """The numbers, with the system's parameters."""
    return np.array([number_of(system, x) for x in values])


def number_of(system: System, value: Scalar) -> float:
    """The number, with the system's parameters."""
    return system.p[value.index] if isinstance(value, Parameter) else float(value)


def value_of(system: System, applied: Applied, name: str) -> float:
    """The effect's number of this name; 0 where it has none."""
    value = applied.values[name]
    return number_of(system, value) if isinstance(value, Scalar) else 0.0


def along(place: np.ndarray, direction: np.ndarray) -> tuple[float, ...]:
    """The place, and the quaternion x, y, z, w that turns z to the direction."""
    x, y, z = direction / np.linalg.norm(direction)
    turn = np.array([-y, x, 0.0, 1 + z]) if z > -1 + 1e-9 else np.array([1.0, 0, 0, 0])
    return (*place.tolist(), *(turn / np.linalg.norm(turn)).tolist())
