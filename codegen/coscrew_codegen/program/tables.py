"""Tables of constants that Programs read at a computed index.

A row begins `stride` numbers behind the one before it and has `width` of them, so that rows may
overlap.  An index is the integer part of a number, kept within the rows: 0 for NaN.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from hashlib import sha256
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from coscrew_codegen.program.program import Program


@dataclass(frozen=True, repr=False)
class ConstantTable:
    """The numbers of a table, exact, in rows."""

    values: tuple[Fraction, ...]
    stride: int
    width: int

    def __repr__(self) -> str:
        return f"ConstantTable({self.name})"

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        return hash((self.name, self.stride, self.width))

    @cached_property
    def rows(self) -> int:
        """The number of its rows."""
        return (len(self.values) - self.width) // self.stride + 1

    @cached_property
    def name(self) -> str:
        """Twelve digits of the hash of its content: its name in text."""
        digest = sha256(f"{self.stride} {self.width}".encode())
        for start in range(0, len(self.values), 4096):
            digest.update(" ".join(map(str, self.values[start:start + 4096])).encode() + b"\n")
        return digest.hexdigest()[:12]


@dataclass(frozen=True)
class TableColumn:
    """A column of a table: the number at one place of every row, as an operand of GATHER."""

    table: ConstantTable
    place: int

    def at(self, index: Any) -> Fraction:
        """The number in the row of this index."""
        return self.table.values[self.table.stride * index_of(index, self.table.rows) + self.place]

    @cached_property
    def values(self) -> tuple[Fraction, ...]:
        """Its numbers, by row."""
        stop = self.table.stride * (self.table.rows - 1) + self.place + 1
        return self.table.values[self.place:stop:self.table.stride]

    @cached_property
    def only(self) -> Fraction | None:
        """The number that all rows have there; None if they differ."""
        first, *others = self.values
        return first if all(x == first for x in others) else None


def index_of(x: Any, count: Any) -> int:
    """The integer part of a number of any kind, within 0 … count - 1; 0 for NaN."""
    if not x > 0:
        return 0
    if x >= count:
        return int(count) - 1
    near = int(x)  # that of an mpfr is the nearest
    return near - 1 if near > x else near


def tables_of(programs: "Iterable[Program]") -> tuple[ConstantTable, ...]:
    """The tables that programs read, in the order of their first uses."""
    return tuple(dict.fromkeys(x.table for program in programs for step in program.instructions
                               for x in step.operands if isinstance(x, TableColumn)))
