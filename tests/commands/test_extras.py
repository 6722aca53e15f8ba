"""An install without extras says at once what a command needs, before it does anything."""

import os
import re
import resource
import subprocess
import sys
import sysconfig
import tomllib
from pathlib import Path

import pytest

from coscrew_codegen import extras
from coscrew_codegen.command_line import _parser

ROOT = Path(__file__).parents[2]
SITE = Path(sysconfig.get_paths()["purelib"])
NEEDED = [(command, module) for command, extra in extras.COMMANDS.items()
          for module in extras.EXTRAS[extra]]


def requirements(extra: str) -> set[str]:
    """The distributions of an extra, and of those it includes, in pyproject.toml."""
    listed = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    found = set()
    for text in listed["optional-dependencies"][extra]:
        inner = re.fullmatch(r"coscrew\[(\w+)\]", text)
        found |= requirements(inner[1]) if inner else {re.match(r"[\w-]+", text)[0]}
    return found


@pytest.fixture(scope="module")
def bare(tmp_path_factory) -> Path:
    """A folder of packages with nothing but coscrew and NumPy; tests link others into it."""
    folder = tmp_path_factory.mktemp("bare")
    for source, name in ((ROOT / "generated/python", "coscrew"), (ROOT / "codegen",
                                                                  "coscrew_codegen"),
                         *((path, path.name) for path in SITE.glob("numpy*")),
                         *((path, path.name) for path in SITE.glob("coscrew-*.dist-info"))):
        (folder / name).symlink_to(source)
    return folder


def run(bare: Path, with_: set[str], *words: str) -> subprocess.CompletedProcess:
    """The command where these packages are installed besides."""
    links = [bare / path.name for name in sorted(with_) for path in SITE.glob(f"{name}*")
             if re.fullmatch(rf"{name}(\.libs|\.py)?", path.name)]
    for link in links:
        link.symlink_to(SITE / link.name)
    try:
        return subprocess.run(
            [sys.executable, "-S", "-P", "-m", "coscrew_codegen", *words], cwd=bare.parent,
            capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(bare)})
    finally:
        for link in links:
            link.unlink()


def test_extras_are_those_of_pyproject():
    for extra, modules in extras.EXTRAS.items():
        optional = {"pyarrow"} if extra == "simulate" else set()
        assert {*modules} == requirements(extra) - optional, extra


def test_every_command_has_its_extra():
    (commands,) = (action for action in _parser()._actions if action.dest == "command")
    assert set(commands.choices) == set(extras.COMMANDS)


@pytest.mark.parametrize("command", extras.COMMANDS)
def test_a_bare_install_says_the_extra_of_each_command(bare, command):
    extra = extras.COMMANDS[command]
    done = run(bare, set(), command, "scene.toml")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (f"coscrew: {command} needs {', '.join(extras.EXTRAS[extra])}; run "
                           f'`pip install "coscrew[{extra}]"`\n')


@pytest.mark.parametrize("module", sorted({module for _, module in NEEDED}))
def test_a_package_that_lacks_alone_is_named(bare, module):
    """Each command that needs it names it before it looks at its arguments: the scene is not
    mentioned."""
    command = [command for command, name in NEEDED if name == module][-1]
    extra = extras.COMMANDS[command]
    others = {*extras.EXTRAS[extra]} - {module}
    done = run(bare, others, command, "no such scene")
    assert (done.returncode, done.stdout, done.stderr) == (
        2, "", f'coscrew: {command} needs {module}; run `pip install "coscrew[{extra}]"`\n')


def test_the_version_is_told_without_extras(bare):
    assert run(bare, set(), "--version").stdout.startswith("coscrew ")


def test_help_needs_no_extra_and_says_which_each_command_needs(bare):
    done = run(bare, set(), "--help")
    assert (done.returncode, done.stderr) == (0, "")
    for command, extra in extras.COMMANDS.items():
        (line,) = (x for x in done.stdout.splitlines() if "pip install" in x
                   and command in re.split(r"[ ,]+", x.partition("pip")[0]))
        assert line.endswith(f'pip install "coscrew[{extra}]"  (not installed)')
    some = run(bare, {*extras.EXTRAS["codegen"]}, "--help").stdout
    assert 'pip install "coscrew[codegen]"  (installed)' in some
    assert 'pip install "coscrew[sweep]"  (not installed)' in some


@pytest.mark.parametrize("command", extras.COMMANDS)
def test_help_of_each_command_needs_no_extra_and_gives_the_way(bare, command):
    done = run(bare, set(), command, "--help")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"usage: coscrew {command} ")
    extra = extras.COMMANDS[command]
    said = " ".join(done.stdout.split())
    assert said.endswith(f"not installed: {command} needs {', '.join(extras.EXTRAS[extra])}; run "
                         f'`pip install "coscrew[{extra}]"`')


@pytest.mark.parametrize("words", (("--help",), ("simulate", "--help")), ids=" ".join)
def test_help_takes_less_than_three_tenths_of_a_second(words):
    """Of the processor, with all packages installed: the least of some runs."""
    def seconds() -> float:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-m", "coscrew_codegen", *words], check=True,
                       stdout=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    assert min(seconds() for _ in range(4)) < 0.3


def test_an_unknown_command_is_refused_without_extras(bare):
    done = run(bare, set(), "simulat")
    assert done.returncode == 2 and "invalid choice: 'simulat'" in done.stderr
