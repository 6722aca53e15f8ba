# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Refuses arguments that are not what a function requires, and chooses the precision."""

import functools
import inspect
from collections.abc import Callable

import numpy as np

from coscrew import _arrays
from coscrew.double.mat3x3 import mat3x3_rotation_defect as mat3x3_rotation_defect_double
from coscrew.single.mat3x3 import mat3x3_rotation_defect as mat3x3_rotation_defect_single
from coscrew.double.quaternion import quaternion_unit_defect as quaternion_unit_defect_double
from coscrew.single.quaternion import quaternion_unit_defect as quaternion_unit_defect_single

TOLERANCE = 0.001
"""A matrix is a rotation if |R^T R - I|_ij and |det R - 1| are at most this, a quaternion of length 1
if | |q| - 1 | is."""
_DEFECTS = {
    "R": [mat3x3_rotation_defect_double, mat3x3_rotation_defect_single],
    "U": [quaternion_unit_defect_double, quaternion_unit_defect_single],
}
"""The kernels that tell how far an argument is from what its letter requires, by precision."""
_AXES = {"R": (-2, -1), "M": (-2, -1), "U": -1, "N": -1}


def _defect(letter: str, x: np.ndarray) -> np.ndarray:
    """The size of the defect, by the kernel of the array's precision."""
    kernels = _DEFECTS[letter]
    kernel = kernels[-1] if x.dtype.type is np.float32 else kernels[0]
    return np.absolute(kernel(x[..., :3] if letter == "R" else x))


def _refused(letter: str, x: np.ndarray) -> np.ndarray:
    """Where elements are refused: R a matrix that is no rotation, U a quaternion whose length is not
    1, N and M a quaternion and a matrix that are zero.  NaN is accepted; a defect may also be NaN
    because it overflows."""
    if letter not in _DEFECTS:
        return ~x.any(axis=_AXES[letter])
    off = ~(_defect(letter, x) <= TOLERANCE)
    return off & ~np.isnan(x).any(axis=_AXES[letter]) if off.any() else off


def _reason(letter: str, x: np.ndarray, name: str) -> str:
    """Why these elements are refused."""
    if letter == "N":
        return f"{name} is zero and has no direction; wanted any other quaternion"
    if letter == "M":
        return f"{name} is zero, to which all rotations are equally near; wanted any other matrix"
    size = f"{np.nan_to_num(_defect(letter, x), nan=np.inf, posinf=np.inf).max():.3g}"
    if letter == "R":
        return (f"{'R of ' if x.shape[-1] == 4 else ''}{name} is no rotation: |R^T R - I| or "
                f"|det R - 1| is {size}; wanted at most {TOLERANCE:g}; "
                "mat3x3_nearest_rotation makes a rotation of it")
    return (f"{name} is no unit quaternion: | |q| - 1 | is {size}; wanted at most {TOLERANCE:g}; "
            "quaternion_nearest_unit divides it by its length")


def require(letter: str, array: np.ndarray, argument: str, function: str) -> None:
    """Raise ValueError if an element is not what the letter requires."""
    if letter == "." or not array.size:
        return
    with np.errstate(all="ignore"):
        refused = _refused(letter, array)
        if not refused.any():
            return
        why = _reason(letter, array[refused], argument)
    place = f"element {tuple(map(int, np.argwhere(refused)[0]))} of " if refused.ndim else ""
    raise ValueError(f"{function}: {place}{why}")



def dispatch(module: str, *kernels: Callable, required: str = "") -> Callable:
    """A function of `module` that calls the second kernel if all arrays are float32, else the
    first; `dtype=` overrides that.  Letters of `required` say what its arguments must be."""
    wide, narrow = kernels[0], kernels[-1]
    arguments = tuple(inspect.signature(wide).parameters)

    def check(*values):
        """Raise the errors that `on_any` raises for wrong arguments."""
        if not any(map(_arrays.overrides, values)):
            admitted(values)

    def admitted(values):
        """The arguments as arrays.  Raises ValueError for those that are refused."""
        _, arrays = wide.checked(values, objects=False)
        for letter, argument, array in zip(required, arguments, arrays):
            require(letter, array, argument, wide.__name__)
        return arrays

    @functools.wraps(wide)
    def on_any(*values, out=None, dtype=None):
        arrays = admitted(values)
        kinds = {array.dtype.type for array, value in zip(arrays, values)
                 if type(value) not in (int, float)}
        if dtype is not None:
            kinds = {np.dtype(dtype).type}
            if not kinds < {np.float64, np.float32}:
                raise TypeError(f"{wide.__name__}: dtype must be float64 or float32; "
                                f"got {np.dtype(dtype)}")
        return (narrow if kinds == {np.float32} else wide)(*arrays, out=out)

    on_any.check = check
    on_any.unchecked = dispatch(module, *kernels) if required else on_any
    on_any.__module__ = module  # where pickle finds it
    return on_any
