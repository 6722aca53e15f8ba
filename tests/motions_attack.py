"""Judges what `coscrew simulate` and `check` say of motions: those of hundreds of scenes.

`python -m tests.motions_attack [--count N] [--seed N] [--family NAME]… [--only N] [--jobs N]`
compares each motion with an integration of order 8 that shares nothing with coscrew.  A motion is
right if every joint's coordinate is within 1 % of its amplitude at all times and its velocity
within 5 %; wrong if a coordinate is off by more than 5 %; and else between.  Right motions must
pass and go on, wrong ones must fail and stop; an advised step must do, and twice that must not.
Each scene runs by the default integrator, by another, and by one in single precision, in turn, or
with `--all` by all.  `--show FAMILY N` prints its file.  References are kept in build/motions.
"""

import argparse
import os
import sys
import time
import warnings
from concurrent.futures import ProcessPoolExecutor
from itertools import groupby, product
from math import nan

from tabulate import tabulate

from tests.support.motions.drawing import RATES
from tests.support.motions.families import FAMILIES, drawn
from tests.support.motions.reference import Unjudged
from tests.support.motions.table import Row, converged, exceptions, judge, settings, table

Task = tuple[str, int, int, bool, bool]
"""Family, number, seed, whether to follow advice, whether to run all integrators."""


def rows(task: Task) -> list[Row]:
    """All runs of one scene."""
    family, number, seed, follow, every = task
    warnings.simplefilter("ignore")
    judged = judge(drawn(family, number, seed))
    return [judged.row(how, follow) for how in settings(judged.motion, every)]


def deviation(task: Task) -> tuple[str, str, float, float]:
    """Deviation of a motion with short steps from the judge's."""
    warnings.simplefilter("ignore")
    motion = drawn(*task[:3])
    try:
        worst = converged(motion)
    except Unjudged as error:
        return motion.name, str(error), nan, nan
    return motion.name, worst.part, worst.q, worst.v


def spread(count: int) -> list[int]:
    """Numbers of scenes: all rates once or more, or fewer of them evenly."""
    return [n * len(RATES) // count for n in range(count)] if count < len(RATES) \
        else list(range(count))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=12, help="scenes of each family")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--family", action="append", choices=tuple(FAMILIES), metavar="NAME",
                        help=f"one of {', '.join(FAMILIES)}; may be repeated")
    parser.add_argument("--only", type=int, metavar="N", help="the scene of this number alone")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--all", action="store_true",
                        help="every scene with every integrator in both precisions")
    parser.add_argument("--no-advice", action="store_true", help="advice is not followed")
    parser.add_argument("--judge", action="store_true", help="compare the judge with Runge and "
                        "Kutta's method at short steps instead")
    parser.add_argument("--show", nargs=2, metavar=("FAMILY", "N"), help="print a scene's file")
    return parser


def main() -> int:
    options = _parser().parse_args()
    if options.show:
        motion = drawn(options.show[0], int(options.show[1]), options.seed)
        print(motion.text(motion.steps[0]))
        return 0
    began = time.perf_counter()
    numbers = spread(options.count) if options.only is None else [options.only]
    tasks = [(*x, options.seed, not options.no_advice, options.all)
             for x in product(options.family or FAMILIES, numbers)]
    got: list[Row] = []
    with ProcessPoolExecutor(options.jobs) as pool:
        if options.judge:
            print(tabulate(pool.map(deviation, tasks), ("scene", "part", "q", "v"), floatfmt=".2g"))
            return 0
        for family, some in groupby(zip(tasks, pool.map(rows, tasks), strict=True),
                                    lambda x: x[0][0]):
            of_family = [row for _, of_scene in some for row in of_scene]
            print("\n".join(row.words for row in of_family if row.false))
            print(f"{family}:\n{table(of_family)}\n", flush=True)
            got += of_family
    print(f"\n{table(got)}\n\n{exceptions(got)}\n\n{len(tasks)} scenes, {len(got)} runs, "
          f"{time.perf_counter() - began:.0f} s")
    return any(row.false for row in got)


if __name__ == "__main__":
    sys.exit(main())
