"""Programs as functions of arrays, with the Programs of their derivatives."""

import ctypes
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import prod
from typing import Any

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.program import Program
from coscrew_codegen.program.in_python import in_python
from coscrew_codegen.program.program import without_dead_steps
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.runtime.arrays.arithmetic import arithmetic
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary, Shape

Compile = Callable[[str, Mapping[str, Sequence[str]], Mapping[str, str]], ctypes.CDLL | None]
"""From a name, object files with their source and flags, and all texts to the library; None where
nothing compiles."""


LONGEST = 30_000
"""Instructions times inputs of functions with Jacobians."""


@dataclass(frozen=True, eq=False)
class ArrayFunction:
    """A plain Program as a function of arrays with leading axes.  `smooth` is the same function
    and is differentiated in its place; `derivatives` returns the derivatives of each result by
    each input, where a function of its own gives them."""

    name: str  # arm_inverse_dynamics: that of its function in C
    program: Program
    smooth: Program | None = None
    compile: Compile | None = None  # if it is to be in C where arrays lie in a processor's memory
    derivatives: "Callable[[], ArrayFunction | None]" = lambda: None
    _printed: dict[tuple[str, str], Callable[..., list[Any]]] = field(default_factory=dict)

    @property
    def inputs(self) -> tuple[tuple[str, Shape], ...]:
        """Names and shapes of arguments."""
        return tuple((a.name, tuple(a.quantity.shape)) for a in self.program.inputs)

    @property
    def shapes(self) -> tuple[Shape, ...]:
        """Shapes of the results, after leading axes."""
        return tuple(tuple(a.quantity.shape) for a in self.program.outputs)

    @property
    def sizes(self) -> tuple[int, ...]:
        """Number of components of each result."""
        return tuple(map(prod, self.shapes))

    @cached_property
    def tangent(self) -> "ArrayFunction":
        """(x, x') -> ∂y/∂x x'."""
        return self._derived(derivatives.tangent(self.smooth or self.program))

    @cached_property
    def adjoint(self) -> "ArrayFunction":
        """(x, w) -> w ∂y/∂x for weights w of y."""
        return self._derived(derivatives.adjoint(self.smooth or self.program))

    @cached_property
    def jacobian(self) -> "ArrayFunction | None":
        """x -> ∂y/∂x of each result by each input; None for operations, whose slopes may be
        infinite, and for functions whose Jacobian is too long."""
        if own := self.derivatives():
            return own
        program, columns = self.smooth or self.program, sum(prod(shape) for _, shape in self.inputs)
        if not self.compile or columns * len(program.instructions) > LONGEST:
            return None
        return ArrayFunction(f"{self.name}_jacobian", derivatives.jacobian(program),
                             compile=self.compile)

    def _derived(self, program: Program) -> "ArrayFunction":
        last = len(self.program.outputs)
        first = sum(a.quantity.size for a in self.program.outputs)
        kind = program.name.rpartition("_")[2]
        program = replace(program, outputs=program.outputs[last:], results=program.results[first:])
        return ArrayFunction(f"{self.name}_{kind}", without_dead_steps(program),
                             compile=self.compile)

    def printed(self, library: ArrayLibrary, precision: Precision) -> Callable[..., list[Any]]:
        """The function by calls of the library, of arrays that are checked."""
        key = library.xp.__name__, precision.name
        if key not in self._printed:
            self._printed[key] = self._made(library, precision)
        return self._printed[key]

    def _made(self, library: ArrayLibrary, precision: Precision) -> Callable[..., list[Any]]:
        compute = in_python(self.program, arithmetic(library, precision, self.program))
        shapes = [shape for _, shape in self.inputs]

        def function(*arrays: Any, lead: Shape) -> list[Any]:
            given = [library.components(x, shape) for x, shape in zip(arrays, shapes, strict=True)]
            results, outputs = compute(given), []
            for shape, size in zip(self.shapes, self.sizes, strict=True):
                outputs.append(library.assembled(results[:size], lead, shape, arrays[0]))
                results = results[size:]
            return outputs

        return function
