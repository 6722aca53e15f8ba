"""Folders of packages of ROS, and files in them: given ones, or beside a model's file or above it,
by their name or by that in their package.xml."""

import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

from coscrew_codegen.scene.readers.model_reader import ModelSource

_SCHEMES = ("package", "model")
"""Of URIs whose first word names a package."""


def folders_of(name: str, source: ModelSource) -> Iterator[Path]:
    """The folders that may be the package of this name, the likeliest first."""
    if name in source.packages:
        yield source.packages[name].resolve()
        return
    for folder in source.path.resolve().parents:
        if folder.name == name or _name_in(folder) == name:
            yield folder
        if (folder / name).is_dir():
            yield folder / name
        yield from _named_below(folder, name)


def file_of(uri: str, source: ModelSource) -> Path | None:
    """The file that a URI or a path names; None if there is none."""
    scheme, colon, rest = uri.strip().partition("://")
    if colon and scheme in _SCHEMES:
        package, _, inside = unquote(rest).partition("/")
        return next((x / inside for x in folders_of(package, source)
                     if (x / inside).is_file()), None)
    file = source.path.parent / (unquote(rest) if colon else uri.strip())
    return file if file.is_file() else None


def _named_below(folder: Path, name: str) -> tuple[Path, ...]:
    """The folders in this one whose package.xml gives the name."""
    return tuple(x.parent for x in sorted(folder.glob("*/package.xml"))
                 if _name_in(x.parent) == name)


def _name_in(folder: Path) -> str:
    """The name that a folder's package.xml gives; "" if it has none."""
    try:
        text = (folder / "package.xml").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""
    match = re.search(r"<name>\s*([^<\s]+)\s*</name>", text)
    return match[1] if match else ""
