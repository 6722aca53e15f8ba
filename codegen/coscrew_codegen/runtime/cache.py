"""The cache of derived and compiled files, by content, in $XDG_CACHE_HOME/coscrew.

`cached` finds a value or makes it.  An entry's name is its key, a hash of everything that it was
made from, its size, and the hash of its content, so that damaged entries are recognized and made
again.  Entries stand in 256 folders, by the first digits of their keys, since to find one means to
list its folder.
They are written under another name and then renamed, so that concurrent processes see complete
entries; one process makes an entry, others wait for it.  When all together exceed the limit,
$COSCREW_CACHE_LIMIT, the least recently used entries are removed.
"""

import functools
import hashlib
import os
import pickle
import re
import shutil
import tempfile
import time
import zlib
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from coscrew_codegen.program.reported_error import ReportedError

LIMIT = "COSCREW_CACHE_LIMIT"
"""The environment variable with the limit: 200 MB, 2 GB, 0."""
DEFAULT_LIMIT = "1 GB"
_UNITS = {"": 1, "B": 1, "KB": 10**3, "MB": 10**6, "GB": 10**9}
_SIZE = re.compile(r"([0-9]+(?:\.[0-9]+)?) *([KMG]?B)?", re.I)
_SIZE_IN_NAME = re.compile("[0-9a-f]{32}-([0-9]+)-")
_FOLDER = re.compile("[0-9a-f]{2}")
_UNCHECKED = 0.01  # of the limit: written, on average, until the sizes are added up again
_ABANDONED = 86400.0  # s after which files that another process is writing count as abandoned


Value = TypeVar("Value")


class CacheError(ReportedError, ValueError):
    """The limit is not a size."""


@dataclass(frozen=True)
class CacheEntry:
    """A file or folder of the cache."""

    path: Path
    size: int  # bytes
    used: float  # time of the last use, in s since 1970


def folder() -> Path:
    """$XDG_CACHE_HOME/coscrew or ~/.cache/coscrew; if it cannot be written to, a folder of this
    process."""
    return wanted_folder() if lasts() else _own_folder()


def lasts() -> bool:
    """Returns whether entries are kept for later processes: the folder can be written to."""
    place = wanted_folder()
    try:
        place.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=place):
            return True
    except OSError:
        return False


def wanted_folder() -> Path:
    """The folder of the cache, whether or not it can be written to."""
    base = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(base) / "coscrew"


@functools.cache
def _own_folder() -> Path:
    return Path(tempfile.mkdtemp(prefix="coscrew-"))


def limit() -> int:
    """The largest number of bytes for all entries together.  Raises CacheError."""
    text = os.environ.get(LIMIT, "").strip() or DEFAULT_LIMIT
    size = _SIZE.fullmatch(text)
    if not size:
        raise CacheError(f"{LIMIT}={text!r}: wanted a size, such as 200 MB, 2 GB or 0")
    return int(float(size[1]) * _UNITS[(size[2] or "").upper()])


def key_of(*parts: str) -> str:
    """The key for these parts: their hash."""
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


def hashed(content: bytes, digits: int = 16) -> str:
    """The hash of a content: in an entry's name, of 16 digits."""
    return hashlib.sha256(content).hexdigest()[:digits]


def cached(key: str, suffix: str, make: Callable[[], bytes], read: Callable[[Path], Value]
           ) -> Value:
    """The value that `read` finds in the entry of this key, whose content `make` returns if there
    is none."""
    if (kept := kept_as(key, suffix, read)) is not None:
        return kept
    with _locked(key):
        if (kept := kept_as(key, suffix, read)) is not None:  # another process has made it
            return kept
        return read(write(key, suffix, make()))


def kept_as(key: str, suffix: str, read: Callable[[Path], Value]) -> Value | None:
    """The value in the entry of this key, None if there is none.  Entries that `read` refuses, by
    whatever error, are removed: they are another program's."""
    path = entry(key, suffix)
    if path is None:
        return None
    try:
        return read(path)
    except Exception:
        _removed(path)
        return None


def entry(key: str, suffix: str) -> Path | None:
    """The entry of this key, marked as used now; None if there is none or it is damaged."""
    place = _place(key)
    for name in sorted(x for x in _names(place)
                       if x.startswith(f"{key}-") and x.endswith(suffix)):
        path = place / name
        with suppress(OSError):
            if hashed(path.read_bytes()) == name.removesuffix(suffix).rpartition("-")[2]:
                os.utime(path)
                return path
        _removed(path)
    return None


def _place(key: str) -> Path:
    """The folder of this key's entries; one of this process if it cannot be written to, as where
    another user has made it."""
    place = folder() / key[:2]
    with suppress(OSError):
        place.mkdir(parents=True, exist_ok=True)
        if os.access(place, os.W_OK):
            return place
    return _own_folder() / key[:2]


def write(key: str, suffix: str, content: bytes) -> Path:
    """Store this content as an entry; removes others if the cache is full."""
    most, size, digest = limit(), len(content), hashed(content)
    path = _place(key) / f"{key}-{size}-{digest}{suffix}"
    replaced(path, content)
    # To add up thousands of sizes takes longer than to write an entry.  So they are added up with a
    # probability that is proportional to this entry's size; its hash is the random number, below
    # 16^16.
    if int(digest, 16) * _UNCHECKED * most <= size * 16**16 and _total() > most:
        evict(most, path)
    return path


def replaced(path: Path, content: bytes) -> None:
    """Write a file such that other processes see the old one or the new one, whole.  Raises
    OSError."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".building-", dir=path.parent) as work:
        made = Path(work) / "content"
        made.write_bytes(content)
        os.replace(made, path)


@contextmanager
def building() -> Iterator[Path]:
    """A temporary folder next to the entries, to make one in."""
    with tempfile.TemporaryDirectory(prefix=".building-", dir=folder()) as name:
        yield Path(name)


@contextmanager
def _locked(key: str) -> Iterator[None]:
    """One process at a time is within, where the system can lock files."""
    limit()  # raises CacheError before anything is made
    path = folder() / f".making-{key}"
    with ExitStack() as stack:
        with suppress(ImportError, OSError):
            import fcntl

            file = stack.enter_context(path.open("wb"))
            fcntl.flock(file, fcntl.LOCK_EX)
            stack.callback(_removed, path)
        yield


def packed(value: object) -> bytes:
    """The value, pickled and compressed.  (No other module pickles.)"""
    return zlib.compress(pickle.dumps(value), 1)


def unpacked(content: bytes) -> Any:
    """The value.  Bytes that are not `packed` may raise any error."""
    return pickle.loads(zlib.decompress(content))


def standard(value: object) -> tuple[Callable[[bytes], Any], bytes]:
    """A function of Python's own, and the bytes from which it makes the value: processes without
    this package can receive both."""
    return pickle.loads, pickle.dumps(value)


def entries() -> list[CacheEntry]:
    """All entries, the least recently used first; also abandoned unfinished files."""
    entries = []
    for path in _paths(wanted_folder()):
        with suppress(OSError):
            used = path.stat().st_mtime
            if not path.name.startswith(".") or time.time() - used > _ABANDONED:
                entries.append(CacheEntry(path, _size(path), used))
    return sorted(entries, key=lambda x: (x.used, x.path.name))


def _total() -> int:
    """Returns the size of all together in bytes, from their names: to ask the system for the sizes
    of thousands of files takes longer than to make one."""
    sizes = [(x, _SIZE_IN_NAME.match(x.name)) for x in _paths(folder())]
    return sum(int(size[1]) if size else _size(path) for path, size in sizes)


def _paths(place: Path) -> Iterator[Path]:
    """The paths in the folder and in those by first digits."""
    for name in _names(place):
        if _FOLDER.fullmatch(name):
            yield from (place / name / x for x in _names(place / name))
        else:
            yield place / name


def _names(place: Path) -> list[str]:
    with suppress(FileNotFoundError, NotADirectoryError):
        return os.listdir(place)
    return []


def evict(most: int, kept: Path | None = None) -> list[CacheEntry]:
    """Remove the least recently used entries, except `kept`, until the rest takes at most `most`
    bytes; returns the removed ones.  Entries that cannot be removed stay."""
    all_of_them = entries()
    total, gone = sum(x.size for x in all_of_them), []
    for entry in all_of_them:
        if total <= most:
            break
        if entry.path != kept and _removed(entry.path):
            total -= entry.size
            gone.append(entry)
    return gone


def _removed(path: Path) -> bool:
    """Returns whether nothing is left of the path."""
    if path.is_dir():
        shutil.rmtree(path, ignore_errors=True)
    else:
        with suppress(OSError):
            path.unlink()
    return not path.exists()


def _size(path: Path) -> int:
    with suppress(OSError):  # another process has removed it
        return sum(x.stat().st_size for x in (path, *path.rglob("*")) if x.is_file())
    return 0
