"""Compiles C texts with the system's compiler to libraries, which are cached.

Knows nothing of scenes.
"""

import atexit
import ctypes
import functools
import os
import platform
import shlex
import subprocess
import sys
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from shutil import which
from types import FrameType

from coscrew_codegen.runtime import cache
from coscrew_codegen.runtime.console import doing

# Higher levels gain nothing for straight-line code.  clang's -O1 compiles a third faster than -O3,
# and its code is as fast or, for 35 joints, faster (2.0 instead of 2.6 us).  gcc's code at -O1 is
# 5 % slower; -ftree-ter lengthens live ranges, and without it register allocation takes three
# quarters of the time.
_LEVELS = {"clang": ("-O1",), "Free Software Foundation": ("-O2", "-fno-tree-ter"), "": ("-O2",)}
_FLAGS = ("-std=c11", "-march=native", "-ffp-contract=off", "-DKSL_CONTRACT_OFF", "-fPIC")
_LIBRARIES = ("-lm", "-pthread")
_LINK = ("-undefined", "dynamic_lookup") if platform.system() == "Darwin" else ()

_PACKAGE = f"{Path(__file__).parents[1]}{os.sep}"
"""How paths of the package's files begin."""


class CompilationError(RuntimeError):
    """Compiling failed, or there is no working compiler; the message is the compiler's."""


@dataclass(frozen=True)
class Compiler:
    """A compiler that understands --version."""

    command: tuple[str, ...]
    version: str  # the first line it prints
    flags: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.version}; {' '.join(self.flags)}"


def compiler() -> Compiler:
    """$CC, or else clang, gcc or cc: clang compiles long straight-line functions in a third of
    gcc's time.  Raises CompilationError."""
    for name in _names():
        if found := _compiler(tuple(shlex.split(name)), os.environ.get("PATH", "")):
            return found
    raise CompilationError(f"no C compiler: {', '.join(_names())} cannot be run")


def warn(name: str, error: CompilationError, runs: str = "runs in pure NumPy") -> None:
    """Warns at the line that called this package."""
    ours = [n for n, file in enumerate(_files()) if file.startswith(_PACKAGE)]
    warnings.warn(f"{name} {runs}: {error}", RuntimeWarning, stacklevel=ours[-1] + 2)


def _files() -> list[str]:
    """Returns the files of the functions on the call stack, from `warn` outwards."""
    found: list[str] = []
    frame: FrameType | None = sys._getframe(1)
    while frame:
        found.append(frame.f_code.co_filename)
        frame = frame.f_back
    return found


def ask() -> None:
    """Start asking a compiler for its version, for which `compiler` waits: until then a command
    imports what it needs."""
    for name in _names():
        if _asked(tuple(shlex.split(name)), os.environ.get("PATH", "")):
            return


def _names() -> list[str]:
    wanted = os.environ.get("CC", "").strip()
    return [wanted] if wanted else ["clang", "gcc", "cc"]


@functools.cache
def _asked(command: tuple[str, ...], path: str) -> "subprocess.Popen[str] | None":
    if which(command[0], path=path) is None:
        return None
    try:
        process = subprocess.Popen([*command, "--version"], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                   errors="replace")
    except OSError:
        return None
    atexit.register(_end, process)
    return process


def _end(process: "subprocess.Popen[str]") -> None:
    """End a process whose answer nobody has read: a command never waits for it to exit."""
    process.kill()
    process.__exit__(None, None, None)


@functools.cache
def _compiler(command: tuple[str, ...], path: str) -> Compiler | None:
    process = _asked(command, path)
    if not process:
        return None
    try:
        told, _ = process.communicate(timeout=60)
    except subprocess.SubprocessError:
        process.kill()
        return None
    if process.returncode or not told.strip():
        return None
    level = next(flags for words, flags in _LEVELS.items() if words in told)
    return Compiler(command, told.partition("\n")[0].strip(), (*level, *_FLAGS))


@dataclass(frozen=True)
class CompiledLibrary:
    """A library, and the key of its entry in the cache."""

    opened: ctypes.PyDLL
    key: str


def library(units: Mapping[str, Sequence[str]], files: Mapping[str, str],
            using: Compiler) -> CompiledLibrary:
    """The library of `units`: object file → its source and additional flags, compiled in parallel.

    `files` maps names to all texts.  Raises CompilationError."""
    key = _key(units, files, using)
    if library := kept(key):
        return library
    with doing(f"compiling {' and '.join(sorted(units))}"):
        path = _built(units, files, using, key)
    if opened := _opened(path):
        return CompiledLibrary(opened, key)
    raise CompilationError(f"{using.command[0]} made a library that cannot be loaded")


def kept(key: str) -> CompiledLibrary | None:
    """The library of this key, if the cache has it."""
    path = cache.found(key, ".so")
    if path is None:
        return None
    if opened := _opened(path):
        return CompiledLibrary(opened, key)
    path.unlink(missing_ok=True)
    return None


def place(using: Compiler) -> tuple[str, ...]:
    """Describes what compiled code depends on besides its text: compiler, flags and processor."""
    return (using.version, *using.command, *using.flags, _processor())


def _key(units: Mapping[str, Sequence[str]], files: Mapping[str, str], using: Compiler) -> str:
    """The cache key: a hash of the texts and of `place`."""
    parts = [*place(using)]
    parts += [x for name, flags in sorted(units.items()) for x in (name, *flags)]
    parts += [x for pair in sorted(files.items()) for x in pair]
    return cache.key_of(*parts)


@functools.cache
def _processor() -> str:
    """The processor's model and features, on which -march=native depends."""
    try:
        lines = Path("/proc/cpuinfo").read_text(errors="replace").splitlines()
    except OSError:
        lines = []
    found = [next((x for x in lines if x.lower().startswith(words)), "")
             for words in ("model name", ("flags", "features"))]
    said = " ".join(found) if all(found) else f"{platform.processor()} {' '.join(found)}"
    return f"{platform.machine()} {said}"


def _opened(path: Path) -> ctypes.PyDLL | None:
    """The library, or None if it cannot be opened.  (The cache has compared its hash: opening a
    truncated library may end the process.)"""
    try:
        return ctypes.PyDLL(str(path))
    except OSError:
        return None


def _built(units: Mapping[str, Sequence[str]], files: Mapping[str, str], using: Compiler,
           key: str) -> Path:
    with cache.building() as work:
        for file, text in files.items():
            (work / file).parent.mkdir(exist_ok=True)
            (work / file).write_text(text, encoding="utf-8")
        from concurrent.futures import ThreadPoolExecutor

        with ThreadPoolExecutor(len(units)) as pool:
            objects = list(pool.map(lambda unit: _object(using, work, unit, *units[unit]), units))
        made = work / "library.so"
        _run(using, [*using.flags, "-shared", *_LINK, *objects, "-o", made.name, *_LIBRARIES], work)
        return cache.keep(made, key, ".so")


def _object(using: Compiler, work: Path, unit: str, source: str, *flags: str) -> str:
    _run(using, [*using.flags, *flags, "-c", source, "-o", f"{unit}.o"], work)
    return f"{unit}.o"


def _run(using: Compiler, words: Sequence[str], work: Path) -> None:
    """Run the compiler; without -march=native if it does not know that."""
    try:
        for given in (words, [word for word in words if word != "-march=native"]):
            done = subprocess.run([*using.command, *given], cwd=work, capture_output=True,
                                  text=True, errors="replace")
            if not done.returncode:
                return
    except OSError as error:
        raise CompilationError(f"{using.command[0]} cannot be run: {error.strerror}") from error
    raise CompilationError(f"{' '.join(using.command)} cannot compile:\n{done.stderr.strip()}")
