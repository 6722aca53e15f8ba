"""The tables that Programs read, in Python: a function for each, which reads a number of a row."""

from collections.abc import Iterable

from coscrew_codegen.backends.c.tables import c_tables
from coscrew_codegen.backends.render import render
from coscrew_codegen.program import Constant, Instruction, Program
from coscrew_codegen.program.ops import OF_TABLES
from coscrew_codegen.program.tables import TableColumn, tables_of
from coscrew_codegen.program.values.formats import Precision


def spelled(step: Instruction) -> str:
    """A pattern of an operation of tables."""
    of, at = step.operands
    if isinstance(of, TableColumn):
        return f"table_{of.table.name}({{1}}, {of.place})"
    assert isinstance(at, Constant)
    return f"index({{0}}, {int(at.double)})"


def names(programs: Iterable[Program]) -> list[str]:
    """The names of the functions that programs call."""
    known = list(programs)
    steps = [step for program in known for step in program.instructions if step.op in OF_TABLES]
    return sorted({spelled(step).partition("(")[0] for step in steps})


def module(programs: Iterable[Program], precision: Precision, banner: str) -> str:
    """The module of these functions."""
    return render("scene/tables.py", banner=banner, precision=precision,
                  tables=[c_tables.template_data(x, precision) for x in tables_of(programs)])
