"""Times of the derivatives of dynamics against Pinocchio's and CasADi's: one call from C, and many
states in lanes.

Rounds of all take turns, and all results are compared first.  Pinocchio is compiled for this
processor, from its headers.  CasADi's C computes derivatives by Pinocchio's recursions or by
automatic differentiation of its dynamics; the faster one counts, by the better compiler."""

import ctypes
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from tabulate import tabulate

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.reports.timing.loop_timing import Loop, Timing, timed_loops
from tests.benchmarks.bars import Bar, fastest, show
from tests.benchmarks.casadi_loops import ALL_DERIVATIVES, OF_HUMANOIDS, CasADi, written
from tests.benchmarks.pinocchio_loops import (
    DERIVATIVES,
    OPTIMISED,
    Pinocchio,
    library,
    refuse_others,
    robot_named,
)
from tests.benchmarks.scene_loops import WIDTHS, Loops, compiled, compilers, widths
from tests.benchmarks.words import span
from tests.support.scenes.robots import Robot

INVERSE, FORWARD = DERIVATIVES
WANTED = {("ur5", INVERSE): 7, ("ur5", FORWARD): 7, ("panda7", INVERSE): 5.5,
          ("panda7", FORWARD): 4, ("g1", INVERSE): 2, ("g1", FORWARD): 1.6}
"""Pinocchio's time / ours, of one call."""
CASADI = 2
"""CasADi's time / ours."""
LANES = {"ur5": 25, "panda7": 15}
"""Pinocchio's time / ours, of many states with the widest lanes."""
STATES = 128
RESULTS = 2**19
"""Most bytes of results of single calls: they stay in the cache, as those of a controller do, and
those of Pinocchio, which are left in its workspace."""
SECONDS = 2.0  # of each comparison


@dataclass(frozen=True)
class Subject:
    """A robot, at states, with its rivals in C."""

    robot: Robot
    given: tuple[np.ndarray, ...]
    pinocchio: Pinocchio | None
    casadi: dict[tuple[str, str], CasADi]  # by function, and compiler and way
    missing: dict[str, str]  # a rival: the reason why it is missing


def subject(name: str, folder: Path) -> Subject:
    """A robot; a humanoid without CasADi's forward dynamics, which take clang eight minutes."""
    robot = robot_named(name, (*DERIVATIVES, "mass_matrix"))
    given, missing, casadi = robot.states(_few(robot)), {}, {}
    built, missing["Pinocchio"] = library("clang++")
    missing["CasADi"] = written(robot, folder, written_of(name))
    if not missing["CasADi"]:
        for compiler in compilers():
            one = CasADi.compiled(robot, given, folder, compiler)
            casadi |= {(function, f"{compiler}{way}"): replace(one, way=way)
                       for function, way in written_of(name)}
    return Subject(robot, given, Pinocchio(built, robot, given) if built else None, casadi, missing)


def _few(robot: Robot) -> int:
    """The number of states of single calls."""
    return min(STATES, RESULTS // (8 * 3 * robot.functions.nv**2))


def written_of(name: str) -> tuple[tuple[str, str], ...]:
    """CasADi's functions and ways for a robot."""
    return ALL_DERIVATIVES if name in LANES else OF_HUMANOIDS


def timed(x: Subject, function: str, ours: dict[str, tuple[str, Loops]]
          ) -> tuple[dict[str, Timing], Timing | None, Timing | None]:
    """Our times by name, of ("one" or "many", loops), Pinocchio's, and CasADi's best, after results
    have been compared."""
    loops: list[Loop] = []
    rivals = [*([x.pinocchio] if x.pinocchio else []), *(
        y for (of, _), y in x.casadi.items() if of == function)]
    for kind, own in ours.values():
        arrays = own.arguments(function, DOUBLE, x.given)
        loops.append(own.loop(kind, function, DOUBLE, arrays))
        loops[-1].function(ctypes.c_long(len(x.given[0])), loops[-1].arguments)
        for rival in rivals:
            refuse_others(arrays[-3:], rival, function)
    driver = next(iter(ours.values()))[1].library
    timings = timed_loops(driver, [*loops, *(r.loop(function) for r in rivals)], 1e9 * SECONDS)
    own, others = timings[:len(loops)], timings[len(loops):]
    pinocchio = others.pop(0) if x.pinocchio else None
    casadi = min(others, key=lambda t: t.minimum) if others else None
    return dict(zip(ours, own, strict=True)), pinocchio, casadi


def single_calls(x: Subject, folder: Path) -> Iterator[tuple[list[str], list[tuple[float, Bar]]]]:
    """A line for each function and compiler, and its bars."""
    scene = x.robot.functions
    ours = {c: ("one", compiled(scene, DERIVATIVES, folder, c, "-march=native"))
            for c in (compilers() if scene.name in LANES else compilers()[-1:])}
    for function in DERIVATIVES:
        times, pinocchio, casadi = timed(x, function, ours)
        for compiler, own in times.items():
            rivals = {"Pinocchio": (pinocchio, WANTED[scene.name, function])}
            if (function, "") in written_of(scene.name):
                rivals["CasADi"] = casadi, CASADI
            bars = [(own.minimum, Bar(f"one call from C: {rival} / {function} of {scene.name}",
                                      wanted, time.ratio(own) if time else None,
                                      note=x.missing[rival] or compiler))
                    for rival, (time, wanted) in rivals.items()]
            yield [scene.name, function, str(operations(scene.named(function).program)), compiler,
                   span(own.time), *(span(t.time) if t else "" for t in (pinocchio, casadi)),
                   *(span(t.ratio(own)) if t else "" for t in (pinocchio, casadi))], bars


def operations(program: Program) -> int:
    """Operations besides changes of sign."""
    return sum(count for op, count in program.counts.items() if op is not Op.NEG)


def in_lanes(x: Subject, folder: Path) -> Iterator[tuple[list[str], tuple[float, Bar]]]:
    """A line for each function and compiler with the widest lanes, and its bar."""
    scene, width, given = x.robot.functions, widths()[-1], x.robot.states(STATES)
    many = replace(x, given=given, casadi={},
                   pinocchio=replace(x.pinocchio, states=given) if x.pinocchio else None)
    ours = {c: ("many", compiled(scene, DERIVATIVES, folder, c, *WIDTHS[width], many=True))
            for c in compilers()}
    for function in DERIVATIVES:
        times, pinocchio, _ = timed(many, function, ours)
        for compiler, own in times.items():
            ratio = pinocchio.ratio(own) if pinocchio else None
            bar = Bar(f"{width} lanes: Pinocchio / {function} of {scene.name}", LANES[scene.name],
                      ratio, note=x.missing["Pinocchio"] or compiler)
            yield [scene.name, function, compiler, width, span(own.time),
                   span(pinocchio.time) if pinocchio else "", span(ratio) if ratio else ""], (
                       own.minimum, bar)


def main() -> list[Bar]:
    """Print the tables."""
    single, many = [], []
    for name in dict.fromkeys(robot for robot, _ in WANTED):
        with TemporaryDirectory() as folder:
            x = subject(name, Path(folder))
            single += single_calls(x, Path(folder))
        if name in LANES:
            with TemporaryDirectory() as folder:
                many += in_lanes(x, Path(folder))
    print("\nDerivatives from C, ns a call, median (95 % interval) of rounds in which all take "
          f"turns; ratios: rival / ours in a round; Pinocchio by clang++ {OPTIMISED}, CasADi's C "
          "by the better compiler and way")
    print(tabulate([row for row, _ in single], (
        "robot", "function", "operations", "compiler", "ours", "Pinocchio", "CasADi",
        "Pinocchio / ours", "CasADi / ours"), disable_numparse=True))
    print(f"\n{STATES} states in lanes, ns a state")
    print(tabulate([row for row, _ in many], (
        "robot", "function", "compiler", "width", "ours", "Pinocchio", "Pinocchio / ours"),
        disable_numparse=True))
    return [*fastest(x for _, bars in single for x in bars), *fastest(x for _, x in many)]


if __name__ == "__main__":
    show(main())
