"""Times of every kernel: the compiled loops, and Python calls on one, 1000 and 1e6 elements."""

import importlib
import timeit
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from coscrew_codegen.report import inputs
from coscrew_codegen.report.c_text import Variant
from coscrew_codegen.report.native import Library
from coscrew_codegen.report.schema import Time

LAYOUTS = {"rows": "array of structs", "planes": "structure of arrays", "chain": "latency"}
COUNTS = (1, 1000, 1_000_000)
_TEMPORARIES = 8  # times the size of its arguments: what a call in pure NumPy may take besides


@dataclass(frozen=True)
class Timed:
    """The shortest and the median time of a variant, in ns per element."""

    variant: Variant
    language: str
    compiler: str | None
    layout: str
    minimum: float
    median: float

    def time(self, ratio: float | None, dominated: bool) -> Time:
        """As the report states it."""
        return Time(self.language, self.compiler, self.layout, self.minimum,
                    self.median / self.minimum - 1, ratio, dominated)


def compiled(library: Library, variants: Sequence[Variant], seed: int,
             seconds: float) -> Iterator[Timed]:
    """Each variant in each layout, all in about `seconds`."""
    end = timeit.default_timer() + seconds
    for number, variant in enumerate(variants):
        left = end - timeit.default_timer()
        share = 1e9 * left / (len(variants) - number) / len(LAYOUTS)
        arguments = _arguments(variant, variant.elements, seed)
        for loop, layout in LAYOUTS.items():
            minimum, median = library.time(variant, loop, arguments, share)
            yield Timed(variant, "C", library.compiler.name, layout, minimum, median)


def python_function(variant: Variant) -> Callable[..., object] | None:
    """The package's function for the variant, if it has one."""
    name = "coscrew" if variant.tier == "plain" else f"coscrew.{variant.tier}"
    try:
        return getattr(importlib.import_module(name), variant.operation.name, None)
    except ModuleNotFoundError:
        return None


def in_python(variants: Sequence[Variant], count: int, seed: int,
              seconds: float) -> Iterator[Timed | None]:
    """Each variant on `count` elements, all in about `seconds`; None for one that takes too much
    memory, or an eighth of the time.  When the time is up, the others are left out."""
    end = timeit.default_timer() + seconds
    for number, variant in enumerate(variants):
        left = end - timeit.default_timer()
        if left <= 0:
            return
        share = left / (len(variants) - number)
        yield _timed(variant, count, seed, seconds / 8 if count == COUNTS[-1] else share)


def _timed(variant: Variant, count: int, seed: int, seconds: float) -> Timed | None:
    """The variant's function called for about `seconds`, at least three times."""
    function = python_function(variant)
    some = _arguments(variant, min(count, 1000), seed)
    with np.errstate(all="ignore"):
        each = min(timeit.repeat(lambda: function(*some), number=1, repeat=2)) / len(some[0])
        if not _fits(variant, count, function) or 3 * each * count > max(seconds, 1e-3):
            return None
        arguments = [np.resize(x, (count, *x.shape[1:])) if count > 1 else x[0] for x in some]
        timer = timeit.Timer(lambda: function(*arguments))
        once = min(timer.repeat(number=1, repeat=3 if count < COUNTS[-1] else 1))
        number = max(1, min(int(50e-6 / once), 1000))
        repeats = 3 if count == COUNTS[-1] else int(min(max(seconds / (once * number), 3), 1000))
        samples = [t / number / count * 1e9 for t in timer.repeat(number=number, repeat=repeats)]
    return Timed(variant, "Python", None, f"N = {count}", min(samples), float(np.median(samples)))


def _arguments(variant: Variant, count: int, seed: int) -> tuple[np.ndarray, ...]:
    rows = inputs.benign(variant.operation, variant.precision, count, seed)
    return inputs.split(variant.operation, rows)


def _fits(variant: Variant, count: int, function: Callable[..., object]) -> bool:
    """Whether a call takes less than half of the memory that is free."""
    arguments = (*variant.operation.inputs, *variant.operation.outputs)
    needed = count * sum(a.quantity.size for a in arguments) * variant.precision.bytes
    return needed * (1 if isinstance(function, np.ufunc) else 1 + _TEMPORARIES) < _free() / 2


def _free() -> int:
    """Bytes of memory available; a gigabyte where the system does not tell."""
    told = Path("/proc/meminfo")
    for line in told.read_text().splitlines() if told.exists() else ():
        if line.startswith("MemAvailable:"):
            return int(line.split()[1]) * 1024
    return 2**30
