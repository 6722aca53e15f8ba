"""Signs that run-time parameters must have: the signs that scene files require of the same numbers.
"""

from coscrew_codegen.program.values.parameter import Parameter, Sign
from coscrew_codegen.scene.scene import Scene


def signs(scene: Scene) -> dict[str, Sign]:
    """The signs of the parameters that have one, by name: masses are positive, and effects say what
    their parameters are."""
    results = {body.inertia.mass.name: Sign.POSITIVE for body in scene.model.bodies
               if body.inertia and isinstance(body.inertia.mass, Parameter)}
    for applied in scene.effects:
        for described in applied.effect.parameters:
            if described.sign:
                value = applied.values.get(described.name)
                results |= {x.name: described.sign
                            for x in (value if isinstance(value, tuple) else (value,))
                            if isinstance(x, Parameter)}
    return results
