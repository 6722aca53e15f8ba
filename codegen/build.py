"""What is installed, as it stands in the folders, and the flags the extension's promises need.

Runs inside setuptools, where neither SymPy nor this package is installed: it looks at what the
generator has written, and lists nothing."""

import os
from collections.abc import Iterable
from pathlib import Path

from setuptools import Extension
from setuptools.command.build_ext import build_ext

ROOTS = {"coscrew": "generated/python", "coscrew.c": "generated/c", "coscrew_codegen": "codegen",
         "coscrew_codegen.templates": "templates"}
"""The folders that packages begin in; others lie below their parents'."""
_GUFUNC = "generated/gufunc"


def packages(root: Path) -> list[str]:
    """Every package: a root, and each folder below one that holds an __init__.py."""
    found = {".".join((name, *init.parent.relative_to(root / folder).parts))
             for name, folder in ROOTS.items() for init in (root / folder).rglob("__init__.py")}
    return sorted(found)


def extensions(root: Path) -> list[Extension]:
    """An extension module for each folder of loops: coscrew._gufunc of plain kernels, and of each
    tier coscrew.TIER._gufunc."""
    return [_extension(root, module.parent) for module in sorted(
        (root / _GUFUNC).rglob("module.c"), key=lambda path: (len(path.parts), path))]


def _extension(root: Path, folder: Path) -> Extension:
    """Its sources include the headers beside them, and their kernels' in one file."""
    tier = folder.relative_to(root / _GUFUNC).parts
    headers = [*folder.glob("*.h"), root / f"generated/c/{'_'.join(('coscrew', *tier))}.h"]
    return Extension(".".join(("coscrew", *tier, "_gufunc")), _relative(root, folder.glob("*.c")),
                     depends=_relative(root, headers), optional=True)


def _relative(root: Path, paths: Iterable[Path]) -> list[str]:
    return sorted(path.relative_to(root).as_posix() for path in paths)


class BuildExt(build_ext):
    """Adds NumPy's headers, and flags that keep every operation's own rounding."""

    def build_extensions(self) -> None:
        import numpy

        self.parallel = self.parallel or os.cpu_count()
        microsoft = self.compiler.compiler_type == "msvc"
        for extension in self.extensions:
            extension.include_dirs.append(numpy.get_include())
            extension.extra_compile_args += (
                ["/O2", "/fp:precise", "/std:c11", "/utf-8"] if microsoft else
                ["-O3", "-g0", "-ffp-contract=off", "-DKSL_CONTRACT_OFF", "-fno-fast-math",
                 "-fvisibility=hidden"])
            extension.libraries += [] if microsoft else ["m"]
        super().build_extensions()
