"""Names of a model of MuJoCo, which gives none to some elements; and its numbers, exactly."""

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.mechanism.model import WORLD
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals

if TYPE_CHECKING:
    import mujoco

_SMALLEST = 1e-300
_KEYS = {x.name for effect in EFFECTS for x in effect.parameters} | {"joints"}
"""Names of parameters, which labels must not have."""


class MjcfNames:
    """The names of bodies and of joints, which may coincide: their own, or body3, joint7; that of
    its body for a free joint."""

    def __init__(self, model: "mujoco.MjModel") -> None:
        self._taken: tuple[set[str], set[str]] = ({WORLD}, set())
        self._bodies = [WORLD, *(self.new_body(model.body(i).name or f"body{i}")
                                 for i in range(1, model.nbody))]
        given = {model.joint(j).name for j in range(model.njnt)}
        self._joints = [model.joint(j).name or _new(self._unnamed(model, j), given)
                        for j in range(model.njnt)]
        self._taken[1].update(self._joints)
        labels = {*self._taken[1], *_KEYS}
        self._tendons = [_new(model.tendon(t).name or f"tendon{t}", labels)
                         for t in range(model.ntendon)]
        self._equalities = [_new(model.equality(e).name or f"equality{e}", {
            model.equality(k).name for k in range(model.neq) if k != e}) for e in range(model.neq)]
        labels = {*self._taken[1], *_KEYS}
        self._actuators = [_new(model.actuator(i).name or f"actuator{i}", labels)
                           for i in range(model.nu)]

    def body(self, number: int) -> str:
        """The name of a body."""
        return self._bodies[number]

    def joint(self, number: int) -> str:
        """The name of a joint."""
        return self._joints[number]

    def tendon(self, number: int) -> str:
        """The label of effects on a tendon."""
        return self._tendons[number]

    def equality(self, number: int) -> str:
        """The name of the loop that an equality closes."""
        return self._equalities[number]

    def actuator(self, number: int) -> str:
        """The label of an actuator."""
        return self._actuators[number]

    def _unnamed(self, model: "mujoco.MjModel", joint: int) -> str:
        import mujoco

        free = model.jnt_type[joint] == int(mujoco.mjtJoint.mjJNT_FREE)
        return self.body(int(model.jnt_bodyid[joint])) if free else f"joint{joint}"

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


def decimals(numbers: Iterable[float]) -> list[Decimals]:
    """The numbers as a file of TOML holds them."""
    return [Decimals(repr(float(x))) for x in numbers]


def one_coordinate(model: "mujoco.MjModel") -> list[int]:
    """The joints that turn about an axis or slide."""
    import mujoco

    kinds = (int(mujoco.mjtJoint.mjJNT_SLIDE), int(mujoco.mjtJoint.mjJNT_HINGE))
    return [j for j in range(model.njnt) if int(model.jnt_type[j]) in kinds]
