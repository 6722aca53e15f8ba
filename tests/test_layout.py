"""Test modules are in folders by subject, and shared code is in support/."""

import ast
import os
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

import coscrew
from tests.conftest import LONG

TESTS = Path(__file__).parent
SUBJECTS = ("laws", "emitted", "tiers", "elementary", "scenes", "commands", "peers")


@cache
def modules() -> dict[Path, ast.Module]:
    """All files of tests, parsed: by the worker that runs these tests, not by each at its start."""
    return {path: ast.parse(path.read_text(encoding="utf-8")) for path in TESTS.rglob("*.py")}


def is_test(path: Path) -> bool:
    return path.name.startswith("test_")


def imported(tree: ast.Module) -> set[str]:
    """The modules that a module imports, also inside functions."""
    results = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import)
               for alias in node.names}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            module = "." * node.level + (node.module or "")
            results |= {module, *(f"{module}.{alias.name}" for alias in node.names)}
    return results


def test_tests_stand_in_the_folder_of_their_subject():
    allowed = {TESTS / folder for folder in SUBJECTS}
    stray = {str(path.relative_to(TESTS)) for path in modules()
             if is_test(path) and path != Path(__file__) and path.parent not in allowed}
    assert not stray, f"move {sorted(stray)} to one of tests/{{{','.join(SUBJECTS)}}}"
    for folder in SUBJECTS:
        assert any(map(is_test, (TESTS / folder).iterdir())), folder


def test_no_module_imports_a_test():
    for path, tree in modules().items():
        tests = {name for name in imported(tree) if ".test_" in f".{name}"}
        assert not tests, f"{path.relative_to(TESTS)}: move what it needs of {tests} to support/"


def test_support_holds_no_test():
    for path, tree in modules().items():
        if not is_test(path):
            named = [node.name for node in ast.walk(tree)
                     if isinstance(node, ast.FunctionDef | ast.ClassDef)
                     and node.name.startswith(("test_", "Test"))]
            assert not named, f"{path.relative_to(TESTS)}: nothing collects {named}"


def test_folders_say_what_they_hold():
    for folder in {path.parent for path in modules()}:
        assert (folder / "__init__.py").exists(), f"{folder} has no __init__.py"
        assert ast.get_docstring(modules()[folder / "__init__.py"]), f"{folder}: no docstring"


def test_what_quick_leaves_out_is_there():
    assert {path.stem for path in modules() if is_test(path)} >= LONG


def collected(site: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """pytest, collecting this file with the coscrew in `site`."""
    return subprocess.run(
        [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "--collect-only", "-q", *words,
         str(Path(__file__))], cwd=TESTS.parent, env={**os.environ, "PYTHONPATH": str(site)},
        capture_output=True, text=True)


def test_extensions_of_other_kernels_end_the_session_at_once(tmp_path: Path):
    package = shutil.copytree(Path(coscrew.__file__).parent, tmp_path / "coscrew",
                              ignore=shutil.ignore_patterns("_gufunc*", "__pycache__"))
    (package / "certified" / "_gufunc.py").write_text('PROVENANCE = "of other kernels"\n')
    done = collected(tmp_path)
    assert done.returncode == pytest.ExitCode.USAGE_ERROR
    output = done.stdout + done.stderr
    assert output.count("make build") == 1 and output.count("stale-extensions") == 1
    assert "coscrew.certified runs in pure NumPy" in output and "from other kernels" in output
    assert collected(tmp_path, "--stale-extensions").returncode == 0
