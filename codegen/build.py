"""Builds the extension module with the flags its promises need."""

from setuptools.command.build_ext import build_ext


class BuildExt(build_ext):
    """Adds NumPy's headers, and flags that keep every operation's own rounding."""

    def build_extensions(self) -> None:
        import numpy

        unix = self.compiler.compiler_type == "unix"
        for extension in self.extensions:
            extension.include_dirs.append(numpy.get_include())
            extension.extra_compile_args += (
                ["-O3", "-ffp-contract=off", "-fno-fast-math", "-fvisibility=hidden"] if unix
                else ["/O2", "/fp:precise"])
        super().build_extensions()
