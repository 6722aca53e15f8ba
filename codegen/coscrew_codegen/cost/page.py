"""A scene's costs as a self-contained page: plots, what they recommend, tables."""

from pathlib import Path

from coscrew_codegen.cost.advice import sentences
from coscrew_codegen.cost.measure import Costs
from coscrew_codegen.cost.schema import data
from coscrew_codegen.cost.table import about, accuracies, others
from coscrew_codegen.pages import embedded
from coscrew_codegen.render import render
from coscrew_codegen.simulate.write import delivered
from coscrew_codegen.tiers import OF_SCENES


def write(costs: Costs, path: Path, command: str) -> None:
    """Write the page.  Raises SimulateError."""
    text = page(costs, command)
    with delivered(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def page(costs: Costs, command: str) -> str:
    """The text of the page."""
    figures = data(costs, command)
    measured = {x.tier for rows in costs.accuracy for x in rows}
    return render("cost/page.html", tiers=OF_SCENES, measured=measured, about=tuple(about(costs)),
                  figures=figures, advice=[sentences(rows) for rows in costs.accuracy],
                  accuracies=[x for rows in costs.accuracy for x in accuracies(rows)],
                  others=tuple(others(costs)), data=embedded(figures))
