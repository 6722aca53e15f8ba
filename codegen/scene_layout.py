"""Which targets a scene's generation runs: all that there are for scenes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from coscrew_codegen.layout import Files
from coscrew_codegen.scene_functions import SceneFunctions
from coscrew_codegen.targets import scene_c, scene_python
from coscrew_codegen.targets.scene_text import printable

if TYPE_CHECKING:
    from coscrew_codegen.scene.scene import Scene

TARGETS: dict[str, Callable[[SceneFunctions, str], Files]] = {
    "c": scene_c.files, "python": scene_python.files}
"""By language: from functions and the first line's text to files by path."""


def scene_files(scene: Scene, functions: SceneFunctions, command: str = "") -> Files:
    """The files by path.  `command` makes them, as their first lines say.  Raises ValueError for a
    name that a C or Python file cannot bear."""
    banner = banner_of(scene.name, command)
    return {path: text for files in TARGETS.values()
            for path, text in files(functions, banner).items()}


def banner_of(name: str, command: str = "") -> str:
    """The first line of every file, as a comment's text."""
    made = printable(command or f"coscrew generate {name}.toml")
    return f"Made by `{made}`; changes are overwritten."
