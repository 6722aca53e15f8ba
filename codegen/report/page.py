"""Writes a report: report.html, a self-contained page; report.md; figures in SVG."""

import json
from dataclasses import asdict
from math import isfinite
from pathlib import Path

from coscrew_codegen.emit import write as write_files
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

Json = dict[str, "Json"] | list["Json"] | tuple["Json", ...] | str | float | bool | None


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
                  shown=formatted, data=_embedded(data))


def _embedded(data: Json) -> str:
    """JSON that is safe in a script element: without `<`, and without bare NaN or Infinity."""
    text = json.dumps(_finite(data), allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c")


def _finite(data: Json) -> Json:
    """The data with NaN and infinities as strings, "NaN", "Infinity" and "-Infinity"."""
    if isinstance(data, dict):
        return {key: _finite(value) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [_finite(value) for value in data]
    if isinstance(data, float) and not isfinite(data):
        return json.dumps(data)
    return data
