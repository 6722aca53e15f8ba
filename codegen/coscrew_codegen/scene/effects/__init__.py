"""The effects of scenes, one per module."""

import copyreg

from coscrew_codegen.program.plugins import discover
from coscrew_codegen.scene.effect import Effect

EFFECTS: tuple[Effect, ...] = tuple(sorted(
    discover(__name__, __path__, "EFFECT", Effect), key=lambda x: x.name))
"""The catalogue, by name: adding or deleting a module adds or removes its effect."""


def effect_named(name: str) -> Effect:
    """The effect of this name.  Raises KeyError if there is none."""
    return {effect.name: effect for effect in EFFECTS}[name]


def _pickled(effect: Effect) -> str | tuple[object, ...]:
    """An effect of the catalogue is pickled by its name, since its functions cannot be."""
    if any(known is effect for known in EFFECTS):
        return effect_named, (effect.name,)
    return object.__reduce_ex__(effect, 2)


copyreg.pickle(Effect, _pickled)  # type: ignore[arg-type]  # object's own reductions are any tuple
