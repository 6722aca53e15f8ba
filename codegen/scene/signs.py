"""Which signs run-time parameters must have: those of the numbers that scene files accept."""

from enum import Enum

from coscrew_codegen.parameter import Parameter
from coscrew_codegen.scene.scene import Scene


class Sign(Enum):
    """The numbers that a parameter may be."""

    POSITIVE = "a positive number"
    NONNEGATIVE = "0 or more"


def signs(scene: Scene) -> dict[str, Sign]:
    """The signs of the parameters that have one, by name: masses are positive, and effects say what
    their parameters are."""
    found = {body.inertia.mass.name: Sign.POSITIVE for body in scene.model.bodies
             if body.inertia and isinstance(body.inertia.mass, Parameter)}
    for applied in scene.effects:
        for described in applied.effect.parameters:
            if described.positive or described.nonnegative:
                value = applied.values.get(described.name)
                found |= {x.name: Sign.POSITIVE if described.positive else Sign.NONNEGATIVE
                          for x in (value if isinstance(value, tuple) else (value,))
                          if isinstance(x, Parameter)}
    return found
