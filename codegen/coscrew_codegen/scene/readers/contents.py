"""Reads files up to a given size: bytes, or text in UTF-8."""

from pathlib import Path

from coscrew_codegen.scene.readers.scene_error import SceneError

_LFS = b"version https://git-lfs.github.com/spec/"


def read_text(path: Path, largest: int = 2**20, wanted: str = "text in UTF-8") -> str:
    """The text of a file in UTF-8, with \\n at the ends of lines; SceneError as `read_bytes`, or if
    it is in another encoding than the `wanted` file."""
    contents = read_bytes(path, largest)
    try:
        return contents.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        raise SceneError(path, f"byte {error.start}", f"is not UTF-8; wanted {wanted}") from None


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
