"""Reads heights of the ground, { file = "ground.csv" }: the first row has the x of the columns, the
first column the y of the rows."""

import csv
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

from coscrew_codegen.scene.contacts.height_grid import MOST, HeightGrid
from coscrew_codegen.scene.formulas import PLACE
from coscrew_codegen.scene.readers.contents import read_text
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.tables.height_image import height_image
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable

_SIZE = 2**25  # bytes
_UNEVEN = Fraction(1, 10**6)
"""Difference of two spacings, relative to them, below which they are the same."""


def height_grid(table: TomlTable) -> HeightGrid:
    """The heights that a table names.  Raises SceneError, with the file and the line."""
    path = table.file.parent / table.text("file")
    if path.suffix.lower() == ".png":
        return height_image(table, path)
    table.only("file")
    lines = [(n, line) for n, line in enumerate(read_text(path, _SIZE).splitlines(), 1)
             if line.strip() and not line.startswith("#")]
    cells = list(zip((n for n, _ in lines), csv.reader(x for _, x in lines), strict=True))
    if len(cells) < 3 or len(cells[0][1]) < 3:
        raise SceneError(path, "", "wanted two rows and two columns of heights or more, below a "
                         "row with their x and behind a column with their y")
    (first, head), *rows = cells
    count = len(rows) * (len(head) - 1)
    if count > MOST:
        raise SceneError(path, "", f"has {count} heights; wanted at most {MOST}: take fewer, "
                         "between which the ground is smooth, or a formula of x and y")
    for n, row in rows:
        if len(row) != len(head):
            raise SceneError(path, f"line {n}", f"{len(row)} columns; wanted {len(head)}")
    xs = [_number(path, first, x) for x in head[1:]]
    ys = [_number(path, n, row[0]) for n, row in rows]
    heights = tuple(tuple(_number(path, n, x) for x in row[1:]) for n, row in rows)
    spacing = (_spacing(path, "x", xs), _spacing(path, "y", ys))
    return HeightGrid(f"heights of {path.name}", of=PLACE, start=(xs[0], ys[0]), spacing=spacing,
                      rows=heights)


def _number(path: Path, line: int, text: str) -> Fraction:
    try:
        return decimal(text.strip())
    except ValueError as error:
        raise SceneError(path, f"line {line}", str(error)) from None


def _spacing(path: Path, name: str, places: Sequence[Fraction]) -> Fraction:
    """The distance of two neighbours.  Raises SceneError unless all have the same."""
    mean = (places[-1] - places[0]) / (len(places) - 1)
    for a, b in pairwise(places):
        if not mean > 0 or abs(b - a - mean) > mean * _UNEVEN:
            wanted = f"even steps, here of {float(mean):g}" if mean > 0 else "places that increase"
            raise SceneError(path, "", f"{name} {float(b):g} after {float(a):g}; wanted {wanted}")
    return mean
