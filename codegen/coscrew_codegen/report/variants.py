"""The variants of an operation: every tier that it has."""

import functools

from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.programs import program_of
from coscrew_codegen.report.c_text import Variant
from coscrew_codegen.tiers import TIERS


@functools.cache
def variants_of(operation: Operation, precision: Precision) -> tuple[Variant, ...]:
    """Plain first, then the tiers in their order."""
    plain = program_of(operation)
    return tuple(Variant(tier.operation(operation), precision, tier.name,
                         tier.program(plain, precision)) for tier in TIERS if tier.has(plain))
