"""Reads recordings that `write` wrote: their provenance, and their numbers."""

import csv
import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TypeVar

import numpy as np

from coscrew_codegen.simulation import SimulateError

Value = TypeVar("Value")


def provenance_of(path: Path, argument: str) -> dict[str, str]:
    """Returns names and values.  Raises SimulateError, whose message names the argument by `said`.
    """
    return _read(path, argument, _READERS)


def columns_of(path: Path, argument: str) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Returns the times, and the numbers by the names of columns.  Raises SimulateError likewise.
    """
    return _read(path, argument, TABLES)


def _read(path: Path, argument: str, readers: Mapping[str, Callable[[Path], Value]]) -> Value:
    reader = readers.get(path.suffix)
    if reader is None:
        raise SimulateError(f"{argument}: {path}: wanted a recording, {', '.join(readers)}")
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


Table = tuple[np.ndarray, dict[str, np.ndarray]]


def _csv_table(path: Path) -> Table:
    with path.open(encoding="utf-8", newline="") as file:
        names, *rows = csv.reader(line for line in file if not line.startswith("# "))
    return _as_table([name.rpartition(" [")[0] for name in names], np.array(rows, float))


def _npz_table(path: Path) -> Table:
    with np.load(path, allow_pickle=False) as file:
        return _as_table(["t", *map(str, file["columns"])],
                         np.column_stack((file["t"], file["values"])))


def _parquet_table(path: Path) -> Table:
    import pyarrow.parquet

    table = pyarrow.parquet.read_table(path)
    return _as_table(table.column_names, np.column_stack([x.to_numpy() for x in table.columns]))


def _as_table(names: Sequence[str], values: np.ndarray) -> Table:
    if names[0] != "t" or not len(values):
        raise ValueError("its first column is not t, or it has no rows")
    return values[:, 0], dict(zip(names[1:], values[:, 1:].T, strict=True))


TABLES: dict[str, Callable[[Path], Table]] = {
    ".csv": _csv_table, ".npz": _npz_table, ".parquet": _parquet_table}
"""Readers of numbers, by the endings of names."""
_READERS: dict[str, Callable[[Path], dict[str, str]]] = {
    ".csv": _of_csv, ".npz": _of_npz, ".parquet": _of_parquet}
