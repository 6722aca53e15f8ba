"""A scene's functions of many states, compiled when they pay, or found in the cache."""

from __future__ import annotations

import ctypes
import functools
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from coscrew_codegen.runtime import compilation, scene_library
from coscrew_codegen.runtime.caller_warnings import warn
from coscrew_codegen.runtime.request import Request

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

    request: Request  # of the functions of one state
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
            made = scene_library.compiled(replace(self.request, lanes=True), compilation.compiler())
            return ctypes.CDLL(made.library.opened._name)
        except compilation.CompilationError as error:
            warn(f"{self.request.name} computes many states one by one: {error}")
            return None
