"""Requests: the functions that are wanted as callables."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.runtime.console import doing
from coscrew_codegen.scene.scene import Scene

if TYPE_CHECKING:
    from coscrew_codegen.accuracy.scene_tiers import SceneTier

BOTH = tuple(p.name for p in PRECISIONS)


@dataclass(frozen=True)
class Request:
    """Functions of a scene that are wanted as callables.

    `functions` derives them when it is called first.  `scene` is None if they are given: the cache
    then has only their library, by its text."""

    name: str
    scene: Scene | None
    selected: tuple[str, ...]  # their names; (): those that the scene selects
    precisions: tuple[str, ...]
    functions: Callable[[], SceneFunctions]
    tier: str = ""  # the plain one
    lanes: bool = False  # whether of many states at once

    @property
    def title(self) -> str:
        """The name of the scene and the tier."""
        return f"{self.name} in the {self.tier} tier" if self.tier else self.name

    def programs(self) -> SceneFunctions | SceneTier:
        """The functions as Programs, in their tier."""
        functions = self.functions()
        if not self.tier:
            return functions
        from coscrew_codegen.accuracy.scene_tiers import in_tier  # imports SymPy
        from coscrew_codegen.accuracy.tiers import tier_named

        with doing(f"deriving the {self.tier} tier of {self.name}"):
            return in_tier(functions, tier_named(self.tier))


def of_scene(scene: Scene, selected: tuple[str, ...], precisions: tuple[str, ...]) -> Request:
    """The request for a scene's functions of these names."""
    @functools.cache
    def functions() -> SceneFunctions:
        with doing(f"deriving {scene.name}") as tell:
            from coscrew_codegen.dynamics import derive  # imports SymPy

            return derive(scene, selected, lambda name: tell(f"deriving {name}"))

    return Request(scene.name, scene, selected, precisions, functions)


def of_functions(functions: SceneFunctions) -> Request:
    """The request for functions that are derived."""
    return Request(functions.name, None, (), BOTH, lambda: functions)
