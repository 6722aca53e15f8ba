"""The version, which is defined in pyproject.toml only; read from the installed metadata."""

import re
from functools import cache
from importlib.metadata import version
from pathlib import Path
from shutil import which
from subprocess import run

VERSION: str = version("coscrew")
"""As in pyproject.toml when coscrew was installed: 1.2.3."""


def numbers() -> tuple[int, int, int]:
    """Major, minor and patch, for macros that #if compares."""
    major, minor, patch = map(int, re.findall(r"\d+", VERSION)[:3])
    return major, minor, patch


def number() -> int:
    """10000 major + 100 minor + patch."""
    major, minor, patch = numbers()
    return 10000 * major + 100 * minor + patch


@cache
def described() -> str:
    """The distribution's version and, in a git working tree, the commit."""
    description = run(["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty"],
                      capture_output=True, text=True) if _in_working_tree() else None
    commit = description.stdout.strip() if description and description.returncode == 0 else ""
    return f"{VERSION} ({commit})" if commit else VERSION


def _in_working_tree() -> bool:
    return bool(which("git")) and (Path(__file__).resolve().parents[3] / ".git").exists()
