"""The version, which is defined in pyproject.toml only; read from the installed metadata."""

import re
from importlib.metadata import version

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
