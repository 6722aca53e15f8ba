"""Run-time parameters: numbers of a scene that stay arguments of its functions."""

from dataclasses import dataclass
from enum import Enum
from fractions import Fraction


@dataclass(frozen=True)
class Parameter:
    """A number of a scene that can be changed at run time: element `index` of the argument p."""

    name: str  # as in a scene's `runtime`: tool.mass
    index: int
    value: Fraction  # the default


Scalar = Fraction | Parameter


class Sign(Enum):
    """Signs that a number may have; NaN, which only arguments at run time can be, is accepted."""

    POSITIVE = "a positive number"
    NONNEGATIVE = "0 or more"

    @property
    def rule(self) -> str:
        """Rule in words, for headers and docstrings."""
        return "must be positive" if self is Sign.POSITIVE else "must not be negative"

    def refuses(self, number: Fraction | float) -> bool:
        """Returns whether the number is refused."""
        return number <= 0 if self is Sign.POSITIVE else number < 0
