"""The effects scenes may call for, a file each.

Three more have a place of their own: contact of a point with the ground fills `body_force`; added
mass needs a slot for a body's 6×6 inertia in `Effect`, beside `joint_inertia`; closed loops need
multipliers, hence a slot for rows of constraints, which forward dynamics then solves for.
"""

import copyreg

from coscrew_codegen.found import found
from coscrew_codegen.scene.effect import Effect

EFFECTS: tuple[Effect, ...] = found(__name__, __path__, "EFFECT", Effect)
"""The catalogue, by name: a file put here is in it, one taken away is gone without a trace."""


def effect_named(name: str) -> Effect:
    """The effect of this name; a KeyError if there is none."""
    return {effect.name: effect for effect in EFFECTS}[name]


def _pickled(effect: Effect) -> str | tuple[object, ...]:
    """An effect of the catalogue is pickled by its name, since its functions cannot be."""
    if any(known is effect for known in EFFECTS):
        return effect_named, (effect.name,)
    return object.__reduce_ex__(effect, 2)


copyreg.pickle(Effect, _pickled)  # type: ignore[arg-type]  # object's own reductions are any tuple
