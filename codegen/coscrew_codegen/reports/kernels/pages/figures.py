"""Figures of a report as SVG, the same bytes for the same report: the headline, and per operation
time against error and error against condition."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from math import isfinite, nan

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import SymmetricalLogLocator

from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.backends.html.plots import (
    Mark,
    Panel,
    legend_below,
    logarithmic,
    place_labels,
    scatter,
    styled,
    svg,
)
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.reports.kernels.pages.overview import (
    PRECISIONS,
    entry_name,
    first_layout,
    formatted,
    headline_operations,
    tiers_of,
    time_of,
    with_interval,
)
from coscrew_codegen.reports.kernels.report_json import ProvenBound, Report, ReportEntry

_COLOURS = {tier.name: tier.colours[0] for tier in TIERS}


@styled
def figures(report: Report, operations: tuple[str, ...]) -> dict[str, str]:
    """The SVG texts by file name: the headline, and each panel of the operations."""
    figure = Figure(figsize=(9, 4), layout="constrained")
    for axes, panel in zip(figure.subplots(1, 2, sharey=True), headline(report), strict=True):
        panel.draw(axes)
    figure.axes[1].set_ylabel("")
    place_labels(figure)
    return {"headline.svg": svg(figure), **{
        f"{name}.svg": svg(x.alone) for name, x in panels(report, operations).items()}}


def headline(report: Report) -> tuple[Panel, ...]:
    """Accuracy against time: one panel per precision, one line per operation."""
    names, layout = headline_operations(report), first_layout(report)
    return tuple(Panel(
        f"What accuracy costs in {precision} precision",
        partial(_tiers, title=f"{precision} precision", layout=layout, name=_operation, lines=[
            [e for e in report.entries if (e.operation, e.precision) == (name, precision)]
            for name in names]), _titles(report.entries, layout)) for precision in PRECISIONS)


def panels(report: Report, operations: tuple[str, ...]) -> dict[str, Panel]:
    """The panels of operations by name: time against the worst error, error against condition."""
    layout, results = first_layout(report), {}
    for name in operations:
        entries = [entry for entry in report.entries if entry.operation == name]
        titles = _titles(entries, layout)
        results[f"pareto-{name}"] = Panel(
            f"Time against worst error of {name}",
            partial(_tiers, title=name, layout=layout, name=_precision, lines=[
                [e for e in entries if e.precision == precision] for precision in PRECISIONS]),
            titles)
        if any(map(_finite_pairs, entries)):
            results[f"condition-{name}"] = Panel(f"Error of {name} against condition",
                                                 partial(_condition, entries=entries), titles)
    return results


def _operation(entry: ReportEntry) -> str:
    return entry.operation


def _precision(entry: ReportEntry) -> str:
    return entry.precision


def _titles(entries: Iterable[ReportEntry], layout: str) -> dict[str, str]:
    return {entry_name(entry): _title(entry, layout) for entry in entries}


def _title(entry: ReportEntry, layout: str) -> str:
    time, errors = time_of(entry, layout), entry.hard or entry.benign
    return (f"{entry_name(entry)}: {formatted(errors.worst if errors else None)} {entry.measure}, "
            f"{with_interval(time.ns, time.low, time.high) if time else '–'} ns"
            f"{', dominated' if time and time.dominated else ''}")


def _tiers(axes: Axes, title: str, lines: Sequence[list[ReportEntry]], layout: str,
           name: Callable[[ReportEntry], str]) -> None:
    """Draws one mark per tier at (ns, worst error); undominated ones are joined, and the fastest of
    these is named."""
    marks: list[Mark] = []
    for entries in lines:
        its = [x for x in (_mark(entry, layout) for entry in entries) if x]
        best = sorted((x for x in its if not x.hollow), key=lambda x: x.x)
        axes.plot([x.x for x in best], [x.y for x in best], ":", color="#9aa2b1", zorder=1)
        marks += [replace(x, label=name(entries[0])) if best and x is best[0] else x for x in its]
    scatter(axes, marks)
    entries = [entry for line in lines for entry in line]
    axes.set(title=title, xlabel=f"ns per element: {layout}",
             ylabel=f"worst error, hard inputs ({_measures(entries)})")
    for tier in tiers_of(entries):
        axes.plot([], [], "o", color=tier.colours[0], label=tier.name)
    if entries:
        axes.legend()


def _mark(entry: ReportEntry, layout: str) -> Mark | None:
    time, errors = time_of(entry, layout), entry.hard or entry.benign
    if not time:
        return None
    return Mark(entry_name(entry), time.ns, time.low, time.high, errors.worst if errors else nan,
                _COLOURS[entry.tier], BY_NAME[entry.precision].marker, time.dominated)


def _condition(axes: Axes, entries: list[ReportEntry]) -> None:
    """Errors against condition, and the proven bounds 1 + (c1 + c2 u) S/|x| as lines."""
    for entry in entries:
        if pairs := _finite_pairs(entry):
            axes.plot(*zip(*pairs, strict=True), BY_NAME[entry.precision].marker, markersize=3,
                      color=_COLOURS[entry.tier], alpha=0.5, markeredgewidth=0,
                      label=f"{entry.precision} {entry.tier}", gid=entry_name(entry))
            if entry.bound:
                _bound_line(axes, entry, entry.bound, [x for x, _ in pairs])
    axes.set(title=f"{entries[0].operation}: errors, bounds as lines", xlabel="condition S/|x|",
             ylabel=f"error ({_measures(entries)})")
    logarithmic(axes.xaxis)
    axes.set_yscale("symlog", linthresh=0.1)  # ulp: linear below, so that it has a zero
    axes.yaxis.set_major_locator(SymmetricalLogLocator(base=1000, linthresh=0.1))
    axes.set_ylim(0)
    legend_below(axes)


def _finite_pairs(entry: ReportEntry) -> list[tuple[float, float]]:
    return [pair for pair in entry.condition if all(map(isfinite, pair))]


def _bound_line(axes: Axes, entry: ReportEntry, bound: ProvenBound,
                conditions: list[float]) -> None:
    """Draws the bound in ulp, as in u |x|: |err| <= u |x̂| + (c1 u + c2 u²) S and 1 ulp >= u |x|.
    """
    precision, steps = BY_NAME[entry.precision], np.geomspace(min(conditions), max(conditions), 61)
    axes.plot(steps, bound.rounded + (bound.c1 + bound.c2 * float(precision.u)) * steps,
              precision.dash, color=_COLOURS[entry.tier], linewidth=1.2)


def _measures(entries: Iterable[ReportEntry]) -> str:
    return " or ".join(dict.fromkeys(entry.measure for entry in entries))
