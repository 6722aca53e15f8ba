"""Requests: the functions that are wanted as callables.

Each derived function of a scene is cached by itself, so that requests for other functions of the
scene derive only those that none has derived.
"""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.program.plugins import holder
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.runtime import cache, sources
from coscrew_codegen.runtime.cache import packed, unpacked
from coscrew_codegen.runtime.console import doing
from coscrew_codegen.scene import effects, joints
from coscrew_codegen.scene.scene import Scene

if TYPE_CHECKING:
    from coscrew_codegen.accuracy.scene_tiers import SceneTier
    from coscrew_codegen.dynamics.derivation import Keep

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

            return derive(scene, selected, lambda name: tell(f"deriving {name}"), _keep(scene))

    return Request(scene.name, scene, selected, precisions, functions)


def made_from(scene: Scene, maker: str) -> str:
    """The hash of the sources from which a module makes something of the scene; "" if an effect or
    a kind of joint is not in its catalogue, since its name does not identify its equations."""
    used = {effects.__name__: {
        holder(effects.__name__, "EFFECT", x.effect) for x in scene.effects},
        joints.__name__: {holder(joints.__name__, "JOINT", x.kind) for x in scene.model.joints}}
    if any("" in modules for modules in used.values()):
        return ""
    return sources.digest_of(maker, chosen=used)


def _keep(scene: Scene) -> Keep:
    """Finds derived functions in the cache, or adds them to it.  They do not depend on what else is
    selected."""
    digest = made_from(scene, "coscrew_codegen.dynamics.derivation")
    content = replace(scene, functions=(), tiers=()).content_hash

    def keep(name: str, make: Callable[[], FunctionProgram]) -> FunctionProgram:
        made: list[FunctionProgram] = []

        def packed_here() -> bytes:
            made.append(make())
            return packed(made[0])

        def read(path: Path) -> FunctionProgram:
            function: FunctionProgram = made[0] if made else unpacked(path.read_bytes())
            return function

        key = cache.key_of(digest, content, str(sys.hash_info), name)  # constants hold their hash
        return cache.cached(key, ".function", packed_here, read)

    return keep if digest else lambda name, make: make()


def of_functions(functions: SceneFunctions) -> Request:
    """The request for functions that are derived."""
    return Request(functions.name, None, (), BOTH, lambda: functions)
