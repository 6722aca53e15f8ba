"""The folder of a sweep: sweep.json, its definition; members/, a Parquet file for each finished
chunk; damaged/, files that were moved aside.

Files appear whole: they are written under another name, which begins with a dot, and renamed."""

import json
import os
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path

from coscrew_codegen.program.values.json_values import Json
from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.files.about import (
    ABOUT,
    HASH,
    SPECIFICATION,
    as_text,
    read_description,
)
from coscrew_codegen.simulation.sweep.files.lock import held
from coscrew_codegen.simulation.sweep.files.part import DamagedError, check, reading, sweep_of
from coscrew_codegen.simulation.sweep.files.quarantine import make_way, put_aside, remove
from coscrew_codegen.simulation.sweep.specification import Specification

LOCK, MEMBERS, PAGE, ZARR = ".lock", "members", "summary.html", "sweep.zarr"
_PART = re.compile(r"part-([0-9]{8,})\.parquet")
_UNREAD = (".", "_")
"""Prefixes of files in members/ that readers of Parquet ignore."""


@dataclass(frozen=True)
class Folder:
    """The folder of this sweep, held by this process."""

    path: Path
    specification: Specification
    about: Mapping[str, Json] = field(default_factory=dict)  # further content of sweep.json

    def of(self, number: int) -> Path:
        """The file of a chunk."""
        return part_of(self.path, number)

    def missing(self) -> Iterator[int]:
        """The numbers of the missing chunks, in order."""
        there = set(self._there())
        return (n for n in range(self.specification.chunks) if n not in there)

    def members(self) -> int:
        """Number of members."""
        return sum(len(self.specification.members(n)) for n in self._there())

    def put_aside(self, finished: bool) -> None:
        """Moves aside, and reports, files that are no part of the sweep, and damaged parts; if all
        parts have been written, reports missing ones, too."""
        self.put_strangers_aside()
        there = sorted(self._there())
        for number in range(self.specification.chunks) if finished else there:
            try:
                check(self.of(number), self.specification, number)
            except DamagedError as error:
                put_aside(self.path, error.path, error.why, "made again")

    def put_strangers_aside(self) -> None:
        """Moves aside, and reports, files that other programs would read as parts."""
        for name in sorted(self._names()):
            if self._number(name) is None and not name.startswith(_UNREAD):
                put_aside(self.path, self.path / MEMBERS / name, "is no part of this sweep")

    def describe(self) -> None:
        """Writes sweep.json again, and reports it, if it is damaged."""
        try:
            if read_description(self.path)[HASH] == self.specification.sha256:
                return
            why = "is of another sweep"
        except DamagedError as error:
            why = error.why
        self.describe_again(why)

    def describe_again(self, why: str) -> None:
        """Moves sweep.json aside, writes it again, and reports why."""
        put_aside(self.path, self.path / ABOUT, why, "written again")
        self.write_description()

    def write_description(self) -> None:
        """Write sweep.json."""
        its = self.specification
        whole(self.path / ABOUT, as_text({HASH: its.sha256, SPECIFICATION: its.data, **self.about}))

    def _there(self) -> tuple[int, ...]:
        """The numbers of the chunks that have a file."""
        numbers = map(self._number, self._names())
        return tuple(n for n in numbers if n is not None)

    def _names(self) -> list[str]:
        """The names of the files in members/."""
        folder = self.path / MEMBERS
        with reading(folder):
            return os.listdir(folder) if folder.is_dir() else []

    def _number(self, name: str) -> int | None:
        """The number of the chunk whose file has this name, None if none has."""
        match = _PART.fullmatch(name)
        number = int(match[1]) if match else self.specification.chunks
        return number if number < self.specification.chunks and self.of(number).name == name \
            else None

    def write(self, number: int, content: bytes) -> None:
        """Add a chunk.  Raises OSError, and then the folder is as before."""
        whole(self.of(number), content)


def part_of(folder: Path, number: int) -> Path:
    """The file of a chunk of the sweep in this folder."""
    return folder / MEMBERS / f"part-{number:08d}.parquet"


@contextmanager
def opened(path: Path, specification: Specification, about: Mapping[str, Json]
           ) -> Iterator[Folder]:
    """Opens or makes the folder of the sweep for the block.

    Raises SweepError for a folder of another sweep, with other content, or held by another process.
    """
    path.mkdir(parents=True, exist_ok=True)
    _refuse_others(path)
    make_way(path, path / LOCK)
    with held(path / LOCK, wait=False) as mine:
        if not mine:
            raise SweepError(f"{path}: another sweep is running into this folder; wait for it, or "
                             "take another --out")
        folder = Folder(path, specification, about)
        _know(folder)
        make_way(path, path / MEMBERS, is_folder=True)
        (path / MEMBERS).mkdir(exist_ok=True)
        for left in (*path.glob(".*.part"), *(path / MEMBERS).glob(".*.part")):
            remove(left)  # by a process that was killed
        yield folder


def whole(path: Path, content: bytes) -> None:
    """Writes a file completely, or raises an OSError that names it, and leaves nothing."""
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
    """Refuses a folder with files but no sweep."""
    strange = next((x.name for x in sorted(path.iterdir()) if x.name != LOCK), None)
    if strange and not (path / ABOUT).exists() and _sweep_of_parts(path) is None:
        raise SweepError(f"{path}: holds {strange}, and no sweep; wanted a new or empty folder, or "
                         "one of this sweep")


def _know(folder: Folder) -> None:
    """Writes the sweep's definition, or compares it with the folder's."""
    path, its = folder.path, folder.specification
    try:
        there = read_description(path)
    except DamagedError as error:
        if not os.path.lexists(path / ABOUT) and not os.path.lexists(path / MEMBERS):
            folder.write_description()  # of a new one
        else:
            _refuse_without_about(path, its.sha256, error)
            folder.describe_again(error.why)
        return
    if there[HASH] != its.sha256:
        differ = ", ".join(_differing("", there[SPECIFICATION], its.data))
        raise SweepError(f"{path}: holds another sweep, {str(there[HASH])[:12]}; this one is "
                         f"{its.sha256[:12]}; they differ in {differ or 'their form'}")


def _refuse_without_about(path: Path, digest: str, error: DamagedError) -> None:
    """Refuse a folder whose sweep.json is damaged unless its parts are of this sweep, or there are
    none."""
    result = _sweep_of_parts(path)
    if result is None and not (path / MEMBERS).is_dir():
        raise SweepError(f"{path / ABOUT}: {error.why}, and nothing beside it is of a sweep; "
                         "wanted a new or empty folder, or one of this sweep")
    if result is None and any((path / MEMBERS).glob("part-*.parquet")):
        raise SweepError(f"{path / ABOUT}: {error.why}, and no part beside it is undamaged, so the "
                         f"sweep cannot be identified; take another --out, or remove {path}")
    if result not in (None, digest):
        raise SweepError(f"{path / ABOUT}: {error.why}; the parts beside it are of another sweep, "
                         f"{str(result)[:12]}; this one is {digest[:12]}; take another --out")


def _sweep_of_parts(path: Path) -> str | None:
    """The hash of the sweep of the first undamaged part; None if all are damaged."""
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
