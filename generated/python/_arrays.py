# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Arrays in and out of the kernels: precision, last axes, components, `out=`."""

import numpy as np
from numpy.typing import ArrayLike

Shape = tuple[int, ...]


def shapes(side: str) -> list[Shape]:
    """The core shapes of one side of a signature: '(3,4),(6)' → [(3, 4), (6,)]."""
    return [tuple(int(n) for n in core.split(",") if n) for core in side[1:-1].split("),(")]


WANTED = "float64, float32 or integers up to 64 bits"


def numbers(value, name, objects=False):
    """The argument as an array of its own numbers: float64, float32, integers; of `objects`, too,
    where they can compute.  Raises TypeError for all else."""
    if isinstance(value, np.ndarray) and type(value) is not np.ndarray and isinstance(
            value, np.ma.MaskedArray):
        raise TypeError(f"{name}: a masked array came; {WANTED}, without a mask, are wanted")
    if hasattr(type(value), "__pandas_priority__"):
        raise TypeError(f"{name}: a pandas {type(value).__name__} came; its to_numpy() is wanted, "
                        f"of {WANTED}")
    try:
        found = np.asarray(value)
    except Exception as error:  # of rows of different lengths, of a tracer, of a tensor elsewhere
        reason = str(error).partition("\n")[0]
        raise TypeError(f"{name}: {type(value).__name__} came, of which NumPy makes no array "
                        f"({reason}); {WANTED} are wanted") from error
    if found.dtype == object:
        if not (objects and all(hasattr(x, "__neg__") for x in found.flat)):
            kinds = ", ".join(sorted({type(x).__name__ for x in found.flat}))
            raise TypeError(f"{name}: objects ({kinds}) came; {WANTED} are wanted")
    elif found.dtype.kind not in "iu" and found.dtype.type not in (np.float64, np.float32):
        raise TypeError(f"{name}: {found.dtype} came; {WANTED} are wanted")
    return found


def cast(array, name, kind):
    """The numbers in this precision; objects as they are.  Raises ValueError for a number that is
    finite, but not in this precision."""
    if array.dtype == kind or array.dtype == object:
        return array
    if array.dtype.kind != "f" or array.itemsize <= np.dtype(kind).itemsize:
        return array.astype(kind)
    try:
        with np.errstate(over="raise", under="ignore", invalid="ignore"):
            return array.astype(kind)
    except FloatingPointError:
        largest = np.abs(array)[np.isfinite(array)].max()
        raise ValueError(f"{name}: a number of magnitude {largest} came; the largest in "
                         f"{np.dtype(kind)} is {np.finfo(kind).max}") from None


def array(value: ArrayLike, name: str, core: Shape, function: str, objects: bool) -> np.ndarray:
    """The argument as an array of its own numbers, its last axes checked."""
    found = numbers(value, f"{function}: {name}", objects)
    if found.shape[max(found.ndim - len(core), 0):] != core:
        raise ValueError(f"{function}: {name} has shape {found.shape}; "
                         f"its last axes must be {core}")
    return found


def overrides(value: object) -> bool:
    """Whether it answers calls of ufuncs itself, as dask's arrays do; pandas' tables may not."""
    return not hasattr(type(value), "__pandas_priority__") and getattr(type(value), "__array_ufunc__", np.ndarray.__array_ufunc__) is not (
        np.ndarray.__array_ufunc__)


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
