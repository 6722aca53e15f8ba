"""Values of JSON files, and what stands there for numbers that JSON lacks."""

import json
from collections.abc import Callable, Mapping, Sequence
from math import isfinite

Json = Mapping[str, "Json"] | Sequence["Json"] | str | float | bool | None


def finite(data: Json, instead: Callable[[float], Json] = json.dumps) -> Json:
    """The data without NaN and infinities: as strings, "NaN", "Infinity" and "-Infinity", or what
    stands `instead`."""
    if isinstance(data, Mapping):
        return {key: finite(value, instead) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [finite(value, instead) for value in data]
    return instead(data) if isinstance(data, float) and not isfinite(data) else data
