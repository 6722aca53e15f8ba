"""Counts instructions of calls on each core under qemu, and fits the numbers of
`core_estimates.INSTRUCTIONS` to them: `--count` counts anew, which takes minutes."""

import argparse
import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from scipy.optimize import nnls
from tabulate import tabulate

from coscrew_codegen.accuracy.fixed_scene import in_fixed
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.reports.cost.needs import core_costs, core_estimates
from coscrew_codegen.reports.cost.needs.core_estimates import counts_in_floats, counts_in_integers
from coscrew_codegen.scene.mechanism.ranges import symmetric
from coscrew_codegen.scene.mechanism.ranges_of_model import ranges_of_model
from coscrew_codegen.scene.mechanism.tree import tree_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.fixed_point import PANDA
from tests.support.scenes.robots import scene_of

COUNTS = Path(__file__).with_suffix(".json")
GIMBAL = Path(__file__).parents[2] / "examples/fixed_point/gimbal.toml"
OTHER = "panda"
"""A robot whose counts stand in the file, too, to which nothing is fitted."""
FUNCTIONS = ("inverse_dynamics", "mass_matrix", "forward_dynamics")
Table = dict[tuple[str, str], dict[str, float]]


@dataclass(frozen=True)
class Counted:
    """A function's instructions, and its operations by kind; `before` has those of the plain
    function that it calls."""

    robot: str
    core: str
    kind: str  # number format of its operations
    function: str
    tier: str
    count: int
    operations: Mapping[str, int]
    before: Mapping[str, int] | None = None


def committed() -> list[Counted]:
    """The counts that stand beside this file."""
    return [Counted(**x) for x in json.loads(COUNTS.read_text(encoding="utf-8"))]


def calibration() -> list[Counted]:
    """The counts to which the estimates are fitted."""
    return [x for x in committed() if x.robot != OTHER]


def scene(robot: str) -> Scene:
    """A gimbal or a robot's file, |v| <= 2 and |a| <= 10."""
    path = {"gimbal": GIMBAL, OTHER: PANDA}.get(robot)
    its = read_scene(path) if path else scene_of(robot)
    ranges = ranges_of_model(its, tree_of(its.model, mimics=False))
    return replace(its, tiers=("fixed",), ranges=ranges.stating({
        "v": (symmetric(Fraction(2)),) * len(ranges.v),
        "a": (symmetric(Fraction(10)),) * len(ranges.a)}))


def counted(robot: str, names: Sequence[str] = FUNCTIONS) -> Iterator[Counted]:
    """The counts of a robot's functions that are in fixed point, in every number format."""
    plain = derive(scene(robot), names)
    made = in_fixed(plain, tier_named("fixed"))
    with TemporaryDirectory() as folder:
        for f, x, counts in core_costs.counted(made, plain, Path(folder)):
            precision = BY_NAME.get(x.precision.name)
            kind, operations, before = x.words, Counter[str](), None
            if precision is None:
                products, fixed = next((k, v) for k, v in f.programs.items() if x.made is v)
                kind, operations = f"fixed, {products.value}", counts_in_integers(fixed.program)
            else:
                kind = "double" if x.function.program.wide else precision.name
                operations = counts_in_floats(x.function.program, precision)
                if x.function.plain:
                    before = counts_in_floats(x.function.plain, precision)
            for core, count in counts.items():
                yield Counted(plain.name, core, kind, f.plain.name, x.tier, count, operations,
                              before)


def fitted(counts: Sequence[Counted]) -> Table:
    """The instructions of an operation by core and number format: least squares of relative errors,
    none negative.  Single precision first, since functions in double may call it."""
    table: Table = {}
    for core, kind in sorted({(x.core, x.kind) for x in counts}, key=lambda x: (
            x[0], x[1] == "double", x[1])):
        rows = [x for x in counts if (x.core, x.kind) == (core, kind)]
        names = sorted({name for x in rows for name in x.operations})
        left = np.array([[x.operations.get(name, 0) / x.count for name in names] for x in rows])
        right = [1 - total(table, x.core, "single", x.before or {}) / x.count for x in rows]
        numbers, _ = nnls(left, np.array(right))
        table[core, kind] = {name: float(f"{n:.4g}") for name, n in zip(names, numbers, strict=True)
                             if n > 0}
    return table


def total(table: Mapping[tuple[str, str], Mapping[str, float]], core: str, kind: str,
          operations: Mapping[str, int]) -> float:
    """The instructions of these operations."""
    of = table.get((core, kind), {})
    return sum(of.get(name, 0) * count for name, count in operations.items())


def error(x: Counted, table: Mapping[tuple[str, str], Mapping[str, float]]) -> float:
    """The relative error of a function's estimate."""
    return (total(table, x.core, x.kind, x.operations)
            + total(table, x.core, "single", x.before or {})) / x.count - 1


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", action="store_true")
    parser.add_argument("robots", nargs="*", help="files of example-robot-data to try it on")
    options = parser.parse_args()
    if options.count:
        counts = [x for robot in ("gimbal", "ur_description/urdf/ur5_robot.urdf", OTHER)
                  for x in counted(robot)]
        COUNTS.write_text("[\n" + ",\n".join(json.dumps(asdict(x)) for x in counts) + "\n]\n")
    for key, numbers in fitted(calibration()).items():
        print(key, numbers)
    rows = [*committed(), *(x for robot in options.robots for x in counted(robot))]
    print(tabulate([(x.robot, x.core, x.kind, x.tier, x.function, f"{x.count:,}",
                     f"{100 * error(x, core_estimates.INSTRUCTIONS):+.1f} %") for x in rows],
                   ("robot", "core", "format", "tier", "function", "counted", "estimate")))


if __name__ == "__main__":
    main()
