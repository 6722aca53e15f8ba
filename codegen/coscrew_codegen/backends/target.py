"""Targets: functions from Programs to files."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coscrew_codegen.accuracy.fixed_scene import FixedScene
    from coscrew_codegen.accuracy.scene_tiers import SceneTier
    from coscrew_codegen.backends.library import Library
    from coscrew_codegen.program.scene_functions import SceneFunctions

Files = dict[str, str]  # path in the output folder, with forward slashes → text


@dataclass(frozen=True)
class Target:
    """Files of one kind, made if all of `languages` are selected.

    A module of this package that assigns one to `TARGET` adds it."""

    name: str
    languages: tuple[str, ...]
    library: Callable[[Library], Files] | None = None  # its files of the library
    scene: Callable[[SceneFunctions, str], Files] | None = None  # of a scene, with this banner
    tier: Callable[[SceneTier, str], Files] | None = None  # of a scene in a tier besides plain
    fixed: Callable[[FixedScene, str], Files] | None = None  # of a scene in fixed point
    many: Callable[[SceneFunctions, str], Files] | None = None  # of its functions of many states
    many_tier: Callable[[SceneTier, str], Files] | None = None  # the same in a tier
    many_fixed: Callable[[FixedScene, str], Files] | None = None  # the same in fixed point
    cuda: Callable[[SceneFunctions, str], Files] | None = None  # of its functions for CUDA
    cuda_tier: Callable[[SceneTier, str], Files] | None = None  # the same in a tier
    cuda_fixed: Callable[[FixedScene, str], Files] | None = None  # the same in fixed point
    generated: bool = True  # whether `coscrew generate` makes them; else only `load_scene` does
