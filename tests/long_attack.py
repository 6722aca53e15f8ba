"""Tests the proven bounds at length: a million outputs per operation, precision and tier.

`python -m tests.long_attack [--outputs N] [--operation NAME …] [--seed N] [--processes N]`, or
`make attack`, tries the hard cases, random rows, rows in which a result nearly cancels, and rows
next to those with the largest errors so far, and prints how close errors come to their bounds.

The test is rigorous.  For each row all tiers share one truth, enclosed within a proved radius
(wide.py), and S from the same polynomial. |result - truth| + radius is compared with the bound,
each rounded to the unsafe side by more than the errors of this arithmetic. Rows for which it is not
smaller, and the worst row of each batch, are judged by exact rationals of the formula (judge.py).
The enclosed value is that of the plain program; other tests show symbolically that this is
identically the formula.
"""

import argparse
import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from importlib import import_module
from multiprocessing import get_context

import numpy as np
from tabulate import tabulate
from tqdm import tqdm

from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.algebra.exact import CONDITION, UNIT
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program import Program
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.hard_cases.corpus import load
from tests.search import joined, split, varied
from tests.support.compiled.implementations import gufuncs
from tests.support.truth.attack import (
    TIERED,
    Implementation,
    Row,
    Worst,
    bounds,
    compare,
    extreme_rows,
    plain_program,
)
from tests.support.truth.judge import ratio
from tests.support.truth.wide import IS_WIDE, WIDE, Enclosed, enclosed, linear

BATCH = 12_000  # rows
PARENTS = 8  # rows of each tier with the largest errors, which are varied
# Sizes of components: 2^±spread, varied ones half as far again.
SPREAD = {"double": 40, "single": 8}
UNSAFE = WIDE(1 - 2.0**-40)

Ways = dict[str, Implementation]


@dataclass
class Attacked:
    """The largest errors of one tier, and the rows from which to continue."""

    worst: Worst = field(default_factory=Worst)
    violations: int = 0
    parents: np.ndarray = field(default_factory=lambda: np.empty((0, 0)))
    ratios: np.ndarray = field(default_factory=lambda: np.empty(0))


def attack_at_length(operation: Operation, precision: Precision, ways: Ways, outputs: int,
                     seed: int, cases: np.ndarray | None = None) -> dict[str, Attacked]:
    """Every tier's errors on at least this many outputs, and on the cases."""
    rng = np.random.default_rng([seed, *operation.name.encode(), precision.bytes])
    values = {tier: Attacked() for tier in ways}
    if cases is not None and len(cases):
        for tier, way in ways.items():
            results = joined(way(operation, precision, split(operation, cases)))
            for row, got in zip(cases.tolist(), results.tolist(), strict=True):
                _judge(operation, precision, tier, row, got, values[tier])
    components = sum(a.quantity.size for a in operation.outputs)
    while min(f.worst.outputs for f in values.values()) < outputs:
        size = min(BATCH, max(64, outputs // components))
        rows = _rows(operation, precision, size, rng, list(values.values()))
        truth = enclosed(plain_program(operation), precision, rows)
        for tier, way in ways.items():
            _attack(operation, precision, tier, way, rows, truth, values[tier])
        if "certified" in ways:
            extreme = joined(
                extreme_rows(operation, precision, size // 8, int(rng.integers(2**30))))
            extreme = extreme[np.isfinite(extreme).all(axis=1)]
            _attack(operation, precision, "certified", ways["certified"], extreme,
                    enclosed(plain_program(operation), precision, extreme), values["certified"],
                    climbing=False)
    return values


def _attack(operation: Operation, precision: Precision, tier: str, way: Implementation,
            rows: np.ndarray, truth: Enclosed, into: Attacked, climbing: bool = True) -> None:
    """One batch: compared with the enclosure, and where that does not decide, exactly."""
    results = joined(way(operation, precision, split(operation, rows)))
    with np.errstate(all="ignore"):
        ratios = _ratios(operation, precision, tier, results, truth)
        ulps = _ulps(precision, results, truth)
    into.worst.outputs += int(np.isfinite(results[:, :ratios.shape[1]]).sum())
    largest = ratios.max(axis=1)
    doubtful = set(np.flatnonzero(~(largest <= 1)).tolist())
    for place in sorted(doubtful | {int(np.argmax(largest)), int(np.argmax(ulps))}):
        _judge(operation, precision, tier, rows[place].tolist(), results[place].tolist(), into, 0)
    if climbing:
        pool = np.vstack([into.parents.reshape(-1, rows.shape[1]), rows])
        marks = np.concatenate([into.ratios, largest])
        best = np.argsort(-marks, kind="stable")[:PARENTS]
        into.parents, into.ratios = pool[best], marks[best]


def _judge(operation: Operation, precision: Precision, tier: str, row: list[float],
           got: list[float], into: Attacked, counted: int = 1) -> None:
    """The exact comparison; overflow and underflow as in judge.py."""
    exact = ratio(operation, precision, tier, row, got)
    into.violations += exact > 1
    into.worst.outputs += counted * (len(got) // (2 if tier == "certified" else 1))
    if exact > into.worst.ratio:
        into.worst.ratio, into.worst.witness = exact, tuple(x.hex() for x in row)
    if tier != "certified" and exact <= 1 and np.isfinite(got).all():
        own = Worst()
        compare(precision, tier, Row(operation, row), got, own)
        if own.ulps > into.worst.ulps and own.ratio <= 1:
            into.worst.ulps, into.worst.ulps_witness = own.ulps, own.ulps_witness


def _ratios(operation: Operation, precision: Precision, tier: str, results: np.ndarray,
            truth: Enclosed) -> np.ndarray:
    """The largest ratio of an error to its bound.  A certified bound that is not finite makes no
    statement; a bound of zero holds for an error of zero."""
    if tier == "certified":
        half = results.shape[1] // 2
        claimed = np.isfinite(results[:, half:])
        return _quotient(np.where(claimed, truth.farthest(results[:, :half]), 0),
                         results[:, half:].astype(WIDE))
    u = WIDE(float(UNIT[precision.name]))
    emitted = bounds(operation, precision, tier)
    rounded, c1, c2 = (np.array([float(x) for x in column], WIDE)
                       for column in zip(*((b.rounded, b.c1, b.c2) for b in emitted), strict=True))
    allowed = u * np.abs(results.astype(WIDE)) * rounded + (c1 * u + c2 * u * u) * truth.terms
    return _quotient(truth.farthest(results), allowed * UNSAFE)


def _quotient(error: np.ndarray, allowed: np.ndarray) -> np.ndarray:
    return np.where(error == 0, WIDE(0), error / allowed)


def _ulps(precision: Precision, results: np.ndarray, truth: Enclosed) -> np.ndarray:
    """About the largest error of each row in ulp, of results whose condition is below CONDITION."""
    x = np.abs(truth.hi)
    spacing = np.spacing(x.astype(precision.numpy_type)).astype(WIDE)
    well = truth.terms < WIDE(float(CONDITION[precision.name])) * x
    return np.where(well, truth.farthest(results[:, :x.shape[1]]) / spacing, 0).max(axis=1)


# rows


def _rows(operation: Operation, precision: Precision, count: int, rng: np.random.Generator,
          results: list[Attacked]) -> np.ndarray:
    """Rows: a third ordinary or of very different sizes, a third nearly cancelling, a third varied.
    """
    dtype, spread = np.dtype(precision.numpy_type), SPREAD[precision.name]
    size = sum(a.quantity.size for a in operation.inputs)
    rows = rng.normal(size=(count, size))
    sizes = rng.uniform(-1, 1, rows.shape) * spread * (rng.random((count, 1)) < 0.7)
    rows = (rows * np.exp2(sizes)).astype(dtype)
    third = count // 3
    _cancel(plain_program(operation), rows[:third], rng)
    if len(parents := np.vstack([f.parents for f in results if len(f.parents)] or [rows[:0]])):
        children = varied(parents.astype(float), third, rng, dtype).astype(dtype)
        with np.errstate(all="ignore"):
            far = np.abs(np.log2(np.abs(children))) > 1.5 * spread
        rows[third:2 * third] = np.where(far & (children != 0), rows[third:2 * third], children)
    return rows


def _cancel(program: Program, rows: np.ndarray, rng: np.random.Generator) -> None:
    """Change one input so that a result that is linear in it nearly vanishes, at most as far as the
    input's last bits allow."""
    for part in np.array_split(np.arange(len(rows)), 24):
        component = int(rng.integers(len(program.results)))
        for place in rng.permutation(rows.shape[1])[:8].tolist():
            p, q = linear(program, component, place, rows[part])
            with np.errstate(all="ignore"):
                root = -p / q
                good = (np.abs(root) < 2.0**60) & (np.abs(root) > 2.0**-60)
            if good.any():
                off = 1 + np.exp2(-rng.integers(1, 64, len(part)).astype(WIDE))
                rows[part, place] = np.where(good, root * off, rows[part, place])
                break


# the command


_ways: Ways = {}
_cases: dict[tuple[str, str], np.ndarray] = {}


def _run(task: tuple[int, int, int, int]) -> list[tuple]:
    """The table's lines of one operation and precision, by their numbers."""
    number, which, outputs, seed = task
    operation, precision = TIERED[number], PRECISIONS[which]
    result = attack_at_length(operation, precision, _ways, outputs, seed,
                              _cases.get((operation.name, precision.name)))
    return [(operation.name, precision.name, tier, f.worst.outputs, f.worst.ratio, f.worst.ulps,
             f.violations) for tier, f in result.items()]


def lines(tasks: list[tuple[int, int, int, int]], processes: int) -> Iterator[tuple]:
    """The table, operation by operation."""
    with get_context("fork").Pool(processes) as pool:
        for some in tqdm(pool.imap(_run, tasks), total=len(tasks), disable=None):
            yield from some


def main() -> None:
    """Print the table and its conclusion."""
    names = [op.name for op in TIERED]
    parser = argparse.ArgumentParser(description="Attack the proven error bounds at length.")
    parser.add_argument("--outputs", type=int, default=1_000_000,
                        help="at least, per operation, precision and tier")
    parser.add_argument("--operation", nargs="+", default=names, choices=names, metavar="NAME")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=os.cpu_count())
    options = parser.parse_args()
    if not IS_WIDE:
        parser.error("needs a long double of 64 bits (x86); here it has other ones")
    for case in load():
        key = case.operation.name, case.precision.name
        row = np.array([case.inputs], case.precision.numpy_type)
        _cases[key] = np.concatenate([_cases[key], row]) if key in _cases else row
    tasks = [(names.index(name), which, options.outputs, options.seed)
             for name in options.operation for which in range(len(PRECISIONS))]
    _ways.update(_implementations())
    table = list(lines(tasks, options.processes))
    print(tabulate(table, ("operation", "precision", "tier", "outputs", "error / bound",
                           "ulps, well conditioned", "violations"), floatfmt=".3f"))
    print(_summary(table))


def _implementations() -> Ways:
    """The kernels as users call them: gufuncs."""
    return {tier.name: gufuncs(import_module(tier.package)) for tier in TIERS}


def _summary(table: list[tuple]) -> str:
    """Outputs, violations, the largest ratio of each tier, the smallest among plain's."""
    tiers = dict.fromkeys(line[2] for line in table)
    worst = ", ".join(f"{tier} {max(x[4] for x in table if x[2] == tier):.3f}" for tier in tiers)
    ulps = ", ".join(f"{p.name} {max(results):.3f}" for p in PRECISIONS if (
        results := [x[5] for x in table if x[1:3] == (p.name, "accurate")]))
    tightest = min(x[4] for x in table if x[2] == "plain")
    return (f"{sum(x[3] for x in table)} outputs, {sum(x[6] for x in table)} violations\n"
            f"worst error / bound: {worst}; the least of plain's {tightest:.3f}\n"
            f"accurate, well conditioned, ulps: {ulps}")


if __name__ == "__main__":
    main()
