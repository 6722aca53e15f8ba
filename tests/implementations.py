"""What the bounds are attacked in: NumPy twins of plain and accurate, compiled C of fused."""

from pathlib import Path
from types import ModuleType

import numpy as np

import coscrew
import coscrew.accurate
from coscrew_codegen.operations import Operation
from coscrew_codegen.targets.precision import Precision
from tests.attack import TIERED, Arrays, Implementation
from tests.c_harness import COMPILERS, EXACT, call, harness


def twin(module: ModuleType) -> Implementation:
    """The pure-NumPy kernels in module.double and module.single."""

    def evaluate(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
        with np.errstate(all="ignore"):
            found = getattr(getattr(module, precision.name), operation.name)(*inputs)
        return found if isinstance(found, tuple) else (found,)

    return evaluate


def compiled(folder: Path, tier: str, compiler: str, flags: tuple[str, ...]) -> Implementation:
    """The C kernels of a tier behind plain."""
    library = harness(folder, compiler, (*flags, EXACT), tier, TIERED)
    return lambda operation, precision, inputs: call(library, operation, precision, inputs)


def implementations(folder: Path) -> dict[str, Implementation]:
    """One implementation per tier."""
    return {"plain": twin(coscrew), "accurate": twin(coscrew.accurate),
            "fused": compiled(folder, "fused", COMPILERS[0], ("-O3", "-march=native"))}
