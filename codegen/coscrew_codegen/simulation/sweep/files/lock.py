"""Locks between processes; a lock ends with the process that holds it, however that ends."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO


@contextmanager
def held(path: Path, wait: bool) -> Iterator[bool]:
    """Holds the lock of this file, which is not removed, during the block; yields whether it is
    held.  Without `wait` it is not held if another process holds it."""
    with path.open("ab") as file:
        yield _locked(file, wait)


def _locked(file: BinaryIO, wait: bool) -> bool:
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(file.fileno(), msvcrt.LK_LOCK if wait else msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
    except (BlockingIOError, PermissionError):
        return False
    return True
