"""The fixed tier: 32-bit integers, for processors without floating point.

Every value is an integer times a power of two that is chosen in advance, such that nothing
overflows as long as arguments are in the ranges that the scene states."""

from coscrew_codegen.accuracy.tiers.tier import Tier

TIER = Tier(
    "fixed", 6, "Fixed tier: 32-bit integers, for arguments in stated ranges.",
    ("#b45309", "#fbbf24"), make=None, fixed=True, precisions=(),
    promise="""\
As long as arguments are in the stated ranges, nothing overflows, and every result is within its
bound of the exact one.  Proved, with arguments taken as exact.  All processors compute the same
bits.""",
    in_words="The fixed tier: 32-bit integers, each times a power of two.")
