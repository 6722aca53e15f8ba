"""An install without extras names at once the packages that a command needs, before it does
anything."""

import os
import re
import subprocess
import sys
import sysconfig
import tomllib
from pathlib import Path

import pytest

from coscrew_codegen.cli.command_line import _parser
from coscrew_codegen.runtime import extras

ROOT = Path(__file__).parents[2]
SITE = Path(sysconfig.get_paths()["purelib"])
NEEDED = [(command, module) for command, extra in extras.COMMANDS.items()
          for module in extras.EXTRAS[extra]]


def requirements(extra: str) -> set[str]:
    """The distributions of an extra, and of those it includes, in pyproject.toml."""
    listed = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    results = set()
    for text in listed["optional-dependencies"][extra]:
        inner = re.fullmatch(r"coscrew\[(\w+)\]", text)
        results |= requirements(inner[1]) if inner else {re.match(r"[\w-]+", text)[0]}
    return results


@pytest.fixture(scope="module")
def bare(tmp_path_factory) -> Path:
    """A folder of packages with nothing but coscrew and NumPy; tests link others into it."""
    folder = tmp_path_factory.mktemp("bare")
    for source, name in ((ROOT / "generated/python/coscrew", "coscrew"),
                         (ROOT / "codegen/coscrew_codegen", "coscrew_codegen"),
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
        optional = {"pillow", *({"pyarrow"} if extra == "simulate" else ())}
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
    output = " ".join(done.stdout.split())
    assert output.endswith(f"not installed: {command} needs {', '.join(extras.EXTRAS[extra])}; run "
                           f'`pip install "coscrew[{extra}]"`')


LISTED = """
import atexit, runpy, sys
before = {*sys.modules}
atexit.register(lambda: print(*sys.modules.keys() - before, file=sys.stderr))
sys.argv = ["coscrew", *sys.argv[1:]]
runpy.run_module("coscrew_codegen", run_name="__main__")
"""


def imported(*words: str) -> set[str]:
    """The modules that the command imports, where all packages are installed."""
    done = subprocess.run([sys.executable, "-c", LISTED, *words], check=True, capture_output=True,
                          text=True)
    return {*done.stderr.split()}


@pytest.mark.parametrize("words", (("--help",), ("simulate", "--help"), ("--version",)),
                         ids=" ".join)
def test_help_imports_nothing_but_the_standard_library(words):
    """NumPy, SciPy, SymPy and others would take a second."""
    packages = {x.partition(".")[0] for x in imported(*words)} - sys.stdlib_module_names
    assert packages == {"coscrew_codegen"}


def test_help_imports_no_operations_and_no_other_command():
    """All operations are built when their module is imported."""
    for words in (("--help",), ("simulate", "--help")):
        result = imported(*words)
        assert not {"coscrew_codegen.algebra.operations", "coscrew_codegen.accuracy.tiers"} & result
    assert not [x for x in result if x.startswith("coscrew_codegen.simulation.sweep")]


def test_an_unknown_command_is_refused_without_extras(bare):
    done = run(bare, set(), "simulat")
    assert done.returncode == 2 and done.stderr == (
        "coscrew: there is no command 'simulat'; did you mean 'simulate'?\n")
