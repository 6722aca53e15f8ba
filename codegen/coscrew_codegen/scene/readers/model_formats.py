"""The formats of models, one per module or folder here: found when a file is to be read.

A module put here with a `READER` adds its format to every scene and command, to messages and to
documentation.
"""

from collections.abc import Mapping
from functools import cache
from pathlib import Path

from coscrew_codegen.program.plugins import discover
from coscrew_codegen.scene.names import or_mean
from coscrew_codegen.scene.readers.foreign import of_suffix
from coscrew_codegen.scene.readers.model_reader import ModelReader

SCENE_SUFFIX = ".toml"
"""Marks scenes, which may name a model or hold its tables."""


@cache
def readers() -> tuple[ModelReader, ...]:
    """The catalogue, in the order of names."""
    package = __name__.rpartition(".")[0]
    every = discover(package, (str(Path(__file__).parent),), "READER", ModelReader)
    by_suffix(every)
    return tuple(sorted(every, key=lambda x: x.name))


def by_suffix(every: tuple[ModelReader, ...]) -> Mapping[str, ModelReader]:
    """The readers by suffix.  Raises ValueError for suffixes that are none, and for two formats of
    one suffix."""
    owners: dict[str, ModelReader] = {}
    for reader in every:
        for suffix in reader.suffixes:
            if not suffix.startswith(".") or suffix != suffix.lower() or suffix == SCENE_SUFFIX:
                raise ValueError(f"the format {reader.name} has the suffix {suffix!r}; wanted a "
                                 f"dot and small letters, and not {SCENE_SUFFIX}")
            if suffix in owners:
                raise ValueError(f"{owners[suffix].name} and {reader.name} both read files with "
                                 f"the suffix {suffix!r}")
            owners[suffix] = reader
    return owners


def reader_of(path: Path) -> ModelReader | None:
    """The reader of a file's format, by the longest suffix that fits; None if there is none."""
    owners = by_suffix(readers())
    fits = [x for x in owners if path.name.lower().endswith(x)]
    return owners[max(fits, key=len)] if fits else None


def stem(path: Path) -> str:
    """The file's name without the suffix of its format."""
    reader = reader_of(path)
    fits = [x for x in reader.suffixes if path.name.lower().endswith(x)] if reader else []
    return path.name[:-len(max(fits, key=len))] if fits else path.stem


def unknown(path: Path, scenes: bool = False) -> str:
    """The problem of a file whose suffix no reader has: "has the suffix '.urd'; wanted a model
    (.sdf, .urdf); did you mean '.urdf'?"; with `scenes` the file may be a scene, too."""
    known = [x for reader in readers() for x in reader.suffixes]
    scene = f"a scene ({SCENE_SUFFIX}) or " if scenes else ""
    likely = [*known, SCENE_SUFFIX] if scenes else known
    near = or_mean(path.suffix.lower(), likely) if path.suffix else ""
    return f"{of_suffix(path)}; wanted {scene}a model ({', '.join(known)}){near}"
