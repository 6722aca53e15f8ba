"""The README is true: its snippets run and print what it says, its commands exist."""

import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text()


def snippets(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)


@pytest.mark.parametrize("snippet", snippets("python"))
def test_python_snippets_print_what_their_comments_say(snippet, tmp_path):
    done = subprocess.run([sys.executable, "-c", snippet], cwd=tmp_path, text=True,
                          capture_output=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == re.findall(r"^# (.*)$", snippet, re.MULTILINE)


@pytest.mark.parametrize("snippet", snippets("c"))
@pytest.mark.parametrize("include", ("generated/c/include", "amalgamation"))
def test_c_snippets_compile_and_run(snippet, include, tmp_path):
    if include == "amalgamation":
        shutil.copy(ROOT / "generated/c/coscrew.h", tmp_path)
        snippet, folder = snippet.replace("ksl/coscrew.h", "coscrew.h"), tmp_path
    else:
        folder = ROOT / include
    (tmp_path / "program.c").write_text(snippet)
    subprocess.run(["cc", "-std=c11", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-I",
                    str(folder), "program.c", "-o", "program", "-lm"], cwd=tmp_path, check=True)
    done = subprocess.run([str(tmp_path / "program")], text=True, capture_output=True, check=True)
    assert done.stdout == "0 10 0; 0 0 7\n3\n"


def test_shell_snippets_run(tmp_path):
    commands = [line.split("#")[0].split() for block in snippets("sh")
                for line in block.splitlines()]
    generate = [words[1:] for words in commands if words[0] == "coscrew"]
    assert len(generate) == 3
    shutil.copytree(ROOT / "generated", tmp_path / "generated",
                    ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    shutil.copy(ROOT / "README.md", tmp_path)
    for words in generate:
        done = subprocess.run([sys.executable, "-m", "coscrew_codegen", *words], cwd=tmp_path,
                              text=True, capture_output=True)
        assert done.returncode == 0, done.stdout + done.stderr
    assert (tmp_path / "firmware/ksl/c/include/ksl/coscrew.h").exists()
    targets = [words[1:] or ["all"] for words in commands if words[0] == "make"]
    makefile = (ROOT / "Makefile").read_text()
    for (target,) in targets:
        assert re.search(rf"^{target}:", makefile, re.MULTILINE)


def test_the_continuous_integration_runs_the_readme_command():
    assert "make test" in (ROOT / ".ci" / "run").read_text()


def test_links_lead_somewhere():
    prose = re.sub(r"```.*?```", "", README, flags=re.DOTALL)
    for target in re.findall(r"(?<!\\)\[[^\[\]]*\]\(([^)#]+)\)", prose):
        assert (ROOT / target).exists(), target


def test_every_extra_named_exists():
    """In the README, in messages, in the Makefile and among the extras themselves."""
    project = (ROOT / "pyproject.toml").read_text()
    extras = tomllib.loads(project)["project"]["optional-dependencies"]
    texts = [README, project, (ROOT / "Makefile").read_text(),
             *(path.read_text() for folder in ("codegen", "templates", "tests/benchmarks")
               for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".py", ".jinja"))]
    named = re.findall(r"""["'](?:\.|coscrew)\[(\w[\w,-]*)\]""", "\n".join(texts))
    each = {x for names in named for x in names.split(",")}
    assert {"codegen", "report", "test", "peers"} <= each
    for names in named:
        assert set(names.split(",")) <= set(extras), names
