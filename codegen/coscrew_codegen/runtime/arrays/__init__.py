"""The functions of scenes and of the library on arrays of NumPy, JAX, PyTorch and others.

They come from the Programs from which C and NumPy are generated: in C where arrays lie in a
processor's memory and compiling is worthwhile, as calls of the array library elsewhere.
Derivatives are Programs, too (`algebra/recording/derivatives.py`): costs and accuracy are those of
an adjoint."""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING

from coscrew_codegen.runtime.extras import lacking

if TYPE_CHECKING:
    from coscrew_codegen.runtime.arrays.namespace import Arrays


def of_library(xp: ModuleType, on_numpy: ModuleType) -> Arrays:
    """The library's operations on arrays of a library; `on_numpy` has them on NumPy's.  Raises
    TypeError for anything but a namespace of arrays, ImportError without the generator's packages.
    """
    if message := lacking("coscrew.arrays", "codegen"):
        raise ImportError(message)
    from coscrew_codegen.runtime.arrays import namespace

    return namespace.of_library(xp, on_numpy)
