"""What a family is: operations that share a header, modules of their name, a page."""

from dataclasses import dataclass

from coscrew_codegen.operations.operation import Operation


@dataclass(frozen=True)
class Family:
    """Operations of one subject, in the file of this folder that is called as they are.

    A file that calls one `FAMILY` has added it: headers, packages and the reference find it."""

    name: str
    order: int  # where it stands among the others
    about: str  # its first line heads the documentation
    operations: tuple[Operation, ...]  # some may belong to another family
    includes: tuple[str, ...] = ()  # families whose headers its own includes

    @property
    def title(self) -> str:
        """The first line of the family's documentation."""
        return self.about.splitlines()[0]
