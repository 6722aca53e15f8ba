"""Values as bytes, for the cache and for other processes: the only module that pickles."""

import pickle
import zlib
from collections.abc import Callable
from typing import Any


def packed(value: object) -> bytes:
    """The value, pickled and compressed."""
    return zlib.compress(pickle.dumps(value), 1)


def unpacked(content: bytes) -> Any:
    """The value.  Bytes that are not `packed` may raise any error."""
    return pickle.loads(zlib.decompress(content))


def standard(value: object) -> tuple[Callable[[bytes], Any], bytes]:
    """A function of Python's own, and the bytes from which it makes the value: processes without
    this package can receive both."""
    return pickle.loads, pickle.dumps(value)
