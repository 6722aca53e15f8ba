"""Searches states at which fixed point breaks a bound, or overflows: random ones, corners, and
climbing.

`python -m tests.fixed_attack [--states N] [--rounds N] [ROBOT ...]` prints the largest errors found
beside the bounds; it fails if one is broken.
"""

import argparse

import numpy as np

from coscrew_codegen.program.fixed.fixed_program import Products
from tests.support.scenes import fixed_point as fx
from tests.support.scenes import fixed_robots

FUNCTIONS = ("inverse_dynamics", "mass_matrix", "body_poses", "gravity_torques")
BLOCK = 20_000


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("robots", metavar="ROBOT", nargs="*")
    parser.add_argument("--states", type=int, default=100_000, help="each, in every round")
    parser.add_argument("--rounds", type=int, default=9, help="of climbing")
    given = parser.parse_args()
    broken = 0
    for robot in given.robots or fixed_robots.ROBOTS:
        for function in fixed_robots.fixed(robot, FUNCTIONS).functions:
            for products in Products:
                bounds, largest = fx.bounds(function, products), np.zeros(1)
                for seed in range(0, given.states, BLOCK):
                    worst = fx.worst(function, products, BLOCK, given.rounds, seed)
                    largest = np.maximum(largest, worst)
                    checked = function.programs[products]
                    fx.results(checked, fx.states(function, BLOCK, seed),
                               fx.checked(checked.program))
                print(f"{robot} {function.plain.name} {products.value}: proved {bounds.max():.1e}, "
                      f"found {largest.max():.1e} in {given.states * (given.rounds + 1)} states",
                      flush=True)
                broken |= bool((largest > bounds * (1 + 1e-9)).any())
    return broken


if __name__ == "__main__":
    raise SystemExit(main())
