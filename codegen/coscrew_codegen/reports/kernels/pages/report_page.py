"""Writes a report: report.html, a self-contained page; report.md; figures in SVG."""

from pathlib import Path

from coscrew_codegen.backends.emit import write as write_files
from coscrew_codegen.backends.html import pages
from coscrew_codegen.reports.kernels.pages import tables
from coscrew_codegen.reports.kernels.pages.figures import figures, headline, panels
from coscrew_codegen.reports.kernels.pages.markdown import markdown
from coscrew_codegen.reports.kernels.pages.overview import (
    headline_operations,
    layouts,
    sentences,
    tiers_of,
)
from coscrew_codegen.reports.kernels.report_json import Report


def write(report: Report, folder: Path, operations: tuple[str, ...] = ()) -> tuple[Path, ...]:
    """Write the page, its Markdown twin and the figures, those of `operations` or of the headline;
    returns their paths.  Raises EmitError; files are written whole or not at all."""
    operations = operations or headline_operations(report)
    drawn = figures(report, operations)
    files = {"report.html": page(report, operations), "report.md": markdown(report, tuple(drawn)),
             **drawn}
    write_files(files, folder)
    return tuple(folder / name for name in files)


def page(report: Report, operations: tuple[str, ...]) -> str:
    """The text of report.html, with figures of these operations."""
    drawn = (*headline(report), *panels(report, operations).values())
    others = [tables.drift(report.drift)] if report.drift else []
    others += [tables.changes(report.compare)] if report.compare else []
    return pages.page(
        "report/page.html", sentences=sentences(report), tiers=tiers_of(report.entries),
        scripted=True, source=tables.source(report.provenance), others=others,
        figures=[x.inline for x in drawn],
        kernels=[(layout or "not timed", tables.detailed(report.entries, layout))
                 for layout in layouts(report)],
        witnesses=tables.witnesses(report.entries))
