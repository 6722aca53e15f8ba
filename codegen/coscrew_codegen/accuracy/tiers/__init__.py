"""Accuracy tiers, one per module: from a plain program to the tier's.

plain       fixed order, every operation rounded once             names without a suffix
accurate    single: computed in double, rounded once; double: compensated, carried as hi + lo
certified   plain, and a bound on each component's error that always holds
mixed       single, with hi + lo where a requested accuracy needs it       scenes only
pairs       single: compensated, carried as hi + lo in single                  scenes only
fixed       32-bit integers, which provably never overflow for stated ranges   scenes only

A tier may also add in another order: `program.sums` gives the terms of a plain program's sums.
"""

from coscrew_codegen.accuracy.tiers.tier import Tier
from coscrew_codegen.program.plugins import discover

__all__ = ["MARKED", "OF_SCENES", "PLAIN", "TIERS", "Tier", "tier_named"]

_ALL = sorted(discover(__name__, __path__, "TIER", Tier), key=lambda tier: tier.order)
TIERS = tuple(tier for tier in _ALL if tier.make)
"""The tiers that operations have, the cheapest first."""

PLAIN = next(tier for tier in TIERS if not tier.marked)
MARKED = tuple(tier for tier in TIERS if tier.marked)
"""All tiers but plain: those with a suffix in names."""
OF_SCENES = tuple(tier for tier in _ALL if tier is PLAIN or tier.scene or tier.on_request
                  or tier.fixed)
"""The tiers that functions of scenes have."""


def tier_named(name: str) -> Tier:
    """The tier of this name.  Raises KeyError if there is none."""
    return {tier.name: tier for tier in _ALL}[name]
