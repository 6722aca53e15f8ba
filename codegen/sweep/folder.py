"""The folder of a sweep: sweep.json, what it is; members/, a Parquet file for each finished chunk.

Files appear whole: they are written under another name, which begins with a dot, and renamed."""

import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from coscrew_codegen.pages import Json
from coscrew_codegen.sweep import SweepError
from coscrew_codegen.sweep.lock import held
from coscrew_codegen.sweep.specification import Specification

LOCK, ABOUT, MEMBERS, PAGE, ZARR = ".lock", "sweep.json", "members", "summary.html", "sweep.zarr"
_HASH = "sha256"


@dataclass(frozen=True)
class Folder:
    """The folder of this sweep, held by this process."""

    path: Path
    specification: Specification

    def of(self, number: int) -> Path:
        """The file of a chunk."""
        return self.path / MEMBERS / f"part-{number:08d}.parquet"

    def missing(self) -> Iterator[int]:
        """The numbers of the chunks that are not there, in order."""
        return (n for n in range(self.specification.chunks) if not self.of(n).exists())

    def members(self) -> int:
        """How many members are there."""
        its = self.specification
        with os.scandir(self.path / MEMBERS) as files:
            count = sum(x.name.startswith("part-") for x in files)
        short = its.chunk - len(its.members(its.chunks - 1))
        return count * its.chunk - short * self.of(its.chunks - 1).exists()

    def write(self, number: int, content: bytes) -> None:
        """Add a chunk.  Raises OSError, and then the folder is as before."""
        whole(self.of(number), content)


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
    if strange and not (path / ABOUT).exists():
        raise SweepError(f"{path}: holds {strange}, and no sweep; wanted a new or empty folder, or "
                         "one of this sweep")


def _know(path: Path, specification: Specification, about: Mapping[str, Json]) -> None:
    """Write what the sweep is, or compare it with what the folder says."""
    wanted = specification.data
    if not (path / ABOUT).exists():
        told = {_HASH: specification.sha256, "specification": wanted, **about}
        whole(path / ABOUT, (json.dumps(told, indent=2, ensure_ascii=False) + "\n").encode())
        return
    try:
        there = json.loads((path / ABOUT).read_text("utf-8"))
        digest, known = there[_HASH], dict(there["specification"])
    except (ValueError, KeyError, TypeError):
        raise SweepError(f"{path / ABOUT}: cannot be read as that of a sweep") from None
    if digest != specification.sha256:
        differ = ", ".join(_differing("", known, wanted))
        raise SweepError(f"{path}: holds another sweep, {digest[:12]}; this one is "
                         f"{specification.sha256[:12]}; they differ in {differ or 'their form'}")


def _differing(name: str, a: Json, b: Json) -> Iterator[str]:
    """Names of the entries in which two specifications differ."""
    if isinstance(a, Mapping) and isinstance(b, Mapping):
        for key in sorted({*a, *b}):
            yield from _differing(key, a.get(key), b.get(key))
    elif a != b:
        short = [json.dumps(x) for x in (a, b)]
        yield f"{name} ({short[0]}, {short[1]})" if max(map(len, short)) < 40 else name
