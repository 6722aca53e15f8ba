"""Caches what is derived from each family of operations, so that only changed families are derived
again.

A family's key names the versions of the packages that derive, and all sources of the generator,
except those in operations/ that the family's own modules do not import.  `coscrew generate --check`
derives everything.
"""

import ast
import pickle
import sys
import zlib
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from importlib.metadata import PackageNotFoundError, version
from typing import TypeVar, cast

from coscrew_codegen.library import FamilyKernels
from coscrew_codegen.native import cache
from coscrew_codegen.operations import OPERATIONS, contributors
from coscrew_codegen.tiers.certified_rotations import DEFECT, ROTATIONS

_PACKAGE = "coscrew_codegen.operations"
_FOLDER, _INIT = "codegen/operations/", "__init__"
_SUFFIX = ".family"
_PACKAGES = ("sympy", "mpmath", "gmpy2", "numpy", "jinja2")
"""The packages whose versions are part of every key."""

Made = TypeVar("Made")
Bundle = dict[str, object]  # a family's results, by the names of the functions that made them


class FamilyCache:
    """Returns cached results for a family, or derives them; `save` caches those that were derived.

    `sources` are the generator's sources, read before this process imported the operations; if they
    are None, the cache is not used.  `command` selects what is generated."""

    def __init__(self, sources: Mapping[str, bytes] | None, command: str,
                 tell: Callable[[str], None]):
        self._sources, self._command, self._tell = sources, command, tell
        self._bundles: dict[str, Bundle] = {}
        self._made: dict[str, None] = {}
        if sources is not None:
            cache.limit()  # raises CacheError before anything is made

    def __call__(self, kernels: FamilyKernels, make: Callable[[FamilyKernels], Made]) -> Made:
        family, name = kernels.family, f"{make.__module__}.{make.__qualname__}"
        if family not in self._bundles:
            self._bundles[family] = self._found(family)
        bundle = self._bundles[family]
        if name not in bundle:
            self._made[family] = None
            self._tell(f"deriving {family}")
            bundle[name] = make(kernels)
        return cast(Made, bundle[name])

    @property
    def derived(self) -> tuple[str, ...]:
        """The families that were not in the cache."""
        return tuple(self._made)

    def save(self) -> None:
        """Cache what was derived, unless the sources have changed since or the cache cannot be
        written to."""
        if self._sources is None or cache.sources() != self._sources or not cache.lasts():
            return
        for family in self._made:
            with suppress(OSError):  # a full disk: it is derived again next time
                cache.write(self._key(family, self._sources), _SUFFIX,
                            zlib.compress(pickle.dumps(self._bundles[family]), 1))

    def _found(self, family: str) -> Bundle:
        """The cached results for a family; empty if they cannot be read."""
        if self._sources is None or not cache.lasts():
            return {}
        path = cache.found(self._key(family, self._sources), _SUFFIX)
        if path is None:
            return {}
        try:
            return dict(pickle.loads(zlib.decompress(path.read_bytes())))
        except Exception:  # for a foreign file, pickle may raise any error
            path.unlink(missing_ok=True)
            return {}

    def _key(self, family: str, sources: Mapping[str, bytes]) -> str:
        return cache.key_of(family, self._command, sys.version, *map(_version, _PACKAGES),
                            cache.digest(made_from(family, sources)))


def made_from(family: str, sources: Mapping[str, bytes]) -> dict[str, bytes]:
    """The sources that a family depends on: all, except those in operations/ that its modules, and
    those of operations that tiers call in its kernels, do not import."""
    modules = [_INIT, *contributors(family)]
    for called in _called(family):
        modules += contributors(called)
    own = _imported(modules, sources)
    return {path: content for path, content in sources.items()
            if not path.startswith(_FOLDER) or path in own}


def _called(family: str) -> set[str]:
    """The families with operations that tiers call in kernels of this one."""
    takes = any(a.domain in ROTATIONS for op in OPERATIONS if op.family == family
                for a in op.inputs)
    return {op.family for op in OPERATIONS if takes and op.name == DEFECT}


def _imported(modules: Iterable[str], sources: Mapping[str, bytes]) -> set[str]:
    """The paths of these modules of operations/ and of those that they import from there, directly
    or not, at the top of a module or inside a function."""
    found: set[str] = set()
    waiting = [_path(module) for module in modules]
    while waiting:
        path = waiting.pop()
        if path in sources and path not in found:
            found.add(path)
            waiting += map(_path, _imports(ast.parse(sources[path])))
    return found


def _path(module: str) -> str:
    return f"{_FOLDER}{module.replace('.', '/')}.py"


def _imports(tree: ast.Module) -> set[str]:
    """The names that a module imports from operations/; some are not modules."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = f"{_PACKAGE}." * bool(node.level) + (node.module or "")
            found |= {base, *(f"{base.rstrip('.')}.{alias.name}" for alias in node.names)}
    return {name.removeprefix(f"{_PACKAGE}.") for name in found if name.startswith(f"{_PACKAGE}.")}


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""
