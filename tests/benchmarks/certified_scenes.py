"""Ratios of certified bounds of scenes' functions to the true errors, and their cost.

`python -m tests.benchmarks.certified_scenes` prints, for robots of example-robot-data, the median,
the 90th percentile and the largest of bound / error, over all components with an error at random
states.  The truth is the plain program in 60 digits with the model's exact decimals.  With
--calibration it prints instead how many of 1e5 outputs of each function have a bound of at most so
many times the error, judged in 113 bits; --plot draws them."""

import argparse
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import mpmath
import numpy as np
from tabulate import tabulate

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.runtime.load import Kernels, kernels_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.recordings.recording_writer import check_target
from tests.benchmarks.calibration import FACTORS, Calibration, plot
from tests.support.scenes.robots import scene_of
from tests.support.scenes.tiers import DIGITS, flat, states, truths
from tests.support.truth import quad

ROBOTS = {"ur5": ("ur_description/urdf/ur5_robot.urdf", False),
          "panda": ("panda_description/urdf/panda.urdf", False),
          "g1": ("g1_description/urdf/g1_29dof_rev_1_0.urdf", True)}
"""Files, and whether the base is free: 6, 9 and 35 degrees of freedom."""
CHAINS = {f"chain{n}": n for n in (15, 20, 25)}
"""Arms of so many joints, one behind the other, about axes in turn."""
FUNCTIONS = ("inverse_dynamics", "mass_matrix", "forward_dynamics")
OUTPUTS = 1000
"""Of each function and precision, at least."""
CALIBRATED = 100_000


def chain(joints: int) -> Scene:
    """An arm of so many revolute joints, under gravity."""
    lines = ['name = "chain"', "[effects.gravity]"]
    for n in range(joints):
        axis = [int(k == (2, 1, 0)[n % 3]) for k in range(3)]
        lines += [f"[bodies.b{n}]", f"mass = {110 - 3 * n}e-2", "com = [0.01, 0.02, 0.15]",
                  "inertia = [0.01, 0.012, 0.005]", f"[joints.j{n}]", 'type = "revolute"',
                  f'parent = "b{n - 1}"' if n else "", f'child = "b{n}"', f"axis = {axis}",
                  "origin = { xyz = [0, 0.01, 0.3] }"]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "chain.toml")
        path.write_text("\n".join(lines))
        return read_scene(path)


def kernels(name: str) -> Kernels:
    """The robot under gravity, with the certified tier."""
    scene = chain(CHAINS[name]) if name in CHAINS else scene_of(*ROBOTS[name])
    functions = derive(scene, FUNCTIONS)
    return kernels_of(replace(functions, name=name, tiers=("certified",)))


def ratios(plain: SceneFunctions, function: FunctionProgram, certified: object, p: Precision,
           count: int
           ) -> tuple[np.ndarray, int]:
    """Bound / error of each component that has an error, inf without a statement, at this many
    states; and how many bounds are smaller."""
    given = states(plain, function, count, p)
    results, bounds = (flat(x, count) for x in certified(*given))
    result, broken = [], 0
    with mpmath.workdps(DIGITS):
        for row, true in enumerate(truths(function.program, given)):
            for x, bound, exact in zip(results[row], bounds[row], true, strict=True):
                error = abs(mpmath.mpf(float(x)) - exact)
                if not np.isfinite(bound):
                    result.append(np.inf)
                    continue
                broken += bool(error > float(bound))
                if error:
                    result.append(float(float(bound) / error))
    return np.array(result), broken


def rows(name: str, outputs: int) -> Iterator[tuple[object, ...]]:
    """A line for each function and precision."""
    plain = kernels(name)
    for function in plain.functions.functions:
        count = -(-outputs // len(function.program.results))
        for p in PRECISIONS:
            certified = getattr(getattr(plain.certified, p.name), function.name)
            result, broken = ratios(plain.functions, function, certified, p, count)
            yield (name, function.name, p.name, count, len(result), *(f"{x:.4g}" for x in (
                np.median(result), *np.quantile(result, (0.9, 1), method="higher"))),
                int(np.isinf(result).sum()), broken)


def calibrations(name: str, outputs: int, folder: Path) -> Iterator[Calibration]:
    """The calibration of each function and precision, at random states."""
    plain = kernels(name)
    for function in plain.functions.functions:
        count, judge = -(-outputs // len(function.program.results)), quad.judge(
            function.program, folder)
        for p in PRECISIONS:
            given = states(plain.functions, function, count, p)
            certified = getattr(getattr(plain.certified, p.name), function.name)(*given)
            result = judge(flat(tuple(given), count), *(flat(x, count) for x in certified))
            yield Calibration(name, function.name, p, 1 / result[result > 0])


def calibrate(robots: Sequence[str], outputs: int, drawn: Path | None) -> None:
    """Print the table of --calibration, and draw it."""
    if drawn:
        check_target(drawn, (".svg",))
    with tempfile.TemporaryDirectory() as folder:
        results = [x for name in robots for x in calibrations(name, outputs, Path(folder))]
    print(tabulate([x.row for x in results], (
        "robot", "function", "precision", "outputs with an error", *(f"<= {x}" for x in FACTORS),
        "largest"), disable_numparse=True))
    if drawn:
        plot(results, drawn)


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description="Certified bounds beside true errors.")
    parser.add_argument("--robot", nargs="+", default=[*ROBOTS],
                        choices=[*ROBOTS, *CHAINS])
    parser.add_argument("--outputs", type=int, help=f"{OUTPUTS}, or {CALIBRATED} to calibrate")
    parser.add_argument("--calibration", action="store_true")
    parser.add_argument("--plot", type=Path, metavar="FILE.svg")
    options = parser.parse_args()
    if options.plot and not options.calibration:
        parser.error("--plot draws what --calibration measures")
    if options.calibration:
        calibrate(options.robot, options.outputs or CALIBRATED, options.plot)
        return
    table = [row for name in options.robot for row in rows(name, options.outputs or OUTPUTS)]
    print(tabulate(table, ("robot", "function", "precision", "states", "outputs with an error",
                           "bound / error: median", "90 %", "largest", "no statement", "broken"),
                   disable_numparse=True))


if __name__ == "__main__":
    main()
