"""The table of operations for people, kept in the README between two marks."""

from collections.abc import Mapping

from coscrew_codegen.operations import FAMILIES, OPERATIONS, family_title
from coscrew_codegen.program import Program, counts_in_words

BEGIN, END = "<!-- operations: begin -->", "<!-- operations: end -->"


def with_table(readme: str | None, programs: Mapping[str, Program]) -> str | None:
    """The README with its table renewed; None if there is none, or it has not the marks."""
    if readme is None or BEGIN not in readme or END not in readme:
        return None
    before, _, rest = readme.partition(BEGIN)
    after = rest.partition(END)[2]
    return f"{before}{BEGIN}\n{operations_table(programs)}{END}{after}"


def operations_table(programs: Mapping[str, Program]) -> str:
    """Markdown: one foldable table per family, one row per operation."""
    return "\n".join(_family_table(family, programs) for family in FAMILIES)


def _family_table(family: str, programs: Mapping[str, Program]) -> str:
    operations = [op for op in OPERATIONS if op.family == family]
    rows = [f"| `{op.name}` | {_escaped(op.statement)} | `{op.signature}` | "
            f"{counts_in_words(programs[op.name])} |" for op in operations]
    return "\n".join((
        f"<details><summary><b><code>{family}.h</code></b>: {len(operations)} operations. "
        f"{family_title(family)}</summary>", "",
        "| name | computes | shapes | cost |", "|---|---|---|---|", *rows, "", "</details>", ""))


def _escaped(text: str) -> str:
    return text.replace("|", "\\|").replace("[", "\\[").replace("*", "\\*")
