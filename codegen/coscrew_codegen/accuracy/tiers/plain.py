"""The plain tier: the program as it was scheduled, every operation rounded once.

Its names have no suffix; every program has it."""

from coscrew_codegen.accuracy.range_proofs import of_plain
from coscrew_codegen.accuracy.tiers.tier import Tier

TIER = Tier(
    "plain", 0, "Plain tier: a fixed order, every operation rounded once.",
    ("#6b7280", "#aab2bf"), make=lambda program, precision: program, has=lambda program: True,
    proof=of_plain,
    in_words="Spatial algebra on screws and coscrews.", marked=False)
