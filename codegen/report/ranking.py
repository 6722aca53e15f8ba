"""Figures beside each other: ratios to plain, dominated variants, changes since a report."""

import math
import operator
from collections.abc import Iterable, Iterator, Mapping

from coscrew_codegen.report.schema import Change, Comparison, Report, Time
from coscrew_codegen.report.timing import Timed

Key = tuple[str, str, str]  # operation, precision, tier


def key(timed: Timed) -> Key:
    """Which variant was timed."""
    return timed.variant.operation.name, timed.variant.precision.name, timed.variant.tier


def times(timed: Iterable[Timed], worst: Mapping[Key, float]) -> dict[Key, tuple[Time, ...]]:
    """The times of each variant, with their ratio to plain's, and whether another tier is no slower
    and has no larger a worst error on hard inputs, and is better in one of both; one that returns
    less, as plain does beside certified, does not count."""
    found: dict[Key, list[Time]] = {}
    contests: dict[tuple[str | None, ...], list[Timed]] = {}
    for t in timed:
        contest = (*key(t)[:2], t.language, t.compiler, t.layout)
        contests.setdefault(contest, []).append(t)
    for rivals in contests.values():
        cost = {key(t): (t.minimum, worst.get(key(t), 0.0), -len(t.variant.operation.outputs))
                for t in rivals}
        plain = next((t.minimum for t in rivals if t.variant.tier == "plain"), None)
        for t in rivals:
            mine = cost[key(t)]
            dominated = any(other[:2] != mine[:2] and all(map(operator.le, other, mine))
                            for other in cost.values())
            found.setdefault(key(t), []).append(
                t.time(t.minimum / plain if plain else None, dominated))
    return {variant: tuple(its) for variant, its in found.items()}


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
            where = " ".join(filter(None, (time.language, time.compiler, time.layout)))
            yield (variant, f"ns, {where}"), time.ns


def _ratio(before: float, after: float) -> float:
    if before == after:
        return 1.0
    return after / before if before else math.inf
