"""Attacks bounds over stated ranges: the worst errors that searches find, beside the bounds.

`python -m tests.ranges_attack [--states N] [--rounds N] [--write]` climbs from random states and
corners, with restarts, and judges the worst state of every component in 60 digits; `--write` makes
the worst cases of the tests.
"""

import argparse
import csv
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from tabulate import tabulate

from coscrew_codegen.accuracy.range_proofs import of_plain
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.range_search import Search, Worst
from tests.support.scenes.ranged import FUNCTIONS, SCENES, WORST, ranged
from tests.support.scenes.robots import scene_of

RESTARTS = 3
ROBOTS = {"UR5": ("ur_description/urdf/ur5_robot.urdf", False, {"a": "20"}),
          "G1": ("g1_description/urdf/g1_29dof_rev_1_0.urdf", False, {"v": "2", "a": "10"}),
          "G1, floating": ("g1_description/urdf/g1_29dof_rev_1_0.urdf", True,
                           {"v": "2", "a": "10"})}
OF_ROBOTS = ("inverse_dynamics", "mass_matrix", "inverse_dynamics_derivatives")


def scenes(robots: bool) -> Iterator[tuple[str, Scene]]:
    """The scenes of the tests and, if wanted, robots."""
    for name, make in SCENES.items():
        yield name, replace(make(), functions=FUNCTIONS[name])
    for name, (file, free, sizes) in ROBOTS.items() if robots else ():
        yield name, replace(ranged(scene_of(file, free), sizes), functions=OF_ROBOTS)


def worst_of(search: Search, states: int, rounds: int) -> Worst:
    """The component whose error is the largest, after restarts."""
    results = [x for n in range(RESTARTS) for x in search.climb(states, rounds, 1000 * n + 7)]
    return max(results, key=lambda x: x.error)


def main() -> None:
    """Print the table; write the worst cases if wanted."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--states", type=int, default=4000)
    parser.add_argument("--rounds", type=int, default=30)
    parser.add_argument("--robots", action="store_true", help="also a UR5 and a humanoid")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    rows, cases = [], []
    for name, scene in scenes(options.robots):
        kernels = kernels_for(scene)
        for function in kernels.functions.functions:
            if function.internal:
                continue
            for p in PRECISIONS:
                search = Search(kernels, function, p, of_plain(function, p))
                worst = worst_of(search, options.states, options.rounds)
                bound = max(x.error for x in search.bounds)
                assert worst.part <= 1, (name, function.name, p.name, worst)
                rows.append((name, function.name, p.name, f"{bound:.1e}", f"{worst.error:.1e}",
                             f"{bound / worst.error:.0f}"))
                print(*rows[-1], flush=True)
                if name in SCENES:
                    numbers = " ".join(float(y).hex() for x in worst.state for y in np.ravel(x))
                    cases.append((name, function.name, p.name, worst.place,
                                  worst.error.hex(), numbers))
    print(tabulate(rows, ("scene", "function", "precision", "stated", "found", "ratio"),
                   disable_numparse=True))
    if options.write:
        with WORST.open("w", encoding="utf-8", newline="") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(("scene", "function", "precision", "component", "error", "state"))
            table.writerows(cases)


if __name__ == "__main__":
    main()
