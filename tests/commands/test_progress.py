"""Progress where standard error is no terminal: lines, and the files after SIGTERM."""

import re
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pyarrow.parquet
import pytest

from coscrew_codegen.__main__ import TERMINATED, main
from coscrew_codegen.runtime import console
from coscrew_codegen.simulation.sweep import prepare
from tests.support.processes import interruptible
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.simulated import scene_file
from tests.support.scenes.sweeps import SLIDER
from tests.support.sweeping import VARIED


def test_long_runs_tell_each_tenth_in_a_line(tmp_path, monkeypatch, capsys):
    scene = scene_file(tmp_path, texts.PENDULUM)
    assert main(["simulate", str(scene), "--precision", "double"]) == 0
    assert " %: " not in capsys.readouterr().err  # it is short
    monkeypatch.setattr(console, "_QUIET", 0.0)
    assert main(["simulate", str(scene), "--precision", "double"]) == 0
    lines = [x for x in capsys.readouterr().err.splitlines() if " %: " in x]
    assert [x.partition(" %")[0] for x in lines] == [f"coscrew: {n}0" for n in range(1, 10)]
    assert re.fullmatch(r"coscrew: 40 %: t 4/10 s  40 %  \S+x real time  dE/E \d+e[-+]\d+  "
                        r"ETA \d+ s", lines[3])


def test_tenths_are_told_once_and_only_after_some_seconds(monkeypatch, capsys):
    now = [100.0]
    monkeypatch.setattr(time, "monotonic", lambda: now[0])
    tenths = console.Tenths()
    for share, seconds in ((0.1, 1), (0.15, 1), (0.35, 3), (0.39, 4), (0.4, 5), (0.99, 6), (1, 7)):
        now[0] = 100.0 + seconds
        tenths(share, lambda: f"at {share}")  # noqa: B023  called at once
    assert capsys.readouterr().err.splitlines() == [
        "coscrew: 30 %: at 0.35", "coscrew: 40 %: at 0.4", "coscrew: 90 %: at 0.99"]


def test_sweeps_tell_each_tenth_and_what_is_written_at_the_end(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(console, "_QUIET", 0.0)
    monkeypatch.setattr(prepare, "_STEPS", (1, 50_000_000))
    out = tmp_path / "out"
    words = ["sweep", str(scene_file(tmp_path, SLIDER)), *VARIED, "--workers", "1", "--out",
             str(out)]
    assert main(words) == 0
    unused, first, *lines, last = capsys.readouterr().err.splitlines()
    assert unused.startswith("coscrew: not used: ")
    assert first == "coscrew: 600 members, 0 of them written"
    assert last == f"coscrew: 600 of 600 members written into {out}"
    shares = [re.fullmatch(r"coscrew: (\d+) %: (\d+) of 600 members written", x) for x in lines]
    assert len(shares) >= 8
    assert all(int(x[1]) == 10 * (int(x[2]) // 60) for x in shares)
    assert main(words) == 0
    assert capsys.readouterr().err == f"{unused}\ncoscrew: 600 members, 600 of them written\n"


def test_sigterm_keeps_what_was_sampled_and_says_where(tmp_path):
    text = texts.PENDULUM.replace("duration = 10", "duration = 3e3").replace(
        "every = 0.05", "every = 1").replace("step = 1e-3", "step = 1e-5")
    output = tmp_path / "out.csv"
    words = [sys.executable, "-m", "coscrew_codegen", "simulate", scene_file(tmp_path, text),
             "--precision", "double", "--output", output]
    with interruptible(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        first = process.stderr.readline()
        process.terminate()
        out = process.communicate(timeout=300)[1]
    assert process.returncode == TERMINATED == 128 + signal.SIGTERM, out
    at, reached = re.match(r"coscrew: (\d)0 %: t ([\d.]+)/3000 s  \d+ %  ", first).groups()
    assert int(at) == float(reached) // 300  # lines come from the run's second second on
    rows = [x for x in output.read_text().splitlines() if not x.startswith("#")][1:]
    assert re.search(rf"interrupted after t = \d+ s; {len(rows)} samples kept in {output}\n", out)
    assert "Traceback" not in out


def test_sigterm_says_what_a_sweep_has_written(tmp_path):
    out = tmp_path / "out"
    words = [sys.executable, "-m", "coscrew_codegen", "sweep", scene_file(tmp_path, SLIDER),
             *VARIED[:-1], "1e8", "--workers", "1", "--out", out]
    with interruptible(words, stderr=subprocess.PIPE) as process:
        while not list(out.glob("members/part*")) and process.poll() is None:
            with suppress(subprocess.TimeoutExpired):
                process.wait(0.05)
        process.terminate()
        text = process.communicate(timeout=300)[1]
    assert process.returncode == TERMINATED, text
    (count,) = re.findall(rf"interrupted; (\d+) of 300000000 members are written into {out}", text)
    rows = [pyarrow.parquet.read_metadata(x).num_rows for x in (out / "members").iterdir()]
    assert sum(rows) == int(count) > 0 and "Traceback" not in text


@pytest.mark.parametrize("command", ("effects", "simulate"))
def test_sigterm_while_a_command_starts_is_told_in_a_line(command, tmp_path):
    words = (sys.executable, "-c", STOPPED.format(command=command, scene=Path("none.toml")))
    with interruptible(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        out, message = process.communicate(timeout=120)
    assert (process.returncode, out, message) == (TERMINATED, "", "coscrew: interrupted\n")


STOPPED = """
import os, signal, sys

class Watch:
    def find_spec(self, name, path=None, target=None):
        if name == "coscrew_codegen.cli.command_line":
            os.kill(os.getpid(), signal.SIGTERM)

sys.meta_path.insert(0, Watch())
from coscrew_codegen.__main__ import main
sys.exit(main(["{command}", "{scene}"]))
"""
