"""What a target is: given Programs, it returns files."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coscrew_codegen.library import Library
    from coscrew_codegen.scene_functions import SceneFunctions

Files = dict[str, str]  # by path in the output folder, with forward slashes


@dataclass(frozen=True)
class Target:
    """Files of one kind, which are made where all of `languages` are asked for.

    A file of this folder that calls one `TARGET` has added it."""

    name: str
    languages: tuple[str, ...]
    library: Callable[[Library], Files] | None = None  # what it makes of the library
    scene: Callable[[SceneFunctions, str], Files] | None = None  # of a scene, below a banner
    asked: bool = True  # by `coscrew generate`; else only by what compiles a scene in place
