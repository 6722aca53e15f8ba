"""Packages and extension modules for setuptools, and the compiler flags the extension needs.

Runs while building, when neither SymPy nor this package is installed: it finds packages and sources
in the folders that the generator has written."""

import os
import re
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from importlib import import_module
from pathlib import Path

from setuptools import Extension
from setuptools.command.build_ext import build_ext

ROOTS = {"coscrew": "generated/python", "coscrew.c": "generated/c", "coscrew_codegen": "codegen",
         "coscrew_codegen.templates": "templates"}
"""Root packages and their folders; subpackages lie in folders below."""
_GUFUNC = "generated/gufunc"
_INCLUDE = re.compile(r'^#include "(.+)"', re.MULTILINE)


def packages(root: Path) -> list[str]:
    """Every package: the roots, and each folder below them with an __init__.py."""
    found = {".".join((name, *init.parent.relative_to(root / folder).parts))
             for name, folder in ROOTS.items() for init in (root / folder).rglob("__init__.py")}
    return sorted(found)


def extensions(root: Path) -> list[Extension]:
    """One extension module per folder of loops: coscrew._gufunc for plain kernels, and
    coscrew.TIER._gufunc for each other tier."""
    return [_extension(root, module.parent) for module in sorted(
        (root / _GUFUNC).rglob("module.c"), key=lambda path: (len(path.parts), path))]


def compiled(root: Path) -> bool:
    """Whether every package that has an extension runs in it."""
    return all(import_module(extension.name.removesuffix("._gufunc")).COMPILED
               for extension in extensions(root))


def _extension(root: Path, folder: Path) -> Extension:
    """The extension module of a folder, compiled again if a header changes that it includes."""
    tier = folder.relative_to(root / _GUFUNC).parts
    sources = sorted(folder.glob("*.c"))
    return Extension(".".join(("coscrew", *tier, "_gufunc")), _relative(root, sources),
                     depends=_relative(root, _included(sources)), optional=True)


def _included(sources: Iterable[Path]) -> set[Path]:
    """The headers that these include by relative paths, directly or not."""
    waiting, seen = list(sources), set[Path]()
    while waiting:
        file = waiting.pop()
        names = _INCLUDE.findall(file.read_text(encoding="utf-8"))
        found = {Path(os.path.normpath(file.parent / name)) for name in names} - seen
        seen |= found
        waiting += found
    return {path for path in seen if path.suffix == ".h"}


def _relative(root: Path, paths: Iterable[Path]) -> list[str]:
    return sorted(path.relative_to(root).as_posix() for path in paths)


class BuildExt(build_ext):
    """Adds NumPy's headers, and flags under which every operation is rounded on its own; compiles
    as many files at a time as there are processors."""

    def build_extensions(self) -> None:
        import numpy

        microsoft = self.compiler.compiler_type == "msvc"
        for extension in self.extensions:
            extension.include_dirs.append(numpy.get_include())
            extension.extra_compile_args += (
                ["/O2", "/fp:precise", "/std:c11", "/utf-8"] if microsoft else
                ["-O3", "-g0", "-ffp-contract=off", "-DKSL_CONTRACT_OFF", "-fno-fast-math",
                 "-fvisibility=hidden"])
            extension.libraries += [] if microsoft else ["m"]
        compile_some = self.compiler.compile
        with ThreadPoolExecutor(self.parallel or os.cpu_count()) as pool:

            def compile_each(sources: list[str], **options: object) -> list[str]:
                longest_first = sorted(sources, key=os.path.getsize, reverse=True)
                made = {x: pool.submit(compile_some, [x], **options) for x in longest_first}
                return [path for x in sources for path in made[x].result()]

            self.compiler.compile = compile_each
            self.parallel: int | None = len(self.extensions)
            super().build_extensions()
