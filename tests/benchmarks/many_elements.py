"""Functions of many elements against a loop of calls, and against planes by hand on vector types.
"""

import ctypes
import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from tabulate import tabulate

from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.reports.timing.buffers import aligned, planes
from coscrew_codegen.reports.timing.loop_timing import Loop, pointers, timed_loops
from tests.benchmarks.bars import Bar, fastest, show
from tests.benchmarks.header_kernels import build
from tests.benchmarks.words import span

FLAGS = ("-O3", "-O3 -march=native")
OPERATIONS = {"CoAdc_one_D": "product_CoAdc, one D", "CoAdc_D_each": "product_CoAdc, D each",
              "cross_sc": "cross_sc", "axpy_cc": "axpy_cc"}
LAYOUTS = {"called": False, "rows": False, "planes": True, "hand": True}  # whether in planes
COUNT = 256
WANTED = {"many, array of structs: composed calls": 5, "planes: composed calls": 14,
          "planes: planes by hand": 0.8}
SECONDS = 0.2  # of each operation and precision


def measure(library: ctypes.CDLL) -> Iterator[tuple[tuple[str, ...], list[tuple[float, Bar]]]]:
    """A line for each operation and precision: the times, and ratios to those of planes; the times
    that are compared, and bars."""
    rng = np.random.default_rng(3)
    for precision in PRECISIONS:
        rows = [aligned(rng.uniform(-1, 1, (COUNT, size)).astype(precision.numpy_type))
                for size in (12, 6, 6, 6)]
        arrays = {False: pointers(rows), True: pointers(planes(rows))}
        one = pointers([rows[0][:1], *planes(rows)[1:]])
        for name, words in OPERATIONS.items():
            loops = [Loop(getattr(library, f"loop_{way}_{name}{precision.suffix}"), COUNT,
                          one if in_planes and "one_D" in name else arrays[in_planes])
                     for way, in_planes in LAYOUTS.items()]
            timings = timed_loops(library, loops, 1e9 * SECONDS)
            called, structs, many, hand = timings
            ratios = [called.ratio(structs), called.ratio(many), hand.ratio(many)]
            compared = zip((structs, many, many), WANTED.items(), ratios, strict=True)
            yield ((words, precision.name, *(span(x.time) for x in timings),
                    *map(span, ratios)),
                   [(x.minimum, Bar(f"{what} / {words}, {precision.name}", wanted, ratio))
                    for x, (what, wanted), ratio in compared])


def main() -> list[Bar]:
    """Print one table per compiler and flags."""
    bars = []
    for compiler in filter(shutil.which, ("gcc", "clang")):
        for flags in FLAGS:
            with tempfile.TemporaryDirectory() as folder:
                results = list(measure(build(compiler, flags, Path(folder), "many_elements")))
            print(f"\n{compiler} {flags}: ns per element of {COUNT}; median (95 % interval) of "
                  "rounds in which the four take turns; ratios in the same round")
            print(tabulate([row for row, _ in results],
                           ("operation", "precision", "composed calls", "_many", "_planes",
                            "by hand", "calls/_many", "calls/_planes", "by hand/_planes"),
                           disable_numparse=True))
            bars += [(time, replace(bar, note=f"{compiler} {flags}"))
                     for _, pairs in results for time, bar in pairs]
    return fastest(bars)


if __name__ == "__main__":
    show(main())
