"""The variants of an operation: every tier that it has."""

import functools

from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.algebra.lowering.programs import program_of
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.reports.kernels.c_text import Variant


@functools.cache
def variants_of(operation: Operation, precision: Precision) -> tuple[Variant, ...]:
    """Plain first, then the tiers in their order."""
    plain = program_of(operation)
    return tuple(Variant(tier.operation(operation), precision, tier.name,
                         tier.program(plain, precision)) for tier in TIERS if tier.has(plain))
