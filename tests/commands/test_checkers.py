"""Checkers of the source code find nothing."""

import subprocess
import sys
from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from tests.support.compiled import all_headers
from tests.support.compiled.c_harness import C11, INCLUDE, run

ROOT = Path(__file__).parents[2]


def checked(*words: str | Path) -> None:
    """A checker, run as a Python module, reports nothing."""
    done = subprocess.run([sys.executable, "-m", *map(str, words)], cwd=ROOT, capture_output=True,
                          text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_ruff_finds_nothing():
    checked("ruff", "check", "--no-cache", "--output-format=concise", "codegen", "tests",
            "examples", "docs", "hatch_build.py")


def test_mypy_finds_nothing():
    checked("mypy", "--no-error-summary", "-p", "coscrew_codegen", "-p", "tests.support")


def tidy(path: Path) -> None:
    """clang-tidy finds nothing but what .clang-tidy gives reasons to leave out."""
    run(["clang-tidy", "--quiet", f"--config-file={ROOT / '.clang-tidy'}", path, "--", "-x", "c",
         *C11, "-I", INCLUDE])


@pytest.mark.parametrize("header", all_headers.AMALGAMATIONS)
def test_clang_tidy_finds_nothing_in_the_headers(header: str):
    tidy(all_headers.c_folder() / header)


def test_clang_tidy_finds_nothing_in_a_scene(tmp_path: Path):
    scene = ROOT / "examples" / "scenes" / "arm6.toml"
    assert main(["generate", str(scene), "-o", str(tmp_path)]) == 0
    tidy(tmp_path / "arm6.c")
