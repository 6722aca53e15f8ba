"""A scene's costs as a self-contained page: plots, what they recommend, tables."""

from pathlib import Path

from coscrew_codegen import pages, version
from coscrew_codegen.cost import plot
from coscrew_codegen.cost.advice import sentences
from coscrew_codegen.cost.measure import Costs
from coscrew_codegen.cost.table import about, accuracies, others
from coscrew_codegen.machine import processor, system
from coscrew_codegen.simulate.write import delivered
from coscrew_codegen.tiers import OF_SCENES


def write(costs: Costs, path: Path, command: str) -> None:
    """Write the page.  Raises SimulateError."""
    text = page(costs, command)
    with delivered(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def page(costs: Costs, command: str) -> str:
    """The text of the page."""
    measured = {x.tier for rows in costs.accuracy for x in rows}
    return pages.page(
        "cost/page.html", scene=costs.scene, about=tuple(about(costs)),
        tiers=[tier for tier in OF_SCENES if tier.name in measured],
        functions=list(plot.functions(costs)), runs=list(plot.runs(costs)),
        advice=[sentences(rows) for rows in costs.accuracy],
        accuracies=[x for rows in costs.accuracy for x in accuracies(rows)],
        others=tuple(others(costs)), source=(
            ("command", command), ("machine", f"{processor()}, {system()}"),
            ("software", f"coscrew {version.described()}"), ("compiler", costs.compiler)))
