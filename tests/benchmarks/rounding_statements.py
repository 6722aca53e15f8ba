"""Stated bounds of rounding errors between the limits, beside the worst errors of a search."""

from collections.abc import Iterator

from tabulate import tabulate

from coscrew_codegen.runtime.load import load_scene
from tests.benchmarks.cortex_m4 import ROBOTS
from tests.support.scenes.robots import scene_of
from tests.support.scenes.selecting import jacobians
from tests.support.scenes.worst_rounding import stated, worst_found

NAMES = ("body_poses", "gravity_torques", "mass_matrix", "energy", "bias_torques")
STATES, ROUNDS = 4000, 60


def rows() -> Iterator[tuple[str, ...]]:
    """A line for each bound in single precision."""
    for name, file in ROBOTS.items():
        scene = scene_of(file)
        kernels = load_scene(scene, functions=(*NAMES, [*jacobians(scene)][-1]))
        for function in kernels.functions.functions:
            for (output, precision), bound in stated(function).items():
                if precision == "single":
                    result = worst_found(kernels, function, output, STATES, ROUNDS)
                    yield (name, function.name, f"{bound:.1e}", f"{result:.1e}",
                           f"{bound / result:.0f}")


def main() -> None:
    """Print the table."""
    print(f"\nSingle precision, the worst of {STATES * (ROUNDS + 1)} states")
    print(tabulate(rows(), ("robot", "function", "stated", "found", "ratio"),
                   disable_numparse=True))


if __name__ == "__main__":
    main()
