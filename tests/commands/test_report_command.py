"""`coscrew report` as a command: its files, refusals and messages."""

import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.reports.kernels import ranking
from coscrew_codegen.reports.kernels.report_json import SCHEMA, Report
from coscrew_codegen.reports.kernels.variants import variants_of
from tests.support.processes import interruptible

FEW = ["report", "--op", "dot_cs", "--op", "vec3_l2norm", "--minutes", "0.02"]
BY_NAME = {operation.name: operation for operation in OPERATIONS}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a small report."""
    folder = tmp_path_factory.mktemp("report")
    assert main([*FEW, "--output", str(folder)]) == 0
    return folder


def test_the_report_holds_what_was_asked(made: Path):
    text = (made / "report.json").read_text()
    report = Report.from_json(text)
    assert Report.from_json(report.to_json()) == report
    assert report.to_json() == text
    wanted = {(v.operation.name, p.name, v.tier) for name in ("dot_cs", "vec3_l2norm")
              for p in PRECISIONS for v in variants_of(BY_NAME[name], p)}
    assert {(e.operation, e.precision, e.tier) for e in report.entries} == wanted
    for entry in report.entries:
        layouts = {t.layout for t in entry.times if t.language == "C"}
        assert layouts == {"array of structs", "structure of arrays", "latency"}
        assert all(0 < t.minimum <= t.low <= t.ns <= t.high and t.rounds >= 6
                   for t in entry.times)
        assert all(t.ratio_low <= t.ratio <= t.ratio_high for t in entry.times if t.ratio)
        assert entry.benign.median <= entry.benign.p999 <= entry.benign.worst
        assert not entry.bound or 0 < entry.bound.worst_ratio <= 1
    accurate = next(e for e in report.entries if (e.operation, e.precision, e.tier)
                    == ("dot_cs", "double", "accurate"))
    assert accurate.hard.worst < 0.6 and len(accurate.condition) > 20
    assert report.provenance.command == "coscrew report --op dot_cs --op vec3_l2norm " \
                                        "--minutes 0.02 --seed 1"
    assert "/" not in report.provenance.cpu and str(Path.home()) not in text
    assert not [p.name for p in made.iterdir() if p.name.startswith(".")]


def test_a_comparison_names_file_and_ratio(made: Path, tmp_path: Path):
    report = Report.from_json((made / "report.json").read_text())
    result = ranking.compared(report, report, "before.json")
    assert result.file == "before.json" and {row.ratio for row in result.rows} == {1.0}
    slower = replace(report, entries=tuple(
        replace(e, times=tuple(replace(t, ns=3 * t.ns) for t in e.times)) for e in report.entries))
    rows = ranking.compared(report, slower, "").rows
    assert {round(r.ratio, 9) for r in rows if r.what.startswith("ns")} == {3.0}


@pytest.mark.parametrize("change", [
    ("schema", 1), ("entries", {}), ("provenance", None), ("drift", [{"precision": "double"}])])
def test_a_report_that_is_none_is_refused(made: Path, change: tuple[str, object]):
    result = json.loads((made / "report.json").read_text())
    result[change[0]] = change[1]
    with pytest.raises(ValueError, match=f"schema {SCHEMA}|{change[0]}"):
        Report.from_json(json.dumps(result))


def test_wrong_options_are_refused_before_measuring(tmp_path: Path,
                                                   capsys: pytest.CaptureFixture[str]):
    (tmp_path / "cases.txt").write_text("# fine\ndot_cs double : 0x1p0 : here\n")
    (tmp_path / "no.json").write_text("{}")
    output = ["--output", str(tmp_path / "out")]
    for words, message in ((["--op", "product_CoAd"], "did you mean 'product_CoAdc'?"),
                           (["--minutes", "0"], "--minutes: wanted a positive number; got 0.0"),
                           (["--minutes", "nan"], "--minutes"), (["--seed", "-1"], "--seed"),
                           (["--compare", str(tmp_path / "none")], "cannot read"),
                           (["--compare", str(tmp_path / "no.json")], "is no report"),
                           (["--hard-cases", str(tmp_path / "none")], "wanted a folder"),
                           (["--hard-cases", str(tmp_path)], "cases.txt:2"),
                           (["--output", str(tmp_path / "no.json")], "cannot write")):
        assert main([*FEW, *output, *words]) == 2
        assert message in capsys.readouterr().err
    assert not (tmp_path / "out" / "report.json").exists()


def command(tmp_path: Path, before: str = "") -> list[str]:
    """A report in a process of its own."""
    words = [*FEW, "--output", str(tmp_path / "out")]
    return [sys.executable, "-c", f"import sys; {before}\n"
            "from coscrew_codegen.__main__ import main\n"
            f"if __name__ == '__main__': sys.exit(main({words!r}))"]


def test_without_a_compiler_python_is_measured(tmp_path: Path):
    done = subprocess.run(command(tmp_path), env={**os.environ, "PATH": str(tmp_path)}, text=True,
                          capture_output=True)
    assert done.returncode == 0, done.stderr
    assert "no C compiler works here" in done.stderr
    report = Report.from_json((tmp_path / "out" / "report.json").read_text())
    assert report.provenance.compilers == () == report.drift
    assert {t.language for e in report.entries for t in e.times} == {"Python"}
    assert {e.tier for e in report.entries} >= {"plain", "accurate"}


def test_without_gmpy2_it_says_what_to_install(tmp_path: Path):
    done = subprocess.run(command(tmp_path, "sys.modules['gmpy2'] = None"), text=True,
                          capture_output=True)
    assert done.returncode == 2
    assert 'needs gmpy2; run `pip install "coscrew[report]"`' in done.stderr


def test_an_interrupt_leaves_no_half_report(tmp_path: Path):
    words = command(tmp_path)
    words[-1] = words[-1].replace("'0.02'", "'5'")
    with interruptible(words, stderr=subprocess.PIPE) as running:
        while not (tmp_path / "out").exists():
            time.sleep(0.05)
        time.sleep(3)
        running.send_signal(signal.SIGINT)
        _, message = running.communicate(timeout=300)
    assert running.returncode == 130 and "interrupted" in message and "Traceback" not in message
    assert not list((tmp_path / "out").iterdir())
