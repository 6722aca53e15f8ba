"""A scene's functions of many states, compiled when that is worthwhile, or loaded from the cache.
"""

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

PAYS = 1_000_000
"""States of a scene, in one call or several, that are computed one by one before its functions of
many states are compiled.  That takes 3.5 to 13 s of processor time (pendulum, quadruped), which
steps regain after 2 to 3 million states, forward dynamics of an arm after 30 million."""
CALLS = 65_536
"""Calls after which they are compiled even of few states: until then a call takes 40 to 60 us more.
"""
LOOKS = 16384
"""States after which the cache is asked for these functions: opening them takes 20 to 50 ms, which
steps regain after 11,000 to 17,000 states."""
LOOKING_CALLS = 512
"""Calls after which the cache is asked even for few states."""

_ONE_BY_ONE = ContextVar("_ONE_BY_ONE", default=False)


@contextmanager
def one_by_one() -> Iterator[None]:
    """Makes all kernels compute states one by one in the block: too few for compiling."""
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
    _calls: int = field(default=0, init=False)

    def function(self, name: str, states: int) -> CFuncPtr | None:
        """The function of this name, if it exists and is worthwhile for so many more states."""
        if _ONE_BY_ONE.get():
            return None
        self._met += states
        self._calls += 1
        library = (self._library if self._met >= PAYS or self._calls >= CALLS else
                   self._kept if self._met >= LOOKS or self._calls >= LOOKING_CALLS else None)
        return getattr(library, name, None)

    @functools.cached_property
    def _kept(self) -> ctypes.CDLL | None:
        """The library, if the cache has it."""
        try:
            library = scene_library.kept(self._wanted, compilation.compiler())
        except compilation.CompilationError:
            return None
        return ctypes.CDLL(library.library.opened._name) if library else None

    @property
    def _wanted(self) -> Request:
        return replace(self.request, lanes=True)

    @functools.cached_property
    def _library(self) -> ctypes.CDLL | None:
        """None where it cannot be compiled."""
        try:
            made = scene_library.compiled(self._wanted, compilation.compiler())
            return ctypes.CDLL(made.library.opened._name)
        except compilation.CompilationError as error:
            warn(f"{self.request.name} computes many states one by one: {error}")
            return None
