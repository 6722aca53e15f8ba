"""Many states of an arm on one core: ours in lanes, with every compiler and width that this
processor has, against Pinocchio compiled for it, in a loop over the same states in C++.

Pinocchio's results are compared with ours, and left in its workspace; ours are written to arrays.
"""

import ctypes
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from tabulate import tabulate

from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS
from coscrew_codegen.reports.timing.loop_timing import Timing, timed_loops
from tests.benchmarks.bars import Bar, fastest, show
from tests.benchmarks.pinocchio_loops import (
    FUNCTIONS,
    OPTIMISED,
    Pinocchio,
    library,
    refuse_others,
    robot_named,
)
from tests.benchmarks.scene_loops import WIDTHS, compiled, compilers, widths
from tests.benchmarks.words import span

ARMS = ("panda7", "ur5")
WANTED = {"avx512f": 20, "avx2": 15}
"""Pinocchio's time / ours, by width."""
SINGLE = 1.8  # double's time / single's
STATES = 256
SECONDS = 3.0  # of each function


@dataclass(frozen=True)
class Measured:
    """A function of an arm with a compiler and a width, and Pinocchio's in the same rounds."""

    arm: str
    function: str
    compiler: str
    width: str
    double: Timing
    single: Timing
    rival: Timing | None

    @property
    def what(self) -> str:
        """The name in the table of bars."""
        return f"{self.function} of {self.arm}"


def measured(arm: str, pinocchio: ctypes.CDLL | None, folder: Path) -> Iterator[Measured]:
    """All functions, compilers and widths."""
    robot = robot_named(arm)
    given = robot.states(STATES)
    rival = Pinocchio(pinocchio, robot, given) if pinocchio else None
    ours = {(compiler, width): compiled(robot.functions, FUNCTIONS, folder, compiler,
                                        *WIDTHS[width], many=True)
            for compiler in compilers() for width in widths()}
    for function in FUNCTIONS:
        loops = []
        for x in ours.values():
            for p in PRECISIONS:
                arrays = x.arguments(function, p, given)
                loops.append(x.loop("many", function, p, arrays))
                if rival and p is DOUBLE:
                    loops[-1].function(ctypes.c_long(STATES), loops[-1].arguments)
                    refuse_others(arrays[-1:], rival, function)
        if rival:
            loops.append(rival.loop(function))
        timings = timed_loops(next(iter(ours.values())).library, loops, 1e9 * SECONDS)
        theirs = timings.pop() if rival else None
        for (compiler, width), double, single in zip(ours, timings[::2], timings[1::2],
                                                     strict=True):
            yield Measured(arm, function, compiler, width, double, single, theirs)


def bars(results: list[Measured], missing: str) -> Iterator[Bar]:
    """With the faster compiler: against Pinocchio, and of single precision against double."""
    for width, wanted in WANTED.items():
        of_width = [x for x in results if x.width == width]
        yield from fastest((x.double.minimum, Bar(
            f"{width} lanes: Pinocchio / {x.what}", wanted,
            x.rival.ratio(x.double) if x.rival else None, note=missing or x.compiler))
            for x in of_width)
        yield from fastest((x.double.minimum, Bar(
            f"{width} lanes: double / single, {x.what}", SINGLE, x.double.ratio(x.single),
            note=x.compiler)) for x in of_width)
        if not of_width:
            yield Bar(f"{width} lanes", wanted, note=f"the processor has no {width}")


def main() -> list[Bar]:
    """Print the table."""
    pinocchio, missing = library("clang++")
    with TemporaryDirectory() as folder:
        results = [x for arm in ARMS for x in measured(arm, pinocchio, Path(folder))]
    print(f"\n{STATES} states of arms in lanes from C, ns a state: the shortest of rounds in which "
          "all of a function take turns;\nratios: median (95 % interval).  Pinocchio: "
          f"{missing or f'clang++ {OPTIMISED}, in a loop'}")
    print(tabulate([row(x) for x in results],
                   ("arm", "function", "compiler", "width", "double", "single", "Pinocchio",
                    "Pinocchio / double", "Pinocchio / single", "double / single"),
                   disable_numparse=True))
    return list(bars(results, missing))


def row(x: Measured) -> tuple[str, ...]:
    """A line of the table."""
    theirs = (f"{x.rival.minimum:.0f}", span(x.rival.ratio(x.double)),
              span(x.rival.ratio(x.single))) if x.rival else ("",) * 3
    return (x.arm, x.function, x.compiler, x.width, f"{x.double.minimum:.1f}",
            f"{x.single.minimum:.1f}", *theirs, span(x.double.ratio(x.single)))


if __name__ == "__main__":
    show(main())
