"""Families: operations that share a header, a module and a page of the documentation."""

from dataclasses import dataclass

from coscrew_codegen.algebra.operations.operation import Operation


@dataclass(frozen=True)
class Family:
    """Operations of one subject, in the module with the family's name.

    A module of this package that assigns one to `FAMILY` adds it to headers, packages and the
    reference."""

    name: str
    order: int  # sorts the families
    about: str  # its first line is the title of the documentation
    operations: tuple[Operation, ...]  # some may belong to another family
    includes: tuple[str, ...] = ()  # families whose headers its own includes

    @property
    def title(self) -> str:
        """The first line of the family's documentation."""
        return self.about.splitlines()[0]
