"""Which files a scene's generation makes: arm.h, arm.c, and the package arm/."""

from __future__ import annotations

import keyword
from typing import TYPE_CHECKING

from coscrew_codegen.layout import Files
from coscrew_codegen.scene_functions import SceneFunctions
from coscrew_codegen.targets import scene_c, scene_python
from coscrew_codegen.targets.scene_text import check_names, printable

if TYPE_CHECKING:
    from coscrew_codegen.scene.scene import Scene


def scene_files(scene: Scene, functions: SceneFunctions, command: str = "") -> Files:
    """The files by path.  `command` makes them, as their first lines say.  Raises ValueError for a
    name that a C or Python file cannot bear."""
    banner = banner_of(scene.name, command)
    return c_files(functions, banner) | python_files(functions, banner)


def banner_of(name: str, command: str = "") -> str:
    """The first line of every file, as a comment's text."""
    made = printable(command or f"coscrew generate {name}.toml")
    return f"Made by `{made}`; changes are overwritten."


def c_files(functions: SceneFunctions, banner: str) -> Files:
    """arm.h and arm.c."""
    _check(functions)
    header, source = scene_c.texts(functions, banner)
    return {f"{functions.name}.h": header, f"{functions.name}.c": source}


def python_files(functions: SceneFunctions, banner: str) -> Files:
    """The package arm/."""
    _check(functions)
    package = scene_python.package(functions, banner)
    return {f"{functions.name}/{file}": text for file, text in package.items()}


def _check(functions: SceneFunctions) -> None:
    name = functions.name
    if not (name.isascii() and name.isidentifier()) or keyword.iskeyword(name):
        raise ValueError(f"scene {name!r}: a name that C and Python can import is wanted")
    check_names(functions)
