"""While a scene is derived and compiled, terminals show the progress; files and pipes do not."""

import os
import pty
import subprocess
import sys
from pathlib import Path

import pytest

SCENE = """[bodies]
bob = { mass = 2, com = [0, 0, -0.5], inertia = [0.01, 0.01, 0.01] }
[joints.pivot]
type = "revolute"
child = "bob"
axis = [0, 1, 0]
[effects.gravity]
"""
ERASED = "\r\x1b[K"


@pytest.fixture
def words(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    path = tmp_path / "swing.toml"
    path.write_text(SCENE)
    return [sys.executable, "-m", "coscrew_codegen", "simulate", str(path), "--until", "0.01"]


def on_a_terminal(words: list[str]) -> str:
    """Runs the command; returns its output to standard error, a terminal."""
    reader, writer = pty.openpty()
    with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=writer) as process:
        os.close(writer)
        message = b""
        while True:
            try:
                more = os.read(reader, 1000)
            except OSError:  # Linux's error when the other end is closed
                break
            if not more:
                break
            message += more
    os.close(reader)
    assert process.returncode == 0
    return message.decode()


def test_terminals_are_told_what_goes_on(words: list[str]):
    """First that a scene is derived, then each function, then the compiler; the line is cleared at
    the end.  If the cache has everything, nothing is shown."""
    message = on_a_terminal(words)
    parts = message.split(ERASED)
    assert parts[1] == "deriving swing …"
    wanted = ["deriving energy …", "deriving midpoint_acceleration …", "compiling double …"]
    assert [x for x in parts if x in wanted] == wanted
    assert "…" not in parts[-1]
    assert "deriving" not in on_a_terminal(words) and "compiling" not in on_a_terminal(words)


def test_files_and_pipes_are_not_told(words: list[str]):
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    assert done.stderr == ""
