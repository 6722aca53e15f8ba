"""`make test` installs the tools that tests run, or names the command that does and stops.

Tried on folders of stand-ins as the only PATH: nothing is installed, and the user is whoever the
stand-in for `id` says.
"""

import os
import re
import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path

import pytest

from tests.support.compiled import cross

ROOT = Path(__file__).parents[2]
SCRIPT = Path("tests", "install_tools.sh")
TOOLS = ("make", "python3", "gcc", "g++", "clang", "clang++", "clang-tidy", "objdump",
         *cross.COMPILERS.values(), "arm-none-eabi-gcc", "qemu-s390x", "chromium", "chromedriver")
USER = {"id": "echo 1000", "sudo": "exit 1", "apt-get": 'echo "apt-get $*" >>"$CALLS"; exit 9'}
"""Somebody who may not install."""
INSTALLS = 'echo "apt-get $*" >>"$CALLS"; [ "$1" = update ] || echo >"$HERE/clang-tidy"\n' \
           '[ "$1" = update ] || chmod +x "$HERE/clang-tidy"'
"""An apt-get that installs clang-tidy, whatever it is called with."""


def machine(folder: Path, tools: Iterable[str], **commands: str) -> Path:
    """A folder with these working tools, and stand-ins that record their calls."""
    folder.mkdir()
    for name, text in {**dict.fromkeys(tools, "exit 0"), **USER, **commands}.items():
        (folder / name).write_text(f"#!/bin/sh\n{text}\n")
        (folder / name).chmod(0o755)
    for name in ("env", "sh", "chmod"):
        (folder / name).symlink_to(shutil.which(name) or name)
    return folder


def without(*missing: str) -> list[str]:
    return [name for name in TOOLS if name not in missing]


def called(path: Path, *words: str | Path, cwd: Path = ROOT) -> subprocess.CompletedProcess[str]:
    """Runs a command on that machine; its calls of apt-get are in the file `calls` beside it."""
    environment = {name: x for name, x in os.environ.items()
                   if not name.startswith("MAKE") and name != "PYTHON3"}
    environment |= {"PATH": str(path), "HERE": str(path), "CALLS": str(path.parent / "calls")}
    return subprocess.run(words or ("/bin/sh", SCRIPT), cwd=cwd, env=environment,
                          capture_output=True, text=True)


def calls(path: Path) -> list[str]:
    """The calls of apt-get on that machine."""
    log = path.parent / "calls"
    return log.read_text().splitlines() if log.exists() else []


def test_a_complete_machine_is_met_with_silence(tmp_path):
    done = called(machine(tmp_path / "bin", TOOLS))
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize("tool", TOOLS)
def test_each_missing_tool_is_in_the_command(tmp_path, tool):
    path = machine(tmp_path / "bin", without(tool))
    done = called(path)
    assert done.returncode == 1 and not calls(path)
    (command,) = done.stdout.splitlines()
    packages = re.fullmatch(r"sudo apt-get install -y ((?:[a-z0-9+-]+ ?)+)", command)[1].split()
    assert packages and len(packages) == len(set(packages)) <= 3


def test_one_command_installs_all_of_it(tmp_path):
    """Each package once, though clang is missing in two ways."""
    done = called(machine(tmp_path / "bin", ()))
    (command,) = done.stdout.splitlines()
    packages = command.removeprefix("sudo apt-get install -y ").split()
    assert done.returncode == 1 and len(packages) == len(set(packages)) > 20
    one_by_one = {word for tool in TOOLS
                  for word in called(machine(tmp_path / tool, without(tool))).stdout.split()[4:]}
    assert one_by_one <= set(packages)


@pytest.mark.parametrize("tool", ["gcc", "g++", "clang", "python3", "s390x-linux-gnu-gcc"])
def test_a_tool_that_does_not_work_is_missing(tmp_path, tool):
    """A compiler without its library, say, or a Python without headers."""
    path = machine(tmp_path / "bin", TOOLS, **{tool: "exit 1"})
    done = called(path)
    assert done.returncode == 1 and done.stdout.startswith("sudo apt-get install -y ")


def test_root_installs(tmp_path):
    path = machine(tmp_path / "bin", without("clang-tidy"), **{"id": "echo 0", "apt-get": INSTALLS})
    assert called(path).returncode == 0
    assert calls(path) == ["apt-get update -qq", "apt-get install -y -qq clang-tidy"]
    assert called(path).stdout == "" and len(calls(path)) == 2


def test_sudo_installs_if_it_needs_no_password(tmp_path):
    sudo = '[ "$1" = -n ] || exit 9; echo sudo >>"$CALLS"; shift; "$@"'
    path = machine(tmp_path / "bin", without("clang-tidy"),
                   **{"sudo": sudo, "true": "exit 0", "apt-get": INSTALLS})
    assert called(path).returncode == 0
    assert calls(path) == ["sudo", "sudo", "apt-get update -qq", "sudo",
                           "apt-get install -y -qq clang-tidy"]


@pytest.mark.parametrize("apt", ["exit 100", "exit 0"])
def test_what_could_not_be_installed_is_an_error(tmp_path, apt):
    path = machine(tmp_path / "bin", without("clang-tidy"), **{"id": "echo 0", "apt-get": apt})
    done = called(path)
    assert done.returncode == 1
    assert (apt == "exit 0") == ("clang-tidy still fail" in done.stderr)


def test_without_apt_the_packages_are_named(tmp_path):
    path = machine(tmp_path / "bin", without("clang-tidy", "chromedriver"))
    (path / "apt-get").unlink()
    done = called(path)
    assert done.returncode == 1 and not done.stdout
    assert "clang-tidy chromium-driver" in done.stderr


@pytest.mark.parametrize("complete", [False, True])
def test_make_test_stops_before_anything_runs(tmp_path, complete):
    """With all tools installed it continues to pytest, for which Python's stand-in is called."""
    project = tmp_path / "project"
    (project / "tests").mkdir(parents=True)
    (project / ".venv" / "bin").mkdir(parents=True)
    shutil.copy(ROOT / SCRIPT, project / SCRIPT)
    makefile = Path(shutil.copy(ROOT / "Makefile", project)).read_text()
    for rule in re.findall(r"^\$\(VENV\)/[\w-]+:.*", makefile, re.MULTILINE):
        for needed in map(project.joinpath, re.findall(r"[\w/]+\.(?:py|toml)\b", rule)):
            needed.parent.mkdir(parents=True, exist_ok=True)
            needed.touch()
    path = machine(tmp_path / "bin", without() if complete else without("qemu-s390x"),
                   touch="exit 0", python3=f'[ "$1" = -c ] || echo "python3 $*" >>"{project}/ran"')
    python = project / ".venv" / "bin" / "python"
    python.write_text(f'#!/bin/sh\necho "$*" >>"{project}/ran"\n')
    python.chmod(0o755)
    (path / "make").unlink()
    (path / "make").symlink_to(shutil.which("make") or "make")
    done = called(path, "make", "test", cwd=project)
    ran = (project / "ran").read_text() if (project / "ran").exists() else ""
    if complete:
        assert done.returncode == 0 and re.search(r"^-m pytest ", ran, re.MULTILINE), done.stderr
    else:
        assert done.returncode and ran == ""
        assert done.stdout.splitlines()[0] == "sudo apt-get install -y qemu-user"


def test_the_gate_is_make_test(tmp_path):
    """It calls nothing else, unless make itself is missing."""
    path = machine(tmp_path / "bin", TOOLS, make='echo "make $* with CI=$CI" >>"$CALLS"')
    for name in ("bash", "dirname"):
        (path / name).symlink_to(shutil.which(name) or name)
    assert called(path, "bash", ROOT / ".ci" / "run").returncode == 0
    assert calls(path) == ["make test with CI=true"]
