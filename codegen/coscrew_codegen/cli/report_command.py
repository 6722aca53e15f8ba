"""`coscrew report`: options, report.json, the page, a short table.

Imports the measurement only when it runs, since the generator does not need it."""

import argparse
import math
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.cli.name_lists import Names
from coscrew_codegen.reports.kernels import ReportError

if TYPE_CHECKING:
    from coscrew_codegen.reports.kernels.report_json import Report


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `report` to the command line."""
    parser = commands.add_parser(
        "report", help="measure errors and times on this machine",
        description="Measure every kernel's errors, against exact results, and times.")
    parser.add_argument("--op", metavar="NAME", action=Names, default=[],
                        help="only these operations; several with commas, or repeated")
    parser.add_argument("--minutes", type=float, default=2.0, metavar="M",
                        help="about how long to measure (default: 2)")
    parser.add_argument("--seed", type=int, default=1, metavar="N",
                        help="seed of the inputs (default: 1)")
    parser.add_argument("--output", metavar="DIR", default="build/report",
                        help="folder to write to (default: build/report)")
    parser.add_argument("--compare", metavar="FILE", help="an earlier report.json")
    parser.add_argument("--hard-cases", metavar="DIR", help="folder of further hard inputs, *.txt")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Measure and write the report; returns the exit status."""
    from coscrew_codegen.backends.emit import write
    from coscrew_codegen.backends.selection import operations_named
    from coscrew_codegen.reports.kernels import inputs, kernel_measurement, ranking, report_page

    if not (math.isfinite(options.minutes) and options.minutes > 0):
        raise ReportError(f"--minutes: wanted a positive number; got {options.minutes}")
    if options.seed < 0:
        raise ReportError(f"--seed: wanted an integer from 0 on; got {options.seed}")
    operations = operations_named(options.op)
    before = _earlier(options.compare) if options.compare else None
    folder = Path(options.output)
    _writable(folder)
    corpus = inputs.corpus(_folder(options.hard_cases)) if options.hard_cases else {}
    words = ["coscrew report", *(f"--op {name}" for name in options.op),
             f"--minutes {options.minutes:g}", f"--seed {options.seed}"]
    report = kernel_measurement.measure(kernel_measurement.MeasurementPlan(
        operations, options.minutes, options.seed, corpus, " ".join(words)))
    if before:
        report = replace(report, compare=ranking.compared(before, report,
                                                          Path(options.compare).name))
    write({"report.json": report.to_json()}, folder)
    made = [folder / "report.json", *report_page.write(report, folder, tuple(options.op))]
    print(report_page.summary(report, kernel_measurement.SHOWN))
    print("\n".join(map(str, made)))
    return 0


def _earlier(name: str) -> "Report":
    from coscrew_codegen.reports.kernels.report_json import Report

    try:
        return Report.from_json(Path(name).read_text(encoding="utf-8"))
    except OSError as error:
        raise ReportError(f"--compare: cannot read {name}: {error.strerror}") from None
    except ValueError as error:
        raise ReportError(f"--compare: {name} is no report: {error}") from None


def _folder(name: str) -> Path:
    if not Path(name).is_dir():
        raise ReportError(f"--hard-cases: wanted a folder; got {name!r}")
    return Path(name)


def _writable(folder: Path) -> None:
    """Raise EmitError if the report cannot be written; called before measuring."""
    from coscrew_codegen.backends.emit import EmitError

    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise EmitError(f"cannot write {folder}: {error.strerror}; nothing was measured") from error
