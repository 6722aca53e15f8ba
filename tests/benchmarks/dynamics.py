"""Dynamics of real robots against Pinocchio's: times of single calls, from C and from Python.

From C against Pinocchio compiled for this processor (pinocchio_loops.py), from Python against its
wheel.  Results are compared first.
"""

import ctypes
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import pinocchio as pin
from tabulate import tabulate

from coscrew_codegen.formats import DOUBLE, PRECISIONS
from coscrew_codegen.native.timing import timed_calls, timed_loops
from coscrew_codegen.program import Op, Program
from coscrew_codegen.simulate.load import kernels_of
from tests.benchmarks.bars import Bar, fastest, show
from tests.benchmarks.pinocchio_loops import (
    FUNCTIONS,
    OPTIMISED,
    ROBOTS,
    Rival,
    library,
    refuse_others,
    robot_named,
)
from tests.benchmarks.scene_loops import compiled, compilers
from tests.benchmarks.words import said
from tests.support.scenes.robots import Robot

WANTED = {"ur5": 5, "panda7": 5, "g1": 3.5}
"""Pinocchio's time / ours, from C."""
FROM_PYTHON = 0.5
"""Our time / Pinocchio's."""
CPLUSPLUS = {"clang++": "Pinocchio", "g++": "by g++"}
STATES = 64
SECONDS = 2.0  # of each comparison


def operations(program: Program) -> str:
    """Sums, products, quotients and choices + pairs of sine and cosine."""
    counts = program.counts
    return f"{sum(counts.values()) - counts[Op.SIN] - counts[Op.COS]} + {counts[Op.SIN]}"


def from_c(robot: Robot, rivals: dict[str, ctypes.CDLL]
           ) -> Iterator[tuple[list[str], float, Bar]]:
    """A line of the table, our time, and the bar against clang's Pinocchio."""
    scene, given = robot.functions, robot.states(STATES)
    theirs = {name: Rival(x, robot, given) for name, x in rivals.items()}
    with TemporaryDirectory() as folder:  # gcc takes long for many joints
        ours = {compiler: compiled(scene, FUNCTIONS, Path(folder), compiler, "-march=native")
                for compiler in (compilers() if scene.nv < 20 else compilers()[-1:])}
    for function in FUNCTIONS:
        loops = []
        for x in ours.values():
            for p in PRECISIONS:
                arrays = x.arguments(function, p, given)
                loops.append(x.loop("one", function, p, arrays))
                if p is DOUBLE:
                    loops[-1].function(ctypes.c_long(STATES), loops[-1].arguments)
                    for rival in theirs.values():
                        refuse_others(arrays[-1], rival, function)
        loops += [x.loop(function) for x in theirs.values()]
        timings = timed_loops(next(iter(ours.values())).library, loops, 1e9 * SECONDS)
        others = dict(zip(theirs, timings[2 * len(ours):], strict=True))
        for k, compiler in enumerate(ours):
            double, single = timings[2 * k:2 * k + 2]
            rival = others.get("clang++")
            ratio = rival.ratio(double) if rival else None
            yield ([scene.name, function, compiler, said(double.time), said(single.time),
                    *(said(others[x].time) if x in others else "" for x in CPLUSPLUS),
                    said(ratio) if ratio else ""], double.minimum,
                   Bar(f"one call from C: Pinocchio / {function} of {scene.name}",
                       WANTED[scene.name], ratio, note=compiler))


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
        yield ([name, function, said(own.time, 1e-3), said(other.time, 1e-3),
                said(own.ratio(other))],
               Bar(f"one call from Python: {function} of {name} / pin", FROM_PYTHON,
                   own.ratio(other), most=True))


def main() -> list[Bar]:
    """Print what a call costs, and the ratios."""
    robots = {name: robot_named(name) for name in ROBOTS}
    print("\nOperations (sums, products, quotients, choices) + pairs of sine and cosine")
    print(tabulate([(name, *(operations(x.functions.named(f).program) for f in FUNCTIONS))
                    for name, x in robots.items()], ("robot", *FUNCTIONS)))
    built = {x: library(x) for x in CPLUSPLUS}
    missing, rivals = built["clang++"][1], {name: x for name, (x, _) in built.items() if x}
    lines = [x for robot in robots.values() for x in from_c(robot, rivals)]
    bars = fastest((time, replace(bar, note=missing or bar.note)) for _, time, bar in lines)
    print("\nFrom C, ns a call, median (95 % interval) of rounds in which all take turns; ratio: "
          f"time of clang's Pinocchio ({OPTIMISED}) / ours in double, in the same round")
    print(tabulate([row for row, _, _ in lines],
                   ("robot", "function", "compiler", "double", "single", *CPLUSPLUS.values(),
                    "ratio"), disable_numparse=True))
    found = [x for name, robot in robots.items() for x in from_python(name, robot)]
    print("\nFrom Python, µs a call; ratio: our time / that of Pinocchio's wheel")
    print(tabulate([row for row, _ in found], ("robot", "function", "ours", "pin", "ratio"),
                   disable_numparse=True))
    return bars + [bar for _, bar in found]


if __name__ == "__main__":
    show(main())
