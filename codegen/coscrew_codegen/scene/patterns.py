"""Patterns of names, `actuator.*.torque`, in every list of names: * any letters, ? one, [ab] one of
these.  A name that exists stands for itself, whatever its letters."""

from collections.abc import Collection, Sequence
from fnmatch import fnmatchcase

from coscrew_codegen.scene.names import did_you_mean

_WILD = frozenset("*?[")


class PatternError(ValueError):
    """A pattern that matches nothing, or an empty name; the message gives the nearest name."""


def is_pattern(name: str) -> bool:
    """Returns whether the name has letters with a meaning in patterns."""
    return not _WILD.isdisjoint(name)


def matching(pattern: str, *known: Collection[str]) -> tuple[str, ...]:
    """Returns the names that a pattern matches, in the first of these collections in which it
    matches any; for a name in one of them, the name itself."""
    if any(pattern in names for names in known):
        return (pattern,)
    if is_pattern(pattern):
        for names in known:
            if results := tuple(name for name in names if fnmatchcase(name, pattern)):
                return results
    return ()


def expanded(given: Sequence[str], *known: Collection[str]) -> tuple[str, ...]:
    """The names, with each pattern replaced by the names that it matches, except names that are
    also given themselves.  Names without patterns stay, known or not.  Raises PatternError."""
    results: list[str] = []
    for name in given:
        if not name:
            raise PatternError("'' is no name; leave it out, or write a name")
        of = matching(name, *known)
        if of == (name,) or not is_pattern(name):
            results.append(name)
        elif of:
            results += [x for x in of if x not in results and x not in given]
        else:
            raise PatternError(f"{name!r} matches nothing; {did_you_mean(name, known[0])}")
    return tuple(results)
