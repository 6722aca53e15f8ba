"""The tables that Programs read, in C: a function for each, which reads a number of a row.

Its name has the digits of the table's hash, so that files that are included together may repeat it.
"""

from collections.abc import Iterable

from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.render import render
from coscrew_codegen.program import Constant, Instruction, Program
from coscrew_codegen.program.ops import OF_TABLES
from coscrew_codegen.program.tables import ConstantTable, TableColumn, tables_of
from coscrew_codegen.program.values.formats import BY_NAME, Precision
from coscrew_codegen.program.values.table_arrays import rounded


def spelled(step: Instruction, precision: Precision) -> str:
    """A pattern of an operation of tables."""
    of, at = step.operands
    if isinstance(of, TableColumn):
        return f"ksl_table_{of.table.name}{precision.called}({{1}}, {of.place})"
    assert isinstance(at, Constant)
    call = f"ksl_index{precision.called}({{0}}, {int(at.double)})"
    if precision.lanes:
        return call
    call = f"({BY_NAME[precision.name].c_type}){call}"
    return f"{precision.c_type}({call})" if precision.device else call


def written(programs: Iterable[Program], precision: Precision) -> str:
    """The functions for these programs, which compute in this precision; empty without tables."""
    known = list(programs)
    if not any(step.op in OF_TABLES for program in known for step in program.instructions):
        return ""
    number, device = BY_NAME[precision.name].c_type, precision.device
    return render("c/tables", f=precision.suffix, F=precision.suffix.upper(), number=number,
                  lanes=precision.lanes, device=device, real=precision.c_type,
                  one=precision.c_type if device else number,  # of one state
                  function="KSL_FUNCTION" if device else "static KSL_INLINED",
                  tables=[template_data(x, precision, precision.suffix) for x in tables_of(known)])


def template_data(table: ConstantTable, precision: Precision, suffix: str = ""
                  ) -> dict[str, object]:
    """Returns a table's name and sizes, and its numbers as literals, for templates; literals are
    the shortest decimals that round to the numbers, and end in the suffix."""
    numbers = [f"{x}{suffix}" for x in rounded(table, precision)]
    return {"name": table.name, "rows": table.rows, "stride": table.stride, "width": table.width,
            "count": len(numbers), "numbers": listed("    ", numbers, "", WIDTH)}
