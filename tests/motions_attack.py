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
from itertools import product

from tests.support.motions.families import FAMILIES, drawn
from tests.support.motions.table import Row, exceptions, judge, settings, table


def rows(task: tuple[str, int, int, bool, bool]) -> list[Row]:
    """All runs of one scene."""
    family, number, seed, follow, every = task
    warnings.simplefilter("ignore")
    judged = judge(drawn(family, number, seed))
    return [judged.row(how, follow) for how in settings(judged.motion, every)]


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
    parser.add_argument("--show", nargs=2, metavar=("FAMILY", "N"), help="print a scene's file")
    return parser


def main() -> int:
    options = _parser().parse_args()
    if options.show:
        motion = drawn(options.show[0], int(options.show[1]), options.seed)
        print(motion.text(motion.steps[0]))
        return 0
    began, numbers = time.perf_counter(), range(options.count)
    if options.only is not None:
        numbers = range(options.only, options.only + 1)
    tasks = [(*x, options.seed, not options.no_advice, options.all)
             for x in product(options.family or FAMILIES, numbers)]
    found: list[Row] = []
    with ProcessPoolExecutor(options.jobs) as pool:
        for some in pool.map(rows, tasks):
            found += some
            for row in some:
                if row.false:
                    print(row.words, flush=True)
    print(f"\n{table(found)}\n\n{exceptions(found)}\n\n{len(tasks)} scenes, {len(found)} runs, "
          f"{time.perf_counter() - began:.0f} s")
    return any(row.false for row in found)


if __name__ == "__main__":
    sys.exit(main())
