"""The operations of robots' and example scenes' functions are counted, and the counts committed, so
that an increase is noticed.

`python -m tests.scenes.test_operation_counts` writes the file anew.
"""

import csv
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Op, Program
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import robots
from tests.support.scenes.kinds import Kind

FILE = Path(__file__).with_suffix(".csv")
EXAMPLES = Path(__file__).parents[2] / "examples" / "scenes"
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "bias_torques",
             "gravity_torques", "energy", "momentum", "body_poses", "body_twists",
             "implicit_acceleration")
KINDS = {"sums and products": (Op.ADD, Op.SUB, Op.MUL, Op.NEG), "quotients": (Op.DIV,),
         "sines and cosines": (Op.SIN, Op.COS)}


def _without_fingers(scene: Scene) -> Scene:
    joints = tuple(replace(x, kind=Kind.FIXED) if "finger" in x.name else x
                   for x in scene.model.joints)
    return replace(scene, model=replace(scene.model, joints=joints))


SCENES = {
    "UR5": lambda: robots.scene_of("ur_description/urdf/ur5_robot.urdf"),
    "Panda, fingers locked": lambda: _without_fingers(
        robots.scene_of("panda_description/urdf/panda.urdf")),
    "Panda": lambda: robots.scene_of("panda_description/urdf/panda.urdf"),
    "G1, floating": lambda: robots.scene_of("g1_description/urdf/g1_29dof_rev_1_0.urdf", True),
    **{path.stem: lambda path=path: read_scene(path) for path in sorted(EXAMPLES.glob("*.toml"))},
}


def _counts(program: Program) -> dict[str, int]:
    results = {kind: sum(program.counts[op] for op in ops) for kind, ops in KINDS.items()}
    return {**results, "others": len(program.instructions) - sum(results.values())}


def _rows(name: str) -> Iterator[dict[str, str]]:
    for f in derive(SCENES[name](), FUNCTIONS).functions:
        if f.name in FUNCTIONS:
            yield {"scene": name, "function": f.name,
                   **{kind: str(n) for kind, n in _counts(f.program).items()}}


@cache
def _committed() -> tuple[dict[str, str], ...]:
    with FILE.open(encoding="utf-8", newline="") as file:
        return tuple(csv.DictReader(file))


@pytest.mark.parametrize("name", SCENES)
def test_operations_are_as_many_as_committed(name: str) -> None:
    assert list(_rows(name)) == [row for row in _committed() if row["scene"] == name]


@pytest.mark.parametrize("name, most", (
    ("UR5", 378), ("Panda, fingers locked", 704), ("G1, floating", 4180)))
def test_inverse_dynamics_takes_at_most(name: str, most: int) -> None:
    """No more than when mechanics did not yet call the library's operations."""
    row = next(x for x in _committed() if (x["scene"], x["function"]) == (name, "inverse_dynamics"))
    assert int(row["sums and products"]) <= most


if __name__ == "__main__":
    with FILE.open("w", encoding="utf-8", newline="") as out:
        writer = csv.DictWriter(out, ("scene", "function", *KINDS, "others"), lineterminator="\n")
        writer.writeheader()
        for scene in SCENES:
            writer.writerows(_rows(scene))
