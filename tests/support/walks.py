"""CONTRIBUTING.md's walks: their additions, and copies of the generator with these."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import coscrew_codegen
from coscrew_codegen.backends.render import GENERATED, TEMPLATES

GUIDE = Path(__file__).parents[2] / "CONTRIBUTING.md"
_BLOCK = re.compile(r"```\w+\n(?:#|\{#) (codegen/coscrew_codegen|templates)/(\S+?)"
                    r"(?:, in (\w+))?(?: #\})?\n(.*?)```", re.DOTALL)
"""Folder, file, the table in it that gets the entry if it is one, text."""


def copied(folder: Path) -> Path:
    """A copy of the generator, its templates and the generated headers in this folder: the package.

    With its bytecode, and with the meanings of its sources: to make these takes 2.5 s.  Files that
    other processes are writing are left out."""
    package = folder / "coscrew_codegen"
    unfinished = shutil.ignore_patterns("*.pyc.*", ".building-*")
    shutil.copytree(Path(coscrew_codegen.__file__).parent, package, ignore=unfinished)
    shutil.copytree(TEMPLATES, package / "templates")
    shutil.copytree(GENERATED / "c", folder / "coscrew" / "c")
    return package


def command(site: Path, *words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """`coscrew` of the copy of the generator in this folder, where its cache is too."""
    return subprocess.run(
        [sys.executable, "-m", "coscrew_codegen", *words], cwd=site, text=True, capture_output=True,
        env={**os.environ, "PYTHONPATH": str(site), "XDG_CACHE_HOME": str(site / "cache"),
             **environment})


def generated(site: Path, *words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """`coscrew generate` of that copy."""
    return command(site, "generate", *words, **environment)


def run_in_copy(site: Path, program: str) -> str:
    """Runs a program with the copy of the generator in this folder; returns its output."""
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=site, text=True, capture_output=True,
        env={**os.environ, "PYTHONPATH": str(site), "XDG_CACHE_HOME": str(site / "cache")})
    assert done.returncode == 0, done.stderr
    return done.stdout


def walk(package: Path, *names: str) -> list[Path]:
    """Adds the walks' files of these names to the package: new ones, or an entry of a table.  Their
    paths."""
    added = []
    for folder, name, table, text in _BLOCK.findall(GUIDE.read_text(encoding="utf-8")):
        if Path(name).name.partition(".")[0] not in names:
            continue
        path = package / (folder if folder == "templates" else "") / name
        if table:
            before = path.read_text(encoding="utf-8")
            start = f"\n{table} = (\n"
            assert before.count(start) == 1, f"{name} has no {table} to which walks could add"
            text = before.replace(start, start + text)
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
        added.append(path)
    assert {path.name.partition(".")[0] for path in added} == set(names), f"{GUIDE.name}: {names}"
    return added
