"""Calls operations in each tier as users do: gufuncs, or C for the tiers that Python does not have.
"""

from importlib import import_module
from pathlib import Path

from coscrew_codegen.operations import Operation
from coscrew_codegen.tiers import TIERS, tier_named
from tests.support.compiled.c_harness import COMPILERS, EXACT, call, harness
from tests.support.compiled.implementations import gufuncs
from tests.support.truth.attack import Implementation, plain_program

# gcc's vectoriser contracts products of alternating signs in spite of -ffp-contract=off.
FLAGS = ("-O2", "-march=native", "-fno-tree-vectorize", EXACT)
TIER_NAMES = tuple(tier.name for tier in TIERS)


def tiers_of(operation: Operation) -> tuple[str, ...]:
    """The tiers the operation has."""
    return tuple(tier.name for tier in TIERS if tier.has(plain_program(operation)))


def of_tier(folder: Path, tier: str, operations: tuple[Operation, ...]) -> Implementation:
    """The tier's kernels of these operations; C is compiled in the folder."""
    made = tier_named(tier)
    if made.in_python:
        return gufuncs(import_module(made.package))
    having = tuple(made.operation(op) for op in operations if tier in tiers_of(op))
    library = harness(folder, COMPILERS[0], FLAGS, tier, having)
    return lambda operation, precision, inputs: call(library, made.operation(operation), precision,
                                                     inputs)
