"""Figures of a report as SVG, the same bytes for the same report: the headline, and per operation
time against error and error against condition."""

import io
from collections.abc import Iterable
from math import isfinite, isnan

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import SymmetricalLogLocator

from coscrew_codegen.formats import BY_NAME
from coscrew_codegen.plots import STYLE
from coscrew_codegen.report.overview import (
    PRECISIONS,
    first_layout,
    formatted,
    headline_operations,
    tiers_of,
    time_of,
)
from coscrew_codegen.report.schema import Entry, ProvenBound, Report
from coscrew_codegen.tiers import TIERS

_COLOURS = {tier.name: tier.colours[0] for tier in TIERS}
_LINEAR_BELOW = 0.1  # ulp: the axis is linear below, so that it has a zero


def figures(report: Report, operations: tuple[str, ...]) -> dict[str, str]:
    """The SVG texts by file name."""
    layout = first_layout(report)
    drawn = {"headline.svg": _headline(report, layout)}
    for name in operations:
        entries = [entry for entry in report.entries if entry.operation == name]
        drawn[f"pareto-{name}.svg"] = _pareto(name, entries, layout)
        if any(map(_finite_pairs, entries)):
            drawn[f"condition-{name}.svg"] = _condition(name, entries)
    return drawn


def _headline(report: Report, layout: str) -> str:
    """Accuracy against time: one panel per precision, one line per operation."""
    operations = headline_operations(report)
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9, 4), layout="constrained")
        for axes, precision in zip(figure.subplots(1, 2, sharey=True), PRECISIONS, strict=True):
            axes.set_title(f"{precision} precision")
            for number, name in enumerate(operations):
                entries = [e for e in report.entries
                           if (e.operation, e.precision) == (name, precision)]
                _tiers(axes, entries, layout, name, 9 + 11 * number)  # so that names don't overlap
            _axes(axes, report.entries, layout)
        figure.axes[1].set_ylabel("")
        return _text(figure)


def _pareto(operation: str, entries: list[Entry], layout: str) -> str:
    """Time against the worst error of one operation; hollow marks are dominated."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(6, 4), layout="constrained")
        axes = figure.subplots()
        axes.set_title(operation)
        for precision in PRECISIONS:
            _tiers(axes, [e for e in entries if e.precision == precision], layout, precision)
        _axes(axes, entries, layout)
        return _text(figure)


def _tiers(axes: Axes, entries: Iterable[Entry], layout: str, name: str, lift: int = 9) -> None:
    """One mark per tier at (ns, worst error) with its interval as a line; those not dominated are
    joined.  The name is `lift` points above the fastest."""
    marks = []
    for entry in entries:
        time, errors = time_of(entry, layout), entry.hard or entry.benign
        if time and errors and not isnan(errors.worst):
            marks.append((time, errors.worst, entry))
    best = sorted((time.ns, y) for time, y, _ in marks if not time.dominated)
    axes.plot([x for x, _ in best], [y for _, y in best], ":", color="#9aa2b1", zorder=1)
    for time, y, entry in marks:
        colour, variant = _COLOURS[entry.tier], f"{entry.operation}-{entry.precision}-{entry.tier}"
        # An infinite error is drawn at the upper edge of the axes.
        at, transform = (y, axes.transData) if isfinite(y) else (1, axes.get_xaxis_transform())
        axes.plot([time.low, time.high], [at, at], "|-", color=colour, transform=transform,
                  linewidth=1.2, clip_on=False, gid=f"{variant}-interval")
        axes.plot([time.ns], [at], BY_NAME[entry.precision].marker, color=colour,
                  transform=transform, clip_on=False, gid=variant,
                  markerfacecolor="white" if time.dominated else colour)
    if best:
        axes.annotate(name, best[0], (-4, lift), textcoords="offset points")


def _axes(axes: Axes, entries: Iterable[Entry], layout: str) -> None:
    _logarithmic(axes)
    axes.margins(x=0.2)
    axes.xaxis.set_major_formatter(lambda x, _: formatted(x))
    axes.xaxis.set_minor_formatter(lambda x, _: formatted(x) if f"{x:e}"[0] in "25" else "")
    axes.set_xlabel(f"ns per element: {layout}")
    axes.set_ylabel(f"worst error, hard inputs ({_measures(entries)})")
    for tier in tiers_of(entries):
        axes.plot([], [], "o", color=tier.colours[0], label=tier.name)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(frameon=False)


def _logarithmic(axes: Axes) -> None:
    """Both axes logarithmic, the vertical one from zero and with room above for names."""
    axes.set_xscale("log")
    axes.set_yscale("symlog", linthresh=_LINEAR_BELOW)
    axes.set_ylim(0, 50 * max(axes.get_ylim()[1], _LINEAR_BELOW))
    locator = axes.yaxis.get_major_locator()
    if isinstance(locator, SymmetricalLogLocator):
        locator.set_params(numticks=9)


def _condition(operation: str, entries: list[Entry]) -> str:
    """Errors against condition, and the proven bounds 1 + (c1 + c2 u) S/|x| as lines."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(6, 4), layout="constrained")
        axes = figure.subplots()
        axes.set_title(f"{operation}: errors, and proven bounds as lines")
        for entry in entries:
            found = _finite_pairs(entry)
            if found:
                axes.plot(*zip(*found, strict=True), BY_NAME[entry.precision].marker, markersize=3,
                          color=_COLOURS[entry.tier], alpha=0.5, markeredgewidth=0,
                          label=f"{entry.precision} {entry.tier}")
            if found and entry.bound:
                _bound_line(axes, entry, entry.bound, [x for x, _ in found])
        _logarithmic(axes)
        axes.set_xlabel("condition S/|x|")
        axes.set_ylabel(f"error ({_measures(entries)})")
        axes.legend(frameon=False)
        return _text(figure)


def _finite_pairs(entry: Entry) -> list[tuple[float, float]]:
    return [pair for pair in entry.condition if all(map(isfinite, pair))]


def _bound_line(axes: Axes, entry: Entry, bound: ProvenBound, conditions: list[float]) -> None:
    """In ulp, as in u |x|: |err| <= u |x̂| + (c1 u + c2 u²) S and 1 ulp >= u |x|."""
    low, high = min(conditions), max(conditions)
    steps = [low * (high / low) ** (i / 60) for i in range(61)]
    precision = BY_NAME[entry.precision]
    slope = bound.c1 + bound.c2 * float(precision.u)
    axes.plot(steps, [bound.rounded + slope * x for x in steps], precision.dash,
              color=_COLOURS[entry.tier], linewidth=1.2)


def _measures(entries: Iterable[Entry]) -> str:
    return " or ".join(dict.fromkeys(entry.measure for entry in entries))


def _text(figure: Figure) -> str:
    """The figure as SVG."""
    text = io.StringIO()
    figure.savefig(text, format="svg", metadata={"Date": None, "Creator": None})
    return text.getvalue()
