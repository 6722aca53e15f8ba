"""Required ratios of performance, and whether measured ones meet them."""

import platform
import shutil
import subprocess
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from os import cpu_count, getloadavg
from pathlib import Path

from tabulate import tabulate

from coscrew_codegen.reports.processor import processor
from coscrew_codegen.reports.timing.intervals import Interval
from tests.benchmarks.words import span

ROOT = Path(__file__).parents[2]
FILE = ROOT / "build" / "benchmarks.md"
WORDS = MET, MISSED, UNCLEAR, UNMEASURED = "met", "missed", "unclear", "not measured"
HEADS = ("what", "wanted", "measured: median (95 % interval)", "bar")


@dataclass(frozen=True)
class Bar:
    """A ratio that is wanted to be at least so large or, if `most`, at most; and the measured one,
    or the reason why there is none."""

    what: str
    wanted: float
    measured: Interval | None = None
    most: bool = False
    note: str = ""  # compiler, processor's instructions; the reason

    @property
    def met(self) -> str:
        """Unclear if the interval holds the bar."""
        if self.measured is None:
            return UNMEASURED
        low, high = ((self.measured.low, self.measured.high) if not self.most else
                     (-self.measured.high, -self.measured.low))
        wanted = -self.wanted if self.most else self.wanted
        return MET if low >= wanted else MISSED if high < wanted else UNCLEAR

    @property
    def row(self) -> tuple[str, str, str, str]:
        """Its line of the table."""
        got = ", ".join(x for x in (span(self.measured) if self.measured else "", self.note) if x)
        return self.what, f"{'≤' if self.most else '≥'} {self.wanted:g}", got, self.met


def fastest(results: Iterable[tuple[float, Bar]]) -> list[Bar]:
    """The bar with our least time for each `what`: that of one compiler and its flags."""
    best: dict[str, tuple[float, Bar]] = {}
    for time, bar in results:
        if bar.what not in best or time < best[bar.what][0]:
            best[bar.what] = time, bar
    return [bar for _, bar in best.values()]


def table(bars: Sequence[Bar], form: str = "simple") -> str:
    """All bars."""
    return tabulate([bar.row for bar in bars], HEADS, form, disable_numparse=True)


def summary(bars: Sequence[Bar]) -> str:
    """A line with the number of bars that are met."""
    counts = Counter(bar.met for bar in bars)
    return ", ".join(f"{count} {words}" for words in WORDS if (count := counts[words])) or "no bars"


def show(bars: Sequence[Bar]) -> None:
    """Print the table, if there are bars."""
    if bars:
        print(f"\nBars\n{table(bars)}\n\n{summary(bars)}")


def write(bars: Sequence[Bar]) -> None:
    """Write the table and the machine to build/benchmarks.md."""
    FILE.parent.mkdir(exist_ok=True)
    FILE.write_text("\n".join(("# Bars of performance", "", *(f"- {x}" for x in machine()), "",
                               table(bars, "github"), "", summary(bars), "")))


def machine() -> Iterator[str]:
    """Date and machine: processor, load, compilers."""
    load = ", ".join(f"{x:.2f}" for x in getloadavg())
    yield f"{datetime.now(UTC):%Y-%m-%d %H:%M} UTC; load of {cpu_count()} cores: {load}"
    yield f"{processor()}, {platform.system()} {platform.machine()}"
    for compiler in filter(shutil.which, ("gcc", "clang")):
        output = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True)
        yield output.stdout.splitlines()[0]
