"""Caches what is derived from each family of operations, so that only changed families are derived
again.

An entry is the result of one function for one family.  Its key is the hash of all that this depends
on: the sources that the function's module and the library's import, where of the operations only
those count that the family's own modules import.  `coscrew generate --check` derives everything.
"""

from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TypeVar, cast

from coscrew_codegen.accuracy.tiers.certified_rotations import DEFECT, ROTATIONS
from coscrew_codegen.algebra import operations
from coscrew_codegen.algebra.operations import OPERATIONS, contributors, family_named
from coscrew_codegen.backends.library import FamilyKernels
from coscrew_codegen.program.plugins import holder
from coscrew_codegen.runtime import cache, sources
from coscrew_codegen.runtime.cache import packed, unpacked
from coscrew_codegen.runtime.sources import Contents, Sources

_SUFFIX = ".family"

Made = TypeVar("Made")
Make = Callable[[FamilyKernels], Made]


class FamilyCache:
    """Returns cached results for a family, or derives them; `save` caches those that were derived.

    `stands` are the generator's sources, read before this process imported the operations; if they
    are None, the cache is not used.  `command` selects what is generated; `anew` derives all."""

    def __init__(self, stands: Contents | None, command: str, tell: Callable[[str], None],
                 anew: bool = False):
        self._stands, self._command, self._tell, self._anew = stands, command, tell, anew
        self._made: dict[tuple[str, Make[object]], object] = {}
        if stands is not None:
            cache.limit()  # raises CacheError before anything is made
        self._sources = Sources.of(stands) if stands is not None and cache.lasts() else None

    def __call__(self, kernels: FamilyKernels, make: Make[Made]) -> Made:
        kept = None if self._anew else self._kept(kernels.family, make)
        if kept is not None:
            return cast(Made, kept)
        self._tell(f"deriving {kernels.family}")
        made = self._made[kernels.family, make] = make(kernels)
        return made

    @property
    def derived(self) -> tuple[str, ...]:
        """The families with results that were not in the cache."""
        return tuple(dict.fromkeys(family for family, _ in self._made))

    def save(self) -> None:
        """Cache what was derived, unless the sources have changed since or the cache cannot be
        written to."""
        if not self._sources or sources.read() != self._stands:
            return
        for (family, make), made in self._made.items():
            with suppress(OSError):  # a full disk: it is derived again next time
                cache.write(self._key(family, make, self._sources), _SUFFIX,
                            packed((_name(make), made)))

    def _kept(self, family: str, make: Make[object]) -> object:
        """The cached result; None if there is none that can be read."""
        def read(path: Path) -> object:
            name, made = unpacked(path.read_bytes())
            if name != _name(make):
                raise LookupError(name)
            return made

        if not self._sources:
            return None
        return cache.kept_as(self._key(family, make, self._sources), _SUFFIX, read)

    def _key(self, family: str, make: Make[object], its: Sources) -> str:
        return cache.key_of(family, _name(make), self._command, its.digest(
            makers(make), {operations.__name__: modules(family)}))


def makers(make: Make[object]) -> tuple[str, ...]:
    """The modules that derive a family's result."""
    return make.__module__, FamilyKernels.__module__


def modules(family: str) -> frozenset[str]:
    """The modules with operations of a family, and with those that tiers call in its kernels."""
    takes = any(a.domain in ROTATIONS for op in OPERATIONS if op.family == family
                for a in op.inputs)
    called = {op.family for op in OPERATIONS if takes and op.name == DEFECT}
    return frozenset(holder(operations.__name__, "FAMILY", family_named(name))
                     for one in {family, *called} for name in contributors(one))


def _name(make: Make[object]) -> str:
    return f"{make.__module__}.{make.__qualname__}"
