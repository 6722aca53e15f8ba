"""Arrays for timed loops: times depend on their addresses, so every run uses the same layout.

Arrays start at a multiple of a cache line, blocks at a page.  Planes are an odd number of lines
apart, so that 64 planes begin in 64 different sets of a first-level cache.
"""

from collections.abc import Sequence

import numpy as np

LINE = 64
_PAGE = 4096


def plane_length(elements: int, size: int) -> int:
    """The distance, in numbers of `size` bytes, from one plane of `elements` to the next."""
    return (-(-elements * size // LINE) | 1) * LINE // size


def planes(arrays: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Arrays (n, …) of one type as planes of components, (components, plane_length) each, all in
    one block; padding between planes is 1."""
    length = plane_length(len(arrays[0]), arrays[0].itemsize)
    columns = [x.reshape(len(x), -1).T for x in arrays]
    block = _aligned((sum(map(len, columns)), length), arrays[0].dtype, _PAGE)
    block[:] = 1
    result, first = [], 0
    for column in columns:
        part = block[first:first + len(column)]
        part[:, :column.shape[1]] = column
        result.append(part)
        first += len(column)
    return result


def aligned(array: np.ndarray) -> np.ndarray:
    """A C-ordered copy that starts at a multiple of a cache line."""
    copy = _aligned(array.shape, array.dtype, LINE)
    copy[...] = array
    return copy


def _aligned(shape: tuple[int, ...], dtype: np.dtype, boundary: int) -> np.ndarray:
    size = int(np.prod(shape)) * dtype.itemsize
    memory = np.empty(size + boundary, np.uint8)
    start = -memory.ctypes.data % boundary
    return memory[start:start + size].view(dtype).reshape(shape)
