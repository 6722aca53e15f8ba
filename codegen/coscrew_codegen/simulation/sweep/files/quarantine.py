"""Moves damaged files, and files in the way of others, into damaged/, and reports them."""

import os
import shutil
import sys
from contextlib import suppress
from itertools import chain, count
from pathlib import Path

from coscrew_codegen.simulation.sweep.files.part import BlockedError

DAMAGED = "damaged"


def put_aside(folder: Path, path: Path, why: str, then: str = "") -> None:
    """Moves a file of the sweep in this folder, if it exists, into damaged/; reports the reason and
    the next action.  Raises BlockedError."""
    done = [f"set aside as {_moved(folder, path, why)}"] if os.path.lexists(path) else []
    print(f"coscrew: {path}: {why}; {', '.join(done + [then] * bool(then))}", file=sys.stderr)


def make_way(folder: Path, path: Path, is_folder: bool = False) -> None:
    """Moves aside a folder in the place of a file of the sweep, or a file in the place of a folder.
    """
    if is_folder and os.path.lexists(path) and not path.is_dir():
        put_aside(folder, path, "is no folder", "made again")
    if not is_folder and path.exists() and not path.is_file():
        put_aside(folder, path, "is no file", "made again")


def remove(path: Path) -> None:
    """Removes a file, a link, or as much as possible of a folder, if it exists."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        with suppress(FileNotFoundError):
            path.unlink()


def _moved(folder: Path, path: Path, why: str) -> Path:
    """The new name, beside sweep.json, of a file that was moved."""
    kept = folder / DAMAGED
    if os.path.lexists(kept) and not kept.is_dir():
        raise BlockedError(f"{path}: {why}, and cannot be set aside: {kept} is no folder; rename "
                           f"or remove {kept}, and give the same command again")
    names = (kept / f"{path.name}{end}" for end in chain([""], (f".{n}" for n in count(2))))
    try:
        kept.mkdir(exist_ok=True)
        target = next(x for x in names if not os.path.lexists(x))
        os.replace(path, target)
    except OSError as error:
        raise BlockedError(f"{path}: {why}, and cannot be moved into {kept}: "
                           f"{error.strerror or error}; move or remove it, and give the same "
                           "command again") from None
    return target.relative_to(folder)
