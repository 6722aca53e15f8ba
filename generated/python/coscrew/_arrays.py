# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Checks and converts the arguments and results of kernels: precision, last axes, `out=`."""

import numpy as np
from numpy.typing import ArrayLike

Shape = tuple[int, ...]


def shapes(side: str) -> list[Shape]:
    """The core shapes of one side of a signature: '(3,4),(6)' → [(3, 4), (6,)]."""
    return [tuple(int(n) for n in core.split(",") if n) for core in side[1:-1].split("),(")]


WANTED = "float64, float32 or integers up to 64 bits"


def numbers(value, name, objects=False):
    """The argument as an array of float64, float32 or integers, or if `objects` of any objects with
    arithmetic.  Raises TypeError for everything else."""
    if isinstance(value, np.ndarray) and type(value) is not np.ndarray and isinstance(
            value, np.ma.MaskedArray):
        raise TypeError(f"{name}: got a masked array; wanted {WANTED}, without a mask")
    if hasattr(type(value), "__pandas_priority__"):
        raise TypeError(f"{name}: got a pandas {type(value).__name__}; wanted its to_numpy(), "
                        f"of {WANTED}")
    try:
        found = np.asarray(value)
    except Exception as error:  # rows of different lengths, a tracer, a tensor on another device
        reason = str(error).partition("\n")[0]
        raise TypeError(f"{name}: got {type(value).__name__}, which NumPy cannot convert "
                        f"({reason}); wanted {WANTED}") from error
    if found.dtype == object:
        if not (objects and all(hasattr(x, "__neg__") for x in found.flat)):
            kinds = ", ".join(sorted({type(x).__name__ for x in found.flat}))
            raise TypeError(f"{name}: got objects ({kinds}); wanted {WANTED}")
    elif found.dtype.kind not in "iu" and found.dtype.type not in (np.float64, np.float32):
        raise TypeError(f"{name}: got {found.dtype}; wanted {WANTED}")
    return found


def cast(array, name, kind):
    """The numbers in this precision; objects unchanged.  Raises ValueError for a finite number that
    overflows in this precision."""
    if array.dtype == kind or array.dtype == object:
        return array
    if array.dtype.kind != "f" or array.itemsize <= np.dtype(kind).itemsize:
        return array.astype(kind)
    try:
        with np.errstate(over="raise", under="ignore", invalid="ignore"):
            return array.astype(kind)
    except FloatingPointError:
        largest = np.abs(array)[np.isfinite(array)].max()
        raise ValueError(f"{name}: got a number of magnitude {largest}; the largest in "
                         f"{np.dtype(kind)} is {np.finfo(kind).max}") from None


def array(value: ArrayLike, name: str, core: Shape, function: str, objects: bool) -> np.ndarray:
    """The argument as an array in its own precision, with its last axes checked."""
    found = numbers(value, f"{function}: {name}", objects)
    if found.shape[max(found.ndim - len(core), 0):] != core:
        raise ValueError(f"{function}: {name} has shape {found.shape}; "
                         f"its last axes must be {core}")
    return found


def overrides(value: object) -> bool:
    """Whether its type handles ufuncs itself, as dask's arrays do; pandas' objects do not count."""
    return not hasattr(type(value), "__pandas_priority__") and getattr(type(value), "__array_ufunc__", np.ndarray.__array_ufunc__) is not (
        np.ndarray.__array_ufunc__)


def components(array: np.ndarray, core: Shape) -> np.ndarray | tuple[np.ndarray, ...]:
    """The components, row by row; a scalar argument unchanged."""
    if not core:
        return array
    return tuple(array[(..., *index)] for index in np.ndindex(*core))


def deliver(result: np.ndarray, out: np.ndarray | None, function: str) -> np.ndarray:
    """The result, copied to `out` if that is given."""
    if out is None:
        return result[()]
    if not isinstance(out, np.ndarray):
        raise TypeError(f"{function}: out must be an array; got {type(out).__name__}")
    if out.shape != result.shape:
        raise ValueError(f"{function}: out has shape {out.shape}; the result has {result.shape}")
    np.copyto(out, result, casting="same_kind")
    return out
