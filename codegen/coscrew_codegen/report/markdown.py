"""The report as Markdown: one folded table per family, one row per kernel."""

import html
import re
from collections.abc import Iterable

from tabulate import tabulate

from coscrew_codegen.operations import family_named
from coscrew_codegen.render import render
from coscrew_codegen.report.overview import (
    first_layout,
    formatted,
    largest_changes,
    sentences,
    time_of,
    with_interval,
)
from coscrew_codegen.report.schema import Change, Entry, Errors, Report

_COLUMNS = ("operation", "precision", "tier", "worst, benign", "worst, hard", "error / bound",
            "flops", "ns", "to plain", "Pareto")
_DRIFT = ("precision", "orthonormalised", "steps", "defect, u", "error, u", "ns per step")
_CHANGES = ("operation", "precision", "tier", "what", "before", "after", "ratio")


def markdown(report: Report, figures: tuple[str, ...]) -> str:
    """The text of report.md; `figures` are the SVG files beside it."""
    layout = first_layout(report)
    names = dict.fromkeys(entry.family for entry in report.entries)
    families = [{"name": name, "title": family_named(name).title,
                 "table": _kernels([e for e in report.entries if e.family == name], layout)}
                for name in names]
    return render("report/report.md", report=report, sentences=sentences(report), layout=layout,
                  families=families, figures=dict(map(_captioned, figures)),
                  drift=_drift(report), text=_escaped,
                  changes=report.compare and _changes(largest_changes(report.compare)))


def _captioned(name: str) -> tuple[str, str]:
    """A figure's file and its caption."""
    kind, _, operation = name.removesuffix(".svg").partition("-")
    return name, {"headline": "What accuracy costs: time per element against worst error",
                  "pareto": f"Time against worst error of {operation}",
                  "condition": f"Error of {operation} against condition"}[kind]


def _kernels(entries: list[Entry], layout: str) -> str:
    rows = []
    for entry in entries:
        time = time_of(entry, layout)
        rows.append((
            f"`{entry.operation}`", entry.precision, entry.tier,
            _worst(entry.benign, entry.measure), _worst(entry.hard, entry.measure),
            formatted(entry.bound.worst_ratio if entry.bound else None), entry.flops,
            with_interval(time.ns, time.low, time.high) if time else "–",
            with_interval(time.ratio, time.ratio_low, time.ratio_high) if time else "–",
            ("○ dominated" if time.dominated else "● undominated") if time else "–"))
    return _table(rows, _COLUMNS)


def _worst(errors: Errors | None, measure: str) -> str:
    return f"{formatted(errors.worst)} {measure}" if errors else "–"


def _drift(report: Report) -> str:
    return _table([(d.precision, "yes" if d.orthonormalised else "no", d.steps,
                    formatted(d.defect_u), formatted(d.error_u),
                    with_interval(d.ns_per_step, d.ns_low, d.ns_high))
                   for d in report.drift], _DRIFT)


def _changes(changes: tuple[Change, ...]) -> str:
    return _table([(f"`{row.operation}`", row.precision, row.tier, _escaped(row.what),
                    *map(formatted, (row.before, row.after, row.ratio))) for row in changes],
                  _CHANGES)


def _table(rows: Iterable[tuple[str | int, ...]], columns: tuple[str, ...]) -> str:
    first_number = min(map(columns.index, {"worst, benign", "steps", "before"} & set(columns)))
    sides = ["left"] * first_number + ["right"] * (len(columns) - first_number)
    return str(tabulate(rows, columns, tablefmt="pipe", disable_numparse=True, colalign=sides))


def _escaped(text: str) -> str:
    """The text on one line, escaped for Markdown."""
    return re.sub(r"([\\`*_\[\]|~])", r"\\\1", html.escape(" ".join(text.split()), quote=False))
