"""The generator's sources, and the ones that a result depends on.

A result depends on the modules that its maker imports, directly or not, at the top of a module or
inside a function, also for types only; on the packages' own files above them; and on the templates
that all these name.  Only the meaning of a source counts: comments, docstrings and positions do
not."""

import functools
import json
import os
import sys
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import astuple, dataclass
from fnmatch import filter as matching
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from importlib.util import cache_from_source
from pathlib import Path

from coscrew_codegen.backends.render import GENERATED, TEMPLATES
from coscrew_codegen.backends.scene import scene_c_runtime
from coscrew_codegen.runtime import cache, syntax
from coscrew_codegen.runtime.syntax import SourceMeaning

ROOT = __name__.partition(".")[0]
_TEMPLATE = ".jinja"
_COPIED = (".c", ".h")
"""How files in templates/ end that are copied as they are."""
_INSTALLED = ("coscrew", "sympy", "mpmath", "gmpy2", "numpy", "jinja2")
"""The packages whose versions every result depends on."""

Contents = Mapping[str, bytes]
"""Modules by their names, packages too; templates, and what is copied, by their paths, which have a
slash: c/family.h.jinja, runtime/calls/threads.h, c/coscrew_runtime.h."""


def read() -> Contents:
    """The sources as they stand."""
    package, templates, generated = _folders()
    hashes = {}
    for folder, file in _files(package, (".py",)):
        inner = () if file == "__init__.py" else (file.removesuffix(".py"),)
        hashes[".".join((ROOT, *folder, *inner))] = package.joinpath(*folder, file)
    for folder, file in _files(templates, (_TEMPLATE, *_COPIED)):
        hashes["/".join((*folder, file))] = templates.joinpath(*folder, file)
    header = generated / scene_c_runtime.PATH
    if header.is_file():  # else it is being generated
        hashes[scene_c_runtime.PATH] = header
    return {name: path.read_bytes() for name, path in hashes.items()}


def _folders() -> tuple[Path, Path, Path]:
    """The folders of the package, of the templates and of generated headers."""
    return Path(next(iter(import_module(ROOT).__path__))), TEMPLATES, GENERATED


def _files(root: Path, endings: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], str]]:
    """The files below a folder that end so: the folders from there, and the name."""
    for folder, _, files in os.walk(root):
        inner = Path(folder).relative_to(root).parts
        yield from ((inner, file) for file in files if file.endswith(endings))


@functools.cache
def generator() -> str:
    """The hash of all sources, byte by byte."""
    return _total((name, _hashed(content)) for name, content in read().items())


def digest_of(*makers: str, chosen: Mapping[str, Collection[str]] | None = None) -> str:
    """The hash of everything that results of these modules depend on, as this process first read
    it.

    In packages of `chosen`, which import all their modules, only these modules count."""
    return _current().digest(makers, chosen or {})


@functools.cache
def _current() -> "Sources":
    return Sources.of(read())


@dataclass(frozen=True)
class Sources:
    """The meanings of sources, by the same names."""

    meanings: Mapping[str, SourceMeaning]

    @classmethod
    def of(cls, contents: Contents) -> "Sources":
        """The meanings of these sources: kept from an earlier process, or read from their syntax.
        """
        kept = _kept(_maker(contents))
        sources = {name: old if (old := kept.get(name)) and old.documented == _hashed(content)
                   else _meaning(name, content, contents) for name, content in contents.items()}
        if sources != kept:
            _keep(_maker(contents), sources)
        return cls(sources)

    def digest(self, makers: Iterable[str], chosen: Mapping[str, Collection[str]]) -> str:
        """The hash of everything that results of these modules depend on."""
        names = self.reached(makers, chosen)
        documented = any(self.meanings[name].reads_docstrings for name in names)
        held = {x for name in names for x in (name, *_packages(name))}
        return _total((("installed", _installed()), *((name, (
            self.meanings[name].documented if documented else self.meanings[name].digest))
            for name in held if name in self.meanings)))

    def reached(self, makers: Iterable[str], chosen: Mapping[str, Collection[str]] | None = None
                ) -> frozenset[str]:
        """The modules that these import, directly or not, and the templates that they name."""
        modules: set[str] = set()
        waiting = list(makers)
        while waiting:
            name = waiting.pop()
            if name not in modules:
                modules.add(name)
                waiting += self._named(name, (chosen or {}).get(name))
        return frozenset(modules)

    def _named(self, name: str, chosen: Collection[str] | None) -> Iterator[str]:
        """The modules and templates that a source names; KeyError if there is no such source."""
        meaning = self.meanings[name]
        if name not in self._spelled:
            self._spelled[name] = (*self._imported(meaning), *self._templates_of(meaning))
        yield from self._spelled[name]
        if meaning.discovers:
            yield from (x for x in self.meanings if x.startswith(f"{name}.")
                        and (chosen is None or x in chosen))

    def _imported(self, meaning: SourceMeaning) -> Iterator[str]:
        return (known for x in meaning.imports if (known := self._known(x)))

    def _templates_of(self, meaning: SourceMeaning) -> Iterator[str]:
        for text in meaning.texts:
            template = f"{text.removesuffix(_TEMPLATE)}{_TEMPLATE}"
            if syntax.ANY in template:
                yield from matching(self._templates, template)
                if text.endswith(_COPIED):
                    yield from matching(self._templates, text)
            yield from (x for x in {text, template} if x in self.meanings)

    @functools.cached_property
    def _spelled(self) -> dict[str, tuple[str, ...]]:
        """The modules and templates that sources name, of those that have been read so far."""
        return {}

    @functools.cached_property
    def _templates(self) -> list[str]:
        return [name for name in self.meanings if "/" in name]

    def _known(self, name: str) -> str:
        """The module of an imported name, which may be an object's in it; "" for another package's.
        """
        while name and name not in self.meanings:
            name = name.rpartition(".")[0]
        return name


def _packages(name: str) -> Iterator[str]:
    """The packages that a module stands in."""
    while name := name.rpartition(".")[0]:
        yield name


def _meaning(name: str, content: bytes, among: Contents) -> SourceMeaning:
    if "/" in name:
        return syntax.of_template(content)
    package = any(x.startswith(f"{name}.") for x in among)
    return syntax.of_module(content, name if package else name.rpartition(".")[0])


def _hashed(content: bytes) -> str:
    return cache.hashed(content, 32)


def _total(parts: Iterable[tuple[str, str]]) -> str:
    return _hashed("\0".join(f"{name} {digest}" for name, digest in sorted(parts)).encode())


@functools.cache
def _installed() -> str:
    """Python's version and those of packages."""
    return " ".join((sys.version, *map(_version, _INSTALLED)))


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def _maker(contents: Contents) -> str:
    """Further dependencies of meanings besides the sources: the version of Python, and the code
    that reads them."""
    return f"{sys.version} {_hashed(contents.get(syntax.__name__, b''))}"


def _places() -> Iterator[Path]:
    """Folders of the meanings: beside the bytecode or, if that cannot be written, in the cache."""
    yield Path(cache_from_source(__file__)).with_suffix(".json")
    yield cache.wanted_folder() / "sources.json"


def _kept(maker: str) -> dict[str, SourceMeaning]:
    """The kept meanings; empty if there are none that can be read."""
    for place in _places():
        with suppress(OSError, ValueError, TypeError, AttributeError, LookupError):
            kept = json.loads(place.read_bytes())
            if kept["maker"] == maker:
                return {name: SourceMeaning(*x[:2], *map(tuple, x[2:4]), *x[4:])
                        for name, x in kept["meanings"].items()}
    return {}


def _keep(maker: str, meanings: Mapping[str, SourceMeaning]) -> None:
    """Keep them where that is possible."""
    text = json.dumps({"maker": maker, "meanings": {k: astuple(x) for k, x in meanings.items()}})
    for place in _places():
        with suppress(OSError):
            cache.replaced(place, text.encode())
            return
