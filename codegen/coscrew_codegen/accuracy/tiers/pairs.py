"""The pairs tier: accurate single precision for processors that have no double.

The accurate tier's compensated program, in single precision: every value, the model's decimals
included, is carried as a pair of floats, hi + lo, and rounded at the end.
"""

from coscrew_codegen.accuracy.range_proofs import of_pairs
from coscrew_codegen.accuracy.tiers.accurate_scene import in_pairs
from coscrew_codegen.accuracy.tiers.tier import Tier
from coscrew_codegen.program.values.formats import SINGLE

TIER = Tier(
    "pairs", 5, "Pairs tier: single precision compensated, every value a pair of floats.",
    ("#8250c4", "#b58cf0"), make=None, scene=in_pairs, precisions=(SINGLE,), header="ksl_exact",
    proof=of_pairs, pairs=(SINGLE,),
    promise="""\
A component is within 0.51 units of its last digit as long as its condition is below 1e4, and
within one below 1e6.  Measured, not proved.  The condition counts the model's decimals among the
rounded results.  Nothing is promised where something overflows or underflows.""",
    in_words="The pairs tier: float32 compensated, intermediate results carried as hi + lo.")
