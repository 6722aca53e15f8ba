"""Times of a Panda's state where many are computed in lanes: functions and steps from C, with every
compiler and width that this processor has, against one call after the other."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from tabulate import tabulate

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.reports.timing.loop_timing import timed_loops
from tests.benchmarks.scene_loops import WIDTHS, Loops, compiled, compilers, widths
from tests.benchmarks.words import span
from tests.support.scenes.robots import scene_of
from tests.support.scenes.tiers import states

NAMES = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
STEP = "step_leapfrog"
STATES = 256
SECONDS = 1.0  # of each comparison


def panda(*more: str) -> SceneFunctions:
    """The robot with its fingers, under gravity, with these functions besides NAMES."""
    scene = scene_of("panda_description/urdf/panda.urdf")
    return derive(replace(scene, name="panda"), (*NAMES, *more))


def rows(loops: Loops) -> Iterator[list[str]]:
    """A line for each function and precision."""
    for name in (*NAMES, STEP):
        for p in PRECISIONS:
            arrays = _arrays(loops, name, p)
            one, many = timed_loops(loops.library, [
                loops.loop(kind, name, p, arrays) for kind in ("one", "many")], 1e9 * SECONDS)
            yield [name, p.name, f"{one.minimum:.1f}", f"{many.minimum:.1f}", span(one.ratio(many))]


def _arrays(loops: Loops, name: str, p: Precision) -> list[np.ndarray]:
    """The arguments of a function, or q and v."""
    function = NAMES[0] if name == STEP else name
    given = states(loops.scene, loops.scene.named(function), STATES, p)
    return loops.arguments(function, p, given)[:2 if name == STEP else None]


def main() -> None:
    """Print the tables."""
    scene, table = panda(STEP), []
    with TemporaryDirectory() as folder:
        for compiler in compilers():
            for width in widths():
                loops = compiled(scene, (*NAMES, STEP), Path(folder), compiler, *WIDTHS[width],
                                 many=True)
                table += [[compiler, width, *row] for row in rows(loops)]
    print("\nA Panda with its fingers, ns a state from C, the shortest of rounds in which both "
          "take turns; ratio: median (95 % interval)")
    heads = ("one by one", "in lanes", "one / lanes")
    print(tabulate(table, ("compiler", "width", "function", "precision", *heads),
                   disable_numparse=True))


if __name__ == "__main__":
    main()
