"""What targets receive of the library: its operations with their Programs."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Program
from coscrew_codegen.tiers import Tier


@dataclass(frozen=True, eq=False)
class Library:
    """The selected operations, in every tier and every selected precision.

    `plain` maps operation names to plain programs; `banner` is the text of the comment on the first
    line of every file."""

    operations: tuple[Operation, ...]
    plain: Mapping[str, Program]
    families: tuple[str, ...]
    precisions: tuple[Precision, ...]
    languages: tuple[str, ...]
    banner: str

    @cache  # noqa: B019  called by every target; libraries live as long as the process
    def kernels(self, tier: Tier, precision: Precision) -> Mapping[Operation, Program]:
        """The tier's operations with their programs; without those that the tier cannot take."""
        return {tier.operation(op): tier.program(self.plain[op.name], precision)
                for op in self.operations if tier.has(self.plain[op.name])}

    def by_family(self, tier: Tier, precision: Precision
                  ) -> Mapping[str, Mapping[Operation, Program]]:
        """`kernels` by family; families without any are left out."""
        found: dict[str, dict[Operation, Program]] = {family: {} for family in self.families}
        for operation, program in self.kernels(tier, precision).items():
            found[operation.family][operation] = program
        return {family: kernels for family, kernels in found.items() if kernels}

    def documented(self, tier: Tier) -> Mapping[Operation, Program]:
        """The kernels that the documentation describes: those of the first precision, which is
        double if both are selected."""
        return self.kernels(tier, self.precisions[0])
