"""Refuses arguments that a function of arrays cannot take, once, at the users' call."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf
from typing import Any

from coscrew_codegen.program.values.formats import Precision, named
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary, Shape
from coscrew_codegen.runtime.callables import bound


@dataclass(frozen=True)
class ArraySignature:
    """A function's name, the names of its arguments with their shapes after leading axes, and its
    precisions."""

    name: str
    inputs: tuple[tuple[str, Shape], ...]
    precisions: tuple[str, ...]

    @property
    def types(self) -> str:
        """float64 or float32."""
        return " or ".join(p.numpy_type for p in named(self.precisions))

    def bound(self, given: Sequence[Any], by_name: Mapping[str, Any]) -> list[Any]:
        """The arguments in order.  Raises TypeError for missing and unknown ones."""
        return list(bound(self.name, self.inputs, given, by_name).values())


def checked(signature: ArraySignature, library: ArrayLibrary, given: Sequence[Any]
            ) -> tuple[Shape, list[Any], Precision]:
    """The leading axes, the arguments as arrays of one type, and that type.  Raises TypeError and
    ValueError."""
    kinds = {name: _kind(signature, library, name, x)
             for (name, _), x in zip(signature.inputs, given, strict=True)}
    precision = _one(signature, library, kinds)
    arrays, leads = [], []
    for (name, shape), x in zip(signature.inputs, given, strict=True):
        _refuse_large(signature, name, x, precision)
        x = library.array(x, precision, next((y for y in given if hasattr(y, "dtype")), None))
        lead = tuple(x.shape[:max(x.ndim - len(shape), 0)])
        if tuple(x.shape[len(lead):]) != shape:
            wanted = "".join(f", {n}" for n in shape)
            raise ValueError(f"{signature.name}: {name} has shape {tuple(x.shape)}; wanted "
                             f"(...{wanted})")
        arrays.append(x)
        leads.append(lead)
    return _broadcast(signature, leads), arrays, precision


def _kind(signature: ArraySignature, library: ArrayLibrary, name: str, x: Any) -> Any:
    """An array's type; None for a Python number."""
    if library.numeral(x):
        return None
    if not library.takes(x):
        raise TypeError(f"{signature.name}: {name} is a {type(x).__module__}.{type(x).__name__}; "
                        f"wanted an array of {library.name}")
    precision = library.precision(x.dtype)
    if precision is None or precision.name not in signature.precisions:
        raise TypeError(f"{signature.name}: {name} is {library.called(x.dtype)}; wanted "
                        f"{signature.types}")
    if not library.holds(precision):
        raise TypeError(f"{signature.name}: {name} is float64, which JAX would round to float32: "
                        'set jax.config.update("jax_enable_x64", True), or give float32')
    return precision


def _refuse_large(signature: ArraySignature, name: str, x: Any, precision: Precision) -> None:
    """Raises ValueError for a finite Python number that overflows."""
    if isinstance(x, (int, float)) and precision.limit("max") < abs(x) != inf:
        number = f"{x:.9g}" if isinstance(x, float) else "a whole number"
        raise ValueError(f"{signature.name}: {name} is {number} that overflows in "
                         f"{precision.numpy_type}")


def _one(signature: ArraySignature, library: ArrayLibrary, kinds: Mapping[str, Precision | None]
         ) -> Precision:
    precisions = {precision for precision in kinds.values() if precision}
    if len(precisions) > 1:
        kinds_given = ", ".join(f"{name} {x.numpy_type}" for name, x in kinds.items() if x)
        raise TypeError(f"{signature.name}: got {kinds_given}; wanted one type for all")
    usable = [p for p in named(signature.precisions) if library.holds(p)]
    if not (precisions or usable):
        raise TypeError(f"{signature.name}: got numbers without a type; wanted {signature.types}")
    return precisions.pop() if precisions else usable[0]


def _broadcast(signature: ArraySignature, leads: Sequence[Shape]) -> Shape:
    axes = max(map(len, leads), default=0)
    sizes = [{lead[k - axes] for lead in leads if axes - k <= len(lead)} - {1}
             for k in range(axes)]
    if any(len(lengths) > 1 for lengths in sizes):
        shapes = ", ".join(f"{name} {lead}" for (name, _), lead in zip(
            signature.inputs, leads, strict=True))
        raise ValueError(f"{signature.name}: leading axes do not broadcast: {shapes}")
    return tuple(lengths.pop() if lengths else 1 for lengths in sizes)
