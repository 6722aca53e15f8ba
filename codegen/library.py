"""What targets are given of the library: its operations, family by family, with their Programs."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Protocol, TypeVar

from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Program
from coscrew_codegen.programs import program_of
from coscrew_codegen.tiers import TIERS, Tier

Kernels = Mapping[Operation, Program]
Made = TypeVar("Made")


@dataclass(frozen=True, eq=False)
class FamilyKernels:
    """The operations of a family, each as every tier has it, in every precision.

    Derived when they are asked for, since most of what is made of them is kept."""

    family: str
    operations: tuple[Operation, ...]
    precisions: tuple[Precision, ...]

    @cached_property
    def plain(self) -> Kernels:
        """All operations, with their plain programs."""
        return {op: program_of(op) for op in self.operations}

    @cache  # every target asks again
    def of(self, tier: Tier, precision: Precision) -> Kernels:
        """The operations that have the tier, as it has them, with their programs."""
        return {tier.operation(op): tier.program(program, precision)
                for op, program in self.plain.items() if tier.has(program)}


class Keep(Protocol):
    """Finds what was made of a family's kernels before, or makes it."""

    def __call__(self, kernels: FamilyKernels, make: Callable[[FamilyKernels], Made]) -> Made: ...


@dataclass(frozen=True, eq=False)
class Library:
    """The operations that are asked for.

    `banner` is the first line of every file, as a comment's text."""

    operations: tuple[Operation, ...]
    families: tuple[str, ...]
    precisions: tuple[Precision, ...]
    languages: tuple[str, ...]
    banner: str
    keep: Keep

    @cached_property
    def _families(self) -> tuple[FamilyKernels, ...]:
        return tuple(FamilyKernels(
            family, tuple(op for op in self.operations if op.family == family), self.precisions)
            for family in self.families)

    @cache  # targets share what they make
    def made(self, make: Callable[[FamilyKernels], Made]) -> Mapping[str, Made]:
        """What `make`, a function of a module, gives of each family's kernels and of nothing else:
        where the family's sources are what they were, it is not made again."""
        return {kernels.family: self.keep(kernels, make) for kernels in self._families}

    def by_family(self, tier: Tier, precision: Precision) -> Mapping[str, Kernels]:
        """The operations that have a tier, with its programs; no family is empty."""
        return {kernels.family: found for kernels in self._families
                if (found := kernels.of(tier, precision))}

    @cache
    def having(self, tier: Tier) -> tuple[Operation, ...]:
        """The operations that have a tier, as it has them, in the table's order."""
        names = {name for found in self.made(_tiered).values() for name in found[tier.name]}
        return tuple(tier.operation(op) for op in self.operations if op.name in names)


def _tiered(kernels: FamilyKernels) -> Mapping[str, tuple[str, ...]]:
    """Of each tier, the names of the operations that have it."""
    return {tier.name: tuple(op.name for op, program in kernels.plain.items()
                             if tier.has(program)) for tier in TIERS}
