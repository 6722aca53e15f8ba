"""Header kernels in a loop over arrays of structs against out-of-line calls of a static library."""

import csv
import io
import shutil
import subprocess
import tempfile
from pathlib import Path

from tabulate import tabulate

HERE = Path(__file__).parent
INCLUDE = HERE.parents[1] / "generated" / "c" / "include"
FLAGS = ("-O3", "-O3 -march=native")


def build(compiler: str, flags: str, folder: Path) -> Path:
    """The benchmark program, its baseline compiled apart and without link-time optimisation."""
    common = [compiler, "-std=c11", "-ffp-contract=off", *flags.split(), "-I", str(INCLUDE)]
    objects = []
    for name in ("out_of_line_vectors", "out_of_line_coscrews", "header_kernels"):
        objects.append(str(folder / f"{name}.o"))
        subprocess.run([*common, "-c", str(HERE / f"{name}.c"), "-o", objects[-1]], check=True)
    library = str(folder / "libbaseline.a")
    Path(library).unlink(missing_ok=True)
    subprocess.run(["ar", "rcs", library, *objects[:2]], check=True)
    program = folder / "header_kernels"
    subprocess.run([compiler, objects[2], library, "-o", str(program), "-lm"], check=True)
    return program


def measure(program: Path) -> dict[tuple[str, str], dict[str, tuple[float, float]]]:
    """{(operation, precision): {variant: (minimum, median)}} in ns per call."""
    rows = csv.reader(io.StringIO(subprocess.run([str(program)], check=True, capture_output=True,
                                                 text=True).stdout.replace(", ", "; ")))
    found: dict[tuple[str, str], dict[str, tuple[float, float]]] = {}
    for operation, precision, variant, minimum, median in rows:
        found.setdefault((operation.replace("; ", ", "), precision), {})[variant] = (
            float(minimum), float(median))
    return found


def main() -> None:
    """Print one table per compiler and flags."""
    for compiler in filter(shutil.which, ("gcc", "clang")):
        for flags in FLAGS:
            with tempfile.TemporaryDirectory() as folder:
                found = measure(build(compiler, flags, Path(folder)))
            rows = [(operation, precision, header[0], f"{header[1] / header[0] - 1:.0%}",
                     one[0], composed[0], one[0] / header[0], composed[0] / header[0])
                    for (operation, precision), variants in found.items()
                    for header, one, composed in [(variants["header"], variants["one call"],
                                                   variants["composed calls"])]]
            print(f"\n{compiler} {flags}: ns per call, minimum of many; spread is median over "
                  "minimum; ratios are baseline / header")
            print(tabulate(rows, ("operation", "precision", "header", "spread", "one call",
                                  "composed calls", "one/header", "composed/header"),
                           floatfmt=".2f"))


if __name__ == "__main__":
    main()
