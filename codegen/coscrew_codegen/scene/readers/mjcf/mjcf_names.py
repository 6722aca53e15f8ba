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
    """The names of bodies and of joints, which may coincide: their own, or body3, joint7."""

    def __init__(self, model: "mujoco.MjModel") -> None:
        self._taken: tuple[set[str], set[str]] = ({WORLD}, set())
        self._bodies = [WORLD, *(self.new_body(model.body(i).name or f"body{i}")
                                 for i in range(1, model.nbody))]
        self._joints = [self.new_joint(model.joint(j).name or f"joint{j}")
                        for j in range(model.njnt)]

    def body(self, number: int) -> str:
        """The name of a body."""
        return self._bodies[number]

    def joint(self, number: int) -> str:
        """The name of a joint."""
        return self._joints[number]

    def new_body(self, name: str) -> str:
        """The name for a further body, with _ after it if it is taken."""
        return _new(name, self._taken[0])

    def new_joint(self, name: str) -> str:
        """The name for a further joint, likewise."""
        return _new(name, self._taken[1])


def _new(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    taken.add(name)
    return name


def exact(numbers: Iterable[float]) -> tuple[Fraction, ...]:
    """The shortest decimals that give these numbers: what their file says of 0.1."""
    return tuple(decimal(repr(float(x))) if abs(x) > _SMALLEST else Fraction(0) for x in numbers)
