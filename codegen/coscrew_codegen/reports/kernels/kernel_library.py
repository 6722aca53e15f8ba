"""Compiled kernels: all variants built by the system's C compilers, called and timed."""

import ctypes
import functools
import os
import subprocess
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from shutil import which

import numpy as np

import coscrew
from coscrew_codegen.backends.render import render
from coscrew_codegen.reports.kernels import ReportError
from coscrew_codegen.reports.kernels.c_text import Variant, kernels_text
from coscrew_codegen.reports.kernels.report_json import CompilerRecord
from coscrew_codegen.reports.timing.buffers import aligned, planes
from coscrew_codegen.reports.timing.loop_timing import Loop, Timing, driver, pointers, timed_loops

_FLAGS = ("-std=c11", "-O3", "-march=native", "-ffp-contract=off", "-DKSL_CONTRACT_OFF")
Arrays = tuple[np.ndarray, ...]


def compilers(folder: Path) -> tuple[CompilerRecord, ...]:
    """Working compilers with the flags they understand: gcc and clang, or else cc."""
    result = [name for name in ("gcc", "clang") if which(name)] or [n for n in ("cc",) if which(n)]
    flags = (_FLAGS, tuple(flag for flag in _FLAGS if not flag.startswith("-march")))
    (folder / "empty.c").write_text("#include <math.h>\nint one(void) { return 1; }\n",
                                   encoding="utf-8")
    working = []
    for name in result:
        usable = next((f for f in flags if _runs(
            name, *f, "-shared", "-fPIC", folder / "empty.c", "-o", folder / "empty.so")), None)
        if usable:
            output = subprocess.run([name, "--version"], capture_output=True, text=True,
                                    errors="replace").stdout
            working.append(CompilerRecord(name, output.partition("\n")[0], " ".join(usable)))
    return tuple(working)


@dataclass(frozen=True)
class KernelLibrary:
    """The loops of all variants, built by one compiler."""

    compiler: CompilerRecord
    path: Path

    def call(self, variant: Variant, inputs: Arrays) -> Arrays:
        """The kernel's outputs, each (n, *shape), for inputs of n rows."""
        n = len(inputs[0])
        read = [_as_structs(x) for x in inputs]
        written = [np.full((n, *a.quantity.shape[::-1]), np.nan, variant.precision.numpy_type)
                   for a in variant.operation.outputs]
        getattr(loaded(self.path), f"rows_{variant.name}")(
            ctypes.c_long(n), pointers((*read, *written)))
        return tuple(_transposed(x) for x in written)

    def times(self, variants: Sequence[Variant], layout: str, inputs: Sequence[Arrays],
              ns: float) -> list[Timing]:
        """Times per element of the loop `layout` of each variant, measured in turn for about `ns`
        altogether; `inputs` has the arguments of each."""
        return timed_loops(loaded(self.path), [
            self._loop(variant, layout, given) for variant, given
            in zip(variants, inputs, strict=True)], ns)

    def _loop(self, variant: Variant, layout: str, inputs: Arrays) -> Loop:
        n, real = variant.elements, np.dtype(variant.precision.numpy_type)
        outputs = [np.ones((n, *a.quantity.shape)) for a in variant.operation.outputs]
        arrays = [x[:n].astype(real) for x in (*inputs, *outputs)]
        arguments = planes(arrays) if layout == "planes" else [
            aligned(_as_structs(x)) for x in arrays]
        return Loop(getattr(loaded(self.path), f"{layout}_{variant.name}"), n,
                    pointers((*arguments, np.zeros(1, real))))


def libraries(variants: Sequence[Variant], results: Sequence[CompilerRecord],
              folder: Path) -> Iterator[KernelLibrary]:
    """The library of each compiler; its parts are compiled in parallel."""
    sources = [folder / "driver.c", folder / "drift.c"]
    for source, text in zip(sources, (driver(), render("report/drift.c")), strict=True):
        source.write_text(text, encoding="utf-8")
    for tier, precision in dict.fromkeys((v.tier, v.precision) for v in variants):
        sources.append(folder / f"{tier}_{precision.name}.c")
        sources[-1].write_text(kernels_text(
            [v for v in variants if (v.tier, v.precision) == (tier, precision)]), encoding="utf-8")
    pool = ThreadPoolExecutor(os.cpu_count())
    jobs = {c.name: [pool.submit(_object, c, source) for source in sources] for c in results}
    try:
        for compiler in results:
            objects = [job.result() for job in jobs[compiler.name]]
            path = folder / f"{compiler.name}.so"
            _run(compiler.name, "-shared", *objects, "-o", path, "-lm")
            yield KernelLibrary(compiler, path)
    finally:
        pool.shutdown(cancel_futures=True)


def _object(compiler: CompilerRecord, source: Path) -> Path:
    path = source.with_name(f"{source.stem}_{compiler.name}.o")
    _run(compiler.name, *compiler.flags.split(), "-fPIC", "-I", coscrew.get_include(), "-c", source,
         "-o", path)
    return path


def _run(*words: str | Path) -> None:
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, errors="replace")
    if done.returncode:
        raise ReportError(f"{words[0]} cannot compile the kernels:\n{done.stderr.strip()}")


def _runs(*words: str | Path) -> bool:
    return subprocess.run(list(map(str, words)), capture_output=True).returncode == 0


@functools.cache
def loaded(path: Path) -> ctypes.CDLL:
    """The library, opened once."""
    return ctypes.CDLL(str(path))


def _transposed(x: np.ndarray) -> np.ndarray:
    return x.swapaxes(-1, -2) if x.ndim == 3 else x


def _as_structs(x: np.ndarray) -> np.ndarray:
    """The array with matrices column by column, as in C."""
    return np.ascontiguousarray(_transposed(x))
