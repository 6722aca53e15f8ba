"""The implementations whose bounds are attacked: NumPy twins, gufuncs and compiled C."""

import functools
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np

import coscrew
from coscrew_codegen.accuracy.tiers import TIERS, tier_named
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import Precision
from tests.support.compiled.c_harness import EXACT, call, harness
from tests.support.truth.attack import TIERED, Arrays, Implementation


def twin(module: ModuleType) -> Implementation:
    """The pure-NumPy kernels in module.double and module.single."""

    def evaluate(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
        with np.errstate(all="ignore"):
            result = getattr(getattr(module, precision.name), operation.name)(*inputs)
        return result if isinstance(result, tuple) else (result,)

    return evaluate


def gufuncs(package: ModuleType) -> Implementation:
    """The compiled gufuncs of a package, of any matrices."""

    def evaluate(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
        assert package.COMPILED
        with np.errstate(all="ignore"):
            result = coscrew.unchecked(getattr(package, operation.name))(*inputs)
        return result if isinstance(result, tuple) else (result,)

    return evaluate


@functools.cache
def compiled(folder: Path, tier: str, compiler: str, flags: tuple[str, ...]) -> Implementation:
    """The C kernels of a tier other than plain."""
    made = tier_named(tier)
    operations = tuple(map(made.operation, TIERED))
    library = harness(folder, compiler, (*flags, EXACT), tier, operations)
    return lambda operation, precision, inputs: call(library, made.operation(operation), precision,
                                                     inputs)


def twins() -> dict[str, Implementation]:
    """The twins of each tier."""
    return {tier.name: twin(import_module(tier.package)) for tier in TIERS}


def same_bits(got: Arrays, want: Arrays) -> bool:
    """Equal bits; of NaN only "is NaN" counts."""
    for g, w in zip(got, want, strict=True):
        different = g.view(f"u{g.itemsize}") != np.ascontiguousarray(w).view(f"u{g.itemsize}")
        if (different & ~(np.isnan(g) & np.isnan(w))).any():
            return False
    return True
