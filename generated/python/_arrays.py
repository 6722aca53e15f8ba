# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors.
"""Arrays in and out of the kernels: precision, last axes, components, `out=`."""

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

Shape = tuple[int, ...]


def shapes(side: str) -> list[Shape]:
    """The core shapes of one side of a signature: '(3,4),(6)' → [(3, 4), (6,)]."""
    return [tuple(int(n) for n in core.split(",") if n) for core in side[1:-1].split("),(")]


def array(value: ArrayLike, name: str, core: Shape, function: str, dtype: DTypeLike) -> np.ndarray:
    """The argument as an array of this precision (or of objects), its last axes checked."""
    found = np.asarray(value)
    if found.dtype != object:
        if not np.can_cast(found.dtype, dtype, casting="same_kind"):
            raise TypeError(f"{function}: {name} has dtype {found.dtype}; wanted real numbers")
        found = found.astype(dtype, copy=False)
    if found.shape[max(found.ndim - len(core), 0):] != core:
        raise ValueError(f"{function}: {name} has shape {found.shape}; "
                         f"its last axes must be {core}")
    return found


def components(array: np.ndarray, core: Shape) -> np.ndarray | tuple[np.ndarray, ...]:
    """The components, row by row; a scalar argument is passed as it is."""
    if not core:
        return array
    return tuple(array[(..., *index)] for index in np.ndindex(*core))


def deliver(result: np.ndarray, out: np.ndarray | None, function: str) -> np.ndarray:
    """Put the result into `out` if there is one."""
    if out is None:
        return result[()]
    if not isinstance(out, np.ndarray):
        raise TypeError(f"{function}: out must be an array; got {type(out).__name__}")
    if out.shape != result.shape:
        raise ValueError(f"{function}: out has shape {out.shape}; the result has {result.shape}")
    np.copyto(out, result, casting="same_kind")
    return out
