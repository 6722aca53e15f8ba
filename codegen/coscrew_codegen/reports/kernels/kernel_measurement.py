"""Measures operations: exact errors, times in C and Python, drift → Report."""

import os
import signal
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np
import sympy as sp
from tqdm import tqdm

from coscrew_codegen.algebra.exact import formula, is_polynomial
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.algebra.special_values import SPECIAL
from coscrew_codegen.program.flops import flops_of
from coscrew_codegen.program.program import in_words
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.whole_cost import whole_counts
from coscrew_codegen.reports.kernels import kernel_errors, kernel_timing
from coscrew_codegen.reports.kernels.c_text import Variant
from coscrew_codegen.reports.kernels.drift import drifts
from coscrew_codegen.reports.kernels.inputs import Corpus
from coscrew_codegen.reports.kernels.kernel_errors import Arrays, KernelAccuracy
from coscrew_codegen.reports.kernels.kernel_library import KernelLibrary, compilers, libraries
from coscrew_codegen.reports.kernels.kernel_timing import COUNTS, Timed
from coscrew_codegen.reports.kernels.measurement_provenance import provenance
from coscrew_codegen.reports.kernels.ranking import Key, times
from coscrew_codegen.reports.kernels.report_json import (
    SCHEMA,
    DriftErrors,
    Report,
    ReportEntry,
    Time,
)
from coscrew_codegen.reports.kernels.variants import variants_of

# The most informative operations: measured first if time is short, and printed.
SHOWN = ("product_CoAdc", "product_CoAdinvc", "product_Ads", "cross_sc", "cross_ss", "dot_cs",
           "product_dd", "product_dv", "screw_normalized")

# Shares of the time that remains after compiling and measuring errors, at least a quarter of the
# whole: loops in C, and Python calls with one, 1000 and 1e6 elements.
_LEAST_LEFT = 0.25
_C_SHARE = 0.5
_PYTHON_SHARES = (0.1, 0.15, 0.25)

# The number of rows for errors depends on the given minutes, not on the machine's speed, so that
# every machine draws the same: this many per minute for operations of `_row_cost` 1.
_ROW_BUDGET = 450_000.0
_FEWEST_ROWS, _MOST_ROWS = 60, 20_000

Item = TypeVar("Item")


@dataclass(frozen=True)
class MeasurementPlan:
    """Settings of a measurement: operations, durations, seed, command line."""

    operations: tuple[Operation, ...]
    minutes: float
    seed: int
    corpus: Corpus
    command: str


@dataclass(frozen=True)
class Task:
    """Errors of one operation in one precision and all tiers.  Holds the operation's name, since
    formulas cannot be sent to another process."""

    operation: str
    precision: Precision
    rows: int
    seed: int
    corpus: tuple[tuple[float, ...], ...]
    library: KernelLibrary | None

    def run(self) -> dict[Key, KernelAccuracy]:
        """The accuracy of each variant that can be called."""
        operation = next(op for op in OPERATIONS if op.name == self.operation)
        benign, hard = kernel_errors.samples(operation, self.precision, self.rows, self.seed,
                                             self.corpus)
        evaluate = self.library.call if self.library else _called_in_python
        return {_key(v): kernel_errors.accuracy(operation, v, benign, hard, evaluate)
                for v in variants_of(operation, self.precision)
                if self.library or kernel_timing.python_function(v)}


def measure(plan: MeasurementPlan) -> Report:
    """The report, without a comparison; of Python only, if there is no compiler."""
    started = time.monotonic()
    variants = [v for operation in _progress(plan.operations, "deriving", len(plan.operations))
                for precision in PRECISIONS for v in variants_of(operation, precision)]
    with tempfile.TemporaryDirectory(prefix="coscrew-") as name:
        ccs = compilers(Path(name))
        if not ccs:
            print("coscrew: no C compiler works here; only Python is measured", file=sys.stderr)
        built = tuple(_progress(libraries(variants, ccs, Path(name)), "compiling", len(ccs)))
        accuracies = _accuracies(plan, built[0] if built else None)
        left = max(60 * plan.minutes - (time.monotonic() - started),
                   60 * plan.minutes * _LEAST_LEFT)
        timed = [*_timed_in_c(variants, built, plan.seed, left * _C_SHARE),
                 *_timed_in_python(variants, plan.seed, left)]
        drift: tuple[DriftErrors, ...] = tuple(
            _progress(drifts(built[0]), "drift", 2 * len(PRECISIONS))) if built else ()
    worst = {k: a.hard.worst for k, a in accuracies.items() if a.hard}
    ranked = times(timed, worst)
    entries = tuple(_entry(v, accuracies[_key(v)], ranked.get(_key(v), ()))
                    for v in variants if _key(v) in accuracies)
    seconds = round(time.monotonic() - started, 1)
    return Report(SCHEMA, provenance(plan.command, plan.seed, ccs, seconds), entries, drift, None)


def tasks(plan: MeasurementPlan, library: KernelLibrary | None) -> list[Task]:
    """A task for each operation and precision, with equal shares of the budget of rows."""
    share = _ROW_BUDGET * plan.minutes / len(plan.operations) / len(PRECISIONS)
    return [Task(operation.name, precision,
                 int(min(max(share / _row_cost(operation), _FEWEST_ROWS), _MOST_ROWS)), plan.seed,
                 plan.corpus.get((operation.name, precision.name), ()), library)
            for operation in plan.operations for precision in PRECISIONS]


def _row_cost(operation: Operation) -> float:
    """Estimated cost of a row's exact results, in components of polynomials."""
    components = formula(operation)
    if is_polynomial(operation):
        return max(len(components), 3)
    bindings, values = sp.cse(components)
    expressions = (*(x for _, x in bindings), *values)
    special = sum(f.func.__name__ in SPECIAL for x in expressions for f in x.atoms(sp.Function))
    return float(len(components) + 0.25 * sum(map(sp.count_ops, expressions)) + 40 * special)


def _accuracies(plan: MeasurementPlan, library: KernelLibrary | None) -> dict[Key, KernelAccuracy]:
    todo = tasks(plan, library)
    results: dict[Key, KernelAccuracy] = {}
    with ProcessPoolExecutor(os.cpu_count(), initializer=_ignore_interrupts) as pool:
        for accuracies in _progress(pool.map(Task.run, todo), "errors", len(todo)):
            results |= accuracies
    return results


def _ignore_interrupts() -> None:
    """Ignore Ctrl-C, which reaches all processes: the main one ends the others."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _timed_in_c(variants: list[Variant], built: tuple[KernelLibrary, ...], seed: int,
                seconds: float) -> Iterator[list[Timed]]:
    for library in built:
        yield from _progress(kernel_timing.compiled(library, variants, seed, seconds / len(built)),
                             f"times, {library.compiler.name}",
                             len(kernel_timing.contests(variants)) * len(kernel_timing.LAYOUTS))


def _timed_in_python(variants: list[Variant], seed: int,
                     seconds: float) -> Iterator[list[Timed]]:
    callable_ = [v for v in variants if kernel_timing.python_function(v)]
    shown = sorted(callable_, key=lambda v: v.operation.name not in SHOWN)
    for count, share in zip(COUNTS, _PYTHON_SHARES, strict=True):
        result = kernel_timing.in_python(shown, count, seed, share * seconds)
        yield from _progress(result, f"times, Python, N = {count}",
                             len(kernel_timing.contests(shown)))


def _called_in_python(variant: Variant, arguments: Arrays) -> Arrays:
    function = kernel_timing.python_function(variant)
    if function is None:
        raise ValueError(f"Python has no {variant.operation.name} of the {variant.tier} tier")
    with np.errstate(all="ignore"):
        result = function(*arguments)
    return result if isinstance(result, tuple) else (result,)


def _entry(variant: Variant, accuracy: KernelAccuracy, its_times: tuple[Time, ...]) -> ReportEntry:
    operation, counts = variant.operation, whole_counts(variant.program, variant.precision)
    return ReportEntry(operation.name, operation.family, operation.statement,
                       variant.precision.name,
                       variant.tier, "u" if operation.normwise else "ulp", accuracy.benign,
                       accuracy.hard, accuracy.bound, accuracy.condition, flops_of(counts),
                       in_words(counts), its_times)


def _key(variant: Variant) -> Key:
    return variant.operation.name, variant.precision.name, variant.tier


def _progress(items: Iterable[Item], what: str, total: int) -> Iterator[Item]:
    """The items, with a progress bar on standard error if that is a terminal."""
    yield from tqdm(items, what, total, leave=False, disable=None, file=sys.stderr)
