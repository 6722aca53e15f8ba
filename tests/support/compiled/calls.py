"""Calls operations in each tier as users do: gufuncs."""

from importlib import import_module

from coscrew_codegen.accuracy.tiers import TIERS, tier_named
from coscrew_codegen.algebra.operations import Operation
from tests.support.compiled.implementations import gufuncs
from tests.support.truth.attack import Implementation, plain_program

TIER_NAMES = tuple(tier.name for tier in TIERS)


def tiers_of(operation: Operation) -> tuple[str, ...]:
    """The tiers the operation has."""
    return tuple(tier.name for tier in TIERS if tier.has(plain_program(operation)))


def of_tier(tier: str) -> Implementation:
    """The tier's kernels."""
    return gufuncs(import_module(tier_named(tier).package))
