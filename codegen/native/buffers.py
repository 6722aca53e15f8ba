"""Arrays for timed loops: where they lie decides what they cost, so it is the same in every run.

Everything starts at a multiple of a cache line, and blocks start at a page.  Planes are an odd
number of lines apart, so that of a first-level cache's 64 sets no two of 64 planes begin in one.
"""

from collections.abc import Sequence

import numpy as np

LINE = 64
_PAGE = 4096


def plane_length(elements: int, size: int) -> int:
    """How many numbers of `size` bytes it is from one plane of `elements` to the next."""
    return (-(-elements * size // LINE) | 1) * LINE // size


def planes(arrays: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Arrays (n, …) of one type, component by component, row by row, all in one block: each as
    (components, plane_length); what lies between planes is 1."""
    length = plane_length(len(arrays[0]), arrays[0].itemsize)
    columns = [x.reshape(len(x), -1).T for x in arrays]
    block = _aligned((sum(map(len, columns)), length), arrays[0].dtype, _PAGE)
    block[:] = 1
    found, first = [], 0
    for column in columns:
        part = block[first:first + len(column)]
        part[:, :column.shape[1]] = column
        found.append(part)
        first += len(column)
    return found


def aligned(array: np.ndarray) -> np.ndarray:
    """A copy in C's order that starts at a multiple of a cache line."""
    copy = _aligned(array.shape, array.dtype, LINE)
    copy[...] = array
    return copy


def _aligned(shape: tuple[int, ...], dtype: np.dtype, boundary: int) -> np.ndarray:
    size = int(np.prod(shape)) * dtype.itemsize
    memory = np.empty(size + boundary, np.uint8)
    start = -memory.ctypes.data % boundary
    return memory[start:start + size].view(dtype).reshape(shape)
