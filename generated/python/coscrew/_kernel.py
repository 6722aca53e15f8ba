# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Turns functions of components into functions of arrays."""

import functools
import inspect
from collections.abc import Callable

import numpy as np

from coscrew import _arrays


def _kernel(signature: str, dtype, working=None) -> Callable[[Callable], Callable]:
    inputs, outputs = (_arrays.shapes(side) for side in signature.split("->"))

    def widened(array: np.ndarray) -> np.ndarray:
        return array if working is None or array.dtype == object else array.astype(working)

    def decorate(function: Callable) -> Callable:
        name = function.__name__
        parameters = [x for x in inspect.signature(function).parameters.values()
                      if x.kind is not inspect.Parameter.KEYWORD_ONLY]  # others are constants
        arguments = tuple(x.name for x in parameters)

        def checked(values, objects=True):
            """(broadcast leading axes, the arguments as arrays)."""
            if len(values) != len(inputs):
                raise TypeError(f"{name}: takes {len(inputs)} arguments ({', '.join(arguments)}); "
                                f"got {len(values)}")
            arrays = [_arrays.array(value, argument, core, name, objects)
                      for value, argument, core in zip(values, arguments, inputs)]
            leads = [a.shape[:a.ndim - len(core)] for a, core in zip(arrays, inputs)]
            try:
                return np.broadcast_shapes(*leads), arrays
            except ValueError:
                raise ValueError(f"{name}: leading axes {leads} do not broadcast") from None

        @functools.wraps(function)
        def on_arrays(*values, out=None):
            lead, arrays = checked(values)
            arrays = [_arrays.cast(array, f"{name}: {argument}", dtype)
                      for array, argument in zip(arrays, arguments)]
            found = function(*map(_arrays.components, map(widened, arrays), inputs))
            components = iter(found if isinstance(found, tuple) else (found,))
            kind = object if any(a.dtype == object for a in arrays) else dtype
            results = []
            for core in outputs:
                result = np.empty(lead + core, kind)
                for index in np.ndindex(*core):
                    result[(..., *index)] = next(components)
                results.append(result)
            wanted = out if isinstance(out, tuple) else (out,)
            if out is None:
                wanted = (None,) * len(outputs)
            if len(wanted) != len(outputs):
                raise TypeError(f"{name}: out needs {len(outputs)} arrays; got {len(wanted)}")
            delivered = tuple(_arrays.deliver(r, o, name) for r, o in zip(results, wanted))
            return delivered[0] if len(delivered) == 1 else delivered

        on_arrays.checked, on_arrays.signature = checked, signature
        on_arrays.__signature__ = inspect.Signature(parameters)
        return on_arrays

    return decorate


double_kernel = functools.partial(_kernel, dtype=np.float64)
single_kernel = functools.partial(_kernel, dtype=np.float32)
wide_kernel = functools.partial(_kernel, dtype=np.float32, working=np.float64)
