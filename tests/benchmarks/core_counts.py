"""Counts instructions of calls on each core under qemu, and fits the numbers of
`core_estimates.INSTRUCTIONS` to them: `--count` counts anew, which takes minutes."""

import argparse
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from scipy.optimize import linprog
from tabulate import tabulate

from coscrew_codegen.accuracy.fixed_scene import in_fixed
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.dynamics import derive
from coscrew_codegen.reports.cost.needs import core_costs, core_estimates
from coscrew_codegen.reports.cost.needs.core_estimates import LEAST, Operations, instructions
from coscrew_codegen.scene.mechanism.ranges import ranges_of_model, symmetric
from coscrew_codegen.scene.mechanism.tree import tree_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.fixed_point import PANDA
from tests.support.scenes.robots import scene_of

COUNTS = Path(__file__).with_suffix(".json")
EXAMPLES = Path(__file__).parents[2] / "examples"
PENDULUM = """
[bodies]
upper = { mass = 2, com = [0, 0, -0.25], inertia = [0.04, 0.04, 0.002] }
lower = { mass = 1, com = [0, 0, -0.2], inertia = [0.01, 0.01, 0.001] }
[joints.shoulder]
type = "revolute"
child = "upper"
axis = [0, 1, 0]
[joints.elbow]
type = "revolute"
parent = "upper"
child = "lower"
axis = [0, 1, 0]
origin = { xyz = [0, 0, -0.5] }
[effects.gravity]
"""
SMALL = "double pendulum, |q| <= 0.3"
"""Sines of small angles multiply by zeros, which software's floating point does in few steps."""
SIZES = {SMALL: Fraction(3, 10), "double pendulum": Fraction(3), "pendulum": Fraction(3)}
"""Largest angles, for robots whose model has no limits."""
ROBOTS = ("gimbal", "pendulum", SMALL, "double pendulum", "ur5", "panda")
FUNCTIONS = ("inverse_dynamics", "mass_matrix", "gravity_torques", "energy", "body_poses",
             "momentum")
Table = dict[tuple[str, str], dict[str, float]]


@dataclass(frozen=True)
class Counted:
    """A function's instructions, and its operations by kind; `before` has those of the plain
    function that it calls."""

    robot: str
    core: str
    function: str
    words: str  # its number format
    count: int
    format: str  # of its operations
    counts: Mapping[str, int]
    before: Mapping[str, int] = field(default_factory=dict)

    @property
    def operations(self) -> Operations:
        """Its operations."""
        return Operations(self.format, self.counts, self.before)


def committed() -> list[Counted]:
    """The counts that stand beside this file; those below LEAST are left out."""
    return [Counted(**x) for x in json.loads(COUNTS.read_text(encoding="utf-8"))]


def scene(robot: str, folder: Path) -> Scene:
    """A robot, |v| <= 2 and |a| <= 10."""
    path = folder / "double_pendulum.toml"
    path.write_text(PENDULUM)
    files = {"gimbal": EXAMPLES / "fixed_point/gimbal.toml", "panda": PANDA,
             "pendulum": EXAMPLES / "scenes/pendulum.toml"}
    its = scene_of("ur_description/urdf/ur5_robot.urdf") if robot == "ur5" else read_scene(
        files.get(robot, path))
    ranges = ranges_of_model(tree_of(its.model, mimics=False), its.parameters)
    sizes = {"v": Fraction(2), "a": Fraction(10)}
    if robot in SIZES:
        sizes["q"] = SIZES[robot]
    return replace(its, tiers=("fixed",), ranges=ranges.stating({
        name: (symmetric(size),) * len(ranges.v) for name, size in sizes.items()}))


def counted(robot: str, names: Sequence[str] = FUNCTIONS) -> Iterator[Counted]:
    """The counts of a robot's functions that are in fixed point, in every number format."""
    with TemporaryDirectory() as folder:
        plain = derive(scene(robot, Path(folder)), names)
        made = in_fixed(plain, tier_named("fixed"))
        for f, x, counts in core_costs.counted(made, plain, Path(folder)):
            its = core_costs.operations(x, f)
            for core, count in counts.items():
                yield Counted(robot, core, f.plain.name, x.words, count, its.format,
                              dict(sorted(its.counts.items())), dict(sorted(its.before.items())))


def fitted(counts: Sequence[Counted]) -> Table:
    """The instructions of an operation by core and number format, none negative, for which the
    largest relative error is least.  Single precision first, since functions in double may call it.
    """
    table: Table = {}
    for core, kind in sorted({(x.core, x.format) for x in counts}, key=lambda x: (
            x[0], x[1] == "double", x[1])):
        rows = [x for x in counts if (x.core, x.format) == (core, kind)]
        names = sorted({name for x in rows for name in x.counts})
        parts = np.array([[x.counts.get(name, 0) / x.count for name in names] for x in rows])
        known = np.array([1 - instructions(table, core, x.operations) / x.count for x in rows])
        ones = np.ones((len(rows), 1))
        numbers = linprog([*[0] * len(names), 1], np.block([[parts, -ones], [-parts, -ones]]),
                          np.concatenate((known, -known)), method="highs").x
        table[core, kind] = {name: float(f"{n:.4g}") for name, n in zip(
            names, numbers[:-1], strict=True) if n > 1e-9}
    return table


def error(x: Counted, table: Mapping[tuple[str, str], Mapping[str, float]]) -> float:
    """The relative error of a function's estimate."""
    return instructions(table, x.core, x.operations) / x.count - 1


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", action="store_true")
    options = parser.parse_args()
    if options.count:
        counts = [x for robot in ROBOTS for x in counted(robot) if x.count >= LEAST]
        COUNTS.write_text("[\n" + ",\n".join(json.dumps(asdict(x)) for x in counts) + "\n]\n")
    for key, numbers in fitted(committed()).items():
        print(f"    {key}: {numbers},")
    print(tabulate([(x.robot, x.core, x.words, x.function, f"{x.count:,}",
                     f"{100 * error(x, core_estimates.INSTRUCTIONS):+.1f} %")
                    for x in committed()],
                   ("robot", "core", "format", "function", "counted", "estimate")))


if __name__ == "__main__":
    main()
