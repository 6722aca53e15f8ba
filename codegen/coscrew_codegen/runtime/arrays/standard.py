"""Differences between array libraries: names, and how arrays are made, read and assembled."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import prod
from types import ModuleType
from typing import Any

import numpy as np

from coscrew_codegen.program.values.formats import PRECISIONS, Precision

Shape = tuple[int, ...]


@dataclass(frozen=True, eq=False)
class ArrayLibrary:
    """A namespace of arrays as of the array API standard; those of torch and cupy are near it."""

    xp: ModuleType

    @property
    def name(self) -> str:
        """numpy, jax, torch, …: the package."""
        return self.xp.__name__.partition(".")[0]

    @property
    def traced(self) -> bool:
        """True if arrays may have no values yet: calls are traced into a program."""
        return self.name == "jax"

    @cached_property
    def dtypes(self) -> dict[Any, Precision]:
        """Its floating types, and our precisions for them."""
        return {self._key(getattr(self.xp, p.numpy_type)): p for p in PRECISIONS}

    def _key(self, dtype: Any) -> str:
        return str(dtype).rpartition(".")[2].removesuffix("'>")

    def precision(self, dtype: Any) -> Precision | None:
        """The precision of a type; None for others."""
        return self.dtypes.get(self._key(dtype))

    def called(self, dtype: Any) -> str:
        """A type's name: float64."""
        return self._key(dtype)

    def takes(self, x: Any) -> bool:
        """Returns whether x is an array of this library, without a mask; JAX takes those of NumPy,
        too."""
        if self.traced and isinstance(x, self.xp.ndarray):  # also one whose values are not known
            return True
        package = "numpy" if self.traced else self.name
        return (hasattr(x, "dtype") and type(x).__module__.partition(".")[0] == package
                and not isinstance(x, np.ma.MaskedArray))

    def numeral(self, x: Any) -> bool:
        """Returns whether x is a Python number, or stands for one in a function that JAX traces."""
        if self.traced and isinstance(x, self.xp.ndarray):
            return getattr(x, "weak_type", False) and str(x.dtype).startswith(("float", "int"))
        return isinstance(x, (int, float)) and not (isinstance(x, bool) or hasattr(x, "dtype"))

    def holds(self, precision: Precision) -> bool:
        """Returns whether arrays keep this precision: without x64, JAX rounds float64."""
        if not self.traced:
            return True
        import jax

        return precision.bytes < 8 or bool(jax.config.read("jax_enable_x64"))

    def array(self, x: Any, precision: Precision, like: Any) -> Any:
        """An argument as an array, a number as one where the array `like` lies."""
        if self.name == "torch" and hasattr(x, "dtype"):
            return x
        if self.name != "torch":
            return self.xp.asarray(x, dtype=getattr(self.xp, precision.numpy_type))
        where = {} if like is None else {"device": like.device}
        return self.xp.asarray(x, dtype=getattr(self.xp, precision.numpy_type), **where)

    def number(self, x: Any, precision: Precision) -> Any:
        """A Python number as an array of this precision, an array unchanged."""
        if not isinstance(x, (float, int)) or hasattr(x, "dtype"):
            return x
        return self.xp.asarray(x, dtype=getattr(self.xp, precision.numpy_type))

    def quotient(self, a: Any, b: Any) -> Any:
        """Returns a / b, rounded once: on a GPU, PyTorch would multiply by the rounded 1 / b."""
        if self.name == "torch" and isinstance(b, float) and hasattr(a, "device"):
            b = self.xp.full((), b, dtype=a.dtype, device=a.device)
        return a / b

    def taken(self, values: Sequence[float], index: Any, like: Any) -> Any:
        """values[index] for an array of whole numbers, with the type of `like`."""
        xp, where = self.xp, {"device": like.device} if self.name == "torch" else {}
        table = xp.asarray(values, dtype=like.dtype, **where)
        whole = index.to(xp.int64) if self.name == "torch" else xp.astype(index, xp.int32)
        return xp.reshape(xp.take(table, xp.reshape(whole, (-1,))), whole.shape)

    def kept(self, function: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
        """Returns a sum or difference that nothing folds into another: XLA makes x of (x + c) - c.

        Its bits are read as an integer, whose last bit is set where the number is NaN.  XLA removes
        barriers and conversions that change no number on one device or another; this it keeps."""
        if not self.traced:
            return function
        from jax.lax import bitcast_convert_type

        def apply(a: Any, b: Any) -> Any:
            result = function(a, b)
            if not (isinstance(a, float) or isinstance(b, float)):
                return result
            integer = self.xp.dtype(f"int{8 * result.dtype.itemsize}")
            bits = bitcast_convert_type(result, integer) | (result != result).astype(integer)
            return bitcast_convert_type(bits, result.dtype)

        return apply

    def components(self, x: Any, shape: Shape) -> list[Any]:
        """The components of arrays (…, shape), row by row."""
        if not shape:
            return [x]
        rows = self.xp.reshape(x, (*x.shape[:x.ndim - len(shape)], prod(shape)))
        return [rows[..., k] for k in range(prod(shape))]

    def assembled(self, parts: Sequence[Any], lead: Shape, shape: Shape, like: Any) -> Any:
        """The array (lead, shape) of these components."""
        xp, precision = self.xp, self.precision(like.dtype)
        assert precision
        where = {"device": like.device} if self.name == "torch" else {}
        parts = [xp.asarray(x, dtype=like.dtype, **where) if isinstance(x, float) else x
                 for x in parts]
        spread = [xp.broadcast_to(x, lead) for x in parts]
        if not shape:
            return spread[0]
        if not spread:
            return xp.zeros((*lead, *shape), dtype=like.dtype, **where)
        row = self._selected(parts, lead) if self.traced and len(parts) <= WIDE else \
            xp.stack(spread, axis=-1)
        return xp.reshape(row, (*lead, *shape))

    def _selected(self, parts: Sequence[Any], lead: Shape) -> Any:
        """Assembles the parts without `stack`: XLA would compute the operands again for each part.
        """
        xp, place = self.xp, self.xp.arange(len(parts))

        def tree(first: int, last: int) -> Any:
            if last - first == 1:
                return parts[first][..., None]
            half = (first + last) // 2
            return xp.where(place < half, tree(first, half), tree(half, last))

        return xp.broadcast_to(tree(0, len(parts)), (*lead, len(parts)))


def library_of(xp: ModuleType) -> ArrayLibrary:
    """The library of a namespace.  Raises TypeError if it is none of arrays."""
    if not isinstance(xp, ModuleType) or not all(
            hasattr(xp, name) for name in ("asarray", "where", "float64", "broadcast_to")):
        library = xp.__name__ if isinstance(xp, ModuleType) else repr(xp)
        raise TypeError("arrays: wanted a namespace of arrays, as numpy, jax.numpy, torch, cupy or "
                        f"array_api_strict; got {library}")
    return ArrayLibrary(xp)


WIDE = 64
"""Results with more components are stacked: there, a tree of choices takes longer."""
