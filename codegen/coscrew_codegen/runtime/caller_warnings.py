"""Warnings from inside the package, issued at the line of the user's program that called it.

A function that users call does its work within `at_callers_line`, or what it calls where that would
take too long; `warn`, called anywhere below, leaves its text there, and the outermost block issues
it when it ends.
"""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_WAITING = ContextVar[list[str] | None]("_WAITING", default=None)


def warn(text: str) -> None:
    """Issue a RuntimeWarning where the outermost `at_callers_line` stands; here if there is none.
    """
    waiting = _WAITING.get()
    if waiting is None:
        warnings.warn(text, RuntimeWarning, stacklevel=2)
    else:
        waiting.append(text)


@contextmanager
def at_callers_line(above: int = 0) -> Iterator[None]:
    """Issue the warnings that arise within at the line that calls the function with this block or,
    if functions are `above` it, the outermost of these."""
    if _WAITING.get() is not None:
        yield
        return
    waiting: list[str] = []
    before = _WAITING.set(waiting)
    try:
        yield
    finally:
        _WAITING.reset(before)
        for text in waiting:  # over here are contextlib, the function with the block, its caller
            warnings.warn(text, RuntimeWarning, stacklevel=4 + above)
