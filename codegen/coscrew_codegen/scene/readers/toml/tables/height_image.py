"""Reads heights of the ground from an image in grey, { file = "ground.png", size = [20, 10],
heights = [0, 1.5] }: black is the lower height, white the upper one."""

from io import BytesIO
from pathlib import Path

from coscrew_codegen.scene.contacts.height_grid import MOST, HeightGrid
from coscrew_codegen.scene.formulas import PLACE
from coscrew_codegen.scene.readers.contents import read_bytes
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable

_SIZE = 2**25  # bytes
_WHITE = {"L": 2**8 - 1, "I;16": 2**16 - 1, "I;16B": 2**16 - 1}
"""The brightest value, by Pillow's name of images in grey of 8 and 16 bits."""


def height_image(table: TomlTable, path: Path) -> HeightGrid:
    """The heights of an image whose outer points are `size` apart, around the origin: columns along
    x, rows against y.  Raises SceneError."""
    table.only("file", "size", "heights")
    size, heights = (table.numbers(key, (2,)) for key in ("size", "heights"))
    if min(size) <= 0:
        table.refuse("size", f"{[float(x) for x in size]}; wanted two positive lengths")
    low, high = heights
    if not low < high:
        table.refuse("heights", f"{[float(x) for x in heights]}; wanted the height of black and a "
                     "larger one of white")
    rows, white = _grey(path)
    known = [low + (high - low) * k / white for k in range(white + 1)]  # one object for each
    return HeightGrid(
        f"heights of {path.name}", of=PLACE, start=(-size[0] / 2, -size[1] / 2),
        spacing=(size[0] / (len(rows[0]) - 1), size[1] / (len(rows) - 1)),
        rows=tuple(tuple(known[x] for x in row) for row in reversed(rows)))


def _grey(path: Path) -> tuple[list[list[int]], int]:
    """The image's values by rows from the top, and that of white."""
    try:
        from PIL import Image, UnidentifiedImageError  # imported on use: few scenes need it
    except ImportError:
        raise SceneError(path, "", "is an image, which needs Pillow: pip install "
                         "\"coscrew[simulate]\"") from None
    contents = read_bytes(path, _SIZE)
    try:
        with Image.open(BytesIO(contents), formats=["PNG"]) as image:
            width, height = image.size
            if min(width, height) < 2 or width * height > MOST:
                raise SceneError(path, "", f"has {width} × {height} points; wanted two or more in "
                                 f"each direction, {MOST} at most")
            if image.mode not in _WHITE:
                raise SceneError(path, "", f"has the colours {image.mode!r}; wanted grey of 8 or "
                                 "16 bits, without transparency")
            import numpy as np

            values: list[list[int]] = np.asarray(image).tolist()
            return values, _WHITE[image.mode]
    except (UnidentifiedImageError, OSError, SyntaxError, ValueError) as error:
        if isinstance(error, SceneError):
            raise
        raise SceneError(path, "", f"cannot be read as a PNG image ({error})") from None
