"""Extension modules, which setuptools compiles, and the compiler flags they need.

Runs while building, when neither SymPy nor this package is installed: it finds sources in the
folders that the generator has written."""

import os
import re
import subprocess
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from importlib import import_module
from pathlib import Path
from shutil import which

from setuptools import Distribution, Extension
from setuptools.command.build_ext import build_ext

PYTHON = "generated/python"
"""The folder of the package `coscrew`."""
WITHIN_PACKAGES = {"templates": "coscrew_codegen/templates", "generated/c": "coscrew/c"}
"""Folders of the project that a wheel holds inside its packages, and their places there."""
_GUFUNC = "generated/gufunc"
_INCLUDE = re.compile(r'^#include "(.+)"', re.MULTILINE)


def extensions(root: Path) -> list[Extension]:
    """One extension module per folder of loops: coscrew._gufunc for plain kernels, and
    coscrew.TIER._gufunc for each other tier."""
    return [_extension(root, module.parent) for module in sorted(
        (root / _GUFUNC).rglob("module.c"), key=lambda path: (len(path.parts), path))]


def build_modules(root: Path, folder: Path) -> dict[str, str]:
    """Compile every extension module into its package below `folder`, unless it is newer than its
    sources; returns the modules that are there, and their paths in the folder."""
    command = BuildExt(Distribution({"name": "coscrew", "ext_modules": extensions(root)}))
    command.build_lib, command.build_temp = str(folder), str(root / "build" / "objects")
    command.ensure_finalized()
    command.run()
    return {path: Path(path).relative_to(folder).as_posix()
            for path in map(str, command.get_outputs()) if Path(path).is_file()}


def compiled(root: Path) -> bool:
    """Returns whether every package that has an extension runs in it."""
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
        files = {Path(os.path.normpath(file.parent / name)) for name in names} - seen
        seen |= files
        waiting += files
    return {path for path in seen if path.suffix == ".h"}


def _relative(root: Path, paths: Iterable[Path]) -> list[str]:
    return sorted(path.relative_to(root).as_posix() for path in paths)


_QUICK = ["-O2", "-fvect-cost-model=dynamic", "-fpeel-loops"]
"""Flags with which gcc compiles faster than with -O3, and loops are as fast.  Functions of the
accurate tier are longer: their loops need the inlining of -O3."""


def _optimization(module: str, compiler: Sequence[str]) -> list[str]:
    """The flags of optimization of a module: gcc's, if this compiler knows them."""
    known = ".accurate." not in module and which(compiler[0]) and not subprocess.run(
        [*compiler, *_QUICK, "-E", "-x", "c", os.devnull], capture_output=True).returncode
    return _QUICK if known else ["-O3"]


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
                [*_optimization(extension.name, self.compiler.compiler_so), "-g0",
                 "-ffp-contract=off", "-DKSL_CONTRACT_OFF", "-fno-fast-math",
                 "-fvisibility=hidden"])
            extension.libraries += [] if microsoft else ["m"]
        compile_some = self.compiler.compile
        with ThreadPoolExecutor(self.parallel or os.cpu_count()) as pool:

            def compile_each(sources: list[str], **options: object) -> list[str]:
                def compile_one(number: int, source: str) -> list[str]:
                    print(f"compiling {source}, {number} of {len(sources)}", flush=True)
                    return list(compile_some([source], **options))

                longest_first = sorted(sources, key=os.path.getsize, reverse=True)
                made = {x: pool.submit(compile_one, n, x)
                        for n, x in enumerate(longest_first, start=1)}
                return [path for x in sources for path in made[x].result()]

            self.compiler.compile = compile_each
            self.parallel: int | None = len(self.extensions)
            super().build_extensions()


if __name__ == "__main__":
    here = Path(__file__).resolve().parents[3]
    os.chdir(here)
    build_modules(here, here / PYTHON)
