"""Targets: how a Program is spelled in a language and a precision, and which files hold it.

A target is given Programs, of the library or of a scene, and returns its files; it is found by its
`TARGET`.  The other modules here are what several targets share."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from coscrew_codegen.found import found

if TYPE_CHECKING:
    from coscrew_codegen.targets.target import Target


@cache  # not when this package is imported: each target imports what it takes
def targets() -> tuple[Target, ...]:
    """All targets, by their modules' names."""
    from coscrew_codegen.targets.target import Target

    return found(__name__, __path__, "TARGET", Target)


def languages() -> tuple[str, ...]:
    """The languages that can be asked for, in alphabetical order."""
    return tuple(sorted({x for target in targets() if target.asked for x in target.languages}))
