# Made by `coscrew generate`; changes are overwritten.
"""Makes functions of components functions of arrays: checks, broadcasting, `out=`, precision."""

import functools
import inspect
from collections.abc import Callable

import numpy as np

Shape = tuple[int, ...]


def _shapes(side: str) -> list[Shape]:
    """The core shapes of one side of a signature: '(3,4),(6)' → [(3, 4), (6,)]."""
    return [tuple(int(n) for n in core.split(",") if n) for core in side[1:-1].split("),(")]


def _array(value, name: str, core: Shape, function: str, dtype) -> np.ndarray:
    """The argument as an array of this precision (or of objects), its last axes checked."""
    array = np.asarray(value)
    if array.dtype != object:
        if not np.can_cast(array.dtype, dtype, casting="same_kind"):
            raise TypeError(f"{function}: {name} has dtype {array.dtype}; wanted real numbers")
        array = array.astype(dtype, copy=False)
    if array.shape[max(array.ndim - len(core), 0):] != core:
        raise ValueError(f"{function}: {name} has shape {array.shape}; its last axes must be {core}")
    return array


def _components(array: np.ndarray, core: Shape):
    """The components, row by row; a scalar argument is passed as it is."""
    if not core:
        return array
    return tuple(array[(..., *index)] for index in np.ndindex(*core))


def _deliver(result: np.ndarray, out: np.ndarray | None, function: str) -> np.ndarray:
    """Put the result into `out` if there is one."""
    if out is None:
        return result[()]
    if not isinstance(out, np.ndarray):
        raise TypeError(f"{function}: out must be an array; got {type(out).__name__}")
    if out.shape != result.shape:
        raise ValueError(f"{function}: out has shape {out.shape}; the result has {result.shape}")
    np.copyto(out, result, casting="same_kind")
    return out


def _kernel(signature: str, dtype) -> Callable[[Callable], Callable]:
    inputs, outputs = (_shapes(side) for side in signature.split("->"))

    def decorate(function: Callable) -> Callable:
        name, arguments = function.__name__, tuple(inspect.signature(function).parameters)

        @functools.wraps(function)
        def on_arrays(*values, out=None):
            if len(values) != len(inputs):
                raise TypeError(f"{name}: takes {len(inputs)} arguments ({', '.join(arguments)}); "
                                f"got {len(values)}")
            arrays = [_array(value, argument, core, name, dtype)
                      for value, argument, core in zip(values, arguments, inputs)]
            leads = [a.shape[:a.ndim - len(core)] for a, core in zip(arrays, inputs)]
            try:
                lead = np.broadcast_shapes(*leads)
            except ValueError:
                raise ValueError(f"{name}: leading axes {leads} do not broadcast") from None
            found = function(*map(_components, arrays, inputs))
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
            delivered = tuple(_deliver(r, o, name) for r, o in zip(results, wanted))
            return delivered[0] if len(delivered) == 1 else delivered

        return on_arrays

    return decorate


double_kernel = functools.partial(_kernel, dtype=np.float64)
single_kernel = functools.partial(_kernel, dtype=np.float32)


def dispatch(*kernels: Callable) -> Callable:
    """The first kernel, except that arguments of float32 alone go to the second."""
    wide, narrow = kernels[0], kernels[-1]

    @functools.wraps(wide)
    def on_any(*values, out=None):
        dtypes = {np.asarray(v).dtype for v in values if type(v) not in (bool, int, float)}
        return (narrow if dtypes == {np.dtype(np.float32)} else wide)(*values, out=out)

    return on_any
