"""The refusal of compilers whose double has 32 bits, as on AVR: results would be wrong."""

from collections.abc import Iterable
from dataclasses import dataclass

from coscrew_codegen.program.values.formats import DOUBLE, Precision


@dataclass(frozen=True)
class Double:
    """Condition under which a header computes in double: of the preprocessor, ending in &&, or ""
    for everywhere; and what to do with a compiler whose double is shorter."""

    where: str
    remedy: str


def of_library(precisions: Iterable[Precision]) -> Double | None:
    """The refusal of headers with operations in these precisions; None if none is double."""
    return Double("", "generate the headers with --precision single") \
        if DOUBLE in precisions else None


EXACT = Double("", "this tier computes in double, also in single precision; use the plain one")
"""The refusal of the headers of tiers that compute in double."""


def of_scene(upper: str, working: Iterable[tuple[Precision, Precision]]) -> Double | None:
    """The refusal of a scene's header; `working` has each precision and that in which its functions
    compute.  None if none computes in double."""
    in_double = tuple(dict.fromkeys(p for p, computes in working if computes == DOUBLE))
    if not in_double:
        return None
    where = " || ".join(f"!defined({upper}_NO_{p.name.upper()})" for p in in_double)
    if in_double == (DOUBLE,):
        remedy = f"define {upper}_NO_DOUBLE, or generate with --precision single"
    else:
        remedy = "this tier computes in double, also in single precision; the pairs tier does not"
    return Double(f"({where}) && " if len(in_double) > 1 else f"{where} && ", remedy)
