"""The pairwise tier: sums of halves.  A chain of n terms rounds the first n - 1 times; here no term
is rounded more than ⌈log2 n⌉ times after it has been multiplied."""

from collections.abc import Sequence

from coscrew_codegen.program.sums import Term, Tree, rearranged
from coscrew_codegen.tiers.tier import Tier


def pairwise(terms: Sequence[Term]) -> Tree:
    """Each half added alone, then both; halves of halves likewise."""
    def half(first: int, end: int) -> Tree:
        middle = (first + end + 1) // 2
        return first if end - first == 1 else (half(first, middle), half(middle, end))

    return half(0, len(terms))


TIER = Tier("pairwise", 4, "Pairwise tier: sums of halves.", ("#7a3e9d", "#c89be0"),
            make=lambda program, precision: rearranged(program, pairwise),
            in_words="The pairwise tier: every sum is added in halves.")
