"""Writes a report: report.html, a self-contained page; figures in SVG."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import inf, isfinite, isnan, log, nan
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import SymmetricalLogLocator

from coscrew_codegen.accuracy.tiers import PLAIN
from coscrew_codegen.backends.emit import write as write_files
from coscrew_codegen.backends.html import plots
from coscrew_codegen.backends.html.pages import Chapter, Page, Table, number, with_interval
from coscrew_codegen.program.values.formats import BY_NAME, PRECISIONS
from coscrew_codegen.reports.kernels.report_json import (
    Change,
    Comparison,
    DriftErrors,
    ErrorFigures,
    Provenance,
    Report,
    ReportEntry,
    Time,
)

_HEADLINE = ("product_CoAdc", "cross_sc", "dot_cs")
_FIGURES = ("Down is more accurate, left is faster. Lines through marks are the intervals of their "
            "times. Hollow marks are dominated: another tier is faster, with disjoint intervals, "
            "and at least as accurate on hard inputs. Dotted lines join the others. Against the "
            "condition of inputs, lines are the proven bound, error ≤ 1 + (c1 + c2 u) S/|x|; S is "
            "the sum of the |terms| of the formula, and 1 ulp ≥ u |x|.")
_KERNELS = ("Errors in ulp of a component, or in u = 2^-53 or 2^-24 relative to the largest "
            "component of its part where a figure ends in u: the worst, that of 99.9 %, the "
            "median. Benign inputs are ordinary; hard ones make terms cancel, up to a condition of "
            "0.1/u. Times are medians in ns per element, each with the interval that holds the "
            "true median in 95 of 100 cases; ratios to plain are of times in the same round.")
_SHORT = ("operation", "precision", "tier", "benign: worst", "hard: worst", "error / bound",
          "flops", "ns", "to plain", "Pareto")  # columns for a terminal
_MOST_CHANGES = 60


def write(report: Report, folder: Path, operations: tuple[str, ...] = ()) -> tuple[Path, ...]:
    """Write the page and the figures, those of `operations` or of the headline; returns their
    paths.  Raises EmitError; files are written whole or not at all."""
    headline = _headline(report)
    drawings = tuple(_panels(report, headline, operations or headline))
    page = Page("coscrew: accuracy and time", tuple(_sentences(report)),
                tuple(_chapters(report, drawings)), tuple(_source(report.provenance)))
    files = {"report.html": page.html(),
             **{f"{plots.slug(x.label)}.svg": plots.svg(plots.drawn((x,))) for x in drawings}}
    write_files(files, folder)
    return tuple(folder / name for name in files)


def summary(report: Report, operations: Sequence[str]) -> str:
    """The figures of these operations, for a terminal; of all, if the report has few."""
    few = len({x.operation for x in report.entries}) < len(operations)
    chosen = [x for x in report.entries if few or x.operation in operations]
    return (f"{report.provenance.cpu}: {report.kinds[0]}\n"
            f"{_kernels(chosen, report.kinds[0], _SHORT).text()}")


def _headline(report: Report) -> tuple[str, ...]:
    """The operations in the first figures: known ones, if they were measured, else the first."""
    names = tuple(dict.fromkeys(entry.operation for entry in report.entries))
    return tuple(name for name in _HEADLINE if name in names) or names[:3]


def _sentences(report: Report) -> Iterator[str]:
    """The summary, each sentence made from the report's figures."""
    operations = {entry.operation for entry in report.entries}
    outputs = sum(x.outputs for entry in report.entries for x in (entry.benign, entry.hard) if x)
    yield ("Errors of coscrew's kernels, compared with exact results, and their times: "
           f"{len(operations):,} operations, {len(report.entries):,} kernels, {outputs:,} outputs "
           "compared with exact arithmetic.")
    name, kind = _headline(report)[0], report.kinds[0]
    tiers = {x.tier: (x.hard.worst, f"is off by up to {number(x.hard.worst)} {x.measure} and takes "
                      f"{with_interval(*t.interval)} ns") for x in report.entries
             if x.hard and (x.operation, x.precision) == (name, "double") and (t := x.time(kind))}
    if PLAIN.name in tiers and len(tiers) > 1:
        _, plain = tiers.pop(PLAIN.name)
        best = min(tiers, key=lambda tier: tiers[tier][0])
        yield (f"Where terms cancel, plain {name} in double precision {plain}; its {best} tier "
               f"{tiers[best][1]}: {kind}.")
    proven = [(entry.bound.worst_ratio, entry.name) for entry in report.entries
              if entry.bound and not isnan(entry.bound.worst_ratio)]
    if proven:
        ratio, nearest = max(proven)
        yield (f"Of {len(proven):,} kernels with a proven bound "
               f"{sum(x > 1 for x, _ in proven) or 'none'} exceeded it; {nearest} came to "
               f"{number(ratio)} of it.")


def _chapters(report: Report, drawings: Sequence[plots.Panel]) -> Iterator[Chapter]:
    yield Chapter("What accuracy costs", (_FIGURES,), drawings)
    yield Chapter("All kernels", (_KERNELS,), tables=(
        *(_kernels(report.entries, kind) for kind in report.kinds),
        _witnesses(report.entries)), folded=True)
    if report.drift:
        yield Chapter("Drift of a displacement composed many times",
                      tables=(_drift(report.drift),))
    if report.compare:
        yield Chapter(f"Changes since {report.compare.file}",
                      tables=(_changes(report.compare),))


def _source(its: Provenance) -> Iterator[tuple[str, str]]:
    yield "command", f"{its.command}, seed {its.seed}"
    yield "machine", f"{its.cpu}, {its.cores} cores, {its.system}"
    yield "software", f"coscrew {its.version}, Python {its.python}, NumPy {its.numpy}"
    yield from ((x.name, f"{x.version}, {x.flags}") for x in its.compilers)
    yield "measured in", f"{its.seconds:.0f} s"


def _kernels(entries: Sequence[ReportEntry], kind: str, columns: Sequence[str] = ()) -> Table:
    """A row for each kernel with its times of this kind, in these columns or in all."""
    return Table.of((_figures(x, x.time(kind)) for x in entries), title=kind or "not timed",
                    texts=3, columns=columns)


def _figures(x: ReportEntry, time: Time | None) -> dict[str, str]:
    times = (with_interval(*time.interval),
             with_interval(time.ratio, time.ratio_low, time.ratio_high),
             "○ dominated" if time.dominated else "● undominated") if time else ("–",) * 3
    return {**_variant(x), **_errors("hard", x.hard, x.measure),
            **dict(zip(("ns", "to plain", "Pareto"), times, strict=True)), "flops": str(x.flops),
            "bound": x.bound.text if x.bound else "–",
            "error / bound": number(x.bound.worst_ratio if x.bound else None),
            **_errors("benign", x.benign, x.measure)}


def _variant(x: ReportEntry | Change) -> dict[str, str]:
    return {"operation": x.operation, "precision": x.precision, "tier": x.tier}


def _errors(inputs: str, e: ErrorFigures | None, measure: str) -> dict[str, str]:
    figures = (_worst(e, measure), number(e.p999), number(e.median)) if e else ("–",) * 3
    return dict(zip((f"{inputs}: worst", f"{inputs}: 99.9 %", f"{inputs}: median"), figures,
                    strict=True))


def _worst(errors: ErrorFigures, measure: str) -> str:
    worst = number(errors.worst)
    return worst if worst == "–" else f"{worst} {measure}"


def _witnesses(entries: Sequence[ReportEntry]) -> Table:
    """A row for each kernel and kind of inputs: the inputs of its worst error."""
    return Table.of((
        {**_variant(x), "inputs": inputs, "component": e.component, "at": " ".join(e.witness),
         "worst": _worst(e, x.measure), "outputs": f"{e.outputs:,}"}
        for x in entries for inputs, e in (("hard", x.hard), ("benign", x.benign)) if e),
        title="Inputs of the worst errors in hex", texts=6)


def _drift(rows: Sequence[DriftErrors]) -> Table:
    """The errors of a displacement after many compositions."""
    return Table.of((
        {"precision": d.precision, "orthonormalised": "yes" if d.orthonormalised else "no",
         "steps": str(d.steps), "orthonormality defect, u": number(d.defect_u),
         "error, u": number(d.error_u),
         "ns per step": with_interval(d.ns_per_step, d.ns_low, d.ns_high)} for d in rows), texts=2)


def _changes(compare: Comparison) -> Table:
    """The largest changes since another report, up or down."""
    changed = [x for x in compare.rows if x.ratio != 1]
    changed.sort(key=lambda x: -abs(log(x.ratio)) if 0 < x.ratio < inf else -inf)
    rows = changed[:_MOST_CHANGES]
    return Table.of((
        {**_variant(x), "what": x.what, "before": number(x.before), "after": number(x.after),
         "after / before": f"{number(x.ratio)} ×"} for x in rows),
        (f"The {len(rows)} largest changes, of {len(compare.rows)} figures compared.",), texts=4)


def _panels(report: Report, headline: Sequence[str], operations: Sequence[str]
           ) -> Iterator[plots.Panel]:
    """Accuracy against time in each precision, a line for each operation of the headline; then the
    same and error against condition of each of the operations."""
    def of(operation: str, precision: str) -> list[ReportEntry]:
        return [e for e in report.entries if (e.operation, e.precision) == (operation, precision)]

    tiers = partial(_tiers, kind=report.kinds[0])
    for p in PRECISIONS:
        yield plots.Panel(f"What accuracy costs in {p.name} precision", partial(
            tiers, title=f"{p.name} precision",
            lines={name: of(name, p.name) for name in headline}))
    for name in operations:
        yield plots.Panel(f"Time against worst error of {name}", partial(
            tiers, title=name, lines={p.name: of(name, p.name) for p in PRECISIONS}))
        if entries := [e for p in PRECISIONS for e in of(name, p.name) if _finite_pairs(e)]:
            yield plots.Panel(f"Error of {name} against condition",
                              partial(_condition, entries=entries))


def _tiers(axes: Axes, title: str, lines: Mapping[str, Sequence[ReportEntry]], kind: str
           ) -> None:
    """Draws one mark per tier at (ns, worst error); undominated ones are joined, and the fastest of
    these is named."""
    marks: list[plots.Mark] = []
    for name, entries in lines.items():
        its = [_mark(x, time) for x in entries if (time := x.time(kind))]
        best = sorted((x for x in its if not x.hollow), key=lambda x: x.x)
        axes.plot([x.x for x in best], [x.y for x in best], ":", color=plots.EDGE, zorder=1)
        marks += [replace(x, label=name) if x in best[:1] else x for x in its]
    plots.scatter(axes, marks)
    shown = [x for entries in lines.values() for x in entries]
    axes.set(title=title, xlabel=f"ns per element: {kind}",
             ylabel=f"worst error, hard inputs ({_measures(shown)})")
    plots.tier_legend(axes, (x.tier for x in shown))


def _mark(entry: ReportEntry, time: Time) -> plots.Mark:
    errors = entry.hard or entry.benign
    worst = errors.worst if errors else nan
    return plots.Mark(
        entry.name, *time.interval, worst, plots.COLOURS[entry.tier],
        BY_NAME[entry.precision].marker, time.dominated, title=(
            f"{entry.name}: {number(worst)} {entry.measure}, "
            f"{with_interval(*time.interval)} ns{', dominated' * time.dominated}"))


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
