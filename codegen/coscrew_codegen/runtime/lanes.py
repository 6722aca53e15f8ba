"""A scene's functions of many states, compiled when they pay, or found in the cache."""

from __future__ import annotations

import ctypes
import functools
import pickle
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.runtime import cache, compilation, load
from coscrew_codegen.runtime.console import doing

if TYPE_CHECKING:
    from _ctypes import CFuncPtr

PAYS = 4096
"""So many states of a scene, in one call or several, are computed one by one before its functions
of many states are compiled, which takes seconds."""

_ONE_BY_ONE = ContextVar("_ONE_BY_ONE", default=False)


@contextmanager
def one_by_one() -> Iterator[None]:
    """Compute states one by one within, those of all kernels: too few to pay for compiling."""
    before = _ONE_BY_ONE.set(True)
    try:
        yield
    finally:
        _ONE_BY_ONE.reset(before)


@dataclass
class CompiledLanes:
    """The functions of many states of a scene."""

    kernels: load.Kernels
    _met: int = field(default=0, init=False)  # states so far

    def function(self, name: str, states: int) -> CFuncPtr | None:
        """The function of this name, if it is there and pays for so many more states."""
        if _ONE_BY_ONE.get():
            return None
        self._met += states
        return getattr(self._library, name, None) if self._met >= PAYS else None

    @functools.cached_property
    def _library(self) -> ctypes.CDLL | None:
        """None where it cannot be compiled."""
        try:
            return ctypes.CDLL(_library(self.kernels, compilation.compiler()).opened._name)
        except compilation.CompilationError as error:
            compilation.warn(self.kernels.interface.name, error, "computes many states one by one")
            return None


def _library(kernels: load.Kernels, compiler: compilation.Compiler) -> compilation.CompiledLibrary:
    key = kernels.scene and load.key_of(kernels.scene, kernels.selected, kernels.precisions,
                                        compiler, "lanes", kernels.interface.mark)
    if key and (kept := load.kept_as(key)):
        return kept[1]
    library = _made(kernels, compiler)
    if key:
        cache.write(key, ".scene", pickle.dumps((kernels.interface, library.key)))
    return library


def _made(kernels: load.Kernels, compiler: compilation.Compiler) -> compilation.CompiledLibrary:
    from coscrew_codegen.accuracy.scene_tiers import in_tier  # imports SymPy
    from coscrew_codegen.backends.scene import scene_c, scene_c_many, scene_c_tier
    from coscrew_codegen.backends.scene.scene_text import banner_of

    functions, stem = (kernels.plain or kernels).functions, kernels.interface.name
    banner = banner_of(stem)
    with doing(f"writing {stem} for many states"):
        if kernels.plain:
            tier = in_tier(functions, tier_named(kernels.interface.mark))
            functions, stem = tier.plain, tier.stem
            files = scene_c.files(functions, banner) | scene_c_tier.files(tier, banner)
            files |= scene_c_many.tier_files(tier, banner)
        else:
            files = scene_c.files(functions, banner) | scene_c_many.files(functions, banner)
    return load.library_of(files, functions, f"{stem}_many{{f}}.c", compiler, kernels.precisions,
                           "-DKSL_LANES_ONLY", scene_c_many.LEVEL)
