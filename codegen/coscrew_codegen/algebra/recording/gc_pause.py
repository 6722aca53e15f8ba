"""Python's garbage collector, and what takes less time without it."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def uncollected() -> Iterator[None]:
    """Without Python's garbage collector, which walks all instructions again and again while there
    are ever more of them: of 100 joints it took a third of the time, and more of more."""
    on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if on:
            gc.enable()
