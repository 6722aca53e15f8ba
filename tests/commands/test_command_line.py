"""Commands end by an interrupt, or when the reader of their output closes it."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from tests.support.processes import interruptible
from tests.support.scenes import scene_texts as texts

INTERRUPTED_AT = """
import os, signal, sys

class Watch:
    def find_spec(self, name, path=None, target=None):
        if name == {module!r}:
            os.kill(os.getpid(), signal.SIGINT)

sys.meta_path.insert(0, Watch())
from coscrew_codegen.__main__ import main
sys.exit(main(["effects"]))
"""


@pytest.mark.parametrize("module", ("tqdm", "sympy", "coscrew_codegen.scene.readers.effect_syntax"))
def test_an_interrupt_while_modules_are_imported_is_told_in_a_line(module):
    words = (sys.executable, "-c", INTERRUPTED_AT.format(module=module))
    with interruptible(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        out, message = process.communicate(timeout=120)
    assert (process.returncode, out, message) == (130, "", "coscrew: interrupted\n")


@pytest.mark.parametrize("command", ("simulate", "check"))
def test_commands_that_fail_wait_for_no_compiler(tmp_path, command):
    """Even if it never answers; it is ended with the command."""
    compiler = tmp_path / "hanging"
    compiler.write_text(f"#!/bin/sh\necho $$ > '{tmp_path}/pid'\nexec sleep 600\n")
    compiler.chmod(0o755)
    done = subprocess.run([sys.executable, "-m", "coscrew_codegen", command, "none.toml"],
                          cwd=tmp_path, env={**os.environ, "CC": str(compiler)}, timeout=120,
                          capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "coscrew: none.toml: cannot be read (No such file or directory)\n"
    pid = tmp_path / "pid"
    if pid.exists() and (written := pid.read_text()):  # it may be ended before it writes
        with pytest.raises(ProcessLookupError):
            os.kill(int(written), 0)


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="only Linux has a full device")
def test_output_that_cannot_be_written_is_told_in_a_line():
    with open("/dev/full", "w") as full:
        done = subprocess.run([sys.executable, "-m", "coscrew_codegen", "effects"], stdout=full,
                              stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (2, "coscrew: cannot write: No space left on device\n")


def test_other_files_that_fail_are_named(monkeypatch, capsys):
    def fail(words: list[str]) -> int:
        Path("/nowhere/at/all").read_text()
        return 0

    monkeypatch.setattr("coscrew_codegen.__main__._run", fail)
    monkeypatch.setattr("coscrew_codegen.__main__._give_up_output", lambda: None)
    assert main(["effects"]) == 2
    assert capsys.readouterr().err == "coscrew: /nowhere/at/all: No such file or directory\n"


def test_an_actuator_without_a_kind_is_told_which_there_are(tmp_path, capsys):
    scene = tmp_path / "scene.toml"
    scene.write_text(texts.PENDULUM + "[effects.actuator.hinge]\ntorque = 1\n")
    assert main(["check", str(scene)]) == 2
    assert "effects.actuator.hinge.kind: missing; wanted kind of actuator: torque, pd, dc" \
        in capsys.readouterr().err


@pytest.mark.parametrize("command", ("effects", "simulate SCENE", "check SCENE",
                                     "cost SCENE --until 0.1"))
def test_a_closed_pipe_is_no_error(tmp_path, command):
    """A closed pipe ends the command without a message."""
    scene = tmp_path / "scene.toml"
    scene.write_text(texts.SPRING)
    read, write = os.pipe()
    os.close(read)  # as `head` does when it has enough
    words = [str(scene) if x == "SCENE" else x for x in command.split()]
    with os.fdopen(write, "w") as closed:
        done = subprocess.run([sys.executable, "-m", "coscrew_codegen", *words], stdout=closed,
                              stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (128 + signal.SIGPIPE, "")
