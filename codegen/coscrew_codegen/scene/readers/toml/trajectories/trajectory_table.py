"""Reads trajectories, { file = "reach.csv", column = "elbow" }, from tables with a column of time.
"""

import csv
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

from coscrew_codegen.scene.readers.contents import read_text
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable
from coscrew_codegen.scene.readers.toml.trajectories.interpolant import MOST, Interpolant

_SIZE = 2**24  # bytes
KEYS = ("file", "column", "time")


def is_trajectory(value: object) -> bool:
    """Returns whether a value is a table that names a file."""
    return isinstance(value, dict) and "file" in value


def trajectory(table: TomlTable) -> Interpolant:
    """The trajectory that a table names.  Raises SceneError, with the file and the line."""
    table.only(*KEYS)
    column, time = table.text("column"), table.text("time", "t")
    path = table.file.parent / table.text("file")
    names, rows = _rows(path)
    places = [_place(table, key, name, names, path)
              for key, name in (("time", time), ("column", column))]
    if len(rows) < 2:
        raise SceneError(path, "", f"has {len(rows)} rows of numbers; wanted two or more")
    if len(rows) > MOST:
        raise SceneError(path, "", f"has {len(rows)} rows; wanted at most {MOST}: take fewer points"
                         ", between which the target is smooth, or set the target by a controller")
    times, values = ([_number(path, line, row, place) for line, row in rows] for place in places)
    for (line, _), (a, b) in zip(rows[1:], pairwise(times), strict=True):
        if b <= a:
            raise SceneError(path, f"line {line}", f"time {float(b):g} after {float(a):g}; wanted "
                             "times that increase")
    return Interpolant(f"{column} of {path.name}", tuple(times), tuple(values))


def _rows(path: Path) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """The names of columns, and the rows with the numbers of their lines; comments begin with #."""
    lines = [(n, line) for n, line in enumerate(read_text(path, _SIZE).splitlines(), 1)
             if line.strip() and not line.startswith("#")]
    parsed = list(csv.reader(line for _, line in lines))
    if not parsed:
        raise SceneError(path, "", "is empty; wanted a line with the names of columns, and rows of "
                         "numbers")
    numbered = zip((n for n, _ in lines[1:]), parsed[1:], strict=True)
    return [x.strip() for x in parsed[0]], list(numbered)


def _place(table: TomlTable, key: str, name: str, names: Sequence[str], path: Path) -> int:
    """The number of a column; the unit in brackets, as recordings have it, may be left out."""
    plain = [x.partition(" [")[0] for x in names]
    known = names if name in names else plain
    chosen = table.known(key, name, f"column of {path.name}", tuple(known))
    if list(known).count(chosen) > 1:
        table.refuse(key, f"{chosen!r} names several columns of {path.name}; wanted one")
    return list(known).index(chosen)


def _number(path: Path, line: int, row: Sequence[str], place: int) -> Fraction:
    if place >= len(row):
        raise SceneError(path, f"line {line}", f"{len(row)} columns; wanted {place + 1} or more")
    try:
        return decimal(row[place].strip())
    except ValueError as error:
        raise SceneError(path, f"line {line}", str(error)) from None
