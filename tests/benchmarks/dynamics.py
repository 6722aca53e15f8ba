"""Dynamics of real robots against Pinocchio's: times of single calls, from C and from Python.

From C against Pinocchio compiled for this processor (pinocchio_loops.py) and against C that CasADi
writes (casadi_loops.py), from Python against Pinocchio's wheel.  Results are compared first.
"""

import ctypes
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pinocchio as pin
from tabulate import tabulate

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS
from coscrew_codegen.reports.timing.loop_timing import Timing, timed_calls, timed_loops
from coscrew_codegen.runtime.load import kernels_of
from tests.benchmarks.bars import Bar, fastest, show
from tests.benchmarks.casadi_loops import CasADi, written
from tests.benchmarks.pinocchio_loops import (
    FUNCTIONS,
    OPTIMISED,
    ROBOTS,
    Pinocchio,
    library,
    refuse_others,
    robot_named,
)
from tests.benchmarks.scene_loops import Loops, compiled, compilers
from tests.benchmarks.words import span
from tests.support.scenes.robots import Robot

WANTED = {"Pinocchio": {"ur5": 5, "panda7": 5, "g1": 3.5}, "CasADi": {"ur5": 1.5, "panda7": 1.5}}
"""A rival's time / ours, from C, by robot."""
FROM_PYTHON = 0.5
"""Our time / Pinocchio's."""
CPLUSPLUS = {"Pinocchio": "clang++", "Pinocchio by g++": "g++"}
RIVALS = (*CPLUSPLUS, "CasADi")
MANY = 20  # velocities: gcc and CasADi take long for as many
STATES = 64
SECONDS = 2.0  # of each comparison


def operations(program: Program) -> str:
    """Sums, products, quotients and choices + pairs of sine and cosine."""
    counts = program.counts
    return f"{sum(counts.values()) - counts[Op.SIN] - counts[Op.COS]} + {counts[Op.SIN]}"


def rivals_of(robot: Robot, given: tuple[np.ndarray, ...], folder: Path) -> tuple[
        dict[str, Pinocchio | CasADi], dict[str, str]]:
    """Rivals by name, and the missing libraries of others."""
    results: dict[str, Pinocchio | CasADi] = {}
    missing = {}
    for name, compiler in CPLUSPLUS.items():
        built, missing[name] = library(compiler)
        if built:
            results[name] = Pinocchio(built, robot, given)
    if robot.functions.nv < MANY:
        missing["CasADi"] = written(robot, folder)
        if not missing["CasADi"]:
            results |= {f"CasADi, {x}": CasADi.compiled(robot, given, folder, x)
                        for x in compilers()}
    return results, missing


def from_c(robot: Robot) -> Iterator[tuple[list[str], list[tuple[float, Bar]]]]:
    """A line of the table; our time, and bars against clang's Pinocchio and CasADi's C."""
    scene, given = robot.functions, robot.states(STATES)
    with TemporaryDirectory() as folder:
        theirs, missing = rivals_of(robot, given, Path(folder))
        ours = {x: compiled(scene, FUNCTIONS, Path(folder), x, "-march=native")
                for x in (compilers() if scene.nv < MANY else compilers()[-1:])}
    for function in FUNCTIONS:
        timings = timed(function, ours, theirs, given)
        rivals = {name.partition(",")[0]: x for name, x in sorted(
            ((name, timings[name]) for name in theirs), key=lambda x: -x[1].minimum)}
        for compiler in ours:
            double, single = (timings[f"{compiler} {p.name}"] for p in PRECISIONS)
            ratios = {name: x.ratio(double) for name, x in rivals.items()}
            row = [scene.name, function, compiler, span(double.time), span(single.time),
                   *(span(rivals[x].time) if x in rivals else "" for x in RIVALS),
                   *(span(ratios[x]) if x in ratios else "" for x in WANTED)]
            bars = [Bar(f"one call from C: {name} / {function} of {scene.name}",
                        wanted[scene.name], ratios.get(name), note=missing[name] or compiler)
                    for name, wanted in WANTED.items() if scene.name in wanted]
            yield row, [(double.minimum, bar) for bar in bars]


def timed(function: str, ours: dict[str, Loops], theirs: dict[str, Pinocchio | CasADi],
          given: tuple[np.ndarray, ...]) -> dict[str, Timing]:
    """Times of all, ours by compiler and precision, after results have been compared."""
    loops = {}
    for compiler, x in ours.items():
        for p in PRECISIONS:
            arrays = x.arguments(function, p, given)
            loop = loops[f"{compiler} {p.name}"] = x.loop("one", function, p, arrays)
            if p is DOUBLE:
                loop.function(ctypes.c_long(STATES), loop.arguments)
                for rival in theirs.values():
                    refuse_others(arrays[-1:], rival, function)
    loops |= {name: x.loop(function) for name, x in theirs.items()}
    library = next(iter(ours.values())).library
    return dict(zip(loops, timed_loops(library, list(loops.values()), 1e9 * SECONDS), strict=True))


def from_python(name: str, robot: Robot) -> Iterator[tuple[list[str], Bar]]:
    """A line of the table, and its bar."""
    model, ours = robot.model, kernels_of(robot.functions).double
    data, (q, v, a) = model.createData(), (x[0] for x in robot.states(1))
    their_q, their_v, their_a = robot.theirs(q), robot.follow @ v, robot.follow @ a
    pairs = {
        "inverse_dynamics": (lambda: ours.inverse_dynamics(q, v, a),
                             lambda: pin.rnea(model, data, their_q, their_v, their_a)),
        "forward_dynamics": (lambda: ours.forward_dynamics(q, v, a),
                             lambda: pin.aba(model, data, their_q, their_v, their_a)),
        "mass_matrix": (lambda: ours.mass_matrix(q), lambda: pin.crba(model, data, their_q))}
    for function, calls in pairs.items():
        own, other = timed_calls(calls, 1e9 * SECONDS)
        yield ([name, function, span(own.time, 1e-3), span(other.time, 1e-3),
                span(own.ratio(other))],
               Bar(f"one call from Python: {function} of {name} / pin", FROM_PYTHON,
                   own.ratio(other), most=True))


def main() -> list[Bar]:
    """Prints the cost of a call, and the ratios."""
    robots = {name: robot_named(name) for name in ROBOTS}
    print("\nOperations (sums, products, quotients, choices) + pairs of sine and cosine")
    print(tabulate([(name, *(operations(x.functions.named(f).program) for f in FUNCTIONS))
                    for name, x in robots.items()], ("robot", *FUNCTIONS)))
    lines = [x for robot in robots.values() for x in from_c(robot)]
    print("\nFrom C, ns a call, median (95 % interval) of rounds in which all take turns; ratios: "
          f"rival / ours in double in a round; Pinocchio by clang++ {OPTIMISED}, CasADi's C by the "
          "better compiler")
    print(tabulate([row for row, _ in lines],
                   ("robot", "function", "compiler", "double", "single", *RIVALS,
                    *(f"{x} / ours" for x in WANTED)), disable_numparse=True))
    results = [x for name, robot in robots.items() for x in from_python(name, robot)]
    print("\nFrom Python, µs a call; ratio: our time / that of Pinocchio's wheel")
    print(tabulate([row for row, _ in results], ("robot", "function", "ours", "pin", "ratio"),
                   disable_numparse=True))
    return fastest(x for _, bars in lines for x in bars) + [bar for _, bar in results]


if __name__ == "__main__":
    show(main())
