"""Reads files up to a given size."""

from pathlib import Path

from coscrew_codegen.scene.readers.scene_error import SceneError

_LFS = b"version https://git-lfs.github.com/spec/"


def read_bytes(path: Path, largest: int) -> bytes:
    """The contents of a file; SceneError if it cannot be read or is larger than `largest` bytes."""
    try:
        if path.exists() and not path.is_dir() and not path.is_file():
            raise SceneError(path, "", "is no regular file; wanted one, since others may never end")
        with path.open("rb") as file:
            contents = file.read(largest + 1)
    except (OSError, ValueError) as error:
        if isinstance(error, SceneError):
            raise
        reason = getattr(error, "strerror", None) or str(error)
        raise SceneError(path, "", f"cannot be read ({reason})") from None
    if len(contents) > largest:
        raise SceneError(path, "", f"is larger than {largest // 2**20} MiB; wanted a smaller file")
    if contents.startswith(_LFS):
        raise SceneError(path, "", "is a pointer of Git LFS, not the file itself; run `git lfs "
                         "pull` in its repository")
    return contents
