"""Which files a scene's generation makes: arm.h, arm.c, and the package arm/."""

from __future__ import annotations

import keyword
from typing import TYPE_CHECKING

from coscrew_codegen.dynamics.function import SceneFunctions
from coscrew_codegen.layout import Files
from coscrew_codegen.targets import scene_c, scene_python

if TYPE_CHECKING:
    from coscrew_codegen.dynamics.scene import Scene


def scene_files(scene: Scene, functions: SceneFunctions, command: str = "") -> Files:
    """The files by path.  `command` made them, as their first lines say.  Raises ValueError for a
    name that a C or Python file cannot bear."""
    banner = f"Made by `{command or f'coscrew generate {scene.name}.toml'}`; changes are overwritten."
    return function_files(functions, banner)


def function_files(functions: SceneFunctions, banner: str) -> Files:
    """The files of functions, wherever they come from."""
    name = functions.name
    if not (name.isascii() and name.isidentifier()) or keyword.iskeyword(name):
        raise ValueError(f"scene {name!r}: a name that C and Python can import is wanted")
    package = scene_python.package(functions, banner)
    return {f"{name}.h": scene_c.header(functions, banner),
            f"{name}.c": scene_c.source(functions, banner),
            **{f"{name}/{file}": text for file, text in package.items()}}
