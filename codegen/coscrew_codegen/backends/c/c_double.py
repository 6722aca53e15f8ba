"""The refusal of compilers whose double has 32 bits, as on AVR: results would be wrong.

Values here say what to do with such a compiler."""

from collections.abc import Iterable

from coscrew_codegen.program.values.formats import DOUBLE, Precision


def of_library(precisions: Iterable[Precision]) -> str:
    """The remedy in headers of operations in these precisions; "" if none is double."""
    return "generate the headers with --precision single" if DOUBLE in precisions else ""


EXACT = "this tier computes in double, also in single precision; use the plain one"
"""Text for the headers of tiers that compute in double."""
