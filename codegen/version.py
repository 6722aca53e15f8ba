"""The version.  pyproject.toml alone says it; installing notes it, and so it is read here."""

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
