"""Variants of a scene: with all its effects, without each of them, and without any."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from coscrew_codegen.dynamics.derive_functions import derive
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.scene.function_selection import FREE, selected_functions, together
from coscrew_codegen.scene.integrators import EMITTED
from coscrew_codegen.scene.mechanism.inertia_checks import why_singular
from coscrew_codegen.scene.scene import Applied, Scene

WHOLE = "all effects"
SHOWN = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
"""The functions whose cost is shown for each effect."""


@dataclass(frozen=True)
class Ablation:
    """A scene with some of its effects."""

    words: str  # "all effects", "without gravity", "bare"
    scene: Scene
    functions: SceneFunctions

    @property
    def public(self) -> tuple[FunctionProgram, ...]:
        """The functions that are declared."""
        return tuple(f for f in self.functions.functions if not f.internal)


def parts(scene: Scene, requested: Sequence[str] = ()) -> tuple[Ablation, ...]:
    """The scene with all its effects and the requested functions;

    without each effect; and without any.  Effects that change the coordinates (mimic) always stay.
    """
    chosen = [(WHOLE, scene.effects), *_fewer(scene)]
    return tuple(part(words, replace(scene, effects=effects),
                      whole(scene, requested) if words == WHOLE else SHOWN)
                 for words, effects in chosen)


def _fewer(scene: Scene) -> list[tuple[str, tuple[Applied, ...]]]:
    """Yields the variants without each effect, and without any: words, and the remaining effects.
    An effect without which the mass matrix is singular (an armature) always stays."""
    names = tuple(dict.fromkeys(x.effect.name for x in scene.effects if _optional(x)))
    chosen = []
    if len(names) > 1:
        chosen += [(f"without {name}", tuple(x for x in scene.effects if x.effect.name != name))
                   for name in names]
    if names:
        chosen.append(("bare", tuple(x for x in scene.effects if not _optional(x))))
    return [(words, effects) for words, effects in chosen
            if not why_singular(replace(scene, effects=effects))]


def leaving_out(scene: Scene, functions: Sequence[str]) -> Iterator[tuple[str, SceneFunctions]]:
    """Derives the functions of the scene without each effect, and without any: (words, functions).
    """
    for words, effects in _fewer(scene):
        yield words, derive(replace(scene, effects=effects), functions)


def part(words: str, scene: Scene, functions: Sequence[str]) -> Ablation:
    """The scene with these functions, as far as it has them."""
    return Ablation(words, scene, derive(scene, functions))


def whole(scene: Scene, requested: Sequence[str] = ()) -> tuple[str, ...]:
    """The functions of the scene with all its effects: selected ones, requested ones, SHOWN ones,
    and the steps of all integrators."""
    return together(selected_functions(scene), requested, SHOWN, (x.step_name for x in EMITTED),
                    ("energy",), FREE)


def _optional(applied: Applied) -> bool:
    """Returns whether the effect can be left out and adds to the cost of functions."""
    return not (applied.effect.mimic or applied.effect.reaction)
