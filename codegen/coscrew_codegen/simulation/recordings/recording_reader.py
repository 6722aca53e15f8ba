"""Reads the provenance of recordings that `write` wrote."""

import csv
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np

from coscrew_codegen.simulation import SimulateError


def provenance_of(path: Path, argument: str) -> dict[str, str]:
    """Returns names and values.  Raises SimulateError, whose message names the argument by `said`.
    """
    reader = _READERS.get(path.suffix)
    if reader is None:
        raise SimulateError(f"{argument}: {path}: wanted a recording, {', '.join(_READERS)}")
    try:
        return reader(path)
    except OSError as error:
        raise SimulateError(f"{argument}: cannot read {path}: {error.strerror or error}") from None
    except Exception as error:  # noqa: BLE001  whatever a reader says of a broken file
        raise SimulateError(f"{argument}: {path} is no recording: {error}") from None


def _of_csv(path: Path) -> dict[str, str]:
    entries = {}
    with path.open(encoding="utf-8", newline="") as file:
        for line in file:
            if not line.startswith("# "):
                if next(csv.reader([line]))[0] != "t [s]":
                    raise ValueError("its first column is not t [s]")
                break
            what, _, value = line[2:].rstrip("\n").partition(": ")
            entries[what] = value
    return entries


def _of_npz(path: Path) -> dict[str, str]:
    with np.load(path, allow_pickle=False) as file:
        return {str(what): str(value) for what, value in file["provenance"]}


def _of_parquet(path: Path) -> dict[str, str]:
    import pyarrow.parquet

    entries: dict[str, str] = json.loads(pyarrow.parquet.read_schema(path).metadata[b"coscrew"])
    return entries


_READERS: dict[str, Callable[[Path], dict[str, str]]] = {
    ".csv": _of_csv, ".npz": _of_npz, ".parquet": _of_parquet}
