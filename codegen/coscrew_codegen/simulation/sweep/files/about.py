"""Reads and writes sweep.json: the definition of a sweep and the provenance of its numbers, with a
checksum of both."""

import json
from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path

from coscrew_codegen.program.values.json_values import Json
from coscrew_codegen.simulation.sweep.files.part import DamagedError, read_bytes

ABOUT = "sweep.json"
HASH, SPECIFICATION, CHECKSUM = "sha256", "specification", "checksum"


def as_text(about: Mapping[str, Json]) -> bytes:
    """The file's bytes."""
    whole = {**about, CHECKSUM: _digest(about)}
    return (json.dumps(whole, indent=2, ensure_ascii=False) + "\n").encode()


def read_description(folder: Path) -> Mapping[str, Json]:
    """Reads the description of the sweep in this folder.  Raises DamagedError if it is not as it
    was written."""
    path = folder / ABOUT
    content = read_bytes(path)
    try:
        results = dict(json.loads(content.decode()))
    except (ValueError, TypeError):
        raise DamagedError(path, "cannot be read as that of a sweep") from None
    if CHECKSUM not in results:
        raise DamagedError(path, f"has no {CHECKSUM}, as those of older versions, or lost it")
    if results.pop(CHECKSUM) != _digest(results):
        raise DamagedError(path, f"differs from its {CHECKSUM}")
    return results


def _digest(about: Mapping[str, Json]) -> str:
    """The SHA-256 of the content, whatever the order of its keys."""
    return sha256(json.dumps(about, sort_keys=True).encode()).hexdigest()
