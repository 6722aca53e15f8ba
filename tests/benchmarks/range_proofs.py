"""Time of proving bounds over stated ranges for a humanoid of 35 velocities."""

from time import process_time

import numpy as np

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.range_proofs import values
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.reports.timing.intervals import interval
from tests.benchmarks.bars import Bar, show
from tests.support.scenes.ranged import ranged
from tests.support.scenes.robots import scene_of

NAMES = ("inverse_dynamics", "inverse_dynamics_derivatives")
SECONDS, REPEATS = 0.2, 9


def main() -> list[Bar]:
    """Print and return the bars."""
    scene = ranged(scene_of("g1_description/urdf/g1_29dof_rev_1_0.urdf", True),
                   {"v": "2", "a": "10"})
    bars = []
    for name in NAMES:
        its, times = derive(scene, (name,)).named(name), []
        for _ in range(REPEATS):
            start = process_time()
            values(its.program, its.ranges, DOUBLE, FloatRounding(DOUBLE))
            times.append(process_time() - start)
        bars.append(Bar(f"seconds to prove {name}, 35 velocities", SECONDS,
                        interval(np.array(times)), True))
    show(bars)
    return bars


if __name__ == "__main__":
    main()
