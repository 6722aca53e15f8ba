"""Writes a report: report.html, a self-contained page; figures in SVG."""

from collections.abc import Iterator, Sequence
from math import inf, isnan, log
from pathlib import Path

from coscrew_codegen.accuracy.tiers import PLAIN
from coscrew_codegen.backends.emit import write as write_files
from coscrew_codegen.backends.html.pages import Chapter, Page, Table, number, with_interval
from coscrew_codegen.backends.html.plots import Panel, drawn, svg
from coscrew_codegen.reports.kernels.pages.figures import panels
from coscrew_codegen.reports.kernels.report_json import (
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
    drawings = tuple(panels(report, headline, operations or headline))
    files = {"report.html": _page(report, drawings).html(),
             **{x.file: svg(drawn((x,))) for x in drawings}}
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


def _page(report: Report, drawings: Sequence[Panel]) -> Page:
    return Page("coscrew: accuracy and time", tuple(_sentences(report)),
                tuple(_chapters(report, drawings)), tuple(_source(report.provenance)))


def _sentences(report: Report) -> Iterator[str]:
    """The summary, each sentence made from the report's figures."""
    operations = {entry.operation for entry in report.entries}
    outputs = sum(x.outputs for entry in report.entries for x in (entry.benign, entry.hard) if x)
    yield ("Errors of coscrew's kernels, compared with exact results, and their times: "
           f"{len(operations):,} operations, {len(report.entries):,} kernels, {outputs:,} outputs "
           "compared with exact arithmetic.")
    name, kind = _headline(report)[0], report.kinds[0]
    tiers = {x.tier: (x.hard.worst, f"is off by up to {number(x.hard.worst)} {x.measure} and takes "
                      f"{with_interval(t.ns, t.low, t.high)} ns") for x in report.entries
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


def _chapters(report: Report, drawings: Sequence[Panel]) -> Iterator[Chapter]:
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
    rows = [_figures(x, x.time(kind)) for x in entries]
    headers = tuple(columns or rows[0])
    return Table(headers, tuple(tuple(row[x] for x in headers) for row in rows),
                 title=kind or "not timed", texts=3)


def _figures(x: ReportEntry, time: Time | None) -> dict[str, str]:
    times = (with_interval(time.ns, time.low, time.high),
             with_interval(time.ratio, time.ratio_low, time.ratio_high),
             "○ dominated" if time.dominated else "● undominated") if time else ("–",) * 3
    return {"operation": x.operation, "precision": x.precision, "tier": x.tier,
            **_errors("hard", x.hard, x.measure),
            **dict(zip(("ns", "to plain", "Pareto"), times, strict=True)), "flops": str(x.flops),
            "bound": x.bound.text if x.bound else "–",
            "error / bound": number(x.bound.worst_ratio if x.bound else None),
            **_errors("benign", x.benign, x.measure)}


def _errors(inputs: str, e: ErrorFigures | None, measure: str) -> dict[str, str]:
    figures = (_worst(e, measure), number(e.p999), number(e.median)) if e else ("–",) * 3
    return dict(zip((f"{inputs}: worst", f"{inputs}: 99.9 %", f"{inputs}: median"), figures,
                    strict=True))


def _worst(errors: ErrorFigures, measure: str) -> str:
    worst = number(errors.worst)
    return worst if worst == "–" else f"{worst} {measure}"


def _witnesses(entries: Sequence[ReportEntry]) -> Table:
    """A row for each kernel and kind of inputs: the inputs of its worst error."""
    return Table(
        ("operation", "precision", "tier", "inputs", "component", "at", "worst", "outputs"),
        tuple((x.operation, x.precision, x.tier, inputs, e.component, " ".join(e.witness),
               _worst(e, x.measure), f"{e.outputs:,}")
              for x in entries for inputs, e in (("hard", x.hard), ("benign", x.benign)) if e),
        title="Inputs of the worst errors in hex", texts=6)


def _drift(rows: Sequence[DriftErrors]) -> Table:
    """The errors of a displacement after many compositions."""
    return Table(
        ("precision", "orthonormalised", "steps", "orthonormality defect, u", "error, u",
         "ns per step"),
        tuple((d.precision, "yes" if d.orthonormalised else "no", str(d.steps), number(d.defect_u),
               number(d.error_u), with_interval(d.ns_per_step, d.ns_low, d.ns_high))
              for d in rows), texts=2)


def _changes(compare: Comparison) -> Table:
    """The largest changes since another report, up or down."""
    changed = [x for x in compare.rows if x.ratio != 1]
    changed.sort(key=lambda x: -abs(log(x.ratio)) if 0 < x.ratio < inf else -inf)
    rows = changed[:_MOST_CHANGES]
    return Table(
        ("operation", "precision", "tier", "what", "before", "after", "after / before"),
        tuple((x.operation, x.precision, x.tier, x.what, number(x.before), number(x.after),
               f"{number(x.ratio)} ×") for x in rows),
        (f"The {len(rows)} largest changes, of {len(compare.rows)} figures compared.",), texts=4)
