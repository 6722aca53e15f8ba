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
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from shutil import which

from coscrew_codegen.runtime import cache
from coscrew_codegen.runtime.console import doing

# Higher levels gain nothing for straight-line code.  clang's -O1 compiles a third faster than -O3,
# and its code is as fast or, for 35 joints, faster (2.0 instead of 2.6 us).  gcc's code at -O1 is
# 5 % slower; -ftree-ter lengthens live ranges, and without it register allocation takes three
# quarters of the time.
_LEVELS = {"clang": ("-O1",), "Free Software Foundation": ("-O2", "-fno-tree-ter"), "": ("-O2",)}
_FLAGS = ("-std=c11", "-march=native", "-ffp-contract=off", "-DKSL_CONTRACT_OFF", "-fPIC")
_LIBRARIES = ("-lm", "-pthread")
_SUFFIX = ".so"
_LINK = ("-undefined", "dynamic_lookup") if platform.system() == "Darwin" else ()


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
    gcc's time.  A level of optimization in $CC, as in "clang -O0", replaces that of _LEVELS; bits
    depend on neither.  Raises CompilationError."""
    for name in _names():
        if executable := _compiler(tuple(shlex.split(name)), os.environ.get("PATH", "")):
            return executable
    raise CompilationError(f"no C compiler: {', '.join(_names())} cannot be run")


def ask() -> None:
    """Starts a compiler that prints its version; `compiler` waits for it, and meanwhile a command
    imports its modules."""
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
    """Ends a process whose output was not read, so that a command does not wait for it to exit."""
    process.kill()
    process.__exit__(None, None, None)


@functools.cache
def _compiler(command: tuple[str, ...], path: str) -> Compiler | None:
    process = _asked(command, path)
    if not process:
        return None
    try:
        version, _ = process.communicate(timeout=60)
    except subprocess.SubprocessError:
        process.kill()
        return None
    if process.returncode or not version.strip():
        return None
    chosen = any(word.startswith("-O") for word in command)
    level = () if chosen else next(x for words, x in _LEVELS.items() if words in version)
    return Compiler(command, version.partition("\n")[0].strip(), (*level, *_FLAGS))


@dataclass(frozen=True)
class CompiledLibrary:
    """A library, and the key of its entry in the cache."""

    opened: ctypes.PyDLL
    key: str


def library(units: Mapping[str, Sequence[str]], files: Mapping[str, str],
            using: Compiler) -> CompiledLibrary:
    """The library of `units`: object file → its source and additional flags, compiled in parallel.

    `files` maps names to all texts.  A source in a folder includes files of this folder alone, and
    its object is cached for other libraries.  Raises CompilationError."""
    key = _key(units, files, using)
    return cache.cached(key, _SUFFIX, lambda: _built(units, files, using),
                        functools.partial(_opened, key, maker=using.command[0]))


def kept(key: str) -> CompiledLibrary | None:
    """The library of this key, if the cache has it."""
    return cache.kept_as(key, _SUFFIX, functools.partial(_opened, key))


def place(using: Compiler) -> tuple[str, ...]:
    """Describes the dependencies of compiled code besides its text: compiler, flags and processor.
    """
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
    rows = [next((x for x in lines if x.lower().startswith(words)), "")
            for words in ("model name", ("flags", "features"))]
    described = " ".join(rows)
    processor = described if all(rows) else f"{platform.processor()} {described}"
    return f"{platform.machine()} {processor}"


def _opened(key: str, path: Path, maker: str = "another") -> CompiledLibrary:
    """The library in a file.  Raises CompilationError.  (The cache has compared its hash: opening a
    truncated library may end the process.)"""
    try:
        return CompiledLibrary(ctypes.PyDLL(str(path)), key)
    except OSError as error:
        raise CompilationError(f"{maker} made a library that cannot be loaded") from error


def _built(units: Mapping[str, Sequence[str]], files: Mapping[str, str], using: Compiler) -> bytes:
    """The content of the library's file."""
    from concurrent.futures import ThreadPoolExecutor

    own = sorted(name for name, (source, *_) in units.items() if not os.path.dirname(source))
    with doing(f"compiling {' and '.join(own)}"), cache.building() as work:
        for file, text in files.items():
            (work / file).parent.mkdir(exist_ok=True)
            (work / file).write_text(text, encoding="utf-8")
        with ThreadPoolExecutor(len(units)) as pool:
            objects = list(pool.map(
                lambda unit: _object(using, work, files, unit, *units[unit]), units))
        made = work / "library.so"
        _run(using, [*using.flags, "-shared", *_LINK, *objects, "-o", made.name, *_LIBRARIES], work)
        return made.read_bytes()


def _object(using: Compiler, work: Path, files: Mapping[str, str], unit: str, source: str,
            *flags: str) -> str:
    """The unit's object file, which it writes to `work`."""
    made = work / f"{unit}.o"

    def compiled() -> bytes:
        _run(using, [*using.flags, *flags, "-c", source, "-o", made.name], work)
        return made.read_bytes()

    if folder := os.path.dirname(source):
        texts = {x: text for x, text in files.items() if os.path.dirname(x) == folder}
        key = _key({unit: (source, *flags)}, texts, using)
        made.write_bytes(cache.cached(key, made.suffix, compiled, Path.read_bytes))
    else:
        compiled()
    return made.name


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
