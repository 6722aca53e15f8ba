"""Values of a proof of roundings, and the operations that round nothing."""

from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

from coscrew_codegen.program.elementary.proofs.affine import Form

ANY_GRID = 10**6  # of zero, which is a multiple of everything


class ImpossibleError(ValueError):
    """No argument of the ranges given leads here."""


class UndecidedError(ValueError):
    """A result needs a choice that is not the same over the whole range: the range must be cut."""


@dataclass(frozen=True)
class Undecided:
    """A value that cannot be analysed, with the reason; it does no harm where it is not selected.
    """

    reason: str


@dataclass(frozen=True, eq=False)
class TrackedValue:
    """Computed: low … high, a multiple of 2^grid; exact; error = computed - exact.

    If the last step rounded, `before` is the range of the number before rounding, and `rounding` is
    this step's part of the error."""

    low: int
    high: int
    grid: int
    exact: Form
    error: Form
    rounding: int | None = None
    before: tuple[int, int] = (0, 0)


Known: TypeAlias = TrackedValue | bool | Undecided


def last_bit(x: Fraction) -> int:
    """The largest n for which x is a multiple of 2^n."""
    if not x:
        return ANY_GRID
    return (x.numerator & -x.numerator).bit_length() - x.denominator.bit_length()


def negated(a: TrackedValue) -> TrackedValue:
    return TrackedValue(-a.high, -a.low, a.grid, -a.exact, -a.error, a.rounding,
                        (-a.before[1], -a.before[0]))


def absolute(a: TrackedValue) -> TrackedValue:
    return signed(a, None)


def signed(a: TrackedValue, b: TrackedValue | None) -> TrackedValue:
    """abs(a), with the sign of b."""
    if a.low < 0 < a.high or b is not None and b.low < 0 <= b.high:
        raise UndecidedError("the sign differs")
    negative = b is not None and b.high < 0
    return negated(a) if (a.high <= 0 and a.low < 0) != negative else a


def less(a: TrackedValue, b: TrackedValue) -> bool:
    if a.high < b.low or a.low >= b.high:
        return a.high < b.low
    raise UndecidedError("the comparison differs")


def equal(a: TrackedValue, b: TrackedValue) -> bool:
    if a.high < b.low or b.high < a.low:
        return False
    if a.low == a.high == b.low == b.high:
        return True
    raise UndecidedError("the comparison differs")


def selected(test: bool, a: Known, b: Known) -> Known:
    return a if test else b
