"""A scene's functions for any arguments, which are checked, cast and broadcast; rows of states are
given to C where they stand if it can read them there."""

import ctypes
import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from types import ModuleType

import numpy as np
from numpy.typing import ArrayLike

from coscrew_codegen.program.scene_functions import Signature


@dataclass(frozen=True)
class Rows:
    """Rows of numbers in memory."""

    array: np.ndarray
    step: int  # numbers from one row to the next


@dataclass(frozen=True)
class CompiledFunction:
    """A function of a library; `signs` are those of the numbers of p."""

    described: Signature
    kind: np.dtype
    in_c: Callable[..., object]  # declines, by NotImplemented, what it cannot take
    loop: Callable[..., None]  # of n states, wherever they stand
    checks: ModuleType
    signs: tuple[tuple[int, str, bool], ...]

    def __call__(self, arguments: Mapping[str, ArrayLike], out: object, threads: object,
                 prepare: Callable[[int], None]) -> object:
        """The results.  `prepare` is told the number of states if there are leading axes, and room
        for their results."""
        described, count = self.described, positive(threads)
        lead, arrays = self.checks.arrays(self.kind, **{
            x: (arguments[x], shape, *([self.signs] if x == "p" else []))
            for x, shape in described.inputs})
        shapes = [(*lead, *shape) for _, shape in described.outputs]
        if lead and out is None:
            _refuse_vast(shapes, self.kind)
            prepare(prod(lead))
        if not lead or out is None:
            outputs = self.in_c(*arrays, threads=count)
            if outputs is not NotImplemented:
                results = outputs if isinstance(outputs, tuple) else (outputs,)
                return self.checks.delivered(out, *results)
        given = dict(zip(arguments, arrays, strict=True))
        places = [x if x is not None and self._is_place(x, len(lead), arrays)
                   else np.empty(shape, self.kind)
                   for x, shape in zip(self.checks.places(out, shapes, self.kind), shapes,
                                       strict=True)]
        if lead and out is not None:
            prepare(prod(lead))
        if described.moved:
            for (x, _), result in zip(described.outputs, places, strict=True):
                result[...] = given[x]
        self._run([_rows(given[x], lead, len(shape)) for x, shape in described.inputs],
                  [Rows(x, _step(x, len(lead)) or 0) for x in places], prod(lead), count)
        return self.checks.delivered(out, *(x[()] for x in places))

    def _is_place(self, x: np.ndarray, lead: int, arrays: Sequence[np.ndarray]) -> bool:
        """Returns whether C may write to `x` while it reads the arrays."""
        step = _step(x, lead) if x.dtype == self.kind else None
        return (step is not None and (x.flags.c_contiguous or step >= prod(x.shape[lead:]))
                and not any(np.may_share_memory(x, array) for array in arrays))

    def _run(self, inputs: Sequence[Rows], outputs: Sequence[Rows], n: int, threads: int) -> None:
        taken = [x for rows in (inputs, outputs) for x in (
            (ctypes.c_void_p * len(rows))(*(x.array.ctypes.data for x in rows)),
            (ctypes.c_ssize_t * len(rows))(*(x.step for x in rows)))]
        self.loop(n, *taken, min(threads, n))


def _refuse_vast(shapes: Sequence[tuple[int, ...]], kind: np.dtype) -> None:
    """Raises MemoryError if there is no room for arrays of these shapes."""
    _ = [np.empty(shape, kind) for shape in shapes]


def positive(threads: object) -> int:
    """The number of threads.  Raises TypeError, ValueError."""
    message = f"threads: got {threads!r}; wanted a positive integer"
    try:
        count = operator.index(threads)  # type: ignore[arg-type]
    except TypeError:
        raise TypeError(message) from None
    if isinstance(threads, bool):
        raise TypeError(message)
    if count < 1:
        raise ValueError(message)
    return count


def _rows(array: np.ndarray, lead: tuple[int, ...], axes: int) -> Rows:
    """Rows of these leading axes: where they stand, or copied if C cannot read them there."""
    if array.ndim == axes:
        return Rows(np.require(array, None, ("C", "A")), 0)
    step = _step(array, len(lead)) if array.ndim == axes + len(lead) else None
    if step is not None and array.shape[:len(lead)] == lead:
        return Rows(array, step)
    array = np.broadcast_to(array, (*lead, *array.shape[array.ndim - axes:]))
    step = _step(array, len(lead))
    return Rows(array, step) if step is not None else Rows(
        np.require(array, None, ("C", "A")), prod(array.shape[len(lead):]))


def _step(array: np.ndarray, lead: int) -> int | None:
    """Returns how many numbers apart the rows of an array are; None if C cannot read them."""
    size, each = prod(array.shape[lead:]), array.itemsize
    if array.flags.c_contiguous and array.flags.aligned:
        return size
    inner = np.empty((0, *array.shape[lead:]), array.dtype).strides[1:]
    regular = lead == 1 and array.strides[1:] == inner and array.flags.aligned
    return array.strides[0] // each if regular and not array.strides[0] % each else None
