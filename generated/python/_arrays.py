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


TOLERANCE = 0.001
"""A matrix is a rotation if |R^T R - I|_ij and |det R - 1| are at most this, a quaternion of length 1
if | |q| - 1 | is."""


def _rotation_defect(R: np.ndarray) -> np.ndarray:
    products = np.einsum("...ki,...kj->...ij", R, R) - np.eye(3)
    a, b, c = (R[..., i, :] for i in range(3))
    det = np.einsum("...i,...i->...", a, np.cross(b, c))
    sizes = np.fmax.reduce(np.abs(products), axis=(-2, -1))
    return np.fmax(sizes, np.abs(det - 1))  # NaN only if all are


def _unit_defect(q: np.ndarray) -> np.ndarray:
    largest = np.abs(q).max(axis=-1, keepdims=True)
    scale = np.where(largest > 0, largest, 1)
    return np.abs(np.linalg.norm(q / scale, axis=-1) * scale[..., 0] - 1)


def _refusal(letter: str, x: np.ndarray, name: str) -> tuple[np.ndarray, str]:
    """Where elements are refused, and why: R a matrix that is no rotation, U a quaternion whose
    length is not 1, N and M a quaternion and a matrix that are zero.  NaN is accepted."""
    if letter == "R":
        defect = _rotation_defect(x[..., :3])
        return defect > TOLERANCE, (
            f"{'R of ' if x.shape[-1] == 4 else ''}{name} is no rotation: |R^T R - I| or "
            f"|det R - 1| is {np.fmax.reduce(np.ravel(defect)):.3g}; wanted at most {TOLERANCE:g}; "
            "mat3x3_nearest_rotation makes a rotation of it")
    if letter == "U":
        defect = _unit_defect(x)
        return defect > TOLERANCE, (
            f"{name} is no unit quaternion: | |q| - 1 | is {np.fmax.reduce(np.ravel(defect)):.3g}; wanted at most "
            f"{TOLERANCE:g}; quaternion_nearest_unit divides it by its length")
    if letter == "N":
        return ~x.any(axis=-1), f"{name} is zero and has no direction; wanted any other quaternion"
    return ~x.any(axis=(-2, -1)), (f"{name} is zero, to which all rotations are equally near; "
                                   "wanted any other matrix")


def require(letter: str, array: np.ndarray, argument: str, function: str) -> None:
    """Raise ValueError if an element is not what the letter requires."""
    if letter == "." or not array.size:
        return
    with np.errstate(all="ignore"):
        wrong, why = _refusal(letter, array.astype(np.float64), argument)
    if wrong.any():
        place = f"element {tuple(map(int, np.argwhere(wrong)[0]))} of " if wrong.ndim else ""
        raise ValueError(f"{function}: {place}{why}")


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
