"""The summary of a sweep: tables for the terminal, and a self-contained page with figures."""

from collections.abc import Iterator, Mapping

import numpy as np

from coscrew_codegen.backends.html.pages import Table, page
from coscrew_codegen.scene.recorded_quantities import QUANTITIES
from coscrew_codegen.simulation.sweep.member_summary import STATISTICS
from coscrew_codegen.simulation.sweep.specification import Grid, Specification
from coscrew_codegen.simulation.sweep.statistics import sweep_figures
from coscrew_codegen.simulation.sweep.statistics.aggregate import LISTED, Aggregate
from coscrew_codegen.simulation.sweep.statistics.column import ColumnStatistics

_DRAWN = 12  # most recorded columns with a figure
_CAUSES = 5  # most joints of failed members that are named


def text(totals: Aggregate) -> str:
    """The final values, for the terminal, and which members failed."""
    rows = tuple((row[0], *row[2:]) for row in _rows(totals.columns) if row[1] == STATISTICS[0])
    parts = [Table(("final", *_headers(totals)[2:]), rows).text()] if rows else []
    if totals.failed:
        parts.append(failures(totals))
    return "\n\n".join(parts)


def failures(totals: Aggregate) -> str:
    """"12 of 1000 members failed: 10 at elbow, 2 at wrist"."""
    worst = sorted(totals.causes.items(), key=lambda x: (-x[1], x[0]))
    named = ", ".join(f"{count} at {joint or 'no joint'}" for joint, count in worst[:_CAUSES])
    more = ", …" if len(worst) > _CAUSES else ""
    return f"{totals.failed} of {totals.members} members failed: {named}{more}"


def html(specification: Specification, about: Mapping[str, str], totals: Aggregate, words: str
         ) -> str:
    """The text of the page."""
    drawn = _drawn([x for x in totals.columns if x.varies])
    same = [x.own.name for x in totals.columns if x.count and not x.varies]
    left = [x.own.name for x in totals.columns if x.varies and x not in drawn]
    source = {"command": words, "seed": str(specification.varied.seed), **about}
    return page("sweep/page.html", scene=specification.scene, members=totals.members,
                failed=totals.failed, varied=tuple(_varied(specification)), left=left,
                same=same,
                figures=[(x.own.name, sweep_figures.figures(x)) for x in drawn],
                tables_of=tuple(_tables(specification, totals, words)), about=source.items())


def _drawn(columns: list[ColumnStatistics]) -> list[ColumnStatistics]:
    """The columns with a figure, in the order recorded: the first of each quantity (q, torque,
    saturated, …), then the second of each, as long as there is room."""
    places: dict[str, int] = {}
    turns = []
    for x in columns:
        parts = x.own.name.split(".")
        quantity = parts[0] if parts[0] in QUANTITIES else parts[-1]
        places[quantity] = places.get(quantity, 0) + 1
        turns.append(places[quantity])
    chosen = sorted(range(len(columns)), key=lambda i: turns[i])[:_DRAWN]
    return [columns[i] for i in sorted(chosen)]


def _varied(specification: Specification) -> Iterator[str]:
    for x in specification.varied.each:
        unit = f" {x.of.unit}" if x.of.unit not in ("", "1") else ""
        if isinstance(x, Grid):
            yield (f"{x.of.name}: a grid of {len(x.values)} from {x.values[0]:g} to "
                   f"{x.values[-1]:g}{unit}")
        else:
            scale = ", in logarithms" if x.log else ""
            yield f"{x.of.name}: sampled from {x.low:g} to {x.high:g}{unit}{scale}"


def _tables(specification: Specification, totals: Aggregate, words: str) -> Iterator[Table]:
    if any(x.count for x in totals.columns):
        yield Table(_headers(totals), tuple(_rows(totals.columns)), (
            "Over the members that reached the end of their runs. Shares: the part of the "
            "variance over the members that each varied quantity explains alone, by means over "
            "its grid or over parts of its range; rough for fewer than about 1000 "
            "samples.",), title="Recorded quantities",
                    texts=2)
    if totals.failed:
        varied, more = specification.varied, totals.failed - len(totals.listed)
        above = f"{failures(totals)}." + (
            f" The first {LISTED} are listed; column failed of the Parquet files has all."
            if more else "") + (
            f" The seed of the Sobol sequence is {varied.seed}." if varied.ranges else "")
        yield Table(("member", *(x.label for x in totals.axes), "at t, s", "cause"), tuple(
            (str(k), *map(str, values), f"{t:.9g}", str(cause))
            for k, *values, t, cause in totals.listed), (
                f"{above} The first is run alone, with the same bits, by: {words} --member "
                f"{totals.listed[0][0]}",), title="Failed members")


def _headers(totals: Aggregate) -> tuple[str, ...]:
    return ("recorded", "statistic", "lowest", "mean", "highest",
            *(f"share of {x.name}" for x in totals.axes))


def _rows(columns: tuple[ColumnStatistics, ...]) -> Iterator[tuple[str, ...]]:
    for x in columns:
        if not x.count:
            continue
        shares = [x.explained(i) for i in range(len(x.axes))]
        for k, word in enumerate(STATISTICS):
            yield (x.own.label, word, f"{x.lowest[k]:.5g}", f"{x.mean[k]:.5g}",
                   f"{x.highest[k]:.5g}", *(_share(share[k]) for share in shares))


def _share(share: float) -> str:
    return "" if np.isnan(share) else f"{100 * share:.0f} %"
