"""A report's tables, for the page, for Markdown and for a terminal."""

from collections.abc import Sequence

from coscrew_codegen.backends.html.pages import Table
from coscrew_codegen.reports.kernels.pages.overview import (
    formatted,
    largest_changes,
    time_of,
    with_interval,
)
from coscrew_codegen.reports.kernels.report_json import (
    Comparison,
    DriftErrors,
    ErrorFigures,
    Provenance,
    ReportEntry,
)

_DETAILED = ("operation", "precision", "tier", "hard: worst", "99.9 %", "median", "ns", "to plain",
             "Pareto", "flops", "bound", "error / bound", "benign: worst", "99.9 %", "median")
_KERNELS = ("operation", "precision", "tier", "worst, benign", "worst, hard", "error / bound",
            "flops", "ns", "to plain", "Pareto")


def kernels(entries: Sequence[ReportEntry], layout: str) -> Table:
    """A row for each kernel, with its times in this layout."""
    return Table(_KERNELS, tuple(_kernel(x, layout) for x in entries), texts=3)


def _kernel(entry: ReportEntry, layout: str) -> tuple[str, ...]:
    time = time_of(entry, layout)
    return (entry.operation, entry.precision, entry.tier,
            *(_worst(errors, entry.measure) for errors in (entry.benign, entry.hard)),
            formatted(entry.bound.worst_ratio if entry.bound else None), str(entry.flops),
            *((with_interval(time.ns, time.low, time.high),
               with_interval(time.ratio, time.ratio_low, time.ratio_high),
               "○ dominated" if time.dominated else "● undominated") if time else ("–",) * 3))


def detailed(entries: Sequence[ReportEntry], layout: str) -> Table:
    """A row for each kernel with all its figures and its times in this layout."""
    return Table(_DETAILED, tuple(_all_figures(x, layout) for x in entries), texts=3)


def _all_figures(x: ReportEntry, layout: str) -> tuple[str, ...]:
    *_, ratio, flops, ns, to_plain, pareto = _kernel(x, layout)
    hard, benign = ((_worst(e, x.measure), formatted(e.p999), formatted(e.median)) if e else
                    ("–",) * 3 for e in (x.hard, x.benign))
    return (x.operation, x.precision, x.tier, *hard, ns, to_plain, pareto, flops,
            x.bound.text if x.bound else "–", ratio, *benign)


def witnesses(entries: Sequence[ReportEntry]) -> Table:
    """A row for each kernel and kind of inputs: the inputs of its worst error."""
    return Table(
        ("operation", "precision", "tier", "inputs", "component", "at", "worst", "outputs"),
        tuple((x.operation, x.precision, x.tier, inputs, e.component, " ".join(e.witness),
               _worst(e, x.measure), f"{e.outputs:,}")
              for x in entries for inputs, e in (("hard", x.hard), ("benign", x.benign)) if e),
        texts=6)


def _worst(errors: ErrorFigures | None, measure: str) -> str:
    worst = formatted(errors.worst if errors else None)
    return worst if worst == "–" else f"{worst} {measure}"


def drift(rows: Sequence[DriftErrors]) -> Table:
    """Table of the errors of a displacement after many compositions."""
    return Table(
        ("precision", "orthonormalised", "steps", "orthonormality defect, u", "error, u",
         "ns per step"),
        tuple((d.precision, "yes" if d.orthonormalised else "no", str(d.steps),
               formatted(d.defect_u), formatted(d.error_u),
               with_interval(d.ns_per_step, d.ns_low, d.ns_high)) for d in rows), texts=2,
        title="Drift of a displacement composed many times")


def changes(compare: Comparison) -> Table:
    """The largest changes since another report."""
    rows = largest_changes(compare)
    return Table(
        ("operation", "precision", "tier", "what", "before", "after", "after / before"),
        tuple((x.operation, x.precision, x.tier, x.what, formatted(x.before), formatted(x.after),
               f"{formatted(x.ratio)} ×") for x in rows),
        (f"The {len(rows)} largest changes, of {len(compare.rows)} figures compared.",),
        title=f"Changes since {compare.file}", texts=4)


def source(its: Provenance) -> tuple[tuple[str, str], ...]:
    """Sentences on the source of the figures."""
    return (("command", f"{its.command}, seed {its.seed}"),
            ("machine", f"{its.cpu}, {its.cores} cores, {its.system}"),
            ("software", f"coscrew {its.version}, Python {its.python}, NumPy {its.numpy}"),
            *((x.name, f"{x.version}, {x.flags}") for x in its.compilers),
            ("measured in", f"{its.seconds:.0f} s"))
