"""Backends of array libraries: each computes functions in its library's own way; found by name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.runtime.arrays.array_function import ArrayFunction
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary, Shape

Backend: TypeAlias = Callable[[ArrayFunction, Shape, Sequence[Any], Precision], list[Any]]
"""From a function, the leading axes of its results, and arrays of a precision, to the results."""


def backend_of(library: ArrayLibrary) -> Backend:
    """The backend of a library."""
    if library.name == "jax":
        from coscrew_codegen.runtime.arrays import in_jax

        return in_jax.call
    if library.name == "torch":
        from coscrew_codegen.runtime.arrays import in_torch

        return in_torch.call
    return partial(_printed, library)


def _printed(library: ArrayLibrary, function: ArrayFunction, lead: Shape, arrays: Sequence[Any],
             precision: Precision) -> list[Any]:
    """By calls of the library."""
    with np.errstate(all="ignore"):  # 0/0 where nothing takes it
        return function.printed(library, precision)(*arrays, lead=lead)
