"""What accuracy costs in time: the tiers on structures of arrays in the first-level cache."""

import csv
import io
import shutil
import subprocess
import tempfile
from pathlib import Path

from tabulate import tabulate

HERE = Path(__file__).parent
INCLUDE = HERE.parents[1] / "generated" / "c" / "include"
FLAGS = ("-std=c11", "-O3", "-march=native", "-ffp-contract=off")


def measure(compiler: str) -> dict[tuple[str, str], dict[str, tuple[float, float]]]:
    """{(operation, precision): {tier: (minimum, median)}} in ns per element."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "tiers"
        subprocess.run([compiler, *FLAGS, "-I", str(INCLUDE), str(HERE / "tiers.c"), "-o",
                        str(program), "-lm"], check=True)
        printed = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout
    found: dict[tuple[str, str], dict[str, tuple[float, float]]] = {}
    for operation, precision, tier, minimum, median in csv.reader(io.StringIO(printed)):
        found.setdefault((operation, precision), {})[tier] = (float(minimum), float(median))
    return found


def main() -> None:
    """Print one table per compiler."""
    for compiler in filter(shutil.which, ("gcc", "clang")):
        rows = [(*key, tier, minimum, f"{median / minimum - 1:.0%}", minimum / tiers["plain"][0])
                for key, tiers in measure(compiler).items()
                for tier, (minimum, median) in tiers.items()]
        print(f"\n{compiler} {' '.join(FLAGS)}: ns per element, minimum of many; spread is median "
              "over minimum; ratio is time / plain's")
        print(tabulate(rows, ("operation", "precision", "tier", "ns", "spread", "ratio"),
                       floatfmt=".2f"))


if __name__ == "__main__":
    main()
