"""The format of files of figures: lines `quantity,at,value`; quantities have the names that scenes
give them."""

import csv
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import mpmath

FOLDER = Path(__file__).parent
DIGITS = 50
NOTHING = mpmath.mpf(10)**-40  # rounding errors of zero


class Figure(NamedTuple):
    """A quantity at a time in s; both are decimals, in SI units."""

    quantity: str
    at: str
    value: str


def figure(quantity: str, at: object, value: object, digits: int = 30) -> Figure:
    """The figure of these numbers, rounded to this many digits; floats are written with at most 17.
    """
    return Figure(quantity, _text(at, digits), _text(value, digits))


def _text(number: object, digits: int) -> str:
    if isinstance(number, float):
        return repr(float(number))
    if isinstance(number, mpmath.mpf):
        return str(mpmath.nstr(number if abs(number) > NOTHING else mpmath.mpf(0), digits))
    return str(number)


def printed(module: str, words: str, figures: Iterable[Figure]) -> None:
    """The file's text, on standard output."""
    print(f"# Made by `python -m tests.references.{module}`: {words}")
    print("quantity,at,value")
    for x in figures:
        print(",".join(x))


def read(module: str) -> tuple[Figure, ...]:
    """The committed figures of a module."""
    lines = (FOLDER / f"{module}.csv").read_text().splitlines()
    return tuple(Figure(**row) for row in csv.DictReader(lines[1:]))
