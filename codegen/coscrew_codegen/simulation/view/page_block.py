"""Data of a page: JSON, and its arrays in one compressed block, in which JSON refers to places.

The bytes of an array stand in planes, the first byte of every number, then the second ones, since
neighbours in a plane are alike and compress to about half."""

import base64
import json
import zlib

import numpy as np
from markupsafe import Markup

from coscrew_codegen.program.values.json_values import Json, finite

KINDS = ("f8", "f4", "u2", "i2", "i4")


class NumberBlock:
    """Collects arrays; `text` is all of them, compressed."""

    def __init__(self) -> None:
        self._bytes = bytearray()

    def put(self, numbers: np.ndarray, kind: str) -> Json:
        """Append an array as numbers of this kind; returns its place: [byte, kind, count]."""
        at, flat = len(self._bytes), np.ascontiguousarray(numbers, f"<{kind}").ravel()
        planes = flat.view(np.uint8).reshape(flat.size, flat.itemsize)
        self._bytes += planes.T.tobytes()
        return [at, kind, flat.size]

    @property
    def text(self) -> str:
        """The block for the page."""
        return compressed(bytes(self._bytes))


def compressed(content: bytes) -> str:
    """The content, deflated, in base64."""
    return base64.b64encode(zlib.compress(content, 9)).decode()


def embedded(data: Json) -> Markup:
    """JSON that is safe in a script element: without `<`, and without bare NaN or Infinity."""
    text = json.dumps(finite(data), allow_nan=False, separators=(",", ":"))
    return Markup(text.replace("<", "\\u003c"))
