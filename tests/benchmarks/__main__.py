"""Run all benchmarks, or those named, and end with one table of bars.

`python -m tests.benchmarks [NAME …]`; the table is also in build/benchmarks.md.
"""

import argparse
from importlib import import_module

from tests.benchmarks.bars import FILE, ROOT, Bar, machine, summary, table, write

NAMES = ("header_kernels", "many_elements", "gufuncs", "tiers", "scene_tiers", "scene_calls",
         "scene_lanes", "dynamics", "derivative_times", "many_states", "mujoco_steps",
         "mujoco_contacts", "python_calls", "controllers", "arrays", "sweeps", "cortex_m4",
         "rounding_statements", "range_proofs", "fixed_point", "accuracy")


def main() -> None:
    """Print each benchmark's tables, and the bars."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks")
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(NAMES))
    names = parser.parse_args().names
    if unknown := [name for name in names if name not in NAMES]:
        parser.error(f"no benchmark {unknown[0]}; there are {', '.join(NAMES)}")
    bars: list[Bar] = []
    for name in names or NAMES:
        bars += import_module(f"tests.benchmarks.{name}").main() or ()
        write(bars)
    print("", *machine(), "", table(bars), "", summary(bars),
          f"also in {FILE.relative_to(ROOT)}", sep="\n")


if __name__ == "__main__":
    main()
