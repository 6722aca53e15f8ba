"""Cost of accuracy in time: the tiers on structures of arrays in the first-level cache.

The loops, the buffers and the rounds are those of `coscrew report`."""

import tempfile
from collections.abc import Iterator
from pathlib import Path

from tabulate import tabulate

from coscrew_codegen.backends.selection import operations_named
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.reports.kernels import inputs
from coscrew_codegen.reports.kernels.c_text import Variant
from coscrew_codegen.reports.kernels.kernel_library import KernelLibrary, compilers, libraries
from coscrew_codegen.reports.kernels.kernel_timing import contests
from coscrew_codegen.reports.kernels.variants import variants_of
from tests.benchmarks.words import span

NAMES = ("product_CoAdc", "cross_sc", "dot_cs")
SECONDS = 0.5  # of each operation and precision


def rows(library: KernelLibrary, variants: list[Variant]) -> Iterator[tuple[str, ...]]:
    """A line for each variant: its time, and the ratio to the plain tier's time in the same round.
    """
    for rivals in contests(variants):
        drawn = [inputs.split(v.operation, inputs.benign(v.operation, v.precision, v.elements, 1))
                 for v in rivals]
        timings = library.times(rivals, "planes", drawn, 1e9 * SECONDS)
        for v, timing in zip(rivals, timings, strict=True):
            yield (v.operation.name, v.precision.name, v.tier, span(timing.time),
                   f"{timing.minimum:.3g}", span(timing.ratio(timings[0])),
                   f"{timing.minimum / timings[0].minimum:.3g}")


def main() -> None:
    """Print one table per compiler."""
    variants = [v for operation in operations_named(list(NAMES)) for precision in PRECISIONS
                for v in variants_of(operation, precision)]
    with tempfile.TemporaryDirectory() as folder:
        for library in libraries(variants, compilers(Path(folder)), Path(folder)):
            print(f"\n{library.compiler.name} {library.compiler.flags}: ns per element, every "
                  "component a plane, aligned to 64 bytes; median (95 % interval) of rounds in "
                  "which the tiers take turns; ratio: to plain in the same round, and of minima")
            print(tabulate(rows(library, variants), ("operation", "precision", "tier", "ns",
                                                     "minimum", "ratio", "of minima"),
                           disable_numparse=True))


if __name__ == "__main__":
    main()
