"""The effects scenes may call for, a file each."""

from importlib import import_module
from pkgutil import iter_modules

from coscrew_codegen.effects.effect import Effect

EFFECTS: tuple[Effect, ...] = tuple(
    import_module(f"{__name__}.{module}").EFFECT
    for module in sorted(found.name for found in iter_modules(__path__)) if module != "effect")
"""The catalogue, by name: a file put here is in it, one taken away is gone without a trace."""
