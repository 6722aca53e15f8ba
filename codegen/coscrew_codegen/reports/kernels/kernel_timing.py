"""Times of every kernel: the compiled loops, and Python calls on one, 1000 and 1e6 elements."""

import importlib
import timeit
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.reports.kernels import inputs
from coscrew_codegen.reports.kernels.c_text import Variant
from coscrew_codegen.reports.kernels.kernel_library import KernelLibrary
from coscrew_codegen.reports.timing.buffers import aligned
from coscrew_codegen.reports.timing.intervals import FEWEST
from coscrew_codegen.reports.timing.loop_timing import Timing, timed_calls

LAYOUTS = {"rows": "array of structs", "planes": "structure of arrays", "chain": "latency"}
COUNTS = (1, 1000, 1_000_000)
_TEMPORARIES = 8  # memory for temporaries of a pure-NumPy call, in sizes of its arguments


@dataclass(frozen=True)
class Timed:
    """A variant's times, in ns per element, in the rounds of its contest: all tiers of one
    operation and precision, in the same language, compiler and layout."""

    variant: Variant
    language: str
    compiler: str | None
    layout: str
    timing: Timing


def contests(variants: Sequence[Variant]) -> list[list[Variant]]:
    """The groups of variants that are timed in turn: all tiers of an operation in a precision."""
    results: dict[tuple[str, str], list[Variant]] = {}
    for v in variants:
        results.setdefault((v.operation.name, v.precision.name), []).append(v)
    return list(results.values())


def compiled(library: KernelLibrary, variants: Sequence[Variant], seed: int,
             seconds: float) -> Iterator[list[Timed]]:
    """Each contest in each layout, all in about `seconds`."""
    end, done = timeit.default_timer() + seconds, 0
    for rivals in contests(variants):
        given = [_arguments(v, v.elements, seed) for v in rivals]
        left = end - timeit.default_timer()
        ns = 1e9 * left * len(rivals) / (len(variants) - done) / len(LAYOUTS)
        for loop, layout in LAYOUTS.items():
            timings = library.times(rivals, loop, given, ns)
            yield [Timed(v, "C", library.compiler.name, layout, timing)
                   for v, timing in zip(rivals, timings, strict=True)]
        done += len(rivals)


def python_function(variant: Variant) -> Callable[..., object] | None:
    """The package's function for the variant, if it has one, that takes all matrices."""
    package = tier_named(variant.tier).package
    try:
        result = getattr(importlib.import_module(package), variant.operation.name, None)
    except ModuleNotFoundError:
        return None
    return result and importlib.import_module("coscrew").unchecked(result)


def in_python(variants: Sequence[Variant], count: int, seed: int,
              seconds: float) -> Iterator[list[Timed]]:
    """Each contest on `count` elements, all in about `seconds`, without variants that take too much
    memory or an eighth of the time.  Contests that don't fit in the time are left out."""
    end, done = timeit.default_timer() + seconds, 0
    for rivals in contests(variants):
        left = end - timeit.default_timer()
        if left <= 0:
            return
        share = left * len(rivals) / (len(variants) - done)
        done += len(rivals)
        most = seconds / 8 if count == COUNTS[-1] else share / len(rivals)
        calls = {v: call for v in rivals if (call := _call(v, count, seed, most))}
        with np.errstate(all="ignore"):
            timings = timed_calls(list(calls.values()), 1e9 * share) if calls else []
        yield [Timed(v, "Python", None, f"N = {count}", Timing(timing.rounds / count))
               for v, timing in zip(calls, timings, strict=True)]


def _call(variant: Variant, count: int, seed: int, seconds: float) -> Callable[[], object] | None:
    """A call of the variant's function on arrays that start at cache lines; NumPy allocates the
    results.  None if FEWEST calls would take more than `seconds`, and more than a millisecond."""
    function = python_function(variant)
    if function is None:
        return None
    some = _arguments(variant, min(count, 1000), seed)
    with np.errstate(all="ignore"):
        each = min(timeit.repeat(lambda: function(*some), number=1, repeat=2)) / len(some[0])
    if not _fits(variant, count, function) or FEWEST * each * count > max(seconds, 1e-3):
        return None
    arguments = [aligned(np.resize(x, (count, *x.shape[1:]))) if count > 1 else x[0] for x in some]
    return lambda: function(*arguments)


def _arguments(variant: Variant, count: int, seed: int) -> tuple[np.ndarray, ...]:
    rows = inputs.benign(variant.operation, variant.precision, count, seed)
    return inputs.split(variant.operation, rows)


def _fits(variant: Variant, count: int, function: Callable[..., object]) -> bool:
    """Returns whether a call needs less than half of the available memory."""
    arguments = (*variant.operation.inputs, *variant.operation.outputs)
    needed = count * sum(a.quantity.size for a in arguments) * variant.precision.bytes
    return needed * (1 if isinstance(function, np.ufunc) else 1 + _TEMPORARIES) < _free() / 2


def _free() -> int:
    """Available memory in bytes; a gigabyte if the system does not report it."""
    messages = Path("/proc/meminfo")
    for line in messages.read_text().splitlines() if messages.exists() else ():
        if line.startswith("MemAvailable:"):
            return int(line.split()[1]) * 1024
    return 2**30
