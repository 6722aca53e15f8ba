"""Checkers of the source code find nothing."""

import keyword
import re
import subprocess
import sys
import sysconfig
import tomllib
from collections.abc import Iterable
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path

import jax
import numpy as np
import pytest
from jinja2 import Environment
from vulture import Vulture

from coscrew_codegen.__main__ import main
from coscrew_codegen.backends.render import TEMPLATES
from tests.support.compiled import all_headers
from tests.support.compiled.c_harness import C11, INCLUDE, STRICT, run
from tests.support.each import each_compiler

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


def used_elsewhere() -> set[str]:
    """The names that templates, scripts of pages and examples of the documents use."""
    lexed = (Environment().lex(path.read_text("utf-8"))
             for path in (ROOT / "templates").rglob("*.jinja"))
    results = {text for tokens in lexed for _, kind, text in tokens if kind == "name"}
    scripts = (*(ROOT / "templates").rglob("*.js"), *(ROOT / "web/src").glob("*.js"))
    for path in (x for x in scripts if not x.name.endswith(".min.js")):
        results.update(re.findall(r"[^\W\d]\w*", path.read_text("utf-8")))
    for path in (*(ROOT / "docs").glob("*.md"), ROOT / "README.md", ROOT / "CONTRIBUTING.md"):
        for block in re.findall(r"```python\n(.*?)```", path.read_text("utf-8"), re.S):
            results.update(re.findall(r"[^\W\d]\w*", block))
    return {name for name in results if name.isidentifier() and not keyword.iskeyword(name)}


def unused(folders: Iterable[str]) -> dict[str, str]:
    """Names that nothing in these folders uses, and the place and kind of each."""
    checker = Vulture(ignore_decorators=["@pytest.fixture*"])
    checker.scavenge([ROOT / folder for folder in folders])
    checker.scan("\n".join(f"_.{name}" for name in sorted(used_elsewhere())))
    return {x.name: f"{x.filename.relative_to(ROOT)}:{x.first_lineno}: {x.message}"
            for x in checker.get_unused_code(min_confidence=60)}


def ignored_names() -> tuple[str, ...]:
    config = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    return tuple(config["tool"]["vulture"]["ignore_names"])


def test_vulture_finds_nothing():
    """Nothing in the tests is dead, and nothing in the generator that only tests use; no exception
    is left over."""
    built = ("codegen", "hatch_build.py")
    result = unused(built) | unused((*built, "tests", "examples"))
    patterns = ignored_names()
    assert [place for name, place in result.items()
            if not any(fnmatchcase(name, x) for x in patterns)] == []
    assert [x for x in patterns if not any(fnmatchcase(name, x) for name in result)] == []


def test_names_that_vulture_ignores_have_reasons():
    text = (ROOT / "pyproject.toml").read_text("utf-8")
    lines = text.partition("ignore_names = [\n")[2].partition("\n]")[0].splitlines()
    assert [x for x in lines if not re.fullmatch(r' +("[\w*]+",\s+)+# \w.+', x)] == []


def tidy(path: Path, *flags: str) -> None:
    """clang-tidy finds nothing but what .clang-tidy gives reasons to leave out."""
    run(["clang-tidy", "--quiet", f"--config-file={ROOT / '.clang-tidy'}", path, "--", "-x", "c",
         *C11, "-I", INCLUDE, *flags])


@pytest.mark.parametrize("header", all_headers.AMALGAMATIONS)
def test_clang_tidy_finds_nothing_in_the_headers(header: str):
    tidy(all_headers.c_folder() / header)


def test_clang_tidy_finds_nothing_in_a_scene(tmp_path: Path):
    scene = ROOT / "examples" / "scenes" / "arm6.toml"
    assert main(["generate", str(scene), "-o", str(tmp_path)]) == 0
    for name in ("arm6.c", "arm6f.c"):
        tidy(tmp_path / name)


RUNTIME = sorted(path.relative_to(TEMPLATES).as_posix()
                 for path in (TEMPLATES / "runtime").rglob("*.[ch]"))
PRECISION_MACROS = ("-DSINGLE_PRECISION=0", "-DSINGLE_PRECISION=1")


@cache
def system_headers() -> tuple[str, ...]:
    """Flags for the headers of Python, NumPy and XLA, in which no warning counts."""
    folders = (sysconfig.get_paths()["include"], np.get_include(), jax.ffi.include_dir())
    return tuple(word for folder in folders for word in ("-isystem", folder))


@pytest.mark.parametrize("macro", PRECISION_MACROS)
@pytest.mark.parametrize("name", RUNTIME)
def test_clang_tidy_finds_nothing_in_run_time_c(name: str, macro: str):
    """By itself, as an editor reads it."""
    tidy(TEMPLATES / name, macro, *system_headers())


@each_compiler
@pytest.mark.parametrize("name", RUNTIME)
def test_run_time_c_compiles_by_itself_without_a_warning(name: str, compiler: str, tmp_path: Path):
    """In each precision, and headers in both, as generated sources include them."""
    include = f'#include "{name}"\nextern int nothing_else;\n'
    texts = [f"#define {macro[2:].replace('=', ' ')}\n{include}" for macro in PRECISION_MACROS]
    if name.endswith(".h"):
        texts.append("#undef SINGLE_PRECISION\n".join(texts))
    for number, text in enumerate(texts):
        (tmp_path / f"{number}.c").write_text(text)
        run([compiler, *C11, *STRICT, "-O2", "-fPIC", "-I", TEMPLATES, *system_headers(),
             "-c", tmp_path / f"{number}.c", "-o", tmp_path / "x.o"])
