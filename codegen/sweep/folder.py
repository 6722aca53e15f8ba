"""The folder of a sweep: sweep.json, what it is; members/, a Parquet file for each finished chunk;
damaged/, files that were not as they had been written.

Files appear whole: they are written under another name, which begins with a dot, and renamed."""

import json
import os
import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from coscrew_codegen.pages import Json
from coscrew_codegen.sweep import SweepError
from coscrew_codegen.sweep.about import ABOUT, HASH, SPECIFICATION, as_text, read_description
from coscrew_codegen.sweep.lock import held
from coscrew_codegen.sweep.part import DamagedError, check, sweep_of
from coscrew_codegen.sweep.specification import Specification

LOCK, MEMBERS, PAGE, ZARR, DAMAGED = ".lock", "members", "summary.html", "sweep.zarr", "damaged"
_PART = re.compile(r"part-(\d{8,})\.parquet")


@dataclass(frozen=True)
class Folder:
    """The folder of this sweep, held by this process."""

    path: Path
    specification: Specification

    def of(self, number: int) -> Path:
        """The file of a chunk."""
        return part_of(self.path, number)

    def missing(self) -> Iterator[int]:
        """The numbers of the chunks that are not there, in order."""
        there = set(self._there())
        return (n for n in range(self.specification.chunks) if n not in there)

    def members(self) -> int:
        """How many members are there."""
        return sum(len(self.specification.members(n)) for n in self._there())

    def damaged(self, finished: bool) -> Iterator[DamagedError]:
        """What is wrong with each part that is not as it was written; if all have been written,
        also with those that are not there."""
        there = sorted(self._there())
        for number in range(self.specification.chunks) if finished else there:
            try:
                check(self.of(number), self.specification, number)
            except DamagedError as error:
                yield error

    def _there(self) -> tuple[int, ...]:
        """The numbers of the chunks that have a file."""
        folder = self.path / MEMBERS
        names = os.listdir(folder) if folder.is_dir() else ()
        numbers = (int(x[1]) for x in map(_PART.fullmatch, names) if x)
        return tuple(n for n in numbers if n < self.specification.chunks)

    def write(self, number: int, content: bytes) -> None:
        """Add a chunk.  Raises OSError, and then the folder is as before."""
        whole(self.of(number), content)


def part_of(folder: Path, number: int) -> Path:
    """The file of a chunk of the sweep in this folder."""
    return folder / MEMBERS / f"part-{number:08d}.parquet"


def set_aside(folder: Path, path: Path) -> Path | None:
    """Move a damaged file of the sweep into damaged/; returns its new name, None if it is gone."""
    if not os.path.lexists(path):
        return None
    kept = folder / DAMAGED
    kept.mkdir(exist_ok=True)
    names = (kept / f"{path.name}{count}" for count in ("", *(f".{n}" for n in range(2, 10**6))))
    target = next(x for x in names if not os.path.lexists(x))
    os.replace(path, target)
    return target


@contextmanager
def opened(path: Path, specification: Specification, about: Mapping[str, Json]
           ) -> Iterator[Folder]:
    """The folder of the sweep, made or found, while the block runs.

    Raises SweepError for one of another sweep, of something else, or that another process holds."""
    path.mkdir(parents=True, exist_ok=True)
    _refuse_others(path)
    with held(path / LOCK, wait=False) as mine:
        if not mine:
            raise SweepError(f"{path}: another sweep is running into this folder; wait for it, or "
                             "take another --out")
        _know(path, specification, about)
        (path / MEMBERS).mkdir(exist_ok=True)
        for left in (*path.glob(".*.part"), *(path / MEMBERS).glob(".*.part")):
            left.unlink()  # by a process that was killed
        yield Folder(path, specification)


def whole(path: Path, content: bytes) -> None:
    """Write a file whole, or raise OSError, which names it, and leave nothing."""
    part = path.with_name(f".{path.name}.part")
    try:
        with part.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(part, path)
    except BaseException as error:
        with suppress(OSError):
            part.unlink()
        if isinstance(error, OSError):
            error.filename = str(path)
        raise


def _refuse_others(path: Path) -> None:
    """Refuse a folder with files but no sweep."""
    strange = next((x.name for x in sorted(path.iterdir()) if x.name != LOCK), None)
    if strange and not (path / ABOUT).exists() and _sweep_of_parts(path) is None:
        raise SweepError(f"{path}: holds {strange}, and no sweep; wanted a new or empty folder, or "
                         "one of this sweep")


def _know(path: Path, specification: Specification, about: Mapping[str, Json]) -> None:
    """Write what the sweep is, or compare it with what the folder says."""
    digest = specification.sha256
    try:
        there = read_description(path)
    except DamagedError as error:
        _refuse_without_about(path, digest, error)
        set_aside(path, path / ABOUT)
        whole(path / ABOUT, as_text({HASH: digest, SPECIFICATION: specification.data, **about}))
        return
    if there[HASH] != digest:
        differ = ", ".join(_differing("", there[SPECIFICATION], specification.data))
        raise SweepError(f"{path}: holds another sweep, {str(there[HASH])[:12]}; this one is "
                         f"{digest[:12]}; they differ in {differ or 'their form'}")


def _refuse_without_about(path: Path, digest: str, error: DamagedError) -> None:
    """Refuse a folder whose sweep.json is damaged unless its parts are of this sweep, or there are
    none; tell that the file is written again."""
    if not (path / ABOUT).exists() and not (path / MEMBERS).exists():
        return  # a new one
    found = _sweep_of_parts(path)
    if found is None and not (path / MEMBERS).is_dir():
        raise SweepError(f"{path / ABOUT}: {error.why}, and nothing beside it is of a sweep; "
                         "wanted a new or empty folder, or one of this sweep")
    if found is None and any((path / MEMBERS).glob("part-*.parquet")):
        raise SweepError(f"{path / ABOUT}: {error.why}, and no part beside it is undamaged, so "
                         "that nobody knows whose sweep it is; take another --out, or remove "
                         f"{path}")
    if found not in (None, digest):
        raise SweepError(f"{path / ABOUT}: {error.why}; the parts beside it are of another sweep, "
                         f"{str(found)[:12]}; this one is {digest[:12]}; take another --out")
    print(f"coscrew: {path / ABOUT}: {error.why}; written again", file=sys.stderr)


def _sweep_of_parts(path: Path) -> str | None:
    """The hash of the sweep of the first part that is as it was written; None if none is."""
    for x in sorted((path / MEMBERS).glob("part-*.parquet")):
        with suppress(DamagedError):
            return sweep_of(x)
    return None


def _differing(name: str, a: Json, b: Json) -> Iterator[str]:
    """Names of the entries in which two specifications differ."""
    if isinstance(a, Mapping) and isinstance(b, Mapping):
        for key in sorted({*a, *b}):
            yield from _differing(key, a.get(key), b.get(key))
    elif a != b:
        short = [json.dumps(x) for x in (a, b)]
        yield f"{name} ({short[0]}, {short[1]})" if max(map(len, short)) < 40 else name
