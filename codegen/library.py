"""What targets are given of the library: its operations with their Programs."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Program
from coscrew_codegen.tiers import Tier


@dataclass(frozen=True, eq=False)
class Library:
    """The operations that are asked for, each as every tier has it, in every precision.

    `plain` holds the plain programs by the operations' names; `banner` is the first line of every
    file, as a comment's text."""

    operations: tuple[Operation, ...]
    plain: Mapping[str, Program]
    families: tuple[str, ...]
    precisions: tuple[Precision, ...]
    languages: tuple[str, ...]
    banner: str

    @cache  # noqa: B019  every target asks again; libraries live as long as the process
    def kernels(self, tier: Tier, precision: Precision) -> Mapping[Operation, Program]:
        """The operations that have the tier, as it has them, with their programs."""
        return {tier.operation(op): tier.program(self.plain[op.name], precision)
                for op in self.operations if tier.has(self.plain[op.name])}

    def by_family(self, tier: Tier, precision: Precision
                  ) -> Mapping[str, Mapping[Operation, Program]]:
        """These, family by family; no family is empty."""
        found: dict[str, dict[Operation, Program]] = {family: {} for family in self.families}
        for operation, program in self.kernels(tier, precision).items():
            found[operation.family][operation] = program
        return {family: kernels for family, kernels in found.items() if kernels}

    def documented(self, tier: Tier) -> Mapping[Operation, Program]:
        """The kernels that documentation describes: the first precision's, which is double's where
        there are both."""
        return self.kernels(tier, self.precisions[0])
