"""Judges the elementary functions of one argument: on every number of single precision, on many of
double precision.

`python -m tests.elementary_attack [--stride N] [--doubles N] [--processes N]`, or `make attack`,
compares the emitted C with the C library's functions in long double (elementary_attack.c) and holds
the largest errors against what is stated of them.  All 2^32 single-precision arguments take some 25
processor minutes.
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

from coscrew_codegen.program.elementary import ELEMENTARY
from coscrew_codegen.program.values.formats import PRECISIONS, SINGLE, Precision
from tests.support.compiled.c_harness import C11, COMPILERS, INCLUDE, run
from tests.support.truth.wide import IS_WIDE

SOURCE = Path(__file__).with_suffix(".c")
SINGLES = 2**31  # from 0 to NaN, and as many below 0
PARTS = 64
JUDGES = {"double": Fraction(1, 1000), "single": Fraction(0)}
"""The error of long double, in ulps of the precision: 2^-11, and less than what is printed."""
OF = {"sin": "sincos", "cos": "sincos"}  # functions that are computed together
FUNCTIONS = {function.name: function for function in ELEMENTARY}


@dataclass(frozen=True)
class Judged:
    """The largest errors of a function, and where they are."""

    precision: Precision
    name: str
    error: float  # of normal results, in ulps of the true value
    where: str
    small: float  # of smaller ones, in the least subnormal number
    small_where: str
    wrong: int  # special values and signs
    strange: str

    @property
    def stated(self) -> Fraction:
        return FUNCTIONS[OF.get(self.name, self.name)].error(self.precision)

    @property
    def holds(self) -> bool:
        """Smaller results are rounded once more: half a unit beside half the error."""
        bound = self.stated + JUDGES[self.precision.name]
        return self.error <= bound and self.small <= (1 + bound) / 2 and not self.wrong


def program(precision: Precision, folder: Path, *include: Path) -> Path:
    """The judge, compiled; headers are looked for in `include` first."""
    binary = folder / f"judge_{precision.name}"
    kind = ("-DSINGLE",) if precision is SINGLE else ()
    run((COMPILERS[0], *C11, "-O2", *kind, *(f"-I{path}" for path in (*include, INCLUDE)), SOURCE,
         "-o", binary, "-lm"))
    return binary


def judged(precision: Precision, binary: Path, arguments: int, stride: int = 1, processes: int = 2,
           progress: bool = False) -> list[Judged]:
    """Every function on every stride-th of the arguments."""
    def part(number: int) -> list[Judged]:
        first, last = (arguments * n // PARTS for n in (number, number + 1))
        words = binary, str(first + -first % stride), str(last), str(stride)
        return [_read(precision, line) for line in run(words).splitlines()]

    with ThreadPoolExecutor(processes) as pool:
        results = list(tqdm(pool.map(part, range(PARTS)), precision.name, PARTS,
                            disable=None if progress else True))
    return [_together(some) for some in zip(*results, strict=True)]


def _read(precision: Precision, line: str) -> Judged:
    name, error, where, small, small_where, wrong, strange = line.split()
    return Judged(precision, name, float(error), where, float(small), small_where, int(wrong),
                  strange)


def _together(some: Iterable[Judged]) -> Judged:
    parts = list(some)
    worst, small, strange = (max(parts, key=lambda x, name=name: getattr(x, name))
                             for name in ("error", "small", "wrong"))
    return Judged(worst.precision, worst.name, worst.error, worst.where, small.small,
                  small.small_where, sum(x.wrong for x in parts), strange.strange)


def main() -> None:
    """Print the table; exit with 1 if a statement does not hold."""
    parser = argparse.ArgumentParser(description="Judge elementary functions.")
    parser.add_argument("--stride", type=int, default=1,
                        help="take every N-th number of single precision only")
    parser.add_argument("--doubles", type=int, default=100_000_000, help="numbers of double")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    if not IS_WIDE:
        parser.error("needs a long double of 64 bits (x86); here it has other ones")
    results: list[Judged] = []
    with tempfile.TemporaryDirectory() as folder:
        for precision in PRECISIONS:
            arguments = ((SINGLES, options.stride) if precision is SINGLE else (options.doubles, 1))
            results += judged(precision, program(precision, Path(folder)), *arguments,
                              options.processes, progress=True)
    print(tabulate([(x.name, x.precision.name, x.error, x.where, float(x.stated), x.small,
                     x.small_where, x.wrong) for x in results],
                   ("function", "precision", "ulps", "at", "stated", "subnormal", "at", "wrong"),
                   floatfmt=".4f"))
    raise SystemExit(not all(x.holds for x in results))


if __name__ == "__main__":
    main()
