"""Judges the elementary functions of one argument on every single-precision number.

`python -m tests.every_single [--stride N] [--processes N]`, or `make attack`, compares the emitted
C with the C library's functions in long double (every_single.c), in about 20 processor minutes for
all 2^32 arguments, and holds the largest errors against what is stated of them.
"""

import argparse
import os
import tempfile
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from tabulate import tabulate
from tqdm import tqdm

from coscrew_codegen.elementary import ELEMENTARY
from coscrew_codegen.formats import SINGLE
from tests.support.compiled.c_harness import C11, COMPILERS, INCLUDE, run

SOURCE = Path(__file__).with_suffix(".c")
END, PARTS = 2**31, 64  # of the arguments' bits; tasks
STATED = {name: function.error(SINGLE) for function in ELEMENTARY
          for name in ((("sin", "cos")) if function.name == "sincos" else (function.name,))}


@dataclass(frozen=True)
class Judged:
    """The largest errors of a function and where they are; strange: wrong special values."""

    name: str
    error: float  # of normal results, in ulps of the true value
    where: str
    small: float  # of smaller ones, in the least subnormal number
    small_where: str
    wrong: int
    strange: str

    @property
    def holds(self) -> bool:
        """Small results are rounded once more: they have half a unit beside half the error."""
        stated = STATED[self.name]
        return (self.error <= stated and self.small <= Fraction(1, 2) + stated / 2
                and not self.wrong)


def program(folder: Path, *include: Path) -> Path:
    """The judge, compiled; headers are looked for in `include` first."""
    binary = folder / "every_single"
    run((COMPILERS[0], *C11, "-O2", *(f"-I{path}" for path in (*include, INCLUDE)), SOURCE, "-o",
         binary, "-lm"))
    return binary


def judged(binary: Path, stride: int, processes: int = 2, quiet: bool = True) -> list[Judged]:
    """Every function on every stride-th argument."""
    def part(number: int) -> list[Judged]:
        first, last = (END * n // PARTS for n in (number, number + 1))
        first += -first % stride
        return [_read(line) for line in run((binary, str(first), str(last), str(stride))
                                            ).splitlines()]

    with ThreadPoolExecutor(processes) as pool:
        found = list(tqdm(pool.map(part, range(PARTS)), total=PARTS, disable=quiet or None))
    return [_together(some) for some in zip(*found, strict=True)]


def _read(line: str) -> Judged:
    name, error, where, small, small_where, wrong, strange = line.split()
    return Judged(name, float(error), where, float(small), small_where, int(wrong), strange)


def _together(some: Iterable[Judged]) -> Judged:
    parts = list(some)
    worst = max(parts, key=lambda x: x.error)
    small = max(parts, key=lambda x: x.small)
    strange = max(parts, key=lambda x: x.wrong)
    return Judged(worst.name, worst.error, worst.where, small.small, small.small_where,
                  sum(x.wrong for x in parts), strange.strange)


def main() -> None:
    """Print the table; exit with 1 if a statement does not hold."""
    parser = argparse.ArgumentParser(description="Judge elementary functions in single precision.")
    parser.add_argument("--stride", type=int, default=1, help="take every N-th argument only")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        found = judged(program(Path(folder)), options.stride, options.processes, quiet=False)
    print(tabulate([(x.name, x.error, x.where, float(STATED[x.name]), x.small, x.small_where,
                     x.wrong) for x in found],
                   ("function", "ulps", "at", "stated", "subnormal", "at", "wrong"),
                   floatfmt=".4f"))
    raise SystemExit(not all(x.holds for x in found))


if __name__ == "__main__":
    main()
