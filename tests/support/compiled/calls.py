"""Calls operations in each tier as users do: gufuncs for plain, C for the other tiers."""

from pathlib import Path

import numpy as np

import coscrew
from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.tiers import TIERS, tier_named
from tests.support.compiled.c_harness import COMPILERS, EXACT, call, harness
from tests.support.truth.attack import Arrays, Implementation, plain_program

# gcc's vectoriser contracts products of alternating signs in spite of -ffp-contract=off.
FLAGS = ("-O2", "-march=native", "-fno-tree-vectorize", EXACT)
TIER_NAMES = tuple(tier.name for tier in TIERS)


def tiers_of(operation: Operation) -> tuple[str, ...]:
    """The tiers the operation has."""
    return tuple(tier.name for tier in TIERS if tier.has(plain_program(operation)))


def of_tier(folder: Path, tier: str, operations: tuple[Operation, ...]) -> Implementation:
    """The tier's kernels of these operations; C is compiled in the folder."""
    if tier == "plain":
        return _gufunc
    made = tier_named(tier)
    having = tuple(made.operation(op) for op in operations if tier in tiers_of(op))
    library = harness(folder, COMPILERS[0], FLAGS, tier, having)
    return lambda operation, precision, inputs: call(library, made.operation(operation), precision,
                                                     inputs)


def _gufunc(operation: Operation, precision: Precision, inputs: Arrays) -> Arrays:
    with np.errstate(all="ignore"):
        found = getattr(coscrew, operation.name)(*inputs)
    return found if isinstance(found, tuple) else (found,)
