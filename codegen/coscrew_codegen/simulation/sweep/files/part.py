"""Parts: Parquet files of chunks, each with the SHA-256 of its bytes, which every reader checks.

The digest stands in the file's key-value metadata, under SEAL; it is the digest of the bytes with
zeros in its place.  So one flipped bit anywhere is detected: in numbers, statistics, names, or the
digest itself."""

import errno
import json
import os
import re
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path

import pyarrow
import pyarrow.parquet

from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.specification import Specification

SEAL = "coscrew.sha256"
_BLANK = b"0" * 64
_SEALED = re.compile(re.escape(SEAL.encode()) + rb"\x18\x40([0-9a-f]{64})")
"""Key and value in Thrift's compact protocol, in which Parquet writes metadata: 0x18 begins a
binary field, 0x40 is its length."""
_MEMBER, _PROVENANCE, _SWEEP = "member", b"coscrew", "sweep sha256"
_SPOILT = (errno.EIO, errno.ELOOP, errno.ENOTDIR)  # of data that the disk has lost


class DamagedError(SweepError):
    """A file of a sweep differs from its written content."""

    def __init__(self, path: Path, why: str) -> None:
        super().__init__(f"{path}: {why}; the command that made the sweep makes it again")
        self.path, self.why = path, why


class BlockedError(SweepError):
    """A file of a sweep needs a person's help; the message says which."""


@contextmanager
def reading(path: Path) -> Iterator[None]:
    """Raises, in the block, BlockedError for a file that cannot be read, by default this one."""
    try:
        yield
    except OSError as error:
        where = Path(error.filename or path)
        other = "" if os.path.isdir(where) else (
            ", or remove it, and the command that made the sweep makes it again")
        raise BlockedError(f"{where}: cannot be read: {error.strerror or error}; make it readable"
                           f"{other}") from None


def sealed(table: pyarrow.Table) -> bytes:
    """The file of a table, with its digest."""
    sink = pyarrow.BufferOutputStream()
    with pyarrow.parquet.ParquetWriter(sink, table.schema, compression="zstd") as writer:
        writer.write_table(table)
        writer.add_key_value_metadata({SEAL: _BLANK.decode()})
    content = bytes(sink.getvalue())
    start, end = _place(content)
    return content[:start] + _digest(content, start, end) + content[end:]


def verified(path: Path) -> bytes:
    """The bytes of a part.  Raises DamagedError if they differ from the written ones."""
    content = read_bytes(path)
    if not content:
        raise DamagedError(path, "is empty")
    if len(content) < 12 or content[:4] != b"PAR1" or content[-4:] != b"PAR1":
        raise DamagedError(path, f"is cut off or overwritten ({len(content)} bytes)")
    try:
        start, end = _place(content)
    except ValueError:
        raise DamagedError(path, f"has no checksum ({SEAL}), as parts of older versions, or lost "
                                 "it") from None
    if content[start:end] != _digest(content, start, end):
        raise DamagedError(path, "differs from its checksum")
    return content


def read_bytes(path: Path) -> bytes:
    """The bytes of a file of the sweep.  Raises DamagedError if it is missing or the disk lost it,
    BlockedError if reading it is not allowed."""
    with reading(path):
        try:
            if not stat.S_ISREG(path.stat().st_mode):
                raise DamagedError(path, "is no file")
            return path.read_bytes()
        except FileNotFoundError:
            raise DamagedError(path, "is gone") from None
        except OSError as error:
            if error.errno in _SPOILT:
                raise DamagedError(path, f"cannot be read: {error.strerror}") from None
            raise


def read(path: Path, columns: list[str] | None = None) -> pyarrow.Table:
    """The table of a part, or these columns of it.  Raises DamagedError."""
    return pyarrow.parquet.read_table(pyarrow.BufferReader(verified(path)), columns=columns)


def read_metadata(path: Path) -> pyarrow.parquet.FileMetaData:
    """The metadata of a part: its statistics.  Raises DamagedError."""
    return pyarrow.parquet.read_metadata(pyarrow.BufferReader(verified(path)))


def check(path: Path, specification: Specification, number: int) -> None:
    """Raise DamagedError unless this is the part of this number of the sweep, as it was written."""
    table = read(path, [_MEMBER])
    if _sweep(table) != specification.sha256:
        raise DamagedError(path, "is of another sweep")
    if table[_MEMBER].to_pylist() != list(specification.members(number)):
        raise DamagedError(path, "holds the members of another part")


def sweep_of(path: Path) -> str:
    """The hash of a part's sweep.  Raises DamagedError."""
    return _sweep(read(path, [_MEMBER]))


def _sweep(table: pyarrow.Table) -> str:
    return str(json.loads(table.schema.metadata[_PROVENANCE])[_SWEEP])


def _place(content: bytes) -> tuple[int, int]:
    """Returns the place of the digest.  Raises ValueError if there is none, or several."""
    (result,) = _SEALED.finditer(content)
    return result.span(1)


def _digest(content: bytes, start: int, end: int) -> bytes:
    """The digest of the content, with zeros where the digest stands."""
    result = sha256(content[:start])
    result.update(_BLANK)
    result.update(content[end:])
    return result.hexdigest().encode()
