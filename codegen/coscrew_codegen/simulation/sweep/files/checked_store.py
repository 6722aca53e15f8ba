"""A store of Zarr whose files are compared with their checksums as they are read.

The checksums stand beside it, in the form of `sha256sum`: `sha256sum -c sweep.zarr.sha256` compares
them, too."""

import asyncio
import re
from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path

from zarr.abc.store import ByteRequest
from zarr.core.buffer import Buffer, BufferPrototype
from zarr.storage import LocalStore, WrapperStore

from coscrew_codegen.simulation.sweep.files.part import DamagedError, read_bytes, reading

_LINE = re.compile(r"([0-9a-f]{64})  (\S.*)")


def sums(folder: Path) -> Path:
    """The file of the checksums of a store."""
    return folder.with_name(f"{folder.name}.sha256")


def listed(made: Path, name: str) -> bytes:
    """The checksums of all files in `made`, which will be called `name`."""
    files = sorted(x.relative_to(made).as_posix() for x in made.rglob("*") if x.is_file())
    return "".join(f"{sha256((made / x).read_bytes()).hexdigest()}  {name}/{x}\n"
                   for x in files).encode()


class CheckedStore(WrapperStore[LocalStore]):
    """Reads files of a store in a folder; raises DamagedError for one that is not as written."""

    def __init__(self, store: LocalStore, known: Mapping[str, str] | None = None) -> None:
        super().__init__(store)
        self._known = _known(Path(store.root)) if known is None else known

    def _with_store(self, store: LocalStore) -> "CheckedStore":
        return type(self)(store, self._known)

    async def get(self, key: str, prototype: BufferPrototype,
                  byte_range: ByteRequest | None = None) -> Buffer | None:
        """The bytes of a file, or a range of them; None if it was never written."""
        path = Path(self._store.root) / key
        with reading(path):
            if key not in self._known and not path.is_file():
                return None
        content = await asyncio.to_thread(read_bytes, path)
        if sha256(content).hexdigest() != self._known.get(key):
            raise DamagedError(path, "differs from its checksum")
        if byte_range is not None:
            return await self._store.get(key, prototype, byte_range)
        return prototype.buffer.from_bytes(content)


def _known(folder: Path) -> dict[str, str]:
    path = sums(folder)
    lines = [_LINE.fullmatch(x) for x in read_bytes(path).decode("latin-1").splitlines()]
    if None in lines:
        raise DamagedError(path, "cannot be read as checksums")
    known = {x[2].removeprefix(f"{folder.name}/"): x[1] for x in lines if x}
    if lost := next((x for x in known if not (folder / x).exists()), None):
        raise DamagedError(folder / lost, "is gone")
    return known
