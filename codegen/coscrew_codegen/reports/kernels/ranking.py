"""Comparisons: ratios to plain, dominated variants, changes since an earlier report."""

import math
from collections.abc import Iterable, Iterator, Mapping

from coscrew_codegen.accuracy.tiers import PLAIN
from coscrew_codegen.reports.kernels.kernel_timing import Timed
from coscrew_codegen.reports.kernels.report_json import Change, Comparison, Report, Time

Key = tuple[str, str, str]  # operation, precision, tier


def key(timed: Timed) -> Key:
    """The key of the variant that was timed."""
    return timed.variant.operation.name, timed.variant.precision.name, timed.variant.tier


def times(timed: Iterable[list[Timed]], worst: Mapping[Key, float]) -> dict[Key, tuple[Time, ...]]:
    """The times of each variant, with their ratio to plain's, and whether it is dominated.

    A variant is dominated if another tier with as many outputs is faster, with disjoint intervals,
    and its worst error on hard inputs is no larger."""
    results: dict[Key, list[Time]] = {}
    for rivals in timed:
        its = {key(t): t.timing.time for t in rivals}
        plain = next((t.timing for t in rivals if t.variant.tier == PLAIN.name), None)

        def no_worse(other: Timed, than: Timed) -> bool:
            return (worst.get(key(other), 0.0) <= worst.get(key(than), 0.0)
                    and len(other.variant.operation.outputs) >= len(than.variant.operation.outputs))

        for t in rivals:
            time, ratio = its[key(t)], t.timing.ratio(plain) if plain else None
            median, low, high = (ratio.median, ratio.low, ratio.high) if ratio else (None,) * 3
            results.setdefault(key(t), []).append(Time(
                t.language, t.compiler, t.layout, time.median, time.low, time.high,
                t.timing.minimum, len(t.timing.rounds), median, low, high,
                any(its[key(x)].below(time) and no_worse(x, t) for x in rivals)))
    return {variant: tuple(its) for variant, its in results.items()}


def compared(before: Report, after: Report, file: str) -> Comparison:
    """Every figure that both reports have: worst errors and times."""
    earlier = dict(_figures(before))
    rows = [Change(*variant, what, earlier[variant, what], figure,
                   _ratio(earlier[variant, what], figure))
            for (variant, what), figure in _figures(after) if (variant, what) in earlier]
    return Comparison(file, tuple(rows))


def _figures(report: Report) -> Iterator[tuple[tuple[Key, str], float]]:
    for entry in report.entries:
        variant = (entry.operation, entry.precision, entry.tier)
        for name, errors in (("benign", entry.benign), ("hard", entry.hard)):
            if errors:
                yield (variant, f"worst error, {name}, {entry.measure}"), errors.worst
        for time in entry.times:
            yield (variant, f"ns, {time.kind}"), time.ns


def _ratio(before: float, after: float) -> float:
    if before == after:
        return 1.0
    return after / before if before else math.inf
