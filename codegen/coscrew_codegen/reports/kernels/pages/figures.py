"""Panels of a report: accuracy against time for all precisions and for an operation, error against
condition."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from math import isfinite, nan

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import SymmetricalLogLocator

from coscrew_codegen.backends.html import plots
from coscrew_codegen.backends.html.pages import number, with_interval
from coscrew_codegen.program.values.formats import BY_NAME, PRECISIONS
from coscrew_codegen.reports.kernels.report_json import Report, ReportEntry, Time

Lines = Sequence[tuple[str, Sequence[ReportEntry]]]  # entries that a line joins, by its name


def panels(report: Report, headline: Sequence[str], operations: Sequence[str]
           ) -> Iterator[plots.Panel]:
    """Accuracy against time in each precision, a line for each operation of the headline; then the
    same and error against condition of each of the operations."""
    def of(operation: str, precision: str) -> list[ReportEntry]:
        return [e for e in report.entries if (e.operation, e.precision) == (operation, precision)]

    tiers = partial(_tiers, kind=report.kinds[0])
    for p in PRECISIONS:
        yield plots.Panel(f"What accuracy costs in {p.name} precision", partial(
            tiers, title=f"{p.name} precision",
            lines=[(name, of(name, p.name)) for name in headline]))
    for name in operations:
        yield plots.Panel(f"Time against worst error of {name}", partial(
            tiers, title=name, lines=[(p.name, of(name, p.name)) for p in PRECISIONS]))
        entries = [e for p in PRECISIONS for e in of(name, p.name) if _finite_pairs(e)]
        if entries:
            yield plots.Panel(f"Error of {name} against condition",
                              partial(_condition, entries=entries))


def _tiers(axes: Axes, title: str, lines: Lines, kind: str) -> None:
    """Draws one mark per tier at (ns, worst error); undominated ones are joined, and the fastest of
    these is named."""
    marks: list[plots.Mark] = []
    for name, entries in lines:
        its = [_mark(x, time) for x in entries if (time := x.time(kind))]
        best = sorted((x for x in its if not x.hollow), key=lambda x: x.x)
        axes.plot([x.x for x in best], [x.y for x in best], ":", color=plots.EDGE, zorder=1)
        marks += [replace(x, label=name) if x in best[:1] else x for x in its]
    plots.scatter(axes, marks)
    shown = [x for _, entries in lines for x in entries]
    axes.set(title=title, xlabel=f"ns per element: {kind}",
             ylabel=f"worst error, hard inputs ({_measures(shown)})")
    plots.tier_legend(axes, (x.tier for x in shown))


def _mark(entry: ReportEntry, time: Time) -> plots.Mark:
    errors = entry.hard or entry.benign
    worst = errors.worst if errors else nan
    return plots.Mark(
        entry.name, time.ns, time.low, time.high, worst, plots.COLOURS[entry.tier],
        BY_NAME[entry.precision].marker, time.dominated, title=(
            f"{entry.name}: {number(worst)} {entry.measure}, "
            f"{with_interval(time.ns, time.low, time.high)} ns{', dominated' * time.dominated}"))


def _condition(axes: Axes, entries: Sequence[ReportEntry]) -> None:
    """Errors against condition; lines are the proven bounds in ulp, as in u |x|:
    |err| <= u |x̂| + (c1 u + c2 u²) S and 1 ulp >= u |x|."""
    for x in entries:
        pairs, precision, colour = _finite_pairs(x), BY_NAME[x.precision], plots.COLOURS[x.tier]
        axes.plot(*zip(*pairs, strict=True), precision.marker, markersize=3, color=colour,
                  alpha=0.5, markeredgewidth=0, label=f"{x.precision} {x.tier}", gid=x.name)
        if x.bound:
            steps = np.geomspace(min(pairs)[0], max(pairs)[0], 61)
            axes.plot(steps, x.bound.rounded + (x.bound.c1 + x.bound.c2 * float(precision.u))
                      * steps, precision.dash, color=colour, linewidth=1.2)
    axes.set(title=f"{entries[0].operation}: errors, bounds as lines", xlabel="condition S/|x|",
             ylabel=f"error ({_measures(entries)})")
    plots.logarithmic(axes.xaxis)
    axes.set_yscale("symlog", linthresh=0.1)  # ulp: linear below, so that it has a zero
    axes.yaxis.set_major_locator(SymmetricalLogLocator(base=1000, linthresh=0.1))
    axes.yaxis.set_major_formatter(lambda y, _: number(y))
    axes.set_ylim(0)
    plots.legend_below(axes)


def _finite_pairs(entry: ReportEntry) -> list[tuple[float, float]]:
    return [pair for pair in entry.condition if all(map(isfinite, pair))]


def _measures(entries: Sequence[ReportEntry]) -> str:
    return " or ".join(dict.fromkeys(entry.measure for entry in entries))
