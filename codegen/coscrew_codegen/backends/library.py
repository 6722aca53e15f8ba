"""The library as targets receive it: its operations, family by family, with their Programs."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Protocol, TypeVar

from coscrew_codegen.accuracy.tiers import TIERS, Tier
from coscrew_codegen.algebra.lowering.programs import program_of
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program import Program
from coscrew_codegen.program.values.formats import Precision

Kernels = Mapping[Operation, Program]
Made = TypeVar("Made")


@dataclass(frozen=True, eq=False)
class FamilyKernels:
    """The operations of a family in every tier and every selected precision, derived on demand:
    most results are kept."""

    family: str
    operations: tuple[Operation, ...]
    precisions: tuple[Precision, ...]

    @cached_property
    def plain(self) -> Kernels:
        """All operations, with their plain programs."""
        return {op: program_of(op) for op in self.operations}

    @cache  # noqa: B019  called by every target; libraries live as long as the process
    def of(self, tier: Tier, precision: Precision) -> Kernels:
        """The tier's operations with their programs; without those that the tier cannot take."""
        return {tier.operation(op): tier.program(program, precision)
                for op, program in self.plain.items() if tier.has(program)}


class Keep(Protocol):
    """Finds the result of `make` for a family, or calls it."""

    def __call__(self, kernels: FamilyKernels, make: Callable[[FamilyKernels], Made]) -> Made: ...


@dataclass(frozen=True, eq=False)
class Library:
    """The selected operations, in every tier and every selected precision.

    `command` makes its files, except those of `amalgamated` tiers and, if `many`, of functions of
    many elements, which are made by an option besides."""

    operations: tuple[Operation, ...]
    families: tuple[str, ...]
    precisions: tuple[Precision, ...]
    languages: tuple[str, ...]
    command: str
    keep: Keep
    amalgamated: tuple[Tier, ...] = ()  # besides plain: whose headers are also in one file
    many: bool = False  # whether also the functions of many elements
    whole: bool = True  # whether no family, precision or language is left out

    @property
    def banner(self) -> str:
        """The text of the comment on the first line of files."""
        return made_by(self.command)

    def banner_with(self, option: str) -> str:
        """The banner of files that are made only with this option."""
        return made_by(f"{self.command} {option}")

    @cached_property
    def _families(self) -> tuple[FamilyKernels, ...]:
        return tuple(FamilyKernels(
            family, tuple(op for op in self.operations if op.family == family), self.precisions)
            for family in self.families)

    @cache  # noqa: B019
    def made(self, make: Callable[[FamilyKernels], Made]) -> Mapping[str, Made]:
        """The results of `make`, family by family.  `make` must depend only on the kernels: it is
        not called for families whose results are kept and whose sources have not changed."""
        return {kernels.family: self.keep(kernels, make) for kernels in self._families}

    @cache  # noqa: B019
    def having(self, tier: Tier) -> tuple[Operation, ...]:
        """The operations that have a tier, as it has them, in the table's order."""
        names = {name for tiers in self.made(_tiered).values() for name in tiers[tier.name]}
        return tuple(tier.operation(op) for op in self.operations if op.name in names)


def made_by(command: str) -> str:
    """The text of the comment on the first line of a command's files."""
    return f"Made by `{command}`; changes are overwritten."


def _tiered(kernels: FamilyKernels) -> Mapping[str, tuple[str, ...]]:
    """Returns the names of the operations of each tier."""
    return {tier.name: tuple(op.name for op, program in kernels.plain.items()
                             if tier.has(program)) for tier in TIERS}
