"""Commands write to terminals and pipes of any encoding."""

import io
import os
import subprocess
import sys

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.runtime.console import _SPELLED, any_encoding
from tests.support.scenes import scene_texts as texts

# Tables and messages show names of joints and bodies in other scripts.
SCENE = (texts.SPRING.replace('["block.mass"]', '["Körper.mass"]').replace('"block"', '"Körper"')
         .replace("[bodies.block]", '[bodies."Körper"]').replace("slide", '"Glied µ₁ дверь"')
         .replace("duration = 2", "duration = 0.02"))
COMMANDS = {"--help": 0, "simulate --help": 0, "effects": 0, "effects drag": 0, "effects ²": 2,
            "generate SCENE -o OUT/µ": 0, "generate SCENE -o OUT --check": 1, "simulate SCENE": 0,
            "simulate SCENE --verbose --set ω=1": 2, "check SCENE": 0, "check none-é.toml": 2,
            "simulate WRONG": 2, "report --op ω": 2, "cost none-é.toml": 2}
"""Commands, and how they end."""

ENCODINGS = ("ascii", "latin-1", "cp1252", "cp437", "utf-8")


@pytest.fixture
def scenes(tmp_path):
    (tmp_path / "scène.toml").write_text(SCENE, encoding="utf-8")
    (tmp_path / "wrong.toml").write_text(SCENE + '[effects.viscouß]\n', encoding="utf-8")
    return {"SCENE": str(tmp_path / "scène.toml"), "WRONG": str(tmp_path / "wrong.toml"),
            "OUT": str(tmp_path / "out")}


def words(command: str, scenes: dict[str, str]) -> list[str]:
    for name, path in scenes.items():
        command = command.replace(name, path)
    return command.split()


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_every_command_in_every_encoding(scenes, encoding, monkeypatch):
    """No character makes a command fail, and its output can be decoded."""
    for command, status in COMMANDS.items():
        out, err = io.BytesIO(), io.BytesIO()
        monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(out, encoding))
        monkeypatch.setattr(sys, "stderr", io.TextIOWrapper(err, encoding))
        try:
            ended = main(words(command, scenes))
        except SystemExit as end:
            ended = end.code
        sys.stdout.flush()
        sys.stderr.flush()
        written = out.getvalue().decode(encoding) + err.getvalue().decode(encoding)
        assert ended == status, (command, written)
        assert written and "Traceback" not in written


def test_a_process_whose_pipes_are_narrow():
    done = subprocess.run([sys.executable, "-m", "coscrew_codegen", "effects"], capture_output=True,
                          env={**os.environ, "PYTHONIOENCODING": "ascii:strict"})
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"kg m^2" in done.stdout and b"Hunt" in done.stdout and b"delta" in done.stdout


def test_what_an_encoding_lacks_is_spelled():
    raw = io.BytesIO()
    stream = io.TextIOWrapper(raw, "ascii", newline="\n")
    any_encoding(stream)
    stream.write("3 kg m², 2⁻⁵³, é, 中, \udcff, τ = 2·x ≤ …\n")
    stream.flush()
    assert raw.getvalue() == b"3 kg m^2, 2^-^5^3, e, ?, ?, tau = 2*x <= ...\n"
    assert all(text.isascii() and not key.isascii() for key, text in _SPELLED.items())


def test_what_an_encoding_has_stays():
    raw = io.BytesIO()
    stream = io.TextIOWrapper(raw, "latin-1")
    any_encoding(stream)
    stream.write("m² · é")
    stream.flush()
    assert raw.getvalue().decode("latin-1") == "m² · é"
