"""Counts and sums over all members: the figures of the page and of the tables.

Memory does not grow with the number of members: a first pass over the files' statistics gives the
ranges, a second pass reads one chunk after the other."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pyarrow.parquet
from pyarrow import Table

from coscrew_codegen.simulation.sweep.files.part import read, read_metadata
from coscrew_codegen.simulation.sweep.member_summary import FAILED, MEMBER, STATISTICS
from coscrew_codegen.simulation.sweep.specification import Specification
from coscrew_codegen.simulation.sweep.statistics.axis import Axis, of_varied, parts_for
from coscrew_codegen.simulation.sweep.statistics.column import ColumnStatistics

LISTED = 100
"""Most failed members that are listed."""


@dataclass
class Aggregate:
    """Aggregate of a whole sweep."""

    members: int
    axes: tuple[Axis, ...]
    columns: tuple[ColumnStatistics, ...]
    failed: int = 0
    causes: dict[str, int] = field(default_factory=dict)  # members by the joint that failed
    listed: list[tuple[object, ...]] = field(default_factory=list)  # member, values, t, cause


def aggregate(specification: Specification, units: Mapping[str, str], files: Iterable[Path]
              ) -> Aggregate:
    """The counts of the members in these Parquet files, at least one."""
    paths = tuple(files)
    varied = specification.varied
    parts = parts_for(varied.members)
    axes = tuple(of_varied(x, min(parts, parts_for(varied.samples)) if varied.ranges else parts)
                 for x in varied.each)
    ranges = _ranges(tuple(units), paths)
    totals = Aggregate(0, axes, tuple(ColumnStatistics(Axis(name, unit, *ranges[name], parts), axes)
                                      for name, unit in units.items()))
    for path in paths:
        _add(totals, read(path))
    return totals


def _ranges(names: tuple[str, ...], files: Iterable[Path]) -> dict[str, tuple[float, float]]:
    """Smallest minimum and largest maximum of each recorded column, from the files' statistics."""
    result = dict.fromkeys(names, (np.inf, -np.inf))
    for path in files:
        meta = read_metadata(path)
        for group in range(meta.num_row_groups):
            for name, x in _statistics(meta.row_group(group)):
                column, _, word = name.rpartition(".")
                if column in result and word in STATISTICS:
                    low, high = result[column]
                    result[column] = min(low, float(x.min)), max(high, float(x.max))
    return {name: ends if np.isfinite(ends).all() else (0.0, 0.0) for name, ends in result.items()}


def _statistics(group: pyarrow.parquet.RowGroupMetaData
                ) -> Iterator[tuple[str, pyarrow.parquet.Statistics]]:
    for i in range(group.num_columns):
        column = group.column(i)
        if column.is_stats_set and column.statistics.has_min_max:
            yield column.path_in_schema, column.statistics


def _add(totals: Aggregate, table: Table) -> None:
    places = [x.index(table[x.name].to_numpy()) for x in totals.axes]
    for column in totals.columns:
        column.add(np.array([table[f"{column.own.name}.{word}"].to_numpy().astype(float)
                             for word in STATISTICS]), places)
    totals.members += len(table)
    causes = table[FAILED].to_pylist()
    for k, cause in enumerate(causes):
        if cause is not None:
            joint = table[f"{FAILED}.joint"][k].as_py()
            totals.failed += 1
            totals.causes[joint] = totals.causes.get(joint, 0) + 1
            if len(totals.listed) < LISTED:
                names = (MEMBER, *(x.name for x in totals.axes), f"{FAILED}.t", FAILED)
                totals.listed.append(tuple(table[name][k].as_py() for name in names))
