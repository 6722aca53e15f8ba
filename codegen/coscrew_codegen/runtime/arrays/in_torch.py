"""Functions of arrays in PyTorch, with derivatives for autograd.

Forward and backward are the function's and its adjoint's Programs, in C for tensors in a
processor's memory, else by calls of PyTorch.  Both are functions with derivatives again, so that
derivatives of any order follow.
"""

from collections.abc import Sequence
from math import prod
from typing import Any

import torch

from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.runtime.arrays.array_function import ArrayFunction
from coscrew_codegen.runtime.arrays.compiled import loop
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary, Shape

LIBRARY = ArrayLibrary(torch)


def call(function: ArrayFunction, lead: Shape, arrays: Sequence[Any], precision: Precision
         ) -> list[Any]:
    """The results for tensors that are checked."""
    return list(_Value.apply(function, lead, precision, *arrays))


class _Value(torch.autograd.Function):
    """The results of a function."""

    @staticmethod
    def forward(function: ArrayFunction, lead: Shape, precision: Precision, *arrays: Any) -> Any:
        """Computes the results for tensors; in C where these lie in a processor's memory."""
        in_memory = function.compile and all(x.device.type == "cpu" for x in arrays)
        if in_memory and (compiled := loop(function, precision)):
            return tuple(_in_c(compiled, function, lead, arrays))
        return tuple(x.contiguous() for x in function.printed(LIBRARY, precision)(
            *arrays, lead=lead))

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:
        ctx.function, ctx.lead, ctx.precision, *arrays = inputs
        ctx.save_for_backward(*arrays)
        ctx.save_for_forward(*arrays)

    @staticmethod
    def backward(ctx: Any, *weights: Any) -> Any:
        """Computes the weights along the arguments from those along the results: the adjoint."""
        arrays = ctx.saved_tensors
        cotangents = _Value.apply(ctx.function.adjoint, ctx.lead, ctx.precision, *arrays, *weights)
        return None, None, None, *(_as(x, array) for x, array in zip(
            cotangents, arrays, strict=True))

    @staticmethod
    def jvp(ctx: Any, *directions: Any) -> Any:
        """The derivative along directions: the tangent."""
        arrays = ctx.saved_tensors
        along = [torch.zeros_like(x) if d is None else d
                 for x, d in zip(arrays, directions[3:], strict=True)]
        return _Value.apply(ctx.function.tangent, ctx.lead, ctx.precision, *arrays, *along)

    @staticmethod
    def vmap(info: Any, axes: tuple[int | None, ...], function: ArrayFunction, lead: Shape,
             precision: Precision, *arrays: Any) -> Any:
        """All members at once: their axis becomes the first."""
        several = (info.batch_size, *lead)
        given = []
        for x, axis, (_, shape) in zip(arrays, axes[3:], function.inputs, strict=True):
            if axis is not None:
                x = x.movedim(axis, 0)
                own = x.shape[1:x.ndim - len(shape)]
                x = x.reshape(x.shape[0], *[1] * (len(lead) - len(own)), *x.shape[1:])
            given.append(x)
        outputs = _Value.apply(function, several, precision, *given)
        return outputs, (0,) * len(outputs)


def _as(x: Any, array: Any) -> Any:
    """The sum over the axes along which an argument was broadcast."""
    return x.sum_to_size(array.shape)


def _in_c(compiled: Any, function: ArrayFunction, lead: Shape, arrays: Sequence[Any]) -> list[Any]:
    words: list[int] = [prod(lead)]
    kept = []
    for x, (_, shape) in zip(arrays, function.inputs, strict=True):
        shared = prod(x.shape[:x.ndim - len(shape)]) == 1
        x = x if shared else x.expand((*lead, *shape))
        kept.append(x.detach().contiguous())
        words += [kept[-1].data_ptr(), 0 if shared else prod(shape)]
    results = [torch.empty((*lead, *shape), dtype=arrays[0].dtype) for shape in function.shapes]
    for result, shape in zip(results, function.shapes, strict=True):
        words += [result.data_ptr(), prod(shape)]
    compiled(*words)
    return results
