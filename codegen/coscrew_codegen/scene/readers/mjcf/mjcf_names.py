"""Names of a model of MuJoCo, which gives none to some elements; and its numbers, exactly."""

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

from coscrew_codegen.scene.mechanism.model import WORLD
from coscrew_codegen.scene.readers.decimals import decimal

if TYPE_CHECKING:
    import mujoco

_SMALLEST = 1e-300


class MjcfNames:
    """The names of bodies and joints: their own, or body3, joint7."""

    def __init__(self, model: "mujoco.MjModel") -> None:
        self._taken: set[str] = set()
        self._bodies = [WORLD, *(self.new(model.body(i).name or f"body{i}")
                                 for i in range(1, model.nbody))]
        self._joints = [self.new(model.joint(j).name or f"joint{j}") for j in range(model.njnt)]

    def body(self, number: int) -> str:
        """The name of a body."""
        return self._bodies[number]

    def joint(self, number: int) -> str:
        """The name of a joint."""
        return self._joints[number]

    def new(self, name: str) -> str:
        """The name, with _ after it if it is taken."""
        while name in self._taken or name == WORLD:
            name += "_"
        self._taken.add(name)
        return name


def exact(numbers: Iterable[float]) -> tuple[Fraction, ...]:
    """The shortest decimals that give these numbers: what their file says of 0.1."""
    return tuple(decimal(repr(float(x))) if abs(x) > _SMALLEST else Fraction(0) for x in numbers)
