"""Targets: how a Program is written in a language and a precision, and in which files.

A target receives Programs, of the library or of a scene, and returns its files.  A module with a
`TARGET` adds one; the other modules here are shared by several targets."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from coscrew_codegen.program.plugins import discover

if TYPE_CHECKING:
    from coscrew_codegen.backends.target import Target


@cache  # a function, since targets import modules of this package
def targets() -> tuple[Target, ...]:
    """All targets, by their modules' names."""
    from coscrew_codegen.backends.target import Target

    return discover(__name__, __path__, "TARGET", Target)


def languages() -> tuple[str, ...]:
    """The languages that can be selected, in alphabetical order."""
    return tuple(sorted({x for target in targets() if target.generated for x in target.languages}))
