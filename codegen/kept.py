"""What was made of families of operations, kept by the content of all that it was made from.

A family is made again where a source of the generator changed, but for those of other families that
its own do not import.  `coscrew generate --check` keeps nothing and finds nothing.
"""

import ast
import pickle
import sys
import zlib
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from importlib.metadata import PackageNotFoundError, version
from typing import TypeVar

from coscrew_codegen.library import FamilyKernels
from coscrew_codegen.native import cache
from coscrew_codegen.operations import contributors

_PACKAGE = "coscrew_codegen.operations"
_FOLDER, _INIT = "codegen/operations/", "__init__"
_SUFFIX = ".family"
_PACKAGES = ("sympy", "mpmath", "gmpy2", "numpy", "jinja2")
"""What derives and writes besides the generator: their versions are part of every key."""

Made = TypeVar("Made")
Bundle = dict[str, object]  # what each function gave of a family, by its name


class Kept:
    """Finds what was made of a family, or makes it, which it tells; `save` keeps what was made.

    `sources` are the generator's as they stood before this process imported those of operations;
    without them nothing is found or kept.  `command` makes all that is generated."""

    def __init__(self, sources: Mapping[str, bytes] | None, command: str,
                 tell: Callable[[str], None]):
        self._sources, self._command, self._tell = sources, command, tell
        self._bundles: dict[str, Bundle] = {}
        self._made: dict[str, None] = {}
        if sources is not None:
            cache.limit()  # says what is wrong with it before anything is made

    def __call__(self, kernels: FamilyKernels, make: Callable[[FamilyKernels], Made]) -> Made:
        family, name = kernels.family, f"{make.__module__}.{make.__qualname__}"
        if family not in self._bundles:
            self._bundles[family] = self._found(family)
        bundle = self._bundles[family]
        if name not in bundle:
            self._made[family] = None
            self._tell(f"deriving {family}")
            bundle[name] = make(kernels)
        return bundle[name]

    @property
    def made_again(self) -> tuple[str, ...]:
        """The families of which anything was made."""
        return tuple(self._made)

    def save(self) -> None:
        """Keep what was made, unless sources have changed meanwhile, or no folder lasts."""
        if self._sources is None or cache.sources() != self._sources or not cache.lasts():
            return
        for family in self._made:
            with suppress(OSError):  # a full disk: it is made again next time
                cache.write(self._key(family, self._sources), _SUFFIX,
                            zlib.compress(pickle.dumps(self._bundles[family]), 1))

    def _found(self, family: str) -> Bundle:
        """What is kept of a family; nothing where that cannot be read."""
        if self._sources is None or not cache.lasts():
            return {}
        path = cache.found(self._key(family, self._sources), _SUFFIX)
        if path is None:
            return {}
        try:
            return dict(pickle.loads(zlib.decompress(path.read_bytes())))
        except Exception:  # of what is no pickle of ours, pickle raises anything
            path.unlink(missing_ok=True)
            return {}

    def _key(self, family: str, sources: Mapping[str, bytes]) -> str:
        return cache.key_of(family, self._command, sys.version, *map(_version, _PACKAGES),
                            cache.digest(made_from(family, sources)))


def made_from(family: str, sources: Mapping[str, bytes]) -> dict[str, bytes]:
    """The sources that a family is made from: all but those of operations that it does not
    import."""
    own = _imported((_INIT, *contributors(family)), sources)
    return {path: content for path, content in sources.items()
            if not path.startswith(_FOLDER) or path in own}


def _imported(modules: Iterable[str], sources: Mapping[str, bytes]) -> set[str]:
    """The paths of these modules of operations, and of all that they import of its folder, at
    their top or within functions."""
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
    """The names of modules of operations that a module may import; some are no modules."""
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
