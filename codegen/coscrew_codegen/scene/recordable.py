"""All names of a scene's quantities, and patterns of them in `record` and `expect`."""

from collections.abc import Sequence

from coscrew_codegen.scene.effect_quantities import quantities_by_name, states_of
from coscrew_codegen.scene.functions import QUANTITIES
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.patterns import is_pattern, matching
from coscrew_codegen.scene.recorded_quantities import (
    STATES,
    XYZ,
    QuantityError,
    coordinates,
    recorded,
    targets,
)
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import Of
from coscrew_codegen.scene.units import UNITS

_POSITIONS = tuple(name for name, (function, x) in QUANTITIES.items()
                   if [unit for unit, _ in function.components_of(x)] == ["m"] * 3)
"""Quantities whose components are called x, y and z, too."""


def recordable(scene: Scene) -> tuple[str, ...]:
    """The names of all quantities, each whole: q.elbow, energy, position.hand."""
    own = [joint.name for joint, _, _ in coordinates(scene)]
    return (*(name for name, (function, x) in QUANTITIES.items()
              if x.of is Of.SCENE and function.recorded_in(scene)),
            *(f"{quantity}.{joint}" for quantity in UNITS for joint in own),
            *(f"{STATES}.{x.name}" for x in states_of(scene)),
            *(f"{name}.{target}" for name, (function, x) in QUANTITIES.items()
              for target in targets(function, x, scene)),
            *quantities_by_name(scene))


def components(names: Sequence[str], scene: Scene) -> tuple[str, ...]:
    """The names of the quantities' columns: energy.kinetic, position.hand.2."""
    return tuple(column for name in names for column in recorded(name, scene).names)


def quantities_of(texts: Sequence[str], scene: Scene) -> tuple[str, ...]:
    """The quantities that texts name; patterns are replaced by all whole quantities that they
    match, or else by components.  Raises QuantityError for each text that names none."""
    result, errors = list[str](), []
    for text in texts:
        try:
            recorded(text, scene)
            names: tuple[str, ...] = (text,)
        except QuantityError as error:
            names = _matching(text, scene) if is_pattern(text) else ()
            if not names:
                errors.append(_unmatched(text, scene) if is_pattern(text) else str(error))
        result += [x for x in names if x == text or not (x in result or x in texts)]
    if errors:
        raise QuantityError("; ".join(errors))
    return tuple(result)


def _matching(pattern: str, scene: Scene) -> tuple[str, ...]:
    """The quantities that a pattern matches: whole ones, or else components, by number, or else
    x, y and z of positions."""
    whole = recordable(scene)
    parts = components(whole, scene)
    lettered = tuple(f"{name[:-1]}{XYZ[int(name[-1])]}" for name in parts
                     if name.partition(".")[0] in _POSITIONS)
    return matching(pattern, whole, parts, lettered)


def _unmatched(pattern: str, scene: Scene) -> str:
    whole = recordable(scene)
    return (f"{pattern!r} matches no quantity; "
            f"{did_you_mean(pattern, (*whole, *components(whole, scene)))}")
