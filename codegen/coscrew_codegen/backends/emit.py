"""Writes generated files, all or none, or checks that the files on disk are current."""

import contextlib
import difflib
import errno
import os
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path

from coscrew_codegen.program.reported_error import ReportedError

MARK = "Made by `coscrew generate"


class EmitError(ReportedError, OSError):
    """The files cannot be written; those on disk are unchanged."""


def read(folder: Path, path: str) -> str | None:
    """The text on disk, or None if it cannot be read."""
    try:
        return (folder / path).read_bytes().decode("utf-8", errors="replace")
    except OSError:
        return None


def differences(files: Mapping[str, str], folder: Path, stale: tuple[str, ...] = ()) -> list[str]:
    """Unified diffs from the files on disk to the generated ones; empty when current."""
    wanted: dict[str, str | None] = {**files, **dict.fromkeys(stale)}
    diffs = []
    for path, new in sorted(wanted.items()):
        old = read(folder, path)
        if old != new:
            lines = difflib.unified_diff(
                (old or "").splitlines(keepends=True), (new or "").splitlines(keepends=True),
                f"{path} (on disk)" if old is not None else "/dev/null",
                f"{path} (generated)" if new is not None else "/dev/null")
            diffs.append("".join(line if line.endswith("\n") else f"{line}\n" for line in lines)
                         or f"{path}: one of the two is missing or empty\n")
    return diffs


def stale_files(files: Mapping[str, str], folder: Path) -> tuple[str, ...]:
    """Files that an earlier run made and this one does not, in the folders that it writes to."""
    owned = sorted({Path(path).parts[0] for path in files})
    endings = {Path(path).suffix for path in files}
    present = (p for name in owned for p in (folder / name).rglob("*")
               if p.is_file() and p.suffix in endings)
    names = sorted(p.relative_to(folder).as_posix() for p in present)
    return tuple(name for name in names
                 if name not in files and MARK in (read(folder, name) or "")[:200])


def refuse_others(files: Mapping[str, str], folder: Path) -> None:
    """Raise EmitError if one of the files exists already and was not generated."""
    for path in sorted(files):
        if (text := read(folder, path)) and MARK not in text[:200]:
            raise EmitError(f"{folder / path} is there already, and not made by coscrew generate; "
                            "nothing was changed")


def write(files: Mapping[str, str], folder: Path, stale: tuple[str, ...] = ()) -> list[str]:
    """Write the files that differ and remove the stale ones; returns the paths changed.

    Everything is written to temporary files first and renamed only when all are complete, so that
    an error or an interrupt leaves every old file whole.  Raises EmitError.
    """
    changed = [path for path, text in sorted(files.items()) if read(folder, path) != text]
    waiting: dict[Path, Path] = {}
    try:
        with _refusing(folder, "nothing was changed"):
            for path in changed:
                waiting[folder / path] = _write_temporary(folder / path, files[path])
        with _refusing(folder, "files not yet renamed are as they were; run it again"):
            for target, temporary in waiting.items():
                os.replace(temporary, target)
            for path in stale:
                (folder / path).unlink()
    finally:
        for temporary in waiting.values():
            temporary.unlink(missing_ok=True)
    return [*changed, *stale]


@contextlib.contextmanager
def _refusing(folder: Path, consequence: str) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise EmitError(f"cannot write {error.filename or folder}: {error.strerror}; "
                        f"{consequence}") from error


def _write_temporary(target: Path, text: str) -> Path:
    if target.is_dir():
        raise IsADirectoryError(errno.EISDIR, "it is a folder", str(target))
    target.parent.mkdir(parents=True, exist_ok=True)
    descriptor, name = tempfile.mkstemp(prefix=f".{target.name}.", dir=target.parent)
    try:
        with os.fdopen(descriptor, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        os.chmod(name, 0o644)
    except BaseException:
        os.unlink(name)
        raise
    return Path(name)
