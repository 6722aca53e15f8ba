"""Writes a report: report.html, a self-contained page; report.md; figures in SVG."""

from dataclasses import asdict
from pathlib import Path

from coscrew_codegen.emit import write as write_files
from coscrew_codegen.pages import embedded
from coscrew_codegen.render import render
from coscrew_codegen.report.figures import figures
from coscrew_codegen.report.markdown import markdown
from coscrew_codegen.report.overview import (
    first_layout,
    formatted,
    headline_operations,
    largest_changes,
    sentences,
    tiers_of,
)
from coscrew_codegen.report.schema import Report


def write(report: Report, folder: Path, operations: tuple[str, ...] = ()) -> tuple[Path, ...]:
    """Write the page, its Markdown twin and the figures, those of `operations` or of the headline;
    returns their paths.  Raises EmitError; files are written whole or not at all."""
    drawn = figures(report, operations or headline_operations(report))
    files = {"report.html": page(report), "report.md": markdown(report, tuple(drawn)), **drawn}
    write_files(files, folder)
    return tuple(folder / name for name in files)


def page(report: Report) -> str:
    """The text of report.html."""
    data = {**asdict(report), "headline": headline_operations(report),
            "layout": first_layout(report),
            "tiers": [tier.name for tier in tiers_of(report.entries)]}
    return render("report/page.html", report=report, sentences=sentences(report),
                  tiers=tiers_of(report.entries),
                  changes=report.compare and largest_changes(report.compare),
                  shown=formatted, data=embedded(data))
