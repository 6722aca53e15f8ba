"""A hash of a value's content."""

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum

from coscrew_codegen.scene.effect import Effect
from coscrew_codegen.scene.mechanism.joint_kind import JointKind


def hashed(value: object) -> str:
    """SHA-256 of everything in a value, such as a scene and its model, independent of the files'
    layout."""
    return hashlib.sha256("\n".join(_as_text(value)).encode()).hexdigest()


def _as_text(value: object) -> Iterator[str]:
    """The value as unambiguous text: effects and kinds of joints by name, mappings sorted, exact
    fractions."""
    if isinstance(value, Effect | JointKind | Enum):
        yield f"{type(value).__name__} {value.name}"
    elif is_dataclass(value):
        yield type(value).__name__
        for field in fields(value):
            empty = "unhashed if empty" in field.metadata and not getattr(value, field.name)
            if field.compare and not empty:
                yield field.name
                yield from _as_text(getattr(value, field.name))
    elif isinstance(value, Mapping):
        for key in sorted(value):
            yield f"key {key}"
            yield from _as_text(value[key])
    elif isinstance(value, tuple | list):
        yield f"{len(value)} entries"
        for entry in value:
            yield from _as_text(entry)
    else:
        yield repr(value)
