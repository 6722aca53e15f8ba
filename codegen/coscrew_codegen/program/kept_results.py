"""Results that are computed once for each object and kept as long as it exists."""

from collections.abc import Callable
from functools import wraps
from typing import TypeVar
from weakref import finalize

Given = TypeVar("Given")
Result = TypeVar("Result")


def kept_with(function: Callable[[Given], Result]) -> Callable[[Given], Result]:
    """Decorates a function of an object: its result is kept as long as the object.

    Equal objects have results of their own, since equal Programs may differ in the names of their
    constants, and so in text."""
    results: dict[int, Result] = {}

    @wraps(function)
    def kept(x: Given) -> Result:
        place = id(x)
        if place not in results:
            results[place] = function(x)
            finalize(x, results.pop, place, None).atexit = False  # of two threads, both do
        return results[place]

    return kept
