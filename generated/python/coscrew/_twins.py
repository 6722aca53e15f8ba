# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Turns kernels of double precision into those of single."""

import inspect
import types
from collections.abc import Callable

import numpy as np

from coscrew._kernel import single_kernel


def single_twins(module: str, quiet=False, **names) -> Callable:
    """Returns what makes kernels of single precision, in this module, of those of a module of
    double: with these names instead of its own, and with other constants."""
    scope: dict[str, object] = {}

    def twin(kernel: Callable, doc: str = "", **constants) -> Callable:
        original = inspect.unwrap(kernel)
        if not scope:
            scope.update(original.__globals__, __name__=module, **names)
        function = types.FunctionType(original.__code__, scope, original.__name__)
        function.__kwdefaults__, function.__doc__ = constants, doc or original.__doc__
        return single_kernel(kernel.signature)(
            np.errstate(all="ignore")(function) if quiet else function)

    return twin
