"""The way from a request to functions in memory: request → Programs → text → library.

`compiled` asks the cache before anything else, so that what is found there imports no stage of
that way.  Where nothing compiles, `in_numpy` goes the same way to modules of Python.
"""

import ctypes
import importlib
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import util
from pathlib import Path
from types import ModuleType

from coscrew_codegen.backends import emit
from coscrew_codegen.program.scene_functions import SceneFunctions, SceneInterface
from coscrew_codegen.program.text_module import imported
from coscrew_codegen.program.values.formats import named
from coscrew_codegen.runtime import cache, compilation
from coscrew_codegen.runtime.cache import packed, unpacked
from coscrew_codegen.runtime.caller_warnings import warn
from coscrew_codegen.runtime.compilation import CompiledLibrary, Compiler
from coscrew_codegen.runtime.request import Request, made_from

_SUFFIX = ".scene"


@dataclass(frozen=True)
class SceneLibrary:
    """The compiled functions of a request."""

    interface: SceneInterface
    library: CompiledLibrary
    checks: str  # the text in Python that checks arguments


def compiled(request: Request, using: Compiler) -> SceneLibrary:
    """The functions in C: found in the cache, or derived, written and compiled.  Raises
    CompilationError."""
    key = key_of(request, using)
    if not key:
        return _made(request, using)

    def made() -> bytes:
        result = _made(request, using)
        return packed((result.interface, result.library.key, result.checks))

    return cache.cached(key, _SUFFIX, made, _read)


def kept(request: Request, using: Compiler) -> SceneLibrary | None:
    """The functions in C, if the cache has them."""
    key = key_of(request, using)
    return cache.kept_as(key, _SUFFIX, _read) if key else None


def key_of(request: Request, using: Compiler) -> str:
    """The cache key: a hash of all that the functions are made from.  "" if they are given, or if
    the scene's sources are not known."""
    scene = request.scene
    if scene is None:
        return ""
    if not (digest := made_from(scene, __name__)):
        return ""
    return cache.key_of(digest, scene.content_hash, *compilation.place(using),
                        " ".join(request.precisions), *request.selected,
                        f"tier {request.tier}", f"lanes {request.lanes}")


def _made(request: Request, using: Compiler) -> SceneLibrary:
    from coscrew_codegen.runtime import source_text  # imports SymPy and Jinja

    text = source_text.in_c(request)
    checks = source_text.checks()
    return SceneLibrary(text.interface, compilation.library(
        text.units(request.precisions), text.files, using), checks)


def _read(path: Path) -> SceneLibrary:
    """Reads an entry.  Raises LookupError if its library is not in the cache."""
    interface, key, checks = unpacked(path.read_bytes())
    library = compilation.kept(key)
    if library is None:
        raise LookupError(key)
    return SceneLibrary(interface, library, checks)


def opened(name: str, units: Mapping[str, Sequence[str]], files: Mapping[str, str]
           ) -> ctypes.CDLL | None:
    """The library of these texts, whose functions run without Python's global lock; None, with a
    warning, where nothing compiles."""
    try:
        return ctypes.CDLL(compilation.library(units, files, compilation.compiler()).opened._name)
    except compilation.CompilationError as error:
        warn(f"{name} is computed by calls of the array library: {error}")
        return None


def in_numpy(request: Request) -> tuple[SceneInterface, Mapping[str, ModuleType]]:
    """The functions in NumPy: their interface, and a module for each precision, imported from a
    folder of the cache."""
    from coscrew_codegen.runtime import source_text

    text = source_text.in_numpy(request)
    key = cache.key_of(*(x for pair in sorted(text.files.items()) for x in pair))
    folder = cache.folder() / f"python-{key}"
    emit.write(text.files, folder)
    name = f"_coscrew_scene_{key}"
    if name not in sys.modules:
        init = folder / request.name / "__init__.py"
        spec = util.spec_from_file_location(
            name, init, submodule_search_locations=[str(init.parent)])
        assert spec and spec.loader
        sys.modules[name] = module = util.module_from_spec(spec)
        spec.loader.exec_module(module)
    inner = (name, request.tier) if request.tier else (name,)
    return text.interface, {p.name: importlib.import_module(".".join((*inner, p.name)))
                            for p in named(text.plain.precisions)}


def in_fixed_point(functions: SceneFunctions, tier: str) -> ModuleType:
    """The functions in fixed point: the module arm/fixed.py of the generated package, in memory.
    Raises NoFunctionsError."""
    from coscrew_codegen.accuracy.fixed_scene import in_fixed
    from coscrew_codegen.accuracy.tiers import tier_named
    from coscrew_codegen.backends.fixed import scene_python_fixed
    from coscrew_codegen.backends.scene.scene_text import banner_of

    made = in_fixed(functions, tier_named(tier))
    ((_, text),) = scene_python_fixed.files(made, banner_of(functions.name)).items()
    return imported(f"{functions.name}.{tier}", text)
