"""The implementations whose bounds are attacked: NumPy twins, and compiled C of the fused tier."""

from pathlib import Path
from types import ModuleType

import numpy as np

import coscrew
import coscrew.accurate
import coscrew.certified
from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.tiers import tier_named
from tests.support.compiled.c_harness import COMPILERS, EXACT, call, harness
from tests.support.truth.attack import TIERED, Arrays, Implementation


def twin(module: ModuleType) -> Implementation:
    """The pure-NumPy kernels in module.double and module.single."""

    def evaluate(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
        with np.errstate(all="ignore"):
            found = getattr(getattr(module, precision.name), operation.name)(*inputs)
        return found if isinstance(found, tuple) else (found,)

    return evaluate


def gufuncs(package: ModuleType) -> Implementation:
    """The compiled gufuncs of a package."""

    def evaluate(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
        assert package.COMPILED
        with np.errstate(all="ignore"):
            found = getattr(package, operation.name)(*inputs)
        return found if isinstance(found, tuple) else (found,)

    return evaluate


def compiled(folder: Path, tier: str, compiler: str, flags: tuple[str, ...]) -> Implementation:
    """The C kernels of a tier other than plain."""
    made = tier_named(tier)
    operations = tuple(map(made.operation, TIERED))
    library = harness(folder, compiler, (*flags, EXACT), tier, operations)
    return lambda operation, precision, inputs: call(library, made.operation(operation), precision,
                                                     inputs)


def implementations(folder: Path) -> dict[str, Implementation]:
    """One implementation per tier."""
    return {"plain": twin(coscrew), "accurate": twin(coscrew.accurate),
            "certified": twin(coscrew.certified),
            "fused": compiled(folder, "fused", COMPILERS[0], ("-O3", "-march=native"))}
