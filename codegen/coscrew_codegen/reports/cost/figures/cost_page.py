"""Writes a scene's costs as a self-contained page: plots, recommendations, tables."""

from pathlib import Path

from coscrew_codegen.accuracy.tiers import OF_SCENES
from coscrew_codegen.backends import version
from coscrew_codegen.backends.html import pages
from coscrew_codegen.reports.cost.cost_measurement import Costs
from coscrew_codegen.reports.cost.figures import cost_figure
from coscrew_codegen.reports.cost.figures.cost_tables import about, accuracies, others
from coscrew_codegen.reports.cost.needs import core_costs, need_table
from coscrew_codegen.reports.cost.recommendations import sentences
from coscrew_codegen.reports.processor import processor, system
from coscrew_codegen.simulation.recordings.recording_writer import delivered


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
        functions=[x.inline for x in cost_figure.functions(costs)],
        runs=[x.inline for x in cost_figure.runs(costs)],
        answers=[*([need_table.table(costs.answers)] if costs.answers else []),
                 *([core_costs.table(costs.cores)] if costs.cores else [])],
        advice=[sentences(rows) for rows in costs.accuracy],
        accuracies=[x for rows in costs.accuracy for x in accuracies(rows)],
        others=tuple(others(costs)), source=(
            ("command", command), ("machine", f"{processor()}, {system()}"),
            ("software", f"coscrew {version.described()}"), ("compiler", costs.compiler)))
