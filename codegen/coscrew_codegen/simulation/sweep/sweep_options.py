"""Reads the options --grid, --sobol, --samples and --seed: words and exact numbers."""

import argparse
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.scene.readers.decimals import decimal

MOST = 2**32
"""Most samples: SciPy's Sobol sequence has no more."""
MOST_POINTS = 10**6
"""Most points of one grid."""
LIMITS, UNIFORM = "limits", "uniform"
LOG = "log"


@dataclass(frozen=True)
class GridOption:
    """--grid NAME=FROM:TO:COUNT, or FROM:TO:COUNT:log."""

    name: str
    ends: tuple[Fraction, Fraction]
    count: int
    log: bool
    text: str


@dataclass(frozen=True)
class SobolOption:
    """--sobol PATTERN=LOW:HIGH, or LOW:HIGH:log; PATTERN=limits and PATTERN=uniform have no ends.
    """

    pattern: str
    ends: tuple[Fraction, Fraction] | None
    log: bool
    text: str
    uniform: bool = False  # rotations


def grid(text: str) -> GridOption:
    """The option's value, for argparse."""
    name, parts = _parts(text, "NAME=FROM:TO:COUNT or NAME=FROM:TO:COUNT:log, such as "
                               "payload.mass=0:5:50")
    log = _log(name, parts, 3, "FROM:TO:COUNT")
    first, last = (_number(name, x) for x in parts[:2])
    count = whole(parts[2], 1, MOST_POINTS)
    if (count == 1) != (float(first) == float(last)):
        raise argparse.ArgumentTypeError(f"{name}: {count} from {parts[0]} to {parts[1]}; wanted 1 "
                                         "if both ends are the same, and 2 or more if not")
    ends = _positive(name, (first, last)) if log else (first, last)
    return GridOption(name, ends, count, log, text)


def sobol(text: str) -> SobolOption:
    """The option's value, for argparse."""
    pattern, parts = _parts(text, "PATTERN=LOW:HIGH, PATTERN=LOW:HIGH:log, PATTERN=limits or "
                                  "PATTERN=uniform, such as start.q.*=limits")
    if parts in ([LIMITS], [UNIFORM]):
        return SobolOption(pattern, None, False, text, parts == [UNIFORM])
    log = _log(pattern, parts, 2, "LOW:HIGH")
    low, high = (_number(pattern, x) for x in parts[:2])
    if float(low) >= float(high):
        raise argparse.ArgumentTypeError(f"{pattern}: wanted LOW below HIGH; got {parts[0]} and "
                                         f"{parts[1]}")
    ends = _positive(pattern, (low, high)) if log else (low, high)
    return SobolOption(pattern, ends, log, text)


def samples(text: str) -> int:
    """1e6 is 1000000."""
    return whole(text, 1, MOST)


def seed(text: str) -> int:
    """Any whole number that is not negative, below 2^64."""
    return whole(text, 0, 2**64 - 1)


def whole(text: str, least: int, most: int | None = None) -> int:
    """The whole number that a decimal is: 1e6, 50."""
    try:
        value = decimal(text)
    except ValueError:
        value = Fraction(1, 2)  # not whole
    if value.denominator != 1 or value < least or most and value > most:
        to = f" to {most}" if most else " or more"
        raise argparse.ArgumentTypeError(f"wanted a whole number, {least}{to}; got {text!r}")
    return int(value)


def _parts(text: str, wanted: str) -> tuple[str, list[str]]:
    name, equals, rest = text.partition("=")
    if not (name and equals and rest):
        raise argparse.ArgumentTypeError(f"wanted {wanted}; got {text!r}")
    return name, rest.split(":")


def _log(name: str, parts: list[str], count: int, form: str) -> bool:
    """Returns whether the parts end in the word log; refuses too few or too many."""
    log = parts[count:] == [LOG]
    if len(parts) != count + log:
        raise argparse.ArgumentTypeError(f"{name}: wanted {form} or {form}:{LOG}; got "
                                         f"{':'.join(parts)!r}")
    return log


def _number(name: str, text: str) -> Fraction:
    try:
        return decimal(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"{name}: {error}") from None


def _positive(name: str, ends: tuple[Fraction, Fraction]) -> tuple[Fraction, Fraction]:
    if min(ends) <= 0:
        raise argparse.ArgumentTypeError(f"{name}: {LOG} wants positive ends; got "
                                         f"{float(ends[0]):g} and {float(ends[1]):g}")
    return ends
