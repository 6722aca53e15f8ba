"""A report's most informative figures as a table for a terminal."""

from collections.abc import Sequence

from tabulate import tabulate

from coscrew_codegen.reports.kernels.pages.overview import with_interval
from coscrew_codegen.reports.kernels.report_json import Report, ReportEntry, Time

_HEADERS = ("operation", "precision", "tier", "benign", "hard", "error / bound", "flops", "C, ns",
            "Python, ns", "C, to plain")


def table(report: Report, shown: Sequence[str]) -> str:
    """Worst errors and times (in C over structures of arrays, in Python with 1000 elements) of the
    operations `shown`; of all if the report has few."""
    names = {entry.operation for entry in report.entries}
    chosen = [e for e in report.entries if e.operation in shown or len(names) < len(shown)]
    about = report.provenance
    message = f"{about.cpu}, {', '.join(c.name for c in about.compilers) or 'no C compiler'}"
    notes = ("Worst errors in ulp (u where marked), hard up to condition 0.1/u; ns per element,\n"
             "median (95 % interval): structure of arrays in C, N = 1000 in Python; ratios to\n"
             "plain are of the same round.")
    rows = tabulate(list(map(_row, chosen)), _HEADERS, floatfmt=".3g", stralign="right")
    return f"{message}\n{rows}\n{notes}"


def _row(entry: ReportEntry) -> tuple[object, ...]:
    mark = "" if entry.measure == "ulp" else " u"
    errors = [f"{e.worst:.3g}{mark}" if e else "" for e in (entry.benign, entry.hard)]
    in_c = next((t for t in entry.times if t.layout == "structure of arrays"), None)
    in_python = next((t for t in entry.times if t.layout == "N = 1000"), None)
    return (entry.operation, entry.precision, entry.tier, *errors,
            entry.bound and entry.bound.worst_ratio, entry.flops, *map(_timed, (in_c, in_python)),
            in_c and with_interval(in_c.ratio, in_c.ratio_low, in_c.ratio_high))


def _timed(time: Time | None) -> str:
    return with_interval(time.ns, time.low, time.high) if time else ""
