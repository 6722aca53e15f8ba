"""The report as Markdown: one folded table per family, one row per kernel."""

from coscrew_codegen.algebra.operations import family_named
from coscrew_codegen.backends.html.pages import Table, in_markdown
from coscrew_codegen.backends.render import render
from coscrew_codegen.reports.kernels.pages import tables
from coscrew_codegen.reports.kernels.pages.overview import first_layout, sentences
from coscrew_codegen.reports.kernels.report_json import Report


def markdown(report: Report, figures: tuple[str, ...]) -> str:
    """The text of report.md; `figures` are the SVG files beside it."""
    layout = first_layout(report)
    families = [(family_named(name), tables.kernels(
        [e for e in report.entries if e.family == name], layout))
        for name in dict.fromkeys(entry.family for entry in report.entries)]
    return render("report/report.md", sentences=sentences(report), layout=layout,
                  source=Table(("", ""), tables.source(report.provenance), texts=2).markdown(),
                  families=families, figures=dict(map(_captioned, figures)), text=in_markdown,
                  drift=tables.drift(report.drift),
                  changes=report.compare and tables.changes(report.compare))


def _captioned(name: str) -> tuple[str, str]:
    """A figure's file and its caption."""
    kind, _, operation = name.removesuffix(".svg").partition("-")
    return name, {"headline": "What accuracy costs: time per element against worst error",
                  "pareto": f"Time against worst error of {operation}",
                  "condition": f"Error of {operation} against condition"}[kind]
