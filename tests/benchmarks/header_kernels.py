"""Header kernels in a loop over arrays of structs against out-of-line calls of a library."""

import ctypes
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from tabulate import tabulate

from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.reports.timing.buffers import aligned
from coscrew_codegen.reports.timing.loop_timing import Loop, driver, pointers, timed_loops
from tests.benchmarks.bars import Bar, fastest, show
from tests.benchmarks.words import span
from tests.support.compiled import all_headers

HERE = Path(__file__).parent
FLAGS = ("-O3", "-O3 -march=native")
OPERATIONS = {"CoAdc_one_D": "product_CoAdc, one D", "CoAdc_D_each": "product_CoAdc, D each",
              "CoAdinvc_one_D": "product_CoAdinvc, one D", "cross_sc": "cross_sc",
              "axpy_cc": "axpy_cc"}
WAYS = ("header", "one", "composed")
COUNT = 256
WANTED = 5
"""The time of composed calls, as KSL has them, / the header's."""
SECONDS = 0.2  # of each operation and precision


def build(compiler: str, flags: str, folder: Path, loops: str = "header_kernels") -> ctypes.CDLL:
    """These loops and the functions that they call: compiled separately, without link-time
    optimisation, and called as functions of a static library are (hidden: not through the procedure
    linkage table)."""
    common = [compiler, "-std=c11", "-ffp-contract=off", "-DKSL_CONTRACT_OFF", *flags.split(),
              "-fPIC",
              "-fvisibility=hidden", "-I", str(all_headers.include())]
    (folder / "driver.c").write_text(driver(), encoding="utf-8")
    subprocess.run([compiler, "-std=c11", "-O3", "-fPIC", "-c", "driver.c", "-o", "driver.o"],
                   cwd=folder, check=True)
    objects = ["driver.o"]
    for name in ("out_of_line_vectors", "out_of_line_coscrews", loops):
        objects.append(f"{name}.o")
        subprocess.run([*common, "-c", str(HERE / f"{name}.c"), "-o", objects[-1]], cwd=folder,
                       check=True)
    path = folder / f"{compiler}{FLAGS.index(flags)}.so"
    subprocess.run([compiler, "-shared", *objects, "-o", str(path), "-lm"], cwd=folder, check=True)
    return ctypes.CDLL(str(path))


def measure(library: ctypes.CDLL) -> Iterator[tuple[tuple[str, ...], float, Bar]]:
    """A line for each operation and precision: the times, and baselines' over the header's; the
    header's time, and its bar."""
    rng = np.random.default_rng(3)
    for precision in PRECISIONS:
        arrays = [aligned(rng.uniform(-1, 1, (COUNT, size)).astype(precision.numpy_type))
                  for size in (12, 6, 6, 6)]
        for name, words in OPERATIONS.items():
            loops = [Loop(getattr(library, f"loop_{way}_{name}{precision.suffix}"), COUNT,
                          pointers(arrays)) for way in WAYS]
            header, one, composed = timed_loops(library, loops, 1e9 * SECONDS)
            ratio = composed.ratio(header)
            yield ((words, precision.name, *(span(x.time) for x in (header, one, composed)),
                    span(one.ratio(header)), span(ratio)), header.minimum,
                   Bar(f"header, array of structs: composed calls / {words}, {precision.name}",
                       WANTED, ratio))


def main() -> list[Bar]:
    """Print one table per compiler and flags."""
    bars = []
    for compiler in filter(shutil.which, ("gcc", "clang")):
        for flags in FLAGS:
            with tempfile.TemporaryDirectory() as folder:
                rows = list(measure(build(compiler, flags, Path(folder))))
            print(f"\n{compiler} {flags}: ns per call over {COUNT} aligned structs; median (95 % "
                  "interval) of rounds in which the three take turns; ratios in the same round")
            print(tabulate([row for row, _, _ in rows],
                           ("operation", "precision", "header", "one call",
                            "composed calls", "one/header", "composed/header"),
                           disable_numparse=True))
            bars += [(time, replace(bar, note=f"{compiler} {flags}")) for _, time, bar in rows]
    return fastest(bars)


if __name__ == "__main__":
    show(main())
