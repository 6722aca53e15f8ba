"""Builds the extension module with the flags its promises need."""

import os

from setuptools.command.build_ext import build_ext


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
