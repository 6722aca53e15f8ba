"""Writes a report's summary in a few sentences, and chooses the figures shown first."""

from collections.abc import Iterable, Iterator
from decimal import ROUND_HALF_UP, Context
from math import inf, isfinite, isnan, log

from coscrew_codegen.accuracy.tiers import PLAIN, TIERS, Tier
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.reports.kernels.report_json import (
    Change,
    Comparison,
    Report,
    ReportEntry,
    Time,
)

PRECISIONS = tuple(BY_NAME)
HEADLINE = ("product_CoAdc", "cross_sc", "dot_cs")

MOST_CHANGES = 60

_THREE_DIGITS = Context(prec=3, rounding=ROUND_HALF_UP)


def formatted(x: float | None) -> str:
    """Three significant digits; – for None and NaN."""
    if x is None or isnan(x):
        return "–"
    if not isfinite(x):
        return "∞" if x > 0 else "-∞"
    rounded = _THREE_DIGITS.create_decimal(x).normalize(_THREE_DIGITS)
    if x and not 1e-3 <= abs(x) < 1e5:
        digits, _, exponent = f"{rounded:e}".partition("e")
        return f"{digits}e{int(exponent)}"
    return f"{rounded:f}" if x else "0"


def layout_name(time: Time) -> str:
    """The name of a kind of time: language, compiler, layout."""
    return ", ".join(filter(None, (time.language, time.compiler, time.layout)))


def with_interval(median: float | None, low: float | None, high: float | None) -> str:
    """A median and its interval: 1.39 (1.38–1.41)."""
    return f"{formatted(median)} ({formatted(low)}–{formatted(high)})" if median else "–"


def tiers_of(entries: Iterable[ReportEntry]) -> tuple[Tier, ...]:
    """The tiers of the entries, in their order."""
    names = {entry.tier for entry in entries}
    return tuple(tier for tier in TIERS if tier.name in names)


def first_layout(report: Report) -> str:
    """The times shown first: those in C over a structure of arrays with the first compiler, else
    the first ones."""
    times = [time for entry in report.entries for time in entry.times]
    return next((layout_name(time) for time in times
                 if (time.language, time.layout) == ("C", "structure of arrays")),
                layout_name(times[0]) if times else "")


def layouts(report: Report) -> tuple[str, ...]:
    """All kinds of times, the first ones first."""
    names = (layout_name(time) for entry in report.entries for time in entry.times)
    return tuple(dict.fromkeys((first_layout(report), *names)))


def time_of(entry: ReportEntry, layout: str) -> Time | None:
    """The entry's time in this layout."""
    return next((time for time in entry.times if layout_name(time) == layout), None)


def headline_operations(report: Report) -> tuple[str, ...]:
    """The operations in the first figure: those of HEADLINE that were measured, else the first one
    with the most tiers."""
    names = [entry.operation for entry in report.entries]
    measured = tuple(name for name in HEADLINE if name in names)
    return measured or tuple(sorted(dict.fromkeys(names), key=names.count, reverse=True)[:3])


def largest_changes(compare: Comparison) -> tuple[Change, ...]:
    """The largest changes, up or down, without unchanged figures."""
    changed = [row for row in compare.rows if row.ratio != 1]
    return tuple(sorted(changed, key=_size, reverse=True)[:MOST_CHANGES])


def _size(change: Change) -> float:
    return abs(log(change.ratio)) if 0 < change.ratio < inf else inf


def sentences(report: Report) -> tuple[str, ...]:
    """The summary, each sentence made from the report's figures."""
    return tuple(_sentences(report))


def _sentences(report: Report) -> Iterator[str]:
    operations = {entry.operation for entry in report.entries}
    outputs = sum(errors.outputs for entry in report.entries
                  for errors in (entry.benign, entry.hard) if errors)
    yield ("Errors of coscrew's kernels, compared with exact results, and their times: "
           f"{_counted(len(operations), 'operation')}, {_counted(len(report.entries), 'kernel')}, "
           f"{outputs:,} outputs compared with exact arithmetic.")
    for name in headline_operations(report)[:1]:
        yield from _price(report, name)
    yield from _bounds(report)


def _counted(number: int, noun: str) -> str:
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"


def _price(report: Report, operation: str) -> Iterator[str]:
    """Accuracy against time: plain and the most accurate tier, in double precision."""
    layout = first_layout(report)
    by_tier = {entry.tier: (entry.hard.worst, f"{formatted(entry.hard.worst)} {entry.measure}",
                            with_interval(t.ns, t.low, t.high))
               for entry in report.entries
               if (entry.operation, entry.precision) == (operation, "double") and entry.hard
               and (t := time_of(entry, layout))}
    if PLAIN.name not in by_tier or len(by_tier) == 1:
        return
    _, error, time = by_tier.pop(PLAIN.name)
    best = min(by_tier, key=lambda tier: by_tier[tier][0])
    _, best_error, best_time = by_tier[best]
    yield (f"Where terms cancel, plain {operation} in double precision is off by up to "
           f"{error} and takes {time} ns; its {best} tier is off by "
           f"up to {best_error} and takes {best_time} ns: {layout}.")


def _bounds(report: Report) -> Iterator[str]:
    proven = [(entry, entry.bound.worst_ratio) for entry in report.entries
              if entry.bound and not isnan(entry.bound.worst_ratio)]
    over = [entry for entry, ratio in proven if ratio > 1]
    if over:
        yield (f"{_counted(len(over), 'kernel')} of the {len(proven):,} with a proven bound "
               f"exceeded it: {', '.join(map(entry_name, over[:5]))}"
               f"{', …' if len(over) > 5 else ''}.")
    elif proven:
        nearest, ratio = max(proven, key=lambda x: x[1])
        yield (f"All {len(proven):,} kernels with a proven bound kept it; the nearest, "
               f"{entry_name(nearest)}, came to {formatted(ratio)} of it.")


def entry_name(entry: ReportEntry) -> str:
    """The entry's name in sentences and plots."""
    return f"{entry.operation} {entry.precision} {entry.tier}"
