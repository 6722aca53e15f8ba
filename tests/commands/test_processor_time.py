"""`pytest -p tests.support.processor_time` says which files take how much processor time."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
BUSY = "import time\nwhile time.process_time() < {}: pass"
TESTS = f"""
import subprocess, sys, time

def test_python():
    end = time.process_time() + 0.5
    while time.process_time() < end: pass

def test_a_process():
    time.sleep(0.1)
    subprocess.run([sys.executable, "-c", {BUSY.format(0.7)!r}])
"""


@pytest.mark.parametrize("workers", [("-p", "no:xdist"), ("-n", "2")], ids=["one", "two"])
def test_tests_and_what_they_start_are_summed_by_file(tmp_path: Path, workers: tuple[str, ...]):
    for name in ("busy", "idle"):
        (tmp_path / f"test_{name}.py").write_text(TESTS if name == "busy" else
                                                  "def test_nothing():\n    pass\n")
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "--rootdir", str(tmp_path), *workers, "-p",
         "no:cacheprovider", "-p", "tests.support.processor_time", str(tmp_path)],
        cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    rows = {words[0]: words[1:] for words in map(str.split, done.stdout.splitlines()) if words}
    own, children = map(float, rows["test_busy.py"])
    assert 0.5 <= own < 5 and 0.7 <= children < 5
    assert "test_idle.py" not in rows and float(rows["all"][0]) >= own
