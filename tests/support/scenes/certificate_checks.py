"""Checkers of certificates, as their files are."""

from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

FOLDER = Path(__file__).parents[3] / "templates/certificate"
CHECKERS = tuple(FOLDER / f"check_{x}.py" for x in ("bounds", "lengths"))
"""Those of plain functions."""


@cache
def checker(path: Path) -> Callable[[Sequence[str]], None]:
    """The checker's function, without its last line, which reads standard input."""
    names: dict[str, Callable[[Sequence[str]], None]] = {}
    exec(path.read_text(encoding="utf-8").rpartition("\nprint(")[0], names)
    return names["check"]


def checked(its: Sequence[str]) -> None:
    """Raises an error unless all checkers of plain functions accept the certificate."""
    for path in CHECKERS:
        checker(path)(its)


def refuses(its: Sequence[str]) -> bool:
    """Returns whether a checker refuses the certificate."""
    try:
        checked(its)
    except (AssertionError, ValueError, KeyError, IndexError):
        return True
    return False
