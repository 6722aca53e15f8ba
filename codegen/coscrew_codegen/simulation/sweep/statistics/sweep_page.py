"""The summary of a sweep: tables for the terminal, and a self-contained page with figures."""

from collections import defaultdict
from collections.abc import Iterator, Mapping
from functools import partial
from itertools import zip_longest

import numpy as np
from matplotlib.axes import Axes

from coscrew_codegen.backends.html import plots
from coscrew_codegen.backends.html.pages import Chapter, Page, Table
from coscrew_codegen.scene.recorded_quantities import QUANTITIES
from coscrew_codegen.simulation.sweep.member_summary import STATISTICS
from coscrew_codegen.simulation.sweep.specification import Grid, Specification
from coscrew_codegen.simulation.sweep.statistics.aggregate import LISTED, Aggregate
from coscrew_codegen.simulation.sweep.statistics.axis import Axis
from coscrew_codegen.simulation.sweep.statistics.column import ColumnStatistics

_DRAWN = 12  # most recorded columns with a figure
_MAPS = 4  # most maps against varied quantities
_CAUSES = 5  # most joints of failed members that are named
_FIGURES = ("First: the distribution of each statistic over the members. Then: members by the "
            "final value and by each varied quantity, in the order given. Last: the mean of the "
            "final value over the first two.")
_SHARES = ("Over the members that reached the end of their runs. Shares: the part of the variance "
           "over the members that each varied quantity explains alone, by means over its grid or "
           "over parts of its range; rough for fewer than about 1000 samples.")


def text(totals: Aggregate) -> str:
    """The final values, for the terminal, and which members failed."""
    table = _recorded(totals)
    rows = tuple((row[0], *row[2:]) for row in table.rows if row[1] == STATISTICS[0])
    parts = [Table(("final", *table.headers[2:]), rows).text()] if rows else []
    return "\n\n".join((*parts, *((failures(totals),) if totals.failed else ())))


def failures(totals: Aggregate) -> str:
    """"12 of 1000 members failed: 10 at elbow, 2 at wrist"."""
    worst = sorted(totals.causes.items(), key=lambda x: (-x[1], x[0]))
    named = ", ".join(f"{count} at {joint or 'no joint'}" for joint, count in worst[:_CAUSES])
    more = ", …" if len(worst) > _CAUSES else ""
    return f"{totals.failed} of {totals.members} members failed: {named}{more}"


def html(specification: Specification, about: Mapping[str, str], totals: Aggregate, words: str
         ) -> str:
    """The text of the page."""
    failed = f", {totals.failed} of them failed" if totals.failed else ""
    source = {"command": words, "seed": str(specification.varied.seed), **about}
    return Page(f"A sweep of {specification.scene}", (
        f"{totals.members} members{failed}", *_varied(specification)), tuple(
            _chapters(specification, totals, words)), source.items()).html()


def _varied(specification: Specification) -> Iterator[str]:
    for x in specification.varied.each:
        unit = f" {x.of.unit}" if x.of.unit not in ("", "1") else ""
        yield (f"{x.of.name}: a grid of {len(x.values)} from {x.values[0]:g} to {x.values[-1]:g}"
               f"{unit}" if isinstance(x, Grid) else
               f"{x.of.name}: sampled from {x.low:g} to {x.high:g}{unit}"
               f"{', in logarithms' * x.log}")


def _chapters(specification: Specification, totals: Aggregate, words: str) -> Iterator[Chapter]:
    varying = [x for x in totals.columns if x.varies]
    drawn = _drawn(varying)
    lists = {"In the table alone": [x.own.name for x in varying if x not in drawn],
             "The same in all members, not drawn": [
                 x.own.name for x in totals.columns if x.count and not x.varies]}
    sentences = [_FIGURES] if drawn else []
    if drawn and totals.failed:
        sentences.append("Crosses mark where members failed.")
    sentences += [f"{what}: {', '.join(names)}." for what, names in lists.items() if names]
    if sentences:
        yield Chapter("Distributions and maps", tuple(sentences))
    for x in drawn:
        yield Chapter(x.own.name, figures=tuple(panels(x)))
    if any(x.count for x in totals.columns):
        yield Chapter("Recorded quantities", (_SHARES,), tables=(_recorded(totals),))
    if totals.failed:
        yield Chapter("Failed members", tuple(_lost(specification, totals, words)), tables=(Table(
            ("member", *(x.label for x in totals.axes), "at t, s", "cause"), tuple(
                (str(k), *map(str, values), f"{t:.9g}", str(cause))
                for k, *values, t, cause in totals.listed)),))


def _drawn(columns: list[ColumnStatistics]) -> list[ColumnStatistics]:
    """The columns with a figure, in the order recorded: the first of each quantity (q, torque,
    saturated, …), then the second of each, as long as there is room."""
    quantities = defaultdict(list)
    for x in columns:
        parts = x.own.name.split(".")
        quantities[parts[0] if parts[0] in QUANTITIES else parts[-1]].append(x.own.name)
    turns = [x for turn in zip_longest(*quantities.values()) for x in turn if x]
    return [x for x in columns if x.own.name in turns[:_DRAWN]]


def _recorded(totals: Aggregate) -> Table:
    """A row for each statistic of each recorded column."""
    rows = [(x.own.label, word, f"{x.lowest[k]:.5g}", f"{x.mean[k]:.5g}", f"{x.highest[k]:.5g}",
             *("" if np.isnan(share) else f"{100 * share:.0f} %"
               for share in (x.explained(i)[k] for i in range(len(x.axes)))))
            for x in totals.columns if x.count for k, word in enumerate(STATISTICS)]
    return Table(("recorded", "statistic", "lowest", "mean", "highest",
                  *(f"share of {x.name}" for x in totals.axes)), tuple(rows), texts=2)


def _lost(specification: Specification, totals: Aggregate, words: str) -> Iterator[str]:
    """Sentences on the members that failed."""
    yield f"{failures(totals)}."
    if totals.failed > len(totals.listed):
        yield f"The first {LISTED} are listed; column failed of the Parquet files has all."
    if specification.varied.ranges:
        yield f"The seed of the Sobol sequence is {specification.varied.seed}."
    yield (f"The first is run alone, with the same bits, by: {words} --member "
           f"{totals.listed[0][0]}")


def panels(column: ColumnStatistics) -> Iterator[plots.Panel]:
    """Draws a column: its distribution, members against the varied quantities in the order given,
    and its mean over the first two."""
    name = column.own.name
    yield plots.Panel(f"distribution of {name}", partial(_distribution, column=column))
    for i, axis in enumerate(column.axes[:_MAPS]):
        yield plots.Panel(f"{name} against {axis.name}", partial(_against, column=column, i=i))
    if pair := next(iter(column.pairs), None):
        yield plots.Panel(f"mean of {name} over {' and '.join(column.axes[i].name for i in pair)}",
                          partial(_means, column=column, pair=pair))


def _distribution(axes: Axes, column: ColumnStatistics) -> None:
    for counts, word in zip(column.histogram, STATISTICS, strict=True):
        first = word == STATISTICS[0]
        axes.stairs(counts, column.own.edges, label=word, fill=first, alpha=0.45 if first else 1)
    axes.set(xlabel=column.own.label, ylabel="members")
    axes.legend()


def _against(axes: Axes, column: ColumnStatistics, i: int) -> None:
    """Members by the final value and one axis; its share of the variance as title."""
    axis, share, counts = column.axes[i], column.explained(i)[0], column.joint[i]
    _map(axes, axis, column.own, np.where(counts > 0, counts, np.nan), "members")
    axes.set(ylabel=f"final {column.own.label}", title="" if np.isnan(share) else
             f"explains {100 * share:.0f} % of the variance")
    where = axis.middles[column.lost[i] > 0]
    axes.plot(where, [0.97] * len(where), "C8x", clip_on=False,
              transform=axes.get_xaxis_transform())


def _means(axes: Axes, column: ColumnStatistics, pair: tuple[int, int]) -> None:
    """The mean of the final value over two axes."""
    x, y = (column.axes[i] for i in pair)
    _map(axes, x, y, column.means(pair), f"mean of the final {column.own.label}")
    lost = np.nonzero(column.pairs[pair][2])
    axes.plot(x.middles[lost[0]], y.middles[lost[1]], "C8x", clip_on=False)


def _map(axes: Axes, x: Axis, y: Axis, values: np.ndarray, words: str) -> None:
    mesh = axes.pcolormesh(x.edges, y.edges, values.T, rasterized=True)
    axes.figure.colorbar(mesh, ax=axes, label=words)
    axes.grid(False)
    axes.set(xlabel=x.label, ylabel=y.label)
    for axis in (axes.xaxis,) * x.log + (axes.yaxis,) * y.log:
        plots.logarithmic(axis)
