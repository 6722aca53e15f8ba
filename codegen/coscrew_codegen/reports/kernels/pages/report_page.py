"""Writes a report: report.html, a self-contained page; report.md; figures in SVG."""

from dataclasses import asdict
from pathlib import Path

from coscrew_codegen.backends.emit import write as write_files
from coscrew_codegen.backends.html import pages
from coscrew_codegen.reports.kernels.pages import tables
from coscrew_codegen.reports.kernels.pages.figures import figures
from coscrew_codegen.reports.kernels.pages.markdown import markdown
from coscrew_codegen.reports.kernels.pages.overview import (
    first_layout,
    headline_operations,
    sentences,
    tiers_of,
)
from coscrew_codegen.reports.kernels.report_json import Report


def write(report: Report, folder: Path, operations: tuple[str, ...] = ()) -> tuple[Path, ...]:
    """Write the page, its Markdown twin and the figures, those of `operations` or of the headline;
    returns their paths.  Raises EmitError; files are written whole or not at all."""
    drawn = figures(report, operations or headline_operations(report))
    files = {"report.html": page(report), "report.md": markdown(report, tuple(drawn)), **drawn}
    write_files(files, folder)
    return tuple(folder / name for name in files)


def page(report: Report) -> str:
    """The text of report.html."""
    tiers = tiers_of(report.entries)
    data = {**asdict(report), "headline": headline_operations(report),
            "layout": first_layout(report), "tiers": [tier.name for tier in tiers]}
    return pages.page("report/page.html", data, sentences=sentences(report), tiers=tiers,
                      source=tables.source(report.provenance), drift=tables.drift(report.drift),
                      changes=report.compare and tables.changes(report.compare))
