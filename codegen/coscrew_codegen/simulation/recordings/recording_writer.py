"""Writes recordings as CSV, NPZ or Parquet, with provenance; a file is written completely or not at
all."""

import csv
import json
import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from coscrew_codegen.runtime.extras import pip
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.recordings.recording import Recording

FIGURES = (".svg", ".png")
"""File name endings of plots."""
_NEEDED = {".parquet": ("pyarrow", "simulate"), ".rrd": ("rerun", "rerun"),
           ".mcap": ("foxglove", "foxglove")}
"""Module that an ending needs, and the extra that installs it."""


def write(recording: Recording, path: Path) -> None:
    """Write the recording in the format of the name's ending.  Raises SimulateError."""
    with delivered(path) as temporary:
        FORMATS[path.suffix](recording, temporary)


def check_target(path: Path, endings: tuple[str, ...]) -> None:
    """Raise SimulateError if `path` cannot be written; called before anything is computed."""
    if path.suffix not in endings:
        raise SimulateError(f"{path}: wanted a name that ends in {' or '.join(endings)}")
    module, extra = _NEEDED.get(path.suffix, ("", ""))
    if module and find_spec(module) is None:
        raise SimulateError(f"{path}: {path.suffix} needs {module}; run `{pip(extra)}`")
    if path.is_dir():
        raise SimulateError(f"cannot write {path}: it is a folder")
    try:
        with tempfile.TemporaryFile(dir=path.parent):
            pass
    except OSError as error:
        raise SimulateError(f"cannot write {path}: {error.strerror}; nothing was run") from None


@contextmanager
def delivered(path: Path) -> Iterator[Path]:
    """A temporary file beside `path`, renamed to it when it is complete.  Raises SimulateError."""
    try:
        descriptor, name = tempfile.mkstemp(prefix=f".{path.name}.", suffix=path.suffix,
                                            dir=path.parent)
        os.close(descriptor)
        try:
            yield Path(name)
            os.chmod(name, 0o644)
            os.replace(name, path)
        finally:
            Path(name).unlink(missing_ok=True)
    except OSError as error:
        raise SimulateError(f"cannot write {path}: {error.strerror or error}") from error


def as_csv(recording: Recording, path: Path) -> None:
    """Lines `# what: value`, a line of names with units, then numbers that read back the same."""
    with path.open("w", encoding="utf-8", newline="") as file:
        for what, value in recording.provenance:
            file.write(f"# {what}: {' '.join(value.split())}\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("t [s]", *(f"{c.name} [{c.unit}]" for c in recording.columns)))
        for t, row in zip(recording.t.tolist(), recording.values, strict=True):
            writer.writerow((t, *map(str, row)))  # shortest decimals in their own precision


def as_npz(recording: Recording, path: Path) -> None:
    """Arrays t (n), values (n, m), columns (m), units (m), provenance (k, 2); none is pickled."""
    with path.open("wb") as file:
        np.savez_compressed(
            file, t=recording.t, values=recording.values,
            columns=np.array([c.name for c in recording.columns], np.str_),
            units=np.array([c.unit for c in recording.columns], np.str_),
            provenance=np.array(recording.provenance, np.str_).reshape(-1, 2))


def as_parquet(recording: Recording, path: Path) -> None:
    """A column for t and each quantity, its unit in the field's metadata; provenance, as JSON, in
    the schema's under `coscrew`."""
    import pyarrow
    import pyarrow.parquet

    columns = [("t", "s", recording.t),
               *((c.name, c.unit, recording.values[:, i]) for i, c in enumerate(recording.columns))]
    arrays = [pyarrow.array(np.ascontiguousarray(numbers)) for _, _, numbers in columns]
    provenance = json.dumps(dict(recording.provenance), ensure_ascii=False)
    schema = pyarrow.schema(
        [pyarrow.field(name, array.type, metadata={"unit": unit})
         for (name, unit, _), array in zip(columns, arrays, strict=True)], {"coscrew": provenance})
    pyarrow.parquet.write_table(pyarrow.table(arrays, schema=schema), path)


FORMATS: dict[str, Callable[[Recording, Path], None]] = {
    ".csv": as_csv, ".npz": as_npz, ".parquet": as_parquet}
